//! What a program has besides its motions: names of operations, preselected tools, the blank.

use super::*;

/// Two operations of two tools.
pub(super) const TWO_OPERATIONS: &str = "UNITS/MM\nTOOL PATH/FIRST,TOOL,T1\nLOADTL/1\nSPINDL/RPM,2000,CLW\nFEDRAT/300,MMPM\nRAPID\n\
                              GOTO/0,0,50\nGOTO/0,0,0\nGOTO/20,0,0\nGOTO/20,0,50\nTOOL PATH/SECOND,TOOL,T2\nLOADTL/2\n\
                              SPINDL/RPM,1000,CLW\nRAPID\nGOTO/0,9,50\nGOTO/0,9,2\nGOTO/20,9,2\nGOTO/20,9,50\n";

#[test]
fn the_name_of_an_operation_comes_after_the_retract_of_the_one_before() {
    for (control, mode, name) in [
        ("fanuc", Mode::Axes, "(OPERATION SECOND)"),
        ("haas", Mode::Axes, "(OPERATION SECOND)"),
        ("siemens", Mode::Tcp, "MSG(\"SECOND\")"),
        ("heidenhain", Mode::Tcp, "* - SECOND"),
    ] {
        let program = posted_right::<Tables>(control, mode, "retract.distance = 20\n", TWO_OPERATIONS);
        let (before, after) = program.split_once(name).expect("the name");
        let last = before.trim_end_matches(|byte: char| byte.is_ascii_digit() || byte == ' ').trim_end();
        let retract = last.lines().last().expect("a block");
        assert!(["G53", "SUPA", "M91"].iter().any(|code| retract.contains(code)), "{control}: {retract}\n{program}");
        let change = ["M6", "M06", "TOOL CALL 2"];
        assert!(change.iter().any(|code| after.contains(code)), "{control}\n{program}");
    }
}

#[test]
fn the_last_tool_preselects_the_first() {
    let program = posted_right::<Mill>("fanuc", Mode::Axes, "", TWO_OPERATIONS);
    assert!(program.contains("T1 M6\nT2\n") && program.contains("T2 M6\nT1\n"), "{program}");
    let not_wanted = posted_right::<Mill>("fanuc", Mode::Axes, "control.preselect_first = false\n", TWO_OPERATIONS);
    assert!(not_wanted.contains("T1 M6\nT2\n") && !not_wanted.contains("\nT1\n"), "{not_wanted}");
    let one = TWO_OPERATIONS.split("TOOL PATH/SECOND").next().expect("the first operation");
    assert!(!posted_right::<Mill>("fanuc", Mode::Axes, "", one).contains("\nT1\n"));
}

#[test]
fn a_tool_change_comes_after_the_complete_state_and_none_after_the_last_motion() {
    for (control, restart, change) in
        [("linuxcnc", "N2 ", "T2 M6\n"), ("fanuc", "N2 ", "T2 M6\n"), ("siemens", "N2 ", "T2 M6\n")]
    {
        let program = posted_right::<Mill>(control, Mode::Axes, "", TWO_OPERATIONS);
        let place = program.find(restart).expect("the second operation");
        let early = format!("{}{change}{}", &program[..place], program[place..].replacen(change, "", 1));
        assert_told::<Mill>(control, Mode::Axes, "", TWO_OPERATIONS, &early);
        let end = program.rfind("M5\n").expect("the spindle stops") + 3;
        let late = format!("{}T0 M6\n{}", &program[..end], &program[end..]);
        assert_told::<Mill>(control, Mode::Axes, "", TWO_OPERATIONS, &late);
    }
}

/// The second tool is called, and a chuck opens, the program stops and waits before its first motion.
const RECORDS_AFTER_A_CALL: &str = "UNITS/MM\nTOOL PATH/FIRST,TOOL,T1\nLOADTL/1\nSPINDL/RPM,2000,CLW\nFEDRAT/300,MMPM\nRAPID\n\
                                    GOTO/0,0,50\nGOTO/0,0,0\nGOTO/20,0,2\nTOOL PATH/SECOND,TOOL,T2\nLOADTL/2\nAUXFUN/77\n\
                                    CHUCK/OPEN\nSTOP\nSPINDL/RPM,1000,CLW\nDELAY/2\nRAPID\nGOTO/0,9,50\nGOTO/0,9,2\nGOTO/20,9,2\n";

const CHUCK: &str = "cl.auxfun = [77]\ncl.words = { \"CHUCK/OPEN\" = { blocks = \"M68\", at = \"after_change\" } }\n\
                     control.effects = { M77 = \"none\", M68 = \"chuck\" }\nretract.distance = 20\n";

