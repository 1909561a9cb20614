//! Holes by cycles of the control.

use std::io::{self, Write};

use crate::motion::{Cycle, CycleKind, MAX_AXES, Words};
use crate::nc::Decimal;

use super::super::Thread;
use super::super::template::fill;
use super::Encoder;

impl<W: Write> Encoder<'_, W> {
    /// Cancels the cycle in force; behind it a motion says everything again.
    pub(super) fn end_cycle(&mut self) -> io::Result<()> {
        let Some(cycle) = self.cycling.take() else { return Ok(()) };
        self.belief.motion = "";
        self.belief.forget_axis(cycle.z);
        self.belief.forget_feed();
        let end = self.codes.cycles.as_ref().map_or("", |cycles| cycles.end);
        self.block(end)
    }

    /// A hole: the cycle with all its words, or only where, while the same one is in force.
    pub(super) fn cycle(&mut self, cycle: &Cycle) -> io::Result<()> {
        let Some(cycles) = &self.codes.cycles else { return Ok(()) };
        if let (CycleKind::Tap { pitch, .. }, Thread::Motion(code)) = (cycle.kind, cycles.thread) {
            return self.thread(cycle, code, pitch);
        }
        if self.cycling.is_some_and(|before| cycle.repeats(&before)) {
            if !self.any_changes(&cycle.words) {
                // The same place once more is said by its words.
                self.forget_words(&cycle.words);
            }
            self.axis_words(&cycle.words, false);
            return self.writer.end();
        }
        self.end_cycle()?;
        self.smooth(false)?;
        self.usual_plane()?;
        let code = match (cycle.kind, cycles.thread) {
            (CycleKind::Drill, _) => cycles.drill[usize::from(cycle.dwell.is_some())],
            (CycleKind::Peck(_), _) => cycles.peck,
            (CycleKind::ChipBreak(_), _) => cycles.chip_break,
            (CycleKind::Ream, _) => cycles.ream[usize::from(cycle.dwell.is_some())],
            (CycleKind::Tap { left, speed, .. }, Thread::Cycle { codes, rigid, .. }) => {
                if self.rigid {
                    self.values.speed = Some(speed);
                    self.fill(rigid)?;
                }
                codes[usize::from(left)]
            }
            (CycleKind::Tap { .. }, Thread::Motion(code)) => code,
        };
        self.feed_mode(self.codes.per_minute);
        self.writer.code(cycles.returns[usize::from(cycle.back != cycle.clearance)]);
        self.writer.code(code);
        self.forget_words(&cycle.words);
        self.axis_words(&cycle.words, false);
        self.cycle_words(cycle)?;
        self.cycling = Some(*cycle);
        Ok(())
    }

    /// `Z R Q P F`.
    pub(super) fn cycle_words(&mut self, cycle: &Cycle) -> io::Result<()> {
        let decimals = self.decimals(cycle.z);
        let words = Words { mask: 1 << cycle.z, ..Words::default() };
        let mut bottom = words;
        bottom.units[cycle.z] = cycle.bottom;
        self.axis_words(&bottom, true);
        self.writer.word("R", Decimal { units: cycle.clearance, decimals }, self.numerals);
        if let CycleKind::Peck(units) | CycleKind::ChipBreak(units) = cycle.kind {
            self.writer.word("Q", Decimal { units, decimals }, self.numerals);
        }
        if let (Some(seconds), Some(cycles)) = (cycle.dwell, &self.codes.cycles) {
            self.values.seconds = Some(seconds);
            let word = fill(cycles.dwell, |field| self.values.get(field)).unwrap_or_default();
            self.writer.code(&word);
        }
        self.feed_word(cycle.feed);
        self.writer.end()
    }

    /// A thread by a motion: over to it, down to where it begins, in and out, and up to where the tool is to stand.
    pub(super) fn thread(&mut self, cycle: &Cycle, code: &'static str, pitch: Decimal) -> io::Result<()> {
        let mut z = Words { mask: 1 << cycle.z, ..Words::default() };
        self.rapid(&cycle.words)?;
        z.units[cycle.z] = cycle.clearance;
        self.rapid(&z)?;
        self.motion(code);
        let mut bottom = z;
        bottom.units[cycle.z] = cycle.bottom;
        self.axis_words(&bottom, true);
        self.writer.word("K", pitch, self.numerals);
        self.writer.end()?;
        self.belief.motion = "";
        self.belief.set_axis(cycle.z, cycle.clearance);
        z.units[cycle.z] = cycle.back;
        self.rapid(&z)
    }

    pub(super) fn forget_words(&mut self, words: &Words) {
        for axis in (0..MAX_AXES).filter(|&axis| words.has(axis)) {
            self.belief.forget_axis(axis);
        }
    }
}
