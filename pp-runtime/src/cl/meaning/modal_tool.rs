//! The tool in the spindle: its call, and the CUTTER or TLDATA that describes it.
//!
//! A cutter described before a call belongs to the tool called next. Creo describes it after the call, so a call is
//! held until the next event. A motion with another cutter, for which no tool record has come, causes a warning.

use std::collections::BTreeMap;

use crate::cl::record::{CutterRecord, ToolCallRecord};
use crate::cl::text::{ClFault, Span};
use crate::program::{Location, ToolCall};

/// Largest difference of the diameters of equal cutters.
const SAME_DIAMETER_MM: f64 = 1e-3;

/// Tool and cutter in force, lengths in mm.
#[derive(Debug, Default)]
pub(crate) struct ModalTool {
    /// Cutter that belongs to the tool called next.
    next_cutter: Option<CutterRecord>,
    /// Length offset registers of tools by number, where TOOLNO states them.
    offsets: BTreeMap<u32, u32>,
    /// No motion has come since that cutter was described.
    next_is_new: bool,
    /// Cutter of the last motion that had no tool record for it.
    uncalled: Option<CutterRecord>,
    /// Call that is held, because its cutter may follow.
    held: Option<(Location, ToolCall)>,
    /// Call that was returned last.
    last: Option<ToolCall>,
    /// Largest diameter, mm, and place of the first cutter: evidence of the unit of the file.
    largest: Option<(f64, Location)>,
}

impl ModalTool {
    /// The tool called last.
    pub(crate) fn current(&self) -> Option<ToolCall> {
        self.held.map(|(_, tool)| tool).or(self.last)
    }

    #[inline]
    pub(crate) fn is_held(&self) -> bool {
        self.held.is_some()
    }

    /// Whether the next motion must be checked for a cutter without a call: see [`compare`](Self::compare).
    pub(crate) fn is_described_anew(&self) -> bool {
        self.next_is_new
    }

    /// Largest diameter so far, mm, and place of the first cutter.
    pub(crate) fn largest_cutter(&self) -> Option<(f64, Location)> {
        self.largest
    }

    /// Takes the call that is held; a cutter that follows cannot change it any more.
    pub(crate) fn take_held(&mut self) -> Option<(Location, ToolCall)> {
        let held = self.held.take()?;
        self.last = Some(held.1);
        Some(held)
    }

    /// LOADTL, LOAD/TOOL. The call before must have been taken by [`take_held`](Self::take_held).
    pub(crate) fn call(&mut self, tool: &ToolCallRecord, length_mm: Option<f64>, here: Location) {
        (self.next_is_new, self.uncalled) = (false, None);
        let length_offset = tool.offset.or(self.offsets.get(&tool.number).copied());
        let mut call = ToolCall { number: tool.number, length_mm, length_offset, ..ToolCall::default() };
        if let Some(cutter) = self.next_cutter.take() {
            call.diameter_mm = Some(cutter.diameter);
            call.corner_radius_mm = cutter.corner_radius;
        } else if let Some(same) = self.last.filter(|last| last.number == tool.number) {
            // CATIA calls a tool for each operation and describes it once only.
            (call.diameter_mm, call.corner_radius_mm) = (same.diameter_mm, same.corner_radius_mm);
        }
        self.held = Some((here, call));
    }

    /// CUTTER or TLDATA before a call.
    pub(crate) fn describe_next(&mut self, cutter: CutterRecord, here: Location) {
        self.note_size(cutter, here);
        self.next_cutter = Some(cutter);
        self.next_is_new = true;
    }

    /// TOOLNO with OSETNO before the calls of a tool.
    pub(crate) fn set_offset_of(&mut self, number: u32, register: u32) {
        self.offsets.insert(number, register);
    }

    /// CUTTER after a call.
    pub(crate) fn describe_last(&mut self, cutter: CutterRecord, here: Location) {
        self.note_size(cutter, here);
        let held = self.held.as_mut().map(|(_, tool)| tool);
        if let Some(tool) = held.or(self.last.as_mut()) {
            tool.diameter_mm = Some(cutter.diameter);
            tool.corner_radius_mm = cutter.corner_radius;
        }
    }

    /// End of an operation: a cutter without a tool call belongs to it and is dropped.
    pub(crate) fn end_operation(&mut self) {
        self.next_cutter = None;
    }

    fn note_size(&mut self, cutter: CutterRecord, here: Location) {
        if cutter.diameter > 0.0 {
            let (largest, _) = self.largest.get_or_insert((0.0, here));
            *largest = largest.max(cutter.diameter);
        }
    }

    /// SET/OFSETL.
    pub(crate) fn set_length_offset(&mut self, register: u32, at: Span) -> Result<(), ClFault> {
        let fault = |text: &str, help: &str| Err(ClFault::new("length offset", at, text, help));
        if register == 0 {
            return fault("OFSETL 0 would cancel the length offset", "program a register above 0");
        }
        match &mut self.held {
            Some((_, tool)) if tool.length_offset.is_none_or(|offset| offset == register) => {
                tool.length_offset = Some(register);
                Ok(())
            }
            Some(_) => fault("two different length offset registers for one tool", "program one register"),
            None if self.last.is_some_and(|tool| tool.length_offset.unwrap_or(tool.number) == register) => Ok(()),
            None => fault(
                "this change of the length offset does not directly follow the tool call",
                "program it directly after LOADTL or LOAD/TOOL: a change in the cut would move the tool",
            ),
        }
    }

    /// Warns of a motion with a cutter that differs from the one before and has no tool record.
    #[inline]
    pub(crate) fn compare(&mut self, at: Span) -> Option<ClFault> {
        if std::mem::take(&mut self.next_is_new) { self.compare_next(at) } else { None }
    }

    #[inline(never)]
    fn compare_next(&mut self, at: Span) -> Option<ClFault> {
        let cutter = self.next_cutter?;
        let called = self.current().and_then(|tool| tool.diameter_mm);
        let before = self.uncalled.replace(cutter).map(|cutter| cutter.diameter).or(called)?;
        if (before - cutter.diameter).abs() <= SAME_DIAMETER_MM {
            return None;
        }
        let text = format!("the cutter changes from {before:.3} mm to {:.3} mm without a tool call", cutter.diameter);
        let help = "the tool in the spindle stays in use: program LOADTL or LOAD/TOOL before this motion";
        Some(ClFault::new("cutter without call", at, text, help))
    }
}
