//! Motions of each control: arcs, holes, distances, machine coordinates, and what is unknown to it.

use approx::assert_abs_diff_eq;

use super::super::Control::{self, Fanuc, Haas, Heidenhain, LinuxCnc, Siemens};
use super::super::axes::Axes;
use super::super::state::CycleKind;
use super::super::{Effect, Options, run};
use super::{motions, program, refusal};

/// Centre to nine decimals, sweep in whole degrees, and position after the last motion.
fn last_arc(control: Control, blocks: &str) -> ([f64; 3], i64, Axes) {
    let all = motions(control, blocks);
    let last = all.last().expect("a motion");
    match last.effect {
        Effect::Arc(arc) => {
            let centre = arc.centre.map(|value| (value * 1e9).round() / 1e9 + 0.0);
            (centre, arc.sweep_deg.round() as i64, last.state.position)
        }
        other => panic!("{control:?} {blocks:?}: {other:?}"),
    }
}

#[test]
fn arcs_by_centre_radius_pole_and_polar_angle_are_the_same_quarter() {
    let end = Axes::from([('X', 0.0), ('Y', 5.0), ('Z', 0.0)]);
    let quarter = ([0.0, 0.0, 0.0], 90, end);
    assert_eq!(last_arc(LinuxCnc, "G0 X5 Y0 Z0\nG3 X0 Y5 I-5 J0 F9"), quarter);
    assert_eq!(last_arc(LinuxCnc, "G0 X5 Y0 Z0\nG3 X0 Y5 R5 F9"), quarter);
    assert_eq!(last_arc(Fanuc, "G0 X5. Y0. Z0.\nG3 X0. Y5. I-5. J0. F9."), quarter);
    assert_eq!(last_arc(Haas, "G00 X5. Y0. Z0.\nG03 X0. Y5. R5. F9."), quarter);
    assert_eq!(last_arc(Siemens, "G0 X5 Y0 Z0\nG3 X0 Y5 CR=5 F9"), quarter);
    assert_eq!(last_arc(Siemens, "G0 X5 Y0 Z0\nG3 X0 Y5 I=AC(0) J=AC(0) F9"), quarter);
    assert_eq!(last_arc(Heidenhain, "L X+5 Y+0 Z+0 R0 FMAX\nCC X+0 Y+0\nC X+0 Y+5 DR+ R0 F9"), quarter);
    let (centre, sweep, at) = last_arc(Heidenhain, "L X+5 Y+0 Z+0 R0 FMAX\nCC X+0 Y+0\nCP IPA+90 IZ-1 DR+ R0 F9");
    assert_eq!((centre, sweep, at.get('Z')), ([0.0; 3], 90, Some(-1.0)));
    for (letter, value) in [('X', 0.0), ('Y', 5.0)] {
        assert_abs_diff_eq!(at.get(letter).expect("known"), value, epsilon = 1e-12);
    }
}

#[test]
fn sense_full_circles_revolutions_and_planes_are_seen() {
    assert_eq!(last_arc(LinuxCnc, "G0 X5 Y0 Z0\nG2 X0 Y5 I-5 J0 F9").1, -270);
    assert_eq!(last_arc(LinuxCnc, "G0 X5 Y0 Z0\nG2 X5 Y0 I-5 J0 F9").1, -360);
    assert_eq!(last_arc(LinuxCnc, "G0 X5 Y0 Z0\nG3 I-5 J0 F9").1, 360);
    assert_eq!(last_arc(LinuxCnc, "G0 X5 Y0 Z0\nG3 X0 Y5 R-5 F9").0.map(|value| value.round() as i64), [5, 5, 0]);
    let polar = last_arc(Heidenhain, "L X+0 Y+5 Z+0 R0 FMAX\nCC X+0 Y+0\nCP IPA+90 DR+ R0 F9").2;
    assert_abs_diff_eq!(polar.get('X').expect("known"), -5.0, epsilon = 1e-12);
    assert_eq!(last_arc(Siemens, "G0 X5 Y0 Z0\nG3 X5 Y0 Z1 I-5 J0 TURN=2 F9").1, 1080);
    assert_eq!(last_arc(LinuxCnc, "G19\nG0 X0 Y5 Z0\nG3 Y0 Z5 J-5 K0 F9").1, 90);
    assert!(refusal(LinuxCnc, "G0 X5 Y0\nG3 X0 Y6 I-5 J0 F9").contains("from its centre"));
    assert!(refusal(LinuxCnc, "G0 X5\nG3 X0 Y5 I-5 J0 F9").contains("unknown position of Y"));
    assert!(refusal(LinuxCnc, "G0 X5 Y0\nG3 X0 Y5 I-5 K0 F9").contains("outside its plane"));
    assert!(refusal(LinuxCnc, "G0 X5 Y0\nG1 X0 I5 F9").contains("no business"));
    assert!(refusal(Heidenhain, "L X+5 Y+0 R0 FMAX\nCC X+0 Y+0\nC X+0 Y+5 R0 F9").contains("DR"));
}

