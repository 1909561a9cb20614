//! Mode `auto`: which stretches get tip control, a tilted plane, or neither.
//!
//! Each row is an operation and the frames that its program switches on, in order. Every program passes its check.

use std::fmt::Write;
use std::io::Cursor;

use approx::abs_diff_eq;
use machines::{LolaXoyzba, SpinnerU5620};
use pp_runtime::check::check;
use pp_runtime::config::{Mode, starting_point};
use pp_runtime::diag::Severity;
use pp_runtime::kinematics::Machine;
use pp_runtime::post::{Job, post};
use tests::by_name;

const HEAD: &str = "UNITS/MM\nTOOL PATH/OP,TOOL,T\nLOADTL/1,LENGTH,100\nSPINDL/RPM,2000,CLW\n";

/// The part zero is the reference point of the table.
const ORIGIN: &str = "part_origin = [0.0, 0.0, 0.0]\n";

const KEYS: &str = "[retract]\ndistance = 40.0\n";

/// A tool axis that is tilted about Y by some degrees.
fn axis(degrees: f64) -> String {
    let (sine, cosine) = degrees.to_radians().sin_cos();
    format!("{sine:.7},0,{cosine:.7}")
}

/// A rapid to a tool axis and a cut with it.
fn face(degrees: f64) -> String {
    let axis = axis(degrees);
    format!("RAPID\nGOTO/0,0,30,{axis}\nFEDRAT/MMPM,300\nGOTO/0,0,20\nGOTO/0,20,20\nRAPID\nGOTO/0,20,60\n")
}

/// Cuts in which the tool axis rotates.
fn blade(from: f64, to: f64) -> String {
    let mut text = format!("RAPID\nGOTO/0,0,30,{}\nFEDRAT/MMPM,300\nGOTO/0,0,20\n", axis(from));
    for step in 1..=4_u8 {
        let along = f64::from(step) / 4.0;
        writeln!(text, "GOTO/0,{},20,{}", 20.0 * along, axis(from + (to - from) * along)).expect("a string");
    }
    text
}

fn holes(degrees: f64, cycle: &str) -> String {
    let axis = axis(degrees);
    format!("RAPID\nGOTO/0,0,60,{axis}\nCYCLE/{cycle}\nGOTO/0,0,10\nGOTO/0,20,10\nCYCLE/OFF\n")
}

const DRILL: &str = "DRILL,RAPTO,3,FEDTO,-8,RTRCTO,10,MMPM,200";
const TAP: &str = "TAP,RAPTO,5,FEDTO,-8,RTRCTO,10,MMPR,1";

/// An arc in the plane of a tool axis.
fn arc(degrees: f64) -> String {
    let axis = axis(degrees);
    format!(
        "RAPID\nGOTO/0,-10,30,{axis}\nFEDRAT/MMPM,300\nGOTO/0,-10,20\nCIRCLE/0,0,20,{axis},10\nGOTO/0,10,20\nRAPID\n\
         GOTO/0,10,60\n"
    )
}

/// The program of an operation, or its first error with its line.
fn posted<M: Machine>(control: &str, keys: &str, operation: &str) -> Result<String, (u64, String)> {
    posted_in::<M>("auto", control, keys, operation)
}

fn posted_in<M: Machine>(mode: &str, control: &str, keys: &str, operation: &str) -> Result<String, (u64, String)> {
    let control = by_name::control(control);
    let mut config =
        starting_point(control).read_over(&M::default(), &format!("{ORIGIN}{keys}\n{KEYS}")).expect("valid keys");
    config.motion.mode = Mode::NAMES.into_iter().find(|(name, _)| *name == mode).expect("a mode").1;
    let cl = format!("{HEAD}{operation}END-OF-PATH\nFINI\n");
    let job = Job { cl_name: "auto.cls", config: &config, control, units: None };
    let mut program = Vec::new();
    let report = post::<M>(&job, &mut Cursor::new(&cl), &mut program).expect("it can run");
    if let Some(error) = report.diagnostics.into_iter().find(|found| found.severity == Severity::Error) {
        return Err((error.location.line, format!("{}; {}", error.text, error.help.unwrap_or_default())));
    }
    let policy = config.check_policy::<M>(control, None).expect("it can be checked");
    let checked = check::<M>(&policy, Cursor::new(&cl), &program[..]).expect("it can be read");
    let text = String::from_utf8(program).expect("ASCII");
    assert!(checked.outcome.passed(), "{operation}\n{text}\n{:?}", checked.outcome.findings);
    Ok(text)
}

