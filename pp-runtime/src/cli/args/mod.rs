//! Commands, arguments and options of the command line, with their help texts.

mod values;

use std::ffi::OsString;
use std::num::NonZeroU8;
use std::path::{Path, PathBuf};
use std::thread;

use clap::builder::PossibleValuesParser;
use clap::{Args, CommandFactory, FromArgMatches, Parser, Subcommand};
use clap_complete::Shell;

use crate::cl::Insert;
use crate::config::Config;
use crate::control::{BlockNumbers, Control};
use crate::kinematics::AnyMachine;
use crate::options::{CourseOptions, Mode, Operations};
use crate::transformation::SheetControl;

use super::text_file::read_text;

pub(crate) use values::{BlockName, MessageFormat, ReportFile};
use values::{
    BranchName, ChosenControl, ControlNames, DialectName, FramesName, FromName, InsertName, SenseName, UnitsName,
    axis_tolerance, block_name, file_name, inert, lift, operations, point, pole_tolerance, report_file, tolerance,
};
#[cfg(feature = "simulate")]
use values::{deviation, pitch};

/// Command line of a machine's postprocessor.
#[derive(Debug, Parser)]
#[command(version, disable_help_subcommand = true)]
pub(crate) struct Cli {
    #[command(subcommand)]
    pub(crate) command: Command,
}

/// The command.
#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Post CL data: write the NC program for this machine and check it
    Post(Box<PostArgs>),
    /// Compare a program with its CL data: path, feed, modal state and safe sequences
    Check(Box<CheckArgs>),
    /// Write a page that shows a program: path, machine in motion, plots, text and findings
    View(Box<ViewArgs>),
    /// Write a set-up sheet: part on the table, tools, work offsets, travel, times and checks
    Report(Box<ReportArgs>),
    /// Cut a stock with the program: rapids, shank and holder against the stock, volume removed
    #[cfg(feature = "simulate")]
    Simulate(Box<SimulateArgs>),
    /// Explain a block of the program: its CL record, why it was written, and the position of the machine after it
    ExplainBlock(Box<ExplainBlockArgs>),
    /// Print a configuration file with all keys and their defaults
    Config(ConfigArgs),
    /// Print the derivation of the kinematics of this machine, and a jog sheet
    Explain(ExplainArgs),
    /// Write the kinematics of this machine for its control, as C, or as a sheet to compare with the control's
    /// parameters
    Kinematics(KinematicsArgs),
    /// Make a folder with the postprocessor of another machine: declaration, configuration, sample and tests
    New(NewArgs),
    /// Print the completions of a shell for this command line
    Completions(CompletionsArgs),
    /// Print the manual page of this command line, for `man`
    Man(ManArgs),
}

/// Arguments of `new`.
#[derive(Debug, Args)]
pub(crate) struct NewArgs {
    /// Folder to make; its name is that of the postprocessor
    #[arg(value_name = "FOLDER")]
    pub(crate) folder: PathBuf,
    /// Folder `pp-runtime` of a checkout on which the postprocessor depends. Without it the checkout from which this
    /// binary was built, or the version of this binary from the registry
    #[arg(long, value_name = "DIR")]
    pub(crate) pp_runtime: Option<PathBuf>,
}

/// Arguments of `completions`.
#[derive(Debug, Args)]
pub(crate) struct CompletionsArgs {
    /// Shell that reads them
    #[arg(value_name = "SHELL")]
    pub(crate) shell: Shell,
}

/// Arguments of `man`.
#[derive(Debug, Args)]
pub(crate) struct ManArgs {
    /// Write the pages of all commands into this folder, instead of the page of the whole
    #[arg(short, long, value_name = "FOLDER")]
    pub(crate) output: Option<PathBuf>,
}

