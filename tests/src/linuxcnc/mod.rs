//! LinuxCNC, from the package `linuxcnc-uspace`: a control that is not part of this project.
//!
//! - [`interpreter`]: its interpreter alone, `rs274`, which prints the motions of a program.
//! - [`module`]: a kinematics module by itself, loaded without the control.
//! - [`simulation`]: the whole control with its kinematics modules, which executes a program.

pub mod interpreter;
pub mod module;
pub mod simulation;

use std::path::PathBuf;

/// Whether the interpreter is installed; if not, prints that the test is skipped.
///
/// # Panics
/// If it is not installed and `PP_REQUIRE_LINUXCNC=1` requires it.
#[must_use]
pub fn installed() -> bool {
    has(&["rs274"])
}

/// Whether the whole control is installed; if not, prints that the test is skipped.
///
/// # Panics
/// If it is not installed and `PP_REQUIRE_LINUXCNC=1` requires it.
#[must_use]
pub fn can_be_simulated() -> bool {
    has(&["linuxcnc", "linuxcncrsh", "halsampler", "timeout"])
}

fn has(programs: &[&str]) -> bool {
    let missing = programs.iter().find(|program| !on_path(program));
    if let Some(missing) = missing {
        absent(&format!("{missing} of the package linuxcnc-uspace"));
    }
    missing.is_none()
}

/// Prints that a test is skipped because something is not there; fails if `PP_REQUIRE_LINUXCNC=1` requires it.
fn absent(what: &str) {
    let required = crate::environment::is_one("PP_REQUIRE_LINUXCNC");
    assert!(!required, "PP_REQUIRE_LINUXCNC=1, but there is not {what}");
    println!("skipped: there is not {what}");
}

/// Whether a program is in a folder of `PATH`.
fn on_path(name: &str) -> bool {
    let folders: Vec<PathBuf> =
        std::env::var_os("PATH").map(|path| std::env::split_paths(&path).collect()).unwrap_or_default();
    folders.iter().any(|folder| folder.join(name).is_file())
}
