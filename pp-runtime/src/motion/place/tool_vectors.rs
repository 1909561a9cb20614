//! Blocks under tip control that contain the tool axis as a vector: the control finds the rotary angles.
//!
//! The control continues from the angles where its axes are, on the same branch and in the same turn. Only at the pole
//! is it free, and takes the nearest angle. Where an axis has limits, a feed motion that passes a pole within
//! [`CONTROL_CHOOSES_NEAR_POLE`] is led through it: past the pole the first axis would rotate by nearly 180° within a
//! part of a block, or the axes would take the other branch, as the interpolation of the control has it.

use nalgebra::{UnitVector3, Vector3};

use super::{AxisPosition, Placer};
use crate::diag::code::plan;
use crate::kinematics::Pose;
use crate::motion::fault::Fault;
use crate::motion::geometry::angle_between;
use crate::motion::policy::Policy;
use crate::motion::rotary::RotaryWords;
use crate::options::{StretchMode, TcpWords};
use crate::tolerance::writer::{BENT_THROUGH_POLE, CONTROL_CHOOSES_NEAR_POLE, NO_GREAT_CIRCLE, PASSES_POLE};

/// Whether the programs of a job have stretches whose blocks contain tool vectors.
pub(crate) fn has_vectors(policy: Policy<'_>) -> bool {
    let options = policy.options;
    options.tip.tcp_words == TcpWords::Vectors && options.mode_of_all().is_none_or(|mode| mode == StretchMode::Tcp)
}

/// Largest angle between a pole and a path that is led through it, rad; `None` if none is.
pub(super) fn largest_bend(policy: Policy<'_>, limited: bool) -> Option<f64> {
    (limited && has_vectors(policy))
        .then_some(CONTROL_CHOOSES_NEAR_POLE.min(BENT_THROUGH_POLE * policy.options.axis_tolerance_path_rad))
}

impl Placer {
    /// Whether blocks contain the tool axis as a vector instead of rotary words.
    #[inline(always)]
    pub(crate) fn writes_vectors(&self) -> bool {
        self.vectors && self.mode() == StretchMode::Tcp
    }

    /// Largest angle between a pole and a path that is led through it, rad; `None` if none is.
    pub(crate) fn largest_bend(&self) -> Option<f64> {
        self.largest_bend_rad
    }

    /// Fraction of the path between two tool axes at which it is nearest to a pole, this pole, and the angle between
    /// them, rad, if the path passes the pole: the directions from the pole to its ends are more than 120° apart.
    pub(crate) fn passing(
        &self,
        from: &UnitVector3<f64>,
        to: &UnitVector3<f64>,
    ) -> Option<(f64, UnitVector3<f64>, f64)> {
        let (a, b) = (from.into_inner(), to.into_inner());
        let normal = a.cross(&b).try_normalize(NO_GREAT_CIRCLE)?;
        self.poles.axes.iter().find_map(|pole| {
            let p = pole.into_inner();
            let from_pole = |axis: &Vector3<f64>| axis - p * p.dot(axis);
            let (before, after) = (from_pole(&a), from_pole(&b));
            if before.dot(&after) > PASSES_POLE * before.norm() * after.norm() {
                return None;
            }
            let nearest = p - normal * p.dot(&normal);
            let part = angle_between(&a, &nearest) / angle_between(&a, &b);
            (part > 0.0 && part < 1.0).then(|| (part, *pole, angle_between(&nearest, &p)))
        })
    }

    /// Refuses a motion that passes a pole closely and could not be led through it, where an axis has limits: the
    /// angles that the control finds after it are unknown.
    #[inline(always)]
    pub(crate) fn check_passed_pole(&self, from: &AxisPosition, to: &AxisPosition) -> Result<(), Fault> {
        if self.largest_bend_rad.is_none() || !self.writes_vectors() || from.at_pole || to.at_pole {
            return Ok(());
        }
        self.check_path_near_pole(from, to)
    }

    fn check_path_near_pole(&self, from: &AxisPosition, to: &AxisPosition) -> Result<(), Fault> {
        let passed =
            self.passing(&from.pose.axis, &to.pose.axis).filter(|(_, _, angle)| *angle < CONTROL_CHOOSES_NEAR_POLE);
        let (Some((_, _, angle)), Some(first)) = (passed, self.rotary.axes.first()) else { return Ok(()) };
        let letter = self.chain[first.index].letter;
        Err(plan::POLE.fault(format_args!(
            "the tool axis passes the pole at {:.4}°, where the control may rotate {letter} by up to 180° or take other \
             angles: with tool vectors it could come to a limit",
            angle.to_degrees()
        ))
        .help("set `tcp_words = \"angles\"`, or a larger `axis_tolerance_path`, so that the motion can lead through the pole"))
    }

    /// Tool axis of a point at which a motion is divided, and its angle from that of the path, rad: that of the rotary
    /// words, or the pole to which they lead. A limit holds for the words; the axis of the path may be beyond it by
    /// their rounding. `None` where the axis of the path is right.
    pub(crate) fn axis_where_divided(&self, pose: &Pose, words: &RotaryWords) -> Option<(UnitVector3<f64>, f64)> {
        let largest = self.largest_bend_rad.filter(|_| self.writes_vectors() && self.pole(&pose.axis).is_none())?;
        let reached = self.axis_at(words);
        let rounding = self.rotary.scale.angle(self.rotary.axes.len() as i64);
        let off = |axis: &UnitVector3<f64>| angle_between(axis, &pose.axis);
        // The point of the path is found again from a rounded share of it.
        let leads_to =
            |pole: &&UnitVector3<f64>| angle_between(pole, &reached) <= rounding && off(pole) <= largest + rounding;
        let axis = self.poles.axes.iter().find(leads_to).copied().unwrap_or(reached);
        Some((axis, off(&axis)))
    }

    /// Whether a block with tool vectors rotates rotary axes by more than `angle_rad` although its vector does not
    /// change, so that the block cannot program the rotation: about the tool axis, or by whole revolutions. At the pole
    /// a control that moves the tool axis in the plane of its ends needs no such rotation.
    fn rotation_is_unprogrammable(&self, from: &AxisPosition, to: &AxisPosition, angle_rad: f64) -> bool {
        let all = self.linear.mask | self.rotary.mask;
        !(to.at_pole && self.frame.rotates_axis_in_plane())
            && self.rotary_travel(&from.words, &to.words) > angle_rad
            && self.words(from, all).vector == self.words(to, all).vector
    }

    /// Refuses a rotation by more than `angle_rad` that a block with tool vectors cannot express: the control would
    /// continue with the rotary axes at other angles.
    #[inline(always)]
    pub(crate) fn check_hidden_rotation(
        &self,
        from: &AxisPosition,
        to: &AxisPosition,
        angle_rad: f64,
    ) -> Result<(), Fault> {
        let hidden = self.writes_vectors() && self.rotation_is_unprogrammable(from, to, angle_rad);
        if hidden { Err(self.hidden_rotation(from, to)) } else { Ok(()) }
    }

    #[cold]
    fn hidden_rotation(&self, from: &AxisPosition, to: &AxisPosition) -> Fault {
        let (letter, turn) = self.largest_rotation(&from.words, &to.words).unwrap_or_default();
        plan::MODE
            .fault(format_args!(
                "{letter} has to rotate by {:.3}° here while the tool axis stays, which tool vectors cannot express",
                turn.to_degrees()
            ))
            .help("set `tcp_words = \"angles\"`; for a rewind `retract.rewind = \"leave\"` is enough")
    }
}
