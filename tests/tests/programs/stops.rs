//! Optional stops that the configuration adds after operations and before tool changes: where they are, and a check that
//! misses none and takes no other.

use machines::SpinnerU5620;
use pp_runtime::config::{Config, starting_point};
use pp_runtime::control::{self, Control};
use pp_runtime::motion::Operations;
use tests::posting::{self, bare, written};

/// Five operations with two tools; the third ends with an optional stop, the fourth begins with a stop.
const CL: &str = "UNITS/MM
TOOL PATH/OP1,TOOL,T
LOADTL/1,LENGTH,100
SPINDL/RPM,2000,CLW
CUT
TOOL PATH/OP2,TOOL,T
LOADTL/1
CUT
TOOL PATH/OP3,TOOL,U
LOADTL/2,LENGTH,110
SPINDL/RPM,1000,CLW
CUT
OPSTOP
TOOL PATH/OP4,TOOL,U
CUT
STOP
LOADTL/1
SPINDL/RPM,2000,CLW
CUT
FINI
";

const CUT: &str = "RAPID
GOTO/0,0,30,0,0,1
FEDRAT/MMPM,300
GOTO/0,0,20
RAPID
GOTO/0,0,60
";

fn cl() -> String {
    CL.replace("CUT\n", CUT)
}

fn config(control: &dyn Control, stops: &str, retract: bool) -> Config {
    let text = format!("mode = 'axes'\noptional_stops = '{stops}'\nstop_retract = {retract}\n");
    starting_point(control).read_over(&SpinnerU5620::default(), &text).unwrap_or_else(|faults| panic!("{faults:?}"))
}

fn findings(config: &Config, control: &dyn Control, program: &str) -> Vec<String> {
    posting::findings::<SpinnerU5620>(config, control, &cl(), program)
}

fn posted(config: &Config, control: &'static dyn Control) -> String {
    posting::posted::<SpinnerU5620>(config, control, &cl())
}

/// Stops, and the operations in whose blocks they are: that of the last name before each.
fn stops<'p>(program: &'p str, codes: &[&'static str; 2]) -> Vec<(&'p str, usize)> {
    let mut operation = 0;
    let mut found = Vec::new();
    for line in bare(program) {
        if let Some(number) = (1..=4).find(|number| line.contains(&format!("OP{number}"))) {
            operation = number;
        }
        if codes.contains(&line) {
            found.push((line, operation));
        }
    }
    found
}

#[test]
fn optional_stops_come_after_operations_or_before_tool_changes() {
    for control in control::CONTROLS {
        let codes = control.spellings().stop;
        let [stop, optional] = codes;
        for retract in [true, false] {
            for (name, expected) in [
                ("none", vec![(optional, 3), (stop, 4)]),
                // The name of an operation comes before its tool.
                ("tool_changes", vec![(optional, 3), (optional, 3), (stop, 4)]),
                ("operations", vec![(optional, 1), (optional, 2), (optional, 3), (stop, 4)]),
            ] {
                let program = posted(&config(*control, name, retract), *control);
                assert_eq!(stops(&program, &codes), expected, "{} {name}\n{program}", control.spellings().name);
            }
        }
    }
}

/// Operations of two tools and again of the first, with the same statements after the first two.
fn with_between(between: &str) -> String {
    let cut =
        |tool: u32| format!("TOOL PATH/OP,TOOL,T\nLOADTL/{tool},LENGTH,100\nSPINDL/RPM,2000,CLW\n{}SPINDL/OFF\n", CUT);
    ["UNITS/MM\n", &cut(1), between, &cut(2), between, &cut(1), "FINI\n"].concat()
}

/// Optional stops of a program, as they are marked, with findings where the program without them is checked.
fn optional_stops(control: &'static dyn Control, key: &str, cl: &str) -> Vec<String> {
    let [with, without] = [key, "none"].map(|key| {
        let text = format!(
            "mode = 'axes'\nretract.distance = 20\nlength_guard = false\noptional_stops = '{key}'\n[cycles.probe]\n\
             'PROBE/BORE' = ['M77']\n"
        );
        starting_point(control).read_over(&SpinnerU5620::default(), &text).unwrap_or_else(|faults| panic!("{faults:?}"))
    });
    let lost = posting::posted::<SpinnerU5620>(&without, control, cl);
    assert!(!posting::findings::<SpinnerU5620>(&with, control, cl, &lost).is_empty(), "{lost}");
    let [_, optional] = control.spellings().stop;
    let program = posting::posted::<SpinnerU5620>(&with, control, cl);
    let text = |line: &str| line.replace(|c: char| c.is_ascii_whitespace() || c == '/', "");
    let is_stop = |line: &&str| bare(&text(line)) == [optional];
    let mark = |line: &str| if line.contains('/') { "/" } else { "" };
    program.lines().filter(is_stop).map(|line| format!("{}{optional}", mark(line))).collect()
}

