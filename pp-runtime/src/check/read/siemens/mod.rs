//! Programs of a Siemens 840D: words with and without `=`, keywords, calls.
//!
//! `D` puts the length of a cutting edge in force, `D0` none. `G4 F` waits seconds. `CYCLE8x(..)` runs where it stands,
//! `MCALL CYCLE8x(..)` at each point that follows. Guards are `IF` with a condition on the tool's length, up to `ENDIF`;
//! messages, alarms and stops stand between the two.
//!
//! Words and keywords are here, G and M in `codes`, what stands in brackets in `calls`.

mod calls;
mod codes;

use super::draft::{Cycle, LengthCode};
use super::line::Line;
use super::text::{Cursor, Number, shown, whole};

/// What is remembered from one line to the next.
#[derive(Debug, Default)]
pub(super) struct Siemens {
    /// Between IF and ENDIF.
    guard: bool,
    /// MCALL is in force.
    called: Option<Cycle>,
}

/// How the value of a word counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Counts {
    AsInForce,
    Absolute,
    Incremental,
}

/// What decides the meaning of other words of its block.
#[derive(Debug, Default)]
struct Loose {
    /// G4: F and S are its time.
    dwell: bool,
    mcall: bool,
}

impl Siemens {
    /// Reads one line into its draft; `false` if it is no block.
    pub(super) fn line(&mut self, line: &mut Line<'_>) -> bool {
        line.at.blanks();
        if matches!(line.at.peek(), None | Some(b'%')) {
            return false;
        }
        if self.guard {
            self.guard = !line.at.rest().windows(5).any(|word| word.eq_ignore_ascii_case(b"ENDIF"));
            return false;
        }
        let mut loose = Loose::default();
        while !line.at.ended() && line.at.peek() != Some(b';') {
            let start = line.at.at;
            if line.at.take(b'/') && start == 0 {
                continue;
            }
            if !self.item(line, &mut loose) {
                let mut from = line.at;
                from.at = start;
                let word = from.rest().split(|byte| *byte == b' ').next().unwrap_or_default();
                line.fault(start, format!("`{}` is not known to the check", shown(word)));
                if line.at.at == start {
                    line.at.at += word.len().max(1);
                }
            }
        }
        if loose.dwell {
            dwell(line);
        }
        self.cycle(line, &loose);
        true
    }

    /// A word, a keyword or a call; `false` if it is not known.
    #[inline]
    fn item(&mut self, line: &mut Line<'_>, loose: &mut Loose) -> bool {
        let start = line.at.at;
        match line.at.letters() {
            [] => false,
            [letter] => self.word(line, loose, letter.to_ascii_uppercase(), start),
            _ => {
                line.at.at = start;
                self.keyword(line, loose)
            }
        }
    }

    /// A letter, the digits of its name (`C1=30`), and its value.
    #[inline]
    fn word(&mut self, line: &mut Line<'_>, loose: &mut Loose, letter: u8, start: usize) -> bool {
        let digits = line.at.rest().iter().take_while(|byte| byte.is_ascii_digit()).count();
        let named = line.at.rest().get(digits) == Some(&b'=');
        let mut name = [letter, 0, 0, 0];
        let length = if named { 1 + digits.min(3) } else { 1 };
        name[1..length].copy_from_slice(&line.at.rest()[..length - 1]);
        let name = &name[..length];
        line.at.at += if named { digits + 1 } else { 0 };
        if letter == b'T' && named && line.at.peek() == Some(b'"') {
            return tool_name(line);
        }
        let Some((number, counts)) = value(&mut line.at) else { return false };
        line.draft.speaks();
        if let Some(index) = line.axis(name) {
            match counts {
                Counts::AsInForce => {}
                Counts::Absolute => line.draft.absolute |= 1 << index,
                Counts::Incremental => line.draft.incremental |= 1 << index,
            }
            let first = line.draft.axis(index, number.value, number.negative);
            line.once(first, name, start);
            return true;
        }
        let first = match name {
            [b'A' | b'B' | b'C', b'3'] => {
                line.vector(usize::from(letter - b'A'), number.value);
                true
            }
            b"N" => {
                line.draft.number = whole(number).map(u64::from);
                true
            }
            b"G" => return codes::g(line, loose, number, start),
            b"M" => return codes::m(line, number, start) || line.in_set_up(line.read_from(start)),
            b"F" => line.draft.feed.replace(number.value).is_none(),
            b"S" => line.draft.speed.replace(number.value).is_none(),
            b"T" => line.draft.tool.replace(whole(number).unwrap_or(u32::MAX)).is_none(),
            b"D" => {
                line.draft.register = whole(number);
                line.draft.length = Some(if number.value == 0.0 { LengthCode::Off } else { LengthCode::On });
                true
            }
            b"I" | b"J" | b"K" => {
                if counts == Counts::Absolute {
                    line.draft.centre_absolute |= 1 << (letter - b'I');
                }
                line.centre(letter, number.value)
            }
            _ => return false,
        };
        line.once(first, name, start);
        true
    }

