//! The course of the rotary axes: branch, whole turns and free angles, for a whole program at once.
//!
//! If the nearest solution is taken pose by pose, an axis may reach its limit in the middle of a cut. The navigator
//! takes the first pass over the program and finds the best course by exact dynamic programming over branches × whole
//! turns × the free angle at the pole. A motion in the air may lead from every state to every other. A cut connects two
//! states if the axes move continuously between them; where no course is continuous, the tool leaves the part, the axes
//! rewind, and the tool returns to the same pose.
//!
//! The best course has, in this order: the fewest rewinds; starts as the user prefers them; the least time at the
//! largest axis speeds; the least travel of the rotary axes. Of equals the first branch is taken before the second, the
//! turn nearest to zero before others, positive before negative, and a rewind as early as possible.
//!
//! Memory: survivors share their history, and a course is a list of changes: the motions at which it differs from the
//! smallest rotation on the same branch.

mod packed;
mod search;
mod states;
mod steady;

#[cfg(test)]
mod tests;

use std::collections::BTreeMap;

use nalgebra::UnitVector3;

use crate::diag::code::plan;
use crate::diag::{Diagnostic, Severity};
use crate::kinematics::math::smaller;
use crate::kinematics::{AnyMachine, Branch, Pose};
use crate::motion::policy::Policy;
use crate::options::{Mode, Singular, StretchMode};
use crate::program::Units;
use crate::program::{Event, Location, MachineFunction, NewStart, ReferenceGeometry};

use crate::motion::geometry::PathSegment;
use crate::motion::place::{Placer, UsableModes};
use crate::motion::rotary::{Cost, RotaryWords, RotationSense};
use crate::motion::source::{Begins, ItemAction, MotionIndex, ProgramItem, Stage};
use crate::shortcut::Shortcut;

use packed::PackedChanges;
use search::{CourseSearch, RotaryState};
use states::{CutEnd, StateFinder, TestedCuts, chord};
use steady::SteadyRun;

/// Largest number of points at which one block is split, at poles and at limits.
const MAX_CROSSINGS: u32 = 16;

/// Action of the planner at a change.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum CourseAction {
    /// The motion ends with these words.
    EndWith,
    /// The motion first runs to this fraction of its path, with these words.
    SplitAt(f64),
    /// Before the motion the free rotary axis rotates at the pole, with the tool in place.
    RotateAtPole,
    /// Before the motion the tool leaves the part, and returns with these words.
    Rewind,
}

/// A difference from the smallest rotation on the same branch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct CourseChange {
    /// Number of the motion, as counted by the source.
    pub(crate) motion: u64,
    pub(crate) action: CourseAction,
    pub(crate) words: RotaryWords,
}

/// The decisions for a program, in the order of its motions.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Course {
    changes: PackedChanges,
    next: Option<CourseChange>,
    /// Cost of the course.
    pub cost: Cost,
    /// Cost of planning motion by motion, without look-ahead; `None` if that ends at a limit.
    pub greedy: Option<Cost>,
}

impl Course {
    /// The next change of a motion.
    #[inline]
    pub(crate) fn change(&mut self, motion: u64) -> Option<CourseChange> {
        let change = self.next.filter(|change| change.motion == motion)?;
        self.next = self.changes.next();
        Some(change)
    }
}

/// Reads a course while the program is planned.
#[derive(Debug, Clone, Default)]
pub(crate) struct CourseFollower {
    course: Course,
    /// ROTABL/NEXT for the next motion.
    sense: Option<RotationSense>,
}

impl CourseFollower {
    pub(crate) fn new(course: Course) -> Self {
        Self { course, sense: None }
    }

    /// Takes ROTABL.
    pub(crate) fn set_sense(&mut self, sense: Option<RotationSense>) {
        self.sense = sense;
    }

    /// ROTABL/NEXT for this motion.
    #[inline]
    pub(crate) fn take_sense(&mut self) -> Option<RotationSense> {
        self.sense.take()
    }

    /// Whether there is anything to do before a motion, or a sense of its rotation.
    #[inline]
    pub(crate) fn changes(&self, motion: u64) -> bool {
        self.sense.is_some() || self.course.next.is_some_and(|change| change.motion == motion)
    }

    /// The next change of a motion.
    #[inline]
    pub(crate) fn change(&mut self, motion: u64) -> Option<CourseChange> {
        self.course.change(motion)
    }
}

