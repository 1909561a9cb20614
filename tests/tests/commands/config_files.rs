//! Configuration files, those of `examples/config` and those that are printed: checked against the printed schema, and
//! used to post.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use approx::abs_diff_eq;
use machine_library::{HaasTrunnion, ObliqueYLathe, XyzacTrt};
use machines::{LolaXoyzba, SpinnerU5620};
use pp_runtime::config::{Config, print, starting_point};
use pp_runtime::control::{self, Control, LinuxCnc};
use pp_runtime::kinematics::{AxisKind, Machine, Pose};
use pp_runtime::nalgebra::{Point3, Vector3};
use serde_json::Value;
use tests::binaries::{binary, workspace};
use tests::by_name;

const MACHINES: [&str; 4] = ["dmu-70e", "lola-xoyzba", "multiprodesk", "spinner-u5-620"];
/// Faults of a value against a schema, each with its path; supports only the keywords that the printed schema uses.
fn faults(schema: &Value, value: &Value, path: &str) -> Vec<String> {
    let mut found = Vec::new();
    for (keyword, wanted) in schema.as_object().expect("a schema is an object") {
        let number = || wanted.as_f64().expect("a number");
        let fits = match keyword.as_str() {
            "$schema" | "title" | "description" | "default" | "patternProperties" | "properties" => true,
            "type" => match wanted.as_str() {
                Some("object") => value.is_object(),
                Some("array") => value.is_array(),
                Some("string") => value.is_string(),
                Some("boolean") => value.is_boolean(),
                Some("number") => value.is_number(),
                Some("integer") => value.is_i64() || value.is_u64(),
                other => panic!("{path}: unsupported type {other:?}"),
            },
            "enum" => wanted.as_array().expect("a list").contains(value),
            "const" => wanted == value,
            "minimum" => value.as_f64().is_none_or(|value| value >= number()),
            "maximum" => value.as_f64().is_none_or(|value| value <= number()),
            "exclusiveMinimum" => value.as_f64().is_none_or(|value| value > number()),
            "minItems" => value.as_array().is_none_or(|list| list.len() as f64 >= number()),
            "maxItems" => value.as_array().is_none_or(|list| list.len() as f64 <= number()),
            "minProperties" => value.as_object().is_none_or(|table| table.len() as f64 >= number()),
            "maxProperties" => value.as_object().is_none_or(|table| table.len() as f64 <= number()),
            "required" => {
                wanted.as_array().expect("a list").iter().all(|key| value.get(key.as_str().expect("a key")).is_some())
            }
            "anyOf" => wanted.as_array().expect("a list").iter().any(|one| faults(one, value, path).is_empty()),
            "items" => {
                let list = value.as_array().map_or(&[][..], Vec::as_slice);
                let all = list.iter().enumerate();
                found.extend(all.flat_map(|(index, item)| faults(wanted, item, &format!("{path}[{index}]"))));
                continue;
            }
            // A table with keys of any name.
            "additionalProperties" if wanted.is_object() => {
                let all = value.as_object().into_iter().flatten();
                found.extend(all.flat_map(|(key, value)| faults(wanted, value, &format!("{path}.{key}"))));
                continue;
            }
            "additionalProperties" => {
                assert_eq!(wanted, &Value::Bool(false));
                found.extend(entries(schema, value, path));
                continue;
            }
            other => panic!("{path}: unsupported keyword {other}"),
        };
        if !fits {
            found.push(format!("{path}: {value} violates {keyword} {wanted}"));
        }
    }
    found
}

/// Faults in the entries of a table.
fn entries(schema: &Value, value: &Value, path: &str) -> Vec<String> {
    let mut found = Vec::new();
    for (key, value) in value.as_object().into_iter().flatten() {
        let path = format!("{path}.{key}");
        let number = !key.starts_with('0') && key.bytes().all(|byte| byte.is_ascii_digit());
        let numbered = schema.pointer("/patternProperties/^[1-9][0-9]*$").filter(|_| number);
        match schema.get("properties").and_then(|keys| keys.get(key)).or(numbered) {
            Some(schema) => found.extend(faults(schema, value, &path)),
            None => found.push(format!("{path}: unknown key")),
        }
    }
    found
}

