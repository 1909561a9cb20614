//! Tilted planes, and a control that keeps the tip on its path.

use super::super::frames;
use super::super::line::Line;
use super::super::orders::{ModeOrder, TiltCode};
use super::ended;

/// How the rotary axes get to a plane.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Positioning {
    /// They stay, and the control does not move them.
    Stay,
    /// They rotate.
    Turn,
    /// They rotate, and the linear axes keep the tool at its point of the part.
    Move,
}

/// Words after the positioning.
#[derive(Debug, Clone, Copy, Default)]
struct PositioningWords {
    retract: bool,
    distance: bool,
    feed: bool,
    pose: Option<bool>,
    /// TABLE ROT or COORD ROT.
    coordinate_rotation: Option<bool>,
}

/// `PLANE RESET STAY`, `PLANE RESET TURN MB MAX FMAX`: with TURN and MOVE the rotary axes go to 0.
pub(super) fn reset(line: &mut Line<'_>) -> bool {
    let Some(positioning) = positioning(line) else { return false };
    let stays = positioning == Positioning::Stay;
    line.tilt(if stays { TiltCode::Off } else { TiltCode::Zero });
    words(line, positioning).is_some_and(|words| words.pose.is_none() && words.coordinate_rotation.is_none())
}

/// `PLANE SPATIAL SPA+45 SPB+0 SPC+90 TURN MB MAX FMAX SEQ- COORD ROT`.
pub(super) fn spatial(line: &mut Line<'_>) -> bool {
    let mut angles = [0.0; 3];
    for (angle, name) in angles.iter_mut().zip([b"SPA", b"SPB", b"SPC"]) {
        line.at.blanks();
        if line.at.letters() != name {
            return false;
        }
        let Some(number) = line.at.number() else { return false };
        *angle = number.value;
    }
    let Some(positioning) = positioning(line) else { return false };
    let Some(words) = words(line, positioning) else { return false };
    line.tilt(TiltCode::On {
        rotation: frames::spatial(angles),
        origin: nalgebra::Vector3::zeros(),
        oriented: positioning != Positioning::Stay,
        pose: words.pose,
        rotates_table: words.coordinate_rotation != Some(true),
    });
    if positioning == Positioning::Move {
        line.fault(0, "PLANE with MOVE moves the linear axes as well, by a distance that depends on the control");
    }
    true
}

fn positioning(line: &mut Line<'_>) -> Option<Positioning> {
    let choices = [(&b"TURN"[..], Positioning::Turn), (b"MOVE", Positioning::Move), (b"STAY", Positioning::Stay)];
    choices.into_iter().find(|(word, _)| line.at.word(word)).map(|(_, positioning)| positioning)
}

/// `MB MAX`, `MB50`, `DIST50`, `FMAX`, `F500`, `SEQ-`, `TABLE ROT`, `COORD ROT`; each at most once.
fn words(line: &mut Line<'_>, positioning: Positioning) -> Option<PositioningWords> {
    let mut words = PositioningWords::default();
    let moves = positioning != Positioning::Stay;
    while !ended(line) {
        let at = &mut line.at;
        let letters = at.letters();
        let first = match letters {
            b"MB" if moves => {
                let distance = at.word(b"MAX") || at.spaced_number().is_some_and(|number| number.value >= 0.0);
                distance && !std::mem::replace(&mut words.retract, true)
            }
            b"DIST" if positioning == Positioning::Move => {
                at.spaced_number().is_some() && !std::mem::replace(&mut words.distance, true)
            }
            b"FMAX" if moves => !std::mem::replace(&mut words.feed, true),
            b"F" if moves => {
                at.spaced_number().is_some_and(|number| number.value > 0.0) && !std::mem::replace(&mut words.feed, true)
            }
            // SYM is not SEQ: it counts from the symmetry point of the axes, which the check does not know.
            b"SEQ" => {
                let plus = at.take(b'+');
                (plus || at.take(b'-')) && words.pose.replace(plus).is_none()
            }
            b"TABLE" | b"COORD" => at.word(b"ROT") && words.coordinate_rotation.replace(letters == b"COORD").is_none(),
            _ => false,
        };
        if !first {
            return None;
        }
    }
    Some(words)
}

/// `FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS`: whether the tool axis rotates in a plane. With AXIS SPAT the words of
/// rotary axes would be spatial angles, which nothing here is.
pub(super) fn tcpm(line: &mut Line<'_>) -> bool {
    line.orders.mode(ModeOrder::TipControl(true));
    let at = &mut line.at;
    let positions = at.words("F TCP AXIS POS PATHCTRL");
    let in_plane = positions && at.word(b"VECTOR");
    if !positions || !in_plane && !at.word(b"AXIS") {
        return false;
    }
    line.orders.mode(ModeOrder::InPlane(in_plane));
    ended(line)
}
