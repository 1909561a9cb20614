//! Travel and time of the rotary axes between two positions, and their cost.

use crate::kinematics::math::rounded;
use crate::kinematics::{AngleScale, Rotary};

/// Words of the solved rotary axes in the order of the chain; 0 for an axis that the machine does not have.
pub(crate) type RotaryWords = [i64; 2];

/// Programmed sense of rotation of an axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct RotationSense {
    /// Index among the solved rotary axes.
    pub(crate) axis: usize,
    /// Its word increases.
    pub(crate) positive: bool,
}

/// Rotary words at the end of a motion, as planned.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct RotaryTarget {
    pub(crate) words: RotaryWords,
    /// Sense in which an endless axis rotates; without it by the shorter path.
    pub(crate) sense: Option<RotationSense>,
}

/// Cost of a course. Compared in this order: rewinds, starts against the preference of the user, time, travel.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Default)]
pub struct Cost {
    /// Number of rewinds: the tool leaves the part while a rotary axis unwinds.
    pub rewinds: u32,
    /// Number of starts that are not as the user prefers.
    pub against_preference: u32,
    /// Time of the rotary axes at their largest speeds; 0 where these are unknown.
    pub time_ns: u64,
    /// Total travel of all rotary axes, in whole units of their words.
    pub travel_units: u64,
}

impl Cost {
    /// The sum. Times at absurd speeds (a nanodegree per minute) are bounded, not wrapped.
    #[inline]
    pub(crate) fn plus(self, other: Self) -> Self {
        Self {
            rewinds: self.rewinds + other.rewinds,
            against_preference: self.against_preference + other.against_preference,
            time_ns: self.time_ns.saturating_add(other.time_ns),
            travel_units: self.travel_units.saturating_add(other.travel_units),
        }
    }

    /// The part of a sum that came after an earlier one. That of a bounded time is bounded, too.
    #[inline]
    pub(crate) fn since(self, earlier: Self) -> Self {
        Self {
            rewinds: self.rewinds - earlier.rewinds,
            against_preference: self.against_preference - earlier.against_preference,
            time_ns: if self.time_ns < u64::MAX { self.time_ns - earlier.time_ns } else { u64::MAX },
            travel_units: self.travel_units - earlier.travel_units,
        }
    }

    pub(crate) const REWIND: Self = Self { rewinds: 1, against_preference: 0, time_ns: 0, travel_units: 0 };
    pub(crate) const AGAINST_PREFERENCE: Self = Self { rewinds: 0, against_preference: 1, time_ns: 0, travel_units: 0 };
}

/// Travel and cost of rotations.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct RotaryMetric {
    /// Time for one unit of a word; 0 for an axis of unknown speed.
    ns_per_unit: [f64; 2],
    /// No axis has a known speed.
    is_untimed: bool,
    endless: [bool; 2],
    units_per_turn: i64,
}

impl RotaryMetric {
    /// Creates the metric of these axes; speeds in rad/min.
    pub(crate) fn new(rotaries: &[Rotary], speeds: [Option<f64>; 2], scale: AngleScale) -> Self {
        const NS_PER_MIN: f64 = 60e9;
        Self {
            is_untimed: speeds.iter().all(Option::is_none),
            ns_per_unit: speeds.map(|speed| speed.map_or(0.0, |speed| NS_PER_MIN * scale.angle(1) / speed)),
            endless: [0, 1].map(|axis| rotaries.get(axis).is_some_and(|rotary| rotary.endless())),
            units_per_turn: scale.units_per_turn,
        }
    }

    /// The word inside the limits that is zero or whole turns from it, nearest to `word`; `None` if none is.
    pub(crate) fn nearest_zero(&self, rotary: &Rotary, word: i64) -> Option<i64> {
        rotary.nearest(0, word, self.units_per_turn).ok()
    }

    /// Signed travel of one axis; an endless axis takes the shorter path.
    #[inline]
    pub(crate) fn change(&self, axis: usize, from: i64, to: i64) -> i64 {
        let change = to - from;
        if !self.endless[axis] {
            return change;
        }
        let short = change.rem_euclid(self.units_per_turn);
        if 2 * short > self.units_per_turn { short - self.units_per_turn } else { short }
    }

