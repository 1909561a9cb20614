//! Geometry around the part beyond which the tool may move freely.

use nalgebra::{Point3, UnitVector3};

/// A plane of the workpiece frame: the points `p` with `normal · p = distance`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ClearancePlane {
    /// Unit normal, away from the part.
    pub normal: UnitVector3<f64>,
    /// Distance from the origin along the normal.
    pub distance_mm: f64,
}

/// Clearance geometry around the part in the workpiece frame. Outside it the tool may move freely.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Clearance {
    /// The half space below a plane.
    Plane(ClearancePlane),
    /// A box along the axes of the frame.
    Box {
        /// Corner with the smallest X, Y and Z.
        lower: Point3<f64>,
        /// Corner with the largest X, Y and Z.
        upper: Point3<f64>,
    },
    /// A cylinder along Z.
    Cylinder {
        /// X and Y of its axis.
        centre: [f64; 2],
        /// Radius.
        radius_mm: f64,
        /// Z of its lower end.
        lower_z_mm: f64,
        /// Z of its upper end.
        upper_z_mm: f64,
    },
}
