//! Blocks and words of an NC program as bytes: numbers, and a writer with one reused buffer.
//!
//! Words come in whole units of their last decimal, so no coordinate is rounded here, and nothing is parsed. Letters
//! and codes are defined in [`control`](crate::control).

#![cfg_attr(not(test), deny(clippy::disallowed_methods))]

mod formats;
mod number;
mod writer;

pub(crate) use formats::Formats;
pub(crate) use number::{Decimal, Numerals, Overflow, whole_units, write_decimal, write_number};
pub(crate) use writer::{Numbering, WordForm, Writer, WrittenLine};
