//! What a reader makes of a program: one [`Block`] after the other, each with the state in which it acts.
//!
//! Lengths are mm and angles rad, whatever the unit of the program; levels and centres count as the words of the program
//! do. Nothing in here knows a machine or CL data.

use std::fmt;

use nalgebra::{Matrix3, Vector3};

use crate::program::{Rotation, Units};

/// Most axes a chain can have: X Y Z U V W A B C.
pub const MAX_AXES: usize = 9;

/// What F means.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FeedMode {
    /// mm/min.
    PerMinute,
    /// 1/min.
    InverseTime,
    /// mm per revolution.
    PerRevolution,
}

/// Plane of arcs, cycles and cutter compensation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum WorkPlane {
    /// G17.
    Xy,
    /// G18.
    Zx,
    /// G19.
    Yz,
}

impl WorkPlane {
    /// First and second axis of the plane and its normal, as positions in X Y Z; right-handed.
    #[must_use]
    pub const fn axes(self) -> [usize; 3] {
        match self {
            Self::Xy => [0, 1, 2],
            Self::Zx => [2, 0, 1],
            Self::Yz => [1, 2, 0],
        }
    }
}

/// On which side of the path the cutter runs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Side {
    /// On it.
    #[default]
    None,
    /// G41.
    Left,
    /// G42.
    Right,
}

impl Side {
    /// The other side.
    #[must_use]
    pub fn across(self) -> Self {
        match self {
            Self::None => Self::None,
            Self::Left => Self::Right,
            Self::Right => Self::Left,
        }
    }
}

impl Side {
    /// Name in messages.
    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::None => "off",
            Self::Left => "left",
            Self::Right => "right",
        }
    }
}

/// A settable offset.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum WorkOffset {
    /// `G54`, `G59.1`, `G505`: the code in tenths.
    Code(u32),
    /// `G54.1 P`, `G154 P`.
    Further(u32),
    /// A row of the datum table.
    Row(u32),
}

/// Length compensation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Length {
    /// None is in force.
    Off,
    /// That of a register, of a cutting edge, or of the tool's row.
    Register(u32),
}

impl fmt::Display for WorkOffset {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Code(tenths) if tenths % 10 == 0 => write!(f, "G{}", tenths / 10),
            Self::Code(tenths) => write!(f, "G{}.{}", tenths / 10, tenths % 10),
            Self::Further(number) => write!(f, "P{number} of the additional work offsets"),
            Self::Row(row) => write!(f, "row {row} of the datum table"),
        }
    }
}

impl fmt::Display for Length {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Off => f.write_str("off"),
            Self::Register(number) => write!(f, "register {number}"),
        }
    }
}

/// A control that keeps the tip on its path.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum TipControl {
    /// Words are axis positions.
    Off,
    /// Words are tip coordinates; the rotary axes stood here when it was switched on, rad.
    On {
        /// By position of the axis.
        start: [f64; MAX_AXES],
    },
}

/// A tilted plane: words count in it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tilt {
    /// Plane to program coordinates.
    pub rotation: Matrix3<f64>,
    /// Where it counts from, mm.
    pub origin: Vector3<f64>,
    /// The rotary axes are in the plane: positioned to it, and no rotary word has moved them since.
    pub oriented: bool,
    /// Pose of the rotary axes that the program selects: SEQ, SYM or _DIR, `true` for plus.
    pub pose: Option<bool>,
    /// COORD ROT: the control rotates the coordinates in the plane, not the table.
    pub coordinate_rotation: bool,
}

/// Smoothing of the path by the control.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Smoothing {
    /// Not active.
    #[default]
    Off,
    /// G5.1 Q1, G187, CYCLE832, cycle 32.
    On {
        /// Largest deviation from the path, mm; `None` where the program does not state it.
        tolerance_mm: Option<f64>,
        /// P of G187, units of the second argument of CYCLE832, HSC-MODE.
        level: Option<u8>,
    },
}

