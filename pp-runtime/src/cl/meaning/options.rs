//! What the caller knows about a file, or wants of it: command line and `[cl]` of the configuration.

use std::collections::BTreeMap;

use super::holes::CycleArg;
use crate::cl::dialect::Dialect;
use crate::cl::record::CycleKind;
use crate::program::Units;

/// Sense of a circle about its axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sense {
    /// Clockwise.
    Clockwise,
    /// Counter-clockwise.
    CounterClockwise,
}

/// What to do with a frame that differs from the first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Frames {
    /// Refuse it, with both lines.
    #[default]
    Refuse,
    /// Map its points and axes into the first.
    Main,
    /// Leave them as they are: each frame has a work offset of its own.
    Offset,
}

/// What to do with INSERT.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Insert {
    /// Refuse it.
    #[default]
    Refuse,
    /// Write it as a comment.
    Comment,
    /// Write it as NC text.
    Write,
}

/// Meaning of a feed labelled MMPM or MMPR in a file in inches.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum FeedLabel {
    /// Refuse it.
    #[default]
    Refuse,
    /// It is in millimetres, as labelled.
    Trust,
    /// It is in the unit of the file, whatever its label.
    FileUnits,
}

/// The point of the tool that the CL data programs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum ClPoint {
    /// The end of the tool on its axis.
    #[default]
    Tip,
    /// The centre of the corner radius: above the tip by that radius.
    Centre,
}

/// What the caller knows about the file, or wants of it.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Options {
    /// Unit of a file that does not state one (`--units`).
    pub units: Option<Units>,
    /// The CAM system, whatever the evidence in the file (`--dialect`).
    pub dialect: Option<Dialect>,
    /// Columns of a line that count (`--columns`); default: all.
    pub columns: Option<u32>,
    /// Words that are passed over (`--inert`).
    pub inert: Vec<String>,
    /// Frames other than the first (`--frames`).
    pub frames: Frames,
    /// Sense of every CIRCLE about its axis, whatever its form (`--circle-sense`).
    pub circle_sense: Option<Sense>,
    /// INSERT (`--insert comment`, `--allow-insert`).
    pub insert: Insert,
    /// `INSERT/STOP ..` is STOP.
    pub insert_stop: bool,
    /// Codes that AUXFUN may write.
    pub auxfun: Vec<u32>,
    /// Codes that PREFUN may write.
    pub prefun: Vec<u32>,
    /// Feeds labelled in mm in a file in inches.
    pub feed_label: FeedLabel,
    /// FROM is written as the first approach (`--from move`).
    pub from_move: bool,
    /// The point that the CL data programs.
    pub cl_point: ClPoint,
    /// The same for single tools.
    pub cl_point_of: BTreeMap<u32, ClPoint>,
    /// Meaning of the numbers without words in a CYCLE.
    pub cycle_args: Vec<(CycleKind, Vec<CycleArg>)>,
}
