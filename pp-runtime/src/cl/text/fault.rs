//! Faults of single statements.
//!
//! A fault points at bytes of its statement; the reader turns that into line and column.

use crate::diag::Severity;

/// Bytes of a statement, counted from its first.
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
    /// Name the known word nearest to this one. Looked for only if the fault is shown.
    NearestTo(String),
}

/// Why a statement is not understood.
#[derive(Debug)]
pub(crate) struct ClFault {
    /// Faults of one kind are counted together.
    pub(crate) kind: &'static str,
    pub(crate) at: Span,
    pub(crate) text: String,
    pub(crate) help: Help,
    pub(crate) severity: Severity,
}

impl ClFault {
    pub(crate) fn new(kind: &'static str, at: Span, text: impl Into<String>, help: impl Into<String>) -> Self {
        ClFault { kind, at, text: text.into(), help: Help::Text(help.into()), severity: Severity::Error }
    }

    /// The same as a warning.
    pub(crate) fn warning(self) -> Self {
        ClFault { severity: Severity::Warning, ..self }
    }

    /// A record of a lathe.
    pub(crate) fn lathe_record(at: Span) -> Self {
        ClFault::new(
            "turning",
            at,
            "this is a turning file: records of a lathe are not understood",
            "post it for a lathe; only milling is understood here",
        )
    }
}

/// Bytes of a file as they can be shown in a message: short, and valid whatever the file's encoding.
pub(crate) fn quoted(text: &[u8]) -> String {
    const SHOWN: usize = 40;
    let (text, dots) = if text.len() > SHOWN { (&text[..SHOWN], "...") } else { (text, "") };
    let clean: String =
        String::from_utf8_lossy(text).chars().map(|c| if c.is_control() { '\u{FFFD}' } else { c }).collect();
    format!("`{clean}{dots}`")
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
