//! How a machine can hold a pose, and which of these states a cut connects.

use nalgebra::{Point3, UnitVector3, Vector3};

use crate::kinematics::{AxisValues, Branch, Pose, Solution};

use crate::motion::course::search::RotaryState;
use crate::motion::geometry::{PathSegment, angle_between};
use crate::motion::place::Placer;
use crate::motion::rotary::Rotary;
use crate::motion::rotary::{MAX_TURNS, RotaryWords};

/// Distance from the pole at which the direction of a path into it is read, rad.
const NEAR_POLE: f64 = 1e-8;

/// Words this near to each other are the same after a detour through the pole.
const SAME_WORD: i64 = 2;

/// Halvings of a block while it is followed along its branch: half a turn, until it is no wider than the least distance
/// from a pole beside which the axes still turn.
const MAX_HALVINGS: u32 = 30;

/// Finds the ways in which the rotary axes of a machine can hold a pose.
#[derive(Debug)]
pub(crate) struct StateFinder {
    placer: Placer,
}

impl StateFinder {
    pub(crate) fn new(placer: Placer) -> Self {
        Self { placer }
    }

    /// Poses into words.
    pub(crate) fn placer(&self) -> &Placer {
        &self.placer
    }

    /// Every branch of a pose with every turn inside the limits, in the order of preference: the first branch first, then
    /// the turns nearest to zero, positive before negative. An endless axis stands within half a turn of zero. `near`: of an
    /// axis with too many turns those next to these words are among them, and those at its ends.
    pub(crate) fn states(&self, pose: &Pose, near: &[RotaryWords], out: &mut Vec<RotaryState>) {
        out.clear();
        for solution in self.placer.machine().inverse_kinematics(pose, self.placer.held()).iter() {
            let start = out.len();
            let turns = |rotary: &Rotary| {
                rotary.turns(
                    rotary.word(solution.axes[rotary.index], self.placer.scale()),
                    self.placer.scale().units_per_turn,
                    MAX_TURNS,
                )
            };
            let mut push = |words: RotaryWords| out.push(RotaryState { branch: solution.branch, words });
            match self.placer.rotaries() {
                [first, second] => {
                    for a in turns(first) {
                        turns(second).for_each(|b| push([a, b]));
                    }
                }
                [only] => turns(only).for_each(|a| push([a, 0])),
                _ => push([0; 2]),
            }
            if self.placer.has_many_turns() {
                let ends = [Rotary::lower_end, Rotary::upper_end]
                    .map(|end| [0, 1].map(|axis| self.placer.rotaries().get(axis).map_or(0, |rotary| end(*rotary))));
                for near in ends.iter().chain(near) {
                    let mut words = [0; 2];
                    let inside = self.placer.rotaries().iter().enumerate().all(|(axis, rotary)| {
                        let word = rotary.word(solution.axes[rotary.index], self.placer.scale());
                        let nearest = rotary.nearest(word, near[axis], self.placer.scale().units_per_turn);
                        words[axis] = nearest.unwrap_or_default();
                        nearest.is_ok()
                    });
                    if inside && out[start..].iter().all(|known| known.words != words) {
                        out.push(RotaryState { branch: solution.branch, words });
                    }
                }
            }
            let far = |state: &RotaryState| state.words[0].abs() + state.words[1].abs();
            out[start..].sort_by_key(|state| (far(state), [-state.words[0], -state.words[1]]));
        }
    }

    /// The words of the second rotary at a pole.
    pub(crate) fn second_words(&self, pose: &Pose, out: &mut Vec<i64>) {
        out.clear();
        let [_, second] = self.placer.rotaries()[..] else { return };
        for solution in self.placer.machine().inverse_kinematics(pose, self.placer.held()).iter() {
            let word = second.word(solution.axes[second.index], self.placer.scale());
            out.extend(second.turns(word, self.placer.scale().units_per_turn, MAX_TURNS));
        }
        out.dedup();
    }

    /// Where a path between two poses touches the pole on its way: the part of the way and the pole.
    pub(crate) fn pole_between(&self, from: &Pose, to: &Pose) -> Option<(f64, UnitVector3<f64>)> {
        let (a, b) = (from.axis.into_inner(), to.axis.into_inner());
        let normal = a.cross(&b);
        let sine = normal.norm();
        if self.placer.poles().is_empty() || sine < 1e-12 {
            return None;
        }
        self.placer.poles().iter().find_map(|pole| {
            let p = pole.into_inner();
            let touches = p.dot(&normal).abs() <= self.placer.pole_tolerance() * sine
                && a.cross(&p).dot(&normal) > 0.0
                && p.cross(&b).dot(&normal) > 0.0;
            touches.then(|| (angle_between(&a, &p) / angle_between(&a, &b), *pole))
        })
    }

    /// The part of its way at which a path is nearest to a pole, if it passes it rather than staying on one side.
    pub(crate) fn passing(&self, from: &Pose, to: &Pose) -> Option<f64> {
        let (a, b) = (from.axis.into_inner(), to.axis.into_inner());
        let normal = a.cross(&b).try_normalize(1e-12)?;
        self.placer.poles().iter().find_map(|pole| {
            let p = pole.into_inner();
            let beside = |axis: &Vector3<f64>| axis - p * p.dot(axis);
            let (before, behind) = (beside(&a), beside(&b));
            if before.dot(&behind) > -0.5 * before.norm() * behind.norm() {
                return None;
            }
            let nearest = p - normal * p.dot(&normal);
            Some(angle_between(&a, &nearest) / angle_between(&a, &b)).filter(|part| *part > 0.0 && *part < 1.0)
        })
    }

