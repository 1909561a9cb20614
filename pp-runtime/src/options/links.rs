//! Options of motion between cuts: rapids, transitions, approach and retract.

use std::collections::BTreeMap;

use crate::keys::{Assumed, Bound, Measure, OneOf, YesNo, options};
use crate::program::Clearance;

use super::keys::{Geometry, HOME, PARK};
use super::no_dwell;

options! {
    /// Motion between cuts.
    pub struct RapidOptions {
        /// Transition between operations: "safe" (retract, rotate, approach), "direct" (as in the CL data) or "auto"
        /// (safe where the tool, its axis or the set-up changes, where a rotary axis is in the head, and where blocks
        /// of the shop come between operations; else as in the CL data where the first motion is a rapid that stays out
        /// of the clearance geometry, which `clearance` or CLEARP states).
        transition: Transition = Transition::Auto, key("transition", OneOf(&Transition::NAMES));
        /// Rapids in which a rotary axis rotates by more than this are replaced by the safe sequence, if they are no
        /// links.
        index_angle_rad: f64 = 1_f64.to_radians(), key("index_angle", Measure::angle(Bound::NotNegative));
        /// Links, the rapids inside an operation that rotate the tool between cuts that rotate it as well: "follow" (as
        /// in the CL data, where every block keeps tip and tool axis on their path within tolerance: as rapids whose
        /// axes arrive together, `control.linear_rapids`, or at `rapid_feed`; by the safe sequence where neither is
        /// possible) or "safe" (always by the safe sequence).
        links: Links = Links::Follow, key("links", OneOf(&Links::NAMES));
        /// Rapids inside an operation: "direct" (one block), "split" (two blocks, along the tool axis and across it:
        /// out first, in last) or "feed" (a feed motion at `rapid_feed`, on a certified path).
        rapid: Rapid = Rapid::Direct, key("rapid", OneOf(&Rapid::NAMES));
        /// Feed of rapids that are written as feed motions: all with `rapid = "feed"`, else links where the axes of a
        /// rapid do not arrive together.
        rapid_feed_mm_per_min: Option<f64> = None, also("rapid_feed", Measure::length(Bound::Positive), "10000.0");
        /// Speed of rotary axes where only the direction of the tool changes.
        reorient_rad_per_min: f64 = 1800_f64.to_radians(), key("reorient_speed", Measure::angle(Bound::Positive));
    }
}

options! {
    /// Retract from the part.
    pub struct Retract in "retract" {
        /// Machine coordinate of the retract axis.
        position_mm: Option<f64> = None,
            key("retract.position", Assumed(Measure::length(Bound::Any), Self::POSITION_MM));
        /// The other linear axes go to their home positions before the rotary axes rotate, and before they are
        /// programmed where their position is unknown: at the start, after a tool change or a stop.
        home_on_indexing: bool = false, key("retract.home_on_indexing", YesNo);
        /// Home positions of these axes for `home_on_indexing`, machine coordinates; 0 where none is given. With "G91
        /// G28" they are the reference positions.
        xy_mm: BTreeMap<char, f64> = BTreeMap::new(), key("retract.xy", HOME);
        /// Positions of axes, after the machine retract, for a tool change: degrees, and machine coordinates of linear
        /// axes, which come last. For changes by hand at the door, and for changers that do not move the axes there
        /// themselves. Axes without one stay where they are.
        tool_change_position: BTreeMap<char, f64> = BTreeMap::new(), key("retract.tool_change_position", PARK);
        /// Distance along the tool axis. Without it, up to the clearance geometry: `clearance`, or CLEARP of the
        /// CL data.
        distance_mm: Option<f64> = None, key("retract.distance", Measure::length(Bound::Positive), "100.0");
        /// Clearance geometry that the tool has to leave, in the part as mounted on the table: a plane above, or a box
        /// or a cylinder around the part.
        clearance: Option<Clearance> = None,
            key("retract.clearance", Geometry, "{ cylinder = { radius = 120.0, lower = -50.0, upper = 80.0 } }");
        /// Rewind of rotary axes in a cut: "leave" (out along the tool axis and back), or "follow" (the tip stays in
        /// place, and the tool swings about it in the part).
        rewind: Rewind = Rewind::Leave, key("retract.rewind", OneOf(&Rewind::NAMES));
        /// Feed at which the tool comes back to the part after a rewind; without it that of the cut.
        entry_feed_mm_per_min: Option<f64> = None, key("retract.entry_feed", Measure::length(Bound::Positive), "2000.0");
        /// Coolant off while the rotary axes are rewound out of the part.
        rewind_dry: bool = false, key("retract.rewind_dry", YesNo);
    }
}

options! {
    /// Approach to the part.
    pub struct Approach in "approach" {
        /// Distance of the approach point from the first point, along the tool axis. 0 where the CL data itself leads
        /// to the part, with a rapid as the first motion of each operation.
        distance_mm: f64 = 50.0, key("approach.distance", Measure::length(Bound::NotNegative));
    }
}

options! {
    /// Coolant around tool changes.
    pub struct CoolantOptions in "coolant" {
        /// Dwell before a tool change after coolant through the spindle, seconds.
        through_dwell_s: f64 = 0.0, key("coolant.through_dwell", Measure::plain(Bound::NotNegative).unless(no_dwell));
    }
}

/// Output of a rapid inside an operation that rotates no rotary axis by more than the index angle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Rapid {
    /// One block; the control decides the path.
    Direct,
    /// Two blocks, along the tool axis and across it: out first, in last.
    Split,
    /// Feed motion on a certified path.
    Feed,
}

impl Rapid {
    const NAMES: [(&'static str, Self); 3] = [("direct", Self::Direct), ("split", Self::Split), ("feed", Self::Feed)];
}

/// Rapids inside an operation that rotate a rotary axis by more than the index angle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Links {
    /// On the path of the CL data where every block is certified to keep to it, else by the safe sequence.
    Follow,
    /// By the safe sequence.
    Safe,
}

impl Links {
    const NAMES: [(&'static str, Self); 2] = [("follow", Self::Follow), ("safe", Self::Safe)];
}

/// Motion from one operation to the next.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Transition {
    /// Retract, rotate, approach.
    Safe,
    /// As in the CL data.
    Direct,
    /// As in the CL data over the clearance geometry, with the same tool and tool axis, else safe.
    Auto,
}

impl Transition {
    const NAMES: [(&'static str, Self); 3] = [("safe", Self::Safe), ("direct", Self::Direct), ("auto", Self::Auto)];
}

/// Rewind of the rotary axes where no course avoids it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Rewind {
    /// The tool leaves the part along its axis, the rotary axes rotate, and the tool returns.
    Leave,
    /// The rotary axes rotate in the cut: the tip stays in place, and the tool swings about it.
    Follow,
}

impl Rewind {
    const NAMES: [(&'static str, Self); 2] = [("leave", Self::Leave), ("follow", Self::Follow)];
}

impl Retract {
    /// Default machine coordinate of the retract axis, mm.
    pub const POSITION_MM: f64 = 0.0;

    /// Home position of another linear axis, machine coordinate, mm.
    #[must_use]
    pub fn home_mm(&self, letter: char) -> f64 {
        self.xy_mm.get(&letter).copied().unwrap_or(0.0)
    }

    /// Machine coordinate of the retract axis, mm.
    #[must_use]
    pub fn position_mm(&self) -> f64 {
        self.position_mm.unwrap_or(Self::POSITION_MM)
    }
}
