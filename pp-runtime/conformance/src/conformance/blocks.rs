//! Checks of blocks: derivatives of the pose, and the bound of the deviation.

use nalgebra::Vector3;
use pp_runtime::kinematics::{AxisKind, MotionBound};

use super::setting::Setting;
use super::{BLOCK_POINTS, CUT_ROTATION, Fault, MOTION_MEDIAN, RATE_SHARE, exceeds};
use crate::block::{Deviation, deviation};
use crate::random::Random;
use crate::subject::Subject;

impl Setting {
    pub(super) fn rates(&self, random: &mut Random) -> Result<(), Fault> {
        let Some(case) = self.draw_case(random) else { return Ok(()) };
        let change = self.draw_change(random);
        let (tip, axis) = self.machine.rates(&case.values, &change);
        let (true_tip, true_axis) = self.oracle.rates(&case.values, &change);
        let rotation: f64 = self.sum(AxisKind::Rotary, &change);
        let travel = self.sum(AxisKind::Linear, &change);
        let more = format!("change {change:?}: {tip:?} and {axis:?} instead of {true_tip:?} and {true_axis:?}");
        if exceeds((tip - true_tip).norm(), RATE_SHARE * (travel + rotation * self.oracle.scale(&case.values))) {
            return Err(self.fault("`rates` are the derivatives of the tip", &case, &more));
        }
        if exceeds((axis - true_axis).norm(), RATE_SHARE * 10.0 * rotation) {
            return Err(self.fault("`rates` are the derivatives of the tool axis", &case, &more));
        }
        Ok(())
    }

    pub(super) fn sum(&self, kind: AxisKind, values: &[f64]) -> f64 {
        let axes = self.machine.axes().iter().zip(values);
        axes.filter(|(axis, _)| axis.kind == kind).map(|(_, value)| value.abs()).sum()
    }

    /// Changes of axis values, up to 300 mm and 4 rad, down to 1e-5 of that; held axes mostly do not move.
    pub(super) fn draw_change(&self, random: &mut Random) -> Vec<f64> {
        let size = 10f64.powf(random.between(-5.0, 0.0));
        let mut change = |axis: &pp_runtime::kinematics::Axis| {
            let still = random.chance(if axis.held { 0.8 } else { 0.15 });
            let size = if random.chance(0.2) { 10f64.powf(random.between(-5.0, 0.0)) } else { size };
            match axis.kind {
                _ if still => 0.0,
                AxisKind::Linear => random.between(-300.0, 300.0) * size,
                AxisKind::Rotary => random.between(-4.0, 4.0) * size,
            }
        };
        self.machine.axes().iter().map(&mut change).collect()
    }

    /// Checks the bound of one block: a random one, or one whose linear axes bring the tip to a point nearby, as in a
    /// cut.
    pub(super) fn motion(&self, random: &mut Random, margins: &mut Margins) -> Result<(), Fault> {
        let Some(case) = self.draw_case(random) else { return Ok(()) };
        let change = self.draw_change(random);
        let mut to: Vec<f64> = case.values.iter().zip(&change).map(|(value, change)| value + change).collect();
        if random.chance(0.7) && self.oracle.determinant(&to).abs() > 1e-3 {
            let offset = Vector3::from(random.direction()) * 10f64.powf(random.between(-4.0, 2.0));
            self.oracle.bring_tip_to(&(case.pose.tip + offset), &mut to);
        }
        let bound = self.machine.motion(&case.values, &to);
        let deviation = deviation(&self.oracle, &case.values, &to, BLOCK_POINTS);
        let more = format!("to {to:?}: {bound:?}, true {deviation:?}");
        if exceeds(deviation.tip_mm, bound.tip) {
            return Err(self.fault("no tip deviates from its line more than the bound of `motion`", &case, &more));
        }
        if exceeds(deviation.axis_rad, bound.axis) {
            return Err(self.fault("no tool axis deviates from its arc more than the bound of `motion`", &case, &more));
        }
        if let Some(rough) = self.machine.rough_motion(&case.values, &to) {
            let exceeding = exceeds(deviation.tip_mm, rough.tip)
                || exceeds(deviation.axis_rad, rough.axis)
                || exceeds(deviation.axis_step_rad, rough.axis_step);
            if exceeding {
                let more = format!("{more}, rough {rough:?}");
                return Err(self.fault("no block deviates more than the rough bound of its `curves`", &case, &more));
            }
        }
        let change: Vec<f64> = case.values.iter().zip(&to).map(|(from, to)| to - from).collect();
        let levers = self.oracle.scale(&case.values) + self.oracle.scale(&to);
        let rounding =
            RATE_SHARE * (self.sum(AxisKind::Linear, &change) + self.sum(AxisKind::Rotary, &change) * levers);
        if exceeds(deviation.tip_rate_mm, bound.tip_rate + rounding) {
            return Err(self.fault("no tip is faster than the bound of `motion`", &case, &more));
        }
        let (start, end) = (self.oracle.forward(&case.values), self.oracle.forward(&to));
        if exceeds(deviation.axis_step_rad, bound.axis_step) || exceeds(deviation.tip_step_mm, bound.tip_step) {
            return Err(self.fault("no block is out of step by more than the bound of `motion`", &case, &more));
        }
        let turn = crate::oracle::angle_between(&start.axis, &end.axis);
        if exceeds(bound.length, (end.tip - start.tip).norm()) || exceeds(turn, bound.turn) {
            return Err(self.fault("`motion` bounds the length and the angle of a block", &case, &more));
        }
        if exceeds(deviation.lag_rad, bound.lag(0.0)) {
            return Err(self.fault("no tool axis lags the tip by more than the bound of `motion`", &case, &more));
        }
        let as_in_a_cut = |(axis, change): (&pp_runtime::kinematics::Axis, &f64)| {
            axis.kind == AxisKind::Linear || change.abs() <= CUT_ROTATION
        };
        if self.machine.axes().iter().zip(&change).all(as_in_a_cut) {
            margins.add(bound, deviation);
        }
        Ok(())
    }
}

/// Quotients of bounds and true deviations, for deviations large enough to divide by.
#[derive(Debug, Default)]
pub(super) struct Margins {
    tip: Vec<f64>,
    axis: Vec<f64>,
    rate: Vec<f64>,
    step: Vec<f64>,
}

impl Margins {
    pub(super) fn add(&mut self, bound: MotionBound, actual: Deviation) {
        if actual.tip_mm > 1e-6 {
            self.tip.push(bound.tip / actual.tip_mm);
        }
        if actual.axis_rad > 1e-9 {
            self.axis.push(bound.axis / actual.axis_rad);
        }
        if actual.axis_step_rad > 1e-6 {
            self.step.push(bound.axis_step / actual.axis_step_rad);
        }
        if actual.tip_rate_mm > 1e-3 {
            self.rate.push(bound.tip_rate / actual.tip_rate_mm);
        }
    }

    pub(super) fn check(self, declared: &dyn Subject) -> Result<(), Fault> {
        for (what, mut quotients) in
            [("tip", self.tip), ("axis", self.axis), ("speed", self.rate), ("axis in step", self.step)]
        {
            quotients.sort_by(f64::total_cmp);
            // A median of a few values is random.
            let Some(median) = quotients.get(quotients.len() / 2).filter(|_| quotients.len() >= 30) else { continue };
            if *median > MOTION_MEDIAN {
                let details = format!(
                    "machine {}: the median bound of the {what} is {median} times the true deviation",
                    declared.name()
                );
                return Err(Fault { rule: "a bound is near the true deviation", details });
            }
        }
        Ok(())
    }
}
