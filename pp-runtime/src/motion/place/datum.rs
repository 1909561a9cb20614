//! Zero of the written words.
//!
//! Planning uses axis values, for which limits hold. A written rotary word is the axis value minus `rotary_offset`.
//! Rounding comes first here, too: the part of the offset that is smaller than one unit of the word is kept in the axis
//! value. A linear word is measured from the part zero or from the reference point of the table, to the tip or to the
//! gauge line of the tool.

use nalgebra::Vector3;

use crate::kinematics::{AngleScale, AnyMachine, AxisValues};
use crate::motion::policy::Policy;
use crate::set_up::{LengthMode, ProgramZero, along_axes};

use crate::motion::step::MAX_AXES;
use crate::tolerance::writer::WORD_NOISE;

/// Offsets from axis values to written words, by position in the chain.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Datum {
    /// Linear words are measured from the reference point of the table.
    from_table: bool,
    /// Linear words minus axis values for a tool of no length.
    zero_mm: [f64; MAX_AXES],
    /// Addition to the linear words for 1 mm of gauge length.
    share: [f64; MAX_AXES],
    /// Written words minus axis values with the tool in the spindle: of linear axes, mm; of rotary axes minus their
    /// words, in units.
    shifts: AxisValues,
    /// Rotary offsets in units of words.
    offsets: [f64; MAX_AXES],
    /// Rotary offsets rounded to whole units.
    whole: [i64; MAX_AXES],
}

impl Datum {
    pub(crate) fn new(machine: &dyn AnyMachine, policy: Policy<'_>, scale: AngleScale) -> Self {
        let (mut offsets, mut whole) = ([0.0; MAX_AXES], [0; MAX_AXES]);
        for (index, axis) in machine.axes().iter().enumerate() {
            if let Some(offset) = policy.set_up.rotary_offset.get(&axis.letter) {
                offsets[index] = offset.to_degrees() * scale.units_per_degree;
                whole[index] = offsets[index].round() as i64;
            }
        }
        let zero_mm = match policy.set_up.program_zero {
            ProgramZero::Part => [0.0; MAX_AXES],
            ProgramZero::Table => along_axes(machine, &policy.set_up.part_origin.into()),
        };
        let share = match policy.set_up.length_mode {
            LengthMode::Tip => [0.0; MAX_AXES],
            LengthMode::Gauge => along_axes(machine, &machine.tool_axis()),
        };
        let from_table = policy.set_up.program_zero == ProgramZero::Table;
        let mut datum = Self { from_table, zero_mm, share, shifts: zero_mm, offsets, whole };
        datum.set_gauge_length(0.0);
        datum
    }

    /// Sets the position of the part zero from the reference point of the table; the gauge length has to be set again.
    pub(crate) fn set_part_origin(&mut self, machine: &dyn AnyMachine, origin: &Vector3<f64>) {
        if self.from_table {
            self.zero_mm = along_axes(machine, origin);
        }
    }

    /// Sets the gauge length of the tool in the spindle.
    pub(crate) fn set_gauge_length(&mut self, length_mm: f64) {
        let shift = |index: usize| self.zero_mm[index] + length_mm * self.share[index] - self.whole[index] as f64;
        self.shifts = std::array::from_fn(shift);
    }

    /// Word of a linear axis minus its axis value, mm.
    #[inline]
    pub(crate) fn linear_shift_mm(&self, index: usize) -> f64 {
        self.shifts[index]
    }

    /// Words minus values of all axes; of rotary ones the written word minus the word, in units.
    #[inline]
    pub(crate) fn shifts(&self) -> &AxisValues {
        &self.shifts
    }

    /// Part of the offset of a rotary axis that is smaller than one unit, degrees.
    pub(crate) fn rest_deg(&self, index: usize, scale: AngleScale) -> f64 {
        let rest = self.offsets[index] - self.whole[index] as f64;
        if rest.abs() < WORD_NOISE { 0.0 } else { rest / scale.units_per_degree }
    }

