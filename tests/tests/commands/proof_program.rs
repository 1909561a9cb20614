//! `explain --proof-program`: the tip stays on one point while each rotary axis sweeps its travel.
//!
//! The foreign interpreter runs the programs of every control; every block is checked by the matrices of the oracle, at
//! its ends and in between.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use approx::abs_diff_eq;
use machines::{Dmu70e, LolaXoyzba, MultiProDesk, SpinnerU5620};
use pp_runtime::config::Config;
use pp_runtime::control::LinuxCnc;
use pp_runtime::kinematics::{Axis, AxisKind, Machine};
use pp_runtime::nalgebra::Point3;
use tempfile::TempDir;
use tests::binaries::{binary, workspace};
use tests::by_name;
use tests::foreign::state::{Coolant, Spindle, Units};
use tests::foreign::{Control, Effect, Options, Trace, run};
use tests::oracle::Oracle;

/// Largest distance of the tip from its point between the ends of a block, mm: the default of `tolerance`.
const TOLERANCE: f64 = 0.01;

/// Samples per block.
const SAMPLES: usize = 20;

struct Case {
    binary: &'static str,
    config: &'static str,
    /// Gauge length in `config`, mm.
    length: f64,
    point: [f64; 3],
}

/// The printed proof program, or the messages of its refusal.
fn proof(case: &Case, control: &str, more: &[&str]) -> Result<String, String> {
    let folder = TempDir::new().expect("a temporary folder");
    fs::write(folder.path().join("set-up.toml"), case.config).expect("a file can be written");
    let [x, y, z] = case.point;
    let mut command = binary(case.binary);
    command.current_dir(folder.path()).args(["explain", "--proof-program", "--config", "set-up.toml"]);
    command.args(["--control", control, &format!("--point={x},{y},{z}")]).args(more);
    let output = command.output().expect("the binary runs");
    let errors = String::from_utf8(output.stderr).expect("text");
    assert_eq!(output.stdout.is_empty(), !output.status.success(), "all or nothing: {errors}");
    if output.status.success() {
        Ok(String::from_utf8(output.stdout).expect("ASCII"))
    } else {
        assert_eq!(output.status.code(), Some(2));
        Err(errors)
    }
}

/// Runs a proof program with the spindle off.
fn traced(program: &str, control: &str) -> Trace {
    let control = Control::by_name(control).expect("a control");
    let options = Options { dry: true, ..Options::of(control) };
    run(program, &options).unwrap_or_else(|refused| panic!("{}: {refused}", control.name()))
}

/// Positions after all feed blocks in chain order, in the unit of the program and rad.
fn feeds<M: Machine>(trace: &Trace) -> Vec<Vec<f64>> {
    let mut feeds = Vec::new();
    for step in trace.motions() {
        let straight = matches!(step.effect, Effect::Feed | Effect::Rapid | Effect::Machine);
        assert!(straight, "line {}: the motion is not straight", step.line);
        if step.effect == Effect::Feed {
            let value = |axis: &Axis| {
                let word = step.state.position.get(axis.letter);
                let word =
                    word.unwrap_or_else(|| panic!("line {}: the position of {} is unknown", step.line, axis.letter));
                if axis.kind == AxisKind::Rotary { word.to_radians() } else { word }
            };
            feeds.push(M::AXES.iter().map(value).collect());
        }
    }
    feeds
}

/// The matrices of a machine with the part origin of a configuration.
fn oracle<M: Machine>(case: &Case) -> Oracle {
    let config = Config::read::<M>(case.config, &LinuxCnc).expect("a configuration");
    let mut machine = config.set_up.machine::<M>().expect("valid");
    machine.set_up(config.set_up.part_origin.into(), case.length);
    Oracle::of(&machine)
}

/// Checks every feed block; returns the smallest and the largest angle of each rotary axis, degrees.
fn check_blocks<M: Machine>(case: &Case, control: &str) -> BTreeMap<char, (f64, f64)> {
    let program = proof(case, control, &[]).unwrap_or_else(|errors| panic!("{control}: {errors}"));
    let trace = traced(&program, control);
    let (oracle, blocks) = (oracle::<M>(case), feeds::<M>(&trace));
    let inches = trace.blocks.iter().any(|block| block.state.units == Some(Units::Inches));
    let unit = if inches { 25.4e-4 } else { 1e-3 };
    let point = Point3::from(case.point);
    let mut travel = BTreeMap::new();
    for (index, words) in blocks.iter().enumerate() {
        let off = (oracle.forward(words).tip - point).norm();
        assert!(off <= 2.0 * unit, "{control}, block {index}: the tip is {off} mm off");
        for sample in 0..=SAMPLES {
            let before = &blocks[index.saturating_sub(1)];
            let share = sample as f64 / SAMPLES as f64;
            let between: Vec<f64> = before.iter().zip(words).map(|(a, b)| a + (b - a) * share).collect();
            let off = (oracle.forward(&between).tip - point).norm();
            assert!(off <= TOLERANCE, "{control}, on the path to block {index}: the tip is {off} mm off");
        }
        for (axis, value) in M::AXES.iter().zip(words).filter(|(axis, _)| axis.kind == AxisKind::Rotary) {
            let degrees = value.to_degrees();
            let ends = travel.entry(axis.letter).or_insert((degrees, degrees));
            *ends = (ends.0.min(degrees), ends.1.max(degrees));
        }
    }
    travel
}

