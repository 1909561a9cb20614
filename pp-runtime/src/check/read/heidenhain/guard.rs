//! The length guard: it reads length and oversize of a tool from the tool table, and jumps over an error.
//!
//! `FN 18: SYSREAD QL1 = ID50 NR1 IDX5`, `FN 18: SYSREAD QL2 = ID50 NR4 IDX5`, `FN 1: QL1 = +QL1 + +QL2`,
//! `FN 12: IF +QL1 LT +99.99 GOTO LBL "OFF1"`, `FN 12: IF +QL1 LT +100.01 GOTO LBL "FITS1"`, `LBL "OFF1"`,
//! `FN 14: ERROR = 100`, `LBL "FITS1"`. `QL` parameters are local; no other parameter is set anywhere.

use super::super::block::{Guard, LengthSource};
use super::super::line::Line;
use super::super::orders::ModeOrder;
use super::super::text::{Cursor, whole};

/// Bounds and lengths are rounded to this, mm.
const ROUNDED: f64 = 1e4;

/// Length and oversize of a tool; either may be read first.
const READ: [&[u8]; 2] = [b"FN18:SYSREADQL1=ID50NR1IDX", b"FN18:SYSREADQL2=ID50NR4IDX"];

/// How far a guard has come.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct LengthGuardLines {
    /// Lines of it that have come.
    lines: u8,
    /// What is read second, of [`READ`].
    second: usize,
    tool: u32,
    low: f64,
    high: f64,
    off: GuardLabel,
    fits: GuardLabel,
}

/// Name of a label.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(super) struct GuardLabel {
    name: [u8; 24],
    length: usize,
}

/// Whether a line, of which `came` says that it is the next of a guard, is nothing else besides; a guard that has begun
/// is incomplete otherwise.
pub(super) fn continues(line: &mut Line<'_>, came: bool, is_open: bool, guard: &str) -> bool {
    let continues = came && super::ended(line);
    if !continues && is_open {
        line.fault(0, format!("{guard} is not complete before this block"));
    }
    continues
}

impl LengthGuardLines {
    /// Whether a guard has begun.
    pub(super) fn is_open(&self) -> bool {
        self.lines > 0
    }

    /// The next line of a guard; `false` if it is not.
    pub(super) fn line(&mut self, line: &mut Line<'_>) -> bool {
        let came = self.next(&mut line.at).is_some();
        if !continues(line, came, self.is_open(), "the length guard") {
            self.lines = 0;
            return false;
        }
        self.lines += 1;
        if self.lines == 8 {
            self.lines = 0;
            let [low, high] = [self.low, self.high];
            line.orders.mode(ModeOrder::Guard(Guard {
                length_mm: ((low + high) / 2.0 * ROUNDED).round() / ROUNDED,
                tolerance_mm: ((high - low) / 2.0 * ROUNDED).round() / ROUNDED,
                source: LengthSource::Tool(self.tool),
                stops: true,
            }));
        }
        true
    }

    fn next(&mut self, at: &mut Cursor<'_>) -> Option<()> {
        let correct = match self.lines {
            0 => {
                let first = READ.iter().position(|text| at.literal(text))?;
                self.second = 1 - first;
                self.tool = at.number().and_then(whole)?;
                true
            }
            1 => at.literal(READ[self.second]) && at.number().and_then(whole) == Some(self.tool),
            2 => at.literal(b"FN1:QL1=+QL1++QL2"),
            3 => {
                (self.low, self.off) = jump(at)?;
                true
            }
            4 => {
                (self.high, self.fits) = jump(at)?;
                self.high > self.low && self.fits != self.off
            }
            5 => at.word(b"LBL") && label(at)? == self.off,
            6 => at.literal(b"FN14:ERROR=") && at.spaced_number().and_then(whole).is_some_and(|number| number > 0),
            _ => at.word(b"LBL") && label(at)? == self.fits,
        };
        correct.then_some(())
    }
}

/// `FN 12: IF +QL1 LT +99.99 GOTO LBL "OFF1"`: bound and label.
fn jump(at: &mut Cursor<'_>) -> Option<(f64, GuardLabel)> {
    let bound = at.literal(b"FN12:IF+QL1LT").then(|| at.spaced_number())??.value;
    let label = at.literal(b"GOTOLBL").then(|| label(at))??;
    Some((bound, label))
}

/// `"OFF1"`.
pub(super) fn label(at: &mut Cursor<'_>) -> Option<GuardLabel> {
    at.blanks();
    at.take(b'"').then_some(())?;
    let rest = at.rest();
    let length = rest.iter().position(|byte| *byte == b'"')?;
    let mut label = GuardLabel { length, ..GuardLabel::default() };
    label.name.get_mut(..length)?.copy_from_slice(&rest[..length]);
    at.skip(length + 1);
    Some(label)
}
