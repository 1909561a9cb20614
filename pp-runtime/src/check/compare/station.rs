//! Positions of the axes where a tool is changed, and where it is measured or checked for breakage
//! (`retract.tool_change_position`, `cycles.tool_position`).

use super::super::expect::Required;
use super::super::read::{Action, Block, OwnLine, OwnPlace, stated};
use super::super::rules::ModalContext;
use super::obligations::{Duty, DutyEvent, DutyPlace, Station};
use super::phase::{Phase, Retracted};
use super::{Comparison, Current, Previous, parking};
use crate::diag::code::check;

impl Comparison<'_> {
    /// Notes the linear axes that a block moves to their positions.
    pub(super) fn note_stations(&mut self, block: &Block) {
        if block.action != Action::Machine {
            return;
        }
        for (station, at) in Station::ALL.into_iter().zip(&mut self.at_station) {
            let places = station.places(&self.rules.policy().links);
            let there = if parking::moves_linear(&self.rules, places, block) { block.written } else { 0 };
            *at = *at & !block.written | there;
        }
    }

    /// Linear axes to their positions; whether the block does that.
    pub(super) fn goes_to_station(&mut self, phase: &Phase, current: &Current<'_>) -> bool {
        let block = current.block;
        let moves = |station: Station| {
            let places = station.places(&self.rules.policy().links);
            self.is_due(station, block) && parking::moves_linear(&self.rules, places, block)
        };
        let goes = matches!(phase, Phase::Retracted(retracted) if retracted.step == 0)
            && block.action == Action::Machine
            && Station::ALL.into_iter().any(moves);
        if goes {
            self.state_at_machine_position(None, true, current);
        }
        goes
    }

    /// The retract axis to its position, after the other axes: it may be the retract position. Whether the block does
    /// that.
    pub(super) fn descends_to_station(&mut self, phase: &Phase, current: &Current<'_>) -> bool {
        let block = current.block;
        let retract = self.rules.words().retract();
        let descends = |station: Station| {
            let places = station.places(&self.rules.policy().links);
            self.at_station[station as usize] != 0
                && block.written == 1 << retract
                && places.contains_key(&self.rules.axes()[retract].letter)
                && parking::moves_linear(&self.rules, places, block)
        };
        if !Station::ALL.into_iter().any(descends) || !self.goes_to_station(phase, current) {
            return false;
        }
        self.note_stations(block);
        true
    }

    /// Whether the tool is changed, measured or checked before the next cut.
    pub(super) fn is_station_due(&self, block: &Block) -> bool {
        Station::ALL.into_iter().any(|station| self.is_due(station, block))
    }

    /// Whether the axes have to go there before the next cut.
    pub(super) fn is_due(&self, station: Station, block: &Block) -> bool {
        if station.places(&self.rules.policy().links).is_empty() {
            return false;
        }
        let spindle = block.state.tool;
        match station {
            // At a restart point the tool in the spindle may be changed for itself, before the spindle is on.
            Station::Change => {
                let again = !self.duties.owes(Duty::CompleteState) && !block.state.spindle_is_on();
                self.tool_due() != spindle || again
            }
            Station::Measuring => {
                let next = self.tool_of_next_motion();
                self.shop_lines.is_measuring_due(spindle, next, self.skips_before_next_motion())
            }
        }
    }

    /// Rotary axes to their positions.
    pub(super) fn rotate_to_station(&mut self, retracted: &Retracted, turned: bool, current: &Current<'_>) {
        self.home_before_rotation(retracted, turned, current);
        // Before the first tool call no plane need be selected.
        let context = ModalContext { no_plane: true, ..ModalContext::default() };
        let fault = |required| self.rules.fault_at_park(current.block, required, context);
        let found = fault(self.required_here());
        let unstated = current.block.stated & stated::OFFSET == 0 && !self.rules.policy().shop.own_safety;
        if unstated && !self.duties.owes(Duty::CompleteState) {
            self.found(
                current,
                check::SEQUENCE,
                "the axes go to a position before the work offset is programmed after the restart point",
            );
        }
        self.found_state(current, found);
    }

    /// A tool is measured with the axes at their positions for that.
    pub(super) fn measures_at_tool_position(&mut self, own: &OwnLine, current: &Current<'_>) {
        let measures = |place: &OwnPlace| matches!(place, OwnPlace::MeasureTool | OwnPlace::CheckTool);
        if own.places.iter().all(measures) {
            self.duties.happens(DutyEvent::Measured);
        }
        if own.places.iter().all(measures) && !self.duties.owes(Duty::RetractAfterShopLine) {
            self.come_to(DutyPlace::Measuring, None, current);
            self.is_at_station(Station::Measuring, current);
            let at = self.as_before(current.block);
            let runs = at.state.spindle_is_on();
            let fault = self.rules.fault_at_measuring(&at, None, self.required_here());
            self.found_state(current, fault);
            if own.places.contains(&OwnPlace::CheckTool) && runs {
                self.found(current, check::PROBE, "the spindle is on where a tool is checked for breakage");
            }
        }
    }

    /// What the operation before requires, or the one after a restart point.
    fn required_here(&self) -> Option<&Required> {
        let next = self.progress.next().map(|item| &*item.required);
        let last = self.progress.last();
        if self.duties.owes(Duty::CompleteState) { last.or(next) } else { next.or(last) }
    }

    /// The axes are at their positions.
    pub(super) fn is_at_station(&mut self, station: Station, current: &Current<'_>) {
        let places = station.places(&self.rules.policy().links);
        if places.is_empty() {
            return;
        }
        let Previous { words, known, .. } = &self.previous;
        let unknown = self.rules.words().rotary_bits() & !known;
        let at = self.at_station[station as usize];
        let missing: Vec<char> = parking::missing(&self.rules, places, at, words).collect();
        let is_elsewhere = |index: usize, letter: char| {
            missing.contains(&letter) || unknown & (1 << index) != 0 && places.contains_key(&letter)
        };
        let axes = self.rules.axes().iter().enumerate();
        let elsewhere = axes.filter(|&(index, axis)| is_elsewhere(index, axis.letter)).map(|(_, axis)| axis.letter);
        for letter in elsewhere.collect::<Vec<_>>() {
            self.found(current, check::SEQUENCE, &format!("{letter} is not at its position of `{}`", station.key()));
        }
    }
}
