//! The words of one block, before anything is done with them.
//!
//! Each family of controls fills a draft from its own text; what the words bring about is said once, in `machine`.

use nalgebra::{Matrix3, Vector3};

use super::block::{
    BlankPart, CycleKind, Fault, FeedMode, FineBore, Guard, MAX_AXES, PathMode, RotaryGuard, Side, Smoothing,
    WorkOffset, WorkPlane,
};
use super::language::{PathCode, Pattern, Plane, Smoother, letters};
use crate::program::{Rotation, Units};

/// Groups of codes of which a block may hold one, as bits of a draft.
pub(super) mod group {
    pub(in super::super) const MOTION: u32 = 0;
    pub(in super::super) const PLANE: u32 = 1;
    pub(in super::super) const DISTANCE: u32 = 2;
    pub(in super::super) const FEED: u32 = 3;
    pub(in super::super) const UNITS: u32 = 4;
    pub(in super::super) const SIDE: u32 = 5;
    pub(in super::super) const LENGTH: u32 = 6;
    pub(in super::super) const OFFSET: u32 = 7;
    pub(in super::super) const RETURN: u32 = 8;
    pub(in super::super) const PATH: u32 = 9;
    pub(in super::super) const TILT: u32 = 10;
    pub(in super::super) const ALONE: u32 = 11;
    pub(in super::super) const STOP: u32 = 12;
    pub(in super::super) const SPINDLE: u32 = 13;
    pub(in super::super) const CENTRE: u32 = 14;
    pub(in super::super) const COOLANT: u32 = 16;
    pub(in super::super) const CHANGE: u32 = 17;
    pub(in super::super) const SMOOTHING: u32 = 18;
    pub(in super::super) const RIGID: u32 = 19;
    pub(in super::super) const TIP: u32 = 20;
    pub(in super::super) const WAY: u32 = 21;
    pub(in super::super) const CALL: u32 = 22;
    pub(in super::super) const WINDOW: u32 = 23;
    pub(in super::super) const POSTURE: u32 = 24;
    pub(in super::super) const FRAME: u32 = 25;
    pub(in super::super) const DYNAMIC_OFFSET: u32 = 26;
    /// Any M code.
    pub(in super::super) const MISCELLANEOUS: u32 = 30;
    /// Whatever may stand beside anything.
    pub(in super::super) const FREE: u32 = 31;
}

/// Declared effects of lines of the user, as bits.
pub(super) mod effect {
    pub(in super::super) const COOLANT: u8 = 1;
    pub(in super::super) const SPINDLE: u8 = 2;
    pub(in super::super) const POSITION: u8 = 4;
    pub(in super::super) const STOP: u8 = 8;
    pub(in super::super) const STATE: u8 = 16;
    /// Modes and work offset, by blocks that measure a tool or look for its breakage.
    pub(in super::super) const MODES: u8 = 32;
}

/// A motion code.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Code {
    Rapid,
    Feed,
    Clockwise,
    CounterClockwise,
    /// The cycle of the draft, at each point from here on.
    Cycle,
    /// G33.1: in step with the spindle to a point and back.
    RigidTap,
    /// G80.
    None,
}

/// Length compensation of a block.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum LengthCode {
    Off,
    /// With the register of the block.
    On,
    /// Tip control with the register of the block.
    TipControl,
    /// The same, I J K being the tool axis.
    TipVector,
}

