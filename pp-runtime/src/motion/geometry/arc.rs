//! Geometry of an arc or helix: points, length, extremes in a direction, and chords.
//!
//! The angle runs from 0 at the start to [`Arc::angle`] at the end; a fraction of the arc runs from 0 to 1. Height
//! along the normal and, if the ends in the CL data are not equally far from the centre, the radius change in
//! proportion to the angle.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use crate::diag::code::plan;
use crate::kinematics::math::{self, larger, smaller};
use crate::nalgebra::{Point3, Vector3};
use crate::program::Arc;

use crate::motion::fault::Fault;
use crate::tolerance::writer::{ARC_POINT_NOISE, LEVEL_ARC, MOST_CHORDS};

/// An arc with its frame.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ArcGeometry<'a> {
    arc: &'a Arc,
    /// Unit vector from the axis of the arc to its start.
    u: Vector3<f64>,
    /// Unit vector 90° further along the arc.
    v: Vector3<f64>,
    /// Distances of start and end from the axis of the arc.
    pub(crate) radii_mm: [f64; 2],
    /// Height of the start above the centre along the normal.
    level_mm: f64,
    /// Motion of the tip along the normal.
    pub(crate) rise_mm: f64,
}

/// Motion of an arc along an axis of the workpiece.
#[derive(Clone, Copy)]
struct AlongAxis {
    /// X, Y or Z: 0, 1 or 2.
    axis: usize,
    /// Largest distance along the axis from the centre of a circle with a radius of 1.
    across: f64,
    /// Rise of the arc along the axis, mm.
    rise_mm: f64,
}

impl<'a> ArcGeometry<'a> {
    pub(crate) fn new(arc: &'a Arc) -> Self {
        let normal = arc.normal.into_inner();
        let along = |point: Point3<f64>| (point - arc.centre).dot(&normal);
        let flat = |point: Point3<f64>| (point - arc.centre) - normal * along(point);
        let (first, last) = (flat(arc.start.tip), flat(arc.end.tip));
        let u = first / first.norm();
        let level_mm = along(arc.start.tip);
        Self {
            arc,
            u,
            v: normal.cross(&u),
            radii_mm: [first.norm(), last.norm()],
            level_mm,
            rise_mm: along(arc.end.tip) - level_mm,
        }
    }

    /// The larger radius, mm.
    pub(crate) fn radius(&self) -> f64 {
        self.radii_mm[0].max(self.radii_mm[1])
    }

    /// Tip at a fraction of the arc; the ends are exactly those of the CL data.
    pub(crate) fn tip(&self, fraction: f64) -> Point3<f64> {
        if fraction <= 0.0 {
            return self.arc.start.tip;
        }
        if fraction >= 1.0 {
            return self.arc.end.tip;
        }
        let (sine, cosine) = math::sin_cos(self.arc.angle_rad * fraction);
        let radius = self.radii_mm[0] + (self.radii_mm[1] - self.radii_mm[0]) * fraction;
        let height = self.level_mm + self.rise_mm * fraction;
        self.arc.centre + (self.u * cosine + self.v * sine) * radius + self.arc.normal.into_inner() * height
    }

    /// Length of the arc, mm.
    pub(crate) fn length(&self) -> f64 {
        math::hypot(0.5 * (self.radii_mm[0] + self.radii_mm[1]) * self.arc.angle_rad, self.rise_mm)
    }

    /// Rise along the normal per mm of path in the plane.
    pub(crate) fn slope(&self) -> f64 {
        self.rise_mm / (0.5 * (self.radii_mm[0] + self.radii_mm[1]) * self.arc.angle_rad)
    }

