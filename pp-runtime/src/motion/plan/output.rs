//! Output of the planner: passes each step to the sink with its provenance, and keeps times, statistics and remarks.
//!
//! No step leaves the planner by another path.

use std::io;

use crate::diag::code::plan;
use crate::diag::{Diagnostic, Severity};
use crate::program::Location;

use crate::motion::fault::{Fault, Planned};
use crate::motion::place::AxisPosition;
use crate::motion::plan::abilities::Abilities;
use crate::motion::plan::feed::Pace;
use crate::motion::plan::machining_time::{FastestRotation, Times};
use crate::motion::plan::statistics::Statistics;
use crate::motion::plan::threads::Threads;
use crate::motion::step::{BlockReason, Provenance, ReachedPosition};
use crate::motion::step::{FeedWord, Sink, Step};
use crate::tolerance::writer::NO_DEVIATION;

/// Whether the steps at hand may be skipped at the control.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
enum Skippable {
    /// They are always executed.
    #[default]
    No,
    /// They may be skipped; `any`: there has been one.
    Yes { any: bool },
}

/// Writes steps, and keeps times, statistics and remarks on them.
#[derive(Debug)]
pub(crate) struct Output<S> {
    sink: S,
    /// Record that the following steps belong to.
    at: Option<Location>,
    /// Reason for the following steps.
    reason: BlockReason,
    /// Steps are written; otherwise they are only planned.
    shown: bool,
    /// Inverse time is in force.
    inverse_time: bool,
    skippable: Skippable,
    guards: OutputGuards,
    statistics: Statistics,
    times: Times,
    threads: Threads,
    warnings: Vec<Diagnostic>,
}

/// Comparisons of the control.
#[derive(Debug, Clone, Copy)]
pub(crate) struct OutputGuards {
    /// They may be in blocks that are skipped.
    in_skipped: bool,
    /// What lies over the work offset is compared after each safety line.
    of_offset: bool,
    /// Such guards so far.
    offset_guards: u32,
}

impl OutputGuards {
    pub(crate) fn of(abilities: &Abilities) -> Self {
        Self { in_skipped: abilities.skips_guards, of_offset: abilities.guards_offset, offset_guards: 0 }
    }
}

impl<S: Sink> Output<S> {
    pub(crate) fn new(sink: S, guards: OutputGuards) -> Self {
        Self {
            sink,
            at: None,
            reason: BlockReason::Head,
            shown: true,
            inverse_time: false,
            skippable: Skippable::No,
            guards,
            statistics: Statistics::default(),
            times: Times::default(),
            threads: Threads::default(),
            warnings: Vec::new(),
        }
    }

    /// The sink of the steps.
    pub(crate) fn sink(&mut self) -> &mut S {
        &mut self.sink
    }

    /// Sets the record and the reason of the following steps.
    #[inline]
    pub(crate) fn serve(&mut self, at: Location, reason: BlockReason) {
        (self.at, self.reason) = (Some(at), reason);
    }

    /// Sets the reason of the following steps.
    #[inline]
    pub(crate) fn set_reason(&mut self, reason: BlockReason) {
        self.reason = reason;
    }

    /// Sets whether the following steps are written.
    pub(crate) fn show(&mut self, shown: bool) {
        self.shown = shown;
    }

    /// Writes one step that moves nothing.
    pub(crate) fn step(&mut self, step: &Step<'_>) -> io::Result<()> {
        self.emit(step, self.reason, None)
    }

    /// Writes a comparison of the control with what was posted.
    ///
    /// # Errors
    /// [`Fault`] where it may be skipped, and the control executes it all the same.
    pub(crate) fn guard(&mut self, step: &Step<'_>) -> Planned {
        if self.is_skippable() && !self.guards.in_skipped {
            let fault = plan::BLOCK_SKIP.fault(
                "a guard of tool length, radius or rotary positions comes between OPSKIP/ON and OPSKIP/OFF, and the control \
                 executes its IF whatever the block skip switch is set to",
            );
            return Err(fault
                .help("set `length_guard = false` and `plane_guard = false`, or post the optional operations as a program of their own (`--ops`)")
                .into());
        }
        Ok(self.step(step)?)
    }

    /// Whether the following steps may be skipped at the control.
    pub(crate) fn is_skippable(&self) -> bool {
        self.skippable != Skippable::No
    }

    /// Whether there has been a block since they may.
    pub(crate) fn has_skippable(&self) -> bool {
        self.skippable == Skippable::Yes { any: true }
    }

    /// The following steps may be skipped, or no longer. Steps that are not written cannot begin that.
    pub(crate) fn set_skippable(&mut self, on: bool) -> io::Result<()> {
        if on && !self.shown {
            return Ok(());
        }
        self.skippable = if on { Skippable::Yes { any: false } } else { Skippable::No };
        self.emit(&Step::BlockSkip { on }, self.reason, None)
    }

    /// Writes one step and the position after it. `inserted`: reason for a point that the record does not name.
    #[inline(always)]
    pub(crate) fn move_step(
        &mut self,
        step: &Step<'_>,
        reached: ReachedPosition<'_>,
        inserted: Option<BlockReason>,
    ) -> io::Result<()> {
        self.emit(step, inserted.unwrap_or(self.reason), Some(reached))
    }

