//! F that a feed block must have.
//!
//! The tip keeps the programmed feed: the time of a block is the length of its tip path over the feed. Where the axes
//! lead the tip unevenly, it is nowhere faster than programmed by more than a hundredth. The time is longer only where
//! an axis would be faster than it can, or the control has a largest F or a shortest block. Where no rotary word
//! changes and the linear axes are perpendicular F is the feed of the tip; elsewhere it applies to the control's own
//! path.

use std::f64::consts::TAU;

use nalgebra::Rotation3;

use super::super::expect::Required;
use super::super::policy::{CheckPolicy, FeedPath, LinearMeaning};
use super::super::read::{FeedMode, MAX_AXES, State, set_bits};
use super::{Deviation, MachineWords, WordRounding, tip_rates};
use crate::check::tolerances::{
    F_NOISE, FASTER, LEVER, PERPENDICULAR_AXES, RESTING_BLOCK, ROUNDED_BLOCK_LENGTH, SLOWED_BY_ROUNDING, TIME_BOUND,
};
use crate::kinematics::math::{larger, smaller};
use crate::kinematics::{AnyMachine, AxisKind};
use crate::program::{Feed, Shown, Units};

/// Motion of one feed block.
#[derive(Debug, Clone)]
pub(crate) struct Stroke {
    /// Length of the programmed tip path, from rounded ends, mm.
    pub(crate) length_mm: f64,
    /// The tip path is not longer than this, mm.
    pub(crate) longest_mm: f64,
    /// Bounds of the largest speed of the tip, times the time of the block, mm; 0 where the tip is led evenly.
    pub(crate) tip_rate_mm: [f64; 2],
    /// The linear axes are perpendicular, everywhere or with the rotary axes where they are at its end.
    pub(crate) perpendicular: bool,
    /// Change of the axis values, mm and rad.
    pub(crate) change: [f64; MAX_AXES],
    /// Largest speeds of the axes within the block, times its time, where the axes do not move evenly and the control
    /// does not slow down for them.
    pub(crate) uneven: Option<Box<[f64; MAX_AXES]>>,
    pub(crate) feed: Option<Feed>,
    pub(crate) speed_rev_per_min: Option<f64>,
}

impl Stroke {
    /// This stroke with the speed of the tip in the block, where that is measured.
    pub(crate) fn with_tip_rate(self, deviation: Option<&Deviation>, required: &Required) -> Self {
        let rate_mm = deviation.map_or(0.0, |found| found.tip_rate_mm);
        if rate_mm > 0.0 { Self { tip_rate_mm: tip_rates(rate_mm, required), ..self } } else { self }
    }
}

/// Rules of F for one machine, control and set-up.
#[derive(Debug, Clone)]
pub(crate) struct FeedLaw {
    path: FeedPath,
    /// The linear axes are perpendicular to each other wherever the rotary axes are.
    perpendicular: bool,
    rotary_bits: u16,
    linear_bits: u16,
    /// Axes with largest speeds, mm/min and rad/min.
    speeds: Vec<(usize, f64)>,
    largest_mm_per_min: f64,
    /// Largest F of inverse-time feed.
    largest_inverse_time: f64,
    /// Largest F per minute where a rotary axis rotates: the word has no more digits.
    largest_word: f64,
    shortest_min: f64,
    reorient_rad_per_min: f64,
    /// One unit of a linear word.
    unit_mm: f64,
    /// One unit of a rotary word.
    unit_rad: f64,
    /// Smallest F per minute: one unit of its last decimal.
    smallest: f64,
    /// Significant digits of an inverse-time F.
    digits: u32,
    /// F applies to the tip path, whatever the axes do.
    along_tip: bool,
    /// F of 1 mm/min.
    per_mm: f64,
}

/// Length of a tip path and what the axes do in it.
#[derive(Debug, Clone, Copy)]
struct PathExtent {
    length_mm: f64,
    perpendicular: bool,
    /// Largest speed of the tip times the time of the block, mm.
    tip_rate_mm: f64,
    /// Path of the linear axes, mm.
    linear_mm: f64,
    /// Path of the rotary axes, degrees.
    rotary_deg: f64,
    /// Largest rotation of an axis, rad.
    rotation_rad: f64,
    /// Time that the axes need, minutes.
    least_min: f64,
}

