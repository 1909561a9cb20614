//! Distance of a retract along the tool axis until the tool is clear of the part.

use nalgebra::{Point3, UnitVector3, Vector3};

use crate::program::Clearance;
use crate::tolerance::writer::{LEADS_TO_PLANE, NO_DIRECTION, PARALLEL_TO_FACE};

/// Distance along `axis` to the point after which the tool stays outside the clearance geometry, mm; 0 if it is outside
/// already, `None` if it never leaves.
pub(crate) fn distance_to_clear(clearance: &Clearance, tip: &Point3<f64>, axis: &UnitVector3<f64>) -> Option<f64> {
    match *clearance {
        Clearance::Plane(plane) => {
            let along = axis.dot(&plane.normal);
            (along > LEADS_TO_PLANE).then(|| ((plane.distance_mm - tip.coords.dot(&plane.normal)) / along).max(0.0))
        }
        Clearance::Box { lower, upper } => {
            let spans = [0, 1, 2].map(|i| span(tip[i], axis[i], lower[i], upper[i]));
            Some(last_inside(&spans))
        }
        Clearance::Cylinder { centre: [x, y], radius_mm: radius, lower_z_mm: lower, upper_z_mm: upper } => {
            let from = Vector3::new(tip.x - x, tip.y - y, 0.0);
            let across = Vector3::new(axis.x, axis.y, 0.0);
            let round = crossing(across.norm_squared(), from.dot(&across), from.norm_squared() - radius * radius);
            Some(last_inside(&[round, span(tip.z, axis.z, lower, upper)]))
        }
    }
}

/// Whether the straight line between two points leads into the clearance geometry, deeper than `graze_mm`.
pub(crate) fn line_enters(clearance: &Clearance, from: &Point3<f64>, to: &Point3<f64>, graze_mm: f64) -> bool {
    let by = to - from;
    let between = |i: usize, lower: f64, upper: f64| span(from[i], by[i], lower + graze_mm, upper - graze_mm);
    let inside = |spans: &[Option<(f64, f64)>]| common(spans).is_some_and(|(first, last)| first <= 1.0 && last >= 0.0);
    match *clearance {
        Clearance::Plane(plane) => {
            let height = |point: &Point3<f64>| point.coords.dot(&plane.normal) - plane.distance_mm;
            height(from).min(height(to)) < -graze_mm
        }
        Clearance::Box { lower, upper } => inside(&[0, 1, 2].map(|i| between(i, lower[i], upper[i]))),
        Clearance::Cylinder { centre: [x, y], radius_mm, lower_z_mm, upper_z_mm } => {
            let start = Vector3::new(from.x - x, from.y - y, 0.0);
            let across = Vector3::new(by.x, by.y, 0.0);
            let radius = (radius_mm - graze_mm).max(0.0);
            let round = crossing(across.norm_squared(), start.dot(&across), start.norm_squared() - radius * radius);
            inside(&[round, between(2, lower_z_mm, upper_z_mm)])
        }
    }
}

/// Whether a plane separates points from the clearance geometry, each by `margin_mm` at least: then the convex hull of
/// the points is outside. `false` also where no plane that touches a face is such a plane.
pub(crate) fn is_separated(clearance: &Clearance, points: &[Point3<f64>], margin_mm: f64) -> bool {
    let above = |normal: Vector3<f64>, face_mm: f64| {
        points.iter().all(|point| point.coords.dot(&normal) - face_mm >= margin_mm)
    };
    match *clearance {
        Clearance::Plane(plane) => above(plane.normal.into_inner(), plane.distance_mm),
        Clearance::Box { lower, upper } => (0..3).any(|i| {
            let normal = Vector3::ith(i, 1.0);
            above(normal, upper[i]) || above(-normal, -lower[i])
        }),
        Clearance::Cylinder { centre: [x, y], radius_mm, lower_z_mm, upper_z_mm } => {
            let centre = Vector3::new(x, y, 0.0);
            let sum: Vector3<f64> = points.iter().map(|point| point.coords - centre).sum();
            let aside = Vector3::new(sum.x, sum.y, 0.0).try_normalize(NO_DIRECTION);
            above(Vector3::z(), upper_z_mm)
                || above(-Vector3::z(), -lower_z_mm)
                || aside.is_some_and(|normal| above(normal, radius_mm + centre.dot(&normal)))
        }
    }
}

/// First and last parameter `t` at which `from + t * by` is between two values.
fn span(from: f64, by: f64, lower: f64, upper: f64) -> Option<(f64, f64)> {
    if by.abs() < PARALLEL_TO_FACE {
        return (lower..=upper).contains(&from).then_some((f64::NEG_INFINITY, f64::INFINITY));
    }
    let (a, b) = ((lower - from) / by, (upper - from) / by);
    Some((a.min(b), a.max(b)))
}

/// First and last parameter `t` at which `a t² + 2 b t + c` is not positive.
fn crossing(a: f64, b: f64, c: f64) -> Option<(f64, f64)> {
    if a < PARALLEL_TO_FACE * PARALLEL_TO_FACE {
        return (c <= 0.0).then_some((f64::NEG_INFINITY, f64::INFINITY));
    }
    let root = (b * b - a * c).sqrt();
    (!root.is_nan()).then(|| ((-b - root) / a, (-b + root) / a))
}

