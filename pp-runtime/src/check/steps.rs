//! Motions in more blocks than one: rapids in steps, and the rest of what is done but for rounding.

use std::io::Read;

use super::chain::Placed;
use super::compare::Checker;
use super::expect::{Motion, Wanted};
use super::follow::{between, places, sweep};
use super::path::{Segment, angle_between};
use super::read::{Action, Block, MAX_AXES};
use crate::config::{Rapid, Transition};
use crate::kinematics::{Axis, Machine};
use crate::program::Feed;

/// A rapid that is run in steps: words where it began, and behind the first of them.
#[derive(Debug, Clone, Copy)]
pub(super) struct Steps {
    start: [f64; MAX_AXES],
    first: [f64; MAX_AXES],
}

/// A motion that has been done.
#[derive(Debug, Clone, Copy)]
pub(super) struct Done {
    pub(super) motion: Motion,
    pub(super) wanted: Wanted,
    /// At feed.
    pub(super) feeds: bool,
}

impl<M: Machine, R: Read> Checker<'_, M, R> {
    /// The rest of a motion that is done but for rounding, run as it should be: a step of a unit, or near the pole a turn of
    /// the rotary axes that have far to go where the tool axis is at its end already.
    pub(super) fn is_rest(&self, block: &Block, end: &Placed) -> bool {
        let (before, known) = self.before;
        let solved = self.solved(block);
        let Some(Done { motion, wanted, feeds }) = self.done.filter(|_| known & solved == solved) else { return false };
        let as_before = match block.action {
            Action::Feed | Action::Arc(_) => feeds,
            Action::Rapid => !feeds,
            _ => false,
        };
        let turned = self.words.rotary_way(&before, &block.values);
        let stays = |share: f64| {
            let words = between(&before, block, share, self.words.linear_places());
            let on = self.words.place(&words, &block.state);
            (on.tip - motion.to.tip).norm() <= wanted.tolerance
                && angle_between(&on.axis, &motion.to.axis) <= self.axis_slack(&motion.to.axis)
        };
        let count = places(turned + sweep(block));
        let feed = if motion.rapid { self.config.rapid_feed.map(Feed::PerMinute) } else { motion.feed };
        as_before
            && self.is_at(end, &motion.to)
            && (1..).map(f64::from).take_while(|place| *place <= count).all(|place| stays(place / (count + 1.0)))
            && self.fault_at_path(block, &wanted).is_none()
            && (!feeds || self.law.wrong(&self.stroke(block, 0.0, feed, &wanted), &block.state).is_none())
    }

    /// A rapid is cut where an axis takes the short way and has half a turn to go or more: all axes go their share together.
    /// Whether they did is seen where it ends.
    pub(super) fn goes_in_steps(&mut self, block: &Block) -> bool {
        let before = self.before.0;
        let turns = |(index, axis): (usize, &Axis)| {
            self.config.wrap.contains_key(&axis.letter)
                && (block.values[index] - before[index]).abs() > self.slack.angle
        };
        let direct = block.action == Action::Rapid && self.config.transition == Transition::Direct;
        if !direct || !M::AXES.iter().enumerate().any(turns) {
            return false;
        }
        let on = self.steps.is_none_or(|steps| self.lies_on_way(&steps, &block.values));
        self.steps = self.steps.or(Some(Steps { start: before, first: block.values }));
        on
    }

    /// Whether the first step lies on the way from where it began to some words, each but for a unit.
    pub(super) fn lies_on_way(&self, steps: &Steps, to: &[f64; MAX_AXES]) -> bool {
        let Steps { start, first } = steps;
        let way = |index: usize| to[index] - start[index];
        let rotary = (0..MAX_AXES).filter(|index| self.words.rotary_mask & (1 << index) != 0);
        let most = rotary.max_by(|a, b| way(*a).abs().total_cmp(&way(*b).abs()));
        let Some(most) = most.filter(|most| way(*most).abs() > 0.0) else { return false };
        let share = (first[most] - start[most]) / way(most);
        (0..MAX_AXES).all(|index| {
            let unit = if self.words.rotary_mask & (1 << index) != 0 { self.slack.angle } else { self.slack.unit };
            (start[index] + share * way(index) - first[index]).abs() <= 1.01 * unit
        })
    }

    /// A rapid in two blocks, along the tool axis and across it.
    pub(super) fn corner(&self, segment: &Segment, end: &Placed) -> Option<f64> {
        let here = self.here.filter(|_| self.config.rapid == Rapid::Split)?;
        let step = segment.to.tip - here.tip;
        let along = segment.to.axis * step.dot(&segment.to.axis);
        let corner = if step.dot(&segment.to.axis) > 0.0 { here.tip + along } else { segment.to.tip - along };
        ((end.tip - corner).norm() <= 2.0 * self.slack.tip).then_some(0.0)
    }
}
