//! Lines of a Siemens 840D: words with and without `=`, names, calls with arguments.

use super::super::meaning::NumberCounting;
use super::{Content, Line, Mark, Number, Token, take_number};

pub(super) fn line(text: &str) -> Result<Line, String> {
    let content = |content| Ok(Line { number: None, content });
    let start = text.trim_start();
    if let Some(comment) = start.strip_prefix(';') {
        let path = comment.starts_with("$PATH");
        let text = comment.strip_prefix(' ').unwrap_or(comment).to_owned();
        return content(if path { Content::Mark(Mark::Name) } else { Content::Comment(text) });
    }
    if let Some(message) = start.strip_prefix("MSG(\"") {
        let message = message.strip_suffix("\")").ok_or("a message does not end")?;
        return content(Content::Comment(message.to_owned()));
    }
    if start.starts_with("%_N_") {
        return content(Content::Mark(Mark::Name));
    }
    if start.starts_with("IF ") || start == "ENDIF" {
        return content(Content::Condition(start.to_owned()));
    }
    let block = start.split(';').next().unwrap_or_default().to_ascii_uppercase();
    let mut tokens = tokens(&block)?;
    let number = take_number(&mut tokens)?;
    Ok(Line { number, content: Content::Block(tokens) })
}

fn tokens(mut text: &str) -> Result<Vec<Token>, String> {
    let mut tokens = Vec::new();
    loop {
        text = text.trim_start();
        if text.is_empty() {
            break;
        }
        let strange = || format!("`{text}` does not begin with a word");
        let letters = text.bytes().take_while(u8::is_ascii_uppercase).count();
        let name = text.bytes().take_while(|byte| byte.is_ascii_uppercase() || byte.is_ascii_digit()).count();
        if letters == 0 {
            return Err(strange());
        }
        let after = &text[name..];
        if let Some(value) = after.strip_prefix('=') {
            let (number, counting, rest) = value_of(value).ok_or_else(strange)?;
            tokens.push(Token::Word { name: text[..name].to_owned(), number, counting });
            text = rest;
        } else if let Some(inside) = after.strip_prefix('(') {
            let end = inside.find(')').ok_or("a call does not end")?;
            let arguments = arguments(&inside[..end])?;
            tokens.push(Token::Call { name: text[..name].to_owned(), arguments });
            text = &inside[end + 1..];
        } else if letters == 1 {
            let (number, rest) = Number::take(text[1..].trim_start()).ok_or_else(strange)?;
            tokens.push(Token::Word { name: text[..1].to_owned(), number, counting: NumberCounting::AsInForce });
            text = rest;
        } else if name == letters && (after.is_empty() || after.starts_with(' ')) {
            tokens.push(Token::Name(text[..name].to_owned()));
            text = after;
        } else {
            return Err(strange());
        }
    }
    if tokens.is_empty() { Err("an empty line".to_owned()) } else { Ok(tokens) }
}

/// `5`, `AC(5)`, `DC(5)`, `IC(5)`.
fn value_of(text: &str) -> Option<(Number, NumberCounting, &str)> {
    // DC is absolute, by the shorter way.
    let absolute = text.strip_prefix("AC(").or_else(|| text.strip_prefix("DC("));
    let (counting, inside) = match (absolute, text.strip_prefix("IC(")) {
        (Some(inside), _) => (NumberCounting::Absolute, inside),
        (_, Some(inside)) => (NumberCounting::Incremental, inside),
        _ => return Number::take(text).map(|(number, rest)| (number, NumberCounting::AsInForce, rest)),
    };
    let (number, rest) = Number::take(inside)?;
    Some((number, counting, rest.strip_prefix(')')?))
}

fn arguments(inside: &str) -> Result<Vec<Option<f64>>, String> {
    if inside.is_empty() {
        return Ok(Vec::new());
    }
    let argument = |text: &str| {
        let text = text.trim();
        if text.is_empty() || text.len() > 1 && text.starts_with('"') && text.ends_with('"') {
            return Ok(None);
        }
        match Number::take(text) {
            Some((number, "")) => Ok(Some(number.value)),
            _ => Err(format!("`{text}` is no argument")),
        }
    };
    inside.split(',').map(argument).collect()
}
