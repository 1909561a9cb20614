//! Geometry of motions in the workpiece frame and in the words of a program; independent of the machine.

mod arc;
mod circle;
mod clearance;
mod clearance_in_force;
mod offset_contour;
mod path_segment;

pub(crate) use arc::{ArcGeometry, extent};
pub use circle::{ArcPlane, Circle};
pub(crate) use circle::{CircleDeviation, NominalCircle, WordGrid};
pub(crate) use clearance::{distance_to_clear, is_separated, line_enters};
pub(crate) use clearance_in_force::ClearanceGeometry;
pub use offset_contour::StraightCorners;
pub(crate) use offset_contour::{ContourArc, ContourElement, InPlane, OffsetContour, OffsetMisfit};
pub(crate) use path_segment::{PathSegment, angle_between};
