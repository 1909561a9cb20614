//! F that a feed block must have.
//!
//! The tip keeps the programmed feed: the time of a block is the length of its tip path over the feed, and longer only
//! where an axis would be faster than it can, or the control has a largest F or a shortest block. Where no rotary word
//! changes and the linear axes are perpendicular F is the feed of the tip; elsewhere it applies to the control's own path.

use super::super::policy::{CheckPolicy, FeedPath, LinearMeaning};
use super::super::read::{Facts, FeedMode, MAX_AXES, State};
use crate::kinematics::{AnyMachine, AxisKind};
use crate::program::{Feed, Units};

/// Share by which sums of floating-point numbers may differ.
const NOISE: f64 = 1e-9;

/// Share of a length: where the error of a length is larger, the upper bound of F follows from this share.
const ROUGHEST: f64 = 0.8;

/// Time written for a block without a motion, minutes.
const NOTHING: f64 = 1e-3;

/// Ratio of the motion of the linear axes to that of the tip above which the tool axis decides the ends of a block.
const LEVER: f64 = 10.0;

/// Motion of one feed block.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Stroke {
    /// Length of the programmed tip path, mm.
    pub(crate) length_mm: f64,
    /// Change of the axis values, mm and rad.
    pub(crate) change: [f64; MAX_AXES],
    pub(crate) feed: Option<Feed>,
    pub(crate) speed_rev_per_min: Option<f64>,
}

/// Rules of F for one machine, control and set-up.
#[derive(Debug, Clone)]
pub(crate) struct FeedLaw {
    path: FeedPath,
    /// The linear axes are perpendicular to each other.
    perpendicular: bool,
    rotary_bits: u16,
    linear_bits: u16,
    /// Largest speeds of the axes, mm/min and rad/min.
    speeds: Vec<Option<f64>>,
    largest_mm_per_min: f64,
    shortest_min: f64,
    reorient_rad_per_min: f64,
    /// One unit of a linear word.
    unit_mm: f64,
    /// One unit of a rotary word.
    unit_rad: f64,
    decimals: u32,
    /// Significant digits of an inverse-time F.
    digits: u32,
    /// F applies to the tip path, whatever the axes do.
    along_tip: bool,
    /// F of 1 mm/min.
    per_mm: f64,
}

/// Expected F, and its bounds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ExpectedFeed {
    pub(crate) mode: FeedMode,
    pub(crate) value: f64,
    low: f64,
    high: f64,
}

impl ExpectedFeed {
    /// `step`: rounding of the digits; `rough`: relative error of the length. F is inverse to the length, so the error is
    /// larger upwards than downwards.
    fn new(mode: FeedMode, value: f64, step: f64, rough: f64) -> Self {
        let over = if rough < ROUGHEST { rough / (1.0 - rough) } else { rough.max(ROUGHEST / (1.0 - ROUGHEST)) };
        Self { mode, value, low: value * (1.0 - rough - NOISE) - step, high: value * (1.0 + over + NOISE) + step }
    }

    fn is_met_by(&self, feed: f64) -> bool {
        (self.low..=self.high).contains(&feed)
    }
}

impl FeedLaw {
    /// `bits`: solved linear and rotary axes; `units`: one unit of linear and of rotary words, mm and rad.
    pub(crate) fn new(
        machine: &dyn AnyMachine,
        policy: &CheckPolicy,
        facts: &Facts,
        program: Units,
        bits: (u16, u16),
        units: (f64, f64),
    ) -> Self {
        let usual = if facts.feed_counts_degrees { FeedPath::LinearAndDegrees } else { FeedPath::InverseMinutes };
        let in_tenths = if facts.feed_in_tenths_of_inch && program == Units::Inches { 10.0 } else { 1.0 };
        let travel = policy.set_up.travel(machine.axes());
        let feed = &policy.feed;
        Self {
            path: feed.path.unwrap_or(usual),
            perpendicular: is_perpendicular(machine),
            linear_bits: bits.0,
            rotary_bits: bits.1,
            speeds: travel.speeds.iter().map(|speed| speed.filter(|_| feed.keeps_axis_speeds)).collect(),
            largest_mm_per_min: feed.largest_mm_per_min.unwrap_or(f64::INFINITY),
            shortest_min: feed.shortest_block_s / 60.0,
            reorient_rad_per_min: feed.reorient_rad_per_min,
            unit_mm: units.0,
            unit_rad: units.1,
            decimals: policy.digits.feed,
            digits: policy.digits.inverse_time,
            along_tip: policy.words.linear == LinearMeaning::TipCoordinates,
            per_mm: in_tenths / program.in_mm(),
        }
    }

