//! `simulate IN.cls [OUT.nc]`: the written program moves the machine and cuts a stock.
//!
//! Without OUT.nc the CL data is posted to a temporary file. The program is executed by the check's reader, in one pass
//! and in memory that does not grow with its length.

mod after_posting;
mod against_design;
mod bodies;
mod figures;
mod page;
mod saved_stock;

use std::fs::File;
use std::io::{self, BufReader, Seek as _, Write as _};
use std::path::Path;

use crate::check::{CheckPolicy, Checked, check_observed};
use crate::diag::code::simulate;
use crate::kinematics::AnyMachine;
use crate::simulate::{
    LineRecords, Machined, Machining, Origin, PartPlaces, Recording, Simulation, SimulationOutcome, ToolBodies,
    clearances, without_solids,
};
use crate::view::{ClFacts, Collector, Motions, ViewedProgram};

use super::args::{MessageFormat, SimulateArgs, SimulationArgs};
use super::check;
use super::cl_source::ClSource;
use super::inputs::{
    cl_file, open_cl_data, posting_passes, read_config, refuse_overwriting, show_progress, show_simulation,
};
use super::messages::MessageWriter;
use super::outcome::{Failure, Status, Streams, is_standard, print};
use super::posting::{PostFn, PostRun};
use super::self_check::Checking;
use super::view::{self, IN_MEMORY, PageFile, PagePart};
pub(super) use after_posting::after_posting;
use against_design::{AgainstDesign, DesignTolerances};
use bodies::{Bodies, GivenDesign};
use figures::Figures;
use page::{ResultSentences, ShownBodies};

/// Result of a simulation.
struct Simulated {
    /// Set-up and tools by which the program was executed.
    policy: CheckPolicy,
    /// A tool table has given lengths to them.
    tool_table: bool,
    checked: Checked,
    outcome: SimulationOutcome,
    against: Option<AgainstDesign>,
    pitch_mm: [f64; 3],
    stock_mm: [[f64; 3]; 2],
    /// No finding is one that the run must not have.
    passed: bool,
    /// For a page.
    shown: Option<ShownBodies>,
}

impl PagePart for Simulated {
    fn policy(&self) -> &CheckPolicy {
        &self.policy
    }

    fn executes_otherwise(&self) -> bool {
        self.tool_table
    }

    fn add_to(&self, machine: &dyn AnyMachine, program: &mut ViewedProgram<'_>) -> io::Result<()> {
        let Some(shown) = &self.shown else { return Ok(()) };
        let placed = self.policy.set_up.machine_for(machine).map_err(io::Error::other)?;
        let figures = serde_json::to_value(self.figures())?;
        let sentences = ResultSentences { line: self.line(), summary: self.outcome.summary() };
        let page = shown.page(&*placed, &self.policy.set_up, program, figures, sentences)?;
        program.add_simulation(page);
        Ok(())
    }
}

impl Simulated {
    fn figures(&self) -> Figures<'_> {
        Figures::of(&self.outcome, self.against.as_ref(), self.passed, (self.pitch_mm, self.stock_mm))
    }

    /// The result in one line.
    fn line(&self) -> String {
        let design = self.against.as_ref().map_or(String::new(), |against| format!("; {}", against.line()));
        let open = self.outcome.not_checked().len();
        let what = if open == 1 { "thing is" } else { "things are" };
        let open = if open == 0 { String::new() } else { format!("; {open} {what} not checked, see `simulate`") };
        format!("{}{design}{open}", self.outcome.line())
    }

    /// Writes collisions and gouges.
    fn findings(&self, messages: &mut MessageWriter<'_>) {
        for found in &self.outcome.found {
            messages.warning(simulate::CONTACT, &found.text());
        }
        self.outcome.differences.iter().for_each(|text| messages.warning(simulate::TOOL_TABLE, text));
        let more = self.outcome.count - self.outcome.found.len() as u64;
        if more > 0 {
            messages.warning(simulate::CONTACT, &format!("{more} more findings"));
        }
        let gouges = self.against.as_ref().map_or_else(Vec::new, AgainstDesign::warnings);
        gouges.iter().for_each(|text| messages.warning(simulate::GOUGE, text));
    }

    /// Writes findings and summary.
    fn report(&self, messages: &mut MessageWriter<'_>) {
        self.findings(messages);
        if let Some(against) = &self.against {
            against.notes().iter().for_each(|text| messages.note(text));
        }
        self.outcome.summary().iter().for_each(|line| messages.note(line));
    }
}

