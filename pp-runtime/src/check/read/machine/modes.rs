//! What codes change in the state of the control.

use super::super::block::{Block, Fault, FeedMode, Length, MAX_AXES, Side, Tilt, TipControl, coolant};
use super::super::facts::Form;
use super::super::orders::{Code, LengthCode, Mode, TiltCode, fault};
use super::{Frames, Interpreter};
use crate::check::tolerances::UNIT_VECTOR;

impl Interpreter {
    /// Sets modes one after the other. Positions whose zero has moved are unknown afterwards.
    pub(super) fn set_modes(&mut self, modes: &[Mode], block: &mut Block) {
        if modes.is_empty() {
            return;
        }
        let (length, zero, frame) = (self.state.length, (self.state.work_offset, self.state.units), self.state.frame());
        for mode in modes {
            self.set(mode, block);
        }
        let now = &self.state;
        if now.length != length {
            // The length lies along Z, whatever the plane.
            self.known &= !self.axes.linear[2].map_or(0, |z| 1 << z);
        }
        if (now.work_offset, now.units) != zero || now.frame() != frame {
            self.known &= self.axes.rotary;
        }
    }

    fn set(&mut self, mode: &Mode, block: &mut Block) {
        let faults = &mut block.faults;
        let state = &mut self.state;
        match *mode {
            // An operation can be entered at its complete state: F and the return level are not of what was before.
            Mode::Restart => (state.feed, state.to_initial) = (None, None),
            Mode::Units(units) => (state.units, state.feed, state.to_initial) = (Some(units), None, None),
            Mode::FeedMode(mode) => {
                if state.feed_mode != Some(mode) || self.facts.feed_mode_clears_feed {
                    state.feed = None;
                }
                state.feed_mode = Some(mode);
            }
            Mode::Feed(feed) => state.feed = Some(feed),
            Mode::Speed(speed) => state.speed = Some(speed),
            Mode::Tool(tool) => state.selected = Some(tool),
            Mode::RadiusRegister(register) => state.diameter = Some(register),
            Mode::Plane(plane) => state.plane = Some(plane),
            Mode::Side(side) => {
                if self.facts.motion_codes_execute && state.compensates() && side != Side::None {
                    fault(faults, 0, "cutter compensation is switched on while it is on");
                }
                (state.side, state.side_unknown) = (Some(side), false);
            }
            Mode::Settles(_) => {}
            Mode::Incremental(on) => state.incremental = Some(on),
            Mode::AbsoluteCentres(on) => state.absolute_centres = Some(on),
            Mode::ReturnToInitial(initial) => {
                // LinuxCNC: "Cannot change retract mode with cutter radius compensation on".
                if self.facts.motion_codes_execute && state.compensates() {
                    fault(
                        faults,
                        0,
                        "the level after a hole is set while cutter compensation is on: the control refuses it",
                    );
                }
                state.to_initial = Some(initial);
            }
            Mode::Shortest(shortest) => (state.shortest, state.shortest_stated) = (shortest, true),
            Mode::CancelsOffset { off } => {
                let known = self.frames.stated & Frames::TIP_CONTROL != 0;
                if !(known && off && state.tip_control == TipControl::Off) {
                    state.cancelled_offset = state.work_offset.or(state.cancelled_offset);
                    state.work_offset = None;
                }
            }
            Mode::WorkOffset(offset) => (state.work_offset, state.cancelled_offset) = (Some(offset), None),
            Mode::Path(mode) => state.path_mode = Some(mode),
            Mode::Smoothing(smoothing, angle_rad) => {
                (state.smoothing, state.smoothing_angle_rad) = (smoothing, angle_rad);
            }
            Mode::Clamp { axis, on } => {
                state.clamped = state.clamped & !(1 << axis) | u16::from(on) << axis;
                state.clamps_known |= 1 << axis;
            }
            Mode::Change => {
                (state.tool, state.spindle, state.length) = (state.selected, Some(None), None);
                self.known = 0;
            }
            Mode::RadiusDelta(Some(delta)) => state.radius_delta_mm = Some(delta),
            // Whether a call with S alone keeps DR is in no manual that was found.
            Mode::RadiusDelta(None) => state.radius_delta_mm = state.radius_delta_mm.filter(|delta| *delta == 0.0),
            Mode::Spindle(rotation) => {
                if self.motion.canned.is_some() && self.motion.rigid {
                    fault(faults, 0, "a code of the spindle between the holes of rigid tapping");
                }
                state.spindle = Some(rotation);
            }
            Mode::CoolantOff(kinds) => {
                // Off codes of another supply leave flood and mist unknown.
                let known = state.coolant.or((kinds & coolant::FLOOD != 0).then_some(0));
                state.coolant = known.map(|on| on & !kinds);
            }
            Mode::CoolantOn(0) => {}
            Mode::CoolantOn(kinds) => state.coolant = Some(state.coolant.unwrap_or(0) | kinds),
            Mode::LengthOfTool => state.length = state.tool.map(Length::Register),
            Mode::Length(code, register) => self.set_length(code, register, faults),
            Mode::DynamicOffset(on) => {
                if on && (state.tilt.is_some() || state.tip_control != TipControl::Off) {
                    fault(faults, 0, "the dynamic work offset is switched on under tip control or in a tilted plane");
                }
                state.dynamic_offset = on;
                self.frames.programmed(Frames::DYNAMIC_OFFSET, on);
            }
            Mode::TipControl(on) => self.set_tip_control(on, faults),
            Mode::InPlane(in_plane) => state.in_plane = Some(in_plane),
            Mode::InWorkpiece(in_workpiece) => state.in_workpiece = Some(in_workpiece),
            Mode::Vector(vector, written) => self.set_vector(vector, written, faults),
            Mode::Tilt(tilt) => self.set_tilt(tilt, faults),
            Mode::Motion(code, takes) => {
                (self.motion.code, self.motion.takes) = (Some(code), takes);
                if code != Code::Cycle {
                    (self.motion.canned, self.motion.rigid) = (None, false);
                }
            }
            Mode::Rigid => self.motion.rigid = true,
            Mode::Define(cycle) => self.motion.cycle = Some(cycle),
            Mode::CallAtEachPoint(cycle) => self.motion.each_point = cycle,
            Mode::Canned(words) => self.set_canned(words, faults),
            Mode::Guard(guard) => block.guards.length = Some(guard),
            Mode::RadiusGuard(largest_mm) => block.guards.radius_mm = Some(largest_mm),
            Mode::PlaneGuard(guard) => block.guards.plane = Some(guard),
            Mode::OffsetGuard => block.guards.offset = true,
            Mode::Blank(part) => block.blank = Some(part),
        }
    }

