//! The machine-independent program: one [`Event`] for each thing that the CL data asks for.
//!
//! The CL reader produces the events, the planner consumes them. Lengths are in mm, angles in rad, feeds in mm/min or
//! mm/rev, speeds in rev/min. Points and tool axes are in the workpiece frame, as the CL data gives it.
//!
//! ```
//! use pp_runtime::cl::{ClReader, ReadingOptions};
//! use pp_runtime::program::{Event, ToolMotion, Units};
//!
//! let options = ReadingOptions { units: Some(Units::Inches), ..ReadingOptions::default() };
//! let mut reader = ClReader::new(&b"GOTO/0,0,1\nFEDRAT/10,IPM\nGOTO/2,0,1\n"[..], options);
//! let mut tips = Vec::new();
//! while let Some((_, event)) = reader.next_event()? {
//!     if let Event::Motion(ToolMotion::Move(motion)) = event {
//!         tips.push(motion.pose.tip);
//!     }
//! }
//! assert!(((tips[1] - tips[0]).norm() - 50.8).abs() < 1e-9);
//! # Ok::<(), std::io::Error>(())
//! ```

mod clearance;
mod quantity;

use crate::kinematics::Pose;
use crate::nalgebra::{Point3, UnitVector3};

pub(crate) use clearance::Clearance;
pub use clearance::ClearancePlane;
pub(crate) use quantity::Shown;

/// Whether a text is a block of printable ASCII characters, which all controls read alike.
pub(crate) fn is_nc_text(text: &[u8]) -> bool {
    !text.is_empty() && text.iter().all(|byte| (b' '..=b'~').contains(byte))
}

/// Line and column in a text file. Both count from 1; columns count bytes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Default)]
pub struct Location {
    /// Line of the first byte of the statement; in a continued statement the line of the byte in question.
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
    /// All units, by name.
    pub(crate) const NAMES: [(&'static str, Self); 2] = [("mm", Self::Millimetres), ("in", Self::Inches)];

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

/// Sense of rotation, of the spindle seen from the spindle towards the tool tip.
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
    /// Spindle on. A part that is `None` keeps its last programmed value.
    On {
        /// Spindle speed.
        speed_rev_per_min: Option<f64>,
        /// Sense of rotation.
        rotation: Option<Rotation>,
    },
    /// Spindle off.
    Off,
}

/// Coolant command.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Coolant {
    /// COOLNT/ON: the kind that the configuration sets, else flood.
    On,
    /// M8.
    Flood,
    /// M7.
    Mist,
    /// Coolant through the spindle.
    Through,
    /// Coolant through the spindle at a pressure.
    ThroughAt(Pressure),
    /// Air blast.
    Air,
    /// M9.
    Off,
}

impl Coolant {
    /// The kinds that have codes, in the order in which they are switched on.
    pub const KINDS: [Self; 7] = [
        Self::Flood,
        Self::Mist,
        Self::Through,
        Self::Air,
        Self::ThroughAt(Pressure::Low),
        Self::ThroughAt(Pressure::Medium),
        Self::ThroughAt(Pressure::High),
    ];

    /// Names of the kinds in a set-up file, in the order of [`KINDS`](Self::KINDS).
    pub const NAMES: [&'static str; 7] =
        ["flood", "mist", "through", "air", "through_low", "through_medium", "through_high"];

    /// Place of a kind among [`KINDS`](Self::KINDS); that of flood for `On`, none for `Off`.
    #[must_use]
    pub fn index(self) -> Option<usize> {
        let kind = if self == Self::On { Self::Flood } else { self };
        Self::KINDS.iter().position(|known| *known == kind)
    }
}

/// Kinds of coolant that are on together.
///
/// ```
/// use pp_runtime::program::{Coolant, Coolants};
///
/// let both = Coolants::of(Coolant::Through).with(Coolant::Flood);
/// assert_eq!(both.kinds().collect::<Vec<_>>(), [Coolant::Flood, Coolant::Through]);
/// assert!(Coolants::of(Coolant::Off).is_empty());
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Coolants {
    /// Bit `i` is set for the kind at place `i`.
    bits: u8,
}

impl Coolants {
    /// The kind of a command alone; empty for `Off`.
    #[must_use]
    pub fn of(kind: Coolant) -> Self {
        Self::default().with(kind)
    }

