//! Deviation of a block from the straight, evenly rotating motion between its ends: certified bounds, not samples.
//!
//! A control moves every axis linearly: `q(s) = q0 + s Δ` for `s` in \[0, 1\]. The tip `P(s)` and the tool axis `a(s)`
//! then follow curves. Both are known exactly in the middle, with their first two derivatives, and their third
//! derivative is bounded over the whole block. The bounds below follow from these alone.
//!
//! # The third derivative
//! The chain is followed from the tool to the workpiece; `y` is the point after the axes so far, and `V A M` are the
//! largest `|y'| |y''| |y'''|`. A linear axis adds a constant to `y'`. A rotary axis about `n` through `c`, rotating by
//! `δ`, moves `y` to `z = c + R (y - c)`, and with `N x = n × x`
//!
//! ```text
//! z'   = R (y' + δ N (y - c))
//! z''  = R (y'' + δ N (2 y' + δ N (y - c)))
//! z''' = R (y''' + 3 δ N y'' + 3 δ² N² y' + δ³ N³ (y - c))
//! |z'''| <= M + 3 |δ| A + 3 δ² V + |δ|³ ρ,   ρ the largest |N (y - c)|
//! ```
//!
//! In the middle everything is known, and from there to an end it is half the block: `A <= |y''(½)| + M/2`,
//! `V <= |y'(½)| + A/2`, `ρ <= |N (y(½) - c)| + V/2`.
//!
//! # The tip
//! `E(s)`, the distance vector from the evenly travelled chord, vanishes at both ends and has `E'' = P''`. With
//! `|P''(s) - P''(½)| <= M |s - ½|` and Green's function of the interval
//!
//! ```text
//! |E| <= |P''(½)|/8 + M/48
//! ```
//!
//! Normal to the chord only the part of `P''(½)` counts that is normal to it. Along the chord, of length `L`, the tip
//! is at `L s + e(s)` with `|e| <= b s (1 - s)/2`, `b` being the part of `P''(½)` along it plus `M/2`: it never
//! reverses if `b <= 2 L`, and otherwise passes an end by at most `b/2 (½ - L/b)²`. The chord is `P'(½)` within `M/24`.
//!
//! Its speed, per block, is `|P'(s)| = |P'(½) + (s - ½) P''(½)|` within `M/8`. The square of the first term is a
//! parabola of `s - ½` that opens upwards: it is largest at an end, `|P'(½)|² + |P'(½) · P''(½)| + |P''(½)|²/4`.
//!
//! An even motion along the chord has covered the share `s`; the tip is at most `b/8` ahead of it, or behind it.
//!
//! # The tool axis
//! The same bound, `e`, holds for the distance of `a(s)` from the chord of its arc. That chord lies in the plane of the
//! great circle, and a unit vector at distance `e` from a vector makes an angle of at most `asin e` with it. Where the
//! axis never reverses, only the part of `a''(½)` along `N = a0 × a1 / |a0 × a1|` counts: the distance from the
//! plane. `a0 × a1` is `(a(½) + a''(½)/8) × a'(½)` within `M/24 + |a'(½)| M/48` and terms of second order.
//!
//! # Lag
//! CL data rotates the axis in step with the tip. The axis at share `s` is compared with the chord of the axes at `s`,
//! whose direction is off that of an even rotation by `θ` by less than `0.0161 θ³` (`h³/3 (x - x³)` with `h = θ/2`, and
//! terms of higher order). Where the tip is ahead of `s` by a part of its line, the axis lags by that part of `θ`:
//! [`MotionBound::lag`].

use nalgebra::{UnitVector3, Vector3};

#[cfg(feature = "simulate")]
use super::any::{AnyMachine, AxisValues};
use super::math;
use super::{AxisKind, Joint, Machine};

/// Certified deviation of one block, all axes moving linearly, from the straight, evenly rotating motion.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct MotionBound {
    /// Upper bound of the distance of the tip from the straight line between the ends, mm.
    pub tip: f64,
    /// Upper bound of the angle of the tool axis from the great circle between the ends, rad; at most π.
    pub axis: f64,
    /// Upper bound of the speed of the tip anywhere in the block, times the time of the block, mm. On a straight line
    /// at an even speed it is the distance between the ends.
    pub tip_rate: f64,
    /// Upper bound of the angle of the tool axis from that of the evenly rotating motion at the same share of the
    /// block, rad; at most π.
    pub axis_step: f64,
    /// Upper bound of the distance along its line by which the tip is ahead of an even motion, or behind it, mm.
    pub tip_step: f64,
    /// Lower bound of the distance between the ends of the tip path, mm.
    pub length: f64,
    /// Upper bound of the angle between the tool axes at both ends, rad; at most π.
    pub turn: f64,
}

