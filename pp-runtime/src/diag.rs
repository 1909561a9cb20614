//! Faults and remarks about CL data or a configuration file, without the text they point at.

use crate::program::Location;

/// How much a diagnostic weighs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Severity {
    /// Nothing is posted from here on.
    Error,
    /// Posted, but to be looked at.
    Warning,
}

/// One fault or remark, in a machinist's words, with a remedy.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Diagnostic {
    /// Error or warning.
    pub severity: Severity,
    /// First byte it speaks of.
    pub location: Location,
    /// Number of bytes it speaks of, at least 1, within that line.
    pub length: u32,
    /// One sentence, no final stop.
    pub text: String,
    /// What to do about it.
    pub help: Option<String>,
}
