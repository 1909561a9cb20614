//! Blocks and words of an NC program as bytes: numbers, and a writer with one reused buffer.
//!
//! Words come in whole units of their last decimal, so no coordinate is rounded here, and nothing is parsed. Letters
//! and codes are defined in [`control`](crate::control).
//!
//! ```
//! use pp_runtime::nc::{Decimal, write_decimal};
//!
//! let mut word = b"X".to_vec();
//! write_decimal(&mut word, Decimal::fixed(-12.50049, 3)?);
//! assert_eq!(word, b"X-12.5");
//! # Ok::<(), pp_runtime::nc::Overflow>(())
//! ```

#![cfg_attr(not(test), deny(clippy::disallowed_methods))]

mod formats;
mod number;
mod writer;

pub use formats::Formats;
pub use number::{Decimal, Numerals, Overflow, whole_units, write_decimal, write_number};
pub use writer::{Numbering, WordForm, Writer, WrittenLine};
