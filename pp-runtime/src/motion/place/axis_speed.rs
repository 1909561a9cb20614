//! Speeds of the axes within a block under tip control.
//!
//! The control moves the tip on a line and the rotary axes evenly; the linear axes follow on curves, on which they are
//! now faster, now slower. Some controls do not hold the speeds of the axes there, so the block has to take long
//! enough.
//!
//! With `s` the share of the block, `θ` the sum of its rotations, `ΔP` its tip path and `w` a bound of the distance
//! from the tip to the centre lines, a linear axis `q(s)` has `|q'''| <= J = w θ³ + 3 |ΔP| θ²`, times the length of its
//! row in the map from the workpiece to the axes.
//!
//! Where a rotary axis carries a linear one, the map `A` itself changes: with `r` its longest row `|A'| <= r² θ`,
//! `|A''| <= 3 r³ θ²` and `|A'''| <= 13 r⁴ θ³`, so that `J = r⁴ (26 w θ³ + 18 |ΔP| θ²)`.
//!
//! Over a part of length `h` that it passes with the step `Δ`, `Δ'` being that of a part next to it,
//!
//! ```text
//! q'(½) = Δ/h within h² J/24,   q''(½) = (Δ' - Δ)/h² within 3 h J/2,   |q'(s)| = |q'(½) + (s - ½) h q''(½)| within h²
//! J/8
//! ```
//!
//! so its largest speed there is `|Δ|/h + |Δ' - Δ|/(2 h)` within `h² J`.

use nalgebra::Point3;

use super::{AxisPosition, Placer};
use crate::kinematics::{AxisValues, Side, carried};
use crate::tolerance::writer::TIME_BOUND;

/// Least and most parts of a block.
const LEAST_PARTS: f64 = 4.0;
const MOST_PARTS: f64 = 1024.0;

/// A block that takes so many times as long leads by a place at which linear axes are parallel: it would take forever.
const MOST_SLOWED: f64 = 1000.0;

impl Placer {
    /// Time of a block under tip control in which no axis exceeds its speed anywhere, min; 0 if speeds need not be
    /// kept. It may be any time up to `enough_min` where that is long enough.
    ///
    /// The block is divided until the bound is at most a hundredth above the time that is needed. The longest row of
    /// the map is that at both ends.
    pub(crate) fn least_minutes_at_tip(&self, from: &AxisPosition, to: &AxisPosition, enough_min: f64) -> f64 {
        let ends = self.least_minutes(from, to).unwrap_or(0.0);
        let rotation: f64 =
            self.rotary.axes.iter().map(|rotary| (to.axes[rotary.index] - from.axes[rotary.index]).abs()).sum();
        if !self.speeds.timed || rotation <= 0.0 {
            return ends;
        }
        let jerk_mm = self.jerk_mm(from, to, rotation);
        let mut parts = LEAST_PARTS;
        loop {
            let Some(minutes) = self.minutes_by_parts(from, to, parts, jerk_mm / (parts * parts)) else { return ends };
            let [needed, bound] = minutes.map(|minutes| minutes.max(ends));
            let exact = bound <= TIME_BOUND * needed;
            if carried(self.chain).is_some() && (needed > MOST_SLOWED * enough_min || !exact && parts >= MOST_PARTS) {
                return f64::INFINITY;
            }
            if bound <= enough_min || exact || parts >= MOST_PARTS {
                return bound;
            }
            parts *= 4.0;
        }
    }

    /// Time that the fastest place of a block needs at least, and a bound for any place in it. `unsure_mm`: of each
    /// speed.
    fn minutes_by_parts(&self, from: &AxisPosition, to: &AxisPosition, parts: f64, unsure_mm: f64) -> Option<[f64; 2]> {
        let at = |part: u32| self.on_the_way(from, to, f64::from(part) / parts);
        let (mut before, mut axes) = (at(0)?, at(1)?);
        let mut minutes = [0.0_f64; 2];
        for part in 2..=parts as u32 {
            let after = at(part)?;
            for &index in &self.linear.solved {
                if let Some(speed) = self.speeds.per_axis[index] {
                    let [step, next] = [axes[index] - before[index], after[index] - axes[index]];
                    // For the part before the place between the two, and for the one after it.
                    let fastest = (step.abs().max(next.abs()) + 0.5 * (next - step).abs()) * parts;
                    minutes[0] = minutes[0].max((fastest - unsure_mm) / speed);
                    minutes[1] = minutes[1].max((fastest + unsure_mm) / speed);
                }
            }
            (before, axes) = (axes, after);
        }
        Some(minutes)
    }

    /// Axis values at a share of a block under tip control.
    fn on_the_way(&self, from: &AxisPosition, to: &AxisPosition, share: f64) -> Option<AxisValues> {
        let mut axes = from.axes;
        for rotary in &self.rotary.axes {
            axes[rotary.index] += share * (to.axes[rotary.index] - from.axes[rotary.index]);
        }
        let tip: Point3<f64> = from.pose.tip + (to.pose.tip - from.pose.tip) * share;
        self.machine.set_linear_axes(&tip, &mut axes).then_some(axes)
    }