/// The blocks of a program with these codes, one after the other.
pub(super) fn with_codes<'p>(program: &'p str, codes: &[&str]) -> Vec<&'p str> {
    let words = |line: &'p str| line.split_whitespace().find(|word| codes.contains(word));
    program.lines().filter(|line| !line.starts_with(['(', ';'])).filter_map(words).collect()
}

#[test]
fn records_act_in_the_order_of_the_cl_data() {
    for control in ["fanuc", "haas", "siemens", "linuxcnc", "heidenhain"] {
        let program = posted_right::<Mill>(control, Mode::Axes, CHUCK, RECORDS_AFTER_A_CALL);
        let plain = program.replace("M0", "M").replace("CYCL DEF 9.0", "G4").replace("G04", "G4");
        let (_, second) = plain.split_once("SECOND").expect("the second operation");
        let change = if control == "heidenhain" { "CALL" } else { "M6" };
        let codes = with_codes(second, &["M5", "M3", "M77", "M68", "M0", "M", "G4", change]);
        let stop = if control == "haas" { "M0" } else { "M" };
        let mut wanted = vec!["M5", change, "M77", "M5", "M68", "M5", stop, "M3", "G4"];
        if control == "heidenhain" {
            // The speed is one of the tool call.
            wanted.insert(7, change);
        }
        assert_eq!(codes[..wanted.len()], wanted, "{control}\n{program}");
    }
}

/// Codes of the second operation, in order, where the chuck opens at a place, and M77 comes at another.
fn codes_at(control: &str, chuck: &str, auxfun: &str) -> (Vec<String>, String, String) {
    let data = RECORDS_AFTER_A_CALL.replace("AUXFUN/77\nCHUCK/OPEN\n", "CHUCK/OPEN\nAUXFUN/77\n");
    let set_up = CHUCK
        .replace("\"after_change\"", &format!("\"{chuck}\""))
        .replace(" } }\n", &format!(" }}, \"AUXFUN/77\" = {{ at = \"{auxfun}\" }} }}\n"))
        .replace("cl.auxfun = [77]\n", "");
    let program = posted_right::<Mill>(control, Mode::Axes, &set_up, &data);
    let plain = program.replace("M0", "M").replace("CYCL DEF 9.0", "G4").replace("G04", "G4");
    let (_, second) = plain.split_once("SECOND").expect("the second operation");
    let change = if control == "heidenhain" { "TOOL" } else { "M6" };
    let codes = with_codes(second, &["M77", "M68", "M0", "M", "G4", change]);
    (codes.iter().map(|code| code.replace("TOOL", "M6").replace("M0", "M")).collect(), set_up, data)
}

#[test]
fn a_block_of_the_shop_comes_at_its_stated_place() {
    for control in ["fanuc", "haas", "siemens", "linuxcnc", "heidenhain"] {
        let wanted = [
            ("before_change", "before_change", &["M68", "M77", "M6", "M", "G4"][..]),
            ("before_change", "after_change", &["M68", "M6", "M77", "M", "G4"]),
            ("after_change", "at_approach", &["M6", "M68", "M", "G4", "M77"]),
            ("at_approach", "at_approach", &["M6", "M", "G4", "M68", "M77"]),
            // The change has come when the other block does.
            ("after_change", "before_change", &["M6", "M68", "M77", "M", "G4"]),
        ];
        for (chuck, auxfun, wanted) in wanted {
            let (mut codes, ..) = codes_at(control, chuck, auxfun);
            // A TNC has the speed in a tool call of its own.
            codes.dedup();
            let mut changes = 0;
            codes.retain(|code| code != "M6" || std::mem::replace(&mut changes, 1) == 0);
            assert_eq!(codes[..wanted.len()], *wanted, "{control} {chuck} {auxfun}");
        }
    }
}

#[test]
fn a_block_of_the_shop_that_has_left_its_stated_place_is_found() {
    for (chuck, auxfun) in
        [("before_change", "after_change"), ("after_change", "at_approach"), ("at_approach", "at_approach")]
    {
        let (_, set_up, data) = codes_at("fanuc", chuck, auxfun);
        let program = posted_right::<Mill>("fanuc", Mode::Axes, &set_up, &data);
        let change = program.find("T2 M6\n").expect("the tool change");
        let stop = program.find("\nM0\n").expect("the stop") + 1;
        for record in ["M77\n", "M68\n"] {
            let at = program.find(record).expect("the record");
            let without = format!("{}{}", &program[..at], &program[at + record.len()..]);
            assert_told::<Mill>("fanuc", Mode::Axes, &set_up, &data, &without);
            for place in [change, stop, stop + 3] {
                let moved = format!(
                    "{}{record}{}",
                    &without[..place - if at < place { record.len() } else { 0 }],
                    &without[place - if at < place { record.len() } else { 0 }..]
                );
                let place_is_same = moved == program;
                if !place_is_same {
                    assert_told::<Mill>("fanuc", Mode::Axes, &set_up, &data, &moved);
                }
            }
        }
    }
}

