//! What the words of a block bring about: the one state machine behind every family of controls.
//!
//! Order of a block: unit, feed, spindle speed, tool, spindle, coolant, plane, compensation, offsets, tilt and tip control,
//! distances, motion, stop. Words become mm and rad here. Where an axis stands is known only while nothing has happened
//! that may have moved it or its zero.

use std::f64::consts::TAU;

use super::super::policy::Rollover;
use super::arc;
use super::block::{
    Action, Block, CycleMove, Fault, FeedMode, Length, MAX_AXES, State, Tilt, TipControl, coolant, stated,
};
use super::draft::{Code, Cycle, Draft, LengthCode, TiltCode, fault};
use crate::program::Units;

/// Angles nearer to half a turn than this have no shorter way, rad.
const HALF_TURN: f64 = 1e-9;

/// One axis of the machine as the program names it.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct AxisName {
    /// As in the program, upper case.
    pub(crate) name: Vec<u8>,
    pub(crate) rotary: bool,
    pub(crate) rollover: Option<Rollover>,
}

/// State and position of a control.
#[derive(Debug)]
pub(super) struct Interpreter {
    pub(super) axes: Vec<AxisName>,
    /// Positions of X Y Z.
    pub(super) linear: [Option<usize>; 3],
    pub(super) state: State,
    values: [f64; MAX_AXES],
    known: u16,
    /// The motion code in force.
    modal: Option<Code>,
    /// Bits of [`stated`], since a complete state began.
    stated: u8,
    /// The cycle that is defined.
    cycle: Option<Cycle>,
    /// The level before the cycle.
    initial: f64,
    /// Motion codes stay in force.
    pub(super) keeps_motion: bool,
    /// Half a unit of a linear word, mm: how far ends of arcs are rounded.
    pub(super) rounding: f64,
}

impl Interpreter {
    pub(super) fn new(axes: Vec<AxisName>, keeps_motion: bool, rounding: f64) -> Self {
        let linear = [b"X", b"Y", b"Z"].map(|name| axes.iter().position(|axis| axis.name == name));
        Self {
            axes,
            linear,
            state: State::default(),
            values: [0.0; MAX_AXES],
            known: 0,
            modal: None,
            stated: 0,
            cycle: None,
            initial: 0.0,
            keeps_motion,
            rounding,
        }
    }

    fn mask(&self, rotary: bool) -> u16 {
        let bits = self.axes.iter().enumerate().filter(|(_, axis)| axis.rotary == rotary);
        bits.fold(0, |mask, (index, _)| mask | 1 << index)
    }

    /// Does what a draft says and leaves it in the block.
    pub(super) fn execute(&mut self, draft: &Draft, block: &mut Block) {
        block.number = draft.number;
        block.restart = draft.restart || draft.units.is_some();
        block.guard = draft.guard;
        block.action = Action::Nothing;
        block.written = draft.written;
        if draft.groups != 0 || draft.written != 0 || draft.vector_written != 0 {
            self.set_state(draft, &mut block.faults);
        }
        self.state_bits(draft, block.restart);
        block.stated = self.stated;
        self.act(draft, block);
        let round = matches!(block.action, Action::Arc(_))
            || matches!(self.modal, Some(Code::Clockwise | Code::CounterClockwise));
        if draft.centre_written != 0 && !round {
            fault(&mut block.faults, 0, "I, J or K without an arc");
        }
        block.values = self.act_values(block);
        block.known = self.known;
        block.state = self.state;
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
        let said = [
            (draft.spindle.is_some(), stated::SPINDLE),
            (draft.coolant_on | draft.coolant_off != 0, stated::COOLANT),
            (draft.length.is_some_and(|code| code != LengthCode::Off), stated::LENGTH),
            (draft.work_offset.is_some(), stated::OFFSET),
            (modes, stated::MODES),
        ];
        self.stated |= said.iter().filter(|(said, _)| *said).fold(0, |bits, (_, bit)| bits | bit);
    }

    /// Machine coordinates stay in the block alone.
    fn act_values(&self, block: &Block) -> [f64; MAX_AXES] {
        if matches!(block.action, Action::Machine | Action::Reference) { block.values } else { self.values }
    }

