//! Programs checked by an independent checker: `../shared/real/fkcheck.py`, plain matrices in another language.
//!
//! Its input is a description of a machine as numbers, CL data and a program; its output is the distance of the tool
//! from the points, and between points from the lines that connect them. The descriptions are in the folder of the
//! checker; their numbers become the set-up here. If the checker, Python or numpy is missing, these tests print that
//! they are skipped, and pass.
//!
//! Words are positions of the gauge point in the machine: `program_zero = table` with the table's reference at the
//! origin of the description, `length_mode = gauge`. A description has one tool length: parts with several tools use
//! `length_mode = tip`.

use std::fs;
use std::io::Cursor;
use std::path::{Path, PathBuf};
use std::process::Command;

use approx::abs_diff_eq;
use pp_runtime::config::Config;
use pp_runtime::control::LinuxCnc;
use pp_runtime::kinematics::{AxisKind, Machine};
use pp_runtime::machine;
use pp_runtime::nalgebra::Vector3;
use pp_runtime::post::{Job, post};
use pp_runtime::program::Units;
use pp_runtime::set_up::{GivenTool, LengthMode, ProgramZero};
use serde_json::Value;
use tests::binaries::workspace;

machine! {
    /// `spinner_u5_620.json`.
    pub struct TableBc;
    chain: C B | X Y Z;
    dims = { c_x: 0.0, c_y: 0.0, c_z: 0.0, b_x: 0.0, b_y: 0.0, b_z: 0.0 };
    d = { C: (c_x, c_y, c_z), B: (b_x, b_y, b_z) };
}

machine! {
    /// `dmu70e.json`.
    pub struct Nutating;
    chain: C B | X Y Z;
    axes = { B: (0, 1, 1) };
    dims = { c_x: 0.0, c_y: 0.0, c_z: 0.0, b_x: 0.0, b_y: 0.0, b_z: 0.0 };
    d = { C: (c_x, c_y, c_z), B: (b_x, b_y, b_z) };
}

machine! {
    /// `linuxcnc_xyzac.json`.
    pub struct TableAc;
    chain: C A | X Y Z;
    dims = { c_x: 0.0, c_y: 0.0, c_z: 0.0, a_x: 0.0, a_y: 0.0, a_z: 0.0 };
    d = { C: (c_x, c_y, c_z), A: (a_x, a_y, a_z) };
    signs = { C: -, A: - };
}

machine! {
    /// `xobyzba.json`.
    pub struct HeadBa;
    chain: X | Y Z B A;
    dims = { b_x: 0.0, b_y: 0.0, b_z: 0.0, a_x: 0.0, a_y: 0.0, a_z: 0.0 };
    d = { B: (b_x, b_y, b_z), A: (a_x, a_y, a_z) };
}

machine! {
    /// `multiprodesk.json`.
    pub struct FourAxes;
    chain: A Y | X Z;
    dims = { a_x: 0.0, a_y: 0.0, a_z: 0.0 };
    d = { A: (a_x, a_y, a_z) };
}

/// Tolerance of the tip, mm: three linear words rounded to three decimals.
const TIP: f64 = 0.5e-3 * 1.7321 + 1e-6;

/// Tolerance of the tool axis, degrees: two angles rounded to four decimals.
const AXIS: f64 = 0.5e-4 * 1.4143 + 1e-7;

/// CL data from the workspace, and its tools: number, and length if the CL data has it, mm.
///
/// The checker does not support circles, cycles and a second frame.
type Part = (&'static str, &'static [(u32, Option<f64>)]);

const FIVE_AXES: &[Part] = &[
    ("examples/cl/convex.cls", &[(1, Some(120.0))]),
    ("examples/cl/concave.aptsource", &[(2, Some(120.0))]),
    ("examples/cl/concave.ncl", &[(2, Some(120.0))]),
    ("examples/cl/two_tools.cls", &[(1, Some(120.0)), (2, Some(95.0))]),
    ("tests/data/blade/blade.cls", &[(3, Some(101.5))]),
    ("tests/data/facets/facets.aptsource", &[(5, Some(132.5)), (6, Some(97.25))]),
    ("tests/data/rim/rim.ncl", &[(7, Some(84.3))]),
    ("tests/data/key_inch/key_inch.cls", &[(12, Some(120.65))]),
    ("tests/data/pads/pads.cls", &[(21, None), (22, None)]),
];

const FOUR_AXES: &[Part] = &[
    ("examples/cl/concave_4axis.cls", &[(3, None)]),
    ("examples/cl/spiral_groove.cls", &[(4, None)]),
    ("tests/data/coil/coil.cls", &[(4, None)]),
    ("tests/data/key_inch/key_inch.cls", &[(12, Some(120.65))]),
];