    /// These and one more.
    #[must_use]
    pub fn with(self, kind: Coolant) -> Self {
        Self { bits: self.bits | kind.index().map_or(0, |index| 1 << index) }
    }

    /// Whether a kind is among them.
    #[must_use]
    pub fn has(self, kind: Coolant) -> bool {
        kind.index().is_some_and(|index| self.bits & (1 << index) != 0)
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(self) -> bool {
        self.bits == 0
    }

    /// The kinds, in the order in which they are switched on.
    pub fn kinds(self) -> impl Iterator<Item = Coolant> {
        Coolant::KINDS.into_iter().filter(move |kind| self.has(*kind))
    }
}

impl FromIterator<Coolant> for Coolants {
    fn from_iter<I: IntoIterator<Item = Coolant>>(kinds: I) -> Self {
        kinds.into_iter().fold(Self::default(), Self::with)
    }
}

/// Pressure of coolant, as CL data names it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Pressure {
    /// LOW.
    Low,
    /// MEDIUM.
    Medium,
    /// HIGH.
    High,
}

impl Pressure {
    /// Words of the pressures in CL data.
    pub const WORDS: [(&'static str, Self); 3] = [("LOW", Self::Low), ("MEDIUM", Self::Medium), ("HIGH", Self::High)];

    /// Its word in CL data.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Low => "LOW",
            Self::Medium => "MEDIUM",
            Self::High => "HIGH",
        }
    }
}

/// Feed rate as programmed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Feed {
    /// mm/min.
    PerMinute(f64),
    /// mm per revolution of the spindle.
    PerRevolution(f64),
}

/// Tool call: LOADTL, LOAD/TOOL.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ToolCall {
    /// Tool number.
    pub number: u32,
    /// Gauge length in the record (LENGTH).
    pub length_mm: Option<f64>,
    /// Length offset register (H) in the record (ADJUST, OSETNO).
    pub length_offset: Option<u32>,
    /// Cutter diameter from CUTTER or TLDATA.
    pub diameter_mm: Option<f64>,
    /// Corner radius from CUTTER or TLDATA.
    pub corner_radius_mm: Option<f64>,
}

impl ToolCall {
    /// The call with what it leaves out from another call of the tool.
    #[must_use]
    pub(crate) fn completed_by(self, other: &Self) -> Self {
        Self {
            number: self.number,
            length_mm: self.length_mm.or(other.length_mm),
            length_offset: self.length_offset.or(other.length_offset),
            diameter_mm: self.diameter_mm.or(other.diameter_mm),
            corner_radius_mm: self.corner_radius_mm.or(other.corner_radius_mm),
        }
    }
}

/// One straight motion of the tool.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Move {
    /// Pose at the end of the motion; its tool axis is normalised.
    pub pose: Pose,
    /// The motion is a rapid: RAPID comes before it.
    pub rapid: bool,
    /// Feed in force; `None` until the first FEDRAT. Not used for a rapid.
    pub feed: Option<Feed>,
}

/// An arc, a full circle, several revolutions or a helix, with constant tool axis.
///
/// The tip runs counter-clockwise about `normal`. Its motion along `normal` is proportional to the angle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Arc {
    /// Pose at the start: the end of the motion before.
    pub start: Pose,
    /// Pose at the end, with the tool axis of the start.
    pub end: Pose,
    /// Point on the axis of the circle.
    pub centre: Point3<f64>,
    /// Direction of that axis. Looking against it, the tip runs counter-clockwise.
    pub normal: UnitVector3<f64>,
    /// Angle of the whole motion, above 0; above 2π for more than one revolution.
    pub angle_rad: f64,
    /// As for a [`Move`].
    pub feed: Option<Feed>,
}

