//! Typed CL records with numbers as written in the file: text to records, and records to text.
//!
//! A file for each topic holds its record types, the functions that read their arguments, and their text. `words` is
//! the table of all major words with these functions. `parse` looks a word up and calls its function; `comment` reads
//! records that are written as comments. Units, modal state and the meaning of a record in its context are in
//! `meaning`.
//!
//! A record prints as a statement that is read back as the same record. Numbers are written as decimals with the fewest
//! digits that give the same number. Statements are not split into several lines. Text is written as UTF-8, so Latin-1
//! changes.
//!
//! ```
//! use pp_runtime::cl::record::{CoordinateRecord, Record};
//! use pp_runtime::program::Units;
//!
//! assert_eq!(Record::Coordinates(CoordinateRecord::Units(Units::Inches)).to_string(), "UNITS/INCH");
//! ```

mod arc;
mod comment;
mod coordinates;
mod cycle;
mod feed;
mod machine;
mod motion;
mod nurbs;
mod own;
mod parse;
mod program;
mod shapes;
mod spindle;
mod subprogram;
mod tool;
mod values;
mod vocabulary;
mod words;

pub use self::coordinates::CoordinateRecord;
pub use self::cycle::ClCycleKind;
pub use self::machine::MachineRecord;
pub use self::program::ProgramRecord;

pub(crate) use self::arc::{ArcRecord, CircleForm, CircleRecord, TangentArc};
pub(crate) use self::comment::{CatiaMatrix, comment_dialect, read_comment};
pub(crate) use self::coordinates::{FrameBase, FrameRecord};
pub(crate) use self::cycle::{CycleCall, CycleRecord, CycleState, Return, ThreadPitch};
pub(crate) use self::feed::{FeedRecord, FeedUnit};
pub(crate) use self::motion::MotionRecord;
pub(crate) use self::nurbs::NurbsRecord;
pub(crate) use self::own::{GivenMeanings, OwnStatement};
pub(crate) use self::parse::{if_harmless, joined_record, parse, record_dialect};
pub(crate) use self::shapes::Shapes;
pub(crate) use self::subprogram::{SubprogramName, SubprogramRecord};
pub(crate) use self::tool::{CutterKind, CutterRecord, ToolCallRecord, ToolRecord};
pub(crate) use self::values::{AxisPlane, Numbers, Point, Text, word_of};
pub(crate) use self::words::{list, nearest_word, not_inert};
#[cfg(test)]
pub(crate) use self::{cycle::MOST_POSITIONAL, tool::MOST_TOOL_NUMBERS};
#[cfg(test)]
pub(crate) use super::text::Span;

use std::fmt::{self, Display, Formatter};

/// The content of one statement.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Record<'a> {
    /// Names, operations, messages, stops and literal NC text.
    Program(ProgramRecord<'a>),
    /// Units, tool axis, frames and coordinate transforms.
    Coordinates(CoordinateRecord),
    /// Tool calls and descriptions.
    Tool(ToolRecord),
    /// States of the machine.
    Machine(MachineRecord),
    /// Motion to points.
    Motion(MotionRecord<'a>),
    /// Arcs.
    Arc(ArcRecord),
    /// Curves.
    Nurbs(NurbsRecord<'a>),
    /// Hole cycles.
    Cycle(CycleRecord),
    /// Subprograms.
    Subprogram(SubprogramRecord),
    /// A statement to which the shop has given a block, and its index among these.
    Own(Text<'a>, usize),
    /// Record without effect.
    Inert,
}

impl Record<'_> {
    /// Whether the record accepts any text as arguments. A line that a `$` joins to it would be lost in that text.
    pub(crate) fn takes_anything(&self) -> bool {
        match self {
            Self::Program(record) => record.takes_anything(),
            Self::Inert => true,
            // The statement is compared as a whole.
            Self::Own(..) => false,
            Self::Coordinates(_) | Self::Tool(_) | Self::Machine(_) | Self::Motion(_) => false,
            Self::Arc(_) | Self::Nurbs(_) | Self::Cycle(_) | Self::Subprogram(_) => false,
        }
    }
}

impl Display for Record<'_> {
    /// Writes the statement without a line end; an inert record becomes a comment.
    fn fmt(&self, out: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::Program(record) => record.fmt(out),
            Self::Coordinates(record) => record.fmt(out),
            Self::Tool(record) => record.fmt(out),
            Self::Machine(record) => record.fmt(out),
            Self::Motion(record) => record.fmt(out),
            Self::Arc(record) => record.fmt(out),
            Self::Nurbs(record) => record.fmt(out),
            Self::Cycle(record) => record.fmt(out),
            Self::Subprogram(record) => record.fmt(out),
            Self::Own(statement, _) => statement.fmt(out),
            Self::Inert => out.write_str("$$"),
        }
    }
}
