//! Heidenhain: the kinematics description of the machine builder, which M128, TCPM and PLANE use.
//!
//! The description of the iTNC 530 is a table of steps from the tool reference point to the workpiece: `Trans` shifts
//! or rotates the coordinate system, `MachAxis` is the place of an axis, `MachBase` that of the bed.
//!
//! Sources: Technical Manual iTNC 530 HSCI, 07/2013: p. 722 (the keys, the start at the tool reference point), p. 670
//! (example of a machine with B in the head and C in the table: `Trans X 0.016`, `Trans Z 250.051`, `MachAxis B`, Y, X,
//! `MachBase`, Z, `Trans X -298.923`, `Trans Y 200.172`, `MachAxis C`). The sign of a shift is read from that example:
//! the centre line of a head is above the tool reference point, and its Z is positive, so a shift is the vector from
//! the step before to the centre line. Technical Manual MANUALplus 620, 01/2012, p. 749: an axis that counts the other
//! way needs a coordinate system that is rotated. That is all that is public: signs of rotations and of shifts of a
//! table are marked unverified.

use nalgebra::Vector3;

use crate::config::Config;
use crate::kinematics::{AnyMachine, Axis, AxisKind, Joint, Side, Sign};

use super::super::NotExpressible;
use super::chain::{coordinate, held_axes_are_zero, linear_axes_are_coordinates, machine_coordinates, tool_coordinate};
use super::rows::{Expected, Group, ParameterSection, Row, Sheet, XYZ, known};
use super::tests_at_machine::{ControlWords, tests};

const MODEL: &str = "the kinematics description of the TNC";
const STEPS: &str = "TM iTNC 530 p. 670, 722";

/// A step of the description.
struct DescriptionStep<'a> {
    axis: &'a Axis,
    joint: Joint,
}

/// The sheet.
pub(super) fn sheet(machine: &dyn AnyMachine, config: &Config) -> Result<Sheet, NotExpressible> {
    held_axes_are_zero(machine)?;
    linear_axes_are_coordinates(machine, MODEL)?;
    let tool = tool_coordinate(machine, MODEL)?;
    let solved = machine.axes().iter().enumerate().filter(|(_, axis)| !axis.held);
    // From the tool to the workpiece.
    let steps: Vec<DescriptionStep<'_>> =
        solved.rev().map(|(index, axis)| DescriptionStep { axis, joint: machine.joint(index) }).collect();
    if steps.iter().all(|step| step.axis.kind == AxisKind::Linear) {
        return Err(NotExpressible(format!(
            "{} has no rotary axis that is solved for: there is nothing to compare with {MODEL}",
            machine.name()
        )));
    }
    Ok(Sheet {
        control: "Heidenhain iTNC 530 (and TNC 620, 640, TNC7)",
        introduction: vec![
            "The kinematics belong to the machine builder: ask for the description that is active. On the iTNC 530 it is a table with \
             the columns KEY, AXIS and COORD, which begins at the tool reference point (gauge line) and ends at the workpiece. On the \
             TNC 620, TNC 640 and TNC7 the same steps are in the machine configuration, behind the builder's code number; the order of \
             the steps, the centre lines and the signs can be compared there as well."
                .to_owned(),
            "Rows of the description between these that shift by zero, describe bodies for collision monitoring, or name the tool axis \
             do not matter. Shifts that follow each other may be added."
                .to_owned(),
        ],
        sections: vec![ParameterSection {
            title: "Kinematics description, from the tool to the workpiece".to_owned(),
            groups: groups(config, &steps, tool)?,
        }],
        differences: vec![
            "A point may be anywhere on its centre line: a difference of a shift along the axis before it or after it, with the \
             opposite one on the other side of that axis, is the same machine. Linear axes next to each other may change places."
                .to_owned(),
            "A shift with KinematicsOpt corrections differs by hundredths of a millimetre: then put the corrected numbers into the \
             dimensions of the declaration, because the post must have the numbers of the control."
                .to_owned(),
            "Any other difference: measure the centre lines again (KinematicsOpt, cycles 451 and 452), or correct the dimensions and \
             `d` of the declaration."
                .to_owned(),
        ],
        tests: tests(machine, &ControlWords { control: "heidenhain", tip_control: "M128 or FUNCTION TCPM", plane: "PLANE SPATIAL" }),
        sources: vec![
            "TM iTNC 530: Technical Manual iTNC 530 HSCI, 07/2013",
            "TM MANUALplus: Technical Manual MANUALplus 620, 01/2012, p. 749",
        ],
    })
}

