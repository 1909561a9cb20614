//! F words, and the time of each block.
//!
//! While no rotary axis moves, F is in mm/min (or inch/min). Where one moves, F is inverse time, or counts along the
//! path that the control measures: see [`PathNorm`].
//!
//! The tip keeps the programmed feed: the time of a block is the length of its tip path over the feed. Where the axes
//! lead the tip along a curve within the tolerance, or unevenly, as near a pole, the block takes so long that the tip
//! is nowhere faster than programmed by more than a hundredth ([`FASTER`]). A block takes longer only where an axis
//! would exceed its largest speed, where F would exceed `feed.largest` or `feed.largest_inverse_time`, where F of a
//! rotation would have more digits than its word, or where the block would be shorter than `feed.shortest_block`; and
//! then by no more than necessary. For `shortest_block` no F is below the smallest that its word can hold: such a block
//! is as long as that F makes it.

use crate::diag::code::plan;
use crate::kinematics::math::{self, larger};
use crate::motion::policy::Policy;
use crate::nc::Decimal;
use crate::options::{PathNorm, StretchMode};
use crate::program;
use crate::program::{Shown, Units};

use crate::motion::fault::Fault;
use crate::motion::plan::abilities::Abilities;
use crate::motion::step::FeedWord;
use crate::tolerance::writer::{FASTER, RESTING_BLOCK, ROUNDED_BLOCK_LENGTH};

/// Computes F words.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Feeds {
    units: Units,
    /// Unit of length of the program, mm.
    unit_mm: f64,
    feed_decimals: u32,
    /// Significant digits of an inverse-time F.
    inverse_time_digits: u32,
    reorient_rad_per_min: f64,
    /// Tip paths shorter than this count as no motion, mm: one unit of the linear words.
    smallest_length_mm: f64,
    path_norm: PathNorm,
    /// The control keeps the tip on its path, and F counts along that.
    along_tip: bool,
    /// Minutes in the unit of time of an inverse-time F, as a factor; `None` where F of a rotation counts along a path.
    inverse_per_min: Option<f64>,
    /// Units of F in one unit of length.
    feed_per_unit: f64,
    /// F words are smaller than this.
    feed_bound: f64,
    /// Largest F per minute.
    largest_word: f64,
    shortest_block_min: f64,
    /// Largest feed of the control.
    largest_mm_per_min: f64,
    /// Largest F of inverse-time feed, and one that its digits cannot round beyond that.
    largest_inverse_time: f64,
    largest_before_rounding: f64,
}

/// One feed motion: lengths of its paths, and the least time that it takes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct FeedMotion {
    /// Distance of the ends of the tip path.
    pub(crate) length_mm: f64,
    /// Largest speed of the tip times the time of the block, where the axes lead it unevenly; else at most its length.
    pub(crate) tip_rate_mm: f64,
    /// Largest rotation of a rotary axis; zero where no rotary word changes.
    pub(crate) rotation_rad: f64,
    /// Length of the path of the linear axes.
    pub(crate) linear_mm: f64,
    /// Length of the path of the rotary axes.
    pub(crate) rotary_degrees: f64,
    /// The linear axes are orthogonal: while no rotary axis moves, the path of the control is as long as that of the
    /// tip.
    pub(crate) orthogonal: bool,
    /// Time that the axes take at their largest speeds; 0 where these are unknown.
    pub(crate) axis_time_min: f64,
}

impl FeedMotion {
    /// A motion of orthogonal linear axes alone.
    pub(crate) fn linear(length_mm: f64, axis_time_min: f64) -> Self {
        Self {
            length_mm,
            tip_rate_mm: length_mm,
            rotation_rad: 0.0,
            linear_mm: length_mm,
            rotary_degrees: 0.0,
            orthogonal: true,
            axis_time_min,
        }
    }
}

/// F word and time of a block.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Pace {
    /// F word.
    pub(crate) feed: FeedWord,
    /// Time of the block.
    pub(crate) time_min: f64,
    /// Time beyond that of the programmed feed.
    pub(crate) slowed_min: f64,
}

