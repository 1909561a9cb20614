//! The pipeline: CL text → events → steps → blocks. The only module that sees both ends.
//!
//! The text is read twice, and a third time where rotary axes have clamps. The survey collects what the header needs and
//! what can only be known at the end: every diagnostic of the reader, the tools with their operations and extremes, and
//! whether all tool axes point into the table. The last pass plans and writes motion by motion, in constant memory. The
//! same input gives the same bytes.

mod account;
mod header;
mod proof;
mod survey;
mod time;

#[cfg(test)]
mod tests;

use std::io::{self, Read, Seek, SeekFrom, Write};

use crate::cl::{self, ReadSeek, Reader};
use crate::config::Config;
use crate::control::{self, Control, Encoder, Layout};
use crate::diag::{Diagnostic, Remarks, Severity, grouped};
use crate::kinematics::{AnyMachine, AxisKind, Invalid, Machine};
use crate::motion::{
    Abilities, ChordedArcs, Cost, Course, DiscardSteps, MovingAxes, Navigator, Planner, PlanningError, Sink, Source,
    Statistics, Times,
};
use crate::program::Location;
use crate::program::Units;

use account::Recorded;
pub(crate) use account::Stand;
pub use account::{Account, Origin};
pub use proof::{Proof, prove};
pub use survey::Stretches;
use survey::Survey;

/// What is to be posted, and how.
#[derive(Clone, Copy)]
pub struct Job<'a> {
    /// Name of the CL file, without its folder: it stands in the header.
    pub cl_name: &'a str,
    /// The set-up.
    pub config: &'a Config,
    /// The control that is to read the program.
    pub control: &'a dyn Control,
    /// Unit of a CL file that does not state one (`--units`); before that of the configuration.
    pub units: Option<Units>,
}

/// Why nothing can be said about the CL data.
#[derive(Debug, thiserror::Error)]
pub enum PostError {
    /// The CL data cannot be read.
    #[error("cannot read the CL data: {0}")]
    Input(#[source] io::Error),
    /// The program cannot be written.
    #[error("cannot write the program: {0}")]
    Output(#[source] io::Error),
    /// The control cannot do what the configuration asks for, or the machine does not suit the mode: one sentence a line.
    #[error("{0}")]
    Unfit(String),
    /// The operations that are wanted are not there.
    #[error("{0}")]
    Operations(String),
}

/// What became of a job.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Report {
    /// Everything found, in the order of the CL data.
    pub diagnostics: Vec<Diagnostic>,
    /// The program is not to be used: it ends with an error comment instead of the end code.
    pub failed: bool,
    /// What was met on the way.
    pub statistics: Statistics,
    /// How long the program takes.
    pub times: Times,
    /// Blocks written, comments not counted.
    pub blocks: u64,
    /// Lines of CL data read.
    pub lines: u64,
    /// Stretches of the program by what the tool axis does in them.
    pub stretches: Stretches,
    /// How the part is set up where that is not the plain case, one sentence each.
    pub set_up: Vec<String>,
    /// How the CL data was read: which CAM system wrote it, arcs, frames, words that were passed over.
    pub reading: Vec<String>,
    /// What the course of the rotary axes costs, with and without a view ahead; empty without rotary axes.
    pub course: String,
    /// What was assumed rather than given, one sentence each.
    pub assumptions: Vec<String>,
    /// Linear axes whose limits were not checked, and why; empty if all were.
    pub unchecked: Vec<String>,
    /// Tools by number, in the order of their numbers.
    pub tools: Vec<u32>,
}

/// `1 tool`, `2 tools`, `2 stretches`.
fn counted(count: u64, word: &str) -> String {
    let ending = match word.ends_with("ch") {
        _ if count == 1 => "",
        true => "es",
        false => "s",
    };
    format!("{} {word}{ending}", grouped(count))
}

impl Report {
    /// What the survey has found.
    fn of(machine: &dyn AnyMachine, job: &Job<'_>, survey: &Survey) -> Self {
        let mut report = Self {
            tools: survey.tools.iter().map(|tool| tool.call.number).collect(),
            lines: survey.file.lines,
            stretches: survey.stretches,
            set_up: header::set_up(job.config, survey),
            reading: header::reading(job.config, survey),
            assumptions: header::assumptions(machine, job.control, job.config, survey),
            ..Self::default()
        };
        survey.diagnostics.iter().for_each(|diagnostic| report.fault(diagnostic.clone()));
        report
    }

