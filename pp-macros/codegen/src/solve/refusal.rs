//! Reasons to refuse a chain.

use crate::model::AxisId;

/// Square of the sine below which two directions count as parallel.
pub const PARALLEL_SINE_SQUARED: f64 = 1e-18;

/// The reason that a chain has no kinematics.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Refusal {
    /// The determinant of the linear axes vanishes for every pose (at the declared dimensions and held values).
    DependentLinears,
    /// The solved rotary nearest the tool is parallel to the tool axis.
    CannotTilt(AxisId),
    /// Both solved rotaries rotate about the same direction.
    SameDirection(AxisId, AxisId),
}
