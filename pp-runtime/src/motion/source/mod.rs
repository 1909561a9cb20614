//! The program as it is run, one item at a time: the common input of every pass over the CL data.
//!
//! ```text
//! event → setting     `part_rotation` (how the part lies on the table) and the lift of a dry run applied
//!       → curves      splines become chords; an arc after an interruption gets a line to its start
//! → operations  assumed tool called; a rapid before the first tool becomes FROM; motions numbered; the settings of
//!                     each operation found
//!       → lookahead   the first motion of an operation, and a rapid, wait for the motion after them
//!       → item
//! ```
//!
//! Survey, course and planner take the items of the same source, so their numbers of motions and operations agree. An
//! operation begins with the first motion after TOOL PATH, after a tool record, or after any record that leaves the
//! position of the machine unknown. It is split into stretches at each change of the tool axis in the air.

mod curves;
mod lookahead;
mod operations;
mod setting;
mod settings;
#[cfg(test)]
mod tests;

use crate::diag::code::plan;
use crate::diag::{Diagnostic, Severity};
use crate::kinematics::{AnyMachine, Pose};
use crate::motion::policy::Policy;
use crate::options::OperationChoice;
use crate::program::{
    Arc, Event, Hole, Location, MachineFunction, Move, NewStart, ReferenceGeometry, Spline, ToolCall, ToolMotion,
};

pub(crate) use lookahead::Next;
pub(crate) use operations::{Begins, MotionIndex};
pub(crate) use setting::Setting;
pub(crate) use settings::{Chosen, OperationStart};

use crate::tolerance::writer::SAME_POSE;
use curves::Curves;
use lookahead::Lookahead;
use operations::MotionCounter;
use settings::SettingsFinder;

/// One action of the program, with the CL record that programs it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ProgramItem<'e> {
    /// Location of the CL record.
    pub at: Location,
    /// The action.
    pub action: ItemAction<'e>,
}

/// Action of an item.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ItemAction<'e> {
    /// A straight motion.
    Line {
        /// End point and feed.
        motion: &'e Move,
        /// Number of the motion, its operation and its stretch.
        index: MotionIndex,
        /// The motion after it, if the approach may depend on that.
        next: Next,
        /// Share of its CL record.
        part: LinePart,
    },
    /// An arc; the tool is at its start.
    Arc {
        /// The arc.
        arc: &'e Arc,
        /// Number of the motion, its operation and its stretch.
        index: MotionIndex,
    },
    /// A hole.
    Hole {
        /// The hole.
        hole: &'e Hole,
        /// Number of the motion, its operation and its stretch.
        index: MotionIndex,
    },
    /// An operation begins with the next motion; only where the configuration has settings of operations.
    Operation(&'e OperationStart<'e>),
    /// Any record that is not a motion.
    Record {
        /// The event, never a motion; of LINTOL the tolerance that is then in force.
        event: &'e Event<'e>,
        /// The record comes between two operations and belongs to the second.
        between: bool,
    },
}

/// Share of its CL record that a straight motion is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LinePart {
    /// The whole record.
    Whole,
    /// First motion of a curve: the line to its start, or its first chord.
    CurveStart,
    /// A later chord of a curve.
    Chord,
}

/// Receiver of the items of a program.
pub trait Stage {
    /// Reason why the stage takes no further item.
    type Stop: From<Diagnostic>;

    /// Takes the next item.
    ///
    /// # Errors
    /// Those of the stage.
    fn take(&mut self, item: &ProgramItem<'_>) -> Result<(), Self::Stop>;

    /// Takes a warning about the CL data.
    fn remark(&mut self, remark: Diagnostic) {
        let _ = remark;
    }
}

/// Converts the events of the CL data into items.
#[derive(Debug, Clone)]
pub struct Source {
    setting: Setting,
    operations: MotionCounter,
    settings: SettingsFinder,
    curves: Curves,
    lookahead: Lookahead,
}

impl Source {
    /// Creates the source of one program.
    #[must_use]
    pub fn new(machine: &dyn AnyMachine, policy: Policy<'_>) -> Self {
        Self {
            setting: Setting::new(policy),
            operations: MotionCounter::new(machine, policy),
            settings: SettingsFinder::new(&policy.options.operations),
            curves: Curves::new(policy),
            lookahead: Lookahead::default(),
        }
    }

