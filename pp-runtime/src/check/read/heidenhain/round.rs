//! Arcs: C and CP go round the pole CC, CR has its radius; DR is the sense.

use super::super::block::WorkPlane;
use super::super::draft::Code;
use super::super::line::Line;

/// `CC X+.. Y+..`: puts the pole.
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

/// What is missing for an arc when its words have been read: C has a pole, CR a radius, CP a pole and an angle.
pub(super) fn close(line: &mut Line<'_>, spelling: &str, pole: &[Option<f64>; 3]) -> bool {
    let draft = &mut *line.draft;
    let forms = (draft.radius.is_some(), draft.sweep.is_some());
    if draft.code.is_some() || forms != (spelling == "CR", spelling == "CP") {
        return false;
    }
    let Some(sense) = draft.pitch.take() else { return false };
    draft.code = Some(if sense > 0.0 { Code::CounterClockwise } else { Code::Clockwise });
    if draft.radius.is_some() {
        return true;
    }
    for (axis, value) in pole.iter().enumerate() {
        if let Some(value) = value {
            draft.centre[axis] = *value;
            draft.centre_written |= 1 << axis;
            draft.centre_absolute |= 1 << axis;
        }
    }
    match draft.sweep {
        Some(angle) => polar_end(line, angle, pole).is_some() && (angle > 0.0) == (sense > 0.0),
        None => draft.centre_written != 0,
    }
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
    line.draft.axis(first, pole[u]? + x * cosine - y * sine);
    line.draft.axis(second, pole[v]? + x * sine + y * cosine);
    Some(())
}
