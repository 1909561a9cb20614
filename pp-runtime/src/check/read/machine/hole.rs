//! Holes: of a canned cycle, whose words stay in force until another motion code, of a defined cycle, and of G33.1.

use super::super::block::{Action, BlockFault, CycleKind, CycleMove, FeedMode, FineBore};
use super::super::orders::{CannedWords, Cycle, MotionOrder, Pattern, WrittenAxisWords, fault};
use super::super::state::MAX_AXES;
use super::Interpreter;
use crate::program::Rotation;

/// Words of a canned cycle that stay in force, mm and seconds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Canned {
    pattern: Pattern,
    reference: Option<f64>,
    bottom: Option<f64>,
    step: Option<f64>,
    shift: Option<[f64; 2]>,
    dwell: f64,
    /// M29 came before it.
    rigid: bool,
}

impl Interpreter {
    /// Takes words of a canned cycle: R counts from where the tool is while distances are programmed.
    pub(super) fn set_canned(&mut self, words: CannedWords, faults: &mut Vec<BlockFault>) {
        let (unit, rigid) = (self.unit(), self.motion.rigid);
        if let Some(pattern) = words.begins {
            if rigid && !matches!(pattern, Pattern::Tap { .. } | Pattern::TapAfterRigid { .. }) {
                fault(
                    faults,
                    0,
                    "this cycle cuts no thread, and rigid tapping (M29) is active: G80 is missing before it",
                );
            }
            if self.motion.canned.is_none() {
                self.motion.initial = self.normal().and_then(|normal| self.at(normal));
            }
            let canned = Canned { pattern, reference: None, bottom: None, step: None, shift: None, dwell: 0.0, rigid };
            self.motion.canned = Some(canned);
        }
        let start = match self.normal().filter(|_| words.reference.is_some() && self.state.incremental == Some(true)) {
            Some(normal) => self.at(normal).unwrap_or_else(|| {
                fault(faults, 0, "incremental motion from an unknown position");
                0.0
            }),
            None => 0.0,
        };
        let Some(canned) = &mut self.motion.canned else { return };
        canned.reference = words.reference.map(|reference| start + reference * unit).or(canned.reference);
        canned.step = words.step.map(|step| step * unit).or(canned.step);
        canned.shift = words.shift.map(|shift| shift.map(|part| part * unit)).or(canned.shift);
        canned.dwell = words.dwell.unwrap_or(canned.dwell);
    }

    /// The hole of the canned cycle, where the axes are; the word along the normal is its bottom.
    pub(super) fn canned_hole(&mut self, words: &WrittenAxisWords, faults: &mut Vec<BlockFault>) -> Action {
        let unit = self.unit();
        let begins = self.motion.canned.is_some_and(|canned| canned.bottom.is_none());
        let across = words.written & !self.axes.rotary & !self.normal().map_or(0, |normal| 1 << normal);
        if self.facts.cycle_needs_position && begins && across == 0 {
            fault(
                faults,
                0,
                "a cycle that begins without X and Y: whether it makes a hole here depends on setting 28 of the control",
            );
        }
        if words.written & self.axes.rotary != 0 && !self.facts.cycle_takes_rotary {
            fault(faults, 0, "a word of a rotary axis in the block of a canned cycle");
        }
        if let Some(normal) = self.normal().filter(|normal| words.written & (1 << normal) != 0)
            && let Some(mut canned) = self.motion.canned
        {
            let from = if self.distances(words) & (1 << normal) != 0 { canned.reference } else { None };
            canned.bottom = Some(from.unwrap_or_default() + words.values[normal] * unit);
            self.motion.canned = Some(canned);
        }
        let canned = self.motion.canned;
        let parts =
            canned.and_then(|canned| Some((self.kind(&canned)?, canned.reference?, canned.bottom?, canned.dwell)));
        let Some((kind, reference, bottom, dwell)) = parts else {
            let text = "this cycle lacks its bottom, its R, or a step (Q) above 0";
            fault(faults, 0, text);
            return Action::Nothing;
        };
        if bottom > reference {
            fault(faults, 0, "the bottom of this cycle is above the level (R) from which it goes down");
        }
        self.motion.cycle = Some(Cycle { kind, reference, bottom, back_to: None, dwell, feed: None, gap: None });
        self.hole(faults)
    }

