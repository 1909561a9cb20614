//! A body of the machine as shapes for distances.

use nalgebra::{Isometry3, Point3};
use parry3d_f64::math::{Pose, Vector};
use parry3d_f64::shape::{Compound, ConvexPolyhedron, Cuboid, SharedShape, TriMesh};

use super::links::MachineLinks;
use super::reach::Ball;
use crate::simulate::bodies::{CentreLine, Mesh};

/// Part of the volume of its hull by which a convex body may be smaller: rounding.
const CONVEX: f64 = 1e-6;

/// Smallest area of a triangle, twice, mm².
const LEAST_AREA: f64 = 1e-10;

/// A body.
pub(crate) struct Body {
    /// Its name, for findings.
    pub(crate) name: String,
    /// Names under which `allow` knows it.
    pub(crate) groups: Vec<String>,
    /// Number of its link.
    pub(crate) link: usize,
    /// Set-ups in which it is there; empty: all.
    pub(crate) set_ups: Vec<u32>,
    pub(crate) ball: Ball,
    /// The real body is one of revolution about this line, in the coordinates of its link.
    pub(crate) axis: Option<CentreLine>,
    /// Largest distance of the real surface from the shapes, mm.
    pub(crate) tolerance_mm: f64,
    pub(crate) shapes: Shapes,
}

/// Largest distance between the axis of a body of revolution and a centre line that are taken for one, mm.
const COAXIAL_MM: f64 = 0.005;

impl Body {
    /// The first and the last link in whose coordinates the body stays where it is, and the tolerance to be added for
    /// that, mm. They are its own, and those beyond rotary axes that rotate it about its own axis.
    ///
    /// A body of revolution fills the same space after any rotation about its axis. A centre line has the same
    /// coordinates in the links on both of its sides. So where it is the axis of the body, the body is at rest in the
    /// link on the other side too, at the coordinates that it has in its own; the same then holds for the next joint of
    /// that link.
    ///
    /// Where both lines are up to `e` apart, a motion `T` that moves no point of the body by more than `e` takes its
    /// axis to the centre line. With `R` a rotation about the axis, which leaves the body as it is, the joint is
    /// `T R T⁻¹`: no point of it is more than `2 e` from the same of `R`.
    pub(crate) fn rests(&self, links: &MachineLinks) -> ([usize; 2], f64) {
        let Some(axis) = &self.axis else { return ([self.link; 2], 0.0) };
        let mut added_mm = 0.0;
        let mut is_coaxial = |joint: usize| {
            let Ball { centre, radius } = self.ball;
            let away = links.centre_line(joint).map(|line| axis.away_from(&line, centre, radius));
            let away = away.filter(|away| *away <= COAXIAL_MM);
            added_mm += 2.0 * away.unwrap_or(0.0);
            away.is_some()
        };
        let before = (0..self.link).rev().take_while(|joint| is_coaxial(*joint)).count();
        let after = (self.link..links.spindle()).take_while(|joint| is_coaxial(*joint)).count();
        ([self.link - before, self.link + after], added_mm)
    }
}

/// The shapes of a body: hulls contain it, and are near enough to leave out most of the work.
pub(crate) struct Shapes {
    pub(crate) hull: ConvexPolyhedron,
    /// Its surface; `None`: the body is its hull.
    pub(crate) surface: Option<BodySurface>,
}

/// The surface of a body that is not convex.
pub(crate) enum BodySurface {
    /// Triangles.
    Triangles {
        surface: Box<TriMesh>,
        /// A point of each part that hangs together.
        points: Vec<Point3<f64>>,
        mesh: Mesh,
    },
    /// Convex pieces in sets, each of which contains the body: the farthest set counts.
    Pieces(Vec<Compound>),
}

pub(crate) fn pose(place: &Isometry3<f64>) -> Pose {
    let (t, r) = (place.translation.vector, place.rotation.coords);
    let rotation = parry3d_f64::math::Rotation::from_xyzw(r.x, r.y, r.z, r.w);
    Pose::from_parts(Vector::new(t.x, t.y, t.z), rotation)
}

pub(crate) fn vector(point: &[f64; 3]) -> Vector {
    Vector::new(point[0], point[1], point[2])
}

pub(crate) fn point(vector: Vector) -> Point3<f64> {
    Point3::new(vector.x, vector.y, vector.z)
}

