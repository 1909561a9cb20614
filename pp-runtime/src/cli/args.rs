//! The words of the command line.

use std::ffi::OsString;
use std::ops::RangeInclusive;
use std::path::{Path, PathBuf};

use clap::builder::PossibleValuesParser;
use clap::{Args, CommandFactory, FromArgMatches, Parser, Subcommand, ValueEnum};

use crate::cl::{Dialect, Frames, Insert, Sense, not_inert};
use crate::config::Config;
use crate::control::{self, CONTROLS, Control};
use crate::kinematics::{Branch, Machine};
use crate::motion::{CourseOptions, Mode, Operations, Options};
use crate::program::Units;

/// Turns CL data (APT/CLS) into a program for one machine.
#[derive(Debug, Parser)]
#[command(version, disable_help_subcommand = true)]
pub(super) struct Cli {
    #[command(subcommand)]
    pub(super) command: Command,
}

/// What to do.
#[derive(Debug, Subcommand)]
pub(super) enum Command {
    /// Post CL data: write the program for this machine
    Post(Box<PostArgs>),
    /// Compare a program with its CL data: path, feed, state and safe sequences
    Check(Box<CheckArgs>),
    /// Tell where a block of the program comes from: its record, why it is there, and where the machine stands behind it
    ExplainBlock(Box<ExplainBlockArgs>),
    /// Print a configuration file that holds every default
    Config(ConfigArgs),
    /// Print how the kinematics of this machine were derived, and a jog sheet
    Explain(ExplainArgs),
}

/// Arguments of `config`.
#[derive(Debug, Args)]
pub(super) struct ConfigArgs {
    /// Print a JSON schema of the file for editors instead
    #[arg(long)]
    pub(super) schema: bool,
    /// Control whose defaults it holds
    #[arg(long, value_name = "NAME", value_parser = control_names(), default_value = control_name(CONTROLS[0]))]
    control: String,
}

impl ConfigArgs {
    /// The control that was asked for.
    pub(super) fn control(&self) -> &'static dyn Control {
        named(&self.control)
    }
}

/// The control of a name that the parser has let pass.
fn named(name: &str) -> &'static dyn Control {
    control::by_name(name).unwrap_or(CONTROLS[0])
}

/// Arguments of `explain`.
#[derive(Debug, Args)]
pub(super) struct ExplainArgs {
    /// Write a LaTeX document instead of text
    #[arg(long, conflicts_with = "cl")]
    pub(super) latex: bool,
    /// Print what becomes of each word of CL data instead
    #[arg(long)]
    pub(super) cl: bool,
    /// Write a program that proves the kinematics at the machine: the tip stays while each rotary axis sweeps its travel
    #[arg(long, conflicts_with_all = ["latex", "cl"])]
    pub(super) proof_program: bool,
    #[command(flatten)]
    pub(super) proof: ProofArgs,
}

/// What a proof program is written for.
#[derive(Debug, Args)]
pub(super) struct ProofArgs {
    /// Control that will run the proof program
    #[arg(long, value_name = "NAME", value_parser = control_names(), default_value = control_name(CONTROLS[0]))]
    control: String,
    /// Configuration of machine and set-up
    #[arg(long, value_name = "FILE.toml", requires = "proof_program")]
    pub(super) config: Option<PathBuf>,
    /// Where the tip stands in the part, mm; without it at the part zero
    #[arg(long, value_name = "X,Y,Z", requires = "proof_program", value_parser = point, allow_hyphen_values = true)]
    pub(super) point: Option<[f64; 3]>,
    /// Tool in the spindle; without it that of the configuration, or 1
    #[arg(long, value_name = "N", requires = "proof_program", value_parser = clap::value_parser!(u32).range(1..=99_999))]
    pub(super) tool: Option<u32>,
}

impl ProofArgs {
    /// The control that was asked for.
    pub(super) fn control(&self) -> &'static dyn Control {
        named(&self.control)
    }
}

