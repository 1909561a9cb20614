//! Programs of a Siemens 840D: words with and without `=`, keywords, calls.
//!
//! `D` puts the length of a cutting edge in force, `D0` none. `G4 F` waits seconds. `CYCLE8x(..)` runs where it stands,
//! `MCALL CYCLE8x(..)` at each point that follows. A guard is `IF` with a condition on the tool's length, a message, a stop
//! and `ENDIF`.
//!
//! Words and keywords are here, codes in the table of the language, what stands in brackets in `calls`.

mod calls;
mod guard;

use self::guard::Guards;
use super::block::PathMode;
use super::draft::{Cycle, Draft, LengthCode, group};
use super::language::{Address, Means, PathCode, Statement, letters};
use super::line::Line;
use super::text::{Cursor, Number, shown, whole};

/// What is remembered from one line to the next.
#[derive(Debug, Default)]
pub(super) struct Siemens {
    guard: Guards,
    /// MCALL is in force.
    called: Option<Cycle>,
    began: bool,
}

/// How the value of a word counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Counts {
    AsInForce,
    Absolute,
    Incremental,
}

impl Siemens {
    /// Reads one line into its draft; `false` if it is no block.
    pub(super) fn line(&mut self, line: &mut Line<'_>) -> bool {
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
        let mut modal_call = false;
        while !line.at.ended() && line.at.peek() != Some(b';') {
            let start = line.at.column();
            if !item(line, &mut modal_call) {
                let mut from = line.at;
                from.go_to(start);
                let word = from.rest().split(|byte| *byte == b' ').next().unwrap_or_default();
                line.fault(start, format!("`{}` is not known to the check", shown(word)));
                if line.at.column() == start {
                    line.at.skip(word.len().max(1));
                }
            }
        }
        if line.draft.dwells {
            dwell(line);
        }
        line.contradictions();
        let shared = |draft: &Draft| {
            draft.written != 0 || draft.groups & !(1 << group::FREE) != 0 || draft.letters & !letters("N") != 0
        };
        if modal_call && shared(line.draft) {
            line.fault(0, "MCALL in a block with other codes or words: it needs a block of its own");
        }
        path(line);
        self.cycle(line, modal_call);
        true
    }

    /// The line before belongs to a guard that has not ended.
    pub(super) fn is_in_guard(&self) -> bool {
        self.guard.is_open()
    }

    /// Forgets what stays in force.
    pub(super) fn forget(&mut self) {
        self.called = None;
    }

    /// What becomes of the cycle of a block, and of the one that MCALL has left in force.
    fn cycle(&mut self, line: &mut Line<'_>, modal_call: bool) {
        let unit = line.machine().unit();
        let draft = &mut *line.draft;
        draft.define = draft.define.map(|cycle| cycle.in_unit(unit));
        if modal_call {
            self.called = draft.define;
            draft.call = false;
        } else if self.called.is_some() && draft.written != 0 && !draft.machine {
            draft.define = draft.define.or(self.called);
            draft.call = true;
        }
    }
}

/// A word, a keyword or a call; `false` if it is not known.
#[inline]
fn item(line: &mut Line<'_>, modal_call: &mut bool) -> bool {
    let start = line.at.column();
    match line.at.letters() {
        [] => false,
        [letter] => word(line, letter.to_ascii_uppercase(), start),
        _ => {
            line.at.go_to(start);
            keyword(line, modal_call)
        }
    }
}

