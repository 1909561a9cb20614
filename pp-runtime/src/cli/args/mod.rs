//! The words of the command line.

mod values;

use std::ffi::OsString;
use std::path::{Path, PathBuf};

use clap::builder::PossibleValuesParser;
use clap::{Args, CommandFactory, FromArgMatches, Parser, Subcommand};

use crate::cl::Insert;
use crate::config::Config;
use crate::control::{CONTROLS, Control};
use crate::kinematics::AnyMachine;
use crate::motion::{CourseOptions, Mode, Operations};

pub(crate) use values::{BlockName, MessageFormat};
use values::{
    BranchName, DialectName, FramesName, FromName, InsertName, SenseName, UnitsName, axis_tolerance, block_name,
    control_name, control_names, inert, lift, map_file, named, operations, point, pole_tolerance, tolerance,
};

/// Turns CL data (APT/CLS) into a program for one machine.
#[derive(Debug, Parser)]
#[command(version, disable_help_subcommand = true)]
pub(crate) struct Cli {
    #[command(subcommand)]
    pub(crate) command: Command,
}

/// What to do.
#[derive(Debug, Subcommand)]
pub(crate) enum Command {
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
pub(crate) struct ConfigArgs {
    /// Print a JSON schema of the file for editors instead
    #[arg(long)]
    pub(crate) schema: bool,
    /// Control whose defaults it holds
    #[arg(long, value_name = "NAME", value_parser = control_names(), default_value = control_name(CONTROLS[0]))]
    control: String,
}

impl ConfigArgs {
    /// The control that was asked for.
    pub(crate) fn control(&self) -> &'static dyn Control {
        named(&self.control)
    }
}

/// Arguments of `explain`.
#[derive(Debug, Args)]
pub(crate) struct ExplainArgs {
    /// Write a LaTeX document instead of text
    #[arg(long, conflicts_with = "cl")]
    pub(crate) latex: bool,
    /// Print what becomes of each word of CL data instead
    #[arg(long)]
    pub(crate) cl: bool,
    /// Write a program that proves the kinematics at the machine: the tip stays while each rotary axis sweeps its travel
    #[arg(long, conflicts_with_all = ["latex", "cl"])]
    pub(crate) proof_program: bool,
    #[command(flatten)]
    pub(crate) proof: ProofArgs,
}

/// What a proof program is written for.
#[derive(Debug, Args)]
pub(crate) struct ProofArgs {
    /// Control that will run the proof program
    #[arg(long, value_name = "NAME", value_parser = control_names(), default_value = control_name(CONTROLS[0]))]
    control: String,
    /// Configuration of machine and set-up
    #[arg(long, value_name = "FILE.toml", requires = "proof_program")]
    pub(crate) config: Option<PathBuf>,
    /// Where the tip stands in the part, mm; without it at the part zero
    #[arg(long, value_name = "X,Y,Z", requires = "proof_program", value_parser = point, allow_hyphen_values = true)]
    pub(crate) point: Option<[f64; 3]>,
    /// Tool in the spindle; without it that of the configuration, or 1
    #[arg(long, value_name = "N", requires = "proof_program", value_parser = clap::value_parser!(u32).range(1..=99_999))]
    pub(crate) tool: Option<u32>,
}

impl ProofArgs {
    /// The control that was asked for.
    pub(crate) fn control(&self) -> &'static dyn Control {
        named(&self.control)
    }
}

/// Arguments of `post`.
#[derive(Debug, Args)]
pub(crate) struct PostArgs {
    /// CL data; `-` is standard input
    #[arg(value_name = "IN.cls")]
    pub(crate) input: PathBuf,
    /// Program to write; `-` is standard output
    #[arg(short, long, value_name = "OUT", default_value = "-")]
    pub(crate) output: PathBuf,
    /// Write for each line of the program which record it serves, why, and where the machine stands behind it
    #[arg(long, value_name = "FILE.json", value_parser = map_file)]
    pub(crate) map: Option<PathBuf>,
    /// Do not read the program back and compare it with the CL data
    #[arg(long)]
    pub(crate) no_check: bool,
    #[command(flatten)]
    pub(crate) set_up: SetUpArgs,
}

