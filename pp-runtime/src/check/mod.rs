//! The check of a program: reads the program back, computes tip and tool axis of each block, and compares them with the
//! CL data.
//!
//! `read` turns the text of a program into blocks; it knows the control and nothing else. `chain` and `words` compute
//! tip and tool axis from the axis words with matrices at run time, not with the generated functions. `expect` reads
//! from the CL data what the program has to do, `path` gives the position of the tool along a motion, `feed` its feed.
//! `compare` compares the two: with `follow` and `steps` in cuts, `sequence` and `out` between cuts, and `state` for
//! modal codes. Memory does not grow with the length of the program.

mod chain;
mod compare;
mod expect;
mod feed;
mod follow;
mod hole;
mod out;
mod path;
mod reach;
pub mod read;
mod report;
mod sequence;
mod set_up;
mod state;
mod steps;
mod travel;
mod words;

use std::io::{self, Read, Seek};

pub use report::Outcome;

use crate::cl::{self, ReadSeek};
use crate::config::Config;
use crate::control::{self, Control};
use crate::diag::Diagnostic;
use crate::kinematics::{AnyMachine, Machine};
use crate::program::Units;
use compare::Checker;
use read::{Family, Reader};

/// A check: the set-up and the control of the program.
#[derive(Clone, Copy)]
pub struct Job<'a> {
    /// The set-up that the program was posted with.
    pub config: &'a Config,
    /// The control that runs the program.
    pub control: &'a dyn Control,
    /// Unit of CL data that states none.
    pub units: Option<Units>,
}

/// The reason why a program could not be checked.
#[derive(Debug, thiserror::Error)]
pub enum CheckError {
    /// The CL data cannot be read.
    #[error("cannot read the CL data: {0}")]
    Input(#[source] io::Error),
    /// The program cannot be read.
    #[error("cannot read the program: {0}")]
    Program(#[source] io::Error),
    /// Programs of this control cannot be read back, or the configuration does not suit control or machine.
    #[error("{0}")]
    Impossible(String),
}

/// Result of a check.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Checked {
    /// Figures and findings of the program.
    pub outcome: Outcome,
    /// First error of the CL data itself.
    pub fault: Option<Diagnostic>,
}

/// Compares a program with the CL data it was posted from.
///
/// # Errors
/// [`CheckError`] if the program cannot be compared. Errors of the program are findings of the outcome.
pub fn check<M: Machine>(
    job: &Job<'_>,
    mut input: impl Read + Seek,
    mut program: impl Read,
) -> Result<Checked, CheckError> {
    check_for(&M::default(), job, &mut input, &mut program)
}

/// [`check()`] for a machine whose type is known at run time only.
///
/// # Errors
/// Those of [`check()`].
pub fn check_for(
    machine: &dyn AnyMachine,
    job: &Job<'_>,
    input: &mut dyn ReadSeek,
    program: &mut dyn Read,
) -> Result<Checked, CheckError> {
    let family = family(job)?;
    let unfit = control::unfit(machine, job.control, job.config.demands());
    if !unfit.is_empty() {
        return Err(CheckError::Impossible(unfit.join("\n")));
    }
    let machine =
        job.config.set_up.machine_for(machine).map_err(|invalid| CheckError::Impossible(invalid.to_string()))?;
    let options = cl::ReadingOptions { units: job.units.or(job.config.cl_units), ..job.config.cl.clone() };
    let units = match job.config.output_units {
        Some(units) => units,
        None => set_up::units_of(input, &options).map_err(CheckError::Input)?.unwrap_or(Units::Millimetres),
    };
    let vocabulary = set_up::vocabulary(&*machine, family, job.config, units);
    let offsets = set_up::offsets(job.config, family);
    let mut reader = Reader::new(program, vocabulary);
    let mut checker = Checker::new(machine, job.config, family, units, offsets, cl::ClReader::new(input, options));
    while let Some((block, text)) = reader.next_block().map_err(CheckError::Program)? {
        checker.block(block, text).map_err(CheckError::Input)?;
    }
    Ok(checker.conclude(reader.lines()))
}

/// The blocks of a program as its control reads them, without comments.
///
/// # Errors
/// [`CheckError`] if programs of the control cannot be read back, or the program cannot be read.
pub fn blocks<M: Machine>(job: &Job<'_>, mut program: impl Read) -> Result<Vec<read::Block>, CheckError> {
    blocks_for(&M::default(), job, &mut program)
}

/// [`blocks`] for a machine whose type is known at run time only.
///
/// # Errors
/// Those of [`blocks`].
pub fn blocks_for(
    machine: &dyn AnyMachine,
    job: &Job<'_>,
    program: &mut dyn Read,
) -> Result<Vec<read::Block>, CheckError> {
    let family = family(job)?;
    let units = job.config.output_units.or(job.units).unwrap_or_default();
    let mut reader = Reader::new(program, set_up::vocabulary(machine, family, job.config, units));
    let mut blocks = Vec::new();
    while let Some((block, _)) = reader.next_block().map_err(CheckError::Program)? {
        blocks.push(block.clone());
    }
    Ok(blocks)
}

/// Writes the codes and words of a control that the check reads, as a table.
///
/// # Errors
/// Errors of the output.
pub(crate) fn codes(control: &dyn Control, out: &mut dyn io::Write) -> io::Result<()> {
    match Family::of_control(control.spellings().name) {
        Some(family) => read::table(family, out),
        None => writeln!(out, "the check cannot read programs of this control"),
    }
}

fn family(job: &Job<'_>) -> Result<Family, CheckError> {
    Family::of_control(job.control.spellings().name)
        .ok_or_else(|| CheckError::Impossible("the check cannot read programs of this control".to_owned()))
}

#[cfg(test)]
mod tests;
