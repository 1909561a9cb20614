//! Machines against their chains written out by hand.

use approx::abs_diff_eq;
use nalgebra::Vector3;
use pp_runtime::kinematics::{AxisKind, DimensionKind, Machine, Pose, PoseTolerance};

use crate::random::Random;

/// A machine with random dimensions, part origin and gauge length.
#[must_use]
pub fn set_up<M: Machine>(random: &mut Random) -> (M, Vector3<f64>, f64) {
    let mut machine = M::default();
    for (index, dimension) in M::DIMENSIONS.iter().enumerate() {
        machine.set_dimension(
            index,
            match dimension.kind {
                DimensionKind::Length => random.between(-300.0, 300.0),
                DimensionKind::Angle => random.between(-0.7, 0.7),
            },
        );
    }
    let part_origin = Vector3::from_fn(|_, _| random.between(-200.0, 200.0));
    let gauge_length = random.between(0.0, 250.0);
    machine.set_up(part_origin, gauge_length);
    (machine, part_origin, gauge_length)
}

/// Random axis values, mm and rad.
pub fn axes<M: Machine>(random: &mut Random) -> M::Axes {
    let mut axes = M::Axes::default();
    for (value, axis) in axes.as_mut().iter_mut().zip(M::AXES) {
        *value = match axis.kind {
            AxisKind::Linear => random.between(-400.0, 400.0),
            AxisKind::Rotary => random.between(-7.0, 7.0),
        };
    }
    axes
}

/// Compares a machine with a chain written out by hand; input of `by_hand`: the machine for its dimensions, axes, part
/// origin, gauge length.
///
/// # Panics
/// If letters, tip or tool axis differ.
pub fn compare<M: Machine>(letters: &str, by_hand: impl Fn(&M, &M::Axes, &Vector3<f64>, f64) -> Pose) {
    assert_eq!(M::AXES.iter().map(|axis| axis.letter).collect::<String>(), letters);
    let random = &mut Random::new(2023);
    for _ in 0..1000 {
        let (machine, part_origin, gauge_length) = set_up::<M>(random);
        let axes = axes::<M>(random);
        let expected = by_hand(&machine, &axes, &part_origin, gauge_length);
        let pose = machine.forward_kinematics(&axes);
        let largest = PoseTolerance { tip_mm: 1e-9, axis_rad: 1e-13 };
        let same = abs_diff_eq!(expected, pose, epsilon = largest);
        assert!(same, "{} at {axes:?}: {pose:?} is not {expected:?}", M::NAME);
    }
}
