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
mod survey;
mod time;

#[cfg(test)]
mod tests;

use std::io::{self, Read, Seek, Write};
use std::ops::ControlFlow;

use crate::cl::{ClData, ClEvents, FromHere, ReadSeek};
use crate::config::Config;
use crate::control::{self, Control, Encoder, Layout};
use crate::diag::{Diagnostic, Remarks, Severity, grouped};
use crate::kinematics::{AnyMachine, AxisKind, Invalid, Machine};
use crate::motion::{
    Abilities, ChordedArcs, Cost, Course, DiscardSteps, ModeFinder, MovingAxes, Navigator, Planner, PlanningError,
    Sink, Source, Threads, UsableModes,
};
use crate::program::Location;
use crate::program::Units;
use crate::set_up::SetUp;

pub use crate::motion::{Statistics, Times};
pub use checked::{CheckedProgram, post_checked};
pub(crate) use ending::ProgramEnd;
use line_map::MappedEncoder;
pub(crate) use line_map::{LineMap, LineOrigin, OwnedPosition};
pub(crate) use proof::{Proof, prove};
use survey::{Stretches, Survey};
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

/// Result of a job.
#[derive(Debug, Clone, PartialEq, Default)]
#[non_exhaustive]
pub struct Report {
    /// Errors and warnings, in the order of the CL data.
    pub diagnostics: Vec<Diagnostic>,
    /// The program must not be run: it ends with an error comment instead of the end code.
    pub failed: bool,
    /// Counts and largest deviations of the planner.
    pub statistics: Statistics,
    /// Machining times.
    pub times: Times,
    /// Pitch and number of the threads, one sentence; empty if there are none.
    pub threads: String,
    /// Number of blocks written, without comments.
    pub blocks: u64,
    /// Number of lines of CL data read.
    pub lines: u64,
    /// Number of stretches in which the tool axis is held, and in which it turns.
    pub stretches: Stretches,
    /// Mode of the words, and those of the stretches in mode `auto`.
    pub modes: String,
    /// Settings of the set-up that differ from the plain case, one sentence each.
    pub set_up: Vec<String>,
    /// How the CL data was read: CAM system, arcs, frames, words that were ignored. One sentence each.
    pub reading: Vec<String>,
    /// Rewinds and travel of the rotary axes, as planned and as they would be chosen motion by motion; empty without
    /// rotary axes.
    pub course: String,
    /// Angles of the rotary axes after the last motion, as the control displays them, degrees. An axis of unknown angle
    /// is left out.
    pub rotary_end: Vec<(char, f64)>,
    /// Assumptions: settings that were not given, one sentence each.
    pub assumptions: Vec<String>,
    /// Conditions on the states of the control, one sentence each.
    pub conditions: Vec<String>,
    /// What the words of axes mean, and what the control must hold for that, as in the header.
    pub settings: Vec<String>,
    /// Linear axes whose limits were not checked, a retract whose way was not compared, and contours whose tool has no
    /// known radius, with the reason; empty if all were.
    pub unchecked: Vec<String>,
    /// Tool numbers in ascending order.
    pub tools: Vec<u32>,
    /// `tolerance`, mm.
    pub tolerance_mm: f64,
}

/// A count with its noun: `1 tool`, `2 tools`, `2 stretches`.
fn counted(count: u64, word: &str) -> String {
    let ending = match word.ends_with("ch") {
        _ if count == 1 => "",
        true => "es",
        false => "s",
    };
    format!("{} {word}{ending}", grouped(count))
}

impl Report {
    /// The report as far as the survey knows it.
    fn of(machine: &dyn AnyMachine, job: &Job<'_>, survey: &Survey) -> Self {
        let units = header::units_of(job.config, survey);
        let header = header::Header { job, survey, units, machine, unchecked: Vec::new() };
        let mut report = Self {
            tools: survey.tools.iter().map(|tool| tool.call.number).collect(),
            tolerance_mm: job.config.motion.tolerance_mm,
            lines: survey.file.lines,
            stretches: survey.stretches,
            modes: header::modes(job.config, survey),
            set_up: header::set_up(machine, job.control, job.config, survey),
            reading: header::reading(job.config, survey),
            assumptions: header::assumptions(machine, job.control, job.config, survey),
            conditions: header::conditions(machine, job.control, job.config, survey),
            settings: header.settings(),
            ..Self::default()
        };
        survey.diagnostics.iter().for_each(|diagnostic| report.fault(diagnostic.clone()));
        report
    }

