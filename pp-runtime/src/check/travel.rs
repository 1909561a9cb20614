//! Whether the axes stay within their travel.
//!
//! Rotary limits are axis values; linear ones machine coordinates, `machine_zero + value + what the tool adds`. Where the
//! machine zero is not known only the span of a linear axis is compared.
//!
//! Limits are a box of axis values, and so is what the axes may run through in a G0 in which each goes as fast as it can:
//! where both of its ends are inside, all of it is. That holds for every straight block whose words are axis values, and in
//! a tilted plane, whose words are axis values turned. It does not hold for arcs, which are looked at along their way, nor
//! under tip control, where linear axes follow the rotary ones: the way is looked at there, and for a G0 that need not be
//! interpolated every pair of rotary values on it, at every corner of the box of the linear words. For a pair of
//! rotary values linear axes are affine in the words, so that corners suffice.
//!
//! What the tip does in a G0 that turns rotary axes at the part is not judged: with `transition = "safe"` there is none
//! beyond the index angle, and who writes `"direct"` has the CL data answer for it.

use std::io::Read;

use super::compare::Checker;
use super::follow::{between, places, sweep};
use super::read::{Action, Block, Family, MAX_AXES, TipControl};
use super::report::Shown;
use super::words::Words;
use crate::config::{Config, ToolPosture};
use crate::kinematics::{AxisKind, Limits, Machine};

/// Rotary values of a G0 that are paired are no farther apart than this, rad, unless they would be more than so many.
const PAIRED: f64 = 0.05;
const MOST_PAIRED: f64 = 60.0;

/// Noise of sums that must not turn an inclusive limit into an exclusive one, mm and rad.
const NOISE: f64 = 1e-6;

/// Travel of one axis.
#[derive(Debug, Clone, Copy)]
struct Axis {
    index: usize,
    letter: char,
    rotary: bool,
    limits: Limits,
    zero: Option<f64>,
    span: (f64, f64),
}

/// Travel of every axis that has limits.
#[derive(Debug, Clone, Default)]
pub(super) struct Travel {
    axes: Vec<Axis>,
}

impl Travel {
    pub(super) fn new<M: Machine>(_machine: &M, config: &Config, words: &Words) -> Self {
        let limits = config.travel::<M>().limits;
        let solved = words.linear_mask | words.rotary_mask;
        let axis = |(index, axis): (usize, &crate::kinematics::Axis)| {
            let limits = limits[index].filter(|_| solved & (1 << index) != 0)?;
            Some(Axis {
                index,
                letter: axis.letter,
                rotary: axis.kind == AxisKind::Rotary,
                limits,
                zero: config.machine_zero.get(&axis.letter).copied(),
                span: (f64::INFINITY, f64::NEG_INFINITY),
            })
        };
        Self { axes: M::AXES.iter().enumerate().filter_map(axis).collect() }
    }

    /// Whether any axis has limits.
    pub(super) fn limited(&self) -> bool {
        !self.axes.is_empty()
    }

    /// The first axis that leaves its travel by more than `slack` where the words say.
    fn check(&mut self, words: &Words, values: &[f64; MAX_AXES], known: u16, slack: f64) -> Option<String> {
        for axis in self.axes.iter_mut().filter(|axis| known & (1 << axis.index) != 0) {
            let gauge = if axis.rotary { 0.0 } else { words.gauge_of(axis.index) };
            let value = values[axis.index] + gauge;
            let place = match (axis.rotary, axis.zero) {
                (true, _) => value,
                (false, Some(zero)) => zero + value,
                (false, None) => {
                    axis.span = (axis.span.0.min(value), axis.span.1.max(value));
                    let (span, travel) = (axis.span.1 - axis.span.0, axis.limits.upper - axis.limits.lower);
                    if span <= travel + slack {
                        continue;
                    }
                    return Some(format!("{} needs {span:.3} mm of travel, there are {travel:.3} mm", axis.letter));
                }
            };
            if let Some(text) = axis.outside(place, slack) {
                return Some(text);
            }
        }
        None
    }

    /// The same for a machine coordinate.
    pub(super) fn check_machine(&self, index: usize, coordinate: f64) -> Option<String> {
        self.axes.iter().find(|axis| axis.index == index)?.outside(coordinate, NOISE)
    }
}

