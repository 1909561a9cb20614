//! LinuxCNC, of the package `linuxcnc-uspace`: a control that nobody here wrote.
//!
//! - [`interpreter`]: its interpreter by itself, `rs274`, which says what a program asks for.

pub mod interpreter;

use std::process::Command;

/// Whether it is there; says so where it is not, unless `PP_REQUIRE_LINUXCNC=1` asks for it.
///
/// # Panics
/// If it has to be there and is not.
#[must_use]
pub fn installed() -> bool {
    let found = Command::new("rs274").arg("-h").output().is_ok();
    let required = std::env::var_os("PP_REQUIRE_LINUXCNC").is_some_and(|value| value == "1");
    assert!(found || !required, "PP_REQUIRE_LINUXCNC=1, and there is no rs274: install linuxcnc-uspace");
    if !found {
        println!("skipped: rs274 is not installed (package linuxcnc-uspace)");
    }
    found
}
