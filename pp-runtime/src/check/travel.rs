//! Whether the axes stay within their travel.
//!
//! Rotary limits are axis values; linear ones machine coordinates, `machine_zero + value + what the tool adds`. Where the
//! machine zero is not known only the span of a linear axis is compared.
//!
//! Limits are a box of axis values, and so is what the axes may run through in a G0 in which each goes as fast as it can:
//! where both of its ends are inside, all of it is. That holds for every straight block whose words are axis values, and in
//! a tilted plane, whose words are axis values turned. It does not hold for arcs, nor under tip control, where linear axes
//! follow the rotary ones: there each axis is followed to the places where it goes farthest (`reach`), and these are told.
//! For a G0 that need not be interpolated that is every pair of rotary values, at every corner of the box of the linear
//! words: for a pair of rotary values linear axes are affine in the words, so that corners suffice.
//!
//! Where the control turns the tool axis in the plane of its ends, or is given that axis in the place of angles, its rotary
//! axes are followed from where they stand, by small steps. At the rim of their travel another position of theirs is sought,
//! as the control does; how it gets there is its own affair, and is not looked at.
//!
//! What the tip does in a G0 that turns rotary axes at the part is not judged: with `transition = "safe"` there is none
//! beyond the index angle, and who writes `"direct"` has the CL data answer for it.

use std::f64::consts::TAU;
use std::io::Read;

use nalgebra::Vector3;

use super::chain::Placed;
use super::compare::Checker;
use super::follow::{between, sweep};
use super::path::{Segment, Shape};
use super::reach::{Place, Reach, Search, highest};
use super::read::{Action, Block, Family, MAX_AXES, TipControl};
use super::report::Shown;
use super::words::Words;
use crate::config::Config;
use crate::kinematics::{AnyMachine, AxisKind, Limits};
use crate::motion::ToolPosture;

/// Places of a block that are looked at are no farther apart than these angles, rad: of the rotary axes, of which two may
/// add up, and of an arc; unless they would be more than so many.
const TURNED: f64 = 0.05;
const SWEPT: f64 = 0.2;
const MOST_STEPS: f64 = 2000.0;

/// Rotary axes that a control turns by itself are followed in steps of no more than this, rad; nearer than that they are in
/// one place.
const MOST_TURNED: f64 = 4.0 * TURNED;
const SAME_PLACE: f64 = 1e-3;

/// Places of each rotary axis from where another position is sought.
const SEEDS: u32 = 9;

/// Rotary values of a G0 that are paired are no farther apart than this, rad, unless they would be more than so many.
const PAIRED: f64 = 0.05;
const MOST_PAIRED: f64 = 60.0;

/// Noise of sums that must not turn an inclusive limit into an exclusive one, mm and rad.
const NOISE: f64 = 1e-6;

/// Travel of one axis.
#[derive(Debug, Clone, Copy)]
struct Axis {
    index: usize,
    letter: char,
    rotary: bool,
    limits: Limits,
    zero: Option<f64>,
    span: (f64, f64),
}

/// Travel of every axis that has limits.
#[derive(Debug, Clone, Default)]
pub(super) struct Travel {
    axes: Vec<Axis>,
}

impl Travel {
    pub(super) fn new(machine: &dyn AnyMachine, config: &Config, words: &Words) -> Self {
        let limits = config.set_up.travel(machine.axes()).limits;
        let solved = words.linear_mask | words.rotary_mask;
        let axis = |(index, axis): (usize, &crate::kinematics::Axis)| {
            let limits = limits[index].filter(|_| solved & (1 << index) != 0)?;
            Some(Axis {
                index,
                letter: axis.letter,
                rotary: axis.kind == AxisKind::Rotary,
                limits,
                zero: config.set_up.machine_zero.get(&axis.letter).copied(),
                span: (f64::INFINITY, f64::NEG_INFINITY),
            })
        };
        Self { axes: machine.axes().iter().enumerate().filter_map(axis).collect() }
    }