/// Arguments of `kinematics`.
#[derive(Debug, Args)]
#[command(group = clap::ArgGroup::new("target").required(true))]
pub(crate) struct KinematicsArgs {
    /// Forward and inverse kinematics as a C99 header; the name of the file is the prefix of all names in it
    #[arg(long, group = "target")]
    c: bool,
    /// A kinematics module of LinuxCNC, with a simulated machine that runs it
    #[arg(long, group = "target", requires = "output")]
    linuxcnc: bool,
    /// Compare sheet: expected pins and INI lines of LinuxCNC's own module for the machine, where it brings one, next
    /// to blanks
    #[arg(long, group = "target")]
    linuxcnc_own: bool,
    /// Compare sheet: expected swivel data and machine data of CYCLE800 and TRAORI, next to blanks for those of the
    /// machine
    #[arg(long, group = "target")]
    siemens: bool,
    /// Compare sheet: expected parameters 19666 to 19714 of five-axis machining, next to blanks
    #[arg(long, group = "target")]
    fanuc: bool,
    /// Compare sheet: expected steps of the kinematics description, next to blanks
    #[arg(long, group = "target")]
    heidenhain: bool,
    /// Compare sheet: expected settings of the rotary zero point, next to blanks
    #[arg(long, group = "target")]
    haas: bool,
    /// File to write, with --linuxcnc a new folder; `-` or without it standard output
    #[arg(short, long, value_name = "OUT")]
    pub(crate) output: Option<PathBuf>,
    /// Configuration file of machine and set-up (see `config`): dimensions, travel, speeds, tools, zero position
    #[arg(long, value_name = "FILE.toml")]
    pub(crate) config: Option<PathBuf>,
}

/// What `kinematics` writes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Target {
    C,
    LinuxCnc,
    Sheet(SheetControl),
}

impl KinematicsArgs {
    pub(crate) fn target(&self) -> Target {
        let Self { c: _, linuxcnc, linuxcnc_own, siemens, fanuc, heidenhain, haas, output: _, config: _ } = *self;
        let sheets = [
            (siemens, SheetControl::Siemens),
            (fanuc, SheetControl::Fanuc),
            (heidenhain, SheetControl::Heidenhain),
            (haas, SheetControl::Haas),
            (linuxcnc_own, SheetControl::LinuxCnc),
        ];
        match sheets.into_iter().find(|(given, _)| *given) {
            Some((_, control)) => Target::Sheet(control),
            None if linuxcnc => Target::LinuxCnc,
            None => Target::C,
        }
    }
}

/// Arguments of `config`.
#[derive(Debug, Args)]
pub(crate) struct ConfigArgs {
    /// Print the JSON schema of the configuration file instead, for editors
    #[arg(long)]
    pub(crate) schema: bool,
    /// Control whose defaults are printed
    #[arg(long, value_name = "NAME", value_parser = ControlNames::with(&[]), default_value = ControlNames::with(&[]).default_name())]
    control: ChosenControl,
}

impl ConfigArgs {
    /// The control of `--control`.
    pub(crate) fn control(&self) -> &'static dyn Control {
        self.control.0
    }
}

/// Arguments of `explain`.
#[derive(Debug, Args)]
pub(crate) struct ExplainArgs {
    /// Print the derivation as a LaTeX document
    #[arg(long, conflicts_with = "cl")]
    pub(crate) latex: bool,
    /// Print the formulas as `verify` blocks instead, as they are written in a declaration
    #[arg(long, conflicts_with_all = ["latex", "cl", "codes", "proof_program"])]
    pub(crate) verify: bool,
    /// Print the list of all words of CL data instead: read, ignored (inert) or refused
    #[arg(long)]
    pub(crate) cl: bool,
    /// Print the codes of `--control` instead that the check reads: meaning, states read and changed, axes moved, words
    /// that the code takes (those without brackets are needed), group of which a block has one code, source
    #[arg(long, conflicts_with_all = ["latex", "cl", "proof_program"])]
    pub(crate) codes: bool,
    /// Print the states of `--control` instead that change the meaning of words: what a program before, a screen, the
    /// operator or the machine builder may have left, and whether the word has it, the program sets it, a guard
    /// compares it, or the header states it
    #[arg(long, conflicts_with_all = ["latex", "cl", "codes", "verify", "proof_program", "drawing"])]
    pub(crate) states: bool,
    /// Print a proof program for the machine instead: the tip stays on one point while each rotary axis runs its
    /// travel. With axis positions it shows the declaration; with `mode = "tcp"` in the configuration, the data of the
    /// control
    #[arg(long, conflicts_with_all = ["latex", "cl"], group = "of_configuration")]
    pub(crate) proof_program: bool,
    /// Print a drawing instead, SVG: the machine at zero from two sides, with its dimensions, and which way the
    /// positive words rotate it
    #[arg(long, conflicts_with_all = ["latex", "cl", "codes", "verify", "proof_program"], group = "of_configuration")]
    pub(crate) drawing: bool,
    #[command(flatten)]
    pub(crate) proof: ProofArgs,
}

