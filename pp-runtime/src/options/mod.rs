//! Options of planning: words, tolerances, speeds, approach and retract.
//!
//! Plain data in mm, rad and mm/min, with the tables of their configuration keys. The doc line of a field with a key is
//! the description of the key in the configuration sample and in the schema. Several stages read them: nothing is
//! planned or written here.

#![cfg_attr(not(test), deny(clippy::disallowed_methods))]

mod cutting;
mod keys;
mod links;
mod operations;
mod words;

use std::collections::BTreeMap;
use std::ops::RangeInclusive;

use crate::keys::{Bound, Measure, OneOf, Whole, YesNo, options};
use crate::kinematics::Branch;

use keys::{PARK, Preference};
use operations::OperationsTable;

pub(crate) use cutting::{
    ArcForm, ArcOptions, ArcOutput, BoreRetract, CutterPath, CycleOptions, CycleOutput, Defaults, FeedLimits, PathNorm,
    ThreadFeed,
};
pub(crate) use keys::{ClampCodes, Wrap};
pub use links::Transition;
pub(crate) use links::{Approach, CoolantOptions, Links, Rapid, RapidOptions, Retract, Rewind};
pub(crate) use operations::{OperationChoice, OperationEntry, OperationSettings, OperationTable, Smoothing};
pub use words::{Mode, TcpFrame, TcpWords, ToolPosture};
pub(crate) use words::{RotaryOptions, StretchMode, TipOptions};

