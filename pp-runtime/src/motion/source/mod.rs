//! The program as it is run, one item at a time: what every pass over the CL data sees.
//!
//! ```text
//! event → setting     as the part lies on the table, `part_rotation` and the dry run's lift applied
//!       → curves      splines become chords; an arc after an interruption gets a line to its start
//!       → operations  the assumed tool called; a rapid before the first tool is FROM; motions numbered
//!       → lookahead   a first motion or a rapid waits for the motion after it
//!       → item
//! ```
//!
//! Survey, course and planner take the items of the same source, so what they count is the same. An operation begins with
//! the first motion after TOOL PATH, a tool record, or whatever leaves the position of the machine unknown. It is split
//! into stretches where the tool axis changes in the air.

mod curves;
mod lookahead;
mod operations;
mod setting;
#[cfg(test)]
mod tests;

use crate::diag::{Diagnostic, Severity};
use crate::kinematics::AnyMachine;
use crate::motion::options::Policy;
use crate::program::{Arc, Event, Hole, Location, Move, Spline, ToolCall};

use crate::motion::fault::Fault;

pub use lookahead::Next;
pub use operations::{Begins, MotionIndex};
pub(crate) use setting::Setting;

use curves::Curves;
use lookahead::Lookahead;
use operations::MotionCounter;

/// One thing that the program does, with the record of the CL data that asks for it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ProgramItem<'e> {
    /// The record.
    pub at: Location,
    /// What it does.
    pub action: ItemAction<'e>,
}

/// What an item does.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ItemAction<'e> {
    /// A straight motion.
    Line {
        /// Where to, and how fast.
        motion: &'e Move,
        /// Where in the program.
        index: MotionIndex,
        /// The motion after it, where the approach may depend on that.
        next: Next,
        /// What it is of its record.
        part: LinePart,
    },
    /// An arc; the tool is at its start.
    Arc {
        /// The arc.
        arc: &'e Arc,
        /// Where in the program.
        index: MotionIndex,
    },
    /// A hole.
    Hole {
        /// The hole.
        hole: &'e Hole,
        /// Where in the program.
        index: MotionIndex,
    },
    /// Anything that is no motion.
    Record {
        /// The record, never a motion; the tolerance is the one in force.
        event: &'e Event<'e>,
        /// It comes between two operations and speaks of the second.
        between: bool,
    },
}

/// What a straight motion is of its record.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LinePart {
    /// All of it.
    Whole,
    /// The first motion of a curve: to its start, or its first chord.
    CurveStart,
    /// A later chord of a curve.
    Chord,
}

/// Takes the items of a program.
pub trait Stage {
    /// Why it takes no more.
    type Stop: From<Diagnostic>;

    /// Takes the next item.
    ///
    /// # Errors
    /// Its own.
    fn take(&mut self, item: &ProgramItem<'_>) -> Result<(), Self::Stop>;

    /// Takes a remark on the CL data.
    fn remark(&mut self, remark: Diagnostic) {
        let _ = remark;
    }
}

/// Turns the events of the CL data into items.
#[derive(Debug, Clone)]
pub struct Source {
    setting: Setting,
    operations: MotionCounter,
    curves: Curves,
    lookahead: Lookahead,
}

impl Source {
    /// The source of a program for the machine `M`.
    #[must_use]
    pub fn new(machine: &dyn AnyMachine, policy: Policy<'_>) -> Self {
        Self {
            setting: Setting::new(policy),
            operations: MotionCounter::new(machine, policy),
            curves: Curves::new(policy),
            lookahead: Lookahead::default(),
        }
    }

    /// Hands on what an event of the CL data means.
    ///
    /// # Errors
    /// Those of the stage, and what cannot be expanded faithfully.
    #[inline]
    pub fn event<S: Stage>(&mut self, at: Location, event: &Event<'_>, to: &mut S) -> Result<(), S::Stop> {
        let Self { setting, operations, curves, lookahead } = self;
        let turned = setting.event(event);
        let event = turned.as_ref().unwrap_or(event);
        if let Event::Move(motion) = event
            && let Some(index) = operations.cut(motion)
        {
            return lookahead.line(at, motion, index, LinePart::Whole, to);
        }
        Expansion { at, operations, curves, lookahead }.event(event, to)
    }

    /// Whether the first motion of an operation waits for the next.
    #[must_use]
    pub fn awaits_second_motion(&self) -> bool {
        self.lookahead.awaits_second_motion()
    }

    /// Hands on what still waits for the next motion: there is none.
    ///
    /// # Errors
    /// Those of the stage.
    pub fn finish<S: Stage>(&mut self, to: &mut S) -> Result<(), S::Stop> {
        self.lookahead.release(Next::None, to)
    }
}

/// An event on its way through curves and operations to the look-ahead.
struct Expansion<'s> {
    at: Location,
    operations: &'s mut MotionCounter,
    curves: &'s mut Curves,
    lookahead: &'s mut Lookahead,
}

