//! A pose into the words of its block.
//!
//! Rounding comes first: the rotary words are rounded, then the linear axes are computed for the *rounded* angles, so
//! that rounding an angle never moves the tip. Limits are compared with rounded values.

use nalgebra::{Point3, Vector3};

use crate::config::{Config, Units};
use crate::kinematics::{Axis, AxisKind, Branch, Joint, Limits, Machine, Pose, REACH_TOLERANCE, Side};
use crate::nc::whole_units;

use super::choose::{AngleScale, OutOfLimits, Rotary, choose};
use super::fault::Fault;
use super::step::{MAX_AXES, Words};
use super::travel::Travel;

/// Word units that floating-point noise of a limit may amount to.
const LIMIT_NOISE: f64 = 1e-6;

/// Cosine between tool axis and retract axis from which the two count as parallel.
const PARALLEL: f64 = 1.0 - 1e-12;

/// A turn of the first rotary below this does no harm near the pole, rad.
const NOTICEABLE_TURN: f64 = 0.01;

/// A feed motion that turns a rotary axis by more than this because of its limits swings the tool in the cut, rad.
const SWING: f64 = 1_f64.to_radians();

/// Where the machine stands: axis values and the words that put it there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Place<A> {
    /// The pose as programmed.
    pub(crate) pose: Pose,
    /// Axis values that the words stand for, mm and rad.
    pub(crate) axes: A,
    /// Whole units of the words, by position in the chain.
    pub(crate) words: [i64; MAX_AXES],
    /// Angle between the programmed axis and the one reached, rad.
    pub(crate) deviation: f64,
    /// So near the pole that the first rotary kept its value.
    pub(crate) near_pole: bool,
    /// How far rounding of the linear words takes the tip at most, mm.
    pub(crate) rounding: f64,
}

/// Puts poses into words for one machine, one set-up and the current tool.
#[derive(Debug, Clone)]
pub(crate) struct Placer<M: Machine> {
    pub(super) machine: M,
    part_origin: Vector3<f64>,
    pub(super) rotaries: Vec<Rotary>,
    /// The same axes without their limits.
    endless: Vec<Rotary>,
    pub(super) limited: bool,
    linear_mask: u16,
    rotary_mask: u16,
    pub(super) scale: AngleScale,
    /// Units of linear words in 1 mm.
    per_mm: f64,
    pub(super) limits: Vec<Option<Limits>>,
    pub(crate) travel: Travel,
    /// Solved linear axis that retracts.
    retract_axis: usize,
    /// Component of the tool axis along that axis' positive word, at the zero position.
    retract_share: f64,
    straight: bool,
    head: bool,
    square: bool,
    /// The linear axes are square to each other, whatever the rotaries do.
    orthogonal: bool,
}

