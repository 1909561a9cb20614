//! A line about which something rotates.

use nalgebra::{Isometry3, Point3, UnitVector3, Vector3};

/// A line: a point, mm, and its direction, whose sense does not count.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct CentreLine {
    pub(crate) point: Point3<f64>,
    pub(crate) direction: UnitVector3<f64>,
}

impl CentreLine {
    /// The Z axis.
    pub(crate) fn z() -> Self {
        Self { point: Point3::origin(), direction: Vector3::z_axis() }
    }

    /// The line where a place is the origin of its coordinates.
    pub(crate) fn placed(&self, place: &Isometry3<f64>) -> Self {
        Self { point: place * self.point, direction: place * self.direction }
    }

    /// Distance of a point, mm.
    pub(crate) fn distance(&self, point: &Point3<f64>) -> f64 {
        (point - self.point).cross(&self.direction).norm()
    }

    /// Bound of what a motion that takes this line to another one moves the points of a ball by, mm, also after they
    /// are rotated about this line.
    ///
    /// The motion rotates about `here`, the foot of the centre of the ball, and then moves `here` to its foot on the
    /// other line. A rotation by an angle moves a point by twice the sine of half of it, the distance of both
    /// directions, times its distance from `here` at most; rotating about this line leaves that distance as it is.
    pub(crate) fn away_from(&self, other: &Self, centre: Point3<f64>, radius: f64) -> f64 {
        let here = self.foot(centre);
        let apart = (other.foot(here) - here).norm();
        let (one, two) = (self.direction.into_inner(), other.direction.into_inner());
        let angle = (one - two).norm().min((one + two).norm());
        apart + angle * ((centre - here).norm() + radius + apart)
    }

    /// The point of the line nearest to another one.
    fn foot(&self, from: Point3<f64>) -> Point3<f64> {
        self.point + self.direction.into_inner() * (from - self.point).dot(&self.direction)
    }
}
