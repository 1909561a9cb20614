//! What every machine must do, whoever wrote or generated it.
//!
//! Poses are made by the [oracle](crate::oracle) from random axis values: the tip inside a cube of 1 m, rotaries over
//! the whole turn and, more often than chance would have it, at 0, ±90°, ±180°, at the pole, at the rim, and 1e-3 to
//! 1e-12 rad beside them. Part origin, gauge length and dimensions are random too.
//!
//! [`check`] runs everything and panics with the machine, the set-up and the pose; [`find_fault`] answers instead;
//! [`conformance!`](crate::conformance!) makes a test module with one test per [`Check`].

use core::f64::consts::{FRAC_PI_2, PI};
use core::fmt;

use nalgebra::{Point3, UnitVector3, Vector3};
use pp_runtime::kinematics::{
    AxisKind, Branch, DimensionKind, Machine, MotionBound, Pose, REACH_TOLERANCE, Side, Unreachable,
};

use crate::block::{Deviation, deviation};
use crate::oracle::{Oracle, Rotaries, angle_between, wrapped};
use crate::random::Random;
use crate::subject::{Erased, Found, Subject};

/// Largest distance of the tip reached from the tip wanted, mm, where the linear axes are well conditioned.
pub const POSITION: f64 = 1e-9;
/// The same, times the determinant, where they are not.
pub const POSITION_BY_DETERMINANT: f64 = 1e-12;
/// Largest angle between the axis reached and the axis wanted beyond the deviation that the solution reports, rad.
pub const AXIS: f64 = 1e-12;
/// Largest difference of a rotary value from the one that made the pose, rad, times the sine of the angle to the pole
/// or the rim, whichever is smaller.
pub const ROTARY: f64 = 1e-9;
/// Below this sine only poses are compared.
pub const SMALLEST_SINE: f64 = 1e-6;
/// Largest distance of forward kinematics from the matrix product, as a share of travel and arms (plus 1 mm).
pub const FORWARD_SHARE: f64 = 1e-13;
/// Largest angle between the axis of forward kinematics and that of the matrix product, rad.
pub const FORWARD_AXIS: f64 = 1e-13;
/// Largest difference of the length of an axis from 1.
pub const UNIT: f64 = 1e-14;
/// Largest difference of `rates` from the derivatives of the matrix product, as a share of what takes part.
pub const RATE_SHARE: f64 = 1e-13;
/// A bound is at most this many times the true deviation, in the median of blocks as they are cut.
pub const MOTION_MEDIAN: f64 = 1.05;
/// Places of a block that are looked at.
const BLOCK_POINTS: usize = 1000;
/// One block instead of so many poses.
const POSES_PER_BLOCK: usize = 50;
/// A block as it is cut turns no axis by more than this, rad.
const USUAL_TURN: f64 = 0.1;
/// Poses per set-up.
const POSES_PER_SET_UP: usize = 16;

/// One family of checks.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Check {
    /// `AXES`, `HELD`, `DIMENSIONS`, joints and `validate` agree with each other.
    Declaration,
    /// Forward kinematics is the product of the declared joints.
    Forward,
    /// Every reachable pose is solved; every solution gives the pose back; the axis values that made the pose are among
    /// the solutions; branches stand in their documented order; `linear_axes` and `reach` agree.
    Inverse,
    /// At the exact pole there is one solution, and the free rotary keeps its held value.
    Pole,
    /// Axes outside the cone are refused, those inside are not, and a hair outside counts as rounding.
    Reach,
    /// NaN and infinity have no solution.
    NotFinite,
    /// `rates` are the derivatives of the product of the declared joints.
    Rates,
    /// `motion` is never below the deviation of a block, looked at everywhere, and not far above it.
    Motion,
}

impl Check {
    /// All of them.
    pub const ALL: [Self; 8] = [
        Self::Declaration,
        Self::Forward,
        Self::Inverse,
        Self::Pole,
        Self::Reach,
        Self::NotFinite,
        Self::Rates,
        Self::Motion,
    ];
}

