//! What a comparison has found: figures of the whole program, and findings that show both sides.

use crate::diag::{Diagnostic, Remarks, Severity, grouped};
use crate::program::Location;

/// Bytes of a block that a finding shows.
const SHOWN: usize = 80;

/// The largest deviations of a program, and what is wrong with it.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Outcome {
    /// Blocks that move an axis.
    pub blocks: u64,
    /// Lines of the program.
    pub lines: u64,
    /// Largest distance of the end of a block from the path of the CL data, mm.
    pub tip: f64,
    /// Largest angle of the tool axis there from that of the CL data, rad.
    pub axis: f64,
    /// Largest distance of the tip from the path along a feed block, mm.
    pub path: f64,
    /// How far it may be, mm.
    pub tolerance: f64,
    /// The travel of some axis is declared.
    pub limited: bool,
    /// Points outside the travel of an axis.
    pub limits: u64,
    /// What is wrong, each with the line of the CL data and the block; more of a kind are counted.
    pub findings: Vec<Diagnostic>,
    /// How many findings there are.
    pub count: u64,
}

impl Outcome {
    /// Whether the program does what the CL data asks for.
    #[must_use]
    pub fn passed(&self) -> bool {
        self.count == 0
    }

    /// One line for people.
    #[must_use]
    pub fn summary(&self) -> String {
        let found = match self.count {
            0 => String::new(),
            1 => ", 1 finding".to_owned(),
            count => format!(", {} findings", grouped(count)),
        };
        let limits = match self.limited {
            true => format!("{} outside limits", grouped(self.limits)),
            false => "no limits declared".to_owned(),
        };
        format!(
            "checked: {} moving blocks, tip {} µm, axis {:.4}°, path {} µm of {}, {limits}{found}",
            grouped(self.blocks),
            short(self.tip * 1e3),
            self.axis.to_degrees(),
            short(self.path * 1e3),
            short(self.tolerance * 1e3),
        )
    }
}

/// Two significant digits.
fn short(value: f64) -> String {
    if value >= 9.95 || value == 0.0 { format!("{value:.0}") } else { format!("{value:.1}") }
}

/// A block as a finding shows it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Shown<'t> {
    pub(super) line: u64,
    pub(super) text: &'t [u8],
}

/// Collects findings.
#[derive(Debug, Default)]
pub(super) struct Tally {
    pub(super) outcome: Outcome,
    remarks: Remarks,
}

impl Tally {
    /// Notes a finding about a block; `at` is the line of the CL data that it should serve.
    #[cold]
    pub(super) fn found(&mut self, at: Location, shown: Shown<'_>, text: &str, help: Option<&str>) {
        // Between these marks findings of one kind may differ.
        let block = String::from_utf8_lossy(&shown.text[..shown.text.len().min(SHOWN)]).replace('`', "'");
        let text = match block.is_empty() {
            true => text.to_owned(),
            false => format!("{text}; line {} of the program is `{block}`", shown.line),
        };
        self.outcome.count += 1;
        // In front of everything that the CL data asks for.
        let at = if at == Location::default() { Location { line: 1, column: 1 } } else { at };
        self.remarks.add(Diagnostic {
            severity: Severity::Error,
            location: at,
            length: 1,
            count: 1,
            text,
            help: help.map(str::to_owned),
        });
    }

    pub(super) fn conclude(mut self) -> Outcome {
        self.outcome.findings = self.remarks.conclude();
        self.outcome
    }
}
