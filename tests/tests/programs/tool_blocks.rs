//! Blocks of the shop for a tool, on every control: it is measured, its conveyor starts and stops, and it is checked for
//! breakage. Their places in a program, and a check that finds them lost, misplaced, and for another tool.

use machines::SpinnerU5620;
use pp_runtime::config::{Config, starting_point};
use pp_runtime::control::{self, Control};
use pp_runtime::motion::Operations;
use tests::posting::{self, bare, posted, renumbered, without};

/// Three operations, the first and the last with tool 1.
const CL: &str = "UNITS/MM
TOOL PATH/OP1,TOOL,T
LOADTL/1,LENGTH,100
SPINDL/RPM,2000,CLW
COOLNT/ON
CUT
TOOL PATH/OP2,TOOL,U
LOADTL/2,LENGTH,110
SPINDL/RPM,1000,CLW
CUT
TOOL PATH/OP3,TOOL,T
LOADTL/1
SPINDL/RPM,2000,CLW
CUT
TOOL PATH/OP4,TOOL,T
LOADTL/1
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

const CONTROLS: [&str; 5] = ["linuxcnc", "fanuc", "haas", "siemens", "heidenhain"];

fn cl() -> String {
    CL.replace("CUT\n", CUT)
}

fn by_name(name: &str) -> &'static dyn Control {
    control::by_name(name).expect("a control")
}

/// Blocks as shops have them: macros of Fanuc and Haas with words, a call of a program elsewhere.
fn blocks(name: &str) -> [&'static str; 2] {
    match name {
        "fanuc" | "haas" => ["G65 P9023 A12. T{tool} H{offset}", "G65 P9023 A22. T{tool} H{offset}"],
        "siemens" => ["MEASURE_TOOL({tool})", "CHECK_TOOL({tool})"],
        "heidenhain" => ["CALL PGM TNC:\\MEASURE.H", "CALL PGM TNC:\\CHECK.H"],
        _ => ["M471 P{tool} Q{offset}", "M472 P{tool} Q{offset}"],
    }
}

/// The blocks up to their first field.
fn starts(name: &str) -> [&'static str; 2] {
    blocks(name).map(|block| block.split('{').next().unwrap_or_default())
}

fn config(name: &str, keys: &str) -> Config {
    let [measure, check] = blocks(name);
    // There the length is that of the tool's row.
    let register = if name == "heidenhain" { "" } else { "offset = 12, " };
    let text = format!(
        "mode = 'axes'\n{keys}\n[cycles]\nmeasure_tool = ['{measure}']\ncheck_tool = ['{check}']\n\
         [control]\neffects = {{ M31 = 'none', M33 = 'none' }}\n\
         [tools]\n1 = {{ measured = true, checked = true, {register}start = ['M31'], end = ['M33'] }}\n2 = {{ checked = true }}\n"
    );
    starting_point(by_name(name))
        .read_over(&SpinnerU5620::default(), &text)
        .unwrap_or_else(|faults| panic!("{faults:?}"))
}

/// Whether a line moves an axis in machine coordinates.
fn retracts(line: &str) -> bool {
    ["G53", "SUPA", "M91"].iter().any(|code| line.contains(code))
}

/// A block with the values of a tool.
fn of(block: &str, tool: u32) -> String {
    let register = if tool == 1 { 12 } else { tool };
    block.replace("{tool}", &tool.to_string()).replace("{offset}", &register.to_string())
}

#[test]
fn a_tool_is_measured_after_its_change_and_checked_when_it_has_cut() {
    for name in CONTROLS {
        let config = config(name, "");
        let program = posted::<SpinnerU5620>(&config, by_name(name), &cl());
        let [measure, check] = blocks(name);
        let wanted = [
            (of(measure, 1), 1),
            ("M31".to_owned(), 1),
            ("M33".to_owned(), 1),
            (of(check, 1), 1),
            (of(check, 2), 2),
            (of(measure, 1), 1),
            ("M31".to_owned(), 1),
            ("M33".to_owned(), 1),
            (of(check, 1), 1),
        ];
        let lines = bare(&program);
        let found = lines.iter().filter(|line| wanted.iter().any(|(text, _)| text == *line));
        assert_eq!(found.collect::<Vec<_>>(), wanted.iter().map(|(text, _)| text).collect::<Vec<_>>(), "{program}");
    }
}