impl Feeds {
    pub(crate) fn new(policy: Policy<'_>, units: Units, smallest_length_mm: f64, abilities: &Abilities) -> Self {
        let (whole, digits) = (policy.formats.feed_whole as i32, policy.formats.inverse_time as i32);
        let (feed_bound, last_digit) = (10_f64.powi(whole), 10_f64.powi(whole - digits));
        let largest_inverse_time = abilities.largest_inverse_time.min(feed_bound - last_digit);
        let mut feeds = Self {
            units,
            unit_mm: units.in_mm(),
            feed_decimals: policy.formats.feed_decimals(units),
            inverse_time_digits: policy.formats.inverse_time,
            path_norm: abilities.path_norm,
            along_tip: false,
            inverse_per_min: None,
            feed_per_unit: if units == Units::Inches { abilities.feed_per_inch } else { 1.0 },
            feed_bound,
            largest_word: feed_bound - 10_f64.powi(-(policy.formats.feed_decimals(units) as i32)),
            reorient_rad_per_min: policy.options.rapids.reorient_rad_per_min,
            smallest_length_mm,
            shortest_block_min: policy.options.feed.shortest_block_s / 60.0,
            largest_mm_per_min: policy.options.feed.largest_mm_per_min.unwrap_or(f64::INFINITY),
            largest_inverse_time,
            largest_before_rounding: largest_inverse_time * (1.0 - 10_f64.powi(1 - digits)),
        };
        feeds.set_mode(policy.options.mode_of_all().unwrap_or_default());
        feeds
    }

    /// Sets the mode of the stretch that begins.
    pub(crate) fn set_mode(&mut self, mode: StretchMode) {
        self.along_tip = mode != StretchMode::Axes;
        self.inverse_per_min = match self.path_norm {
            PathNorm::G93Minutes if !self.along_tip => Some(1.0),
            PathNorm::G93Seconds if !self.along_tip => Some(60.0),
            PathNorm::G93Minutes | PathNorm::G93Seconds | PathNorm::Xyz | PathNorm::XyzDegrees => None,
        };
    }

    /// Whether F counts along the path of the control where a rotary axis moves.
    pub(crate) fn counts_path(&self) -> bool {
        self.inverse_per_min.is_none()
    }

    /// Largest speed of the tip, times the time of a block of this length, that does not slow the block down, mm.
    pub(crate) fn largest_tip_rate_mm(&self, length_mm: f64) -> f64 {
        FASTER * length_mm + ROUNDED_BLOCK_LENGTH * self.smallest_length_mm
    }

    /// Unit of length of the program.
    pub(crate) fn units(&self) -> Units {
        self.units
    }

    /// An F per minute that differs from a feed by at most this share of it needs so many decimals; `None` if no format
    /// has as many.
    pub(crate) fn decimals_within(&self, feed: f64, share: f64) -> Option<u32> {
        let value = feed / self.unit_mm * self.feed_per_unit;
        decimals_within(value, share)
    }

    /// Feed of an F per minute, mm/min.
    pub(crate) fn mm_per_minute(&self, word: Decimal) -> f64 {
        word.value() * self.unit_mm / self.feed_per_unit
    }

    /// Programmed feed, mm/min. `speed_rev_per_min`: spindle speed as written.
    pub(crate) fn per_minute(feed: program::Feed, speed_rev_per_min: Option<f64>) -> Result<f64, Fault> {
        match feed {
            program::Feed::PerMinute(value) => Ok(value),
            program::Feed::PerRevolution(value) => speed_rev_per_min
                .map(|speed| value * speed)
                .ok_or_else(|| plan::FEED.fault("a feed per revolution needs the spindle speed")),
        }
    }