impl<M: Machine> Placer<M> {
    pub(crate) fn new(machine: M, config: &Config, units: Units) -> Self {
        let axes = &M::AXES[..M::AXES.len().min(MAX_AXES)];
        let scale = AngleScale::new(config.formats.rotary);
        let limits = config.travel::<M>().limits;
        let solved = |kind: AxisKind| {
            axes.iter().enumerate().filter(move |(_, axis)| axis.kind == kind && !axis.held).map(|(index, _)| index)
        };
        let mask = |kind: AxisKind| solved(kind).fold(0_u16, |mask, index| mask | 1 << index);
        let rotaries: Vec<Rotary> = solved(AxisKind::Rotary)
            .map(|index| {
                let word = |angle: f64| angle.to_degrees() * scale.per_degree;
                Rotary {
                    index,
                    lower: limits[index].map(|limits| (word(limits.lower) - LIMIT_NOISE).ceil() as i64),
                    upper: limits[index].map(|limits| (word(limits.upper) + LIMIT_NOISE).floor() as i64),
                }
            })
            .collect();
        let tool_axis = machine.tool_axis();
        let share = |index: usize| {
            let joint = machine.joint(index);
            joint.direction.dot(&tool_axis) * joint.sign
        };
        // `max_by` keeps the last of equals; nearer the tool is later on the tool side, and the tool side is later.
        let retract_axis = solved(AxisKind::Linear)
            .max_by(|&a, &b| {
                let (a, b) = (share(a).abs(), share(b).abs());
                if (a - b).abs() < 1e-9 { std::cmp::Ordering::Equal } else { a.total_cmp(&b) }
            })
            .unwrap_or_default();
        let head = axes.iter().any(|axis| axis.kind == AxisKind::Rotary && !axis.held && axis.side == Side::Tool);
        let per_unit = match units {
            Units::Millimetres => 10_f64.powi(config.formats.linear_mm as i32),
            Units::Inches => 10_f64.powi(config.formats.linear_inch as i32),
        };
        Self {
            part_origin: config.part_origin.into(),
            endless: rotaries.iter().map(|rotary| Rotary { lower: None, upper: None, ..*rotary }).collect(),
            limited: rotaries.iter().any(|rotary| rotary.lower.is_some() || rotary.upper.is_some()),
            rotaries,
            linear_mask: mask(AxisKind::Linear),
            rotary_mask: mask(AxisKind::Rotary),
            scale,
            per_mm: per_unit / units.in_mm(),
            limits,
            travel: Travel::new(&machine, config),
            retract_axis,
            retract_share: share(retract_axis),
            straight: !head && held_tool_axis(&machine).dot(&machine.joint(retract_axis).direction).abs() >= PARALLEL,
            head,
            square: orthogonal(&machine, axes) && counted(axes),
            orthogonal: orthogonal(&machine, axes),
            machine,
        }
    }

    /// Solved rotary axes stand on the tool side: the tool's length moves the linear axes.
    pub(crate) fn head(&self) -> bool {
        self.head
    }

    /// Solved rotary axes stand in the table.
    pub(crate) fn turning_table(&self) -> bool {
        M::AXES.iter().any(|axis| axis.kind == AxisKind::Rotary && !axis.held && axis.side == Side::Workpiece)
    }

    /// Going out along the retract axis is going out along the tool axis, whatever the rotaries do.
    pub(crate) fn straight(&self) -> bool {
        self.straight
    }

    /// The path length of the linear words is that of the tip while no rotary moves.
    pub(crate) fn square(&self) -> bool {
        self.square
    }

    pub(crate) fn retract_axis(&self) -> usize {
        self.retract_axis
    }

    pub(crate) fn linear_mask(&self) -> u16 {
        self.linear_mask
    }

    pub(crate) fn rotary_mask(&self) -> u16 {
        self.rotary_mask
    }

    /// A length in mm and words of one unit.
    pub(crate) fn unit_mm(&self) -> f64 {
        1.0 / self.per_mm
    }

    pub(crate) fn set_gauge_length(&mut self, length: Option<f64>) {
        self.machine.set_up(self.part_origin, length.unwrap_or(0.0));
        self.travel.set_gauge_length(length);
    }

    /// Largest turn of a rotary word, rad.
    #[inline]
    pub(crate) fn rotary_travel(&self, from: &[i64; MAX_AXES], to: &[i64; MAX_AXES]) -> f64 {
        let largest = self.rotaries.iter().map(|rotary| (to[rotary.index] - from[rotary.index]).abs()).max();
        self.scale.angle(largest.unwrap_or(0))
    }

    /// Words of the axes in a mask.
    #[inline]
    pub(crate) fn words(&self, place: &Place<M::Axes>, mask: u16) -> Words {
        Words { units: place.words, mask }
    }

    /// The place of a pose; `from` says where the rotaries come from and how the held axes stand.
    #[inline]
    pub(crate) fn place(&mut self, pose: &Pose, from: &Place<M::Axes>, feed: bool) -> Result<Place<M::Axes>, Fault> {
        let place = self.turn(pose, from, feed)?;
        self.finish(place)
    }

