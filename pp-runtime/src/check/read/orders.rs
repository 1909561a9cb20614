//! Orders of one block, in typed form.
//!
//! The families make them of their text, and `machine` executes each once: first the modes, in the order of
//! [`Mode::stage`], then the acts, in that of [`Act::stage`], and last the functions that act after a motion.

use nalgebra::{Matrix3, Vector3};

use super::block::{
    BlankPart, BlockFault, CycleKind, FeedMode, FineBore, Guard, PathMode, PathSmoothing, RotaryGuard, SideOfPath,
    WorkOffset, WorkPlane, settled,
};
use super::state::MAX_AXES;
use crate::program::{Rotation, Units};

/// Declared effects of lines of the user, as bits.
pub(super) mod effect {
    pub(in super::super) const COOLANT: u8 = 1;
    pub(in super::super) const SPINDLE: u8 = 2;
    pub(in super::super) const POSITION: u8 = 4;
    pub(in super::super) const STOP: u8 = 8;
    pub(in super::super) const STATE: u8 = 16;
    /// Modes and work offset, by blocks that measure a tool or look for its breakage.
    pub(in super::super) const MODES: u8 = 32;
    /// None of the state: retract and spindle off are required before it.
    pub(in super::super) const STANDSTILL: u8 = 64;
}

/// A motion code.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Code {
    Rapid,
    Feed,
    Clockwise,
    CounterClockwise,
    /// The canned cycle in force, at each point from here on.
    Cycle,
    /// G33.1: in step with the spindle to a point and back.
    RigidTap,
    /// G80.
    None,
}

/// A code of length compensation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum LengthCode {
    Off,
    /// With the register of the block.
    On,
    /// Tip control with the register of the block.
    TipControl,
    /// Tip control with the register of the block, I J K being the tool axis.
    TipVector,
}

/// A tilted plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum TiltCode {
    Off,
    On {
        rotation: Matrix3<f64>,
        /// In the unit of the program.
        origin: Vector3<f64>,
        oriented: bool,
        pose: Option<bool>,
        rotates_table: bool,
    },
    /// The rotary axes follow.
    Orient,
    /// Off, and the rotary axes go to 0.
    Zero,
}

/// A defined cycle, mm, rad, seconds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Cycle {
    pub(crate) kind: CycleKind,
    pub(crate) reference: f64,
    pub(crate) bottom: f64,
    /// `None`: by G98 and G99.
    pub(crate) back_to: Option<f64>,
    pub(crate) dwell: f64,
    /// A feed of its own, as F is written.
    pub(crate) feed: Option<f64>,
    pub(crate) gap: Option<f64>,
}

impl Cycle {
    /// Its lengths times the unit in which they are written, mm.
    pub(super) fn in_unit(self, unit: f64) -> Self {
        let kind = match self.kind {
            CycleKind::Peck(step) => CycleKind::Peck(step * unit),
            CycleKind::ChipBreak(step) => CycleKind::ChipBreak(step * unit),
            CycleKind::Tap(pitch) => CycleKind::Tap(pitch * unit),
            CycleKind::FloatingTap(pitch) => CycleKind::FloatingTap(pitch * unit),
            CycleKind::FineBore(bore) => {
                CycleKind::FineBore(FineBore { shift_mm: bore.shift_mm.map(|shift| shift * unit), ..bore })
            }
            kind => kind,
        };
        let back_to = self.back_to.map(|level| level * unit);
        let gap = self.gap.map(|gap| gap * unit);
        Self { kind, reference: self.reference * unit, bottom: self.bottom * unit, back_to, gap, ..self }
    }
}

/// Words of a canned cycle in one block: lengths in the unit of the program, seconds.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct CannedWords {
    /// The cycle that begins here.
    pub(crate) begins: Option<Pattern>,
    /// R.
    pub(crate) reference: Option<f64>,
    /// Q.
    pub(crate) step: Option<f64>,
    /// P.
    pub(crate) dwell: Option<f64>,
    /// I and J, which shift a tool off the wall of a bore.
    pub(crate) shift: Option<[f64; 2]>,
}

