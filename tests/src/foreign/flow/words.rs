//! Words with values become words with numbers.

use super::super::Control::{Fanuc, Haas, Heidenhain, LinuxCnc, Siemens};
use super::super::lexer;
use super::Flow;
use super::expression::{Fault, Variables, is_parameter, wrong};

/// Letters whose number is whole: codes, registers, counts.
const WHOLE: &str = "GMNTHDLPOS";

/// The block of a line with numbers alone.
pub(super) fn block(flow: &mut Flow, at: usize) -> Result<String, Fault> {
    let line = &flow.lines[at];
    match flow.control {
        LinuxCnc | Fanuc | Haas => {
            let condition = line.code.starts_with('O') || line.code.starts_with("IF");
            if condition || !line.code.contains(['#', '[']) {
                return Ok(line.text.clone());
            }
            let code = iso(flow, &line.code)?;
            Ok(line.label.as_ref().map_or(code.clone(), |label| format!("N{label} {code}")))
        }
        Siemens => {
            if lexer::line(Siemens, &line.text).is_ok() {
                return Ok(line.text.clone());
            }
            let code = siemens(flow, &line.code)?;
            let number = line.label.as_ref().and_then(|label| label.strip_prefix('N'));
            let number = number.filter(|number| number.parse::<u32>().is_ok());
            Ok(number.map_or(code.clone(), |number| format!("N{number} {code}")))
        }
        Heidenhain => heidenhain(flow, at),
    }
}

/// A number without exponent.
fn written(value: f64) -> String {
    let text = format!("{value:.9}");
    let text = text.trim_end_matches('0');
    if text == "-0." { "0.".to_owned() } else { text.to_owned() }
}

/// `X[#1+2]`, `X#1`, `X-#1`; `X5` stays as it is.
fn iso(flow: &Flow, code: &str) -> Result<String, Fault> {
    let mut block = String::new();
    let mut rest = code;
    while let Some(letter) = rest.chars().next() {
        block.push(letter);
        rest = &rest[letter.len_utf8()..];
        let unsigned = rest.trim_start_matches(['+', '-']);
        let function = unsigned.bytes().take_while(u8::is_ascii_uppercase).count() > 1;
        if letter.is_ascii_alphabetic() && (unsigned.starts_with(['#', '[']) || function) {
            let mut reader = flow.reader(rest);
            let value = reader.primary()?;
            rest = reader.text;
            let whole = WHOLE.contains(letter) && value.fract() == 0.0;
            let text = written(value);
            block += if whole { text.trim_end_matches('.') } else { &text };
        }
    }
    Ok(block)
}

/// Arguments between commas that are in no bracket and no text.
pub(super) fn arguments(inside: &str) -> Vec<&str> {
    let (mut depth, mut quoted, mut start) = (0, false, 0);
    let mut arguments = Vec::new();
    for (place, letter) in inside.char_indices() {
        match letter {
            '"' => quoted = !quoted,
            '(' | '[' if !quoted => depth += 1,
            ')' | ']' if !quoted => depth -= 1,
            ',' if !quoted && depth == 0 => {
                arguments.push(inside[start..place].trim());
                start = place + 1;
            }
            _ => {}
        }
    }
    if !inside.trim().is_empty() {
        arguments.push(inside[start..].trim());
    }
    arguments
}

/// `X=R1*2`, `Y=IC(R2)`, `CYCLE81(R1,0,2)`.
fn siemens(flow: &Flow, code: &str) -> Result<String, Fault> {
    let mut block: Vec<String> = Vec::new();
    let mut rest = code.trim();
    while !rest.is_empty() {
        let name = rest.bytes().take_while(|byte| byte.is_ascii_alphanumeric() || *byte == b'_').count();
        if name == 0 {
            return wrong("not a word");
        }
        let (word, after) = rest.split_at(name);
        if let Some(value) = after.strip_prefix('=') {
            let value = value.trim_start();
            let counted = ["AC(", "IC("].into_iter().find(|start| value.starts_with(start));
            let mut reader = flow.reader(value.strip_prefix(counted.unwrap_or_default()).unwrap_or(value));
            let number = written(reader.value()?);
            let number = number.trim_end_matches('.');
            match counted {
                Some(counted) if reader.take(")") => block.push(format!("{word}={counted}{number})")),
                Some(_) => return wrong("a bracket does not close"),
                None => block.push(format!("{word}={number}")),
            }
            rest = reader.text.trim_start();
        } else if let Some(inside) = after.strip_prefix('(') {
            let Some((inside, next)) = inside.rsplit_once(')') else { return wrong("a call does not end") };
            let argument = |text: &str| match text {
                "" => Ok(String::new()),
                text if text.starts_with('"') => Ok(text.to_owned()),
                text => flow.value(text).map(|value| written(value).trim_end_matches('.').to_owned()),
            };
            let arguments: Result<Vec<String>, Fault> = arguments(inside).into_iter().map(argument).collect();
            block.push(format!("{word}({})", arguments?.join(",")));
            rest = next.trim_start();
        } else {
            let end = rest.find(' ').unwrap_or(rest.len());
            block.push(rest[..end].to_owned());
            rest = rest[end..].trim_start();
        }
    }
    Ok(block.join(" "))
}

/// `L X+Q1 FQ2`, `Q200=+Q3`. A cycle sets its parameters.
fn heidenhain(flow: &mut Flow, at: usize) -> Result<String, Fault> {
    let text = flow.lines[at].text.clone();
    let code = flow.lines[at].code.clone();
    let mut changed = text.split_whitespace().next().unwrap_or_default().to_owned();
    let mut any = false;
    for piece in code.split(' ').filter(|piece| !piece.is_empty()) {
        let (piece, by_variable) = heidenhain_word(&flow.variables, piece)?;
        any |= by_variable;
        changed.push(' ');
        changed += &piece;
        if code.starts_with("CYCL DEF ")
            && let Some((name, value)) = piece.split_once('=')
            && is_parameter(name)
        {
            // A definition sets the parameters of its cycle; an assignment to them is refused.
            let value = flow.value(value).ok();
            flow.variables.set(flow.control, name, value);
        }
    }
    Ok(if any { changed } else { text })
}

fn heidenhain_word(variables: &Variables, piece: &str) -> Result<(String, bool), Fault> {
    let start = piece.rfind('Q').filter(|start| *start > 0 && is_parameter(&piece[*start..]));
    let Some(start) = start else { return Ok((piece.to_owned(), false)) };
    let signed = piece[..start].ends_with(['+', '-']);
    let begins = if signed { start - 1 } else { start };
    let mut reader = super::ValueReader { control: Heidenhain, text: &piece[begins..], variables };
    let value = written(reader.primary()?);
    let sign = if value.starts_with('-') { "" } else { "+" };
    Ok((format!("{}{sign}{}", &piece[..begins], value.trim_end_matches('.')), true))
}