/// A machine that does not do what it must.
#[derive(Debug, Clone)]
pub struct Fault {
    /// The rule that is broken.
    pub rule: &'static str,
    /// Machine, set-up, pose and numbers.
    pub details: String,
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}\n{}", self.rule, self.details)
    }
}

/// Makes a test module `$name` for a machine: one test per [`Check`](crate::conformance::Check), with `$poses` random
/// poses each (2000 if not said).
#[macro_export]
macro_rules! conformance {
    ($machine:ty, $name:ident) => {
        $crate::conformance!($machine, $name, 2000);
    };
    ($machine:ty, $name:ident, $poses:expr) => {
        mod $name {
            #[allow(unused_imports)]
            use super::*;
            use $crate::conformance::{Check, run};

            #[test]
            fn declaration_agrees_with_itself() {
                run::<$machine>(Check::Declaration, $poses);
            }
            #[test]
            fn forward_kinematics_is_the_matrix_product() {
                run::<$machine>(Check::Forward, $poses);
            }
            #[test]
            fn every_reachable_pose_is_solved_and_found_again() {
                run::<$machine>(Check::Inverse, $poses);
            }
            #[test]
            fn the_free_rotary_keeps_its_held_value_at_the_pole() {
                run::<$machine>(Check::Pole, $poses);
            }
            #[test]
            fn axes_are_refused_where_the_machine_cannot_reach() {
                run::<$machine>(Check::Reach, $poses);
            }
            #[test]
            fn nan_and_infinity_have_no_solution() {
                run::<$machine>(Check::NotFinite, $poses);
            }
            #[test]
            fn rates_are_the_derivatives_of_the_matrix_product() {
                run::<$machine>(Check::Rates, $poses);
            }
            #[test]
            fn no_block_leaves_its_line_by_more_than_motion_says() {
                run::<$machine>(Check::Motion, $poses);
            }
        }
    };
}

/// Runs all checks with `poses` random poses each.
///
/// # Panics
/// With the first [`Fault`].
pub fn check<M: Machine>(poses: usize) {
    for check in Check::ALL {
        run::<M>(check, poses);
    }
}

/// Runs one check with `poses` random poses.
///
/// # Panics
/// With the first [`Fault`].
pub fn run<M: Machine>(check: Check, poses: usize) {
    if let Err(fault) = perform(&Erased(M::default()), check, poses) {
        panic!("{fault}");
    }
}

/// The first fault of a machine, if it has one.
#[must_use]
pub fn find_fault<M: Machine>(poses: usize) -> Option<Fault> {
    Check::ALL.into_iter().find_map(|check| perform(&Erased(M::default()), check, poses).err())
}

fn perform(declared: &dyn Subject, check: Check, poses: usize) -> Result<(), Fault> {
    if check == Check::Declaration {
        return declaration(declared);
    }
    let poses = if check == Check::Motion { poses.div_ceil(POSES_PER_BLOCK) } else { poses };
    let mut margins = Margins::default();
    // Every chain has a stream of its own.
    let letters =
        declared.axes().iter().fold(check as u64, |seed, axis| seed * 131 + u64::from(u32::from(axis.letter)));
    let mut random = Random::new(letters);
    let mut done = 0;
    let mut attempts = 0;
    while done < poses {
        let setting = Setting::draw(declared, attempts == 0, &mut random);
        attempts += 1;
        for _ in 0..POSES_PER_SET_UP.min(poses - done) {
            match check {
                Check::Declaration => {}
                Check::Forward => setting.forward(&mut random)?,
                Check::Inverse => setting.inverse(&mut random)?,
                Check::Pole => setting.pole(&mut random)?,
                Check::Reach => setting.reach(&mut random)?,
                Check::NotFinite => setting.not_finite(&mut random)?,
                Check::Rates => setting.rates(&mut random)?,
                Check::Motion => setting.motion(&mut random, &mut margins)?,
            }
            done += 1;
        }
    }
    margins.check(declared)
}

