//! The path that the CL data asks for, one motion at a time: where tip and tool axis are at each share of it.
//!
//! A straight motion turns its axis evenly along the great circle between its ends; arcs and curves hold theirs. Shares
//! run from 0 to 1.

use std::f64::consts::{PI, TAU};
use std::rc::Rc;

use nalgebra::{Point3, Vector2, Vector3};

use super::ToolPose;
use crate::check::tolerances::{
    ANGLE_NOISE, BEFORE_LAST_POINT, NARROW_ARC, NEARLY_SAME_ARC, NO_DIRECTION, SMALL_ANGLE,
};
use crate::kinematics::Pose;
use crate::kinematics::math::{hypot, larger, smaller};
use crate::program::Arc;

/// What the tip follows.
///
/// Nearly every motion is a line: the others are shared, so that motions are small.
#[derive(Debug, Clone)]
pub(crate) enum PathShape {
    Line,
    Arc(Rc<ArcPath>),
    Cubic(Rc<[Vector3<f64>; 4]>),
}

/// A circle or a helix, seen from its centre.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ArcPath {
    centre: Vector3<f64>,
    normal: Vector3<f64>,
    /// Towards the start, and a quarter turn on.
    u: Vector3<f64>,
    v: Vector3<f64>,
    radii: [f64; 2],
    heights: [f64; 2],
    angle: f64,
}

/// A tip on its way round: at a share `t` of its angle `a` at `middle + start cos a t + quarter sin a t + rise t`, mm.
/// `quarter` is a quarter turn on in the sense in which it goes.
#[derive(Debug, Clone, Copy)]
pub(crate) struct RoundTip {
    pub(crate) middle: Vector3<f64>,
    pub(crate) start: Vector3<f64>,
    pub(crate) quarter: Vector3<f64>,
    pub(crate) rise: Vector3<f64>,
    /// Not negative, rad.
    pub(crate) angle: f64,
}

/// One motion.
#[derive(Debug, Clone)]
pub(crate) struct Segment {
    pub(crate) from: ToolPose,
    pub(crate) to: ToolPose,
    pub(crate) shape: PathShape,
}

/// The axes of a motion that rotates the tool evenly: part of a great circle.
#[derive(Debug, Clone, Copy)]
pub(crate) enum AxisArc {
    /// Shorter than [`NARROW_ARC`]; `half`: half its angle, rad.
    Narrow { middle: Vector3<f64>, half: f64 },
    /// `sides`: towards the arc from each of its ends, perpendicular to the axis there.
    Wide { from: Vector3<f64>, to: Vector3<f64>, normal: Vector3<f64>, sides: [Vector3<f64>; 2] },
}

pub(crate) fn tool_pose(pose: &Pose) -> ToolPose {
    ToolPose { tip: pose.tip.coords, axis: pose.axis.into_inner() }
}

/// Angle between two unit vectors, exact for small ones.
pub(crate) fn angle_between(a: &Vector3<f64>, b: &Vector3<f64>) -> f64 {
    2.0 * smaller((a - b).norm() / 2.0, 1.0).asin()
}

/// Whether the angle between two unit vectors is at most `largest`, rad. Their chord `c` decides nearly always: the
/// angle is no smaller than `c`, and no larger than `c + c³/7`: the difference of both, divided by `c³`, grows with `c`
/// to less than 1/7.
pub(crate) fn is_within_angle(a: &Vector3<f64>, b: &Vector3<f64>, largest: f64) -> bool {
    let squared = (a - b).norm_squared();
    let chord = squared.sqrt();
    chord * (1.0 + ANGLE_NOISE + squared / 7.0) <= largest || chord <= largest && angle_between(a, b) <= largest
}

impl ArcPath {
    pub(crate) fn of(arc: &Arc) -> Self {
        let normal = arc.normal.into_inner();
        let centre = arc.centre.coords;
        let height = |tip: &Point3<f64>| (tip.coords - centre).dot(&normal);
        let heights = [height(&arc.start.tip), height(&arc.end.tip)];
        let first = arc.start.tip.coords - centre - normal * heights[0];
        let last = arc.end.tip.coords - centre - normal * heights[1];
        let radius = first.norm();
        let u = if radius > 0.0 { first / radius } else { Vector3::zeros() };
        Self { centre, normal, u, v: normal.cross(&u), radii: [radius, last.norm()], heights, angle: arc.angle_rad }
    }

