//! Operations, stretches and the numbers of motions: counted once, for every pass.
//!
//! An operation begins with the first motion after TOOL PATH, a tool record, a stop, another frame, GOHOME, or NC text of
//! the CL data. A stretch is what is cut between two changes of the tool axis in the air: it begins with an operation, and
//! with a rapid or a hole whose tool axis is not the one before. Within it the tool axis is held, or it turns at feed.

use crate::kinematics::{AnyMachine, Pose, Side};
use crate::motion::options::{Policy, Transition};
use crate::motion::place::rotaries_of;
use crate::nalgebra::UnitVector3;
use crate::program::{Hole, Move};

use crate::motion::geometry::SAME_AXIS;

/// How a motion relates to the one before it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Begins {
    /// Both belong to the same operation.
    Nothing,
    /// An operation that may go on where the last one ended: `transition = "direct"`, and nothing interrupted it.
    Linked,
    /// An operation that begins with the safe sequence.
    Operation,
}

/// Where a motion is in the program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct MotionIndex {
    /// Its number, from 0.
    pub motion: u64,
    /// The number of its operation, from 1.
    pub operation: u64,
    /// The number of its stretch, from 1, counted over all operations.
    pub stretch: u64,
    /// Whether it is the first of its operation.
    pub begins: Begins,
    /// The tool axis turns in it at feed.
    pub turns: bool,
}

/// Counts the motions of a program.
#[derive(Debug, Clone)]
pub(crate) struct MotionCounter {
    /// Operations go on where the last one ended.
    links_operations: bool,
    /// The tool's length moves the axes even without a tool: nothing may be passed over.
    rotary_head: bool,
    /// The tool that is called before the first motion if the CL data calls none.
    assumed_tool: Option<u32>,
    /// A tool has been called.
    called: bool,
    /// A rapid has been passed over.
    passed_over: bool,
    /// What the next motion begins.
    begins: Begins,
    next_motion: u64,
    operation: u64,
    stretch: u64,
    /// Tool axis at the end of the last motion.
    axis: Option<UnitVector3<f64>>,
}

impl MotionCounter {
    pub(crate) fn new(machine: &dyn AnyMachine, policy: Policy<'_>) -> Self {
        Self {
            links_operations: policy.options.rapids.transition == Transition::Direct,
            rotary_head: rotaries_of(machine.axes(), Side::Tool).next().is_some(),
            assumed_tool: policy.options.defaults.tool,
            called: false,
            passed_over: false,
            begins: Begins::Operation,
            next_motion: 0,
            operation: 0,
            stretch: 0,
            axis: None,
        }
    }

    /// Nothing has moved since the last operation.
    pub(crate) fn between(&self) -> bool {
        self.begins != Begins::Nothing
    }

    /// TOOL PATH.
    pub(crate) fn name(&mut self) {
        self.begins = match self.begins {
            Begins::Nothing | Begins::Linked if self.links_operations => Begins::Linked,
            Begins::Nothing | Begins::Linked | Begins::Operation => Begins::Operation,
        };
    }

    /// A record after which the position of the machine, or its state, is unknown.
    pub(crate) fn interrupt(&mut self) {
        self.begins = Begins::Operation;
    }

    /// A tool record.
    pub(crate) fn call_tool(&mut self) {
        self.assumed_tool = None;
        self.called = true;
        self.interrupt();
    }

    /// The tool that is to be called before the motion at hand.
    pub(crate) fn take_assumed_tool(&mut self) -> Option<u32> {
        let number = self.assumed_tool?;
        self.call_tool();
        Some(number)
    }

    /// A rapid before the first tool is not written: whatever is in the spindle, its length offset is not active, and Z
    /// would go deeper by that length.
    pub(crate) fn passes_over(&self, motion: &Move) -> bool {
        motion.rapid && !self.called && !self.rotary_head && self.between()
    }

    /// Whether this is the first rapid that is passed over.
    pub(crate) fn first_passed_over(&mut self) -> bool {
        !std::mem::replace(&mut self.passed_over, true)
    }

    /// A feed motion inside an operation; `None` for any other.
    #[inline]
    pub(crate) fn cut(&mut self, motion: &Move) -> Option<MotionIndex> {
        (self.begins == Begins::Nothing && !motion.rapid).then(|| self.line(motion))
    }

    /// A straight motion.
    #[inline]
    pub(crate) fn line(&mut self, motion: &Move) -> MotionIndex {
        self.count(&motion.pose, motion.rapid)
    }

    /// A motion at feed with the tool axis held.
    pub(crate) fn hold(&mut self, end: &Pose) -> MotionIndex {
        self.count(end, false)
    }

    /// A hole: the tool goes over to it at rapid.
    pub(crate) fn hole(&mut self, hole: &Hole) -> MotionIndex {
        self.count(&hole.top, true)
    }

    #[inline]
    fn count(&mut self, end: &Pose, air: bool) -> MotionIndex {
        let begins = std::mem::replace(&mut self.begins, Begins::Nothing);
        let other = |before: UnitVector3<f64>| {
            (before.into_inner() - end.axis.into_inner()).norm_squared() > SAME_AXIS * SAME_AXIS
        };
        let turned = self.axis.replace(end.axis).is_some_and(other);
        let first = begins != Begins::Nothing;
        self.operation += u64::from(first);
        self.stretch += u64::from(first || air && turned);
        let motion = self.next_motion;
        self.next_motion += 1;
        let turns = turned && !air && begins != Begins::Operation;
        MotionIndex { motion, operation: self.operation, stretch: self.stretch, begins, turns }
    }
}
