//! Checks of the pole, of the cone of reachable tool axes, and of poses with NaN or infinity.

use core::f64::consts::PI;

use nalgebra::{Point3, UnitVector3, Vector3};
use pp_runtime::kinematics::{Pose, REACH_TOLERANCE, Unreachable};

use super::setting::Setting;
use super::{AXIS, Fault, exceeds};
use crate::oracle::{Rotaries, angle_between, wrapped};
use crate::random::Random;

impl Setting {
    pub(super) fn pole(&self, random: &mut Random) -> Result<(), Fault> {
        let mut values = self.draw_angles(random);
        let (Some(rotaries), &[first, second]) = (self.oracle.rotaries(&values), &self.oracle.rotary()[..]) else {
            return Ok(());
        };
        let held = self.held(&values, random);
        values[first] = held[first];
        for direction in [1.0, -1.0] {
            if rotaries.authority() < 0.01 || !rotaries.ends_at_pole(direction) {
                continue;
            }
            let edge = if direction > 0.0 { rotaries.edge() } else { rotaries.edge() + PI };
            values[second] = wrapped(self.oracle.sign(second) * edge);
            if self.oracle.determinant(&values).abs() < 1e-6 {
                continue;
            }
            let tip = Point3::from(Vector3::from_fn(|_, _| random.between(-500.0, 500.0)));
            let pose = Pose { tip, axis: UnitVector3::new_normalize(rotaries.first * direction) };
            self.oracle.bring_tip_to(&tip, &mut values);
            let case = self.case(values.clone(), pose, held.clone());
            let solutions = self.machine.inverse(&case.pose, &case.held);
            let [solution] = &solutions[..] else {
                return Err(self.fault("at the pole there is one solution", &case, &format!("{solutions:?}")));
            };
            if !solution.singular {
                return Err(self.fault("at the pole the first rotary is free", &case, &format!("{solutions:?}")));
            }
            self.free_rotary(&case, &solutions)?;
            self.solution(&case, solution)?;
        }
        Ok(())
    }

    /// Angle by which an axis lies outside what the machine reaches, rad; negative inside.
    pub(super) fn outside(&self, axis: &Vector3<f64>, values: &[f64]) -> f64 {
        match (self.oracle.rotaries(values), &self.oracle.rotary()[..]) {
            (Some(rotaries), _) => {
                let angle = angle_between(&rotaries.first, axis);
                let (smallest, largest) = rotaries.cone();
                // A cone that ends at a pole has no edge there.
                let below = if smallest < 1e-9 { f64::NEG_INFINITY } else { smallest - angle };
                let above = if largest > PI - 1e-9 { f64::NEG_INFINITY } else { angle - largest };
                below.max(above)
            }
            (None, []) => angle_between(&self.oracle.forward(values).axis, axis),
            (None, _) => {
                let (first, tool) = self.single(values);
                (angle_between(&first, axis) - angle_between(&first, &tool)).abs()
            }
        }
    }

    /// Direction of the only solved rotary in the workpiece frame, and a tool axis that it reaches.
    pub(super) fn single(&self, values: &[f64]) -> (Vector3<f64>, Vector3<f64>) {
        let index = self.oracle.rotary()[0];
        let mut rotated = values.to_vec();
        let tools = [0.0, 1.5, 3.0].map(|angle| {
            rotated[index] = angle;
            self.oracle.forward(&rotated).axis.into_inner()
        });
        // The plane through three points of a circle is perpendicular to its axis.
        ((tools[1] - tools[0]).cross(&(tools[2] - tools[0])).normalize(), tools[0])
    }

