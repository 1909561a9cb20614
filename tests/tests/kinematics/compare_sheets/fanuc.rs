//! Fanuc: parameters of five-axis machining, in the model of A-79348E p. 72 to 84.

use pp_runtime::kinematics::Machine;
use pp_runtime::nalgebra::Vector3;
use pp_runtime::transformation::SheetControl::Fanuc;

use super::chains::{
    HeadAbReversed, HeadCa, HeadInXy, HeadTable, HeadTableInclined, Horizontal, NutatingHead, NutatingTable, Quill,
    TableAb, TableCaReversed, TableCb, TableInZx,
};
use super::printed::Printed;
use super::{Position, agrees, rotated, sheet};

/// Direction about which the body of an axis rotates right-handed for positive words: 19682 to 19684, or 19687
/// to 19689.
fn rotation(printed: &Printed, number: u32) -> Vector3<f64> {
    let [code, inclination, direction] = [0, 1, 2].map(|next| printed.value(&(number + next).to_string()));
    let (sine, cosine) = inclination.to_radians().sin_cos();
    let axis = match code as u32 {
        1 => Vector3::x(),
        2 => Vector3::y(),
        3 => Vector3::z(),
        4 => Vector3::new(cosine, sine, 0.0),
        5 => Vector3::new(0.0, cosine, sine),
        6 => Vector3::new(sine, 0.0, cosine),
        other => panic!("direction {other}"),
    };
    // 0: right-hand thread.
    if direction == 0.0 { axis } else { -axis }
}

fn point(printed: &Printed, first: u32) -> Vector3<f64> {
    printed.vector(|component| (first + component as u32).to_string())
}

/// `vector`, from a point on the axis, rotated about it.
fn about(centre: Vector3<f64>, axis: Vector3<f64>, angle: f64, vector: Vector3<f64>) -> Vector3<f64> {
    centre + rotated(&axis, angle, &(vector - centre))
}

fn letter(printed: &Printed, number: &str) -> char {
    printed.row(number).expected.chars().last().expect("an axis")
}

fn model(printed: &Printed, position: &Position) -> Vector3<f64> {
    let axes = [rotation(printed, 19682), rotation(printed, 19687)];
    let angles = ["19681", "19686"].map(|number| position.angle(letter(printed, number)));
    let tool = [Vector3::x(), Vector3::y(), Vector3::z()][printed.value("19697") as usize - 1];
    let with_holder = position.length + tool * printed.value("19666");
    // The gauge point with all axes at zero is above the tip by the tool length.
    let seen = |workpiece: Vector3<f64>, tip: Vector3<f64>| workpiece - tip;
    match printed.value("19680") as u32 {
        // The slave holds the workpiece, the master carries it.
        12 => {
            let (a, b) = (point(printed, 19700), point(printed, 19700) + point(printed, 19703));
            let slave = about(b, axes[1], angles[1], position.point);
            let master = about(a, axes[0], angles[0], slave);
            seen(master, -with_holder)
        }
        21 => {
            let workpiece = about(point(printed, 19700), axes[1], angles[1], position.point);
            let e = with_holder + point(printed, 19709);
            // The tip from the gauge line: E is at rest in the head.
            let gauge = position.length;
            seen(workpiece, about(e - gauge, axes[0], angles[0], -gauge))
        }
        2 => {
            let gauge = position.length;
            let e = with_holder + point(printed, 19709) - gauge;
            let f = e + point(printed, 19712);
            let slave = about(e, axes[1], angles[1], -gauge);
            seen(position.point, about(f, axes[0], angles[0], slave))
        }
        other => panic!("type {other}"),
    }
}

fn agree<M: Machine>() {
    agrees::<M>(Fanuc, model);
}

#[test]
fn tables_agree() {
    agree::<TableCb>();
    agree::<TableCaReversed>();
    agree::<TableAb>();
    agree::<NutatingTable>();
    agree::<TableInZx>();
    agree::<machines::SpinnerU5620>();
    agree::<machines::Dmu70e>();
    agree::<Horizontal>();
    agree::<Quill>();
}

#[test]
fn heads_agree() {
    agree::<HeadCa>();
    agree::<HeadAbReversed>();
    agree::<NutatingHead>();
    agree::<HeadInXy>();
    agree::<machines::LolaXoyzba>();
}

#[test]
fn a_head_with_a_table_agrees() {
    agree::<HeadTable>();
    agree::<HeadTableInclined>();
}

/// A-79348E p. 75: normally 0 for a rotary axis of the tool and 1 for one of the table.
#[test]
fn senses_of_iso_841_are_those_that_the_manual_calls_normal() {
    let senses = |text: String| {
        let printed = Printed::read(&text);
        ["19684", "19689"].map(|number| printed.row(number).expected.clone())
    };
    assert_eq!(senses(sheet::<TableCb>(Fanuc, "").expect("a sheet")), ["1", "1"]);
    assert_eq!(senses(sheet::<HeadCa>(Fanuc, "").expect("a sheet")), ["0", "0"]);
    assert_eq!(senses(sheet::<HeadTable>(Fanuc, "").expect("a sheet")), ["0", "1"]);
    assert_eq!(senses(sheet::<TableCaReversed>(Fanuc, "").expect("a sheet")), ["0", "0"]);
}

#[test]
fn master_and_slave_are_in_the_order_of_the_manual() {
    let order = |text: String| {
        let printed = Printed::read(&text);
        [letter(&printed, "19681"), letter(&printed, "19686")]
    };
    // The tilting table carries the rotary table; C of the fork head carries A.
    assert_eq!(order(sheet::<TableCb>(Fanuc, "").expect("a sheet")), ['B', 'C']);
    assert_eq!(order(sheet::<HeadCa>(Fanuc, "").expect("a sheet")), ['C', 'A']);
    assert_eq!(order(sheet::<HeadTable>(Fanuc, "").expect("a sheet")), ['B', 'C']);
}

#[test]
fn table_position_and_frame_need_their_keys() {
    let printed = Printed::read(&sheet::<TableCb>(Fanuc, "").expect("a sheet"));
    assert_eq!(printed.row("19702").expected, "needs machine_zero");
    assert_eq!(printed.row("19696#5").expected, "needs tcp_frame");
    assert_eq!(printed.row("19705").expected, "-150.0000");
    let frame = |name: &str| {
        let text = sheet::<TableCb>(Fanuc, &format!("tcp_frame = \"{name}\"\n")).expect("a sheet");
        Printed::read(&text).row("19696#5").expected.clone()
    };
    assert_eq!(["table_at_zero", "table_at_start", "not_turning"].map(frame), ["0", "0", "1"]);
}

#[test]
fn an_inclined_axis_is_stated_by_its_plane_and_angle() {
    let printed = Printed::read(&sheet::<machines::Dmu70e>(Fanuc, "").expect("a sheet"));
    let values = ["19682", "19683", "19684"].map(|number| printed.row(number).expected.as_str());
    // B of the DMU 70e is about (0, 1, -1): from Y towards Z by -45 degrees. The table itself rotates left-handed about
    // it.
    assert_eq!(values, ["5", "-45.0000", "1"]);
}
