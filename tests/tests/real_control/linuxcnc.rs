//! Programs for LinuxCNC, run by its own interpreter, `rs274` of the package `linuxcnc-uspace`.
//!
//! If it is not installed, the tests print that they are skipped and pass; with `PP_REQUIRE_LINUXCNC=1` they fail. The
//! interpreter reads its tool table in inches; each tool has the length for which the program was posted, so that the
//! length guards let it pass.

use std::fs;

use tests::binaries::{binary, workspace};
use tests::foreign::trace::Hole;
use tests::foreign::{Control, Effect, Options, run};
use tests::linuxcnc::installed;
use tests::linuxcnc::interpreter::interpret;

/// Number of blocks with motion, and whether one of them is a canned cycle, which makes several motions in a block.
fn moving_blocks(program: &str, dry: bool) -> (usize, bool) {
    let options = Options { dry, ..Options::of(Control::LinuxCnc) };
    let trace = run(program, &options).unwrap_or_else(|refused| panic!("{refused}"));
    let canned = |hole: Hole| hole.cycle.back_to.is_none();
    let cycles = trace.motions().any(|block| matches!(block.effect, Effect::Hole(hole) if canned(hole)));
    (trace.motions().count(), cycles)
}

/// Runs a program and checks that it passes with all its motions; `dry`: its spindle is off.
fn assert_runs(name: &str, program: &str, dry: bool) {
    let calls = interpret(program, 0.0).unwrap_or_else(|errors| panic!("{name}: {errors}"));
    let motion = |line: &&str| ["STRAIGHT_", "ARC_FEED", "RIGID_TAP"].iter().any(|call| line.contains(call));
    let motions = calls.lines().filter(motion).count();
    let (blocks, cycles) = moving_blocks(program, dry);
    assert!(motions == blocks || cycles && motions > blocks, "{name}: {motions} motions of {blocks} blocks");
}

fn printed(machine: &str, arguments: &[&str]) -> String {
    let output = binary(machine).current_dir(workspace()).args(arguments).output().expect("the binary runs");
    assert!(output.status.success(), "{machine} {arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).expect("ASCII")
}

#[test]
fn every_golden_program_runs() {
    if !installed() {
        return;
    }
    let mut count = 0;
    for part in fs::read_dir(workspace().join("tests/data")).expect("the folder of the parts") {
        for file in fs::read_dir(part.expect("a part").path()).expect("the folder of a part") {
            let path = file.expect("a file").path();
            if path.to_string_lossy().ends_with(".linuxcnc.nc") {
                assert_runs(&path.display().to_string(), &fs::read_to_string(&path).expect("ASCII"), false);
                count += 1;
            }
        }
    }
    assert!(count >= 28, "{count} programs");
}

#[test]
fn every_sample_runs_on_every_machine_that_it_suits() {
    if !installed() {
        return;
    }
    let five = ["concave.aptsource", "concave.ncl", "convex.cls", "two_tools.cls"];
    let four = ["concave_4axis.cls", "spiral_groove.cls"];
    let machines = ["dmu-70e", "lola-xoyzba", "spinner-u5-620"];
    let suited = machines.into_iter().flat_map(|machine| five.map(|part| (machine, part)));
    let works = ["--config", "tests/data/works/works.toml"];
    for machine in machines {
        let program = printed(machine, &["post", "tests/data/works/works.cls", works[0], works[1]]);
        assert!(program.contains("\nG33.1 Z-10 K1\n") && program.contains(" J"), "no thread or no arcs: {program}");
        assert_runs(&format!("{machine} works"), &program, false);
    }
    for (machine, part) in suited.chain(four.map(|part| ("multiprodesk", part))) {
        let name = format!("examples/cl/{part}");
        assert_runs(&format!("{machine} {name}"), &printed(machine, &["post", &name]), false);
    }
}

#[test]
fn a_proof_program_runs() {
    if !installed() {
        return;
    }
    let table = ["explain", "--proof-program", "--point=40,25,120"];
    assert_runs("spinner-u5-620", &printed("spinner-u5-620", &table), true);
    let head = ["explain", "--proof-program", "--config", "examples/config/lola-xoyzba-linuxcnc.toml"];
    assert_runs("lola-xoyzba", &printed("lola-xoyzba", &head), true);
}

#[test]
fn a_tool_of_another_length_is_stopped_by_the_guard_and_a_wrong_block_by_the_interpreter() {
    if !installed() {
        return;
    }
    let path = workspace().join("tests/data/two_tools/lola-xoyzba.linuxcnc.nc");
    let program = fs::read_to_string(path).expect("ASCII");
    for off in [0.011, -0.011] {
        let errors = interpret(&program, off).expect_err("stopped");
        assert!(errors.contains("T1 was posted with L = 120"), "{errors}");
    }
    assert!(interpret(&program, 0.009).is_ok());
    let wrong = interpret(&program.replacen("\nM8\n", "\nG68.2\n", 1), 0.0).expect_err("no such code");
    assert!(wrong.contains("G68.2"), "{wrong}");
}
