//! Blocks at the part.
//!
//! A block is one of these, in this order: a lift over a hole for the next cycle; the way back after a rewind; the rest
//! of a finished motion; a part of the next motion; a step of a rapid; a retract along the tool axis.

use std::f64::consts::PI;
use std::io;
use std::rc::Rc;

use nalgebra::Vector3;

use super::super::expect::{ClMotion, ExpectedAction, ExpectedHole, Required};
use super::super::geometry::{PathShape, Segment, ToolPose, angle_between, is_within_angle};
use super::super::policy::RapidForm;
use super::super::read::{Action, Block, MAX_AXES, SideOfPath};
use super::super::rules::{Deviation, DeviationBound, ModalContext, RotatingRapid, StateFault, Stroke};
use super::hole::lean_of_words;
use super::obligations::{Duty, DutyEvent, DutyPlace};
use super::phase::{Cutting, FinishedMotion, Leaving, Phase, RapidStart, RapidSteps, RetractedLength, RewindPoint};
use super::rapid::{RapidPart, RapidRules, is_on_line, rollover_travel};
use super::retract::RetractStart;
use super::{Comparison, Current, Previous, retract};
use crate::check::tolerances::{BOTH, COMES_BACK};
use crate::diag::code::check;
use crate::kinematics::math::smaller;
use crate::program::{Drilling, Feed, Location};
use crate::shortcut::Shortcut;

/// Largest number of motions ahead without a block that are looked through for the one that a block begins.
pub(super) const MOST_NEEDLESS: usize = 16;