    fn at(&self, share: f64) -> Vector3<f64> {
        let (sine, cosine) = (self.angle * share).sin_cos();
        let between = |[a, b]: [f64; 2]| a + (b - a) * share;
        self.centre + (self.u * cosine + self.v * sine) * between(self.radii) + self.normal * between(self.heights)
    }

    /// Its angle, rad.
    pub(crate) fn angle(&self) -> f64 {
        self.angle
    }

    /// Distance of a point from the arc, mm, where its foot is near to the place at this angle; `None` elsewhere, and
    /// beyond the ends. Angles count from the start of the motion; sine and cosine are those of this one.
    pub(crate) fn distance_near(&self, point: &Vector3<f64>, angle: f64, sine: f64, cosine: f64) -> Option<f64> {
        let between = |[a, b]: [f64; 2], share: f64| a + (b - a) * share;
        let from = point - self.centre;
        let (a, b, height) = (from.dot(&self.u), from.dot(&self.v), from.dot(&self.normal));
        let (outwards, ahead) = (a * cosine + b * sine, b * cosine - a * sine);
        if ahead.abs() > outwards * SMALL_ANGLE {
            return None;
        }
        let same_angle = (angle + ahead / outwards) / self.angle;
        let share = self.foot_at(height, same_angle);
        let turned = (share - same_angle) * self.angle;
        if !(0.0..=1.0).contains(&share) || turned.abs() > SMALL_ANGLE {
            return None;
        }
        let (distance, radius) = ((a * a + b * b).sqrt(), between(self.radii, share));
        let (out, up) = (distance - radius, height - between(self.heights, share));
        Some((out * out + distance * radius * turned * turned + up * up).sqrt())
    }

    /// Bound of the distance of a tip that goes round from the arc, mm; it begins about where this share of the arc is
    /// done. `None` where it begins or ends elsewhere, or about another centre.
    ///
    /// Each of its points is compared with that of the arc at the same angle about the centre. The distance of a circle
    /// from a point within it is largest and smallest towards and away from its centre, or at an end of its arc. Radii
    /// and heights of the arc change evenly with the angle: their differences are largest at the ends, but for what the
    /// angle about another centre is ahead of even steps. By how much the tip's path differs from a circle in this
    /// plane is added. Beyond an end of the arc the point is that end: the last point of the tip is the farthest from
    /// it.
    pub(crate) fn farthest(&self, tip: &RoundTip, along: f64) -> Option<f64> {
        let parts = |of: &Vector3<f64>| (Vector2::new(of.dot(&self.u), of.dot(&self.v)), of.dot(&self.normal));
        let (off, height) = parts(&(tip.middle - self.centre));
        let (start, tilt_start) = parts(&tip.start);
        let (quarter, tilt_quarter) = parts(&tip.quarter);
        let (rise_beside, rise) = parts(&tip.rise);
        let begin = along * self.angle;
        let towards = if along > 0.0 { direction(begin) } else { Vector2::x() };
        let (radius, centre_off) = (start.norm(), off.norm());
        let turned = towards.perp(&start) / towards.dot(&start);
        let square = Vector2::new(-start.y, start.x);
        let is_about_it =
            turned.abs() <= NEARLY_SAME_ARC && towards.dot(&start) > 0.0 && centre_off <= radius * NEARLY_SAME_ARC;
        let same_sense = quarter.dot(&square) > 0.0;
        let (sine, cosine) = tip.angle.sin_cos();
        let end = start * cosine + square * sine;
        // Angles of its ends about the centre of the arc.
        let about = |place: &Vector2<f64>| place.perp(&off) / (radius * radius + place.dot(&off));
        let first = begin + turned + about(&start);
        let last = begin + turned + tip.angle + about(&end);
        let is_part = self.angle > 0.0 && first >= -NEARLY_SAME_ARC && last <= self.angle + NEARLY_SAME_ARC;
        if !(is_about_it && same_sense && is_part) {
            return None;
        }
        let passes = |way: &Vector2<f64>| match tip.angle {
            ..PI => start.perp(way) >= 0.0 && way.perp(&end) >= 0.0,
            PI..TAU => start.perp(way) >= 0.0 || way.perp(&end) >= 0.0,
            _ => true,
        };
        let at_ends = [(off + start).norm(), (off + end).norm()];
        let farthest = if passes(&off) { radius + centre_off } else { larger(at_ends[0], at_ends[1]) };
        let nearest = if passes(&-off) { radius - centre_off } else { smaller(at_ends[0], at_ends[1]) };
        let between = |[a, b]: [f64; 2], angle: f64| a + (b - a) * (angle / self.angle);
        let radii = [first, last].map(|angle| between(self.radii, angle));
        let out = larger(farthest - smaller(radii[0], radii[1]), larger(radii[0], radii[1]) - nearest);
        let up =
            larger((height - between(self.heights, first)).abs(), (height + rise - between(self.heights, last)).abs());
        let beside = rise_beside.norm() + (quarter - square).norm();
        // The share of the arc by which a point may be ahead of even steps between the ends, and what radius and height
        // change in it.
        let ahead = 2.0 * (centre_off + beside) / (radius - centre_off) / self.angle;
        let uneven = [self.radii, self.heights].map(|[a, b]| (b - a).abs() * ahead);
        let tilted = Vector2::new(tilt_start, tilt_quarter).norm();
        let mut largest = hypot(out + beside + uneven[0], up + tilted + uneven[1]);
        let beyond = [larger(-first, 0.0), larger(last - self.angle, 0.0)];
        if beyond[0] > 0.0 {
            largest = larger(largest, (tip.middle + tip.start - self.at(0.0)).norm());
        }
        if beyond[1] > 0.0 {
            let end = tip.middle + tip.start * cosine + tip.quarter * sine + tip.rise;
            largest = larger(largest, (end - self.at(1.0)).norm());
        }
        // The way beyond an end is no chord.
        let bent = larger(beyond[0], beyond[1]);
        Some(largest + radius * bent * bent / 8.0)
    }