    /// Hands the items of one event of the CL data to a stage.
    ///
    /// # Errors
    /// Those of the stage, and a curve that cannot be cut into chords.
    pub fn event<S: Stage>(&mut self, at: Location, event: &Event<'_>, to: &mut S) -> Result<(), S::Stop> {
        let Self { setting, operations, settings, curves, lookahead } = self;
        let set = setting.event(event);
        let event = set.as_ref().unwrap_or(event);
        Expansion { at, operations, settings, curves, lookahead }.event(event, to)
    }

    /// Whether the first motion of an operation is held back until the next motion.
    #[must_use]
    pub fn awaits_second_motion(&self) -> bool {
        self.lookahead.awaits_second_motion()
    }

    /// Entries of the settings of operations that are for no operation so far.
    pub fn unused_settings(&self) -> impl Iterator<Item = &OperationChoice> {
        self.settings.unused()
    }

    /// Hands on the items that are still held back: there is no next motion.
    ///
    /// # Errors
    /// Those of the stage.
    pub fn finish<S: Stage>(&mut self, to: &mut S) -> Result<(), S::Stop> {
        self.lookahead.release(Next::None, to)
    }
}

/// Converts one event: through curves and operations to the look-ahead.
struct Expansion<'s> {
    at: Location,
    operations: &'s mut MotionCounter,
    settings: &'s mut SettingsFinder,
    curves: &'s mut Curves,
    lookahead: &'s mut Lookahead,
}

