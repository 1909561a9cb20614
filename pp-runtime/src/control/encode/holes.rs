//! Holes by cycles of the control.

use std::io::{self, Write};

use crate::control::dialects::{CycleCodes, CycleDefinitions, CycleForm, Thread};
use crate::control::layout::Layout;
use crate::motion::{AxisWords, CannedCycle, CannedKind};
use crate::nc::Decimal;
use crate::program::Units;

use super::modal_state::After;
use super::modal_writer::ModalWriter;
use super::values::HoleValues;

/// Writes cycles, and knows which one is in force.
#[derive(Debug)]
pub(crate) struct Holes {
    /// The modal cycle that every motion calls until it is cancelled.
    in_force: Option<CannedCycle>,
    /// Threads are cut with the spindle under control of its angle.
    rigid: bool,
    units: Units,
}

impl Holes {
    pub(crate) fn new(layout: &Layout) -> Self {
        Self { in_force: None, rigid: layout.rigid, units: layout.units }
    }

    /// Cancels the cycle in force; a motion after it writes all its words.
    pub(crate) fn end_cycle<W: Write>(&mut self, out: &mut ModalWriter<W>) -> io::Result<()> {
        let Some(cycle) = self.in_force.take() else { return Ok(()) };
        out.modal().forget(After::HoleCycle { z: cycle.z });
        match out.codes().cycles.as_ref().map(|cycles| &cycles.form) {
            Some(CycleForm::Codes(CycleCodes { end, .. }) | CycleForm::Definitions(CycleDefinitions { end, .. })) => {
                out.block(end)
            }
            None => Ok(()),
        }
    }

    /// A hole: the cycle with all its words, or only its place while the same one is in force.
    pub(crate) fn cycle<W: Write>(&mut self, cycle: &CannedCycle, out: &mut ModalWriter<W>) -> io::Result<()> {
        let Some(cycles) = &out.codes().cycles else { return Ok(()) };
        match (&cycles.form, cycle.kind) {
            (CycleForm::Definitions(blocks), _) => self.defined_cycle(cycle, blocks, out),
            (CycleForm::Codes(CycleCodes { thread: Thread::Motion(code), .. }), CannedKind::Tap { pitch, .. }) => {
                self.thread(cycle, code, pitch, out)
            }
            (CycleForm::Codes(codes), _) => self.coded_cycle(cycle, codes, out),
        }
    }

    /// `G99 G81 X Y Z R F`, then `X Y`.
    fn coded_cycle<W: Write>(
        &mut self,
        cycle: &CannedCycle,
        codes: &'static CycleCodes,
        out: &mut ModalWriter<W>,
    ) -> io::Result<()> {
        if self.in_force.is_some_and(|before| cycle.repeats(&before)) {
            out.place_words(&cycle.words);
            return out.end();
        }
        self.before_cycle(out)?;
        let code = match (cycle.kind, codes.thread) {
            (CannedKind::Drill, _) => codes.drill[usize::from(cycle.dwell.is_some())],
            (CannedKind::Peck { .. }, _) => codes.peck,
            (CannedKind::ChipBreak { .. }, _) => codes.chip_break,
            (CannedKind::Ream, _) => codes.ream[usize::from(cycle.dwell.is_some())],
            (CannedKind::Tap { left, speed, .. }, Thread::Cycle { codes, rigid }) => {
                if self.rigid {
                    out.values().speed = Some(speed);
                    out.fill(rigid)?;
                }
                codes[usize::from(left)]
            }
            (CannedKind::Tap { .. }, Thread::Motion(code)) => code,
        };
        out.feed_mode(out.codes().per_minute);
        out.writer_mut().code(codes.returns[usize::from(cycle.back != cycle.clearance)]);
        out.writer_mut().code(code);
        out.modal().forget_axes(&cycle.words);
        out.axis_words(&cycle.words, false);
        cycle_words(cycle, codes.dwell, out)?;
        self.in_force = Some(*cycle);
        Ok(())
    }

