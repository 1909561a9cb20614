//! How far smooth functions of a share reach: samples, and between them golden sections.
//!
//! Between samples as close as these a function is a parabola to a few percent: it rises above the highest of three by
//! an eighth of their second difference. Where the whole of that difference would matter, the peak is sought, to the
//! noise of the function. What stays inside costs nothing but its samples.

use super::super::read::{MAX_AXES, set_bits};

/// Sections of a search: the last is 1e-6 of the first, and what that leaves of a parabola is 1e-12 of its rise.
const SECTIONS: u32 = 29;

/// Part of an interval that a section keeps.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// A way that cannot be followed in steps of this share is left there.
const SMALLEST: f64 = 1e-5;

/// One place of a way.
#[derive(Debug, Clone, Copy)]
pub(crate) struct PathPoint {
    pub(crate) share: f64,
    pub(crate) words: [f64; MAX_AXES],
    /// Axis values, mm and rad.
    pub(crate) values: [f64; MAX_AXES],
}

/// Smallest and largest value of each axis.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Extent {
    pub(crate) low: [f64; MAX_AXES],
    pub(crate) high: [f64; MAX_AXES],
}

impl Extent {
    pub(crate) fn of(values: &[f64; MAX_AXES]) -> Self {
        Self { low: *values, high: *values }
    }

    pub(crate) fn take(&mut self, values: &[f64; MAX_AXES]) {
        for (index, value) in values.iter().enumerate() {
            self.low[index] = self.low[index].min(*value);
            self.high[index] = self.high[index].max(*value);
        }
    }

    /// Whether all values of some axes are within it: bits.
    pub(crate) fn holds(&self, other: &Self, axes: u16) -> bool {
        set_bits(axes).all(|axis| self.low[axis] <= other.low[axis] && other.high[axis] <= self.high[axis])
    }

    /// The bound on one side, + up; values there count with their side, so that more is always farther.
    pub(crate) fn bound(&self, index: usize, side: f64) -> f64 {
        side * if side > 0.0 { self.high[index] } else { self.low[index] }
    }
}

/// Functions of a share and how far they reach.
pub(crate) struct Search<'s, F> {
    /// The place at a share, near to another; `None` if that is too far away to follow.
    pub(crate) at: F,
    /// Values between these are of no interest.
    pub(crate) quiet: &'s Extent,
    /// The axes that are: bits.
    pub(crate) axes: u16,
    pub(crate) extent: Extent,
}

impl<F: Fn(f64, &PathPoint) -> Option<PathPoint>> Search<'_, F> {
    /// Goes in steps from a place to a share; where it ended.
    pub(crate) fn go(&mut self, from: PathPoint, to: f64, step: f64) -> PathPoint {
        let (mut seen, mut count, mut stride) = ([from; 3], 1, step);
        self.extent.take(&from.values);
        while seen[2].share < to && stride > SMALLEST * step.min(1.0) {
            let share = seen[2].share + stride;
            // The last step may be a little longer, so that none is a sliver.
            let share = if share + 1e-3 * stride > to { to } else { share };
            let Some(next) = (self.at)(share, &seen[2]) else {
                stride *= 0.5;
                continue;
            };
            stride = (2.0 * stride).min(step);
            seen = [seen[1], seen[2], next];
            self.extent.take(&next.values);
            count += 1;
            if count >= 3 {
                self.peaks(&seen, count == 3, share >= to);
            }
        }
        seen[2]
    }

    /// Peaks about the middle of three places, and between it and an end of the way.
    fn peaks(&mut self, seen: &[PathPoint; 3], first: bool, last: bool) {
        let [a, b, c] = seen.map(|place| place.share);
        let (before, behind) = (b - a, c - b);
        let axes = self.axes;
        for index in (0..MAX_AXES).filter(|index| axes & (1 << index) != 0) {
            for side in [1.0, -1.0] {
                let [fa, fb, fc] = seen.map(|place| side * place.values[index]);
                let bend = 2.0 * ((fc - fb) / behind - (fb - fa) / before).abs() / (before + behind);
                let room = bend * before.max(behind).powi(2);
                let (low, high, top) = if fb >= fa && fb >= fc {
                    (a, c, fb)
                } else if first && fa > fb && fa - fb < room {
                    (a, b, fa)
                } else if last && fc > fb && fc - fb < room {
                    (b, c, fc)
                } else {
                    continue;
                };
                if top + room > self.quiet.bound(index, side).max(self.extent.bound(index, side)) {
                    self.seek(index, side, [low, high], &seen[1]);
                }
            }
        }
    }

    fn seek(&mut self, index: usize, side: f64, [low, high]: [f64; 2], near: &PathPoint) {
        let value = |share: f64| (self.at)(share, near).map_or(f64::NEG_INFINITY, |place| side * place.values[index]);
        let share = highest(low, high, value);
        if let Some(place) = (self.at)(share, near) {
            self.extent.take(&place.values);
        }
    }
}

