//! `view IN.cls [OUT.nc]`: a page that shows the program as the check's reader understands it; `post --view` writes the
//! page of the program that it posts. `report IN.cls`: a set-up sheet of the posted program.
//!
//! Without OUT.nc the CL data is posted to memory. With it the CL data is posted, too: lines that are equal have the
//! reasons of the posted ones. A program with findings is shown, and the exit status is that of `check`.

use std::fs;
use std::io::{self, BufWriter, Seek as _, Write};
use std::path::{Path, PathBuf};

use crate::check::CheckPolicy;
use crate::kinematics::AnyMachine;
use crate::view::{ProgramText, Reasons, Titles, ViewedProgram, is_document, path_and_axes, write_page, write_report};

use super::args::{NamedFile, ReportArgs, ReportFile, SetUpArgs, ViewArgs};
use super::check;
use super::cl_source::ClSource;
use super::inputs::{cl_file, cl_name, open_cl_data, posting_passes, read_config, refuse_overwriting, show_progress};
use super::messages::{MessageWriter, headline};
use super::outcome::{Failure, Status, Streams, is_standard};
use super::output_file::OutputFile;
use super::posting::{PostFn, PostRun, Written};
use super::self_check::Checking;

/// Name of the program in memory, in messages.
pub(crate) const IN_MEMORY: &str = "the program in memory";

/// Times that the CL data is read to show a program: for what only the CL data states, and to execute the program where
/// the run that posted it has not.
pub(crate) fn viewing_passes(written: &Written) -> u64 {
    1 + u64::from(written.execution.is_none())
}

/// A program to be shown.
struct Request<'a> {
    input: &'a Path,
    /// `None`: the CL data is posted.
    program: Option<&'a Path>,
    set_up: &'a SetUpArgs,
}

/// A file that shows a program.
struct ViewFile<'a> {
    path: &'a Path,
    /// What it holds.
    what: &'static str,
    write: &'a dyn Fn(&ViewedProgram<'_>, &mut dyn Write) -> io::Result<()>,
}

/// A program in memory, and why its lines are there.
#[derive(Default)]
pub(crate) struct Posted {
    pub(crate) text: Vec<u8>,
    pub(crate) reasons: Reasons,
}

/// `view`.
pub(crate) fn run(
    machine: &dyn AnyMachine,
    args: &ViewArgs,
    streams: &mut Streams<'_>,
    post: PostFn<'_>,
) -> Result<Status, Failure> {
    let page = match (&args.output, &args.svg) {
        (Some(output), _) => Some(output.clone()),
        (None, Some(_)) if !args.open => None,
        (None, _) if is_standard(&args.input) => {
            return Err(Failure::Argument("CL data from standard input has no name: give `-o OUT.html`".to_owned()));
        }
        (None, _) => Some(own_name(&args.input)?),
    };
    if args.open && page.as_deref().is_some_and(is_standard) {
        return Err(Failure::Argument("--open needs a file: give `-o OUT.html`".to_owned()));
    }
    let svg = |program: &ViewedProgram<'_>, out: &mut dyn Write| out.write_all(path_and_axes(program)?.as_bytes());
    let outputs: Vec<ViewFile<'_>> = page
        .iter()
        .map(|path| ViewFile { path, what: "page", write: &write_page })
        .chain(args.svg.iter().map(|path| ViewFile { path, what: "pictures", write: &svg }))
        .collect();
    let request = Request { input: &args.input, program: args.program.as_deref(), set_up: &args.set_up };
    let status = show(machine, &request, streams, post, &outputs)?;
    if let Some(page) = page.filter(|_| args.open) {
        open::that_detached(&page).map_err(|error| {
            Failure::Argument(format!("{} is written, but no browser could be opened: {error}", page.display()))
        })?;
    }
    Ok(status)
}

/// Name of a page that is given none: that of the CL data. A file that is no page of ours is not replaced unasked.
fn own_name(input: &Path) -> Result<PathBuf, Failure> {
    let path = input.with_extension("html");
    if path.exists() && !is_document(&path) {
        let text = format!("{0} exists and is not a page of this program: give `-o OUT.html`", path.display());
        return Err(Failure::Argument(text));
    }
    Ok(path)
}