    /// Nothing is written: the machine cannot be built.
    fn refuse(&mut self, machine: &dyn AnyMachine, invalid: &Invalid) {
        self.fault(Diagnostic {
            severity: Severity::Error,
            location: Location::default(),
            length: 1,
            count: 1,
            text: format!("{} cannot be posted for: {invalid}", machine.name()),
            help: Some("correct the dimensions in the configuration".to_owned()),
        });
    }

    /// The summary for people, one line each.
    #[must_use]
    pub fn summary(&self) -> Vec<String> {
        let mut lines = vec![format!(
            "{}, {}, {}, {}, {} in inverse time",
            counted(self.statistics.motions, "motion"),
            counted(self.tools.len() as u64, "tool"),
            counted(self.blocks, "block"),
            counted(self.statistics.sequences, "safe sequence"),
            counted(self.statistics.inverse_time, "block"),
        )];
        lines.extend(time::lines(&self.times));
        lines.extend(self.set_up.iter().cloned());
        lines.extend(self.reading.iter().cloned());
        lines.extend((!self.course.is_empty()).then(|| self.course.clone()));
        lines.extend((!self.course.is_empty()).then(|| self.stretches.summary()));
        lines.extend(self.assumptions.iter().map(|assumption| format!("assumed: {assumption}")));
        lines.extend(self.unchecked.iter().cloned());
        if self.statistics.deviations > 0 {
            lines.push(format!(
                "tool axes outside what the machine reaches: {}, by up to {:.2e} rad; the nearest one was used",
                self.statistics.deviations, self.statistics.largest_deviation_rad
            ));
        }
        if self.statistics.near_pole > 0 {
            lines.push(format!(
                "tool axes near the pole that were put there: {}, by up to {:.2e} rad; the first rotary kept its value",
                self.statistics.near_pole, self.statistics.largest_at_pole_rad
            ));
        }
        let statistics = &self.statistics;
        if statistics.largest_tip_bound_mm > 0.0 {
            lines.push(format!(
                "linearised: {} inserted; while a rotary axis moves at feed the tip leaves its line by at most {:.4} mm, \
                 the tool axis its even turn by at most {:.4}°",
                counted(statistics.inserted, "block"),
                statistics.largest_tip_bound_mm,
                statistics.largest_axis_bound_rad.to_degrees(),
            ));
        }
        lines.extend(arcs_text(statistics));
        if statistics.cycles > 0 {
            lines.push(format!("holes by cycles of the control: {}", statistics.cycles));
        }
        lines.push("rapids are not linearised".to_owned());
        lines
    }