/// Motion from block to block.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PathMode {
    /// G61 of LinuxCNC: the path exactly, without stops.
    ExactPath,
    /// A stop at the end of each block.
    ExactStop,
    /// G64: corners are rounded.
    Continuous {
        /// P of LinuxCNC, mm; `None`: no limit is programmed.
        tolerance_mm: Option<f64>,
        /// Q of LinuxCNC, mm: deviation up to which blocks are joined.
        joining_mm: Option<f64>,
    },
    /// G641 to G645: by the smoothing of this code.
    Smoothed(u16),
}

/// Length that a guard reads from the control.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LengthSource {
    /// The tool in the spindle, in the tool table.
    Spindle,
    /// A length register: the sum of geometry and wear.
    Register(u32),
    /// One system variable.
    Variable(u32),
    /// The row of a tool in the tool table.
    Tool(u32),
    /// The active cutting edge.
    Edge,
}

/// A length guard: the program stops if the control has another length for the tool.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Guard {
    /// Length with which it compares, mm.
    pub length_mm: f64,
    /// Largest permitted difference, mm.
    pub tolerance_mm: f64,
    /// Length that is compared.
    pub source: LengthSource,
    /// The program stops or raises an alarm if they differ.
    pub stops: bool,
}

/// Declared effect of a line or a word of the user.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Effect {
    /// Nothing that the check reads.
    None,
    /// The coolant is unknown afterwards.
    Coolant,
    /// The spindle is unknown afterwards.
    Spindle,
    /// It measures: positions are unknown afterwards.
    Measures,
    /// Positions are unknown afterwards.
    PositionLost,
    /// The program stops.
    Stop,
    /// Positions and modal state are unknown afterwards.
    StateLost,
}

/// Place of a user's line in the configuration.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum OwnPlace {
    /// `[program] start`.
    Start,
    /// `[program] end`.
    End,
    /// `control.safety`.
    Safety,
    /// `control.tool_change`.
    ToolChange,
    /// Code of a rotary clamp.
    Clamp {
        /// Position of the axis in the chain.
        axis: usize,
        /// It clamps.
        on: bool,
    },
    /// Coolant code.
    Coolant,
    /// Code of `control.tip_control`.
    TipControl {
        /// It switches tip control on.
        on: bool,
    },
    /// Text of INSERT, AUXFUN or PREFUN.
    Insert,
}

/// A line that the user brought in, executed by its declared effect or by that of its key.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct OwnLine {
    /// Where the configuration has it; the first place of several.
    pub place: OwnPlace,
    /// Strongest effect that `[control] effects` declares for it.
    pub effect: Option<Effect>,
}

/// Coolant that is on: bits.
pub mod coolant {
    /// M8.
    pub const FLOOD: u8 = 1;
    /// M7.
    pub const MIST: u8 = 2;
    /// Through the spindle.
    pub const THROUGH: u8 = 4;
    /// Air.
    pub const AIR: u8 = 8;
}

/// What has been said since a complete state began: bits.
pub mod stated {
    /// Spindle on or off.
    pub const SPINDLE: u8 = 1;
    /// Coolant.
    pub const COOLANT: u8 = 2;
    /// Length compensation.
    pub const LENGTH: u8 = 4;
    /// Work offset.
    pub const OFFSET: u8 = 8;
    /// Unit, plane, feed mode, distances and sides.
    pub const MODES: u8 = 16;
    /// Smoothing on or off.
    pub const SMOOTHING: u8 = 32;
}

