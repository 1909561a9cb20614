//! Statements of the CL data at which a probe measures (`cycles.probe`), on every control: their blocks where the last motion
//! has ended, the retract after them, what is refused, and a check that misses them.

use machines::SpinnerU5620;
use pp_runtime::config::{Config, starting_point};
use pp_runtime::control::{self, Control};
use pp_runtime::motion::Mode;
use tests::posting::{self, bare, posted, renumbered, without, written};

/// Two points of a probe, then a cut with a mill.
const CL: &str = "UNITS/MM
TOOL PATH/PROBE,TOOL,P
LOADTL/9,LENGTH,150
SPINDL/OFF
RAPID
GOTO/10,20,30,0,0,1
RAPID
GOTO/10,20,5
PROBE/BORE, 20
RAPID
GOTO/40,20,30
RAPID
GOTO/40,20,5
CYCLE/PROBE, Z
TOOL PATH/CUT,TOOL,M
LOADTL/1,LENGTH,100
SPINDL/RPM,2000,CLW
RAPID
GOTO/0,0,30
FEDRAT/MMPM,300
GOTO/0,0,20
RAPID
GOTO/0,0,60
FINI
";

/// Blocks for a bore, two of them, and for a level.
const BLOCKS: &[(&str, [&str; 3])] = &[
    ("linuxcnc", ["O<BORE> CALL [20]", "M472", "O<LEVEL> CALL"]),
    ("fanuc", ["G65 P9810 Z-5. F3000.", "G65 P9814 D20.", "G65 P9811 Z0."]),
    ("haas", ["G65 P9810 Z-5. F3000.", "G65 P9814 D20.", "G65 P9811 Z0."]),
    ("siemens", ["PROBE_DOWN(-5)", "PROBE_BORE(20)", "PROBE_LEVEL"]),
    ("heidenhain", ["CALL PGM TNC:\\DOWN.H", "CALL PGM TNC:\\BORE.H", "CALL PGM TNC:\\LEVEL.H"]),
];

fn by_name(name: &str) -> &'static dyn Control {
    control::by_name(name).expect("a control")
}

fn config(name: &str, [down, bore, level]: [&str; 3], keys: &str) -> Config {
    let mode = if keys.contains("mode") { "" } else { "mode = 'axes'\n" };
    let text = format!(
        "part_origin = [0.0, 0.0, 0.0]\n{mode}retract.distance = 20\n{keys}\n[cycles.probe]\n\
         'probe/bore,20' = ['{down}', '{bore}']\n'CYCLE/PROBE,Z' = ['{level}']\n"
    );
    starting_point(by_name(name))
        .read_over(&SpinnerU5620::default(), &text)
        .unwrap_or_else(|faults| panic!("{faults:?}"))
}

#[test]
fn a_probe_measures_where_the_last_motion_ends_and_the_machine_retracts_after_it() {
    for &(name, blocks) in BLOCKS {
        let (control, config) = (by_name(name), config(name, blocks, ""));
        let program = posted::<SpinnerU5620>(&config, control, CL);
        let lines = bare(&program);
        let [down, bore, level] = blocks.map(|block| lines.iter().position(|line| *line == block).expect(block));
        assert_eq!(bore, down + 1, "{name}\n{program}");
        // The point of the tool in Z is the last thing before.
        assert!(lines[down - 1].contains("Z5") || lines[down - 1].contains("Z+5"), "{name}\n{program}");
        assert!(lines[level - 1].contains("Z5") || lines[level - 1].contains("Z+5"), "{name}\n{program}");
        let retracts = ["G53", "SUPA", "M91"];
        for at in [bore, level] {
            let next = lines[at + 1..]
                .iter()
                .find(|line| ["G0 ", "G00 ", "L ", "SUPA", "G49 ", "G53"].iter().any(|word| line.starts_with(word)));
            let next = next.expect("a motion");
            assert!(retracts.iter().any(|retract| next.contains(retract)), "{name}: {next}\n{program}");
        }
    }
}