fn printed(command: &mut Command) -> String {
    let output = command.output().expect("the binary runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).expect("text")
}

fn schema(machine: &str, control: &str) -> Value {
    let text = printed(binary(machine).args(["config", "--schema", "--control", control]));
    serde_json::from_str(&text).expect("JSON")
}

fn toml(text: &str) -> Value {
    let table: toml::Table = text.parse().unwrap_or_else(|error| panic!("{error}\n{text}"));
    serde_json::to_value(table).expect("TOML is JSON")
}

/// Files of `examples/config` for the machines of the papers, with the machine and the control of their names; those of
/// the library are in its own tests.
fn examples() -> Vec<(PathBuf, &'static str, &'static str)> {
    let folder = fs::read_dir(workspace().join("examples/config")).expect("the folder");
    let mut files: Vec<PathBuf> = folder.map(|entry| entry.expect("an entry").path()).collect();
    files.sort();
    let named = |path: PathBuf| {
        let stem = path.file_stem().expect("a name").to_string_lossy().into_owned();
        let machine = MACHINES.into_iter().find(|machine| stem.starts_with(machine))?;
        let control = by_name::controls().find(|control| stem == format!("{machine}-{control}")).expect("a control");
        Some((path, machine, control))
    };
    files.into_iter().filter_map(named).collect()
}

#[test]
fn every_printed_file_fits_its_schema_with_all_lines_enabled() {
    for machine in MACHINES {
        for control in by_name::controls() {
            let text = printed(binary(machine).args(["config", "--control", control]));
            let enabled = |line: &str| {
                let default = line.strip_prefix('#').filter(|rest| !rest.is_empty() && !rest.starts_with(' '));
                line.strip_prefix("# e.g. ").or(default).unwrap_or(line).to_owned()
            };
            let enabled: Vec<String> = text.lines().map(enabled).collect();
            let schema = schema(machine, control);
            for text in [text, enabled.join("\n")] {
                assert_eq!(faults(&schema, &toml(&text), ""), Vec::<String>::new(), "{machine} {control}");
            }
        }
    }
}

#[test]
fn values_that_the_reader_refuses_violate_the_schema() {
    let schema = schema("spinner-u5-620", "linuxcnc");
    for wrong in [
        "unit = 'mm'",
        "units = 'cm'",
        "part_origin = [1, 2]",
        "part_rotation = ['a', 0, 0]",
        "park = { Q = 1 }",
        "rotary_offset = { X = 1 }",
        "tolerance = 0",
        "stop_retract = 'yes'",
        "[tools]\n012 = { length = 5 }",
        "[tools]\n12 = { lenght = 5 }",
        "[tools]\n12 = { length = -5 }",
        "[limits]\nC = 'endless'",
        "[retract]\nclearance = { ball = 5 }",
        "[control]\ncoolant = { mist = ['M7'] }",
        "[control]\neffects = { M77 = 'nothing' }",
        "[control]\neffects = { M77 = 5 }",
        "[cl]\nauxfun = [10000]",
        "[formats]\nrotary = 7",
        "[formats]\nrotary = 3.5",
        "[nowhere]\n",
    ] {
        assert!(!faults(&schema, &toml(wrong), "").is_empty(), "{wrong}");
    }
}

#[test]
fn each_machine_has_an_example_that_fits_its_schema() {
    let examples = examples();
    for machine in MACHINES {
        assert!(examples.iter().any(|(_, known, _)| *known == machine), "{machine}");
    }
    for (path, machine, control) in examples {
        let text = fs::read_to_string(&path).expect("text");
        assert_eq!(faults(&schema(machine, control), &toml(&text), ""), Vec::<String>::new(), "{}", path.display());
    }
}

/// Posts a part for a machine with four or five axes; returns the program and the messages.
fn posted(path: &Path, machine: &str, control: &str) -> (String, String) {
    let part = if machine == "multiprodesk" { "concave_4axis.cls" } else { "two_tools.cls" };
    let mut command = binary(machine);
    command.current_dir(workspace()).args(["post", &format!("examples/cl/{part}"), "--control", control, "--config"]);
    let output = command.arg(path).output().expect("the binary runs");
    let messages = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.success(), "{}: {messages}", path.display());
    (String::from_utf8(output.stdout).expect("ASCII"), messages)
}

#[test]
fn each_example_posts_a_part_without_warnings_and_checks_every_limit() {
    for (path, machine, control) in examples() {
        let (program, messages) = posted(&path, machine, control);
        assert!(!messages.contains("warning") && !messages.contains("not checked"), "{}: {messages}", path.display());
        // Nothing of the set-up is assumed; the rollover of an axis belongs to the control, not to the set-up.
        let assumed: Vec<&str> =
            messages.lines().filter(|line| line.starts_with("assumed:") && !line.contains(" rolls over, ")).collect();
        assert_eq!(assumed, Vec::<&str>::new(), "{}", path.display());
        assert!(program.lines().count() > 60, "{}", path.display());
    }
}

/// Names in backticks in the last column of the table of functions in the chapter that compares with other posts.
fn keys_of_compared_functions() -> Vec<String> {
    let chapter = fs::read_to_string(workspace().join("docs/src/comparison.md")).expect("the chapter");
    let table = chapter
        .split("\n## ")
        .find(|section| section.starts_with("Functions that shops ask for"))
        .expect("the section");
    let rows = table.lines().filter(|line| line.starts_with("| ")).skip(1);
    let last = rows.map(|row| row.trim_end_matches(['|', ' ']).rsplit('|').next().expect("a column").to_owned());
    let named = |column: String| column.split('`').skip(1).step_by(2).map(str::to_owned).collect::<Vec<String>>();
    last.flat_map(named).collect()
}

#[test]
fn every_key_that_the_table_of_functions_names_is_a_key_of_the_configuration() {
    let schema = schema("spinner-u5-620", "siemens");
    let keys = keys_of_compared_functions();
    assert!(keys.len() > 40, "{keys:?}");
    for key in keys {
        let pointer: String = key.split('.').map(|part| format!("/properties/{part}")).collect();
        assert!(schema.pointer(&pointer).is_some(), "{key}");
    }
}

