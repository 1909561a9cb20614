//! The machine-independent program: what the CL data asks for, one event at a time.
//!
//! The CL reader produces these events, the planner consumes them. Everything is in millimetres, radians,
//! mm/min and rev/min; points and axes are in the workpiece frame as the CL data gives it.

use crate::kinematics::Pose;

/// Where something stands in a text file; lines and columns count from 1, columns in bytes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Default)]
pub struct Location {
    /// Line of the first byte of the statement (for a continued statement the line of the offending byte).
    pub line: u64,
    /// Column of that byte.
    pub column: u32,
}

/// Unit of length of a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Units {
    /// `mm`.
    Millimetres,
    /// `in`, 25.4 mm exactly.
    Inches,
}

impl Units {
    /// Length of one unit in mm.
    #[must_use]
    pub const fn in_mm(self) -> f64 {
        match self {
            Self::Millimetres => 1.0,
            Self::Inches => 25.4,
        }
    }

    /// `mm` or `in`, as on the command line and in configuration files.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Millimetres => "mm",
            Self::Inches => "in",
        }
    }
}

/// Sense of rotation of the spindle, seen from the spindle towards the tip.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Rotation {
    /// CLW: M3.
    Clockwise,
    /// CCLW: M4.
    CounterClockwise,
}

/// Spindle command.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Spindle {
    /// Turn; a missing part keeps the last one given.
    On {
        /// rev/min.
        speed: Option<f64>,
        /// Sense of rotation.
        rotation: Option<Rotation>,
    },
    /// Stop.
    Off,
}

/// Coolant command.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Coolant {
    /// COOLNT/ON: the default kind of the configuration, FLOOD without one.
    On,
    /// M8.
    Flood,
    /// M7.
    Mist,
    /// Through the spindle.
    Through,
    /// Air.
    Air,
    /// M9.
    Off,
}

/// Feed rate as programmed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Feed {
    /// mm/min.
    PerMinute(f64),
    /// mm per revolution of the spindle.
    PerRevolution(f64),
}

/// A tool record: LOADTL, LOAD/TOOL.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ToolCall {
    /// Number of the tool.
    pub number: u32,
    /// Gauge length given with the record, mm.
    pub length: Option<f64>,
    /// Length offset register given with the record (ADJUST, OSETNO).
    pub offset: Option<u32>,
    /// Diameter from CUTTER or TLDATA, mm.
    pub diameter: Option<f64>,
    /// Corner radius from CUTTER or TLDATA, mm.
    pub corner_radius: Option<f64>,
}

/// One straight motion of the tool.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Move {
    /// Where it ends. The axis is normalised.
    pub pose: Pose,
    /// RAPID stood in front.
    pub rapid: bool,
    /// Modal feed; `None` until the first FEDRAT. Meaningless for a rapid.
    pub feed: Option<Feed>,
}

/// What the CL data asks for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Event<'a> {
    /// PARTNO: the program's name as written.
    Name(&'a [u8]),
    /// TOOL PATH: an operation begins; its name as written.
    Operation(&'a [u8]),
    /// A tool record.
    Tool(ToolCall),
    /// SELECT/TOOL: the tool that will be needed next.
    Preselect(u32),
    /// SPINDL.
    Spindle(Spindle),
    /// COOLNT.
    Coolant(Coolant),
    /// FROM: the point and axis from which motion counts; nothing moves.
    From(Pose),
    /// GOTO.
    Move(Move),
    /// OPSTOP.
    OptionalStop,
    /// STOP.
    Stop,
    /// PPRINT: text for the operator.
    Message(&'a [u8]),
}