/// What is in force; `None` where the program has not said it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct State {
    /// In the spindle.
    pub tool: Option<u32>,
    /// Called up for the next change.
    pub selected: Option<u32>,
    /// Length compensation.
    pub length: Option<Length>,
    /// Register of the diameter.
    pub diameter: Option<u32>,
    /// Work offset.
    pub work_offset: Option<WorkOffset>,
    /// Unit of lengths.
    pub units: Option<Units>,
    /// Words are distances.
    pub incremental: Option<bool>,
    /// Plane of arcs and cycles.
    pub plane: Option<WorkPlane>,
    /// Sense of the spindle; `Some(None)` if it stands.
    pub spindle: Option<Option<Rotation>>,
    /// S, rev/min.
    pub speed: Option<f64>,
    /// Bits of [`coolant`].
    pub coolant: Option<u8>,
    /// Cutter compensation.
    pub side: Option<Side>,
    /// What F means.
    pub feed_mode: Option<FeedMode>,
    /// F in force: units of length of the program per minute or per revolution, or 1/min.
    pub feed: Option<f64>,
    /// Tip control.
    pub tip_control: TipControl,
    /// Under tip control the tool axis turns in the plane of its ends; otherwise each rotary axis evenly.
    pub in_plane: Option<bool>,
    /// Under tip control tool axes count in the workpiece; otherwise in the machine.
    pub in_workpiece: Option<bool>,
    /// The tool axis as the program says it under tip control, in the place of angles.
    pub vector: Option<Vector3<f64>>,
    /// Tilted plane.
    pub tilt: Option<Tilt>,
    /// G98: cycles go back to the level before them.
    pub to_initial: bool,
    /// Rotary words name the nearest such angle.
    pub shortest: bool,
    /// The program has selected the path of rotary axes (M126, M127).
    pub shortest_stated: bool,
    /// Smoothing of the path.
    pub smoothing: Smoothing,
    /// Largest deviation of the tool axis while smoothing is on, rad.
    pub smoothing_angle_rad: Option<f64>,
    /// Motion from block to block.
    pub path_mode: Option<PathMode>,
    /// Clamped rotary axes: bits by position.
    pub clamped: u16,
    /// Axes of which it is known whether they are clamped: bits by position.
    pub clamps_known: u16,
}

impl Default for State {
    fn default() -> Self {
        Self {
            tool: None,
            selected: None,
            length: None,
            diameter: None,
            work_offset: None,
            units: None,
            incremental: None,
            plane: None,
            spindle: None,
            speed: None,
            coolant: None,
            side: None,
            feed_mode: None,
            feed: None,
            tip_control: TipControl::Off,
            in_plane: None,
            in_workpiece: None,
            vector: None,
            tilt: None,
            to_initial: true,
            shortest: false,
            shortest_stated: false,
            smoothing: Smoothing::Off,
            smoothing_angle_rad: None,
            path_mode: None,
            clamped: 0,
            clamps_known: 0,
        }
    }
}

/// A circle or a helix in the plane of the state.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ArcMove {
    /// Of X Y Z; the component along the normal means nothing, mm.
    pub centre: [f64; 3],
    /// Angle, + counter-clockwise about the normal of the plane, rad; never 0.
    pub sweep: f64,
    /// The angle is what the block says, and its end follows.
    pub by_angle: bool,
}

/// How a cycle makes a hole.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum CycleKind {
    /// G81, G82: in at feed, out at rapid.
    Drill,
    /// G85, G89: in and out at feed.
    Ream,
    /// G83: out to the reference level after each step, mm.
    Peck(f64),
    /// G73: back a little after each step, mm.
    ChipBreak(f64),
    /// G84: a thread, mm per turn, + right-hand; synchronised.
    Tap(f64),
    /// The same, not synchronised: the pitch is that of F and S.
    FloatingTap(f64),
    /// G86, G76: in at feed, out with the spindle still or turned.
    Bore,
}

impl fmt::Display for CycleKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Drill => f.write_str("a drilled hole"),
            Self::Ream => f.write_str("a reamed hole"),
            Self::Bore => f.write_str("a bored hole"),
            Self::Peck(step) => write!(f, "a peck-drilled hole, full retract after each {step} mm"),
            Self::ChipBreak(step) => write!(f, "a peck-drilled hole, chip break after each {step} mm"),
            Self::Tap(pitch) if *pitch < 0.0 => write!(f, "a left-hand thread with a pitch of {} mm", -pitch),
            Self::Tap(pitch) => write!(f, "a thread with a pitch of {pitch} mm"),
            Self::FloatingTap(pitch) if *pitch < 0.0 => {
                write!(f, "a left-hand thread with a pitch of {} mm, not in step with the spindle", -pitch)
            }
            Self::FloatingTap(pitch) => {
                write!(f, "a thread with a pitch of {pitch} mm, not in step with the spindle")
            }
        }
    }
}

