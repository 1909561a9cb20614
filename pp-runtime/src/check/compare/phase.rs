//! Phases of a program, each with the data that has a meaning in it.

use std::rc::Rc;

use nalgebra::Vector3;

use super::super::expect::Required;
use super::super::geometry::{Segment, ToolPose, is_within_angle};
use super::super::policy::LinearMeaning;
use super::super::read::{Action, MAX_AXES};
use crate::check::tolerances::{ALONG_TOOL_AXIS, NO_DIRECTION, SAME_POINT};
use crate::program::Feed;

/// Phase of a program.
#[derive(Debug, Clone)]
pub(super) enum Phase {
    /// The position of the machine is unknown: at the start, after a tool change, a stop, a block of the CL data.
    Unknown {
        /// The program has stopped with the spindle off.
        stopped: bool,
    },
    /// On the path of the CL data.
    Cutting(Box<Cutting>),
    /// Retracted along the tool axis; the machine retract is next.
    Leaving(Box<Leaving>),
    /// At the retract position, or in the approach from it.
    Retracted(Box<Retracted>),
    /// After the end code.
    Ended,
}

/// On the path of the CL data.
#[derive(Debug, Clone, Default)]
pub(super) struct Cutting {
    /// Where the tool is.
    pub(crate) here: Option<ToolPose>,
    pub(crate) retract: RetractedLength,
    /// Way back to the point at which the rotary axes were rewound.
    pub(crate) back: Option<Box<Segment>>,
    /// The coolant was on in the retract to it.
    pub(crate) wet_retract: bool,
    /// The rapid of which the last block was a part.
    pub(super) rapid_from: Option<Box<RapidStart>>,
    /// The rapid of which the last block was a step.
    pub(crate) steps: Option<Box<RapidSteps>>,
    /// The motion that the last block has ended.
    pub(crate) finished: Option<FinishedMotion>,
}

impl Cutting {
    /// Whether blocks have been taken for the rest of the last motion.
    pub(super) fn has_rested(&self) -> bool {
        self.finished.as_ref().is_some_and(|finished| finished.rotated_rad > 0.0)
    }
}

/// Retracted along the tool axis.
#[derive(Debug, Clone)]
pub(super) struct Leaving {
    pub(crate) here: ToolPose,
    pub(crate) retract: RetractedLength,
    pub(crate) rewind: Option<RewindPoint>,
}

/// At the retract position.
#[derive(Debug, Clone, Default)]
pub(super) struct Retracted {
    /// Step of the approach that was done last: 1 rotary axes, 2 linear axes, 3 down to the approach point.
    pub(crate) step: u8,
    /// Meaning of the linear words of its second step.
    pub(crate) meaning: Option<LinearMeaning>,
    /// Words of the approach so far, and their bits.
    pub(crate) approach: ([f64; MAX_AXES], u16),
    /// Rotary words since the control has positioned the axes to a plane: bits.
    pub(crate) since_plane: Option<u16>,
    /// Its second step came before tip control.
    pub(crate) before_tip_control: bool,
    /// Axis values across the retract axis after its second step, where they do not depend on the retract axis.
    pub(crate) across: Option<[f64; MAX_AXES]>,
    pub(crate) rewind: Option<RewindPoint>,
    /// The program has stopped with the spindle off, and no approach has begun since.
    pub(crate) stopped: bool,
    /// Axes may move to their parking positions.
    pub(crate) parks: bool,
    /// Linear axes have moved there.
    pub(crate) linear_parked: bool,
    /// Axes that have gone to their home positions: bits.
    pub(crate) homed: u16,
}

/// The point at which the cut is interrupted to rewind rotary axes.
#[derive(Debug, Clone)]
pub(super) struct RewindPoint {
    pub(crate) pose: ToolPose,
    /// End of the retract along the tool axis.
    pub(crate) out: Option<ToolPose>,
    /// The motion that was done but for rounding: the cut may have been interrupted just before its end.
    pub(crate) finished: Option<FinishedMotion>,
    /// The coolant was on in the retract, which is right only if the cut continues.
    pub(crate) wet: bool,
}

