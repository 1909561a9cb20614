//! Drilling and tapping cycles: the abilities of a control, and one hole as a cycle.

use crate::nc::Decimal;

use crate::motion::step::AxisWords;
use crate::options::BoreRetract;

/// Cycles that a control has.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct CycleAbilities {
    /// Drilling: in at feed, out at rapid, with or without a dwell at the bottom.
    pub drill: bool,
    /// Deep-hole drilling with a return to the clearance level after each step.
    pub peck: bool,
    /// Drilling with a short retract after each step to break the chip, by a distance set in the control.
    pub chip_break: bool,
    /// Reaming: in and out at feed.
    pub ream: bool,
    /// Reaming out at feed to the clearance level, and at rapid from there to a higher level.
    pub ream_higher: bool,
    /// Tapping with spindle and feed synchronised.
    pub tap: bool,
    /// Tapping with a dwell at the bottom.
    pub tap_dwell: bool,
    /// Drilling in steps with a dwell at the bottom.
    pub peck_dwell: bool,
    /// Longest dwell, ms.
    pub longest_dwell_ms: u32,
    /// Return to any level, independent of the level at which the cycle began.
    pub returns_to_any_level: bool,
    /// The retract between two steps, and the gap left by the rapid that follows it, are parameters of the cycle.
    pub programs_gap: bool,
    /// Tapping is a motion along Z from where the tool is, over the hole.
    pub tap_is_motion: bool,
    /// The spindle is off after tapping.
    pub tap_stops_spindle: bool,
    /// Tapping takes an F word.
    pub tap_uses_feed: bool,
    /// F of tapping may be the pitch, in feed per revolution.
    pub tap_per_revolution: bool,
    /// Boring with an oriented spindle, if the control has it.
    pub fine_bore: Option<FineBoreAbility>,
    /// Why cycles that the control has are not used.
    pub unused: Option<UnusedCycles>,
}

/// Why cycles of a control are not used.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum UnusedCycles {
    /// They run the master spindle, and the tool is in another one: threads and bores.
    OtherSpindle,
    /// Their words are X, Y and Z, and one of these axes has another name.
    AxisNames,
}

/// Boring with an oriented spindle.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct FineBoreAbility {
    /// The program states the angle at which the spindle stops. Otherwise it is set in the machine.
    pub states_angle: bool,
    /// Distance by which the control moves the tool off the wall, µm; `None`: the program states it.
    pub fixed_shift_um: Option<u32>,
    /// The spindle is off after the cycle, which switches it on by itself.
    pub stops_spindle: bool,
}

impl CycleAbilities {
    /// Cycles that are codes with X Y Z R: they begin at the level to which they return, and their short retracts are
    /// settings of the machine.
    pub const CODES: Self = Self {
        drill: true,
        peck: true,
        chip_break: true,
        ream: true,
        ream_higher: false,
        tap: true,
        tap_dwell: false,
        peck_dwell: false,
        longest_dwell_ms: u32::MAX,
        returns_to_any_level: false,
        programs_gap: false,
        tap_is_motion: false,
        tap_stops_spindle: false,
        tap_uses_feed: false,
        tap_per_revolution: false,
        fine_bore: None,
        unused: None,
    };
}

/// Kind of a cycle; lengths in whole units of linear words.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum CannedKind {
    /// In at feed, out at rapid.
    Drill,
    /// In steps, out to the clearance level after each.
    Peck {
        /// Depth of a step.
        step: i64,
        /// Distance left above the end of the last step by the rapid back in.
        gap: i64,
    },
    /// In steps, with a short retract after each.
    ChipBreak {
        /// Depth of a step.
        step: i64,
        /// Retract after a step.
        gap: i64,
    },
    /// In and out at feed.
    Ream,
    /// In at feed, spindle stopped at an angle, off the wall, out at rapid.
    FineBore {
        /// Direction in which the tool leaves the wall.
        direction: BoreRetract,
        /// Distance by which it does.
        shift: i64,
        /// Angle at which the spindle stops, degrees.
        orient: Decimal,
        /// The spindle runs counter-clockwise.
        left: bool,
    },
    /// Tapping.
    Tap {
        /// Units of length per revolution.
        pitch: Decimal,
        /// Left-hand thread.
        left: bool,
        /// Spindle speed, rev/min.
        speed: Decimal,
    },
}

/// A hole by a cycle along Z; levels are Z words.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CannedCycle {
    /// Kind of the cycle.
    pub kind: CannedKind,
    /// X and Y of the hole.
    pub words: AxisWords,
    /// Position of Z in the chain.
    pub z: usize,
    /// Top of the hole.
    pub surface: i64,
    /// Clearance level (R), at which the feed begins.
    pub clearance: i64,
    /// Bottom of the hole.
    pub bottom: i64,
    /// Return level: the clearance level, or a higher one.
    pub back: i64,
    /// Dwell at the bottom, s.
    pub dwell: Option<f64>,
    /// Feed, units of the control's path per minute.
    pub feed: Decimal,
}

impl CannedCycle {
    /// Whether this is another hole of the same cycle.
    pub(crate) fn repeats(&self, before: &Self) -> bool {
        let Self { kind, words: _, z, surface, clearance, bottom, back, dwell, feed } = self;
        (kind, z, surface, clearance) == (&before.kind, &before.z, &before.surface, &before.clearance)
            && (bottom, back, dwell, feed) == (&before.bottom, &before.back, &before.dwell, &before.feed)
    }
}
