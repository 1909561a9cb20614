//! Every golden program can be entered at each of its restart points: what follows moves as it does in the whole program.
//!
//! Whoever enters there has switched the control on, and the tool of the operation stands in the spindle.

use std::fs;
use std::path::PathBuf;

use tests::binaries::workspace;
use tests::state::{Moved, State, moved, restarts};

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
