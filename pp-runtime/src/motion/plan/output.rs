//! The only way out of the planner: each step leaves with its provenance, and what it adds to times and statistics.

use std::io;

use crate::diag::{Diagnostic, Severity};
use crate::program::Location;

use crate::motion::fault::Fault;
use crate::motion::place::Place;
use crate::motion::plan::feed::Pace;
use crate::motion::plan::machining_time::Times;
use crate::motion::plan::statistics::Statistics;
use crate::motion::step::{BlockReason, Provenance, ReachedPosition};
use crate::motion::step::{FeedWord, Sink, Step};

/// A deviation of the tool axis up to this is arithmetic, rad.
const NO_DEVIATION: f64 = 1e-12;

/// Writes steps, and keeps what is told about them at the end.
#[derive(Debug)]
pub(crate) struct Output<S> {
    sink: S,
    /// The record that the following steps serve.
    at: Option<Location>,
    /// Why the following steps are in the program.
    reason: BlockReason,
    /// Steps are written; else they are planned only.
    shown: bool,
    /// Inverse time is in force.
    inverse_time: bool,
    statistics: Statistics,
    times: Times,
    warnings: Vec<Diagnostic>,
}

impl<S: Sink> Output<S> {
    pub(crate) fn new(sink: S) -> Self {
        Self {
            sink,
            at: None,
            reason: BlockReason::Head,
            shown: true,
            inverse_time: false,
            statistics: Statistics::default(),
            times: Times::default(),
            warnings: Vec::new(),
        }
    }

    /// What the steps are written to.
    pub(crate) fn sink(&mut self) -> &mut S {
        &mut self.sink
    }

    /// What follows serves this record.
    #[inline]
    pub(crate) fn serve(&mut self, at: Location, reason: BlockReason) {
        (self.at, self.reason) = (Some(at), reason);
    }

    /// Why what follows is in the program.
    #[inline]
    pub(crate) fn set_reason(&mut self, reason: BlockReason) {
        self.reason = reason;
    }

    /// Whether what follows is written.
    pub(crate) fn show(&mut self, shown: bool) {
        self.shown = shown;
    }

    /// One step that moves nothing.
    pub(crate) fn step(&mut self, step: &Step<'_>) -> io::Result<()> {
        self.emit(step, self.reason, None)
    }

    /// One step, and where the machine is after it. `inserted`: it is a point that the record does not name.
    #[inline]
    pub(crate) fn move_step(
        &mut self,
        step: &Step<'_>,
        reached: ReachedPosition<'_>,
        inserted: Option<BlockReason>,
    ) -> io::Result<()> {
        self.emit(step, inserted.unwrap_or(self.reason), Some(reached))
    }

    #[inline]
    fn emit(&mut self, step: &Step<'_>, reason: BlockReason, reached: Option<ReachedPosition<'_>>) -> io::Result<()> {
        // The work offset is needed by the next restart point, whether what is around it is written or not.
        if self.shown || matches!(step, Step::WorkOffset { .. }) {
            self.sink.step(step, &Provenance { at: self.at, reason, reached })
        } else {
            Ok(())
        }
    }

    /// Inverse time never stays in force over a rapid.
    #[inline]
    pub(crate) fn cancel_inverse_time(&mut self) -> io::Result<()> {
        if std::mem::take(&mut self.inverse_time) { self.step(&Step::PerMinute) } else { Ok(()) }
    }

    /// A safety line: feed per minute is in force.
    pub(crate) fn restart(&mut self, number: u32) -> io::Result<()> {
        self.inverse_time = false;
        self.step(&Step::Restart { number })
    }

    /// A feed motion at this pace, in which an axis may turn fastest: its letter, and its angle in rad.
    #[inline]
    pub(crate) fn feed(&mut self, pace: &Pace, turn: Option<(char, f64)>) {
        let (at, Pace { feed, time_min, slowed_min }) = (self.location(), *pace);
        self.times.cut(time_min);
        if let Some((letter, angle)) = turn {
            self.times.rotate(letter, angle / (time_min - slowed_min), at);
        }
        if slowed_min > 0.0 {
            self.times.slow(at, slowed_min);
        }
        self.inverse_time = matches!(feed, FeedWord::InverseTime(_));
        self.statistics.inverse_time += u64::from(self.inverse_time);
    }

    /// How far a place is from the tool axis of the CL data.
    #[inline]
    pub(crate) fn count_deviation(&mut self, place: &Place) {
        if place.deviation > NO_DEVIATION {
            self.statistics.deviates(place.deviation, place.pole);
        }
    }

    /// What was met so far.
    pub(crate) fn statistics(&self) -> &Statistics {
        &self.statistics
    }

    pub(crate) fn statistics_mut(&mut self) -> &mut Statistics {
        &mut self.statistics
    }

    /// How long what was planned so far takes.
    pub(crate) fn times(&self) -> &Times {
        &self.times
    }

    pub(crate) fn times_mut(&mut self) -> &mut Times {
        &mut self.times
    }

    /// The record that is served.
    pub(crate) fn location(&self) -> Location {
        self.at.unwrap_or_default()
    }

    /// A remark on the record that is served.
    pub(crate) fn remark(&mut self, fault: Fault) {
        let at = self.location();
        self.add_remark(fault.at(at, Severity::Warning));
    }

    /// A remark with its location, on what is written; on anything else it is dropped.
    pub(crate) fn add_remark(&mut self, remark: Diagnostic) {
        if self.shown {
            self.warnings.push(remark);
        }
    }

    pub(crate) fn has_remarks(&self) -> bool {
        !self.warnings.is_empty()
    }

    /// Remarks since the last call.
    pub(crate) fn take_remarks(&mut self) -> Vec<Diagnostic> {
        std::mem::take(&mut self.warnings)
    }

    /// What was planned so far is not written: it counts for nothing but the operation that begins.
    pub(crate) fn forget_hidden(&mut self) {
        self.warnings.clear();
        self.statistics = Statistics::default();
        self.times.keep_last_operation();
    }
}
