//! Lead-out of the CL data: the length by which the last motions before a retract already withdrew the tool along the
//! tool axis. A retract of that length need not be added.

use nalgebra::Point3;

use crate::kinematics::Pose;
use crate::tolerance::writer::{ALONG_TOOL_AXIS, NO_DIRECTION, SAME_POINT};

/// Square of a length in that of its part along the axis, above which the rest is neither along the axis nor too short
/// for a direction.
const FAR_FROM_AXIS: f64 = 1.1;

/// Running length of the last motions along the positive tool axis.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct LeadOut {
    length_mm: f64,
    /// Where the retract ends, if there is one.
    end: Option<Point3<f64>>,
}

impl LeadOut {
    /// Length along the tool axis since the last motion in any other direction, mm.
    pub(crate) fn length_mm(self) -> f64 {
        self.length_mm
    }

    /// Takes one motion.
    #[inline(always)]
    pub(crate) fn follow(&mut self, from: &Pose, to: &Pose) {
        if (to.axis.into_inner() - from.axis.into_inner()).norm_squared() > ALONG_TOOL_AXIS * ALONG_TOOL_AXIS {
            *self = Self::default();
            return;
        }
        // The point that the retract has reached, again.
        if self.end.is_some_and(|end| (to.tip - end).norm() <= SAME_POINT) {
            return;
        }
        let step = to.tip - from.tip;
        let along = step.dot(&to.axis);
        // Nearly every cut: it is far from the direction of the axis.
        if step.norm_squared() > FAR_FROM_AXIS * (along * along + NO_DIRECTION * NO_DIRECTION) {
            *self = Self::default();
            return;
        }
        let across = (step - to.axis.into_inner() * along).norm();
        if along > NO_DIRECTION && across <= ALONG_TOOL_AXIS * along {
            *self = Self { length_mm: self.length_mm + along, end: Some(to.tip) };
        } else if along.abs() > NO_DIRECTION || across > NO_DIRECTION {
            *self = Self::default();
        }
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::{Point3, UnitVector3, Vector3};

    use super::*;

    fn length_after(tips: &[[f64; 3]], axis: [f64; 3]) -> f64 {
        let axis = UnitVector3::new_normalize(Vector3::from(axis));
        let poses: Vec<_> = tips.iter().map(|&tip| Pose { tip: Point3::from(tip), axis }).collect();
        let mut lead_out = LeadOut::default();
        for pair in poses.windows(2) {
            lead_out.follow(&pair[0], &pair[1]);
        }
        lead_out.length_mm()
    }

    #[test]
    fn the_last_motions_along_the_axis_add_up() {
        let tips = [[0.0; 3], [5.0, 0.0, 0.0], [5.0, 0.0, 2.0], [5.0, 0.0, 2.0], [5.0, 0.0, 10.0]];
        assert!((length_after(&tips, [0.0, 0.0, 1.0]) - 10.0).abs() < 1e-12);
    }

    #[test]
    fn a_motion_in_any_other_direction_counts_as_nothing() {
        assert!(length_after(&[[0.0; 3], [0.0, 0.0, 9.0], [0.1, 0.0, 9.0]], [0.0, 0.0, 1.0]) < 1e-12);
        assert!(length_after(&[[0.0; 3], [0.0, 0.0, 9.0], [0.0, 0.0, 8.0]], [0.0, 0.0, 1.0]) < 1e-12);
        assert!(length_after(&[[0.0; 3], [0.0, 0.0, 9.0]], [0.0, 1.0, 1.0]) < 1e-12);
    }

    #[test]
    fn a_point_that_the_rounding_of_cl_data_repeats_is_no_motion() {
        let out = [[0.0; 3], [0.0, 0.0, 50.0]];
        let after = |tips: &[[f64; 3]]| length_after(&[&out[..], tips].concat(), [0.0, 0.0, 1.0]);
        for near in [[0.0, 0.0, 49.9999], [0.0001, 0.0, 50.0001], [0.001, -0.001, 50.0]] {
            assert!((after(&[near]) - 50.0).abs() < 1e-12, "{near:?}");
            assert!((after(&[near, [near[0], near[1], 60.0]]) - 60.0).abs() < 1e-3, "{near:?}");
        }
        assert!(after(&[[0.006, 0.0, 50.0]]) < 1e-12);
        // Many such motions lead away.
        let steps: Vec<_> = (1..10).map(|step| [0.0, 0.0, 50.0 - 0.002 * f64::from(step)]).collect();
        assert!(after(&steps) < 1e-12);
    }

    #[test]
    fn a_thousandth_of_a_radian_is_still_along_the_axis() {
        assert!(length_after(&[[0.0; 3], [0.0009, 0.0, 1.0]], [0.0, 0.0, 1.0]) > 0.9);
        assert!(length_after(&[[0.0; 3], [0.0011, 0.0, 1.0]], [0.0, 0.0, 1.0]) < 1e-12);
    }
}