#[test]
fn the_place_of_a_chuck_after_a_call_must_be_stated() {
    let set_up = CHUCK.replace("{ blocks = \"M68\", at = \"after_change\" }", "\"M68\"");
    let refused =
        posted::<Mill>("fanuc", Mode::Axes, &set_up, RECORDS_AFTER_A_CALL.replace("AUXFUN/77\n", "").as_str());
    let fault = refused.expect_err("it is refused").remove(0);
    let help = fault.help.unwrap_or_default();
    assert!(fault.text.contains("between the call of T2"), "{}", fault.text);
    assert!(["before_change", "after_change", "at_approach"].iter().all(|place| help.contains(place)), "{help}");
    // With no call before it, it comes in the order of the CL data.
    let before =
        RECORDS_AFTER_A_CALL.replace("AUXFUN/77\nCHUCK/OPEN\n", "").replace("LOADTL/2", "CHUCK/OPEN\nLOADTL/2");
    let program = posted_right::<Mill>("fanuc", Mode::Axes, &set_up, &before);
    assert!(program.find("M68").expect("it opens") < program.find("T2 M6").expect("a change"), "{program}");
}

/// A code that is declared "none" and not confirmed comes with the spindle off, at the machine retract.
#[test]
fn a_code_without_effect_is_confirmed_to_be_harmless() {
    let unconfirmed = CHUCK.replace("M68 = \"chuck\"", "M68 = \"none\"");
    let program = posted_right::<Mill>("fanuc", Mode::Axes, &unconfirmed, RECORDS_AFTER_A_CALL);
    assert!(program.contains("M5\nM68\n"), "{program}");
    assert_told::<Mill>(
        "fanuc",
        Mode::Axes,
        &unconfirmed,
        RECORDS_AFTER_A_CALL,
        &program.replace("M5\nM68", "S500 M3\nM68"),
    );
    let confirmed = unconfirmed.replace("\"after_change\" }", "\"after_change\", harmless = true }");
    let program = posted_right::<Mill>("fanuc", Mode::Axes, &confirmed, RECORDS_AFTER_A_CALL);
    assert!(program.contains("M77\nM68\n"), "{program}");
}

#[test]
fn a_record_that_has_left_its_place_is_found() {
    let program = posted_right::<Mill>("fanuc", Mode::Axes, CHUCK, RECORDS_AFTER_A_CALL);
    let change = program.find("T2 M6\n").expect("the tool change");
    let told = |changed: &str| assert_told::<Mill>("fanuc", Mode::Axes, CHUCK, RECORDS_AFTER_A_CALL, changed);
    for record in ["M77\n", "M68\n", "M0\n", "G4 P2000\n"] {
        let at = change + program[change..].find(record).expect("the record");
        let without = format!("{}{}", &program[..at], &program[at + record.len()..]);
        told(&without);
        told(&format!("{}{record}{}", &without[..change], &without[change..]));
    }
    // The spindle is off in a tool change and where a chuck opens.
    let stop = program[..change].rfind("M5\n").expect("the spindle stops");
    told(&format!("{}{}", &program[..stop], &program[stop + 3..]));
    for block in ["T2 M6\n", "M68\n"] {
        let place = program.find(block).expect("the block");
        told(&format!("{}S500 M3\n{}", &program[..place], &program[place..]));
    }
}

#[test]
fn a_tool_that_is_called_last_comes_into_the_spindle() {
    let data = format!("{TWO_OPERATIONS}LOADTL/1\n");
    for control in ["fanuc", "haas", "siemens", "linuxcnc", "heidenhain"] {
        let program = posted_right::<Mill>(control, Mode::Axes, "", &data);
        let calls = ["T1 M6\n", "T1 M06\n", "T1\nM6\n", "TOOL CALL 1 Z"];
        let last = calls.iter().filter_map(|call| Some((program.rfind(call)?, call.len()))).max();
        let (place, length) = last.expect("the tool change");
        assert!(place > program.len() - 200, "{control}\n{program}");
        let without = format!("{}{}", &program[..place], &program[place + length..]);
        assert_told::<Mill>(control, Mode::Axes, "", &data, &without);
    }
    let twice = TWO_OPERATIONS.replace("LOADTL/2", "LOADTL/3\nLOADTL/2");
    assert!(!posted_right::<Mill>("fanuc", Mode::Axes, "", &twice).contains("T3 M6"));
}

