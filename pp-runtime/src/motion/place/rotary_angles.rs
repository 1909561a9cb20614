//! Rotary angles of a pose: branch and turn, the pole, indexed axes, and the angles of the course.

use nalgebra::UnitVector3;

use crate::diag::code::plan;
use crate::kinematics::{
    AxisValues, Branch, OutOfLimits, Pose, REACH_TOLERANCE, Rotary, RotaryAngles, Side, Solution, Solutions, math,
};
use crate::program::{RotaryDirection, Rotation};

use super::linearise::PathTolerance;
use super::refusal;
use super::{AxisPosition, Placer};
use crate::motion::fault::Fault;
use crate::motion::geometry::angle_between;
use crate::motion::rotary::{Choice, MAX_TURNS, RotaryTarget, RotaryWords, RotationSense, choose};
use crate::motion::step::MAX_AXES;
use crate::shortcut::Shortcut;
use crate::tolerance::writer::{HELD_AXIS, LIMIT_SWING};

/// What the choice of rotary angles reads of a position.
#[derive(Debug, Clone, Copy, PartialEq)]
struct RotariesAt {
    words: RotaryWords,
    branch: Branch,
    at_pole: bool,
}

impl RotariesAt {
    #[inline]
    fn of(placer: &Placer, place: &AxisPosition) -> Self {
        Self { words: placer.rotary_words_of(&place.words), branch: place.branch, at_pole: place.at_pole }
    }
}

/// A motion that kept its rotary angles. One of its kind that begins like it, with the same tool axis, keeps them, too:
/// nothing needs to be solved.
#[derive(Debug, Clone, Copy)]
pub(super) struct Stay {
    feed: bool,
    axis: UnitVector3<f64>,
    at: RotariesAt,
    /// Tool axis of the position: at a pole that of the pole.
    reached: UnitVector3<f64>,
    deviation_rad: f64,
}

impl Placer {
    /// Sense of ROTABL/NEXT for the rotary axis of the table, if there are two for the one nearest the workpiece. Seen
    /// against its axis a table rotates clockwise while its word increases, unless the word runs backwards.
    pub(crate) fn rotation_sense(&self, turning: RotaryDirection) -> Option<RotationSense> {
        let RotaryDirection::Towards(rotation) = turning else { return None };
        let table = |rotary: &Rotary| self.chain[rotary.index].side == Side::Workpiece;
        let axis = self.rotary.axes.iter().position(table)?;
        let forwards = self.machine.joint(self.rotary.axes[axis].index).sign > 0.0;
        Some(RotationSense { axis, positive: (rotation == Rotation::Clockwise) == forwards })
    }

    /// Word of a rotary axis at an angle; of an indexed axis the nearest of its steps.
    #[inline]
    pub(crate) fn indexed_word(&self, rotary: &Rotary, angle_rad: f64) -> i64 {
        let word = rotary.word(angle_rad, self.rotary.scale);
        let step = self.rotary.grid.iter().find(|(indexed, _)| indexed.index == rotary.index);
        step.map_or(word, |(_, step)| nearest_step(word, *step))
    }

    /// Moves indexed axes to the nearest of their steps; refuses an angle between steps, and an indexed rotation in a
    /// cut.
    #[cold]
    pub(crate) fn snap_to_index(&self, place: &mut AxisPosition, from: &AxisPosition, feed: bool) -> Result<(), Fault> {
        for &(rotary, step) in &self.rotary.grid {
            let index = rotary.index;
            let word = place.words[index];
            let snapped = nearest_step(word, step);
            place.words[index] = snapped;
            place.axes[index] = rotary.angle(snapped, self.rotary.scale);
            let reached = self.machine.forward_kinematics(&place.axes).axis;
            let deviation = angle_between(&reached, &place.pose.axis);
            // The other words are rounded.
            let rounded_rad = 0.5 * self.rotary.scale.angle(1) * self.rotary.axes.len() as f64;
            let allowed_rad = self.poles.tolerance_rad.max(HELD_AXIS) + rounded_rad;
            if deviation > allowed_rad || !rotary.contains(snapped) {
                return Err(self.between_steps(&rotary, word, step));
            }
            place.deviation_rad = place.deviation_rad.max(deviation);
            if feed && snapped != from.words[index] {
                let letter = self.chain[index].letter;
                let degrees = |word| rotary.degrees_for_display(word, self.rotary.scale);
                return Err(plan::INDEXING
                    .fault(format_args!(
                        "{letter} would have to rotate from {}° to {}° in the cut, but it is an indexed axis",
                        degrees(from.words[index]),
                        degrees(snapped)
                    ))
                    .help("program this operation with a fixed tool axis"));
            }
        }
        Ok(())
    }

