//! `post --map` and `explain-block`: CL record of every line of a program, and machine position after it, compared with
//! the program itself, the CL data and the oracle.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use approx::abs_diff_eq;
use machines::{Dmu70e, LolaXoyzba, SpinnerU5620};
use nalgebra::Vector3;
use pp_runtime::config::Config;
use pp_runtime::control::LinuxCnc;
use pp_runtime::kinematics::{AxisKind, Machine, Pose};
use serde_json::Value;
use tests::binaries::{binary, workspace};
use tests::by_name;
use tests::foreign::{Control, Effect, Options, Trace, lexer, run};
use tests::oracle::{Oracle, angle_between};

const CL: &str = "tests/data/works/works.cls";

/// Modes, their controls, and the operations that are posted.
const MODES: &[(&str, &[&str], &str)] = &[
    ("axes", &["linuxcnc", "fanuc", "siemens", "heidenhain", "haas"], "1..5"),
    ("tcp", &["fanuc", "heidenhain"], "1..4"),
    ("plane", &["siemens", "haas"], "1..3"),
];

/// One posted program and its map.
struct Posted {
    name: String,
    control: Control,
    program: Vec<String>,
    lines: Vec<Value>,
}

fn posted(machine: &str, config: &str, control: &str, mode: &str, operations: &str) -> Posted {
    let folder = tempfile::tempdir().expect("a folder");
    let [map, program] = ["map.json", "part.nc"].map(|name| folder.path().join(name));
    let output = binary(machine)
        .current_dir(workspace())
        .args(["post", CL, "--config", config, "--control", control, "--mode", mode, "--ops", operations])
        .args((control != "heidenhain").then_some("--line-numbers"))
        .args([Path::new("--map"), &map, Path::new("-o"), &program])
        .output()
        .expect("the binary runs");
    let name = format!("{machine} {control} {mode}");
    assert!(output.status.success(), "{name}: {}", String::from_utf8_lossy(&output.stderr));
    let text = fs::read_to_string(&map).expect("a map");
    let whole: Value = serde_json::from_str(&text).expect("a map is JSON");
    assert_eq!(whole["cl"], "works.cls");
    let program = fs::read_to_string(&program).expect("a program");
    Posted {
        name,
        control: Control::by_name(control).expect("a control"),
        program: program.lines().map(str::to_owned).collect(),
        lines: whole["lines"].as_array().expect("a list").clone(),
    }
}

impl Posted {
    /// The program, run by the foreign interpreter.
    fn trace(&self) -> Trace {
        let text = self.program.join("\n") + "\n";
        run(&text, &Options::of(self.control)).unwrap_or_else(|refused| panic!("{}: {refused}", self.name))
    }
}

fn numbers<const N: usize>(value: &Value) -> Option<[f64; N]> {
    let list = value.as_array()?.iter().map(|number| number.as_f64().expect("a number"));
    list.collect::<Vec<f64>>().try_into().ok()
}

/// Numbers of a GOTO record.
fn goto(record: &str) -> Option<Vec<f64>> {
    let numbers = record.strip_prefix("GOTO/")?.split(',').map(|number| number.trim().parse());
    Some(numbers.collect::<Result<_, _>>().expect("numbers"))
}

/// Checks that the map has every line once, in order, with its block number.
fn assert_complete(posted: &Posted) {
    let Posted { name, control, program, lines } = posted;
    assert_eq!(lines.len(), program.len(), "{name}");
    for (index, (line, text)) in lines.iter().zip(program).enumerate() {
        assert_eq!(line["line"], index as u64 + 1, "{name}");
        // A continuation line with the parameters of a cycle has no number.
        let number = match text.starts_with(' ') {
            true => None,
            false => lexer::line(*control, text).unwrap_or_else(|why| panic!("{name}: {why}: {text}")).number,
        };
        let number = number.map(u64::from);
        assert_eq!(line["number"].as_u64(), number, "{name} line {}: {text}", index + 1);
    }
}

