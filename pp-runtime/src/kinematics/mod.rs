//! Kinematics of a machine tool: its axes, poses, and the maps between axis values and poses.
//!
//! Units are millimetres and radians. *Forward* is always axes to pose, *inverse* pose to axes. Everything but `any`,
//! the object-safe form of a machine, builds without `std` and allocates nothing; [`machine!`](crate::machine) implements [`Machine`] for one declared machine.

#![cfg_attr(not(test), deny(clippy::disallowed_methods))]

#[cfg(feature = "std")]
pub mod any;
mod explanation;
mod machine;
#[cfg(all(test, feature = "std"))]
pub(crate) mod machines;
pub mod math;
mod motion;
#[cfg(feature = "simulate")]
mod ranges;
mod refusal;
mod solutions;

#[cfg(feature = "std")]
pub(crate) use any::AnyMachine;
#[cfg(feature = "std")]
pub use any::{AxisValues, MAX_AXES};
pub use explanation::{CSource, Explanation, Section};
pub use machine::{Axis, AxisKind, Dimension, DimensionKind, Joint, Limits, Machine, Pose, Side, Sign};
#[cfg(feature = "simulate")]
pub use motion::StepBound;
pub use motion::{Curve, MotionBound, motion_of_joints, rates_of_joints};
#[cfg(feature = "simulate")]
pub use ranges::AxisRanges;
pub use refusal::{Cone, Invalid, Unreachable};
pub use solutions::{Branch, RotaryAngles, Solution, Solutions};

/// Largest angle of a tool axis outside the reachable set at which it is still posted, rad.
///
/// CL data carries seven digits: an axis of `k = -5e-8` on a machine that reaches `k >= 0` is rounding. The nearest
/// reachable axis is used and the deviation is reported with the solution.
pub const REACH_TOLERANCE: f64 = 1e-6;

/// Sine of the angle between tool axis and first rotary axis below which the tool axis does not define that rotary
/// value.
pub const SINGULAR_SINE: f64 = 1e-15;

/// Smallest determinant of the unit directions of the linear axes for which they can be solved.
pub const SMALLEST_DETERMINANT: f64 = 1e-9;
