//! Axes at their positions where a tool is measured or checked for breakage (`cycles.tool_position`), and home positions before
//! any rotation at the machine retract: on every control, in each mode, and a check that finds them lost or changed.

use machines::SpinnerU5620;
use pp_runtime::config::{Config, starting_point};
use pp_runtime::control::{self, Control};
use tests::posting::{self, bare, posted, renumbered, without};

/// Tilted cuts with two tools, each measured and checked, and GOHOME.
const CL: &str = "UNITS/MM
TOOL PATH/OP1,TOOL,T
LOADTL/1,LENGTH,100
SPINDL/RPM,2000,CLW
COOLNT/ON
RAPID
GOTO/0,0,30,0.5,0,0.8660254
FEDRAT/MMPM,300
GOTO/0,0,20
RAPID
GOTO/0,0,60
TOOL PATH/OP2,TOOL,U
LOADTL/2,LENGTH,110
SPINDL/RPM,1000,CLW
RAPID
GOTO/0,0,30,0,0.5,0.8660254
FEDRAT/MMPM,300
GOTO/0,0,20
RAPID
GOTO/0,0,60
GOHOME
FINI
";

/// Control, blocks of the shop, the words of the rotary axes at zero, and a code that only a block of machine
/// coordinates has.
const CONTROLS: &[(&str, [&str; 2], [&str; 2], &str)] = &[
    ("linuxcnc", ["M471 P{tool}", "M472 P{tool}"], ["C0", "B0"], "G53"),
    ("fanuc", ["G65 P9023 A12. T{tool}", "G65 P9023 A22. T{tool}"], ["C0.", "B0."], "G53"),
    ("haas", ["G65 P9023 A12. T{tool}", "G65 P9023 A22. T{tool}"], ["C0.", "B0."], "G53"),
    ("siemens", ["MEASURE_TOOL({tool})", "CHECK_TOOL({tool})"], ["C0", "B0"], "SUPA"),
    ("heidenhain", ["CALL PGM TNC:\\MEASURE.H", "CALL PGM TNC:\\CHECK.H"], ["C+0", "B+0"], "M91"),
];

const MODES: [&str; 2] = ["mode = 'axes'", "mode = 'auto'"];

fn by_name(name: &str) -> &'static dyn Control {
    control::by_name(name).expect("a control")
}

fn config(name: &str, mode: &str, [measure, check]: [&str; 2], cycles: &str, more: &str) -> Config {
    let (more, tables) = more.find("[set_ups").map_or((more, ""), |at| more.split_at(at));
    let (retract, more) = if more.starts_with("tool_change") { (more, "") } else { ("", more) };
    let text = format!(
        "part_origin = [0.0, 0.0, 0.0]\n{mode}\n{more}\n[retract]\n{retract}\ndistance = 50.0\nhome_on_indexing = true\n\
         xy = {{ X = -7.0, Y = -8.0 }}\n[cycles]\nmeasure_tool = ['{measure}']\ncheck_tool = ['{check}']\n{cycles}\n\
         [tools]\n1 = {{ measured = true, checked = true }}\n2 = {{ measured = true, checked = true }}\n{tables}"
    );
    let mode_keys = if name == "fanuc" { "tcp_frame = 'table_at_start'\n" } else { "" };
    starting_point(by_name(name))
        .read_over(&SpinnerU5620::default(), &format!("{mode_keys}{text}"))
        .unwrap_or_else(|faults| panic!("{faults:?}"))
}

/// Whether a line moves rotary axes to zero and does nothing else.
fn rotates_to_zero(line: &str, words: [&str; 2]) -> bool {
    let known = |word: &str| words.contains(&word) || matches!(word, "G0" | "G00" | "G90" | "L" | "R0" | "FMAX");
    line.split(' ').all(known) && words.iter().any(|word| line.contains(word))
}

/// Whether a line moves X and Y to these machine coordinates.
fn goes_to(line: &str, code: &str, [x, y]: [i32; 2]) -> bool {
    line.contains(code) && line.contains(&format!("X{x}")) && line.contains(&format!("Y{y}"))
}

fn is_of_shop(line: &str, blocks: [&str; 2]) -> bool {
    blocks.iter().any(|block| line.starts_with(block.split('{').next().unwrap_or_default()))
}