#[test]
fn a_blank_around_the_cuts_is_named_in_the_header() {
    let note = "BLANK is the box around all cuts";
    let program = posted_right::<Mill>("heidenhain", Mode::Axes, "", TWO_OPERATIONS);
    assert!(program.contains("BLK FORM 0.1 Z X+0 Y+0 Z+0\n") && program.contains(note), "{program}");
    let solid = "solids.stock = { box = [[-10, -10, -30], [40, 20, 0]] }\n";
    let program = posted_right::<Mill>("heidenhain", Mode::Axes, solid, TWO_OPERATIONS);
    assert!(
        program.contains(note) && program.contains("the solid `stock` of [solids] is for the simulation"),
        "{program}"
    );
    let stock = "stock = { lower = [-10, -10, -30], upper = [40, 20, 0] }\n";
    let program = posted_right::<Mill>("heidenhain", Mode::Axes, stock, TWO_OPERATIONS);
    assert!(program.contains("BLK FORM 0.1 Z X-10 Y-10 Z-30\n") && !program.contains(note), "{program}");
    assert!(!posted_right::<Mill>("fanuc", Mode::Axes, "", TWO_OPERATIONS).to_lowercase().contains("blank"));
}

#[test]
fn under_tip_control_a_safety_line_before_the_retract_is_found() {
    for (control, retract) in [("siemens", "SUPA G0 Z0 D0\n"), ("fanuc", "G53 G0 Z0.\n"), ("haas", "G53 G00 Z0.\n")] {
        let set_up = "retract.distance = 20\ntcp_frame = \"table_at_zero\"\n";
        let program = posted_right::<Tables>(control, Mode::Tcp, set_up, TWO_OPERATIONS);
        let name = program.find("SECOND").expect("the name");
        let at = program[..name].rfind(retract).expect("the retract");
        let without = format!("{}{}", &program[..at], &program[at + retract.len()..]);
        assert_told::<Tables>(control, Mode::Tcp, set_up, TWO_OPERATIONS, &without);
    }
}

/// The guard stops the program before an axis has moved to a position that depends on the length.
#[test]
fn a_length_guard_after_the_first_linear_axes_is_found() {
    let set_up = "retract.distance = 20\nlength_guard = true\ntools = { 1 = { length = 100 }, 2 = { length = 90 } }\n";
    for control in ["fanuc", "haas"] {
        let program = posted_right::<HeadTable>(control, Mode::Axes, set_up, TWO_OPERATIONS);
        let guard = program.lines().find(|line| line.starts_with("IF [")).expect("a guard");
        let (before, after) = program.split_once(&format!("{guard}\n")).expect("the guard");
        let down = after.find("\nG43").expect("the retract axis") + 1;
        let late = format!("{before}{}{guard}\n{}", &after[..down], &after[down..]);
        let found = again::<HeadTable>(control, Mode::Axes, set_up, TWO_OPERATIONS, &late);
        assert!(found.iter().any(|text| text.contains("the length guard comes after")), "{found:?}\n{late}");
    }
}

/// Under tip control over a tilted table a word of X alone moves the retract axis, too.
#[test]
fn the_block_that_enters_tip_control_is_one_block() {
    let data = "UNITS/MM\nLOADTL/1,LENGTH,100\nSPINDL/RPM,2000,CLW\nFEDRAT/300,MMPM\nRAPID\nGOTO/0,8,50,0.5,0.1,0.8602325\n\
                GOTO/10,5,0\nGOTO/20,0,0,0.6,0,0.8\nGOTO/20,0,50\n";
    let tip = "retract.distance = 20\ncontrol.tip_control = [\"M428\", \"M429\"]\n";
    for (control, set_up) in [("linuxcnc", tip), ("fanuc", "retract.distance = 20\ntcp_frame = \"table_at_zero\"\n")] {
        let program = posted_right::<Tables>(control, Mode::Tcp, set_up, data);
        let enters = match control {
            "linuxcnc" => program.lines().skip_while(|line| *line != "M428").nth(1),
            _ => program.lines().find(|line| line.starts_with("G0 G43.4")),
        };
        let enters = enters.expect("the block that enters tip control");
        let y = enters.find(" Y").expect("Y");
        let apart = program.replace(enters, &format!("{}\n{}", &enters[..y], &enters[y + 1..]));
        assert_told::<Tables>(control, Mode::Tcp, set_up, data, &apart);
    }
}

/// A word that comes with the retract axis only: where the other axes are is unknown before.
#[test]
fn an_axis_of_unknown_position_does_not_move_with_the_retract_axis() {
    let set_up = "retract.distance = 20\ntools = { 1 = { length = 100 }, 2 = { length = 90 } }\n";
    let data = TWO_OPERATIONS.replace(",9,", ",0,");
    for (control, mode) in [("siemens", Mode::Tcp), ("heidenhain", Mode::Tcp)] {
        let program = posted_right::<HeadTable>(control, mode, set_up, &data);
        let (start, rest) = program.split_at(program.find("SECOND").expect("the second operation"));
        let across = rest.lines().find(|line| line.contains(" Y0") || line.contains("Y+0")).expect("X and Y");
        let down = rest.lines().skip_while(|line| *line != across).nth(1).expect("Z");
        let y = if control == "siemens" { " Y0" } else { " Y+0" };
        let late = rest.replace(across, &across.replace(y, "")).replace(down, &format!("{down}{y}"));
        assert_told::<HeadTable>(control, mode, set_up, &data, &format!("{start}{late}"));
    }
}

