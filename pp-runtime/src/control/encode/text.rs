//! Texts of a program: line breaks of comments, characters of the control, program names.

use std::borrow::Cow;

use deunicode::deunicode_char;

use crate::control::dialects::{Control, Spellings};
use crate::control::layout::Layout;

/// First line of a text, at most `length` bytes and up to a blank if there is one, and the rest of the text.
fn line_of(text: &[u8], length: usize) -> (&[u8], Option<&[u8]>) {
    if text.len() <= length {
        return (text, None);
    }
    match text[..=length].iter().rposition(|&byte| byte == b' ') {
        Some(blank) => (&text[..blank], Some(&text[blank + 1..])),
        None => (&text[..length], Some(&text[length..])),
    }
}

/// A text in lines of at most `length` bytes, without empty lines.
pub(crate) fn lines_of(text: &[u8], length: usize) -> impl Iterator<Item = &[u8]> {
    let mut rest = Some(text);
    let lines = std::iter::from_fn(move || {
        let (line, after) = line_of(rest?, length);
        rest = after;
        Some(line)
    });
    lines.filter(|line| !line.is_empty())
}

/// A text as comments of a control, in lines of the length that it allows.
pub(crate) fn comments(control: &dyn Control, text: &str) -> Vec<Vec<u8>> {
    let text = legible(text.as_bytes());
    let lines = lines_of(&text, control.spellings().comment.length);
    let spelled = lines.map(|text| {
        let mut line = Vec::new();
        control.comment(text, &mut line);
        line
    });
    spelled.collect()
}

/// A text in ASCII, the letters that all controls have.
pub(crate) fn legible(text: &[u8]) -> Cow<'_, [u8]> {
    if text.is_ascii() {
        return text.into();
    }
    let letter = |letter: char| match letter {
        '°' => " deg",
        'µ' | 'μ' => "u",
        // As German is written without umlauts.
        'Ä' => "AE",
        'Ö' => "OE",
        'Ü' => "UE",
        'ä' => "ae",
        'ö' => "oe",
        'ü' => "ue",
        other => deunicode_char(other).unwrap_or("?"),
    };
    String::from_utf8_lossy(text).chars().map(letter).collect::<String>().into_bytes().into()
}

/// A name in capitals, digits and `_`.
pub(crate) fn plain(name: &str) -> String {
    let byte = |byte: char| if byte.is_ascii_alphanumeric() { byte.to_ascii_uppercase() } else { '_' };
    name.chars().map(byte).collect()
}

/// Name of the program in the characters that the control permits.
pub(crate) fn program_name(codes: &Spellings, layout: &Layout) -> String {
    let given = layout.options.program_name.as_ref().map_or(layout.name.as_slice(), String::as_bytes);
    let given = legible(given.trim_ascii());
    let byte = |byte: &u8| match byte.to_ascii_uppercase() {
        byte if !codes.plain_name => (codes.comment.byte)(byte),
        byte if byte.is_ascii_alphanumeric() => byte,
        _ => b'_',
    };
    let name: String = given.iter().take(codes.comment.length / 2).map(byte).map(char::from).collect();
    if name.is_empty() { "NONAME".to_owned() } else { name }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::control::dialects::Siemens;

    #[test]
    fn the_name_of_the_program_keeps_the_letters_of_its_part() {
        let layout = Layout { name: "Würfel 7".into(), ..Layout::default() };
        assert_eq!(program_name(Siemens.spellings(), &layout), "WUERFEL 7");
    }
}
