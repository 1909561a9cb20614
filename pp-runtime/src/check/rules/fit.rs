//! Whether a block ends on a motion of the CL data, and its deviation from the path between its ends: at points, unless
//! a bound from the rates of its axes decides.

use std::f64::consts::FRAC_PI_2;

use nalgebra::{SVector, Vector3};

use super::super::geometry::{ArcPath, PathShape, Segment, ToolPose, angle_between};
use super::super::policy::RapidForm;
use super::super::read::{Action, ArcMove, Block, MAX_AXES, TipControl};
use super::Rules;
use crate::check::tolerances::{
    AXIS_NOISE, BOTH, CONTROL_CHOOSES_NEAR_POLE, HELD_AXIS, POLE_DRIFT, SAME_REVOLUTION, SAME_SHARE, UNEVEN_NEAR_POLE,
};
use crate::kinematics::math::larger;

/// Points of a block that are compared besides its ends, and one more for each of these angles that it rotates, rad.
const POINTS: f64 = 3.0;
const ANGLE_PER_POINT: f64 = 0.02;
const MOST_POINTS: f64 = 400.0;

/// A step of the rotary axes to the end of a motion below which its square is far below a unit of rotary words, rad.
const LAST_STEP: f64 = 1e-4;

/// A position along a motion of the CL data.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Arrival<'h> {
    /// Share of the motion that was done before the block.
    pub(crate) along: f64,
    /// Pose before the block.
    pub(crate) here: Option<&'h ToolPose>,
    /// Chords of arcs by their angle since the words last gave the position in their plane, in diameters.
    pub(crate) chords: f64,
}

/// A block from the words before it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct BlockPath<'b> {
    pub(crate) before: [f64; MAX_AXES],
    pub(crate) block: &'b Block,
    /// X, Y and Z in the chain.
    pub(crate) xyz: [Option<usize>; 3],
}

/// Largest deviations of a block from its motion, between its ends.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Deviation {
    pub(crate) tip_mm: f64,
    pub(crate) axis_rad: f64,
    /// Angle of the tool axis from the programmed one where the tip is on its line, rad.
    pub(crate) lag_rad: f64,
    /// Largest speed of the tip times the time of the block, mm; 0 where no rotary axis rotates.
    pub(crate) tip_rate_mm: f64,
}

/// Bounds of the deviation of a block from its motion, between its ends, from the rates of its axes alone.
#[derive(Debug, Clone, Copy)]
pub(crate) struct DeviationBound {
    pub(crate) tip_mm: f64,
    pub(crate) axis_rad: f64,
    /// Largest speed of the tip times the time of the block, mm.
    pub(crate) tip_rate_mm: f64,
}

/// Largest speed of a tip or an axis that is followed from point to point, as steps from one to the next.
#[derive(Debug, Clone, Copy)]
pub(super) struct FastestStep<const N: usize> {
    /// The last three, the newest first.
    last: [SVector<f64, N>; 3],
    count: u32,
    largest: f64,
}

impl<const N: usize> Default for FastestStep<N> {
    fn default() -> Self {
        Self { last: [SVector::zeros(); 3], count: 0, largest: 0.0 }
    }
}

impl<const N: usize> FastestStep<N> {
    pub(super) fn add(&mut self, step: SVector<f64, N>) {
        self.last = [step, self.last[0], self.last[1]];
        self.count += 1;
        self.largest = self.largest.max(step.norm());
        if self.count == 3 {
            let [third, second, first] = self.last;
            self.largest = self.largest.max(Self::at_end([first, second, third]));
        }
    }

    /// The largest of all, of at least three steps.
    pub(super) fn largest(&self) -> f64 {
        self.largest.max(Self::at_end(self.last))
    }

    /// Speed where the first of three steps begins: that of the parabola with these steps.
    fn at_end([a, b, c]: [SVector<f64, N>; 3]) -> f64 {
        ((a * 11.0 - b * 7.0 + c * 2.0) / 6.0).norm()
    }
}

