//! States (branch and rotary words) of a pose, and the test whether a cut connects two of them.

use nalgebra::{UnitVector3, Vector3};

use crate::kinematics::{Branch, Pose, Rotary, RotaryAngles, Solution, math};

use crate::motion::course::search::{RotaryState, preference};
use crate::motion::geometry::{PathSegment, angle_between};
use crate::motion::place::Placer;
use crate::motion::rotary::{MAX_TURNS, RotaryWords};
use crate::tolerance::writer::{DIRECTION_AT_POLE, NO_GREAT_CIRCLE, SAME_WORD_AFTER_POLE, SLOPE_NEAR_LIMIT};

/// Parts of a cut near a limit whose ends are looked at.
const LIMIT_POINTS: u32 = 16;

/// Largest number of halvings of a block in the test of continuity: from 180° down to the smallest distance from a pole
/// at which the axes still move.
const MAX_HALVINGS: u32 = 30;

/// Square of the distance between the tool axes of two poses.
#[inline(always)]
pub(crate) fn chord(from: &Pose, to: &Pose) -> f64 {
    (to.axis.into_inner() - from.axis.into_inner()).norm_squared()
}

/// Finds the states of poses on one machine.
#[derive(Debug)]
pub(crate) struct StateFinder {
    placer: Placer,
    /// The two rotary axes, where each has one turn at most inside its limits.
    single_turns: Option<[Rotary; 2]>,
    /// Largest angle between a pole and a path that is led through it, rad; `None` if none is.
    largest_bend_rad: Option<f64>,
}

/// Cuts along one path that have been tested for continuity, by the words of their ends. Both searches ask for the same
/// ones.
#[derive(Debug, Default)]
pub(crate) struct TestedCuts {
    /// Fraction of the path at which the cuts begin.
    start: f64,
    results: Vec<([RotaryWords; 2], bool)>,
}

/// A pose where a cut begins or ends, and the state of the rotary axes there.
#[derive(Debug, Clone, Copy)]
pub(crate) struct CutEnd<'p> {
    pub(crate) pose: &'p Pose,
    pub(crate) state: &'p RotaryState,
}

/// Rotary words at a share of a path.
#[derive(Debug, Clone, Copy)]
struct WordsAtShare {
    /// Share of the path, 0 to 1.
    share: f64,
    words: RotaryWords,
}

impl TestedCuts {
    /// Forgets all cuts.
    pub(crate) fn clear(&mut self) {
        self.results.clear();
    }

    /// From here on cuts begin at this fraction of the path.
    pub(crate) fn begin_at(&mut self, start: f64) {
        if start.to_bits() != self.start.to_bits() {
            self.clear();
        }
        self.start = start;
    }

    fn is_continuous(&mut self, ends: [RotaryWords; 2], test: impl FnOnce() -> bool) -> bool {
        if let Some((_, result)) = self.results.iter().find(|(known, _)| *known == ends) {
            return *result;
        }
        let result = test();
        self.results.push((ends, result));
        result
    }
}

impl StateFinder {
    pub(crate) fn new(placer: Placer) -> Self {
        let single_turns = <[Rotary; 2]>::try_from(placer.rotaries())
            .ok()
            .filter(|rotaries| rotaries.iter().all(|rotary| rotary.has_one_turn(placer.scale().units_per_turn)));
        Self { placer, single_turns, largest_bend_rad: None }
    }

    /// Sets whether paths that pass a pole closely are led through it, where blocks contain tool vectors and an axis
    /// has limits; `tip`: under tip control. Returns whether they are.
    pub(crate) fn lead_through_poles(&mut self, tip: bool) -> bool {
        self.largest_bend_rad = self.placer.largest_bend().filter(|_| tip);
        self.largest_bend_rad.is_some()
    }

    /// Converts poses to words.
    pub(crate) fn placer(&self) -> &Placer {
        &self.placer
    }

