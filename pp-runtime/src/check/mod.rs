//! The check of a program: reads the program back, computes tip and tool axis of each block, and compares them with the
//! CL data.
//!
//! `read` turns the text of a program into blocks; it knows the control and nothing else. `geometry` has the chain of
//! the machine as matrices at run time, not the generated functions. `expect` reads from the CL data what the program
//! must carry out, `rules` what a block must be like, `travel` has the limits of the axes. `compare` compares the two,
//! block by block. Memory does not grow with the length of the program.
//!
//! It shares no code with the planner and the controls: [`CheckPolicy`] is all that it reads of a job, and the
//! configuration builds it. A convention that both sides need is written twice, each with a test.
//!
//! ```
//! use std::io::Cursor;
//!
//! use pp_runtime::check::check;
//! use pp_runtime::config::Config;
//! use pp_runtime::control::LinuxCnc;
//! use pp_runtime::post::{Job, post_checked};
//! # pp_runtime::machine! {
//! #     /// A table that rotates about Z on a table that tilts about X.
//! #     pub struct Trunnion;
//! #     chain: C A | X Y Z;
//! # }
//!
//! let cl = "UNITS/MM\nLOADTL/1\nSPINDL/3000,CLW\nFEDRAT/500,MMPM\nGOTO/0,0,5,0,0,1\nGOTO/20,0,5,0,0.6,0.8\nFINI\n";
//! let config = Config::default();
//! let job = Job { cl_name: "plate.cls", config: &config, control: &LinuxCnc, units: None };
//! let posted = post_checked::<Trunnion>(&job, &mut Cursor::new(cl))?;
//! // Somebody edits the program.
//! let edited = String::from_utf8(posted.program().expect("no findings").to_vec())?.replace("X20", "X21");
//! let policy = config.check_policy::<Trunnion>(&LinuxCnc, None)?;
//! let checked = check::<Trunnion>(&policy, Cursor::new(cl), edited.as_bytes())?;
//! assert!(!checked.outcome.passed());
//! // The record that the block should carry out.
//! assert_eq!(checked.outcome.findings[0].location.line, 6);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod compare;
mod edits;
mod expect;
mod geometry;
pub(crate) mod policy;
pub mod read;
mod report;
mod rules;
mod stream;
pub(crate) mod tolerances;
mod travel;
mod vocabulary;

use std::io::{self, Read, Seek};

#[cfg(feature = "simulate")]
pub(crate) use geometry::angle_between;
pub use policy::CheckPolicy;
pub use report::{Finding, Outcome};
#[cfg(feature = "simulate")]
pub(crate) use stream::Leg;
pub use stream::{ExecutedBlock, Observer};
pub(crate) use vocabulary::faults_of_lines;

use crate::cl::{ClData, FromHere, ReadSeek};
use crate::diag::Diagnostic;
use crate::kinematics::{AnyMachine, Machine};
use crate::program::Units;
use compare::Checker;
use policy::EditPolicy;
use read::{PlacedLines, Reader, TextPieces};

