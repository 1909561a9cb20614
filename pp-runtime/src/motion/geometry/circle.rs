//! Words of a circle: the end points are rounded first, then the centre is computed from them.
//!
//! A control compares the distances of both ends from the centre. Therefore the centre is the point on the
//! perpendicular bisector of the *rounded* ends that is nearest to the nominal centre, rounded to the nearest grid
//! point, or to a neighbour of this whose distances from both ends differ by less than half as much. Lengths are mm in
//! the plane of the circle, in program coordinates: the first axis, then the second, which is 90° counter-clockwise
//! from it.

use std::f64::consts::{PI, TAU};

use crate::kinematics::math::{self, larger};
use crate::nalgebra::Vector3;
use crate::nc::whole_units;
use crate::tolerance::writer::{LEAST_RADIUS_SWEEP, MOST_RADIUS_SWEEP, SAME_SWEEP};

/// Steps from a point of the grid to those around it.
const NEIGHBOURS: [[f64; 2]; 8] =
    [[0.0, 1.0], [1.0, 0.0], [0.0, -1.0], [-1.0, 0.0], [1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0]];

/// Largest coordinate of a centre, in units of the words.
const MAX_UNITS: i64 = 1_000_000_000_000_000;

/// Working plane of a circle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ArcPlane {
    /// G17: X, then Y.
    Xy,
    /// G18: Z, then X.
    Zx,
    /// G19: Y, then Z.
    Yz,
}

impl ArcPlane {
    /// The planes perpendicular to X, Y and Z.
    pub(crate) const PERPENDICULAR_TO: [Self; 3] = [Self::Yz, Self::Zx, Self::Xy];

    /// Indices (0 X, 1 Y, 2 Z) of its two axes, in their order, and of the axis perpendicular to it.
    #[must_use]
    pub const fn axes(self) -> [usize; 3] {
        match self {
            Self::Xy => [0, 1, 2],
            Self::Zx => [2, 0, 1],
            Self::Yz => [1, 2, 0],
        }
    }
}

/// A circle in words; whole units of the linear words.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Circle {
    /// The plane.
    pub plane: ArcPlane,
    /// Positions of X Y Z in the chain.
    pub chain: [usize; 3],
    /// Sense of rotation, seen against the axis perpendicular to the plane.
    pub clockwise: bool,
    /// Start point.
    pub start: [i64; 2],
    /// Centre.
    pub centre: [i64; 2],
    /// Radius, if the block is written with R instead of the centre; negative for more than 180°.
    pub radius: Option<i64>,
    /// Angle from start to end, above 0 and at most one revolution.
    pub sweep_rad: f64,
    /// Motion along the axis perpendicular to the plane.
    pub rise: i64,
}

impl Circle {
    /// Distance, in units, of the end of an arc that is programmed by its angle from the end of its words; `offset`:
    /// the same at its start.
    pub(crate) fn drift(&self, offset: [f64; 2], end: [i64; 2]) -> [f64; 2] {
        let (sine, cosine) = math::sin_cos(if self.clockwise { -self.sweep_rad } else { self.sweep_rad });
        let from_centre = |point: [i64; 2], axis: usize| (point[axis] - self.centre[axis]) as f64;
        let [x, y] = [0, 1].map(|axis| from_centre(self.start, axis) + offset[axis]);
        [x * cosine - y * sine - from_centre(end, 0), x * sine + y * cosine - from_centre(end, 1)]
    }

