//! Configuration of a job: the options of all stages, from one file.
//!
//! The stages declare their options as tables of keys. Here they are read from a file into [`Config`], printed as a
//! commented sample, and described as a JSON schema. Values are in mm, rad and mm/min; a file states its own unit of
//! length and has angles in degrees. No motion is planned or written here.
//!
//! ```
//! use pp_runtime::config::Config;
//! use pp_runtime::control::LinuxCnc;
//! # pp_runtime::machine! {
//! #     /// A table that rotates about Z on a table that tilts about X.
//! #     pub struct Trunnion;
//! #     chain: C A | X Y Z;
//! # }
//!
//! let config = Config::read::<Trunnion>("part_origin = [0, 0, 40]\n\n[limits]\nA = [-30, 110]\n", &LinuxCnc).expect("a
//! configuration"); assert!(config.is_given("part_origin")); assert!((config.set_up.part_origin[2] - 40.0).abs() <
//! 1e-12);
//!
//! // All faults of a file are reported, each at its place.
//! let faults = Config::read::<Trunnion>("part_orign = [0, 0, 40]\ntolerance = -1\n", &LinuxCnc).expect_err("two
//! faults"); assert_eq!(faults.len(), 2); assert_eq!(faults[0].location.line, 1);
//! ```

mod checking;
mod dimensions;
mod edits;
mod print;
mod read;
#[cfg(test)]
pub(crate) mod sample;
mod schema;
#[cfg(test)]
mod tests;

use std::collections::BTreeSet;

use crate::cl::{self as reading, OwnStatement};
use crate::control::{self, Control, ControlOptions, Demands, LineEffect, take_out_lacking};
use crate::keys::{OneOf, options};
use crate::motion::Policy;
use crate::nc;
use crate::options::StandstillWord;
use crate::program::Units;
use crate::set_up::SetUp;

pub(crate) use crate::keys::{list, nearest};
pub use crate::options::{Mode, MotionOptions, Operations, TcpFrame, TcpWords, ToolPosture, Transition};
pub use checking::NotCheckable;
pub(crate) use edits::EditOptions;
pub use print::print;
pub(crate) use read::read_edits;
pub(crate) use schema::schema;

options! {
    /// All options of a job, by stage. The default is that of LinuxCNC; for another control take its
    /// [`starting_point`], or [`read`](Config::read) a file.
    pub struct Config {
        /// Unit of CL data that does not state its own. Without it such data is refused.
        cl_units: Option<Units> = None, key("cl_units", OneOf(&Units::NAMES), "\"mm\"");
        /// Unit of the NC program. Without it the unit of the CL data is used.
        output_units: Option<Units> = None, key("output_units", OneOf(&Units::NAMES), "\"mm\"");
        /// How the CL data is read; its unit is in `cl_units`.
        cl: reading::ReadingOptions = reading::ReadingOptions::default(), keys();
        /// Set-up: machine, part and tools.
        set_up: SetUp = SetUp::default(), keys();
        /// How motion is planned.
        motion: MotionOptions = MotionOptions::default(), keys();
        /// Digits of the words.
        formats: nc::Formats = nc::Formats::DEFAULT, keys();
        /// How the control differs from its table.
        control: ControlOptions = ControlOptions::default(), keys();
        /// Permitted edits of a posted program.
        check: EditOptions = EditOptions::default(), keys();
        /// The file has lengths and does not state its unit: mm is assumed.
        file_units_assumed: bool = false;
        /// Keys that are given, not assumed, by their paths in a file: `part_origin`, `retract.position`.
        ///
        /// Keys by axis, dimension or tool are not listed: their maps hold only what is given.
        given: BTreeSet<&'static str> = BTreeSet::new();
        /// Settings that the control of the job lacks, one sentence each: see [`for_control`](Self::for_control).
        left_out: Vec<String> = Vec::new();
    }
}

/// Configuration of a control before any file is read: its number formats, else the defaults.
#[must_use]
pub fn starting_point(control: &dyn Control) -> Config {
    Config { formats: control.spellings().formats.clone(), ..Config::default() }
}

impl Config {
    /// Step of the block numbers where they are requested without a step.
    pub const LINE_NUMBER_STEP: u32 = 10;

    /// The configuration as a control carries it out: without the settings that the control lacks and a program does
    /// without, which [`left_out`](Self::left_out) names. Posting and check use this form, so that one file serves
    /// several controls.
    #[must_use]
    pub fn for_control(&self, control: &dyn Control) -> Self {
        let mut config = self.clone();
        let lacking = take_out_lacking(control, &mut config.control, &mut config.motion.operations);
        config.left_out.extend(lacking);
        let blocks = &config.control.program;
        if config.motion.rapids.transition == Transition::Auto
            && !(blocks.operation_start.is_empty() && blocks.operation_end.is_empty())
        {
            // They need the machine retract.
            config.motion.rapids.transition = Transition::Safe;
        }
        let declared = config.control.effects.iter().map(|(text, effect)| (text.as_str(), *effect));
        let stands = declared.chain(control.effects().iter().copied()).filter(|(_, effect)| effect.needs_standstill());
        let stands = stands.map(|(text, effect)| (text, Some(effect.name())));
        let stands = stands.chain(self.unconfirmed().map(|block| (block, None)));
        let word = |(text, effect): (&str, _)| StandstillWord { text: text.trim().to_owned(), effect };
        config.motion.standstill = stands.map(word).collect();
        config
    }

    /// Blocks of `[cl.words]` with a code that is declared "none", and not confirmed to be harmless.
    pub(crate) fn unconfirmed(&self) -> impl Iterator<Item = &str> {
        let is_none = |block: &str| {
            let declared = self.control.effects.iter().filter(|(_, effect)| **effect == LineEffect::None);
            let mut texts = declared.map(|(text, _)| text.as_str());
            texts.any(|text| block.trim() == text || block.split_whitespace().any(|one| one == text))
        };
        let statements = self.cl.own_statements.iter().filter(|own| own.code().is_none() && !own.is_harmless());
        statements.flat_map(OwnStatement::blocks).map(String::as_str).filter(move |block| is_none(block))
    }

    /// Whether no part origin is given, so that the part zero is taken to be the reference point of the table.
    #[must_use]
    pub fn part_origin_is_assumed(&self) -> bool {
        !self.is_given("part_origin") && self.set_up.part_origin.iter().all(|value| value.abs() <= 0.0)
    }

    /// Whether `key` (`retract.position`) is given, not assumed.
    #[must_use]
    pub fn is_given(&self, key: &str) -> bool {
        self.given.contains(key)
    }

    /// The part of the configuration that the planner reads.
    pub(crate) fn policy(&self) -> Policy<'_> {
        self.demands().policy()
    }

    /// Reasons why a control cannot write programs of this configuration for a machine; empty if it can.
    #[must_use]
    pub fn unfit(&self, machine: &dyn crate::kinematics::AnyMachine, control: &dyn Control) -> Vec<String> {
        let mut faults = control::unfit(machine, control, self.demands());
        let of_probes = self.cl.probes.iter().flat_map(|probe| probe.blocks());
        faults.extend(of_probes.filter_map(|block| control::of_another_control(control.spellings(), block)));
        faults.extend(self.unfit_lines(machine, control));
        faults
    }

    /// The part of the configuration that the control reads.
    pub(crate) fn demands(&self) -> Demands<'_> {
        Demands { set_up: &self.set_up, motion: &self.motion, options: &self.control, formats: &self.formats }
    }
}
