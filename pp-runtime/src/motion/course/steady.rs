//! Runs of cuts in which branches and turns stay the same.
//!
//! In a cut that rotates every axis by less than a quarter turn, all turns of a branch rotate alike, and as long as
//! none enters or leaves the limits, each state of a pose comes from the state of its branch and turn in the pose
//! before. Increments, times and travel are then the same for all of them: one sum for each branch takes the place of
//! the layers of states.
//!
//! Only a rewind from the other branch can lead cheaper to a state than its own course, where that branch has fewer
//! rewinds: before a cut the search [compares](super::search::CourseSearch::compare_rewinds) the two, unless the
//! branches have [drifted apart](Drift) too little since the last comparison.

use wide::f64x2;

use crate::kinematics::{AngleScale, Branch, Rotary, RotaryAngles, RotaryScale, Solution};
use crate::motion::course::search::RotaryState;
use crate::motion::rotary::{Cost, RotaryMetric, RotaryWords};

/// One branch in a run of cuts. Words and rotations are whole numbers, those of both axes side by side.
#[derive(Debug, Clone, Copy)]
struct RunBranch {
    branch: Branch,
    /// Words of the last pose, within half a turn of zero.
    words: f64x2,
    /// Rotation since the run began, and the rotations between which no turn enters or leaves the limits.
    rotated: f64x2,
    lowest: f64x2,
    highest: f64x2,
    /// 1 for a second axis with limits, if the branch has a state: a cut must not exceed them between its ends either.
    /// Else 0.
    is_limited: f64x2,
    /// Travel and time of the rotation.
    travel: f64x2,
    time_ns: u64,
}

/// Rotation of one branch in a cut: the words at its end, within half a turn of zero, and their change.
#[derive(Debug, Clone, Copy)]
pub(crate) struct BranchRotation {
    words: f64x2,
    by: f64x2,
}

/// By how much the two branches of a run have travelled unlike each other since courses with a rewind were compared
/// with those without.
///
/// A rewind costs the travel between both branches. In a cut in which they rotate by `a` and `b`, that changes by at
/// most `|a - b|`, and the difference of their travels by `||a| - |b||`: the difference of the two courses changes by
/// no more than the sum of both.
#[derive(Debug, Clone, Copy)]
struct Drift {
    by: f64x2,
    /// Drift up to which no course with a rewind becomes cheaper; below zero it is unknown.
    least: f64,
}

/// A run of cuts in which the states of each pose are those of the one before, rotated.
#[derive(Debug, Clone)]
pub(crate) struct SteadyRun {
    branches: Vec<RunBranch>,
    /// The rotary axes; the second is one that never rotates, where there is one alone.
    axes: [Rotary; 2],
    scale: AngleScale,
    of_both: RotaryScale,
    /// The second axis has limits that a cut could exceed between its ends.
    is_limited: bool,
    /// Where courses with a rewind are compared.
    drift: Option<Drift>,
}

impl SteadyRun {
    /// Begins a run at a pose with these solutions. `compares`: courses with a rewind are compared in it.
    pub(crate) fn begin(
        solutions: &[Solution<RotaryAngles>],
        rotaries: &[Rotary],
        scale: AngleScale,
        compares: bool,
    ) -> Self {
        let branches: Vec<_> = solutions.iter().map(|solution| RunBranch::begin(solution, rotaries, scale)).collect();
        let none = Rotary { index: 0, lower: None, upper: None, rest_deg: 0.0 };
        let axes = std::array::from_fn(|axis| rotaries.get(axis).copied().unwrap_or(none));
        let is_limited = branches.iter().any(|known| known.is_limited != f64x2::ZERO);
        let drift = compares.then_some(Drift { by: f64x2::ZERO, least: f64::NEG_INFINITY });
        Self { branches, axes, scale, of_both: RotaryScale::new(rotaries, scale), is_limited, drift }
    }

    /// Whether the second axis has limits that a cut could exceed between its ends.
    #[inline]
    pub(crate) fn is_limited(&self) -> bool {
        self.is_limited
    }

