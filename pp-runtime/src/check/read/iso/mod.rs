//! Programs of letters and numbers: LinuxCNC, Fanuc, Haas.
//!
//! A line has letters and their numbers; codes are in the table of the language. Besides blocks a program has `%`,
//! `O1234`, comments, `/`, and the guards of `guard`.
//!
//! On Fanuc and Haas a length without a decimal point counts least increments (0.001 mm, 0.0001 in, 0.001 degree),
//! unless the set-up says that the control reads them plainly; Haas reads an F without one by a setting, so that it is
//! refused here. There `;` ends a block, and what follows it in the line would be the next block: it is a fault.

mod guard;
mod moves;

use self::guard::Guards;
use self::moves::MoveWords;
use super::language::Address;
use super::line::Line;
use super::machine::Interpreter;
use super::orders::Act;
use super::text::{Number, shown, whole};
use super::words::{Counts, Word};
use super::{LineLanguage, Moves, Vocabulary};
use crate::shortcut::Shortcut;

/// Comments of LinuxCNC that begin with these words and a comma display a text and do nothing else.
const DISPLAYED: [&[u8]; 3] = [b"MSG", b"DEBUG", b"PRINT"];

/// Comments of LinuxCNC that are orders without a comma.
const ORDERS: [&[u8]; 4] = [b"PROBEOPEN", b"PROBECLOSE", b"LOGCLOSE", b"PYRELOAD"];

/// What is remembered from one line to the next.
#[derive(Debug)]
pub(super) struct Iso {
    moves: MoveWords,
    guards: Guards,
    /// The program has begun, and has ended.
    began: bool,
    ended: bool,
}

impl Iso {
    pub(super) fn new(vocabulary: &Vocabulary, machine: &Interpreter) -> Self {
        let moves = MoveWords::new(vocabulary, machine);
        Self { moves, guards: Guards::default(), began: false, ended: false }
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

    /// `%`: before the first block it begins the program, and after it ends it.
    fn mark(&mut self, line: &mut Line<'_>) -> bool {
        line.at.skip(1);
        if !line.at.ended() {
            line.fault(line.at.column(), "text after %");
        }
        if self.began && !self.ended && !line.facts().mark_ends_program {
            line.fault(0, "% before the end code of the program");
        }
        self.ends(line)
    }

    /// Ends the program, if it has begun and has not ended; whether it does.
    fn ends(&mut self, line: &mut Line<'_>) -> bool {
        let ends = self.began && !self.ended;
        if ends {
            line.orders.act(Act::End);
            self.ended = true;
        }
        ends
    }

    /// `O1234 (NAME)`: where it is not the first block it begins another program.
    fn program_number(&mut self, line: &mut Line<'_>) -> bool {
        line.at.skip(1);
        let numbered = line.at.number().and_then(whole).is_some();
        if !numbered || !line.at.ended() && line.at.peek() != Some(b'(') {
            line.unknown_text(0, line.at.rest());
        } else if !line.at.ended() {
            comment(line);
            if !line.at.ended() {
                line.fault(line.at.column(), "text after the program number");
            }
        }
        if self.began && !self.ended {
            line.fault(0, "another program begins before the end code");
        }
        let ends = self.ends(line);
        self.began = true;
        ends
    }
}

impl LineLanguage for Iso {
    fn moves(&self, text: &[u8], machine: &Interpreter, moves: &mut Moves) -> bool {
        if !Shortcut::LinesOfWords.is_on() || self.guards.is_open() {
            return false;
        }
        machine.words_of_moves().is_some_and(|permitted| self.moves.read(text, permitted, moves))
    }

    fn line(&mut self, line: &mut Line<'_>) -> bool {
        line.at.blanks();
        if line.at.rest().is_empty() {
            return false;
        }
        if let Some(is_block) = self.without_words(line) {
            return is_block;
        }
        if words(line) {
            line.compose(false);
        }
        self.began |= line.orders.speaks || line.fault_count() > 0;
        self.ended |= line.orders.acts.contains(&Act::End);
        true
    }

    fn is_in_guard(&self) -> bool {
        self.guards.is_open()
    }

    fn begin(&mut self) {
        self.began = true;
    }
}

/// Takes the words up to the end of the line or a comment that reaches there; `false` at what is no word.
fn words(line: &mut Line<'_>) -> bool {
    while !line.at.ended() {
        let start = line.at.column();
        match line.at.peek() {
            Some(b'(') => comment(line),
            Some(b';') => {
                line.at.skip(1);
                semicolon(line);
                break;
            }
            _ => match line.at.letter_and_number() {
                Some((letter, number)) => word(line, letter.to_ascii_uppercase(), number, start),
                None => {
                    line.at.go_to(start);
                    line.fault(start, format!("`{}` is not a word", shown(line.at.rest())));
                    return false;
                }
            },
        }
    }
    true
}

/// What follows a semicolon.
fn semicolon(line: &mut Line<'_>) {
    let start = line.at.column();
    let rest = line.at.take_rest().trim_ascii();
    if line.facts().semicolon_comments {
        order(line, rest, start);
    } else if !rest.is_empty() {
        line.fault(start, "text after `;`, which ends the block: the control reads it as the next block");
    }
}

/// `( .. )`, without another bracket in it.
fn comment(line: &mut Line<'_>) {
    let start = line.at.column();
    let rest = &line.at.rest()[1..];
    match rest.iter().position(|byte| *byte == b')') {
        Some(end) if !rest[..end].contains(&b'(') => {
            line.at.skip(end + 2);
            order(line, &rest[..end], start);
        }
        _ => {
            line.at.take_rest();
            line.fault(start, "comment without its closing bracket, or with a bracket in it");
        }
    }
}

/// A comment that begins with a word and a comma is an order to LinuxCNC, and so are some words that need none.
fn order(line: &mut Line<'_>, text: &[u8], column: usize) {
    if !line.facts().comments_give_orders {
        return;
    }
    let text = text.trim_ascii_start();
    let end = text.iter().position(|byte| !byte.is_ascii_alphanumeric() && *byte != b'_').unwrap_or(text.len());
    let (word, rest) = text.split_at(end);
    let order = !word.is_empty() && rest.trim_ascii_start().starts_with(b",")
        || ORDERS.iter().any(|known| word.eq_ignore_ascii_case(known));
    if order && !DISPLAYED.iter().any(|known| word.eq_ignore_ascii_case(known)) {
        line.lasting_fault(column, format!("the comment `{}` is an order to the control", shown(text)));
    }
}

/// A letter and its number, which begin at a column.
fn word(line: &mut Line<'_>, letter: u8, number: Number, column: usize) {
    let Some(address) = line.language().address(letter) else { return line.unknown(column) };
    let index = match address {
        Address::Code => {
            if !line.code(letter, number, column) {
                line.unknown(column);
            }
            return;
        }
        Address::BlockNumber => return line.block_number(number, column),
        Address::Axis => match line.axis(&[letter]) {
            Some(index) => index,
            None => return line.fault(column, format!("the machine has no axis {}", char::from(letter))),
        },
        Address::Centre => usize::from(letter - b'I'),
        _ => 0,
    };
    line.word(&[letter], Word::new(address, index, number, Counts::AsInForce, column));
}
