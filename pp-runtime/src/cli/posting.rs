//! `post IN.cls -o OUT`: posts CL data, checks the program, and gives program and map their final names, or rejects
//! both.

use std::io::{self, BufWriter, Seek as _, Write};
use std::path::Path;

use crate::check::CheckPolicy;
use crate::config::Config;
use crate::control::{Control, comments};
use crate::diag::code::control;
use crate::diag::{Diagnostic, Severity};
use crate::kinematics::AnyMachine;
use crate::post::{Job, LineMap, LineOrigin, PostError, ProgramEnd, Report};
use crate::view::Execution;

use super::args::{NamedFile, PostArgs};
use super::check;
use super::cl_source::{ClSource, same_file};
use super::inputs::{self, cl_file, cl_name, open_cl_data, posting_passes, read_config, show_progress};
use super::map::{EndBuffer, MapFile, MapWriter};
use super::messages::{MessageWriter, headline};
use super::outcome::{Failure, Status, Streams, is_standard};
use super::output_file::{OutputFile, Rejected, rejected_path};
use super::self_check::{self, CheckedOutput, Checking, SelfCheck, SelfChecked};
use super::view::{PageFile, PagePart, viewing_passes};

/// Writer of a program.
pub(crate) type ProgramSink<'a> = BufWriter<&'a mut dyn Write>;

/// The function that posts; tests replace it.
pub(crate) type PostFn<'a> =
    &'a dyn Fn(&Job<'_>, &mut ClSource, &mut ProgramSink<'_>, Option<&mut dyn LineMap>) -> Result<Report, PostError>;

/// A posted program.
pub(crate) struct Written {
    pub(crate) report: Report,
    /// Lines of the summary, or the reason why the program is rejected.
    pub(crate) summary: Result<Vec<String>, String>,
    /// What the check has executed, where the run wants it and the CL data has no errors.
    pub(crate) execution: Option<Execution>,
}

/// Copies what is written.
struct Copied<'a> {
    out: &'a mut dyn Write,
    copy: &'a mut dyn Write,
}

impl Write for Copied<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let count = self.out.write(bytes)?;
        self.copy.write_all(&bytes[..count])?;
        Ok(count)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.out.flush()
    }
}

/// Hands lines to two maps.
struct BothMaps<'a>(Option<&'a mut dyn LineMap>, &'a mut dyn LineMap);

impl LineMap for BothMaps<'_> {
    fn line(&mut self, origin: &LineOrigin<'_>) -> io::Result<()> {
        self.0.as_mut().map_or(Ok(()), |map| map.line(origin))?;
        self.1.line(origin)
    }
}

/// Lines of the summary, or the reason to reject the program; and what the page of the program shows of it.
pub(crate) type Finished = (Result<Vec<String>, String>, Box<dyn PagePart>);

/// What is done with a program that is posted and checked, before it gets its final name.
pub(crate) trait AfterPosting {
    /// Receives the text of the program.
    fn writer(&mut self) -> &mut dyn Write;

    /// `source` is the CL data, anywhere; `terminal`: standard error is one.
    fn finish(
        self: Box<Self>,
        terminal: bool,
        machine: &dyn AnyMachine,
        run: &PostRun<'_>,
        source: &mut ClSource,
        messages: &mut MessageWriter<'_>,
    ) -> Result<Finished, Failure>;
}

#[cfg(feature = "simulate")]
fn after_posting<'a>(config: &Config, args: &'a PostArgs) -> Result<Option<Box<dyn AfterPosting + 'a>>, Failure> {
    super::simulate::after_posting(config, args)
}

#[cfg(not(feature = "simulate"))]
fn after_posting<'a>(_config: &Config, _args: &'a PostArgs) -> Result<Option<Box<dyn AfterPosting + 'a>>, Failure> {
    Ok(None)
}

