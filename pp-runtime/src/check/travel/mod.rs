//! Travel limits.
//!
//! Rotary limits are axis values; linear ones machine coordinates, `machine_zero + value + share of the gauge length`.
//! Where the machine zero is unknown only the span of a linear axis is compared with its travel.
//!
//! Limits are a box of axis values, and so is the region that the axes may pass in a rapid in which each moves on its
//! own: if both ends are inside, all of it is. That holds for every straight block whose words are axis values, and in
//! a tilted plane. It does not hold for arcs, nor under tip control, where linear axes follow the rotary ones: `within`
//! finds the extreme of each axis there, and `rapid` those of a rapid under tip control whose axes do not arrive
//! together.
//!
//! The tip in a rapid is not judged here: `compare/clear` compares it with the clearance geometry.

mod rapid;
mod within;

use nalgebra::Vector3;

use super::geometry::{Extent, ToolPose};
use super::read::{Block, MAX_AXES, TipControl};
use super::report::{ShownBlock, Tally};
use super::rules::{MachineWords, Rules, sweep};
use crate::check::tolerances::AXIS_VALUE_NOISE;
use crate::diag::code::check;
use crate::kinematics::{Axis, AxisKind, Limits};
use crate::program::Location;

/// An axis with limits.
#[derive(Debug, Clone, Copy)]
struct LimitedAxis {
    index: usize,
    letter: char,
    rotary: bool,
    limits: Limits,
    /// Machine coordinate at the zero position, mm.
    machine_zero_mm: Option<f64>,
    /// Smallest and largest value so far.
    span: (f64, f64),
}

/// Every axis with limits, and the rotary axes as the control has rotated them.
#[derive(Debug, Clone, Default)]
pub(super) struct Travel {
    axes: Vec<LimitedAxis>,
    /// Words with the rotary axes as the control has rotated them, where that is known.
    rotated: Option<[f64; MAX_AXES]>,
    /// Between its ends a block may leave its path by the tolerance, mm.
    path_tolerance_mm: f64,
}

/// Findings about one block.
pub(super) struct Findings<'t> {
    pub(crate) tally: &'t mut Tally,
    pub(crate) at: Location,
    pub(crate) shown: ShownBlock<'t>,
}

impl Findings<'_> {
    fn outside(&mut self, text: &str) {
        self.tally.outside_limits(check::LIMITS, self.at, self.shown, text);
    }
}

impl Travel {
    pub(super) fn new(rules: &Rules<'_>) -> Self {
        let set_up = &rules.policy().set_up;
        let limits = set_up.travel(rules.axes()).limits;
        let solved = rules.words().linear_bits() | rules.words().rotary_bits();
        let limited = |(index, axis): (usize, &Axis)| {
            let limits = limits[index].filter(|_| solved & (1 << index) != 0)?;
            Some(LimitedAxis {
                index,
                letter: axis.letter,
                rotary: axis.kind == AxisKind::Rotary,
                limits,
                machine_zero_mm: set_up.machine_zero.get(&axis.letter).copied(),
                span: (f64::INFINITY, f64::NEG_INFINITY),
            })
        };
        Self {
            axes: rules.axes().iter().enumerate().filter_map(limited).collect(),
            rotated: None,
            path_tolerance_mm: rules.policy().largest_path_mm(),
        }
    }

    /// Whether any axis has limits.
    pub(super) fn is_limited(&self) -> bool {
        !self.axes.is_empty()
    }

    /// A block in machine coordinates: the control does not rotate the axes to a tool axis.
    pub(super) fn machine_block(&mut self, rules: &Rules<'_>, block: &Block) {
        let rotary = rules.words().rotary_bits();
        if block.known & rotary != rotary {
            self.rotated = None;
        }
    }

    /// Any other block that moves, from the words before it.
    pub(super) fn block(
        &mut self,
        rules: &Rules<'_>,
        (before, known): (&[f64; MAX_AXES], u16),
        block: &Block,
        mut findings: Findings<'_>,
    ) {
        if !self.is_limited() {
            return;
        }
        self.within(rules, (before, known), block, &mut findings);
        self.at_end(rules, block, &block.values, &mut findings);
    }

    /// Whether the axes are within their limits with some words in the state of a block.
    pub(super) fn at_end(
        &mut self,
        rules: &Rules<'_>,
        block: &Block,
        at: &[f64; MAX_AXES],
        findings: &mut Findings<'_>,
    ) {
        let words = rules.words();
        let solved = words.linear_bits() | words.rotary_bits();
        let direct = !block.state.has_frame();
        if !self.is_limited() || !(direct || block.known & solved == solved) {
            return;
        }
        let by_control = block.state.vector.is_some();
        let text = if direct && !by_control {
            self.judge_known(block, words, |index| words.value(index, at[index]))
        } else {
            let rotated = if by_control { self.rotated } else { Some(*at) };
            let values = rotated.and_then(|rotated| words.axes_with_rotary(&rotated, &block.state));
            values.and_then(|values| self.judge_known(block, words, |index| values[index]))
        };
        if let Some(text) = text {
            findings.outside(&text);
        }
    }