/// Certified deviation of one block, all axes moving linearly, from the motion in step with it: the tip at the same
/// share of the straight line, and the tool axis at the same share of the chord between both axes.
#[cfg(feature = "simulate")]
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct StepBound {
    /// Upper bound of the distance of the tip, mm.
    pub tip: f64,
    /// Upper bound of the angle of the tool axis, rad; at most π.
    pub axis: f64,
}

/// Derivatives of a moving point or tool axis in the middle of a block; per block, not per second.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Curve {
    /// First derivative in the middle.
    pub rate: Vector3<f64>,
    /// Second derivative in the middle.
    pub bend: Vector3<f64>,
    /// Largest third derivative of the whole block.
    pub third: f64,
}

/// Sine of the angle between two tool axes below which no great circle is defined.
const SAME_AXIS: f64 = 1e-9;

/// Largest angle, rad, by which the tool axis may rotate in a block with a [rough bound](BlockCurves::rough_bound).
const LARGEST_ROUGH_RATE: f64 = 0.25;

/// Largest angle, rad, by which an even motion along the chord of two tool axes less than a rad apart is off an even
/// rotation, per cube of the angle between them.
const UNEVEN: f64 = 0.02;

/// Relative rounding error of the bounds.
const RELATIVE_ROUNDING: f64 = 1e-12;

/// Relative rounding error of forward kinematics.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// Deviation of a block below which a rough bound will do.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct RoughDeviation {
    /// Distance of the tip from its line, mm.
    pub tip: f64,
    /// Angle of the tool axis from its great circle, rad.
    pub axis: f64,
    /// Angle of the tool axis from the evenly rotating motion, rad.
    pub axis_step: f64,
}

/// Deviation of a block, compared with another one.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg(feature = "std")]
pub enum BlockDeviation {
    /// It is below that one in each part.
    Below {
        /// As in [`MotionBound`].
        tip_rate: f64,
    },
    /// Its certified bound, which may be below that one, too.
    UpTo(MotionBound),
}

/// Motion of tip and tool axis in a block in which all axes move linearly. The vectors may be those of any frame that
/// does not move in the block.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BlockCurves {
    /// Derivatives of the tip, mm.
    pub tip: Curve,
    /// Tool axis in the middle.
    pub tool_axis: Vector3<f64>,
    /// Derivatives of the tool axis.
    pub axis: Curve,
    /// Upper bound of the levers of the chain, mm. This and `turns` are used only for the rounding error of forward
    /// kinematics, which is part of each bound.
    pub reach: f64,
    /// Sum of the rotary values, rad.
    pub turns: f64,
}

impl BlockCurves {
    /// The certified deviation of the block.
    #[must_use]
    #[inline]
    pub fn bound(&self) -> MotionBound {
        let Self { tip, tool_axis, axis, .. } = self;
        let ChordBound { distance, along, length } = tip.off_chord();
        let turn = axis.largest_turn();
        let step = axis.off_step(tool_axis) + uneven(turn);
        self.rounded(MotionBound {
            tip: distance,
            axis: axis.off_great_circle(tool_axis),
            tip_rate: tip.largest_rate(),
            axis_step: step,
            tip_step: along,
            length,
            turn,
        })
    }