    /// Signed travel of one axis in a programmed sense; `None` if a limited axis cannot rotate in that sense to the
    /// target.
    pub(crate) fn change_in_sense(&self, axis: usize, from: i64, to: i64, sense: Option<RotationSense>) -> Option<i64> {
        let change = self.change(axis, from, to);
        match sense.filter(|sense| sense.axis == axis) {
            None => Some(change),
            Some(RotationSense { positive, .. }) if (change >= 0) == positive || change == 0 => Some(change),
            Some(RotationSense { positive, .. }) if self.endless[axis] => {
                Some(if positive { change + self.units_per_turn } else { change - self.units_per_turn })
            }
            Some(_) => None,
        }
    }

    /// Whether the cost of a rotation of the first axis is the sum of the costs of its parts, whatever the other axis
    /// does: it has limits, and no axis has a known speed. Times are rounded.
    pub(crate) fn adds_up_along_first_axis(&self) -> bool {
        self.is_untimed && !self.endless[0]
    }

    /// Travel by which a course is longer than a cheaper one, or an equal one; infinite if more than travel tells them
    /// apart. Negative infinity where an axis has a known speed: there times tell them apart, and these are rounded.
    pub(crate) fn longer_by(&self, cheaper: Cost, other: Cost) -> f64 {
        if !self.is_untimed {
            return f64::NEG_INFINITY;
        }
        let alike = Cost { travel_units: other.travel_units, ..cheaper } == other;
        if alike { (other.travel_units - cheaper.travel_units) as f64 } else { f64::INFINITY }
    }

    /// Cost of rotating all axes together.
    #[inline]
    pub(crate) fn cost(&self, from: &RotaryWords, to: &RotaryWords) -> Cost {
        self.cost_of([0, 1].map(|axis| self.change(axis, from[axis], to[axis])))
    }

    /// Cost of these signed travels.
    #[inline]
    pub(crate) fn cost_of(&self, changes: [i64; 2]) -> Cost {
        let travel = changes.map(i64::unsigned_abs);
        let time_ns = self.time_ns(travel.map(|travel| travel as f64));
        Cost { time_ns, travel_units: travel[0] + travel[1], ..Cost::default() }
    }

    /// Whether an axis has a known speed.
    #[inline(always)]
    pub(crate) fn has_speeds(&self) -> bool {
        !self.is_untimed
    }

    /// Time of these travels, in units of the words, ns; 0 where no speed is known.
    #[inline]
    pub(crate) fn time_ns(&self, travel: [f64; 2]) -> u64 {
        if self.is_untimed {
            return 0;
        }
        let times = [0, 1].map(|axis| rounded(travel[axis] * self.ns_per_unit[axis]).unsigned_abs());
        times[0].max(times[1])
    }

    /// Travel of the axis that rotates most.
    #[inline(always)]
    fn farthest(&self, from: &RotaryWords, to: &RotaryWords) -> i64 {
        self.change(0, from[0], to[0]).abs().max(self.change(1, from[1], to[1]).abs())
    }

    /// Whether no axis rotates by more than 180°: the limit of a cut without a rewind.
    pub(crate) fn short(&self, from: &RotaryWords, to: &RotaryWords) -> bool {
        2 * self.farthest(from, to) <= self.units_per_turn
    }

    /// Whether every axis rotates by less than 180°.
    pub(crate) fn shorter_than_half_turns(&self, from: &RotaryWords, to: &RotaryWords) -> bool {
        2 * self.farthest(from, to) < self.units_per_turn
    }

    /// Whether every axis rotates by less than 90°.
    pub(crate) fn plain(&self, from: &RotaryWords, to: &RotaryWords) -> bool {
        4 * self.farthest(from, to) < self.units_per_turn
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn absurd_speeds_and_travels_add_up_to_the_largest_cost() {
        let scale = AngleScale { units_per_degree: 1e3, units_per_turn: 360_000 };
        let metric = RotaryMetric::new(&[], [Some(1e-300); 2], scale);
        let cost = metric.cost(&[0, 0], &[360_000, 1]);
        let most = (0..4).fold(cost, |sum, _| sum.plus(cost));
        assert_eq!(most.time_ns, u64::MAX);
        assert_eq!(most.travel_units, 5 * 360_001);
        assert!(cost < most && cost.plus(Cost::REWIND) > most);
    }
}
