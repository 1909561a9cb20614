//! LinuxCNC, of the package `linuxcnc-uspace`: a control that nobody here wrote.
//!
//! - [`interpreter`]: its interpreter by itself, `rs274`, which says what a program asks for.
//! - [`simulation`]: the whole control with its kinematics modules, which runs a program.

pub mod interpreter;
pub mod simulation;

use std::path::PathBuf;

/// Whether the interpreter is there; says so where it is not, unless `PP_REQUIRE_LINUXCNC=1` asks for it.
///
/// # Panics
/// If it has to be there and is not.
#[must_use]
pub fn installed() -> bool {
    has(&["rs274"])
}

/// Whether the whole control is there; says so where it is not, unless `PP_REQUIRE_LINUXCNC=1` asks for it.
///
/// # Panics
/// If it has to be there and is not.
#[must_use]
pub fn can_be_simulated() -> bool {
    has(&["linuxcnc", "linuxcncrsh", "halsampler", "timeout"])
}

fn has(programs: &[&str]) -> bool {
    let required = std::env::var_os("PP_REQUIRE_LINUXCNC").is_some_and(|value| value == "1");
    let missing = programs.iter().find(|program| !on_path(program));
    if let Some(missing) = missing {
        assert!(!required, "PP_REQUIRE_LINUXCNC=1, and there is no {missing}: install linuxcnc-uspace");
        println!("skipped: {missing} is not installed (package linuxcnc-uspace)");
    }
    missing.is_none()
}

/// Whether a program is there to be run.
fn on_path(name: &str) -> bool {
    let folders: Vec<PathBuf> =
        std::env::var_os("PATH").map(|path| std::env::split_paths(&path).collect()).unwrap_or_default();
    folders.iter().any(|folder| folder.join(name).is_file())
}