/// A letter, the digits of its name (`C1=30`), and its value.
#[inline]
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
    line.draft.speaks();
    if let Some(index) = line.axis(name) {
        match counts {
            Counts::AsInForce => {}
            Counts::Absolute => line.draft.absolute |= 1 << index,
            Counts::Incremental => line.draft.incremental |= 1 << index,
        }
        let first = line.draft.axis(index, number.value);
        line.once(first, name, start);
        return true;
    }
    let address = match name {
        [letter] => line.language().address(*letter),
        _ => None,
    };
    let Some(address) = address.or_else(|| named_address(line, name)) else { return false };
    if counts != Counts::AsInForce && !(address == Address::Centre && counts == Counts::Absolute) {
        return false;
    }
    let bit = 1 << (letter - b'A');
    let first = match address {
        Address::Code => return line.code(letter, number, start),
        Address::Vector => line.vector(usize::from(letter - b'A'), number.value),
        Address::Centre => {
            if counts == Counts::Absolute {
                line.draft.centre_absolute |= 1 << (letter - b'I');
            }
            line.centre(letter, number.value)
        }
        _ => {
            let first = line.draft.letters & bit == 0;
            line.draft.letters |= bit;
            first
        }
    };
    match address {
        Address::BlockNumber => line.block_number(number, start),
        Address::Feed => line.draft.feed = Some(number.value),
        Address::Speed => line.draft.speed = Some(number.value),
        Address::Tool => {
            line.draft.tool = whole(number);
            line.called(false, start);
        }
        Address::Edge => {
            line.draft.register = whole(number);
            line.draft.length = Some(if number.value == 0.0 { LengthCode::Off } else { LengthCode::On });
        }
        _ => {}
    }
    let counted = matches!(address, Address::Tool | Address::Edge);
    if counted && whole(number).is_none() {
        return false;
    }
    line.once(first, name, start);
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
fn keyword(line: &mut Line<'_>, modal_call: &mut bool) -> bool {
    let start = line.at.column();
    let name = line.at.name();
    line.draft.speaks();
    if line.at.peek() == Some(b'(') {
        return calls::call(line, name);
    }
    let Some(row) = line.language().word(name) else { return false };
    match row.means {
        Means::Address(address) => return line.at.take(b'=') && assigned(line, address, start),
        Means::Statement(Statement::ModalCall) => return !std::mem::replace(modal_call, true),
        Means::Statement(_) => return false,
        _ => line.carry_out(row, 0, start),
    }
    line.at.peek() != Some(b'=')
}

/// What the codes of the path mode say.
fn path(line: &mut Line<'_>) {
    line.draft.path_mode = line.draft.path.map(|path| match path {
        PathCode::ExactPath => PathMode::ExactPath,
        PathCode::ExactStop | PathCode::Window => PathMode::ExactStop,
        PathCode::Continuous => PathMode::Continuous { tolerance_mm: None, joining_mm: None },
        PathCode::Smoothed(code) => PathMode::Smoothed(code),
    });
}

/// `G4 F0.5` in seconds, `G4 S20` in revolutions of the spindle.
fn dwell(line: &mut Line<'_>) {
    let (feed, speed) = (line.draft.feed.take(), line.draft.speed.take());
    let turns = speed.zip(line.machine().state().speed);
    let seconds = feed.or(turns.map(|(turns, speed)| turns / speed * 60.0));
    line.draft.dwell = Some(seconds.unwrap_or_default());
    if seconds.is_none() {
        line.fault(0, "dwell without its time");
    } else if feed.is_some() && speed.is_some() {
        line.fault(0, "dwell with two times");
    }
}

/// `CR=5`, `AR=90`, `TURN=2`.
fn assigned(line: &mut Line<'_>, address: Address, start: usize) -> bool {
    let Some((number, Counts::AsInForce)) = value(&mut line.at) else { return false };
    let draft = &mut *line.draft;
    let first = match address {
        Address::Radius => draft.radius.replace(number.value).is_none(),
        Address::Angle => draft.sweep.replace(number.value.to_radians()).is_none(),
        Address::Turns => match whole(number) {
            Some(turns) => std::mem::replace(&mut draft.turns, turns) == 0,
            None => return false,
        },
        _ => return false,
    };
    let name = line.read_from(start);
    line.once(first, name, start);
    true
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
    line.draft.speaks();
    let first = line.draft.tool.is_none();
    line.draft.tool = line.tool_of(name);
    line.called(true, start);
    line.once(first, b"T", start);
    line.draft.tool.is_some()
}
