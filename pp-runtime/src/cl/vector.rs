//! Vector algebra for frames and axes of CL data, and the limit on coordinates.

use super::text::{ClFault, Span};
use crate::diag::code::cl;
use crate::nalgebra::Point3;

/// Largest coordinate, one kilometre: no machine is larger, and words of an NC program would overflow.
const LARGEST_COORDINATE_MM: f64 = 1e6;

/// Returns the point, or a fault if a coordinate is above [`LARGEST_COORDINATE_MM`] or not a number.
#[inline(always)]
pub(crate) fn within_a_kilometre(point: Point3<f64>, at: Span) -> Result<Point3<f64>, Box<ClFault>> {
    // NaN fails this comparison, too.
    if point.iter().all(|value| value.abs() <= LARGEST_COORDINATE_MM) {
        return Ok(point);
    }
    Err(Box::new(cl::NUMBER.cl_fault(
        "coordinate",
        at,
        "a coordinate is more than a kilometre from the origin",
        "check the point in the CAM system, and the unit of the file",
    )))
}

/// `a × b`.
pub(crate) fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// `a · b`.
pub(crate) fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Whether the largest component of `a` is positive: it points along an axis of the frame, not against it.
pub(crate) fn points_up(a: [f64; 3]) -> bool {
    a.into_iter().fold(0.0_f64, |most, value| if value.abs() > most.abs() { value } else { most }) > 0.0
}

/// Length of `a`.
pub(crate) fn length(a: [f64; 3]) -> f64 {
    dot(a, a).sqrt()
}

/// Largest absolute difference of a component of `a` and `b`.
pub(crate) fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|i| (a[i] - b[i]).abs()).fold(0.0, f64::max)
}