/// Checks that what a machine says about itself fits together.
fn declaration(declared: &dyn Subject) -> Result<(), Fault> {
    let rule = |rule: &'static str, holds: bool| {
        let chain: String = declared.axes().iter().map(|axis| axis.letter).collect();
        if holds { Ok(()) } else { Err(Fault { rule, details: format!("machine {}, chain {chain}", declared.name()) }) }
    };
    let axes = declared.axes();
    let held = declared.default_held();
    rule("HELD has one value per axis", held.len() == axes.len())?;
    rule("the machine has a name", !declared.name().is_empty())?;
    rule(
        "exactly three linear axes are solved for",
        axes.iter().filter(|axis| axis.kind == AxisKind::Linear && !axis.held).count() == 3,
    )?;
    rule(
        "at most two rotary axes are solved for",
        axes.iter().filter(|axis| axis.kind == AxisKind::Rotary && !axis.held).count() <= 2,
    )?;
    rule("workpiece side comes before tool side", axes.is_sorted_by_key(|axis| axis.side == Side::Tool))?;
    rule("the tool axis is a unit vector", (declared.tool_axis().norm() - 1.0).abs() <= UNIT)?;
    for (index, axis) in axes.iter().enumerate() {
        rule("no letter is used twice", axes[..index].iter().all(|other| other.letter != axis.letter))?;
        let kind = match axis.letter {
            'A'..='C' => AxisKind::Rotary,
            'U'..='Z' => AxisKind::Linear,
            _ => return rule("an axis is one of X Y Z U V W A B C", false),
        };
        rule("A B C turn and X Y Z U V W slide", axis.kind == kind)?;
        rule("HELD is zero for an axis that is solved for", axis.held || held[index].abs() <= 0.0)?;
        if let Some(limits) = axis.limits {
            rule("travel is not empty", limits.lower <= limits.upper)?;
        }
        let joint = declared.joint(index);
        rule("a joint's sign is that of its axis", (joint.sign - axis.sign.factor()).abs() <= 0.0)?;
        rule("a joint's direction is a unit vector", (joint.direction.norm() - 1.0).abs() <= UNIT)?;
        if axis.kind == AxisKind::Linear {
            rule("a linear joint stands at the origin", joint.point.coords.norm() <= 0.0)?;
        }
    }
    rule("the declared dimensions are valid", declared.validate().is_ok())?;
    let mut changed = declared.fresh();
    for (index, dimension) in declared.dimensions().iter().enumerate() {
        rule("a dimension starts at its default", (declared.dimension(index) - dimension.default).abs() <= 0.0)?;
        changed.set_dimension(index, 0.125);
        rule("a dimension keeps what it is given", (changed.dimension(index) - 0.125).abs() <= 0.0)?;
        changed.set_dimension(index, f64::NAN);
        rule("a dimension that is not a number is invalid", changed.validate().is_err())?;
        changed = declared.fresh();
    }
    changed.set_up(Vector3::new(0.0, f64::INFINITY, 0.0), 0.0);
    rule("an infinite part origin is invalid", changed.validate().is_err())?;
    changed.set_up(Vector3::zeros(), f64::NAN);
    rule("a gauge length that is not a number is invalid", changed.validate().is_err())
}

/// A machine with a set-up, and the oracle of both.
struct Setting {
    machine: Box<dyn Subject>,
    oracle: Oracle,
    /// `σ` of the first branch, if the documented rule decides it here.
    first_branch: Option<f64>,
    description: String,
}

/// A pose, and how it was made.
struct Case {
    /// The axis values that made it.
    values: Vec<f64>,
    pose: Pose,
    /// Input of the inverse kinematics: true values of held axes, anything elsewhere.
    held: Vec<f64>,
    determinant: f64,
    /// Sines of the angle to the pole and to the rim; 1 where there is no such thing.
    pole_sine: f64,
    rim_sine: f64,
}

