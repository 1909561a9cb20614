//! Worked examples of the Siemens manuals: their numbers, the sheet of the same machine, and the machine's own
//! matrices.

use approx::{abs_diff_eq, assert_abs_diff_eq};
use pp_runtime::kinematics::Machine;
use pp_runtime::machine;
use pp_runtime::nalgebra::{Point3, Vector3};
use pp_runtime::transformation::SheetControl::Siemens;
use tests::oracle::Oracle;

use super::printed::Printed;
use super::sheet;
use super::siemens::Carrier;

machine! {
    /// W1 08/2005 p. 4-3: type P, A first, B second, `l4 = (0, 0, 15)`, the other offsets zero. The chain is not
    /// closed: the centre lines are 15 mm below the table, which a closed chain has in `l2`.
    pub struct TableOfW1;
    chain: B A | X Y Z;
    d = (0, 0, -15);
    signs = { A: -, B: - };
}

/// "The rotation of the fourth offset vector about the B axis" by 45° shifts the zero point by X 10.607 and Z -4.393;
/// with the tool of 13 mm, X10.607 Y10 Z8.607 is approached for Y10.
#[test]
fn the_table_of_w1_shifts_its_zero_point_as_printed() {
    let keys = "units = \"mm\"\npart_origin = [0, 0, 0]\nmachine_zero = { X = 0, Y = 0, Z = 0 }\n";
    let record = Carrier::of_record(&Printed::read(&sheet::<TableOfW1>(Siemens, keys).expect("a sheet")));
    assert_eq!(record.kind, 'P');
    assert_eq!(record.v, [Vector3::x(), Vector3::y()]);
    assert_eq!(record.l[2..], [Vector3::zeros(), Vector3::new(0.0, 0.0, 15.0)]);
    let (b, tool) = (45_f64.to_radians(), Vector3::new(0.0, 0.0, 13.0));
    let thousandths = |vector: Vector3<f64>| vector.map(|value| (value * 1000.0).round() / 1000.0);
    let shifted = record.workpiece([0.0, b], &Vector3::zeros());
    assert_eq!(thousandths(shifted), Vector3::new(10.607, 0.0, -4.393));
    // The coordinate system is shifted, not rotated: Y10 is 10 mm along Y of the machine.
    let printed = shifted + Vector3::new(0.0, 10.0, 0.0) + tool;
    assert_eq!(thousandths(printed), Vector3::new(10.607, 10.0, 8.607));
    // The machine itself, with the part zero under the tool.
    let mut machine = TableOfW1::default();
    machine.set_up(Vector3::zeros(), 13.0);
    let mut values = [b, 0.0, 0.0, 0.0, 0.0];
    Oracle::of(&machine).bring_tip_to(&Point3::new(0.0, 10.0, 0.0), &mut values);
    assert_eq!(thousandths(Vector3::new(values[2], values[3], values[4]) + tool), Vector3::new(10.607, 10.0, 8.607));
}

machine! {
    /// W1 08/2005 p. 2-92: a head with `v1 = (1, 0, 0)`, `v2 = (-1, 0, 1)`, `l2 = 0` and `l3 = (-100, 0, 0)`.
    pub struct HeadOfW1;
    chain: | X Y Z A C;
    axes = { C: (-1, 0, 1) };
    d = { A: (-100, 0, 0), C: (-100, 0, 0) };
}

machine! {
    /// IM9 12/2017 p. 581, HEAD_2: `V1 = (0, 1, 0)`, `I2 = (0, 172, 172)`, `V2 = (0, 1, 1)`, `I3 = (0, 0, 93.8)`. The
    /// footnote of the table has `V2Y = sin(-45)`, which contradicts it: with (0, 1, 1) both centre lines meet, at (0,
    /// 172, 265.8).
    pub struct Head2;
    chain: | X Y Z B C;
    axes = { C: (0, 1, 1) };
    d = { B: (0, 172, 265.8), C: (0, 0, 93.8) };
}

/// Numbers of a head in a manual.
struct Printout {
    l: [Vector3<f64>; 3],
    v: [Vector3<f64>; 2],
}

