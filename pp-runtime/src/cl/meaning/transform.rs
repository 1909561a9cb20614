//! Coordinate transforms from the numbers of a file to the workpiece frame: TRACUT, ORIGIN, TRANS and frames.
//!
//! A point is transformed by TRACUT first, then ORIGIN is subtracted and TRANS added, then a frame other than the first
//! is mapped into the first. Directions are only rotated. Every transform is rigid; a mirror or a scale is refused.

use super::frame::StatedFrame;
use crate::cl::text::{ClFault, Span};
use crate::cl::vector::{cross, dot, length};
use crate::diag::code::cl;
use crate::nalgebra::{Point3, UnitVector3, Vector3};

/// Largest permitted deviation of a matrix from a rotation. CL data has five decimals or more.
const RIGID: f64 = 1e-4;

/// A rotation and a translation: `p' = R p + t`, lengths in mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct RigidTransform {
    rows: [[f64; 3]; 3],
    shift: [f64; 3],
}

impl RigidTransform {
    const IDENTITY: RigidTransform =
        RigidTransform { rows: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], shift: [0.0; 3] };

    /// TRACUT: a 3×4 matrix by rows, its last column in units of the file.
    pub(crate) fn from_rows(n: &[f64; 12], unit_mm: f64, at: Span) -> Result<RigidTransform, ClFault> {
        let row = |i: usize| [n[4 * i], n[4 * i + 1], n[4 * i + 2]];
        let rows = [row(0), row(1), row(2)];
        let [x, y, z] = rows;
        let unit_length = rows.iter().all(|row| (length(*row) - 1.0).abs() <= RIGID);
        let perpendicular = dot(x, y).abs() <= RIGID && dot(x, z).abs() <= RIGID && dot(y, z).abs() <= RIGID;
        if !unit_length || !perpendicular || dot(cross(x, y), z) < 0.0 {
            return Err(cl::FRAME.cl_fault(
                "TRACUT",
                at,
                "this matrix may only rotate and shift; it scales, shears or mirrors",
                "no option applies it: delete TRACUT and write the points where they shall be; a mirrored path would turn climb into \
                 conventional milling",
            ));
        }
        Ok(RigidTransform { rows, shift: [n[3], n[7], n[11]].map(|value| value * unit_mm) })
    }

    /// Transform from the coordinates of `frame` to those of `main`.
    fn between(main: &StatedFrame, frame: &StatedFrame) -> RigidTransform {
        // Axes of a frame are columns of its matrix, so they are rows of its inverse.
        let [x, y, z] = frame.axes;
        let rows = main.axes.map(|axis| [dot(axis, x), dot(axis, y), dot(axis, z)]);
        let apart = [0, 1, 2].map(|i| frame.origin[i] - main.origin[i]);
        RigidTransform { rows, shift: main.axes.map(|axis| dot(axis, apart)) }
    }

    fn rotate(&self, v: [f64; 3]) -> [f64; 3] {
        self.rows.map(|row| dot(row, v))
    }

    fn point(&self, p: [f64; 3]) -> [f64; 3] {
        let rotated = self.rotate(p);
        [0, 1, 2].map(|i| rotated[i] + self.shift[i])
    }

    /// Transform that applies `other` first, then `self`.
    fn after(&self, other: &RigidTransform) -> RigidTransform {
        let [a, b, c] = other.rows;
        let column = |i: usize| [a[i], b[i], c[i]];
        RigidTransform {
            rows: self.rows.map(|row| [0, 1, 2].map(|i| dot(row, column(i)))),
            shift: self.point(other.shift),
        }
    }
}

/// All transforms in force.
#[derive(Debug, Default)]
pub(crate) struct Transforms {
    tracut: Option<RigidTransform>,
    origin: Option<[f64; 3]>,
    translation: Option<[f64; 3]>,
    frame: Option<RigidTransform>,
    /// Product of all of them; `None` if none is in force.
    combined: Option<RigidTransform>,
}

impl Transforms {
    /// Whether no transform is in force: the numbers of the file are coordinates of the workpiece frame.
    pub(crate) fn none(&self) -> bool {
        self.combined.is_none()
    }

    pub(crate) fn set_tracut(&mut self, tracut: Option<RigidTransform>) {
        self.tracut = tracut;
        self.combine();
    }

    pub(crate) fn set_origin(&mut self, origin: Option<[f64; 3]>) {
        self.origin = origin;
        self.combine();
    }

    pub(crate) fn set_translation(&mut self, translation: Option<[f64; 3]>) {
        self.translation = translation;
        self.combine();
    }

    /// Sets the transform from `frame` to `main`; none if they are the same.
    pub(crate) fn set_frame(&mut self, main: &StatedFrame, frame: &StatedFrame) {
        self.frame = (!main.is_same(frame)).then(|| RigidTransform::between(main, frame));
        self.combine();
    }

    fn combine(&mut self) {
        let (origin, translation) = (self.origin.unwrap_or_default(), self.translation.unwrap_or_default());
        let shift = RigidTransform { shift: [0, 1, 2].map(|i| translation[i] - origin[i]), ..RigidTransform::IDENTITY };
        let any = self.tracut.is_some() || self.origin.is_some() || self.translation.is_some() || self.frame.is_some();
        let inner = shift.after(self.tracut.as_ref().unwrap_or(&RigidTransform::IDENTITY));
        self.combined = any.then(|| self.frame.as_ref().unwrap_or(&RigidTransform::IDENTITY).after(&inner));
    }

    pub(crate) fn point(&self, point: Point3<f64>) -> Point3<f64> {
        self.combined.as_ref().map_or(point, |rigid| Point3::from(rigid.point(point.into())))
    }

    pub(crate) fn vector(&self, vector: Vector3<f64>) -> Vector3<f64> {
        self.combined.as_ref().map_or(vector, |rigid| Vector3::from(rigid.rotate(vector.into())))
    }

    pub(crate) fn direction(&self, direction: UnitVector3<f64>) -> UnitVector3<f64> {
        match &self.combined {
            None => direction,
            Some(_) => UnitVector3::new_normalize(self.vector(direction.into_inner())),
        }
    }
}