    /// Every branch of a pose with every turn inside the limits, in the order of preference: the first branch first,
    /// then the turns nearest to zero, positive before negative. An endless axis is within 180° of zero. `near`: of an
    /// axis with more than [`MAX_TURNS`] turns those next to these words and at its ends are added.
    pub(crate) fn states(&self, pose: &Pose, near: &[RotaryWords], out: &mut Vec<RotaryState>) {
        out.clear();
        let scale = self.placer.scale();
        for solution in self.placer.machine().rotary_axes(&pose.axis, self.placer.held()).iter() {
            let mut words = RotaryWords::default();
            for ((word, rotary), angle) in words.iter_mut().zip(self.placer.rotaries()).zip(solution.axes) {
                *word = self.placer.indexed_word(rotary, angle);
            }
            if let Some([first, second]) = self.single_turns {
                let turn = |axis: usize, rotary: Rotary| rotary.only_turn(words[axis], scale.units_per_turn);
                if let (Some(first), Some(second)) = (turn(0, first), turn(1, second)) {
                    out.push(RotaryState { branch: solution.branch, words: [first, second] });
                }
                continue;
            }
            let start = out.len();
            let turns = |axis: usize, rotary: &Rotary| rotary.turns(words[axis], scale.units_per_turn, MAX_TURNS);
            let mut push = |words: RotaryWords| out.push(RotaryState { branch: solution.branch, words });
            match self.placer.rotaries() {
                [first, second] => {
                    for b in turns(1, second) {
                        turns(0, first).for_each(|a| push([a, b]));
                    }
                }
                [only] => turns(0, only).for_each(|a| push([a, 0])),
                _ => push([0; 2]),
            }
            if self.placer.has_many_turns() {
                // The turns tried of an axis are all those between the first and the last one.
                let tried = [0, 1].map(|axis| {
                    let words = || out[start..].iter().map(|state| state.words[axis]);
                    words().min().zip(words().max())
                });
                let is_between = |words: &RotaryWords| {
                    tried.iter().zip(words).all(|(ends, word)| ends.is_some_and(|(a, b)| (a..=b).contains(word)))
                };
                let added = out.len();
                let ends = [Rotary::lower_end, Rotary::upper_end]
                    .map(|end| [0, 1].map(|axis| self.placer.rotaries().get(axis).map_or(0, |rotary| end(*rotary))));
                // Between turns tried the nearest is one of them.
                for near in ends.iter().chain(near).filter(|near| !is_between(near)) {
                    let mut found = RotaryWords::default();
                    let inside = self.placer.rotaries().iter().enumerate().all(|(axis, rotary)| {
                        let nearest = rotary.nearest(words[axis], near[axis], scale.units_per_turn);
                        found[axis] = nearest.unwrap_or_default();
                        nearest.is_ok()
                    });
                    if inside && !is_between(&found) && out[added..].iter().all(|known| known.words != found) {
                        out.push(RotaryState { branch: solution.branch, words: found });
                    }
                }
            }
            out[start..].sort_by_key(|state| preference(&state.words));
        }
    }

    /// Words of the second rotary axis at a pole.
    pub(crate) fn second_words(&self, pose: &Pose, out: &mut Vec<i64>) {
        out.clear();
        let [_, second] = self.placer.rotaries()[..] else { return };
        for solution in self.placer.machine().rotary_axes(&pose.axis, self.placer.held()).iter() {
            let word = self.placer.indexed_word(&second, solution.axes[1]);
            out.extend(second.turns(word, self.placer.scale().units_per_turn, MAX_TURNS));
        }
        out.dedup();
    }

    /// Fraction of the path between two poses at which the tool axis is at a pole or is to be led through it, and this
    /// pole.
    pub(crate) fn pole_between(&self, from: &Pose, to: &Pose) -> Option<(f64, UnitVector3<f64>)> {
        self.pole_touched(from, to).or_else(|| self.pole_to_cross(from, to))
    }

    /// Pole that the path passes closely where blocks contain tool vectors and an axis is limited: there the control
    /// finds the rotary angles, and whether it rotates the first axis by nearly 180° or takes the other branch depends
    /// on its interpolation. Through the pole the axis takes the nearest angle.
    fn pole_to_cross(&self, from: &Pose, to: &Pose) -> Option<(f64, UnitVector3<f64>)> {
        let largest = self.largest_bend_rad?;
        let (part, pole, angle) = self.placer.passing(&from.axis, &to.axis)?;
        (angle <= largest).then_some((part, pole))
    }

    /// Whether a path between two tool axes is so short, and so far from the poles, that
    /// [`pole_between`](Self::pole_between) finds none, and neither end is at one. `chord`: square of the distance
    /// between both.
    #[inline(always)]
    pub(crate) fn passes_far_from_poles(&self, chord: f64, to: &UnitVector3<f64>) -> bool {
        // A pole on the path, within its tolerance, is no farther from an end than the path is long and the tolerance.
        let poles = self.placer.poles();
        let least = 4.0 * (chord + poles.tolerance_rad * poles.tolerance_rad);
        self.largest_bend_rad.is_none() && poles.are_farther(to, least)
    }

