//! Smallest and largest axis values during a part of a motion: certified, not sampled.
//!
//! Axes that move linearly are between their ends. Where the control keeps the tip on a path, the linear axes follow
//! from the rotary axes: with `t = F(L, R)` the tip of linear values `L` and rotary values `R`,
//!
//! ```text
//! |F(L, R) - F(M, R)| >= σ |L - M|        σ: least singular value of the directions of the linear axes
//! ```
//!
//! so that linear values differ by no more than tips do, divided by `σ`. Rotary axes that move evenly are compared with
//! the motion of all axes between the same ends, whose tip is known by [`StepBound`].
//!
//! # A tool axis on a great circle
//! The control finds the rotary values. Their rate is `|R'| <= θ/s`, with `θ` the angle of the tool axis and `s` the
//! least singular value of the 3 x 2 matrix `J` of its rates by the rotary axes. `J` has columns `n × a` and `m × a`,
//! which change by no more than √7 |ΔR| together. While `√7 |ΔR| <= s₀/2`, `s >= s₀/2` and `|ΔR| <= 2θ/s₀ = x`: if
//! `√7 x <= s₀/2` this holds for the whole part, since `R` cannot leave without passing that distance. The linear
//! values are bounded in the same manner: a bound that is larger than what follows from it is never reached.

use nalgebra::{Matrix3, Vector3};

use super::any::{AnyMachine, AxisValues, MAX_AXES};
use super::{AxisKind, StepBound};

/// √7, rounded up.
const CHANGE: f64 = 2.646;

/// Least singular value of the directions of the linear axes that is used.
const LEAST_STRETCH: f64 = 0.02;

/// Smallest and largest axis values, mm and rad.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AxisRanges {
    /// Smallest values.
    pub low: AxisValues,
    /// Largest values.
    pub high: AxisValues,
}

impl AxisRanges {
    /// All axes between their ends.
    #[must_use]
    pub fn between(from: &AxisValues, to: &AxisValues) -> Self {
        Self {
            low: std::array::from_fn(|index| from[index].min(to[index])),
            high: std::array::from_fn(|index| from[index].max(to[index])),
        }
    }

    /// The rotary axes evenly between their ends, the tip within a distance, mm, of the even motion on a straight line.
    /// `None`: not found.
    #[must_use]
    pub fn of_tip(machine: &dyn AnyMachine, from: &AxisValues, to: &AxisValues, tip_mm: f64) -> Option<Self> {
        let between = Self::between(from, to);
        let off = tip_mm + StepBound::of(machine, from, to).tip;
        Some(between.with_linear(machine, off / stretch(machine, from, rotation(machine, from, to))?))
    }

    /// The tool axis evenly on a great circle by an angle, rad, and the tip on a straight line; the control finds the
    /// rotary axes. `None`: not found.
    #[must_use]
    pub fn of_great_circle(machine: &dyn AnyMachine, from: &AxisValues, to: &AxisValues, angle: f64) -> Option<Self> {
        let rotary: Vec<usize> = solved(machine, AxisKind::Rotary).collect();
        let rates = |index: usize| machine.rates(from, &std::array::from_fn(|other| f64::from(other == index)));
        let columns: Vec<Vector3<f64>> = rotary.iter().map(|index| rates(*index).1).collect();
        let least = match columns.as_slice() {
            [] => return Self::of_tip(machine, from, to, 0.0),
            [one] => one.norm(),
            [one, two, ..] => {
                let (a, b, c) = (one.norm_squared(), one.dot(two), two.norm_squared());
                let mean = f64::midpoint(a, c);
                (mean - (mean * mean - (a * c - b * b)).max(0.0).sqrt()).max(0.0).sqrt()
            }
        };
        let turn = 2.0 * angle / least;
        if turn.is_nan() || CHANGE * turn > 0.5 * least {
            return None;
        }
        let tips = [from, to].map(|axes| machine.forward_kinematics(axes).tip);
        let travel = (tips[1] - tips[0]).norm();
        let levers: f64 = rotary.iter().map(|index| rates(*index).0.norm()).sum();
        let stretch = stretch(machine, from, turn * rotary.len() as f64)?;
        // The tip moves seen from each rotary axis: by the linear axes, and by the rotary ones after it.
        let moved = |linear: f64| 3.0_f64.sqrt() * linear + turn * (levers + 3.0_f64.sqrt() * linear) * 1.5;
        let reached = |linear: f64| (travel + turn * (levers + rotary.len() as f64 * moved(linear))) / stretch;
        let linear = 2.0 * (travel + turn * levers) / stretch + 1e-9;
        if reached(linear) > linear {
            return None;
        }
        let mut ranges = Self { low: *from, high: *from };
        for &index in &rotary {
            (ranges.low[index], ranges.high[index]) = (from[index] - turn, from[index] + turn);
        }
        Some(ranges.with_linear(machine, linear))
    }

    /// These ranges with solved linear axes farther by a distance on both sides, mm.
    fn with_linear(mut self, machine: &dyn AnyMachine, by: f64) -> Self {
        for index in solved(machine, AxisKind::Linear) {
            self.low[index] -= by;
            self.high[index] += by;
        }
        self
    }

    /// Axis values in the middle.
    #[must_use]
    pub fn middle(&self) -> AxisValues {
        std::array::from_fn(|index| f64::midpoint(self.low[index], self.high[index]))
    }

    /// Largest distance of each axis value from others.
    #[must_use]
    pub fn from(&self, values: &AxisValues) -> AxisValues {
        std::array::from_fn(|index| (self.high[index] - values[index]).max(values[index] - self.low[index]))
    }
}