/// A mode, or a function that moves nothing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum ModeOrder {
    /// A complete state begins.
    Restart,
    Units(Units),
    FeedMode(FeedMode),
    /// As written.
    Feed(f64),
    Speed(f64),
    /// Called up for the next change.
    Tool(u32),
    RadiusRegister(u32),
    Plane(WorkPlane),
    Side(SideOfPath),
    Incremental(bool),
    /// I J K of arcs are absolute.
    AbsoluteCentres(bool),
    /// Ends what a program before may have left, and changes nothing else: bit of `settled`.
    Settles(u32),
    ReturnToInitial(bool),
    Shortest(bool),
    /// The code may cancel the work offset; whether tip control is off afterwards.
    CancelsOffset {
        off: bool,
    },
    WorkOffset(WorkOffset),
    Path(PathMode),
    /// With its tolerance for rotary axes, rad.
    Smoothing(PathSmoothing, Option<f64>),
    Clamp {
        axis: usize,
        on: bool,
    },
    /// The selected tool comes into the spindle.
    Change,
    /// DR, mm; `None` where a call without a tool number states none.
    RadiusDelta(Option<f64>),
    Spindle(Option<Rotation>),
    CoolantOff(u8),
    CoolantOn(u8),
    Length(LengthCode, Option<u32>),
    /// The tool's own row gives its length.
    LengthOfTool,
    DynamicOffset(bool),
    TipControl(bool),
    /// Under tip control the tool axis rotates in a plane.
    InPlane(bool),
    InWorkpiece(bool),
    /// Components of the tool axis, and the bits of those that are written.
    Vector([f64; 3], u8),
    Tilt(TiltCode),
    /// A motion code, and the letters that it takes.
    Motion(Code, Letters),
    Define(Cycle),
    /// MCALL.
    CallAtEachPoint(Option<Cycle>),
    /// M29.
    Rigid,
    Canned(CannedWords),
    Guard(Guard),
    /// Largest radius, mm.
    RadiusGuard(f64),
    PlaneGuard(RotaryGuard),
    /// Nothing lies over the work offset.
    OffsetGuard,
    Blank(BlankPart),
}

impl ModeOrder {
    /// Place in the order of execution.
    fn stage(&self) -> u8 {
        match self {
            Self::Restart | Self::Units(_) => 0,
            Self::FeedMode(_) => 1,
            Self::Feed(_) | Self::Speed(_) => 2,
            Self::Tool(_) | Self::RadiusRegister(_) | Self::Plane(_) | Self::Side(_) => 3,
            Self::Incremental(_)
            | Self::AbsoluteCentres(_)
            | Self::Settles(_)
            | Self::ReturnToInitial(_)
            | Self::Shortest(_)
            | Self::CancelsOffset { .. } => 3,
            Self::WorkOffset(_) => 4,
            Self::Path(_) | Self::Smoothing(..) | Self::Clamp { .. } => 5,
            Self::Change => 6,
            Self::RadiusDelta(_) | Self::Spindle(_) | Self::CoolantOff(_) => 7,
            Self::CoolantOn(_) => 8,
            Self::Length(..) | Self::LengthOfTool => 9,
            Self::DynamicOffset(_) => 10,
            Self::TipControl(_) => 11,
            Self::InPlane(_) | Self::InWorkpiece(_) | Self::Vector(..) => 12,
            Self::Tilt(_) => 13,
            Self::Motion(..) | Self::Rigid => 14,
            Self::Define(_) | Self::CallAtEachPoint(_) | Self::Canned(_) => 15,
            Self::Guard(_) | Self::RadiusGuard(_) | Self::PlaneGuard(_) | Self::OffsetGuard | Self::Blank(_) => 16,
        }
    }

