//! Faults of single statements, and the bounded list of diagnostics they end in.
//!
//! A fault points at bytes of its statement; the reader turns that into line and column. A file with a million equal
//! faults must not fill the memory or the screen, so each kind is shown a few times and counted from then on.

use super::lexer::{Lexer, Statement};
use super::words;
use crate::diag::{Diagnostic, LISTED_OF_A_KIND, Severity};
use crate::program::Location;
use std::io::Read;

/// Bytes of a statement, counted from its first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Span {
    /// First byte.
    pub start: usize,
    /// One behind the last.
    pub end: usize,
}

impl Span {
    /// The whole statement, as far as its first line goes.
    pub(super) const WHOLE: Span = Span { start: 0, end: usize::MAX };
}

/// What to do about a fault.
#[derive(Debug)]
pub(super) enum Help {
    Text(String),
    /// Name the known word nearest to this one. Looked for only if the fault is shown.
    NearestTo(String),
}

/// Why a statement is not understood.
#[derive(Debug)]
pub(super) struct Fault {
    /// Faults of one kind are counted together.
    pub(super) kind: &'static str,
    pub(super) at: Span,
    pub(super) text: String,
    pub(super) help: Help,
    pub(super) severity: Severity,
}

impl Fault {
    pub(super) fn new(kind: &'static str, at: Span, text: impl Into<String>, help: impl Into<String>) -> Self {
        Fault { kind, at, text: text.into(), help: Help::Text(help.into()), severity: Severity::Error }
    }

    /// The same as a remark.
    pub(super) fn warning(self) -> Self {
        Fault { severity: Severity::Warning, ..self }
    }
}

/// Bytes of a file as they can stand in a message: short, and valid whatever the file's encoding.
pub(super) fn quoted(text: &[u8]) -> String {
    const SHOWN: usize = 40;
    let (text, dots) = if text.len() > SHOWN { (&text[..SHOWN], "...") } else { (text, "") };
    let clean: String =
        String::from_utf8_lossy(text).chars().map(|c| if c.is_control() { '\u{FFFD}' } else { c }).collect();
    format!("`{clean}{dots}`")
}

/// Diagnostics in the order found, and how many more of each kind there were.
#[derive(Debug, Default)]
pub(super) struct Faults {
    diagnostics: Vec<Diagnostic>,
    counts: Vec<Count>,
    failed: bool,
}

#[derive(Debug)]
struct Count {
    kind: &'static str,
    severity: Severity,
    found: u64,
    first_hidden: Location,
}

impl Faults {
    pub(super) fn diagnostics(&self) -> &[Diagnostic] {
        &self.diagnostics
    }

    pub(super) fn failed(&self) -> bool {
        self.failed
    }

    /// Takes the fault of a statement.
    #[cold]
    pub(super) fn add<R: Read>(&mut self, fault: Fault, statement: &Statement, lexer: &Lexer<R>) {
        let (location, left_on_line) = lexer.locate(statement, fault.at.start);
        self.add_at(fault, location, left_on_line);
    }

    /// Takes the fault of a statement whose text goes on for so many bytes on its line.
    pub(super) fn add_at(&mut self, fault: Fault, location: Location, left_on_line: usize) {
        let length = fault.at.end.saturating_sub(fault.at.start).min(left_on_line).max(1);
        if !self.is_shown(fault.kind, fault.severity, location) {
            return;
        }
        let help = match fault.help {
            Help::Text(text) => text,
            Help::NearestTo(word) => match words::nearest(&word) {
                Some(known) => format!("did you mean {known}?"),
                None if word.is_empty() => "check whether this is CL data".into(),
                None => format!("if it is known to move nothing, delete it or give `--inert {word}`"),
            },
        };
        self.diagnostics.push(Diagnostic {
            severity: fault.severity,
            location,
            length: u32::try_from(length).unwrap_or(u32::MAX),
            text: fault.text,
            help: Some(help),
            count: 1,
        });
    }

    /// Takes what is said of the file as a whole.
    pub(super) fn add_about_file(&mut self, severity: Severity, location: Location, text: String, help: &str) {
        self.failed |= severity == Severity::Error;
        self.diagnostics.push(Diagnostic { severity, location, length: 1, text, help: Some(help.into()), count: 1 });
    }

    /// Says at the end how many diagnostics were not shown.
    pub(super) fn conclude(&mut self) {
        for count in &self.counts {
            if let Some(hidden) = count.found.checked_sub(LISTED_OF_A_KIND).filter(|hidden| *hidden > 0) {
                self.diagnostics.push(Diagnostic {
                    severity: count.severity,
                    location: count.first_hidden,
                    length: 1,
                    text: format!("{hidden} more of this kind from here on: {}", count.kind),
                    help: None,
                    count: hidden,
                });
            }
        }
    }

    fn is_shown(&mut self, kind: &'static str, severity: Severity, location: Location) -> bool {
        self.failed |= severity == Severity::Error;
        let index = self.counts.iter().position(|count| count.kind == kind && count.severity == severity);
        let index = index.unwrap_or_else(|| {
            self.counts.push(Count { kind, severity, found: 0, first_hidden: location });
            self.counts.len() - 1
        });
        let count = &mut self.counts[index];
        count.found += 1;
        if count.found == LISTED_OF_A_KIND + 1 {
            count.first_hidden = location;
        }
        count.found <= LISTED_OF_A_KIND
    }
}

#[cfg(test)]
mod tests {
    use super::quoted;

    #[test]
    fn foreign_bytes_and_long_text_can_stand_in_a_message() {
        assert_eq!(quoted(b"GOTO"), "`GOTO`");
        assert_eq!(quoted(b"\xCF\x00x"), "`\u{FFFD}\u{FFFD}x`");
        assert_eq!(quoted(&[b'a'; 41]), format!("`{}...`", "a".repeat(40)));
    }
}
