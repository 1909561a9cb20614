//! `kinematics`: kinematics of the machine for its control, as files or as a sheet to compare.

use std::fs;
use std::io::Write as _;
use std::path::{Path, PathBuf};

use crate::config::Config;
use crate::control::{CONTROLS, by_name};
use crate::kinematics::AnyMachine;
use crate::transformation::{NotExpressible, c_header, compare_sheet, identifier, linuxcnc, machine_identifier};

use super::args::{KinematicsArgs, MessageFormat, Target};
use super::inputs::{read_config_file, refuse_overwriting};
use super::messages::MessageWriter;
use super::outcome::{Failure, Status, Streams, is_standard, print};
use super::output_file::OutputFile;

/// Writes the files of a target.
pub(crate) fn run(
    machine: &dyn AnyMachine,
    args: &KinematicsArgs,
    streams: &mut Streams<'_>,
) -> Result<Status, Failure> {
    let mut messages = MessageWriter::new(streams.errors, MessageFormat::Human);
    let control = match args.target() {
        Target::Sheet(sheet) => by_name(sheet.name()),
        Target::C | Target::LinuxCnc => None,
    };
    let control = control.unwrap_or(CONTROLS[0]);
    let config = read_config_file(machine, args.config.as_deref(), control, &mut messages)?;
    let set_up = config.set_up.machine_for(machine).map_err(|invalid| Failure::Argument(invalid.to_string()))?;
    let refused = |reason: NotExpressible| Failure::Argument(reason.to_string());
    match args.target() {
        Target::C => {
            let prefix = match &args.output {
                Some(path) if !is_standard(path) => identifier(&path.file_stem().unwrap_or_default().to_string_lossy()),
                _ => machine_identifier(machine),
            };
            let header = c_header(&*set_up, &prefix.map_err(refused)?).map_err(refused)?;
            write(args, &config, &header, streams)
        }
        Target::LinuxCnc => {
            let Some(folder) = args.output.as_deref().filter(|path| !is_standard(path)) else {
                return Err(Failure::Argument("--linuxcnc writes several files: give their folder, -o DIR".to_owned()));
            };
            let written = write_module(&*set_up, &config, folder, refused)?;
            for path in &written {
                messages.note(&format!("written: {}", path.display()));
            }
            messages.note("read README.md first: steps to try the module, and to set it up at the machine");
            Ok(Status::Done)
        }
        Target::Sheet(control) => {
            let sheet = compare_sheet(&*set_up, &config, control).map_err(refused)?;
            if let Some(path) = args.output.as_deref().filter(|path| !is_standard(path) && path.is_file()) {
                return Err(Failure::Argument(format!(
                    "{} exists, and may hold values that were entered at the machine: give a new name",
                    path.display()
                )));
            }
            write(args, &config, &sheet, streams)
        }
    }
}

/// One file, or standard output.
fn write(args: &KinematicsArgs, config: &Config, text: &str, streams: &mut Streams<'_>) -> Result<Status, Failure> {
    let Some(path) = args.output.as_deref().filter(|path| !is_standard(path)) else {
        return print(streams, |out| out.write_all(text.as_bytes()));
    };
    refuse_overwriting(args.config.as_deref(), config, &[], &[(path, "output")])?;
    write_file(path, text)?;
    Ok(Status::Done)
}

fn write_file(path: &Path, text: &str) -> Result<(), Failure> {
    let failed = |error| Failure::unwritable(path, error);
    let mut file = OutputFile::create(path).map_err(failed)?;
    file.writer().write_all(text.as_bytes()).map_err(failed)?;
    file.finish(|_| false).map_err(failed)?;
    Ok(())
}

/// All files of the module, or none: values that were measured and written into a file are never replaced.
fn write_module(
    machine: &dyn AnyMachine,
    config: &Config,
    folder: &Path,
    refused: impl Fn(NotExpressible) -> Failure,
) -> Result<Vec<PathBuf>, Failure> {
    let files = linuxcnc::files(machine, config).map_err(refused)?;
    let paths: Vec<PathBuf> = files.iter().map(|file| folder.join(&file.name)).collect();
    if let Some(existing) = paths.iter().find(|path| path.exists()) {
        return Err(Failure::Argument(format!(
            "{} exists, and may hold values that were measured: give a new folder, then compare the two",
            existing.display()
        )));
    }
    fs::create_dir_all(folder).map_err(|error| Failure::unwritable(folder, error))?;
    for (path, file) in paths.iter().zip(&files) {
        write_file(path, &file.text)?;
    }
    Ok(paths)
}
