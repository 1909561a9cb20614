//! Words of axis values: whole units of the last decimal of an address.
//!
//! Rounding comes first: the rotary words are rounded, then the linear axes are computed for the *rounded* angles. Both
//! happen for each pose of a program, so they are compiled for each machine, with its number of axes and their places
//! in the chain.

use nalgebra::Point3;
use wide::f64x2;

use super::any::trimmed;
use super::math::{rounded, rounded_below, rounded_both, sqrt};
use super::{Axis, AxisKind, AxisValues, MAX_AXES, Machine, RotaryAngles};

/// Words in chain order, in whole units: of linear axes as written, of rotary axes those of the axis values.
pub(crate) type AxisUnits = [i64; MAX_AXES];

/// Resolution of the linear words, and range of all.
#[derive(Debug, Clone, PartialEq)]
pub struct LinearScale {
    /// Units in 1 mm.
    pub units_per_mm: f64,
    /// The axes are perpendicular to each other at any rotary angles.
    pub orthogonal: bool,
    /// Half a unit less than the bounds of the absolute words of all axes, linear and rotary; the bounds are exclusive.
    pub most_units: AxisValues,
}

/// Resolution of the words of both rotary axes, side by side; one that a machine does not have never rotates.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct RotaryScale {
    units_per_degree: f64x2,
    units_per_turn: f64x2,
    /// Axis values at word 0, degrees.
    rest_deg: f64x2,
}

impl RotaryScale {
    /// The scale of some axes, at most two.
    pub(crate) fn new(rotaries: &[Rotary], scale: AngleScale) -> Self {
        let rest_deg = [0, 1].map(|axis| rotaries.get(axis).map_or(0.0, |rotary: &Rotary| rotary.rest_deg));
        Self {
            units_per_degree: f64x2::splat(scale.units_per_degree),
            units_per_turn: f64x2::splat(scale.units_per_turn as f64),
            rest_deg: rest_deg.into(),
        }
    }

    /// Units in one revolution, of each axis.
    #[inline(always)]
    pub(crate) fn units_per_turn(&self) -> f64x2 {
        self.units_per_turn
    }

    /// The words nearest to two angles, rad; `None` if one is half way between two words.
    #[inline(always)]
    pub(crate) fn words(&self, angles: &RotaryAngles) -> Option<f64x2> {
        rounded_both((f64x2::from(angles.map(f64::to_degrees)) - self.rest_deg) * self.units_per_degree)
    }
}

/// Words of poses, computed in the loops of one machine.
pub trait PoseWords {
    /// Sets the linear words of a tip at the rotary axis values of `axes`, and the axis values of these words.
    /// `shifts`: written word minus axis value, mm; of a rotary axis minus its word, in units. Returns the largest
    /// displacement of the tip by the rounding, mm; `None`, with any words, where the axes are degenerate or a written
    /// word, also a rotary one, has more digits than it may.
    fn set_linear_words(
        &self,
        tip: &Point3<f64>,
        scale: &LinearScale,
        shifts: &AxisValues,
        axes: &mut AxisValues,
        words: &mut AxisUnits,
    ) -> Option<f64>;
}

/// Positions in the chain of the solved axes of one kind, and their number.
const fn solved(chain: &[Axis], rotary: bool) -> ([usize; MAX_AXES], usize) {
    let (mut places, mut count, mut index) = ([0; MAX_AXES], 0, 0);
    while index < chain.len() {
        if matches!(chain[index].kind, AxisKind::Rotary) == rotary && !chain[index].held {
            places[count] = index;
            count += 1;
        }
        index += 1;
    }
    (places, count)
}

impl<M: Machine> PoseWords for M {
    #[inline]
    fn set_linear_words(
        &self,
        tip: &Point3<f64>,
        scale: &LinearScale,
        shifts: &AxisValues,
        axes: &mut AxisValues,
        words: &mut AxisUnits,
    ) -> Option<f64> {
        let (places, count) = const { solved(M::AXES, false) };
        let (rotary_places, rotary_count) = const { solved(M::AXES, true) };
        let values = Machine::linear_axes(self, tip, &trimmed::<M>(axes))?;
        let (mut sum, mut squares) = (0.0, 0.0);
        for &index in &places[..count] {
            let (value, shift) = (values.as_ref()[index], shifts[index]);
            let word = rounded_below((value + shift) * scale.units_per_mm, scale.most_units[index])?;
            let written = word as f64 / scale.units_per_mm - shift;
            let off = written - value;
            (axes[index], words[index]) = (written, word);
            sum += off.abs();
            squares += off * off;
        }
        let fits = |&index: &usize| (words[index] as f64 + shifts[index]).abs() < scale.most_units[index];
        let fit = rotary_places[..rotary_count].iter().all(fits);
        fit.then(|| if scale.orthogonal { sqrt(squares) } else { sum })
    }
}

