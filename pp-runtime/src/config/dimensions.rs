//! What each length of a machine measures, for the comments of a configuration: which centre line it moves, and which
//! way.

use nalgebra::Vector3;

use crate::kinematics::{AnyMachine, AxisKind, DimensionKind, Side};

/// Test value of a length, mm.
const LENGTH: f64 = 1.0;

/// Largest difference of a component from 0 or from the test value, mm.
const SAME: f64 = 1e-9;

/// A sentence for each length that moves centre lines along an axis of the machine frame, found by moving them: the
/// lengths are set to zero, and one after the other to 1 mm.
pub(super) fn meanings(machine: &dyn AnyMachine) -> String {
    let mut zero = machine.to_boxed();
    zero.set_up(Vector3::zeros(), 0.0);
    let lengths: Vec<usize> = (0..machine.dimensions().len())
        .filter(|&index| machine.dimensions()[index].kind == DimensionKind::Length)
        .collect();
    lengths.iter().for_each(|&index| zero.set_dimension(index, 0.0));
    let sentences = lengths.iter().filter_map(|&index| {
        let mut moved = zero.clone();
        moved.set_dimension(index, LENGTH);
        sentence(machine.dimensions()[index].name, &*zero, &*moved)
    });
    sentences.collect::<Vec<_>>().join(" ")
}

/// What a length does, if it moves centre lines of one side along one direction.
fn sentence(name: &str, zero: &dyn AnyMachine, moved: &dyn AnyMachine) -> Option<String> {
    let rotary = zero.axes().iter().enumerate().filter(|(_, axis)| axis.kind == AxisKind::Rotary);
    let steps = rotary.map(|(index, axis)| (axis, moved.joint(index).point - zero.joint(index).point));
    let moving: Vec<_> = steps.filter(|(_, step)| step.norm() > SAME).collect();
    let (first, step) = moving.first()?;
    let alike = moving.iter().all(|(axis, other)| axis.side == first.side && (other - step).norm() <= SAME);
    let (component, letter) = (0..3).zip(['X', 'Y', 'Z']).find(|&(index, _)| step[index].abs() > SAME)?;
    let straight = (step.norm() - step[component].abs()).abs() <= SAME && (step.norm() - LENGTH).abs() <= SAME;
    let [along, against] = if step[component] > 0.0 { ["+", "-"] } else { ["-", "+"] };
    let axes = moving.iter().map(|(axis, _)| axis.letter.to_string()).collect::<Vec<_>>().join(" and ");
    let from = match first.side {
        Side::Workpiece => "the reference point of the table",
        Side::Tool => "the gauge line of the spindle",
    };
    (alike && straight).then(|| {
        format!(
            "`{name}`: from {from} to the centre line of {axes} along {along}{letter}, with all axes at zero; below zero where \
             that lies towards {against}{letter}."
        )
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    crate::machine! {
        /// A cradle below the table face, measured downwards, and the offset of its centre line.
        struct Cradle;
        chain: C A | X Y Z;
        d = { A: (0, offset, -depth) };
        dims = { offset: required, depth: 25 mm };
    }

    #[test]
    fn a_length_is_told_with_its_direction() {
        assert_eq!(
            meanings(&Cradle::default()),
            "`offset`: from the reference point of the table to the centre line of A along +Y, with all axes at zero; below zero \
             where that lies towards -Y. `depth`: from the reference point of the table to the centre line of A along -Z, with \
             all axes at zero; below zero where that lies towards +Z."
        );
    }
}
