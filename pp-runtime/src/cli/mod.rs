//! The command line of a machine's binary: arguments, files, streams and exit status.
//!
//! Status 0: done. 1: the CL data has errors; there is no file of the final name. 2: could not run; a closed pipe is
//! status 2 without a message. The program goes to standard output or a file, everything else to standard error.

mod args;
mod check;
mod cl_source;
mod excerpt;
mod explain;
mod explain_block;
mod inputs;
mod map;
mod messages;
mod outcome;
mod output_file;
mod posting;
mod self_check;
#[cfg(test)]
mod tests;

use std::ffi::OsString;
use std::io::{self, IsTerminal as _};
use std::process::ExitCode;

use crate::cl;
use crate::config;
use crate::kinematics::{AnyMachine, Machine};
use crate::post::{Proof, post_for, prove};

use args::{Command, MessageFormat, ProofArgs};
use inputs::{fit, read_file};
use messages::Messages;
use outcome::{Failure, Status, Streams, print};
use posting::Post;

/// Runs the command line of the machine `M`: the whole of a machine's `main`.
#[must_use]
pub fn run<M: Machine>() -> ExitCode {
    run_for(&M::default())
}

/// [`run`] for a machine whose type is not known.
#[must_use]
pub fn run_for(machine: &dyn AnyMachine) -> ExitCode {
    let args: Vec<OsString> = std::env::args_os().collect();
    let terminal = io::stderr().is_terminal();
    let (mut input, mut output, mut errors) = (io::stdin(), io::stdout(), io::stderr());
    let streams = Streams { input: &mut input, output: &mut output, errors: &mut errors, terminal };
    let status =
        execute(machine, &args, streams, &|job, source, sink, account| post_for(machine, job, source, sink, account));
    ExitCode::from(status as u8)
}

fn execute(machine: &dyn AnyMachine, args: &[OsString], mut streams: Streams<'_>, post: Post<'_>) -> Status {
    let command = match args::parse(machine.name(), args) {
        Ok(cli) => cli.command,
        Err(error) => return usage(&error, &mut streams),
    };
    let format = match &command {
        Command::Post(args) => args.set_up.message_format,
        Command::Check(args) => args.format(),
        Command::ExplainBlock(args) => args.set_up.message_format,
        Command::Config(_) | Command::Explain(_) => MessageFormat::Human,
    };
    let result = match command {
        Command::Post(args) => posting::run(machine, &args, &mut streams, post),
        Command::Check(args) => check::run(machine, &args, &mut streams),
        Command::ExplainBlock(args) => explain_block::run(machine, &args, &mut streams, post),
        Command::Config(args) => {
            let config = config::starting_point(args.control());
            let text = if args.schema { config::schema(machine, &config) } else { config::print(machine, &config) };
            print(&mut streams, |out| out.write_all(text.as_bytes()))
        }
        Command::Explain(args) if args.latex => print(&mut streams, |out| explain::latex(machine, out)),
        Command::Explain(args) if args.proof_program => prove_machine(machine, &args.proof, &mut streams),
        Command::Explain(args) if args.cl => print(&mut streams, |out| cl::list_words(out)),
        Command::Explain(_) => print(&mut streams, |out| explain::text(machine, out)),
    };
    result.unwrap_or_else(|failure| {
        if !matches!(failure, Failure::Said) {
            Messages::new(streams.errors, format).error(&failure.to_string());
        }
        Status::NotRun
    })
}

/// Help and version go to standard output, mistakes to standard error.
fn usage(error: &clap::Error, streams: &mut Streams<'_>) -> Status {
    let text = error.render().to_string();
    if error.use_stderr() {
        // Where standard error is closed the message is lost.
        let _ = streams.errors.write_all(text.as_bytes());
        return Status::NotRun;
    }
    match streams.output.write_all(text.as_bytes()).and_then(|()| streams.output.flush()) {
        Ok(()) => Status::Done,
        Err(_) => Status::NotRun,
    }
}

/// Writes the program that proves the kinematics at the machine; nothing of it where it cannot be planned.
fn prove_machine(machine: &dyn AnyMachine, args: &ProofArgs, streams: &mut Streams<'_>) -> Result<Status, Failure> {
    let mut messages = Messages::new(streams.errors, MessageFormat::Human);
    let config = read_file(machine, args.config.as_deref(), args.control(), &mut messages)?;
    fit(machine, args.control(), &config)?;
    let proof = Proof { config: &config, control: args.control(), tool: args.tool, point: args.point };
    let text = prove(machine, &proof).map_err(Failure::Argument)?;
    print(streams, |out| out.write_all(&text))
}
