//! Where the rotaries of every operation begin, packed: a program of a million operations must not fill the memory.
//!
//! An operation that begins as the one before takes one byte, any other three to seven for each rotary that differs.

use super::scout::Start;
use super::step::MAX_AXES;

/// The operation has no start of its own.
const NONE: u8 = 0xFF;

/// One start for each operation, written in their order and then read in it.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Starts {
    bytes: Vec<u8>,
    /// The start written or read last.
    last: [i64; MAX_AXES],
    /// Bytes read so far.
    read: usize,
}

impl Starts {
    /// Appends the start of the next operation.
    pub(super) fn push(&mut self, start: Start) {
        let Some(words) = start else { return self.bytes.push(NONE) };
        let count = self.bytes.len();
        self.bytes.push(0);
        for (index, (word, last)) in (0_u8..).zip(words.into_iter().zip(self.last)) {
            if word != last {
                self.bytes[count] += 1;
                self.bytes.push(index);
                self.push_number(word.wrapping_sub(last));
            }
        }
        self.last = words;
    }

    /// Goes back to the first operation, to read.
    #[must_use]
    pub(super) fn read_from_start(self) -> Self {
        Self { last: [0; MAX_AXES], read: 0, ..self }
    }

    /// The start of the next operation; none behind the last.
    pub(super) fn next(&mut self) -> Start {
        let count = self.byte()?;
        if count == NONE {
            return None;
        }
        for _ in 0..count {
            let index = usize::from(self.byte()?);
            let difference = self.number()?;
            let word = self.last.get_mut(index)?;
            *word = word.wrapping_add(difference);
        }
        Some(self.last)
    }

    /// Seven bits a byte, lowest first, small numbers of either sign in few bytes.
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
    use super::*;
    use proptest::prelude::*;

    fn read(mut starts: Starts, count: usize) -> Vec<Start> {
        (0..count).map(|_| starts.next()).collect()
    }

    proptest! {
        #[test]
        fn starts_are_read_as_they_were_written(
            list in proptest::collection::vec(
                proptest::option::of(prop_oneof![Just([0; MAX_AXES]), any::<[i64; MAX_AXES]>()]),
                0..20,
            ),
        ) {
            let mut starts = Starts::default();
            list.iter().for_each(|start| starts.push(*start));
            let mut starts = starts.read_from_start();
            let found: Vec<Start> = list.iter().map(|_| starts.next()).collect();
            prop_assert_eq!(found, list);
            prop_assert_eq!(starts.next(), None);
        }
    }

    #[test]
    fn a_million_operations_take_few_megabytes() {
        let mut starts = Starts::default();
        let there = Some([0, 900_000, -1_800_000, 0, 0, 0, 0, 0, 0]);
        let back = Some([0; MAX_AXES]);
        (0..500_000).for_each(|_| [there, back].into_iter().for_each(|start| starts.push(start)));
        assert!(starts.bytes.len() <= 10_000_000, "{}", starts.bytes.len());
        assert_eq!(read(starts.read_from_start(), 2), [there, back]);
        let mut same = Starts::default();
        (0..1000).for_each(|_| same.push(back));
        assert_eq!(same.bytes.len(), 1000);
    }
}