    /// A bound that is never below [`bound`](Self::bound) and takes a fraction of its arithmetic; `None` unless it is
    /// below `most`. Only the lengths of the derivatives count: with `b = |a''|/8 + M/48`, a deviation of the tool axis
    /// is at most `asin b`, and that from the evenly rotating motion `asin` of the same with `|a''| (1 + V/2)`, divided
    /// by `1 - b`.
    ///
    /// `V`, at most a quarter, is `|a'| + |a''|/2 + M/4`: so `b <= V/4`, the angle is at most `V (1 + V²/20)`, and
    ///
    /// ```text
    /// asin b <= b (1 + b²) <= 1.004 b
    /// e = b (1 + V/2) / (1 - b) <= b (1 + 0.81 V)     asin e <= 1.006 e
    /// ```
    #[must_use]
    #[inline(always)]
    pub fn rough_bound(&self, most: &RoughDeviation) -> Option<MotionBound> {
        let (tip, axis) = (&self.tip, &self.axis);
        let (bend, rate) = (length(&axis.bend), length(&axis.rate));
        let largest_rate = rate + 0.5 * bend + 0.25 * axis.third;
        let distance = axis.sagitta(bend);
        let off = tip.sagitta(length(&tip.bend));
        let turn = 1.004 * largest_rate;
        let bound = self.rounded(MotionBound {
            tip: off,
            axis: 1.004 * distance,
            tip_rate: tip.largest_rate(),
            axis_step: 1.006 * distance * (1.0 + 0.81 * largest_rate) + UNEVEN * turn * turn * turn,
            tip_step: off,
            length: 0.0,
            turn,
        });
        let is_below = bound.tip < most.tip && bound.axis < most.axis && bound.axis_step < most.axis_step;
        (largest_rate <= LARGEST_ROUGH_RATE && is_below).then_some(bound)
    }

    /// A bound with the rounding errors of its computation and of forward kinematics.
    #[inline]
    fn rounded(&self, bound: MotionBound) -> MotionBound {
        let angle = ROUNDING * (1.0 + self.turns);
        let length = angle * self.reach;
        MotionBound {
            tip: bound.tip * (1.0 + RELATIVE_ROUNDING) + length,
            axis: bound.axis * (1.0 + RELATIVE_ROUNDING) + angle,
            tip_rate: bound.tip_rate * (1.0 + RELATIVE_ROUNDING) + length,
            axis_step: math::smaller(bound.axis_step * (1.0 + RELATIVE_ROUNDING) + angle, core::f64::consts::PI),
            tip_step: bound.tip_step * (1.0 + RELATIVE_ROUNDING) + length,
            length: math::larger(bound.length * (1.0 - RELATIVE_ROUNDING) - length, 0.0),
            turn: math::smaller(bound.turn * (1.0 + RELATIVE_ROUNDING) + angle, core::f64::consts::PI),
        }
    }
}

/// An even motion along the chord of two tool axes is off an even rotation by [less than this](UNEVEN).
#[inline]
fn uneven(turn: f64) -> f64 {
    if turn < 1.0 { UNEVEN * turn * turn * turn } else { core::f64::consts::PI }
}

impl MotionBound {
    /// Upper bound of the angle, rad, by which the tool axis differs from the programmed one: that of the evenly
    /// rotating motion where the tip is, or within `tip_mm` of there along its line.
    #[must_use]
    #[inline]
    pub fn lag(&self, tip_mm: f64) -> f64 {
        let ahead = self.tip_step - tip_mm;
        let share = if ahead <= 0.0 {
            0.0
        } else if ahead < self.length {
            ahead / self.length
        } else {
            1.0
        };
        let (in_step, anywhere) = (self.axis_step + self.turn * share, self.turn + self.axis);
        math::smaller(in_step, anywhere)
    }
}

/// Deviation of a point from the chord of its curve, and the chord.
struct ChordBound {
    /// Largest distance from the chord.
    distance: f64,
    /// Largest distance along it from the point that travels it evenly.
    along: f64,
    /// Lower bound of its length.
    length: f64,
}

impl Curve {
    /// Bound of the distance from the evenly travelled chord, for the part `bend` of the second derivative.
    #[inline]
    fn sagitta(&self, bend: f64) -> f64 {
        bend / 8.0 + self.third / 48.0
    }

    /// Largest first derivative.
    #[inline]
    fn largest_rate(&self) -> f64 {
        let along = math::abs(self.rate.dot(&self.bend));
        math::sqrt(self.rate.norm_squared() + along + 0.25 * self.bend.norm_squared()) + self.third / 8.0
    }

    /// Largest angle between two unit vectors at the ends, rad: an arc of at most one rad is longer than its chord by
    /// less than a twentieth of the cube of the chord.
    #[inline]
    fn largest_turn(&self) -> f64 {
        let chord = length(&self.rate) + self.third / 24.0;
        if chord < 1.0 { chord * (1.0 + 0.05 * chord * chord) } else { core::f64::consts::PI }
    }

