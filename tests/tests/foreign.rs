//! Every golden program through the foreign interpreter: it runs to its end, and its motions are those that the product's
//! own reader finds.
//!
//! The two share no code. Each motion is compared: its kind, axis positions, F and feed mode, circle, hole, and the state
//! in which it is made.

use std::fs;
use std::path::{Path, PathBuf};

use machines::{Dmu70e, LolaXoyzba, MultiProDesk, SpinnerU5620};
use pp_runtime::check::read::{self, Action, Block, coolant};
use pp_runtime::check::{Job, blocks};
use pp_runtime::config::{Mode, starting_point};
use pp_runtime::control;
use pp_runtime::kinematics::{AxisKind, Machine};
use pp_runtime::program::{Rotation, Units};
use tests::binaries::workspace;
use tests::foreign::state::{self, Compensation, CycleKind, Length, Spindle, WorkOffset};
use tests::foreign::{Control, Effect, Executed, Options, Trace, run};

/// Golden programs in the folders of `tests/data`, sorted.
fn goldens() -> Vec<PathBuf> {
    let mut files = Vec::new();
    let mut folders = vec![workspace().join("tests/data")];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).expect("a folder of the parts") {
            let path = entry.expect("an entry").path();
            match path.extension() {
                _ if path.is_dir() => folders.push(path),
                Some(extension) if extension == "nc" => files.push(path),
                _ => {}
            }
        }
    }
    files.sort();
    files
}

/// Machine and control in the name of a golden program.
fn names(path: &Path) -> (String, Control) {
    let name = path.file_stem().expect("a name").to_string_lossy().into_owned();
    let (machine, control) = name.split_once('.').expect("machine and control");
    (machine.to_owned(), Control::by_name(control).expect("a control"))
}

fn traced(path: &Path) -> (String, Trace) {
    let text = fs::read_to_string(path).expect("ASCII");
    let (_, control) = names(path);
    let trace = run(&text, &Options::of(control)).unwrap_or_else(|refused| panic!("{}: {refused}", path.display()));
    (text, trace)
}

/// Configuration with which a golden program was posted; its folder is that of the part, or of a mode in it.
fn config_of(path: &Path, machine: &str) -> (String, Mode) {
    let folder = path.parent().expect("a folder");
    let (part, mode) = match folder.file_name().and_then(|name| name.to_str()) {
        Some("tcp") => (folder.parent().expect("the part"), Mode::Tcp),
        Some("plane") => (folder.parent().expect("the part"), Mode::Plane),
        _ => (folder, Mode::Axes),
    };
    let name = part.file_name().expect("a name").to_string_lossy().into_owned();
    let name = if name == "works" && machine != "lola-xoyzba" { "table".to_owned() } else { name };
    (fs::read_to_string(part.join(format!("{name}.toml"))).unwrap_or_default(), mode)
}

/// Motions of a program as the product's own reader finds them.
fn read_by_product<M: Machine>(path: &Path, text: &str, units: Units) -> Vec<Block> {
    let (machine, control) = names(path);
    let control = control::by_name(control.name()).expect("a control");
    let (config, mode) = config_of(path, &machine);
    let mut config = starting_point(control).read_over::<M>(&config).expect("a configuration");
    config.motion.mode = mode;
    let job = Job { config: &config, control, units: Some(units) };
    let all = blocks::<M>(&job, text.as_bytes()).expect("it can be read");
    if let Some(block) = all.iter().find(|block| !block.faults.is_empty()) {
        panic!("{}: {block:?}", path.display());
    }
    all.into_iter().filter(|block| block.action.moves()).collect()
}

fn near(one: f64, other: f64) -> bool {
    (one - other).abs() <= 1e-9 * one.abs().max(1.0)
}

fn near_or_absent(one: Option<f64>, other: Option<f64>) -> bool {
    match (one, other) {
        (Some(one), Some(other)) => near(one, other),
        _ => one.is_none() && other.is_none(),
    }
}

