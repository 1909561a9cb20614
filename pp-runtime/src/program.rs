//! The machine-independent program: what the CL data asks for, one event at a time.
//!
//! The CL reader produces these events, the planner consumes them. Everything is in millimetres, radians,
//! mm/min and rev/min; points and axes are in the workpiece frame as the CL data gives it.

use crate::kinematics::Pose;
use crate::nalgebra::{Point3, UnitVector3};

/// Where something stands in a text file; lines and columns count from 1, columns in bytes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Default)]
pub struct Location {
    /// Line of the first byte of the statement (for a continued statement the line of the offending byte).
    pub line: u64,
    /// Column of that byte.
    pub column: u32,
}

/// Unit of length of a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Units {
    /// `mm`.
    #[default]
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
        speed_rev_per_min: Option<f64>,
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
    pub length_mm: Option<f64>,
    /// Length offset register given with the record (ADJUST, OSETNO).
    pub length_offset: Option<u32>,
    /// Diameter from CUTTER or TLDATA, mm.
    pub diameter_mm: Option<f64>,
    /// Corner radius from CUTTER or TLDATA, mm.
    pub corner_radius_mm: Option<f64>,
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

/// An arc of a circle, a full circle, several turns or a helix, with the tool axis held.
///
/// The tip turns counter-clockwise about `normal`; what it moves along `normal` it moves in proportion to the angle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Arc {
    /// Where it begins: the end of the motion before.
    pub start: Pose,
    /// Where it ends; the axis is that of the start.
    pub end: Pose,
    /// A point of the circle's axis.
    pub centre: Point3<f64>,
    /// Direction of that axis; seen against it the tip turns counter-clockwise.
    pub normal: UnitVector3<f64>,
    /// Angle of the whole motion, rad, above 0; more than a turn for several.
    pub angle_rad: f64,
    /// As for a [`Move`].
    pub feed: Option<Feed>,
}

/// A cubic B-spline that begins where the motion before ended.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spline<'a> {
    /// Every knot, ends included as often as they count: four more than points.
    pub knots: &'a [f64],
    /// Control points; the first is where the spline begins, the last where it ends.
    pub points: &'a [Point3<f64>],
    /// The tool axis, held.
    pub axis: UnitVector3<f64>,
    /// As for a [`Move`].
    pub feed: Option<Feed>,
}

/// A wait.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Dwell {
    /// Seconds.
    Seconds(f64),
    /// Revolutions of the spindle.
    Revolutions(f64),
}

/// How a hole is made; depths and steps in mm along the tool axis, above 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Drilling {
    /// DRILL, FACE, CSINK, THRU: in at feed, out at rapid.
    Drill,
    /// BORE, REAM: in at feed, out at feed.
    Ream,
    /// DEEP: after each step out to the clearance level.
    Peck {
        /// Depth of the first step.
        first_mm: f64,
        /// Depth of each later one.
        later_mm: f64,
    },
    /// BRKCHP: after each step back a little.
    ChipBreak {
        /// Depth of a step.
        step_mm: f64,
        /// How far back; `None`: as configured.
        retract_mm: Option<f64>,
    },
    /// TAP.
    Tap {
        /// mm per turn, if stated.
        pitch_mm: Option<f64>,
    },
}

/// One hole of a CYCLE. Levels count from `top` along the tool axis, + away from the part.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hole {
    /// The point of the GOTO: top of the hole.
    pub top: Pose,
    /// How deep the tip goes below `top`, above 0.
    pub depth_mm: f64,
    /// Level to which the tool comes down at rapid, 0 or more.
    pub clearance_mm: f64,
    /// Level where it stands afterwards, at least `clearance`.
    pub return_mm: f64,
    /// How it is made.
    pub drilling: Drilling,
    /// Feed of the cycle, else the modal one.
    pub feed: Option<Feed>,
    /// Wait at the bottom.
    pub dwell: Option<Dwell>,
}