fn assert_swept(found: &BTreeMap<char, (f64, f64)>, wanted: &[(char, f64, f64)]) {
    for (letter, low, high) in wanted {
        let (from, to) = found[letter];
        let same = abs_diff_eq!([from, to][..], [*low, *high][..], epsilon = 1e-3);
        assert!(same, "{letter}: {from} to {to}");
    }
}

const SPINNER: Case = Case {
    binary: "spinner-u5-620",
    config: "units = 'mm'\npart_origin = [10, -5, 60]\n",
    length: 0.0,
    point: [40.0, 25.0, 50.0],
};
const DMU: Case = Case { binary: "dmu-70e", point: [60.0, 0.0, 120.0], config: "units = 'mm'\n", length: 0.0 };
const DESK: Case = Case { binary: "multiprodesk", point: [0.0, 20.0, 30.0], config: "units = 'mm'\n", length: 0.0 };
const LOLA: Case = Case {
    binary: "lola-xoyzba",
    point: [0.0; 3],
    config: "units = 'mm'\n[limits]\nB = [-90, 90]\nA = [-60, 45]\n[tools]\n5 = { length = 117.25 }\n",
    length: 117.25,
};

#[test]
fn the_tip_stays_on_its_point_while_each_rotary_sweeps_its_travel_on_every_control() {
    for control in by_name::controls() {
        assert_swept(&check_blocks::<SpinnerU5620>(&SPINNER, control), &[('B', -5.0, 110.0), ('C', 0.0, 360.0)]);
        assert_swept(&check_blocks::<Dmu70e>(&DMU, control), &[('B', 0.0, 180.0), ('C', 0.0, 360.0)]);
        assert_swept(&check_blocks::<MultiProDesk>(&DESK, control), &[('A', 0.0, 360.0)]);
        assert_swept(&check_blocks::<LolaXoyzba>(&LOLA, control), &[('B', -90.0, 90.0), ('A', -60.0, 45.0)]);
    }
}

#[test]
fn a_table_that_rolls_over_is_swept_by_quarter_turns() {
    for control in by_name::controls().filter(|control| *control != "haas") {
        let config = "units = 'mm'\nmode = 'axes'\nwrap = { C = '0..360' }\n";
        for case in [Case { config, ..DMU }, Case { config, ..SPINNER }] {
            let program =
                proof(&case, control, &[]).unwrap_or_else(|errors| panic!("{}, {control}: {errors}", case.binary));
            let trace = traced(&program, control);
            let words = trace.motions().filter_map(|step| step.state.position.get('C'));
            let reached: Vec<f64> =
                words.filter(|degrees| (degrees / 90.0 - (degrees / 90.0).round()).abs() < 1e-9).collect();
            for quarter in [90.0, 180.0, 270.0] {
                assert!(reached.contains(&quarter), "{}, {control}: {quarter}\n{program}", case.binary);
            }
        }
    }
}

/// Keys with which a control has tip control in the frame of the table at zero.
fn tip_control_of(control: &str) -> &'static str {
    match control {
        "linuxcnc" => "mode = 'tcp'\n[control]\ntip_control = ['M428', 'M429']\n",
        "fanuc" => "mode = 'tcp'\ntcp_frame = 'table_at_zero'\n",
        _ => "mode = 'tcp'\n",
    }
}

/// Checks a program under tip control: every feed block has the point as its tip; returns the sweeps.
fn check_tip_control<M: Machine>(case: &Case, control: &str) -> BTreeMap<char, (f64, f64)> {
    let config = format!("{}{}", case.config, tip_control_of(control));
    let case = Case { config: config.leak(), ..*case };
    let program = proof(&case, control, &[]).unwrap_or_else(|errors| panic!("{control}: {errors}"));
    // Some controls have capitals only.
    let head = program.to_uppercase();
    assert!(head.contains("MODE TCP") && head.contains("TIP CONTROL IS ON"), "{program}");
    let trace = traced(&program, control);
    let mut travel = BTreeMap::new();
    let mut blocks = 0;
    for step in trace.motions().filter(|step| step.effect == Effect::Feed) {
        assert!(step.state.under_tip_control(), "{control}, line {}: tip control is off", step.line);
        blocks += 1;
        for (letter, expected) in ['X', 'Y', 'Z'].into_iter().zip(case.point) {
            let found = step.state.position.get(letter).unwrap_or_else(|| panic!("{letter} is unknown"));
            let same = abs_diff_eq!(found, expected, epsilon = 1e-3);
            assert!(same, "{control}, line {}: {letter} {found}", step.line);
        }
        for axis in M::AXES.iter().filter(|axis| axis.kind == AxisKind::Rotary) {
            let degrees = step.state.position.get(axis.letter).unwrap_or_else(|| panic!("{} is unknown", axis.letter));
            let ends = travel.entry(axis.letter).or_insert((degrees, degrees));
            *ends = (ends.0.min(degrees), ends.1.max(degrees));
        }
    }
    assert!(blocks > 6, "{program}");
    travel
}

