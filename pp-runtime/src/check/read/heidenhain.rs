//! Conversational programs of a Heidenhain control.
//!
//! Every line has a number, one more than the line before; one that ends in `~` goes on in the next. Only words, F and the
//! radius correction stay in force: a line begins with L, C, CR or CP. `FMAX` and M codes hold for one line. The tool axis of TOOL CALL is the normal of the plane.

use super::block::{Block, CycleKind, Side, WorkOffset, WorkPlane, coolant};
use super::draft::{Code, Cycle, Draft, TiltCode, fault};
use super::frames;
use super::machine::Interpreter;
use super::text::{Cursor, shown, whole};
use crate::program::{Rotation, Units};

/// Reads lines of a Heidenhain control.
#[derive(Debug, Default)]
pub(super) struct Heidenhain {
    /// The number of the line before.
    last: Option<u64>,
    /// CC, as written.
    pole: [Option<f64>; 3],
    /// The label where the last jump of a guard leads; only messages stand before it.
    jump: Option<Vec<u8>>,
}

impl Heidenhain {
    /// Reads one line into a draft; `false` if it is no block.
    pub(super) fn line(
        &mut self,
        line: &[u8],
        machine: &Interpreter,
        draft: &mut Draft,
        block: &mut Block,
        known: &[Vec<u8>],
    ) -> bool {
        let mut at = Cursor::new(line);
        if at.ended() {
            return false;
        }
        match at.number().and_then(whole).map(u64::from) {
            Some(number) => {
                if self.last.is_some_and(|last| last + 1 != number) {
                    fault(&mut block.faults, 0, "the number of the line does not follow that of the line before");
                }
                self.last = Some(number);
                draft.number = Some(number);
            }
            None => fault(&mut block.faults, 0, "a line without its number"),
        }
        at.blanks();
        if matches!(at.peek(), None | Some(b';' | b'*')) {
            return true;
        }
        draft.groups |= 1 << 31;
        let start = at.at;
        if !self.statement(&mut at, machine, draft, block, known) {
            let rest = line.get(start..).unwrap_or_default();
            if !known.iter().any(|word| word.eq_ignore_ascii_case(rest.trim_ascii())) {
                fault(&mut block.faults, start, format!("`{}` is not known here", shown(rest)));
            }
        }
        true
    }

    fn statement(
        &mut self,
        at: &mut Cursor<'_>,
        machine: &Interpreter,
        draft: &mut Draft,
        block: &mut Block,
        known: &[Vec<u8>],
    ) -> bool {
        if self.jump.is_some() {
            return self.jumped(at);
        }
        if at.word(b"L") || at.word(b"LN") {
            draft.code = Some(Code::Feed);
            self.words(at, machine, draft, block, known)
        } else if at.word(b"CC") {
            self.centre(at, machine)
        } else if at.word(b"CR") || at.word(b"C") || at.word(b"CP") {
            self.words(at, machine, draft, block, known) && self.close_arc(draft, machine)
        } else if at.word(b"TOOL") {
            tool(at, draft)
        } else if at.word(b"CYCL") {
            at.word(b"CALL") && call(draft) || at.word(b"DEF") && self.cycle(at, draft, machine.unit())
        } else if at.word(b"PLANE") {
            plane(at, draft)
        } else if at.word(b"FUNCTION") {
            let reset = at.word(b"RESET");
            draft.tip_control = Some(!reset);
            at.word(b"TCPM") && (reset || tcpm(at))
        } else if at.word(b"BEGIN") {
            draft.distances = Some(false);
            draft.feed_mode = Some(super::block::FeedMode::PerMinute);
            draft.side = Some(Side::None);
            begin(at, draft)
        } else if at.word(b"END") || at.word(b"BLK") {
            at.word(b"PGM") || at.word(b"FORM")
        } else if at.word(b"FN") {
            self.function(at)
        } else if at.word(b"LBL") {
            at.blanks();
            at.number().is_some()
        } else if at.word(b"STOP") {
            draft.stop = Some(false);
            self.words(at, machine, draft, block, known)
        } else {
            self.words(at, machine, draft, block, known)
        }
    }

