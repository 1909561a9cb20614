//! Choice of branch and whole turns with the least total travel of the rotary axes.
//!
//! Computes in whole units of the rotary words, so that limits hold for the written values, ties are exact, and turns
//! are exact. The choice is made pose by pose, without look-ahead.

use crate::kinematics::{AngleScale, OutOfLimits, Rotary, RotaryAngles, Solution};

use super::RotaryWords;

/// Most turns of one axis that are tried for one pose, nearest to zero first. Of an axis with a wider range the turns
/// at its ends and those near the current course are tried in addition.
pub(crate) const MAX_TURNS: i64 = 24;

/// A chosen solution with its words.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Choice {
    /// Index of the solution.
    pub(crate) solution: usize,
    /// Words of the rotary axes.
    pub(crate) words: RotaryWords,
}

/// Solution and turns with the least total rotary travel from `previous`; ties go to the first branch.
///
/// # Errors
/// For each solution the rotary axis that no whole turn brings inside its limits.
pub(crate) fn choose(
    solutions: &[Solution<RotaryAngles>],
    rotaries: &[Rotary],
    previous: &RotaryWords,
    scale: AngleScale,
) -> Result<Choice, [Option<OutOfLimits>; 2]> {
    let mut best: Option<(i64, Choice)> = None;
    let mut outside = [None; 2];
    for (number, solution) in solutions.iter().enumerate() {
        match nearest_words(&solution.axes, rotaries, previous, scale) {
            Ok(words) => {
                let travel = words.iter().zip(previous).map(|(word, before)| (word - before).abs()).sum();
                if best.is_none_or(|(least, _)| travel < least) {
                    best = Some((travel, Choice { solution: number, words }));
                }
            }
            Err(out) => {
                if let Some(entry) = outside.get_mut(number) {
                    *entry = Some(out);
                }
            }
        }
    }
    best.map(|(_, choice)| choice).ok_or(outside)
}