#[test]
fn the_axes_are_at_their_positions_where_a_tool_is_measured() {
    for &(name, blocks, zero, code) in CONTROLS {
        for mode in MODES {
            let cycles = "tool_position = { B = 0.0, C = 0.0, X = -300.0, Y = -200.0 }";
            let config = config(name, mode, blocks, cycles, "");
            let program = posted::<SpinnerU5620>(&config, by_name(name), CL);
            let lines = bare(&program);
            let routines: Vec<usize> = (0..lines.len()).filter(|&at| is_of_shop(lines[at], blocks)).collect();
            assert_eq!(routines.len(), 4, "{name}\n{program}");
            for at in routines {
                let before = &lines[at - 5..at];
                let turned = before.iter().position(|line| rotates_to_zero(line, zero));
                let home = before.iter().position(|line| goes_to(line, code, [-7, -8]));
                let there = before.iter().position(|line| goes_to(line, code, [-300, -200]));
                assert!(home.is_some() && home < turned && turned < there, "{name} {mode}: {before:?}\n{program}");
            }
        }
    }
}

#[test]
fn an_axis_elsewhere_where_a_tool_is_measured_is_found() {
    for &(name, blocks, zero, code) in CONTROLS {
        for mode in MODES {
            let cycles = "tool_position = { B = 0.0, C = 0.0, X = -300.0, Y = -200.0 }";
            let (control, config) = (by_name(name), config(name, mode, blocks, cycles, ""));
            let program = posted::<SpinnerU5620>(&config, control, CL);
            let found = |edited: &str| posting::findings::<SpinnerU5620>(&config, control, CL, edited);
            let is_there = |line: &str| rotates_to_zero(line, zero) || goes_to(line, code, [-300, -200]);
            let shorter = without(&program, control, |rest| is_there(rest[0]));
            assert!(shorter.len() >= 8, "{name} {mode}\n{program}");
            for edited in shorter {
                assert!(!found(&edited).is_empty(), "{name} {mode}\n{edited}");
            }
            let lines = bare(&program);
            for at in (0..lines.len()).filter(|&at| is_there(lines[at])) {
                let other = lines[at].replace(zero[1], &zero[1].replace('0', "5")).replace("X-300", "X-301");
                let mut edited = lines.clone();
                edited[at] = &other;
                let found = found(&renumbered(control, &edited));
                assert!(!found.is_empty(), "{name} {mode}: {other}\n{program}");
            }
        }
    }
}

#[test]
fn the_axes_go_where_a_tool_is_changed_with_the_spindle_off_in_any_set_up_and_up_to_any_height() {
    // The spindle is on at the end of the first operation, as the CL data leaves it, and the second has another set-up.
    for &(name, blocks, _, code) in CONTROLS {
        for mode in MODES {
            for z in ["", ", Z = 0.0", ", Z = -20.0"] {
                for measures in ["", "tool_position = { B = 0.0, C = 0.0, X = -300.0, Y = -200.0 }"] {
                    let position = CHANGE_POSITION.replace(" }", &format!("{z} }}"));
                    let offset = if name == "heidenhain" { "2" } else { "G55" };
                    let second = format!(
                        "[set_ups.2]\nbegins = 'OP2'\nwork_offset = '{offset}'\npart_origin = [0.0, 0.0, 0.0]\n"
                    );
                    let (control, config) =
                        (by_name(name), config(name, mode, blocks, measures, &format!("{position}\n{second}")));
                    let program = posted::<SpinnerU5620>(&config, control, CL);
                    let lines = bare(&program);
                    for at in (0..lines.len()).filter(|&at| changes_tool(lines[at])).skip(1) {
                        let there =
                            lines[..at].iter().rposition(|line| goes_to(line, code, [-400, -500])).expect("there");
                        let off = lines[..there].iter().rposition(|line| ["M5", "M05"].contains(line)).expect("off");
                        let on = lines[..there].iter().rposition(|line| line.contains("M3") || line.contains("M03"));
                        assert!(on < Some(off), "{name} {mode}\n{program}");
                    }
                }
            }
        }
    }
}