/// One of the two searches: with look-ahead, and motion by motion.
#[derive(Debug)]
struct SearchRun {
    search: CourseSearch,
    /// The search has reached a motion that it cannot make.
    ended: bool,
}

/// Motion before a run.
#[derive(Debug, Clone, Copy, PartialEq)]
enum RunStart {
    /// Every state has been reached, in any sense of rotation.
    InAir,
    /// Both searches have followed it.
    AfterCut,
}

/// Finds the course in the first pass.
#[derive(Debug)]
pub struct Navigator {
    finder: StateFinder,
    greedy: bool,
    prefer: Option<(char, bool)>,
    /// Angles at which GOHOME parks the axes.
    park: BTreeMap<char, f64>,
    start_branch: Option<Branch>,
    searches: [SearchRun; 2],
    /// The run of cuts since the last motion that both searches have taken.
    run: Option<SteadyRun>,
    /// A run can begin with the next cut.
    run_start: Option<RunStart>,
    /// Angle of a free first rotary axis in operations without one of their own.
    singular: Singular,
    /// Mode of operations without one of their own.
    mode: Mode,
    /// Control and machine have tip control.
    has_tip_control: bool,
    /// Number of the present motion.
    motion: u64,
    /// Pose at the end of the last motion.
    here: Option<Pose>,
    /// The pole to which the tool axis is parallel.
    pole: Option<UnitVector3<f64>>,
    /// A motion has come: FROM has no effect any more.
    has_moved: bool,
    /// ROTABL/NEXT.
    sense: Option<RotationSense>,
    states: Vec<RotaryState>,
    /// Words near which turns are tried if an axis has too many turns to try all.
    near: Vec<RotaryWords>,
    /// Words of the second rotary axis at a pole.
    second_words: Vec<i64>,
    /// Cuts to the present pose.
    tested: TestedCuts,
}

impl Navigator {
    /// A navigator for one program.
    #[must_use]
    pub fn new(machine: Box<dyn AnyMachine>, policy: Policy<'_>) -> Self {
        let placer = Placer::new(machine, policy, Units::Millimetres);
        let free = placer.rotaries().first().filter(|_| placer.rotaries().len() == 2).copied();
        let zeroes = policy.options.singular == Singular::Zero;
        let run = |greedy| {
            let mut search = CourseSearch::new(*placer.metric(), free, zeroes, greedy);
            if greedy != policy.options.course.greedy {
                search.forget_changes();
            }
            SearchRun { search, ended: false }
        };
        Self {
            searches: [run(false), run(true)],
            run: None,
            run_start: None,
            singular: policy.options.singular,
            mode: policy.options.mode,
            has_tip_control: false,
            finder: StateFinder::new(placer),
            greedy: policy.options.course.greedy,
            prefer: policy.options.course.prefer,
            park: policy.options.park.clone(),
            start_branch: policy.options.course.start_branch,
            motion: 0,
            here: None,
            pole: None,
            has_moved: false,
            sense: None,
            states: Vec::new(),
            near: Vec::new(),
            second_words: Vec::new(),
            tested: TestedCuts::default(),
        }
    }

    /// The same navigator for a program with the usable modes: where tool vectors are written, the control finds the
    /// rotary angles.
    #[must_use]
    pub fn with_modes(mut self, usable: &UsableModes) -> Self {
        self.has_tip_control = usable.tip;
        self.set_mode(self.mode);
        self
    }

    /// Sets the mode of the motions that come. Mode `auto` has tip control where the tool axis rotates at feed.
    fn set_mode(&mut self, mode: Mode) {
        let tip = self.has_tip_control && mode.of_all().is_none_or(|mode| mode == StretchMode::Tcp);
        let by_control = self.finder.lead_through_poles(tip);
        self.searches.iter_mut().for_each(|run| run.search.set_by_control(by_control));
    }

    fn record(&mut self, event: &Event<'_>) {
        match event {
            Event::Reference(ReferenceGeometry::From(pose)) => self.count_from(pose),
            Event::NewStart(NewStart::Home) => {
                self.end_run();
                self.go_home();
            }
            Event::Function(MachineFunction::RotaryDirection(turning)) => {
                self.sense = self.finder.placer().rotation_sense(*turning)
            }
            Event::Motion(_)
            | Event::NewStart(_)
            | Event::Interruption(_)
            | Event::Function(_)
            | Event::Reference(_)
            | Event::Text(..) => {}
        }
    }