/// Largest parameter that is inside all spans and not negative; 0 if there is none.
fn last_inside(spans: &[Option<(f64, f64)>]) -> f64 {
    common(spans).map_or(0.0, |(_, last)| last.max(0.0))
}

/// First and last parameter that is inside all spans.
fn common(spans: &[Option<(f64, f64)>]) -> Option<(f64, f64)> {
    let mut inside = (f64::NEG_INFINITY, f64::INFINITY);
    for span in spans {
        let (first, last) = (*span)?;
        inside = (inside.0.max(first), inside.1.min(last));
    }
    Some(inside).filter(|(first, last)| first <= last)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::program::ClearancePlane;

    fn out(clearance: &Clearance, tip: [f64; 3], axis: [f64; 3]) -> Option<f64> {
        distance_to_clear(clearance, &Point3::from(tip), &UnitVector3::new_normalize(Vector3::from(axis)))
    }

    const BOX: Clearance =
        Clearance::Box { lower: Point3::new(-10.0, -20.0, -30.0), upper: Point3::new(10.0, 20.0, 5.0) };
    const CYLINDER: Clearance =
        Clearance::Cylinder { centre: [0.0; 2], radius_mm: 10.0, lower_z_mm: -30.0, upper_z_mm: 5.0 };

    #[test]
    fn a_tool_leaves_a_box_and_a_cylinder_where_its_axis_does() {
        for clearance in [BOX, CYLINDER] {
            assert_eq!(out(&clearance, [0.0; 3], [0.0, 0.0, 1.0]), Some(5.0));
            assert_eq!(out(&clearance, [4.0, 0.0, 0.0], [1.0, 0.0, 0.0]), Some(6.0));
            assert_eq!(out(&clearance, [0.0, 0.0, 6.0], [0.0, 0.0, 1.0]), Some(0.0));
            // Outside, but the axis leads through the part.
            assert_eq!(out(&clearance, [-15.0, 0.0, 0.0], [1.0, 0.0, 0.0]), Some(25.0));
            assert_eq!(out(&clearance, [-15.0, 25.0, 0.0], [1.0, 0.0, 0.0]), Some(0.0));
        }
    }

    #[test]
    fn a_plane_is_left_only_towards_it() {
        let plane = Clearance::Plane(ClearancePlane { normal: Vector3::z_axis(), distance_mm: 50.0 });
        assert_eq!(out(&plane, [0.0, 0.0, 20.0], [0.0, 0.0, 1.0]), Some(30.0));
        assert_eq!(out(&plane, [0.0, 0.0, 20.0], [1.0, 0.0, 0.0]), None);
        assert_eq!(out(&plane, [0.0, 0.0, 20.0], [0.0, 0.0, -1.0]), None);
        assert_eq!(out(&plane, [0.0, 0.0, 60.0], [0.0, 0.0, 1.0]), Some(0.0));
    }

    fn inside(clearance: &Clearance, point: &Point3<f64>) -> bool {
        match *clearance {
            Clearance::Box { lower, upper } => (0..3).all(|i| (lower[i]..=upper[i]).contains(&point[i])),
            Clearance::Cylinder { radius_mm: radius, lower_z_mm: lower, upper_z_mm: upper, .. } => {
                point.x.hypot(point.y) <= radius && (lower..=upper).contains(&point.z)
            }
            Clearance::Plane(_) => false,
        }
    }

    proptest! {
        #[test]
        fn beyond_the_distance_to_clear_nothing_is_inside(
            tip in proptest::array::uniform3(-25.0..25.0_f64),
            axis in proptest::array::uniform3(-1.0..1.0_f64),
            cylinder in proptest::bool::ANY,
        ) {
            prop_assume!(Vector3::from(axis).norm() > 0.1);
            let clearance = if cylinder { CYLINDER } else { BOX };
            let axis = UnitVector3::new_normalize(Vector3::from(axis));
            let distance = distance_to_clear(&clearance, &Point3::from(tip), &axis).expect("a distance");
            let at = |t: f64| Point3::from(tip) + axis.into_inner() * t;
            for step in 1..200 {
                prop_assert!(!inside(&clearance, &at(distance + 0.5 * f64::from(step))));
            }
            prop_assert!(distance <= 1e-9 || inside(&clearance, &at(distance - 1e-6)));
        }
    }

    proptest! {
        #[test]
        fn a_line_enters_where_a_point_of_it_is_inside(
            from in proptest::array::uniform3(-25.0..25.0_f64),
            to in proptest::array::uniform3(-25.0..25.0_f64),
            cylinder in proptest::bool::ANY,
        ) {
            let clearance = if cylinder { CYLINDER } else { BOX };
            let (from, to) = (Point3::from(from), Point3::from(to));
            let points: Vec<Point3<f64>> = (0..=400).map(|step| from + (to - from) * (f64::from(step) / 400.0)).collect();
            let enters = points.iter().any(|point| inside(&clearance, point));
            // Between two points less than 0.2 mm apart a line may cut a corner.
            prop_assert!(!enters || line_enters(&clearance, &from, &to, 0.0));
            prop_assert!(enters || !line_enters(&clearance, &from, &to, 0.2));
            prop_assert!(!enters || !is_separated(&clearance, &[from, to], 0.0));
        }
    }
}
