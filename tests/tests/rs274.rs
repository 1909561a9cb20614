//! The LinuxCNC programs of the samples, run by the interpreter of LinuxCNC itself.
//!
//! Skipped with a note where `rs274` is not installed; with `PP_REQUIRE_LINUXCNC=1` it must be there.

use std::env;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use tests::binaries::{binary, workspace};

/// CL file, configuration, machines.
const SAMPLES: &[(&str, Option<&str>, &[&str])] = &[
    ("examples/cl/two_tools.cls", None, &["dmu-70e", "lola-xoyzba", "spinner-u5-620"]),
    (
        "tests/data/pocket/pocket.cls",
        Some("tests/data/pocket/pocket.toml"),
        &["dmu-70e", "lola-xoyzba", "spinner-u5-620"],
    ),
    ("tests/data/plate/plate.ncl", Some("tests/data/plate/plate.toml"), &["dmu-70e", "lola-xoyzba", "spinner-u5-620"]),
    ("tests/data/nest/nest.apt", Some("tests/data/nest/nest.toml"), &["dmu-70e", "lola-xoyzba", "spinner-u5-620"]),
    ("tests/data/works/works.cls", Some("tests/data/works/works.toml"), &["dmu-70e", "lola-xoyzba", "spinner-u5-620"]),
    ("tests/data/coil/coil.cls", Some("tests/data/coil/coil.toml"), &["multiprodesk"]),
];

/// Whether the interpreter is there.
fn installed() -> bool {
    let found = Command::new("rs274").arg("-g").arg("/dev/null").output().is_ok();
    assert!(found || env::var_os("PP_REQUIRE_LINUXCNC").is_none(), "rs274 of LinuxCNC is required and not installed");
    if !found {
        println!("skipped: rs274 of LinuxCNC is not installed");
    }
    found
}

/// A folder of this test's own.
fn folder(name: &str) -> PathBuf {
    let folder = env::temp_dir().join(format!("pp-rs274-{}-{name}", std::process::id()));
    fs::create_dir_all(&folder).expect("a folder");
    folder
}

/// Runs a program; what the control does, or what it says against it.
fn interpreted(program: &str, folder: &Path) -> Result<String, String> {
    let (file, table) = (folder.join("program.ngc"), folder.join("tool.tbl"));
    fs::write(&file, program).expect("written");
    // Lengths are no matter of these tests: the guard of a posted length is left out, an unknown H is refused.
    let tools: String = (1..=30).chain([50, 51, 52]).map(|tool| format!("T{tool} P{tool} Z0 D0.1\n")).collect();
    fs::write(&table, tools).expect("written");
    let output = Command::new("rs274")
        .args(["-g", "-t"])
        .arg(&table)
        .arg("-v")
        .arg(folder.join("parameters.var"))
        .arg(&file)
        .current_dir(folder)
        .output()
        .expect("it runs");
    let said = String::from_utf8_lossy(&output.stdout).into_owned();
    let complaint = String::from_utf8_lossy(&output.stderr).into_owned();
    if output.status.success() { Ok(said) } else { Err(format!("{complaint}{}", said.lines().last().unwrap_or(""))) }
}

fn posted(machine: &str, cl: &str, config: Option<&str>) -> String {
    let mut command = binary(machine);
    command.current_dir(workspace()).args(["post", cl]);
    if let Some(config) = config {
        command.args(["--config", config]);
    }
    let output = command.output().expect("the binary runs");
    assert!(output.status.success(), "{machine} {cl}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).expect("ASCII")
}

/// Without the guards that stop a program whose tool has another length.
fn unguarded(program: &str) -> String {
    let guard = |line: &&str| !line.starts_with('o') && !line.starts_with("(abort,");
    program.lines().filter(guard).map(|line| format!("{line}\n")).collect()
}

#[test]
fn every_sample_is_accepted_and_its_arcs_are_arcs_there() {
    if !installed() {
        return;
    }
    let folder = folder("samples");
    for (cl, config, machines) in SAMPLES {
        for machine in *machines {
            let program = unguarded(&posted(machine, cl, *config));
            let said = interpreted(&program, &folder).unwrap_or_else(|why| panic!("{machine} {cl}: {why}"));
            let arcs = program.lines().filter(|line| [" I", " J", " K"].iter().any(|word| line.contains(word)));
            let arcs = arcs.filter(|line| !line.starts_with('(') && !line.contains("G33.1")).count();
            assert_eq!(said.matches("ARC_FEED").count(), arcs, "{machine} {cl}");
        }
    }
    fs::remove_dir_all(folder).expect("removed");
}

#[test]
fn a_wrong_centre_is_refused() {
    if !installed() {
        return;
    }
    let folder = folder("wrong");
    let program = unguarded(&posted("spinner-u5-620", "tests/data/nest/nest.apt", Some("tests/data/nest/nest.toml")));
    assert!(program.contains("I0 J5"), "{program}");
    assert!(interpreted(&program.replace("I0 J5", "I0 J4.8"), &folder).is_err());
    fs::remove_dir_all(folder).expect("removed");
}
