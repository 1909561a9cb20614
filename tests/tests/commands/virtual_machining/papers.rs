//! The parts of the papers on their machines, with the configurations of `examples/virtual`: no collision, gouges
//! within the tolerances, rest material within the scallops.

use std::fs::{self, File};
use std::path::Path;
use std::sync::OnceLock;

use serde_json::Value;
use tempfile::TempDir;
use tests::binaries::{binary, workspace};

/// Tolerance of the CL data in these configurations, mm.
const TOLERANCE_MM: f64 = 0.01;

/// A folder with the configurations and the designs.
fn folder() -> &'static Path {
    static FOLDER: OnceLock<TempDir> = OnceLock::new();
    let folder = FOLDER.get_or_init(|| {
        let folder = TempDir::new().expect("a temporary folder");
        for entry in fs::read_dir(workspace().join("examples/virtual")).expect("the configurations") {
            let path = entry.expect("an entry").path();
            if path.extension().is_some_and(|end| end == "toml") {
                fs::copy(&path, folder.path().join(path.file_name().expect("a name"))).expect("a copy");
            }
        }
        for (name, design) in examples::designs::designs() {
            design.write(&mut File::create(folder.path().join(name)).expect("a file")).expect("it is written");
        }
        folder
    });
    folder.path()
}

/// Simulates a part; the pitch is coarse, so that a build without optimisation takes seconds.
fn simulated(machine: &str, cl: &str, config: &str) -> Value {
    let run = binary(machine)
        .arg("simulate")
        .arg(workspace().join("examples/cl").join(cl))
        .arg("--config")
        .arg(folder().join(config).with_extension("toml"))
        .args(["--pitch", "1.5", "--json", "--fail-on", "collision"])
        .output()
        .expect("it runs");
    let errors = String::from_utf8_lossy(&run.stderr);
    assert!(run.status.success(), "{config}: {errors}");
    let json: Value = serde_json::from_slice(&run.stdout).expect("figures");
    assert_eq!(json["collisions"], 0, "{config}: {errors}");
    json
}

/// Height of the scallop between two rows of a ball, mm: `curvature` is that of the surface across the rows, positive
/// where it is convex.
fn scallop(step: f64, ball: f64, curvature: f64) -> f64 {
    step * step / 8.0 * (1.0 / ball + curvature)
}

/// Distance of a chord of the centre of a ball from its circle, mm.
fn sagitta(step: f64, radius: f64) -> f64 {
    step * step / (8.0 * radius)
}

/// Compares the largest gouge and the largest rest material with what they may be at most: `intol`: of the generator of
/// the CL data, `left`: scallop or chord that the CL data leaves.
fn assert_deviations(json: &Value, intol: f64, left: f64, about: &str) {
    let design = &json["design"];
    let number = |key: &str| design[key].as_f64().expect("a number");
    let slack = TOLERANCE_MM + number("design_tolerance_mm") + number("certified_mm");
    let (gouge, rest) = (number("largest_gouge_mm"), number("largest_rest_mm"));
    assert!(gouge <= intol + slack, "{about}: gouge {gouge}, at most {intol} + {slack}");
    assert!(rest <= left + slack, "{about}: rest {rest}, at most {left} + {slack}");
    // The bound is no empty one: scallops are seen.
    assert!(left < 0.05 || rest > 0.4 * left, "{about}: rest {rest} of {left}");
    let parts = json["taking_part"].to_string();
    assert!(parts.contains("spindle") && parts.contains("bed"), "{about}: {parts}");
}

// The slope across the rows is at most 33/70, that along them 45/60.
const ACROSS: f64 = 1.106;
const ALONG: f64 = 1.25;

#[test]
fn the_dome_on_the_spinner_and_on_lola() {
    for (machine, config) in [("spinner-u5-620", "spinner-convex"), ("lola-xoyzba", "lola-convex")] {
        let json = simulated(machine, "convex.cls", config);
        let chord = sagitta(2.5 * ALONG, 66.0);
        assert_deviations(&json, chord, scallop(2.0 * ACROSS, 6.0, 1.0 / 70.0), config);
    }
}

#[test]
fn the_bowl_on_the_dmu_and_on_lola() {
    // One way in rows of 6 mm, chords of 2.5 mm; and zigzag in rows of 2 mm, chords of 3 mm.
    for (machine, cl, config, row, chord) in [
        ("dmu-70e", "concave.aptsource", "dmu-concave", 6.0, 2.5),
        ("lola-xoyzba", "concave.ncl", "lola-concave", 2.0, 3.0),
    ] {
        let json = simulated(machine, cl, config);
        let left = scallop(row * ACROSS, 6.0, -1.0 / 70.0) + sagitta(chord * ALONG, 54.0);
        assert_deviations(&json, 0.0, left, config);
    }
}

#[test]
fn the_trough_and_the_spiral_groove_on_multiprodesk() {
    let json = simulated("multiprodesk", "concave_4axis.cls", "multiprodesk-trough");
    // Rows of 2.5 mm along X, where the surface has a radius of 200 mm and a slope of 40/200; the ball leans by that
    // slope.
    let left = scallop(2.5 * 1.02, 4.0, -1.0 / 200.0) + sagitta(2.0 * 1.26, 46.0);
    assert_deviations(&json, 0.0, left, "trough");
    let json = simulated("multiprodesk", "spiral_groove.cls", "multiprodesk-groove");
    // Sixty chords for each revolution of the centre of the ball: they are 0.037 mm inside its helix.
    let chord = 27.0 * (1.0 - 3.0_f64.to_radians().cos());
    assert_deviations(&json, chord, chord, "groove");
}