    pub(super) fn reach(&self, random: &mut Random) -> Result<(), Fault> {
        let values = self.draw_angles(random);
        if self.oracle.rotaries(&values).is_some_and(|rotaries| rotaries.authority() < 0.01) {
            return Ok(());
        }
        let axis = Vector3::from(random.direction());
        self.expect_reach(&values, axis, random)?;
        // Slightly outside the edges of the cone.
        let (direction, angles) = match (self.oracle.rotaries(&values), &self.oracle.rotary()[..]) {
            (Some(rotaries), _) => (rotaries.first, [rotaries.cone().0, rotaries.cone().1]),
            (None, []) => (self.oracle.forward(&values).axis.into_inner(), [0.0, 0.0]),
            (None, _) => {
                let (first, tool) = self.single(&values);
                (first, [angle_between(&first, &tool); 2])
            }
        };
        let near_pole = |rotaries: Rotaries| {
            let (smallest, largest) = rotaries.cone();
            smallest.min(PI - largest) < 1e-3 && !rotaries.ends_at_pole(1.0) && !rotaries.ends_at_pole(-1.0)
        };
        if self.oracle.rotaries(&values).is_some_and(near_pole) {
            // A held head tilted by a few hundredths of a degree: the edge is a very narrow cone.
            return Ok(());
        }
        let edge = random.below(2);
        let amount = REACH_TOLERANCE * [0.5, 2.0][random.below(2)];
        let angle = angles[edge] + amount * [-1.0, 1.0][edge];
        let side = direction.cross(&Vector3::from(random.direction())).normalize();
        let axis = direction * angle.cos() + side * angle.sin();
        self.expect_reach(&values, axis, random)
    }

    /// Compares inverse kinematics and `reach` with the angle of the axis outside the cone.
    pub(super) fn expect_reach(&self, values: &[f64], axis: Vector3<f64>, random: &mut Random) -> Result<(), Fault> {
        let pose = Pose { tip: Point3::origin(), axis: UnitVector3::new_normalize(axis) };
        let held = self.held(values, random);
        let outside = self.outside(&axis, values);
        let case = self.case(values.to_vec(), pose, held);
        let solutions = self.machine.inverse(&case.pose, &case.held);
        let reach = self.machine.reach(&case.pose.axis, &case.held);
        let more = format!("{outside:e} rad outside\n{solutions:?}\n{reach:?}");
        let fault = |rule| Err(self.fault(rule, &case, &more));
        if reach.is_ok() == solutions.is_empty() {
            return fault("`reach` refuses exactly what has no solution");
        }
        if outside > 1.5 * REACH_TOLERANCE {
            return if reach.is_err() { Ok(()) } else { fault("an axis outside the cone is refused") };
        }
        if matches!(reach, Err(Unreachable::LinearAxes { .. })) {
            // Allowed where the linear axes can degenerate at all; the oracle judges every solution that is given.
            return Ok(());
        }
        if reach.is_err() {
            return fault("an axis that the machine reaches is not refused");
        }
        for solution in &solutions {
            let angle = angle_between(&self.oracle.forward(&solution.axes).axis, &case.pose.axis);
            if exceeds(angle, AXIS + solution.deviation) {
                return fault("a solution reports how far its axis deviates");
            }
            if exceeds((solution.deviation - outside.max(0.0)).abs(), 1e-9) {
                return fault("just outside the cone the nearest axis is used");
            }
        }
        Ok(())
    }

    pub(super) fn not_finite(&self, random: &mut Random) -> Result<(), Fault> {
        let Some(case) = self.draw_case(random) else { return Ok(()) };
        for component in 0..6 {
            for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
                let (mut tip, mut axis) = (case.pose.tip, case.pose.axis.into_inner());
                if component < 3 {
                    tip[component] = bad;
                } else {
                    axis[component - 3] = bad;
                }
                let pose = Pose { tip, axis: UnitVector3::new_unchecked(axis) };
                let solutions = self.machine.inverse(&pose, &case.held);
                if !solutions.is_empty() {
                    let more = format!("{pose:?}: {solutions:?}");
                    return Err(self.fault("NaN and infinity have no solution", &case, &more));
                }
                if component >= 3 && self.machine.reach(&pose.axis, &case.held).is_ok() {
                    return Err(self.fault("`reach` refuses NaN and infinity", &case, &format!("{pose:?}")));
                }
            }
        }
        Ok(())
    }
}