    /// Whether any axis has limits.
    pub(super) fn limited(&self) -> bool {
        !self.axes.is_empty()
    }

    /// The first axis that leaves its travel by more than `slack` where the words say.
    fn check(&mut self, words: &Words, values: &[f64; MAX_AXES], known: u16, slack: f64) -> Option<String> {
        let mut axes = self.axes.iter_mut().filter(|axis| known & (1 << axis.index) != 0);
        axes.find_map(|axis| axis.judge(values[axis.index], words, slack))
    }

    /// Values between which nothing new is to be learnt.
    fn quiet(&self, words: &Words) -> Reach {
        let mut quiet = Reach { low: [f64::NEG_INFINITY; MAX_AXES], high: [f64::INFINITY; MAX_AXES] };
        for axis in &self.axes {
            let ((low, high), zero) = (axis.bounds(), axis.zero(words));
            (quiet.low[axis.index], quiet.high[axis.index]) = (low - zero, high - zero);
        }
        quiet
    }

    /// Whether a rotary axis is outside its travel.
    fn turned_over(&self, values: &[f64; MAX_AXES]) -> bool {
        let mut rotary = self.axes.iter().filter(|axis| axis.rotary);
        rotary.any(|axis| axis.outside(values[axis.index], NOISE).is_some())
    }

    /// Axes with limits: bits.
    fn mask(&self) -> u16 {
        self.axes.iter().fold(0, |mask, axis| mask | 1 << axis.index)
    }

    /// The same for a machine coordinate.
    pub(super) fn check_machine(&self, index: usize, coordinate: f64) -> Option<String> {
        self.axes.iter().find(|axis| axis.index == index)?.outside(coordinate, NOISE)
    }
}

