//! Turns faults of statements into diagnostics, in a bounded list.
//!
//! The first [`LISTED_OF_A_KIND`] faults of a kind are listed, further ones are counted: a file with a million equal
//! faults must not fill the memory or the screen.

use std::io::Read;

use super::record::{if_harmless, nearest_word};
use super::text::{ClFault, Help, Lexer, Statement, whole_number};
use crate::diag::{Code, Diagnostic, LISTED_OF_A_KIND, Severity};
use crate::program::Location;

/// Diagnostics in the order found, and the number of faults of each kind and severity.
#[derive(Debug, Default)]
pub(crate) struct Faults {
    diagnostics: Vec<Diagnostic>,
    counts: Vec<FaultCount>,
    failed: bool,
}

#[derive(Debug)]
struct FaultCount {
    kind: &'static str,
    severity: Severity,
    found: u64,
    /// Code and place of the first fault that is not listed.
    first_hidden: (Code, Location),
}

impl Faults {
    pub(crate) fn diagnostics(&self) -> &[Diagnostic] {
        &self.diagnostics
    }

    pub(crate) fn failed(&self) -> bool {
        self.failed
    }

    /// Adds the fault of a statement.
    #[cold]
    pub(crate) fn add<R: Read>(&mut self, fault: ClFault, statement: &Statement, lexer: &Lexer<R>) {
        let (location, left_on_line) = lexer.locate(statement, fault.at.start);
        self.add_at(fault, location, left_on_line);
    }

    /// Adds a fault at `location`; `left_on_line`: number of bytes of the statement from there on that line.
    pub(crate) fn add_at(&mut self, fault: ClFault, location: Location, left_on_line: usize) {
        let length = fault.at.end.saturating_sub(fault.at.start).min(left_on_line).max(1);
        if !self.is_shown(&fault, location) {
            return;
        }
        let help = match fault.help {
            Help::Text(text) => text,
            Help::NearestTo(word) => match nearest_word(&word) {
                Some(known) => {
                    format!("did you mean {known}? A statement of the shop gets its block in `[cl.words]`")
                }
                None if word.is_empty() => "check whether this file is CL data: the line is no record".into(),
                None if whole_number(word.as_bytes()).is_some() => {
                    "numbers on a line of their own belong to the record before them, whose line ends in `$` then"
                        .into()
                }
                None => if_harmless(&word),
            },
        };
        self.diagnostics.push(Diagnostic {
            code: fault.code,
            severity: fault.severity,
            location,
            length: u32::try_from(length).unwrap_or(u32::MAX),
            text: fault.text,
            help: Some(help),
            count: 1,
        });
    }

    /// Adds a diagnostic about the file as a whole.
    pub(crate) fn add_about_file(
        &mut self,
        code: Code,
        severity: Severity,
        location: Location,
        text: String,
        help: &str,
    ) {
        self.failed |= severity == Severity::Error;
        let help = Some(help.into());
        self.diagnostics.push(Diagnostic { code, severity, location, length: 1, text, help, count: 1 });
    }

    /// Adds, at the end of the file, the number of faults of each kind that are not listed.
    pub(crate) fn conclude(&mut self) {
        for count in &self.counts {
            if let Some(hidden) = count.found.checked_sub(LISTED_OF_A_KIND).filter(|hidden| *hidden > 0) {
                self.diagnostics.push(Diagnostic {
                    code: count.first_hidden.0,
                    severity: count.severity,
                    location: count.first_hidden.1,
                    length: 1,
                    text: format!("{hidden} more of this kind from here on: {}", count.kind),
                    help: None,
                    count: hidden,
                });
            }
        }
    }

    fn is_shown(&mut self, fault: &ClFault, location: Location) -> bool {
        let &ClFault { code, kind, severity, .. } = fault;
        self.failed |= severity == Severity::Error;
        let index = self.counts.iter().position(|count| count.kind == kind && count.severity == severity);
        let index = index.unwrap_or_else(|| {
            self.counts.push(FaultCount { kind, severity, found: 0, first_hidden: (code, location) });
            self.counts.len() - 1
        });
        let count = &mut self.counts[index];
        count.found += 1;
        if count.found == LISTED_OF_A_KIND + 1 {
            count.first_hidden = (code, location);
        }
        count.found <= LISTED_OF_A_KIND
    }
}
