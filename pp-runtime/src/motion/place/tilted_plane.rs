//! Tilted planes: conversion between an orientation and the three angles of a control.
//!
//! The columns of an orientation are the X, Y and Z of the plane in the frame that is tilted; Z is the tool axis. The
//! angles are written in the resolution of the control, and all later coordinates are in the plane as the *control*
//! computes it: in the orientation of the rounded angles.

use nalgebra::{Matrix3, Rotation3, UnitVector3, Vector3};

use crate::kinematics::math;
use crate::nc::Decimal;

use crate::motion::geometry::angle_between;
use crate::tolerance::writer::{ALONG_PLANE_NORMAL, ONE_SUM_OF_ANGLES, SAME_PLANE_POSE};

/// Convention of the three angles by which a control describes the orientation of a plane.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PlaneAngles {
    /// About Z, then about the new X, then about the new Z: `Rz(1)·Rx(2)·Rz(3)`.
    EulerZxz,
    /// About X, then about the new Y, then about the new Z: `Rx(1)·Ry(2)·Rz(3)`.
    MovingXyz,
    /// About X, then Y, then Z of the frame that is tilted: `Rz(3)·Ry(2)·Rx(1)`.
    FixedXyz,
}

impl PlaneAngles {
    /// The orientation of three angles, rad.
    #[must_use]
    pub fn orientation(self, [a, b, c]: [f64; 3]) -> Matrix3<f64> {
        let about = |axis: &nalgebra::UnitVector3<f64>, angle: f64| Rotation3::from_axis_angle(axis, angle);
        let (x, y, z) = (Vector3::x_axis(), Vector3::y_axis(), Vector3::z_axis());
        let rotation = match self {
            Self::EulerZxz => about(&z, a) * about(&x, b) * about(&z, c),
            Self::MovingXyz => about(&x, a) * about(&y, b) * about(&z, c),
            Self::FixedXyz => about(&z, c) * about(&y, b) * about(&x, a),
        };
        rotation.into_inner()
    }

    /// Angles of an orientation, rad. If the middle angle determines only the sum or the difference of the other two,
    /// one of these is zero.
    #[must_use]
    pub fn angles(self, r: &Matrix3<f64>) -> [f64; 3] {
        match self {
            Self::EulerZxz => {
                let sine = math::hypot(r[(0, 2)], r[(1, 2)]);
                let middle = math::atan2(sine, r[(2, 2)]);
                if sine < ONE_SUM_OF_ANGLES {
                    return [math::atan2(r[(1, 0)], r[(0, 0)]), middle, 0.0];
                }
                [math::atan2(r[(0, 2)], -r[(1, 2)]), middle, math::atan2(r[(2, 0)], r[(2, 1)])]
            }
            Self::MovingXyz => {
                let cosine = math::hypot(r[(0, 0)], r[(0, 1)]);
                let middle = math::atan2(r[(0, 2)], cosine);
                if cosine < ONE_SUM_OF_ANGLES {
                    return [math::atan2(r[(2, 1)], r[(1, 1)]), middle, 0.0];
                }
                [math::atan2(-r[(1, 2)], r[(2, 2)]), middle, math::atan2(-r[(0, 1)], r[(0, 0)])]
            }
            Self::FixedXyz => {
                let cosine = math::hypot(r[(0, 0)], r[(1, 0)]);
                let middle = math::atan2(-r[(2, 0)], cosine);
                if cosine < ONE_SUM_OF_ANGLES {
                    return [0.0, middle, math::atan2(-r[(0, 1)], r[(1, 1)])];
                }
                [math::atan2(r[(2, 1)], r[(2, 2)]), middle, math::atan2(r[(1, 0)], r[(0, 0)])]
            }
        }
    }
}

/// Orientation of the plane across a tool axis whose X is that of the workpiece, projected into it; Y where X is within
/// [`ALONG_PLANE_NORMAL`] of the normal. A plane about Y is then an angle about Y alone.
pub(crate) fn plane_across(axis: &UnitVector3<f64>) -> Matrix3<f64> {
    let normal = axis.into_inner();
    let along = |direction: Vector3<f64>| (direction - normal * normal.dot(&direction)).normalize();
    let x =
        if normal.x.abs() > math::sin_cos(ALONG_PLANE_NORMAL).1 { along(Vector3::y()) } else { along(Vector3::x()) };
    Matrix3::from_columns(&[x, normal.cross(&x), normal])
}

