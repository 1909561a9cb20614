//! Posting some operations of a program: all of it is planned up to the last of them, and only these are written.
//!
//! What the part that is passed over leaves behind (branch and turns, tool, spindle, coolant, feed, frame) is then what it
//! is in the whole program, and the restart point of the first operation brings it about.

use std::io;
use std::ops::RangeInclusive;

use crate::kinematics::Machine;
use crate::program::Location;

use super::account::{Standing, Why};
use super::planner::{Planned, Planner, Statistics};
use super::step::{Sink, Step};

/// Where planning stands with respect to the operations that are wanted.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Selection {
    /// Numbers of the operations, from 1; `None`: all.
    wanted: Option<RangeInclusive<u64>>,
    /// The operation that is planned; 0 before the first.
    number: u64,
    /// The last one wanted has been left.
    pub(super) over: bool,
}

impl Selection {
    pub(super) fn of(wanted: Option<RangeInclusive<u64>>) -> Self {
        Self { wanted, number: 0, over: false }
    }

    fn holds(&self, number: u64) -> bool {
        self.wanted.as_ref().is_none_or(|wanted| wanted.contains(&number))
    }

    /// What comes before the first operation belongs to it.
    fn shown(&self) -> bool {
        self.holds(self.number.max(1)) && !self.over
    }

    /// Nothing that is planned now is written.
    #[inline]
    pub(super) fn hidden(&self) -> bool {
        self.wanted.is_some() && !self.shown()
    }
}

impl<M: Machine> Planner<'_, M> {
    /// What stands between two operations and speaks of the second.
    pub(super) fn announce(&mut self, step: &Step<'_>, sink: &mut impl Sink) -> Planned {
        let Selection { number, over, .. } = self.selection;
        sink.show(self.selection.holds(number + 1) && !over);
        sink.step(step)?;
        sink.show(self.selection.shown());
        Ok(())
    }

    /// An operation begins. True if it is the first that is written although it is not the first of the program: whoever
    /// begins there knows nothing of what came before.
    pub(super) fn begin_operation(&mut self, at: Location, sink: &mut impl Sink) -> Result<bool, super::Stop> {
        let before = self.selection.shown();
        let number = self.selection.number + 1;
        let wanted = self.selection.holds(number);
        if before && !wanted && number > 1 {
            self.leave(at, sink)?;
            sink.serve(at, Why::End);
            self.coolant_off(sink)?;
            self.cancel_inverse_time(sink)?;
            self.machine_retract(at, sink)?;
            self.spindle_off(sink)?;
            self.times.forget_empty();
            self.selection.over = true;
        }
        self.selection.number = number;
        sink.show(wanted);
        let opens = wanted && !before;
        if opens {
            self.there = false;
            self.warnings.clear();
            self.statistics = Statistics::default();
            self.times.keep_last_operation();
        }
        Ok(opens)
    }
}

/// Lets through what is to be written, and the work offset, which the next restart point needs.
#[derive(Debug)]
pub struct Gate<'s, S> {
    sink: &'s mut S,
    shown: bool,
}

impl<'s, S: Sink> Gate<'s, S> {
    /// A gate in front of a sink; `shown`: it is open from the beginning.
    pub fn new(sink: &'s mut S, shown: bool) -> Self {
        Self { sink, shown }
    }
}

impl<S: Sink> Sink for Gate<'_, S> {
    #[inline]
    fn step(&mut self, step: &Step<'_>) -> io::Result<()> {
        if self.shown || matches!(step, Step::WorkOffset { .. }) { self.sink.step(step) } else { Ok(()) }
    }

    fn show(&mut self, shown: bool) {
        self.shown = shown;
    }

    #[inline]
    fn serve(&mut self, at: Location, why: Why) {
        self.sink.serve(at, why);
    }

    #[inline]
    fn stand(&mut self, standing: &Standing<'_>) {
        // What is not written reaches no place.
        if self.shown {
            self.sink.stand(standing);
        }
    }
}