/// Frames in which a Heidenhain program goes down: `P` plane, `T` tip control. A plane in which X and Y come over the
/// approach point of tip control is not one of them.
fn frames(program: &str) -> String {
    let (mut frames, mut tilted) = (String::new(), false);
    for line in program.lines() {
        if line.contains("PLANE SPATIAL") || line.contains("PLANE RESET") {
            tilted = line.contains("PLANE SPATIAL");
        } else if line.contains("FUNCTION TCPM F") {
            frames.push('T');
        } else if tilted && line.contains(" Z") {
            frames.push('P');
            tilted = false;
        }
    }
    frames
}

#[test]
fn the_tool_axis_of_a_stretch_decides_its_mode() {
    let faces = |count: u8| (1..=count).map(|step| face(5.0 * f64::from(step))).collect::<String>();
    let rows: &[(&str, String, &str)] = &[
        ("vertical holes", holes(0.0, DRILL), ""),
        ("a vertical thread", holes(0.0, TAP), ""),
        ("vertical cuts", face(0.0), ""),
        ("tilted holes", holes(30.0, DRILL), "P"),
        ("a tilted thread", holes(30.0, TAP), "P"),
        ("one face", face(30.0), "P"),
        ("eight faces", faces(8), "PPPPPPPP"),
        ("nine faces", faces(9), "T"),
        ("nine faces and an arc", faces(9) + &arc(60.0), "PPPPPPPPPP"),
        ("nine faces and holes", faces(9) + &holes(60.0, DRILL), "PPPPPPPPPP"),
        ("a blade", blade(20.0, 40.0), "T"),
        ("a blade and a face", blade(20.0, 40.0) + &face(50.0), "T"),
        ("a blade and holes", blade(20.0, 40.0) + &holes(50.0, DRILL), "TP"),
        ("a blade and a thread", blade(20.0, 40.0) + &holes(50.0, TAP), "TP"),
        ("a blade and vertical holes", blade(20.0, 40.0) + &holes(0.0, DRILL), "T"),
        ("holes, then a blade from where they end", holes(20.0, DRILL) + "FEDRAT/MMPM,300\n" + &cut(20.0, 40.0), "PT"),
        ("a tool axis that varies in its digits", face(30.0) + &noise(), "P"),
    ];
    for (what, operation, expected) in rows {
        let program = posted::<SpinnerU5620>("heidenhain", "", operation);
        let program = program.unwrap_or_else(|(line, text)| panic!("{what}: line {line}: {text}"));
        assert_eq!(windows(&frames(&program), expected), *expected, "{what}\n{program}");
    }
}

/// Tip control is switched on again after each safe sequence: repetitions count once.
fn windows(frames: &str, expected: &str) -> String {
    let mut shown: Vec<char> = frames.chars().collect();
    if expected.contains('T') {
        shown.dedup_by(|a, b| *a == 'T' && *b == 'T');
    }
    shown.into_iter().collect()
}

/// Cuts that go on from where the tool is.
fn cut(from: f64, to: f64) -> String {
    let middle = 0.5 * (from + to);
    format!("GOTO/0,22,22,{}\nGOTO/0,24,22,{}\n", axis(middle), axis(to))
}

