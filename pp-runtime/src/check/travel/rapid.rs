//! A rapid under tip control in which every axis moves on its own.
//!
//! Every pair of rotary values may occur with every point of the box of the linear words. For a pair of rotary values
//! linear axes are affine in the words, so that the corners of the box suffice. Over the rotary values an axis value is
//! `Σ c_ij·g_i(a)·h_j(b)` with `g, h ∈ {1, cos, sin}`, because each rotary axis is one factor of the chain: nine values
//! give the bound of its curvature, and branch and bound its largest value. Nothing between samples is left out.

use std::f64::consts::FRAC_PI_2;

use super::{Block, Extent, Findings, MAX_AXES, Rules, Travel};
use crate::check::tolerances::AXIS_VALUE_NOISE;

/// Accuracy of a largest value that is outside the limits, mm and rad.
const ACCURACY: f64 = 1e-4;

/// Largest number of cells that are examined for one value; the rest counts with its bound.
const MOST_CELLS: usize = 20_000;

/// A rectangle of two rotary words: from and to of each.
type Cell = [[f64; 2]; 2];

impl Travel {
    pub(super) fn uncoordinated(
        &mut self,
        rules: &Rules<'_>,
        before: &[f64; MAX_AXES],
        block: &Block,
        findings: &mut Findings<'_>,
    ) {
        let words = rules.words();
        let at = |point: &[f64; MAX_AXES]| words.axes(point, &block.state);
        let (Some(first), Some(last)) = (at(before), at(&block.values)) else { return };
        let mut rotary = words.rotary();
        let rotary = [rotary.next(), rotary.next()];
        let cell = rotary.map(|index| index.map_or([0.0; 2], |index| [before[index], block.values[index]]));
        let (quiet, linear) = (self.quiet(words), words.linear_bits());
        let mut extent = Extent::of(&first);
        extent.take(&last);
        for corner in (0..=linear).filter(|corner| corner & !linear == 0) {
            let from: [f64; MAX_AXES] =
                std::array::from_fn(
                    |index| if corner & (1 << index) == 0 { before[index] } else { block.values[index] },
                );
            let with = |angles: [f64; 2]| {
                let mut point = from;
                for (index, angle) in rotary.into_iter().zip(angles) {
                    if let Some(index) = index {
                        point[index] = angle;
                    }
                }
                at(&point)
            };
            for axis in self.axes.iter().filter(|axis| !axis.rotary) {
                for side in [1.0, -1.0] {
                    let value = |angles: [f64; 2]| with(angles).map_or(f64::NEG_INFINITY, |at| side * at[axis.index]);
                    let inside = quiet.bound(axis.index, side).max(extent.bound(axis.index, side));
                    let largest = highest(value, cell, curvature(value), inside + AXIS_VALUE_NOISE);
                    let bound = if side > 0.0 { &mut extent.high } else { &mut extent.low };
                    if largest > inside {
                        bound[axis.index] = side * largest;
                    }
                }
            }
        }
        self.judge(words, &extent, [&first, &last], "if each axis of this rapid moves on its own, ", findings);
    }
}

/// Bound of the second derivative in each of two angles.
fn curvature(value: impl Fn([f64; 2]) -> f64) -> [f64; 2] {
    // Constant, cosine and sine from the values at 0, a quarter and half a revolution.
    let parts = |values: [f64; 3]| {
        let constant = f64::midpoint(values[0], values[2]);
        [constant, values[0] - constant, values[1] - constant]
    };
    let at = |quarters: usize| FRAC_PI_2 * quarters as f64;
    let bound = |value: &dyn Fn(f64, f64) -> f64| {
        let [_, cosine, sine] = transposed([0, 1, 2].map(|b| parts([0, 1, 2].map(|a| value(at(a), at(b))))));
        let largest = |over_b: [f64; 3]| {
            let [constant, cosine, sine] = parts(over_b);
            constant.abs() + cosine.hypot(sine)
        };
        largest(cosine).hypot(largest(sine))
    };
    [bound(&|a, b| value([a, b])), bound(&|b, a| value([a, b]))]
}

