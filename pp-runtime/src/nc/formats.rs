//! Digits of the numbers in words.

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
        /// Decimals of F per minute and per revolution.
        feed: u32 = 3, key("formats.feed", Whole(0..=6));
        /// Significant digits of F in inverse-time feed.
        inverse_time: u32 = 6, key("formats.inverse_time", Whole(6..=12));
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
}
