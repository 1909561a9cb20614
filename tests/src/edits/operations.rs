//! Edits: insertions, deletions, exchanges and changes of numbers and codes.

use crate::foreign::Control;
use crate::random::Random;

use super::places::Subject;
use super::rows::{groups, rows};

/// An edited program.
#[derive(Debug, Clone)]
pub struct Edit {
    /// Kind of the edit, with the code or the letter that it concerns.
    pub kind: String,
    /// State class of the line.
    pub class: String,
    /// Number of the first line concerned, from 1.
    pub line: usize,
    /// Lines before the edit.
    pub before: String,
    /// Lines after the edit.
    pub after: String,
    /// Text of the whole program after the edit.
    pub text: String,
}

/// Lines `from..to` become others.
struct Change {
    kind: String,
    from: usize,
    to: usize,
    lines: Vec<String>,
}

/// Operations, each as probable as any other.
type Operation = fn(&Subject, usize, &mut Random) -> Option<Change>;

const OPERATIONS: &[Operation] = &[
    insert_row,
    insert_row,
    insert_row,
    insert_into_block,
    insert_into_block,
    append_word,
    append_word,
    open_and_close,
    open_and_close,
    insert_copy,
    insert_copied_word,
    delete_line,
    delete_line,
    delete_word,
    delete_word,
    swap_lines,
    move_line,
    swap_words,
    move_word,
    change_number,
    change_number,
    change_number,
    change_code,
    change_code,
    duplicate_line,
    skip_or_comment_out,
    split_block,
    join_lines,
];

/// Operations that leave every line as it is, and change their order: one line moves, two change places, one comes
/// twice.
const PERMUTATIONS: &[Operation] = &[move_line, move_line, swap_lines, swap_lines, duplicate_line];

/// Largest number of lines by which a line moves.
const FARTHEST: usize = 20;

/// An edit at a line, by a random operation; `None` if the operation does not suit the line.
#[must_use]
pub fn edit(subject: &Subject, index: usize, random: &mut Random) -> Option<Edit> {
    by_one_of(OPERATIONS, subject, index, random)
}

/// An edit at a line that changes the order of lines alone.
#[must_use]
pub fn permutation(subject: &Subject, index: usize, random: &mut Random) -> Option<Edit> {
    by_one_of(PERMUTATIONS, subject, index, random)
}

fn by_one_of(operations: &[Operation], subject: &Subject, index: usize, random: &mut Random) -> Option<Edit> {
    let operation = operations[random.below(operations.len())];
    let change = operation(subject, index, random)?;
    made(subject, index, &change.kind, change.from, change.to, &change.lines)
}

/// An edit that replaces lines `from..to`, from 0; `None` if nothing changes.
#[must_use]
pub fn made(subject: &Subject, index: usize, kind: &str, from: usize, to: usize, changed: &[String]) -> Option<Edit> {
    // Nothing after the end code is executed.
    if subject.lines[from..to] == *changed || to > subject.end + 1 {
        return None;
    }
    let lines: Vec<String> = subject.lines[..from].iter().chain(changed).chain(&subject.lines[to..]).cloned().collect();
    // With the neighbours, as a reader needs them.
    let shown = |lines: &[String]| lines.join(" | ");
    Some(Edit {
        kind: kind.to_owned(),
        class: subject.classes.get(&index).cloned().unwrap_or_default(),
        line: from + 1,
        before: shown(&subject.lines[from..to]),
        after: shown(changed),
        text: subject.text(&lines),
    })
}

fn is_comment(text: &str) -> bool {
    text.starts_with(['(', ';', '*']) || text.starts_with("MSG(")
}

/// Words of a line, with a comment at its end as one word.
fn words(text: &str) -> Vec<String> {
    let (block, comment) = match text.find([';', '(']) {
        Some(place) if text[place..].starts_with(';') || text[..place].ends_with(' ') => text.split_at(place),
        _ => (text, ""),
    };
    let mut words: Vec<String> = block.split(' ').filter(|word| !word.is_empty()).map(str::to_owned).collect();
    if !comment.is_empty() {
        words.push(comment.to_owned());
    }
    words
}

fn joined(line: &str, words: &[String]) -> String {
    let indent = if line.starts_with("  ") { "  " } else { "" };
    format!("{indent}{}", words.join(" "))
}

/// Letter or code of a word, for the kind of an edit.
fn head(word: &str) -> String {
    let letters: String = word.chars().take_while(char::is_ascii_alphabetic).collect();
    if matches!(&*letters, "G" | "M" | "Q") || letters.is_empty() {
        return word.split(['=', '(']).next().unwrap_or_default().to_owned();
    }
    letters
}

