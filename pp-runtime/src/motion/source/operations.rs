//! Numbers of motions, operations and stretches: counted once, for every pass.
//!
//! An operation begins with the first motion after TOOL PATH, a tool record, a stop, a change of the frame, GOHOME, or
//! NC text in the CL data. A stretch is the part of an operation between two changes of the tool axis in the air: it
//! begins with an operation, and with a rapid or a hole whose tool axis differs from the one before. Holes and other
//! motions are never in one stretch. Within a stretch the tool axis is constant, or changes at feed.

use crate::kinematics::{AnyMachine, Pose, Side};
use crate::motion::geometry::{ClearanceGeometry, line_enters};
use crate::motion::place::rotaries_of;
use crate::motion::policy::Policy;
use crate::nalgebra::UnitVector3;
use crate::options::Transition;
use crate::program::{ClearancePlane, Hole, Move, ToolCall};
use crate::tolerance::writer::{HELD_AXIS, SAME_AXIS};

/// Relation of a motion to the one before it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Begins {
    /// The motion belongs to the same operation.
    Nothing,
    /// The motion begins an operation that may continue from the end of the last one: no interruption, and `transition`
    /// permits it.
    Linked,
    /// The motion begins an operation that starts with the safe sequence.
    Operation,
}

/// Numbers of a motion in the program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct MotionIndex {
    /// Number of the motion, from 0.
    pub motion: u64,
    /// Number of its operation, from 1.
    pub operation: u64,
    /// Number of its stretch, from 1, counted over all operations.
    pub stretch: u64,
    /// Whether the motion begins an operation.
    pub begins: Begins,
    /// The motion is at feed, and its tool axis is not the one with which the stretch began, or that of a feed line
    /// before it in the stretch was not.
    pub rotates_axis: bool,
}

/// What has come since the last motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Since {
    /// Nothing with which the path begins anew: a cut goes on from there, after a stop too.
    NoNewStart,
    /// The name of an operation alone.
    Name,
    /// A tool, GOHOME, a retract, or another set-up.
    NewStart,
}

/// Whether an operation may continue from the end of the last one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Linking {
    Never,
    /// As in the CL data.
    Always,
    /// With the same tool and tool axis, over the clearance geometry.
    OverClearance,
}

/// Counts the motions of a program.
#[derive(Debug, Clone)]
pub(crate) struct MotionCounter {
    links: Linking,
    /// Clearance geometry in force, and that of the configuration.
    clearance: ClearanceGeometry,
    /// The last call of a tool.
    last_call: Option<ToolCall>,
    /// The tool side has rotary axes: no rapid may be left out, since the tool length moves the axes.
    rotary_head: bool,
    /// The tool that is called before the first motion if the CL data calls none.
    assumed_tool: Option<u32>,
    /// A tool has been called.
    called: bool,
    /// A rapid has been left out.
    passed_over: bool,
    /// Whether the next motion begins an operation.
    begins: Begins,
    next_motion: u64,
    operation: u64,
    stretch: u64,
    /// End of the last motion.
    end: Option<Pose>,
    /// Where the tool is after it: above a hole.
    here: Option<Pose>,
    /// What has come since.
    since: Since,
    /// Tool axis at the begin of the stretch.
    stretch_axis: Option<UnitVector3<f64>>,
    /// A feed line of the stretch has had another one.
    has_rotated: bool,
    /// The last motion was a hole.
    in_holes: bool,
}

impl MotionCounter {
    pub(crate) fn new(machine: &dyn AnyMachine, policy: Policy<'_>) -> Self {
        let rotary_head = rotaries_of(machine.axes(), Side::Tool).next().is_some();
        Self {
            links: match policy.options.rapids.transition {
                Transition::Direct => Linking::Always,
                Transition::Auto if !rotary_head => Linking::OverClearance,
                Transition::Auto | Transition::Safe => Linking::Never,
            },
            clearance: ClearanceGeometry::new(policy.options.retract.clearance),
            last_call: None,
            rotary_head,
            assumed_tool: policy.options.defaults.tool,
            called: false,
            passed_over: false,
            begins: Begins::Operation,
            next_motion: 0,
            operation: 0,
            stretch: 0,
            end: None,
            here: None,
            since: Since::NoNewStart,
            stretch_axis: None,
            has_rotated: false,
            in_holes: false,
        }
    }

    /// Whether no motion has come since the last operation ended.
    pub(crate) fn between(&self) -> bool {
        self.begins != Begins::Nothing
    }

    /// Number of the next operation.
    pub(crate) fn next_operation(&self) -> u64 {
        self.operation + 1
    }

    /// Counts TOOL PATH.
    pub(crate) fn name(&mut self) {
        if self.since == Since::NoNewStart {
            self.since = if self.links == Linking::Always { Since::NewStart } else { Since::Name };
        }
        let may_link = match self.links {
            Linking::Never => false,
            Linking::Always => true,
            Linking::OverClearance => self.clearance.in_force().is_some(),
        };
        self.link(may_link);
    }

    /// Another operation begins, which may continue from the end of the last one or not.
    fn link(&mut self, may_link: bool) {
        self.begins = match self.begins {
            Begins::Nothing | Begins::Linked if may_link => Begins::Linked,
            Begins::Nothing | Begins::Linked | Begins::Operation => Begins::Operation,
        };
    }