    /// Takes a motion; `air`: the tool is out of the part. Returns whether the searches have taken it.
    #[inline(always)]
    fn move_to(&mut self, end: &Pose, index: MotionIndex, air: bool) -> bool {
        self.has_moved = true;
        self.motion = index.motion;
        let searched = self.go(end, air, index.begins == Begins::Operation);
        self.sense = None;
        searched
    }

    /// Parks the rotary axes at the configured angles; the planner reports an angle outside the limits.
    fn go_home(&mut self) {
        let (placer, park) = (self.finder.placer(), &self.park);
        let Ok((_, 1..)) = placer.parked(park, &placer.zero()) else { return };
        self.has_moved = true;
        let parked = |words: &RotaryWords| {
            let position = placer.parked(park, &placer.position_at_words(words));
            position.map_or(*words, |(place, _)| placer.rotary_words_of(&place.words))
        };
        self.searches.iter_mut().for_each(|run| run.search.park(parked));
    }

    /// Takes FROM: sets the start angles of the rotary axes unless a motion has come before.
    fn count_from(&mut self, pose: &Pose) {
        if self.has_moved {
            return;
        }
        let from = self.finder.placer().position_at_words(&self.searches[0].search.words());
        if let Some(place) = self.finder.placer().reference(pose, &from) {
            let words = self.finder.placer().rotary_words_of(&place.words);
            self.searches.iter_mut().for_each(|run| run.search.restart(words));
        }
    }

    /// Takes a motion; returns whether the searches have taken it, and not a run.
    #[inline(always)]
    fn go(&mut self, pose: &Pose, air: bool, begins: bool) -> bool {
        let follows = match air {
            false => self.stays(pose) || self.goes_on(pose),
            true => !begins && self.rests_at_pole() && self.stays(pose),
        };
        if !follows {
            self.search(pose, air, begins);
        }
        !follows
    }

    /// Takes a motion in both searches.
    fn search(&mut self, pose: &Pose, air: bool, begins: bool) {
        self.end_run();
        if self.searches[0].ended {
            return;
        }
        let pole = self.finder.placer().pole(&pose.axis);
        let pose = Pose { axis: pole.unwrap_or(pose.axis), ..*pose };
        self.near.clear();
        if self.finder.placer().has_many_turns() {
            self.searches.iter().for_each(|run| run.search.near(air, &mut self.near));
        }
        match pole {
            Some(_) => self.finder.second_words(&pose, &mut self.second_words),
            None => self.finder.states(&pose, &self.near, &mut self.states),
        }
        let reached = if pole.is_some() { !self.second_words.is_empty() } else { !self.states.is_empty() };
        if !reached {
            self.searches.iter_mut().for_each(|run| run.ended = true);
            return;
        }
        self.tested.clear();
        let steady = !air && pole.is_none() && self.is_away_from_poles(&pose) && !self.is_near_limit(&pose);
        let mut followed = steady;
        for run in 0..self.searches.len() {
            if self.searches[run].ended || steady && self.searches[run].search.follow(self.motion, &self.states) {
                continue;
            }
            followed = false;
            if !self.step(run, &pose, pole.as_ref(), air, begins) {
                self.searches[run].ended = true;
            }
        }
        self.here = Some(pose);
        self.pole = pole;
        self.run_start = match air {
            _ if self.searches[0].ended => None,
            true => (pole.is_none() && self.sense.is_none()).then_some(RunStart::InAir),
            false => followed.then_some(RunStart::AfterCut),
        };
    }

    /// Whether a further motion in the air to the pole of the last one changes nothing in either search.
    fn rests_at_pole(&self) -> bool {
        self.pole.is_some()
            && self.sense.is_none()
            && self.second_words.len() == 1
            && self.searches.iter().all(|run| run.ended || run.search.is_free_at_pole())
    }

    /// Takes a motion with the tool axis of the last pose, at a pole or in a run: it rotates nothing. False for any
    /// other.
    #[inline]
    fn stays(&mut self, pose: &Pose) -> bool {
        let is_held = |here: &&mut Pose| Shortcut::HeldToolAxis.is_on() && here.axis == pose.axis;
        let Some(here) = self.here.as_mut().filter(is_held) else { return false };
        if let Some(run) = &mut self.run {
            if run.awaits_comparison() {
                compare_rewinds(&mut self.searches, self.motion, run);
            }
        } else if self.pole.is_none() {
            return false;
        }
        here.tip = pose.tip;
        true
    }

