//! CL data: APT source and CLS files to machine-independent events.
//!
//! Bytes become statements in `text`, typed [`Record`]s in [`record`], and in `meaning`, with units and modes, the
//! [`Event`](crate::program::Event)s of [`program`](crate::program). The [`ClReader`] drives them, and keeps subprograms and
//! diagnostics. Memory is constant: one read buffer, one buffer for joined statements, nothing allocated for a record that
//! is understood.
//!
//! Reading never stops at a fault; all faults of a file are reported in one run, but no event is returned after the first.
//! What is not understood is refused, never skipped: it might move the tool. The same bytes give the same events and
//! diagnostics, whatever the size of the reads, so a file may be read twice.

mod diagnostics;
mod dialect;
mod meaning;
mod reader;
pub mod record;
mod subprogram;
mod text;
mod vector;

#[cfg(test)]
mod tests;

pub use self::dialect::Dialect;
pub use self::meaning::{ArcVote, ClPoint, CycleArg, FeedLabel, Frames, Insert, ReadingOptions, Sense, StatedFrame};
pub use self::reader::ClReader;
pub use self::record::{Record, list as list_words, not_inert};
