//! What a control executes where no careful programmer writes it, as edits of a program leave it.

use approx::assert_abs_diff_eq;

use super::super::Control::{self, Fanuc, Haas, Heidenhain, LinuxCnc, Siemens};
use super::super::state::{Coolant, CycleKind, State};
use super::super::{Effect, Options, Refused, Trace, run};
use super::program;

fn options(control: Control) -> Options {
    Options { untidy: true, careless: true, idle: vec!["M10".to_owned()], ..Options::of(control) }
}

fn read(control: Control, blocks: &str) -> Result<Trace, Refused> {
    run(&program(control, blocks), &options(control))
}

fn trace(control: Control, blocks: &str) -> Trace {
    read(control, blocks).unwrap_or_else(|refused| panic!("{control:?} {blocks:?}: {refused}"))
}

fn effects(control: Control, blocks: &str) -> Vec<Effect> {
    trace(control, blocks).motions().map(|block| block.effect).collect()
}

/// State before the end of the program.
fn state(control: Control, blocks: &str) -> State {
    let blocks = trace(control, blocks).blocks;
    blocks[blocks.len() - 2].state
}

fn is_refused(control: Control, blocks: &str) {
    assert!(read(control, blocks).is_err(), "{control:?} {blocks:?} is accepted");
}

#[test]
fn axes_go_to_their_reference_points() {
    for (control, from) in [(LinuxCnc, "G0 X1 Y2 Z3"), (Fanuc, "G0 X1. Y2. Z3."), (Haas, "G00 X1. Y2. Z3.")] {
        let letters = |block: &str| state(control, &format!("{from}\n{block}")).position.letters().collect::<String>();
        assert_eq!(letters("G28 Z5."), "XY", "{control:?}");
        assert_eq!(letters("G30"), "", "{control:?}");
        assert!(matches!(effects(control, "G28 Z5.")[..], [Effect::Home(passed)] if passed.get('Z') == Some(5.0)));
    }
}

#[test]
fn a_plane_reset_may_move_rotary_axes() {
    for block in ["PLANE RESET TURN FMAX", "PLANE RESET MOVE DIST50 FMAX"] {
        assert_eq!(effects(Heidenhain, block), [Effect::Orient], "{block}");
    }
    assert_eq!(effects(Heidenhain, "PLANE RESET STAY"), []);
}

#[test]
fn the_sign_that_chooses_the_rotary_axes_is_part_of_the_plane() {
    let solution = |control, block: &str| state(control, block).tilted_plane().expect("a plane").solution;
    let spatial = |sign: &str| format!("PLANE SPATIAL SPA+0 SPB+45 SPC+0 TURN MB MAX FMAX {sign}COORD ROT");
    assert_eq!(["SEQ+ ", "SEQ- ", ""].map(|sign| solution(Heidenhain, &spatial(sign))), [1, -1, 0]);
    let swivel = |direction| format!("CYCLE800(0,\"\",0,57,0,0,0,0,45,0,0,0,0,{direction},0)");
    assert_eq!([1, -1, 0].map(|direction| solution(Siemens, &swivel(direction))), [1, -1, 0]);
    is_refused(Heidenhain, &spatial("").replace("COORD", "TABLE"));
}

#[test]
fn smoothing_is_a_state() {
    for (control, on, other, off) in [
        (Fanuc, "G05.1 Q1", "G05.1 Q2", "G05.1 Q0"),
        (Haas, "G187 P3 E0.01", "G187 P1 E0.01", "G187"),
        (Siemens, "CYCLE832(0.01,3)", "CYCLE832(10,3)", "CYCLE832()"),
        (
            Heidenhain,
            "CYCL DEF 32.0 TOLERANCE\nCYCL DEF 32.1 T0.01\nCYCL DEF 32.2 HSC-MODE:1",
            "CYCL DEF 32.0 TOLERANCE\nCYCL DEF 32.1 T5\nCYCL DEF 32.2 HSC-MODE:1",
            "CYCL DEF 32.0 TOLERANCE\nCYCL DEF 32.1",
        ),
    ] {
        let smoothing = |blocks: &str| state(control, blocks).smoothing.unwrap_or_default();
        assert_ne!(smoothing(on), smoothing(other), "{control:?}");
        assert_ne!(smoothing(on), smoothing(off), "{control:?}");
        assert_eq!(smoothing(on), smoothing(&format!("{other}\n{on}")), "{control:?}");
    }
}

