//! Stages that the suites of the repository run on their own. It is no part of the interface and changes at any time.

use crate::config::Config;
use crate::control::{self, Control};
use crate::motion::{Abilities, Policy};

pub use crate::motion::{
    AxisWords, Cost, FeedWord, Navigator, Planner, PlanningError, Provenance, Sink, Source, Stage, Step,
};
pub use crate::shortcut::Shortcut;
#[cfg(debug_assertions)]
pub use crate::shortcut::without;

/// Functions of a control that the planner may use with a configuration.
#[must_use]
pub fn abilities(control: &dyn Control, config: &Config) -> Abilities {
    control::abilities(control, config.demands())
}

/// The part of a configuration that the planner reads.
#[must_use]
pub fn policy(config: &Config) -> Policy<'_> {
    config.policy()
}
