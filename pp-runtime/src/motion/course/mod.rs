//! The course of the rotary axes: branch, whole turns and free values, for a whole program at once.
//!
//! Pose by pose the nearest answer may run into a limit in the middle of a cut. The navigator sees the first pass and
//! finds the best course by exact dynamic programming over branches × whole turns × the free axis at the pole. A motion in
//! the air may go from every state to every other. A cut goes where the axes run through; where no course runs through,
//! the tool leaves the part, the axes rewind, and it comes back to the same pose.
//!
//! What is best, in this order: the fewest rewinds; starts as the user prefers them; the least time at the largest axis
//! speeds; the least travel of the rotary axes. Of equals the first branch is taken before the second, the turn nearest to
//! zero before others, positive before negative, and a rewind as early as it can be.
//!
//! Memory: survivors share their history, and only what is not expected is remembered: a course is a list of changes.

mod packed;
mod search;
mod states;

#[cfg(test)]
mod tests;

use std::collections::BTreeMap;

use nalgebra::UnitVector3;

use crate::diag::Diagnostic;
use crate::kinematics::{AnyMachine, Branch, Pose};
use crate::motion::options::Policy;
use crate::program::Event;
use crate::program::Units;

use crate::motion::geometry::PathSegment;
use crate::motion::place::Placer;
use crate::motion::rotary::{Cost, RotaryWords, RotationSense};
use crate::motion::source::{Begins, ItemAction, MotionIndex, ProgramItem, Stage};

use packed::PackedChanges;
use search::{CourseSearch, RotaryState};
use states::StateFinder;

/// A limit is crossed at most this often in one block.
const MAX_CROSSINGS: u32 = 16;

/// What the planner does at a change.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum CourseAction {
    /// The motion ends with these words.
    EndWith,
    /// The motion first goes to this part of its way, with these words.
    SplitAt(f64),
    /// Before the motion the free rotary turns where it stands, at the pole.
    RotateAtPole,
    /// Before the motion the tool leaves the part, and comes back with these words.
    Rewind,
}

/// Something that the least turn on the same branch would not do.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct CourseChange {
    /// The motion, as the source counts them.
    pub(crate) motion: u64,
    pub(crate) action: CourseAction,
    pub(crate) words: RotaryWords,
}

/// The decisions for a program, in the order of its motions.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Course {
    changes: PackedChanges,
    next: Option<CourseChange>,
    /// What the course costs.
    pub cost: Cost,
    /// What it costs pose by pose, without looking ahead; `None` where that way ends before a limit.
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

/// The course while it is followed.
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

    /// ROTABL.
    pub(crate) fn set_sense(&mut self, sense: Option<RotationSense>) {
        self.sense = sense;
    }

    /// ROTABL/NEXT for the motion at hand.
    #[inline]
    pub(crate) fn take_sense(&mut self) -> Option<RotationSense> {
        self.sense.take()
    }

    /// The next change of a motion.
    #[inline]
    pub(crate) fn change(&mut self, motion: u64) -> Option<CourseChange> {
        self.course.change(motion)
    }
}

/// One of the two searches: with a view ahead, and without.
#[derive(Debug)]
struct SearchRun {
    search: CourseSearch,
    /// It has come to a motion that it cannot make.
    ended: bool,
}

/// Finds the course in the first pass.
#[derive(Debug)]
pub struct Navigator {
    finder: StateFinder,
    greedy: bool,
    prefer: Option<(char, bool)>,
    /// Where GOHOME takes the axes.
    park: BTreeMap<char, f64>,
    start_branch: Option<Branch>,
    searches: [SearchRun; 2],
    /// The number of the motion at hand.
    motion: u64,
    here: Option<Pose>,
    /// The pole at which the tool axis stands.
    pole: Option<UnitVector3<f64>>,
    /// Something has been reached: FROM no longer counts.
    placed: bool,
    /// ROTABL/NEXT.
    sense: Option<RotationSense>,
    states: Vec<RotaryState>,
    /// Words near which turns are looked at where there are too many to look at all.
    near: Vec<RotaryWords>,
    second: Vec<i64>,
}

impl Navigator {
    /// A navigator for one program.
    #[must_use]
    pub fn new(machine: Box<dyn AnyMachine>, policy: Policy<'_>) -> Self {
        let placer = Placer::new(machine, policy, Units::Millimetres);
        let run = |greedy| SearchRun { search: CourseSearch::new(placer.metric(), [0; 2], greedy), ended: false };
        Self {
            searches: [run(false), run(true)],
            finder: StateFinder::new(placer),
            greedy: policy.options.course.greedy,
            prefer: policy.options.course.prefer,
            park: policy.options.park.clone(),
            start_branch: policy.options.course.start_branch,
            motion: 0,
            here: None,
            pole: None,
            placed: false,
            sense: None,
            states: Vec::new(),
            near: Vec::new(),
            second: Vec::new(),
        }
    }