#[test]
fn a_probe_measures_in_a_tilted_plane() {
    let tilted = CL.replace("30,0,0,1", "30,0.5,0,0.8660254").replace("GOTO/0,0,30\n", "GOTO/0,0,30,0,0,1\n");
    for &(name, blocks) in &BLOCKS[1..] {
        // It passes its check.
        let program = posted::<SpinnerU5620>(&config(name, blocks, "mode = 'plane'"), by_name(name), &tilted);
        assert_eq!(bare(&program).iter().filter(|line| blocks.contains(line)).count(), 3, "{name}\n{program}");
    }
}

#[test]
fn a_lost_block_of_a_probe_and_one_at_another_place_are_found() {
    for &(name, blocks) in BLOCKS {
        let (control, config) = (by_name(name), config(name, blocks, ""));
        let program = posted::<SpinnerU5620>(&config, control, CL);
        let found = |edited: &str| posting::findings::<SpinnerU5620>(&config, control, CL, edited);
        for edited in without(&program, control, |rest| blocks.contains(&rest[0])) {
            assert!(!found(&edited).is_empty(), "{name}\n{edited}");
        }
        let lines = bare(&program);
        let at = lines.iter().position(|line| *line == blocks[0]).expect("the first block");
        // Another block in its place, before the last motion, after the retract, and with the spindle on.
        let mut changed = lines.clone();
        changed[at] = blocks[2];
        let mut early = lines.clone();
        early.swap(at - 1, at);
        let retracted =
            lines[at..].iter().position(|line| ["G53", "SUPA", "M91"].iter().any(|code| line.contains(code)));
        let retract = lines[at + retracted.expect("a retract")];
        let late = [&lines[..at], &[retract], &lines[at..]].concat();
        let spindle = if name == "haas" { "S100 M03" } else { "S100 M3" };
        let spindle = if name == "heidenhain" { "M3" } else { spindle };
        let on = [&lines[..at], &[spindle], &lines[at..]].concat();
        for edited in [changed, early, late, on] {
            let edited = renumbered(control, &edited);
            assert!(!found(&edited).is_empty(), "{name}\n{edited}");
        }
    }
}

#[test]
fn a_probe_without_a_point_or_with_the_spindle_on_is_refused() {
    let spindle = CL.replacen("SPINDL/OFF", "SPINDL/RPM,100,CLW", 1);
    let coolant = CL.replacen("SPINDL/OFF", "SPINDL/OFF\nCOOLNT/ON", 1);
    let nowhere = CL.replacen("RAPID\nGOTO/10,20,30,0,0,1\nRAPID\nGOTO/10,20,5\n", "", 1);
    for &(name, blocks) in BLOCKS {
        for (cl, expected) in [
            (&spindle, "the spindle is on where a probe measures"),
            (&coolant, "the coolant is on where a probe measures"),
            (&nowhere, "a probe measures here, and no motion leads to its point"),
        ] {
            let (_, report) =
                written::<SpinnerU5620>(&config(name, blocks, ""), by_name(name), cl).expect("it can run");
            let told: Vec<&str> = report.diagnostics.iter().map(|found| found.text.as_str()).collect();
            assert!(report.failed && told.iter().any(|text| text.contains(expected)), "{name}: {told:?}");
        }
    }
    let mut tip_control = config("siemens", BLOCKS[3].1, "");
    tip_control.motion.mode = Mode::Tcp;
    let (_, report) = written::<SpinnerU5620>(&tip_control, by_name("siemens"), CL).expect("it can run");
    assert!(report.diagnostics.iter().any(|found| found.text.contains("do not run under tip control")), "{report:?}");
}

#[test]
fn a_statement_of_a_probe_is_a_statement_of_cl_data_with_blocks() {
    let read = |keys: &str| {
        let faults = starting_point(by_name("fanuc")).read_over(&SpinnerU5620::default(), keys).err();
        faults.map(|faults| format!("{faults:?}")).unwrap_or_default()
    };
    assert_eq!(read("cycles.probe = { 'PROBE/Z' = ['G65 P9811 Z0.'], 'CYCLE/PROBE' = ['M99'] }\n"), "");
    assert!(read("cycles.probe = { 'CYCLE/DRILL,3' = ['M99'] }\n").contains("CYCLE is read"));
    assert!(read("cycles.probe = { 'PROBE/Z' = [] }\n").contains("a block has ASCII"));
    assert!(read("cycles.probe = { 'PROBE/Z' = ['M1'], 'probe / z' = ['M1'] }\n").contains("stated twice"));
}
