//! Properties of the axes of a machine in its set-up, computed once: solved rotary and linear axes, poles, speeds.
//!
//! Plain data, constant after the placer has been created.

use nalgebra::UnitVector3;

use super::chain::{coordinates, held_tool_axis, orthogonal, poles, xyz_only};
use super::datum::Datum;
use crate::kinematics::math::LARGEST_SHIFTED;
use crate::kinematics::{AngleScale, AnyMachine, Axis, AxisKind, AxisUnits, LinearScale, REACH_TOLERANCE, Rotary};
use crate::motion::policy::Policy;
use crate::motion::rotary::RotaryMetric;
use crate::nc::{Overflow, whole_units};
use crate::program::Units;
use crate::tolerance::writer::{EQUAL_TOOL_SHARE, RETRACT_ALONG_TOOL, UNIT_VECTOR_NOISE, WORD_NOISE};

/// The solved rotary axes.
#[derive(Debug, Clone)]
pub(crate) struct RotaryAxes {
    pub(crate) axes: Vec<Rotary>,
    /// The same axes without their limits.
    pub(crate) endless: Vec<Rotary>,
    /// At least one axis has limits.
    pub(crate) limited: bool,
    /// Bit `i` for the axis at position `i`.
    pub(crate) mask: u16,
    /// Mask of the axes whose words stay within one revolution.
    pub(crate) wrapped: u16,
    /// Indexed axes, and their steps in whole units.
    pub(crate) grid: Vec<(Rotary, i64)>,
    pub(crate) scale: AngleScale,
    /// Largest rotation of the tool axis by the rounding of the words at both ends of a block.
    pub(crate) rounding_rad: f64,
    pub(crate) metric: RotaryMetric,
}

/// Reachable tool axes at which the angle of the first rotary axis is free.
#[derive(Debug, Clone)]
pub(crate) struct Poles {
    pub(crate) axes: Vec<UnitVector3<f64>>,
    /// Largest angle to a pole at which the tool axis counts as being at the pole.
    pub(crate) tolerance_rad: f64,
}

/// The solved linear axes.
#[derive(Debug, Clone)]
pub(crate) struct LinearAxes {
    /// Bit `i` for the axis at position `i`.
    pub(crate) mask: u16,
    /// Positions in the chain, in its order.
    pub(crate) solved: Vec<usize>,
    /// Resolution and range of their words.
    pub(crate) scale: LinearScale,
    /// One unit, mm.
    pub(crate) unit_mm: f64,
    /// Positions of X Y Z in the chain, if these are the solved linear axes.
    pub(crate) xyz: Option<[usize; 3]>,
    /// Position of the retract axis.
    pub(crate) retract_axis: usize,
    /// Component of the tool axis along the positive direction of the retract axis, at the zero position.
    pub(crate) retract_share: f64,
    /// A retract along the retract axis, outside tip control and planes, is one along the tool axis at any rotary
    /// angles.
    pub(crate) retracts_along_tool: bool,
    /// The path length that the control computes from the words equals that of the tip.
    pub(crate) keeps_path_length: bool,
}

impl LinearAxes {
    /// Word of an axis value in whole units, and the axis value of the rounded word, mm. `shift_mm`: word minus axis
    /// value.
    #[inline]
    pub(crate) fn rounded(&self, value_mm: f64, shift_mm: f64) -> Result<(i64, f64), Overflow> {
        let units = whole_units(value_mm + shift_mm, self.scale.units_per_mm)?;
        Ok((units, units as f64 / self.scale.units_per_mm - shift_mm))
    }
}

/// Largest speeds, mm/min and rad/min, by position in the chain.
#[derive(Debug, Clone)]
pub(crate) struct AxisSpeeds {
    pub(crate) per_axis: Vec<Option<f64>>,
    /// Feeds are limited by these speeds.
    pub(crate) timed: bool,
}

/// Positions of the solved axes of one kind.
fn solved(chain: &'static [Axis], kind: AxisKind) -> impl Iterator<Item = usize> {
    chain.iter().enumerate().filter(move |(_, axis)| axis.kind == kind && !axis.held).map(|(index, _)| index)
}

/// Mask of the solved axes of one kind.
fn mask(chain: &'static [Axis], kind: AxisKind) -> u16 {
    solved(chain, kind).fold(0_u16, |mask, index| mask | 1 << index)
}

