//! Chains that the model of a control cannot express.

use pp_runtime::machine;
use pp_runtime::transformation::SheetControl::{self, Fanuc, Haas, Heidenhain, LinuxCnc, Siemens};

use super::chains::{HeadCa, HeadTable, SingleTable, TableCaReversed};
use super::refusal;

machine! {
    /// X is on the tilting table.
    pub struct SlideOnTable;
    chain: C X B | Y Z;
    d = { C: (0, 0, 0), B: (5, 6, 70) };
}

machine! {
    /// Z moves along the tilted spindle.
    pub struct QuillInHead;
    chain: C | X Y B Z;
    d = { C: (0, 0, 0), B: (0, 0, 100) };
}

machine! {
    /// Y is inclined.
    pub struct Slanted;
    chain: C B | X Y Z;
    axes = { Y: (0, 1, -0.5) };
}

machine! {
    /// A head that is set by hand.
    pub struct SetByHand;
    chain: C B | X Y Z A;
    d = { C: (0, 0, 0), B: (0, 7, 30), A: (0, 0, 90) };
    hold = { A: 15 };
}

machine! {
    /// No rotary axis.
    pub struct ThreeAxes;
    chain: X Y | Z;
}

machine! {
    /// W in place of Z.
    pub struct WithoutZ;
    chain: C B | X Y W;
}

machine! {
    /// A tool that leans at zero.
    pub struct LeaningTool;
    chain: C B | X Y Z;
    tool_axis = (0.6, 0, 0.8);
}

machine! {
    /// An axis that is in no plane of the coordinates.
    pub struct Oblique;
    chain: C B | X Y Z;
    axes = { B: (2, -6, 3) };
}

const ALL: [SheetControl; 5] = [Siemens, Fanuc, Heidenhain, Haas, LinuxCnc];

#[test]
fn a_linear_axis_on_a_rotary_axis() {
    for control in [Siemens, Fanuc, Haas] {
        let reason = refusal::<SlideOnTable>(control);
        assert!(reason.starts_with("B carries X: X rotates with B, and "), "{reason}");
        assert!(reason.ends_with(" X, Y and Z must be next to the bed"), "{reason}");
        assert!(refusal::<QuillInHead>(control).starts_with("B carries Z: Z rotates with B"));
    }
}

#[test]
fn linear_axes_that_are_no_right_handed_system() {
    for control in ALL {
        let reason = refusal::<machines::MultiProDesk>(control);
        assert!(reason.starts_with("Y counts against ISO 841 (`signs = { Y: - }`)"), "{reason}");
        assert!(reason.contains("Reverse the direction of Y in the control, declare it `+`"), "{reason}");
        assert!(refusal::<Slanted>(control).starts_with("Y is not parallel to its coordinate"));
        assert!(refusal::<WithoutZ>(control).contains("WithoutZ has no Z that is solved for"));
    }
}

#[test]
fn held_axes_away_from_zero() {
    for control in ALL {
        let reason = refusal::<SetByHand>(control);
        assert!(reason.starts_with("A is held away from zero"), "{reason}");
        assert!(reason.contains("declare `hold = { A: 0 }`"), "{reason}");
    }
}

#[test]
fn no_rotary_axis() {
    for control in ALL {
        assert!(refusal::<ThreeAxes>(control).starts_with("ThreeAxes has no rotary axis that is solved for"));
    }
}

#[test]
fn a_tool_along_no_coordinate() {
    for control in ALL {
        let reason = refusal::<LeaningTool>(control);
        assert!(reason.contains("the tool of LeaningTool does not point along X, Y or Z"), "{reason}");
    }
}

#[test]
fn what_one_control_alone_cannot_express() {
    let reason = refusal::<SingleTable>(Fanuc);
    assert!(
        reason.starts_with("types 2, 12 and 21 of parameter 19680 have two rotary axes, SingleTable has one"),
        "{reason}"
    );
    assert!(reason.contains("Test at the machine: with G43.4 active"), "{reason}");
    let reason = refusal::<Oblique>(Fanuc);
    assert!(reason.starts_with("B has components along X, Y and Z"), "{reason}");
    let reason = refusal::<Oblique>(Heidenhain);
    assert!(reason.starts_with("B is not in a plane of Y and another coordinate"), "{reason}");
    let reason = refusal::<TableCaReversed>(Heidenhain);
    assert!(reason.starts_with("A counts against ISO 841 (`signs = { A: - }`)"), "{reason}");
    assert!(reason.contains("Test at the machine: with M128 active"), "{reason}");
    for reason in [refusal::<HeadCa>(Haas), refusal::<HeadTable>(Haas), refusal::<machines::Dmu70e>(Haas)] {
        assert!(reason.contains("knows a tilting rotary table as on the UMC only"), "{reason}");
        assert!(reason.contains("Test at the machine: with G234 active"), "{reason}");
    }
}