impl<R: Read> Checker<'_, R> {
    /// Whether the axes stay within their travel where a block ends.
    pub(super) fn limits(&mut self, block: &Block, shown: Shown<'_>) {
        let solved = self.words.linear_mask | self.words.rotary_mask;
        let direct = block.state.tip_control == TipControl::Off && block.state.tilt.is_none();
        if self.travel.limited() && (direct || block.known & solved == solved) {
            self.inside(block, shown);
        }
    }

    /// Whether they do on its way from the block before.
    pub(super) fn limits_on_way(&mut self, block: &Block, shown: Shown<'_>) {
        if !self.travel.limited() {
            return;
        }
        let (before, known) = self.before;
        let (rotary, chosen) = (self.words.rotary_mask, block.state.vector.is_some());
        let stood = self.stands.take();
        if !chosen && block.known & rotary == rotary {
            self.stands = Some(block.values);
        }
        let known = known & block.known & self.words.linear_mask == self.words.linear_mask;
        let Some(stood) = stood else { return };
        // Where linear axes come from may not be known; how the control turns the rotary ones there is.
        let from = self.words.with_rotary(if known { before } else { block.values }, &stood);
        let turned = match block.state.tip_control {
            TipControl::On { .. } if !chosen => self.words.rotary_way(&from, &block.values),
            _ => 0.0,
        };
        let sweep = sweep(block);
        if chosen || (turned > 0.0 && known && self.turns_in_plane(block)) {
            self.limits_in_plane(block, from, turned, shown);
        } else if !known || (turned <= 0.0 && sweep <= 0.0) {
        } else if block.action == Action::Rapid && !self.interpolates_rapids() {
            self.limits_of_pairs(block, shown);
        } else {
            self.limits_of_interpolated(block, turned, sweep, shown);
        }
    }

    /// The control turns the tool axis in the plane of its ends: in each block whose axes arrive together.
    fn turns_in_plane(&self, block: &Block) -> bool {
        self.config.motion.tip.tool_posture == ToolPosture::Plane
            && (block.action != Action::Rapid || self.interpolates_rapids())
    }

    /// A block in which the control turns the tool axis evenly from where it stands, and finds the rotary axes itself.
    fn limits_in_plane(&mut self, block: &Block, from: [f64; MAX_AXES], turned: f64, shown: Shown<'_>) {
        let (words, places, state) = (&self.words, self.words.linear_places(), &block.state);
        let placed = |axis: Vector3<f64>| Placed { tip: Vector3::zeros(), axis };
        let (start, end) = (placed(words.tool_axis(&from)), placed(words.place(&block.values, state).axis));
        let turn = Segment { from: start, to: end, shape: Shape::Line };
        let at = |share: f64, near: &Place| {
            let here = words.with_rotary(between(&from, block, share, places), &near.words);
            let here = words.turned_to(&here, &turn.at(share).axis)?;
            let moved = words.rotary_way(&here, &near.words);
            let values = words.axes_turned(&here, state).filter(|_| moved <= MOST_TURNED)?;
            Some(Place { share, words: here, values })
        };
        let Some(values) = words.axes_turned(&from, state) else { return };
        let (first, quiet) = (Place { share: 0.0, words: from, values }, self.travel.quiet(words));
        let mut search = Search { at, quiet: &quiet, axes: self.travel.mask(), reach: Reach::of(&values) };
        let last = search.go(first, 1.0, step(turned.max(turn.turn()), sweep(block)));
        let reach = search.reach;
        if last.share < 1.0 {
            return;
        }
        if block.state.vector.is_none() {
            // Past the pole the axes may have swung to the other position that shows the same tool axis.
            if words.rotary_way(&last.words, &block.values) <= SAME_PLACE {
                self.judge(&reach, [&values, &last.values], "within this block ", shown);
            }
            return;
        }
        self.stands = Some(last.words);
        match self.travel.turned_over(&last.values).then(|| self.other_position(&last.words, &end.axis)).flatten() {
            Some(other) => self.stands = Some(other),
            None => self.judge(&reach, [&values, &last.values], "within this block ", shown),
        }
    }

    /// Another position of the rotary axes with the same tool axis, inside their travel: the one that is nearest.
    fn other_position(&self, words: &[f64; MAX_AXES], axis: &Vector3<f64>) -> Option<[f64; MAX_AXES]> {
        let mut turning = (0..MAX_AXES).filter(|index| self.words.rotary_mask & (1 << index) != 0);
        let (first, second) = (turning.next()?, turning.next()?);
        let found = (0..SEEDS * SEEDS).filter_map(|seed| {
            let mut words = *words;
            words[first] += TAU * (f64::from(seed % SEEDS) / f64::from(SEEDS) - 0.5);
            words[second] += TAU * (f64::from(seed / SEEDS) / f64::from(SEEDS) - 0.5);
            let words = self.words.turned_to(&words, axis)?;
            (!self.travel.turned_over(&self.words.values(&words))).then_some(words)
        });
        let way = |there: &[f64; MAX_AXES]| self.words.rotary_way(words, there);
        found.min_by(|a, b| way(a).total_cmp(&way(b)))
    }

    /// A block whose axes all arrive together: the rotary ones turn so far at the most, an arc goes round so far, rad.
    fn limits_of_interpolated(&mut self, block: &Block, turned: f64, sweep: f64, shown: Shown<'_>) {
        let (before, places) = (self.before.0, self.words.linear_places());
        let at = |share: f64, _: &Place| {
            let words = between(&before, block, share, places);
            self.words.axes(&words, &block.state).map(|values| Place { share, words, values })
        };
        let Some(values) = self.words.axes(&before, &block.state) else { return };
        let first = Place { share: 0.0, words: before, values };
        let (quiet, step) = (self.travel.quiet(&self.words), step(turned, sweep));
        let mut search = Search { at, quiet: &quiet, axes: self.travel.mask(), reach: Reach::of(&values) };
        // Turns of a helix differ by its rise alone: what goes farthest does so in the first or the last.
        let turn = TAU / sweep;
        let late = if turned <= 0.0 && turn < 0.5 {
            search.go(first, turn, step);
            (search.at)(1.0 - turn, &first).unwrap_or(first)
        } else {
            first
        };
        let last = search.go(late, 1.0, step);
        let reach = search.reach;
        self.judge(&reach, [&first.values, &last.values], "within this block ", shown);
    }

    /// Tells each axis that leaves its travel on the way of a block, farther than at the ends of it.
    fn judge(&mut self, reach: &Reach, ends: [&[f64; MAX_AXES]; 2], place: &str, shown: Shown<'_>) {
        // Between its ends a block may leave its path by the tolerance.
        let slack = self.config.motion.tolerance_mm;
        for axis in &mut self.travel.axes {
            for side in [1.0, -1.0] {
                let farthest = reach.bound(axis.index, side);
                if ends.iter().all(|end| farthest > side * end[axis.index] + NOISE)
                    && let Some(text) = axis.judge(side * farthest, &self.words, slack)
                {
                    self.tally.outcome.outside_limits += 1;
                    self.tally.found(self.served, shown, &format!("{place}{text}"), None);
                }
            }
        }
    }

    /// All axes of a G0 arrive together, as in a feed motion, under tip control at least. On a Siemens they do while a
    /// transformation is active (programming manual of the Sinumerik One, RTLIOF), every straight line of a Heidenhain is
    /// one, and a G0 of LinuxCNC is coordinated; on a Fanuc parameter 1401#1 says so, on a Haas a setting.
    fn interpolates_rapids(&self) -> bool {
        let usual = !matches!(self.family, Family::Fanuc | Family::Haas);
        self.config.control.linear_rapids.unwrap_or(usual)
    }

    /// A G0 under tip control in which each rotary axis runs on its own, and so do the words of the tip.
    fn limits_of_pairs(&mut self, block: &Block, shown: Shown<'_>) {
        let before = self.before.0;
        let counts: [u32; MAX_AXES] = std::array::from_fn(|index| {
            let turned = (block.values[index] - before[index]).abs();
            let rotary = self.words.rotary_mask & (1 << index) != 0;
            if rotary { (turned / PAIRED).ceil().min(MOST_PAIRED) as u32 + 1 } else { 1 }
        });
        let at = |words: &[f64; MAX_AXES]| self.words.axes(words, &block.state);
        let (Some(first), Some(last)) = (at(&before), at(&block.values)) else { return };
        let mut reach = Reach::of(&first);
        let mut farthest = [[before; 2]; MAX_AXES];
        for words in pairs(&before, &block.values, counts, self.words.linear_mask) {
            let Some(values) = at(&words) else { continue };
            for (index, value) in values.into_iter().enumerate() {
                if value < reach.low[index] {
                    farthest[index][0] = words;
                }
                if value > reach.high[index] {
                    farthest[index][1] = words;
                }
            }
            reach.take(&values);
        }
        let quiet = self.travel.quiet(&self.words);
        for axis in &self.travel.axes {
            // Between two pairs a value rises by less than it does over all of them.
            let room = reach.high[axis.index] - reach.low[axis.index];
            for (side, words) in [-1.0, 1.0].into_iter().zip(farthest[axis.index]) {
                if reach.bound(axis.index, side) + room > quiet.bound(axis.index, side) {
                    let value =
                        |words: &[f64; MAX_AXES]| at(words).map_or(f64::NEG_INFINITY, |at| side * at[axis.index]);
                    let words = farther(&before, &block.values, counts, words, value);
                    reach.take(&at(&words).unwrap_or(first));
                }
            }
        }
        self.judge(&reach, [&first, &last], "if each axis of this rapid moves on its own, ", shown);
    }

    /// Whether the axes are within their travel at the words of a block; says so if not.
    fn inside(&mut self, block: &Block, shown: Shown<'_>) {
        let turned = if block.state.vector.is_some() { self.stands } else { Some(block.values) };
        let values = turned.and_then(|words| self.words.axes_turned(&words, &block.state));
        let Some(values) = values else { return };
        let Some(text) = self.travel.check(&self.words, &values, block.known, NOISE) else { return };
        self.tally.outcome.outside_limits += 1;
        self.tally.found(self.served, shown, &text, None);
    }
}

