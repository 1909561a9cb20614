//! The retract along the tool axis before a machine retract.

use super::super::geometry::{ToolPose, angle_between, distance_out};
use super::super::rules::Rules;
use crate::check::tolerances::{BOTH, LEADS_OUT, SAME_AXIS};
use crate::program::Clearance;

/// Length of the retract from where it began, mm; `done_mm` of it is done. `None` where the axis does not lead out of
/// the clearance geometry.
fn length(rules: &Rules<'_>, clearance: Option<&Clearance>, here: &ToolPose, done_mm: f64) -> Option<f64> {
    let out = clearance.and_then(|clearance| distance_out(clearance, &here.tip, &here.axis));
    rules.policy().links.retract_distance_mm.or(out.map(|out| out + done_mm))
}

/// Whether the tool is far enough out.
pub(super) fn is_out(rules: &Rules<'_>, clearance: Option<&Clearance>, here: &ToolPose, done_mm: f64) -> bool {
    match length(rules, clearance, here, done_mm) {
        Some(length) => done_mm + 2.0 * rules.rounding().tip_mm >= length,
        None => rules.retracts_along_tool() || done_mm > LEADS_OUT,
    }
}

/// Start of a retract: the tool on the path of the CL data.
#[derive(Clone, Copy)]
pub(super) struct RetractStart<'p> {
    pub(super) pose: &'p ToolPose,
    /// It is between the ends of a motion.
    pub(super) between: bool,
}

/// Rest of the retract and the pose after it, if that is where a block ends.
pub(super) fn rest(
    rules: &Rules<'_>,
    clearance: Option<&Clearance>,
    RetractStart { pose: from, between }: RetractStart<'_>,
    here: &ToolPose,
    end: &ToolPose,
    done_mm: f64,
) -> Option<(f64, ToolPose)> {
    if angle_between(&here.axis, &end.axis) > SAME_AXIS {
        return None;
    }
    // Near the pole the tool is at the pole, and retracts along it.
    [from.axis, here.axis].into_iter().find_map(|axis| {
        let from = ToolPose { tip: from.tip, axis };
        let length = length(rules, clearance, &from, done_mm)?;
        let rest = if rules.policy().links.retract_distance_mm.is_some() { length } else { length - done_mm };
        let out = ToolPose { tip: from.tip + axis * rest, axis };
        // Rounded words show a place between the ends with their own error.
        let roundings = if between { 1.0 + BOTH } else { BOTH };
        is_at_distance(rules, end, &out, roundings, rest).then_some((rest, out))
    })
}

/// Whether a pose is at a distance along a tool axis that is known to its rounding. `roundings`: those of a tip to
/// which `out` is known.
pub(super) fn is_at_distance(
    rules: &Rules<'_>,
    end: &ToolPose,
    out: &ToolPose,
    roundings: f64,
    distance_mm: f64,
) -> bool {
    let rounding = rules.rounding();
    // The rounding of the axis moves the far end across it.
    let (off, near) = (end.tip - out.tip, roundings * rounding.tip_mm);
    let along = off.dot(&out.axis).abs();
    along <= near
        && off.norm() <= near + distance_mm.abs() * rounding.axis_rad
        && rules.is_axis_near(&end.axis, &out.axis, 1.0)
}