#[test]
fn a_dwell_in_a_cut_has_the_spindle_of_the_cl_data() {
    let dwells =
        |before: &str| TWO_OPERATIONS.replacen("GOTO/20,0,0\n", &format!("GOTO/20,0,0\n{before}DELAY/1.5\n"), 1);
    let dwell = "G4 P1500\n";
    let around =
        |program: &str, before: &str, after: &str| program.replacen(dwell, &format!("{before}{dwell}{after}"), 1);
    let data = dwells("");
    let program = posted_right::<Mill>("fanuc", Mode::Axes, "retract.distance = 20\n", &data);
    assert!(program.contains(dwell), "{program}");
    for (before, after) in [("M5\n", "S2000 M3\n"), ("S500 M3\n", "S2000 M3\n"), ("S2000 M4\n", "S2000 M3\n")] {
        let changed = around(&program, before, after);
        assert_told::<Mill>("fanuc", Mode::Axes, "retract.distance = 20\n", &data, &changed);
    }
    // Both are right: before SPINDL the cut, after it the request.
    posted_right::<Mill>("fanuc", Mode::Axes, "retract.distance = 20\n", &dwells("SPINDL/RPM,900,CLW\n"));
}

/// A word of the CL data that is refused, or an option of the post that the check was not given: its motions end there.
#[test]
fn after_an_error_of_the_cl_data_nothing_is_compared() {
    for (control, mode) in [("fanuc", Mode::Axes), ("siemens", Mode::Tcp), ("heidenhain", Mode::Tcp)] {
        let set_up = "retract.distance = 20\ntcp_frame = \"table_at_zero\"\n";
        let program = posted_right::<Tables>(control, mode, set_up, TWO_OPERATIONS);
        let (control, config) = configured::<Tables>(control, mode, set_up);
        let policy = config.check_policy::<Tables>(control, None).expect("the configuration suits control and machine");
        let records: Vec<&str> = TWO_OPERATIONS.lines().collect();
        for at in 1..records.len() {
            let mut data = records.clone();
            data.insert(at, "CHUCK/OPEN");
            let compared = |program: &str| {
                check::<Tables>(&policy, Cursor::new(data.join("\n")), program.as_bytes()).expect("it can be read")
            };
            let checked = compared(&program);
            assert_eq!(checked.fault.as_ref().map(|fault| fault.location.line), Some(at as u64 + 1));
            assert_eq!(checked.outcome.findings, [], "{at}");
            assert!(!checked.passed());
            let from = checked.outcome.not_compared_from;
            let after_the_program = at + 1 >= records.len();
            assert!(from.is_some() || after_the_program, "{at}");
            let stated = from.is_none_or(|line| checked.outcome.summary().contains(&format!("from line {line} on")));
            assert!(stated, "{}", checked.outcome.summary());
            // What was cut before it is still compared.
            if at >= 10 {
                let wrong = program.replace("X20", "X21").replace("X+20", "X+21");
                assert_ne!(compared(&wrong).outcome.findings, [], "{at}\n{wrong}");
            }
        }
    }
}

/// A length that is called alone may move the tool, although another is in force when the axes move.
#[test]
fn a_length_that_is_called_between_is_found() {
    for (control, call) in [("fanuc", "G43 H1 Z50."), ("haas", "G43 H1 Z50.")] {
        let program = posted_right::<Mill>(control, Mode::Axes, "retract.distance = 20\n", TWO_OPERATIONS);
        let at = program.find(call).expect("the length");
        let between = format!("{}G43 H5\n{}", &program[..at], &program[at..]);
        assert_told::<Mill>(control, Mode::Axes, "retract.distance = 20\n", TWO_OPERATIONS, &between);
    }
}

/// On the way to tip control axes with a head go to positions that depend on the length, whatever key asks for the
/// guard.
#[test]
fn a_length_guard_that_nobody_has_asked_for_is_missed() {
    let set_up =
        "retract.distance = 20\ntcp_frame = \"table_at_zero\"\ntools = { 1 = { length = 100 }, 2 = { length = 90 } }\n";
    let data = TWO_OPERATIONS.replace("GOTO/20,0,0\n", "GOTO/20,0,0,0.1,0,0.9949874\n");
    let data = data.replace("GOTO/0,0,50\n", "GOTO/0,0,50,0,0,1\n").replace("GOTO/0,9,50\n", "GOTO/0,9,50,0,0,1\n");
    let program = posted_right::<HeadTable>("fanuc", Mode::Auto, set_up, &data);
    assert!(program.contains("G43.4"), "{program}");
    let guards: Vec<&str> = program.lines().filter(|line| line.starts_with("IF [")).collect();
    assert_eq!(guards.len(), 2, "{program}");
    for guard in guards {
        assert_told::<HeadTable>("fanuc", Mode::Auto, set_up, &data, &program.replace(&format!("{guard}\n"), ""));
    }
}

