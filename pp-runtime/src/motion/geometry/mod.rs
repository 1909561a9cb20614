//! Geometry of motions in the workpiece frame and in the words of a program; independent of the machine.

mod arc;
mod circle;
mod clearance;
mod clearance_in_force;
mod offset_contour;
mod path_segment;

pub(crate) use arc::{ArcGeometry, extent};
pub(crate) use circle::{ArcPlane, Circle, CircleDeviation, NominalCircle, WordGrid};
pub(crate) use clearance::{distance_to_clear, is_separated, line_enters};
pub(crate) use clearance_in_force::ClearanceGeometry;
pub(crate) use offset_contour::{ContourArc, ContourElement, InPlane, OffsetContour, OffsetMisfit, StraightCorners};
pub(crate) use path_segment::{PathSegment, angle_between};