/// Rule by which a control chooses between the two poses of a plane.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PoseRule {
    /// The pose with the least travel of the rotary axes, which are at their angles already.
    Nearest,
    /// By the sign of the rotary axis nearest the tool; if none is written, the pose with the least travel.
    Sign,
    /// By the lower or the higher value of the rotary axis nearest the tool.
    Side,
}

/// Abilities of a control for tilted planes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct PlaneAbility {
    /// Convention of its angles.
    pub angles: PlaneAngles,
    /// Decimals of its angles in degrees.
    pub decimals: u32,
    /// Rule for the pose.
    pub pose: PoseRule,
    /// The plane is cancelled after the machine retract; otherwise before it.
    pub ends_after_retract: bool,
    /// The length offset is called before it, so that it cannot come before tip control that begins with the length
    /// offset.
    pub length_first: bool,
}

/// A tilted plane in the words of a control.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TiltedPlane {
    /// Angles, degrees.
    pub words: [Decimal; 3],
    /// Orientation of these rounded angles.
    pub orientation: Matrix3<f64>,
}

impl TiltedPlane {
    /// Whether its axes are those of the frame that is tilted.
    pub(crate) fn is_plain(&self) -> bool {
        self.words.iter().all(|word| word.value() == 0.0)
    }
}

impl PlaneAbility {
    /// The plane of an orientation; `None` if the orientation of its rounded words deviates by more than three times
    /// half a unit of a word: then the matrix is no orientation of this convention.
    #[must_use]
    pub fn tilt(&self, orientation: &Matrix3<f64>) -> Option<TiltedPlane> {
        let wanted = self.angles.angles(orientation);
        let mut words = [Decimal::default(); 3];
        for (word, angle) in words.iter_mut().zip(wanted) {
            *word = Decimal::fixed(angle.to_degrees(), self.decimals).ok()?;
        }
        let meant = self.angles.orientation(words.map(|word| word.value().to_radians()));
        let half_unit = 0.5 * 10_f64.powi(-(self.decimals as i32)).to_radians();
        let off = (0..3).map(|column| {
            let [is, wanted]: [Vector3<f64>; 2] = [meant, *orientation].map(|r| r.column(column).into_owned());
            angle_between(&is, &wanted)
        });
        (off.fold(0.0, f64::max) <= 3.0 * half_unit + SAME_PLANE_POSE)
            .then_some(TiltedPlane { words, orientation: meant })
    }
}

