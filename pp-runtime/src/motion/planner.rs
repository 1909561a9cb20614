//! The planner: what to do with each event, and what must be known before it can be done.
//!
//! A start collects what the CL data says between two operations. Its safe sequence is written once the first motion
//! and the one after it are known, because the approach point depends on both; the events between these two wait in a
//! short queue. Everything else is decided motion by motion.

use std::collections::BTreeMap;
use std::io;
use std::ops::RangeInclusive;

use super::options::Policy;
use super::options::{PathNorm, Transition};
use crate::diag::{Diagnostic, Severity};
use crate::kinematics::{Machine, Pose};
use crate::program::Units;
use crate::program::{Clearance, Coolant, Event, Location, Move, Rotation, ToolCall};

use super::account::Why;
use super::arcs::Chorded;
use super::clamps::Clamps;
use super::course::{Course, Target, Towards};
use super::cutter::Cutter;
use super::expand::Expander;
use super::fault::Fault;
use super::feed::Feeds;
use super::frame::TipAbility;
use super::hole::CycleAbilities;
use super::linearise::Tolerance;
use super::place::{Place, Placer};
use super::retreat::Retreat;
use super::selection::Selection;
use super::step::Sink;
use super::tilt::PlaneAbility;
use super::times::Times;
use super::tool::{SpindleRequest, Tool};
use super::waiting::Waiting;
use super::wrap::Speller;

/// A motion of the same axis, within this angle, rad: CL data has seven digits.
pub(super) const SAME_AXIS: f64 = 1e-6;

/// Why planning stopped.
#[derive(Debug)]
pub enum Stop {
    /// The CL data cannot be posted from here on.
    Fault(Diagnostic),
    /// The output failed.
    Output(io::Error),
}

impl From<Diagnostic> for Stop {
    fn from(fault: Diagnostic) -> Self {
        Self::Fault(fault)
    }
}

impl From<io::Error> for Stop {
    fn from(error: io::Error) -> Self {
        Self::Output(error)
    }
}

pub(super) type Planned = Result<(), Stop>;

/// What a control has no code for must not be planned.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Abilities {
    /// Flood coolant.
    pub flood: bool,
    /// Mist coolant.
    pub mist: bool,
    /// Coolant through the spindle.
    pub through: bool,
    /// Air.
    pub air: bool,
    /// To call or cancel a length offset may move by the length.
    pub length_moves: bool,
    /// What the register of a length offset means.
    pub registers: Registers,
    /// What F counts along in a block in which a rotary axis moves.
    pub path_norm: PathNorm,
    /// Units of F in one unit of length of an inch program.
    pub feed_per_inch: f64,
    /// Cycles that it has.
    pub cycles: CycleAbilities,
    /// Registers of radii are one list for all tools.
    pub radius_registers: bool,
    /// Arcs are possible in the plane square to X, to Y and to Z.
    pub arc_planes: [bool; 3],
    /// By how much the distances of the ends of an arc from its centre may differ, mm.
    pub arc_radius_tolerance: f64,
    /// How it controls the tip, if it does.
    pub tip: Option<TipAbility>,
    /// How it tilts a plane, if it does.
    pub plane: Option<PlaneAbility>,
}

/// What the register of a length offset means.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Registers {
    /// One list for all tools; a tool's own has its number.
    Shared,
    /// Cutting edges of each tool, from 1.
    Edges,
    /// The row of the tool; there is no choice.
    Rows,
}

impl Registers {
    /// The register of a tool, `given` or its own; `None` if it cannot be the one that is given.
    #[must_use]
    pub fn of_tool(self, number: u32, given: Option<u32>) -> Option<u32> {
        match self {
            Self::Shared => Some(given.unwrap_or(number)),
            // CL data that counts its registers like the tools knows of no edges.
            Self::Edges => Some(given.filter(|given| *given != number).unwrap_or(1)),
            Self::Rows => Some(number).filter(|number| given.is_none_or(|given| given == *number)),
        }
    }
}

