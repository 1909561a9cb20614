//! The tool in the spindle: its call, and the CUTTER or TLDATA that describes it.
//!
//! A cutter described before a call belongs to the tool called next, or to the tool in the spindle if that cuts before.
//! Creo describes it after the call, so a call is held until the next event. All that is stated comes together in the
//! `tool_table`.

use std::collections::BTreeMap;

use super::options::ReadingOptions;
use super::tool_table::{Contradiction, CutterAt, StatedTool, ToolTable};
use crate::cl::record::{CutterRecord, ToolCallRecord};
use crate::cl::text::{ClFault, Span, decoded};
use crate::diag::code::cl;
use crate::program::{Location, ToolCall, Units};

/// A call that is held, and the cutter that it has so far.
#[derive(Debug, Clone, Copy)]
struct HeldCall {
    here: Location,
    call: ToolCall,
    cutter: Option<CutterAt>,
}

/// Tool and cutter in force, lengths in mm.
#[derive(Debug, Default)]
pub(crate) struct ModalTool {
    /// Cutter that belongs to the tool called next.
    next_cutter: Option<CutterAt>,
    /// Length offset registers of tools by number, where TOOLNO states them.
    offsets: BTreeMap<u32, u32>,
    /// Name that the operation has for its tool, until that is called or cuts.
    named: Option<(String, Location)>,
    /// No motion has come since that cutter was described.
    next_is_new: bool,
    /// Call that is held, because its cutter may follow.
    held: Option<HeldCall>,
    /// Call that was returned last.
    last: Option<ToolCall>,
    table: ToolTable,
    /// Largest diameter, mm, and place of the first cutter: evidence of the unit of the file.
    largest: Option<(f64, Location)>,
}

/// What the configuration states about a tool.
fn given(options: &ReadingOptions, number: Option<u32>) -> Option<&StatedTool> {
    options.tools.get(&number?)
}

impl ModalTool {
    /// Takes the unit of the file, for messages.
    pub(crate) fn set_units(&mut self, units: Units) {
        self.table.units = units;
    }

    /// The tool called last.
    pub(crate) fn current(&self) -> Option<ToolCall> {
        self.held.map(|held| held.call).or(self.last)
    }

    /// Corner radius that the CL data states for the tool in the spindle, mm.
    pub(crate) fn corner_radius_mm(&self) -> Option<f64> {
        self.current().map_or_else(|| self.table.corner_radius_without_call(), |call| call.corner_radius_mm)
    }

    #[inline]
    pub(crate) fn is_held(&self) -> bool {
        self.held.is_some()
    }

    /// Whether the next motion may be with a cutter that no call has.
    pub(crate) fn is_described_anew(&self) -> bool {
        self.next_is_new
    }

    /// Largest diameter so far, mm, and place of the first cutter.
    pub(crate) fn largest_cutter(&self) -> Option<(f64, Location)> {
        self.largest
    }

    /// Takes the call that is held; a cutter that follows cannot change it any more.
    pub(crate) fn take_held(
        &mut self,
        options: &ReadingOptions,
    ) -> Option<((Location, ToolCall), Result<(), Contradiction>)> {
        let HeldCall { here, mut call, cutter } = self.held.take()?;
        let given = given(options, Some(call.number));
        let taken = self.table.take_call(&mut call, cutter, here, given);
        self.last = Some(call);
        Some(((here, call), taken))
    }

    /// LOADTL, LOAD/TOOL. The call before must have been taken by [`take_held`](Self::take_held).
    pub(crate) fn call(&mut self, tool: &ToolCallRecord, length_mm: Option<f64>, here: Location) {
        self.next_is_new = false;
        let length_offset = tool.offset.or(self.offsets.get(&tool.number).copied());
        let call = ToolCall { number: tool.number, length_mm, length_offset, ..ToolCall::default() };
        self.held = Some(HeldCall { here, call, cutter: self.next_cutter.take() });
    }

    /// CUTTER or TLDATA before a call.
    pub(crate) fn describe_next(&mut self, cutter: CutterRecord, here: Location) {
        self.note_size(cutter, here);
        self.next_cutter = Some((cutter, here));
        self.next_is_new = true;
    }

    /// TOOLNO with OSETNO before the calls of a tool.
    pub(crate) fn set_offset_of(&mut self, number: u32, register: u32) {
        self.offsets.insert(number, register);
    }

    /// CUTTER after a call.
    pub(crate) fn describe_last(
        &mut self,
        cutter: CutterRecord,
        here: Location,
        options: &ReadingOptions,
    ) -> Result<(), Contradiction> {
        self.note_size(cutter, here);
        if let Some(held) = &mut self.held {
            held.cutter = Some((cutter, here));
            return Ok(());
        }
        let number = self.last.map(|call| call.number);
        self.table.take_cutter(self.last.as_mut(), (cutter, here), given(options, number))
    }

    /// Another operation begins, for a tool of this name: a cutter that has not cut belongs to the one before and is
    /// dropped.
    pub(crate) fn begin_operation(&mut self, tool: Option<&[u8]>, here: Location) {
        self.next_cutter = None;
        self.named = tool.map(|name| (decoded(name).into_owned(), here));
    }

    /// Takes the name that the operation has for the tool in the spindle; a remark if it had another one before.
    pub(crate) fn take_name(&mut self) -> Option<Contradiction> {
        let (name, here) = self.named.take()?;
        self.table.take_name(self.last?.number, name, here)
    }

    fn note_size(&mut self, cutter: CutterRecord, here: Location) {
        if cutter.diameter > 0.0 {
            let (largest, _) = self.largest.get_or_insert((0.0, here));
            *largest = largest.max(cutter.diameter);
        }
    }

    /// SET/OFSETL.
    pub(crate) fn set_length_offset(&mut self, register: u32, at: Span) -> Result<(), ClFault> {
        let fault = |text: &str, help: &str| Err(cl::TOOL.cl_fault("length offset", at, text, help));
        if register == 0 {
            return fault("OFSETL 0 would cancel the length offset", "program a register above 0");
        }
        match &mut self.held {
            Some(HeldCall { call, .. }) if call.length_offset.is_none_or(|offset| offset == register) => {
                call.length_offset = Some(register);
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

    /// A cut with a cutter that no call has had: it describes the tool in the spindle.
    #[inline]
    pub(crate) fn cut(&mut self, options: &ReadingOptions) -> Result<(), Contradiction> {
        if !std::mem::take(&mut self.next_is_new) {
            return Ok(());
        }
        let Some(cutter) = self.next_cutter else { return Ok(()) };
        let number = self.last.map(|call| call.number);
        self.table.take_cutter(self.last.as_mut(), cutter, given(options, number))
    }
}
