//! The arguments of a record: words and numbers between commas.

use super::fault::{Fault, Span, quoted};
use super::lexer::is_blank;
use super::number;

/// One argument without the blanks around it; never empty.
#[derive(Debug, Clone, Copy)]
pub(super) struct Arg<'a> {
    pub(super) text: &'a [u8],
    pub(super) at: Span,
}

impl Arg<'_> {
    pub(super) fn is(self, word: &str) -> bool {
        self.text.eq_ignore_ascii_case(word.as_bytes())
    }

    /// Whether it begins like a number; then it must be one.
    pub(super) fn looks_numeric(self) -> bool {
        matches!(self.text[0], b'0'..=b'9' | b'+' | b'-' | b'.')
    }

    /// The finite number it is.
    pub(super) fn number(self) -> Result<f64, Fault> {
        match number::whole(self.text) {
            Some(value) if value.is_finite() => Ok(value),
            Some(_) => Err(Fault::new(
                "number too large",
                self.at,
                format!("{} is too large to be a number here", quoted(self.text)),
                "check the exponent",
            )),
            None => Err(self.not_a_number()),
        }
    }

    /// The tool or register number it is.
    pub(super) fn integer(self) -> Result<u32, Fault> {
        let value = self.number()?;
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // In range, and checked to be whole.
        if (0.0..=f64::from(u32::MAX)).contains(&value) && value.fract().abs() < f64::MIN_POSITIVE {
            Ok(value as u32)
        } else {
            Err(Fault::new(
                "whole number",
                self.at,
                format!("{} must be a whole number, 0 or more", quoted(self.text)),
                "write it as in LOADTL/12",
            ))
        }
    }

    #[cold]
    fn not_a_number(self) -> Fault {
        if self.text.contains(&b'/') {
            return Fault::new(
                "second slash",
                self.at,
                "a second slash stands behind this word",
                "arguments are separated by commas; only a GOTO may hold a list of points",
            );
        }
        if self.text.contains(&b'$') {
            return Fault::new(
                "stray $",
                self.at,
                format!("`$` stands inside a statement: {}", quoted(self.text)),
                "`$` continues a statement only at the end of a line; `$$` begins a comment",
            );
        }
        let glued = number::prefix(self.text).is_some_and(|(_, used)| used > 0);
        let help = if glued {
            "a number ends at a comma: is a comma missing?"
        } else {
            "numbers look like 12, -0.5, .5 or 1.5E-3"
        };
        Fault::new("number expected", self.at, format!("{} is not a number", quoted(self.text)), help)
    }
}

/// Walks over the arguments behind the slash, from left to right.
#[derive(Debug, Clone)]
pub(super) struct Args<'a> {
    text: &'a [u8],
    at: usize,
    /// Another argument must follow.
    more: bool,
    first: usize,
}

impl<'a> Args<'a> {
    /// Arguments from byte `at` of the statement on. Nothing but blanks there means no arguments.
    pub(super) fn new(text: &'a [u8], at: usize) -> Self {
        let at = skip_blanks(text, at.min(text.len()));
        Args { text, at, more: at < text.len(), first: at }
    }

    /// All arguments, for messages; the whole statement if there are none.
    pub(super) fn all(&self) -> Span {
        let start = if self.first < self.text.len() { self.first } else { 0 };
        Span { start, end: self.text.len() }
    }

    /// The next argument; an empty place is an error.
    pub(super) fn next(&mut self) -> Result<Option<Arg<'a>>, Fault> {
        if !self.more {
            return Ok(None);
        }
        let start = skip_blanks(self.text, self.at);
        let end = memchr::memchr(b',', &self.text[start..]).map_or(self.text.len(), |found| start + found);
        let trimmed = end - self.text[start..end].iter().rev().take_while(|byte| is_blank(**byte)).count();
        self.more = end < self.text.len();
        self.at = end + 1;
        if trimmed == start {
            return Err(self.empty_place(start));
        }
        Ok(Some(Arg { text: &self.text[start..trimmed], at: Span { start, end: trimmed } }))
    }

    /// All remaining arguments as numbers. Those beyond the size of `into` are checked and counted only.
    pub(super) fn numbers(&mut self, into: &mut [f64]) -> Result<usize, Fault> {
        let mut count = 0;
        while self.more {
            let start = skip_blanks(self.text, self.at);
            // The common case in one pass; everything unusual goes the slow way for its message.
            let value = match number::prefix(&self.text[start..]) {
                Some((value, used)) if value.is_finite() => {
                    let end = skip_blanks(self.text, start + used);
                    match self.text.get(end) {
                        Some(b',') => self.at = end + 1,
                        None => self.more = false,
                        Some(_) => self.only_number()?,
                    }
                    value
                }
                _ => {
                    self.only_number()?;
                    0.0
                }
            };
            if let Some(place) = into.get_mut(count) {
                *place = value;
            }
            count += 1;
        }
        Ok(count)
    }

    /// Refuses what stands here, which is no number.
    #[cold]
    fn only_number(&mut self) -> Result<(), Fault> {
        if let Some(arg) = self.next()? {
            arg.number()?;
        }
        Ok(())
    }

    #[cold]
    fn empty_place(&self, at: usize) -> Fault {
        let start = at.min(self.text.len() - 1);
        Fault::new(
            "empty place",
            Span { start, end: start + 1 },
            "an argument is missing: nothing stands between the commas here",
            "write the missing argument, or delete the comma",
        )
    }
}

/// A piece without the blanks around it.
pub(super) fn trimmed(piece: &[u8]) -> &[u8] {
    let start = skip_blanks(piece, 0);
    let behind = piece[start..].iter().rev().take_while(|byte| is_blank(**byte)).count();
    &piece[start..piece.len() - behind]
}

/// Index of the first byte from `at` on that is no blank.
pub(super) fn skip_blanks(text: &[u8], mut at: usize) -> usize {
    while at < text.len() && is_blank(text[at]) {
        at += 1;
    }
    at
}
