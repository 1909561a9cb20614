//! Steps: what the planner passes to the encoder of a control. One step becomes one block.

mod cycle;
mod provenance;

use std::io;

use crate::nc::Decimal;
use crate::program::{Coolant, Rotation};

use crate::motion::geometry::Circle;
use crate::options::Smoothing;

pub(crate) use crate::kinematics::MAX_AXES;
pub(crate) use cycle::{CannedCycle, CannedKind, CycleAbilities, FineBoreAbility, UnusedCycles};
pub use provenance::Provenance;
pub(crate) use provenance::{BlockReason, ReachedPosition};

/// Decimals of the components of a tool axis, as in CL data.
pub(crate) const VECTOR_DECIMALS: u32 = 7;

/// Axis words of a block: whole units of their last decimal, by position in the chain.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct AxisWords {
    /// Whole units; valid where [`has`](Self::has) returns true.
    pub units: [i64; MAX_AXES],
    /// Bit `i` is set for the axis at position `i`.
    pub mask: u16,
    /// Tool axis in the frame of the control, instead of rotary words: units of `VECTOR_DECIMALS` decimals.
    pub vector: Option<[i64; 3]>,
}

impl AxisWords {
    /// Adds the words of other axes.
    pub(crate) fn add(&mut self, other: &Self) {
        for index in (0..MAX_AXES).filter(|&index| other.has(index)) {
            self.units[index] = other.units[index];
        }
        self.mask |= other.mask;
    }

    /// Whether the block may have a word of this axis.
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
    /// Inverse time, for this block only.
    InverseTime(Decimal),
}

/// Use of the blocks of the shop for the tool in the spindle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ToolRoutine {
    /// `cycles.measure_tool`.
    Measure,
    /// Its `start`.
    Start,
    /// Its `end`.
    End,
    /// `cycles.check_tool`.
    Check,
}

/// One block.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Step<'a> {
    /// Feed motion, straight in axis values; words that do not change are left out.
    Feed {
        /// End point.
        words: AxisWords,
        /// Feed.
        feed: FeedWord,
    },
    /// Arc of a circle about an axis of the program, or a helix; the words of its plane are always written.
    Arc {
        /// End point; linear axes only.
        words: AxisWords,
        /// The circle.
        circle: &'a Circle,
        /// Units of the control's path per minute.
        feed: Decimal,
    },
    /// Hole by a cycle of the control.
    Cycle {
        /// The cycle.
        cycle: &'a CannedCycle,
    },
    /// Cutter compensation (G41, G42, G40), effective with the next feed block.
    CutterCompensation {
        /// Left of the written path, or right; `None`: off.
        left: Option<bool>,
        /// Register of the radius.
        register: u32,
    },
    /// Rapid; words that do not change are left out.
    Rapid {
        /// End point.
        words: AxisWords,
    },
    /// Rapid in machine coordinates; all its words are written. After it the positions of these axes in program
    /// coordinates are unknown.
    Machine {
        /// End point, machine coordinates.
        words: AxisWords,
    },
    /// The retract axis to its machine position, by the machine retract of the configuration. After it the position of
    /// this axis in program coordinates is unknown.
    Retract {
        /// End point, machine coordinate.
        words: AxisWords,
    },
    /// Other linear axes to their home positions, as the retract axis where that goes to its reference position.
    Home {
        /// End point, machine coordinates.
        words: AxisWords,
    },
    /// Safety line, at which a program can be entered: units, plane, modes cancelled, feed per minute, work offset.
    /// After it every word is written again.
    Restart {
        /// Number of the safety line, from 1.
        number: u32,
        /// A tool change follows.
        changes_tool: bool,
    },
    /// The modes of a safety line after blocks of the shop that may have changed them; the program is not entered
    /// there.
    Modes,
    /// Feed per minute from here on.
    PerMinute,
    /// Tool call.
    Tool {
        /// Tool number.
        number: u32,
        /// Register of its length.
        offset: u32,
        /// Next tool of the program, if there is one.
        next: Option<u32>,
        /// First spindle speed of the tool, rev/min, if known.
        speed: Option<Decimal>,
        /// Delta of its radius, which takes the radius off where the path is that of the tool centre, mm.
        radius_delta: Option<f64>,
        /// False if the tool is in the spindle already.
        change: bool,
    },
    /// Blocks of the shop for the tool in the spindle; after them the state of the machine is unknown.
    ToolRoutine {
        /// Number of the tool.
        tool: u32,
        /// Their use.
        routine: ToolRoutine,
    },
    /// Length offset of the following motions.
    Length {
        /// Register.
        offset: u32,
    },
    /// Tip control (TCP) on or off: while it is on, linear words are coordinates of the tip.
    TipControl {
        /// On from here.
        on: bool,
    },
    /// Tilted plane for the linear words; the rotary axes are positioned for it.
    Plane {
        /// Angles of the plane in the convention of the control, degrees.
        angles: [Decimal; 3],
        /// Choice between the two poses, where it has to be programmed: true for plus or the higher one.
        pose: Option<bool>,
    },
    /// Tilted plane off.
    PlaneOff,
    /// Dynamic work offset on or off: while it is on, the zero of the words has moved with the table.
    DynamicOffset {
        /// On from here.
        on: bool,
    },
    /// Stop if the radius of the tool, which must be wear only, is larger than wear.
    RadiusGuard {
        /// Number of the tool.
        tool: u32,
        /// Largest wear, mm.
        wear: f64,
    },
    /// Comparison of the tool length in the control with the posted one; the program stops where they differ. Writes
    /// nothing where a control cannot compare.
    LengthGuard {
        /// Label that is unique in the program.
        label: u32,
        /// Tool in the spindle.
        tool: u32,
        /// Register of its length.
        offset: u32,
        /// Posted gauge length, mm.
        length: f64,
        /// Largest difference allowed, mm.
        tolerance: f64,
    },
    /// Comparison of rotary axes with their positions, apart from whole turns, after the control has tilted a plane;
    /// the program stops where they differ. Writes nothing where a control cannot compare.
    PlaneGuard {
        /// Label that is unique among these steps.
        label: u32,
        /// Positions.
        words: AxisWords,
    },
    /// Comparison of what lies over the work offset: rotation, scale, mirror, shifts that last; the program stops where
    /// there is any.
    OffsetGuard {
        /// Label that is unique among these steps.
        label: u32,
    },
    /// Spindle on.
    Spindle {
        /// rev/min.
        speed: Decimal,
        /// Sense of rotation.
        rotation: Rotation,
    },
    /// Code of the configuration that moves nothing and changes no mode.
    Code {
        /// Text of the block.
        text: &'a str,
    },
    /// Spindle off.
    SpindleOff,
    /// Dwell.
    Dwell {
        /// Duration, s.
        seconds: f64,
    },
    /// Coolant on.
    Coolant {
        /// Kind that the control has; never `On` or `Off`.
        kind: Coolant,
    },
    /// All coolant off.
    CoolantOff,
    /// Program stop; after it the state of the machine is unknown.
    Stop {
        /// Stops only where the operator has enabled optional stops.
        optional: bool,
    },
    /// The following blocks may be skipped at the control, or no longer; after it the state of the machine is unknown.
    BlockSkip {
        /// They may, from here.
        on: bool,
    },
    /// Beginning of an operation.
    Operation {
        /// Name in the CL data.
        name: &'a [u8],
    },
    /// Text for the operator.
    Message {
        /// Text in the CL data.
        text: &'a [u8],
    },
    /// Work offset of the following motions; written with the next restart.
    WorkOffset {
        /// Word of the offset.
        word: &'a str,
    },
    /// Smoothing of the following cuts; nothing is written before the next of them.
    Smoothing {
        /// That of the operation; `None`: that of the configuration for the whole program.
        level: Option<Smoothing>,
        /// Largest deviation where the control blends or smooths, mm; `None`: as for the level.
        tolerance_mm: Option<f64>,
    },
    /// Blocks of the shop at the start or the end of an operation; after them the state of the machine is unknown.
    OperationBlocks {
        /// At its end.
        at_end: bool,
    },
    /// Blocks with which a probe measures, written unchanged; smoothing is off before them, and the state of the
    /// machine unknown after them.
    Probe {
        /// The blocks.
        blocks: &'a [String],
    },
    /// Block written unchanged; after it the state of the machine is unknown.
    Raw {
        /// Text of the block.
        text: &'a [u8],
    },
}

