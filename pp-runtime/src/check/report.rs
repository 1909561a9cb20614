//! Result of a check: figures of the whole program, and findings that name the CL line and the block.

use std::collections::HashMap;
use std::fmt::{self, Display, Formatter};

use crate::diag::{Code, Diagnostic, LISTED_OF_A_KIND, Severity, grouped, without_numbers};
use crate::kinematics::math::larger;
use crate::program::Location;

/// Largest number of bytes of a block that a finding shows.
const SHOWN_BYTES: usize = 80;

/// Largest number of causes that are listed separately; further causes share one count. It bounds the memory.
const MOST_CAUSES: usize = 200;

/// A fault of a program: a block, or several in a row.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct Finding {
    /// Class of the finding, whatever its wording and numbers.
    pub code: Code,
    /// Record of the CL data that the block should carry out.
    pub location: Location,
    /// First line of the program.
    pub line: u64,
    /// Last line of the program.
    pub last_line: u64,
    /// Number of blocks from the first line to the last that have the fault.
    pub blocks: u64,
    /// Text of the first block, cut off if it is long.
    pub block: String,
    /// Cause, one sentence without a final stop.
    pub cause: String,
    /// Cause, and the lines of the program with their block.
    pub text: String,
    /// Remedy.
    pub help: Option<String>,
    /// Number of findings that this one represents: 1, or all of its cause that are not listed.
    pub count: u64,
}

impl Finding {
    fn new(code: Code, at: Location, shown: ShownBlock<'_>, cause: &str, help: Option<&str>) -> Self {
        // Text between backquotes does not count in the comparison of causes, so the block must not hold one.
        let block = String::from_utf8_lossy(&shown.text[..shown.text.len().min(SHOWN_BYTES)])
            .replace('`', "'")
            .replace('\n', "");
        // A finding before the first record is shown at the start of the CL data.
        let location = if at == Location::default() { Location { line: 1, column: 1 } } else { at };
        let found = Self {
            code,
            location,
            line: shown.line,
            last_line: shown.line,
            blocks: 1,
            block,
            cause: cause.to_owned(),
            text: String::new(),
            help: help.map(str::to_owned),
            count: 1,
        };
        found.with_text()
    }

    fn with_text(mut self) -> Self {
        let Self { line, last_line, blocks, block, cause, .. } = &self;
        self.text = match (block.is_empty(), *blocks > 1) {
            (true, _) => cause.clone(),
            (false, false) => format!("{cause}; line {line} of the program is `{block}`"),
            (false, true) => format!(
                "{cause}; from line {line} to {last_line}, {blocks} blocks; line {line} of the program is `{block}`"
            ),
        };
        self
    }

    /// The finding as an error in the CL data.
    #[must_use]
    pub fn diagnostic(&self) -> Diagnostic {
        Diagnostic {
            code: self.code,
            severity: Severity::Error,
            location: self.location,
            length: 1,
            text: self.text.clone(),
            help: self.help.clone(),
            count: self.count,
        }
    }
}

/// Largest deviations of a program from its CL data, and the findings.
#[derive(Debug, Clone, PartialEq, Default)]
#[non_exhaustive]
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
    /// Findings by cause, in the order of the first block of each cause; of many of one cause the rest is only counted.
    pub findings: Vec<Finding>,
    /// Number of findings.
    pub count: u64,
    /// Line of the program from which on it was not compared, because the CL data has an error.
    pub not_compared_from: Option<u64>,
    /// Edits that the program has, and that are permitted.
    pub permitted: Vec<PermittedEdit>,
}

/// An edit of a program that is permitted.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PermittedEdit {
    /// Line of the program.
    pub line: u64,
    /// Its text, as edited.
    pub block: String,
    /// What the edit has taken away.
    pub old: String,
    /// What it has put there.
    pub new: String,
    /// Why.
    pub reason: String,
}

impl Display for PermittedEdit {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let Self { line, block, old, new, reason } = self;
        let what = match (old.is_empty(), new.is_empty()) {
            (true, _) => format!("`{new}` added"),
            (_, true) => format!("`{old}` taken away"),
            _ => format!("`{new}` for `{old}`"),
        };
        write!(f, "permitted edit: {what} ({reason}); line {line} of the program is `{block}`")
    }
}

impl Outcome {
    /// Adds a finding about a line of the program.
    pub(super) fn add(&mut self, code: Code, line: u64, block: &[u8], cause: &str) {
        self.findings.push(Finding::new(code, Location::default(), ShownBlock { line, text: block }, cause, None));
        self.count += 1;
    }

    /// The permitted edits, a line each, and the figures.
    #[must_use]
    pub fn lines(&self) -> Vec<String> {
        self.permitted.iter().map(ToString::to_string).chain([self.summary()]).collect()
    }

    /// Whether the program does what the CL data asks for.
    #[must_use]
    pub fn passed(&self) -> bool {
        self.count == 0 && self.not_compared_from.is_none()
    }