    /// Axis words, F, R, DR and M of a line.
    fn words(
        &mut self,
        at: &mut Cursor<'_>,
        machine: &Interpreter,
        draft: &mut Draft,
        block: &mut Block,
        known: &[Vec<u8>],
    ) -> bool {
        while !at.ended() && at.peek() != Some(b';') {
            let start = at.at;
            if at.word(b"FMAX") || (at.word(b"F") && at.word(b"MAX")) {
                draft.code = Some(Code::Rapid);
                continue;
            }
            at.at = start;
            if [(&b"R0"[..], Side::None), (b"RL", Side::Left), (b"RR", Side::Right)]
                .into_iter()
                .any(|(word, side)| at.word(word) && draft.side.replace(side).is_none())
            {
                continue;
            }
            if [(&b"DR+"[..], 1.0), (b"DR-", -1.0)].into_iter().any(|(word, sign)| {
                let found = at.rest().starts_with(word);
                if found {
                    at.at += word.len();
                    draft.pitch = Some(sign);
                }
                found
            }) {
                continue;
            }
            if !self.word(at, machine, draft, block, known) {
                at.at = start;
                return false;
            }
        }
        true
    }

    fn word(
        &mut self,
        at: &mut Cursor<'_>,
        machine: &Interpreter,
        draft: &mut Draft,
        block: &mut Block,
        known: &[Vec<u8>],
    ) -> bool {
        let start = at.at;
        let mut incremental = at.peek() == Some(b'I');
        at.at += usize::from(incremental);
        let letters = at.letters();
        if incremental && letters.is_empty() {
            incremental = false;
        }
        let named = machine.axes.iter().position(|axis| axis.name == letters);
        let polar = letters == b"PA";
        at.blanks();
        let Some(number) = at.number() else { return false };
        if let Some(index) = named {
            let first = draft.axis(index, number.value, number.negative);
            if incremental {
                draft.incremental |= 1 << index;
            }
            if !first {
                fault(&mut block.faults, start, format!("two {} words", shown(letters)));
            }
            return true;
        }
        match letters {
            b"PA" if polar && incremental => draft.sweep = Some(number.value.to_radians()),
            b"F" => draft.feed = Some(number.value),
            b"TX" | b"TY" | b"TZ" => {
                let axis = usize::from(letters[1] - b'X');
                draft.vector[axis] = number.value;
                draft.vector_written |= 1 << axis;
            }
            b"R" => draft.radius = Some(number.value),
            b"M" => {
                let mut text = *at;
                text.at = start;
                let text = &text.rest()[..at.at - start];
                return m(number.value as u32, draft) || known.iter().any(|word| word.eq_ignore_ascii_case(text));
            }
            _ => return false,
        }
        true
    }

    /// `CC X+.. Y+..`; without words the place of the tool.
    fn centre(&mut self, at: &mut Cursor<'_>, machine: &Interpreter) -> bool {
        self.pole = [None; 3];
        while !at.ended() && at.peek() != Some(b';') {
            let incremental = at.take(b'I');
            let Some(axis) = [b'X', b'Y', b'Z'].iter().position(|letter| at.peek() == Some(*letter)) else {
                return false;
            };
            at.at += 1;
            let Some(number) = at.number() else { return false };
            let from = match (incremental, machine.linear[axis].and_then(|index| machine.at(index))) {
                (false, _) => 0.0,
                (true, Some(from)) => from / machine.unit(),
                (true, None) => return false,
            };
            self.pole[axis] = Some(from + number.value);
        }
        true
    }

    /// C and CP go round CC, CR has its radius; DR is the sense.
    fn close_arc(&self, draft: &mut Draft, machine: &Interpreter) -> bool {
        let Some(sign) = draft.pitch.take() else { return false };
        draft.code = Some(if sign > 0.0 { Code::CounterClockwise } else { Code::Clockwise });
        if draft.radius.is_some() {
            return draft.sweep.is_none();
        }
        for (axis, value) in self.pole.iter().enumerate() {
            if let Some(value) = value {
                draft.centre[axis] = *value;
                draft.centre_written |= 1 << axis;
                draft.centre_absolute |= 1 << axis;
            }
        }
        if let Some(angle) = draft.sweep {
            return self.polar_end(angle, draft, machine);
        }
        draft.centre_written != 0
    }

    /// CP: the end in the plane follows from the angle.
    fn polar_end(&self, angle: f64, draft: &mut Draft, machine: &Interpreter) -> bool {
        let Some([u, v, _]) = machine.state.plane.map(WorkPlane::axes) else { return false };
        let place = |axis: usize| machine.linear[axis].and_then(|index| machine.at(index).map(|at| (index, at)));
        let (Some((first, x)), Some((second, y))) = (place(u), place(v)) else { return false };
        let (Some(cx), Some(cy)) = (self.pole[u], self.pole[v]) else { return false };
        let unit = machine.unit();
        let (dx, dy, (sine, cosine)) = (x / unit - cx, y / unit - cy, angle.sin_cos());
        draft.axis(first, cx + dx * cosine - dy * sine, false);
        draft.axis(second, cy + dx * sine + dy * cosine, false);
        (angle > 0.0) == (draft.code == Some(Code::CounterClockwise))
    }

