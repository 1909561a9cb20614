//! Which tool is in the spindle, which one comes next, and what the CL data has called them with.

use std::collections::BTreeMap;

use crate::program::ToolCall;

use crate::motion::plan::tool::LoadedTool;

/// The tools of a program while it is planned.
#[derive(Debug, Clone, Default)]
pub(crate) struct Tooling {
    current: Option<LoadedTool>,
    /// The tool that the next operation begins with.
    next: Option<LoadedTool>,
    /// Tools called so far, with the length and the offset register that the CL data gave last.
    calls: BTreeMap<u32, ToolCall>,
    /// Tools in the order in which they come into the spindle, as far as it is known.
    order: Vec<u32>,
    /// Tool changes so far.
    changes: usize,
}

impl Tooling {
    /// Knows which tool follows which.
    pub(crate) fn know_order(&mut self, order: Vec<u32>) {
        self.order = order;
    }

    /// The tool in the spindle.
    pub(crate) fn current(&self) -> Option<LoadedTool> {
        self.current
    }

    /// The tool that the next operation begins with, where a tool record has named it.
    pub(crate) fn next(&self) -> Option<LoadedTool> {
        self.next
    }

    /// Earlier calls of a tool, taken together.
    pub(crate) fn called_before(&self, number: u32) -> Option<ToolCall> {
        self.calls.get(&number).copied()
    }

    /// A tool record.
    pub(crate) fn call(&mut self, call: &ToolCall) {
        let before = self.calls.get(&call.number).copied().unwrap_or_default();
        let (length, offset) = (call.length_mm.or(before.length_mm), call.length_offset.or(before.length_offset));
        self.calls.insert(call.number, ToolCall { length_mm: length, length_offset: offset, ..*call });
    }

    /// The next operation begins with this tool.
    pub(crate) fn prepare(&mut self, tool: LoadedTool) {
        self.next = Some(tool);
    }

    /// The tool that an operation asks for, and whether it has to be changed.
    pub(crate) fn take_next(&mut self) -> (Option<LoadedTool>, bool) {
        let wanted = self.next.take();
        let change = wanted.is_some_and(|wanted| self.current.is_none_or(|tool| tool.number != wanted.number));
        (wanted, change)
    }

    /// A tool is in the spindle.
    pub(crate) fn load(&mut self, tool: LoadedTool, change: bool) {
        self.current = Some(tool);
        self.changes += usize::from(change);
    }

    /// The tool that follows the one of the last change.
    pub(crate) fn following(&self, number: u32) -> Option<u32> {
        let known = self.order.get(self.changes.checked_sub(1)?..)?;
        known.first().filter(|first| **first == number).and(known.get(1)).copied()
    }
}