    /// The share of the motion that an angle is.
    pub(crate) fn share_of(&self, angle: f64) -> f64 {
        angle / self.angle
    }

    /// The share nearest to a point in the turn that a share says: rounding of ends and centre may have made an arc
    /// longer or shorter.
    pub(crate) fn share_near(&self, point: &Vector3<f64>, share: f64) -> f64 {
        let angle = self.angle_of(point);
        let turns = ((share * self.angle - angle) / TAU).round();
        self.foot(point, (angle + turns * TAU) / self.angle)
    }

    /// Angle of a point about the normal, from the start.
    fn angle_of(&self, point: &Vector3<f64>) -> f64 {
        let from = point - self.centre;
        from.dot(&self.v).atan2(from.dot(&self.u))
    }

    /// The share nearest to a point whose angle is about this one: on a steep helix a small error of the angle is a
    /// large one of the height, and the foot of the point lies between the shares of both.
    fn foot(&self, point: &Vector3<f64>, share: f64) -> f64 {
        self.foot_at((point - self.centre).dot(&self.normal), share)
    }

    /// The share of a point at a height.
    fn foot_at(&self, height: f64, share: f64) -> f64 {
        let rise = self.heights[1] - self.heights[0];
        let round = self.angle * f64::midpoint(self.radii[0], self.radii[1]);
        let off = height - self.heights[0] - rise * share;
        let whole = rise * rise + round * round;
        if whole > NO_DIRECTION * NO_DIRECTION { share + off * rise / whole } else { share }
    }

    /// The nearest share whose angle is that of a point, as near behind `after` as a turn lets it be.
    fn share(&self, point: &Vector3<f64>, after: f64) -> f64 {
        let angle = self.angle_of(point);
        let turns = ((after * self.angle - angle) / TAU).ceil();
        let on = angle + turns * TAU;
        // Rounding may have put the point a little before the place where the last block ended.
        let back = on - TAU;
        let slack = (BEFORE_LAST_POINT / self.radii[0].max(BEFORE_LAST_POINT)) + ANGLE_NOISE;
        let chosen = if after * self.angle - back < slack { back } else { on };
        self.foot(point, chosen / self.angle).clamp(0.0, 1.0 + TAU / self.angle)
    }
}

