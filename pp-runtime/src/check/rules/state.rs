//! Modal state of a block, compared with the one that the CL data and the safe sequence require.

use std::fmt::Display;

use super::super::expect::{Required, SpindleState};
use super::super::policy::{CheckPolicy, LinearMeaning};
use super::super::read::{
    Action, Block, Facts, FeedMode, LeftOver, Length, LineForm, PathSmoothing, RolloverRule, SideOfPath, State,
    TipControl, WorkOffset, WorkPlane, settled,
};
use super::{Rules, apart};
use crate::check::tolerances::{ROUNDED_SPEED, ROUNDED_WORD};
use crate::diag::Code;
use crate::diag::code::check;
use crate::program::Location;
use crate::set_up::{LengthMode, SetUp};

/// A wrong state.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct StateFault {
    pub(crate) code: Code,
    pub(crate) text: String,
    /// The record that calls the tool, if the tool is wrong.
    pub(crate) called: Option<Location>,
    /// What a line of the program has set to a wrong value.
    pub(crate) set: Option<StateItem>,
}

/// Part of the state of a control that a line sets.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum StateItem {
    WorkOffset,
    Length,
    RadiusRegister,
    Spindle,
    Speed,
}

impl StateItem {
    pub(crate) const ALL: [Self; 5] =
        [Self::WorkOffset, Self::Length, Self::RadiusRegister, Self::Spindle, Self::Speed];

    /// Whether two states differ in it.
    pub(crate) fn differs(self, one: &State, other: &State) -> bool {
        match self {
            Self::WorkOffset => one.work_offset != other.work_offset,
            Self::Length => one.length != other.length,
            Self::RadiusRegister => one.diameter != other.diameter,
            Self::Spindle => one.spindle != other.spindle,
            Self::Speed => one.speed != other.speed,
        }
    }
}

/// Work offset and length compensation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct OffsetsInForce {
    work_offset: Option<WorkOffset>,
    length: Option<Length>,
}

impl OffsetsInForce {
    /// Those of a state; tip control may have cancelled the work offset.
    pub(crate) fn of(state: &State) -> Self {
        Self { work_offset: state.work_offset.or(state.cancelled_offset), length: state.length }
    }

    /// What is wrong where others are in force although nothing moves any more; compensation may be switched off, or as
    /// `called`.
    fn changed(self, now: Self, called: Option<Length>) -> Option<StateFault> {
        if let Some((before, now)) = self.work_offset.zip(now.work_offset)
            && before != now
        {
            let text =
                format!("the program ends with work offset {now}, and {before} was in force at its last retract");
            return Some(StateFault::from(text).set_by(StateItem::WorkOffset, true));
        }
        let Some(Length::Register(register)) = now.length.filter(|_| now.length != self.length && now.length != called)
        else {
            return None;
        };
        let text = format!("the program ends with length compensation by register {register}");
        Some(StateFault::from(text).set_by(StateItem::Length, true))
    }
}

/// Frame that the linear words of a block need.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum FrameUse {
    /// None: no tip control, no plane.
    Without,
    /// That of their meaning.
    AsMeant,
    /// Any in which tip control is off: the axes across the retract axis come first to the place where it begins.
    BeforeTipControl,
}

/// Circumstances of a block on which its modal state depends, besides the CL data.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct ModalContext {
    /// Plane of the last arc, where it may still be selected.
    pub(crate) arc_plane: Option<WorkPlane>,
    /// No plane need be selected yet.
    pub(crate) no_plane: bool,
    /// F may be per revolution: that of a thread is compared with its cycle.
    pub(crate) in_thread: bool,
    /// Coolant must be off.
    pub(crate) dry: bool,
}

