//! Programs of letters and numbers: LinuxCNC, Fanuc, Haas.
//!
//! A block may hold one code of each modal group. On Fanuc and Haas a length without a decimal point counts least
//! increments (0.001 mm, 0.0001 in, 0.001 degree), unless the set-up says that the control reads them plainly; Haas reads
//! an F without one by a setting, so that it is refused here.
//! A dwell is P in seconds on LinuxCNC, and milliseconds on Fanuc and Haas where P has no point.
//!
//! Known besides blocks: `%`, `O1234`, comments, `/`, and guards: `o1 if [..]` with nothing in it but messages, and on
//! Fanuc and Haas `IF [..] GOTO n` over an alarm `#3000 = ..` to the block `Nn`.

use super::block::{CycleKind, FeedMode, Side, WorkOffset, WorkPlane, coolant};
use super::draft::{Code, Cycle, Draft, LengthCode, TiltCode, fault};
use super::machine::Interpreter;
use super::text::{Cursor, Number, shown, tenths, whole};
use super::{Family, frames};
use crate::check::read::block::Block;
use crate::program::{Rotation, Units};

/// Where a cycle word counts least increments, in mm and degrees.
const LEAST: f64 = 1e-3;
const LEAST_INCH: f64 = 1e-4;

/// Reads blocks of letters and numbers.
#[derive(Debug)]
pub(super) struct Iso {
    family: Family,
    /// Numbers mean the same with and without a decimal point.
    plain: bool,
    /// The label of a guard that is open.
    guard: Option<u32>,
    /// A jump over an alarm, and where it leads.
    jump: Option<u32>,
    tilt: frames::EulerWords,
    cycle: CycleWords,
    /// I J K are the tool axis.
    vectors: bool,
}

/// Words of a cycle that stay in force.
#[derive(Debug, Clone, Copy, Default)]
struct CycleWords {
    /// The code, 0 for none.
    code: u32,
    reference: Option<f64>,
    bottom: Option<f64>,
    step: Option<f64>,
    dwell: f64,
}

/// Words of a block that mean different things in different blocks.
#[derive(Debug, Clone, Copy, Default)]
struct Loose {
    p: Option<Number>,
    q: Option<Number>,
    r: Option<Number>,
    l: Option<Number>,
    x: Option<Number>,
    k: Option<Number>,
    cycle: Option<u32>,
    tilt: Option<u32>,
    dwell: bool,
    offset_with_p: bool,
    sync: bool,
    smoothing: bool,
}

/// Modal groups, as bits of a draft.
mod group {
    pub(super) const MOTION: u32 = 0;
    pub(super) const PLANE: u32 = 1;
    pub(super) const DISTANCE: u32 = 2;
    pub(super) const FEED: u32 = 3;
    pub(super) const UNITS: u32 = 4;
    pub(super) const SIDE: u32 = 5;
    pub(super) const LENGTH: u32 = 6;
    pub(super) const OFFSET: u32 = 7;
    pub(super) const RETURN: u32 = 8;
    pub(super) const PATH: u32 = 9;
    pub(super) const TILT: u32 = 10;
    pub(super) const ALONE: u32 = 11;
    pub(super) const STOP: u32 = 12;
    pub(super) const SPINDLE: u32 = 13;
    pub(super) const CENTRE: u32 = 14;
    pub(super) const WORDS: u32 = 15;
    pub(super) const COOLANT: u32 = 16;
}

impl Iso {
    pub(super) fn new(family: Family, plain: bool) -> Self {
        Self {
            family,
            plain: plain || family == Family::LinuxCnc,
            guard: None,
            jump: None,
            tilt: frames::EulerWords::default(),
            cycle: CycleWords::default(),
            vectors: false,
        }
    }