    /// Largest speed along a direction of X, Y and Z, or against it, times the time of the arc, in units, as the words
    /// state the arc. `offset`: distance of its start from the start of its words; `end`: end of its words.
    ///
    /// With `a` and `b` the shares of the start and of the point a quarter turn after it, seen from the centre, it is
    /// `b cos t - a sin t` per radian, which is largest where `tan t = -a/b`.
    pub(crate) fn fastest_along(&self, direction: &Vector3<f64>, offset: [f64; 2], end: [i64; 2]) -> f64 {
        let (centre, sweep_rad) =
            self.by_radius(end).unwrap_or((self.centre.map(|units| units as f64), self.sweep_rad));
        let [x, y] = [0, 1].map(|axis| self.start[axis] as f64 + offset[axis] - centre[axis]);
        let quarter = if self.clockwise { [y, -x] } else { [-y, x] };
        let [first, second, perpendicular] = self.plane.axes().map(|axis| direction[axis]);
        let (a, b) = (x * first + y * second, quarter[0] * first + quarter[1] * second);
        let rise = self.rise as f64 * perpendicular;
        let speed = |at: f64| {
            let (sine, cosine) = math::sin_cos(at);
            (sweep_rad * (b * cosine - a * sine) + rise).abs()
        };
        let largest = math::atan2(-a, b);
        let inside = [largest, largest + PI].map(|at| at.rem_euclid(TAU)).into_iter().filter(|at| *at < sweep_rad);
        inside.chain([0.0, sweep_rad]).map(speed).fold(0.0, larger)
    }

    /// Centre and angle of an arc that is written with R, as they follow from its ends.
    fn by_radius(&self, end: [i64; 2]) -> Option<([f64; 2], f64)> {
        let radius = self.radius? as f64;
        let half = [0, 1].map(|axis| 0.5 * (end[axis] - self.start[axis]) as f64);
        let half_chord = math::hypot(half[0], half[1]);
        // The centre is on the left of an arc that goes counter-clockwise by less than half a turn.
        let left = if self.clockwise == (radius < 0.0) { 1.0 } else { -1.0 };
        let off = left * math::sqrt((radius * radius - half_chord * half_chord).max(0.0)) / half_chord;
        let middle = [0, 1].map(|axis| self.start[axis] as f64 + half[axis]);
        let least = 2.0 * math::asin((half_chord / radius.abs()).min(1.0));
        let sweep_rad = if radius < 0.0 { TAU - least } else { least };
        Some(([middle[0] - off * half[1], middle[1] + off * half[0]], sweep_rad))
    }
}

/// The circle of the CL data in its plane.
#[derive(Debug, Clone, Copy)]
pub(crate) struct NominalCircle {
    pub(crate) centre_mm: [f64; 2],
    /// Radii at start and end.
    pub(crate) radii_mm: [f64; 2],
    pub(crate) clockwise: bool,
    pub(crate) sweep_rad: f64,
}

/// Resolution of the words, and the tolerance of the control.
#[derive(Debug, Clone, Copy)]
pub(crate) struct WordGrid {
    /// Units of a linear word in 1 mm.
    pub(crate) units_per_mm: f64,
    /// Largest difference of the radii at both ends that the control accepts.
    pub(crate) radius_tolerance_mm: f64,
}

impl WordGrid {
    /// A point in whole units, mm.
    fn mm(self, units: [i64; 2]) -> [f64; 2] {
        units.map(|units| units as f64 / self.units_per_mm)
    }
}

/// Words of a circle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct CircleFit {
    pub(crate) centre: [i64; 2],
    /// Sweep of the circle that the words describe.
    pub(crate) sweep_rad: f64,
    /// No less than its [deviation](NominalCircle::deviation) from the nominal circle, and seldom as much as twice
    /// that.
    pub(crate) largest_deviation: CircleDeviation,
}

/// Deviation of the circle of some words from the nominal circle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct CircleDeviation {
    /// Largest distance between the two circles in the plane.
    pub(crate) plane_mm: f64,
    /// Distance between the two centres, by which a point may lead or lag along the circle, seen from either centre.
    pub(crate) centre_mm: f64,
}

fn minus(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] - b[0], a[1] - b[1]]
}

fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

fn length(a: [f64; 2]) -> f64 {
    math::hypot(a[0], a[1])
}

