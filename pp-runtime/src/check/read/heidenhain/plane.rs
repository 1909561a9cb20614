//! Tilted planes, and a control that keeps the tip on its path.

use super::super::draft::TiltCode;
use super::super::frames;
use super::super::line::Line;
use super::super::text::Cursor;

/// `PLANE SPATIAL SPA+45 SPB+0 SPC+90 TURN ..`, `PLANE RESET STAY`.
pub(super) fn statement(line: &mut Line<'_>) -> bool {
    let (at, draft) = (&mut line.at, &mut *line.draft);
    if at.word(b"RESET") {
        draft.tilt = Some(TiltCode::Off);
        return at.word(b"STAY") && at.ended() || at.word(b"TURN") || at.word(b"MOVE");
    }
    if !at.word(b"SPATIAL") {
        return false;
    }
    let mut angles = [None; 3];
    for (angle, name) in angles.iter_mut().zip([b"SPA", b"SPB", b"SPC"]) {
        at.blanks();
        if at.letters() != name {
            return false;
        }
        *angle = at.number().map(|number| number.value);
    }
    let [Some(a), Some(b), Some(c)] = angles else { return false };
    let oriented = at.word(b"TURN") || at.word(b"MOVE");
    let stays = !oriented && at.word(b"STAY");
    draft.tilt =
        Some(TiltCode::On { rotation: frames::spatial([a, b, c]), origin: nalgebra::Vector3::zeros(), oriented });
    (oriented || stays) && positioning(at)
}

/// How the rotary axes get there: `MB MAX FMAX SEQ- TABLE ROT`.
fn positioning(at: &mut Cursor<'_>) -> bool {
    const WORDS: [&[u8]; 11] =
        [b"MB", b"MAX", b"FMAX", b"SEQ+", b"SEQ-", b"SYM+", b"SYM-", b"TABLE", b"COORD", b"ROT", b"DIST"];
    let rest = at.rest();
    at.at += rest.len();
    let rest = rest.split(|byte| *byte == b';').next().unwrap_or_default();
    let mut words = rest.split(|byte| *byte == b' ').filter(|word| !word.is_empty());
    words.all(|word| WORDS.contains(&word))
}

/// `FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS`, `FUNCTION RESET TCPM`.
pub(super) fn function(line: &mut Line<'_>) -> bool {
    let at = &mut line.at;
    let reset = at.word(b"RESET");
    line.draft.tip_control = Some(!reset);
    if !at.word(b"TCPM") {
        return false;
    }
    if !reset {
        line.draft.in_plane = tcpm(at);
    }
    reset || line.draft.in_plane.is_some()
}

/// `F TCP AXIS POS PATHCTRL AXIS`: whether the tool axis turns in a plane. With AXIS SPAT the words of rotary axes would be
/// spatial angles, which nothing here is.
fn tcpm(at: &mut Cursor<'_>) -> Option<bool> {
    let positions = at.word(b"F") && at.word(b"TCP") && at.word(b"AXIS") && at.word(b"POS") && at.word(b"PATHCTRL");
    let in_plane = positions && at.word(b"VECTOR");
    (positions && (in_plane || at.word(b"AXIS")) && at.ended()).then_some(in_plane)
}
