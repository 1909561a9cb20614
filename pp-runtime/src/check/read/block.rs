//! What a reader makes of a program: one [`Block`] after the other, each with the state in which it acts.
//!
//! Lengths are mm and angles rad, whatever the unit of the program; levels and centres count as the words of the
//! program do. Nothing in here knows a machine or CL data.

use super::state::MAX_AXES;
use crate::program::{Rotation, Units};

pub(super) use super::state::settled;
pub use super::state::{FeedMode, Length, SideOfPath, State, TipControl, WorkOffset, WorkPlane, coolant};
pub(crate) use super::state::{PathMode, PathSmoothing, Tilt, stated};

/// Positions of the axes whose bits are set.
pub(crate) fn set_bits(bits: u16) -> impl Iterator<Item = usize> {
    let mut rest = bits;
    std::iter::from_fn(move || {
        let index = rest.trailing_zeros() as usize;
        rest &= rest.wrapping_sub(1);
        (index < MAX_AXES).then_some(index)
    })
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

/// A guard of rotary positions: the program stops where the sum of |sin(d/2)| over the differences d of its axes is
/// larger.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct RotaryGuard {
    /// Axis by its position in the chain, and the position with which it compares, rad.
    pub positions: [Option<(usize, f64)>; 2],
    /// Largest permitted sum.
    pub largest: f64,
}

impl RotaryGuard {
    /// Adds an axis; `None` if it is there, or if there are two.
    pub(crate) fn compare(&mut self, axis: usize, position_rad: f64) -> Option<()> {
        let other = |position: &Option<(usize, f64)>| position.is_none_or(|(known, _)| known != axis);
        let free = self.positions.iter().all(other).then(|| self.positions.iter_mut().find(|at| at.is_none()))??;
        *free = Some((axis, position_rad));
        Some(())
    }
}

/// Declared effect of a line or a word of the user.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Effect {
    /// Nothing that the check reads.
    None,
    /// It clamps work or sets it free: the machine has retracted before it, and the spindle is off.
    Clamp,
    /// It opens or closes a chuck.
    Chuck,
    /// It opens or closes a door.
    Door,
    /// It changes a pallet: positions are unknown afterwards.
    Pallet,
    /// The coolant is unknown afterwards.
    Coolant,
    /// The spindle is unknown afterwards.
    Spindle,
    /// It measures: positions are unknown afterwards.
    Measures,
    /// Positions are unknown afterwards.
    PositionLost,
    /// The tool of its field `{tool}` is in the spindle afterwards, as after the tool change of the control.
    ToolChange,
    /// The program stops.
    Stop,
    /// Positions and modal state are unknown afterwards.
    StateLost,
}

impl Effect {
    /// All, with their names in a configuration.
    pub(crate) const NAMES: [(&'static str, Self); 12] = [
        ("none", Self::None),
        ("clamp", Self::Clamp),
        ("chuck", Self::Chuck),
        ("door", Self::Door),
        ("pallet", Self::Pallet),
        ("coolant", Self::Coolant),
        ("spindle", Self::Spindle),
        ("stop", Self::Stop),
        ("position lost", Self::PositionLost),
        ("state lost", Self::StateLost),
        ("measures", Self::Measures),
        ("tool change", Self::ToolChange),
    ];
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
    /// `control.mill_turn`: words of X as radii, C as an axis, the tool driven.
    MillTurn,
    /// Code of the spindle of the tool, where it is not that of the control.
    Spindle {
        /// Its sense; `None`: off.
        rotation: Option<Rotation>,
    },
    /// `control.tool_change`.
    ToolChange,
    /// `program.operation_start`.
    OperationStart,
    /// `program.operation_end`.
    OperationEnd,
    /// `retract.method`.
    Retract {
        /// Position in the list, from 0.
        index: usize,
    },
    /// `cycles.measure_tool`.
    MeasureTool,
    /// `cycles.check_tool`.
    CheckTool,
    /// `start` of a tool.
    ToolStart {
        /// Its number.
        tool: u32,
    },
    /// `end` of a tool.
    ToolEnd {
        /// Its number.
        tool: u32,
    },
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
    /// Text of INSERT, AUXFUN, PREFUN, or of a statement of the shop.
    Insert,
    /// Such a text with a code that is declared "none" and not confirmed to be harmless.
    Unconfirmed,
}

impl OwnPlace {
    /// Key of lines that have their place in the program; `None` where records or the planner decide when they come.
    #[must_use]
    pub fn key(self) -> Option<&'static str> {
        Some(match self {
            Self::Start => "program.start",
            Self::End => "program.end",
            Self::Safety => "control.safety",
            Self::MillTurn => "control.mill_turn",
            Self::ToolChange => "control.tool_change",
            Self::OperationStart => "program.operation_start",
            Self::OperationEnd => "program.operation_end",
            Self::MeasureTool => "cycles.measure_tool",
            Self::CheckTool => "cycles.check_tool",
            Self::ToolStart { .. } => "tools.N.start",
            Self::ToolEnd { .. } => "tools.N.end",
            Self::Retract { .. }
            | Self::Clamp { .. }
            | Self::Coolant
            | Self::Spindle { .. }
            | Self::TipControl { .. }
            | Self::Insert
            | Self::Unconfirmed => {
                return None;
            }
        })
    }
}

