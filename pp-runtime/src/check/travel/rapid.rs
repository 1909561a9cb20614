//! A rapid under tip control in which every axis moves on its own.
//!
//! Every pair of rotary values may occur with every point of the box of the linear words. For a pair of rotary values
//! linear axes are affine in the words, so that the corners of the box suffice.

use super::super::geometry::highest;
use super::{Block, Extent, Findings, MAX_AXES, Rules, Travel};

/// Largest distance between rotary values that are paired, rad, unless there were more than this.
const PAIR_STEP: f64 = 0.05;
const MOST_PAIRED: f64 = 60.0;

impl Travel {
    pub(super) fn uncoordinated(
        &mut self,
        rules: &Rules<'_>,
        before: &[f64; MAX_AXES],
        block: &Block,
        findings: &mut Findings<'_>,
    ) {
        let words = rules.words();
        let counts: [u32; MAX_AXES] = std::array::from_fn(|index| {
            let angle = (block.values[index] - before[index]).abs();
            let rotary = words.rotary_bits() & (1 << index) != 0;
            if rotary { (angle / PAIR_STEP).ceil().min(MOST_PAIRED) as u32 + 1 } else { 1 }
        });
        let at = |point: &[f64; MAX_AXES]| words.axes(point, &block.state);
        let (Some(first), Some(last)) = (at(before), at(&block.values)) else { return };
        let mut extent = Extent::of(&first);
        let mut farthest = [[*before; 2]; MAX_AXES];
        for point in pairs(before, &block.values, counts, words.linear_bits()) {
            let Some(values) = at(&point) else { continue };
            for (index, value) in values.into_iter().enumerate() {
                if value < extent.low[index] {
                    farthest[index][0] = point;
                }
                if value > extent.high[index] {
                    farthest[index][1] = point;
                }
            }
            extent.take(&values);
        }
        let quiet = self.quiet(words);
        for axis in &self.axes {
            // Between two pairs a value rises by less than over all of them.
            let room = extent.high[axis.index] - extent.low[axis.index];
            for (side, point) in [-1.0, 1.0].into_iter().zip(farthest[axis.index]) {
                if extent.bound(axis.index, side) + room > quiet.bound(axis.index, side) {
                    let value =
                        |point: &[f64; MAX_AXES]| at(point).map_or(f64::NEG_INFINITY, |at| side * at[axis.index]);
                    let point = farther(before, &block.values, counts, point, value);
                    extent.take(&at(&point).unwrap_or(first));
                }
            }
        }
        self.judge(words, &extent, [&first, &last], "if each axis of this rapid moves on its own, ", findings);
    }
}

/// Every pair of rotary values at every corner of the box of the linear words; `counts`: number of values of each axis.
fn pairs(
    from: &[f64; MAX_AXES],
    to: &[f64; MAX_AXES],
    counts: [u32; MAX_AXES],
    linear: u16,
) -> impl Iterator<Item = [f64; MAX_AXES]> {
    let all: u32 = counts.iter().product();
    let corners = (0..=linear).filter(move |corner| corner & !linear == 0);
    corners.flat_map(move |corner| (0..all).map(move |pair| (corner, pair))).map(move |(corner, pair)| {
        let mut rest = pair;
        std::array::from_fn(|index| {
            let (step, last) = (rest % counts[index], counts[index] - 1);
            rest /= counts[index];
            let share = match corner & (1 << index) {
                0 if last == 0 => 0.0,
                0 => f64::from(step) / f64::from(last),
                _ => 1.0,
            };
            from[index] + (to[index] - from[index]) * share
        })
    })
}

/// The point near the best pair where a value is largest: one rotary axis after the other, twice.
fn farther(
    from: &[f64; MAX_AXES],
    to: &[f64; MAX_AXES],
    counts: [u32; MAX_AXES],
    mut words: [f64; MAX_AXES],
    value: impl Fn(&[f64; MAX_AXES]) -> f64,
) -> [f64; MAX_AXES] {
    for index in (0..MAX_AXES).chain(0..MAX_AXES).filter(|index| counts[*index] > 1) {
        let step = (to[index] - from[index]).abs() / f64::from(counts[index] - 1);
        let (least, most) = (from[index].min(to[index]), from[index].max(to[index]));
        let with = |word: f64| {
            let mut moved = words;
            moved[index] = word;
            moved
        };
        let (low, high) = ((words[index] - step).max(least), (words[index] + step).min(most));
        let better = with(highest(low, high, |word| value(&with(word))));
        if value(&better) > value(&words) {
            words = better;
        }
    }
    words
}
