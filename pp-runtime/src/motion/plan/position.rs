//! Position of the machine, as far as it is known.
//!
//! It is unknown at the start of a program, and after a stop, GOHOME, another frame or NC text of the CL data: see
//! [`Position::forget`].

use crate::kinematics::Pose;

use crate::motion::place::AxisPosition;
use crate::motion::plan::lead_out::LeadOut;
use crate::tolerance::writer::{ALONG_TOOL_AXIS, DEEP_PLUNGE, SAME_AXIS};

/// Position of the machine.
#[derive(Debug, Clone)]
pub(crate) struct Position {
    /// Last known place of the axes; before the first motion, the one from which rotary axes count.
    place: AxisPosition,
    /// Something has moved: `place` is more than a reference.
    moved: bool,
    /// The tool is at `place`.
    known: bool,
    /// The rotary axes are at the angles of `place`.
    rotary_known: bool,
    /// The CL data has moved the tool since the last stop.
    worked: bool,
    /// The stop of the configuration is the last that has been written.
    stopped: bool,
    /// `worked` before the blocks that may be skipped.
    worked_before_skip: bool,
    /// Blocks before may have been skipped, and no complete state has come since.
    after_skip: bool,
    /// The retract axis is at its retract position.
    retracted: bool,
    /// It is there with the complete state and the tool of the operation that comes.
    prepared: bool,
    /// The axes are at their parking positions, and nothing has moved them since.
    parked: bool,
    /// Linear words are tip coordinates: tip control is on, or a plane is tilted.
    in_frame: bool,
    /// Length by which the CL data has led the tool out along its axis.
    lead_out: LeadOut,
    /// Lowest pose of this tool axis that was cut in this operation.
    lowest: Option<Pose>,
    plunge_reported: bool,
}

impl Position {
    /// Nothing has moved; the rotary axes count from here.
    pub(crate) fn new(reference: AxisPosition) -> Self {
        Self {
            place: reference,
            moved: false,
            known: false,
            rotary_known: false,
            worked: false,
            stopped: false,
            worked_before_skip: false,
            after_skip: false,
            retracted: false,
            prepared: false,
            parked: false,
            in_frame: false,
            lead_out: LeadOut::default(),
            lowest: None,
            plunge_reported: false,
        }
    }

    /// Place of the axes, or the last one that was known.
    #[inline]
    pub(crate) fn place(&self) -> &AxisPosition {
        &self.place
    }

    /// Tip and tool axis at this place.
    #[inline]
    pub(crate) fn pose(&self) -> Pose {
        self.place.pose
    }

    /// Whether the tool is at its place.
    pub(crate) fn is_known(&self) -> bool {
        self.known
    }

    /// Whether the retract axis is at its retract position.
    pub(crate) fn is_retracted(&self) -> bool {
        self.retracted
    }

    /// Whether the complete state and the tool of the operation that comes are in force.
    pub(crate) fn is_prepared(&self) -> bool {
        self.prepared
    }

    /// Whether the axes are at their parking positions.
    pub(crate) fn is_parked(&self) -> bool {
        self.parked
    }

    /// They are in force, at the machine retract.
    pub(crate) fn prepare(&mut self) {
        self.prepared = true;
        (self.stopped, self.after_skip) = (false, false);
    }

    /// Whether blocks before may have been skipped, and no complete state has come since.
    pub(crate) fn is_after_skip(&self) -> bool {
        self.after_skip
    }

    /// Whether the rotary axes are at the angles of the place.
    pub(crate) fn knows_rotary_axes(&self) -> bool {
        self.rotary_known
    }

    /// Whether anything has moved since the beginning.
    pub(crate) fn has_moved(&self) -> bool {
        self.moved
    }

    /// Whether the CL data has moved the tool since the last stop.
    pub(crate) fn has_worked(&self) -> bool {
        self.worked
    }

    /// A tool change or blocks of the shop may move any axis: the angles of the rotary axes are unknown.
    pub(crate) fn forget_rotary_axes(&mut self) {
        self.rotary_known = false;
    }

    /// Whether linear words are tip coordinates.
    pub(crate) fn is_in_frame(&self) -> bool {
        self.in_frame
    }

    /// Length by which the CL data has led the tool out along its axis, mm.
    pub(crate) fn led_out_mm(&self) -> f64 {
        self.lead_out.length_mm()
    }

    /// FROM: as long as nothing has moved, the rotary axes count from here.
    pub(crate) fn count_from(&mut self, reference: impl FnOnce(&AxisPosition) -> Option<AxisPosition>) {
        if !self.moved
            && let Some(place) = reference(&self.place)
        {
            self.place = place;
        }
    }

    /// A motion of the CL data has ended here.
    pub(crate) fn arrive(&mut self, place: &AxisPosition) {
        self.stopped = false;
        self.place = *place;
        self.moved = true;
        self.known = true;
        self.rotary_known = true;
        self.worked = true;
        self.retracted = false;
        self.prepared = false;
        self.parked = false;
    }

