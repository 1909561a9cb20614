//! Cycles: CYCL DEF with its parameters, and where they run.

use super::super::block::{CycleKind, WorkOffset};
use super::super::draft::Cycle;
use super::super::line::Line;
use super::super::text::{Cursor, whole};

/// `CYCL CALL`, `CYCL DEF 200 DRILLING ~ Q200=+2 ..`, and the old ones: `CYCL DEF 9.1 DWELL 0.5`.
pub(super) fn statement(line: &mut Line<'_>) -> bool {
    if line.at.word(b"CALL") {
        line.draft.call = true;
        return true;
    }
    line.at.word(b"DEF") && define(line).is_some()
}

fn define(line: &mut Line<'_>) -> Option<()> {
    line.at.blanks();
    let number = line.at.number()?;
    let rest = line.at.rest();
    let q = Parameters { text: rest };
    let tenth = (number.value * 10.0).round() as u32;
    match tenth {
        // 9.0 names the dwell, 32.0 to 32.2 are the tolerance of the control.
        90 | 320..=322 => {}
        91 => {
            let digits = rest.iter().position(|byte| byte.is_ascii_digit()).unwrap_or_default();
            line.draft.dwell = Some(Cursor::new(&rest[digits..]).number()?.value);
        }
        2470 => {
            line.draft.restart = true;
            let row = q.value(339).filter(|row| *row >= 0.0)?;
            line.draft.work_offset = Some(WorkOffset::Row(row as u32));
        }
        _ => line.draft.define = Some(hole(tenth / 10, &q)?.in_unit(line.machine.unit())),
    }
    Some(())
}

/// `Q200=+2` and its kin in the text of a cycle.
struct Parameters<'a> {
    text: &'a [u8],
}

impl Parameters<'_> {
    fn value(&self, number: u32) -> Option<f64> {
        let mut at = Cursor::new(self.text);
        while at.at < self.text.len() {
            if at.take(b'Q') && at.number().and_then(whole) == Some(number) && at.take(b'=') {
                at.blanks();
                return at.number().map(|number| number.value);
            }
            at.at += 1;
        }
        None
    }
}

/// Cycles 200 and up that make one hole.
fn hole(number: u32, q: &Parameters<'_>) -> Option<Cycle> {
    let surface = q.value(203)?;
    let depth = -q.value(201)?;
    let (reference, bottom) = (surface + q.value(200)?, surface - depth);
    let back_to = q.value(204).map_or(reference, |second| (surface + second).max(reference));
    // Steps count from the surface.
    let step = q.value(202).filter(|step| *step > 0.0 && *step < depth);
    let kind = match number {
        200 => step.map_or(CycleKind::Drill, CycleKind::Peck),
        201 => CycleKind::Ream,
        202 => CycleKind::Bore,
        203 | 205 if q.value(212).is_none_or(|less| less == 0.0) => match (step, q.value(213), q.value(257)) {
            (_, _, Some(chip)) if chip > 0.0 => CycleKind::ChipBreak(chip),
            (Some(step), Some(breaks), _) if breaks > 0.0 => CycleKind::ChipBreak(step),
            (Some(step), _, _) => CycleKind::Peck(step),
            (None, _, _) => CycleKind::Drill,
        },
        207 | 209 => CycleKind::Tap(q.value(239)?),
        _ => return None,
    };
    let dwell = q.value(211).unwrap_or(0.0);
    Some(Cycle { kind, reference, bottom, back_to: Some(back_to), dwell, feed: q.value(206) })
}