/// Checks that tips agree with the axis values by the oracle, and with the points of their records.
fn assert_tips<M: Machine>(posted: &Posted, config: &str) {
    let text = fs::read_to_string(workspace().join(config)).expect("a configuration");
    let config = Config::read::<M>(&text, &LinuxCnc).expect("a valid configuration");
    let mut machine = config.set_up.machine::<M>().expect("a valid machine");
    let cl = fs::read_to_string(workspace().join(CL)).expect("CL data");
    let records: Vec<&str> = cl.lines().collect();
    let (mut length, mut named) = (0.0, 0);
    for line in &posted.lines {
        let context = format!("{} {line}", posted.name);
        let record = line["cl_line"].as_u64().map_or("", |line| records[line as usize - 1]);
        if line["step"] == "tool" || line["step"] == "restart" {
            // The tool of the operation: the last one called before its first point.
            let before = &records[..line["cl_line"].as_u64().expect("a record") as usize];
            let call = before.iter().rev().find_map(|record| record.strip_prefix("LOAD/TOOL,")).expect("a tool");
            let number: u32 = call.split(',').next().and_then(|number| number.parse().ok()).expect("a number");
            length = config.set_up.tools[&number].length_mm.expect("a length");
        }
        let Some(tip) = numbers::<3>(&line["tip"]) else { continue };
        machine.set_up(Vector3::from(config.set_up.part_origin), length);
        let value = |axis: &pp_runtime::kinematics::Axis| {
            let value = line["axes"][axis.letter.to_string()].as_f64().unwrap_or_default();
            if axis.kind == AxisKind::Rotary { value.to_radians() } else { value }
        };
        let values: Vec<f64> = M::AXES.iter().map(value).collect();
        let Pose { tip: true_tip, axis: true_axis } = Oracle::of(&machine).forward(&values);
        let off = (true_tip.coords - Vector3::from(tip)).norm();
        assert!(off < 1.5e-3, "{context}: {off} mm");
        let axis = Vector3::from(numbers::<3>(&line["axis"]).expect("a tool axis"));
        let axis_off = angle_between(&true_axis.into_inner(), &axis);
        // Two axes, each off by half a thousandth of a degree.
        assert!(axis_off < 1.8e-5, "{context}: {axis_off} rad");
        if line["why"] == "record" && ["feed", "rapid", "arc"].iter().any(|step| line["step"] == *step) {
            let point = goto(record).unwrap_or_else(|| panic!("{context}: its record is {record}, expected GOTO"));
            let off = (Vector3::new(point[0], point[1], point[2]) - Vector3::from(tip)).norm();
            assert!(off < 1e-6, "{context}: {off} mm from {record}");
            named += 1;
        }
    }
    assert!(named > 10, "{}: {named} points of the CL data", posted.name);
}

/// Checks that in mode `axes` the words in force are the axis values plus a constant shift for each tool, and that an
/// axis with a value in the map has a word in force.
fn assert_words(posted: &Posted) {
    let trace = posted.trace();
    let mut shifts: BTreeMap<(char, Option<u32>), f64> = BTreeMap::new();
    let mut compared = 0;
    for block in trace.motions() {
        let line = &posted.lines[block.line - 1];
        let cycle = matches!(block.effect, Effect::Hole(_));
        let Some(axes) = line["axes"].as_object() else { continue };
        for (letter, value) in axes {
            let letter = letter.chars().next().expect("a letter");
            let context = format!("{} {line}", posted.name);
            let word = block.state.position.get(letter).unwrap_or_else(|| panic!("{context}: {letter} has no word"));
            let shift = value.as_f64().expect("a number") - word;
            let known = *shifts.entry((letter, block.state.tool)).or_insert(shift);
            // At the end of a cycle the words are those above the hole, rounded separately.
            let room = if cycle { 1.1e-3 } else { 1e-5 };
            assert!(abs_diff_eq!(shift, known, epsilon = room), "{context}: {letter} is {word} in the block");
            compared += 1;
        }
    }
    assert!(compared > 500, "{}: {compared} words", posted.name);
}

