//! The rows: what a program owes after an event, and what must be so at each place to which it comes.

use std::collections::BTreeMap;

use crate::check::policy::{CheckPolicy, LinkPolicy};
use crate::check::read::OwnPlace;
use crate::check::rules::Rules;

/// What changes what a program owes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in super::super) enum DutyEvent {
    /// The first block.
    Begin,
    /// The block that sets all modal codes: an operation can be entered there.
    CompleteState,
    /// The machine retract.
    Retract,
    /// The position of the machine is unknown.
    PositionLost,
    /// A line of the shop has left the axes anywhere.
    ShopLine,
    /// GOHOME.
    Home,
    /// The linear axes move to their home positions, for a rotation.
    LinearHome,
    /// A block at the retract with rotary words.
    RotaryWords,
    /// A complete state where a stop of the CL data should have come before it.
    StopPassed,
    /// Blocks have measured the tool, or checked it for breakage.
    Measured,
    /// A motion of the CL data, as a rapid or not.
    Motion,
    BlockSkip,
    ThroughCoolant,
    /// The dwell after it.
    Drained,
    SpindleStarts,
    SpindleOff,
    SpindleStated,
    /// A dwell that is long enough for the spindle.
    SpindleWaited,
    /// A cycle after which the spindle is off.
    CycleStopsSpindle,
    TipControlOff,
    PlaneCall,
    PlaneGuard,
    OffsetGuard,
    /// A tilted plane, or a zero that follows the table, begins.
    FrameBegins,
    /// A step of an approach with linear words.
    LinearStep,
    /// The tool comes to the level of a cycle over its hole.
    LevelOfCycle,
    Cycle,
}

/// What must be so.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::check) enum Duty {
    CompleteState,
    Retract,
    RetractAfterShopLine,
    Parking,
    DrainDwell,
    SpindleDwell,
    SpindleAgain,
    TipControlOff,
    PlaneGuard,
    OffsetGuard,
    CycleAtLevel,
    RotationAfterHome,
    StopInTime,
    /// The modes are stated again, which is no restart point.
    ModesAgain,
    MotionInFrame,
    // What follows is not owed after an event, but seen where it is needed.
    /// The tool is away from the part.
    Away,
    /// The machine is at its retract, since whatever.
    Retracted,
    SpindleOff,
    /// Off for certain.
    SpindleStopped,
    /// Spindle and coolant off, no plane, no shifted zero.
    StateAtEnd,
    /// Neither is known to be on.
    SpindleAndCoolantOff,
    AtChangePosition,
    ApproachEnded,
    CutsEnded,
    ClampsOfCuts,
    ClampsAsBefore,
    ClampsPositioned,
    ClampsParked,
    OperationEnded,
    ToolEnded,
    ProgramEnded,
    ParkingAtEnd,
    CoolantStated,
    OffsetStated,
    SpindleStated,
    LengthGuard,
    ClampsStated,
    AxesStated,
    Blank,
}

/// A place to which a program comes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::check) enum DutyPlace {
    ToolChange,
    Stop,
    /// A block of the CL data that is copied.
    Copied,
    /// A block with which a probe measures.
    Probe,
    /// A dwell of the CL data.
    Wait,
    /// Blocks that may be skipped begin or end.
    BlockSkip,
    /// Work is clamped, a chuck, a door or a pallet moves.
    Standstill,
    /// A tool is measured, or checked for breakage.
    Measuring,
    /// The machine retract after a complete state.
    RetractOfStart,
    /// A step of an approach.
    ApproachStep,
    /// The first approach of an operation.
    Operation,
    /// The axes go to their parking positions at the end, without GOHOME.
    Park,
    /// A tilted plane, or a zero that follows the table, ends.
    FrameEnd,
    /// A block at feed or of a cycle.
    Feed,
    /// A motion of the CL data at feed.
    Cut,
    Cycle,
    End,
}

pub(super) struct Owed {
    pub(super) what: Duty,
    pub(super) after: &'static [DutyEvent],
    pub(super) done: &'static [DutyEvent],
    /// Where it is asked for at all.
    pub(super) asked: fn(&CheckPolicy) -> bool,
}