/// A solved rotary axis and the range of its words.
///
/// The words are axis values; the zero of the written words is applied when they are written.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Rotary {
    /// Position in the chain.
    pub(crate) index: usize,
    /// Smallest word, inclusive; `None` for an endless axis.
    pub(crate) lower: Option<i64>,
    /// Largest word, inclusive; `None` for an endless axis.
    pub(crate) upper: Option<i64>,
    /// Axis value at word 0: the part of a rotary offset that is smaller than one unit.
    pub(crate) rest_deg: f64,
}

/// A rotary axis that is outside its limits in every whole turn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct OutOfLimits {
    /// The axis.
    pub(crate) rotary: Rotary,
    /// Its word nearest to the previous one, outside the limits.
    pub(crate) word: i64,
}

/// Resolution of rotary words.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct AngleScale {
    /// Units in one degree.
    pub(crate) units_per_degree: f64,
    /// Units in one revolution.
    pub(crate) units_per_turn: i64,
}

impl AngleScale {
    pub(crate) fn new(decimals: u32) -> Self {
        let units_per_degree = 10_i64.pow(decimals);
        Self { units_per_degree: units_per_degree as f64, units_per_turn: 360 * units_per_degree }
    }

    /// The word nearest to an angle, rad.
    #[inline(always)]
    pub(crate) fn word(self, angle_rad: f64) -> i64 {
        rounded(angle_rad.to_degrees() * self.units_per_degree)
    }

    /// Angle of a word or of a difference of words, rad.
    #[inline(always)]
    pub(crate) fn angle(self, word: i64) -> f64 {
        self.degrees(word).to_radians()
    }

    /// Angle of a word or of a difference of words, degrees.
    #[inline(always)]
    pub(crate) fn degrees(self, word: i64) -> f64 {
        word as f64 / self.units_per_degree
    }
}

impl Rotary {
    /// The word nearest to an axis value, rad.
    #[inline(always)]
    pub(crate) fn word(self, angle_rad: f64, scale: AngleScale) -> i64 {
        rounded((angle_rad.to_degrees() - self.rest_deg) * scale.units_per_degree)
    }

    /// Axis value of a word, rad.
    #[inline(always)]
    pub(crate) fn angle(self, word: i64, scale: AngleScale) -> f64 {
        self.degrees(word, scale).to_radians()
    }

    /// Axis value of a word for messages, degrees.
    pub(crate) fn degrees_for_display(self, word: i64, scale: AngleScale) -> f64 {
        (self.degrees(word, scale) * 1e9).round() / 1e9
    }

    /// Axis value of a word, degrees.
    fn degrees(self, word: i64, scale: AngleScale) -> f64 {
        scale.degrees(word) + self.rest_deg
    }

    /// Whether the axis has no limits, so that any whole turn is allowed.
    pub(crate) fn endless(self) -> bool {
        self.lower.is_none() || self.upper.is_none()
    }

    /// The same axis without its limits.
    pub(crate) fn without_limits(self) -> Self {
        Self { lower: None, upper: None, ..self }
    }

    /// Whether a word is inside the limits.
    pub(crate) fn contains(&self, word: i64) -> bool {
        self.lower.is_none_or(|lower| word >= lower) && self.upper.is_none_or(|upper| word <= upper)
    }

    /// Smallest word; 0 for an endless axis.
    pub(crate) fn lower_end(self) -> i64 {
        self.lower.unwrap_or_default()
    }

    /// Largest word; 0 for an endless axis.
    pub(crate) fn upper_end(self) -> i64 {
        self.upper.unwrap_or_default()
    }

    /// The word inside the limits that is nearest to this one; not only by whole turns.
    pub(crate) fn clamped(self, word: i64) -> i64 {
        let word = self.upper.map_or(word, |upper| word.min(upper));
        self.lower.map_or(word, |lower| word.max(lower))
    }

