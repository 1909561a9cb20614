//! The kinematics in C agree with those in Rust: every machine here is written as a C99 header, compiled with all
//! warnings as errors, and run on the same poses.
//!
//! Poles, rims, poses just beyond reach, angles near a quarter turn and poses that are not numbers are among them. The
//! guards of the C code are written apart from those of Rust, so a guard that one of the two lacks is found here.

mod compiled;
mod machines;

use std::f64::consts::{FRAC_PI_2, PI};

use nalgebra::{Point3, Unit, UnitVector3, Vector3};
use pp_runtime::kinematics::AnyMachine;
use pp_runtime::kinematics::{AxisKind, AxisValues, DimensionKind, MAX_AXES, Machine, Pose};
use pp_runtime::nalgebra;
use tests::oracle::Oracle;
use tests::random::Random;

use compiled::{Answer, Compiled};

/// Poses of each machine; one in eight has a set-up of its own.
const POSES: usize = 10_000;

/// Largest difference, as a share of the lengths of a set-up (plus 1 mm), and in rad.
const SHARE: f64 = 1e-12;

/// Compares a machine in random set-ups.
fn agrees<M: Machine>(seed: u64) {
    let random = &mut Random::new(seed);
    let mut complete = M::default();
    set_required(&mut complete, random);
    let compiled = Compiled::of(&complete);
    for _ in 0..8 {
        let set_up = (Vector3::from_fn(|_, _| random.between(-300.0, 300.0)), random.between(0.0, 300.0));
        let mut machine = M::default();
        machine.set_up(set_up.0, set_up.1);
        set_required(&mut machine, random);
        for (index, dimension) in M::DIMENSIONS.iter().enumerate() {
            let before = machine.dimension(index);
            let value = match dimension.kind {
                DimensionKind::Length => random.between(-300.0, 300.0),
                DimensionKind::Angle => before + random.between(-0.2, 0.2),
            };
            machine.set_dimension(index, value);
            if machine.validate().is_err() {
                machine.set_dimension(index, before);
            }
        }
        let oracle = Oracle::of(&machine);
        let machine: &dyn AnyMachine = &machine;
        let poses: Vec<_> = (0..POSES / 8).map(|number| pose(machine, number, random)).collect();
        let answers = compiled.answers(machine, set_up, &poses);
        assert_eq!(answers.len(), poses.len());
        for ((pose, held), answer) in poses.iter().zip(&answers) {
            if let Some(fault) = differs(machine, &oracle, pose, held, answer) {
                panic!("{}: {fault}\n{set_up:?}\npose {pose:?}\nheld {held:?}\nanswer {answer:?}", M::NAME);
            }
        }
    }
}

/// Gives random values to the dimensions without a declared one.
fn set_required<M: Machine>(machine: &mut M, random: &mut Random) {
    for (index, dimension) in M::DIMENSIONS.iter().enumerate().filter(|(_, dimension)| dimension.default.is_nan()) {
        machine.set_dimension(
            index,
            match dimension.kind {
                DimensionKind::Length => random.between(-300.0, 300.0),
                DimensionKind::Angle => random.between(-0.5, 0.5),
            },
        );
    }
}

/// A pose from axis values, and every eighth one from a random tool axis, which may be out of reach.
fn pose(machine: &dyn AnyMachine, number: usize, random: &mut Random) -> (Pose, AxisValues) {
    let mut values = [0.0; MAX_AXES];
    for (index, axis) in machine.axes().iter().enumerate() {
        values[index] = match axis.kind {
            AxisKind::Linear => random.between(-500.0, 500.0),
            AxisKind::Rotary => angle(random),
        };
    }
    let mut pose = machine.forward_kinematics(&values);
    match number % 8 {
        7 => pose.axis = Unit::new_unchecked(Vector3::from(random.direction())),
        // Exactly along an axis: at the pole, where that axis is the first rotary.
        1 => pose.axis = machine.joint(random.below(machine.axes().len())).direction,
        // Beside the pole and the rim, and just beyond the rim.
        3 | 5 => {
            let shift = Vector3::from(random.direction()) * 10.0_f64.powf(random.between(-16.0, -5.0));
            pose.axis = Unit::new_normalize(pose.axis.into_inner() + shift);
        }
        _ => {}
    }
    match number % 97 {
        0 => pose.tip = Point3::new(f64::NAN, 0.0, 0.0),
        1 => pose.axis = UnitVector3::new_unchecked(Vector3::new(f64::INFINITY, 0.0, 0.0)),
        2 => values[random.below(machine.axes().len())] = f64::NAN,
        3 => pose.axis = Unit::new_unchecked(pose.axis.into_inner() * 1.001),
        _ => {}
    }
    (pose, values)
}