    /// The words in which a path from (or to) an axis reaches the pole on the branch of a state.
    pub(crate) fn at_pole(
        &self,
        pole: &UnitVector3<f64>,
        axis: &UnitVector3<f64>,
        state: &RotaryState,
    ) -> Option<RotaryWords> {
        let [first, second] = self.placer.rotaries()[..] else { return None };
        let p = pole.into_inner();
        let beside = (axis.into_inner() - p * p.dot(axis)).try_normalize(0.0)?;
        let solutions_at = |axis: Vector3<f64>| {
            let pose = Pose { tip: Point3::origin(), axis: UnitVector3::new_normalize(axis) };
            self.placer.machine().inverse_kinematics(&pose, &self.placer.axes_of(&state.words))
        };
        let near = solutions_at(p + beside * NEAR_POLE);
        let near = near.iter().find(|solution| near.len() == 1 || solution.branch == state.branch)?;
        let word = |rotary: &Rotary, angle: f64, from: i64| {
            rotary.nearest(rotary.word(angle, self.placer.scale()), from, self.placer.scale().units_per_turn).ok()
        };
        let free = word(&first, near.axes[first.index], state.words[0])?;
        let there = solutions_at(p);
        let tilt = there
            .iter()
            .filter_map(|solution| word(&second, solution.axes[second.index], state.words[1]))
            .min_by_key(|word| (word - state.words[1]).abs())?;
        let free = if (free - state.words[0]).abs() <= SAME_WORD { state.words[0] } else { free };
        Some([free, tilt])
    }

    /// For each state the words in which a path to an axis leaves the pole.
    pub(crate) fn exits(
        &self,
        pole: &UnitVector3<f64>,
        axis: &UnitVector3<f64>,
        states: &[RotaryState],
    ) -> Vec<Option<RotaryWords>> {
        states.iter().map(|state| self.at_pole(pole, axis, state)).collect()
    }

    /// Whether a cut from one state to another keeps the tool on its path: the axes run through from end to end.
    pub(crate) fn connected(&self, from: (&Pose, &RotaryState), to: (&Pose, &RotaryState), merged: bool) -> bool {
        let ((a, start), (b, end)) = (from, to);
        if !self.placer.metric().short(&start.words, &end.words) || (start.branch != end.branch && !merged) {
            return false;
        }
        if start.branch == end.branch && self.placer.metric().plain(&start.words, &end.words) {
            return true;
        }
        let change = [0, 1].map(|axis| self.placer.metric().change(axis, start.words[axis], end.words[axis]));
        let end = [start.words[0] + change[0], start.words[1] + change[1]];
        self.runs_through((a, start.words), (b, end), MAX_HALVINGS)
    }

    /// Whether halving a block again and again leads to small turns.
    fn runs_through(&self, from: (&Pose, RotaryWords), to: (&Pose, RotaryWords), halvings: u32) -> bool {
        let turn = (0..2).map(|axis| (to.1[axis] - from.1[axis]).abs()).max().unwrap_or(0);
        if 36 * turn < self.placer.scale().units_per_turn {
            return true;
        }
        let Some(middle) = PathSegment::new(from.0, to.0).map(|segment| segment.at(0.5)) else { return false };
        if halvings == 0 {
            return false;
        }
        let expected = [0, 1].map(|axis| (from.1[axis] + to.1[axis]) / 2);
        let Some(words) = self.nearest_turns(&middle, &expected) else { return false };
        let off = (0..2).map(|axis| (words[axis] - expected[axis]).abs()).max().unwrap_or(0);
        off < turn
            && self.runs_through(from, (&middle, words), halvings - 1)
            && self.runs_through((&middle, words), to, halvings - 1)
    }

    /// The solution of a pose nearest to some words, on any branch, without limits.
    pub(crate) fn nearest_turns(&self, pose: &Pose, expected: &RotaryWords) -> Option<RotaryWords> {
        let solutions = self.placer.machine().inverse_kinematics(pose, &self.placer.axes_of(expected));
        let off = |words: &RotaryWords| (words[0] - expected[0]).abs() + (words[1] - expected[1]).abs();
        solutions.iter().filter_map(|solution| self.turned_to(solution, expected)).min_by_key(off)
    }

    /// The words to which a state runs on in a cut, whatever the limits say.
    pub(crate) fn continued(&self, pose: &Pose, state: &RotaryState) -> Option<RotaryWords> {
        let solutions = self.placer.machine().inverse_kinematics(pose, &self.placer.axes_of(&state.words));
        let solution = solutions.iter().find(|solution| solutions.len() == 1 || solution.branch == state.branch)?;
        self.turned_to(solution, &state.words)
    }

    /// The words of a solution in the turn nearest to some words, without limits.
    fn turned_to(&self, solution: &Solution<AxisValues>, near: &RotaryWords) -> Option<RotaryWords> {
        let mut words = *near;
        for (word, rotary) in words.iter_mut().zip(self.placer.rotaries()) {
            let wanted = rotary.word(solution.axes[rotary.index], self.placer.scale());
            *word = rotary.without_limits().nearest(wanted, *word, self.placer.scale().units_per_turn).ok()?;
        }
        Some(words)
    }

    /// Whether words lie inside the limits of their axes.
    pub(crate) fn inside(&self, words: &RotaryWords) -> bool {
        self.placer.rotaries().iter().zip(words).all(|(rotary, &word)| rotary.contains(word))
    }

    /// Both branches of a pose are one.
    pub(crate) fn merged(&self, states: &[RotaryState]) -> bool {
        self.placer.rotaries().len() == 2 && states.iter().all(|state| state.branch == Branch::First)
    }
}
