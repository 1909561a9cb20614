//! Options of cuts: arcs, cycles, cutter compensation, feeds, and defaults for what the CL data leaves out.

use crate::keys::{Bound, Measure, OneOf, Whole, YesNo, options};
use crate::program::{Coolant, Coolants, Rotation};
use crate::set_up::{CoolantKinds, LARGEST_TOOL, ROTATIONS};

/// Output of arcs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ArcOutput {
    /// Arcs of the control where they stay within tolerance, else lines.
    Native,
    /// Lines.
    Lines,
}

impl ArcOutput {
    const NAMES: [(&'static str, Self); 2] = [("native", Self::Native), ("lines", Self::Lines)];
}

/// Words that define the centre of an arc.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ArcForm {
    /// Centre words.
    Centre,
    /// Radius word, except where it does not define the centre: full circles and arcs close to a half circle.
    Radius,
}

impl ArcForm {
    const NAMES: [(&'static str, Self); 2] = [("centre", Self::Centre), ("radius", Self::Radius)];
}

options! {
    /// Arcs of the control: where the rotary axes do not move, in a plane of the program, within `tolerance` of the CL
    /// data.
    pub struct ArcOptions in "arcs" {
        /// "native", or "lines" throughout.
        output: ArcOutput = ArcOutput::Native, key("arcs.output", OneOf(&ArcOutput::NAMES));
        /// Words that define the centre: "centre", or "radius" (full circles and arcs close to a half circle keep
        /// their centre words).
        form: ArcForm = ArcForm::Centre, key("arcs.form", OneOf(&ArcForm::NAMES));
        /// Arcs with a smaller or a larger radius become lines.
        smallest_radius_mm: f64 = 0.01, key("arcs.smallest_radius", Measure::length(Bound::Positive));
        /// Arcs with a larger radius become lines.
        largest_radius_mm: f64 = 10_000.0, also("arcs.largest_radius", Measure::length(Bound::Positive));
    }
}

/// Output of holes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CycleOutput {
    /// Cycles of the control where they move the tool in the same way, else single motions.
    Native,
    /// Single motions.
    Expanded,
}

impl CycleOutput {
    const NAMES: [(&'static str, Self); 2] = [("native", Self::Native), ("expanded", Self::Expanded)];
}

options! {
    /// Cycles of the control: where the tool axis is Z of the program and a cycle moves the tool as the CL data does.
    pub struct CycleOptions in "cycles" {
        /// "native", or "expanded" into single motions throughout; a thread is never expanded.
        output: CycleOutput = CycleOutput::Native, key("cycles.output", OneOf(&CycleOutput::NAMES));
        /// Rigid tapping, where the control has a code for it (M29 of Fanuc).
        rigid: bool = true, key("cycles.rigid", YesNo);
        /// F of a thread: per "minute", or per "revolution" (G95), where F is the pitch (Fanuc, Haas; the other
        /// controls take the pitch in any case).
        thread_feed: ThreadFeed = ThreadFeed::PerMinute, key("cycles.thread_feed", OneOf(&ThreadFeed::NAMES));
        /// Direction in which the tool leaves the wall of a bore where the spindle has stopped at its angle (BORE with
        /// ORIENT), away from the cutting edge: "+X", "-X", "+Y" or "-Y" of the program. Such a bore is refused without
        /// it, and in other modes than "axes", where the tool axis has to be Z of the program: set `mode = "axes"` for
        /// its operation.
        bore_retract: Option<BoreRetract> = None, key("cycles.bore_retract", OneOf(&BoreRetract::NAMES), "\"-X\"");
        /// Distance by which it leaves the wall.
        bore_shift_mm: f64 = 0.2, key("cycles.bore_shift", Measure::length(Bound::Positive).unless(far_off));
    }
}

/// Largest distance off the wall of a bore, mm: the bar has to pass at the other side.
const FARTHEST_OFF: f64 = 5.0;

fn far_off(shift_mm: f64) -> Option<String> {
    (shift_mm > FARTHEST_OFF).then(|| {
        format!(
            "{shift_mm} mm off the wall of a bore drives the bar into the other side: tenths of a millimetre are enough"
        )
    })
}

/// Direction in which the tool leaves the wall of a bore, in the XY plane of the program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BoreRetract {
    /// +X.
    PlusX,
    /// -X.
    MinusX,
    /// +Y.
    PlusY,
    /// -Y.
    MinusY,
}

impl BoreRetract {
    /// Names, as in configuration files.
    pub(crate) const NAMES: [(&'static str, Self); 4] =
        [("+X", Self::PlusX), ("-X", Self::MinusX), ("+Y", Self::PlusY), ("-Y", Self::MinusY)];

    /// Its name.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::PlusX => "+X",
            Self::MinusX => "-X",
            Self::PlusY => "+Y",
            Self::MinusY => "-Y",
        }
    }

