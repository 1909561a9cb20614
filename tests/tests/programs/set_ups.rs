//! Several set-ups in one program: each is posted as it would be alone, with its own part origin, rotation and work
//! offset, and between two of them the axes are parked and the program stops.

use machines::{Dmu70e, LolaXoyzba, SpinnerU5620};
use pp_runtime::config::{Config, starting_point};
use pp_runtime::control::{self, Control};
use pp_runtime::diag::Severity;
use pp_runtime::kinematics::Machine;
use tests::by_name;
use tests::posting::{findings, written};

const FIRST: &str = "TOOL PATH/OP10,TOOL,T
MSYS/0,0,0,1,0,0,0,1,0
LOADTL/1,LENGTH,100
SPINDL/RPM,2000,CLW
COOLNT/ON
RAPID
GOTO/0,0,30,0.5,0,0.8660254
FEDRAT/MMPM,300
GOTO/0,0,20
GOTO/0,20,20
RAPID
GOTO/0,20,60
END-OF-PATH
";

/// The frame of the second set-up is upside down in the model; its numbers are coordinates of that frame.
const SECOND: &str = "TOOL PATH/OP20,TOOL,T
MSYS/0,0,-40,1,0,0,0,-1,0
LOADTL/2,LENGTH,100
SPINDL/RPM,2000,CLW
COOLNT/ON
RAPID
GOTO/5,0,30,0.3420201,0,0.9396926
FEDRAT/MMPM,300
GOTO/5,0,20
GOTO/5,20,20
RAPID
GOTO/5,20,60
END-OF-PATH
";

const KEYS: &str = "tcp_confirmed = true
tcp_frame = 'table_at_zero'
[retract]
distance = 40.0
";

const HERE: &str = "part_origin = [7.0, -3.0, 45.0]
part_rotation = [0.0, 0.0, 90.0]
work_offset = \"G55\"
";

fn config<M: Machine>(control: &'static dyn Control, mode: &str, keys: &str) -> Config {
    let keys = if control.spellings().name == "fanuc" { keys.to_owned() } else { keys.replace("tcp_frame", "#") };
    let given = keys.split('[').next().is_some_and(|keys| keys.contains("part_origin"));
    let origin = if given { "" } else { "part_origin = [0.0, 0.0, 0.0]\n" };
    let text = format!("mode = '{mode}'\n{origin}{keys}");
    starting_point(control).read_over(&M::default(), &text).unwrap_or_else(|faults| panic!("{text}: {faults:?}"))
}

/// The program, which passes its check; the first error with its line.
fn posted<M: Machine>(config: &Config, control: &'static dyn Control, cl: &str) -> Result<String, (u64, String)> {
    let (text, report) = written::<M>(config, control, cl).expect("it can run");
    if let Some(error) = report.diagnostics.into_iter().find(|found| found.severity == Severity::Error) {
        return Err((error.location.line, format!("{}; {}", error.text, error.help.unwrap_or_default())));
    }
    let found = findings::<M>(config, control, cl, &text);
    assert!(found.is_empty(), "{text}\n{found:?}");
    Ok(text)
}

/// Blocks with axis words, from the block on that holds the first tool call in the operation of this name. Numbers at
/// the begin of a block are left out.
fn motions(program: &str, operation: &str) -> Vec<String> {
    let unnumbered = |line: &str| line.trim_start_matches(|c: char| c.is_ascii_digit()).trim_start().to_owned();
    let after = program.lines().skip_while(|line| !line.contains(operation) || line.contains("LINE"));
    let tool = after.map(unnumbered).skip_while(|line| !(line.contains("S2000") || line.contains("TOOL CALL")));
    // Labels are numbered through the program.
    let moves =
        |line: &String| line.contains(['X', 'Y', 'B', 'C']) && !line.contains([';', '(']) && !line.contains("LBL");
    tool.filter(moves).collect()
}

fn alone_and_together<M: Machine>(control: &'static dyn Control, mode: &str) {
    for keys in ["", "program_zero = \"table\"\n"] {
        alone_and_together_with::<M>(control, mode, &format!("{keys}{KEYS}"));
    }
}

fn alone_and_together_with<M: Machine>(control: &'static dyn Control, mode: &str, keys: &str) {
    let name = format!("{} {mode}", control.spellings().name);
    let whole = format!("UNITS/MM\n{FIRST}{SECOND}FINI\n");
    let together = config::<M>(control, mode, &format!("{keys}[set_ups.2]\n{HERE}"));
    let together = posted::<M>(&together, control, &whole).unwrap_or_else(|error| panic!("{name}: {error:?}"));
    let alone = config::<M>(control, mode, &format!("{HERE}{keys}"));
    let alone = posted::<M>(&alone, control, &format!("UNITS/MM\n{SECOND}FINI\n")).expect("the set-up alone");
    let [one, other] = [&alone, &together].map(|program| motions(program, "OP20"));
    assert!(one.len() > 3, "{name}: {alone}");
    assert_eq!(one, other, "{name}\n{together}");
    // A guard ends the program after its stop.
    let stops = |pair: &&[&str]| matches!(pair[0].split(' ').next_back(), Some("M0" | "M00")) && pair[1] != "M30";
    let lines: Vec<&str> = together.lines().collect();
    assert_eq!(lines.windows(2).filter(stops).count(), 1, "{name}\n{together}");
}

