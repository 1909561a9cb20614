//! What a control that nobody here wrote makes of our programs: LinuxCNC's own interpreter.
//!
//! Without LinuxCNC these tests say so and pass; with `PP_REQUIRE_LINUXCNC=1` they have to run.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::process::Command;
use std::sync::{Mutex, PoisonError};

use machines::{Dmu70e, LolaXoyzba, MultiProDesk, SpinnerU5620};
use pp_runtime::check::read::{Action, Block, CycleMove, Length};
use pp_runtime::check::{Job, blocks};
use pp_runtime::config::{Config, Units};
use pp_runtime::control;
use pp_runtime::kinematics::{AxisKind, Machine};
use tests::binaries::workspace;
use tests::linuxcnc::installed;

/// Programs of the samples, and their machines.
const PROGRAMS: &[(&str, &str)] = &[
    ("two_tools", "spinner-u5-620"),
    ("blade", "spinner-u5-620"),
    ("blade", "lola-xoyzba"),
    ("facets", "dmu-70e"),
    ("rim", "dmu-70e"),
    ("key_inch", "multiprodesk"),
    ("coil", "multiprodesk"),
    ("pocket", "spinner-u5-620"),
    ("plate", "dmu-70e"),
    ("nest", "dmu-70e"),
    ("pads", "lola-xoyzba"),
];

/// The interpreter prints four decimals.
const PRINTED: f64 = 6e-5;

/// The interpreter keeps its tool table in one place for all that run: one at a time.
static INTERPRETER: Mutex<()> = Mutex::new(());

/// The canonical calls of a program; the tools are in the table, without length.
fn canonical(program: &Path, tools: &BTreeSet<u32>, guards: &[(u32, f64)]) -> Vec<String> {
    let _alone = INTERPRETER.lock().unwrap_or_else(PoisonError::into_inner);
    let folder = tempfile::tempdir().expect("a folder");
    let (table, variables) = (folder.path().join("tool.tbl"), folder.path().join("params.var"));
    let length = |tool: &u32| guards.iter().find(|(number, _)| number == tool).map_or(0.0, |(_, length)| *length);
    // The stand-alone interpreter takes the table as inches.
    let lines: Vec<String> =
        tools.iter().map(|tool| format!("T{tool} P{tool} Z{:.6} D1\n", length(tool) / 25.4)).collect();
    fs::write(&table, lines.concat()).expect("a table");
    fs::write(&variables, "5161 0\n").expect("a file");
    let output = Command::new("rs274").arg("-g").arg("-t").arg(&table).arg("-v").arg(&variables).arg(program).output();
    let output = output.expect("rs274 runs");
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.success(), "{}: {said}", program.display());
    String::from_utf8_lossy(&output.stdout).lines().map(str::to_owned).collect()
}

/// A motion as the interpreter tells it: its name and the axis values X Y Z A B C.
fn motions(calls: &[String]) -> Vec<(String, Vec<f64>)> {
    let motion = |call: &String| {
        let start = call.find("STRAIGHT_TRAVERSE").or(call.find("STRAIGHT_FEED"))?;
        let (name, rest) = call[start..].split_once('(')?;
        let numbers = rest.trim_end().trim_end_matches(')').split(',');
        Some((name.to_owned(), numbers.filter_map(|number| number.trim().parse().ok()).collect()))
    };
    calls.iter().filter_map(motion).collect()
}

fn read<M: Machine>(program: &Path, units: Units) -> Vec<Block> {
    let control = control::by_name("linuxcnc").expect("it is there");
    let config = Config { output_units: Some(units), ..control::starting_point(control) };
    let bytes = fs::read(program).expect("a program");
    blocks::<M>(&Job { config: &config, control, units: None }, &bytes[..]).expect("it can be read")
}