/// Words of angles in the turns nearest to `previous`.
///
/// # Errors
/// The first axis that no whole turn brings inside its limits.
#[inline(always)]
fn nearest_words(
    angles: &RotaryAngles,
    rotaries: &[Rotary],
    previous: &RotaryWords,
    scale: AngleScale,
) -> Result<RotaryWords, OutOfLimits> {
    let mut words = RotaryWords::default();
    for ((word, rotary), (angle, before)) in words.iter_mut().zip(rotaries).zip(angles.iter().zip(previous)) {
        *word = rotary.nearest(rotary.word(*angle, scale), *before, scale.units_per_turn)?;
    }
    Ok(words)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::kinematics::Branch;

    const SCALE: AngleScale = AngleScale { units_per_degree: 10_000.0, units_per_turn: 3_600_000 };

    fn solution(degrees: [f64; 2]) -> Solution<RotaryAngles> {
        Solution { axes: degrees.map(f64::to_radians), branch: Branch::First, singular: false, deviation: 0.0 }
    }

    fn rotary(index: usize, limits: Option<(f64, f64)>) -> Rotary {
        let word = |degrees: f64| (degrees * 1e4) as i64;
        Rotary {
            index,
            lower: limits.map(|(lower, _)| word(lower)),
            upper: limits.map(|(_, upper)| word(upper)),
            rest_deg: 0.0,
        }
    }

    fn chosen(
        solutions: &[[f64; 2]],
        limits: [Option<(f64, f64)>; 2],
        previous: [f64; 2],
    ) -> Option<(usize, [f64; 2])> {
        let solutions: Vec<_> = solutions.iter().copied().map(solution).collect();
        let words = previous.map(|degrees| (degrees * 1e4) as i64);
        choose(&solutions, &[rotary(0, limits[0]), rotary(1, limits[1])], &words, SCALE)
            .ok()
            .map(|choice| (choice.solution, [SCALE.degrees(choice.words[0]), SCALE.degrees(choice.words[1])]))
    }

    #[test]
    fn the_branch_with_the_least_travel_is_taken() {
        let branches = [[10.0, 30.0], [-170.0, -30.0]];
        assert_eq!(chosen(&branches, [None, None], [0.0, 0.0]), Some((0, [10.0, 30.0])));
        assert_eq!(chosen(&branches, [None, None], [180.0, -20.0]), Some((1, [190.0, -30.0])));
    }

    #[test]
    fn a_tie_between_branches_goes_to_the_first() {
        let branches = [[90.0, 30.0], [-90.0, -30.0]];
        assert_eq!(chosen(&branches, [None, None], [0.0, 0.0]), Some((0, [90.0, 30.0])));
    }

    #[test]
    fn a_tie_between_turns_goes_to_the_smaller_absolute_value() {
        assert_eq!(chosen(&[[-170.0, 0.0]], [None, None], [10.0, 0.0]), Some((0, [-170.0, 0.0])));
        assert_eq!(chosen(&[[-170.0, 0.0]], [None, None], [370.0, 0.0]), Some((0, [190.0, 0.0])));
        assert_eq!(chosen(&[[180.0, 0.0]], [None, None], [0.0, 0.0]), Some((0, [180.0, 0.0])));
    }

    #[test]
    fn a_limit_is_inclusive_and_holds_for_the_rounded_word() {
        let limits = [None, Some((-5.0, 110.0))];
        assert_eq!(chosen(&[[0.0, 110.000_04]], limits, [0.0, 0.0]), Some((0, [0.0, 110.0])));
        assert_eq!(chosen(&[[0.0, 110.000_06]], limits, [0.0, 0.0]), None);
        assert_eq!(chosen(&[[0.0, -5.0]], limits, [0.0, 0.0]), Some((0, [0.0, -5.0])));
        assert_eq!(chosen(&[[0.0, -5.000_06]], limits, [0.0, 0.0]), None);
    }

    #[test]
    fn the_axis_without_a_turn_inside_its_limits_is_named_for_each_branch() {
        let branches = [solution([0.0, 120.0]), solution([180.0, -120.0])];
        let rotaries = [rotary(0, None), rotary(1, Some((-5.0, 110.0)))];
        let outside = choose(&branches, &rotaries, &[0; 2], SCALE).expect_err("both are outside");
        assert_eq!(
            outside.map(|out| out.map(|out| (out.rotary.index, out.word))),
            [Some((1, 1_200_000)), Some((1, -1_200_000))]
        );
    }

    proptest! {
        #[test]
        fn the_only_turn_is_the_first_of_the_turns(
            word in -9_000_000_i64..9_000_000,
            halves in any::<bool>(),
            limits in proptest::option::of((-4_000_000_i64..4_000_000, 0_i64..3_600_000)),
        ) {
            let word = if halves { word / 1_800_000 * 1_800_000 } else { word };
            let (lower, upper) = limits.map(|(lower, span)| (lower, lower + span)).unzip();
            let rotary = Rotary { index: 0, lower, upper, rest_deg: 0.0 };
            prop_assert!(rotary.has_one_turn(SCALE.units_per_turn));
            let turns: Vec<i64> = rotary.turns(word, SCALE.units_per_turn, MAX_TURNS).collect();
            prop_assert_eq!(Vec::from_iter(rotary.only_turn(word, SCALE.units_per_turn)), turns);
        }

        #[test]
        fn the_chooser_agrees_with_trying_every_turn(
            angles in proptest::collection::vec((-1800_i64..=1800, -1800_i64..=1800), 1..=2),
            previous in (-8000_i64..8000, -8000_i64..8000),
            limits in proptest::collection::vec(proptest::option::of((-5000_i64..5000, 0_i64..8000)), 2),
        ) {
            // Tenths of a degree make ties likely.
            let solutions: Vec<_> =
                angles.iter().map(|&(a, b)| solution([a as f64 / 10.0, b as f64 / 10.0])).collect();
            let limit = |i: usize| limits[i].map(|(lower, span)| (lower as f64 / 10.0, (lower + span) as f64 / 10.0));
            let rotaries = [rotary(0, limit(0)), rotary(1, limit(1))];
            let from = [previous.0 * 1000, previous.1 * 1000];
            let mut best: Option<(i64, usize, i64, i64, [i64; 2])> = None;
            for (number, &(a, b)) in angles.iter().enumerate() {
                for i in -5..=5 {
                    for j in -5..=5 {
                        let words = [a * 1000 + i * SCALE.units_per_turn, b * 1000 + j * SCALE.units_per_turn];
                        let inside = (0..2).all(|axis| {
                            rotaries[axis].lower.is_none_or(|lower| words[axis] >= lower)
                                && rotaries[axis].upper.is_none_or(|upper| words[axis] <= upper)
                        });
                        let travel = (words[0] - from[0]).abs() + (words[1] - from[1]).abs();
                        let key = (travel, number, words[0].abs() + words[1].abs(), -words[0] - words[1], words);
                        if inside && best.is_none_or(|best| key < best) {
                            best = Some(key);
                        }
                    }
                }
            }
            let choice = choose(&solutions, &rotaries, &from, SCALE).ok();
            prop_assert_eq!(choice.map(|choice| (choice.solution, [choice.words[0], choice.words[1]])),
                best.map(|(_, number, _, _, words)| (number, words)));
        }
    }
}
