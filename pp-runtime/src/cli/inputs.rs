//! Inputs of a run: the configuration, which has to suit the control, and the CL data.

use std::borrow::Cow;
use std::io::Read;
use std::path::{Path, PathBuf};

use crate::config::{self, Config, EditOptions};
use crate::control::Control;
use crate::diag::Diagnostic;
use crate::diag::code::{config as config_code, control as control_code};
use crate::kinematics::AnyMachine;

use super::args::{MessageFormat, NamedFile, SetUpArgs};
use super::cl_source::{ClSource, LONG_INPUT_BYTES, same_file};
use super::messages::MessageWriter;
use super::outcome::{Failure, is_standard};
use super::text_file::read_text;

/// The configuration of a run: defaults of the control, then the file, then the command line; the later takes
/// precedence.
pub(crate) fn read_config(
    machine: &dyn AnyMachine,
    args: &SetUpArgs,
    messages: &mut MessageWriter<'_>,
) -> Result<Config, Failure> {
    let mut config = read_config_file(machine, args.config.as_deref(), args.control(), messages)?;
    args.apply(machine, &mut config).map_err(Failure::Argument)?;
    refuse_unfit(machine, args.control(), &config)?;
    Ok(config)
}

/// Refuses a configuration that asks for something that control or machine cannot do.
pub(crate) fn refuse_unfit(machine: &dyn AnyMachine, control: &dyn Control, config: &Config) -> Result<(), Failure> {
    let unfit = config.unfit(machine, control);
    if unfit.is_empty() { Ok(()) } else { Err(Failure::Reasons(control_code::UNFIT, unfit)) }
}

/// The configuration of a file over the defaults of a control.
pub(crate) fn read_config_file(
    machine: &dyn AnyMachine,
    path: Option<&Path>,
    control: &dyn Control,
    messages: &mut MessageWriter<'_>,
) -> Result<Config, Failure> {
    let start = config::starting_point(control);
    match path {
        // The defaults are no configuration of a machine with required dimensions.
        None => start.read_over(machine, "").map_err(|faults| {
            let with_help = |fault: &Diagnostic| match &fault.help {
                Some(help) => format!("{}; {help} (`--config`)", fault.text),
                None => fault.text.clone(),
            };
            let code = faults.first().map_or(config_code::DIMENSIONS, |fault| fault.code);
            Failure::Reasons(code, faults.iter().map(with_help).collect())
        }),
        Some(path) => {
            let text = read_text(path, "configuration")?;
            let mut config = start.read_over(machine, &text).map_err(|faults| {
                messages.diagnostics(&path.display().to_string(), &mut text.as_bytes(), &faults);
                Failure::Reported
            })?;
            config.set_up.solids.folder = path.parent().unwrap_or(Path::new("")).to_owned();
            Ok(config)
        }
    }
}

/// The edits of a file of their own, which has the table `[check]` alone.
pub(crate) fn read_edits(
    machine: &dyn AnyMachine,
    path: &Path,
    messages: &mut MessageWriter<'_>,
) -> Result<EditOptions, Failure> {
    let text = read_text(path, "list of edits")?;
    config::read_edits(machine, &text).map_err(|faults| {
        messages.diagnostics(&path.display().to_string(), &mut text.as_bytes(), &faults);
        Failure::Reported
    })
}

/// Opens the CL data. Standard input is copied to a temporary file, so that it can be read twice.
pub(crate) fn open_cl_data(path: &Path, args: &SetUpArgs, input: &mut dyn Read) -> Result<ClSource, Failure> {
    let source = if is_standard(path) { ClSource::spool(input, path)? } else { ClSource::open(path)? };
    Ok(source.read_ahead(args.threads() > 1))
}

/// Times that the CL data is read to post it: survey, rehearsal where axes have clamps, program.
pub(crate) fn posting_passes(config: &Config) -> u64 {
    if config.motion.rotaries.clamp.is_empty() { 2 } else { 3 }
}

/// Shows the progress of a run that reads the CL data so often, on a terminal.
pub(crate) fn show_progress(source: &mut ClSource, terminal: bool, args: &SetUpArgs, passes: u64) {
    if terminal && !args.quiet && args.message_format == MessageFormat::Human {
        source.show_progress(passes, LONG_INPUT_BYTES);
    }
}

/// Shows the progress of a simulation, which takes long for any CL data.
#[cfg(feature = "simulate")]
pub(crate) fn show_simulation(source: &mut ClSource, terminal: bool, args: &SetUpArgs) {
    if terminal && !args.quiet && args.message_format == MessageFormat::Human {
        source.show_progress(2, 0);
    }
}

/// The CL data as an input file, unless it is standard input.
pub(crate) fn cl_file(path: &Path) -> Option<NamedFile<'_>> {
    (!is_standard(path)).then_some((path, "CL data"))
}

/// Refuses an output file that would replace an input file or another output file. Inputs are the configuration, if it
/// is a file, the files of its solids, and `read`.
pub(crate) fn refuse_overwriting(
    config_file: Option<&Path>,
    config: &Config,
    read: &[NamedFile<'_>],
    written: &[NamedFile<'_>],
) -> Result<(), Failure> {
    let solids: Vec<PathBuf> = config.set_up.solids.paths().collect();
    let of_config = config_file.map(|path| (path, "configuration"));
    let of_config: Vec<NamedFile<'_>> =
        of_config.into_iter().chain(solids.iter().map(|path| (path.as_path(), "solid"))).collect();
    for (index, (path, _)) in written.iter().enumerate() {
        let others = read.iter().chain(&of_config).chain(&written[..index]);
        if let Some((other, what)) = others.into_iter().find(|(other, _)| same_file(path, other)) {
            return Err(Failure::Overwrites(path.display().to_string(), format!("the {what} {}", other.display())));
        }
    }
    Ok(())
}

/// Name of the CL data in the header: the file without its folder, so that the program does not depend on where it was
/// posted.
pub(crate) fn cl_name(path: &Path) -> Cow<'_, str> {
    if is_standard(path) { "standard input".into() } else { path.file_name().unwrap_or_default().to_string_lossy() }
}
