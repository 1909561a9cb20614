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
mod self_check;
mod source;
mod target;
#[cfg(test)]
mod tests;

use std::borrow::Cow;
use std::ffi::OsString;
use std::fs;
use std::io::{self, BufWriter, IsTerminal as _, Read, Seek as _, Write};
use std::path::Path;
use std::process::ExitCode;

use crate::cl;
use crate::config::{self, Config};
use crate::control::{self, Control};
use crate::diag::Severity;
use crate::kinematics::Machine;
use crate::post::{Account, Job, PostError, Proof, Report, post_with_account, prove};

use args::{Command, MessageFormat, PostArgs, ProofArgs, SetUpArgs};
use map::{Map, MapFile};
use messages::{Messages, headline};
use self_check::{Checking, SelfCheck};
use source::{Source, same_file};
use target::{Rejected, Target, rejected_path};

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

/// Where a program is written to.
type Sink<'a> = BufWriter<&'a mut dyn Write>;

/// The posting, so that tests can put their own in its place.
type Post<'a> = &'a dyn Fn(&Job<'_>, &mut Source, &mut Sink<'_>, Option<&mut dyn Account>) -> Result<Report, PostError>;

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
        Command::Post(args) => post_file::<M>(&args, &mut streams, post),
        Command::Check(args) => check::run::<M>(&args, &mut streams),
        Command::ExplainBlock(args) => explain_block::run::<M>(&args, &mut streams),
        Command::Config(args) => {
            let config = control::starting_point(args.control());
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

fn post_file<M: Machine>(args: &PostArgs, streams: &mut Streams<'_>, post: Post<'_>) -> Result<Status, Failure> {
    let mut messages = Messages::new(streams.errors, args.set_up.message_format);
    let config = read_config::<M>(&args.set_up, &mut messages)?;
    refuse_overwriting(args)?;
    let mut source =
        if is_standard(&args.input) { Source::spool(streams.input, "<stdin>") } else { Source::open(&args.input) }
            .map_err(|error| Failure::unreadable(&args.input, error))?;
    let mut target = match is_standard(&args.output) {
        true => None,
        false => Some(Target::create(&args.output).map_err(|error| Failure::unwritable(&args.output, error))?),
    };

    let name = source.name().to_owned();
    let cl_name = cl_name(&args.input);
    let control = args.set_up.control();
    let job = Job { cl_name: &cl_name, config: &config, control, units: config.cl_units };
    if streams.terminal && args.set_up.message_format == MessageFormat::Human {
        source.show_progress();
    }
    let check = (!args.no_check).then(|| SelfCheck::start::<M>(&config, control, &source)).transpose();
    let check = check.map_err(|error| Failure::Unreadable(name.clone(), error))?;
    let mut checking = Checking::new(
        match &mut target {
            Some(target) => target.writer(),
            None => &mut *streams.output,
        },
        check,
        1 + control.spellings().closing.len(),
    );
    let mut sink = Sink::new(&mut checking);
    let mut map_file = args.map.as_deref().map(MapFile::create).transpose()?;
    let mut map = map_file.as_mut().map(|file| file.begin::<M>(&cl_name, control)).transpose()?;
    let posted = post(&job, &mut source, &mut sink, map.as_mut().map(|map| map as &mut dyn Account));
    let written = sink.flush();
    let mapped = map.map_or(Ok(()), Map::end);
    // What could not be written is not tried again.
    drop(sink.into_parts());
    source.hide_progress();
    if let Some(what) = source.disturbed() {
        return Err(Failure::Disturbed(name, what));
    }
    let report = match posted {
        Ok(report) => report,
        Err(PostError::Input(error)) => return Err(Failure::Unreadable(name, error)),
        Err(PostError::Operations(text)) => return Err(Failure::Argument(text)),
        Err(PostError::Output(error)) => return Err(Failure::unwritable(&args.output, error)),
    };
    written.map_err(|error| Failure::unwritable(&args.output, error))?;
    mapped.map_err(|error| Failure::unwritable(args.map.as_deref().unwrap_or(&args.output), error))?;
    let unwritable = |error| Failure::unwritable(&args.output, error);

    if !report.diagnostics.is_empty() {
        source.rewind().map_err(|error| Failure::Unreadable(name.clone(), error))?;
        messages.diagnostics(&name, &mut source, &report.diagnostics);
    }
    let first_error = report.diagnostics.iter().filter(|found| found.severity == Severity::Error);
    let first_error = first_error.min_by_key(|found| found.location);
    // A program with an error in its CL data is never handed over, whatever the report says.
    if report.failed || first_error.is_some() {
        checking.close().map_err(unwritable)?;
        let reason = first_error.map_or_else(|| "the CL data has errors".to_owned(), |found| headline(&name, found));
        reject(args, target, map_file, &reason, &mut messages)?;
        return Ok(Status::Rejected);
    }
    let checked = checking.verdict().transpose().map_err(|error| check::failure(error, &name, &args.output))?;
    if let Some(reason) = self_check::against(checked.as_ref(), &name, &mut source, &mut messages) {
        let lines = [format!("ERROR: {reason}"), "the program ends here: do not run it".to_owned()];
        checking.close_with(&lines.map(|line| comment(control, &line))).map_err(unwritable)?;
        reject(args, target, map_file, &reason, &mut messages)?;
        return Ok(Status::Rejected);
    }
    let verdict = checked.map_or_else(|| "not checked".to_owned(), |checked| checked.outcome.summary());
    if config.program.checked {
        checking.close_behind(&comments(control, &verdict), control.spellings().counted).map_err(unwritable)?;
    } else {
        checking.close().map_err(unwritable)?;
    }
    if config.file_units_assumed {
        messages.note("assumed: lengths of the configuration file are in mm (`units` is not set there)");
    }
    for line in report.summary() {
        messages.note(&line);
    }
    messages.note(&verdict);
    if let Some(target) = target {
        let removed = target.finish(|line| is_rejected(control, line)).map_err(unwritable)?;
        if removed {
            messages.note(&format!("removed {} of an earlier run", rejected_path(&args.output).display()));
        }
    }
    map_file.map_or(Ok(()), MapFile::finish)?;
    messages.note("done");
    Ok(Status::Done)
}

/// Says where the program went that was cut short, and sees to it that nothing stands under the final name.
fn reject(
    args: &PostArgs,
    target: Option<Target>,
    map: Option<MapFile>,
    reason: &str,
    messages: &mut Messages<'_>,
) -> Result<(), Failure> {
    map.map_or(Ok(()), MapFile::discard)?;
    let Some(target) = target else {
        messages.note("rejected: the program on standard output is not complete and must not be run");
        return Ok(());
    };
    let first_line = comment(args.set_up.control(), &format!("{REJECTED}{reason}"));
    let rejected = target.reject(&first_line).map_err(|error| Failure::unwritable(&args.output, error))?;
    let out = args.output.display();
    messages.note(&match rejected {
        Rejected { path: None, .. } => format!("rejected: the program on {out} is not complete and must not be run"),
        Rejected { path: Some(path), removed } => {
            let earlier = if removed { format!("; the earlier {out} was removed") } else { String::new() };
            format!("rejected: {out} was not written, what could be posted stands in {}{earlier}", path.display())
        }
    });
    Ok(())
}

fn read_config<M: Machine>(args: &SetUpArgs, messages: &mut Messages<'_>) -> Result<Config, Failure> {
    let mut config = read_file::<M>(args.config.as_deref(), args.control(), messages)?;
    args.apply::<M>(&mut config).map_err(Failure::Argument)?;
    fit::<M>(args.control(), &config)?;
    Ok(config)
}

/// Whether the control can do what the configuration asks for.
fn fit<M: Machine>(control: &dyn Control, config: &Config) -> Result<(), Failure> {
    let mut unfit = control::check(control, config);
    unfit.append(&mut control::unsuited::<M>(control, config));
    if unfit.is_empty() { Ok(()) } else { Err(Failure::Argument(unfit.join("\n"))) }
}

/// The configuration of a file on top of the defaults of a control.
fn read_file<M: Machine>(
    path: Option<&Path>,
    control: &dyn Control,
    messages: &mut Messages<'_>,
) -> Result<Config, Failure> {
    let start = control::starting_point(control);
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

/// Nothing that is written may replace a file that is read, or another that is written.
fn refuse_overwriting(args: &PostArgs) -> Result<(), Failure> {
    let output = Some(&args.output).filter(|path| !is_standard(path));
    let rejected = output.map(|path| rejected_path(path));
    let read = [
        (Some(&args.input).filter(|path| !is_standard(path)), "CL data"),
        (args.set_up.config.as_ref(), "configuration"),
    ];
    let written = [(output, "program"), (rejected.as_ref(), "rejected program")];
    let programs = written.into_iter().filter_map(|(path, _)| path).flat_map(|path| read.map(|read| (path, read)));
    let maps = args.map.iter().flat_map(|path| read.into_iter().chain(written).map(move |other| (path, other)));
    for (path, (other, what)) in programs.chain(maps) {
        if let Some(other) = other
            && same_file(path, other)
        {
            let what = format!("the {what} {}", other.display());
            return Err(Failure::Overwrites(path.display().to_string(), what));
        }
    }
    Ok(())
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

/// How the first line of a rejected program begins, inside the comment.
const REJECTED: &str = "REJECTED ";

/// A comment of one line as the control spells it.
fn comment(control: &dyn Control, text: &str) -> Vec<u8> {
    comments(control, text).into_iter().next().unwrap_or_default()
}

/// A comment as the control spells it, on as many lines as it needs.
fn comments(control: &dyn Control, text: &str) -> Vec<Vec<u8>> {
    let lines = control::lines_of(text.as_bytes(), control.spellings().comment.length);
    let spelled = lines.map(|text| {
        let mut line = Vec::new();
        control.comment(text, &mut line);
        line
    });
    spelled.collect()
}

/// Whether a line is the first one of a rejected program.
fn is_rejected(control: &dyn Control, line: &[u8]) -> bool {
    // The comment without what closes it.
    let mark = comment(control, REJECTED);
    let end = mark.windows(REJECTED.len()).position(|window| window == REJECTED.as_bytes());
    end.is_some_and(|at| line.starts_with(&mark[..at + REJECTED.len()]))
}