    /// Reads one line into a draft; `false` if the line is no block of words.
    pub(super) fn line(
        &mut self,
        line: &[u8],
        machine: &Interpreter,
        draft: &mut Draft,
        block: &mut Block,
        known: &[Vec<u8>],
    ) -> bool {
        let mut at = Cursor::new(line);
        at.blanks();
        match at.peek() {
            None | Some(b'%') => return false,
            Some(b'O' | b'o') => return self.o_word(at, draft, block),
            Some(b'I' | b'i') if line.len() > at.at + 1 && line[at.at + 1].eq_ignore_ascii_case(&b'F') => {
                return self.fanuc_guard(at, draft, block);
            }
            Some(b'#') => {
                self.alarm(at, block);
                return false;
            }
            _ => {}
        }
        let mut loose = Loose::default();
        while !at.ended() {
            let start = at.at;
            match at.peek() {
                Some(b'(') => comment(&mut at, block),
                Some(b';') => break,
                Some(b'/') if start == 0 => at.at += 1,
                Some(letter) if letter.is_ascii_alphabetic() => {
                    at.at += 1;
                    at.blanks();
                    match at.number() {
                        Some(number) => {
                            let text = &line[start..at.at];
                            self.word(
                                letter.to_ascii_uppercase(),
                                number,
                                text,
                                start,
                                machine,
                                draft,
                                &mut loose,
                                block,
                                known,
                            );
                        }
                        None => {
                            fault(&mut block.faults, start, format!("`{}` is no word", shown(&line[start..])));
                            return true;
                        }
                    }
                }
                _ => {
                    fault(&mut block.faults, start, format!("`{}` is no word", shown(&line[start..])));
                    return true;
                }
            }
        }
        if self.guard.is_some() && (draft.groups != 0 || draft.written != 0) {
            fault(&mut block.faults, 0, "a block that runs only where a guard lets it");
        }
        self.conclude(machine, draft, &loose, block);
        true
    }

    /// `O1234 (NAME)` and the guards of LinuxCNC.
    fn o_word(&mut self, mut at: Cursor<'_>, draft: &mut Draft, block: &mut Block) -> bool {
        at.at += 1;
        let Some(label) = at.number().and_then(whole) else {
            fault(&mut block.faults, 0, "an O word without a number");
            return false;
        };
        if at.ended() || at.peek() == Some(b'(') {
            if self.family == Family::LinuxCnc && at.ended() {
                fault(&mut block.faults, 0, "an O word that does nothing");
            }
            return false;
        }
        if at.word(b"if") && self.guard.is_none() {
            self.guard = Some(label);
            match guarded(at.rest()) {
                Some(length) => draft.guard = Some(length),
                None => fault(&mut block.faults, at.at, "a condition that is not known here"),
            }
            block.guard = draft.guard;
        } else if at.word(b"endif") && self.guard == Some(label) && at.ended() {
            self.guard = None;
        } else {
            fault(&mut block.faults, 0, format!("`{}` is not known here", shown(at.rest())));
        }
        draft.guard.is_some()
    }

    /// `IF [ABS[#..-101.5] GT 0.01] THEN #3000=1 (..)`, and `IF [ABS[#..-101.5] LT 0.01] GOTO 5` over such an alarm.
    fn fanuc_guard(&mut self, mut at: Cursor<'_>, draft: &mut Draft, block: &mut Block) -> bool {
        at.at += 2;
        let rest = at.rest();
        let goto = rest.windows(4).rposition(|word| word.eq_ignore_ascii_case(b"GOTO"));
        let target = goto.and_then(|goto| {
            let mut at = Cursor::new(&rest[goto + 4..]);
            at.blanks();
            at.number().and_then(whole)
        });
        let then = rest.windows(4).position(|word| word.eq_ignore_ascii_case(b"THEN"));
        if let Some(then) = then {
            let mut at = Cursor::new(&rest[then + 4..]);
            at.blanks();
            let alarm = at.take(b'#') && at.number().and_then(whole) == Some(3000) && at.take(b'=');
            match guarded(&rest[..then]).filter(|_| alarm && self.family != Family::LinuxCnc) {
                Some(length) => draft.guard = Some(length),
                None => fault(&mut block.faults, 0, "a condition that is not known here"),
            }
            return true;
        }
        match (target, guarded(rest)) {
            (Some(target), Some(length)) if self.family != Family::LinuxCnc => {
                self.jump = Some(target);
                draft.guard = Some(length);
            }
            _ => fault(&mut block.faults, 0, "a condition that is not known here"),
        }
        true
    }

    /// `#3000 = 1 (TEXT)`: only a guard jumps over it.
    fn alarm(&mut self, mut at: Cursor<'_>, block: &mut Block) {
        at.at += 1;
        let is_alarm = at.number().and_then(whole) == Some(3000);
        if !is_alarm || self.jump.is_none() {
            fault(&mut block.faults, 0, "a variable is set, or an alarm is raised, whatever happens");
        }
    }