/// Compares every straight motion with what our reader makes of its block.
fn compare<M: Machine>(part: &str, machine: &str) {
    let path = workspace().join(format!("tests/data/{part}/{machine}.linuxcnc.nc"));
    let text = fs::read_to_string(&path).expect("a program");
    let units = if text.contains("UNITS in") { Units::Inches } else { Units::Millimetres };
    let blocks = read::<M>(&path, units);
    // The rows of the tools, and of registers that have a number of their own.
    let register = |block: &Block| match block.state.length {
        Some(Length::Register(register)) => Some(register),
        _ => None,
    };
    let tools = blocks.iter().flat_map(|block| [block.state.tool, register(block)]).flatten().collect();
    let guards: Vec<_> = blocks.iter().filter_map(|block| Some((block.state.tool?, block.guard?))).collect();
    let theirs = motions(&canonical(&path, &tools, &guards));
    let mut theirs = theirs.iter();
    let straight =
        |action: &Action| matches!(action, Action::Rapid | Action::Feed | Action::Machine | Action::Cycle(_));
    for block in blocks.iter().filter(|block| straight(&block.action) && block.written != 0) {
        let context = format!("{part} {machine} line {}", block.line);
        if let Action::Cycle(cycle) = &block.action {
            assert_hole(cycle, &mut theirs, units, &context);
            continue;
        }
        let (name, numbers) = theirs.next().unwrap_or_else(|| panic!("{context}: there is no motion"));
        assert_eq!(name == "STRAIGHT_FEED", block.action == Action::Feed, "{context}");
        if block.action == Action::Machine {
            continue;
        }
        for (index, axis) in M::AXES.iter().enumerate().filter(|(index, _)| block.known & (1 << index) != 0) {
            let place = "XYZABC".find(axis.letter).expect("one of the six");
            let ours = match axis.kind {
                AxisKind::Linear => block.values[index] / units.in_mm(),
                AxisKind::Rotary => block.values[index].to_degrees(),
            };
            let there = numbers[place];
            assert!((ours - there).abs() <= PRINTED, "{context}: {} is {ours} here and {there} there", axis.letter);
        }
    }
    assert_eq!(theirs.next(), None, "{part} {machine}: a motion that no block asks for");
}

/// The motions of one cycle: down to its bottom and no deeper, and back to where it ends.
fn assert_hole<'m>(
    cycle: &CycleMove,
    theirs: &mut impl Iterator<Item = &'m (String, Vec<f64>)>,
    units: Units,
    context: &str,
) {
    let [bottom, back_to] = [cycle.bottom, cycle.back_to].map(|level| level / units.in_mm());
    let mut deep = false;
    for (_, numbers) in theirs {
        let z = numbers[2];
        assert!(z >= bottom - PRINTED, "{context}: Z{z} is below the bottom of the hole, Z{bottom}");
        deep |= z <= bottom + PRINTED;
        if deep && (z - back_to).abs() <= PRINTED {
            return;
        }
    }
    panic!("{context}: the hole does not end at Z{back_to}, or is not Z{bottom} deep");
}

#[test]
fn the_interpreter_reads_every_straight_motion_as_we_do() {
    if !installed() {
        return;
    }
    for (part, machine) in PROGRAMS {
        match *machine {
            "spinner-u5-620" => compare::<SpinnerU5620>(part, machine),
            "dmu-70e" => compare::<Dmu70e>(part, machine),
            "lola-xoyzba" => compare::<LolaXoyzba>(part, machine),
            _ => compare::<MultiProDesk>(part, machine),
        }
    }
}

#[test]
fn a_word_that_is_a_tenth_off_is_noticed() {
    if !installed() {
        return;
    }
    let source = workspace().join("tests/data/blade/spinner-u5-620.linuxcnc.nc");
    let text = fs::read_to_string(source).expect("a program").replacen("X-29.236", "X-29.336", 1);
    let folder = tempfile::tempdir().expect("a folder");
    let program = folder.path().join("blade.ngc");
    fs::write(&program, text).expect("a program");
    let calls = motions(&canonical(&program, &BTreeSet::from([3]), &[]));
    let path = workspace().join("tests/data/blade/spinner-u5-620.linuxcnc.nc");
    let blocks = read::<SpinnerU5620>(&path, Units::Millimetres);
    let moving = blocks.iter().filter(|block| matches!(block.action, Action::Rapid | Action::Feed | Action::Machine));
    let mut feeds = moving.zip(&calls).filter(|(block, _)| block.action == Action::Feed);
    assert!(feeds.any(|(block, (_, numbers))| (block.values[2] - numbers[0]).abs() > 0.09));
}