pub(crate) fn run(
    machine: &dyn AnyMachine,
    args: &SimulateArgs,
    streams: &mut Streams<'_>,
    post: PostFn<'_>,
) -> Result<Status, Failure> {
    let mut messages = MessageWriter::new(streams.errors, args.format());
    let config = read_config(machine, &args.set_up, &mut messages)?;
    let bodies = Bodies::read(&config.set_up, &args.simulation, config.output_units.unwrap_or_default())?;
    if args.output.as_deref().is_some_and(is_standard) {
        return Err(Failure::Argument("the page must be a file: give `-o REPORT.html`".to_owned()));
    }
    let mut read = args.files_read();
    read.extend(cl_file(&args.input));
    refuse_overwriting(args.set_up.config.as_deref(), &config, &read, &args.files_written())?;
    let mut source = open_cl_data(&args.input, &args.set_up, streams.input)?;
    let name = source.name().to_owned();
    let unreadable = |error| Failure::Unreadable(name.clone(), error);
    let shown = args.program.as_deref().unwrap_or(Path::new(IN_MEMORY));
    let run = PostRun {
        input: &args.input,
        output: shown,
        checking: Checking::for_text(&config),
        config: &config,
        control: args.set_up.control(),
        post,
    };
    if args.program.as_deref().is_some_and(is_standard) {
        return Err(Failure::Argument("the program must be a file: it is read once the CL data is".to_owned()));
    }
    let mut page = None;
    let mut program: File = match (&args.output, &args.program) {
        (Some(path), _) => {
            let mut page_file = PageFile::create(path)?;
            show_progress(&mut source, streams.terminal, &args.set_up, posting_passes(&config));
            let (posted, written) = view::posted(machine, &run, args.program.as_deref(), &mut source, &mut messages)?;
            if let (None, Err(reason)) = (&args.program, &written.summary) {
                messages.note(&format!("rejected: {reason}"));
                return Ok(Status::Rejected);
            }
            let file = file_of(&posted.text, shown)?;
            source.rewind().map_err(unreadable)?;
            page_file.posted = posted;
            page = Some((page_file, written));
            file
        }
        (None, Some(path)) => File::open(path).map_err(|error| Failure::unreadable(path, error))?,
        (None, None) => {
            show_progress(&mut source, streams.terminal, &args.set_up, posting_passes(&config));
            let mut file = tempfile::tempfile().map_err(|error| Failure::unwritable(shown, error))?;
            let written = run.write(machine, &mut source, &mut file, None, &mut messages)?;
            if let Err(reason) = written.summary {
                messages.note(&format!("rejected: {reason}"));
                return Ok(Status::Rejected);
            }
            file.rewind().map_err(|error| Failure::unwritable(shown, error))?;
            source.rewind().map_err(unreadable)?;
            file
        }
    };
    let policy = run.policy(machine)?;
    show_simulation(&mut source, streams.terminal, &args.set_up);
    let keep = page.is_some();
    let files = SimulatedFiles { source: &mut source, program: &mut program, shown };
    let how = SimulationRun { args: &args.simulation, threads: args.set_up.threads(), keep };
    let simulated = simulate(machine, policy, files, bodies, how)?;
    source.hide_progress();
    if let Some(what) = source.changed_since_opened() {
        return Err(Failure::Changed(name, what));
    }
    let written = args.program.as_deref().map(Path::to_string_lossy);
    check::report(&simulated.checked, &name, &mut source, written.as_deref(), &mut messages).map_err(unreadable)?;
    simulated.checked.outcome.lines().iter().for_each(|line| messages.note(line));
    simulated.report(&mut messages);
    if let Some((page, mut written)) = page {
        written.execution = written.execution.filter(|_| !simulated.executes_otherwise());
        let part: &dyn PagePart = &simulated;
        let path = page.finish(machine, &run, args.program.as_deref(), &mut source, written, Some(part))?;
        messages.note(&format!("page: {}", path.display()));
    }
    if args.format() == MessageFormat::Json {
        print(streams, |out| {
            serde_json::to_writer(&mut *out, &simulated.figures())?;
            out.write_all(b"\n")
        })?;
    }
    Ok(if simulated.passed { Status::Done } else { Status::Rejected })
}

/// A temporary file of a text, at its start. `shown`: name of the text.
fn file_of(text: &[u8], shown: &Path) -> Result<File, Failure> {
    let unwritable = |error| Failure::unwritable(shown, error);
    let mut file = tempfile::tempfile().map_err(unwritable)?;
    file.write_all(text).and_then(|()| file.rewind()).map_err(unwritable)?;
    Ok(file)
}

/// Files of a simulation, both at their start.
struct SimulatedFiles<'f> {
    source: &'f mut ClSource,
    program: &'f mut File,
    /// Name of the program.
    shown: &'f Path,
}

/// How a program is simulated.
#[derive(Clone, Copy)]
struct SimulationRun<'r> {
    args: &'r SimulationArgs,
    /// Number of threads of the removal.
    threads: usize,
    /// A page will show the bodies.
    keep: bool,
}

