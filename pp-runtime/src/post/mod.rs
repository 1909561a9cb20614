//! Posting: CL text → events → steps → blocks. The only module that puts all stages together.
//!
//! The CL text is read twice, and a third time where rotary axes have clamps:
//!
//! 1. `survey` collects what the header needs and what is known only at the end of the text: all diagnostics of the
//!    reader, the tools with their operations and Z range, whether all tool axes point into the table, and the course
//!    (branch and turns of the rotary axes).
//! 2. With clamps only: a rehearsal plans the program without writing it, to find where a rotary axis can stay clamped.
//! 3. The last pass plans and writes motion by motion, in constant memory.
//!
//! The same input gives the same bytes.
//!
//! [`post_checked`] is the plain call, with an example; [`post`](post()) alone writes to a stream, in constant memory.

#![cfg_attr(not(test), deny(clippy::disallowed_methods))]

mod checked;
mod ending;
mod header;
mod line_map;
mod operations;
mod proof;
mod report;
mod survey;
mod time;

#[cfg(test)]
mod tests;

use std::io::{self, Read, Seek, Write};
use std::ops::ControlFlow;

use crate::cl::{ClData, ClEvents, FromHere, ReadSeek};
use crate::config::Config;
use crate::control::{self, Control, Encoder, Layout};
use crate::diag::code::config;
use crate::diag::{Diagnostic, Remarks, Severity};
use crate::kinematics::{AnyMachine, AxisKind, Machine};
use crate::motion::{
    Abilities, Course, DiscardSteps, ModeFinder, MovingAxes, Navigator, Planner, PlanningError, Sink, Source,
    UsableModes,
};
use crate::program::Location;
use crate::program::Units;

pub use crate::motion::{Statistics, Times};
pub use checked::{CheckedProgram, post_checked};
pub(crate) use ending::ProgramEnd;
use line_map::MappedEncoder;
pub(crate) use line_map::{LineMap, LineOrigin, OwnedPosition};
pub(crate) use proof::{Proof, prove};
pub use report::Report;
use report::RotaryCourse;
use survey::Survey;
pub(crate) use time::duration;

/// A posting job: set-up, control and name of the CL file.
#[derive(Clone, Copy)]
pub struct Job<'a> {
    /// Name of the CL file without its folder, for the header.
    pub cl_name: &'a str,
    /// The set-up.
    pub config: &'a Config,
    /// The control that will run the program.
    pub control: &'a dyn Control,
    /// Unit of a CL file that states none (`--units`); takes precedence over that of the configuration.
    pub units: Option<Units>,
}

