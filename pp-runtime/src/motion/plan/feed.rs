//! F words: mm/min while no rotary moves; where one does inverse time, or what the control counts along; and how long a
//! block takes.
//!
//! The tip keeps the programmed feed: a block takes its tip path over the feed. Longer only where an axis would turn or
//! travel faster than it can, where the control asks for a longest F or a shortest block, and then by as much as it needs.

use crate::motion::options::Policy;
use crate::motion::options::{Mode, PathNorm};
use crate::nc::Decimal;
use crate::program;
use crate::program::Units;

use crate::motion::fault::Fault;
use crate::motion::plan::abilities::Abilities;
use crate::motion::step::FeedWord;

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
    norm: PathNorm,
    /// The control keeps the tip on its path: F counts along that.
    along_tip: bool,
    /// Units of F in a unit of length.
    per_length: f64,
    /// F has this bound.
    bound: f64,
    /// Shortest block, minutes.
    shortest: f64,
    /// Largest feed of the control, mm/min.
    largest: f64,
}

/// One feed motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Stroke {
    /// Length of the tip path, mm.
    pub(crate) length: f64,
    /// Largest turn of a rotary axis, rad; zero where no rotary word changes.
    pub(crate) turn: f64,
    /// Length of the way of the linear axes, mm.
    pub(crate) linear: f64,
    /// Length of the way of the rotary axes, degrees.
    pub(crate) degrees: f64,
    /// The control's own path length is that of the tip while no rotary turns.
    pub(crate) square: bool,
    /// Minutes that the axes take at their largest speeds; 0 where these are not known.
    pub(crate) least: f64,
}

/// How fast a block runs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Pace {
    /// Its F word.
    pub(crate) feed: FeedWord,
    /// How long it takes, minutes.
    pub(crate) minutes: f64,
    /// How much longer than programmed that is, minutes.
    pub(crate) slowed: f64,
}

impl Feeds {
    pub(crate) fn new(policy: Policy<'_>, units: Units, still: f64, abilities: &Abilities) -> Self {
        Self {
            length_unit: units.in_mm(),
            decimals: policy.formats.feed,
            digits: policy.formats.inverse_time,
            norm: abilities.path_norm,
            along_tip: policy.options.mode != Mode::Axes,
            per_length: if units == Units::Inches { abilities.feed_per_inch } else { 1.0 },
            bound: 10_f64.powi(policy.formats.feed_whole as i32),
            reorient_speed: policy.options.rapids.reorient_speed,
            still,
            shortest: policy.options.feed.shortest_block / 60.0,
            largest: policy.options.feed.largest.unwrap_or(f64::INFINITY),
        }
    }

    /// F counts along the path of the control where a rotary axis moves.
    pub(crate) fn counts_path(&self) -> bool {
        self.along_tip || matches!(self.norm, PathNorm::Xyz | PathNorm::XyzDegrees)
    }

    /// mm in one unit of length of the program.
    pub(crate) fn length_unit(&self) -> f64 {
        self.length_unit
    }