/// `report`.
pub(crate) fn report(
    machine: &dyn AnyMachine,
    args: &ReportArgs,
    streams: &mut Streams<'_>,
    post: PostFn<'_>,
) -> Result<Status, Failure> {
    let ReportFile { path, form } = &args.output;
    let write = |program: &ViewedProgram<'_>, out: &mut dyn Write| write_report(program, *form, args.jog, out);
    let request = Request { input: &args.input, program: None, set_up: &args.set_up };
    show(machine, &request, streams, post, &[ViewFile { path, what: "set-up sheet", write: &write }])
}

/// Posts or reads a program, executes it, and writes what is shown of it.
fn show(
    machine: &dyn AnyMachine,
    request: &Request<'_>,
    streams: &mut Streams<'_>,
    post: PostFn<'_>,
    outputs: &[ViewFile<'_>],
) -> Result<Status, Failure> {
    let Request { input, program, set_up } = *request;
    let mut messages = MessageWriter::new(streams.errors, set_up.message_format);
    let config = read_config(machine, set_up, &mut messages)?;
    let read: Vec<NamedFile<'_>> =
        program.map(|program| (program, "program")).into_iter().chain(cl_file(input)).collect();
    let files: Vec<NamedFile<'_>> =
        outputs.iter().filter(|output| !is_standard(output.path)).map(|output| (output.path, output.what)).collect();
    refuse_overwriting(set_up.config.as_deref(), &config, &read, &files)?;
    let mut source = open_cl_data(input, set_up, streams.input)?;
    let create = |output: &ViewFile<'_>| -> Result<Option<OutputFile>, Failure> {
        let file = (!is_standard(output.path)).then(|| OutputFile::create(output.path));
        file.transpose().map_err(|error| Failure::unwritable(output.path, error))
    };
    let targets = outputs.iter().map(create).collect::<Result<Vec<_>, _>>()?;
    show_progress(&mut source, streams.terminal, set_up, posting_passes(&config));
    let in_memory = Path::new(IN_MEMORY);
    let checking = if program.is_some() { Checking::for_text(&config) } else { Checking::Points };
    let run = PostRun { input, output: in_memory, checking, config: &config, control: set_up.control(), post };
    let (posted, written) = posted(machine, &run, program, &mut source, &mut messages)?;
    let rejected = program.is_none() && written.summary.is_err();
    show_progress(&mut source, streams.terminal, set_up, viewing_passes(&written));
    let policy = run.policy(machine)?;
    let shown = viewed(machine, &run, program, &policy, &mut source, &posted, written)?;
    source.hide_progress();
    let name = source.name().to_owned();
    if let Some(what) = source.changed_since_opened() {
        return Err(Failure::Changed(name, what));
    }
    let checked = shown.checked();
    if !rejected {
        let program = program.map(Path::to_string_lossy);
        check::report(checked, &name, &mut source, program.as_deref(), &mut messages)
            .map_err(|error| Failure::Unreadable(name.clone(), error))?;
    }
    checked.outcome.lines().iter().for_each(|line| messages.note(line));
    for (output, target) in outputs.iter().zip(targets) {
        let unwritable = |error| Failure::unwritable(output.path, error);
        let Some(mut target) = target else {
            let mut out = BufWriter::new(&mut *streams.output);
            (output.write)(&shown, &mut out).and_then(|()| out.flush()).map_err(unwritable)?;
            continue;
        };
        write_to(&mut target, &shown, output.write).and_then(|()| target.finish(|_| false)).map_err(unwritable)?;
        messages.note(&format!("{}: {}", output.what, output.path.display()));
    }
    Ok(if !rejected && shown.passed() { Status::Done } else { Status::Rejected })
}

/// Posts the CL data to memory. `program`: one that is given has its own text, with the reasons of the posted lines.
pub(crate) fn posted(
    machine: &dyn AnyMachine,
    run: &PostRun<'_>,
    program: Option<&Path>,
    source: &mut ClSource,
    messages: &mut MessageWriter<'_>,
) -> Result<(Posted, Written), Failure> {
    let given = program.map(|path| fs::read(path).map_err(|error| Failure::unreadable(path, error))).transpose()?;
    let mut posted = Posted::default();
    // Of a program that is given only its own faults count; those of the CL data come with it.
    let mut nobody = io::sink();
    let mut unheard = MessageWriter::new(&mut nobody, messages.format());
    let mut write =
        |heard: &mut MessageWriter<'_>| run.write(machine, source, &mut posted.text, Some(&mut posted.reasons), heard);
    let written = if given.is_some() { write(&mut unheard)? } else { write(messages)? };
    if let Some(text) = given {
        posted = Posted { reasons: posted.reasons.carried_over(&posted.text, &text), text };
    }
    Ok((posted, written))
}