/// The checker, and a Python that can run it.
struct Checker {
    python: &'static str,
    folder: PathBuf,
}

impl Checker {
    /// The checker in the folder next to the workspace; `None` if it or Python is missing.
    fn find() -> Option<Self> {
        let folder = workspace().parent()?.join("shared/real");
        if !folder.join("fkcheck.py").is_file() {
            println!("skipped: no checker next to the workspace (shared/real/fkcheck.py)");
            return None;
        }
        let has_numpy = |python: &&str| {
            Command::new(python).args(["-c", "import numpy"]).output().is_ok_and(|output| output.status.success())
        };
        let python = ["/usr/bin/python3", "python3"].into_iter().find(has_numpy);
        if python.is_none() {
            println!("skipped: no python3 with numpy");
        }
        python.map(|python| Self { python, folder })
    }

    /// Checks a program; returns the exit status and the figures. Lengths and `chord` in mm.
    fn check(&self, machine: &str, cl: &str, program: &str, length: f64, chord: f64) -> (Option<i32>, Value) {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("program.ngc");
        fs::write(&path, program).expect("a file");
        let mut command = Command::new(self.python);
        command.arg(self.folder.join("fkcheck.py")).arg(self.folder.join("machines").join(format!("{machine}.json")));
        command.arg(workspace().join(cl)).arg(&path);
        let option = |name: &str, value: f64| [name.to_owned(), value.to_string()];
        command.args(option("--tool-length", length));
        command.args(option("--tol-pos", TIP)).args(option("--tol-ang", AXIS)).args(option("--tol-chord", chord));
        // A block this near to a point may belong to it; inserted blocks on the path are farther away.
        command.args(["--match", "seq", "--match-pos", "0.02", "--match-ang", "0.02", "--json"]);
        let output = command.output().expect("python runs");
        let printed = String::from_utf8_lossy(&output.stdout).into_owned();
        let errors = String::from_utf8_lossy(&output.stderr);
        let figures = serde_json::from_str(&printed).unwrap_or_else(|_| panic!("{machine} {cl}: {printed}{errors}"));
        (output.status.code(), figures)
    }
}

fn numbers(value: &Value) -> Vector3<f64> {
    let number = |index: usize| value.get(index).and_then(Value::as_f64).unwrap_or(0.0);
    Vector3::new(number(0), number(1), number(2))
}

/// Set-up from the numbers of a description, for a machine with the same chain, and the tool length, mm.
fn set_up<M: Machine>(description: &Value, tools: &[(u32, Option<f64>)]) -> (Config, f64) {
    let gauge_point = numbers(&description["gauge_point"]);
    let own_length = description["tool_length"].as_f64().unwrap_or(0.0);
    let single = tools.len() == 1;
    let mut config = Config::default();
    config.set_up.part_origin = (numbers(&description["frame"]["origin"]) - gauge_point).into();
    config.set_up.program_zero = ProgramZero::Table;
    config.set_up.length_mode = if single { LengthMode::Gauge } else { LengthMode::Tip };
    config.output_units = Some(Units::Millimetres);
    config.motion.retract.distance_mm = Some(60.0);
    for (number, length) in tools {
        let length = Some(length.unwrap_or(own_length));
        config.set_up.tools.insert(*number, GivenTool { length_mm: length, ..GivenTool::default() });
    }
    for axis in description["chain"].as_array().expect("a chain") {
        let letter = axis["name"].as_str().expect("a name").to_ascii_lowercase();
        let point = numbers(&axis["point"]) - gauge_point;
        for (coordinate, value) in ["x", "y", "z"].into_iter().zip(point.iter()).filter(|_| axis["type"] == "rotary") {
            config.set_up.dimensions.insert(format!("{letter}_{coordinate}"), *value);
        }
    }
    assert_same_chain(&config.set_up.machine::<M>().expect("valid"), description);
    let length = if single { config.set_up.tools.values().find_map(|tool| tool.length_mm).unwrap_or(0.0) } else { 0.0 };
    (config, length)
}

