//! The spindle: request of the CL data, defaults of the configuration, and the state as written.

use std::io;

use crate::diag::code::plan;
use crate::motion::policy::Policy;
use crate::program::{Dwell, Rotation, Spindle as Command};

use crate::motion::fault::{Fault, Planned};
use crate::motion::plan::output::Output;
use crate::motion::plan::tool::{LoadedTool, ResolvedSpindle, SpindleRequest};
use crate::motion::step::{Sink, Step};

/// The spindle while a program is planned.
#[derive(Debug, Clone, Default)]
pub(crate) struct PlannedSpindle {
    request: SpindleRequest,
    /// Request of SPINDL since the last operation.
    between: SpindleRequest,
    /// Another tool has been called since the last operation.
    tool_called: bool,
    /// Speed in rev/min and sense of rotation as written; `None` if off or unknown.
    running: Option<(f64, Rotation)>,
    /// That speed as the CL data or the configuration has it.
    exact_rev_per_min: f64,
    /// A stop or NC text came after the last SPINDL: it is for the approach.
    held: bool,
    /// It may be on although `running` is unknown: since a stop, or NC text.
    uncertain: bool,
    /// It has been switched off, and nothing has come since that may switch it on.
    is_off: bool,
    /// SPINDL/OFF came after the last motion: written before the next, or when the tool is out of the part.
    stop_pending: bool,
    /// A cycle has stopped the spindle.
    stopped_by_cycle: bool,
}

impl PlannedSpindle {
    /// SPINDL; `between`: it comes between two operations.
    pub(crate) fn request(&mut self, command: Command, between: bool) {
        self.request.take(command);
        self.held = false;
        if between {
            self.between.take(command);
        }
    }

    /// Another tool is called; it does not take over the speed of the last one. A request since the last operation
    /// belongs to the first tool called after it.
    pub(crate) fn change_tool(&mut self) {
        if std::mem::replace(&mut self.tool_called, true) {
            self.between = SpindleRequest::default();
        }
        self.request = self.between;
    }

    /// An operation begins.
    pub(crate) fn begin_operation(&mut self) {
        self.between = SpindleRequest::default();
        self.tool_called = false;
    }

    /// Whether SPINDL has switched the spindle on since the last operation, stop or NC text.
    pub(crate) fn is_on_requested_between(&self) -> bool {
        self.between != SpindleRequest::default() && !self.between.off && !self.held
    }

    /// A stop or NC text comes: the spindle starts in the approach.
    pub(crate) fn hold(&mut self) {
        self.held = true;
    }

    /// Request of the CL data.
    pub(crate) fn requested(&self) -> &SpindleRequest {
        &self.request
    }

    /// Whether it may be on. It is off where a program begins.
    pub(crate) fn may_run(&self) -> bool {
        self.running.is_some() || self.uncertain
    }

    /// The program is entered here, or goes on, with the spindle off.
    pub(crate) fn enter(&mut self) {
        (self.running, self.uncertain, self.is_off) = (None, false, false);
    }

    /// Whether the last SPINDL was SPINDL/OFF.
    pub(crate) fn is_off_requested(&self) -> bool {
        self.request.off
    }

    /// Speed in rev/min and sense of rotation, where the spindle is known to be on.
    #[inline]
    pub(crate) fn running(&self) -> Option<(f64, Rotation)> {
        self.running
    }

    /// Speed in rev/min, where the spindle is known to be on.
    #[inline]
    pub(crate) fn speed(&self) -> Option<f64> {
        self.running.map(|(speed, _)| speed)
    }

    /// Speed in rev/min as the CL data or the configuration has it, where the spindle is known to be on.
    pub(crate) fn exact_speed(&self) -> Option<f64> {
        self.running.map(|_| self.exact_rev_per_min)
    }

    /// Forgets the state.
    pub(crate) fn forget(&mut self) {
        self.running = None;
        self.uncertain = true;
        self.is_off = false;
    }

    /// Forgets the state and a pending stop.
    pub(crate) fn reset(&mut self) {
        self.forget();
        self.stop_pending = false;
    }

    /// A tapping cycle has been written; `stops`: the spindle is off after it.
    pub(crate) fn note_thread(&mut self, stops: bool) {
        self.stopped_by_cycle = stops;
    }

    /// Whether a cycle has stopped the spindle since it was switched on.
    pub(crate) fn take_stopped_by_cycle(&mut self) -> bool {
        std::mem::take(&mut self.stopped_by_cycle)
    }

    /// Writes the requested state; `again`: even if it is in force.
    pub(crate) fn apply<S: Sink>(
        &mut self,
        again: bool,
        tool: Option<LoadedTool>,
        policy: Policy<'_>,
        output: &mut Output<S>,
    ) -> Planned {
        let given = tool.and_then(|tool| policy.set_up.tools.get(&tool.number));
        let Some(ResolvedSpindle { word: speed, exact_rev_per_min, rotation }) = self.request.resolve(given, policy)?
        else {
            // The spindle does not stop in the part: see `stop_if_pending`.
            self.stop_pending |= self.running.is_some() || self.request.off && self.uncertain;
            return Ok(());
        };
        let was_off = std::mem::take(&mut self.is_off);
        self.stop_pending = false;
        self.exact_rev_per_min = exact_rev_per_min;
        let wanted = Some((speed.value(), rotation));
        if policy.options.lift_mm.is_some() {
            // In a dry run the spindle is on only for the planner; the program writes once that it is off.
            (self.running, self.is_off) = (wanted, true);
            return if again || !was_off { Ok(output.step(&Step::SpindleOff)?) } else { Ok(()) };
        }
        if again || self.running != wanted {
            let stopped = std::mem::take(&mut self.stopped_by_cycle);
            let starts = again || stopped || self.running.is_none_or(|(_, before)| before != rotation);
            self.running = wanted;
            output.step(&Step::Spindle { speed, rotation })?;
            if starts && policy.options.spindle_dwell_s > 0.0 {
                output.cancel_inverse_time()?;
                output.step(&Step::Dwell { seconds: policy.options.spindle_dwell_s })?;
                output.times_mut().wait(policy.options.spindle_dwell_s / 60.0);
            }
        }
        Ok(())
    }

    /// Stops the spindle, if SPINDL/OFF came after the last motion.
    #[inline]
    pub(crate) fn stop_if_pending<S: Sink>(&mut self, output: &mut Output<S>) -> io::Result<()> {
        if self.stop_pending { self.stop(output) } else { Ok(()) }
    }

    /// Stops the spindle, unless the program has just done so.
    pub(crate) fn stop<S: Sink>(&mut self, output: &mut Output<S>) -> io::Result<()> {
        let is_written = self.is_off;
        self.reset();
        (self.uncertain, self.is_off) = (false, true);
        if is_written { Ok(()) } else { output.step(&Step::SpindleOff) }
    }

    /// Duration of a dwell, s.
    pub(crate) fn seconds(&self, dwell: Dwell) -> Result<f64, Fault> {
        match (dwell, self.speed().filter(|_| !self.stop_pending)) {
            (Dwell::Seconds(seconds), _) => Ok(seconds),
            (Dwell::Revolutions(revolutions), Some(speed)) => Ok(revolutions / speed * 60.0),
            (Dwell::Revolutions(_), None) => Err(plan::SPINDLE
                .fault("a dwell in spindle revolutions while the spindle is off")
                .help("give SPINDL before it, or the dwell in seconds")),
        }
    }
}