/// Arguments of `check`.
#[derive(Debug, Args)]
pub(crate) struct CheckArgs {
    /// CL data; `-` is standard input
    #[arg(value_name = "IN.cls")]
    pub(crate) input: PathBuf,
    /// Program to compare with it; `-` is standard input
    #[arg(value_name = "OUT.nc")]
    pub(crate) program: PathBuf,
    /// Messages as JSON, and the figures as an object on standard output
    #[arg(long)]
    pub(crate) json: bool,
    #[command(flatten)]
    pub(crate) set_up: SetUpArgs,
}

impl CheckArgs {
    /// How messages are written.
    pub(crate) fn format(&self) -> MessageFormat {
        if self.json { MessageFormat::Json } else { self.set_up.message_format }
    }
}

/// Arguments of `explain-block`.
#[derive(Debug, Args)]
pub(crate) struct ExplainBlockArgs {
    /// CL data; `-` is standard input
    #[arg(value_name = "IN.cls")]
    pub(crate) input: PathBuf,
    /// The block: `N1230` by its number, `57` by its line in the program
    #[arg(value_name = "BLOCK", value_parser = block_name)]
    pub(crate) block: BlockName,
    #[command(flatten)]
    pub(crate) set_up: SetUpArgs,
}

/// How CL data becomes a program: what posting and checking have to agree on.
#[derive(Debug, Args)]
pub(crate) struct SetUpArgs {
    /// Control that will run the program
    #[arg(long, value_name = "NAME", value_parser = control_names(), default_value = control_name(CONTROLS[0]))]
    control: String,
    /// Configuration of machine and set-up (see `config`)
    #[arg(long, value_name = "FILE.toml")]
    pub(crate) config: Option<PathBuf>,
    /// Unit of the CL data where it does not say so itself
    #[arg(long, value_enum)]
    pub(crate) units: Option<UnitsName>,
    /// Unit of the program; without it that of the CL data
    #[arg(long, value_enum)]
    pub(crate) output_units: Option<UnitsName>,
    /// How far arcs and chords may leave the arcs and curves of the CL data, and the tip its line while a rotary axis moves, mm
    #[arg(long, value_name = "MM", value_parser = tolerance)]
    pub(crate) tolerance: Option<f64>,
    /// How far the tool axis may leave its even turn from one point to the next, degrees
    #[arg(long, value_name = "DEG", value_parser = axis_tolerance)]
    axis_tolerance_path: Option<f64>,
    /// LINTOL of the CL data may be wider than the tolerance
    #[arg(long)]
    allow_lintol: bool,
    /// CAM system that wrote the CL data where it does not tell, or tells wrongly
    #[arg(long, value_enum)]
    dialect: Option<DialectName>,
    /// Columns of a line that count
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(8..=4096))]
    columns: Option<u32>,
    /// Pass this word of the CL data over; may be repeated
    #[arg(long, value_name = "WORD", value_parser = inert)]
    pub(crate) inert: Vec<String>,
    /// What to do with a frame that differs from the first
    #[arg(long, value_enum)]
    frames: Option<FramesName>,
    /// Sense of every CIRCLE about its axis, whatever its form says
    #[arg(long, value_enum)]
    circle_sense: Option<SenseName>,
    /// What to do with INSERT
    #[arg(long, value_enum)]
    insert: Option<InsertName>,
    /// Write INSERT as NC text that nobody checks
    #[arg(long, conflicts_with = "insert")]
    allow_insert: bool,
    /// Write FROM as the first approach
    #[arg(long, value_enum)]
    pub(crate) from: Option<FromName>,
    /// Branch on which operations begin where they can
    #[arg(long, value_enum)]
    start_branch: Option<BranchName>,
    /// Side of zero on which operations begin where they can: `B+`
    #[arg(long, value_name = "AXIS±", allow_hyphen_values = true)]
    prefer: Option<String>,
    /// Choose branch and turns motion by motion, without a view ahead
    #[arg(long)]
    greedy: bool,
    /// Angle to the pole within which the tool axis is put there, degrees
    #[arg(long, value_name = "DEGREES", value_parser = pole_tolerance)]
    pub(crate) axis_tolerance: Option<f64>,
    /// What the words of a motion say: axis values, tip coordinates, or coordinates in a tilted plane
    #[arg(long, value_name = "MODE", value_parser = PossibleValuesParser::new(Mode::NAMES.map(|(name, _)| name)))]
    mode: Option<String>,
    /// Dry run: move every point out along the tool axis by so many mm, with the spindle off
    #[arg(long, value_name = "MM", value_parser = lift)]
    pub(crate) lift: Option<f64>,
    /// Post these operations only: `3..5`, `3..` or `3`
    #[arg(long, value_name = "M..N", value_parser = operations)]
    pub(crate) ops: Option<Operations>,
    /// Post from this operation on
    #[arg(long, value_name = "NAME", conflicts_with = "ops")]
    from_op: Option<String>,
    /// Number the blocks
    #[arg(long)]
    pub(crate) line_numbers: bool,
    /// How messages are written
    #[arg(long, value_enum, default_value_t)]
    pub(crate) message_format: MessageFormat,
}

