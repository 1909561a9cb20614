//! Geometry of a check: the chain of the machine as matrices, the path of a motion, the clearance geometry,
//! extrema along a path, and a tool along a contour.

mod chain;
mod clearance;
mod extrema;
mod path;
mod tool_fit;

pub(super) use chain::{Chain, Swing, TipRegion, ToolPose};
pub(super) use clearance::{depth_of_box, depth_of_line, distance_out, size};
pub(super) use extrema::{Extent, PathPoint, Search};
pub(crate) use path::angle_between;
pub(super) use path::{ArcPath, PathShape, RoundTip, Segment, bezier, is_within_angle, tool_pose};
pub(super) use tool_fit::{ContourSide, FitTool, FittedSide, NoFit};