#[test]
fn a_set_up_is_posted_as_it_would_be_alone() {
    for control in control::CONTROLS {
        for mode in ["axes", "auto"] {
            alone_and_together::<SpinnerU5620>(*control, mode);
            alone_and_together::<Dmu70e>(*control, mode);
        }
    }
    for control in control::CONTROLS.iter().filter(|control| control.spellings().plane.is_some()) {
        alone_and_together::<SpinnerU5620>(*control, "plane");
        alone_and_together::<LolaXoyzba>(*control, "plane");
        alone_and_together::<SpinnerU5620>(*control, "tcp");
    }
}

#[test]
fn what_is_wrong_between_two_set_ups_is_found() {
    let control = by_name::control("siemens");
    let cl = format!("UNITS/MM\n{FIRST}{SECOND}FINI\n");
    let config = config::<SpinnerU5620>(control, "axes", &format!("park = {{ C = 0.0 }}\n{KEYS}[set_ups.2]\n{HERE}"));
    let program = posted::<SpinnerU5620>(&config, control, &cl).expect("it can be posted");
    let offset = program.replacen("G94 G55", "G94 G54", 1);
    assert_ne!(offset, program);
    let stop = program.replacen("\nM0\n", "\n", 1);
    assert_ne!(stop, program);
    let park = program.replacen("\nG0 C0\n", "\n", 1);
    assert_ne!(park, program);
    for (what, edited) in [("the work offset of the first set-up", offset), ("no stop", stop), ("not parked", park)] {
        assert!(!findings::<SpinnerU5620>(&config, control, &cl, &edited).is_empty(), "{what}");
    }
    // The second set-up with the origin, or the rotation, of the first.
    for changed in ["part_origin = [0.0, 0.0, 0.0]", "part_rotation = [0.0, 0.0, 0.0]"] {
        let key = changed.split(' ').next().unwrap_or_default();
        let line = HERE.lines().find(|line| line.starts_with(key)).expect("a key");
        let keys = format!("park = {{ C = 0.0 }}\n{KEYS}[set_ups.2]\n{}", HERE.replace(line, changed));
        let other = self::config::<SpinnerU5620>(control, "axes", &keys);
        assert!(!findings::<SpinnerU5620>(&other, control, &cl, &program).is_empty(), "{changed}");
    }
}

/// `machine_zero` is stated for the first set-up; a part that is clamped higher is nearer to the end of the travel.
#[test]
fn the_travel_counts_from_where_the_part_is_clamped() {
    let control = by_name::control("linuxcnc");
    let cl = format!("UNITS/MM\n{FIRST}{SECOND}FINI\n");
    let clamped = |height: f64| {
        let travel = "tcp_confirmed = true\nretract = { distance = 40.0 }\nmachine_zero = { X = 0.0, Y = 0.0, Z = -400.0 }\n[limits]\nZ = [-600.0, 0.0]\n";
        let part = format!("[set_ups.2]\nwork_offset = \"G55\"\npart_origin = [0.0, 0.0, {height:?}]\n");
        let config = config::<SpinnerU5620>(control, "axes", &format!("{travel}{part}"));
        posted::<SpinnerU5620>(&config, control, &cl)
    };
    assert!(clamped(150.0).is_ok());
    let (line, text) = clamped(400.0).expect_err("out of travel");
    assert!(line > 14 && text.contains("Z would have to move to"), "line {line}: {text}");
}

#[test]
fn a_set_up_that_does_not_begin_is_an_error() {
    let control = by_name::control("haas");
    let cl = format!("UNITS/MM\n{FIRST}FINI\n");
    for (begins, text) in [("begins = \"OP21\"", "no operation is called `OP21`"), ("frames = [3]", "its frames")] {
        let keys = format!("{KEYS}[set_ups.2]\nwork_offset = \"G55\"\n{begins}\n");
        let (_, found) = posted::<SpinnerU5620>(&config::<SpinnerU5620>(control, "auto", &keys), control, &cl)
            .expect_err("it does not begin");
        assert!(found.contains("set-up 2 of the configuration does not begin") && found.contains(text), "{found}");
    }
}

#[test]
fn without_a_table_a_second_frame_is_refused_with_one_to_paste() {
    let control = by_name::control("heidenhain");
    let cl = format!("UNITS/MM\n{FIRST}{SECOND}FINI\n");
    let alone = config::<SpinnerU5620>(control, "auto", KEYS);
    let (line, text) = posted::<SpinnerU5620>(&alone, control, &cl).expect_err("a second frame");
    assert!(line == 16 && text.contains("[set_ups.2]") && text.contains("--frames main"), "line {line}: {text}");
}

#[test]
fn the_header_states_the_zero_of_each_set_up_where_it_is_known() {
    for (name, lines) in [
        ("fanuc", ["G54 must hold X-200 Y-100 Z-500", "G55 must hold X-193 Y-103 Z-455"]),
        (
            "heidenhain",
            [
                "the zero of preset 1 must be at X-200 Y-100 Z-500 in",
                "the zero of preset 2 must be at X-193 Y-103 Z-455 in",
            ],
        ),
    ] {
        let control = by_name::control(name);
        let zero = "table_zero = { X = -200.0, Y = -100.0, Z = -500.0 }\npark = { C = 0.0 }\n";
        let config = config::<SpinnerU5620>(control, "axes", &format!("{zero}{KEYS}[set_ups.2]\n{HERE}"));
        let (program, _) =
            written::<SpinnerU5620>(&config, control, &format!("UNITS/MM\n{FIRST}{SECOND}FINI\n")).expect("it can run");
        let plain = program.replace('+', "").to_lowercase();
        lines.iter().for_each(|line| assert!(plain.contains(&line.to_lowercase()), "{program}"));
    }
}