pub(crate) fn run(
    machine: &dyn AnyMachine,
    args: &PostArgs,
    streams: &mut Streams<'_>,
    post: PostFn<'_>,
) -> Result<Status, Failure> {
    let mut messages = MessageWriter::new(streams.errors, args.set_up.message_format);
    let config = read_config(machine, &args.set_up, &mut messages)?;
    refuse_overwriting(args, &config)?;
    let mut after = after_posting(&config, args)?;
    let mut source = open_cl_data(&args.input, &args.set_up, streams.input)?;
    let unwritable = |error| Failure::unwritable(&args.output, error);
    let mut target = match is_standard(&args.output) {
        true => None,
        false => Some(OutputFile::create(&args.output).map_err(unwritable)?),
    };
    let mut map_file = args.map.as_deref().map(MapFile::create).transpose()?;
    let mut page = args.view.as_deref().map(PageFile::create).transpose()?;
    show_progress(&mut source, streams.terminal, &args.set_up, posting_passes(&config));
    let mut file = target.as_mut().map(OutputFile::writer);
    let out: &mut dyn Write = match &mut file {
        Some(file) => file,
        None => &mut *streams.output,
    };
    let mut both_outputs;
    let out = match &mut after {
        Some(after) => {
            both_outputs = Copied { out, copy: after.writer() };
            &mut both_outputs as &mut dyn Write
        }
        None => out,
    };
    let control = args.set_up.control();
    let checking = match (args.no_check, &args.view) {
        (true, _) => Checking::Off,
        (false, None) => Checking::Findings,
        (false, Some(_)) => Checking::Points,
    };
    let run = PostRun { input: &args.input, output: &args.output, checking, config: &config, control, post };
    let mut map = map_file.as_mut().map(|file| file.begin(machine, &cl_name(&args.input), control)).transpose()?;
    let written = match &mut page {
        None => run.write(machine, &mut source, out, map.as_mut().map(|map| map as &mut dyn LineMap), &mut messages)?,
        Some(page) => {
            let mut copied = Copied { out, copy: &mut page.posted.text };
            let mut both = BothMaps(map.as_mut().map(|map| map as &mut dyn LineMap), &mut page.posted.reasons);
            run.write(machine, &mut source, &mut copied, Some(&mut both), &mut messages)?
        }
    };
    let ended = map.map_or(Ok(()), MapWriter::end);
    let mut written = written;
    let mut page_part = None;
    if let (Some(after), Ok(summary)) = (after, &mut written.summary) {
        let (done, part) = after.finish(streams.terminal, machine, &run, &mut source, &mut messages)?;
        source.hide_progress();
        match done {
            Ok(lines) => summary.extend(lines),
            Err(reason) => written.summary = Err(reason),
        }
        written.execution = written.execution.filter(|_| !part.executes_otherwise());
        page_part = Some(part);
    }
    page.as_ref().map_or(Ok(()), PageFile::clear)?;
    let mut write_page = |messages: &mut MessageWriter<'_>, written: Written| {
        let Some(page) = page.take() else { return Ok(()) };
        show_progress(&mut source, streams.terminal, &args.set_up, viewing_passes(&written));
        let path = page.finish(machine, &run, None, &mut source, written, page_part.as_deref())?;
        source.hide_progress();
        messages.note(&format!("page: {}", path.display()));
        Ok(())
    };
    let summary = match &written.summary {
        Ok(summary) => summary,
        Err(reason) => {
            reject(args, target, reason, &mut messages)?;
            // The map of an earlier program must not be taken for that of this one.
            map_file.map_or(Ok(()), |file| file.clear())?;
            write_page(&mut messages, written)?;
            return Ok(Status::Rejected);
        }
    };
    ended.map_err(|error| Failure::unwritable(args.map.as_deref().unwrap_or(&args.output), error))?;
    summary.iter().for_each(|line| messages.note(line));
    map_file.as_ref().map_or(Ok(()), MapFile::clear)?;
    if let Some(target) = target {
        let removed = target.finish(|line| is_rejected(control, line)).map_err(unwritable)?;
        if removed {
            messages.note(&format!("removed {} of an earlier run", rejected_path(&args.output).display()));
        }
    }
    map_file.map_or(Ok(()), MapFile::finish)?;
    write_page(&mut messages, written)?;
    messages.note("done");
    Ok(Status::Done)
}