/// Why a job could not be run.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum PostError {
    /// The CL data cannot be read.
    #[error("cannot read the CL data: {0}")]
    Input(#[source] io::Error),
    /// The program cannot be written.
    #[error("cannot write the program: {0}")]
    Output(#[source] io::Error),
    /// The control cannot do what the configuration asks for, or the machine does not suit the mode. One sentence per
    /// line.
    #[error("{0}")]
    Unfit(String),
    /// The selected operations are not in the CL data.
    #[error("{0}")]
    Operations(String),
}

/// Posts CL data for a machine.
///
/// Errors of the CL data are reported in [`Report::diagnostics`]. The program is then written up to the first of them
/// and ends with an error comment instead of the end code.
///
/// # Errors
/// [`PostError`] if the configuration does not suit control or machine, the selected operations do not exist, the input
/// cannot be read or the output not written.
pub fn post<M: Machine>(
    job: &Job<'_>,
    input: &mut (impl Read + Seek),
    output: &mut impl Write,
) -> Result<Report, PostError> {
    post_for(&M::default(), job, input, output, None)
}

/// [`post`] for a machine whose type is known at run time only, with a line map if `line_map` is given.
///
/// # Errors
/// Those of [`post`]; a line map that cannot be written is [`PostError::Output`].
pub(crate) fn post_for(
    machine: &dyn AnyMachine,
    job: &Job<'_>,
    input: &mut dyn ReadSeek,
    output: &mut dyn Write,
    line_map: Option<&mut dyn LineMap>,
) -> Result<Report, PostError> {
    let mut data = FromHere::new(input).map_err(PostError::Input)?;
    post_data(machine, job, &mut data, output, line_map)
}

/// [`post_for`] for CL data that may be read ahead.
///
/// # Errors
/// Those of [`post_for`].
pub(crate) fn post_data(
    machine: &dyn AnyMachine,
    job: &Job<'_>,
    data: &mut dyn ClData,
    output: &mut dyn Write,
    line_map: Option<&mut dyn LineMap>,
) -> Result<Report, PostError> {
    let unfit = job.config.unfit(machine, job.control);
    if !unfit.is_empty() {
        return Err(PostError::Unfit(unfit.join("\n")));
    }
    let config = job.config.for_control(job.control);
    let job = &Job { config: &config, ..*job };
    let mut text = ClText { job, data };
    let ready = job.config.set_up.machine_for(machine);
    let usable = control::usable_modes(ready.as_deref().unwrap_or(machine), job.control, job.config.demands());
    let mut survey = text.survey(machine, ready.as_deref().ok(), &usable)?;
    if let (Some(Err(missing)), None) = (&survey.selected, survey.first_error) {
        // Errors of the CL data are reported first: they may be why operations are missing.
        return Err(PostError::Operations(missing.clone()));
    }
    if let Some(tilted) = survey.tilted
        && !control::is_default_family(job.control)
        && job.config.part_origin_is_assumed()
        && header::has_positions(machine, job.control, job.config, &survey)
    {
        survey.refuse(unknown_part_origin(tilted));
    }
    if job.config.motion.guards.length_guard == Some(true)
        && survey.first_error.is_none()
        && let Some(tool) = survey.tools.iter().find(|tool| !header::can_guard_length(job, tool))
    {
        return Err(PostError::Unfit(unguarded(tool.call.number)));
    }
    let mut report = Report::of(machine, job, &survey);
    let machine = match &ready {
        Ok(ready) => &**ready,
        Err(invalid) => {
            report.refuse(machine, &job.config.set_up, invalid);
            return Ok(report);
        }
    };
    let course = std::mem::take(&mut survey.course);
    if machine.axes().iter().any(|axis| axis.kind == AxisKind::Rotary && !axis.held) {
        report.course = Some(RotaryCourse::of(&course, job.config));
    }
    let units = header::units_of(job.config, &survey);
    let abilities = control::abilities(job.control, job.config.demands());
    let layout = Layout::new(machine, job.config.demands(), &abilities, &survey.modes, units, &survey.name);
    let pass = PlanningPass { job, survey: &survey, usable: &usable, machine, units, abilities: &abilities };
    let moving = if job.config.motion.rotaries.clamp.is_empty() {
        MovingAxes::default()
    } else {
        pass.rehearse(text.events()?, course.clone())?
    };
    let mapped = MappedEncoder::new(Encoder::new(job.control, &layout, output), line_map);
    pass.write(text.events()?, mapped, course, moving, &mut report)?;
    report.diagnostics.sort_by_key(|diagnostic| diagnostic.location);
    Ok(report)
}

/// The error that `length_guard` is requested, and no block can compare the length of this tool.
fn unguarded(number: u32) -> String {
    format!(
        "`length_guard = true`, and no block of this control compares the length of T{number}: the length is not known, or the control \
         reads no other register than that of the tool; give `[tools.{number}] length` without `offset`, or remove `length_guard`"
    )
}

/// The error that the place of the part on a table that rotates is not known.
fn unknown_part_origin(location: Location) -> Diagnostic {
    Diagnostic {
        code: config::PART_ORIGIN,
        severity: Severity::Error,
        location,
        length: 1,
        count: 1,
        text: "the table rotates under words that are positions of the axes, and the place of the part on it is not known"
            .to_owned(),
        help: Some(
            "measure the part zero from the reference point of the table and give `part_origin`, [0.0, 0.0, 0.0] included; in \
             mode tcp and plane the work offset is enough"
                .to_owned(),
        ),
    }
}

/// The CL data of a job; each pass reads it from its start.
struct ClText<'a> {
    job: &'a Job<'a>,
    data: &'a mut dyn ClData,
}

impl ClText<'_> {
    /// The first pass. `ready`: the machine with the dimensions of the set-up; without it no course is planned.
    fn survey(
        &mut self,
        machine: &dyn AnyMachine,
        ready: Option<&dyn AnyMachine>,
        usable: &UsableModes,
    ) -> Result<Survey, PostError> {
        let policy = self.job.config.policy();
        let modes = ModeFinder::new(policy, usable);
        let navigator = ready.map(|ready| Navigator::new(ready.to_boxed(), policy).with_modes(usable));
        // The tool axis may depend on dimensions: that of the set-up, where it is valid.
        Survey::take(ready.unwrap_or(machine), self.events()?, policy, modes, navigator).map_err(PostError::Input)
    }

    /// The events from the start.
    fn events(&mut self) -> Result<ClEvents<'_>, PostError> {
        let config = self.job.config;
        self.data.events(config.reading(self.job.units)).map_err(PostError::Input)
    }
}

/// A pass that plans motions: the rehearsal or the last pass.
struct PlanningPass<'a> {
    job: &'a Job<'a>,
    survey: &'a Survey,
    usable: &'a UsableModes,
    machine: &'a dyn AnyMachine,
    units: Units,
    abilities: &'a Abilities,
}