    /// The fault that an indexed axis would have to rotate to a word between its steps.
    #[cold]
    fn between_steps(&self, rotary: &Rotary, word: i64, step: i64) -> Fault {
        let scale = self.rotary.scale;
        plan::INDEXING
            .fault(format_args!(
                "{} would have to rotate to {}°, which is not a multiple of its indexing step of {}°",
                self.chain[rotary.index].letter,
                rotary.degrees_for_display(word, scale),
                scale.degrees(step)
            ))
            .help(
                "move the tool axis of the operation to a step in CAM; to move it to a step at the pole, increase \
             `axis_tolerance` in [course]",
            )
    }

    /// The fault that words of the course do not give a tool axis: an indexed axis is at a step there.
    #[cold]
    fn not_reached(&self, axis: &UnitVector3<f64>, place: &AxisPosition) -> Fault {
        let (solutions, scale) = (self.machine.rotary_axes(axis, &place.axes), self.rotary.scale);
        let between = self.rotary.grid.iter().find_map(|&(rotary, step)| {
            let solved = self.rotary.axes.iter().position(|axis| axis.index == rotary.index)?;
            let at = place.words[rotary.index];
            let near = |solution: &Solution<RotaryAngles>| {
                let word = rotary.word(solution.axes[solved], scale);
                rotary.without_limits().nearest(word, at, scale.units_per_turn).unwrap_or(word)
            };
            let word = solutions.iter().map(near).min_by_key(|word| word.abs_diff(at))?;
            (word != at).then(|| self.between_steps(&rotary, word, step))
        });
        between.unwrap_or_else(|| {
            plan::INTERNAL
                .fault("the planned rotary angles do not give the tool axis of this point")
                .help("this is a fault of the postprocessor, not of the CL data")
        })
    }

    /// Keeps indexed axes at their angles inside a cut; refuses a deviation of the tool axis beyond the tolerance.
    #[inline]
    pub(crate) fn hold_indexed(
        &self,
        place: &mut AxisPosition,
        from: &AxisPosition,
        allowed: PathTolerance,
    ) -> Result<(), Fault> {
        for &(rotary, step) in &self.rotary.grid {
            let index = rotary.index;
            let (wanted, held) = (place.words[index], from.words[index]);
            place.words[index] = held;
            place.axes[index] = from.axes[index];
            let reached = self.machine.forward_kinematics(&place.axes).axis;
            place.deviation_rad = place.deviation_rad.max(angle_between(&reached, &place.pose.axis));
            // The deviation of an end counts twice: see `axis_off` in `linearise`.
            if 2.0 * place.deviation_rad >= allowed.axis_rad {
                let (letter, degrees) =
                    (self.chain[index].letter, |word| rotary.degrees_for_display(word, self.rotary.scale));
                return Err(plan::INDEXING.fault(format_args!(
                    "{letter} would have to rotate from {}° to {}° in the cut, but it is an indexed axis with steps of {}°",
                    degrees(held),
                    degrees(wanted),
                    self.rotary.scale.degrees(step)
                ))
                .help("program this operation with a fixed tool axis, or with points closer together"));
            }
        }
        Ok(())
    }

    /// Pole to which a tool axis is parallel, within the tolerance.
    #[inline(always)]
    pub(crate) fn pole(&self, axis: &UnitVector3<f64>) -> Option<UnitVector3<f64>> {
        let square = self.poles.tolerance_rad * self.poles.tolerance_rad;
        if self.poles.are_farther(axis, square) { None } else { self.pole_within(axis, square) }
    }