/// Arguments of `explain --proof-program`.
#[derive(Debug, Args)]
pub(crate) struct ProofArgs {
    /// Control that will run the proof program, or whose codes are printed
    #[arg(long, value_name = "NAME", value_parser = ControlNames::with(&[]), default_value = ControlNames::with(&[]).default_name())]
    control: ChosenControl,
    /// Configuration file of machine and set-up (see `config`)
    #[arg(long, value_name = "FILE.toml", requires = "of_configuration")]
    pub(crate) config: Option<PathBuf>,
    /// Point of the part at which the tip is held, mm; without it the part zero
    #[arg(
        long = "point",
        value_name = "X,Y,Z",
        requires = "proof_program",
        value_parser = point,
        allow_hyphen_values = true
    )]
    pub(crate) point_mm: Option<[f64; 3]>,
    /// Tool number in the spindle; without it that of the configuration, else 1
    #[arg(long, value_name = "N", requires = "proof_program", value_parser = clap::value_parser!(u32).range(1..=99_999))]
    pub(crate) tool: Option<u32>,
}

impl ProofArgs {
    /// The control of `--control`.
    pub(crate) fn control(&self) -> &'static dyn Control {
        self.control.0
    }
}

/// Arguments of `post`.
#[derive(Debug, Args)]
pub(crate) struct PostArgs {
    /// CL file; `-` is standard input
    #[arg(value_name = "IN.cls")]
    pub(crate) input: PathBuf,
    /// NC program to write; `-` is standard output
    #[arg(short, long, value_name = "OUT", default_value = "-")]
    pub(crate) output: PathBuf,
    /// Also write a map: for each line of the program its CL record, its reason, and the machine position after it
    #[arg(long, value_name = "FILE.json", value_parser = file_name)]
    pub(crate) map: Option<PathBuf>,
    /// Also write a page that shows the program, as `view` does
    #[arg(long, value_name = "OUT.html", value_parser = file_name)]
    pub(crate) view: Option<PathBuf>,
    /// Do not check the program against the CL data
    #[arg(long)]
    pub(crate) no_check: bool,
    /// Simulate the program on the machine, as `simulate` does; the options of `simulate` need this one
    #[cfg(feature = "simulate")]
    #[arg(long)]
    pub(crate) simulate: bool,
    #[cfg(feature = "simulate")]
    #[command(flatten)]
    pub(crate) simulation: SimulationArgs,
    #[command(flatten)]
    pub(crate) set_up: SetUpArgs,
}

impl PostArgs {
    /// Input files besides CL data and configuration.
    pub(crate) fn files_read(&self) -> Vec<NamedFile<'_>> {
        #[cfg(feature = "simulate")]
        let files = self.simulation.files_read();
        #[cfg(not(feature = "simulate"))]
        let files = Vec::new();
        files
    }

    /// Output files besides the program.
    pub(crate) fn files_written(&self) -> Vec<NamedFile<'_>> {
        let files = [(&self.map, "map"), (&self.view, "page")];
        #[cfg(feature = "simulate")]
        let files = files.into_iter().chain([self.simulation.file_written()]);
        given(files)
    }
}

/// A file with what it holds.
pub(crate) type NamedFile<'a> = (&'a Path, &'static str);

/// The files that are given.
fn given<'a>(files: impl IntoIterator<Item = (&'a Option<PathBuf>, &'static str)>) -> Vec<NamedFile<'a>> {
    files.into_iter().filter_map(|(path, what)| Some((path.as_deref()?, what))).collect()
}

/// Arguments of `check`.
#[derive(Debug, Args)]
pub(crate) struct CheckArgs {
    /// CL file; `-` is standard input
    #[arg(value_name = "IN.cls")]
    pub(crate) input: PathBuf,
    /// NC program to check; `-` is standard input
    #[arg(value_name = "OUT.nc")]
    pub(crate) program: PathBuf,
    /// Permitted edits of the program: a file with `[[check.edits]]`, in addition to those of the configuration
    #[arg(long, value_name = "FILE.toml", value_parser = file_name)]
    pub(crate) edits: Option<PathBuf>,
    /// Write messages as JSON, and the figures of the check as a JSON object to standard output
    #[arg(long)]
    pub(crate) json: bool,
    #[command(flatten)]
    pub(crate) set_up: SetUpArgs,
}

impl CheckArgs {
    /// Format of the messages.
    pub(crate) fn format(&self) -> MessageFormat {
        if self.json { MessageFormat::Json } else { self.set_up.message_format }
    }
}

