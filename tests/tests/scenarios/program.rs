//! Lines of programs: compared with expected ones, and edited.

use imara_diff::{Algorithm, Diff, InternedInput};

/// Stands for any lines where it is a line, and for any text in a line.
const GAP: &str = "...";

/// Between a text and what replaces it.
const ARROW: &str = " =>";

/// Lines of a program without the numbers that a control gives to every line.
pub(crate) fn unnumbered(program: &str, numbered: bool) -> Vec<String> {
    let bare = |line: &str| {
        let (mark, line) = line.strip_prefix('/').map_or(("", line), |line| ("/", line));
        let digits = line.len() - line.trim_start_matches(|c: char| c.is_ascii_digit()).len();
        match line[digits..].strip_prefix(' ').filter(|_| digits > 0) {
            Some(text) => format!("{mark}{text}"),
            None => format!("{mark}{line}"),
        }
    };
    program.lines().map(|line| if numbered { bare(line) } else { line.to_owned() }).collect()
}

/// Whether a line is the expected one.
pub(crate) fn is_like(line: &str, expected: &str) -> bool {
    let (line, expected) = (line.trim(), expected.trim());
    if expected == GAP {
        return line == GAP;
    }
    let mut pieces = expected.split(GAP);
    let first = pieces.next().unwrap_or_default();
    let Some(mut rest) = line.strip_prefix(first) else { return false };
    let mut ends_with = first;
    for piece in pieces {
        ends_with = piece;
        let Some(at) = rest.find(piece) else { return false };
        rest = &rest[at + piece.len()..];
    }
    rest.is_empty() || expected.contains(GAP) && line.ends_with(ends_with)
}

/// Whether a text contains the expected one.
pub(crate) fn contains(text: &str, expected: &str) -> bool {
    is_like(text, &format!("{GAP}{}{GAP}", expected.trim()))
}

/// Difference between expected lines, marked `-`, and those found, marked `+`, with a line around.
pub(crate) fn difference(expected: &[String], found: &[String]) -> String {
    let whole = |lines: &[String]| lines.iter().map(|line| format!("{line}\n")).collect::<String>();
    let (before, after) = (whole(expected), whole(found));
    let input = InternedInput::new(&*before, &*after);
    let (mut text, mut shown) = (String::new(), 0);
    for hunk in Diff::compute(Algorithm::Histogram, &input).hunks() {
        let [before, after] = [&hunk.before, &hunk.after].map(|range| range.start as usize..range.end as usize);
        let around = |at: usize| expected.get(at).map(|line| format!("    {line}\n")).unwrap_or_default();
        if before.start > shown {
            text += &around(before.start - 1);
        }
        text.extend(expected[before.clone()].iter().map(|line| format!("  - {line}\n")));
        text.extend(found[after].iter().map(|line| format!("  + {line}\n")));
        text += &around(before.end);
        shown = before.end + 1;
    }
    text
}

/// The place of some lines without a gap, at or after a line.
fn place(lines: &[String], wanted: &[String], from: usize) -> Option<usize> {
    let fits = |at: &usize| wanted.iter().zip(&lines[*at..]).all(|(wanted, line)| is_like(line, wanted));
    (from..(lines.len() + 1).saturating_sub(wanted.len())).find(fits)
}

/// `None` if the expected lines are in the program; the difference where they are not, and the expected lines with
/// those of the program in their place if any of them is there.
pub(crate) fn excerpt(lines: &[String], expected: &[String]) -> Option<(String, Option<Vec<String>>)> {
    let mut from = 0;
    let parts: Vec<&[String]> = expected.split(|line| line.trim() == GAP).collect();
    for (index, part) in parts.iter().enumerate() {
        if let Some(at) = place(lines, part, from) {
            from = at + part.len();
            continue;
        }
        let near = nearest(&lines[from..], part);
        let mut all = parts.clone();
        all[index] = near;
        let is_near = near.iter().any(|line| part.iter().any(|wanted| is_like(line, wanted)));
        return Some((difference(part, near), is_near.then(|| all.join(&GAP.to_owned()))));
    }
    None
}