#[test]
fn under_tip_control_the_rotary_axes_sweep_alone_and_the_tip_is_the_point() {
    for control in by_name::controls() {
        assert_swept(&check_tip_control::<SpinnerU5620>(&SPINNER, control), &[('B', -5.0, 110.0), ('C', 0.0, 360.0)]);
    }
}

#[test]
fn a_control_without_tip_control_has_no_such_proof_program() {
    let case = Case { config: "units = 'mm'\npart_origin = [10, -5, 60]\nmode = 'tcp'\n", ..SPINNER };
    let refusal = proof(&case, "linuxcnc", &[]).expect_err("no codes are given");
    assert!(refusal.contains("has no tip control (TCP) by default"), "{refusal}");
}

#[test]
fn the_header_states_what_must_be_observed_and_the_spindle_is_off() {
    let program = proof(&LOLA, "linuxcnc", &[]).expect("a program");
    for line in [
        "PROOF OF THE KINEMATICS: no cutting, spindle off",
        "an indicator that is fixed to the table and touches a ball at the tip does not move",
        "SWEEP 1: B from -90 to 90 degrees, A at 0",
        "SWEEP 2: A from -60 to 45 degrees, B at 0",
        "SWEEP 3: B from -90 to 90 degrees, A at -60",
        "T5 posted with L = 117.25: H5 must hold exactly this",
    ] {
        assert!(program.contains(line), "missing: {line}\n{program}");
    }
    let blocks = traced(&program, "linuxcnc").blocks;
    let still = |spindle: Option<Spindle>| matches!(spindle, None | Some(Spindle::Off));
    let dry = |coolant: Option<Coolant>| coolant.is_none_or(|coolant| coolant == Coolant::default());
    assert!(blocks.iter().all(|block| still(block.state.spindle) && dry(block.state.coolant)));
    assert!(blocks.iter().any(|block| block.effect == Effect::Spindle(Spindle::Off)));
    assert_eq!(blocks.last().map(|block| block.effect), Some(Effect::End));
    assert!(program.contains("o1 if [[ABS[#5403 - 117.25]"), "the length guard is missing");
}

#[test]
fn words_in_inches_and_wrapped_words_keep_the_tip_on_its_point() {
    let inches = Case { config: "units = 'mm'\noutput_units = 'in'\npart_origin = [10, -5, 60]\n", ..SPINNER };
    let program = proof(&inches, "linuxcnc", &[]).expect("a program");
    let oracle = oracle::<SpinnerU5620>(&inches);
    for mut words in feeds::<SpinnerU5620>(&traced(&program, "linuxcnc")) {
        for (axis, value) in SpinnerU5620::AXES.iter().zip(&mut words).filter(|(axis, _)| axis.kind == AxisKind::Linear)
        {
            assert!(value.abs() < 20.0, "{} is in inches", axis.letter);
            *value *= 25.4;
        }
        assert!((oracle.forward(&words).tip - Point3::from(inches.point)).norm() <= 2.0 * 25.4e-4);
    }
    let wrapped = Case { config: "units = 'mm'\npart_origin = [10, -5, 60]\nwrap = { C = '0..360' }\n", ..SPINNER };
    let program = proof(&wrapped, "heidenhain", &[]).expect("a program");
    let wrapped_words = feeds::<SpinnerU5620>(&traced(&program, "heidenhain"));
    assert!(wrapped_words.iter().all(|words| (0.0..360.0).contains(&words[0].to_degrees())));
}