/// Length of a motion along the path that F counts.
#[derive(Debug, Clone, Copy)]
struct CountedPath {
    /// In mm, or in degrees where only rotary axes move.
    amount: f64,
    /// It is a length, in mm.
    is_length: bool,
}

impl CountedPath {
    fn length(amount: f64) -> Self {
        Self { amount, is_length: true }
    }

    fn degrees(amount: f64) -> Self {
        Self { amount, is_length: false }
    }
}

impl FeedLaw {
    /// `program`: its units; `rounding`: one unit of linear and of rotary words.
    pub(crate) fn new(
        machine: &dyn AnyMachine,
        policy: &CheckPolicy,
        program: Units,
        words: &MachineWords,
        rounding: &WordRounding,
    ) -> Self {
        let facts = policy.family.facts();
        let usual = if facts.feed_counts_degrees { FeedPath::LinearAndDegrees } else { FeedPath::InverseMinutes };
        let in_tenths = if facts.feed_in_tenths_of_inch && program == Units::Inches { 10.0 } else { 1.0 };
        let travel = policy.set_up.travel(machine.axes());
        let feed = &policy.feed;
        let inverse_time = feed.largest_inverse_time.unwrap_or_else(|| {
            facts.largest_inverse_time_hundredths.map_or(f64::INFINITY, |hundredths| f64::from(hundredths) / 100.0)
        });
        let (whole, digits) = (policy.digits.feed_whole as i32, policy.digits.inverse_time as i32);
        let (bound, last_digit) = (10_f64.powi(whole), 10_f64.powi(whole - digits));
        let speed = |(index, speed): (usize, &Option<f64>)| {
            speed.filter(|_| feed.keeps_axis_speeds).map(|speed| (index, speed))
        };
        Self {
            path: feed.path.unwrap_or(usual),
            largest_word: bound - 10_f64.powi(-(policy.digits.feed(program) as i32)),
            perpendicular: is_perpendicular(machine),
            linear_bits: words.linear_bits(),
            rotary_bits: words.rotary_bits(),
            speeds: travel.speeds.iter().enumerate().filter_map(speed).collect(),
            largest_mm_per_min: feed.largest_mm_per_min.unwrap_or(f64::INFINITY),
            largest_inverse_time: inverse_time.min(bound - last_digit),
            shortest_min: feed.shortest_block_s / 60.0,
            reorient_rad_per_min: feed.reorient_rad_per_min,
            unit_mm: rounding.unit_mm,
            unit_rad: rounding.unit_rad,
            smallest: 10_f64.powi(-(policy.digits.feed(program) as i32)),
            digits: policy.digits.inverse_time,
            along_tip: policy.linear_of_all() == Some(LinearMeaning::TipCoordinates),
            per_mm: in_tenths / program.in_mm(),
        }
    }

    /// Takes the meaning of linear words from the next block on.
    pub(crate) fn follow(&mut self, meaning: LinearMeaning) {
        self.along_tip = meaning == LinearMeaning::TipCoordinates;
    }

    /// Whether it depends on the rotary axes if the linear ones are perpendicular.
    pub(crate) fn needs_directions(&self) -> bool {
        !self.perpendicular
    }

    /// Whether largest speeds of axes may hold a block back.
    pub(crate) fn needs_axes(&self) -> bool {
        !self.speeds.is_empty()
    }

    /// Feed of the tip, mm/min; `None` where none is known.
    fn programmed(stroke: &Stroke) -> Option<f64> {
        match stroke.feed? {
            Feed::PerMinute(feed) => Some(feed),
            Feed::PerRevolution(feed) => stroke.speed_rev_per_min.map(|speed| feed * speed),
        }
    }