/// An angle; often at or close to a quarter, half or whole turn.
fn angle(random: &mut Random) -> f64 {
    let round = FRAC_PI_2 * [-2.0, -1.0, 0.0, 1.0, 2.0][random.below(5)];
    match random.below(4) {
        0 => round,
        1 => round + random.sign() * 10.0_f64.powf(random.between(-13.0, -2.0)),
        _ => random.between(-PI, PI),
    }
}

/// The difference between the two, if it is too large.
fn differs(
    machine: &dyn AnyMachine,
    oracle: &Oracle,
    pose: &Pose,
    held: &AxisValues,
    answer: &Answer,
) -> Option<String> {
    let axes = machine.axes();
    // In Rust the type has it; in C it is refused.
    if pose.axis.norm() > 1.0005 {
        return (!answer.solutions.is_empty()).then(|| "a tool axis that is no unit vector has an answer".to_owned());
    }
    let lengths = lengths(machine, oracle, pose, held);
    let close = |index: usize, a: f64, b: f64| match axes[index].kind {
        AxisKind::Linear => (a - b).abs() <= SHARE * lengths,
        AxisKind::Rotary => (a - b).abs() <= SHARE,
    };
    let solutions = machine.inverse_kinematics(pose, held);
    if solutions.len() != answer.solutions.len() {
        return Some(format!("{} branches in Rust, {} in C", solutions.len(), answer.solutions.len()));
    }
    for (solution, of_c) in solutions.iter().zip(&answer.solutions) {
        if let Some(index) = (0..axes.len()).find(|index| !close(*index, solution.axes[*index], of_c[*index])) {
            return Some(format!(
                "axis {}: {} in Rust, {} in C",
                axes[index].letter, solution.axes[index], of_c[index]
            ));
        }
        let back = machine.forward_kinematics(&solution.axes);
        let (tip, axis) = answer.forward_of(of_c);
        let off = (back.tip.coords - tip).norm();
        if !(off <= SHARE * lengths && (back.axis.into_inner() - axis).norm() <= SHARE) {
            return Some(format!("forward kinematics differ by {off} mm"));
        }
    }
    let linear = machine.linear_axes(&pose.tip, held);
    match (linear, &answer.linear) {
        (None, None) => None,
        (Some(linear), Some(of_c)) => {
            let index = (0..axes.len()).find(|index| !close(*index, linear[*index], of_c[*index]))?;
            Some(format!("linear axis {}: {} in Rust, {} in C", axes[index].letter, linear[index], of_c[index]))
        }
        (linear, of_c) => Some(format!("linear axes: {linear:?} in Rust, {of_c:?} in C")),
    }
}

/// Sum of the lengths from which a solution is computed, mm. Nearly dependent linear axes enlarge every rounding.
fn lengths(machine: &dyn AnyMachine, oracle: &Oracle, pose: &Pose, held: &AxisValues) -> f64 {
    let finite = |value: f64| if value.is_finite() { value.abs() } else { 0.0 };
    let given: f64 = pose.tip.iter().chain(held).copied().map(finite).sum();
    let centres: f64 = (0..machine.axes().len()).map(|index| machine.joint(index).point.coords.norm()).sum();
    let determinant = oracle.determinant(&held[..machine.axes().len()]).abs();
    (1.0 + given + centres) / if determinant.is_finite() { determinant.clamp(1e-9, 1.0) } else { 1.0 }
}
