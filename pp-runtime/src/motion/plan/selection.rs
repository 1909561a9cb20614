//! Selection of operations: the program is planned up to the last of them, and only the selected operations are
//! written.
//!
//! So the state at their beginning (branch and turns, tool, spindle, coolant, feed, frame) is that of the whole
//! program, and the restart point of the first selected operation establishes it.

use std::ops::RangeInclusive;

/// Progress of planning through the selected operations.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Selection {
    /// Numbers of the operations, from 1; `None`: all.
    wanted: Option<RangeInclusive<u64>>,
    /// Number of the present operation; 0 before the first.
    number: u64,
    /// Records after a tool call belong to the operation that comes.
    opened: bool,
    /// The last selected operation has ended.
    over: bool,
}

/// Effect of the beginning of an operation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Opening {
    /// The selected operations end before it.
    pub(crate) ends: bool,
    /// It is written.
    pub(crate) wanted: bool,
    /// It is the first that is written and not the first of the program: the state of the machine is unknown there.
    pub(crate) enters: bool,
}

impl Selection {
    pub(crate) fn of(wanted: Option<RangeInclusive<u64>>) -> Self {
        Self { wanted, number: 0, opened: false, over: false }
    }

    fn holds(&self, number: u64) -> bool {
        self.wanted.as_ref().is_none_or(|wanted| wanted.contains(&number))
    }

    /// Whether the present steps are written; steps before the first operation belong to it.
    pub(crate) fn is_written(&self) -> bool {
        self.holds(self.number.max(1)) && !self.over
    }

    /// Number of the operation whose first motion comes next.
    pub(crate) fn next_number(&self) -> u64 {
        self.number + u64::from(!self.opened)
    }

    /// Whether it is written.
    pub(crate) fn next_is_written(&self) -> bool {
        self.holds(self.next_number()) && !self.over
    }

    /// The operation whose first motion comes next begins with records.
    pub(crate) fn open(&mut self) -> Opening {
        let opening = self.begin(self.next_number());
        self.opened = true;
        opening
    }

    /// Whether the last selected operation has ended.
    #[inline]
    pub(crate) fn is_over(&self) -> bool {
        self.over
    }

    /// The operation of this number begins.
    pub(crate) fn begin(&mut self, number: u64) -> Opening {
        let (before, wanted) = (self.is_written(), self.holds(number));
        let ends = before && !wanted && number > 1;
        self.number = number;
        self.opened = false;
        self.over |= ends;
        Opening { ends, wanted, enters: wanted && !before }
    }
}
