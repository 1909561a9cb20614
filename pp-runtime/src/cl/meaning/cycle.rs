//! The CYCLE in force, or suspended: GOTOs are holes while it is active.

use super::arc::ARC_TOLERANCE_MM;
use super::holes::{HoleDefinition, ReturnLevel};
use super::permitted::Permitted;
use crate::cl::record::CycleState;
use crate::cl::text::{ClFault, Span};
use crate::kinematics::Pose;
use crate::nalgebra::Point3;

/// A cycle with its holes.
#[derive(Debug, Default)]
pub(crate) struct CycleInForce {
    active: bool,
    /// `None` in an active cycle: its record was refused.
    definition: Option<HoleDefinition>,
    /// CYCLE/INIT (true) or CYCLE/CLEAR came before.
    initial: Option<bool>,
    /// Position of the tool when the cycle began or was resumed.
    before: Option<Point3<f64>>,
}

impl CycleInForce {
    pub(crate) fn is_active(&self) -> bool {
        self.active
    }

    /// `None` if the record of the cycle was refused.
    pub(crate) fn definition(&self) -> Option<HoleDefinition> {
        self.definition
    }

    /// Lets a record come while the cycle is active; one that may not come ends it.
    pub(crate) fn admit(&mut self, permitted: Permitted) -> Result<(), ClFault> {
        if permitted.in_cycle || !self.active {
            return Ok(());
        }
        self.active = false;
        Err(ClFault::new(
            "CYCLE",
            Span::WHOLE,
            "this record stands under a CYCLE, where only points of holes are expected",
            "end the cycle before it: CYCLE/OFF",
        ))
    }

    /// A CYCLE is read; its holes are refused with it unless it is defined.
    pub(crate) fn begin_definition(&mut self) {
        self.active = true;
        self.definition = None;
    }

    /// CYCLE/INIT or CYCLE/CLEAR, for one cycle.
    pub(crate) fn take_initial(&mut self) -> Option<bool> {
        self.initial.take()
    }

    /// Holes follow; the level before them is that of the tool at `before`.
    pub(crate) fn begin_holes(
        &mut self,
        definition: HoleDefinition,
        before: Option<Point3<f64>>,
        at: Span,
    ) -> Result<(), ClFault> {
        self.active = true;
        self.before = before;
        if definition.return_level == ReturnLevel::Initial && before.is_none() {
            return Err(ClFault::new(
                "CYCLE",
                at,
                "RTRCTO,AUTO goes back to the level before the cycle, and nothing says where the tool stands",
                "give a GOTO before the cycle",
            ));
        }
        self.definition = Some(definition);
        Ok(())
    }

    /// CYCLE/OFF, ON, INIT, CLEAR.
    pub(crate) fn switch(&mut self, state: CycleState, before: Option<Point3<f64>>, at: Span) -> Result<(), ClFault> {
        match state {
            CycleState::Off => self.active = false,
            CycleState::Initial => self.initial = Some(true),
            CycleState::Clear => self.initial = Some(false),
            CycleState::On => {
                let Some(definition) = self.definition else {
                    let text = "CYCLE/ON without a cycle before it in this operation";
                    return Err(ClFault::new("CYCLE", at, text, "define the cycle first"));
                };
                return self.begin_holes(definition, before, at);
            }
        }
        Ok(())
    }

    /// Levels of one tool are not those of another.
    pub(crate) fn end_operation(&mut self) {
        (self.definition, self.initial) = (None, None);
    }

    /// Level to which the tool returns after a hole, mm above its top.
    pub(crate) fn return_level(&self, cycle: &HoleDefinition, top: &Pose, at: Span) -> Result<f64, ClFault> {
        match cycle.return_level {
            ReturnLevel::Clearance => Ok(cycle.clearance_mm),
            ReturnLevel::Level(level) => Ok(level),
            ReturnLevel::Initial => {
                let before = self.before.unwrap_or(top.tip);
                let level = (before - top.tip).dot(&top.axis);
                if level < cycle.clearance_mm - ARC_TOLERANCE_MM {
                    return Err(ClFault::new(
                        "CYCLE",
                        at,
                        format!(
                            "the level before the cycle lies {level:.4} mm above this hole, below its clearance level"
                        ),
                        "retract further before the cycle, or give a return level",
                    ));
                }
                Ok(level.max(cycle.clearance_mm))
            }
        }
    }
}