    /// Written words for words that are axis values.
    #[inline(always)]
    pub(crate) fn written(&self, words: &[i64; MAX_AXES]) -> [i64; MAX_AXES] {
        let mut written = *words;
        for (word, offset) in written.iter_mut().zip(&self.whole) {
            *word -= offset;
        }
        written
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::config::Config;
    use crate::kinematics::Machine;
    use crate::kinematics::machines::{Cb, Head};
    use crate::motion::tests::{Run, config, feed, rapid, run, spindle, tool};
    use crate::set_up::GivenTool;

    /// Tool axis at `C` and `B` degrees on the C-B table.
    fn axis(c: f64, b: f64) -> [f64; 3] {
        let ((sin_c, cos_c), (sin_b, cos_b)) = (c.to_radians().sin_cos(), b.to_radians().sin_cos());
        [sin_b * cos_c, sin_b * sin_c, cos_b]
    }

    fn posted(config: &Config, [c, b]: [f64; 2]) -> Run {
        let (tip, above) = ([10.0, 20.0, 5.0], [10.0, 20.0, 30.0]);
        run::<Cb>(config, &[tool(1), spindle(), rapid(above, axis(c, b)), feed(tip, axis(c, b))])
    }

    /// The last word of each axis.
    fn words(run: &Run) -> [f64; 5] {
        ['C', 'B', 'X', 'Y', 'Z'].map(|letter| {
            let words = run.lines.iter().filter(|line| !line.contains("G53")).flat_map(|line| line.split(' '));
            let last = words.filter_map(|word| word.strip_prefix(letter)).next_back();
            last.and_then(|word| word.parse().ok()).expect("a word of each axis")
        })
    }

    fn shifted(offsets: &[(char, f64)]) -> Config {
        let mut config = config();
        config.set_up.rotary_offset = offsets.iter().map(|&(letter, degrees)| (letter, degrees.to_radians())).collect();
        config
    }

    #[test]
    fn a_rotary_word_is_the_axis_value_minus_its_offset() {
        let (plain, moved) = (posted(&shifted(&[]), [100.0, 30.0]), posted(&shifted(&[('C', 12.5)]), [100.0, 30.0]));
        assert_eq!(moved.diagnostics, []);
        let mut expected = words(&plain);
        expected[0] -= 12.5;
        assert!(words(&moved).iter().zip(&expected).all(|(word, wanted)| (word - wanted).abs() < 1e-9));
        assert_eq!(plain.lines.len(), moved.lines.len());
    }

    #[test]
    fn the_part_of_an_offset_below_one_unit_is_in_the_axis_value() {
        let [c, b, x, y, z] = words(&posted(&shifted(&[('C', 12.500_03), ('B', -0.000_04)]), [100.0, 30.0]));
        assert!((c - 87.5).abs() < 1e-9 && (b - 30.0).abs() < 1e-9, "{c} {b}");
        let machine: Cb = config().set_up.machine().expect("valid");
        let tip = Machine::forward_kinematics(
            &machine,
            &[(c + 12.500_03).to_radians(), (b - 0.000_04).to_radians(), x, y, z],
        )
        .tip;
        assert!((tip - nalgebra::Point3::new(10.0, 20.0, 5.0)).norm() < 0.5e-3 * 3_f64.sqrt());
        let tip = Machine::forward_kinematics(&machine, &[c.to_radians(), b.to_radians(), x, y, z]).tip;
        assert!((tip - nalgebra::Point3::new(10.0, 20.0, 5.0)).norm() > 1.0);
    }

    #[test]
    fn limits_hold_for_the_rounded_word_and_its_offset() {
        assert_eq!(posted(&shifted(&[('B', 20.0)]), [0.0, 110.0]).diagnostics, []);
        // 99.99997 is written as 100, and B would be at 110.00003.
        let fault = posted(&shifted(&[('B', 10.000_03)]), [0.0, 110.0]);
        assert!(fault.error().text.contains("B would have to rotate to 110.00003"), "{}", fault.error().text);
        assert_eq!(posted(&shifted(&[('B', 9.999_97)]), [0.0, 110.0]).diagnostics, []);
    }

    #[test]
    fn linear_words_are_measured_from_the_table_if_so_configured() {
        let mut config = shifted(&[]);
        config.set_up.part_origin = [1.5, -2.25, 40.0];
        let plain = words(&posted(&config, [100.0, 30.0]));
        config.set_up.program_zero = ProgramZero::Table;
        let moved = words(&posted(&config, [100.0, 30.0]));
        let off: Vec<f64> = moved.iter().zip(&plain).map(|(a, b)| ((a - b) * 1e3).round() / 1e3).collect();
        assert_eq!(off, [0.0, 0.0, 1.5, -2.25, 40.0]);
        config.output_units = Some(crate::program::Units::Inches);
        let inches = words(&posted(&config, [100.0, 30.0]));
        assert!((2..5).all(|axis| (inches[axis] * 25.4 - moved[axis]).abs() < 2e-3), "{inches:?} {moved:?}");
    }

    #[test]
    fn words_of_the_gauge_line_need_no_length_offset() {
        fn both<M: Machine>(axis: [f64; 3], length: f64) -> (Run, Run) {
            let mut config = config();
            config.motion.retract.distance_mm = Some(10.0);
            config.motion.guards.length_guard = Some(false);
            config.set_up.tools.insert(1, GivenTool { length_mm: Some(length), ..GivenTool::default() });
            let events = [tool(1), spindle(), rapid([1.0, 2.0, -60.0], axis), feed([1.0, 2.0, -80.0], axis)];
            let tip = run::<M>(&config, &events);
            config.set_up.length_mode = LengthMode::Gauge;
            (tip, run::<M>(&config, &events))
        }
        let word = |line: &str, letter: char| -> Option<f64> {
            line.split(' ').find_map(|word| word.strip_prefix(letter)?.parse().ok())
        };
        for (tip, gauge) in [both::<Cb>([0.0, 0.0, 1.0], 80.25), both::<Head>([0.5, 0.0, 0.8], 80.25)] {
            assert_eq!((tip.diagnostics, &gauge.diagnostics), (vec![], &vec![]));
            assert!(!gauge.lines.iter().any(|line| line.contains("G43")), "{:?}", gauge.lines);
            let without: Vec<_> = tip.lines.iter().filter(|line| !line.contains("G43")).collect();
            assert_eq!(without.len(), gauge.lines.len());
            for (tip, gauge) in without.into_iter().zip(&gauge.lines).filter(|(tip, _)| !tip.contains("G53")) {
                let length = |letter| Some(word(gauge, letter)? - word(tip, letter)?);
                assert!(length('Z').is_none_or(|length| (length - 80.25).abs() < 1e-9), "{tip} {gauge}");
                assert!(length('X').is_none_or(|length| length.abs() < 1e-9), "{tip} {gauge}");
            }
        }
    }

    #[test]
    fn words_of_the_gauge_line_need_the_length_of_every_tool() {
        let mut config = config();
        config.set_up.length_mode = LengthMode::Gauge;
        let run = posted(&config, [0.0, 0.0]);
        assert!(run.error().text.contains("the gauge length of T1 is unknown, and `length_mode"), "{:?}", run.error());
    }

    #[test]
    fn parking_is_an_axis_value() {
        let mut config = shifted(&[('C', 12.5)]);
        config.motion.park.insert('C', 0.0);
        assert_eq!(posted(&config, [100.0, 30.0]).lines.last().map(String::as_str), Some("G0 C-12.5"));
    }
}