/// A cubic B-spline that begins at the end of the motion before, with constant tool axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spline<'a> {
    /// All knots, with the end knots in their multiplicity of 4: four more knots than points.
    pub knots: &'a [f64],
    /// Control points; the first is the start of the spline, the last its end.
    pub points: &'a [Point3<f64>],
    /// Tool axis.
    pub axis: UnitVector3<f64>,
    /// As for a [`Move`].
    pub feed: Option<Feed>,
}

/// A dwell.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Dwell {
    /// Duration in seconds.
    Seconds(f64),
    /// Duration in revolutions of the spindle.
    Revolutions(f64),
}

/// Kind of hole-making. Depths and steps are along the tool axis, above 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Drilling {
    /// DRILL, FACE, CSINK, THRU: in at feed, out at rapid.
    Drill,
    /// BORE, REAM: in at feed, out at feed.
    Ream,
    /// DEEP: peck drilling, out to the clearance level after each step.
    Peck {
        /// Depth of the first step.
        first_mm: f64,
        /// Depth of each later one.
        later_mm: f64,
    },
    /// BRKCHP: chip breaking, a short retract after each step.
    ChipBreak {
        /// Depth of each step.
        step_mm: f64,
        /// Retract after each step; `None`: as configured.
        retract_mm: Option<f64>,
    },
    /// BORE with ORIENT: in at feed, spindle stopped at an angle, the tip moved off the wall, out at rapid.
    FineBore {
        /// Angle at which the spindle stops, as the control counts it.
        orient_rad: f64,
    },
    /// THRU of several plates: in at feed through each plate, at rapid through the gaps between them, out at rapid.
    Through {
        /// Gaps between the plates, from the top.
        gaps: Gaps,
    },
    /// TAP.
    Tap {
        /// Pitch of the thread, mm per revolution, if the CL data states it.
        pitch_mm: Option<f64>,
    },
}

/// Largest number of gaps in a hole. With more a hole would be larger than an arc, and so would every event be.
pub(crate) const MOST_GAPS: usize = 3;

const _: () = assert!(size_of::<Hole>() <= size_of::<Arc>());

/// A gap between two plates of a hole, by depths below its top.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Gap {
    /// Depth at which the feed ends: the tip is through the plate above.
    pub feed_ends_mm: f64,
    /// Depth to which the tool moves at rapid, and at which the feed begins again: above the plate below, and above 0
    /// where negative.
    pub feed_begins_mm: f64,
}

/// The gaps between the plates of a hole, from the top.
///
/// ```
/// use pp_runtime::program::{Gap, Gaps};
///
/// let gap = Gap { feed_ends_mm: 12.0, feed_begins_mm: 18.0 };
/// assert_eq!(Gaps::of(&[gap]).unwrap().iter().collect::<Vec<_>>(), [gap]);
/// assert!(Gaps::of(&[gap; 5]).is_none(), "more than `MOST_GAPS`");
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Gaps {
    gaps: [Gap; MOST_GAPS],
    count: usize,
}

impl Gaps {
    /// These gaps; `None` if they are more than `MOST_GAPS`.
    #[must_use]
    pub fn of(found: &[Gap]) -> Option<Self> {
        let mut gaps = [Gap::default(); MOST_GAPS];
        gaps.get_mut(..found.len())?.copy_from_slice(found);
        Some(Self { gaps, count: found.len() })
    }

    /// The gaps in their order.
    pub fn iter(&self) -> impl Iterator<Item = Gap> + '_ {
        self.gaps.iter().take(self.count).copied()
    }
}