    /// What the words show.
    fn extent(&self, stroke: &Stroke) -> PathExtent {
        let (mut degrees, mut rotation_rad) = (0.0_f64, 0.0_f64);
        let linear: f64 = set_bits(self.linear_bits).map(|index| stroke.change[index].powi(2)).sum();
        for index in set_bits(self.rotary_bits) {
            let rotation = stroke.change[index].abs();
            degrees += rotation.to_degrees().powi(2);
            rotation_rad = larger(rotation, rotation_rad);
        }
        let least_min = self.least_min(stroke, 0.0);
        let linear_mm = linear.sqrt();
        let (length_mm, tip_rate_mm) = (stroke.length_mm, stroke.tip_rate_mm[0]);
        let perpendicular = stroke.perpendicular;
        PathExtent {
            length_mm,
            perpendicular,
            tip_rate_mm,
            linear_mm,
            rotary_deg: degrees.sqrt(),
            rotation_rad,
            least_min,
        }
    }

    /// Time that the axes need at their largest speeds, minutes. `error`: share of one unit that is added
    /// to the motion of each axis.
    fn least_min(&self, stroke: &Stroke, error: f64) -> f64 {
        let times = self.speeds.iter().map(|&(index, speed)| {
            let mut change = stroke.change[index].abs();
            if self.linear_bits & (1 << index) != 0 {
                change = stroke.uneven.as_ref().map_or(change, |uneven| uneven[index]) + error * self.unit_mm;
            } else if self.rotary_bits & (1 << index) != 0 {
                change += error * self.unit_rad;
            }
            change / speed
        });
        // A bounded time may exceed that of any axis.
        let bound = if stroke.uneven.is_some() && error > 0.0 { TIME_BOUND } else { 1.0 };
        bound * times.fold(0.0, f64::max)
    }

    /// Whether a rotary axis rotates.
    fn rotates(&self, extent: &PathExtent) -> bool {
        extent.rotation_rad >= 0.25 * self.unit_rad
    }

    /// Whether F applies to the tip path because nothing else moves, whatever the control counts otherwise.
    fn is_plain(&self, extent: &PathExtent) -> bool {
        extent.perpendicular && !self.rotates(extent)
    }

    fn mode(&self, extent: &PathExtent) -> FeedMode {
        match self.path {
            FeedPath::InverseMinutes | FeedPath::InverseSeconds if !self.along_tip && !self.is_plain(extent) => {
                FeedMode::InverseTime
            }
            _ => FeedMode::PerMinute,
        }
    }

    /// Path that F counts along.
    fn counted(&self, extent: &PathExtent) -> CountedPath {
        let moves = extent.linear_mm > 0.25 * self.unit_mm;
        match self.path {
            _ if self.is_plain(extent) => CountedPath::length(extent.length_mm),
            _ if self.along_tip && self.rotates(extent) && extent.length_mm < self.unit_mm => {
                CountedPath::degrees(extent.rotary_deg)
            }
            _ if self.along_tip => CountedPath::length(extent.length_mm),
            FeedPath::InverseMinutes | FeedPath::InverseSeconds => CountedPath::length(extent.length_mm),
            FeedPath::Linear if moves => CountedPath::length(extent.linear_mm),
            FeedPath::LinearAndDegrees if moves => CountedPath::length(extent.linear_mm.hypot(extent.rotary_deg)),
            FeedPath::Linear | FeedPath::LinearAndDegrees => CountedPath::degrees(extent.rotary_deg),
        }
    }

    /// Length of a tip path that is led evenly and takes the time of one with this largest speed, mm.
    fn even_mm(&self, tip_rate_mm: f64) -> f64 {
        (tip_rate_mm - ROUNDED_BLOCK_LENGTH * self.unit_mm) / FASTER
    }

    /// F of a motion at a feed of the tip, mm/min.
    fn value(&self, feed: f64, extent: &PathExtent) -> f64 {
        let mut programmed = extent.length_mm.max(self.even_mm(extent.tip_rate_mm)) / feed;
        if extent.length_mm < self.unit_mm {
            programmed = programmed.max(extent.rotation_rad / self.reorient_rad_per_min);
        }
        if programmed <= 0.0 {
            programmed = RESTING_BLOCK;
        }
        let counted = self.counted(extent);
        let needed = programmed.max(self.least_needed_min(extent, counted));
        if !self.is_plain(extent) {
            return self.in_time(needed, self.mode(extent), counted);
        }
        let minutes = needed.max(self.shortest_min);
        let slowed = minutes > programmed * (1.0 + F_NOISE);
        let slower = if slowed { extent.length_mm.max(self.unit_mm) / minutes } else { feed };
        self.held(feed.min(slower).min(self.largest_mm_per_min) * self.per_mm, needed)
    }

