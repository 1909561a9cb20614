//! The approach: from the machine retract to the approach point, or back to the cut after a rewind.

use std::f64::consts::TAU;
use std::io;

use super::super::expect::{ClMotion, ExpectedAction, ExpectedItem};
use super::super::geometry::{PathShape, Segment, ToolPose, angle_between};
use super::super::policy::LinearMeaning;
use super::super::read::{Block, TipControl};
use super::super::rules::{FrameUse, ModalContext};
use super::obligations::{Duty, DutyEvent, DutyPlace, Station};
use super::phase::{Cutting, Phase, Retracted, RetractedLength, RewindPoint};
use super::{Comparison, Current, parking, retract};
use crate::check::tolerances::{ALONG_PLANE_NORMAL, BOTH, COMES_BACK};
use crate::diag::code::check;

/// What a block of an approach moves.
#[derive(Debug, Clone, Copy)]
struct ApproachStep {
    /// 1 rotary axes, 2 the other linear axes, 3 the last axis; 0 in another order.
    number: u8,
    /// Rotary axes rotate.
    turned: bool,
    /// It is the second, and linear axes move.
    across: bool,
    /// So they do to the place where tip control begins.
    before_tip_control: bool,
    /// Tip control begins.
    enters_tip_control: bool,
}

/// Number of items on which an approach may depend.
pub(super) const FOR_APPROACH: usize = 8;