    fn set_state(&mut self, draft: &Draft, faults: &mut Vec<Fault>) {
        let before = self.state;
        let state = &mut self.state;
        state.units = draft.units.or(state.units);
        if let Some(mode) = draft.feed_mode {
            if state.feed_mode != Some(mode) {
                state.feed = None;
            }
            state.feed_mode = Some(mode);
        }
        if state.feed_mode == Some(FeedMode::InverseTime) {
            state.feed = None;
        }
        if let Some(feed) = draft.feed {
            state.feed = Some(feed);
        }
        state.speed = draft.speed.or(state.speed);
        state.selected = draft.tool.or(state.selected);
        state.diameter = draft.diameter.or(state.diameter);
        state.plane = draft.plane.or(state.plane);
        state.side = draft.side.or(state.side);
        state.incremental = draft.distances.or(state.incremental);
        state.to_initial = draft.to_initial.unwrap_or(state.to_initial);
        state.shortest = draft.shortest.unwrap_or(state.shortest);
        state.work_offset = draft.work_offset.or(state.work_offset);
        if draft.change {
            state.tool = state.selected;
            state.spindle = Some(None);
            state.length = None;
            self.known = 0;
        }
        state.spindle = draft.spindle.or(state.spindle);
        if draft.coolant_off != 0 {
            let left = state.coolant.unwrap_or(0) & !draft.coolant_off;
            state.coolant = Some(left);
        }
        if draft.coolant_on != 0 {
            state.coolant = Some(state.coolant.unwrap_or(0) | draft.coolant_on);
        }
        if draft.coolant_on & !(coolant::FLOOD | coolant::MIST | coolant::THROUGH | coolant::AIR) != 0 {
            fault(faults, 0, "unknown coolant code");
        }
        self.set_length(draft, faults);
        self.set_frames(draft);
        let now = &self.state;
        if now.length != before.length {
            // The length lies along Z, whatever the plane.
            self.known &= !self.linear[2].map_or(0, |z| 1 << z);
        }
        if (now.work_offset, now.units) != (before.work_offset, before.units)
            || now.tilt != before.tilt
            || now.tip_control != before.tip_control
        {
            self.known &= !self.mask(false);
        }
    }

    fn set_length(&mut self, draft: &Draft, faults: &mut Vec<Fault>) {
        let state = &mut self.state;
        let with = |register: Option<u32>, state: &State| {
            register.or(match state.length {
                Some(Length::Register(register)) => Some(register),
                _ => None,
            })
        };
        match draft.length {
            None if draft.length_with_tool => state.length = state.tool.map(Length::Register),
            None => {
                if draft.register.is_some() {
                    fault(faults, 0, "length register without the code for length compensation");
                }
            }
            Some(LengthCode::Off) => state.length = Some(Length::Off),
            Some(LengthCode::On | LengthCode::TipControl | LengthCode::TipVector) => {
                match with(draft.register, state) {
                    Some(0) => state.length = Some(Length::Off),
                    Some(register) => state.length = Some(Length::Register(register)),
                    None => fault(faults, 0, "length compensation without its register"),
                }
            }
        }
    }

    fn set_frames(&mut self, draft: &Draft) {
        let state = &mut self.state;
        let tip = match draft.length {
            Some(LengthCode::TipControl | LengthCode::TipVector) => Some(true),
            _ => draft.tip_control,
        };
        match tip {
            Some(true) => state.tip_control = TipControl::On { start: self.values },
            Some(false) => {
                state.tip_control = TipControl::Off;
                state.vector = None;
            }
            None => {}
        }
        state.in_plane = draft.in_plane.or(state.in_plane);
        state.in_workpiece = draft.in_workpiece.or(state.in_workpiece);
        if draft.vector_written == 7 {
            state.vector = nalgebra::Vector3::from(draft.vector).try_normalize(0.0);
        }
        match draft.tilt {
            None | Some(TiltCode::Orient) => {}
            Some(TiltCode::Off) => state.tilt = None,
            Some(TiltCode::On { rotation, origin, oriented }) => {
                let unit = state.units.map_or(1.0, |units| units.in_mm());
                state.tilt = Some(Tilt { rotation, origin: origin * unit, oriented });
            }
        }
        if draft.tilt == Some(TiltCode::Orient)
            && let Some(tilt) = &mut state.tilt
        {
            tilt.oriented = true;
        }
    }

