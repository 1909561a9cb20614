//! Policy of a check: everything that it reads of a job, besides CL data, program and machine.
//!
//! Whoever configures a job builds it. Lengths in mm, angles in rad, feeds in mm/min and rad/min.
//!
//! ```
//! use pp_runtime::config::Config;
//! use pp_runtime::control::Haas;
//! # pp_runtime::machine! {
//! #     /// A table that rotates about Z on a table that tilts about X.
//! #     pub struct Trunnion;
//! #     chain: C A | X Y Z;
//! # }
//!
//! let config = Config::read::<Trunnion>("tolerance = 0.005\n", &Haas).expect("keys of this machine");
//! let policy = config.check_policy::<Trunnion>(&Haas, None)?;
//! assert!((policy.tolerances.path_mm - 0.005).abs() < 1e-12);
//! # Ok::<(), pp_runtime::config::NotCheckable>(())
//! ```

use std::collections::BTreeMap;

use super::read::{Effect, Family, OwnPlace, RolloverRule};
use crate::cl::ReadingOptions;
use crate::program::{Clearance, Coolants, Rotation, Units};
use crate::set_up::SetUp;

/// Meaning of the words of a program, the motion between cuts, and the tolerances of a check.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct CheckPolicy {
    /// Family of the control that runs the program.
    pub family: Family,
    /// How the CL data is read, its unit included.
    pub reading: ReadingOptions,
    /// Unit of the program; without it that of the CL data.
    pub output_units: Option<Units>,
    /// Machine, part and tools.
    pub set_up: SetUp,
    /// Meaning of the words.
    pub words: WordPolicy,
    /// Number of decimals of the words.
    pub digits: Decimals,
    /// Largest deviations.
    pub tolerances: Tolerances,
    /// Motion between cuts.
    pub links: LinkPolicy,
    /// F of feed blocks.
    pub feed: FeedPolicy,
    /// State that the CL data leaves open.
    pub defaults: StateDefaults,
    /// Operations that are in the program; all without it.
    pub selection: Option<OperationSelection>,
    /// Blocks of the shop and functions of the control in the program.
    pub shop: ShopBlocks,
    /// Rules of single operations.
    pub operations: Vec<OperationRule>,
    /// Edits of the program that are meant.
    pub edits: EditPolicy,
}

/// Edits of a program that are meant, and how far F and S may go.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct EditPolicy {
    /// The edits.
    pub edits: Vec<MeantEdit>,
    /// Largest ratio of an edited F to the posted one, where it may be larger.
    pub feed_factor: Option<f64>,
    /// Largest ratio of an edited S to the posted one, and of the posted one to it.
    pub speed_factor: Option<f64>,
}

/// An edit that is meant.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct MeantEdit {
    /// Where it is.
    pub block: EditedBlock,
    /// Text as posted; empty where something is added.
    pub old: String,
    /// Text as edited; empty where something is taken away.
    pub new: String,
    /// Why.
    pub reason: String,
}

/// A block that is edited.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum EditedBlock {
    /// By its block number.
    Number(u64),
    /// By its line, from 1.
    Line(u64),
}

impl CheckPolicy {
    /// Meaning of all linear words of the program; `None` where the program decides with each approach, or operations
    /// differ.
    #[must_use]
    pub fn linear_of_all(&self) -> Option<LinearMeaning> {
        self.words.linear.filter(|_| self.operations.iter().all(|rule| rule.linear.is_none()))
    }

    /// Largest tolerance of the path, of all operations, mm.
    #[must_use]
    pub fn largest_path_mm(&self) -> f64 {
        let own = self.operations.iter().filter_map(|rule| rule.path_mm);
        own.fold(self.tolerances.path_mm, f64::max)
    }
}

/// Meaning of linear words.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LinearMeaning {
    /// Axis positions.
    AxisPositions,
    /// Coordinates of the tip, under tip control.
    TipCoordinates,
    /// Coordinates of the tip in a tilted plane, or from a zero that follows the table.
    PlaneCoordinates,
}

impl LinearMeaning {
    pub(super) const fn name(self) -> &'static str {
        match self {
            Self::AxisPositions => "axis positions",
            Self::TipCoordinates => "tip coordinates under tip control",
            Self::PlaneCoordinates => "coordinates in a plane",
        }
    }
}

/// Frame of the coordinates of the tip under tip control.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TipFrame {
    /// Fixed to the table, as it is with its rotary axes at zero.
    TableAtZero,
    /// Fixed to the table, as it is where tip control is switched on.
    TableAtStart,
    /// Fixed to the machine.
    Machine,
}

