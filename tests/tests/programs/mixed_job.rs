//! The mixed job on a machine with one rotary axis in the head and one in the table: two set-ups, four tools, holes and
//! threads, tilted pockets with arcs and cutter compensation, a blade with a rewind, in one program.

use std::fs;
use std::io::Cursor;

use pp_runtime::check::check;
use pp_runtime::config::{Mode, starting_point};
use pp_runtime::diag::Severity;
use pp_runtime::post::{Job, post};
use tests::binaries::workspace;
use tests::by_name;
use tests::further::HeadTable;

/// The program, or its first error with its line.
fn posted(control: &str) -> Result<String, (u64, String)> {
    let folder = workspace().join("tests/data/mixed");
    let read = |name: &str| fs::read_to_string(folder.join(name)).expect("a file");
    let (cl, keys) = (read("mixed.cls"), read("mixed.toml"));
    let control = by_name::control(control);
    let mut config = starting_point(control).read_over(&HeadTable::default(), &keys).expect("valid keys");
    config.motion.mode = Mode::Auto;
    let job = Job { cl_name: "mixed.cls", config: &config, control, units: None };
    let mut program = Vec::new();
    let report = post::<HeadTable>(&job, &mut Cursor::new(&cl), &mut program).expect("it can run");
    if let Some(error) = report.diagnostics.into_iter().find(|found| found.severity == Severity::Error) {
        return Err((error.location.line, error.text));
    }
    let policy = config.check_policy::<HeadTable>(control, None).expect("it can be checked");
    let outcome = check::<HeadTable>(&policy, Cursor::new(&cl), &program[..]).expect("it can be read").outcome;
    let found: Vec<String> = outcome.findings.iter().map(|found| found.text.clone()).collect();
    let program = String::from_utf8(program).expect("ASCII");
    assert!(found.is_empty(), "{}: {found:?}\n{program}", control.spellings().title);
    Ok(program)
}

#[test]
fn controls_with_planes_and_tip_control_post_the_whole_job() {
    for (control, plane, tip) in [
        ("fanuc", "G68.2", "G43.4"),
        ("haas", "G268", "G234"),
        ("siemens", "CYCLE800(0", "TRAORI"),
        ("heidenhain", "PLANE SPATIAL", "FUNCTION TCPM F"),
    ] {
        let program = posted(control).unwrap_or_else(|error| panic!("{control}: {error:?}"));
        let blocks = |code: &str| program.lines().filter(|line| line.contains(code)).count();
        assert!(blocks(plane) >= 2 && blocks(tip) >= 1, "{control}\n{program}");
        let offsets = if control == "heidenhain" { ["Q339=+1", "Q339=+2"] } else { ["G54", "G55"] };
        assert!(offsets.iter().all(|offset| program.contains(offset)), "{control}\n{program}");
    }
}

#[test]
fn without_planes_a_tilted_pocket_on_the_head_is_refused_with_the_reason() {
    let (line, text) = posted("linuxcnc").expect_err("cutter compensation in a tilted pocket");
    assert!(line > 0 && text.contains("cutter compensation"), "{line}: {text}");
}
