//! The set-up of a job: everything that is true of today's part and shop rather than of the machine.
//!
//! [`Config::default`] is the one place where defaults stand; [`print()`] shows them as a file to edit and
//! [`Config::read`] reads such a file. Millimetres, radians and mm/min in here; a file states its own unit of length and
//! writes angles in degrees. Nothing here plans or writes a motion.

mod arcs;
mod axes;
mod cl;
mod clearance;
mod compensation;
mod control;
mod course;
mod cycles;
mod mode;
mod print;
mod read;
#[cfg(test)]
pub(crate) mod sample;
mod schema;
mod set_up;
#[cfg(test)]
mod tests;
mod value;

use std::collections::BTreeSet;

use crate::cl as reading;
use crate::control::{Control, Demands, Options as ControlOptions};
use crate::motion::{self, Policy};
use crate::nc;
use crate::set_up::SetUp;

pub use crate::control::{ProgramBlocks, Smoothing};
pub use crate::motion::{
    Approach, ArcForm, ArcOptions, ArcOutput, ClampCodes, CourseOptions, CutterPath, CycleOptions, CycleOutput,
    Defaults, FeedLimits, GuardOptions, Mode, Operations, PathNorm, Rapid, RapidOptions, Retract, Rewind,
    RotaryOptions, TcpFrame, TcpWords, TipOptions, ToolPosture, Transition, Wrap,
};
pub use crate::nc::Formats;
pub use crate::program::Units;
pub use crate::set_up::{AxisBounds, GivenTool, LengthMode, ProgramZero, Stock};
pub(crate) use course::{preference, preferences};
pub use print::print;
use read::WORK_OFFSETS;
pub(crate) use read::{AXIS_TOLERANCE, TOLERANCE};
pub use schema::schema;
pub(crate) use value::{list, nearest};

/// Everything a job may set, by the stage that it belongs to.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Config {
    /// Unit of the CL data where it does not say so itself; `None` (default): it must say so.
    pub cl_units: Option<Units>,
    /// Unit of the posted program; `None` (default): that of the CL data.
    pub output_units: Option<Units>,
    /// How the CL data is read; its unit is in `cl_units`.
    pub cl: reading::Options,
    /// Machine, part and shop.
    pub set_up: SetUp,
    /// How motion is planned.
    pub motion: motion::Options,
    /// How the control differs from its table.
    pub control: ControlOptions,
    /// Digits of the words.
    pub formats: nc::Formats,
    /// Lengths came from a file that does not state its unit: mm assumed.
    pub file_units_assumed: bool,
    /// What was given rather than assumed: keys as they stand in a file, `part_origin`, `retract.position`.
    ///
    /// The keys of a machine's axes, dimensions and tools are not in here: their maps hold only what was given.
    pub given: BTreeSet<&'static str>,
}

/// The configuration of a control before anything else is said.
#[must_use]
pub fn starting_point(control: &dyn Control) -> Config {
    Config { formats: control.spellings().formats.clone(), ..Config::default() }
}

impl Config {
    /// Step of the block numbers where they are asked for without one.
    pub const LINE_NUMBER_STEP: u32 = 10;

    /// Whether `key` (`retract.position`) was given rather than assumed.
    #[must_use]
    pub fn is_given(&self, key: &str) -> bool {
        self.given.contains(key)
    }

    /// What the planner reads.
    #[must_use]
    pub fn policy(&self) -> Policy<'_> {
        self.demands().policy()
    }

    /// What the control reads.
    #[must_use]
    pub fn demands(&self) -> Demands<'_> {
        Demands { set_up: &self.set_up, motion: &self.motion, options: &self.control, formats: &self.formats }
    }
}
