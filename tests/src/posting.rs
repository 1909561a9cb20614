//! CL data posted in memory with a configuration of the test, and programs compared with it by their own check.

use std::io::Cursor;

use pp_runtime::check::check;
use pp_runtime::config::Config;
use pp_runtime::control::Control;
use pp_runtime::kinematics::Machine;
use pp_runtime::post::{Job, PostError, Report, post};

/// The text of a program and the report on it, whether or not the CL data can be posted.
///
/// # Errors
/// [`PostError`] if the run is not possible.
///
/// # Panics
/// If the program is not text.
pub fn written<M: Machine>(
    config: &Config,
    control: &'static dyn Control,
    cl: &str,
) -> Result<(String, Report), PostError> {
    let job = Job { cl_name: "part.cls", config, control, units: None };
    let mut program = Vec::new();
    let report = post::<M>(&job, &mut Cursor::new(cl), &mut program)?;
    Ok((String::from_utf8(program).expect("text"), report))
}

/// The program, which passes its check.
///
/// # Panics
/// If it cannot be posted, or the check finds anything.
pub fn posted<M: Machine>(config: &Config, control: &'static dyn Control, cl: &str) -> String {
    let (program, report) = written::<M>(config, control, cl).expect("it can run");
    assert!(!report.failed, "{program}\n{:?}", report.diagnostics);
    let found = findings::<M>(config, control, cl, &program);
    assert!(found.is_empty(), "{program}\n{found:?}");
    program
}

/// What the check finds in a program, and the fault of its CL data.
///
/// # Panics
/// If the check is not possible.
#[must_use]
pub fn findings<M: Machine>(config: &Config, control: &dyn Control, cl: &str, program: &str) -> Vec<String> {
    let policy = config.check_policy::<M>(control, None).expect("it can be checked");
    let checked = check::<M>(&policy, Cursor::new(cl), program.as_bytes()).expect("it can be read");
    let fault = checked.fault.map(|fault| fault.text);
    checked.outcome.findings.into_iter().map(|finding| finding.text).chain(fault).collect()
}

/// Lines of a program without the numbers that a control puts before every line.
#[must_use]
pub fn bare(program: &str) -> Vec<&str> {
    program.lines().map(|line| line.trim_start_matches(|c: char| c.is_ascii_digit()).trim_start()).collect()
}

/// Lines as a program; a control that numbers every line has no gap in the numbers.
#[must_use]
pub fn renumbered(control: &dyn Control, lines: &[&str]) -> String {
    let numbered = control.spellings().numbers_every_line;
    let (mut number, mut goes_on) = (0, false);
    let lines = lines.iter().map(|line| {
        let starts = !std::mem::replace(&mut goes_on, numbered && line.ends_with('~'));
        let (mark, words) = line.strip_prefix('/').map_or(("", *line), |words| ("/", words));
        let text = if numbered && starts { format!("{mark}{number} {words}\n") } else { format!("{line}\n") };
        number += u32::from(starts);
        text
    });
    lines.collect()
}