impl SetUpArgs {
    /// The control that was asked for.
    pub(crate) fn control(&self) -> &'static dyn Control {
        named(&self.control)
    }

    /// Puts the arguments on top of the configuration file.
    ///
    /// # Errors
    /// A sentence about an argument that does not fit the machine.
    pub(crate) fn apply(&self, machine: &dyn AnyMachine, config: &mut Config) -> Result<(), String> {
        if let Some(units) = self.units {
            config.cl_units = Some(units.into());
            config.given.insert("cl_units");
        }
        if let Some(units) = self.output_units {
            config.output_units = Some(units.into());
            config.given.insert("output_units");
        }
        if let Some(tolerance) = self.tolerance {
            config.motion.tolerance_mm = tolerance;
            config.given.insert("tolerance");
        }
        if let Some(tolerance) = self.axis_tolerance_path {
            config.motion.axis_tolerance_path_rad = tolerance.to_radians();
            config.given.insert("axis_tolerance_path");
        }
        config.motion.allow_lintol |= self.allow_lintol;
        config.motion.course.start_branch = self.start_branch.map(Into::into).or(config.motion.course.start_branch);
        if let Some(text) = &self.prefer {
            let help = || {
                format!(
                    "--prefer {text} is not known here: {}",
                    CourseOptions::preferences(machine.name(), machine.axes())
                )
            };
            config.motion.course.prefer = Some(CourseOptions::preference(machine.axes(), text).ok_or_else(help)?);
        }
        config.motion.operations = self.from_op.clone().map(Operations::From).or_else(|| self.ops.clone());
        let named = |mode: &String| Mode::NAMES.iter().find(|(name, _)| name == mode).map(|(_, mode)| *mode);
        if let Some(mode) = self.mode.as_ref().and_then(named) {
            config.motion.mode = mode;
            config.given.insert("mode");
        }
        config.motion.lift_mm = self.lift.or(config.motion.lift_mm);
        config.motion.course.greedy |= self.greedy;
        config.motion.course.axis_tolerance_rad =
            self.axis_tolerance.unwrap_or(config.motion.course.axis_tolerance_rad);
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

/// Parses the command line; the command goes by the name of its file.
pub(crate) fn parse(machine: &str, args: &[OsString]) -> Result<Cli, clap::Error> {
    let stem =
        args.first().and_then(|name| Path::new(name).file_stem()).map(|stem| stem.to_string_lossy().into_owned());
    let name = stem.unwrap_or_else(|| machine.to_owned());
    let about = format!("Postprocessor for {machine}: turns CL data (APT/CLS) into a program for this machine");
    let command = Cli::command().bin_name(&name).display_name(name).about(about);
    Cli::from_arg_matches(&command.try_get_matches_from(args)?)
}
