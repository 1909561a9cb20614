//! A pose into the words of its block.
//!
//! Rounding comes first: the rotary words are rounded, then the linear axes are computed for the *rounded* angles, so
//! that rounding an angle never moves the tip. Limits are compared with rounded values.

mod axes;
mod chain;
mod datum;
mod frame;
mod linearise;
mod refusal;
mod tilted_plane;
mod tip;
mod travel;
mod turn;

use std::collections::BTreeMap;

use nalgebra::{Point3, UnitVector3, Vector3};

use crate::kinematics::{AnyMachine, Axis, AxisKind, AxisValues, Branch, Limits, Pose, Side};
use crate::motion::fault::Fault;
use crate::motion::options::{Mode, Policy, TcpWords};
use crate::motion::rotary::{AngleScale, Metric, OutOfLimits, Rotary, TurnTarget, Turns, choose};
use crate::motion::step::{AxisWords, MAX_AXES, ReachedPosition, VECTOR_DECIMALS};
use crate::nc::whole_units;
use crate::program::Units;
use crate::set_up::LengthMode;

pub use frame::{TipAbility, unsuited};
pub(crate) use linearise::{Linearised, Tolerance};
pub(crate) use refusal::limits_text;
pub use tilted_plane::{PlaneAbility, PlaneAngles, PoseRule};

use axes::{AxisSpeeds, LinearAxes, Poles, RotaryAxes};
pub(crate) use chain::rotaries as rotaries_of;
use datum::Datum;
use frame::WordFrame;
use travel::Travel;

/// Where the machine stands: axis values and the words that put it there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Place {
    /// The pose as programmed; near the pole with its axis.
    pub(crate) pose: Pose,
    /// Which answer of the inverse kinematics this is.
    pub(crate) branch: Branch,
    /// Axis values that the words stand for, mm and rad.
    pub(crate) axes: AxisValues,
    /// Whole units by position in the chain: words of linear axes, and axis values of rotary ones.
    pub(crate) words: [i64; MAX_AXES],
    /// Angle between the programmed axis and the one reached, rad.
    pub(crate) deviation: f64,
    /// The tool axis is parallel to the first rotary, which may turn freely.
    pub(crate) pole: bool,
    /// How far rounding of the linear words takes the tip at most, mm.
    pub(crate) rounding: f64,
}

/// Puts poses into words for one machine, one set-up and the current tool.
#[derive(Debug, Clone)]
pub(crate) struct Placer {
    machine: Box<dyn AnyMachine>,
    /// The axes of the machine.
    chain: &'static [Axis],
    /// Values of the held axes, and zeros.
    held: AxisValues,
    part_origin: Vector3<f64>,
    rotary: RotaryAxes,
    poles: Poles,
    linear: LinearAxes,
    speeds: AxisSpeeds,
    /// Words are below these, in units.
    bounds: [i64; MAX_AXES],
    /// What the words count from.
    datum: Datum,
    /// What the linear words count.
    frame: WordFrame,
    limits: Vec<Option<Limits>>,
    travel: Travel,
    /// Solved rotary axes are on the tool side.
    head: bool,
    gauge_line: bool,
    /// Blocks hold the tool axis in the place of rotary words.
    vectors: bool,
    /// The control takes the length of the tool into account, whatever the rotaries do.
    compensated: bool,
}

fn too_large(letter: char) -> Fault {
    Fault::new(format_args!("{letter} is too large for a word of this control"))
        .help("`[formats] linear_whole` and `rotary_whole` are the digits before the point")
}

/// Bounds of the words in whole units.
fn bounds(axes: &[Axis], policy: Policy<'_>, units: Units) -> [i64; MAX_AXES] {
    let formats = &policy.formats;
    let bound = |whole: u32, decimals: u32| 10_i64.saturating_pow(whole + decimals);
    let mut bounds = [i64::MAX; MAX_AXES];
    for (bound_of, axis) in bounds.iter_mut().zip(axes) {
        *bound_of = match axis.kind {
            AxisKind::Linear => bound(formats.linear_whole, formats.linear(units)),
            AxisKind::Rotary => bound(formats.rotary_whole, formats.rotary),
        };
    }
    bounds
}