/// The ball around points: the centre of their box, and the farthest point.
fn ball(points: &[[f64; 3]]) -> Ball {
    let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    for point in points {
        for axis in 0..3 {
            (low[axis], high[axis]) = (low[axis].min(point[axis]), high[axis].max(point[axis]));
        }
    }
    let centre = Point3::from(std::array::from_fn::<f64, 3, _>(|axis| f64::midpoint(low[axis], high[axis])));
    let radius = points.iter().map(|point| (Point3::from(*point) - centre).norm()).fold(0.0, f64::max);
    Ball { centre, radius }
}

impl Shapes {
    /// The shapes of triangles. `None`: they have no volume.
    pub(crate) fn of(mesh: Mesh) -> Option<(Self, Ball)> {
        let used: Vec<[f64; 3]> = mesh.used_vertices();
        let corners: Vec<Vector> = used.iter().map(vector).collect();
        let hull = ConvexPolyhedron::from_convex_hull(&corners)?;
        let ball = ball(&used);
        let full = volume(&hull);
        if mesh.flaw().is_none() && mesh.volume() >= full * (1.0 - CONVEX) {
            return Some((Self { hull, surface: None }, ball));
        }
        let area = |face: &[u32; 3]| {
            let [a, b, c] = face.map(|index| vector(&mesh.vertices()[index as usize]));
            (b - a).cross(c - a).length()
        };
        let faces: Vec<[u32; 3]> = mesh.faces().iter().filter(|face| area(face) > LEAST_AREA).copied().collect();
        let surface = Box::new(TriMesh::new(mesh.vertices().iter().map(vector).collect(), faces).ok()?);
        let points = mesh.points_of_parts().into_iter().map(Point3::from).collect();
        Some((Self { hull, surface: Some(BodySurface::Triangles { surface, points, mesh }) }, ball))
    }

    /// The shapes of convex pieces. `None`: there is none, or one has no volume.
    pub(crate) fn of_pieces(pieces: Vec<Mesh>) -> Option<(Self, Ball)> {
        if let [_] = pieces.as_slice() {
            return pieces.into_iter().next().and_then(Self::of);
        }
        let corners: Vec<[f64; 3]> = pieces.iter().flat_map(Mesh::used_vertices).collect();
        let hull_of =
            |corners: &[[f64; 3]]| ConvexPolyhedron::from_convex_hull(&corners.iter().map(vector).collect::<Vec<_>>());
        let hulls: Option<Vec<_>> = pieces.iter().map(|piece| hull_of(&piece.used_vertices())).collect();
        let hulls = hulls.filter(|hulls| !hulls.is_empty())?;
        let shapes = hulls.into_iter().map(|hull| (Pose::identity(), SharedShape::new(hull))).collect();
        let surface = Some(BodySurface::Pieces(vec![Compound::new(shapes)]));
        Some((Self { hull: hull_of(&corners)?, surface }, ball(&corners)))
    }

    /// The shapes of sets of boxes, each of which contains the body. `None`: there is nothing.
    pub(crate) fn of_boxes(sets: Vec<Vec<[[f64; 3]; 2]>>) -> Option<(Self, Ball)> {
        let all: Vec<[f64; 3]> = sets
            .last()?
            .iter()
            .flat_map(|ends| (0..8_usize).map(|corner| std::array::from_fn(|axis| ends[corner >> axis & 1][axis])))
            .collect();
        let hull = ConvexPolyhedron::from_convex_hull(&all.iter().map(vector).collect::<Vec<_>>())?;
        let compound = |boxes: Vec<[[f64; 3]; 2]>| {
            let shapes = boxes.into_iter().map(|[low, high]| {
                let (low, high) = (vector(&low), vector(&high));
                (Pose::from_translation((low + high) * 0.5), SharedShape::new(Cuboid::new((high - low) * 0.5)))
            });
            Compound::new(shapes.collect())
        };
        if sets.iter().any(Vec::is_empty) {
            return None;
        }
        let surface = Some(BodySurface::Pieces(sets.into_iter().map(compound).collect()));
        Some((Self { hull, surface }, ball(&all)))
    }
}

/// Volume of a hull, mm³.
fn volume(hull: &ConvexPolyhedron) -> f64 {
    let (points, faces) = hull.to_trimesh();
    let six = faces.iter().map(|face| {
        let [a, b, c] = face.map(|index| points[index as usize] - points[0]);
        a.dot(b.cross(c))
    });
    six.sum::<f64>() / 6.0
}
