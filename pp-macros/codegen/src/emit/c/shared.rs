//! What the parts of the inverse share.

use crate::emit::inputs::InputVariables;
use crate::model::Model;
use crate::solve::PARALLEL_SINE_SQUARED;

/// Largest angle outside the reachable set, rad: `pp_runtime::kinematics::REACH_TOLERANCE`.
pub(super) const REACH_TOLERANCE: &str = "1e-6";

/// Sine below which the first rotary axis is free: `pp_runtime::kinematics::SINGULAR_SINE`.
pub(super) const SINGULAR_SINE: &str = "1e-15";

/// Variables of the inverse that hold its inputs.
pub(super) fn variables() -> InputVariables<'static> {
    InputVariables { tip: Some("tip"), axis: Some("axis"), words: Some("held"), turns: None }
}

/// Test that pose and held values are finite.
pub(super) fn finite(model: &Model) -> String {
    let held = model.axes.iter().enumerate().filter(|(_, axis)| axis.held.is_some());
    let held: String = held.map(|(place, _)| format!(" + held[{place}]")).collect();
    format!("isfinite(tip[0] + tip[1] + tip[2] + axis[0] + axis[1] + axis[2]{held})")
}

/// The bound below which directions count as parallel.
pub(super) fn parallel() -> String {
    format!("{PARALLEL_SINE_SQUARED:?}")
}