    /// Adds the error that the dimensions of the machine are invalid; nothing is written then.
    fn refuse(&mut self, machine: &dyn AnyMachine, set_up: &SetUp, invalid: &Invalid) {
        let (text, help) = set_up.refusal(machine, invalid);
        self.fault(Diagnostic {
            severity: Severity::Error,
            location: Location::default(),
            length: 1,
            count: 1,
            text,
            help: Some(help),
        });
    }

    /// The summary that is shown after posting, line by line.
    #[must_use]
    pub fn summary(&self) -> Vec<String> {
        let conditions = match self.conditions.len() {
            0 => None,
            count => Some(format!(
                "{} on the control: in the header and on the set-up sheet",
                counted(count as u64, "condition")
            )),
        };
        self.summary_with(&time::lines(&self.times), conditions.as_slice())
    }

    /// The summary with the conditions on the control, and without machining times, for a document that has those of
    /// the executed program.
    pub(crate) fn summary_without_times(&self) -> Vec<String> {
        let mut conditions: Vec<String> =
            self.conditions.iter().map(|condition| format!("condition: {condition}")).collect();
        conditions.extend(self.settings.iter().cloned());
        self.summary_with(&time::speeds(&self.times), &conditions)
    }

    fn summary_with(&self, times: &[String], conditions: &[String]) -> Vec<String> {
        let mut lines = vec![format!(
            "{}, {}, {}, {}, {} with inverse-time feed",
            counted(self.statistics.motions, "motion"),
            counted(self.tools.len() as u64, "tool"),
            counted(self.blocks, "block"),
            counted(self.statistics.sequences, "safe sequence"),
            counted(self.statistics.inverse_time, "block"),
        )];
        lines.extend_from_slice(times);
        lines.extend(self.set_up.iter().cloned());
        lines.extend(self.reading.iter().cloned());
        lines.extend((!self.course.is_empty()).then(|| self.course.clone()));
        lines.extend(self.rotary_end_text());
        lines.extend((!self.course.is_empty()).then(|| format!("{}; mode {}", self.stretches.summary(), self.modes)));
        lines.extend_from_slice(conditions);
        lines.extend(self.assumptions.iter().map(|assumption| format!("assumed: {assumption}")));
        lines.extend(self.unchecked.iter().cloned());
        if self.statistics.deviations > 0 {
            lines.push(format!(
                "tool axes out of reach of the machine: {}, by at most {:.1e}°; the nearest one within reach was used",
                self.statistics.deviations,
                self.statistics.largest_deviation_rad.to_degrees()
            ));
        }
        if self.statistics.near_pole > 0 {
            lines.push(format!(
                "tool axes set to the pole: {}, by at most {:.1e}°; the first rotary axis kept its value",
                self.statistics.near_pole,
                self.statistics.largest_at_pole_rad.to_degrees()
            ));
        }
        let statistics = &self.statistics;
        if statistics.largest_tip_bound_mm > 0.0 {
            lines.push(format!(
                "linearised: {} inserted; while a rotary axis moves at feed, the tip deviates from its line by at most \
                 {:.4} mm, the tool axis from its great circle by at most {:.4}°, and from where it should be at the tip by at \
                 most {:.4}°",
                counted(statistics.inserted, "block"),
                statistics.largest_tip_bound_mm,
                statistics.largest_axis_bound_rad.to_degrees(),
                statistics.largest_lag_rad.to_degrees(),
            ));
            lines.extend(self.surface_text());
        }
        if statistics.faint > 0 {
            lines.push(format!(
                "linear axes move by 1 or 2 last digits beside a rotation in {}: LinuxCNC up to 2.8.4 takes the time of such a block from \
                 them, and rotates at the speed of the axis",
                counted(statistics.faint, "block")
            ));
        }
        if statistics.largest_on_spot_rad > ON_SPOT {
            lines.push(format!(
                "at the pole a rotary axis rotates by up to {:.3}° with the tool in the cut and the tip at rest: \
                 `course.rotation_at_pole` sets a limit",
                statistics.largest_on_spot_rad.to_degrees()
            ));
        }
        lines.extend(arcs_text(statistics));
        if statistics.cycles > 0 {
            lines.push(format!("holes made with canned cycles: {}", statistics.cycles));
        }
        lines.extend((!self.threads.is_empty()).then(|| self.threads.clone()));
        lines.push(match statistics.links {
            0 => "rapids are not linearised".to_owned(),
            links => {
                format!("links on the path of the CL data, within tolerance: {links}; other rapids are not linearised")
            }
        });
        lines
    }

    fn fault(&mut self, diagnostic: Diagnostic) {
        self.failed |= diagnostic.severity == Severity::Error;
        self.diagnostics.push(diagnostic);
    }

