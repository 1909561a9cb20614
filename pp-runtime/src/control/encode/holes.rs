//! Hole cycles of the control.

use std::io;

use crate::control::dialects::{CycleCodes, CycleDefinitions, CycleForm, ThreadCodes};
use crate::control::layout::Layout;
use crate::motion::{AxisWords, CannedCycle, CannedKind};
use crate::nc::Decimal;
use crate::program::Units;

use super::modal_state::After;
use super::modal_writer::ModalWriter;
use super::values::HoleValues;

/// Writes hole cycles, and records the one in force.
#[derive(Debug)]
pub(crate) struct HoleWriter {
    /// Modal cycle that every motion calls until it is cancelled.
    in_force: Option<CannedCycle>,
    /// Threads are cut by rigid tapping.
    rigid: bool,
    /// F of a thread is its pitch.
    thread_per_revolution: bool,
    units: Units,
}

impl HoleWriter {
    pub(crate) fn new(layout: &Layout) -> Self {
        let Layout { rigid, thread_per_revolution, units, .. } = *layout;
        Self { in_force: None, rigid, thread_per_revolution, units }
    }

    /// Cancels the cycle in force, and feed per revolution of a thread; the next motion writes its motion code, the
    /// word of the tool axis and F again.
    #[inline(always)]
    pub(crate) fn end_cycle(&mut self, out: &mut ModalWriter<'_>) -> io::Result<()> {
        match self.in_force.take() {
            Some(cycle) => self.cancel(&cycle, out),
            None => Ok(()),
        }
    }

    fn cancel(&self, cycle: &CannedCycle, out: &mut ModalWriter<'_>) -> io::Result<()> {
        out.modal().forget(After::HoleCycle { z: cycle.z });
        match out.codes().cycles.as_ref().map(|cycles| &cycles.form) {
            Some(CycleForm::Codes(CycleCodes { end, .. }) | CycleForm::Definitions(CycleDefinitions { end, .. })) => {
                if self.thread_per_revolution && matches!(cycle.kind, CannedKind::Tap { .. }) {
                    out.feed_mode(out.codes().per_minute);
                }
                out.block(end)
            }
            None => Ok(()),
        }
    }

    /// Writes a hole: the cycle with all its words, or only the position while the same cycle is in force.
    pub(crate) fn cycle(&mut self, cycle: &CannedCycle, out: &mut ModalWriter<'_>) -> io::Result<()> {
        let Some(cycles) = &out.codes().cycles else { return Ok(()) };
        match (&cycles.form, cycle.kind) {
            (CycleForm::Definitions(blocks), _) => self.defined_cycle(cycle, blocks, out),
            (CycleForm::Codes(CycleCodes { thread: ThreadCodes::Motion(code), .. }), CannedKind::Tap { pitch, .. }) => {
                self.thread(cycle, code, pitch, out)
            }
            (CycleForm::Codes(codes), _) => self.coded_cycle(cycle, codes, out),
        }
    }

    /// Writes `G99 G81 X Y Z R F`, then `X Y`.
    fn coded_cycle(
        &mut self,
        cycle: &CannedCycle,
        codes: &'static CycleCodes,
        out: &mut ModalWriter<'_>,
    ) -> io::Result<()> {
        if self.in_force.as_ref().is_some_and(|before| cycle.repeats(before)) {
            out.place_words(&cycle.words);
            return out.end();
        }
        self.before_cycle(out)?;
        let code = match (cycle.kind, codes.thread) {
            (CannedKind::Drill, _) => codes.drill[usize::from(cycle.dwell.is_some())],
            (CannedKind::Peck { .. }, _) => codes.peck,
            (CannedKind::ChipBreak { .. }, _) => codes.chip_break,
            (CannedKind::Ream, _) => codes.ream[usize::from(cycle.dwell.is_some())],
            (CannedKind::FineBore { .. }, _) => codes.fine_bore,
            (CannedKind::Tap { left, speed, .. }, ThreadCodes::Cycle { codes, rigid }) => {
                if self.rigid {
                    out.values().speed = Some(speed);
                    out.fill(rigid)?;
                }
                codes[usize::from(left)]
            }
            (CannedKind::Tap { .. }, ThreadCodes::Motion(code)) => code,
        };
        let feed = match cycle.kind {
            CannedKind::Tap { pitch, .. } if self.thread_per_revolution => {
                out.feed_mode(out.codes().per_revolution);
                pitch
            }
            CannedKind::Drill
            | CannedKind::Peck { .. }
            | CannedKind::ChipBreak { .. }
            | CannedKind::Ream
            | CannedKind::FineBore { .. }
            | CannedKind::Tap { .. } => {
                out.feed_mode(out.codes().per_minute);
                cycle.feed
            }
        };
        out.writer_mut().code(codes.returns[usize::from(cycle.back != cycle.clearance)]);
        out.writer_mut().code(code);
        out.modal().forget_axes(&cycle.words);
        out.axis_words(&cycle.words, false);
        cycle_words(cycle, feed, codes, out)?;
        self.in_force = Some(*cycle);
        Ok(())
    }

