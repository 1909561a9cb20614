//! Digits of the numbers in words.

use crate::keys::{Whole, options};
use crate::program::Units;

options! {
    /// Decimals of the words; significant digits for inverse-time feed.
    pub struct Formats in "formats", const DEFAULT {
        /// Decimals of linear words in mm.
        linear_mm: u32 = 3, also("formats.linear_mm", Whole(0..=6));
        /// Decimals of linear words in inches.
        linear_inch: u32 = 4, also("formats.linear_inch", Whole(0..=6));
        /// Decimals of rotary words in degrees.
        rotary: u32 = 4, also("formats.rotary", Whole(0..=6));
        /// Decimals of F per minute and per revolution.
        feed: u32 = 3, also("formats.feed", Whole(0..=6));
        /// Significant digits of an inverse-time F.
        inverse_time: u32 = 6, also("formats.inverse_time", Whole(6..=12));
        /// Decimals of S.
        speed: u32 = 0, also("formats.speed", Whole(0..=3));
        /// Digits before the point: a number with more is refused.
        linear_whole: u32 = 9, key("formats.linear_whole", Whole(1..=9));
        /// Digits of rotary words before the point.
        rotary_whole: u32 = 9, also("formats.rotary_whole", Whole(1..=9));
        /// Digits of F before the point.
        feed_whole: u32 = 15, also("formats.feed_whole", Whole(1..=15));
        /// Digits of S before the point.
        speed_whole: u32 = 9, also("formats.speed_whole", Whole(1..=9));
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
}