impl Placer {
    pub(crate) fn new(machine: Box<dyn AnyMachine>, policy: Policy<'_>, units: Units) -> Self {
        let chain = machine.axes();
        let scale = AngleScale::new(policy.formats.rotary);
        let datum = Datum::new(&*machine, policy, scale);
        let speeds = policy.set_up.travel(chain).speeds;
        let head = rotaries_of(chain, Side::Tool).next().is_some();
        let rotary = RotaryAxes::new(chain, policy, &datum, &speeds, scale);
        let (options, mode) = (policy.options, policy.options.mode);
        Self {
            part_origin: policy.set_up.part_origin.into(),
            poles: Poles::new(&*machine, policy, &rotary.axes),
            linear: LinearAxes::new(&*machine, policy, units, head),
            speeds: AxisSpeeds {
                timed: options.feed.keep_speeds && speeds.iter().any(Option::is_some),
                of_axes: speeds,
            },
            bounds: bounds(chain, policy, units),
            limits: policy.set_up.travel(chain).limits,
            travel: Travel::new(&*machine, policy),
            frame: WordFrame::new(&*machine, policy),
            datum,
            head,
            gauge_line: policy.set_up.length_mode == LengthMode::Gauge,
            vectors: mode == Mode::Tcp && options.tip.tcp_words == TcpWords::Vectors,
            compensated: mode != Mode::Axes,
            rotary,
            held: machine.held(),
            chain,
            machine,
        }
    }

    /// The machine with the current tool.
    pub(crate) fn machine(&self) -> &dyn AnyMachine {
        &*self.machine
    }