/// Kind, reference, bottom and return level of each hole, and the Z after the last one.
fn holes(control: Control, blocks: &str) -> (Vec<(CycleKind, [f64; 3])>, Option<f64>) {
    let all = motions(control, blocks);
    let hole = |effect: &Effect| match effect {
        Effect::Hole(hole) => Some((hole.cycle.kind, [hole.cycle.reference, hole.cycle.bottom, hole.back_to])),
        _ => None,
    };
    let holes = all.iter().filter_map(|block| hole(&block.effect)).collect();
    (holes, all.last().and_then(|block| block.state.position.get('Z')))
}

#[test]
fn a_cycle_makes_its_hole_at_every_position() {
    let drilled = (CycleKind::Drill, [2.0, -3.0, 9.0]);
    let two = (vec![drilled, drilled], Some(9.0));
    assert_eq!(holes(LinuxCnc, "G0 X0 Y0 Z9\nG98 G81 X1 Y1 Z-3 R2 F9\nX2\nG80"), two);
    assert_eq!(holes(Fanuc, "G0 X0. Y0. Z9.\nG98 G81 X1. Y1. Z-3. R2. F9.\nX2.\nG80"), two);
    assert_eq!(holes(Siemens, "G0 X0 Y0 Z9\nF9\nMCALL CYCLE81(9,0,2,-3)\nG0 X1 Y1\nX2\nMCALL"), two);
    let cycle = "CYCL DEF 200 DRILLING ~\n  Q200=+2 ;A ~\n  Q201=-3 ;B ~\n  Q206=+9 ;C ~\n  Q202=+3 ;D ~\n  Q203=+0 ;E ~\n  Q204=+9 ;F";
    let blocks = format!("{cycle}\nL X+1 Y+1 R0 FMAX M99\nL X+2 R0 FMAX M99");
    assert_eq!(holes(Heidenhain, &blocks), two);
    assert_eq!(holes(Siemens, "G0 X0 Y0 Z9\nF9\nCYCLE81(9,0,2,-3)\nG0 X1"), (vec![drilled], Some(9.0)));
}

