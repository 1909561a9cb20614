//! Arcs: C and CP about the pole CC, CR with its radius; DR is the sense.

use super::super::block::WorkPlane;
use super::super::language::Address;
use super::super::line::Line;
use super::super::orders::Code;
use super::super::text::Number;
use super::super::words::{Counts, Word};

/// `CC X+.. Y+..`: sets the pole.
pub(super) fn centre(line: &mut Line<'_>, pole: &mut [Option<f64>; 3]) -> bool {
    *pole = [None; 3];
    while !line.at.ended() && line.at.peek() != Some(b';') {
        let incremental = line.at.take(b'I');
        let Some(axis) = [b'X', b'Y', b'Z'].into_iter().position(|letter| line.at.take(letter)) else { return false };
        let Some(number) = line.at.number() else { return false };
        let from = match (incremental, line.machine().linear()[axis].and_then(|index| line.machine().at(index))) {
            (false, _) => 0.0,
            (true, Some(from)) => from / line.machine().unit(),
            (true, None) => return false,
        };
        if pole[axis].replace(from + number.value).is_some() {
            return false;
        }
    }
    pole.iter().flatten().count() <= 2
}

/// Code of an arc whose words have been read: C has a pole, CR a radius, CP a pole and an angle. `None` where one is
/// missing.
pub(super) fn close(
    line: &mut Line<'_>,
    spelling: &str,
    counter_clockwise: bool,
    pole: &[Option<f64>; 3],
) -> Option<Code> {
    let forms = (line.words.has(Address::Radius), line.words.has(Address::Angle));
    if forms != (spelling == "CR", spelling == "CP") {
        return None;
    }
    let code = if counter_clockwise { Code::CounterClockwise } else { Code::Clockwise };
    if forms.0 {
        return Some(code);
    }
    for (axis, value) in pole.iter().enumerate() {
        if let Some(value) = value {
            add(line, Address::Centre, axis, *value);
        }
    }
    let angle = line.words.left().iter().find(|word| word.address == Address::Angle).map(|word| word.number.value);
    match angle {
        Some(angle) => {
            polar_end(line, angle.to_radians(), pole)?;
            ((angle > 0.0) == counter_clockwise).then_some(code)
        }
        None => pole.iter().any(Option::is_some).then_some(code),
    }
}

/// Adds a word of the pole.
fn add(line: &mut Line<'_>, address: Address, index: usize, value: f64) {
    let number = Number { value, point: true, negative: value < 0.0 };
    line.word(b"CC", Word::new(address, index, number, Counts::Absolute, 0));
}

/// CP: the end in the plane follows from the angle.
fn polar_end(line: &mut Line<'_>, angle: f64, pole: &[Option<f64>; 3]) -> Option<()> {
    let machine = line.machine();
    let [u, v, _] = machine.state().plane.map(WorkPlane::axes)?;
    let unit = machine.unit();
    let from_pole = |axis: usize| {
        let index = machine.linear()[axis]?;
        Some((index, machine.at(index)? / unit - pole[axis]?))
    };
    let ((first, x), (second, y)) = (from_pole(u)?, from_pole(v)?);
    let (sine, cosine) = angle.sin_cos();
    add(line, Address::Axis, first, pole[u]? + x * cosine - y * sine);
    add(line, Address::Axis, second, pole[v]? + x * sine + y * cosine);
    Some(())
}
