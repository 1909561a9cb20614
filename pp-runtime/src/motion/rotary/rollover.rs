//! How many turns a written angle shows: as many as there are, or none.
//!
//! Planning counts turns without end. Where the control's axis rolls over, words stay within a turn, and the control goes
//! there the short way, or the way that the sign says.

use crate::kinematics::Axis;
use crate::motion::options::Policy;
use crate::motion::options::Wrap;

use crate::motion::rotary::Rotary;
use crate::motion::step::{AxisWords, MAX_AXES};

/// One axis whose words stay within a turn.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Wrapped {
    /// Position in the chain.
    index: usize,
    wrap: Wrap,
    /// The word written last, while the axis has not moved since.
    last: Option<i64>,
}

/// Words of a program as they are written.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Speller {
    axes: Vec<Wrapped>,
    turn: i64,
}

impl Speller {
    pub(crate) fn new(chain: &[Axis], policy: Policy<'_>, rotaries: &[Rotary], turn: i64) -> Self {
        let wrapped = |rotary: &Rotary| {
            let wrap = *policy.options.rotaries.wrap.get(&chain[rotary.index].letter)?;
            Some(Wrapped { index: rotary.index, wrap, last: None })
        };
        Self { axes: rotaries.iter().filter_map(wrapped).collect(), turn }
    }

    /// Blocks into which a motion of some axes has to be cut, so that the control turns each of them the way that is meant.
    pub(crate) fn pieces(&self, from: &[i64; MAX_AXES], to: &[i64; MAX_AXES], mask: u16) -> i64 {
        let pieces = |axis: &Wrapped| {
            let travel = (to[axis.index] - from[axis.index]).abs();
            match axis.wrap {
                // The short way is less than half a turn.
                Wrap::Positive | Wrap::Symmetric => 2 * travel / self.turn + 1,
                Wrap::Sign => travel / self.turn + 1,
            }
        };
        self.axes.iter().filter(|axis| mask & (1 << axis.index) != 0).map(pieces).max().unwrap_or(1)
    }

    /// The words of a block from where the axes stand.
    #[inline]
    pub(crate) fn spell(&mut self, from: &[i64; MAX_AXES], words: AxisWords) -> AxisWords {
        if self.axes.is_empty() { words } else { self.wrapped(from, words) }
    }

    #[cold]
    fn wrapped(&mut self, from: &[i64; MAX_AXES], words: AxisWords) -> AxisWords {
        let (turn, mut written) = (self.turn, words);
        for axis in self.axes.iter_mut().filter(|axis| words.has(axis.index)) {
            let (before, to) = (from[axis.index], words.units[axis.index]);
            let within = to.rem_euclid(turn);
            let spelled = match axis.wrap {
                Wrap::Positive => within,
                Wrap::Symmetric if 2 * within > turn => within - turn,
                Wrap::Symmetric => within,
                Wrap::Sign if to == before && axis.last.is_some_and(|last| last.abs() % turn == within) => {
                    axis.last.unwrap_or(within)
                }
                // Zero has no sign, a whole turn has.
                Wrap::Sign if to < before && within == 0 => -turn,
                Wrap::Sign if to < before => -within,
                Wrap::Sign => within,
            };
            axis.last = Some(spelled);
            written.units[axis.index] = spelled;
        }
        written
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::config::Config;
    use crate::kinematics::Machine;
    use crate::motion::machines::Cb;

    /// The words of C for a row of positions in degrees.
    fn spelled(wrap: Wrap, degrees: &[i64]) -> Vec<i64> {
        let mut config = Config::default();
        config.motion.rotaries.wrap.insert('C', wrap);
        let rotary = Rotary { index: 0, lower: None, upper: None, rest: 0.0 };
        let mut speller = Speller::new(Cb::AXES, config.policy(), &[rotary], 360);
        let mut from = [0; MAX_AXES];
        degrees
            .iter()
            .map(|&to| {
                let mut words = AxisWords { units: [0; MAX_AXES], mask: 1, vector: None };
                words.units[0] = to;
                let spelled = speller.spell(&from, words).units[0];
                from[0] = to;
                spelled
            })
            .collect()
    }

    #[test]
    fn words_stay_within_a_turn() {
        let path = [0, 90, 180, 350, 360, 370, 725, 700, 360, 0, -10];
        assert_eq!(spelled(Wrap::Positive, &path), [0, 90, 180, 350, 0, 10, 5, 340, 0, 0, 350]);
        assert_eq!(spelled(Wrap::Symmetric, &path), [0, 90, 180, -10, 0, 10, 5, -20, 0, 0, -10]);
        assert_eq!(spelled(Wrap::Sign, &path), [0, 90, 180, 350, 0, 10, 5, -340, -360, -360, -350]);
        assert_eq!(spelled(Wrap::Sign, &[90, 90, 80, 80, 80]), [90, 90, -80, -80, -80]);
    }

    #[test]
    fn the_short_way_is_less_than_half_a_turn() {
        let pieces = |wrap, travel: i64| {
            let axes = vec![Wrapped { index: 0, wrap, last: None }];
            let mut to = [0; MAX_AXES];
            to[0] = travel;
            Speller { axes, turn: 360 }.pieces(&[0; MAX_AXES], &to, 1)
        };
        assert_eq!(
            [0, 179, 180, -180, 359, 360, 720].map(|travel| pieces(Wrap::Positive, travel)),
            [1, 1, 2, 2, 2, 3, 5]
        );
        assert_eq!([179, 359, 360].map(|travel| pieces(Wrap::Sign, travel)), [1, 1, 2]);
    }
}
