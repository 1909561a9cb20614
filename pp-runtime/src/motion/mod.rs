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
mod options;
mod place;
mod plan;
mod rotary;
mod source;
mod step;
pub(crate) mod tolerances;

#[cfg(test)]
mod tests;

pub use course::{Course, Navigator};
pub use fault::PlanningError;
pub(crate) use geometry::extent;
pub use geometry::{ArcPlane, Circle, StraightCorners};
pub use modes::{ModeFinder, StretchModes};
pub(crate) use options::nearly_zero;
pub use options::{
    Approach, ArcForm, ArcOptions, ArcOutput, BoreRetract, ClampCodes, CoolantOptions, CourseOptions, CutterPath,
    CycleOptions, CycleOutput, Defaults, FeedLimits, GuardOptions, Links, Mode, MotionOptions, OperationChoice,
    OperationEntry, OperationSettings, OperationTable, Operations, OptionalStops, PathNorm, Policy, Rapid,
    RapidOptions, Retract, Rewind, RotaryOptions, Singular, Smoothing, StandstillWord, StretchMode, TcpFrame, TcpWords,
    ThreadFeed, TipOptions, ToolPosture, Transition, Wrap,
};
pub(crate) use place::rotaries_of;
pub use place::{PlaneAbility, PlaneAngles, PoseRule, TipAbility, TipStart, UsableModes, unsuited};
pub(crate) use plan::hole_extent;
#[cfg(test)]
pub(crate) use plan::obligations;
pub use plan::{
    Abilities, ChordedArcs, CutterRadius, FastestRotation, MovingAxes, OperationBlocks, OperationTime, Planner,
    ProofProgram, Registers, Statistics, SurfaceDeviation, Sweep, Thread, Threads, Times,
};
pub use rotary::Cost;
pub use source::{
    Begins, Chosen, ChosenSettings, ItemAction, LinePart, MotionIndex, Next, OperationStart, ProgramItem, Source, Stage,
};
pub use step::{
    AxisWords, BlockReason, CannedCycle, CannedKind, CycleAbilities, DiscardSteps, FeedWord, FineBoreAbility, MAX_AXES,
    Provenance, ReachedPosition, Sink, Step, ToolRoutine, UnusedCycles, VECTOR_DECIMALS,
};
