//! A package outside the workspace: one dependency, no std, with the serde derives.
//!
//! It is a static library with its own panic handler. If `std` were linked, there would be two handlers and the build
//! would fail.

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

#[test]
fn a_package_outside_the_workspace_builds_a_machine_without_std() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("the workspace");
    let folder = tempfile::tempdir().expect("a temporary folder");
    let manifest = MANIFEST.replace("@RUNTIME@", root.join("pp-runtime").to_str().expect("UTF-8"));
    fs::create_dir(folder.path().join("src")).expect("writable");
    fs::write(folder.path().join("Cargo.toml"), manifest).expect("writable");
    fs::write(folder.path().join("src/lib.rs"), SOURCE).expect("writable");
    // The versions of the workspace: what is built here needs no network.
    fs::copy(root.join("Cargo.lock"), folder.path().join("Cargo.lock")).expect("writable");
    let output = Command::new(env!("CARGO"))
        .args(["build", "--offline"])
        .current_dir(folder.path())
        .env("CARGO_TARGET_DIR", root.join("target/outside"))
        .output()
        .expect("cargo runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
}
