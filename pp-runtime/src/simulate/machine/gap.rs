//! Distance of two bodies: spheres first, then hulls, then surfaces.
//!
//! Each of these is a lower bound of the next, and enough where it is as large as what is asked for. Distances are by
//! parry.

use nalgebra::{Isometry3, Point3};
use parry3d_f64::math::Pose;
use parry3d_f64::query::{ClosestPoints, DefaultQueryDispatcher, QueryDispatcher};
use parry3d_f64::shape::Shape;

use super::body::{Body, BodySurface, point, pose, vector};

/// Error of a distance, mm, and as a part of the sizes of the bodies.
const ERROR_MM: f64 = 1e-6;
const ERROR: f64 = 1e-9;

/// Distance of two bodies.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum BodyGap {
    /// They meet about at a place, in the coordinates in which the first one is compared.
    Meets(Point3<f64>),
    /// They are apart.
    Apart {
        /// Lower bound of the distance, mm.
        least_mm: f64,
        /// The distance and its middle, where it was found: always if it is less than what was asked for.
        nearest: Option<(f64, Point3<f64>)>,
    },
}

/// Closest points of two shapes that are not farther apart than a distance.
fn closest(place: &Pose, one: &dyn Shape, two: &dyn Shape, within: f64) -> ClosestPoints {
    // Every pair of shapes of a body is supported.
    DefaultQueryDispatcher.closest_points(place, one, two, within).unwrap_or(ClosestPoints::Intersecting)
}

/// The shapes by which a body is compared: of several the farthest counts.
fn shapes(body: &Body) -> Vec<&dyn Shape> {
    match &body.shapes.surface {
        None => vec![&body.shapes.hull],
        Some(BodySurface::Triangles { surface, .. }) => vec![&**surface],
        Some(BodySurface::Pieces(sets)) => sets.iter().map(|set| set as &dyn Shape).collect(),
    }
}

/// Distance of two bodies. `place`: of the coordinates of the second in those of the first; `enough_mm`: a
/// distance beyond which it need not be known. `fresh`: one may be inside the other, which only a jump can bring about.
pub(crate) fn gap(one: &Body, two: &Body, place: &Isometry3<f64>, enough_mm: f64, fresh: bool) -> BodyGap {
    let centres = (place * two.ball.centre - one.ball.centre).norm();
    let error = ERROR_MM + ERROR * (centres + one.ball.radius + two.ball.radius);
    let off = error + one.tolerance_mm + two.tolerance_mm;
    let balls = centres - one.ball.radius - two.ball.radius - off;
    if balls >= enough_mm {
        return BodyGap::Apart { least_mm: balls, nearest: None };
    }
    let place = &pose(place);
    let middle = |first, second| nalgebra::center(&point(first), &point(place.transform_point(second)));
    let mut least = balls.max(0.0);
    // From far away the hulls count, with no limit, since the distance is good for many motions.
    match closest(place, &one.shapes.hull, &two.shapes.hull, f64::MAX) {
        ClosestPoints::WithinMargin(first, second) => {
            let distance = (place.transform_point(second) - first).length();
            let whole = one.shapes.surface.is_none() && two.shapes.surface.is_none();
            least = least.max(distance - off);
            if whole || distance - off >= enough_mm {
                let nearest = whole.then(|| (distance, middle(first, second)));
                return BodyGap::Apart { least_mm: least, nearest };
            }
        }
        ClosestPoints::Intersecting if one.shapes.surface.is_none() && two.shapes.surface.is_none() => {
            return BodyGap::Meets(meeting(place, &one.shapes.hull, &two.shapes.hull));
        }
        // Not found without a limit: the search did not end.
        ClosestPoints::Disjoint if one.shapes.surface.is_none() && two.shapes.surface.is_none() => {
            return BodyGap::Apart { least_mm: least, nearest: None };
        }
        ClosestPoints::Intersecting | ClosestPoints::Disjoint => {}
    }
    if fresh && is_inside(one, two, place) {
        return BodyGap::Meets(point(place.transform_point(vector(&two.ball.centre.into()))));
    }
    surfaces(one, two, place, GapBounds { enough_mm, least_mm: least, off_mm: off })
}

/// Bounds with which the surfaces of two bodies are compared, mm.
#[derive(Debug, Clone, Copy)]
struct GapBounds {
    /// Distance beyond which it need not be known.
    enough_mm: f64,
    /// Lower bound that is known already.
    least_mm: f64,
    /// Largest error of a distance, with the tolerances of both bodies.
    off_mm: f64,
}

/// The farthest of the pairs of shapes.
fn surfaces(one: &Body, two: &Body, place: &Pose, bounds: GapBounds) -> BodyGap {
    let GapBounds { enough_mm, least_mm: least, off_mm: off } = bounds;
    let mut farthest: Option<BodyGap> = None;
    for first in shapes(one) {
        for second in shapes(two) {
            let found = match closest(place, first, second, enough_mm + off) {
                ClosestPoints::Intersecting => BodyGap::Meets(meeting(place, first, second)),
                ClosestPoints::Disjoint => return BodyGap::Apart { least_mm: least.max(enough_mm), nearest: None },
                ClosestPoints::WithinMargin(a, b) => {
                    let b = place.transform_point(b);
                    let distance = (b - a).length();
                    let nearest = Some((distance, nalgebra::center(&point(a), &point(b))));
                    BodyGap::Apart { least_mm: least.max(distance - off), nearest }
                }
            };
            farthest =
                Some(match (farthest, found) {
                    (None | Some(BodyGap::Meets(_)), found) => found,
                    (Some(apart), BodyGap::Meets(_)) => apart,
                    (Some(one @ BodyGap::Apart { least_mm: a, .. }), two @ BodyGap::Apart { least_mm: b, .. }) => {
                        if b > a { two } else { one }
                    }
                });
        }
    }
    farthest.unwrap_or(BodyGap::Apart { least_mm: least, nearest: None })
}

/// A place where two shapes meet.
fn meeting(place: &Pose, one: &dyn Shape, two: &dyn Shape) -> Point3<f64> {
    let contact = DefaultQueryDispatcher.contact(place, one, two, 0.0).ok().flatten();
    let middle = || (one.compute_local_aabb().center() + two.compute_aabb(place).center()) * 0.5;
    point(contact.map_or_else(middle, |contact| contact.point1))
}

/// Whether a part of one body is inside the other one. Their surfaces do not meet.
fn is_inside(one: &Body, two: &Body, place: &Pose) -> bool {
    let inside = |body: &Body, at: Point3<f64>| match &body.shapes.surface {
        None | Some(BodySurface::Pieces(_)) => false,
        Some(BodySurface::Triangles { mesh, .. }) => mesh.has_inside(at.into()),
    };
    let points = |body: &Body| match &body.shapes.surface {
        Some(BodySurface::Triangles { points, .. }) => points.clone(),
        None | Some(BodySurface::Pieces(_)) => vec![point(body.shapes.hull.points()[0])],
    };
    let into_one = |at: Point3<f64>| point(place.transform_point(vector(&at.into())));
    let into_two = |at: Point3<f64>| point(place.inverse_transform_point(vector(&at.into())));
    points(two).into_iter().any(|at| inside(one, into_one(at)))
        || points(one).into_iter().any(|at| inside(two, into_two(at)))
}
