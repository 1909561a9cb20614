//! What the writer does at each place between two cuts, as rows: the steps in their order.
//!
//! The check has rows of its own, of what must be so at its places; a test compares both.

use crate::motion::fault::Planned;
use crate::motion::plan::Planner;
use crate::motion::step::{BlockReason, Sink};

/// A place between two cuts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Place {
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
pub(crate) enum Need {
    /// Out along the tool axis, if the tool is at the part.
    LeadOut,
    /// The same where the retract axis would not lead out along the tool axis.
    LeadOutIfTilted,
    CoolantOff,
    InverseTimeOff,
    Retract,
    SpindleOff,
    /// The same where it may be on, or the axes go to where the tool is changed.
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
pub(crate) struct Row {
    pub(crate) at: Place,
    /// Reason of its blocks but for the lead-out.
    reason: Option<BlockReason>,
    pub(crate) needs: &'static [Need],
}

const fn row(at: Place, reason: Option<BlockReason>, needs: &'static [Need]) -> Row {
    Row { at, reason, needs }
}

#[rustfmt::skip]
pub(crate) const ROWS: [Row; 12] = {
    use Need::{
        BlockSkipEnd, ChangePosition, CoolantOff, DrainDwell, InverseTimeOff, LeadOut, LeadOutIfTilted, OperationEnd, Parking, Retract,
        SpindleAsAsked, SpindleOff, SpindleOffForChange, ToolEnd,
    };
    [
        row(Place::Index,         Some(BlockReason::Approach), &[LeadOut, Retract]),
        row(Place::CompleteState, None,                        &[CoolantOff, Retract]),
        row(Place::ToolChange,    None,                        &[SpindleOffForChange, DrainDwell, ChangePosition]),
        row(Place::OperationEnd,  Some(BlockReason::End),      &[LeadOut, CoolantOff, SpindleAsAsked, InverseTimeOff, Retract]),
        row(Place::ToolEnd,       Some(BlockReason::End),      &[CoolantOff, InverseTimeOff, Retract, SpindleOff]),
        row(Place::BlockSkip,     Some(BlockReason::Record),   &[LeadOut, CoolantOff, InverseTimeOff, Retract, SpindleOff, ToolEnd]),
        row(Place::Stop,          Some(BlockReason::Record),   &[LeadOut, CoolantOff, Retract, SpindleOff]),
        row(Place::StopInPlace,   Some(BlockReason::Record),   &[LeadOutIfTilted, SpindleAsAsked]),
        row(Place::Home,          Some(BlockReason::Record),   &[LeadOut, CoolantOff, Retract, Parking]),
        row(Place::Standstill,    None,                        &[CoolantOff, Retract, SpindleOff]),
        row(Place::SelectionEnd,  Some(BlockReason::End),      &[BlockSkipEnd, LeadOut, CoolantOff, InverseTimeOff, ToolEnd, CoolantOff, Retract, SpindleOff]),
        row(Place::End,           Some(BlockReason::End),      &[OperationEnd, LeadOut, ToolEnd, CoolantOff, InverseTimeOff, Retract, SpindleOff]),
    ]
};

impl<S: Sink> Planner<'_, S> {
    /// Writes the steps of a place.
    pub(crate) fn come_to(&mut self, place: Place) -> Planned {
        let Some(Row { reason, needs, .. }) = ROWS.iter().find(|row| row.at == place) else { return Ok(()) };
        let leads_out = |need: &Need| matches!(need, Need::LeadOut | Need::LeadOutIfTilted);
        let of_reason = needs.iter().position(leads_out).map_or(0, |lead_out| lead_out + 1);
        for (index, need) in needs.iter().enumerate() {
            if let Some(reason) = reason.filter(|_| index == of_reason) {
                self.mover.output_mut().set_reason(reason);
            }
            self.carry_out(*need)?;
        }
        Ok(())
    }

    fn carry_out(&mut self, need: Need) -> Planned {
        match need {
            Need::LeadOut => self.leave()?,
            Need::LeadOutIfTilted if self.mover.retracts_along_tool() => {}
            Need::LeadOutIfTilted => self.leave()?,
            Need::CoolantOff => self.stop_coolant()?,
            Need::InverseTimeOff => self.mover.output_mut().cancel_inverse_time()?,
            Need::Retract => self.mover.machine_retract()?,
            Need::SpindleOff => self.spindle.stop(self.mover.output_mut())?,
            Need::SpindleOffForChange => {
                let goes = !self.policy.options.retract.tool_change_position.is_empty();
                if goes || self.spindle.may_run() {
                    self.spindle.stop(self.mover.output_mut())?;
                }
            }
            Need::SpindleAsAsked => self.stop_spindle()?,
            Need::DrainDwell => self.drain_spindle()?,
            Need::ChangePosition => self.mover.take_axes_to_tool_change()?,
            Need::OperationEnd => self.end_operation()?,
            Need::ToolEnd => self.end_tool()?,
            Need::BlockSkipEnd => self.skip_blocks(false)?,
            Need::Parking => {
                if !self.policy.options.park.is_empty() {
                    self.spindle.stop(self.mover.output_mut())?;
                }
                self.mover.park()?;
            }
        }
        Ok(())
    }
}
