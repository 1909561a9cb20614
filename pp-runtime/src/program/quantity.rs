//! Lengths and feeds in messages: in the unit of the file, and without the noise of binary arithmetic.
//!
//! Inside, everything is in mm; `0.75 in` is 19.049999999999997 mm there. A message has at most seven significant
//! digits: a micrometre in a position of metres.

use std::fmt::{self, Display, Formatter};

use super::Units;

/// Significant digits of a number in a message.
const DIGITS: i32 = 7;

/// A number of a message: seven significant digits, without zeros at the end.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Shown(pub(crate) f64);

impl Display for Shown {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let value = self.0;
        // Zero has no digits; what is not finite has none, either.
        let decade = if value == 0.0 || !value.is_finite() {
            0
        } else {
            crate::kinematics::math::log10(value.abs()).floor() as i32
        };
        let decimals = (DIGITS - 1 - decade).clamp(0, 12) as usize;
        let text = format!("{value:.decimals$}");
        let text = if decimals > 0 { text.trim_end_matches('0').trim_end_matches('.') } else { &text };
        f.write_str(if text == "-0" { "0" } else { text })
    }
}

/// A number and its unit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Quantity {
    value: f64,
    /// Decimals, where they are fixed.
    decimals: Option<usize>,
    unit: &'static str,
}

impl Quantity {
    /// Whether all its digits are zeros.
    pub(crate) fn is_zero(self) -> bool {
        !self.number().contains(|c: char| ('1'..='9').contains(&c))
    }

    /// The number without its unit.
    pub(crate) fn number(self) -> String {
        match self.decimals {
            Some(decimals) => format!("{:.decimals$}", self.value),
            None => Shown(self.value).to_string(),
        }
    }
}

impl Display for Quantity {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        write!(f, "{} {}", self.number(), self.unit)
    }
}

impl Units {
    /// The unit that is so many mm long.
    pub(crate) fn of_length(in_mm: f64) -> Self {
        if in_mm > Self::Millimetres.in_mm() { Self::Inches } else { Self::Millimetres }
    }

    /// A length in this unit.
    pub(crate) fn length(self, mm: f64) -> Quantity {
        Quantity { value: mm / self.in_mm(), decimals: None, unit: self.name() }
    }

    /// A deviation in this unit: 4 decimals in mm, 5 in inches.
    pub(crate) fn deviation(self, mm: f64) -> Quantity {
        let decimals = match self {
            Self::Millimetres => 4,
            Self::Inches => 5,
        };
        Quantity { value: mm / self.in_mm(), decimals: Some(decimals), unit: self.name() }
    }

    /// A coordinate or a travel in this unit: 3 decimals in mm, 4 in inches.
    pub(crate) fn coordinate(self, mm: f64) -> Quantity {
        let decimals = match self {
            Self::Millimetres => 3,
            Self::Inches => 4,
        };
        Quantity { value: mm / self.in_mm(), decimals: Some(decimals), unit: self.name() }
    }

    /// A feed per minute in this unit.
    pub(crate) fn feed(self, mm_per_min: f64) -> Quantity {
        let unit = match self {
            Self::Millimetres => "mm/min",
            Self::Inches => "in/min",
        };
        Quantity { value: mm_per_min / self.in_mm(), decimals: None, unit }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_of_a_message_has_seven_digits_and_no_noise() {
        let shown = |value: f64| Shown(value).to_string();
        assert_eq!(shown(749.960_399_999_999_9), "749.9604");
        assert_eq!(shown(0.75 * 25.4), "19.05");
        assert_eq!([0.0, -0.0, 100.0, 1e7, 12_345_678.9].map(shown), ["0", "0", "100", "10000000", "12345679"]);
        assert_eq!([1.0 / 3.0, -1.0 / 26.0, 1e-20].map(shown), ["0.3333333", "-0.03846154", "0"]);
        assert_eq!(shown(f64::INFINITY), "inf");
    }

    #[test]
    fn lengths_and_feeds_are_in_the_unit_of_the_file() {
        let (mm, inch) = (Units::Millimetres, Units::Inches);
        assert_eq!(inch.length(19.049_999_999_999_997).to_string(), "0.75 in");
        assert_eq!(mm.length(19.049_999_999_999_997).to_string(), "19.05 mm");
        assert_eq!(inch.feed(396.875).to_string(), "15.625 in/min");
        assert_eq!(mm.feed(396.875).to_string(), "396.875 mm/min");
        assert_eq!(inch.deviation(0.012_34).to_string(), "0.00049 in");
        assert_eq!(mm.deviation(0.012_34).to_string(), "0.0123 mm");
        assert_eq!([mm, inch].map(|units| units.coordinate(-50.8).to_string()), ["-50.800 mm", "-2.0000 in"]);
        assert_eq!(mm.deviation(1.0).to_string(), "1.0000 mm");
        assert!(mm.deviation(-0.000_04).is_zero() && !mm.deviation(0.000_06).is_zero());
        assert_eq!([Units::of_length(1.0), Units::of_length(25.4)], [mm, inch]);
    }
}
