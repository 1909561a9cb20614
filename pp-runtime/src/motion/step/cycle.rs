//! Cycles of a control: what it has, and one hole by one of them.

use crate::nc::Decimal;

use crate::motion::step::AxisWords;

/// Cycles of a control.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct CycleAbilities {
    /// In and out, with a wait at the bottom or without.
    pub drill: bool,
    /// With a retreat to the clearance level after each step.
    pub peck: bool,
    /// With a short retreat after each step, as far as the control is set to.
    pub chip_break: bool,
    /// Out at feed.
    pub ream: bool,
    /// Out at feed to the clearance level, and at rapid from there to a higher one.
    pub ream_higher: bool,
    /// With spindle and feed in step.
    pub tap: bool,
    /// With a wait at the bottom of a thread.
    pub tap_dwell: bool,
    /// With a wait at the bottom of a hole in steps.
    pub peck_dwell: bool,
    /// Longest wait, milliseconds.
    pub longest_dwell_ms: u32,
    /// It comes back to any level, wherever it began.
    pub returns_to_any_level: bool,
    /// It is told how far to go back between two steps, and how near to come again.
    pub programs_gap: bool,
    /// It shares out what is left for the last two steps: only whole steps are what they are.
    pub whole_steps_only: bool,
    /// The spindle stands behind a thread.
    pub tap_stops_spindle: bool,
    /// A thread is cut with F.
    pub tap_uses_feed: bool,
    /// Decimals of a pitch.
    pub pitch_decimals: u32,
}

impl CycleAbilities {
    /// Of a control whose cycles are codes with X Y Z R: they begin at the level to which they go back, and their short
    /// retreats are settings of the machine.
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
        whole_steps_only: false,
        tap_stops_spindle: false,
        tap_uses_feed: false,
        pitch_decimals: 6,
    };
}

/// What a cycle does in a hole; lengths in whole units of linear words.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum CannedKind {
    /// In at feed, out at rapid.
    Drill,
    /// In steps, out to the clearance level after each.
    Peck {
        /// Depth of a step.
        step: i64,
        /// How near at rapid to where the last step ended.
        gap: i64,
    },
    /// In steps, a little back after each.
    ChipBreak {
        /// Depth of a step.
        step: i64,
        /// How far back.
        gap: i64,
    },
    /// In and out at feed.
    Ream,
    /// A thread.
    Tap {
        /// Units of length per turn.
        pitch: Decimal,
        /// Left-hand.
        left: bool,
        /// rev/min.
        speed: Decimal,
    },
}

/// A hole by a cycle along Z; levels are words of Z.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CannedCycle {
    /// What it does.
    pub kind: CannedKind,
    /// Where: X and Y.
    pub words: AxisWords,
    /// Position of Z in the chain.
    pub z: usize,
    /// The top of the hole.
    pub surface: i64,
    /// Where feed begins.
    pub clearance: i64,
    /// The bottom.
    pub bottom: i64,
    /// Where the tool stands afterwards: at the clearance level, or higher where it stood before.
    pub back: i64,
    /// Wait at the bottom, seconds.
    pub dwell: Option<f64>,
    /// Units of the control's path per minute.
    pub feed: Decimal,
}

impl CannedCycle {
    /// Another hole of the same.
    pub(crate) fn repeats(&self, before: &Self) -> bool {
        Self { words: before.words, ..*self } == *before
    }
}