    /// mm/min of an F per minute.
    pub(crate) fn mm_per_minute(&self, word: Decimal) -> f64 {
        word.value() * self.length_unit / self.per_length
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
    pub(crate) fn pace(&self, feed: f64, stroke: Stroke) -> Result<Pace, Fault> {
        let zero = |feed: f64| {
            Fault::new(format_args!("a feed of {feed} mm/min is written as F0"))
                .help("check the unit of FEDRAT, or give F more decimals")
        };
        if feed.is_nan() || feed <= 0.0 {
            return Err(zero(feed));
        }
        let programmed = self.programmed(feed, stroke);
        let minutes = programmed.max(stroke.least).max(self.shortest).max(self.path(stroke) / self.largest);
        let overflow = |_| Fault::new(format_args!("a feed of {feed} mm/min does not fit into a word"));
        let (feed, word) = if stroke.turn == 0.0 && stroke.square {
            // A way that is nothing but rounding is one unit of the words.
            let slowed = if minutes > programmed { stroke.length.max(self.still) / minutes } else { feed };
            let feed = feed.min(slowed).min(self.largest);
            let word = Decimal::fixed(feed / self.length_unit * self.per_length, self.decimals).map_err(overflow)?;
            (FeedWord::PerMinute(word), word)
        } else {
            let inverse = |time: f64| Decimal::significant(1.0 / time, self.digits).map_err(overflow);
            let along = |path: f64| Decimal::fixed(path / minutes, self.decimals).map_err(overflow);
            // Degrees have no unit of length.
            let lengths = stroke.linear > 0.0 && (!self.along_tip || stroke.length >= self.still);
            let in_units = if lengths { self.per_length / self.length_unit } else { 1.0 };
            match self.norm {
                PathNorm::G93Minutes if !self.along_tip => {
                    inverse(minutes).map(|word| (FeedWord::InverseTime(word), word))?
                }
                PathNorm::G93Seconds if !self.along_tip => {
                    inverse(minutes * 60.0).map(|word| (FeedWord::InverseTime(word), word))?
                }
                PathNorm::G93Minutes | PathNorm::G93Seconds | PathNorm::Xyz | PathNorm::XyzDegrees => {
                    along(self.path(stroke) * in_units).map(|word| (FeedWord::PerMinute(word), word))?
                }
            }
        };
        if word.value() >= self.bound {
            return Err(Fault::new(format_args!("an F of {} has more digits than the control holds", word.value()))
                .help(
                    "`[feed] largest` or `shortest_block` slow such blocks down; `[formats] feed_whole` are the digits",
                ));
        }
        if word.units <= 0 {
            return Err(zero(stroke.length / minutes));
        }
        Ok(Pace { feed, minutes, slowed: minutes - programmed })
    }

    /// What F counts along, mm; degrees where a rotary axis moves and no linear one does.
    fn path(&self, stroke: Stroke) -> f64 {
        let Stroke { length, linear, degrees, .. } = stroke;
        match self.norm {
            _ if stroke.turn == 0.0 && stroke.square => length,
            _ if self.along_tip && length < self.still => degrees,
            _ if self.along_tip => length,
            PathNorm::G93Minutes | PathNorm::G93Seconds => length,
            PathNorm::Xyz if linear > 0.0 => linear,
            PathNorm::XyzDegrees if linear > 0.0 => linear.hypot(degrees),
            PathNorm::Xyz | PathNorm::XyzDegrees => degrees,
        }
    }

    /// Minutes of a stroke as the CL data asks for it.
    fn programmed(&self, feed: f64, stroke: Stroke) -> f64 {
        let minutes = stroke.length / feed;
        let minutes = if stroke.length < self.still { minutes.max(stroke.turn / self.reorient_speed) } else { minutes };
        // Where neither tip nor tool axis moves by a unit any time will do: a minute in a thousand is a short one.
        if minutes > 0.0 { minutes } else { 1e-3 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::config::Config;

    fn abilities() -> Abilities {
        crate::control::abilities(&crate::control::LinuxCnc, Config::default().demands())
    }

    fn feeds(units: Units) -> Feeds {
        Feeds::new(Config::default().policy(), units, 1e-3, &abilities())
    }

    fn stroke(length: f64, degrees: f64) -> Stroke {
        Stroke { length, turn: degrees.to_radians(), square: true, least: 0.0, linear: length, degrees }
    }

    #[test]
    fn without_a_turn_f_is_length_per_minute() {
        let word = |units| feeds(units).pace(254.0, stroke(10.0, 0.0)).map(|pace| pace.feed);
        assert_eq!(word(Units::Millimetres), Ok(FeedWord::PerMinute(Decimal { units: 254_000, decimals: 3 })));
        assert_eq!(word(Units::Inches), Ok(FeedWord::PerMinute(Decimal { units: 10_000, decimals: 3 })));
    }

    #[test]
    fn with_a_turn_f_is_the_inverse_of_the_time_along_the_tip_path_in_any_unit() {
        for units in [Units::Millimetres, Units::Inches] {
            let pace = feeds(units).pace(300.0, stroke(7.0, 2.0)).expect("a pace");
            let FeedWord::InverseTime(word) = pace.feed else { panic!("inverse time") };
            assert_eq!((pace.minutes, pace.slowed), (7.0 / 300.0, 0.0));
            assert_eq!((word.units, word.decimals), (428_571, 4));
        }
    }

    #[test]
    fn a_tip_that_stands_still_takes_its_time_from_the_rotary() {
        let pace = feeds(Units::Millimetres).pace(300.0, stroke(0.0, 90.0)).expect("a pace");
        let FeedWord::InverseTime(word) = pace.feed else { panic!("inverse time") };
        assert!((word.value() - 20.0).abs() < 1e-9, "90° at 1800 °/min take a twentieth of a minute: {word:?}");
    }

    #[test]
    fn a_feed_that_rounds_to_zero_is_refused() {
        assert!(feeds(Units::Millimetres).pace(0.000_4, stroke(1.0, 0.0)).is_err());
        assert!(feeds(Units::Millimetres).pace(0.0, stroke(1.0, 1.0)).is_err());
        assert!(feeds(Units::Millimetres).pace(-5.0, stroke(1.0, 0.0)).is_err());
        assert!(feeds(Units::Millimetres).pace(f64::NAN, stroke(1.0, 0.0)).is_err());
    }

    #[test]
    fn a_block_that_goes_nowhere_has_an_f_where_blocks_are_stretched() {
        let mut config = Config::default();
        config.motion.feed.shortest_block = 0.12;
        let feeds = Feeds::new(config.policy(), Units::Millimetres, 1e-3, &abilities());
        let word = |length| feeds.pace(500.0, stroke(length, 0.0)).map(|pace| pace.feed);
        // One unit of the words in two thousandths of a minute.
        assert_eq!(word(0.0), Ok(FeedWord::PerMinute(Decimal { units: 500, decimals: 3 })));
        assert_eq!(word(0.0004), word(0.0));
        assert_eq!(word(0.1), Ok(FeedWord::PerMinute(Decimal { units: 50_000, decimals: 3 })));
        assert_eq!(word(5.0), Ok(FeedWord::PerMinute(Decimal { units: 500_000, decimals: 3 })));
    }

    #[test]
    fn a_block_is_slowed_by_exactly_what_an_axis_needs() {
        let slow = |degrees| Stroke { least: 0.25, ..stroke(10.0, degrees) };
        let pace = feeds(Units::Millimetres).pace(100.0, slow(30.0)).expect("a pace");
        assert_eq!((pace.minutes, pace.slowed), (0.25, 0.25 - 0.1));
        assert_eq!(pace.feed, FeedWord::InverseTime(Decimal { units: 400_000, decimals: 5 }));
        // Without a turn F per minute goes down.
        let pace = feeds(Units::Millimetres).pace(100.0, slow(0.0)).expect("a pace");
        assert_eq!(pace.feed, FeedWord::PerMinute(Decimal { units: 40_000, decimals: 3 }));
        let fast = feeds(Units::Millimetres).pace(20.0, slow(30.0)).expect("a pace");
        assert_eq!((fast.minutes, fast.slowed), (0.5, 0.0));
    }

    #[test]
    fn the_largest_feed_and_the_shortest_block_of_a_control_are_kept() {
        let mut config = Config::default();
        config.motion.feed.largest = Some(5000.0);
        config.motion.feed.shortest_block = 0.006;
        let feeds = Feeds::new(config.policy(), Units::Millimetres, 1e-3, &abilities());
        let pace = feeds.pace(20_000.0, stroke(10.0, 0.0)).expect("a pace");
        assert_eq!(pace.feed, FeedWord::PerMinute(Decimal { units: 5_000_000, decimals: 3 }));
        let pace = feeds.pace(4000.0, stroke(0.1, 1.0)).expect("a pace");
        assert!((pace.minutes - 1e-4).abs() < 1e-12 && pace.slowed > 0.0, "{pace:?}");
        // A way that is nothing but rounding, too.
        config.motion.feed.shortest_block = 0.0;
        let feeds = Feeds::new(config.policy(), Units::Millimetres, 1e-3, &abilities());
        for length in [0.0, 1e-5, 3e-4] {
            let pace = feeds.pace(20_000.0, stroke(length, 0.0)).expect("a pace");
            assert!(matches!(pace.feed, FeedWord::PerMinute(word) if word.value() <= 5000.0), "{length}: {pace:?}");
        }
    }

    #[test]
    fn feed_per_revolution_needs_a_speed() {
        assert_eq!(Feeds::per_minute(program::Feed::PerRevolution(0.1), Some(3000.0)), Ok(300.0));
        assert!(Feeds::per_minute(program::Feed::PerRevolution(0.1), None).is_err());
    }

    #[test]
    fn without_inverse_time_f_counts_what_the_control_counts() {
        let write = |word, prefix: &str| {
            let mut text = prefix.as_bytes().to_vec();
            crate::nc::write_decimal(&mut text, word);
            String::from_utf8(text).expect("ASCII")
        };
        let word = |norm, units, per_length, linear, degrees| {
            let abilities = Abilities { path_norm: norm, feed_per_inch: per_length, ..abilities() };
            let feeds = Feeds::new(Config::default().policy(), units, 1e-3, &abilities);
            // A tenth of a minute along the tip path.
            let pace = feeds.pace(100.0, Stroke { linear, degrees, ..stroke(10.0, 4.0) }).expect("a pace");
            match pace.feed {
                FeedWord::PerMinute(word) => write(word, "F"),
                FeedWord::InverseTime(word) => write(word, "inverse F"),
            }
        };
        let mm = Units::Millimetres;
        assert_eq!(word(PathNorm::XyzDegrees, mm, 1.0, 3.0, 4.0), "F50");
        assert_eq!(word(PathNorm::Xyz, mm, 1.0, 3.0, 4.0), "F30");
        assert_eq!(word(PathNorm::Xyz, mm, 1.0, 0.0, 4.0), "F40");
        assert_eq!(word(PathNorm::XyzDegrees, mm, 1.0, 0.0, 4.0), "F40");
        assert_eq!(word(PathNorm::G93Minutes, mm, 1.0, 3.0, 4.0), "inverse F10");
        assert_eq!(word(PathNorm::G93Seconds, mm, 1.0, 3.0, 4.0), "inverse F0.166667");
        assert_eq!(word(PathNorm::Xyz, Units::Inches, 10.0, 25.4, 4.0), "F100");
    }

    #[test]
    fn an_f_with_more_digits_than_the_control_holds_is_refused() {
        let config = |feed_whole| Config {
            formats: crate::nc::Formats { feed_whole, ..Config::default().formats },
            ..Config::default()
        };
        let pace = |feed_whole| {
            Feeds::new(config(feed_whole).policy(), Units::Millimetres, 1e-3, &abilities())
                .pace(10_000.0, stroke(5.0, 0.0))
        };
        assert!(pace(5).is_ok());
        assert!(pace(4).is_err());
    }
}
