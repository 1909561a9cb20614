//! Posted programs, read back block by block and compared with the CL data they were made from.
//!
//! The CL data is read by `points`, the program by [`tests::foreign`], and the machine is the product of matrices of
//! [`tests::oracle`]: none of the three shares code with the postprocessor. Every block must be one of the following,
//! and every GOTO must be reached, in order:
//!
//! - a retract in machine coordinates; after it rotary axes alone, the other linear axes, the retract axis;
//! - the retract of the set-up, along the tool axis;
//! - the approach along the tool axis;
//! - a motion to the next GOTO, or a piece of it, on its line and within tolerance; the pieces take the time of the
//!   whole motion.

mod comparison;
mod given;
mod points;
mod set_ups;
mod slips;

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use machines::{Dmu70e, LolaXoyzba, MultiProDesk, SpinnerU5620};
use pp_runtime::kinematics::{AxisKind, Machine, Side};
use tests::binaries::binary;
use tests::foreign::state::Length;
use tests::foreign::{Control, Effect, Entry, Executed, Options, Trace, run};

use comparison::{Checked, Comparison, Motion, Stage};
use given::{COIL, PADS, PLAIN, SetUp, USUAL, WordDatum, data, sample};
use points::ClData;

fn posted(machine: &str, cl: &PathBuf, set_up: &SetUp) -> String {
    posted_with(machine, cl, set_up.config.map(data).as_deref(), set_up.coarse)
}

fn posted_with(machine: &str, cl: &PathBuf, config: Option<&Path>, coarse: bool) -> String {
    let mut command = binary(machine);
    command.arg("post").arg(cl);
    if let Some(config) = config {
        command.arg("--config").arg(config);
    }
    if coarse {
        command.args(["--tolerance", "1", "--axis-tolerance-path", "10"]);
    }
    let output = command.output().expect("the binary runs");
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{machine} does not post {}:\n{errors}", cl.display());
    String::from_utf8(output.stdout).expect("a program is ASCII")
}

/// Posts and checks a program; returns its text and its CL data.
fn posted_and_checked<M: Machine>(name: &str, path: &PathBuf, set_up: &SetUp) -> (String, ClData) {
    let cl = points::read(&std::fs::read_to_string(path).expect("the CL data exists"));
    let text = posted(name, path, set_up);
    check::<M>(&text, path, &cl, set_up);
    (text, cl)
}

/// Posts, reads back, and checks every block and every GOTO.
fn read_back<M: Machine>(name: &str, path: &PathBuf, set_up: &SetUp) -> Checked {
    let text = posted(name, path, set_up);
    let cl = points::read(&std::fs::read_to_string(path).expect("the CL data exists"));
    check::<M>(&text, path, &cl, set_up)
}

fn check<M: Machine>(text: &str, path: &Path, cl: &ClData, set_up: &SetUp) -> Checked {
    let options = Options { gauge_line: set_up.datum.gauge_line, ..Options::of(Control::LinuxCnc) };
    let program = run(text, &options).unwrap_or_else(|refused| panic!("{refused}"));
    let mut comparison = Comparison::<M>::new(set_up, cl);
    let steps = &program.blocks;
    for (index, step) in steps.iter().enumerate() {
        match step.effect {
            Effect::ToolChange(tool) => comparison.call(tool),
            Effect::Length(Length::Register(register)) => {
                let head = M::AXES.iter().any(|axis| axis.kind == AxisKind::Rotary && axis.side == Side::Tool);
                let next = steps.get(index + 1).map(|step| step.effect);
                let guarded = matches!(next, Some(Effect::Guard { length, tolerance })
                    if (length - comparison.length()).abs() < 1e-9 && (tolerance - 0.01).abs() < 1e-12);
                assert_eq!(guarded, head && Some(register) == comparison.tool, "line {}: the length guard", step.line);
            }
            Effect::Rapid | Effect::Feed | Effect::Machine => {
                let later = steps[index + 1..].iter().find(|step| step.effect.moves());
                let then_machine = later.is_some_and(|step| step.effect == Effect::Machine);
                comparison.motion(step.line, &Motion::of(step), then_machine);
            }
            Effect::Arc(_) | Effect::Hole(_) | Effect::Orient => {
                panic!("line {}: the motion is not straight", step.line)
            }
            _ => {}
        }
    }
    assert_eq!(comparison.next, cl.points.len(), "GOTOs that are reached, and GOTOs in the CL data");
    let (edge, own) = (comparison.edge, path.starts_with(data("")) && set_up.datum == USUAL);
    assert!(!own || edge > 1e-4, "another platform may round a word differently: {edge} units");
    assert!(comparison.stage == Stage::Retracted, "the program ends in the part");
    assert_eq!(comparison.parked, set_up.park.iter().map(|(letter, _)| *letter).collect());
    check_restarts(text, &program, cl, &options);
    comparison.checked
}

