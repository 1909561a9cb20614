//! Canned cycles: the code, and words that stay in force until another motion code.

use super::super::block::{CycleKind, FeedMode, FineBore};
use super::super::draft::{Code, Cycle, group};
use super::super::language::{Letters, Pattern, letters};
use super::Reading;

/// Words of a cycle that stay in force, mm and seconds.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct CycleWords {
    pattern: Option<Pattern>,
    reference: Option<f64>,
    bottom: Option<f64>,
    step: Option<f64>,
    /// I and J, which shift a tool off the wall of a bore.
    shift: Option<[f64; 2]>,
    dwell: f64,
    /// M29 came before it.
    rigid: bool,
}

impl CycleWords {
    /// No cycle is in force.
    pub(super) fn is_off(&self) -> bool {
        self.pattern.is_none()
    }
}

/// Hole that the next line of axis words drills again.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct RepeatedHole {
    pub(super) cycle: Cycle,
    /// Position in the chain of the axis along the normal, whose word would be another bottom.
    pub(super) normal: usize,
}

impl Reading<'_, '_> {
    /// Notes the hole of the block; `before`: that of the line before. A block of axis words that drills it again only moves.
    pub(super) fn note_hole(&mut self, before: Option<RepeatedHole>) {
        const AXES: Letters = letters("NXYZABCUVW");
        let hole = self.line.draft.define.zip(self.line.normal()).map(|(cycle, normal)| RepeatedHole { cycle, normal });
        self.iso.repeated_hole = hole.filter(|_| self.line.fault_count() == 0);
        let draft = &mut *self.line.draft;
        let moves = draft.groups == 1 << group::FREE
            && draft.written != 0
            && draft.letters & !AXES == 0
            && hole.is_some_and(|hole| draft.written & (1 << hole.normal) == 0);
        draft.only_moves |= moves && !self.iso.rigid && hole == before;
    }

    /// Words of a canned cycle, in the block that begins it or in a later one. Every block with one of its words, or with an
    /// axis word, drills.
    pub(super) fn cycle_words(&mut self) {
        let code = self.line.draft.code;
        if code.is_some() && code != Some(Code::Cycle) {
            self.iso.cycle = CycleWords::default();
        }
        if let Some(pattern) = self.line.draft.hole {
            if self.iso.rigid && !matches!(pattern, Pattern::Tap { .. } | Pattern::TapAfterRigid { .. }) {
                self.line
                    .fault(0, "this cycle cuts no thread, and rigid tapping (M29) is active: G80 is missing before it");
            }
            self.iso.cycle = CycleWords { pattern: Some(pattern), rigid: self.iso.rigid, ..CycleWords::default() };
        }
        let draft = &*self.line.draft;
        let apart = draft.machine || draft.reference || draft.dwell.is_some();
        let says = draft.hole.is_some() || draft.written != 0 || draft.letters & letters("RPQ") & !draft.takes != 0;
        if self.iso.cycle.is_off() || !says || apart {
            return;
        }
        self.levels();
        if let Some(q) = self.loose.q.take() {
            self.iso.cycle.step = Some(self.length(q, false) * self.line.unit());
        }
        if let Some(p) = self.loose.p.take() {
            self.iso.cycle.dwell = self.wait(p);
        }
        if self.iso.cycle.pattern == Some(Pattern::FineBore) && self.line.draft.centre_written & 4 == 0 {
            let unit = self.line.unit();
            let draft = &mut *self.line.draft;
            if std::mem::take(&mut draft.centre_written) != 0 {
                self.iso.cycle.shift = Some([draft.centre[0] * unit, draft.centre[1] * unit]);
            }
        }
        let words = self.iso.cycle;
        match (self.kind(), words.reference, words.bottom) {
            (Some(kind), Some(reference), Some(bottom)) => {
                let cycle = Cycle { kind, reference, bottom, back_to: None, dwell: words.dwell, feed: None, gap: None };
                self.line.draft.define = Some(cycle);
            }
            _ => self.line.fault(0, "unknown cycle, or a word of the cycle is missing"),
        }
    }

    /// R and the word along the normal: while distances are programmed, from where the tool stands and from R.
    fn levels(&mut self) {
        let (unit, incremental, normal) = (self.line.unit(), self.line.incremental(), self.line.normal());
        if let Some(r) = self.loose.r.take() {
            let start = match normal.filter(|_| incremental) {
                Some(index) => self.line.machine().at(index),
                None => Some(0.0),
            };
            if start.is_none() {
                self.line.fault(0, "incremental motion from an unknown position");
            }
            self.iso.cycle.reference = Some(start.unwrap_or_default() + self.length(r, false) * unit);
        }
        if let Some(index) = normal.filter(|index| self.line.draft.written & (1 << index) != 0) {
            let start = self.iso.cycle.reference.filter(|_| incremental);
            self.iso.cycle.bottom = Some(start.unwrap_or_default() + self.line.draft.axes[index] * unit);
        }
    }

    fn kind(&self) -> Option<CycleKind> {
        let words = &self.iso.cycle;
        let tap = |left: bool| self.pitch() * if left { -1.0 } else { 1.0 };
        Some(match words.pattern? {
            Pattern::Drill => CycleKind::Drill,
            Pattern::Ream => CycleKind::Ream,
            Pattern::Bore => CycleKind::Bore,
            Pattern::FineBore => CycleKind::FineBore(match (words.step, words.shift) {
                // Q has no direction: it is set in the control.
                (Some(shift), _) => FineBore { shift_mm: Some(shift.abs()), ..FineBore::default() },
                (None, shift) => FineBore::by_shift(shift?, None),
            }),
            Pattern::Peck => CycleKind::Peck(words.step.filter(|step| *step > 0.0)?),
            Pattern::ChipBreak => CycleKind::ChipBreak(words.step.filter(|step| *step > 0.0)?),
            Pattern::Tap { left } => CycleKind::Tap(tap(left)),
            Pattern::TapAfterRigid { left } if words.rigid => CycleKind::Tap(tap(left)),
            Pattern::TapAfterRigid { left } | Pattern::FloatingTap { left } => CycleKind::FloatingTap(tap(left)),
        })
    }

    /// What feed and speed make of a thread, mm per turn; 0 where they make none.
    fn pitch(&self) -> f64 {
        let (draft, state) = (&self.line.draft, &self.line.machine().state());
        let feed = self.line.machine().feed_in(draft).unwrap_or(0.0) * self.line.unit();
        match draft.feed_mode.or(state.feed_mode) {
            Some(FeedMode::PerRevolution) => feed,
            Some(FeedMode::InverseTime) => 0.0,
            Some(FeedMode::PerMinute) | None => feed / draft.speed.or(state.speed).unwrap_or(0.0),
        }
    }
}