    /// `MCALL CYCLE81(..)`, then `G0 X Y`; or `CYCL DEF 200`, then `L X Y R0 FMAX M99`.
    fn defined_cycle<W: Write>(
        &mut self,
        cycle: &CannedCycle,
        blocks: &'static CycleDefinitions,
        out: &mut ModalWriter<W>,
    ) -> io::Result<()> {
        // Where each place calls it a definition outlives the motions between.
        let lasts = blocks.end.is_empty();
        let known = if lasts { out.modal().cycle() } else { self.in_force };
        if !known.is_some_and(|before| cycle.repeats(&before)) {
            self.before_cycle(out)?;
            self.define(cycle, blocks, out)?;
            if lasts {
                out.modal().set_cycle(*cycle);
            } else {
                self.in_force = Some(*cycle);
            }
            out.modal().forget_axes(&cycle.words);
        }
        let codes = out.codes();
        out.motion(codes.rapid);
        out.place_words(&cycle.words);
        out.writer_mut().code(codes.rapid_end);
        out.writer_mut().code(blocks.call);
        out.modal().forget(After::DefinedHole { z: cycle.z });
        out.end()
    }

    /// The blocks that define a cycle.
    fn define<W: Write>(
        &self,
        cycle: &CannedCycle,
        blocks: &'static CycleDefinitions,
        out: &mut ModalWriter<W>,
    ) -> io::Result<()> {
        out.call_length_alone(&cycle.words)?;
        let per_minute = out.codes().per_minute;
        if !out.modal().is_feed_mode(per_minute) {
            out.feed_mode(per_minute);
            out.end()?;
        }
        let blocks = match (cycle.kind, cycle.dwell, blocks.plain_drill) {
            (CannedKind::Drill, None, Some(plain)) => plain,
            (CannedKind::Drill, ..) => blocks.drill,
            (CannedKind::Peck { .. }, ..) => blocks.peck,
            (CannedKind::ChipBreak { .. }, ..) => blocks.chip_break,
            (CannedKind::Ream, ..) => blocks.ream,
            (CannedKind::Tap { speed, .. }, ..) => {
                out.values().speed = Some(speed);
                blocks.thread
            }
        };
        let decimals = out.decimals(cycle.z);
        out.values().seconds = Some(cycle.dwell.unwrap_or(0.0));
        out.values().hole = Some(HoleValues { cycle: *cycle, decimals, units: self.units });
        out.modal().forget(After::OwnMotion);
        out.fill_all(blocks)
    }

    /// Ends what a cycle does not bear.
    fn before_cycle<W: Write>(&mut self, out: &mut ModalWriter<W>) -> io::Result<()> {
        self.end_cycle(out)?;
        out.smooth(false)?;
        out.usual_plane()
    }

    /// A thread by a motion: over to it, down to its start, in and out, and up to the level after it.
    fn thread<W: Write>(
        &mut self,
        cycle: &CannedCycle,
        code: &'static str,
        pitch: Decimal,
        out: &mut ModalWriter<W>,
    ) -> io::Result<()> {
        // The rapid over to it would be another hole of the cycle before.
        self.before_cycle(out)?;
        let level = |units: i64| {
            let mut words = AxisWords { mask: 1 << cycle.z, ..AxisWords::default() };
            words.units[cycle.z] = units;
            words
        };
        out.rapid(&cycle.words)?;
        out.rapid(&level(cycle.clearance))?;
        out.motion(code);
        out.axis_words(&level(cycle.bottom), true);
        out.word("K", pitch);
        out.end()?;
        out.modal().forget(After::OwnMotion);
        out.modal().set_axis(cycle.z, cycle.clearance);
        out.rapid(&level(cycle.back))
    }
}

/// `Z R Q P F`.
fn cycle_words<W: Write>(cycle: &CannedCycle, dwell: &str, out: &mut ModalWriter<W>) -> io::Result<()> {
    let decimals = out.decimals(cycle.z);
    let mut bottom = AxisWords { mask: 1 << cycle.z, ..AxisWords::default() };
    bottom.units[cycle.z] = cycle.bottom;
    out.axis_words(&bottom, true);
    out.word("R", Decimal { units: cycle.clearance, decimals });
    if let CannedKind::Peck { step: units, .. } | CannedKind::ChipBreak { step: units, .. } = cycle.kind {
        out.word("Q", Decimal { units, decimals });
    }
    if let Some(seconds) = cycle.dwell {
        out.values().seconds = Some(seconds);
        out.code(dwell);
    }
    out.feed_word(cycle.feed);
    out.end()
}