    /// Time that a motion needs whatever its feed, by its axes and the largest F, min.
    fn least_needed_min(&self, extent: &PathExtent, counted: CountedPath) -> f64 {
        larger(counted.amount / self.largest_mm_per_min, extent.least_min)
    }

    /// F of a motion that needs a time, along the path that F counts; that of a plain one depends on its feed.
    fn in_time(&self, needed_min: f64, mode: FeedMode, CountedPath { amount, is_length }: CountedPath) -> f64 {
        let minutes = larger(needed_min, self.shortest_min);
        match (mode, self.path) {
            (FeedMode::InverseTime, FeedPath::InverseSeconds) => {
                smaller(1.0 / (60.0 * minutes), self.largest_inverse_time)
            }
            (FeedMode::InverseTime, _) => smaller(1.0 / minutes, self.largest_inverse_time),
            _ => {
                let counted = amount * if is_length { self.per_mm } else { 1.0 };
                self.held((counted / minutes).min(self.largest_word), needed_min)
            }
        }
    }

    /// An F, and the smallest one at least for a block that is held back for its shortest time alone.
    fn held(&self, value: f64, needed_min: f64) -> f64 {
        let minutes = needed_min.max(self.shortest_min);
        value.max(self.smallest.min(value * minutes / needed_min))
    }

    /// Time of a motion at the F in force, min; `None` without one.
    pub(crate) fn minutes(&self, stroke: &Stroke, state: &State) -> Option<f64> {
        let feed = state.feed.filter(|feed| *feed > 0.0)?;
        let extent = self.extent(stroke);
        let minutes = match state.feed_mode? {
            FeedMode::InverseTime if self.path == FeedPath::InverseSeconds => 1.0 / (60.0 * feed),
            FeedMode::InverseTime => 1.0 / feed,
            FeedMode::PerMinute => {
                let CountedPath { amount, is_length } = self.counted(&extent);
                amount * if is_length { self.per_mm } else { 1.0 } / feed
            }
            FeedMode::PerRevolution => {
                let length = stroke.length_mm / state.units.unwrap_or_default().in_mm();
                length / (feed * state.speed.filter(|speed| *speed > 0.0)?)
            }
        };
        Some(minutes)
    }

    /// Largest error of a rounded F.
    fn step(&self, mode: FeedMode, value: f64) -> f64 {
        match mode {
            // The last of its significant digits.
            FeedMode::InverseTime => 10_f64.powi(decade(value) + 1 - self.digits as i32),
            _ => 0.5 * self.smallest,
        }
    }

    /// Shortest and longest tip path that rounded ends may show. Where the axes move much farther than the tip, the
    /// rounding of the tool axis moves its ends, too.
    fn lengths(&self, stroke: &Stroke, extent: &PathExtent) -> (f64, f64) {
        let rotates = self.rotates(extent);
        let lever = rotates && extent.linear_mm > LEVER * stroke.length_mm;
        // A place between the ends of a motion is found by its tip and its tool axis together.
        let error = if lever {
            5.0
        } else if rotates {
            3.0
        } else {
            2.0
        } * self.unit_mm;
        let longest_mm = larger(stroke.longest_mm, stroke.length_mm);
        (larger(stroke.length_mm - error, 0.0), smaller(stroke.length_mm + error, longest_mm))
    }

