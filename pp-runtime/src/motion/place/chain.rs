//! Consequences of the axis directions of a machine: poles, and whether its linear axes are perpendicular.

use nalgebra::{UnitVector3, Vector3};

use crate::kinematics::{AnyMachine, Axis, AxisKind, Joint, Rotary, Side};
use crate::tolerance::writer::PERPENDICULAR_AXES;

/// Reachable tool axes at which the angle of the first of two rotary axes is free: along its direction and against it.
pub(crate) fn poles(machine: &dyn AnyMachine, rotaries: &[Rotary]) -> Vec<UnitVector3<f64>> {
    let [first, _] = rotaries else { return Vec::new() };
    let mut direction = machine.joint(first.index).direction.into_inner();
    for index in (0..first.index).rev().filter(|&index| machine.axes()[index].kind == AxisKind::Rotary) {
        direction = rotated(&machine.joint(index), machine.held()[index], &direction);
    }
    let free =
        |axis: &UnitVector3<f64>| machine.rotary_axes(axis, &machine.held()).iter().any(|solution| solution.singular);
    [direction, -direction].map(UnitVector3::new_normalize).into_iter().filter(free).collect()
}

/// Positions of the solved rotary axes of one side, beginning at the workpiece.
pub(crate) fn rotaries(chain: &'static [Axis], side: Side) -> impl Iterator<Item = usize> {
    let wanted = move |axis: &Axis| axis.kind == AxisKind::Rotary && !axis.held && axis.side == side;
    chain.iter().enumerate().filter(move |(_, axis)| wanted(axis)).map(|(index, _)| index)
}

/// Tool axis in the machine frame with the solved axes at zero and the held axes at their values.
pub(crate) fn held_tool_axis(machine: &dyn AnyMachine) -> Vector3<f64> {
    let mut axis = machine.tool_axis().into_inner();
    for (index, described) in machine.axes().iter().enumerate().rev() {
        if described.kind == AxisKind::Rotary && described.held && described.side == Side::Tool {
            axis = rotated(&machine.joint(index), machine.held()[index], &axis);
        }
    }
    axis
}

fn rotated(joint: &Joint, angle_rad: f64, vector: &Vector3<f64>) -> Vector3<f64> {
    nalgebra::Rotation3::from_axis_angle(&joint.direction, joint.sign * angle_rad) * vector
}

/// Whether the solved linear axes are perpendicular to each other at any rotary angles.
pub(crate) fn orthogonal(machine: &dyn AnyMachine, axes: &[Axis]) -> bool {
    let solved = solved_linear(axes);
    let mut pairs = solved.iter().enumerate().flat_map(|(place, &a)| solved[place + 1..].iter().map(move |&b| (a, b)));
    pairs.all(|(a, b)| {
        let rotary = (a + 1..b).filter(|&index| axes[index].kind == AxisKind::Rotary);
        let between: Vec<(Joint, Option<f64>)> =
            rotary.map(|index| (machine.joint(index), axes[index].held.then(|| machine.held()[index]))).collect();
        stays_perpendicular(&machine.joint(a).direction, &between, &machine.joint(b).direction)
    })
}

/// Whether `a · R₁ ⋯ Rₙ b` is zero at any angles but those given. By the last angle θ the vector is
/// `p + u cos θ + w sin θ`, with the part `p` of `b` along the axis, the rest `u`, and `w` a quarter of a revolution
/// on: the product is zero at any θ if it is so for each of the three.
fn stays_perpendicular(a: &Vector3<f64>, between: &[(Joint, Option<f64>)], b: &Vector3<f64>) -> bool {
    let Some(((joint, held), before)) = between.split_last() else { return a.dot(b).abs() < PERPENDICULAR_AXES };
    let along = joint.direction.into_inner() * joint.direction.dot(b);
    match held {
        Some(angle_rad) => stays_perpendicular(a, before, &rotated(joint, *angle_rad, b)),
        None => [along, b - along, joint.direction.cross(b)].iter().all(|part| stays_perpendicular(a, before, part)),
    }
}

/// Whether the solved linear axes are X, Y, Z: no control applies F along U, V, W in a block that moves one of X, Y, Z.
pub(crate) fn xyz_only(axes: &[Axis]) -> bool {
    solved_linear(axes).iter().all(|&index| matches!(axes[index].letter, 'X' | 'Y' | 'Z'))
}

/// Positions of X, Y and Z in the chain, if these are the solved linear axes.
pub(crate) fn coordinates(axes: &[Axis]) -> Option<[usize; 3]> {
    let place = |letter: char| axes.iter().position(|axis| axis.letter == letter && !axis.held);
    Some([place('X')?, place('Y')?, place('Z')?])
}

fn solved_linear(axes: &[Axis]) -> Vec<usize> {
    (0..axes.len()).filter(|&index| axes[index].kind == AxisKind::Linear && !axes[index].held).collect()
}
