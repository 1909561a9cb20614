//! What codes change in the state of the control.

use super::super::block::{Block, BlockFault, FeedMode, Length, SideOfPath, Tilt, TipControl, coolant};
use super::super::facts::LineForm;
use super::super::orders::{Code, LengthCode, ModeOrder, TiltCode, fault};
use super::{FrameBits, Interpreter, MAX_AXES};
use crate::check::tolerances::UNIT_VECTOR;

impl Interpreter {
    /// Sets modes one after the other. Positions whose zero has moved are unknown afterwards.
    pub(super) fn set_modes(&mut self, modes: &[ModeOrder], block: &mut Block) {
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

    fn set(&mut self, mode: &ModeOrder, block: &mut Block) {
        let faults = &mut block.faults;
        let state = &mut self.state;
        match *mode {
            // An operation can be entered at its complete state: F and the return level are not of what was before.
            ModeOrder::Restart => (state.feed, state.to_initial) = (None, None),
            ModeOrder::Units(units) => (state.units, state.feed, state.to_initial) = (Some(units), None, None),
            ModeOrder::FeedMode(mode) => {
                if state.feed_mode != Some(mode) || self.facts.feed_mode_clears_feed {
                    state.feed = None;
                }
                state.feed_mode = Some(mode);
            }
            ModeOrder::Feed(feed) => state.feed = Some(feed),
            ModeOrder::Speed(speed) => state.speed = Some(speed),
            ModeOrder::Tool(tool) => state.selected = Some(tool),
            ModeOrder::RadiusRegister(register) => state.diameter = Some(register),
            ModeOrder::Plane(plane) => state.plane = Some(plane),
            ModeOrder::Side(side) => {
                if self.facts.motion_codes_execute && state.compensates() && side != SideOfPath::None {
                    fault(faults, 0, "cutter compensation is switched on while it is on");
                }
                (state.side, state.side_unknown) = (Some(side), false);
            }
            ModeOrder::Settles(_) => {}
            ModeOrder::Incremental(on) => state.incremental = Some(on),
            ModeOrder::AbsoluteCentres(on) => state.absolute_centres = Some(on),
            ModeOrder::ReturnToInitial(initial) => {
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
            ModeOrder::Shortest(shortest) => (state.shortest, state.shortest_stated) = (shortest, true),
            ModeOrder::CancelsOffset { off } => {
                let known = self.frames.stated & FrameBits::TIP_CONTROL != 0;
                if !(known && off && state.tip_control == TipControl::Off) {
                    state.cancelled_offset = state.work_offset.or(state.cancelled_offset);
                    state.work_offset = None;
                }
            }
            ModeOrder::WorkOffset(offset) => (state.work_offset, state.cancelled_offset) = (Some(offset), None),
            ModeOrder::Path(mode) => state.path_mode = Some(mode),
            ModeOrder::Smoothing(smoothing, angle_rad) => {
                (state.smoothing, state.smoothing_angle_rad) = (smoothing, angle_rad);
            }
            ModeOrder::Clamp { axis, on } => {
                state.clamped = state.clamped & !(1 << axis) | u16::from(on) << axis;
                state.clamps_known |= 1 << axis;
            }
            ModeOrder::Change => {
                (state.tool, state.spindle, state.length) = (state.selected, Some(None), None);
                self.known = 0;
            }
            ModeOrder::RadiusDelta(Some(delta)) => state.radius_delta_mm = Some(delta),
            // Whether a call with S alone keeps DR is in no manual that was found.
            ModeOrder::RadiusDelta(None) => state.radius_delta_mm = state.radius_delta_mm.filter(|delta| *delta == 0.0),
            ModeOrder::Spindle(rotation) => {
                if self.motion.canned.is_some() && self.motion.rigid {
                    fault(faults, 0, "a code of the spindle between the holes of rigid tapping");
                }
                state.spindle = Some(rotation);
            }
            ModeOrder::CoolantOff(kinds) => {
                // Off codes of another supply leave flood and mist unknown.
                let known = state.coolant.or((kinds & coolant::FLOOD != 0).then_some(0));
                state.coolant = known.map(|on| on & !kinds);
            }
            ModeOrder::CoolantOn(0) => {}
            ModeOrder::CoolantOn(kinds) => state.coolant = Some(state.coolant.unwrap_or(0) | kinds),
            ModeOrder::LengthOfTool => state.length = state.tool.map(Length::Register),
            ModeOrder::Length(code, register) => self.set_length(code, register, faults),
            ModeOrder::DynamicOffset(on) => {
                if on && (state.tilt.is_some() || state.tip_control != TipControl::Off) {
                    fault(faults, 0, "the dynamic work offset is switched on under tip control or in a tilted plane");
                }
                state.dynamic_offset = on;
                self.frames.programmed(FrameBits::DYNAMIC_OFFSET, on);
            }
            ModeOrder::TipControl(on) => self.set_tip_control(on, faults),
            ModeOrder::InPlane(in_plane) => state.in_plane = Some(in_plane),
            ModeOrder::InWorkpiece(in_workpiece) => state.in_workpiece = Some(in_workpiece),
            ModeOrder::Vector(vector, written) => self.set_vector(vector, written, faults),
            ModeOrder::Tilt(tilt) => self.set_tilt(tilt, faults),
            ModeOrder::Motion(code, takes) => {
                (self.motion.code, self.motion.takes) = (Some(code), takes);
                if code != Code::Cycle {
                    (self.motion.canned, self.motion.rigid) = (None, false);
                }
            }
            ModeOrder::Rigid => self.motion.rigid = true,
            ModeOrder::Define(cycle) => self.motion.cycle = Some(cycle),
            ModeOrder::CallAtEachPoint(cycle) => self.motion.each_point = cycle,
            ModeOrder::Canned(words) => self.set_canned(words, faults),
            ModeOrder::Guard(guard) => block.guards.length = Some(guard),
            ModeOrder::RadiusGuard(largest_mm) => block.guards.radius_mm = Some(largest_mm),
            ModeOrder::PlaneGuard(guard) => block.guards.plane = Some(guard),
            ModeOrder::OffsetGuard => block.guards.offset = true,
            ModeOrder::Blank(part) => block.blank = Some(part),
        }
    }

    /// Sets the F of a block that changes nothing else: that before it holds for its block alone under inverse time.
    pub(super) fn set_feed(&mut self, feed: Option<f64>) {
        let stays = self.state.feed_mode != Some(FeedMode::InverseTime);
        self.state.feed = feed.or(self.state.feed.filter(|_| stays));
    }

    fn set_length(&mut self, code: LengthCode, register: Option<u32>, faults: &mut Vec<BlockFault>) {
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

    fn set_tip_control(&mut self, on: bool, faults: &mut Vec<BlockFault>) {
        let state = &mut self.state;
        if on {
            if self.facts.form == LineForm::Statements && state.tip_control != TipControl::Off {
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
        self.frames.programmed(FrameBits::TIP_CONTROL, on);
    }

    fn set_vector(&mut self, vector: [f64; 3], written: u8, faults: &mut Vec<BlockFault>) {
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

    fn set_tilt(&mut self, tilt: TiltCode, faults: &mut Vec<BlockFault>) {
        let unit = self.unit();
        let state = &mut self.state;
        if tilt != TiltCode::Orient {
            self.frames.programmed(FrameBits::PLANE, matches!(tilt, TiltCode::On { .. }));
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