impl Segment {
    /// Tip and axis at a share.
    pub(crate) fn at(&self, share: f64) -> ToolPose {
        if share >= 1.0 {
            return self.to;
        }
        ToolPose { tip: self.tip_at(share), axis: self.axis_at(share) }
    }

    /// Tip at a share.
    pub(crate) fn tip_at(&self, share: f64) -> Vector3<f64> {
        match &self.shape {
            _ if share >= 1.0 => self.to.tip,
            PathShape::Line => self.from.tip + (self.to.tip - self.from.tip) * share,
            PathShape::Arc(round) => round.at(share),
            PathShape::Cubic(points) => cubic(points, share),
        }
    }

    fn axis_at(&self, share: f64) -> Vector3<f64> {
        let (a, b) = (&self.from.axis, &self.to.axis);
        let normal = a.cross(b);
        let sine = normal.norm();
        if sine < NARROW_ARC {
            return a + (b - a) * share;
        }
        let angle = sine.atan2(a.dot(b));
        let across = normal.cross(a) / sine;
        let (s, c) = (angle * share).sin_cos();
        a * c + across * s
    }

    /// Length of the tip path, mm.
    pub(crate) fn length(&self) -> f64 {
        match &self.shape {
            PathShape::Line => (self.to.tip - self.from.tip).norm(),
            PathShape::Arc(round) => {
                let radius = f64::midpoint(round.radii[0], round.radii[1]);
                hypot(radius * round.angle, round.heights[1] - round.heights[0])
            }
            PathShape::Cubic(points) => points.windows(2).map(|pair| (pair[1] - pair[0]).norm()).sum(),
        }
    }

    /// Length of the part of a line between the feet of two tips, mm; 0 if they come in the opposite order.
    pub(crate) fn length_between(&self, [from, to]: [&Vector3<f64>; 2]) -> f64 {
        let line = self.to.tip - self.from.tip;
        let length = line.norm();
        if length > 0.0 { larger((to - from).dot(&line) / length, 0.0) } else { 0.0 }
    }

    /// Angle by which the tip goes round, rad; a whole turn for what is no arc.
    pub(crate) fn angle(&self) -> f64 {
        match &self.shape {
            PathShape::Arc(round) => round.angle,
            PathShape::Line | PathShape::Cubic(_) => TAU,
        }
    }

    /// Angle by which the axis turns, rad.
    pub(crate) fn turn(&self) -> f64 {
        angle_between(&self.from.axis, &self.to.axis)
    }

    /// The share at which the motion is nearest to a pose, not before `after`; on a curve the first whose distance is
    /// no more than `near`, mm. `per_rad`: so many mm of the tip count as much as one rad of the axis.
    pub(crate) fn share(&self, pose: &ToolPose, after: f64, near: f64, per_rad: f64) -> f64 {
        match &self.shape {
            PathShape::Line => {
                let line = self.to.tip - self.from.tip;
                let weight = per_rad * per_rad;
                let along = (pose.tip - self.from.tip).dot(&line);
                let (turn, turned) = if weight > 0.0 {
                    let turn = self.turn();
                    (turn, turn * angle_between(&pose.axis, &self.from.axis))
                } else {
                    (0.0, 0.0)
                };
                let whole = line.norm_squared() + weight * turn * turn;
                if whole > NO_DIRECTION * NO_DIRECTION { (along + weight * turned) / whole } else { 1.0 }
            }
            PathShape::Arc(round) => round.share(&pose.tip, after),
            PathShape::Cubic(points) => nearest(points, &pose.tip, after, near),
        }
    }

    /// How far a tip is from the motion, mm.
    pub(crate) fn distance(&self, pose: &ToolPose, after: f64) -> f64 {
        let share = self.share(pose, after, 0.0, 0.0).clamp(0.0, 1.0);
        (pose.tip - self.tip_at(share)).norm()
    }