impl NominalCircle {
    /// Angle from one direction to another in the sense of the circle, rad; one revolution if both are the same.
    fn angle_to_run(&self, from: [f64; 2], to: [f64; 2]) -> f64 {
        let left = math::atan2(from[0] * to[1] - from[1] * to[0], dot(from, to));
        let angle = math::from_zero(if self.clockwise { -left } else { left });
        if angle > 0.0 { angle } else { TAU }
    }

    /// Whether a direction is between two others, `sweep` rad apart in the sense of the circle.
    fn passes(&self, direction: [f64; 2], [first, last]: [[f64; 2]; 2], sweep: f64) -> bool {
        let left_of = |from: [f64; 2], to: [f64; 2]| {
            let left = from[0] * to[1] - from[1] * to[0];
            if self.clockwise { -left } else { left }
        };
        match sweep {
            TAU.. => true,
            ..=PI => left_of(first, direction) >= 0.0 && left_of(direction, last) >= 0.0,
            _ => left_of(last, direction) <= 0.0 || left_of(direction, first) <= 0.0,
        }
    }

    /// An upper bound of the deviation of a circle about a centre with these radii, from the displacements of the
    /// centre and of the radii, mm.
    fn largest_deviation(&self, centre: [f64; 2], radii: [f64; 2]) -> CircleDeviation {
        let centre_mm = length(minus(centre, self.centre_mm));
        let wider = larger((radii[0] - self.radii_mm[0]).abs(), (radii[0] - self.radii_mm[1]).abs());
        CircleDeviation { plane_mm: centre_mm + wider + (radii[1] - radii[0]).abs(), centre_mm }
    }

    /// Deviation of the circle of a fit between two points in whole units.
    pub(crate) fn deviation(&self, ends: [[i64; 2]; 2], fit: &CircleFit, grid: WordGrid) -> CircleDeviation {
        self.deviation_of(ends.map(|end| grid.mm(end)), grid.mm(fit.centre), fit.sweep_rad)
    }

    /// Deviation of the circle between two rounded points, `sweep` rad apart about `centre`, mm.
    fn deviation_of(&self, [start, end]: [[f64; 2]; 2], centre: [f64; 2], sweep: f64) -> CircleDeviation {
        let (first, last) = (minus(start, centre), minus(end, centre));
        let radii = [length(first), length(last)];
        let shift = minus(centre, self.centre_mm);
        let far = |direction: [f64; 2]| {
            let distance = length([shift[0] + direction[0] * radii[0], shift[1] + direction[1] * radii[0]]);
            larger((distance - self.radii_mm[0]).abs(), (distance - self.radii_mm[1]).abs())
        };
        let missed = |direction: [f64; 2]| {
            let radius = self.radii_mm[0];
            (length([direction[0] * radius - shift[0], direction[1] * radius - shift[1]]) - radii[0]).abs()
        };
        let over = |vector: [f64; 2], length: f64| [vector[0] / length, vector[1] / length];
        // The distance of this circle from the nominal centre is monotonic except at the direction of the shift and
        // opposite to it, and so is the distance of the nominal circle from this centre.
        let mut off = larger(far(over(first, radii[0])), far(over(last, radii[1])));
        let shift_mm = length(shift);
        if shift_mm > 0.0 {
            let along = over(shift, shift_mm);
            let begin = minus(start, self.centre_mm);
            for direction in [along, [-along[0], -along[1]]] {
                let (there, nominal) = (far(direction), missed(direction));
                if there > off && self.passes(direction, [first, last], sweep) {
                    off = there;
                }
                // The converse: a small loop near the nominal circle would leave most of that circle uncut.
                if nominal > off && self.angle_to_run(begin, direction) <= self.sweep_rad {
                    off = nominal;
                }
            }
        }
        CircleDeviation { plane_mm: off + (radii[1] - radii[0]).abs(), centre_mm: shift_mm }
    }

