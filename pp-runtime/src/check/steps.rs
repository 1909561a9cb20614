//! Motions in more blocks than one: rapids in steps, and the rest of what is done but for rounding.

use std::f64::consts::PI;
use std::io::Read;

use super::chain::Placed;
use super::compare::Checker;
use super::expect::{Motion, Wanted};
use super::follow::{between, drift, places, sweep};
use super::path::{Segment, angle_between};
use super::read::{Action, Block, MAX_AXES};
use super::report::Shown;
use crate::kinematics::Axis;
use crate::motion::{Rapid, Transition};
use crate::program::Feed;

/// A rapid that is run in steps: words where it began, and behind the last of them.
#[derive(Debug, Clone, Copy)]
pub(super) struct Steps {
    start: [f64; MAX_AXES],
    last: [f64; MAX_AXES],
}

/// A motion that has been done.
#[derive(Debug, Clone, Copy)]
pub(super) struct Done {
    pub(super) motion: Motion,
    pub(super) wanted: Wanted,
    /// At feed.
    pub(super) feeds: bool,
    /// How far rotary axes have turned since, where the tool axis was at its end already, rad.
    pub(super) turned: f64,
}

impl<R: Read> Checker<'_, R> {
    /// Takes the rest of a motion that is done but for rounding, run as it should be: a step of a unit, or near the pole a turn
    /// of the rotary axes, by half a turn at most, that have far to go where the tool axis is at its end already.
    pub(super) fn takes_rest(&mut self, block: &Block, end: &Placed) -> bool {
        let (before, known) = self.before;
        let solved = self.solved(block);
        let Some(done) = self.done.filter(|_| known & solved == solved) else { return false };
        let Done { motion, wanted, feeds, .. } = done;
        let as_before = match block.action {
            Action::Feed | Action::Arc(_) => feeds,
            Action::Rapid => !feeds && !self.turns_at_part(block),
            _ => false,
        };
        let way = self.words.rotary_way(&before, &block.values);
        let turned = done.turned + way;
        let stays = |share: f64| {
            let words = between(&before, block, share, self.words.linear_places());
            let on = self.words.place(&words, &block.state);
            (on.tip - motion.to.tip).norm() <= wanted.tolerance
                && angle_between(&on.axis, &motion.to.axis) <= self.axis_slack(&motion.to.axis)
        };
        let count = places(way + sweep(block));
        let feed = if motion.rapid {
            self.config.motion.rapids.rapid_feed_mm_per_min.map(Feed::PerMinute)
        } else {
            motion.feed
        };
        let is_rest = as_before
            && turned <= PI + self.slack.angle
            && self.is_at(end, &motion.to)
            && (1..).map(f64::from).take_while(|place| *place <= count).all(|place| stays(place / (count + 1.0)))
            && self.fault_at_path(block, &wanted).is_none()
            && (!feeds || self.law.wrong(&self.stroke(block, 0.0, feed, &wanted), &block.state).is_none());
        if is_rest {
            self.done = Some(Done { turned, ..done });
        }
        is_rest
    }

    /// Takes a step of a rapid: it is cut where an axis takes the short way and has half a turn to go or more, and all axes
    /// go their share together. Each step goes on along the line of those before it; whether that was the line of the rapid
    /// is seen where it ends.
    pub(super) fn takes_step(&mut self, block: &Block, wanted: &Wanted, shown: Shown<'_>) -> bool {
        let before = self.before.0;
        let direct = block.action == Action::Rapid && self.config.motion.rapids.transition == Transition::Direct;
        if !direct || self.short_way(&before, &block.values) <= self.slack.angle {
            return false;
        }
        if self.steps.is_some_and(|steps| !self.lies_on_way(&steps, &block.values)) {
            return false;
        }
        let start = self.steps.map_or(before, |steps| steps.start);
        self.steps = Some(Steps { start, last: block.values });
        self.state_at_path(block, wanted, shown);
        true
    }

    /// The end of a rapid, of which there may have been steps.
    pub(super) fn ends_steps(&mut self, block: &Block, shown: Shown<'_>) {
        let Some(steps) = self.steps.take() else { return };
        if !self.lies_on_way(&steps, &block.values) {
            self.found(shown, "the intermediate points of this rapid are not on its path");
        } else if self.short_way(&steps.start, &block.values) < PI - self.slack.angle {
            self.found(shown, "this rapid is split into steps, but no rotary axis moves by 180° or more");
        }
    }

    /// How far an axis turns that takes the short way, rad.
    fn short_way(&self, from: &[f64; MAX_AXES], to: &[f64; MAX_AXES]) -> f64 {
        let wraps = |(_, axis): &(usize, &Axis)| self.config.motion.rotaries.wrap.contains_key(&axis.letter);
        let way = |(index, _): (usize, &Axis)| (to[index] - from[index]).abs();
        self.machine.axes().iter().enumerate().filter(wraps).map(way).fold(0.0, f64::max)
    }

    /// Whether the last step lies between where the rapid began and some words, on the line of both, but for a unit.
    fn lies_on_way(&self, steps: &Steps, to: &[f64; MAX_AXES]) -> bool {
        let Steps { start, last } = steps;
        let way = |index: usize| to[index] - start[index];
        let rotary = (0..MAX_AXES).filter(|index| self.words.rotary_mask & (1 << index) != 0);
        let most = rotary.max_by(|a, b| way(*a).abs().total_cmp(&way(*b).abs()));
        let Some(most) = most.filter(|most| way(*most).abs() > 0.0) else { return false };
        let share = (last[most] - start[most]) / way(most);
        let between = (0.0..=1.0).contains(&share);
        between
            && (0..MAX_AXES).all(|index| {
                let unit = if self.words.rotary_mask & (1 << index) != 0 { self.slack.angle } else { self.slack.unit };
                (start[index] + share * way(index) - last[index]).abs() <= 1.01 * unit
            })
    }

    /// A rapid in two blocks, along the tool axis and across it.
    pub(super) fn corner(&self, segment: &Segment, end: &Placed) -> Option<f64> {
        let here = self.here.filter(|_| self.config.motion.rapids.rapid == Rapid::Split)?;
        let step = segment.to.tip - here.tip;
        let along = segment.to.axis * step.dot(&segment.to.axis);
        let corner = if step.dot(&segment.to.axis) > 0.0 { here.tip + along } else { segment.to.tip - along };
        let slack = (1.0 + drift(self.by_angle)) * self.slack.tip;
        ((end.tip - corner).norm() <= slack).then_some(0.0)
    }
}