/// Cuts whose tool axis differs from 30 degrees by the last digit of CL data.
fn noise() -> String {
    let points = (0..4_u8).map(|step| {
        let (sine, cosine) = 30_f64.to_radians().sin_cos();
        let off = if step % 2 == 0 { 4e-6 } else { -4e-6 };
        format!("GOTO/0,{},20,{:.6},0,{:.6}\n", 20 - step, sine + off, cosine)
    });
    "FEDRAT/MMPM,300\n".to_owned() + &points.collect::<String>()
}

#[test]
fn x_of_a_plane_is_that_of_the_part() {
    // Tilted about Y by 45 degrees: the angle about Y alone, and Y of the points as in the drawing.
    let operation = face(45.0);
    for (control, plane) in [
        ("heidenhain", "PLANE SPATIAL SPA+0 SPB+45 SPC+0 TURN MB MAX FMAX SEQ+ COORD ROT"),
        ("fanuc", "G68.2 X0. Y0. Z0. I90. J45. K-90."),
        ("haas", "G268 X0. Y0. Z0. I0. J45. K0. Q123"),
        ("siemens", "CYCLE800(0,\"\",0,57,0,0,0,0,45"),
    ] {
        let by = if control == "haas" { "control.plane_by = \"tilted_plane\"\n" } else { "" };
        let program = posted_in::<SpinnerU5620>("plane", control, by, &operation).expect("it can be posted");
        assert!(program.contains(plane), "{control}\n{program}");
    }
}

#[test]
fn a_key_sets_how_many_planes_an_operation_may_have() {
    let operation = face(10.0) + &face(20.0) + &face(30.0);
    let frames_of = |keys| frames(&posted::<SpinnerU5620>("heidenhain", keys, &operation).expect("it can be posted"));
    assert_eq!(frames_of("auto_planes = 3"), "PPP");
    assert!(frames_of("auto_planes = 2").chars().all(|frame| frame == 'T'));
}

#[test]
fn a_setting_that_is_missing_is_an_error_where_a_stretch_needs_it() {
    assert!(posted::<SpinnerU5620>("fanuc", "", &holes(30.0, DRILL)).is_ok());
    let (line, text) = posted::<SpinnerU5620>("fanuc", "", &blade(20.0, 40.0)).expect_err("tip control has no frame");
    assert!(line == 6 && text.contains("give `tcp_frame`"), "line {line}: {text}");
    assert!(posted::<SpinnerU5620>("fanuc", "tcp_frame = \"table_at_zero\"", &blade(20.0, 40.0)).is_ok());
}

#[test]
fn a_function_that_is_not_installed_is_not_used() {
    let operation = holes(30.0, DRILL) + &blade(20.0, 40.0);
    let frames_with = |functions: &str| {
        let keys = format!("control = {{ functions = {functions} }}");
        frames(&posted::<SpinnerU5620>("heidenhain", &keys, &operation).expect("it can be posted"))
    };
    assert_eq!(frames_with("[\"tip_control\", \"planes\"]"), "PT");
    assert_eq!(frames_with("[\"planes\"]"), "P");
    assert_eq!(frames_with("[\"tip_control\"]"), "T");
    assert_eq!(frames_with("[]"), "");
}

#[test]
fn cutter_compensation_is_refused_where_the_tool_axis_rotates() {
    let keys = "[compensation]\npath = \"contour\"\n";
    let compensated = |operation: &str| operation.replacen("FEDRAT", "CUTCOM/LEFT,XYPLAN\nFEDRAT", 1);
    let (_, text) = posted::<SpinnerU5620>("heidenhain", keys, &compensated(&blade(20.0, 40.0))).expect_err("refused");
    assert!(text.contains("cutter compensation"), "{text}");
}