    /// The arc between the axes of both ends.
    pub(crate) fn axis_arc(&self) -> AxisArc {
        let (from, to) = (self.from.axis, self.to.axis);
        let normal = from.cross(&to);
        let sine = normal.norm();
        if sine < NARROW_ARC {
            return AxisArc::Narrow { middle: self.axis_at(0.5), half: 0.5 * self.turn() };
        }
        let normal = normal / sine;
        AxisArc::Wide { from, to, normal, sides: [normal.cross(&from), to.cross(&normal)] }
    }
}

impl AxisArc {
    /// Whether the angle between an axis and the arc is at most `angle`, rad. Chords and sines, which are no larger
    /// than their angles, exclude most.
    pub(crate) fn is_within(&self, axis: &Vector3<f64>, angle: f64) -> bool {
        let far = match self {
            Self::Narrow { .. } => false,
            Self::Wide { from, to, normal, sides } => {
                let least = angle * (1.0 + ANGLE_NOISE);
                let beside = sides.iter().any(|side| side.dot(axis) < 0.0);
                let chord = |end: &Vector3<f64>| (axis - end).norm();
                if beside { chord(from).min(chord(to)) > least } else { normal.dot(axis).abs() > least }
            }
        };
        !far && self.distance(axis) <= angle
    }

    /// Angle between an axis and the arc, rad.
    pub(crate) fn distance(&self, axis: &Vector3<f64>) -> f64 {
        match self {
            Self::Narrow { middle, half } => angle_between(axis, middle) - half,
            Self::Wide { from, to, sides, .. } if sides.iter().any(|side| side.dot(axis) < 0.0) => {
                angle_between(axis, from).min(angle_between(axis, to))
            }
            Self::Wide { normal, .. } => normal.dot(axis).abs().min(1.0).asin(),
        }
    }
}

/// The unit vector at an angle.
fn direction(angle: f64) -> Vector2<f64> {
    let (sine, cosine) = angle.sin_cos();
    Vector2::new(cosine, sine)
}

fn cubic(points: &[Vector3<f64>; 4], t: f64) -> Vector3<f64> {
    let s = 1.0 - t;
    points[0] * (s * s * s) + points[1] * (3.0 * s * s * t) + points[2] * (3.0 * s * t * t) + points[3] * (t * t * t)
}

/// The nearest place of a cubic that is not before `after`, or the first that is as near as `near`.
///
/// `(B(t) - tip) . B'(t)` vanishes there, or it is an end. Both sides of a narrow bend are looked at, however narrow it
/// is.
fn nearest(points: &[Vector3<f64>; 4], tip: &Vector3<f64>, after: f64, near: f64) -> f64 {
    let from = after.min(1.0);
    let distance = |t: f64| (cubic(points, t) - tip).norm();
    let (found, count) = roots(&slope(points, tip), from, 1.0);
    let places = || std::iter::once(from).chain(found[..count].iter().copied()).chain([1.0]);
    let least = places().map(distance).fold(f64::INFINITY, f64::min);
    places().find(|place| distance(*place) <= least.max(near)).unwrap_or(1.0)
}

/// `(B(t) - tip) . B'(t)` by powers of t, half the derivative of the square of the distance.
fn slope(points: &[Vector3<f64>; 4], tip: &Vector3<f64>) -> [f64; 6] {
    let [p, q, r, s] = points;
    let powers = [p - tip, (q - p) * 3.0, (p - q * 2.0 + r) * 3.0, s - p + (q - r) * 3.0];
    let mut slope = [0.0; 6];
    for (i, power) in powers.iter().enumerate() {
        for (j, other) in powers.iter().enumerate().skip(1) {
            slope[i + j - 1] += power.dot(other) * j as f64;
        }
    }
    slope
}

