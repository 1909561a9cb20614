//! The F that a feed block has to have.
//!
//! The tip keeps the programmed feed: a block takes the length of its tip path over the feed; longer only where an axis
//! would be faster than it can, or the control asks for a largest F or a shortest block. While no rotary word changes and
//! the linear axes are square F is the feed of the tip; else it says what the control counts.

use super::read::{Family, FeedMode, MAX_AXES, State};
use crate::config::Config;
use crate::kinematics::{AnyMachine, AxisKind};
use crate::motion::{Mode, PathNorm};
use crate::program::Feed;
use crate::program::Units;

/// Share by which sums of floating-point numbers may differ.
const NOISE: f64 = 1e-9;

/// A way that is known no better than to this share of it says nothing more of how much higher its F may be.
const ROUGHEST: f64 = 0.8;

/// A block that goes nowhere may take any time; this much is written, minutes.
const NOTHING: f64 = 1e-3;

/// One block as the comparison has placed it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Stroke {
    /// Length of the programmed tip path, mm.
    pub(super) length: f64,
    /// Change of the axis values, mm and rad.
    pub(super) change: [f64; MAX_AXES],
    pub(super) feed: Option<Feed>,
    /// rev/min.
    pub(super) speed: Option<f64>,
}

/// The law of one machine, control and set-up.
#[derive(Debug, Clone)]
pub(super) struct FeedLaw {
    norm: PathNorm,
    /// The linear axes are square and of one unit each.
    square: bool,
    rotary_mask: u16,
    linear_mask: u16,
    speeds: Vec<Option<f64>>,
    largest: f64,
    shortest: f64,
    reorient: f64,
    /// One unit of linear and of rotary words, mm and rad.
    unit: f64,
    angle: f64,
    decimals: u32,
    digits: u32,
    /// F counts along the tip path, whatever the axes do.
    along_tip: bool,
    /// F of one mm/min.
    per_mm: f64,
}

/// Expected F, and between what it may be.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Expected {
    pub(super) mode: FeedMode,
    pub(super) value: f64,
    low: f64,
    high: f64,
}

impl Expected {
    /// `step`: how far its digits let it be off; `rough`: the share to which the length of its way is known. F goes with one
    /// over that length, so it may be more off upwards than downwards.
    fn new(mode: FeedMode, value: f64, step: f64, rough: f64) -> Self {
        let over = if rough < ROUGHEST { rough / (1.0 - rough) } else { rough.max(ROUGHEST / (1.0 - ROUGHEST)) };
        Self { mode, value, low: value * (1.0 - rough - NOISE) - step, high: value * (1.0 + over + NOISE) + step }
    }

    fn is_met_by(&self, feed: f64) -> bool {
        (self.low..=self.high).contains(&feed)
    }
}

impl FeedLaw {
    pub(super) fn new(
        machine: &dyn AnyMachine,
        config: &Config,
        family: Family,
        units: Units,
        masks: (u16, u16),
        (unit, angle): (f64, f64),
    ) -> Self {
        let usual = if family == Family::Heidenhain { PathNorm::XyzDegrees } else { PathNorm::G93Minutes };
        // Heidenhain counts tenths of an inch.
        let in_tenths = if family == Family::Heidenhain && units == Units::Inches { 10.0 } else { 1.0 };
        let keeps = config.motion.feed.keep_speeds;
        let travel = config.set_up.travel(machine.axes());
        Self {
            norm: config.control.path_norm.unwrap_or(usual),
            square: square(machine),
            linear_mask: masks.0,
            rotary_mask: masks.1,
            speeds: travel.speeds.iter().map(|speed| speed.filter(|_| keeps)).collect(),
            largest: config.motion.feed.largest_mm_per_min.unwrap_or(f64::INFINITY),
            shortest: config.motion.feed.shortest_block_s / 60.0,
            reorient: config.motion.rapids.reorient_rad_per_min,
            unit,
            angle,
            decimals: config.formats.feed,
            digits: config.formats.inverse_time,
            along_tip: config.motion.mode == Mode::Tcp,
            per_mm: in_tenths / units.in_mm(),
        }
    }

    /// The largest speeds of the axes count.
    pub(super) fn needs_axes(&self) -> bool {
        self.speeds.iter().any(Option::is_some)
    }

