//! Texts of a program: comments in lines, letters that every control has, names of programs.

use std::borrow::Cow;

use crate::control::dialects::Spellings;
use crate::control::layout::Layout;

/// The part of a text that fits into a line of `length` bytes, up to a blank if it holds one, and the rest.
fn line_of(text: &[u8], length: usize) -> (&[u8], Option<&[u8]>) {
    if text.len() <= length {
        return (text, None);
    }
    match text[..=length].iter().rposition(|&byte| byte == b' ') {
        Some(blank) => (&text[..blank], Some(&text[blank + 1..])),
        None => (&text[..length], Some(&text[length..])),
    }
}

/// A text in lines of at most `length` bytes; none of an empty one.
pub(crate) fn lines_of(text: &[u8], length: usize) -> impl Iterator<Item = &[u8]> {
    let mut rest = Some(text);
    let lines = std::iter::from_fn(move || {
        let (line, after) = line_of(rest?, length);
        rest = after;
        Some(line)
    });
    lines.filter(|line| !line.is_empty())
}

/// A text whose signs that few controls have (`°`, `µ`) are written in letters.
pub(crate) fn legible(text: &[u8]) -> Cow<'_, [u8]> {
    if text.is_ascii() {
        return text.into();
    }
    let mut out = Vec::with_capacity(text.len());
    for chunk in text.utf8_chunks() {
        for letter in chunk.valid().chars() {
            match letter {
                '°' => out.extend_from_slice(b" deg"),
                'µ' => out.push(b'u'),
                other => out.extend_from_slice(other.encode_utf8(&mut [0; 4]).as_bytes()),
            }
        }
        out.extend_from_slice(chunk.invalid());
    }
    out.into()
}

/// A name of capitals, digits and `_`.
pub(crate) fn plain(name: &str) -> String {
    let byte = |byte: char| if byte.is_ascii_alphanumeric() { byte.to_ascii_uppercase() } else { '_' };
    name.chars().map(byte).collect()
}

/// The name of a program as the control can hold it.
pub(crate) fn program_name(codes: &Spellings, layout: &Layout) -> String {
    let given = layout.options.program_name.as_ref().map_or(layout.name.as_slice(), String::as_bytes);
    let given = given.trim_ascii();
    let byte = |byte: &u8| match byte.to_ascii_uppercase() {
        byte if !codes.plain_name => (codes.comment.byte)(byte),
        byte if byte.is_ascii_alphanumeric() => byte,
        _ => b'_',
    };
    let name: String = given.iter().take(codes.comment.length / 2).map(byte).map(char::from).collect();
    if name.is_empty() { "NONAME".to_owned() } else { name }
}