/// Blocks around those of the shop where tool 1 is changed for tool 2, from the retract on, to the safety line of tool 2.
const AT_THE_CHANGE: &[(&str, [&str; 6])] = &[
    ("linuxcnc", ["M9", "G53 G0 Z0", "M5", "M33", "G53 G0 Z0", "M472 P1 Q12"]),
    ("fanuc", ["M9", "G49 G53 G0 Z0.", "M5", "M33", "G49 G53 G0 Z0.", "G65 P9023 A22. T1 H12"]),
    ("haas", ["M09", "G49 G53 G00 Z0.", "M05", "M33", "G49 G53 G00 Z0.", "G65 P9023 A22. T1 H12"]),
    ("siemens", ["M9", "SUPA G0 Z0 D0", "M5", "M33", "SUPA G0 Z0 D0", "CHECK_TOOL(1)"]),
    ("heidenhain", ["M9", "L Z+0 R0 FMAX M91", "M5", "M33", "L Z+0 R0 FMAX M91", "CALL PGM TNC:\\CHECK.H"]),
];

#[test]
fn the_machine_retracts_before_and_after_the_blocks_with_spindle_and_coolant_off() {
    for (name, expected) in AT_THE_CHANGE {
        let program = posted::<SpinnerU5620>(&config(name, ""), by_name(name), &cl());
        let lines = bare(&program);
        let at = lines.windows(expected.len()).position(|lines| lines == expected);
        let after = &lines[at.unwrap_or_else(|| panic!("{name}\n{program}")) + expected.len()..];
        // The safety line again, without a number, then the retract.
        let safety = lines.iter().position(|line| line.starts_with("N1 ") || *line == "M129").expect("a restart point");
        let retract = after.iter().position(|line| retracts(line)).expect("a retract");
        assert_eq!(after[0], lines[safety].trim_start_matches("N1 "), "{name}\n{program}");
        assert!((1..=6).contains(&retract), "{name}\n{program}");
    }
}

