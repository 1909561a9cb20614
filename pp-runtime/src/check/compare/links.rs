//! Blocks to positions of the machine: machine retract, home and parking positions.

use std::io;

use super::super::expect::{ExpectedAction, ExpectedItem, SpindleState};
use super::super::geometry::ToolPose;
use super::super::policy::RetractRule;
use super::super::read::{Action, Block, OwnPlace};
use super::super::rules::{ModalContext, OffsetsInForce};
use super::obligations::{Duty, DutyEvent, DutyPlace};
use super::phase::{Cutting, Phase, Retracted};
use super::{Comparison, Current, PreviousTools, machine_move, parking, retract};
use crate::diag::code::check;
use crate::program::Clearance;

impl Comparison<'_> {
    /// A block to a position of the machine.
    pub(super) fn machine_position(&mut self, phase: &mut Phase, current: &Current<'_>) -> io::Result<Option<Phase>> {
        self.pass_needless(phase)?;
        let block = current.block;
        if self.descends_to_station(phase, current) {
            return Ok(None);
        }
        if let Some(text) = machine_move::fault_of_retract(&self.rules, &self.previous, block) {
            self.note_stations(block);
            // An axis leaves the place where it was.
            self.parked &= !block.written;
            if let Phase::Retracted(retracted) = phase {
                retracted.homed &= !block.written;
            }
            // A parking position may be the home position.
            let (homes, parks) = (self.goes_home(phase, current), self.parks_linear(phase, current));
            let elsewhere = parks || self.goes_to_station(phase, current);
            if homes && !elsewhere && !self.is_station_due(block) {
                self.duties.happens(DutyEvent::LinearHome);
            } else if !homes && !elsewhere {
                self.found(current, check::SEQUENCE, &text);
                if block.action != Action::Machine {
                    return Ok(Some(self.forget(phase)));
                }
            }
            return Ok(None);
        }
        self.machine_retract(phase, current).map(Some)
    }

    /// The other linear axes to their home positions, before the rotary axes rotate; whether the block does that.
    pub(super) fn goes_home(&mut self, phase: &mut Phase, current: &Current<'_>) -> bool {
        let Phase::Retracted(retracted) = phase else { return false };
        let homes = retracted.step == 0 && machine_move::goes_home(&self.rules, current.block);
        if homes {
            retracted.homed |= current.block.written;
            // The spindle is on for the cut that comes.
            let rewind = retracted.rewind.as_ref();
            let finished = rewind.and_then(|rewind| rewind.finished.as_ref()).map(|finished| &finished.required);
            let next = self.progress.next();
            let cut = next.map(|item| &item.required).or(finished);
            let stopped = retracted.parks || next.is_none() || self.is_station_due(current.block);
            let spindle = cut.filter(|_| !stopped).and_then(|required| self.rules.spindle_in_cut(required));
            // As in an approach, the coolant may be on where a cut goes on after a rewind.
            let dry = retracted.rewind.is_none();
            self.state_at_machine_position(spindle, dry, current);
        }
        homes
    }

    /// The linear axes are home where a block at the retract rotates the rotary axes (`home_on_indexing`).
    pub(super) fn home_before_rotation(&mut self, retracted: &Retracted, turned: bool, current: &Current<'_>) {
        if current.block.written & self.rules.words().rotary_bits() != 0 {
            self.duties.happens(DutyEvent::RotaryWords);
        }
        if turned && machine_move::is_not_home(&self.rules, retracted.homed) {
            self.found(
                current,
                check::SEQUENCE,
                "the rotary axes rotate before the linear axes are at their home positions (`home_on_indexing`)",
            );
        }
    }

    /// Linear axes to their parking positions; whether the block does that.
    fn parks_linear(&mut self, phase: &mut Phase, current: &Current<'_>) -> bool {
        let block = current.block;
        let Phase::Retracted(retracted) = phase else { return false };
        let begun = retracted.parks || self.progress.next().is_none();
        let parks = block.action == Action::Machine
            && begun
            && parking::moves_linear(&self.rules, &self.rules.policy().links.park, block);
        if parks {
            retracted.linear_parked = true;
            self.parks_at_end(current);
            self.state_at_machine_position(None, true, current);
            self.parked |= block.written;
        }
        parks
    }

    /// The axes are parked when the operation has ended, without GOHOME when all else is done.
    pub(super) fn parks_at_end(&mut self, current: &Current<'_>) {
        match self.duties.owes(Duty::Parking) {
            _ if self.progress.next().is_some() => {}
            // GOHOME is a record: it ends the operation, and lines that end the work of the tool come after it.
            true => self.ends_operation(current),
            false => self.come_to(DutyPlace::Park, None, current),
        }
    }

    /// State of a block to a home or parking position.
    pub(super) fn state_at_machine_position(
        &mut self,
        spindle: Option<SpindleState>,
        dry: bool,
        current: &Current<'_>,
    ) {
        let block = current.block;
        let context = ModalContext { dry, no_plane: true, ..ModalContext::default() };
        let fault = self.rules.fault_at_retract(block, false, spindle, context);
        self.found_state(current, fault);
    }

    /// Position in the machine retract of the shop of a line that has these places: the one that comes next, or another
    /// where the line has no place but the retract.
    pub(super) fn own_retract_block(&self, places: &[OwnPlace]) -> Option<usize> {
        let of_retract = |place: &OwnPlace| match place {
            OwnPlace::Retract { index } => Some(*index),
            _ => None,
        };
        let next = places.iter().filter_map(of_retract).find(|index| *index == self.own_retract);
        next.or_else(|| {
            if places.iter().all(|place| of_retract(place).is_some()) { of_retract(places.first()?) } else { None }
        })
    }

    /// The block of the shop at this position of its machine retract; the phase after the last of them.
    pub(super) fn own_retract(
        &mut self,
        index: usize,
        phase: &mut Phase,
        current: &Current<'_>,
    ) -> io::Result<Option<Phase>> {
        self.pass_needless(phase)?;
        let RetractRule::OwnBlocks(count) = self.rules.policy().links.retract else { return Ok(None) };
        if index != self.own_retract {
            self.found(current, check::SEQUENCE, "the blocks of `retract.method` are incomplete, or in another order");
        }
        self.own_retract = index + 1;
        if self.own_retract < count {
            return Ok(None);
        }
        self.own_retract = 0;
        self.machine_retract(phase, current).map(Some)
    }

    /// The machine retract.
    fn machine_retract(&mut self, phase: &mut Phase, current: &Current<'_>) -> io::Result<Phase> {
        let block = current.block;
        let (index, position) = (self.rules.words().retract(), self.rules.policy().links.retract_mm);
        if let Some(text) = self.travel.machine_coordinate(index, position) {
            self.tally.outside_limits(check::LIMITS, self.progress.location(), current.shown, &text);
        }
        self.is_complete(phase, current);
        let at_part = phase.is_at_part();
        if at_part {
            let fault = machine_move::leads_down(&self.rules, &self.previous, block);
            self.found_any(current, check::SEQUENCE, fault);
            self.missing_dwells(current, false);
        }
        if !self.duties.owes(Duty::CompleteState) {
            self.come_to(DutyPlace::RetractOfStart, Some(phase), current);
            let missing = self.shop_lines.retract_of_start();
            self.found_all(current, check::SHOP_LINE, missing);
        }
        let mut retracted = self.retracted(phase, current);
        let rewinds = retracted.rewind.is_some();
        // The cuts after a rewind belong to those before it.
        if at_part && rewinds {
            self.functions.interrupt_cuts();
        } else if at_part {
            let fault = self.functions.end_of_cuts(&self.rules);
            self.found_any(current, check::CLAMP, fault);
        }
        let links = &self.rules.policy().links;
        // After a stop, where the position is unknown, the operator has switched the coolant; and the stop may have
        // been in the plane.
        let dry = !phase.is_unknown() && (!rewinds || links.rewinds_dry);
        let probed = std::mem::take(&mut self.previous.probed);
        let tilts = phase.is_at_part() || (phase.is_unknown() && (probed || !links.retracts_for_stop));
        let context = ModalContext {
            dry,
            no_plane: phase.is_unknown() || phase.is_stopped() || self.previous.tools.current.is_none(),
            arc_plane: self.previous.arc_plane.filter(|_| matches!(phase, Phase::Cutting(_) | Phase::Unknown { .. })),
            ..ModalContext::default()
        };
        let spindle = self.spindle_may_be(current.block, retracted.stopped);
        let fault = self.rules.fault_at_retract(block, tilts, spindle, context);
        self.found_state(current, fault);
        if at_part && self.stops_in_cut(block) {
            self.found(current, check::STATE, "the spindle is off before this machine retract, and was on in the cut");
        }
        if !self.duties.owes(Duty::CompleteState) {
            let frames = self.rules.frames_not_ended(&block.state);
            self.restarts.note(frames, current.shown);
            self.restarts.end();
        }
        if let Some(last) = self.progress.last().filter(|_| at_part) {
            let fault = self.rules.fault_in_offset(&block.state, last);
            self.found_state(current, fault);
        }
        self.duties.happens(DutyEvent::Retract);
        self.functions.retract(&block.state);
        // Blocks after it, up to the next complete state, change nothing of that.
        if at_part || self.previous.offsets.is_none() {
            self.previous.offsets = Some(OffsetsInForce::of(&block.state));
        }
        self.at_station = Default::default();
        if self.is_home_due(block.state.tool) {
            self.progress.take();
            retracted.parks = true;
            self.duties.happens(DutyEvent::Home);
            self.parked = 0;
        }
        Ok(Phase::Retracted(Box::new(retracted)))
    }

    /// Whether GOHOME is next, and the tool in the spindle, as far as it is known, is the one with which it is carried
    /// out: after blocks that may be skipped, a tool that is called comes first.
    fn is_home_due(&self, tool: Option<u32>) -> bool {
        let Some(ExpectedItem { action: ExpectedAction::Home { called }, required, .. }) = self.progress.next() else {
            return false;
        };
        let PreviousTools { current: before, unsure: unsure_tool, .. } = self.previous.tools;
        tool == required.tool || tool.is_none() && before.is_some() && !(unsure_tool && *called)
    }

    /// GOHOME where the machine has retracted already: its axes are parked from there.
    pub(super) fn take_home(&mut self, phase: &mut Phase, block: &Block) {
        let Phase::Retracted(retracted) = phase else { return };
        let changes = block.action == Action::ToolChange;
        if retracted.step == 0 && !changes && self.is_home_due(block.state.tool) {
            self.progress.take();
            retracted.parks = true;
            self.duties.happens(DutyEvent::Home);
        }
    }

    /// Every axis with a parking position is there.
    pub(super) fn parking_positions(&mut self, current: &Current<'_>) {
        let missing: Vec<char> = {
            let places = &self.rules.policy().links.park;
            parking::missing(&self.rules, places, self.parked, &current.block.values).collect()
        };
        for letter in missing {
            self.found(current, check::SEQUENCE, &format!("{letter} is not at its parking position"));
        }
    }

    /// Data of the retract position after this phase. At the part the tool must have left it along its axis.
    pub(super) fn retracted(&mut self, phase: &mut Phase, current: &Current<'_>) -> Retracted {
        let stopped = phase.is_stopped();
        match phase {
            Phase::Cutting(cutting) => {
                self.has_left(cutting, current);
                Retracted { rewind: self.rewind_point(cutting, None, current.block), ..Retracted::default() }
            }
            Phase::Leaving(leaving) => Retracted { rewind: leaving.rewind.take(), ..Retracted::default() },
            Phase::Retracted(retracted) => Retracted {
                rewind: retracted.rewind.take(),
                // The retract of the next operation: what rotates the axes after it is its approach.
                parks: retracted.parks && self.duties.owes(Duty::CompleteState),
                stopped,
                ..Retracted::default()
            },
            Phase::Unknown { .. } | Phase::Ended => Retracted { stopped, ..Retracted::default() },
        }
    }

    /// The tool must have left the part along its axis.
    pub(super) fn has_left(&mut self, cutting: &Cutting, current: &Current<'_>) {
        let (here, out_mm) = (cutting.here, cutting.retract.out_mm());
        let on_path = here.map(|here| self.progress.on_path(&here));
        let out = |pose: ToolPose| retract::is_out(&self.rules, self.clearance(), &pose, out_mm);
        // Where the axis hardly leads to a plane, the rounding of a point is a long way: the CL data has reached it.
        let on_path = on_path.filter(|pose| here.is_some_and(|here| self.rules.is_at(&here, pose)));
        if !here.into_iter().chain(on_path).any(out) {
            self.found(
                current,
                check::SEQUENCE,
                "the retract along the tool axis before this block is missing or too short",
            );
        }
    }

    /// Clearance geometry of the last motion.
    pub(super) fn clearance(&self) -> Option<&Clearance> {
        match self.progress.last() {
            Some(required) => required.clearance.as_ref(),
            None => self.rules.policy().links.clearance.as_ref(),
        }
    }

    /// State in which the spindle may be at the retract position: as in the last cut, as a SPINDL after it requests, or
    /// as in the operation to which the link leads; off after a stop.
    fn spindle_may_be(&self, block: &Block, stopped: bool) -> Option<SpindleState> {
        block.state.spindle.flatten().filter(|_| !stopped)?;
        let requested = self.progress.requested_spindle().flatten();
        let in_cut = self.progress.last().and_then(|required| required.spindle);
        let linked = self.progress.next().filter(|item| item.motion().is_some_and(|motion| !motion.starts));
        let in_next = linked.and_then(|item| self.rules.spindle_in_cut(&item.required));
        let is_so = |spindle: &Option<SpindleState>| self.rules.spindle_is(&block.state, *spindle);
        [requested, self.progress.requested_before(), in_next, self.functions.waits_with()]
            .into_iter()
            .find(is_so)
            .unwrap_or(in_cut)
    }
}
