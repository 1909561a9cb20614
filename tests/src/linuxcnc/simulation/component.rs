//! Kinematics of a machine that LinuxCNC has no module for: `table.c`, compiled for that machine, or a generated
//! module.
//!
//! LinuxCNC loads modules from its own folder only. In a mount namespace of its own it sees the component there, beside
//! its own modules; no other program sees it.

use std::fs;
use std::io;
use std::path::Path;
use std::process::{Command, Stdio};

use super::super::absent;
use super::super::module::MODULES;

/// The module whose place `table.c` takes: the one that LinuxCNC has for kinematics of one's own.
pub(super) const MODULE: &str = "userkins";

/// Folder with the modules that the control sees, in the folder of the configuration.
const SEEN: &str = "modules";

/// Folder with the modules of LinuxCNC, in the folder of the configuration.
const OWN: &str = "installed";

/// A rotation of the table, right-handed.
#[derive(Debug, Clone, Copy)]
pub struct Rotation {
    /// Direction in which a positive angle turns the tool about the workpiece, unit vector.
    pub direction: [f64; 3],
    /// A point of the centre line in machine coordinates, mm.
    pub point: [f64; 3],
}

/// A table of two rotary axes: C carries the workpiece, B carries C.
#[derive(Debug, Clone, Copy)]
pub struct RotaryTable {
    /// Rotation by B.
    pub b: Rotation,
    /// Rotation by C, with B at zero.
    pub c: Rotation,
}

/// Whether a component can be compiled and put in place; if not, prints that the test is skipped.
///
/// # Panics
/// If it cannot, and `PP_REQUIRE_LINUXCNC=1` requires it.
#[must_use]
pub fn can_be_loaded() -> bool {
    let runs = |program: &str, arguments: &[&str]| {
        let output = Command::new(program).args(arguments).stdout(Stdio::null()).stderr(Stdio::null()).status();
        output.is_ok_and(|status| status.success())
    };
    let missing = if !runs("cc", &["--version"]) {
        "a C compiler, `cc`"
    } else if !runs("unshare", &[&namespace()[..], &["true"]].concat()) {
        "the permission for a mount namespace (unshare --mount)"
    } else {
        return true;
    };
    absent(missing);
    false
}

/// Arguments of `unshare` for a mount namespace; who is not root has the right to mount in a user namespace of their
/// own.
fn namespace() -> Vec<&'static str> {
    match super::is_root() {
        Ok(true) => vec!["--mount"],
        Ok(false) | Err(_) => vec!["--map-current-user", "--keep-caps", "--mount"],
    }
}

/// Compiles the component into a folder.
pub(super) fn compile(table: &RotaryTable, folder: &Path) -> io::Result<()> {
    let source = folder.join("table.c");
    std::fs::write(&source, include_str!("table.c"))?;
    let mut command = Command::new("cc");
    command.args(["-shared", "-fPIC", "-O2", "-Wall", "-Wextra", "-Werror"]);
    for (letter, rotation) in [('B', &table.b), ('C', &table.c)] {
        let numbers = |[x, y, z]: [f64; 3]| format!("{{{x:?}, {y:?}, {z:?}}}");
        command.arg(format!("-D{letter}_DIRECTION={}", numbers(rotation.direction)));
        command.arg(format!("-D{letter}_POINT={}", numbers(rotation.point)));
    }
    let compiled = folder.join(MODULE).with_extension("so");
    let output = command.arg("-o").arg(&compiled).arg(source).arg("-lm").output()?;
    if output.status.success() {
        return show(&compiled, folder);
    }
    Err(io::Error::other(String::from_utf8_lossy(&output.stderr).into_owned()))
}

/// Prepares the modules that the control will see: those of LinuxCNC, and the compiled one.
pub(super) fn show(compiled: &Path, folder: &Path) -> io::Result<()> {
    let (seen, own) = (folder.join(SEEN), folder.join(OWN));
    fs::create_dir(&seen)?;
    fs::create_dir(&own)?;
    let name = compiled.file_name().ok_or(io::ErrorKind::InvalidInput)?;
    fs::copy(compiled, seen.join(name))?;
    for module in fs::read_dir(MODULES)? {
        let other = module?.file_name();
        if other != name {
            std::os::unix::fs::symlink(own.join(&other), seen.join(&other))?;
        }
    }
    Ok(())
}

/// The beginning of a command that sees the modules of a folder in place of LinuxCNC's.
pub(super) fn in_place(command: &mut Command, folder: &Path) {
    let script = format!("mount --bind {MODULES} \"$0/{OWN}\" && mount --bind \"$0/{SEEN}\" {MODULES} && exec \"$@\"");
    command.arg("unshare").args(namespace()).args(["sh", "-c", &script]).arg(folder);
}