    /// The F of a block; `None` where no feed is known.
    pub(super) fn expected(&self, stroke: &Stroke) -> Option<Expected> {
        let feed = match stroke.feed? {
            Feed::PerMinute(feed) => feed,
            Feed::PerRevolution(feed) => feed * stroke.speed?,
        };
        let (mut linear, mut degrees, mut turn, mut least) = (0.0_f64, 0.0_f64, 0.0_f64, 0.0_f64);
        for (index, change) in stroke.change.iter().enumerate() {
            if self.linear_mask & (1 << index) != 0 {
                linear += change * change;
            } else if self.rotary_mask & (1 << index) != 0 {
                degrees += change.to_degrees().powi(2);
                turn = turn.max(change.abs());
            }
            if let Some(Some(speed)) = self.speeds.get(index) {
                least = least.max(change.abs() / speed);
            }
        }
        let (linear, degrees) = (linear.sqrt(), degrees.sqrt());
        let still = stroke.length < self.unit;
        let mut programmed = stroke.length / feed;
        if still {
            programmed = programmed.max(turn / self.reorient);
        }
        if programmed <= 0.0 {
            programmed = NOTHING;
        }
        let moves = turn >= self.angle * 0.25;
        let counted = match self.norm {
            _ if !moves && self.square || self.along_tip => {
                if moves && still {
                    degrees
                } else {
                    stroke.length
                }
            }
            PathNorm::Xyz if linear > 0.25 * self.unit => linear,
            PathNorm::XyzDegrees if linear > 0.25 * self.unit => linear.hypot(degrees),
            PathNorm::Xyz | PathNorm::XyzDegrees => degrees,
            PathNorm::G93Minutes | PathNorm::G93Seconds => stroke.length,
        };
        let minutes = programmed.max(least).max(self.shortest).max(counted / self.largest);
        // Ends of the tip path are known to a unit, and those of the axes to half a unit each.
        let way = if still { turn } else { stroke.length };
        let known = if still { self.angle } else { 2.0 * self.unit };
        let mut rough = if way > 0.0 { known / way } else { 1.0 };
        if least > 0.0 && minutes > programmed {
            rough = rough.max(2.0 * self.unit / linear.max(self.unit)).max(self.angle / turn.max(self.angle));
        }
        let step = self.step();
        let along = |path: f64, rough: f64| {
            let value = path / minutes;
            Expected::new(FeedMode::PerMinute, value, step, rough)
        };
        if turn < self.angle * 0.25 && self.square {
            let slowed = minutes > programmed * (1.0 + NOISE);
            let value = if slowed { stroke.length / minutes } else { feed.min(self.largest) } * self.per_mm;
            let rough = if slowed { rough } else { 0.0 };
            let expected = Expected::new(FeedMode::PerMinute, value, step, rough);
            return Some(Expected { high: expected.high.min(self.largest * self.per_mm + step), ..expected });
        }
        let inverse = |per_minute: f64| {
            let value = 1.0 / (minutes * per_minute);
            // The last of its significant digits.
            let digit = 10_f64.powi(value.abs().log10().floor() as i32 + 1 - self.digits as i32);
            Expected::new(FeedMode::InverseTime, value, digit, rough)
        };
        if self.along_tip {
            return Some(if still { along(degrees, rough) } else { along(stroke.length * self.per_mm, rough) });
        }
        Some(match self.norm {
            PathNorm::G93Minutes => inverse(1.0),
            PathNorm::G93Seconds => inverse(60.0),
            PathNorm::Xyz if linear > 0.25 * self.unit => along(linear * self.per_mm, rough + 2.0 * self.unit / linear),
            PathNorm::XyzDegrees if linear > 0.25 * self.unit => along(linear.hypot(degrees) * self.per_mm, rough),
            PathNorm::Xyz | PathNorm::XyzDegrees => along(degrees, rough),
        })
    }

    /// Whether F suits a way of just less, or of just more than a unit.
    fn fits_shorter_or_longer(&self, stroke: &Stroke, state: &State) -> bool {
        [0.5, 1.0].into_iter().any(|units| {
            let expected = self.expected(&Stroke { length: units * self.unit, ..*stroke });
            expected.is_some_and(|expected| {
                state.feed_mode == Some(expected.mode) && expected.is_met_by(state.feed.unwrap_or(0.0))
            })
        })
    }

    /// Where the tip stands and rotary axes turn, these take their time, or the way of the tip its own: which of the two,
    /// and how long, ends that are known to a unit do not tell.
    fn fits_standing(&self, stroke: &Stroke, state: &State) -> bool {
        let standing = |units: f64| self.expected(&Stroke { length: units * self.unit, ..*stroke });
        let (Some(none), Some(most)) = (standing(0.0), standing(1.0 - NOISE)) else { return false };
        let (low, high) = (none.low.min(most.low), none.high.max(most.high));
        let written = state.feed.unwrap_or(0.0);
        self.turns(stroke) && state.feed_mode == Some(none.mode) && low <= written && written <= high
    }

    /// Whether F is that of a block which is held back, being shorter than it seems by the rounding of its ends.
    fn fits_held_back(&self, stroke: &Stroke, wanted: &Expected, state: &State) -> bool {
        let length = (stroke.length - 2.0 * self.unit).max(self.unit);
        let written = state.feed.unwrap_or(0.0);
        let least = self.expected(&Stroke { length, ..*stroke });
        !self.turns(stroke)
            && state.feed_mode == Some(wanted.mode)
            && written < wanted.value
            && least
                .is_some_and(|least| least.mode == wanted.mode && written >= least.value * (1.0 - NOISE) - self.step())
    }