    /// The rotaries of a pose, chosen from where they stand. A feed motion is refused if only the limits make it take
    /// another branch or turn than the nearest: the tool is in the cut.
    #[inline]
    pub(crate) fn turn(&self, pose: &Pose, from: &Place<M::Axes>, feed: bool) -> Result<Place<M::Axes>, Fault> {
        let solutions = self.machine.inverse_kinematics(pose, &from.axes);
        if solutions.is_empty() {
            return Err(self.unreachable(pose, &from.axes));
        }
        let choice = choose(&solutions, &self.rotaries, &from.words, self.scale)
            .map_err(|outside| self.outside_limits(&outside))?;
        let solution = &solutions[choice.solution];
        let mut place = self.at(pose, from, &choice.words);
        place.axes = merged(solution.axes, &place.axes, self.rotary_mask);
        place.deviation = solution.deviation;
        self.steady(&mut place, from);
        if feed && self.limited && self.rotary_travel(&from.words, &place.words) > SWING {
            let nearest = choose(&solutions, &self.endless, &from.words, self.scale);
            if let Ok(nearest) = nearest
                && nearest.words != choice.words
                && !place.near_pole
                && !self.goes_on(from, &place, solution.branch)
            {
                return Err(self.jump(&from.words, &choice.words, &nearest.words));
            }
        }
        Ok(place)
    }

    /// Whether a place on this branch is reached without leaving the branch and by less than half a turn: linearisation
    /// certifies the way there, or refuses it.
    fn goes_on(&self, from: &Place<M::Axes>, to: &Place<M::Axes>, branch: Branch) -> bool {
        self.branch(from).is_none_or(|known| known == branch)
            && self.rotary_travel(&from.words, &to.words) <= std::f64::consts::PI
    }

    /// A pose with these rotary words; the linear axes are not computed.
    #[inline]
    pub(super) fn at(&self, pose: &Pose, from: &Place<M::Axes>, words: &[i64; MAX_AXES]) -> Place<M::Axes> {
        let mut place =
            Place { pose: *pose, axes: from.axes, words: *words, deviation: 0.0, near_pole: false, rounding: 0.0 };
        for rotary in &self.rotaries {
            place.axes.as_mut()[rotary.index] = self.scale.angle(words[rotary.index]);
        }
        place
    }

    /// The place of a pose with rotary words that were chosen beforehand; `None` if they do not belong to this pose.
    pub(crate) fn place_at(
        &mut self,
        pose: &Pose,
        from: &Place<M::Axes>,
        words: &[i64; MAX_AXES],
    ) -> Option<Result<Place<M::Axes>, Fault>> {
        let mut place = self.at(pose, from, words);
        let reached = self.machine.forward_kinematics(&place.axes).axis;
        if (reached.into_inner() - pose.axis.into_inner()).norm() > 2.0 * self.scale.angle(1) + REACH_TOLERANCE {
            return None;
        }
        let solutions = self.machine.inverse_kinematics(pose, &place.axes);
        place.deviation = solutions.first().map_or(0.0, |solution| solution.deviation);
        Some(self.finish(place))
    }

    /// Near the pole the axis of CL data carries no angle, only rounding: there the first rotary keeps its value.
    #[inline]
    fn steady(&self, place: &mut Place<M::Axes>, from: &Place<M::Axes>) {
        let [first, _] = self.rotaries[..] else { return };
        let turn = (place.words[first.index] - from.words[first.index]).abs();
        if self.scale.angle(turn) < NOTICEABLE_TURN {
            return;
        }
        let mut kept = place.axes;
        kept.as_mut()[first.index] = from.axes.as_ref()[first.index];
        let axis = self.machine.forward_kinematics(&kept).axis;
        if (axis.into_inner() - place.pose.axis.into_inner()).norm() <= REACH_TOLERANCE {
            place.axes = kept;
            place.words[first.index] = from.words[first.index];
            place.near_pole = true;
        }
    }

    /// The place of another tip with the rotaries of `at`.
    pub(crate) fn shifted(&mut self, tip: Point3<f64>, at: &Place<M::Axes>) -> Result<Place<M::Axes>, Fault> {
        let mut place = *at;
        place.pose.tip = tip;
        self.finish(place)
    }

