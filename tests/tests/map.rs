//! `post --map` and `explain-block`: every line of a program with the record it serves, and where the machine stands behind
//! it, beside the program itself, the CL data and the oracle.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use machines::{Dmu70e, LolaXoyzba, SpinnerU5620};
use nalgebra::Vector3;
use pp_runtime::config::Config;
use pp_runtime::kinematics::{AxisKind, Machine, Pose};
use serde_json::Value;
use tests::binaries::{binary, workspace};
use tests::foreign::{Control, Effect, Options, Trace, lexer, run};
use tests::oracle::{Oracle, angle_between};

const CL: &str = "tests/data/works/works.cls";

/// Modes, their controls, and the operations that these take.
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

/// The numbers of a record GOTO.
fn goto(record: &str) -> Option<Vec<f64>> {
    let numbers = record.strip_prefix("GOTO/")?.split(',').map(|number| number.trim().parse());
    Some(numbers.collect::<Result<_, _>>().expect("numbers"))
}

/// Every line is there once, in order, with the number that stands in it.
fn assert_complete(posted: &Posted) {
    let Posted { name, control, program, lines } = posted;
    assert_eq!(lines.len(), program.len(), "{name}");
    for (index, (line, text)) in lines.iter().zip(program).enumerate() {
        assert_eq!(line["line"], index as u64 + 1, "{name}");
        // A line that goes on with the parameters of a cycle has no number.
        let number = match text.starts_with(' ') {
            true => None,
            false => lexer::line(*control, text).unwrap_or_else(|why| panic!("{name}: {why}: {text}")).number,
        };
        let number = number.map(u64::from);
        assert_eq!(line["number"].as_u64(), number, "{name} line {}: {text}", index + 1);
    }
}

/// Tips are where the oracle finds them for the axis values, and on the points of their records.
fn assert_standing<M: Machine>(posted: &Posted, config: &str) {
    let text = fs::read_to_string(workspace().join(config)).expect("a configuration");
    let config = Config::read::<M>(&text).expect("a valid configuration");
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
        let Pose { tip: there, axis: points } = Oracle::of(&machine).forward(&values);
        let off = (there.coords - Vector3::from(tip)).norm();
        assert!(off < 1.5e-3, "{context}: {off} mm");
        let axis = Vector3::from(numbers::<3>(&line["axis"]).expect("a tool axis"));
        let lean = angle_between(&points.into_inner(), &axis);
        // Half a thousandth of a degree of two axes.
        assert!(lean < 1.8e-5, "{context}: {lean} rad");
        if line["why"] == "record" && ["feed", "rapid", "arc"].iter().any(|step| line["step"] == *step) {
            let point = goto(record).unwrap_or_else(|| panic!("{context} serves {record}"));
            let off = (Vector3::new(point[0], point[1], point[2]) - Vector3::from(tip)).norm();
            assert!(off < 1e-6, "{context}: {off} mm from {record}");
            named += 1;
        }
    }
    assert!(named > 10, "{}: {named} points of the CL data", posted.name);
}

/// In mode axes the words in force are the axis values, but for what each tool and work offset count from; an axis that is
/// said to be reached has a word in force.
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
            // At the end of a cycle the words are those over the hole, rounded by themselves.
            let room = if cycle { 1.1e-3 } else { 1e-5 };
            assert!((shift - known).abs() < room, "{context}: {letter} is {word} in the block");
            compared += 1;
        }
    }
    assert!(compared > 500, "{}: {compared} words", posted.name);
}

#[test]
fn every_line_is_accounted_for_and_every_tip_is_where_its_axis_values_put_it() {
    let mut reasons = BTreeSet::new();
    for &(mode, controls, operations) in MODES {
        for &control in controls {
            let [table, works] = ["table", "works"].map(|name| format!("tests/data/works/{name}.toml"));
            let spinner = posted("spinner-u5-620", &table, control, mode, operations);
            let dmu = posted("dmu-70e", &table, control, mode, operations);
            let lola = posted("lola-xoyzba", &works, control, mode, operations);
            for posted in [&spinner, &dmu, &lola] {
                assert_complete(posted);
                // The helices of Heidenhain count from where they begin.
                if mode == "axes" && control != "heidenhain" {
                    assert_words(posted);
                }
                reasons.extend(posted.lines.iter().filter_map(|line| line["why"].as_str()).map(str::to_owned));
            }
            assert_standing::<SpinnerU5620>(&spinner, &table);
            assert_standing::<Dmu70e>(&dmu, &table);
            assert_standing::<LolaXoyzba>(&lola, &works);
        }
    }
    let told = ["head", "record", "tolerance", "rewind", "split-arc", "chord", "hole", "lead-out", "start", "approach"];
    for why in told {
        assert!(reasons.contains(why), "no line is there for {why}: {reasons:?}");
    }
}

fn explained(arguments: &[&str]) -> (Option<i32>, String, String) {
    let output = binary("spinner-u5-620").current_dir(workspace()).args(arguments).output().expect("the binary runs");
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).expect("text");
    (output.status.code(), text(output.stdout), text(output.stderr))
}