    /// Words of the circle between two points in whole units; `None` if no words describe it.
    pub(crate) fn fit(&self, start: [i64; 2], end: [i64; 2], grid: WordGrid) -> Option<CircleFit> {
        let (from, to) = (grid.mm(start), grid.mm(end));
        let whole = start == end;
        let mut wanted = self.centre_mm;
        if !whole {
            let chord = minus(to, from);
            let middle = [0.5 * (from[0] + to[0]), 0.5 * (from[1] + to[1])];
            let along = dot(minus(wanted, middle), chord) / dot(chord, chord);
            wanted = [wanted[0] - chord[0] * along, wanted[1] - chord[1] * along];
        }
        let [Ok(x), Ok(y)] = wanted.map(|value| whole_units(value, grid.units_per_mm)) else { return None };
        let nearest = [x, y];
        if nearest.iter().any(|units| units.abs() > MAX_UNITS) {
            return None;
        }
        // The difference of the squares of both distances, in units: whole numbers, and exact for arcs of less than
        // 2^26 units. Where the distances are equal it is zero.
        let twice = [0, 1].map(|axis| (start[axis] + end[axis] - 2 * nearest[axis]) as f64);
        let chord = [0, 1].map(|axis| (start[axis] - end[axis]) as f64);
        let of_nearest = dot(chord, twice);
        let units_in_mm2 = grid.units_per_mm * grid.units_per_mm;
        // The difference of the distances, mm.
        let unequal = |squares: f64, centre: [i64; 2]| {
            let centre = grid.mm(centre);
            squares / units_in_mm2 / (length(minus(from, centre)) + length(minus(to, centre)))
        };
        let (mut centre, mut least_squares) = (nearest, of_nearest.abs());
        let mut least = unequal(least_squares, nearest);
        // Of equals the first is kept: the nearest.
        for step in NEIGHBOURS {
            let squares = (of_nearest - 2.0 * dot(chord, step)).abs();
            if squares < least_squares {
                let other = [nearest[0] + step[0] as i64, nearest[1] + step[1] as i64];
                let difference = unequal(squares, other);
                if difference < 0.5 * least {
                    (centre, least, least_squares) = (other, difference, squares);
                }
            }
        }
        if least > grid.radius_tolerance_mm || centre == start || centre == end {
            return None;
        }
        let centre_mm = grid.mm(centre);
        let (first, last) = (minus(from, centre_mm), minus(to, centre_mm));
        let sweep_rad = if whole { TAU } else { self.angle_to_run(first, last) };
        let largest_deviation = self.largest_deviation(centre_mm, [length(first), length(last)]);
        ((sweep_rad - self.sweep_rad).abs() <= SAME_SWEEP).then_some(CircleFit { centre, sweep_rad, largest_deviation })
    }

