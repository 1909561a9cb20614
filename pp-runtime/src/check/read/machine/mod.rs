//! What the words of a block bring about: the one state machine behind every family of controls.
//!
//! Order of a block: unit, feed, spindle speed, tool, spindle, coolant, plane, compensation, offsets, tilt and tip control,
//! distances, motion, stop; what the user declares of a line comes last. Words become mm and rad here. The position of an axis is
//! known only while nothing has happened that may have moved it or its zero.

mod arc;
mod modes;
mod motion;

use super::super::policy::RolloverRule;
use super::block::{Action, Block, MAX_AXES, State, TipControl, stated};
use super::draft::{Code, Cycle, Draft, LengthCode, TiltCode, effect, fault};
use super::facts::{Facts, Form};
use crate::program::Units;

/// One axis of the machine as the program names it.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct AxisName {
    /// As in the program, upper case.
    pub(crate) name: Vec<u8>,
    pub(crate) rotary: bool,
    pub(crate) rollover: Option<RolloverRule>,
}

/// State and position of a control.
#[derive(Debug, Clone)]
pub(super) struct Interpreter {
    axes: Vec<AxisName>,
    /// Rotary axes: bits by position.
    rotary: u16,
    /// The set-up has rules for rotary axes beyond a revolution.
    has_rollover: bool,
    /// Positions of X Y Z.
    linear: [Option<usize>; 3],
    /// Position of the axis with a name of one letter, A to Z.
    by_letter: [Option<u8>; 26],
    facts: Facts,
    state: State,
    values: [f64; MAX_AXES],
    known: u16,
    /// The motion code in force.
    modal: Option<Code>,
    /// Bits of [`stated`], since a complete state began.
    stated: u8,
    /// The cycle that is defined.
    cycle: Option<Cycle>,
    /// The level before the cycle.
    initial: Option<f64>,
    /// Half a unit of a linear word, mm: how far ends of arcs are rounded.
    rounding: f64,
    frames: Frames,
}

/// Tip control, tilted plane and dynamic work offset, as bits: a line of the user may leave any of them on.
#[derive(Debug, Clone, Copy, Default)]
struct Frames {
    /// Those of which it is unknown whether they are on.
    unknown: u8,
    /// Those that the program has switched on.
    used: u8,
    /// Those that the program has switched on or off, the last time.
    stated: u8,
}

impl Frames {
    const TIP_CONTROL: u8 = 1;
    const PLANE: u8 = 2;
    const DYNAMIC_OFFSET: u8 = 4;

    /// The program has switched one on or off.
    fn programmed(&mut self, frame: u8, on: bool) {
        self.unknown &= !frame;
        self.used |= if on { frame } else { 0 };
        self.stated |= frame;
    }

    /// A line of the user may have switched either.
    fn lose(&mut self) {
        self.unknown = Self::TIP_CONTROL | Self::PLANE | Self::DYNAMIC_OFFSET & self.used;
        self.stated = 0;
    }

    /// A complete state has been programmed: an option that the program does not use is off.
    fn complete(&mut self) {
        self.unknown &= self.used;
    }
}

impl Interpreter {
    pub(super) fn new(axes: Vec<AxisName>, facts: Facts, rounding: f64) -> Self {
        let linear = [b"X", b"Y", b"Z"].map(|name| axes.iter().position(|axis| axis.name == name));
        let by_letter = std::array::from_fn(|letter| {
            let index = axes.iter().position(|axis| axis.name == [b'A' + letter as u8])?;
            u8::try_from(index).ok()
        });
        let rotary = axes.iter().enumerate().filter(|(_, axis)| axis.rotary);
        Self {
            rotary: rotary.fold(0, |bits, (index, _)| bits | 1 << index),
            has_rollover: axes.iter().any(|axis| axis.rollover.is_some()),
            axes,
            linear,
            by_letter,
            facts,
            state: State::default(),
            values: [0.0; MAX_AXES],
            known: 0,
            modal: None,
            stated: 0,
            cycle: None,
            initial: None,
            rounding,
            frames: Frames::default(),
        }
    }

