//! Blocks between cuts: machine retract, tool change, approach, stop and end, as the specification requires them.

use std::io;
use std::rc::Rc;

use super::super::expect::{ClMotion, ExpectedAction, ExpectedItem, SpindleState};
use super::super::geometry::{PathShape, Segment, ToolPose, angle_between};
use super::super::policy::{LinearMeaning, RetractRule};
use super::super::read::{Action, Block, Effect, Length, OwnLine, OwnPlace, TipControl, stated};
use super::super::rules::{FrameUse, ModalContext, fault_at_end, tool_name};
use super::functions::place_of_line;
use super::phase::{Cutting, Phase, Retracted, RetractedLength, RewindPoint};
use super::station::Station;
use super::{Comparison, Current, StartState, machine_move, parking, plane_guard, retract};
use crate::check::tolerances::{ALONG_PLANE_NORMAL, BOTH, COMES_BACK, ROUNDED_DWELL};
use crate::program::Clearance;

/// Number of items on which an approach may depend.
const FOR_APPROACH: usize = 8;

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
                self.probed = true;
                self.probes(phase, first, current);
            }
            (Phase::Cutting(cutting), None) => self.has_left(cutting, current),
            _ => {}
        }
        // The text of INSERT is not judged; a line of the configuration has an effect, of its codes or declared.
        let judged = if current.block.own.is_some() { current.block.faults.len() } else { current.block.frame_faults };
        for fault in &current.block.faults[..judged] {
            self.found(current, &fault.text);
        }
        if current.block.action == Action::End {
            self.found(current, "the program ends at this block of the CL data: nothing after it is executed");
        }
        (0..index).for_each(|_| self.progress.pass());
        self.ends_operation(current);
        self.compare_tool(current);
        self.progress.pass();
        if current.block.own.as_ref().is_some_and(|own| own.stands) {
            self.compare_standstill(phase, current);
        }
        let is_first = self.previous.tool.is_none() && self.progress.last().is_none();
        if is_first && !self.start.restarted && !self.rules.policy().shop.own_safety {
            self.found(current, "this block comes before the first complete state of the program");
        }
        true
    }

    /// Work is clamped, or a door moves, with the machine retracted and the spindle off.
    fn compare_standstill(&mut self, phase: &Phase, current: &Current<'_>) {
        if !phase.is_retracted() || self.shop_lines.needs_retract() {
            self.found(
                current,
                "a clamp, a chuck, a door or a pallet moves here: expected the machine retract before this block",
            );
        }
        if self.setters.at_block.spindle != Some(None) {
            self.found(current, "a clamp, a chuck, a door or a pallet moves here: the spindle is not known to be off");
        }
    }

    /// A block with which a probe measures: the first where the last motion has ended.
    fn probes(&mut self, phase: &Phase, first: bool, current: &Current<'_>) {
        let state = &current.block.state;
        if first && !matches!(phase, Phase::Cutting(_)) {
            self.found(current, "the tool is not at the point at which the probe measures");
        }
        if first && state.spindle.flatten().is_some() {
            self.found(current, "the spindle is on where a probe measures");
        }
        if first && state.coolant.is_some_and(|on| on != 0) {
            self.found(current, "the coolant is on where a probe measures");
        }
        if first {
            let before = &self.setters.at_block;
            let fault = self.rules.fault_at_measuring(before, current.block, self.progress.last());
            self.found_state(current, fault);
        }
    }

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
            self.found_any(current, of_another);
        }
        if !block.only_moves {
            self.guards_and_restart(phase, current);
        }
        let fault = self.functions.spindle(block, &self.rules);
        self.found_any(current, fault);
        if !current.same_modes {
            self.modes_before_task(phase, current);
        }
    }

    /// A line that the user brought in; `is_of_cl`: it is the stop of the CL data.
    #[inline(never)]
    fn own_line(&mut self, own: &OwnLine, is_of_cl: bool, phase: &Phase, current: &Current<'_>) {
        self.functions.line(&own.places);
        let ended = self.progress.next().is_none();
        let misplaced = place_of_line(&own.places, phase, self.tally.motions(), ended);
        self.found_any(current, misplaced.filter(|_| !is_of_cl));
        self.begins_operation(own, is_of_cl, current);
        let register = self.progress.next().map(|item| item.required.register);
        let of_another = self.shop_lines.values_fault(own, current.block.state.tool, register);
        self.found_any(current, of_another);
        self.measures_at_tool_position(own, current);
        if needs_retract(own) {
            self.start.retracted = false;
            self.shop_lines.lose_retract();
        }
    }

    /// A line of the shop for the start of an operation comes after its complete state, its tool change and the retract.
    fn begins_operation(&mut self, own: &OwnLine, is_of_cl: bool, current: &Current<'_>) {
        let of_start = |place: &OwnPlace| {
            matches!(place, OwnPlace::OperationStart | OwnPlace::ToolStart { .. } | OwnPlace::MeasureTool)
        };
        if is_of_cl || !own.places.iter().all(of_start) {
            return;
        }
        let StartState { restarted, retracted } = self.start;
        let begun = retracted && (restarted || self.rules.policy().shop.own_safety);
        let tool = current.block.state.tool;
        if !begun || tool.is_some() && tool != self.tool_due() {
            self.found(
                current,
                "this line comes before the complete state, the tool change or the retract of its operation",
            );
        }
    }

    /// Changes of length compensation and planes that must not happen at the part.
    #[inline(never)]
    fn modes_before_task(&mut self, phase: &Phase, current: &Current<'_>) {
        let block = current.block;
        self.functions.coolant(&block.state);
        let length = std::mem::replace(&mut self.previous.length, block.state.length);
        let tilted = std::mem::replace(&mut self.previous.tilted, block.state.tilt.is_some());
        if !phase.is_at_part() {
            return;
        }
        let facts = *self.rules.facts();
        let changed = matches!(length, Some(Length::Register(_))) && length != block.state.length;
        if facts.length_moves && changed && !block.action.leaves_words() {
            self.found(
                current,
                "length compensation is switched off before the machine has retracted: the tool may move by its length",
            );
        }
        if tilted && block.state.tilt.is_none() && !facts.plane_off_before_retract {
            self.found(current, "the tilted plane is switched off before the machine has retracted");
        }
    }

    /// The rules of a block with codes: the complete state, a restart, and values that the control compares.
    fn guards_and_restart(&mut self, phase: &mut Phase, current: &Current<'_>) {
        let block = current.block;
        if block.restart {
            // Tip control ends with the safety line, if it is still on, in the part.
            if phase.is_at_part() && self.rules.meaning() == LinearMeaning::TipCoordinates {
                self.found(current, "the safety line comes before the machine has retracted");
            }
            self.start = StartState { restarted: true, retracted: false };
            self.functions.restart();
        }
        if let Some(guard) = block.guard {
            let required = self.progress.next().map(|item| &*item.required);
            let fault = self.functions.guard(guard, block.state.length, &self.rules, required);
            self.found_any(current, fault);
            if matches!(phase, Phase::Retracted(retracted) if retracted.step >= 2) {
                self.found(current, "the length guard comes after linear axes have moved in the approach");
            }
        }
        if let Some(largest_mm) = block.radius_guard_mm {
            let fault = self.functions.radius_guard(largest_mm, block.state.length);
            self.found_any(current, fault);
        }
        if let Some(part) = block.blank {
            self.functions.blank(part);
        }
        if let Some(guard) = &block.plane_guard {
            let fault = plane_guard::fault(guard, phase, &self.rules, &self.previous);
            self.found_any(current, fault);
        }
    }

    /// An approach that has begun must end at the approach point.
    fn is_complete(&mut self, phase: &Phase, current: &Current<'_>) {
        let Phase::Retracted(retracted) = phase else { return };
        if retracted.step > 0 && !retracted.parks {
            self.found(current, "the approach before this block does not end at an approach point");
        }
        if let Some(rewind) = &retracted.rewind {
            self.found_wet(rewind.wet, current);
        }
    }

    /// The control positions the rotary axes to a tilted plane: to the pose in which they are.
    pub(super) fn orient(&mut self, phase: &mut Phase, current: &Current<'_>) {
        if let Phase::Retracted(retracted) = phase {
            retracted.since_plane = Some(0);
            retracted.plane_guard_due = self.rules.policy().shop.guards_planes && self.rules.facts().plane_guard;
        }
        let state = &current.block.state;
        let expected = self.rules.meaning() == LinearMeaning::PlaneCoordinates || self.rules.may_have_tip_control();
        let Some(tilt) = state.tilt.filter(|_| expected) else {
            self.found(current, "the control positions the rotary axes to a tilted plane where none is expected");
            return;
        };
        if tilt.rotates_table {
            self.found(
                current,
                "the control may rotate the table so that X of the plane is its X (COORD ROT is missing)",
            );
        }
        let rotary = self.rules.words().rotary_bits();
        let known = self.previous.known & rotary == rotary;
        let words = self.rules.words();
        let [axis, normal] = [words.tool_axis_at(&self.previous.words), words.place(&self.previous.words, state).axis];
        if known && angle_between(&axis, &normal) > ALONG_PLANE_NORMAL.max(self.rules.rounding().of_plane_rad()) {
            self.found(current, "the plane call rotates the rotary axes: they are not where the plane has them");
        }
        if let Some(higher) = tilt.pose.filter(|_| known)
            && self.travel.selects_other_pose(&self.rules, &self.previous.words, higher)
        {
            self.found(current, "the plane call selects the other pose: the rotary axes would rotate to it");
        }
    }

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
            let goes = self.goes_home(phase, current) | self.parks_linear(phase, current)
                || self.goes_to_station(phase, current);
            if !goes {
                self.found(current, &text);
                if block.action != Action::Machine {
                    return Ok(Some(self.forget(phase)));
                }
            }
            return Ok(None);
        }
        self.machine_retract(phase, current).map(Some)
    }

    /// The other linear axes to their home positions, before the rotary axes rotate; whether the block does that.
    fn goes_home(&mut self, phase: &mut Phase, current: &Current<'_>) -> bool {
        let Phase::Retracted(retracted) = phase else { return false };
        let homes = retracted.step == 0 && machine_move::goes_home(&self.rules, current.block);
        if homes {
            retracted.homed |= current.block.written;
            // The spindle is on for the cut that comes.
            let rewind = retracted.rewind.as_ref();
            let finished = rewind.and_then(|rewind| rewind.finished.as_ref()).map(|finished| &finished.required);
            let next = self.progress.next();
            let cut = next.map(|item| &item.required).or(finished);
            let stands = retracted.parks || next.is_none() || self.is_station_due(current.block);
            let spindle = cut.filter(|_| !stands).and_then(|required| self.rules.spindle_in_cut(required));
            // As in an approach, the coolant may be on where a cut goes on after a rewind.
            let dry = retracted.rewind.is_none();
            self.state_at_machine_position(spindle, dry, current);
        }
        homes
    }

    /// The linear axes are home where a block at the retract rotates the rotary axes (`home_on_indexing`).
    pub(super) fn home_before_rotation(&mut self, retracted: &Retracted, turned: bool, current: &Current<'_>) {
        if turned && machine_move::is_not_home(&self.rules, retracted.homed) {
            self.found(
                current,
                "the rotary axes rotate before the linear axes are at their home positions (`home_on_indexing`)",
            );
        }
    }

    /// Linear axes to their parking positions; whether the block does that.
    fn parks_linear(&mut self, phase: &mut Phase, current: &Current<'_>) -> bool {
        let block = current.block;
        let begun = matches!(phase, Phase::Retracted(retracted) if retracted.parks) || self.progress.next().is_none();
        let parks = block.action == Action::Machine
            && phase.is_retracted()
            && begun
            && parking::moves_linear(&self.rules, &self.rules.policy().links.park, block);
        if parks {
            self.state_at_machine_position(None, true, current);
            self.parked |= block.written;
        }
        parks
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
            self.found(current, "the blocks of `retract.method` are incomplete, or in another order");
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
            self.tally.outside_limits(self.progress.location(), current.shown, &text);
        }
        self.is_complete(phase, current);
        let at_part = phase.is_at_part();
        if at_part {
            let fault = machine_move::leads_down(&self.rules, &self.previous, block);
            self.found_any(current, fault);
            self.missing_dwells(current, false);
        }
        if self.start.restarted {
            self.is_parked(current);
        }
        let mut retracted = self.retracted(phase, current);
        let rewinds = retracted.rewind.is_some();
        // The cuts after a rewind belong to those before it.
        if at_part && rewinds {
            self.functions.interrupt_cuts();
        } else if at_part {
            let fault = self.functions.end_of_cuts(&self.rules);
            self.found_any(current, fault);
        }
        let links = &self.rules.policy().links;
        // After a stop, where the position is unknown, the operator has switched the coolant; and the stop may have been in
        // the plane.
        let dry = !phase.is_unknown() && (!rewinds || links.rewinds_dry);
        let probed = std::mem::take(&mut self.probed);
        let tilts = phase.is_at_part() || (phase.is_unknown() && (probed || !links.retracts_for_stop));
        let context = ModalContext {
            dry,
            no_plane: phase.is_unknown() || phase.is_stopped(),
            arc_plane: self.previous.arc_plane.filter(|_| matches!(phase, Phase::Cutting(_) | Phase::Unknown { .. })),
            ..ModalContext::default()
        };
        let spindle = self.spindle_may_be(current.block, retracted.stopped);
        let fault = self.rules.fault_at_retract(block, tilts, spindle, context);
        self.found_state(current, fault);
        if self.start.restarted {
            let fault = self.functions.tip_control_fault(&self.rules);
            self.found_any(current, fault);
        }
        self.start.retracted = true;
        self.at_station = Default::default();
        self.shop_lines.note_retract();
        let is_home =
            |item: &ExpectedItem| matches!(item.action, ExpectedAction::Home) && self.is_with_tool(item, block);
        if self.progress.next().is_some_and(is_home) {
            self.progress.take();
            retracted.parks = true;
            (self.home, self.parked) = (true, 0);
        }
        Ok(Phase::Retracted(Box::new(retracted)))
    }

    /// A record ends the operation: the lines of the shop for that have come.
    fn ends_operation(&mut self, current: &Current<'_>) {
        for missing in self.shop_lines.end_operation() {
            self.found(current, &missing);
        }
    }

    /// GOHOME is over: every axis with a parking position must be there.
    fn is_parked(&mut self, current: &Current<'_>) {
        if std::mem::take(&mut self.home) {
            self.parking_positions(current);
        }
    }

    fn parking_positions(&mut self, current: &Current<'_>) {
        let missing: Vec<char> = {
            let places = &self.rules.policy().links.park;
            parking::missing(&self.rules, places, self.parked, &current.block.values).collect()
        };
        for letter in missing {
            self.found(current, &format!("{letter} is not at its parking position"));
        }
    }

    /// The cuts before the last retract do not go on: it was no rewind.
    fn cuts_have_ended(&mut self, current: &Current<'_>) {
        let fault = self.functions.end_of_interrupted(&self.rules);
        self.found_any(current, fault);
    }

    /// Data of the retract position after this phase. At the part the tool must have left it along its axis.
    fn retracted(&mut self, phase: &mut Phase, current: &Current<'_>) -> Retracted {
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
                parks: retracted.parks && !self.start.restarted,
                stopped,
                ..Retracted::default()
            },
            Phase::Unknown { .. } | Phase::Ended => Retracted { stopped, ..Retracted::default() },
        }
    }

    /// The tool must have left the part along its axis.
    fn has_left(&mut self, cutting: &Cutting, current: &Current<'_>) {
        let (here, out_mm) = (cutting.here, cutting.retract.out_mm());
        let on_path = here.map(|here| self.progress.on_path(&here));
        let out = |pose: ToolPose| retract::is_out(&self.rules, self.clearance(), &pose, out_mm);
        // Where the axis hardly leads to a plane, the rounding of a point is a long way: the CL data has reached it.
        let on_path = on_path.filter(|pose| here.is_some_and(|here| self.rules.is_at(&here, pose)));
        if !here.into_iter().chain(on_path).any(out) {
            self.found(current, "the retract along the tool axis before this block is missing or too short");
        }
    }

    /// Clearance geometry of the last motion.
    pub(super) fn clearance(&self) -> Option<&Clearance> {
        match self.progress.last() {
            Some(required) => required.clearance.as_ref(),
            None => self.rules.policy().links.clearance.as_ref(),
        }
    }

    /// State in which the spindle may be at the retract position: as in the last cut, as a SPINDL after it requests, or as in the
    /// operation to which the link leads; off after a stop.
    fn spindle_may_be(&self, block: &Block, stopped: bool) -> Option<SpindleState> {
        block.state.spindle.flatten().filter(|_| !stopped)?;
        let requested = self.progress.requested_spindle().flatten();
        let in_cut = self.progress.last().and_then(|required| required.spindle);
        let linked = self.progress.next().filter(|item| item.motion().is_some_and(|motion| !motion.starts));
        let in_next = linked.and_then(|item| self.rules.spindle_in_cut(&item.required));
        let is_so = |spindle: &Option<SpindleState>| self.rules.spindle_is(&block.state, *spindle);
        [requested, in_next, self.functions.waits_with()].into_iter().find(is_so).unwrap_or(in_cut)
    }

    /// Reads the items on which an approach may depend: the next two motions and what comes between them.
    fn fill_for_approach(&mut self, current: &Current<'_>) -> io::Result<()> {
        self.progress.fill(FOR_APPROACH)?;
        self.stop_at_fault(current);
        Ok(())
    }

    /// A rapid from the retract position: one of the steps to the approach point.
    pub(super) fn approach(&mut self, retracted: &mut Retracted, current: &Current<'_>) -> io::Result<Option<Phase>> {
        self.fill_for_approach(current)?;
        let block = current.block;
        if std::mem::take(&mut retracted.plane_guard_due) {
            let missing = plane_guard::missing(&self.rules, &self.previous);
            self.found_any(current, missing);
        }
        let words = self.rules.words();
        let (retract, rotary) = (1 << words.retract(), words.rotary_bits());
        // In a plane its own Z comes last. Under tip control the words of the other axes may change with it.
        let (last, with_last) = match self.rules.meaning() {
            LinearMeaning::AxisPositions => (retract, retract),
            LinearMeaning::TipCoordinates => (retract, words.linear_bits()),
            LinearMeaning::PlaneCoordinates => {
                let z = words.xyz()[2].map_or(retract, |z| 1 << z);
                (z, z)
            }
        };
        // A word that moves nothing may be in any block.
        let moved = self.rules.all_moved(&self.previous.words, self.previous.known, block);
        let step = match if moved == 0 { block.written } else { moved } {
            // A plane call may leave a rotary axis in another revolution: its word is written again.
            written if written & !rotary == 0 && moved == 0 => retracted.step.max(1),
            written if written & !rotary == 0 => 1,
            written if written & !with_last == 0 && written & last != 0 => 3,
            written if written & (rotary | last) == 0 => 2,
            _ => 0,
        };
        let turned = moved & rotary != 0;
        let goes_to = |places| step == 1 && parking::moves_rotary(&self.rules, places, &self.previous, block);
        let links = &self.rules.policy().links;
        let parks = retracted.parks && goes_to(&links.park);
        let to_station = |station: Station| self.is_due(station, block) && goes_to(station.places(links));
        if !parks && retracted.step == 0 && Station::ALL.into_iter().any(to_station) {
            self.rotate_to_station(retracted, turned, current);
            return Ok(None);
        }
        // A cut goes on with the spindle on, and its rotary axes rotate first; at the end it is off before the axes are parked.
        let rotates = step == 1 || retracted.step >= 1;
        let spindle_on = block.state.spindle.flatten().is_some();
        let continues =
            spindle_on && rotates && retracted.rewind.as_ref().is_some_and(|rewind| rewind.finished.is_some());
        if self.progress.next().is_none() && !continues || parks {
            self.park(retracted, current);
            return Ok(None);
        }
        while let Some(ExpectedItem {
            action:
                ExpectedAction::Stop { .. }
                | ExpectedAction::BlockSkip { .. }
                | ExpectedAction::Raw(_)
                | ExpectedAction::Probe { .. }
                | ExpectedAction::Home,
            ..
        }) = self.progress.next()
        {
            self.skip(1, None, current);
        }
        if step == 0 || step < retracted.step {
            self.found(
                current,
                "order of the approach: expected rotary axes first, then the other linear axes, the retract axis last",
            );
        }
        let across = step == 2 && block.written & !rotary != 0;
        let before_tip_control =
            across && block.state.tip_control == TipControl::Off && self.rules.may_have_tip_control();
        if across {
            retracted.before_tip_control = before_tip_control;
            let others = self.rules.words().linear_bits() & !retract;
            let known = block.known & others == others;
            retracted.across = if known { self.rules.across(&self.previous.words, block) } else { None };
        }
        let enters_tip_control = step == 3 && self.rules.meaning() == LinearMeaning::TipCoordinates;
        if (across || step == 3)
            && !enters_tip_control
            && retracted.meaning.replace(self.rules.meaning()).is_some_and(|before| before != self.rules.meaning())
        {
            self.found(
                current,
                "tip control or a tilted plane is switched after linear axes have moved in the approach",
            );
        }
        self.moves_once(retracted, enters_tip_control, current);
        self.home_before_rotation(retracted, turned, current);
        if let Some(since) = &mut retracted.since_plane {
            *since |= block.written & rotary;
            if enters_tip_control && *since != rotary {
                self.found(
                    current,
                    "the plane call may have left a rotary axis in another revolution or pose: its word is missing before tip control",
                );
            }
        }
        let finished =
            retracted.rewind.as_ref().and_then(|rewind| rewind.finished.as_ref()).map(|finished| &finished.required);
        if let Some(required) = self.progress.next().map(|item| &item.required).or(finished).cloned() {
            let context = ModalContext { dry: retracted.rewind.is_none(), ..ModalContext::default() };
            let frame = match before_tip_control {
                true => FrameUse::BeforeTipControl,
                false if across || step == 3 => FrameUse::AsMeant,
                false => FrameUse::Without,
            };
            let fault = self.rules.fault_at_approach(block, &required, (frame, step == 3), context);
            self.found_state(current, fault);
        }
        retracted.stopped = false;
        retracted.step = step;
        if step == 3 || step == 0 && block.written & retract != 0 {
            if !self.rules.is_known(block, block.known) {
                self.found(current, "the position of an axis is unknown at the approach point");
                self.progress.set_lost(true);
                return Ok(Some(Phase::Cutting(Box::default())));
            }
            let end = self.rules.pose(block);
            if enters_tip_control {
                self.is_over_approach_point(retracted, current, &end);
            }
            self.compare_plane(current, &end);
            return Ok(Some(Phase::Cutting(Box::new(self.arrive(retracted, current, &end)))));
        }
        Ok(None)
    }

    /// Under tip control the words of all axes change with the position of the retract axis, and a rapid need not be straight:
    /// the other axes must have arrived before.
    fn is_over_approach_point(&mut self, retracted: &Retracted, current: &Current<'_>, end: &ToolPose) {
        let (rules, before) = (&self.rules, &self.previous.words);
        let over = retracted.across.is_some_and(|at| rules.moves_retract_axis_alone(&at, before, current.block, end));
        if !over {
            self.found(
                current,
                "linear axes move together with the retract axis: they must be over the approach point before",
            );
        }
    }

    /// Each axis moves once in an approach; one that takes the shorter way may do so in steps.
    fn moves_once(&mut self, retracted: &mut Retracted, enters_tip_control: bool, current: &Current<'_>) {
        let block = current.block;
        let (before, mut moved) = retracted.approach;
        if enters_tip_control && retracted.before_tip_control {
            // Under tip control the same position has other words.
            moved &= self.rules.words().rotary_bits();
        }
        let steps = !self.rules.policy().words.rollover.is_empty();
        let rotary = self.rules.words().rotary_bits();
        let (unit_mm, unit_rad) = (self.rules.rounding().unit_mm, self.rules.rounding().unit_rad);
        let again = (0..before.len()).find(|&index| {
            let is_rotary = rotary & (1 << index) != 0;
            let unit = if is_rotary { unit_rad } else { unit_mm };
            block.written & moved & (1 << index) != 0
                && !(is_rotary && steps)
                && (block.values[index] - before[index]).abs() > 0.5 * unit
        });
        if let Some(axis) = again.and_then(|index| self.rules.axes().get(index)) {
            let text = format!("{} moves twice in this approach, to different positions", axis.letter);
            self.found(current, &text);
        }
        retracted.approach = (block.values, moved | block.written);
    }

    /// In a tilted plane the rotary axes are where the plane requires them.
    fn compare_plane(&mut self, current: &Current<'_>, end: &ToolPose) {
        let block = current.block;
        if block.state.tilt.is_none() {
            return;
        }
        let (words, rounding) = (self.rules.words(), *self.rules.rounding());
        let axis = words.tool_axis_at(&block.values);
        let off = angle_between(&axis, &end.axis);
        if off > self.rules.axis_allowance(&end.axis) {
            let off = off.to_degrees();
            self.found(current, &format!("the rotary axes are {off:.4}° off the tilted plane"));
        } else if let Some(motion) = self.progress.motion() {
            let off = angle_between(&axis, &motion.to.axis);
            let largest =
                if self.rules.is_near_pole(&motion.to.axis) { rounding.pole_rad } else { rounding.rotary_rad };
            if off > largest {
                let off = off.to_degrees();
                self.found(current, &format!("the rotary axes are {off:.4}° off the tool axis of the CL data"));
            }
        }
    }

    /// The approach has ended.
    fn arrive(&mut self, retracted: &mut Retracted, current: &Current<'_>, end: &ToolPose) -> Cutting {
        let mut cutting = Cutting { here: Some(*end), ..Cutting::default() };
        self.keeps_rapids = false;
        self.functions.wait_with(None);
        let rewind = self.rewind_of(retracted, end, current);
        let rewind = rewind.filter(|_| !(self.is_over_next(end) && self.is_other_way()));
        if rewind.is_some() {
            self.functions.resume_cuts();
        } else {
            self.cuts_have_ended(current);
        }
        if let Some(rewind) = rewind {
            let back = self.come_back(&rewind, current, end);
            // A rapid of the CL data that has led out is done, and so is the way back to its end.
            cutting.back = (!self.rules.is_at(end, &back.to)).then(|| Box::new(back));
            cutting.wet_retract = rewind.wet;
            cutting.finished = rewind.finished;
            return cutting;
        }
        self.progress.restart_motion();
        self.missing_dwells(current, true);
        let Some(starts) = self.progress.motion().map(|motion| motion.starts) else {
            self.found(current, "approach, but the CL data has no motion here");
            return cutting;
        };
        let of_item = |item: &ExpectedItem| (item.required.tool, item.required.register);
        let tool = self.progress.next().map_or((None, 0), of_item);
        for missing in self.shop_lines.approach(starts, tool) {
            self.found(current, &missing);
        }
        if starts {
            self.compare_start(current);
        }
        self.pass_lift_to_hole(end);
        let Some(motion) = self.progress.motion() else { return cutting };
        let (to, rapid, above) = (motion.to, motion.rapid, self.approach_point(0, motion));
        let (off, angle) = ((end.tip - above.tip).norm(), angle_between(&end.axis, &above.axis));
        if self.rules.is_at(end, &above) {
            self.tally.deviation(off, angle);
        } else {
            let angle = angle.to_degrees();
            self.found(
                current,
                &format!("the approach ends {off:.4} mm from the approach point, the tool axis is {angle:.4}° off"),
            );
        }
        if above == to && !rapid {
            self.found(current, "the approach leads to the end of a cut");
        }
        self.progress.approach(above);
        self.previous.arc_plane = None;
        cutting.retract = RetractedLength::starting(to, 0.0);
        if above == to {
            self.progress.pass();
        }
        cutting
    }

    fn approach_point(&self, index: usize, motion: &ClMotion) -> ToolPose {
        self.progress.approach_point(index, motion, self.rules.policy().links.approach_mm)
    }

    /// Whether a pose is the approach point of the next motion.
    fn is_over_next(&self, end: &ToolPose) -> bool {
        self.progress.motion().is_some_and(|next| self.rules.is_at(end, &self.approach_point(0, next)))
    }

    /// An approach to a hole leads straight over it, and down to it: the lift from the last position, the way over and a rapid on
    /// the way down are not needed.
    fn pass_lift_to_hole(&mut self, end: &ToolPose) {
        let ahead = |index: usize| {
            let item = self.progress.get(index)?;
            Some((item.hole.as_ref()?.number, item.motion()?))
        };
        let Some((number, _)) = ahead(0) else { return };
        let rapids = (0..).map_while(ahead).take_while(|(hole, motion)| *hole == number && motion.rapid);
        let count = rapids
            .enumerate()
            .filter(|(index, (_, motion))| self.rules.is_at(end, &self.approach_point(*index, motion)))
            .last()
            .map_or(0, |(count, _)| count);
        (0..count).for_each(|_| self.progress.pass());
    }

    /// The rewind that this approach comes back from, if the cut continues.
    fn rewind_of(&mut self, retracted: &Retracted, end: &ToolPose, current: &Current<'_>) -> Option<RewindPoint> {
        let rewind = retracted.rewind.clone()?;
        // An operation may begin where the last one ended. It has a restart point, a way back has none; safety lines of the
        // shop may say nothing.
        let begins = self.progress.motion().filter(|next| next.starts).is_some_and(|next| {
            let own_safety = self.rules.policy().shop.own_safety;
            self.start.restarted || own_safety && self.rules.is_at(end, &self.approach_point(0, next))
        });
        if rewind.finished.is_none() || !begins && self.above(&rewind, end).is_some() {
            return Some(rewind);
        }
        self.found_wet(rewind.wet, current);
        None
    }

    /// A retract with coolant, if it was `wet`, although the cut does not continue.
    pub(super) fn found_wet(&mut self, wet: bool, current: &Current<'_>) {
        if wet {
            self.found(current, "coolant was on in the retract before this block, expected off");
        }
    }

    /// The pose above a rewind point at which an approach ends, if it ends there.
    fn above(&self, rewind: &RewindPoint, end: &ToolPose) -> Option<ToolPose> {
        let pose = rewind.pose;
        // Far above, the rounding of the rotary axes counts: along the tool axis as it is now.
        let mut over = [pose.axis, end.axis].map(|axis| {
            let along = (end.tip - pose.tip).dot(&axis);
            (along, ToolPose { tip: pose.tip + axis * along, axis })
        });
        let tip_mm = self.rules.rounding().tip_mm;
        // The tool comes back from as far as it was led out, or by a new approach to the same point.
        let led_out = rewind.out.map(|out| (out.tip - pose.tip).dot(&pose.axis));
        let approach_mm = self.rules.policy().links.approach_mm;
        if let Some(out) = rewind.out {
            over[0].1 = out;
        }
        let at = |(along, above): &&(f64, ToolPose)| {
            let near = |height: f64| (along - height).abs() <= 4.0 * tip_mm;
            let far = led_out.map_or(*along >= -tip_mm, |led_out| near(led_out) || near(approach_mm));
            far && retract::is_at_distance(&self.rules, end, (above, 1.0 + BOTH), *along)
        };
        over.iter().find(at).map(|(_, above)| *above)
    }

    /// Way back from above the point at which the rotary axes were rewound.
    fn come_back(&mut self, rewind: &RewindPoint, current: &Current<'_>, end: &ToolPose) -> Segment {
        let pose = rewind.pose;
        let back = self.above(rewind, end);
        let above = back.unwrap_or_else(|| {
            let along = (end.tip - pose.tip).dot(&pose.axis);
            rewind.out.unwrap_or(ToolPose { tip: pose.tip + pose.axis * along, axis: pose.axis })
        });
        let largest_rad = COMES_BACK * self.rules.axis_allowance(&pose.axis);
        if back.is_none() || angle_between(&pose.axis, &end.axis) > largest_rad {
            self.found(current, "after the rewind the tool does not return above the point that it left");
        }
        Segment { from: above, to: pose, shape: PathShape::Line }
    }

    /// The program can be entered where an operation begins: its complete state, and a machine retract after it.
    fn compare_start(&mut self, current: &Current<'_>) {
        let own_safety = self.rules.policy().shop.own_safety;
        let mut needed = stated::COOLANT;
        if !own_safety {
            needed |= stated::OFFSET;
        }
        if self.progress.next().is_some_and(|item| item.required.spindle.is_some()) {
            needed |= stated::SPINDLE;
        }
        let missing = needed & !current.block.stated;
        for (bit, name) in [(stated::COOLANT, "coolant"), (stated::OFFSET, "work offset"), (stated::SPINDLE, "spindle")]
        {
            if missing & bit != 0 {
                self.found(
                    current,
                    &format!("operation starts without its {name}, which must be programmed after its restart point"),
                );
            }
        }
        if !own_safety && !self.start.restarted {
            self.found(current, "operation starts without a restart point, the block that sets all modal codes");
        }
        if !self.start.retracted {
            self.found(current, "operation starts without the machine retract after its restart point");
        }
        if let Some(required) = self.progress.next().map(|item| Rc::clone(&item.required)) {
            for fault in self.functions.start(&self.rules, &required, current.block) {
                self.found(current, &fault);
            }
        }
    }

    /// Rotary axes to their parking positions.
    fn park(&mut self, retracted: &mut Retracted, current: &Current<'_>) {
        let block = current.block;
        let fault = self.rules.fault_at_park(block, self.progress.last(), ModalContext::default());
        self.found_state(current, fault);
        retracted.parks = true;
        let turned = self.rules.moved(&self.previous.words, self.previous.known, block) != 0;
        self.home_before_rotation(retracted, turned, current);
        if !parking::moves_rotary(&self.rules, &self.rules.policy().links.park, &self.previous, block) {
            self.found(current, "the CL data has no motion here, and this is no parking position of the configuration");
        }
    }

    pub(super) fn tool_change(&mut self, phase: &mut Phase, current: &Current<'_>) -> io::Result<Phase> {
        let tool = current.block.state.tool;
        self.is_parked(current);
        self.ends_operation(current);
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
        let required = self.tool_due();
        if required == tool {
            self.previous.tool = tool;
        }
        match required {
            // The shop may end with another tool.
            _ if of_shop && self.progress.next().is_none() => {}
            _ if required != tool => {
                let (tool, required) = (tool_name(tool), tool_name(required));
                self.found(current, &format!("change to {tool}, but the CL data requires {required}"));
            }
            _ if !self.start.restarted => self.found(
                current,
                "tool change before the complete state of its operation: where the program is entered there, the tool is missing",
            ),
            _ => {}
        }
        if self.setters.at_block.spindle.flatten().is_some() {
            self.found(current, "tool change with the spindle on");
        }
        let undrained = self.functions.undrained(&self.rules);
        self.found_any(current, undrained);
        if !phase.is_retracted() || !self.start.retracted {
            self.found(current, "tool change before the machine has retracted");
        } else {
            self.is_at_station(Station::Change, current);
        }
        self.is_complete(phase, current);
        self.cuts_have_ended(current);
        // The axes were taken to where it is changed.
        self.start.retracted &= self.rules.policy().links.tool_change_position.is_empty();
        Ok(self.forget(phase))
    }

    /// The tool that the next record of the CL data is carried out with; after the last one the tool that has been called last.
    pub(super) fn tool_due(&self) -> Option<u32> {
        let mut ahead = (0..FOR_APPROACH).map_while(|index| self.progress.get(index));
        let carried_out = ahead.find(|item| !matches!(item.action, ExpectedAction::BlockSkip { .. }));
        carried_out.map_or(self.progress.last_tool(), |item| item.required.tool)
    }

    /// Whether the tool with which a record is carried out is in the spindle, as far as that is known.
    fn is_with_tool(&self, item: &ExpectedItem, block: &Block) -> bool {
        let (tool, required) = (block.state.tool, item.required.tool);
        tool == required || tool.is_none() && self.previous.tool.is_some()
    }

    /// Records act in the order of the CL data: a tool is changed before the records after its call.
    fn compare_tool(&mut self, current: &Current<'_>) {
        let Some(item) = self.progress.next() else { return };
        if !self.is_with_tool(item, current.block) {
            let (tool, required) = (tool_name(current.block.state.tool), tool_name(item.required.tool));
            let text =
                format!("this block comes with {tool} in the spindle, its record in the CL data with {required}");
            self.found(current, &text);
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

    /// Reports dwells of the CL data that are not in the program before a block; `all`: those between operations as well.
    pub(super) fn missing_dwells(&mut self, current: &Current<'_>, all: bool) {
        while let Some(ExpectedItem { action: ExpectedAction::Dwell { seconds, between, .. }, .. }) =
            self.progress.next()
        {
            if *between && !all {
                return;
            }
            self.found(current, &format!("the dwell of {seconds} s before this block is missing"));
            self.progress.take();
        }
    }

    pub(super) fn dwell(&mut self, phase: &mut Phase, seconds: f64, current: &Current<'_>) -> io::Result<()> {
        self.pass_needless(phase)?;
        if let Some(ExpectedItem { action: ExpectedAction::Dwell { seconds: expected, spindle, .. }, required, .. }) =
            self.progress.next()
            && (expected - seconds).abs() <= ROUNDED_DWELL
        {
            let waits = spindle.is_some_and(|_| !self.rules.spindle_is(&current.block.state, *spindle));
            let waits_with = *spindle;
            let spindles = std::iter::once(required.spindle).chain(self.progress.requested_spindle());
            let runs = spindles.into_iter().any(|spindle| self.rules.spindle_is(&current.block.state, spindle));
            self.compare_tool(current);
            self.progress.take();
            if waits_with.is_some() {
                phase.start_spindle();
                self.functions.wait_with(waits_with);
            }
            let dry = self.rules.policy().links.dry_lift_mm.is_some();
            if !dry && (waits || matches!(phase, Phase::Cutting(_)) && !runs) {
                self.found(current, "dwell with the spindle off, or at another speed or sense than in the CL data");
            }
            return Ok(());
        }
        if !phase.is_at_part() && self.shop_lines.has(current.shown.text) {
            return Ok(());
        }
        if phase.is_retracted() && self.functions.drain(seconds, &self.rules) {
            return Ok(());
        }
        let spindle = self.rules.policy().links.spindle_dwell_s;
        if spindle <= 0.0 || (spindle - seconds).abs() > ROUNDED_DWELL {
            self.found(current, &format!("dwell of {seconds} s, which neither CL data nor configuration asks for"));
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
                self.compare_tool(current);
                self.progress.take();
            }
            // The shop stops where the program and its operations start and end, and at its tool changes.
            _ if of_shop => return Ok(None),
            _ => self.found(current, "stop without STOP or OPSTOP in the CL data"),
        }
        self.functions.wait_with(None);
        self.ends_operation(current);
        self.cuts_have_ended(current);
        self.is_parked(current);
        if phase.is_at_part() {
            let fault = self.functions.end_of_cuts(&self.rules);
            self.found_any(current, fault);
        }
        let retracts = self.rules.policy().links.retracts_for_stop;
        // After the stop the retract axis moves from the position of the tool.
        if let Phase::Cutting(cutting) = &*phase
            && !retracts
            && !self.rules.retracts_along_tool()
        {
            self.has_left(cutting, current);
        }
        if retracts && !phase.is_retracted() {
            self.found(current, "program stop before the machine has retracted");
        }
        if retracts {
            self.found_state(current, fault_at_end(current.block));
        }
        self.is_complete(phase, current);
        match self.forget(phase) {
            Phase::Unknown { stopped } => Ok(Some(Phase::Unknown { stopped: stopped || retracts })),
            other => Ok(Some(other)),
        }
    }

    /// Blocks that may be skipped begin and end where OPSKIP does, with the machine retracted. What is in force after them is what
    /// the reader knows whether they were executed or not.
    pub(super) fn block_skip(&mut self, phase: &mut Phase, current: &Current<'_>) -> io::Result<()> {
        let on = current.block.skippable;
        let is = |index: usize, on: bool| {
            matches!(self.progress.get(index), Some(ExpectedItem { action: ExpectedAction::BlockSkip { on: expected }, .. })
                if *expected == on)
        };
        if !on && !self.skippable && self.progress.has_records_ahead() && is(0, true) && is(1, false) {
            // Nothing comes between them.
            self.progress.take();
            self.progress.take();
        }
        if std::mem::replace(&mut self.skippable, on) == on { Ok(()) } else { self.change_block_skip(phase, current) }
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
            _ if on => {
                self.found(current, "the operator may skip this block (`/`), without OPSKIP/ON in the CL data here")
            }
            _ => self.found(current, "this block is always executed (no `/`), without OPSKIP/OFF in the CL data here"),
        }
        self.cuts_have_ended(current);
        self.ends_operation(current);
        for missing in self.shop_lines.skip() {
            self.found(current, &missing);
        }
        self.is_parked(current);
        self.is_complete(phase, current);
        if phase.is_at_part() {
            let text = "blocks that may be skipped begin and end with the machine retracted: expected the retract before this block";
            self.found(current, text);
            let fault = self.functions.end_of_cuts(&self.rules);
            self.found_any(current, fault);
        }
        if self.previous.runs {
            let text = "blocks that may be skipped begin and end with spindle and coolant off: one of them is on before this block";
            self.found(current, text);
        }
        self.previous.known &= current.block.known_before;
        // A complete state that may be skipped, or that came before, is none for what comes after.
        self.start = StartState::default();
        self.functions.restart();
        self.forget(phase);
        *phase = match phase.is_retracted() {
            true => Phase::Retracted(Box::new(Retracted { stopped: true, ..Retracted::default() })),
            false => Phase::Unknown { stopped: true },
        };
        Ok(())
    }

    /// The end code.
    pub(super) fn end(&mut self, phase: &mut Phase, current: &Current<'_>) -> io::Result<Phase> {
        self.progress.fill(1)?;
        self.pass_needless(phase)?;
        if self.progress.next().is_some() {
            self.found(current, "end code before the end of the CL data");
        } else if let Some(last) = self.progress.last_tool().filter(|_| self.progress.last_tool() != self.previous.tool)
        {
            self.found(current, &format!("the CL data ends with a call of T{last}: the tool change is missing"));
        }
        if self.skippable {
            self.found(current, "the operator may skip the end code (`/`)");
        }
        if !phase.is_retracted() || self.shop_lines.needs_retract() {
            self.found(current, "end code before the machine has retracted");
        }
        for missing in self.shop_lines.end() {
            self.found(current, &missing);
        }
        self.found_state(current, fault_at_end(current.block));
        self.is_complete(phase, current);
        self.cuts_have_ended(current);
        self.parking_positions(current);
        Ok(Phase::Ended)
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