    fn act(&mut self, draft: &Draft, block: &mut Block) {
        if let Some(cycle) = draft.define {
            if self.cycle.is_none()
                && let Some(z) = self.normal()
            {
                self.initial = self.values[z];
            }
            self.cycle = Some(cycle);
        }
        if let Some(code) = draft.code {
            self.modal = Some(code);
            if !matches!(code, Code::Cycle) && draft.define.is_none() && self.keeps_motion && !draft.call {
                self.cycle = None;
            }
        }
        block.action = if draft.end {
            Action::End
        } else if let Some(optional) = draft.stop {
            self.known = 0;
            if optional { Action::OptionalStop } else { Action::Stop }
        } else if let Some(seconds) = draft.dwell {
            Action::Dwell(seconds)
        } else if draft.change {
            Action::ToolChange
        } else {
            self.motion(draft, block)
        };
        let alone = matches!(block.action, Action::End | Action::Stop | Action::OptionalStop | Action::Dwell(_));
        if (alone || block.action == Action::ToolChange) && draft.written != 0 {
            fault(&mut block.faults, 0, "axis words in a block with another function");
        }
        if matches!(draft.tilt, Some(TiltCode::Orient | TiltCode::On { oriented: true, .. }))
            && block.action == Action::Nothing
        {
            block.action = Action::Orient;
        }
        if !self.keeps_motion {
            self.modal = None;
        }
    }

    fn motion(&mut self, draft: &Draft, block: &mut Block) -> Action {
        // Under tip control a block may turn the tool axis alone.
        let turns = draft.vector_written != 0 && self.state.tip_control != TipControl::Off;
        if draft.written == 0 && !turns {
            if draft.call {
                return self.hole(&mut block.faults);
            }
            if draft.machine {
                fault(&mut block.faults, 0, "machine coordinates without an axis word");
            }
            return self.still(draft, &mut block.faults);
        }
        if draft.machine || draft.reference {
            return self.machine_block(draft, block);
        }
        let Some(code) = self.modal else {
            fault(&mut block.faults, 0, "axis words, but no motion code is active");
            return Action::Nothing;
        };
        let from = (self.values, self.known);
        if code == Code::Cycle && draft.define.is_some() && self.written_plane(draft) == 0 && !draft.call {
            return Action::Nothing;
        }
        self.place(draft, code == Code::Cycle, &mut block.faults);
        match code {
            Code::None => {
                fault(&mut block.faults, 0, "axis words, but no motion code is active");
                Action::Nothing
            }
            Code::Cycle => self.hole(&mut block.faults),
            Code::Rapid if draft.call => self.hole(&mut block.faults),
            Code::Rapid => Action::Rapid,
            Code::Feed => Action::Feed,
            Code::RigidTap => self.rigid_tap(draft, from.0, &mut block.faults),
            Code::Clockwise | Code::CounterClockwise => match arc::of(draft, self, from, code == Code::Clockwise) {
                Ok(arc) => Action::Arc(arc),
                Err(text) => {
                    fault(&mut block.faults, 0, text);
                    Action::Feed
                }
            },
        }
    }

    /// A block without axes: only a full circle moves.
    fn still(&mut self, draft: &Draft, faults: &mut Vec<Fault>) -> Action {
        if draft.centre_written != 0
            && let Some(code @ (Code::Clockwise | Code::CounterClockwise)) = self.modal
        {
            return match arc::of(draft, self, (self.values, self.known), code == Code::Clockwise) {
                Ok(arc) => Action::Arc(arc),
                Err(text) => {
                    fault(faults, 0, text);
                    Action::Nothing
                }
            };
        }
        Action::Nothing
    }

    /// Words of the axes of the plane.
    fn written_plane(&self, draft: &Draft) -> u16 {
        let normal = self.normal().map_or(0, |index| 1 << index);
        draft.written & !normal
    }

    fn machine_block(&mut self, draft: &Draft, block: &mut Block) -> Action {
        let unit = self.unit();
        for index in (0..self.axes.len()).filter(|index| draft.written & (1 << index) != 0) {
            let value = draft.axes[index];
            block.values[index] = if self.axes[index].rotary { value.to_radians() } else { value * unit };
        }
        self.known &= !draft.written;
        if draft.reference {
            return Action::Reference;
        }
        if self.modal != Some(Code::Rapid) {
            fault(&mut block.faults, 0, "machine coordinates in a feed motion");
        }
        if self.state.incremental == Some(true) {
            fault(&mut block.faults, 0, "machine coordinates in incremental mode");
        }
        Action::Machine
    }

    /// Where the axes stand.
    pub(super) fn position(&self) -> [f64; MAX_AXES] {
        self.values
    }

    /// Where an axis stands, if that is known.
    pub(super) fn at(&self, index: usize) -> Option<f64> {
        (self.known & (1 << index) != 0).then_some(self.values[index])
    }

