//! Arcs by centre, by radius and by polar angle.

use super::super::Control;
use super::super::axes::LETTERS;
use super::super::meaning::{Address, Command, NumberCounting};
use super::super::state::{Distance, Plane};
use super::super::trace::Arc;
use super::{Machine, modes};

/// Largest difference between the distances of both ends from the centre, mm: start, end and centre in words of two
/// decimals are off by half a unit each.
const SAME_RADIUS_MM: f64 = 0.017;

/// Ends nearer than this are one point: a full circle, mm.
const ONE_POINT_MM: f64 = 1e-9;

/// Moves along an arc.
pub(super) fn motion(machine: &mut Machine, command: &mut Command, clockwise: bool) -> Result<Arc, String> {
    let plane = modes::plane(&machine.state)?;
    let [first, second, _] = plane.letters();
    let unit = machine.state.units.map_or(1.0, super::super::state::Units::in_mm);
    let at = |machine: &Machine, letter| {
        let value = machine.state.position.get(letter);
        value.ok_or_else(|| format!("an arc from an unknown position of {letter}"))
    };
    let start = [at(machine, first)?, at(machine, second)?];
    let pole = pole(machine, plane);
    let centre = match (command.take(Address::Radius), pole) {
        (Some(radius), _) => Centre::Radius(radius),
        (None, Some(pole)) => Centre::Point(pole?),
        (None, None) => {
            let absolute = match (machine.control, machine.state.arc_centres) {
                (Control::LinuxCnc, None) => return Err("an arc, and G90.1 may be in force".to_owned()),
                (_, centres) => centres == Some(Distance::Absolute),
            };
            Centre::Point(centre(command, plane, start, absolute)?)
        }
    };
    let polar = command.take(Address::PolarAngle);
    let revolutions = command.take(Address::Revolutions).unwrap_or(0.0);
    machine.place(command, &LETTERS)?;
    if let Some(angle) = polar {
        let Centre::Point(pole) = centre else { return Err("a polar angle without a pole".to_owned()) };
        return polar_arc(machine, plane, start, pole, angle, clockwise);
    }
    let end = [at(machine, first)?, at(machine, second)?];
    let centre = match centre {
        Centre::Point(centre) => centre,
        Centre::Radius(radius) => by_radius(start, end, radius, clockwise)?,
    };
    let [from, to] = [start, end].map(|[x, y]| [x - centre[0], y - centre[1]]);
    let [near, far] = [from, to].map(|[x, y]| x.hypot(y) * unit);
    if (near - far).abs() > SAME_RADIUS_MM || near < ONE_POINT_MM {
        return Err(format!("the ends of the arc are {near:.4} and {far:.4} mm from its centre"));
    }
    let one_point = (start[0] - end[0]).hypot(start[1] - end[1]) * unit < ONE_POINT_MM;
    let left = (to[1].atan2(to[0]) - from[1].atan2(from[0])).to_degrees().rem_euclid(360.0);
    let sweep = match (clockwise, one_point) {
        (false, true) => 360.0,
        (true, true) => -360.0,
        (false, false) => left,
        (true, false) => left - 360.0,
    };
    let more = 360.0 * revolutions * if clockwise { -1.0 } else { 1.0 };
    Ok(Arc { centre: in_space(plane, centre), sweep_deg: sweep + more })
}

enum Centre {
    Point([f64; 2]),
    Radius(f64),
}

/// The pole of a Heidenhain control in the plane; `None` on other controls.
fn pole(machine: &Machine, plane: Plane) -> Option<Result<[f64; 2], String>> {
    let component = |letter: char| {
        let index = "XYZ".find(letter).unwrap_or_default();
        machine.state.pole[index].ok_or_else(|| format!("an arc about a pole without {letter}"))
    };
    let [first, second, _] = plane.letters();
    (machine.control == Control::Heidenhain).then(|| Ok([component(first)?, component(second)?]))
}

/// I J K: distances from the start, or `absolute`.
fn centre(command: &mut Command, plane: Plane, start: [f64; 2], absolute: bool) -> Result<[f64; 2], String> {
    let [first, second, normal] = plane.letters().map(|letter| "XYZ".find(letter).unwrap_or_default());
    if command.take(Address::Centre(normal)).is_some() {
        return Err("an arc with a centre outside its plane".to_owned());
    }
    let words = [first, second].map(|index| command.take_counted(Address::Centre(index)));
    if words == [None, None] {
        return Err("an arc without centre and radius: the end alone has no business here".to_owned());
    }
    let mut centre = start;
    for (place, word) in centre.iter_mut().zip(words) {
        match word {
            Some(word) if absolute || word.counting == NumberCounting::Absolute => *place = word.value,
            Some(word) => *place += word.value,
            None => {}
        }
    }
    Ok(centre)
}

/// A negative radius is that of the longer way round.
fn by_radius(start: [f64; 2], end: [f64; 2], radius: f64, clockwise: bool) -> Result<[f64; 2], String> {
    let chord = [end[0] - start[0], end[1] - start[1]];
    let length = chord[0].hypot(chord[1]);
    let square = radius * radius - length * length / 4.0;
    if length < ONE_POINT_MM || square < -1e-3 * radius.abs() {
        return Err("a radius that fits no arc between these ends".to_owned());
    }
    // Left of the chord lies the centre of a counter-clockwise arc of less than half a circle.
    let side = if clockwise == (radius > 0.0) { -1.0 } else { 1.0 };
    let height = side * square.max(0.0).sqrt() / length;
    Ok([start[0] + chord[0] / 2.0 - height * chord[1], start[1] + chord[1] / 2.0 + height * chord[0]])
}

/// CP: the start turns about the pole by the angle.
fn polar_arc(
    machine: &mut Machine,
    plane: Plane,
    start: [f64; 2],
    pole: [f64; 2],
    angle_deg: f64,
    clockwise: bool,
) -> Result<Arc, String> {
    if angle_deg.abs() < 1e-12 || (angle_deg < 0.0) != clockwise {
        return Err("a polar angle against the sense of its arc".to_owned());
    }
    let [x, y] = [start[0] - pole[0], start[1] - pole[1]];
    let (sine, cosine) = angle_deg.to_radians().sin_cos();
    let [first, second, _] = plane.letters();
    machine.state.position.set(first, pole[0] + x * cosine - y * sine);
    machine.state.position.set(second, pole[1] + x * sine + y * cosine);
    Ok(Arc { centre: in_space(plane, pole), sweep_deg: angle_deg })
}

fn in_space(plane: Plane, centre: [f64; 2]) -> [f64; 3] {
    let [first, second, _] = plane.letters();
    ['X', 'Y', 'Z'].map(|letter| match letter {
        _ if letter == first => centre[0],
        _ if letter == second => centre[1],
        _ => 0.0,
    })
}
