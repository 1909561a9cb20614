//! Each modal code changes the part of the state that it should, on every control that has it.

use super::super::Control::{self, Fanuc, Haas, Heidenhain, LinuxCnc, Siemens};
use super::super::axes::Axes;
use super::super::state::{
    Compensation, Coolant, Distance, FeedMode, Interpolation, Length, MotionMode, PathMode, Plane, ReturnLevel,
    RotaryPath, Spindle, State, TipControl, VectorFrame, WorkOffset,
};
use super::{refusal, state_after};

/// Blocks, the last of which changes the state, and whether a state agrees with them.
type Row = (Control, &'static str, fn(&State) -> bool);

#[rustfmt::skip]
const ROWS: &[Row] = &[
    (LinuxCnc, "G0 X1", |state| state.motion == Some(MotionMode::Rapid)),
    (Fanuc, "G1 X1. F10.", |state| state.motion == Some(MotionMode::Feed) && state.feed == Some(10.0)),
    (Haas, "G00 X1.", |state| state.motion == Some(MotionMode::Rapid)),
    (LinuxCnc, "G0 X1\nG80", |state| state.motion.is_none()),
    (LinuxCnc, "G18", |state| state.plane == Some(Plane::Zx)),
    (Siemens, "G19", |state| state.plane == Some(Plane::Yz)),
    (Heidenhain, "TOOL CALL 2 Y S9", |state| state.plane == Some(Plane::Zx) && state.tool == Some(2)),
    (Fanuc, "G20 G17 G40 G49 G80 G90 G94 G54", |state| state.units.is_some_and(|units| units.in_mm() > 25.0)),
    (Siemens, "G700 G17 G40 G64 G90 G94 G54", |state| state.units.is_some_and(|units| units.in_mm() > 25.0)),
    (Fanuc, "G91", |state| state.distance == Some(Distance::Incremental)),
    (Siemens, "G91", |state| state.distance == Some(Distance::Incremental)),
    (Fanuc, "G93", |state| state.feed_mode == Some(FeedMode::InverseTime)),
    (Siemens, "G95", |state| state.feed_mode == Some(FeedMode::PerRevolution)),
    (Siemens, "F5\nG95", |state| state.feed.is_none()),
    (Siemens, "F5", |state| state.feed == Some(5.0)),
    (LinuxCnc, "G41 D3", |state| state.compensation == Some(Compensation::Left(Some(3)))),
    (Siemens, "G42", |state| state.compensation == Some(Compensation::Right(None))),
    (Heidenhain, "L X+1 RL F9", |state| state.compensation == Some(Compensation::Left(None))),
    (Heidenhain, "L X+1 RR F9\nL X+2 R0", |state| state.compensation == Some(Compensation::Off)),
    (LinuxCnc, "G43 H7", |state| state.length == Some(Length::Register(7))),
    (Fanuc, "G49", |state| state.length == Some(Length::Off)),
    (Siemens, "D2", |state| state.length == Some(Length::Register(2))),
    (Siemens, "D0", |state| state.length == Some(Length::Off)),
    (Heidenhain, "TOOL CALL 2 Z S9", |state| state.length == Some(Length::Register(2))),
    (LinuxCnc, "G59.3", |state| state.work_offset == Some(WorkOffset::Code(593))),
    (Fanuc, "G54.1 P12", |state| state.work_offset == Some(WorkOffset::Further(12))),
    (Haas, "G154 P12", |state| state.work_offset == Some(WorkOffset::Further(12))),
    (Siemens, "G505", |state| state.work_offset == Some(WorkOffset::Code(5050))),
    (Heidenhain, "CYCL DEF 247 DATUM SETTING ~\n  Q339=+3 ;DATUM NUMBER", |state| {
        state.work_offset == Some(WorkOffset::Row(3))
    }),
    (LinuxCnc, "T5 M6", |state| {
        (state.tool, state.length, state.spindle) == (Some(5), None, Some(Spindle::Off))
    }),
    (Fanuc, "T5 M6\nT6", |state| (state.tool, state.selected) == (Some(5), Some(6))),
    (Siemens, "T5", |state| (state.tool, state.selected) == (Some(1), Some(5))),
    (Siemens, "T5\nM6", |state| (state.tool, state.selected) == (Some(5), None)),
    (LinuxCnc, "S5 M4", |state| (state.spindle, state.speed) == (Some(Spindle::CounterClockwise), Some(5.0))),
    (Heidenhain, "TOOL CALL S77", |state| (state.tool, state.speed) == (Some(1), Some(77.0))),
    (Haas, "M05", |state| state.spindle == Some(Spindle::Off)),
    (LinuxCnc, "M0", |state| state.spindle.is_none() && state.position.is_empty()),
    (LinuxCnc, "M7\nM8", |state| state.coolant == Some(Coolant { flood: true, mist: true, through: false })),
    (LinuxCnc, "M7\nM8\nM9", |state| state.coolant == Some(Coolant::default())),
    (Haas, "M88", |state| state.coolant.is_some_and(|coolant| coolant.through)),
    (Haas, "M88\nM89", |state| state.coolant == Some(Coolant::default())),
    (LinuxCnc, "G64 P0.02", |state| state.path == Some(PathMode::Continuous(Some(0.02)))),
    (LinuxCnc, "G61", |state| state.path == Some(PathMode::ExactStop)),
    (Fanuc, "G99", |state| state.return_level == Some(ReturnLevel::Reference)),
    (Fanuc, "M29 S500", |state| state.rigid && state.speed == Some(500.0)),
    (Fanuc, "G0 B5. C6.\nG43.4 H1 P1 X1. Y2. Z3.", |state| {
        let start = Axes::from([('B', 5.0), ('C', 6.0)]);
        state.tip_control == Some(TipControl::On { start, vectors: false })
            && state.interpolation == Some(Interpolation::Vector)
            && state.position == Axes::from([('X', 1.0), ('Y', 2.0), ('Z', 3.0), ('B', 5.0), ('C', 6.0)])
    }),
    (Fanuc, "G0\nG43.5 H1 P0 X1. Y2. Z3. I0. J0.6 K0.8", |state| state.vector == Some([0.0, 0.6, 0.8])),
    (Fanuc, "G0\nG43.4 H1 X1. Y2. Z3.\nG49", |state| state.tip_control == Some(TipControl::Off)),
    (Haas, "G00 G234 H1 X1. Y2. Z3.", State::under_tip_control),
    (Siemens, "TRAORI\nORIWKS ORIVECT", |state| {
        state.under_tip_control()
            && state.interpolation == Some(Interpolation::Vector)
            && state.vector_frame == Some(VectorFrame::Workpiece)
    }),
    (Siemens, "TRAORI\nG1 X1 A3=0.6 B3=0 C3=0.8 F5", |state| state.vector == Some([0.6, 0.0, 0.8])),
    (Siemens, "TRAORI\nTRAFOOF", |state| state.tip_control == Some(TipControl::Off)),
    (Heidenhain, "FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS", |state| {
        state.under_tip_control() && state.interpolation == Some(Interpolation::RotaryAxes)
    }),
    (Heidenhain, "M128\nFUNCTION RESET TCPM", |state| state.tip_control == Some(TipControl::Off)),
    (Heidenhain, "M126", |state| state.rotary_path == Some(RotaryPath::Shortest)),
    (Fanuc, "G68.2 X0. Y0. Z0. I90. J0. K0.", |state| state.tilted_plane().is_some_and(|plane| !plane.oriented)),
    (Fanuc, "G68.2 X0. Y0. Z0. I90. J0. K0.\nG53.1", |state| state.tilted_plane().is_some_and(|plane| plane.oriented)),
    (Fanuc, "G68.2 X0. Y0. Z0. I90. J0. K0.\nG69", |state| state.tilt == Some(None)),
    (Haas, "G268 X0. Y0. Z0. I0. J90. K0. Q123", |state| state.tilted_plane().is_some()),
    (Siemens, "CYCLE800(0,\"\",0,57,0,0,0,90,0,0,0,0,0,1,0)", |state| {
        state.tilted_plane().is_some_and(|plane| plane.oriented)
    }),
    (Siemens, "CYCLE800()", |state| state.tilt == Some(None)),
    (Heidenhain, "PLANE SPATIAL SPA+0 SPB+45 SPC+0 TURN MB MAX FMAX SEQ+ COORD ROT", |state| {
        state.tilted_plane().is_some_and(|plane| plane.oriented)
    }),
    (Heidenhain, "PLANE RESET STAY", |state| state.tilt == Some(None)),
    (Siemens, "MCALL CYCLE81(5,0,2,-3)", |state| state.cycle.is_some()),
    (Siemens, "MCALL CYCLE81(5,0,2,-3)\nMCALL", |state| state.cycle.is_none()),
    (Heidenhain, "CC X+1 Y-2", |state| state.pole == [Some(1.0), Some(-2.0), None]),
];

#[test]
fn each_modal_code_changes_its_part_of_the_state() {
    for (control, blocks, agrees) in ROWS {
        let state = state_after(*control, blocks);
        assert!(agrees(&state), "{control:?} {blocks:?}: {state:?}");
        // The state did not agree before; a line that begins with a blank continues a block.
        let lines: Vec<&str> = blocks.lines().collect();
        let last = lines.iter().rposition(|line| !line.starts_with(' ')).expect("a block");
        let before = state_after(*control, &lines[..last].join("\n"));
        assert!(!agrees(&before), "{control:?} {blocks:?} changes nothing");
    }
}

#[test]
fn a_change_of_what_words_count_from_leaves_positions_unknown() {
    let cut = "G0 X1. Y2. Z3. B4.";
    for (change, known) in [
        ("G55", "B"),
        ("G43 H2", "XYB"),
        ("G68.2 X0. Y0. Z0. I90. J0. K0.", "B"),
        ("G68.2 X0. Y0. Z0. I90. J0. K0.\nG53.1", ""),
        ("M1", ""),
        ("T2 M6", ""),
        ("G53 G0 X0.", "YZB"),
        ("G54", "XYZB"),
        ("G93", "XYZB"),
    ] {
        let state = state_after(Fanuc, &format!("{cut}\n{change}"));
        let letters: String = state.position.letters().collect();
        assert_eq!(letters, known, "{change}");
    }
}

#[test]
fn two_codes_of_one_group_are_refused() {
    for (control, block) in [
        (LinuxCnc, "G17 G18"),
        (Fanuc, "G90 G91"),
        (Fanuc, "G43 G49 H1"),
        (Haas, "G93 G94"),
        (Siemens, "G54 G55"),
        (Siemens, "ORIAXES ORIVECT"),
        (Heidenhain, "L X+1 RL RR F5"),
    ] {
        assert!(refusal(control, block).contains("two codes"), "{control:?} {block}");
    }
}
