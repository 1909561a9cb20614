//! Lines of LinuxCNC, Fanuc and Haas: letters and numbers.

use super::super::Control;
use super::super::meaning::NumberCounting;
use super::{Content, Line, Mark, Number, Token, take_number};

const EMPTY: &str = "an empty line";

pub(super) fn line(control: Control, text: &str) -> Result<Line, String> {
    let content = |content| Ok(Line { number: None, content });
    let text = if control == Control::LinuxCnc { without_remark(text) } else { text };
    if let Some(inside) = text.strip_prefix('(')
        && let Some(comment) = inside.strip_suffix(')')
        && !comment.contains(['(', ')'])
    {
        return content(Content::Comment(comment.to_owned()));
    }
    // A comment that is skipped, and several comments.
    let rest = text.strip_prefix('/').unwrap_or(text);
    if rest.starts_with('(') && !rest.starts_with("(abort") && tokens(rest).is_err_and(|why| why == EMPTY) {
        return content(Content::Comment(rest.to_owned()));
    }
    let condition = match control {
        Control::LinuxCnc => text.starts_with(['o', 'O']),
        _ => text.starts_with("IF"),
    };
    if condition {
        return content(Content::Condition(text.to_owned()));
    }
    if control != Control::LinuxCnc {
        if text == "%" {
            return content(Content::Mark(Mark::Tape));
        }
        if let Some(name) = text.strip_prefix('O') {
            return match name.split_once(' ') {
                Some((digits, title)) if digits.parse::<u32>().is_ok() && is_comment(title) => {
                    content(Content::Mark(Mark::Name))
                }
                _ => Err("not a program number with its name".to_owned()),
            };
        }
    }
    let mut tokens = tokens(&text.to_ascii_uppercase())?;
    let number = take_number(&mut tokens)?;
    Ok(Line { number, content: Content::Block(tokens) })
}

/// LinuxCNC reads nothing after a semicolon outside of brackets.
fn without_remark(text: &str) -> &str {
    match end_of_block(text) {
        Some(end) if !text[..end].trim().is_empty() => text[..end].trim_end(),
        Some(_) => "()",
        None => text,
    }
}

/// Blocks of a line: a semicolon outside of brackets ends one. A line without a semicolon is one block.
pub(super) fn blocks(line: &str) -> Vec<&str> {
    let Some(end) = end_of_block(line) else { return vec![line] };
    let rest = line[end + 1..].trim_start();
    let mut blocks = if rest.is_empty() { Vec::new() } else { self::blocks(rest) };
    if !line[..end].trim().is_empty() {
        blocks.insert(0, line[..end].trim_end());
    }
    blocks
}

/// Place of the first semicolon outside of brackets.
fn end_of_block(text: &str) -> Option<usize> {
    let mut inside = false;
    for (place, letter) in text.char_indices() {
        match letter {
            '(' => inside = true,
            ')' => inside = false,
            ';' if !inside => return Some(place),
            _ => {}
        }
    }
    None
}

fn is_comment(text: &str) -> bool {
    text.strip_prefix('(').and_then(|text| text.strip_suffix(')')).is_some_and(|text| !text.contains(['(', ')']))
}

/// Letters and their numbers, with comments between them left out.
fn tokens(mut text: &str) -> Result<Vec<Token>, String> {
    let mut tokens = Vec::new();
    loop {
        text = text.trim_start();
        let Some(letter) = text.chars().next() else { break };
        if letter == '(' {
            let end = text.find(')').ok_or("a comment does not end")?;
            if text[1..end].contains('(') {
                return Err("a comment holds a bracket".to_owned());
            }
            text = &text[end + 1..];
            continue;
        }
        let word = Number::take(text[1..].trim_start()).filter(|_| letter.is_ascii_uppercase());
        let (number, rest) = word.ok_or_else(|| format!("`{text}` does not begin with a word"))?;
        tokens.push(Token::Word { name: letter.to_string(), number, counting: NumberCounting::AsInForce });
        text = rest;
    }
    if tokens.is_empty() { Err(EMPTY.to_owned()) } else { Ok(tokens) }
}