    fn fault(&mut self, diagnostic: Diagnostic) {
        self.failed |= diagnostic.severity == Severity::Error;
        self.diagnostics.push(diagnostic);
    }
}

/// How many arcs the control traces, and why others became lines.
fn arcs_text(statistics: &Statistics) -> Option<String> {
    let ChordedArcs { frame, plane, radius, rounding } = statistics.chorded;
    let reasons = [
        (frame, "rotary axes turn in them, or the linear axes are not square"),
        (plane, "in no plane in which the control has arcs"),
        (radius, "their radius is outside `[arcs]`"),
        (rounding, "rounded words do not say them within tolerance"),
    ];
    let total: u64 = reasons.iter().map(|(count, _)| count).sum();
    if statistics.arcs + total == 0 {
        return None;
    }
    let traced = format!("arcs: {} by the control", statistics.arcs);
    let why: Vec<String> =
        reasons.iter().filter(|(count, _)| *count > 0).map(|(count, why)| format!("{count} {why}")).collect();
    Some(if why.is_empty() { traced } else { format!("{traced}, {total} as lines: {}", why.join("; ")) })
}

/// What the course costs, and what it would cost motion by motion.
fn course_text(course: &Course, config: &Config) -> String {
    let cost = |cost: &Cost| {
        let degrees = cost.travel as f64 / 10_f64.powi(config.formats.rotary as i32);
        let time = match cost.time {
            0 => String::new(),
            time => format!(" in at least {:.1} s", time as f64 / 1e9),
        };
        format!("{}, {degrees:.1} degrees of travel{time}", counted(u64::from(cost.rewinds), "rewind"))
    };
    let planned = format!("rotary axes: {}", cost(&course.cost));
    match &course.greedy {
        _ if config.motion.course.greedy => format!("{planned}, chosen motion by motion"),
        None => format!("{planned}; motion by motion there would be no way through"),
        Some(greedy) if *greedy == course.cost => planned,
        Some(greedy) => format!("{planned}; motion by motion: {}", cost(greedy)),
    }
}

/// Posts CL data for a machine.
///
/// Faults of the CL data are in the report, not errors: what stands before the first of them is written, followed by an
/// error comment in the place of the end code.
///
/// # Errors
/// [`PostError`] if the configuration does not fit, the input cannot be read or the output not written.
pub fn post<M: Machine>(
    job: &Job<'_>,
    input: &mut (impl Read + Seek),
    output: &mut impl Write,
) -> Result<Report, PostError> {
    post_for(&M::default(), job, input, output, None)
}

/// [`post`] for a machine whose type is not known, with an account of each line that is written.
///
/// # Errors
/// Those of [`post`]; an account that cannot be written is an error of the output.
pub fn post_for(
    machine: &dyn AnyMachine,
    job: &Job<'_>,
    input: &mut dyn ReadSeek,
    output: &mut dyn Write,
    account: Option<&mut dyn Account>,
) -> Result<Report, PostError> {
    let unfit = control::unfit(machine, job.control, job.config.demands());
    if !unfit.is_empty() {
        return Err(PostError::Unfit(unfit.join("\n")));
    }
    let mut text = ClText::new(job, input)?;
    let ready = job.config.set_up.machine_for(machine);
    let mut survey = text.survey(machine, ready.as_deref().ok())?;
    if let (Some(Err(missing)), None) = (&survey.wanted, survey.first_error) {
        // What is wrong with the CL data is reported first: with it, operations may be missing.
        return Err(PostError::Operations(missing.clone()));
    }
    let mut report = Report::of(machine, job, &survey);
    let machine = match &ready {
        Ok(ready) => &**ready,
        Err(invalid) => {
            report.refuse(machine, invalid);
            return Ok(report);
        }
    };
    let course = std::mem::take(&mut survey.course);
    if machine.axes().iter().any(|axis| axis.kind == AxisKind::Rotary && !axis.held) {
        report.course = course_text(&course, job.config);
    }
    let units = job.config.output_units.unwrap_or_else(|| survey.file.units.unwrap_or(Units::Millimetres));
    let layout = Layout::new(machine, job.config.demands(), units, &survey.name);
    let abilities = control::abilities(job.control, job.config.demands());
    let pass = Pass { job, survey: &survey, machine, units, abilities: &abilities };
    let moving = if job.config.motion.rotaries.clamp.is_empty() {
        MovingAxes::default()
    } else {
        pass.rehearse(text.reader()?, course.clone())?
    };
    let recorded = Recorded::new(Encoder::new(job.control, &layout, output), account);
    pass.write(text.reader()?, recorded, course, moving, &mut report)?;
    report.diagnostics.sort_by_key(|diagnostic| diagnostic.location);
    Ok(report)
}

/// The CL text, which is read from its start in each pass.
struct ClText<'a> {
    job: &'a Job<'a>,
    input: &'a mut dyn ReadSeek,
    start: u64,
}

impl<'a> ClText<'a> {
    fn new(job: &'a Job<'a>, input: &'a mut dyn ReadSeek) -> Result<Self, PostError> {
        let start = input.stream_position().map_err(PostError::Input)?;
        Ok(Self { job, input, start })
    }

    fn options(&self) -> cl::Options {
        let config = self.job.config;
        cl::Options { units: self.job.units.or(config.cl_units), ..config.cl.clone() }
    }

    /// The first pass; without a machine there is no course.
    fn survey(&mut self, machine: &dyn AnyMachine, ready: Option<&dyn AnyMachine>) -> Result<Survey, PostError> {
        let policy = self.job.config.policy();
        let navigator = ready.map(|ready| Navigator::new(ready.to_boxed(), policy));
        let options = self.options();
        Survey::take(machine, &mut *self.input, options, policy, navigator).map_err(PostError::Input)
    }

    /// A reader at the start.
    fn reader(&mut self) -> Result<Reader<&mut dyn ReadSeek>, PostError> {
        self.input.seek(SeekFrom::Start(self.start)).map_err(PostError::Input)?;
        let options = self.options();
        Ok(Reader::new(&mut *self.input, options))
    }
}

/// What a pass that plans has to know.
struct Pass<'a> {
    job: &'a Job<'a>,
    survey: &'a Survey,
    machine: &'a dyn AnyMachine,
    units: Units,
    abilities: &'a Abilities,
}

