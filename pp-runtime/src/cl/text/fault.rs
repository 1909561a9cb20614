//! Faults of single statements.
//!
//! A fault names bytes of its statement; the reader converts them to line and column of the file.

use super::encoding::decoded;
use crate::diag::code::cl;
use crate::diag::{Code, Severity};

/// Range of bytes of a statement, counted from its first byte.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Span {
    /// First byte.
    pub start: usize,
    /// One after the last.
    pub end: usize,
}

impl Span {
    /// The whole statement, up to the end of its first line.
    pub(crate) const WHOLE: Span = Span { start: 0, end: usize::MAX };
}

/// Remedy of a fault.
#[derive(Debug)]
pub(crate) enum Help {
    Text(String),
    /// Suggests the known word nearest to this one. The search is made only if the fault is listed.
    NearestTo(String),
}

/// A fault of a statement: what is wrong, where, and the remedy.
#[derive(Debug)]
pub(crate) struct ClFault {
    /// What a program that reads the messages may rely on.
    pub(crate) code: Code,
    /// Faults of one kind are counted together.
    pub(crate) kind: &'static str,
    pub(crate) at: Span,
    pub(crate) text: String,
    pub(crate) help: Help,
    pub(crate) severity: Severity,
}

/// Kind of the faults of records that belong to turning.
const TURNING: &str = "turning record";

/// Where numbers are expected a fault is in a box: the numbers of a result then stay in whole registers.
impl From<Box<ClFault>> for ClFault {
    fn from(fault: Box<ClFault>) -> Self {
        *fault
    }
}

impl Code {
    /// The error of a statement with this code.
    pub(crate) fn cl_fault(
        self,
        kind: &'static str,
        at: Span,
        text: impl Into<String>,
        help: impl Into<String>,
    ) -> ClFault {
        ClFault { code: self, kind, at, text: text.into(), help: Help::Text(help.into()), severity: Severity::Error }
    }
}

impl ClFault {
    /// The same fault as a warning.
    pub(crate) fn warning(self) -> Self {
        ClFault { severity: Severity::Warning, ..self }
    }

    /// Whether the record belongs to turning.
    pub(crate) fn is_of_lathe(&self) -> bool {
        self.kind == TURNING
    }

    /// Fault: the record belongs to turning.
    pub(crate) fn lathe_record(at: Span) -> Self {
        cl::TURNING.cl_fault(
            TURNING,
            at,
            "this record belongs to turning: only milling is supported",
            "use a postprocessor for turning, or output milling operations only",
        )
    }
}

/// Quotes bytes of a file for a message: at most 40 letters.
pub(crate) fn quoted(text: &[u8]) -> String {
    const SHOWN: usize = 40;
    let text = decoded(text);
    let mut letters = text.chars().map(|letter| if letter.is_control() { '\u{FFFD}' } else { letter });
    let shown: String = letters.by_ref().take(SHOWN).collect();
    let dots = if letters.next().is_some() { "..." } else { "" };
    format!("`{shown}{dots}`")
}

#[cfg(test)]
mod tests {
    use super::quoted;

    #[test]
    fn foreign_bytes_and_long_text_are_quoted_safely_and_shortened() {
        assert_eq!(quoted(b"GOTO"), "`GOTO`");
        assert_eq!(quoted(b"\xCF\x00x"), "`Ï\u{FFFD}x`");
        assert_eq!(quoted(&[b'a'; 41]), format!("`{}...`", "a".repeat(40)));
    }
}
