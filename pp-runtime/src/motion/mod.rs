//! Planning: events of the CL data into the steps of one machine's program.
//!
//! Input are [`Event`](crate::program::Event)s in mm and rad, output are [`Step`]s with words in whole units. Branch and
//! turns, limits, feeds and the safe sequence between operations are decided here; how a control spells a step is not,
//! and what the CL data looked like neither. Memory is constant, and nothing is allocated for a motion.

mod account;
mod arc;
mod choose;
mod circle;
mod clearance;
mod course;
mod fault;
mod frame;
mod hole_cycle;
mod linearise;
mod options;
mod origin;
mod place;
mod plan;
mod refuse;
mod source;
mod step;
mod structure;
mod tilt;
mod travel;
mod way;
mod wrap;

#[cfg(test)]
pub(crate) mod machines;
#[cfg(test)]
mod tests;

pub use account::{Provenance, Standing, Why};
pub(crate) use arc::extent;
pub use circle::{Circle, Plane};
pub(crate) use clearance::way_out;
pub use course::{Cost, Course, Navigator};
pub use fault::Stop;
pub use frame::{TipAbility, unsuited};
pub use hole_cycle::{Cycle, CycleAbilities, CycleKind};
pub use options::{
    Approach, ArcForm, ArcOptions, ArcOutput, ClampCodes, CourseOptions, CutterPath, CycleOptions, CycleOutput,
    Defaults, FeedLimits, GuardOptions, Mode, Operations, Options, PathNorm, Policy, Rapid, RapidOptions, Retract,
    Rewind, RotaryOptions, TcpFrame, TcpWords, TipOptions, ToolPosture, Transition, Wrap,
};
pub(crate) use plan::hole_extent;
pub use plan::{
    Abilities, Chorded, FastestTurn, Moving, OperationTime, Planner, ProofProgram, Registers, Statistics, Sweep, Times,
};
pub(crate) use source::Setting;
pub use source::{Action, Begins, Item, MotionIndex, Next, Source, Stage};
pub use step::{Feed, MAX_AXES, Nowhere, Sink, Step, VECTOR_DECIMALS, Words};
pub use tilt::{PlaneAbility, PlaneAngles, PoseRule};