    #[expect(clippy::too_many_arguments, reason = "one call for a word, inlined")]
    #[inline]
    fn word(
        &mut self,
        letter: u8,
        number: Number,
        text: &[u8],
        column: usize,
        machine: &Interpreter,
        draft: &mut Draft,
        loose: &mut Loose,
        block: &mut Block,
        known: &[Vec<u8>],
    ) {
        let mut bad = |text: String| fault(&mut block.faults, column, text);
        let twice = match letter {
            b'N' => {
                let number = whole(number).map(u64::from);
                if self.jump.map(u64::from) == number {
                    self.jump = None;
                }
                draft.number.replace(number.unwrap_or_default()).is_some()
            }
            b'G' => return self.g(number, text, column, draft, loose, block, known),
            b'M' => return self.m(number, text, column, draft, block, known),
            b'X' | b'Y' | b'Z' | b'A' | b'B' | b'C' | b'U' | b'V' | b'W' => {
                let Some(index) = machine.axes.iter().position(|axis| axis.name == [letter]) else {
                    return bad(format!("the machine has no axis {}", char::from(letter)));
                };
                if letter == b'X' {
                    loose.x = Some(number);
                }
                let value = self.length(number, machine, draft, machine.axes[index].rotary);
                !draft.axis(index, value, number.negative)
            }
            b'I' | b'J' | b'K' => {
                let axis = usize::from(letter - b'I');
                let bit = 1 << axis;
                let twice = draft.centre_written & bit != 0;
                draft.centre_written |= bit;
                draft.centre[axis] = self.length(number, machine, draft, false);
                if letter == b'K' {
                    loose.k = Some(number);
                }
                twice
            }
            b'F' => {
                if self.family == Family::Haas && !number.point && !self.plain {
                    bad("F without a decimal point means what a setting says".to_owned());
                }
                draft.feed.replace(number.value).is_some()
            }
            b'S' => draft.speed.replace(number.value).is_some(),
            b'T' => draft.tool.replace(whole(number).unwrap_or(u32::MAX)).is_some(),
            b'H' => draft.register.replace(whole(number).unwrap_or(u32::MAX)).is_some(),
            b'D' => draft.diameter.replace(whole(number).unwrap_or(u32::MAX)).is_some(),
            b'P' => loose.p.replace(number).is_some(),
            b'Q' => loose.q.replace(number).is_some(),
            b'R' => loose.r.replace(number).is_some(),
            b'L' => loose.l.replace(number).is_some(),
            b'E' if self.family == Family::Haas => false,
            _ => return unknown(text, column, block, known),
        };
        if twice {
            bad(format!("two {} words", char::from(letter)));
        }
        draft.groups |= 1 << group::WORDS;
    }

    /// A length or an angle as written: least increments where there is no point.
    fn length(&self, number: Number, machine: &Interpreter, draft: &Draft, rotary: bool) -> f64 {
        if number.point || self.plain {
            return number.value;
        }
        let inches = draft.units.or(machine.state.units) == Some(Units::Inches);
        number.value * if inches && !rotary { LEAST_INCH } else { LEAST }
    }