/// Arguments of `view`.
#[derive(Debug, Args)]
pub(crate) struct ViewArgs {
    /// CL file; `-` is standard input
    #[arg(value_name = "IN.cls")]
    pub(crate) input: PathBuf,
    /// NC program to show, posted earlier or edited; without it the CL data is posted
    #[arg(value_name = "OUT.nc", value_parser = file_name)]
    pub(crate) program: Option<PathBuf>,
    /// Page to write; `-` is standard output; without it IN.html next to the CL file
    #[arg(short, long, value_name = "OUT.html")]
    pub(crate) output: Option<PathBuf>,
    /// Draw the path in three views and the axes over time; the page is written only with -o
    #[arg(long, value_name = "FILE.svg", value_parser = file_name)]
    pub(crate) svg: Option<PathBuf>,
    /// Open the page in the browser
    #[arg(long)]
    pub(crate) open: bool,
    #[command(flatten)]
    pub(crate) set_up: SetUpArgs,
}

/// Arguments of `report`.
#[derive(Debug, Args)]
pub(crate) struct ReportArgs {
    /// CL file; `-` is standard input
    #[arg(value_name = "IN.cls")]
    pub(crate) input: PathBuf,
    /// Sheet to write, as HTML, Markdown or JSON by its extension
    #[arg(short, long, value_name = "OUT.{html,md,json}", value_parser = report_file)]
    pub(crate) output: ReportFile,
    /// Add the jog sheet: in which direction each axis must move
    #[arg(long)]
    pub(crate) jog: bool,
    #[command(flatten)]
    pub(crate) set_up: SetUpArgs,
}

/// Arguments of `simulate`.
#[cfg(feature = "simulate")]
#[derive(Debug, Args)]
pub(crate) struct SimulateArgs {
    /// CL file; `-` is standard input
    #[arg(value_name = "IN.cls")]
    pub(crate) input: PathBuf,
    /// NC program to simulate, posted earlier or edited; without it the CL data is posted
    #[arg(value_name = "OUT.nc")]
    pub(crate) program: Option<PathBuf>,
    /// Write a page with machined stock, machine, tool path and findings to this file
    #[arg(short, long, value_name = "REPORT.html", value_parser = file_name)]
    pub(crate) output: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) simulation: SimulationArgs,
    /// Write messages as JSON, and findings and volumes as a JSON object to standard output
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    pub(crate) set_up: SetUpArgs,
}

/// Bodies and tolerances of a simulation.
#[cfg(feature = "simulate")]
#[derive(Debug, Args)]
pub(crate) struct SimulationArgs {
    /// Stock as a closed STL file, mm, in the coordinates of the CL data; without it that of `[solids]`, or the box of
    /// `[stock]`
    #[arg(long, value_name = "S.stl", value_parser = file_name)]
    pub(crate) stock: Option<PathBuf>,
    /// Tool table of the machine: its lengths count in the simulation. LinuxCNC tool.tbl, Heidenhain TOOL.T, or G10
    /// lines
    #[arg(long, value_name = "FILE", value_parser = file_name)]
    pub(crate) tool_table: Option<PathBuf>,
    /// Save the machined stock as an STL file, in the coordinates of the CL data: the stock of the next program
    #[arg(long, value_name = "FILE.stl", value_parser = file_name)]
    pub(crate) save_stock: Option<PathBuf>,
    /// Distance of the lines of the stock, mm: nothing thinner is seen. Without it chosen from the size of the stock
    #[arg(long = "pitch", value_name = "MM", value_parser = pitch)]
    pub(crate) pitch_mm: Option<f64>,
    /// Design as a closed STL file, mm, in the coordinates of the CL data: gouges and rest material are measured from
    /// it. Without it that of `[solids]`
    #[arg(long, value_name = "D.stl", value_parser = file_name)]
    pub(crate) design: Option<PathBuf>,
    /// Largest gouge that is no finding, mm. Without it the tolerance of the CL data
    #[arg(long = "gouge-tolerance", value_name = "MM", value_parser = deviation)]
    pub(crate) gouge_tolerance_mm: Option<f64>,
    /// Largest rest material that is no finding, mm. Without it the tolerance of the CL data
    #[arg(long = "rest-tolerance", value_name = "MM", value_parser = deviation)]
    pub(crate) rest_tolerance_mm: Option<f64>,
    /// Tolerance with which the triangles of the design were made, mm: it is added to the other two. Without it that of
    /// `[solids]`, else 0
    #[arg(long = "design-tolerance", value_name = "MM", value_parser = deviation)]
    pub(crate) design_tolerance_mm: Option<f64>,
    /// Exit status 1 for findings of these kinds, separated by commas: `collision`, `gouge`
    #[arg(long, value_name = "KINDS", value_delimiter = ',', value_parser = ["collision", "gouge"])]
    fail_on: Vec<String>,
}