/// Meaning of words.
#[derive(Debug, Clone, PartialEq)]
pub struct WordPolicy {
    /// Meaning of linear words, where an operation has no rule; without it the program decides with each approach.
    pub linear: Option<LinearMeaning>,
    /// Frame of the tip under tip control.
    pub tip_frame: TipFrame,
    /// Under tip control the control rotates the tool axis in the plane of its ends.
    pub axis_in_plane: bool,
    /// The program selects `axis_in_plane` where the control has a word for it; otherwise a setting of the control
    /// does.
    pub posture_word: bool,
    /// Under tip control the program gives components of the tool axis instead of angles.
    pub tool_axis_vectors: bool,
    /// Tip control is switched by codes of the shop, which also select how the tool axis moves.
    pub own_tip_codes: bool,
    /// Axis names that differ from the axis letters.
    pub axis_names: BTreeMap<char, String>,
    /// Rotary axes whose words are reduced to one revolution.
    pub rollover: BTreeMap<char, RolloverRule>,
    /// A number without a decimal point has the same value as with one.
    pub plain_numbers: bool,
}

/// Number of decimals of the words.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Decimals {
    /// Linear words in mm.
    pub linear_mm: u32,
    /// Linear words in inches.
    pub linear_inch: u32,
    /// Rotary words, in degrees.
    pub rotary: u32,
    /// S.
    pub speed: u32,
    /// F per minute in mm.
    pub feed_mm: u32,
    /// F per minute in inches, or in tenths of an inch.
    pub feed_inch: u32,
    /// Pitch of a thread in mm.
    pub pitch_mm: u32,
    /// Pitch of a thread in inches.
    pub pitch_inch: u32,
    /// Largest number of digits of an F before its point.
    pub feed_whole: u32,
    /// Significant digits of an inverse-time F.
    pub inverse_time: u32,
}

impl Decimals {
    /// Number of decimals of a linear word.
    #[must_use]
    pub const fn linear(&self, units: Units) -> u32 {
        match units {
            Units::Millimetres => self.linear_mm,
            Units::Inches => self.linear_inch,
        }
    }

    /// Number of decimals of an F per minute.
    #[must_use]
    pub const fn feed(&self, units: Units) -> u32 {
        match units {
            Units::Millimetres => self.feed_mm,
            Units::Inches => self.feed_inch,
        }
    }

    /// Number of decimals of a pitch.
    #[must_use]
    pub const fn pitch(&self, units: Units) -> u32 {
        match units {
            Units::Millimetres => self.pitch_mm,
            Units::Inches => self.pitch_inch,
        }
    }
}

/// Largest deviations from the CL data.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tolerances {
    /// Of the tip from its path, mm.
    pub path_mm: f64,
    /// Of the tool axis from its great circle, rad.
    pub axis_path_rad: f64,
    /// Angle to the pole within which a tool axis may be put at the pole, and to a step of an indexed axis, rad.
    pub pole_rad: f64,
    /// There are indexed axes.
    pub has_steps: bool,
    /// A tolerance in the CL data may be larger than `path_mm`.
    pub stated_may_be_larger: bool,
    /// Where the control blends blocks: largest deviation from the programmed path, mm.
    pub blending_mm: f64,
}

/// Form of a rapid at the part.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RapidForm {
    /// One block.
    OneBlock,
    /// Two blocks, along the tool axis and across it.
    TwoBlocks,
    /// A feed motion.
    Feed,
}

/// Optional stops that the CL data does not program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StopRule {
    /// None.
    None,
    /// After the last operation of a tool.
    ToolChanges,
    /// After each operation.
    Operations,
}

/// Form of the machine retract.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RetractRule {
    /// To a machine coordinate.
    MachineCoordinate,
    /// To the reference position, through no other point.
    ReferencePosition,
    /// Along the tool axis to the end of the travel; to a machine coordinate before the first tool.
    AlongTool,
    /// By this number of blocks of the shop.
    OwnBlocks(usize),
}