    #[expect(clippy::too_many_arguments, reason = "one call for a code, inlined")]
    fn g(
        &mut self,
        number: Number,
        text: &[u8],
        column: usize,
        draft: &mut Draft,
        loose: &mut Loose,
        block: &mut Block,
        known: &[Vec<u8>],
    ) {
        let Some(code) = tenths(number) else { return unknown(text, column, block, known) };
        let haas = self.family == Family::Haas;
        let group = match code {
            0 => set(&mut draft.code, Code::Rapid, group::MOTION),
            10 => set(&mut draft.code, Code::Feed, group::MOTION),
            20 => set(&mut draft.code, Code::Clockwise, group::MOTION),
            30 => set(&mut draft.code, Code::CounterClockwise, group::MOTION),
            331 if self.family == Family::LinuxCnc => {
                loose.sync = true;
                set(&mut draft.code, Code::RigidTap, group::MOTION)
            }
            800 => set(&mut draft.code, Code::None, group::MOTION),
            730 | 740 | 760 | 810..=890 if code % 10 == 0 => {
                loose.cycle = Some(code / 10);
                set(&mut draft.code, Code::Cycle, group::MOTION)
            }
            40 => {
                loose.dwell = true;
                group::ALONE
            }
            170 => set(&mut draft.plane, WorkPlane::Xy, group::PLANE),
            180 => set(&mut draft.plane, WorkPlane::Zx, group::PLANE),
            190 => set(&mut draft.plane, WorkPlane::Yz, group::PLANE),
            200 => set(&mut draft.units, Units::Inches, group::UNITS),
            210 => set(&mut draft.units, Units::Millimetres, group::UNITS),
            280 | 300 => {
                draft.reference = true;
                group::ALONE
            }
            400 => set(&mut draft.side, Side::None, group::SIDE),
            410 => set(&mut draft.side, Side::Left, group::SIDE),
            420 => set(&mut draft.side, Side::Right, group::SIDE),
            430 => set(&mut draft.length, LengthCode::On, group::LENGTH),
            434 if self.family == Family::Fanuc => set(&mut draft.length, LengthCode::TipControl, group::LENGTH),
            435 if self.family == Family::Fanuc => set(&mut draft.length, LengthCode::TipVector, group::LENGTH),
            2340 if haas => set(&mut draft.length, LengthCode::TipControl, group::LENGTH),
            490 => set(&mut draft.length, LengthCode::Off, group::LENGTH),
            530 => {
                draft.machine = true;
                group::ALONE
            }
            531 if self.family != Family::Haas => set(&mut draft.tilt, TiltCode::Orient, group::TILT),
            2530 if haas => set(&mut draft.tilt, TiltCode::Orient, group::TILT),
            690 | 2690 => set(&mut draft.tilt, TiltCode::Off, group::TILT),
            682 if !haas => set(&mut loose.tilt, 682, group::TILT),
            2680 if haas => set(&mut loose.tilt, 2680, group::TILT),
            541 | 1540 if self.family != Family::LinuxCnc => {
                loose.offset_with_p = true;
                group::OFFSET
            }
            540 | 550 | 560 | 570 | 580 | 590 => set(&mut draft.work_offset, WorkOffset::Code(code), group::OFFSET),
            591..=593 if self.family == Family::LinuxCnc => {
                set(&mut draft.work_offset, WorkOffset::Code(code), group::OFFSET)
            }
            610 | 611 | 640 => {
                loose.smoothing = true;
                group::PATH
            }
            50 | 51 | 80 | 1870 if self.family != Family::LinuxCnc => {
                loose.smoothing = true;
                group::PATH
            }
            900 => set(&mut draft.distances, false, group::DISTANCE),
            910 => set(&mut draft.distances, true, group::DISTANCE),
            901 | 911 if self.family == Family::LinuxCnc => {
                draft.centre_absolute = if code == 901 { 7 } else { 0 };
                group::CENTRE
            }
            930 => set(&mut draft.feed_mode, FeedMode::InverseTime, group::FEED),
            940 => set(&mut draft.feed_mode, FeedMode::PerMinute, group::FEED),
            950 => set(&mut draft.feed_mode, FeedMode::PerRevolution, group::FEED),
            980 => set(&mut draft.to_initial, true, group::RETURN),
            990 => set(&mut draft.to_initial, false, group::RETURN),
            _ => return unknown(text, column, block, known),
        };
        if !draft.group(group) {
            fault(&mut block.faults, column, format!("`{}` beside another code of its group", shown(text)));
        }
    }

    fn m(
        &mut self,
        number: Number,
        text: &[u8],
        column: usize,
        draft: &mut Draft,
        block: &mut Block,
        known: &[Vec<u8>],
    ) {
        let group = match whole(number).unwrap_or(u32::MAX) {
            0 => set(&mut draft.stop, false, group::STOP),
            1 => set(&mut draft.stop, true, group::STOP),
            2 | 30 => {
                draft.end = true;
                group::STOP
            }
            3 => set(&mut draft.spindle, Some(Rotation::Clockwise), group::SPINDLE),
            4 => set(&mut draft.spindle, Some(Rotation::CounterClockwise), group::SPINDLE),
            5 => set(&mut draft.spindle, None, group::SPINDLE),
            6 => {
                draft.change = true;
                group::WORDS
            }
            7 if self.family != Family::Haas => switch(&mut draft.coolant_on, coolant::MIST),
            8 => switch(&mut draft.coolant_on, coolant::FLOOD),
            9 => switch(&mut draft.coolant_off, coolant::FLOOD | coolant::MIST),
            88 if self.family == Family::Haas => switch(&mut draft.coolant_on, coolant::THROUGH),
            89 if self.family == Family::Haas => switch(&mut draft.coolant_off, coolant::THROUGH),
            13 | 14 if self.family == Family::Fanuc => {
                let clockwise = number.value < 13.5;
                draft.coolant_on |= coolant::FLOOD;
                let turning = if clockwise { Rotation::Clockwise } else { Rotation::CounterClockwise };
                set(&mut draft.spindle, Some(turning), group::SPINDLE)
            }
            // The thread that follows is in step with the spindle.
            29 if self.family == Family::Fanuc => group::WORDS,
            428 if self.family == Family::LinuxCnc => set(&mut draft.tip_control, true, group::TILT),
            429 if self.family == Family::LinuxCnc => set(&mut draft.tip_control, false, group::TILT),
            _ => return unknown(text, column, block, known),
        };
        let first = draft.group(group);
        if !first && group != group::WORDS && group != group::COOLANT {
            fault(&mut block.faults, column, format!("`{}` beside another code of its group", shown(text)));
        }
    }