fn transposed(rows: [[f64; 3]; 3]) -> [[f64; 3]; 3] {
    [0, 1, 2].map(|column| rows.map(|row| row[column]))
}

/// Largest value over a cell, to [`ACCURACY`]; of no interest up to `threshold`, which is returned then or less.
///
/// Over a rectangle with edges `u` and `v` a function exceeds the largest of its corners by `(u²·m + v²·n) / 8` at
/// most, where `m` and `n` bound its second derivatives: the error of linear interpolation, once for each edge.
fn highest(value: impl Fn([f64; 2]) -> f64, cell: Cell, curvature: [f64; 2], threshold: f64) -> f64 {
    let (mut best, mut cells, mut examined) = (f64::NEG_INFINITY, vec![cell], 0);
    while let Some([a, b]) = cells.pop() {
        let corners = [[a[0], b[0]], [a[0], b[1]], [a[1], b[0]], [a[1], b[1]]].map(&value);
        let corner = corners.into_iter().fold(f64::NEG_INFINITY, f64::max);
        best = best.max(corner);
        let excess =
            [(a, curvature[0]), (b, curvature[1])].map(|(edge, bound)| (edge[1] - edge[0]).powi(2) * bound / 8.0);
        let above = corner + excess[0] + excess[1];
        if above <= threshold.max(best + ACCURACY) {
            continue;
        }
        examined += 1;
        if examined > MOST_CELLS {
            best = best.max(above);
            continue;
        }
        let halves = |[low, high]: [f64; 2]| {
            let middle = f64::midpoint(low, high);
            [[low, middle], [middle, high]]
        };
        if excess[0] >= excess[1] {
            cells.extend(halves(a).map(|a| [a, b]));
        } else {
            cells.extend(halves(b).map(|b| [a, b]));
        }
    }
    best
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Products of two trigonometric functions with random coefficients.
    fn wave(seed: u32) -> impl Fn([f64; 2]) -> f64 {
        let c: [f64; 9] = std::array::from_fn(|index| (f64::from(seed) * 1.7 + index as f64 * 2.3).sin() * 300.0);
        move |[a, b]: [f64; 2]| {
            let (g, h) = ([1.0, a.cos(), a.sin()], [1.0, b.cos(), b.sin()]);
            (0..9).map(|index| c[index] * g[index / 3] * h[index % 3]).sum()
        }
    }

    #[test]
    fn the_largest_value_of_a_rectangle_is_found_wherever_it_is() {
        for seed in 0..60 {
            let value = wave(seed);
            let at = f64::from(seed) * 0.21;
            let cell = [[at - 2.0, at + 0.3 * at.sin()], [0.7 * at, 0.7 * at + 1.9]];
            let found = highest(&value, cell, curvature(&value), f64::NEG_INFINITY);
            let sampled = (0..=400).flat_map(|i| (0..=400).map(move |j| [i, j].map(|step| f64::from(step) / 400.0)));
            let point = |share: [f64; 2]| [0, 1].map(|i| cell[i][0] + (cell[i][1] - cell[i][0]) * share[i]);
            let most = sampled.map(|share| value(point(share))).fold(f64::NEG_INFINITY, f64::max);
            assert!(found >= most - ACCURACY && found <= most + 0.02, "{seed}: {found} {most}");
        }
    }

    #[test]
    fn no_curvature_is_larger_than_its_bound() {
        for seed in 0..60 {
            let value = wave(seed);
            let [m, n] = curvature(&value);
            for step in 0..500 {
                let at = [f64::from(step) * 0.37, f64::from(step) * 0.91];
                let second = |by: [f64; 2]| {
                    let moved = |sign: f64| value([at[0] + sign * by[0], at[1] + sign * by[1]]);
                    (moved(1.0) - 2.0 * value(at) + moved(-1.0)) / 1e-6
                };
                assert!(second([1e-3, 0.0]).abs() <= m * 1.001 + 1e-3 && second([0.0, 1e-3]).abs() <= n * 1.001 + 1e-3);
            }
        }
    }
}