#[test]
fn a_lost_block_and_one_for_another_tool_are_found() {
    for name in CONTROLS {
        let (control, config) = (by_name(name), config(name, ""));
        let program = posted::<SpinnerU5620>(&config, control, &cl());
        let found = |edited: &str| posting::findings::<SpinnerU5620>(&config, control, &cl(), edited);
        let starts = starts(name);
        let is_of_shop =
            |line: &str| line == "M31" || line == "M33" || starts.iter().any(|start| line.starts_with(start));
        let shorter = without(&program, control, |rest| is_of_shop(rest[0]));
        assert_eq!(shorter.len(), 9, "{name}\n{program}");
        for edited in shorter {
            assert!(!found(&edited).is_empty(), "{name}\n{edited}");
        }
        // The retract after each of them.
        let lines = bare(&program);
        let shop = (0..lines.len()).filter(|&at| is_of_shop(lines[at]));
        let after: Vec<usize> =
            shop.map(|at| at + lines[at..].iter().position(|line| retracts(line)).expect("a retract")).collect();
        assert_eq!(after.len(), 9, "{name}\n{program}");
        // Others follow before an axis moves after all but the last.
        let lost = after.iter().filter(|&&at| {
            let edited = renumbered(control, &[&lines[..at], &lines[at + 1..]].concat());
            !found(&edited).is_empty()
        });
        assert_eq!(lost.copied().last(), after.last().copied(), "{name}\n{program}");
        for (at, line) in lines.iter().enumerate().filter(|(_, line)| is_of_shop(line)) {
            for (was, is) in [("T1", "T2"), ("H12", "H1"), ("P1", "P2"), ("Q12", "Q1"), ("(1)", "(2)"), ("M31", "M33")]
            {
                if line.contains(was) {
                    let other = line.replace(was, is);
                    let mut edited = lines.clone();
                    edited[at] = &other;
                    assert!(!found(&renumbered(control, &edited)).is_empty(), "{name}: {other}\n{program}");
                }
            }
        }
        // The modes after the macros, which may have changed them, lost and changed.
        let mut restated = 0;
        for at in (0..lines.len()).filter(|&at| starts.iter().any(|start| lines[at].starts_with(start))) {
            let end = at + lines[at..].iter().position(|line| retracts(line)).expect("a retract");
            assert!(end > at + 1, "{name}\n{program}");
            for line in at + 1..end {
                let lost = [&lines[..line], &lines[line + 1..]].concat();
                // After the check of a tool a restart point follows, before any motion in the work offset.
                let is_measured = lines[at].starts_with(starts[0]);
                // Codes off of what is off, before the line of the modes.
                let is_off = ["TRAFOOF", "CYCLE800()", "M129", "PLANE RESET STAY", "M127", "G69"]
                    .contains(&lines[line])
                    || !is_measured && ["M9", "M09"].contains(&lines[line]);
                assert!(is_off || !found(&renumbered(control, &lost)).is_empty(), "{name}: {}\n{program}", lines[line]);
                restated += usize::from(!is_off);
                for (was, is) in [
                    ("G40 ", ""),
                    ("G40 G64", "G64"),
                    ("G54", "G55"),
                    ("G90", "G91"),
                    ("G17", "G18"),
                    ("Q339=+1", "Q339=+2"),
                ] {
                    let other = lines[line].replace(was, is);
                    let mut edited = lines.clone();
                    edited[line] = &other;
                    let found = edited == lines || !is_measured || !found(&renumbered(control, &edited)).is_empty();
                    assert!(found, "{name}: {other}\n{program}");
                }
            }
        }
        assert!(restated >= 5, "{name}\n{program}");
        // The start of tool 1 where tool 2 is in the spindle.
        let mut checks = (0..lines.len()).filter(|&at| lines[at].starts_with(starts[1]));
        let second = checks.nth(1).expect("the check of tool 2");
        let edited = renumbered(control, &[&lines[..second], &["M31"], &lines[second..]].concat());
        let told = found(&edited).join("\n");
        assert!(told.contains("a line of another tool in `[tools]`, but T2 is in the spindle"), "{name}: {told}");
    }
}

#[test]
fn chosen_operations_measure_their_tools_alone_and_check_them_at_their_end() {
    for name in CONTROLS {
        let mut config = config(name, "");
        config.motion.selected = Some(Operations::Range(2, Some(3)));
        let program = posted::<SpinnerU5620>(&config, by_name(name), &cl());
        let lines = bare(&program);
        let count = |start: &str| lines.iter().filter(|line| line.starts_with(start)).count();
        let [measure, check] = starts(name);
        assert_eq!([measure, "M31", "M33", check].map(count), [1, 1, 1, 2], "{name}\n{program}");
    }
}

#[test]
fn a_dry_run_measures_nothing() {
    for name in CONTROLS {
        let mut config = config(name, "");
        config.motion.lift_mm = Some(50.0);
        let program = posted::<SpinnerU5620>(&config, by_name(name), &cl());
        let lines = bare(&program);
        let [measure, check] = starts(name);
        assert!(!lines.iter().any(|line| line.starts_with(measure) || line.starts_with(check)), "{name}\n{program}");
        assert_eq!(lines.iter().filter(|line| **line == "M31").count(), 2, "{name}\n{program}");
    }
}

#[test]
fn a_tool_to_be_measured_needs_the_blocks_for_it() {
    let text = "mode = 'axes'\ntools = { 1 = { measured = true }, 2 = { checked = true, start = ['M31 P{tol}'] } }\n";
    for name in CONTROLS {
        let control = by_name(name);
        let config = starting_point(control).read_over(&SpinnerU5620::default(), text).expect("it can be read");
        let refused = control::unfit(&SpinnerU5620::default(), control, config.demands());
        let expected = [
            "T1 has `measured = true`, but `cycles.measure_tool` has no blocks for it: give those of the machine",
            "T2 has `checked = true`, but `cycles.check_tool` has no blocks for it: give those of the machine",
            "in the block `M31 P{tol}` of `[tools.2]` `{tol}` is not a field of this block",
        ];
        assert_eq!(refused, expected, "{name}");
    }
}

