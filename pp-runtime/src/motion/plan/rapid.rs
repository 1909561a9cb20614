//! Rapids inside an operation.
//!
//! A rapid that rotates the tool between cuts that rotate it as well is a *link*. The CAM system has verified its path,
//! not that of axes each of which moves at its own speed. So it is written only where every block keeps tip and tool
//! axis on their path, within the tolerance of cuts: as rapids whose axes arrive together, or at `rapid_feed`.
//! Elsewhere the safe sequence leads to its end, and where the tool axis is held before or after the rapid: there the
//! rotary axes are indexed, and clamped.
//!
//! Where each axis of a rapid moves at its own speed, the tip may leave its line. If it could get into the clearance
//! geometry so, which its line does not enter, the safe sequence leads to its end as well.

use crate::kinematics::Pose;
use crate::motion::fault::Planned;
use crate::motion::geometry::{is_separated, line_enters};
use crate::motion::place::AxisPosition;
use crate::motion::plan::{MotionAndNext, Planner};
use crate::motion::rotary::RotaryTarget;
use crate::motion::step::Sink;
use crate::options::{Links, Rapid, Transition};
use crate::tolerance::writer::{GRAZES_CLEARANCE, RAPID_ALONG_TOOL, SAME_AXIS};

/// Path of a rapid.
#[derive(Debug, Clone, Copy)]
enum RapidPath {
    /// By `rapid`.
    AsConfigured,
    /// That of the CL data, in certified pieces.
    Certified(LinkForm),
    /// The safe sequence.
    Sequence,
}

/// Blocks of a link.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum LinkForm {
    /// Rapids.
    Rapid,
    /// Feed motions, mm/min.
    Feed(f64),
}

impl<S: Sink> Planner<'_, S> {
    /// A rapid to a place.
    pub(crate) fn rapid(
        &mut self,
        ahead: MotionAndNext<'_>,
        place: &AxisPosition,
        planned: Option<RotaryTarget>,
    ) -> Planned {
        let motion = ahead.motion;
        let path = self.path_of_rapid(&motion.pose, place);
        if matches!(path, RapidPath::Sequence) {
            return self.index(ahead, planned);
        }
        let before = self.mover.position().pose();
        self.mover.watch_plunge(&before, &motion.pose);
        match path {
            RapidPath::Certified(form) => self.mover.link(place, form)?,
            RapidPath::AsConfigured | RapidPath::Sequence => self.mover.rapid_as_configured(motion, place)?,
        }
        self.mover.position_mut().follow(&before, &motion.pose);
        self.mover.arrive(place);
        Ok(())
    }

    /// Whether a rapid to a place, whose axes each move at their own speed, may lead the tip into the clearance
    /// geometry although its line is outside and not along the tool axis.
    pub(crate) fn may_enter_clearance(&self, place: &AxisPosition) -> bool {
        let rapids = &self.policy.options.rapids;
        let as_in_cl_data = rapids.transition == Transition::Direct || rapids.rapid == Rapid::Feed;
        let strays = !as_in_cl_data && !self.abilities.linear_rapids;
        let Some(clearance) = self.clearance.in_force().filter(|_| strays) else { return false };
        let (placer, here) = (self.mover.placer(), self.mover.here());
        let (axis, step) = (place.pose.axis.into_inner(), place.pose.tip - here.pose.tip);
        let across = (step - axis * step.dot(&axis)).norm();
        let holds_axis = (here.pose.axis.into_inner() - axis).norm() <= SAME_AXIS;
        let graze_mm = GRAZES_CLEARANCE * placer.unit_mm();
        if holds_axis && across <= RAPID_ALONG_TOOL * placer.unit_mm()
            || line_enters(clearance, &here.pose.tip, &place.pose.tip, graze_mm)
        {
            return false;
        }
        let dog_leg = placer.dog_leg(here, place);
        dog_leg.is_some_and(|dog_leg| !is_separated(clearance, &dog_leg.corners, dog_leg.beyond_mm - graze_mm))
    }

    /// Whether no axis exceeds its known speed in a rapid that rotates the tool.
    fn rapids_hold_speeds(&self) -> bool {
        self.mover.holds_axis_speeds() || !self.mover.placer().keeps_speeds()
    }

    fn path_of_rapid(&mut self, pose: &Pose, place: &AxisPosition) -> RapidPath {
        if self.mover.leaves_plane(place) {
            return RapidPath::Sequence;
        }
        let rapids = &self.policy.options.rapids;
        let (far, at_feed) = (self.mover.indexes(place), rapids.rapid == Rapid::Feed);
        let safe = rapids.transition != Transition::Direct;
        if !(far || at_feed && self.mover.rotates(place)) {
            return match self.may_enter_clearance(place) {
                true => RapidPath::Sequence,
                false => RapidPath::AsConfigured,
            };
        }
        let form = match rapids.rapid_feed_mm_per_min.map(LinkForm::Feed) {
            _ if far && safe && (rapids.links == Links::Safe || !self.modes.keeps_rotating()) => None,
            feed if at_feed => feed,
            _ if !safe => None,
            _ if self.abilities.linear_rapids && self.rapids_hold_speeds() => Some(LinkForm::Rapid),
            feed => feed,
        };
        match form {
            Some(form) if self.mover.follows(pose, place) => RapidPath::Certified(form),
            _ if safe => RapidPath::Sequence,
            _ => RapidPath::AsConfigured,
        }
    }
}