/// One hole of a CYCLE. Levels are measured from `top` along the tool axis, positive away from the part.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hole {
    /// Top of the hole: the point of the GOTO.
    pub top: Pose,
    /// Depth of the tip below `top`, above 0.
    pub depth_mm: f64,
    /// Clearance level, 0 or more: down to it the tool moves at rapid (R plane).
    pub clearance_mm: f64,
    /// Return level after the hole, at least the clearance level.
    pub return_mm: f64,
    /// Kind of hole-making.
    pub drilling: Drilling,
    /// Feed of the cycle, else the feed in force.
    pub feed: Option<Feed>,
    /// Dwell at the bottom.
    pub dwell: Option<Dwell>,
}

impl Hole {
    /// Pose at a level above the top of the hole.
    #[must_use]
    pub fn level(&self, level_mm: f64) -> Pose {
        Pose { tip: self.top.tip + self.top.axis.into_inner() * level_mm, axis: self.top.axis }
    }

    /// Rapid motion to the clearance level of the hole.
    #[must_use]
    pub fn rapid_to_clearance(&self) -> Move {
        Move { pose: self.level(self.clearance_mm), rapid: true, feed: self.feed }
    }
}

/// Cutter compensation: CUTCOM.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Compensation {
    /// Side of the path.
    pub side: CutterSide,
    /// Offset register (D), if the record names one.
    pub register: Option<u32>,
    /// The record names the XY plane or no plane.
    pub in_xy_plane: bool,
}

/// Side of the path on which the cutter runs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CutterSide {
    /// Compensation off.
    Off,
    /// Compensation on again, on the side programmed last.
    On,
    /// Left of the path.
    Left,
    /// Right of the path.
    Right,
}

/// Direction in which the rotary axis turns: ROTABL.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RotaryDirection {
    /// Shortest rotation.
    Shortest,
    /// Rotation of the table in this sense, in the next motion only.
    Towards(Rotation),
}

/// One instruction of the CL data, in its group.
///
/// A pass over the program matches the events that it acts on, and all others by their group: a new event of a group
/// has the properties of that group everywhere.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Event<'a> {
    /// A motion of the tool.
    Motion(ToolMotion<'a>),
    /// The path ends, and starts anew with the next motion.
    NewStart(NewStart<'a>),
    /// The path is interrupted: a cut goes on from where it was.
    Interruption(Interruption<'a>),
    /// A function of the machine for the motions around it.
    Function(MachineFunction),
    /// A point or a plane for the motions after it; nothing moves.
    Reference(ReferenceGeometry),
    /// A text, as written, that changes neither path nor state of the machine.
    Text(TextKind, &'a [u8]),
}

impl Event<'_> {
    /// Whether the record is carried out by a block of its own: it is not data for the motions after it. A tool that
    /// has been called is changed before it.
    pub(crate) const fn writes_block(&self) -> bool {
        match self {
            Self::Interruption(interruption) => !matches!(interruption, Interruption::BlockSkip { .. }),
            Self::NewStart(start) => matches!(start, NewStart::Home),
            Self::Function(function) => matches!(function, MachineFunction::Delay(_)),
            Self::Text(kind, _) => matches!(kind, TextKind::Message),
            Self::Motion(_) | Self::Reference(_) => false,
        }
    }
}

/// A motion of the tool. Only these and [`ReferenceGeometry`] have points and directions.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum ToolMotion<'a> {
    /// GOTO.
    Move(Move),
    /// CIRCLE, MOVARC, TLON with the GOTO that ends it.
    Arc(Arc),
    /// NURBS, KNOT and CNTRL.
    Spline(Spline<'a>),
    /// A GOTO under a CYCLE.
    Hole(Hole),
}

/// Instruction at which the path ends. The next motion begins an operation, and cutter compensation must be off.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum NewStart<'a> {
    /// TOOL PATH: begin of an operation, with its name, UTF-8.
    Operation(&'a [u8]),
    /// Tool call.
    Tool(ToolCall),
    /// The set-up of this number begins, counted from 1: the part is clamped again, with its own origin, rotation and
    /// work offset. Begins like an operation.
    SetUp(u32),
    /// The next motion begins with the safe sequence.
    SafeSequence,
    /// GOHOME without a point.
    Home,
}

impl NewStart<'_> {
    /// A sentence of a message: what happens.
    pub(crate) const fn sentence(self) -> &'static str {
        match self {
            Self::Operation(_) | Self::SafeSequence => "another operation begins",
            Self::Tool(_) => "a tool is called",
            Self::SetUp(_) => "another frame follows",
            Self::Home => "GOHOME follows",
        }
    }
}