/// Cycles of several lines, with comments, and the tool by its name and its number.
const CYCLES: &str = "mode = 'axes'
[cycles]
measure_tool = [
    'TCH PROBE 483 MEASURE TOOL ~',
    '  Q340=+1 ;CHECK ~',
    '  Q260=+50 ;CLEARANCE HEIGHT ~',
    '  Q341=+0',
    'CALL PGM TNC:\\ROW{tool_number}.H',
]
check_tool = ['TCH PROBE 481 LENGTH ~', '  Q340=+{tool_number} ~', '  Q260=+50']
[cycles.probe]
'PROBE/BORE' = ['TCH PROBE 421 MEASURE HOLE ~', 'Q273=+50 ;CENTRE ~', 'Q274=+50', 'CALL PGM TNC:\\BORE.H']
[control]
tool_names = true
[tools]
1 = { name = 'MILL', measured = true, checked = true }
2 = { name = 'DRILL', start = ['TCH PROBE 582 ~', '  Q1=+{tool_number} ~', '  Q2=+5'] }
";

#[test]
fn a_cycle_of_several_lines_is_one_block() {
    let (control, machine) = (by_name("heidenhain"), SpinnerU5620::default());
    let cl = cl().replacen("TOOL PATH/OP3", "SPINDL/OFF\nCOOLNT/OFF\nRAPID\nGOTO/0,0,50\nPROBE/BORE\nTOOL PATH/OP3", 1);
    let keys = CYCLES
        .replace("[control]", "[control]\neffects = { 'TCH PROBE 582 ~ Q1=+{tool_number} ~ Q2=+5' = 'measures' }");
    let config = starting_point(control).read_over(&machine, &keys).unwrap_or_else(|faults| panic!("{faults:?}"));
    let program = posted::<SpinnerU5620>(&config, control, &cl);
    for written in [
        "TCH PROBE 483 MEASURE TOOL ~\n  Q340=+1 ;CHECK ~\n  Q260=+50 ;CLEARANCE HEIGHT ~\n  Q341=+0\n",
        "CALL PGM TNC:\\ROW1.H\n",
        "TCH PROBE 481 LENGTH ~\n  Q340=+1 ~\n  Q260=+50\n",
        "TCH PROBE 421 MEASURE HOLE ~\nQ273=+50 ;CENTRE ~\nQ274=+50\n",
        "TCH PROBE 582 ~\n  Q1=+2 ~\n  Q2=+5\n",
        "TOOL CALL \"MILL\" Z",
    ] {
        assert!(program.contains(written), "{written}\n{program}");
    }
    // Each of their lines, lost or changed, and each whole block.
    let lines = bare(&program);
    let found = |lines: &[&str]| posting::findings::<SpinnerU5620>(&config, control, &cl, &renumbered(control, lines));
    assert_eq!(found(&lines), [""; 0]);
    let is_of_cycle = |line: &str| line.starts_with("TCH PROBE") || line.starts_with('Q') && !line.starts_with("Q339");
    let of_cycles: Vec<usize> = (0..lines.len()).filter(|&at| is_of_cycle(lines[at])).collect();
    assert_eq!(of_cycles.len(), 2 * 4 + 3 * 3 + 3, "{program}");
    for at in of_cycles {
        let lost = [&lines[..at], &lines[at + 1..]].concat();
        assert!(!found(&lost).is_empty(), "{}\n{program}", lines[at]);
        for (was, is) in [("=+1", "=+2"), ("=+5", "=+6"), ("=+0", "=+1"), ("PROBE 4", "PROBE 3"), (" ~", "")] {
            let other = lines[at].replacen(was, is, 1);
            let mut edited = lines.clone();
            edited[at] = &other;
            assert!(edited == lines || !found(&edited).is_empty(), "{other}\n{program}");
        }
        let mut end = at;
        while lines[end].ends_with('~') {
            end += 1;
        }
        assert!(!found(&[&lines[..at], &lines[end + 1..]].concat()).is_empty(), "{}\n{program}", lines[at]);
    }
    // Without a declared effect the lines of the tool are refused, and the effect that is named for them is accepted.
    let undeclared = starting_point(control).read_over(&machine, CYCLES).unwrap_or_else(|faults| panic!("{faults:?}"));
    let told = posting::findings::<SpinnerU5620>(&undeclared, control, &cl, &program).join("\n");
    assert!(told.contains("`\"TCH PROBE 582 Q1=+{tool_number} Q2=+5\" = \"none\"`"), "{told}");
    let named =
        CYCLES.replace("[control]", "[control]\neffects = { 'TCH PROBE 582 Q1=+{tool_number} Q2=+5' = 'measures' }");
    let named = starting_point(control).read_over(&machine, &named).unwrap_or_else(|faults| panic!("{faults:?}"));
    assert_eq!(posting::findings::<SpinnerU5620>(&named, control, &cl, &program), [""; 0]);
}

