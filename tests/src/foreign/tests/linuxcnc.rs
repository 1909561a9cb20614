//! What is refused in programs for LinuxCNC, and what stays in force.

use super::super::axes::Axes;
use super::super::{Control, Effect, Entry, Feed, Options, run};
use super::{program, refusal, start};

const LINUXCNC: Control = Control::LinuxCnc;

fn motions(blocks: &str) -> Vec<super::Executed> {
    super::motions(LINUXCNC, blocks)
}

#[test]
fn words_stay_in_force_until_they_change() {
    let read = motions("G0 X1 Y2 B3\nG1 X-0.5 F10\nY4\nG93 B5 F7");
    assert_eq!(read[2].state.position, Axes::from([('X', -0.5), ('Y', 4.0), ('B', 3.0)]));
    assert_eq!(read[2].words, Axes::from([('Y', 4.0)]));
    assert_eq!(read[2].feed(), Some(Feed::PerMinute(10.0)));
    assert_eq!(read[3].feed(), Some(Feed::InverseTime(7.0)));
    assert_eq!((read[0].effect, read[3].effect, read[3].state.tool), (Effect::Rapid, Effect::Feed, Some(1)));
}

#[test]
fn machine_coordinates_say_nothing_about_the_program() {
    let read = motions("G0 X1 Z2\nG53 G0 Z0\nX3");
    assert_eq!(read[1].state.position, Axes::from([('X', 1.0)]));
    assert_eq!(read[1].state.machine, Axes::from([('Z', 0.0)]));
    assert_eq!(read[2].state.position, Axes::from([('X', 3.0)]));
}

#[test]
fn untidy_text_is_refused() {
    for block in ["G0  X1", "G0 X1 ", " G0 X1", "G0 X-0", "G0 X1e3", "G0 X1.", "G0 X.5", "G0 X01", "G0 X1.50", "G0 x1"]
    {
        refusal(LINUXCNC, block);
    }
    refusal(LINUXCNC, "(A (B) C)");
    refusal(LINUXCNC, "(A");
    refusal(LINUXCNC, "\n");
    refusal(LINUXCNC, &format!("({})", "A".repeat(254)));
    let whole = program(LINUXCNC, "");
    assert!(run(whole.trim_end(), &Options::of(LINUXCNC)).is_err(), "the last line does not end");
}

#[test]
fn untidy_text_is_read_as_the_control_reads_it_where_that_is_asked_for() {
    let options = Options { untidy: true, ..Options::of(LINUXCNC) };
    let read = run(&program(LINUXCNC, "g0  x01.50 (over) Y.5"), &options).expect("the control reads it");
    let motion = read.motions().next().expect("a motion");
    assert_eq!(motion.words, Axes::from([('X', 1.5), ('Y', 0.5)]));
}

#[test]
fn a_state_that_makes_no_sense_is_refused() {
    let refused = |blocks: &str, why: &str| {
        let found = refusal(LINUXCNC, blocks);
        assert!(found.contains(why), "{blocks:?}: {found}");
    };
    refused("G1 X1", "G1 without F");
    refused("G93 G1 X1", "G93 without F");
    refused("G1 X1 F5\nG93 X2", "G93 without F");
    refused("G93 G1 X1 F5\nG94 X2", "G1 without F");
    refused("G93 G0 X1", "inverse time");
    refused("G0 X1 F5", "with F");
    refused("M5\nG1 X1 F5", "spindle off");
    refused("M0\nG1 X1 F5", "spindle off");
    refused("T2 M6\nG0 X1", "length offset");
    refused("G53 G1 X1 F5", "G53 with feed");
    refused("G0 X1 X2", "two X");
    refused("G0 G1 X1", "two codes");
    refused("G0 X1 M8", "no business");
    refused("G0 X0 Y0\nG2 X1 F5", "no business");
    refused("G0 X0\nG2 X1 F5", "unknown position");
    refused("G43 H1 X1", "no business");
    refused("G43", "register");
    refused("M3", "S is missing");
    refused("M6", "without T");
    refused("S0 M3", "S0");
    refused("G93 G1 X1 F5\nG4 P1", "inverse time");
    refused("F100", "moves nothing");
    refused("G1", "moves nothing");
    refused("G93", "moves nothing");
    refused("G53 G0", "moves nothing");
    refused("G80\nX1", "no motion mode");
    refused("M2", "follows the end");
    assert!(run(start(LINUXCNC), &Options::of(LINUXCNC)).is_err());
}