impl Expansion<'_> {
    /// Decides what an event means to the passes over a program; no other function does.
    fn event<S: Stage>(&mut self, event: &Event<'_>, to: &mut S) -> Result<(), S::Stop> {
        match event {
            Event::Motion(ToolMotion::Move(motion)) => {
                self.call_assumed_tool(to)?;
                self.line(motion, LinePart::Whole, to)
            }
            Event::Motion(ToolMotion::Arc(arc)) => {
                self.call_assumed_tool(to)?;
                // After a tool change or a stop a motion leads back to the start of the path.
                if self.operations.between() {
                    self.line(&Move { pose: arc.start, rapid: false, feed: arc.feed }, LinePart::Whole, to)?;
                }
                let index = self.operations.hold(&arc.end);
                self.lookahead.arc(self.at, arc, index, to)
            }
            Event::Motion(ToolMotion::Spline(spline)) => {
                self.call_assumed_tool(to)?;
                self.curve(spline, to)
            }
            Event::Motion(ToolMotion::Hole(hole)) => {
                self.call_assumed_tool(to)?;
                let index = self.operations.hole(hole);
                self.begin(index, to)?;
                self.lookahead.hole(self.at, hole, index, to)
            }
            Event::Function(MachineFunction::Tolerance(stated)) => {
                if let Err(remark) = self.curves.state_tolerance(*stated) {
                    to.remark(remark.at(self.at, Severity::Warning));
                }
                self.record(&Event::Function(MachineFunction::Tolerance(Some(self.curves.tolerance()))), to)
            }
            Event::NewStart(NewStart::Tool(call)) => {
                self.operations.call_tool(call);
                self.boundary(event, to)
            }
            Event::NewStart(NewStart::SetUp(_)) => {
                self.operations.change_set_up();
                self.boundary(event, to)
            }
            Event::NewStart(NewStart::Operation(name)) => {
                self.settings.name(self.at, name);
                self.operations.name();
                self.boundary(event, to)
            }
            Event::NewStart(_) => {
                self.operations.leave();
                self.boundary(event, to)
            }
            Event::Interruption(_) => {
                self.operations.interrupt();
                self.boundary(event, to)
            }
            Event::Reference(ReferenceGeometry::ClearancePlane(plane)) => {
                self.operations.set_clearance(*plane);
                self.record(event, to)
            }
            Event::Function(_) | Event::Reference(_) | Event::Text(..) => self.record(event, to),
        }
    }

    /// Hands on a straight motion.
    #[inline]
    fn line<S: Stage>(&mut self, motion: &Move, part: LinePart, to: &mut S) -> Result<(), S::Stop> {
        if self.operations.between() { self.first_line(motion, part, to) } else { self.single_line(motion, part, to) }
    }

    /// Hands on a straight motion between two operations. A rapid before the first tool only sets the start angles of
    /// the rotary axes.
    fn first_line<S: Stage>(&mut self, motion: &Move, part: LinePart, to: &mut S) -> Result<(), S::Stop> {
        if self.operations.passes_over(motion) {
            if self.operations.first_passed_over() {
                let remark = plan::TOOL.fault("this rapid is left out of the program: it comes before the first tool, and no length offset is active yet")
                    .help("call the tool before the first motion: LOADTL/1");
                to.remark(remark.at(self.at, Severity::Warning));
            }
            return self.record(&Event::Reference(ReferenceGeometry::From(motion.pose)), to);
        }
        if self.operations.named_at().is_some_and(|from| !motion.rapid && !is_at(&from, &motion.pose)) {
            let fault = plan::APPROACH.fault(
                "this operation begins with a feed motion: the safe sequence leads to its end, and the way from the last point is not cut",
            );
            let help = "if it is a cut, begin the operation at its start: RAPID to it in CAM";
            to.remark(fault.help(help).at(self.at, Severity::Warning));
        }
        // A cut that was interrupted goes on where it was: the safe sequence leads back there.
        let from = self.operations.goes_on_from().filter(|from| !motion.rapid && !is_at(from, &motion.pose));
        if let Some(pose) = from {
            self.single_line(&Move { pose, ..*motion }, LinePart::Whole, to)?;
        }
        self.single_line(motion, part, to)
    }

    #[inline]
    fn single_line<S: Stage>(&mut self, motion: &Move, part: LinePart, to: &mut S) -> Result<(), S::Stop> {
        let index = self.operations.line(motion);
        self.begin(index, to)?;
        self.lookahead.line(self.at, motion, index, part, to)
    }

    /// Hands on the settings of an operation before the motion that begins it. No motion is held back then.
    fn begin<S: Stage>(&mut self, index: MotionIndex, to: &mut S) -> Result<(), S::Stop> {
        if index.begins == Begins::Nothing || !self.settings.has_entries() {
            return Ok(());
        }
        self.take_tolerance(index.operation);
        let at = self.settings.begins_at(self.at);
        match self.settings.begin(index.operation, self.curves.tolerance()) {
            Ok(start) => to.take(&ProgramItem { at, action: ItemAction::Operation(&start) }),
            Err(fault) => Err(fault.at(at, Severity::Error).into()),
        }
    }

    /// Takes the tolerance of the operation of a number.
    fn take_tolerance(&mut self, operation: u64) {
        // Settings that contradict each other are reported where the operation begins.
        if let Ok(chosen) = self.settings.chosen(operation) {
            self.curves.configure(chosen.tolerance_mm.map(|tolerance| tolerance.value));
        }
    }

    /// Hands on a curve, chord by chord.
    fn curve<S: Stage>(&mut self, spline: &Spline<'_>, to: &mut S) -> Result<(), S::Stop> {
        let Some(start) = curves::start(spline) else { return Ok(()) };
        let mut part = LinePart::CurveStart;
        if self.operations.between() {
            self.line(&start, part, to)?;
            part = LinePart::Chord;
        }
        let (at, tolerance) = (self.at, self.curves.tolerance());
        curves::chords(spline, tolerance, |motion| match motion {
            Ok(motion) => self.line(&motion, std::mem::replace(&mut part, LinePart::Chord), to),
            Err(fault) => {
                self.lookahead.release(Next::None, to)?;
                Err(fault.at(at, Severity::Error).into())
            }
        })
    }

    /// Calls the tool of the configuration before the first motion of a program without a tool record.
    fn call_assumed_tool<S: Stage>(&mut self, to: &mut S) -> Result<(), S::Stop> {
        match self.operations.take_assumed_tool() {
            Some(number) => {
                self.boundary(&Event::NewStart(NewStart::Tool(ToolCall { number, ..ToolCall::default() })), to)
            }
            None => Ok(()),
        }
    }

    fn record<S: Stage>(&mut self, event: &Event<'_>, to: &mut S) -> Result<(), S::Stop> {
        self.lookahead.record(self.at, event, self.operations.between(), to)
    }

    fn boundary<S: Stage>(&mut self, event: &Event<'_>, to: &mut S) -> Result<(), S::Stop> {
        if self.settings.has_entries() {
            // LINTOL may come before the first motion.
            self.take_tolerance(self.operations.next_operation());
        }
        self.lookahead.boundary(self.at, event, to)
    }
}

/// Whether two poses are the same.
fn is_at(one: &Pose, other: &Pose) -> bool {
    (one.tip - other.tip).norm() <= SAME_POSE && (one.axis.into_inner() - other.axis.into_inner()).norm() <= SAME_POSE
}