    /// A block within a motion, or between two motions, has ended here.
    #[inline]
    pub(crate) fn go_to(&mut self, place: &AxisPosition) {
        self.place = *place;
    }

    /// The rotary axes are parked here; the next rotation begins here.
    pub(crate) fn park_rotary(&mut self, place: AxisPosition) {
        self.place = place;
        self.moved = true;
    }

    /// All axes are parked, the retract axis at its retract position.
    pub(crate) fn park(&mut self) {
        self.parked = true;
    }

    /// Other axes have gone to other positions of the machine.
    pub(crate) fn leave_parking(&mut self) {
        self.parked = false;
    }

    /// Forgets the position: anything may have moved the machine.
    pub(crate) fn forget(&mut self) {
        self.known = false;
        self.rotary_known = false;
        self.retracted = false;
        self.prepared = false;
        self.parked = false;
        self.stopped = false;
    }

    /// Forgets the position at a stop: what has moved needs no further one. `configured`: the configuration asks for
    /// it.
    pub(crate) fn stop(&mut self, configured: bool) {
        self.forget();
        self.worked = false;
        self.stopped = configured;
    }

    /// Whether an optional stop of the CL data is the one of the configuration, which has just been written.
    pub(crate) fn take_stop(&mut self) -> bool {
        std::mem::take(&mut self.stopped)
    }

    /// Blocks that may be skipped begin or end here; skipped, a stop among them has not been.
    pub(crate) fn skip(&mut self, begins: bool) {
        (self.parked, self.after_skip) = (false, !begins);
        if begins {
            self.worked_before_skip = self.worked;
        } else {
            self.worked |= self.worked_before_skip;
        }
    }

    /// Forgets that the retract axis is at its retract position.
    pub(crate) fn forget_retract(&mut self) {
        self.retracted = false;
        self.parked = false;
    }

    /// The tool has left the part along its axis.
    pub(crate) fn leave(&mut self) {
        self.lead_out = LeadOut::default();
        self.known = false;
    }

    /// The program is entered here: the tool may be anywhere.
    pub(crate) fn enter(&mut self) {
        self.known = false;
        self.prepared = false;
        self.parked = false;
        self.rotary_known = false;
    }

    /// The retract axis is at its retract position; linear words are axis positions again.
    pub(crate) fn retract(&mut self) {
        self.retracted = true;
        self.in_frame = false;
    }

    /// A safety line: linear words are axis positions.
    pub(crate) fn leave_frame(&mut self) {
        self.in_frame = false;
    }

    /// Tip control is on, or a plane is tilted, which may move the retract axis.
    pub(crate) fn enter_frame(&mut self) {
        self.in_frame = true;
        self.retracted = false;
    }

    /// A motion of the CL data leads from one pose to another.
    #[inline(always)]
    pub(crate) fn follow(&mut self, from: &Pose, to: &Pose) {
        self.lead_out.follow(from, to);
    }

    /// A cut of the CL data leads from here to a pose.
    #[inline(always)]
    pub(crate) fn cut_to(&mut self, pose: &Pose) {
        self.note_cut(pose);
        self.lead_out.follow(&self.place.pose, pose);
    }

    /// Sets the length of the lead-out to zero.
    pub(crate) fn forget_lead_out(&mut self) {
        self.lead_out = LeadOut::default();
    }

    /// An operation begins: nothing has been cut in it yet.
    pub(crate) fn begin_operation(&mut self) {
        self.lowest = None;
        self.plunge_reported = false;
    }

    /// Remembers the lowest level that was cut with this tool axis in this operation.
    #[inline(always)]
    pub(crate) fn note_cut(&mut self, pose: &Pose) {
        match &mut self.lowest {
            Some(lowest)
                if (lowest.axis.into_inner() - pose.axis.into_inner()).norm_squared() < SAME_AXIS * SAME_AXIS =>
            {
                if (pose.tip - lowest.tip).dot(&lowest.axis) < 0.0 {
                    lowest.tip = pose.tip;
                }
            }
            lowest => *lowest = Some(*pose),
        }
    }

    /// Depth of a rapid along the tool axis below the lowest cut of this operation, mm; returned once in an operation.
    pub(crate) fn plunges(&mut self, from: &Pose, to: &Pose) -> Option<f64> {
        let lowest = self.lowest?;
        let step = to.tip - from.tip;
        let down = -step.dot(&to.axis);
        let across = (step + to.axis.into_inner() * down).norm();
        let same = (lowest.axis.into_inner() - to.axis.into_inner()).norm() < SAME_AXIS;
        let depth = -(to.tip - lowest.tip).dot(&to.axis);
        if same && down > 0.0 && across <= ALONG_TOOL_AXIS * down && depth > DEEP_PLUNGE && !self.plunge_reported {
            self.plunge_reported = true;
            return Some(depth);
        }
        None
    }
}