impl Rules<'_> {
    /// At the part, on the path of the CL data.
    pub(crate) fn fault_at_path(
        &self,
        block: &Block,
        required: &Required,
        context: ModalContext,
    ) -> Option<StateFault> {
        let state = &block.state;
        let found = self.fault_in_cut(block, required, context);
        self.tool_first(found, state, required)
    }

    /// At the part, on the path of the CL data, without the tool.
    pub(crate) fn fault_in_cut(&self, block: &Block, required: &Required, context: ModalContext) -> Option<StateFault> {
        let (state, context) = (&block.state, ModalContext { in_thread: block.action.is_thread(), ..context });
        let offset_path = required.side != SideOfPath::None;
        let side = if offset_path && self.is_mirrored(block) { required.side.across() } else { required.side };
        self.everywhere(state, side, context)
            .or_else(|| if matches!(block.action, Action::Arc(_)) { self.centres(state) } else { None })
            .or_else(|| if block.action.is_rapid() { inverse_time(state) } else { None })
            .or_else(|| self.frame(block, FrameUse::AsMeant))
            .or_else(|| self.meaning_of_operation(block, required))
            .map(StateFault::from)
            .or_else(|| self.offsets(state, required, true))
            .or_else(|| if offset_path { self.radius_register(state, required) } else { None })
            .or_else(|| if offset_path { self.radius_delta(state, required).map(StateFault::from) } else { None })
            .or_else(|| in_each_order(block, |state| spindle(state, self.spindle_in_cut(required))))
            .or_else(|| in_each_order(block, |state| coolant(state, required.coolant)))
    }

    /// Whether the state of a cut is right or wrong whatever block has it.
    pub(crate) fn is_judged_by_state(&self, block: &Block, required: &Required) -> bool {
        let state = &block.state;
        let on_path = matches!(block.action, Action::Feed | Action::Arc(_));
        let in_plane = state.plane == Some(WorkPlane::Xy) && required.side == SideOfPath::None;
        let centres = !self.facts.modal_centres || state.absolute_centres == Some(false);
        on_path && in_plane && centres && !state.has_frame() && self.meaning == LinearMeaning::AxisPositions
    }

    /// What is wrong with the centres of arcs, where a program before may have left them absolute.
    fn centres(&self, state: &State) -> Option<String> {
        let absolute = state.absolute_centres;
        // Where the program may be entered it is stated after the restart point.
        let stated = absolute.is_some() && state.settled & settled::CENTRES != 0;
        let unsure = !stated && !self.policy.shop.own_safety;
        let since = || state.since_lost(absolute.is_none());
        (self.facts.modal_centres && (unsure || absolute == Some(true))).then(|| {
            format!("centres of arcs are absolute (G90.1 is active), or G91.1 has not been programmed{}", since())
        })
    }

    /// In a step of the approach; `last`: to the approach point.
    pub(crate) fn fault_at_approach(
        &self,
        block: &Block,
        required: &Required,
        frame: FrameUse,
        last: bool,
        context: ModalContext,
    ) -> Option<StateFault> {
        let state = &block.state;
        let framed = frame != FrameUse::Without;
        let found = self
            .everywhere(state, SideOfPath::None, context)
            .or_else(|| inverse_time(state))
            .or_else(|| self.frame(block, frame))
            .map(StateFault::from)
            .or_else(|| {
                // Rotary axes rotate before the work offset is selected again that tip control may have cancelled.
                let cancelled = self.facts.tip_control_may_cancel_offset && state.work_offset.is_none();
                match cancelled && !framed {
                    true => None,
                    false => self.offsets(state, required, last || !self.facts.length_moves),
                }
            })
            .or_else(|| in_each_order(block, |state| spindle(state, self.spindle_in_cut(required))))
            .or_else(|| if context.dry { in_each_order(block, |state| coolant(state, 0)) } else { None });
        self.tool_first(found, state, required)
    }

    /// In the retract along the tool axis.
    pub(crate) fn fault_at_leave(
        &self,
        block: &Block,
        required: Option<&Required>,
        context: ModalContext,
    ) -> Option<StateFault> {
        let state = &block.state;
        let found = self
            .everywhere(state, SideOfPath::None, context)
            .or_else(|| inverse_time(state))
            .or_else(|| self.frame(block, FrameUse::AsMeant))
            .map(StateFault::from)
            .or_else(|| required.and_then(|required| self.offsets(state, required, true)))
            .or_else(|| if context.dry { in_each_order(block, |state| coolant(state, 0)) } else { None });
        match required {
            Some(required) => self.tool_first(found, state, required),
            None => found,
        }
    }

    /// At the end code: the modes in which the next program, or the operator, finds the control. `offsets`: those
    /// before it that are right; `register`: that of the last motion.
    pub(crate) fn fault_in_modes(
        &self,
        state: &State,
        offsets: Option<OffsetsInForce>,
        register: Option<u32>,
    ) -> Option<StateFault> {
        // Where a call moves nothing, the length is in force again after the retract.
        let called = register.filter(|_| !self.facts.length_moves).map(Length::Register);
        // Where the tool call names the plane, blocks that may be skipped may have called the tool.
        let context = ModalContext { no_plane: true, ..ModalContext::default() };
        self.everywhere(state, SideOfPath::None, context)
            .or_else(|| inverse_time(state))
            .or_else(|| {
                (state.tip_control != TipControl::Off).then(|| "tip control is still on at the end code".to_owned())
            })
            .or_else(|| {
                (state.smoothing != PathSmoothing::Off).then(|| "smoothing is still on at the end code".to_owned())
            })
            .map(StateFault::from)
            .or_else(|| offsets?.changed(OffsetsInForce::of(state), called))
    }

    /// At the retract, after a motion or before one: its work offset is in force.
    pub(crate) fn fault_in_offset(&self, state: &State, last: &Required) -> Option<StateFault> {
        // One that tip control may have cancelled may be in force as well.
        let work_offset = state.work_offset.or(state.cancelled_offset);
        self.offsets(&State { work_offset, ..*state }, last, false)
    }

    /// At a position of the machine; `tilts`: the frame of a plane may still be in force; `spindle_on`: the state in
    /// which the spindle may be.
    pub(crate) fn fault_at_retract(
        &self,
        block: &Block,
        tilts: bool,
        spindle_on: Option<SpindleState>,
        context: ModalContext,
    ) -> Option<StateFault> {
        // The block of a reference position has distances, G91.
        let distances = block.action == Action::Reference { direct: true };
        let state =
            &State { incremental: if distances { Some(false) } else { block.state.incremental }, ..block.state };
        let tip_control = (state.tip_control != TipControl::Off)
            .then(|| StateFault::from("machine coordinates are programmed while tip control is on".to_owned()));
        let coordinate = block.action == Action::Machine;
        let length = (coordinate && self.facts.length_off_at_machine_coordinates && state.length != Some(Length::Off))
            .then(|| {
                StateFault::from(
                    "machine coordinates are programmed before length compensation is switched off".to_owned(),
                )
            });
        self.everywhere(state, SideOfPath::None, context)
            .or_else(|| inverse_time(state))
            .map(StateFault::from)
            .or(tip_control)
            .or_else(|| moved_zero(state).or_else(|| tilted(state)).filter(|_| !tilts).map(StateFault::from))
            .or(length)
            .or_else(|| in_each_order(block, |state| spindle(state, spindle_on)))
            .or_else(|| if context.dry { in_each_order(block, |state| coolant(state, 0)) } else { None })
    }

    /// Rotary axes to their parking positions. `last`: the state of the last motion, whose work offset is in force.
    pub(crate) fn fault_at_park(
        &self,
        block: &Block,
        last: Option<&Required>,
        context: ModalContext,
    ) -> Option<StateFault> {
        self.everywhere(&block.state, SideOfPath::None, context)
            .or_else(|| self.frame(block, FrameUse::Without))
            .map(StateFault::from)
            .or_else(|| last.and_then(|last| self.fault_in_offset(&block.state, last)))
            .or_else(|| still_on(block))
    }

    /// What is wrong with the state that a plane, or a zero that follows the table, captures: that of the motions after
    /// it.
    pub(crate) fn fault_at_capture(&self, block: &Block, required: &Required) -> Option<StateFault> {
        let incremental = block.state.incremental == Some(true);
        incremental
            .then(|| StateFault::from("G91 is in force where a plane is tilted"))
            .or_else(|| self.offsets(&block.state, required, false))
    }

    /// What is wrong with the state in which blocks of the shop measure: with a probe at its point after a motion of
    /// this state, or the tool at the machine retract. `at`: their block, as if it did nothing.
    pub(crate) fn fault_at_measuring(
        &self,
        at: &Block,
        probed: Option<&Required>,
        required: Option<&Required>,
    ) -> Option<StateFault> {
        let context = ModalContext { no_plane: probed.is_none(), ..ModalContext::default() };
        let frame = if probed.is_some() { FrameUse::AsMeant } else { FrameUse::Without };
        let before = &at.state;
        let wet = before.coolant_is_on();
        self.everywhere(before, SideOfPath::None, context)
            .or_else(|| inverse_time(before))
            .or_else(|| self.frame(at, frame))
            .or_else(|| {
                (before.smoothing != PathSmoothing::Off).then(|| "smoothing is on where blocks measure".to_owned())
            })
            .or_else(|| wet.then(|| "the coolant is on where blocks measure".to_owned()))
            .map(StateFault::from)
            .or_else(|| match probed {
                Some(probed) => self.offsets(before, probed, true),
                None => self.fault_in_offset(before, required?),
            })
    }

    /// Whether the spindle is in a state.
    pub(crate) fn spindle_is(&self, state: &State, required: Option<SpindleState>) -> bool {
        spindle(state, required).is_none()
    }

    /// State of the spindle in a cut; a dry run has it off.
    pub(crate) fn spindle_in_cut(&self, required: &Required) -> Option<SpindleState> {
        required.spindle.filter(|_| self.policy.links.dry_lift_mm.is_none())
    }

    /// A wrong tool is reported first, where the CL data calls the right one: other faults may follow from it.
    fn tool_first(&self, found: Option<StateFault>, state: &State, required: &Required) -> Option<StateFault> {
        if state.tool == required.tool {
            return found;
        }
        let text = format!("{} is in the spindle, expected {}", tool_name(state.tool), tool_name(required.tool));
        Some(StateFault { code: check::TOOL, text, called: required.called, set: None })
    }

    /// State of every block that moves.
    fn everywhere(&self, state: &State, side: SideOfPath, context: ModalContext) -> Option<String> {
        if state.units != Some(self.units) {
            return Some(format!(
                "the program is not in {}: the unit code before this block is missing or wrong{}",
                self.units.name(),
                state.since_lost(state.units.is_none())
            ));
        }
        if state.incremental != Some(false) {
            let since = state.since_lost(state.incremental.is_none());
            return Some(format!("incremental mode (G91) is active, or G90 has not been programmed{since}"));
        }
        let unselected = context.no_plane && self.facts.plane_by_tool_call && state.plane.is_none();
        let of_arc = state.plane.is_some() && state.plane == context.arc_plane;
        if state.plane != Some(WorkPlane::Xy) && !unselected && !of_arc {
            return Some(format!("the working plane is not XY{}", state.since_lost(state.plane.is_none())));
        }
        if state.side_unknown && !self.policy.shop.own_safety {
            return Some(
                "cutter compensation may be on after the blocks that measure: G40 has not been programmed".to_owned(),
            );
        }
        if state.side.unwrap_or_default() != side {
            return Some(format!(
                "cutter compensation is {}, expected {}",
                state.side.unwrap_or_default().name(),
                side.name()
            ));
        }
        let owed = self.owed(state);
        if state.settled & owed != owed {
            return self.not_settled(state);
        }
        let selects = self.facts.rotary_path_selected && !self.policy.shop.own_safety;
        if selects && !state.shortest_stated {
            return Some("the direction of rotary axes (M126, M127) has not been programmed".to_owned());
        }
        let shorter = self.policy.words.rollover.values().any(|rollover| *rollover == RolloverRule::Shortest);
        if selects && !state.shortest && shorter {
            return Some("rotary axes do not take the shorter way, but their words are reduced to 360".to_owned());
        }
        if state.shortest && !shorter {
            return Some(
                "rotary axes take the shorter way (M126), but their words give the position and the direction"
                    .to_owned(),
            );
        }
        let per_revolution = state.feed_mode == Some(FeedMode::PerRevolution) && !context.in_thread;
        if per_revolution || state.feed_mode.is_none() {
            let code = if self.facts.form == LineForm::Statements { "M137" } else { "G94" };
            let since = state.since_lost(state.feed_mode.is_none());
            return Some(format!("feed mode is not per minute ({code}){since}"));
        }
        None
    }

    /// Bits of what a restart point must have ended: what every control may have left, and frames that the program has
    /// used, since it may be entered after a stop in one.
    #[inline]
    fn owed(&self, state: &State) -> u32 {
        let frames = self.frames_used | frame_bits(state);
        if self.policy.shop.own_safety { self.left_over } else { self.left_over | frames }
    }

    /// Frames that a restart point has not ended, of those that the control may have: bits.
    pub(crate) fn frames_not_ended(&self, state: &State) -> u32 {
        let frames = settled::PLANE | settled::DYNAMIC_OFFSET;
        if self.policy.shop.own_safety { 0 } else { frames & !state.settled }
    }

    /// What is wrong with a restart point that has not ended these frames, as the program uses one of them after it.
    pub(crate) fn fault_before_frames(&self, not_ended: u32) -> Option<String> {
        let left = self.facts.left_over.iter().find(|left| left.bit & not_ended & self.frames_used != 0)?;
        let LeftOver { what, code, .. } = left;
        Some(format!("{what} is used later in the program, and this restart point does not end it: {code} is missing"))
    }

    /// What a program before may have left, and this one has not ended.
    fn not_settled(&self, state: &State) -> Option<String> {
        let owed = self.owed(state);
        let is_missing = |left: &&LeftOver| left.bit & owed & !state.settled != 0;
        let LeftOver { what, code, .. } = self.facts.left_over.iter().find(is_missing)?;
        let since = state.since_lost(true);
        Some(format!(
            "{what} may be on from a program before: {code} has not been programmed at the restart point of this operation{since}"
        ))
    }

    /// Tip control, tilted plane and dynamic work offset, as the linear words require.
    fn frame(&self, block: &Block, frame: FrameUse) -> Option<String> {
        use LinearMeaning::{PlaneCoordinates, TipCoordinates};
        let (state, framed) = (&block.state, frame == FrameUse::AsMeant);
        if frame == FrameUse::BeforeTipControl {
            return state
                .tilt
                .filter(|tilt| !tilt.oriented)
                .map(|_| "a tilted plane is active, but the rotary axes have not been positioned to it".to_owned());
        }
        if let Some(fault) = self.dynamic_offset_fault.filter(|_| state.dynamic_offset) {
            return Some(fault.to_owned());
        }
        if state.dynamic_offset && !(framed && self.meaning == PlaneCoordinates) {
            return Some(
                "the dynamic work offset (G254) is active, but words are not counted from its zero".to_owned(),
            );
        }
        let tip_control = state.tip_control != TipControl::Off;
        let tilted = state.tilt.is_some();
        match (self.meaning, framed) {
            (TipCoordinates, true) if !tip_control => {
                Some("tip control is off, but linear words are tip coordinates".to_owned())
            }
            // With the rotary axes at zero these are coordinates in a plane that is not tilted.
            (PlaneCoordinates, true) if !tilted && self.are_at_zero(block) => None,
            (PlaneCoordinates, true) if state.dynamic_offset && !tilted && !tip_control => None,
            (PlaneCoordinates, true) if !tilted => {
                Some("no plane is active, but linear words are coordinates in one".to_owned())
            }
            (PlaneCoordinates, true) if state.tilt.is_some_and(|tilt| !tilt.oriented) => {
                Some("a tilted plane is active, but the rotary axes have not been positioned to it".to_owned())
            }
            (words, framed) if tip_control && !(framed && words == TipCoordinates) => {
                Some("tip control is on, but words are axis positions".to_owned())
            }
            (words, framed) if tilted && !(framed && words == PlaneCoordinates) => {
                Some("a tilted plane is active, but words are axis positions".to_owned())
            }
            (TipCoordinates, true)
                if self.policy.words.tool_axis_vectors && block.written & self.words.rotary_bits() != 0 =>
            {
                Some("rotary words where the program gives the tool axis by its components".to_owned())
            }
            (TipCoordinates, true) => self.tool_axis_interpolation(state),
            _ => None,
        }
    }

    /// Meaning of linear words, where the operation has its own.
    fn meaning_of_operation(&self, block: &Block, required: &Required) -> Option<String> {
        let expected = required.linear?;
        // With the rotary axes at zero axis positions are coordinates in a plane that is not tilted.
        let untilted = expected == LinearMeaning::PlaneCoordinates
            && self.meaning == LinearMeaning::AxisPositions
            && self.are_at_zero(block);
        (self.meaning != expected && !untilted).then(|| {
            format!("linear words are {}, expected {} in this operation", self.meaning.name(), expected.name())
        })
    }

    /// Whether every rotary axis is known to be at zero, or whole revolutions from it.
    pub(crate) fn are_at_zero(&self, block: &Block) -> bool {
        let bits = self.words.rotary_bits();
        let values = self.words.values(&block.values);
        let zero = |index: usize| apart(values[index], 0.0) <= 0.5 * self.rounding.unit_rad;
        block.known & bits == bits && self.words.rotary().all(zero)
    }

    /// Motion of the tool axis between the ends of a block, where the program selects it.
    fn tool_axis_interpolation(&self, state: &State) -> Option<String> {
        let words = &self.policy.words;
        if words.own_tip_codes {
            return None;
        }
        if !words.posture_word {
            return state.in_plane.map(|_| {
                "interpolation of the tool axis is programmed (P), expected the setting of the control".to_owned()
            });
        }
        if self.facts.tool_axis_interpolation && state.in_plane != Some(words.axis_in_plane) {
            let expected = match words.axis_in_plane {
                true => "the plane through the first and the last tool axis",
                false => "even motion of the rotary axes",
            };
            return Some(format!("interpolation of the tool axis: expected {expected}, which is not programmed"));
        }
        let in_workpiece = words.axis_in_plane || words.tool_axis_vectors;
        (self.facts.tool_axis_frame && state.in_workpiece != Some(in_workpiece)).then(|| {
            let frame = if in_workpiece { "workpiece" } else { "machine" };
            format!("tool axis: expected interpolation in the {frame} frame, which is not programmed")
        })
    }

    /// Work offset; `length`: length compensation, too.
    fn offsets(&self, state: &State, required: &Required, length: bool) -> Option<StateFault> {
        let offset = self.offsets.iter().find(|(set_up, _)| *set_up == required.set_up).map(|(_, offset)| *offset);
        if state.work_offset != offset {
            let text = format!("work offset is {}, expected {}", shown(state.work_offset), shown(offset));
            return Some(StateFault::from(text).set_by(StateItem::WorkOffset, state.work_offset.is_some()));
        }
        if !length {
            return None;
        }
        let register = match (self.policy.set_up.length_mode, required.tool) {
            (LengthMode::Gauge, _) => Length::Off,
            (LengthMode::Tip, Some(_)) => Length::Register(required.register),
            (LengthMode::Tip, None) => return None,
        };
        if state.length.unwrap_or(Length::Off) != register {
            let text = format!("length compensation is {}, expected {register}", shown(state.length));
            let is_set = matches!(state.length, Some(Length::Register(_)));
            return Some(StateFault::from(text).set_by(StateItem::Length, is_set));
        }
        None
    }

    /// DR of the tool call, where it has to take the radius off, or must not.
    fn radius_delta(&self, state: &State, required: &Required) -> Option<String> {
        if !self.facts.radius_delta {
            return None;
        }
        let centre = self.policy.shop.compensated_centre;
        let Some(expected) = (if centre { required.radius_mm.map(|radius| -radius) } else { Some(0.0) }) else {
            return Some("the radius of the tool is unknown, and DR must take it off".to_owned());
        };
        let right = |delta: f64| (delta - expected).abs() <= ROUNDED_WORD * self.rounding.unit_mm;
        (!state.radius_delta_mm.is_some_and(right)).then(|| match state.radius_delta_mm {
            Some(delta) => {
                format!("DR of the tool call is {}, expected {}", self.units.length(delta), self.units.length(expected))
            }
            None => {
                let expected = self.units.length(expected);
                format!("DR of the tool call is unknown after a call with S alone, expected {expected}")
            }
        })
    }

    /// Register of the tool radius. A cutting edge, and a row of the tool table, have the radius with the length.
    fn radius_register(&self, state: &State, required: &Required) -> Option<StateFault> {
        (self.facts.radius_registers && state.diameter != Some(required.radius_register)).then(|| {
            let register = state.diameter.map(|register| format!("D{register}"));
            let text = format!("radius register is {}, expected D{}", shown(register), required.radius_register);
            StateFault::from(text).set_by(StateItem::RadiusRegister, state.diameter.is_some())
        })
    }
}

