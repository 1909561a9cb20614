//! Blocks and words of an NC program: numbers and one reused buffer.
//!
//! Words arrive as whole units of their last decimal, so nothing here rounds a coordinate and nothing parses. Which
//! letters and codes there are is the business of [`control`](crate::control).

mod formats;
mod number;
mod writer;

pub use formats::Formats;
pub use number::{Decimal, Numerals, Overflow, whole_units, write_decimal, write_number};
pub use writer::{Numbering, Writer, WrittenLine};