    /// The figures in one line of text.
    #[must_use]
    pub fn summary(&self) -> String {
        let found = match self.count {
            0 => String::new(),
            1 => ", 1 finding; besides it".to_owned(),
            count => format!(", {} findings; besides them", grouped(count)),
        };
        let limits = match self.limits_declared {
            true => match self.outside_limits {
                1 => "1 point outside limits".to_owned(),
                count => format!("{} points outside limits", grouped(count)),
            },
            false => "no limits declared".to_owned(),
        };
        let rest = match self.not_compared_from {
            Some(line) => format!("; from line {line} on not compared, because the CL data has an error"),
            None => String::new(),
        };
        // Rounding of the words is allowed in addition to the tolerance.
        let rounding =
            if self.count == 0 && self.path_mm > self.tolerance_mm { " plus rounding of the words" } else { "" };
        let edits = match self.permitted.len() {
            0 => String::new(),
            1 => " with 1 permitted edit".to_owned(),
            count => format!(" with {count} permitted edits"),
        };
        format!(
            "checked{edits}: {} motion blocks{found}, largest deviation of tip {} µm, of tool axis {:.4}°, of path {} µm of {} \
             allowed{rounding}, {limits}{rest}",
            grouped(self.blocks),
            short(self.tip_mm * 1e3),
            self.axis_rad.to_degrees(),
            short(self.path_mm * 1e3),
            short(self.tolerance_mm * 1e3),
        )
    }
}

/// A number with two significant digits; 0 where the first decimal would be.
fn short(value: f64) -> String {
    if !(0.05..9.95).contains(&value) { format!("{value:.0}") } else { format!("{value:.1}") }
}

/// A block as shown in a finding: its line in the program and its text.
#[derive(Debug, Clone, Copy)]
pub(super) struct ShownBlock<'t> {
    pub(crate) line: u64,
    pub(crate) text: &'t [u8],
}

/// Figures and findings while a program is compared.
#[derive(Debug, Clone, Default)]
pub(super) struct Tally {
    outcome: Outcome,
    causes: Vec<Cause>,
    /// Position in `causes` by text without numbers.
    by_text: HashMap<String, usize>,
    /// Faults of the last block, which the next one may have, too.
    runs: Vec<FaultRun>,
    /// Largest deviations of the tip at the end of a block and along one, mm, without those of the block at hand.
    put_aside: (f64, f64),
}

/// One fault of several blocks in a row.
#[derive(Debug, Clone)]
struct FaultRun {
    found: Finding,
    kind: String,
    /// Number of the last motion that has it.
    last: u64,
}

/// Faults that the next block may have, too, at most: the others are not continued.
const MOST_RUNS: usize = 32;

/// Kind of the findings about blocks that match nothing.
const LOST: &str = "lost";

/// Findings of one cause.
#[derive(Debug, Clone, Default)]
struct Cause {
    listed: Vec<Finding>,
    /// First finding that is not listed, and how many there are.
    further: Option<Finding>,
}

impl Tally {
    pub(super) fn new(tolerance_mm: f64, limits_declared: bool) -> Self {
        Self { outcome: Outcome { tolerance_mm, limits_declared, ..Outcome::default() }, ..Self::default() }
    }

    /// Counts a block that moves an axis.
    pub(super) fn count_motion(&mut self) {
        self.outcome.blocks += u64::from(self.compares());
    }

    /// The CL data has an error: from this line of the program on nothing is compared any more.
    pub(super) fn stop(&mut self, line: u64) {
        self.end_runs(u64::MAX);
        self.outcome.not_compared_from.get_or_insert(line);
    }

    fn compares(&self) -> bool {
        self.outcome.not_compared_from.is_none()
    }

    /// Number of blocks that have moved an axis.
    pub(super) fn motions(&self) -> u64 {
        self.outcome.blocks
    }

    /// Number of findings so far.
    pub(super) fn count(&self) -> u64 {
        self.outcome.count
    }

    /// Deviation at the end of a block.
    pub(super) fn deviation(&mut self, tip_mm: f64, axis_rad: f64) {
        self.outcome.tip_mm = larger(tip_mm, self.outcome.tip_mm);
        self.outcome.axis_rad = larger(axis_rad, self.outcome.axis_rad);
    }

    /// Largest deviation of the tool axis at the end of a block so far, rad.
    pub(super) fn largest_axis_deviation(&self) -> f64 {
        self.outcome.axis_rad
    }

    /// Deviation of the tip between the ends of a block.
    pub(super) fn path_deviation(&mut self, tip_mm: f64) {
        self.outcome.path_mm = self.outcome.path_mm.max(tip_mm);
    }

    /// Largest deviation of the tip between the ends of a block so far, mm.
    pub(super) fn largest_path_deviation(&self) -> f64 {
        self.outcome.path_mm
    }

    /// Largest deviation of the tip since they have been put aside, mm; `None` if none has been measured.
    pub(super) fn take_deviation(&mut self) -> Option<f64> {
        let Outcome { tip_mm: tip, path_mm: path, .. } = &mut self.outcome;
        let found = tip.max(*path);
        let (tip_mm, path_mm) = std::mem::take(&mut self.put_aside);
        (*tip, *path) = (tip.max(tip_mm), path.max(path_mm));
        (found >= 0.0).then_some(found)
    }