impl Step<'_> {
    /// Kind of the step in one word, as in the JSON of `--map`.
    #[must_use]
    pub const fn name(&self) -> &'static str {
        match self {
            Self::Feed { .. } => "feed",
            Self::Arc { .. } => "arc",
            Self::Cycle { .. } => "cycle",
            Self::CutterCompensation { .. } => "compensation",
            Self::Rapid { .. } => "rapid",
            Self::Machine { .. } | Self::Retract { .. } | Self::Home { .. } => "machine-coordinates",
            Self::Restart { .. } => "restart",
            Self::Modes => "modes",
            Self::PerMinute => "feed-mode",
            Self::Tool { .. } => "tool",
            Self::ToolRoutine { routine, .. } => match routine {
                ToolRoutine::Measure => "tool-measurement",
                ToolRoutine::Start => "tool-start",
                ToolRoutine::End => "tool-end",
                ToolRoutine::Check => "tool-check",
            },
            Self::Length { .. } => "length-offset",
            Self::TipControl { .. } => "tip-control",
            Self::Plane { .. } | Self::PlaneOff => "plane",
            Self::DynamicOffset { .. } => "dynamic-offset",
            Self::LengthGuard { .. } => "length-guard",
            Self::RadiusGuard { .. } => "radius-guard",
            Self::PlaneGuard { .. } => "plane-guard",
            Self::OffsetGuard { .. } => "offset-guard",
            Self::Spindle { .. } | Self::SpindleOff => "spindle",
            Self::Code { .. } => "code",
            Self::Dwell { .. } => "dwell",
            Self::Coolant { .. } | Self::CoolantOff => "coolant",
            Self::Stop { .. } => "stop",
            Self::BlockSkip { .. } => "block-skip",
            Self::Operation { .. } => "operation",
            Self::Message { .. } => "message",
            Self::WorkOffset { .. } => "work-offset",
            Self::Smoothing { .. } => "smoothing",
            Self::OperationBlocks { at_end: false } => "operation-start",
            Self::OperationBlocks { at_end: true } => "operation-end",
            Self::Probe { .. } => "probe",
            Self::Raw { .. } => "insert",
        }
    }
}

/// Receiver of the steps of a program.
pub trait Sink {
    /// Writes one step; `from` has its record in the CL data and the position after it.
    ///
    /// # Errors
    /// The error of the output.
    fn step(&mut self, step: &Step<'_>, from: &Provenance<'_>) -> io::Result<()>;
}

impl<S: Sink> Sink for &mut S {
    #[inline]
    fn step(&mut self, step: &Step<'_>, from: &Provenance<'_>) -> io::Result<()> {
        (**self).step(step, from)
    }
}

/// Sink that drops the steps, for a rehearsal.
#[derive(Debug, Clone, Copy)]
pub(crate) struct DiscardSteps;

impl Sink for DiscardSteps {
    fn step(&mut self, _: &Step<'_>, _: &Provenance<'_>) -> io::Result<()> {
        Ok(())
    }
}
