//! The words of the command line.

use std::ffi::OsString;
use std::path::{Path, PathBuf};

use clap::builder::PossibleValuesParser;
use clap::{Args, CommandFactory, FromArgMatches, Parser, Subcommand, ValueEnum};

use crate::config::{Config, Units};
use crate::control::{self, CONTROLS, Control};

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
    Post(PostArgs),
    /// Print a configuration file that holds every default
    Config,
    /// Print how the kinematics of this machine were derived, and a jog sheet
    Explain(ExplainArgs),
}

/// Arguments of `explain`.
#[derive(Debug, Args)]
pub(super) struct ExplainArgs {
    /// Write a LaTeX document instead of text
    #[arg(long)]
    pub(super) latex: bool,
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
    /// Number the blocks
    #[arg(long)]
    pub(super) line_numbers: bool,
    /// How messages are written
    #[arg(long, value_enum, default_value_t)]
    pub(super) message_format: MessageFormat,
}

impl PostArgs {
    /// The control that was asked for; the parser lets no other name pass.
    pub(super) fn control(&self) -> &'static dyn Control {
        control::by_name(&self.control).unwrap_or(CONTROLS[0])
    }

    /// Puts what the command line says on top of what the configuration file says.
    pub(super) fn apply(&self, config: &mut Config) {
        if let Some(units) = self.units {
            config.cl_units = Some(units.into());
            config.given.insert("cl_units");
        }
        if let Some(units) = self.output_units {
            config.output_units = Some(units.into());
            config.given.insert("output_units");
        }
        if self.line_numbers {
            config.program.line_numbers.get_or_insert(Config::LINE_NUMBER_STEP);
            config.given.insert("program.line_numbers");
        }
    }
}

fn control_name(control: &dyn Control) -> &'static str {
    control.spellings().name
}

fn control_names() -> PossibleValuesParser {
    PossibleValuesParser::new(CONTROLS.iter().map(|control| control_name(*control)))
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
