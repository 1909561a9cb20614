//! What must be between two cuts, as rows.
//!
//! [`OWED`] has what a program owes after an event, and the events that settle it. [`NEEDED`] has what must be so at
//! each place to which a program comes: nothing of that kind is owed there any more, and the machine is in the state
//! for it. The writer has rows of its own, from which it writes its sequence; a test compares them.

mod rows;

use std::rc::Rc;

use crate::diag::code::check;

use super::super::policy::CheckPolicy;
use super::super::read::{LineForm, stated};
use super::super::rules::fault_at_end;
use super::functions::ClampsDue;
use super::phase::Phase;
use super::{Comparison, Current, plane_guard};
pub(super) use rows::{Duty, DutyEvent, DutyPlace, Station};
use rows::{NEEDED, OWED, Owed};

const OFFSET_GUARD: &str = "the guard of the work offset is missing after the restart point: a rotation that lies over it would rotate \
                            the part (`offset_guard`)";

/// What is owed.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Duties {
    /// Bits by [`Duty`].
    owed: u64,
    /// What is asked for at all.
    asked: u64,
}

impl Duty {
    const fn bit(self) -> u64 {
        1 << self as u32
    }
}

/// What is owed after each event, and what is done by it: bits.
const BY_EVENT: [[u64; 2]; DutyEvent::Cycle as usize + 1] = {
    let (mut bits, mut index) = ([[0; 2]; _], 0);
    while index < OWED.len() {
        let Owed { what, after, done, .. } = &OWED[index];
        let (lists, mut column) = ([*after, *done], 0);
        while column < 2 {
            let mut event = 0;
            while event < lists[column].len() {
                bits[lists[column][event] as usize][column] |= what.bit();
                event += 1;
            }
            column += 1;
        }
        index += 1;
    }
    bits
};

/// What may be owed at each place: bits.
const AT_PLACE: [u64; DutyPlace::End as usize + 1] = {
    let (mut bits, mut row) = ([0; _], 0);
    while row < NEEDED.len() {
        bits[NEEDED[row].at as usize] |= NEEDED[row].what.bit();
        row += 1;
    }
    bits
};

impl Duties {
    pub(super) fn new(policy: &CheckPolicy) -> Self {
        let asked = OWED.iter().filter(|row| (row.asked)(policy)).fold(0, |bits, row| bits | row.what.bit());
        let mut duties = Self { owed: 0, asked };
        duties.happens(DutyEvent::Begin);
        duties
    }

    /// An event: what it settles is no longer owed, and what comes after it is.
    #[inline]
    pub(super) fn happens(&mut self, event: DutyEvent) {
        let [after, done] = BY_EVENT[event as usize];
        self.owed = self.owed & !done | after & self.asked;
    }

    pub(super) fn owes(&self, what: Duty) -> bool {
        self.owed & what.bit() != 0
    }

    /// Whether something is owed, which is said once.
    fn take(&mut self, what: Duty) -> bool {
        let owes = self.owes(what);
        self.owed &= !what.bit();
        owes
    }
}

