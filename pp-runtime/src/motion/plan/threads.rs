//! Threads that cycles of the control cut, by tool and pitch, for the summary: a wrong pitch is seen there.

use crate::nc::Decimal;

/// Largest number of different threads that are listed; bounds the memory.
const MOST: usize = 100;

/// Threads with the same tool, pitch and hand.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Thread {
    /// Number of the tool.
    pub tool: u32,
    /// Pitch as written, in the unit of the program per revolution.
    pub pitch: Decimal,
    /// Left-hand thread.
    pub left: bool,
    /// Number of holes.
    pub holes: u64,
}

/// Threads of a program, in the order in which they are first cut.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Threads {
    list: Vec<Thread>,
    not_listed: u64,
}

impl Threads {
    /// Counts a hole.
    pub(crate) fn count(&mut self, tool: u32, pitch: Decimal, left: bool) {
        let same = |known: &Thread| (known.tool, known.pitch, known.left) == (tool, pitch, left);
        match self.list.iter().position(same) {
            Some(index) => self.list[index].holes += 1,
            None if self.list.len() < MOST => self.list.push(Thread { tool, pitch, left, holes: 1 }),
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
            threads.count(tool, pitch(units), left);
        }
        let holes: Vec<u64> = threads.listed().iter().map(|thread| thread.holes).collect();
        assert_eq!(holes, [2, 1, 1, 1]);
        (0..200).for_each(|tool| threads.count(tool, pitch(500), false));
        assert_eq!((threads.listed().len(), threads.not_listed()), (100, 104));
    }
}