/// A row of what must be so at a place.
pub(in crate::check) struct Needed {
    pub(in crate::check) at: DutyPlace,
    pub(in crate::check) what: Duty,
    pub(super) needed: fn(&Rules<'_>) -> bool,
    /// The finding; empty where the comparison has texts of its own.
    pub(super) text: &'static str,
}

const fn owed(
    what: Duty,
    after: &'static [DutyEvent],
    done: &'static [DutyEvent],
    asked: fn(&CheckPolicy) -> bool,
) -> Owed {
    Owed { what, after, done, asked }
}

const fn needed(at: DutyPlace, what: Duty, needed: fn(&Rules<'_>) -> bool, text: &'static str) -> Needed {
    Needed { at, what, needed, text }
}

const fn always(_: &Rules<'_>) -> bool {
    true
}

/// Whether the machine retracts before a stop.
fn stops_retracted(rules: &Rules<'_>) -> bool {
    rules.policy().links.retracts_for_stop
}

/// Whether safety lines are those of the control, and not of the shop.
fn has_safety_line(rules: &Rules<'_>) -> bool {
    !rules.policy().shop.own_safety
}

/// Whether codes of the shop switch tip control.
fn has_own_tip_control(policy: &CheckPolicy) -> bool {
    policy.shop.lines.iter().any(|line| matches!(line.place, OwnPlace::TipControl { .. }))
}

/// What is owed, after what, and until what.
#[rustfmt::skip]
pub(super) const OWED: [Owed; 15] = [
    owed(Duty::CompleteState, &[DutyEvent::Begin, DutyEvent::Motion, DutyEvent::Cycle, DutyEvent::BlockSkip], &[DutyEvent::CompleteState], |_| true),
    owed(Duty::Retract, &[DutyEvent::Begin, DutyEvent::CompleteState, DutyEvent::PositionLost, DutyEvent::ShopLine, DutyEvent::BlockSkip], &[DutyEvent::Retract], |_| true),
    owed(Duty::RetractAfterShopLine, &[DutyEvent::ShopLine], &[DutyEvent::Retract], |_| true),
    owed(Duty::Parking, &[DutyEvent::Home], &[], |_| true),
    owed(Duty::DrainDwell, &[DutyEvent::ThroughCoolant], &[DutyEvent::Drained], |policy| policy.links.through_dwell_s > 0.0),
    owed(Duty::SpindleDwell, &[DutyEvent::SpindleStarts], &[DutyEvent::SpindleWaited, DutyEvent::SpindleOff], |policy| policy.links.spindle_dwell_s > 0.0),
    owed(Duty::SpindleAgain, &[DutyEvent::CycleStopsSpindle], &[DutyEvent::SpindleStated], |_| true),
    owed(Duty::TipControlOff, &[DutyEvent::Begin, DutyEvent::CompleteState, DutyEvent::BlockSkip], &[DutyEvent::TipControlOff], has_own_tip_control),
    owed(Duty::PlaneGuard, &[DutyEvent::PlaneCall], &[DutyEvent::PlaneGuard, DutyEvent::Retract, DutyEvent::PositionLost], |policy| policy.shop.guards_planes),
    owed(Duty::OffsetGuard, &[DutyEvent::Begin, DutyEvent::CompleteState], &[DutyEvent::OffsetGuard], |policy| policy.shop.guards_offset),
    owed(Duty::CycleAtLevel, &[DutyEvent::LevelOfCycle], &[DutyEvent::Cycle, DutyEvent::Motion], |_| true),
    owed(Duty::RotationAfterHome, &[DutyEvent::LinearHome], &[DutyEvent::RotaryWords, DutyEvent::PlaneCall], |_| true),
    owed(Duty::MotionInFrame, &[DutyEvent::FrameBegins], &[DutyEvent::LinearStep, DutyEvent::Motion], |_| true),
    owed(Duty::ModesAgain, &[DutyEvent::Measured], &[DutyEvent::CompleteState, DutyEvent::Motion], |_| true),
    owed(Duty::StopInTime, &[DutyEvent::StopPassed], &[DutyEvent::Motion], |_| true),
];

/// What must be so at each place.
#[rustfmt::skip]
pub(in crate::check) const NEEDED: [Needed; 74] = [
    needed(DutyPlace::ToolChange, Duty::Parking, always, ""),
    needed(DutyPlace::ToolChange, Duty::OperationEnded, always, ""),
    needed(DutyPlace::ToolChange, Duty::CompleteState, always, "tool change before the complete state of its operation: where the program is entered there, the tool is missing"),
    needed(DutyPlace::ToolChange, Duty::SpindleOff, always, "tool change with the spindle on"),
    needed(DutyPlace::ToolChange, Duty::DrainDwell, always, "the dwell `coolant.through_dwell` before this tool change is missing"),
    needed(DutyPlace::ToolChange, Duty::Retract, always, "tool change before the machine has retracted"),
    needed(DutyPlace::ToolChange, Duty::AtChangePosition, always, ""),
    needed(DutyPlace::ToolChange, Duty::ApproachEnded, always, ""),
    needed(DutyPlace::ToolChange, Duty::RotationAfterHome, always, NEEDLESS_HOME),
    needed(DutyPlace::ToolChange, Duty::ClampsPositioned, always, ""),
    needed(DutyPlace::ToolChange, Duty::CoolantStated, has_safety_line, "the coolant is not switched off after the restart point, before the tool change"),
    needed(DutyPlace::ToolChange, Duty::CutsEnded, always, ""),

    needed(DutyPlace::Stop, Duty::OperationEnded, always, ""),
    needed(DutyPlace::Stop, Duty::CutsEnded, always, ""),
    needed(DutyPlace::Stop, Duty::Parking, always, ""),
    needed(DutyPlace::Stop, Duty::ClampsOfCuts, always, ""),
    needed(DutyPlace::Stop, Duty::Retracted, stops_retracted, "program stop before the machine has retracted"),
    needed(DutyPlace::Stop, Duty::StateAtEnd, stops_retracted, ""),
    needed(DutyPlace::Stop, Duty::ApproachEnded, always, ""),
    needed(DutyPlace::Stop, Duty::RotationAfterHome, always, NEEDLESS_HOME),
    needed(DutyPlace::Stop, Duty::ClampsAsBefore, always, ""),
    needed(DutyPlace::Stop, Duty::StopInTime, always, "the stop comes after the restart point before which the CL data has it"),

    needed(DutyPlace::Copied, Duty::OperationEnded, always, ""),
    needed(DutyPlace::Copied, Duty::CutsEnded, always, ""),
    needed(DutyPlace::Copied, Duty::ClampsOfCuts, always, ""),

    needed(DutyPlace::Probe, Duty::CutsEnded, always, ""),
    needed(DutyPlace::Probe, Duty::ClampsOfCuts, always, ""),

    needed(DutyPlace::Wait, Duty::Parking, always, ""),

    needed(DutyPlace::BlockSkip, Duty::CutsEnded, always, ""),
    needed(DutyPlace::BlockSkip, Duty::OperationEnded, always, ""),
    needed(DutyPlace::BlockSkip, Duty::ToolEnded, always, ""),
    needed(DutyPlace::BlockSkip, Duty::Parking, always, ""),
    needed(DutyPlace::BlockSkip, Duty::ApproachEnded, always, ""),
    needed(DutyPlace::BlockSkip, Duty::Away, always, "blocks that may be skipped begin and end with the machine retracted: expected the retract before this block"),
    needed(DutyPlace::BlockSkip, Duty::RetractAfterShopLine, always, "blocks that may be skipped begin and end with the machine retracted: expected the retract after the line of the shop before this block"),
    needed(DutyPlace::BlockSkip, Duty::ClampsOfCuts, always, ""),
    needed(DutyPlace::BlockSkip, Duty::SpindleAndCoolantOff, always, "blocks that may be skipped begin and end with spindle and coolant off: one of them is on before this block"),

    needed(DutyPlace::Standstill, Duty::Retracted, always, "a clamp, a chuck, a door or a pallet moves here: expected the machine retract before this block"),
    needed(DutyPlace::Standstill, Duty::ClampsAsBefore, always, ""),
    needed(DutyPlace::Standstill, Duty::SpindleStopped, always, "a clamp, a chuck, a door or a pallet moves here: the spindle is not known to be off"),

    needed(DutyPlace::Measuring, Duty::ClampsPositioned, always, ""),
    needed(DutyPlace::Measuring, Duty::Retract, always, "the machine has not retracted before the tool is measured or checked for breakage"),

    needed(DutyPlace::RetractOfStart, Duty::Parking, always, ""),
    needed(DutyPlace::RetractOfStart, Duty::OffsetGuard, always, ""),
    needed(DutyPlace::RetractOfStart, Duty::RotationAfterHome, always, NEEDLESS_HOME),
    needed(DutyPlace::RetractOfStart, Duty::TipControlOff, always, "tip control may be on: its code off is missing after the restart point and before the retract"),

    needed(DutyPlace::ApproachStep, Duty::PlaneGuard, always, ""),

    needed(DutyPlace::Operation, Duty::CoolantStated, always, "operation starts without its coolant, which must be programmed after its restart point"),
    needed(DutyPlace::Operation, Duty::OffsetStated, has_safety_line, "operation starts without its work offset, which must be programmed after its restart point"),
    needed(DutyPlace::Operation, Duty::SpindleStated, always, "operation starts without its spindle, which must be programmed after its restart point"),
    needed(DutyPlace::Operation, Duty::CompleteState, has_safety_line, "operation starts without a restart point, the block that sets all modal codes"),
    needed(DutyPlace::Operation, Duty::Retract, always, "operation starts without the machine retract after its restart point"),
    needed(DutyPlace::Operation, Duty::ModesAgain, has_safety_line, "the modes are not stated again after the blocks that measure the tool"),
    needed(DutyPlace::Operation, Duty::LengthGuard, always, ""),
    needed(DutyPlace::Operation, Duty::ClampsStated, always, ""),
    needed(DutyPlace::Operation, Duty::AxesStated, has_safety_line, ""),
    needed(DutyPlace::Operation, Duty::TipControlOff, always, "tip control may be on: its code off is missing after the restart point and before the retract"),
    needed(DutyPlace::Operation, Duty::Blank, always, ""),

    needed(DutyPlace::Park, Duty::OperationEnded, always, ""),
    needed(DutyPlace::Park, Duty::ToolEnded, always, ""),

    needed(DutyPlace::FrameEnd, Duty::MotionInFrame, always, "the plane, or the zero that follows the table, ends before a motion in it"),

    needed(DutyPlace::Feed, Duty::SpindleDwell, always, "the dwell after the start of the spindle (`spindle_dwell`) is missing"),
    needed(DutyPlace::Cut, Duty::SpindleAgain, always, SPINDLE_AGAIN),
    needed(DutyPlace::Cut, Duty::RotationAfterHome, always, NEEDLESS_HOME),
    needed(DutyPlace::Cut, Duty::CycleAtLevel, always, "the tool has come to the level of a cycle, and this is none"),
    needed(DutyPlace::Cycle, Duty::SpindleAgain, always, SPINDLE_AGAIN),

    needed(DutyPlace::End, Duty::Retracted, always, "end code before the machine has retracted"),
    needed(DutyPlace::End, Duty::ProgramEnded, always, ""),
    needed(DutyPlace::End, Duty::StateAtEnd, always, ""),
    needed(DutyPlace::End, Duty::ApproachEnded, always, ""),
    needed(DutyPlace::End, Duty::RotationAfterHome, always, NEEDLESS_HOME),
    needed(DutyPlace::End, Duty::CutsEnded, always, ""),
    needed(DutyPlace::End, Duty::ParkingAtEnd, always, ""),
    needed(DutyPlace::End, Duty::ClampsParked, always, ""),
];

const NEEDLESS_HOME: &str =
    "the linear axes have moved to their home positions (`home_on_indexing`), and no rotary axis rotates";
const SPINDLE_AGAIN: &str = "the control has switched the spindle off after the cycle: M3 or M4 is missing";

/// What is done with a tool at positions of the axes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in super::super) enum Station {
    /// It is changed.
    Change,
    /// It is measured, or checked for breakage.
    Measuring,
}

impl Station {
    pub(in super::super) const ALL: [Self; 2] = [Self::Change, Self::Measuring];

    /// Positions of the axes there.
    pub(in super::super) fn places(self, links: &LinkPolicy) -> &BTreeMap<char, f64> {
        match self {
            Self::Change => &links.tool_change_position,
            Self::Measuring => &links.tool_position,
        }
    }

    /// Key of these positions.
    pub(in super::super) fn key(self) -> &'static str {
        match self {
            Self::Change => "retract.tool_change_position",
            Self::Measuring => "cycles.tool_position",
        }
    }
}