    #[inline]
    fn finish(&mut self, place: Place<M::Axes>) -> Result<Place<M::Axes>, Fault> {
        let place = self.set(place)?;
        self.travel.check(place.axes.as_ref())?;
        Ok(place)
    }

    /// The linear words of a pose whose rotaries are known; the travel is not compared.
    #[inline]
    pub(super) fn set(&self, mut place: Place<M::Axes>) -> Result<Place<M::Axes>, Fault> {
        let Some(axes) = self.machine.linear_axes(&place.pose.tip, &place.axes) else {
            return Err(self.unreachable(&place.pose, &place.axes));
        };
        place.axes = axes;
        let (mut sum, mut squares) = (0.0, 0.0);
        for (index, value) in place.axes.as_mut().iter_mut().enumerate().take(MAX_AXES) {
            if self.linear_mask & (1 << index) != 0 {
                let Ok(units) = whole_units(*value, self.per_mm) else {
                    return Err(Fault::new(format_args!("{} is too large for a word", M::AXES[index].letter)));
                };
                place.words[index] = units;
                let written = units as f64 / self.per_mm;
                let off = written - *value;
                *value = written;
                sum += off.abs();
                squares += off * off;
            }
        }
        place.rounding = if self.orthogonal { squares.sqrt() } else { sum };
        Ok(place)
    }

    /// How far rounding of the linear words can take the tip, mm.
    pub(super) fn largest_rounding(&self) -> f64 {
        0.5 * self.unit_mm() * if self.orthogonal { 3_f64.sqrt() } else { 3.0 }
    }

    /// The rotaries of a pose that only says where motion counts from; `None` if it cannot be reached.
    pub(crate) fn reference(&self, pose: &Pose, from: &Place<M::Axes>) -> Option<Place<M::Axes>> {
        let solutions = self.machine.inverse_kinematics(pose, &from.axes);
        let choice = choose(&solutions, &self.rotaries, &from.words, self.scale).ok()?;
        let mut place = *from;
        for rotary in &self.rotaries {
            place.words[rotary.index] = choice.words[rotary.index];
            place.axes.as_mut()[rotary.index] = self.scale.angle(choice.words[rotary.index]);
        }
        Some(place)
    }

    /// Every rotary at zero and held axes at their values.
    pub(crate) fn zero(&self) -> Place<M::Axes> {
        let pose = Pose { tip: Point3::origin(), axis: self.machine.tool_axis() };
        Place { pose, axes: M::HELD, words: [0; MAX_AXES], deviation: 0.0, near_pole: false, rounding: 0.0 }
    }

    /// Words of a linear axis at a machine coordinate.
    pub(crate) fn machine_words(&self, index: usize, coordinate: f64) -> Result<Words, Fault> {
        self.travel.check_machine(index, coordinate)?;
        let units = whole_units(coordinate, self.per_mm)
            .map_err(|_| Fault::new(format_args!("{} is too large for a word", M::AXES[index].letter)))?;
        let mut words = Words { units: [0; MAX_AXES], mask: 1 << index };
        words.units[index] = units;
        Ok(words)
    }

    /// Words of the machine retract. The end of the travel at the part is no place to retract to.
    pub(crate) fn retract_words(&self, coordinate: f64) -> Result<Words, Fault> {
        let index = self.retract_axis;
        let part_end = |limits: Limits| if self.retract_share > 0.0 { limits.lower } else { limits.upper };
        if self.limits[index].is_some_and(|limits| (coordinate - part_end(limits)).abs() < self.unit_mm()) {
            return Err(Fault::new(format_args!(
                "the retract position {} = {coordinate} mm (machine coordinate) is the end of the travel at the part",
                M::AXES[index].letter
            ))
            .help("give `retract.position` in the configuration, the machine coordinate away from the part"));
        }
        self.machine_words(index, coordinate)
    }