    /// How a canned cycle makes its hole; `None` where a word of it is missing.
    fn kind(&self, words: &Canned) -> Option<CycleKind> {
        let tap = |left: bool| self.pitch() * if left { -1.0 } else { 1.0 };
        let step = words.step.filter(|step| *step > 0.0);
        Some(match words.pattern {
            Pattern::Drill => CycleKind::Drill,
            Pattern::Ream => CycleKind::Ream,
            Pattern::Bore => CycleKind::Bore,
            Pattern::FineBore => CycleKind::FineBore(match (words.step, words.shift) {
                // Q has no direction: it is set in the control.
                (Some(shift), _) => FineBore { shift_mm: Some(shift.abs()), ..FineBore::default() },
                (None, shift) => FineBore::by_shift(shift?, None),
            }),
            Pattern::Peck => CycleKind::Peck(step?),
            Pattern::ChipBreak => CycleKind::ChipBreak(step?),
            Pattern::Tap { left } => CycleKind::Tap(tap(left)),
            Pattern::TapAfterRigid { left } if words.rigid => CycleKind::Tap(tap(left)),
            Pattern::TapAfterRigid { left } | Pattern::FloatingTap { left } => CycleKind::FloatingTap(tap(left)),
        })
    }

    /// Pitch that F and S give a thread, mm per turn; 0 where they give none.
    fn pitch(&self) -> f64 {
        let feed = self.state.feed.unwrap_or(0.0) * self.unit();
        match self.state.feed_mode {
            Some(FeedMode::PerRevolution) => feed,
            Some(FeedMode::InverseTime) => 0.0,
            Some(FeedMode::PerMinute) | None => feed / self.state.speed.unwrap_or(0.0),
        }
    }

    /// The hole of the cycle that is defined, where the axes are.
    pub(super) fn hole(&mut self, faults: &mut Vec<BlockFault>) -> Action {
        let (Some(cycle), Some(normal)) = (self.motion.cycle, self.normal()) else {
            fault(faults, 0, "cycle call without a cycle definition, or without a working plane");
            return Action::Nothing;
        };
        if cycle.back_to.is_none() && self.state.to_initial.is_none() {
            fault(
                faults,
                0,
                "neither G98 nor G99 has been programmed since the complete state: where the cycle returns to is unknown",
            );
        }
        let modal = if self.state.to_initial == Some(false) { Some(cycle.reference) } else { self.motion.initial };
        let back_to = cycle.back_to.or(modal).unwrap_or_else(|| {
            fault(faults, 0, "the cycle returns to the level before it, which is unknown");
            cycle.reference
        });
        let back_to = back_to.max(cycle.reference);
        let over = self.at(normal);
        self.values[normal] = back_to;
        self.known |= 1 << normal;
        let Cycle { kind, reference, bottom, dwell, feed, gap, .. } = cycle;
        Action::Cycle(CycleMove { kind, over, reference, bottom, back_to, dwell, feed, gap })
    }

    /// G33.1 to a depth along the normal; it comes back to where it began.
    pub(super) fn rigid_tap(
        &mut self,
        motion: &MotionOrder,
        from: [f64; MAX_AXES],
        faults: &mut Vec<BlockFault>,
    ) -> Action {
        let (Some(pitch), Some(normal)) = (motion.pitch, self.normal()) else {
            fault(faults, 0, "thread without a pitch, or without a working plane");
            return Action::Nothing;
        };
        if motion.axes.written & !(1 << normal) != 0 {
            fault(
                faults,
                0,
                "G33.1 with a word other than that of the tool axis: the thread would be cut on the way there",
            );
        }
        let bottom = self.values[normal];
        self.values = from;
        self.motion.code = None;
        let back_to = from[normal];
        let left = matches!(self.state.spindle, Some(Some(Rotation::CounterClockwise)));
        let kind = CycleKind::Tap(pitch * self.unit() * if left { -1.0 } else { 1.0 });
        let (over, reference) = (Some(back_to), back_to);
        Action::Cycle(CycleMove { kind, over, reference, bottom, back_to, dwell: 0.0, feed: None, gap: None })
    }
}