options! {
    /// Options of planning. Lengths in mm, angles in rad, speeds in mm/min and rad/min.
    pub struct MotionOptions {
        /// Largest deviation of arcs and chords from the arcs and curves of the CL data, and of the tip from its line
        /// while a rotary axis moves.
        tolerance_mm: f64 = 0.01, key("tolerance", Measure::length(Bound::Positive).unless(beyond_words));
        /// Largest angle of the tool axis from the great circle between two points. The rotary axes go evenly where
        /// they keep to it, else by points on the great circle.
        axis_tolerance_path_rad: f64 = 0.1_f64.to_radians(),
            key("axis_tolerance_path", Measure::angle(Bound::Positive).unless(beyond_axis_words));
        /// Dwell after the start of the spindle, seconds.
        spindle_dwell_s: f64 = 0.0, key("spindle_dwell", Measure::plain(Bound::NotNegative).unless(no_dwell));
        /// Retract before STOP and OPSTOP.
        stop_retract: bool = true, key("stop_retract", YesNo);
        /// Optional stops (M1) that the CL data does not program: "none", "tool_changes" (at each tool record that
        /// calls another tool, after the last operation of the one before) or "operations" (after each operation of the
        /// CL data, at the name of the next, TOOL PATH, and at each tool record). None comes where the CL data has STOP
        /// or OPSTOP after the last motion, and none at the end.
        optional_stops: OptionalStops = OptionalStops::None, key("optional_stops", OneOf(&OptionalStops::NAMES));
        /// Preselect the first tool at the last tool change, for the next part, where tools are preselected.
        preselect_first: bool = true, key("control.preselect_first", YesNo);
        /// Park positions of axes at the end of the program: degrees, and machine coordinates of linear axes. Axes
        /// without one do not move.
        park: BTreeMap<char, f64> = BTreeMap::new(), key("park", PARK);
        /// Positions of axes, after the machine retract, for the blocks of `cycles.measure_tool` and
        /// `cycles.check_tool`: degrees, and machine coordinates of linear axes, which come last. Axes without one are
        /// where the last cut has left them: a table that is tilted.
        tool_position: BTreeMap<char, f64> = BTreeMap::new(), key("cycles.tool_position", PARK);
        /// Meaning of the words of a motion: positions of the "axes" (on any control), coordinates of the tip under tip
        /// control ("tcp"), coordinates of the tip in a tilted "plane" (3+2), or "auto": tip control where the tool
        /// axis rotates at feed, else a tilted plane, and axis positions where the control has neither.
        mode: Mode = Mode::Auto, key("mode", OneOf(&Mode::NAMES));
        /// Mode "auto": largest number of tool axes of an operation of fixed tool axes without holes, arcs and cutter
        /// compensation that gets a plane for each; one of more is written under tip control.
        auto_planes: u32 = 8, key("auto_planes", Whole(1..=MOST_PLANES));
        /// Angle of the first rotary axis where the tool axis is parallel to it in all cuts from one motion in the air
        /// to the next (vertical operations of a machine with a C table): "zero", so that X and Y are read as on the
        /// drawing, or the "previous" one, which is also the "shortest" travel. A cut that rotates the tool axis away
        /// from there decides the angle itself.
        singular: Singular = Singular::Zero, key("singular", OneOf(&Singular::NAMES));
        /// Tip control, in mode `tcp`.
        tip: TipOptions = TipOptions::default(), keys();
        /// Motion between cuts.
        rapids: RapidOptions = RapidOptions::default(), keys();
        /// Checks.
        guards: GuardOptions = GuardOptions::default(), keys();
        /// LINTOL may be wider than `tolerance`.
        allow_lintol: bool = false, key("cl.allow_lintol", YesNo);
        /// Defaults for what the CL data leaves out.
        defaults: Defaults = Defaults::default(), keys();
        /// Choice of branch and turns of the rotary axes.
        course: CourseOptions = CourseOptions::default(), keys();
        /// Retract from the part.
        retract: Retract = Retract::default(), keys();
        /// Arcs of the control.
        arcs: ArcOptions = ArcOptions::default(), keys();
        /// Cycles of the control.
        cycles: CycleOptions = CycleOptions::default(), keys();
        /// Cutter compensation by the control (CUTCOM: G41, G42, RL, RR): path in the CL data, of the tool "centre" (D
        /// holds wear only; on Heidenhain the tool call takes the radius off) or the "contour" (D holds the radius).
        /// Without it CUTCOM is refused.
        compensation: Option<CutterPath> = None, key("compensation.path", OneOf(&CutterPath::NAMES), "\"centre\"");
        /// Largest wear with path "centre": a Siemens control stops if the radius of the edge is larger.
        largest_wear_mm: f64 = 0.5, also("compensation.largest_wear", Measure::length(Bound::Positive));
        /// Limits of feeds and block times.
        feed: FeedLimits = FeedLimits::default(), keys();
        /// Approach to the part.
        approach: Approach = Approach::default(), keys();
        /// Coolant around tool changes.
        coolant: CoolantOptions = CoolantOptions::default(), keys();
        /// Words and clamps of rotary axes.
        rotaries: RotaryOptions = RotaryOptions::default(), keys();
        /// Operations that are posted; all without it.
        selected: Option<Operations> = None;
        /// Settings of single operations that differ from those of the whole program: by number (as in `--ops`), by the
        /// name of TOOL PATH, or by a pattern with `*` and `?`; letter case is ignored. A number counts before a name,
        /// a name before a pattern. `largest_feed` is the largest feed of the tip in feed motions.
        operations: OperationTable = OperationTable::default(), key("operations", OperationsTable);
        /// Dry run: distance by which every point is moved out along the tool axis, mm; the spindle stays off.
        lift_mm: Option<f64> = None;
        /// Words of NC text before which the machine retracts and the spindle stops.
        standstill: Vec<StandstillWord> = Vec::new();
    }
}

/// A word or a line of NC text before which the machine retracts and the spindle stops.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct StandstillWord {
    /// The word, or the whole line.
    pub text: String,
    /// Name of its effect: work is clamped, a door moves; `None` where it is not confirmed to be harmless.
    pub effect: Option<&'static str>,
}

impl StandstillWord {
    /// Whether a block is this line, or has this word.
    pub(crate) fn is_in(&self, block: &str) -> bool {
        block.trim() == self.text || block.split_whitespace().any(|word| word == self.text)
    }
}