impl RotaryAxes {
    pub(crate) fn new(
        chain: &'static [Axis],
        policy: Policy<'_>,
        datum: &Datum,
        speeds: &[Option<f64>],
        scale: AngleScale,
    ) -> Self {
        let limits = policy.set_up.travel(chain).limits;
        let axes: Vec<Rotary> = solved(chain, AxisKind::Rotary)
            .map(|index| {
                let rest_deg = datum.rest_deg(index, scale);
                let word = |angle: f64| (angle.to_degrees() - rest_deg) * scale.units_per_degree;
                Rotary {
                    index,
                    lower: limits[index].map(|limits| (word(limits.lower) - WORD_NOISE).ceil() as i64),
                    upper: limits[index].map(|limits| (word(limits.upper) + WORD_NOISE).floor() as i64),
                    rest_deg,
                }
            })
            .collect();
        let rotaries = &policy.options.rotaries;
        let is_wrapped = |rotary: &&Rotary| rotaries.wrap.contains_key(&chain[rotary.index].letter);
        let speed = |axis: usize| axes.get(axis).and_then(|rotary| speeds[rotary.index]);
        Self {
            endless: axes.iter().map(|rotary| rotary.without_limits()).collect(),
            limited: axes.iter().any(|rotary| !rotary.endless()),
            mask: mask(chain, AxisKind::Rotary),
            wrapped: axes.iter().filter(is_wrapped).fold(0, |mask, rotary| mask | 1 << rotary.index),
            grid: grid(chain, policy, &axes, scale),
            metric: RotaryMetric::new(&axes, [0, 1].map(speed), scale),
            scale,
            rounding_rad: scale.angle(1) * axes.len() as f64,
            axes,
        }
    }
}

impl LinearAxes {
    /// `head`: a rotary axis moves the tool; `bounds`: exclusive bounds of the absolute words.
    pub(crate) fn new(
        machine: &dyn AnyMachine,
        policy: Policy<'_>,
        units: Units,
        head: bool,
        bounds: &AxisUnits,
    ) -> Self {
        let axes = machine.axes();
        let tool_axis = machine.tool_axis();
        let share = |index: usize| {
            let joint = machine.joint(index);
            joint.direction.dot(&tool_axis) * joint.sign
        };
        // `max_by` keeps the last of equals: the tool side comes last in the chain, and there the axis nearest the
        // tool.
        let retract_axis = solved(axes, AxisKind::Linear)
            .max_by(|&a, &b| {
                let (a, b) = (share(a).abs(), share(b).abs());
                if (a - b).abs() < EQUAL_TOOL_SHARE { std::cmp::Ordering::Equal } else { a.total_cmp(&b) }
            })
            .unwrap_or_default();
        let along_tool =
            held_tool_axis(machine).dot(&machine.joint(retract_axis).direction).abs() >= RETRACT_ALONG_TOOL;
        let units_per_mm = 10_f64.powi(policy.formats.linear(units) as i32) / units.in_mm();
        let orthogonal = orthogonal(machine, axes);
        Self {
            mask: mask(axes, AxisKind::Linear),
            solved: solved(axes, AxisKind::Linear).collect(),
            scale: LinearScale {
                units_per_mm,
                orthogonal,
                most_units: bounds.map(|bound| (bound as f64).min(LARGEST_SHIFTED) - 0.5),
            },
            unit_mm: 1.0 / units_per_mm,
            xyz: coordinates(axes),
            retract_axis,
            retract_share: share(retract_axis),
            retracts_along_tool: !head && along_tool,
            keeps_path_length: orthogonal && xyz_only(axes),
        }
    }
}

impl Poles {
    /// `least_rad`: smallest tolerance.
    pub(crate) fn new(machine: &dyn AnyMachine, policy: Policy<'_>, rotaries: &[Rotary], least_rad: f64) -> Self {
        let tolerance_rad = policy.options.course.axis_tolerance_rad.max(REACH_TOLERANCE).max(least_rad);
        Self { axes: poles(machine, rotaries), tolerance_rad }
    }

    /// Whether the square of the distance of a tool axis from each pole is certainly larger than this. For a quick
    /// answer: where it is not certain, the poles are to be compared one by one.
    #[inline(always)]
    pub(crate) fn are_farther(&self, axis: &UnitVector3<f64>, square: f64) -> bool {
        // The second one is opposite.
        self.axes.first().is_none_or(|pole| 2.0 - 2.0 * pole.dot(axis).abs() > square + UNIT_VECTOR_NOISE)
    }
}

/// Indexed rotary axes and their steps in whole units.
fn grid(chain: &'static [Axis], policy: Policy<'_>, rotaries: &[Rotary], scale: AngleScale) -> Vec<(Rotary, i64)> {
    let step =
        |rotary: &Rotary| Some((*rotary, scale.word(*policy.options.rotaries.grid.get(&chain[rotary.index].letter)?)));
    rotaries.iter().filter_map(step).collect()
}
