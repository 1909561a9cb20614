//! `check IN.cls OUT.nc`: compares a program that was posted earlier, or edited by hand, with its CL data.

use std::fs::File;
use std::io::{self, Read, Seek as _};
use std::path::Path;

use serde::Serialize;

use crate::check::{CheckError, Checked, check_data};
use crate::diag::code::control;
use crate::kinematics::AnyMachine;

use super::args::{CheckArgs, MessageFormat};
use super::cl_source::ClSource;
use super::inputs::{open_cl_data, read_config, read_edits, show_progress};
use super::messages::MessageWriter;
use super::outcome::{Failure, Status, Streams, is_standard, print};

/// The figures of a check as JSON.
#[derive(Serialize)]
struct CheckFigures {
    passed: bool,
    findings: u64,
    blocks: u64,
    tip_mm: f64,
    axis_deg: f64,
    path_mm: f64,
    tolerance_mm: f64,
    outside_limits: u64,
    /// Line of the program from which on it was not compared, because the CL data has an error.
    #[serde(skip_serializing_if = "Option::is_none")]
    not_compared_from: Option<u64>,
    /// Edits of the program that are permitted.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    permitted_edits: Vec<String>,
}

pub(crate) fn run(machine: &dyn AnyMachine, args: &CheckArgs, streams: &mut Streams<'_>) -> Result<Status, Failure> {
    let mut messages = MessageWriter::new(streams.errors, args.format());
    let mut config = read_config(machine, &args.set_up, &mut messages)?;
    if let Some(path) = &args.edits {
        let mut edits = read_edits(machine, path, &mut messages)?;
        config.check.edits.append(&mut edits.edits);
        config.check.feed_factor = edits.feed_factor.or(config.check.feed_factor);
        config.check.speed_factor = edits.speed_factor.or(config.check.speed_factor);
    }
    let mut source = open_cl_data(&args.input, &args.set_up, streams.input)?;
    let name = source.name().to_owned();
    let mut program: Box<dyn Read + '_> = match (is_standard(&args.program), is_standard(&args.input)) {
        (true, true) => {
            return Err(Failure::Argument("CL data and program cannot both come from standard input".to_owned()));
        }
        (true, false) => Box::new(&mut *streams.input),
        (false, _) => Box::new(File::open(&args.program).map_err(|error| Failure::unreadable(&args.program, error))?),
    };
    let policy = config
        .check_policy_for(machine, args.set_up.control(), None)
        .map_err(|error| Failure::Argument(error.to_string()))?;
    show_progress(&mut source, streams.terminal, &args.set_up, 1);
    let checked = check_data(machine, &policy, &mut source, &mut program, None)
        .map_err(|error| failure(error, &name, &args.program))?;
    drop(program);
    source.hide_progress();
    if let Some(what) = source.changed_since_opened() {
        return Err(Failure::Changed(name, what));
    }
    report(&checked, &name, &mut source, Some(&args.program.to_string_lossy()), &mut messages)
        .map_err(|error| Failure::Unreadable(name.clone(), error))?;
    checked.outcome.lines().iter().for_each(|line| messages.note(line));
    let passed = checked.passed();
    if args.format() == MessageFormat::Json {
        let figures = figures(&checked, passed);
        print(streams, |out| {
            serde_json::to_writer(&mut *out, &figures)?;
            out.write_all(b"\n")
        })?;
    }
    Ok(if passed { Status::Done } else { Status::Rejected })
}

/// The reason why a program could not be compared.
pub(crate) fn failure(error: CheckError, name: &str, program: &Path) -> Failure {
    match error {
        CheckError::Input(error) => Failure::Unreadable(name.to_owned(), error),
        CheckError::Program(error) => Failure::unreadable(program, error),
        CheckError::Impossible(text) => Failure::Reasons(control::UNFIT, vec![text]),
    }
}

/// Writes the first error of the CL data, and the findings in the program.
pub(crate) fn report(
    checked: &Checked,
    name: &str,
    source: &mut ClSource,
    program: Option<&str>,
    messages: &mut MessageWriter<'_>,
) -> io::Result<()> {
    if let Some(fault) = &checked.fault {
        source.rewind()?;
        messages.diagnostics(name, source, std::slice::from_ref(fault));
    }
    if !checked.outcome.findings.is_empty() {
        source.rewind()?;
        messages.findings(name, source, program, &checked.outcome.findings);
    }
    Ok(())
}

fn figures(checked: &Checked, passed: bool) -> CheckFigures {
    let outcome = &checked.outcome;
    CheckFigures {
        passed,
        findings: outcome.count,
        blocks: outcome.blocks,
        tip_mm: outcome.tip_mm,
        axis_deg: outcome.axis_rad.to_degrees(),
        path_mm: outcome.path_mm,
        tolerance_mm: outcome.tolerance_mm,
        outside_limits: outcome.outside_limits,
        not_compared_from: outcome.not_compared_from,
        permitted_edits: outcome.permitted.iter().map(ToString::to_string).collect(),
    }
}