    /// Deviation from the chord.
    #[inline]
    fn off_chord(&self) -> ChordBound {
        let (rate, bend) = (length(&self.rate), length(&self.bend));
        let (anyhow, off) = (self.sagitta(bend), self.third / 24.0);
        let chord = rate - off;
        if chord > 0.0 {
            let normal = self.sagitta((length(&self.bend.cross(&self.rate)) + bend * off) / rate);
            let along = (math::abs(self.bend.dot(&self.rate)) + bend * off) / rate + 0.5 * self.third;
            let past = if 2.0 * chord < along {
                let share = 0.5 - chord / along;
                0.5 * along * share * share
            } else {
                0.0
            };
            let distance = if past > 0.0 { math::hypot(normal, past) } else { normal };
            let step = along / 8.0;
            ChordBound { distance: math::smaller(distance, anyhow), along: math::smaller(step, anyhow), length: chord }
        } else {
            ChordBound { distance: anyhow, along: anyhow, length: 0.0 }
        }
    }

    /// Largest angle from the chord at the same share, rad; `axis` is the unit vector in the middle.
    ///
    /// With `e` the distance vector from the chord point `c`, the sine of the angle is `|a × e| / |c|`, and
    /// `|a(s) × a''(t)| <= |a × a''| + V/2 |a''| + M |t - ½|`, the right side in the middle.
    #[inline]
    fn off_step(&self, axis: &Vector3<f64>) -> f64 {
        let bend = length(&self.bend);
        let rate = length(&self.rate) + 0.5 * bend + 0.25 * self.third;
        let across = length(&axis.cross(&self.bend)) + 0.5 * rate * bend;
        let (sine, least) = (self.sagitta(across), 1.0 - self.sagitta(bend));
        let sine = if least > 0.0 { sine / least } else { 1.0 };
        let cosine = 1.0 - sine * sine;
        if cosine > 0.0 { sine / math::sqrt(cosine) } else { core::f64::consts::PI }
    }

    /// Largest angle from the great circle, rad; `axis` is the unit vector in the middle.
    #[inline]
    fn off_great_circle(&self, axis: &Vector3<f64>) -> f64 {
        let bend = length(&self.bend);
        let plane = (axis + self.bend / 8.0).cross(&self.rate);
        let size = length(&plane);
        let (along, across) = (self.third / 24.0, self.third / 48.0);
        let off = along * (1.0 + across) + across * length(&self.rate) + along * across;
        let least = size - off;
        let distance = if least > SAME_AXIS && least > 0.5 * bend + 0.25 * self.third {
            let normal = (math::abs(self.bend.dot(&plane)) + bend * off) / size;
            self.sagitta(math::smaller(normal, bend))
        } else {
            self.sagitta(bend)
        };
        // tan(asin e) is no less than asin e.
        let cosine = 1.0 - distance * distance;
        if cosine > 0.0 {
            let angle = distance / math::sqrt(cosine);
            math::smaller(angle, core::f64::consts::PI)
        } else {
            core::f64::consts::PI
        }
    }
}

#[inline]
fn length(vector: &Vector3<f64>) -> f64 {
    math::sqrt(vector.norm_squared())
}

/// A point in the middle of a block with two derivatives, and the bound of the third.
#[derive(Debug, Clone, Copy)]
struct Moving {
    place: Vector3<f64>,
    curve: Curve,
}

impl Moving {
    fn still(place: Vector3<f64>) -> Self {
        Self { place, curve: Curve { rate: Vector3::zeros(), bend: Vector3::zeros(), third: 0.0 } }
    }

    /// The point rotated about `n` through `centre` by `angle`, in the middle of a rotation by `change`, rad.
    fn turned(self, n: &UnitVector3<f64>, centre: &Vector3<f64>, angle: f64, change: f64) -> Self {
        let Curve { rate, bend, third } = self.curve;
        let (sine, cosine) = math::sin_cos(angle);
        let turn = |v: Vector3<f64>| v * cosine + n.cross(&v) * sine + n.into_inner() * (n.dot(&v) * (1.0 - cosine));
        let lever = self.place - centre;
        let swing = n.cross(&lever);
        let size = math::abs(change);
        let largest_bend = length(&bend) + third / 2.0;
        let largest_rate = length(&rate) + largest_bend / 2.0;
        let largest_swing = length(&swing) + largest_rate / 2.0;
        let third = third + size * (3.0 * largest_bend + size * (3.0 * largest_rate + size * largest_swing));
        let bend = turn(bend + n.cross(&(rate * 2.0 + swing * change)) * change);
        Self { place: centre + turn(lever), curve: Curve { rate: turn(rate + swing * change), bend, third } }
    }
}