    /// Whether largest speeds of axes may hold a block back.
    pub(crate) fn needs_axes(&self) -> bool {
        self.speeds.iter().any(Option::is_some)
    }

    /// The F of a block; `None` where no feed is known.
    pub(crate) fn expected(&self, stroke: &Stroke) -> Option<ExpectedFeed> {
        let feed = match stroke.feed? {
            Feed::PerMinute(feed) => feed,
            Feed::PerRevolution(feed) => feed * stroke.speed_rev_per_min?,
        };
        let (mut linear, mut degrees, mut turn, mut least) = (0.0_f64, 0.0_f64, 0.0_f64, 0.0_f64);
        for (index, change) in stroke.change.iter().enumerate() {
            if self.linear_bits & (1 << index) != 0 {
                linear += change * change;
            } else if self.rotary_bits & (1 << index) != 0 {
                degrees += change.to_degrees().powi(2);
                turn = turn.max(change.abs());
            }
            if let Some(Some(speed)) = self.speeds.get(index) {
                least = least.max(change.abs() / speed);
            }
        }
        let (linear, degrees) = (linear.sqrt(), degrees.sqrt());
        let still = stroke.length_mm < self.unit_mm;
        let mut programmed = stroke.length_mm / feed;
        if still {
            programmed = programmed.max(turn / self.reorient_rad_per_min);
        }
        if programmed <= 0.0 {
            programmed = NOTHING;
        }
        let moves = turn >= self.unit_rad * 0.25;
        let counted = match self.path {
            _ if !moves && self.perpendicular || self.along_tip => {
                if moves && still {
                    degrees
                } else {
                    stroke.length_mm
                }
            }
            FeedPath::Linear if linear > 0.25 * self.unit_mm => linear,
            FeedPath::LinearAndDegrees if linear > 0.25 * self.unit_mm => linear.hypot(degrees),
            FeedPath::Linear | FeedPath::LinearAndDegrees => degrees,
            FeedPath::InverseMinutes | FeedPath::InverseSeconds => stroke.length_mm,
        };
        let minutes = programmed.max(least).max(self.shortest_min).max(counted / self.largest_mm_per_min);
        // Ends of the tip path are known to one unit, those of the axes to half a unit each. Where the axes move much farther
        // than the tip, the rounding of the tool axis moves the ends, too.
        let way = if still { turn } else { stroke.length_mm };
        let ends = if linear > LEVER * stroke.length_mm { 3.0 } else { 2.0 };
        let known = if still { self.unit_rad } else { ends * self.unit_mm };
        let mut rough = if way > 0.0 { known / way } else { 1.0 };
        if least > 0.0 && minutes > programmed {
            rough =
                rough.max(2.0 * self.unit_mm / linear.max(self.unit_mm)).max(self.unit_rad / turn.max(self.unit_rad));
        }
        let step = self.step();
        let along = |path: f64, rough: f64| {
            let value = path / minutes;
            ExpectedFeed::new(FeedMode::PerMinute, value, step, rough)
        };
        if turn < self.unit_rad * 0.25 && self.perpendicular {
            let slowed = minutes > programmed * (1.0 + NOISE);
            let value =
                if slowed { stroke.length_mm / minutes } else { feed.min(self.largest_mm_per_min) } * self.per_mm;
            let rough = if slowed { rough } else { 0.0 };
            let expected = ExpectedFeed::new(FeedMode::PerMinute, value, step, rough);
            return Some(ExpectedFeed {
                high: expected.high.min(self.largest_mm_per_min * self.per_mm + step),
                ..expected
            });
        }
        let inverse = |per_minute: f64| {
            let value = 1.0 / (minutes * per_minute);
            // The last of its significant digits.
            let digit = 10_f64.powi(value.abs().log10().floor() as i32 + 1 - self.digits as i32);
            ExpectedFeed::new(FeedMode::InverseTime, value, digit, rough)
        };
        if self.along_tip {
            return Some(if still { along(degrees, rough) } else { along(stroke.length_mm * self.per_mm, rough) });
        }
        Some(match self.path {
            FeedPath::InverseMinutes => inverse(1.0),
            FeedPath::InverseSeconds => inverse(60.0),
            FeedPath::Linear if linear > 0.25 * self.unit_mm => {
                along(linear * self.per_mm, rough + 2.0 * self.unit_mm / linear)
            }
            FeedPath::LinearAndDegrees if linear > 0.25 * self.unit_mm => {
                along(linear.hypot(degrees) * self.per_mm, rough)
            }
            FeedPath::Linear | FeedPath::LinearAndDegrees => along(degrees, rough),
        })
    }