    #[inline(always)]
    fn emit(&mut self, step: &Step<'_>, reason: BlockReason, reached: Option<ReachedPosition<'_>>) -> io::Result<()> {
        if let Skippable::Yes { any } = &mut self.skippable {
            let is_block = !matches!(
                step,
                Step::BlockSkip { .. }
                    | Step::Operation { .. }
                    | Step::Message { .. }
                    | Step::WorkOffset { .. }
                    | Step::Smoothing { .. }
            );
            *any |= is_block;
        }
        // The next restart point needs the work offset, and its cuts their smoothing, even where the steps around it
        // are not written.
        if self.shown
            || matches!(step, Step::WorkOffset { .. } | Step::Smoothing { .. } | Step::BlockSkip { on: false })
        {
            self.sink.step(step, &Provenance { at: self.at, reason, reached })
        } else {
            Ok(())
        }
    }

    /// Writes feed per minute if inverse time is in force: it must not stay in force over a rapid.
    #[inline]
    pub(crate) fn cancel_inverse_time(&mut self) -> io::Result<()> {
        if std::mem::take(&mut self.inverse_time) { self.step(&Step::PerMinute) } else { Ok(()) }
    }

    /// Writes a safety line, after which feed per minute is in force.
    pub(crate) fn restart(&mut self, number: u32, changes_tool: bool) -> io::Result<()> {
        self.inverse_time = false;
        self.step(&Step::Restart { number, changes_tool })?;
        self.guard_offset()
    }

    /// Writes the modes of a safety line again, after which feed per minute is in force.
    pub(crate) fn restate_modes(&mut self) -> io::Result<()> {
        self.inverse_time = false;
        self.step(&Step::Modes)?;
        self.guard_offset()
    }

    /// Compares what lies over the work offset. Blocks that may be skipped come after a safety line that has done so.
    fn guard_offset(&mut self) -> io::Result<()> {
        let executed = !self.is_skippable() || self.guards.in_skipped;
        if !(self.guards.of_offset && executed && self.shown) {
            return Ok(());
        }
        self.guards.offset_guards += 1;
        self.step(&Step::OffsetGuard { label: self.guards.offset_guards })
    }

    /// Counts a feed motion. `rotation`: letter and angle, rad, of the rotary axis that rotates most.
    #[inline(always)]
    pub(crate) fn feed(&mut self, pace: &Pace, rotation: Option<(char, f64)>) {
        let Pace { feed, time_min, slowed_min } = *pace;
        self.times.cut(time_min);
        if let Some((letter, angle_rad)) = rotation
            && let rad_per_min = angle_rad / (time_min - slowed_min)
            && self.times.is_fastest(rad_per_min)
        {
            self.times.fastest = Some(FastestRotation { letter, rad_per_min, at: self.location() });
        }
        if slowed_min > 0.0 {
            self.times.slow(self.location(), slowed_min);
        }
        self.inverse_time = matches!(feed, FeedWord::InverseTime(_));
        self.statistics.inverse_time += u64::from(self.inverse_time);
    }

    /// Counts a motion of the CL data that ends at a place.
    #[inline]
    pub(crate) fn count_motion(&mut self, place: &AxisPosition) {
        self.statistics.motions += 1;
        self.count_deviation(place);
    }

    /// Counts the deviation of a place from the tool axis of the CL data.
    #[inline]
    pub(crate) fn count_deviation(&mut self, place: &AxisPosition) {
        if place.deviation_rad > NO_DEVIATION {
            self.statistics.deviates(place.deviation_rad, place.at_pole);
        }
    }

    /// Statistics so far.
    pub(crate) fn statistics(&self) -> &Statistics {
        &self.statistics
    }

    pub(crate) fn statistics_mut(&mut self) -> &mut Statistics {
        &mut self.statistics
    }

    /// Machining times so far.
    pub(crate) fn times(&self) -> &Times {
        &self.times
    }

    pub(crate) fn times_mut(&mut self) -> &mut Times {
        &mut self.times
    }

    /// Threads so far.
    pub(crate) fn threads(&self) -> &Threads {
        &self.threads
    }

    pub(crate) fn threads_mut(&mut self) -> &mut Threads {
        &mut self.threads
    }

    /// Location of the current record.
    pub(crate) fn location(&self) -> Location {
        self.at.unwrap_or_default()
    }

    /// Adds a remark on the current record.
    pub(crate) fn remark(&mut self, fault: Fault) {
        let at = self.location();
        self.add_remark(fault.at(at, Severity::Warning));
    }

    /// Adds a remark with its location; dropped where steps are not written.
    pub(crate) fn add_remark(&mut self, remark: Diagnostic) {
        if self.shown {
            self.warnings.push(remark);
        }
    }

    pub(crate) fn has_remarks(&self) -> bool {
        !self.warnings.is_empty()
    }

    /// Takes the remarks since the last call.
    pub(crate) fn take_remarks(&mut self) -> Vec<Diagnostic> {
        std::mem::take(&mut self.warnings)
    }

    /// Drops remarks, statistics, threads and times of the steps that were not written, except those of the operation
    /// that begins.
    pub(crate) fn forget_hidden(&mut self) {
        self.warnings.clear();
        self.statistics = Statistics::default();
        self.threads = Threads::default();
        self.times.keep_last_operation();
    }
}
