//! The command line of a machine's binary: arguments, files, streams and exit status.
//!
//! Status 0: done. 1: the CL data has errors; nothing stands under the final name. 2: could not run; a closed pipe is
//! status 2 without a message. The program goes to standard output or a file, everything else to standard error.

mod args;
mod check;
mod excerpt;
mod explain;
mod explain_block;
mod map;
mod messages;
mod posting;
mod self_check;
mod source;
mod target;
#[cfg(test)]
mod tests;

use std::borrow::Cow;
use std::ffi::OsString;
use std::fs;
use std::io::{self, BufWriter, IsTerminal as _, Read, Write};
use std::path::Path;
use std::process::ExitCode;

use crate::cl;
use crate::config::{self, Config};
use crate::control::{self, Control};
use crate::kinematics::Machine;
use crate::post::{Proof, post_with_account, prove};

use args::{Command, MessageFormat, ProofArgs, SetUpArgs};
use messages::Messages;
use posting::Post;
use source::Source;

/// Runs the command line of the machine `M`: the whole of a machine's `main`.
#[must_use]
pub fn run<M: Machine>() -> ExitCode {
    let args: Vec<OsString> = std::env::args_os().collect();
    let terminal = io::stderr().is_terminal();
    let (mut input, mut output, mut errors) = (io::stdin(), io::stdout(), io::stderr());
    let streams = Streams { input: &mut input, output: &mut output, errors: &mut errors, terminal };
    let status =
        execute::<M>(&args, streams, &|job, source, sink, account| post_with_account::<M>(job, source, sink, account));
    ExitCode::from(status as u8)
}

/// How a run ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[repr(u8)]
enum Status {
    Done = 0,
    Rejected = 1,
    NotRun = 2,
}

/// The standard streams.
struct Streams<'a> {
    input: &'a mut dyn Read,
    output: &'a mut dyn Write,
    errors: &'a mut dyn Write,
    /// `errors` is a terminal.
    terminal: bool,
}

/// Why there is no result.
#[derive(Debug, thiserror::Error)]
enum Failure {
    #[error("cannot read {0}: {1}")]
    Unreadable(String, io::Error),
    #[error("cannot write {0}: {1}")]
    Unwritable(String, io::Error),
    #[error("{0} {1}: post it again")]
    Disturbed(String, &'static str),
    #[error("{0} would overwrite {1}")]
    Overwrites(String, String),
    #[error("{0}")]
    Argument(String),
    /// Everything has been said.
    #[error("")]
    Said,
}

impl Failure {
    fn unreadable(path: &Path, error: io::Error) -> Self {
        let name = if is_standard(path) { "standard input".to_owned() } else { path.display().to_string() };
        Self::Unreadable(name, error)
    }

    fn unwritable(path: &Path, error: io::Error) -> Self {
        // Whoever closed the pipe does not want to hear about it.
        if error.kind() == io::ErrorKind::BrokenPipe {
            return Self::Said;
        }
        let name = if is_standard(path) { "standard output".to_owned() } else { path.display().to_string() };
        Self::Unwritable(name, error)
    }
}

fn execute<M: Machine>(args: &[OsString], mut streams: Streams<'_>, post: Post<'_>) -> Status {
    let command = match args::parse(M::NAME, args) {
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
        Command::Post(args) => posting::run::<M>(&args, &mut streams, post),
        Command::Check(args) => check::run::<M>(&args, &mut streams),
        Command::ExplainBlock(args) => explain_block::run::<M>(&args, &mut streams, post),
        Command::Config(args) => {
            let config = config::starting_point(args.control());
            let text = if args.schema { config::schema::<M>(&config) } else { config::print::<M>(&config) };
            print(&mut streams, |out| out.write_all(text.as_bytes()))
        }
        Command::Explain(args) if args.latex => print(&mut streams, explain::latex::<M>),
        Command::Explain(args) if args.proof_program => prove_machine::<M>(&args.proof, &mut streams),
        Command::Explain(args) if args.cl => print(&mut streams, |out| cl::list_words(out)),
        Command::Explain(_) => print(&mut streams, explain::text::<M>),
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
        // Where standard error is closed there is nobody to tell.
        let _ = streams.errors.write_all(text.as_bytes());
        return Status::NotRun;
    }
    match streams.output.write_all(text.as_bytes()).and_then(|()| streams.output.flush()) {
        Ok(()) => Status::Done,
        Err(_) => Status::NotRun,
    }
}

fn print(streams: &mut Streams<'_>, write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<Status, Failure> {
    let mut out = BufWriter::new(&mut *streams.output);
    write(&mut out).and_then(|()| out.flush()).map_err(|error| Failure::unwritable(Path::new("-"), error))?;
    Ok(Status::Done)
}

/// Writes the program that proves the kinematics at the machine; nothing of it where it cannot be planned.
fn prove_machine<M: Machine>(args: &ProofArgs, streams: &mut Streams<'_>) -> Result<Status, Failure> {
    let mut messages = Messages::new(streams.errors, MessageFormat::Human);
    let config = read_file::<M>(args.config.as_deref(), args.control(), &mut messages)?;
    fit::<M>(args.control(), &config)?;
    let proof = Proof { config: &config, control: args.control(), tool: args.tool, point: args.point };
    let text = prove::<M>(&proof).map_err(Failure::Argument)?;
    print(streams, |out| out.write_all(&text))
}

fn read_config<M: Machine>(args: &SetUpArgs, messages: &mut Messages<'_>) -> Result<Config, Failure> {
    let mut config = read_file::<M>(args.config.as_deref(), args.control(), messages)?;
    args.apply::<M>(&mut config).map_err(Failure::Argument)?;
    fit::<M>(args.control(), &config)?;
    Ok(config)
}

/// Whether the control can do what the configuration asks for.
fn fit<M: Machine>(control: &dyn Control, config: &Config) -> Result<(), Failure> {
    let unfit = control::unfit::<M>(control, config.demands());
    if unfit.is_empty() { Ok(()) } else { Err(Failure::Argument(unfit.join("\n"))) }
}

/// The configuration of a file on top of the defaults of a control.
fn read_file<M: Machine>(
    path: Option<&Path>,
    control: &dyn Control,
    messages: &mut Messages<'_>,
) -> Result<Config, Failure> {
    let start = config::starting_point(control);
    match path {
        None => Ok(start),
        Some(path) => {
            let bytes = fs::read(path).map_err(|error| Failure::unreadable(path, error))?;
            let text = String::from_utf8(bytes).map_err(|error| {
                let kind = io::ErrorKind::InvalidData;
                Failure::unreadable(path, io::Error::new(kind, error.utf8_error().to_string()))
            })?;
            start.read_over::<M>(&text).map_err(|faults| {
                messages.diagnostics(&path.display().to_string(), &mut text.as_bytes(), &faults);
                Failure::Said
            })
        }
    }
}

/// The CL data; a stream is kept so that it can be read twice.
fn open(path: &Path, input: &mut dyn Read) -> Result<Source, Failure> {
    let source = if is_standard(path) { Source::spool(input, "<stdin>") } else { Source::open(path) };
    source.map_err(|error| Failure::unreadable(path, error))
}

/// What the head of a program calls its CL data: the file and not the folder, so that the same data gives the same program
/// anywhere.
fn cl_name(path: &Path) -> Cow<'_, str> {
    if is_standard(path) { "standard input".into() } else { path.file_name().unwrap_or_default().to_string_lossy() }
}

/// `-` is standard input or output.
fn is_standard(path: &Path) -> bool {
    path.as_os_str() == "-"
}
