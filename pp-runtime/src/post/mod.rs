//! The pipeline: CL text → events → steps → blocks. The only module that sees both ends.
//!
//! The text is read twice, and a third time where rotary axes have clamps. The survey collects what the header needs and
//! what can only be known at the end: every diagnostic of the reader, the tools with their operations and extremes, and
//! whether all tool axes point into the table. The last pass plans and writes motion by motion, in constant memory. The
//! same input gives the same bytes.

mod account;
mod header;
mod proof;
mod setting;
mod survey;
mod time;

#[cfg(test)]
mod tests;

use std::io::{self, Read, Seek, SeekFrom, Write};

use crate::cl::{self, Reader};
use crate::config::Config;
use crate::control::{self, Control, Encoder, Layout};
use crate::diag::{Diagnostic, Remarks, Severity, grouped};
use crate::kinematics::{AxisKind, Machine};
use crate::motion::{Chorded, Cost, Course, Gate, Moving, Navigator, Nowhere, Planner, Sink, Statistics, Stop, Times};
use crate::program::Location;
use crate::program::Units;

use account::Recorded;
pub(crate) use account::Stand;
pub use account::{Account, Origin};
pub use proof::{Proof, prove};
pub(crate) use setting::Setting;
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

/// `1 tool`, `2 tools`.
fn counted(count: u64, word: &str) -> String {
    format!("{} {word}{}", grouped(count), if count == 1 { "" } else { "s" })
}

