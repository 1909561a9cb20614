//! The interpreter of LinuxCNC alone: `rs274` reads a program and prints its canonical motions.
//!
//! It reads its tool table in inches and prints four decimals, in the unit of the program. The table holds every tool
//! that a program calls, with the length for which the program was posted.

use std::collections::BTreeMap;
use std::fs;
use std::process::Command;

use pp_runtime::check::read::WorkPlane;
use tempfile::TempDir;

use crate::foreign::lexer::{self, Content, Token};
use crate::foreign::{Control, guarded_length};

/// Largest difference between a printed number and the value in the interpreter.
pub const PRINTED: f64 = 6e-5;

/// Length of a tool whose length the program does not check, mm.
const DEFAULT_LENGTH: f64 = 100.0;

/// A motion as the interpreter prints it; X Y Z in units of the program, A B C in degrees.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Motion {
    /// At rapid.
    Traverse([f64; 6]),
    /// At feed.
    Feed([f64; 6]),
    /// A circle or a helix.
    Arc(CanonArc),
    /// Rigid tapping, in and out: X Y Z of the bottom.
    Tap([f64; 3]),
}

/// A circle or a helix in a plane, seen from the end of its normal.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CanonArc {
    /// The plane in force.
    pub plane: WorkPlane,
    /// End point.
    pub end: [f64; 6],
    /// Centre along the first and the second axis of the plane.
    pub centre: [f64; 2],
    /// Revolutions begun, positive counter-clockwise.
    pub turns: i32,
}

/// Length of each register that a program calls, mm. The program may hold lines that a control refuses.
fn lengths(program: &str) -> BTreeMap<u32, f64> {
    let mut lengths = BTreeMap::new();
    let mut tool = 0;
    for line in program.lines() {
        let Ok(lexer::Line { content, .. }) = lexer::line(Control::LinuxCnc, line) else { continue };
        match content {
            Content::Block(tokens) => {
                for token in tokens {
                    if let Token::Word { name, number, .. } = token
                        && matches!(&*name, "T" | "H")
                    {
                        let number = number.value as u32;
                        tool = if name == "T" { number } else { tool };
                        lengths.entry(number).or_insert(DEFAULT_LENGTH);
                    }
                }
            }
            // The guard comes after the call of its tool.
            Content::Condition(text) => lengths.extend(guarded_length(&text).map(|length| (tool, length))),
            Content::Comment(_) | Content::Mark(_) => {}
        }
    }
    lengths
}

/// Canonical calls of a program that runs with tools longer by `off_mm` than it expects.
///
/// # Errors
/// Message of the interpreter about a program that it refuses.
///
/// # Panics
/// If the interpreter cannot be run.
pub fn interpret(program: &str, off_mm: f64) -> Result<String, String> {
    interpret_edited(program, program, off_mm)
}

/// As [`interpret`], with the tools that another program expects: the one from which `program` was edited.
///
/// # Errors
/// Message of the interpreter about a program that it refuses.
///
/// # Panics
/// If the interpreter cannot be run.
pub fn interpret_edited(program: &str, original: &str, off_mm: f64) -> Result<String, String> {
    run(program, original, (off_mm, 0.25 * 25.4))
}

/// As [`interpret`], with tools of this diameter, mm. In a table of wear it may be negative.
///
/// # Errors
/// Message of the interpreter about a program that it refuses.
///
/// # Panics
/// If the interpreter cannot be run.
pub fn interpret_with_diameter(program: &str, diameter_mm: f64) -> Result<String, String> {
    run(program, program, (0.0, diameter_mm))
}