options! {
    /// Choice of branch and turns of the rotary axes, for the whole program: fewest rewinds, then these preferences,
    /// then least time at the largest axis speeds, then least travel.
    pub struct CourseOptions in "course" {
        /// Preferred branch of `explain` at the beginning of operations: "first" or "second".
        start_branch: Option<Branch> = None, key("course.start_branch", OneOf(&START_BRANCHES), "\"first\"");
        /// Preferred side of zero of a rotary axis at the beginning of operations; where an operation begins at the
        /// pole, after the cut that leaves it.
        ///
        /// `true`: at or above zero.
        prefer: Option<(char, bool)> = None, key("course.prefer", Preference);
        /// Choose motion by motion, without look-ahead.
        greedy: bool = false, key("course.greedy", YesNo);
        /// Within this angle of the direction that leaves the first rotary axis free, the tool axis is moved to that
        /// direction.
        ///
        /// Zero: within the rounding of CL data.
        axis_tolerance_rad: f64 = 0.0,
            key("course.axis_tolerance", Measure::angle(Bound::NotNegative).unless(another_path));
        /// Largest rotation of a rotary axis at the pole with the tool in the cut: for a larger one the tool leaves the
        /// part. Without it any.
        rotation_at_pole_rad: Option<f64> = None,
            key("course.rotation_at_pole", Measure::angle(Bound::NotNegative), "45.0");
    }
}

options! {
    /// Checks.
    pub struct GuardOptions {
        /// Compare the posted length of a tool with the tool table of the control at the tool call, where the control
        /// can. Without it: only where the length matters because of a rotary axis in the head. Not with
        /// `control.tool_names`: the program reads the length by the number of the tool. A tool that is measured in the
        /// program must come out within `length_tolerance` of the posted length; where no rotary axis is in the head
        /// its length may be any other, and false is right.
        length_guard: Option<bool> = None, key("length_guard", YesNo, "true");
        /// Largest difference between the lengths.
        length_tolerance_mm: f64 = 0.01, also("length_tolerance", Measure::length(Bound::Positive).unless(unmeasurable));
        /// Compare the positions of the rotary axes with those of the program after the control has tilted a plane
        /// (Siemens, Heidenhain; the variables of Fanuc and Haas have positions by numbers of axes, which are the
        /// machine builder's).
        plane_guard: bool = true, key("plane_guard", YesNo);
        /// Stop at each restart point if a rotation, a scale, a mirror or a shift that lasts lies over the work offset
        /// (LinuxCNC: G92, G52 and the R of the offset; Siemens: all frames; Heidenhain: the basic rotation). Without
        /// it the header has the condition. Set false where such a rotation is meant: the program does not know it.
        offset_guard: bool = true, key("offset_guard", YesNo);
        /// Largest spindle speed, rev/min. Without it speeds are not checked.
        spindle_max_rev_per_min: Option<f64> = None, key("spindle_max", Measure::plain(Bound::Positive), "12000");
        /// Lowest Z of the tool tip, in the part as mounted on the table. Without it depths are not checked.
        floor_mm: Option<f64> = None, key("floor", Measure::length(Bound::Any), "0.0");
        /// Refuse CL data in which every tool axis points into the table.
        table_check: bool = true, key("table_check", YesNo);
    }
}

/// Largest number for `auto_planes`.
const MOST_PLANES: u32 = 1000;

/// Optional stops that the CL data does not program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum OptionalStops {
    /// None.
    None,
    /// After the last operation before a change to another tool.
    ToolChanges,
    /// After each operation.
    Operations,
}