    /// A name of two letters or more.
    fn keyword(&mut self, line: &mut Line<'_>, loose: &mut Loose) -> bool {
        const OF_THE_CONTROL: [&[u8]; 2] = [b"STOPRE", b"RET"];
        let start = line.at.at;
        let name = line.at.name();
        let is = |word: &[u8]| name.eq_ignore_ascii_case(word);
        line.draft.speaks();
        match line.at.peek() {
            Some(b'=') => return assigned(line, name),
            Some(b'(') => return calls::call(line, name),
            _ => {}
        }
        if is(b"SUPA") {
            line.draft.machine = true;
        } else if is(b"TRAFOOF") {
            line.draft.tip_control = Some(false);
        } else if is(b"TRAORI") {
            line.draft.tip_control = Some(true);
        } else if is(b"ORIAXES") || is(b"ORIVECT") {
            line.draft.in_plane = Some(is(b"ORIVECT"));
        } else if is(b"ORIMKS") || is(b"ORIWKS") {
            line.draft.in_workpiece = Some(is(b"ORIWKS"));
        } else if is(b"MCALL") {
            loose.mcall = true;
        } else if is(b"IF") {
            line.draft.guard = compared(line.at.take_rest());
            self.guard = line.draft.guard.is_some();
            return self.guard;
        } else if !OF_THE_CONTROL.into_iter().any(is) {
            return line.in_set_up(line.read_from(start));
        }
        true
    }

    /// What becomes of the cycle of a block, and of the one that MCALL has left in force.
    fn cycle(&mut self, line: &mut Line<'_>, loose: &Loose) {
        let unit = line.machine.unit();
        let draft = &mut *line.draft;
        draft.define = draft.define.map(|cycle| cycle.in_unit(unit));
        if loose.mcall {
            self.called = draft.define;
            draft.call = false;
        } else if self.called.is_some() && draft.written != 0 && !draft.machine {
            draft.define = draft.define.or(self.called);
            draft.call = true;
        }
    }
}

/// `G4 F0.5` in seconds, `G4 S20` in turns of the spindle.
fn dwell(line: &mut Line<'_>) {
    let turns = line.draft.speed.take().zip(line.machine.state.speed);
    let seconds = line.draft.feed.take().or(turns.map(|(turns, speed)| turns / speed * 60.0));
    line.draft.dwell = seconds;
    if seconds.is_none() {
        line.fault(0, "dwell without its time");
    }
}

/// `CR=5`, `AR=90`, `TURN=2`.
fn assigned(line: &mut Line<'_>, name: &[u8]) -> bool {
    line.at.at += 1;
    let Some((number, _)) = value(&mut line.at) else { return false };
    if name.eq_ignore_ascii_case(b"CR") {
        line.draft.radius = Some(number.value);
    } else if name.eq_ignore_ascii_case(b"AR") {
        line.draft.sweep = Some(number.value.to_radians());
    } else if name.eq_ignore_ascii_case(b"TURN") {
        line.draft.turns = whole(number).unwrap_or(u32::MAX);
    } else {
        return false;
    }
    true
}

/// The length with which a condition compares that of the tool, `$P_TOOLL[1]`.
fn compared(condition: &[u8]) -> Option<f64> {
    let compares = condition.windows(7).any(|word| word == b"P_TOOLL");
    let minus = condition.iter().position(|byte| *byte == b'-')?;
    let number = Cursor::new(&condition[minus + 1..]).number();
    number.map(|number| number.value).filter(|_| compares)
}

/// A number, or one in `AC( )` or `IC( )`.
fn value(at: &mut Cursor<'_>) -> Option<(Number, Counts)> {
    at.blanks();
    if !at.peek()?.is_ascii_alphabetic() {
        return at.number().map(|number| (number, Counts::AsInForce));
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
fn tool_name(line: &mut Line<'_>) -> bool {
    line.at.at += 1;
    let rest = line.at.rest();
    let Some(end) = rest.iter().position(|byte| *byte == b'"') else { return false };
    let name = String::from_utf8_lossy(&rest[..end]);
    line.at.at += end + 1;
    line.draft.speaks();
    let known = line.vocabulary.tools.iter().find(|(known, _)| *known == name);
    line.draft.tool = known.map(|(_, number)| *number).or(name.parse().ok());
    line.draft.tool.is_some()
}