    pub(super) fn facts(&self) -> &Facts {
        &self.facts
    }

    /// What is in force.
    pub(super) fn state(&self) -> &State {
        &self.state
    }

    /// After blocks that were executed or not, `before` being the state before them: what is the same in both cases.
    pub(super) fn join(&mut self, before: &Self) {
        let same = (0..MAX_AXES).filter(|&index| self.values[index].to_bits() == before.values[index].to_bits());
        self.known &= before.known & same.fold(0, |bits, index| bits | 1 << index);
        self.stated &= before.stated;
        if self.modal != before.modal {
            self.modal = None;
        }
        if self.cycle != before.cycle {
            self.cycle = None;
        }
        let (now, then) = (&mut self.state, &before.state);
        self.frames.unknown |= before.frames.unknown;
        self.frames.used |= before.frames.used;
        self.frames.stated &= before.frames.stated;
        if now.tip_control != then.tip_control {
            self.frames.unknown |= Frames::TIP_CONTROL;
            now.tip_control = TipControl::Off;
        }
        if now.tilt != then.tilt {
            self.frames.unknown |= Frames::PLANE;
            now.tilt = None;
        }
        if now.dynamic_offset != then.dynamic_offset {
            self.frames.unknown |= Frames::DYNAMIC_OFFSET;
            now.dynamic_offset = false;
        }
        now.join(then);
    }

    /// Axis by its position in the chain.
    pub(super) fn axis(&self, index: usize) -> &AxisName {
        &self.axes[index]
    }

    /// Position in the chain of an axis, by its name in the program.
    #[inline]
    pub(super) fn axis_named(&self, name: &[u8]) -> Option<usize> {
        if let [letter @ b'A'..=b'Z'] = name {
            return self.by_letter[usize::from(letter - b'A')].map(usize::from);
        }
        self.axes.iter().position(|axis| axis.name == name)
    }

    /// Positions in the chain of X Y Z.
    pub(super) fn linear(&self) -> [Option<usize>; 3] {
        self.linear
    }

    /// Position of an axis, if it is known.
    pub(super) fn at(&self, index: usize) -> Option<f64> {
        (self.known & (1 << index) != 0).then_some(self.values[index])
    }

    /// Unit of lengths in force, mm.
    pub(super) fn unit(&self) -> f64 {
        self.state.units.map_or(1.0, Units::in_mm)
    }

    /// Does what a draft says and leaves it in the block.
    pub(super) fn execute(&mut self, draft: &Draft, block: &mut Block) {
        block.number = draft.number;
        block.written = draft.written;
        block.only_moves = draft.only_moves && draft.speed.is_none() && draft.effects == 0;
        let straight = match self.modal {
            Some(Code::Feed) => Some(Action::Feed),
            Some(Code::Rapid) => Some(Action::Rapid),
            _ => None,
        };
        match straight.filter(|_| self.moves_alone(draft)) {
            Some(action) => self.move_along(action, draft, block),
            None => self.carry_out(draft, block),
        }
        debug_assert!(block.state == self.state, "{:?} {:?}", block.state, self.state);
    }

    /// Whether a draft does nothing but move axes, and where it counts is known: most blocks.
    fn moves_alone(&self, draft: &Draft) -> bool {
        let is_straight = draft.centre_written == 0 && draft.define.is_none();
        draft.is_moves && is_straight && self.frames.unknown == 0 && self.facts.motion_modal
    }