/// One run of posting and check.
pub(crate) struct PostRun<'a> {
    pub(crate) input: &'a Path,
    /// Path of the program, for messages.
    pub(crate) output: &'a Path,
    pub(crate) checking: Checking,
    pub(crate) config: &'a Config,
    pub(crate) control: &'static dyn Control,
    pub(crate) post: PostFn<'a>,
}

impl PostRun<'_> {
    /// Policy of the check.
    pub(crate) fn policy(&self, machine: &dyn AnyMachine) -> Result<CheckPolicy, Failure> {
        let policy = self.config.check_policy_for(machine, self.control, None);
        policy.map_err(|error| Failure::Argument(error.to_string()))
    }

    /// Posts, checks, and ends the program: with its end code, or with comments that state why it was rejected.
    pub(crate) fn write(
        &self,
        machine: &dyn AnyMachine,
        source: &mut ClSource,
        out: &mut dyn Write,
        line_map: Option<&mut dyn LineMap>,
        messages: &mut MessageWriter<'_>,
    ) -> Result<Written, Failure> {
        let Self { output, config, control, .. } = *self;
        let name = source.name().to_owned();
        let unreadable = |error| Failure::Unreadable(name.clone(), error);
        let unwritable = |error| Failure::unwritable(output, error);
        let end = ProgramEnd::of(control);
        let check = match self.checking {
            Checking::Off => None,
            Checking::Findings | Checking::Points => {
                let points = self.checking == Checking::Points;
                Some(SelfCheck::start(machine, self.policy(machine)?, source, points)?)
            }
        };
        let mut output_with_check = CheckedOutput::new(out, check, end);
        let mut map = line_map.map(EndBuffer::new);
        let report = self.report(source, &mut output_with_check, map.as_mut().map(|map| map as &mut dyn LineMap))?;
        if !report.diagnostics.is_empty() {
            source.rewind().map_err(unreadable)?;
            messages.diagnostics(&name, source, &report.diagnostics);
        }
        let end_map =
            |map: Option<EndBuffer<'_>>, lines| map.map_or(Ok(()), |map| map.end(lines, end)).map_err(unwritable);
        if let Some(reason) = error_of(&report, &name) {
            output_with_check.close().map_err(unwritable)?;
            end_map(map, 0)?;
            return Ok(Written { report, summary: Err(reason), execution: None });
        }
        let self_checked =
            output_with_check.finish_check().transpose().map_err(|error| check::failure(error, &name, output))?;
        let checked = self_checked.as_ref().map(SelfChecked::checked);
        if let Some(reason) = self_check::rejection(checked, &name, source, messages) {
            let lines = [format!("ERROR: {reason}"), "the program ends here: do not run it".to_owned()];
            let lines: Vec<Vec<u8>> = lines.iter().flat_map(|line| comments(control, line)).collect();
            output_with_check.close_with(&lines).map_err(unwritable)?;
            return Ok(Written {
                report,
                summary: Err(reason),
                execution: self_checked.and_then(SelfChecked::execution),
            });
        }
        let verdict = checked.map_or_else(|| "not checked".to_owned(), |checked| checked.outcome.summary());
        let footer = if config.control.program.checked { comments(control, &verdict) } else { Vec::new() };
        output_with_check.close_before_end(&footer).map_err(unwritable)?;
        end_map(map, footer.len())?;
        let assumed = "assumed: lengths of the configuration file are in mm (`units` is not set there)";
        let mut summary = vec![format!("machine {}, control {}", machine.name(), control.spellings().title)];
        summary.extend(config.file_units_assumed.then(|| assumed.to_owned()));
        summary.append(&mut report.summary());
        summary.push(verdict);
        Ok(Written { report, summary: Ok(summary), execution: self_checked.and_then(SelfChecked::execution) })
    }

    /// Posts the CL data.
    fn report(
        &self,
        source: &mut ClSource,
        output_with_check: &mut CheckedOutput<'_>,
        line_map: Option<&mut dyn LineMap>,
    ) -> Result<Report, Failure> {
        let cl_name = cl_name(self.input);
        let unwritable = |error| Failure::unwritable(self.output, error);
        let job = Job { cl_name: &cl_name, config: self.config, control: self.control, units: self.config.cl_units };
        let mut sink = ProgramSink::new(output_with_check);
        let posted = (self.post)(&job, source, &mut sink, line_map);
        let written = sink.flush();
        // Drops the bytes that could not be written; dropping the writer itself would try them again.
        drop(sink.into_parts());
        source.hide_progress();
        let name = source.name().to_owned();
        if let Some(what) = source.changed_since_opened() {
            return Err(Failure::Changed(name, what));
        }
        let report = posted.map_err(|error| match error {
            PostError::Input(error) => Failure::Unreadable(name, error),
            PostError::Unfit(text) => Failure::Reasons(control::UNFIT, vec![text]),
            PostError::Operations(text) => Failure::Argument(text),
            PostError::Output(error) => unwritable(error),
        })?;
        written.map_err(unwritable)?;
        Ok(report)
    }
}