    /// Words of a rotary at an angle, inside its limits.
    pub(crate) fn rotary_words(&self, index: usize, angle: f64) -> Result<Words, Fault> {
        let mut words = Words { units: [0; MAX_AXES], mask: 1 << index };
        words.units[index] = self.scale.word(angle);
        let rotary = self.rotaries.iter().find(|rotary| rotary.index == index);
        match rotary {
            Some(rotary)
                if rotary.lower.is_some_and(|lower| words.units[index] < lower)
                    || rotary.upper.is_some_and(|upper| words.units[index] > upper) =>
            {
                Err(self.outside_limits(&[Some(OutOfLimits { rotary: *rotary, word: words.units[index] }), None]))
            }
            _ => Ok(words),
        }
    }

    /// How far below the machine retract a place stands along the tool axis of the zero position, mm; `None` if that
    /// cannot be known.
    pub(crate) fn below_retract(&self, place: &Place<M::Axes>, retract: f64) -> Option<f64> {
        let there = self.travel.value_at(self.retract_axis, retract)?;
        Some((there - place.axes.as_ref()[self.retract_axis]) * self.retract_share.signum())
    }
}

/// The axes of `base`, and those of `mask` from `chosen`.
#[inline]
fn merged<A: AsRef<[f64]> + AsMut<[f64]>>(mut base: A, chosen: &A, mask: u16) -> A {
    for (index, value) in base.as_mut().iter_mut().enumerate().take(MAX_AXES) {
        if mask & (1 << index) != 0 {
            *value = chosen.as_ref()[index];
        }
    }
    base
}

/// The tool axis in the machine frame with the solved axes at zero and the held ones at their values.
fn held_tool_axis<M: Machine>(machine: &M) -> Vector3<f64> {
    let mut axis = machine.tool_axis().into_inner();
    for (index, described) in M::AXES.iter().enumerate().rev() {
        if described.kind == AxisKind::Rotary && described.held && described.side == Side::Tool {
            axis = turned(&machine.joint(index), M::HELD.as_ref()[index], &axis);
        }
    }
    axis
}

fn turned(joint: &Joint, angle: f64, vector: &Vector3<f64>) -> Vector3<f64> {
    nalgebra::Rotation3::from_axis_angle(&joint.direction, joint.sign * angle) * vector
}

/// Linear directions that are square to each other and stay so, because no rotary stands between two of them.
fn orthogonal<M: Machine>(machine: &M, axes: &[Axis]) -> bool {
    let solved = solved_linear(axes);
    let square = solved.iter().enumerate().all(|(position, &a)| {
        solved[position + 1..]
            .iter()
            .all(|&b| machine.joint(a).direction.dot(&machine.joint(b).direction).abs() < 1e-12)
    });
    let (Some(&first), Some(&last)) = (solved.first(), solved.last()) else { return false };
    square && axes[first..=last].iter().all(|axis| axis.kind == AxisKind::Linear)
}

/// X Y Z: along U V W no control counts F in a block that moves one of these.
fn counted(axes: &[Axis]) -> bool {
    solved_linear(axes).iter().all(|&index| matches!(axes[index].letter, 'X' | 'Y' | 'Z'))
}

fn solved_linear(axes: &[Axis]) -> Vec<usize> {
    (0..axes.len()).filter(|&index| axes[index].kind == AxisKind::Linear && !axes[index].held).collect()
}

#[cfg(test)]
mod tests {
    use super::super::machines::{Ay, Cb, Head, Xyz};
    use super::*;

    fn placer<M: Machine>() -> Placer<M> {
        let config = Config::default();
        Placer::new(config.machine::<M>().expect("valid"), &config, Units::Millimetres)
    }

    #[test]
    fn the_retract_axis_is_the_one_along_the_tool() {
        assert_eq!(placer::<Cb>().retract_axis(), 4);
        assert_eq!(placer::<Head>().retract_axis(), 2);
        assert_eq!(placer::<Ay>().retract_axis(), 3);
        assert_eq!(placer::<Xyz>().retract_axis(), 2);
    }

    #[test]
    fn only_a_machine_without_a_rotary_in_the_head_retracts_straight() {
        assert!(placer::<Cb>().straight() && placer::<Ay>().straight() && placer::<Xyz>().straight());
        assert!(!placer::<Head>().straight() && placer::<Head>().head());
    }
}