    /// Bound of the third derivative of the linear axes by the share of the block, mm.
    fn jerk_mm(&self, from: &AxisPosition, to: &AxisPosition, rotation: f64) -> f64 {
        let centres = |side: Side| {
            let of_side = self.rotary.axes.iter().filter(move |rotary| self.chain[rotary.index].side == side);
            of_side.map(|rotary| self.machine.joint(rotary.index).point)
        };
        let between = |side: Side| -> f64 {
            centres(side).zip(centres(side).skip(1)).map(|(one, other)| (other - one).norm()).sum()
        };
        // The table's centre lines are seen from the tip, those of the head are at arms from it.
        let from_tip = |tip: &Point3<f64>| centres(Side::Workpiece).map(|at| (tip - at).norm()).fold(0.0, f64::max);
        let table = from_tip(&from.pose.tip).max(from_tip(&to.pose.tip)) + between(Side::Workpiece);
        let head = centres(Side::Tool).map(|at| at.coords.norm()).fold(0.0, f64::max) + between(Side::Tool);
        let lever = table + head;
        let travel = (to.pose.tip - from.pose.tip).norm();
        let row = [from, to]
            .into_iter()
            .filter_map(|end| self.axis_map(end))
            .map(|(_, map)| (0..3).map(|row| map.row(row).norm()).fold(0.0, f64::max));
        let row = row.fold(1.0, f64::max);
        let bound =
            |of_lever: f64, of_travel: f64| rotation * rotation * (of_lever * lever * rotation + of_travel * travel);
        match carried(self.chain) {
            None => row * bound(1.0, 3.0),
            Some(_) => row.powi(4) * bound(26.0, 18.0),
        }
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;
    use crate::config::starting_point;
    use crate::kinematics::Pose;
    use crate::kinematics::machines::Cb;
    use crate::program::Units;

    /// Largest speed of Y in a block, times its time, at two thousand places.
    fn fastest_y(placer: &Placer, from: &AxisPosition, to: &AxisPosition) -> f64 {
        let y = |share: f64| placer.on_the_way(from, to, share).expect("solvable")[3];
        let places: Vec<f64> = (0..=2000).map(|place| y(f64::from(place) / 2e3)).collect();
        places.windows(2).map(|pair| (pair[1] - pair[0]).abs() * 2e3).fold(0.0, f64::max)
    }

    #[test]
    fn the_time_of_a_block_is_at_most_a_hundredth_longer_than_the_fastest_place_of_an_axis_needs() {
        let keys = "part_origin = [-18.0, -44.0, -39.5]\n[speeds]\nY = 1000.0\n";
        let config = starting_point(&crate::control::LinuxCnc).read_over(&Cb::default(), keys).expect("valid keys");
        let machine = config.set_up.machine::<Cb>().expect("valid");
        let placer = Placer::new(Box::new(machine), config.policy(), Units::Millimetres);
        let place = |tip: [f64; 3], c: f64, b: f64| {
            let mut place = placer.zero();
            (place.words[0], place.words[1]) = (placer.scale().word(c), placer.scale().word(b));
            let words = place.words;
            let mut pose = Pose { tip: Point3::from(tip), axis: place.pose.axis };
            let at = placer.position_at(&pose, &place, &words);
            pose.axis = placer.machine.forward_kinematics(&at.axes).axis;
            placer.solved(placer.position_at(&pose, &place, &words)).expect("a place")
        };
        for round in 0..40 {
            let wave = |phase: f64| (1.7 * f64::from(round) + phase).sin();
            let tip = [30.0 + 20.0 * wave(0.3), 53.0 + 20.0 * wave(1.1), 20.0 * wave(2.2)];
            let step = [0.3 * wave(0.5), 0.3 * wave(0.7), 0.1 * wave(0.9)];
            let (c, b) = (PI * wave(1.9), 0.02 * wave(0.2));
            let from = place(tip, c, b);
            let rotation = 10_f64.powf(-2.5 + 2.7 * f64::from(round % 20) / 20.0);
            let to = place(std::array::from_fn(|index| tip[index] + step[index]), c + rotation, b + 0.01 * wave(2.9));
            let needed = fastest_y(&placer, &from, &to) / 1000.0;
            let time = placer.least_minutes_at_tip(&from, &to, 0.0);
            // The words of Y are rounded at both ends.
            let rounding = 2e-3 / 1000.0;
            assert!(time >= needed * 0.9999 && time <= needed * 1.011 + rounding, "{round}: {time} for {needed}");
            assert!(placer.least_minutes_at_tip(&from, &to, 2.0 * needed) <= 2.0 * needed, "{round}");
        }
    }
}
