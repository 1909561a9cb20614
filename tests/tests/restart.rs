//! Every golden program can be entered at each of its restart points: what follows moves as it does in the whole program.
//!
//! Whoever enters there has switched the control on, and the tool of the operation stands in the spindle.

use std::fs;
use std::path::{Path, PathBuf};

use machines::{Dmu70e, LolaXoyzba, SpinnerU5620};
use pp_runtime::check::read::{Action, Block, TipControl};
use pp_runtime::check::{Job, blocks};
use pp_runtime::config::{Mode, starting_point};
use pp_runtime::control;
use pp_runtime::kinematics::{AxisKind, Machine};
use tests::binaries::workspace;
use tests::state::{Moved, State, moved, restarts, stripped};

/// The golden programs, in their order.
fn goldens() -> Vec<PathBuf> {
    let mut files = Vec::new();
    for part in fs::read_dir(workspace().join("tests/data")).expect("the folder of the parts") {
        for file in fs::read_dir(part.expect("a part").path()).expect("the folder of a part") {
            let path = file.expect("a file").path();
            files.extend(path.extension().is_some_and(|extension| extension == "nc").then_some(path));
        }
    }
    files.sort();
    files
}

/// What the operator has seen to where a program is entered: the tool of the operation, which Heidenhain measures with its
/// call.
fn entered(program: &str, whole: &[Moved], line: usize) -> State {
    let before = whole.iter().rfind(|moved| moved.line < line).map(|moved| &moved.state);
    let Some(before) = before else { return State::default() };
    let register = before.register.filter(|_| program.contains("BEGIN PGM"));
    State { tool: before.tool, register, ..State::default() }
}

/// Why a block does not do what it does in the whole program.
fn difference(whole: &Moved, entered: &Moved, axes: usize) -> Option<&'static str> {
    let (one, other) = (&whole.state, &entered.state);
    let known = other.at.iter().all(|(letter, at)| one.at.get(letter).is_none_or(|whole| (whole - at).abs() < 1e-12));
    let feed = other.rapid == Some(false) && !entered.machine;
    match () {
        () if whole.line != entered.line || whole.words != entered.words => Some("other words"),
        () if whole.machine != entered.machine || one.rapid != other.rapid => Some("another kind of motion"),
        () if !known => Some("another place"),
        () if entered.machine => None,
        () if one.tool != other.tool || one.register != other.register => Some("another tool or length"),
        () if one.offset != other.offset || one.offset.is_none() => Some("another work offset"),
        () if !feed => None,
        () if other.register.is_none_or(|register| register == 0) => Some("a cut without length"),
        () if !matches!(other.spindle, Some(3 | 4)) => Some("a cut with a spindle that stands"),
        () if other.at.len() < axes => Some("an axis whose place nobody knows"),
        () if (one.inverse, one.feed) != (other.inverse, other.feed) || one.feed.is_none() => Some("another F"),
        () if (one.spindle, one.speed) != (other.spindle, other.speed) => Some("another spindle"),
        () if one.coolant != other.coolant => Some("another coolant"),
        () => None,
    }
}

/// What goes wrong where a program is entered at a line, and how many blocks move behind it.
fn enter(program: &str, line: usize) -> Result<usize, String> {
    let whole = moved(program, 0, State::default());
    let axes = whole.last().map_or(0, |last| last.state.at.len());
    let rest = moved(program, line, entered(program, &whole, line));
    let tail: Vec<&Moved> = whole.iter().filter(|moved| moved.line >= line).collect();
    if tail.len() != rest.len() {
        return Err(format!("{} blocks move, in the whole program {}", rest.len(), tail.len()));
    }
    for (whole, entered) in tail.iter().zip(&rest) {
        if let Some(why) = difference(whole, entered, axes.max(4)) {
            return Err(format!("line {}: {why}\n{:?}\n{:?}", whole.line + 1, whole.state, entered.state));
        }
    }
    Ok(rest.len())
}