    /// What the loose words belong to.
    fn conclude(&mut self, machine: &Interpreter, draft: &mut Draft, loose: &Loose, block: &mut Block) {
        let mut left = *loose;
        if loose.dwell {
            let word = left.p.take().or(left.x.take());
            draft.written = 0;
            draft.dwell = word.map(|word| {
                let milliseconds = self.family != Family::LinuxCnc && !word.point;
                if milliseconds { word.value / 1000.0 } else { word.value }
            });
            if draft.dwell.is_none() {
                fault(&mut block.faults, 0, "a dwell without its time");
            }
        }
        if loose.offset_with_p {
            match left.p.take().and_then(whole) {
                Some(number) => draft.work_offset = Some(WorkOffset::Further(number)),
                None => fault(&mut block.faults, 0, "a work offset without its number"),
            }
        }
        if loose.smoothing {
            left.p = None;
            left.q = None;
        }
        let tips = matches!(draft.length, Some(LengthCode::TipControl | LengthCode::TipVector));
        if tips && self.family == Family::Fanuc {
            // P0 and P1: how the rotary axes move between two points.
            left.p = None;
        }
        self.vectors |= draft.length == Some(LengthCode::TipVector);
        self.vectors &= !matches!(draft.length, Some(LengthCode::Off | LengthCode::On | LengthCode::TipControl));
        if self.vectors && draft.centre_written != 0 {
            draft.vector = draft.centre;
            draft.vector_written = draft.centre_written;
            draft.centre_written = 0;
        }
        if loose.sync {
            draft.pitch = left.k.map(|k| k.value);
            draft.centre_written = 0;
        }
        if loose.tilt.is_some() {
            self.tilted(machine, draft, &mut left, block);
        }
        self.cycle_words(machine, draft, &mut left, block);
        if let Some(r) = left.r.take() {
            draft.radius = Some(self.length(r, machine, draft, false));
        }
        if draft.centre_written != 0
            && let Some(turns) = left.p.take().or(left.l.take())
        {
            draft.turns = whole(turns).unwrap_or(1).saturating_sub(1);
        }
        let unused = [(left.p, 'P'), (left.q, 'Q'), (left.l, 'L')];
        for (_, letter) in unused.iter().filter(|(word, _)| word.is_some()) {
            fault(&mut block.faults, 0, format!("{letter} has no business in this block"));
        }
        self.forms(draft, machine, block);
    }

    /// Words that need another word beside them.
    fn forms(&self, draft: &Draft, machine: &Interpreter, block: &mut Block) {
        if draft.change && draft.tool.is_none() && machine.state.selected.is_none() {
            fault(&mut block.faults, 0, "a tool change without a tool");
        }
        if draft.tool.is_some() && !draft.change && self.family == Family::LinuxCnc && draft.written != 0 {
            fault(&mut block.faults, 0, "a tool is called up in a block that moves");
        }
    }

    /// G68.2 and G268: the words are those of the plane.
    fn tilted(&mut self, machine: &Interpreter, draft: &mut Draft, left: &mut Loose, block: &mut Block) {
        let words = &mut self.tilt;
        *words = frames::EulerWords::default();
        for (axis, place) in machine.linear.iter().enumerate() {
            words.origin[axis] =
                place.filter(|index| draft.written & (1 << index) != 0).map_or(0.0, |index| draft.axes[index]);
        }
        words.angles = draft.centre;
        words.order = left.q.take().and_then(whole);
        draft.written = 0;
        draft.centre_written = 0;
        match if self.family == Family::Haas { words.haas() } else { words.euler() } {
            Some(rotation) => {
                let origin = words.origin.into();
                draft.tilt = Some(TiltCode::On { rotation, origin, oriented: false });
            }
            None => fault(&mut block.faults, 0, "a tilted plane in a form that is not known here"),
        }
    }

