//! The command line of a machine's binary: arguments, files, streams and exit status.
//!
//! Exit status 0: done. 1: the CL data has errors or a check has findings; there is no file of the final name. 2: the
//! run was not possible; a closed pipe is status 2 without a message. The program goes to standard output or to a file,
//! messages go to standard error.
//!
//! ```no_run
//! pp_runtime::machine! {
//!     /// A table that rotates about Z on a table that tilts about X.
//!     pub struct Trunnion;
//!     chain: C A | X Y Z;
//! }
//!
//! fn main() -> std::process::ExitCode {
//!     pp_runtime::cli::run::<Trunnion>()
//! }
//! ```

mod app;
mod args;
mod check;
mod cl_source;
mod closed;
mod excerpt;
mod explain;
mod explain_block;
mod inputs;
mod kinematics;
mod manual;
mod map;
mod messages;
mod new;
mod outcome;
mod output_file;
mod posting;
mod self_check;
#[cfg(feature = "simulate")]
mod simulate;
mod temporary;
#[cfg(test)]
mod tests;
mod text_file;
mod view;

use std::ffi::OsString;

use crate::cl;
use crate::config;
use crate::control::{self, Control};
use crate::kinematics::{AnyMachine, digest};
use crate::post::{Proof, prove};
use crate::view::drawing;

pub use app::{App, run, run_for, run_with};
pub use outcome::{Status, Streams};

use args::{Command, MessageFormat, ProofArgs};
use inputs::{read_config_file, refuse_unfit};
use messages::MessageWriter;
use outcome::{Failure, print};
use posting::PostFn;

/// Runs a command; `own`: controls besides those of this crate.
fn execute(
    machine: &dyn AnyMachine,
    own: &[&'static dyn Control],
    args: &[OsString],
    mut streams: Streams<'_>,
    post: PostFn<'_>,
) -> Status {
    let definition = || args::definition(machine.name(), own, args);
    let command = match args::parse(definition(), args) {
        Ok(cli) => cli.command,
        Err(error) => return print_usage(machine, &error, &mut streams),
    };
    let format = match &command {
        Command::Post(args) => args.set_up.message_format,
        Command::Check(args) => args.format(),
        Command::View(args) => args.set_up.message_format,
        Command::Report(args) => args.set_up.message_format,
        Command::ExplainBlock(args) => args.set_up.message_format,
        #[cfg(feature = "simulate")]
        Command::Simulate(args) => args.format(),
        Command::Config(_)
        | Command::Explain(_)
        | Command::Kinematics(_)
        | Command::New(_)
        | Command::Completions(_)
        | Command::Man(_) => MessageFormat::Human,
    };
    let result = match command {
        Command::Post(args) => posting::run(machine, &args, &mut streams, post),
        Command::Check(args) => check::run(machine, &args, &mut streams),
        Command::View(args) => view::run(machine, &args, &mut streams, post),
        Command::Report(args) => view::report(machine, &args, &mut streams, post),
        Command::ExplainBlock(args) => explain_block::run(machine, &args, &mut streams, post),
        #[cfg(feature = "simulate")]
        Command::Simulate(args) => simulate::run(machine, &args, &mut streams, post),
        Command::Config(args) => {
            let text = match args.schema {
                true => config::schema(machine, &config::starting_point(args.control())),
                false => config::print(machine, args.control()),
            };
            print(&mut streams, |out| out.write_all(text.as_bytes()))
        }
        Command::Explain(args) if args.latex => print(&mut streams, |out| explain::latex(machine, out)),
        Command::Explain(args) if args.drawing => print_drawing(machine, &args.proof, &mut streams),
        Command::Explain(args) if args.proof_program => print_proof_program(machine, &args.proof, &mut streams),
        Command::Explain(args) if args.states => {
            let control = args.proof.control();
            print(&mut streams, |out| control::write_table(control, out))
        }
        Command::Explain(args) if args.codes => {
            let control = args.proof.control();
            print(&mut streams, |out| match crate::check::read::Family::of_control(control.family()) {
                Some(family) => {
                    crate::check::codes(family, out)?;
                    let title = control.spellings().title;
                    control.effects().iter().try_for_each(|(text, effect)| {
                        writeln!(out, "{text:<16}  declared by {title} with the effect \"{}\"", effect.name())
                    })
                }
                None => writeln!(out, "the check cannot read programs for {}", control.family()),
            })
        }
        Command::Explain(args) if args.verify => print(&mut streams, |out| explain::verify(machine, out)),
        Command::Explain(args) if args.cl => print(&mut streams, |out| cl::list_words(out)),
        Command::Explain(_) => print(&mut streams, |out| explain::text(machine, out)),
        Command::Kinematics(args) => kinematics::run(machine, &args, &mut streams),
        Command::New(args) => new::run(&args, &mut streams),
        Command::Completions(args) => manual::completions(definition(), args.shell, &mut streams),
        Command::Man(args) => manual::pages(definition(), args.output.as_deref(), &mut streams),
    };
    result.unwrap_or_else(|failure| {
        let mut messages = MessageWriter::new(streams.errors, format);
        match failure {
            Failure::Reported => {}
            Failure::Reasons(code, reasons) => reasons.iter().for_each(|reason| messages.error(code, reason)),
            failure => messages.error(failure.code(), &failure.to_string()),
        }
        Status::NotRun
    })
}

/// Prints help and version to standard output, errors of the command line to standard error.
fn print_usage(machine: &dyn AnyMachine, error: &clap::Error, streams: &mut Streams<'_>) -> Status {
    let mut text = error.render().to_string();
    if error.kind() == clap::error::ErrorKind::DisplayVersion {
        text = format!("{} (kinematics {})\n", text.trim_end(), digest(machine));
    }
    if error.use_stderr() {
        // If standard error is closed, the message is lost.
        let _ = streams.errors.write_all(text.as_bytes());
        return Status::NotRun;
    }
    match streams.output.write_all(text.as_bytes()).and_then(|()| streams.output.flush()) {
        Ok(()) => Status::Done,
        Err(_) => Status::NotRun,
    }
}

/// Writes the drawing of the machine, with the dimensions of a configuration if there is one.
fn print_drawing(machine: &dyn AnyMachine, args: &ProofArgs, streams: &mut Streams<'_>) -> Result<Status, Failure> {
    let mut measured = machine.to_boxed();
    if args.config.is_some() {
        let mut messages = MessageWriter::new(streams.errors, MessageFormat::Human);
        let config = read_config_file(machine, args.config.as_deref(), args.control(), &mut messages)?;
        measured = config.set_up.machine_for(machine).map_err(|invalid| Failure::Argument(invalid.to_string()))?;
    }
    let text = drawing(&*measured).map_err(|error| Failure::Argument(error.to_string()))?;
    print(streams, |out| out.write_all(text.as_bytes()))
}

/// Writes the proof program; writes nothing if it cannot be planned.
fn print_proof_program(
    machine: &dyn AnyMachine,
    args: &ProofArgs,
    streams: &mut Streams<'_>,
) -> Result<Status, Failure> {
    let mut messages = MessageWriter::new(streams.errors, MessageFormat::Human);
    let config = read_config_file(machine, args.config.as_deref(), args.control(), &mut messages)?;
    refuse_unfit(machine, args.control(), &config)?;
    let proof = Proof { config: &config, control: args.control(), tool: args.tool, point_mm: args.point_mm };
    let text = prove(machine, &proof).map_err(Failure::Argument)?;
    print(streams, |out| out.write_all(&text))
}
