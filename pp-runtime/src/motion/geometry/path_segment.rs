//! The motion that CL data means between two points: a straight tip path, and a tool axis that turns evenly in the plane of
//! its ends.

use nalgebra::{Rotation3, UnitVector3, Vector3};

use crate::kinematics::{Pose, REACH_TOLERANCE};

/// Tool axes within this angle are the same, rad: CL data has seven digits.
pub(crate) const SAME_AXIS: f64 = 1e-6;

/// Angle between two unit vectors, rad; as exact for small angles as for large ones.
pub(crate) fn angle_between(a: &Vector3<f64>, b: &Vector3<f64>) -> f64 {
    a.cross(b).norm().atan2(a.dot(b))
}

/// The shortest turn that brings `a` to `b`, which are not opposite. No arc cosine: the cosine of axes that are the same but
/// for rounding may be above 1.
pub(crate) fn rotation_between(a: &UnitVector3<f64>, b: &UnitVector3<f64>) -> Rotation3<f64> {
    let normal = UnitVector3::try_new(a.cross(b), 0.0);
    normal.map_or_else(Rotation3::identity, |normal| Rotation3::from_axis_angle(&normal, angle_between(a, b)))
}

/// From one pose to another.
#[derive(Debug, Clone, Copy)]
pub(crate) struct PathSegment {
    start: Pose,
    step: Vector3<f64>,
    /// Unit vector in the plane of the tool axes, square to the first; zero where these are the same.
    aside: Vector3<f64>,
    /// Angle between the tool axes, rad.
    angle: f64,
}

impl PathSegment {
    /// `None` if the tool axes are opposite: which way round, nobody says.
    pub(crate) fn new(from: &Pose, to: &Pose) -> Option<Self> {
        let (a, b) = (from.axis.into_inner(), to.axis.into_inner());
        let angle = angle_between(&a, &b);
        let aside = a.cross(&b).cross(&a).try_normalize(0.0).unwrap_or_else(Vector3::zeros);
        let step = to.tip - from.tip;
        (angle <= std::f64::consts::PI - REACH_TOLERANCE).then_some(Self { start: *from, step, aside, angle })
    }

    /// Length of the tip path, mm.
    pub(crate) fn length(&self) -> f64 {
        self.step.norm()
    }

    /// Angle between the tool axes at the ends, rad.
    pub(crate) fn angle(&self) -> f64 {
        self.angle
    }

    /// Where the tool is at a part of the way.
    pub(crate) fn at(&self, part: f64) -> Pose {
        let (sine, cosine) = (part * self.angle).sin_cos();
        let axis = self.start.axis.into_inner() * cosine + self.aside * sine;
        Pose { tip: self.start.tip + self.step * part, axis: UnitVector3::new_normalize(axis) }
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
    fn the_tip_goes_straight_and_the_axis_turns_evenly() {
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
    fn a_turn_leads_from_one_axis_to_another_however_near_they_are() {
        for tilt in [1.0, 30.0, 55.5, 89.0] {
            for off in [0.0, 1e-17, 1.2e-16, 1e-12, 1e-9, 1e-4, 0.5, 3.0] {
                for step in 0..100 {
                    let (sine, cosine) = (tilt + f64::from(step) * 0.01_f64).to_radians().sin_cos();
                    let a = UnitVector3::new_unchecked(Vector3::new(0.0, -sine, cosine));
                    let b = UnitVector3::new_normalize(Vector3::new(off * 0.7, off - sine, cosine));
                    let turned = rotation_between(&a, &b) * a.into_inner();
                    assert!((turned - b.into_inner()).norm() < 1e-15 * 4.0, "{tilt} {off}: {turned}");
                }
            }
        }
    }

    #[test]
    fn opposite_axes_have_no_way() {
        assert!(PathSegment::new(&pose([0.0; 3], [0.0, 0.0, 1.0]), &pose([1.0; 3], [1e-8, 0.0, -1.0])).is_none());
        let still =
            PathSegment::new(&pose([0.0; 3], [0.0, 0.6, 0.8]), &pose([1.0; 3], [0.0, 0.6, 0.8])).expect("a segment");
        assert_eq!(still.at(0.7).axis, still.at(0.0).axis);
    }
}