#[cfg(feature = "simulate")]
impl SimulateArgs {
    /// Input files besides CL data and configuration.
    pub(crate) fn files_read(&self) -> Vec<NamedFile<'_>> {
        let mut files = self.simulation.files_read();
        files.extend(given([(&self.program, "program")]));
        files
    }

    /// Output files.
    pub(crate) fn files_written(&self) -> Vec<NamedFile<'_>> {
        given([self.simulation.file_written(), (&self.output, "page")])
    }

    /// Format of the messages.
    pub(crate) fn format(&self) -> MessageFormat {
        if self.json { MessageFormat::Json } else { self.set_up.message_format }
    }
}

#[cfg(feature = "simulate")]
impl SimulationArgs {
    /// The first of the options that is given.
    pub(crate) fn given(&self) -> Option<&'static str> {
        let options = [
            ("--stock", self.stock.is_some()),
            ("--save-stock", self.save_stock.is_some()),
            ("--tool-table", self.tool_table.is_some()),
            ("--pitch", self.pitch_mm.is_some()),
            ("--design", self.design.is_some()),
            ("--gouge-tolerance", self.gouge_tolerance_mm.is_some()),
            ("--rest-tolerance", self.rest_tolerance_mm.is_some()),
            ("--design-tolerance", self.design_tolerance_mm.is_some()),
            ("--fail-on", !self.fail_on.is_empty()),
        ];
        options.into_iter().find(|(_, given)| *given).map(|(name, _)| name)
    }

    /// Input files besides CL data, configuration and program.
    fn files_read(&self) -> Vec<NamedFile<'_>> {
        given([(&self.stock, "stock"), (&self.design, "design"), (&self.tool_table, "tool table")])
    }

    /// The output file, which may be given.
    fn file_written(&self) -> (&Option<PathBuf>, &'static str) {
        (&self.save_stock, "machined stock")
    }

    /// Whether a gouge is exit status 1.
    pub(crate) fn fails_on_gouge(&self) -> bool {
        self.fail_on.iter().any(|kind| kind == "gouge")
    }

    /// Whether a collision is exit status 1.
    pub(crate) fn fails_on_collision(&self) -> bool {
        self.fail_on.iter().any(|kind| kind == "collision")
    }
}

/// Arguments of `explain-block`.
#[derive(Debug, Args)]
pub(crate) struct ExplainBlockArgs {
    /// CL file; `-` is standard input
    #[arg(value_name = "IN.cls")]
    pub(crate) input: PathBuf,
    /// Block to explain: `N1230` is a block number, `57` is a line of the program
    #[arg(value_name = "BLOCK", value_parser = block_name)]
    pub(crate) block: BlockName,
    #[command(flatten)]
    pub(crate) set_up: SetUpArgs,
}