    /// Puts the deviations of the tip aside, for [`take_deviation`](Self::take_deviation).
    pub(super) fn put_aside_deviations(&mut self) {
        let Outcome { tip_mm, path_mm, .. } = &mut self.outcome;
        self.put_aside = (std::mem::replace(tip_mm, -1.0), std::mem::replace(path_mm, -1.0));
    }

    /// Adds a finding about a point outside the limits of an axis.
    pub(super) fn outside_limits(&mut self, code: Code, at: Location, shown: ShownBlock<'_>, text: &str) {
        self.outcome.outside_limits += u64::from(self.compares());
        self.found(code, at, shown, text);
    }

    /// Adds a finding about a block; blocks in a row with the same fault are one finding. `at`: the CL record that the
    /// block should carry out.
    #[cold]
    pub(super) fn found(&mut self, code: Code, at: Location, shown: ShownBlock<'_>, cause: &str) {
        self.found_in_run(code, at, shown, cause, without_numbers(cause, |quoted| quoted));
    }

    fn found_in_run(&mut self, code: Code, at: Location, shown: ShownBlock<'_>, cause: &str, kind: String) {
        if !self.compares() {
            return;
        }
        let number = self.outcome.blocks;
        self.end_runs(number);
        if let Some(run) = self.runs.iter_mut().find(|run| run.kind == kind) {
            run.found.blocks += u64::from(run.found.last_line < shown.line);
            (run.found.last_line, run.last) = (shown.line, number);
            return;
        }
        self.outcome.count += 1;
        if self.runs.len() == MOST_RUNS {
            let run = self.runs.remove(0);
            self.add(run.found.with_text());
        }
        self.runs.push(FaultRun { found: Finding::new(code, at, shown, cause, None), kind, last: number });
    }

    /// Ends the runs that the block before this motion does not have.
    fn end_runs(&mut self, number: u64) {
        while let Some(index) = self.runs.iter().position(|run| run.last.saturating_add(1) < number) {
            let run = self.runs.remove(index);
            self.add(run.found.with_text());
        }
    }

    /// Adds a finding that every block until the next tool change repeats: the first is listed, the others are counted.
    #[cold]
    pub(super) fn found_once(&mut self, code: Code, at: Location, shown: ShownBlock<'_>, cause: &str) {
        if self.compares() {
            self.outcome.count += 1;
            self.add_to(cause.to_owned(), 1, Finding::new(code, at, shown, cause, None));
        }
    }

    /// Adds a finding about a block that matches nothing; such blocks in a row are one finding, whatever each of them
    /// lacks.
    #[cold]
    pub(super) fn found_lost(&mut self, code: Code, at: Location, shown: ShownBlock<'_>, cause: &str) {
        self.found_in_run(code, at, shown, cause, LOST.to_owned());
    }

    fn add(&mut self, found: Finding) {
        self.add_to(found.diagnostic().kind(), LISTED_OF_A_KIND, found);
    }

    /// `most`: largest number of findings of this kind that are listed.
    fn add_to(&mut self, mut kind: String, most: u64, found: Finding) {
        if self.causes.len() >= MOST_CAUSES && !self.by_text.contains_key(&kind) {
            kind = "other findings".to_owned();
        }
        let causes = &mut self.causes;
        let index = *self.by_text.entry(kind).or_insert_with(|| {
            causes.push(Cause::default());
            causes.len() - 1
        });
        let Some(cause) = causes.get_mut(index) else { return };
        match &mut cause.further {
            Some(further) => further.count += 1,
            None if (cause.listed.len() as u64) < most => cause.listed.push(found),
            further => *further = Some(found),
        }
    }

    /// Outcome; `lines`: number of lines of the program.
    pub(super) fn conclude(mut self, lines: u64) -> Outcome {
        self.end_runs(u64::MAX);
        self.causes.iter_mut().for_each(|cause| cause.listed.sort_by_key(|found| found.line));
        let first = |cause: &Cause| cause.listed.first().map(|found| found.line);
        self.causes.sort_by_key(first);
        for cause in self.causes {
            self.outcome.findings.extend(cause.listed);
            self.outcome.findings.extend(cause.further.map(|first| {
                let text = format!("{} more of this kind from here on: {}", first.count, first.diagnostic().kind());
                Finding { text, help: None, ..first }
            }));
        }
        self.outcome.lines = lines;
        self.outcome
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_summary_names_rounding_where_a_path_exceeds_its_tolerance_by_it() {
        let summary =
            |path_mm: f64, count: u64| Outcome { path_mm, tolerance_mm: 0.01, count, ..Outcome::default() }.summary();
        assert!(summary(0.0098, 0).contains("of path 9.8 µm of 10 allowed, "));
        assert!(summary(0.0108, 0).contains("of path 11 µm of 10 allowed plus rounding of the words, "));
        // A finding has its own figures.
        assert!(summary(0.4, 1).contains("of path 400 µm of 10 allowed, "));
    }
}