    /// Fractions of the arc, without its ends, at which the tip may be furthest in a direction or against it.
    ///
    /// With `H cos(t - φ)` for the circle and `s t` for the helix the derivative vanishes where `sin(t - φ) = s/H`. Of
    /// the points one revolution apart only the first and the last can be the furthest.
    pub(crate) fn extremes(&self, direction: Vector3<f64>) -> impl Iterator<Item = f64> {
        let (a, b) = (self.u.dot(&direction), self.v.dot(&direction));
        let across = math::hypot(a, b);
        let (mut parts, mut count) = ([0.0; 4], 0);
        // None if the direction is the normal.
        if across > 0.0 {
            let angle = self.arc.angle_rad;
            let slope = self.arc.normal.dot(&direction) * self.rise_mm / angle;
            let phase = math::atan2(b, a);
            // NaN, which is below no angle, if the pitch exceeds the circle's own motion in the direction.
            let lean = math::asin(slope / (self.radius() * across));
            for extreme in [phase + lean, phase + PI - lean] {
                let first = extreme.rem_euclid(TAU);
                let last = first + TAU * ((angle - first) / TAU).floor();
                let further = (last.to_bits() != first.to_bits()).then_some(last);
                for at in [Some(first), further].into_iter().flatten().filter(|at| *at < angle) {
                    parts[count] = at / angle;
                    count += 1;
                }
            }
        }
        parts.into_iter().take(count)
    }

    /// A distance from any point of the arc that no other is further away than, mm.
    pub(crate) fn diameter_mm(&self) -> f64 {
        2.0 * self.radius() + self.rise_mm.abs()
    }

    /// Two values between which `direction · p` is at every point `p` of the arc, and not far outside of its own.
    ///
    /// It is `c + H cos(t - φ) + s h` for the centre, the circle and a height `h` between those of the ends, so it
    /// leaves `c + s h` by no more than `H`.
    pub(crate) fn bounds(&self, direction: Vector3<f64>) -> [f64; 2] {
        let circle = self.radius() * math::hypot(self.u.dot(&direction), self.v.dot(&direction));
        let heights_mm = [self.level_mm, self.level_mm + self.rise_mm];
        let centre = self.arc.centre.coords;
        let along = heights_mm.map(|height| centre.dot(&direction) + self.arc.normal.dot(&direction) * height);
        let distances_mm = centre.lp_norm(1) + self.radius() + heights_mm[0].abs() + heights_mm[1].abs();
        let aside = circle + ARC_POINT_NOISE * distances_mm * direction.norm();
        [smaller(along[0], along[1]) - aside, larger(along[0], along[1]) + aside]
    }

    /// Lowest and highest coordinate of the tip along an axis of the workpiece, mm; where the arc certainly stays
    /// within `known`, those of its ends.
    #[inline(always)]
    fn range(&self, axis: usize, known: Option<[[f64; 3]; 2]>) -> [f64; 2] {
        let (start, end) = (self.arc.start.tip[axis], self.arc.end.tip[axis]);
        let ends = [smaller(start, end), larger(start, end)];
        let across = math::hypot(self.u[axis], self.v[axis]);
        // Along its normal the arc only rises.
        if across <= 0.0 {
            return ends;
        }
        let rise_mm = self.arc.normal[axis] * self.rise_mm;
        let along = AlongAxis { axis, across, rise_mm };
        if let Some([lowest, highest]) = known {
            // A circle may reach the box exactly.
            let is_circle = !self.changes(rise_mm) && self.arc.angle_rad <= TAU;
            if is_circle
                && lowest[axis] <= self.of_circle(along, -1.0, 0.0)
                && self.of_circle(along, 1.0, 0.0) <= highest[axis]
            {
                return ends;
            }
            // No point of any arc is further from the start of its axis.
            let (centre, level) = (self.arc.centre[axis], self.arc.normal[axis] * self.level_mm);
            let reach = across * self.radius() + rise_mm.abs();
            let reach = reach + ARC_POINT_NOISE * (centre.abs() + level.abs() + reach);
            if !is_circle && lowest[axis] <= centre + level - reach && centre + level + reach <= highest[axis] {
                return ends;
            }
        }
        self.range_beyond(along, ends, known)
    }

