//! Values of options: their names, their parsers, and the messages for values that are refused.

use std::ffi::OsStr;
use std::fmt;
use std::ops::RangeInclusive;
use std::path::PathBuf;

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use clap::{Arg, Command, ValueEnum};

use crate::cl::{Dialect, Frames, Sense, not_inert};
use crate::control::{CONTROLS, Control};
use crate::kinematics::Branch;
use crate::options::{MotionOptions, Operations};
use crate::program::Units;
use crate::view::ReportForm;

/// A value of `--control`.
#[derive(Clone, Copy)]
pub(crate) struct ChosenControl(pub(crate) &'static dyn Control);

impl fmt::Debug for ChosenControl {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.0.spellings().name)
    }
}

/// Parser of `--control`: the names of these controls, the default first.
#[derive(Clone)]
pub(crate) struct ControlNames(Vec<&'static dyn Control>);

impl ControlNames {
    /// Own controls, then those of this crate that have other names.
    pub(crate) fn with(own: &[&'static dyn Control]) -> Self {
        let name = |control: &dyn Control| control.spellings().name;
        let others = CONTROLS.iter().filter(|control| own.iter().all(|own| name(*own) != name(**control)));
        Self(own.iter().chain(others).copied().collect())
    }

    pub(crate) fn default_name(&self) -> &'static str {
        self.0.first().map_or("", |control| control.spellings().name)
    }

    /// The control of this name.
    pub(crate) fn find(&self, name: &str) -> Option<&'static str> {
        self.0.iter().map(|control| control.spellings().name).find(|known| *known == name)
    }

    fn names(&self) -> PossibleValuesParser {
        PossibleValuesParser::new(self.0.iter().map(|control| control.spellings().name))
    }
}

impl TypedValueParser for ControlNames {
    type Value = ChosenControl;

    fn parse_ref(&self, command: &Command, arg: Option<&Arg>, value: &OsStr) -> Result<ChosenControl, clap::Error> {
        let name = self.names().parse_ref(command, arg, value)?;
        let control = self.0.iter().find(|control| control.spellings().name == name);
        Ok(ChosenControl(control.copied().unwrap_or(CONTROLS[0])))
    }

    fn possible_values(&self) -> Option<Box<dyn Iterator<Item = PossibleValue> + '_>> {
        Some(Box::new(self.0.iter().map(|control| PossibleValue::new(control.spellings().name))))
    }
}

/// A word of CL data to be ignored, in capitals; refuses a word that must not be ignored.
pub(crate) fn inert(word: &str) -> Result<String, String> {
    match not_inert(word) {
        Some(why) => Err(why),
        None => Ok(word.to_ascii_uppercase()),
    }
}

/// Parses an angle to the pole in degrees; returns it in rad.
pub(crate) fn pole_tolerance(text: &str) -> Result<f64, String> {
    let degrees: f64 = text.parse().map_err(|_| "expected a number of degrees".to_owned())?;
    match (0.0..=5.0).contains(&degrees) {
        true => Ok(degrees.to_radians()),
        false => Err("expected 0 to 5 degrees".to_owned()),
    }
}

/// Parses a range of operation numbers, both ends included.
pub(crate) fn operations(text: &str) -> Result<Operations, String> {
    let number = |text: &str| {
        let number = text.trim().parse().ok().filter(|number| *number > 0);
        number.ok_or_else(|| "operations are numbered from 1: expected `3..5`, `3..` or `3`".to_owned())
    };
    let (first, last) = match text.split_once("..") {
        Some((first, "")) => (number(first)?, None),
        Some((first, last)) => (number(first)?, Some(number(last)?)),
        None => (number(text)?, Some(number(text)?)),
    };
    match last {
        Some(last) if last < first => Err(format!("the range is empty; did you mean `{last}..{first}`?")),
        last => Ok(Operations::Range(first, last)),
    }
}

/// Parses the distance of a dry run from the part, mm.
pub(crate) fn lift(text: &str) -> Result<f64, String> {
    let value: f64 = text.parse().map_err(|_| "expected a distance in mm".to_owned())?;
    match (1.0..=10_000.0).contains(&value) {
        true => Ok(value),
        false => Err("expected 1 to 10000 mm".to_owned()),
    }
}

/// Parses a point, mm.
pub(crate) fn point(text: &str) -> Result<[f64; 3], String> {
    let number = |text: &str| text.trim().parse().ok().filter(|number: &f64| number.abs() <= 1e5);
    let numbers: Option<Vec<f64>> = text.split(',').map(number).collect();
    let point = numbers.and_then(|numbers| numbers.try_into().ok());
    point.ok_or_else(|| "expected three coordinates in mm, such as 60,0,120".to_owned())
}