/// Length of the last motions out along the tool axis.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct RetractedLength {
    /// Start of the next motion.
    from: Option<ToolPose>,
    /// Where it ends, if there is one.
    end: Option<Vector3<f64>>,
    out_mm: f64,
}

/// Where a rapid in several blocks has begun.
#[derive(Debug, Clone)]
pub(super) struct RapidStart {
    /// The words before it.
    pub(super) words: [f64; MAX_AXES],
    /// The last block has led to the corner between its two halves.
    pub(super) is_corner: bool,
}

/// A rapid in steps: words before the first and after the last step.
#[derive(Debug, Clone, Copy)]
pub(super) struct RapidSteps {
    pub(crate) start: [f64; MAX_AXES],
    pub(crate) last: [f64; MAX_AXES],
}

/// A motion that is done.
#[derive(Debug, Clone)]
pub(super) struct FinishedMotion {
    pub(crate) segment: Segment,
    pub(crate) required: Rc<Required>,
    /// Feed of a block that is no rapid.
    pub(crate) feed: Option<Feed>,
    /// It was run at feed.
    pub(crate) at_feed: bool,
    /// It was a rapid that rotates the tool, without a retract.
    pub(crate) link: bool,
    /// Rotation of rotary axes since, the tool axis being at its end, rad.
    pub(crate) rotated_rad: f64,
}

/// Task of a block.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Task {
    /// Modal state only.
    Modal,
    /// A block after the end code.
    AfterEnd,
    ToolChange,
    Dwell,
    Stop,
    End,
    /// To a position of the machine: the machine retract, a home position, or a parking position.
    MachinePosition,
    /// The control positions the rotary axes to the tilted plane.
    Orient,
    OrientElsewhere,
    /// A step of the approach.
    Approach,
    /// A cycle of the control.
    Cycle,
    /// On the path of the CL data, or the retract along the tool axis.
    Cut,
    /// At the part without an approach.
    Astray,
}

impl Phase {
    /// The task of a block: the table of phase and action. The phase after it is in the last column.
    #[rustfmt::skip]
    pub(super) fn task(&self, action: &Action) -> Task {
        match (self, action) {
            (_,                  Action::Nothing)                     => Task::Modal,              // the same
            (Self::Ended,        _)                                   => Task::AfterEnd,           // the same
            (_,                  Action::ToolChange)                  => Task::ToolChange,         // unknown
            (_,                  Action::Stop | Action::OptionalStop) => Task::Stop,               // unknown
            (_,                  Action::Dwell(_))                    => Task::Dwell,              // the same
            (_,                  Action::End)                         => Task::End,                // ended
            (_,                  Action::Machine)                     => Task::MachinePosition,    // retracted
            (_,                  Action::Reference { .. })            => Task::MachinePosition,    // retracted, unknown
            (_,                  Action::EndOfTravel)                 => Task::MachinePosition,    // retracted, unknown
            (Self::Retracted(_), Action::Orient)                      => Task::Orient,             // the same
            (_,                  Action::Orient)                      => Task::OrientElsewhere,    // the same
            (Self::Retracted(_), Action::Rapid)                       => Task::Approach,           // retracted, cutting
            (_,                  Action::Cycle(_))                    => Task::Cycle,              // cutting
            (Self::Cutting(_),   _)                                   => Task::Cut,                // cutting, leaving
            (_,                  _)                                   => Task::Astray,             // cutting
        }
    }

    /// Where the tool is, if that is known.
    pub(super) fn here(&self) -> Option<&ToolPose> {
        match self {
            Self::Cutting(cutting) => cutting.here.as_ref(),
            Self::Leaving(leaving) => Some(&leaving.here),
            Self::Unknown { .. } | Self::Retracted(_) | Self::Ended => None,
        }
    }

    /// Whether the tool is at the part.
    pub(super) fn is_at_part(&self) -> bool {
        matches!(self, Self::Cutting(_) | Self::Leaving(_))
    }

