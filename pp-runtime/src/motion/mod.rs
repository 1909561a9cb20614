//! Planning: events of the CL data become the steps of one machine's program.
//!
//! Input: [`Event`](crate::program::Event)s in mm and rad. Output: [`Step`]s, whose axis words are whole units of their
//! last decimal. Decides branch and revolutions of the rotary axes, limits, feeds and the safe sequence between
//! operations. Does not write the codes of a control and does not read CL text. Nothing is allocated for a motion, and
//! memory does not grow with the number of motions: data kept for an operation, a tool or a change of the course is
//! packed or bounded.
//!
//! The command line and [`post`](crate::post) run it. Its options are part of a configuration, its figures part of a
//! report:
//!
//! ```
//! use pp_runtime::config::Config;
//! use pp_runtime::control::LinuxCnc;
//! use pp_runtime::post::{Job, post_checked};
//! # pp_runtime::machine! {
//! #     /// A table that rotates about Z on a table that tilts about X.
//! #     pub struct Trunnion;
//! #     chain: C A | X Y Z;
//! # }
//!
//! let cl = "UNITS/MM\nLOADTL/1\nSPINDL/3000,CLW\nFEDRAT/500,MMPM\nGOTO/0,0,5,0,0,1\nGOTO/20,0,5,0,0.6,0.8\nFINI\n";
//! let inserted = |tolerance_mm: f64| {
//!     let mut config = Config::default();
//!     config.motion.tolerance_mm = tolerance_mm;
//!     let job = Job { cl_name: "plate.cls", config: &config, control: &LinuxCnc, units: None };
//!     post_checked::<Trunnion>(&job, &mut std::io::Cursor::new(cl)).map(|posted| posted.report.statistics.inserted)
//! };
//! assert!(inserted(0.001)? > inserted(0.1)?);
//! # Ok::<(), pp_runtime::post::PostError>(())
//! ```

#![cfg_attr(not(test), deny(clippy::disallowed_methods))]

mod course;
mod fault;
mod geometry;
mod modes;
mod place;
mod plan;
mod policy;
mod rotary;
mod source;
mod step;

#[cfg(test)]
mod tests;

pub(crate) use course::Course;
pub use course::Navigator;
pub use fault::PlanningError;
#[cfg(test)]
pub(crate) use geometry::ArcPlane;
pub(crate) use geometry::{Circle, StraightCorners, extent};
pub(crate) use modes::{ModeFinder, StretchModes};
pub(crate) use place::{PlaneAbility, PlaneAngles, PoseRule, TipAbility, TipStart, UsableModes, rotaries_of, unsuited};
#[cfg(test)]
pub(crate) use plan::obligations;
pub(crate) use plan::{
    Abilities, ChordedArcs, CutterRadius, MovingAxes, OperationBlocks, OperationTime, ProofProgram, Registers, Sweep,
    Threads, hole_extent,
};
pub use plan::{Planner, Statistics, Times};
pub(crate) use policy::Policy;
pub use rotary::Cost;
pub(crate) use source::{Begins, ItemAction, MotionIndex, OperationStart, ProgramItem};
pub use source::{Source, Stage};
pub use step::{AxisWords, FeedWord, Provenance, Sink, Step};
pub(crate) use step::{
    BlockReason, CannedCycle, CannedKind, CycleAbilities, DiscardSteps, FineBoreAbility, MAX_AXES, ReachedPosition,
    ToolRoutine, UnusedCycles, VECTOR_DECIMALS,
};
