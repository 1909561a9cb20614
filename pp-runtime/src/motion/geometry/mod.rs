//! Geometry of motions in the workpiece and in the words of a program; knows no machine.

mod arc;
mod circle;
mod clearance;
mod sweep;

pub(crate) use arc::{Round, extent};
pub use circle::{ArcPlane, Circle};
pub(crate) use circle::{Grid, Nominal, Off};
pub(crate) use clearance::way_out;
pub(crate) use sweep::{SAME_AXIS, Way, angle_between, turn_between};