    /// The slowest and the fastest motion that rounded words may show, by all but their lengths.
    fn slowest_and_fastest(&self, stroke: &Stroke, extent: &PathExtent) -> [PathExtent; 2] {
        // Three words may be off by √3 units together, two rotary ones by √2.
        let linear = if extent.linear_mm > 0.25 * self.unit_mm { 2.0 * self.unit_mm } else { 0.0 };
        let rotary = if self.rotates(extent) { self.unit_rad } else { 0.0 };
        [1.0, -1.0].map(|sign| PathExtent {
            length_mm: stroke.length_mm,
            perpendicular: extent.perpendicular,
            tip_rate_mm: stroke.tip_rate_mm[usize::from(sign > 0.0)],
            linear_mm: (extent.linear_mm - sign * linear).max(0.5 * linear),
            rotary_deg: (extent.rotary_deg - sign * 1.5 * rotary.to_degrees()).max(0.0),
            rotation_rad: (extent.rotation_rad + sign * rotary).max(rotary),
            least_min: self.least_min(stroke, sign),
        })
    }

    /// Smallest and largest F of the paths that rounded words may show.
    fn bounds(&self, feed: f64, stroke: &Stroke, extent: &PathExtent) -> (f64, f64) {
        let (shortest, longest) = self.lengths(stroke, extent);
        // The time of a tip that rests is another.
        let rests = self.unit_mm * (1.0 - F_NOISE);
        let lengths = [shortest, longest, rests, self.unit_mm];
        let lengths = lengths.into_iter().filter(|length| (shortest..=longest).contains(length));
        let ends = self.slowest_and_fastest(stroke, extent);
        lengths.fold((f64::INFINITY, 0.0), |(low, high), length_mm| {
            let [slow, fast] = ends.map(|end| self.value(feed, &PathExtent { length_mm, ..end }));
            (low.min(slow), high.max(fast))
        })
    }

    /// Whether a written F is between two values of F, but for its rounding.
    fn is_between(&self, written: f64, mode: FeedMode, low: f64, high: f64) -> bool {
        let beyond = larger(low - written, written - high);
        beyond <= 0.0 || beyond <= high * F_NOISE + self.step(mode, high)
    }

    /// Whether F is between that of the longest tip path and that of the shortest, the axes moving as their words show:
    /// both are within [`bounds`](Self::bounds), so that it is right. `tip_rates_mm`: speeds of the tip times the time
    /// of the block, slow and fast, both within what is allowed for the one that is measured; the second is 0 where
    /// nothing is known of it. Nothing is decided where rounding of anything but the length may change the rule.
    pub(crate) fn is_plainly_right(&self, stroke: &Stroke, state: &State, tip_rates_mm: [f64; 2]) -> bool {
        let (Some(programmed), Some(written)) = (Self::programmed(stroke), state.feed) else { return false };
        let extent = self.extent(stroke);
        let mode = self.mode(&extent);
        let (shortest, longest) = self.lengths(stroke, &extent);
        if state.feed_mode != Some(mode) {
            return false;
        }
        let [least_mm, most_mm] = tip_rates_mm.map(|rate_mm| self.even_mm(rate_mm));
        if self.along_tip || self.is_plain(&extent) {
            if least_mm > shortest {
                return false;
            }
            let expected = self.value(programmed, &extent);
            return self.is_between(written, mode, expected, expected);
        }
        let moves_plainly = mode == FeedMode::InverseTime || extent.linear_mm >= self.unit_mm;
        if shortest < self.unit_mm || !moves_plainly {
            return false;
        }
        let counted = self.counted(&extent);
        let least_min = self.least_needed_min(&extent, counted);
        let [low, high] = [larger(longest, most_mm), larger(shortest, least_mm)].map(|length_mm| {
            let needed_min = larger(length_mm / programmed, least_min);
            self.in_time(needed_min, mode, counted)
        });
        let within = mode != FeedMode::InverseTime || written <= self.largest_inverse_time;
        within && self.is_between(written, mode, low, high)
    }

    /// Whether the tip may rest, as far as rounded ends show.
    pub(crate) fn may_be_still(&self, stroke: &Stroke) -> bool {
        self.lengths(stroke, &self.extent(stroke)).0 < self.unit_mm
    }

    /// Whether the tip may move, as far as rounded ends show.
    pub(crate) fn may_move(&self, stroke: &Stroke) -> bool {
        self.lengths(stroke, &self.extent(stroke)).1 >= self.unit_mm
    }