impl Report {
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
        lines.extend(self.assumptions.iter().map(|assumption| format!("assumed: {assumption}")));
        lines.extend(self.unchecked.iter().cloned());
        if self.statistics.deviations > 0 {
            lines.push(format!(
                "tool axes outside what the machine reaches: {}, by up to {:.2e} rad; the nearest one was used",
                self.statistics.deviations, self.statistics.largest_deviation
            ));
        }
        if self.statistics.near_pole > 0 {
            lines.push(format!(
                "tool axes near the pole that were put there: {}, by up to {:.2e} rad; the first rotary kept its value",
                self.statistics.near_pole, self.statistics.largest_at_pole
            ));
        }
        let statistics = &self.statistics;
        if statistics.largest_tip_bound > 0.0 {
            lines.push(format!(
                "linearised: {} inserted; while a rotary axis moves at feed the tip leaves its line by at most {:.4} mm, \
                 the tool axis its even turn by at most {:.4}°",
                counted(statistics.inserted, "block"),
                statistics.largest_tip_bound,
                statistics.largest_axis_bound.to_degrees(),
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
    let Chorded { frame, plane, radius, rounding } = statistics.chorded;
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
    post_with_account::<M>(job, input, output, None)
}

/// [`post`], and an account of each line that is written.
///
/// # Errors
/// Those of [`post`]; what the account cannot take counts as output.
pub fn post_with_account<M: Machine>(
    job: &Job<'_>,
    input: &mut (impl Read + Seek),
    output: &mut impl Write,
    account: Option<&mut dyn Account>,
) -> Result<Report, PostError> {
    let unfit = control::unfit::<M>(job.control, job.config.demands());
    if !unfit.is_empty() {
        return Err(PostError::Unfit(unfit.join("\n")));
    }
    let start = input.stream_position().map_err(PostError::Input)?;
    let options = cl::Options { units: job.units.or(job.config.cl_units), ..job.config.cl.clone() };
    let machine = job.config.set_up.machine::<M>();
    let navigator = machine.as_ref().ok().map(|machine| Navigator::new(machine.clone(), job.config.policy()));
    let mut survey = Survey::take(&mut *input, options.clone(), job.config, navigator).map_err(PostError::Input)?;
    input.seek(SeekFrom::Start(start)).map_err(PostError::Input)?;

    let wanted = match survey.wanted() {
        // What is wrong with the CL data is told first: with it, operations may be missing.
        Err(text) if survey.first_error.is_none() => return Err(PostError::Operations(text)),
        wanted => wanted.unwrap_or_default(),
    };
    let mut report = Report {
        tools: survey.tools.iter().map(|tool| tool.call.number).collect(),
        lines: survey.lines,
        ..Report::default()
    };
    for diagnostic in &survey.diagnostics {
        report.fault(diagnostic.clone());
    }
    let machine = match machine {
        Ok(machine) => machine,
        Err(invalid) => {
            report.fault(Diagnostic {
                severity: Severity::Error,
                location: Location::default(),
                length: 1,
                count: 1,
                text: format!("{} cannot be posted for: {invalid}", M::NAME),
                help: Some("correct the dimensions in the configuration".to_owned()),
            });
            return Ok(report);
        }
    };
    let units = job.config.output_units.unwrap_or_else(|| survey.units.unwrap_or(Units::Millimetres));
    if M::AXES.iter().any(|axis| axis.kind == AxisKind::Rotary && !axis.held) {
        report.course = course_text(&survey.course, job.config);
    }
    let layout = Layout::new::<M>(job.config.demands(), units, &survey.name);
    let mut recorded = Recorded::new(Encoder::new(job.control, &layout, &mut *output), account);
    let abilities = control::abilities(job.control, job.config.demands());
    let (upside_down, order) = (survey.upside_down(), std::mem::take(&mut survey.order));
    let course = std::mem::take(&mut survey.course);
    let planner = |course| {
        Planner::new(machine.clone(), job.config.policy(), units, abilities, upside_down)
            .with_course(course)
            .with_tools(order.clone())
    };
    let moving = if job.config.motion.rotaries.clamp.is_empty() {
        Moving::default()
    } else {
        let reader = Reader::new(&mut *input, options.clone());
        let moving = rehearse(job, &survey, reader, planner(course.clone())).map_err(PostError::Input)?;
        input.seek(SeekFrom::Start(start)).map_err(PostError::Input)?;
        moving
    };
    let planner = planner(course).with_operations(wanted).with_clamps(moving);
    report.set_up = header::set_up(job.config, &survey);
    report.reading = header::reading(job.config, &survey);
    report.assumptions = header::assumptions::<M>(job.control, job.config, &survey);
    let header = header::Header { job, survey: &survey, units, machine: &machine, unchecked: planner.unchecked_axes() };
    header.write(&report.assumptions, &mut recorded.encoder).map_err(PostError::Output)?;
    recorded.settle("head").map_err(PostError::Output)?;
    run(job, &survey, Reader::new(&mut *input, options), planner, &mut recorded, &mut report)?;
    report.blocks = recorded.encoder.blocks();
    report.diagnostics.sort_by_key(|diagnostic| diagnostic.location);
    recorded.encoder.finish().map_err(PostError::Output)?;
    Ok(report)
}

/// The second pass.
fn run<M: Machine, R: Read, W: Write>(
    job: &Job<'_>,
    survey: &Survey,
    reader: Reader<R>,
    mut planner: Planner<'_, M>,
    recorded: &mut Recorded<'_, '_, W>,
    report: &mut Report,
) -> Result<(), PostError> {
    let mut remarks = Remarks::default();
    let mut gate = Gate::new(recorded, planner.shows());
    let planned = plan(job, survey, reader, &mut planner, &mut gate, &mut remarks).map_err(PostError::Input)?;
    planner.take_warnings().into_iter().for_each(|remark| remarks.add(remark));
    report.diagnostics.append(&mut remarks.conclude());
    report.statistics = planner.statistics();
    report.times = planner.times().clone();
    report.unchecked = header::unchecked(&planner.unchecked_axes());
    match planned {
        Ok(()) => {}
        Err(Stop::Output(error)) => return Err(PostError::Output(error)),
        Err(Stop::Fault(diagnostic)) => report.fault(diagnostic),
    }
    close(job, report, &mut recorded.encoder).and_then(|()| recorded.settle("end")).map_err(PostError::Output)
}

/// Plans the CL data from its first event to its last.
fn plan<M: Machine>(
    job: &Job<'_>,
    survey: &Survey,
    mut reader: Reader<impl Read>,
    planner: &mut Planner<'_, M>,
    sink: &mut impl Sink,
    remarks: &mut Remarks,
) -> io::Result<Result<(), Stop>> {
    let mut setting = Setting::new(job.config);
    let mut last = Location::default();
    loop {
        // Looked at where it lies: to move an event costs as much as to look at it.
        let found = reader.next_event();
        match &found {
            Err(_) => {
                found?;
            }
            Ok(Some((at, event))) if survey.first_error.is_none_or(|error| *at < error) => {
                last = *at;
                let planned = match setting.event(event) {
                    Some(turned) => planner.event(*at, &turned, sink),
                    None => planner.event(*at, event, sink),
                };
                if let Err(stopped) = planned {
                    return Ok(Err(stopped));
                }
            }
            _ if survey.first_error.is_some() => return Ok(planner.abandon(sink).map_err(Stop::Output)),
            Ok(Some(_)) => {}
            Ok(None) => return Ok(planner.finish(last, sink)),
        }
        if planner.has_warnings() {
            planner.take_warnings().into_iter().for_each(|remark| remarks.add(remark));
        }
    }
}

/// Which rotary axes stay still for how long: the whole program is planned and nothing written.
fn rehearse<M: Machine>(
    job: &Job<'_>,
    survey: &Survey,
    reader: Reader<impl Read>,
    mut planner: Planner<'_, M>,
) -> io::Result<Moving> {
    // What goes wrong here goes wrong again when the program is written, and is told then.
    let _ = plan(job, survey, reader, &mut planner, &mut Nowhere, &mut Remarks::default())?;
    Ok(planner.rehearsed())
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