/// Options that determine the program, for all commands that post or check.
#[derive(Debug, Args)]
pub(crate) struct SetUpArgs {
    /// Control that will run the program
    #[arg(long, value_name = "NAME", value_parser = ControlNames::with(&[]), default_value = ControlNames::with(&[]).default_name())]
    control: ChosenControl,
    /// Configuration file of machine and set-up (see `config`)
    #[arg(long, value_name = "FILE.toml")]
    pub(crate) config: Option<PathBuf>,
    /// Unit of the CL data if the file states none
    #[arg(long, value_enum)]
    pub(crate) units: Option<UnitsName>,
    /// Unit of the program; without it the unit of the CL data
    #[arg(long, value_enum)]
    pub(crate) output_units: Option<UnitsName>,
    /// Largest deviation from arcs and curves, and of the tip from its line while a rotary axis moves, mm
    #[arg(long = "tolerance", value_name = "MM", value_parser = tolerance)]
    pub(crate) tolerance_mm: Option<f64>,
    /// Largest deviation of the tool axis from its great circle between two points, degrees
    #[arg(long = "axis-tolerance-path", value_name = "DEG", value_parser = axis_tolerance)]
    axis_tolerance_path_rad: Option<f64>,
    /// Allow LINTOL of the CL data to be wider than the tolerance
    #[arg(long)]
    allow_lintol: bool,
    /// CAM system that wrote the CL data, if it is not recognised from the file or not correctly
    #[arg(long, value_enum)]
    dialect: Option<DialectName>,
    /// Number of columns of a CL line that are read; the rest is ignored
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(8..=4096))]
    columns: Option<u32>,
    /// Ignore this word of the CL data; may be repeated
    #[arg(long, value_name = "WORD", value_parser = inert)]
    pub(crate) inert: Vec<String>,
    /// Where the points after a coordinate frame are that differs from the first
    #[arg(long, value_enum)]
    frames: Option<FramesName>,
    /// Sense of every CIRCLE about its axis, instead of the sense found from its form
    #[arg(long, value_enum)]
    circle_sense: Option<SenseName>,
    /// Treatment of INSERT
    #[arg(long, value_enum)]
    insert: Option<InsertName>,
    /// Write the text of INSERT to the program without checking it
    #[arg(long, conflicts_with = "insert")]
    allow_insert: bool,
    /// Treatment of FROM
    #[arg(long, value_enum)]
    pub(crate) from: Option<FromName>,
    /// Preferred branch of the inverse kinematics at the start of operations
    #[arg(long, value_enum)]
    start_branch: Option<BranchName>,
    /// Preferred sign of a rotary axis at the start of operations: `B+`
    #[arg(long, value_name = "AXIS±", allow_hyphen_values = true)]
    prefer: Option<String>,
    /// Choose branch and turns of the rotary axes motion by motion, not for the whole program
    #[arg(long)]
    greedy: bool,
    /// Angle to the pole within which the tool axis is set to the pole, degrees
    #[arg(long = "axis-tolerance", value_name = "DEGREES", value_parser = pole_tolerance)]
    pub(crate) pole_tolerance_rad: Option<f64>,
    /// Coordinates of the program: axis positions, tip coordinates under tip control, or coordinates in a tilted plane
    #[arg(long, value_name = "MODE", value_parser = PossibleValuesParser::new(Mode::NAMES.map(|(name, _)| name)))]
    mode: Option<String>,
    /// Dry run: move every point out along the tool axis by this distance, spindle and coolant off
    #[arg(long = "lift", value_name = "MM", value_parser = lift)]
    pub(crate) lift_mm: Option<f64>,
    /// Post only these operations: `3..5`, `3..` or `3`
    #[arg(long, value_name = "M..N", value_parser = operations)]
    pub(crate) ops: Option<Operations>,
    /// Post from the operation of this name on
    #[arg(long, value_name = "NAME", conflicts_with = "ops")]
    from_op: Option<String>,
    /// Write block numbers
    #[arg(long)]
    pub(crate) line_numbers: bool,
    /// Remove material of a simulation with N threads, and read CL data ahead in threads of its own if N is above 1.
    /// Without it, N is the number of processors
    #[arg(long, value_name = "N")]
    threads: Option<NonZeroU8>,
    /// Show no progress
    #[arg(long)]
    pub(crate) quiet: bool,
    /// Format of the messages
    #[arg(long, value_enum, default_value_t)]
    pub(crate) message_format: MessageFormat,
}

