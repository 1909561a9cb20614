//! Faults of planning: first without, then with their location in the CL data.

use std::fmt::Display;
use std::io;

use crate::diag::{Code, Diagnostic, Severity};
use crate::program::Location;

/// The cause of a fault in plain words, and its remedy. Boxed: a result that may be a fault is one word.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Fault(Box<FaultCause>);

#[derive(Debug, Clone, PartialEq, Eq)]
struct FaultCause {
    code: Code,
    text: String,
    help: Option<String>,
}

impl Code {
    /// The fault with this code.
    pub(crate) fn fault(self, text: impl Display) -> Fault {
        Fault(Box::new(FaultCause { code: self, text: text.to_string(), help: None }))
    }
}

impl Fault {
    pub(crate) fn help(mut self, help: impl Display) -> Self {
        self.0.help = Some(help.to_string());
        self
    }

    /// Puts the purpose of the refused motion before the text.
    pub(crate) fn context(mut self, purpose: impl Display) -> Self {
        self.0.text = format!("{purpose}: {}", self.0.text);
        self
    }

    /// The diagnostic at a location.
    pub(crate) fn at(self, location: Location, severity: Severity) -> Diagnostic {
        let FaultCause { code, text, help } = *self.0;
        Diagnostic { code, severity, location, length: 1, text, help, count: 1 }
    }
}

/// The error that ends planning, with its location.
#[derive(Debug)]
pub enum PlanningError {
    /// The CL data cannot be posted beyond this record.
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

/// The error of one item, before its location is attached.
#[derive(Debug)]
pub(crate) enum ItemError {
    /// The CL data cannot be posted beyond this record.
    Fault(Fault),
    /// The output failed.
    Output(io::Error),
}

impl ItemError {
    /// The error at the location of its record.
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

/// Result of planning something.
pub(crate) type Planned = Result<(), ItemError>;
