//! One number, one tool: statements of CL data and configuration about it.

use super::*;
use crate::cl::StatedTool;

/// A tool with this cutter that cuts.
fn cut(cutter: &str, call: &str) -> String {
    format!("{cutter}\n{call}\nGOTO/0,0,0\n")
}

fn given(tool: StatedTool) -> ReadingOptions {
    ReadingOptions { tools: [(1, tool)].into(), ..mm() }
}

#[test]
fn two_cutters_with_one_number_are_refused_with_both_lines() {
    for (second, what) in [
        ("CUTTER/3,0", "a diameter of 3 mm in line 4 and 10 mm in line 1"),
        ("CUTTER/10,2", "a corner radius of 2 mm in line 4 and 0 mm in line 1"),
    ] {
        let text = cut("CUTTER/10,0", "LOADTL/1") + &cut(second, "LOADTL/1");
        assert_eq!(errors(&text), [format!("4:1+1 tool 1 has {what}")]);
    }
    let kinds = cut("TLDATA/MILL,10,0,50,0,0", "LOADTL/1") + &cut("TLDATA/DRILL,10,118,50", "LOADTL/1");
    assert_eq!(errors(&kinds), ["4:1+1 tool 1 has a kind, DRILL in line 4 and MILL in line 1"]);
    let lengths = "LOADTL/1,LENGTH,100\nGOTO/0,0,0\nLOADTL/1,LENGTH,120\nGOTO/0,0,0\n";
    assert_eq!(errors(lengths), ["3:1+1 tool 1 has a length of 120 mm in line 3 and 100 mm in line 1"]);
    let after = "LOADTL/1\n$$-> CUTTER / 10\nGOTO/0,0,0\nLOADTL/1\n$$-> CUTTER / 3\nGOTO/0,0,0\n";
    assert_eq!(errors(after), ["5:1+1 tool 1 has a diameter of 3 mm in line 5 and 10 mm in line 2"]);
    // The same again, and a cutter that states less.
    events(&(cut("CUTTER/10,1", "LOADTL/1") + &cut("CUTTER/10", "LOADTL/1") + &cut("CUTTER/10.004,1", "LOADTL/1")));
}

#[test]
fn a_cutter_without_a_call_is_that_of_the_tool_in_the_spindle() {
    let operation = |d: u32, call: &str| format!("TOOL PATH/A,TOOL,D{d}\nTLDATA/MILL,{d},0,75,0,0\n{call}GOTO/0,0,0\n");
    let uncalled = "the tool in the spindle has a diameter of 8 mm in line 5 and 16 mm in line 2";
    assert_eq!(errors(&(operation(16, "") + &operation(8, ""))), [format!("5:1+1 {uncalled}")]);
    let called = "tool 1 has a diameter of 8 mm in line 6 and 16 mm in line 2";
    assert_eq!(errors(&(operation(16, "LOAD/TOOL,1\n") + &operation(8, ""))), [format!("6:1+1 {called}")]);
    events(&(operation(16, "") + &operation(8, "LOAD/TOOL,1\n")));
    events(&(operation(16, "") + &operation(16, "")));
    // A rapid before the call that the cutter belongs to cuts nothing.
    events(&format!("{}CUTTER/8\nRAPID\nGOTO/0,0,9\nLOADTL/2\nGOTO/0,0,9\n", cut("CUTTER/16", "LOADTL/1")));
    assert_eq!(errors(&format!("{}CUTTER/8\nGOTO/0,0,9\n", cut("CUTTER/16", "LOADTL/1"))).len(), 1);
}

#[test]
fn a_tool_with_two_names_is_remarked_on_once() {
    let operation = |name: &str| format!("TOOL PATH/A,TOOL,{name}\nLOAD/TOOL,1\nGOTO/0,0,0\n");
    let found = read_from(["M10", "M10", "D8", "D7"].map(operation).concat().as_bytes(), MM).diagnostics;
    let [remark] = &found[..] else { panic!("{found:?}") };
    assert_eq!((remark.severity, remark.location.line), (Severity::Warning, 7));
    assert_eq!(remark.text, "tool 1 is called D8 in line 7 and M10 in line 1");
}

#[test]
fn a_tool_with_two_registers_has_two_rows() {
    let text = "LOADTL/5,LENGTH,100,ADJUST,5\nGOTO/0,0,0\nLOADTL/5,LENGTH,94,ADJUST,25\nGOTO/0,0,0\nLOADTL/5,ADJUST,5\nGOTO/0,0,0\n";
    let found = events_without_places(text, MM);
    let lengths: Vec<bool> = found.iter().step_by(2).map(|event| event.contains("length_mm: Some(100.0)")).collect();
    assert_eq!(lengths, [true, false, true], "{found:?}");
}

#[test]
fn a_tool_that_is_called_again_keeps_length_and_register() {
    let again = |call: &str| format!("LOADTL/1,LENGTH,120,ADJUST,5\nGOTO/0,0,0\n{call}\nGOTO/0,0,0\n");
    let found = events_without_places(&again("LOADTL/1"), MM);
    assert_eq!(found[0], found[2]);
    let found = events_without_places(&again("LOADTL/1,ADJUST,1"), MM);
    assert!(
        found[2].contains("length_mm: None, length_offset: Some(1)"),
        "another register has another length: {found:?}"
    );
}

#[test]
fn the_configuration_fills_what_is_absent_and_contradicts_nothing() {
    let text = cut("CUTTER/10,1", "LOADTL/1,LENGTH,100,ADJUST,3");
    let same = StatedTool {
        diameter_mm: Some(10.0),
        corner_radius_mm: Some(1.0),
        length_mm: Some(100.0),
        offset: Some(3),
        ..Default::default()
    };
    assert_eq!(events_with(&text, given(same.clone())), events(&text));
    for (tool, what) in [
        (
            StatedTool { diameter_mm: Some(12.0), ..same.clone() },
            "1:1+1 tool 1 has a diameter of 10 mm in line 1 and 12 mm in `[tools.1]`",
        ),
        (
            StatedTool { corner_radius_mm: Some(2.0), ..same.clone() },
            "1:1+1 tool 1 has a corner radius of 1 mm in line 1 and 2 mm in `[tools.1]`",
        ),
        (
            StatedTool { length_mm: Some(90.0), ..same.clone() },
            "2:1+1 tool 1 has a length of 100 mm in line 2 and 90 mm in `[tools.1]`",
        ),
        (
            StatedTool { offset: Some(4), ..same.clone() },
            "2:1+1 tool 1 has length offset register 3 in line 2 and 4 in `[tools.1]`",
        ),
    ] {
        assert_eq!(errors_with(&text, given(tool)), [what]);
    }
}

#[test]
fn a_key_settles_a_contradiction() {
    let text = cut("CUTTER/10,0", "LOADTL/1") + &cut("CUTTER/10.4,0", "LOADTL/1");
    let wider = StatedTool { path_diameter_mm: Some(10.4), ..Default::default() };
    assert!(events_with(&text, given(wider)).iter().filter(|event| event.contains("Some(10.0)")).count() == 2);
    let one = StatedTool { is_one: true, diameter_mm: Some(9.9), ..Default::default() };
    let found = events_with(&text, given(one));
    assert!(found[0].contains("diameter_mm: None"), "those of the configuration: {found:?}");
    // Without its sizes it would be a guess.
    let bare = StatedTool { is_one: true, ..Default::default() };
    assert_eq!(errors_with(&text, given(bare)).len(), 1);
}