    /// Pole within a distance from a tool axis, of which this is the square.
    fn pole_within(&self, axis: &UnitVector3<f64>, square: f64) -> Option<UnitVector3<f64>> {
        let near = |pole: &&UnitVector3<f64>| (pole.into_inner() - axis.into_inner()).norm_squared() <= square;
        self.poles.axes.iter().find(near).copied()
    }

    /// Chooses the rotary angles of a pose, or keeps those at which the motion before has stayed with the same tool
    /// axis. Sets all of the position `to` but for its linear axes.
    #[inline(always)]
    pub(super) fn set_rotaries_for(
        &mut self,
        pose: &Pose,
        from: &AxisPosition,
        feed: bool,
        to: &mut AxisPosition,
    ) -> Result<(), Fault> {
        if let Some(stay) = &self.stay
            && Shortcut::RotariesAtRest.is_on()
            && stay.feed == feed
            && stay.axis == pose.axis
            && stay.at == RotariesAt::of(self, from)
        {
            self.set_rotaries(to, &Pose { axis: stay.reached, ..*pose }, &stay.at.words);
            (to.branch, to.at_pole, to.deviation_rad) = (stay.at.branch, stay.at.at_pole, stay.deviation_rad);
            return Ok(());
        }
        self.choose_rotaries(pose, from, feed, to)?;
        if to.pose.axis == from.pose.axis {
            self.stay = self.stay_at(pose, from, feed, to);
        } else {
            self.stay = None;
        }
        Ok(())
    }

    /// The motion to `pose`, if it kept the rotary angles.
    fn stay_at(&self, pose: &Pose, from: &AxisPosition, feed: bool, to: &AxisPosition) -> Option<Stay> {
        let at = RotariesAt::of(self, from);
        let stay = Stay { feed, axis: pose.axis, at, reached: to.pose.axis, deviation_rad: to.deviation_rad };
        (RotariesAt::of(self, to) == at).then_some(stay)
    }

    /// Chooses the rotary angles of a pose from the present ones: a feed motion stays on its branch, a rapid takes the
    /// least travel. Refuses a feed motion in which limits force another turn than the nearest: the tool is in the cut.
    /// Sets all of the position `to` but for its linear axes.
    #[inline(always)]
    fn choose_rotaries(
        &self,
        pose: &Pose,
        from: &AxisPosition,
        feed: bool,
        to: &mut AxisPosition,
    ) -> Result<(), Fault> {
        if let Some(pole) = self.pole(&pose.axis) {
            *to = self.rotaries_at_pole(pose, pole, from)?;
            return Ok(());
        }
        self.choose_branch(pose, from, feed, to)
    }

    /// Chooses branch and turns of a pose from the present ones.
    fn choose_branch(&self, pose: &Pose, from: &AxisPosition, feed: bool, to: &mut AxisPosition) -> Result<(), Fault> {
        let solutions = self.machine.rotary_axes(&pose.axis, &from.axes);
        if solutions.is_empty() {
            return Err(refusal::unreachable(self, pose, &from.axes));
        }
        let before = self.rotary_words_of(&from.words);
        let same = solutions.iter().position(|solution| solution.branch == from.branch && feed && !from.at_pole);
        let of_branch = same.map_or(0..solutions.len(), |same| same..same + 1);
        let branch = &solutions[of_branch.clone()];
        let Choice { solution, words } = self.choose_words(&solutions, of_branch, &before)?;
        let solution = &branch[solution];
        self.set_rotaries(to, pose, &words);
        (to.branch, to.deviation_rad) = (solution.branch, solution.deviation);
        if feed && self.rotary.limited {
            self.check_swing(branch, &before, &words)?;
        }
        Ok(())
    }

    /// The nearest of the wanted solutions, with indexed axes at their steps where only those are inside the limits.
    fn choose_words(
        &self,
        solutions: &Solutions<RotaryAngles>,
        wanted: std::ops::Range<usize>,
        before: &RotaryWords,
    ) -> Result<Choice, Fault> {
        let outside = match choose(&solutions[wanted.clone()], &self.rotary.axes, before, self.rotary.scale) {
            Ok(choice) => return Ok(choice),
            Err(outside) => outside,
        };
        self.choose_steps(solutions, wanted, before).ok_or_else(|| self.outside_limits(solutions, before, &outside))
    }