    /// The axes of the machine, from the workpiece to the tool.
    pub(crate) fn chain(&self) -> &'static [Axis] {
        self.chain
    }

    /// Values of the held axes, and zeros.
    pub(crate) fn held(&self) -> &AxisValues {
        &self.held
    }

    /// Measures turns of the rotary axes.
    pub(crate) fn metric(&self) -> Metric {
        self.rotary.metric
    }

    /// Tool axes within reach that leave the first rotary free.
    pub(crate) fn poles(&self) -> &[UnitVector3<f64>] {
        &self.poles.axes
    }

    /// Angle to a pole up to which the tool axis counts as being there, rad.
    pub(crate) fn pole_tolerance(&self) -> f64 {
        self.poles.tolerance
    }

    /// The solved rotary axes.
    pub(crate) fn rotaries(&self) -> &[Rotary] {
        &self.rotary.axes
    }

    /// How rotary words count angles.
    pub(crate) fn scale(&self) -> AngleScale {
        self.rotary.scale
    }

    /// Places of X Y Z in the chain, in whose words a control with a frame of its own counts.
    pub(crate) fn frame_letters(&self) -> [usize; 3] {
        self.frame.letters()
    }

    /// The machine at a place.
    #[inline]
    pub(crate) fn standing_at<'p>(&self, place: &'p Place) -> ReachedPosition<'p> {
        let mask = self.linear.mask | self.rotary.mask;
        ReachedPosition { pose: Some(&place.pose), branch: place.branch, axes: &place.axes[..self.chain.len()], mask }
    }

    /// Compares a place with the travel of the linear axes.
    #[inline]
    pub(crate) fn check_travel(&mut self, place: &Place) -> Result<(), Fault> {
        self.travel.check(&place.axes)
    }

    /// Linear axes whose limits could not be compared: letter and why.
    pub(crate) fn unchecked_axes(&self) -> Vec<(char, &'static str)> {
        self.travel.axes().iter().filter_map(|axis| axis.unchecked().map(|why| (axis.letter(), why))).collect()
    }

    /// The tool axis in the part with these rotary words.
    pub(crate) fn axis_at(&self, words: &Turns) -> UnitVector3<f64> {
        self.machine.forward_kinematics(&self.standing(words).axes).axis
    }

    /// The place of a pose with these rotary words; limits are not compared.
    pub(crate) fn with_turns(&self, pose: &Pose, from: &Place, words: &Turns) -> Result<Place, Fault> {
        self.set(self.at(pose, from, &self.all_words(words)))
    }

    /// Solved rotary axes stand on the tool side: the tool's length moves the linear axes.
    pub(crate) fn head(&self) -> bool {
        self.head
    }

    /// Why the words depend on the length of the tool, if they do.
    pub(crate) fn needs_length(&self) -> Option<&'static str> {
        if self.head {
            (!self.compensated).then_some("this machine turns the tool about its head")
        } else {
            self.gauge_line.then_some("`length_mode = \"gauge\"` writes where its gauge line is")
        }
    }

    /// The words say where the gauge line is: no length offset is to be active.
    pub(crate) fn gauge_line(&self) -> bool {
        self.gauge_line
    }

    /// Solved rotary axes stand in the table.
    pub(crate) fn turning_table(&self) -> bool {
        rotaries_of(self.chain, Side::Workpiece).next().is_some()
    }

    /// Going out along the retract axis is going out along the tool axis, whatever the rotaries do.
    pub(crate) fn straight(&self) -> bool {
        self.linear.straight
    }

    /// The path length of the linear words is that of the tip while no rotary moves.
    pub(crate) fn square(&self) -> bool {
        self.linear.square || self.frame.counts_tip()
    }

    pub(crate) fn retract_axis(&self) -> usize {
        self.linear.retract_axis
    }

    pub(crate) fn linear_mask(&self) -> u16 {
        self.linear.mask
    }

    pub(crate) fn rotary_mask(&self) -> u16 {
        self.rotary.mask
    }

    /// A length in mm and words of one unit.
    pub(crate) fn unit_mm(&self) -> f64 {
        1.0 / self.linear.per_mm
    }

    pub(crate) fn set_gauge_length(&mut self, length: Option<f64>) {
        self.machine.set_up(self.part_origin, length.unwrap_or(0.0));
        self.datum.set_gauge_length(length.unwrap_or(0.0));
        self.travel.set_gauge_length(length);
    }

    /// Largest turn of a rotary word, rad.
    #[inline]
    pub(crate) fn rotary_travel(&self, from: &[i64; MAX_AXES], to: &[i64; MAX_AXES]) -> f64 {
        let largest = self.rotary.axes.iter().map(|rotary| (to[rotary.index] - from[rotary.index]).abs()).max();
        self.rotary.scale.angle(largest.unwrap_or(0))
    }

    /// The rotary that turns furthest, and how far, rad; none if none turns.
    #[inline]
    pub(crate) fn largest_turn(&self, from: &[i64; MAX_AXES], to: &[i64; MAX_AXES]) -> Option<(char, f64)> {
        let turns = self.rotary.axes.iter().map(|rotary| (rotary.index, to[rotary.index].abs_diff(from[rotary.index])));
        let (index, turn) = turns.max_by_key(|(_, turn)| *turn).filter(|(_, turn)| *turn > 0)?;
        Some((self.chain[index].letter, self.rotary.scale.angle(turn.cast_signed())))
    }

    /// How far the linear axes go together, mm, and the rotary axes, degrees.
    pub(crate) fn travelled(&self, from: &Place, to: &Place) -> (f64, f64) {
        let length = |mask: u16| {
            let steps = from.axes.iter().zip(to.axes).enumerate();
            let steps = steps.filter(|(index, _)| mask & (1 << index) != 0).map(|(_, (from, to))| to - from);
            steps.map(|step| step * step).sum::<f64>().sqrt()
        };
        (length(self.linear.mask), length(self.rotary.mask).to_degrees())
    }

    /// Minutes that a block takes at the largest speeds of its axes: those without a known speed do not count.
    #[inline]
    pub(crate) fn least_minutes(&self, from: &Place, to: &Place) -> Option<f64> {
        if !self.speeds.timed {
            return None;
        }
        let times = self.speeds.of_axes.iter().enumerate().filter_map(|(index, speed)| {
            let travel = (to.axes[index] - from.axes[index]).abs();
            speed.map(|speed| travel / speed)
        });
        times.reduce(f64::max)
    }

    /// Minutes of a rapid of some axes; `None` if one of those that move has no known speed.
    pub(crate) fn least_minutes_of(&self, from: &Place, to: &Place, mask: u16) -> Option<f64> {
        let mut least: f64 = 0.0;
        for (index, speed) in self.speeds.of_axes.iter().enumerate().filter(|(index, _)| mask & (1 << index) != 0) {
            let travel = (to.axes[index] - from.axes[index]).abs();
            if travel > 0.0 {
                least = least.max(travel / (*speed)?);
            }
        }
        Some(least)
    }

    /// What is written for the words of a place, by position in the chain.
    #[inline]
    pub(crate) fn written(&self, place: &Place) -> [i64; MAX_AXES] {
        self.datum.written(&place.words)
    }

    /// The written words of the axes in a mask.
    #[inline]
    pub(crate) fn words(&self, place: &Place, mask: u16) -> AxisWords {
        let units = self.written(place);
        let both = mask & self.linear.mask != 0 && mask & self.rotary.mask != 0;
        if !(self.vectors && both) {
            return AxisWords { units, mask, vector: None };
        }
        let axis = self.frame.map(&*self.machine, &place.axes).map(|map| map.rotation * place.pose.axis.into_inner());
        let unit = 10_f64.powi(VECTOR_DECIMALS.cast_signed());
        let vector = axis.map(|axis| axis.map(|component| (component * unit).round() as i64).into());
        AxisWords { units, mask: mask & !self.rotary.mask, vector }
    }

    /// Whether a block would turn rotary axes by more than an angle, rad, and could not say so: a tool axis as a vector is the
    /// same before and behind a turn about it, or of whole turns. At the pole a control that turns the tool axis in the
    /// plane of its ends needs no such turn.
    pub(crate) fn hides_turn(&self, from: &Place, to: &Place, angle: f64) -> bool {
        let all = self.linear.mask | self.rotary.mask;
        self.vectors
            && !(to.pole && self.frame.turns_in_plane())
            && self.rotary_travel(&from.words, &to.words) > angle
            && self.words(from, all).vector == self.words(to, all).vector
    }

    /// The place of a pose; `from` says where the rotaries come from and how the held axes stand. `planned`: the words of
    /// the rotaries where the course says so; an endless axis goes the short way to them.
    #[inline]
    pub(crate) fn place(
        &mut self,
        pose: &Pose,
        from: &Place,
        feed: bool,
        planned: Option<TurnTarget>,
    ) -> Result<Place, Fault> {
        let mut place = match planned {
            Some(target) => self.planned(pose, from, &target)?,
            None => self.turn(pose, from, feed)?,
        };
        if !self.rotary.grid.is_empty() {
            self.snap(&mut place, from, feed)?;
        }
        self.finish(place)
    }

    /// The place of another tip with the rotaries of `at`.
    pub(crate) fn shifted(&mut self, tip: Point3<f64>, at: &Place) -> Result<Place, Fault> {
        let mut place = *at;
        place.pose.tip = tip;
        self.finish(place)
    }

    #[inline]
    fn finish(&mut self, place: Place) -> Result<Place, Fault> {
        let place = self.set(place)?;
        self.travel.check(&place.axes)?;
        Ok(place)
    }

    /// The linear words of a pose whose rotaries are known; the travel is not compared.
    #[inline]
    pub(crate) fn set(&self, mut place: Place) -> Result<Place, Fault> {
        let Some(axes) = self.machine.linear_axes(&place.pose.tip, &place.axes) else {
            return Err(refusal::unreachable(self, &place.pose, &place.axes));
        };
        if let Some(map) = self.frame.map(&*self.machine, &place.axes) {
            return self.set_tip(place, &map);
        }
        place.axes = axes;
        let (mut sum, mut squares) = (0.0, 0.0);
        for (index, value) in place.axes.iter_mut().enumerate().take(MAX_AXES) {
            if self.linear.mask & (1 << index) != 0 {
                let shift = self.datum.linear(index);
                let Ok(units) = whole_units(*value + shift, self.linear.per_mm) else {
                    return Err(too_large(self.chain[index].letter));
                };
                place.words[index] = units;
                let written = units as f64 / self.linear.per_mm - shift;
                let off = written - *value;
                *value = written;
                sum += off.abs();
                squares += off * off;
            }
        }
        if let Some(index) = (0..self.chain.len()).find(|&index| place.words[index].abs() >= self.bounds[index]) {
            return Err(too_large(self.chain[index].letter));
        }
        place.rounding = if self.linear.orthogonal { squares.sqrt() } else { sum };
        Ok(place)
    }

    /// Whether offsets along two axes have more digits than their words.
    pub(crate) fn too_large(&self, units: [i64; 2], axes: [usize; 2]) -> bool {
        units.iter().zip(axes).any(|(units, axis)| units.abs() >= self.bounds[axis])
    }

    /// Minutes that the linear axes need while the tip travels so far, mm, in whatever direction, with the rotary axes
    /// still; 0 where their speeds are not to be kept.
    pub(crate) fn least_minutes_of_tip(&self, length: f64, at: &Place) -> f64 {
        let Some((solved, map)) = self.axis_map(at).filter(|_| self.speeds.timed) else { return 0.0 };
        let minutes = |(row, axis): (usize, usize)| {
            self.speeds.of_axes[axis].map_or(0.0, |speed| length * map.row(row).norm() / speed)
        };
        solved.into_iter().enumerate().map(minutes).fold(0.0, f64::max)
    }

    /// How far rounding of the linear words can take the tip, mm.
    pub(crate) fn largest_rounding(&self) -> f64 {
        0.5 * self.unit_mm() * if self.linear.orthogonal { 3_f64.sqrt() } else { 3.0 }
    }

    /// The rotaries of a pose that only says where motion counts from; `None` if it cannot be reached.
    pub(crate) fn reference(&self, pose: &Pose, from: &Place) -> Option<Place> {
        let solutions = self.machine.inverse_kinematics(pose, &from.axes);
        let choice = choose(&solutions, &self.rotary.axes, &from.words, self.rotary.scale).ok()?;
        let mut place = Place { branch: solutions[choice.solution].branch, ..*from };
        for rotary in &self.rotary.axes {
            place.words[rotary.index] = choice.words[rotary.index];
            place.axes[rotary.index] = rotary.angle(choice.words[rotary.index], self.rotary.scale);
        }
        Some(place)
    }

    /// Every rotary at zero and held axes at their values.
    pub(crate) fn zero(&self) -> Place {
        let pose = Pose { tip: Point3::origin(), axis: self.machine.tool_axis() };
        let zero = Place {
            pose,
            branch: Branch::First,
            axes: self.held,
            words: [0; MAX_AXES],
            deviation: 0.0,
            pole: false,
            rounding: 0.0,
        };
        self.at(&pose, &zero, &zero.words)
    }

    /// Words of a linear axis at a machine coordinate.
    pub(crate) fn machine_words(&self, index: usize, coordinate: f64) -> Result<AxisWords, Fault> {
        self.travel.check_machine(index, coordinate)?;
        let units = whole_units(coordinate, self.linear.per_mm)
            .ok()
            .filter(|units| units.abs() < self.bounds[index])
            .ok_or_else(|| too_large(self.chain[index].letter))?;
        let mut words = AxisWords { units: [0; MAX_AXES], mask: 1 << index, vector: None };
        words.units[index] = units;
        Ok(words)
    }

    /// Words of the machine retract. The end of the travel at the part is no place to retract to.
    pub(crate) fn retract_words(&self, coordinate: f64) -> Result<AxisWords, Fault> {
        let index = self.linear.retract_axis;
        let part_end = |limits: Limits| if self.linear.retract_share > 0.0 { limits.lower } else { limits.upper };
        if self.limits[index].is_some_and(|limits| (coordinate - part_end(limits)).abs() < self.unit_mm()) {
            return Err(Fault::new(format_args!(
                "the retract position {} = {coordinate} mm (machine coordinate) is the end of the travel at the part",
                self.chain[index].letter
            ))
            .help("give `retract.position` in the configuration, the machine coordinate away from the part"));
        }
        self.machine_words(index, coordinate)
    }

    /// Whole units of a rotary at an angle, inside its limits.
    pub(crate) fn rotary_word(&self, index: usize, angle: f64) -> Result<i64, Fault> {
        let rotary = self.rotary.axes.iter().find(|rotary| rotary.index == index);
        let Some(rotary) = rotary else { return Ok(0) };
        let mut words = [0; MAX_AXES];
        words[index] = rotary.word(angle, self.rotary.scale);
        if !rotary.holds(words[index]) {
            return Err(refusal::outside_limits(
                self,
                &[Some(OutOfLimits { rotary: *rotary, word: words[index] }), None],
            ));
        }
        Ok(words[index])
    }

    /// The place with its rotaries parked at these angles, and which of them are; one whose words are wrapped stands in
    /// the turn nearest to where it stood. The linear axes stay as they are.
    pub(crate) fn parked(&self, park: &BTreeMap<char, f64>, from: &Place) -> Result<(Place, u16), Fault> {
        let (mut words, mut mask) = (from.words, 0);
        for rotary in &self.rotary.axes {
            let index = rotary.index;
            let Some(&angle) = park.get(&self.chain[index].letter) else { continue };
            let word = self.rotary_word(index, angle)?;
            let nearest = || rotary.nearest(word, words[index], self.rotary.scale.turn).unwrap_or(word);
            words[index] = if self.rotary.wrapped & (1 << index) != 0 { nearest() } else { word };
            mask |= 1 << index;
        }
        Ok((self.at(&from.pose, from, &words), mask))
    }

    /// Whether a control that goes the short way would turn an axis the wrong way in this block.
    #[inline]
    pub(crate) fn rolls_over(&self, from: &Place, to: &Place) -> bool {
        let half_turn = |rotary: &Rotary| {
            self.rotary.wrapped & (1 << rotary.index) != 0
                && 2 * from.words[rotary.index].abs_diff(to.words[rotary.index])
                    >= self.rotary.scale.turn.unsigned_abs()
        };
        self.rotary.wrapped != 0 && self.rotary.axes.iter().any(half_turn)
    }

    /// How far below the machine retract a place stands along the tool axis of the zero position, mm; `None` if that
    /// cannot be known.
    pub(crate) fn below_retract(&self, place: &Place, retract: f64) -> Option<f64> {
        let there = self.travel.value_at(self.linear.retract_axis, retract)?;
        Some((there - place.axes[self.linear.retract_axis]) * self.linear.retract_share.signum())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::config::Config;
    use crate::kinematics::Machine;
    use crate::motion::machines::{Ay, Cb, Head, Xyz};

    fn placer<M: Machine>() -> Placer {
        let config = Config::default();
        Placer::new(Box::new(config.set_up.machine::<M>().expect("valid")), config.policy(), Units::Millimetres)
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
