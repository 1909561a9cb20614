//! Records of the CL data that are blocks of their own: tool changes, stops, dwells, NC text, probes, block skip, the
//! end; and the order in which they act.

use std::io;

use super::super::expect::{ExpectedAction, ExpectedItem};
use super::super::read::{Action, Block, OwnPlace, State, stated};
use super::super::rules::tool_name;
use super::approach::FOR_APPROACH;
use super::obligations::{Duty, DutyEvent, DutyPlace};
use super::phase::{Phase, Retracted};
use super::{Comparison, Current, Previous};
use crate::check::tolerances::ROUNDED_DWELL;
use crate::diag::code::check;

impl Comparison<'_> {
    /// INSERT, codes of the CL data and statements of the shop: a block that is copied.
    #[inline(never)]
    pub(super) fn is_raw(&mut self, phase: &Phase, current: &Current<'_>) -> bool {
        let here = phase.here();
        let index = (0..).find(|index| !self.is_needless(*index, here)).unwrap_or_default();
        let (expected, probe) = match self.progress.get(index).map(|item| &item.action) {
            Some(ExpectedAction::Raw(text)) => (text, None),
            Some(ExpectedAction::Probe { text, first }) => (text, Some(*first)),
            _ => return false,
        };
        let (text, expected) = (current.shown.text, expected.trim_ascii_end());
        let numbered = text.iter().position(|byte| *byte == b' ').map_or(text, |at| &text[at + 1..]);
        if text != expected && !(current.block.number.is_some() && numbered == expected) {
            return false;
        }
        match (phase, probe) {
            (_, Some(first)) => {
                (self.previous.probed, self.previous.measured) = (true, true);
                self.probes(phase, first, current);
            }
            (Phase::Cutting(cutting), None) => self.has_left(cutting, current),
            _ => {}
        }
        // The text of INSERT is not judged; a line of the configuration has an effect, of its codes or declared.
        let judged = if current.block.own.is_some() { current.block.faults.len() } else { current.block.frame_faults };
        for fault in &current.block.faults[..judged] {
            self.found(current, check::WORD, &fault.text);
        }
        if current.block.action == Action::End {
            self.found(
                current,
                check::ORDER,
                "the program ends at this block of the CL data: nothing after it is executed",
            );
        }
        (0..index).for_each(|_| self.progress.pass());
        let place = if probe.is_some() { DutyPlace::Probe } else { DutyPlace::Copied };
        self.come_to(place, Some(phase), current);
        self.compare_tool(current);
        self.progress.pass();
        if current.block.own.as_ref().is_some_and(|own| own.needs_standstill) {
            self.come_to(DutyPlace::Standstill, Some(phase), current);
        }
        let is_first = self.previous.tools.current.is_none() && self.progress.last().is_none();
        if is_first && self.duties.owes(Duty::CompleteState) && !self.rules.policy().shop.own_safety {
            self.found(current, check::ORDER, "this block comes before the first complete state of the program");
        }
        true
    }

    /// A block with which a probe measures: the first where the last motion has ended.
    fn probes(&mut self, phase: &Phase, first: bool, current: &Current<'_>) {
        let state = &current.block.state;
        if first && !matches!(phase, Phase::Cutting(_)) {
            self.found(current, check::PROBE, "the tool is not at the point at which the probe measures");
        }
        if !first && phase.is_retracted() {
            self.found(
                current,
                check::PROBE,
                "the machine has retracted before this block with which a probe measures",
            );
        }
        if first && state.spindle_is_on() {
            self.found(current, check::PROBE, "the spindle is on where a probe measures");
        } else if self.previous.process.started {
            self.found(current, check::PROBE, "the spindle has been switched on where a probe measures");
        }
        if first {
            let at = self.as_before(current.block);
            let fault = self.rules.fault_at_measuring(&at, self.progress.last(), None);
            self.found_state(current, fault);
            let loose = self.functions.loose(&at.state, &self.rules);
            self.found_any(current, check::CLAMP, loose);
        }
    }

    /// A block of the shop as if it did nothing: in the state, and with the axes, of the block before.
    pub(super) fn as_before(&self, block: &Block) -> Block {
        let Previous { words, known, .. } = self.previous;
        Block { state: self.setters.at_block, values: words, known, written: 0, ..block.clone() }
    }

    pub(super) fn tool_change(&mut self, phase: &mut Phase, current: &Current<'_>) -> io::Result<Phase> {
        let tool = current.block.state.tool;
        if self.progress.next().is_none_or(|item| item.required.tool != tool) {
            self.find_again(phase, |item| item.required.tool == tool, current)?;
        }
        self.fill_for_approach(current)?;
        // Records of the tool before that are lost.
        let lost = (0..FOR_APPROACH).map_while(|index| self.progress.get(index));
        let lost = lost.take_while(|item| item.required.tool != tool && item.motion().is_none()).count();
        if self.progress.get(lost).is_some_and(|item| item.required.tool == tool) {
            self.skip(lost, phase.here(), current);
        }
        let of_shop = current.block.own.is_some();
        self.previous.tools.has_changed = true;
        self.previous.tools.first = self.previous.tools.first.or(tool);
        let required = self.tool_due();
        if required == tool {
            (self.previous.tools.current, self.previous.tools.unsure) = (tool, false);
        }
        match required {
            // The shop may end with another tool.
            _ if of_shop && self.progress.next().is_none() => {}
            _ if required != tool => {
                let (tool, required) = (tool_name(tool), tool_name(required));
                self.found(current, check::TOOL, &format!("change to {tool}, but the CL data requires {required}"));
            }
            _ => {}
        }
        let is_stated = of_shop || current.block.stated & stated::TOOL != 0;
        if !is_stated && !self.duties.owes(Duty::CompleteState) {
            self.found(current, check::TOOL, "the tool of this change is not called after the restart point");
        }
        self.come_to(DutyPlace::ToolChange, Some(phase), current);
        self.shop_lines.next_tool();
        Ok(self.forget(phase))
    }

    /// A tool that is selected by itself is the one that is changed next.
    pub(super) fn selected_tool(&mut self, current: &Current<'_>) {
        let (before, now) = (&self.setters.before, &current.block.state);
        if now.selected == before.selected {
            return;
        }
        let prepared = before.selected.filter(|_| self.previous.tools.prepares && before.selected != before.tool);
        if let Some((prepared, tool)) = prepared.zip(now.selected) {
            self.found(
                current,
                check::TOOL,
                &format!("T{prepared} was selected for the next tool change, and T{tool} comes"),
            );
        }
        self.previous.tools.prepares = current.block.own.is_none();
    }

    /// At the end code the tool that is selected is that in the spindle, or the first one, for the next part; or that
    /// of operations that are not in the program.
    fn selected_at_end(&mut self, current: &Current<'_>) {
        let State { tool, selected, .. } = current.block.state;
        // After blocks that may be skipped the tool is unknown.
        let first = self.previous.tools.first.filter(|_| tool.is_some() && self.rules.policy().selection.is_none());
        if let Some((selected, first)) =
            selected.filter(|_| self.previous.tools.prepares && selected != tool).zip(first)
            && selected != first
        {
            self.found(
                current,
                check::TOOL,
                &format!("T{selected} is selected for the next tool change, expected T{first}"),
            );
        }
    }

    /// The tool that the next record of the CL data is carried out with; after the last one the tool that has been
    /// called last.
    pub(super) fn tool_due(&self) -> Option<u32> {
        let mut ahead = (0..FOR_APPROACH).map_while(|index| self.progress.get(index));
        let carried_out = ahead.find(|item| !matches!(item.action, ExpectedAction::BlockSkip { .. }));
        carried_out.map_or(self.progress.last_tool(), |item| item.required.tool)
    }

    /// Whether the tool with which a record is carried out is in the spindle, as far as that is known.
    pub(super) fn is_with_tool(&self, item: &ExpectedItem, block: &Block) -> bool {
        let (tool, required) = (block.state.tool, item.required.tool);
        tool == required || tool.is_none() && self.previous.tools.current.is_some()
    }

    /// Records act in the order of the CL data: a tool is changed before the records after its call.
    fn compare_tool(&mut self, current: &Current<'_>) {
        let Some(item) = self.progress.next() else { return };
        if !self.is_with_tool(item, current.block) {
            let (tool, required) = (tool_name(current.block.state.tool), tool_name(item.required.tool));
            let text =
                format!("this block comes with {tool} in the spindle, its record in the CL data with {required}");
            self.found(current, check::TOOL, &text);
        }
    }

    /// Tool of the next motion, as far as an approach looks ahead; `None` without a motion there.
    pub(super) fn tool_of_next_motion(&self) -> Option<Option<u32>> {
        let mut ahead = (0..FOR_APPROACH).map_while(|index| self.progress.get(index));
        // Behind as many other items, such as dwells, their tool is that of the motion.
        let last = self.progress.get(FOR_APPROACH - 1);
        ahead.find(|item| item.motion().is_some()).or(last).map(|item| item.required.tool)
    }

    /// Whether OPSKIP comes before the next motion.
    pub(super) fn skips_before_next_motion(&self) -> bool {
        let ahead = (0..FOR_APPROACH).map_while(|index| self.progress.get(index));
        let mut before = ahead.take_while(|item| item.motion().is_none());
        before.any(|item| matches!(item.action, ExpectedAction::BlockSkip { .. }))
    }

    /// Where the program has been lost, it continues at the next item that suits.
    fn find_again(
        &mut self,
        phase: &mut Phase,
        suits: impl Fn(&ExpectedItem) -> bool,
        current: &Current<'_>,
    ) -> io::Result<()> {
        if self.progress.is_lost()
            && let Some(count) = self.progress.find(suits)?
        {
            self.skip(count, phase.here(), current);
            self.progress.set_lost(false);
        }
        Ok(())
    }

    /// Reports dwells of the CL data that are not in the program before a block; `all`: those between operations as
    /// well.
    pub(super) fn missing_dwells(&mut self, current: &Current<'_>, all: bool) {
        while let Some(ExpectedItem { action: ExpectedAction::Dwell { seconds, between, .. }, .. }) =
            self.progress.next()
        {
            if *between && !all {
                return;
            }
            self.found(current, check::STOP, &format!("the dwell of {seconds} s before this block is missing"));
            self.progress.take();
        }
    }

    pub(super) fn dwell(&mut self, phase: &mut Phase, seconds: f64, current: &Current<'_>) -> io::Result<()> {
        self.pass_needless(phase)?;
        // The spindle waits first, and a dwell of the CL data may be as long.
        let links = &self.rules.policy().links;
        let [of_spindle, drains] =
            [links.spindle_dwell_s, links.through_dwell_s].map(|dwell_s| (dwell_s - seconds).abs() <= ROUNDED_DWELL);
        if of_spindle && self.previous.process.waits {
            return Ok(());
        }
        // A dwell of the spindle may be as long.
        let stands = !current.block.state.spindle_is_on();
        if stands && phase.is_retracted() && drains && self.duties.owes(Duty::DrainDwell) {
            self.duties.happens(DutyEvent::Drained);
            return Ok(());
        }
        if let Some(ExpectedItem { action: ExpectedAction::Dwell { seconds: expected, spindle, .. }, required, .. }) =
            self.progress.next()
            && (expected - seconds).abs() <= ROUNDED_DWELL
        {
            let waits_with = *spindle;
            let requested = || self.progress.requested_spindle().unwrap_or(required.spindle);
            let wrong = match waits_with {
                None if !matches!(phase, Phase::Cutting(_)) => false,
                None => !self.rules.spindle_is(&current.block.state, requested()),
                Some(_) => !self.rules.spindle_is(&current.block.state, waits_with),
            };
            self.compare_tool(current);
            self.come_to(DutyPlace::Wait, Some(phase), current);
            self.progress.take();
            if waits_with.is_some() {
                phase.start_spindle();
                self.functions.wait_with(waits_with);
            }
            let dry = self.rules.policy().links.dry_lift_mm.is_some();
            if !dry && wrong {
                self.found(
                    current,
                    check::STOP,
                    "dwell with the spindle off, or at another speed or sense than in the CL data",
                );
            }
            return Ok(());
        }
        if !phase.is_at_part() && self.shop_lines.has(current.shown.text) {
            return Ok(());
        }
        // The writer may not know that the spindle runs already.
        if !(of_spindle && self.previous.process.started) {
            self.found(
                current,
                check::STOP,
                &format!("dwell of {seconds} s, which neither CL data nor configuration asks for"),
            );
        }
        Ok(())
    }

    /// M0 and M1.
    pub(super) fn stop(
        &mut self,
        phase: &mut Phase,
        optional: bool,
        current: &Current<'_>,
    ) -> io::Result<Option<Phase>> {
        self.pass_needless(phase)?;
        let suits = |item: &ExpectedItem| matches!(item.action, ExpectedAction::Stop { optional: expected } if expected == optional);
        self.find_again(phase, suits, current)?;
        let begins = self.tally.motions() == 0;
        let may_stop = |place: &OwnPlace| match place {
            OwnPlace::Start => begins,
            OwnPlace::ToolChange
            | OwnPlace::ToolStart { .. }
            | OwnPlace::ToolEnd { .. }
            | OwnPlace::MeasureTool
            | OwnPlace::CheckTool
            | OwnPlace::OperationStart
            | OwnPlace::OperationEnd
            | OwnPlace::End => phase.is_retracted(),
            _ => false,
        };
        let of_shop = current.block.own.as_ref().is_some_and(|own| own.places.iter().any(may_stop));
        match self.progress.next() {
            Some(item) if suits(item) => {
                let off = matches!(self.progress.requested_spindle(), Some(None));
                if off && current.block.state.spindle_is_on() {
                    self.found(
                        current,
                        check::STOP,
                        "the spindle is on at this stop, and the CL data has switched it off",
                    );
                }
                self.compare_tool(current);
                self.progress.take();
            }
            // The shop stops where the program and its operations start and end, and at its tool changes.
            _ if of_shop => return Ok(None),
            _ => self.found(current, check::STOP, "stop without STOP or OPSTOP in the CL data"),
        }
        self.come_to(DutyPlace::Stop, Some(phase), current);
        let retracts = self.rules.policy().links.retracts_for_stop;
        if retracts {
            self.functions.wait_with(None);
        }
        // After the stop the retract axis moves from the position of the tool.
        if let Phase::Cutting(cutting) = &*phase
            && !retracts
            && !self.rules.retracts_along_tool()
        {
            self.has_left(cutting, current);
        }
        match self.forget(phase) {
            Phase::Unknown { stopped } => Ok(Some(Phase::Unknown { stopped: stopped || retracts })),
            other => Ok(Some(other)),
        }
    }

    /// Blocks that may be skipped begin and end where OPSKIP does, with the machine retracted. What is in force after
    /// them is what the reader knows whether they were executed or not.
    pub(super) fn block_skip(&mut self, phase: &mut Phase, current: &Current<'_>) -> io::Result<()> {
        let on = current.block.skippable;
        let is = |index: usize, on: bool| {
            matches!(self.progress.get(index), Some(ExpectedItem { action: ExpectedAction::BlockSkip { on: expected }, .. })
                if *expected == on)
        };
        if !on && !self.previous.skippable && self.progress.has_records_ahead() && is(0, true) && is(1, false) {
            // Nothing comes between them.
            self.progress.take();
            self.progress.take();
        }
        if std::mem::replace(&mut self.previous.skippable, on) == on {
            Ok(())
        } else {
            self.change_block_skip(phase, current)
        }
    }

    /// The first block that may be skipped, or that may no longer.
    #[inline(never)]
    fn change_block_skip(&mut self, phase: &mut Phase, current: &Current<'_>) -> io::Result<()> {
        let on = current.block.skippable;
        self.pass_needless(phase)?;
        match self.progress.next().map(|item| &item.action) {
            Some(ExpectedAction::BlockSkip { on: expected }) if *expected == on => self.progress.take(),
            // Without OPSKIP/OFF they end with the CL data.
            None if !on => {}
            _ if on => self.found(
                current,
                check::BLOCK_SKIP,
                "the operator may skip this block (`/`), without OPSKIP/ON in the CL data here",
            ),
            _ => self.found(
                current,
                check::BLOCK_SKIP,
                "this block is always executed (no `/`), without OPSKIP/OFF in the CL data here",
            ),
        }
        self.come_to(DutyPlace::BlockSkip, Some(phase), current);
        self.shop_lines.next_tool();
        self.previous.known &= current.block.known_before;
        // A complete state that may be skipped, or that came before, is none for what comes after.
        self.functions.restart();
        self.previous.tools.unsure = true;
        self.forget(phase);
        self.duties.happens(DutyEvent::BlockSkip);
        *phase = match phase.is_retracted() {
            true => Phase::Retracted(Box::new(Retracted { stopped: true, ..Retracted::default() })),
            false => Phase::Unknown { stopped: true },
        };
        Ok(())
    }

    /// The end code.
    pub(super) fn end(&mut self, phase: &mut Phase, current: &Current<'_>) -> io::Result<Phase> {
        self.progress.fill(2)?;
        self.pass_needless(phase)?;
        let marks = |index: usize| {
            matches!(
                self.progress.get(index),
                Some(ExpectedItem { action: ExpectedAction::BlockSkip { on: true }, .. })
            )
        };
        if marks(0) && self.progress.get(1).is_none() {
            // The blocks that may be skipped belong to no selected operation.
            self.progress.take();
        }
        if self.progress.next().is_some() {
            self.found(current, check::MISSING, "end code before the end of the CL data");
        } else if let Some(last) =
            self.progress.last_tool().filter(|_| self.progress.last_tool() != self.previous.tools.current)
        {
            self.found(
                current,
                check::TOOL,
                &format!("the CL data ends with a call of T{last}: the tool change is missing"),
            );
        }
        if self.previous.skippable {
            self.found(current, check::BLOCK_SKIP, "the operator may skip the end code (`/`)");
        }
        self.come_to(DutyPlace::End, Some(phase), current);
        self.selected_at_end(current);
        Ok(Phase::Ended)
    }

    /// A record ends the operation: the lines of the shop for that have come.
    pub(super) fn ends_operation(&mut self, current: &Current<'_>) {
        // A stop that both have comes twice, and which of the two is the one of the shop cannot be seen.
        if current.block.own.as_ref().is_some_and(|own| own.places.contains(&OwnPlace::OperationEnd)) {
            return;
        }
        for missing in self.shop_lines.end_operation() {
            self.found(current, check::SHOP_LINE, &missing);
        }
    }

    /// The cuts before the last retract do not go on: it was no rewind.
    pub(super) fn cuts_have_ended(&mut self, current: &Current<'_>) {
        let fault = self.functions.end_of_interrupted(&self.rules);
        self.found_any(current, check::CLAMP, fault);
    }
}
