//! Whether the axes stay within their travel.
//!
//! Rotary limits are axis values; linear ones machine coordinates, `machine_zero + value + what the tool adds`. Where the
//! machine zero is not known only the span of a linear axis is compared.

use super::read::MAX_AXES;
use super::words::Words;
use crate::config::Config;
use crate::kinematics::{AxisKind, Limits, Machine};

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

    /// The first axis that leaves its travel where the words say.
    pub(super) fn check(&mut self, words: &Words, values: &[f64; MAX_AXES], known: u16) -> Option<String> {
        for axis in self.axes.iter_mut().filter(|axis| known & (1 << axis.index) != 0) {
            let gauge = if axis.rotary { 0.0 } else { words.gauge_of(axis.index) };
            let value = values[axis.index] + gauge;
            let place = match (axis.rotary, axis.zero) {
                (true, _) => value,
                (false, Some(zero)) => zero + value,
                (false, None) => {
                    axis.span = (axis.span.0.min(value), axis.span.1.max(value));
                    let (span, travel) = (axis.span.1 - axis.span.0, axis.limits.upper - axis.limits.lower);
                    if span <= travel + NOISE {
                        continue;
                    }
                    return Some(format!("{} needs {span:.3} mm of travel, there are {travel:.3} mm", axis.letter));
                }
            };
            if let Some(text) = axis.outside(place) {
                return Some(text);
            }
        }
        None
    }

    /// The same for a machine coordinate.
    pub(super) fn check_machine(&self, index: usize, coordinate: f64) -> Option<String> {
        self.axes.iter().find(|axis| axis.index == index)?.outside(coordinate)
    }
}

impl Axis {
    fn outside(&self, place: f64) -> Option<String> {
        let Limits { lower, upper } = self.limits;
        if (lower - NOISE..=upper + NOISE).contains(&place) {
            return None;
        }
        let shown = |value: f64| if self.rotary { value.to_degrees() } else { value };
        let [place, lower, upper] = [place, lower, upper].map(shown);
        Some(format!("{} goes to {place:.4}, its limits are {lower:.4} to {upper:.4}", self.letter))
    }
}
