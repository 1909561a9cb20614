//! The planner: items of the program become the steps of one machine.
//!
//! Decides, motion by motion and record by record, what the machine does; [`Mover`] writes the motions. Each part of
//! the state has one owner: position (in the mover), tooling, spindle, coolant, clearance geometry, course, cutter
//! compensation, and the selection of operations. A fault gets the location of its item in [`Planner::take`] and
//! nowhere else.

mod abilities;
mod arcs;
mod clamps;
mod coolant;
mod cutter;
mod feed;
mod hole;
mod lead_out;
mod machining_time;
mod mover;
pub(crate) mod obligations;
mod operation;
mod output;
mod position;
mod proof;
mod rapid;
mod records;
mod rewind;
mod selection;
mod sequence;
mod spindle;
mod statistics;
mod threads;
mod tool;
mod tooling;

use std::collections::BTreeSet;
use std::io;
use std::ops::RangeInclusive;

use crate::diag::Diagnostic;
use crate::diag::code::plan;
use crate::kinematics::{AnyMachine, Pose, Rotary};
use crate::motion::modes::{ModeFollower, StretchModes};
use crate::motion::place::UsableModes;
use crate::motion::policy::Policy;
use crate::options::StretchMode;
use crate::program::Units;
use crate::program::{self, Coolant, Location, Move};

use crate::motion::course::{Course, CourseAction, CourseChange, CourseFollower};
use crate::motion::fault::{Fault, ItemError, Planned, PlanningError};
use crate::motion::geometry::PathSegment;
use crate::motion::rotary::{RotaryTarget, RotaryWords};
use crate::motion::source::{Begins, ItemAction, LinePart, MotionIndex, Next, ProgramItem, Stage};
use crate::motion::step::{BlockReason, MAX_AXES, Sink};

pub(crate) use abilities::{Abilities, CutterRadius, OperationBlocks, Registers};
pub(crate) use clamps::MovingAxes;
pub(crate) use hole::hole_extent;
pub(crate) use machining_time::OperationTime;
pub use machining_time::Times;
pub(crate) use proof::{ProofProgram, Sweep};
pub(crate) use statistics::ChordedArcs;
pub use statistics::Statistics;
pub(crate) use threads::Threads;

use crate::motion::geometry::ClearanceGeometry;
use coolant::CoolantState;
use cutter::{CutterCompensation, CutterSite};
use feed::Feeds;
use mover::Mover;
use operation::FeedCap;
use output::{Output, OutputGuards};
use selection::Selection;
use spindle::PlannedSpindle;
use tooling::Tooling;

/// Turns the items of a program into steps.
pub struct Planner<'a, S> {
    policy: Policy<'a>,
    abilities: &'a Abilities,
    /// Every tool axis of the CL data points into the table, and `table_check` refuses that.
    upside_down: bool,
    mover: Mover<'a, S>,
    tooling: Tooling,
    spindle: PlannedSpindle,
    coolant: CoolantState,
    clearance: ClearanceGeometry,
    course: CourseFollower,
    cutter: CutterCompensation,
    selection: Selection,
    modes: ModeFollower,
    usable: UsableModes,
    /// Largest feed of the operation, where one is set.
    feed_cap: Option<FeedCap>,
    /// The operation that begins may continue from the end of the last one.
    linked: bool,
    /// An operation has begun, and not ended.
    in_operation: bool,
    /// Blocks of the shop that come before the approach to the next motion.
    at_approach: Vec<Vec<u8>>,
    /// End of the last arc in words, and distance of the tool from there in their plane, in units.
    arc_end: Option<([i64; MAX_AXES], [f64; 2])>,
    /// Name of the operation that begins, and its record, until it is known whether the tool leaves the part before.
    name_due: Option<(Location, Vec<u8>)>,
}

/// A motion, and the next one where the approach depends on it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct MotionAndNext<'m> {
    motion: &'m Move,
    next: &'m Next,
    /// Where the safe sequence ends, if it does not lead to the end of the motion: above a hole.
    above: Option<Pose>,
}