impl From<String> for StateFault {
    fn from(text: String) -> Self {
        Self { code: check::STATE, text, called: None, set: None }
    }
}

impl From<&str> for StateFault {
    fn from(text: &str) -> Self {
        text.to_owned().into()
    }
}

impl StateFault {
    /// The fault of what a line has set, if it is a wrong value and no other state is missing.
    fn set_by(self, item: StateItem, is_set: bool) -> Self {
        Self { set: is_set.then_some(item), ..self }
    }
}

/// At a stop with a retract, and at the end code.
pub(crate) fn fault_at_end(block: &Block) -> Option<StateFault> {
    still_on(block).or_else(|| tilted(&block.state).or_else(|| moved_zero(&block.state)).map(StateFault::from))
}

/// Spindle or coolant where both must be off.
fn still_on(block: &Block) -> Option<StateFault> {
    in_each_order(block, |state| spindle(state, None).or_else(|| coolant(state, 0)))
}

/// What is wrong with a state in which a block moves, whether its functions act before its motion or after it.
fn in_each_order(block: &Block, fault: impl Fn(&State) -> Option<StateFault>) -> Option<StateFault> {
    fault(&block.state).or_else(|| {
        let StateFault { code, text, .. } = fault(block.early.as_deref()?)?;
        let text = format!("{text}, where the machine executes the functions of this block after its motion");
        Some(StateFault { code, text, called: None, set: None })
    })
}

