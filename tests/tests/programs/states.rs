//! States that a program before may have left: planted before a program they change nothing of what it does, or its
//! guard stops it; and the check finds a program in which the code, the word or the guard is missing that deals with
//! one.
//!
//! LinuxCNC's states are planted in its own interpreter, those of the other controls in the foreign one.

use machines::SpinnerU5620;
use pp_runtime::config::{Config, starting_point};
use pp_runtime::control;
use tests::foreign::state::{
    Compensation, Distance, FeedMode, Length, MotionMode, Plane, ReturnLevel, Spindle, State, Units, WorkOffset,
};
use tests::foreign::{self, Control, Effect, Options, Trace};
use tests::linuxcnc::{self, interpreter};
use tests::posting::{bare, findings, posted, renumbered, written};

/// Two tools, a tilted tool axis, an arc, and holes.
const DATA: &str = "UNITS/MM
TOOL PATH/OP1,TOOL,T
LOADTL/1,LENGTH,100
SPINDL/RPM,2000,CLW
COOLNT/ON
RAPID
GOTO/0,0,30,0,0,1
FEDRAT/MMPM,300
GOTO/0,0,20
GOTO/10,0,20
CIRCLE/10,5,20,0,0,-1,5,0.05,0.5,10,0
GOTO/15,5,20
RAPID
GOTO/15,5,60
TOOL PATH/OP2,TOOL,U
LOADTL/2,LENGTH,110
SPINDL/RPM,1000,CLW
COOLNT/ON
RAPID
GOTO/0,0,30,0.5,0,0.8660254
FEDRAT/MMPM,200
GOTO/0,0,20
RAPID
GOTO/20,0,54.641016
TOOL PATH/OP3,TOOL,U
LOADTL/2
SPINDL/RPM,1000,CLW
RAPID
GOTO/0,0,50,0,0,1
CYCLE/DRILL,DEPTH,10,CLEAR,3,MMPM,100
GOTO/5,5,20
GOTO/9,5,20
CYCLE/OFF
RAPID
GOTO/9,5,60
FINI
";

fn config(name: &str, keys: &str) -> Config {
    let text = format!("part_origin = [0.0, 0.0, 0.0]\nmode = \"axes\"\n{keys}");
    let control = tests::by_name::control(name);
    starting_point(control).read_over(&SpinnerU5620::default(), &text).unwrap_or_else(|faults| panic!("{faults:?}"))
}

fn program(name: &str, keys: &str) -> String {
    posted::<SpinnerU5620>(&config(name, keys), tests::by_name::control(name), DATA)
}

/// A program without some text, wherever it is.
fn without(name: &str, program: &str, text: &str) -> String {
    let lines = if name == "heidenhain" { bare(program) } else { program.lines().collect() };
    let edited = lines.into_iter().filter_map(|line| {
        let (number, rest) = line.split_once(' ').filter(|(first, _)| first.starts_with('N')).unwrap_or(("", line));
        if rest == text {
            return None;
        }
        let words = || rest.split(' ');
        let is_there = !rest.starts_with(['(', ';']) && words().any(|word| word == text);
        let kept =
            std::iter::once(number).filter(|number| !number.is_empty()).chain(words().filter(|word| *word != text));
        Some(if is_there { kept.collect::<Vec<_>>().join(" ") } else { line.to_owned() })
    });
    let lines: Vec<String> = edited.collect();
    let lines: Vec<&str> = lines.iter().map(String::as_str).collect();
    renumbered(tests::by_name::control(name), &lines)
}

fn run(control: Control, text: &str, before: State) -> Result<Trace, foreign::Refused> {
    foreign::run(text, &Options { before, ..Options::of(control) })
}