/// The reason why a program could not be checked.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum CheckError {
    /// The CL data cannot be read.
    #[error("cannot read the CL data: {0}")]
    Input(#[source] io::Error),
    /// The program cannot be read.
    #[error("cannot read the program: {0}")]
    Program(#[source] io::Error),
    /// The dimensions of the set-up do not suit the machine.
    #[error("{0}")]
    Impossible(String),
}

/// Result of a check.
#[derive(Debug, Clone, PartialEq, Default)]
#[non_exhaustive]
pub struct Checked {
    /// Figures and findings of the program.
    pub outcome: Outcome,
    /// First error of the CL data itself.
    pub fault: Option<Diagnostic>,
}

impl Checked {
    /// Whether the program carries out its CL data, which has no error.
    #[must_use]
    pub fn passed(&self) -> bool {
        self.fault.is_none() && self.outcome.passed()
    }
}

/// Compares a program with the CL data it was posted from.
///
/// # Errors
/// [`CheckError`] if the program cannot be compared. Errors of the program are findings of the outcome.
pub fn check<M: Machine>(
    policy: &CheckPolicy,
    mut input: impl Read + Seek,
    mut program: impl Read,
) -> Result<Checked, CheckError> {
    check_for(&M::default(), policy, &mut input, &mut program)
}

/// [`check()`] for a machine whose type is known at run time only.
///
/// # Errors
/// Those of [`check()`].
pub(crate) fn check_for(
    machine: &dyn AnyMachine,
    policy: &CheckPolicy,
    input: &mut dyn ReadSeek,
    mut program: &mut dyn Read,
) -> Result<Checked, CheckError> {
    let mut data = FromHere::new(input).map_err(CheckError::Input)?;
    check_data(machine, policy, &mut data, &mut program, None)
}

/// `check_for` that shows every block to an observer as it is executed.
///
/// # Errors
/// Those of [`check()`].
pub fn check_observed(
    machine: &dyn AnyMachine,
    policy: &CheckPolicy,
    input: &mut dyn ReadSeek,
    mut program: &mut dyn Read,
    observer: &mut dyn Observer,
) -> Result<Checked, CheckError> {
    let mut data = FromHere::new(input).map_err(CheckError::Input)?;
    check_data(machine, policy, &mut data, &mut program, Some(observer))
}

/// [`check_for`] and [`check_observed`] for CL data that may be read ahead.
///
/// # Errors
/// Those of [`check()`].
pub(crate) fn check_data(
    machine: &dyn AnyMachine,
    policy: &CheckPolicy,
    data: &mut dyn ClData,
    program: &mut dyn TextPieces,
    mut observer: Option<&mut dyn Observer>,
) -> Result<Checked, CheckError> {
    if !policy.edits.edits.is_empty() {
        return check_edited(machine, policy, data, program, observer);
    }
    let machine = policy.set_up.machine_for(machine).map_err(|invalid| CheckError::Impossible(invalid.to_string()))?;
    let units = match policy.output_units {
        Some(units) => units,
        None => expect::units_of(data, &policy.reading).map_err(CheckError::Input)?.unwrap_or_default(),
    };
    let vocabulary = vocabulary::vocabulary(&*machine, policy, units);
    let lines = PlacedLines::of(vocabulary.clone());
    let mut reader = Reader::new(program, vocabulary);
    let events = data.events(policy.reading.clone()).map_err(CheckError::Input)?;
    let mut checker = Checker::new(machine, policy, units, events, lines);
    while let Some((block, text)) = reader.next_block().map_err(CheckError::Program)? {
        match &mut observer {
            Some(observer) => checker.observed(block, text, *observer),
            None => checker.block(block, text),
        }
        .map_err(CheckError::Input)?;
    }
    Ok(checker.conclude(reader.lines()))
}

/// [`check_data`] of a program with edits that are meant: it is compared as it was posted, and then with that.
fn check_edited(
    machine: &dyn AnyMachine,
    policy: &CheckPolicy,
    data: &mut dyn ClData,
    program: &mut dyn TextPieces,
    observer: Option<&mut dyn Observer>,
) -> Result<Checked, CheckError> {
    let (mut edited, mut piece) = (Vec::new(), Vec::new());
    loop {
        program.next_piece(&mut piece).map_err(CheckError::Program)?;
        if piece.is_empty() {
            break;
        }
        edited.extend_from_slice(&piece);
    }
    let posted = edits::take_back(&edited, &policy.edits, policy.family);
    let plain = CheckPolicy { edits: EditPolicy::default(), ..policy.clone() };
    let mut checked = check_data(machine, &plain, data, &mut &posted.text[..], observer)?;
    let units = policy.output_units.or(policy.reading.units).unwrap_or_default();
    let vocabulary = vocabulary::vocabulary(machine, policy, units);
    let concluded = posted.conclude(&edited, &vocabulary, &policy.edits, &mut checked.outcome);
    concluded.map_err(CheckError::Program)?;
    Ok(checked)
}

/// The blocks of a program as its control reads them, without comments.
///
/// # Errors
/// [`CheckError`] if the program cannot be read.
pub fn blocks<M: Machine>(policy: &CheckPolicy, mut program: impl Read) -> Result<Vec<read::Block>, CheckError> {
    blocks_for(&M::default(), policy, &mut program)
}

/// [`blocks`] for a machine whose type is known at run time only.
///
/// # Errors
/// Those of [`blocks`].
pub(crate) fn blocks_for(
    machine: &dyn AnyMachine,
    policy: &CheckPolicy,
    mut program: &mut dyn Read,
) -> Result<Vec<read::Block>, CheckError> {
    let units: Units = policy.output_units.or(policy.reading.units).unwrap_or_default();
    let mut reader = Reader::new(&mut program as &mut dyn TextPieces, vocabulary::vocabulary(machine, policy, units));
    let mut blocks = Vec::new();
    while let Some((block, _)) = reader.next_block().map_err(CheckError::Program)? {
        blocks.push(block.clone());
    }
    Ok(blocks)
}

/// Writes the codes and words of a family of controls that the check reads, as a table.
///
/// # Errors
/// Errors of the output.
pub(crate) fn codes(family: read::Family, out: &mut dyn io::Write) -> io::Result<()> {
    read::table(family, out)
}

#[cfg(test)]
mod tests;
