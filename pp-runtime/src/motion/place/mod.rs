//! Conversion of a pose to axis values and to the words of its block.
//!
//! Rounding comes first: the rotary words are rounded, then the linear axes are computed for the *rounded* angles, so
//! that rounding an angle never moves the tip. Limits are compared with rounded values.

mod axes;
mod axis_speed;
mod chain;
mod datum;
mod dog_leg;
mod entry;
mod frame;
mod linearise;
mod refusal;
mod rotary_angles;
mod suited;
mod tilted_plane;
mod tip;
mod tool_vectors;
mod travel;

use std::cell::RefCell;
use std::collections::BTreeMap;

use nalgebra::{Point3, UnitVector3, Vector3};

use crate::diag::code::plan;
use crate::kinematics::math::rounded;
use crate::kinematics::{
    AngleScale, AnyMachine, Axis, AxisKind, AxisUnits, AxisValues, Branch, Limits, OutOfLimits, Pose, Rotary, Side,
};
use crate::motion::fault::Fault;
use crate::motion::policy::Policy;
use crate::motion::rotary::{RotaryMetric, RotaryTarget, RotaryWords, choose};
use crate::motion::step::{AxisWords, MAX_AXES, ReachedPosition, VECTOR_DECIMALS};
use crate::nc::whole_units;
use crate::options::{StretchMode, ToolPosture};
use crate::program::Units;
use crate::set_up::LengthMode;

pub(crate) use entry::TipEntry;
pub(crate) use frame::{TipAbility, TipStart};
pub(crate) use linearise::{BlockEnds, Linearised, PathTolerance, RotationLaw, WholeMotion};
pub(crate) use refusal::limits_text;
pub(crate) use suited::{UsableModes, unsuited};
pub(crate) use tilted_plane::{PlaneAbility, PlaneAngles, PoseRule};

use crate::tolerance::writer::{GUARDED_ANGLE_DEG, LEAST_GUARDED_RATE};
pub(crate) use axes::Poles;
use axes::{AxisSpeeds, LinearAxes, RotaryAxes};
pub(crate) use chain::rotaries as rotaries_of;
use datum::Datum;
use frame::WordFrame;
use travel::TravelCheck;

/// Parts of a block whose speeds of the tip are bounded one by one.
const RATE_PARTS: u32 = 8;

/// Position of all axes: pose, axis values, and the words that move the machine there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct AxisPosition {
    /// The programmed pose; near the pole its tool axis is replaced by the pole.
    pub(crate) pose: Pose,
    /// Branch of the inverse kinematics.
    pub(crate) branch: Branch,
    /// Axis values of the rounded words, mm and rad.
    pub(crate) axes: AxisValues,
    /// Whole units by position in the chain: words of linear axes, axis values of rotary axes.
    pub(crate) words: [i64; MAX_AXES],
    /// Angle between the programmed tool axis and the one reached.
    pub(crate) deviation_rad: f64,
    /// The tool axis is parallel to the first rotary axis, whose angle is therefore free.
    pub(crate) at_pole: bool,
    /// Largest displacement of the tip by rounding of the linear words.
    pub(crate) rounding_mm: f64,
}

/// Converts poses to axis values and words for one machine, one set-up and the current tool.
#[derive(Debug, Clone)]
pub(crate) struct Placer {
    machine: Box<dyn AnyMachine>,
    /// Unit of the program.
    units: Units,
    /// Axes of the machine, from the workpiece to the tool.
    chain: &'static [Axis],
    /// Values of the held axes; 0 for all others.
    held: AxisValues,
    part_origin: Vector3<f64>,
    rotary: RotaryAxes,
    /// The last motion, if it kept the rotary angles.
    stay: Option<rotary_angles::Stay>,
    /// The last [`axis_map`](Self::axis_map).
    last_map: RefCell<Option<tip::AxisMap>>,
    poles: Poles,
    linear: LinearAxes,
    speeds: AxisSpeeds,
    /// Exclusive bounds of the absolute words, in units.
    bounds: AxisUnits,
    /// Zero of the written words.
    datum: Datum,
    /// Frame of the linear words.
    frame: WordFrame,
    limits: Vec<Option<Limits>>,
    travel: TravelCheck,
    /// The tool side has solved rotary axes.
    head: bool,
    gauge_line: bool,
    /// Under tip control blocks contain the tool axis as a vector instead of rotary words.
    vectors: bool,
    /// Largest angle between a pole and a path that is led through it; `None` if none is.
    largest_bend_rad: Option<f64>,
    /// Tolerance of the tool axis within which the rotary axes go evenly in a whole motion, rad; `None` if they never
    /// do.
    even_rad: Option<f64>,
}