    /// Whether F suits a path just shorter, or just longer, than one unit.
    fn fits_shorter_or_longer(&self, stroke: &Stroke, state: &State) -> bool {
        [0.5, 1.0].into_iter().any(|units| {
            let expected = self.expected(&Stroke { length_mm: units * self.unit_mm, ..*stroke });
            expected.is_some_and(|expected| {
                state.feed_mode == Some(expected.mode) && expected.is_met_by(state.feed.unwrap_or(0.0))
            })
        })
    }

    /// Where the tip hardly moves and rotary axes rotate, either the rotation or the tip path decides the time. Ends that are
    /// known to one unit do not show which.
    fn fits_standing(&self, stroke: &Stroke, state: &State) -> bool {
        let standing = |units: f64| self.expected(&Stroke { length_mm: units * self.unit_mm, ..*stroke });
        let (Some(none), Some(most)) = (standing(0.0), standing(1.0 - NOISE)) else { return false };
        let (low, high) = (none.low.min(most.low), none.high.max(most.high));
        let written = state.feed.unwrap_or(0.0);
        self.rotates(stroke) && state.feed_mode == Some(none.mode) && low <= written && written <= high
    }

    /// Whether F is that of a block that is held back, because it is shorter than its rounded ends suggest.
    fn fits_held_back(&self, stroke: &Stroke, wanted: &ExpectedFeed, state: &State) -> bool {
        let length = (stroke.length_mm - 2.0 * self.unit_mm).max(self.unit_mm);
        let written = state.feed.unwrap_or(0.0);
        let least = self.expected(&Stroke { length_mm: length, ..*stroke });
        !self.rotates(stroke)
            && state.feed_mode == Some(wanted.mode)
            && written < wanted.value
            && least
                .is_some_and(|least| least.mode == wanted.mode && written >= least.value * (1.0 - NOISE) - self.step())
    }

    /// Half a unit of an F per minute.
    fn step(&self) -> f64 {
        0.5 * 10_f64.powi(-(self.decimals as i32))
    }

    fn rotates(&self, stroke: &Stroke) -> bool {
        let rotary = |index: usize| self.rotary_bits & (1 << index) != 0;
        stroke.change.iter().enumerate().any(|(index, change)| rotary(index) && change.abs() >= 0.25 * self.unit_rad)
    }

    /// Whether the tip stands still, as far as rounded ends show. Where the axes move much farther than the tip, the rounding
    /// of the tool axis moves its ends, too.
    pub(crate) fn is_still(&self, stroke: &Stroke) -> bool {
        let linear = stroke.change.iter().enumerate().filter(|(index, _)| self.linear_bits & (1 << index) != 0);
        let linear = linear.map(|(_, change)| change * change).sum::<f64>().sqrt();
        let lever = self.rotates(stroke) && linear > LEVER * stroke.length_mm;
        stroke.length_mm < if lever { 6.0 } else { 2.5 } * self.unit_mm
    }

    /// Where only the tool axis rotates, and the rotation of the rotary axes is unknown: degrees a minute, at most those of
    /// all rotary axes together.
    pub(crate) fn wrong_on_the_spot(&self, state: &State) -> Option<String> {
        let largest = self.reorient_rad_per_min.to_degrees() * f64::from(self.rotary_bits.count_ones()).sqrt();
        let feed = state.feed.unwrap_or(0.0);
        (feed <= 0.0 || feed > largest + self.step()).then(|| {
            format!("F is {feed} per minute where only the tool axis rotates, allowed at most {largest:.6} degrees")
        })
    }

    /// Where axis speeds may hold a block back, and the motion of the axes is unknown: at most the feed of the tip.
    pub(crate) fn too_fast(&self, stroke: &Stroke, state: &State) -> Option<String> {
        let most = self.expected(&Stroke { change: [0.0; MAX_AXES], ..*stroke })?;
        let feed = state.feed.unwrap_or(0.0);
        (state.feed_mode != Some(most.mode) || feed <= 0.0 || feed > most.high)
            .then(|| format!("F is {feed} per minute, allowed at most {:.6}", most.value))
    }

    /// What is wrong with F; `None` if it is right.
    pub(crate) fn wrong(&self, stroke: &Stroke, state: &State) -> Option<String> {
        let expected = self.expected(stroke)?;
        let written = state.feed.unwrap_or(0.0);
        // Rounded ends do not show whether so short a path has any length.
        if self.is_still(stroke) && (self.fits_shorter_or_longer(stroke, state) || self.fits_standing(stroke, state)) {
            return None;
        }
        if state.feed_mode == Some(expected.mode) && expected.is_met_by(written) {
            return None;
        }
        if self.fits_held_back(stroke, &expected, state) {
            return None;
        }
        let (name, unit) = match expected.mode {
            FeedMode::InverseTime => ("inverse-time feed", "1/min"),
            _ => ("feed per minute", "per minute"),
        };
        Some(match state.feed {
            _ if state.feed_mode != Some(expected.mode) => {
                format!("feed mode {name} is not active: expected {name} with F {:.6} {unit}", expected.value)
            }
            None => format!("F is missing, expected {:.6} {unit}", expected.value),
            Some(written) => format!("F is {written} {unit}, expected {:.6}", expected.value),
        })
    }
}