    /// Where only the tool axis rotates, and the rotation of the rotary axes is unknown: degrees a minute, at most
    /// those of all rotary axes together.
    pub(crate) fn wrong_on_the_spot(&self, state: &State) -> Option<String> {
        let largest = self.reorient_rad_per_min.to_degrees() * f64::from(self.rotary_bits.count_ones()).sqrt();
        let feed = state.feed.unwrap_or(0.0);
        (feed <= 0.0 || feed > largest + self.step(FeedMode::PerMinute, largest)).then(|| {
            format!(
                "F is {} per minute where only the tool axis rotates, allowed at most {} degrees",
                Shown(feed),
                Shown(largest)
            )
        })
    }

    /// Where axis speeds may hold a block back, and the control finds the rotary angles: F is at most the feed of the
    /// tip.
    ///
    /// `changes`: `None` where the tool axis is held; then the block is no slower than the slowest linear axis. Else
    /// how far the axes move in each position that they may have; empty where that is unknown, and any lower F is
    /// right. Asked only for an F that needs it.
    pub(crate) fn wrong_within(
        &self,
        stroke: &Stroke,
        state: &State,
        changes: impl FnOnce() -> Option<Vec<[f64; MAX_AXES]>>,
    ) -> Option<String> {
        let programmed = Self::programmed(stroke)?;
        let still = Stroke { change: [0.0; MAX_AXES], ..stroke.clone() };
        let extent = self.extent(&still);
        let (mode, (low, most)) = (self.mode(&extent), self.bounds(programmed, &still, &extent));
        let feed = state.feed.unwrap_or(0.0);
        let high = most * (1.0 + F_NOISE) + self.step(mode, most);
        let suits = |least: f64| {
            let low = least * (1.0 - F_NOISE) - self.step(mode, most);
            state.feed_mode == Some(mode) && feed > 0.0 && (low..=high).contains(&feed)
        };
        // The least F is not above this.
        if suits(SLOWED_BY_ROUNDING * low) {
            return None;
        }
        let linear = self.speeds.iter().filter(|(index, _)| self.linear_bits & (1 << index) != 0);
        let slowest = linear.map(|(_, speed)| *speed).fold(f64::INFINITY, f64::min);
        let held_back = |change: &[f64; MAX_AXES]| {
            let stroke = Stroke { change: *change, ..stroke.clone() };
            let held = PathExtent { least_min: self.least_min(&stroke, 1.0), ..extent };
            self.bounds(programmed, &stroke, &held).0
        };
        // An axis may move as far as the longest path that rounded ends show, in the time of the shortest.
        let (shortest, longest) = self.lengths(&still, &extent);
        let share = if longest > 0.0 { shortest / longest } else { 0.0 };
        let least = match changes() {
            None => SLOWED_BY_ROUNDING * low.min(slowest * self.per_mm * share),
            Some(changes) if changes.is_empty() => 0.0,
            Some(changes) => SLOWED_BY_ROUNDING * changes.iter().map(held_back).fold(low, f64::min),
        };
        (!suits(least)).then(|| {
            let [feed, most, least] = [feed, most, least].map(Shown);
            format!("F is {feed} per minute, allowed at most {most}, at least {least}")
        })
    }

    /// What is wrong with F; `None` if it is right.
    pub(crate) fn wrong(&self, stroke: &Stroke, state: &State) -> Option<String> {
        let programmed = Self::programmed(stroke)?;
        let extent = self.extent(stroke);
        let (mode, expected) = (self.mode(&extent), self.value(programmed, &extent));
        if let (Some(written), true) = (state.feed, state.feed_mode == Some(mode)) {
            if mode == FeedMode::InverseTime && written > self.largest_inverse_time * (1.0 + F_NOISE) {
                let largest = self.largest_inverse_time;
                return Some(format!("F is {} in inverse time, allowed at most {}", Shown(written), Shown(largest)));
            }
            if self.is_between(written, mode, expected, expected) {
                return None;
            }
            let (low, high) = self.bounds(programmed, stroke, &extent);
            if self.is_between(written, mode, low, high) {
                return None;
            }
        }
        let (name, unit) = match mode {
            FeedMode::InverseTime => ("inverse-time feed", "1/min"),
            _ => ("feed per minute", "per minute"),
        };
        let expected = Shown(expected);
        Some(match state.feed {
            _ if state.feed_mode != Some(mode) => {
                let since = state.since_lost(state.feed_mode.is_none());
                format!("feed mode {name} is not active: expected {name} with F {expected} {unit}{since}")
            }
            None => format!("F is missing, expected {expected} {unit}"),
            Some(written) => format!("F is {} {unit}, expected {expected}", Shown(written)),
        })
    }
}