/// A line that the user brought in, executed by its declared effect or by that of its key.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct OwnLine {
    /// Where the configuration has it.
    pub places: Vec<OwnPlace>,
    /// Strongest effect that `[control] effects` declares for it.
    pub effect: Option<Effect>,
    /// Before it the machine retracts and the spindle stops: one of its effects is that of a clamp, a chuck, a door or
    /// a pallet.
    pub needs_standstill: bool,
    /// Values of its fields.
    pub values: OwnValues,
}

/// Values of the fields of a line that the user brought in, where it has them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct OwnValues {
    /// `{tool}`.
    pub tool: Option<u32>,
    /// `{offset}`.
    pub offset: Option<u32>,
}

/// A circle or a helix in the plane of the state.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ArcMove {
    /// Of X Y Z; the component along the normal means nothing, mm.
    pub centre: [f64; 3],
    /// Angle, + counter-clockwise about the normal of the plane, rad; 0 only counter-clockwise, where start and
    /// end are in one direction from a centre that is not quite as far from both.
    pub sweep: f64,
    /// The angle is what the block says, and its end follows.
    pub by_angle: bool,
}

/// Part of the definition of the blank for the graphics of the control, in the unit of the program.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum BlankPart {
    /// Lower corner of a box.
    Lower([f64; 3]),
    /// Upper corner of a box.
    Upper([f64; 3]),
    /// Corners of a box, or of the box around a cylinder along Z.
    Whole {
        /// Lower corner.
        lower: [f64; 3],
        /// Upper corner.
        upper: [f64; 3],
        /// It is a cylinder.
        round: bool,
    },
}

impl BlankPart {
    /// A cylinder about X0 Y0.
    pub(super) fn cylinder(radius: f64, bottom: f64, top: f64) -> Self {
        Self::Whole { lower: [-radius, -radius, bottom], upper: [radius, radius, top], round: true }
    }
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
    /// G84, not synchronised: the pitch is that of F and S.
    FloatingTap(f64),
    /// G86: in at feed, out with the spindle off.
    Bore,
    /// G76, CYCLE86, cycle 202: in at feed, spindle stopped at an angle, off the wall, out at rapid.
    FineBore(FineBore),
}

/// Retract of a tool from the wall of a bore, as far as the program states it.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct FineBore {
    /// Distance, mm.
    pub shift_mm: Option<f64>,
    /// Direction along X and Y, of length 1; 0, 0 if there is no shift.
    pub direction: Option<[f64; 2]>,
    /// Angle at which the spindle stops, degrees.
    pub angle_deg: Option<f64>,
}

impl FineBore {
    /// By a shift along X and Y, mm.
    pub(super) fn by_shift(shift: [f64; 2], angle_deg: Option<f64>) -> Self {
        let length = shift[0].hypot(shift[1]);
        let direction = shift.map(|part| if length > 0.0 { part / length } else { 0.0 });
        Self { shift_mm: Some(length), direction: Some(direction), angle_deg }
    }
}

impl CycleKind {
    /// The kind in words, with lengths in the unit of the program.
    pub(crate) fn text(&self, units: Units) -> String {
        let thread = |pitch: f64, floats: bool| {
            let hand = if pitch < 0.0 { "a left-hand thread" } else { "a thread" };
            let floats = if floats { ", not in step with the spindle" } else { "" };
            format!("{hand} with a pitch of {}{floats}", units.length(pitch.abs()))
        };
        match self {
            Self::Drill => "a drilled hole".to_owned(),
            Self::Ream => "a reamed hole".to_owned(),
            Self::Bore => "a bored hole".to_owned(),
            Self::FineBore(_) => "a bore with the spindle stopped at an angle".to_owned(),
            Self::Peck(step) => format!("a peck-drilled hole, full retract after each {}", units.length(*step)),
            Self::ChipBreak(step) => format!("a peck-drilled hole, chip break after each {}", units.length(*step)),
            Self::Tap(pitch) => thread(*pitch, false),
            Self::FloatingTap(pitch) => thread(*pitch, true),
        }
    }
}