    pub(super) fn unit(&self) -> f64 {
        self.state.units.map_or(1.0, Units::in_mm)
    }

    /// Position of the axis along the normal of the plane.
    pub(super) fn normal(&self) -> Option<usize> {
        let [_, _, normal] = self.state.plane?.axes();
        self.linear[normal]
    }

    /// Puts the axes where their words say.
    fn place(&mut self, draft: &Draft, cycle: bool, faults: &mut Vec<Fault>) {
        let (unit, normal) = (self.unit(), self.normal());
        for index in (0..self.axes.len()).filter(|index| draft.written & (1 << index) != 0) {
            // In a cycle the word along the normal is the bottom of the hole.
            if cycle && Some(index) == normal {
                continue;
            }
            let bit = 1 << index;
            let rotary = self.axes[index].rotary;
            let value = if rotary { draft.axes[index].to_radians() } else { draft.axes[index] * unit };
            let incremental =
                draft.incremental & bit != 0 || (self.state.incremental == Some(true) && draft.absolute & bit == 0);
            if incremental {
                if self.known & bit == 0 {
                    fault(faults, 0, "incremental motion from an unknown position");
                }
                self.values[index] += value;
            } else if rotary {
                self.values[index] = self.turned(index, value, draft.negative & bit != 0, faults);
            } else {
                self.values[index] = value;
            }
            self.known |= bit;
        }
    }

    /// Where a rotary axis ends whose word says `value`.
    fn turned(&self, index: usize, value: f64, negative: bool, faults: &mut Vec<Fault>) -> f64 {
        // Where the set-up says which axes roll over, the short way is for these.
        let said = self.axes.iter().any(|axis| axis.rollover.is_some());
        let any = if self.state.shortest && !said { Some(Rollover::Shortest) } else { None };
        let wrap = self.axes[index].rollover.or(any);
        let Some(wrap) = wrap else { return value };
        if self.known & (1 << index) == 0 {
            // Its sign is the way there, not the place.
            return if wrap == Rollover::Sign { value.abs() } else { value };
        }
        let from = self.values[index];
        match wrap {
            Rollover::Sign => {
                let forward = (value.abs() - from).rem_euclid(TAU);
                // What is already there does not turn, whatever its rounding.
                let forward = if TAU - forward < HALF_TURN { 0.0 } else { forward };
                if forward < HALF_TURN || !negative { from + forward } else { from + forward - TAU }
            }
            Rollover::Shortest => {
                let way = (value - from + TAU / 2.0).rem_euclid(TAU) - TAU / 2.0;
                if TAU / 2.0 - way.abs() < HALF_TURN {
                    fault(faults, 0, "rotary motion of exactly 180°: the control may rotate in either direction");
                }
                from + way
            }
        }
    }

    /// The hole of the cycle that is defined, where the axes stand.
    fn hole(&mut self, faults: &mut Vec<Fault>) -> Action {
        let (Some(cycle), Some(normal)) = (self.cycle, self.normal()) else {
            fault(faults, 0, "cycle call without a cycle definition, or without a working plane");
            return Action::Nothing;
        };
        let back_to = cycle.back_to.unwrap_or(if self.state.to_initial { self.initial } else { cycle.reference });
        let back_to = back_to.max(cycle.reference);
        self.values[normal] = back_to;
        self.known |= 1 << normal;
        Action::Cycle(CycleMove {
            kind: cycle.kind,
            reference: cycle.reference,
            bottom: cycle.bottom,
            back_to,
            dwell: cycle.dwell,
            feed: cycle.feed,
        })
    }

    /// G33.1 to a depth along the normal; it comes back to where it began.
    fn rigid_tap(&mut self, draft: &Draft, from: [f64; MAX_AXES], faults: &mut Vec<Fault>) -> Action {
        let (Some(pitch), Some(normal)) = (draft.pitch, self.normal()) else {
            fault(faults, 0, "thread without a pitch, or without a working plane");
            return Action::Nothing;
        };
        let bottom = self.values[normal];
        self.values = from;
        self.modal = None;
        let back_to = from[normal];
        let left = matches!(self.state.spindle, Some(Some(crate::program::Rotation::CounterClockwise)));
        let pitch = pitch * self.unit() * if left { -1.0 } else { 1.0 };
        let kind = super::block::CycleKind::Tap(pitch);
        Action::Cycle(CycleMove { kind, reference: back_to, bottom, back_to, dwell: 0.0, feed: None })
    }
}