fn heads(line: &str) -> String {
    let words = words(line);
    let first: Vec<String> = words.iter().take(3).map(|word| head(word)).collect();
    first.join(" ")
}

fn some<'a, T>(all: &'a [T], random: &mut Random) -> Option<&'a T> {
    (!all.is_empty()).then(|| &all[random.below(all.len())])
}

fn insert_row(subject: &Subject, index: usize, random: &mut Random) -> Option<Change> {
    let rows = rows(subject.options.control);
    let row = *some(&rows, random)?;
    let at = (index + random.below(2)).min(subject.end);
    let lines = row.split('\n').map(str::to_owned).collect();
    Some(Change { kind: format!("insert line {row}"), from: at, to: at, lines })
}

fn insert_into_block(subject: &Subject, index: usize, random: &mut Random) -> Option<Change> {
    let line = &subject.lines[index];
    let rows = rows(subject.options.control);
    let row = *some(&rows, random)?;
    if row.contains('\n') || is_comment(line) {
        return None;
    }
    let mut words = words(line);
    let at = match random.below(3) {
        0 => 0,
        1 => words.len(),
        _ => random.below(words.len() + 1),
    };
    words.insert(at, row.to_owned());
    Some(Change { kind: format!("insert words {row}"), from: index, to: index + 1, lines: vec![joined(line, &words)] })
}

/// A word of the control's alphabet at the end of a block: what a block does with it, comes after all else that it
/// does.
fn append_word(subject: &Subject, index: usize, random: &mut Random) -> Option<Change> {
    let line = &subject.lines[index];
    let alphabet: Vec<&str> =
        rows(subject.options.control).into_iter().filter(|row| !row.contains([' ', '\n'])).collect();
    let word = *some(&alphabet, random)?;
    if is_comment(line) {
        return None;
    }
    let mut words = words(line);
    let is_remark = words.last().is_some_and(|last| last.starts_with([';', '(']) && words.len() > 1);
    words.insert(words.len() - usize::from(is_remark), word.to_owned());
    let lines = vec![joined(line, &words)];
    Some(Change { kind: format!("append {word}"), from: index, to: index + 1, lines })
}

/// Two codes of a group, one here and the other some lines later, each on a line of its own or at the end of a block:
/// what the first opens the second closes.
fn open_and_close(subject: &Subject, index: usize, random: &mut Random) -> Option<Change> {
    let group = *some(groups(subject.options.control), random)?;
    let (opens, closes) = (*some(group, random)?, *some(group, random)?);
    let to = index + 1 + random.below(8);
    let mut lines = subject.lines.get(index..to)?.to_vec();
    let apart = random.chance(0.7);
    if opens == closes || !apart && (is_comment(&lines[0]) || is_comment(&lines[lines.len() - 1])) {
        return None;
    }
    if apart {
        lines.insert(0, opens.to_owned());
        lines.push(closes.to_owned());
    } else {
        let last = lines.len() - 1;
        lines[last] = format!("{} {closes}", lines[last]);
        lines[0] = format!("{} {opens}", lines[0]);
    }
    Some(Change { kind: format!("open {opens} and close {closes}"), from: index, to, lines })
}

/// A line of the program again at another place.
fn insert_copy(subject: &Subject, index: usize, random: &mut Random) -> Option<Change> {
    let lines: Vec<usize> = subject.classes.keys().copied().collect();
    let copied = &subject.lines[*some(&lines, random)?];
    let at = (index + random.below(2)).min(subject.end);
    let kind = format!("insert copied {}", heads(copied));
    (!is_comment(copied)).then(|| Change { kind, from: at, to: at, lines: vec![copied.clone()] })
}

fn insert_copied_word(subject: &Subject, index: usize, random: &mut Random) -> Option<Change> {
    let line = &subject.lines[index];
    let lines: Vec<usize> = subject.classes.keys().copied().collect();
    let copied = words(&subject.lines[*some(&lines, random)?]);
    let word = some(&copied, random)?.clone();
    if is_comment(line) || is_comment(&word) {
        return None;
    }
    let mut words = words(line);
    let at = random.below(words.len() + 1);
    let kind = format!("insert copied word {}", head(&word));
    words.insert(at, word);
    Some(Change { kind, from: index, to: index + 1, lines: vec![joined(line, &words)] })
}

fn delete_line(subject: &Subject, index: usize, _: &mut Random) -> Option<Change> {
    let kind = format!("delete line {}", heads(&subject.lines[index]));
    Some(Change { kind, from: index, to: index + 1, lines: Vec::new() })
}