/// What was met on the way.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Statistics {
    /// Motions of the CL data that were posted.
    pub motions: u64,
    /// Motions whose tool axis lies outside the reachable set by more than arithmetic, yet within tolerance.
    pub deviations: u64,
    /// Largest of these deviations, rad.
    pub largest_deviation: f64,
    /// Safe sequences.
    pub sequences: u64,
    /// Blocks in inverse time.
    pub inverse_time: u64,
    /// Motions so near the pole that their tool axis was put there, and the first rotary kept its value.
    pub near_pole: u64,
    /// Largest angle by which one of them was turned, rad.
    pub largest_at_pole: f64,
    /// Times that the rotary axes were rewound out of the part.
    pub rewinds: u64,
    /// Blocks inserted into feed motions so that tip and tool axis stay within tolerance.
    pub inserted: u64,
    /// Holes by cycles of the control.
    pub cycles: u64,
    /// Arcs that the control traces.
    pub arcs: u64,
    /// Arcs that became chords.
    pub chorded: Chorded,
    /// Largest certified distance of the tip from its straight line in feed blocks that turn an axis, mm.
    pub largest_tip_bound: f64,
    /// Largest certified angle of the tool axis from its even turn in these blocks, rad.
    pub largest_axis_bound: f64,
}

/// Where the plan stands.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Phase {
    /// Before the first motion of an operation.
    Start,
    /// The first motion is known, the next is not.
    First {
        at: Location,
        motion: Move,
        /// Words of the rotaries, where the course says them.
        planned: Option<Target>,
        /// A new operation; else a rapid that turns the table or the head.
        operation: bool,
    },
    /// In an operation.
    Running,
}

/// Turns events into steps.
pub struct Planner<'a, M: Machine> {
    pub(super) policy: Policy<'a>,
    pub(super) placer: Placer<M>,
    pub(super) feeds: Feeds,
    pub(super) speller: Speller,
    pub(super) abilities: Abilities,
    expander: Expander,
    /// Geometry of the configuration, or of CLEARP.
    pub(super) clearance: Option<Clearance>,
    /// Every tool axis of the CL data points into the table.
    pub(super) upside_down: bool,
    pub(super) course: Course,
    /// ROTABL/NEXT for the next motion.
    pub(super) towards: Option<Towards>,
    /// Motions so far, as the course counts them.
    pub(super) counted: u64,
    pub(super) phase: Phase,
    pub(super) waiting: Waiting,
    pub(super) warnings: Vec<Diagnostic>,

    /// Where the rotaries stand or are taken to stand; held axes at their values.
    pub(super) place: Place<M::Axes>,
    /// A motion has been posted: `place` is more than a reference.
    pub(super) placed: bool,
    /// The tool stands at `place`; false after anything that may have moved the machine.
    pub(super) there: bool,
    /// The retract axis stands at its retract position.
    pub(super) clear: bool,
    pub(super) retreat: Retreat,
    /// A safety line has been written.
    pub(super) restarts: u32,

    pub(super) tool: Option<Tool>,
    /// Tools in the order in which they come into the spindle, as far as it is known.
    tools: Vec<u32>,
    /// Tool changes so far.
    pub(super) changes: usize,
    /// Tools called so far, with the length and the offset register that the CL data gave last.
    pub(super) calls: BTreeMap<u32, ToolCall>,
    /// The remark on rapids before the first tool has been made.
    passed_over: bool,
    /// The tool that the next operation begins with.
    pub(super) next_tool: Option<Tool>,
    pub(super) request: SpindleRequest,
    /// What SPINDL said in the start that is being collected.
    pub(super) request_in_start: SpindleRequest,
    /// Speed in rev/min and sense of the spindle as written; `None` if it does not turn or nobody knows.
    pub(super) spindle: Option<(f64, Rotation)>,
    /// SPINDL/OFF stood behind the last motion: written before the next, or when the tool is out of the part.
    pub(super) spindle_stop: bool,
    /// A cycle has left the spindle standing.
    pub(super) tapped: bool,
    pub(super) coolant_request: Coolant,
    /// The coolant as written; `None` if nobody knows.
    pub(super) coolant: Option<Coolant>,
    pub(super) inverse_time: bool,
    /// The control counts the tip: tip control is on, or a plane tilted.
    pub(super) framed: bool,
    /// How far feed motions may be left.
    pub(super) tolerance: Tolerance,
    /// Lowest pose of this tool axis that was cut in this operation.
    pub(super) lowest: Option<Pose>,
    pub(super) plunge_told: bool,
    pub(super) statistics: Statistics,
    pub(super) times: Times,
    pub(super) selection: Selection,
    pub(super) clamps: Clamps,
    pub(super) cutter: Cutter,
}

