//! Holes by cycles of the control.

use std::io::{self, Write};

use crate::motion::{Cycle, CycleKind, MAX_AXES, Words};
use crate::nc::Decimal;

use super::super::template::fill;
use super::super::{CycleCodes, CycleDefinitions, CycleForm, LengthCall, Thread};
use super::Encoder;
use super::values::HoleValues;

impl<W: Write> Encoder<'_, W> {
    /// Cancels the cycle in force; behind it a motion says everything again.
    pub(super) fn end_cycle(&mut self) -> io::Result<()> {
        let Some(cycle) = self.cycling.take() else { return Ok(()) };
        self.belief.motion = "";
        self.belief.forget_axis(cycle.z);
        self.belief.forget_feed();
        match self.codes.cycles.as_ref().map(|cycles| &cycles.form) {
            Some(CycleForm::Codes(CycleCodes { end, .. }) | CycleForm::Definitions(CycleDefinitions { end, .. })) => {
                self.block(end)
            }
            None => Ok(()),
        }
    }

    /// A hole: the cycle with all its words, or only where, while the same one is in force.
    pub(super) fn cycle(&mut self, cycle: &Cycle) -> io::Result<()> {
        let Some(cycles) = &self.codes.cycles else { return Ok(()) };
        match (&cycles.form, cycle.kind) {
            (CycleForm::Definitions(blocks), _) => self.defined_cycle(cycle, blocks),
            (CycleForm::Codes(CycleCodes { thread: Thread::Motion(code), .. }), CycleKind::Tap { pitch, .. }) => {
                self.thread(cycle, code, pitch)
            }
            (CycleForm::Codes(codes), _) => self.coded_cycle(cycle, codes),
        }
    }

    /// `G99 G81 X Y Z R F`, then `X Y`.
    fn coded_cycle(&mut self, cycle: &Cycle, codes: &'static CycleCodes) -> io::Result<()> {
        if self.cycling.is_some_and(|before| cycle.repeats(&before)) {
            self.place_words(cycle);
            return self.writer.end();
        }
        self.before_cycle()?;
        let code = match (cycle.kind, codes.thread) {
            (CycleKind::Drill, _) => codes.drill[usize::from(cycle.dwell.is_some())],
            (CycleKind::Peck { .. }, _) => codes.peck,
            (CycleKind::ChipBreak { .. }, _) => codes.chip_break,
            (CycleKind::Ream, _) => codes.ream[usize::from(cycle.dwell.is_some())],
            (CycleKind::Tap { left, speed, .. }, Thread::Cycle { codes, rigid }) => {
                if self.rigid {
                    self.values.speed = Some(speed);
                    self.fill(rigid)?;
                }
                codes[usize::from(left)]
            }
            (CycleKind::Tap { .. }, Thread::Motion(code)) => code,
        };
        self.feed_mode(self.codes.per_minute);
        self.writer.code(codes.returns[usize::from(cycle.back != cycle.clearance)]);
        self.writer.code(code);
        self.forget_words(&cycle.words);
        self.axis_words(&cycle.words, false);
        self.cycle_words(cycle, codes.dwell)?;
        self.cycling = Some(*cycle);
        Ok(())
    }

    /// `MCALL CYCLE81(..)`, then `G0 X Y`; or `CYCL DEF 200`, then `L X Y R0 FMAX M99`.
    fn defined_cycle(&mut self, cycle: &Cycle, blocks: &'static CycleDefinitions) -> io::Result<()> {
        // Where each place calls it a definition outlives the motions between.
        let lasts = blocks.end.is_empty();
        let known = if lasts { self.belief.cycle } else { self.cycling };
        if !known.is_some_and(|before| cycle.repeats(&before)) {
            self.before_cycle()?;
            self.define(cycle, blocks)?;
            *(if lasts { &mut self.belief.cycle } else { &mut self.cycling }) = Some(*cycle);
            self.forget_words(&cycle.words);
        }
        self.motion(self.codes.rapid);
        self.place_words(cycle);
        self.writer.code(self.codes.rapid_end);
        self.writer.code(blocks.call);
        self.belief.forget_axis(cycle.z);
        self.belief.forget_feed();
        self.writer.end()
    }

    fn define(&mut self, cycle: &Cycle, blocks: &'static CycleDefinitions) -> io::Result<()> {
        if self.codes.length.call == LengthCall::Alone {
            self.call_length(&cycle.words)?;
        }
        if self.belief.feed_mode != self.codes.per_minute {
            self.feed_mode(self.codes.per_minute);
            self.writer.end()?;
        }
        let blocks = match (cycle.kind, cycle.dwell, blocks.plain_drill) {
            (CycleKind::Drill, None, Some(plain)) => plain,
            (CycleKind::Drill, ..) => blocks.drill,
            (CycleKind::Peck { .. }, ..) => blocks.peck,
            (CycleKind::ChipBreak { .. }, ..) => blocks.chip_break,
            (CycleKind::Ream, ..) => blocks.ream,
            (CycleKind::Tap { speed, .. }, ..) => {
                self.values.speed = Some(speed);
                blocks.thread
            }
        };
        self.values.seconds = Some(cycle.dwell.unwrap_or(0.0));
        self.values.hole = Some(HoleValues { cycle: *cycle, decimals: self.decimals(cycle.z), units: self.units });
        self.belief.motion = "";
        self.fill_all(blocks)
    }

    /// Nothing else is in force that a cycle would not bear.
    fn before_cycle(&mut self) -> io::Result<()> {
        self.end_cycle()?;
        self.smooth(false)?;
        self.usual_plane()
    }

    /// Where a hole is; the same place once more is said by its words.
    fn place_words(&mut self, cycle: &Cycle) {
        if !self.any_changes(&cycle.words) {
            self.forget_words(&cycle.words);
        }
        self.axis_words(&cycle.words, false);
    }

    /// `Z R Q P F`.
    fn cycle_words(&mut self, cycle: &Cycle, dwell: &str) -> io::Result<()> {
        let decimals = self.decimals(cycle.z);
        let words = Words { mask: 1 << cycle.z, ..Words::default() };
        let mut bottom = words;
        bottom.units[cycle.z] = cycle.bottom;
        self.axis_words(&bottom, true);
        self.writer.word("R", Decimal { units: cycle.clearance, decimals }, self.numerals);
        if let CycleKind::Peck { step: units, .. } | CycleKind::ChipBreak { step: units, .. } = cycle.kind {
            self.writer.word("Q", Decimal { units, decimals }, self.numerals);
        }
        if let Some(seconds) = cycle.dwell {
            self.values.seconds = Some(seconds);
            let word = fill(dwell, |field| self.values.get(field)).unwrap_or_default();
            self.writer.code(&word);
        }
        self.feed_word(cycle.feed);
        self.writer.end()
    }

    /// A thread by a motion: over to it, down to where it begins, in and out, and up to where the tool is to stand.
    fn thread(&mut self, cycle: &Cycle, code: &'static str, pitch: Decimal) -> io::Result<()> {
        // The way over to it would be another hole of the cycle before.
        self.before_cycle()?;
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

    fn forget_words(&mut self, words: &Words) {
        for axis in (0..MAX_AXES).filter(|&axis| words.has(axis)) {
            self.belief.forget_axis(axis);
        }
    }
}
