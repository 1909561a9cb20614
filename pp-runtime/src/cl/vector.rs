//! The vector algebra that frames and axes of CL data need, and the largest coordinate of a point.

use super::text::{ClFault, Span};
use crate::nalgebra::Point3;

/// A kilometre: no machine goes there, and words of an NC program would overflow.
const LARGEST_COORDINATE_MM: f64 = 1e6;

/// The point, if a machine could be there.
#[inline]
pub(crate) fn within_a_kilometre(point: Point3<f64>, at: Span) -> Result<Point3<f64>, ClFault> {
    // A NaN fails the comparison, too.
    if point.iter().all(|value| value.abs() <= LARGEST_COORDINATE_MM) {
        return Ok(point);
    }
    Err(ClFault::new(
        "coordinate",
        at,
        "a coordinate is more than a kilometre from the origin",
        "check the point in the CAM system, and the unit of the file",
    ))
}

/// `a × b`.
pub(crate) fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// `a · b`.
pub(crate) fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Length of `a`.
pub(crate) fn length(a: [f64; 3]) -> f64 {
    dot(a, a).sqrt()
}

/// Largest difference of a component.
pub(crate) fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|i| (a[i] - b[i]).abs()).fold(0.0, f64::max)
}
