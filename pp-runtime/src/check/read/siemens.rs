//! Programs of a Siemens 840D: words with and without `=`, keywords, calls.
//!
//! `D` puts the length of a cutting edge in force, `D0` none. `G4 F` waits seconds. `CYCLE8x(..)` runs where it stands,
//! `MCALL CYCLE8x(..)` at each point that follows. Guards are `IF` with a condition on the tool's length, up to `ENDIF`;
//! messages, alarms and stops stand between the two.

use super::block::{Block, CycleKind, FeedMode, Side, WorkOffset, WorkPlane, coolant};
use super::draft::{Code, Cycle, Draft, LengthCode, TiltCode, fault};
use super::frames;
use super::machine::Interpreter;
use super::text::{Cursor, Number, shown, tenths, whole};
use crate::program::{Rotation, Units};

/// Most arguments of a call that are looked at.
const ARGUMENTS: usize = 24;

/// Reads blocks of a Siemens control.
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

/// What stands in a block besides its draft.
#[derive(Debug, Default)]
struct Loose {
    dwell: bool,
    suppressed: bool,
    mcall: bool,
}

impl Siemens {
    /// Reads one line into a draft; `false` if it is no block.
    pub(super) fn line(
        &mut self,
        line: &[u8],
        machine: &Interpreter,
        draft: &mut Draft,
        block: &mut Block,
        known: &[Vec<u8>],
        tools: &[(String, u32)],
    ) -> bool {
        let mut at = Cursor::new(line);
        at.blanks();
        if matches!(at.peek(), None | Some(b'%')) {
            return false;
        }
        if self.guard {
            self.guard = !line.windows(5).any(|word| word.eq_ignore_ascii_case(b"ENDIF"));
            return false;
        }
        let mut loose = Loose::default();
        while !at.ended() {
            let start = at.at;
            if at.peek() == Some(b';') {
                break;
            }
            if at.take(b'/') && start == 0 {
                continue;
            }
            let ok = at.peek().is_some_and(|byte| byte.is_ascii_alphabetic())
                && self.item(&mut at, machine, draft, &mut loose, block, known, tools);
            if !ok {
                let word = line[start..].split(|byte| *byte == b' ').next().unwrap_or_default();
                fault(&mut block.faults, start, format!("`{}` is not known here", shown(word)));
                if at.at == start {
                    at.at += word.len().max(1);
                }
            }
        }
        if loose.dwell {
            draft.dwell =
                draft.feed.take().or(draft.speed.take().zip(machine.state.speed).map(|(s, speed)| s / speed * 60.0));
            if draft.dwell.is_none() {
                fault(&mut block.faults, 0, "a dwell without its time");
            }
        }
        draft.define = draft.define.map(|cycle| cycle.in_unit(machine.unit()));
        if loose.mcall {
            self.called = draft.define;
            draft.define = None;
            if self.called.is_some() {
                draft.define = self.called;
            }
            draft.call = false;
        } else if self.called.is_some() && draft.written != 0 && !draft.machine {
            draft.define = draft.define.or(self.called);
            draft.call = true;
        }
        true
    }