/// Checks that a program that is entered at any of its block numbers has the same motions as from its start.
fn check_restarts(text: &str, whole: &Trace, cl: &ClData, options: &Options) {
    let mut tool = 0;
    let mut tools = BTreeMap::new();
    for step in &whole.blocks {
        if let Some(number) = step.number {
            tools.insert(number, (tool, step.line));
        }
        if let Effect::ToolChange(called) = step.effect {
            tool = called;
        }
    }
    let mut operations: Vec<usize> = cl.points.iter().map(|goto| goto.operation).collect();
    operations.dedup();
    assert!(tools.keys().copied().eq(1..=operations.len() as u32), "an operation has no number: {tools:?}");
    for (number, (tool, line)) in tools {
        let entered = run(text, &Options { entry: Some(Entry { line, tool: Some(tool) }), ..options.clone() });
        let entered = entered.unwrap_or_else(|refused| panic!("N{number}: {refused}"));
        let after = |step: &Executed| (step.effect, step.words, step.feed());
        let expected: Vec<_> = whole.motions().filter(|step| step.line > line).map(after).collect();
        let found: Vec<_> = entered.motions().map(after).collect();
        assert_eq!(found, expected, "N{number}");
    }
}

/// Checks that as many GOTOs are reached as there are lines that begin with GOTO.
fn assert_complete(path: &PathBuf, checked: &Checked) {
    let text = std::fs::read_to_string(path).expect("the CL data exists");
    let gotos = text.lines().filter(|line| line.starts_with("GOTO")).count();
    assert!(gotos > 0 && checked.points == gotos, "{} of {gotos} GOTOs are reached", checked.points);
}

macro_rules! programs {
    ($($name:ident: $machine:ty, $binary:literal, $path:expr, $set_up:expr;)*) => {
        $(#[test]
        fn $name() {
            let path = $path;
            let checked = read_back::<$machine>($binary, &path, &$set_up);
            assert_complete(&path, &checked);
        })*
    };
}