    /// Words inside the limits that equal `word` modulo one revolution, nearest to zero first, at most `most` of them;
    /// for an endless axis only the one nearest to zero. `turn`: units in one revolution.
    pub(crate) fn turns(self, word: i64, turn: i64, most: i64) -> impl Iterator<Item = i64> {
        let nearest = self.without_limits().nearest(word, 0, turn).unwrap_or(word);
        // Beyond the farthest turn inside the limits there is none.
        let farthest = match (self.lower, self.upper) {
            (Some(lower), Some(upper)) => ((upper - nearest) / turn).max((nearest - lower) / turn).max(0),
            _ => 0,
        };
        let count = most.min(2 * farthest + 1);
        let step_towards_zero = if nearest > 0 { -turn } else { turn };
        // The nearest, one turn towards zero and past it, one turn away, two turns towards zero, ...
        let all = (0..count)
            .map(move |step| nearest + step_towards_zero * if step % 2 == 1 { (step + 1) / 2 } else { -step / 2 });
        all.filter(move |&word| self.contains(word))
    }

    /// Whether at most one word of a revolution is inside the limits, or taken: of an endless axis the one nearest to
    /// zero.
    pub(crate) fn has_one_turn(self, turn: i64) -> bool {
        self.lower.zip(self.upper).is_none_or(|(lower, upper)| upper - lower < turn)
    }

    /// The only one of [`turns`](Self::turns), where [`has_one_turn`](Self::has_one_turn); `None` if it is outside.
    #[inline]
    pub(crate) fn only_turn(self, word: i64, turn: i64) -> Option<i64> {
        match self.lower.zip(self.upper) {
            Some((lower, upper)) => Some(lower + (word - lower).rem_euclid(turn)).filter(|word| *word <= upper),
            None => {
                let above = word.rem_euclid(turn);
                Some(if 2 * above > turn { above - turn } else { above })
            }
        }
    }

    /// The word inside the limits that equals `word` modulo one revolution and is nearest to `previous`; at equal
    /// distance the one of smaller absolute value, then the positive one. `turn`: units in one revolution.
    #[inline]
    pub(crate) fn nearest(&self, word: i64, previous: i64, turn: i64) -> Result<i64, OutOfLimits> {
        let near = if 2 * (previous - word).abs() < turn { word } else { nearest_of_all(word, previous, turn) };
        if self.contains(near) { Ok(near) } else { self.nearest_inside(near, turn) }
    }

    /// The word inside the limits that is the fewest turns from one outside.
    #[cold]
    fn nearest_inside(&self, near: i64, turn: i64) -> Result<i64, OutOfLimits> {
        let out = OutOfLimits { rotary: *self, word: near };
        let mut choice = near;
        if let Some(upper) = self.upper
            && choice > upper
        {
            choice -= (choice - upper + turn - 1).div_euclid(turn) * turn;
        }
        if let Some(lower) = self.lower
            && choice < lower
        {
            choice += (lower - choice + turn - 1).div_euclid(turn) * turn;
        }
        // Each candidate may be inside at its own limit only: the nearer one has been chosen above.
        if self.contains(choice) { Ok(choice) } else { Err(out) }
    }
}

/// The word that equals `word` modulo one revolution and is nearest to `previous`, as in [`Rotary::nearest`].
fn nearest_of_all(word: i64, previous: i64, turn: i64) -> i64 {
    // The candidates next to the previous word: at or below it, and above it.
    let below = word + (previous - word).div_euclid(turn) * turn;
    let above = below + turn;
    if (previous - below, below.abs(), -below) <= (above - previous, above.abs(), -above) { below } else { above }
}

#[cfg(test)]
mod tests {
    use nalgebra::UnitVector3;
    use proptest::prelude::*;

    use super::*;
    use crate::kinematics::machines::{Ay, Cb, Head, Mirrored, Xyz};
    use crate::kinematics::math::LARGEST_SHIFTED;
    use crate::kinematics::{AnyMachine, Branch};
    use crate::nc::whole_units;

    /// Numbers that make limits, half turns and halves of a unit likely.
    #[derive(Debug, Clone)]
    struct Case {
        axis: [f64; 3],
        tip: [f64; 3],
        before: [i64; 2],
        rest_deg: f64,
        shift_mm: f64,
        digits: u32,
        second: bool,
    }

