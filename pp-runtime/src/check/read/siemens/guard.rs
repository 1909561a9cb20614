//! Guards: `IF ABS($P_TOOLL[1]-L)>tol`, `MSG("..")`, `M0`, `M30`, `ENDIF`, each a line. That of the radius begins with
//! `IF ABS($P_TOOLR)>tol`, that of rotary positions with `IF ABS(SIN(($AA_IW[B]-30)/2))+ABS(SIN(($AA_IW[C]+20)/2))>t`;
//! SIN is in degrees, and reading `$AA_IW` stops the look-ahead.
//! That of what lies over the work offset has rotation, scale and mirror of X, Y and Z of `$P_ACTFRAME`, the chain of
//! all frames (programming manual 12/2019, 6FC5398-2EP40-0BA0, p. 631 and 636).

use super::super::block::{Guard, LengthSource, RotaryGuard};
use super::super::line::Line;
use super::super::orders::ModeOrder;
use super::super::text::Cursor;

/// Largest sum of rotations in degrees, and of deviations of scales from 1, that a guard lets pass.
const LARGEST_SUM: f64 = 1e-3;

/// The guard that has begun.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct SiemensGuards {
    open: Option<(OpenGuard, Stops)>,
}

/// What an open guard compares.
#[derive(Debug, Clone, Copy)]
enum OpenGuard {
    Length(Guard),
    Radius(f64),
    Plane(RotaryGuard),
    Offset,
}

/// How far a guard stops the program: M0 shows its message, and M30 ends the program whatever the operator does.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
struct Stops {
    stop: bool,
    end: bool,
}

impl SiemensGuards {
    /// A guard has begun.
    pub(super) fn is_open(&self) -> bool {
        self.open.is_some()
    }

    /// A line of a guard: whether it is a block. `None` if it is none of a guard.
    #[inline]
    pub(super) fn line(&mut self, line: &mut Line<'_>) -> Option<bool> {
        if let Some((guard, stops)) = self.open {
            return Some(self.within(guard, stops, line));
        }
        if !matches!(line.at.rest(), [b'I' | b'i', b'F' | b'f', ..]) || !line.at.word(b"IF") {
            return None;
        }
        let unit = if line.facts().guard_in_mm { 1.0 } else { line.unit() };
        let offset = is_offset(&mut line.at).then_some(OpenGuard::Offset);
        let guard = offset.or_else(|| positions(line)).or_else(|| condition(&mut line.at, unit));
        self.open = guard.map(|guard| (guard, Stops::default()));
        if self.open.is_none() {
            line.fault(
                0,
                "unknown condition: the check reads `IF ABS($P_TOOLL[1]-L)>t`, `IF ABS($P_TOOLR)>t`, \
                 `IF ABS(SIN(($AA_IW[B]-30)/2))>t` and that of rotation, scale and mirror of `$P_ACTFRAME`",
            );
            return Some(true);
        }
        Some(false)
    }

    fn within(&mut self, guard: OpenGuard, mut stops: Stops, line: &mut Line<'_>) -> bool {
        let at = &mut line.at;
        if at.word(b"ENDIF") && at.ended() {
            self.open = None;
            if !(stops.stop && stops.end) {
                line.fault(0, "the guard does not stop and end the program: M0 and M30 expected before ENDIF");
            }
            line.orders.mode(match guard {
                OpenGuard::Length(guard) => ModeOrder::Guard(guard),
                OpenGuard::Radius(largest_mm) => ModeOrder::RadiusGuard(largest_mm),
                OpenGuard::Plane(guard) => ModeOrder::PlaneGuard(guard),
                OpenGuard::Offset => ModeOrder::OffsetGuard,
            });
            return true;
        }
        let stop = at.word(b"M0");
        if (stop || at.word(b"M30")) && at.ended() {
            (stops.stop, stops.end) = (stops.stop || stop, stops.end || !stop);
            self.open = Some((guard, stops));
        } else if at.peek() != Some(b';') && !(message(at) && at.ended()) {
            line.fault(0, "this block is executed only under a condition");
            return true;
        }
        false
    }
}

/// `ABS(SIN(($AA_IW[B]-30)/2))+..>t`, and nothing after it; takes nothing if it is something else.
fn positions(line: &mut Line<'_>) -> Option<OpenGuard> {
    let start = line.at;
    let open = compared(line);
    if open.is_none() {
        line.at = start;
    }
    open
}

fn compared(line: &mut Line<'_>) -> Option<OpenGuard> {
    let mut guard = RotaryGuard::default();
    loop {
        line.at.literal(b"ABS(SIN(($AA_IW[").then_some(())?;
        let name = line.at.name().to_ascii_uppercase();
        let index = line.axis(&name)?;
        let rotary = line.machine().axis(index).rotary && line.at.literal(b"]");
        let degrees = rotary.then(|| line.at.subtracted())??;
        guard.compare(index, degrees.to_radians())?;
        line.at.literal(b")/2))").then_some(())?;
        if line.at.literal(b">") {
            break;
        }
        line.at.literal(b"+").then_some(())?;
    }
    guard.largest = line.at.spaced_number()?.value;
    (line.at.ended() && guard.largest > 0.0).then_some(OpenGuard::Plane(guard))
}

/// `ABS($P_TOOLL[1]-L)>tol` or `ABS($P_TOOLR)>tol`, and nothing after it.
fn condition(at: &mut Cursor<'_>, unit: f64) -> Option<OpenGuard> {
    if at.literal(b"ABS($P_TOOLR)>") {
        let largest = at.spaced_number()?.value;
        return (at.ended() && largest > 0.0).then_some(OpenGuard::Radius(largest * unit));
    }
    let length = at.literal(b"ABS($P_TOOLL[1]-").then(|| at.spaced_number())??.value;
    let tolerance = at.literal(b")>").then(|| at.spaced_number())??.value;
    let [length_mm, tolerance_mm] = [length * unit, tolerance * unit];
    let guard = Guard { length_mm, tolerance_mm, source: LengthSource::Edge, stops: true };
    (at.ended() && tolerance > 0.0).then_some(OpenGuard::Length(guard))
}

/// `(ABS($P_ACTFRAME[X,RT])+ABS($P_ACTFRAME[X,SC]-1)+..>t) OR $P_ACTFRAME[X,MI] ..`, and nothing after it; takes
/// nothing if it is something else.
fn is_offset(at: &mut Cursor<'_>) -> bool {
    let start = *at;
    let whole = at.literal(b"(ABS($P_ACTFRAME[X,RT])+ABS($P_ACTFRAME[Y,RT])+ABS($P_ACTFRAME[Z,RT])")
        && at.literal(b"+ABS($P_ACTFRAME[X,SC]-1)+ABS($P_ACTFRAME[Y,SC]-1)+ABS($P_ACTFRAME[Z,SC]-1)>")
        && at.spaced_number().is_some_and(|largest| largest.value > 0.0 && largest.value <= LARGEST_SUM)
        && at.literal(b")OR$P_ACTFRAME[X,MI]OR$P_ACTFRAME[Y,MI]OR$P_ACTFRAME[Z,MI]")
        && at.ended();
    if !whole {
        *at = start;
    }
    whole
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