fn delete_word(subject: &Subject, index: usize, random: &mut Random) -> Option<Change> {
    let line = &subject.lines[index];
    let mut words = words(line);
    if is_comment(line) || words.len() < 2 {
        return None;
    }
    let word = words.remove(random.below(words.len()));
    let kind = format!("delete word {}", head(&word));
    Some(Change { kind, from: index, to: index + 1, lines: vec![joined(line, &words)] })
}

/// A line and another below it change places; half of them are neighbours.
fn swap_lines(subject: &Subject, index: usize, random: &mut Random) -> Option<Change> {
    let far = if random.chance(0.5) { 1 } else { 1 + random.below(FARTHEST) };
    let mut lines = subject.lines.get(index..=index + far)?.to_vec();
    let kind = format!("swap {} and {}", heads(&lines[0]), heads(&lines[far]));
    lines.swap(0, far);
    Some(Change { kind, from: index, to: index + far + 1, lines })
}

fn move_line(subject: &Subject, index: usize, random: &mut Random) -> Option<Change> {
    let farthest = if random.chance(0.5) { 6 } else { FARTHEST };
    let far = 1 + random.below(farthest);
    let down = random.chance(0.5);
    let (from, to) = if down { (index, index + far + 1) } else { (index.checked_sub(far)?, index + 1) };
    let mut lines = subject.lines.get(from..to)?.to_vec();
    let moved = lines.remove(if down { 0 } else { far });
    let kind = format!("move {}", heads(&moved));
    lines.insert(if down { far } else { 0 }, moved);
    Some(Change { kind, from, to, lines })
}

fn swap_words(subject: &Subject, index: usize, random: &mut Random) -> Option<Change> {
    let line = &subject.lines[index];
    let mut words = words(line);
    if is_comment(line) || words.len() < 2 {
        return None;
    }
    let at = random.below(words.len() - 1);
    let kind = format!("swap words {} {}", head(&words[at]), head(&words[at + 1]));
    words.swap(at, at + 1);
    Some(Change { kind, from: index, to: index + 1, lines: vec![joined(line, &words)] })
}

/// A word goes to the next or to the previous line.
fn move_word(subject: &Subject, index: usize, random: &mut Random) -> Option<Change> {
    let from = if random.chance(0.5) { index } else { index.checked_sub(1)? };
    let [one, other] = subject.lines.get(from..from + 2)? else { return None };
    if is_comment(one) || is_comment(other) {
        return None;
    }
    let (mut first, mut second) = (words(one), words(other));
    let (source, target) = if from == index { (&mut first, &mut second) } else { (&mut second, &mut first) };
    let word = source.remove(random.below(source.len()));
    let kind = format!("move word {}", head(&word));
    target.insert(random.below(target.len() + 1), word);
    let lines = [(one, first), (other, second)];
    let lines = lines.into_iter().filter(|(_, words)| !words.is_empty());
    Some(Change { kind, from, to: from + 2, lines: lines.map(|(line, words)| joined(line, &words)).collect() })
}

/// Places of the numbers of a text.
fn numbers(text: &str) -> Vec<(usize, usize)> {
    let bytes = text.as_bytes();
    let mut numbers = Vec::new();
    let mut place = 0;
    while place < bytes.len() {
        let digit = |at: usize| bytes.get(at).is_some_and(|byte| byte.is_ascii_digit() || *byte == b'.');
        if !digit(place) {
            place += 1;
            continue;
        }
        let start = if place > 0 && matches!(bytes[place - 1], b'-' | b'+') { place - 1 } else { place };
        while digit(place) {
            place += 1;
        }
        numbers.push((start, place));
    }
    numbers
}

fn change_number(subject: &Subject, index: usize, random: &mut Random) -> Option<Change> {
    let line = &subject.lines[index];
    if is_comment(line) {
        return None;
    }
    let code = line.split(" ;").next().unwrap_or_default();
    let (start, end) = *some(&numbers(code), random)?;
    let old = &line[start..end];
    let plus = subject.options.control == Control::Heidenhain && old.starts_with(['+', '-']);
    let (name, new) = changed_number(old, plus, random)?;
    let word = line[..start].rsplit([' ', ',', '(', '[']).next().unwrap_or_default();
    let word = if matches!(word, "G" | "M") { format!("{word}{old}") } else { word.to_owned() };
    let lines = vec![format!("{}{new}{}", &line[..start], &line[end..])];
    Some(Change { kind: format!("number of {word} {name}"), from: index, to: index + 1, lines })
}