    fn pole_touched(&self, from: &Pose, to: &Pose) -> Option<(f64, UnitVector3<f64>)> {
        let (a, b) = (from.axis.into_inner(), to.axis.into_inner());
        let normal = a.cross(&b);
        let sine = normal.norm();
        let poles = self.placer.poles();
        if poles.axes.is_empty() || sine < NO_GREAT_CIRCLE {
            return None;
        }
        poles.axes.iter().find_map(|pole| {
            let p = pole.into_inner();
            let touches = p.dot(&normal).abs() <= poles.tolerance_rad * sine
                && a.cross(&p).dot(&normal) > 0.0
                && p.cross(&b).dot(&normal) > 0.0;
            // The pole may be beside the path: where it is nearest.
            let along = || math::atan2(p.dot(&normal.cross(&a)), sine * p.dot(&a));
            touches.then(|| (along() / angle_between(&a, &b), *pole))
        })
    }

    /// Words with which a path between a tool axis and the pole reaches the pole on the branch of a state.
    pub(crate) fn at_pole(
        &self,
        pole: &UnitVector3<f64>,
        axis: &UnitVector3<f64>,
        state: &RotaryState,
    ) -> Option<RotaryWords> {
        let [first, second] = self.placer.rotaries()[..] else { return None };
        let p = pole.into_inner();
        let away = (axis.into_inner() - p * p.dot(axis)).try_normalize(0.0)?;
        let solutions_at = |axis: Vector3<f64>| {
            let axis = UnitVector3::new_normalize(axis);
            self.placer.machine().rotary_axes(&axis, &self.placer.axes_of(&state.words))
        };
        let near = solutions_at(p + away * DIRECTION_AT_POLE);
        let near = near.iter().find(|solution| near.len() == 1 || solution.branch == state.branch)?;
        let word = |rotary: &Rotary, angle: f64, from: i64| {
            rotary.nearest(rotary.word(angle, self.placer.scale()), from, self.placer.scale().units_per_turn).ok()
        };
        let free = word(&first, near.axes[0], state.words[0])?;
        let at_pole = solutions_at(p);
        let tilt = at_pole
            .iter()
            .filter_map(|solution| word(&second, solution.axes[1], state.words[1]))
            .min_by_key(|word| (word - state.words[1]).abs())?;
        let free = if (free - state.words[0]).abs() <= SAME_WORD_AFTER_POLE { state.words[0] } else { free };
        Some([free, tilt])
    }

    /// For each state the words with which a path to a tool axis leaves the pole.
    pub(crate) fn exits(
        &self,
        pole: &UnitVector3<f64>,
        axis: &UnitVector3<f64>,
        states: &[RotaryState],
    ) -> Vec<Option<RotaryWords>> {
        states.iter().map(|state| self.at_pole(pole, axis, state)).collect()
    }

    /// Whether a cut from one state to another keeps the tool on its path: the axes move continuously from end to end,
    /// and inside their limits. `merged`: both branches are the same.
    pub(crate) fn connected(&self, from: CutEnd<'_>, to: CutEnd<'_>, merged: bool, tested: &mut TestedCuts) -> bool {
        self.is_joined(from, to, merged, tested) && self.stays_inside(from, to)
    }

    /// Whether the words of one of these states are so near to a limit that a cut to a pose, whose tool axis moves
    /// along a great circle, could exceed the limit between its ends.
    pub(crate) fn is_near_limit(&self, from: &Pose, to: &Pose, states: &[RotaryState]) -> bool {
        let Some(second) = self.placer.rotaries().get(1).filter(|rotary| !rotary.endless()) else { return false };
        let reach = math::rounded(self.reach_along(chord(from, to)));
        states.iter().any(|state| !(second.contains(state.words[1] - reach) && second.contains(state.words[1] + reach)))
    }

    /// How far the second rotary axis may go beyond the ends of a cut, whose tool axis moves along a great circle, in
    /// units of the words. `chord`: square of the distance between both tool axes.
    #[inline(always)]
    pub(crate) fn reach_along(&self, chord: f64) -> f64 {
        (math::sqrt(chord) * SLOPE_NEAR_LIMIT).to_degrees() * self.placer.scale().units_per_degree
    }

    /// Whether a cut stays inside the limits between its ends, where the rotary axes do not go evenly.
    fn stays_inside(&self, from: CutEnd<'_>, to: CutEnd<'_>) -> bool {
        let (CutEnd { pose: a, state: start }, CutEnd { pose: b, state: end }) = (from, to);
        let ends = [*start, *end];
        if !self.is_near_limit(a, b, &ends) || self.placer.goes_evenly([a, b], [&start.words, &end.words]) {
            return true;
        }
        let Some(segment) = PathSegment::new(a, b) else { return true };
        let inside = |step: u32| {
            let share = f64::from(step) / f64::from(LIMIT_POINTS);
            let between = [0, 1].map(|axis| {
                let change = self.placer.metric().change(axis, start.words[axis], end.words[axis]);
                start.words[axis] + (change as f64 * share) as i64
            });
            self.nearest_turns(&segment.at(share), &between).is_none_or(|words| self.inside(&words))
        };
        (1..LIMIT_POINTS).all(inside)
    }