fn shown<T: Display>(value: Option<T>) -> String {
    value.map_or_else(|| "not programmed".to_owned(), |value| value.to_string())
}

fn tilted(state: &State) -> Option<String> {
    state.tilt.map(|_| "a tilted plane is still active at the retract position".to_owned())
}

fn moved_zero(state: &State) -> Option<String> {
    state.dynamic_offset.then(|| "the dynamic work offset (G254) is still active".to_owned())
}

fn inverse_time(state: &State) -> Option<String> {
    (state.feed_mode == Some(FeedMode::InverseTime)).then(|| "rapid while inverse-time feed (G93) is active".to_owned())
}

fn spindle(state: &State, required: Option<SpindleState>) -> Option<StateFault> {
    let rotation = state.spindle.flatten();
    match required {
        None => rotation.map(|_| StateFault::from("spindle is on, expected off")),
        Some((_, sense)) if rotation != Some(sense) => Some(match rotation {
            None => "spindle is off, expected on".into(),
            Some(_) => StateFault::from("spindle rotates in the wrong direction").set_by(StateItem::Spindle, true),
        }),
        Some((speed, _)) => match state.speed {
            Some(written) if (written - speed).abs() <= ROUNDED_SPEED * speed => None,
            written => {
                let fault = StateFault::from(format!("S is {}, expected {speed}", shown(written)));
                Some(fault.set_by(StateItem::Speed, written.is_some()))
            }
        },
    }
}