impl<'m> MotionAndNext<'m> {
    /// A motion to which a safe sequence leads as to any other.
    pub(crate) fn new(motion: &'m Move, next: &'m Next) -> Self {
        Self { motion, next, above: None }
    }
}

impl<'a, S: Sink> Planner<'a, S> {
    /// Begins a program in `units` that is written to `sink`. `upside_down`: every tool axis of the CL data points into
    /// the table.
    pub fn new(
        machine: Box<dyn AnyMachine>,
        policy: Policy<'a>,
        units: Units,
        abilities: &'a Abilities,
        upside_down: bool,
        sink: S,
    ) -> Self {
        Self {
            policy,
            abilities,
            upside_down: upside_down && policy.options.guards.table_check,
            mover: Mover::new(machine, policy, units, abilities, Output::new(sink, OutputGuards::of(abilities))),
            tooling: Tooling::default(),
            spindle: PlannedSpindle::default(),
            coolant: CoolantState::default(),
            clearance: ClearanceGeometry::new(policy.options.retract.clearance),
            course: CourseFollower::default(),
            cutter: CutterCompensation::default(),
            selection: Selection::default(),
            modes: ModeFollower::new(StretchModes::all(policy.options.mode_of_all().unwrap_or_default())),
            usable: UsableModes::default(),
            feed_cap: None,
            linked: false,
            in_operation: false,
            at_approach: Vec::new(),
            arc_end: None,
            name_due: None,
        }
    }

    /// Follows the modes that [`ModeFinder`](crate::motion::ModeFinder) has chosen among the usable ones.
    #[must_use]
    pub fn with_modes(mut self, modes: StretchModes, usable: UsableModes) -> Self {
        self.modes = ModeFollower::new(modes);
        self.usable = usable;
        self
    }

    /// Follows the course that [`Navigator`](crate::motion::Navigator) has found.
    #[must_use]
    pub fn with_course(mut self, course: Course) -> Self {
        self.course = CourseFollower::new(course);
        self
    }

    /// Writes these operations only, counted from 1.
    #[must_use]
    pub fn with_operations(mut self, wanted: Option<RangeInclusive<u64>>) -> Self {
        self.selection = Selection::of(wanted);
        self.mover.output_mut().show(self.selection.is_written());
        self
    }

    /// Sets the order of the tools, for the preselection of the next one.
    #[must_use]
    pub fn with_tools(mut self, order: Vec<u32>) -> Self {
        self.tooling.know_order(order);
        self
    }

    /// Sets the tools that cut with cutter compensation. Without them every tool may.
    #[must_use]
    pub fn with_compensated(mut self, tools: BTreeSet<u32>) -> Self {
        self.tooling.know_compensated(tools);
        self
    }

    /// Sets the result of a rehearsal of the same program, which decides where clamps are on.
    #[must_use]
    pub fn with_clamps(mut self, rehearsed: MovingAxes) -> Self {
        self.mover.set_rehearsed(rehearsed);
        self
    }

    /// Result of a rehearsal: the axes that move after each approach.
    #[must_use]
    pub fn rehearsed(self) -> MovingAxes {
        self.mover.into_rehearsed()
    }

    /// Statistics so far.
    #[must_use]
    pub fn statistics(&self) -> Statistics {
        let mut statistics = *self.mover.output().statistics();
        statistics.end_tool(self.tooling.current().and_then(|tool| tool.radius_mm));
        statistics
    }

    /// Machining times so far.
    #[must_use]
    pub fn times(&self) -> &Times {
        self.mover.output().times()
    }

    /// Threads so far.
    #[must_use]
    pub fn threads(&self) -> &Threads {
        self.mover.output().threads()
    }

    /// Takes the remarks since the last call.
    pub fn take_warnings(&mut self) -> Vec<Diagnostic> {
        self.mover.output_mut().take_remarks()
    }

    /// Whether there are remarks to take.
    #[must_use]
    #[inline]
    pub fn has_warnings(&self) -> bool {
        self.mover.output().has_remarks()
    }