    /// Whether at a pose with these solutions the same turns nearest to zero are tried of an axis with many.
    pub(crate) fn tries_same_turns(&self, solutions: &[Solution<RotaryAngles>]) -> bool {
        let turn = self.scale.units_per_turn;
        self.branches.iter().zip(solutions).all(|(known, solution)| {
            (0..2).all(|axis| {
                let rotary = self.axes[axis].without_limits();
                let begins = |word: i64| rotary.only_turn(word, turn).is_some_and(|first| first > 0);
                begins(known.words.to_array()[axis] as i64) == begins(rotary.word(solution.axes[axis], self.scale))
            })
        })
    }

    /// The rotations of a cut to a pose with these solutions; `reach`: how far the second axis may go beyond the ends
    /// of the cut, in units of the words. `None` if the run ends before it.
    #[inline(always)]
    pub(crate) fn rotations(&self, solutions: &[Solution<RotaryAngles>], reach: f64) -> Option<[BranchRotation; 2]> {
        if solutions.len() != self.branches.len() {
            return None;
        }
        let reach = f64x2::splat(reach);
        let mut rotations = [BranchRotation { words: f64x2::ZERO, by: f64x2::ZERO }; 2];
        for ((known, solution), rotation) in self.branches.iter().zip(solutions).zip(&mut rotations) {
            *rotation = known.rotation(solution, reach, &self.of_both)?;
        }
        Some(rotations)
    }

    /// Takes a cut with these [rotations](Self::rotations).
    #[inline(always)]
    pub(crate) fn take(&mut self, rotations: [BranchRotation; 2], metric: &RotaryMetric) {
        for (known, BranchRotation { words, by }) in self.branches.iter_mut().zip(rotations) {
            known.words = words;
            known.rotated += by;
            known.travel += by.abs();
        }
        if metric.has_speeds() {
            for (known, rotation) in self.branches.iter_mut().zip(rotations) {
                let time_ns = metric.time_ns(rotation.by.abs().to_array());
                known.time_ns = known.time_ns.saturating_add(time_ns);
            }
        }
        if let Some(drift) = &mut self.drift {
            let [a, b] = rotations.map(|rotation| rotation.by);
            drift.by += (a - b).abs() + (a.abs() - b.abs()).abs();
        }
    }

    /// Whether rewinds are to be compared before the next cut.
    #[inline(always)]
    pub(crate) fn awaits_comparison(&self) -> bool {
        self.drift.is_some_and(|drift| drift.by.reduce_add() > drift.least)
    }

    /// Rewinds have been compared: they are not cheaper before the branches have drifted apart by `least`, in units of
    /// the words.
    pub(crate) fn compared(&mut self, least: f64) {
        self.drift = Some(Drift { by: f64x2::ZERO, least });
    }

    /// A state of the pose at which the run began as it is at the last pose, and the cost of its rotation.
    #[inline]
    pub(crate) fn rotated(&self, state: &RotaryState) -> (RotaryState, Cost) {
        let Some(known) = self.branches.iter().find(|known| known.branch == state.branch) else {
            return (*state, Cost::default());
        };
        let mut words = state.words;
        for ((word, rotary), by) in words.iter_mut().zip(&self.axes).zip(known.rotated.to_array()) {
            let rotated = *word + by as i64;
            *word = if rotary.endless() {
                rotary.only_turn(rotated, self.scale.units_per_turn).unwrap_or(rotated)
            } else {
                rotated
            };
        }
        let [first, second] = known.travel.to_array();
        let cost = Cost { time_ns: known.time_ns, travel_units: (first + second) as u64, ..Cost::default() };
        (RotaryState { words, ..*state }, cost)
    }
}

/// Words of less than one and a half turns, in the turn that is within half a turn of zero.
#[inline(always)]
fn within_half_turn(words: f64x2, turn: f64x2) -> f64x2 {
    let twice = words + words;
    words + (twice.simd_lt(-turn) & turn) - (twice.simd_gt(turn) & turn)
}