/// The lines that are most like the expected ones: from their first line to their last, where these are there.
fn nearest<'l>(lines: &'l [String], expected: &[String]) -> &'l [String] {
    let like = |line: &String, wanted: Option<&String>| wanted.is_some_and(|wanted| is_like(line, wanted));
    let score = |at: usize| {
        let window = &lines[at..(at + expected.len()).min(lines.len())];
        let anchored = usize::from(window.first().is_some_and(|line| like(line, expected.first())));
        2 * expected.iter().filter(|wanted| window.iter().any(|line| is_like(line, wanted))).count() + anchored
    };
    let Some(start) = (0..lines.len()).rev().max_by_key(|&at| score(at)) else { return lines };
    let least = (start + expected.len()).min(lines.len());
    let last = (start..lines.len().min(least + 20)).find(|&at| at > start && like(&lines[at], expected.last()));
    &lines[start..last.map_or(least, |last| last + 1)]
}

/// Lines of the program that are like one of these.
pub(crate) fn like_one_of(lines: &[String], expected: &[String]) -> Vec<String> {
    lines.iter().filter(|line| expected.iter().any(|wanted| is_like(line, wanted))).cloned().collect()
}

/// Edits of a block, separated by blank lines; a line with an arrow is one of its own.
pub(crate) fn edits(lines: &[String]) -> impl Iterator<Item = &[String]> {
    let edits = lines.split(|line| line.trim().is_empty()).filter(|edit| !edit.is_empty());
    edits.flat_map(|edit| edit.chunks(if edit.iter().all(|line| line.contains(ARROW)) { 1 } else { edit.len() }))
}

/// The program after an edit at each of its places in turn, without those that change nothing.
pub(crate) fn edited(lines: &[String], edit: &[String]) -> Vec<Vec<String>> {
    if let ([_], Some((was, is))) = (edit, edit[0].split_once(ARROW)) {
        return replaced(lines, was.trim(), is.trim());
    }
    let mut programs = Vec::new();
    for start in 0..lines.len() {
        if let Some(program) =
            changed(lines, edit, start).filter(|program| program != lines && !programs.contains(program))
        {
            programs.push(program);
        }
    }
    programs
}

/// The program after an edit whose first line is at `start`.
fn changed(lines: &[String], edit: &[String], start: usize) -> Option<Vec<String>> {
    let (mut program, mut at) = (lines[..start].to_vec(), start);
    for (index, part) in edit.split(|line| line.trim() == GAP).enumerate() {
        let old = part.iter().filter(|line| !line.starts_with("+ "));
        let old: Vec<String> = old.map(|line| line.strip_prefix("- ").unwrap_or(line).to_owned()).collect();
        let place = place(lines, &old, at)?;
        if index == 0 && (place != start || old.is_empty()) {
            return None;
        }
        program.extend_from_slice(&lines[at..place]);
        at = place;
        for line in part {
            match line.strip_prefix("+ ") {
                Some(new) => program.push(new.to_owned()),
                None => {
                    if !line.starts_with("- ") {
                        program.push(lines[at].clone());
                    }
                    at += 1;
                }
            }
        }
    }
    program.extend_from_slice(&lines[at..]);
    Some(program)
}

/// The program with a text replaced at each of its places outside comments in turn.
fn replaced(lines: &[String], was: &str, is: &str) -> Vec<Vec<String>> {
    let comment = ["(", ";", "*", "MSG("];
    let mut programs = Vec::new();
    for (index, line) in lines.iter().enumerate() {
        let in_comment = comment.iter().any(|mark| line.trim_start().starts_with(mark) && !was.starts_with(mark));
        for (at, _) in line.match_indices(was).filter(|(at, _)| !in_comment && is_word(line, *at, was)) {
            let mut program = lines.to_vec();
            program[index] = format!("{}{is}{}", &line[..at], &line[at + was.len()..]);
            programs.push(program);
        }
    }
    programs
}

/// Whether a text in a line ends and begins where words and numbers do: `X-40` is not in `X-400`, and `T1` not in
/// `GT1`.
fn is_word(line: &str, at: usize, text: &str) -> bool {
    let (before, after) = (&line[..at], &line[at + text.len()..]);
    let joins = |one: Option<char>, other: Option<char>| {
        one.zip(other).is_some_and(|(one, other)| one.is_ascii_alphanumeric() && other.is_ascii_alphanumeric())
    };
    // A point goes on with a number, unless it ends the number.
    let after = after.strip_prefix('.').filter(|rest| rest.starts_with(|c: char| c.is_ascii_digit())).unwrap_or(after);
    !joins(before.chars().next_back(), text.chars().next()) && !joins(text.chars().next_back(), after.chars().next())
}