#[test]
fn every_golden_program_moves_alike_from_each_restart_point_on() {
    let mut entries = 0;
    for path in goldens() {
        let program = fs::read_to_string(&path).expect("ASCII");
        let lines = restarts(&program);
        assert!(!lines.is_empty(), "{}: no restart point", path.display());
        for line in lines {
            match enter(&program, line) {
                Ok(blocks) => assert!(blocks > 5, "{}, line {}", path.display(), line + 1),
                Err(why) => panic!("{}, entered at line {}: {why}", path.display(), line + 1),
            }
            entries += 1;
        }
    }
    assert!(entries > 100, "{entries} entries");
}

#[test]
fn a_state_that_is_lost_behind_a_restart_point_is_seen() {
    let folder = workspace().join("tests/data");
    let read = |name: &str| fs::read_to_string(folder.join(name)).expect("ASCII");
    for (name, lost) in [
        ("blade/spinner-u5-620.fanuc.nc", "G43 H3 "),
        ("blade/spinner-u5-620.fanuc.nc", "S7600 M3"),
        ("blade/spinner-u5-620.siemens.nc", "D1"),
        ("blade/spinner-u5-620.haas.nc", " G54"),
        ("blade/spinner-u5-620.linuxcnc.nc", "G43 H3"),
        ("blade/spinner-u5-620.heidenhain.nc", "M3"),
    ] {
        let program = read(name);
        let lines = restarts(&program);
        let line = lines[1];
        let mut text: Vec<&str> = program.lines().collect();
        let found = text[line..].iter().position(|text| text.contains(lost));
        let at = line + found.unwrap_or_else(|| panic!("{name}: {lost}"));
        let without = text[at].replacen(lost, "", 1);
        text[at] = &without;
        assert!(enter(&text.join("\n"), line).is_err(), "{name} without {lost}");
    }
}

/// The blocks of a program of `works` in a mode, as the reader of the check has them: it knows tip control and planes.
fn read<M: Machine>(program: &str, control: &str, mode: Mode) -> Vec<Block> {
    let text = fs::read_to_string(workspace().join("tests/data/works/works.toml")).expect("a configuration");
    let control = control::by_name(control).expect("it is there");
    let mut config = starting_point(control).read_over(&M::default(), &text).expect("a valid configuration");
    config.motion.mode = mode;
    blocks::<M>(&Job { config: &config, control, units: None }, program.as_bytes()).expect("it can be read")
}

/// Whether both are on with the rotary axes at the same angles, or both off.
fn same_tip_control<M: Machine>(one: &TipControl, other: &TipControl) -> bool {
    let (TipControl::On { start: one }, TipControl::On { start: other }) = (one, other) else { return one == other };
    let rotary = |(axis, _): &(&pp_runtime::kinematics::Axis, _)| axis.kind == AxisKind::Rotary;
    M::AXES.iter().zip(one.iter().zip(other)).filter(rotary).all(|(_, (one, other))| (one - other).abs() < 1e-12)
}

/// Why a block that is entered before does not do what it does in the whole program.
fn parted<M: Machine>(whole: &Block, entered: &Block, solved: u16) -> Option<&'static str> {
    let (one, other) = (&whole.state, &entered.state);
    let same = |index: usize| (whole.values[index] - entered.values[index]).abs() < 1e-12;
    let mut places = (0..solved.count_ones() as usize).filter(|index| entered.known & (1 << index) != 0);
    let cuts = matches!(entered.action, Action::Feed | Action::Arc(_) | Action::Cycle(_));
    let own_feed = matches!(entered.action, Action::Cycle(cycle) if cycle.feed.is_some());
    match () {
        () if whole.action != entered.action || whole.written != entered.written => Some("another motion"),
        () if !places.all(same) => Some("another place"),
        () if !same_tip_control::<M>(&one.tip_control, &other.tip_control) => Some("another tip control"),
        () if (one.tilt, one.vector) != (other.tilt, other.vector) => Some("another plane"),
        () if !cuts => None,
        () if entered.known & solved != solved => Some("an axis whose place nobody knows"),
        () if (one.work_offset, one.units) != (other.work_offset, other.units) => Some("another offset"),
        () if (one.incremental, one.side) != (other.incremental, other.side) => Some("another way to count"),
        () if (one.spindle, one.speed, one.coolant) != (other.spindle, other.speed, other.coolant) => {
            Some("another spindle")
        }
        () if !own_feed && (one.feed_mode, one.feed) != (other.feed_mode, other.feed) => Some("another feed"),
        () if (one.length, one.plane) != (other.length, other.plane) => Some("another length or plane"),
        () => None,
    }
}

