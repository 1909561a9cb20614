//! What is no block of letters and numbers: program numbers, and guards that compare the length of the tool.
//!
//! LinuxCNC: `o1 if [..]` up to `o1 endif` with nothing in it but messages. Fanuc and Haas: `IF [..] THEN #3000=1 (..)`, or
//! `IF [..] GOTO n` over such an alarm to the block `Nn`.

use super::super::Family;
use super::super::line::Line;
use super::super::text::{Cursor, shown, whole};

/// The variable that raises an alarm.
const ALARM: u32 = 3000;

/// Guards that have begun and not ended.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Guards {
    /// The label of an `if` of LinuxCNC.
    open: Option<u32>,
    /// The block to which a jump over an alarm leads.
    jump: Option<u32>,
}

impl Guards {
    /// Whether what stands here runs only where a guard lets it.
    pub(super) fn open(&self) -> bool {
        self.open.is_some()
    }

    /// A block of this number begins: a jump may have led to it.
    pub(super) fn block(&mut self, number: Option<u32>) {
        if self.jump == number {
            self.jump = None;
        }
    }

    /// `O1234 (NAME)`, `o1 if [..]`, `o1 endif`; `true` if a guard begins.
    pub(super) fn o_word(&mut self, line: &mut Line<'_>) -> bool {
        line.at.at += 1;
        let Some(label) = line.at.number().and_then(whole) else {
            line.fault(0, "O word without a number");
            return false;
        };
        if line.at.ended() || line.at.peek() == Some(b'(') {
            if line.family() == Family::LinuxCnc && line.at.ended() {
                line.fault(0, "O word without a function");
            }
        } else if line.at.word(b"if") && self.open.is_none() {
            self.open = Some(label);
            line.draft.guard = compared(line.at.rest());
            if line.draft.guard.is_none() {
                line.fault(line.at.at, "unknown condition");
            }
        } else if line.at.word(b"endif") && self.open == Some(label) && line.at.ended() {
            self.open = None;
        } else {
            line.fault(0, format!("`{}` is not known to the check", shown(line.at.rest())));
        }
        line.draft.guard.is_some()
    }

    /// `IF [ABS[#..-101.5] GT 0.01] THEN #3000=1 (..)`, and `IF [ABS[#..-101.5] LT 0.01] GOTO 5` over such an alarm.
    pub(super) fn condition(&mut self, line: &mut Line<'_>) -> bool {
        line.at.at += 2;
        let rest = line.at.rest();
        let length = match rest.windows(4).position(|word| word.eq_ignore_ascii_case(b"THEN")) {
            Some(then) => compared(&rest[..then]).filter(|_| is_alarm(&mut behind(rest, then))),
            None => compared(rest).filter(|_| self.jumps(rest)),
        };
        match length.filter(|_| line.family() != Family::LinuxCnc) {
            Some(length) => line.draft.guard = Some(length),
            None => line.fault(0, "unknown condition"),
        }
        true
    }

    /// `.. GOTO 5`.
    fn jumps(&mut self, rest: &[u8]) -> bool {
        let goto = rest.windows(4).rposition(|word| word.eq_ignore_ascii_case(b"GOTO"));
        let target = goto.and_then(|goto| behind(rest, goto).number()).and_then(whole);
        self.jump = target.or(self.jump);
        target.is_some()
    }

    /// `#3000 = 1 (TEXT)`: only a guard jumps over it.
    pub(super) fn alarm(&self, line: &mut Line<'_>) {
        if !is_alarm(&mut line.at) || self.jump.is_none() {
            line.fault(0, "a variable is set or an alarm is raised without a condition");
        }
    }
}

/// Behind a word of four letters.
fn behind(rest: &[u8], word: usize) -> Cursor<'_> {
    let mut at = Cursor::new(&rest[word + 4..]);
    at.blanks();
    at
}

/// `#3000 =`.
fn is_alarm(at: &mut Cursor<'_>) -> bool {
    let variable = at.take(b'#') && at.number().and_then(whole) == Some(ALARM);
    at.blanks();
    variable && at.take(b'=')
}

/// The length that a condition compares with: the number behind the first `-`.
fn compared(condition: &[u8]) -> Option<f64> {
    let minus = condition.iter().position(|byte| *byte == b'-')?;
    let mut at = Cursor::new(&condition[minus + 1..]);
    at.blanks();
    at.number().map(|number| number.value)
}
