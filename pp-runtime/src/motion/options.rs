//! What a job may set about planning: which words, how exact, how fast, how to get to and away from the part.
//!
//! Plain data in mm, rad and mm/min; nothing here plans. [`Policy`] is everything of a job that planning may read.

mod cutting;
mod links;
mod words;

use std::collections::BTreeMap;

use crate::kinematics::Branch;
use crate::nc::Formats;
use crate::set_up::SetUp;

pub use cutting::{
    ArcForm, ArcOptions, ArcOutput, CutterPath, CycleOptions, CycleOutput, Defaults, FeedLimits, PathNorm,
};
pub use links::{Approach, Rapid, RapidOptions, Retract, Rewind, Transition};
pub use words::{ClampCodes, Mode, RotaryOptions, TcpFrame, TcpWords, TipOptions, ToolPosture, Wrap};

/// Everything of a job that planning may read.
#[derive(Debug, Clone, Copy)]
pub struct Policy<'a> {
    /// Machine, part and shop.
    pub set_up: &'a SetUp,
    /// How motion is planned.
    pub options: &'a Options,
    /// Digits of the words.
    pub formats: &'a Formats,
}

/// How motion is planned. Lengths in mm, angles in rad, speeds in mm/min and rad/min.
#[derive(Debug, Clone, PartialEq)]
pub struct Options {
    /// What the words of a motion say; default [`Mode::Axes`].
    pub mode: Mode,
    /// Tip control, in mode `tcp`.
    pub tip: TipOptions,
    /// How branch and turns of the rotary axes are chosen.
    pub course: CourseOptions,
    /// How far arcs and chords may leave the arcs and curves of the CL data, and the tip its line while a rotary axis moves,
    /// mm; default 0.01.
    pub tolerance: f64,
    /// How far the tool axis may leave its even turn from one point to the next, rad; default 0.1 degree.
    pub axis_tolerance_path: f64,
    /// LINTOL may be wider than `tolerance`; default false.
    pub allow_lintol: bool,
    /// Arcs of the control.
    pub arcs: ArcOptions,
    /// Cycles of the control.
    pub cycles: CycleOptions,
    /// What the path under CUTCOM is; `None` (default): CUTCOM is refused.
    pub compensation: Option<CutterPath>,
    /// The operations that are posted; default all.
    pub operations: Option<Operations>,
    /// Dry run: every point lies this much further out along the tool axis, and the spindle stays off, mm; default none.
    pub lift: Option<f64>,
    /// What the CL data may leave out.
    pub defaults: Defaults,
    /// How fast blocks may run.
    pub feed: FeedLimits,
    /// How to get away from the part.
    pub retract: Retract,
    /// How to get to the part.
    pub approach: Approach,
    /// Motion between cuts.
    pub rapids: RapidOptions,
    /// Where axes go at program end, machine coordinates for linear axes, mm and rad; default none: they stay.
    pub park: BTreeMap<char, f64>,
    /// Retract before STOP and OPSTOP; default true.
    pub stop_retract: bool,
    /// Wait after the spindle starts, seconds; default 0.
    pub spindle_dwell: f64,
    /// Words and clamps of rotary axes.
    pub rotaries: RotaryOptions,
    /// What is refused or compared.
    pub guards: GuardOptions,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            mode: Mode::Axes,
            tip: TipOptions::default(),
            course: CourseOptions::default(),
            tolerance: 0.01,
            axis_tolerance_path: 0.1_f64.to_radians(),
            allow_lintol: false,
            arcs: ArcOptions::default(),
            cycles: CycleOptions::default(),
            compensation: None,
            operations: None,
            lift: None,
            defaults: Defaults::default(),
            feed: FeedLimits::default(),
            retract: Retract::default(),
            approach: Approach::default(),
            rapids: RapidOptions::default(),
            park: BTreeMap::new(),
            stop_retract: true,
            spindle_dwell: 0.0,
            rotaries: RotaryOptions::default(),
            guards: GuardOptions::default(),
        }
    }
}

/// How branch and turns of the rotary axes are chosen.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct CourseOptions {
    /// Every operation begins on this branch where it can; default none.
    pub start_branch: Option<Branch>,
    /// Every operation begins with this rotary axis at or above zero (`true`) or at or below it, where it can; default none.
    pub prefer: Option<(char, bool)>,
    /// Branch and turns are chosen motion by motion, without a view ahead; default false.
    pub greedy: bool,
    /// Within this angle of the pole the tool axis is put there, rad; default 0: within what CL data rounds.
    pub axis_tolerance: f64,
}

/// What is refused or compared.
#[derive(Debug, Clone, PartialEq)]
pub struct GuardOptions {
    /// The posted length is compared at the tool call, where the control can; default `None`: where a rotary axis in the
    /// head makes it matter.
    pub length_guard: Option<bool>,
    /// By how much the lengths may differ, mm; default 0.01.
    pub length_tolerance: f64,
    /// Largest spindle speed, rev/min; default none: unchecked.
    pub spindle_max: Option<f64>,
    /// Lowest Z of a tip of the part as it lies, `part_rotation` applied, mm; default none: unchecked.
    pub floor: Option<f64>,
    /// Refuse CL data in which every tool axis points into the table; default true.
    pub table_check: bool,
}

impl Default for GuardOptions {
    fn default() -> Self {
        Self { length_guard: None, length_tolerance: 0.01, spindle_max: None, floor: None, table_check: true }
    }
}

/// Some operations of a program, counted from 1: they begin at TOOL PATH, tool records, stops and frames, and starts with
/// no motion between them are one.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Operations {
    /// From this one to that, both included; to the last without it.
    Range(u64, Option<u64>),
    /// From the first of this name on.
    From(String),
}
