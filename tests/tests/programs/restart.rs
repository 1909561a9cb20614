//! Every golden program can be entered at each of its restart points: the motions after it are those of the whole
//! program.
//!
//! At the entry the control has just been switched on, and the tool of the operation is in the spindle.

use std::fs;
use std::path::Path;

use machines::{Dmu70e, LolaXoyzba, SpinnerU5620};
use pp_runtime::check::blocks;
use pp_runtime::check::read::{Action, Block, TipControl};
use pp_runtime::config::{Mode, starting_point};
use pp_runtime::control;
use pp_runtime::kinematics::{AxisKind, Machine};
use tests::binaries::{golden_programs, workspace};
use tests::foreign::state::{Interpolation, Length, Spindle, State};
use tests::foreign::{Control, Effect, Entry, Executed, Options, Trace, run};

/// Control of a golden program, by its file name.
fn control_of(path: &Path) -> Control {
    let name = path.file_stem().expect("a name").to_string_lossy().into_owned();
    Control::by_name(name.rsplit('.').next().expect("a control")).expect("a control")
}

fn traced(program: &str, options: &Options) -> Trace {
    run(program, options).unwrap_or_else(|refused| panic!("{}: {refused}", options.control.name()))
}

/// Lines, from 1, at which a program can be entered.
fn restarts(program: &str, control: Control) -> Vec<usize> {
    traced(program, &Options::of(control)).restarts().collect()
}

/// Difference between a block of the whole program and the same block of the entered one; `axes`: number of axes.
fn difference(whole: &Executed, entered: &Executed, axes: usize) -> Option<&'static str> {
    let (one, other) = (&whole.state, &entered.state);
    let at = |letter: char| one.position.get(letter);
    let known = other.position.iter().all(|(letter, here)| at(letter).is_none_or(|there| (there - here).abs() < 1e-12));
    match () {
        () if whole.line != entered.line || whole.words != entered.words => Some("different words"),
        () if whole.effect != entered.effect => Some("different kind of motion"),
        () if !known => Some("different position"),
        () if entered.effect == Effect::Machine => None,
        () if one.tool != other.tool || one.length != other.length => Some("different tool or length"),
        () if one.work_offset != other.work_offset || one.work_offset.is_none() => Some("different work offset"),
        () if one.tilted_plane() != other.tilted_plane() => Some("different plane"),
        () if one.dynamic_offset != other.dynamic_offset => Some("different dynamic work offset"),
        () if one.under_tip_control() != other.under_tip_control() => Some("different tip control"),
        () if !entered.effect.cuts() => None,
        () if !matches!(other.length, Some(Length::Register(_))) => Some("a cut without length"),
        () if !matches!(other.spindle, Some(Spindle::Clockwise | Spindle::CounterClockwise)) => {
            Some("a cut with the spindle off")
        }
        () if other.position.len() < axes => Some("an axis at an unknown position"),
        () if whole.feed() != entered.feed() || one.feed_mode != other.feed_mode => Some("different F"),
        () if (one.spindle, one.speed) != (other.spindle, other.speed) => Some("different spindle"),
        () if one.coolant != other.coolant => Some("different coolant"),
        () if (one.units, one.distance, one.plane) != (other.units, other.distance, other.plane) => {
            Some("different unit, distance mode or plane")
        }
        () if one.compensation != other.compensation => Some("different cutter compensation"),
        () if posture(one) != posture(other) => Some("different tool axis"),
        () => None,
    }
}

/// What decides about the tool axis under tip control.
fn posture(state: &State) -> Option<(Option<Interpolation>, Option<[f64; 3]>)> {
    state.under_tip_control().then_some((state.interpolation, state.vector))
}

/// Enters a program at a line; returns the number of moving blocks after it, or the first difference.
fn enter(program: &str, control: Control, line: usize) -> Result<usize, String> {
    let options = Options::of(control);
    let whole = run(program, &options).map_err(|refused| refused.to_string())?;
    let tool = whole.blocks.iter().rfind(|block| block.line < line).and_then(|block| block.state.tool);
    let options = Options { entry: Some(Entry { line, tool }), ..options };
    let rest = run(program, &options).map_err(|refused| refused.to_string())?;
    let axes = whole.blocks.iter().map(|block| block.state.position.len()).max().unwrap_or(0).max(4);
    let tail: Vec<&Executed> = whole.motions().filter(|moved| moved.line >= line).collect();
    let rest: Vec<&Executed> = rest.motions().collect();
    if tail.len() != rest.len() {
        return Err(format!("{} blocks move, in the whole program {}", rest.len(), tail.len()));
    }
    for (whole, entered) in tail.iter().zip(&rest) {
        // In a tilted plane the control has moved the rotary axes to angles of its own.
        let axes = if whole.state.tilted_plane().is_some() { 3 } else { axes };
        if let Some(why) = difference(whole, entered, axes) {
            return Err(format!("line {}: {why}\n{:?}\n{:?}", whole.line, whole.state, entered.state));
        }
    }
    Ok(rest.len())
}

