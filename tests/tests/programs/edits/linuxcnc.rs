//! Edits of programs for LinuxCNC, judged by its own interpreter.
//!
//! The canonical calls of both programs are compared: motions with the state in which they are made. An edit that the
//! interpreter refuses, or that changes a motion, has to be found by the check; one that leaves every call as it was
//! must not be. The foreign interpreter must not call harmless what changes a motion.

use std::collections::BTreeMap;
use std::path::Path;

use tests::edits::{Allowed, Edit, Posted, Verdict, edit, verdict};
use tests::environment;
use tests::foreign::{Control, run};
use tests::linuxcnc::installed;
use tests::linuxcnc::interpreter::{PRINTED, interpret, interpret_edited};
use tests::random::Random;

use super::corpus::programs;
use super::{EDITS, chosen, is_displayed, is_matter_of_taste, places, shown};

/// A motion, a wait or a stop with the state in which it is made.
#[derive(Debug, Clone, PartialEq)]
struct Action {
    name: String,
    numbers: Vec<f64>,
    /// Calls that set the state, by their kind.
    state: BTreeMap<&'static str, String>,
}

/// Kinds of state; those that are compared in cuts only are marked.
const STATES: &[(&str, &str, bool)] = &[
    ("SET_FEED_RATE", "feed", true),
    ("SET_FEED_MODE", "feed mode", true),
    ("START_SPINDLE", "spindle", true),
    ("STOP_SPINDLE", "spindle", true),
    ("SET_SPINDLE_SPEED", "speed", true),
    ("FLOOD", "flood", true),
    ("MIST", "mist", true),
    ("SET_MOTION_CONTROL_MODE", "path mode", true),
    ("CHANGE_TOOL(", "tool", true),
    ("USE_TOOL_LENGTH_OFFSET", "length", false),
    ("SET_G5X_OFFSET", "work offset", false),
    ("SET_G92_OFFSET", "G92", false),
    ("SET_XY_ROTATION", "rotation", false),
    ("USE_LENGTH_UNITS", "unit", false),
];

const ACTIONS: &[&str] = &[
    "STRAIGHT_TRAVERSE",
    "STRAIGHT_FEED",
    "ARC_FEED",
    "RIGID_TAP",
    "DWELL",
    "PROGRAM_STOP",
    "OPTIONAL_PROGRAM_STOP",
    "PROGRAM_END",
    "CHANGE_TOOL",
];

/// Calls without their line numbers, comments left out.
fn calls(text: &str) -> Vec<&str> {
    text.lines()
        .filter_map(|line| {
            let start = line.find('(')?;
            let name = line[..start].rfind(' ').map_or(0, |place| place + 1);
            Some(&line[name..])
        })
        .filter(|call| !call.starts_with("COMMENT") && !call.starts_with("MESSAGE"))
        .collect()
}

fn actions(calls: &[&str]) -> Vec<Action> {
    let mut state = BTreeMap::new();
    let mut actions: Vec<Action> = Vec::new();
    let mut position: Vec<f64> = Vec::new();
    let (mut plane, mut length) = ([0, 1, 2], 0.0);
    for call in calls {
        if let Some((_, kind, _)) = STATES.iter().find(|(start, ..)| call.starts_with(start)) {
            state.insert(*kind, (*call).to_owned());
        }
        let Some((name, arguments)) = call.split_once('(') else { continue };
        if name == "USE_TOOL_LENGTH_OFFSET" {
            // The place where the axes are has other coordinates.
            let mut numbers = arguments.split([' ', ',', ')']).filter_map(|number| number.parse::<f64>().ok());
            let now = numbers.nth(2).unwrap_or(0.0);
            position.get_mut(2).into_iter().for_each(|z| *z += length - now);
            length = now;
        }
        if name == "SELECT_PLANE" {
            plane = match arguments {
                "CANON_PLANE_XZ)" => [2, 0, 1],
                "CANON_PLANE_YZ)" => [1, 2, 0],
                _ => [0, 1, 2],
            };
        }
        if !ACTIONS.contains(&name) {
            continue;
        }
        let numbers = arguments.trim_end_matches(')').split(',').filter_map(|number| number.trim().parse().ok());
        let numbers: Vec<f64> = numbers.collect();
        let end = match numbers[..] {
            [first, second, _, _, _, along, a, b, c] => {
                let mut end = vec![0.0, 0.0, 0.0, a, b, c];
                plane.into_iter().zip([first, second, along]).for_each(|(axis, value)| end[axis] = value);
                end
            }
            [_, _, _, _, _, _] => numbers.clone(),
            _ => position.clone(),
        };
        // A motion to the place where the axes are.
        let stays =
            end.len() == position.len() && end.iter().zip(&position).all(|(end, was)| (end - was).abs() <= PRINTED);
        if !(name.starts_with("STRAIGHT") && stays) {
            actions.push(Action { name: name.to_owned(), numbers, state: state.clone() });
        }
        position = end;
    }
    actions
}

