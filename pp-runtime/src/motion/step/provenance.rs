//! Provenance of the blocks of a program: the record of the CL data that a step belongs to, the reason for the step,
//! and the position after it. The planner passes it to the sink with each step; a sink may record it or not.

use crate::kinematics::{Branch, Pose};
use crate::program::Location;

/// Reason for a step in the program.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum BlockReason {
    /// Head of the program, before the first record.
    #[default]
    Head,
    /// The record itself.
    Record,
    /// Inserted point of a feed motion: without it the tip or the tool axis would leave the tolerance.
    Tolerance,
    /// Inserted point of a feed motion, at which the rotary axes change to other angles.
    Course,
    /// Rewind of the rotary axes, to stay within their limits.
    Rewind,
    /// Chord of a curve.
    Curve,
    /// Chord of an arc that cannot be written as an arc.
    Chord,
    /// Part of an arc that does not fit into one block.
    SplitArc,
    /// Motion of a hole that is not written as a cycle.
    Hole,
    /// Corner of a rapid in two blocks.
    Corner,
    /// Retract out of the part along the tool axis.
    LeadOut,
    /// Complete state with the tool of the operation, away from the part.
    Start,
    /// Approach from the retract position to the part.
    Approach,
    /// End of the program.
    End,
}

impl BlockReason {
    /// Name in JSON.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Head => "head",
            Self::Record => "record",
            Self::Tolerance => "tolerance",
            Self::Course => "course",
            Self::Rewind => "rewind",
            Self::Curve => "curve",
            Self::Chord => "chord",
            Self::SplitArc => "split-arc",
            Self::Hole => "hole",
            Self::Corner => "corner",
            Self::LeadOut => "lead-out",
            Self::Start => "start",
            Self::Approach => "approach",
            Self::End => "end",
        }
    }

    /// Sentence for a reader.
    #[must_use]
    pub const fn text(self) -> &'static str {
        match self {
            Self::Head => "the head of the program, before the first record",
            Self::Record => "programmed by this record",
            Self::Tolerance => {
                "inserted in the motion of this record: in one block the tip or the tool axis would leave the tolerance"
            }
            Self::Course => "inserted in the motion of this record: here the rotary axes change to other angles",
            Self::Rewind => "the rotary axes are rewound before this record, to stay within their limits",
            Self::Curve => "a chord of the curve of this record",
            Self::Chord => "a chord of the arc of this record, which cannot be written as an arc",
            Self::SplitArc => "a part of the arc of this record, which does not fit into one block",
            Self::Hole => "a motion of the hole of this record, which is not written as a cycle",
            Self::Corner => "the corner of the rapid of this record, which is written in two blocks",
            Self::LeadOut => "the retract out of the part before this record",
            Self::Start => "the complete state at the beginning of the operation of this record",
            Self::Approach => "the approach to the point of this record",
            Self::End => "the end of the program",
        }
    }
}

/// Position after a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ReachedPosition<'a> {
    /// Tip in mm and tool axis, workpiece frame; `None` while only some axes have arrived.
    pub pose: Option<&'a Pose>,
    /// Branch of the inverse kinematics.
    pub branch: Branch,
    /// Axis values in chain order, mm and rad.
    pub axes: &'a [f64],
    /// Axes that have arrived: bit `i` for the axis at position `i`.
    pub mask: u16,
}

/// Record of a step, reason for it, and position after it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Provenance<'a> {
    /// Record that the step belongs to; `None` before the first.
    pub at: Option<Location>,
    /// Reason for the step.
    pub reason: BlockReason,
    /// Position after the step, if it moves.
    pub reached: Option<ReachedPosition<'a>>,
}