/// Runs a program with the tools that `original` expects, longer by `off_mm`, of a diameter.
fn run(program: &str, original: &str, (off_mm, diameter_mm): (f64, f64)) -> Result<String, String> {
    let folder = TempDir::new().expect("a temporary folder");
    let write = |name: &str, text: &str| fs::write(folder.path().join(name), text).expect("a file can be written");
    let diameter = diameter_mm / 25.4;
    let row = |(number, length): (u32, f64)| {
        format!("T{number} P{number} Z{:+.7} D{diameter:+.12}\n", (length + off_mm) / 25.4)
    };
    write("tool.tbl", &lengths(original).into_iter().map(row).collect::<String>());
    write("params.var", "");
    write("program.ngc", program);
    let output = Command::new("rs274")
        .current_dir(folder.path())
        // It keeps the tool table in a file of the home folder, which parallel runs would share.
        .env("HOME", folder.path())
        .args(["-g", "-t", "tool.tbl", "-v", "params.var", "program.ngc"])
        .output()
        .expect("rs274 runs");
    let (calls, errors) = (String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
    if output.status.success() { Ok(calls.into_owned()) } else { Err(errors.trim().to_owned()) }
}

/// The motions among the canonical calls.
///
/// # Panics
/// At a call with a wrong number of arguments, or with an unknown plane.
#[must_use]
pub fn motions(calls: &str) -> Vec<Motion> {
    let mut plane = WorkPlane::Xy;
    let mut motions = Vec::new();
    for line in calls.lines() {
        // `621 N..... RIGID_TAP(-27.1290, 30.3250, -10.0000)`
        let Some((name, arguments)) = line.split_once('(') else { continue };
        let name = name.split_whitespace().last().unwrap_or_default();
        let arguments = arguments.trim_end().trim_end_matches(')');
        match name {
            "SELECT_PLANE" => plane = plane_of(arguments),
            "STRAIGHT_TRAVERSE" => motions.push(Motion::Traverse(numbers(line, arguments))),
            "STRAIGHT_FEED" => motions.push(Motion::Feed(numbers(line, arguments))),
            "RIGID_TAP" => motions.push(Motion::Tap(numbers(line, arguments))),
            "ARC_FEED" => motions.push(Motion::Arc(arc(plane, numbers(line, arguments)))),
            _ => {}
        }
    }
    motions
}

fn plane_of(name: &str) -> WorkPlane {
    match name {
        "CANON_PLANE_XY" => WorkPlane::Xy,
        "CANON_PLANE_XZ" => WorkPlane::Zx,
        "CANON_PLANE_YZ" => WorkPlane::Yz,
        other => panic!("expected the plane XY, XZ or YZ, found {other}"),
    }
}

/// `ARC_FEED(first end, second end, first centre, second centre, turns, end along the normal, a, b, c)`.
fn arc(plane: WorkPlane, [first, second, u, v, turns, normal, a, b, c]: [f64; 9]) -> CanonArc {
    let mut end = [0.0, 0.0, 0.0, a, b, c];
    for (axis, value) in plane.axes().into_iter().zip([first, second, normal]) {
        end[axis] = value;
    }
    CanonArc { plane, end, centre: [u, v], turns: turns as i32 }
}

fn numbers<const N: usize>(line: &str, arguments: &str) -> [f64; N] {
    let numbers: Vec<f64> = arguments.split(',').filter_map(|number| number.trim().parse().ok()).collect();
    numbers.try_into().unwrap_or_else(|found: Vec<f64>| panic!("expected {N} numbers, found {}: {line}", found.len()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn calls_become_motions_in_the_plane_in_force() {
        let calls = "  4 N..... SELECT_PLANE(CANON_PLANE_XZ)\n  5 N..... SET_FEED_RATE(20.0000)\n  \
             6 N3     ARC_FEED(1.0000, 2.0000, 3.0000, 4.0000, -2, 5.0000, 6.0000, 7.0000, 8.0000)\n  \
             7 N..... STRAIGHT_FEED(1.0000, -2.0000, 3.0000, 4.0000, 5.0000, 6.0000)\n";
        let arc = CanonArc { plane: WorkPlane::Zx, end: [2.0, 5.0, 1.0, 6.0, 7.0, 8.0], centre: [3.0, 4.0], turns: -2 };
        assert_eq!(motions(calls), [Motion::Arc(arc), Motion::Feed([1.0, -2.0, 3.0, 4.0, 5.0, 6.0])]);
    }

    #[test]
    fn a_tool_has_the_length_of_its_guard() {
        let guard = "o1 if [[ABS[#5403 - 87.5] GT 0.01] AND [ABS[[#5403 * 25.4] - 87.5] GT 0.01]]";
        let program = &format!("T4 M6\n{guard}\nG43 H9\nT5 M6\n");
        assert_eq!(lengths(program), BTreeMap::from([(4, 87.5), (5, DEFAULT_LENGTH), (9, DEFAULT_LENGTH)]));
    }
}