#[test]
fn the_rotary_axes_go_where_the_course_leads_them_whatever_position_a_tool_was_changed_at() {
    // Rotary words in a cut are those of the preference, with a position of the axes before it and without one.
    let words = |program: &str| -> Vec<String> {
        let rotary = |line: &&str| {
            line.contains(['B', 'C']) && !line.starts_with([';', '(', 'M', 'C', 'T', 'P', '*', 'B', 'D', 'Q'])
        };
        let is_zero = |line: &str| line.contains("B0") || line.contains("B+0");
        bare(program).into_iter().filter(|line| rotary(line) && !is_zero(line)).map(str::to_owned).collect()
    };
    for &(name, blocks, ..) in CONTROLS {
        for prefer in ["prefer = 'B-'", "prefer = 'B+'", "start_branch = 'second'"] {
            let course = format!("course = {{ {prefer} }}\nlimits = {{ B = [-110.0, 110.0] }}\nmode = 'axes'");
            let program = |cycles: &str, change: &str| {
                posted::<SpinnerU5620>(&config(name, &course, blocks, cycles, change), by_name(name), CL)
            };
            let plain = words(&program("", ""));
            assert!(plain.len() >= 2, "{name}: {plain:?}\n{}", program("", ""));
            let position = "tool_position = { B = 0.0, C = 0.0 }";
            for (cycles, change) in [(position, ""), ("", CHANGE_POSITION), (position, CHANGE_POSITION)] {
                assert_eq!(words(&program(cycles, change)), plain, "{name} {prefer}");
            }
        }
    }
}

/// Codes that change a tool.
const CHANGES: [&str; 3] = ["M6", "M06", "TOOL CALL "];

/// Whether a line changes the tool; `TOOL CALL S` does not.
fn changes_tool(line: &str) -> bool {
    let number = line.strip_prefix(CHANGES[2]).is_some_and(|rest| !rest.starts_with('S'));
    number || line.split(' ').any(|word| CHANGES[..2].contains(&word))
}

const CHANGE_POSITION: &str = "tool_change_position = { B = 0.0, C = 0.0, X = -400.0, Y = -500.0 }";

#[test]
fn the_axes_are_at_their_positions_where_a_tool_is_changed() {
    for &(name, blocks, zero, code) in CONTROLS {
        for mode in MODES {
            let (control, cycles) = (by_name(name), "tool_position = { B = 0.0, C = 0.0, X = -300.0, Y = -200.0 }");
            let config = config(name, mode, blocks, cycles, CHANGE_POSITION);
            let program = posted::<SpinnerU5620>(&config, control, CL);
            let lines = bare(&program);
            let found =
                |lines: &[&str]| posting::findings::<SpinnerU5620>(&config, control, CL, &renumbered(control, lines));
            let is_there = |line: &str| goes_to(line, code, [-400, -500]);
            let changes: Vec<usize> = (0..lines.len()).filter(|&at| changes_tool(lines[at])).collect();
            assert_eq!(changes.len(), 2, "{name}\n{program}");
            for at in changes {
                let there = lines[..at].iter().rposition(|line| is_there(line)).expect("the position");
                let turned = lines[..there].iter().rposition(|line| rotates_to_zero(line, zero)).expect("rotary axes");
                let home = lines[..turned].iter().rposition(|line| goes_to(line, code, [-7, -8])).expect("home");
                assert!(home + 2 >= turned && at - there <= 2, "{name} {mode}\n{program}");
                // Lost, and another position; a spindle that runs on the way.
                for lost in [there, turned, home] {
                    let edited = [&lines[..lost], &lines[lost + 1..]].concat();
                    assert!(!found(&edited).is_empty(), "{name} {mode}: {}\n{program}", lines[lost]);
                }
                for (line, was, is) in [(there, "X-400", "X-401"), (turned, zero[1], "B5."), (there, "Y-500", "Y500")] {
                    let other = lines[line].replace(was, is);
                    let mut edited = lines.clone();
                    edited[line] = &other;
                    assert!(edited != lines && !found(&edited).is_empty(), "{name} {mode}: {other}\n{program}");
                }
                let told = found(&[&lines[..there], &lines[there + 1..]].concat()).join("\n");
                assert!(told.contains("X is not at its position of `retract.tool_change_position`"), "{name}: {told}");
            }
            // The retract between the change and the blocks that measure.
            for at in (0..lines.len()).filter(|&at| changes_tool(lines[at])) {
                let retract = at + 1 + lines[at + 1..].iter().position(|line| line.contains(code)).expect("a retract");
                assert!(!found(&[&lines[..retract], &lines[retract + 1..]].concat()).is_empty(), "{name}\n{program}");
            }
            // The position of the other station is none for a change.
            let other = lines.iter().map(|line| line.replace("X-400", "X-300").replace("Y-500", "Y-200"));
            let other: Vec<String> = other.collect();
            let other: Vec<&str> = other.iter().map(String::as_str).collect();
            assert!(!found(&other).is_empty(), "{name} {mode}\n{program}");
        }
    }
}