    /// What is wrong with the values of the axes whose words are known.
    fn judge_known(&mut self, block: &Block, words: &MachineWords, value: impl Fn(usize) -> f64) -> Option<String> {
        let mut axes = self.axes.iter_mut().filter(|axis| block.known & (1 << axis.index) != 0);
        axes.find_map(|axis| axis.judge(value(axis.index), words, AXIS_VALUE_NOISE))
    }

    /// What is wrong with a machine coordinate.
    pub(super) fn machine_coordinate(&self, index: usize, coordinate: f64) -> Option<String> {
        self.axes.iter().find(|axis| axis.index == index)?.outside(coordinate, AXIS_VALUE_NOISE)
    }

    /// Values within which nothing is outside and no span grows.
    fn quiet(&self, words: &MachineWords) -> Extent {
        let mut quiet = Extent { low: [f64::NEG_INFINITY; MAX_AXES], high: [f64::INFINITY; MAX_AXES] };
        for axis in &self.axes {
            let ((low, high), zero) = (axis.bounds(), axis.zero_mm(words));
            (quiet.low[axis.index], quiet.high[axis.index]) = (low - zero, high - zero);
        }
        quiet
    }

    /// Whether a rotary axis is outside its limits.
    fn rotary_outside(&self, values: &[f64; MAX_AXES]) -> bool {
        let mut rotary = self.axes.iter().filter(|axis| axis.rotary);
        rotary.any(|axis| axis.outside(values[axis.index], AXIS_VALUE_NOISE).is_some())
    }

    /// Axes with limits: bits.
    fn bits(&self) -> u16 {
        self.axes.iter().fold(0, |bits, axis| bits | 1 << axis.index)
    }

    /// Reports each axis that leaves its limits within a block, farther than at the ends of the block.
    fn judge(
        &mut self,
        words: &MachineWords,
        extent: &Extent,
        ends: [&[f64; MAX_AXES]; 2],
        place: &str,
        findings: &mut Findings<'_>,
    ) {
        let slack = self.path_tolerance_mm;
        for axis in &mut self.axes {
            for side in [1.0, -1.0] {
                let farthest = extent.bound(axis.index, side);
                if ends.iter().all(|end| farthest > side * end[axis.index] + AXIS_VALUE_NOISE)
                    && let Some(text) = axis.judge(side * farthest, words, slack)
                {
                    findings.outside(&format!("{place}{text}"));
                }
            }
        }
    }
}

impl LimitedAxis {
    /// Machine coordinate less axis value, mm.
    fn zero_mm(&self, words: &MachineWords) -> f64 {
        if self.rotary { 0.0 } else { self.machine_zero_mm.unwrap_or(0.0) + words.gauge_of(self.index) }
    }

    /// Its limits; the span so far where the machine zero is unknown.
    fn bounds(&self) -> (f64, f64) {
        let known = self.rotary || self.machine_zero_mm.is_some();
        if known { (self.limits.lower, self.limits.upper) } else { self.span }
    }

    /// What is wrong with an axis value, beyond `slack`.
    fn judge(&mut self, value: f64, words: &MachineWords, slack: f64) -> Option<String> {
        let coordinate = value + self.zero_mm(words);
        if self.rotary || self.machine_zero_mm.is_some() {
            return self.outside(coordinate, slack);
        }
        self.span = (self.span.0.min(coordinate), self.span.1.max(coordinate));
        let (span, travel) = (self.span.1 - self.span.0, self.limits.upper - self.limits.lower);
        (span > travel + slack)
            .then(|| format!("{} needs {span:.3} mm of travel, its limits allow {travel:.3} mm", self.letter))
    }

    fn outside(&self, coordinate: f64, slack: f64) -> Option<String> {
        let Limits { lower, upper } = self.limits;
        let slack = if self.rotary { AXIS_VALUE_NOISE } else { slack };
        if (lower - slack..=upper + slack).contains(&coordinate) {
            return None;
        }
        let shown = |value: f64| if self.rotary { value.to_degrees() } else { value };
        let [coordinate, lower, upper] = [coordinate, lower, upper].map(shown);
        Some(format!("{} moves to {coordinate:.4}, outside its limits {lower:.4} to {upper:.4}", self.letter))
    }
}
