//! The configuration of a job: the options of every stage, from one file.
//!
//! Stages declare their options as tables of keys; in here they are read from a file, printed as a sample to edit and
//! described as a schema, and [`Config`] holds what comes of it for the stages. Millimetres, radians and mm/min in
//! here; a file states its own unit of length and writes angles in degrees. Nothing here plans or writes a motion.

mod print;
mod read;
#[cfg(test)]
pub(crate) mod sample;
mod schema;
#[cfg(test)]
mod tests;

use std::collections::BTreeSet;

use crate::cl as reading;
use crate::control::{Control, Demands, Options as ControlOptions};
use crate::keys::{OneOf, options};
use crate::motion::{self, Policy};
use crate::nc;
use crate::set_up::SetUp;

pub use crate::control::{ProgramBlocks, Smoothing};
pub(crate) use crate::keys::{list, nearest};
pub use crate::motion::{
    Approach, ArcForm, ArcOptions, ArcOutput, ClampCodes, CourseOptions, CutterPath, CycleOptions, CycleOutput,
    Defaults, FeedLimits, GuardOptions, Mode, Operations, PathNorm, Rapid, RapidOptions, Retract, Rewind,
    RotaryOptions, TcpFrame, TcpWords, TipOptions, ToolPosture, Transition, Wrap,
};
pub use crate::nc::Formats;
pub use crate::program::Units;
pub use crate::set_up::{AxisBounds, GivenTool, LengthMode, ProgramZero, Stock};
pub use print::print;
pub use schema::schema;

options! {
    /// Everything a job may set, by the stage that it belongs to.
    pub struct Config {
        /// Unit of CL data that does not state its own. Without it such data is refused.
        cl_units: Option<Units> = None, key("cl_units", OneOf(&UNITS), "\"mm\"");
        /// Unit of the program. Without it that of the CL data.
        output_units: Option<Units> = None, key("output_units", OneOf(&UNITS), "\"mm\"");
        /// How the CL data is read; its unit is in `cl_units`.
        cl: reading::Options = reading::Options::default(), keys();
        /// Machine, part and shop.
        set_up: SetUp = SetUp::default(), keys();
        /// How motion is planned.
        motion: motion::MotionOptions = motion::MotionOptions::default(), keys();
        /// Digits of the words.
        formats: nc::Formats = nc::Formats::DEFAULT, keys();
        /// How the control differs from its table.
        control: ControlOptions = ControlOptions::default(), keys();
        /// Lengths came from a file that does not state its unit: mm assumed.
        file_units_assumed: bool = false;
        /// What was given rather than assumed: keys as they are in a file, `part_origin`, `retract.position`.
        ///
        /// The keys of a machine's axes, dimensions and tools are not in here: their maps hold only what was given.
        given: BTreeSet<&'static str> = BTreeSet::new();
    }
}

/// Units of length by their names.
const UNITS: [(&str, Units); 2] = [("mm", Units::Millimetres), ("in", Units::Inches)];

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
