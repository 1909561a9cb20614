//! Programs of letters and numbers: LinuxCNC, Fanuc, Haas.
//!
//! A line is read in one go: letters and their numbers here, codes by the table of the language. What P Q R E X K mean
//! depends on what else is in the block, so they wait for its end in `loose`; `cycle` has the words of canned cycles, which
//! stay in force. Besides blocks a program has `%`, `O1234`, comments, `/`, and the guards of `guard`.
//!
//! On Fanuc and Haas a length without a decimal point counts least increments (0.001 mm, 0.0001 in, 0.001 degree), unless
//! the set-up says that the control reads them plainly; Haas reads an F without one by a setting, so that it is refused
//! here. There `;` ends a block, and what follows it in the line would be the next block: it is a fault.

mod cycle;
mod guard;
mod loose;
mod moves;

use self::cycle::{CycleWords, RepeatedHole};
use self::guard::Guards;
use self::loose::Loose;
use self::moves::MoveWords;
use super::Vocabulary;
use super::draft::Draft;
use super::language::{Address, Letters, Pattern, letters};
use super::line::Line;
use super::machine::Interpreter;
use super::text::{Number, shown, whole};
use crate::program::Units;
use crate::shortcut::Shortcut;

/// Least increment of mm and degrees, and of inches.
const LEAST: f64 = 1e-3;
const LEAST_INCH: f64 = 1e-4;

/// Words that any block may have: block number, codes, axes, F, S, T.
const ALWAYS: Letters = letters("NGMXYZABCUVWFST");

/// Comments of LinuxCNC that begin with these words and a comma display a text and do nothing else.
const DISPLAYED: [&[u8]; 3] = [b"MSG", b"DEBUG", b"PRINT"];

/// Comments of LinuxCNC that are orders without a comma.
const ORDERS: [&[u8]; 4] = [b"PROBEOPEN", b"PROBECLOSE", b"LOGCLOSE", b"PYRELOAD"];

/// M29 without its thread.
const WITHOUT_THREAD: &str = "M29 in the block before: expected its thread here, G84 or G74";

/// What is remembered from one line to the next.
#[derive(Debug)]
pub(super) struct Iso {
    moves: MoveWords,
    guards: Guards,
    cycle: CycleWords,
    /// Hole that the next line of axis words drills again.
    repeated_hole: Option<RepeatedHole>,
    /// I J K are the tool axis (G43.5).
    vectors: bool,
    /// Address words that the motion code in force takes.
    modal: Letters,
    /// The next thread is cut in step with the spindle (M29).
    rigid: bool,
    /// The block of that thread must come next.
    thread_due: bool,
    /// The program has begun, and has ended.
    began: bool,
    ended: bool,
}

/// One block while its words are read.
struct Reading<'l, 'a> {
    iso: &'l mut Iso,
    line: &'l mut Line<'a>,
    loose: Loose,
}

impl Iso {
    pub(super) fn new(vocabulary: &Vocabulary, machine: &Interpreter) -> Self {
        Self {
            moves: MoveWords::new(vocabulary, machine),
            guards: Guards::default(),
            cycle: CycleWords::default(),
            repeated_hole: None,
            vectors: false,
            modal: 0,
            rigid: false,
            thread_due: false,
            began: false,
            ended: false,
        }
    }

    /// Reads one line into its draft; `false` if the line is no block of words.
    pub(super) fn line(&mut self, line: &mut Line<'_>) -> bool {
        let before = self.repeated_hole.take();
        line.at.blanks();
        if line.at.rest().is_empty() {
            return false;
        }
        let due = std::mem::take(&mut self.thread_due);
        if let Some(is_block) = self.without_words(line) {
            if due {
                line.lasting_fault(0, WITHOUT_THREAD);
            }
            return is_block;
        }
        let mut reading = Reading { iso: self, line, loose: Loose::default() };
        if reading.words() {
            reading.conclude();
            reading.note_hole(before);
        }
        let says = line.draft.groups != 0 || line.draft.written != 0 || line.fault_count() > 0;
        self.began |= says;
        if due && says && !matches!(line.draft.hole, Some(Pattern::TapAfterRigid { .. })) {
            line.lasting_fault(0, WITHOUT_THREAD);
        }
        self.thread_due = line.draft.rigid && line.draft.hole.is_none() || due && !says;
        self.ended |= line.draft.end;
        true
    }

    /// Those of I J K that are the centre of an arc whose code is in force.
    fn centre_letters(&self) -> Letters {
        if self.vectors { 0 } else { self.modal & letters("IJK") }
    }

