//! OPSKIP: blocks that the operator may have skipped. The program is right for the CL data with them where they are
//! executed, and for the CL data without them where they are skipped; the check insists on each mark. Single cases are
//! in `tests/scenarios/block_skip.md`.

use machines::SpinnerU5620;
use pp_runtime::config::{Config, starting_point};
use pp_runtime::control::{self, Control};
use tests::posting::{findings, posted};

const FIRST: &str = "UNITS/MM
TOOL PATH/OP1,TOOL,T
LOADTL/1,LENGTH,100
SPINDL/RPM,2000,CLW
COOLNT/ON
RAPID
GOTO/0,0,30,0,0,1
FEDRAT/MMPM,300
GOTO/0,0,20
GOTO/10,0,20
RAPID
GOTO/10,0,60
";

/// With another tool, a tilted tool axis, and a stop.
const SKIPPED: &str = "TOOL PATH/OP2,TOOL,U
LOADTL/2,LENGTH,110
SPINDL/RPM,1000,CLW
COOLNT/ON
RAPID
GOTO/0,0,30,0.5,0,0.8660254
FEDRAT/MMPM,200
GOTO/0,0,20
RAPID
GOTO/20,0,54.641016
OPSTOP
";

const LAST: &str = "TOOL PATH/OP3,TOOL,T
LOADTL/1
SPINDL/RPM,2000,CLW
COOLNT/ON
RAPID
GOTO/5,5,30,0,0,1
FEDRAT/MMPM,300
GOTO/5,5,20
RAPID
GOTO/5,5,60
FINI
";

fn with_skip() -> String {
    [FIRST, "OPSKIP/ON\n", SKIPPED, "OPSKIP/OFF\n", LAST].concat()
}

fn config(control: &dyn Control, keys: &str) -> Config {
    let text = format!("part_origin = [0.0, 0.0, 0.0]\n{keys}");
    starting_point(control).read_over(&SpinnerU5620::default(), &text).unwrap_or_else(|faults| panic!("{faults:?}"))
}

/// Whether a line goes on with the one before it.
fn continues(line: &str, control: &dyn Control) -> bool {
    control.spellings().numbers_every_line && line.starts_with(' ')
}

/// A program without the lines of a selection, and lines numbered anew where the control numbers every line.
fn only(program: &str, control: &dyn Control, wanted: impl Fn(&str) -> bool) -> String {
    let mut text = String::new();
    let mut number = 0;
    let mut keeps = false;
    for line in program.lines() {
        // A line that goes on belongs to the one before it.
        let continues = continues(line, control);
        keeps = if continues { keeps } else { wanted(line) };
        if !keeps {
            continue;
        }
        let line = line.strip_prefix('/').unwrap_or(line);
        if control.spellings().numbers_every_line && !continues {
            text += &format!("{number}{}\n", line.trim_start_matches(|c: char| c.is_ascii_digit()));
            number += 1;
        } else {
            text += &format!("{line}\n");
        }
    }
    text
}

#[test]
fn the_header_states_that_blocks_may_be_left_out() {
    for control in control::CONTROLS {
        let config = config(*control, "length_guard = false\nplane_guard = false\n[control]\npreselect = false\n");
        let states = |cl: &str| {
            let program = posted::<SpinnerU5620>(&config, *control, cl).to_lowercase();
            program.contains("condition block skip is as meant")
        };
        assert!(states(&with_skip()), "{}", control.spellings().name);
        assert!(!states(&[FIRST, SKIPPED, LAST].concat()), "{}", control.spellings().name);
    }
}