impl Comparison<'_> {
    /// Reads the items on which an approach may depend: the next two motions and what comes between them.
    pub(super) fn fill_for_approach(&mut self, current: &Current<'_>) -> io::Result<()> {
        self.progress.fill(FOR_APPROACH)?;
        self.stop_at_fault(current);
        Ok(())
    }

    /// A rapid from the retract position: one of the steps to the approach point.
    pub(super) fn approach(&mut self, retracted: &mut Retracted, current: &Current<'_>) -> io::Result<Option<Phase>> {
        self.fill_for_approach(current)?;
        self.come_to_cut(DutyPlace::ApproachStep, current);
        if current.block.written & self.rules.words().linear_bits() != 0 {
            self.duties.happens(DutyEvent::LinearStep);
        }
        if self.rules.clamps() != 0 && retracted.rewind.is_none() {
            let held = self.functions.rotates_from_restart(current.block, &self.rules);
            self.found_any(current, check::CLAMP, held);
        }
        let step = self.approach_step(retracted, current.block);
        if self.goes_elsewhere(retracted, step, current) {
            return Ok(None);
        }
        self.skip_records(current);
        if step.number == 0 || step.number < retracted.step {
            self.found(
                current,
                check::SEQUENCE,
                "order of the approach: expected rotary axes first, then the other linear axes, the retract axis last",
            );
        }
        self.compare_frame_of_step(retracted, step, current);
        self.moves_once(retracted, step.enters_tip_control, current);
        self.rotates_too_far(current);
        self.home_before_rotation(retracted, step.turned, current);
        self.compare_state_of_step(retracted, step, current);
        self.functions.state_axes(current.block.written);
        retracted.stopped = false;
        retracted.step = step.number;
        Ok(self.end_of_approach(retracted, step, current))
    }

    /// The step that a block is.
    fn approach_step(&self, retracted: &Retracted, block: &Block) -> ApproachStep {
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
        let number = match if moved == 0 { block.written } else { moved } {
            // A plane call may leave a rotary axis in another revolution: its word is written again.
            written if written & !rotary == 0 && moved == 0 => retracted.step.max(1),
            written if written & !rotary == 0 => 1,
            written if written & !with_last == 0 && written & last != 0 => 3,
            written if written & (rotary | last) == 0 => 2,
            _ => 0,
        };
        let across = number == 2 && block.written & !rotary != 0;
        ApproachStep {
            number,
            turned: moved & rotary != 0,
            across,
            before_tip_control: across
                && block.state.tip_control == TipControl::Off
                && self.rules.may_have_tip_control(),
            enters_tip_control: number == 3 && self.rules.meaning() == LinearMeaning::TipCoordinates,
        }
    }

    /// Whether a block rotates axes to another place than that of the next cut, which is compared then: to a station,
    /// or to park.
    fn goes_elsewhere(&mut self, retracted: &mut Retracted, step: ApproachStep, current: &Current<'_>) -> bool {
        let block = current.block;
        let goes_to = |places| step.number == 1 && parking::moves_rotary(&self.rules, places, &self.previous, block);
        let links = &self.rules.policy().links;
        let parks = retracted.parks && goes_to(&links.park);
        let to_station = |station: Station| self.is_due(station, block) && goes_to(station.places(links));
        if !parks && retracted.step == 0 && Station::ALL.into_iter().any(to_station) {
            self.rotate_to_station(retracted, step.turned, current);
            // Its positions may be those of the next cut.
            self.functions.state_axes(block.written);
            return true;
        }
        // A cut goes on with the spindle on, and its rotary axes rotate first; at the end it is off before the axes are
        // parked.
        let rotates = step.number == 1 || retracted.step >= 1;
        let spindle_on = block.state.spindle_is_on();
        let continues =
            spindle_on && rotates && retracted.rewind.as_ref().is_some_and(|rewind| rewind.finished.is_some());
        let parks = parks || self.progress.next().is_none() && !continues;
        if parks {
            self.park(retracted, current);
        }
        parks
    }

    /// Records before the next motion that the program does not have.
    fn skip_records(&mut self, current: &Current<'_>) {
        while let Some(ExpectedItem {
            action:
                ExpectedAction::Stop { .. }
                | ExpectedAction::BlockSkip { .. }
                | ExpectedAction::Raw(_)
                | ExpectedAction::Probe { .. }
                | ExpectedAction::Home { .. },
            ..
        }) = self.progress.next()
        {
            self.skip(1, None, current);
        }
    }

    /// Tip control and planes do not change after linear axes have moved, and all rotary words come after a plane call.
    fn compare_frame_of_step(&mut self, retracted: &mut Retracted, step: ApproachStep, current: &Current<'_>) {
        let block = current.block;
        let (retract, rotary) = (1 << self.rules.words().retract(), self.rules.words().rotary_bits());
        if step.across {
            retracted.before_tip_control = step.before_tip_control;
            let others = self.rules.words().linear_bits() & !retract;
            let known = block.known & others == others;
            retracted.across = if known { self.rules.across(&self.previous.words, block) } else { None };
        }
        let meaning = self.rules.meaning();
        if (step.across || step.number == 3)
            && !step.enters_tip_control
            && retracted.meaning.replace(meaning).is_some_and(|before| before != meaning)
        {
            self.found(
                current,
                check::SEQUENCE,
                "tip control or a tilted plane is switched after linear axes have moved in the approach",
            );
        }
        if let Some(since) = &mut retracted.since_plane {
            *since |= block.written & rotary;
            if step.enters_tip_control && *since != rotary {
                self.found(
                    current, check::SEQUENCE,
                    "the plane call may have left a rotary axis in another revolution or pose: its word is missing before tip control",
                );
            }
        }
    }

    /// The modal state of a step is that of the cut to which it leads.
    fn compare_state_of_step(&mut self, retracted: &Retracted, step: ApproachStep, current: &Current<'_>) {
        let finished = retracted.rewind.as_ref().and_then(|rewind| rewind.finished.as_ref());
        let finished = finished.map(|finished| &finished.required);
        let Some(required) = self.progress.next().map(|item| &item.required).or(finished).cloned() else { return };
        let context = ModalContext { dry: retracted.rewind.is_none(), ..ModalContext::default() };
        let frame = match step.before_tip_control {
            true => FrameUse::BeforeTipControl,
            false if step.across || step.number == 3 => FrameUse::AsMeant,
            false => FrameUse::Without,
        };
        let fault = self.rules.fault_at_approach(current.block, &required, frame, step.number == 3, context);
        self.found_state(current, fault);
    }

    /// The phase after the last step; `None` after another one.
    fn end_of_approach(
        &mut self,
        retracted: &mut Retracted,
        step: ApproachStep,
        current: &Current<'_>,
    ) -> Option<Phase> {
        let block = current.block;
        let retracts = block.written & (1 << self.rules.words().retract()) != 0;
        if !(step.number == 3 || step.number == 0 && retracts) {
            return None;
        }
        if !self.rules.is_known(block, block.known) {
            self.found(current, check::SEQUENCE, "the position of an axis is unknown at the approach point");
            self.progress.set_lost(true);
            return Some(Phase::Cutting(Box::default()));
        }
        let end = self.rules.pose(block);
        if step.enters_tip_control {
            self.is_over_approach_point(retracted, current, &end);
        }
        self.compare_plane(current, &end);
        Some(Phase::Cutting(Box::new(self.arrive(retracted, current, &end))))
    }

    /// Under tip control the words of all axes change with the position of the retract axis, and a rapid need not be
    /// straight: the other axes must have arrived before.
    fn is_over_approach_point(&mut self, retracted: &Retracted, current: &Current<'_>, end: &ToolPose) {
        let (rules, before) = (&self.rules, &self.previous.words);
        let over = retracted.across.is_some_and(|at| rules.moves_retract_axis_alone(&at, before, current.block, end));
        if !over {
            self.found(
                current,
                check::SEQUENCE,
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
            self.found(current, check::SEQUENCE, &text);
        }
        retracted.approach = (block.values, moved | block.written);
    }

    /// An axis without limits comes to every angle within a revolution; after tool vectors it may be anywhere.
    fn rotates_too_far(&mut self, current: &Current<'_>) {
        if self.rules.policy().words.tool_axis_vectors {
            return;
        }
        let (block, known) = (current.block, self.previous.known);
        let limits = self.rules.policy().set_up.travel(self.rules.axes()).limits;
        let largest = 2.0 * TAU + 1.5 * self.rules.rounding().unit_rad;
        let too_far = |&index: &usize| {
            block.written & known & (1 << index) != 0
                && limits[index].is_none()
                && (block.values[index] - self.previous.words[index]).abs() > largest
        };
        if let Some(index) = self.rules.words().rotary().find(too_far) {
            let letter = self.rules.axes()[index].letter;
            self.found(
                current,
                check::SEQUENCE,
                &format!("{letter} rotates by more than two revolutions in this approach"),
            );
        }
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
            self.found(current, check::SEQUENCE, &format!("the rotary axes are {off:.4}° off the tilted plane"));
        } else if let Some(motion) = self.progress.motion() {
            let off = angle_between(&axis, &motion.to.axis);
            let largest = if self.rules.may_be_led(&motion.to.axis) { rounding.pole_rad } else { rounding.rotary_rad };
            if off > largest {
                let off = off.to_degrees();
                self.found(
                    current,
                    check::SEQUENCE,
                    &format!("the rotary axes are {off:.4}° off the tool axis of the CL data"),
                );
            }
        }
    }

    /// The approach has ended.
    pub(super) fn arrive(&mut self, retracted: &mut Retracted, current: &Current<'_>, end: &ToolPose) -> Cutting {
        let mut cutting = Cutting { here: Some(*end), ..Cutting::default() };
        self.way.keeps_rapids = false;
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
            self.found(current, check::ORDER, "approach, but the CL data has no motion here");
            return cutting;
        };
        let of_item = |item: &ExpectedItem| (item.required.tool, item.required.register);
        let tool = self.progress.next().map_or((None, 0), of_item);
        let goes_on = std::mem::take(&mut self.previous.measured);
        let missing = self.shop_lines.approach(starts, goes_on, tool);
        self.found_all(current, check::SHOP_LINE, missing);
        if starts {
            self.come_to(DutyPlace::Operation, None, current);
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
                check::SEQUENCE,
                &format!(
                    "the approach ends {} from the approach point, the tool axis is {angle:.4}° off",
                    self.rules.units().deviation(off)
                ),
            );
        }
        if above == to && !rapid {
            self.found(current, check::SEQUENCE, "the approach leads to the end of a cut");
        }
        self.progress.approach(above);
        self.previous.arc_plane = None;
        cutting.retract = RetractedLength::starting(to, 0.0);
        if above == to {
            self.progress.pass();
            self.duties.happens(DutyEvent::Motion);
        }
        cutting
    }

    pub(super) fn approach_point(&self, index: usize, motion: &ClMotion) -> ToolPose {
        self.progress.approach_point(index, motion, self.rules.policy().links.approach_mm)
    }

    /// Whether a pose is the approach point of the next motion.
    fn is_over_next(&self, end: &ToolPose) -> bool {
        self.progress.motion().is_some_and(|next| self.rules.is_at(end, &self.approach_point(0, next)))
    }

    /// An approach to a hole leads straight over it, and down to it: the lift from the last position, the way over and
    /// a rapid on the way down are not needed.
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
        // An operation may begin where the last one ended. It has a restart point, a way back has none; safety lines of
        // the shop may say nothing.
        let begins = self.progress.motion().filter(|next| next.starts).is_some_and(|next| {
            let own_safety = self.rules.policy().shop.own_safety;
            !self.duties.owes(Duty::CompleteState) || own_safety && self.rules.is_at(end, &self.approach_point(0, next))
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
            self.found(current, check::STATE, "coolant was on in the retract before this block, expected off");
        }
    }

    /// The pose above a rewind point at which an approach ends, if it ends there.
    pub(super) fn above(&self, rewind: &RewindPoint, end: &ToolPose) -> Option<ToolPose> {
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
            far && retract::is_at_distance(&self.rules, end, above, 1.0 + BOTH, *along)
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
            self.found(
                current,
                check::SEQUENCE,
                "after the rewind the tool does not return above the point that it left",
            );
        }
        Segment { from: above, to: pose, shape: PathShape::Line }
    }

    /// Rotary axes to their parking positions.
    pub(super) fn park(&mut self, retracted: &mut Retracted, current: &Current<'_>) {
        let block = current.block;
        // Before the first tool call no plane need be selected.
        let context = ModalContext { no_plane: self.previous.tools.current.is_none(), ..ModalContext::default() };
        let fault = self.rules.fault_at_park(block, self.progress.last(), context);
        self.found_state(current, fault);
        self.parks_at_end(current);
        if retracted.linear_parked && self.rules.policy().links.home_mm.is_none() {
            self.found(current, check::SEQUENCE, "the rotary axes are parked after linear axes");
        }
        retracted.parks = true;
        let turned = self.rules.moved(&self.previous.words, self.previous.known, block) != 0;
        self.home_before_rotation(retracted, turned, current);
        if !parking::moves_rotary(&self.rules, &self.rules.policy().links.park, &self.previous, block) {
            self.found(
                current,
                check::ORDER,
                "the CL data has no motion here, and this is no parking position of the configuration",
            );
        }
    }

    /// The control positions the rotary axes to a tilted plane: to the pose in which they are.
    pub(super) fn orient(&mut self, phase: &mut Phase, current: &Current<'_>) {
        if let Phase::Retracted(retracted) = phase {
            retracted.since_plane = Some(0);
            if self.rules.facts().plane_guard {
                self.duties.happens(DutyEvent::PlaneCall);
            }
        }
        let state = &current.block.state;
        let expected = self.rules.meaning() == LinearMeaning::PlaneCoordinates || self.rules.may_have_tip_control();
        let Some(tilt) = state.tilt.filter(|_| expected) else {
            self.found(
                current,
                check::SEQUENCE,
                "the control positions the rotary axes to a tilted plane where none is expected",
            );
            return;
        };
        if tilt.rotates_table {
            self.found(
                current,
                check::STATE,
                "the control may rotate the table so that X of the plane is its X (COORD ROT is missing)",
            );
        }
        let rotary = self.rules.words().rotary_bits();
        let known = self.previous.known & rotary == rotary;
        let words = self.rules.words();
        let [axis, normal] = [words.tool_axis_at(&self.previous.words), words.place(&self.previous.words, state).axis];
        if known && angle_between(&axis, &normal) > ALONG_PLANE_NORMAL.max(self.rules.rounding().of_plane_rad()) {
            self.found(
                current,
                check::SEQUENCE,
                "the plane call rotates the rotary axes: they are not where the plane has them",
            );
        }
        if let Some(higher) = tilt.pose.filter(|_| known)
            && self.travel.selects_other_pose(&self.rules, &self.previous.words, higher)
        {
            self.found(
                current,
                check::SEQUENCE,
                "the plane call selects the other pose: the rotary axes would rotate to it",
            );
        }
    }

    /// An approach that has begun must end at the approach point.
    pub(super) fn is_complete(&mut self, phase: &Phase, current: &Current<'_>) {
        let Phase::Retracted(retracted) = phase else { return };
        if retracted.step > 0 && !retracted.parks {
            self.found(current, check::SEQUENCE, "the approach before this block does not end at an approach point");
        }
        if let Some(rewind) = &retracted.rewind {
            self.found_wet(rewind.wet, current);
        }
    }
}