fn solved(machine: &dyn AnyMachine, kind: AxisKind) -> impl Iterator<Item = usize> {
    let axes = machine.axes();
    (0..axes.len().min(MAX_AXES)).filter(move |index| axes[*index].kind == kind && !axes[*index].held)
}

/// Sum of the rotations of all rotary axes, rad.
fn rotation(machine: &dyn AnyMachine, from: &AxisValues, to: &AxisValues) -> f64 {
    solved(machine, AxisKind::Rotary).map(|index| (to[index] - from[index]).abs()).sum()
}

/// Least singular value of the directions of the linear axes, for rotations of all rotary axes by a sum, rad.
fn stretch(machine: &dyn AnyMachine, axes: &AxisValues, rotation: f64) -> Option<f64> {
    let linear: Vec<usize> = solved(machine, AxisKind::Linear).collect();
    let [first, _, last] = linear[..] else { return None };
    let column = |index: usize| machine.rates(axes, &std::array::from_fn(|other| f64::from(other == index))).0;
    let matrix = Matrix3::from_columns(&[column(linear[0]), column(linear[1]), column(linear[2])]);
    // Rotary axes between them rotate one against the other.
    let between = solved(machine, AxisKind::Rotary).any(|index| first < index && index < last);
    let change = if between { 3.0_f64.sqrt() * rotation } else { 0.0 };
    let least = matrix.singular_values().min() * (1.0 - 1e-9) - change;
    (least > LEAST_STRETCH).then_some(least)
}

#[cfg(test)]
mod tests {
    use nalgebra::UnitVector3;

    use super::*;
    use crate::kinematics::Pose;
    use crate::kinematics::machines::Cb;

    /// Axis values of a pose, near others.
    fn solution(machine: &dyn AnyMachine, pose: &Pose, near: &AxisValues) -> AxisValues {
        let solutions = machine.inverse_kinematics(pose, near);
        let away = |values: &AxisValues| (0..2).map(|index| (values[index] - near[index]).abs()).sum::<f64>();
        let all = solutions.iter().map(|solution| solution.axes);
        all.min_by(|a, b| away(a).total_cmp(&away(b))).expect("a solution")
    }

    fn assert_within(ranges: &AxisRanges, values: &AxisValues, about: &str) {
        for (index, value) in values.iter().enumerate() {
            let (low, high) = (ranges.low[index] - 1e-9, ranges.high[index] + 1e-9);
            assert!((low..=high).contains(value), "{about}: axis {index}: {value} {low} {high}");
        }
    }

    #[test]
    fn axis_values_while_the_control_keeps_the_tip_are_within_their_ranges() {
        let machine: &dyn AnyMachine = &Cb::default();
        let (mut found, mut tightest): (u32, f64) = (0, 0.0);
        for round in 0..40 {
            let wave = |phase: f64, size: f64| size * (0.9 * f64::from(round) + phase).sin();
            let tip = |by: f64| nalgebra::Point3::new(wave(0.3 + by, 80.0), wave(1.1 + by, 80.0), wave(2.0 + by, 60.0));
            let (from_tip, to_tip) = (tip(0.0), tip(0.02));
            let (mut from, mut to) = ([0.0; 9], [0.0; 9]);
            for index in 0..2 {
                from[index] = wave(2.3 * index as f64, 1.2);
                to[index] = from[index] + wave(1.7 * index as f64 + 1.0, 0.06);
            }
            let ends = [(&mut from, from_tip), (&mut to, to_tip)].map(|(axes, tip)| {
                *axes = machine.linear_axes(&tip, axes).expect("linear axes");
                *axes
            });
            let [from, to] = ends;
            // The rotary axes evenly.
            let ranges = AxisRanges::of_tip(machine, &from, &to, 0.0).expect("ranges");
            for place in 0..=100 {
                let share = f64::from(place) / 100.0;
                let rotary = std::array::from_fn(|index| from[index] + share * (to[index] - from[index]));
                let tip = from_tip + (to_tip - from_tip) * share;
                let values = machine.linear_axes(&tip, &rotary).expect("linear axes");
                assert_within(&ranges, &values, &format!("{round} {place}"));
                let middle = machine.linear_axes(&nalgebra::center(&from_tip, &to_tip), &ranges.middle());
                let bend = (2..5).map(|index| (middle.expect("values")[index] - ranges.middle()[index]).abs());
                tightest =
                    tightest.max(bend.fold(0.0, f64::max) / (ranges.high[2] - ranges.low[2] - (to[2] - from[2]).abs()));
            }
            // The tool axis evenly.
            let [a, b] = [&from, &to].map(|axes| machine.forward_kinematics(axes).axis.into_inner());
            let angle = a.cross(&b).norm().atan2(a.dot(&b));
            let parts = 8;
            let at = |share: f64, near: &AxisValues| {
                let axis = (a * ((1.0 - share) * angle).sin() + b * (share * angle).sin()) / angle.sin();
                let tip = from_tip + (to_tip - from_tip) * share;
                solution(machine, &Pose { tip, axis: UnitVector3::new_normalize(axis) }, near)
            };
            let mut here = from;
            for part in 0..parts {
                let share = |inner: f64| (f64::from(part) + inner) / f64::from(parts);
                let end = at(share(1.0), &here);
                if let Some(ranges) = AxisRanges::of_great_circle(machine, &here, &end, angle / f64::from(parts)) {
                    found += 1;
                    for place in 0..=50 {
                        let values = at(share(f64::from(place) / 50.0), &here);
                        assert_within(&ranges, &values, &format!("{round} {part} {place}"));
                    }
                }
                here = end;
            }
        }
        assert!(found > 240, "{found}");
        assert!(tightest > 0.2, "{tightest}");
    }
}