    /// Linear axes whose limits could not be checked: letter and reason.
    #[must_use]
    pub fn unchecked_axes(&self) -> Vec<(char, &'static str)> {
        self.mover.placer().unchecked_axes()
    }

    /// Tools with unknown radius that cut a contour with compensation: whether they fit into it is not compared.
    #[must_use]
    pub fn unknown_radii(&self) -> &BTreeSet<u32> {
        self.cutter.unknown_radii()
    }

    /// Letter of the retract axis where its machine coordinates are unknown: whether a retract leads away from the part
    /// is not compared.
    #[must_use]
    pub fn blind_retract(&self) -> Option<char> {
        self.mover.placer().blind_retract().filter(|_| !self.abilities.retracts_along_tool)
    }

    /// Angles of the rotary axes as the control displays them, degrees. An axis whose angle is unknown is left out: one
    /// that the program has not positioned since its beginning or a stop.
    #[must_use]
    pub fn rotary_angles(&self) -> Vec<(char, f64)> {
        let (placer, position) = (self.mover.placer(), self.mover.position());
        let (written, options) = (placer.written(position.place()), self.policy.options);
        let scale = placer.scale();
        let angle = |rotary: &Rotary| {
            let letter = placer.chain()[rotary.index].letter;
            let word = match options.rotaries.wrap.get(&letter) {
                Some(wrap) => wrap.displayed(written[rotary.index], scale.units_per_turn),
                None => written[rotary.index],
            };
            (letter, scale.degrees(word))
        };
        let mut angles: Vec<(char, f64)> = placer.rotaries().iter().map(angle).collect();
        angles.retain(|(letter, _)| position.knows_rotary_axes() || options.park.contains_key(letter));
        angles
    }

    /// The sink of the steps.
    pub fn sink(&mut self) -> &mut S {
        self.mover.output_mut().sink()
    }

    /// Ends the program after its last record; the caller writes the end code.
    ///
    /// # Errors
    /// [`PlanningError`] if the tool cannot retract, or the output fails.
    pub fn finish(&mut self, at: Location) -> Result<(), PlanningError> {
        self.end(at).map_err(|halt| halt.at(at))
    }

    /// A straight motion of the CL data.
    fn line(&mut self, ahead: MotionAndNext<'_>, index: MotionIndex) -> Planned {
        match index.begins {
            Begins::Nothing if self.cutter.is_idle() => self.run(ahead, index),
            Begins::Nothing => self.compensated_line(ahead, index),
            Begins::Linked | Begins::Operation => self.begin(ahead, index),
        }
    }

    /// A line while cutter compensation is requested, in force, or about to end.
    #[cold]
    fn compensated_line(&mut self, ahead: MotionAndNext<'_>, index: MotionIndex) -> Planned {
        let from = *self.mover.here();
        let (cutter, site) = self.compensation();
        let line = cutter.line(ahead.motion, &site)?;
        if let Some(step) = cutter.switch(line, &site)? {
            self.mover.output_mut().step(&step)?;
        }
        self.run(ahead, index)?;
        let (cutter, site) = self.compensation();
        Ok(cutter.after_line(line, &from, &site)?)
    }

    /// Cutter compensation, and what it depends on.
    fn compensation(&mut self) -> (&mut CutterCompensation, CutterSite<'_>) {
        let Self { cutter, mover, tooling, abilities, policy, .. } = self;
        let site = CutterSite {
            policy: *policy,
            abilities,
            tooling,
            placer: mover.placer(),
            here: mover.here(),
            moves_zero: mover.moves_zero(),
            line: mover.output().location().line,
        };
        (cutter, site)
    }

    /// The first motion of an operation.
    fn begin(&mut self, ahead: MotionAndNext<'_>, index: MotionIndex) -> Planned {
        records::come_to_approach(self)?;
        self.linked = index.begins == Begins::Linked;
        let continues = self.continues();
        records::come_to_name(self, !continues)?;
        self.mover.output_mut().set_reason(BlockReason::Record);
        self.modes.reach(index.stretch);
        if continues {
            self.prepare_directly(ahead.motion)?;
        }
        let planned = self.apply_course_changes(ahead.motion, index)?;
        self.spindle.begin_operation();
        self.mover.position_mut().begin_operation();
        self.start(ahead, index.operation, planned)
    }

