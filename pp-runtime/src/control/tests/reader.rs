//! Small reader of programs: returns the motions of a program of any control.

use std::collections::BTreeMap;

/// Centre of an arc, and whether it is clockwise.
type Round = (BTreeMap<String, i64>, bool);

/// Motion of a block: whether it is a rapid and in machine coordinates, position of every axis after it, feed (inverse
/// time, F), and circle.
pub(super) type Motion = (bool, bool, BTreeMap<String, f64>, Option<(bool, f64)>, Option<Round>);

fn number(word: &str, start: usize) -> f64 {
    word[start..].parse().expect("a number")
}

/// Rotates X and Y about a pole by an angle in degrees; rounded to a thousandth.
fn turn_about(pole: &BTreeMap<String, i64>, degrees: f64, at: &mut BTreeMap<String, f64>) {
    let [x, y] = ["X", "Y"].map(|axis| at[axis] - pole[axis] as f64 * 1e-3);
    let (sine, cosine) = degrees.to_radians().sin_cos();
    for (axis, value) in [("X", x * cosine - y * sine), ("Y", x * sine + y * cosine)] {
        at.insert(axis.to_owned(), (value * 1e3 + pole[axis] as f64).round() * 1e-3);
    }
}

/// Motions of a program of any control; words are modal.
pub(super) fn motions(lines: &[String]) -> Vec<Motion> {
    let (mut at, mut feed, mut rapid, mut inverse) = (BTreeMap::<String, f64>::new(), None, false, false);
    let (mut clockwise, mut pole) = (None, BTreeMap::<String, i64>::new());
    let mut read = Vec::new();
    for line in lines {
        let mut line = line.as_str();
        if let Some((number, rest)) = line.split_once(' ')
            && number.trim_start_matches('N').parse::<u32>().is_ok()
        {
            line = rest;
        }
        if line.starts_with(['(', ';', '%', 'O', '*', 'M', ' ']) || line.contains("CYCL") || line.contains("TOOL") {
            continue;
        }
        if let Some(words) = line.strip_prefix("CC ") {
            let word =
                |word: &str| (word[..1].to_owned(), (word[1..].parse::<f64>().expect("a number") * 1e3).round() as i64);
            pole = words.split(' ').map(word).collect();
            continue;
        }
        let (mut machine, mut fast, mut moves) = (false, None, false);
        let (mut centre, before) = (BTreeMap::new(), at.clone());
        let mut word_feed = None;
        for word in line.split(' ') {
            match word {
                "G53" | "SUPA" | "M91" => machine = true,
                "G0" | "G00" => (rapid, clockwise) = (true, None),
                "G1" | "G01" => (rapid, clockwise) = (false, None),
                "G2" | "G02" => (rapid, clockwise) = (false, Some(true)),
                "G3" | "G03" => (rapid, clockwise) = (false, Some(false)),
                "FMAX" => fast = Some(true),
                "L" => (fast, clockwise) = (fast.or(Some(false)), None),
                "C" | "CP" => (fast, centre) = (Some(false), pole.clone()),
                _ if word.starts_with("IZ") => *at.get_mut("Z").expect("a height") += number(word, 2),
                _ if word.starts_with("IPA") => {
                    moves = true;
                    turn_about(&pole, number(word, 3), &mut at);
                }
                "DR+" => clockwise = Some(false),
                "DR-" => clockwise = Some(true),
                "G93" => inverse = true,
                "G94" => inverse = false,
                _ => {
                    let (name, number) = match word.split_once('=') {
                        Some((name, number)) => (name, number),
                        None => word.split_at(1),
                    };
                    let Ok(number) = number.parse::<f64>() else { continue };
                    match name.as_bytes()[0] {
                        b'X'..=b'Z' | b'A' | b'C' => {
                            moves = true;
                            at.insert(name.to_owned(), number);
                        }
                        b'F' => word_feed = Some(number),
                        letter @ b'I'..=b'K' if clockwise.is_some() => {
                            let axis = ["X", "Y", "Z"][usize::from(letter - b'I')];
                            let from = before.get(axis).copied().unwrap_or(f64::NAN);
                            centre.insert(axis.to_owned(), ((from + number) * 1e3).round() as i64);
                        }
                        _ => {}
                    }
                }
            }
        }
        rapid = fast.unwrap_or(rapid);
        feed = word_feed.or(feed);
        if moves {
            let feed = if rapid || machine { None } else { feed.map(|feed| (inverse, feed)) };
            let round = clockwise.filter(|_| !rapid && !machine).map(|clockwise| (centre, clockwise));
            read.push((rapid, machine, at.clone(), feed, round));
        }
    }
    read
}
