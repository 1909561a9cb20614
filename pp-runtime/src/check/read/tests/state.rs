//! State that codes change: reference motions, planes, smoothing, path modes, work offsets.

use super::*;

const PLAIN: &str = "G21 G17 G40 G49 G80 G90 G94 G54\n";
const AT: &str = "G0 X1. Y2. Z3. B0. C0.\n";

#[test]
fn a_reference_motion_moves_every_axis_or_those_written_through_their_point() {
    for family in [Family::LinuxCnc, Family::Fanuc, Family::Haas] {
        for code in ["G28", "G30"] {
            let all = last(family, &format!("{PLAIN}{AT}{code}"));
            assert_eq!(
                (all.action, all.written, all.known),
                (Action::Reference { direct: false }, 0b11111, 0),
                "{code}"
            );
            let down = last(family, &format!("{PLAIN}{AT}{code} Z-200."));
            assert_eq!(
                (down.action, down.written, down.values[4]),
                (Action::Reference { direct: false }, 1 << 4, -200.0),
                "{code}"
            );
            assert_eq!(down.known, 0b01111);
            let up = last(family, &format!("{PLAIN}{AT}G91 {code} Z50."));
            assert_eq!((up.written, up.values[4]), (1 << 4, 53.0), "{code}");
            let still = last(family, &format!("{PLAIN}{AT}G91 {code} Z0."));
            assert_eq!((still.action, still.written), (Action::Reference { direct: true }, 1 << 4), "{code}");
        }
        assert_eq!(faults(family, &format!("{PLAIN}G91 G28 Z0.\n")), [""; 0]);
        assert!(!faults(family, &format!("{PLAIN}G91 G28 Z5.\n")).is_empty());
    }
}

#[test]
fn the_end_of_a_plane_may_rotate_the_axes_to_zero() {
    let program = |code: &str| format!("{TNC}2 L X+0 Y+0 Z+0 B+30 C+40 R0 FMAX\n3 {code}\n");
    for code in ["PLANE RESET TURN MB MAX FMAX", "PLANE RESET TURN MB50 F500", "PLANE RESET MOVE DIST50 F500"] {
        let block = last(Family::Heidenhain, &program(code));
        assert_eq!(
            (block.action, block.values[0], block.values[1], block.known),
            (Action::Orient, 0.0, 0.0, 3),
            "{code}"
        );
    }
    let stays = last(Family::Heidenhain, &program("PLANE RESET STAY"));
    assert_eq!((stays.action, stays.values[1]), (Action::Nothing, 30_f64.to_radians()));
    for code in [
        "PLANE RESET TURN SEQ-",
        "PLANE RESET STAY MB MAX",
        "PLANE RESET",
        "PLANE RESET TURN MB",
        "PLANE RESET TURN DIST50",
    ] {
        assert!(!faults(Family::Heidenhain, &program(code)).is_empty(), "{code}");
    }
}

#[test]
fn a_plane_has_its_pose_and_its_rotation_of_the_table() {
    let plane =
        |words: &str| tilt(&last(Family::Heidenhain, &format!("{TNC}2 PLANE SPATIAL SPA+45 SPB+0 SPC+90 {words}\n")));
    let (table, coord) = (plane("TURN MB MAX FMAX SEQ- TABLE ROT"), plane("TURN MB50 F500 SEQ+ COORD ROT"));
    assert_eq!((table.pose, table.rotates_table), (Some(false), true));
    assert_eq!((coord.pose, coord.rotates_table), (Some(true), false));
    assert_eq!(plane("TURN MB MAX FMAX").pose, None);
    for words in [
        "TURN MB FMAX",
        "TURN SEQ",
        "TURN SEQ+ SEQ-",
        "TURN SEQ- SYM-",
        "TURN SYM+",
        "TURN SYM-",
        "TURN TABLE",
        "TURN TABLE ROT COORD ROT",
        "TURN DIST50",
        "STAY FMAX",
    ] {
        let text = format!("{TNC}2 PLANE SPATIAL SPA+45 SPB+0 SPC+90 {words}\n");
        assert!(!faults(Family::Heidenhain, &text).is_empty(), "{words}");
    }
    let swivel = |direction: &str| {
        let text = format!("{SIEMENS}CYCLE800(0,\"TC\",0,57,0,0,0,30,0,0,0,0,0,{direction},0)\n");
        tilt(&last(Family::Siemens, &text))
    };
    assert_eq!([swivel("-1").pose, swivel("1").pose, swivel("0").pose], [Some(false), Some(true), None]);
    assert!(!swivel("0").oriented);
}