#[test]
fn every_golden_program_has_the_same_motions_from_each_restart_point() {
    let mut entries = 0;
    for path in golden_programs() {
        let program = fs::read_to_string(&path).expect("ASCII");
        let control = control_of(&path);
        let lines = restarts(&program, control);
        assert!(!lines.is_empty(), "{}: no restart point", path.display());
        for line in lines {
            match enter(&program, control, line) {
                Ok(blocks) => assert!(blocks > 5, "{}, line {line}", path.display()),
                Err(why) => panic!("{}, entered at line {line}: {why}", path.display()),
            }
            entries += 1;
        }
    }
    assert!(entries > 200, "{entries} entries");
}

#[test]
fn a_state_that_is_lost_after_a_restart_point_is_found() {
    let folder = workspace().join("tests/data");
    let read = |name: &str| fs::read_to_string(folder.join(name)).expect("ASCII");
    for (name, lost, seen) in [
        ("blade/spinner-u5-620.fanuc.nc", "G43 H3 ", "length"),
        ("blade/spinner-u5-620.fanuc.nc", "S7600 M3", "spindle"),
        ("blade/spinner-u5-620.siemens.nc", "D1", "length"),
        ("blade/spinner-u5-620.haas.nc", " G54", "work offset"),
        ("blade/spinner-u5-620.linuxcnc.nc", "G43 H3", "length"),
        ("blade/spinner-u5-620.heidenhain.nc", "M3", "spindle"),
    ] {
        let (program, control) = (read(name), control_of(Path::new(name)));
        let line = restarts(&program, control)[1];
        let mut text: Vec<&str> = program.lines().collect();
        let found = text[line - 1..].iter().position(|text| text.contains(lost));
        let at = line - 1 + found.unwrap_or_else(|| panic!("{name}: {lost}"));
        // A comment replaces a block that is lost as a whole.
        let comment = if matches!(control, Control::Siemens | Control::Heidenhain) { "; LOST" } else { "(LOST)" };
        let alone = text[at] == lost || control == Control::Heidenhain;
        let without = text[at].replacen(lost, if alone { comment } else { "" }, 1);
        text[at] = &without;
        let error = enter(&(text.join("\n") + "\n"), control, line).expect_err(name);
        assert!(error.contains(seen), "{name} without {lost}: {error}");
    }
}

/// Blocks of a program of `works` in a mode, by the reader of the check, which supports tip control and planes.
fn read<M: Machine>(program: &str, control: &str, mode: Mode) -> Vec<Block> {
    let text = fs::read_to_string(workspace().join("tests/data/works/works.toml")).expect("a configuration");
    let control = control::by_name(control).expect("it is there");
    let mut config = starting_point(control).read_over(&M::default(), &text).expect("a valid configuration");
    config.motion.mode = mode;
    blocks::<M>(
        &config.check_policy::<M>(control, None).expect("the configuration suits control and machine"),
        program.as_bytes(),
    )
    .expect("it can be read")
}

/// Whether tip control is on in both with the rotary axes at the same angles, or off in both.
fn same_tip_control<M: Machine>(one: &TipControl, other: &TipControl) -> bool {
    let (TipControl::On { start: one }, TipControl::On { start: other }) = (one, other) else { return one == other };
    let rotary = |(axis, _): &(&pp_runtime::kinematics::Axis, _)| axis.kind == AxisKind::Rotary;
    M::AXES.iter().zip(one.iter().zip(other)).filter(rotary).all(|(_, (one, other))| (one - other).abs() < 1e-12)
}

/// Difference between a block of the whole program and of the entered one, by the reader of the check; `solved`: bits
/// of the solved axes.
fn read_difference<M: Machine>(whole: &Block, entered: &Block, solved: u16) -> Option<&'static str> {
    let (one, other) = (&whole.state, &entered.state);
    let same = |index: usize| (whole.values[index] - entered.values[index]).abs() < 1e-12;
    let mut positions = (0..solved.count_ones() as usize).filter(|index| entered.known & (1 << index) != 0);
    let cuts = matches!(entered.action, Action::Feed | Action::Arc(_) | Action::Cycle(_));
    let own_feed = matches!(entered.action, Action::Cycle(cycle) if cycle.feed.is_some());
    match () {
        () if whole.action != entered.action || whole.written != entered.written => Some("different motion"),
        () if !positions.all(same) => Some("different position"),
        () if !same_tip_control::<M>(&one.tip_control, &other.tip_control) => Some("different tip control"),
        () if (one.tilt, one.vector) != (other.tilt, other.vector) => Some("different plane"),
        () if one.dynamic_offset != other.dynamic_offset => Some("different dynamic work offset"),
        () if !cuts => None,
        () if entered.known & solved != solved => Some("an axis at an unknown position"),
        () if (one.work_offset, one.units) != (other.work_offset, other.units) => Some("different work offset or unit"),
        () if (one.incremental, one.side) != (other.incremental, other.side) => {
            Some("different distance mode or compensation")
        }
        () if (one.spindle, one.speed, one.coolant) != (other.spindle, other.speed, other.coolant) => {
            Some("different spindle")
        }
        () if !own_feed && (one.feed_mode, one.feed) != (other.feed_mode, other.feed) => Some("different feed"),
        () if (one.length, one.plane) != (other.length, other.plane) => Some("different length or plane"),
        () => None,
    }
}

