//! Programs of a Siemens 840D: words with and without `=`, keywords, calls.
//!
//! `D` puts the length of a cutting edge in force, `D0` none. `G4 F` waits seconds. `CYCLE8x(..)` runs where the tool
//! is, `MCALL CYCLE8x(..)` at each point that follows. A guard is `IF` with a condition on the tool's length, a
//! message, a stop and `ENDIF`.
//!
//! Words and keywords are here, codes in the table of the language, calls in `calls`.

mod calls;
mod guard;

use self::guard::SiemensGuards;
use super::LineLanguage;
use super::language::{Address, Means, StatementWord};
use super::line::Line;
use super::orders::{Cycle, ModeOrder};
use super::text::{Cursor, Number, whole};
use super::words::{Coded, Counts, Word};

/// What is remembered from one line to the next.
#[derive(Debug, Default)]
pub(super) struct SiemensLines {
    guard: SiemensGuards,
    began: bool,
}

/// What the calls of a line ask for.
#[derive(Debug, Default)]
struct Calls {
    /// MCALL.
    modal: bool,
    /// A cycle, where one is called with arguments that are right.
    cycle: Option<Cycle>,
    has_cycle: bool,
}

impl LineLanguage for SiemensLines {
    fn line(&mut self, line: &mut Line<'_>) -> bool {
        line.at.blanks();
        match line.at.rest() {
            [] => return false,
            // The file header of an archive.
            [b'%', b'_', b'N', b'_', ..] if !self.began => {
                self.began = true;
                return false;
            }
            _ => {}
        }
        self.began = true;
        if let Some(is_block) = self.guard.line(line) {
            return is_block;
        }
        let mut calls = Calls::default();
        while !line.at.ended() && line.at.peek() != Some(b';') {
            let start = line.at.column();
            if !item(line, &mut calls) {
                let mut from = line.at;
                from.go_to(start);
                let word = from.rest().split(|byte| *byte == b' ').next().unwrap_or_default();
                line.unknown_text(start, word);
                if line.at.column() == start {
                    line.at.skip(word.len().max(1));
                }
            }
        }
        let cycle = calls.cycle.map(|cycle| cycle.in_unit(line.machine().unit()));
        if calls.modal {
            line.orders.mode(ModeOrder::CallAtEachPoint(cycle));
        } else if let Some(cycle) = cycle {
            line.orders.mode(ModeOrder::Define(cycle));
        }
        line.compose(calls.has_cycle && !calls.modal);
        true
    }

    fn is_in_guard(&self) -> bool {
        self.guard.is_open()
    }
}

/// A word, a keyword or a call; `false` if it is not known.
fn item(line: &mut Line<'_>, calls: &mut Calls) -> bool {
    let start = line.at.column();
    match line.at.letters() {
        [] => false,
        [letter] => word(line, letter.to_ascii_uppercase(), start),
        _ => {
            line.at.go_to(start);
            keyword(line, calls)
        }
    }
}

/// A letter, the digits of its name (`C1=30`), and its value.
fn word(line: &mut Line<'_>, letter: u8, start: usize) -> bool {
    let digits = line.at.rest().iter().take_while(|byte| byte.is_ascii_digit()).count();
    let named = line.at.rest().get(digits) == Some(&b'=');
    if named && digits > 3 {
        return false;
    }
    let mut name = [letter, 0, 0, 0];
    let length = if named { 1 + digits } else { 1 };
    name[1..length].copy_from_slice(&line.at.rest()[..length - 1]);
    let name = &name[..length];
    line.at.skip(if named { digits + 1 } else { 0 });
    if name == b"T" && named && line.at.peek() == Some(b'"') {
        return tool_name(line, start);
    }
    let Some((number, counts)) = value(&mut line.at) else { return false };
    if let Some(index) = line.axis(name) {
        line.word(name, Word::new(Address::Axis, index, number, counts, start));
        return true;
    }
    let spindle = line.vocabulary().spindle_number;
    let address = match name {
        [b'S', number @ ..] if spindle.is_some() => {
            let of_tool = spindle.is_some_and(|spindle| spindle.to_string().as_bytes() == number);
            if !of_tool {
                line.fault(start, "the speed of another spindle than that of the tool");
            }
            line.language().address(b'S')
        }
        [letter] => line.language().address(*letter),
        _ => None,
    };
    let Some(address) = address.or_else(|| named_address(line, name)) else { return false };
    if counts != Counts::AsInForce && !(address == Address::Centre && counts == Counts::Absolute) {
        return false;
    }
    let index = match address {
        Address::Code => return line.code(letter, number, start),
        Address::BlockNumber => {
            line.block_number(number, start);
            return true;
        }
        Address::Vector => usize::from(letter - b'A'),
        Address::Centre => usize::from(letter - b'I'),
        Address::Tool => {
            // The empty spindle has no name.
            if whole(number) != Some(0) {
                line.called(false, start);
            }
            0
        }
        _ => 0,
    };
    if matches!(address, Address::Tool | Address::Edge) && whole(number).is_none() {
        return false;
    }
    line.word(name, Word::new(address, index, number, counts, start));
    true
}

