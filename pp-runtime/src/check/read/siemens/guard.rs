//! The length guard: `IF ABS($P_TOOLL[1]-L)>tol`, `MSG("..")`, `M0`, `M30`, `ENDIF`, each a line.

use super::super::block::{Guard, LengthSource};
use super::super::line::Line;
use super::super::text::Cursor;

/// The guard that has begun.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct LengthGuard {
    open: Option<Guard>,
}

impl LengthGuard {
    /// A line of a guard: whether it is a block. `None` if it is none of a guard.
    #[inline]
    pub(super) fn line(&mut self, line: &mut Line<'_>) -> Option<bool> {
        if let Some(guard) = self.open {
            return Some(self.within(guard, line));
        }
        if !matches!(line.at.rest(), [b'I' | b'i', b'F' | b'f', ..]) || !line.at.word(b"IF") {
            return None;
        }
        let unit = if line.facts().guard_in_mm { 1.0 } else { line.unit() };
        self.open = condition(&mut line.at, unit);
        if self.open.is_none() {
            line.fault(0, "unknown condition: the check reads `IF ABS($P_TOOLL[1]-L)>t`");
            return Some(true);
        }
        Some(false)
    }

    fn within(&mut self, mut guard: Guard, line: &mut Line<'_>) -> bool {
        let at = &mut line.at;
        if at.word(b"ENDIF") && at.ended() {
            self.open = None;
            line.draft.guard = Some(guard);
            if !guard.stops {
                line.fault(0, "the length guard does not stop the program");
            }
            return true;
        }
        if (at.word(b"M0") || at.word(b"M30")) && at.ended() {
            guard.stops = true;
            self.open = Some(guard);
        } else if !(message(at) && at.ended()) {
            line.fault(0, "this block is executed only under a condition");
            return true;
        }
        false
    }
}

/// `ABS($P_TOOLL[1]-L)>tol` and nothing after it.
fn condition(at: &mut Cursor<'_>, unit: f64) -> Option<Guard> {
    let length = at.literal(b"ABS($P_TOOLL[1]-").then(|| at.spaced_number())??.value;
    let tolerance = at.literal(b")>").then(|| at.spaced_number())??.value;
    let [length_mm, tolerance_mm] = [length * unit, tolerance * unit];
    let guard = Guard { length_mm, tolerance_mm, source: LengthSource::Edge, stops: false };
    (at.ended() && tolerance > 0.0).then_some(guard)
}

/// `MSG("..")`.
fn message(at: &mut Cursor<'_>) -> bool {
    if !at.literal(b"MSG(\"") {
        return false;
    }
    let rest = at.rest();
    let Some(end) = rest.iter().position(|byte| *byte == b'"') else { return false };
    at.skip(end + 1);
    at.literal(b")")
}