#[test]
fn what_comes_between_two_operations_takes_no_optional_stop_away() {
    let on = format!("SPINDL/RPM,2000,CLW\n{CUT}SPINDL/OFF\n");
    let skipped = format!("OPSKIP/ON\n{on}OPSKIP/OFF\n");
    for control in control::CONTROLS {
        for key in ["tool_changes", "operations"] {
            for between in ["GOHOME\n", "RAPID\nGOTO/0,0,70\nPROBE/BORE\n", &skipped] {
                let stops = optional_stops(*control, key, &with_between(between));
                assert_eq!(stops.len(), 2, "{} {key} {between}", control.spellings().name);
            }
        }
    }
}

#[test]
fn a_tool_change_has_its_optional_stop_whether_blocks_before_it_are_skipped_or_not() {
    let other = format!("OPSKIP/ON\nTOOL PATH/OP,TOOL,U\nLOADTL/2,LENGTH,100\nSPINDL/RPM,900,CLW\n{CUT}OPSKIP/OFF\n");
    let stop = format!("OPSKIP/ON\nSPINDL/RPM,900,CLW\n{CUT}OPSTOP\nOPSKIP/OFF\n");
    for control in control::CONTROLS {
        let [_, optional] = control.spellings().stop;
        let marked = format!("/{optional}");
        // The second call of T2 is a change where the first was skipped.
        let stops = optional_stops(*control, "tool_changes", &with_between(&other));
        assert_eq!(stops, [&marked, optional, optional], "{}", control.spellings().name);
        let stops = optional_stops(*control, "tool_changes", &with_between(&stop));
        assert_eq!(stops, [&marked, optional, &marked, optional]);
    }
}

#[test]
fn a_stop_that_is_lost_or_another_one_is_found() {
    for control in control::CONTROLS {
        let [stop, optional] = control.spellings().stop;
        let [none, all] = ["none", "operations"].map(|name| config(*control, name, true));
        let program = posted(&all, *control);
        assert!(!findings(&none, *control, &program).is_empty());
        assert!(!findings(&all, *control, &posted(&none, *control)).is_empty());
        let numbered = control.spellings().numbers_every_line;
        let lines: Vec<&str> = program.lines().collect();
        let is_optional = |line: &str| bare(line)[0] == optional;
        for at in (0..lines.len()).filter(|&at| is_optional(lines[at])) {
            // A comment keeps the numbers of the lines.
            let lost = if numbered { lines[at].replace(optional, "; NO STOP") } else { String::new() };
            for line in [lost, lines[at].replace(optional, stop)] {
                let edited = [&lines[..at], &[line.as_str()], &lines[at + 1..]].concat().join("\n");
                assert!(!findings(&all, *control, &edited).is_empty(), "{edited}");
            }
        }
    }
}

#[test]
fn selected_operations_end_without_a_stop() {
    for control in control::CONTROLS {
        let [_, optional] = control.spellings().stop;
        let mut config = config(*control, "operations", true);
        config.motion.selected = Some(Operations::Range(1, Some(2)));
        let program = posted(&config, *control);
        assert_eq!(stops(&program, &control.spellings().stop), [(optional, 1)], "{program}");
    }
}

/// Texts for the operator before, in and between operations; one with signs that not every control has.
fn cl_with_texts() -> String {
    let text = cl().replace("TOOL PATH/OP2,", "PPRINT CHECK THE CLAMPS\nTOOL PATH/OP2,");
    let long = "PPRINT TURN THE PART BY 90° (SIDE \"B\")\nSTOP";
    text.replace("STOP\nLOADTL", &format!("{long}\nLOADTL")).replacen("FEDRAT", "PPRINT START\nFEDRAT", 1)
}

fn displaying(control: &dyn Control, key: &str) -> Config {
    let text = format!("part_origin = [0.0, 0.0, 0.0]\nmode = 'axes'\n[program]\nmessages = '{key}'\n");
    starting_point(control).read_over(&SpinnerU5620::default(), &text).unwrap_or_else(|faults| panic!("{faults:?}"))
}

fn with_texts(config: &Config, control: &'static dyn Control) -> String {
    let (program, report) = written::<SpinnerU5620>(config, control, &cl_with_texts()).expect("it can run");
    assert!(!report.failed, "{program}\n{:?}", report.diagnostics);
    program
}

fn findings_with_texts(config: &Config, control: &dyn Control, program: &str) -> Vec<String> {
    posting::findings::<SpinnerU5620>(config, control, &cl_with_texts(), program)
}