/// The reason to reject a program whose CL data has errors, even if the report is not marked as failed.
fn error_of(report: &Report, name: &str) -> Option<String> {
    let errors = report.diagnostics.iter().filter(|found| found.severity == Severity::Error);
    let first: Option<&Diagnostic> = errors.min_by_key(|found| found.location);
    let unnamed = || report.failed.then(|| "the CL data has errors".to_owned());
    first.map(|found| headline(name, found)).or_else(unnamed)
}

/// Moves an incomplete program to `OUT.rejected` and reports it; the final name does not exist afterwards.
fn reject(
    args: &PostArgs,
    target: Option<OutputFile>,
    reason: &str,
    messages: &mut MessageWriter<'_>,
) -> Result<(), Failure> {
    let Some(target) = target else {
        messages.note("rejected: the program on standard output is incomplete and must not be run");
        return Ok(());
    };
    let first = comments(args.set_up.control(), &format!("{REJECTED}{reason}")).join(&b'\n');
    let rejected = target.reject(&first).map_err(|error| Failure::unwritable(&args.output, error))?;
    let out = args.output.display();
    messages.note(&match rejected {
        Rejected { path: None, .. } => format!("rejected: the program on {out} is incomplete and must not be run"),
        Rejected { path: Some(path), earlier } => {
            let earlier = earlier.map(|earlier| format!("; the earlier {out} is in {} now", earlier.display()));
            let earlier = earlier.unwrap_or_default();
            format!("rejected: {out} was not written; the incomplete program is in {}{earlier}", path.display())
        }
    });
    Ok(())
}

/// Refuses an output file that would replace an input file or another output file.
fn refuse_overwriting(args: &PostArgs, config: &Config) -> Result<(), Failure> {
    let output = Some(args.output.as_path()).filter(|path| !is_standard(path));
    // Standard output may be redirected to a file.
    let besides = args.files_written();
    let onto_standard = |(path, _): &&NamedFile<'_>| output.is_none() && same_file(path, Path::new(STANDARD_OUTPUT));
    if let Some((path, _)) = besides.iter().find(onto_standard) {
        let what = "the program on standard output".to_owned();
        return Err(Failure::Overwrites(path.display().to_string(), what));
    }
    let rejected = output.map(rejected_path);
    let program = [(output, "program"), (rejected.as_deref(), "rejected program")];
    let program = program.into_iter().filter_map(|(path, what)| Some((path?, what)));
    let written: Vec<NamedFile<'_>> = program.chain(besides).collect();
    let mut read = args.files_read();
    read.extend(cl_file(&args.input));
    inputs::refuse_overwriting(args.set_up.config.as_deref(), config, &read, &written)
}

/// Path of standard output, on systems that have one.
const STANDARD_OUTPUT: &str = "/dev/stdout";

/// First word of the first line of a rejected program, inside the comment.
const REJECTED: &str = "REJECTED ";

/// Whether a line is the first line of a rejected program.
fn is_rejected(control: &dyn Control, line: &[u8]) -> bool {
    // The comment without its closing character.
    let mark = comments(control, REJECTED).concat();
    let end = mark.windows(REJECTED.len()).position(|window| window == REJECTED.as_bytes());
    end.is_some_and(|at| line.starts_with(&mark[..at + REJECTED.len()]))
}