    /// F word and time of a motion at `feed`, mm/min.
    #[inline(always)]
    pub(crate) fn pace(&self, feed: f64, motion: FeedMotion) -> Result<Pace, Fault> {
        if feed.is_nan() || feed <= 0.0 {
            return Err(written_as_zero(feed, self.units));
        }
        let programmed_min = self.programmed_min(feed, motion);
        let plain = motion.rotation_rad == 0.0 && motion.orthogonal;
        let path = self.path_length(motion);
        // Degrees have no unit of length.
        let lengths = motion.linear_mm > 0.0 && (!self.along_tip || motion.length_mm >= self.smallest_length_mm);
        let in_units = if lengths { self.feed_per_unit / self.unit_mm } else { 1.0 };
        // F of a motion that rotates has no more digits than the control holds.
        let digits_min = match self.inverse_per_min {
            _ if plain => 0.0,
            Some(per_min) => 1.0 / (per_min * self.largest_inverse_time),
            None => path * in_units / self.largest_word,
        };
        let least_min = larger(motion.axis_time_min, digits_min);
        let needed_min = larger(larger(path / self.largest_mm_per_min, least_min), programmed_min);
        let mut time_min = larger(needed_min, self.shortest_block_min);
        let per_minute = |value: f64| self.per_minute_word(feed, value, time_min, needed_min);
        let (feed, word) = match self.inverse_per_min {
            _ if plain => {
                // A motion of nothing but rounding counts as one unit of the words.
                let length_mm = motion.length_mm.max(self.smallest_length_mm);
                let slowed = if time_min > programmed_min { length_mm / time_min } else { feed };
                let feed = feed.min(slowed).min(self.largest_mm_per_min);
                let word = per_minute(feed / self.unit_mm * self.feed_per_unit)?;
                (FeedWord::PerMinute(word), word)
            }
            Some(per_min) => {
                let inverse = 1.0 / (time_min * per_min);
                let word =
                    Decimal::significant(inverse, self.inverse_time_digits).map_err(|_| too_large(feed, self.units))?;
                // Rounding must not lead beyond the limit.
                let is_beyond = inverse > self.largest_before_rounding && word.value() > self.largest_inverse_time;
                let word = if is_beyond { self.largest_word()? } else { word };
                (FeedWord::InverseTime(word), word)
            }
            None => {
                let word = per_minute(path * in_units / time_min)?;
                (FeedWord::PerMinute(word), word)
            }
        };
        if word.units <= 0 {
            return Err(written_as_zero(motion.length_mm / time_min, self.units));
        }
        if let FeedWord::PerMinute(_) = feed
            && word.units == 1
            && time_min > needed_min
        {
            let path = path.max(if plain { self.smallest_length_mm } else { 0.0 });
            time_min = time_min.min(needed_min.max(path * in_units / word.value()));
        }
        Ok(Pace { feed, time_min, slowed_min: time_min - programmed_min })
    }

    /// F of this value per minute. A block that is slowed down from `needed_min` to `time_min`, for `shortest_block`
    /// alone, has the smallest F at least.
    fn per_minute_word(&self, feed: f64, value: f64, time_min: f64, needed_min: f64) -> Result<Decimal, Fault> {
        let word = Decimal::fixed(value, self.feed_decimals).map_err(|_| too_large(feed, self.units))?;
        let smallest = Decimal { units: 1, ..word };
        let slowed = word.units <= 0 && value * time_min / needed_min >= smallest.value();
        let word = if slowed { smallest } else { word };
        if word.value() < self.feed_bound {
            return Ok(word);
        }
        let text = format!("F{} has more digits than an F word of this control", Shown(word.value()));
        Err(plan::FEED.fault(text).help(
            "`[feed] largest` or `shortest_block` slows such blocks down; `[formats] feed_whole` is the number of digits \
             before the decimal point",
        ))
    }

    /// Largest F of inverse-time feed, rounded down to its digits.
    fn largest_word(&self) -> Result<Decimal, Fault> {
        let digits = self.inverse_time_digits;
        let whole = math::log10(self.largest_inverse_time).floor() as i32 + 1;
        let decimals = (digits as i32 - whole).max(0) as u32;
        let nearest = Decimal::fixed(self.largest_inverse_time, decimals);
        let word = nearest.map_err(|_| plan::FEED.fault("`feed.largest_inverse_time` is too large for an F word"))?;
        let beyond = word.value() > self.largest_inverse_time;
        Ok(Decimal { units: word.units - i64::from(beyond), ..word })
    }