    /// `CYCL DEF 200 DRILLING ~ Q200=+2 ..`, and the old ones: `9.1 DWELL 0.5`.
    fn cycle(&mut self, at: &mut Cursor<'_>, draft: &mut Draft, unit: f64) -> bool {
        at.blanks();
        let Some(number) = at.number() else { return false };
        let q = Parameters { text: at.rest() };
        let tenth = (number.value * 10.0).round() as u32;
        match tenth {
            90 | 320..=322 => {}
            91 => {
                let digits = at.rest().iter().position(|byte| byte.is_ascii_digit()).unwrap_or_default();
                draft.dwell = Cursor::new(&at.rest()[digits..]).number().map(|number| number.value);
                return draft.dwell.is_some();
            }
            2470 => {
                let row = q.value(339);
                draft.work_offset = row.filter(|row| *row >= 0.0).map(|row| WorkOffset::Row(row as u32));
                draft.restart = true;
                return draft.work_offset.is_some();
            }
            _ => {
                draft.define = hole(tenth / 10, &q).map(|cycle| cycle.in_unit(unit));
                return draft.define.is_some();
            }
        }
        true
    }

    /// `FN 18: SYSREAD ..`, and a jump over a message: `FN 12: IF +Q1 LT +0.01 GOTO LBL 5`.
    fn function(&mut self, at: &mut Cursor<'_>) -> bool {
        at.blanks();
        let Some(number) = at.number().and_then(whole) else { return false };
        match number {
            0..=5 | 18 => true,
            9..=12 => self.leap(at),
            _ => false,
        }
    }

    /// `.. GOTO LBL 5`, `.. GOTO LBL "FITS1"`.
    fn leap(&mut self, at: &mut Cursor<'_>) -> bool {
        let rest = at.rest();
        let Some(label) = rest.windows(4).rposition(|word| word == b"LBL ") else { return false };
        self.jump = Some(rest[label + 4..].trim_ascii().to_vec());
        at.at += rest.len();
        true
    }

    /// What a guard jumps over: other jumps, labels, messages and a stop.
    fn jumped(&mut self, at: &mut Cursor<'_>) -> bool {
        if at.word(b"LBL") {
            if self.jump.as_deref() == Some(at.rest().trim_ascii()) {
                self.jump = None;
            }
            return true;
        }
        if at.word(b"FN") {
            at.blanks();
            return match at.number().and_then(whole) {
                Some(9..=12) => self.leap(at),
                Some(14) => true,
                _ => false,
            };
        }
        at.word(b"STOP")
    }
}

/// `Q200=+2` and its kin in the text of a cycle.
struct Parameters<'a> {
    text: &'a [u8],
}

impl Parameters<'_> {
    fn value(&self, number: u32) -> Option<f64> {
        let mut at = Cursor::new(self.text);
        while at.at < self.text.len() {
            if at.take(b'Q') && at.number().and_then(whole) == Some(number) && at.take(b'=') {
                at.blanks();
                return at.number().map(|number| number.value);
            }
            at.at += 1;
        }
        None
    }
}

/// Cycles 200 and up that make one hole.
fn hole(number: u32, q: &Parameters<'_>) -> Option<Cycle> {
    let surface = q.value(203)?;
    let depth = -q.value(201)?;
    let (reference, bottom) = (surface + q.value(200)?, surface - depth);
    let back_to = q.value(204).map_or(reference, |second| (surface + second).max(reference));
    // Steps count from the surface.
    let step = q.value(202).filter(|step| *step > 0.0 && *step < depth);
    let kind = match number {
        200 => step.map_or(CycleKind::Drill, CycleKind::Peck),
        201 => CycleKind::Ream,
        202 => CycleKind::Bore,
        203 | 205 if q.value(212).is_none_or(|less| less == 0.0) => match (step, q.value(213), q.value(257)) {
            (_, _, Some(chip)) if chip > 0.0 => CycleKind::ChipBreak(chip),
            (Some(step), Some(breaks), _) if breaks > 0.0 => CycleKind::ChipBreak(step),
            (Some(step), _, _) => CycleKind::Peck(step),
            (None, _, _) => CycleKind::Drill,
        },
        207 | 209 => CycleKind::Tap(q.value(239)?),
        _ => return None,
    };
    let dwell = q.value(211).unwrap_or(0.0);
    Some(Cycle { kind, reference, bottom, back_to: Some(back_to), dwell, feed: q.value(206) })
}

fn call(draft: &mut Draft) -> bool {
    draft.call = true;
    true
}

fn begin(at: &mut Cursor<'_>, draft: &mut Draft) -> bool {
    let rest = at.rest().trim_ascii_end();
    draft.units = match rest.rsplit(|byte| *byte == b' ').next() {
        Some(b"MM") => Some(Units::Millimetres),
        Some(b"INCH") => Some(Units::Inches),
        _ => None,
    };
    at.word(b"PGM") && draft.units.is_some()
}

