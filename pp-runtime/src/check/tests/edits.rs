//! Edits of a program that are meant.

use super::*;
use crate::check::report::PermittedEdit;

const DATA: &str = "UNITS/MM\nTOOL PATH/FIRST,TOOL,T1\nLOADTL/1\nSPINDL/RPM,2000,CLW\nCOOLNT/ON\nFEDRAT/1200,MMPM\nRAPID\n\
                    GOTO/0,0,50\nGOTO/0,0,0\nGOTO/20,0,0\nDELAY/1\nGOTO/20,9,0\nRAPID\nGOTO/20,9,50\n\
                    CYCLE/DEEP,STEP,4,RAPTO,5,FEDTO,-20,RTRCTO,14,MMPM,300\nGOTO/40,0,0\nCYCLE/OFF\n\
                    CYCLE/TAP,RAPTO,5,FEDTO,-10,MMPR,1.5\nGOTO/50,0,0\nCYCLE/OFF\n";

const SET_UP: &str = "cl.dialect = \"nx\"\nretract.distance = 20\n";

/// Findings about an edited program, and its permitted edits.
fn found(control: &str, keys: &str, program: &str) -> (Vec<String>, Vec<PermittedEdit>) {
    let set_up = format!("{SET_UP}{keys}");
    let (control, config) = configured::<Mill>(control, Mode::Axes, &set_up);
    let policy = config.check_policy::<Mill>(control, None).expect("the configuration suits control and machine");
    let outcome = check::<Mill>(&policy, Cursor::new(DATA), program.as_bytes()).expect("it can be read").outcome;
    assert_eq!(outcome.passed(), outcome.findings.is_empty());
    (outcome.findings.into_iter().map(|found| found.text).collect(), outcome.permitted)
}

/// The key for an edit of the first line that holds a text, and the program with it.
fn edited(program: &str, old: &str, new: &str) -> (String, String) {
    let line = program.lines().position(|line| line.contains(old)).unwrap_or_else(|| panic!("{old}: {program}"));
    let lines = program.lines().enumerate();
    let lines = lines.map(|(index, text)| if index == line { text.replacen(old, new, 1) } else { text.to_owned() });
    let program = lines.map(|line| line + "\n").collect();
    (format!("check.edits = [{{ line = {}, old = '{old}', new = '{new}', reason = 'a test' }}]\n", line + 1), program)
}

#[test]
fn an_edit_that_is_meant_is_permitted_and_listed() {
    let edits = [
        ("fanuc", "F1200.", "F1100."),
        ("fanuc", "G4 P1000", "G4 P1500"),
        ("fanuc", "M8", "M7"),
        ("fanuc", "Q4.", "Q3."),
        ("siemens", "F1200", "F800"),
        ("siemens", "G4 F1", "G4 F2"),
        ("heidenhain", "F1200", "F1100"),
        ("heidenhain", "9.1 DWELL 1", "9.1 DWELL 2"),
        ("heidenhain", "Q202=+4", "Q202=+2"),
        ("linuxcnc", "F1200", "F900.5"),
        ("haas", "Q4.", "Q2."),
    ];
    for (control, old, new) in edits {
        let program = posted_right::<Mill>(control, Mode::Axes, SET_UP, DATA);
        let (keys, changed) = edited(&program, old, new);
        assert_ne!(again::<Mill>(control, Mode::Axes, SET_UP, DATA, &changed), [""; 0], "{control}: {new}");
        let (findings, permitted) = found(control, &keys, &changed);
        assert_eq!(findings, [""; 0], "{control}: {new}\n{changed}");
        assert_eq!(permitted.iter().map(|edit| edit.new.as_str()).collect::<Vec<_>>(), [new], "{control}");
        // Without the edit the program is as posted, and nothing is permitted.
        let (findings, permitted) = found(control, &keys, &program);
        assert_eq!((findings.len(), permitted.len()), (0, 0), "{control}: {new}");
    }
}