/// Motion between cuts.
#[derive(Debug, Clone, PartialEq)]
pub struct LinkPolicy {
    /// Form of rapids at the part.
    pub rapid: RapidForm,
    /// Feed of rapids that are feed motions, mm/min.
    pub rapid_feed_mm_per_min: Option<f64>,
    /// Rapids that rotate the tool may lead along the path of the CL data, without a retract.
    pub follows_links: bool,
    /// Operations follow each other without a retract.
    pub direct: bool,
    /// So they do with the same tool and tool axis, where a rapid leads over the clearance geometry.
    pub over_clearance: bool,
    /// Largest rotation of a rotary axis in a rapid at the part, rad.
    pub index_angle_rad: f64,
    /// Coordinate of the retract axis at the machine retract, mm.
    pub retract_mm: f64,
    /// Form of the machine retract.
    pub retract: RetractRule,
    /// Home positions of the other linear axes, machine coordinates, to which they go before the rotary axes rotate.
    pub home_mm: Option<BTreeMap<char, f64>>,
    /// Length of the retract along the tool axis, mm; without it out of the clearance geometry.
    pub retract_distance_mm: Option<f64>,
    /// Clearance geometry, until the CL data programs one.
    pub clearance: Option<Clearance>,
    /// Rotary axes are rewound in the cut.
    pub rewinds_in_cut: bool,
    /// Feed back to the part after a rewind, mm/min; without it that of the cut.
    pub entry_feed_mm_per_min: Option<f64>,
    /// Coolant is off while rotary axes are rewound at the retract position.
    pub rewinds_dry: bool,
    /// Distance of the approach point from the first point, along the tool axis, mm.
    pub approach_mm: f64,
    /// The machine retracts before a stop.
    pub retracts_for_stop: bool,
    /// Optional stops that the CL data does not program.
    pub optional_stops: StopRule,
    /// Dwell before a tool change after coolant through the spindle, s.
    pub through_dwell_s: f64,
    /// Dwell after the spindle is switched on, s.
    pub spindle_dwell_s: f64,
    /// Parking position of axes at the end: mm in machine coordinates, rad.
    pub park: BTreeMap<char, f64>,
    /// Position of axes where a tool is changed: mm in machine coordinates, rad.
    pub tool_change_position: BTreeMap<char, f64>,
    /// Position of axes where a tool is measured or checked for breakage: mm in machine coordinates, rad.
    pub tool_position: BTreeMap<char, f64>,
    /// Lift of a dry run along the tool axis, mm.
    pub dry_lift_mm: Option<f64>,
}

/// Path to which F applies where a rotary axis moves.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FeedPath {
    /// That of the linear axes.
    Linear,
    /// That of all axes, a degree counted as a millimetre.
    LinearAndDegrees,
    /// F is the inverse of the time of the block, 1/min.
    InverseMinutes,
    /// F is the inverse of the time of the block, 1/s.
    InverseSeconds,
}

/// F of feed blocks.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FeedPolicy {
    /// Path to which F applies, if it is not that of the control as delivered.
    pub path: Option<FeedPath>,
    /// No axis is to be faster than it can be.
    pub keeps_axis_speeds: bool,
    /// Largest F, mm/min.
    pub largest_mm_per_min: Option<f64>,
    /// Largest F of inverse-time feed, if it is not that of the control.
    pub largest_inverse_time: Option<f64>,
    /// Shortest time of a block, s.
    pub shortest_block_s: f64,
    /// Speed of rotary axes where the tip rests, rad/min.
    pub reorient_rad_per_min: f64,
    /// All axes of a rapid arrive together, if that is not as the control is delivered.
    pub rapids_interpolated: Option<bool>,
}

/// State that the CL data leaves open.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StateDefaults {
    /// Tool where the CL data calls none.
    pub tool: Option<u32>,
    /// S where the CL data programs none, rev/min.
    pub speed_rev_per_min: Option<f64>,
    /// Sense of rotation where the CL data programs none.
    pub rotation: Option<Rotation>,
    /// Kinds of coolant that COOLNT/ON means, on together.
    pub coolant: Coolants,
    /// Distance above the last depth to which a peck returns at rapid, mm.
    pub peck_gap_mm: f64,
}

/// Operations that are in the program.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum OperationSelection {
    /// By number, from 1: the first and the last.
    Range(u64, Option<u64>),
    /// From the operation of this name.
    From(String),
}

/// What a rule is for.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum RuledOperation {
    /// The operation of this number, counted from 1.
    Number(u64),
    /// Operations of this name, in any letter case.
    Name(String),
    /// Operations whose names are like this one: `*` is any text, `?` one character.
    Like(String),
}

/// Rule of single operations; what it leaves open is as in the whole program.
#[derive(Debug, Clone, PartialEq)]
pub struct OperationRule {
    /// The operations.
    pub of: RuledOperation,
    /// Meaning of linear words; `Some(None)`: the program decides.
    pub linear: Option<Option<LinearMeaning>>,
    /// Smoothing in cuts; `Some(None)`: off.
    pub smoothing: Option<Option<SmoothingLevel>>,
    /// Largest deviation where the control blends or smooths, mm.
    pub blending_mm: Option<f64>,
    /// Largest deviation of the tip from its path, mm.
    pub path_mm: Option<f64>,
    /// Largest feed of the tip in feed motions, mm/min.
    pub largest_feed_mm_per_min: Option<f64>,
    /// Material that is left on the design, mm.
    pub allowance_mm: Option<f64>,
}