impl PlanningPass<'_> {
    fn planner<S: Sink>(&self, course: Course, sink: S) -> Planner<'_, S> {
        let Self { job, survey, usable, machine, units, abilities } = *self;
        Planner::new(machine.to_boxed(), job.config.policy(), units, abilities, survey.upside_down, sink)
            .with_course(course)
            .with_modes(survey.modes.clone(), usable.clone())
            .with_tools(survey.order.clone())
            .with_compensated(survey.compensated.clone())
            .with_operations(survey.selected.clone().and_then(Result::ok))
    }

    /// Plans the whole program without writing it. Returns which axes move between each approach and the next.
    fn rehearse(&self, events: ClEvents<'_>, course: Course) -> Result<MovingAxes, PostError> {
        let mut planner = self.planner(course, DiscardSteps);
        // An error here occurs again when the program is written, and is reported then.
        let _ = self.plan(events, &mut planner, &mut Remarks::default())?;
        Ok(planner.rehearsed())
    }

    /// The last pass: writes header, blocks and end code.
    fn write(
        &self,
        events: ClEvents<'_>,
        mapped: MappedEncoder<'_, '_>,
        course: Course,
        moving: MovingAxes,
        report: &mut Report,
    ) -> Result<(), PostError> {
        let Self { job, survey, machine, units, .. } = *self;
        let mut planner = self.planner(course, mapped).with_clamps(moving);
        let unchecked = planner.unchecked_axes();
        let header = header::Header { job, survey, units, machine, unchecked };
        let mapped = planner.sink();
        header.write(&report.assumptions, mapped.encoder()).map_err(PostError::Output)?;
        mapped.map_head().map_err(PostError::Output)?;

        let mut remarks = Remarks::default();
        let planned = self.plan(events, &mut planner, &mut remarks)?;
        planner.take_warnings().into_iter().for_each(|remark| remarks.add(remark));
        report.diagnostics.append(&mut remarks.conclude());
        report.statistics = planner.statistics();
        report.times = planner.times().clone();
        report.threads = planner.threads().clone();
        report.unchecked = header::unchecked_limits(&planner.unchecked_axes());
        report.unchecked.extend(planner.blind_retract().map(|axis| {
            format!("machine retract: whether it leads away from the part is not compared: no machine_zero ({axis})")
        }));
        report.unchecked.extend(planner.unknown_radii().iter().map(|number| {
            format!(
                "cutter compensation: whether T{number} fits into its contours is not compared: its radius is unknown"
            )
        }));
        match planned {
            Ok(()) => report.rotary_end = planner.rotary_angles(),
            Err(PlanningError::Output(error)) => return Err(PostError::Output(error)),
            Err(PlanningError::Fault(diagnostic)) => report.fault(diagnostic),
        }
        let mapped = planner.sink();
        close(job, report, mapped.encoder()).map_err(PostError::Output)?;
        mapped.map_end().map_err(PostError::Output)?;
        report.blocks = mapped.encoder().blocks();
        mapped.encoder().finish().map_err(PostError::Output)
    }

    /// Plans the CL data from the first event to the last, or to the first error of the reader.
    fn plan<S: Sink>(
        &self,
        mut events: ClEvents<'_>,
        planner: &mut Planner<'_, S>,
        remarks: &mut Remarks,
    ) -> Result<Result<(), PlanningError>, PostError> {
        let mut source = Source::new(self.machine, self.job.config.policy());
        let first_error = self.survey.first_error;
        let mut last = Location::default();
        let stopped = events.all(|at, event| {
            if first_error.is_some_and(|error| at >= error) {
                return ControlFlow::Break(Ok(()));
            }
            last = at;
            if let Err(stopped) = source.event(at, event, planner) {
                return ControlFlow::Break(Err(stopped));
            }
            if planner.has_warnings() {
                planner.take_warnings().into_iter().for_each(|remark| remarks.add(remark));
            }
            ControlFlow::Continue(())
        });
        Ok(match stopped.map_err(PostError::Input)? {
            Some(Err(stopped)) => Err(stopped),
            _ if first_error.is_some() => {
                let first_is_waiting = source.awaits_second_motion();
                let released = source.finish(planner);
                if first_is_waiting { without_fault(released) } else { released }
            }
            _ => source.finish(planner).and_then(|()| planner.finish(last)),
        })
    }
}

/// Drops the fault of a first motion that was still held back when the reader stopped: its approach depends on the next
/// motion, which could not be read, so the error of the reader is the one to report.
fn without_fault(released: Result<(), PlanningError>) -> Result<(), PlanningError> {
    match released {
        Err(PlanningError::Output(error)) => Err(PlanningError::Output(error)),
        Ok(()) | Err(PlanningError::Fault(_)) => Ok(()),
    }
}

/// Writes the end code, or the first error in its place.
fn close(job: &Job<'_>, report: &Report, encoder: &mut Encoder<'_>) -> io::Result<()> {
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