/// Arguments of `post`.
#[derive(Debug, Args)]
pub(super) struct PostArgs {
    /// CL data; `-` is standard input
    #[arg(value_name = "IN.cls")]
    pub(super) input: PathBuf,
    /// Program to write; `-` is standard output
    #[arg(short, long, value_name = "OUT", default_value = "-")]
    pub(super) output: PathBuf,
    /// Write for each line of the program which record it serves, why, and where the machine stands behind it
    #[arg(long, value_name = "FILE.json", value_parser = map_file)]
    pub(super) map: Option<PathBuf>,
    /// Do not read the program back and compare it with the CL data
    #[arg(long)]
    pub(super) no_check: bool,
    #[command(flatten)]
    pub(super) set_up: SetUpArgs,
}

/// Arguments of `check`.
#[derive(Debug, Args)]
pub(super) struct CheckArgs {
    /// CL data; `-` is standard input
    #[arg(value_name = "IN.cls")]
    pub(super) input: PathBuf,
    /// Program to compare with it; `-` is standard input
    #[arg(value_name = "OUT.nc")]
    pub(super) program: PathBuf,
    /// Messages as JSON, and the figures as an object on standard output
    #[arg(long)]
    pub(super) json: bool,
    #[command(flatten)]
    pub(super) set_up: SetUpArgs,
}

impl CheckArgs {
    /// How messages are written.
    pub(super) fn format(&self) -> MessageFormat {
        if self.json { MessageFormat::Json } else { self.set_up.message_format }
    }
}

/// Arguments of `explain-block`.
#[derive(Debug, Args)]
pub(super) struct ExplainBlockArgs {
    /// CL data; `-` is standard input
    #[arg(value_name = "IN.cls")]
    pub(super) input: PathBuf,
    /// The block: `N1230` by its number, `57` by its line in the program
    #[arg(value_name = "BLOCK", value_parser = block_name)]
    pub(super) block: BlockName,
    #[command(flatten)]
    pub(super) set_up: SetUpArgs,
}

/// Which block is meant.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum BlockName {
    /// By the number that stands in it.
    Number(u32),
    /// By its place in the program, from 1.
    Line(u64),
}

/// The file of a map.
fn map_file(text: &str) -> Result<PathBuf, String> {
    if text == "-" { Err("the name of a file is needed".to_owned()) } else { Ok(text.into()) }
}

/// `N1230` or `57`.
fn block_name(text: &str) -> Result<BlockName, String> {
    let number = text.strip_prefix(['N', 'n']).map(|number| number.parse().map(BlockName::Number).ok());
    let name = number.unwrap_or_else(|| text.parse().ok().filter(|line| *line > 0).map(BlockName::Line));
    name.ok_or_else(|| "`N1230`, a block number, or `57`, a line of the program, is needed".to_owned())
}