#[test]
fn words_of_a_cycle_decide_how_the_hole_is_made() {
    let kind = |control, blocks: &str| holes(control, blocks).0[0].0;
    let fanuc = |cycle: &str| kind(Fanuc, &format!("G0 X0. Y0. Z9.\nG98 {cycle} X1. Z-3. R2. F50."));
    assert_eq!(fanuc("G83 Q0.5"), CycleKind::Peck { step: 0.5 });
    assert_eq!(fanuc("G73 Q0.5"), CycleKind::ChipBreak { step: 0.5 });
    assert_eq!(fanuc("G85"), CycleKind::Ream);
    assert_eq!(fanuc("G84"), CycleKind::Tap { pitch: 0.5 });
    assert_eq!(fanuc("G74"), CycleKind::Tap { pitch: -0.5 });
    let tap = "G0 X0 Y0 Z9\nG33.1 Z-3 K0.5";
    assert_eq!(holes(LinuxCnc, tap), (vec![(CycleKind::Tap { pitch: 0.5 }, [9.0, -3.0, 9.0])], Some(9.0)));
    let siemens = |cycle: &str| kind(Siemens, &format!("G0 X0 Y0 Z9\nF9\nMCALL {cycle}\nX1"));
    assert_eq!(siemens("CYCLE83(9,0,2,-3,,,0.5,0,0,0,1,1,,,,0,1)"), CycleKind::Peck { step: 0.5 });
    assert_eq!(siemens("CYCLE83(9,0,2,-3,,,0.5,0,0,0,1,0,,,1,0)"), CycleKind::ChipBreak { step: 0.5 });
    assert_eq!(siemens("CYCLE84(9,0,2,-3,,0,3,,1.25,0,500,500,,1)"), CycleKind::Tap { pitch: 1.25 });
    assert!(refusal(LinuxCnc, "G0 X0 Y0 Z9\nG98 G83 X1 Z-3 R2 F9").contains("without Q"));
    assert!(refusal(LinuxCnc, "G0 X0 Y0 Z9\nG98 G81 X1 R2 F9").contains("without its levels"));
    assert!(refusal(LinuxCnc, "G0 X0 Y0\nG98 G81 X1 Z-3 R2 F9").contains("initial level"));
    assert!(refusal(LinuxCnc, "G0 X0 Y0 Z9\nG81 X1 Z-3 R2 F9").contains("G98"));
    assert!(refusal(Heidenhain, "L X+1 R0 FMAX M99").contains("call of no cycle"));
}

#[test]
fn numbers_count_as_the_control_counts_them() {
    let x = |control, block: &str, plain_numbers| {
        let options = Options { plain_numbers, ..Options::of(control) };
        let read = run(&program(control, block), &options).expect("it is read");
        read.motions().next().and_then(|motion| motion.words.get('X')).expect("an X word")
    };
    let near = |one: f64, other: f64| assert_abs_diff_eq!(one, other, epsilon = 1e-12);
    for (control, block) in [(Fanuc, "G0 X5"), (Haas, "G00 X5")] {
        assert!(refusal(control, block).contains("without a point"));
    }
    near(x(Fanuc, "G0 X5", true), 5.0);
    near(x(Fanuc, "G0 X5.", false), 5.0);
    near(x(LinuxCnc, "G0 X5", false), 5.0);
    let wait = |control, block: &str| {
        let read = run(&program(control, block), &Options::of(control)).expect("it is read");
        read.blocks.iter().find_map(|block| if let Effect::Dwell(wait) = block.effect { Some(wait) } else { None })
    };
    assert_eq!(wait(LinuxCnc, "G4 P2"), Some(2.0));
    assert_eq!(wait(Fanuc, "G4 P2000"), Some(2.0));
    assert_eq!(wait(Haas, "G04 P2."), Some(2.0));
    assert_eq!(wait(Siemens, "G4 F2"), Some(2.0));
    assert_eq!(wait(Heidenhain, "CYCL DEF 9.0 DWELL TIME\nCYCL DEF 9.1 DWELL 2"), Some(2.0));
    assert!(refusal(Haas, "G01 X1. F5").contains("decimal point"));
}

#[test]
fn distances_count_from_a_known_position() {
    let at = |control, blocks: &str| motions(control, blocks).last().expect("a motion").state.position.get('X');
    assert_eq!(at(Fanuc, "G0 X5. Z0.\nG91\nX1."), Some(6.0));
    assert_eq!(at(Siemens, "G0 X5 Z0\nX=IC(1)"), Some(6.0));
    assert_eq!(at(Siemens, "G0 X5 Z0\nG91\nX=AC(1)"), Some(1.0));
    assert_eq!(at(Heidenhain, "L X+5 R0 FMAX\nL IX-1 R0 FMAX"), Some(4.0));
    assert!(refusal(Fanuc, "G91\nG0 X1.").contains("unknown position"));
    assert!(refusal(Fanuc, "G91\nG53 G0 X1.").contains("by their distance"));
}