/// Executes a program with the bodies of a job.
fn simulate(
    machine: &dyn AnyMachine,
    mut policy: CheckPolicy,
    files: SimulatedFiles<'_>,
    bodies: Bodies,
    SimulationRun { args, threads, keep }: SimulationRun<'_>,
) -> Result<Simulated, Failure> {
    let SimulatedFiles { source, program, shown } = files;
    let name = source.name().to_owned();
    let unreadable = |error| Failure::Unreadable(name.clone(), error);
    let Bodies { stock, stock_text, design, solids, tool_table } = bodies;
    let facts = ClFacts::read(&mut *source, policy.reading.clone()).map_err(unreadable)?;
    source.rewind().map_err(unreadable)?;
    let given_table = tool_table.is_some();
    let table = tool_table.map_or_else(Vec::new, |table| table.apply(&mut policy.set_up, &facts));
    let owned = policy;
    let policy = &owned;
    let tools = ToolBodies::of(&facts, &policy.set_up);
    let (pitch_mm, stock_mm) = (stock.pitch(), stock.corners());
    let placed = policy.set_up.machine_for(machine).map_err(|invalid| Failure::Argument(invalid.to_string()))?;
    let mut sentences = Vec::new();
    let distances = clearances(&*placed, &policy.set_up, &solids, &tools, &stock, &mut sentences);
    let places = PartPlaces::of(&policy.set_up, &facts);
    let kept_tools = keep.then(|| tools.clone());
    let machining = Machining::new(policy, tools, stock, places.clone(), threads);
    let machining = if keep { machining.recorded() } else { machining };
    let mut simulation = Simulation::new(policy, machine.axes(), machining, distances);
    let execute = |source: &mut ClSource, program: &mut File, motions: &mut dyn Motions| {
        let mut follower = Collector::following(machine, policy, motions);
        check_observed(machine, policy, source, &mut BufReader::new(program), &mut follower)
            .map_err(|error| check::failure(error, &name, shown))
    };
    let checked = execute(source, program, &mut simulation)?;
    let Machined { mut outcome, stock: machined, set_up: last, recording } = simulation.finish();
    places.assumed.iter().for_each(|text| outcome.assume(text.clone()));
    for number in &places.unknown {
        outcome.leave_out(format!(
            "the part in set-up {number}: the CL data does not state its frame, and `cl_origin` is not given in [set_ups.{number}]"
        ));
    }
    outcome.assume(stock_text);
    outcome.differences = table;
    outcome.without_solids = without_solids(&*placed, &policy.set_up, &solids);
    sentences.into_iter().for_each(|text| outcome.leave_out(text));
    let (mut against, mut kept_design) = (None, None);
    match design {
        Some(GivenDesign { design, name: design_name, tolerance_mm }) => {
            let tolerances = DesignTolerances {
                gouge_mm: args.gouge_tolerance_mm.unwrap_or(policy.largest_path_mm()),
                rest_mm: args.rest_tolerance_mm.unwrap_or(policy.largest_path_mm()),
                design_mm: tolerance_mm,
                certified_mm: outcome.certified_mm(stock_mm),
            };
            // Where the part lies at the end.
            let design = match places.between(1, last) {
                Some(place) if last != 1 => design.moved(&place),
                _ => design,
            };
            let comparison = design.compare(&machined, tolerances.limits(), &|origin| match origin {
                Origin::Line(line) => outcome.allowance_mm(u64::from(line)),
                Origin::Blank | Origin::Unknown => 0.0,
            });
            let mut records = LineRecords::of(comparison.lines());
            if !records.is_empty() {
                // The program is executed again for the records of the lines that were found.
                program.rewind().map_err(|error| Failure::unreadable(shown, error))?;
                source.rewind().map_err(unreadable)?;
                execute(source, program, &mut records)?;
            }
            let found =
                AgainstDesign { comparison, records, tolerances, name: design_name, triangles: design.triangles() };
            found.not_checked().into_iter().for_each(|text| outcome.leave_out(text));
            against = Some(found);
            kept_design = keep.then_some(design);
        }
        None => outcome.leave_out("gouges and rest material: no design given".to_owned()),
    }
    if let Some(path) = &args.save_stock {
        outcome.saved = Some(saved_stock::save(&policy.set_up, last, &machined, path)?);
    }
    let shown = kept_tools.map(|tools| ShownBodies {
        stock: machined,
        set_up: last,
        stages: recording.and_then(Recording::stages),
        design: kept_design,
        solids,
        tools,
        places,
    });
    let collides = args.fails_on_collision() && outcome.count > 0;
    let gouges = args.fails_on_gouge() && against.as_ref().is_some_and(AgainstDesign::gouges);
    let passed = checked.passed() && !collides && !gouges;
    Ok(Simulated {
        policy: owned,
        tool_table: given_table,
        checked,
        outcome,
        against,
        pitch_mm,
        stock_mm,
        passed,
        shown,
    })
}
