//! Result of a check: figures of the whole program, and findings that name the CL line and the block.

use crate::diag::{Diagnostic, Remarks, Severity, grouped};
use crate::program::Location;

/// Largest number of bytes of a block that a finding shows.
const SHOWN_BYTES: usize = 80;

/// Largest deviations of a program from its CL data, and the findings.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Outcome {
    /// Number of blocks that move an axis.
    pub blocks: u64,
    /// Number of lines of the program.
    pub lines: u64,
    /// Largest distance of the tip from the path of the CL data at the end of a block, mm.
    pub tip_mm: f64,
    /// Largest angle between the tool axis and that of the CL data at the end of a block, rad.
    pub axis_rad: f64,
    /// Largest distance of the tip from the path of the CL data along a feed block, mm.
    pub path_mm: f64,
    /// Tolerance for `path_mm`, mm.
    pub tolerance_mm: f64,
    /// At least one axis has declared limits.
    pub limits_declared: bool,
    /// Number of points outside the limits of an axis.
    pub outside_limits: u64,
    /// Findings, each with its CL line and its block; of many of one kind the rest is only counted.
    pub findings: Vec<Diagnostic>,
    /// Number of findings.
    pub count: u64,
}

impl Outcome {
    /// Whether the program does what the CL data asks for.
    #[must_use]
    pub fn passed(&self) -> bool {
        self.count == 0
    }

    /// The figures in one line of text.
    #[must_use]
    pub fn summary(&self) -> String {
        let found = match self.count {
            0 => String::new(),
            1 => ", 1 finding".to_owned(),
            count => format!(", {} findings", grouped(count)),
        };
        let limits = match self.limits_declared {
            true => match self.outside_limits {
                1 => "1 point outside limits".to_owned(),
                count => format!("{} points outside limits", grouped(count)),
            },
            false => "no limits declared".to_owned(),
        };
        format!(
            "checked: {} motion blocks, largest deviation of tip {} µm, of tool axis {:.4}°, of path {} µm of {} \
             allowed, {limits}{found}",
            grouped(self.blocks),
            short(self.tip_mm * 1e3),
            self.axis_rad.to_degrees(),
            short(self.path_mm * 1e3),
            short(self.tolerance_mm * 1e3),
        )
    }
}

/// A number with two significant digits.
fn short(value: f64) -> String {
    if value >= 9.95 || value == 0.0 { format!("{value:.0}") } else { format!("{value:.1}") }
}

/// A block as shown in a finding: its line in the program and its text.
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
    /// Adds a finding about a block. `at`: the CL record that the block should carry out.
    #[cold]
    pub(super) fn found(&mut self, at: Location, shown: Shown<'_>, text: &str, help: Option<&str>) {
        // Text between backquotes does not count in the comparison of kinds, so the block must not hold one.
        let block = String::from_utf8_lossy(&shown.text[..shown.text.len().min(SHOWN_BYTES)]).replace('`', "'");
        let text = match block.is_empty() {
            true => text.to_owned(),
            false => format!("{text}; line {} of the program is `{block}`", shown.line),
        };
        self.outcome.count += 1;
        // A finding before the first record is shown at the start of the CL data.
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