    /// Moves the axes of a draft that does nothing else.
    fn move_along(&mut self, action: Action, draft: &Draft, block: &mut Block) {
        (block.action, block.frame_faults, block.restart) = (action, 0, false);
        (block.guard, block.radius_guard_mm, block.plane_guard, block.blank) = (None, None, None, None);
        (block.known_before, block.stated) = (self.known, self.stated);
        self.set_feed_and_speed(draft);
        let in_plane = self.state.tilt.is_some().then_some((self.values, self.known));
        self.place(draft, false, &mut block.faults);
        if let Some(from) = in_plane {
            self.left_plane(draft.written & self.rotary, from);
        }
        (block.values, block.known) = (self.values, self.known);
        block.state.take_moves(&self.state);
    }

    /// Does whatever a draft says.
    fn carry_out(&mut self, draft: &Draft, block: &mut Block) {
        block.frame_faults = draft.frame_faults;
        block.restart = draft.restart || draft.units.is_some();
        block.guard = draft.guard;
        block.radius_guard_mm = draft.radius_guard_mm;
        block.plane_guard = draft.plane_guard;
        block.blank = draft.blank;
        block.action = Action::Nothing;
        if draft.only_moves {
            self.set_feed_and_speed(draft);
        } else if draft.groups != 0 || draft.written != 0 || draft.vector_written != 0 {
            self.set_state(draft, &mut block.faults);
        }
        block.known_before = self.known;
        if !draft.only_moves {
            self.state_bits(draft, block.restart);
        }
        block.stated = self.stated;
        self.act(draft, block);
        leftovers(draft, block);
        if self.frames.unknown != 0 {
            self.in_unknown_frame(block);
        }
        if self.facts.stops_spindle(&block.action) {
            self.stated &= !stated::SPINDLE;
            block.stated = self.stated;
        }
        self.suffer(draft.effects, block);
        block.values = self.act_values(block);
        block.known = self.known;
        // The block has the state of the block before.
        if draft.only_moves && draft.effects == 0 {
            block.state.take_moves(&self.state);
        } else {
            block.state = self.state;
        }
    }

    /// Notes what a block says in so many words.
    fn state_bits(&mut self, draft: &Draft, restart: bool) {
        if restart {
            self.stated = 0;
        }
        let modes = draft.units.is_some()
            && draft.plane.is_some()
            && draft.distances.is_some()
            && draft.side.is_some()
            && draft.feed_mode.is_some();
        if modes && self.facts.frames_are_options {
            self.frames.complete();
        }
        let said = [
            (draft.spindle.is_some(), stated::SPINDLE),
            (draft.coolant_on | draft.coolant_off != 0, stated::COOLANT),
            (draft.length.is_some_and(|code| code != LengthCode::Off), stated::LENGTH),
            (draft.work_offset.is_some(), stated::OFFSET),
            (modes, stated::MODES),
        ];
        self.stated |= said.iter().filter(|(said, _)| *said).fold(0, |bits, (_, bit)| bits | bit);
    }

    /// Where words count is unknown, and so is every position.
    #[cold]
    fn in_unknown_frame(&mut self, block: &mut Block) {
        self.known = 0;
        if block.action.moves() && !block.action.leaves_words() {
            let text = "motion while tip control or a tilted plane may be active, after a line with the effect \"state lost\": \
                        switch both off before";
            fault(&mut block.faults, 0, text);
        }
    }

    /// Machine coordinates stay in the block alone.
    fn act_values(&self, block: &Block) -> [f64; MAX_AXES] {
        if block.action.leaves_words() { block.values } else { self.values }
    }

    /// The effect that the user has declared.
    fn suffer(&mut self, effects: u8, block: &mut Block) {
        if effects == 0 {
            return;
        }
        if effects & (effect::POSITION | effect::STOP | effect::STATE) != 0 {
            self.known = 0;
        }
        if effects & effect::COOLANT != 0 {
            self.state.coolant = None;
            self.stated &= !stated::COOLANT;
        }
        if effects & effect::SPINDLE != 0 {
            (self.state.spindle, self.state.speed) = (None, None);
            self.stated &= !stated::SPINDLE;
        }
        if effects & effect::MODES != 0 {
            self.lose_modes();
        }
        if effects & effect::STATE != 0 {
            let State { units, incremental, .. } = self.state;
            self.state = State { lost_at: Some(block.line), ..State::default() };
            // The unit of a program in statements is that of its first line, and each word of it has its own I.
            if self.facts.form == Form::Statements {
                (self.state.units, self.state.incremental) = (units, incremental);
            }
            (self.modal, self.cycle, self.stated) = (None, None, 0);
            self.frames.lose();
        }
        block.stated = self.stated;
        if effects & effect::STOP != 0 && block.action == Action::Nothing {
            block.action = Action::Stop;
        }
    }