    /// The fault that no turn of the branch of a feed motion, or of either branch, is inside the limits.
    #[cold]
    fn outside_limits(
        &self,
        solutions: &[Solution<RotaryAngles>],
        before: &RotaryWords,
        of_branch: &[Option<OutOfLimits>; 2],
    ) -> Fault {
        let of_both = choose(solutions, &self.rotary.axes, before, self.rotary.scale).err();
        refusal::outside_limits(self, of_both.as_ref().unwrap_or(of_branch))
    }

    /// Refuses a swing of the tool in the cut: another turn than the nearest, which limits force.
    fn check_swing(
        &self,
        branch: &[Solution<RotaryAngles>],
        before: &RotaryWords,
        after: &RotaryWords,
    ) -> Result<(), Fault> {
        let travel = (after[0] - before[0]).abs().max((after[1] - before[1]).abs());
        if self.rotary.scale.angle(travel) <= LIMIT_SWING {
            return Ok(());
        }
        match choose(branch, &self.rotary.endless, before, self.rotary.scale) {
            Ok(nearest) if nearest.words != *after => Err(refusal::jump(self, before, after, &nearest.words)),
            _ => Ok(()),
        }
    }

    /// Sets the rotary words and angles of a position, and its pose. The linear axes are not computed.
    #[inline]
    fn set_rotaries(&self, to: &mut AxisPosition, pose: &Pose, words: &RotaryWords) {
        to.pose = *pose;
        for (rotary, word) in self.rotary.axes.iter().zip(words) {
            to.words[rotary.index] = *word;
            to.axes[rotary.index] = rotary.angle(*word, self.rotary.scale);
        }
        (to.deviation_rad, to.at_pole, to.rounding_mm) = (0.0, false, 0.0);
    }

    /// The nearest of these solutions with indexed axes at their steps: a step may be inside the limits although the
    /// angle is not. `None` without indexed axes, or if all are outside.
    #[cold]
    fn choose_steps(
        &self,
        solutions: &Solutions<RotaryAngles>,
        wanted: std::ops::Range<usize>,
        before: &RotaryWords,
    ) -> Option<Choice> {
        if !self.has_indexed_axes() {
            return None;
        }
        let stepped = solutions.map(|angles| {
            let mut angles = *angles;
            for (angle, rotary) in angles.iter_mut().zip(&self.rotary.axes) {
                *angle = rotary.angle(self.indexed_word(rotary, *angle), self.rotary.scale);
            }
            angles
        });
        choose(&stepped[wanted], &self.rotary.axes, before, self.rotary.scale).ok()
    }

    /// Rotary angles at the pole, where the first rotary axis keeps its value: the direction that CL data gives there
    /// is only rounding.
    pub(crate) fn rotaries_at_pole(
        &self,
        pose: &Pose,
        pole: UnitVector3<f64>,
        from: &AxisPosition,
    ) -> Result<AxisPosition, Fault> {
        let pose_at_pole = Pose { axis: pole, ..*pose };
        let solutions = self.machine.rotary_axes(&pole, &from.axes);
        if solutions.is_empty() {
            return Err(refusal::unreachable(self, &pose_at_pole, &from.axes));
        }
        // In the solutions the free rotary axis has its previous value.
        let choice = choose(&solutions, &self.rotary.axes, &self.rotary_words_of(&from.words), self.rotary.scale)
            .map_err(|outside| refusal::outside_limits(self, &outside))?;
        let mut place = self.position_at(&pose_at_pole, from, &self.all_words(&choice.words));
        place.at_pole = true;
        place.deviation_rad = angle_between(&pole, &pose.axis);
        Ok(place)
    }

    /// Position of a pose at these rotary words; the linear axes are not computed.
    #[inline]
    pub(crate) fn position_at(&self, pose: &Pose, from: &AxisPosition, words: &[i64; MAX_AXES]) -> AxisPosition {
        let mut place = AxisPosition { words: *words, ..*from };
        self.set_rotaries(&mut place, pose, &self.rotary_words_of(words));
        place
    }