impl Comparison<'_> {
    /// The program comes to a place: reports what is missing there. `phase`: before the block; `None` at the end of an
    /// approach and in a cut.
    pub(super) fn come_to(&mut self, place: DutyPlace, phase: Option<&Phase>, current: &Current<'_>) {
        for row in NEEDED.iter().filter(|row| row.at == place) {
            if (row.needed)(&self.rules) && self.is_missing(row.what, phase, current) {
                self.found(current, check::MISSING, row.text);
            }
        }
    }

    /// The program comes to a cut, where nothing is owed as a rule.
    #[inline]
    pub(super) fn come_to_cut(&mut self, place: DutyPlace, current: &Current<'_>) {
        if self.duties.owed & AT_PLACE[place as usize] != 0 {
            self.come_to(place, None, current);
        }
    }

    /// Whether something is missing for which the row has the text; what has others is reported here.
    fn is_missing(&mut self, what: Duty, phase: Option<&Phase>, current: &Current<'_>) -> bool {
        let (before, at_part) = (&self.setters.at_block, phase.is_some_and(Phase::is_at_part));
        let unstated = |bit| current.block.stated & bit == 0;
        match what {
            Duty::CompleteState | Duty::ModesAgain | Duty::RetractAfterShopLine => return self.duties.owes(what),
            Duty::Retract => return at_part || self.duties.owes(what),
            Duty::DrainDwell
            | Duty::SpindleDwell
            | Duty::SpindleAgain
            | Duty::TipControlOff
            | Duty::CycleAtLevel
            | Duty::RotationAfterHome
            | Duty::StopInTime
            | Duty::MotionInFrame => {
                return self.duties.take(what);
            }
            Duty::Away => return at_part,
            Duty::Retracted => {
                return !phase.is_some_and(Phase::is_retracted) || self.duties.owes(Duty::RetractAfterShopLine);
            }
            Duty::SpindleOff => return before.spindle_is_on(),
            Duty::SpindleStopped => return before.spindle != Some(None),
            Duty::SpindleAndCoolantOff => return self.previous.process.runs,
            Duty::CoolantStated => return unstated(stated::COOLANT),
            Duty::OffsetStated => return unstated(stated::OFFSET),
            Duty::SpindleStated => {
                let runs = self.progress.next().is_some_and(|item| item.required.spindle.is_some());
                return runs && unstated(stated::SPINDLE);
            }
            Duty::Parking if self.duties.take(what) => self.parking_positions(current),
            Duty::Parking => {}
            Duty::ParkingAtEnd => self.parking_positions(current),
            Duty::PlaneGuard if self.duties.take(what) => {
                let missing = plane_guard::missing(&self.rules, &self.previous);
                self.found_any(current, check::GUARD, missing);
            }
            Duty::PlaneGuard => {}
            // The control executes its IF whatever the block skip switch is set to, so it has come before.
            Duty::OffsetGuard if !self.rules.facts().offset_guard => {}
            Duty::OffsetGuard if current.block.skippable && self.rules.facts().form == LineForm::Keywords => {}
            Duty::OffsetGuard if self.duties.take(what) => self.found(current, check::GUARD, OFFSET_GUARD),
            Duty::OffsetGuard => {}
            Duty::StateAtEnd => self.found_state(current, fault_at_end(current.block)),
            Duty::AtChangePosition if !at_part && !self.duties.owes(Duty::Retract) => {
                self.is_at_station(Station::Change, current)
            }
            Duty::AtChangePosition => {}
            Duty::ApproachEnded => phase.into_iter().for_each(|phase| self.is_complete(phase, current)),
            Duty::CutsEnded => self.cuts_have_ended(current),
            Duty::ClampsOfCuts if at_part => {
                let fault = self.functions.end_of_cuts(&self.rules);
                self.found_any(current, check::CLAMP, fault);
            }
            Duty::ClampsOfCuts => {}
            Duty::ClampsAsBefore | Duty::ClampsPositioned | Duty::ClampsParked => {
                let due = match what {
                    // In an approach an axis may have rotated for a cut in which it moves.
                    Duty::ClampsAsBefore if matches!(phase, Some(Phase::Retracted(retracted)) if retracted.step == 0) => {
                        ClampsDue::Positioned
                    }
                    Duty::ClampsAsBefore => ClampsDue::AsBefore,
                    Duty::ClampsPositioned => ClampsDue::Positioned,
                    _ => ClampsDue::Parked,
                };
                let fault = self.functions.clamps_left(&self.setters.at_block, &self.rules, due);
                self.found_any(current, check::CLAMP, fault);
            }
            Duty::OperationEnded => self.ends_operation(current),
            Duty::ToolEnded => {
                let missing = self.shop_lines.end_tool(match phase {
                    Some(_) => "before the blocks that may be skipped begin or end",
                    None => "before the axes are parked",
                });
                self.found_all(current, check::SHOP_LINE, missing);
            }
            Duty::ProgramEnded => {
                // An operation without a motion has begun with its own.
                let offsets = self.previous.offsets.filter(|_| self.duties.owes(Duty::CompleteState));
                let register = self.progress.last().map(|last| last.register);
                let fault = self.rules.fault_in_modes(&current.block.state, offsets, register);
                self.found_state(current, fault);
                let missing = self.shop_lines.end();
                self.found_all(current, check::SHOP_LINE, missing);
            }
            Duty::LengthGuard | Duty::ClampsStated | Duty::AxesStated | Duty::Blank => {
                self.compare_first_blocks(what, current)
            }
        }
        false
    }

    /// What must come before the first approach of an operation: a guard, the clamps, the blank.
    fn compare_first_blocks(&mut self, what: Duty, current: &Current<'_>) {
        let Some(required) = self.progress.next().map(|item| Rc::clone(&item.required)) else { return };
        let fault = match what {
            Duty::LengthGuard => self.functions.length_guard(&self.rules, &required, current.block),
            Duty::ClampsStated => self.functions.clamps_unstated(&self.rules),
            Duty::AxesStated => self.functions.axes_unstated(&self.rules),
            _ => self.functions.blank_fault(&self.rules),
        };
        self.found_any(current, check::GUARD, fault);
    }
}

#[cfg(test)]
mod tests {
    use super::{Duty, DutyEvent, DutyPlace, NEEDED, OWED};
    use crate::motion::obligations::{ROWS, SequencePlace, SequenceStep};

    /// Places of the check, and the rows of the writer that lead there.
    const PLACES: [(DutyPlace, &[SequencePlace]); 5] = [
        (DutyPlace::ToolChange, &[SequencePlace::CompleteState, SequencePlace::ToolChange]),
        (DutyPlace::Stop, &[SequencePlace::Stop]),
        (DutyPlace::BlockSkip, &[SequencePlace::BlockSkip]),
        (DutyPlace::Standstill, &[SequencePlace::Standstill]),
        (DutyPlace::End, &[SequencePlace::End]),
    ];

