//! How many digits words have.

use crate::program::Units;

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

impl Default for Formats {
    fn default() -> Self {
        Self::DEFAULT
    }
}