    /// Reads a line that only moves axes, and may drill the hole of the line before again; `false` if it is another, or may mean
    /// something else. Then nothing has been read.
    pub(super) fn moves(&mut self, text: &[u8], draft: &mut Draft) -> bool {
        if !Shortcut::LinesOfWords.is_on() || self.rigid || self.thread_due || self.guards.is_open() {
            return false;
        }
        let permitted = match &self.repeated_hole {
            _ if self.cycle.is_off() => moves::permitted(self.centre_letters()),
            Some(hole) => moves::AXES & !(1 << hole.normal),
            None => return false,
        };
        if !self.moves.read(text, permitted, draft) {
            draft.forget_moves();
            return false;
        }
        (draft.only_moves, draft.is_moves) = (true, true);
        if let Some(hole) = &self.repeated_hole {
            draft.define = Some(hole.cycle);
        }
        draft.speaks();
        self.began = true;
        true
    }

    /// Reads a line that has no words: whether it is a block. `None` if it has words.
    fn without_words(&mut self, line: &mut Line<'_>) -> Option<bool> {
        match line.at.rest() {
            [b'%', ..] => Some(self.mark(line)),
            [b'O' | b'o', ..] if line.facts().program_numbers => Some(self.program_number(line)),
            _ => {
                let is_block = self.guards.line(line)?;
                self.began = true;
                Some(is_block)
            }
        }
    }

    /// The line before belongs to a guard that has not ended.
    pub(super) fn is_in_guard(&self) -> bool {
        self.guards.is_open()
    }

    /// Forgets what stays in force.
    pub(super) fn forget(&mut self) {
        (self.cycle, self.repeated_hole, self.vectors, self.modal) = (CycleWords::default(), None, false, 0);
        (self.rigid, self.thread_due) = (false, false);
    }

    /// `%`: before the first block it begins the program, and after it ends it.
    fn mark(&mut self, line: &mut Line<'_>) -> bool {
        line.at.skip(1);
        if !line.at.ended() {
            line.fault(line.at.column(), "text after %");
        }
        let ends = self.began && !self.ended;
        if ends && !line.facts().mark_ends_program {
            line.fault(0, "% before the end code of the program");
        }
        line.draft.end = ends;
        self.ended |= ends;
        ends
    }

    /// `O1234 (NAME)`: where it is not the first block it begins another program.
    fn program_number(&mut self, line: &mut Line<'_>) -> bool {
        line.at.skip(1);
        if line.at.number().and_then(whole).is_none() {
            line.fault(0, "O word without a number");
        } else if !line.at.ended() && line.at.peek() != Some(b'(') {
            line.fault(0, format!("`{}` is not known to the check", shown(line.at.rest())));
        } else if !line.at.ended() {
            Reading { iso: self, line, loose: Loose::default() }.comment();
            if !line.at.ended() {
                line.fault(line.at.column(), "text after the program number");
            }
        }
        let ends = self.began && !self.ended;
        if ends {
            line.fault(0, "another program begins before the end code");
        }
        line.draft.end = ends;
        self.ended |= ends;
        self.began = true;
        ends
    }
}

/// Whether a number counts as it is written, not in least increments.
fn counts_plainly(line: &Line<'_>, number: Number) -> bool {
    number.point || line.vocabulary().plain || !line.facts().least_increments
}

impl Reading<'_, '_> {
    /// Takes the words up to the end of the line or a comment that reaches there; `false` at what is no word.
    fn words(&mut self) -> bool {
        while !self.line.at.ended() {
            let start = self.line.at.column();
            match self.line.at.peek() {
                Some(b'(') => self.comment(),
                Some(b';') => {
                    self.line.at.skip(1);
                    self.semicolon();
                    break;
                }
                _ => match self.line.at.letter_and_number() {
                    Some((letter, number)) => self.word(letter.to_ascii_uppercase(), number, start),
                    None => {
                        self.line.at.go_to(start);
                        self.line.fault(start, format!("`{}` is not a word", shown(self.line.at.rest())));
                        return false;
                    }
                },
            }
        }
        true
    }

    /// What follows a semicolon.
    fn semicolon(&mut self) {
        let start = self.line.at.column();
        let rest = self.line.at.take_rest().trim_ascii();
        if self.line.facts().semicolon_comments {
            self.order(rest, start);
        } else if !rest.is_empty() {
            self.line.fault(start, "text after `;`, which ends the block: the control reads it as the next block");
        }
    }

