//! Positions of the axes where a tool is measured or checked for breakage (`cycles.tool_position`).

use std::io::Read;

use super::super::expect::{ExpectedAction, ExpectedItem};
use super::super::read::{Action, Block, OwnLine, OwnPlace};
use super::super::rules::ModalContext;
use super::links::{FOR_APPROACH, ROTATES_BEFORE_HOME};
use super::phase::{Phase, Retracted};
use super::{Comparison, Current, Previous, machine_move, parking};

impl<R: Read> Comparison<'_, R> {
    /// Notes the linear axes that a block moves to their positions for measuring a tool.
    pub(super) fn note_tool_position(&mut self, block: &Block) {
        let places = &self.rules.policy().links.tool_position;
        if block.action == Action::Machine {
            let there = if parking::moves_linear(&self.rules, places, block) { block.written } else { 0 };
            self.at_tool_position = self.at_tool_position & !block.written | there;
        }
    }

    /// Linear axes to their positions for measuring a tool; whether the block does that.
    pub(super) fn goes_to_tool_position(&mut self, phase: &Phase, current: &Current<'_>) -> bool {
        let block = current.block;
        let places = &self.rules.policy().links.tool_position;
        let goes = matches!(phase, Phase::Retracted(retracted) if retracted.step == 0)
            && block.action == Action::Machine
            && self.is_measuring_due(block)
            && parking::moves_linear(&self.rules, places, block);
        if goes {
            self.state_at_machine_position(None, true, current);
        }
        goes
    }

    /// Whether blocks that measure the tool in the spindle, or look for its breakage, have to come before the next cut.
    pub(super) fn is_measuring_due(&self, block: &Block) -> bool {
        let motion = |item: &&ExpectedItem| matches!(item.action, ExpectedAction::Motion(_));
        let ahead = (0..FOR_APPROACH).map_while(|index| self.progress.get(index));
        let next = ahead.filter(motion).map(|item| item.required.tool).next();
        self.shop_lines.is_measuring_due(block.state.tool, next)
    }

    /// Rotary axes to their positions for measuring a tool.
    pub(super) fn rotate_to_tool_position(&mut self, retracted: &Retracted, turned: bool, current: &Current<'_>) {
        if turned && machine_move::is_not_home(&self.rules, retracted.homed) {
            self.found(current, ROTATES_BEFORE_HOME);
        }
        let fault = self.rules.fault_at_park(current.block, self.progress.last(), ModalContext::default());
        self.found_state(current, fault);
    }

    /// A tool is measured with the axes at their positions for that.
    pub(super) fn measures_at_tool_position(&mut self, own: &OwnLine, current: &Current<'_>) {
        let measures = |place: &OwnPlace| matches!(place, OwnPlace::MeasureTool | OwnPlace::CheckTool);
        let first = own.places.iter().all(measures) && !self.shop_lines.needs_retract();
        let places = &self.rules.policy().links.tool_position;
        if places.is_empty() || !first {
            return;
        }
        let Previous { words, known, .. } = &self.previous;
        let unknown = self.rules.words().rotary_bits() & !known;
        let axes = self.rules.axes().iter().enumerate();
        let unknown: Vec<char> = axes
            .filter(|(index, axis)| unknown & (1 << index) != 0 && places.contains_key(&axis.letter))
            .map(|(_, axis)| axis.letter)
            .collect();
        let missing: Vec<char> = parking::missing(&self.rules, places, self.at_tool_position, words).collect();
        for letter in unknown.iter().chain(missing.iter().filter(|letter| !unknown.contains(letter))) {
            self.found(current, &format!("{letter} is not at its position of `cycles.tool_position`"));
        }
    }
}