impl BlockPath<'_> {
    /// Words at a share of the block.
    pub(crate) fn at(&self, share: f64) -> [f64; MAX_AXES] {
        let (before, block) = (&self.before, self.block);
        let mut words: [f64; MAX_AXES] =
            std::array::from_fn(|index| before[index] + (block.values[index] - before[index]) * share);
        if let (Action::Arc(ArcMove { centre, sweep, .. }), Some(plane)) = (&block.action, block.state.plane) {
            let [u, v, _] = plane.axes();
            if let (Some(first), Some(second)) = (self.xyz[u], self.xyz[v]) {
                let (x, y) = (before[first] - centre[u], before[second] - centre[v]);
                let (sine, cosine) = (sweep * share).sin_cos();
                words[first] = centre[u] + x * cosine - y * sine;
                words[second] = centre[v] + x * sine + y * cosine;
            }
        }
        words
    }
}

impl Rules<'_> {
    pub(crate) fn path<'b>(&self, before: [f64; MAX_AXES], block: &'b Block) -> BlockPath<'b> {
        BlockPath { before, block, xyz: self.words.xyz() }
    }

    /// Whether rounded words of the end of a motion are those already active.
    pub(crate) fn needs_no_block(&self, segment: &Segment, here: Option<&ToolPose>, chords: f64) -> bool {
        let here = here.filter(|here| self.may_need_no_block(here, &segment.to, chords));
        if here.is_none() {
            return false;
        }
        let short = segment.length() <= 2.0 * self.rounding.tip_mm;
        let here = here.filter(|_| short || matches!(segment.shape, PathShape::Line));
        // A point that repeats needs no block, wherever the arcs before it have ended.
        let times = if short { drift(chords) } else { 1.0 };
        here.is_some_and(|here| self.is_near(here, &segment.to, [times, 1.0]))
    }

    /// Whether a motion of which only the end is known may need no block: no path allows more.
    pub(crate) fn may_need_no_block(&self, here: &ToolPose, to: &ToolPose, chords: f64) -> bool {
        self.is_near(here, to, [drift(chords), 1.0])
    }

    /// Share of a motion that is done when a block ends at `end`; `None` if it ends elsewhere. `rapid`: it is one in
    /// the CL data.
    pub(crate) fn share_done(
        &self,
        segment: &Segment,
        rapid: bool,
        block: &Block,
        (before, end): (&[f64; MAX_AXES], &ToolPose),
        arrival: &Arrival<'_>,
    ) -> Option<f64> {
        let is_arc = matches!(segment.shape, PathShape::Arc(_));
        if !is_arc && (self.is_at(end, &segment.to) || self.is_at_with_held_axis(end, segment)) {
            return Some(1.0);
        }
        self.share_within(segment, rapid, block, (before, end), arrival)
    }

    /// Whether a block ends with a motion that rotates the tool axis by the digits of CL data, through which it is
    /// held.
    #[inline(never)]
    fn is_at_with_held_axis(&self, end: &ToolPose, segment: &Segment) -> bool {
        segment.turn() <= BOTH * HELD_AXIS
            && (end.tip - segment.to.tip).norm() <= self.rounding.tip_mm
            && angle_between(&end.axis, &segment.to.axis) <= self.rounding.axis_rad + HELD_AXIS
    }

    /// The share for an arc, and where the block does not end with the motion.
    #[inline(never)]
    fn share_within(
        &self,
        segment: &Segment,
        rapid: bool,
        block: &Block,
        (before, end): (&[f64; MAX_AXES], &ToolPose),
        arrival: &Arrival<'_>,
    ) -> Option<f64> {
        let rounding = &self.rounding;
        let along = arrival.along;
        let on_arc = match (&block.action, &segment.shape) {
            (Action::Arc(arc), PathShape::Arc(path)) => {
                Some(path.share_near(&end.tip, along + path.share_of(arc.sweep.abs())))
            }
            _ => None,
        };
        let is_done = |share: f64| (share - 1.0).abs() * segment.angle() < SAME_REVOLUTION;
        if on_arc.is_some_and(is_done) && self.is_at(end, &segment.to) {
            return Some(1.0);
        }
        let is_led = self.policy.tolerances.has_steps
            || self.pole.is_some_and(|pole| {
                let arc = segment.axis_arc();
                [pole, -pole].iter().any(|pole| arc.is_within(pole, self.policy.tolerances.pole_rad))
            });
        let axis = match is_led {
            _ if self.is_led_through_pole(segment, block) => rounding.pole_rad + self.largest_bend_rad(),
            true => rounding.pole_rad,
            false => rounding.axis_rad,
        };
        let share = on_arc.unwrap_or_else(|| segment.share(end, along, rounding.tip_mm, rounding.tip_mm / axis));
        let done = is_done(share);
        if matches!(segment.shape, PathShape::Arc(_)) && done && self.is_at(end, &segment.to) {
            return Some(1.0);
        }
        // An arc by its angle ends where its rounded centre leads, not at a position of words.
        let polar = match &block.action {
            Action::Arc(ArcMove { by_angle: true, sweep, .. }) => drift(arrival.chords + chord(*sweep)),
            _ => 1.0,
        };
        if polar > 1.0 && done && (end.tip - segment.to.tip).norm() <= polar * rounding.tip_mm {
            return Some(1.0);
        }
        let links = &self.policy.links;
        if rapid && let Some(corner) = self.corner(segment, end, arrival) {
            return Some(corner);
        }
        if rapid && !self.may_be_in_pieces(block) {
            return None;
        }
        let rewinds = links.rewinds_in_cut
            && !self.needs_no_block(segment, arrival.here, arrival.chords)
            && arrival.here.is_some_and(|here| (here.tip - end.tip).norm() <= 2.0 * rounding.tip_mm);
        let elsewhere = || {
            let by_tip = |here: &ToolPose| segment.share(here, along, rounding.tip_mm, 0.0).clamp(0.0, 1.0);
            // Where the tool axis is near its arc, too, the share done before the block is a mean of both.
            let evenly = |along: f64| self.evenly_done(segment, block, (before, end), along);
            let done = evenly(along).or_else(|| arrival.here.map(by_tip).and_then(evenly)).or(rewinds.then_some(along));
            done.or_else(|| self.rotated_on_spot(segment, block, end, arrival))
        };
        if !(along - SAME_SHARE..=1.0 + SAME_SHARE).contains(&share)
            && !self.is_just_before(segment, share, along, axis)
        {
            return elsewhere();
        }
        let on = segment.at(share.clamp(0.0, 1.0));
        let near = (end.tip - on.tip).norm() <= BOTH * polar * rounding.tip_mm
            && angle_between(&end.axis, &on.axis) <= BOTH * axis;
        if near { Some(share.clamp(along, 1.0)) } else { elsewhere() }
    }

    /// Largest angle between a motion and a pole through which its blocks may lead, rad.
    fn largest_bend_rad(&self) -> f64 {
        self.policy.tolerances.axis_path_rad.min(CONTROL_CHOOSES_NEAR_POLE)
    }

    /// Whether blocks with tool vectors may lead a motion through a pole that it passes closely: only there the rotary
    /// angles that the control finds do not depend on its interpolation. Their points after the pole are on the path
    /// from there to its end. A point of the motion is the pole, too, where the angles of the point are those of the
    /// pole in the units of the program.
    fn is_led_through_pole(&self, segment: &Segment, block: &Block) -> bool {
        let largest_rad = self.largest_bend_rad() + self.rounding.axis_rad;
        let passes = |pole: &Vector3<f64>| segment.axis_arc().is_within(pole, largest_rad);
        block.state.vector.is_some() && self.pole.is_some_and(|pole| passes(&pole) || passes(&-pole))
    }

    /// Share of a motion that is done where the rotary axes rotate past the pole with the tip where it is: the tool
    /// axis keeps to its tolerance only.
    fn rotated_on_spot(&self, segment: &Segment, block: &Block, end: &ToolPose, arrival: &Arrival<'_>) -> Option<f64> {
        let tip_mm = 2.0 * self.rounding.tip_mm;
        let rests = |here: &ToolPose| (here.tip - end.tip).norm() <= tip_mm;
        let on_line = matches!(segment.shape, PathShape::Line) && block.action.is_feed();
        if !on_line || !arrival.here.is_some_and(rests) || self.off_pole_rad(&end.axis) > UNEVEN_NEAR_POLE {
            return None;
        }
        let largest_rad = self.policy.tolerances.axis_path_rad + self.rounding.pole_rad;
        if segment.axis_arc().distance(&end.axis) > largest_rad {
            return None;
        }
        // On its way around the pole the tool axis may be ahead of the tip, which rests where the last block has left
        // it.
        let by_tip = segment.share(end, arrival.along, self.rounding.tip_mm, 0.0).clamp(arrival.along, 1.0);
        // The share that was done has the rounding of the block before, too.
        let near = [(arrival.along, tip_mm + self.rounding.tip_mm), (by_tip, tip_mm)];
        let is_near = |(share, most): &(f64, f64)| (end.tip - segment.tip_at(*share)).norm() <= *most;
        near.into_iter().find(is_near).map(|(share, _)| share)
    }

    /// Share of a motion that is done where the rotary axes rotate evenly from the words before a block to the end of
    /// the motion, and the tip is on its line.
    fn evenly_done(
        &self,
        segment: &Segment,
        block: &Block,
        (before, end): (&[f64; MAX_AXES], &ToolPose),
        along: f64,
    ) -> Option<f64> {
        let line = matches!(segment.shape, PathShape::Line) && matches!(block.action, Action::Feed | Action::Rapid);
        if !line || self.policy.words.axis_in_plane || block.state.vector.is_some() {
            return None;
        }
        let target = self.end_of_even_rotation(before, &segment.to.axis)?;
        let change = |index: usize| target[index] - before[index];
        let widest = self.words.rotary().max_by(|a, b| change(*a).abs().total_cmp(&change(*b).abs()))?;
        // Rounding of the words before the block, at its end, and at the end of the motion.
        let rounded = 2.0 * self.rounding.unit_rad + AXIS_NOISE;
        if change(widest).abs() <= rounded {
            return None;
        }
        let part = (block.values[widest] - before[widest]) / change(widest);
        let even = |index: usize| (block.values[index] - before[index] - change(index) * part).abs() <= rounded;
        let done = along + (1.0 - along) * part;
        if !(0.0..1.0).contains(&part) || !self.words.rotary().all(even) {
            return None;
        }
        let unsure_mm = (1.0 - along) * segment.length() * rounded / change(widest).abs();
        let tip_mm = BOTH * self.rounding.tip_mm;
        let off = (end.tip - segment.tip_at(done)).norm();
        if off > tip_mm + unsure_mm {
            return None;
        }
        // The tip may show the share more exactly.
        let by_tip = segment.share(end, along, self.rounding.tip_mm, 0.0).clamp(along, 1.0);
        if unsure_mm <= tip_mm {
            Some(done)
        } else {
            let near = (end.tip - segment.tip_at(by_tip)).norm() <= tip_mm;
            near.then_some(by_tip)
        }
    }

    /// Words with a tool axis, nearest to other words; those of the last call, where they are still near.
    fn end_of_even_rotation(&self, words: &[f64; MAX_AXES], axis: &Vector3<f64>) -> Option<[f64; MAX_AXES]> {
        let near = |end: &[f64; MAX_AXES]| self.words.rotary_travel(words, end) < FRAC_PI_2;
        if let Some((_, end)) = self.even_end.get().filter(|(of, end)| of == axis && near(end)) {
            return Some(end);
        }
        let end = self.words.rotated_to(words, axis, LAST_STEP)?;
        self.even_end.set(Some((*axis, end)));
        Some(end)
    }

    /// Share of a motion at which a pose is.
    pub(crate) fn share_at(&self, segment: &Segment, end: &ToolPose) -> f64 {
        let rounding = &self.rounding;
        segment.share(end, 0.0, rounding.tip_mm, rounding.tip_mm / rounding.axis_rad).clamp(0.0, 1.0)
    }

    /// Whether the tip is farther from the end of a motion than any rounding may put it.
    pub(crate) fn is_far_from_end(&self, segment: &Segment, end: &ToolPose) -> bool {
        (end.tip - segment.to.tip).norm() > 8.0 * self.rounding.tip_mm
    }

    /// Whether a pose is on a motion, before its end by no more than the rounding of both.
    pub(crate) fn is_almost_done(&self, segment: &Segment, end: &ToolPose) -> bool {
        if self.is_far_from_end(segment, end) {
            return false;
        }
        let rest = 1.0 - self.share_at(segment, end);
        let near = matches!(segment.shape, PathShape::Line)
            && rest * segment.length() <= 4.0 * self.rounding.tip_mm
            && rest * segment.turn() <= 4.0 * self.rounding.axis_rad;
        near && segment.distance(end, 0.0) <= BOTH * self.rounding.tip_mm
            && segment.axis_arc().distance(&end.axis) <= BOTH * self.axis_allowance(&segment.to.axis)
    }

    /// Rounding may put an end a little before that of the last block, which rounding has put a little forward.
    fn is_just_before(&self, segment: &Segment, share: f64, along: f64, axis: f64) -> bool {
        let (length, angle) = (segment.length(), segment.turn());
        let near = |part: f64, most: f64| part * length <= most * self.rounding.tip_mm && part * angle <= most * axis;
        near(along - share, 2.0 * BOTH) && near(share - 1.0, 1.0)
    }

    /// The corner of a rapid in two blocks, along the tool axis and across it.
    fn corner(&self, segment: &Segment, end: &ToolPose, arrival: &Arrival<'_>) -> Option<f64> {
        let here = arrival.here.filter(|_| self.policy.links.rapid == RapidForm::TwoBlocks)?;
        let largest = (1.0 + drift(arrival.chords)) * self.rounding.tip_mm;
        let is_corner = |from: Vector3<f64>| {
            let step = segment.to.tip - from;
            let out = step.dot(&segment.to.axis) > 0.0;
            let is_at = |corner: Vector3<f64>, axis: &Vector3<f64>, rounded_mm: f64| {
                (end.tip - corner).norm() <= largest + rounded_mm && self.is_axis_near(&end.axis, axis, BOTH)
            };
            let along = |axis: &Vector3<f64>| axis * step.dot(axis);
            // Out along the tool axis as it is before it rotates, in along that at the end; that of words is rounded.
            match out {
                true => {
                    is_at(from + along(&segment.to.axis), &segment.to.axis, 0.0)
                        || is_at(from + along(&here.axis), &here.axis, self.rounding.axis_rad * step.norm())
                }
                false => is_at(segment.to.tip - along(&segment.to.axis), &segment.to.axis, 0.0),
            }
        };
        // A cycle that leans with its words returns beside the axis of its hole.
        (is_corner(here.tip) || is_corner(segment.from.tip)).then_some(0.0)
    }

    /// Bounds of [`deviation`](Self::deviation) for a block whose words are axis positions, on a straight motion.
    /// `ends`: poses with the words before and after it; `on`: those of the motion near to them. A bound for the tip of
    /// `enough_mm` or less need not be the smallest: no point of a chord is farther from another than the farther of
    /// its ends.
    ///
    /// A point that moves from 0 to 1 with a second derivative `b` is never farther than `b/8` from its chord, and no
    /// faster than the chord by more than `b/2`; the parabola through three steps of a quarter at most adds `7/24 b` to
    /// that. Along the chord the distance from the motion is largest at the first or the last point that is compared.
    /// Angles are at most `π/2` chords of unit vectors.
    pub(crate) fn deviation_bound(
        &self,
        [before, after]: [&[f64; MAX_AXES]; 2],
        ends: [&ToolPose; 2],
        on: [&ToolPose; 2],
        enough_mm: f64,
    ) -> DeviationBound {
        let swing = self.words.swing(before, after);
        let off = [0, 1].map(|end| ends[end].tip - on[end].tip);
        let farther_mm = longer(&off) + swing.bend_mm / 8.0;
        let tip_mm = if farther_mm <= enough_mm {
            farther_mm
        } else {
            let first = 1.0 / (points(swing.angle) + 1.0);
            let line = on[1].tip - on[0].tip;
            let squared = line.norm_squared();
            let distance = |share: f64| {
                let off = off[0] + (off[1] - off[0]) * share;
                let nearest = (share + off.dot(&line) / squared).clamp(0.0, 1.0);
                (off - line * (nearest - share)).norm()
            };
            distance(first).max(distance(1.0 - first)) + swing.bend_mm / 8.0
        };
        let axis = longer(&[0, 1].map(|end| ends[end].axis - on[end].axis));
        // The tool axis leaves its chord, and the motion that of the axes on it.
        let turn = FRAC_PI_2 * (swing.angle + 2.0 * axis);
        let bent_rad = (swing.angle * swing.angle + turn * turn) / 8.0;
        DeviationBound {
            tip_mm,
            axis_rad: FRAC_PI_2 * (axis + bent_rad),
            tip_rate_mm: (ends[1].tip - ends[0].tip).norm() + (0.5 + 7.0 / 24.0) * swing.bend_mm,
        }
    }

    /// Bounds of [`tip_rate_mm`](Deviation::tip_rate_mm), smallest and largest, for a block whose words are axis
    /// positions, on a straight motion; `None` where no rotary axis rotates. `ends`: tool poses with the words before
    /// and after it.
    ///
    /// The mean of the speeds at the ends of a motion with a third derivative `b` is its chord but for `b/12`, so that
    /// the first is known from the last but for `b/6`. No speed between them is larger than the larger one by more than
    /// `b/8`, and what the parabola through three steps, each of a quarter or less, shows is the speed at the end but
    /// for `0.17 b`. The sum is `0.34 b`.
    pub(crate) fn rates_by_ends(
        &self,
        [before, after]: [&[f64; MAX_AXES]; 2],
        ends: [&ToolPose; 2],
    ) -> Option<[f64; 2]> {
        if self.words.rotary_travel(before, after) <= 0.0 {
            return None;
        }
        let last = self.words.last_speed(before, after);
        let first = (ends[1].tip - ends[0].tip) * 2.0 - last;
        let unsure_mm = 0.34 * self.words.swing(before, after).jerk_mm;
        Some([-unsure_mm, unsure_mm].map(|unsure_mm| longer(&[first, last]) + unsure_mm))
    }

    /// Deviation of a block from its motion between its ends; `None` where words and motion are straight. `ends`: poses
    /// before and after it.
    pub(crate) fn deviation(
        &self,
        path: &BlockPath<'_>,
        [here, end]: [&ToolPose; 2],
        segment: &Segment,
        along: f64,
    ) -> Option<Deviation> {
        let block = path.block;
        // The control itself rotates the tool axis evenly.
        let evenly = block.state.tip_control != TipControl::Off
            && (block.state.vector.is_some() || self.policy.words.axis_in_plane)
            && matches!(block.action, Action::Feed | Action::Rapid);
        let rotated = if evenly { 0.0 } else { self.words.rotary_travel(&path.before, &block.values) };
        let straight = matches!(block.action, Action::Feed | Action::Rapid);
        if straight && rotated <= 0.0 && matches!(segment.shape, PathShape::Line) {
            return None;
        }
        let sweep = sweep(block);
        if rotated <= 0.0
            && let PathShape::Arc(arc) = &segment.shape
            && let Some(deviation) = self.arc_deviation(path, (segment, arc), along)
        {
            return Some(deviation);
        }
        let count = points(rotated + sweep);
        let axes = (rotated > 0.0).then(|| segment.axis_arc());
        let in_step = self.policy.words.axis_in_plane && segment.length() > 0.0;
        let mut found = Deviation::default();
        let (mut last, mut fastest) = (here.tip, FastestStep::<3>::default());
        let mut point = 1.0;
        while point <= count {
            let share = point / (count + 1.0);
            let on = self.words.place(&path.at(share), &block.state);
            fastest.add(on.tip - std::mem::replace(&mut last, on.tip));
            found.tip_mm = found.tip_mm.max(match &segment.shape {
                PathShape::Arc(arc) if sweep > 0.0 => {
                    off_arc((segment, arc), &on.tip, along + arc.share_of(sweep * share))
                }
                _ => segment.distance(&on, along),
            });
            if let Some(axes) = &axes {
                found.axis_rad = found.axis_rad.max(axes.distance(&on.axis));
                if in_step {
                    let by_tip = segment.at(segment.share(&on, along, 0.0, 0.0).clamp(0.0, 1.0));
                    found.lag_rad = found.lag_rad.max(angle_between(&on.axis, &by_tip.axis));
                }
            }
            point += 1.0;
        }
        fastest.add(end.tip - last);
        if rotated > 0.0 {
            found.tip_rate_mm = fastest.largest() * (count + 1.0);
        }
        Some(found)
    }

    /// Whether every point of a block is within `tolerance_mm` of a pose, and its tool axis the one of the pose.
    pub(crate) fn stays_at(&self, path: &BlockPath<'_>, pose: &ToolPose, tolerance_mm: f64) -> bool {
        let block = path.block;
        let count = points(self.words.rotary_travel(&path.before, &block.values) + sweep(block));
        let shares = (1..).map(f64::from).take_while(|point| *point <= count).map(|point| point / (count + 1.0));
        shares.into_iter().all(|share| {
            let on = self.words.place(&path.at(share), &block.state);
            (on.tip - pose.tip).norm() <= tolerance_mm && self.is_axis_near(&on.axis, &pose.axis, 1.0)
        })
    }
}

