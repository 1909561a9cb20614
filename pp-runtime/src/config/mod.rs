//! The set-up of a job: everything that is true of today's part and shop rather than of the machine.
//!
//! [`Config::default`] is the one place where defaults stand; [`print()`] shows them as a file to edit and
//! [`Config::read`] reads such a file. Millimetres, radians and mm/min in here; a file states its own unit of length and
//! writes angles in degrees. Nothing here plans or writes a motion.

mod arcs;
mod axes;
mod cl;
mod clearance;
mod compensation;
mod control;
mod course;
mod cycles;
mod machine;
mod mode;
mod print;
mod read;
#[cfg(test)]
pub(crate) mod sample;
mod schema;
mod set_up;
#[cfg(test)]
mod tests;
mod value;

use std::collections::{BTreeMap, BTreeSet};

use nalgebra::Rotation3;

use crate::cl as reading;
use crate::kinematics::{Branch, Limits};
use crate::program::{Clearance, Coolant, Rotation};

pub use crate::program::Units;
pub use arcs::{ArcForm, ArcOutput, Arcs};
pub use compensation::CutterPath;
pub use control::{ControlSetup, PathNorm, Smoothing};
pub(crate) use course::{preference, preferences};
pub use cycles::{CycleOutput, Cycles};
pub use machine::Travel;
pub use mode::{Mode, TcpFrame, TcpWords, ToolPosture};
pub use print::print;
use read::WORK_OFFSETS;
pub(crate) use read::{AXIS_TOLERANCE, TOLERANCE};
pub use schema::schema;
pub(crate) use set_up::part_angles;
pub(crate) use value::{list, nearest};

