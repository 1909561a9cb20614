//! Calls of a Siemens control: cycles at a point, CYCLE800, and those that move nothing.

use super::super::block::CycleKind;
use super::super::draft::{Cycle, TiltCode};
use super::super::frames;
use super::super::line::Line;
use super::super::text::Cursor;

/// Most arguments of a call that are looked at.
const ARGUMENTS: usize = 24;

/// Calls that move nothing and leave nothing in force that is looked at.
const MESSAGES: [&[u8]; 5] = [b"MSG", b"FGROUP", b"SETAL", b"WRITE", b"CYCLE832"];

/// `NAME(..)`, from the bracket on; `false` if it is not known.
pub(super) fn call(line: &mut Line<'_>, name: &[u8]) -> bool {
    let start = line.at.at;
    let Some((arguments, count)) = arguments(&mut line.at) else {
        line.at.take_rest();
        line.fault(start, "call without its closing bracket");
        return true;
    };
    if name.eq_ignore_ascii_case(b"CYCLE800") {
        line.draft.tilt = if count == 0 { Some(TiltCode::Off) } else { swivel(&arguments) };
        return line.draft.tilt.is_some();
    }
    if MESSAGES.iter().any(|word| name.eq_ignore_ascii_case(word)) {
        return true;
    }
    let Some(code) = name.strip_prefix(b"CYCLE").or(name.strip_prefix(b"cycle")) else { return false };
    line.draft.define = cycle(code, |index| arguments.get(index).copied().flatten());
    line.draft.call = true;
    line.draft.define.is_some()
}

/// CYCLE81 and its kin: RTP, RFP, SDIS, DP, DPR, and what each has behind these.
fn cycle(code: &[u8], number: impl Fn(usize) -> Option<f64>) -> Option<Cycle> {
    let surface = number(1)?;
    let bottom = number(3).or_else(|| Some(surface - number(4)?.abs()))?;
    let reference = surface + number(2).unwrap_or(0.0).abs();
    let (mut dwell, mut feed) = (0.0, None);
    let kind = match code {
        b"81" => CycleKind::Drill,
        b"82" => {
            dwell = number(5).unwrap_or(0.0);
            CycleKind::Drill
        }
        b"83" => {
            // A step that grows smaller is not read here.
            let first = number(5).map(|depth| surface - depth).or(number(6).map(f64::abs))?;
            if number(7).is_some_and(|less| less != 0.0) {
                return None;
            }
            // A wait at the bottom alone, else one after each step.
            dwell = number(15).filter(|wait| *wait != 0.0).or(number(8)).unwrap_or(0.0);
            if number(11) == Some(1.0) { CycleKind::Peck(first) } else { CycleKind::ChipBreak(first) }
        }
        b"84" => {
            dwell = number(5).unwrap_or(0.0);
            CycleKind::Tap(number(8)?)
        }
        b"840" => CycleKind::Tap(number(8)? * if number(6) == Some(4.0) { -1.0 } else { 1.0 }),
        b"85" => {
            dwell = number(5).unwrap_or(0.0);
            feed = number(6);
            CycleKind::Ream
        }
        b"86" => CycleKind::Bore,
        _ => return None,
    };
    Some(Cycle { kind, reference, bottom, back_to: Some(number(0)?), dwell, feed })
}

/// CYCLE800(_FR,"_TC",_ST,_MODE,_X0,_Y0,_Z0,_A,_B,_C,_X1,_Y1,_Z1,_DIR,..) with a new plane, axis by axis.
fn swivel(arguments: &[Option<f64>; ARGUMENTS]) -> Option<TiltCode> {
    let number = |index: usize| arguments[index].unwrap_or(0.0);
    if !(number(2) as u32).is_multiple_of(10) {
        return None;
    }
    let rotation = frames::axis_by_axis(number(3) as u32, [number(7), number(8), number(9)])?;
    let vector = |first: usize| nalgebra::Vector3::new(number(first), number(first + 1), number(first + 2));
    let origin = vector(4) + rotation * vector(10);
    Some(TiltCode::On { rotation, origin, oriented: number(13) != 0.0 })
}

/// Numbers between brackets; a text or a gap is `None`. And how many there are.
fn arguments(at: &mut Cursor<'_>) -> Option<([Option<f64>; ARGUMENTS], usize)> {
    let mut list = [None; ARGUMENTS];
    let mut count = 0;
    at.take(b'(').then_some(())?;
    loop {
        at.blanks();
        match at.peek()? {
            b')' => {
                at.at += 1;
                return Some((list, count));
            }
            b',' => {
                at.at += 1;
                count += 1;
            }
            b'"' => {
                at.at += 1;
                while at.peek()? != b'"' {
                    at.at += 1;
                }
                at.at += 1;
                count = count.max(1);
            }
            _ => {
                *list.get_mut(count)? = Some(at.number()?.value);
                if count == 0 {
                    count = 1;
                    at.blanks();
                    // The first argument is counted; a comma leads to the second.
                    if at.take(b',') {
                        continue;
                    }
                }
            }
        }
    }
}
