//! The spindle: what the CL data wants, what the configuration adds, and what has been written.

use std::io;

use crate::motion::options::Policy;
use crate::program::{Dwell, Rotation, Spindle as Command};

use crate::motion::fault::{Fault, Planned};
use crate::motion::plan::output::Output;
use crate::motion::plan::tool::{LoadedTool, SpindleRequest};
use crate::motion::step::{Sink, Step};

/// The spindle while a program is planned.
#[derive(Debug, Clone, Default)]
pub(crate) struct SpindleState {
    request: SpindleRequest,
    /// What SPINDL has programmed since the last operation.
    between: SpindleRequest,
    /// Speed in rev/min and sense of rotation as written; `None` if it is off or unknown.
    running: Option<(f64, Rotation)>,
    /// SPINDL/OFF came after the last motion: written before the next, or when the tool is out of the part.
    stop_pending: bool,
    /// A cycle has stopped the spindle.
    stopped_by_cycle: bool,
}

impl SpindleState {
    /// SPINDL; `between`: two operations.
    pub(crate) fn request(&mut self, command: Command, between: bool) {
        self.request.take(command);
        if between {
            self.between.take(command);
        }
    }

    /// Another tool is called: the speed of one is not the speed of the other. What was programmed since the last operation
    /// is `meant` for the first tool that is called there.
    pub(crate) fn change_tool(&mut self, meant: bool) {
        self.request = if meant { self.between } else { SpindleRequest::default() };
    }

    /// An operation begins.
    pub(crate) fn begin_operation(&mut self) {
        self.between = SpindleRequest::default();
    }

    /// What the CL data has asked for.
    pub(crate) fn requested(&self) -> &SpindleRequest {
        &self.request
    }

    /// SPINDL/OFF was the last word.
    pub(crate) fn is_off_requested(&self) -> bool {
        self.request.off
    }

    /// Speed in rev/min and sense of rotation, where the spindle is known to be on.
    #[inline]
    pub(crate) fn running(&self) -> Option<(f64, Rotation)> {
        self.running
    }

    /// rev/min, where the spindle is known to be on.
    #[inline]
    pub(crate) fn speed(&self) -> Option<f64> {
        self.running.map(|(speed, _)| speed)
    }

    /// Its state is unknown.
    pub(crate) fn forget(&mut self) {
        self.running = None;
    }

    /// Its state is unknown, and nothing waits to stop it.
    pub(crate) fn reset(&mut self) {
        self.running = None;
        self.stop_pending = false;
    }

    /// A cycle has been run that stops it, or not.
    pub(crate) fn note_thread(&mut self, stops: bool) {
        self.stopped_by_cycle = stops;
    }

    /// Whether a cycle has stopped it since it was turned on.
    pub(crate) fn take_stopped_by_cycle(&mut self) -> bool {
        std::mem::take(&mut self.stopped_by_cycle)
    }

    /// Brings the spindle to what is wanted; `again`: even if it is so already.
    pub(crate) fn apply<S: Sink>(
        &mut self,
        again: bool,
        tool: Option<LoadedTool>,
        policy: Policy<'_>,
        output: &mut Output<S>,
    ) -> Planned {
        let given = tool.and_then(|tool| policy.set_up.tools.get(&tool.number));
        let Some((speed, rotation)) = self.request.resolve(given, policy)? else {
            // In the part the tool does not stop: see `stop_if_pending`.
            self.stop_pending |= self.running.is_some();
            return Ok(());
        };
        self.stop_pending = false;
        let wanted = Some((speed.value(), rotation));
        if policy.options.lift_mm.is_some() {
            // In a dry run the spindle is on on paper only; whoever enters here makes sure that it is off.
            self.running = wanted;
            return if again { Ok(output.step(&Step::SpindleOff)?) } else { Ok(()) };
        }
        if again || self.running != wanted {
            let starts = again || self.running.is_none_or(|(_, before)| before != rotation);
            self.running = wanted;
            output.step(&Step::Spindle { speed, rotation })?;
            if starts && policy.options.spindle_dwell_s > 0.0 {
                output.cancel_inverse_time()?;
                output.step(&Step::Dwell { seconds: policy.options.spindle_dwell_s })?;
            }
        }
        Ok(())
    }

    /// Stops the spindle, if that is what the CL data wanted after its last motion.
    #[inline]
    pub(crate) fn stop_if_pending<S: Sink>(&mut self, output: &mut Output<S>) -> io::Result<()> {
        if self.stop_pending { self.stop(output) } else { Ok(()) }
    }

    /// Off.
    pub(crate) fn stop<S: Sink>(&mut self, output: &mut Output<S>) -> io::Result<()> {
        self.reset();
        output.step(&Step::SpindleOff)
    }

    /// A dwell in seconds.
    pub(crate) fn seconds(&self, dwell: Dwell) -> Result<f64, Fault> {
        match (dwell, self.speed()) {
            (Dwell::Seconds(seconds), _) => Ok(seconds),
            (Dwell::Revolutions(turns), Some(speed)) => Ok(turns / speed * 60.0),
            (Dwell::Revolutions(_), None) => {
                Err(Fault::new("a wait of some turns of the spindle, and the spindle does not turn")
                    .help("give SPINDL before it, or the wait in seconds"))
            }
        }
    }
}