/// Tip and tool axis in the middle of a block, from the joints in the order tool to workpiece, each with its value and
/// its change.
fn walk_joints(tool_axis: Vector3<f64>, joints: impl Iterator<Item = (AxisKind, Joint, f64, f64)>) -> (Moving, Moving) {
    let (mut tip, mut axis) = (Moving::still(Vector3::zeros()), Moving::still(tool_axis));
    for (kind, joint, value, change) in joints {
        let (value, change) = (joint.sign * value, joint.sign * change);
        match kind {
            AxisKind::Linear => {
                tip.place += joint.direction.into_inner() * value;
                tip.curve.rate += joint.direction.into_inner() * change;
            }
            AxisKind::Rotary => {
                tip = tip.turned(&joint.direction, &joint.point.coords, value, change);
                axis = axis.turned(&joint.direction, &Vector3::zeros(), value, change);
            }
        }
    }
    (tip, axis)
}

/// Tip and tool axis in the middle of a block.
fn walk<M: Machine>(machine: &M, axes: &M::Axes, change: &M::Axes) -> (Moving, Moving) {
    let joints = M::AXES.iter().enumerate().rev();
    let joint = |(index, described): (usize, &super::Axis)| {
        (described.kind, machine.joint(index), axes.as_ref()[index], change.as_ref()[index])
    };
    walk_joints(machine.tool_axis().into_inner(), joints.map(joint))
}

#[cfg(feature = "simulate")]
impl StepBound {
    /// The bound of a block of a machine.
    #[must_use]
    pub fn of(machine: &dyn AnyMachine, from: &AxisValues, to: &AxisValues) -> Self {
        let (mut reach, mut turns) = (0.0, 0.0);
        let joints = machine.axes().iter().enumerate().rev().map(|(index, described)| {
            let joint = machine.joint(index);
            let (lever, turn) = sizes(described.kind, &joint, from[index], to[index]);
            reach += lever;
            turns += turn;
            (described.kind, joint, 0.5 * (from[index] + to[index]), to[index] - from[index])
        });
        let (tip, axis) = walk_joints(machine.tool_axis().into_inner(), joints);
        let rounding = ROUNDING * (1.0 + turns);
        let bend = length(&tip.curve.bend);
        Self {
            tip: tip.curve.sagitta(bend) * (1.0 + RELATIVE_ROUNDING) + rounding * reach,
            axis: axis.curve.off_step(&axis.place) * (1.0 + RELATIVE_ROUNDING) + rounding,
        }
    }
}

/// [`Machine::rates`] from the joints, for a machine written by hand.
#[must_use]
pub fn rates_of_joints<M: Machine>(machine: &M, axes: &M::Axes, change: &M::Axes) -> (Vector3<f64>, Vector3<f64>) {
    let (tip, axis) = walk(machine, axes, change);
    (tip.curve.rate, axis.curve.rate)
}

/// Upper bound of the levers that a joint adds to the chain between two values, mm, and of its rotations, rad: what the
/// rounding of forward kinematics grows with.
fn sizes(kind: AxisKind, joint: &Joint, from: f64, to: f64) -> (f64, f64) {
    let size = math::abs(from) + math::abs(to);
    match kind {
        AxisKind::Linear => (size, 0.0),
        AxisKind::Rotary => (4.0 * joint.point.coords.iter().map(|component| math::abs(*component)).sum::<f64>(), size),
    }
}

