//! Packages outside the workspace, with the kinematics alone and the serde derives.
//!
//! One has a single dependency and no std: a static library with its own panic handler. If `std` were linked, there
//! would be two handlers and the build would fail. The other writes poses and machines as JSON and reads them back.

use std::path::Path;
use std::process::Command;
use std::{env, fs};

const MANIFEST: &str = r#"
[package]
name = "outside"
version = "0.0.0"
edition = "2024"

[workspace]

[lib]
crate-type = ["staticlib"]

[dependencies]
pp-runtime = { path = "@RUNTIME@", default-features = false, features = ["serde"] }

[profile.dev]
panic = "abort"
"#;

const SOURCE: &str = r#"
//! Generated kinematics on a bare target.
#![no_std]
#![deny(warnings, missing_docs)]
#![forbid(unsafe_op_in_unsafe_fn)]

use pp_runtime::kinematics::{Machine, Pose};
use pp_runtime::nalgebra::{Point3, UnitVector3, Vector3};

pp_runtime::machine! {
    /// A head with an inclined rotary axis.
    pub struct Head;
    chain: X Y | Z C B W;
    axes = { B: Rx(alpha) * Y };
    dims = { alpha: 45 deg, pivot: 80 };
    d = { C: (0, 0, 0), B: (0, 0, pivot) };
    hold = { W: 0 };
}

/// First rotary axis for a tool axis, rad; NaN where there is none.
#[must_use]
pub fn first_rotary(i: f64, j: f64, k: f64) -> f64 {
    let axis = UnitVector3::new_normalize(Vector3::new(i, j, k));
    let solutions = Head::default().inverse_kinematics(&Pose { tip: Point3::origin(), axis }, &Head::HELD);
    solutions.first().map_or(f64::NAN, |solution| solution.axes[3])
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    loop {}
}
"#;

const SERIALISED_MANIFEST: &str = r#"
[package]
name = "serialised"
version = "0.0.0"
edition = "2024"

[workspace]

[dependencies]
pp-runtime = { path = "@RUNTIME@", default-features = false, features = ["serde"] }
# Without the feature numbers are read to the last bit but one.
serde_json = { version = "1.0", features = ["float_roundtrip"] }
"#;

const SERIALISED_SOURCE: &str = r##"
use pp_runtime::kinematics::{Limits, Machine, Pose, Solution, nearest};
use pp_runtime::nalgebra::{Point3, UnitVector3, Vector3};
use serde_json::{from_str, to_string};

pp_runtime::machine! {
    /// A trunnion table.
    pub struct Trunnion;
    chain: C A | X Y Z;
    d = { A: (0, other, height) };
    dims = { height: 75.5, other: required };
    limits = { A: -110..110 };
}

fn refusal<T: pp_runtime::serde::de::DeserializeOwned>(text: &str) -> String {
    from_str::<T>(text).err().expect("refused").to_string()
}

fn main() {
    let machine = Trunnion { height: 80.1, other: 3.0, gauge_length: 120.25, ..Trunnion::default() };
    let text = to_string(&machine).unwrap();
    assert_eq!(from_str::<Trunnion>(&text).unwrap(), machine);
    assert_ne!(Trunnion { height: 80.2, ..machine.clone() }, machine);
    // Fields that are missing have their defaults; unknown ones are refused.
    let read: Trunnion = from_str(r#"{"other": 3.0}"#).unwrap();
    assert_eq!(read, Trunnion { other: 3.0, ..Trunnion::default() });
    assert!(from_str::<Trunnion>("{}").unwrap().other.is_nan());
    let text = refusal::<Trunnion>(r#"{"heigth": 80.1}"#);
    assert!(text.contains("unknown field `heigth`") && text.contains("`height`"), "{text}");

    let axis = UnitVector3::new_normalize(Vector3::new(0.1, 0.2, 0.9));
    let pose = Pose { tip: Point3::new(1.5, -2.25, 1e-9), axis };
    let text = to_string(&pose).unwrap();
    assert!(text.starts_with(r#"{"tip":[1.5,-2.25,"#), "{text}");
    assert_eq!(from_str::<Pose>(&text).unwrap(), pose);
    let text = refusal::<Pose>(r#"{"tip": [0.0, 0.0, 0.0], "axis": [0.0, 0.0, 2.0]}"#);
    assert!(text.contains("the length of the tool axis is 2, and must be 1"), "{text}");
    refusal::<Pose>(r#"{"tip": [0.0, 0.0, 0.0], "axis": [0.0, 0.0, 1.0], "spin": 1.0}"#);

    let solution = nearest(&machine, &pose, &Trunnion::HELD, None).unwrap();
    assert_eq!(from_str::<Solution<[f64; 5]>>(&to_string(&solution).unwrap()).unwrap(), solution);
    let limits = Trunnion::AXES[1].limits.unwrap();
    assert_eq!(from_str::<Limits>(&to_string(&limits).unwrap()).unwrap(), limits);
    println!("all read back");
}
"##;

/// Builds a package outside the workspace with the versions of the workspace: it needs no network. Output of the
/// command.
fn package(manifest: &str, file: &str, source: &str, command: &str) -> String {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("the workspace");
    let folder = tempfile::tempdir().expect("a temporary folder");
    let manifest = manifest.replace("@RUNTIME@", root.join("pp-runtime").to_str().expect("UTF-8"));
    fs::create_dir(folder.path().join("src")).expect("writable");
    fs::write(folder.path().join("Cargo.toml"), manifest).expect("writable");
    fs::write(folder.path().join("src").join(file), source).expect("writable");
    fs::copy(root.join("Cargo.lock"), folder.path().join("Cargo.lock")).expect("writable");
    let output = Command::new(env!("CARGO"))
        .args([command, "--offline"])
        .current_dir(folder.path())
        .env("CARGO_TARGET_DIR", root.join("target/outside"))
        .output()
        .expect("cargo runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).expect("UTF-8")
}

#[test]
fn a_package_outside_the_workspace_builds_a_machine_without_std() {
    package(MANIFEST, "lib.rs", SOURCE, "build");
}

#[test]
fn machines_poses_and_solutions_are_read_back_as_they_were_written() {
    assert_eq!(package(SERIALISED_MANIFEST, "main.rs", SERIALISED_SOURCE, "run"), "all read back\n");
}
