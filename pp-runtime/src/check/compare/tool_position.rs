//! Positions of the axes where a tool is measured or checked for breakage (`cycles.tool_position`).

use std::io::Read;

use super::super::read::{Action, Block, OwnLine, OwnPlace};
use super::super::rules::ModalContext;
use super::phase::{Phase, Retracted};
use super::{Comparison, Current, Previous, parking};

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
        self.shop_lines.is_measuring_due(block.state.tool, self.tool_of_next_motion())
    }

    /// Rotary axes to their positions for measuring a tool.
    pub(super) fn rotate_to_tool_position(&mut self, retracted: &Retracted, turned: bool, current: &Current<'_>) {
        self.home_before_rotation(retracted, turned, current);
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
        let missing: Vec<char> = parking::missing(&self.rules, places, self.at_tool_position, words).collect();
        let is_elsewhere = |index: usize, letter: char| {
            missing.contains(&letter) || unknown & (1 << index) != 0 && places.contains_key(&letter)
        };
        let axes = self.rules.axes().iter().enumerate();
        let elsewhere = axes.filter(|&(index, axis)| is_elsewhere(index, axis.letter)).map(|(_, axis)| axis.letter);
        for letter in elsewhere.collect::<Vec<_>>() {
            self.found(current, &format!("{letter} is not at its position of `cycles.tool_position`"));
        }
    }
}