/// The largest power of ten, as its exponent, that is not above a number.
fn decade(value: f64) -> i32 {
    // The factor is log10(2) times 2^32, exact enough for every exponent; by the binary exponent alone the decade may
    // be one short.
    let binary = (value.abs().to_bits() >> 52) as i64 - 1023;
    let below = ((binary * 1_292_913_986) >> 32) as i32;
    if value.abs() >= 10_f64.powi(below + 1) { below + 1 } else { below }
}

/// Whether the linear axes are perpendicular to each other wherever the rotary axes are: the path of the words is as
/// long as that of the tip. By each angle of a rotary axis between two of them their product is
/// `a + b cos θ + c sin θ`: it is zero everywhere if it is so at three angles.
pub(super) fn is_perpendicular(machine: &dyn AnyMachine) -> bool {
    let axes = machine.axes();
    let linear =
        (0..axes.len()).filter(|&index| axes[index].kind == AxisKind::Linear && !axes[index].held).collect::<Vec<_>>();
    let turns = |index: usize| {
        let thirds: &[f64] = if axes[index].held { &[0.0] } else { &[0.0, 1.0, 2.0] };
        let (joint, start) = (machine.joint(index), machine.held()[index]);
        thirds.iter().map(move |third| {
            let angle = if axes[index].held { start } else { third * TAU / 3.0 };
            Rotation3::from_axis_angle(&joint.direction, joint.sign * angle)
        })
    };
    let stays = |one: usize, other: usize| {
        let mut placed = vec![machine.joint(other).direction.into_inner()];
        for index in (one + 1..other).rev().filter(|&index| axes[index].kind == AxisKind::Rotary) {
            placed = turns(index).flat_map(|turn| placed.iter().map(move |direction| turn * direction)).collect();
        }
        placed.iter().all(|direction| machine.joint(one).direction.dot(direction).abs() < PERPENDICULAR_AXES)
    };
    linear.iter().enumerate().all(|(place, &one)| linear[place + 1..].iter().all(|&other| stays(one, other)))
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
            largest_inverse_time: f64::INFINITY,
            largest_word: f64::INFINITY,
            shortest_min: shortest / 60.0,
            reorient_rad_per_min: 1800_f64.to_radians(),
            unit_mm: 0.01,
            unit_rad: 1e-3_f64.to_radians(),
            smallest: 0.01,
            digits: 6,
            along_tip: false,
            per_mm: 1.0,
        }
    }

    fn stroke(length: f64, degrees: f64, feed: f64) -> Stroke {
        let mut change = [0.0; MAX_AXES];
        (change[0], change[1]) = (length, degrees.to_radians());
        let feed = Some(Feed::PerMinute(feed));
        let (longest_mm, tip_rate_mm) = (f64::INFINITY, [0.0; 2]);
        Stroke {
            length_mm: length,
            longest_mm,
            tip_rate_mm,
            perpendicular: true,
            change,
            uneven: None,
            feed,
            speed_rev_per_min: None,
        }
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

    /// Where the tool axis is held an axis may move by two units in a step that looks as long as one.
    #[test]
    fn a_step_of_a_unit_may_be_slower_than_its_tip_asks_for() {
        let law = FeedLaw { speeds: vec![(0, 700.0)], along_tip: true, ..law(0.0) };
        let slower = |length: f64, feed: f64| {
            let state = State { feed: Some(feed), feed_mode: Some(FeedMode::PerMinute), ..State::default() };
            law.wrong_within(&stroke(length, 0.0, 600.0), &state, || None).is_none()
        };
        assert!(slower(0.01, 600.0) && slower(0.01, 400.0) && slower(1.0, 600.0));
        assert!(!slower(1.0, 400.0) && !slower(0.01, 650.0));
    }

    #[test]
    fn the_decade_of_a_number_is_that_of_its_first_digit() {
        for exponent in -20..20 {
            for digit in [1.0, 1.000_000_1, 2.0, 4.999, 8.0, 9.999_999] {
                let value: f64 = format!("{digit}e{exponent}").parse().expect("a number");
                assert_eq!(decade(value), exponent, "{value}");
            }
        }
    }

    #[test]
    fn no_f_is_plainly_right_that_the_law_refuses() {
        use FeedPath::{InverseMinutes, InverseSeconds, Linear, LinearAndDegrees};
        let (mut decided, speeds) = (0, [Vec::new(), vec![(0, 500.0), (1, 20.0)]]);
        let paths = [InverseMinutes, InverseSeconds, Linear, LinearAndDegrees];
        for (path, speeds) in paths.iter().flat_map(|path| speeds.iter().map(|speeds| (*path, speeds))) {
            for (held_s, seen) in (1..=400).map(|step| {
                let size = 1.02_f64.powi(step) * 1e-3;
                let degrees = [0.0, 0.001, 0.01, 0.3, 3.0][step as usize % 5] * size;
                (0.01 * f64::from(step % 3), Stroke { length_mm: size, ..stroke(size * 0.7, degrees, 600.0) })
            }) {
                let law = FeedLaw { path, speeds: speeds.clone(), largest_mm_per_min: 900.0, ..law(held_s) };
                for faster in [0.0, 1.0, 1.02, 1.1, 1.5] {
                    let rates_mm = [faster * seen.length_mm, faster * (1.01 * seen.length_mm + 0.002)];
                    let followed = Stroke { tip_rate_mm: rates_mm, ..seen.clone() };
                    let extent = law.extent(&followed);
                    let (mode, expected) = (law.mode(&extent), law.value(600.0, &extent));
                    for part in -60..=60 {
                        let feed = expected * (1.0 + 0.002 * f64::from(part));
                        let state = State { feed: Some(feed), feed_mode: Some(mode), ..State::default() };
                        let plainly = law.is_plainly_right(&seen, &state, rates_mm);
                        assert!(!plainly || law.wrong(&followed, &state).is_none(), "{law:?} {followed:?} {feed}");
                        decided += i32::from(plainly);
                    }
                }
            }
        }
        assert!(decided > 25_000, "{decided}");
    }

    #[test]
    fn a_path_of_no_length_keeps_the_largest_feed_too() {
        let (law, seen) = (FeedLaw { largest_mm_per_min: 900.0, ..law(0.0) }, stroke(0.0, 0.0, 8000.0));
        let feeds = [900.0, 8000.0];
        assert_eq!(feeds.map(|feed| passes(&law, &seen, FeedMode::PerMinute, feed)), [true, false]);
    }

    #[test]
    fn a_short_path_may_be_shorter_than_its_rounded_ends() {
        // 0.046 mm known to 0.03: it may have been 0.016, or 0.076.
        let (law, seen) = (law(0.0), stroke(0.046, 1.0, 600.0));
        let feeds = [600.0 / 0.0165, 600.0 / 0.0155, 600.0 / 0.074];
        assert_eq!(feeds.map(|feed| passes(&law, &seen, FeedMode::InverseTime, feed)), [true, false, true]);
        assert!(!passes(&law, &seen, FeedMode::InverseTime, 600.0 / 0.1));
    }

    #[test]
    fn a_tip_that_is_led_unevenly_is_a_hundredth_faster_at_most() {
        // 2 mm with the speed of 6.06 mm in the same time, which rounding may show as 6.04; its bound is 6.2 mm.
        let (law, seen) = (law(0.0), Stroke { tip_rate_mm: [6.08, 6.2], ..stroke(2.0, 30.0, 600.0) });
        let feeds = [600.0 / 2.0, 600.0 / 5.95, 600.0 / 6.0, 600.0 / 6.1, 600.0 / 6.2];
        let told = feeds.map(|feed| passes(&law, &seen, FeedMode::InverseTime, feed));
        assert_eq!(told, [false, false, true, true, false]);
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