    /// Unit steps along X and Y.
    #[must_use]
    pub const fn steps(self) -> [i64; 2] {
        match self {
            Self::PlusX => [1, 0],
            Self::MinusX => [-1, 0],
            Self::PlusY => [0, 1],
            Self::MinusY => [0, -1],
        }
    }
}

/// F of a thread, on controls whose cycle takes an F.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ThreadFeed {
    /// Pitch times speed.
    PerMinute,
    /// The pitch.
    PerRevolution,
}

impl ThreadFeed {
    const NAMES: [(&'static str, Self); 2] = [("minute", Self::PerMinute), ("revolution", Self::PerRevolution)];
}

/// Path in the CL data while CUTCOM is on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CutterPath {
    /// Path of the tool centre: the register holds the wear.
    Centre,
    /// Contour of the part: the register holds the radius.
    Contour,
}

impl CutterPath {
    pub(crate) const NAMES: [(&'static str, Self); 2] = [("centre", Self::Centre), ("contour", Self::Contour)];
}

/// Path length that F refers to in a block in which a rotary axis moves.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PathNorm {
    /// Path of the linear axes; degrees where none of them moves.
    Xyz,
    /// Path of linear and rotary axes: √(Σ mm² + Σ degrees²).
    XyzDegrees,
    /// None, inverse time: F is 1/min.
    G93Minutes,
    /// None, inverse time: F is 1/s.
    G93Seconds,
}

options! {
    /// Defaults for what the CL data leaves out.
    pub struct Defaults in "defaults" {
        /// Spindle speed, rev/min.
        speed_rev_per_min: Option<f64> = None, also("defaults.speed", Measure::plain(Bound::Positive), "8000");
        /// Sense of rotation of the spindle: CLW (M3) or CCLW (M4).
        rotation: Option<Rotation> = None, key("defaults.direction", OneOf(&ROTATIONS), "\"CLW\"");
        /// Coolant for COOLNT/ON, as `coolant` of a tool: one kind, or several that are on together.
        coolant: Coolants = Coolants::of(Coolant::Flood), key("defaults.coolant", CoolantKinds);
        /// Tool for CL data without a tool call before its first motion. Without it such data is refused.
        tool: Option<u32> = None, key("defaults.tool", Whole(1..=LARGEST_TOOL), "1");
        /// Distance above the last step at which the rapid back into a hole ends.
        peck_gap_mm: f64 = 0.5, key("defaults.peck_gap", Measure::length(Bound::Positive));
    }
}

options! {
    /// Limits of feeds and block times.
    pub struct FeedLimits in "feed" {
        /// Slow down blocks in which an axis would exceed its speed.
        keep_speeds: bool = true, key("feed.keep_speeds", YesNo);
        /// Largest F of the control, per minute. Without it F is not limited.
        largest_mm_per_min: Option<f64> = None, key("feed.largest", Measure::length(Bound::Positive), "20000.0");
        /// Largest F of a block in inverse time. Without it that of the control (Haas: 9999.99).
        largest_inverse_time: Option<f64> = None,
            key("feed.largest_inverse_time", Measure::plain(Bound::Positive), "9999.99");
        /// Shortest time of a block, seconds.
        shortest_block_s: f64 = 0.0, key("feed.shortest_block", Measure::plain(Bound::NotNegative));
    }
}