#[test]
fn a_program_ends_at_its_marks() {
    let whole = trace(Siemens, "G0 X1\nG0 X2").motions().count();
    for end in ["RET", "M17", "M2", "M30"] {
        assert_eq!(trace(Siemens, &format!("G0 X1\n{end}\nG0 X2")).motions().count(), whole - 1, "{end}");
    }
    assert_eq!(trace(Heidenhain, "END PGM PART MM\nL X+1 R0 FMAX").motions().count(), 0);
    for mark in ["%", "O0002 (OTHER)"] {
        is_refused(Fanuc, mark);
        is_refused(Haas, mark);
    }
}

#[test]
fn a_semicolon_ends_a_block_on_fanuc_and_haas() {
    for control in [Fanuc, Haas] {
        assert_eq!(effects(control, "G0 X1.;Y2.").len(), 2);
        assert_eq!(effects(control, ";G0 X1.").len(), 1);
        assert_eq!(effects(control, "G0 X1. (A;B)").len(), 1);
    }
    assert_eq!(effects(LinuxCnc, "G0 X1 ; Y2").len(), 1);
}

#[test]
fn a_word_of_a_cycle_drills_again() {
    let holes = |blocks: &str| {
        let holes = effects(Fanuc, &format!("G0 X0. Y0. Z9.\nG98 G81 X1. Z-3. R2. F9.\n{blocks}"));
        holes
            .into_iter()
            .filter_map(|effect| if let Effect::Hole(hole) = effect { Some(hole) } else { None })
            .collect::<Vec<_>>()
    };
    assert_abs_diff_eq!(holes("Z-40.")[1].cycle.bottom, -40.0, epsilon = 1e-12);
    assert_abs_diff_eq!(holes("R-1.")[1].cycle.reference, -1.0, epsilon = 1e-12);
    assert_eq!(holes("B5.").len(), 2);
    assert_eq!(holes("G80").len(), 1);
}

#[test]
fn every_parameter_of_a_cycle_counts() {
    let cycle = |number: u32, more: &str| {
        let levels = "~\n  Q200=+2 ~\n  Q201=-9 ~\n  Q206=+9 ~\n  Q202=+3 ~\n  Q203=+0 ~\n  Q204=+9";
        let blocks = format!("CYCL DEF {number} HOLE {levels}{more}\nL X+1 Y+1 R0 FMAX M99");
        state(Heidenhain, &blocks).cycle.expect("a cycle")
    };
    assert_eq!(cycle(205, " ~\n  Q379=+0"), cycle(205, " ~\n  Q379=+0"));
    assert_ne!(cycle(205, " ~\n  Q379=+0"), cycle(205, " ~\n  Q379=+5"));
    assert_ne!(cycle(205, ""), cycle(200, ""));
    assert_eq!(cycle(205, "").kind, CycleKind::Peck { step: 3.0 });
    let dwell = |block: &str| match effects(Fanuc, &format!("G0 X0. Y0. Z9.\nG98 {block} X1. Z-3. R2. P500 F9."))[1] {
        Effect::Hole(hole) => hole.cycle.dwell_s,
        other => panic!("{other:?}"),
    };
    assert_eq!((dwell("G82"), dwell("G81")), (0.5, 0.0));
}

#[test]
fn codes_beside_other_words_are_executed() {
    let coolant = state(Fanuc, "G0 X1. M8").coolant;
    assert_eq!(coolant, Some(Coolant { flood: true, ..Coolant::default() }));
    let blocks = trace(Fanuc, "G0 X1. M10").blocks;
    assert!(blocks.iter().any(|block| block.effect == Effect::Shop(10)));
    is_refused(Fanuc, "M8 M9");
    is_refused(Fanuc, "G0 X1. M11");
    is_refused(Heidenhain, "X+1 Y+1");
    is_refused(Heidenhain, "CYCL DEF 9.1 DWELL 2");
    is_refused(Heidenhain, "L IZ+0 R0 FMAX M91");
    assert_eq!(effects(Heidenhain, "L Z+0 R0 FMAX M91"), [Effect::Machine]);
}

#[test]
fn traori_clears_the_work_offset() {
    assert!(
        state(Siemens, "TRAORI").offset_cleared
            && state(Siemens, "TRAORI\nG54\nTRAFOOF").offset_cleared
            && !state(Siemens, "TRAFOOF").offset_cleared
    );
    assert!(!state(Siemens, "TRAORI\nG54").offset_cleared);
}

#[test]
fn a_guard_names_its_register() {
    let guarded = |register: u32| {
        let guard = format!("IF [ABS[#{register}+#{}-9.5] GT 0.01] THEN #3000=101 (NO)", register + 1000);
        state(Fanuc, &guard).guarded
    };
    assert_eq!((guarded(10_001), guarded(10_002)), (Some(10_001), Some(10_002)));
}