    /// Position of a pose at the rotary words of the course; the linear axes are not computed.
    pub(crate) fn follow_course(
        &self,
        pose: &Pose,
        from: &AxisPosition,
        target: &RotaryTarget,
    ) -> Result<AxisPosition, Fault> {
        let pole = self.pole(&pose.axis);
        let target_pose = Pose { axis: pole.unwrap_or(pose.axis), ..*pose };
        let mut words = self.all_words(&target.words);
        for (axis, rotary) in self.rotary.axes.iter().enumerate().filter(|(_, rotary)| rotary.endless()) {
            let (word, before) = (&mut words[rotary.index], from.words[rotary.index]);
            *word = rotary.nearest(*word, before, self.rotary.scale.units_per_turn).unwrap_or(*word);
            if let Some(RotationSense { positive, .. }) = target.sense.filter(|sense| sense.axis == axis) {
                match *word - before {
                    change if change > 0 && !positive => *word -= self.rotary.scale.units_per_turn,
                    change if change < 0 && positive => *word += self.rotary.scale.units_per_turn,
                    _ => {}
                }
            }
        }
        let mut place = self.position_at(&target_pose, from, &words);
        let reached = self.machine.forward_kinematics(&place.axes).axis;
        // A path that is led through the pole may have been divided where its words are near those of the pole.
        if pole.is_some() && self.writes_vectors() {
            let at_pole = self.rotaries_at_pole(&target_pose, target_pose.axis, &place)?;
            place = self.position_at(&target_pose, from, &at_pole.words);
        }
        let off_step = if self.has_indexed_axes() { self.poles.tolerance_rad } else { REACH_TOLERANCE };
        if angle_between(&reached, &target_pose.axis) > 2.0 * self.rotary.scale.angle(1) + off_step {
            return Err(self.not_reached(&target_pose.axis, &place));
        }
        let solutions = self.machine.rotary_axes(&target_pose.axis, &place.axes);
        let off = |solution: &Solution<RotaryAngles>| -> f64 {
            let angles = self.rotary.axes.iter().zip(solution.axes);
            angles.map(|(rotary, angle)| 1.0 - math::sin_cos(angle - place.axes[rotary.index]).1).sum()
        };
        let nearest = solutions.iter().min_by(|a, b| off(a).total_cmp(&off(b)));
        place.branch = nearest.map_or(from.branch, |solution| solution.branch);
        place.at_pole = pole.is_some();
        place.deviation_rad = match pole {
            Some(pole) => angle_between(&pole, &pose.axis),
            None => nearest.map_or(0.0, |solution| solution.deviation),
        };
        Ok(place)
    }

    /// Words of all axes from those of the solved rotary axes; 0 for the others.
    pub(crate) fn all_words(&self, words: &RotaryWords) -> [i64; MAX_AXES] {
        let mut all = [0; MAX_AXES];
        for (rotary, word) in self.rotary.axes.iter().zip(words) {
            all[rotary.index] = *word;
        }
        all
    }

    /// Words of the solved rotary axes.
    pub(crate) fn rotary_words_of(&self, words: &[i64; MAX_AXES]) -> RotaryWords {
        let mut rotary_words = [0; 2];
        for (word, rotary) in rotary_words.iter_mut().zip(&self.rotary.axes) {
            *word = words[rotary.index];
        }
        rotary_words
    }

    /// Position of which only the rotary words are known.
    pub(crate) fn position_at_words(&self, words: &RotaryWords) -> AxisPosition {
        AxisPosition { words: self.all_words(words), axes: self.axes_of(words), ..self.zero() }
    }

    /// Axis values of rotary words, with held axes at their values.
    pub(crate) fn axes_of(&self, words: &RotaryWords) -> AxisValues {
        let mut axes = self.held;
        for (rotary, word) in self.rotary.axes.iter().zip(words) {
            axes[rotary.index] = rotary.angle(*word, self.rotary.scale);
        }
        axes
    }

    /// Whether an axis rotates in steps only.
    pub(crate) fn has_indexed_axes(&self) -> bool {
        !self.rotary.grid.is_empty()
    }