#[test]
fn a_rotary_word_takes_the_axes_out_of_the_plane() {
    let tnc = |code: &str| {
        let head = format!(
            "{TNC}2 L X+0 Y+0 Z+0 B+30 C+0 R0 FMAX\n3 PLANE SPATIAL SPA+0 SPB+30 SPC+0 TURN MB MAX FMAX TABLE ROT\n"
        );
        last(Family::Heidenhain, &format!("{head}4 L X+0 Y+0 Z+0 R0 FMAX\n5 {code}\n"))
    };
    for code in ["L B+5 F500", "L X+0 Y+0 B+5 F500"] {
        let block = tnc(code);
        assert_eq!((block.action, block.written & 2, block.values[1]), (Action::Feed, 2, 5_f64.to_radians()), "{code}");
        assert!(!tilt(&block).oriented, "{code}");
    }
    assert!(tilt(&tnc("L X+5 B+30 F500")).oriented);
    for (family, on, orient) in [
        (Family::Fanuc, "G68.2 X0. Y0. Z0. I0. J30. K0.", "G53.1"),
        (Family::Haas, "G268 X0. Y0. Z0. I0. J30. K0. Q123", "G253"),
    ] {
        let head = format!("{PLAIN}{AT}{on}\n{orient}\nG0 X0. Y0. Z0.\n");
        assert!(tilt(&last(family, &head)).oriented);
        let moved = last(family, &format!("{head}G1 G93 B5. F72.\n"));
        assert!(!tilt(&moved).oriented && moved.written == 2, "{family:?}");
        assert!(tilt(&last(family, &format!("{head}G1 G93 B5. F72.\n{orient}\n"))).oriented, "{family:?}");
        assert!(!faults(family, &format!("{PLAIN}{orient}\n")).is_empty(), "{family:?}");
        assert!(!faults(family, &format!("{PLAIN}{on} B5.\n")).is_empty(), "{family:?}");
    }
}

#[test]
fn smoothing_and_path_modes_are_in_the_state() {
    let on = |tolerance_mm: Option<f64>, level: Option<u8>| PathSmoothing::On { tolerance_mm, level };
    for (family, text, wanted) in [
        (Family::Fanuc, "G05.1 Q1", on(None, None)),
        (Family::Fanuc, "G05.1 Q1\nG05.1 Q0", PathSmoothing::Off),
        (Family::Haas, "G21\nG187 P2 E0.02", on(Some(0.02), Some(2))),
        (Family::Haas, "G21\nG187 P2 E0.02\nG187", PathSmoothing::Off),
        (Family::Siemens, "G710\nCYCLE832(0.02,2,1)", on(Some(0.02), Some(2))),
        (Family::Siemens, "G710\nCYCLE832(0.02,2,1)\nCYCLE832()", PathSmoothing::Off),
        (Family::Siemens, "G710\nCYCLE832(0,0,1)", PathSmoothing::Off),
        (Family::Heidenhain, "0 CYCL DEF 32.0 TOLERANCE\n1 CYCL DEF 32.1 T0.02", on(Some(0.02), None)),
        (
            Family::Heidenhain,
            "0 CYCL DEF 32.0 TOLERANCE\n1 CYCL DEF 32.1 T0.02\n2 CYCL DEF 32.2 HSC-MODE:1 TA0.5",
            on(Some(0.02), Some(1)),
        ),
        (Family::Heidenhain, "0 CYCL DEF 32.0 TOLERANCE\n1 CYCL DEF 32.1", PathSmoothing::Off),
    ] {
        assert_eq!(last(family, text).state.smoothing, wanted, "{text}");
    }
    let angle = |family: Family, text: &str| last(family, text).state.smoothing_angle_rad.map(f64::to_degrees);
    assert_eq!(angle(Family::Siemens, "G710\nCYCLE832(0.02,11,0.5)"), Some(0.5));
    assert_eq!(
        angle(Family::Heidenhain, "0 CYCL DEF 32.0 TOLERANCE\n1 CYCL DEF 32.1 T0.02\n2 CYCL DEF 32.2 HSC-MODE:1 TA0.5"),
        Some(0.5)
    );
    for (family, text) in [
        (Family::Fanuc, "G05.1"),
        (Family::Fanuc, "G05.1 Q2"),
        (Family::Haas, "G187 P4"),
        (Family::Siemens, "CYCLE832(0.02)"),
        (Family::Siemens, "CYCLE832(0.02,5)"),
        (Family::Heidenhain, "0 CYCL DEF 32.1 T0.02"),
        (Family::Heidenhain, "0 CYCL DEF 32.0 TOLERANCE\n1 L X+5 R0 FMAX"),
        (Family::Heidenhain, "0 CYCL DEF 32.2 HSC-MODE:1 TA0.5"),
        (Family::Heidenhain, "0 CYCL DEF 9.0 DWELL TIME\n1 M8"),
    ] {
        assert!(!faults(family, text).is_empty(), "{text}");
    }
    let path = |family: Family, text: &str| last(family, text).state.path_mode;
    let rounded =
        |tolerance_mm: Option<f64>, joining_mm: Option<f64>| Some(PathMode::Continuous { tolerance_mm, joining_mm });
    assert_eq!(path(Family::LinuxCnc, "G21 G64 P0.01"), rounded(Some(0.01), None));
    assert_eq!(path(Family::LinuxCnc, "G20 G64 P0.01 Q0.02"), rounded(Some(0.254), Some(0.508)));
    assert_eq!(path(Family::LinuxCnc, "G64"), rounded(None, None));
    assert_eq!(path(Family::LinuxCnc, "G61"), Some(PathMode::ExactPath));
    assert_eq!(path(Family::LinuxCnc, "G61.1"), Some(PathMode::ExactStop));
    assert_eq!(path(Family::Fanuc, "G61"), Some(PathMode::ExactStop));
    assert_eq!(path(Family::Siemens, "G64\nG642"), Some(PathMode::Smoothed(642)));
    assert!(!faults(Family::Fanuc, "G64 P1").is_empty());
    assert!(!faults(Family::Fanuc, "G5 P10000").is_empty());
}