    /// Takes a cut that belongs to the run, or with which one begins; false for any other.
    #[inline(always)]
    fn goes_on(&mut self, pose: &Pose) -> bool {
        let Some(run) = &mut self.run else { return self.begins_run(pose) };
        let Some(from) = &mut self.here else { return false };
        let finder = &self.finder;
        let chord = chord(from, pose);
        let follows = finder.passes_far_from_poles(chord, &pose.axis)
            && takes(run, &mut self.searches, finder, self.motion, RunCut { pose, chord });
        if follows {
            *from = *pose;
        }
        follows
    }

    /// Takes the first cut of a run, where one can begin; false if none does.
    fn begins_run(&mut self, pose: &Pose) -> bool {
        let (Some(start), Some(from), true) = (self.run_start.take(), self.here, Shortcut::SteadyRuns.is_on()) else {
            return false;
        };
        let chord = chord(&from, pose);
        if !self.finder.passes_far_from_poles(chord, &pose.axis) {
            return false;
        }
        let placer = self.finder.placer();
        let compares = !placer.has_many_turns();
        let begins = |run: &mut SearchRun| run.ended || run.search.begin_run(compares);
        if placer.has_indexed_axes() || !self.searches.iter_mut().all(begins) {
            return false;
        }
        let solutions = placer.machine().rotary_axes(&from.axis, placer.held());
        // Where two branches are one, they may become two again.
        if solutions.len() != placer.rotaries().len().clamp(1, 2) {
            return false;
        }
        let compares = self.searches.iter().any(|run| !run.ended && run.search.compares_rewinds());
        let mut run = SteadyRun::begin(&solutions, placer.rotaries(), placer.scale(), compares);
        let same_turns = || run.tries_same_turns(&placer.machine().rotary_axes(&pose.axis, placer.held()));
        let begins = (start == RunStart::AfterCut || !placer.has_many_turns() || same_turns())
            && takes(&mut run, &mut self.searches, &self.finder, self.motion, RunCut { pose, chord });
        if begins {
            (self.run, self.here) = (Some(run), Some(*pose));
        }
        begins
    }

    /// Lets both searches take the cuts of the run.
    fn end_run(&mut self) {
        self.run_start = None;
        let (Some(run), Some(here)) = (self.run.take(), self.here) else { return };
        let mut searches: Vec<_> =
            self.searches.iter_mut().filter(|run| !run.ended).map(|run| &mut run.search).collect();
        searches.iter_mut().for_each(|search| search.rotate(|state| run.rotated(state)));
        self.near.clear();
        if self.finder.placer().has_many_turns() {
            self.near.extend(searches.iter().flat_map(|search| search.states()).map(|state| state.words));
        }
        self.finder.states(&here, &self.near, &mut self.states);
        searches.iter_mut().for_each(|search| search.enter(&self.states));
    }

    /// Whether a cut from the last pose to this one passes no pole.
    fn is_away_from_poles(&self, pose: &Pose) -> bool {
        let Some(from) = self.here.filter(|_| self.pole.is_none()) else { return false };
        self.finder.pole_between(&from, pose).is_none()
    }

    /// Whether a cut from the last pose to this one could exceed a limit between its ends.
    fn is_near_limit(&self, pose: &Pose) -> bool {
        self.here.is_some_and(|from| self.finder.is_near_limit(&from, pose, &self.states))
    }