#[test]
fn a_tool_that_stays_in_the_spindle_needs_no_position_for_a_change_but_one_after_skipped_blocks_does() {
    let same = CL.replace("LOADTL/2,LENGTH,110", "LOADTL/1");
    let skipped = CL.replace("TOOL PATH/OP2", "OPSKIP/ON\nTOOL PATH/OP2").replace("GOHOME", "OPSKIP/OFF\nTOOL PATH/OP3,TOOL,T\nLOADTL/1\nSPINDL/RPM,2000,CLW\nRAPID\nGOTO/0,0,30,0,0,1\nFEDRAT/MMPM,300\nGOTO/0,0,20\nRAPID\nGOTO/0,0,60\nGOHOME");
    for &(name, blocks, _, code) in CONTROLS {
        for (cl, changes) in [(&same, 1), (&skipped, 3)] {
            let config = config(name, MODES[0], blocks, "", CHANGE_POSITION);
            let program = posted::<SpinnerU5620>(&config, by_name(name), cl);
            let there = bare(&program).into_iter().filter(|line| goes_to(line, code, [-400, -500])).count();
            assert_eq!(there, changes, "{name}\n{program}");
        }
    }
}

#[test]
fn clamps_are_off_where_an_axis_may_rotate_after_the_blocks_of_a_tool() {
    // Straight, so that no axis rotates by what is known.
    let straight = CL.replace(",0.5,0,0.8660254", ",0,0,1").replace(",0,0.5,0.8660254", ",0,0,1");
    let positions =
        ["tool_position = { B = 0.0, C = 0.0 }", "tool_position = { B = 0.0, C = 0.0, X = -300.0, Y = -200.0 }", ""];
    for &(name, blocks, ..) in CONTROLS {
        let control = by_name(name);
        for cl in [CL, &straight] {
            for (cycles, mode) in positions.into_iter().flat_map(|cycles| MODES.map(|mode| (cycles, mode))) {
                for change in ["", CHANGE_POSITION] {
                    let mut config = config(name, mode, blocks, cycles, change);
                    for (letter, [on, off]) in [('B', ["M68", "M69"]), ('C', ["M78", "M79"])] {
                        let codes = pp_runtime::motion::ClampCodes { on: on.to_owned(), off: off.to_owned() };
                        config.motion.rotaries.clamp.insert(letter, codes);
                    }
                    // It passes its check, which finds an axis that rotates while it is clamped.
                    posted::<SpinnerU5620>(&config, control, cl);
                }
            }
        }
    }
}

#[test]
fn x_and_y_go_home_before_the_rotary_axes_are_parked() {
    for &(name, blocks, zero, code) in CONTROLS {
        for mode in MODES {
            let config = config(name, mode, blocks, "", "park = { B = 0.0, C = 0.0, X = -300.0, Y = -200.0 }");
            let control = by_name(name);
            let program = posted::<SpinnerU5620>(&config, control, CL);
            let lines = bare(&program);
            let parked = lines.iter().position(|line| goes_to(line, code, [-300, -200])).expect("GOHOME parks");
            let turned = lines[..parked].iter().rposition(|line| rotates_to_zero(line, zero)).expect("rotary axes");
            let home = lines[..turned].iter().rposition(|line| *line != "D1").expect("a line");
            assert!(goes_to(lines[home], code, [-7, -8]), "{name} {mode}\n{program}");
            let edited = renumbered(control, &[&lines[..home], &lines[home + 1..]].concat());
            let found = posting::findings::<SpinnerU5620>(&config, control, CL, &edited);
            assert!(found.iter().any(|text| text.contains("home_on_indexing")), "{name} {mode}: {found:?}\n{edited}");
            // The spindle does not run on the way to the door.
            assert!(["M5", "M05"].contains(&lines[home - 1]), "{name} {mode}\n{program}");
            let edited = renumbered(control, &[&lines[..home - 1], &lines[home..]].concat());
            let found = posting::findings::<SpinnerU5620>(&config, control, CL, &edited);
            assert!(found.iter().any(|text| text.contains("spindle is on")), "{name} {mode}: {found:?}\n{edited}");
        }
    }
}

#[test]
fn the_park_position_may_be_the_home_position() {
    for &(name, blocks, ..) in CONTROLS {
        let more = "park = { B = 0.0, C = 0.0, X = -7.0, Y = -8.0 }";
        // It passes its check.
        posted::<SpinnerU5620>(&config(name, MODES[0], blocks, "", more), by_name(name), CL);
    }
}

