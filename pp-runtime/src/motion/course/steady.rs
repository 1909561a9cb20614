//! Runs of cuts in which nothing can change.
//!
//! In a cut that rotates every axis by less than a quarter turn, all turns of a branch rotate alike, and as long as none enters
//! or leaves the limits, each state of a pose comes from the state of its branch and turn in the pose before. Increments,
//! times and travel are then the same for all of them: one sum for each branch takes the place of the layers of states.

use crate::kinematics::{Branch, RotaryAngles, Solution};
use crate::motion::course::search::RotaryState;
use crate::motion::rotary::{AngleScale, Cost, Rotary, RotaryMetric, RotaryWords};

/// One branch in a run of cuts.
#[derive(Debug, Clone, Copy)]
struct RunBranch {
    branch: Branch,
    /// Words of the last pose, within half a turn of zero.
    words: RotaryWords,
    /// Rotation since the run began, and the rotations between which no turn enters or leaves the limits.
    rotated: RotaryWords,
    lowest: RotaryWords,
    highest: RotaryWords,
    /// Rotations of the second axis at which its outermost turns are at the limits.
    at_limits: Option<[i64; 2]>,
    cost: Cost,
}

/// A run of cuts in which the states of each pose are those of the one before, rotated.
#[derive(Debug, Clone)]
pub(crate) struct SteadyRun {
    branches: Vec<RunBranch>,
    /// The rotary axes; the second is one that never rotates, where there is one alone.
    axes: [Rotary; 2],
    scale: AngleScale,
}

impl SteadyRun {
    /// Begins a run at a pose with these solutions.
    pub(crate) fn begin(solutions: &[Solution<RotaryAngles>], rotaries: &[Rotary], scale: AngleScale) -> Self {
        let branches = solutions.iter().map(|solution| RunBranch::begin(solution, rotaries, scale)).collect();
        let none = Rotary { index: 0, lower: None, upper: None, rest_deg: 0.0 };
        let axes = std::array::from_fn(|axis| rotaries.get(axis).copied().unwrap_or(none));
        Self { branches, axes, scale }
    }

    /// Whether the second axis has limits that a cut could exceed between its ends.
    #[inline]
    pub(crate) fn is_limited(&self) -> bool {
        self.branches.iter().any(|known| known.at_limits.is_some())
    }

    /// Takes a cut to a pose with these solutions; `reach`: how far the second axis may go beyond the ends of the cut. Returns
    /// false, and changes nothing, if the run ends before it.
    #[inline]
    pub(crate) fn follow(&mut self, solutions: &[Solution<RotaryAngles>], reach: i64, metric: &RotaryMetric) -> bool {
        if solutions.len() != self.branches.len() {
            return false;
        }
        let mut steps = [(RotaryWords::default(), RotaryWords::default()); 2];
        for ((known, solution), (words, change)) in self.branches.iter().zip(solutions).zip(&mut steps) {
            if solution.branch != known.branch {
                return false;
            }
            for axis in 0..2 {
                // Both are within half a turn of zero.
                words[axis] = self.axes[axis].word(solution.axes[axis], self.scale);
                let by = within_half_turn(words[axis] - known.words[axis], self.scale);
                let rotated = known.rotated[axis] + by;
                let is_wide = 4 * by.abs() >= self.scale.units_per_turn;
                if is_wide || rotated < known.lowest[axis] || rotated > known.highest[axis] {
                    return false;
                }
                change[axis] = by;
            }
            let second = known.rotated[1] + change[1];
            if known.at_limits.is_some_and(|[lower, upper]| second - reach < lower || second + reach > upper) {
                return false;
            }
        }
        for (known, (words, change)) in self.branches.iter_mut().zip(steps) {
            known.words = words;
            known.rotated = [known.rotated[0] + change[0], known.rotated[1] + change[1]];
            known.cost = known.cost.plus(metric.cost_of(change));
        }
        true
    }

    /// A state of the pose at which the run began as it is at the last pose, and the cost of its rotation.
    pub(crate) fn rotated(&self, state: &RotaryState) -> (RotaryState, Cost) {
        let Some(known) = self.branches.iter().find(|known| known.branch == state.branch) else {
            return (*state, Cost::default());
        };
        let mut words = state.words;
        for ((word, rotary), by) in words.iter_mut().zip(&self.axes).zip(known.rotated) {
            let rotated = *word + by;
            *word = if rotary.endless() {
                rotary.only_turn(rotated, self.scale.units_per_turn).unwrap_or(rotated)
            } else {
                rotated
            };
        }
        (RotaryState { words, ..*state }, known.cost)
    }
}

/// A word of less than one and a half turns, in the turn that is within half a turn of zero.
#[inline]
fn within_half_turn(word: i64, scale: AngleScale) -> i64 {
    let turns = i64::from(2 * word < -scale.units_per_turn) - i64::from(2 * word > scale.units_per_turn);
    word + turns * scale.units_per_turn
}

impl RunBranch {
    fn begin(solution: &Solution<RotaryAngles>, rotaries: &[Rotary], scale: AngleScale) -> Self {
        let mut new = Self {
            branch: solution.branch,
            words: RotaryWords::default(),
            rotated: RotaryWords::default(),
            lowest: [i64::MIN; 2],
            highest: [i64::MAX; 2],
            at_limits: None,
            cost: Cost::default(),
        };
        // A branch without a state gets one only where each axis has a turn inside its limits.
        let mut missing = None;
        for (axis, rotary) in rotaries.iter().enumerate().take(new.words.len()) {
            new.words[axis] = rotary.word(solution.axes[axis], scale);
            let Some(room) = TurnsInside::of(rotary, new.words[axis], scale.units_per_turn) else { continue };
            (new.lowest[axis], new.highest[axis]) = (room.lowest, room.highest);
            if axis > 0 {
                new.at_limits = Some(room.at_limits);
            }
            if room.is_empty {
                missing = Some(axis);
            }
        }
        if let Some(missing) = missing {
            new.at_limits = None;
            for axis in (0..new.words.len()).filter(|axis| *axis != missing) {
                (new.lowest[axis], new.highest[axis]) = (i64::MIN, i64::MAX);
            }
        }
        new
    }
}

/// Rotations of an axis for which its turns inside the limits stay the same ones.
struct TurnsInside {
    lowest: i64,
    highest: i64,
    /// Rotations at which the first is at the lower limit, and the last at the upper one.
    at_limits: [i64; 2],
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
            true => Self { lowest, highest, at_limits: [at_lower, at_upper], is_empty },
            false => Self {
                lowest: lowest.max(at_lower),
                highest: highest.min(at_upper),
                at_limits: [at_lower, at_upper],
                is_empty,
            },
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