    /// Half a unit of an F per minute.
    fn step(&self) -> f64 {
        0.5 * 10_f64.powi(-(self.decimals as i32))
    }

    fn turns(&self, stroke: &Stroke) -> bool {
        let rotary = |index: usize| self.rotary_mask & (1 << index) != 0;
        stroke.change.iter().enumerate().any(|(index, change)| rotary(index) && change.abs() >= 0.25 * self.angle)
    }

    /// The tip stands, as far as its ends tell.
    pub(super) fn is_still(&self, stroke: &Stroke) -> bool {
        stroke.length < 2.5 * self.unit
    }

    /// Where only the tool axis turns, and how far its rotary axes turn is not known: degrees a minute, at most those of
    /// a turn of all rotary axes together.
    pub(super) fn wrong_on_the_spot(&self, state: &State) -> Option<String> {
        let largest = self.reorient.to_degrees() * f64::from(self.rotary_mask.count_ones()).sqrt();
        let feed = state.feed.unwrap_or(0.0);
        (feed <= 0.0 || feed > largest + self.step()).then(|| {
            format!("F is {feed} per minute where only the tool axis rotates, allowed at most {largest:.6} degrees")
        })
    }

    /// Where the speeds of axes hold a block back, and how far these move is not known: at most the feed of the tip.
    pub(super) fn too_fast(&self, stroke: &Stroke, state: &State) -> Option<String> {
        let most = self.expected(&Stroke { change: [0.0; MAX_AXES], ..*stroke })?;
        let feed = state.feed.unwrap_or(0.0);
        (state.feed_mode != Some(most.mode) || feed <= 0.0 || feed > most.high)
            .then(|| format!("F is {feed} per minute, allowed at most {:.6}", most.value))
    }

    /// Whether a block runs as it should: `None`, or what it should be.
    pub(super) fn wrong(&self, stroke: &Stroke, state: &State) -> Option<String> {
        let expected = self.expected(stroke)?;
        let written = state.feed.unwrap_or(0.0);
        // Whether so short a way stands still, its ends do not tell.
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

/// Whether the linear axes are square to each other, so that the way of the words is the way of the tip.
fn square(machine: &dyn AnyMachine) -> bool {
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
            norm: PathNorm::G93Minutes,
            square: true,
            rotary_mask: 2,
            linear_mask: 1,
            speeds: Vec::new(),
            largest: f64::INFINITY,
            shortest: shortest / 60.0,
            reorient: 1800_f64.to_radians(),
            unit: 0.01,
            angle: 1e-3_f64.to_radians(),
            decimals: 2,
            digits: 6,
            along_tip: false,
            per_mm: 1.0,
        }
    }

    fn stroke(length: f64, degrees: f64, feed: f64) -> Stroke {
        let mut change = [0.0; MAX_AXES];
        (change[0], change[1]) = (length, degrees.to_radians());
        Stroke { length, change, feed: Some(Feed::PerMinute(feed)), speed: None }
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
    fn a_way_of_nothing_keeps_the_largest_feed_too() {
        let (law, seen) = (FeedLaw { largest: 900.0, ..law(0.0) }, stroke(0.0, 0.0, 8000.0));
        let feeds = [900.0, 8000.0];
        assert_eq!(feeds.map(|feed| passes(&law, &seen, FeedMode::PerMinute, feed)), [true, false]);
    }

    #[test]
    fn a_short_way_may_be_shorter_than_its_ends_say_and_its_feed_then_higher_by_more() {
        // 0.036 mm known to 0.02: it may have been 0.016, or 0.056.
        let (law, seen) = (law(0.0), stroke(0.036, 1.0, 600.0));
        let feeds = [600.0 / 0.0165, 600.0 / 0.0155, 600.0 / 0.054];
        assert_eq!(feeds.map(|feed| passes(&law, &seen, FeedMode::InverseTime, feed)), [true, false, true]);
        assert!(!passes(&law, &seen, FeedMode::InverseTime, 600.0 / 0.1));
    }

    #[test]
    fn a_tip_that_stands_may_take_the_time_of_its_rotary_axes_or_of_its_way() {
        // 0.003 degrees take 1/600 000 min; 0.0084 mm of the tip 1/71 429 min, and it may stand as well.
        let (law, seen) = (law(0.0), stroke(0.0084, 0.003, 600.0));
        let feeds = [600_000.0, 300_000.0, 71_429.0, 1_000_000.0];
        let told = feeds.map(|feed| passes(&law, &seen, FeedMode::InverseTime, feed));
        assert_eq!(told, [true, true, true, false]);
    }
}
