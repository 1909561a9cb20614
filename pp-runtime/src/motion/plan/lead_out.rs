//! Lead-out of the CL data: the length by which the last motions before a retract already withdrew the tool along the tool
//! axis. A retract of that length need not be added.

use crate::kinematics::Pose;

/// Largest angle between the tool axis and a motion along it, rad.
const ALONG: f64 = 1e-3;

/// Motions shorter than this have no direction, mm.
const SHORTEST: f64 = 1e-9;

/// Running length of the last motions along the positive tool axis.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct LeadOut {
    length_mm: f64,
}

impl LeadOut {
    /// Length along the tool axis since the last motion in any other direction, mm.
    pub(crate) fn length_mm(self) -> f64 {
        self.length_mm
    }

    /// Takes one motion.
    #[inline]
    pub(crate) fn follow(&mut self, from: &Pose, to: &Pose) {
        if (to.axis.into_inner() - from.axis.into_inner()).norm_squared() > ALONG * ALONG {
            self.length_mm = 0.0;
            return;
        }
        let step = to.tip - from.tip;
        let along = step.dot(&to.axis);
        let across = (step - to.axis.into_inner() * along).norm();
        if along > SHORTEST && across <= ALONG * along {
            self.length_mm += along;
        } else if along.abs() > SHORTEST || across > SHORTEST {
            self.length_mm = 0.0;
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
    fn a_thousandth_of_a_radian_is_still_along_the_axis() {
        assert!(length_after(&[[0.0; 3], [0.0009, 0.0, 1.0]], [0.0, 0.0, 1.0]) > 0.9);
        assert!(length_after(&[[0.0; 3], [0.0011, 0.0, 1.0]], [0.0, 0.0, 1.0]) < 1e-12);
    }
}