impl Hole {
    /// The pose at a height over its top, mm.
    #[must_use]
    pub fn level(&self, height: f64) -> Pose {
        Pose { tip: self.top.tip + self.top.axis.into_inner() * height, axis: self.top.axis }
    }

    /// The rapid to its clearance level.
    #[must_use]
    pub fn rapid_to_clearance(&self) -> Move {
        Move { pose: self.level(self.clearance_mm), rapid: true, feed: self.feed }
    }
}

/// A plane of the workpiece frame: the points `p` with `normal · p = distance`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ClearancePlane {
    /// Its direction, away from the part.
    pub normal: UnitVector3<f64>,
    /// mm from the origin.
    pub distance_mm: f64,
}

/// Geometry around the part in the workpiece frame, mm: outside it the tool may move freely.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Clearance {
    /// Everything below a plane.
    Plane(ClearancePlane),
    /// A box along the axes of the frame.
    Box {
        /// Its lowest corner.
        lower: Point3<f64>,
        /// Its highest corner.
        upper: Point3<f64>,
    },
    /// A cylinder along Z.
    Cylinder {
        /// X and Y of its axis.
        centre: [f64; 2],
        /// Its radius.
        radius_mm: f64,
        /// Z of its lower end.
        lower_z_mm: f64,
        /// Z of its upper end.
        upper_z_mm: f64,
    },
}

/// CUTCOM.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Compensation {
    /// On which side.
    pub side: CutterSide,
    /// Offset register, if one is named.
    pub register: Option<u32>,
    /// No other plane than that of X and Y is named.
    pub in_xy_plane: bool,
}

/// On which side of the path the cutter runs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CutterSide {
    /// Off.
    Off,
    /// On again, on the side that was given last.
    On,
    /// Left of the path.
    Left,
    /// Right of the path.
    Right,
}

/// ROTABL: which way a rotary axis turns.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RotaryDirection {
    /// The shortest.
    Shortest,
    /// The next one in this sense.
    Towards(Rotation),
}

/// What the CL data asks for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Event<'a> {
    /// PARTNO: the program's name as written.
    Name(&'a [u8]),
    /// MACHIN: the machine that the CL data was made for, as written.
    MachineName(&'a [u8]),
    /// TOOL PATH: an operation begins; its name as written.
    Operation(&'a [u8]),
    /// What follows begins with the safe sequence.
    SafeSequence,
    /// What follows is in the frame of this number, from 1: a work offset of its own. Begins like an operation.
    Frame(u32),
    /// A tool record.
    Tool(ToolCall),
    /// SELECT/TOOL: the tool that will be needed next.
    Preselect(u32),
    /// SPINDL.
    Spindle(Spindle),
    /// COOLNT.
    Coolant(Coolant),
    /// CUTCOM.
    Compensation(Compensation),
    /// FROM: the point and axis from which motion counts; nothing moves.
    From(Pose),
    /// GOTO.
    Move(Move),
    /// CIRCLE, MOVARC, TLON with the GOTO that ends it.
    Arc(Arc),
    /// NURBS, KNOT and CNTRL.
    Spline(Spline<'a>),
    /// A GOTO under a CYCLE.
    Hole(Hole),
    /// GOHOME without a point.
    Home,
    /// CLEARP.
    ClearancePlane(ClearancePlane),
    /// LINTOL: the tolerance of what follows, mm; `None`: as configured.
    Tolerance(Option<f64>),
    /// ROTABL/SHORT, ROTABL/NEXT.
    RotaryDirection(RotaryDirection),
    /// DELAY.
    Delay(Dwell),
    /// OPSTOP.
    OptionalStop,
    /// STOP.
    Stop,
    /// PPRINT: text for the operator.
    Message(&'a [u8]),
    /// INSERT: a block of NC text as written.
    Insert(&'a [u8]),
    /// AUXFUN, PREFUN: a code of the control.
    Code {
        /// `M` or `G`.
        letter: u8,
        /// Its number.
        number: u32,
    },
}
