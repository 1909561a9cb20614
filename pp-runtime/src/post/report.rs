//! The result of a job: figures of the survey and the planner, and the summary that is shown after posting.

use std::fmt::{self, Display, Formatter};

use super::survey::{Stretches, Survey, UsedModes};
use super::{Job, header, time};
use crate::config::Config;
use crate::diag::code::config;
use crate::diag::{Diagnostic, Severity, counted};
use crate::kinematics::{AnyMachine, Invalid};
use crate::motion::{ChordedArcs, Cost, Course, Statistics, Threads, Times};
use crate::program::{Location, Units};
use crate::set_up::SetUp;

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
    /// Threads that cycles of the control cut, in the order in which they are first cut.
    pub threads: Threads,
    /// Number of blocks written, without comments.
    pub blocks: u64,
    /// Number of lines of CL data read.
    pub lines: u64,
    /// Number of stretches in which the tool axis is held, and in which it turns.
    pub stretches: Stretches,
    /// Mode of the words, and those of the stretches.
    pub modes: UsedModes,
    /// Settings of the set-up that differ from the plain case, one sentence each.
    pub set_up: Vec<String>,
    /// How the CL data was read: CAM system, arcs, frames, words that were ignored. One sentence each.
    pub reading: Vec<String>,
    /// Rewinds and travel of the rotary axes; `None` without rotary axes.
    pub course: Option<RotaryCourse>,
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
    /// Unit of the program.
    pub units: Units,
}

/// Rewinds and travel of the rotary axes, by one way to choose their branches and turns.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RotaryTravel {
    /// Number of rewinds.
    pub rewinds: u32,
    /// Travel of all rotary axes, degrees.
    pub degrees: f64,
    /// Least time at the largest speeds of the axes, s; `None` where these are unknown.
    pub seconds: Option<f64>,
}

impl Display for RotaryTravel {
    fn fmt(&self, out: &mut Formatter<'_>) -> fmt::Result {
        let rewinds = counted(u64::from(self.rewinds), "rewind");
        write!(out, "{rewinds}, {:.1} degrees of travel", self.degrees)?;
        self.seconds.map_or(Ok(()), |seconds| write!(out, " in at least {seconds:.1} s"))
    }
}

/// The course of the rotary axes, and how it compares with a choice motion by motion.
#[derive(Debug, Clone, PartialEq)]
pub struct RotaryCourse {
    /// As planned.
    pub planned: RotaryTravel,
    /// As it would be if chosen motion by motion; `None` if there would be no solution.
    pub by_motion: Option<RotaryTravel>,
    /// It is chosen motion by motion (`course.greedy`).
    pub is_by_motion: bool,
}

impl RotaryCourse {
    pub(super) fn of(course: &Course, config: &Config) -> Self {
        let travel = |cost: &Cost| RotaryTravel {
            rewinds: cost.rewinds,
            degrees: cost.travel_units as f64 / 10_f64.powi(config.formats.rotary as i32),
            seconds: (cost.time_ns > 0).then(|| cost.time_ns as f64 / 1e9),
        };
        Self {
            planned: travel(&course.cost),
            by_motion: course.greedy.as_ref().map(travel),
            is_by_motion: config.motion.course.greedy,
        }
    }
}

impl Display for RotaryCourse {
    fn fmt(&self, out: &mut Formatter<'_>) -> fmt::Result {
        write!(out, "rotary axes: {}", self.planned)?;
        match &self.by_motion {
            _ if self.is_by_motion => out.write_str(", chosen motion by motion"),
            None => out.write_str("; chosen motion by motion there would be no solution"),
            Some(same) if *same == self.planned => Ok(()),
            Some(other) => write!(out, "; chosen motion by motion: {other}"),
        }
    }
}

impl Report {
    /// The report as far as the survey knows it.
    pub(super) fn of(machine: &dyn AnyMachine, job: &Job<'_>, survey: &Survey) -> Self {
        let units = header::units_of(job.config, survey);
        let header = header::Header { job, survey, units, machine, unchecked: Vec::new() };
        let mut report = Self {
            tools: survey.tools.iter().map(|tool| tool.call.number).collect(),
            tolerance_mm: job.config.motion.tolerance_mm,
            lines: survey.file.lines,
            stretches: survey.stretches,
            modes: UsedModes::of(job.config, survey),
            units,
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
    pub(super) fn refuse(&mut self, machine: &dyn AnyMachine, set_up: &SetUp, invalid: &Invalid) {
        let (text, help) = set_up.refusal(machine, invalid);
        self.fault(Diagnostic {
            code: config::DIMENSIONS,
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
        lines.extend(self.course.as_ref().map(RotaryCourse::to_string));
        lines.extend(self.rotary_end_text());
        let modes = self.course.as_ref().map(|_| format!("{}; mode {}", self.stretches.summary(), self.modes));
        lines.extend(modes);
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
        lines.extend(threads_text(&self.threads, self.units));
        lines.push(match statistics.links {
            0 => "rapids are not linearised".to_owned(),
            links => {
                format!("links on the path of the CL data, within tolerance: {links}; other rapids are not linearised")
            }
        });
        lines
    }

    pub(super) fn fault(&mut self, diagnostic: Diagnostic) {
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
fn threads_text(threads: &Threads, units: Units) -> Option<String> {
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
    (!list.is_empty()).then(|| format!("threads: {}", list.join(", ")))
}
