//! Posting some operations of a program: all of it is planned up to the last of them, and only these are written.
//!
//! What the part that is passed over leaves (branch and turns, tool, spindle, coolant, feed, frame) is then what it is in
//! the whole program, and the restart point of the first operation brings it about.

use std::ops::RangeInclusive;

/// Where planning is with respect to the operations that are wanted.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Selection {
    /// Numbers of the operations, from 1; `None`: all.
    wanted: Option<RangeInclusive<u64>>,
    /// The operation that is planned; 0 before the first.
    number: u64,
    /// The last one wanted has been left.
    over: bool,
}

/// What the beginning of an operation means for the selection.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Opening {
    /// The operations that are wanted end before it.
    pub(crate) ends: bool,
    /// It is written.
    pub(crate) wanted: bool,
    /// It is the first that is written although it is not the first of the program: whoever begins there knows nothing of
    /// what came before.
    pub(crate) enters: bool,
}

impl Selection {
    pub(crate) fn of(wanted: Option<RangeInclusive<u64>>) -> Self {
        Self { wanted, number: 0, over: false }
    }

    fn holds(&self, number: u64) -> bool {
        self.wanted.as_ref().is_none_or(|wanted| wanted.contains(&number))
    }

    /// Whether what is planned now is written; what comes before the first operation belongs to it.
    pub(crate) fn is_written(&self) -> bool {
        self.holds(self.number.max(1)) && !self.over
    }

    /// Whether the operation after this one is written.
    pub(crate) fn next_is_written(&self) -> bool {
        self.holds(self.number + 1) && !self.over
    }

    /// Whether the last operation that is wanted has been left.
    #[inline]
    pub(crate) fn is_over(&self) -> bool {
        self.over
    }

    /// The operation of this number begins.
    pub(crate) fn begin(&mut self, number: u64) -> Opening {
        let (before, wanted) = (self.is_written(), self.holds(number));
        let ends = before && !wanted && number > 1;
        self.number = number;
        self.over |= ends;
        Opening { ends, wanted, enters: wanted && !before }
    }
}