/// A number with another sign, digit or point, ten times larger, or a little larger.
fn changed_number(old: &str, plus: bool, random: &mut Random) -> Option<(&'static str, String)> {
    let value: f64 = old.trim_start_matches('+').parse().ok()?;
    let decimals = old.split_once('.').map_or(0, |(_, fraction)| fraction.len());
    let point = old.contains('.');
    let written = |value: f64, decimals: usize| {
        let mut text = format!("{value:.decimals$}");
        if point && !text.contains('.') {
            text.push('.');
        }
        if plus && !text.starts_with('-') {
            text.insert(0, '+');
        }
        text
    };
    let unit = 10_f64.powi(-(decimals as i32));
    Some(match random.below(9) {
        0 => ("sign", written(-value, decimals)),
        1 => {
            let digits: Vec<usize> =
                old.bytes().enumerate().filter(|(_, byte)| byte.is_ascii_digit()).map(|(place, _)| place).collect();
            let place = *some(&digits, random)?;
            let mut bytes = old.as_bytes().to_vec();
            bytes[place] = b'0' + random.below(10) as u8;
            ("digit", String::from_utf8(bytes).ok()?)
        }
        2 if point => ("without point", old.replace('.', "")),
        2 | 3 => ("tenfold", written(value * 10.0, decimals)),
        4 => ("tenth", written(value / 10.0, decimals + 1)),
        5 => ("by a unit", written(value + unit * random.sign(), decimals)),
        6 => ("by 1 %", written(value * (1.0 + 0.01 * random.sign()), decimals.max(3))),
        7 => ("by 2 %", written(value * (1.0 + 0.02 * random.sign()), decimals.max(3))),
        _ => ("zero", written(0.0, 0)),
    })
}

fn change_code(subject: &Subject, index: usize, random: &mut Random) -> Option<Change> {
    let line = &subject.lines[index];
    let mut words = words(line);
    let control = subject.options.control;
    let bare = |word: &str| match word.strip_prefix(['G', 'M']).and_then(|code| code.strip_prefix('0')) {
        Some(code) if !code.is_empty() => format!("{}{code}", &word[..1]),
        _ => word.to_owned(),
    };
    let group = |word: &str| groups(control).iter().find(|group| group.contains(&bare(word).as_str()));
    let codes: Vec<usize> = (0..words.len()).filter(|&place| group(&words[place]).is_some()).collect();
    let place = *some(&codes, random)?;
    let new = *some(group(&words[place])?, random)?;
    let kind = format!("code {} to {new}", bare(&words[place]));
    words[place] = new.to_owned();
    (!is_comment(line)).then(|| Change { kind, from: index, to: index + 1, lines: vec![joined(line, &words)] })
}

fn duplicate_line(subject: &Subject, index: usize, _: &mut Random) -> Option<Change> {
    let line = &subject.lines[index];
    Some(Change { kind: format!("duplicate {}", heads(line)), from: index, to: index, lines: vec![line.clone()] })
}

fn skip_or_comment_out(subject: &Subject, index: usize, random: &mut Random) -> Option<Change> {
    let line = &subject.lines[index];
    let comment = match subject.options.control {
        Control::Siemens | Control::Heidenhain => format!("; {line}"),
        _ => format!("({line})"),
    };
    let (name, new) = match random.below(4) {
        0 => ("skip", format!("/{line}")),
        1 => ("semicolon before", format!(";{line}")),
        2 => ("comment at the end", format!("{line} (X)")),
        _ => ("comment out", comment),
    };
    let kind = format!("{name} {}", heads(line));
    Some(Change { kind, from: index, to: index + 1, lines: vec![new] })
}

/// One block becomes two.
fn split_block(subject: &Subject, index: usize, random: &mut Random) -> Option<Change> {
    let line = &subject.lines[index];
    let words = words(line);
    if is_comment(line) || words.len() < 2 {
        return None;
    }
    let at = 1 + random.below(words.len() - 1);
    let lines = vec![joined(line, &words[..at]), joined(line, &words[at..])];
    Some(Change { kind: format!("split before {}", head(&words[at])), from: index, to: index + 1, lines })
}

/// Two blocks become one.
fn join_lines(subject: &Subject, index: usize, _: &mut Random) -> Option<Change> {
    let [one, other] = subject.lines.get(index..index + 2)? else { return None };
    if is_comment(one) || is_comment(other) {
        return None;
    }
    let kind = format!("join {} and {}", heads(one), heads(other));
    Some(Change { kind, from: index, to: index + 2, lines: vec![format!("{one} {other}")] })
}