    /// Lowest and highest coordinate of an arc whose circle is not known to be within.
    #[inline(never)]
    fn range_beyond(&self, along: AlongAxis, mut range: [f64; 2], known: Option<[[f64; 3]; 2]>) -> [f64; 2] {
        let AlongAxis { axis, across, rise_mm } = along;
        let mut include = |at: f64| range = [smaller(at, range[0]), larger(at, range[1])];
        if self.arc.angle_rad <= TAU && rise_mm.abs() <= LEVEL_ARC * self.radius() * across * self.arc.angle_rad {
            let [lowest, highest] = self.turning_points(along);
            if let Some(at) = lowest {
                include(at);
            }
            if let Some(at) = highest {
                include(at);
            }
        } else {
            let direction = Vector3::ith_axis(axis).into_inner();
            let [low, high] = self.bounds(direction);
            if !known.is_some_and(|[lowest, highest]| lowest[axis] <= low && high <= highest[axis]) {
                self.extremes(direction).for_each(|part| include(self.tip(part)[axis]));
            }
        }
        range
    }

    /// Whether the radius changes along the arc, or its height along an axis, which has this rise.
    fn changes(&self, rise_mm: f64) -> bool {
        (self.radii_mm[1] - self.radii_mm[0]).abs() > 0.0 || rise_mm.abs() > 0.0
    }

    /// Coordinate along an axis of the point of its circle that is furthest to a side, 1 or -1, at a part of the arc, 0
    /// to 1. The rise moves no extreme.
    fn of_circle(&self, AlongAxis { axis, across, rise_mm }: AlongAxis, side: f64, part: f64) -> f64 {
        let wider_mm = self.radii_mm[1] - self.radii_mm[0];
        let start = self.arc.centre[axis] + self.arc.normal[axis] * self.level_mm;
        start + side * across * (self.radii_mm[0] + wider_mm * part) + rise_mm * part
    }

    /// Coordinates along an axis of the extremes, lowest and highest, that an arc of one revolution at most has between
    /// its ends.
    ///
    /// They are the coordinate of the centre, less or plus the radius times `across`. An arc of at most half a
    /// revolution passes the highest point if it begins to climb and ends falling; a longer one, unless the rest of its
    /// circle does.
    fn turning_points(&self, along: AlongAxis) -> [Option<f64>; 2] {
        let AlongAxis { axis, rise_mm, .. } = along;
        let (a, b) = (self.u[axis], self.v[axis]);
        let (angle, end) = (self.arc.angle_rad, self.arc.end.tip - self.arc.centre);
        let slopes = [b, b * end.dot(&self.u) - a * end.dot(&self.v)];
        let turning = |side: f64| {
            let [begins, ends] = slopes.map(|slope| side * slope);
            let short = begins > 0.0 && ends < 0.0;
            let rest = begins <= 0.0 && ends >= 0.0;
            if !(angle >= TAU || if angle <= PI { short } else { !rest }) {
                return None;
            }
            let changes = self.changes(rise_mm);
            let part = if changes { math::from_zero(math::atan2(side * b, side * a)) / angle } else { 0.0 };
            Some(self.of_circle(along, side, part))
        };
        [turning(-1.0), turning(1.0)]
    }

    /// Number of chords that deviate from the arc by no more than the tolerance.
    ///
    /// # Errors
    /// If the number would exceed [`MOST_CHORDS`].
    pub(crate) fn chords(&self, tolerance_mm: f64) -> Result<u32, Fault> {
        // A chord over the angle t deviates by r (1 - cos t/2), which is at most r t²/8.
        let step = (8.0 * tolerance_mm / self.radius()).sqrt().min(FRAC_PI_2);
        let chords = (self.arc.angle_rad / step).ceil().max(1.0);
        if chords.is_nan() || chords > MOST_CHORDS {
            return Err(plan::ARC
                .fault("this arc cannot be cut into chords")
                .help("check its radius, its number of revolutions and LINTOL"));
        }
        Ok(chords as u32)
    }
}

/// Whether an arc is about an axis parallel to Z, and a box certainly holds it in X and Y: no point is further from
/// that axis than one of its ends.
fn holds_upright(arc: &Arc, [lowest, highest]: [[f64; 3]; 2]) -> bool {
    let [x, y, _] = <[f64; 3]>::from(arc.normal.into_inner());
    let from_axis = |tip: Point3<f64>| math::hypot(tip.x - arc.centre.x, tip.y - arc.centre.y);
    let radius = larger(from_axis(arc.start.tip), from_axis(arc.end.tip));
    let holds = |axis: usize| {
        let centre = arc.centre[axis];
        let reach = radius + ARC_POINT_NOISE * (centre.abs() + radius);
        lowest[axis] <= centre - reach && centre + reach <= highest[axis]
    };
    x == 0.0 && y == 0.0 && holds(0) && holds(1)
}