#[test]
fn the_program_is_right_with_the_marked_blocks_and_without_them() {
    for control in control::CONTROLS {
        for mode in ["axes", "auto"] {
            let config = config(
                *control,
                &format!(
                    "mode = '{mode}'\nlength_guard = false\nplane_guard = false\noffset_guard = false\n[control]\npreselect = false\n"
                ),
            );
            let program = posted::<SpinnerU5620>(&config, *control, &with_skip());
            let lines = program.lines().filter(|line| !continues(line, *control));
            let marked: Vec<usize> =
                (0..).zip(lines).filter(|(_, line)| line.starts_with('/')).map(|(at, _)| at).collect();
            let [first, .., last] = marked[..] else { panic!("no marks: {program}") };
            assert_eq!(marked.len(), last - first + 1, "one stretch: {program}");
            let executed = only(&program, *control, |_| true);
            let found = findings::<SpinnerU5620>(&config, *control, &[FIRST, SKIPPED, LAST].concat(), &executed);
            assert!(found.is_empty(), "{executed}\n{found:?}");
            let skipped = only(&program, *control, |line| !line.starts_with('/'));
            let found = findings::<SpinnerU5620>(&config, *control, &[FIRST, LAST].concat(), &skipped);
            assert!(found.is_empty(), "{skipped}\n{found:?}");
        }
    }
}

#[test]
fn a_mark_that_is_lost_or_at_another_block_is_found() {
    for control in control::CONTROLS {
        let config = config(*control, "mode = 'auto'\nlength_guard = false\nplane_guard = false\n");
        let program = posted::<SpinnerU5620>(&config, *control, &with_skip());
        let lines: Vec<&str> = program.lines().collect();
        let comment = |line: &str| {
            let text = line.trim_start_matches(|c: char| c.is_ascii_digit() || c == '/').trim_start();
            // The name of an operation is no text that the configuration wants to be displayed.
            text.is_empty()
                || text.starts_with(['(', ';', '%', '*', 'O'])
                || text.starts_with("MSG(")
                || line.starts_with(' ')
        };
        let marked = |at: &usize| lines[*at].starts_with('/') && !comment(lines[*at]);
        let last = (0..lines.len()).rfind(marked).expect("a mark");
        let mut edits = 0;
        for at in 0..lines.len() {
            // The last of them switches off a spindle that is off already, and M129 a tip control that is.
            if at == last
                || lines[at].ends_with(" M129")
                || comment(lines[at])
                || lines[at].contains("BLK FORM")
                || lines[at].contains(" PGM ")
            {
                continue;
            }
            let changed = match lines[at].strip_prefix('/') {
                Some(always) => always.to_owned(),
                None => format!("/{}", lines[at]),
            };
            let edited = [&lines[..at], &[changed.as_str()], &lines[at + 1..]].concat().join("\n");
            let found = findings::<SpinnerU5620>(&config, *control, &with_skip(), &edited);
            assert!(!found.is_empty(), "{}: line {}: {changed}", control.spellings().name, at + 1);
            edits += 1;
        }
        assert!(edits > 30);
        // The tool in the spindle depends on the switch, so it is called again, although the last record calls T1 as
        // before.
        let call = |line: &&str| line.contains("T1") || line.contains("T=1") || line.contains("TOOL CALL 1");
        assert!(lines[last..].iter().any(call), "{program}");
    }
}

/// Blocks of each control that look for breakage.
fn check_tool(name: &str) -> &'static str {
    match name {
        "linuxcnc" => "M472 P{tool}",
        "fanuc" | "haas" => "G65 P9023 A22. T{tool}",
        "siemens" => "CHECK_TOOL({tool})",
        _ => "CALL PGM TNC:\\CHECK{tool_number}.H",
    }
}

