//! Consequences of the axis directions of a machine: poles, and whether its linear axes are perpendicular.

use nalgebra::{UnitVector3, Vector3};

use crate::kinematics::{AnyMachine, Axis, AxisKind, Joint, Rotary, Side};
use crate::motion::tolerances::PERPENDICULAR_AXES;

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

/// Whether the solved linear axes are perpendicular to each other at any rotary angles: no rotary axis is between them.
pub(crate) fn orthogonal(machine: &dyn AnyMachine, axes: &[Axis]) -> bool {
    let solved = solved_linear(axes);
    let perpendicular = solved.iter().enumerate().all(|(position, &a)| {
        solved[position + 1..]
            .iter()
            .all(|&b| machine.joint(a).direction.dot(&machine.joint(b).direction).abs() < PERPENDICULAR_AXES)
    });
    let (Some(&first), Some(&last)) = (solved.first(), solved.last()) else { return false };
    perpendicular && axes[first..=last].iter().all(|axis| axis.kind == AxisKind::Linear)
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