    /// A word, a keyword or a call; `false` if it is not known.
    #[expect(clippy::too_many_arguments, reason = "one call for an item, inlined")]
    #[inline]
    fn item(
        &mut self,
        at: &mut Cursor<'_>,
        machine: &Interpreter,
        draft: &mut Draft,
        loose: &mut Loose,
        block: &mut Block,
        known: &[Vec<u8>],
        tools: &[(String, u32)],
    ) -> bool {
        let start = at.at;
        let letters = at.letters();
        if letters.len() > 1 {
            at.at = start;
            return self.keyword(at, draft, loose, block, known);
        }
        let letter = letters[0].to_ascii_uppercase();
        // `C1=30`: the digits belong to the name.
        let digits = at.rest().iter().take_while(|byte| byte.is_ascii_digit()).count();
        let named = at.rest().get(digits) == Some(&b'=');
        let name_end = if named { at.at + digits } else { at.at };
        let mut name = [letter, 0, 0, 0];
        let length = if named { 1 + digits.min(3) } else { 1 };
        name[1..length].copy_from_slice(&at.rest()[..length - 1]);
        let name = &name[..length];
        at.at = name_end + usize::from(named);
        if letter == b'T' && named && at.peek() == Some(b'"') {
            return tool_name(at, draft, tools);
        }
        let Some((number, counts)) = value(at) else { return false };
        draft.groups |= 1 << 31;
        if let Some(index) = machine.axes.iter().position(|axis| axis.name == name) {
            match counts {
                Counts::AsInForce => {}
                Counts::Absolute => draft.absolute |= 1 << index,
                Counts::Incremental => draft.incremental |= 1 << index,
            }
            return once(draft.axis(index, number.value, number.negative), name, start, block);
        }
        if let [b'A' | b'B' | b'C', b'3'] = name {
            let axis = usize::from(letter - b'A');
            draft.vector[axis] = number.value;
            draft.vector_written |= 1 << axis;
            return true;
        }
        if name.len() > 1 {
            return false;
        }
        let whole_number = whole(number);
        match letter {
            b'N' => draft.number = whole_number.map(u64::from),
            b'G' => return self.g(number, start, draft, loose, block),
            b'M' => return m(number, start, draft, block) || in_set_up(&at_text(at, start), known),
            b'F' => return once(draft.feed.replace(number.value).is_none(), name, start, block),
            b'S' => return once(draft.speed.replace(number.value).is_none(), name, start, block),
            b'T' => return once(draft.tool.replace(whole_number.unwrap_or(u32::MAX)).is_none(), name, start, block),
            b'D' => {
                draft.register = whole_number;
                draft.length = Some(if number.value == 0.0 { LengthCode::Off } else { LengthCode::On });
            }
            b'I' | b'J' | b'K' => {
                let axis = usize::from(letter - b'I');
                let first = draft.centre_written & (1 << axis) == 0;
                draft.centre_written |= 1 << axis;
                draft.centre[axis] = number.value;
                if counts == Counts::Absolute {
                    draft.centre_absolute |= 1 << axis;
                }
                return once(first, name, start, block);
            }
            _ => return false,
        }
        true
    }

    fn g(&mut self, number: Number, column: usize, draft: &mut Draft, loose: &mut Loose, block: &mut Block) -> bool {
        let Some(code) = tenths(number) else { return false };
        let group = match code {
            0 => set(&mut draft.code, Code::Rapid, 0),
            10 => set(&mut draft.code, Code::Feed, 0),
            20 => set(&mut draft.code, Code::Clockwise, 0),
            30 => set(&mut draft.code, Code::CounterClockwise, 0),
            40 => {
                loose.dwell = true;
                11
            }
            90 | 600 | 640 | 6410 | 6420 | 6430 | 6440 | 6450 | 5010 | 5020 => 9,
            170 => set(&mut draft.plane, WorkPlane::Xy, 1),
            180 => set(&mut draft.plane, WorkPlane::Zx, 1),
            190 => set(&mut draft.plane, WorkPlane::Yz, 1),
            400 => set(&mut draft.side, Side::None, 5),
            410 => set(&mut draft.side, Side::Left, 5),
            420 => set(&mut draft.side, Side::Right, 5),
            530 | 1530 => {
                loose.suppressed = true;
                draft.machine = true;
                11
            }
            5000 => set(&mut draft.work_offset, WorkOffset::Code(code), 7),
            540..=570 | 5050..=5990 if code % 10 == 0 => set(&mut draft.work_offset, WorkOffset::Code(code), 7),
            700 | 7000 => set(&mut draft.units, Units::Inches, 4),
            710 | 7100 => set(&mut draft.units, Units::Millimetres, 4),
            900 => set(&mut draft.distances, false, 2),
            910 => set(&mut draft.distances, true, 2),
            930 => set(&mut draft.feed_mode, FeedMode::InverseTime, 3),
            940 => set(&mut draft.feed_mode, FeedMode::PerMinute, 3),
            950 => set(&mut draft.feed_mode, FeedMode::PerRevolution, 3),
            _ => return false,
        };
        once(draft.group(group), b"codes of one group", column, block)
    }