/// First difference between the actions of two programs that is more than rounding.
fn difference(was: &[Action], is: &[Action], allowed: Allowed) -> Option<String> {
    for (was, is) in was.iter().zip(is) {
        if was.name != is.name {
            return Some(format!("{} became {}", was.name, is.name));
        }
        let far = |(index, (one, other)): (usize, (&f64, &f64))| {
            let largest = if was.numbers.len() == 6 && index > 2 { allowed.rotary_deg } else { allowed.linear };
            (one - other).abs() > largest + 2.0 * PRINTED
        };
        if was.numbers.len() != is.numbers.len() || was.numbers.iter().zip(&is.numbers).enumerate().any(far) {
            return Some(format!("{} {:?} became {:?}", was.name, was.numbers, is.numbers));
        }
        let cuts = matches!(&*was.name, "STRAIGHT_FEED" | "ARC_FEED" | "RIGID_TAP");
        let moves = cuts || was.name == "STRAIGHT_TRAVERSE";
        for (_, kind, in_cuts) in STATES {
            // A thread follows the spindle.
            if *kind == "feed" && was.name == "RIGID_TAP" {
                continue;
            }
            if (cuts || moves && !in_cuts) && was.state.get(kind) != is.state.get(kind) && !nearly(was, is, kind) {
                return Some(format!("{kind} {:?} became {:?}", was.state.get(kind), is.state.get(kind)));
            }
        }
    }
    (was.len() != is.len()).then(|| format!("{} actions became {}", was.len(), is.len()))
}

/// Whether the canonical calls of two programs make the same motions in the same states.
pub(super) fn same_calls(was: &str, is: &str, allowed: Allowed) -> Result<(), String> {
    let [was, is] = [was, is].map(calls);
    difference(&actions(&was), &actions(&is), allowed).map_or(Ok(()), Err)
}

/// Whether an F or an S differs by no more than 1 %.
fn nearly(was: &Action, is: &Action, kind: &str) -> bool {
    let number = |action: &Action| -> Option<f64> {
        action.state.get(kind)?.trim_end_matches(')').rsplit(['(', ',']).next()?.trim().parse().ok()
    };
    kind == "feed" && number(was).zip(number(is)).is_some_and(|(was, is)| (was - is).abs() <= 0.0101 * was + PRINTED)
}

