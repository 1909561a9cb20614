//! What codes change in the state of the control, before the block moves.

use super::super::block::{Fault, FeedMode, Length, MAX_AXES, Side, Tilt, TipControl, coolant};
use super::super::draft::{Draft, LengthCode, TiltCode, fault};
use super::{Frames, Interpreter};
use crate::check::tolerances::UNIT_VECTOR;

impl Interpreter {
    pub(super) fn set_state(&mut self, draft: &Draft, faults: &mut Vec<Fault>) {
        self.set_feed_and_speed(draft);
        let state = &mut self.state;
        let (before_length, before) = (state.length, (state.work_offset, state.units));
        let reframes = draft.tilt.is_some()
            || draft.tip_control.is_some()
            || draft.length.is_some()
            || draft.dynamic_offset.is_some();
        let frames = if reframes { Some(state.frame()) } else { None };
        state.units = draft.units.or(state.units);
        // An operation can be entered at its complete state: F and the return level are not of what was before.
        if draft.restart || draft.units.is_some() {
            state.to_initial = None;
        }
        state.feed_mode = draft.feed_mode.or(state.feed_mode);
        state.selected = draft.tool.or(state.selected);
        state.diameter = draft.diameter.or(state.diameter);
        state.plane = draft.plane.or(state.plane);
        let on = |side: Option<Side>| side.is_some_and(|side| side != Side::None);
        if self.facts.motion_codes_execute && on(draft.side) && on(state.side) {
            fault(faults, 0, "cutter compensation is switched on while it is on");
        }
        state.side = draft.side.or(state.side);
        state.side_unknown &= draft.side.is_none();
        state.incremental = draft.distances.or(state.incremental);
        state.to_initial = draft.to_initial.or(state.to_initial);
        state.shortest = draft.shortest.unwrap_or(state.shortest);
        state.shortest_stated |= draft.shortest.is_some();
        let known = self.frames.stated & Frames::TIP_CONTROL != 0;
        let off = known && draft.tip_control == Some(false) && state.tip_control == TipControl::Off;
        if draft.offset_lost && !off {
            state.cancelled_offset = state.work_offset.or(state.cancelled_offset);
            state.work_offset = None;
        }
        if draft.work_offset.is_some() {
            (state.work_offset, state.cancelled_offset) = (draft.work_offset, None);
        }
        state.path_mode = draft.path_mode.or(state.path_mode);
        if let Some(smoothing) = draft.smoothing {
            state.smoothing = smoothing;
            state.smoothing_angle_rad = None;
        }
        state.smoothing_angle_rad = draft.smoothing_angle.or(state.smoothing_angle_rad);
        state.clamped = state.clamped & !draft.clamp_off | draft.clamp_on;
        state.clamps_known |= draft.clamp_on | draft.clamp_off;
        if draft.change {
            state.tool = state.selected;
            state.spindle = Some(None);
            state.length = None;
            self.known = 0;
        }
        match draft.radius_delta_mm {
            Some(Some(delta)) => state.radius_delta_mm = Some(delta),
            // Whether a call with S alone keeps DR is in no manual that was found.
            Some(None) => state.radius_delta_mm = state.radius_delta_mm.filter(|delta| *delta == 0.0),
            None => {}
        }
        state.spindle = draft.spindle.or(state.spindle);
        if draft.coolant_off != 0 {
            // Off codes of another supply leave flood and mist unknown.
            let known = state.coolant.or((draft.coolant_off & coolant::FLOOD != 0).then_some(0));
            state.coolant = known.map(|on| on & !draft.coolant_off);
        }
        if draft.coolant_on != 0 {
            state.coolant = Some(state.coolant.unwrap_or(0) | draft.coolant_on);
        }
        self.set_length(draft, faults);
        self.set_frames(draft, faults);
        let now = &self.state;
        if now.length != before_length {
            // The length lies along Z, whatever the plane.
            self.known &= !self.linear[2].map_or(0, |z| 1 << z);
        }
        let reframed = frames.is_some_and(|frames| frames != now.frame());
        if (now.work_offset, now.units) != before || reframed {
            self.known &= self.rotary;
        }
    }

