//! Words of a motion: axes, F, radius correction, sense of an arc, components of the tool axis, M codes.

use super::super::block::{Side, coolant};
use super::super::draft::{Code, Draft};
use super::super::line::Line;
use super::super::text::whole;
use crate::program::Rotation;

/// Takes the words up to the end of the line or a comment.
pub(super) fn motion(line: &mut Line<'_>) -> bool {
    while !line.at.ended() && line.at.peek() != Some(b';') {
        let start = line.at.at;
        if line.at.word(b"FMAX") || (line.at.word(b"F") && line.at.word(b"MAX")) {
            line.draft.code = Some(Code::Rapid);
            continue;
        }
        line.at.at = start;
        if !side(line) && !sense(line) && !word(line) {
            line.at.at = start;
            return false;
        }
    }
    true
}

/// `R0`, `RL`, `RR`; one of them.
fn side(line: &mut Line<'_>) -> bool {
    [(&b"R0"[..], Side::None), (b"RL", Side::Left), (b"RR", Side::Right)]
        .into_iter()
        .any(|(word, side)| line.at.word(word) && line.draft.side.replace(side).is_none())
}

/// `DR+`, `DR-`.
fn sense(line: &mut Line<'_>) -> bool {
    let sense = match line.at.rest() {
        [b'D', b'R', b'+', ..] => 1.0,
        [b'D', b'R', b'-', ..] => -1.0,
        _ => return false,
    };
    line.at.at += 3;
    line.draft.pitch = Some(sense);
    true
}

/// Letters and a number, with an `I` in front of those that are distances.
fn word(line: &mut Line<'_>) -> bool {
    let start = line.at.at;
    let leading = line.at.take(b'I');
    let letters = line.at.letters();
    let incremental = leading && !letters.is_empty();
    line.at.blanks();
    let Some(number) = line.at.number() else { return false };
    if let Some(index) = line.axis(letters) {
        let first = line.draft.axis(index, number.value, number.negative);
        if incremental {
            line.draft.incremental |= 1 << index;
        }
        line.once(first, letters, start);
        return true;
    }
    match letters {
        b"PA" if incremental => line.draft.sweep = Some(number.value.to_radians()),
        b"F" => line.draft.feed = Some(number.value),
        b"TX" | b"TY" | b"TZ" => line.vector(usize::from(letters[1] - b'X'), number.value),
        b"R" => line.draft.radius = Some(number.value),
        b"M" => return m(whole(number).unwrap_or(u32::MAX), line.draft) || line.in_set_up(line.read_from(start)),
        _ => return false,
    }
    true
}

/// An M code.
fn m(number: u32, draft: &mut Draft) -> bool {
    match number {
        0 => draft.stop = Some(false),
        1 => draft.stop = Some(true),
        2 | 30 => draft.end = true,
        3 => draft.spindle = Some(Some(Rotation::Clockwise)),
        4 => draft.spindle = Some(Some(Rotation::CounterClockwise)),
        5 => draft.spindle = Some(None),
        8 => draft.coolant_on |= coolant::FLOOD,
        9 => draft.coolant_off |= coolant::FLOOD | coolant::MIST,
        13 | 14 => {
            draft.coolant_on |= coolant::FLOOD;
            draft.spindle = Some(Some(if number == 13 { Rotation::Clockwise } else { Rotation::CounterClockwise }));
        }
        91 => draft.machine = true,
        99 => draft.call = true,
        126 => draft.shortest = Some(true),
        127 => draft.shortest = Some(false),
        128 => draft.tip_control = Some(true),
        129 => draft.tip_control = Some(false),
        _ => return false,
    }
    true
}