/// Distance of a tip from an arc where so much of it is done, mm.
#[inline(never)]
pub(super) fn off_arc((segment, arc): (&Segment, &ArcPath), tip: &Vector3<f64>, done: f64) -> f64 {
    let near = arc.share_near(tip, done).clamp(0.0, 1.0);
    // In the other sense about the same centre, or some other turn.
    let strays = (near - done).abs() > arc.share_of(FRAC_PI_2);
    (tip - segment.tip_at(if strays { done.clamp(0.0, 1.0) } else { near })).norm()
}

/// Factor on the allowance for the tip after arcs by their angle, whose chords add up to `chords` diameters.
pub(crate) fn drift(chords: f64) -> f64 {
    1.0 + POLE_DRIFT * chords
}

/// Chord of an arc in diameters.
pub(crate) fn chord(sweep: f64) -> f64 {
    (0.5 * sweep).sin().abs()
}

/// Angle of an arc, rad; 0 for any other block.
pub(crate) fn sweep(block: &Block) -> f64 {
    if let Action::Arc(arc) = &block.action { arc.sweep.abs() } else { 0.0 }
}

/// Length of the longer vector.
fn longer([a, b]: &[Vector3<f64>; 2]) -> f64 {
    larger(a.norm_squared(), b.norm_squared()).sqrt()
}

/// Number of points of a block that are compared besides its ends.
fn points(rotated: f64) -> f64 {
    (POINTS + (rotated / ANGLE_PER_POINT).floor()).min(MOST_POINTS)
}