#[test]
fn machine_coordinates_are_a_rapid_of_their_own() {
    for (control, block) in [
        (LinuxCnc, "G53 G0 Z0"),
        (Fanuc, "G49 G53 G0 Z0."),
        (Haas, "G53 G00 Z0."),
        (Siemens, "SUPA G0 Z0 D0"),
        (Heidenhain, "L Z+0 R0 FMAX M91"),
    ] {
        let all = motions(control, block);
        assert_eq!((all[0].effect, all[0].state.machine.get('Z')), (Effect::Machine, Some(0.0)), "{control:?}");
        assert_eq!(all[0].state.position.get('Z'), None, "{control:?}");
    }
}

#[test]
fn what_a_control_does_not_know_is_refused() {
    for (control, block) in [
        (LinuxCnc, "G43.4 H1"),
        (LinuxCnc, "G68.2 X0 Y0 Z0 I0 J0 K0"),
        (LinuxCnc, "M30"),
        (LinuxCnc, "G28"),
        (LinuxCnc, "M88"),
        (LinuxCnc, "O100 sub"),
        (LinuxCnc, "%"),
        (Fanuc, "G33.1 Z-1. K1."),
        (Fanuc, "G234 H1"),
        (Fanuc, "#100=5"),
        (Fanuc, "G0 L5"),
        (Fanuc, "M98 P1000"),
        (Haas, "M07"),
        (Haas, "G43.4 H1"),
        (Siemens, "G43 H1"),
        (Siemens, "R1=5"),
        (Siemens, "X=R1"),
        (Siemens, "CYCLE99(1)"),
        (Siemens, "CYCLE81(1)"),
        (Siemens, "GOTOF END"),
        (Siemens, "CYCLE800(0,\"\",0,21,0,0,0,0,0,0,0,0,0,1,0)"),
        (Heidenhain, "M6"),
        (Heidenhain, "M7"),
        (Heidenhain, "CYCL DEF 240 CENTRING ~\n  Q200=+2 ;A"),
        (Heidenhain, "PLANE SPATIAL SPA+0 SPB+0 SPC+0 STAY"),
        (Heidenhain, "FUNCTION MODE TURN"),
        (Heidenhain, "CALL PGM OTHER"),
        (Heidenhain, "LBL 5"),
        (Heidenhain, "FN 0: Q1 = +5"),
        (Heidenhain, "L XX+1 R0 FMAX"),
    ] {
        refusal(control, block);
    }
    let lines = program(Heidenhain, "M8\nM9");
    assert!(run(&lines.replace("5 M9", "6 M9"), &Options::of(Heidenhain)).is_err(), "numbers count on");
}

#[test]
fn a_block_of_the_shop_changes_nothing_where_it_is_named() {
    assert!(refusal(Fanuc, "M10").contains("unknown"));
    let options = Options { idle: vec!["M10".to_owned()], ..Options::of(Fanuc) };
    assert!(run(&program(Fanuc, "M10"), &options).is_ok());
}

#[test]
fn a_feed_motion_is_as_careful_on_every_control() {
    for (control, cut, off) in [
        (Fanuc, "G1 X1. F9.", "M5"),
        (Haas, "G01 X1. F9.", "M05"),
        (Siemens, "G1 X1 F9", "M5"),
        (Heidenhain, "L X+1 R0 F9", "M5"),
    ] {
        assert_eq!(motions(control, cut).len(), 1);
        assert!(refusal(control, &format!("{off}\n{cut}")).contains("spindle off"), "{control:?}");
        let without = cut.rsplit_once(' ').expect("an F").0;
        assert!(refusal(control, without).contains("without F"), "{control:?}");
    }
    assert!(refusal(Fanuc, "G49\nG1 X1. F9.").contains("length offset"));
    assert!(refusal(Siemens, "D0\nG1 X1 F9").contains("length offset"));
}
