//! The guard of what lies over the work offset: it reads the basic rotation, and jumps over an error.
//!
//! `FN 18: SYSREAD QL1 = ID210 NR1` (TNC 426/430 Technical Manual, p. 7-30), `FN 9: IF +QL1 EQU +0 GOTO LBL "OFFSET1"`,
//! a comment, `FN 14: ERROR = 102`, `LBL "OFFSET1"`.

use super::super::line::Line;
use super::super::orders::ModeOrder;
use super::super::text::{Cursor, whole};
use super::guard::{GuardLabel, continues, label};

/// Progress of a guard.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct OffsetGuardLines {
    /// Lines of it that have come.
    lines: u8,
    passed: GuardLabel,
}

impl OffsetGuardLines {
    /// Whether a guard has begun.
    pub(super) fn is_open(&self) -> bool {
        self.lines > 0
    }

    /// The next line of a guard; `false` if it is not.
    pub(super) fn line(&mut self, line: &mut Line<'_>) -> bool {
        let came = self.next(&mut line.at).is_some();
        if !continues(line, came, self.is_open(), "the guard of the work offset") {
            self.lines = 0;
            return false;
        }
        self.lines = (self.lines + 1) % 4;
        if self.lines == 0 {
            line.orders.mode(ModeOrder::OffsetGuard);
        }
        true
    }

    fn next(&mut self, at: &mut Cursor<'_>) -> Option<()> {
        let correct = match self.lines {
            0 => at.literal(b"FN18:SYSREADQL1=ID210NR1"),
            1 => {
                self.passed = at.literal(b"FN9:IF+QL1EQU+0GOTOLBL").then(|| label(at))??;
                true
            }
            2 => at.literal(b"FN14:ERROR=") && at.spaced_number().and_then(whole).is_some_and(|number| number > 0),
            _ => at.word(b"LBL") && label(at)? == self.passed,
        };
        correct.then_some(())
    }
}
