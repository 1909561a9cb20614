//! The swivel data record `$TC_CARR`.

use super::super::chain::RotaryAtZero;
use super::super::rows::{Expected, Group, Row, XYZ, direction, known_lengths};
use super::record::DataRecord;
use super::{IM9_POINTS, vector_meaning};

const SIGNS: &str = "W1 p. 2-92; IM9 12/2017 p. 572, 581";
const VARIABLES: &str = "NC programming 12/2019 p. 779";
const KIND: &str = "W1 p. 2-89; NC programming 12/2019 p. 779";

/// Numbers of the first component of I1 to I4 in `$TC_CARR`.
const OFFSETS: [usize; 4] = [1, 4, 15, 18];
/// Numbers of the first component of V1 and V2.
const AXES: [usize; 2] = [7, 10];

fn carr(first: usize) -> impl Fn(usize) -> String {
    move |component| format!("$TC_CARR{}[m]", first + component)
}

/// The groups of the record.
pub(super) fn carrier(
    record: &DataRecord,
    first: &RotaryAtZero,
    second: Option<&RotaryAtZero>,
    tool: usize,
) -> Vec<Group> {
    let kind = match record.kind {
        'T' => "T: the tool is rotated",
        'P' => "P: the workpiece is rotated",
        _ => "M: tool and workpiece are rotated",
    };
    let plane = ["G19", "G18", "G17"][tool];
    let mut groups = vec![Group::new(
        format!("Kinematic type, {kind}. Tool axis with all axes at zero: {}, so the plane is {plane}.", XYZ[tool]),
        KIND,
        vec![Row::code("$TC_CARR23[m]", "kinematic type", record.kind)],
    )];
    let names = [Some(first), second];
    let axis = |index: usize| names[index].map_or("0".to_owned(), |axis| axis.letter.to_string());
    groups.push(Group::new(
        "Rotary axes by name: their positions are the angles of the record.",
        VARIABLES,
        vec![
            Row::code("$TC_CARR21[m]", "first rotary axis", axis(0)),
            Row::code("$TC_CARR22[m]", "second rotary axis", axis(1)),
        ],
    ));
    for index in [0, 1] {
        groups.push(Group::new(vector_meaning(index, names[index]), SIGNS, {
            direction(&format!("axis vector V{}", index + 1), carr(AXES[index]), &record.axes[index])
        }));
    }
    for (index, meaning) in record.meanings.iter().enumerate() {
        groups.push(Group::new(format!("I{}: {meaning}.", index + 1), IM9_POINTS, {
            known_lengths(&format!("offset vector I{}", index + 1), carr(OFFSETS[index]), &record.offsets[index])
        }));
    }
    groups.push(Group::new(
        "Angle of the rotary axes in their initial setting: the words of the program count from the same zero.",
        VARIABLES,
        vec![
            Row::new("$TC_CARR24[m]", "offset of the first rotary axis", Expected::Degrees(0.0)),
            Row::new("$TC_CARR25[m]", "offset of the second rotary axis", Expected::Degrees(0.0)),
        ],
    ));
    groups
}
