//! The machine data of TRAORI.

use nalgebra::Vector3;

use super::super::chain::RotaryAtZero;
use super::super::rows::{Expected, Group, Row, XYZ, direction, known_lengths};
use super::record::{DataRecord, JOINT_OFFSET, JOINT_OFFSET_PART, known};
use super::{IM9_POINTS, vector_meaning};

const VECTORS: &str = "IM9 12/2017 p. 572";
const TYPES: &str = "F2 06/2019 p. 148; IM9 12/2017 p. 572";
const INPUTS: &str = "F2 06/2019 p. 148";
const BASE: &str = "Job planning 06/2009 p. 361";
const LIST: &str = "names: machine data list 12/2019";

/// Types of MD24100 with axes along the coordinates: kind of the record, coordinates of the fourth and the fifth axis.
const PARALLEL_TYPES: [(char, &str, u32); 12] = [
    ('T', "XY", 16),
    ('T', "YX", 18),
    ('T', "ZX", 20),
    ('T', "ZY", 21),
    ('P', "XY", 32),
    ('P', "XZ", 33),
    ('P', "YX", 34),
    ('P', "YZ", 35),
    ('M', "XY", 48),
    ('M', "XZ", 49),
    ('M', "YX", 50),
    ('M', "YZ", 51),
];

/// Type of MD24100 whose axes are parallel to the coordinates.
fn parallel_type(record: &DataRecord, first: &RotaryAtZero, second: Option<&RotaryAtZero>) -> Option<u32> {
    let pair: String = [first.coordinate()?, second?.coordinate()?].map(|index| XYZ[index]).iter().collect();
    let found = PARALLEL_TYPES.iter().find(|(kind, order, _)| *kind == record.kind && *order == pair);
    found.map(|(_, _, number)| *number)
}

fn array(number: u32) -> impl Fn(usize) -> String {
    move |index| format!("MD{number}[{index}]")
}

/// The groups of the machine data.
pub(super) fn transformation(
    record: &DataRecord,
    first: &RotaryAtZero,
    second: Option<&RotaryAtZero>,
    tool: usize,
) -> Vec<Group> {
    let generic = record.generic;
    let mut kinds = format!(
        "Type of the transformation: {generic}, generic, with the vectors below; or 72, which takes them from the swivel data \
         record of number MD24582 (TRAFO5_TCARR_NO_1)"
    );
    match parallel_type(record, first, second) {
        Some(number) => kinds.push_str(&format!(
            "; or {number}, for axes parallel to the coordinates without vectors: there tests 1 and 2 settle the directions (MD24520)."
        )),
        None => kinds.push_str(". No type with axes parallel to the coordinates (16 to 51) has these axes."),
    }
    let mut kind = Group::new(kinds, TYPES, vec![Row::code("MD24100", "TRAFO_TYPE_1", generic)]);
    if record.single() {
        kind = kind.unverified(format!(
            "that type {generic} takes a machine with one rotary axis is stated in Siemens' catalogue only, without its machine data. \
             Test 2 settles it."
        ));
    }
    let mut groups = vec![kind];
    let mut inputs = vec![];
    for (index, name) in ["X", "Y", "Z"].into_iter().map(str::to_owned).enumerate() {
        inputs.push(Row::code(array(24110)(index), "TRAFO_AXES_IN_1", format!("number of {name}")));
    }
    for (index, axis) in [Some(first), second].into_iter().flatten().enumerate() {
        inputs.push(Row::code(array(24110)(3 + index), "TRAFO_AXES_IN_1", format!("number of {}", axis.letter)));
    }
    groups.push(Group::new(
        "Channel axes that enter the transformation: the numbers of these axes in the channel, in this order.",
        INPUTS,
        inputs,
    ));
    for (index, axis) in [Some(first), second].into_iter().enumerate() {
        let (number, name) = [(24570, "TRAFO5_AXIS1_1"), (24572, "TRAFO5_AXIS2_1")][index];
        groups.push(Group::new(
            vector_meaning(index, axis),
            VECTORS,
            direction(name, array(number), &record.axes[index]),
        ));
    }
    for (index, offset) in record.offsets.iter().enumerate() {
        let Some((number, name)) = record.machine_data[index] else { continue };
        let mut group = Group::new(
            format!("I{}, {}.", index + 1, record.meanings[index]),
            IM9_POINTS,
            known_lengths(name, array(number), offset),
        );
        if record.kind == 'P' && (number, name) == JOINT_OFFSET {
            let (number, name) = JOINT_OFFSET_PART;
            group.rows.extend(known_lengths(name, array(number), &known(&Vector3::zeros())));
            group = group.unverified(JOINT_OFFSET_DOUBT);
        }
        groups.push(group);
    }
    let both = |number: u32, name: &str, expected: fn() -> Expected| {
        [0, 1].map(|index| Row::new(array(number)(index), name, expected())).into()
    };
    groups.push(
        Group::new(
            "Angles of the rotary axes in the initial setting.",
            LIST,
            both(24510, "TRAFO5_ROT_AX_OFFSET_1", || Expected::Degrees(0.0)),
        )
        .unverified("no public page with its description was found. Test 2 settles it."),
    );
    groups.push(
        Group::new(
            "Signs of the rotary axes: 1, not reversed.",
            LIST,
            both(24520, "TRAFO5_ROT_SIGN_IS_PLUS_1", || Expected::Code("1".to_owned())),
        )
        .unverified(
            "no public page with its description was found; by its name a vector that is reversed, with 0 here, is the same machine. \
             Tests 1 and 2 settle it.",
        ),
    );
    let mut base = Vector3::zeros();
    base[tool] = 1.0;
    groups.push(
        Group::new(
            "Basic orientation of the tool, from the tip to the spindle. TRAORI(1,x,y,z) programs the same.",
            BASE,
            direction("TRAFO5_BASE_ORIENT_1", array(24574), &base),
        )
        .unverified("number and name of the machine data are from general knowledge. Test 2 settles it."),
    );
    groups
}

const JOINT_OFFSET_DOUBT: &str = "IM9 12/2017 p. 572 prints number 24558 with the name TRAFO5_JOINT_OFFSET_1, which is that of \
                                  MD24560; by the machine data list MD24558 is for mixed kinematics only. If I3 is not zero, test 2 \
                                  with the second rotary axis settles which one the control reads; the other is 0. Type 72 avoids \
                                  the question.";
