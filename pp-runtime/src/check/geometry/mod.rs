//! Geometry of a check: the chain of the machine as matrices, the path of a motion, the retract out of the clearance
//! geometry, and extrema along a path.

mod chain;
mod clearance;
mod extrema;
mod path;

pub(super) use chain::{Chain, ToolPose};
pub(super) use clearance::distance_out;
pub(super) use extrema::{Extent, PathPoint, Search};
pub(super) use path::{ArcPath, PathShape, Segment, angle_between, bezier, tool_pose};
