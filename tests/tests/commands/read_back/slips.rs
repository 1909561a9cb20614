//! Programs with one error each, which must be found.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::PathBuf;

use machines::{LolaXoyzba, SpinnerU5620};
use pp_runtime::kinematics::Machine;

use super::given::{PADS, PLAIN, SetUp, data};
use super::{check, posted_and_checked};

/// A word with `change` added to its number.
fn shifted(word: &str, change: f64) -> String {
    let (letter, number) = word.split_at(1);
    let value: f64 = number.parse().expect("a number");
    format!("{letter}{}", ((value + change) * 1e4).round() / 1e4 + 0.0)
}

/// Copies of a program with one error each: a changed number or a missing line.
fn slips(text: &str) -> Vec<String> {
    let lines: Vec<&str> = text.lines().collect();
    let mut slips = Vec::new();
    // The length guard moves nothing.
    for (index, line) in lines.iter().enumerate().filter(|(_, line)| !line.starts_with(['(', 'o'])) {
        let mut with = |line: Option<String>| {
            let all = lines.iter().enumerate();
            let all = all.filter_map(|(at, old)| if at == index { line.clone() } else { Some((*old).to_owned()) });
            slips.push(all.map(|line| line + "\n").collect::<String>());
        };
        let words: Vec<&str> = line.split(' ').collect();
        let cut = !words.contains(&"G0") && line.contains(" F");
        let rotates = words.iter().any(|word| word.starts_with(['A', 'B', 'C']));
        for (at, word) in words.iter().enumerate() {
            let change = match word.as_bytes()[0] {
                // An inserted point may be a unit off its line, a cut may not.
                b'X' | b'Y' | b'Z' => Some(if cut { 0.001 } else { 0.003 }),
                b'A' | b'B' | b'C' => Some(0.01),
                // A bound of the speed of the tip may be above its largest speed by a little.
                b'F' if rotates => Some(1e-3 * word[1..].parse::<f64>().expect("a number") + 0.002),
                b'F' => Some(0.002),
                _ => None,
            };
            if let Some(change) = change {
                let mut words: Vec<String> = words.iter().map(|word| (*word).to_owned()).collect();
                words[at] = shifted(word, change);
                with(Some(words.join(" ")));
            }
        }
        // Blocks that change no motion may be missing.
        if !["M9", "M5", "M8", "G94", "M0", "M1", "G4 P2.5"].contains(line) && *line != "G53 G0 Z0" {
            with(None);
        }
    }
    slips
}

fn every_slip_is_found<M: Machine>(name: &str, path: &PathBuf, set_up: &SetUp) {
    let (text, cl) = posted_and_checked::<M>(name, path, set_up);
    let slips = slips(&text);
    assert!(slips.len() > 50, "{} slips", slips.len());
    for slip in slips {
        let missed = catch_unwind(AssertUnwindSafe(|| check::<M>(&slip, path, &cl, set_up))).is_ok();
        if missed {
            let (line, (was, is)) =
                text.lines().zip(slip.lines()).enumerate().find(|(_, (was, is))| was != is).expect("a slip");
            panic!("line {}: `{was}` became `{is}`, which was not found", line + 1);
        }
    }
}

#[test]
fn every_wrong_digit_and_every_missing_block_is_found() {
    let coarse = |set_up: SetUp| SetUp { coarse: true, ..set_up };
    every_slip_is_found::<SpinnerU5620>("spinner-u5-620", &data("blade/blade.cls"), &coarse(PLAIN));
    every_slip_is_found::<LolaXoyzba>("lola-xoyzba", &data("pads/pads.cls"), &coarse(PADS));
}
