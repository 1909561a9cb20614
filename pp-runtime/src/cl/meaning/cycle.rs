//! The state of CYCLE: each GOTO is a hole while a cycle is active.

use super::arc::ARC_TOLERANCE_MM;
use super::holes::{HoleDefinition, ReturnLevel};
use super::permitted::Permitted;
use crate::cl::record::{CycleCall, CycleState};
use crate::cl::text::{ClFault, Span};
use crate::diag::code::cl;
use crate::kinematics::Pose;
use crate::nalgebra::{Point3, UnitVector3};
use crate::program::Units;

/// Largest difference of two tool axes that are the same: that of their digits.
const SAME_AXIS: f64 = 1e-6;

/// The cycle that is active, or that CYCLE/ON can resume.
#[derive(Debug, Default)]
pub(crate) struct CycleInForce {
    active: bool,
    /// Definition of the hole; `None` in an active cycle whose record was refused.
    definition: Option<HoleDefinition>,
    /// Record of that cycle, whose words CYCLE/ON can change.
    call: Option<CycleCall>,
    /// CYCLE/INIT (true) or CYCLE/CLEAR (false) for the next cycle.
    initial: Option<bool>,
    /// Position of the tool when the cycle began or was resumed; with another tool axis, the point as high above the
    /// hole with which that axis began.
    before: Option<Point3<f64>>,
    /// The holes of the cycle so far.
    made: Option<HolesMade>,
}

/// Holes that a cycle has made, for an initial level that counts along the axis of each hole.
#[derive(Debug, Clone, Copy)]
struct HolesMade {
    /// Tool axis of the last hole.
    axis: UnitVector3<f64>,
    /// Initial level above the first hole, mm.
    first_mm: f64,
}

fn without_cycle(at: Span) -> ClFault {
    let text = "CYCLE/ON without a cycle before it in this operation";
    cl::HOLE.cl_fault("CYCLE", at, text, "write the whole record of the cycle here: CYCLE/DRILL,.. with its levels")
}

impl CycleInForce {
    pub(crate) fn is_active(&self) -> bool {
        self.active
    }

    /// Definition of the hole; `None` if its record was refused.
    pub(crate) fn definition(&self) -> Option<HoleDefinition> {
        self.definition
    }

    /// Position of the tool before the cycle.
    pub(crate) fn before(&self) -> Option<Point3<f64>> {
        self.before
    }

    /// Checks that a record may come while the cycle is active; a record that may not ends the cycle.
    #[inline]
    pub(crate) fn admit(&mut self, permitted: Permitted) -> Result<(), ClFault> {
        if permitted.in_cycle || !self.active {
            return Ok(());
        }
        self.active = false;
        Err(cl::HOLE.cl_fault(
            "CYCLE",
            Span::WHOLE,
            "this record is not permitted between the points of a CYCLE",
            "end the cycle before this record, CYCLE/OFF, and write the record of the cycle again before the holes after it",
        ))
    }

    /// Begins a cycle without a definition: if its record is refused, its holes are passed over.
    pub(crate) fn begin_definition(&mut self, call: &CycleCall) {
        self.active = true;
        (self.definition, self.call) = (None, Some(*call));
    }

    /// Whether the record of the cycle was refused with a message. A change of it needs none.
    pub(crate) fn is_refused(&self) -> bool {
        self.call.is_some() && self.definition.is_none()
    }

    /// The cycle with the words of `CYCLE/ON,..` in place of its own.
    pub(crate) fn changed_by(&self, change: &CycleCall) -> Result<CycleCall, ClFault> {
        let call = self.call.ok_or_else(|| without_cycle(change.at))?;
        Ok(call.changed_by(change))
    }

    /// Takes CYCLE/INIT (true) or CYCLE/CLEAR (false); it holds for one cycle.
    pub(crate) fn take_initial(&mut self) -> Option<bool> {
        self.initial.take()
    }

    /// Activates a cycle. `before`: position of the tool, from which the initial level follows.
    pub(crate) fn begin_holes(
        &mut self,
        definition: HoleDefinition,
        before: Option<Point3<f64>>,
        at: Span,
    ) -> Result<(), ClFault> {
        self.active = true;
        (self.before, self.made) = (before, None);
        self.check_level_before(&definition, at)?;
        self.definition = Some(definition);
        Ok(())
    }

    /// Resumes a cycle whose record was refused: its points are passed over.
    pub(crate) fn resume_refused(&mut self) {
        self.active = true;
    }

    /// Changes the cycle among its points; its initial level stays that of the tool before the first of them.
    pub(crate) fn change(&mut self, definition: HoleDefinition, at: Span) -> Result<(), ClFault> {
        self.check_level_before(&definition, at)?;
        self.definition = Some(definition);
        Ok(())
    }

    fn check_level_before(&self, definition: &HoleDefinition, at: Span) -> Result<(), ClFault> {
        if definition.return_level == ReturnLevel::Initial && self.before.is_none() {
            return Err(cl::HOLE.cl_fault(
                "CYCLE",
                at,
                "RTRCTO,AUTO returns to the level before the cycle, and the tool position is unknown",
                "program a GOTO before the cycle",
            ));
        }
        Ok(())
    }

    /// Executes CYCLE/OFF, ON, INIT, CLEAR.
    pub(crate) fn switch(&mut self, state: CycleState, before: Option<Point3<f64>>, at: Span) -> Result<(), ClFault> {
        match state {
            CycleState::Off => self.active = false,
            CycleState::Initial => self.initial = Some(true),
            CycleState::Clear => self.initial = Some(false),
            CycleState::On => {
                let definition = self.definition.ok_or_else(|| without_cycle(at))?;
                return self.begin_holes(definition, before, at);
            }
        }
        Ok(())
    }

    /// Forgets the cycle at a new operation: levels of one tool do not hold for another.
    pub(crate) fn end_operation(&mut self) {
        (self.definition, self.call, self.initial) = (None, None, None);
    }

    /// Level to which the tool returns after a hole, mm above its top. The initial level is a plane across the tool
    /// axis; with another tool axis it is as high above the first hole there as it was above the first hole of the
    /// cycle.
    pub(crate) fn return_level(
        &mut self,
        cycle: &HoleDefinition,
        top: &Pose,
        units: Units,
        at: Span,
    ) -> Result<f64, ClFault> {
        match cycle.return_level {
            ReturnLevel::Clearance => Ok(cycle.clearance_mm),
            ReturnLevel::Level(level) => Ok(level),
            ReturnLevel::Initial => self.initial_level(cycle.clearance_mm, top, units, at),
        }
    }

    fn initial_level(&mut self, clearance_mm: f64, top: &Pose, units: Units, at: Span) -> Result<f64, ClFault> {
        let axis = top.axis;
        if let Some(HolesMade { axis: last, first_mm }) = self.made
            && (axis.into_inner() - last.into_inner()).norm() > SAME_AXIS
        {
            self.before = Some(top.tip + axis.into_inner() * first_mm);
        }
        let before = self.before.unwrap_or(top.tip);
        let level = (before - top.tip).dot(&axis);
        if level < clearance_mm - ARC_TOLERANCE_MM {
            return Err(cl::HOLE.cl_fault(
                "CYCLE",
                at,
                format!(
                    "the level before the cycle lies {} above this hole, below its clearance level",
                    units.deviation(level)
                ),
                "retract further before the cycle, or program a return level",
            ));
        }
        self.made = Some(HolesMade { axis, first_mm: self.made.map_or(level, |made| made.first_mm) });
        Ok(level.max(clearance_mm))
    }
}
