//! Rollover of written rotary words: all whole turns, or a value within one revolution.
//!
//! Planning uses angles beyond 360°. Where an axis of the control rolls over, the words stay within one revolution, and
//! the control rotates by the shorter path, or in the direction given by the sign.

use crate::kinematics::{Axis, Rotary};
use crate::motion::policy::Policy;
use crate::options::Wrap;

use crate::motion::step::{AxisWords, MAX_AXES};

/// An axis whose words stay within one revolution.
#[derive(Debug, Clone, Copy, PartialEq)]
struct RolloverAxis {
    /// Position in the chain.
    index: usize,
    wrap: Wrap,
    /// The word written last.
    last: Option<i64>,
}

impl Wrap {
    /// Word that the control displays for a word of the plan.
    pub(crate) fn displayed(self, word: i64, units_per_turn: i64) -> i64 {
        let within = word.rem_euclid(units_per_turn);
        match self {
            Self::Symmetric if 2 * within >= units_per_turn => within - units_per_turn,
            Self::Positive | Self::Symmetric | Self::Sign => within,
        }
    }
}

/// Axes of a program that roll over.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Rollover {
    axes: Vec<RolloverAxis>,
    units_per_turn: i64,
}

impl Rollover {
    pub(crate) fn new(chain: &[Axis], policy: Policy<'_>, rotaries: &[Rotary], units_per_turn: i64) -> Self {
        let wrapped = |rotary: &Rotary| {
            let wrap = *policy.options.rotaries.wrap.get(&chain[rotary.index].letter)?;
            Some(RolloverAxis { index: rotary.index, wrap, last: None })
        };
        Self { axes: rotaries.iter().filter_map(wrapped).collect(), units_per_turn }
    }

    /// Number of blocks into which a motion of the axes in `mask` must be split so that the control rotates each of
    /// them in the planned direction.
    pub(crate) fn pieces(&self, from: &[i64; MAX_AXES], to: &[i64; MAX_AXES], mask: u16) -> i64 {
        let pieces = |axis: &RolloverAxis| {
            let travel = (to[axis.index] - from[axis.index]).abs();
            match axis.wrap {
                // A rotation by the shorter path is less than 180°.
                Wrap::Positive | Wrap::Symmetric => 2 * travel / self.units_per_turn + 1,
                Wrap::Sign => travel / self.units_per_turn + 1,
            }
        };
        self.axes.iter().filter(|axis| mask & (1 << axis.index) != 0).map(pieces).max().unwrap_or(1)
    }

    /// Whether an axis that takes the shorter path rotates by half a revolution, in either direction.
    pub(crate) fn is_half_turn(&self, from: &[i64; MAX_AXES], to: &[i64; MAX_AXES], mask: u16) -> bool {
        let turn = self.units_per_turn;
        self.axes.iter().any(|axis| {
            let travel = (to[axis.index] - from[axis.index]).rem_euclid(turn);
            mask & (1 << axis.index) != 0 && axis.wrap != Wrap::Sign && 2 * travel == turn
        })
    }

    /// Makes the words of a block that starts at the words `from` those to write.
    #[inline(always)]
    pub(crate) fn spell(&mut self, from: impl FnOnce() -> [i64; MAX_AXES], words: &mut AxisWords) {
        if !self.axes.is_empty() {
            self.wrap(&from(), words);
        }
    }

    fn wrap(&mut self, from: &[i64; MAX_AXES], words: &mut AxisWords) {
        let (turn, mask) = (self.units_per_turn, words.mask);
        for axis in self.axes.iter_mut().filter(|axis| mask & (1 << axis.index) != 0) {
            let (before, to) = (from[axis.index], words.units[axis.index]);
            let within = to.rem_euclid(turn);
            let spelled = match axis.wrap {
                Wrap::Positive | Wrap::Symmetric => axis.wrap.displayed(to, turn),
                Wrap::Sign if to == before && axis.last.is_some_and(|last| last.abs() % turn == within) => {
                    axis.last.unwrap_or(within)
                }
                // Zero has no sign: a whole revolution is written instead.
                Wrap::Sign if to < before && within == 0 => -turn,
                Wrap::Sign if to < before => -within,
                Wrap::Sign => within,
            };
            axis.last = Some(spelled);
            words.units[axis.index] = spelled;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::config::Config;
    use crate::kinematics::Machine;
    use crate::kinematics::machines::Cb;

    /// The written words of C for a list of positions in degrees.
    fn spelled(wrap: Wrap, degrees: &[i64]) -> Vec<i64> {
        let mut config = Config::default();
        config.motion.rotaries.wrap.insert('C', wrap);
        let rotary = Rotary { index: 0, lower: None, upper: None, rest_deg: 0.0 };
        let mut speller = Rollover::new(Cb::AXES, config.policy(), &[rotary], 360);
        let mut from = [0; MAX_AXES];
        degrees
            .iter()
            .map(|&to| {
                let mut words = AxisWords { units: [0; MAX_AXES], mask: 1, vector: None };
                words.units[0] = to;
                speller.spell(|| from, &mut words);
                let spelled = words.units[0];
                from[0] = to;
                spelled
            })
            .collect()
    }

    #[test]
    fn words_stay_within_one_revolution() {
        let path = [0, 90, 180, 350, 360, 370, 725, 700, 360, 0, -10];
        assert_eq!(spelled(Wrap::Positive, &path), [0, 90, 180, 350, 0, 10, 5, 340, 0, 0, 350]);
        assert_eq!(spelled(Wrap::Symmetric, &path), [0, 90, -180, -10, 0, 10, 5, -20, 0, 0, -10]);
        assert_eq!(spelled(Wrap::Sign, &path), [0, 90, 180, 350, 0, 10, 5, -340, -360, -360, -350]);
        assert_eq!(spelled(Wrap::Sign, &[90, 90, 80, 80, 80]), [90, 90, -80, -80, -80]);
    }

    #[test]
    fn a_rotation_by_the_shorter_path_is_less_than_half_a_revolution() {
        let pieces = |wrap, travel: i64| {
            let axes = vec![RolloverAxis { index: 0, wrap, last: None }];
            let mut to = [0; MAX_AXES];
            to[0] = travel;
            Rollover { axes, units_per_turn: 360 }.pieces(&[0; MAX_AXES], &to, 1)
        };
        assert_eq!(
            [0, 179, 180, -180, 359, 360, 720].map(|travel| pieces(Wrap::Positive, travel)),
            [1, 1, 2, 2, 2, 3, 5]
        );
        assert_eq!([179, 359, 360].map(|travel| pieces(Wrap::Sign, travel)), [1, 1, 2]);
    }
}