    fn record(&mut self, event: &Event<'_>) {
        match event {
            Event::From(pose) => self.count_from(pose),
            Event::Home => self.go_home(),
            Event::Turning(turning) => self.sense = self.finder.placer().rotation_sense(*turning),
            Event::Name(_)
            | Event::MachineName(_)
            | Event::Operation(_)
            | Event::SafeSequence
            | Event::Frame(_)
            | Event::Tool(_)
            | Event::Preselect(_)
            | Event::Spindle(_)
            | Event::Coolant(_)
            | Event::Compensation(_)
            | Event::Move(_)
            | Event::Arc(_)
            | Event::Spline(_)
            | Event::Hole(_)
            | Event::ClearancePlane(_)
            | Event::Tolerance(_)
            | Event::Delay(_)
            | Event::OptionalStop
            | Event::Stop
            | Event::Message(_)
            | Event::Insert(_)
            | Event::Code { .. } => {}
        }
    }

    /// A motion; `air`: the tool is out of the part.
    fn move_to(&mut self, end: &Pose, index: MotionIndex, air: bool) {
        self.placed = true;
        self.motion = index.motion;
        self.go(end, air, index.begins == Begins::Operation);
        self.sense = None;
    }

    /// The rotaries are parked where the configuration wants it; an angle out of reach is told by the planner.
    fn go_home(&mut self) {
        let (placer, park) = (self.finder.placer(), &self.park);
        let Ok((_, 1..)) = placer.parked(park, &placer.zero()) else { return };
        self.placed = true;
        let parked = |words: &RotaryWords| {
            let there = placer.parked(park, &placer.position_at_words(words));
            there.map_or(*words, |(place, _)| placer.rotary_words_of(&place.words))
        };
        self.searches.iter_mut().for_each(|run| run.search.park(parked));
    }

    /// Where the rotaries count from as long as nothing has moved.
    fn count_from(&mut self, pose: &Pose) {
        if self.placed {
            return;
        }
        let from = self.finder.placer().position_at_words(&self.searches[0].search.words());
        if let Some(place) = self.finder.placer().reference(pose, &from) {
            let words = self.finder.placer().rotary_words_of(&place.words);
            self.searches.iter_mut().for_each(|run| run.search.restart(words));
        }
    }

    fn go(&mut self, pose: &Pose, air: bool, begins: bool) {
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
            Some(_) => self.finder.second_words(&pose, &mut self.second),
            None => self.finder.states(&pose, &self.near, &mut self.states),
        }
        let reached = if pole.is_some() { !self.second.is_empty() } else { !self.states.is_empty() };
        if !reached {
            self.searches.iter_mut().for_each(|run| run.ended = true);
            return;
        }
        for run in 0..self.searches.len() {
            if !self.searches[run].ended && !self.step(run, (&pose, pole.as_ref()), air, begins) {
                self.searches[run].ended = true;
            }
        }
        self.here = Some(pose);
        self.pole = pole;
    }

    /// One motion of one search. False if there is no way.
    fn step(&mut self, run: usize, (pose, pole): (&Pose, Option<&UnitVector3<f64>>), air: bool, begins: bool) -> bool {
        let motion = self.motion;
        let (finder, search) = (&self.finder, &mut self.searches[run].search);
        let from = self.here.filter(|_| !air);
        match (from, pole) {
            (None, None) => {
                let is_preferred = |state: &RotaryState| {
                    let preferred = self.prefer.is_none_or(|(letter, positive)| {
                        let axis = finder
                            .placer()
                            .rotaries()
                            .iter()
                            .position(|rotary| finder.placer().chain()[rotary.index].letter == letter);
                        axis.is_none_or(|axis| if positive { state.words[axis] >= 0 } else { state.words[axis] <= 0 })
                    });
                    preferred && self.start_branch.is_none_or(|branch| branch == state.branch)
                };
                search.free(motion, &self.states, self.sense, is_preferred)
            }
            (None, Some(_)) => {
                let Some(first) = finder.placer().rotaries().first() else { return false };
                search.free_to_pole((motion, begins), (*first, &self.second), self.sense);
                true
            }
            (Some(_), Some(_)) if self.pole.is_some() => true,
            (Some(from), Some(pole)) => {
                search.cut_to_pole(motion, None, |state| finder.at_pole(pole, &from.axis, state))
            }
            (Some(_), None) if let Some(pole) = self.pole => {
                search.leave_pole(motion, &self.states, &finder.exits(&pole, &pose.axis, &self.states))
            }
            (Some(from), None) => match finder.pole_between(&from, pose) {
                Some((part, pole)) => {
                    search.cut_to_pole(motion, Some(part), |state| finder.at_pole(&pole, &from.axis, state))
                        && search.leave_pole(motion, &self.states, &finder.exits(&pole, &pose.axis, &self.states))
                }
                None => cut(finder, search, motion, &from, pose, &self.states),
            },
        }
    }

    /// The course, and what it costs to plan without a view ahead.
    #[must_use]
    pub fn finish(self) -> Course {
        let [best, greedy] = self.searches.map(|run| (run.ended, run.search.finish()));
        let (ended, motion_by_motion) = (greedy.0, greedy.1.0);
        let (cost, changes) = if self.greedy { greedy.1 } else { best.1 };
        let mut changes = changes.read_from_start();
        Course { next: changes.next(), changes, cost, greedy: (!ended).then_some(motion_by_motion) }
    }
}