impl RunBranch {
    /// The rotation to a solution; `None` if the run ends before it.
    #[inline(always)]
    fn rotation(&self, solution: &Solution<RotaryAngles>, reach: f64x2, scale: &RotaryScale) -> Option<BranchRotation> {
        let (words, turn) = (scale.words(&solution.axes)?, scale.units_per_turn());
        // Both are within half a turn of zero.
        let by = within_half_turn(words - self.words, turn);
        let (rotated, reach) = (self.rotated + by, reach * self.is_limited);
        let ends = by.abs().simd_ge(f64x2::splat(0.25) * turn)
            | (rotated - reach).simd_lt(self.lowest)
            | (rotated + reach).simd_gt(self.highest);
        (solution.branch == self.branch && !ends.any()).then_some(BranchRotation { words, by })
    }

    fn begin(solution: &Solution<RotaryAngles>, rotaries: &[Rotary], scale: AngleScale) -> Self {
        let (mut words, mut lowest, mut highest) = (RotaryWords::default(), [f64::NEG_INFINITY; 2], [f64::INFINITY; 2]);
        // A branch without a state gets one only where each axis has a turn inside its limits.
        let mut missing = None;
        for (axis, rotary) in rotaries.iter().enumerate().take(words.len()) {
            words[axis] = rotary.word(solution.axes[axis], scale);
            let Some(room) = TurnsInside::of(rotary, words[axis], scale.units_per_turn) else { continue };
            (lowest[axis], highest[axis]) = (room.lowest as f64, room.highest as f64);
            if room.is_empty {
                missing = Some(axis);
            }
        }
        if let Some(missing) = missing {
            for axis in (0..words.len()).filter(|axis| *axis != missing) {
                (lowest[axis], highest[axis]) = (f64::NEG_INFINITY, f64::INFINITY);
            }
        }
        let is_limited = missing.is_none() && lowest[1].is_finite();
        Self {
            branch: solution.branch,
            words: words.map(|word| word as f64).into(),
            rotated: f64x2::ZERO,
            lowest: lowest.into(),
            highest: highest.into(),
            is_limited: [0.0, f64::from(u8::from(is_limited))].into(),
            travel: f64x2::ZERO,
            time_ns: 0,
        }
    }
}

/// Rotations of an axis for which its turns inside the limits stay the same ones.
struct TurnsInside {
    lowest: i64,
    highest: i64,
    /// No turn is inside.
    is_empty: bool,
}

impl TurnsInside {
    /// Those of the turns of a word; `None` for an axis without limits.
    fn of(rotary: &Rotary, word: i64, turn: i64) -> Option<Self> {
        let (lower, upper) = rotary.lower.zip(rotary.upper)?;
        // The first and the last turn inside.
        let first = -(word - lower).div_euclid(turn);
        let last = (upper - word).div_euclid(turn);
        // Until the first one leaves, or the one before it enters; the same at the upper limit.
        let at_lower = lower - word - first * turn;
        let at_upper = upper - word - last * turn;
        let is_empty = first > last;
        let (lowest, highest) = (at_upper - turn + 1, at_lower + turn - 1);
        Some(match is_empty {
            true => Self { lowest, highest, is_empty },
            false => Self { lowest: lowest.max(at_lower), highest: highest.min(at_upper), is_empty },
        })
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::motion::rotary::MAX_TURNS;

    proptest! {
        #[test]
        fn the_turns_inside_stay_the_same_up_to_the_ends_of_their_room(
            word in -180_i64..=180,
            limits in (-500_i64..500, 0_i64..900),
            by in -400_i64..400,
        ) {
            let rotary = Rotary { index: 0, lower: Some(limits.0), upper: Some(limits.0 + limits.1), rest_deg: 0.0 };
            let room = TurnsInside::of(&rotary, word, 360).expect("limits");
            let numbers = |word: i64, by: i64| {
                let mut turns: Vec<i64> =
                    rotary.turns(word + by, 360, MAX_TURNS).map(|turn| (turn - word - by) / 360).collect();
                turns.sort_unstable();
                turns
            };
            prop_assert_eq!(room.is_empty, numbers(word, 0).is_empty());
            prop_assert!(room.lowest <= 0 && room.highest >= 0);
            let inside = (room.lowest..=room.highest).contains(&by);
            let between = |ends: [i64; 2]| (ends[0].min(ends[1])..=ends[0].max(ends[1])).all(|by| numbers(word, by) == numbers(word, 0));
            prop_assert_eq!(inside, between([0, by]));
        }
    }
}