/// With nothing between them, a stop of the CL data and that of the configuration are one.
#[test]
fn an_optional_stop_takes_the_place_of_the_one_that_is_configured() {
    let set_up = "optional_stops = \"operations\"\nretract.distance = 20\n";
    let stops = |records: &str, tool: u32| {
        let data = TWO_OPERATIONS.replace("LOADTL/2\n", &format!("{records}LOADTL/{tool}\n"));
        let program = posted_right::<Mill>("fanuc", Mode::Axes, set_up, &data);
        let twice = program.replace("M1\n", "M1\nM1\n");
        if twice != program {
            assert_told::<Mill>("fanuc", Mode::Axes, set_up, &data, &twice);
        }
        program.matches("\nM1\n").count()
    };
    assert_eq!([stops("", 2), stops("OPSTOP\n", 2), stops("OPSTOP\n", 1), stops("STOP\n", 1)], [1, 1, 1, 1]);
    let after = TWO_OPERATIONS.replace("LOADTL/2\n", "LOADTL/2\nOPSTOP\n");
    // With the next tool in the spindle it is another stop.
    assert_eq!(posted_right::<Mill>("fanuc", Mode::Axes, set_up, &after).matches("\nM1\n").count(), 2);
    let same = TWO_OPERATIONS.replace("LOADTL/2\n", "LOADTL/1\nOPSTOP\n");
    assert_eq!(posted_right::<Mill>("fanuc", Mode::Axes, set_up, &same).matches("\nM1\n").count(), 1);
}

/// The tool goes up to the clearance level of a higher hole before it goes across.
#[test]
fn across_to_a_higher_hole_before_the_way_up_is_found() {
    let holes = "UNITS/MM\nLOADTL/1\nSPINDL/1000,CLW\nRAPID\nGOTO/0,0,50\nCYCLE/DRILL,DEPTH,10,CLEAR,5,MMPM,100\nGOTO/0,0,0\n\
                 GOTO/20,0,3\nCYCLE/OFF\nRAPID\nGOTO/20,0,50\n";
    let set_up = "rapid = \"split\"\ncycles.output = \"expanded\"\ncl.dialect = \"iso\"\nretract.distance = 20\n";
    let program = posted_right::<Mill>("fanuc", Mode::Axes, set_up, holes);
    let swapped = program.replace("Z8.\nX20.\n", "X20.\nZ8.\n");
    assert_ne!(swapped, program);
    assert_told::<Mill>("fanuc", Mode::Axes, set_up, holes, &swapped);
}

#[test]
fn the_guard_of_the_work_offset_comes_before_the_machine_retracts() {
    let program = posted_right::<Mill>("linuxcnc", Mode::Axes, "retract.distance = 20\n", TWO_OPERATIONS);
    let guard = program.lines().find(|line| line.contains("#5210")).expect("the guard");
    let place = program.find(guard).expect("its place");
    let retract = "G53 G0 Z0\n";
    let after = place + program[place..].find(retract).expect("the retract");
    let early =
        format!("{}{retract}{}{}", &program[..place], &program[place..after], &program[after + retract.len()..]);
    assert_told::<Mill>("linuxcnc", Mode::Axes, "retract.distance = 20\n", TWO_OPERATIONS, &early);
}

#[test]
fn a_guard_of_a_plane_whose_call_is_lost_is_found() {
    let data = &format!("{TILTED}RAPID\nGOTO/10,0,50\n");
    let set_up = "retract.distance = 20\n";
    let program = posted_right::<OneTable>("heidenhain", Mode::Tcp, set_up, data);
    let call = program.lines().find(|line| line.contains("PLANE SPATIAL")).expect("a plane call");
    assert_told::<OneTable>("heidenhain", Mode::Tcp, set_up, data, &program.replace(&format!("{call}\n"), ""));
}