/// How CL data becomes a program: what posting and checking have to agree on.
#[derive(Debug, Args)]
pub(super) struct SetUpArgs {
    /// Control that will run the program
    #[arg(long, value_name = "NAME", value_parser = control_names(), default_value = control_name(CONTROLS[0]))]
    pub(super) control: String,
    /// Configuration of machine and set-up (see `config`)
    #[arg(long, value_name = "FILE.toml")]
    pub(super) config: Option<PathBuf>,
    /// Unit of the CL data where it does not say so itself
    #[arg(long, value_enum)]
    pub(super) units: Option<UnitsName>,
    /// Unit of the program; without it that of the CL data
    #[arg(long, value_enum)]
    pub(super) output_units: Option<UnitsName>,
    /// How far arcs and chords may leave the arcs and curves of the CL data, and the tip its line while a rotary axis moves, mm
    #[arg(long, value_name = "MM", value_parser = tolerance)]
    pub(super) tolerance: Option<f64>,
    /// How far the tool axis may leave its even turn from one point to the next, degrees
    #[arg(long, value_name = "DEG", value_parser = axis_tolerance)]
    pub(super) axis_tolerance_path: Option<f64>,
    /// LINTOL of the CL data may be wider than the tolerance
    #[arg(long)]
    pub(super) allow_lintol: bool,
    /// CAM system that wrote the CL data where it does not tell, or tells wrongly
    #[arg(long, value_enum)]
    pub(super) dialect: Option<DialectName>,
    /// Columns of a line that count
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(8..=4096))]
    pub(super) columns: Option<u32>,
    /// Pass this word of the CL data over; may be repeated
    #[arg(long, value_name = "WORD", value_parser = inert)]
    pub(super) inert: Vec<String>,
    /// What to do with a frame that differs from the first
    #[arg(long, value_enum)]
    pub(super) frames: Option<FramesName>,
    /// Sense of every CIRCLE about its axis, whatever its form says
    #[arg(long, value_enum)]
    pub(super) circle_sense: Option<SenseName>,
    /// What to do with INSERT
    #[arg(long, value_enum)]
    pub(super) insert: Option<InsertName>,
    /// Write INSERT as NC text that nobody checks
    #[arg(long, conflicts_with = "insert")]
    pub(super) allow_insert: bool,
    /// Write FROM as the first approach
    #[arg(long, value_enum)]
    pub(super) from: Option<FromName>,
    /// Branch on which operations begin where they can
    #[arg(long, value_enum)]
    pub(super) start_branch: Option<BranchName>,
    /// Side of zero on which operations begin where they can: `B+`
    #[arg(long, value_name = "AXIS±", allow_hyphen_values = true)]
    pub(super) prefer: Option<String>,
    /// Choose branch and turns motion by motion, without a view ahead
    #[arg(long)]
    pub(super) greedy: bool,
    /// Angle to the pole within which the tool axis is put there, degrees
    #[arg(long, value_name = "DEGREES", value_parser = pole_tolerance)]
    pub(super) axis_tolerance: Option<f64>,
    /// What the words of a motion say: axis values, tip coordinates, or coordinates in a tilted plane
    #[arg(long, value_name = "MODE", value_parser = PossibleValuesParser::new(Mode::NAMES.map(|(name, _)| name)))]
    pub(super) mode: Option<String>,
    /// Dry run: move every point out along the tool axis by so many mm, with the spindle off
    #[arg(long, value_name = "MM", value_parser = lift)]
    pub(super) lift: Option<f64>,
    /// Post these operations only: `3..5`, `3..` or `3`
    #[arg(long, value_name = "M..N", value_parser = operations)]
    pub(super) ops: Option<Operations>,
    /// Post from this operation on
    #[arg(long, value_name = "NAME", conflicts_with = "ops")]
    pub(super) from_op: Option<String>,
    /// Number the blocks
    #[arg(long)]
    pub(super) line_numbers: bool,
    /// How messages are written
    #[arg(long, value_enum, default_value_t)]
    pub(super) message_format: MessageFormat,
}

impl SetUpArgs {
    /// The control that was asked for.
    pub(super) fn control(&self) -> &'static dyn Control {
        named(&self.control)
    }

    /// Puts what the command line says on top of what the configuration file says.
    ///
    /// # Errors
    /// A sentence about what does not fit the machine.
    pub(super) fn apply<M: Machine>(&self, config: &mut Config) -> Result<(), String> {
        if let Some(units) = self.units {
            config.cl_units = Some(units.into());
            config.given.insert("cl_units");
        }
        if let Some(units) = self.output_units {
            config.output_units = Some(units.into());
            config.given.insert("output_units");
        }
        if let Some(tolerance) = self.tolerance {
            config.motion.tolerance = tolerance;
            config.given.insert("tolerance");
        }
        if let Some(tolerance) = self.axis_tolerance_path {
            config.motion.axis_tolerance_path = tolerance.to_radians();
            config.given.insert("axis_tolerance_path");
        }
        config.motion.allow_lintol |= self.allow_lintol;
        config.motion.course.start_branch = self.start_branch.map(Into::into).or(config.motion.course.start_branch);
        if let Some(text) = &self.prefer {
            let help =
                || format!("--prefer {text} is not known here: {}", CourseOptions::preferences(M::NAME, M::AXES));
            config.motion.course.prefer = Some(CourseOptions::preference(M::AXES, text).ok_or_else(help)?);
        }
        config.motion.operations = self.from_op.clone().map(Operations::From).or_else(|| self.ops.clone());
        let named = |mode: &String| Mode::NAMES.iter().find(|(name, _)| name == mode).map(|(_, mode)| *mode);
        if let Some(mode) = self.mode.as_ref().and_then(named) {
            config.motion.mode = mode;
            config.given.insert("mode");
        }
        config.motion.lift = self.lift.or(config.motion.lift);
        config.motion.course.greedy |= self.greedy;
        config.motion.course.axis_tolerance = self.axis_tolerance.unwrap_or(config.motion.course.axis_tolerance);
        let cl = &mut config.cl;
        cl.dialect = self.dialect.map(Into::into).or(cl.dialect);
        cl.columns = self.columns.or(cl.columns);
        cl.inert.extend(self.inert.iter().cloned());
        cl.frames = self.frames.map_or(cl.frames, Into::into);
        cl.circle_sense = self.circle_sense.map(Into::into).or(cl.circle_sense);
        cl.insert = match (self.insert, self.allow_insert) {
            (_, true) => Insert::Write,
            (Some(InsertName::Comment), false) => Insert::Comment,
            (None, false) => cl.insert,
        };
        cl.from_move |= self.from.is_some();
        if self.line_numbers {
            config.control.program.line_numbers.get_or_insert(Config::LINE_NUMBER_STEP);
            config.given.insert("program.line_numbers");
        }
        Ok(())
    }
}