#[test]
fn a_safety_line_is_complete_or_refused() {
    let line = "G21 G17 G40 G49 G80 G90 G94 G54";
    motions(&format!("{line}\nG43 H1\nG0 X1"));
    motions(&format!("{line} G64 P0.01\nG43 H1\nG0 X1"));
    for code in line.split(' ').skip(1) {
        refusal(LINUXCNC, &line.replace(&format!(" {code}"), ""));
    }
    refusal(LINUXCNC, &format!("{line} X1"));
}

#[test]
fn an_arc_needs_to_know_whether_its_centre_is_absolute() {
    let arc = |codes: &str, words: &str| {
        let program = program(LINUXCNC, &format!("G0 X1 Y0 Z0\nG3 X0 Y1 {words} F9"));
        run(&program.replace("G91.1 ", codes), &Options::of(LINUXCNC)).map(|_| ()).map_err(|refused| refused.why)
    };
    assert_eq!(arc("G91.1 ", "I-1 J0"), Ok(()));
    assert_eq!(arc("G90.1 ", "I0 J0"), Ok(()));
    assert!(arc("", "I-1 J0").is_err_and(|why| why.contains("G90.1 may be in force")));
    assert!(arc("G90.1 ", "I-1 J0").is_err());
}

#[test]
fn a_safety_line_leaves_no_linear_position_no_motion_mode_and_no_feed() {
    let read = motions("G0 X1 Y2 B3\nG1 X2 F10\nG21 G17 G40 G49 G80 G90 G91.1 G94 G54\nG43 H1\nG0 Z4");
    assert_eq!(read[2].state.position, Axes::from([('Z', 4.0), ('B', 3.0)]));
    assert!(refusal(LINUXCNC, "G0 X1\nG21 G17 G40 G49 G80 G90 G91.1 G94 G54\nG43 H1\nX2").contains("no motion mode"));
    let again = "G1 X1 F5\nG21 G17 G40 G49 G80 G90 G91.1 G94 G54\nG43 H1\nG1 X2";
    assert!(refusal(LINUXCNC, again).contains("G1 without F"));
}

#[test]
fn words_of_the_gauge_line_are_read_without_length_offset_only() {
    let gauge_line = Options { gauge_line: true, ..Options::of(LINUXCNC) };
    let without = program(LINUXCNC, "G0 X1").replace("G43 H1\n", "");
    assert_eq!(run(&without, &gauge_line).expect("no offset").motions().count(), 1);
    assert!(run(&without, &Options::of(LINUXCNC)).is_err());
    assert!(run(&program(LINUXCNC, "G0 X1"), &gauge_line).is_err());
}

#[test]
fn a_proof_program_cuts_nothing_with_the_spindle_off() {
    let dry = Options { dry: true, ..Options::of(LINUXCNC) };
    let off = program(LINUXCNC, "M5\nG1 X1 F5");
    assert!(run(&off, &dry).is_ok());
    assert!(run(&off, &Options::of(LINUXCNC)).is_err());
}

#[test]
fn a_program_can_be_entered_only_where_the_state_is_complete() {
    let complete = program(
        LINUXCNC,
        "G0 X1 Z9\nN2 G21 G8 G17 G40 G49 G80 G90 G91.1 G94 G97 G54\nG43 H1\nS9 M3\nG0 X2 Z9\nG1 X3 F5",
    );
    let at = |line| Options { entry: Some(Entry { line, tool: Some(1) }), ..Options::of(LINUXCNC) };
    let whole = run(&complete, &Options::of(LINUXCNC)).expect("complete");
    let line = whole.restarts().next().expect("a restart point");
    assert_eq!(line, 6);
    assert_eq!(run(&complete, &at(line)).expect("complete").motions().count(), 2);
    for code in ["G8 ", "G40 ", "G97 "] {
        assert!(run(&complete.replace(code, ""), &at(line)).is_err(), "{code}");
    }
    assert!(run(&complete.replace("G43 H1\nS9", "S9"), &at(line)).is_err());
    assert!(run(&complete.replace("\nS9 M3", ""), &at(line)).is_err());
    assert!(run(&complete, &at(line + 1)).is_err());
    assert!(run(&complete, &at(70)).is_err());
}