/// Set-up of a job. Lengths in mm, angles in rad, speeds in mm/min and rad/min.
#[derive(Debug, Clone, PartialEq)]
pub struct Config {
    /// Unit of the CL data where it does not say so itself; `None` (default): it must say so.
    pub cl_units: Option<Units>,
    /// How the CL data is read; its unit stands in `cl_units`.
    pub cl: reading::Options,
    /// Work offsets of frames of the CL data other than the first, by number; default none.
    pub frames: BTreeMap<u32, String>,
    /// Every operation begins on this branch where it can; default none.
    pub start_branch: Option<Branch>,
    /// Every operation begins with this rotary axis at or above zero (`true`) or at or below it, where it can; default none.
    pub prefer: Option<(char, bool)>,
    /// Branch and turns are chosen motion by motion, without a view ahead; default false.
    pub greedy: bool,
    /// Within this angle of the pole the tool axis is put there, rad; default 0: within what CL data rounds.
    pub axis_tolerance: f64,
    /// How far arcs and chords may leave the arcs and curves of the CL data, and the tip its line while a rotary axis moves,
    /// mm; default 0.01.
    pub tolerance: f64,
    /// How far the tool axis may leave its even turn from one point to the next, rad; default 0.1 degree.
    pub axis_tolerance_path: f64,
    /// Arcs of the control.
    pub arcs: Arcs,
    /// Cycles of the control.
    pub cycles: Cycles,
    /// What the path under CUTCOM is; `None` (default): CUTCOM is refused.
    pub compensation: Option<CutterPath>,
    /// LINTOL may be wider than that; default false.
    pub allow_lintol: bool,
    /// Unit of the posted program; `None` (default): that of the CL data.
    pub output_units: Option<Units>,
    /// Part zero from the table's reference point along the table's directions, mm; default 0, 0, 0.
    pub part_origin: [f64; 3],
    /// Turns the CL data before anything else: how the part lies on the table; default not at all.
    pub part_rotation: Rotation3<f64>,
    /// The written word of a rotary axis is its value minus this, rad; default none.
    pub rotary_offset: BTreeMap<char, f64>,
    /// Where linear words count from; default [`ProgramZero::Part`].
    pub program_zero: ProgramZero,
    /// The operations that are posted; default all.
    pub operations: Option<Operations>,
    /// Dry run: every point lies this much further out along the tool axis, and the spindle stays off, mm; default none.
    pub lift: Option<f64>,
    /// What linear words say of the tool; default [`LengthMode::Tip`].
    pub length_mode: LengthMode,
    /// What the words of a motion say; default [`Mode::Axes`].
    pub mode: Mode,
    /// The frame of tip coordinates in mode `tcp`; default none: where a control has only one, that one.
    pub tcp_frame: Option<TcpFrame>,
    /// How blocks say where the tool axis goes in mode `tcp`; default [`TcpWords::Angles`].
    pub tcp_words: TcpWords,
    /// How the control moves the tool axis in mode `tcp`; default [`ToolPosture::Axes`].
    pub tool_posture: ToolPosture,
    /// The control knows held axes and linear axes between rotary ones in mode `tcp`; default false.
    pub tcp_confirmed: bool,
    /// Codes of the clamps of rotary axes; default none.
    pub clamp: BTreeMap<char, ClampCodes>,
    /// The posted length is compared at the tool call, where the control can; default `None`: where a rotary axis in the
    /// head makes it matter.
    pub length_guard: Option<bool>,
    /// By how much the lengths may differ, mm; default 0.01.
    pub length_tolerance: f64,
    /// The blank as it lies on the table; default none: a box around all cuts.
    pub stock: Option<Stock>,
    /// The word of the work offset; default `G54`.
    pub work_offset: String,
    /// Machine coordinate of linear axes at the zero position without tool, mm; default none: linear limits unchecked.
    pub machine_zero: BTreeMap<char, f64>,
    /// Tools by number; default none.
    pub tools: BTreeMap<u32, Tool>,
    /// What the CL data may leave out.
    pub defaults: Defaults,
    /// How fast blocks may run.
    pub feed: FeedLimits,
    /// How to get away from the part.
    pub retract: Retract,
    /// How to get to the part.
    pub approach: Approach,
    /// Where axes go at program end, machine coordinates for linear axes, mm and rad; default none: they stay.
    pub park: BTreeMap<char, f64>,
    /// Largest turn of a rotary axis in a rapid that does not go through the safe sequence, rad; default 1 degree.
    pub index_angle: f64,
    /// How rapids inside an operation are written; default [`Rapid::Direct`].
    pub rapid: Rapid,
    /// Feed of a rapid that is written as a feed motion, mm/min; default none.
    pub rapid_feed: Option<f64>,
    /// How the words of endless rotary axes stay within a turn; default none: they count turns.
    pub wrap: BTreeMap<char, Wrap>,
    /// Steps of indexed rotary axes, rad; default none: they turn continuously.
    pub grid: BTreeMap<char, f64>,
    /// How to get from one operation to the next; default [`Transition::Safe`].
    pub transition: Transition,
    /// Speed of rotary axes in moves that only turn the tool or the table, rad/min; default 1800 degrees/min.
    pub reorient_speed: f64,
    /// Retract before STOP and OPSTOP; default true.
    pub stop_retract: bool,
    /// Wait after the spindle starts, seconds; default 0.
    pub spindle_dwell: f64,
    /// How far the control may leave the programmed path where it blends blocks, mm; 0.01.
    pub path_tolerance: f64,
    /// Largest spindle speed, rev/min; default none: unchecked.
    pub spindle_max: Option<f64>,
    /// Lowest Z of a tip of the part as it lies, `part_rotation` applied, mm; default none: unchecked.
    pub floor: Option<f64>,
    /// Refuse CL data in which every tool axis points into the table; default true.
    pub table_check: bool,
    /// Dimensions of the machine that differ from its declaration, mm or rad; default none.
    pub dimensions: BTreeMap<String, f64>,
    /// Travel that differs from the machine's declaration, mm or rad, `None` for an endless axis; default none.
    pub limits: BTreeMap<char, Option<Limits>>,
    /// Largest axis speeds that differ from the machine's declaration, mm/min or rad/min; default none.
    pub speeds: BTreeMap<char, f64>,
    /// Digits of the words.
    pub formats: Formats,
    /// Blocks around the program.
    pub program: Program,
    /// How the control differs from its table.
    pub control: ControlSetup,
    /// Lengths came from a file that does not state its unit: mm assumed.
    pub file_units_assumed: bool,
    /// What was given rather than assumed: keys as they stand in a file, `part_origin`, `retract.position`.
    ///
    /// The keys of a machine's axes, dimensions and tools are not in here: their maps hold only what was given.
    pub given: BTreeSet<&'static str>,
}