    /// Counts CLEARP. Another geometry between two operations: the tool leaves the one before.
    pub(crate) fn set_clearance(&mut self, plane: ClearancePlane) {
        if self.clearance.changes(plane) && self.between() && self.links == Linking::OverClearance {
            self.interrupt();
        }
        self.clearance.set_plane(plane);
    }

    /// Counts another set-up.
    pub(crate) fn change_set_up(&mut self) {
        self.clearance.change_set_up();
        self.leave();
    }

    /// Counts a record after which the position of the machine, or its state, is unknown.
    pub(crate) fn interrupt(&mut self) {
        self.begins = Begins::Operation;
    }

    /// Counts a record after which the path does not go on from where it was: a tool, GOHOME, a retract, another
    /// set-up.
    pub(crate) fn leave(&mut self) {
        self.since = Since::NewStart;
        self.interrupt();
    }

    /// Counts a tool record.
    pub(crate) fn call_tool(&mut self, call: &ToolCall) {
        self.assumed_tool = None;
        self.called = true;
        let again = self.last_call.replace(*call) == Some(*call);
        self.since = Since::NewStart;
        self.link(again && self.links == Linking::OverClearance && self.clearance.in_force().is_some());
    }

    /// Whether a rapid leads from the end of the last operation over the clearance geometry, with the same tool axis.
    fn leads_over_clearance(&self, end: &Pose) -> bool {
        let (Some(from), Some(clearance)) = (self.here, self.clearance.in_force()) else { return false };
        let axes = from.axis.into_inner() - end.axis.into_inner();
        axes.norm() <= SAME_AXIS && !line_enters(clearance, &from.tip, &end.tip, 0.0)
    }

    /// Where the last motion ended, if all that has come since is the name of an operation.
    pub(crate) fn named_at(&self) -> Option<Pose> {
        self.end_before(Since::Name)
    }

    /// Where a cut goes on that was interrupted. An operation with a name or a tool record begins at its first point.
    pub(crate) fn goes_on_from(&self) -> Option<Pose> {
        self.end_before(Since::NoNewStart)
    }

    /// End of the last motion, if it was no hole and this has come since.
    fn end_before(&self, since: Since) -> Option<Pose> {
        self.end.filter(|_| self.between() && self.since == since && !self.in_holes)
    }

    /// Takes the tool that must be called before this motion, if any.
    pub(crate) fn take_assumed_tool(&mut self) -> Option<u32> {
        let number = self.assumed_tool?;
        self.call_tool(&ToolCall { number, ..ToolCall::default() });
        Some(number)
    }

    /// Whether a motion is a rapid before the first tool, which is not written: the length offset of the tool in the
    /// spindle is not active, and Z would go deeper by that length.
    pub(crate) fn passes_over(&self, motion: &Move) -> bool {
        motion.rapid && !self.called && !self.rotary_head && self.between()
    }

    /// Whether this is the first rapid that is left out.
    pub(crate) fn first_passed_over(&mut self) -> bool {
        !std::mem::replace(&mut self.passed_over, true)
    }

    /// Counts a straight motion.
    #[inline]
    pub(crate) fn line(&mut self, motion: &Move) -> MotionIndex {
        let index = self.count(&motion.pose, motion.rapid, false);
        self.has_rotated |= index.rotates_axis;
        index
    }

    /// Counts a motion at feed with a constant tool axis.
    pub(crate) fn hold(&mut self, end: &Pose) -> MotionIndex {
        self.count(end, false, false)
    }

    /// Counts a hole: a rapid leads to it.
    pub(crate) fn hole(&mut self, hole: &Hole) -> MotionIndex {
        let index = self.count(&hole.top, true, true);
        self.here = Some(hole.level(hole.return_mm));
        index
    }

    #[inline]
    fn count(&mut self, end: &Pose, air: bool, hole: bool) -> MotionIndex {
        let differs = |before: UnitVector3<f64>, most: f64| {
            (before.into_inner() - end.axis.into_inner()).norm_squared() > most * most
        };
        let begins = match std::mem::replace(&mut self.begins, Begins::Nothing) {
            Begins::Linked if self.links == Linking::OverClearance => {
                if air && !hole && self.leads_over_clearance(end) { Begins::Linked } else { Begins::Operation }
            }
            begins => begins,
        };
        self.here = Some(*end);
        let before = self.end.replace(*end).map(|end| end.axis);
        self.since = Since::NoNewStart;
        let first = begins != Begins::Nothing;
        let other_kind = std::mem::replace(&mut self.in_holes, hole) != hole;
        let held = self.stretch_axis.filter(|_| !self.has_rotated).or(before);
        let stretch_begins = first || other_kind || air && held.is_some_and(|held| differs(held, HELD_AXIS));
        self.operation += u64::from(first);
        self.stretch += u64::from(stretch_begins);
        if stretch_begins {
            // A feed motion at the begin starts from the last tool axis, unless the safe sequence leads to its end.
            self.stretch_axis = before.filter(|_| !air && begins != Begins::Operation).or(Some(end.axis));
            self.has_rotated = false;
        }
        let rotates_axis = !air && (self.has_rotated || self.stretch_axis.is_some_and(|axis| differs(axis, HELD_AXIS)));
        let motion = self.next_motion;
        self.next_motion += 1;
        MotionIndex { motion, operation: self.operation, stretch: self.stretch, begins, rotates_axis }
    }
}