    /// Checks tool, spindle, feed and floor before the tool moves to a point of the CL data.
    fn check_state(&self, motion: &Move) -> Result<(), Fault> {
        self.check_floor(motion)?;
        if self.tooling.current().is_none() {
            self.check_without_tool(motion)?;
        }
        if self.upside_down {
            return Err(plan::TOOL_AXIS.fault("every tool axis of this program points into the table").help(
                "check whether the frame is upside down: rotate it in CAM or by `part_rotation`; `table_check = \
                     false` posts it unchanged",
            ));
        }
        if motion.rapid {
            return Ok(());
        }
        if self.spindle.running().is_none() {
            return Err(if self.spindle.is_off_requested() {
                plan::SPINDLE.fault("a feed motion with the spindle off").help(
                    "give SPINDL/ON before it for a cutting tool; a probe must not rotate: let its CL motions end in RAPID at a \
                     safe height, and the blocks of its statement in `cycles.probe` move it on, protected",
                )
            } else {
                plan::SPINDLE.fault("a feed motion without spindle speed or direction since the tool call").help(
                    "give SPINDL/RPM,..,CLW after the tool call, or `speed` and `direction` of the tool in the configuration",
                )
            });
        }
        if motion.feed.is_none() {
            return Err(plan::FEED.fault("a feed motion without feed").help(
                "give FEDRAT before it, or the feed until the first FEDRAT in the configuration: `[defaults] feed`",
            ));
        }
        Ok(())
    }

    /// Whether points of a path are compared with a floor: nothing else that [`check_state`](Self::check_state) checks
    /// depends on them.
    #[inline]
    fn has_floor(&self) -> bool {
        self.policy.options.guards.floor_mm.is_some()
    }

    /// Refuses a point below the configured floor.
    #[inline(always)]
    fn check_floor(&self, motion: &Move) -> Result<(), Fault> {
        match self.policy.options.guards.floor_mm {
            Some(floor) if motion.pose.tip.z < floor => {
                Err(below_floor(motion.pose.tip.z, floor, self.mover.placer().units()))
            }
            _ => Ok(()),
        }
    }

    fn check_without_tool(&self, motion: &Move) -> Result<(), Fault> {
        if self.mover.placer().has_rotary_head() {
            return Err(plan::TOOL.fault(
                "a motion before the first tool call: this machine has a rotary axis in the head, so axis positions depend \
                 on the tool length",
            )
            .help("call the tool first: LOADTL/1,LENGTH,120"));
        }
        if !motion.rapid {
            return Err(plan::TOOL
                .fault("a feed motion before the first tool call")
                .help("call a tool: LOADTL/1, or give it in the configuration: `[defaults] tool`"));
        }
        Ok(())
    }

    /// Feed of a motion, mm/min.
    #[inline(always)]
    fn rate(&self, feed: Option<program::Feed>) -> Result<f64, Fault> {
        let feed = feed.ok_or_else(|| plan::FEED.fault("a feed motion without feed"))?;
        let feed = Feeds::per_minute(feed, self.spindle.speed())?;
        Ok(self.feed_cap.as_ref().map_or(feed, |cap| cap.caps(feed)))
    }

    /// Feed of a thread, mm/min, which follows from its pitch.
    fn thread_feed(&self, feed: f64) -> Result<f64, Fault> {
        self.feed_cap.as_ref().map_or(Ok(()), |cap| cap.check_thread(feed, self.mover.placer().units()))?;
        Ok(feed)
    }

    /// A motion inside an operation.
    fn run(&mut self, ahead: MotionAndNext<'_>, index: MotionIndex) -> Planned {
        self.stop_spindle()?;
        self.check_state(ahead.motion)?;
        self.reach_stretch(ahead.motion, index)?;
        let planned = self.apply_course_changes(ahead.motion, index)?;
        self.go(ahead, planned)
    }

