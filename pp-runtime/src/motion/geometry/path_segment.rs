//! The motion that CL data programs between two points: a straight tip path, and a tool axis that rotates evenly in the
//! plane of the tool axes at both ends.

use nalgebra::{UnitVector3, Vector3};

use crate::kinematics::{Pose, REACH_TOLERANCE, math};

/// Angle between two unit vectors, rad; equally exact for small and large angles.
pub(crate) fn angle_between(a: &Vector3<f64>, b: &Vector3<f64>) -> f64 {
    math::atan2(a.cross(b).norm(), a.dot(b))
}

/// Straight path from one pose to another, with evenly rotating tool axis.
#[derive(Debug, Clone, Copy)]
pub(crate) struct PathSegment {
    start: Pose,
    step: Vector3<f64>,
    /// Unit vector in the plane of both tool axes, perpendicular to the first; zero if the two are the same.
    perpendicular: Vector3<f64>,
    /// Angle between the tool axes at the ends.
    angle_rad: f64,
}

impl PathSegment {
    /// Creates the path; `None` if the tool axes are opposite: then the plane of rotation is undefined.
    pub(crate) fn new(from: &Pose, to: &Pose) -> Option<Self> {
        let (a, b) = (from.axis.into_inner(), to.axis.into_inner());
        let angle_rad = angle_between(&a, &b);
        let perpendicular = a.cross(&b).cross(&a).try_normalize(0.0).unwrap_or_else(Vector3::zeros);
        let step = to.tip - from.tip;
        (angle_rad <= std::f64::consts::PI - REACH_TOLERANCE).then_some(Self {
            start: *from,
            step,
            perpendicular,
            angle_rad,
        })
    }

    /// Length of the tip path, mm.
    pub(crate) fn length(&self) -> f64 {
        self.step.norm()
    }

    /// Angle between the tool axes at the ends, rad.
    pub(crate) fn angle(&self) -> f64 {
        self.angle_rad
    }

    /// Pose at a fraction of the path, 0 at its start and 1 at its end.
    pub(crate) fn at(&self, fraction: f64) -> Pose {
        let (sine, cosine) = math::sin_cos(fraction * self.angle_rad);
        let axis = self.start.axis.into_inner() * cosine + self.perpendicular * sine;
        Pose { tip: self.start.tip + self.step * fraction, axis: UnitVector3::new_normalize(axis) }
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::Point3;

    use super::*;

    fn pose(tip: [f64; 3], axis: [f64; 3]) -> Pose {
        Pose { tip: Point3::from(tip), axis: UnitVector3::new_normalize(Vector3::from(axis)) }
    }

    #[test]
    fn the_tip_moves_straight_and_the_axis_rotates_evenly() {
        let segment = PathSegment::new(&pose([0.0; 3], [0.0, 0.0, 1.0]), &pose([4.0, 0.0, 8.0], [1.0, 0.0, 0.0]))
            .expect("a segment");
        let third = segment.at(1.0 / 3.0);
        let expected = pose([4.0 / 3.0, 0.0, 8.0 / 3.0], [0.5, 0.0, 3_f64.sqrt() / 2.0]);
        assert!((third.tip - expected.tip).norm() < 1e-12 && (third.axis.dot(&expected.axis) - 1.0).abs() < 1e-12);
        assert!(
            (segment.angle() - std::f64::consts::FRAC_PI_2).abs() < 1e-12
                && (segment.length() - 80_f64.sqrt()).abs() < 1e-12
        );
    }

    #[test]
    fn opposite_axes_have_no_path() {
        assert!(PathSegment::new(&pose([0.0; 3], [0.0, 0.0, 1.0]), &pose([1.0; 3], [1e-8, 0.0, -1.0])).is_none());
        let still =
            PathSegment::new(&pose([0.0; 3], [0.0, 0.6, 0.8]), &pose([1.0; 3], [0.0, 0.6, 0.8])).expect("a segment");
        assert_eq!(still.at(0.7).axis, still.at(0.0).axis);
    }
}