#[test]
fn impossible_sweeps_are_refused_with_a_reason() {
    let refusal = |case: Case| match proof(&case, "linuxcnc", &[]) {
        Ok(program) => panic!("{} lines were written", program.lines().count()),
        Err(errors) => errors,
    };
    let head = refusal(Case { config: "units = 'mm'\n[tools]\n5 = { length = 117.25 }\n", ..LOLA });
    assert!(
        head.contains("the travel of B, a rotary axis of the head, is unknown") && head.contains("[limits]"),
        "{head}"
    );
    let length = refusal(Case { config: "units = 'mm'\n[limits]\nB = [-90, 90]\nA = [-60, 45]\n", ..LOLA });
    assert!(length.contains("length"), "{length}");
    let steps = refusal(Case { config: "units = 'mm'\n[grid]\nB = 1\n", ..SPINNER });
    assert!(steps.contains("B is indexed"), "{steps}");
    let limits =
        "units = 'mm'\nmachine_zero = { X = 0, Y = 0, Z = 0 }\n[limits]\nZ = [-10, 10]\n[tools]\n1 = { length = 80 }\n";
    assert!(refusal(Case { config: limits, ..SPINNER }).contains("Z"), "a linear axis is beyond its travel");

    let mut command = binary("spinner-u5-620");
    let output = command.args(["explain", "--proof-program"]).output().expect("the binary runs");
    let errors = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(!output.status.success() && errors.contains("part_origin") && errors.contains("--point"), "{errors}");
}

#[test]
fn a_spindle_that_would_come_down_to_the_table_is_refused_and_one_that_stays_clear_says_how_far() {
    let with_length = |length: f64| {
        let config = format!("{}tools = {{ 1 = {{ length = {length} }} }}\n", SPINNER.config);
        proof(&Case { config: config.leak(), ..SPINNER }, "linuxcnc", &[])
    };
    let program = with_length(120.0).expect("the spindle stays clear");
    // B 110: 60 + 50 + 120 cos 110 degrees.
    assert!(program.contains("come down to 68.958 above the face") && program.contains("EMPTY TABLE"), "{program}");
    let refusal = with_length(400.0).expect_err("110 + 400 cos 110 degrees is below the table");
    assert!(refusal.contains("would come down to -26.8 mm"), "{refusal}");
}

#[test]
fn an_axis_of_many_turns_is_swept_once() {
    let case = Case { config: "units = 'mm'\npart_origin = [10, -5, 60]\n[limits]\nC = [-36000, 36000]\n", ..SPINNER };
    let program = proof(&case, "linuxcnc", &[]).expect("a program");
    assert!(program.contains("SWEEP 1: C from 0 to 360 degrees"), "{program}");
}

/// What is missing can be done: the program is written as soon as the message is followed.
#[test]
fn every_example_has_a_proof_program_or_a_remedy_that_works() {
    let folder = TempDir::new().expect("a temporary folder");
    let (mut written, mut followed) = (0, 0);
    for entry in fs::read_dir(workspace().join("examples/config")).expect("the examples") {
        let path = entry.expect("an example").path();
        let name = path.file_stem().expect("a name").to_string_lossy().into_owned();
        let (machine, control) = name.rsplit_once('-').expect("machine and control");
        let proof = |config: &Path, point: Option<&str>| {
            let mut command = binary(machine);
            command.args(["explain", "--proof-program", "--control", control, "--config"]).arg(config);
            command.args(point.map(|point| format!("--point={point}")));
            let output = command.output().expect("the binary runs");
            if output.status.success() { Ok(()) } else { Err(String::from_utf8(output.stderr).expect("text")) }
        };
        let Err(refusal) = proof(&path, None) else {
            written += 1;
            continue;
        };
        let remedy = refusal.trim_end().rsplit("; ").next().and_then(|remedy| remedy.strip_suffix(" would do"));
        let remedy = remedy.unwrap_or_else(|| panic!("{name}: {refusal}"));
        let (keys, point) = remedy.split_once("--point ").unwrap_or_else(|| panic!("{name}: {refusal}"));
        let keys = keys.trim_end_matches(" and ").trim_matches('`');
        let text = fs::read_to_string(&path).expect("an example");
        let begin = text.lines().position(|line| line.starts_with("part_origin")).expect("a key outside sections");
        // The examples have sections; the key of a message stands before them.
        let lines = text
            .lines()
            .enumerate()
            .map(|(index, line)| if index == begin { format!("{keys}\n{line}\n") } else { format!("{line}\n") });
        let without = |text: String| match keys.is_empty() {
            true => text,
            false => without_section(&text, "[limits]"),
        };
        let config = folder.path().join("followed.toml");
        fs::write(&config, without(lines.collect())).expect("a file can be written");
        proof(&config, Some(point)).unwrap_or_else(|errors| panic!("{name}: {remedy}: {errors}"));
        followed += 1;
    }
    assert!(written >= 9 && followed > 0, "{written} are written, {followed} after a remedy");
}

/// A configuration without one of its sections.
fn without_section(text: &str, section: &str) -> String {
    let mut inside = false;
    let lines = text.lines().filter(|line| {
        if line.starts_with('[') {
            inside = *line == section;
        }
        !inside
    });
    lines.flat_map(|line| [line, "\n"]).collect()
}