/// What goes wrong where a program of a mode is entered at some lines.
fn enter_mode<M: Machine>(program: &str, control: &str, mode: Mode, lines: &[usize]) -> Result<(), String> {
    let whole = read::<M>(program, control, mode);
    let solved = (1_u16 << M::AXES.iter().filter(|axis| !axis.held).count()) - 1;
    for &line in lines {
        // A Heidenhain control is told the unit in the first line, and length and plane with the tool that stands in the
        // spindle.
        let call = |text: &&str| stripped(text).strip_prefix("TOOL CALL ").is_some_and(|call| !call.starts_with('S'));
        let before: Vec<&str> = program.lines().take(line).collect();
        let mut text: Vec<&str> =
            before.first().into_iter().chain(before.iter().rfind(|text| call(text))).copied().collect();
        let told = text.len() as u64;
        text.extend(program.lines().skip(line));
        let entered = read::<M>(&text.join("\n"), control, mode);
        let moves = |block: &&Block| block.action != Action::Nothing;
        let tail: Vec<&Block> = whole.iter().filter(|block| block.line > line as u64).filter(moves).collect();
        let rest: Vec<&Block> = entered.iter().filter(|block| block.line > told).filter(moves).collect();
        if tail.len() != rest.len() || rest.len() < 5 {
            return Err(format!("line {}: {} blocks, in the whole program {}", line + 1, rest.len(), tail.len()));
        }
        for (one, other) in tail.iter().zip(&rest) {
            if let Some(why) = parted::<M>(one, other, solved) {
                return Err(format!("entered at line {}, line {}: {why}\n{one:?}\n{other:?}", line + 1, one.line));
            }
        }
    }
    Ok(())
}

/// [`enter_mode`] for a machine.
type Enter = fn(&str, &str, Mode, &[usize]) -> Result<(), String>;

fn works(mode: &str, machine: &str, control: &str) -> String {
    let folder = workspace().join("tests/data/works");
    let path = folder.join(Path::new(mode).join(format!("{machine}.{control}.nc")));
    fs::read_to_string(path).expect("a golden program")
}

#[test]
fn programs_under_tip_control_and_in_planes_are_entered_with_their_frames() {
    let mut entries = 0;
    for (name, mode) in [("tcp", Mode::Tcp), ("plane", Mode::Plane)] {
        for control in ["fanuc", "siemens", "heidenhain", "haas"] {
            let mut enter = |machine: &str, enter: Enter| {
                let program = works(name, machine, control);
                let lines = restarts(&program);
                entries += lines.len();
                let entered = enter(&program, control, mode, &lines);
                entered.unwrap_or_else(|why| panic!("{name} {machine} {control}, {why}"));
            };
            enter("spinner-u5-620", enter_mode::<SpinnerU5620>);
            enter("dmu-70e", enter_mode::<Dmu70e>);
            enter("lola-xoyzba", enter_mode::<LolaXoyzba>);
        }
    }
    assert!(entries >= 72, "{entries} entries");
}

#[test]
fn a_frame_that_is_lost_behind_a_restart_point_is_seen() {
    for (mode, name, control, lost) in [
        (Mode::Tcp, "tcp", "fanuc", "G43.4 "),
        (Mode::Tcp, "tcp", "siemens", "TRAORI"),
        (Mode::Tcp, "tcp", "heidenhain", "FUNCTION TCPM"),
        (Mode::Plane, "plane", "fanuc", "G53.1"),
        (Mode::Plane, "plane", "siemens", "CYCLE800(0"),
        (Mode::Plane, "plane", "heidenhain", "PLANE SPATIAL"),
        (Mode::Plane, "plane", "haas", "G268"),
    ] {
        // Whoever enters behind the block that brings the frame does not have it.
        let program = works(name, "spinner-u5-620", control);
        let entry = restarts(&program)[1];
        let found = program.lines().skip(entry).position(|text| text.contains(lost));
        let behind = entry + 1 + found.unwrap_or_else(|| panic!("{name} {control}: no {lost}"));
        let entered = enter_mode::<SpinnerU5620>(&program, control, mode, &[behind]);
        assert!(entered.is_err(), "{name} {control} without {lost}");
    }
}