    /// Writes `MCALL CYCLE81(..)`, then `G0 X Y`; or `CYCL DEF 200`, then `L X Y R0 FMAX M99`.
    fn defined_cycle(
        &mut self,
        cycle: &CannedCycle,
        blocks: &'static CycleDefinitions,
        out: &mut ModalWriter<'_>,
    ) -> io::Result<()> {
        // Where each position calls the cycle, its definition survives the motions between.
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

    /// Writes the blocks that define a cycle.
    fn define(
        &self,
        cycle: &CannedCycle,
        blocks: &'static CycleDefinitions,
        out: &mut ModalWriter<'_>,
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
            (CannedKind::FineBore { .. }, ..) => blocks.fine_bore,
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

    /// Cancels the functions that must be off in a cycle.
    fn before_cycle(&mut self, out: &mut ModalWriter<'_>) -> io::Result<()> {
        self.end_cycle(out)?;
        out.stop_smoothing()?;
        out.blend()?;
        out.select_xy_plane()
    }

    /// Writes a thread from where the tool is, over the hole: tapping motion, rapid to the return level.
    fn thread(
        &mut self,
        cycle: &CannedCycle,
        code: &'static str,
        pitch: Decimal,
        out: &mut ModalWriter<'_>,
    ) -> io::Result<()> {
        self.before_cycle(out)?;
        let level = |units: i64| {
            let mut words = AxisWords { mask: 1 << cycle.z, ..AxisWords::default() };
            words.units[cycle.z] = units;
            words
        };
        out.motion(code);
        out.axis_words(&level(cycle.bottom), true);
        out.word("K", pitch);
        out.end()?;
        out.modal().forget(After::OwnMotion);
        out.modal().set_axis(cycle.z, cycle.clearance);
        out.rapid(&level(cycle.back))
    }
}

/// Writes the words `Z R Q P F` of a cycle, and ends the block.
fn cycle_words(cycle: &CannedCycle, feed: Decimal, codes: &CycleCodes, out: &mut ModalWriter<'_>) -> io::Result<()> {
    let decimals = out.decimals(cycle.z);
    let mut bottom = AxisWords { mask: 1 << cycle.z, ..AxisWords::default() };
    bottom.units[cycle.z] = cycle.bottom;
    out.axis_words(&bottom, true);
    out.word("R", Decimal { units: cycle.clearance, decimals });
    match cycle.kind {
        CannedKind::Peck { step: units, .. } | CannedKind::ChipBreak { step: units, .. } => {
            out.word("Q", Decimal { units, decimals });
        }
        CannedKind::FineBore { direction, shift, .. } if codes.bore_shift_by_axis => {
            for (word, step) in ["I", "J"].into_iter().zip(direction.steps()).filter(|(_, step)| *step != 0) {
                out.word(word, Decimal { units: step * shift, decimals });
            }
        }
        CannedKind::FineBore { shift: units, .. } => out.word("Q", Decimal { units, decimals }),
        CannedKind::Drill | CannedKind::Ream | CannedKind::Tap { .. } => {}
    }
    if let Some(seconds) = cycle.dwell {
        out.values().seconds = Some(seconds);
        out.code(codes.dwell);
    }
    out.feed_word(feed);
    out.end()
}