impl Comparison<'_> {
    /// A block at the part without an approach.
    pub(super) fn astray(&mut self, phase: &mut Phase, current: &Current<'_>) -> io::Result<Option<Phase>> {
        if !self.rules.is_known(current.block, current.block.known) {
            self.found(current, check::PATH, "the position of an axis is unknown at this block");
            return Ok(None);
        }
        let mut cutting = match phase {
            Phase::Leaving(leaving) => {
                self.found(current, check::SEQUENCE, "machine retract expected after the retract along the tool axis");
                Cutting { here: Some(leaving.here), retract: leaving.retract, ..Cutting::default() }
            }
            _ => {
                self.found(current, check::ORDER, "motion at the part without an approach before it");
                Cutting::default()
            }
        };
        self.progress.set_lost(true);
        let next = self.cut(&mut cutting, current)?;
        Ok(Some(next.unwrap_or_else(|| Phase::Cutting(Box::new(cutting)))))
    }

    /// A block at the part.
    pub(super) fn cut(&mut self, cutting: &mut Cutting, current: &Current<'_>) -> io::Result<Option<Phase>> {
        let block = current.block;
        if !self.rules.is_known(block, block.known) {
            self.found(current, check::PATH, "the position of an axis is unknown at this block");
            return Ok(None);
        }
        self.stays_in_plane(current);
        let end = self.rules.pose(block);
        let rapid = block.action.is_rapid();
        if self.may_lead_out(cutting, block, &end)
            && self.is_other_way()
            && let Some(leaving) = self.retract(cutting, current, &end)?
        {
            self.way.keeps_rapids = true;
            return Ok(Some(Phase::Leaving(Box::new(leaving))));
        }
        // Motions that need no block may come before the hole.
        let may_lift = rapid || self.rules.policy().links.rapid == RapidForm::Feed;
        let carried_out = may_lift && self.lifts_for_cycle(cutting, current, &end)
            || self.carry_out(cutting, current, &end)?
            || may_lift && self.lifts_for_cycle(cutting, current, &end);
        if !carried_out {
            // A rapid to where the axes are moves nothing.
            if rapid && self.stays(block) {
                return Ok(None);
            }
            if rapid && let Some(leaving) = self.retract(cutting, current, &end)? {
                return Ok(Some(Phase::Leaving(Box::new(leaving))));
            }
            self.resume(cutting, current, &end)?;
        }
        cutting.here = Some(end);
        self.arrived = true;
        Ok(None)
    }

    /// Reads ahead over motions that need no block, to the item after them.
    fn read_over_needless(&mut self, here: Option<&ToolPose>) -> io::Result<()> {
        let mut count = 0;
        while count < MOST_NEEDLESS && self.is_needless(count, here) {
            count += 1;
            self.progress.fill(count + 1)?;
        }
        Ok(())
    }

    /// Whether the words of a block are those before it.
    fn stays(&self, block: &Block) -> bool {
        let Previous { words, known, .. } = &self.previous;
        let same = |index: usize| (block.values[index] - words[index]).abs() <= 0.0;
        block.written & !known == 0 && (0..MAX_AXES).all(|index| block.written & (1 << index) == 0 || same(index))
    }

    /// In a tilted plane the rotary axes stay where the plane has them.
    fn stays_in_plane(&mut self, current: &Current<'_>) {
        let block = current.block;
        if block.state.tilt.is_none() {
            return;
        }
        let known = self.previous.known & block.written & self.rules.words().rotary_bits();
        let limit = 1.5 * self.rules.rounding().unit_rad;
        let moved = |index: usize| (block.values[index] - self.previous.words[index]).abs() > limit;
        if (0..MAX_AXES).any(|index| known & (1 << index) != 0 && moved(index)) {
            self.found(current, check::PATH, "rotary axes move out of the tilted plane at the part");
        }
    }

    /// Lets the block carry out the next motion, or a part of it, and passes motions that need no block; `false` if it
    /// does not fit.
    fn carry_out(&mut self, cutting: &mut Cutting, current: &Current<'_>, end: &ToolPose) -> io::Result<bool> {
        if self.is_rapid_after_retract(cutting, current.block, end) {
            cutting.back = None;
            self.found_wet(std::mem::take(&mut cutting.wet_retract), current);
            cutting.here.into_iter().for_each(|here| self.progress.approach(here));
        }
        if let Some(back) = cutting.back.clone() {
            return Ok(self.come_back_to_cut(cutting, &back, current, end));
        }
        while self.progress.repeats() {
            self.progress.pass();
            self.progress.fill(2)?;
        }
        self.progress.fill(2)?;
        let leads_away = self.progress.leads_away(&self.rules, cutting.here.as_ref(), self.previous.chords);
        if !leads_away {
            self.read_over_needless(cutting.here.as_ref())?;
        }
        if self.is_rest(cutting, current.block, end) {
            Ok(true)
        } else {
            self.carry_out_next(cutting, current, end, leads_away)
        }
    }

    /// Lets the block carry out the next motion or one after it. `leads_away`: the next one needs its block.
    fn carry_out_next(
        &mut self,
        cutting: &mut Cutting,
        current: &Current<'_>,
        end: &ToolPose,
        mut leads_away: bool,
    ) -> io::Result<bool> {
        let (block, chords) = (current.block, self.previous.chords);
        loop {
            self.progress.fill(2)?;
            let Some(item) = self.progress.next() else { return Ok(false) };
            let motion = match &item.action {
                ExpectedAction::Motion(motion) => motion,
                // It may come after the retract along the tool axis.
                ExpectedAction::Dwell { between: true, .. } if self.may_lead_out(cutting, block, end) => {
                    return Ok(false);
                }
                ExpectedAction::Dwell { .. } => {
                    self.missing_dwells(current, true);
                    continue;
                }
                _ => return Ok(false),
            };
            let (rapid, starts) = (motion.rapid, motion.starts);
            if starts && !self.progress.is_approached() {
                return Ok(false);
            }
            let (here, hole) = (cutting.here.as_ref(), item.hole.clone());
            let (at, required, feed) = (item.at, Rc::clone(&item.required), self.rules.feed_of(motion));
            let segment = self.progress.segment(motion, here, end);
            let mut part = MotionPart { segment, rapid, starts, feed, share: 0.0, at, required };
            // A full circle ends where it began, like a motion to the same point before it; so does a rapid after a cut
            // of no length.
            let other = matches!(block.action, Action::Arc(_)) || (block.action.is_rapid() && !rapid);
            let leads_away = std::mem::take(&mut leads_away);
            let needless = !leads_away && self.rules.needs_no_block(&part.segment, here, chords);
            // A block that continues from the end of a motion belongs to a later one, and so does one with another feed
            // or state.
            let has_state = || self.rules.fault_in_cut(block, &part.required, self.modal_context()).is_none();
            let belongs =
                || self.rules.is_at(end, &part.segment.to) && self.has_feed_of(here, block, end, &part) && has_state();
            if needless && (other || !belongs()) {
                self.progress.pass();
                continue;
            }
            let (arrival, words) = (self.progress.arrival(here, chords), &self.previous.words);
            let share = self.rules.share_done(&part.segment, rapid, block, (words, end), &arrival);
            let over_hole = hole.as_ref().and_then(|hole| self.share_over_hole(&part, hole, block, end));
            if let Some(share) = over_hole.filter(|share| *share >= 1.0).or(share).or(over_hole) {
                part.share = share;
                self.travelled(cutting, current, end, &part);
                return Ok(true);
            }
            if rapid && self.is_step_of_rapid(cutting, current, &part.required) {
                return Ok(true);
            }
            if !needless {
                return Ok(false);
            }
            self.progress.pass();
        }
    }

    /// Whether a block has the feed of a motion. `here`, `end`: poses before and after it. Asked of few blocks.
    #[inline(never)]
    fn has_feed_of(&self, here: Option<&ToolPose>, block: &Block, end: &ToolPose, part: &MotionPart) -> bool {
        let (rules, words, segment) = (&self.rules, &self.previous.words, &part.segment);
        let length = segment.length();
        // What is left of a motion that is done but for a rotation.
        let left = match (&segment.shape, here.filter(|_| self.progress.along() > 0.0)) {
            (_, None) => length,
            (PathShape::Line, Some(here)) => segment.length_between([&here.tip, &segment.to.tip]),
            (_, Some(here)) => (1.0 - self.progress.along().max(rules.share_at(segment, here))) * length,
        };
        let lengths = (left, length);
        let fault = || {
            let path = rules.path(*words, block);
            let deviation = here.and_then(|here| rules.deviation(&path, [here, end], segment, 0.0));
            let stroke = rules.stroke(words, block, lengths, part.feed, &part.required);
            let stroke = stroke.with_tip_rate(deviation.as_ref(), &part.required);
            rules.feed_fault(&stroke, &block.state, segment, [&segment.from, &segment.to])
        };
        !block.action.is_feed() || fault().is_none()
    }

    /// Share of a rapid to a hole or on its axis that a block has done: it may stop on its way down, because a cycle of
    /// the control returns to where it began. Words across the tool are those of the clearance level at every height;
    /// from there words along it follow the axis that the machine has. Its tolerance holds for what both lead off each
    /// other.
    fn share_over_hole(&self, part: &MotionPart, hole: &ExpectedHole, block: &Block, end: &ToolPose) -> Option<f64> {
        let (segment, rounding) = (&part.segment, self.rules.rounding());
        let largest = BOTH * rounding.tip_mm;
        let along = |step: Vector3<f64>| step.dot(&end.axis);
        let step = end.tip - hole.clearance_point().tip;
        let leads_off_mm =
            || along(step).abs() * lean_of_words(&self.rules, block, [0.0, 1.0], &hole.hole).unwrap_or(0.0);
        let off = |step: Vector3<f64>| (step - end.axis * along(step)).norm();
        let is_over =
            |off_mm: f64| off_mm <= largest || off_mm <= largest + leads_off_mm().min(part.required.tolerance_mm);
        // The lift off the hole before it is not on its axis.
        let over = is_over(off(step)) && is_over(off(segment.to.tip - hole.clearance_point().tip));
        let [from, to] = [segment.from.tip, segment.to.tip].map(|tip| along(end.tip - tip));
        let leans_rad = segment.axis_arc().distance(&end.axis);
        // Words across the tool keep the level of a plane that leans as much.
        let level = largest + leans_rad * segment.length();
        // On its way up it comes to the clearance level before it moves across.
        let down = to >= -level;
        let on_axis = over && down && from.abs() + to.abs() <= along(segment.to.tip - segment.from.tip).abs() + level;
        let near = part.rapid && leans_rad <= BOTH * rounding.axis_rad;
        let done = if over && to.abs() <= level { 1.0 } else { 0.0 };
        (near && (on_axis || segment.distance(end, 0.0) <= largest)).then_some(done)
    }

    /// A block that carries out a part of a motion: its state, its path, its feed.
    fn travelled(&mut self, cutting: &mut Cutting, current: &Current<'_>, end: &ToolPose, part: &MotionPart) {
        let block = current.block;
        let on = part.segment.at(part.share);
        if !part.rapid || part.share >= 1.0 {
            self.count_deviation(end, &on);
        }
        let judged = self.right_state.as_ref().is_some_and(|required| Rc::ptr_eq(required, &part.required));
        let right_state = judged || self.compare_state(current, &part.required);
        let at_feed = !block.action.is_rapid();
        let known = self.rules.is_known(block, self.previous.known);
        self.compare_functions(current, part, at_feed && known);
        let rules = if part.rapid { self.rapid_rules(cutting, current, part) } else { RapidRules::CUT };
        let RapidRules { expects_feed, follows_path, link, .. } = rules;
        if at_feed != expects_feed {
            let text = match at_feed {
                true => "this motion is a rapid in the CL data and is programmed at feed",
                false => "this motion is a feed motion in the CL data and is programmed as a rapid",
            };
            self.found(current, check::FEED, text);
        } else if at_feed && !judged {
            let fault = self.functions.smoothing(&block.state, &self.rules, part.required.smoothing);
            let right = self.rules.is_judged_by_state(block, &part.required) && fault.is_none() && right_state;
            self.right_state = right.then(|| Rc::clone(&part.required));
            self.found_any(current, check::STATE, fault);
        }
        if at_feed == expects_feed && follows_path && known && !self.progress.is_lost() {
            let here = cutting.here.unwrap_or_else(|| self.rules.words().place(&self.previous.words, &block.state));
            let between = self.compare_path(current, ([&here, end], &on), part);
            if at_feed {
                let along = match cutting.has_rested() {
                    true => self.rules.share_at(&part.segment, &here).min(part.share),
                    false => self.progress.along(),
                };
                self.compare_feed(current, part, ([&here, end], along), between);
            }
        }
        if let Some(steps) = cutting.steps.take() {
            self.end_rapid_steps(&steps, current);
        }
        // The machine retracts along the axis that it has: tool axes of the CL data that it cannot tell apart are one.
        let start = part.segment.tip_at(self.progress.along());
        cutting.retract.follow(&start, &ToolPose { axis: end.axis, ..on });
        if !part.rapid {
            self.come_to_cut(DutyPlace::Cut, current);
        }
        self.duties.happens(DutyEvent::Motion);
        self.progress.set_lost(false);
        self.finish_part(cutting, end, part, at_feed, link);
    }

    /// Largest deviations at the end of a block. No other angle than the largest so far is reported. Points of an even
    /// rotation of the rotary axes are not on the great circle.
    fn count_deviation(&mut self, end: &ToolPose, on: &ToolPose) {
        let counts = !is_within_angle(&end.axis, &on.axis, self.tally.largest_axis_deviation())
            && self.rules.is_axis_near(&end.axis, &on.axis, BOTH);
        let angle = if counts { angle_between(&end.axis, &on.axis) } else { 0.0 };
        self.tally.deviation((end.tip - on.tip).norm(), angle);
    }

    /// What has to be on or off in a part of a motion; `rotates`: its rotary axes may rotate at feed.
    fn compare_functions(&mut self, current: &Current<'_>, part: &MotionPart, rotates: bool) {
        if part.required.side != SideOfPath::None {
            let unguarded = self.functions.cut_with_radius(&self.rules);
            self.found_any(current, check::GUARD, unguarded);
        }
        if rotates {
            let rotated_rad = self.rules.words().rotary_travel(&self.previous.words, &current.block.values);
            // At a pole an axis may have to go round between its limits.
            if rotated_rad > 4.0 * PI {
                let degrees = rotated_rad.to_degrees();
                self.found(
                    current,
                    check::PATH,
                    &format!("a rotary axis rotates by {degrees:.3}° in this cut, farther than any tool axis asks for"),
                );
            }
        }
    }

    /// A part of a motion is done, at feed or not, as a link or not.
    fn finish_part(&mut self, cutting: &mut Cutting, end: &ToolPose, part: &MotionPart, at_feed: bool, link: bool) {
        let required = Rc::clone(&part.required);
        if part.share >= 1.0 {
            self.progress.pass();
            let (segment, feed) = (part.segment.clone(), part.feed);
            cutting.finished = Some(FinishedMotion { segment, required, feed, at_feed, link, rotated_rad: 0.0 });
            return;
        }
        self.progress.advance(part.at, required, part.share);
        cutting.finished = None;
        if part.rapid && part.share <= 0.0 {
            // The corner of a rapid in two blocks.
            self.progress.begin_at(*end);
        }
    }

    /// Rules of a block that carries out a part of a rapid.
    #[inline(never)]
    fn rapid_rules(&mut self, cutting: &mut Cutting, current: &Current<'_>, part: &MotionPart) -> RapidRules {
        let begun = cutting.rapid_from.take();
        let is_begun = begun.as_ref().is_some_and(|begun| !begun.is_corner);
        // The corner of a rapid in two blocks is on neither half of its line.
        let is_corner = part.share <= 0.0 && self.rules.policy().links.rapid == RapidForm::TwoBlocks;
        let start = cutting.steps.as_ref().map_or(&self.previous.words, |steps| &steps.start);
        let mut from = begun.unwrap_or_else(|| Box::new(RapidStart { words: *start, is_corner }));
        let (segment, block) = (&part.segment, current.block);
        let rapid = RapidPart {
            begun: is_begun,
            ends: part.share >= 1.0 || is_corner,
            // The motion down from the approach point is a rapid if it is one in the CL data.
            approaches: part.starts || self.progress.is_approached(),
            in_thread: self.is_in_thread(),
            in_hole: self.progress.next().is_some_and(|item| item.hole.is_some()),
            rotates: match block.state.vector {
                Some(_) => self.rules.rotated_for(&segment.from.axis, &segment.to.axis) != 0,
                None => self.rules.rotates(&from.words, self.previous.known, block),
            },
        };
        let rules = RapidRules::of(&self.rules, block, rapid);
        if part.share < 1.0 {
            from.is_corner = is_corner;
            cutting.rapid_from = Some(from);
        }
        if rules.lacks_retract {
            self.rotates_at_part(current);
        }
        rules
    }

    /// Compares the modal state of a block, and returns whether it is right.
    #[inline(never)]
    pub(super) fn compare_state(&mut self, current: &Current<'_>, required: &Required) -> bool {
        let fault = self.rules.fault_at_path(current.block, required, self.modal_context());
        let right = fault.is_none();
        self.found_state(current, fault);
        right
    }

    /// Whether the next item belongs to a thread, whose motions are a cycle of their own on some controls.
    pub(super) fn is_in_thread(&self) -> bool {
        let hole = self.progress.next().and_then(|item| item.hole.as_ref());
        hole.is_some_and(|expected| matches!(expected.hole.drilling, Drilling::Tap { .. }))
    }

    /// Whether a rotary axis rotates by more than the index angle.
    pub(super) fn rotates(&self, block: &Block) -> bool {
        self.rules.rotates(&self.previous.words, self.previous.known, block)
    }

    /// Reports a rapid that rotates the rotary axes at the part.
    pub(super) fn rotates_at_part(&mut self, current: &Current<'_>) {
        if self.rules.link_form() != RotatingRapid::OneRapid {
            self.found(
                current,
                check::SEQUENCE,
                "this rapid rotates the rotary axes near the part: the retract before it is missing",
            );
        }
    }

    /// Compares the path between the ends of a block; `on`: pose of the motion at its end.
    fn compare_path(
        &mut self,
        current: &Current<'_>,
        (ends, on): ([&ToolPose; 2], &ToolPose),
        part: &MotionPart,
    ) -> BetweenEnds {
        if let Some(bound) = self.small_deviation(current, (ends, on), part) {
            return BetweenEnds::Within(bound);
        }
        self.compare_points(current, ends, part)
    }

    /// Compares the path at points between the ends, where bounds do not decide.
    #[inline(never)]
    fn compare_points(&mut self, current: &Current<'_>, ends: [&ToolPose; 2], part: &MotionPart) -> BetweenEnds {
        let path = self.rules.path(self.previous.words, current.block);
        let along = self.progress.along();
        let Some(deviation) = self.rules.deviation(&path, ends, &part.segment, along) else {
            return BetweenEnds::Straight;
        };
        self.tally.path_deviation(deviation.tip_mm);
        let (largest_mm, largest) = self.largest_between(part);
        let tip = deviation.tip_mm;
        if tip > largest_mm {
            let [tip, largest] = [tip, largest_mm].map(|mm| self.rules.units().deviation(mm));
            let text = format!("within this block the tip deviates from its path by {tip}, allowed {largest}");
            self.found(current, check::PATH, &text);
        }
        let policy = self.rules.policy();
        if deviation.axis_rad > largest && !policy.links.rewinds_in_cut {
            let (axis, largest) = (deviation.axis_rad.to_degrees(), largest.to_degrees());
            let text = format!(
                "within this block the tool axis deviates from its great circle by {axis:.4}°, allowed {largest:.4}°"
            );
            self.found(current, check::PATH, &text);
        }
        // Where the tool axis rotates in the plane of its ends it is in step with the tip, within the tolerance of
        // that.
        let length = part.segment.length();
        let reach = if length > 0.0 { largest_mm / length } else { 1.0 };
        let lag = deviation.lag_rad - part.segment.turn() * reach;
        if lag > largest && deviation.axis_rad <= largest && !policy.links.rewinds_in_cut {
            let (lag, largest) = (lag.to_degrees(), largest.to_degrees());
            let text = format!(
                "within this block the tool axis is {lag:.4}° from where it should be at the tip, allowed {largest:.4}°"
            );
            self.found(current, check::PATH, &text);
        }
        BetweenEnds::Measured(deviation)
    }

    /// Largest deviations of tip and tool axis from a motion between the ends of a block, mm and rad.
    fn largest_between(&self, part: &MotionPart) -> (f64, f64) {
        let rounding = self.rules.rounding();
        let axis_rad = self.rules.policy().tolerances.axis_path_rad + rounding.pole_rad;
        (part.required.tolerance_mm + rounding.tip_mm, axis_rad)
    }

    /// Bounds of the deviation between the ends of a block, if they show that it is allowed, and no larger than the
    /// largest so far: then nothing depends on its value.
    fn small_deviation(
        &self,
        current: &Current<'_>,
        (ends, on): ([&ToolPose; 2], &ToolPose),
        part: &MotionPart,
    ) -> Option<DeviationBound> {
        if !Shortcut::DeviationBounds.is_on() {
            return None;
        }
        let (tip_mm, axis_rad) = self.largest_between(part);
        let tip_mm = smaller(tip_mm, self.tally.largest_path_deviation());
        let bound = match &part.segment.shape {
            PathShape::Line => self.bound_of_line(current, (ends, on), part, tip_mm)?,
            PathShape::Arc(arc) => {
                let path = self.rules.path(self.previous.words, current.block);
                self.rules.arc_bound(&path, arc, self.progress.along())?
            }
            PathShape::Cubic(_) => return None,
        };
        (bound.tip_mm <= tip_mm && bound.axis_rad <= axis_rad).then_some(bound)
    }

    /// The bounds of a straight block on a straight motion; one for the tip of `enough_mm` or less need not be the
    /// smallest. `None` where the rotary axes rest, so that the tip goes straight.
    fn bound_of_line(
        &self,
        current: &Current<'_>,
        (ends, on): ([&ToolPose; 2], &ToolPose),
        part: &MotionPart,
        enough_mm: f64,
    ) -> Option<DeviationBound> {
        let block = current.block;
        let by_axes = self.previous.at_part && !self.rules.policy().words.axis_in_plane;
        let rests = self.rules.words().rotary_travel(&self.previous.words, &block.values) <= 0.0;
        if !block.action.is_feed() || !by_axes || block.state.has_frame() || rests {
            return None;
        }
        let along = self.progress.along();
        let done = (along > 0.0).then(|| part.segment.at(along));
        let before = done.as_ref().unwrap_or(&part.segment.from);
        Some(self.rules.deviation_bound([&self.previous.words, &block.values], ends, [before, on], enough_mm))
    }

    /// `ends`: poses before and after the block; `along`: share of the motion that was done before it.
    fn compare_feed(
        &mut self,
        current: &Current<'_>,
        part: &MotionPart,
        (ends, along): ([&ToolPose; 2], f64),
        between: BetweenEnds,
    ) {
        let (block, segment) = (current.block, &part.segment);
        let length = match segment.shape {
            // The tips show it; the tool axis may be elsewhere, as at the pole.
            PathShape::Line => segment.length_between(ends.map(|end| &end.tip)),
            _ if matches!(block.action, Action::Arc(_)) => (part.share - along) * segment.length(),
            _ => (segment.tip_at(part.share) - segment.tip_at(along)).norm(),
        };
        let (rules, words, lengths) = (&self.rules, &self.previous.words, (length, segment.length()));
        let stroke = rules.stroke(words, block, lengths, part.feed, &part.required);
        let rates_mm = match &between {
            BetweenEnds::Straight => [0.0; 2],
            BetweenEnds::Measured(deviation) => [deviation.tip_rate_mm; 2],
            BetweenEnds::Within(bound) => [0.0, bound.tip_rate_mm],
        };
        if !Shortcut::FeedBounds.is_on()
            || !rules.is_feed_plainly_right(&stroke, &block.state, rates_mm, &part.required)
        {
            self.compare_feed_closely(current, part, (ends, along), stroke, between);
        }
    }

    /// Compares the feed of a block where it is not plainly right: few are.
    #[inline(never)]
    fn compare_feed_closely(
        &mut self,
        current: &Current<'_>,
        part: &MotionPart,
        (ends, along): ([&ToolPose; 2], f64),
        stroke: Stroke,
        between: BetweenEnds,
    ) {
        let (block, segment) = (current.block, &part.segment);
        let (rules, words) = (&self.rules, &self.previous.words);
        let is_line = matches!(segment.shape, PathShape::Line) && matches!(between, BetweenEnds::Within(_));
        let rates_mm = if is_line { rules.rates_by_ends([words, &block.values], ends) } else { None };
        if rates_mm.is_some_and(|mm| rules.is_feed_plainly_right(&stroke, &block.state, mm, &part.required)) {
            return;
        }
        let deviation = match between {
            BetweenEnds::Straight => None,
            BetweenEnds::Measured(deviation) => Some(deviation),
            BetweenEnds::Within(_) => rules.deviation(&rules.path(*words, block), ends, segment, self.progress.along()),
        };
        let stroke = stroke.with_tip_rate(deviation.as_ref(), &part.required);
        let of = |stroke: &Stroke| self.rules.feed_fault(stroke, &block.state, segment, ends);
        // F may be that of the motion of the CL data or of the one that the words lead on: after a cycle that leans
        // they differ.
        let as_asked = || Stroke { length_mm: (part.share - along).abs() * segment.length(), ..stroke.clone() };
        let is_line = matches!(segment.shape, PathShape::Line);
        let fault = of(&stroke).filter(|_| !is_line || of(&as_asked()).is_some());
        self.found_any(current, check::FEED, fault);
    }

    /// Whether a block is the next rapid, and the retract before it no rewind: the cut was done.
    fn is_rapid_after_retract(&self, cutting: &Cutting, block: &Block, end: &ToolPose) -> bool {
        let suits = |motion: &ClMotion| motion.rapid && !motion.starts && self.rules.is_at(end, &motion.to);
        let done = cutting.back.is_some() && cutting.finished.is_some();
        done && block.action.is_rapid() && self.progress.motion().is_some_and(suits)
    }

    /// The way back to the point at which the rotary axes were rewound.
    fn come_back_to_cut(
        &mut self,
        cutting: &mut Cutting,
        back: &Segment,
        current: &Current<'_>,
        end: &ToolPose,
    ) -> bool {
        let block = current.block;
        // The cut was interrupted at a point that rounded words show.
        let at_end = self.rules.is_near(end, &back.to, [COMES_BACK; 2]);
        if block.action.is_rapid() || !at_end {
            return false;
        }
        let goes_on = self.progress.next().filter(|_| self.progress.motion().is_some_and(|motion| !motion.starts));
        let required = goes_on.map(|item| &item.required).or(cutting.finished.as_ref().map(|motion| &motion.required));
        if let Some(expected) = required.map(|required| required.smoothing) {
            let smoothing = self.functions.smoothing(&block.state, &self.rules, expected);
            self.found_any(current, check::STATE, smoothing);
        }
        let (before, known) = (self.previous.words, self.previous.known);
        let rotary = self.rules.words().rotary_bits();
        let rotated = self.rules.words().rotary_travel(&before, &block.values);
        if known & rotary == rotary && rotated > 1.5 * self.rules.rounding().unit_rad {
            self.found(
                current,
                check::SEQUENCE,
                "the rotary axes rotate on the way back to the part: a rewind rotates them at the retract position \
                 only",
            );
        }
        // The cut may have been interrupted just before the end of a motion, or just after it.
        let feed = self.progress.motion().map(|motion| self.rules.feed_of(motion));
        let entry = self.rules.policy().links.entry_feed_mm_per_min.map(Feed::PerMinute);
        let next = self.progress.next().map(|item| Rc::clone(&item.required)).zip(feed.map(|feed| entry.or(feed)));
        let finished =
            cutting.finished.as_ref().map(|finished| (Rc::clone(&finished.required), entry.or(finished.feed)));
        let fault = |(required, programmed): &(Rc<Required>, Option<Feed>)| {
            let state = self.rules.fault_at_path(block, required, self.modal_context());
            let feed = state.is_none() && self.rules.is_known(block, known);
            let stroke = || self.rules.stroke(&before, block, (back.length(), f64::INFINITY), *programmed, required);
            let feed =
                if feed { self.rules.feed_fault(&stroke(), &block.state, back, [&back.from, &back.to]) } else { None };
            state.or(feed.map(|text| StateFault { code: check::FEED, ..text.into() }))
        };
        let faults: Vec<Option<StateFault>> = next.iter().chain(&finished).map(fault).collect();
        if faults.iter().all(Option::is_some) {
            self.found_state(current, faults.into_iter().flatten().next());
        }
        cutting.back = None;
        cutting.retract = RetractedLength::starting(self.progress.on_path(&back.to), 0.0);
        true
    }

    /// Whether a block is the rest of a finished motion: a step of one unit, or near the pole a rotation of the rotary
    /// axes, by half a revolution at most (a whole one between limits), where the tool axis is at its end already.
    fn is_rest(&self, cutting: &mut Cutting, block: &Block, end: &ToolPose) -> bool {
        let (rules, here) = (&self.rules, cutting.here.as_ref());
        let Some(finished) = cutting.finished.as_mut().filter(|_| rules.is_known(block, self.previous.known)) else {
            return false;
        };
        !rules.is_far_from_end(&finished.segment, end) && self.is_rest_of(finished, here, block, end)
    }

    /// Whether a block near the end of a finished motion is the rest of it; few are near.
    #[inline(never)]
    fn is_rest_of(
        &self,
        finished: &mut FinishedMotion,
        here: Option<&ToolPose>,
        block: &Block,
        end: &ToolPose,
    ) -> bool {
        let rules = &self.rules;
        let FinishedMotion { segment, required, at_feed, link, .. } = &*finished;
        let same_kind = match block.action {
            Action::Feed | Action::Arc(_) => *at_feed,
            Action::Rapid => {
                !*at_feed && (*link || rules.link_form() == RotatingRapid::OneRapid || !self.rotates(block))
            }
            _ => false,
        };
        let before = &self.previous.words;
        let rotation = rules.words().rotary_travel(before, &block.values);
        let rotated_rad = finished.rotated_rad + rotation;
        // Rounding may show an end of a rotation at the pole where it is only near.
        let near = rotation > 0.5 * rules.rounding().unit_rad && rules.is_almost_done(segment, end);
        let tolerance_mm = required.tolerance_mm + if near { BOTH * rules.rounding().tip_mm } else { 0.0 };
        let is_rest = same_kind
            && rotated_rad <= rules.largest_rest_rad()
            && (near || rules.is_at(end, &segment.to))
            && !self.begins_next(finished, here, block, end)
            && rules.stays_at(&rules.path(*before, block), &segment.to, tolerance_mm)
            && rules.fault_in_cut(block, required, self.modal_context()).is_none()
            && self.has_feed_of_rest(finished, block, end);
        if is_rest {
            finished.rotated_rad = rotated_rad;
        }
        is_rest
    }

    /// Whether a block near the end of a finished motion begins the next one: a rotation after a dwell or before
    /// another speed or coolant, or a step that ends nearer to the end of the next motion.
    fn begins_next(&self, finished: &FinishedMotion, here: Option<&ToolPose>, block: &Block, end: &ToolPose) -> bool {
        let (rules, FinishedMotion { segment, required, .. }) = (&self.rules, finished);
        let off = |to: &ToolPose| (end.tip - to.tip).norm();
        let process = |required: &Required| (required.spindle, required.coolant);
        let changes = || self.progress.next().is_some_and(|item| process(&item.required) != process(required));
        match self.progress.next().map(|item| &item.action) {
            Some(ExpectedAction::Dwell { .. }) => self.rotates(block),
            Some(ExpectedAction::Motion(_)) if changes() && self.rotates(block) => true,
            // Before that motion there may be others that need no block.
            Some(ExpectedAction::Motion(_)) => {
                let needless = (0..MOST_NEEDLESS).take_while(|index| self.is_needless(*index, here)).count();
                let mut motions = (0..=needless).filter_map(|index| match &self.progress.get(index)?.action {
                    ExpectedAction::Motion(motion) => Some(&motion.to),
                    _ => None,
                });
                let turned = rules.moved(&self.previous.words, self.previous.known, block) != 0;
                let axis_off = |to: &ToolPose| angle_between(&end.axis, &to.axis);
                let nearer = |to: &ToolPose| match turned {
                    true => axis_off(to) + rules.rounding().axis_rad < axis_off(&segment.to),
                    false => off(to) < off(&segment.to),
                };
                motions.any(|to| nearer(to) && rules.is_at(end, to))
            }
            _ => false,
        }
    }

    /// Whether a block that may be the rest of a finished motion has its feed.
    fn has_feed_of_rest(&self, finished: &FinishedMotion, block: &Block, end: &ToolPose) -> bool {
        let (rules, before) = (&self.rules, &self.previous.words);
        let FinishedMotion { segment, required, feed, at_feed, .. } = finished;
        let from = rules.pose_from(before, block);
        let moved_mm = (from.tip - end.tip).norm();
        let stays = moved_mm < 0.5 * rules.rounding().unit_mm;
        // Both ends are rounded: a last piece of one unit may look like none.
        let longest = if stays { moved_mm + 2.0 * rules.rounding().tip_mm } else { f64::INFINITY };
        let deviation = rules.deviation(&rules.path(*before, block), [&from, end], segment, 0.0);
        let stroke = rules.stroke(before, block, (0.0, longest), *feed, required);
        let stroke = stroke.with_tip_rate(deviation.as_ref(), required);
        !at_feed || rules.feed_fault(&stroke, &block.state, segment, [&segment.from, &segment.to]).is_none()
    }

    /// Whether a block is a step of a rapid: an axis that takes the shorter way and has half a revolution to go, or
    /// more, goes in steps, and all axes their share. Each step is on the line of those before it; `end_rapid_steps`
    /// compares that line with the rapid.
    fn is_step_of_rapid(&mut self, cutting: &mut Cutting, current: &Current<'_>, required: &Required) -> bool {
        let (before, block) = (self.previous.words, current.block);
        let links = &self.rules.policy().links;
        let unit_rad = self.rules.rounding().unit_rad;
        let far = links.direct || links.index_angle_rad >= PI - unit_rad;
        let rotates = far && block.action.is_rapid();
        if !rotates || rollover_travel(&self.rules, &before, &block.values) <= unit_rad {
            return false;
        }
        if cutting.steps.as_ref().is_some_and(|steps| !is_on_line(&self.rules, steps, &block.values)) {
            return false;
        }
        let start = cutting.steps.as_ref().map_or(before, |steps| steps.start);
        cutting.steps = Some(Box::new(RapidSteps { start, last: block.values }));
        self.compare_state(current, required);
        true
    }

    /// The end of a rapid that may have been in steps.
    #[inline(never)]
    fn end_rapid_steps(&mut self, steps: &RapidSteps, current: &Current<'_>) {
        let end = &current.block.values;
        if !is_on_line(&self.rules, steps, end) {
            self.found(current, check::PATH, "the intermediate points of this rapid are not on its path");
        } else if rollover_travel(&self.rules, &steps.start, end) < PI - self.rules.rounding().unit_rad {
            self.found(
                current,
                check::PATH,
                "this rapid is split into steps, but no rotary axis moves by 180° or more",
            );
        }
    }

    /// A block that carries out nothing: reports it and looks among the motions ahead for the place at which the
    /// program continues. The items between are lost.
    fn resume(&mut self, cutting: &mut Cutting, current: &Current<'_>, end: &ToolPose) -> io::Result<()> {
        (cutting.back, cutting.steps, cutting.rapid_from) = (None, None, None);
        cutting.retract = RetractedLength::starting(*end, 0.0);
        let (tip, axis) = (self.rules.rounding().tip_mm, self.rules.rounding().axis_rad);
        let continues = self.progress.find(|item| {
            matches!(&item.action, ExpectedAction::Motion(motion) if (motion.to.tip - end.tip).norm() <= tip
                && angle_between(&motion.to.axis, &end.axis) <= axis)
        })?;
        if let Some(count @ 1..) = continues {
            self.skip(count, cutting.here.as_ref(), current);
            // Its start is not judged.
            self.progress.set_lost(true);
            if self.carry_out(cutting, current, end)? {
                return Ok(());
            }
        }
        let text = self.progress.mismatch(&self.rules, cutting.here.as_ref(), end);
        self.tally.found_lost(check::PATH, self.progress.location(), current.shown, &text);
        if continues.is_some() {
            self.progress.pass();
        }
        self.progress.set_lost(continues.is_none());
        Ok(())
    }

    /// Whether a rapid ends where a retract along the tool axis would.
    pub(super) fn may_lead_out(&self, cutting: &Cutting, block: &Block, end: &ToolPose) -> bool {
        let leads_out = |here: ToolPose| self.rest_of_retract(cutting, &here, end).is_some();
        block.action.is_rapid() && cutting.back.is_none() && cutting.here.is_some_and(leads_out)
    }

    /// Rest of the retract along the tool axis and the pose after it, if the block ends there.
    fn rest_of_retract(&self, cutting: &Cutting, here: &ToolPose, end: &ToolPose) -> Option<(f64, ToolPose)> {
        let from = self.progress.on_path(here);
        // Blocks that were taken for the rest of the motion before may have led on.
        let rested = cutting.has_rested();
        let from = if rested { ToolPose { tip: here.tip, ..from } } else { from };
        let between = rested || self.progress.along() > 0.0;
        let from = RetractStart { pose: &from, between };
        retract::rest(&self.rules, self.clearance(), from, here, end, cutting.retract.out_mm())
    }

    /// The retract along the tool axis before the machine retract; `None` if the block is something else.
    fn retract(&mut self, cutting: &mut Cutting, current: &Current<'_>, end: &ToolPose) -> io::Result<Option<Leaving>> {
        let Some(here) = cutting.here else { return Ok(None) };
        self.pass_needless_from(cutting.here.as_ref())?;
        let Some((rest, out)) = self.rest_of_retract(cutting, &here, end) else { return Ok(None) };
        self.missing_dwells(current, false);
        // A whole revolution leaves the tool axis the same at both ends, but not between.
        if self.rules.moved(&self.previous.words, self.previous.known, current.block) != 0 {
            self.found(current, check::SEQUENCE, "rotary axes rotate in this retract along the tool axis");
        }
        if self.stops_in_cut(current.block) {
            self.found(
                current,
                check::STATE,
                "the spindle is off before this retract along the tool axis, and was on in the cut",
            );
        }
        // The machine retract that follows each restart point has not come.
        let after_restart = self.duties.owes(Duty::Retract) && !self.duties.owes(Duty::RetractAfterShopLine);
        if after_restart && !self.duties.owes(Duty::CompleteState) {
            self.found(
                current,
                check::SEQUENCE,
                "the retract along the tool axis comes after the restart point of the next operation",
            );
        }
        let rewind = self.rewind_point(cutting, Some(out), current.block);
        let dry = rewind.is_none() || self.rules.policy().links.rewinds_dry;
        let context = ModalContext { dry, ..self.modal_context() };
        let fault = self.rules.fault_at_leave(current.block, self.progress.last(), context);
        self.found_state(current, fault);
        Ok(Some(Leaving { here: *end, retract: cutting.retract.longer(rest), rewind }))
    }

    /// Whether the spindle has been switched off since the last cut by something that the CL data has not.
    pub(super) fn stops_in_cut(&self, block: &Block) -> bool {
        let in_cut = self.progress.last().and_then(|required| self.rules.spindle_in_cut(required));
        let asked = matches!(self.progress.requested_spindle(), Some(None));
        let stopped = asked || self.duties.owes(Duty::SpindleAgain);
        in_cut.is_some() && block.state.spindle == Some(None) && !stopped
    }

    /// The point at which a retract interrupts the cut, if it does so. A cut that is done but for rounding may have to
    /// go on: the coolant shows it, where the cut has any.
    pub(super) fn rewind_point(&self, cutting: &Cutting, out: Option<ToolPose>, block: &Block) -> Option<RewindPoint> {
        let here = cutting.here?;
        let continues = self.progress.continues_cut();
        let on = block.state.coolant_is_on();
        // The way back may not have been gone since another retract.
        let wet = !continues && (on || cutting.back.is_some() && cutting.wet_retract);
        let dry = self.rules.policy().links.rewinds_dry;
        let may_go_on = |finished: &FinishedMotion| continues || wet || finished.required.coolant == 0 || dry;
        let finished = cutting.finished.as_ref().filter(|finished| finished.at_feed && may_go_on(finished)).cloned();
        (finished.is_some() || continues).then_some(RewindPoint { pose: here, out, finished, wet })
    }
}

/// What is known of the deviation of a block from its motion between its ends.
enum BetweenEnds {
    /// Both are straight.
    Straight,
    /// Bounds that decide all but F.
    Within(DeviationBound),
    Measured(Deviation),
}

/// A part of a motion that a block carries out, from where the last one has ended.
struct MotionPart {
    segment: Segment,
    rapid: bool,
    starts: bool,
    /// Feed of a block that is no rapid.
    feed: Option<Feed>,
    /// Share of the motion that is done after the block.
    share: f64,
    at: Location,
    required: Rc<Required>,
}