/// What is known about one tool besides the CL data; everything defaults to unknown.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Tool {
    /// From gauge line to tip, mm.
    pub length: Option<f64>,
    /// Cutting diameter, mm; only compared with the CL data.
    pub diameter: Option<f64>,
    /// Length offset register (H); default: the tool's number or what the CL data says.
    pub offset: Option<u32>,
    /// Register of its radius (D); default: what CUTCOM says or the tool's number.
    pub radius_offset: Option<u32>,
    /// Spindle speed where the CL data gives none, rev/min.
    pub speed: Option<f64>,
    /// Sense of rotation where the CL data gives none.
    pub rotation: Option<Rotation>,
    /// Cuts turning counter-clockwise; default false.
    pub left_handed: bool,
    /// The kind that COOLNT/ON means for this tool.
    pub coolant: Option<Coolant>,
    /// Name for header and comments.
    pub name: Option<String>,
}

/// What the CL data may leave out.
#[derive(Debug, Clone, PartialEq)]
pub struct Defaults {
    /// Spindle speed, rev/min; default none.
    pub speed: Option<f64>,
    /// Sense of rotation; default none.
    pub rotation: Option<Rotation>,
    /// The kind that COOLNT/ON means; default [`Coolant::Flood`]. Never `On` or `Off`.
    pub coolant: Coolant,
    /// The tool of CL data that calls none before it moves; default none.
    pub tool: Option<u32>,
    /// How far above the bottom a rapid ends in a hole that is drilled in steps, mm; default 0.5.
    pub peck_gap: f64,
}

/// How fast blocks may run.
#[derive(Debug, Clone, PartialEq)]
pub struct FeedLimits {
    /// Blocks in which an axis would be faster than it can run longer; default true.
    pub keep_speeds: bool,
    /// Largest F of the control, mm/min; default none.
    pub largest: Option<f64>,
    /// Shortest time of a block, seconds; default 0.
    pub shortest_block: f64,
}

/// How to get away from the part.
#[derive(Debug, Clone, PartialEq)]
pub struct Retract {
    /// Machine coordinate of the retract axis, mm; default 0.
    pub position: f64,
    /// Distance along the tool axis, mm; default none: to the clearance geometry of the CL data.
    pub distance: Option<f64>,
    /// Geometry around the part that the tool has to leave, if no distance is given; default none.
    pub clearance: Option<Clearance>,
    /// How rotary axes are rewound in a cut; default [`Rewind::Leave`].
    pub rewind: Rewind,
    /// Coolant is off while the rotary axes are rewound; default false.
    pub rewind_dry: bool,
}

/// How rotary axes are rewound where no course runs through.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Rewind {
    /// The tool leaves the part along its axis, the rotaries turn, and it comes back.
    Leave,
    /// The linear axes follow: the tip stays in place, and the tool swings about it.
    Follow,
}

/// How to get to the part.
#[derive(Debug, Clone, PartialEq)]
pub struct Approach {
    /// Distance of the approach point from the first tip along the tool axis, mm; default 50.
    pub distance: f64,
}

/// A box around the blank, for the pictures of a control, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stock {
    /// Its lowest corner.
    pub lower: [f64; 3],
    /// Its highest corner.
    pub upper: [f64; 3],
}

/// What switches the clamp of a rotary axis.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ClampCodes {
    /// The axis is held.
    pub on: String,
    /// It may turn.
    pub off: String,
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

/// Where linear words count from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ProgramZero {
    /// The part zero.
    Part,
    /// The table's reference point.
    Table,
}

/// What linear words say of the tool.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LengthMode {
    /// Where its tip is at the zero position of the rotary axes; the length offset is active.
    Tip,
    /// Where its gauge line is; no length offset is active.
    Gauge,
}

/// How the words of a rotary axis stay within a turn; without it they show as many turns as there are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Wrap {
    /// From 0 up to 360; the control goes the short way.
    Positive,
    /// Above -180 up to 180; the control goes the short way.
    Symmetric,
    /// From 0 up to 360 with the sense of the motion as sign; a whole turn stands for a zero that is reached backwards.
    Sign,
}

/// How a rapid inside an operation is written that turns no rotary axis by more than the index angle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Rapid {
    /// In one block; its path is the control's affair.
    Direct,
    /// Along the tool axis and across it in blocks of their own: out first, in last.
    Split,
    /// As a feed motion, on a path that is certified.
    Feed,
}