    /// Takes one motion in one search. `pole`: where the tool axis is at it. Returns false if no state of the pose can
    /// be reached.
    fn step(&mut self, run: usize, pose: &Pose, pole: Option<&UnitVector3<f64>>, air: bool, begins: bool) -> bool {
        let motion = self.motion;
        let (finder, search) = (&self.finder, &mut self.searches[run].search);
        let from = self.here.filter(|_| !air);
        let is_preferred = |state: &RotaryState| {
            let preferred = self.prefer.is_none_or(|(letter, positive)| {
                let mut rotaries = finder.placer().rotaries().iter();
                let axis = rotaries.position(|rotary| finder.placer().chain()[rotary.index].letter == letter);
                axis.is_none_or(|axis| if positive { state.words[axis] >= 0 } else { state.words[axis] <= 0 })
            });
            preferred && self.start_branch.is_none_or(|branch| branch == state.branch)
        };
        match (from, pole) {
            (None, None) => search.free(motion, &self.states, self.sense, is_preferred),
            (None, Some(_)) => {
                let Some(first) = finder.placer().rotaries().first() else { return false };
                search.free_to_pole(motion, begins, *first, &self.second_words, self.sense);
                true
            }
            (Some(_), Some(_)) if self.pole.is_some() => true,
            (Some(from), Some(pole)) => {
                search.cut_to_pole(motion, None, |state| finder.at_pole(pole, &from.axis, state))
            }
            (Some(_), None) if let Some(pole) = self.pole => {
                let exits = finder.exits(&pole, &pose.axis, &self.states);
                search.leave_pole(motion, &self.states, &exits, is_preferred)
            }
            (Some(from), None) => match finder.pole_between(&from, pose) {
                Some((part, pole)) => {
                    let exits = finder.exits(&pole, &pose.axis, &self.states);
                    search.cut_to_pole(motion, Some(part), |state| finder.at_pole(&pole, &from.axis, state))
                        && search.leave_pole(motion, &self.states, &exits, is_preferred)
                }
                None => cut(finder, search, motion, [&from, pose], &self.states, &mut self.tested),
            },
        }
    }

    /// Returns the course, and the cost of planning without look-ahead.
    #[must_use]
    pub fn finish(mut self) -> Course {
        self.end_run();
        let [best, greedy] = self.searches.map(|run| (run.ended, run.search.finish()));
        let (ended, motion_by_motion) = (greedy.0, greedy.1.0);
        let (cost, changes) = if self.greedy { greedy.1 } else { best.1 };
        let mut changes = changes.read_from_start();
        Course { next: changes.next(), changes, cost, greedy: (!ended).then_some(motion_by_motion) }
    }
}

/// A cut that may belong to a run: far from the poles.
#[derive(Clone, Copy)]
struct RunCut<'p> {
    /// Pose at its end.
    pose: &'p Pose,
    /// Square of the distance between the tool axes of its ends.
    chord: f64,
}

/// A pose on a path.
#[derive(Clone, Copy)]
struct PoseOnPath<'p> {
    pose: &'p Pose,
    /// Share of the path up to the pose, 0 to 1.
    share: f64,
}

/// Whether a run, and the searches in it, take a cut.
#[inline(always)]
fn takes(
    run: &mut SteadyRun,
    searches: &mut [SearchRun],
    finder: &StateFinder,
    motion: u64,
    RunCut { pose, chord }: RunCut<'_>,
) -> bool {
    let placer = finder.placer();
    let solutions = placer.machine().rotary_axes(&pose.axis, placer.held());
    let reach = if run.is_limited() { finder.reach_along(chord) } else { 0.0 };
    let Some(rotations) = run.rotations(&solutions, reach) else { return false };
    if run.awaits_comparison() {
        compare_rewinds(searches, motion, run);
    }
    run.take(rotations, placer.metric());
    true
}

/// Lets the searches look for rewinds before a motion of a run.
#[inline(never)]
fn compare_rewinds(searches: &mut [SearchRun], motion: u64, run: &mut SteadyRun) {
    let running = searches.iter_mut().filter(|run| !run.ended);
    let least = running.map(|known| known.search.compare_rewinds(motion, |state| run.rotated(state)));
    run.compared(least.fold(f64::INFINITY, smaller));
}

impl Stage for Navigator {
    type Stop = Diagnostic;

    /// Follows one item; refused is a course of more changes than memory is given for.
    #[inline(always)]
    fn take(&mut self, item: &ProgramItem<'_>) -> Result<(), Diagnostic> {
        let searched = match item.action {
            ItemAction::Line { motion, index, .. } => {
                let begins = index.begins == Begins::Operation;
                self.move_to(&motion.pose, index, begins || motion.rapid)
            }
            _ => {
                self.take_other(item);
                true
            }
        };
        if searched && self.is_too_long() { Err(too_long(item.at)) } else { Ok(()) }
    }
}

impl Navigator {
    fn is_too_long(&self) -> bool {
        self.searches.iter().any(|run| run.search.is_too_long())
    }

