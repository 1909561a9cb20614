//! Words of a motion: axes, F, radius correction, sense of an arc, components of the tool axis, M codes.

use super::super::block::Side;
use super::super::draft::Code;
use super::super::line::Line;

/// Takes the words up to the end of the line or a comment.
pub(super) fn motion(line: &mut Line<'_>) -> bool {
    while !line.at.ended() && line.at.peek() != Some(b';') {
        let start = line.at.column();
        if !word(line) && !rapid(line, start) && !side(line, start) && !sense(line, start) {
            line.at.go_to(start);
            return false;
        }
    }
    // FMAX holds for its block, F from its block on: together they are no motion that is known.
    line.draft.code != Some(Code::Rapid) || line.draft.feed.is_none()
}

/// M codes alone, up to the end of the line or a comment.
pub(super) fn codes(line: &mut Line<'_>) -> bool {
    while !line.at.ended() && line.at.peek() != Some(b';') {
        if line.at.peek() != Some(b'M') || !word(line) {
            return false;
        }
    }
    true
}

/// `FMAX`.
fn rapid(line: &mut Line<'_>, start: usize) -> bool {
    line.at.go_to(start);
    let found = line.at.word(b"FMAX");
    if found {
        let first = line.draft.code != Some(Code::Rapid);
        line.draft.code = Some(Code::Rapid);
        line.once(first, b"FMAX", start);
    }
    found
}

/// `R0`, `RL`, `RR`; one of them.
fn side(line: &mut Line<'_>, start: usize) -> bool {
    line.at.go_to(start);
    [(&b"R0"[..], Side::None), (b"RL", Side::Left), (b"RR", Side::Right)]
        .into_iter()
        .any(|(word, side)| line.at.word(word) && line.draft.side.replace(side).is_none())
}

/// `DR+`, `DR-`.
fn sense(line: &mut Line<'_>, start: usize) -> bool {
    line.at.go_to(start);
    let sense = match line.at.rest() {
        [b'D', b'R', b'+', ..] => 1.0,
        [b'D', b'R', b'-', ..] => -1.0,
        _ => return false,
    };
    line.at.skip(3);
    line.draft.pitch.replace(sense).is_none()
}

/// `MB MAX` after M140: no other distance is known.
fn end_of_travel(line: &mut Line<'_>) -> bool {
    line.at.words("MB MAX") && line.draft.feed.is_none()
}

/// Letters and a number, with an `I` in front of those that are distances.
fn word(line: &mut Line<'_>) -> bool {
    let start = line.at.column();
    let leading = line.at.take(b'I');
    let letters = line.at.letters();
    let incremental = leading && !letters.is_empty();
    line.at.blanks();
    let Some(number) = line.at.number() else { return false };
    if let Some(index) = line.axis(letters) {
        let first = line.draft.axis(index, number.value);
        if incremental {
            line.draft.incremental |= 1 << index;
        }
        line.once(first, letters, start);
        return true;
    }
    let first = match letters {
        b"PA" if incremental => line.draft.sweep.replace(number.value.to_radians()).is_none(),
        _ if leading => return false,
        b"F" => line.draft.feed.replace(number.value).is_none(),
        b"TX" | b"TY" | b"TZ" => line.vector(usize::from(letters[1] - b'X'), number.value),
        // R0 is the radius correction.
        b"R" if number.negative || number.value > 0.0 => line.draft.radius.replace(number.value).is_none(),
        b"M" => return line.code(b'M', number, start) && (!line.draft.end_of_travel || end_of_travel(line)),
        _ => return false,
    };
    line.once(first, letters, start);
    true
}