    /// A cut, after the changes of its course.
    fn cut(&mut self, motion: &Move, planned: Option<RotaryTarget>) -> Planned {
        let place = self.mover.place(&motion.pose, true, planned)?;
        let rate = self.rate(motion.feed)?;
        self.mover.position_mut().cut_to(&motion.pose);
        self.mover.feed_to(&place, rate)?;
        self.mover.arrive(&place);
        Ok(())
    }

    /// The stretch of a motion inside an operation. Where another mode begins with a cut, the safe sequence leads back
    /// to its start; a rapid leads to its own end.
    fn reach_stretch(&mut self, motion: &Move, index: MotionIndex) -> Planned {
        self.modes.reach(index.stretch);
        if self.modes.changes() && !motion.rapid { self.change_mode(motion) } else { Ok(()) }
    }

    /// Reason why the words of the program depend on tool lengths; `None` if they do not.
    fn needs_gauge_length(&self) -> Option<&'static str> {
        let modes = self.modes.modes();
        let enters = modes.has(StretchMode::Tcp) && self.abilities.enters_tip_control_by_axes();
        self.mover.placer().needs_gauge_length(modes.has(StretchMode::Axes) || enters)
    }

    /// Whether the control has arcs in the plane perpendicular to X, Y or Z here.
    fn has_arcs(&self, perpendicular: usize) -> bool {
        let vectors = self.abilities.vectors_take_arc_words && self.mover.placer().writes_vectors();
        self.abilities.arc_planes[perpendicular] && !vectors
    }

    /// A motion inside an operation, after the changes of its course.
    fn go(&mut self, ahead: MotionAndNext<'_>, planned: Option<RotaryTarget>) -> Planned {
        let motion = ahead.motion;
        if !motion.rapid {
            self.restart_after_thread()?;
            return self.cut(motion, planned);
        }
        if self.modes.changes() {
            return self.index(ahead, planned);
        }
        let place = self.mover.place(&motion.pose, false, planned)?;
        self.rapid(ahead, &place, planned)
    }

    /// Makes the course changes before a motion and returns the rotary words at its end, if the course has set them.
    #[inline(always)]
    fn apply_course_changes(&mut self, motion: &Move, index: MotionIndex) -> Result<Option<RotaryTarget>, ItemError> {
        if self.course.changes(index.motion) { self.change_course(motion, index) } else { Ok(None) }
    }

    fn change_course(&mut self, motion: &Move, index: MotionIndex) -> Result<Option<RotaryTarget>, ItemError> {
        let (from, sense, mut planned) = (self.mover.position().pose(), self.course.take_sense(), None);
        while let Some(CourseChange { action, words, .. }) = self.course.change(index.motion) {
            if !matches!(action, CourseAction::EndWith) {
                self.mover.divide_motion();
            }
            match action {
                CourseAction::EndWith => planned = Some(RotaryTarget { words, sense }),
                CourseAction::Rewind => rewind::rewind(self, motion, words)?,
                CourseAction::RotateAtPole if rewind::rotate_out_of_cut(self, motion, words)? => {}
                // The block that leaves the pole has the next tool vector, and rotates the axis.
                CourseAction::RotateAtPole if self.mover.placer().writes_vectors() => {}
                CourseAction::RotateAtPole => self.cut_to(motion, self.mover.position().pose(), words)?,
                CourseAction::SplitAt(part) => {
                    let Some(path) = PathSegment::new(&from, &motion.pose) else { continue };
                    let pose = self.mover.bend(path.at(part), &words);
                    self.cut_to(motion, pose, words)?;
                }
            }
        }
        if sense.is_some() && planned.is_none() {
            return Err(sense_refused(motion.rapid || index.begins != Begins::Nothing).into());
        }
        Ok(planned)
    }

    /// Cuts along the path of a motion to a pose that is not in the CL data.
    fn cut_to(&mut self, motion: &Move, pose: Pose, words: RotaryWords) -> Planned {
        let place = self.mover.place(&pose, true, Some(RotaryTarget { words, sense: None }))?;
        let turned = place.words != self.mover.here().words;
        self.mover.output_mut().statistics_mut().inserted += u64::from(turned);
        self.mover.output_mut().set_reason(BlockReason::Course);
        self.mover.feed_to(&place, self.rate(motion.feed)?)?;
        self.mover.pass(&pose, &place);
        self.mover.output_mut().set_reason(BlockReason::Record);
        Ok(())
    }

    /// Starts the spindle again if a thread has stopped it.
    #[inline(always)]
    fn restart_after_thread(&mut self) -> Planned {
        if self.spindle.take_stopped_by_cycle() { self.apply_spindle(true) } else { Ok(()) }
    }

    fn apply_spindle(&mut self, again: bool) -> Planned {
        self.spindle.apply(again, self.tooling.current(), self.policy, self.mover.output_mut())
    }

    #[inline]
    fn stop_spindle(&mut self) -> io::Result<()> {
        self.spindle.stop_if_pending(self.mover.output_mut())
    }

    fn request_coolant(&mut self, kind: Coolant) {
        self.coolant.request(kind, self.abilities, self.mover.output_mut());
    }

    fn apply_coolant(&mut self) -> Planned {
        self.coolant.apply(self.tooling.current(), self.policy, self.abilities, self.mover.output_mut())
    }

    fn stop_coolant(&mut self) -> io::Result<()> {
        self.coolant.stop(self.mover.output_mut())
    }
}

