//! What the planner hands to a control: one step is one block.

mod cycle;
mod provenance;

use std::io;

use crate::nc::Decimal;
use crate::program::{Coolant, Rotation};

use crate::motion::geometry::Circle;

pub use crate::kinematics::MAX_AXES;
pub use cycle::{CannedCycle, CannedKind, CycleAbilities};
pub use provenance::{BlockReason, Provenance, ReachedPosition};

/// Decimals of the components of a tool axis: as many as CL data has.
pub const VECTOR_DECIMALS: u32 = 7;

/// Words of axes: whole units of their last decimal, by position in the chain.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct AxisWords {
    /// Whole units, meaningful where [`has`](Self::has) says so.
    pub units: [i64; MAX_AXES],
    /// Bit `i` is set for the axis at position `i`.
    pub mask: u16,
    /// The tool axis as the control counts it, in the place of rotary words: units of [`VECTOR_DECIMALS`] decimals.
    pub vector: Option<[i64; 3]>,
}

impl AxisWords {
    /// Whether the block may hold a word of this axis.
    #[must_use]
    #[inline]
    pub fn has(&self, axis: usize) -> bool {
        self.mask & (1 << axis) != 0
    }
}

/// The feed of a block.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FeedWord {
    /// Units of the control's path per minute; stays in force.
    PerMinute(Decimal),
    /// Inverse time, for this block alone.
    InverseTime(Decimal),
}

/// One block.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Step<'a> {
    /// Straight line of all axes together at a feed; words that do not change are left out.
    Feed {
        /// Where to.
        words: AxisWords,
        /// How fast.
        feed: FeedWord,
    },
    /// Arc of a circle about an axis of the program, or a helix; the words of its plane are always written.
    Arc {
        /// Where to; linear axes only.
        words: AxisWords,
        /// The circle.
        circle: &'a Circle,
        /// Units of the control's path per minute.
        feed: Decimal,
    },
    /// A hole by a cycle of the control.
    Cycle {
        /// The cycle.
        cycle: &'a CannedCycle,
    },
    /// From the next feed block on the cutter runs beside its path.
    CutterCompensation {
        /// Left of the words as they are written, else right; `None`: on it again.
        left: Option<bool>,
        /// Register of the radius.
        register: u32,
    },
    /// Rapid; words that do not change are left out.
    Rapid {
        /// Where to.
        words: AxisWords,
    },
    /// Rapid in machine coordinates; all its words are written, and where these axes stand in the program's
    /// coordinates is not known behind it.
    Machine {
        /// Where to.
        words: AxisWords,
    },
    /// A program can be entered here: units, plane, everything cancelled, feed per minute, work offset. Every word is
    /// written again behind it.
    Restart {
        /// Counts from 1.
        number: u32,
    },
    /// Feed per minute from here on.
    PerMinute,
    /// The tool that is needed.
    Tool {
        /// Its number.
        number: u32,
        /// Register of its length.
        offset: u32,
        /// The tool after it, if one follows.
        next: Option<u32>,
        /// Speed it begins with, rev/min, if that is known.
        speed: Option<Decimal>,
        /// False if it stands in the spindle already.
        change: bool,
    },
    /// The length offset of the motions that follow.
    Length {
        /// Register.
        offset: u32,
    },
    /// The control keeps the tip where the linear words say, or no longer.
    TipControl {
        /// From here on.
        on: bool,
    },
    /// The plane of the linear words is tilted, and the rotary axes are turned to it.
    Plane {
        /// Its angles as the control counts them, degrees.
        angles: [Decimal; 3],
        /// Which of the two poses, where it has to be said: plus or the higher one.
        pose: Option<bool>,
    },
    /// The plane is no longer tilted.
    PlaneOff,
    /// The length of the tool as the control knows it is compared with the one that was posted, and the program stops where
    /// they differ; nothing where a control cannot compare.
    LengthGuard {
        /// A number of its own in the program.
        label: u32,
        /// The tool in the spindle.
        tool: u32,
        /// Its register.
        offset: u32,
        /// Posted gauge length, mm.
        length: f64,
        /// By how much it may differ, mm.
        tolerance: f64,
    },
    /// Spindle on.
    Spindle {
        /// rev/min.
        speed: Decimal,
        /// Sense of rotation.
        rotation: Rotation,
    },
    /// A code of the configuration that moves nothing and leaves in force what is.
    Code {
        /// As it is written.
        text: &'a str,
    },
    /// Spindle off.
    SpindleOff,
    /// Wait.
    Dwell {
        /// How long.
        seconds: f64,
    },
    /// Coolant on.
    Coolant {
        /// A kind that the control has; never `On` or `Off`.
        kind: Coolant,
    },
    /// All coolant off.
    CoolantOff,
    /// Program stop; the operator may do anything.
    Stop {
        /// Only where the operator has asked for it.
        optional: bool,
    },
    /// An operation begins.
    Operation {
        /// Its name as the CL data has it.
        name: &'a [u8],
    },
    /// Text for the operator.
    Message {
        /// As the CL data has it.
        text: &'a [u8],
    },
    /// The work offset of what follows; written with the next restart.
    WorkOffset {
        /// Its word.
        word: &'a str,
    },
    /// A block as it stands; nothing is known behind it.
    Raw {
        /// The block.
        text: &'a [u8],
    },
}

impl Step<'_> {
    /// What it is, in one word.
    #[must_use]
    pub const fn name(&self) -> &'static str {
        match self {
            Self::Feed { .. } => "feed",
            Self::Arc { .. } => "arc",
            Self::Cycle { .. } => "cycle",
            Self::CutterCompensation { .. } => "compensation",
            Self::Rapid { .. } => "rapid",
            Self::Machine { .. } => "machine-coordinates",
            Self::Restart { .. } => "restart",
            Self::PerMinute => "feed-mode",
            Self::Tool { .. } => "tool",
            Self::Length { .. } => "length-offset",
            Self::TipControl { .. } => "tip-control",
            Self::Plane { .. } | Self::PlaneOff => "plane",
            Self::LengthGuard { .. } => "length-guard",
            Self::Spindle { .. } | Self::SpindleOff => "spindle",
            Self::Code { .. } => "code",
            Self::Dwell { .. } => "dwell",
            Self::Coolant { .. } | Self::CoolantOff => "coolant",
            Self::Stop { .. } => "stop",
            Self::Operation { .. } => "operation",
            Self::Message { .. } => "message",
            Self::WorkOffset { .. } => "work-offset",
            Self::Raw { .. } => "insert",
        }
    }
}

/// Takes the steps of a program.
pub trait Sink {
    /// Writes one step; `from` says where it comes from and where it leads.
    ///
    /// # Errors
    /// Those of the output.
    fn step(&mut self, step: &Step<'_>, from: &Provenance<'_>) -> io::Result<()>;
}

impl<S: Sink> Sink for &mut S {
    #[inline]
    fn step(&mut self, step: &Step<'_>, from: &Provenance<'_>) -> io::Result<()> {
        (**self).step(step, from)
    }
}

/// Takes the steps of a rehearsal.
#[derive(Debug, Clone, Copy)]
pub struct DiscardSteps;

impl Sink for DiscardSteps {
    fn step(&mut self, _: &Step<'_>, _: &Provenance<'_>) -> io::Result<()> {
        Ok(())
    }
}
