//! Rapids and the clearance geometry.
//!
//! A control that does not interpolate rapids moves each axis of the machine at its own speed, and the axes arrive in
//! any order. The tip may then be at every point of the box of the axis values between the ends of a block, rotary axes
//! included. That box is bounded as a whole, not sampled, and compared with the geometry in force, in the part as it is
//! mounted. A finding is
//! - a rapid at the part whose tip may be in the geometry, although the straight line from end to end is outside it. A
//!   line that leads into it is what the CL data asks for, and so is one along the tool axis, or it is the retract,
//!   whose length is compared; with `transition = "direct"` all are as in the CL data;
//! - the last block of an approach, if the tip may be deeper in the geometry than on its last part along the retract
//!   axis. It comes from the retract position, which is above at an unknown height; the other axes are where they were
//!   before it.
//!
//! A block that moves a single linear axis of the machine is a line in any case. Not judged, because the position
//! before them is unknown or has another meaning, or nothing is near: steps at the retract position; an approach after
//! a tool change, in a tilted plane or under tip control, for which the order of the approach is compared; the motion
//! from hole to hole of a cycle of the control; rapids to a tool axis by its components, for which the control chooses
//! the angles.

use super::super::geometry::{angle_between, depth_of_box, depth_of_line, size};
use super::super::policy::LinearMeaning;
use super::super::read::{Block, MAX_AXES};
use super::super::rules::Rules;
use super::{Comparison, Phase, Previous};
use crate::check::tolerances::SAME_AXIS_VALUE;
use crate::program::Clearance;

/// Geometry that a rapid must stay out of.
#[derive(Debug, Clone, Copy)]
pub(super) struct KeepOut {
    clearance: Clearance,
    /// The rapid is a block of an approach.
    approaches: bool,
}

impl KeepOut {
    /// Geometry that a block must stay out of; `None` where it cannot run into it.
    pub(super) fn of(comparison: &Comparison<'_>, phase: &Phase, block: &Block) -> Option<Self> {
        let rules = &comparison.rules;
        if !block.action.is_rapid() || rules.policy().links.direct || rules.rapids_are_interpolated() {
            return None;
        }
        let (clearance, approaches) = match phase {
            Phase::Retracted(_) => (comparison.progress.next()?.required.clearance, true),
            Phase::Cutting(_) => (comparison.clearance().copied(), false),
            Phase::Unknown { .. } | Phase::Leaving(_) | Phase::Ended => return None,
        };
        Some(Self { clearance: clearance?, approaches })
    }

    /// What is wrong with a rapid that may lead the tip into the geometry.
    #[inline(never)]
    pub(super) fn fault(&self, rules: &Rules<'_>, previous: &Previous, block: &Block) -> Option<String> {
        let Self { clearance, approaches } = self;
        let [from, to] = self.ends_of_rapid(rules, previous, block)?;
        let (words, rounding) = (rules.words(), rules.rounding());
        let chain = words.chain();
        let ends = [&from, &to].map(|values| chain.place(values));
        let [start, end] = [ends[0].tip, ends[1].tip];
        let step = end - start;
        let accuracy_mm = 4.0 * rounding.tip_mm + 2.0 * step.norm() * rounding.axis_rad;
        let deepest = |allowed_mm: f64| depth_of_box(clearance, chain, [&from, &to], allowed_mm, accuracy_mm);
        let across_mm = (step - ends[1].axis * step.dot(&ends[1].axis)).norm();
        let holds_axis = angle_between(&ends[0].axis, &ends[1].axis) <= 2.0 * rounding.axis_rad;
        let along_axis = !approaches && holds_axis && across_mm <= accuracy_mm;
        if along_axis || deepest(0.0).is_none() {
            return None;
        }
        let straight_from = if *approaches { chain.place(&above(&to, &from, words.retract())).tip } else { start };
        let straight_mm = depth_of_line(clearance, &straight_from, &end);
        let asked_for = !approaches && straight_mm > accuracy_mm;
        let depth_mm = deepest(straight_mm.max(0.0)).filter(|_| !asked_for)?;
        let remedy = match approaches {
            true => "the retract axis must come down last",
            false => "post it with `rapid = \"feed\"`, or state `[control] linear_rapids`",
        };
        Some(format!(
            "if each axis of this rapid moves on its own, the tip may be {depth_mm:.3} mm deep in the clearance geometry: \
             {remedy}"
        ))
    }

    /// Axis values before and after a rapid that need not be straight. Before an approach the retract axis is as far
    /// out as leads out of the geometry.
    fn ends_of_rapid(&self, rules: &Rules<'_>, previous: &Previous, block: &Block) -> Option<[[f64; MAX_AXES]; 2]> {
        let words = rules.words();
        let (retract, solved) = (words.retract(), words.linear_bits() | words.rotary_bits());
        let needed = if self.approaches { solved & !(1 << retract) } else { solved };
        let comes_down = rules.meaning() == LinearMeaning::AxisPositions && block.written & (1 << retract) != 0;
        if self.approaches && !comes_down || previous.same_meaning & needed != needed || block.known & solved != solved
        {
            return None;
        }
        let to = words.axes(&block.values, &block.state)?;
        let mut from = words.axes(&previous.words, &block.state)?;
        if self.approaches {
            let out_mm = size(&self.clearance) + words.chain().place(&to).tip.norm();
            from[retract] = to[retract] + words.outwards() * out_mm;
        }
        let moved = |index: &usize| (from[*index] - to[*index]).abs() > SAME_AXIS_VALUE;
        let straight = (0..MAX_AXES).filter(moved).count() < 2 && !words.rotary().any(|index| moved(&index));
        (!straight).then_some([from, to])
    }
}

/// Axis values of a position, one axis at its value of another.
fn above(position: &[f64; MAX_AXES], other: &[f64; MAX_AXES], axis: usize) -> [f64; MAX_AXES] {
    std::array::from_fn(|index| if index == axis { other[index] } else { position[index] })
}