#[test]
fn every_line_is_mapped_and_every_tip_agrees_with_its_axis_values() {
    let mut reasons = BTreeSet::new();
    for &(mode, controls, operations) in MODES {
        for &control in controls {
            let [table, works] = ["table", "works"].map(|name| format!("tests/data/works/{name}.toml"));
            let spinner = posted("spinner-u5-620", &table, control, mode, operations);
            let dmu = posted("dmu-70e", &table, control, mode, operations);
            let lola = posted("lola-xoyzba", &works, control, mode, operations);
            for posted in [&spinner, &dmu, &lola] {
                assert_complete(posted);
                // The helices of Heidenhain are incremental.
                if mode == "axes" && control != "heidenhain" {
                    assert_words(posted);
                }
                reasons.extend(posted.lines.iter().filter_map(|line| line["why"].as_str()).map(str::to_owned));
            }
            assert_tips::<SpinnerU5620>(&spinner, &table);
            assert_tips::<Dmu70e>(&dmu, &table);
            assert_tips::<LolaXoyzba>(&lola, &works);
        }
    }
    let expected =
        ["head", "record", "tolerance", "rewind", "split-arc", "chord", "hole", "lead-out", "start", "approach"];
    for why in expected {
        assert!(reasons.contains(why), "no line has the reason {why}: {reasons:?}");
    }
    // The chapter of the book has all of them.
    let chapter = std::fs::read_to_string(workspace().join("docs/src/embed.md")).expect("docs/src/embed.md");
    for why in &reasons {
        assert!(chapter.contains(&format!("`{why}`")), "docs/src/embed.md has no `{why}`");
    }
}

fn explained(arguments: &[&str]) -> (Option<i32>, String, String) {
    let output = binary("spinner-u5-620").current_dir(workspace()).args(arguments).output().expect("the binary runs");
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).expect("text");
    (output.status.code(), text(output.stdout), text(output.stderr))
}

#[test]
fn a_block_is_explained_by_number_and_by_line_as_in_the_map() {
    let part = ["examples/cl/two_tools.cls"];
    let (status, text, _) = explained(&["explain-block", part[0], "N120", "--line-numbers"]);
    assert_eq!(status, Some(0));
    let expected = "\
line 51 of the program (feed):
    N120 G1 Z25.096 F1000
programmed by this record
examples/cl/two_tools.cls, line 17:
    GOTO/-0.3923,-28.0000,6.0000
tip X -0.3923, Y -28.0000, Z 6.0000 mm in the workpiece
tool axis I 0.5000000, J 0.0000000, K 0.8660254
axis values C 0.0000°, B 30.0000°, X 71.6600, Y -28.0000, Z 25.0960
branch 1 of the inverse kinematics
";
    assert_eq!(text, expected);
    let (_, json, _) = explained(&["explain-block", part[0], "51", "--message-format", "json"]);
    let line: Value = serde_json::from_str(&json).expect("an object");
    assert_eq!((&line["line"], &line["cl_line"], &line["number"]), (&51.into(), &17.into(), &Value::Null));
    let (_, head, _) = explained(&["explain-block", part[0], "1"]);
    assert!(head.contains("the head of the program, before the first record"), "{head}");
}

#[test]
fn a_missing_block_is_reported() {
    let missing = |block: &str, more: &[&str], expected: &str| {
        let arguments = [&["explain-block", "examples/cl/two_tools.cls", block], more].concat();
        let (status, text, errors) = explained(&arguments);
        assert_eq!((status, text.as_str()), (Some(2), ""), "{block}");
        assert!(errors.contains(expected), "{block}: {errors}");
    };
    missing("N77", &["--line-numbers"], "there is no block N77: the program has 92 lines");
    missing("N120", &[], "Give all options that the program was posted with, --line-numbers too");
    missing("9999", &[], "there is no line 9999");
    missing("0", &[], "expected a block number such as `N1230`, or a line of the program such as `57`");
    missing("X12", &[], "expected a block number");
}