/// Bounding box of the tip on an arc: its lowest and its highest corner, mm. Along an axis on which a box in `known`
/// certainly holds the arc, that of its ends.
pub(crate) fn extent(arc: &Arc, known: Option<[[f64; 3]; 2]>) -> [[f64; 3]; 2] {
    if known.is_some_and(|known| holds_upright(arc, known)) {
        let (start, end) = (arc.start.tip, arc.end.tip);
        return [smaller, larger].map(|of| std::array::from_fn(|axis| of(start[axis], end[axis])));
    }
    let round = ArcGeometry::new(arc);
    let [x, y, z] = [round.range(0, known), round.range(1, known), round.range(2, known)];
    [[x[0], y[0], z[0]], [x[1], y[1], z[1]]]
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::kinematics::Pose;
    use crate::nalgebra::UnitVector3;

    fn arc(start: [f64; 3], end: [f64; 3], angle: f64) -> Arc {
        let up = |tip: [f64; 3]| Pose { tip: Point3::from(tip), axis: Vector3::z_axis() };
        let (start, end) = (up(start), up(end));
        Arc { start, end, centre: Point3::origin(), normal: Vector3::z_axis(), angle_rad: angle, feed: None }
    }

    /// A box and the one before.
    fn around([low, high]: [[f64; 3]; 2], so_far: Option<[[f64; 3]; 2]>) -> Option<[[f64; 3]; 2]> {
        let [lower, upper] = so_far.unwrap_or([low, high]);
        let corner = |of: fn(f64, f64) -> f64, a: [f64; 3], b: [f64; 3]| std::array::from_fn(|i| of(a[i], b[i]));
        Some([corner(f64::min, low, lower), corner(f64::max, high, upper)])
    }

    /// Distance of a point from the line between two others.
    fn off_line(p: Point3<f64>, a: Point3<f64>, b: Point3<f64>) -> f64 {
        let t = ((p - a).dot(&(b - a)) / (b - a).norm_squared()).clamp(0.0, 1.0);
        (p - (a + (b - a) * t)).norm()
    }

    #[test]
    fn chords_deviate_from_a_helix_by_the_tolerance_at_most_and_not_by_much_less() {
        for tolerance in [0.001, 0.01, 0.1] {
            let angle = 2.25 * TAU;
            let helix = arc([20.0, 0.0, 0.0], [0.0, 20.0, -9.0], angle);
            let round = ArcGeometry::new(&helix);
            let chords = round.chords(tolerance).expect("chords");
            let tips: Vec<_> = (0..=chords).map(|index| round.tip(f64::from(index) / f64::from(chords))).collect();
            assert_eq!(tips.last(), Some(&helix.end.tip), "the end is exact");
            let mut most: f64 = 0.0;
            for step in 0..=20_000 {
                let part = f64::from(step) / 20_000.0;
                let (sine, cosine) = (angle * part).sin_cos();
                let on_helix = Point3::new(20.0 * cosine, 20.0 * sine, -9.0 * part);
                let index = ((part * f64::from(chords)).floor() as usize).min(tips.len() - 2);
                most = most.max(off_line(on_helix, tips[index], tips[index + 1]));
            }
            assert!(most <= tolerance * 1.000_001 && most > 0.9 * tolerance, "{most} for {tolerance}");
        }
    }

    #[test]
    fn arcs_that_would_need_a_million_chords_are_refused() {
        let round = |centre, tolerance| {
            let circle = Arc { centre, ..arc([20.0, 0.0, 0.0], [20.0, 0.0, 0.0], TAU) };
            ArcGeometry::new(&circle).chords(tolerance).is_err()
        };
        assert!(round(Point3::new(1e150, 0.0, 0.0), 0.01));
        assert!(round(Point3::new(f64::MAX, 0.0, 0.0), 0.01));
        assert!(round(Point3::origin(), 1e-300));
        assert!(!round(Point3::origin(), 0.01));
    }

    #[test]
    fn a_radius_that_changes_within_the_tolerance_leaves_both_ends_exact() {
        let spiral = arc([20.0, 0.0, 0.0], [0.0, 20.004, 0.0], 0.25 * TAU);
        let round = ArcGeometry::new(&spiral);
        assert_eq!((round.tip(0.0), round.tip(1.0)), (spiral.start.tip, spiral.end.tip));
        assert!((round.tip(0.5).coords.norm() - 20.002).abs() < 1e-9);
    }

    proptest! {
        /// The tip is nowhere on the arc further than at its ends and its extremes.
        #[test]
        fn no_point_of_an_arc_is_further_than_its_extremes(
            direction in prop::array::uniform3(-1.0_f64..1.0),
            normal in prop::array::uniform3(-1.0_f64..1.0),
            angle in 0.01_f64..15.0,
            rise in -30.0_f64..30.0,
        ) {
            let normal = Vector3::from(normal);
            prop_assume!(normal.norm() > 0.1);
            let normal = UnitVector3::new_normalize(normal);
            let u = normal.cross(&Vector3::new(0.3, 0.7, -0.4)).normalize() * 7.0;
            let end = nalgebra::Rotation3::from_axis_angle(&normal, angle) * u + normal.into_inner() * rise;
            let helix = Arc { normal, ..arc(u.into(), end.into(), angle) };
            let (round, direction) = (ArcGeometry::new(&helix), Vector3::from(direction));
            let far = |part: f64| round.tip(part).coords.dot(&direction);
            let known: Vec<f64> = round.extremes(direction).chain([0.0, 1.0]).map(far).collect();
            let most = known.iter().copied().fold(f64::MIN, f64::max);
            let least = known.iter().copied().fold(f64::MAX, f64::min);
            let [low, high] = round.bounds(direction);
            for step in 0..=500 {
                let here = far(f64::from(step) / 500.0);
                prop_assert!(here <= most + 1e-9 && here >= least - 1e-9, "{here} {known:?}");
                prop_assert!(low <= here && here <= high, "{here} {low} {high}");
            }
            // Within the first or the last revolution the arc comes as near as it rises in one.
            let near = if angle < TAU { f64::INFINITY } else { rise.abs() * TAU / angle * direction.norm() };
            prop_assert!(high - most <= near + 1e-9 && least - low <= near + 1e-9, "{low} {high} {known:?}");
        }

        /// The box of an arc is that of its ends and of the points at its extremes.
        #[test]
        fn the_box_of_an_arc_is_that_of_its_extremes(
            normal in prop::sample::select(vec![[0.0, 0.0, 1.0], [0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.6, 0.0, 0.8], [1.0, 1.0, 1.0]]),
            from in prop_oneof![-PI..PI, prop::sample::select(vec![0.0, FRAC_PI_2, -FRAC_PI_2, PI])],
            angle in prop_oneof![0.01_f64..TAU, prop::sample::select(vec![0.1, FRAC_PI_2, PI, 1.5 * PI, 6.0, TAU, 15.0])],
            wider in prop_oneof![Just(0.0), -0.005_f64..0.005],
            rise in prop::sample::select(vec![0.0, 0.0, 1e-10, 1.0, -2.0]),
        ) {
            let normal = UnitVector3::new_normalize(Vector3::from(normal));
            let aside = Vector3::from([normal.y, normal.z, normal.x]);
            let aside = (aside - normal.into_inner() * normal.dot(&aside)).normalize();
            let at = |angle: f64| nalgebra::Rotation3::from_axis_angle(&normal, angle) * aside;
            let centre = Point3::new(3.0, -20.0, 0.7);
            let end = centre + at(from + angle) * (7.0 + wider) + normal.into_inner() * rise;
            let helix = Arc { normal, centre, ..arc((centre + at(from) * 7.0).into(), end.into(), angle) };
            let round = ArcGeometry::new(&helix);
            let [lowest, highest] = extent(&helix, None);
            for axis in 0..3 {
                let parts = round.extremes(Vector3::ith_axis(axis).into_inner()).chain([0.0, 1.0]);
                let known: Vec<f64> = parts.map(|part| round.tip(part)[axis]).collect();
                let least = known.iter().copied().fold(f64::MAX, f64::min);
                let most = known.iter().copied().fold(f64::MIN, f64::max);
                // A rise of 1e-10 mm moves an extreme over an end of the arc, where the radius changes by `wider`.
                prop_assert!((lowest[axis] - least).abs() < 4e-12, "{axis}: {} {least}", lowest[axis]);
                prop_assert!((highest[axis] - most).abs() < 4e-12, "{axis}: {} {most}", highest[axis]);
            }
        }

        /// So is the box of arcs in a plane whose ends are equally far from the centre to the last bit.
        #[test]
        fn the_box_around_arcs_with_equal_radii_is_that_of_their_boxes(
            arcs in prop::collection::vec(
                (prop::array::uniform2(-2_i32..3), 0_usize..12, 1_usize..12, any::<bool>()), 1..30),
        ) {
            const AROUND: [[f64; 2]; 12] = [
                [5.0, 0.0], [4.0, 3.0], [3.0, 4.0], [0.0, 5.0], [-3.0, 4.0], [-4.0, 3.0], [-5.0, 0.0], [-4.0, -3.0],
                [-3.0, -4.0], [0.0, -5.0], [3.0, -4.0], [4.0, -3.0],
            ];
            let mut known: Option<[[f64; 3]; 2]> = None;
            let mut expected = known;
            for (centre, from, steps, clockwise) in arcs {
                let centre = Point3::new(centre[0].into(), centre[1].into(), 1.0);
                let on = |index: usize| centre + Vector3::new(AROUND[index % 12][0], AROUND[index % 12][1], 0.0);
                let (start, end) = (on(from), on(from + steps));
                let (start, end) = if clockwise { (end, start) } else { (start, end) };
                let [u, v] = [start - centre, end - centre];
                let angle = math::from_zero(math::atan2(u.x * v.y - u.y * v.x, u.dot(&v)) * if clockwise { -1.0 } else { 1.0 });
                let normal = if clockwise { -Vector3::z_axis() } else { Vector3::z_axis() };
                let arc = Arc { normal, centre, ..arc(start.into(), end.into(), angle) };
                expected = around(extent(&arc, None), expected);
                known = around(extent(&arc, known), known);
                prop_assert_eq!(known, expected);
            }
        }

        /// A box around many arcs is the same to the last bit, whether the boxes of all are computed or only those of
        /// arcs that may leave it.
        #[test]
        fn the_box_around_arcs_is_that_of_their_boxes(
            arcs in prop::collection::vec(
                (
                    prop::array::uniform3(-1.0_f64..1.0),
                    prop::sample::select(vec![[0.0, 0.0, 1.0], [0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.6, 0.0, 0.8], [1.0, 1.0, 1.0]]),
                    prop::sample::select(vec![0.1_f64, 1.0, FRAC_PI_2, PI, 6.0, TAU, 15.0]),
                    prop::sample::select(vec![0.0, 0.0, 1.0, -2.0]),
                ),
                1..30,
            ),
        ) {
            let mut known: Option<[[f64; 3]; 2]> = None;
            let mut expected = known;
            for (centre, normal, angle, rise) in arcs {
                let normal = UnitVector3::new_normalize(Vector3::from(normal));
                let u = normal.cross(&Vector3::new(0.3, 0.7, -0.4)).normalize() * 7.0;
                let (centre, up) = (Point3::from(centre), normal.into_inner() * rise);
                let end = centre + nalgebra::Rotation3::from_axis_angle(&normal, angle) * u + up;
                let helix = Arc { normal, centre, ..arc((centre + u).into(), end.into(), angle) };
                expected = around(extent(&helix, None), expected);
                known = around(extent(&helix, known), known);
                prop_assert_eq!(known, expected);
            }
        }
    }
}
