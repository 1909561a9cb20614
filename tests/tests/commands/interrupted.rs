//! A cut that goes on after a stop, OPSKIP or NC text begins where the last motion ended: no part of it is lost, on
//! every control, in each mode; and a check that finds it lost. An operation with a name or a tool begins at its first
//! point.

use machines::SpinnerU5620;
use pp_runtime::config::{Config, starting_point};
use pp_runtime::control::{self, Control};
use tests::by_name;
use tests::posting::{self, bare, posted, renumbered};

/// A slot around a square; `BETWEEN` stands in the middle of it.
const CL: &str = "UNITS/MM
TOOL PATH/SLOT,TOOL,T
LOADTL/1,LENGTH,100
SPINDL/RPM,2000,CLW
RAPID
GOTO/-40,-20,60,0,0,1
RAPID
GOTO/-40,-20,2
FEDRAT/MMPM,200
GOTO/-40,-20,-5
GOTO/41,-21,-5
BETWEEN
GOTO/42,22,-5
GOTO/-40,20,-5
RAPID
GOTO/-40,20,60
FINI
";

/// With the tool axis tilted, and rotating at feed across the interruption.
fn tilted() -> String {
    CL.replace("60,0,0,1", "60,0.5,0,0.8660254")
        .replace("GOTO/42,22,-5", "GOTO/42,22,-5,0.5735764,0,0.8191520")
        .replace("GOTO/-40,20,60", "GOTO/8,20,63.5")
}

/// What may come between, and whether the cut goes on from where it was.
const BETWEEN: &[(&str, bool)] = &[
    ("STOP", true),
    ("OPSTOP", true),
    ("OPSKIP/ON\nGOTO/41,0,-5\nOPSKIP/OFF", true),
    ("AUXFUN/77", true),
    ("TOOL PATH/NEXT,TOOL,T", false),
    ("TOOL PATH/NEXT,TOOL,T\nLOADTL/1", false),
    ("TOOL PATH/NEXT,TOOL,U\nLOADTL/2,LENGTH,110\nSPINDL/RPM,2000,CLW", false),
    ("GOHOME", false),
];

fn config(control: &dyn Control, mode: &str) -> Config {
    let text = format!(
        "part_origin = [0.0, 0.0, 0.0]\nmode = '{mode}'\nlength_guard = false\nplane_guard = false\nretract.distance = 60\n\
         {}[cl]\nauxfun = [77]\n[control]\npreselect = false\neffects = {{ M77 = 'none' }}\n",
        if control.spellings().name == "fanuc" { "tcp_frame = 'table_at_start'\n" } else { "" }
    );
    starting_point(control).read_over(&SpinnerU5620::default(), &text).unwrap_or_else(|faults| panic!("{faults:?}"))
}

/// Whether a block moves to the point before the interruption, by its numbers in axis positions of an untilted table.
fn is_point(line: &str, [x, y]: [&str; 2]) -> bool {
    let line = line.trim_start_matches('/');
    let has = |letter: char, number: &str| {
        line.split(' ')
            .any(|word| word.trim_start_matches(letter).trim_start_matches('+').trim_end_matches('.') == number)
    };
    has('X', x) && has('Y', y)
}

#[test]
fn a_cut_goes_on_where_it_was_interrupted() {
    for control in control::CONTROLS {
        let config = config(*control, "axes");
        for (between, goes_on) in BETWEEN {
            let cl = CL.replace("BETWEEN", between);
            let program = posted::<SpinnerU5620>(&config, *control, &cl);
            let lines = bare(&program);
            // The safe sequence leads over the point at which the cut was interrupted, and the cut goes on from there.
            let back: Vec<usize> = (0..lines.len()).filter(|&at| is_point(lines[at], ["41", "-21"])).collect();
            let skips = between.contains("OPSKIP");
            assert_eq!(back.len() > 1, *goes_on, "{} {between}\n{program}", control.spellings().name);
            let Some(&back) = back.get(1) else { continue };
            let found = |lines: &[&str]| {
                posting::findings::<SpinnerU5620>(&config, *control, &cl, &renumbered(*control, lines))
            };
            if skips {
                continue;
            }
            let cut = back
                + lines[back..].iter().position(|line| line.contains("X42") || line.contains("X+42")).expect("a cut");
            assert!(lines[cut].contains("Y22") || lines[cut].contains("Y+22"), "{}", lines[cut]);
            // Straight down to the end of the cut, as if nothing were between.
            let other = lines[back]
                .replace("X41", "X42")
                .replace("X+41", "X+42")
                .replace("Y-21", "Y22")
                .replace("Y22", if control.spellings().name == "heidenhain" { "Y+22" } else { "Y22" });
            let mut edited = [&lines[..cut], &lines[cut + 1..]].concat();
            edited[back] = &other;
            assert!(!found(&edited).is_empty(), "{}: {other}\n{program}", control.spellings().name);
            assert!(!found(&[&lines[..cut], &lines[cut + 1..]].concat()).is_empty(), "{program}");
        }
    }
}

#[test]
fn it_does_in_every_mode_and_with_a_tool_axis_that_rotates() {
    for control in control::CONTROLS {
        for mode in ["axes", "auto"] {
            for (between, _) in BETWEEN {
                for cl in [CL.replace("BETWEEN", between), tilted().replace("BETWEEN", between)] {
                    for transition in ["safe", "direct"] {
                        let mut config = config(*control, mode);
                        if transition == "direct" {
                            config.motion.rapids.transition = pp_runtime::config::Transition::Direct;
                        }
                        // It passes its check.
                        posted::<SpinnerU5620>(&config, *control, &cl);
                    }
                }
            }
        }
    }
}

#[test]
fn an_operation_that_begins_with_a_cut_is_remarked_on() {
    let linuxcnc = by_name::control("linuxcnc");
    let remarks = |between: &str| -> Vec<u64> {
        let cl = CL.replace("BETWEEN", between);
        let written = posting::written::<SpinnerU5620>(&config(linuxcnc, "axes"), linuxcnc, &cl);
        let (_, report) = written.expect("it can run");
        let remarks = report.diagnostics.iter().filter(|remark| remark.text.contains("begins with a feed motion"));
        remarks.map(|remark| remark.location.line).collect()
    };
    assert_eq!(remarks("TOOL PATH/NEXT,TOOL,T"), [13]);
    for between in ["OPSTOP", "TOOL PATH/NEXT,TOOL,T\nLOADTL/1", "TOOL PATH/NEXT,TOOL,T\nRAPID", "PPRINT A"] {
        assert_eq!(remarks(between), [] as [u64; 0], "{between}");
    }
}