    /// A name of two letters or more.
    fn keyword(
        &mut self,
        at: &mut Cursor<'_>,
        draft: &mut Draft,
        loose: &mut Loose,
        block: &mut Block,
        known: &[Vec<u8>],
    ) -> bool {
        let start = at.at;
        let name = at.name();
        let is = |word: &[u8]| name.eq_ignore_ascii_case(word);
        draft.groups |= 1 << 31;
        if at.take(b'=') {
            let Some((number, _)) = value(at) else { return false };
            if is(b"CR") {
                draft.radius = Some(number.value);
            } else if is(b"AR") {
                draft.sweep = Some(number.value.to_radians());
            } else if is(b"TURN") {
                draft.turns = whole(number).unwrap_or(u32::MAX);
            } else {
                return false;
            }
            return true;
        }
        if at.peek() == Some(b'(') {
            return self.call(name, at, draft, block);
        }
        if is(b"SUPA") {
            draft.machine = true;
        } else if is(b"TRAFOOF") {
            draft.tip_control = Some(false);
        } else if is(b"TRAORI") {
            draft.tip_control = Some(true);
        } else if is(b"MCALL") {
            loose.mcall = true;
        } else if is(b"IF") {
            let condition = at.rest();
            let compares = condition.windows(7).any(|word| word == b"P_TOOLL");
            let minus = condition.iter().position(|byte| *byte == b'-').unwrap_or(condition.len());
            let mut number = Cursor::new(&condition[(minus + 1).min(condition.len())..]);
            draft.guard = number.number().map(|number| number.value).filter(|_| compares);
            self.guard = draft.guard.is_some();
            at.at += condition.len();
            return self.guard;
        } else if is(b"STOPRE") || is(b"ORIAXES") || is(b"ORIVECT") || is(b"ORIWKS") || is(b"ORIMKS") || is(b"RET") {
        } else {
            return in_set_up(&at_text(at, start), known);
        }
        true
    }

    fn call(&mut self, name: &[u8], at: &mut Cursor<'_>, draft: &mut Draft, block: &mut Block) -> bool {
        let start = at.at;
        let Some((arguments, count)) = arguments(at) else {
            fault(&mut block.faults, start, "a call that does not end");
            at.at += at.rest().len();
            return true;
        };
        let number = |index: usize| arguments.get(index).copied().flatten();
        if name.eq_ignore_ascii_case(b"CYCLE800") {
            draft.tilt = if count == 0 { Some(TiltCode::Off) } else { swivel(&arguments) };
            return draft.tilt.is_some();
        }
        let code = name.strip_prefix(b"CYCLE").or(name.strip_prefix(b"cycle"));
        match code {
            Some(b"832") => {}
            Some(code) => {
                draft.define = cycle(code, number);
                draft.call = true;
                return draft.define.is_some();
            }
            None => {
                return [&b"MSG"[..], b"FGROUP", b"SETAL", b"WRITE"].iter().any(|word| name.eq_ignore_ascii_case(word));
            }
        }
        true
    }
}

/// CYCLE81 and its kin: RTP, RFP, SDIS, DP, DPR, and what each has behind these.
fn cycle(code: &[u8], number: impl Fn(usize) -> Option<f64>) -> Option<Cycle> {
    let surface = number(1)?;
    let bottom = number(3).or_else(|| Some(surface - number(4)?.abs()))?;
    let reference = surface + number(2).unwrap_or(0.0).abs();
    let (mut dwell, mut feed) = (0.0, None);
    let kind = match code {
        b"81" => CycleKind::Drill,
        b"82" => {
            dwell = number(5).unwrap_or(0.0);
            CycleKind::Drill
        }
        b"83" => {
            // A step that grows smaller is not read here.
            let first = number(5).map(|depth| surface - depth).or(number(6).map(f64::abs))?;
            if number(7).is_some_and(|less| less != 0.0) {
                return None;
            }
            // A wait at the bottom alone, else one after each step.
            dwell = number(15).filter(|wait| *wait != 0.0).or(number(8)).unwrap_or(0.0);
            if number(11) == Some(1.0) { CycleKind::Peck(first) } else { CycleKind::ChipBreak(first) }
        }
        b"84" => {
            dwell = number(5).unwrap_or(0.0);
            CycleKind::Tap(number(8)?)
        }
        b"840" => CycleKind::Tap(number(8)? * if number(6) == Some(4.0) { -1.0 } else { 1.0 }),
        b"85" => {
            dwell = number(5).unwrap_or(0.0);
            feed = number(6);
            CycleKind::Ream
        }
        b"86" => CycleKind::Bore,
        _ => return None,
    };
    Some(Cycle { kind, reference, bottom, back_to: Some(number(0)?), dwell, feed })
}

