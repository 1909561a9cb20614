//! Where the blocks of a program come from: the record of the CL data that a step serves, why it is there, and where the
//! machine is after it. The planner hands it over with each step; a sink may keep an account of it or not.

use crate::kinematics::{Branch, Pose};
use crate::program::Location;

/// Why a step is in the program.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum BlockReason {
    /// In front of everything that a record asks for.
    #[default]
    Head,
    /// The record asks for just this.
    Record,
    /// A point of a feed motion between its ends: there tip or tool axis would leave the tolerance.
    Tolerance,
    /// A point of a feed motion at which the course of the rotary axes goes on with other words.
    Course,
    /// The rotary axes are rewound to stay within their limits.
    Rewind,
    /// A chord of a curve.
    Curve,
    /// A chord of an arc that the control cannot be told.
    Chord,
    /// A part of an arc that one block cannot say.
    SplitArc,
    /// A motion of a hole that no cycle of the control makes.
    Hole,
    /// The corner of a rapid in two legs.
    Corner,
    /// Out of the part along the tool axis.
    LeadOut,
    /// A complete state with the tool of the operation, before anything comes near the part.
    Start,
    /// From the retract position to the part.
    Approach,
    /// What ends a program.
    End,
}

impl BlockReason {
    /// The word that programs read.
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

    /// The sentence that people read.
    #[must_use]
    pub const fn text(self) -> &'static str {
        match self {
            Self::Head => "the head of the program, which serves no record",
            Self::Record => "this record asks for it",
            Self::Tolerance => {
                "inserted in the motion of this record: in one block tip or tool axis would leave the tolerance"
            }
            Self::Course => "inserted in the motion of this record: here the rotary axes go on along another course",
            Self::Rewind => "the rotary axes are rewound before this record, to stay within their limits",
            Self::Curve => "a chord of the curve of this record",
            Self::Chord => "a chord of the arc of this record, which the control cannot be told as an arc",
            Self::SplitArc => "a part of the arc of this record, which one block cannot say",
            Self::Hole => "a motion of the hole of this record, which no cycle of the control makes",
            Self::Corner => "the corner of the rapid of this record, which is written in two legs",
            Self::LeadOut => "the tool is led out of the part before what this record asks for",
            Self::Start => "the complete state that the operation of this record begins with",
            Self::Approach => "the approach to the point of this record",
            Self::End => "the end of the program",
        }
    }
}

/// Where the machine is after a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ReachedPosition<'a> {
    /// Tip in mm and tool axis in the workpiece; `None` while only some axes have arrived.
    pub pose: Option<&'a Pose>,
    /// Branch of the inverse kinematics.
    pub branch: Branch,
    /// Axis values in chain order, mm and rad.
    pub axes: &'a [f64],
    /// Axes that have arrived: bit `i` for the axis at position `i`.
    pub mask: u16,
}

/// Where a step comes from and where it leads.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Provenance<'a> {
    /// The record that it serves; `None` before the first.
    pub at: Option<Location>,
    /// Why it is in the program.
    pub reason: BlockReason,
    /// Where the machine is after it, if it moves.
    pub reached: Option<ReachedPosition<'a>>,
}