programs! {
    spinner_cuts_every_point_of_the_dome: SpinnerU5620, "spinner-u5-620", sample("convex.cls"), PLAIN;
    dmu_cuts_every_point_of_the_dome: Dmu70e, "dmu-70e", sample("convex.cls"), PLAIN;
    lola_cuts_every_point_of_the_dome: LolaXoyzba, "lola-xoyzba", sample("convex.cls"), PLAIN;
    spinner_cuts_every_point_of_the_bowl_of_catia: SpinnerU5620, "spinner-u5-620", sample("concave.aptsource"), PLAIN;
    dmu_cuts_every_point_of_the_bowl_of_catia: Dmu70e, "dmu-70e", sample("concave.aptsource"), PLAIN;
    lola_cuts_every_point_of_the_bowl_of_catia: LolaXoyzba, "lola-xoyzba", sample("concave.aptsource"), PLAIN;
    spinner_cuts_every_point_of_the_bowl_of_creo: SpinnerU5620, "spinner-u5-620", sample("concave.ncl"), PLAIN;
    dmu_cuts_every_point_of_the_bowl_of_creo: Dmu70e, "dmu-70e", sample("concave.ncl"), PLAIN;
    lola_cuts_every_point_of_the_bowl_of_creo: LolaXoyzba, "lola-xoyzba", sample("concave.ncl"), PLAIN;
    multiprodesk_cuts_every_point_of_the_trough: MultiProDesk, "multiprodesk", sample("concave_4axis.cls"), PLAIN;
    multiprodesk_cuts_every_point_of_the_groove: MultiProDesk, "multiprodesk", sample("spiral_groove.cls"), PLAIN;
    spinner_cuts_every_point_of_two_tools: SpinnerU5620, "spinner-u5-620", sample("two_tools.cls"), PLAIN;
    dmu_cuts_every_point_of_two_tools: Dmu70e, "dmu-70e", sample("two_tools.cls"), PLAIN;
    lola_cuts_every_point_of_two_tools: LolaXoyzba, "lola-xoyzba", sample("two_tools.cls"), PLAIN;

    spinner_cuts_every_point_of_the_blade: SpinnerU5620, "spinner-u5-620", data("blade/blade.cls"), PLAIN;
    dmu_cuts_every_point_of_the_blade: Dmu70e, "dmu-70e", data("blade/blade.cls"), PLAIN;
    lola_cuts_every_point_of_the_blade: LolaXoyzba, "lola-xoyzba", data("blade/blade.cls"), PLAIN;
    spinner_cuts_every_point_of_the_facets: SpinnerU5620, "spinner-u5-620", data("facets/facets.aptsource"), PLAIN;
    dmu_cuts_every_point_of_the_facets: Dmu70e, "dmu-70e", data("facets/facets.aptsource"), PLAIN;
    lola_cuts_every_point_of_the_facets: LolaXoyzba, "lola-xoyzba", data("facets/facets.aptsource"), PLAIN;
    spinner_cuts_every_point_of_the_rim: SpinnerU5620, "spinner-u5-620", data("rim/rim.ncl"), PLAIN;
    dmu_cuts_every_point_of_the_rim: Dmu70e, "dmu-70e", data("rim/rim.ncl"), PLAIN;
    lola_cuts_every_point_of_the_rim: LolaXoyzba, "lola-xoyzba", data("rim/rim.ncl"), PLAIN;
    spinner_cuts_every_point_of_the_keyway: SpinnerU5620, "spinner-u5-620", data("key_inch/key_inch.cls"), PLAIN;
    dmu_cuts_every_point_of_the_keyway: Dmu70e, "dmu-70e", data("key_inch/key_inch.cls"), PLAIN;
    lola_cuts_every_point_of_the_keyway: LolaXoyzba, "lola-xoyzba", data("key_inch/key_inch.cls"), PLAIN;
    multiprodesk_cuts_every_point_of_the_keyway: MultiProDesk, "multiprodesk", data("key_inch/key_inch.cls"), PLAIN;
    multiprodesk_cuts_every_point_of_the_coil: MultiProDesk, "multiprodesk", data("coil/coil.cls"), COIL;
    spinner_cuts_every_point_of_the_pads: SpinnerU5620, "spinner-u5-620", data("pads/pads.cls"), PADS;
    dmu_cuts_every_point_of_the_pads: Dmu70e, "dmu-70e", data("pads/pads.cls"), PADS;
    lola_cuts_every_point_of_the_pads: LolaXoyzba, "lola-xoyzba", data("pads/pads.cls"), PADS;
}

#[test]
fn inserted_points_are_counted() {
    let checked = read_back::<LolaXoyzba>("lola-xoyzba", &data("pads/pads.cls"), &PADS);
    assert_eq!((checked.approaches, checked.retracts), (3, 3));
    let checked = read_back::<SpinnerU5620>("spinner-u5-620", &data("facets/facets.aptsource"), &PLAIN);
    assert_eq!((checked.approaches, checked.retracts), (5, 0));
}
