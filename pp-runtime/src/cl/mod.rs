//! Reads CL data (APT source, CLS files) into machine-independent events.
//!
//! `text` splits bytes into statements, [`record`] makes typed `Record`s of them, and `meaning` applies units and
//! modes and returns the [`Event`](crate::program::Event)s of [`program`](crate::program). The [`ClReader`] calls these
//! three in turn and keeps subprograms and diagnostics; `batch` has its events in batches, and `events` hands them on,
//! read ahead or not. Memory is constant: one read buffer, one buffer for joined
//! statements, no allocation for a record that is understood.
//!
//! Reading goes on after an error, so that one run reports all errors of a file; no event is returned after the first.
//! A record that is not understood is refused, never skipped: it might move the tool. The same bytes give the same
//! events and diagnostics, whatever the size of the reads, so a file may be read twice.
//!
//! ```
//! use pp_runtime::cl::{ClReader, ReadingOptions};
//!
//! let mut reader = ClReader::new(&b"UNITS/MM\nGOTO/0,0,5\nFEDRATE/100,MMPM\nGOTO/10,0,5\n"[..],
//! ReadingOptions::default()); let mut events = 0; while reader.next_event()?.is_some() {
//!     events += 1;
//! }
//! // What is not understood is an error at its place, with a remedy.
//! assert!(reader.failed());
//! let fault = &reader.diagnostics()[0];
//! assert_eq!((fault.location.line, fault.location.column), (3, 1));
//! assert!(fault.help.as_deref().is_some_and(|help| help.contains("FEDRAT")));
//! # Ok::<(), std::io::Error>(())
//! ```

#![cfg_attr(not(test), deny(clippy::disallowed_methods))]

mod batch;
mod diagnostics;
mod dialect;
mod events;
mod meaning;
mod reader;
pub mod record;
mod subprogram;
mod text;
mod vector;

#[cfg(test)]
mod tests;

pub(crate) use self::batch::FileFacts;
pub use self::dialect::Dialect;
pub(crate) use self::events::{ClData, ClEvents, FromHere};
pub(crate) use self::meaning::{ArcVote, FrameVote, SetUpBegins, StatedTool};
pub use self::meaning::{CycleArg, FeedLabel, Frames, Insert, ReadingOptions, Sense, ToolArg};
pub use self::reader::ClReader;
pub(crate) use self::reader::ReadSeek;
pub(crate) use self::record::{OwnStatement, list as list_words, not_inert};