/// What a program does: its motions, waits and stops, with the state that matters to them.
fn done(trace: &Trace) -> Vec<String> {
    let acts = trace.blocks.iter().filter(|block| {
        block.effect.moves() || matches!(block.effect, Effect::Dwell(_) | Effect::Stop | Effect::ToolChange(_))
    });
    let shown = acts.map(|block| {
        let State { units, plane, feed_mode, feed, work_offset, tool, length, spindle, speed, position, .. } =
            block.state;
        // Machine coordinates have no length, unless the control switches it off for them.
        let length = length.filter(|_| block.effect != Effect::Machine);
        let state = (units, plane, feed_mode, work_offset, tool, length);
        let spindle = (spindle, speed, feed);
        // A spindle that still runs does no harm on the way to the machine retract and the tool change, which stops it.
        let spindle = Some(spindle).filter(|_| block.effect.cuts());
        format!("{:?} {:?} {state:?} {spindle:?} {position:?}", block.effect, block.words)
    });
    shown.collect()
}

/// Modal states, one at a time.
fn planted(control: Control) -> Vec<State> {
    let before = State::default();
    let mut all = vec![
        State::left_on(control),
        State { feed: Some(77.0), ..before },
        State { spindle: Some(Spindle::CounterClockwise), speed: Some(99.0), ..before },
        State { tool: Some(9), length: Some(Length::Register(9)), ..before },
    ];
    // Words of Heidenhain say these themselves, and BEGIN PGM the unit.
    if control != Control::Heidenhain {
        all.extend([
            State { units: Some(Units::Inches), ..before },
            State { plane: Some(Plane::Zx), ..before },
            State { distance: Some(Distance::Incremental), ..before },
            State { motion: Some(MotionMode::Feed), feed: Some(77.0), ..before },
            State { motion: Some(MotionMode::Clockwise), ..before },
            State { feed_mode: Some(FeedMode::InverseTime), ..before },
            State { feed_mode: Some(FeedMode::PerRevolution), ..before },
            State { work_offset: Some(WorkOffset::Code(590)), ..before },
            State { compensation: Some(Compensation::Right(Some(3))), ..before },
            State { return_level: Some(ReturnLevel::Reference), ..before },
        ]);
    }
    all
}

#[test]
fn a_state_that_was_left_changes_nothing_of_what_a_program_does() {
    for control in Control::ALL {
        let text = program(control.name(), "");
        let plain = run(control, &text, State::default()).unwrap_or_else(|refused| panic!("{refused:?}\n{text}"));
        for before in planted(control) {
            let trace = run(control, &text, before).unwrap_or_else(|refused| panic!("{before:?}\n{refused:?}\n{text}"));
            assert_eq!(done(&trace), done(&plain), "{}: {before:?}", control.name());
        }
    }
}

#[test]
fn a_rotation_over_the_work_offset_is_stopped_by_the_guard_where_the_control_can_compare_it() {
    let rotated = State { rotated_offset: true, ..State::default() };
    for control in Control::ALL {
        let compares = !tests::by_name::control(control.name()).offset_guard(1).is_empty();
        let outcome = run(control, &program(control.name(), ""), rotated);
        assert_eq!(
            outcome.is_err_and(|refused| refused.why.contains("the guard stops")),
            compares,
            "{}",
            control.name()
        );
        let unguarded = program(control.name(), "offset_guard = false\n");
        assert!(run(control, &unguarded, rotated).is_ok());
        if compares {
            assert!(unguarded.to_lowercase().contains("rotat"), "the header has the condition: {unguarded}");
        }
    }
}

/// Motions before all axes have come to a position of the program.
const FIRST: usize = 4;

/// Blocks and words of LinuxCNC that last until the next program.
const LINUXCNC: [&str; 17] = [
    "G7",
    "G96 D2000 S100",
    "G90.1",
    "G91",
    "G18",
    "G19",
    "G20",
    "G93",
    "G95",
    "G55",
    "G61",
    "G64",
    "G43 H2",
    "G98",
    "G0 X1 Y1\nG1 X2 F300",
    "G0 X3\nG81 X1 Y1 Z-1 R2 F100",
    "T2 M6\nM3 S99\nM8",
];