    /// Blocks that measure a tool, or look for its breakage, may have left any modes and another work offset.
    fn lose_modes(&mut self) {
        let state = &mut self.state;
        (state.work_offset, state.cancelled_offset, state.side, state.feed) = (None, None, None, None);
        // Words of a program in statements have the unit of its first line, and each its own I.
        if self.facts.form != Form::Statements {
            (state.units, state.incremental, state.plane, state.feed_mode) = (None, None, None, None);
            state.side_unknown = true;
        }
        if self.facts.form == Form::Letters {
            state.length = None;
        }
        (self.modal, self.cycle) = (None, None);
        self.stated &= !(stated::OFFSET | stated::MODES);
    }

    fn act(&mut self, draft: &Draft, block: &mut Block) {
        if let Some(cycle) = draft.define {
            if self.cycle.is_none()
                && let Some(z) = self.normal()
            {
                self.initial = self.at(z);
            }
            self.cycle = Some(cycle);
        }
        if let Some(code) = draft.code {
            self.modal = Some(code);
            if !matches!(code, Code::Cycle) && draft.define.is_none() && self.facts.motion_modal && !draft.call {
                self.cycle = None;
            }
        }
        block.action = if draft.end {
            Action::End
        } else if let Some(optional) = draft.stop {
            self.known = 0;
            if optional { Action::OptionalStop } else { Action::Stop }
        } else if let Some(seconds) = draft.dwell {
            if seconds < 0.0 {
                fault(&mut block.faults, 0, "dwell with a negative time");
            }
            Action::Dwell(seconds)
        } else if draft.change {
            Action::ToolChange
        } else {
            self.motion(draft, block)
        };
        let alone = matches!(block.action, Action::End | Action::Stop | Action::OptionalStop | Action::Dwell(_));
        let stops = matches!(block.action, Action::End | Action::Stop | Action::OptionalStop | Action::ToolChange);
        if stops && self.facts.motion_codes_execute {
            self.code_alone(draft, &mut block.faults);
        }
        let others = draft.written != 0 || draft.reference || draft.machine || draft.end_of_travel;
        if (alone || block.action == Action::ToolChange) && others {
            fault(&mut block.faults, 0, "axis words in a block with another function");
        }
        let orients =
            matches!(draft.tilt, Some(TiltCode::Orient | TiltCode::Zero | TiltCode::On { oriented: true, .. }));
        if orients && block.action == Action::Nothing {
            block.action = Action::Orient;
        } else if orients {
            fault(&mut block.faults, 0, "the rotary axes are positioned to a plane in a block with another function");
        }
        if !self.facts.motion_modal {
            self.modal = None;
        }
    }
}

/// Says which words of a block did nothing.
fn leftovers(draft: &Draft, block: &mut Block) {
    if !block.faults.is_empty() {
        return;
    }
    if !matches!(draft.vector_written, 0 | 7) {
        fault(&mut block.faults, 0, "tool axis with fewer than three components");
    }
    if matches!(block.action, Action::Arc(_)) {
        return;
    }
    if draft.centre_written != 0 {
        fault(&mut block.faults, 0, "I, J or K without an arc");
    }
    if draft.radius.is_some() || draft.sweep.is_some() || draft.turns != 0 {
        fault(&mut block.faults, 0, "radius, angle or revolutions of an arc without an arc");
    }
}