/// Smoothing that the program switches on for cuts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SmoothingLevel {
    /// Speed first.
    Rough,
    /// Between the two.
    Medium,
    /// Surface first.
    Finish,
}

/// Blocks of the shop and functions of the control that belong in the program.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ShopBlocks {
    /// The shop has safety blocks of its own at restart points.
    pub own_safety: bool,
    /// Every tool of known length is guarded: largest difference of the length in the control, mm.
    pub length_guard_mm: Option<f64>,
    /// The guard is needed only where words are positions of axes that have rotated.
    pub guards_rotated_axes_only: bool,
    /// The control has tilted planes: at zero, axis positions may be coordinates in a plane.
    pub has_planes: bool,
    /// Such words lead to tip control as well.
    pub guards_tip_control: bool,
    /// Rotary positions are compared after each plane call, where the control can.
    pub guards_planes: bool,
    /// What lies over the work offset is compared after each complete state, where the control can.
    pub guards_offset: bool,
    /// Functions of the control that are installed, by their names; `None` if they are not listed.
    pub functions: Option<Vec<String>>,
    /// Smoothing in cuts.
    pub smoothing: Option<SmoothingLevel>,
    /// Numbers of rough, medium and finish, where the program states them.
    pub smoothing_levels: Option<[u32; 3]>,
    /// Tolerance of smoothing for rotary axes, where the program states it.
    pub smoothing_angle_rad: Option<f64>,
    /// The path in the CL data is that of the tool centre where cutter compensation is on.
    pub compensated_centre: bool,
    /// Largest wear of a tool, mm.
    pub largest_wear_mm: f64,
    /// F of a thread is per revolution, where its cycle takes an F.
    pub thread_per_revolution: bool,
    /// Threads are cut with the feed synchronised to the spindle.
    pub rigid_tapping: bool,
    /// Direction along X and Y in which a tool leaves the wall of a bore, of length 1; 0, 0 if it is not configured.
    pub bore_direction: [f64; 2],
    /// Distance by which it does, mm.
    pub bore_shift_mm: f64,
    /// Lines that the configuration brings into the program.
    pub lines: Vec<ShopLine>,
    /// Declared effects of lines and words that are in no table, by their text.
    pub effects: Vec<(String, Effect)>,
    /// Lines that measure, where their codes say nothing else.
    pub measuring: Vec<String>,
    /// Tools are called by the names of the set-up.
    pub tool_names: bool,
    /// Name of the swivel data record.
    pub swivel_data: String,
    /// Number of the spindle of the tool, where its words have it.
    pub spindle_number: Option<u32>,
    /// Blocks with a number are restart points.
    pub restarts_numbered: bool,
    /// Texts of PPRINT are displayed.
    pub displays_messages: bool,
    /// Settings and parameters of the control, by its names for them, mm.
    pub states: Vec<(String, f64)>,
}

impl ShopBlocks {
    /// Value of a setting or parameter of the control, mm, where it is known.
    #[must_use]
    pub fn state_mm(&self, name: &str) -> Option<f64> {
        self.states.iter().find(|(state, _)| state == name).map(|(_, value)| *value)
    }

    /// Whether safety blocks of the shop state the tolerance within which the control blends.
    #[must_use]
    pub fn states_blending(&self) -> bool {
        let states = |line: &ShopLine| line.place == OwnPlace::Safety && line.text.contains("{path_tolerance}");
        self.lines.iter().any(states)
    }

    /// Whether they state the same distance for lines that are joined (Q of G64).
    #[must_use]
    pub fn states_joining(&self) -> bool {
        let states = |line: &ShopLine| line.place == OwnPlace::Safety && line.text.contains("Q{path_tolerance}");
        self.lines.iter().any(states)
    }

    /// Whether blocks of the shop may select modal functions that the control's own blocks leave alone.
    #[must_use]
    pub fn selects_modes(&self) -> bool {
        let idle = |text: &str| self.effects.iter().any(|(word, effect)| word == text && *effect == Effect::None);
        let selects = |line: &ShopLine| {
            matches!(line.place, OwnPlace::Start | OwnPlace::ToolChange | OwnPlace::OperationStart)
                && !(idle(&line.text) || line.text.split_whitespace().all(idle))
        };
        self.own_safety || self.lines.iter().any(selects)
    }
}

/// A line that the configuration brings into the program.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ShopLine {
    /// The line, with fields in braces.
    pub text: String,
    /// Its place in the configuration.
    pub place: OwnPlace,
    /// Bits of the kinds of coolant that a coolant code switches, and whether it switches them on.
    pub coolant: Option<(u8, bool)>,
}