#[test]
fn every_value_of_a_field_is_compared() {
    let text = "mode = 'axes'\n[cycles]\nmeasure_tool = ['MEASURE({tool},{tool_number},{offset},{tool_number})']\n[control]\ntool_names = true\n\
                [tools]\n1 = { name = 'MILL', measured = true }\n2 = { name = 'DRILL', measured = true }\n";
    let control = by_name("siemens");
    let config =
        starting_point(control).read_over(&SpinnerU5620::default(), text).unwrap_or_else(|faults| panic!("{faults:?}"));
    let program = posted::<SpinnerU5620>(&config, control, &cl());
    assert!(program.contains("MEASURE(\"DRILL\",2,1,2)"), "{program}");
    for other in [
        "MEASURE(\"MILL\",2,1,2)",
        "MEASURE(\"DRILL\",1,1,2)",
        "MEASURE(\"DRILL\",2,1,1)",
        "MEASURE(\"DRILL\",1,1,1)",
        "MEASURE(\"DRILL\",2,2,2)",
    ] {
        let edited = program.replacen("MEASURE(\"DRILL\",2,1,2)", other, 1);
        let found = posting::findings::<SpinnerU5620>(&config, control, &cl(), &edited);
        assert!(!found.is_empty(), "{other}\n{program}");
    }
}

#[test]
fn a_block_that_no_line_continues_and_one_of_several_lines_on_another_control_are_refused() {
    let machine = SpinnerU5620::default();
    let open = "[program]\nend = ['TCH PROBE 483 ~', '  Q340=+1 ~']\n";
    let faults = starting_point(by_name("heidenhain")).read_over(&machine, open).expect_err("a line is missing");
    assert!(format!("{faults:?}").contains("no line follows"), "{faults:?}");
    for name in CONTROLS {
        let text = "[program]\nend = ['O9001 ~', '  Q340=+1']\n";
        let config = starting_point(by_name(name)).read_over(&machine, text).expect("it can be read");
        let refused = control::unfit(&machine, by_name(name), config.demands());
        assert_eq!(
            refused.iter().any(|text| text.contains("`O9001 ~   Q340=+1` is a line of Heidenhain")),
            name != "heidenhain",
            "{name}: {refused:?}"
        );
    }
}

/// A motion of each control.
fn motions(name: &str) -> [&'static str; 3] {
    match name {
        "heidenhain" => ["L Z-480 R0 FMAX M91", "L C-90 R0 FMAX", "L IZ-300 R0 FMAX"],
        "siemens" => ["SUPA G0 Z-480 D0", "G0 C-90", "G0 Z=IC(-300)"],
        "haas" | "fanuc" => ["G53 G0 Z-480.", "G0 C-90.", "G91 G0 Z-300."],
        _ => ["G53 G0 Z-480", "G0 C-90", "G91 G0 Z-300"],
    }
}

