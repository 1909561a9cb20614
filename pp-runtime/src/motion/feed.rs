//! F words: mm/min while no rotary moves, inverse time where one does.

use crate::config::{Config, Units};
use crate::nc::Decimal;
use crate::program;

use super::fault::Fault;
use super::step::Feed;

/// Computes F words.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Feeds {
    length_unit: f64,
    decimals: u32,
    digits: u32,
    /// rad/min.
    reorient_speed: f64,
    /// A tip path shorter than this stands still, mm: one unit of the linear words.
    still: f64,
}

/// One feed motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Stroke {
    /// Length of the tip path, mm.
    pub(crate) length: f64,
    /// Largest turn of a rotary axis, rad; zero where no rotary word changes.
    pub(crate) turn: f64,
    /// The control's own path length is that of the tip while no rotary turns.
    pub(crate) square: bool,
}

impl Feeds {
    pub(crate) fn new(config: &Config, units: Units, still: f64) -> Self {
        Self {
            length_unit: units.in_mm(),
            decimals: config.formats.feed,
            digits: config.formats.inverse_time,
            reorient_speed: config.reorient_speed,
            still,
        }
    }

    /// mm/min of a programmed feed; `speed`: rev/min of the spindle as written.
    pub(crate) fn per_minute(feed: program::Feed, speed: Option<f64>) -> Result<f64, Fault> {
        match feed {
            program::Feed::PerMinute(value) => Ok(value),
            program::Feed::PerRevolution(value) => speed.map(|speed| value * speed).ok_or_else(|| {
                Fault::new("a feed per revolution needs the spindle speed").help("give SPINDL/RPM before it")
            }),
        }
    }

    /// The F word of a stroke at `feed` mm/min.
    pub(crate) fn word(&self, feed: f64, stroke: Stroke) -> Result<Feed, Fault> {
        let zero = || {
            Fault::new(format_args!("a feed of {feed} mm/min is written as F0"))
                .help("check the unit of FEDRAT, or give F more decimals")
        };
        let overflow = |_| Fault::new(format_args!("a feed of {feed} mm/min does not fit into a word"));
        if stroke.turn == 0.0 && stroke.square {
            let word = Decimal::fixed(feed / self.length_unit, self.decimals).map_err(overflow)?;
            return if word.units > 0 { Ok(Feed::PerMinute(word)) } else { Err(zero()) };
        }
        if feed <= 0.0 {
            return Err(zero());
        }
        let mut minutes = stroke.length / feed;
        if stroke.length < self.still {
            minutes = minutes.max(stroke.turn / self.reorient_speed);
        }
        if minutes <= 0.0 {
            // Neither tip nor tool axis moves by a unit: any time will do, a minute in a thousand is a short one.
            minutes = 1e-3;
        }
        let word = Decimal::significant(1.0 / minutes, self.digits).map_err(overflow)?;
        if word.units > 0 { Ok(Feed::InverseTime(word)) } else { Err(zero()) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn feeds(units: Units) -> Feeds {
        Feeds::new(&Config::default(), units, 1e-3)
    }

    fn stroke(length: f64, degrees: f64) -> Stroke {
        Stroke { length, turn: degrees.to_radians(), square: true }
    }

    #[test]
    fn without_a_turn_f_is_length_per_minute() {
        let word = |units| feeds(units).word(254.0, stroke(10.0, 0.0));
        assert_eq!(word(Units::Millimetres), Ok(Feed::PerMinute(Decimal { units: 254_000, decimals: 3 })));
        assert_eq!(word(Units::Inches), Ok(Feed::PerMinute(Decimal { units: 10_000, decimals: 3 })));
    }

    #[test]
    fn with_a_turn_f_is_the_inverse_of_the_time_along_the_tip_path_in_any_unit() {
        for units in [Units::Millimetres, Units::Inches] {
            let Ok(Feed::InverseTime(word)) = feeds(units).word(300.0, stroke(7.0, 2.0)) else {
                panic!("inverse time")
            };
            assert_eq!((word.units, word.decimals), (428_571, 4));
        }
    }

    #[test]
    fn a_tip_that_stands_still_takes_its_time_from_the_rotary() {
        let Ok(Feed::InverseTime(word)) = feeds(Units::Millimetres).word(300.0, stroke(0.0, 90.0)) else {
            panic!("inverse time")
        };
        assert!((word.value() - 20.0).abs() < 1e-9, "90° at 1800 °/min take a twentieth of a minute: {word:?}");
    }

    #[test]
    fn a_feed_that_rounds_to_zero_is_refused() {
        assert!(feeds(Units::Millimetres).word(0.000_4, stroke(1.0, 0.0)).is_err());
        assert!(feeds(Units::Millimetres).word(0.0, stroke(1.0, 1.0)).is_err());
        assert!(feeds(Units::Millimetres).word(-5.0, stroke(1.0, 0.0)).is_err());
        assert!(feeds(Units::Millimetres).word(f64::NAN, stroke(1.0, 0.0)).is_err());
    }

    #[test]
    fn feed_per_revolution_needs_a_speed() {
        assert_eq!(Feeds::per_minute(program::Feed::PerRevolution(0.1), Some(3000.0)), Ok(300.0));
        assert!(Feeds::per_minute(program::Feed::PerRevolution(0.1), None).is_err());
    }
}