/// The sheet has the numbers of the manual, and these move the tip as the matrices of the declaration do.
fn head_agrees<M: Machine>(manual: &Printout) {
    let record = Carrier::of_record(&Printed::read(&sheet::<M>(Siemens, "").expect("a sheet")));
    assert_eq!(record.kind, 'T');
    for index in [1, 2] {
        assert_abs_diff_eq!(record.l[index], manual.l[index], epsilon = 5e-10);
    }
    for (sheet, manual) in record.v.iter().zip(manual.v) {
        assert_abs_diff_eq!(*sheet, manual.normalize(), epsilon = 5e-7);
    }
    // A closed chain.
    assert_abs_diff_eq!(record.l[0] + record.l[1] + record.l[2], Vector3::zeros(), epsilon = 5e-10);
    let [l1, l2, l3] = manual.l;
    let example = Carrier { kind: 'T', l: [l1, l2, l3, Vector3::zeros()], v: manual.v };
    let mut machine = M::default();
    machine.set_up(Vector3::zeros(), 250.0);
    let oracle = Oracle::of(&machine);
    let length = Vector3::new(0.0, 0.0, 250.0);
    for number in 0..100 {
        let angles = [0.37 * f64::from(number), -0.23 * f64::from(number)];
        // The chain of the example need not be closed: only the motion of the tip is compared.
        let moved = example.tool([0.0; 2], &length) - example.tool(angles, &length);
        let tip = oracle.forward(&[0.0, 0.0, 0.0, angles[0], angles[1]]).tip;
        assert!(abs_diff_eq!(moved, tip.coords, epsilon = 5e-10), "{}: {moved:?} is not {tip:?}", M::NAME);
    }
}

#[test]
fn the_head_of_w1_is_read_back() {
    head_agrees::<HeadOfW1>(&Printout {
        l: [Vector3::new(-200.0, 0.0, 0.0), Vector3::zeros(), Vector3::new(-100.0, 0.0, 0.0)],
        v: [Vector3::new(1.0, 0.0, 0.0), Vector3::new(-1.0, 0.0, 1.0)],
    });
}

#[test]
fn head_2_of_im9_is_read_back() {
    head_agrees::<Head2>(&Printout {
        l: [Vector3::new(0.0, -172.0, -265.8), Vector3::new(0.0, 172.0, 172.0), Vector3::new(0.0, 0.0, 93.8)],
        v: [Vector3::new(0.0, 1.0, 0.0), Vector3::new(0.0, 1.0, 1.0)],
    });
}

machine! {
    /// IM9 12/2017 p. 586 (and SINUMERIK 828D 10/2015 p. 157): A and C in the table, C rotates about Z; `I2` from the
    /// reference point of the machine to A, `I3` from A to C, `I4 = -(I2 + I3)`. The page has no numbers.
    pub struct TableOfIm9;
    chain: C A | X Y Z;
    d = { C: (0, 0, 0), A: (0, -12.5, 55) };
}

#[test]
fn the_a_c_table_of_im9_has_its_points() {
    let keys = "units = \"mm\"\npart_origin = [0, 0, 0]\nmachine_zero = { X = 400.25, Y = 300.5, Z = -620 }\n";
    let printed = Printed::read(&sheet::<TableOfIm9>(Siemens, keys).expect("a sheet"));
    let record = Carrier::of_record(&printed);
    let centre_of_a = Vector3::new(400.25, 288.0, -565.0);
    let from_a_to_c = Vector3::new(0.0, 12.5, -55.0);
    assert_eq!(record.l, [Vector3::zeros(), centre_of_a, from_a_to_c, -(centre_of_a + from_a_to_c)]);
    // Both axes move the workpiece: their vectors are reversed (IM9 12/2017, section 21.7.2).
    assert_eq!(record.v, [-Vector3::x(), -Vector3::z()]);
    assert_eq!(
        (printed.row("$TC_CARR21[m]").expected.as_str(), printed.row("$TC_CARR22[m]").expected.as_str()),
        ("A", "C")
    );
}
