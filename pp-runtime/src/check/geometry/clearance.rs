//! The clearance geometry: the retract along the tool axis out of it, and the depth to which a motion leads into it.
//!
//! Along a line the height above a convex body is a convex function: its lowest point is found by sections, and the
//! point where the line leaves the body by bisection. Nothing is solved in closed form.
//!
//! The height is the largest of the distances from a few planes. A box of axis values whose tips are all on the outer
//! side of one of them does not reach into the body; a box of which that is not sure is halved.

use nalgebra::Vector3;

use super::super::read::MAX_AXES;
use super::{Chain, TipRegion};
use crate::check::tolerances::LEADS_TO_PLANE;
use crate::program::Clearance;

/// Share of the largest depth that is reported at least.
const NEARLY: f64 = 0.95;

/// Largest number of boxes that are examined for one motion; the rest counts as inside.
const MOST_BOXES: usize = 20_000;

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

/// Depth to which a straight motion leads into the body, mm; negative where it stays outside.
pub(crate) fn depth_of_line(clearance: &Clearance, from: &Vector3<f64>, to: &Vector3<f64>) -> f64 {
    let at = |share: f64| height(clearance, &from.lerp(to, share));
    -at(lowest(0.0, 1.0, at))
}

/// Depth of the deepest tip whose axes are anywhere between two positions, if it is deeper than `allowed_mm`; mm. Each
/// axis takes any value between its own two, whatever the others do. Without a result no tip is deeper than
/// `allowed_mm` by `accuracy_mm`; a result is the depth of a tip, at least [`NEARLY`] of the largest. Where
/// [`MOST_BOXES`] do not suffice it may be less, and a bound if no such tip has been seen.
pub(crate) fn depth_of_box(
    clearance: &Clearance,
    chain: &Chain,
    [from, to]: [&[f64; MAX_AXES]; 2],
    allowed_mm: f64,
    accuracy_mm: f64,
) -> Option<f64> {
    let middle = |index: usize| f64::midpoint(from[index], to[index]);
    let half = |index: usize| 0.5 * (to[index] - from[index]).abs();
    let mut boxes = vec![(std::array::from_fn(middle), std::array::from_fn(half))];
    let (mut examined, mut deepest): (usize, Option<f64>) = (0, None);
    while let Some((values, by)) = boxes.pop() {
        let region = chain.around(&values, &by);
        let bound = -lowest_height(clearance, &region);
        if bound <= deepest.map_or(allowed_mm + accuracy_mm, |depth| depth / NEARLY) {
            continue;
        }
        examined += 1;
        if examined > MOST_BOXES {
            return Some(deepest.unwrap_or(bound));
        }
        let depth = -height(clearance, &region.tip);
        if depth > deepest.unwrap_or(allowed_mm + 0.5 * accuracy_mm) {
            deepest = Some(depth);
        }
        let halved = if region.bend_mm > 0.5 * accuracy_mm { region.most_bent() } else { region.widest() };
        for side in [-0.5, 0.5] {
            let (mut values, mut by): ([f64; MAX_AXES], [f64; MAX_AXES]) = (values, by);
            values[halved] += side * by[halved];
            by[halved] *= 0.5;
            boxes.push((values, by));
        }
    }
    deepest
}