/// Enters a program of a mode after each of some lines; the error is the first difference.
fn enter_mode<M: Machine>(program: &str, control: &str, mode: Mode, lines: &[usize]) -> Result<(), String> {
    let whole = read::<M>(program, control, mode);
    let trace = traced(program, &Options::of(Control::by_name(control).expect("a control")));
    let solved = (1_u16 << M::AXES.iter().filter(|axis| !axis.held).count()) - 1;
    for &line in lines {
        // A Heidenhain program sets the unit in its first line, and length and plane with the call of the tool in the
        // spindle.
        let called = |block: &&Executed| matches!(block.effect, Effect::ToolChange(_)) && block.line <= line;
        let call = trace.blocks.iter().rfind(called).filter(|_| control == "heidenhain");
        let all: Vec<&str> = program.lines().collect();
        let mut text: Vec<&str> =
            all[..line.min(1)].iter().copied().chain(call.map(|call| all[call.line - 1])).collect();
        let prepended = text.len() as u64;
        text.extend(program.lines().skip(line));
        let entered = read::<M>(&text.join("\n"), control, mode);
        let moves = |block: &&Block| block.action != Action::Nothing;
        let tail: Vec<&Block> = whole.iter().filter(|block| block.line > line as u64).filter(moves).collect();
        let rest: Vec<&Block> = entered.iter().filter(|block| block.line > prepended).filter(moves).collect();
        if tail.len() != rest.len() || rest.len() < 5 {
            return Err(format!("line {}: {} blocks, in the whole program {}", line + 1, rest.len(), tail.len()));
        }
        for (one, other) in tail.iter().zip(&rest) {
            if let Some(why) = read_difference::<M>(one, other, solved) {
                return Err(format!("entered at line {}, line {}: {why}\n{one:?}\n{other:?}", line + 1, one.line));
            }
        }
    }
    Ok(())
}

/// Number of lines before each restart point.
fn before_restarts(program: &str, control: &str) -> Vec<usize> {
    let control = Control::by_name(control).expect("a control");
    restarts(program, control).into_iter().map(|line| line - 1).collect()
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
    for (name, mode) in [("tcp", Mode::Tcp), ("plane", Mode::Plane), ("auto", Mode::Auto)] {
        for control in ["fanuc", "siemens", "heidenhain", "haas"] {
            let mut enter = |machine: &str, enter: Enter| {
                let program = works(name, machine, control);
                let lines = before_restarts(&program, control);
                entries += lines.len();
                let entered = enter(&program, control, mode, &lines);
                entered.unwrap_or_else(|why| panic!("{name} {machine} {control}, {why}"));
            };
            enter("spinner-u5-620", enter_mode::<SpinnerU5620>);
            enter("dmu-70e", enter_mode::<Dmu70e>);
            enter("lola-xoyzba", enter_mode::<LolaXoyzba>);
        }
    }
    assert!(entries >= 120, "{entries} entries");
}

#[test]
fn a_frame_that_is_lost_after_a_restart_point_is_found() {
    for (mode, name, control, lost) in [
        (Mode::Tcp, "tcp", "fanuc", "G43.4 "),
        (Mode::Tcp, "tcp", "siemens", "TRAORI"),
        (Mode::Tcp, "tcp", "heidenhain", "FUNCTION TCPM"),
        (Mode::Plane, "plane", "fanuc", "G53.1"),
        (Mode::Plane, "plane", "siemens", "CYCLE800(0"),
        (Mode::Plane, "plane", "heidenhain", "PLANE SPATIAL"),
        (Mode::Plane, "plane", "haas", "G254"),
    ] {
        // A program that is entered after the block that sets the frame does not have it.
        let program = works(name, "spinner-u5-620", control);
        let entry = before_restarts(&program, control)[1];
        let found = program.lines().skip(entry).position(|text| text.contains(lost));
        let after = entry + 1 + found.unwrap_or_else(|| panic!("{name} {control}: no {lost}"));
        let entered = enter_mode::<SpinnerU5620>(&program, control, mode, &[after]);
        assert!(entered.is_err(), "{name} {control} without {lost}");
    }
}
