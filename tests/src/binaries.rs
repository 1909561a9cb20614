//! The built binaries, run as a user runs them, and the golden programs that they write.

use std::ffi::OsStr;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;

use pp_runtime::config::Mode;

/// The samples on the machines of the papers, with their example configurations: machine, control, CL file.
pub const SAMPLES: [(&str, &str, &str); 4] = [
    ("spinner-u5-620", "siemens", "two_tools.cls"),
    ("multiprodesk", "fanuc", "concave_4axis.cls"),
    ("lola-xoyzba", "linuxcnc", "convex.cls"),
    ("dmu-70e", "heidenhain", "two_tools.cls"),
];

/// Path of an example configuration, in the workspace.
#[must_use]
pub fn example_config(machine: &str, control: &str) -> String {
    format!("examples/config/{machine}-{control}.toml")
}

/// The folder of the workspace.
#[must_use]
pub fn workspace() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap_or(Path::new(".")).to_owned()
}

/// Golden programs: the `.nc` files in the folders of `tests/data`, sorted.
///
/// # Panics
/// If a folder cannot be read.
#[must_use]
pub fn golden_programs() -> Vec<PathBuf> {
    let mut files = Vec::new();
    let mut folders = vec![workspace().join("tests/data")];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).expect("a folder of the parts") {
            let path = entry.expect("an entry").path();
            match path.extension() {
                _ if path.is_dir() => folders.push(path),
                Some(extension) if extension == "nc" => files.push(path),
                _ => {}
            }
        }
    }
    files.sort();
    files
}

/// Folder of the part of a golden program, and the mode of the program: programs of other modes than `axes` are in a
/// folder of their mode in that of the part.
///
/// # Panics
/// If the file is in no folder.
#[must_use]
pub fn part_and_mode(golden: &Path) -> (&Path, Mode) {
    let folder = golden.parent().expect("a folder");
    let name = folder.file_name().unwrap_or_default();
    match Mode::NAMES.into_iter().find(|(mode, _)| name == *mode) {
        Some((_, mode)) => (folder.parent().expect("the part"), mode),
        None => (folder, Mode::Axes),
    }
}

/// Configuration with which a golden program was posted; its folder is that of the part, or of a mode in it.
///
/// # Panics
/// If the path is not that of a golden program.
#[must_use]
pub fn config_of(path: &Path, machine: &str) -> (String, Mode) {
    let (part, mode) = part_and_mode(path);
    let name = part.file_name().expect("a name").to_string_lossy().into_owned();
    let name = if name == "works" && machine != "lola-xoyzba" { "table".to_owned() } else { name };
    (fs::read_to_string(part.join(format!("{name}.toml"))).unwrap_or_default(), mode)
}

/// A command that runs the binary of a machine. The first call builds all binaries that are out of date.
///
/// # Panics
/// If they cannot be built.
#[must_use]
pub fn binary(name: &str) -> Command {
    static DIRECTORY: OnceLock<PathBuf> = OnceLock::new();
    let directory = DIRECTORY.get_or_init(build);
    let path = directory.join(format!("{name}{}", std::env::consts::EXE_SUFFIX));
    assert!(path.is_file(), "{} was not built", path.display());
    Command::new(path)
}

/// Builds the binaries with the profile of the running test, into the parent folder of the test. Of the whole
/// workspace, whose features are those of the tests: the runtime is not compiled again.
fn build() -> PathBuf {
    let test = std::env::current_exe().expect("the path of the running test");
    // TARGET/PROFILE/deps/TEST
    let directory = test.parent().and_then(Path::parent).expect("a test is in the folder `deps`").to_owned();
    let target = directory.parent().expect("the folder of a profile has a parent");
    let profile = match directory.file_name().and_then(OsStr::to_str) {
        Some("debug") | None => "dev",
        Some(profile) => profile,
    };
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let mut build = Command::new(cargo);
    build.current_dir(workspace()).args(["build", "--quiet", "--workspace", "--profile", profile]);
    build.arg("--target-dir").arg(target);
    for folder in ["machines/src/bin", "machines/library/src/bin"] {
        for binary in fs::read_dir(workspace().join(folder)).expect("the machines") {
            let path = binary.expect("an entry").path();
            build.arg("--bin").arg(path.file_stem().expect("a name"));
        }
    }
    let status = build.status().expect("cargo can be run");
    assert!(status.success(), "the binaries do not build");
    directory
}