    /// Follows any item that is no straight motion.
    fn take_other(&mut self, item: &ProgramItem<'_>) {
        match item.action {
            ItemAction::Line { .. } => {}
            // The tool is at its start.
            ItemAction::Arc { arc, index } => {
                self.move_to(&arc.end, index, false);
            }
            // A rapid leads to the hole.
            ItemAction::Hole { hole, index } => {
                self.move_to(&hole.top, index, true);
            }
            ItemAction::Operation(start) => {
                self.end_run();
                let singular = start.chosen.singular.map_or(self.singular, |singular| singular.value);
                self.searches.iter_mut().for_each(|run| run.search.set_zeroes(singular == Singular::Zero));
                self.set_mode(start.chosen.mode.map_or(self.mode, |mode| mode.value));
            }
            ItemAction::Record { event, .. } => self.record(event),
        }
    }
}

#[cold]
fn too_long(at: Location) -> Diagnostic {
    plan::COURSE
        .fault("up to here the rotary axes change their course too often for one program")
        .help("post the CL data in parts, or keep the tool axis on one side of the pole")
        .at(at, Severity::Error)
}

/// Takes a cut between two poses away from the pole. If no state is continuous over the whole cut, the cut is split: at
/// the point nearest to a pole that it passes, where an axis may rotate by more than 180°, and where a state reaches a
/// limit.
fn cut(
    finder: &StateFinder,
    search: &mut CourseSearch,
    motion: u64,
    [from, to]: [&Pose; 2],
    states: &[RotaryState],
    tested: &mut TestedCuts,
) -> bool {
    // Between opposite tool axes the path is undefined, and is not split.
    let segment = PathSegment::new(from, to);
    let (mut here, mut done) = (*from, 0.0);
    let mut passing = finder.placer().passing(&from.axis, &to.axis).map(|(part, ..)| part);
    let (mut near, mut split) = (Vec::new(), Vec::new());
    for _ in 0..MAX_CROSSINGS {
        let merged = finder.merged(to, states) || finder.merged(&here, search.layer());
        tested.begin_at(done);
        if search.cut(motion, states, None, |a, b| {
            let (start, end) = (CutEnd { pose: &here, state: a }, CutEnd { pose: to, state: b });
            finder.connected(start, end, merged, tested)
        }) {
            return true;
        }
        let Some(segment) = &segment else { return false };
        near.clear();
        if finder.placer().has_many_turns() {
            search.near(false, &mut near);
        }
        let mut split_at = |search: &mut CourseSearch, part: f64| {
            let pose = segment.at(part);
            finder.states(&pose, &near, &mut split);
            // No other search asks for cuts to this pose.
            let mut tested = TestedCuts::default();
            let mut connected = |a: &RotaryState, b: &RotaryState| {
                let (start, end) = (CutEnd { pose: &here, state: a }, CutEnd { pose: &pose, state: b });
                finder.connected(start, end, false, &mut tested)
            };
            let reached = search.cut(motion, &split, Some(part), &mut connected);
            reached.then_some(pose)
        };
        if let Some(part) = passing.filter(|part| *part > done)
            && let Some(pose) = split_at(search, part)
        {
            (here, done, passing) = (pose, part, None);
            continue;
        }
        let Some(part) = crossing(finder, search, segment, PoseOnPath { pose: &here, share: done }, &near) else {
            return false;
        };
        let Some(pose) = split_at(search, part) else { return false };
        (here, done) = (pose, part);
    }
    false
}

/// First fraction of the path, after `from`, at which a state of the last layer reaches a limit while another turn is
/// inside the limits.
fn crossing(
    finder: &StateFinder,
    search: &CourseSearch,
    segment: &PathSegment,
    from: PoseOnPath<'_>,
    near: &[RotaryWords],
) -> Option<f64> {
    let mut split = Vec::new();
    let mut first: Option<f64> = None;
    for state in search.layer() {
        let runs = |part: f64| finder.continued(&segment.at(part), state);
        if !finder.continued(from.pose, state).is_some_and(|words| finder.inside(&words)) {
            continue;
        }
        let (mut inside, mut outside) = (from.share, 1.0);
        for _ in 0..60 {
            let middle = 0.5 * (inside + outside);
            match runs(middle) {
                Some(words) if finder.inside(&words) => inside = middle,
                _ => outside = middle,
            }
        }
        if inside <= from.share || first.is_some_and(|first| first <= inside) {
            continue;
        }
        finder.states(&segment.at(inside), near, &mut split);
        if split.len() > 1 {
            first = Some(inside);
        }
    }
    first
}