#[test]
fn a_motion_among_the_lines_that_measure_is_a_motion() {
    for name in CONTROLS {
        let [measure, check] = blocks(name);
        for motion in motions(name) {
            for (measure, check) in [
                (format!("'{measure}', '{motion}'"), format!("'{check}'")),
                (format!("'{measure}'"), format!("'{motion}'")),
            ] {
                let text = format!(
                    "mode = 'axes'\n[cycles]\nmeasure_tool = [{measure}]\ncheck_tool = [{check}]\n[tools]\n\
                     1 = {{ measured = true, checked = true, {}}}\n",
                    if name == "heidenhain" { "" } else { "offset = 12" }
                );
                let config = starting_point(by_name(name)).read_over(&SpinnerU5620::default(), &text).expect("read");
                let (program, report) =
                    posting::written::<SpinnerU5620>(&config, by_name(name), &cl()).expect("it can run");
                assert!(!report.failed, "{program}");
                let found = posting::findings::<SpinnerU5620>(&config, by_name(name), &cl(), &program);
                assert!(!found.is_empty(), "{name} {motion}\n{program}");
            }
        }
    }
}

#[test]
fn the_parameters_of_a_cycle_that_are_no_lines_of_it_are_refused() {
    for lines in [
        "'TCH PROBE 483 A', 'Q340=+1', 'Q260=+50'",
        "'TCH PROBE 483 A ~ Q340=+1 ~ Q260=+50'",
        "'TCH PROBE 483 A ~', 'Q340=+1 ~ Q260=+50'",
    ] {
        let text = format!("[cycles]\nmeasure_tool = [{lines}]\n");
        let config = starting_point(by_name("heidenhain")).read_over(&SpinnerU5620::default(), &text).expect("read");
        let refused = control::unfit(&SpinnerU5620::default(), by_name("heidenhain"), config.demands()).join("\n");
        assert!(
            refused.contains("the parameters of the cycle `TCH PROBE 483 A` follow it line by line"),
            "{lines}: {refused}"
        );
    }
}

#[test]
fn a_displayed_text_of_the_blocks_of_the_shop_may_have_fields() {
    for (name, text) in [("linuxcnc", "(MSG, TOOL {tool} NEXT)"), ("siemens", "MSG(\"TOOL {tool} NEXT\")")] {
        let keys = format!("program.messages = 'display'\nprogram.operation_start = ['{text}']");
        let config = config(name, &keys);
        let program = posted::<SpinnerU5620>(&config, by_name(name), &cl());
        assert!(program.contains(&text.replace("{tool}", "2")), "{program}");
        for other in ["1", "2 WRONG", "20"] {
            let edited = program.replacen(&text.replace("{tool}", "2"), &text.replace("{tool}", other), 1);
            let found = posting::findings::<SpinnerU5620>(&config, by_name(name), &cl(), &edited);
            assert!(!found.is_empty(), "{name} {other}\n{edited}");
        }
    }
}

#[test]
fn measuring_lines_may_have_codes_that_the_program_has_elsewhere_and_stops() {
    for name in CONTROLS {
        let [measure, check] = blocks(name);
        let [stop, optional] = by_name(name).spellings().stop;
        let off = if name == "haas" { "M09" } else { "M9" };
        for [measure, check] in [
            [format!("'{off}', '{measure}'"), format!("'{off}', '{check}'")],
            [format!("'{stop}'"), format!("'{optional}'")],
            [format!("'{measure}', '{stop}'"), format!("'{check}'")],
        ] {
            let text = format!(
                "mode = 'axes'\n[cycles]\nmeasure_tool = [{measure}]\ncheck_tool = [{check}]\n[tools]\n\
                 1 = {{ measured = true, checked = true, {}}}\n",
                if name == "heidenhain" { "" } else { "offset = 12" }
            );
            let config = starting_point(by_name(name)).read_over(&SpinnerU5620::default(), &text).expect("read");
            // It passes its check.
            posted::<SpinnerU5620>(&config, by_name(name), &cl());
        }
    }
}

#[test]
fn the_length_offset_has_ended_at_the_retract_before_a_tool_is_checked() {
    for name in ["fanuc", "haas"] {
        for method in ["G53", "G91 G28"] {
            let config = config(name, &format!("retract.method = '{method}'"));
            let program = posted::<SpinnerU5620>(&config, by_name(name), &cl());
            let lines = bare(&program);
            let checks = (0..lines.len()).filter(|&at| lines[at].starts_with(starts(name)[1]));
            for check in checks {
                let on = lines[..check].iter().rposition(|line| line.contains("G43")).expect("a length offset");
                let off = lines[..check].iter().rposition(|line| line.contains("G49")).expect("its end");
                assert!(on < off, "{name} {method}\n{program}");
            }
        }
    }
}

