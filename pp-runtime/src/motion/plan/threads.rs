//! Threads that cycles of the control cut, by tool and pitch, for the summary: a wrong pitch is seen there.

use crate::nc::Decimal;

/// Largest number of different threads that are listed; bounds the memory.
const MOST: usize = 100;

/// Threads with the same tool, pitch and hand.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Thread {
    /// Number of the tool.
    pub tool: u32,
    /// Pitch in the unit of the program per revolution, with the decimals of a pitch.
    pub pitch: Decimal,
    /// Left-hand thread.
    pub left: bool,
    /// Number of holes.
    pub holes: u64,
    /// Largest error of the pitch over the length of the thread by the rounding of words, mm: above zero where the
    /// thread is too long.
    pub error_mm: f64,
}

/// Threads of a program, in the order in which they are first cut.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Threads {
    list: Vec<Thread>,
    not_listed: u64,
}

impl Threads {
    /// Counts a hole.
    pub(crate) fn count(&mut self, tool: u32, pitch: Decimal, left: bool, error_mm: f64) {
        let same = |known: &Thread| (known.tool, known.pitch, known.left) == (tool, pitch, left);
        match self.list.iter().position(same) {
            Some(index) => {
                let thread = &mut self.list[index];
                thread.holes += 1;
                if error_mm.abs() > thread.error_mm.abs() {
                    thread.error_mm = error_mm;
                }
            }
            None if self.list.len() < MOST => self.list.push(Thread { tool, pitch, left, holes: 1, error_mm }),
            None => self.not_listed += 1,
        }
    }

    /// The threads, each with the number of its holes.
    #[must_use]
    pub fn listed(&self) -> &[Thread] {
        &self.list
    }

    /// Number of holes of threads that are not listed because there are too many different ones.
    #[must_use]
    pub fn not_listed(&self) -> u64 {
        self.not_listed
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn holes_are_counted_by_tool_pitch_and_hand_and_the_list_is_bounded() {
        let pitch = |units: i64| Decimal { units, decimals: 3 };
        let mut threads = Threads::default();
        for (tool, units, left) in
            [(3, 1000, false), (3, 1000, false), (3, 1250, false), (3, 1000, true), (4, 1000, false)]
        {
            threads.count(tool, pitch(units), left, if left { -2e-3 } else { 1e-6 * units as f64 });
        }
        let holes: Vec<u64> = threads.listed().iter().map(|thread| thread.holes).collect();
        assert_eq!(holes, [2, 1, 1, 1]);
        threads.count(3, pitch(1000), false, -3e-3);
        threads.count(3, pitch(1000), false, 2e-3);
        assert!((threads.listed()[0].error_mm + 3e-3).abs() < 1e-12);
        (0..200).for_each(|tool| threads.count(tool, pitch(500), false, 0.0));
        assert_eq!((threads.listed().len(), threads.not_listed()), (100, 104));
    }
}