#[test]
fn only_motions_have_positions_for_any_selection_of_operations() {
    let check = |control: &str, mode: &str, operations: &str| {
        let posted = posted("lola-xoyzba", "tests/data/works/works.toml", control, mode, operations);
        assert_complete(&posted);
        let moves = ["feed", "rapid", "arc", "cycle"];
        let still = |line: &&Value| !moves.iter().any(|step| line["step"] == *step);
        let with_position = posted.lines.iter().filter(still).find(|line| !line["axes"].is_null());
        assert_eq!(with_position, None, "{control} {mode} {operations}");
    };
    for control in by_name::controls() {
        for operations in ["2", "2..3", "3..", "5"] {
            check(control, "axes", operations);
        }
    }
    for control in by_name::controls_with_tip_control() {
        check(control, "tcp", "2..4");
        check(control, "plane", "2..3");
    }
}

#[test]
fn comments_about_the_check_are_in_the_map() {
    let folder = tempfile::tempdir().expect("a folder");
    let config = folder.path().join("table.toml");
    let table = fs::read_to_string(workspace().join("tests/data/works/table.toml")).expect("a configuration");
    fs::write(&config, format!("{table}\n[program]\nchecked = true\n")).expect("a configuration");
    for control in ["linuxcnc", "fanuc", "heidenhain"] {
        let posted = posted("dmu-70e", &config.display().to_string(), control, "axes", "1..2");
        assert_complete(&posted);
        let check_lines: Vec<&Value> = posted.lines.iter().filter(|line| line["step"] == "check").collect();
        let line = check_lines.first().and_then(|line| line["line"].as_u64()).expect("a line of the check");
        assert!(posted.program[line as usize - 1].to_lowercase().contains("checked"), "{control}: {check_lines:?}");
        // The last line comes after these comments and is explained unchanged.
        let (count, last) = (posted.program.len().to_string(), posted.program.last().expect("a line"));
        let arguments =
            ["explain-block", CL, &count, "--control", control, "--mode", "axes", "--ops", "1..2", "--config"];
        let mut command = binary("dmu-70e");
        command.current_dir(workspace()).args(arguments).arg(&config);
        let numbers = (control != "heidenhain").then_some("--line-numbers");
        let printed = command.args(numbers).output().expect("the binary runs");
        let printed = String::from_utf8_lossy(&printed.stdout).into_owned();
        assert!(printed.contains(&format!("\n    {last}\n")), "{control}: {last} is missing in\n{printed}");
    }
}

#[test]
fn a_map_is_written_only_with_its_program() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = |name: &str| folder.path().join(name);
    let good = fs::read_to_string(workspace().join("examples/cl/two_tools.cls")).expect("CL data");
    let post = |cl: &str, map: &str| {
        fs::write(path("part.cls"), cl).expect("a file can be written");
        let run = binary("spinner-u5-620")
            .current_dir(&folder)
            .args(["post", "part.cls", "-o", "part.nc", "--map", map])
            .output();
        run.expect("the binary runs").status.code()
    };
    assert_eq!(post(&good, "part.json"), Some(0));
    assert!(path("part.json").is_file());
    // The map of an earlier program is removed with that program.
    assert_eq!(post(&good.replacen("GOTO/", "GOTO/x", 1), "part.json"), Some(1));
    assert!(!path("part.json").exists() && !path("part.nc").exists());
    // Standard output, redirected to a file.
    let into = |file: fs::File, map: &str| {
        let mut command = binary("spinner-u5-620");
        command.current_dir(&folder).args(["post", "part.cls", "--map", map]).stdout(file);
        command.status().expect("the binary runs").code()
    };
    fs::write(path("part.cls"), &good).expect("a file can be written");
    if Path::new("/dev/stdout").exists() {
        for map in ["both.txt", "/dev/stdout"] {
            assert_eq!(into(fs::File::create(path("both.txt")).expect("a file"), map), Some(2), "{map}");
        }
        assert_eq!(into(fs::File::create(path("other.nc")).expect("a file"), "both.txt"), Some(0));
    }
    for other in ["part.cls", "part.nc", "part.nc.rejected", "./part.nc", "-", "nowhere/part.json"] {
        assert_eq!(post(&good, other), Some(2), "{other}");
    }
    assert_eq!(fs::read_to_string(path("part.cls")).expect("CL data"), good);
}