    /// The F of a block: its own, or that before it, which is lost with its unit and its mode, and which holds for its block alone
    /// under inverse time.
    pub(in super::super) fn feed_in(&self, draft: &Draft) -> Option<f64> {
        let (state, clears) = (&self.state, self.facts.feed_mode_clears_feed);
        let stays = !draft.restart
            && draft.units.is_none()
            && draft.feed_mode.is_none_or(|mode| state.feed_mode == Some(mode) && !clears)
            && state.feed_mode != Some(FeedMode::InverseTime);
        draft.feed.or(state.feed.filter(|_| stays))
    }

    /// Sets F and S of a block before its modes.
    pub(super) fn set_feed_and_speed(&mut self, draft: &Draft) {
        self.state.feed = self.feed_in(draft);
        self.state.speed = draft.speed.or(self.state.speed);
    }

    fn set_length(&mut self, draft: &Draft, faults: &mut Vec<Fault>) {
        let state = &mut self.state;
        match draft.length {
            None if draft.length_with_tool => state.length = state.tool.map(Length::Register),
            None => {
                if draft.register.is_some() {
                    fault(faults, 0, "length register without the code for length compensation");
                }
            }
            Some(LengthCode::Off) => state.length = Some(Length::Off),
            Some(LengthCode::On | LengthCode::TipControl | LengthCode::TipVector) => {
                // A code without its register is a fault by the table.
                match draft.register {
                    Some(0) if self.facts.register_0_is_off => state.length = Some(Length::Off),
                    Some(0) => fault(faults, 0, "length register 0: which length it has depends on the tool changer"),
                    Some(register) => state.length = Some(Length::Register(register)),
                    None => {}
                }
            }
        }
    }

    fn set_frames(&mut self, draft: &Draft, faults: &mut Vec<Fault>) {
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
        if let Some(on) = tip {
            self.frames.programmed(Frames::TIP_CONTROL, on);
        }
        let form = self.facts.tip_control_has_form && tip == Some(true);
        state.in_plane = if form { draft.in_plane } else { draft.in_plane.or(state.in_plane) };
        state.in_workpiece = draft.in_workpiece.or(state.in_workpiece);
        if draft.vector_written != 0 && state.tip_control == TipControl::Off {
            fault(faults, 0, "a tool axis is programmed while tip control is off");
        }
        if draft.vector_written == 7 {
            if (nalgebra::Vector3::from(draft.vector).norm() - 1.0).abs() > UNIT_VECTOR {
                fault(faults, 0, "the components of the tool axis are those of no unit vector");
            }
            state.vector = nalgebra::Vector3::from(draft.vector).try_normalize(0.0);
        }
        if let Some(on) = draft.dynamic_offset {
            state.dynamic_offset = on;
            self.frames.programmed(Frames::DYNAMIC_OFFSET, on);
        }
        if state.dynamic_offset && tip == Some(true) {
            fault(faults, 0, "tip control is switched on while the dynamic work offset is active");
        }
        if state.dynamic_offset && matches!(draft.tilt, Some(TiltCode::On { .. })) {
            fault(faults, 0, "a plane is tilted while the dynamic work offset is active");
        }
        if draft.tilt.is_some_and(|tilt| tilt != TiltCode::Orient) {
            self.frames.programmed(Frames::PLANE, matches!(draft.tilt, Some(TiltCode::On { .. })));
        }
        match draft.tilt {
            None | Some(TiltCode::Orient) => {}
            Some(TiltCode::Off | TiltCode::Zero) => state.tilt = None,
            Some(TiltCode::On { rotation, origin, oriented, pose, rotates_table }) => {
                let unit = state.units.map_or(1.0, |units| units.in_mm());
                state.tilt = Some(Tilt { rotation, origin: origin * unit, oriented, pose, rotates_table });
            }
        }
        match (draft.tilt, &mut state.tilt) {
            (Some(TiltCode::Orient), Some(tilt)) => tilt.oriented = true,
            (Some(TiltCode::Orient), None) => {
                fault(faults, 0, "the rotary axes are positioned to a tilted plane, but none is active");
            }
            _ => {}
        }
        if draft.tilt == Some(TiltCode::Zero) {
            let rotary = self.rotary;
            (0..MAX_AXES).filter(|index| rotary & (1 << index) != 0).for_each(|index| self.values[index] = 0.0);
            self.known = rotary;
        }
    }
}