impl SetUpArgs {
    /// The control of `--control`.
    pub(crate) fn control(&self) -> &'static dyn Control {
        self.control.0
    }

    /// Number of threads that the user allows, or of processors.
    pub(crate) fn threads(&self) -> usize {
        let processors = || thread::available_parallelism().map_or(1, usize::from);
        self.threads.map_or_else(processors, |threads| threads.get().into())
    }

    /// Sets the given options in the configuration; they take precedence over the file.
    ///
    /// # Errors
    /// A sentence about an option that does not suit the machine.
    pub(crate) fn apply(&self, machine: &dyn AnyMachine, config: &mut Config) -> Result<(), String> {
        if let Some(units) = self.units {
            config.cl_units = Some(units.into());
            config.given.insert("cl_units");
            config.cl.units_confirmed = true;
        }
        if let Some(units) = self.output_units {
            config.output_units = Some(units.into());
            config.given.insert("output_units");
        }
        if let Some(tolerance_mm) = self.tolerance_mm {
            config.motion.tolerance_mm = tolerance_mm;
            config.given.insert("tolerance");
        }
        if let Some(tolerance_rad) = self.axis_tolerance_path_rad {
            config.motion.axis_tolerance_path_rad = tolerance_rad;
            config.given.insert("axis_tolerance_path");
        }
        config.motion.allow_lintol |= self.allow_lintol;
        config.motion.course.start_branch = self.start_branch.map(Into::into).or(config.motion.course.start_branch);
        if let Some(text) = &self.prefer {
            let help = || {
                format!(
                    "--prefer {text} does not suit this machine: {}",
                    CourseOptions::preferences(machine.name(), machine.axes())
                )
            };
            config.motion.course.prefer = Some(CourseOptions::preference(machine.axes(), text).ok_or_else(help)?);
        }
        config.motion.selected = self.from_op.clone().map(Operations::From).or_else(|| self.ops.clone());
        let mode_named = |mode: &String| Mode::NAMES.iter().find(|(name, _)| name == mode).map(|(_, mode)| *mode);
        if let Some(mode) = self.mode.as_ref().and_then(mode_named) {
            config.motion.mode = mode;
            config.given.insert("mode");
        }
        config.motion.lift_mm = self.lift_mm.or(config.motion.lift_mm);
        config.motion.course.greedy |= self.greedy;
        config.motion.course.axis_tolerance_rad =
            self.pole_tolerance_rad.unwrap_or(config.motion.course.axis_tolerance_rad);
        let cl = &mut config.cl;
        cl.dialect = self.dialect.map(Into::into).or(cl.dialect);
        cl.columns = self.columns.or(cl.columns);
        cl.inert.extend(self.inert.iter().cloned());
        cl.frames = self.frames.map(Into::into).or(cl.frames);
        cl.circle_sense = self.circle_sense.map(Into::into).or(cl.circle_sense);
        cl.insert = match (self.insert, self.allow_insert) {
            (_, true) => Insert::Write,
            (Some(InsertName::Comment), false) => Insert::Comment,
            (None, false) => cl.insert,
        };
        cl.from_move |= self.from.is_some();
        if self.line_numbers {
            let numbers = &mut config.control.program.line_numbers;
            if !numbers.are_on_every_block() {
                *numbers = BlockNumbers::Step(Config::LINE_NUMBER_STEP);
            }
            config.given.insert("program.line_numbers");
        }
        Ok(())
    }
}

/// The command line of a machine. Help and errors call the command by the name of its file. `own`: controls besides
/// those of this crate; the first is the default.
pub(crate) fn definition(machine: &str, own: &[&'static dyn Control], args: &[OsString]) -> clap::Command {
    let stem =
        args.first().and_then(|name| Path::new(name).file_stem()).map(|stem| stem.to_string_lossy().into_owned());
    let name = stem.unwrap_or_else(|| machine.to_owned());
    let about = format!("Postprocessor for {machine}: converts CL data (APT/CLS) into NC programs");
    let mut command = Cli::command().bin_name(&name).display_name(name).about(about);
    let names = ControlNames::with(own);
    let of_file = control_of_file(args).and_then(|name| names.find(&name));
    if !own.is_empty() || of_file.is_some() {
        let default = of_file.unwrap_or(names.default_name());
        let choice = |arg: clap::Arg| arg.value_parser(names.clone()).default_value(default);
        let takes_control = |command: &clap::Command| command.get_arguments().any(|arg| arg.get_id() == "control");
        command =
            command.mut_subcommands(
                |command| {
                    if takes_control(&command) { command.mut_arg("control", choice) } else { command }
                },
            );
    }
    command
}

/// `control.name` of the configuration that the arguments name, if it can be read; where it cannot, the command says
/// so.
fn control_of_file(args: &[OsString]) -> Option<String> {
    let of_option = |index: usize| match args[index].to_str()? {
        "--config" => args.get(index + 1).map(PathBuf::from),
        option => option.strip_prefix("--config=").map(PathBuf::from),
    };
    let path = (0..args.len()).find_map(of_option)?;
    let table: toml::Table = read_text(&path, "configuration").ok()?.parse().ok()?;
    Some(table.get("control")?.get("name")?.as_str()?.to_owned())
}

/// Parses the arguments of a command line.
pub(crate) fn parse(definition: clap::Command, args: &[OsString]) -> Result<Cli, clap::Error> {
    Cli::from_arg_matches(&definition.try_get_matches_from(args)?)
}