/// A stop of the CL data belongs to what was cut before it, and not to the operation that is entered after it.
#[test]
fn a_stop_after_the_next_restart_point_is_found() {
    let set_up = "stop_retract = false\nretract.distance = 20\n";
    let data = TWO_OPERATIONS.replace("TOOL PATH/SECOND,TOOL,T2\nLOADTL/2\n", "OPSTOP\nTOOL PATH/SECOND,TOOL,T1\n");
    let program = posted_right::<Mill>("fanuc", Mode::Axes, set_up, &data);
    let restart = program.lines().rfind(|line| line.starts_with("N2 ")).expect("a restart point");
    let moved = program.replace("M1\n", "").replace(&format!("{restart}\n"), &format!("{restart}\nM1\n"));
    let found = again::<Mill>("fanuc", Mode::Axes, set_up, &data, &moved);
    assert!(found.iter().any(|text| text.contains("comes after the restart point")), "{found:?}\n{moved}");
}

/// The restart point ends the length offset: a retract after it would go to another height.
#[test]
fn a_retract_after_the_next_restart_point_is_found() {
    let set_up = "retract.distance = 20\n";
    let program = posted_right::<Mill>("linuxcnc", Mode::Axes, set_up, TWO_OPERATIONS);
    let restart = program.lines().find(|line| line.starts_with("N2 ")).expect("a restart point");
    let late = program.replacen("Z70\n", "", 1).replace(&format!("{restart}\n"), &format!("{restart}\nG0 Z70\n"));
    let found = again::<Mill>("linuxcnc", Mode::Axes, set_up, TWO_OPERATIONS, &late);
    let text = "comes after the restart point of the next operation";
    assert!(found.iter().any(|found| found.contains(text)), "{found:?}\n{late}");
}

/// SPINDL acts before the DELAY after it.
#[test]
fn a_speed_that_comes_after_its_dwell_is_found() {
    let data =
        TWO_OPERATIONS.replacen("GOTO/20,0,0\n", "GOTO/20,0,0\nSPINDL/RPM,900,CCLW\nDELAY/1.5\nGOTO/25,0,0\n", 1);
    let set_up = "retract.distance = 20\n";
    let program = posted_right::<Mill>("fanuc", Mode::Axes, set_up, &data);
    let late = program.replace("S900 M4\nG4 P1500\n", "G4 P1500\nS900 M4\n");
    assert_ne!(late, program);
    assert_told::<Mill>("fanuc", Mode::Axes, set_up, &data, &late);
}

const TILTED: &str = "UNITS/MM\nMULTAX/ON\nLOADTL/1\nSPINDL/1000,CLW\nRAPID\nGOTO/0,0,50,0,-0.5,0.8660254\nFEDRAT/300,MMPM\n\
                      GOTO/0,0,10\nGOTO/10,0,10,0,-0.6,0.8\n";

/// After a whole revolution the tool axis is the same, and nowhere between.
#[test]
fn a_retract_in_which_an_axis_rotates_is_found() {
    let set_up = "retract.distance = 20\n";
    for control in ["linuxcnc", "fanuc", "siemens"] {
        let program = posted_right::<OneTable>(control, Mode::Axes, set_up, TILTED);
        let lines: Vec<&str> = program.lines().collect();
        let retract = lines.iter().rposition(|line| line.starts_with("G0 Z")).expect("the retract");
        let cut = lines[..retract].iter().rev().find_map(|line| line.split(' ').find(|word| word.starts_with('A')));
        let angle: f64 = cut.expect("A in the cut")[1..].parse().expect("a number");
        let rotating = format!("{} A{}", lines[retract], angle + 360.0);
        let found = again::<OneTable>(control, Mode::Axes, set_up, TILTED, &program.replace(lines[retract], &rotating));
        assert!(found.iter().any(|text| text.contains("rotary axes rotate in this retract")), "{found:?}\n{rotating}");
    }
}

#[test]
fn parking_before_the_lines_that_end_the_operation_is_found() {
    let set_up = "retract.distance = 20\npark = { A = 0.0 }\nprogram.operation_end = [\"M78\"]\n\
                  control.effects = { M78 = \"none\" }\n";
    let program = posted_right::<OneTable>("fanuc", Mode::Axes, set_up, TILTED);
    let late = program.replace("M78\n", "").replace("G0 A0.\nM30", "G0 A0.\nM78\nM30");
    assert_eq!(late.len(), program.len());
    assert_told::<OneTable>("fanuc", Mode::Axes, set_up, TILTED, &late);
}

#[test]
fn a_plane_that_ends_before_its_motion_is_found() {
    let set_up = "retract.distance = 20\n";
    let program = posted_right::<OneTable>("heidenhain", Mode::Tcp, set_up, TILTED);
    let lines: Vec<&str> = program.lines().collect();
    let call = lines.iter().rposition(|line| line.contains("PLANE SPATIAL")).expect("a plane call");
    let off = call + lines[call..].iter().position(|line| line.contains("PLANE RESET")).expect("its end");
    let text = |line: &str| line.split_once(' ').map_or("", |(_, text)| text).to_owned();
    let number = |line: &str| line.split(' ').next().unwrap_or_default().to_owned();
    let (motion, reset) = (lines[off - 1], lines[off]);
    let swapped = format!("{} {}\n{} {}\n", number(motion), text(reset), number(reset), text(motion));
    let edited = program.replace(&format!("{motion}\n{reset}\n"), &swapped);
    let found = again::<OneTable>("heidenhain", Mode::Tcp, set_up, TILTED, &edited);
    assert!(found.iter().any(|text| text.contains("ends before a motion in it")), "{found:?}\n{edited}");
}