impl<'a, M: Machine> Planner<'a, M> {
    /// A planner at the beginning of a program that is written in `units`.
    pub fn new(machine: M, policy: Policy<'a>, units: Units, abilities: Abilities, upside_down: bool) -> Self {
        let placer = Placer::new(machine, policy, units);
        let place = placer.zero();
        let clamps = Clamps::new::<M>(policy, &placer.rotaries);
        Self {
            feeds: Feeds::new(policy, units, placer.unit_mm(), &abilities),
            speller: Speller::new::<M>(policy, &placer.rotaries, placer.scale.turn),
            policy,
            placer,
            abilities,
            expander: Expander::new(policy),
            clearance: policy.options.retract.clearance,
            upside_down: upside_down && policy.options.guards.table_check,
            course: Course::default(),
            towards: None,
            counted: 0,
            phase: Phase::Start,
            waiting: Waiting::default(),
            warnings: Vec::new(),
            place,
            placed: false,
            there: false,
            clear: false,
            retreat: Retreat::default(),
            restarts: 0,
            tool: None,
            tools: Vec::new(),
            changes: 0,
            calls: BTreeMap::new(),
            passed_over: false,
            next_tool: None,
            request: SpindleRequest::default(),
            request_in_start: SpindleRequest::default(),
            spindle: None,
            spindle_stop: false,
            tapped: false,
            coolant_request: Coolant::Off,
            coolant: None,
            inverse_time: false,
            framed: false,
            tolerance: Tolerance { tip: policy.options.tolerance, axis: policy.options.axis_tolerance_path },
            lowest: None,
            plunge_told: false,
            statistics: Statistics::default(),
            times: Times::default(),
            selection: Selection::default(),
            clamps,
            cutter: Cutter::default(),
        }
    }

    /// Follows the course that [`Navigator`](super::Navigator) has found.
    #[must_use]
    pub fn with_course(mut self, course: Course) -> Self {
        self.course = course;
        self
    }

    /// Writes these operations only, counted from 1; the sink has to be a [`Gate`](super::Gate).
    #[must_use]
    pub fn with_operations(mut self, wanted: Option<RangeInclusive<u64>>) -> Self {
        self.selection = Selection::of(wanted);
        self
    }

    /// Whether what comes first is written.
    #[must_use]
    pub fn shows(&self) -> bool {
        !self.selection.hidden()
    }

    /// Knows which tool follows which.
    #[must_use]
    pub fn with_tools(mut self, tools: Vec<u32>) -> Self {
        self.tools = tools;
        self
    }

    /// The tool that follows the one of the last change.
    pub(super) fn tool_after(&self, number: u32) -> Option<u32> {
        let known = self.tools.get(self.changes.checked_sub(1)?..)?;
        known.first().filter(|first| **first == number).and(known.get(1)).copied()
    }

    /// What was met so far.
    #[must_use]
    pub fn statistics(&self) -> Statistics {
        self.statistics
    }

    /// How long what was planned so far takes.
    #[must_use]
    pub fn times(&self) -> &Times {
        &self.times
    }

    /// Takes the remarks that have come up since the last call.
    pub fn take_warnings(&mut self) -> Vec<Diagnostic> {
        if self.selection.hidden() {
            self.warnings.clear();
        }
        std::mem::take(&mut self.warnings)
    }

    /// Whether there are remarks to take.
    #[must_use]
    #[inline]
    pub fn has_warnings(&self) -> bool {
        !self.warnings.is_empty()
    }

    /// Linear axes whose limits could not be compared: letter and why.
    #[must_use]
    pub fn unchecked_axes(&self) -> Vec<(char, &'static str)> {
        let why = |axis: &super::travel::LinearTravel| {
            if !axis.limited() {
                Some("no travel declared")
            } else if !axis.placed() {
                Some("no machine_zero")
            } else if axis.unknown_length {
                Some("gauge length unknown")
            } else {
                None
            }
        };
        self.placer.travel.axes().iter().filter_map(|axis| why(axis).map(|why| (axis.letter(), why))).collect()
    }

    /// Plans one event.
    ///
    /// # Errors
    /// [`Stop`] if it cannot be posted; nothing may be planned after that.
    #[inline]
    pub fn event(&mut self, at: Location, event: &Event<'_>, sink: &mut impl Sink) -> Planned {
        if self.selection.over {
            return Ok(());
        }
        if let Event::Move(motion) = event
            && self.expander.passes()
        {
            return self.motion(at, motion, Why::Record, sink);
        }
        self.expanded(at, event, sink)
    }

