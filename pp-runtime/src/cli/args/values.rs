//! Values on the command line: their names, and what is wrong with them.

use std::ops::RangeInclusive;
use std::path::PathBuf;

use clap::ValueEnum;
use clap::builder::PossibleValuesParser;

use crate::cl::{Dialect, Frames, Sense, not_inert};
use crate::control::{self, CONTROLS, Control};
use crate::kinematics::Branch;
use crate::motion::{MotionOptions, Operations};
use crate::program::Units;

/// The control of a name that the parser has let pass.
pub(crate) fn named(name: &str) -> &'static dyn Control {
    control::by_name(name).unwrap_or(CONTROLS[0])
}

pub(crate) fn control_name(control: &dyn Control) -> &'static str {
    control.spellings().name
}

pub(crate) fn control_names() -> PossibleValuesParser {
    PossibleValuesParser::new(CONTROLS.iter().map(|control| control_name(*control)))
}

/// A word that may be declared inert.
pub(crate) fn inert(word: &str) -> Result<String, String> {
    match not_inert(word) {
        Some(why) => Err(why),
        None => Ok(word.to_ascii_uppercase()),
    }
}

/// An angle to the pole in degrees, in rad.
pub(crate) fn pole_tolerance(text: &str) -> Result<f64, String> {
    let degrees: f64 = text.parse().map_err(|_| "a number is needed".to_owned())?;
    match (0.0..=5.0).contains(&degrees) {
        true => Ok(degrees.to_radians()),
        false => Err("0 to 5 degrees are needed".to_owned()),
    }
}

/// A range of operations, both ends included.
pub(crate) fn operations(text: &str) -> Result<Operations, String> {
    let number = |text: &str| {
        let number = text.trim().parse().ok().filter(|number| *number > 0);
        number.ok_or_else(|| "operations count from 1: `3..5`, `3..` or `3` is needed".to_owned())
    };
    let (first, last) = match text.split_once("..") {
        Some((first, "")) => (number(first)?, None),
        Some((first, last)) => (number(first)?, Some(number(last)?)),
        None => (number(text)?, Some(number(text)?)),
    };
    match last {
        Some(last) if last < first => Err(format!("this range is empty: `{last}..{first}`?")),
        last => Ok(Operations::Range(first, last)),
    }
}

/// How far a dry run stays away, mm.
pub(crate) fn lift(text: &str) -> Result<f64, String> {
    let value: f64 = text.parse().map_err(|_| "a number is needed".to_owned())?;
    match (1.0..=10_000.0).contains(&value) {
        true => Ok(value),
        false => Err("1 to 10000 mm are needed".to_owned()),
    }
}

/// A point, mm.
pub(crate) fn point(text: &str) -> Result<[f64; 3], String> {
    let number = |text: &str| text.trim().parse().ok().filter(|number: &f64| number.abs() <= 1e5);
    let numbers: Option<Vec<f64>> = text.split(',').map(number).collect();
    let point = numbers.and_then(|numbers| numbers.try_into().ok());
    point.ok_or_else(|| "three numbers are needed: 60,0,120".to_owned())
}

/// A tolerance in mm.
pub(crate) fn tolerance(text: &str) -> Result<f64, String> {
    within(text, &MotionOptions::TOLERANCE, "mm")
}

/// A tolerance in degrees.
pub(crate) fn axis_tolerance(text: &str) -> Result<f64, String> {
    within(text, &MotionOptions::AXIS_TOLERANCE, "degrees")
}

fn within(text: &str, range: &RangeInclusive<f64>, unit: &str) -> Result<f64, String> {
    let value: f64 = text.parse().map_err(|_| "a number is needed".to_owned())?;
    if range.contains(&value) {
        Ok(value)
    } else {
        Err(format!("between {} and {} {unit}", range.start(), range.end()))
    }
}

/// CAM systems on the command line.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum DialectName {
    /// Siemens NX
    Nx,
    /// CATIA
    Catia,
    /// PTC Creo
    Creo,
    /// SolidWorks CAM
    Solidworks,
    /// ISO 4343
    Iso,
}

impl From<DialectName> for Dialect {
    fn from(name: DialectName) -> Self {
        match name {
            DialectName::Nx => Self::Nx,
            DialectName::Catia => Self::Catia,
            DialectName::Creo => Self::Creo,
            DialectName::Solidworks => Self::SolidWorks,
            DialectName::Iso => Self::Iso,
        }
    }
}

/// What becomes of a second frame.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum FramesName {
    /// Mapped into the first
    Main,
    /// A work offset of its own
    Offset,
}

impl From<FramesName> for Frames {
    fn from(name: FramesName) -> Self {
        match name {
            FramesName::Main => Self::Main,
            FramesName::Offset => Self::Offset,
        }
    }
}

/// Sense of circles.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum SenseName {
    /// Clockwise
    Cw,
    /// Counter-clockwise
    Ccw,
}

impl From<SenseName> for Sense {
    fn from(name: SenseName) -> Self {
        match name {
            SenseName::Cw => Self::Clockwise,
            SenseName::Ccw => Self::CounterClockwise,
        }
    }
}

/// A branch, as `explain` numbers them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum BranchName {
    /// The first
    First,
    /// The second
    Second,
}

impl From<BranchName> for Branch {
    fn from(name: BranchName) -> Self {
        match name {
            BranchName::First => Self::First,
            BranchName::Second => Self::Second,
        }
    }
}

/// What becomes of INSERT.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum InsertName {
    /// Written as a comment
    Comment,
}

/// What becomes of FROM.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum FromName {
    /// Written as the first approach
    Move,
}

/// Unit of length on the command line.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum UnitsName {
    /// Millimetres
    Mm,
    /// Inches
    In,
}

impl From<UnitsName> for Units {
    fn from(name: UnitsName) -> Self {
        match name {
            UnitsName::Mm => Self::Millimetres,
            UnitsName::In => Self::Inches,
        }
    }
}

/// How messages are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
pub(crate) enum MessageFormat {
    /// Text with the line it speaks of
    #[default]
    Human,
    /// One JSON object per line
    Json,
}

/// Which block is meant.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum BlockName {
    /// By its block number.
    Number(u32),
    /// By its place in the program, from 1.
    Line(u64),
}

/// The file of a map.
pub(crate) fn map_file(text: &str) -> Result<PathBuf, String> {
    if text == "-" { Err("the name of a file is needed".to_owned()) } else { Ok(text.into()) }
}

/// `N1230` or `57`.
pub(crate) fn block_name(text: &str) -> Result<BlockName, String> {
    let number = text.strip_prefix(['N', 'n']).map(|number| number.parse().map(BlockName::Number).ok());
    let name = number.unwrap_or_else(|| text.parse().ok().filter(|line| *line > 0).map(BlockName::Line));
    name.ok_or_else(|| "`N1230`, a block number, or `57`, a line of the program, is needed".to_owned())
}