#[test]
fn a_spindle_that_stops_in_the_cut_is_found() {
    let set_up = "retract.distance = 20\n";
    for control in ["linuxcnc", "fanuc", "haas", "siemens"] {
        let program = posted_right::<OneTable>(control, Mode::Axes, set_up, TILTED);
        let lines: Vec<&str> = program.lines().collect();
        let is_rapid = |line: &&str| line.starts_with("G0 Z") || line.starts_with("G00 Z");
        let retract = lines.iter().rfind(|line| is_rapid(line)).expect("the retract");
        let off = if control == "haas" { "M05" } else { "M5" };
        let stopped = program.replace(&format!("{retract}\n"), &format!("{off}\n{retract}\n"));
        let found = again::<OneTable>(control, Mode::Axes, set_up, TILTED, &stopped);
        assert!(
            found.iter().any(|text| text.contains("the spindle is off before this retract")),
            "{found:?}\n{stopped}"
        );
    }
}

#[test]
fn an_approach_with_many_revolutions_is_found() {
    let (set_up, data) = ("retract.distance = 20\n", TILTED.repeat(2));
    let program = posted_right::<OneTable>("fanuc", Mode::Axes, set_up, &data);
    let place = program.rfind("G0 A").expect("a rotary axis alone");
    let line = program[place..].lines().next().expect("its line");
    let angle: f64 = line[4..].parse().expect("a number");
    let far = format!("{}G0 A{:?}{}", &program[..place], angle + 3600.0, &program[place + line.len()..]);
    let found = again::<OneTable>("fanuc", Mode::Axes, set_up, &data, &far);
    assert!(found.iter().any(|text| text.contains("by more than two revolutions")), "{found:?}\n{far}");
}

#[test]
fn a_code_of_the_spindle_between_the_holes_of_rigid_tapping_is_found() {
    let data = "UNITS/MM\nLOADTL/1\nSPINDL/500,CLW\nRAPID\nGOTO/0,0,50\nCYCLE/TAP,DEPTH,10,CLEAR,5,MMPR,1.25\nGOTO/0,0,0\n\
                GOTO/20,0,0\nCYCLE/OFF\nRAPID\nGOTO/20,0,50\n";
    let set_up = "cycles.rigid = true\ncl.dialect = \"iso\"\nretract.distance = 20\n";
    let program = posted_right::<Mill>("fanuc", Mode::Axes, set_up, data);
    let tap = program.lines().find(|line| line.contains("G84")).expect("a thread");
    let edited = program.replace(&format!("{tap}\n"), &format!("{tap}\nS500 M3\n"));
    let found = again::<Mill>("fanuc", Mode::Axes, set_up, data, &edited);
    assert!(found.iter().any(|text| text.contains("between the holes of rigid tapping")), "{found:?}\n{edited}");
}

/// The next program, and the operator, find the modes in which this one ends.
#[test]
fn a_mode_that_is_left_at_the_end_is_found() {
    let set_up = "retract.distance = 20\n";
    for (control, end, modes) in [
        ("fanuc", "M30", &["G91", "G20", "G18", "G95", "G93"][..]),
        ("haas", "M30", &["G91", "G20", "G18", "G95"]),
        ("siemens", "M30", &["G91", "G18", "G95", "G93"]),
        ("linuxcnc", "M2", &["G91", "G20", "G18", "G95"]),
    ] {
        let program = posted_right::<Mill>(control, Mode::Axes, set_up, TWO_OPERATIONS);
        for mode in modes {
            let left = program.replace(&format!("{end}\n"), &format!("{mode}\n{end}\n"));
            assert_ne!(left, program);
            assert_told::<Mill>(control, Mode::Axes, set_up, TWO_OPERATIONS, &left);
        }
    }
}

#[test]
fn a_length_of_the_next_tool_before_its_change_is_found() {
    let set_up = "retract.distance = 20\n";
    let program = posted_right::<Mill>("fanuc", Mode::Axes, set_up, TWO_OPERATIONS);
    let early = program.replace("T2 M6\n", "G43 H2\nT2 M6\n");
    let found = again::<Mill>("fanuc", Mode::Axes, set_up, TWO_OPERATIONS, &early);
    assert!(found.iter().any(|text| text.contains("before the change to T2")), "{found:?}\n{early}");
}