/// Parses a tolerance, mm.
pub(crate) fn tolerance(text: &str) -> Result<f64, String> {
    within(text, &MotionOptions::TOLERANCE, "mm")
}

/// Parses the pitch of a stock, mm.
#[cfg(feature = "simulate")]
pub(crate) fn pitch(text: &str) -> Result<f64, String> {
    within(text, &(1e-3..=100.0), "mm")
}

/// Parses a tolerance of the comparison with a design, mm.
#[cfg(feature = "simulate")]
pub(crate) fn deviation(text: &str) -> Result<f64, String> {
    within(text, &(0.0..=100.0), "mm")
}

/// Parses a tolerance in degrees; returns it in rad.
pub(crate) fn axis_tolerance(text: &str) -> Result<f64, String> {
    within(text, &MotionOptions::AXIS_TOLERANCE, "degrees").map(f64::to_radians)
}

fn within(text: &str, range: &RangeInclusive<f64>, unit: &str) -> Result<f64, String> {
    let value: f64 = text.parse().map_err(|_| format!("expected a number in {unit}"))?;
    if range.contains(&value) {
        Ok(value)
    } else {
        Err(format!("expected a value between {} and {} {unit}", range.start(), range.end()))
    }
}

/// CAM system.
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
    /// Posts "Common ISO 4343 APT" and "CAMplete APT" of Autodesk (Fusion, Inventor CAM, HSMWorks)
    Autodesk,
}

impl From<DialectName> for Dialect {
    fn from(name: DialectName) -> Self {
        match name {
            DialectName::Nx => Self::Nx,
            DialectName::Catia => Self::Catia,
            DialectName::Creo => Self::Creo,
            DialectName::Solidworks => Self::SolidWorks,
            DialectName::Iso => Self::Iso,
            DialectName::Autodesk => Self::Autodesk,
        }
    }
}

/// In which frame the points after a frame are that differs from the first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum FramesName {
    /// In it: they are transformed into the first
    Main,
    /// In the first frame of the file
    First,
}

impl From<FramesName> for Frames {
    fn from(name: FramesName) -> Self {
        match name {
            FramesName::Main => Self::Main,
            FramesName::First => Self::First,
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

/// Branch of the inverse kinematics, as `explain` numbers them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum BranchName {
    /// The first branch, as `explain` numbers them
    First,
    /// The second branch
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

/// Treatment of INSERT.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum InsertName {
    /// Its text is written as a comment
    Comment,
}

/// Treatment of FROM.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum FromName {
    /// It is written as the first approach
    Move,
}

/// Unit of length.
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

/// Format of the messages.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
pub(crate) enum MessageFormat {
    /// Text, with the line of the file that the message refers to
    #[default]
    Human,
    /// One JSON object per line
    Json,
}

/// A block, as the user names it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum BlockName {
    /// By its block number.
    Number(u32),
    /// By its line in the program, from 1.
    Line(u64),
}

/// Parses the name of a file that is written besides the program.
pub(crate) fn file_name(text: &str) -> Result<PathBuf, String> {
    if text == "-" { Err("expected the name of a file".to_owned()) } else { Ok(text.into()) }
}

/// A set-up sheet to write.
#[derive(Debug, Clone)]
pub(crate) struct ReportFile {
    pub(crate) path: PathBuf,
    pub(crate) form: ReportForm,
}

/// Parses the name of a set-up sheet.
pub(crate) fn report_file(text: &str) -> Result<ReportFile, String> {
    let path = file_name(text)?;
    let extension = path.extension().unwrap_or_default().to_string_lossy().to_ascii_lowercase();
    let form = ReportForm::EXTENSIONS.into_iter().find(|(name, _)| *name == extension).map(|(_, form)| form);
    let form = form.ok_or_else(|| "expected a name that ends with .html, .md or .json".to_owned())?;
    Ok(ReportFile { path, form })
}

/// Parses a block: `N1230` (block number) or `57` (line).
pub(crate) fn block_name(text: &str) -> Result<BlockName, String> {
    let number = text.strip_prefix(['N', 'n']).map(|number| number.parse().map(BlockName::Number).ok());
    let name = number.unwrap_or_else(|| text.parse().ok().filter(|line| *line > 0).map(BlockName::Line));
    name.ok_or_else(|| "expected a block number such as `N1230`, or a line of the program such as `57`".to_owned())
}