/// What is wrong with the judgement of an edit; `None` if nothing is, or nothing can be said.
fn wrong(posted: &Posted, edit: &Edit, original: &str) -> Option<String> {
    let subject = &posted.subject;
    let foreign = verdict(&subject.trace, &run(&edit.text, &subject.options), subject.allowed);
    let found = || posted.findings(&edit.text).first().cloned();
    let edited = match interpret_edited(&edit.text, &posted.text, 0.0) {
        Ok(edited) => edited,
        // The tool table holds the tools of the original, and codes of the shop are unknown.
        Err(errors) => {
            // A label of two statements stops the control before it begins.
            let unsure = ["ool", "Unknown m code", "duplicate O-word"].iter().any(|text| errors.contains(text));
            let refused =
                || format!("LinuxCNC refuses it, not found: {}", errors.lines().collect::<Vec<_>>().join("; "));
            return (!unsure && found().is_none()).then(refused);
        }
    };
    let [was, is] = [original, edited.as_str()].map(calls);
    if was == is {
        // The calls hold no guard that lets the program pass, every offset of the work and of the machine is zero, and
        // no block is skipped.
        let elsewhere = [&edit.before, &edit.after].iter().any(|text| text.to_lowercase().contains("g53"));
        let of_these =
            |why: &str| ["guard", "machine", "work offset", "may be skipped"].iter().any(|text| why.contains(text));
        let unseen = elsewhere || matches!(&foreign, Verdict::Harmful(why) if of_these(why));
        if matches!(foreign, Verdict::Harmful(_)) && !unseen {
            return Some(format!("the same for LinuxCNC, but {foreign:?}"));
        }
        // The interpreter opens a file for (PROBEOPEN ..) without a call.
        let opens = edit.after.contains("probeopen");
        // On Fanuc and Haas an alarm.
        let alarms = edit.after.contains("#3000=");
        let loose_end = edit.kind.contains("endif");
        let of_taste = is_matter_of_taste(posted, edit) || is_displayed(edit) || opens || alarms || loose_end;
        let decided = foreign == Verdict::Harmless && !of_taste;
        return found().filter(|_| decided).map(|finding| format!("the same for LinuxCNC, falsely found: {finding}"));
    }
    let difference = difference(&actions(&was), &actions(&is), subject.allowed)?;
    // Calls are in the unit that is in force.
    let units = ["G20", "G21"].iter().any(|unit| edit.after.contains(unit));
    match foreign {
        Verdict::Harmless if units => None,
        Verdict::Harmless => Some(format!("LinuxCNC does something else ({difference}), but {foreign:?}")),
        Verdict::Undecided(_) => None,
        _ => found().is_none().then(|| format!("LinuxCNC does something else, not found: {difference}")),
    }
}

#[test]
fn the_interpreter_of_linuxcnc_agrees_with_the_verdicts() {
    if !installed() {
        return;
    }
    let edits = environment::number("PP_EDITS").map_or(EDITS as u64, |edits| edits) / 15;
    let seed = environment::number("PP_EDITS_SEED").unwrap_or(1);
    let mut programs = programs(seed);
    programs.retain(|posted| posted.subject.options.control == Control::LinuxCnc && posted.subject.lines.len() < 600);
    let originals: Vec<Option<String>> = programs.iter().map(|posted| interpret(&posted.text, 0.0).ok()).collect();
    let mut number = 0;
    programs.retain(|_| {
        number += 1;
        originals[number - 1].is_some()
    });
    let originals: Vec<String> = originals.into_iter().flatten().collect();
    assert!(programs.len() > 30, "{} programs for LinuxCNC", programs.len());
    let places = places(&programs);
    let mut random = Random::new(seed);
    let mut failures = Vec::new();
    for _ in 0..edits {
        let (posted, edit) = chosen(&programs, &places, "linuxcnc", &mut random, edit);
        let number = programs.iter().position(|other| std::ptr::eq(other, posted)).expect("a program");
        if let Some(why) = wrong(posted, &edit, &originals[number]) {
            if let Ok(path) = std::env::var("PP_EDITS_REPORT") {
                let folder = format!("{path}.linuxcnc/{}", failures.len());
                posted.write(Path::new(&folder), &edit.text).expect("the files can be written");
            }
            failures.push(shown(posted, &edit, &why, ""));
        }
    }
    assert!(failures.is_empty(), "{} of {edits} edits:\n{}", failures.len(), failures.join("\n"));
}