impl Stage for Navigator {
    type Stop = Diagnostic;

    /// Follows one item; nothing is refused.
    fn take(&mut self, item: &ProgramItem<'_>) -> Result<(), Diagnostic> {
        match item.action {
            ItemAction::Line { motion, index, .. } => {
                let begins = index.begins == Begins::Operation;
                self.move_to(&motion.pose, index, begins || motion.rapid);
            }
            // The tool has been led to its start.
            ItemAction::Arc { arc, index } => self.move_to(&arc.end, index, false),
            // The tool goes over to it at rapid.
            ItemAction::Hole { hole, index } => self.move_to(&hole.top, index, true),
            ItemAction::Record { event, .. } => self.record(event),
        }
        Ok(())
    }
}

/// A cut between two poses beside the pole. Where no state runs through it is split: at its place nearest to a pole that it
/// passes, since an axis may turn by more than half a turn there, and where a state runs into a limit on the way.
fn cut(
    finder: &StateFinder,
    search: &mut CourseSearch,
    motion: u64,
    from: &Pose,
    to: &Pose,
    states: &[RotaryState],
) -> bool {
    // Between opposite axes no way is known, and none is split.
    let segment = PathSegment::new(from, to);
    let (mut here, mut done) = (*from, 0.0);
    let mut passing = finder.passing(from, to);
    let (mut near, mut split) = (Vec::new(), Vec::new());
    for _ in 0..MAX_CROSSINGS {
        let merged = finder.merged(states) || finder.merged(search.layer());
        if search.cut(motion, states, None, |a, b| finder.connected((&here, a), (to, b), merged)) {
            return true;
        }
        let Some(segment) = &segment else { return false };
        near.clear();
        if finder.placer().has_many_turns() {
            search.near(false, &mut near);
        }
        let mut split_at = |search: &mut CourseSearch, part: f64| {
            let there = segment.at(part);
            finder.states(&there, &near, &mut split);
            let reached =
                search.cut(motion, &split, Some(part), |a, b| finder.connected((&here, a), (&there, b), false));
            reached.then_some(there)
        };
        if let Some(part) = passing.filter(|part| *part > done)
            && let Some(there) = split_at(search, part)
        {
            (here, done, passing) = (there, part, None);
            continue;
        }
        let Some(part) = crossing(finder, search, segment, (&here, done), &near) else { return false };
        let Some(there) = split_at(search, part) else { return false };
        (here, done) = (there, part);
    }
    false
}

/// The first part of the way at which a state of the last layer is about to leave its limits while another turn is inside.
fn crossing(
    finder: &StateFinder,
    search: &CourseSearch,
    segment: &PathSegment,
    (here, done): (&Pose, f64),
    near: &[RotaryWords],
) -> Option<f64> {
    let mut split = Vec::new();
    let mut first: Option<f64> = None;
    for state in search.layer() {
        let runs = |part: f64| finder.continued(&segment.at(part), state);
        if !finder.continued(here, state).is_some_and(|words| finder.inside(&words)) {
            continue;
        }
        let (mut inside, mut outside) = (done, 1.0);
        for _ in 0..60 {
            let middle = 0.5 * (inside + outside);
            match runs(middle) {
                Some(words) if finder.inside(&words) => inside = middle,
                _ => outside = middle,
            }
        }
        if inside <= done || first.is_some_and(|first| first <= inside) {
            continue;
        }
        finder.states(&segment.at(inside), near, &mut split);
        if split.len() > 1 {
            first = Some(inside);
        }
    }
    first
}
