//! Random set-ups and poses.

use core::f64::consts::{FRAC_PI_2, PI};

use nalgebra::{Point3, Vector3};
use pp_runtime::kinematics::{AxisKind, DimensionKind, Pose};

use super::{Fault, first_branch, oracle_of};
use crate::oracle::{Oracle, wrapped};
use crate::random::Random;
use crate::subject::Subject;

/// A machine with a set-up, and the oracle of both.
pub(super) struct Setting {
    pub(super) machine: Box<dyn Subject>,
    pub(super) oracle: Oracle,
    /// `σ` of the first branch, if the documented rule decides it here.
    pub(super) first_branch: Option<f64>,
    pub(super) description: String,
}

/// A pose, and the axis values and conditioning from which it was made.
pub(super) struct Case {
    /// Axis values of the pose.
    pub(super) values: Vec<f64>,
    pub(super) pose: Pose,
    /// Input of the inverse kinematics: true values of held axes, random values elsewhere.
    pub(super) held: Vec<f64>,
    pub(super) determinant: f64,
    /// Sines of the angle to the pole and to the rim; 1 where there is none.
    pub(super) pole_sine: f64,
    pub(super) rim_sine: f64,
}

impl Setting {
    pub(super) fn draw(declared: &dyn Subject, as_declared: bool, random: &mut Random) -> Self {
        let mut machine = declared.copy();
        let mut description = format!(
            "machine {}, chain {}",
            declared.name(),
            declared.axes().iter().map(|axis| axis.letter).collect::<String>()
        );
        if !as_declared {
            let origin = Vector3::from_fn(|_, _| random.between(-300.0, 300.0));
            let gauge = random.between(0.0, 300.0);
            machine.set_up(origin, gauge);
            description += &format!("\npart origin {origin:?}, gauge length {gauge:?}");
            for (index, dimension) in declared.dimensions().iter().enumerate() {
                let value = match dimension.kind {
                    DimensionKind::Length => random.between(-300.0, 300.0),
                    DimensionKind::Angle => declared.dimension(index) + random.between(-0.3, 0.3),
                };
                machine.set_dimension(index, value);
                if machine.validate().is_err() {
                    machine.set_dimension(index, declared.dimension(index));
                }
                description += &format!(", {} = {:?}", dimension.name, machine.dimension(index));
            }
        }
        let oracle = oracle_of(&*machine);
        let first_branch = first_branch(declared, &oracle);
        Self { machine, oracle, first_branch, description }
    }

    pub(super) fn fault(&self, rule: &'static str, case: &Case, more: &str) -> Fault {
        let Case { values, pose, held, determinant, pole_sine, rim_sine, .. } = case;
        Fault {
            rule,
            details: format!(
                "{}\naxis values {values:?}, held {held:?}\ntip {:?}, axis {:?}\ndeterminant {determinant:e}, sine to \
                 pole {pole_sine:e}, to rim {rim_sine:e}\n{more}",
                self.description,
                pose.tip.coords.as_slice(),
                pose.axis.as_slice(),
            ),
        }
    }

    /// Input of the inverse kinematics for these axis values: held axes keep theirs, the others get random values.
    pub(super) fn held(&self, values: &[f64], random: &mut Random) -> Vec<f64> {
        let axes = self.machine.axes();
        (0..values.len())
            .map(|index| match axes[index].kind {
                _ if axes[index].held => values[index],
                AxisKind::Linear => random.between(-500.0, 500.0),
                AxisKind::Rotary => random.between(-PI, PI),
            })
            .collect()
    }

    /// Random axis values; linear axes are still at zero.
    pub(super) fn draw_angles(&self, random: &mut Random) -> Vec<f64> {
        let axes = self.machine.axes();
        let defaults = self.machine.default_held();
        let mut values = vec![0.0; axes.len()];
        for (index, axis) in axes.iter().enumerate() {
            if axis.held {
                values[index] = match axis.kind {
                    _ if random.chance(0.3) => defaults[index],
                    AxisKind::Linear => random.between(-200.0, 200.0),
                    AxisKind::Rotary => random.between(-PI, PI),
                };
            }
        }
        let edge = self.oracle.rotaries(&values).map(|rotaries| rotaries.edge());
        for (place, &index) in self.oracle.rotary().iter().enumerate() {
            let mut special = vec![0.0, FRAC_PI_2, -FRAC_PI_2, PI];
            if let (1, Some(edge)) = (place, edge) {
                let edge = self.oracle.sign(index) * edge;
                special.extend([edge, wrapped(edge + PI), edge, wrapped(edge + PI)]);
            }
            let angle = special[random.below(special.len())];
            values[index] = match random.below(10) {
                0..5 => random.between(-PI, PI),
                5..7 => angle,
                _ => wrapped(angle + random.sign() * 10f64.powf(random.between(-12.0, -3.0))),
            };
        }
        values
    }

    /// A reachable pose; `None` where the machine cannot tilt the tool at the held values.
    pub(super) fn draw_case(&self, random: &mut Random) -> Option<Case> {
        let mut values = self.draw_angles(random);
        if self.oracle.rotaries(&values).is_some_and(|rotaries| rotaries.authority() < 0.01) {
            return None;
        }
        let determinant = self.oracle.determinant(&values).abs();
        if determinant < 1e-6 {
            for index in self.oracle.linear() {
                values[index] = random.between(-500.0, 500.0);
            }
        } else {
            let tip = Point3::from(Vector3::from_fn(|_, _| random.between(-500.0, 500.0)));
            self.oracle.bring_tip_to(&tip, &mut values);
        }
        let pose = self.oracle.forward(&values);
        let held = self.held(&values, random);
        Some(self.case(values, pose, held))
    }

    pub(super) fn case(&self, values: Vec<f64>, pose: Pose, held: Vec<f64>) -> Case {
        let determinant = self.oracle.determinant(&values).abs();
        let (mut pole_sine, mut rim_sine) = (1.0, 1.0);
        if let Some(rotaries) = self.oracle.rotaries(&values) {
            pole_sine = rotaries.first.cross(&pose.axis).norm();
            let tilted = self.oracle.axis_before_first(&values);
            rim_sine = rotaries.first.dot(&rotaries.second.cross(&tilted)).abs() / rotaries.authority();
        }
        Case { values, pose, held, determinant, pole_sine, rim_sine }
    }
}