    /// Sets the F of a block that changes nothing else: that before it holds for its block alone under inverse time.
    pub(super) fn set_feed(&mut self, feed: Option<f64>) {
        let stays = self.state.feed_mode != Some(FeedMode::InverseTime);
        self.state.feed = feed.or(self.state.feed.filter(|_| stays));
    }

    fn set_length(&mut self, code: LengthCode, register: Option<u32>, faults: &mut Vec<Fault>) {
        self.motion.vectors = code == LengthCode::TipVector;
        let state = &mut self.state;
        // A code without its register is a fault by the table.
        match (code, register) {
            (LengthCode::Off, _) => state.length = Some(Length::Off),
            (_, Some(0)) if self.facts.register_0_is_off => state.length = Some(Length::Off),
            (_, Some(0)) => fault(faults, 0, "length register 0: which length it has depends on the tool changer"),
            (_, Some(register)) => state.length = Some(Length::Register(register)),
            (_, None) => {}
        }
    }

    fn set_tip_control(&mut self, on: bool, faults: &mut Vec<Fault>) {
        let state = &mut self.state;
        if on {
            if self.facts.form == Form::Statements && state.tip_control != TipControl::Off {
                fault(faults, 0, "tip control is on already: M128 and FUNCTION TCPM do not replace each other");
            }
            state.tip_control = TipControl::On { start: self.values };
            if self.facts.tip_control_has_form {
                state.in_plane = None;
            }
            if state.dynamic_offset {
                fault(faults, 0, "tip control is switched on while the dynamic work offset is active");
            }
        } else {
            (state.tip_control, state.vector) = (TipControl::Off, None);
        }
        self.frames.programmed(Frames::TIP_CONTROL, on);
    }

    fn set_vector(&mut self, vector: [f64; 3], written: u8, faults: &mut Vec<Fault>) {
        if self.state.tip_control == TipControl::Off {
            fault(faults, 0, "a tool axis is programmed while tip control is off");
        }
        if written != 7 {
            return fault(faults, 0, "tool axis with fewer than three components");
        }
        let vector = nalgebra::Vector3::from(vector);
        if (vector.norm() - 1.0).abs() > UNIT_VECTOR {
            fault(faults, 0, "the components of the tool axis are those of no unit vector");
        }
        self.state.vector = vector.try_normalize(0.0);
        self.turned = self.axes.rotary;
    }

    fn set_tilt(&mut self, tilt: TiltCode, faults: &mut Vec<Fault>) {
        let unit = self.unit();
        let state = &mut self.state;
        if tilt != TiltCode::Orient {
            self.frames.programmed(Frames::PLANE, matches!(tilt, TiltCode::On { .. }));
        }
        match tilt {
            TiltCode::Off => state.tilt = None,
            TiltCode::Zero => {
                state.tilt = None;
                let rotary = self.axes.rotary;
                (0..MAX_AXES).filter(|index| rotary & (1 << index) != 0).for_each(|index| self.values[index] = 0.0);
                self.known = rotary;
            }
            TiltCode::On { rotation, origin, oriented, pose, rotates_table } => {
                state.tilt = Some(Tilt { rotation, origin: origin * unit, oriented, pose, rotates_table });
                if state.dynamic_offset {
                    fault(faults, 0, "a plane is tilted while the dynamic work offset is active");
                }
            }
            TiltCode::Orient => match &mut state.tilt {
                Some(tilt) => tilt.oriented = true,
                None => fault(faults, 0, "the rotary axes are positioned to a tilted plane, but none is active"),
            },
        }
    }
}