#[test]
fn what_linuxcnc_keeps_from_a_program_before_changes_no_motion_or_stops_it() {
    if !linuxcnc::installed() {
        return;
    }
    let text = program("linuxcnc", "");
    let motions = |before: &str| {
        interpreter::interpret_edited(&format!("{before}\n{text}"), &text, 0.0)
            .map(|calls| interpreter::motions(&calls))
    };
    let plain = motions("").expect("the interpreter runs it");
    for before in LINUXCNC {
        let planted = motions(before).unwrap_or_else(|error| panic!("{before}: {error}"));
        assert_eq!(planted[planted.len() - plain.len()..][FIRST..], plain[FIRST..], "{before}");
    }
    for before in ["G92 X5", "G52 X5", "G10 L2 P1 R30"] {
        let stopped = motions(before);
        assert!(
            stopped.as_ref().is_err_and(|error| error.contains("lies over the work offset")),
            "{before}: {stopped:?}"
        );
    }
    // Each of these is what the line that deals with it changes.
    for (before, code) in [("G90.1", "G91.1"), ("G7", "G8"), ("G91", "G90"), ("G20", "G21")] {
        let edited = without("linuxcnc", &text, code);
        let found = interpreter::interpret_edited(&format!("{before}\n{edited}"), &text, 0.0);
        let same = found.is_ok_and(|calls| {
            let motions = interpreter::motions(&calls);
            motions.len() >= plain.len() && motions[motions.len() - plain.len()..][FIRST..] == plain[FIRST..]
        });
        assert!(!same, "without {code} the state of {before} changes nothing");
    }
}

/// What each control states at a restart point.
const ENDS: [(&str, &[&str]); 5] = [
    ("linuxcnc", &["G21", "G8", "G17", "G40", "G49", "G90", "G91.1", "G94", "G97", "G54", "G64"]),
    ("fanuc", &["G21", "G17", "G40", "G49", "G90", "G94", "G54"]),
    ("haas", &["G21", "G17", "G40", "G49", "G90", "G94", "G54"]),
    ("siemens", &["TRAFOOF", "CYCLE800()", "TRANS", "G710", "G17", "G40", "G64", "G90", "G94", "G54"]),
    ("heidenhain", &["M129", "PLANE RESET STAY", "M127"]),
];

#[test]
fn the_check_finds_a_program_that_lacks_a_code_or_its_guard() {
    for (name, codes) in ENDS {
        let (config, control) = (config(name, ""), tests::by_name::control(name));
        let text = program(name, "");
        for code in codes {
            let edited = without(name, &text, code);
            assert_ne!(edited, text, "{name} has {code}");
            let found = findings::<SpinnerU5620>(&config, control, DATA, &edited);
            assert!(!found.is_empty(), "{name} without {code}");
        }
        let guard = control.offset_guard(2);
        let lines: Vec<&str> = bare(&text);
        let edited: Vec<&str> = lines.iter().copied().filter(|line| !guard.iter().any(|of| of == line)).collect();
        if !guard.is_empty() {
            let found = findings::<SpinnerU5620>(&config, control, DATA, &renumbered(control, &edited));
            assert!(found.iter().any(|text| text.contains("guard")), "{name}: {found:?}");
        }
    }
}

#[test]
fn a_guard_of_the_work_offset_that_compares_something_else_is_found() {
    for (name, from, to) in [
        ("linuxcnc", "#5220", "#5221"),
        ("linuxcnc", "#5210 NE", "#5211 NE"),
        ("linuxcnc", "(abort, G92", "(G92"),
        ("siemens", "[Y,RT]", "[X,RT]"),
        ("siemens", ">0.0001", ">1"),
        ("siemens", " OR $P_ACTFRAME[Y,MI]", ""),
        ("heidenhain", "ID210 NR1", "ID210 NR2"),
        ("heidenhain", "EQU +0", "EQU +1"),
        ("heidenhain", "FN 14: ERROR = 102", "FN 14: ERROR = 0"),
    ] {
        let (config, control) = (config(name, ""), tests::by_name::control(name));
        let text = program(name, "");
        let edited = text.replacen(from, to, 1);
        assert_ne!(edited, text, "{name}: {from}");
        assert!(!findings::<SpinnerU5620>(&config, control, DATA, &edited).is_empty(), "{name}: {to}");
    }
}