#[test]
fn a_block_is_explained_by_number_and_by_line_as_the_map_has_it() {
    let part = ["examples/cl/two_tools.cls"];
    let (status, text, _) = explained(&["explain-block", part[0], "N120", "--line-numbers"]);
    assert_eq!(status, Some(0));
    let told = "\
line 37 of the program (feed):
    N120 G1 Z25.096 F1000
programmed by this record
examples/cl/two_tools.cls, line 17:
    GOTO/-0.3923,-28.0000,6.0000
tip X -0.3923, Y -28.0000, Z 6.0000 mm in the workpiece
tool axis I 0.5000000, J 0.0000000, K 0.8660254
axis values C 0.0000°, B 30.0000°, X 71.6600, Y -28.0000, Z 25.0960
branch 1 of the inverse kinematics
";
    assert_eq!(text, told);
    let (_, json, _) = explained(&["explain-block", part[0], "37", "--message-format", "json"]);
    let line: Value = serde_json::from_str(&json).expect("an object");
    assert_eq!((&line["line"], &line["cl_line"], &line["number"]), (&37.into(), &17.into(), &Value::Null));
    let (_, head, _) = explained(&["explain-block", part[0], "1"]);
    assert!(head.contains("the head of the program, before the first record"), "{head}");
}

#[test]
fn a_block_that_is_not_there_is_said_to_be_missing() {
    let missing = |block: &str, more: &[&str], told: &str| {
        let arguments = [&["explain-block", "examples/cl/two_tools.cls", block], more].concat();
        let (status, text, errors) = explained(&arguments);
        assert_eq!((status, text.as_str()), (Some(2), ""), "{block}");
        assert!(errors.contains(told), "{block}: {errors}");
    };
    missing("N77", &["--line-numbers"], "there is no block N77: the program has 75 lines");
    missing("N120", &[], "was it posted with --line-numbers?");
    missing("9999", &[], "there is no line 9999");
    missing("0", &[], "expected a block number such as `N1230`, or a line of the program such as `57`");
    missing("X12", &[], "expected a block number");
}

#[test]
fn only_what_moves_has_a_place_wherever_a_program_is_entered() {
    let check = |control: &str, mode: &str, operations: &str| {
        let posted = posted("lola-xoyzba", "tests/data/works/works.toml", control, mode, operations);
        assert_complete(&posted);
        let moves = ["feed", "rapid", "arc", "cycle"];
        let still = |line: &&Value| !moves.iter().any(|step| line["step"] == *step);
        let placed = posted.lines.iter().filter(still).find(|line| !line["axes"].is_null());
        assert_eq!(placed, None, "{control} {mode} {operations}");
    };
    for control in ["linuxcnc", "fanuc", "siemens", "heidenhain", "haas"] {
        for operations in ["2", "2..3", "3..", "5"] {
            check(control, "axes", operations);
        }
    }
    for control in ["fanuc", "siemens", "heidenhain", "haas"] {
        check(control, "tcp", "2..4");
        check(control, "plane", "2..3");
    }
}

#[test]
fn what_a_program_says_of_its_check_is_in_its_map() {
    let folder = tempfile::tempdir().expect("a folder");
    let config = folder.path().join("table.toml");
    let table = fs::read_to_string(workspace().join("tests/data/works/table.toml")).expect("a configuration");
    fs::write(&config, format!("{table}\n[program]\nchecked = true\n")).expect("a configuration");
    for control in ["linuxcnc", "fanuc", "heidenhain"] {
        let posted = posted("dmu-70e", &config.display().to_string(), control, "axes", "1..2");
        assert_complete(&posted);
        let told: Vec<&Value> = posted.lines.iter().filter(|line| line["step"] == "check").collect();
        let line = told.first().and_then(|line| line["line"].as_u64()).expect("a line of the check");
        assert!(posted.program[line as usize - 1].to_lowercase().contains("checked"), "{control}: {told:?}");
        // The last line, which stands behind it, is explained as it is.
        let (count, last) = (posted.program.len().to_string(), posted.program.last().expect("a line"));
        let arguments = ["explain-block", CL, &count, "--control", control, "--ops", "1..2", "--config"];
        let mut command = binary("dmu-70e");
        command.current_dir(workspace()).args(arguments).arg(&config);
        let numbers = (control != "heidenhain").then_some("--line-numbers");
        let said = command.args(numbers).output().expect("the binary runs");
        let said = String::from_utf8_lossy(&said.stdout).into_owned();
        assert!(said.contains(&format!("\n    {last}\n")), "{control}: {last} is no line of\n{said}");
    }
}

#[test]
fn a_map_stands_there_with_its_program_or_not_at_all() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = |name: &str| folder.path().join(name);
    let good = fs::read_to_string(workspace().join("examples/cl/two_tools.cls")).expect("CL data");
    let post = |cl: &str, map: &str| {
        fs::write(path("part.cls"), cl).expect("the folder takes files");
        let run = binary("spinner-u5-620")
            .current_dir(&folder)
            .args(["post", "part.cls", "-o", "part.nc", "--map", map])
            .output();
        run.expect("the binary runs").status.code()
    };
    assert_eq!(post(&good, "part.json"), Some(0));
    assert!(path("part.json").is_file());
    // The map of yesterday's program goes with it.
    assert_eq!(post(&good.replacen("GOTO/", "GOTO/x", 1), "part.json"), Some(1));
    assert!(!path("part.json").exists() && !path("part.nc").exists());
    // Standard output, wherever it has been led.
    let into = |file: fs::File, map: &str| {
        let mut command = binary("spinner-u5-620");
        command.current_dir(&folder).args(["post", "part.cls", "--map", map]).stdout(file);
        command.status().expect("the binary runs").code()
    };
    fs::write(path("part.cls"), &good).expect("the folder takes files");
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
