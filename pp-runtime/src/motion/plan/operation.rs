//! Settings of the operation that begins: mode, smoothing, tolerance and largest feed.
//!
//! The first pass has chosen the modes and the course by the same settings. A mode that machine or control cannot carry
//! out is refused here, where the operation begins, with its entry and key.

use crate::diag::code::plan;
use crate::motion::fault::{Fault, Planned};
use crate::motion::plan::Planner;
use crate::motion::source::{Chosen, OperationStart};
use crate::motion::step::{Sink, Step};
use crate::options::OperationChoice;
use crate::program::Units;

/// Largest feed of an operation.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct FeedCap {
    mm_per_min: f64,
    /// Its entry in a message.
    entry: String,
}

impl FeedCap {
    fn of(chosen: &Chosen<'_, f64>) -> Self {
        Self { mm_per_min: chosen.value, entry: chosen.by.shown() }
    }

    /// A feed of the CL data under this one, mm/min.
    pub(crate) fn caps(&self, feed: f64) -> f64 {
        feed.min(self.mm_per_min)
    }

    /// The feed of a thread follows from its pitch, mm/min.
    pub(crate) fn check_thread(&self, feed: f64, units: Units) -> Result<(), Fault> {
        if feed <= self.mm_per_min {
            return Ok(());
        }
        let text = format!(
            "`{} largest_feed` is {}, but pitch and spindle speed of this thread give {}",
            self.entry,
            units.feed(self.mm_per_min),
            units.feed(feed)
        );
        Err(plan::FEED.fault(text).help("lower the spindle speed of the thread, or raise `largest_feed`"))
    }
}

/// Takes the settings of the operation that begins.
#[cold]
pub(crate) fn begin<S: Sink>(planner: &mut Planner<'_, S>, start: &OperationStart<'_>) -> Planned {
    let chosen = &start.chosen;
    if let Some(mode) = chosen.mode
        && let Some(missing) = mode.value.of_all().and_then(|mode| planner.usable.missing(mode))
    {
        let refused = plan::MODE.fault(missing).context(entry(mode.by, "mode", mode.value.name()));
        return Err(refused.help("the mode of the program, or \"auto\", may suit this operation").into());
    }
    planner.mover.set_tip_tolerance(start.tolerance_mm);
    planner.feed_cap = chosen.largest_feed_mm_per_min.as_ref().map(FeedCap::of);
    if planner.policy.options.operations.sets_smoothing() {
        let level = chosen.smoothing.map(|smoothing| smoothing.value);
        let tolerance_mm = chosen.path_tolerance_mm.map(|tolerance| tolerance.value);
        planner.mover.output_mut().step(&Step::Smoothing { level, tolerance_mm })?;
    }
    Ok(())
}

/// A setting in a message: `[operations.3] mode = "tcp"`.
fn entry(by: &OperationChoice, key: &str, value: &str) -> String {
    format!("`{} {key} = \"{value}\"`", by.shown())
}
