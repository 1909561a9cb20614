//! Speeds of the axes within a block under tip control.
//!
//! The control moves the tip on a line and the rotary axes evenly; the linear axes follow on curves, on which they are now
//! faster, now slower. Some controls do not hold the speeds of the axes there, so the block has to take long enough.
//!
//! With `s` the share of the block, `θ` the sum of its rotations, `ΔP` its tip path and `w` a bound of the distance from the
//! tip to the centre lines, a linear axis `q(s)` has `|q''| <= w θ² + 2 |ΔP| θ`, times the length of its row in the map from the
//! workpiece to the axes. Over a part of length `h` its speed differs from its mean there by `h` times this bound at most.

use nalgebra::Point3;

use super::{AxisPosition, Placer};
use crate::kinematics::{AxisValues, Side};

/// Largest ratio of the bound of a time to the time that is known to be needed.
const LOOSE: f64 = 1.01;

/// Most parts of a block: at so many the bound is within a thousandth.
const MOST_PARTS: f64 = 4096.0;

impl Placer {
    /// Time of a block under tip control in which no axis exceeds its speed anywhere, min; 0 if speeds need not be kept. It may be
    /// any time up to `enough_min` where that is long enough.
    ///
    /// The block is divided until the bound is at most a hundredth above the time that is needed. Where linear axes are between
    /// the rotary ones or not perpendicular, `|q''|` is bounded by the longest row of the map at both ends.
    pub(crate) fn least_minutes_at_tip(&self, from: &AxisPosition, to: &AxisPosition, enough_min: f64) -> f64 {
        let ends = self.least_minutes(from, to).unwrap_or(0.0);
        let rotation: f64 =
            self.rotary.axes.iter().map(|rotary| (to.axes[rotary.index] - from.axes[rotary.index]).abs()).sum();
        if !self.speeds.timed || rotation <= 0.0 {
            return ends;
        }
        let bend_mm = self.bend_mm(from, to, rotation);
        let mut parts = 1.0;
        loop {
            let Some([needed, bound]) = self.minutes_by_parts(from, to, parts, bend_mm / parts) else { return ends };
            let (needed, bound) = (needed.max(ends), bound.max(ends));
            if bound <= enough_min || bound <= LOOSE * needed || parts >= MOST_PARTS {
                return bound;
            }
            parts *= 4.0;
        }
    }

    /// Time that the fastest part of a block needs at least, and a bound for any place in it.
    fn minutes_by_parts(&self, from: &AxisPosition, to: &AxisPosition, parts: f64, bend_mm: f64) -> Option<[f64; 2]> {
        let mut before = from.axes;
        let mut minutes = [0.0_f64; 2];
        for part in 1..=parts as u32 {
            let axes = self.on_the_way(from, to, f64::from(part) / parts)?;
            for index in (0..self.chain.len()).filter(|index| self.linear.mask & (1 << index) != 0) {
                if let Some(speed) = self.speeds.per_axis[index] {
                    let mean = (axes[index] - before[index]).abs() * parts;
                    minutes[0] = minutes[0].max(mean / speed);
                    minutes[1] = minutes[1].max((mean + bend_mm) / speed);
                }
            }
            before = axes;
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
        self.machine.linear_axes(&tip, &axes)
    }

    /// Bound of the second derivative of the linear axes by the share of the block, mm.
    fn bend_mm(&self, from: &AxisPosition, to: &AxisPosition, rotation: f64) -> f64 {
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
        row.fold(1.0, f64::max) * rotation * (lever * rotation + 2.0 * travel)
    }
}