/// Codes of options, which raise an alarm where the option is not installed.
const OPTIONS: [(&str, &[(&str, &str)]); 5] = [
    ("linuxcnc", &[]),
    (
        "fanuc",
        &[
            ("planes", "G69"),
            ("scaling", "G50"),
            ("rotation", "G69"),
            ("polar", "G15"),
            ("setting_error", "G54.4 P0"),
            ("smoothing", "G05.1 Q0"),
        ],
    ),
    (
        "haas",
        &[
            ("planes", "G269"),
            ("dynamic_offset", "G255"),
            ("scaling", "G50"),
            ("rotation", "G69"),
            ("smoothing", "G187"),
        ],
    ),
    ("siemens", &[("tip_control", "TRAFOOF"), ("planes", "CYCLE800()")]),
    ("heidenhain", &[("tip_control", "M129"), ("planes", "PLANE RESET STAY")]),
];

#[test]
fn codes_of_options_come_where_they_are_listed_and_the_check_asks_for_them_there() {
    for (name, options) in OPTIONS {
        let keys = |listed: &str| format!("[control]\nfunctions = [{listed}]\n");
        let none = program(name, &keys(""));
        for (function, code) in options {
            assert_eq!(without(name, &none, code), without(name, &none, ""), "{name} without functions has {code}");
            let listed = keys(&format!("\"{function}\""));
            let (config, text) = (config(name, &listed), program(name, &listed));
            let edited = without(name, &text, code);
            assert_ne!(edited, text, "{name} with {function} has {code}");
            // Of two codes of tip control either ends it.
            let edited = without(name, &edited, "FUNCTION RESET TCPM");
            let found = findings::<SpinnerU5620>(&config, tests::by_name::control(name), DATA, &edited);
            assert!(!found.is_empty(), "{name} with {function} and without {code}");
        }
    }
}

#[test]
fn an_axis_that_rolls_over_has_its_direction_in_each_word_of_siemens() {
    let keys = "wrap = { C = \"0..360\" }\n";
    let (config, control) = (config("siemens", keys), control::by_name("siemens").expect("a control"));
    let text = program("siemens", keys);
    assert!(text.contains("C=DC(0)"), "{text}");
    for wrong in ["C0", "C=AC(0)", "C=DC(400)"] {
        let found = findings::<SpinnerU5620>(&config, control, DATA, &text.replacen("C=DC(0)", wrong, 1));
        assert!(found.iter().any(|text| text.contains("DC(")), "{wrong}: {found:?}");
    }
    let plain = program("siemens", "");
    let found =
        findings::<SpinnerU5620>(&self::config("siemens", ""), control, DATA, &plain.replacen("C0", "C=DC(0)", 1));
    assert!(found.iter().any(|text| text.contains("DC(")), "{found:?}");
}

#[test]
fn conditions_on_the_control_are_in_the_header_of_the_program() {
    for control in Control::ALL {
        let name = control.name();
        let (program, report) =
            written::<SpinnerU5620>(&config(name, ""), tests::by_name::control(name), DATA).expect("it can run");
        assert!(!report.conditions.is_empty(), "{name}");
        let letters = |text: &str| text.to_uppercase().chars().filter(char::is_ascii_alphanumeric).collect::<String>();
        let header = letters(&bare(&program).concat());
        for condition in &report.conditions {
            assert!(header.contains(&letters(&format!("CONDITION {condition}"))), "{name}: {condition}\n{program}");
        }
    }
}