/// `table_zero` gives the `machine_zero` that leads to the same place: the axes have to move from the reference point
/// of the table to the part zero.
fn machine_zero_follows<M: Machine>(dimensions: &str) {
    let (letters, origin) = (['X', 'Y', 'Z'], Vector3::new(12.3, -4.5, 45.6));
    let text = format!(
        "units = \"mm\"\npart_origin = [{}, {}, {}]\ntable_zero = {{ X = -381.0, Y = -254.0, Z = -550.0 }}\n{dimensions}",
        origin.x, origin.y, origin.z
    );
    let config = Config::read::<M>(&text, &LinuxCnc).expect("a configuration");
    let mut machine: M = Config::read::<M>(&format!("units = \"mm\"\n{dimensions}"), &LinuxCnc)
        .expect("a configuration")
        .set_up
        .machine()
        .expect("a machine");
    machine.set_up(Vector3::zeros(), 0.0);
    let pose = Pose { tip: Point3::from(origin), axis: machine.tool_axis() };
    let held = M::HELD;
    let solutions = machine.inverse_kinematics(&pose, &held);
    let at_zero = |values: &&M::Axes| {
        M::AXES.iter().zip(values.as_ref()).all(|(axis, value)| axis.kind == AxisKind::Linear || value.abs() < 1e-9)
    };
    let values = solutions.iter().map(|solution| &solution.axes).find(at_zero).expect("the rotary axes at zero");
    for (letter, table) in letters.into_iter().zip([-381.0, -254.0, -550.0]) {
        let index = M::AXES.iter().position(|axis| axis.letter == letter).expect("an axis");
        let expected = table + values.as_ref()[index];
        let found = config.set_up.machine_zero[&letter];
        assert!(abs_diff_eq!(found, expected, epsilon = 1e-9), "{} {letter}: {found} {expected}", M::NAME);
    }
    let both = Config::read::<M>(&format!("machine_zero = {{ X = 1.0 }}\n{text}"), &LinuxCnc).expect_err("both");
    assert!(both[0].text.contains("`machine_zero` beside `table_zero`"), "{both:?}");
}

#[test]
fn machine_coordinates_of_the_part_zero_follow_from_those_of_the_table() {
    machine_zero_follows::<SpinnerU5620>("");
    machine_zero_follows::<LolaXoyzba>("");
    machine_zero_follows::<HaasTrunnion>("[dimensions]\ntilt_y = 0.5\ntilt_z = 60.0\n");
    machine_zero_follows::<ObliqueYLathe>("[dimensions]\nslant = 30.0\n");
}

/// Faults of the example lines of a printed file, each enabled alone.
fn faults_of_examples<M: Machine>(control: &'static dyn Control) -> Vec<String> {
    let machine = M::default();
    let (mut table, mut faults, mut examples) = (String::new(), Vec::new(), 0);
    for line in print(&machine, control).lines() {
        if line.starts_with('[') {
            line.clone_into(&mut table);
        }
        let default = line.strip_prefix('#').filter(|rest| !rest.is_empty() && !rest.starts_with(' '));
        let Some(example) = line.strip_prefix("# e.g. ").or(default) else { continue };
        examples += 1;
        let key = format!("{table} {example}");
        // A blank has two corners.
        let example =
            if table == "[stock]" { "lower = [-50.0, -40.0, -30.0]\nupper = [50.0, 40.0, 0.0]" } else { example };
        match starting_point(control).read_over(&machine, &format!("units = \"mm\"\n{table}\n{example}\n")) {
            Ok(config) => {
                // Settings of single operations serve several controls.
                let unread = config.for_control(control).left_out.into_iter().filter(|_| table != "[operations]");
                faults.extend(
                    config.unfit(&machine, control).into_iter().chain(unread).map(|fault| format!("{key}: {fault}")),
                );
            }
            Err(read) => faults.extend(read.iter().map(|fault| format!("{key}: {}", fault.text))),
        }
    }
    assert!(examples > 100, "{examples} examples");
    faults
}

#[test]
fn each_example_that_is_printed_for_a_control_is_accepted_by_it() {
    for control in control::CONTROLS.iter().copied() {
        let faults = [faults_of_examples::<SpinnerU5620>(control), faults_of_examples::<LolaXoyzba>(control)].concat();
        assert!(faults.is_empty(), "{}: {faults:#?}", control.spellings().name);
    }
}

/// Two axes have two clamps.
#[test]
fn the_examples_of_clamps_have_codes_of_their_own() {
    for control in control::CONTROLS.iter().copied() {
        let printed = print(&XyzacTrt::default(), control);
        let codes: Vec<&str> = printed.lines().filter(|line| line.contains("{ on = ")).collect();
        let [first, second] = codes[..] else { panic!("{codes:?}") };
        assert_ne!(first.split_once('=').expect("codes").1, second.split_once('=').expect("codes").1);
    }
}