/// Where a polynomial, lowest power first, changes its sign between two places, in ascending order: between
/// neighbouring zeros of its derivative it is monotone, so that sections find them all.
fn roots(polynomial: &[f64; 6], low: f64, high: f64) -> ([f64; 5], usize) {
    let mut derivatives = [*polynomial; 5];
    for level in 1..5 {
        let before = derivatives[level - 1];
        derivatives[level] = std::array::from_fn(|i| before.get(i + 1).map_or(0.0, |above| above * (i + 1) as f64));
    }
    let (mut found, mut count) = ([0.0; 5], 0);
    for polynomial in derivatives.iter().rev() {
        let value = |t: f64| polynomial.iter().rev().fold(0.0, |sum, factor| sum * t + factor);
        let (turns, between) = (found, count);
        count = 0;
        for index in 0..=between {
            let mut a = if index == 0 { low } else { turns[index - 1] };
            let mut b = if index == between { high } else { turns[index] };
            if value(a).is_sign_negative() == value(b).is_sign_negative() {
                continue;
            }
            // Until there is no number between the two.
            while let middle = f64::midpoint(a, b)
                && a < middle
                && middle < b
            {
                if value(middle).is_sign_negative() == value(a).is_sign_negative() { a = middle } else { b = middle }
            }
            found[count] = b;
            count += 1;
        }
    }
    (found, count)
}

/// The polynomial pieces of a cubic B-spline, as Bézier points.
pub(crate) fn bezier(knots: &[f64], points: &[Point3<f64>], span: usize) -> [Vector3<f64>; 4] {
    let (from, to) = (knots[span], knots[span + 1]);
    [[from; 3], [from, from, to], [from, to, to], [to; 3]].map(|at| polar(knots, points, span, at))
}

/// Value of the polar form at three parameters, by repeated interpolation (de Boor).
fn polar(knots: &[f64], points: &[Point3<f64>], span: usize, at: [f64; 3]) -> Vector3<f64> {
    let mut d: [Vector3<f64>; 4] = std::array::from_fn(|index| points[span - 3 + index].coords);
    for (level, parameter) in at.into_iter().enumerate() {
        for index in 0..3 - level {
            let (left, right) = (knots[span - 2 + level + index], knots[span + 1 + index]);
            d[index] = d[index].lerp(&d[index + 1], (parameter - left) / (right - left));
        }
    }
    d[0]
}

#[cfg(test)]
mod tests {
    use nalgebra::UnitVector3;

    use super::*;

    #[test]
    fn an_angle_is_within_all_larger_ones_and_no_smaller_one() {
        for part in 1..=1000 {
            let angle = 1e-3 * PI * f64::from(part);
            let (sine, cosine) = angle.sin_cos();
            let within = |largest: f64| is_within_angle(&Vector3::x(), &Vector3::new(cosine, sine, 0.0), largest);
            assert!(within(angle * (1.0 + 1e-7)) && !within(angle * (1.0 - 1e-7)), "{angle}");
        }
    }

    #[test]
    fn a_rounded_point_of_a_steep_helix_is_as_near_as_its_rounding() {
        let (radius, rise, angle) = (1.025, 3.58, 0.45_f64);
        let axis = UnitVector3::new_normalize(Vector3::z());
        let at = |turn: f64, out: f64| {
            let (sine, cosine) = turn.sin_cos();
            let tip = Point3::new((radius + out) * cosine, (radius + out) * sine, rise * turn / angle);
            Pose { tip, axis }
        };
        let (start, end) = (at(0.0, 0.0), at(angle, 0.0));
        let arc = Arc { centre: Point3::origin(), normal: axis, start, end, angle_rad: angle, feed: None };
        let segment =
            Segment { from: tool_pose(&start), to: tool_pose(&end), shape: PathShape::Arc(Rc::new(ArcPath::of(&arc))) };
        let half = tool_pose(&at(0.5 * angle, 0.0));
        // Half a unit of three decimals across the helix, where its angle says another height.
        let across = Vector3::new(-(0.5 * angle).sin(), (0.5 * angle).cos(), 0.0) * 5e-4;
        let off = |step: Vector3<f64>| segment.distance(&ToolPose { tip: half.tip + step, ..half }, 0.0);
        assert!(off(across) < 5e-4 && off(-across) < 5e-4, "{} {}", off(across), off(-across));
        assert!(off(across * 20.0) > 1e-3, "{}", off(across * 20.0));
    }

