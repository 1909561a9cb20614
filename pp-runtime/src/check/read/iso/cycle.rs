//! Canned cycles: the code, and words that stay in force until another motion code.

use super::super::block::{CycleKind, FeedMode};
use super::super::draft::{Code, Cycle};
use super::Reading;

/// Words of a cycle that stay in force, mm and seconds.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct CycleWords {
    /// The code, 0 for none.
    code: u32,
    reference: Option<f64>,
    bottom: Option<f64>,
    step: Option<f64>,
    dwell: f64,
}

impl Reading<'_, '_> {
    /// Words of a canned cycle, in the block that begins it or in a later one.
    pub(super) fn cycle_words(&mut self) {
        let code = self.line.draft.code;
        if code.is_some() && code != Some(Code::Cycle) {
            self.iso.cycle.code = 0;
        }
        if let Some(code) = self.loose.cycle {
            self.iso.cycle = CycleWords { code, ..CycleWords::default() };
        }
        let says = self.loose.cycle.is_some() || self.line.draft.written != 0 || self.loose.r.is_some();
        if self.iso.cycle.code == 0 || !says {
            return;
        }
        self.levels();
        if let Some(q) = self.loose.q.take() {
            self.iso.cycle.step = Some(self.length(q, false) * self.line.unit());
        }
        if let Some(p) = self.loose.p.take() {
            self.iso.cycle.dwell = self.seconds(p);
        }
        self.loose.l = None;
        let words = self.iso.cycle;
        match (self.kind(), words.reference, words.bottom) {
            (Some(kind), Some(reference), Some(bottom)) => {
                let cycle = Cycle { kind, reference, bottom, back_to: None, dwell: words.dwell, feed: None };
                self.line.draft.define = Some(cycle);
            }
            _ => self.line.fault(0, "unknown cycle, or a word of the cycle is missing"),
        }
    }

    /// R and the word along the normal: while distances are programmed, from where the tool stands and from R.
    fn levels(&mut self) {
        let (unit, incremental, normal) = (self.line.unit(), self.line.incremental(), self.line.normal());
        if let Some(r) = self.loose.r.take() {
            let start = normal.filter(|_| incremental).and_then(|index| self.line.machine.at(index));
            self.iso.cycle.reference = Some(start.unwrap_or_default() + self.length(r, false) * unit);
        }
        if let Some(index) = normal.filter(|index| self.line.draft.written & (1 << index) != 0) {
            let start = self.iso.cycle.reference.filter(|_| incremental);
            self.iso.cycle.bottom = Some(start.unwrap_or_default() + self.line.draft.axes[index] * unit);
        }
    }

    fn kind(&self) -> Option<CycleKind> {
        Some(match (self.iso.cycle.code, self.iso.cycle.step) {
            (81 | 82, _) => CycleKind::Drill,
            (85 | 89, _) => CycleKind::Ream,
            (83, Some(step)) => CycleKind::Peck(step),
            (73, Some(step)) => CycleKind::ChipBreak(step),
            (84, _) => CycleKind::Tap(self.pitch()),
            (74, _) => CycleKind::Tap(-self.pitch()),
            (76 | 86 | 88, _) => CycleKind::Bore,
            _ => return None,
        })
    }

    /// What feed and speed make of a thread, mm per turn.
    fn pitch(&self) -> f64 {
        let (draft, state) = (&self.line.draft, &self.line.machine.state);
        let feed = draft.feed.or(state.feed).unwrap_or(0.0) * self.line.unit();
        match draft.feed_mode.or(state.feed_mode) {
            Some(FeedMode::PerRevolution) => feed,
            _ => feed / draft.speed.or(state.speed).unwrap_or(0.0),
        }
    }
}