/// A height above the surface below which no tip of a region is, mm: the largest distance from one of the planes.
fn lowest_height(clearance: &Clearance, region: &TipRegion) -> f64 {
    let tip = &region.tip;
    let along = |direction: Vector3<f64>, height: f64| height - region.extent_mm(&direction);
    let [x, y, z] = [Vector3::x(), Vector3::y(), Vector3::z()];
    match clearance {
        Clearance::Plane(plane) => along(plane.normal.into_inner(), height(clearance, tip)),
        Clearance::Box { lower, upper } => {
            let faces = [x, y, z].into_iter().enumerate();
            let distance = |axis: usize| (lower[axis] - tip[axis]).max(tip[axis] - upper[axis]);
            faces.map(|(axis, normal)| along(normal, distance(axis))).fold(f64::NEG_INFINITY, f64::max)
        }
        Clearance::Cylinder { centre: [centre_x, centre_y], radius_mm, lower_z_mm, upper_z_mm } => {
            let out = Vector3::new(tip.x - centre_x, tip.y - centre_y, 0.0);
            let distance = out.norm();
            let side = if distance > 0.0 { along(out / distance, distance - radius_mm) } else { f64::NEG_INFINITY };
            side.max(along(z, (lower_z_mm - tip.z).max(tip.z - upper_z_mm)))
        }
    }
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
pub(crate) fn size(clearance: &Clearance) -> f64 {
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
    use nalgebra::{Point3, UnitVector3};

    use super::*;
    use crate::kinematics::machines::Cb;
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
    fn the_deepest_tip_of_a_box_of_axis_values_is_found_wherever_it_is() {
        let plane = Clearance::Plane(ClearancePlane {
            normal: UnitVector3::new_normalize(Vector3::new(0.3, -0.5, 0.8)),
            distance_mm: 20.0,
        });
        let machine = Cb::default();
        let chain = Chain::of(&machine);
        let mut found = [0; 2];
        for turn in 0..45 {
            let at = f64::from(turn);
            let clearance = [BOX, CYLINDER, plane][turn as usize % 3];
            let wave = |phase: f64, size: f64| size * (0.7 * at + phase).sin();
            let (mut from, mut to) = ([0.0; MAX_AXES], [0.0; MAX_AXES]);
            for index in 0..5 {
                let (place, by) = if index < 2 { (0.4, 0.3) } else { (35.0, 12.0) };
                from[index] = wave(2.1 * index as f64, place);
                to[index] = from[index] + wave(1.3 * index as f64 + 1.0, by);
            }
            let shares = 0..9_usize.pow(5);
            let deepest = shares.step_by(7).map(|corner| {
                let share = |index: usize| (corner / 9_usize.pow(index as u32) % 9) as f64 / 8.0;
                let values = std::array::from_fn(|index| {
                    from[index] + if index < 5 { (to[index] - from[index]) * share(index) } else { 0.0 }
                });
                -height(&clearance, &chain.place(&values).tip)
            });
            let deepest = deepest.fold(f64::NEG_INFINITY, f64::max);
            match depth_of_box(&clearance, &chain, [&from, &to], 0.0, 0.01) {
                Some(depth) => {
                    found[1] += 1;
                    assert!(depth >= NEARLY * deepest && depth <= deepest + 2.5, "{turn}: {depth} {deepest}");
                    let allowed = depth / NEARLY + 0.01;
                    assert_eq!(depth_of_box(&clearance, &chain, [&from, &to], allowed, 0.01), None, "{turn}");
                }
                None => {
                    found[0] += 1;
                    assert!(deepest <= 0.01, "{turn}: {deepest}");
                }
            }
        }
        assert!(found[0] >= 10 && found[1] >= 10, "{found:?}");
    }

    #[test]
    fn a_box_along_the_surface_is_outside() {
        let chain = Chain::of(&Cb::default());
        // C about the cylinder, whose axis is that of C; B at zero.
        let centred = Clearance::Cylinder { centre: [0.0; 2], radius_mm: 10.0, lower_z_mm: -30.0, upper_z_mm: 5.0 };
        let at = |values: [f64; 5]| std::array::from_fn(|index| values.get(index).copied().unwrap_or(0.0));
        let deep = |clearance: &Clearance, from: [f64; 5], to: [f64; 5]| {
            depth_of_box(clearance, &chain, [&at(from), &at(to)], 0.0, 1e-3)
        };
        assert_eq!(deep(&centred, [0.0, 0.0, 10.0, 0.0, -20.0], [6.0, 0.0, 14.0, 0.0, 8.0]), None);
        assert!(deep(&centred, [0.0, 0.0, 9.99, 0.0, -20.0], [6.0, 0.0, 14.0, 0.0, 8.0]).is_some());
        assert_eq!(deep(&BOX, [0.0, 0.0, -40.0, -30.0, 5.0], [0.0, 0.0, 40.0, 30.0, 9.0]), None);
        assert!(deep(&BOX, [0.0, 0.0, -40.0, -30.0, 4.99], [0.0, 0.0, 40.0, 30.0, 9.0]).is_some());
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
