//! Digits of the numbers in words, and from what a number is computed.
//!
//! A word is computed from the exact numbers of the CL data, rounded once, and never from a word that has been rounded.
//! Where the control derives a number from words, that number is judged as it follows from the rounded words, by the
//! planner and by the check:
//!
//! | number | who computes it | from |
//! |---|---|---|
//! | pitch of a thread | CL data: PITCH, TPI, IPR, or feed over speed | the feed and the speed of the CL data, exact (`Hole`, `ResolvedSpindle`) |
//! | K of G33.1, F of G84 in G95, PIT of CYCLE84, Q239 | the writer | the exact pitch |
//! | F of G84 in G94 | the writer | the exact pitch, and S as written: the control multiplies by that |
//! | pitch of G84 in G94 | the control | F and S as written |
//! | F per minute, also of a feed per revolution | the writer | the exact feed, and S as written: the spindle rotates so |
//! | F in G93 | the writer | the time of the block, by the exact feed and the length of the rounded words: that is what moves |
//! | time of a block in G93 | the control | F as written |
//! | F along a path of the control | the writer | the same time, and the path of the rounded words |
//! | linear words | the writer | the exact tip, at the rounded angles of the rotary axes |
//! | dwell in revolutions | the writer | the revolutions of the CL data, and S as written |
//!
//! Words of lengths have decimals of their own in inches. 1/min of inverse time, seconds, degrees and rev/min have no
//! unit of length: their digits are the same in both.

use super::number::MOST_SIGNIFICANT;
use crate::keys::{Whole, options};
use crate::program::Units;

options! {
    /// Digits of the numbers in words. Trailing zeros are not written.
    pub struct Formats in "formats", const DEFAULT {
        /// Decimals of linear words in mm.
        linear_mm: u32 = 3, key("formats.linear_mm", Whole(0..=6));
        /// Decimals of linear words in inches.
        linear_inch: u32 = 4, key("formats.linear_inch", Whole(0..=6));
        /// Decimals of rotary words in degrees.
        rotary: u32 = 4, key("formats.rotary", Whole(0..=6));
        /// Decimals of F per minute in mm.
        feed: u32 = 3, key("formats.feed", Whole(0..=6));
        /// Decimals of F per minute in inches (Heidenhain: in tenths of an inch).
        feed_inch: u32 = 3, key("formats.feed_inch", Whole(0..=6));
        /// Decimals of the pitch of a thread in mm: K of G33.1, F in G95, PIT of CYCLE84, Q239.
        pitch_mm: u32 = 6, key("formats.pitch_mm", Whole(0..=6));
        /// Decimals of the pitch of a thread in inches.
        pitch_inch: u32 = 6, key("formats.pitch_inch", Whole(0..=6));
        /// Significant digits of F in inverse-time feed, whose unit is 1/min in any unit of length.
        inverse_time: u32 = 6, key("formats.inverse_time", Whole(6..=MOST_SIGNIFICANT));
        /// Decimals of S.
        speed: u32 = 0, key("formats.speed", Whole(0..=3));
        /// Largest number of digits of linear words before the point; a number with more is refused.
        linear_whole: u32 = 9, key("formats.linear_whole", Whole(1..=9));
        /// Largest number of digits of rotary words before the point.
        rotary_whole: u32 = 9, key("formats.rotary_whole", Whole(1..=9));
        /// Largest number of digits of F before the point.
        feed_whole: u32 = 15, key("formats.feed_whole", Whole(1..=15));
        /// Largest number of digits of S before the point.
        speed_whole: u32 = 9, key("formats.speed_whole", Whole(1..=9));
    }
}

impl Formats {
    /// Decimals of linear words.
    #[must_use]
    pub fn linear(&self, units: Units) -> u32 {
        match units {
            Units::Millimetres => self.linear_mm,
            Units::Inches => self.linear_inch,
        }
    }

    /// Decimals of F per minute.
    #[must_use]
    pub fn feed_decimals(&self, units: Units) -> u32 {
        match units {
            Units::Millimetres => self.feed,
            Units::Inches => self.feed_inch,
        }
    }

    /// Decimals of a pitch.
    #[must_use]
    pub fn pitch_decimals(&self, units: Units) -> u32 {
        match units {
            Units::Millimetres => self.pitch_mm,
            Units::Inches => self.pitch_inch,
        }
    }
}
