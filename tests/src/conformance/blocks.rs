//! Blocks: derivatives of the pose, and the bound of the deviation.

use nalgebra::Vector3;
use pp_runtime::kinematics::{AxisKind, MotionBound};

use super::setting::Setting;
use super::{BLOCK_POINTS, Fault, MOTION_MEDIAN, RATE_SHARE, USUAL_TURN, exceeds};
use crate::block::{Deviation, deviation};
use crate::random::Random;
use crate::subject::Subject;

impl Setting {
    pub(super) fn rates(&self, random: &mut Random) -> Result<(), Fault> {
        let Some(case) = self.draw_case(random) else { return Ok(()) };
        let change = self.draw_change(random);
        let (tip, axis) = self.machine.rates(&case.values, &change);
        let (true_tip, true_axis) = self.oracle.rates(&case.values, &change);
        let turns: f64 = self.sum(AxisKind::Rotary, &change);
        let travel = self.sum(AxisKind::Linear, &change);
        let more = format!("change {change:?}: {tip:?} and {axis:?} instead of {true_tip:?} and {true_axis:?}");
        if exceeds((tip - true_tip).norm(), RATE_SHARE * (travel + turns * self.oracle.scale(&case.values))) {
            return Err(self.fault("`rates` are the derivatives of the tip", &case, &more));
        }
        if exceeds((axis - true_axis).norm(), RATE_SHARE * 10.0 * turns) {
            return Err(self.fault("`rates` are the derivatives of the tool axis", &case, &more));
        }
        Ok(())
    }

    pub(super) fn sum(&self, kind: AxisKind, values: &[f64]) -> f64 {
        let axes = self.machine.axes().iter().zip(values);
        axes.filter(|(axis, _)| axis.kind == kind).map(|(_, value)| value.abs()).sum()
    }

    /// Changes of axis values, from a hair to more than half a turn; held axes mostly stand still.
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

    /// A block: at random, or one whose linear axes bring the tip to a point nearby, as when something is cut.
    pub(super) fn motion(&self, random: &mut Random, margins: &mut Margins) -> Result<(), Fault> {
        let Some(case) = self.draw_case(random) else { return Ok(()) };
        let change = self.draw_change(random);
        let mut to: Vec<f64> = case.values.iter().zip(&change).map(|(value, change)| value + change).collect();
        if random.chance(0.7) && self.oracle.determinant(&to).abs() > 1e-3 {
            let way = Vector3::from(random.direction()) * 10f64.powf(random.between(-4.0, 2.0));
            self.oracle.bring_tip_to(&(case.pose.tip + way), &mut to);
        }
        let bound = self.machine.motion(&case.values, &to);
        let deviation = deviation(&self.oracle, &case.values, &to, BLOCK_POINTS);
        let more = format!("to {to:?}: {bound:?}, in truth {deviation:?}");
        if exceeds(deviation.tip, bound.tip) {
            return Err(self.fault("no tip is farther from its line than `motion` says", &case, &more));
        }
        if exceeds(deviation.axis, bound.axis) {
            return Err(self.fault("no tool axis is farther from its arc than `motion` says", &case, &more));
        }
        let usual = |(axis, change): (&pp_runtime::kinematics::Axis, &f64)| {
            axis.kind == AxisKind::Linear || change.abs() <= USUAL_TURN
        };
        if self.machine.axes().iter().zip(&change).all(usual) {
            margins.add(bound, deviation);
        }
        Ok(())
    }
}

/// How far bounds are above the truth: quotients, where there is something to divide by.
#[derive(Debug, Default)]
pub(super) struct Margins {
    tip: Vec<f64>,
    axis: Vec<f64>,
}

impl Margins {
    pub(super) fn add(&mut self, bound: MotionBound, truth: Deviation) {
        if truth.tip > 1e-6 {
            self.tip.push(bound.tip / truth.tip);
        }
        if truth.axis > 1e-9 {
            self.axis.push(bound.axis / truth.axis);
        }
    }

    pub(super) fn check(self, declared: &dyn Subject) -> Result<(), Fault> {
        for (what, mut quotients) in [("tip", self.tip), ("axis", self.axis)] {
            quotients.sort_by(f64::total_cmp);
            // A median of a few is chance.
            let Some(median) = quotients.get(quotients.len() / 2).filter(|_| quotients.len() >= 30) else { continue };
            if *median > MOTION_MEDIAN {
                let details = format!("machine {}: the bound of the {what} is {median} times", declared.name());
                return Err(Fault { rule: "a bound is near the truth", details });
            }
        }
        Ok(())
    }
}