    /// Length of the path that F counts along, mm; in degrees where a rotary axis moves and no linear axis does.
    #[inline(always)]
    fn path_length(&self, motion: FeedMotion) -> f64 {
        let FeedMotion { length_mm, linear_mm, rotary_degrees, .. } = motion;
        match self.path_norm {
            _ if motion.rotation_rad == 0.0 && motion.orthogonal => length_mm,
            _ if self.along_tip && length_mm < self.smallest_length_mm => rotary_degrees,
            _ if self.along_tip => length_mm,
            PathNorm::G93Minutes | PathNorm::G93Seconds => length_mm,
            PathNorm::Xyz if linear_mm > 0.0 => linear_mm,
            PathNorm::XyzDegrees if linear_mm > 0.0 => math::hypot(linear_mm, rotary_degrees),
            PathNorm::Xyz | PathNorm::XyzDegrees => rotary_degrees,
        }
    }

    /// Time of a motion at the feed of the CL data, mm/min; where the tip rests, at the speed for reorientation.
    pub(crate) fn programmed_min(&self, feed: f64, motion: FeedMotion) -> f64 {
        let uneven_mm = (motion.tip_rate_mm - ROUNDED_BLOCK_LENGTH * self.smallest_length_mm) / FASTER;
        let along_path = larger(uneven_mm, motion.length_mm) / feed;
        let time_min = if motion.length_mm < self.smallest_length_mm {
            along_path.max(motion.rotation_rad / self.reorient_rad_per_min)
        } else {
            along_path
        };
        // Where neither tip nor tool axis moves by a unit, any time will do.
        if time_min > 0.0 { time_min } else { RESTING_BLOCK }
    }
}

/// Most decimals of a format.
pub(crate) const MOST_DECIMALS: u32 = 6;

/// Fewest decimals with which a value is off by at most a share of it; `None` if no format has as many.
pub(crate) fn decimals_within(value: f64, share: f64) -> Option<u32> {
    let is_within = |decimals: &u32| {
        Decimal::fixed(value, *decimals).is_ok_and(|word| (word.value() - value).abs() <= share * value.abs())
    };
    (0..=MOST_DECIMALS).find(is_within)
}

/// Key of the decimals of F per minute.
pub(crate) fn feed_key(units: Units) -> &'static str {
    match units {
        Units::Millimetres => "feed",
        Units::Inches => "feed_inch",
    }
}

/// Fault: an F of no digits but zeros.
#[cold]
fn written_as_zero(feed: f64, units: Units) -> Fault {
    let key = feed_key(units);
    plan::FEED
        .fault(format_args!("a feed of {} is written as F0", units.feed(feed)))
        .help(format_args!("check the unit of FEDRAT, or give F more decimals (`[formats] {key}`)"))
}

