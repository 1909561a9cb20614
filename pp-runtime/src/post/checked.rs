//! The plain call: a program in memory, with the result of its check. No other file of `post` uses `check`.

use std::io::{Read, Seek, SeekFrom};

use crate::check::policy::EditPolicy;
use crate::check::{CheckError, CheckPolicy, Checked, check};
use crate::control::comments;
use crate::kinematics::Machine;

use super::{Job, PostError, ProgramEnd, Report, post};

/// A posted program and the result of its check.
#[derive(Debug)]
pub struct CheckedProgram {
    /// Diagnostics of the CL data, and figures of the program.
    pub report: Report,
    /// Result of the check; `None` if the CL data has errors, so that the program is not complete.
    pub checked: Option<Checked>,
    text: Vec<u8>,
}

impl CheckedProgram {
    /// The program, if it is complete and the check has found nothing.
    #[must_use]
    pub fn program(&self) -> Option<&[u8]> {
        let passed = self.checked.as_ref().is_some_and(Checked::passed);
        passed.then_some(&self.text)
    }

    /// The text as far as it was written, whatever the check has found: to be shown, not to be run.
    #[must_use]
    pub fn unchecked_text(&self) -> &[u8] {
        &self.text
    }
}

/// Posts CL data for a machine and checks the program, as the command `post` does. The result of the check is in
/// [`CheckedProgram::checked`], and with `program.checked` a comment at the end of a program without findings.
///
/// ```
/// use pp_runtime::config::Config;
/// use pp_runtime::control::LinuxCnc;
/// use pp_runtime::post::{Job, post_checked};
///
/// pp_runtime::machine! {
///     /// A trunnion table: C on A.
///     pub struct Trunnion;
///     chain: C A | X Y Z;
/// }
///
/// let cl = "UNITS/MM\nLOADTL/1\nSPINDL/3000,CLW\nFEDRAT/500,MMPM\nGOTO/0,0,5,0,0,1\nGOTO/20,0,5,0,0.6,0.8\nFINI\n";
/// let config = Config::default();
/// let job = Job { cl_name: "plate.cls", config: &config, control: &LinuxCnc, units: None };
/// let posted = post_checked::<Trunnion>(&job, &mut std::io::Cursor::new(cl))?;
/// let program = posted.program().expect("no findings");
/// assert!(program.ends_with(b"M2\n"));
/// # Ok::<(), pp_runtime::post::PostError>(())
/// ```
///
/// # Errors
/// Those of [`post`]; [`PostError::Unfit`] also if programs of the control cannot be checked.
pub fn post_checked<M: Machine>(job: &Job<'_>, input: &mut (impl Read + Seek)) -> Result<CheckedProgram, PostError> {
    let policy =
        job.config.check_policy::<M>(job.control, job.units).map_err(|reason| PostError::Unfit(reason.to_string()))?;
    // Nobody has edited it.
    let policy = CheckPolicy { edits: EditPolicy::default(), ..policy };
    let start = input.stream_position().map_err(PostError::Input)?;
    let mut text = Vec::new();
    let report = post::<M>(job, input, &mut text)?;
    if report.failed {
        return Ok(CheckedProgram { report, checked: None, text });
    }
    input.seek(SeekFrom::Start(start)).map_err(PostError::Input)?;
    let checked = check::<M>(&policy, input, &text[..]).map_err(|error| match error {
        CheckError::Input(error) => PostError::Input(error),
        CheckError::Program(error) => PostError::Output(error),
        CheckError::Impossible(reason) => PostError::Unfit(reason),
    })?;
    if job.config.control.program.checked && checked.passed() {
        let comments = comments(job.control, &checked.outcome.summary());
        let posted = std::mem::take(&mut text);
        ProgramEnd::of(job.control).write_with(&mut text, &posted, &comments).map_err(PostError::Output)?;
    }
    Ok(CheckedProgram { report, checked: Some(checked), text })
}