impl Setting {
    fn draw(declared: &dyn Subject, as_declared: bool, random: &mut Random) -> Self {
        let mut machine = declared.fresh();
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
                    DimensionKind::Angle => dimension.default + random.between(-0.3, 0.3),
                };
                machine.set_dimension(index, value);
                if machine.validate().is_err() {
                    machine.set_dimension(index, dimension.default);
                }
                description += &format!(", {} = {:?}", dimension.name, machine.dimension(index));
            }
        }
        let oracle = oracle_of(&*machine);
        let first_branch = first_branch(declared, &oracle);
        Self { machine, oracle, first_branch, description }
    }

    fn fault(&self, rule: &'static str, case: &Case, more: &str) -> Fault {
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

    /// Input of the inverse kinematics for these axis values: only held axes keep theirs.
    fn held(&self, values: &[f64], random: &mut Random) -> Vec<f64> {
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
    fn draw_angles(&self, random: &mut Random) -> Vec<f64> {
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

    /// A reachable pose; `None` where held values leave the machine no way to tilt the tool.
    fn draw_case(&self, random: &mut Random) -> Option<Case> {
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

    fn case(&self, values: Vec<f64>, pose: Pose, held: Vec<f64>) -> Case {
        let determinant = self.oracle.determinant(&values).abs();
        let (mut pole_sine, mut rim_sine) = (1.0, 1.0);
        if let Some(rotaries) = self.oracle.rotaries(&values) {
            pole_sine = rotaries.first.cross(&pose.axis).norm();
            let tilted = self.oracle.axis_before_first(&values);
            rim_sine = rotaries.first.dot(&rotaries.second.cross(&tilted)).abs() / rotaries.authority();
        }
        Case { values, pose, held, determinant, pole_sine, rim_sine }
    }

    fn forward(&self, random: &mut Random) -> Result<(), Fault> {
        let mut values = self.draw_angles(random);
        for index in self.oracle.linear() {
            values[index] = random.between(-500.0, 500.0);
        }
        // Forward kinematics takes any number of turns.
        for index in self.oracle.rotary() {
            if random.chance(0.2) {
                values[index] += random.sign() * 2.0 * PI;
            }
        }
        let held = values.clone();
        let case = self.case(values, self.oracle.forward(&held), held);
        let pose = self.machine.forward(&case.values);
        let distance = (pose.tip - case.pose.tip).norm();
        let allowed = FORWARD_SHARE * self.oracle.scale(&case.values);
        if exceeds(distance, allowed) {
            let more = format!("forward kinematics says {:?}: {distance:e} mm off, allowed {allowed:e}", pose.tip);
            return Err(self.fault("forward kinematics puts the tip where the joints do", &case, &more));
        }
        let angle = angle_between(&pose.axis, &case.pose.axis);
        if exceeds(angle, FORWARD_AXIS) || exceeds((pose.axis.norm() - 1.0).abs(), UNIT) {
            let more = format!("forward kinematics says {:?}: {angle:e} rad off", pose.axis);
            return Err(self.fault("forward kinematics tilts the tool as the joints do", &case, &more));
        }
        Ok(())
    }

    fn inverse(&self, random: &mut Random) -> Result<(), Fault> {
        let Some(case) = self.draw_case(random) else { return Ok(()) };
        let solutions = self.machine.inverse(&case.pose, &case.held);
        if solutions.is_empty() && case.determinant >= 2e-9 {
            let more = format!("{:?}", self.machine.reach(&case.pose.axis, &case.held));
            return Err(self.fault("a pose that the machine reaches has a solution", &case, &more));
        }
        for solution in &solutions {
            self.solution(&case, solution)?;
        }
        self.found_again(&case, &solutions)?;
        self.branches(&case, &solutions)?;
        self.free_rotary(&case, &solutions)?;
        self.linear_axes(&case, &solutions, random)?;
        if self.machine.reach(&case.pose.axis, &case.held).is_ok() == solutions.is_empty() {
            let more = format!("{solutions:?}\n{:?}", self.machine.reach(&case.pose.axis, &case.held));
            return Err(self.fault("`reach` refuses exactly what has no solution", &case, &more));
        }
        Ok(())
    }

    /// A solution, put through the oracle, is the pose.
    fn solution(&self, case: &Case, solution: &Found) -> Result<(), Fault> {
        let fault = |rule, more: &str| Err(self.fault(rule, case, &format!("{solution:?}\n{more}")));
        if solution.axes.iter().any(|value| !value.is_finite()) {
            return fault("solutions are finite numbers", "");
        }
        for (index, axis) in self.machine.axes().iter().enumerate() {
            let value = solution.axes[index];
            if axis.held && value.to_bits() != case.held[index].to_bits() {
                return fault("a held axis keeps its value", "");
            }
            if axis.kind == AxisKind::Rotary && !axis.held && !(value > -PI && value <= PI) {
                return fault("rotary values are in (-180°, 180°]", "");
            }
        }
        let determinant = self.oracle.determinant(&solution.axes).abs();
        if determinant < 0.5e-9 {
            return fault("degenerate linear axes have no solution", &format!("determinant {determinant:e}"));
        }
        if !(0.0..=AXIS).contains(&solution.deviation) {
            return fault("an axis that the machine reaches is reached", "");
        }
        let reached = self.oracle.forward(&solution.axes);
        let distance = (reached.tip - case.pose.tip).norm();
        let allowed = position_tolerance(determinant);
        if exceeds(distance, allowed) {
            let more = format!("{distance:e} mm off, allowed {allowed:e}, determinant {determinant:e}");
            return fault("a solution brings the tip to the pose", &more);
        }
        let angle = angle_between(&reached.axis, &case.pose.axis);
        if exceeds(angle, AXIS + solution.deviation) {
            return fault("a solution brings the tool axis to the pose", &format!("{angle:e} rad off"));
        }
        Ok(())
    }

    /// The axis values that made the pose are among the solutions.
    fn found_again(&self, case: &Case, solutions: &[Found]) -> Result<(), Fault> {
        let sine = case.pole_sine.min(case.rim_sine);
        if sine < SMALLEST_SINE || case.determinant < 2e-9 {
            return Ok(());
        }
        let angle = ROTARY / sine;
        let lever = self.oracle.scale(&case.values) + case.pose.tip.coords.norm();
        let length = (2.0 * angle * lever + POSITION) / case.determinant;
        let same = |solution: &Found| {
            self.machine.axes().iter().enumerate().all(|(index, axis)| {
                let difference = solution.axes[index] - case.values[index];
                match axis.kind {
                    AxisKind::Rotary => wrapped(difference).abs() <= angle,
                    AxisKind::Linear => difference.abs() <= length,
                }
            })
        };
        if solutions.iter().any(same) {
            return Ok(());
        }
        let more = format!("within {angle:e} rad and {length:e} mm\n{solutions:?}");
        Err(self.fault("the axis values that made the pose are found again", case, &more))
    }

    /// First comes first, and the second is another one.
    fn branches(&self, case: &Case, solutions: &[Found]) -> Result<(), Fault> {
        if let [first, second] = solutions {
            if (first.branch, second.branch) != (Branch::First, Branch::Second) {
                return Err(self.fault("the first branch comes first", case, &format!("{solutions:?}")));
            }
            if case.rim_sine > 1e-14 && first.axes == second.axes {
                return Err(self.fault("two solutions are two", case, &format!("{solutions:?}")));
            }
        }
        let &[_, second_rotary] = &self.oracle.rotary()[..] else {
            return if solutions.len() < 2 {
                Ok(())
            } else {
                Err(self.fault("fewer than two rotaries have one solution", case, &format!("{solutions:?}")))
            };
        };
        let (Some(sigma), Some(rotaries)) = (self.first_branch, self.oracle.rotaries(&case.values)) else {
            return Ok(());
        };
        if case.rim_sine < SMALLEST_SINE {
            return Ok(());
        }
        for solution in solutions {
            let (sin, cos) = (self.oracle.sign(second_rotary) * solution.axes[second_rotary]).sin_cos();
            // `n · axis` falls with the second angle on the branch `σ = 1`.
            let falls = rotaries.cosine_part() * sin - rotaries.sine_part() * cos;
            if ((falls * sigma > 0.0) != (solution.branch == Branch::First)) && falls.abs() > 1e-9 {
                return Err(self.fault("branches are what they are documented to be", case, &format!("{solutions:?}")));
            }
        }
        Ok(())
    }

    /// `singular` is told at the pole and nowhere else.
    fn free_rotary(&self, case: &Case, solutions: &[Found]) -> Result<(), Fault> {
        if self.oracle.rotary().len() < 2 {
            return match solutions.iter().any(|solution| solution.singular) {
                true => Err(self.fault("only two rotaries can leave one free", case, &format!("{solutions:?}"))),
                false => Ok(()),
            };
        }
        let first = self.oracle.rotary()[0];
        for solution in solutions {
            let says = |rule| Err(self.fault(rule, case, &format!("{solutions:?}")));
            if solution.singular && case.pole_sine > 4e-15 {
                return says("a rotary is free at the pole only");
            }
            if !solution.singular && case.pole_sine < 3e-16 {
                return says("at the pole the first rotary is free");
            }
            if solution.singular && solution.axes[first].to_bits() != case.held[first].to_bits() {
                return says("a free rotary keeps its held value");
            }
            if solution.singular && solutions.len() != 1 {
                return says("at the pole there is one solution");
            }
        }
        Ok(())
    }

    /// `linear_axes` says what the inverse says, and what the oracle says.
    fn linear_axes(&self, case: &Case, solutions: &[Found], random: &mut Random) -> Result<(), Fault> {
        let mut wanted = case.values.clone();
        for index in self.oracle.linear() {
            wanted[index] = random.between(-500.0, 500.0);
        }
        let expected = solutions.iter().map(|solution| (&solution.axes, Some(&solution.axes)));
        for (input, solution) in expected.chain([(&wanted, None)]) {
            let determinant = self.oracle.determinant(input).abs();
            let answer = self.machine.linear_axes(&case.pose.tip, input);
            let fault = |rule| Err(self.fault(rule, case, &format!("linear_axes({input:?}) = {answer:?}")));
            let Some(axes) = &answer else {
                if determinant >= 2e-9 {
                    return fault("`linear_axes` has an answer");
                }
                continue;
            };
            if determinant < 0.5e-9 {
                return fault("`linear_axes` has no answer where the linear axes are degenerate");
            }
            let linear = self.oracle.linear();
            if (0..axes.len()).any(|index| !linear.contains(&index) && axes[index].to_bits() != input[index].to_bits())
            {
                return fault("`linear_axes` leaves rotary and held values alone");
            }
            let allowed = position_tolerance(determinant);
            if exceeds((self.oracle.forward(axes).tip - case.pose.tip).norm(), allowed) {
                return fault("`linear_axes` brings the tip to where it should be");
            }
            if let Some(solution) = solution
                && linear
                    .iter()
                    .any(|&index| exceeds((axes[index] - solution[index]).abs(), 2.0 * allowed / determinant))
            {
                return fault("`linear_axes` agrees with the inverse kinematics");
            }
        }
        Ok(())
    }

    fn pole(&self, random: &mut Random) -> Result<(), Fault> {
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
    fn outside(&self, axis: &Vector3<f64>, values: &[f64]) -> f64 {
        match (self.oracle.rotaries(values), &self.oracle.rotary()[..]) {
            (Some(rotaries), _) => {
                let angle = angle_between(&rotaries.first, axis);
                let (smallest, largest) = rotaries.cone();
                // A cone that ends at a pole ends nowhere.
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

    /// Direction of the only solved rotary as the workpiece sees it, and a tool axis that it reaches.
    fn single(&self, values: &[f64]) -> (Vector3<f64>, Vector3<f64>) {
        let index = self.oracle.rotary()[0];
        let mut turned = values.to_vec();
        let tools = [0.0, 1.5, 3.0].map(|angle| {
            turned[index] = angle;
            self.oracle.forward(&turned).axis.into_inner()
        });
        // Three points of a circle have its axis as their normal.
        ((tools[1] - tools[0]).cross(&(tools[2] - tools[0])).normalize(), tools[0])
    }

    fn reach(&self, random: &mut Random) -> Result<(), Fault> {
        let values = self.draw_angles(random);
        if self.oracle.rotaries(&values).is_some_and(|rotaries| rotaries.authority() < 0.01) {
            return Ok(());
        }
        let axis = Vector3::from(random.direction());
        self.expect_reach(&values, axis, random)?;
        // A little outside the edges of what can be reached.
        let (direction, angles) = match (self.oracle.rotaries(&values), &self.oracle.rotary()[..]) {
            (Some(rotaries), _) => (rotaries.first, [rotaries.cone().0, rotaries.cone().1]),
            (None, []) => (self.oracle.forward(&values).axis.into_inner(), [0.0, 0.0]),
            (None, _) => {
                let (first, tool) = self.single(&values);
                (first, [angle_between(&first, &tool); 2])
            }
        };
        let beside_pole = |rotaries: Rotaries| {
            let (smallest, largest) = rotaries.cone();
            smallest.min(PI - largest) < 1e-3 && !rotaries.ends_at_pole(1.0) && !rotaries.ends_at_pole(-1.0)
        };
        if self.oracle.rotaries(&values).is_some_and(beside_pole) {
            // A held head at a few hundredths of a degree: the edge is a cone of a hair's width.
            return Ok(());
        }
        let edge = random.below(2);
        let amount = REACH_TOLERANCE * [0.5, 2.0][random.below(2)];
        let angle = angles[edge] + amount * [-1.0, 1.0][edge];
        let side = direction.cross(&Vector3::from(random.direction())).normalize();
        let axis = direction * angle.cos() + side * angle.sin();
        self.expect_reach(&values, axis, random)
    }

    /// Compares inverse kinematics and `reach` with how far the axis lies outside.
    fn expect_reach(&self, values: &[f64], axis: Vector3<f64>, random: &mut Random) -> Result<(), Fault> {
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
                return fault("a hair outside the cone the nearest axis is used");
            }
        }
        Ok(())
    }

    fn rates(&self, random: &mut Random) -> Result<(), Fault> {
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

    fn sum(&self, kind: AxisKind, values: &[f64]) -> f64 {
        let axes = self.machine.axes().iter().zip(values);
        axes.filter(|(axis, _)| axis.kind == kind).map(|(_, value)| value.abs()).sum()
    }

    /// Changes of axis values, from a hair to more than half a turn; held axes mostly stand still.
    fn draw_change(&self, random: &mut Random) -> Vec<f64> {
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
    fn motion(&self, random: &mut Random, margins: &mut Margins) -> Result<(), Fault> {
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

    fn not_finite(&self, random: &mut Random) -> Result<(), Fault> {
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

/// How far bounds are above the truth: quotients, where there is something to divide by.
#[derive(Debug, Default)]
struct Margins {
    tip: Vec<f64>,
    axis: Vec<f64>,
}

impl Margins {
    fn add(&mut self, bound: MotionBound, truth: Deviation) {
        if truth.tip > 1e-6 {
            self.tip.push(bound.tip / truth.tip);
        }
        if truth.axis > 1e-9 {
            self.axis.push(bound.axis / truth.axis);
        }
    }

    fn check(self, declared: &dyn Subject) -> Result<(), Fault> {
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

/// NaN exceeds everything.
fn exceeds(error: f64, allowed: f64) -> bool {
    error > allowed || error.is_nan()
}

fn position_tolerance(determinant: f64) -> f64 {
    POSITION.max(POSITION_BY_DETERMINANT / determinant)
}

fn oracle_of(machine: &dyn Subject) -> Oracle {
    let joints = (0..machine.axes().len()).map(|index| machine.joint(index)).collect();
    Oracle::new(machine.axes(), joints, machine.tool_axis())
}

/// `σ` of the first branch: decided at the default dimensions and held values, then fixed.
fn first_branch(declared: &dyn Subject, current: &Oracle) -> Option<f64> {
    let default = oracle_of(&*declared.fresh());
    let held = declared.default_held();
    let (at_default, now) = (default.rotaries(&held)?, current.rotaries(&held)?);
    let sign = default.sign(*default.rotary().get(1)?);
    let (alpha1, alpha2) = (at_default.cosine_part(), at_default.sine_part());
    if alpha1.abs() > 1e-9 {
        Some(alpha1.signum() * sign)
    } else if now.cosine_part().abs() < 1e-9 {
        Some(-alpha2.signum())
    } else {
        // Zero at the defaults only: which rule applies is the machine's to say.
        None
    }
}