impl<M: Machine, R: Read> Checker<'_, M, R> {
    /// Whether the axes stay within their travel where a block ends.
    pub(super) fn limits(&mut self, block: &Block, shown: Shown<'_>) {
        let solved = self.words.linear_mask | self.words.rotary_mask;
        let direct = block.state.tip_control == TipControl::Off && block.state.tilt.is_none();
        if self.travel.limited() && (direct || block.known & solved == solved) {
            self.inside(block, &block.values, "", shown);
        }
    }

    /// Whether they do on its way from the block before.
    pub(super) fn limits_on_way(&mut self, block: &Block, shown: Shown<'_>) {
        let (before, known) = self.before;
        let solved = self.words.linear_mask | self.words.rotary_mask;
        if !self.travel.limited() || known & block.known & solved != solved {
            return;
        }
        let turned = match block.state.tip_control {
            TipControl::On { .. } => self.rotary_way(&before, &block.values),
            TipControl::Off => 0.0,
        };
        let sweep = sweep(block);
        if turned <= 0.0 && sweep <= 0.0 {
            return;
        }
        if block.action == Action::Rapid && !self.interpolates_rapids() {
            self.limits_of_pairs(block, shown);
        } else if self.config.tool_posture != ToolPosture::Plane || turned <= 0.0 {
            let places = places(turned + sweep);
            let mut place = 1.0;
            while place <= places {
                let words = between(&before, block, place / (places + 1.0), self.words.linear_places());
                if !self.inside(block, &words, "on its way ", shown) {
                    return;
                }
                place += 1.0;
            }
        }
    }

    /// All axes of a G0 arrive together, as in a feed motion, under tip control at least. On a Siemens they do while a
    /// transformation is active (programming manual of the Sinumerik One, RTLIOF), every straight line of a Heidenhain is
    /// one, and a G0 of LinuxCNC is coordinated; on a Fanuc parameter 1401#1 says so, on a Haas a setting.
    fn interpolates_rapids(&self) -> bool {
        let usual = !matches!(self.family, Family::Fanuc | Family::Haas);
        self.config.control.linear_rapids.unwrap_or(usual)
    }

    /// A G0 under tip control in which each rotary axis runs on its own, and so do the words of the tip.
    fn limits_of_pairs(&mut self, block: &Block, shown: Shown<'_>) {
        let before = self.before.0;
        let counts: [u32; MAX_AXES] = std::array::from_fn(|index| {
            let turned = (block.values[index] - before[index]).abs();
            let rotary = self.words.rotary_mask & (1 << index) != 0;
            if rotary { (turned / PAIRED).ceil().min(MOST_PAIRED) as u32 + 1 } else { 1 }
        });
        let pairs: u32 = counts.iter().product();
        let linear = self.words.linear_mask;
        for corner in (0..=linear).filter(|corner| corner & !linear == 0) {
            for pair in 0..pairs {
                let mut rest = pair;
                let words: [f64; MAX_AXES] = std::array::from_fn(|index| {
                    let (step, last) = (rest % counts[index], counts[index] - 1);
                    rest /= counts[index];
                    let share = match corner & (1 << index) {
                        0 if last == 0 => 0.0,
                        0 => f64::from(step) / f64::from(last),
                        _ => 1.0,
                    };
                    before[index] + (block.values[index] - before[index]) * share
                });
                if !self.inside(block, &words, "where each axis of this rapid runs on its own, ", shown) {
                    return;
                }
            }
        }
    }

    /// Whether the axes are within their travel at these words; says so if not.
    fn inside(&mut self, block: &Block, words: &[f64; MAX_AXES], place: &str, shown: Shown<'_>) -> bool {
        let Some(values) = self.words.axes(words, &block.state) else { return true };
        // Between its ends a block may leave its path by the tolerance.
        let slack = if place.is_empty() { NOISE } else { self.config.tolerance };
        let Some(text) = self.travel.check(&self.words, &values, block.known, slack) else { return true };
        self.tally.outcome.limits += 1;
        self.tally.found(self.served, shown, &format!("{place}{text}"), None);
        false
    }
}

impl Axis {
    fn outside(&self, place: f64, slack: f64) -> Option<String> {
        let Limits { lower, upper } = self.limits;
        let slack = if self.rotary { NOISE } else { slack };
        if (lower - slack..=upper + slack).contains(&place) {
            return None;
        }
        let shown = |value: f64| if self.rotary { value.to_degrees() } else { value };
        let [place, lower, upper] = [place, lower, upper].map(shown);
        Some(format!("{} goes to {place:.4}, its limits are {lower:.4} to {upper:.4}", self.letter))
    }
}