/// [`Machine::curves`] from the joints, for a machine written by hand.
#[must_use]
pub fn curves_of_joints<M: Machine>(machine: &M, from: &M::Axes, to: &M::Axes) -> BlockCurves {
    let (mut middle, mut change) = (*from, *from);
    let (mut reach, mut turns) = (0.0, 0.0);
    for (index, described) in M::AXES.iter().enumerate() {
        let (start, end) = (from.as_ref()[index], to.as_ref()[index]);
        middle.as_mut()[index] = 0.5 * (start + end);
        change.as_mut()[index] = end - start;
        let (lever, turn) = sizes(described.kind, &machine.joint(index), start, end);
        reach += lever;
        turns += turn;
    }
    let (tip, axis) = walk(machine, &middle, &change);
    BlockCurves { tip: tip.curve, tool_axis: axis.place, axis: axis.curve, reach, turns }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kinematics::machines::Cb;

    /// Ends of a block of a C-B table; the rotations are largest in the first rounds.
    fn block(round: i32) -> [[f64; 5]; 2] {
        let wave = |phase: f64, size: f64| size * (0.9 * f64::from(round) + phase).sin();
        let size = 1.0 / f64::from(1 + round / 10);
        let from = core::array::from_fn(|index| wave(2.3 * index as f64, if index < 2 { 1.2 } else { 120.0 }));
        let by = |index: usize| wave(1.7 * index as f64 + 1.0, size * if index < 2 { 0.5 } else { 20.0 });
        [from, core::array::from_fn(|index| from[index] + by(index))]
    }

    #[test]
    fn a_rough_bound_is_never_below_the_bound_and_near_it() {
        let all = RoughDeviation { tip: f64::INFINITY, axis: f64::INFINITY, axis_step: f64::INFINITY };
        let (mut found, mut ratios) = (0, [0.0; 3]);
        for round in 0..3000 {
            let [from, to] = block(round);
            let curves = Cb::default().curves(&from, &to);
            let bound = curves.bound();
            let Some(rough) = curves.rough_bound(&all) else { continue };
            found += 1;
            let pairs = [(rough.tip, bound.tip), (rough.axis, bound.axis), (rough.axis_step, bound.axis_step)];
            for (ratio, (rough, bound)) in ratios.iter_mut().zip(pairs) {
                assert!(rough >= bound, "{round}: {curves:?}");
                *ratio += rough / bound / 3000.0;
            }
            assert!(rough.tip_rate >= bound.tip_rate && rough.turn >= bound.turn && rough.length <= bound.length);
            // Not where another one is wanted.
            let no_more = RoughDeviation { tip: rough.tip, ..all };
            assert_eq!(curves.rough_bound(&no_more), None);
        }
        assert!(found > 2900 && ratios[0] < 2.0, "{found} {ratios:?}");
    }
}

#[cfg(all(test, feature = "simulate"))]
mod step_tests {
    use super::*;
    use crate::kinematics::machines::Cb;

    #[test]
    fn the_motion_in_step_is_within_its_bound_at_a_thousand_places() {
        let machine: &dyn AnyMachine = &Cb::default();
        let mut tightest: [f64; 2] = [0.0; 2];
        for round in 0..60 {
            let wave = |phase: f64, size: f64| size * (0.9 * f64::from(round) + phase).sin();
            let (mut from, mut to) = ([0.0; 9], [0.0; 9]);
            for index in 0..5 {
                let (place, by) = if index < 2 { (1.2, 0.5) } else { (120.0, 20.0) };
                from[index] = wave(2.3 * index as f64, place);
                to[index] = from[index] + wave(1.7 * index as f64 + 1.0, by);
            }
            let bound = StepBound::of(machine, &from, &to);
            let ends = [&from, &to].map(|axes| machine.forward_kinematics(axes));
            let mut seen: [f64; 2] = [0.0; 2];
            for place in 0..=1000 {
                let share = f64::from(place) / 1000.0;
                let axes = core::array::from_fn(|index| from[index] + share * (to[index] - from[index]));
                let pose = machine.forward_kinematics(&axes);
                let tip = ends[0].tip + (ends[1].tip - ends[0].tip) * share;
                let axis = ends[0].axis.into_inner() * (1.0 - share) + ends[1].axis.into_inner() * share;
                let angle = axis.cross(&pose.axis).norm().atan2(axis.dot(&pose.axis));
                seen = [seen[0].max((pose.tip - tip).norm()), seen[1].max(angle)];
            }
            assert!(seen[0] <= bound.tip && seen[1] <= bound.axis, "{round}: {seen:?} {bound:?}");
            tightest = [tightest[0].max(seen[0] / bound.tip), tightest[1].max(seen[1] / bound.axis)];
        }
        assert!(tightest[0] > 0.75 && tightest[1] > 0.7, "{tightest:?}");
    }
}