/// Writes a file that shows a program.
fn write_to(
    target: &mut OutputFile,
    shown: &ViewedProgram<'_>,
    write: impl Fn(&ViewedProgram<'_>, &mut dyn Write) -> io::Result<()>,
) -> io::Result<()> {
    let mut out = BufWriter::new(target.writer());
    write(shown, &mut out)?;
    out.flush()
}

/// What is shown of a program that is in memory. `program`: its path, if it was not posted in this run.
fn viewed<'p>(
    machine: &dyn AnyMachine,
    run: &PostRun<'_>,
    program: Option<&Path>,
    policy: &'p CheckPolicy,
    source: &mut ClSource,
    posted: &'p Posted,
    written: Written,
) -> Result<ViewedProgram<'p>, Failure> {
    let (name, cl) = (source.name().to_owned(), cl_name(run.input).into_owned());
    let Written { report, summary, execution } = written;
    let titles = Titles {
        program: program
            .map_or_else(|| stem(run), |path| path.file_name().unwrap_or_default().to_string_lossy().into()),
        control: run.control.spellings().name,
        summary: match (program, summary) {
            // What the planner counts is not this program.
            (Some(_), _) => report.set_up.iter().chain(&report.reading).chain(&report.assumptions).cloned().collect(),
            (None, Ok(_)) => report.summary_without_times(),
            (None, Err(reason)) => vec![format!("rejected: {reason}")],
        },
        warnings: report.diagnostics.iter().map(|found| headline(&cl, found)).collect(),
        cl,
    };
    source.rewind().map_err(|error| Failure::Unreadable(name.clone(), error))?;
    let program = ProgramText { text: &posted.text, reasons: &posted.reasons };
    ViewedProgram::new(machine, policy, source, program, titles, execution)
        .map_err(|error| check::failure(error, &name, run.output))
}

/// Name of a program that is posted in this run: its file, or that of the CL data without its ending.
fn stem(run: &PostRun<'_>) -> String {
    let posted = run.output;
    let path = if is_standard(posted) || posted == Path::new(IN_MEMORY) { run.input } else { posted };
    let name = if path == run.input { path.file_stem() } else { path.file_name() };
    if is_standard(path) { "program".to_owned() } else { name.unwrap_or_default().to_string_lossy().into_owned() }
}

/// What the page of a program shows besides it.
pub(crate) trait PagePart {
    /// Policy by which the page executes the program.
    fn policy(&self) -> &CheckPolicy;

    /// Whether that differs from the policy of the run that posts.
    fn executes_otherwise(&self) -> bool;

    /// Adds it to the page.
    fn add_to(&self, machine: &dyn AnyMachine, program: &mut ViewedProgram<'_>) -> io::Result<()>;
}

/// The page of a program that is being posted.
pub(crate) struct PageFile {
    path: PathBuf,
    target: OutputFile,
    pub(crate) posted: Posted,
}

impl PageFile {
    pub(crate) fn create(path: &Path) -> Result<Self, Failure> {
        let target = OutputFile::create(path).map_err(|error| Failure::unwritable(path, error))?;
        Ok(Self { path: path.to_owned(), target, posted: Posted::default() })
    }

    /// Removes the page of an earlier program: it must not be taken for that of this one.
    pub(crate) fn clear(&self) -> Result<(), Failure> {
        self.target.clear().map_err(|error| Failure::unwritable(&self.path, error))
    }

    /// Writes the page, of a rejected program as well. `program`: its path, if it was not posted in this run.
    pub(crate) fn finish(
        self,
        machine: &dyn AnyMachine,
        run: &PostRun<'_>,
        program: Option<&Path>,
        source: &mut ClSource,
        written: Written,
        part: Option<&dyn PagePart>,
    ) -> Result<PathBuf, Failure> {
        let Self { path, mut target, posted } = self;
        let unwritable = |error| Failure::unwritable(&path, error);
        let own;
        let policy = match part {
            Some(part) => part.policy(),
            None => {
                own = run.policy(machine)?;
                &own
            }
        };
        let mut program = viewed(machine, run, program, policy, source, &posted, written)?;
        if let Some(part) = part {
            part.add_to(machine, &mut program).map_err(unwritable)?;
        }
        if let Some(what) = source.changed_since_opened() {
            return Err(Failure::Changed(source.name().to_owned(), what));
        }
        write_to(&mut target, &program, write_page).map_err(unwritable)?;
        target.finish(|_| false).map_err(unwritable)?;
        Ok(path)
    }
}