/// Whether the linear axes are perpendicular to each other: the path of the words is as long as that of the tip.
fn is_perpendicular(machine: &dyn AnyMachine) -> bool {
    let linear = (0..machine.axes().len())
        .filter(|&index| machine.axes()[index].kind == AxisKind::Linear && !machine.axes()[index].held);
    let directions: Vec<_> = linear.map(|index| machine.joint(index).direction).collect();
    let pairs = directions.iter().enumerate().flat_map(|(index, a)| directions[..index].iter().map(move |b| (a, b)));
    let mut pairs = pairs;
    pairs.all(|(a, b)| a.dot(b).abs() < 1e-12)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// X and a rotary axis that turns by 1800 degrees a minute; a block takes 0.01 s at least.
    fn law(shortest: f64) -> FeedLaw {
        FeedLaw {
            path: FeedPath::InverseMinutes,
            perpendicular: true,
            rotary_bits: 2,
            linear_bits: 1,
            speeds: Vec::new(),
            largest_mm_per_min: f64::INFINITY,
            shortest_min: shortest / 60.0,
            reorient_rad_per_min: 1800_f64.to_radians(),
            unit_mm: 0.01,
            unit_rad: 1e-3_f64.to_radians(),
            decimals: 2,
            digits: 6,
            along_tip: false,
            per_mm: 1.0,
        }
    }

    fn stroke(length: f64, degrees: f64, feed: f64) -> Stroke {
        let mut change = [0.0; MAX_AXES];
        (change[0], change[1]) = (length, degrees.to_radians());
        Stroke { length_mm: length, change, feed: Some(Feed::PerMinute(feed)), speed_rev_per_min: None }
    }

    fn passes(law: &FeedLaw, stroke: &Stroke, mode: FeedMode, feed: f64) -> bool {
        let state = State { feed: Some(feed), feed_mode: Some(mode), ..State::default() };
        law.wrong(stroke, &state).is_none()
    }

    #[test]
    fn a_block_may_be_held_back_for_a_length_that_rounding_has_hidden() {
        // 598.39 mm/min for 0.01 s are 0.0997 mm: a block of 0.0985 mm that looks 0.105 mm long is held back.
        let (law, seen) = (law(0.01), stroke(0.105, 0.0, 598.39));
        let feeds = [598.39, 591.13, 505.0, 600.0];
        assert_eq!(feeds.map(|feed| passes(&law, &seen, FeedMode::PerMinute, feed)), [true, true, false, false]);
        // Nothing holds back a longer one.
        assert!(!passes(&law, &stroke(0.2, 0.0, 598.39), FeedMode::PerMinute, 591.13));
    }

    #[test]
    fn a_path_of_no_length_keeps_the_largest_feed_too() {
        let (law, seen) = (FeedLaw { largest_mm_per_min: 900.0, ..law(0.0) }, stroke(0.0, 0.0, 8000.0));
        let feeds = [900.0, 8000.0];
        assert_eq!(feeds.map(|feed| passes(&law, &seen, FeedMode::PerMinute, feed)), [true, false]);
    }

    #[test]
    fn a_short_path_may_be_shorter_than_its_rounded_ends() {
        // 0.036 mm known to 0.02: it may have been 0.016, or 0.056.
        let (law, seen) = (law(0.0), stroke(0.036, 1.0, 600.0));
        let feeds = [600.0 / 0.0165, 600.0 / 0.0155, 600.0 / 0.054];
        assert_eq!(feeds.map(|feed| passes(&law, &seen, FeedMode::InverseTime, feed)), [true, false, true]);
        assert!(!passes(&law, &seen, FeedMode::InverseTime, 600.0 / 0.1));
    }

    #[test]
    fn a_tip_that_hardly_moves_may_take_the_time_of_the_rotary_axes() {
        // 0.003 degrees take 1/600 000 min; 0.0084 mm of the tip 1/71 429 min, and it may stand as well.
        let (law, seen) = (law(0.0), stroke(0.0084, 0.003, 600.0));
        let feeds = [600_000.0, 300_000.0, 71_429.0, 1_000_000.0];
        let told = feeds.map(|feed| passes(&law, &seen, FeedMode::InverseTime, feed));
        assert_eq!(told, [true, true, true, false]);
    }
}