/// Steps and shifts between them. Their numbers count the rows of this sheet.
fn groups(config: &Config, steps: &[DescriptionStep<'_>], tool: usize) -> Result<Vec<Group>, NotExpressible> {
    let mut groups = vec![Group::new(
        format!("Tool axis: {}.", XYZ[tool]),
        "TM iTNC 530 p. 722",
        vec![Row::code("ToolAxis", "axis", XYZ[tool])],
    )];
    let mut place: [Option<f64>; 3] = [Some(0.0); 3];
    let mut base = false;
    for step in steps {
        let letter = step.axis.letter;
        if step.axis.side == Side::Workpiece && !base {
            groups.push(bed());
            base = true;
        }
        if step.axis.kind == AxisKind::Linear {
            groups.push(Group::new(
                format!("{letter} moves everything after it."),
                STEPS,
                vec![Row::code("MachAxis", "axis", letter)],
            ));
            continue;
        }
        if step.axis.sign == Sign::Minus {
            return Err(NotExpressible(format!(
                "{letter} counts against ISO 841 (`signs = {{ {letter}: - }}`): {MODEL} then needs a coordinate system that is rotated \
                 (Technical Manual MANUALplus 620, p. 749), and no public manual settles how. Test at the machine: with M128 active \
                 the tip must stay on a fixed point while {letter} rotates"
            )));
        }
        let centre = match step.axis.side {
            Side::Workpiece => machine_coordinates(config, &step.joint.point.coords),
            Side::Tool => [0, 1, 2].map(|component| Some(step.joint.point[component])),
        };
        groups.push(shift(step, &place, &centre));
        place = centre;
        groups.extend(axis(step)?);
    }
    if !base {
        groups.push(bed());
    }
    Ok(groups)
}

fn bed() -> Group {
    Group::new("The bed of the machine.", STEPS, vec![Row::code("MachBase", "", "-")])
}

/// The shift to a centre line.
fn shift(step: &DescriptionStep<'_>, from: &[Option<f64>; 3], to: &[Option<f64>; 3]) -> Group {
    let letter = step.axis.letter;
    let along = coordinate(&step.joint.direction);
    let rows = (0..3)
        .map(|component| {
            let length = to[component].zip(from[component]).map(|(to, from)| to - from);
            // The centre line of an axis along a coordinate has no place on it.
            let free = along == Some(component) && length.is_none();
            let expected = if free { Expected::Any } else { known(length) };
            Row::new("Trans", format!("shift {}", XYZ[component]), expected)
        })
        .collect();
    let group = match step.axis.side {
        Side::Tool => Group::new(format!("To the centre line of {letter}, from the step before."), STEPS, rows),
        Side::Workpiece => Group::new(
            format!("To the centre line of {letter}, from the step before, with the linear axes at machine zero."),
            STEPS,
            rows,
        ),
    };
    match step.axis.side {
        Side::Tool => group,
        Side::Workpiece => group.unverified(
            "the example of the manual does not settle the sign of the shift to a table. Test 2 settles it: with the opposite sign \
             the tip leaves by far.",
        ),
    }
}

/// The axis itself, between two rotations of the coordinate system if it is inclined.
fn axis(step: &DescriptionStep<'_>) -> Result<Vec<Group>, NotExpressible> {
    let letter = step.axis.letter;
    let direction = step.joint.direction.into_inner();
    let machine_axis = Group::new(
        format!("{letter} rotates everything after it; positive as in ISO 841."),
        STEPS,
        vec![Row::code("MachAxis", "axis", letter)],
    )
    .unverified(format!("the direction of {letter} is not in the table. Test 1 settles it."));
    let own = match letter {
        'A' => 0,
        'B' => 1,
        _ => 2,
    };
    let Some((about, degrees)) = inclination(&direction, own) else {
        return Err(NotExpressible(format!(
            "{letter} is not in a plane of {} and another coordinate: {MODEL} needs two rotations for it, and no public manual settles \
             their order",
            XYZ[own]
        )));
    };
    if degrees == 0.0 {
        return Ok(vec![machine_axis]);
    }
    let rotation = |degrees: f64, meaning: &str| {
        let name = ['A', 'B', 'C'][about];
        Group::new(
            meaning.to_owned(),
            "TM iTNC 530 p. 722",
            vec![Row::new("Trans", format!("rotation {name}"), Expected::Degrees(degrees))],
        )
        .unverified("the sign of a rotation is in no public manual. Tests 1 and 2 settle it.")
    };
    Ok(vec![
        rotation(
            degrees,
            &format!(
                "{letter} is inclined: the coordinate system is rotated so that its {} is along {letter}.",
                XYZ[own]
            ),
        ),
        machine_axis,
        rotation(-degrees, "The coordinate system is rotated back."),
    ])
}

/// Coordinate and angle of the rotation that brings the coordinate `own` to a direction; `None` if it takes more than
/// one.
fn inclination(direction: &Vector3<f64>, own: usize) -> Option<(usize, f64)> {
    let (next, last) = ((own + 1) % 3, (own + 2) % 3);
    let small = |component: usize| direction[component].abs() < 1e-12;
    match (small(next), small(last)) {
        // Towards the next coordinate: about the one after it.
        (_, true) => Some((last, direction[next].atan2(direction[own]).to_degrees())),
        // Towards the last coordinate: about the next one, the other way round.
        (true, false) => Some((next, (-direction[last]).atan2(direction[own]).to_degrees())),
        (false, false) => None,
    }
}