/// Instruction after which the position of the machine, or its state, is unknown. The next motion begins an operation,
/// and cutter compensation must be off.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Interruption<'a> {
    /// STOP.
    Stop,
    /// OPSTOP.
    OptionalStop,
    /// OPSKIP: the blocks after this one may be skipped at the control, or no longer. Each is between two operations.
    BlockSkip {
        /// ON.
        on: bool,
    },
    /// INSERT, and a statement of the shop: block of NC text, as written.
    Insert(&'a [u8], BlockPlace),
    /// A statement at which a probe measures from where the tool is: blocks, one or more.
    Probe(&'a [String]),
    /// AUXFUN, PREFUN: an M or G code of the control.
    Code {
        /// `M` or `G`.
        letter: u8,
        /// Number after the letter.
        number: u32,
        /// Where it comes.
        place: BlockPlace,
    },
}

/// Where a block of the shop comes that comes between the call of a tool and the motion after it: `at` in `[cl.words]`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum BlockPlace {
    /// Not stated: records act in the order of the CL data, after the tool change.
    #[default]
    InOrder,
    /// With the tool that is in the spindle.
    BeforeChange,
    /// With the tool that has been called.
    AfterChange,
    /// Before the approach to the next motion, after the other records.
    AtApproach,
}

impl BlockPlace {
    /// Names of those that can be stated.
    pub(crate) const NAMES: [(&'static str, Self); 3] =
        [("before_change", Self::BeforeChange), ("after_change", Self::AfterChange), ("at_approach", Self::AtApproach)];

    /// The place in the words of a summary; empty where it is not stated.
    pub(crate) const fn phrase(self) -> &'static str {
        match self {
            Self::InOrder => "",
            Self::BeforeChange => " before the tool change",
            Self::AfterChange => " after the tool change",
            Self::AtApproach => " at the approach",
        }
    }
}

impl Interruption<'_> {
    /// A sentence of a message: what happens.
    pub(crate) const fn sentence(self) -> &'static str {
        match self {
            Self::Stop | Self::OptionalStop => "the program stops",
            Self::BlockSkip { .. } => "OPSKIP follows",
            Self::Insert(..) | Self::Code { .. } => "NC text of the CL data follows",
            Self::Probe(_) => "a probe measures",
        }
    }
}

/// Function of the machine or of its control. The path goes on after it, also with cutter compensation.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum MachineFunction {
    /// SPINDL.
    Spindle(Spindle),
    /// COOLNT.
    Coolant(Coolant),
    /// CUTCOM.
    Compensation(Compensation),
    /// LINTOL: tolerance of the following motions, mm; `None`: as configured.
    Tolerance(Option<f64>),
    /// ROTABL/SHORT, ROTABL/NEXT.
    RotaryDirection(RotaryDirection),
    /// DELAY.
    Delay(Dwell),
    /// SELECT/TOOL: number of the next tool.
    Preselect(u32),
}

/// Point or plane in the workpiece frame that is not on the path.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum ReferenceGeometry {
    /// FROM: point and tool axis at the start.
    From(Pose),
    /// CLEARP.
    ClearancePlane(ClearancePlane),
}

/// Kind of a text.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum TextKind {
    /// PARTNO: name of the program.
    Name,
    /// MACHIN: name of the machine that the CL data was made for.
    MachineName,
    /// PPRINT: text for the operator.
    Message,
}