    #[cold]
    fn expanded(&mut self, at: Location, event: &Event<'_>, sink: &mut impl Sink) -> Planned {
        let mut expander = std::mem::take(&mut self.expander);
        let bears = self.bears_cutter(at, event);
        let why = if let Event::Spline(_) = event { Why::Curve } else { Why::Record };
        let done = bears.and_then(|()| {
            expander.event(at, event, &mut |at, event| match event {
                Event::Move(motion) => self.motion(at, motion, why, sink),
                Event::Arc(arc) if self.cutter.idle() => self.arc(at, arc, sink),
                Event::Arc(arc) => self.beside_arc(at, arc, sink),
                Event::Hole(hole) => self.hole(at, hole, sink),
                event => self.other(at, event, sink),
            })
        });
        self.warnings.append(&mut expander.take_warnings());
        self.tolerance.tip = expander.chord_tolerance();
        self.expander = expander;
        done
    }

    /// Ends the program behind its last event; the end code itself is left to the caller.
    ///
    /// # Errors
    /// [`Stop`] if there is no way to retract, or the output fails.
    pub fn finish(&mut self, at: Location, sink: &mut impl Sink) -> Planned {
        self.settle(None, sink)?;
        if self.selection.over {
            sink.show(true);
            sink.serve(at, Why::End);
            return self.park(at, sink);
        }
        self.ends_cutter(at)?;
        self.end(at, sink)
    }

    /// Writes what is still held back, because reading stops with an error here. No end is written.
    ///
    /// # Errors
    /// Those of the output.
    pub fn abandon(&mut self, sink: &mut impl Sink) -> io::Result<()> {
        match self.settle(None, sink) {
            Err(Stop::Output(error)) => Err(error),
            // The error that stopped the reader is the one to be told.
            Ok(()) | Err(Stop::Fault(_)) => Ok(()),
        }
    }

    fn motion(&mut self, at: Location, motion: &Move, why: Why, sink: &mut impl Sink) -> Planned {
        if self.phase == Phase::Start && self.unarmed() && motion.rapid && !self.placer.head() {
            self.pass_over(at, motion);
            return Ok(());
        }
        let number = self.counted;
        self.counted += 1;
        if self.phase == Phase::Start {
            return self.first(at, motion, number, sink);
        }
        self.settle(Some(motion), sink)?;
        sink.serve(at, why);
        match self.selection.over {
            true => Ok(()),
            false if self.cutter.idle() => self.run(at, motion, number, sink),
            false => self.beside_path(at, motion, number, sink),
        }
    }

    /// The first motion of an operation waits for the next.
    pub(super) fn first(&mut self, at: Location, motion: &Move, number: u64, sink: &mut impl Sink) -> Planned {
        sink.serve(at, Why::Record);
        if self.there && self.policy.options.rapids.transition == Transition::Direct {
            self.prepare_directly(at, motion, sink)?;
        }
        let planned = self.changes(at, motion, number, sink)?;
        self.phase = Phase::First { at, motion: *motion, planned, operation: true };
        Ok(())
    }

    /// No tool has been called yet.
    pub(super) fn unarmed(&self) -> bool {
        self.tool.is_none() && self.next_tool.is_none()
    }

    /// A rapid before the first tool: whatever is in the spindle, its length offset is not active, and Z would go deeper
    /// by that length. Nothing moves; the pose counts as FROM does.
    fn pass_over(&mut self, at: Location, motion: &Move) {
        self.from(&motion.pose);
        if !self.passed_over {
            self.passed_over = true;
            let fault = Fault::new("a rapid before the first tool is not written: no length offset is active yet")
                .help("call the tool before the first motion: LOADTL/1");
            self.warnings.push(fault.at(at, Severity::Warning));
        }
    }

    /// Writes the sequence to a first motion that has been waiting for the next, and what came between the two.
    pub(super) fn settle(&mut self, next: Option<&Move>, sink: &mut impl Sink) -> Planned {
        let Phase::First { at, motion, planned, operation } = self.phase else { return Ok(()) };
        self.phase = Phase::Running;
        if operation {
            self.request_in_start = SpindleRequest::default();
            self.lowest = None;
            self.plunge_told = false;
            self.start(at, &motion, next, planned, sink)?;
        } else {
            self.index(at, &motion, next, planned, sink)?;
        }
        if self.selection.over {
            return Ok(());
        }
        let mut waiting = std::mem::take(&mut self.waiting);
        waiting.replay(|at, event| self.other(at, event, sink))?;
        self.waiting = waiting;
        Ok(())
    }
}

pub(super) fn stop(at: Location, fault: Fault) -> Stop {
    Stop::Fault(fault.at(at, Severity::Error))
}