/// One hole of a cycle; levels count along the normal of the plane as program words do, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CycleMove {
    /// How.
    pub kind: CycleKind,
    /// Where the motion of the block ends before it, if that is known: the tool comes over the hole there.
    pub over: Option<f64>,
    /// Where the tool comes down to at rapid.
    pub reference: f64,
    /// Bottom.
    pub bottom: f64,
    /// Its position afterwards.
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
///
/// The kind has a byte of its own, so that it is found by one comparison.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(u8)]
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
    Reference {
        /// That point is where they are: every word is a distance of 0.
        direct: bool,
    },
    /// The axis of `written` along the tool axis to the end of its travel; as above.
    EndOfTravel,
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
    /// Whether a thread is cut in step with the spindle.
    #[must_use]
    pub const fn is_rigid_thread(&self) -> bool {
        matches!(self, Self::Cycle(CycleMove { kind: CycleKind::Tap(_), .. }))
    }

    /// Whether a thread is cut.
    #[must_use]
    pub const fn is_thread(&self) -> bool {
        matches!(self, Self::Cycle(CycleMove { kind: CycleKind::Tap(_) | CycleKind::FloatingTap(_), .. }))
    }

    /// Whether the axes go to their values, each as fast as it can.
    #[must_use]
    pub const fn is_rapid(&self) -> bool {
        matches!(self, Self::Rapid)
    }

    /// Whether the axes go to their values together.
    #[must_use]
    pub const fn is_feed(&self) -> bool {
        matches!(self, Self::Feed)
    }

    /// Whether an axis moves.
    #[must_use]
    pub const fn moves(&self) -> bool {
        matches!(
            self,
            Self::Rapid
                | Self::Feed
                | Self::Arc(_)
                | Self::Cycle(_)
                | Self::Machine
                | Self::Reference { .. }
                | Self::EndOfTravel
                | Self::Orient
        )
    }

    /// Whether axes move to positions of the machine: their words are unknown afterwards.
    #[must_use]
    pub const fn leaves_words(&self) -> bool {
        matches!(self, Self::Machine | Self::Reference { .. } | Self::EndOfTravel)
    }

    /// Whether the tool moves at feed.
    #[must_use]
    pub const fn cuts(&self) -> bool {
        matches!(self, Self::Feed | Self::Arc(_) | Self::Cycle(_))
    }
}

/// What a control would stumble over.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct BlockFault {
    /// Column from 1, bytes.
    pub column: usize,
    /// One sentence, no final stop.
    pub text: String,
}

/// Guards that end with a block: each compares the control with what was posted, and stops the program where they
/// differ.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct EndedGuards {
    /// Of the tool length.
    pub length: Option<Guard>,
    /// Of the radius of the active edge: the largest one that it allows, mm.
    pub radius_mm: Option<f64>,
    /// Of the rotary positions.
    pub plane: Option<RotaryGuard>,
    /// Of what lies over the work offset: shifts that last, rotation, scale, mirror.
    pub offset: bool,
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
    /// That on a machine whose builder lets the functions of the block act after its motion, where it is another.
    pub early: Option<Box<State>>,
    /// It is a further act of the line of the block before.
    pub goes_on: bool,
    /// Value of each axis after the block, as written: no offsets. mm and rad.
    pub values: [f64; MAX_AXES],
    /// Axes whose value is known: bits by position.
    pub known: u16,
    /// Axes whose value before the block is known, and has had its present meaning since it was programmed: bits.
    pub known_before: u16,
    /// Axes whose words stand in the block.
    pub written: u16,
    /// Blocks that the look-ahead of the control takes it for where it moves nothing: none is a comment alone, and what
    /// stops the look-ahead ends it.
    pub looked_over: u8,
    /// Its words are those of axes, of the centre of an arc, F and N alone, without a declared effect. All modes are
    /// those of the block before, unless blocks that may be skipped end here.
    pub only_moves: bool,
    /// A complete state begins here: the block names the unit, or a line of the shop takes its place.
    pub restart: bool,
    /// Bits of `stated`.
    pub stated: u8,
    /// Guards that end with it.
    pub guards: EndedGuards,
    /// A part of the definition of the blank.
    pub blank: Option<BlankPart>,
    /// The operator may have it skipped: it begins with the mark of block skip.
    pub skippable: bool,
    /// The block is a line that the user brought in.
    pub own: Option<OwnLine>,
    /// What is wrong with it.
    pub faults: Vec<BlockFault>,
    /// Number of faults, the first ones, that the text of the block does not explain: its number, an incomplete cycle
    /// before it.
    pub frame_faults: usize,
}

impl Block {
    /// Forgets what blocks before it have compared, and said of the blank.
    pub(super) fn forget_guards(&mut self) {
        (self.guards, self.blank) = (EndedGuards::default(), None);
    }
}

impl Default for Block {
    fn default() -> Self {
        Self {
            line: 0,
            number: None,
            action: Action::Nothing,
            state: State::default(),
            early: None,
            goes_on: false,
            values: [0.0; MAX_AXES],
            known: 0,
            known_before: 0,
            written: 0,
            looked_over: 0,
            only_moves: false,
            restart: false,
            stated: 0,
            guards: EndedGuards::default(),
            blank: None,
            skippable: false,
            own: None,
            faults: Vec::new(),
            frame_faults: 0,
        }
    }
}
