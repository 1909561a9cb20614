//! The guard of rotary positions after a plane call: it reads the positions, and jumps over an error.
//!
//! `FN 20: WAIT FOR SYNC`, `FN 18: SYSREAD QL1 = ID270 NR1 IDX5` for each axis,
//! `QL3 = ABS ( SIN ( ( QL1 - 30 ) / 2 ) ) + ABS ( SIN ( ( QL2 + 20 ) / 2 ) )`,
//! `FN 12: IF +QL3 LT +0.0009 GOTO LBL "PLANE1"`, a comment, `FN 14: ERROR = 101`, `LBL "PLANE1"`.

use super::super::block::RotaryGuard;
use super::super::line::Line;
use super::super::orders::ModeOrder;
use super::super::text::{Cursor, whole};
use super::guard::{GuardLabel, continues, label};

/// Axes in the order of their numbers in `ID270`; the check states them itself.
const AXES: &[u8; 9] = b"XYZABCUVW";

/// Progress of a guard.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct PlaneGuardLines {
    due: Due,
    /// The axes whose positions have been read, by QL number.
    axes: [Option<usize>; 2],
    guard: RotaryGuard,
    passed: GuardLabel,
}

/// The next line of a guard.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
enum Due {
    #[default]
    Wait,
    Position,
    /// A further position, or the sum.
    Sum,
    Jump,
    Error,
    Label,
}

impl PlaneGuardLines {
    /// Whether a guard has begun.
    pub(super) fn is_open(&self) -> bool {
        self.due != Due::Wait
    }

    /// The next line of a guard; `false` if it is not.
    pub(super) fn line(&mut self, line: &mut Line<'_>) -> bool {
        let due = self.next(line);
        let continues = continues(line, due.is_some(), self.is_open(), "the guard of the rotary positions");
        let Some(due) = due.filter(|_| continues) else {
            *self = Self::default();
            return false;
        };
        self.due = due;
        if !self.is_open() {
            line.orders.mode(ModeOrder::PlaneGuard(std::mem::take(self).guard));
        }
        true
    }

    /// Takes a line: what is due after it.
    fn next(&mut self, line: &mut Line<'_>) -> Option<Due> {
        match self.due {
            Due::Wait => line.at.literal(b"FN20:WAITFORSYNC").then_some(Due::Position),
            Due::Position => self.position(line, 0),
            Due::Sum => self.position(line, 1).or_else(|| self.sum(&mut line.at)),
            Due::Jump => {
                self.guard.largest = line.at.literal(b"FN12:IF+QL3LT").then(|| line.at.spaced_number())??.value;
                self.passed = line.at.literal(b"GOTOLBL").then(|| label(&mut line.at))??;
                (self.guard.largest > 0.0).then_some(Due::Error)
            }
            Due::Error => {
                let number = line.at.literal(b"FN14:ERROR=").then(|| line.at.spaced_number())?.and_then(whole);
                number.filter(|number| *number > 0).map(|_| Due::Label)
            }
            Due::Label => (line.at.word(b"LBL") && label(&mut line.at)? == self.passed).then_some(Due::Wait),
        }
    }

    /// `FN 18: SYSREAD QL1 = ID270 NR1 IDX5`.
    fn position(&mut self, line: &mut Line<'_>, place: usize) -> Option<Due> {
        let start: &[u8] = [b"FN18:SYSREADQL1=ID270NR1IDX", b"FN18:SYSREADQL2=ID270NR1IDX"][place];
        let number = line.at.literal(start).then(|| line.at.number())?.and_then(whole)?;
        let name = AXES.get(usize::try_from(number).ok()?.checked_sub(1)?)?;
        let index = line.axis(&[*name]).filter(|&index| line.machine().axis(index).rotary)?;
        *self.axes.get_mut(place).filter(|axis| axis.is_none())? = Some(index);
        Some(Due::Sum)
    }

    /// `QL3 = ABS ( SIN ( ( QL1 - 30 ) / 2 ) ) + ..`, with every position that has been read.
    fn sum(&mut self, at: &mut Cursor<'_>) -> Option<Due> {
        at.literal(b"QL3=").then_some(())?;
        for (place, index) in self.axes.iter().enumerate().filter_map(|(place, axis)| Some((place, (*axis)?))) {
            let start: &[u8] = [b"ABS(SIN((QL1" as &[u8], b"+ABS(SIN((QL2"][place];
            let degrees = at.literal(start).then(|| at.subtracted())??;
            at.literal(b")/2))").then_some(())?;
            self.guard.compare(index, degrees.to_radians())?;
        }
        Some(Due::Jump)
    }
}