/// A dwell of a minute, as blocks of each control.
fn minute(name: &str) -> &'static [&'static str] {
    match name {
        "fanuc" => &["G4 P60000"],
        "haas" => &["G04 P60."],
        "siemens" => &["G4 F60"],
        "heidenhain" => &["CYCL DEF 9.0 DWELL TIME", "CYCL DEF 9.1 DWELL 60"],
        _ => &["G4 P60"],
    }
}

#[test]
fn a_dwell_in_the_blocks_of_the_shop_is_asked_for() {
    for name in CONTROLS {
        let blocks = minute(name);
        for key in ["start", "end", "operation_start", "operation_end"] {
            let config = config(name, &format!("program.{key} = {blocks:?}"));
            let program = posted::<SpinnerU5620>(&config, by_name(name), &cl());
            let lines = bare(&program);
            let at = lines.windows(blocks.len()).position(|lines| lines == blocks).expect("the dwell");
            // Where the tool is at the part it is asked for by nothing.
            let cut = lines.iter().position(|line| line.contains("F300")).expect("a cut");
            let mut moved = lines.clone();
            moved.splice(cut + 1..=cut, blocks.iter().copied());
            moved.drain(if at < cut { at..at + blocks.len() } else { at + blocks.len()..at + 2 * blocks.len() });
            let moved = renumbered(by_name(name), &moved);
            let found = posting::findings::<SpinnerU5620>(&config, by_name(name), &cl(), &moved);
            assert!(found.iter().any(|text| text.starts_with("dwell of 60 s")), "{name} {key}\n{moved}\n{found:?}");
        }
    }
}

#[test]
fn a_program_of_the_shop_on_heidenhain_may_leave_any_state() {
    let of = |start: &str| {
        let text = format!(
            "mode = 'axes'\n[program]\nstart = [{start}]\n[control]\neffects = {{ 'CALL PGM TNC:\\WARM.H' = 'state lost' }}\n"
        );
        starting_point(by_name("heidenhain")).read_over(&SpinnerU5620::default(), &text).expect("it can be read")
    };
    let call = "'CALL PGM TNC:\\WARM.H'";
    let whole = of(&format!("{call}, 'M137'"));
    let program = posted::<SpinnerU5620>(&whole, by_name("heidenhain"), &cl());
    // F may be per revolution after the call, and the findings name it.
    let lines: Vec<&str> = bare(&program).into_iter().filter(|line| *line != "M137").collect();
    let without = renumbered(by_name("heidenhain"), &lines);
    let found = posting::findings::<SpinnerU5620>(&of(call), by_name("heidenhain"), &cl(), &without);
    let expected = "feed mode is not per minute (M137); it is unknown after line";
    assert!(found.first().is_some_and(|text| text.starts_with(expected)), "{found:?}");
}

#[test]
fn blocks_that_only_another_control_reads_are_refused() {
    for name in CONTROLS {
        for other in CONTROLS {
            let [measure, check] = blocks(other);
            let check = of(check, 1);
            let text = format!(
                "[cycles]\nmeasure_tool = ['{measure}']\n[cycles.probe]\n'PROBE/Z' = ['{check}']\n[program]\nstart = ['{check}']\n"
            );
            let config = starting_point(by_name(name)).read_over(&SpinnerU5620::default(), &text).expect("read");
            let unfit = config.unfit(&SpinnerU5620::default(), by_name(name));
            let of_another = unfit.iter().filter(|fault| fault.contains("is a line of")).count();
            // The M functions are read by every control; Fanuc and Haas have the same macros.
            let reads =
                other == "linuxcnc" || name == other || [name, other].iter().all(|of| ["fanuc", "haas"].contains(of));
            assert_eq!(of_another, if reads { 0 } else { 3 }, "{name} {other}: {unfit:?}");
        }
    }
}
