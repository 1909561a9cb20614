//! Blocks of cycles: the lift over a hole, the cycle, and the motions of the CL data that it takes the place of.

use std::io;
use std::rc::Rc;

use super::super::expect::{ExpectedAction, ExpectedHole, ExpectedItem, Required, RequiredSmoothing};
use super::super::geometry::ToolPose;
use super::super::policy::RapidForm;
use super::super::read::{Action, Block, CycleMove};
use super::hole::{CycleComparison, is_over, pose_at, words_at};
use super::obligations::{DutyEvent, DutyPlace};
use super::phase::{Cutting, Phase, RetractedLength};
use super::{Comparison, Current, Findings};
use crate::diag::code::check;
use crate::program::Feed;

impl Comparison<'_> {
    /// A cycle returns to the level where it began: the tool first comes to that level over its hole, and down again to
    /// a thread by a motion; `false` if the block does something else.
    pub(super) fn lifts_for_cycle(&mut self, cutting: &Cutting, current: &Current<'_>, end: &ToolPose) -> bool {
        let Some(ExpectedItem { required, hole: Some(expected), action: ExpectedAction::Motion(next), .. }) =
            self.progress.next()
        else {
            return false;
        };
        let (required, hole, number, next) = (Rc::clone(required), expected.hole, expected.number, next.clone());
        let (top, axis) = (hole.top.tip.coords, hole.top.axis.into_inner());
        let tip_mm = self.rules.rounding().tip_mm;
        let at = |height: f64| self.rules.is_at(end, &ToolPose { tip: top + axis * height, axis });
        let over = cutting.here.is_some_and(|here| {
            let height = (here.tip - top).dot(&axis);
            height >= hole.clearance_mm - tip_mm && (here.tip - top - axis * height).norm() <= 2.0 * tip_mm
        });
        // A motion over the hole from where the tool is needs no block, and hides the one after it.
        let asked = (0..)
            .map_while(|index| match self.progress.get(index) {
                Some(ExpectedItem { hole: Some(of), action: ExpectedAction::Motion(motion), .. }) => {
                    (of.number == number).then_some((index, motion))
                }
                _ => None,
            })
            .find(|(index, motion)| {
                self.rules.is_at(end, &motion.to) || !self.is_needless(*index, cutting.here.as_ref())
            })
            .is_some_and(|(_, motion)| self.rules.is_at(end, &motion.to));
        let returns = at(hole.return_mm) && !asked;
        let lifts = over && (returns || !next.rapid && at(hole.clearance_mm));
        if lifts {
            // It may come down to a thread again.
            if returns && !at(hole.clearance_mm) {
                self.duties.happens(DutyEvent::LevelOfCycle);
            }
            self.pass_over_hole(cutting.here.as_ref(), number);
            self.progress.begin_at(*end);
            self.compare_state(current, &required);
            if current.block.action.is_rapid() {
                if self.rotates(current.block) {
                    self.rotates_at_part(current);
                }
                let at_feed = self.rules.policy().links.rapid == RapidForm::Feed;
                if at_feed && !self.is_in_thread() && !self.progress.is_approached() {
                    self.found(
                        current,
                        check::FEED,
                        "this motion to the next hole is programmed as a rapid, expected at feed",
                    );
                }
            } else if let Some(here) = cutting.here {
                let length = (end.tip - here.tip).norm();
                let feed = self.rules.policy().links.rapid_feed_mm_per_min.map(Feed::PerMinute);
                let feed = if next.rapid { feed } else { feed.or(next.feed) };
                let before = &self.previous.words;
                let stroke = self.rules.stroke(before, current.block, (length, f64::INFINITY), feed, &required);
                let fault = self.rules.law().wrong(&stroke, &current.block.state);
                self.found_any(current, check::HOLE, fault);
                let fault = self.functions.smoothing(&current.block.state, &self.rules, required.smoothing);
                self.found_any(current, check::STATE, fault);
            }
        }
        lifts
    }

    /// Passes motions to a place over a hole that need no block from where the tool was; the last rapid leads down to
    /// it.
    fn pass_over_hole(&mut self, here: Option<&ToolPose>, number: u64) {
        let leads_on = |item: &ExpectedItem| {
            item.hole.as_ref().is_some_and(|of| of.number == number) && item.motion().is_some_and(|motion| motion.rapid)
        };
        while self.is_needless(0, here) && self.progress.get(1).is_some_and(leads_on) {
            self.progress.pass();
        }
    }

    /// A hole by a cycle of the control.
    pub(super) fn cycle(&mut self, phase: &mut Phase, current: &Current<'_>) -> io::Result<Option<Phase>> {
        let (block, Action::Cycle(cycle)) = (current.block, &current.block.action) else { return Ok(None) };
        self.progress.fill(2)?;
        while self.is_needless(0, phase.here()) && self.is_last_of_hole() {
            self.progress.pass();
            self.progress.fill(2)?;
        }
        if let Some(count) = self.items_before_hole(block, cycle)? {
            self.skip(count, phase.here(), current);
        }
        let item = self.progress.next().and_then(|item| Some((item.hole.clone()?, Rc::clone(&item.required))));
        let end = pose_at(&self.rules, block, cycle.back_to);
        let Some((expected, required)) = item else {
            self.found(current, check::ORDER, "cycle, but the CL data has no hole here");
            if let Phase::Cutting(cutting) = phase {
                cutting.here = end;
            }
            return Ok(None);
        };
        if self.progress.is_made(expected.number) {
            self.found(current, check::HOLE, "this hole has been made already: the cycle runs twice");
        }
        self.duties.happens(DutyEvent::Cycle);
        let starts = self.progress.motion().is_some_and(|motion| motion.starts);
        if !matches!(phase, Phase::Cutting(_)) || (starts && !self.progress.is_approached()) {
            self.found(current, check::ORDER, "cycle without an approach before it");
        }
        self.compare_state_of_cycle(current, &required);
        let (stays, back, way_out_mm) = self.compare_hole(current, cycle, &expected, &required);
        self.progress.make(expected.number);
        self.finish_hole(expected.number, stays)?;
        self.progress.begin_at(back);
        self.progress.set_lost(false);
        let mut cutting = match phase {
            Phase::Cutting(cutting) => std::mem::take(cutting),
            _ => Box::default(),
        };
        cutting.retract = RetractedLength::starting(back, way_out_mm);
        cutting.here = end.or(Some(back));
        Ok(Some(Phase::Cutting(cutting)))
    }

    /// The modal state of a cycle.
    fn compare_state_of_cycle(&mut self, current: &Current<'_>, required: &Required) {
        let block = current.block;
        self.compare_state(current, required);
        if !block.action.is_rigid_thread() && !self.rules.facts().stops_spindle(&block.action) {
            self.come_to_cut(DutyPlace::Cycle, current);
        }
        // Smoothing is off in a cycle.
        let off = RequiredSmoothing { level: None, ..required.smoothing };
        let fault = self.functions.smoothing(&block.state, &self.rules, off);
        self.found_any(current, check::HOLE, fault);
    }

    /// The levels and the kind of a cycle. Returns whether the way up to the return level is left to a motion, where
    /// the tool is after it, and the length of its way out.
    fn compare_hole(
        &mut self,
        current: &Current<'_>,
        cycle: &CycleMove,
        expected: &ExpectedHole,
        required: &Required,
    ) -> (bool, ToolPose, f64) {
        let block = current.block;
        let (hole, spindle) = (expected.hole, required.spindle);
        // Words show no less than half a unit.
        let tolerance_mm = required.tolerance_mm.max(0.5 * self.rules.rounding().unit_mm);
        let comparison = CycleComparison { rules: &self.rules, block, cycle, hole: &hole, spindle, tolerance_mm };
        let (stays, highest) = (comparison.stays_at_clearance(), comparison.highest());
        let (levels, back) = comparison.levels(stays);
        let way_out_mm = comparison.way_out_mm(&back);
        let levels = levels.map(|level| {
            let found = comparison.compare(&level);
            (level.level_mm, found)
        });
        let over = comparison.over_fault(&self.previous.words, self.previous.known);
        let faults: Vec<String> = over.into_iter().chain(comparison.faults()).collect();
        for (level_mm, found) in levels {
            self.level_found(current, level_mm, found);
        }
        for level_mm in [cycle.over, highest].into_iter().flatten() {
            if let Some(values) = words_at(&self.rules, block, level_mm) {
                let mut findings = Findings { tally: &mut self.tally, at: current.at, shown: current.shown };
                self.travel.at_end(&self.rules, block, &values, &mut findings);
            }
        }
        if self.rotates(block) {
            self.rotates_at_part(current);
        }
        faults.iter().for_each(|text| self.found(current, check::HOLE, text));
        (stays, back, way_out_mm)
    }

    /// Reports a wrong level of a cycle, and its travel limits.
    fn level_found(&mut self, current: &Current<'_>, level_mm: f64, found: Option<(f64, Option<String>)>) {
        let Some((off, text)) = found else {
            return self.found(current, check::HOLE, "cycle without a known working plane");
        };
        if let Some(text) = text {
            self.found(current, check::HOLE, &text);
        }
        self.tally.deviation(off, 0.0);
        if let Some(values) = words_at(&self.rules, current.block, level_mm) {
            let mut findings = Findings { tally: &mut self.tally, at: current.at, shown: current.shown };
            self.travel.at_end(&self.rules, current.block, &values, &mut findings);
        }
    }

    /// Number of items before the hole that a cycle makes, if that is not the next one.
    fn items_before_hole(&mut self, block: &Block, cycle: &CycleMove) -> io::Result<Option<usize>> {
        let Some(at) = pose_at(&self.rules, block, cycle.reference) else { return Ok(None) };
        let rules = &self.rules;
        let makes = |item: &ExpectedItem| item.hole.as_ref().is_some_and(|expected| is_over(rules, &at, expected));
        if self.progress.next().is_some_and(makes) {
            return Ok(None);
        }
        self.progress.find(makes)
    }

    /// Whether the next item is not of a hole, or the last of its hole.
    fn is_last_of_hole(&self) -> bool {
        let number =
            |index: usize| self.progress.get(index).and_then(|item| item.hole.as_ref()).map(|hole| hole.number);
        number(0).is_none() || number(0) != number(1)
    }

    /// Passes the items of a hole, but for the way up where that is left to a motion.
    fn finish_hole(&mut self, number: u64, stays: bool) -> io::Result<()> {
        loop {
            self.progress.fill(2)?;
            let belongs = |index: usize| {
                self.progress.get(index).and_then(|item| item.hole.as_ref()).is_some_and(|hole| hole.number == number)
            };
            if !belongs(0) || (stays && !belongs(1)) {
                return Ok(());
            }
            self.progress.pass();
        }
    }
}