#[test]
fn a_tool_is_checked_on_its_own_side_of_the_marks() {
    for control in control::CONTROLS {
        let name = control.spellings().name;
        for (mode, position) in [("axes", ""), ("auto", "tool_position = { B = 0.0, C = 0.0 }")] {
            let keys = format!(
                "mode = '{mode}'\nlength_guard = false\nplane_guard = false\n[cycles]\ncheck_tool = ['{}']\n{position}\n\
                 [control]\npreselect = false\neffects = {{ M31 = 'none', M33 = 'none', M34 = 'none' }}\n[tools]\n\
                 1 = {{ checked = true, start = ['M34'], end = ['M33'] }}\n2 = {{ checked = true, end = ['M31'] }}\n",
                check_tool(name)
            );
            let config = config(*control, &keys);
            let same = SKIPPED.replace("LOADTL/2,LENGTH,110", "LOADTL/1");
            for (skipped, tool) in [(SKIPPED, "2"), (&same, "1")] {
                for last in [LAST, "FINI\n"] {
                    let data = [FIRST, "OPSKIP/ON\n", skipped, "OPSKIP/OFF\n", last].concat();
                    let program = posted::<SpinnerU5620>(&config, *control, &data);
                    let lines: Vec<&str> = program.lines().collect();
                    let marked = |line: &&&str| line.starts_with('/');
                    let first = lines.iter().position(|line| marked(&line)).expect("a mark");
                    let end = lines.iter().rposition(|line| marked(&line)).expect("a mark");
                    let of = |tool: &str| check_tool(name).replace("{tool}", tool).replace("{tool_number}", tool);
                    let checks =
                        |lines: &[&str], tool: &str| lines.iter().filter(|line| line.ends_with(&of(tool))).count();
                    let counted = [&lines[..first], &lines[first..=end], &lines[end + 1..]];
                    let expected = if last == LAST { 1 } else { 0 };
                    assert_eq!(checks(counted[0], "1"), 1, "{name}\n{program}");
                    assert_eq!(checks(counted[1], tool), 1, "{name}\n{program}");
                    assert_eq!(checks(counted[2], "1"), expected, "{name}\n{program}");
                    let all = ["1", "2"].iter().map(|tool| checks(&lines, tool)).sum::<usize>();
                    assert_eq!(all, 2 + expected, "{name}\n{program}");
                    // A tool that goes on after its blocks at the end has those at its start again.
                    let starts = (0..lines.len()).filter(|&at| {
                        lines[at].trim_start_matches(|c: char| c == '/' || c.is_ascii_digit()).trim_start() == "M34"
                    });
                    let starts: Vec<usize> = starts.collect();
                    assert_eq!(starts.len(), 1 + usize::from(tool == "1") + expected, "{name}\n{program}");
                    for at in starts {
                        let lost = [&lines[..at], &lines[at + 1..]].concat().join("\n");
                        let lost = findings::<SpinnerU5620>(&config, *control, &data, &lost);
                        assert!(!lost.is_empty(), "{name}: {}\n{program}", lines[at]);
                    }
                    // Lost, and on the other side of the marks: the retract stands before them and after them.
                    for at in
                        (0..lines.len()).filter(|&at| ["1", "2"].iter().any(|tool| lines[at].ends_with(&of(tool))))
                    {
                        let lost = [&lines[..at], &lines[at + 1..]].concat().join("\n");
                        let lost = findings::<SpinnerU5620>(&config, *control, &data, &lost);
                        assert!(!lost.is_empty(), "{name}: {}\n{program}", lines[at]);
                        let other = match lines[at].strip_prefix('/') {
                            Some(line) => line.to_owned(),
                            None => format!("/{}", lines[at]),
                        };
                        let mut edited = lines.clone();
                        edited[at] = &other;
                        let moved = findings::<SpinnerU5620>(&config, *control, &data, &edited.join("\n"));
                        assert!(!moved.is_empty(), "{name}: {other}\n{program}");
                    }
                }
            }
        }
    }
}

/// Clamps are as skipped blocks have left them, or as they were before.
#[test]
fn a_clamp_is_released_before_parking_after_skipped_blocks() {
    let cl = "UNITS/MM\nLOADTL/1\nSPINDL/RPM,4000,CLW\nRAPID\nGOTO/0,0,20,0,0,1\nFEDRAT/MMPM,700\nGOTO/0,0,10\nOPSKIP/ON\n\
        GOTO/2,4,10,0,0.11971221,0.99280864\nGOTO/2.5,5,10,0,0.14943813,0.98877108\nRAPID\nGOTO/2.5,5,50\nOPSKIP/OFF\nFINI\n";
    for &control in control::CONTROLS {
        let name = control.spellings().name;
        let codes = if name == "linuxcnc" { "on = 'M64 P6', off = 'M65 P6'" } else { "on = 'M162', off = 'M262'" };
        let frame = if name == "fanuc" { "tcp_frame = 'table_at_zero'\n" } else { "" };
        let keys = format!("{frame}retract.distance = 80.0\npark.B = 30.0\nclamp.B = {{ {codes} }}\n");
        posted::<SpinnerU5620>(&config(control, &keys), control, cl);
    }
}