/// How to get from one operation to the next.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Transition {
    /// Retract, turn, approach.
    Safe,
    /// As the CL data has it.
    Direct,
}

/// Digits of the words.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Formats {
    /// Decimals of linear words in mm; default 3.
    pub linear_mm: u32,
    /// Decimals of linear words in inches; default 4.
    pub linear_inch: u32,
    /// Decimals of rotary words in degrees; default 4.
    pub rotary: u32,
    /// Decimals of F per minute and per revolution; default 3.
    pub feed: u32,
    /// Significant digits of an inverse-time F; default 6.
    pub inverse_time: u32,
    /// Decimals of S; default 0.
    pub speed: u32,
    /// Digits of linear words before the point; default 9.
    pub linear_whole: u32,
    /// Digits of rotary words before the point; default 9.
    pub rotary_whole: u32,
    /// Digits of F before the point; default 15.
    pub feed_whole: u32,
    /// Digits of S before the point; default 9.
    pub speed_whole: u32,
}

impl Formats {
    /// Digits of a control that sets no bounds.
    pub const DEFAULT: Self = Self {
        linear_mm: 3,
        linear_inch: 4,
        rotary: 4,
        feed: 3,
        inverse_time: 6,
        speed: 0,
        linear_whole: 9,
        rotary_whole: 9,
        feed_whole: 15,
        speed_whole: 9,
    };

    /// Decimals of linear words.
    #[must_use]
    pub fn linear(&self, units: Units) -> u32 {
        match units {
            Units::Millimetres => self.linear_mm,
            Units::Inches => self.linear_inch,
        }
    }
}

/// Blocks around the program.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Program {
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

impl Default for Config {
    fn default() -> Self {
        Self {
            cl_units: None,
            cl: reading::Options::default(),
            frames: BTreeMap::new(),
            start_branch: None,
            prefer: None,
            greedy: false,
            axis_tolerance: 0.0,
            tolerance: 0.01,
            axis_tolerance_path: 0.1_f64.to_radians(),
            arcs: Arcs::default(),
            cycles: Cycles::default(),
            compensation: None,
            allow_lintol: false,
            output_units: None,
            part_origin: [0.0; 3],
            part_rotation: Rotation3::identity(),
            rotary_offset: BTreeMap::new(),
            program_zero: ProgramZero::Part,
            length_mode: LengthMode::Tip,
            mode: Mode::Axes,
            tcp_frame: None,
            tcp_words: TcpWords::Angles,
            tool_posture: ToolPosture::Axes,
            tcp_confirmed: false,
            clamp: BTreeMap::new(),
            length_guard: None,
            stock: None,
            length_tolerance: 0.01,
            operations: None,
            lift: None,
            work_offset: "G54".to_owned(),
            machine_zero: BTreeMap::new(),
            tools: BTreeMap::new(),
            defaults: Defaults { speed: None, rotation: None, coolant: Coolant::Flood, tool: None, peck_gap: 0.5 },
            feed: FeedLimits { keep_speeds: true, largest: None, shortest_block: 0.0 },
            retract: Retract {
                position: 0.0,
                distance: None,
                clearance: None,
                rewind: Rewind::Leave,
                rewind_dry: false,
            },
            approach: Approach { distance: 50.0 },
            park: BTreeMap::new(),
            index_angle: 1_f64.to_radians(),
            rapid: Rapid::Direct,
            rapid_feed: None,
            wrap: BTreeMap::new(),
            grid: BTreeMap::new(),
            transition: Transition::Safe,
            reorient_speed: 1800_f64.to_radians(),
            stop_retract: true,
            spindle_dwell: 0.0,
            path_tolerance: 0.01,
            spindle_max: None,
            floor: None,
            table_check: true,
            dimensions: BTreeMap::new(),
            limits: BTreeMap::new(),
            speeds: BTreeMap::new(),
            formats: Formats::DEFAULT,
            program: Program::default(),
            control: ControlSetup::default(),
            file_units_assumed: false,
            given: BTreeSet::new(),
        }
    }
}

impl Config {
    /// Step of the block numbers where they are asked for without one.
    pub const LINE_NUMBER_STEP: u32 = 10;

    /// Whether `key` (`retract.position`) was given rather than assumed.
    #[must_use]
    pub fn is_given(&self, key: &str) -> bool {
        self.given.contains(key)
    }
}