impl PoseRule {
    /// Selector of this pose: `true` for positive or higher, `None` if none is written, because the control takes the
    /// pose at which the rotary axes already are. `here` and `others`: values of the rotary axis nearest the tool in
    /// this pose and in the others, rad.
    pub(crate) fn choose(self, here: f64, others: &[f64]) -> Option<bool> {
        let mut apart = others.iter().filter(|other| (*other - here).abs() > SAME_PLANE_POSE).peekable();
        apart.peek()?;
        match self {
            Self::Nearest => None,
            // Without a sign the control takes the pose with the least travel.
            Self::Sign => apart.all(|other| other * here < 0.0).then_some(here > 0.0),
            Self::Side => Some(apart.all(|other| *other < here)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const ALL: [PlaneAngles; 3] = [PlaneAngles::EulerZxz, PlaneAngles::MovingXyz, PlaneAngles::FixedXyz];

    /// Elementary matrices written out; they share no code with the library that rotates above.
    fn about(axis: usize, degrees: f64) -> Matrix3<f64> {
        let (s, c) = degrees.to_radians().sin_cos();
        match axis {
            0 => Matrix3::new(1.0, 0.0, 0.0, 0.0, c, -s, 0.0, s, c),
            1 => Matrix3::new(c, 0.0, s, 0.0, 1.0, 0.0, -s, 0.0, c),
            _ => Matrix3::new(c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0),
        }
    }

    #[test]
    fn each_convention_is_the_product_of_its_name() {
        let [a, b, c] = [20.0, -35.0, 50.0];
        let products = [
            about(2, a) * about(0, b) * about(2, c),
            about(0, a) * about(1, b) * about(2, c),
            about(2, c) * about(1, b) * about(0, a),
        ];
        for (convention, product) in ALL.into_iter().zip(products) {
            let orientation = convention.orientation([a, b, c].map(f64::to_radians));
            assert!((orientation - product).abs().max() < 1e-14, "{convention:?}");
        }
    }

    #[test]
    fn angles_and_orientation_are_inverse_also_where_two_angles_become_one() {
        for convention in ALL {
            for a in [-180.0, -120.0, -0.001, 0.0, 33.0, 179.0] {
                for b in [-90.0, -89.999_999, -45.0, -1e-7, 0.0, 30.0, 90.0, 135.0, 180.0] {
                    for c in [-150.0, 0.0, 60.0, 180.0] {
                        let orientation = convention.orientation([a, b, c].map(f64::to_radians));
                        let again = convention.orientation(convention.angles(&orientation));
                        assert!((again - orientation).abs().max() < 1e-9, "{convention:?} {a} {b} {c}");
                    }
                }
            }
        }
    }

    #[test]
    fn rounded_words_mean_the_orientation_within_half_a_unit_of_each() {
        let ability = PlaneAbility {
            angles: PlaneAngles::EulerZxz,
            decimals: 3,
            pose: PoseRule::Nearest,
            ends_after_retract: true,
            length_first: false,
        };
        for step in 0..400 {
            let t = f64::from(step);
            let orientation = PlaneAngles::FixedXyz.orientation([t * 0.37, (t * 0.71).sin(), t * 1.3]);
            let tilt = ability.tilt(&orientation).expect("a plane");
            assert!(tilt.words.iter().all(|word| word.decimals == 3));
            assert!((tilt.orientation - orientation).abs().max() < 3.0 * 0.5e-3_f64.to_radians());
        }
        // A mirror is no orientation.
        assert_eq!(ability.tilt(&Matrix3::from_diagonal(&Vector3::new(1.0, -1.0, 1.0))), None);
    }

    #[test]
    fn a_pose_is_named_only_if_the_rule_distinguishes_it_from_the_others() {
        assert_eq!(PoseRule::Nearest.choose(0.5, &[-0.5]), None);
        assert_eq!(PoseRule::Sign.choose(-0.5, &[0.5]), Some(false));
        assert_eq!(PoseRule::Sign.choose(0.5, &[1.5]), None);
        assert_eq!(PoseRule::Sign.choose(0.0, &[1.0]), None);
        assert_eq!(PoseRule::Side.choose(0.5, &[1.5]), Some(false));
        assert_eq!(PoseRule::Side.choose(0.5, &[-0.2]), Some(true));
        assert_eq!(PoseRule::Side.choose(0.5, &[]), None);
    }

    #[test]
    fn x_of_a_plane_is_x_of_the_workpiece_in_it() {
        let axis = |x: f64, y: f64, z: f64| UnitVector3::new_normalize(Vector3::new(x, y, z));
        for (x, y, z) in [(0.0, 0.0, 1.0), (0.3, 0.0, 0.9), (-0.4, 0.7, 0.2), (0.9, -0.4, -0.1), (1.0, 0.02, 0.0)] {
            let axis = axis(x, y, z);
            let plane = plane_across(&axis);
            assert!((plane.transpose() * plane - Matrix3::identity()).norm() < 1e-12 && plane.determinant() > 0.0);
            assert!((plane.column(2) - axis.into_inner()).norm() < 1e-15);
            // In the plane, and no nearer direction to X of the workpiece is in it.
            assert!(plane[(0, 1)].abs() < 1e-12 && plane[(0, 0)] > 0.0, "{plane}");
        }
        // Seen along X, Y is to the right and Z is up.
        for x in [1.0, -1.0] {
            let plane = plane_across(&axis(x, 0.01, 0.005));
            assert!(plane[(1, 0)] > 0.999 && plane[(2, 1)] * x > 0.999, "{plane}");
        }
    }
}