fn too_large(letter: char) -> Fault {
    plan::WORD
        .fault(format_args!("the value of {letter} is too large for its word"))
        .help("`linear_whole` and `rotary_whole` in [formats] are the digits before the decimal point")
}

/// Exclusive bounds of the words in whole units. A word that stays within one revolution may be one of an axis that has
/// rotated further.
fn bounds(axes: &[Axis], policy: Policy<'_>, units: Units) -> AxisUnits {
    let formats = &policy.formats;
    let bound = |whole: u32, decimals: u32| 10_i64.saturating_pow(whole + decimals);
    let wraps = |axis: &Axis| policy.options.rotaries.wrap.contains_key(&axis.letter);
    let mut bounds = [i64::MAX; MAX_AXES];
    for (bound_of, axis) in bounds.iter_mut().zip(axes) {
        *bound_of = match axis.kind {
            AxisKind::Linear => bound(formats.linear_whole, formats.linear(units)),
            AxisKind::Rotary => match bound(formats.rotary_whole, formats.rotary) {
                bound if wraps(axis) && bound > AngleScale::new(formats.rotary).units_per_turn => i64::MAX,
                bound => bound,
            },
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
        let options = policy.options;
        let largest_bend_rad = tool_vectors::largest_bend(policy, rotary.limited);
        // A motion is led through a pole by a block there: words with the tool axis of the pole are at the pole.
        let at_pole_rad = if largest_bend_rad.is_some() { 0.5 * scale.angle(1) } else { 0.0 };
        let bounds = bounds(chain, policy, units);
        let mut placer = Self {
            part_origin: policy.set_up.part_origin.into(),
            poles: Poles::new(&*machine, policy, &rotary.axes, at_pole_rad),
            linear: LinearAxes::new(&*machine, policy, units, head, &bounds),
            speeds: AxisSpeeds {
                timed: options.feed.keep_speeds && speeds.iter().any(Option::is_some),
                per_axis: speeds,
            },
            bounds,
            limits: policy.set_up.travel(chain).limits,
            travel: TravelCheck::new(&*machine, policy, units),
            frame: WordFrame::new(&*machine, policy),
            datum,
            head,
            gauge_line: policy.set_up.length_mode == LengthMode::Gauge,
            vectors: tool_vectors::has_vectors(policy),
            largest_bend_rad,
            even_rad: (options.tip.tool_posture == ToolPosture::Axes).then_some(options.axis_tolerance_path_rad),
            rotary,
            stay: None,
            last_map: RefCell::new(None),
            held: machine.held(),
            units,
            chain,
            machine,
        };
        placer.set_mode(options.mode_of_all().unwrap_or_default());
        placer
    }

    /// Unit of the program.
    pub(crate) fn units(&self) -> Units {
        self.units
    }

    /// Mode of the present stretch.
    #[inline]
    pub(crate) fn mode(&self) -> StretchMode {
        self.frame.mode()
    }

    /// Sets the mode of the stretch that begins.
    pub(crate) fn set_mode(&mut self, mode: StretchMode) {
        self.frame.set_mode(mode);
    }

    /// The machine with the current tool.
    pub(crate) fn machine(&self) -> &dyn AnyMachine {
        &*self.machine
    }

    /// The axes of the machine, from the workpiece to the tool.
    pub(crate) fn chain(&self) -> &'static [Axis] {
        self.chain
    }

    /// Values of the held axes; 0 for all others.
    pub(crate) fn held(&self) -> &AxisValues {
        &self.held
    }

    /// Travel and cost of rotations of the rotary axes.
    #[inline]
    pub(crate) fn metric(&self) -> &RotaryMetric {
        &self.rotary.metric
    }

    /// Reachable tool axes at which the angle of the first rotary axis is free.
    pub(crate) fn poles(&self) -> &Poles {
        &self.poles
    }

    /// The solved rotary axes.
    pub(crate) fn rotaries(&self) -> &[Rotary] {
        &self.rotary.axes
    }

    /// Resolution of the rotary words.
    pub(crate) fn scale(&self) -> AngleScale {
        self.rotary.scale
    }

    /// Positions of X Y Z in the chain.
    pub(crate) fn frame_letters(&self) -> [usize; 3] {
        self.frame.letters()
    }

    /// State of the machine at a position, for the sink of a step.
    #[inline]
    pub(crate) fn state_at<'p>(&self, place: &'p AxisPosition) -> ReachedPosition<'p> {
        let mask = self.linear.mask | self.rotary.mask;
        ReachedPosition { pose: Some(&place.pose), branch: place.branch, axes: &place.axes[..self.chain.len()], mask }
    }

    /// Compares a position with the travel of the linear axes.
    #[inline]
    pub(crate) fn check_travel(&mut self, place: &AxisPosition) -> Result<(), Fault> {
        self.travel.check(&place.axes)
    }

    /// Tries motions that are not in the program yet. Returns whether they are possible; no travel counts as needed for
    /// those that are not.
    pub(crate) fn attempt(&mut self, motions: impl FnOnce(&mut Self) -> Result<bool, Fault>) -> bool {
        let needed = self.travel.needed();
        let possible = motions(self).unwrap_or(false);
        if !possible {
            self.travel.take_back(&needed);
        }
        possible
    }

    /// Linear axes whose limits could not be compared: letter and reason.
    pub(crate) fn unchecked_axes(&self) -> Vec<(char, &'static str)> {
        self.travel.axes().iter().filter_map(|axis| axis.unchecked_reason().map(|why| (axis.letter(), why))).collect()
    }

    /// Letter of the retract axis where its machine coordinates are unknown, so that the way of a retract is not
    /// compared.
    pub(crate) fn blind_retract(&self) -> Option<char> {
        let axis = self.travel.axes().iter().find(|axis| axis.index == self.retract_axis())?;
        (!axis.has_machine_zero()).then(|| axis.letter())
    }

    /// Tool axis in the workpiece frame at these rotary words.
    pub(crate) fn axis_at(&self, words: &RotaryWords) -> UnitVector3<f64> {
        self.machine.forward_kinematics(&self.position_at_words(words).axes).axis
    }

    /// Position of a pose at these rotary words; limits are not compared.
    pub(crate) fn with_rotary_words(
        &self,
        pose: &Pose,
        from: &AxisPosition,
        words: &RotaryWords,
    ) -> Result<AxisPosition, Fault> {
        self.solved(self.position_at(pose, from, &self.all_words(words)))
    }

    /// Whether the tool side has solved rotary axes, so that the tool length moves the linear axes.
    pub(crate) fn has_rotary_head(&self) -> bool {
        self.head
    }

    /// Whether the travel of all linear axes is known.
    pub(crate) fn travel_is_known(&self) -> bool {
        self.travel.is_known()
    }

    /// Reason why the words depend on the tool length; `None` if they do not. `axes`: the program has axis positions,
    /// in stretches or on the way to tip control.
    pub(crate) fn needs_gauge_length(&self, axes: bool) -> Option<&'static str> {
        if self.head {
            axes.then_some("this machine rotates the tool about its head")
        } else {
            self.gauge_line.then_some("`length_mode = \"gauge\"` writes positions of its gauge line")
        }
    }

    /// Whether the words are positions of the gauge line, so that no length offset may be active.
    pub(crate) fn gauge_line(&self) -> bool {
        self.gauge_line
    }

    /// Whether a retract along the retract axis, outside tip control and planes, is one along the tool axis at any
    /// rotary angles.
    pub(crate) fn retracts_along_tool(&self) -> bool {
        self.linear.retracts_along_tool
    }

    /// Whether the path length of the linear words equals that of the tip while no rotary axis moves.
    pub(crate) fn keeps_path_length(&self) -> bool {
        self.linear.keeps_path_length || self.frame.counts_tip()
    }

    /// Whether the path length of the words of a motion of linear axes that ends here equals that of the tip.
    pub(crate) fn keeps_path_length_at(&self, at: &AxisPosition) -> bool {
        self.keeps_path_length() || self.orthogonal_map(at).is_some()
    }

    pub(crate) fn retract_axis(&self) -> usize {
        self.linear.retract_axis
    }

    pub(crate) fn linear_mask(&self) -> u16 {
        self.linear.mask
    }

    /// Whether every rotary axis is at zero, or whole turns from it, and Z is the retract axis: words without a plane
    /// are those of a plane that is not tilted.
    pub(crate) fn is_plain(&self, place: &AxisPosition) -> bool {
        let mut rotary = self.rotary.axes.iter();
        rotary.all(|axis| place.words[axis.index] % self.rotary.scale.units_per_turn == 0)
            && self.frame_letters()[2] == self.retract_axis()
    }

    pub(crate) fn rotary_mask(&self) -> u16 {
        self.rotary.mask
    }

    /// Rotary axes whose positions follow from the rounded angles of a plane, within a part of what a guard allows:
    /// bits. `decimals`: those of the angles, degrees.
    pub(crate) fn directing_axes(&self, at: &AxisPosition, decimals: u32) -> u16 {
        // Three angles, each rounded by half a unit.
        let least_rate = LEAST_GUARDED_RATE.max(10_f64.powi(-decimals.cast_signed()) / (0.5 * GUARDED_ANGLE_DEG));
        if self.rotary.scale.degrees(1) > 0.2 * GUARDED_ANGLE_DEG {
            return 0;
        }
        let directs = |index: usize| {
            let mut change = AxisValues::default();
            change[index] = 1.0;
            self.machine.rates(&at.axes, &change).1.norm() > least_rate
        };
        let directing = self.rotary.axes.iter().filter(|axis| directs(axis.index));
        directing.fold(0, |mask, axis| mask | 1 << axis.index)
    }

    /// Size of one unit of a linear word, mm.
    pub(crate) fn unit_mm(&self) -> f64 {
        self.linear.unit_mm
    }

    /// Sets the position of the part zero from the reference point of the table: the part is clamped again.
    pub(crate) fn set_part_origin(&mut self, origin: Vector3<f64>) {
        self.part_origin = origin;
        self.datum.set_part_origin(&*self.machine, &origin);
        self.frame.set_part_origin(&origin);
        self.travel.set_part_origin(&*self.machine, &origin);
        self.set_gauge_length(self.travel.gauge_length_mm());
    }

    pub(crate) fn set_gauge_length(&mut self, length: Option<f64>) {
        self.machine.set_up(self.part_origin, length.unwrap_or(0.0));
        self.datum.set_gauge_length(length.unwrap_or(0.0));
        self.travel.set_gauge_length(length);
    }

    /// Whether a rotary word differs.
    #[inline]
    pub(crate) fn rotates(&self, from: &[i64; MAX_AXES], to: &[i64; MAX_AXES]) -> bool {
        self.rotary.axes.iter().any(|rotary| to[rotary.index] != from[rotary.index])
    }

    /// Largest travel of a rotary axis, rad.
    #[inline]
    pub(crate) fn rotary_travel(&self, from: &[i64; MAX_AXES], to: &[i64; MAX_AXES]) -> f64 {
        let largest = self.rotary.axes.iter().map(|rotary| (to[rotary.index] - from[rotary.index]).abs()).max();
        self.rotary.scale.angle(largest.unwrap_or(0))
    }

    /// Rotary axis with the largest travel, and this travel, rad; `None` if none moves.
    #[inline(always)]
    pub(crate) fn largest_rotation(&self, from: &[i64; MAX_AXES], to: &[i64; MAX_AXES]) -> Option<(char, f64)> {
        let (mut largest, mut most) = (0, 0);
        for rotary in &self.rotary.axes {
            let travel = to[rotary.index].abs_diff(from[rotary.index]);
            if travel >= most {
                (largest, most) = (rotary.index, travel);
            }
        }
        (most > 0).then(|| (self.chain[largest].letter, self.rotary.scale.angle(most.cast_signed())))
    }

    /// Path length of the linear axes together, mm, and of the rotary axes together, degrees.
    pub(crate) fn path_lengths(&self, from: &AxisPosition, to: &AxisPosition) -> (f64, f64) {
        let length = |mask: u16| {
            let steps = from.axes.iter().zip(to.axes).enumerate();
            let steps = steps.filter(|(index, _)| mask & (1 << index) != 0).map(|(_, (from, to))| to - from);
            steps.map(|step| step * step).sum::<f64>().sqrt()
        };
        (length(self.linear.mask), length(self.rotary.mask).to_degrees())
    }

    /// Largest speed of the tip in a block in which all axes move linearly, times the time of the block, mm: the
    /// certified bounds of its parts, which are near the true speed.
    #[cold]
    pub(crate) fn tip_rate_mm(&self, from: &AxisPosition, to: &AxisPosition) -> f64 {
        let at = |part: u32| -> AxisValues {
            let share = f64::from(part) / f64::from(RATE_PARTS);
            std::array::from_fn(|index| from.axes[index] + share * (to.axes[index] - from.axes[index]))
        };
        let rate = |part: u32| self.machine.motion(&at(part), &at(part + 1)).tip_rate;
        (0..RATE_PARTS).map(rate).fold(0.0, f64::max) * f64::from(RATE_PARTS)
    }

    /// Whether the linear words of a position are coordinates of the tip, and those of another: the control moves no
    /// tip.
    #[inline(always)]
    pub(crate) fn tip_rests(&self, from: &AxisPosition, to: &AxisPosition) -> bool {
        self.frame.counts_tip() && self.keeps_linear_words(from, to)
    }

    fn keeps_linear_words(&self, from: &AxisPosition, to: &AxisPosition) -> bool {
        let same = |index: usize| self.linear.mask & (1 << index) == 0 || from.words[index] == to.words[index];
        (0..self.chain.len()).all(same)
    }

    /// Shortest time of a block at the largest speeds of its axes, min; axes of unknown speed do not count.
    #[inline]
    pub(crate) fn least_minutes(&self, from: &AxisPosition, to: &AxisPosition) -> Option<f64> {
        if !self.speeds.timed {
            return None;
        }
        let times = self.speeds.per_axis.iter().enumerate().filter_map(|(index, speed)| {
            let travel = (to.axes[index] - from.axes[index]).abs();
            speed.map(|speed| travel / speed)
        });
        times.reduce(f64::max)
    }

    /// Whether blocks are slowed down for the speeds of axes.
    pub(crate) fn keeps_speeds(&self) -> bool {
        self.speeds.timed
    }

    /// Shortest time of a rapid of the axes in `mask`, min; `None` if one that moves has no known speed.
    pub(crate) fn least_minutes_of(&self, from: &AxisPosition, to: &AxisPosition, mask: u16) -> Option<f64> {
        let mut least: f64 = 0.0;
        for (index, speed) in self.speeds.per_axis.iter().enumerate().filter(|(index, _)| mask & (1 << index) != 0) {
            let travel = (to.axes[index] - from.axes[index]).abs();
            if travel > 0.0 {
                least = least.max(travel / (*speed)?);
            }
        }
        Some(least)
    }

    /// Written words of a position, by position in the chain.
    #[inline]
    pub(crate) fn written(&self, place: &AxisPosition) -> [i64; MAX_AXES] {
        self.datum.written(&place.words)
    }

    /// Written words of the axes in `mask`.
    #[inline(always)]
    pub(crate) fn words(&self, place: &AxisPosition, mask: u16) -> AxisWords {
        let units = self.written(place);
        let both = mask & self.linear.mask != 0 && mask & self.rotary.mask != 0;
        if !(self.writes_vectors() && both) {
            return AxisWords { units, mask, vector: None };
        }
        let axis = self.frame.map(&*self.machine, &place.axes).map(|map| map.rotation * place.pose.axis.into_inner());
        let unit = 10_f64.powi(VECTOR_DECIMALS.cast_signed());
        let vector = axis.map(|axis| axis.map(|component| rounded(component * unit)).into());
        AxisWords { units, mask: mask & !self.rotary.mask, vector }
    }

    /// Position of a pose, reached from the position `from`, which also gives the values of the held axes. `planned`:
    /// rotary words of the course, if it sets them; an endless axis rotates to them by the shorter path.
    #[inline]
    pub(crate) fn place(
        &mut self,
        pose: &Pose,
        from: &AxisPosition,
        feed: bool,
        planned: Option<RotaryTarget>,
    ) -> Result<AxisPosition, Fault> {
        let mut place = *from;
        match planned {
            Some(target) => place = self.follow_course(pose, from, &target)?,
            None => self.set_rotaries_for(pose, from, feed, &mut place)?,
        }
        if self.has_indexed_axes() {
            self.snap_to_index(&mut place, from, feed)?;
        }
        self.solve_linear_in_travel(&mut place)?;
        Ok(place)
    }

    /// Position of another tip at the rotary angles of `at`.
    pub(crate) fn shifted(&mut self, tip: Point3<f64>, at: &AxisPosition) -> Result<AxisPosition, Fault> {
        let mut place = *at;
        self.shift(&mut place, tip)?;
        Ok(place)
    }

    /// Moves the tip of a position, at its rotary angles.
    pub(crate) fn shift(&mut self, place: &mut AxisPosition, tip: Point3<f64>) -> Result<(), Fault> {
        place.pose.tip = tip;
        self.solve_linear_in_travel(place)
    }

    /// [`Placer::solve_linear`] with the travel compared.
    #[inline(always)]
    fn solve_linear_in_travel(&mut self, place: &mut AxisPosition) -> Result<(), Fault> {
        self.solve_linear(place)?;
        self.travel.check(&place.axes)
    }

    /// A position whose rotary angles are known, with its linear axes: see [`Placer::solve_linear`].
    pub(crate) fn solved(&self, mut place: AxisPosition) -> Result<AxisPosition, Fault> {
        self.solve_linear(&mut place)?;
        Ok(place)
    }

    /// Computes the linear axes and words of a position whose rotary angles are known; the travel is not compared.
    #[inline(always)]
    pub(crate) fn solve_linear(&self, place: &mut AxisPosition) -> Result<(), Fault> {
        if self.frame.counts_tip() {
            return self.solve_in_frame(place);
        }
        let (scale, shifts) = (&self.linear.scale, self.datum.shifts());
        let (AxisPosition { pose, axes, words, .. }, machine) = (&mut *place, &self.machine);
        match machine.set_linear_words(&pose.tip, scale, shifts, axes, words) {
            Some(rounding_mm) => place.rounding_mm = rounding_mm,
            None => return Err(self.not_solved(place)),
        }
        Ok(())
    }

    /// Computes the words where they are coordinates of the tip in a frame.
    fn solve_in_frame(&self, place: &mut AxisPosition) -> Result<(), Fault> {
        self.frame.map(&*self.machine, &place.axes).map_or(Ok(()), |map| self.solve_tip(place, &map))
    }

    /// The fault that a position has no linear axes, or a word more digits than are allowed.
    #[cold]
    fn not_solved(&self, place: &AxisPosition) -> Fault {
        let Some(values) = self.machine.linear_axes(&place.pose.tip, &place.axes) else {
            return refusal::unreachable(self, &place.pose, &place.axes);
        };
        let fits = |index: usize| match self.chain[index].kind {
            AxisKind::Rotary => self.rotary_fits(&place.words, index),
            AxisKind::Linear => {
                let word = self.linear.rounded(values[index], self.datum.linear_shift_mm(index));
                self.chain[index].held || word.is_ok_and(|(units, _)| units.abs() < self.bounds[index])
            }
        };
        too_large(self.chain[(0..self.chain.len()).find(|&index| !fits(index)).unwrap_or_default()].letter)
    }

    /// Whether the written word of a rotary axis has no more digits than it may.
    fn rotary_fits(&self, words: &AxisUnits, index: usize) -> bool {
        (words[index] as f64 + self.datum.shifts()[index]).abs() < self.linear.scale.most_units[index]
    }

    /// Refuses a rotary word with more digits than it may have.
    #[inline]
    fn check_rotary_digits(&self, words: &AxisUnits) -> Result<(), Fault> {
        let beyond = self.rotary.axes.iter().find(|rotary| !self.rotary_fits(words, rotary.index));
        beyond.map_or(Ok(()), |rotary| Err(too_large(self.chain[rotary.index].letter)))
    }

    /// Whether offsets along two axes have more digits than their words allow.
    pub(crate) fn too_large(&self, units: [i64; 2], axes: [usize; 2]) -> bool {
        units.iter().zip(axes).any(|(units, axis)| units.abs() >= self.bounds[axis])
    }

    /// Shortest time of the linear axes, min, for a tip path at constant rotary angles; 0 if their speeds need not be
    /// kept. `along`: largest speed of the tip along a direction or against it, times the time, mm.
    pub(crate) fn least_minutes_of_tip(&self, at: &AxisPosition, along: impl Fn(Vector3<f64>) -> f64) -> f64 {
        if !self.speeds.timed {
            return 0.0;
        }
        let Some((solved, map)) = self.axis_map(at) else { return 0.0 };
        let minutes = |(row, axis): (usize, usize)| {
            self.speeds.per_axis[axis].map_or(0.0, |speed| along(map.row(row).transpose()) / speed)
        };
        solved.into_iter().enumerate().map(minutes).fold(0.0, f64::max)
    }

    /// Largest possible displacement of the tip by rounding of the linear words, mm.
    pub(crate) fn largest_rounding(&self) -> f64 {
        0.5 * self.unit_mm() * if self.linear.scale.orthogonal { 3_f64.sqrt() } else { 3.0 }
    }

    /// Position with the rotary angles of a pose from which motion starts (FROM); `None` if it cannot be reached.
    pub(crate) fn reference(&self, pose: &Pose, from: &AxisPosition) -> Option<AxisPosition> {
        let solutions = self.machine.rotary_axes(&pose.axis, &from.axes);
        let choice =
            choose(&solutions, &self.rotary.axes, &self.rotary_words_of(&from.words), self.rotary.scale).ok()?;
        let mut place = AxisPosition { branch: solutions[choice.solution].branch, ..*from };
        for (rotary, word) in self.rotary.axes.iter().zip(choice.words) {
            place.words[rotary.index] = word;
            place.axes[rotary.index] = rotary.angle(word, self.rotary.scale);
        }
        Some(place)
    }

    /// Position with every rotary axis at zero and held axes at their values.
    pub(crate) fn zero(&self) -> AxisPosition {
        let pose = Pose { tip: Point3::origin(), axis: self.machine.tool_axis() };
        let zero = AxisPosition {
            pose,
            branch: Branch::First,
            axes: self.held,
            words: [0; MAX_AXES],
            deviation_rad: 0.0,
            at_pole: false,
            rounding_mm: 0.0,
        };
        self.position_at(&pose, &zero, &zero.words)
    }

    /// Words of a linear axis at a machine coordinate.
    pub(crate) fn machine_words(&self, index: usize, coordinate_mm: f64) -> Result<AxisWords, Fault> {
        self.travel.check_machine(index, coordinate_mm)?;
        let units = whole_units(coordinate_mm, self.linear.scale.units_per_mm)
            .ok()
            .filter(|units| units.abs() < self.bounds[index])
            .ok_or_else(|| too_large(self.chain[index].letter))?;
        let mut words = AxisWords { units: [0; MAX_AXES], mask: 1 << index, vector: None };
        words.units[index] = units;
        Ok(words)
    }

    /// Words of the machine retract. Refuses a retract position at the end of the travel that is at the part.
    pub(crate) fn retract_words(&self, coordinate_mm: f64) -> Result<AxisWords, Fault> {
        let index = self.linear.retract_axis;
        let part_end = |limits: Limits| if self.linear.retract_share > 0.0 { limits.lower } else { limits.upper };
        if self.limits[index].is_some_and(|limits| (coordinate_mm - part_end(limits)).abs() < self.unit_mm()) {
            return Err(plan::RETRACT
                .fault(format_args!(
                    "the retract position {} = {} (machine coordinate) is the end of the travel at the part",
                    self.chain[index].letter,
                    self.units.length(coordinate_mm)
                ))
                .help("set `retract.position` in the configuration to a machine coordinate away from the part"));
        }
        self.machine_words(index, coordinate_mm)
    }

    /// Word of a rotary axis at an angle; refuses one outside its limits.
    pub(crate) fn rotary_word(&self, index: usize, angle_rad: f64) -> Result<i64, Fault> {
        let rotary = self.rotary.axes.iter().find(|rotary| rotary.index == index);
        let Some(rotary) = rotary else { return Ok(0) };
        let mut words = [0; MAX_AXES];
        words[index] = rotary.word(angle_rad, self.rotary.scale);
        if !rotary.contains(words[index]) {
            return Err(refusal::outside_limits(
                self,
                &[Some(OutOfLimits { rotary: *rotary, word: words[index] }), None],
            ));
        }
        Ok(words[index])
    }

    /// Position with the rotary axes parked at these angles, and the mask of the parked axes; one that rolls over parks
    /// in the turn nearest to `from`. The linear axes are unchanged.
    pub(crate) fn parked(&self, park: &BTreeMap<char, f64>, from: &AxisPosition) -> Result<(AxisPosition, u16), Fault> {
        let (mut words, mut mask) = (from.words, 0);
        for rotary in &self.rotary.axes {
            let index = rotary.index;
            let Some(&angle) = park.get(&self.chain[index].letter) else { continue };
            let word = self.rotary_word(index, angle)?;
            let nearest = || rotary.nearest(word, words[index], self.rotary.scale.units_per_turn).unwrap_or(word);
            words[index] = if self.rotary.wrapped & (1 << index) != 0 { nearest() } else { word };
            mask |= 1 << index;
        }
        Ok((self.position_at(&from.pose, from, &words), mask))
    }

    /// Whether an axis rolls over: its words are within one revolution.
    pub(crate) fn rolls(&self, index: usize) -> bool {
        self.rotary.wrapped & (1 << index) != 0
    }

    /// Whether a control that rotates by the shorter path would rotate an axis in the wrong direction in this block.
    #[inline]
    pub(crate) fn rolls_over(&self, from: &AxisPosition, to: &AxisPosition) -> bool {
        let half_a_revolution = |rotary: &Rotary| {
            self.rotary.wrapped & (1 << rotary.index) != 0
                && 2 * from.words[rotary.index].abs_diff(to.words[rotary.index])
                    >= self.rotary.scale.units_per_turn.unsigned_abs()
        };
        self.rotary.wrapped != 0 && self.rotary.axes.iter().any(half_a_revolution)
    }

    /// Distance of a position below the machine retract along the tool axis of the zero position, mm; `None` if it
    /// cannot be known. `retract_mm`: machine coordinate.
    pub(crate) fn below_retract(&self, place: &AxisPosition, retract_mm: f64) -> Option<f64> {
        let retracted = self.travel.value_at(self.linear.retract_axis, retract_mm)?;
        Some((retracted - place.axes[self.linear.retract_axis]) * self.linear.retract_share.signum())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::config::Config;
    use crate::kinematics::Machine;
    use crate::kinematics::machines::{Ay, Cb, Head, Xyz};

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
    fn only_a_machine_without_a_rotary_in_the_head_retracts_along_the_tool() {
        assert!(
            placer::<Cb>().retracts_along_tool()
                && placer::<Ay>().retracts_along_tool()
                && placer::<Xyz>().retracts_along_tool()
        );
        assert!(!placer::<Head>().retracts_along_tool() && placer::<Head>().has_rotary_head());
    }
}
