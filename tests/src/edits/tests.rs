//! Verdicts of edits whose harm is known.

use crate::foreign::{Control, Options, run};

use super::{Allowed, Subject, Verdict, restarts_differ, verdict};

const ALLOWED: Allowed = Allowed {
    linear: 0.024,
    unit: 0.001,
    rotary_deg: 0.25,
    axis_speeds: false,
    wraps: false,
    signs_turn: false,
    tool_axis: None,
    starts_continuous: false,
    clamped: [Some('B'), None],
};

const PROGRAM: &str = "N1 G21 G8 G17 G40 G49 G80 G90 G91.1 G94 G97 G54 G64 P0.01
M9
G53 G0 Z0
T1 M6
G53 G0 Z0
G43 H1
S4000 M3
G4 P2
G0 B25 C40
X10 Y5
Z20
M8
G1 Z-1 F200
X20 F600
X30
X40 Y6
G3 X50 Y16 I0 J10
G0 Z20
G98 G81 X1 Y2 Z-5 R2 F150
X8
G80
M9
G53 G0 Z0
M5
M2
";

fn subject() -> Subject {
    Subject::new("part".to_owned(), PROGRAM, Options::of(Control::LinuxCnc), ALLOWED).expect("a program")
}

fn judged(from: &str, to: &str) -> Verdict {
    let subject = subject();
    let text = PROGRAM.replacen(from, to, 1);
    assert_ne!(text, PROGRAM, "{from:?}");
    verdict(&subject.trace, &run(&text, &subject.options), ALLOWED)
}

#[test]
fn what_changes_a_motion_or_its_state_is_harmful() {
    for (from, to) in [
        ("X30\n", ""),
        ("X20 F600\nX30\n", "X20 F600\nX30 Y-1\n"),
        ("X20 F600", "X20.1 F600"),
        ("F600", "F610"),
        ("I0 J10", "I0 J10 Z1"),
        ("G3 X50", "G2 X50"),
        ("M8\n", ""),
        ("M3\n", "M4\n"),
        ("S4000", "S400"),
        ("G4 P2\n", ""),
        ("S4000 M3\nG4 P2\n", "G4 P2\nS4000 M3\n"),
        ("C40\n", "C41\n"),
        ("X10 Y5\nZ20\n", "Z20\nX10 Y5\n"),
        ("X8\n", "X8\nZ-9\n"),
        ("X8\n", ""),
        ("R2 F150", "R3 F150"),
        ("X30\n", "X30\nG28\n"),
        ("X30\n", "X30\nM0\n"),
        ("X30\n", "X30\nM2\n"),
        ("G64 P0.01", "G64"),
        ("G54 ", "G55 "),
        ("G53 G0 Z0\nM5", "M5"),
    ] {
        let verdict = judged(from, to);
        assert!(matches!(verdict, Verdict::Harmful(_)), "{from:?} to {to:?}: {verdict:?}");
    }
}

#[test]
fn what_a_control_does_not_know_is_refused() {
    for (from, to) in
        [("X30\n", "X30\nM98 P1000\n"), ("X30\n", "X30\nX#5420\n"), ("M8\n", "M8 M9\n"), ("X8\n", "X8 L3\n")]
    {
        let verdict = judged(from, to);
        assert!(matches!(verdict, Verdict::Refused(_)), "{from:?} to {to:?}: {verdict:?}");
    }
}

#[test]
fn what_changes_nothing_is_harmless() {
    for (from, to) in [
        ("X30\n", "X30.0 (HERE)\n"),
        ("X30\n", "G90 X30 Y5\n"),
        ("X30\n", "(HERE)\nX30\n"),
        ("X30\n", "X30\n#1=5\n"),
        ("X30\n", "#1=15\nX[#1 * 2]\n"),
        ("X30\n", "G1 X30 F600\n"),
        ("M8\n", "M8\nM8\n"),
        ("G80\n", "G80\nG17\n"),
        ("X10 Y5\n", "Y5 X10\n"),
    ] {
        assert_eq!(judged(from, to), Verdict::Harmless, "{from:?} to {to:?}");
    }
}

#[test]
fn what_is_within_tolerance_or_cuts_nothing_is_undecided() {
    for (from, to) in [
        ("X20 F600", "X20.001 F600"),
        ("X20 F600\nX30\n", "F600 X30\n"),
        ("X30\n", "X30\nX30\n"),
        ("X30\n", "X30\nG4 P1\n"),
        ("M5\n", ""),
        ("G53 G0 Z0\nM5", "M5\nG53 G0 Z0"),
        ("X10 Y5\n", "X10\nY5\n"),
    ] {
        let verdict = judged(from, to);
        assert!(matches!(verdict, Verdict::Undecided(_)), "{from:?} to {to:?}: {verdict:?}");
    }
}

#[test]
fn a_restart_point_that_lacks_a_code_is_seen() {
    let subject = subject();
    let text = PROGRAM.replacen("T1 M6\n", "", 1).replacen("N1 G21", "T1 M6\nN1 G21", 1);
    let edited = run(&text, &subject.options).expect("it is read");
    let entered = |after: bool, number: usize| {
        let trace = if after { &edited } else { &subject.trace };
        let line = trace.restarts().nth(number).expect("a restart point");
        let options = Options { entry: Some(crate::foreign::Entry { line, tool: None }), ..subject.options.clone() };
        run(if after { &text } else { PROGRAM }, &options)
    };
    assert!(restarts_differ([&subject.trace, &edited], entered, ALLOWED));
    assert!(!restarts_differ([&subject.trace, &subject.trace], |_, number| entered(false, number), ALLOWED));
}

#[test]
fn lines_are_classified_by_what_is_done_in_which_mode() {
    let subject = subject();
    let class = |text: &str| {
        let index = subject.lines.iter().position(|line| line == text).expect("a line");
        subject.classes[&index].as_str()
    };
    assert_eq!(class("X30"), "axes feed>feed>feed");
    assert_eq!(class("X8"), "axes+cycle hole>hole>modal");
    assert_eq!(class("G4 P2"), "axes spindle>dwell>rapid");
}