/// One hole of a cycle; levels count along the normal of the plane as program words do, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CycleMove {
    /// How.
    pub kind: CycleKind,
    /// Where the tool comes down to at rapid.
    pub reference: f64,
    /// Bottom.
    pub bottom: f64,
    /// Where it stands afterwards.
    pub back_to: f64,
    /// Wait at the bottom, seconds.
    pub dwell: f64,
    /// A feed of its own, as the F of the state is counted.
    pub feed: Option<f64>,
    /// Retract that breaks the chip, or distance above the last depth to which the tool returns at rapid, mm, where the
    /// program states it.
    pub gap: Option<f64>,
}

impl CycleMove {
    /// Whether the tool moves out of the hole at feed.
    #[must_use]
    pub const fn retracts_at_feed(&self) -> bool {
        matches!(self.kind, CycleKind::Ream | CycleKind::Tap(_) | CycleKind::FloatingTap(_))
    }
}

/// What a block does.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Action {
    /// State, comments, frame.
    Nothing,
    /// Axes go to their values, each as fast as it can.
    Rapid,
    /// Axes go to their values together.
    Feed,
    /// An arc in the plane of the state.
    Arc(ArcMove),
    /// A hole.
    Cycle(CycleMove),
    /// At rapid to machine coordinates; where the axes stand in the program is not known behind it.
    Machine,
    /// To the reference position of the axes of `written`, through the point of `values`; as above.
    Reference,
    /// A code that turns the rotary axes into the tilted plane, or to 0 at its end.
    Orient,
    /// A wait, seconds.
    Dwell(f64),
    /// A tool change.
    ToolChange,
    /// M0.
    Stop,
    /// M1.
    OptionalStop,
    /// M2, M30.
    End,
}

impl Action {
    /// Whether an axis moves.
    #[must_use]
    pub const fn moves(&self) -> bool {
        matches!(
            self,
            Self::Rapid | Self::Feed | Self::Arc(_) | Self::Cycle(_) | Self::Machine | Self::Reference | Self::Orient
        )
    }
}

/// What a control would stumble over.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Fault {
    /// Column from 1, bytes.
    pub column: usize,
    /// One sentence, no final stop.
    pub text: String,
}

/// What one line of a program does.
#[derive(Debug, Clone, PartialEq)]
pub struct Block {
    /// Line, from 1.
    pub line: u64,
    /// Block number.
    pub number: Option<u64>,
    /// What it does.
    pub action: Action,
    /// The state in which it does so.
    pub state: State,
    /// Value of each axis behind the block, as written: no offsets. mm and rad.
    pub values: [f64; MAX_AXES],
    /// Axes whose value is known: bits by position.
    pub known: u16,
    /// Axes whose words stand in the block.
    pub written: u16,
    /// A complete state begins here: the block names the unit, or what stands for it.
    pub restart: bool,
    /// Bits of [`stated`].
    pub stated: u8,
    /// A length guard that ends with this block.
    pub guard: Option<Guard>,
    /// The block is a line that the user brought in.
    pub own: Option<OwnLine>,
    /// What is wrong with it.
    pub faults: Vec<Fault>,
}

impl Default for Block {
    fn default() -> Self {
        Self {
            line: 0,
            number: None,
            action: Action::Nothing,
            state: State::default(),
            values: [0.0; MAX_AXES],
            known: 0,
            written: 0,
            restart: false,
            stated: 0,
            guard: None,
            own: None,
            faults: Vec::new(),
        }
    }
}