#[test]
fn a_switch_of_tip_control_may_cancel_the_work_offset_on_siemens() {
    for code in ["TRAORI", "TRAFOOF"] {
        assert_eq!(last(Family::Siemens, &format!("{SIEMENS}{code}")).state.work_offset, None, "{code}");
        let again = last(Family::Siemens, &format!("{SIEMENS}{code}\nG55")).state.work_offset;
        assert_eq!(again, Some(WorkOffset::Code(550)), "{code}");
        // What is off already cancels nothing.
        let off = last(Family::Siemens, &format!("{SIEMENS}{code}\nTRAFOOF\nG55\nTRAFOOF")).state.work_offset;
        assert_eq!(off, Some(WorkOffset::Code(550)), "{code}");
    }
}

#[test]
fn the_path_of_rotary_axes_is_known_once_it_is_programmed() {
    let said = |text: &str| {
        let state = last(Family::Heidenhain, text).state;
        (state.shortest, state.shortest_stated)
    };
    assert_eq!([said("0 M8"), said("0 M127"), said("0 M126")], [(false, false), (false, true), (true, true)]);
}

#[test]
fn dwells_are_read_in_each_of_their_forms() {
    assert_eq!(last(Family::Fanuc, "G4 X0.5").action, Action::Dwell(0.5));
    assert_eq!(last(Family::Fanuc, "G4 X500").action, Action::Dwell(0.5));
    assert_eq!(last(Family::Siemens, "S600 M3\nG4 S20").action, Action::Dwell(2.0));
    for (family, text) in [
        (Family::Fanuc, "G4 P0.5"),
        (Family::Fanuc, "G4"),
        (Family::Fanuc, "G4 P500 X1."),
        (Family::Fanuc, "G4 P500 Y1."),
        (Family::Fanuc, "G4 U1."),
        (Family::LinuxCnc, "G4 X1"),
        (Family::Haas, "G4 X1."),
        (Family::Siemens, "G4 F1 S5"),
        (Family::Siemens, "G4 S5"),
        (Family::Heidenhain, "0 CYCL DEF 9.0 DWELL TIME\n1 CYCL DEF 9.1 DWELL"),
    ] {
        assert!(!faults(family, text).is_empty(), "{text}");
    }
}

#[test]
fn a_tool_axis_has_three_components_and_needs_tip_control() {
    let head = "G710 G17 G90 G94\nTRAORI\nG1 X0 Y0 Z0 A3=0 B3=0 C3=1 F100\n";
    for text in ["A3=0 B3=0.6", "A3=0 B3=0.6 C3=0.8 B5", "A3=1 A3=0 B3=0 C3=1"] {
        assert!(!faults(Family::Siemens, &format!("{head}{text}\n")).is_empty(), "{text}");
    }
    assert!(!faults(Family::Siemens, "G710 G17 G90 G94\nG1 X0 A3=0 B3=0 C3=1 F100\n").is_empty());
    assert!(!faults(Family::Heidenhain, &format!("{TNC}2 LN X+0 Y+0 Z+0 TX+0 TY+0 TZ+1 F100\n")).is_empty());
}