/// Steps in which a block is looked at that turns and goes round so far, rad.
fn step(turned: f64, sweep: f64) -> f64 {
    1.0 / (turned / TURNED + sweep / SWEPT).ceil().clamp(2.0, MOST_STEPS)
}

/// Every pair of rotary values at every corner of the box of the linear words: so many values of each axis.
fn pairs(
    from: &[f64; MAX_AXES],
    to: &[f64; MAX_AXES],
    counts: [u32; MAX_AXES],
    linear: u16,
) -> impl Iterator<Item = [f64; MAX_AXES]> {
    let all: u32 = counts.iter().product();
    let corners = (0..=linear).filter(move |corner| corner & !linear == 0);
    corners.flat_map(move |corner| (0..all).map(move |pair| (corner, pair))).map(move |(corner, pair)| {
        let mut rest = pair;
        std::array::from_fn(|index| {
            let (step, last) = (rest % counts[index], counts[index] - 1);
            rest /= counts[index];
            let share = match corner & (1 << index) {
                0 if last == 0 => 0.0,
                0 => f64::from(step) / f64::from(last),
                _ => 1.0,
            };
            from[index] + (to[index] - from[index]) * share
        })
    })
}

/// From the best pair to the place near to it where a value is largest: one rotary axis after the other, twice.
fn farther(
    from: &[f64; MAX_AXES],
    to: &[f64; MAX_AXES],
    counts: [u32; MAX_AXES],
    mut words: [f64; MAX_AXES],
    value: impl Fn(&[f64; MAX_AXES]) -> f64,
) -> [f64; MAX_AXES] {
    for index in (0..MAX_AXES).chain(0..MAX_AXES).filter(|index| counts[*index] > 1) {
        let step = (to[index] - from[index]).abs() / f64::from(counts[index] - 1);
        let (least, most) = (from[index].min(to[index]), from[index].max(to[index]));
        let with = |word: f64| {
            let mut moved = words;
            moved[index] = word;
            moved
        };
        let (low, high) = ((words[index] - step).max(least), (words[index] + step).min(most));
        let better = with(highest(low, high, |word| value(&with(word))));
        if value(&better) > value(&words) {
            words = better;
        }
    }
    words
}

