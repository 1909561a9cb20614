//! What the writer does at each place between two cuts, as rows: the steps in their order.
//!
//! The check has rows of its own, of what must be so at its places; a test compares both.

use crate::motion::fault::Planned;
use crate::motion::plan::Planner;
use crate::motion::step::{BlockReason, Sink};

/// A place between two cuts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum SequencePlace {
    /// The table or the head rotates, by the safe sequence.
    Index,
    /// After a safety line: the program can be entered there.
    CompleteState,
    ToolChange,
    /// Blocks of the shop at the end of an operation.
    OperationEnd,
    /// Blocks of the shop for a tool that has cut.
    ToolEnd,
    /// Blocks that may be skipped begin or end.
    BlockSkip,
    Stop,
    /// A stop without a retract.
    StopInPlace,
    /// GOHOME without a point.
    Home,
    /// Work is clamped, a chuck, a door or a pallet moves.
    Standstill,
    /// The operations that are posted end.
    SelectionEnd,
    End,
}

/// A step.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum SequenceStep {
    /// Out along the tool axis, if the tool is at the part.
    LeadOut,
    /// Out along the tool axis where the retract axis would not lead out along it.
    LeadOutIfTilted,
    CoolantOff,
    Retract,
    SpindleOff,
    /// The spindle off where it may be on, or the axes go to where the tool is changed.
    SpindleOffForChange,
    /// The spindle off if the CL data asks for it.
    SpindleAsAsked,
    DrainDwell,
    /// The axes to where a tool is changed.
    ChangePosition,
    OperationEnd,
    ToolEnd,
    BlockSkipEnd,
    Parking,
}

/// A row.
pub(crate) struct SequenceRow {
    pub(crate) at: SequencePlace,
    /// Reason of its blocks but for the lead-out.
    reason: Option<BlockReason>,
    pub(crate) needs: &'static [SequenceStep],
}

const fn row(at: SequencePlace, reason: Option<BlockReason>, needs: &'static [SequenceStep]) -> SequenceRow {
    SequenceRow { at, reason, needs }
}

#[rustfmt::skip]
pub(crate) const ROWS: [SequenceRow; 12] = {
    use SequenceStep::{
        BlockSkipEnd, ChangePosition, CoolantOff, DrainDwell, LeadOut, LeadOutIfTilted, OperationEnd, Parking, Retract,
        SpindleAsAsked, SpindleOff, SpindleOffForChange, ToolEnd,
    };
    [
        row(SequencePlace::Index,         Some(BlockReason::Approach), &[LeadOut, Retract]),
        row(SequencePlace::CompleteState, None,                        &[CoolantOff, Retract]),
        row(SequencePlace::ToolChange,    None,                        &[SpindleOffForChange, DrainDwell, ChangePosition]),
        row(SequencePlace::OperationEnd,  Some(BlockReason::End),      &[LeadOut, CoolantOff, SpindleAsAsked, Retract]),
        row(SequencePlace::ToolEnd,       Some(BlockReason::End),      &[CoolantOff, Retract, SpindleOff]),
        row(SequencePlace::BlockSkip,     Some(BlockReason::Record),   &[LeadOut, CoolantOff, Retract, SpindleOff, ToolEnd]),
        row(SequencePlace::Stop,          Some(BlockReason::Record),   &[LeadOut, CoolantOff, Retract, SpindleOff]),
        row(SequencePlace::StopInPlace,   Some(BlockReason::Record),   &[LeadOutIfTilted, SpindleAsAsked]),
        row(SequencePlace::Home,          Some(BlockReason::Record),   &[LeadOut, CoolantOff, Retract, Parking]),
        row(SequencePlace::Standstill,    None,                        &[CoolantOff, Retract, SpindleOff]),
        row(SequencePlace::SelectionEnd,  Some(BlockReason::End),      &[BlockSkipEnd, LeadOut, CoolantOff, ToolEnd, CoolantOff, Retract, SpindleOff]),
        row(SequencePlace::End,           Some(BlockReason::End),      &[OperationEnd, LeadOut, ToolEnd, CoolantOff, Retract, SpindleOff]),
    ]
};

impl<S: Sink> Planner<'_, S> {
    /// Writes the steps of a place.
    pub(crate) fn come_to(&mut self, place: SequencePlace) -> Planned {
        let Some(SequenceRow { reason, needs, .. }) = ROWS.iter().find(|row| row.at == place) else { return Ok(()) };
        let leads_out = |need: &SequenceStep| matches!(need, SequenceStep::LeadOut | SequenceStep::LeadOutIfTilted);
        let of_reason = needs.iter().position(leads_out).map_or(0, |lead_out| lead_out + 1);
        for (index, need) in needs.iter().enumerate() {
            if let Some(reason) = reason.filter(|_| index == of_reason) {
                self.mover.output_mut().set_reason(reason);
            }
            self.carry_out(*need)?;
        }
        Ok(())
    }

    fn carry_out(&mut self, need: SequenceStep) -> Planned {
        match need {
            SequenceStep::LeadOut => self.leave()?,
            SequenceStep::LeadOutIfTilted if self.mover.retracts_along_tool() => {}
            SequenceStep::LeadOutIfTilted => self.leave()?,
            SequenceStep::CoolantOff => self.stop_coolant()?,
            SequenceStep::Retract => self.mover.machine_retract()?,
            SequenceStep::SpindleOff => self.spindle.stop(self.mover.output_mut())?,
            SequenceStep::SpindleOffForChange => {
                let goes = !self.policy.options.retract.tool_change_position.is_empty();
                if goes || self.spindle.may_run() {
                    self.spindle.stop(self.mover.output_mut())?;
                }
            }
            SequenceStep::SpindleAsAsked => self.stop_spindle()?,
            SequenceStep::DrainDwell => self.drain_spindle()?,
            SequenceStep::ChangePosition => self.mover.take_axes_to_tool_change()?,
            SequenceStep::OperationEnd => self.end_operation()?,
            SequenceStep::ToolEnd => self.end_tool()?,
            SequenceStep::BlockSkipEnd => self.skip_blocks(false)?,
            SequenceStep::Parking => {
                if !self.policy.options.park.is_empty() {
                    self.spindle.stop(self.mover.output_mut())?;
                }
                self.mover.park()?;
            }
        }
        Ok(())
    }
}