/// Checks that the declaration in this file is the chain of the description.
fn assert_same_chain<M: Machine>(machine: &M, description: &Value) {
    let chain = description["chain"].as_array().expect("a chain");
    assert_eq!(chain.len(), M::AXES.len(), "{}", description["name"]);
    for (index, (ours, theirs)) in M::AXES.iter().zip(chain).enumerate() {
        let joint = machine.joint(index);
        let kind = if ours.kind == AxisKind::Linear { "linear" } else { "rotary" };
        assert_eq!((theirs["name"].as_str(), theirs["type"].as_str()), (Some(&*ours.letter.to_string()), Some(kind)));
        let direction = numbers(&theirs["dir"]).normalize();
        assert!(abs_diff_eq!(joint.direction.into_inner(), direction, epsilon = 5e-13), "{theirs}");
        let sign = theirs["sign"].as_f64().unwrap_or(1.0);
        assert!(abs_diff_eq!(joint.sign, sign, epsilon = 1e-12), "{theirs}");
    }
    let plain = description["frame"].get("x").is_none() && description.get("offsets").is_none();
    assert!(plain, "a frame or offsets that are not supported here: {description}");
}

fn posted<M: Machine>(cl: &str, config: &Config) -> String {
    let text = fs::read(workspace().join(cl)).expect("CL data");
    let mut program = Vec::new();
    let job = Job { cl_name: cl, config, control: &LinuxCnc, units: None };
    let report = post::<M>(&job, &mut Cursor::new(text), &mut program).expect("memory");
    assert!(!report.failed, "{} {cl}: {:?}", M::NAME, report.diagnostics);
    String::from_utf8(program).expect("ASCII")
}

/// The program with the first axis word of a line, counted from 1, increased by `more`, mm or degrees.
fn damaged(program: &str, line: usize, more: f64) -> String {
    let mut lines: Vec<String> = program.lines().map(str::to_owned).collect();
    let mut words: Vec<String> = lines[line - 1].split(' ').map(str::to_owned).collect();
    let word = words.iter_mut().find(|word| word.starts_with(['X', 'Y', 'Z', 'A', 'B', 'C'])).expect("an axis moves");
    let value: f64 = word[1..].parse().expect("a number");
    *word = format!("{}{:.4}", &word[..1], value + more);
    lines[line - 1] = words.join(" ");
    lines.join("\n") + "\n"
}

/// Posts parts for a machine; the checker must accept each of them and reject damaged ones.
fn check<M: Machine>(checker: &Checker, name: &str, parts: &[Part]) {
    let text = fs::read_to_string(checker.folder.join("machines").join(format!("{name}.json"))).expect("a description");
    let description: Value = serde_json::from_str(&text).expect("JSON");
    for (cl, tools) in parts {
        let (config, length) = set_up::<M>(&description, tools);
        let program = posted::<M>(cl, &config);
        let chord = config.motion.tolerance_mm + TIP;
        let (status, figures) = checker.check(name, cl, &program, length, chord);
        println!(
            "{name} {cl}: {} points, tip {} mm, axis {} deg, path {} mm",
            figures["cl_points"], figures["max_pos_err_mm"], figures["max_axis_err_deg"], figures["max_chord_err_mm"]
        );
        assert_eq!(status, Some(0), "{name} {cl}: {figures}");
        assert_eq!(figures["cl_points"], figures["matched"], "{name} {cl}");
        for block in [&figures["max_pos_at"]["g_line"], &figures["max_axis_at"]["g_line"]] {
            let line = block.as_u64().expect("the line of a block") as usize;
            let (status, figures) = checker.check(name, cl, &damaged(&program, line, 0.004), length, chord);
            assert_eq!(status, Some(1), "{name} {cl} damaged in line {line}: {figures}");
        }
    }
}

#[test]
fn an_independent_checker_accepts_every_program_and_rejects_a_damaged_one() {
    let Some(checker) = Checker::find() else { return };
    let mut machines = 0;
    let heads: Vec<Part> = FIVE_AXES.iter().copied().filter(|(_, tools)| tools.len() == 1).collect();
    for file in fs::read_dir(checker.folder.join("machines")).expect("descriptions") {
        let name = Path::new(&file.expect("a file").file_name()).with_extension("").to_string_lossy().into_owned();
        machines += 1;
        match &*name {
            "spinner_u5_620" => check::<TableBc>(&checker, &name, FIVE_AXES),
            "dmu70e" => check::<Nutating>(&checker, &name, FIVE_AXES),
            "linuxcnc_xyzac" => check::<TableAc>(&checker, &name, FIVE_AXES),
            "xobyzba" => check::<HeadBa>(&checker, &name, &heads),
            "multiprodesk" => check::<FourAxes>(&checker, &name, FOUR_AXES),
            _ => {
                println!("{name}: its chain is not declared here");
                machines -= 1;
            }
        }
    }
    assert!(machines > 0, "the checker has no description of a machine");
}