fn control_name(control: &dyn Control) -> &'static str {
    control.spellings().name
}

fn control_names() -> PossibleValuesParser {
    PossibleValuesParser::new(CONTROLS.iter().map(|control| control_name(*control)))
}

/// A word that may be declared inert.
fn inert(word: &str) -> Result<String, String> {
    match not_inert(word) {
        Some(why) => Err(why),
        None => Ok(word.to_ascii_uppercase()),
    }
}

/// An angle to the pole in degrees, in rad.
fn pole_tolerance(text: &str) -> Result<f64, String> {
    let degrees: f64 = text.parse().map_err(|_| "a number is needed".to_owned())?;
    match (0.0..=5.0).contains(&degrees) {
        true => Ok(degrees.to_radians()),
        false => Err("0 to 5 degrees are needed".to_owned()),
    }
}

/// A range of operations, both ends included.
fn operations(text: &str) -> Result<Operations, String> {
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
fn lift(text: &str) -> Result<f64, String> {
    let value: f64 = text.parse().map_err(|_| "a number is needed".to_owned())?;
    match (1.0..=10_000.0).contains(&value) {
        true => Ok(value),
        false => Err("1 to 10000 mm are needed".to_owned()),
    }
}

/// A point, mm.
fn point(text: &str) -> Result<[f64; 3], String> {
    let number = |text: &str| text.trim().parse().ok().filter(|number: &f64| number.abs() <= 1e5);
    let numbers: Option<Vec<f64>> = text.split(',').map(number).collect();
    let point = numbers.and_then(|numbers| numbers.try_into().ok());
    point.ok_or_else(|| "three numbers are needed: 60,0,120".to_owned())
}

/// A tolerance in mm.
fn tolerance(text: &str) -> Result<f64, String> {
    within(text, &Options::TOLERANCE, "mm")
}

/// A tolerance in degrees.
fn axis_tolerance(text: &str) -> Result<f64, String> {
    within(text, &Options::AXIS_TOLERANCE, "degrees")
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
pub(super) enum DialectName {
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
pub(super) enum FramesName {
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
pub(super) enum SenseName {
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
pub(super) enum BranchName {
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
pub(super) enum InsertName {
    /// Written as a comment
    Comment,
}

/// What becomes of FROM.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum FromName {
    /// Written as the first approach
    Move,
}

/// Unit of length on the command line.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum UnitsName {
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
pub(super) enum MessageFormat {
    /// Text with the line it speaks of
    #[default]
    Human,
    /// One JSON object per line
    Json,
}

/// Parses the command line; the command goes by the name of its file.
pub(super) fn parse(machine: &str, args: &[OsString]) -> Result<Cli, clap::Error> {
    let stem =
        args.first().and_then(|name| Path::new(name).file_stem()).map(|stem| stem.to_string_lossy().into_owned());
    let name = stem.unwrap_or_else(|| machine.to_owned());
    let about = format!("Postprocessor for {machine}: turns CL data (APT/CLS) into a program for this machine");
    let command = Cli::command().bin_name(&name).display_name(name).about(about);
    Cli::from_arg_matches(&command.try_get_matches_from(args)?)
}