impl Expansion<'_> {
    /// The one place that decides what an event is to the passes over a program.
    #[cold]
    fn event<S: Stage>(&mut self, event: &Event<'_>, to: &mut S) -> Result<(), S::Stop> {
        match event {
            Event::Move(motion) => {
                self.call_assumed_tool(to)?;
                self.line(motion, LinePart::Whole, to)
            }
            Event::Arc(arc) => {
                self.call_assumed_tool(to)?;
                self.lead_to(Move { pose: arc.start, rapid: false, feed: arc.feed }, LinePart::Whole, to)?;
                let index = self.operations.hold(&arc.end);
                self.lookahead.arc(self.at, arc, index, to)
            }
            Event::Spline(spline) => {
                self.call_assumed_tool(to)?;
                self.curve(spline, to)
            }
            Event::Hole(hole) => {
                self.call_assumed_tool(to)?;
                let index = self.operations.hole(hole);
                self.lookahead.hole(self.at, hole, index, to)
            }
            Event::Tolerance(stated) => {
                if let Err(remark) = self.curves.state_tolerance(*stated) {
                    to.remark(remark.at(self.at, Severity::Warning));
                }
                self.record(&Event::Tolerance(Some(self.curves.tolerance())), to)
            }
            Event::Tool(_) => {
                self.operations.call_tool();
                self.boundary(event, to)
            }
            Event::Operation(_) => {
                self.operations.name();
                self.boundary(event, to)
            }
            Event::Stop
            | Event::OptionalStop
            | Event::SafeSequence
            | Event::Frame(_)
            | Event::Home
            | Event::Insert(_)
            | Event::Code { .. } => {
                self.operations.interrupt();
                self.boundary(event, to)
            }
            Event::Name(_)
            | Event::MachineName(_)
            | Event::Preselect(_)
            | Event::Spindle(_)
            | Event::Coolant(_)
            | Event::Compensation(_)
            | Event::From(_)
            | Event::ClearancePlane(_)
            | Event::Turning(_)
            | Event::Delay(_)
            | Event::Message(_) => self.record(event, to),
        }
    }

    /// A straight motion; before the first tool a rapid only says where the rotary axes count from.
    fn line<S: Stage>(&mut self, motion: &Move, part: LinePart, to: &mut S) -> Result<(), S::Stop> {
        if self.operations.passes_over(motion) {
            if self.operations.first_passed_over() {
                let remark = Fault::new("a rapid before the first tool is not written: no length offset is active yet")
                    .help("call the tool before the first motion: LOADTL/1");
                to.remark(remark.at(self.at, Severity::Warning));
            }
            return self.record(&Event::From(motion.pose), to);
        }
        let index = self.operations.line(motion);
        self.lookahead.line(self.at, motion, index, part, to)
    }

    /// A curve, chord by chord.
    fn curve<S: Stage>(&mut self, spline: &Spline<'_>, to: &mut S) -> Result<(), S::Stop> {
        let Some(start) = curves::start(spline) else { return Ok(()) };
        let led = self.lead_to(start, LinePart::CurveStart, to)?;
        let mut part = if led { LinePart::Chord } else { LinePart::CurveStart };
        let (at, tolerance) = (self.at, self.curves.tolerance());
        curves::chords(spline, tolerance, |motion| match motion {
            Ok(motion) => self.line(&motion, std::mem::replace(&mut part, LinePart::Chord), to),
            Err(fault) => {
                self.lookahead.release(Next::None, to)?;
                Err(fault.at(at, Severity::Error).into())
            }
        })
    }

    /// After a tool change or a stop the tool first comes back to where the path goes on; whether it does.
    fn lead_to<S: Stage>(&mut self, start: Move, part: LinePart, to: &mut S) -> Result<bool, S::Stop> {
        let leads = self.operations.between();
        if leads {
            self.line(&start, part, to)?;
        }
        Ok(leads)
    }

    /// Calls the tool of the configuration before the first motion of a program that calls none.
    fn call_assumed_tool<S: Stage>(&mut self, to: &mut S) -> Result<(), S::Stop> {
        match self.operations.take_assumed_tool() {
            Some(number) => self.boundary(&Event::Tool(ToolCall { number, ..ToolCall::default() }), to),
            None => Ok(()),
        }
    }

    fn record<S: Stage>(&mut self, event: &Event<'_>, to: &mut S) -> Result<(), S::Stop> {
        self.lookahead.record(self.at, event, self.operations.between(), to)
    }

    fn boundary<S: Stage>(&mut self, event: &Event<'_>, to: &mut S) -> Result<(), S::Stop> {
        self.lookahead.boundary(self.at, event, to)
    }
}
