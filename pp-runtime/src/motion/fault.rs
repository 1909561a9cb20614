//! Why something cannot be posted, first without and then with its location in the CL data.

use std::fmt::Display;
use std::io;

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

/// Why planning stopped.
#[derive(Debug)]
pub enum PlanningError {
    /// The CL data cannot be posted from here on.
    Fault(Diagnostic),
    /// The output failed.
    Output(io::Error),
}

impl From<Diagnostic> for PlanningError {
    fn from(fault: Diagnostic) -> Self {
        Self::Fault(fault)
    }
}

impl From<io::Error> for PlanningError {
    fn from(error: io::Error) -> Self {
        Self::Output(error)
    }
}

/// Why an item cannot be planned, before its location is attached.
#[derive(Debug)]
pub(crate) enum ItemError {
    /// The CL data cannot be posted from here on.
    Fault(Fault),
    /// The output failed.
    Output(io::Error),
}

impl ItemError {
    /// With the location of the record.
    pub(crate) fn at(self, location: Location) -> PlanningError {
        match self {
            Self::Fault(fault) => PlanningError::Fault(fault.at(location, Severity::Error)),
            Self::Output(error) => PlanningError::Output(error),
        }
    }
}

impl From<Fault> for ItemError {
    fn from(fault: Fault) -> Self {
        Self::Fault(fault)
    }
}

impl From<io::Error> for ItemError {
    fn from(error: io::Error) -> Self {
        Self::Output(error)
    }
}

/// What becomes of planning something.
pub(crate) type Planned = Result<(), ItemError>;