    /// Words of a canned cycle, in the block that begins it or in a later one.
    fn cycle_words(&mut self, machine: &Interpreter, draft: &mut Draft, left: &mut Loose, block: &mut Block) {
        if draft.code.is_some() && draft.code != Some(Code::Cycle) {
            self.cycle.code = 0;
        }
        if let Some(code) = left.cycle {
            self.cycle = CycleWords { code, ..CycleWords::default() };
        }
        if self.cycle.code == 0 || (left.cycle.is_none() && draft.written == 0 && left.r.is_none()) {
            return;
        }
        let unit = draft.units.map_or(machine.unit(), |units| units.in_mm());
        let words = &mut self.cycle;
        let plane = draft.plane.or(machine.state.plane);
        let normal = plane.and_then(|plane| machine.linear[plane.axes()[2]]);
        let incremental = draft.distances.or(machine.state.incremental) == Some(true);
        let start = normal.and_then(|index| machine.at(index));
        let family = self.family;
        let length = |number: Number| {
            let least = if unit > 2.0 { LEAST_INCH } else { LEAST };
            unit * if number.point || family == Family::LinuxCnc { number.value } else { number.value * least }
        };
        if let Some(r) = left.r.take() {
            let r = length(r);
            words.reference = Some(if incremental { start.unwrap_or_default() + r } else { r });
        }
        if let Some(index) = normal.filter(|index| draft.written & (1 << index) != 0) {
            let z = draft.axes[index] * unit;
            words.bottom = Some(if incremental { words.reference.unwrap_or_default() + z } else { z });
        }
        if let Some(q) = left.q.take() {
            words.step = Some(length(q));
        }
        if let Some(p) = left.p.take() {
            words.dwell = if family != Family::LinuxCnc && !p.point { p.value / 1000.0 } else { p.value };
        }
        left.l = None;
        let feed = draft.feed.or(machine.state.feed).unwrap_or(0.0);
        let speed = draft.speed.or(machine.state.speed).unwrap_or(0.0);
        let per_turn = match draft.feed_mode.or(machine.state.feed_mode) {
            Some(FeedMode::PerRevolution) => feed,
            _ => feed / speed,
        };
        let kind = match (words.code, words.step) {
            (81 | 82, _) => Some(CycleKind::Drill),
            (85 | 89, _) => Some(CycleKind::Ream),
            (83, Some(step)) => Some(CycleKind::Peck(step)),
            (73, Some(step)) => Some(CycleKind::ChipBreak(step)),
            (84, _) => Some(CycleKind::Tap(per_turn * unit)),
            (74, _) => Some(CycleKind::Tap(-per_turn * unit)),
            (76 | 86 | 88, _) => Some(CycleKind::Bore),
            _ => None,
        };
        match (kind, words.reference, words.bottom) {
            (Some(kind), Some(reference), Some(bottom)) => {
                draft.define = Some(Cycle { kind, reference, bottom, back_to: None, dwell: words.dwell, feed: None });
            }
            _ => fault(&mut block.faults, 0, "a cycle without the words it needs, or not known here"),
        }
    }
}

fn set<T>(place: &mut Option<T>, value: T, group: u32) -> u32 {
    *place = Some(value);
    group
}

fn switch(bits: &mut u8, bit: u8) -> u32 {
    *bits |= bit;
    group::COOLANT
}

/// A word that is not known, unless the set-up has brought it in.
fn unknown(text: &[u8], column: usize, block: &mut Block, known: &[Vec<u8>]) {
    if !known.iter().any(|word| word.eq_ignore_ascii_case(text)) {
        fault(&mut block.faults, column, format!("`{}` is not known here", shown(text)));
    }
}

/// `( .. )`, without another bracket in it.
fn comment(at: &mut Cursor<'_>, block: &mut Block) {
    let start = at.at;
    let rest = &at.rest()[1..];
    match rest.iter().position(|byte| *byte == b')') {
        Some(end) if !rest[..end].contains(&b'(') => at.at += end + 2,
        _ => {
            fault(&mut block.faults, start, "a comment that does not end, or holds a bracket");
            at.at += rest.len() + 1;
        }
    }
}

/// The length that a condition compares with: the number behind the first `-`.
fn guarded(condition: &[u8]) -> Option<f64> {
    let minus = condition.iter().position(|byte| *byte == b'-')?;
    let mut at = Cursor::new(&condition[minus + 1..]);
    at.blanks();
    at.number().map(|number| number.value)
}
