//! Planning: events of the CL data into the steps of one machine's program.
//!
//! Input are [`Event`](crate::program::Event)s in mm and rad, output are [`Step`]s with words in whole units. Branch and
//! turns, limits, feeds and the safe sequence between operations are decided here; how a control spells a step is not,
//! and what the CL data looked like neither. Memory is constant, and nothing is allocated for a motion.

mod account;
mod arc;
mod arcs;
mod auxiliary;
mod choose;
mod circle;
mod clamps;
mod clearance;
mod course;
mod cutter;
mod expand;
mod fault;
mod feed;
mod frame;
mod hole;
mod linearise;
mod operation;
mod options;
mod origin;
mod place;
mod planner;
mod proof;
mod records;
mod refuse;
mod retreat;
mod rewind;
mod selection;
mod sequence;
mod step;
mod structure;
mod tilt;
mod times;
mod tool;
mod travel;
mod waiting;
mod way;
mod wrap;

#[cfg(test)]
pub(crate) mod machines;
#[cfg(test)]
mod tests;

pub use account::{Standing, Why};
pub(crate) use arc::extent;
pub use arcs::Chorded;
pub use circle::{Circle, Plane};
pub use clamps::{Moving, Nowhere};
pub(crate) use clearance::way_out;
pub use course::{Cost, Course, Navigator};
pub use expand::Expander;
pub use frame::{TipAbility, unsuited};
pub(crate) use hole::hole_extent;
pub use hole::{Cycle, CycleAbilities, CycleKind};
pub use options::{
    Approach, ArcForm, ArcOptions, ArcOutput, ClampCodes, CourseOptions, CutterPath, CycleOptions, CycleOutput,
    Defaults, FeedLimits, GuardOptions, Mode, Operations, Options, PathNorm, Policy, Rapid, RapidOptions, Retract,
    Rewind, RotaryOptions, TcpFrame, TcpWords, TipOptions, ToolPosture, Transition, Wrap,
};
pub use planner::{Abilities, Planner, Registers, Statistics, Stop};
pub use proof::Sweep;
pub use selection::Gate;
pub use step::{Feed, MAX_AXES, Sink, Step, VECTOR_DECIMALS, Words};
pub use tilt::{PlaneAbility, PlaneAngles, PoseRule};
pub use times::{FastestTurn, OperationTime, Times};
pub use tool::Tool;
