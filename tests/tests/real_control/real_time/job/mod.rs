//! A whole job on the whole control: drilled and tapped along Z, faces milled with the table tilted, with arcs and
//! cutter compensation, a blade under tip control with a rewind, and a second set-up.
//!
//! The program is posted in mode `auto` with M428 and M429, which the control remaps to a change of its kinematics;
//! those are compiled for the machine. The poses of the tool come from the joints that the control commands, by the
//! oracle, and are compared with the CL data, which is read without the product: every point, the way between two
//! points in every servo cycle, every hole. The numbers of the centre lines are those of the machine's declaration; the
//! set-ups are stated again.

mod cl;
mod compare;
mod run;

use std::fs;
use std::io::Cursor;

use machines::{Dmu70e, SpinnerU5620};
use pp_runtime::config::{Config, starting_point};
use pp_runtime::control::LinuxCnc;
use pp_runtime::kinematics::Machine;
use pp_runtime::machine;
use pp_runtime::post::{Job, post};
use tests::binaries::workspace;
use tests::linuxcnc::can_be_simulated;
use tests::linuxcnc::simulation::{Simulation, can_be_loaded};

use cl::{Operation, operations};
use compare::{Compared, compare};

machine! {
    /// The Spinner U5-620 with the wrong sign of C.
    pub struct SpinnerWrongSign;
    chain: C B | X Y Z;
    d = (0, 0, d);
    dims = { d: 150.0 };
    signs = { C: - };
    limits = { B: -5..110, C: free };
}

fn read(name: &str) -> String {
    fs::read_to_string(workspace().join("tests/data/mixed").join(name)).expect("a golden part")
}

/// The set-up of the golden programs, with tip control.
fn set_up<M: Machine>() -> Config {
    let text = format!("{}\n[control]\ntip_control = ['M428', 'M429']\n", read("mixed.toml"));
    starting_point(&LinuxCnc).read_over(&M::default(), &text).unwrap_or_else(|faults| panic!("{faults:?}"))
}

fn posted<M: Machine>(config: &Config) -> String {
    let job = Job { cl_name: "mixed.cls", config, control: &LinuxCnc, units: None };
    let mut program = Vec::new();
    let report = post::<M>(&job, &mut Cursor::new(read("mixed.cls")), &mut program).expect("memory");
    assert!(!report.failed, "{:?}", report.diagnostics);
    String::from_utf8(program).expect("ASCII")
}

/// Operations of the CL data by name.
fn named(names: &[&str]) -> Vec<Operation> {
    operations(&read("mixed.cls")).into_iter().filter(|operation| names.contains(&operation.name.as_str())).collect()
}

/// The program of some operations: each begins with a complete state.
fn only(program: &str, names: &[&str]) -> String {
    let mut wanted = false;
    let mut text = String::new();
    for line in program.lines() {
        if let Some(name) = line.strip_prefix("(OPERATION ") {
            wanted = names.contains(&name.trim_end_matches(')'));
        }
        if wanted {
            text += &format!("{line}\n");
        }
    }
    format!("{}\nM2\n", text.trim_end().trim_end_matches("M2"))
}

/// Runs a program on the control of machine `M`, and compares it with operations of the CL data.
fn compared<M: Machine>(simulation: &mut Simulation, program: &str, of: &[Operation]) -> (Compared, Vec<String>) {
    let lines = run::run::<M>(simulation, program).unwrap_or_else(|error| panic!("{}: {error}", M::NAME));
    compare(&lines, of)
}

fn start<M: Machine>() -> Simulation {
    Simulation::start(&run::control::<M>()).unwrap_or_else(|error| panic!("{error}"))
}

fn assert_agrees<M: Machine>(simulation: &mut Simulation) {
    let all = operations(&read("mixed.cls"));
    let (compared, faults) = compared::<M>(simulation, &posted::<M>(&set_up::<M>()), &all);
    println!("{}: {compared:?}", M::NAME);
    assert!(faults.is_empty(), "{}:\n{}", M::NAME, faults.join("\n"));
    // The blade is left and entered again between two of its points, by the rewind.
    let expected = Compared { points: 122, lines: 101, arcs: 2, compensated: 3, holes: 10, threads: 4, switches: 11 };
    assert_eq!(compared, expected, "{}", M::NAME);
}

/// Runs operations of a program with a mistake, and checks that each of `wrong` is reported.
fn assert_found(simulation: &mut Simulation, program: &str, run: &[&str], wrong: &[&str], mistake: &str) {
    let (_, faults) = compared::<SpinnerU5620>(simulation, &only(program, run), &named(run));
    println!("{mistake}: {} faults, {:?}", faults.len(), faults.first());
    for name in wrong {
        assert!(faults.iter().any(|fault| fault.starts_with(name)), "{mistake}: {name}: {faults:?}");
    }
}

#[test]
fn the_job_moves_the_tool_as_its_cl_data_on_a_table_of_b_and_c_and_mistakes_are_found() {
    if !can_be_simulated() || !can_be_loaded() {
        return;
    }
    let mut simulation = start::<SpinnerU5620>();
    assert_agrees::<SpinnerU5620>(&mut simulation);

    let wrong_sign = posted::<SpinnerWrongSign>(&set_up::<SpinnerWrongSign>());
    assert_found(&mut simulation, &wrong_sign, &["FACE_30", "BLADE"], &["FACE_30", "BLADE"], "a wrong sign of C");

    let program = posted::<SpinnerU5620>(&set_up::<SpinnerU5620>());
    let without =
        |code: &str| program.lines().filter(|line| *line != code).fold(String::new(), |text, line| text + line + "\n");
    assert_found(&mut simulation, &without("M428"), &["BLADE"], &["BLADE"], "tip control is not switched on");
    assert_found(
        &mut simulation,
        &without("M429"),
        &["BLADE", "BACK_FACE"],
        &["BACK_FACE"],
        "tip control is not switched off",
    );

    let mut displaced = set_up::<SpinnerU5620>();
    displaced.set_up.set_ups.get_mut(&2).expect("the second set-up").part_origin[2] += 0.1;
    let displaced = posted::<SpinnerU5620>(&displaced);
    let second = ["BACK_DRILL", "BACK_FACE"];
    assert_found(&mut simulation, &displaced, &second, &["BACK_FACE"], "a wrong part origin of set-up 2");
}

#[test]
fn the_job_moves_the_tool_as_its_cl_data_on_a_table_with_an_inclined_axis() {
    if can_be_simulated() && can_be_loaded() {
        assert_agrees::<Dmu70e>(&mut start::<Dmu70e>());
    }
}
