//! Planning: events of the CL data become the steps of one machine's program.
//!
//! Input: [`Event`](crate::program::Event)s in mm and rad. Output: [`Step`]s, whose axis words are whole units of their
//! last decimal. Decides branch and revolutions of the rotary axes, limits, feeds and the safe sequence between operations.
//! Does not write the codes of a control and does not read CL text. Memory is constant, and nothing is allocated for a
//! motion.

#![cfg_attr(not(test), deny(clippy::disallowed_methods))]

mod course;
mod fault;
mod geometry;
mod modes;
mod options;
mod place;
mod plan;
mod rotary;
mod source;
mod step;

#[cfg(test)]
mod tests;

pub use course::{Course, Navigator};
pub use fault::PlanningError;
pub(crate) use geometry::extent;
pub use geometry::{ArcPlane, Circle};
pub use modes::{ModeFinder, StretchModes};
pub use options::{
    Approach, ArcForm, ArcOptions, ArcOutput, ClampCodes, CourseOptions, CutterPath, CycleOptions, CycleOutput,
    Defaults, FeedLimits, GuardOptions, Links, Mode, MotionOptions, OperationChoice, OperationEntry, OperationSettings,
    OperationTable, Operations, PathNorm, Policy, Rapid, RapidOptions, Retract, Rewind, RotaryOptions, Singular,
    Smoothing, StretchMode, TcpFrame, TcpWords, TipOptions, ToolPosture, Transition, Wrap,
};
pub(crate) use place::rotaries_of;
pub use place::{PlaneAbility, PlaneAngles, PoseRule, TipAbility, TipStart, UsableModes, unsuited};
pub(crate) use plan::hole_extent;
pub use plan::{
    Abilities, ChordedArcs, CutterRadius, FastestRotation, MovingAxes, OperationTime, Planner, ProofProgram, Registers,
    Statistics, Sweep, Times,
};
pub use rotary::Cost;
pub use source::{
    Begins, Chosen, ChosenSettings, ItemAction, LinePart, MotionIndex, Next, OperationStart, ProgramItem, Source, Stage,
};
pub use step::{
    AxisWords, BlockReason, CannedCycle, CannedKind, CycleAbilities, DiscardSteps, FeedWord, MAX_AXES, Provenance,
    ReachedPosition, Sink, Step, VECTOR_DECIMALS,
};