    /// Whether the machine is at its retract position, or in an approach.
    pub(super) fn is_retracted(&self) -> bool {
        matches!(self, Self::Retracted(_))
    }

    /// Whether the program has stopped with the spindle off, and no approach has begun since.
    pub(super) fn is_stopped(&self) -> bool {
        match self {
            Self::Unknown { stopped } => *stopped,
            Self::Retracted(retracted) => retracted.stopped,
            Self::Cutting(_) | Self::Leaving(_) | Self::Ended => false,
        }
    }

    /// The spindle starts for a dwell, after a stop or not.
    pub(super) fn start_spindle(&mut self) {
        match self {
            Self::Unknown { stopped } => *stopped = false,
            Self::Retracted(retracted) => retracted.stopped = false,
            Self::Cutting(_) | Self::Leaving(_) | Self::Ended => {}
        }
    }

    pub(super) fn is_unknown(&self) -> bool {
        matches!(self, Self::Unknown { .. })
    }
}

impl RetractedLength {
    pub(super) fn out_mm(&self) -> f64 {
        self.out_mm
    }

    /// From a pose on, with a length out along the tool axis.
    pub(super) fn starting(from: ToolPose, out_mm: f64) -> Self {
        Self { from: Some(from), end: (out_mm > 0.0).then_some(from.tip), out_mm }
    }

    /// The same retract, longer.
    pub(super) fn longer(self, by_mm: f64) -> Self {
        Self { out_mm: self.out_mm + by_mm, ..self }
    }

    /// Adds the motion to a pose. `start`: where it begins, if motions that need no block have led there.
    pub(super) fn follow(&mut self, start: &Vector3<f64>, to: &ToolPose) {
        let is_there = |from: &ToolPose| (start - from.tip).norm() <= SAME_POINT;
        let from = self.from.replace(*to).map_or(*to, |from| match is_there(&from) {
            true => ToolPose { tip: *start, ..from },
            false => from,
        });
        if !is_within_angle(&from.axis, &to.axis, ALONG_TOOL_AXIS) {
            (self.out_mm, self.end) = (0.0, None);
            return;
        }
        let step = to.tip - from.tip;
        let along = step.dot(&to.axis);
        let across = (step - to.axis * along).norm();
        let (out_mm, end) = if self.end.is_some_and(|end| (to.tip - end).norm() <= SAME_POINT) {
            return;
        } else if along > NO_DIRECTION && across <= ALONG_TOOL_AXIS * along {
            (self.out_mm + along, Some(to.tip))
        } else if along.abs() > NO_DIRECTION || across > NO_DIRECTION {
            (0.0, None)
        } else {
            return;
        };
        (self.out_mm, self.end) = (out_mm, end);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Length out along Z after poses one after the other.
    fn out_mm(tips: &[[f64; 3]]) -> f64 {
        let pose = |tip: &[f64; 3]| ToolPose { tip: Vector3::from(*tip), axis: Vector3::z() };
        let mut retract = RetractedLength::starting(pose(&[0.0; 3]), 50.0);
        let starts = std::iter::once(&[0.0; 3]).chain(tips);
        starts.zip(tips).for_each(|(start, tip)| retract.follow(&pose(start).tip, &pose(tip)));
        retract.out_mm()
    }

    #[test]
    fn a_point_that_the_rounding_of_cl_data_repeats_does_not_end_a_retract() {
        assert!((out_mm(&[[0.0001, 0.0, -0.0001], [0.0, 0.003, 0.0]]) - 50.0).abs() < 1e-12);
        assert!((out_mm(&[[0.0001, 0.0, 0.0], [0.0001, 0.0, 10.0]]) - 60.0).abs() < 1e-12);
        assert!(out_mm(&[[0.006, 0.0, 0.0]]) < 1e-12);
        // Many such motions lead away.
        let steps: Vec<_> = (1..10).map(|step| [0.0, 0.0, -0.002 * f64::from(step)]).collect();
        assert!(out_mm(&steps) < 1e-12);
    }
}