/// Where a function with one peak is highest, by golden sections.
fn highest(low: f64, high: f64, value: impl Fn(f64) -> f64) -> f64 {
    let (mut low, mut high) = (low, high);
    let (mut left, mut right) = (high - GOLDEN * (high - low), low + GOLDEN * (high - low));
    let (mut at_left, mut at_right) = (value(left), value(right));
    for _ in 0..SECTIONS {
        if at_left < at_right {
            (low, left, at_left) = (left, right, at_right);
            right = low + GOLDEN * (high - low);
            at_right = value(right);
        } else {
            (high, right, at_right) = (right, left, at_left);
            left = high - GOLDEN * (high - low);
            at_left = value(left);
        }
    }
    f64::midpoint(low, high)
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use super::*;

    /// A wave about a slope, in steps; low, high, and the places that were looked at.
    fn wave(phase: f64, angle: f64, slope: f64, quiet: f64) -> (f64, f64, u32) {
        let count = std::cell::Cell::new(0);
        let at = |share: f64, _: &PathPoint| {
            count.set(count.get() + 1);
            let mut values = [0.0; MAX_AXES];
            values[2] = 100.0 * (phase + angle * share).sin() + slope * share;
            Some(PathPoint { share, words: values, values })
        };
        let quiet = Extent { low: [-quiet; MAX_AXES], high: [quiet; MAX_AXES] };
        let from =
            at(0.0, &PathPoint { share: 0.0, words: [0.0; MAX_AXES], values: [0.0; MAX_AXES] }).expect("a place");
        let mut search = Search { at, quiet: &quiet, axes: 4, extent: Extent::of(&from.values) };
        search.go(from, 1.0, (0.2 / angle).min(0.5));
        (search.extent.low[2], search.extent.high[2], count.get())
    }

    #[test]
    fn the_furthest_value_is_found_wherever_it_lies_between_samples() {
        for turn in 0..400 {
            let (phase, angle) = (0.017 * f64::from(turn), 0.03 + 0.02 * f64::from(turn));
            let slope = f64::from(turn % 7) - 3.0;
            let (low, high, _) = wave(phase, angle, slope, 0.0);
            let all = (0..=100_000).map(|step| {
                let share = f64::from(step) / 1e5;
                100.0 * (phase + angle * share).sin() + slope * share
            });
            let (least, most) = all.fold((f64::MAX, f64::MIN), |(a, b), value| (a.min(value), b.max(value)));
            assert!((low - least).abs() < 1e-6 && (high - most).abs() < 1e-6, "{turn}: {low} {least} {high} {most}");
        }
    }

    #[test]
    fn nothing_is_sought_where_all_is_quiet() {
        let (_, _, samples) = wave(0.0, TAU, 0.0, 110.0);
        assert!(samples <= 34, "{samples}");
        let (_, high, _) = wave(0.1, TAU, 0.0, 99.9999);
        assert!((high - 100.0).abs() < 1e-9, "{high}");
    }

    #[test]
    fn a_way_that_breaks_off_is_followed_as_far_as_it_goes() {
        let quiet = Extent::of(&[0.0; MAX_AXES]);
        let at = |share: f64, _: &PathPoint| {
            (share < 0.3).then_some(PathPoint { share, words: [share; MAX_AXES], values: [share; MAX_AXES] })
        };
        let from =
            at(0.0, &PathPoint { share: 0.0, words: [0.0; MAX_AXES], values: [0.0; MAX_AXES] }).expect("a place");
        let mut search = Search { at, quiet: &quiet, axes: 1, extent: Extent::of(&from.values) };
        let end = search.go(from, 1.0, 0.25);
        assert!(end.share < 0.3 && end.share > 0.299, "{}", end.share);
    }
}