/// Address of a letter with digits: A3.
fn named_address(line: &Line<'_>, name: &[u8]) -> Option<Address> {
    match line.language().word(name)?.means {
        Means::Address(address) => Some(address),
        _ => None,
    }
}

/// A name of two letters or more.
fn keyword(line: &mut Line<'_>, calls: &mut Calls) -> bool {
    let start = line.at.column();
    let name = line.at.name();
    line.orders.speaks = true;
    line.orders.stops_look_ahead |= name.eq_ignore_ascii_case(b"STOPRE");
    if line.at.peek() == Some(b'(') {
        line.orders.stops_look_ahead |= !name.eq_ignore_ascii_case(b"MSG");
        return calls::call(line, name, calls, start);
    }
    let Some(row) = line.language().word(name) else { return false };
    match row.means {
        // `CR=5`, `AR=90`, `TURN=2`.
        Means::Address(address) => {
            let value = if line.at.take(b'=') { value(&mut line.at) } else { None };
            let Some((number, Counts::AsInForce)) = value else { return false };
            let turns = address == Address::Turns;
            line.word(name, Word::new(address, 0, number, Counts::AsInForce, start));
            return !turns || whole(number).is_some();
        }
        Means::Statement(StatementWord::ModalCall) if !std::mem::replace(&mut calls.modal, true) => {}
        Means::Statement(_) => return false,
        _ => {}
    }
    line.words.add_code(Coded { row, number: 0, column: start, end: line.at.column() });
    line.at.peek() != Some(b'=')
}

/// A number, or one in `AC( )` or `IC( )`.
fn value(at: &mut Cursor<'_>) -> Option<(Number, Counts)> {
    at.blanks();
    if !at.peek()?.is_ascii_alphabetic() {
        let number = at.number()?;
        // An expression goes on.
        let goes_on = matches!(at.peek(), Some(b'+' | b'-' | b'*' | b'/' | b'[' | b'(' | b'='));
        return (!goes_on).then_some((number, Counts::AsInForce));
    }
    let counts = match at.letters() {
        b"AC" => Counts::Absolute,
        b"IC" => Counts::Incremental,
        b"DC" => Counts::Shortest,
        _ => return None,
    };
    at.take(b'(').then_some(())?;
    at.blanks();
    let number = at.number()?;
    at.blanks();
    at.take(b')').then_some((number, counts))
}

/// `T="MILL 10"`.
fn tool_name(line: &mut Line<'_>, start: usize) -> bool {
    line.at.skip(1);
    let rest = line.at.rest();
    let Some(end) = rest.iter().position(|byte| *byte == b'"') else { return false };
    let name = &rest[..end];
    line.at.skip(end + 1);
    line.called(true, start);
    let Some(tool) = line.tool_of(name) else { return false };
    let number = Number { value: f64::from(tool), point: false, negative: false };
    line.word(b"T", Word::new(Address::Tool, 0, number, Counts::AsInForce, start));
    true
}