impl OptionalStops {
    pub(crate) const NAMES: [(&'static str, Self); 3] =
        [("none", Self::None), ("tool_changes", Self::ToolChanges), ("operations", Self::Operations)];
}

/// Angle of the first rotary axis where it is free.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Singular {
    /// Zero, or whole turns from it.
    Zero,
    /// The one in which it is.
    Previous,
    /// The one with the least travel. That is the previous one: a free axis that rotates early rotates no less.
    Shortest,
}

impl Singular {
    pub(crate) const NAMES: [(&'static str, Self); 3] =
        [("zero", Self::Zero), ("previous", Self::Previous), ("shortest", Self::Shortest)];

    /// `zero`, `previous` or `shortest`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Zero => "zero",
            Self::Previous => "previous",
            Self::Shortest => "shortest",
        }
    }
}

/// Names of the branches.
pub(crate) const START_BRANCHES: [(&str, Branch); 2] = [("first", Branch::First), ("second", Branch::Second)];

impl MotionOptions {
    /// Mode of every stretch; `None` where it is chosen for each, or an operation has its own.
    #[must_use]
    pub fn mode_of_all(&self) -> Option<StretchMode> {
        self.mode.of_all().filter(|_| !self.operations.sets_mode())
    }

    /// Chord tolerances, mm: below the range words are too coarse, above it the path is no longer followed.
    pub(crate) const TOLERANCE: RangeInclusive<f64> = 0.0001..=1.0;

    /// Tolerances of the tool axis, degrees: below the range words are too coarse, above it the axis is no longer
    /// followed.
    pub(crate) const AXIS_TOLERANCE: RangeInclusive<f64> = 0.001..=10.0;
}

/// Tolerances of the length guard, mm: from the resolution of its words to beyond the accuracy of any tool measurement.
const LENGTH_TOLERANCE: RangeInclusive<f64> = 0.0001..=1.0;

/// Dwells after spindle start, s: three decimals are written, and ten minutes are a mistake.
const DWELL: RangeInclusive<f64> = 0.001..=600.0;

/// Largest axis tolerance at the pole, rad: a wider one would change the path.
const LARGEST_AXIS_TOLERANCE: f64 = 5_f64.to_radians();

/// Smallest tolerance of blending and smoothing, mm. In inches, with six decimals, it is still greater than zero.
const SMALLEST_PATH_TOLERANCE: f64 = 0.0001;

pub(crate) fn nearly_zero(tolerance: f64) -> Option<String> {
    (tolerance < SMALLEST_PATH_TOLERANCE).then(|| {
        format!(
            "a tolerance below {SMALLEST_PATH_TOLERANCE} mm could be written as 0, which removes the limit on the \
             deviation from the path"
        )
    })
}

fn beyond_words(tolerance: f64) -> Option<String> {
    outside(&MotionOptions::TOLERANCE, tolerance)
}

fn unmeasurable(tolerance: f64) -> Option<String> {
    outside(&LENGTH_TOLERANCE, tolerance)
}

fn outside(range: &RangeInclusive<f64>, tolerance: f64) -> Option<String> {
    let (low, high) = (range.start(), range.end());
    (!range.contains(&tolerance)).then(|| format!("a tolerance of {low} to {high} mm is needed here"))
}

/// Compares with a little slack: the ends of the range are degrees, and the value has been converted from radians.
fn beyond_axis_words(tolerance: f64) -> Option<String> {
    let range = MotionOptions::AXIS_TOLERANCE;
    let (low, high) = (range.start(), range.end());
    let within = low * (1.0 - 1e-12)..=high * (1.0 + 1e-12);
    let outside = !within.contains(&tolerance.to_degrees());
    outside.then(|| format!("a tolerance of {low} to {high} degrees is needed here"))
}

fn no_dwell(seconds: f64) -> Option<String> {
    let (low, high) = (DWELL.start(), DWELL.end());
    let outside = seconds > 0.0 && !DWELL.contains(&seconds);
    outside.then(|| format!("a dwell of 0, or of {low} to {high} seconds, is needed here"))
}

fn another_path(tolerance: f64) -> Option<String> {
    let largest = LARGEST_AXIS_TOLERANCE.to_degrees();
    (tolerance > LARGEST_AXIS_TOLERANCE).then(|| format!("an angle of at most {largest} degrees is needed here"))
}

/// Selection of operations, counted from 1. An operation begins at TOOL PATH, a tool record, a stop or a frame; starts
/// with no motion between them count as one.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum Operations {
    /// First and last operation, both included; `None`: up to the last of the program.
    Range(u64, Option<u64>),
    /// All from the first operation of this name.
    From(String),
}