#[cold]
fn below_floor(tip_mm: f64, floor_mm: f64, units: Units) -> Fault {
    let [tip, floor] = [tip_mm, floor_mm].map(|mm| units.deviation(mm));
    let text = format!("the tool tip moves to Z {tip}, below `floor` = {floor}");
    plan::DEPTH.fault(text).help("correct the depth in CAM, or lower `floor`")
}

/// Fault: ROTABL/NEXT before a motion that cannot rotate in that sense. `air`: the tool is out of the part.
#[cold]
fn sense_refused(air: bool) -> Fault {
    plan::COURSE
        .fault(match air {
            true => "the sense of rotation of ROTABL/NEXT leads out of the limits of the axis",
            false => "ROTABL/NEXT comes before a cut, which cannot rotate the table the long way round",
        })
        .help("remove it, or give it before a rapid or before an operation")
}

impl<S: Sink> Stage for Planner<'_, S> {
    type Stop = PlanningError;

    /// Plans one item; nothing may be planned after an error.
    #[inline]
    fn take(&mut self, item: &ProgramItem<'_>) -> Result<(), PlanningError> {
        if self.selection.is_over() {
            return Ok(());
        }
        let at = item.at;
        let planned = match item.action {
            ItemAction::Line { motion, index, ref next, part } => {
                let why = if part == LinePart::Whole { BlockReason::Record } else { BlockReason::Curve };
                self.mover.output_mut().serve(at, why);
                self.mover.begin_motion(part == LinePart::Whole);
                let suits = if part == LinePart::CurveStart { self.cutter.check_curve() } else { Ok(()) };
                suits.map_err(ItemError::from).and_then(|()| self.line(MotionAndNext::new(motion, next), index))
            }
            ItemAction::Arc { arc, index } => {
                self.mover.output_mut().serve(at, BlockReason::Record);
                self.mover.begin_motion(false);
                arcs::arc(self, arc, index)
            }
            ItemAction::Hole { hole, index } => {
                self.mover.output_mut().serve(at, BlockReason::Hole);
                self.mover.begin_motion(false);
                hole::hole(self, hole, index)
            }
            ItemAction::Operation(start) => {
                self.mover.output_mut().serve(at, BlockReason::Record);
                operation::begin(self, start)
            }
            ItemAction::Record { event, between } => {
                self.mover.output_mut().serve(at, BlockReason::Record);
                records::record(self, event, between)
            }
        };
        planned.map_err(|halt| halt.at(at))
    }

    fn remark(&mut self, remark: Diagnostic) {
        if !self.selection.is_over() {
            self.mover.output_mut().add_remark(remark);
        }
    }
}
