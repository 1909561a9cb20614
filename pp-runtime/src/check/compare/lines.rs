//! Before a block is compared: lines of the shop, guards, complete states, and changes that must not happen at the
//! part.

use super::super::expect::{ExpectedAction, ExpectedItem};
use super::super::policy::LinearMeaning;
use super::super::read::{Action, Block, Effect, Length, LineForm, OwnLine, OwnPlace, State, coolant, stated};
use super::functions::place_of_line;
use super::obligations::{Duty, DutyEvent, DutyPlace};
use super::phase::Phase;
use super::{Comparison, Current, plane_guard};
use crate::check::tolerances::SHORT_SPINDLE_DWELL;
use crate::diag::code::check;

/// Coolant through the spindle, with any pressure: bits.
const THROUGH: u8 = coolant::THROUGH | coolant::PRESSURES[0] | coolant::PRESSURES[1] | coolant::PRESSURES[2];

impl Comparison<'_> {
    /// Changes of state that must not happen at the part.
    pub(super) fn before_task(&mut self, phase: &mut Phase, current: &Current<'_>) {
        let block = current.block;
        // A stop of the CL data, though the shop has the same in its lines.
        let is_of_cl = matches!(block.action, Action::Stop | Action::OptionalStop)
            && matches!(self.progress.next(), Some(ExpectedItem { action: ExpectedAction::Stop { optional }, .. })
                if *optional == (block.action == Action::OptionalStop));
        if let Some(own) = &block.own {
            self.own_line(own, is_of_cl, phase, current);
        }
        let is_line = !is_of_cl && !block.goes_on;
        if is_line && (!phase.is_at_part() || !current.block.action.moves()) {
            let of_another = self.shop_lines.note(current.shown.text, block.state.tool);
            self.found_any(current, check::SHOP_LINE, of_another);
        }
        if !block.only_moves {
            self.guards_and_restart(phase, current);
        }
        if !current.same_modes {
            self.follow_spindle(block, phase.is_at_part(), current);
            self.modes_before_task(phase, current);
        }
        if block.action.cuts() {
            self.come_to_cut(DutyPlace::Feed, current);
        }
    }

    /// Notes what a block has done to the spindle.
    fn follow_spindle(&mut self, block: &Block, at_part: bool, current: &Current<'_>) {
        let (rotation, stated) = (block.state.spindle.flatten(), block.stated & stated::SPINDLE != 0);
        let first = !std::mem::replace(&mut self.previous.process.stated, stated) && stated;
        let before = std::mem::replace(&mut self.previous.process.rotation, rotation);
        if stated {
            self.duties.happens(DutyEvent::SpindleStated);
        }
        if self.rules.facts().stops_spindle(&block.action) {
            self.duties.happens(DutyEvent::CycleStopsSpindle);
        }
        if rotation.is_none() {
            self.duties.happens(DutyEvent::SpindleOff);
        } else if first || rotation != before {
            self.duties.happens(DutyEvent::SpindleStarts);
        }
        self.switched_twice(block, at_part, current);
        let dwell = self.rules.policy().links.spindle_dwell_s;
        self.previous.process.waits = self.duties.owes(Duty::SpindleDwell);
        if matches!(block.action, Action::Dwell(seconds) if seconds >= dwell - SHORT_SPINDLE_DWELL) {
            self.duties.happens(DutyEvent::SpindleWaited);
        }
    }

    /// Spindle and coolant are switched for a motion, or a wait; at the part the CL data may switch them without one.
    fn switched_twice(&mut self, block: &Block, at_part: bool, current: &Current<'_>) {
        let (before, now) = (&self.setters.at_block, &block.state);
        // In statements the speed has a line of its own.
        let speeds = self.rules.facts().form != LineForm::Statements;
        let runs = |state: &State| state.spindle.flatten().map(|rotation| (rotation, state.speed.filter(|_| speeds)));
        let on = |state: &State| state.coolant.filter(|on| *on != 0);
        let changes = [runs(before) != runs(now), on(before) != on(now)];
        let is_on = [runs(now).is_some(), on(now).is_some()];
        let known =
            [before.spindle.is_some() && now.spindle.is_some(), before.coolant.is_some() && now.coolant.is_some()];
        for (index, what) in ["spindle", "coolant"].into_iter().enumerate() {
            if !changes[index] {
                continue;
            }
            let stops = matches!(block.action, Action::ToolChange | Action::End);
            let twice =
                self.previous.process.switched[index] && known[index] && block.own.is_none() && !at_part && !stops;
            // Further kinds of coolant may come on.
            if twice && (index == 0 || !is_on[index]) {
                self.found(
                    current,
                    check::SHOP_LINE,
                    &format!("the {what} has been switched on before, and nothing has moved or waited since"),
                );
            }
            self.previous.process.switched[index] = is_on[index] && block.own.is_none();
            self.previous.process.started |= index == 0 && is_on[index];
        }
        if matches!(block.action, Action::Dwell(_) | Action::Stop | Action::OptionalStop) {
            self.previous.process.switched = [false; 2];
        }
    }

    /// A line that the user brought in; `is_of_cl`: it is the stop of the CL data.
    #[inline(never)]
    fn own_line(&mut self, own: &OwnLine, is_of_cl: bool, phase: &Phase, current: &Current<'_>) {
        self.functions.line(&own.places);
        let switches = current.block.state.clamped != self.setters.at_block.clamped;
        if switches && own.places.iter().any(|place| !matches!(place, OwnPlace::Clamp { .. })) {
            self.functions.forget_clamps();
        }
        if own.places.contains(&OwnPlace::TipControl { on: false }) {
            self.duties.happens(DutyEvent::TipControlOff);
        }
        let ended = self.progress.next().is_none();
        let misplaced = place_of_line(&own.places, phase, self.tally.motions(), ended);
        self.found_any(current, check::SHOP_LINE, misplaced.filter(|_| !is_of_cl));
        self.begins_operation(own, is_of_cl, current);
        let register = self.progress.next().map(|item| item.required.register);
        let of_another = self.shop_lines.values_fault(own, current.block.state.tool, register);
        self.found_any(current, check::SHOP_LINE, of_another);
        self.measures_at_tool_position(own, current);
        if !is_of_cl {
            if own.needs_standstill {
                self.come_to(DutyPlace::Standstill, Some(phase), current);
            }
            self.ends_tool(own, current);
        }
        if needs_retract(own) {
            self.duties.happens(DutyEvent::ShopLine);
        }
    }

    /// A line of the shop for a tool that has cut comes after the records of that tool, and before it is looked at for
    /// breakage.
    fn ends_tool(&mut self, own: &OwnLine, current: &Current<'_>) {
        let of_end = |place: &OwnPlace| matches!(place, OwnPlace::ToolEnd { .. } | OwnPlace::CheckTool);
        if !own.places.iter().all(of_end) {
            return;
        }
        let before = &self.setters.at_block;
        if before.spindle_is_on() || before.coolant_is_on() {
            self.found(
                current,
                check::SHOP_LINE,
                "the spindle or the coolant is on where blocks end the work of a tool",
            );
        }
        let tool = self.previous.tools.current;
        let is_record = |item: &ExpectedItem| {
            let record = matches!(
                item.action,
                ExpectedAction::Stop { .. }
                    | ExpectedAction::Dwell { .. }
                    | ExpectedAction::Raw(_)
                    | ExpectedAction::Probe { .. }
                    | ExpectedAction::Home { .. }
            );
            record && item.required.tool == tool
        };
        if tool.is_some() && self.progress.next().is_some_and(is_record) {
            self.found(
                current,
                check::SHOP_LINE,
                "this line ends the work of its tool, and a record of the CL data with that tool comes after it",
            );
        }
        let ends = own.places.iter().any(|place| matches!(place, OwnPlace::ToolEnd { .. }));
        if ends && self.shop_lines.has_been_checked(tool) {
            self.found(
                current,
                check::SHOP_LINE,
                "this line ends the work of its tool, and the tool has been checked for breakage before it",
            );
        }
    }

    /// A line of the shop for the start of an operation comes after its complete state, its tool change and the
    /// retract.
    fn begins_operation(&mut self, own: &OwnLine, is_of_cl: bool, current: &Current<'_>) {
        let of_start = |place: &OwnPlace| {
            matches!(place, OwnPlace::OperationStart | OwnPlace::ToolStart { .. } | OwnPlace::MeasureTool)
        };
        let ends = own.places.iter().all(|place| *place == OwnPlace::OperationEnd);
        if ends && !is_of_cl && !self.duties.owes(Duty::CompleteState) {
            self.found(
                current,
                check::SHOP_LINE,
                "this line ends an operation, and comes after the complete state of the next one",
            );
        }
        if is_of_cl || !own.places.iter().all(of_start) {
            return;
        }
        let starts_tool = |place: &OwnPlace| *place != OwnPlace::MeasureTool;
        let runs = current.block.stated & stated::SPINDLE != 0 && current.block.state.spindle_is_on();
        // It runs for a dwell of the CL data, and is programmed again.
        let waits = self.functions.waits_with().is_some();
        if runs && !waits && own.places.iter().all(starts_tool) {
            self.found(current, check::SHOP_LINE, "this line comes after the spindle of its operation has started");
        }
        let of_operation = own.places.iter().all(|place| *place == OwnPlace::OperationStart);
        if of_operation && self.shop_lines.is_tool_start_due(current.block.state.tool) {
            self.found(current, check::SHOP_LINE, "this line comes before those that start the work of its tool");
        }
        if self.functions.is_guarded() {
            self.found(
                current,
                check::SHOP_LINE,
                "this line comes after the guard of the tool length of its operation",
            );
        }
        let owes = |what| self.duties.owes(what);
        // A line before it may have lost the retract.
        let begun = (!owes(Duty::Retract) || owes(Duty::RetractAfterShopLine))
            && (!owes(Duty::CompleteState) || self.rules.policy().shop.own_safety);
        let tool = current.block.state.tool;
        let other = if self.previous.tools.has_changed {
            tool.is_some() && tool != self.tool_due()
        } else {
            self.tool_due().is_some()
        };
        if !begun || other {
            self.found(
                current,
                check::SHOP_LINE,
                "this line comes before the complete state, the tool change or the retract of its operation",
            );
        }
    }

    /// The rules of a block with codes: the complete state, a restart, and values that the control compares.
    fn guards_and_restart(&mut self, phase: &mut Phase, current: &Current<'_>) {
        let block = current.block;
        if block.restart {
            // Tip control ends with the safety line, if it is still on, in the part.
            if phase.is_at_part() && self.rules.meaning() == LinearMeaning::TipCoordinates {
                self.found(current, check::SHOP_LINE, "the safety line comes before the machine has retracted");
            }
            // A tool that is called before a stop is changed before it; and the program begins with a restart point.
            let tool = self.previous.tools.current;
            let stops = |item: &ExpectedItem| {
                matches!(item.action, ExpectedAction::Stop { .. }) && tool.is_some() && item.required.tool == tool
            };
            // After blocks that measure the tool its modes are stated again.
            let restates = self.duties.owes(Duty::ModesAgain);
            if !restates && self.progress.next().is_some_and(stops) {
                self.duties.happens(DutyEvent::StopPassed);
            }
            self.duties.happens(DutyEvent::CompleteState);
            self.previous.offsets = None;
            self.functions.restart();
        }
        if let Some(guard) = block.guards.length {
            let required = self.progress.next().map(|item| &*item.required);
            let fault = self.functions.guard(guard, block.state.length, &self.rules, required);
            self.found_any(current, check::GUARD, fault);
            if matches!(phase, Phase::Retracted(retracted) if retracted.step >= 2) {
                self.found(
                    current,
                    check::GUARD,
                    "the length guard comes after linear axes have moved in the approach",
                );
            }
        }
        if let Some(largest_mm) = block.guards.radius_mm {
            let fault = self.functions.radius_guard(largest_mm, block.state.length);
            self.found_any(current, check::GUARD, fault);
        }
        if let Some(part) = block.blank {
            self.functions.blank(part);
        }
        if block.guards.offset {
            self.duties.happens(DutyEvent::OffsetGuard);
        }
        if let Some(guard) = &block.guards.plane {
            if phase.is_retracted() {
                self.duties.happens(DutyEvent::PlaneGuard);
            }
            let fault = plane_guard::fault(guard, phase, &self.rules, &self.previous);
            self.found_any(current, check::GUARD, fault);
        }
    }

    /// Changes of work offset, length compensation and planes that must not happen at the part.
    #[inline(never)]
    fn modes_before_task(&mut self, phase: &Phase, current: &Current<'_>) {
        let block = current.block;
        if block.state.coolant.is_some_and(|on| on & THROUGH != 0) {
            self.duties.happens(DutyEvent::ThroughCoolant);
        }
        let length = std::mem::replace(&mut self.previous.length, block.state.length);
        let framed = block.state.tilt.is_some() || block.state.dynamic_offset;
        let was_framed = std::mem::replace(&mut self.previous.framed, framed);
        if was_framed && !framed {
            self.come_to(DutyPlace::FrameEnd, None, current);
        } else if framed && !was_framed {
            self.duties.happens(DutyEvent::FrameBegins);
        }
        if !phase.is_at_part() {
            return;
        }
        let offset = |state: &State| state.work_offset.or(state.cancelled_offset);
        let offsets = offset(&self.setters.at_block).zip(offset(&block.state));
        if block.own.is_none() && offsets.is_some_and(|(before, now)| before != now) {
            self.found(current, check::SEQUENCE, "the work offset changes before the machine has retracted");
        }
        let facts = *self.rules.facts();
        let changed = matches!(length, Some(Length::Register(_))) && length != block.state.length;
        if facts.length_moves && changed && !block.action.leaves_words() {
            self.found(
                current,
                check::SEQUENCE,
                "length compensation is switched off before the machine has retracted: the tool may move by its length",
            );
        }
        if was_framed && !framed && !facts.plane_off_before_retract {
            self.found(
                current,
                check::SEQUENCE,
                "the frame of the plane is switched off before the machine has retracted",
            );
        }
    }
}

/// Whether the machine has to retract after a line of the shop, although it was at its retract before.
fn needs_retract(own: &OwnLine) -> bool {
    let is_lost = matches!(own.effect, Some(Effect::Measures | Effect::PositionLost | Effect::StateLost));
    let has_retract = |place: &OwnPlace| match place {
        OwnPlace::MeasureTool
        | OwnPlace::CheckTool
        | OwnPlace::ToolStart { .. }
        | OwnPlace::ToolEnd { .. }
        | OwnPlace::OperationStart => true,
        OwnPlace::Start
        | OwnPlace::End
        | OwnPlace::Safety
        | OwnPlace::MillTurn
        | OwnPlace::Spindle { .. }
        | OwnPlace::ToolChange
        | OwnPlace::OperationEnd
        | OwnPlace::Retract { .. }
        | OwnPlace::Clamp { .. }
        | OwnPlace::Coolant
        | OwnPlace::TipControl { .. }
        | OwnPlace::Insert
        | OwnPlace::Unconfirmed => false,
    };
    is_lost && own.places.iter().any(has_retract)
}