    fn cases() -> impl Strategy<Value = Case> {
        let number = || prop_oneof![-1.0..1.0_f64, (-2_i32..=2).prop_map(|half| f64::from(half) * 0.5)];
        let length = || prop_oneof![-2e3..2e3_f64, (-9999_i32..9999).prop_map(|half| f64::from(half) * 0.0005)];
        (
            prop::array::uniform3(number()).prop_filter("a direction", |axis| axis.iter().any(|part| part.abs() > 0.1)),
            prop::array::uniform3(length()),
            prop::array::uniform2(prop_oneof![-1_800_i64..1_800, -9_000_000_i64..9_000_000]),
            prop_oneof![Just(0.0), -0.05..0.05_f64],
            prop_oneof![Just(0.0), -500.0..500.0_f64],
            4_u32..8,
            any::<bool>(),
        )
            .prop_map(|(axis, tip, before, rest_deg, shift_mm, digits, second)| Case {
                axis,
                tip,
                before,
                rest_deg,
                shift_mm,
                digits,
                second,
            })
    }

    /// The words in the loops of one machine are those that are found one by one.
    fn compare<M: Machine>(case: &Case) -> Result<(), TestCaseError> {
        let machine = M::default();
        let (scale, units_per_mm) = (AngleScale::new(1), 1000.0);
        let places = |kind: AxisKind| {
            let solved = M::AXES.iter().enumerate().filter(move |(_, axis)| axis.kind == kind && !axis.held);
            solved.map(|(index, _)| index).collect::<Vec<_>>()
        };
        let (held, branch) = (machine.held(), if case.second { Branch::Second } else { Branch::First });
        let axis = UnitVector3::new_normalize(case.axis.into());
        let solutions = AnyMachine::rotary_axes(&machine, &axis, &held);
        let solution = solutions.iter().find(|solution| solution.branch == branch);
        let (mut rotaries, mut expected) = (Vec::new(), AxisUnits::default());
        for (axis, index) in places(AxisKind::Rotary).into_iter().enumerate() {
            let endless = Rotary { index, lower: None, upper: None, rest_deg: case.rest_deg };
            let angle = solution.map_or(0.0, |solution| solution.axes[axis]);
            let near = nearest_of_all(endless.word(angle, scale), case.before[axis], scale.units_per_turn);
            expected[index] = near;
            rotaries.push(endless);
        }
        let mut at = held;
        for rotary in &rotaries {
            at[rotary.index] = rotary.angle(expected[rotary.index], scale);
        }
        let (tip, most) = (Point3::from(case.tip), 10_i64.pow(case.digits));
        let mut linear =
            LinearScale { units_per_mm, orthogonal: case.second, most_units: [most as f64 - 0.5; MAX_AXES] };
        let mut shifts = [case.shift_mm; MAX_AXES];
        rotaries.iter().for_each(|rotary| shifts[rotary.index] = case.before[0] as f64);
        let (mut axes, mut words) = (at, expected);
        let found = machine.set_linear_words(&tip, &linear, &shifts, &mut axes, &mut words);
        let Some(values) = (&machine as &dyn AnyMachine).linear_axes(&tip, &at) else {
            prop_assert_eq!(found, None);
            return Ok(());
        };
        let written = |rotary: &Rotary| expected[rotary.index] + case.before[0];
        let (mut reached, mut fits) = (at, rotaries.iter().all(|rotary| written(rotary).abs() < most));
        let mut off = Vec::new();
        for index in places(AxisKind::Linear) {
            let units = whole_units(values[index] + case.shift_mm, units_per_mm).expect("few units");
            expected[index] = units;
            fits &= units.abs() < most;
            reached[index] = units as f64 / units_per_mm - case.shift_mm;
            off.push((reached[index] - values[index]).abs());
        }
        prop_assert_eq!(found.is_some(), fits);
        if let Some(rounding_mm) = found {
            prop_assert_eq!((words, axes.map(f64::to_bits)), (expected, reached.map(f64::to_bits)));
            let least =
                if linear.orthogonal { off.iter().map(|off| off * off).sum::<f64>().sqrt() } else { off.iter().sum() };
            prop_assert!((rounding_mm - least).abs() <= 1e-15, "{} {}", rounding_mm, least);
        }
        // A bound that no number of binary64 has a half beside.
        linear.most_units = [LARGEST_SHIFTED - 0.5; MAX_AXES];
        prop_assert!(
            machine.set_linear_words(&Point3::new(1e13, 0.0, 0.0), &linear, &shifts, &mut axes, &mut words).is_none()
        );
        Ok(())
    }

    proptest! {
        #[test]
        fn words_of_a_machine_are_those_that_are_found_one_by_one(case in cases()) {
            compare::<Cb>(&case)?;
            compare::<Head>(&case)?;
            compare::<Ay>(&case)?;
            compare::<Mirrored>(&case)?;
            compare::<Xyz>(&case)?;
        }
    }
}