    /// Angles of the rotary axes after the last motion.
    fn rotary_end_text(&self) -> Option<String> {
        let angles: Vec<String> =
            self.rotary_end.iter().map(|(letter, degrees)| format!("{letter} {degrees}")).collect();
        (!angles.is_empty()).then(|| format!("rotary axes after the last motion: {} degrees", angles.join(", ")))
    }

    /// How far the surface of a tool is off where its axis is not the programmed one: the tip is held.
    fn surface_text(&self) -> Option<String> {
        let Statistics { largest_axis_bound_rad: off_circle, largest_lag_rad: lag, surface, .. } = self.statistics;
        let angle = off_circle.max(lag);
        let per_mm = format!("the flank of a tool is off by at most {:.2} µm per mm of its length there", angle * 1e3);
        let Some(surface) = surface else { return (angle > 0.0).then_some(per_mm) };
        let (radius, off) = (surface.radius_mm, surface.off_mm());
        let mut text = format!("{per_mm}, a ball of R{radius} by at most {off:.4} mm");
        if off > self.tolerance_mm {
            let kept = ((self.tolerance_mm / radius).to_degrees() * 1e3).floor() / 1e3;
            // Where the rotary axes go evenly, only the distance from the great circle has a tolerance.
            let posture = if lag > off_circle { "`tool_posture = \"plane\"` with " } else { "" };
            text += &format!(
                "; warning: that is more than `tolerance` = {} mm, which {posture}`axis_tolerance_path = {kept}` keeps",
                self.tolerance_mm
            );
        }
        Some(text)
    }
}

/// Rotation with the tip at rest that the summary states, rad.
const ON_SPOT: f64 = 5_f64.to_radians();

/// Number of arcs written as arcs, and of those written as lines with the reasons.
fn arcs_text(statistics: &Statistics) -> Option<String> {
    let ChordedArcs { frame, plane, radius, rounding } = statistics.chorded;
    let reasons = [
        (frame, "in which a rotary axis moves, or the linear axes are not perpendicular"),
        (plane, "outside the planes in which the control has arcs"),
        (radius, "with a radius outside the limits of `[arcs]`"),
        (rounding, "that rounded words do not hold within the tolerance"),
    ];
    let total: u64 = reasons.iter().map(|(count, _)| count).sum();
    if statistics.arcs + total == 0 {
        return None;
    }
    let traced = format!("arcs: {} as arcs of the control", statistics.arcs);
    let why: Vec<String> =
        reasons.iter().filter(|(count, _)| *count > 0).map(|(count, why)| format!("{count} {why}")).collect();
    Some(if why.is_empty() { traced } else { format!("{traced}, {total} as lines: {}", why.join("; ")) })
}

/// Pitch and number of the threads of each tool.
fn threads_text(threads: &Threads, units: Units) -> String {
    let mut list: Vec<String> = threads
        .listed()
        .iter()
        .map(|thread| {
            let decimals = if units == Units::Inches { 5 } else { 3 };
            let hand = if thread.left { " left-hand" } else { "" };
            let error = units.deviation(thread.error_mm.abs());
            let rounded = match error.is_zero() {
                true => String::new(),
                false => format!(", rounded words change its length by up to {error}"),
            };
            format!(
                "T{} pitch {:.decimals$} {}{hand} ({}{rounded})",
                thread.tool,
                thread.pitch.value(),
                units.name(),
                counted(thread.holes, "hole")
            )
        })
        .collect();
    list.extend((threads.not_listed() > 0).then(|| counted(threads.not_listed(), "other hole")));
    if list.is_empty() { String::new() } else { format!("threads: {}", list.join(", ")) }
}

/// Rewinds and travel of the course, and what they would be if chosen motion by motion.
fn course_text(course: &Course, config: &Config) -> String {
    let cost = |cost: &Cost| {
        let degrees = cost.travel_units as f64 / 10_f64.powi(config.formats.rotary as i32);
        let time = match cost.time_ns {
            0 => String::new(),
            time => format!(" in at least {:.1} s", time as f64 / 1e9),
        };
        format!("{}, {degrees:.1} degrees of travel{time}", counted(u64::from(cost.rewinds), "rewind"))
    };
    let planned = format!("rotary axes: {}", cost(&course.cost));
    match &course.greedy {
        _ if config.motion.course.greedy => format!("{planned}, chosen motion by motion"),
        None => format!("{planned}; chosen motion by motion there would be no solution"),
        Some(greedy) if *greedy == course.cost => planned,
        Some(greedy) => format!("{planned}; chosen motion by motion: {}", cost(greedy)),
    }
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
        report.course = course_text(&course, job.config);
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
        report.threads = threads_text(planner.threads(), units);
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