    /// `( .. )`, without another bracket in it.
    fn comment(&mut self) {
        let at = &mut self.line.at;
        let start = at.column();
        let rest = &at.rest()[1..];
        match rest.iter().position(|byte| *byte == b')') {
            Some(end) if !rest[..end].contains(&b'(') => {
                at.skip(end + 2);
                self.order(&rest[..end], start);
            }
            _ => {
                at.take_rest();
                self.line.fault(start, "comment without its closing bracket, or with a bracket in it");
            }
        }
    }

    /// A comment that begins with a word and a comma is an order to LinuxCNC, and so are some words that need none.
    fn order(&mut self, text: &[u8], column: usize) {
        if !self.line.facts().comments_give_orders {
            return;
        }
        let text = text.trim_ascii_start();
        let end = text.iter().position(|byte| !byte.is_ascii_alphanumeric() && *byte != b'_').unwrap_or(text.len());
        let (word, rest) = text.split_at(end);
        let order = !word.is_empty() && rest.trim_ascii_start().starts_with(b",")
            || ORDERS.iter().any(|known| word.eq_ignore_ascii_case(known));
        if order && !DISPLAYED.iter().any(|known| word.eq_ignore_ascii_case(known)) {
            self.line.lasting_fault(column, format!("the comment `{}` is an order to the control", shown(text)));
        }
    }

    /// A letter and its number, which begin at a column.
    #[inline]
    fn word(&mut self, letter: u8, number: Number, column: usize) {
        let Some(address) = self.line.language().address(letter) else { return self.line.unknown(column) };
        if address == Address::Code {
            if !self.line.code(letter, number, column) {
                self.line.unknown(column);
            }
            return self.line.draft.speaks();
        }
        let bit = 1 << (letter - b'A');
        let first = self.line.draft.letters & bit == 0;
        self.line.draft.letters |= bit;
        match address {
            Address::BlockNumber => self.line.block_number(number, column),
            Address::Axis => {
                let Some(index) = self.line.axis(&[letter]) else {
                    return self.line.fault(column, format!("the machine has no axis {}", char::from(letter)));
                };
                if letter == b'X' {
                    self.loose.x = Some(number);
                }
                let value = self.length(number, self.line.machine().axis(index).rotary);
                self.line.draft.axis(index, value);
            }
            Address::Centre => {
                if letter == b'K' {
                    self.loose.k = Some(number);
                }
                let value = self.length(number, false);
                self.line.centre(letter, value);
            }
            Address::Feed => {
                if self.line.facts().feed_needs_point && !counts_plainly(self.line, number) {
                    self.line.fault(column, "F without a decimal point: its value depends on a setting of the control");
                }
                self.line.draft.feed = Some(number.value);
            }
            Address::Speed => self.line.draft.speed = Some(number.value),
            Address::Tool => self.line.draft.tool = Some(self.register(number, column)),
            Address::LengthRegister => self.line.draft.register = Some(self.register(number, column)),
            Address::RadiusRegister => self.line.draft.diameter = Some(self.register(number, column)),
            _ => match letter {
                b'P' => self.loose.p = Some(number),
                b'Q' => self.loose.q = Some(number),
                b'R' => self.loose.r = Some(number),
                b'E' => self.loose.e = Some(number),
                _ => self.line.unknown(column),
            },
        }
        self.line.once(first, &[letter], column);
        self.line.draft.speaks();
    }

    /// The number of a tool or a register.
    fn register(&mut self, number: Number, column: usize) -> u32 {
        whole(number).unwrap_or_else(|| {
            self.line.fault(column, "number of a tool or a register that is no whole number");
            u32::MAX
        })
    }

    /// A length or an angle as written: least increments where there is no point.
    fn length(&self, number: Number, rotary: bool) -> f64 {
        if counts_plainly(self.line, number) {
            return number.value;
        }
        let inches = self.line.units() == Some(Units::Inches);
        number.value * if inches && !rotary { LEAST_INCH } else { LEAST }
    }

    /// A time in seconds: milliseconds where a Fanuc or a Haas reads no point.
    fn seconds(&self, number: Number) -> f64 {
        let milliseconds = self.line.facts().least_increments && !number.point;
        if milliseconds { number.value / 1000.0 } else { number.value }
    }

    /// A P in seconds.
    fn wait(&mut self, number: Number) -> f64 {
        if self.line.facts().whole_milliseconds && number.point {
            self.line.fault(0, "P of a dwell has no decimal point: it counts milliseconds");
        }
        self.seconds(number)
    }
}