fn coolant(state: &State, required: u8) -> Option<StateFault> {
    let text = match state.coolant {
        Some(on) if on == required => return None,
        Some(_) if required == 0 => "coolant is on, expected off",
        None => "coolant state is unknown: neither on nor off has been programmed before this block",
        Some(_) => "coolant differs from that of the CL data (COOLNT)",
    };
    Some(text.into())
}

/// A tool in a message.
pub(crate) fn tool_name(tool: Option<u32>) -> String {
    tool.map_or("no tool".to_owned(), |number| format!("T{number}"))
}

/// What must be ended at each restart point; safety lines of the shop are its own affair.
pub(super) fn left_over(policy: &CheckPolicy, facts: &Facts) -> u32 {
    let shop = &policy.shop;
    let asked = facts.left_over.iter().filter(|left| !shop.own_safety && left.of.is_in(shop.functions.as_deref()));
    asked.fold(0, |bits, left| bits | left.bit)
}

/// Bits of the frames in force.
pub(super) fn frame_bits(state: &State) -> u32 {
    let plane = if state.tilt.is_some() { settled::PLANE } else { 0 };
    plane | if state.dynamic_offset { settled::DYNAMIC_OFFSET } else { 0 }
}

/// The work offset of each set-up.
pub(super) fn offsets(set_up: &SetUp, facts: &Facts) -> Vec<(u32, WorkOffset)> {
    set_up.clampings().filter_map(|(number, part)| Some((number, offset(part.work_offset, facts)?))).collect()
}

/// `G54`, `G59.1`, `G505`, `G54.1 P3`, `G154 P2`; or a row of the preset table.
fn offset(word: &str, facts: &Facts) -> Option<WorkOffset> {
    let word = word.trim();
    if facts.offset_rows {
        let row = match word.strip_prefix('G') {
            Some(code) => code.parse::<u32>().ok()?.checked_sub(53)?,
            None => word.parse().ok()?,
        };
        return Some(WorkOffset::Row(row));
    }
    if let Some(further) = word.strip_prefix("G54.1 P").or(word.strip_prefix("G154 P")) {
        return further.parse().ok().map(WorkOffset::Further);
    }
    let code: f64 = word.strip_prefix('G')?.parse().ok()?;
    Some(WorkOffset::Code((code * 10.0).round() as u32))
}