#[cold]
fn too_large(feed: f64, units: Units) -> Fault {
    plan::FEED.fault(format_args!("a feed of {} is too large for an F word", units.feed(feed)))
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

    fn moved(length: f64, degrees: f64) -> FeedMotion {
        FeedMotion {
            length_mm: length,
            tip_rate_mm: length,
            rotation_rad: degrees.to_radians(),
            linear_mm: length,
            rotary_degrees: degrees,
            orthogonal: true,
            axis_time_min: 0.0,
        }
    }

    #[test]
    fn without_a_rotation_f_is_length_per_minute() {
        let word = |units| feeds(units).pace(254.0, moved(10.0, 0.0)).map(|pace| pace.feed);
        assert_eq!(word(Units::Millimetres), Ok(FeedWord::PerMinute(Decimal { units: 254_000, decimals: 3 })));
        assert_eq!(word(Units::Inches), Ok(FeedWord::PerMinute(Decimal { units: 10_000, decimals: 3 })));
    }

    #[test]
    fn with_a_rotation_f_is_the_inverse_of_the_time_along_the_tip_path_in_any_unit() {
        for units in [Units::Millimetres, Units::Inches] {
            let pace = feeds(units).pace(300.0, moved(7.0, 2.0)).expect("a pace");
            let FeedWord::InverseTime(word) = pace.feed else { panic!("inverse time") };
            assert_eq!((pace.time_min, pace.slowed_min), (7.0 / 300.0, 0.0));
            assert_eq!((word.units, word.decimals), (428_571, 4));
        }
    }

    #[test]
    fn a_tip_that_rests_takes_its_time_from_the_rotary() {
        let pace = feeds(Units::Millimetres).pace(300.0, moved(0.0, 90.0)).expect("a pace");
        let FeedWord::InverseTime(word) = pace.feed else { panic!("inverse time") };
        assert!((word.value() - 20.0).abs() < 1e-9, "90° at 1800 °/min take a twentieth of a minute: {word:?}");
    }

    #[test]
    fn a_tip_that_is_led_unevenly_is_a_hundredth_faster_at_most() {
        let pace = |tip_rate_mm| {
            let motion = FeedMotion { tip_rate_mm, ..moved(2.0, 30.0) };
            feeds(Units::Millimetres).pace(100.0, motion).expect("a pace")
        };
        // Rounding of the words is no speed: one unit is 0.001 mm.
        assert!([2.0, 2.021].map(pace).iter().all(|pace| (pace.time_min - 0.02).abs() < 1e-15));
        let slow = pace(6.0);
        assert!((slow.time_min - (6.0 - 0.002) / 101.0).abs() < 1e-12 && slow.slowed_min == 0.0, "{slow:?}");
    }

    #[test]
    fn a_feed_that_rounds_to_zero_is_refused() {
        assert!(feeds(Units::Millimetres).pace(0.000_4, moved(1.0, 0.0)).is_err());
        assert!(feeds(Units::Millimetres).pace(0.0, moved(1.0, 1.0)).is_err());
        assert!(feeds(Units::Millimetres).pace(-5.0, moved(1.0, 0.0)).is_err());
        assert!(feeds(Units::Millimetres).pace(f64::NAN, moved(1.0, 0.0)).is_err());
    }

    #[test]
    fn a_block_without_motion_has_an_f_where_blocks_have_a_shortest_time() {
        let mut config = Config::default();
        config.motion.feed.shortest_block_s = 0.12;
        let feeds = Feeds::new(config.policy(), Units::Millimetres, 1e-3, &abilities());
        let word = |length| feeds.pace(500.0, moved(length, 0.0)).map(|pace| pace.feed);
        // One unit of the words in two thousandths of a minute.
        assert_eq!(word(0.0), Ok(FeedWord::PerMinute(Decimal { units: 500, decimals: 3 })));
        assert_eq!(word(0.0004), word(0.0));
        assert_eq!(word(0.1), Ok(FeedWord::PerMinute(Decimal { units: 50_000, decimals: 3 })));
        assert_eq!(word(5.0), Ok(FeedWord::PerMinute(Decimal { units: 500_000, decimals: 3 })));
    }

    #[test]
    fn the_shortest_block_leads_to_no_f_below_the_smallest() {
        let mut config = Config::default();
        config.motion.feed.shortest_block_s = 0.12;
        config.formats.feed = 1;
        let feeds = Feeds::new(config.policy(), Units::Millimetres, 1e-5, &abilities());
        // 0.00001 mm in 0.002 min would be F0.005: F0.1 takes 0.0001 min, longer than the programmed feed.
        let pace = feeds.pace(500.0, moved(1e-5, 0.0)).expect("a pace");
        assert_eq!(pace.feed, FeedWord::PerMinute(Decimal { units: 1, decimals: 1 }));
        assert!((pace.time_min - 1e-4).abs() < 1e-12 && pace.slowed_min > 0.0, "{pace:?}");
        // A programmed feed below the smallest F is refused as before.
        assert!(feeds.pace(0.04, moved(1e-5, 0.0)).is_err());
        assert!(feeds.pace(0.04, moved(5.0, 0.0)).is_err());
    }

    #[test]
    fn a_block_is_slowed_by_exactly_what_an_axis_needs() {
        let slow = |degrees| FeedMotion { axis_time_min: 0.25, ..moved(10.0, degrees) };
        let pace = feeds(Units::Millimetres).pace(100.0, slow(30.0)).expect("a pace");
        assert_eq!((pace.time_min, pace.slowed_min), (0.25, 0.25 - 0.1));
        assert_eq!(pace.feed, FeedWord::InverseTime(Decimal { units: 400_000, decimals: 5 }));
        // Without a rotation F per minute goes down.
        let pace = feeds(Units::Millimetres).pace(100.0, slow(0.0)).expect("a pace");
        assert_eq!(pace.feed, FeedWord::PerMinute(Decimal { units: 40_000, decimals: 3 }));
        let fast = feeds(Units::Millimetres).pace(20.0, slow(30.0)).expect("a pace");
        assert_eq!((fast.time_min, fast.slowed_min), (0.5, 0.0));
    }

    #[test]
    fn the_largest_feed_and_the_shortest_block_of_a_control_are_kept() {
        let mut config = Config::default();
        config.motion.feed.largest_mm_per_min = Some(5000.0);
        config.motion.feed.shortest_block_s = 0.006;
        let feeds = Feeds::new(config.policy(), Units::Millimetres, 1e-3, &abilities());
        let pace = feeds.pace(20_000.0, moved(10.0, 0.0)).expect("a pace");
        assert_eq!(pace.feed, FeedWord::PerMinute(Decimal { units: 5_000_000, decimals: 3 }));
        let pace = feeds.pace(4000.0, moved(0.1, 1.0)).expect("a pace");
        assert!((pace.time_min - 1e-4).abs() < 1e-12 && pace.slowed_min > 0.0, "{pace:?}");
        // A motion of nothing but rounding, too.
        config.motion.feed.shortest_block_s = 0.0;
        let feeds = Feeds::new(config.policy(), Units::Millimetres, 1e-3, &abilities());
        for length in [0.0, 1e-5, 3e-4] {
            let pace = feeds.pace(20_000.0, moved(length, 0.0)).expect("a pace");
            assert!(matches!(pace.feed, FeedWord::PerMinute(word) if word.value() <= 5000.0), "{length}: {pace:?}");
        }
    }

    #[test]
    fn feed_per_revolution_needs_a_speed() {
        assert_eq!(Feeds::per_minute(program::Feed::PerRevolution(0.1), Some(3000.0)), Ok(300.0));
        assert!(Feeds::per_minute(program::Feed::PerRevolution(0.1), None).is_err());
    }

    #[test]
    fn without_inverse_time_f_counts_along_the_path_of_the_control() {
        let write = |word, prefix: &str| {
            let mut text = prefix.as_bytes().to_vec();
            crate::nc::write_decimal(&mut text, word);
            String::from_utf8(text).expect("ASCII")
        };
        let word = |norm, units, per_length, linear, degrees| {
            let abilities = Abilities { path_norm: norm, feed_per_inch: per_length, ..abilities() };
            let feeds = Feeds::new(Config::default().policy(), units, 1e-3, &abilities);
            // A tenth of a minute along the tip path.
            let pace = feeds
                .pace(100.0, FeedMotion { linear_mm: linear, rotary_degrees: degrees, ..moved(10.0, 4.0) })
                .expect("a pace");
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
    fn an_f_with_more_digits_than_the_control_holds_is_refused_or_its_block_takes_longer() {
        let config = |feed_whole| Config {
            formats: crate::nc::Formats { feed_whole, ..Config::default().formats },
            ..Config::default()
        };
        let pace = |feed_whole, motion| {
            Feeds::new(config(feed_whole).policy(), Units::Millimetres, 1e-3, &abilities()).pace(10_000.0, motion)
        };
        assert!(pace(5, moved(5.0, 0.0)).is_ok());
        assert!(pace(4, moved(5.0, 0.0)).is_err());
        // A rotation takes as long as its F needs: 100 a minute have three digits.
        let slow = pace(2, moved(100.0, 5.0)).expect("a pace");
        assert!(slow.slowed_min > 0.0 && slow.time_min > 0.01 && slow.time_min < 0.010_1, "{slow:?}");
        let FeedWord::InverseTime(word) = slow.feed else { panic!("inverse time") };
        assert!(word.value() > 99.99 && word.value() < 100.0, "{word:?}");
    }
}