#[test]
fn what_is_not_permitted_is_told_whatever_the_list_says() {
    let edits = [
        ("fanuc", "F1200.", "F1300."),
        ("fanuc", "X20.", "X21."),
        ("fanuc", "G1 Z0.", "G0 Z0."),
        ("fanuc", "G43 H1", "G43 H2"),
        ("fanuc", "G94 G54", "G94 G55"),
        ("fanuc", "S2000 M3", "S2100 M3"),
        ("fanuc", "S2000 M3", "S2000 M4"),
        ("fanuc", "T1 M6", "T2 M6"),
        ("fanuc", "Q4.", "Q5."),
        ("fanuc", "G4 P1000", "G4 P500"),
        ("heidenhain", "Q202=+4", "Q202=+5"),
        ("siemens", "G710 G17", "G710 G18"),
    ];
    for (control, old, new) in edits {
        let program = posted_right::<Mill>(control, Mode::Axes, SET_UP, DATA);
        let (keys, changed) = edited(&program, old, new);
        assert_ne!(found(control, &keys, &changed).0, [""; 0], "{control}: {new}\n{changed}");
    }
    // The F of a thread is its pitch, whatever the factor.
    let program = posted_right::<Mill>("fanuc", Mode::Axes, SET_UP, DATA);
    let tap = program.lines().find(|line| line.contains("G84")).expect("a thread");
    let word = tap.split(' ').find(|word| word.starts_with('F')).expect("its F");
    let (keys, changed) = edited(&program, word, "F2900.");
    assert_ne!(found("fanuc", &format!("check.feed_factor = 9\ncheck.speed_factor = 9\n{keys}"), &changed).0, [""; 0]);
}

#[test]
fn factors_permit_a_larger_f_and_another_s() {
    let program = posted_right::<Mill>("fanuc", Mode::Axes, SET_UP, DATA);
    let (keys, changed) = edited(&program, "F1200.", "F1300.");
    assert_eq!(found("fanuc", &format!("check.feed_factor = 1.1\n{keys}"), &changed).0, [""; 0]);
    assert_ne!(found("fanuc", &format!("check.feed_factor = 1.05\n{keys}"), &changed).0, [""; 0]);
    let without_thread = DATA.split("CYCLE/TAP").next().expect("the rest");
    let program = posted_right::<Mill>("fanuc", Mode::Axes, SET_UP, without_thread);
    let (keys, changed) = edited(&program, "S2000 M3", "S1900 M3");
    let found = |keys: &str| {
        let set_up = format!("{SET_UP}{keys}");
        again::<Mill>("fanuc", Mode::Axes, &set_up, without_thread, &changed)
    };
    assert_eq!(found(&format!("check.speed_factor = 1.1\n{keys}")), [""; 0]);
    assert_ne!(found(&keys), [""; 0]);
}

#[test]
fn an_edit_reaches_as_far_as_its_word_and_no_other() {
    let program = posted_right::<Mill>("fanuc", Mode::Axes, SET_UP, DATA);
    let (keys, changed) = edited(&program, "F1200.", "F1100.");
    // A second edit that is not listed.
    let (_, both) = edited(&changed, "X20.", "X20.5");
    assert_ne!(found("fanuc", &keys, &both).0, [""; 0]);
    // A list for another program.
    let (_, other) = edited(&program, "F1200.", "F1000.");
    let told = found("fanuc", &keys, &other).0;
    assert!(told.iter().any(|text| text.contains("neither `F1100.` nor `F1200.`")), "{told:?}");
}

#[test]
fn stops_are_added_and_nothing_else() {
    let program = posted_right::<Mill>("fanuc", Mode::Axes, SET_UP, DATA);
    let at = program.find("G4 P1000").expect("a block");
    let line = program[..at].lines().count() + 1;
    for (block, right) in [("M0", true), ("M1", true), ("M5", false), ("G0 Z5.", false), ("M30", false)] {
        let changed = format!("{}{block}\n{}", &program[..at], &program[at..]);
        let keys = format!("check.edits = [{{ line = {line}, old = '', new = '{block}', reason = 'look' }}]\n");
        let (findings, permitted) = found("fanuc", &keys, &changed);
        assert_eq!(findings.is_empty(), right, "{block}: {findings:?}");
        assert_eq!(permitted.len(), 1, "{block}");
    }
}