#[test]
fn without_planes_and_tip_control_words_are_axis_positions() {
    let operation = holes(30.0, DRILL) + &blade(20.0, 40.0);
    let program = posted::<SpinnerU5620>("linuxcnc", "", &operation).expect("it can be posted");
    assert!(program.contains("MODE auto [axes]"), "{program}");
    // A tilted head without planes: holes are single motions, and a thread is refused.
    let program = posted::<LolaXoyzba>("linuxcnc", "", &holes(30.0, DRILL)).expect("it can be posted");
    assert!(!program.contains("G81"), "{program}");
    let (_, text) = posted::<LolaXoyzba>("linuxcnc", "", &holes(30.0, TAP)).expect_err("refused");
    assert!(text.contains("tapping"), "{text}");
}

#[test]
fn a_length_is_guarded_in_a_head_without_tip_control_only() {
    let guarded = |control, keys: &str| {
        let program = posted::<LolaXoyzba>(control, keys, &blade(20.0, 40.0)).expect("it can be posted");
        program.contains("was posted with L")
    };
    assert!(guarded("linuxcnc", ""));
    assert!(!guarded("heidenhain", ""));
    assert!(guarded("heidenhain", "length_guard = true"));
}

/// A machine with a C table is at C0 in vertical operations, so that X and Y are read as on the drawing. An operation
/// that begins vertically and tilts at feed begins with the angle to which it tilts.
#[test]
fn vertical_operations_are_at_zero() {
    // Tilted about X: C is at -90 or 90 degrees there.
    let tilted = "RAPID\nGOTO/0,0,30,0,0.5,0.8660254\nFEDRAT/MMPM,300\nGOTO/0,0,20\nRAPID\nGOTO/0,20,60\n";
    let vertical = format!("END-OF-PATH\nTOOL PATH/TOP,TOOL,T\nLOADTL/1\n{}", face(0.0));
    let tilting = "END-OF-PATH\nTOOL PATH/BLADE,TOOL,T\nLOADTL/1\nRAPID\nGOTO/0,0,30,0,0,1\nFEDRAT/MMPM,300\nGOTO/0,0,20\n\
                   GOTO/0,5,20,0,0.2588190,0.9659258\nGOTO/0,10,20,0,0.5,0.8660254\n";
    for mode in ["axes", "auto"] {
        for control in ["linuxcnc", "heidenhain"] {
            let angles = |keys: &str, operation: &str| {
                let keys = format!("{keys}\ntcp_confirmed = true");
                let program = posted_in::<SpinnerU5620>(mode, control, &keys, operation);
                positions(&program.unwrap_or_else(|(line, text)| panic!("line {line}: {text}")))
            };
            let after_tilted = |operation: &str| angles("", &(tilted.to_owned() + operation));
            let [first, second] = after_tilted(&vertical)[..] else { panic!("two positions") };
            let same = abs_diff_eq!(first.abs(), 90.0, epsilon = 1e-3) && abs_diff_eq!(second, 0.0, epsilon = 1e-9);
            assert!(same, "{mode} {control}: {first} {second}");
            for keys in ["singular = \"previous\"", "singular = \"shortest\""] {
                let previous = angles(keys, &(tilted.to_owned() + &vertical));
                assert_eq!(previous.last(), previous.first(), "{mode} {control} {keys}");
            }
            let [.., begin] = after_tilted(tilting)[..] else { panic!("a position") };
            assert!(abs_diff_eq!(begin.abs(), 90.0, epsilon = 1e-3), "{mode} {control}: {begin}");
        }
    }
}

/// Angles of C in the blocks that position the rotary axes alone, and where it does not move, the one before.
fn positions(program: &str) -> Vec<f64> {
    let word = |line: &str, letter: char| {
        line.split_whitespace().find_map(|word| word.strip_prefix(letter)?.parse::<f64>().ok())
    };
    let mut found = Vec::new();
    for line in program.lines().filter(|line| !line.contains([';', '(']) && !line.contains("PLANE")) {
        if let Some(angle) = word(line, 'C').filter(|_| word(line, 'X').is_none() && word(line, 'Z').is_none()) {
            found.push(angle);
        }
    }
    found
}
