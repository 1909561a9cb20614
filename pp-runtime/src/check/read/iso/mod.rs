//! Programs of letters and numbers: LinuxCNC, Fanuc, Haas.
//!
//! A line is read in one go: letters and their numbers here, G and M in `codes`. What P Q R L X K mean depends on what
//! else stands in the block, so they wait for its end in `loose`; `cycle` has the words of canned cycles, which stay in
//! force. Known besides blocks: `%`, `O1234`, comments, `/`, and the guards of `guard`.
//!
//! On Fanuc and Haas a length without a decimal point counts least increments (0.001 mm, 0.0001 in, 0.001 degree), unless
//! the set-up says that the control reads them plainly; Haas reads an F without one by a setting, so that it is refused
//! here.

mod codes;
mod cycle;
mod guard;
mod loose;

use self::cycle::CycleWords;
use self::guard::Guards;
use self::loose::Loose;
use super::Family;
use super::line::Line;
use super::text::{Number, shown, whole};
use crate::program::Units;

/// Least increment of mm and degrees, and of inches.
const LEAST: f64 = 1e-3;
const LEAST_INCH: f64 = 1e-4;

/// What is remembered from one line to the next.
#[derive(Debug, Default)]
pub(super) struct Iso {
    guards: Guards,
    cycle: CycleWords,
    /// I J K are the tool axis (G43.5).
    vectors: bool,
}

/// One block while its words are read.
struct Reading<'l, 'a> {
    iso: &'l mut Iso,
    line: &'l mut Line<'a>,
    loose: Loose,
}

impl Iso {
    /// Reads one line into its draft; `false` if the line is no block of words.
    pub(super) fn line(&mut self, line: &mut Line<'_>) -> bool {
        line.at.blanks();
        match line.at.rest() {
            [] | [b'%', ..] => return false,
            [b'O' | b'o', ..] => return self.guards.o_word(line),
            [b'I' | b'i', b'F' | b'f', ..] => return self.guards.condition(line),
            [b'#', ..] => {
                self.guards.alarm(line);
                return false;
            }
            _ => {}
        }
        let mut reading = Reading { iso: self, line, loose: Loose::default() };
        if reading.words() {
            reading.conclude();
        }
        true
    }
}

impl Reading<'_, '_> {
    /// Takes the words up to the end of the line or a comment that reaches there; `false` at what is no word.
    fn words(&mut self) -> bool {
        while !self.line.at.ended() {
            let start = self.line.at.at;
            match self.line.at.peek() {
                Some(b'(') => self.comment(),
                Some(b';') => break,
                Some(b'/') if start == 0 => self.line.at.at += 1,
                _ => match self.line.at.letter_and_number() {
                    Some((letter, number)) => self.word(letter.to_ascii_uppercase(), number, start),
                    None => {
                        self.line.at.at = start;
                        self.line.fault(start, format!("`{}` is not a word", shown(self.line.at.rest())));
                        return false;
                    }
                },
            }
        }
        true
    }

    /// `( .. )`, without another bracket in it.
    fn comment(&mut self) {
        let at = &mut self.line.at;
        let start = at.at;
        let rest = &at.rest()[1..];
        match rest.iter().position(|byte| *byte == b')') {
            Some(end) if !rest[..end].contains(&b'(') => at.at += end + 2,
            _ => {
                at.take_rest();
                self.line.fault(start, "comment without its closing bracket, or with a bracket in it");
            }
        }
    }

    /// A letter and its number, which begin at a column.
    #[inline]
    fn word(&mut self, letter: u8, number: Number, column: usize) {
        let first = match letter {
            b'N' => {
                let number = whole(number);
                self.iso.guards.block(number);
                self.line.draft.number.replace(number.map(u64::from).unwrap_or_default()).is_none()
            }
            b'G' => return self.g(number, column),
            b'M' => return self.m(number, column),
            b'X' | b'Y' | b'Z' | b'A' | b'B' | b'C' | b'U' | b'V' | b'W' => {
                let Some(index) = self.line.axis(&[letter]) else {
                    return self.line.fault(column, format!("the machine has no axis {}", char::from(letter)));
                };
                if letter == b'X' {
                    self.loose.x = Some(number);
                }
                let value = self.length(number, self.line.machine.axes[index].rotary);
                self.line.draft.axis(index, value, number.negative)
            }
            b'I' | b'J' | b'K' => {
                if letter == b'K' {
                    self.loose.k = Some(number);
                }
                let value = self.length(number, false);
                self.line.centre(letter, value)
            }
            b'F' => {
                if self.line.family() == Family::Haas && !self.counts_plainly(number) {
                    self.line.fault(column, "F without a decimal point: its value depends on a setting of the control");
                }
                self.line.draft.feed.replace(number.value).is_none()
            }
            b'S' => self.line.draft.speed.replace(number.value).is_none(),
            b'T' => self.line.draft.tool.replace(whole(number).unwrap_or(u32::MAX)).is_none(),
            b'H' => self.line.draft.register.replace(whole(number).unwrap_or(u32::MAX)).is_none(),
            b'D' => self.line.draft.diameter.replace(whole(number).unwrap_or(u32::MAX)).is_none(),
            b'P' => self.loose.p.replace(number).is_none(),
            b'Q' => self.loose.q.replace(number).is_none(),
            b'R' => self.loose.r.replace(number).is_none(),
            b'L' => self.loose.l.replace(number).is_none(),
            b'E' if self.line.family() == Family::Haas => true,
            _ => return self.line.unknown(column),
        };
        self.line.once(first, &[letter], column);
        self.line.draft.speaks();
    }

    /// A length or an angle as written: least increments where there is no point.
    fn length(&self, number: Number, rotary: bool) -> f64 {
        if self.counts_plainly(number) {
            return number.value;
        }
        let inches = self.line.units() == Some(Units::Inches);
        number.value * if inches && !rotary { LEAST_INCH } else { LEAST }
    }

    fn counts_plainly(&self, number: Number) -> bool {
        number.point || self.line.vocabulary.plain || self.line.family() == Family::LinuxCnc
    }

    /// A time in seconds: milliseconds where a Fanuc or a Haas reads no point.
    fn seconds(&self, number: Number) -> f64 {
        let milliseconds = self.line.family() != Family::LinuxCnc && !number.point;
        if milliseconds { number.value / 1000.0 } else { number.value }
    }
}