#[test]
fn an_axis_that_rolls_over_is_parked_in_one_block_where_its_angle_is_unknown() {
    let half_a_turn = CL.replace("0,0.5,0.8660254", "-0.5,0,0.8660254").replace("GOHOME\n", "");
    for &(name, blocks, zero, _) in CONTROLS.iter().filter(|(name, ..)| !["haas", "linuxcnc"].contains(name)) {
        for mode in MODES {
            // Half a turn back from a known angle takes two blocks; after the blocks of the shop the angle is unknown.
            let more = "wrap = { C = '0..360' }\npark = { B = 0.0, C = 0.0 }";
            let program = posted::<SpinnerU5620>(&config(name, mode, blocks, "", more), by_name(name), &half_a_turn);
            let lines = bare(&program);
            let routine =
                lines.iter().rposition(|line| is_of_shop(line, blocks)).expect("the breakage check at the end");
            let rotary = |line: &&&str| line.contains(['B', 'C']) && !line.starts_with([';', '(', 'M', 'C', 'Q']);
            let turns: Vec<&&str> = lines[routine + 1..].iter().filter(rotary).collect();
            assert!(turns.len() == 1 && rotates_to_zero(turns[0], zero), "{name} {mode}: {turns:?}\n{program}");
        }
    }
}

/// A configuration without blocks of the shop.
fn plain(name: &str, text: &str) -> Config {
    let frame = if name == "fanuc" { "tcp_frame = 'table_at_start'\n" } else { "" };
    let text = format!("part_origin = [0.0, 0.0, 0.0]\n{frame}{text}\n[retract]\ndistance = 50.0\n");
    starting_point(by_name(name)).read_over(&SpinnerU5620::default(), &text).expect("a configuration")
}

#[test]
fn a_program_goes_on_after_gohome_and_may_stop_then() {
    // Rotary axes that are parked where they are, or elsewhere, and come back to the next cut or stay.
    for axes in [["0,0,1", "0,0,1"], ["0.5,0,0.8660254", "0,0,1"], ["0,0,1", "0,0.5,0.8660254"], ["0.5,0,0.8660254"; 2]]
    {
        let [first, then] = axes;
        let cl = format!(
            "UNITS/MM\nTOOL PATH/OP1,TOOL,T\nLOADTL/1,LENGTH,100\nSPINDL/RPM,2000,CLW\nFEDRAT/MMPM,300\nRAPID\nGOTO/0,0,30,{first}\n\
             GOTO/0,0,20\nGOHOME\nTOOL PATH/OP2,TOOL,T\nRAPID\nGOTO/10,0,30,{then}\nGOTO/10,0,20\nSTOP\nFINI\n"
        );
        for &(name, ..) in CONTROLS {
            for mode in MODES {
                for park in ["B = 0.0", "C = 0.0", "B = 0.0, C = 0.0", "B = 10.0, C = 0.0"] {
                    // It passes its check.
                    posted::<SpinnerU5620>(&plain(name, &format!("{mode}\npark = {{ {park} }}")), by_name(name), &cl);
                }
            }
        }
    }
}

#[test]
fn a_link_to_an_operation_with_another_tilt_and_speed_passes_its_check() {
    let cl = "UNITS/MM\nTOOL PATH/OP1,TOOL,T\nLOADTL/1,LENGTH,100\nSPINDL/RPM,500,CLW\nFEDRAT/MMPM,300\nRAPID\nGOTO/0,0,90,0.5,0,0.8660254\n\
              GOTO/-30,0,38\nGOTO/0,0,90\nTOOL PATH/OP2,TOOL,T\nSPINDL/RPM,3000,CLW\nRAPID\nGOTO/0,10,90,0,0.5,0.8660254\nGOTO/0,-20,38\n\
              GOTO/0,10,90\nFINI\n";
    for &(name, ..) in CONTROLS {
        for mode in MODES {
            let (config, control) = (plain(name, &format!("{mode}\ntransition = 'direct'")), by_name(name));
            let program = posted::<SpinnerU5620>(&config, control, cl);
            let edited = program.replace("S3000", "S2900");
            assert_ne!(program, edited, "{name} {mode}\n{program}");
            let found = posting::findings::<SpinnerU5620>(&config, control, cl, &edited);
            assert!(found.iter().any(|text| text.contains("S is 2900")), "{name} {mode}: {found:?}\n{edited}");
        }
    }
}
