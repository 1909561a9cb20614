//! What a job may set about its control, and what of a job the control reads.

use std::collections::BTreeMap;

use crate::motion::{self, PathNorm, Policy};
use crate::nc::Formats;
use crate::set_up::SetUp;

/// What a job asks of a control: everything that encoding and the fit of the two may read.
#[derive(Debug, Clone, Copy)]
pub struct Demands<'a> {
    /// Machine, part and shop.
    pub set_up: &'a SetUp,
    /// How motion is planned.
    pub motion: &'a motion::Options,
    /// What differs from the table of the control.
    pub options: &'a Options,
    /// Digits of the words.
    pub formats: &'a Formats,
}

impl<'a> Demands<'a> {
    /// What of it the planner reads.
    #[must_use]
    pub fn policy(self) -> Policy<'a> {
        Policy { set_up: self.set_up, options: self.motion, formats: self.formats }
    }
}

/// What differs from the table of the control.
#[derive(Debug, Clone, PartialEq)]
pub struct Options {
    /// Number of the program; default 1.
    pub program_number: Option<u32>,
    /// Name of the program; default that of the CL data.
    pub program_name: Option<String>,
    /// The program begins with the name of its file; default false.
    pub file_header: bool,
    /// Safety blocks of a restart point; default those of the control.
    pub safety: Option<Vec<String>>,
    /// Blocks of a tool change; default those of the control.
    pub tool_change: Option<Vec<String>>,
    /// The tool after the next is called up; default as usual on the control.
    pub preselect: Option<bool>,
    /// Codes of flood, mist, coolant through the spindle and air, on and off; default those of the control.
    pub coolant: [Option<[String; 2]>; 4],
    /// Smoothing; default none.
    pub smoothing: Smoothing,
    /// Largest turn of the tool axis while the control smooths, rad; default none.
    pub smoothing_angle: Option<f64>,
    /// What F counts along; default as the control does.
    pub path_norm: Option<PathNorm>,
    /// Whole numbers end with a point; default as usual on the control.
    pub point: Option<bool>,
    /// Codes that switch tip control on and off; default those of the control.
    pub tip_control: Option<[String; 2]>,
    /// Name of the swivel data of CYCLE800; default none: there is only one.
    pub swivel_data: Option<String>,
    /// All axes of a rapid arrive together, as in a feed motion; default as usual on the control.
    pub linear_rapids: Option<bool>,
    /// Every word in every block; default false.
    pub every_word: bool,
    /// Names of axes on the control; default their letters.
    pub axes: BTreeMap<char, String>,
    /// How far the control may leave the programmed path where it blends blocks, mm; 0.01.
    pub path_tolerance: f64,
    /// Blocks around the program.
    pub program: ProgramBlocks,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            program_number: None,
            program_name: None,
            file_header: false,
            safety: None,
            tool_change: None,
            preselect: None,
            coolant: [const { None }; 4],
            smoothing: Smoothing::None,
            smoothing_angle: None,
            path_norm: None,
            point: None,
            tip_control: None,
            swivel_data: None,
            linear_rapids: None,
            every_word: false,
            axes: BTreeMap::new(),
            path_tolerance: 0.01,
            program: ProgramBlocks::default(),
        }
    }
}

/// Blocks around the program.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct ProgramBlocks {
    /// Blocks written after the header; default none.
    pub start: Vec<String>,
    /// Blocks written before the end code; default none.
    pub end: Vec<String>,
    /// Step of the block numbers; default none: no numbers.
    pub line_numbers: Option<u32>,
    /// Machining times as comments at the end; default false.
    pub times: bool,
    /// What the check of the program has found as a comment at the end; default false.
    pub checked: bool,
}

/// How much the control smooths the path.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Smoothing {
    /// Not by the program.
    #[default]
    None,
    /// Speed first.
    Rough,
    /// Between the two.
    Medium,
    /// Surface first.
    Finish,
}