impl Axis {
    /// What is more than its value where it is compared, mm.
    fn zero(&self, words: &Words) -> f64 {
        if self.rotary { 0.0 } else { self.zero.unwrap_or(0.0) + words.gauge_of(self.index) }
    }

    /// Its limits; the span so far where these cannot be told from it.
    fn bounds(&self) -> (f64, f64) {
        let known = self.rotary || self.zero.is_some();
        if known { (self.limits.lower, self.limits.upper) } else { self.span }
    }

    /// What is wrong where it goes to a value, by more than `slack`.
    fn judge(&mut self, value: f64, words: &Words, slack: f64) -> Option<String> {
        let place = value + self.zero(words);
        if self.rotary || self.zero.is_some() {
            return self.outside(place, slack);
        }
        self.span = (self.span.0.min(place), self.span.1.max(place));
        let (span, travel) = (self.span.1 - self.span.0, self.limits.upper - self.limits.lower);
        (span > travel + slack)
            .then(|| format!("{} needs {span:.3} mm of travel, its limits allow {travel:.3} mm", self.letter))
    }

    fn outside(&self, place: f64, slack: f64) -> Option<String> {
        let Limits { lower, upper } = self.limits;
        let slack = if self.rotary { NOISE } else { slack };
        if (lower - slack..=upper + slack).contains(&place) {
            return None;
        }
        let shown = |value: f64| if self.rotary { value.to_degrees() } else { value };
        let [place, lower, upper] = [place, lower, upper].map(shown);
        Some(format!("{} moves to {place:.4}, outside its limits {lower:.4} to {upper:.4}", self.letter))
    }
}
