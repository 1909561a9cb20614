//! Blocks with numbers in the place of their expressions.

use super::super::facts::LineForm;
use super::super::text::Cursor;
use super::expression::Expression;
use super::statement::bare;
use super::variables::Variables;

/// Letters of lengths, angles and feeds: their numbers have a decimal point.
const WITH_POINT: &[u8] = b"XYZABCUVWIJKRQFE";

/// Whether a line may be a statement, or have an expression: most lines of a program do not.
pub(super) fn may_state(line: &[u8], form: LineForm) -> bool {
    let bare = bare(line, form);
    let begins = |words: &[&str]| {
        words.iter().any(|word| bare.len() >= word.len() && bare[..word.len()].eq_ignore_ascii_case(word.as_bytes()))
    };
    match form {
        LineForm::Letters => memchr::memchr2(b'#', b'[', line).is_some() || begins(&LETTERS),
        LineForm::Keywords => line.iter().any(|byte| matches!(byte, b'=' | b'(' | b':')) || begins(&KEYWORDS),
        LineForm::Statements => memchr::memchr(b'Q', line).is_some() || begins(&["LBL", "CALL", "FN"]),
    }
}

/// Beginnings of statements.
const LETTERS: [&str; 9] = ["O", "GOTO", "DO", "END", "WHILE", "M98", "M97", "M99", "G65"];
const KEYWORDS: [&str; 10] = ["IF", "ELSE", "END", "WHILE", "LOOP", "FOR", "GOTO", "DEF", "R", "UNTIL"];

/// Appends the line with the values of its expressions to `text`; whether it has any.
///
/// # Errors
/// The expression whose value is not known.
pub(super) fn numbers(line: &[u8], variables: &Variables, text: &mut Vec<u8>) -> Result<bool, String> {
    let form = variables.form();
    let (mut at, mut found, mut letter) = (Cursor::new(line), false, b' ');
    while let Some(byte) = at.peek() {
        if let Some(length) = passed_over(at.rest(), form) {
            text.extend_from_slice(&at.rest()[..length]);
            at.skip(length);
            continue;
        }
        let start = at;
        if let Some(value) = expression(&mut at, text, variables) {
            let source = &line[start.column()..at.column()];
            let Some(value) = value else { return Err(String::from_utf8_lossy(source).into_owned()) };
            found = true;
            write(value, form, letter, text);
            continue;
        }
        at = start;
        if byte.is_ascii_alphabetic() {
            letter = byte.to_ascii_uppercase();
        }
        text.push(byte);
        at.skip(1);
    }
    Ok(found)
}

/// Length of a comment or a text that comes next.
fn passed_over(rest: &[u8], form: LineForm) -> Option<usize> {
    let until = |end: u8| rest[1..].iter().position(|byte| *byte == end).map_or(rest.len(), |at| at + 2);
    match (rest[0], form) {
        (b'(', LineForm::Letters) => Some(until(b')')),
        (b';', _) => Some(rest.iter().position(|byte| *byte == super::super::text::GOES_ON).unwrap_or(rest.len())),
        (b'"', LineForm::Keywords | LineForm::Statements) => Some(until(b'"')),
        _ => None,
    }
}

/// Takes an expression that comes next, with its sign; `None` where none does. `before`: what has come before it.
fn expression(at: &mut Cursor<'_>, before: &[u8], variables: &Variables) -> Option<Option<f64>> {
    let last = before.last().copied().unwrap_or(b' ');
    let signed = usize::from(matches!(at.peek(), Some(b'-' | b'+')));
    match variables.form() {
        LineForm::Letters => {
            let begins = matches!(at.rest().get(signed), Some(b'#' | b'['));
            (begins && last.is_ascii_alphabetic()).then(|| Expression::new(at, variables).signed())?
        }
        LineForm::Keywords => {
            // A value after `=`, a bracket or a comma that is more than a number.
            matches!(last, b'=' | b'(' | b',').then_some(())?;
            let start = at.rest();
            let value = Expression::new(at, variables).condition()?;
            let taken = &start[..start.len() - at.rest().len()];
            let is_number = taken.iter().all(|byte| matches!(byte, b'0'..=b'9' | b'.' | b'-' | b'+' | b' '));
            let is_plain = is_number && !taken.iter().skip(1).any(|byte| matches!(byte, b'-' | b'+'));
            let ends = matches!(at.peek(), None | Some(b' ' | b'\t' | b',' | b')' | b';'));
            (!is_plain && ends).then_some(value)
        }
        LineForm::Statements => {
            (at.rest().get(signed) == Some(&b'Q')).then_some(())?;
            (!last.is_ascii_alphabetic() || signed > 0 || is_word_letter(before)).then_some(())?;
            let value = {
                let minus = at.peek() == Some(b'-');
                at.skip(signed);
                let variable = variables.read(at)?;
                variables.value(&variable).map(|value| if minus { -value } else { value })
            };
            // The parameter of a cycle is named, not read.
            let mut after = *at;
            after.blanks();
            (after.peek() != Some(b'=')).then_some(value)
        }
    }
}

/// Whether a word of one letter, such as F, ends here.
fn is_word_letter(before: &[u8]) -> bool {
    !matches!(before, [.., first, _] if first.is_ascii_alphanumeric())
}

/// Writes a value as a number of the form.
fn write(value: f64, form: LineForm, letter: u8, text: &mut Vec<u8>) {
    let mut number = format!("{value:.9}");
    let length = number.trim_end_matches('0').len();
    number.truncate(length);
    match form {
        LineForm::Letters if WITH_POINT.contains(&letter) => {}
        _ => number.truncate(number.trim_end_matches('.').len()),
    }
    if number.starts_with("-0") && number.trim_matches(['-', '0', '.']).is_empty() {
        number.remove(0);
    }
    if form == LineForm::Statements && !number.starts_with('-') {
        text.push(b'+');
    }
    text.extend_from_slice(number.as_bytes());
}