/// CYCLE800(_FR,"_TC",_ST,_MODE,_X0,_Y0,_Z0,_A,_B,_C,_X1,_Y1,_Z1,_DIR,..) with a new plane, axis by axis.
fn swivel(arguments: &[Option<f64>; ARGUMENTS]) -> Option<TiltCode> {
    let number = |index: usize| arguments[index].unwrap_or(0.0);
    if !(number(2) as u32).is_multiple_of(10) {
        return None;
    }
    let rotation = frames::axis_by_axis(number(3) as u32, [number(7), number(8), number(9)])?;
    let vector = |first: usize| nalgebra::Vector3::new(number(first), number(first + 1), number(first + 2));
    let origin = vector(4) + rotation * vector(10);
    Some(TiltCode::On { rotation, origin, oriented: number(13) != 0.0 })
}

/// A number, or one in `AC( )`, `DC( )`, `ACP( )`, `ACN( )`, `IC( )`.
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

/// Numbers between brackets; a text or a gap is `None`. And how many there are.
fn arguments(at: &mut Cursor<'_>) -> Option<([Option<f64>; ARGUMENTS], usize)> {
    let mut list = [None; ARGUMENTS];
    let mut count = 0;
    at.take(b'(').then_some(())?;
    loop {
        at.blanks();
        match at.peek()? {
            b')' => {
                at.at += 1;
                return Some((list, count));
            }
            b',' => {
                at.at += 1;
                count += 1;
            }
            b'"' => {
                at.at += 1;
                while at.peek()? != b'"' {
                    at.at += 1;
                }
                at.at += 1;
                count = count.max(1);
            }
            _ => {
                *list.get_mut(count)? = Some(at.number()?.value);
                if count == 0 {
                    count = 1;
                    at.blanks();
                    // The first argument is counted; a comma leads to the second.
                    if at.take(b',') {
                        continue;
                    }
                }
            }
        }
    }
}

fn tool_name(at: &mut Cursor<'_>, draft: &mut Draft, tools: &[(String, u32)]) -> bool {
    at.at += 1;
    let rest = at.rest();
    let Some(end) = rest.iter().position(|byte| *byte == b'"') else { return false };
    let name = String::from_utf8_lossy(&rest[..end]);
    at.at += end + 1;
    draft.groups |= 1 << 31;
    draft.tool = tools.iter().find(|(known, _)| *known == name).map(|(_, number)| *number).or(name.parse().ok());
    draft.tool.is_some()
}

fn m(number: Number, column: usize, draft: &mut Draft, block: &mut Block) -> bool {
    let first = match whole(number).unwrap_or(u32::MAX) {
        0 => draft.stop.replace(false).is_none(),
        1 => draft.stop.replace(true).is_none(),
        2 | 17 | 30 => !std::mem::replace(&mut draft.end, true),
        3 => draft.spindle.replace(Some(Rotation::Clockwise)).is_none(),
        4 => draft.spindle.replace(Some(Rotation::CounterClockwise)).is_none(),
        5 => draft.spindle.replace(None).is_none(),
        6 => !std::mem::replace(&mut draft.change, true),
        7 => {
            draft.coolant_on |= coolant::MIST;
            true
        }
        8 => {
            draft.coolant_on |= coolant::FLOOD;
            true
        }
        9 => {
            draft.coolant_off |= coolant::FLOOD | coolant::MIST;
            true
        }
        _ => return false,
    };
    once(first, b"M codes of one group", column, block)
}

fn set<T>(place: &mut Option<T>, value: T, group: u32) -> u32 {
    *place = Some(value);
    group
}

/// Says that a word stands twice; the word itself is known.
fn once(first: bool, name: &[u8], column: usize, block: &mut Block) -> bool {
    if !first {
        fault(&mut block.faults, column, format!("two {} words", shown(name)));
    }
    true
}

fn at_text(at: &Cursor<'_>, start: usize) -> Vec<u8> {
    let mut whole = *at;
    whole.at = start;
    whole.rest()[..at.at - start].to_vec()
}

fn in_set_up(text: &[u8], known: &[Vec<u8>]) -> bool {
    known.iter().any(|word| word.eq_ignore_ascii_case(text))
}
