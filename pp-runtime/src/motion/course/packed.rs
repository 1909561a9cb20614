//! Compact list of changes: a program of a million operations must not fill the memory.
//!
//! A change takes one byte for its action, a variable number for the motions since the change before and for the
//! difference of the words, and eight bytes for the fraction of a split path.

use crate::motion::course::{CourseAction, CourseChange};
use crate::motion::rotary::RotaryWords;

/// Changes in the order of their motions, written once and then read.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct PackedChanges {
    bytes: Vec<u8>,
    /// Motion of the change written or read last.
    motion: u64,
    /// Words of the change written or read last.
    words: RotaryWords,
    /// Number of bytes read so far.
    read: usize,
}

impl PackedChanges {
    pub(crate) fn push(&mut self, change: &CourseChange) {
        let (tag, part) = match change.action {
            CourseAction::EndWith => (0, None),
            CourseAction::RotateAtPole => (1, None),
            CourseAction::Rewind => (2, None),
            CourseAction::SplitAt(part) => (3, Some(part)),
        };
        self.bytes.push(tag);
        self.push_number(change.motion.cast_signed().wrapping_sub(self.motion.cast_signed()));
        for (word, last) in change.words.into_iter().zip(self.words) {
            self.push_number(word.wrapping_sub(last));
        }
        self.bytes.extend(part.into_iter().flat_map(f64::to_le_bytes));
        (self.motion, self.words) = (change.motion, change.words);
    }

    /// Number of bytes.
    pub(crate) fn size(&self) -> usize {
        self.bytes.len()
    }

    /// Returns to the first change, for reading.
    pub(crate) fn read_from_start(self) -> Self {
        Self { bytes: self.bytes, ..Self::default() }
    }

    /// The next change.
    pub(crate) fn next(&mut self) -> Option<CourseChange> {
        let tag = self.byte()?;
        self.motion = self.motion.wrapping_add_signed(self.number()?);
        for axis in 0..self.words.len() {
            self.words[axis] = self.words[axis].wrapping_add(self.number()?);
        }
        let action = match tag {
            0 => CourseAction::EndWith,
            1 => CourseAction::RotateAtPole,
            2 => CourseAction::Rewind,
            _ => {
                let mut part = [0; 8];
                for byte in &mut part {
                    *byte = self.byte()?;
                }
                CourseAction::SplitAt(f64::from_le_bytes(part))
            }
        };
        Some(CourseChange { motion: self.motion, action, words: self.words })
    }

    /// Writes a number with seven bits per byte, lowest first, and its sign in the lowest bit.
    fn push_number(&mut self, number: i64) {
        let mut rest = ((number << 1) ^ (number >> 63)).cast_unsigned();
        while rest >= 0x80 {
            self.bytes.push((rest & 0x7F) as u8 | 0x80);
            rest >>= 7;
        }
        self.bytes.push(rest as u8);
    }

    fn number(&mut self) -> Option<i64> {
        let mut number = 0_u64;
        for shift in (0..u64::BITS).step_by(7) {
            let byte = self.byte()?;
            number |= u64::from(byte & 0x7F) << shift;
            if byte & 0x80 == 0 {
                break;
            }
        }
        Some((number >> 1).cast_signed() ^ -((number & 1).cast_signed()))
    }

    fn byte(&mut self) -> Option<u8> {
        let byte = *self.bytes.get(self.read)?;
        self.read += 1;
        Some(byte)
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn changes_are_read_as_they_were_written(
            list in proptest::collection::vec((any::<u64>(), 0..4_u8, 0.0..1.0_f64, any::<RotaryWords>()), 0..20),
        ) {
            let list: Vec<CourseChange> = list
                .into_iter()
                .map(|(motion, tag, part, words)| {
                    let action = match tag {
                        0 => CourseAction::EndWith,
                        1 => CourseAction::RotateAtPole,
                        2 => CourseAction::Rewind,
                        _ => CourseAction::SplitAt(part),
                    };
                    CourseChange { motion, action, words }
                })
                .collect();
            let mut packed = PackedChanges::default();
            list.iter().for_each(|change| packed.push(change));
            let mut packed = packed.read_from_start();
            let found: Vec<CourseChange> = std::iter::from_fn(|| packed.next()).collect();
            prop_assert_eq!(found, list);
        }
    }

    #[test]
    fn a_million_operations_take_at_most_ten_megabytes() {
        let mut packed = PackedChanges::default();
        for motion in 0..1_000_000 {
            let words = if motion % 2 == 0 { [900_000, -1_800_000] } else { [0; 2] };
            packed.push(&CourseChange { motion: 20 * motion, action: CourseAction::EndWith, words });
        }
        assert!(packed.bytes.len() <= 10_000_000, "{}", packed.bytes.len());
    }
}
