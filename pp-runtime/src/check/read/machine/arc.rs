//! Circles and helices as a block programs them: centre and angle from I J K, from a radius, or from a polar angle.
//!
//! In the plane the first axis turns towards the second about the normal: X to Y (G17), Z to X (G18), Y to Z (G19).

use std::f64::consts::TAU;

use super::super::block::ArcMove;
use super::super::orders::ArcWords;
use super::super::state::MAX_AXES;
use super::Interpreter;
use crate::check::tolerances::{EQUAL_RADII, FULL_CIRCLE, RADIUS_BELOW_HALF_CHORD};
use crate::kinematics::math::hypot;
use crate::program::Units;

/// The arc of a block from where the axes stood to where the interpreter has put them.
pub(super) fn of(
    words: &ArcWords,
    machine: &Interpreter,
    (from, known): ([f64; MAX_AXES], u16),
    clockwise: bool,
) -> Result<ArcMove, String> {
    let Some(plane) = machine.state.plane else { return Err("arc without a working plane".to_owned()) };
    let [u, v, w] = plane.axes();
    let (Some(first), Some(second)) = (machine.axes.linear[u], machine.axes.linear[v]) else {
        return Err("arc in a plane for which the machine has no linear axes".to_owned());
    };
    let (end, bits) = (machine.position(), 1 << first | 1 << second);
    if known & bits != bits {
        return Err("arc from an unknown position".to_owned());
    }
    let start = [from[first], from[second]];
    let stop = [end[first], end[second]];
    let centre = match words.radius {
        Some(radius) if words.written == 0 => {
            by_radius(start, stop, (radius * machine.unit(), clockwise), machine.units())?
        }
        Some(_) => return Err("arc with both a radius and a centre".to_owned()),
        None => by_centre(words, machine, start, [u, v, w])?,
    };
    let mut sweep = match words.sweep {
        Some(sweep) => sweep,
        None => turn(start, stop, centre, clockwise),
    };
    let radii = [start, stop].map(|[x, y]| hypot(x - centre[0], y - centre[1]));
    let largest = EQUAL_RADII + 3.0 * machine.axes.rounding;
    if (radii[0] - radii[1]).abs() > largest || radii[0] < FULL_CIRCLE {
        return Err(format!(
            "start and end of the arc are {} and {} from its centre: expected equal radii above 0",
            machine.units().deviation(radii[0]).number(),
            machine.units().deviation(radii[1])
        ));
    }
    sweep += f64::from(words.turns) * TAU.copysign(sweep);
    let mut all = [0.0; 3];
    all[u] = centre[0];
    all[v] = centre[1];
    Ok(ArcMove { centre: all, sweep, by_angle: words.sweep.is_some() })
}

fn by_centre(
    words: &ArcWords,
    machine: &Interpreter,
    start: [f64; 2],
    [u, v, w]: [usize; 3],
) -> Result<[f64; 2], String> {
    if words.written & (1 << w) != 0 {
        return Err("arc with a centre outside its plane".to_owned());
    }
    if words.written == 0 {
        return Err("arc without a centre or a radius".to_owned());
    }
    let from_start = |axis: usize| words.absolute & (1 << axis) == 0 && machine.state.absolute_centres != Some(true);
    let coordinate = |axis: usize, from: f64| {
        let centre = words.centre[axis] * machine.unit();
        if from_start(axis) { from + centre } else { centre }
    };
    Ok([coordinate(u, start[0]), coordinate(v, start[1])])
}

/// A negative radius is that of the longer way round.
fn by_radius(
    start: [f64; 2],
    stop: [f64; 2],
    (radius, clockwise): (f64, bool),
    units: Units,
) -> Result<[f64; 2], String> {
    let (dx, dy) = (stop[0] - start[0], stop[1] - start[1]);
    let chord = hypot(dx, dy);
    if chord < FULL_CIRCLE {
        return Err("a full circle cannot be programmed with its radius".to_owned());
    }
    let square = radius * radius - chord * chord / 4.0;
    if square < -RADIUS_BELOW_HALF_CHORD * radius.abs() {
        let [radius, chord] = [radius.abs(), chord].map(|mm| units.deviation(mm));
        return Err(format!("a radius of {radius} is too small for a chord of {chord}"));
    }
    // To the left of the chord the centre of a short counter-clockwise arc.
    let height = square.max(0.0).sqrt() * if clockwise == (radius > 0.0) { -1.0 } else { 1.0 };
    Ok([(start[0] + stop[0]) / 2.0 - height * dy / chord, (start[1] + stop[1]) / 2.0 + height * dx / chord])
}

/// Angle from start to stop, a whole turn where they are one point.
fn turn(start: [f64; 2], stop: [f64; 2], centre: [f64; 2], clockwise: bool) -> f64 {
    let (a, b) = ([start[0] - centre[0], start[1] - centre[1]], [stop[0] - centre[0], stop[1] - centre[1]]);
    let left = (a[0] * b[1] - a[1] * b[0]).atan2(a[0] * b[0] + a[1] * b[1]).rem_euclid(TAU);
    let whole = hypot(start[0] - stop[0], start[1] - stop[1]) < FULL_CIRCLE;
    match (whole, clockwise) {
        (true, false) => TAU,
        (true, true) => -TAU,
        (false, false) => left,
        (false, true) => left - TAU,
    }
}
