//! Retract along the tool axis out of the clearance geometry.
//!
//! Along a line the height above a convex body is a convex function: its lowest point is found by sections, and the point
//! where the line leaves the body by bisection. Nothing is solved in closed form.

use nalgebra::Vector3;

use crate::program::Clearance;

/// Smallest cosine between the tool axis and the normal of a clearance plane.
const LEADS_TO_PLANE: f64 = 1e-3;

/// Sections and bisections: the interval is 1e-18 of the first one after them.
const STEPS: u32 = 100;

/// Distance along the tool axis after which the tip stays outside the clearance geometry, mm; 0 where it is outside and
/// the axis leads away, `None` where the axis never leads out.
pub(crate) fn distance_out(clearance: &Clearance, tip: &Vector3<f64>, axis: &Vector3<f64>) -> Option<f64> {
    if let Clearance::Plane(plane) = clearance {
        let (rise, height) = (axis.dot(&plane.normal), plane.distance_mm - tip.dot(&plane.normal));
        return (rise > LEADS_TO_PLANE).then(|| if height > 0.0 { height / rise } else { 0.0 });
    }
    let at = |distance: f64| height(clearance, &(tip + axis * distance));
    let far = tip.norm() + size(clearance);
    let lowest = lowest(0.0, far, at);
    if at(lowest) > 0.0 {
        return Some(0.0);
    }
    let (mut inside, mut outside) = (lowest, far);
    for _ in 0..STEPS {
        let middle = f64::midpoint(inside, outside);
        if at(middle) > 0.0 { outside = middle } else { inside = middle }
    }
    Some(inside)
}

/// Height of a point above the surface, mm: not above 0 inside. Convex, and no shorter than the distance from a face.
fn height(clearance: &Clearance, point: &Vector3<f64>) -> f64 {
    match clearance {
        Clearance::Plane(plane) => point.dot(&plane.normal) - plane.distance_mm,
        Clearance::Box { lower, upper } => {
            let faces = (0..3).flat_map(|axis| [lower[axis] - point[axis], point[axis] - upper[axis]]);
            faces.fold(f64::NEG_INFINITY, f64::max)
        }
        Clearance::Cylinder { centre: [x, y], radius_mm, lower_z_mm, upper_z_mm } => {
            let round = (point.x - x).hypot(point.y - y) - radius_mm;
            round.max(lower_z_mm - point.z).max(point.z - upper_z_mm)
        }
    }
}

/// Length beyond which no point of the body is from the origin, mm.
fn size(clearance: &Clearance) -> f64 {
    let corner = match clearance {
        Clearance::Plane(_) => 0.0,
        Clearance::Box { lower, upper } => lower.coords.norm() + upper.coords.norm(),
        Clearance::Cylinder { centre: [x, y], radius_mm, lower_z_mm, upper_z_mm } => {
            x.hypot(*y) + radius_mm + lower_z_mm.abs() + upper_z_mm.abs()
        }
    };
    2.0 * corner + 1.0
}

/// Where a convex function is lowest between two arguments.
fn lowest(mut low: f64, mut high: f64, value: impl Fn(f64) -> f64) -> f64 {
    for _ in 0..STEPS {
        let third = (high - low) / 3.0;
        let (left, right) = (low + third, high - third);
        if value(left) <= value(right) { high = right } else { low = left }
    }
    // An end is met exactly.
    [low, f64::midpoint(low, high), high].into_iter().min_by(|a, b| value(*a).total_cmp(&value(*b))).unwrap_or(low)
}

#[cfg(test)]
mod tests {
    use nalgebra::Point3;

    use super::*;
    use crate::program::ClearancePlane;

    fn out(clearance: &Clearance, tip: [f64; 3], axis: [f64; 3]) -> Option<f64> {
        distance_out(clearance, &Vector3::from(tip), &Vector3::from(axis).normalize())
    }

    const BOX: Clearance =
        Clearance::Box { lower: Point3::new(-10.0, -20.0, -30.0), upper: Point3::new(10.0, 20.0, 5.0) };
    const CYLINDER: Clearance =
        Clearance::Cylinder { centre: [1.0, 2.0], radius_mm: 10.0, lower_z_mm: -30.0, upper_z_mm: 5.0 };

    fn is(found: Option<f64>, wanted: f64) -> bool {
        found.is_some_and(|found| (found - wanted).abs() < 1e-9)
    }

    #[test]
    fn a_tool_leaves_a_box_through_the_face_that_its_axis_meets() {
        assert!(is(out(&BOX, [0.0; 3], [0.0, 0.0, 1.0]), 5.0));
        assert!(is(out(&BOX, [4.0, 0.0, 0.0], [1.0, 0.0, 0.0]), 6.0));
        assert!(is(out(&BOX, [0.0, 0.0, 5.0], [1.0, 0.0, 0.0]), 10.0), "along a face");
        assert!(is(out(&BOX, [0.0, 0.0, 6.0], [0.0, 0.0, 1.0]), 0.0));
        assert!(is(out(&BOX, [-15.0, 0.0, 0.0], [1.0, 0.0, 0.0]), 25.0), "outside, and the axis leads through");
        assert!(is(out(&BOX, [-15.0, 25.0, 0.0], [1.0, 0.0, 0.0]), 0.0));
        assert!(is(out(&BOX, [0.0, 0.0, 0.0], [3.0, 0.0, 4.0]), 6.25));
    }

    #[test]
    fn a_tool_leaves_a_cylinder_through_its_side_or_its_end() {
        assert!(is(out(&CYLINDER, [1.0, 2.0, 0.0], [0.0, 0.0, 1.0]), 5.0));
        assert!(is(out(&CYLINDER, [1.0, 8.0, 0.0], [1.0, 0.0, 0.0]), 8.0));
        assert!(is(out(&CYLINDER, [1.0, 15.0, 0.0], [0.0, 1.0, 0.0]), 0.0));
    }

    #[test]
    fn a_plane_is_left_only_towards_it() {
        let plane = Clearance::Plane(ClearancePlane { normal: Vector3::z_axis(), distance_mm: 50.0 });
        assert!(is(out(&plane, [0.0, 0.0, 20.0], [0.0, 0.6, 0.8]), 37.5));
        assert_eq!(out(&plane, [0.0, 0.0, 20.0], [1.0, 0.0, 0.0]), None);
        assert_eq!(out(&plane, [0.0, 0.0, 20.0], [0.0, 0.0, -1.0]), None);
        assert!(is(out(&plane, [0.0, 0.0, 60.0], [0.0, 0.0, 1.0]), 0.0));
    }
}
