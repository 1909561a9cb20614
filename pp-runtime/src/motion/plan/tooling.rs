//! Tools of a program: the one in the spindle, and the next one.

use std::collections::BTreeSet;

use crate::motion::plan::tool::LoadedTool;

/// The tools of a program while it is planned.
#[derive(Debug, Clone, Default)]
pub(crate) struct Tooling {
    current: Option<LoadedTool>,
    /// Tool of the next operation.
    next: Option<LoadedTool>,
    /// Tools in the order of their changes, as far as known.
    order: Vec<u32>,
    /// Tools that cut with cutter compensation, where they are known.
    compensated: Option<BTreeSet<u32>>,
    /// Tool changes so far.
    changes: usize,
    /// The tool before the blocks that may be skipped.
    before_skip: Option<LoadedTool>,
    /// Number of the last tool called before them.
    called_before_skip: Option<u32>,
    /// Number of the last tool called if they are skipped, until a tool is called.
    called_if_skipped: Option<u32>,
    /// Another tool may be in the spindle, as blocks were skipped or not.
    uncertain: bool,
    /// A tool has been measured or checked for breakage.
    measured: bool,
    /// The tool has cut since its blocks for the end of its work.
    has_cut: bool,
    /// Its blocks for the end of its work have come, and it is still in the spindle.
    ended: bool,
}

impl Tooling {
    /// Sets the order of the tools.
    pub(crate) fn know_order(&mut self, order: Vec<u32>) {
        self.order = order;
    }

    /// Notes that a tool is measured or checked for breakage; whether it is the first.
    pub(crate) fn note_measured(&mut self) -> bool {
        !std::mem::replace(&mut self.measured, true)
    }

    /// Notes that the tool cuts.
    pub(crate) fn note_cut(&mut self) {
        self.has_cut = true;
    }

    /// The blocks for the end of the work of the tool have come.
    pub(crate) fn end(&mut self) {
        self.ended = true;
    }

    /// Whether they have come since the last call.
    pub(crate) fn take_end(&mut self) -> bool {
        std::mem::take(&mut self.ended)
    }

    /// Whether the tool has cut since the last call.
    pub(crate) fn take_cut(&mut self) -> bool {
        std::mem::take(&mut self.has_cut)
    }

    /// Sets the tools that cut with cutter compensation.
    pub(crate) fn know_compensated(&mut self, tools: BTreeSet<u32>) {
        self.compensated = Some(tools);
    }

    /// Whether a tool may cut with cutter compensation.
    pub(crate) fn may_be_compensated(&self, number: u32) -> bool {
        self.compensated.as_ref().is_none_or(|tools| tools.contains(&number))
    }

    /// The tool in the spindle.
    pub(crate) fn current(&self) -> Option<LoadedTool> {
        self.current
    }

    /// Tool of the next operation, where a tool record has called one.
    pub(crate) fn next(&self) -> Option<LoadedTool> {
        self.next
    }

    /// Sets the tool of the next operation.
    pub(crate) fn prepare(&mut self, tool: LoadedTool) {
        self.next = Some(tool);
        self.called_if_skipped = None;
    }

    /// Takes the tool that has been called for the next operation.
    pub(crate) fn take_next(&mut self) -> Option<LoadedTool> {
        self.next.take()
    }

    /// Whether another tool has been called than the one in the spindle.
    pub(crate) fn changes(&self) -> bool {
        self.next.is_some_and(|wanted| self.current.is_none_or(|tool| tool.number != wanted.number))
    }

    /// Whether a tool has to be changed: another has been called, or may be in the spindle.
    pub(crate) fn needs_change(&self) -> bool {
        self.changes() || self.uncertain
    }

    /// Sets the tool in the spindle.
    pub(crate) fn load(&mut self, tool: LoadedTool, change: bool) {
        let again = self.uncertain && self.current.is_some_and(|current| current.number == tool.number);
        self.current = Some(tool);
        self.changes += usize::from(change && !again);
        self.uncertain = false;
    }

    /// Blocks that may be skipped begin or end here.
    pub(crate) fn skip(&mut self, begins: bool) {
        if begins {
            self.before_skip = self.current;
            self.called_before_skip = self.next.or(self.current).map(|tool| tool.number);
        } else {
            self.called_if_skipped = self.called_before_skip;
            let number = |tool: Option<LoadedTool>| tool.map(|tool| tool.number);
            self.uncertain |= number(self.before_skip) != number(self.current);
        }
    }

    /// Whether a call is a change to another tool where the blocks before it were skipped.
    pub(crate) fn changes_if_skipped(&self, number: u32) -> bool {
        self.called_if_skipped.is_some_and(|before| before != number)
    }

    /// The tool after this one, where it is the tool of the last change; after the last one the `first`, for the next
    /// part. None where the spindle is empty then.
    pub(crate) fn following(&self, number: u32, first: bool) -> Option<u32> {
        let known = self.order.get(self.changes.checked_sub(1)?..)?;
        let next =
            known.first().filter(|known| **known == number).and(known.get(1).or(self.order.first().filter(|_| first)));
        next.copied().filter(|next| *next != number && *next != 0 && number != 0)
    }
}
