//! What the written words count from.
//!
//! Planning counts axis values, for which limits hold. A written rotary word is the axis value minus `rotary_offset`, and
//! rounding comes first here, too: what whole units of the word cannot hold of the offset is in the axis value.

use crate::config::Config;
use crate::kinematics::Machine;

use super::choose::AngleScale;
use super::step::MAX_AXES;

/// Part of a unit of a word that an offset may be off whole units because degrees became radians.
const NOISE: f64 = 1e-6;

/// From axis values to written words, by position in the chain.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Origin {
    /// Rotary offsets in units of words.
    offsets: [f64; MAX_AXES],
    /// The same in whole units.
    whole: [i64; MAX_AXES],
}

impl Origin {
    pub(super) fn new<M: Machine>(config: &Config, scale: AngleScale) -> Self {
        let (mut offsets, mut whole) = ([0.0; MAX_AXES], [0; MAX_AXES]);
        for (index, axis) in M::AXES.iter().enumerate().take(MAX_AXES) {
            if let Some(offset) = config.rotary_offset.get(&axis.letter) {
                offsets[index] = offset.to_degrees() * scale.per_degree;
                whole[index] = offsets[index].round() as i64;
            }
        }
        Self { offsets, whole }
    }

    /// What whole units do not hold of the offset of a rotary axis, degrees.
    pub(super) fn rest(&self, index: usize, scale: AngleScale) -> f64 {
        let rest = self.offsets[index] - self.whole[index] as f64;
        if rest.abs() < NOISE { 0.0 } else { rest / scale.per_degree }
    }

    /// The words to write for words that count axis values.
    #[inline]
    pub(super) fn written(&self, words: &[i64; MAX_AXES]) -> [i64; MAX_AXES] {
        std::array::from_fn(|index| words[index] - self.whole[index])
    }
}

#[cfg(test)]
mod tests {
    use super::super::machines::Cb;
    use super::super::tests::{Run, config, feed, rapid, run, spindle, tool};
    use super::*;

    /// The axis at `C` and `B` degrees on the C-B table.
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
        config.rotary_offset = offsets.iter().map(|&(letter, degrees)| (letter, degrees.to_radians())).collect();
        config
    }

    #[test]
    fn a_rotary_word_is_the_axis_value_minus_its_offset() {
        let (plain, moved) = (posted(&shifted(&[]), [100.0, 30.0]), posted(&shifted(&[('C', 12.5)]), [100.0, 30.0]));
        assert_eq!(moved.diagnostics, []);
        let mut expected = words(&plain);
        expected[0] -= 12.5;
        assert_eq!(words(&moved), expected);
        assert_eq!(plain.lines.len(), moved.lines.len());
    }

    #[test]
    fn what_the_word_cannot_hold_of_an_offset_is_in_the_axis_value() {
        let [c, b, x, y, z] = words(&posted(&shifted(&[('C', 12.500_03), ('B', -0.000_04)]), [100.0, 30.0]));
        assert_eq!([c, b], [87.5, 30.0]);
        let machine: Cb = config().machine().expect("valid");
        let tip = machine.forward_kinematics(&[(c + 12.500_03).to_radians(), (b - 0.000_04).to_radians(), x, y, z]).tip;
        assert!((tip - nalgebra::Point3::new(10.0, 20.0, 5.0)).norm() < 0.5e-3 * 3_f64.sqrt());
        let tip = machine.forward_kinematics(&[c.to_radians(), b.to_radians(), x, y, z]).tip;
        assert!((tip - nalgebra::Point3::new(10.0, 20.0, 5.0)).norm() > 1.0);
    }

    #[test]
    fn limits_hold_for_the_rounded_word_and_its_offset() {
        assert_eq!(posted(&shifted(&[('B', 20.0)]), [0.0, 110.0]).diagnostics, []);
        // 99.99997 is written 100, and B would stand at 110.00003.
        let fault = posted(&shifted(&[('B', 10.000_03)]), [0.0, 110.0]);
        assert!(fault.error().text.contains("B would have to turn to 110.00003"), "{}", fault.error().text);
        assert_eq!(posted(&shifted(&[('B', 9.999_97)]), [0.0, 110.0]).diagnostics, []);
    }

    #[test]
    fn parking_is_an_axis_value() {
        let mut config = shifted(&[('C', 12.5)]);
        config.park.insert('C', 0.0);
        assert_eq!(posted(&config, [100.0, 30.0]).lines.last().map(String::as_str), Some("G0 C-12.5"));
    }
}
