//! Heidenhain: the kinematics description, walked from the tool to the workpiece (technical manual iTNC 530 HSCI p.
//! 670, 722).

use pp_runtime::kinematics::Machine;
use pp_runtime::machine;
use pp_runtime::nalgebra::Vector3;
use pp_runtime::transformation::SheetControl::Heidenhain;

use super::chains::{
    HeadCa, HeadInXy, HeadTable, NutatingHead, NutatingTable, Quill, SingleHead, SingleTable, TableCb, TableInZx,
};
use super::printed::Printed;
use super::{Position, agrees, rotated, sheet};

fn unit(letter: char) -> Vector3<f64> {
    match letter {
        'X' | 'A' => Vector3::x(),
        'Y' | 'B' => Vector3::y(),
        _ => Vector3::z(),
    }
}

/// A step as a map from the coordinate system after it to the one before it.
#[derive(Debug)]
enum Step {
    Shift(Vector3<f64>),
    Rotate(Vector3<f64>, f64),
    Linear,
}

impl Step {
    fn apply(&self, vector: Vector3<f64>) -> Vector3<f64> {
        match self {
            Self::Shift(shift) => shift + vector,
            Self::Rotate(axis, angle) => rotated(axis, *angle, &vector),
            Self::Linear => vector,
        }
    }

    fn undo(&self, vector: Vector3<f64>) -> Vector3<f64> {
        match self {
            Self::Shift(shift) => vector - shift,
            Self::Rotate(axis, angle) => rotated(axis, -angle, &vector),
            Self::Linear => vector,
        }
    }
}

fn steps(printed: &Printed, position: &Position) -> Vec<Step> {
    let mut steps = Vec::new();
    for row in &printed.rows {
        let letter = || row.expected.chars().next().expect("an axis");
        match (row.number.as_str(), row.name.split(' ').collect::<Vec<_>>()[..].as_ref()) {
            ("Trans", ["shift", axis]) => {
                let length = if row.expected == "any" { 0.0 } else { row.value() };
                steps.push(Step::Shift(unit(axis.chars().next().expect("an axis")) * length));
            }
            ("Trans", ["rotation", axis]) => {
                steps.push(Step::Rotate(unit(axis.chars().next().expect("an axis")), row.value().to_radians()));
            }
            ("MachAxis", _) if "XYZ".contains(letter()) => steps.push(Step::Linear),
            // The coordinate system after an axis moves against its word: the tool moves along with it in a head, and a
            // table moves the opposite way.
            ("MachAxis", _) => steps.push(Step::Rotate(unit(letter()), -position.angle(letter()))),
            ("MachBase" | "ToolAxis", _) => {}
            other => panic!("{other:?}"),
        }
    }
    steps
}

/// Machine coordinates at which the tip is on the workpiece point. Linear axes are next to each other in these
/// machines.
fn model(printed: &Printed, position: &Position) -> Vector3<f64> {
    let steps = steps(printed, position);
    let first = steps.iter().position(|step| matches!(step, Step::Linear)).expect("linear axes");
    let last = steps.iter().rposition(|step| matches!(step, Step::Linear)).expect("linear axes");
    let (head, table) = (&steps[..first], &steps[last + 1..]);
    // With all axes at zero the last coordinate system is where the shifts lead, and the point is given from machine
    // zero.
    let sum = |steps: &[Step]| {
        let shifts = steps.iter().filter_map(|step| if let Step::Shift(shift) = step { Some(*shift) } else { None });
        shifts.sum::<Vector3<f64>>()
    };
    let workpiece = table.iter().rev().fold(position.point - sum(&steps), |point, step| step.apply(point));
    // The tip in the coordinate system after the head: below the tool reference point by the tool length.
    let tip = head.iter().fold(-position.length, |point, step| step.undo(point));
    workpiece - tip
}

fn agree<M: Machine>() {
    agrees::<M>(Heidenhain, model);
}

#[test]
fn tables_agree() {
    agree::<TableCb>();
    agree::<NutatingTable>();
    agree::<TableInZx>();
    agree::<machines::SpinnerU5620>();
    agree::<machines::Dmu70e>();
    agree::<SingleTable>();
    agree::<Quill>();
}

#[test]
fn heads_agree() {
    agree::<HeadCa>();
    agree::<NutatingHead>();
    agree::<HeadInXy>();
    agree::<machines::LolaXoyzba>();
    agree::<SingleHead>();
}

#[test]
fn a_head_with_a_table_agrees() {
    agree::<HeadTable>();
}

machine! {
    /// Technical manual iTNC 530 HSCI p. 670: the steps of a machine with B in the head and C in the table.
    pub struct Example;
    chain: C Z | X Y B;
    d = { C: (0, 0, 0), B: (0.016, 0, 250.051) };
}

/// The manual's steps: Trans X 0.016, Trans Z 250.051, MachAxis B, Y, X, MachBase, Z, Trans X -298.923, Trans Y
/// 200.172, MachAxis C.
#[test]
fn the_example_of_the_manual_has_its_steps() {
    // C is where the shifts lead: its machine coordinates are their sums.
    let zero = "machine_zero = { X = -298.907, Y = 200.172 }\npart_origin = [0, 0, 0]\n";
    let printed = Printed::read(&sheet::<Example>(Heidenhain, zero).expect("a sheet"));
    let steps: Vec<String> = printed
        .rows
        .iter()
        .filter(|row| row.number != "ToolAxis" && row.expected != "0.0000" && row.expected != "any")
        .map(|row| format!("{} {} {}", row.number, row.name, row.expected))
        .collect();
    assert_eq!(
        steps,
        [
            "Trans shift X 0.0160",
            "Trans shift Z 250.0510",
            "MachAxis axis B",
            "MachAxis axis Y",
            "MachAxis axis X",
            "MachBase  -",
            "MachAxis axis Z",
            "Trans shift X -298.9230",
            "Trans shift Y 200.1720",
            "MachAxis axis C"
        ]
    );
}

#[test]
fn shifts_of_a_table_and_rotations_are_marked() {
    let printed = Printed::read(&sheet::<NutatingTable>(Heidenhain, "").expect("a sheet"));
    let rows = printed.rows.iter().filter(|row| row.number == "Trans" || "ABC".contains(&row.expected));
    assert!(rows.clone().count() >= 10 && rows.clone().all(|row| row.unverified), "{:?}", printed.rows);
    let head = Printed::read(&sheet::<HeadCa>(Heidenhain, "").expect("a sheet"));
    assert!(head.rows.iter().filter(|row| row.number == "Trans").all(|row| !row.unverified));
}