#[test]
fn texts_are_displayed_where_the_control_displays_them() {
    for (name, texts) in [
        ("linuxcnc", ["(MSG, START)", "(MSG, CHECK THE CLAMPS)", "(MSG, TURN THE PART BY 90 deg [SIDE \"B\"])"]),
        ("siemens", ["MSG(\"START\")", "MSG(\"CHECK THE CLAMPS\")", "MSG(\"TURN THE PART BY 90 deg (SIDE 'B')\")"]),
    ] {
        let control = control::by_name(name).expect("a control");
        let config = displaying(control, "display");
        let program = with_texts(&config, control);
        assert!(findings_with_texts(&config, control, &program).is_empty());
        let lines: Vec<&str> = program.lines().collect();
        let places =
            texts.map(|text| lines.iter().position(|line| *line == text).unwrap_or_else(|| panic!("{program}")));
        assert!(places.is_sorted(), "{program}");
        for (at, other) in places.into_iter().zip(texts.into_iter().cycle().skip(1)) {
            let lost = [&lines[..at], &lines[at + 1..]].concat().join("\n");
            let changed = [&lines[..at], &[other], &lines[at + 1..]].concat().join("\n");
            let twice = [&lines[..at], &[lines[at], lines[at]], &lines[at + 1..]].concat().join("\n");
            for edited in [lost, changed, twice] {
                assert!(!findings_with_texts(&config, control, &edited).is_empty(), "{edited}");
            }
        }
        // As comments they are no part of what is compared.
        let plain = displaying(control, "comment");
        assert!(!findings_with_texts(&config, control, &with_texts(&plain, control)).is_empty());
    }
    for name in ["fanuc", "haas", "heidenhain"] {
        let control = control::by_name(name).expect("a control");
        let config = displaying(control, "display");
        // Left out and named; the texts are comments.
        assert!(
            config
                .for_control(control)
                .left_out
                .iter()
                .any(|text| text.contains("displays a text only where the program stops"))
        );
    }
}

#[test]
fn an_operation_with_blocks_of_the_shop_at_its_end_stops_after_them() {
    for control in control::CONTROLS {
        let text = "mode = 'axes'\noptional_stops = 'operations'\n[program]\noperation_end = ['M77']\n[control]\n\
                    effects = { M77 = 'none' }\n";
        let config = starting_point(*control).read_over(&SpinnerU5620::default(), text).expect("it can be read");
        let program = posted(&config, *control);
        let codes = control.spellings().stop;
        let [stop, optional] = codes;
        let expected = [(optional, 1), (optional, 2), (optional, 3), (stop, 4)];
        assert_eq!(stops(&program, &codes), expected, "{program}");
        let lines = bare(&program);
        for at in (0..lines.len()).filter(|&at| codes.contains(&lines[at])) {
            assert!(lines[..at].iter().rposition(|line| *line == "M77").is_some_and(|end| at - end < 6), "{program}");
        }
    }
}

#[test]
fn a_stop_in_the_lines_of_the_shop_is_asked_for_by_them() {
    for control in control::CONTROLS {
        let [stop, _] = control.spellings().stop;
        for key in [
            "program.start",
            "program.end",
            "program.operation_start",
            "program.operation_end",
            "tools.1.start",
            "tools.2.end",
        ] {
            // The spindle may be on where one operation ends and the next begins.
            let off = if control.spellings().name == "haas" { "M05" } else { "M5" };
            let off = if key.contains("operation") { format!("'{off}', ") } else { String::new() };
            let text = format!("mode = 'axes'\nlength_guard = false\n{key} = [{off}'{stop}']\n");
            let config = starting_point(*control)
                .read_over(&SpinnerU5620::default(), &text)
                .unwrap_or_else(|faults| panic!("{faults:?}"));
            // It passes its check, which finds the stop lost, and one more at the part.
            let program = posted(&config, *control);
            let codes: Vec<&str> = bare(&program);
            let stops: Vec<usize> = (0..codes.len()).filter(|&at| codes[at] == stop).collect();
            assert!(stops.len() > 1, "{key}\n{program}");
            let cut = codes.iter().position(|line| line.contains("F300")).expect("a cut");
            let more = posting::renumbered(*control, &[&codes[..=cut], &[stop], &codes[cut + 1..]].concat());
            assert!(!findings(&config, *control, &more).is_empty(), "{key}\n{more}");
            for at in stops {
                let lost = posting::renumbered(*control, &[&codes[..at], &codes[at + 1..]].concat());
                assert!(!findings(&config, *control, &lost).is_empty(), "{key}\n{lost}");
            }
        }
    }
}