/// Why a motion is not the one that the product's reader finds.
fn difference<M: Machine>(block: &Block, executed: &Executed) -> Option<String> {
    let unit = executed.state.units.map_or(1.0, state::Units::in_mm);
    let machine = executed.effect == Effect::Machine;
    for (index, axis) in M::AXES.iter().enumerate() {
        let scale = if axis.kind == AxisKind::Linear { unit } else { 1.0_f64.to_radians() };
        let written = executed.words.contains(axis.letter);
        if written != (block.written & (1 << index) != 0) && !matches!(block.action, Action::Arc(_)) {
            return Some(format!("{} is written in one of them", axis.letter));
        }
        let found = if machine { executed.words.get(axis.letter) } else { executed.state.position.get(axis.letter) };
        let known = if machine { block.written } else { block.known } & (1 << index) != 0;
        let Some(found) = found.filter(|_| known) else {
            let compared = !executed.effect.cuts() || axis.kind == AxisKind::Rotary && block.state.tilt.is_some();
            if (written || !compared) && executed.effect != Effect::Orient {
                return Some(format!("{} is unknown", axis.letter));
            }
            continue;
        };
        if !near(found * scale, block.values[index]) {
            return Some(format!("{}: {} and {}", axis.letter, found * scale, block.values[index]));
        }
    }
    kinds(block, executed, unit).or_else(|| states(block, executed, unit))
}

fn kinds(block: &Block, executed: &Executed, unit: f64) -> Option<String> {
    let same = match (block.action, executed.effect) {
        (Action::Rapid, Effect::Rapid)
        | (Action::Feed, Effect::Feed)
        | (Action::Machine, Effect::Machine)
        | (Action::Orient, Effect::Orient) => true,
        (Action::Arc(one), Effect::Arc(other)) => {
            let [first, second, _] = block.state.plane.expect("a plane of arcs").axes();
            let centres = [first, second].into_iter().all(|index| near(one.centre[index], other.centre[index] * unit));
            centres && (one.sweep.to_degrees() - other.sweep_deg).abs() < 1e-6
        }
        (Action::Cycle(one), Effect::Hole(other)) => {
            let kind = match (one.kind, other.cycle.kind) {
                (read::CycleKind::Drill, CycleKind::Drill) | (read::CycleKind::Ream, CycleKind::Ream) => true,
                (read::CycleKind::Peck(one), CycleKind::Peck { step })
                | (read::CycleKind::ChipBreak(one), CycleKind::ChipBreak { step }) => near(one, step * unit),
                (read::CycleKind::Tap(one), CycleKind::Tap { pitch }) => near(one, pitch * unit),
                _ => false,
            };
            let levels = [
                (one.reference, other.cycle.reference * unit),
                (one.bottom, other.cycle.bottom * unit),
                (one.back_to, other.back_to * unit),
                (one.dwell, other.cycle.dwell_s),
            ];
            kind && levels.into_iter().all(|(one, other)| near(one, other))
                && near_or_absent(one.feed, other.cycle.feed)
        }
        _ => false,
    };
    (!same).then(|| "another motion".to_owned())
}

