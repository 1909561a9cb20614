//! Why a motion cannot be posted, before it is known where in the CL data it stands.

use std::fmt::Display;

use crate::diag::{Diagnostic, Severity};
use crate::program::Location;

/// One reason, in a machinist's words, with a remedy.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Fault {
    text: String,
    help: Option<String>,
}

impl Fault {
    pub(crate) fn new(text: impl Display) -> Self {
        Self { text: text.to_string(), help: None }
    }

    pub(crate) fn help(mut self, help: impl Display) -> Self {
        self.help = Some(help.to_string());
        self
    }

    /// Says what the motion was for that cannot be posted.
    pub(crate) fn context(mut self, what: impl Display) -> Self {
        self.text = format!("{what}: {}", self.text);
        self
    }

    pub(crate) fn at(self, location: Location, severity: Severity) -> Diagnostic {
        Diagnostic { severity, location, length: 1, text: self.text, help: self.help, count: 1 }
    }
}