impl Pass<'_> {
    fn planner<S: Sink>(&self, course: Course, sink: S) -> Planner<'_, S> {
        let Self { job, survey, machine, units, abilities } = *self;
        Planner::new(machine.to_boxed(), job.config.policy(), units, abilities, survey.upside_down, sink)
            .with_course(course)
            .with_tools(survey.order.clone())
            .with_operations(survey.wanted.clone().and_then(Result::ok))
    }

    /// Which rotary axes stay still for how long: the whole program is planned and nothing written.
    fn rehearse(&self, reader: Reader<impl Read>, course: Course) -> Result<MovingAxes, PostError> {
        let mut planner = self.planner(course, DiscardSteps);
        // What goes wrong here goes wrong again when the program is written, and is reported then.
        let _ = self.plan(reader, &mut planner, &mut Remarks::default())?;
        Ok(planner.rehearsed())
    }

    /// The last pass: header, program, and end code.
    fn write<W: Write>(
        &self,
        reader: Reader<impl Read>,
        recorded: Recorded<'_, '_, W>,
        course: Course,
        moving: MovingAxes,
        report: &mut Report,
    ) -> Result<(), PostError> {
        let Self { job, survey, machine, units, .. } = *self;
        let mut planner = self.planner(course, recorded).with_clamps(moving);
        let unchecked = planner.unchecked_axes();
        let header = header::Header { job, survey, units, machine, unchecked };
        let recorded = planner.sink();
        header.write(&report.assumptions, recorded.encoder()).map_err(PostError::Output)?;
        recorded.account_for_head().map_err(PostError::Output)?;

        let mut remarks = Remarks::default();
        let planned = self.plan(reader, &mut planner, &mut remarks)?;
        planner.take_warnings().into_iter().for_each(|remark| remarks.add(remark));
        report.diagnostics.append(&mut remarks.conclude());
        report.statistics = planner.statistics();
        report.times = planner.times().clone();
        report.unchecked = header::unchecked(&planner.unchecked_axes());
        match planned {
            Ok(()) => {}
            Err(PlanningError::Output(error)) => return Err(PostError::Output(error)),
            Err(PlanningError::Fault(diagnostic)) => report.fault(diagnostic),
        }
        let recorded = planner.sink();
        close(job, report, recorded.encoder()).map_err(PostError::Output)?;
        recorded.account_for_end().map_err(PostError::Output)?;
        report.blocks = recorded.encoder().blocks();
        recorded.encoder().finish().map_err(PostError::Output)
    }

    /// Plans the CL data from its first event to its last, or to the first error of the reader.
    fn plan<S: Sink>(
        &self,
        mut reader: Reader<impl Read>,
        planner: &mut Planner<'_, S>,
        remarks: &mut Remarks,
    ) -> Result<Result<(), PlanningError>, PostError> {
        let mut source = Source::new(self.machine, self.job.config.policy());
        let first_error = self.survey.first_error;
        let mut last = Location::default();
        loop {
            // Looked at where it lies: to move an event costs as much as to look at it.
            let found = reader.next_event();
            match &found {
                Err(_) => {
                    found.map_err(PostError::Input)?;
                }
                Ok(Some((at, event))) if first_error.is_none_or(|error| *at < error) => {
                    last = *at;
                    if let Err(stopped) = source.event(*at, event, planner) {
                        return Ok(Err(stopped));
                    }
                }
                _ if first_error.is_some() => {
                    let first = source.awaits_second_motion();
                    let released = source.finish(planner);
                    return Ok(if first { abandoned(released) } else { released });
                }
                Ok(Some(_)) => {}
                Ok(None) => return Ok(source.finish(planner).and_then(|()| planner.finish(last))),
            }
            if planner.has_warnings() {
                planner.take_warnings().into_iter().for_each(|remark| remarks.add(remark));
            }
        }
    }
}

/// What became of a first motion that still waited where the reader stopped: its approach depends on a motion that nobody
/// could read, so the reader's error is the one to be reported.
fn abandoned(released: Result<(), PlanningError>) -> Result<(), PlanningError> {
    match released {
        Err(PlanningError::Output(error)) => Err(PlanningError::Output(error)),
        Ok(()) | Err(PlanningError::Fault(_)) => Ok(()),
    }
}

/// The end code, or the first error in its place.
fn close<W: Write>(job: &Job<'_>, report: &Report, encoder: &mut Encoder<'_, W>) -> io::Result<()> {
    if !report.failed {
        let times = if job.config.control.program.times { time::lines(&report.times) } else { Vec::new() };
        return encoder.end(&times);
    }
    let errors = report.diagnostics.iter().filter(|diagnostic| diagnostic.severity == Severity::Error);
    if let Some(error) = errors.min_by_key(|error| error.location) {
        let text = format!("ERROR in {} line {}: {}", job.cl_name, error.location.line, error.text);
        encoder.comment(text.as_bytes())?;
    }
    encoder.comment(b"the program ends here: do not run it")
}
