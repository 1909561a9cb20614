//! Restart points as a whole: a block with a number begins one, and each ends the frames that the program uses.

use super::super::read::LineForm;
use super::super::report::ShownBlock;
use super::phase::Phase;
use super::{Comparison, Current};
use crate::diag::code::check;

/// What is not known of a restart point where it comes.
#[derive(Debug, Clone, Default)]
pub(super) struct Restarts {
    /// A block with a number whose complete state has not come.
    numbered: Option<(u64, Vec<u8>)>,
    /// The first machine retract after a restart point that has not ended a frame of each kind: bits of the frames with
    /// its line.
    not_ended: Vec<(u32, u64, Vec<u8>)>,
}

impl Restarts {
    /// The machine retracts after a restart point that has not ended these frames.
    pub(super) fn note(&mut self, frames: u32, at: ShownBlock<'_>) {
        let known = self.not_ended.iter().fold(0, |bits, (frames, ..)| bits | frames);
        if frames & !known != 0 {
            self.not_ended.push((frames & !known, at.line, at.text.to_vec()));
        }
    }

    /// The restart point has ended.
    pub(super) fn end(&mut self) {
        self.numbered = None;
    }
}

impl Comparison<'_> {
    /// Takes a block: it may begin a restart point, or show that one before it is not complete.
    pub(super) fn restart_point(&mut self, phase: &Phase, current: &Current<'_>) {
        let block = current.block;
        let shop = &self.rules.policy().shop;
        let numbered = shop.restarts_numbered && !shop.own_safety && self.rules.facts().form != LineForm::Statements;
        // A number alone is the target of a jump.
        let alone = || !current.shown.text.contains(&b' ');
        if numbered && block.number.is_some() && !block.goes_on && !phase.is_at_part() && !alone() {
            self.restarts.numbered = Some((block.line, current.shown.text.to_vec()));
        }
        if block.restart {
            self.restarts.numbered = None;
        }
        if block.action.moves()
            && let Some((line, text)) = self.restarts.numbered.take()
        {
            let text_of = "the block with this number is no restart point: the code of the unit, which begins its complete state, is missing";
            self.tally.found(check::ORDER, self.progress.location(), ShownBlock { line, text: &text }, text_of);
        }
        if current.same_modes || self.restarts.not_ended.is_empty() {
            return;
        }
        let fault = |(frames, ..): &(u32, u64, Vec<u8>)| self.rules.fault_before_frames(*frames);
        let Some((index, fault)) =
            self.restarts.not_ended.iter().enumerate().find_map(|(index, of)| Some((index, fault(of)?)))
        else {
            return;
        };
        let (_, line, text) = self.restarts.not_ended.remove(index);
        self.tally.found(check::ORDER, self.progress.location(), ShownBlock { line, text: &text }, &fault);
    }
}