    /// Whether the axes move continuously from one state to another.
    fn is_joined(&self, from: CutEnd<'_>, to: CutEnd<'_>, merged: bool, tested: &mut TestedCuts) -> bool {
        let (CutEnd { pose: a, state: start }, CutEnd { pose: b, state: end }) = (from, to);
        if !self.placer.metric().short(&start.words, &end.words) || (start.branch != end.branch && !merged) {
            return false;
        }
        if start.branch == end.branch && self.placer.metric().plain(&start.words, &end.words) {
            return true;
        }
        let change = [0, 1].map(|axis| self.placer.metric().change(axis, start.words[axis], end.words[axis]));
        let end = [start.words[0] + change[0], start.words[1] + change[1]];
        tested.is_continuous([start.words, end], || {
            let segment = PathSegment::new(a, b);
            let (from, to) = (WordsAtShare { share: 0.0, words: start.words }, WordsAtShare { share: 1.0, words: end });
            segment.is_some_and(|path| self.is_continuous(&path, from, to, MAX_HALVINGS))
        })
    }

    /// Whether repeated halving of a part of a block leads to rotations below 10°.
    fn is_continuous(&self, segment: &PathSegment, from: WordsAtShare, to: WordsAtShare, halvings: u32) -> bool {
        let travel = (0..2).map(|axis| (to.words[axis] - from.words[axis]).abs()).max().unwrap_or(0);
        if 36 * travel < self.placer.scale().units_per_turn {
            return true;
        }
        if halvings == 0 {
            return false;
        }
        let share = 0.5 * (from.share + to.share);
        let expected = [0, 1].map(|axis| (from.words[axis] + to.words[axis]) / 2);
        let Some(words) = self.nearest_turns(&segment.at(share), &expected) else { return false };
        let off = (0..2).map(|axis| (words[axis] - expected[axis]).abs()).max().unwrap_or(0);
        let middle = WordsAtShare { share, words };
        off < travel
            && self.is_continuous(segment, from, middle, halvings - 1)
            && self.is_continuous(segment, middle, to, halvings - 1)
    }

    /// Words of a pose nearest to the expected ones, on any branch, without limits.
    pub(crate) fn nearest_turns(&self, pose: &Pose, expected: &RotaryWords) -> Option<RotaryWords> {
        let solutions = self.placer.machine().rotary_axes(&pose.axis, &self.placer.axes_of(expected));
        let off = |words: &RotaryWords| (words[0] - expected[0]).abs() + (words[1] - expected[1]).abs();
        solutions.iter().filter_map(|solution| self.words_near(solution, expected)).min_by_key(off)
    }

    /// Words of a state after a cut to a pose, without limits.
    pub(crate) fn continued(&self, pose: &Pose, state: &RotaryState) -> Option<RotaryWords> {
        let solutions = self.placer.machine().rotary_axes(&pose.axis, &self.placer.axes_of(&state.words));
        let solution = solutions.iter().find(|solution| solutions.len() == 1 || solution.branch == state.branch)?;
        self.words_near(solution, &state.words)
    }

    /// Words of a solution in the turn nearest to the words `near`, without limits.
    fn words_near(&self, solution: &Solution<RotaryAngles>, near: &RotaryWords) -> Option<RotaryWords> {
        let mut words = *near;
        for ((word, rotary), angle) in words.iter_mut().zip(self.placer.rotaries()).zip(solution.axes) {
            let wanted = rotary.word(angle, self.placer.scale());
            *word = rotary.without_limits().nearest(wanted, *word, self.placer.scale().units_per_turn).ok()?;
        }
        Some(words)
    }

    /// Whether words are inside the limits of their axes.
    pub(crate) fn inside(&self, words: &RotaryWords) -> bool {
        self.placer.rotaries().iter().zip(words).all(|(rotary, &word)| rotary.contains(word))
    }

    /// Whether both branches of a pose with these states are the same, or the other one is outside the limits: a cut
    /// may lead from one to the other close to a pole, where its blocks are certified. Where the control finds the
    /// angles it keeps its branch.
    pub(crate) fn merged(&self, pose: &Pose, states: &[RotaryState]) -> bool {
        let one = || self.placer.machine().inverse_kinematics(pose, self.placer.held()).len() == 1;
        self.placer.rotaries().len() == 2
            && states.iter().all(|state| state.branch == Branch::First)
            && (self.largest_bend_rad.is_none() || one())
    }
}