/// `TOOL CALL 5 Z S8000 DL+0`, `TOOL CALL S8000`, `TOOL DEF 6`.
fn tool(at: &mut Cursor<'_>, draft: &mut Draft) -> bool {
    if at.word(b"DEF") {
        at.blanks();
        // The next tool is brought near; it does not come into the spindle.
        return at.number().and_then(whole).is_some() && at.ended();
    }
    if !at.word(b"CALL") {
        return false;
    }
    at.blanks();
    if at.peek().is_some_and(|byte| byte.is_ascii_digit()) {
        draft.tool = at.number().and_then(whole);
        draft.change = true;
        draft.length_with_tool = true;
        at.blanks();
        draft.plane = match at.peek() {
            Some(b'Z') => Some(WorkPlane::Xy),
            Some(b'Y') => Some(WorkPlane::Zx),
            Some(b'X') => Some(WorkPlane::Yz),
            _ => return false,
        };
        at.at += 1;
    }
    while !at.ended() && at.peek() != Some(b';') {
        let name = at.letters();
        let Some(number) = at.number() else { return false };
        match name {
            b"S" => draft.speed = Some(number.value),
            b"DL" | b"DR" if number.value == 0.0 => {}
            _ => return false,
        }
    }
    true
}

/// `PLANE SPATIAL SPA+45 SPB+0 SPC+90 TURN ..`, `PLANE RESET STAY`.
fn plane(at: &mut Cursor<'_>, draft: &mut Draft) -> bool {
    if at.word(b"RESET") {
        draft.tilt = Some(TiltCode::Off);
        return at.word(b"STAY") && at.ended() || at.word(b"TURN") || at.word(b"MOVE");
    }
    if !at.word(b"SPATIAL") {
        return false;
    }
    let mut angles = [None; 3];
    for (angle, name) in angles.iter_mut().zip([b"SPA", b"SPB", b"SPC"]) {
        at.blanks();
        if at.letters() != name {
            return false;
        }
        *angle = at.number().map(|number| number.value);
    }
    let [Some(a), Some(b), Some(c)] = angles else { return false };
    let oriented = at.word(b"TURN") || at.word(b"MOVE");
    let stays = !oriented && at.word(b"STAY");
    draft.tilt =
        Some(TiltCode::On { rotation: frames::spatial([a, b, c]), origin: nalgebra::Vector3::zeros(), oriented });
    (oriented || stays) && positioning(at)
}

/// How the rotary axes get there: `MB MAX FMAX SEQ- TABLE ROT`.
fn positioning(at: &mut Cursor<'_>) -> bool {
    const WORDS: [&[u8]; 11] =
        [b"MB", b"MAX", b"FMAX", b"SEQ+", b"SEQ-", b"SYM+", b"SYM-", b"TABLE", b"COORD", b"ROT", b"DIST"];
    let rest = at.rest();
    at.at += rest.len();
    let rest = rest.split(|byte| *byte == b';').next().unwrap_or_default();
    let mut words = rest.split(|byte| *byte == b' ').filter(|word| !word.is_empty());
    words.all(|word| WORDS.contains(&word))
}

/// `FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS`.
fn tcpm(at: &mut Cursor<'_>) -> bool {
    let axis = at.word(b"F") && at.word(b"TCP") && at.word(b"AXIS") && (at.word(b"POS") || at.word(b"SPAT"));
    let way = at.word(b"PATHCTRL") && (at.word(b"AXIS") || at.word(b"VECTOR"));
    axis && way && at.ended()
}

fn m(number: u32, draft: &mut Draft) -> bool {
    match number {
        0 => draft.stop = Some(false),
        1 => draft.stop = Some(true),
        2 | 30 => draft.end = true,
        3 => draft.spindle = Some(Some(Rotation::Clockwise)),
        4 => draft.spindle = Some(Some(Rotation::CounterClockwise)),
        5 => draft.spindle = Some(None),
        8 => draft.coolant_on |= coolant::FLOOD,
        9 => draft.coolant_off |= coolant::FLOOD | coolant::MIST,
        13 | 14 => {
            draft.coolant_on |= coolant::FLOOD;
            draft.spindle = Some(Some(if number == 13 { Rotation::Clockwise } else { Rotation::CounterClockwise }));
        }
        91 => draft.machine = true,
        99 => draft.call = true,
        126 => draft.shortest = Some(true),
        127 => draft.shortest = Some(false),
        128 => draft.tip_control = Some(true),
        129 => draft.tip_control = Some(false),
        _ => return false,
    }
    true
}