    /// What of a program before it ends or replaces: bits of [`settled`].
    pub(super) fn settles(&self) -> u32 {
        match self {
            Self::Side(_) => settled::SIDE,
            Self::Length(..) | Self::LengthOfTool => settled::LENGTH,
            Self::TipControl(_) => settled::TIP_CONTROL,
            Self::DynamicOffset(_) => settled::DYNAMIC_OFFSET,
            Self::Tilt(TiltCode::Off | TiltCode::Zero | TiltCode::On { .. }) => settled::PLANE,
            Self::Smoothing(..) => settled::SMOOTHING,
            Self::Path(_) => settled::PATH,
            Self::Incremental(_) => settled::DISTANCES,
            Self::Plane(_) => settled::WORKING_PLANE,
            Self::FeedMode(_) => settled::FEED_MODE,
            Self::AbsoluteCentres(_) => settled::CENTRES,
            Self::Settles(bits) => *bits,
            _ => 0,
        }
    }

    /// Whether the block says nothing but F by it.
    fn is_feed(&self) -> bool {
        matches!(self, Self::Feed(_))
    }
}

/// Words of axes, as written.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct WrittenAxisWords {
    pub(crate) values: [f64; MAX_AXES],
    /// Bits.
    pub(crate) written: u16,
    /// Words that are distances, and words that are places, whatever is in force: bits.
    pub(crate) incremental: u16,
    pub(crate) absolute: u16,
}

/// Words of an arc, as written; angles in rad.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct ArcWords {
    /// I J K.
    pub(crate) centre: [f64; 3],
    pub(crate) written: u8,
    pub(crate) absolute: u8,
    pub(crate) radius: Option<f64>,
    /// Angle of a polar arc, + counter-clockwise.
    pub(crate) sweep: Option<f64>,
    /// More whole turns of a helix.
    pub(crate) turns: u32,
}

/// A motion by the motion code in force.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct MotionOrder {
    pub(crate) axes: WrittenAxisWords,
    pub(crate) arc: ArcWords,
    /// K of G33.1.
    pub(crate) pitch: Option<f64>,
    /// The defined cycle is run where the motion ends.
    pub(crate) call: bool,
}

/// One of the things that a block does, of which the control does one after the other.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Act {
    ToolChange,
    /// Seconds.
    Dwell(f64),
    /// G28, G30.
    Reference(WrittenAxisWords),
    /// G53, SUPA, M91.
    Machine(WrittenAxisWords),
    /// M140 MB MAX.
    EndOfTravel,
    Move(MotionOrder),
    /// A cycle where the tool is.
    Hole,
    /// The rotary axes go to a tilted plane, or to 0 at its end.
    Orient,
    Stop {
        optional: bool,
    },
    End,
}

impl Act {
    /// Place in the order of execution.
    fn stage(&self) -> u8 {
        match self {
            Self::ToolChange => 0,
            Self::Dwell(_) => 1,
            Self::Orient => 2,
            Self::Reference(_) | Self::Machine(_) | Self::EndOfTravel | Self::Move(_) => 3,
            Self::Hole => 4,
            Self::Stop { .. } => 5,
            Self::End => 6,
        }
    }
}

/// When a function acts in a block that moves.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Order {
    Before,
    After,
    /// The machine builder decides.
    Either,
}

/// What a block orders.
#[derive(Debug, Clone, Default)]
pub(super) struct Orders {
    pub(crate) number: Option<u64>,
    /// Executed before the acts.
    pub(crate) modes: Vec<ModeOrder>,
    /// Executed before the acts on one machine and after them on another.
    pub(crate) either: Vec<ModeOrder>,
    /// Executed after the acts.
    pub(crate) late: Vec<ModeOrder>,
    pub(crate) acts: Vec<Act>,
    /// Faults of the frame of the line, as of its number: nothing that its text does takes them away.
    pub(crate) frame_faults: usize,
    /// Bits of [`effect`].
    pub(crate) effects: u8,
    /// It says something, if only a code that changes nothing.
    pub(crate) speaks: bool,
    /// The control executes the blocks before it first.
    pub(crate) stops_look_ahead: bool,
    /// It has a code that changes nothing here.
    pub(crate) harmless: bool,
    /// It has what is not in the language.
    pub(crate) unknown: bool,
}

impl Orders {
    /// Forgets the block.
    pub(super) fn clear(&mut self) {
        self.forget_codes();
        (self.number, self.frame_faults) = (None, 0);
    }