    /// Whether an axis may have turns inside its limits that are not among the [`MAX_TURNS`] nearest to zero.
    pub(crate) fn has_many_turns(&self) -> bool {
        let farthest = |rotary: &Rotary| Some(rotary.upper?.max(-rotary.lower?));
        let all_tried = MAX_TURNS / 2 * self.rotary.scale.units_per_turn;
        self.rotary.axes.iter().filter_map(farthest).any(|farthest| farthest >= all_tried)
    }
}

/// The multiple of a step that is nearest to a word.
fn nearest_step(word: i64, step: i64) -> i64 {
    (2 * word + step).div_euclid(2 * step) * step
}

#[cfg(test)]
mod tests {
    use nalgebra::{Point3, Vector3};
    use proptest::prelude::*;

    use super::*;
    use crate::config::Config;
    use crate::kinematics::machines::{Cb, Head, Mirrored};
    use crate::kinematics::{Limits, Machine};
    use crate::program::Units;

    /// Tool axes among which a motion often keeps the last one: at the pole, near it, tilted.
    const AXES: [[f64; 3]; 5] =
        [[0.0, 0.0, 1.0], [1e-6, 0.0, 1.0], [0.0, 2e-5, 1.0], [0.5, 0.0, 1.0], [-0.3, 0.4, 1.0]];

    /// Places of motions: tip, number of the tool axis, whether at feed. `keeps`: angles are kept from motion to
    /// motion.
    fn places<M: Machine>(
        limits: Option<f64>,
        motions: &[([f64; 3], usize, bool)],
        keeps: bool,
    ) -> Vec<Result<AxisPosition, Fault>> {
        let mut config = Config::default();
        for letter in ['B', 'C'].into_iter().filter(|_| limits.is_some()) {
            let limits = limits.map(|upper| Limits { lower: upper - 5.0, upper });
            config.set_up.limits.insert(letter, limits);
        }
        let machine = Box::new(config.set_up.machine::<M>().expect("valid"));
        let mut placer = Placer::new(machine, config.policy(), Units::Millimetres);
        let mut from = placer.zero();
        let place = |&(tip, axis, feed): &([f64; 3], usize, bool)| {
            if !keeps {
                placer.stay = None;
            }
            // Sometimes the axes have been parked.
            if tip[0] > 250.0 {
                from = placer.zero();
            }
            let axis = UnitVector3::new_normalize(Vector3::from(AXES[axis]));
            let place = placer.place(&Pose { tip: Point3::from(tip), axis }, &from, feed, None);
            if let Ok(place) = &place {
                // The tip of a position has its words.
                let tip = placer.machine().forward_kinematics(&place.axes).tip;
                let again = placer.shifted(tip, place).expect("the same words");
                assert_eq!((again.words, again.axes.map(f64::to_bits)), (place.words, place.axes.map(f64::to_bits)));
                assert!(again.rounding_mm < 1e-9, "{again:?}");
                from = *place;
            }
            place
        };
        motions.iter().map(place).collect()
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 60, ..ProptestConfig::default() })]

        #[test]
        fn a_motion_that_keeps_its_angles_has_the_place_of_one_whose_angles_are_chosen(
            motions in proptest::collection::vec(
                (proptest::array::uniform3(-400.0..400.0_f64), 0..AXES.len(), proptest::bool::ANY),
                1..40,
            ),
            same in 1..6_usize,
            limits in proptest::option::of(0.0..5.0_f64),
        ) {
            // Several motions with one tool axis.
            let axis = |index: usize| motions[index / same * same].1;
            let motions: Vec<_> =
                motions.iter().enumerate().map(|(index, &(tip, _, feed))| (tip, axis(index), feed)).collect();
            prop_assert_eq!(places::<Cb>(limits, &motions, true), places::<Cb>(limits, &motions, false));
            prop_assert_eq!(places::<Head>(limits, &motions, true), places::<Head>(limits, &motions, false));
            prop_assert_eq!(places::<Mirrored>(limits, &motions, true), places::<Mirrored>(limits, &motions, false));
        }
    }
}
