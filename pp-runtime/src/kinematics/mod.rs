//! Kinematics of a machine tool: its axes, poses, and the maps between axis values and poses.
//!
//! Units are millimetres and radians. *Forward* is always axes to pose, *inverse* pose to axes. Everything but
//! `digest`, `words` and `any`, the object-safe form of a machine, builds without `std` and allocates nothing;
//! [`machine!`](crate::machine) implements [`Machine`] for one declared machine.
//!
//! ```
//! use pp_runtime::kinematics::{Machine, Pose};
//! use pp_runtime::nalgebra::{Point3, UnitVector3, Vector3};
//! # pp_runtime::machine! {
//! #     /// A table that rotates about Z on a table that tilts about X.
//! #     pub struct Trunnion;
//! #     chain: C A | X Y Z;
//! # }
//!
//! let axis = UnitVector3::new_normalize(Vector3::new(0.0, -0.6, 0.8));
//! let pose = Pose { tip: Point3::new(10.0, 20.0, 30.0), axis };
//! let machine = Trunnion::default();
//! for solution in machine.inverse_kinematics(&pose, &Trunnion::HELD).iter() {
//!     let again = machine.forward_kinematics(&solution.axes);
//!     assert!((again.tip - pose.tip).norm() < 1e-9);
//! }
//! ```
//!
//! [`nearest`](nearest()) chooses among branches and revolutions, within the travel.

#![cfg_attr(not(test), deny(clippy::disallowed_methods))]

#[cfg(feature = "std")]
mod any;
#[cfg(feature = "std")]
mod digest;
mod explanation;
mod machine;
#[cfg(all(test, feature = "std"))]
pub(crate) mod machines;
pub mod math;
mod motion;
mod nearest;
#[cfg(feature = "simulate")]
mod ranges;
mod refusal;
mod solutions;
#[cfg(feature = "std")]
mod words;

#[cfg(feature = "std")]
pub(crate) use any::carried;
#[cfg(feature = "std")]
pub use any::{AnyMachine, AxisValues, MAX_AXES};
#[cfg(feature = "std")]
pub(crate) use digest::digest;
pub use explanation::{CSource, Explanation, Section};
pub use machine::{Axis, AxisKind, Dimension, DimensionKind, Joint, Limits, Machine, Pose, PoseTolerance, Side, Sign};
#[cfg(feature = "std")]
pub(crate) use motion::BlockDeviation;
#[cfg(feature = "simulate")]
pub(crate) use motion::StepBound;
pub use motion::{BlockCurves, Curve, MotionBound, RoughDeviation, curves_of_joints, rates_of_joints};
pub use nearest::{NotNearest, nearest};
#[cfg(feature = "simulate")]
pub(crate) use ranges::AxisRanges;
pub use refusal::{Cone, Invalid, Unreachable};
pub use solutions::{Branch, RotaryAngles, Solution, Solutions};
#[cfg(feature = "std")]
pub(crate) use words::{AngleScale, AxisUnits, LinearScale, OutOfLimits, Rotary, RotaryScale};

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