/// A tilted plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum TiltCode {
    Off,
    On {
        rotation: Matrix3<f64>,
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

/// A cycle as it is defined, mm, rad, seconds; levels that are missing stay as they were.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Cycle {
    pub(crate) kind: CycleKind,
    pub(crate) reference: f64,
    pub(crate) bottom: f64,
    /// `None`: as G98 and G99 say.
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

/// Everything that a block says.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Draft {
    pub(crate) number: Option<u64>,
    /// mm and rad, once the unit is known; until then as written.
    pub(crate) axes: [f64; MAX_AXES],
    pub(crate) written: u16,
    /// Words that are distances, and words that are places, whatever is in force.
    pub(crate) incremental: u16,
    pub(crate) absolute: u16,
    /// I J K.
    pub(crate) centre: [f64; 3],
    pub(crate) centre_written: u8,
    pub(crate) centre_absolute: u8,
    /// Components of the tool axis.
    pub(crate) vector: [f64; 3],
    pub(crate) vector_written: u8,
    /// Radius of an arc, R of a cycle.
    pub(crate) radius: Option<f64>,
    /// More whole turns of a helix.
    pub(crate) turns: u32,
    /// Angle of a polar arc, rad, + counter-clockwise.
    pub(crate) sweep: Option<f64>,
    /// As written.
    pub(crate) feed: Option<f64>,
    pub(crate) speed: Option<f64>,
    pub(crate) tool: Option<u32>,
    pub(crate) register: Option<u32>,
    pub(crate) diameter: Option<u32>,
    pub(crate) change: bool,
    /// The tool's own row gives its length, as the call does.
    pub(crate) length_with_tool: bool,
    pub(crate) code: Option<Code>,
    /// A cycle is defined; nothing is drilled by that.
    pub(crate) define: Option<Cycle>,
    /// The cycle defined is run where the block ends.
    pub(crate) call: bool,
    /// A wait, seconds.
    pub(crate) dwell: Option<f64>,
    pub(crate) pitch: Option<f64>,
    pub(crate) machine: bool,
    pub(crate) reference: bool,
    pub(crate) end_of_travel: bool,
    pub(crate) units: Option<Units>,
    pub(crate) distances: Option<bool>,
    pub(crate) plane: Option<WorkPlane>,
    pub(crate) feed_mode: Option<FeedMode>,
    pub(crate) side: Option<Side>,
    pub(crate) length: Option<LengthCode>,
    pub(crate) work_offset: Option<WorkOffset>,
    pub(crate) tip_control: Option<bool>,
    pub(crate) in_plane: Option<bool>,
    pub(crate) in_workpiece: Option<bool>,
    pub(crate) tilt: Option<TiltCode>,
    pub(crate) dynamic_offset: Option<bool>,
    pub(crate) to_initial: Option<bool>,
    pub(crate) shortest: Option<bool>,
    pub(crate) spindle: Option<Option<Rotation>>,
    pub(crate) coolant_on: u8,
    pub(crate) coolant_off: u8,
    pub(crate) stop: Option<bool>,
    pub(crate) end: bool,
    pub(crate) restart: bool,
    pub(crate) guard: Option<Guard>,
    pub(crate) radius_guard_mm: Option<f64>,
    pub(crate) plane_guard: Option<RotaryGuard>,
    pub(crate) blank: Option<BlankPart>,
    /// DR of a tool call; `None` within: not programmed in a call without a tool number.
    pub(crate) radius_delta_mm: Option<Option<f64>>,
    /// Address letters of the block, those that its codes take, and those that they need.
    pub(crate) letters: u32,
    pub(crate) takes: u32,
    pub(crate) needs: u32,
    /// Codes that wait for the words of their block.
    pub(crate) hole: Option<Pattern>,
    pub(crate) dwells: bool,
    pub(crate) offset_with_p: bool,
    pub(crate) plane_form: Option<Plane>,
    pub(crate) path: Option<PathCode>,
    pub(crate) smooths: Option<Smoother>,
    pub(crate) rigid: bool,
    pub(crate) path_mode: Option<PathMode>,
    pub(crate) smoothing: Option<Smoothing>,
    pub(crate) smoothing_angle: Option<f64>,
    /// The code may cancel the work offset.
    pub(crate) offset_lost: bool,
    /// Faults of the frame of the line, as of its number: nothing that its text does takes them away.
    pub(crate) frame_faults: usize,
    /// Bits of [`effect`].
    pub(crate) effects: u8,
    pub(crate) clamp_on: u16,
    pub(crate) clamp_off: u16,
    /// Words of axes and the centre of an arc, F, S and N, and nothing else; or a hole again, by words of axes and N alone. No state
    /// changes but F and S.
    pub(crate) only_moves: bool,
    /// It has nothing else to forget, and no effect is declared for its words.
    pub(crate) is_moves: bool,
    /// Modal groups that have spoken.
    pub(crate) groups: u32,
}

impl Draft {
    /// Forgets the words of a block that moves axes and does nothing else.
    pub(super) fn forget_moves(&mut self) {
        (self.number, self.feed) = (None, None);
        (self.axes, self.written) = ([0.0; MAX_AXES], 0);
        (self.centre, self.centre_written) = ([0.0; 3], 0);
        self.define = None;
    }

    /// Forgets the block. `empty`: a draft without words; most blocks leave few.
    pub(super) fn clear(&mut self, empty: &Self) {
        if self.is_moves {
            self.forget_moves();
            (self.only_moves, self.is_moves, self.groups) = (false, false, 0);
        } else {
            *self = *empty;
        }
    }

    /// Forgets everything but the block number.
    pub(super) fn forget_codes(&mut self) {
        let Self { number, frame_faults, .. } = *self;
        *self = Self { number, frame_faults, ..Self::default() };
    }

    /// Notes that the block says something.
    pub(super) fn speaks(&mut self) {
        self.groups |= 1 << group::FREE;
    }

    /// Whether the block has nothing but codes of a group and their words.
    pub(super) fn is_alone(&self, own: u32) -> bool {
        let words = self.letters & !(self.takes | letters("N"));
        let miscellaneous = u32::from(self.rigid) << group::MISCELLANEOUS;
        self.groups & !(1 << own | 1 << group::FREE | miscellaneous) == 0
            && self.written == 0
            && words == 0
            && self.define.is_none()
    }

    /// Takes the word of an axis; `false` if it stands there already.
    pub(super) fn axis(&mut self, index: usize, value: f64) -> bool {
        let bit = 1 << index;
        let first = self.written & bit == 0;
        self.axes[index] = value;
        self.written |= bit;
        first
    }
}

/// A line with more wrong words than this is told by these.
const MOST_FAULTS: usize = 20;

/// Collects what is wrong with a line.
pub(super) fn fault(faults: &mut Vec<Fault>, column: usize, text: impl Into<String>) {
    if faults.len() < MOST_FAULTS {
        faults.push(Fault { column: column + 1, text: text.into() });
    }
}