fn states(block: &Block, executed: &Executed, unit: f64) -> Option<String> {
    let (one, other) = (&block.state, &executed.state);
    let spindle = match other.spindle {
        None => true,
        Some(Spindle::Off) => one.spindle == Some(None),
        Some(Spindle::Clockwise) => one.spindle == Some(Some(Rotation::Clockwise)),
        Some(Spindle::CounterClockwise) => one.spindle == Some(Some(Rotation::CounterClockwise)),
    };
    let bits = other.coolant.map(|on| {
        let bit = |on: bool, bit: u8| if on { bit } else { 0 };
        bit(on.flood, coolant::FLOOD) | bit(on.mist, coolant::MIST) | bit(on.through, coolant::THROUGH)
    });
    let length = match other.length {
        None => one.length.is_none(),
        Some(Length::Off) => one.length == Some(read::Length::Off),
        Some(Length::Register(register)) => one.length == Some(read::Length::Register(register)),
    };
    let offset = match other.work_offset {
        None => one.work_offset.is_none(),
        Some(WorkOffset::Code(code)) => one.work_offset == Some(read::WorkOffset::Code(code)),
        Some(WorkOffset::Further(number)) => one.work_offset == Some(read::WorkOffset::Further(number)),
        Some(WorkOffset::Row(row)) => one.work_offset == Some(read::WorkOffset::Row(row)),
    };
    let side = match other.compensation {
        None => true,
        Some(Compensation::Off) => one.side == Some(read::Side::None),
        Some(Compensation::Left(_)) => one.side == Some(read::Side::Left),
        Some(Compensation::Right(_)) => one.side == Some(read::Side::Right),
    };
    let tilt = match (one.tilt, other.tilted_plane()) {
        (None, None) => true,
        (Some(one), Some(other)) => {
            let entries = (0..3).flat_map(|row| (0..3).map(move |column| (row, column)));
            let same = |(row, column): (usize, usize)| near(one.rotation[(row, column)], other.rotation[row][column]);
            one.oriented == other.oriented
                && entries.clone().all(same)
                && (0..3).all(|index| near(one.origin[index], other.origin[index] * unit))
        }
        _ => false,
    };
    let feed = !executed.effect.cuts()
        || near_or_absent(one.feed, other.feed)
            && one.feed_mode.map(|mode| format!("{mode:?}")) == other.feed_mode.map(|mode| format!("{mode:?}"));
    let tip = (one.tip_control != read::TipControl::Off) == other.under_tip_control();
    let checks = [
        (one.tool == other.tool, "tool"),
        (one.plane.map(read::WorkPlane::axes) == other.plane.map(axes_of), "plane"),
        (spindle, "spindle"),
        (near_or_absent(one.speed, other.speed), "speed"),
        (bits.is_none() || one.coolant == bits, "coolant"),
        (length, "length"),
        (offset, "work offset"),
        (side, "compensation"),
        (tilt, "tilted plane"),
        (feed, "F"),
        (tip, "tip control"),
    ];
    checks.into_iter().find(|(same, _)| !same).map(|(_, what)| format!("another {what}"))
}

/// First axis, second axis and normal of a plane, as positions in X Y Z.
fn axes_of(plane: state::Plane) -> [usize; 3] {
    plane.letters().map(|letter| "XYZ".find(letter).expect("a linear axis"))
}

/// Compares every motion of a program; their number.
fn compare<M: Machine>(path: &Path) -> usize {
    let (text, trace) = traced(path);
    let inches = trace.blocks.iter().any(|block| block.state.units == Some(state::Units::Inches));
    let units = if inches { Units::Inches } else { Units::Millimetres };
    let found = read_by_product::<M>(path, &text, units);
    let executed: Vec<&Executed> = trace.motions().collect();
    for (block, executed) in found.iter().zip(&executed) {
        assert_eq!(block.line, executed.line as u64, "{}\n{block:?}\n{executed:?}", path.display());
        if let Some(why) = difference::<M>(block, executed) {
            panic!("{}, line {}: {why}\n{block:?}\n{executed:?}", path.display(), block.line);
        }
    }
    assert_eq!(found.len(), executed.len(), "{}: motions", path.display());
    found.len()
}

#[test]
fn every_golden_program_moves_as_the_own_reader_of_the_product_finds() {
    let (mut programs, mut motions) = (0, 0);
    for path in goldens() {
        motions += match names(&path).0.as_str() {
            "dmu-70e" => compare::<Dmu70e>(&path),
            "lola-xoyzba" => compare::<LolaXoyzba>(&path),
            "multiprodesk" => compare::<MultiProDesk>(&path),
            "spinner-u5-620" => compare::<SpinnerU5620>(&path),
            name => panic!("{name} is no machine"),
        };
        programs += 1;
    }
    assert!(programs >= 110 && motions > 10_000, "{programs} programs, {motions} motions");
}

#[test]
fn a_golden_program_cut_short_is_refused() {
    for path in goldens() {
        let (text, trace) = traced(&path);
        let end = trace.blocks.iter().rfind(|block| block.effect == Effect::End).expect("an end").line;
        let options = Options::of(names(&path).1);
        let short: String = text.split_inclusive('\n').take(end - 1).collect();
        assert!(run(&short, &options).is_err(), "{} without its end", path.display());
    }
}