    /// Steps that a duty asks for; none where the writer does it elsewhere, or its path is compared.
    fn steps_for(what: Duty) -> &'static [SequenceStep] {
        match what {
            Duty::Retract | Duty::RetractAfterShopLine | Duty::Retracted | Duty::Away => &[SequenceStep::Retract],
            Duty::SpindleOff => &[SequenceStep::SpindleOffForChange],
            Duty::SpindleStopped => &[SequenceStep::SpindleOff],
            Duty::StateAtEnd | Duty::SpindleAndCoolantOff => &[SequenceStep::CoolantOff, SequenceStep::SpindleOff],
            Duty::DrainDwell => &[SequenceStep::DrainDwell],
            Duty::AtChangePosition => &[SequenceStep::ChangePosition],
            Duty::ToolEnded | Duty::ProgramEnded => &[SequenceStep::ToolEnd],
            // At a record the writer ends the operation before it takes it.
            Duty::OperationEnded => &[],
            Duty::CompleteState
            | Duty::Parking
            | Duty::ParkingAtEnd
            | Duty::SpindleDwell
            | Duty::SpindleAgain
            | Duty::TipControlOff
            | Duty::PlaneGuard
            | Duty::OffsetGuard
            | Duty::CycleAtLevel
            | Duty::RotationAfterHome
            | Duty::StopInTime
            | Duty::ModesAgain
            | Duty::MotionInFrame
            | Duty::ApproachEnded
            | Duty::CutsEnded
            | Duty::ClampsOfCuts
            | Duty::ClampsAsBefore
            | Duty::ClampsPositioned
            | Duty::ClampsParked
            | Duty::CoolantStated
            | Duty::OffsetStated
            | Duty::SpindleStated
            | Duty::LengthGuard
            | Duty::ClampsStated
            | Duty::AxesStated
            | Duty::Blank => &[],
        }
    }

    /// Steps that no duty asks for by themselves: the path of the first is compared, the others are in the state of
    /// each block or come before their place.
    const OF_OTHERS: [SequenceStep; 5] = [
        SequenceStep::LeadOut,
        SequenceStep::LeadOutIfTilted,
        SequenceStep::CoolantOff,
        SequenceStep::OperationEnd,
        SequenceStep::BlockSkipEnd,
    ];

    fn written(places: &[SequencePlace]) -> Vec<SequenceStep> {
        let row = |place: &SequencePlace| ROWS.iter().find(|row| row.at == *place).expect("a place has its row");
        places.iter().flat_map(|place| row(place).needs).copied().collect()
    }

    #[test]
    fn the_writer_does_at_each_place_what_the_check_needs_there_and_nothing_else() {
        for (place, rows) in PLACES {
            let written = written(rows);
            let asked: Vec<SequenceStep> =
                NEEDED.iter().filter(|row| row.at == place).flat_map(|row| steps_for(row.what)).copied().collect();
            assert!(!asked.is_empty(), "{place:?}");
            for need in &asked {
                assert!(written.contains(need), "{place:?}: the check needs {need:?}, which the writer does not do");
            }
            for need in written.iter().filter(|need| !OF_OTHERS.contains(need)) {
                assert!(asked.contains(need), "{place:?}: the writer does {need:?}, and the check would not miss it");
            }
        }
    }

    #[test]
    fn the_machine_retracts_before_the_spindle_stops_and_after_the_coolant_is_off() {
        for row in &ROWS {
            let at = |need: SequenceStep| row.needs.iter().rposition(|one| *one == need);
            let in_order = |first: Option<usize>, then: Option<usize>| first.zip(then).is_none_or(|(a, b)| a < b);
            assert!(in_order(at(SequenceStep::LeadOut), at(SequenceStep::Retract)), "{:?}", row.at);
            assert!(in_order(at(SequenceStep::CoolantOff), at(SequenceStep::Retract)), "{:?}", row.at);
            assert!(in_order(at(SequenceStep::Retract), at(SequenceStep::SpindleOff)), "{:?}", row.at);
            assert!(in_order(at(SequenceStep::Retract), at(SequenceStep::Parking)), "{:?}", row.at);
        }
    }

    #[test]
    fn each_event_and_each_thing_that_is_owed_has_its_rows() {
        for row in &OWED {
            assert!(!row.after.is_empty(), "{:?} is never owed", row.what);
            let settled = !row.done.is_empty() || row.what == Duty::Parking;
            assert!(settled, "{:?} is never done", row.what);
            let asked = NEEDED.iter().any(|needed| needed.what == row.what);
            assert!(asked, "{:?} is needed nowhere", row.what);
            assert_eq!(OWED.iter().filter(|other| other.what == row.what).count(), 1, "{:?}", row.what);
        }
        let retract = OWED.iter().find(|row| row.what == Duty::Retract).expect("the retract is owed");
        assert!(retract.after.contains(&DutyEvent::CompleteState), "the writer retracts after each complete state");
        assert_eq!(written(&[SequencePlace::CompleteState]), [SequenceStep::CoolantOff, SequenceStep::Retract]);
    }
}