    /// Radius word, in whole units, that describes the same circle as the centre of a fit, and the deviation of its
    /// circle; `None` if no radius word determines the centre.
    pub(crate) fn radius(
        &self,
        start: [i64; 2],
        end: [i64; 2],
        fit: &CircleFit,
        grid: WordGrid,
    ) -> Option<(i64, CircleDeviation)> {
        let small = fit.sweep_rad.min(TAU - fit.sweep_rad);
        if !(LEAST_RADIUS_SWEEP..=MOST_RADIUS_SWEEP).contains(&small) {
            return None;
        }
        let (from, to, centre) = (grid.mm(start), grid.mm(end), grid.mm(fit.centre));
        let chord = minus(to, from);
        let middle = [0.5 * (from[0] + to[0]), 0.5 * (from[1] + to[1])];
        let units = (length(minus(from, centre)) * grid.units_per_mm).round();
        let radius = units / grid.units_per_mm;
        let square = radius * radius - 0.25 * dot(chord, chord);
        // A radius of some units, rounded down, may be less than half the chord: such an arc does not reach its end.
        if square < 0.0 {
            return None;
        }
        let height = square.sqrt();
        let left = [-chord[1] / length(chord), chord[0] / length(chord)];
        let side = dot(minus(centre, middle), left).signum();
        let centre = [middle[0] + left[0] * height * side, middle[1] + left[1] * height * side];
        let sweep_rad = self.angle_to_run(minus(from, centre), minus(to, centre));
        let deviation = self.deviation_of([from, to], centre, sweep_rad);
        let units = units as i64;
        Some((if fit.sweep_rad > PI { -units } else { units }, deviation))
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    const GRID: WordGrid = WordGrid { units_per_mm: 1000.0, radius_tolerance_mm: 0.00127 };

    fn circle(centre: [f64; 2], radius: f64, from: f64, sweep: f64) -> (NominalCircle, [i64; 2], [i64; 2]) {
        let nominal =
            NominalCircle { centre_mm: centre, radii_mm: [radius; 2], clockwise: sweep < 0.0, sweep_rad: sweep.abs() };
        let at = |angle: f64| {
            [centre[0] + radius * angle.cos(), centre[1] + radius * angle.sin()]
                .map(|value| (value * GRID.units_per_mm).round() as i64)
        };
        (nominal, at(from), at(from + sweep))
    }

    /// Ends of a full circle that are rounded apart, perpendicular to the path: on the line between them and the centre
    /// a loop of some thousandths of a millimetre has the same ends and the same sweep, and lies on the nominal circle
    /// everywhere.
    #[test]
    fn a_full_circle_is_no_loop_at_its_start() {
        for radius in [0.05, 2.0, 10.000_5, 80.000_5] {
            let nominal =
                NominalCircle { centre_mm: [0.0; 2], radii_mm: [radius; 2], clockwise: false, sweep_rad: TAU };
            let units = (radius * 1e3).floor() as i64;
            for aside in 0..40 {
                let ends = [[units, aside], [units + 1, aside]];
                let fit = nominal.fit(ends[0], ends[1], GRID);
                let deviation = |fit: &CircleFit| nominal.deviation(ends, fit, GRID).plane_mm;
                let off = fit.map(|fit| (deviation(&fit), length(fit.centre.map(|units| units as f64 / 1e3))));
                assert!(off.is_none_or(|(off, shift)| off > 0.8 * shift), "{radius} {aside}: {off:?}");
            }
        }
    }

    #[test]
    fn a_full_circle_stays_one_and_no_other_arc_becomes_one() {
        let (nominal, start, end) = circle([1.0, 2.0], 10.0, 0.3, TAU);
        let fit = nominal.fit(start, end, GRID).expect("a circle");
        assert!((fit.sweep_rad - TAU).abs() < 1e-12 && fit.centre == [1000, 2000]);
        // Nearly a full circle whose ends round to one point, and to points on the wrong side of each other.
        let (nominal, start, _) = circle([1.0, 2.0], 10.0, 0.3, TAU - 1e-6);
        assert!(nominal.fit(start, start, GRID).is_some());
        let past = [start[0] - 1, start[1] + 1];
        assert!(nominal.fit(start, past, GRID).is_none(), "a tiny arc instead of a full circle");
        // A tiny arc whose ends round to one point, or to points in the opposite order.
        let (nominal, start, end) = circle([1.0, 2.0], 10.0, 0.3, 1e-5);
        assert_eq!(start, end);
        assert!(nominal.fit(start, end, GRID).is_none());
        assert!(nominal.fit(start, [start[0] + 1, start[1] - 1], GRID).is_none());
    }

    #[test]
    fn radii_that_no_words_make_equal_are_refused() {
        let (nominal, start, end) = circle([0.0, 0.0], 0.7, 0.0, 2.4);
        assert!(nominal.fit(start, end, GRID).is_some());
        assert!(nominal.fit(start, end, WordGrid { radius_tolerance_mm: 1e-9, ..GRID }).is_none());
        assert!(nominal.fit(start, end, WordGrid { radius_tolerance_mm: 1.0, ..GRID }).is_some());
    }

    #[test]
    fn a_radius_word_is_no_less_than_half_the_chord() {
        let (mut written, mut left) = (0, 0);
        for turn in 0..4000 {
            let radius = 0.02 + 0.0001 * f64::from(turn % 400);
            let (nominal, start, end) = circle([0.0, 0.0], radius, 0.37 * f64::from(turn), 2.8);
            let Some(fit) = nominal.fit(start, end, GRID) else { continue };
            let chord = [0, 1].map(|axis| end[axis] - start[axis]);
            match nominal.radius(start, end, &fit, GRID) {
                Some((units, _)) => {
                    written += 1;
                    assert!(
                        4 * units * units >= chord[0] * chord[0] + chord[1] * chord[1],
                        "{turn}: {units} {chord:?}"
                    );
                }
                None => left += 1,
            }
        }
        assert!(written > 1000 && left > 100, "{written} {left}");
    }

    /// Ends within half a unit in each axis of the nominal ones: their distances from the nominal centre differ by at
    /// most √2 units, so that it is `√½ / sin(sweep / 2)` from their bisector; the grid and its neighbour add 3 √½.
    /// A circle deviates by at most the displacement of its centre and of its radius.
    fn largest_by_rounding(sweep: f64) -> f64 {
        let end = 0.5_f64.sqrt() / GRID.units_per_mm;
        let displaced = end / (0.5 * sweep).sin() + 3.0 * end;
        displaced + (displaced + end) + 2.0 * GRID.radius_tolerance_mm
    }

    #[test]
    fn words_of_long_arcs_deviate_by_less_than_four_units() {
        for turn in 0..5000 {
            let part = |times: f64| (times * f64::from(turn)).fract();
            let centre = [600.0 * part(0.618_034) - 300.0, 600.0 * part(0.414_214) - 300.0];
            let (nominal, start, end) =
                circle(centre, 5.0 + 95.0 * part(0.732_051), TAU * part(0.236_068), 0.5 + 4.5 * part(0.302_776));
            let deviation = nominal.fit(start, end, GRID).map(|fit| nominal.deviation([start, end], &fit, GRID));
            assert!(deviation.is_some_and(|deviation| deviation.plane_mm < 0.004), "{turn}: {deviation:?}");
        }
    }

    proptest! {
        /// Ends as far from a point of the grid as each other: the centre of the CL data is that of the words.
        #[test]
        fn a_centre_that_words_can_express_is_kept(
            centre in prop::array::uniform2(-300_000_i64..300_000),
            [across, along] in prop::array::uniform2(1_i64..90_000),
            kind in 0..4,
            clockwise in prop::bool::ANY,
            units_per_mm in prop_oneof![Just(1e3), Just(1e4), Just(1e4 / 25.4)],
        ) {
            let offsets = match kind {
                0 => [[across, along], [across, -along]],
                1 => [[across, along], [-across, along]],
                2 => [[across, along], [along, across]],
                _ => [[across, 0], [0, across]],
            };
            let [start, end] = offsets.map(|offset| [centre[0] + offset[0], centre[1] + offset[1]]);
            prop_assume!(start != end);
            let mm = |units: i64| units as f64 / units_per_mm;
            let radius = length([mm(offsets[0][0]), mm(offsets[0][1])]);
            let mut nominal =
                NominalCircle { centre_mm: centre.map(mm), radii_mm: [radius; 2], clockwise, sweep_rad: 0.0 };
            nominal.sweep_rad = nominal.angle_to_run(offsets[0].map(mm), offsets[1].map(mm));
            let fit = nominal.fit(start, end, WordGrid { units_per_mm, ..GRID });
            prop_assert_eq!(fit.map(|fit| fit.centre), Some(centre));
        }
    }

    #[test]
    fn a_neighbour_of_the_nearest_centre_is_taken_where_its_distances_differ_by_less_than_half() {
        let mut taken = 0;
        for turn in 0..2000 {
            let (from, sweep) = (0.37 * f64::from(turn), 0.3 + 0.002 * f64::from(turn));
            // Small arcs, too, whose distances from neighbours are not nearly the same.
            let radius = if turn % 2 == 0 { 0.06 } else { 15.0 };
            let (nominal, start, end) = circle([0.0, 0.0], radius, from, sweep);
            let Some(fit) = nominal.fit(start, end, WordGrid { radius_tolerance_mm: 1.0, ..GRID }) else { continue };
            let off = |centre: [i64; 2]| {
                let [first, last] = [start, end].map(|point| {
                    let [x, y] = [point[0] - centre[0], point[1] - centre[1]].map(|units| units as f64);
                    x.hypot(y)
                });
                (first - last).abs()
            };
            // The foot of the nominal centre on the bisector.
            let [x, y] = [end[0] - start[0], end[1] - start[1]].map(|units| units as f64);
            let middle = [start[0] + end[0], start[1] + end[1]].map(|units| 0.5 * units as f64);
            let along = (middle[0] * x + middle[1] * y) / (x * x + y * y);
            let foot = [along * x, along * y];
            if foot.iter().any(|units| (units - units.round()).abs() > 0.499) {
                continue;
            }
            let nearest = foot.map(|units| units.round() as i64);
            let around = (-1..=1).flat_map(|dx| (-1..=1).map(move |dy| [nearest[0] + dx, nearest[1] + dy]));
            let best = around.map(off).fold(f64::INFINITY, f64::min);
            assert!(off(fit.centre) < 2.0 * best + 1e-9, "{turn}: {fit:?}");
            if fit.centre == nearest {
                assert!(off(nearest) < 2.0 * best + 1e-9, "{turn}");
            } else {
                taken += 1;
                assert!(off(fit.centre) < 0.5 * off(nearest), "{turn}: {fit:?} for {nearest:?}");
            }
        }
        assert!(taken > 500, "{taken}");
    }

    /// Deviation in the plane, every direction asked whether the circles pass it.
    fn deviation_in_all_directions(nominal: &NominalCircle, start: [f64; 2], end: [f64; 2], centre: [f64; 2]) -> f64 {
        let (first, last, shift) = (minus(start, centre), minus(end, centre), minus(centre, nominal.centre_mm));
        let (radii, shift_mm) = ([length(first), length(last)], length(shift));
        let over = |vector: [f64; 2], length: f64| vector.map(|value| value / length);
        let far = |direction: [f64; 2]| {
            let distance = length([0, 1].map(|axis| shift[axis] + direction[axis] * radii[0]));
            larger((distance - nominal.radii_mm[0]).abs(), (distance - nominal.radii_mm[1]).abs())
        };
        let mut off = larger(far(over(first, radii[0])), far(over(last, radii[1])));
        for side in [1.0, -1.0] {
            let direction = over(shift, side * shift_mm);
            if shift_mm > 0.0 && nominal.angle_to_run(first, direction) <= nominal.angle_to_run(first, last) {
                off = off.max(far(direction));
            }
            if shift_mm > 0.0 && nominal.angle_to_run(minus(start, nominal.centre_mm), direction) <= nominal.sweep_rad {
                let point = [0, 1].map(|axis| direction[axis] * nominal.radii_mm[0] - shift[axis]);
                off = off.max((length(point) - radii[0]).abs());
            }
        }
        off + (radii[1] - radii[0]).abs()
    }

    proptest! {
        #[test]
        fn the_deviation_is_that_of_all_directions(
            from in 0.0_f64..TAU,
            sweep in prop_oneof![0.01_f64..TAU, -TAU..-0.01_f64],
            shift in prop_oneof![Just([0.0; 2]), prop::array::uniform2(-0.01_f64..0.01)],
        ) {
            let (nominal, start, end) = circle([1.0, 2.0], 10.0, from, sweep);
            let [start, end] = [start, end].map(|units| units.map(|units| units as f64 / GRID.units_per_mm));
            let centre = [1.0 + shift[0], 2.0 + shift[1]];
            let (first, last) = (minus(start, centre), minus(end, centre));
            let found = nominal.deviation_of([start, end], centre, nominal.angle_to_run(first, last));
            let expected = deviation_in_all_directions(&nominal, start, end, centre);
            prop_assert_eq!(found.plane_mm.to_bits(), expected.to_bits());
            let largest = nominal.largest_deviation(centre, [length(first), length(last)]);
            prop_assert!(found.plane_mm <= largest.plane_mm + 1e-12);
            prop_assert_eq!(found.centre_mm.to_bits(), largest.centre_mm.to_bits());
        }

        /// The path that a control makes of the words, sampled at many points, is within the deviation of the fit.
        #[test]
        fn a_fit_deviates_by_no_more_than_it_states(
            centre in prop::array::uniform2(-300.0_f64..300.0),
            radius in 0.05_f64..400.0,
            from in 0.0_f64..TAU,
            sweep in prop_oneof![0.01_f64..TAU, -TAU..-0.01_f64],
        ) {
            let (nominal, start, end) = circle(centre, radius, from, sweep);
            if let Some(fit) = nominal.fit(start, end, GRID) {
                let deviation = nominal.deviation([start, end], &fit, GRID).plane_mm;
                prop_assert!(deviation <= fit.largest_deviation.plane_mm + 1e-12, "{fit:?}");
                let [start, end, middle] = [start, end, fit.centre].map(|units| units.map(|units| units as f64 / 1e3));
                let (first, last) = (minus(start, middle), minus(end, middle));
                let unequal = (length(first) - length(last)).abs();
                prop_assert!(unequal <= GRID.radius_tolerance_mm);
                let begin = first[1].atan2(first[0]);
                for step in 0..=200 {
                    let part = f64::from(step) / 200.0;
                    let angle = begin + sweep.signum() * fit.sweep_rad * part;
                    let r = length(first) + (length(last) - length(first)) * part;
                    let point = [middle[0] + r * angle.cos(), middle[1] + r * angle.sin()];
                    let off = (length(minus(point, centre)) - radius).abs();
                    prop_assert!(off <= deviation + 1e-9, "{off} {fit:?}");
                }
                let reached = begin + sweep.signum() * fit.sweep_rad;
                let (x, y) = (middle[0] + length(last) * reached.cos(), middle[1] + length(last) * reached.sin());
                prop_assert!((x - end[0]).hypot(y - end[1]) < 1e-6, "the sweep leads to the end");
                if let Some((units, off)) = nominal.radius(
                    start.map(|value| (value * 1e3).round() as i64),
                    end.map(|value| (value * 1e3).round() as i64),
                    &fit,
                    GRID,
                ) {
                    prop_assert_eq!(units < 0, fit.sweep_rad > PI);
                    // The centre that the control computes: on the side given by sign and sense.
                    let r = units.unsigned_abs() as f64 / 1e3;
                    let chord = minus(end, start);
                    let height = (r * r - 0.25 * dot(chord, chord)).sqrt();
                    let side = if (units > 0) == (sweep > 0.0) { 1.0 } else { -1.0 };
                    let computed = [
                        0.5 * (start[0] + end[0]) - side * height * chord[1] / length(chord),
                        0.5 * (start[1] + end[1]) + side * height * chord[0] / length(chord),
                    ];
                    prop_assert!(length(minus(computed, middle)) < 0.1 * radius + 0.01, "{computed:?} {middle:?}");
                    prop_assert!((length(minus(start, computed)) - r).abs() < 1e-6);
                    prop_assert!(off.plane_mm < 1.0);
                }
            }
        }

        #[test]
        fn words_of_long_arcs_deviate_as_little_as_rounding_explains(
            centre in prop::array::uniform2(-300.0_f64..300.0),
            radius in 5.0_f64..100.0,
            from in 0.0_f64..TAU,
            sweep in 0.5_f64..5.0,
        ) {
            let (nominal, start, end) = circle(centre, radius, from, sweep);
            let fit = nominal.fit(start, end, GRID);
            let largest = largest_by_rounding(sweep);
            prop_assert!(fit.is_some_and(|fit| fit.largest_deviation.plane_mm < largest), "{fit:?} {largest}");
        }
    }
}