    #[test]
    fn a_point_of_a_narrow_bend_belongs_to_its_own_side() {
        // Up by 60 and down again, 0.05 mm beside.
        let points = [[0.0, 0.0, 0.0], [0.0, 80.0, 0.0], [0.05, 80.0, 0.0], [0.05, 0.0, 0.0]].map(Vector3::from);
        let mut after = 0.0;
        for step in 1..=200 {
            let share = f64::from(step) / 200.0;
            let tip = cubic(&points, share).map(|value| (value * 1e3).round() / 1e3);
            let found = nearest(&points, &tip, after, 1e-3);
            let off = (cubic(&points, found) - tip).norm();
            assert!((found - share).abs() < 0.01 && off < 2e-3, "{share}: {found}, {off} mm");
            after = found;
        }
    }

    #[test]
    fn every_change_of_sign_is_found() {
        // (t - 0.1) (t - 0.3) (t - 0.5) (t - 0.7) (t - 0.9), multiplied out.
        let polynomial = [-0.00945, 0.1689, -0.95, 2.3, -2.5, 1.0];
        let (found, count) = roots(&polynomial, 0.0, 1.0);
        assert_eq!(count, 5);
        for (found, wanted) in found.iter().zip([0.1, 0.3, 0.5, 0.7, 0.9]) {
            assert!((found - wanted).abs() < 1e-9, "{found} {wanted}");
        }
        assert_eq!(roots(&polynomial, 0.4, 0.6).1, 1);
        assert_eq!(roots(&[1.0, 0.0, 1.0, 0.0, 0.0, 0.0], 0.0, 1.0).1, 0);
    }

    /// Tips that go round about as a spiral helix does, the other way or in a plane that is tilted: none is farther off
    /// than the bound says.
    #[test]
    fn no_point_of_a_tip_that_goes_round_is_farther_from_an_arc_than_its_bound() {
        let mut seed = 7_u64;
        let mut noise = || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (seed >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
        };
        let mut bounded = 0;
        for turn in 0..2000 {
            let mut vector = |by: f64| Vector3::new(noise(), noise(), noise()) * by;
            let (centre, normal) = (vector(50.0), UnitVector3::new_normalize(vector(1.0)));
            let (across, by) = (normal.cross(&vector(1.0)).normalize(), 10_f64.powf(-1.0 - f64::from(turn % 5)));
            let (slope, tilt) = (vector(1.0), vector(by));
            let (radius, angle) = (5.0 + 4.0 * slope.x, 4.0 * (1.01 + slope.y));
            let at = |turned: f64, radius: f64, height: f64| {
                centre + (across * turned.cos() + normal.cross(&across) * turned.sin()) * radius + *normal * height
            };
            let pose = |tip: Vector3<f64>| Pose { tip: Point3::from(tip), axis: normal };
            let (widened, rise) = (radius * (1.0 + by * slope.z), 3.0 * slope.x);
            let ends = [at(0.0, radius, 0.0), at(angle, widened, rise)].map(pose);
            let arc = Arc {
                centre: Point3::from(centre),
                normal,
                start: ends[0],
                end: ends[1],
                angle_rad: angle,
                feed: None,
            };
            let arc = ArcPath::of(&arc);
            // A part of it, as it is, tilted, or the other way.
            let (along, part) = (0.25 * (1.0 + slope.y), 0.25 * (2.0 + slope.z));
            let from = along * angle + 1e-5 * tilt.x;
            let start = at(from, radius, along * rise) - centre - *normal * (along * rise) + tilt * 1e-3;
            let side = if turn % 7 == 0 { -1.0 } else { 1.0 };
            let tip = RoundTip {
                middle: centre + *normal * (along * rise) + tilt.cross(&normal),
                start,
                quarter: normal.cross(&start) * side + tilt * 1e-2,
                rise: *normal * (part * rise) + tilt * 1e-2,
                angle: part * angle,
            };
            let Some(bound) = arc.farthest(&tip, along) else { continue };
            bounded += 1;
            for point in 0..=200 {
                let share = f64::from(point) / 200.0;
                let (sine, cosine) = (tip.angle * share).sin_cos();
                let on = tip.middle + tip.start * cosine + tip.quarter * sine + tip.rise * share;
                let off = (on - arc.at(arc.share_near(&on, along + part * share).clamp(0.0, 1.0))).norm();
                assert!(off <= bound + 1e-6, "{turn}: {off} {bound}");
            }
        }
        assert!(bounded > 1000, "{bounded}");
    }
}