    /// Forgets everything but the block number.
    pub(super) fn forget_codes(&mut self) {
        self.modes.clear();
        self.either.clear();
        self.late.clear();
        self.acts.clear();
        (self.effects, self.speaks, self.stops_look_ahead) = (0, false, false);
        (self.harmless, self.unknown) = (false, false);
    }

    /// Adds a mode that is executed before the motion of its block.
    pub(super) fn mode(&mut self, mode: ModeOrder) {
        self.function(mode, Order::Before);
    }

    /// Adds a mode or a function.
    pub(super) fn function(&mut self, mode: ModeOrder, order: Order) {
        self.speaks = true;
        let list = match order {
            Order::Before => &mut self.modes,
            Order::After => &mut self.late,
            Order::Either => &mut self.either,
        };
        let at = list.partition_point(|other| other.stage() <= mode.stage());
        list.insert(at, mode);
    }

    /// A cycle that runs at the end of the block may come before its functions there or after them.
    pub(super) fn late_in_either_order(&mut self) {
        for mode in std::mem::take(&mut self.late) {
            self.function(mode, Order::Either);
        }
    }

    /// Adds an act.
    pub(super) fn act(&mut self, act: Act) {
        self.speaks = true;
        let at = self.acts.partition_point(|other| other.stage() <= act.stage());
        self.acts.insert(at, act);
    }

    /// All modes and functions.
    pub(super) fn all_modes(&self) -> impl Iterator<Item = &ModeOrder> {
        self.modes.iter().chain(&self.either).chain(&self.late)
    }

    /// Whether one of its modes suits.
    pub(super) fn has(&self, suits: impl Fn(&ModeOrder) -> bool) -> bool {
        self.all_modes().any(suits)
    }

    /// What one of its modes says.
    pub(super) fn find<T>(&self, says: impl FnMut(&ModeOrder) -> Option<T>) -> Option<T> {
        self.all_modes().find_map(says)
    }

    /// Takes away modes.
    pub(super) fn remove(&mut self, is: impl Fn(&ModeOrder) -> bool) {
        for list in [&mut self.modes, &mut self.either, &mut self.late] {
            list.retain(|mode| !is(mode));
        }
    }

    /// The unit that it names.
    pub(super) fn units(&self) -> Option<Units> {
        self.find(|mode| if let ModeOrder::Units(units) = mode { Some(*units) } else { None })
    }

    /// Whether it has words of axes.
    pub(super) fn moves_axes(&self) -> bool {
        self.acts.iter().any(|act| match act {
            Act::Move(motion) => motion.axes.written != 0,
            Act::Machine(words) | Act::Reference(words) => words.written != 0,
            _ => false,
        })
    }

    /// Whether it stops the program.
    pub(super) fn stops(&self) -> bool {
        self.acts.iter().any(|act| matches!(act, Act::Stop { .. }))
    }

    /// Whether it moves axes and changes no state but F, nor has a declared effect.
    pub(super) fn only_moves(&self) -> bool {
        matches!(self.acts[..], [Act::Move(MotionOrder { call: false, .. })])
            && self.modes.iter().all(ModeOrder::is_feed)
            && self.either.is_empty()
            && self.late.is_empty()
            && self.effects == 0
    }
}

/// Most faults reported per line.
const MOST_FAULTS: usize = 20;

/// Adds a fault of a line.
pub(super) fn fault(faults: &mut Vec<BlockFault>, column: usize, text: impl Into<String>) {
    if faults.len() < MOST_FAULTS {
        faults.push(BlockFault { column: column + 1, text: text.into() });
    }
}

/// How a canned cycle makes its hole.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in super::super) enum Pattern {
    Drill,
    Ream,
    Peck,
    ChipBreak,
    /// In step with the spindle.
    Tap {
        left: bool,
    },
    /// In step with the spindle after M29 only.
    TapAfterRigid {
        left: bool,
    },
    /// Never in step with the spindle.
    FloatingTap {
        left: bool,
    },
    Bore,
    /// The spindle stops at an angle, and the tool leaves the wall.
    FineBore,
}

/// Letters A to Z as bits.
pub(super) type Letters = u32;
