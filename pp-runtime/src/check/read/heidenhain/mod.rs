//! Conversational programs of a Heidenhain control.
//!
//! Every line has a number, one more than the line before; one that ends in `~` goes on in the next. Only words, F and
//! the radius correction stay in force: a line begins with L, C, CR or CP. `FMAX` and M codes hold for one line. The
//! tool axis of TOOL CALL is the normal of the plane.
//!
//! What a line begins with is in the table of the language; `words` has the words of a motion, `round` the arcs about
//! CC, `cycles` CYCL DEF, `plane` PLANE and TCPM, `guard` the length guard, `plane_guard` and `offset_guard` the
//! others. Functions of a statement answer whether all of it is known.

mod cycles;
mod guard;
mod offset_guard;
mod plane;
mod plane_guard;
mod round;
mod words;

use self::cycles::Sequence;
use self::guard::LengthGuardLines;
use self::offset_guard::OffsetGuardLines;
use self::plane_guard::PlaneGuardLines;
use super::LineLanguage;
use super::block::{BlankPart, FeedMode, SideOfPath, WorkPlane};
use super::language::{Means, StatementWord};
use super::line::Line;
use super::orders::{Act, Code, ModeOrder};
use super::text::{GOES_ON, shown, whole};
use crate::program::Units;

/// What is remembered from one line to the next.
#[derive(Debug, Default)]
pub(super) struct HeidenhainLines {
    /// CC, as written.
    pole: [Option<f64>; 3],
    guard: LengthGuardLines,
    plane_guard: PlaneGuardLines,
    offset_guard: OffsetGuardLines,
    /// A cycle of several lines.
    sequence: Sequence,
    began: bool,
    ended: bool,
}

impl LineLanguage for HeidenhainLines {
    fn line(&mut self, line: &mut Line<'_>) -> bool {
        if line.at.ended() {
            return false;
        }
        Self::number(line);
        line.at.blanks();
        self.sequence.line(line);
        line.orders.frame_faults = line.fault_count();
        let goes_on = line.at.rest().contains(&GOES_ON);
        if matches!(line.at.peek(), None | Some(b';' | b'*')) {
            if goes_on {
                line.fault(0, "a comment that goes on in the next line (~)");
            }
            return true;
        }
        line.orders.speaks = true;
        let start = line.at;
        // Only the parameters of a cycle go on in the next line, and they have been read to their end.
        if !self.statement(line) || goes_on && !line.at.ended() {
            line.unknown_text(start.column(), start.rest());
        }
        self.began = true;
        self.ended |= line.orders.acts.contains(&Act::End);
        true
    }

    fn is_in_guard(&self) -> bool {
        self.guard.is_open() || self.plane_guard.is_open() || self.offset_guard.is_open()
    }

    fn forget(&mut self) {
        (self.pole, self.sequence) = ([None; 3], Sequence::default());
    }
}

impl HeidenhainLines {
    /// The number of the line.
    fn number(line: &mut Line<'_>) {
        let Some(number) = line.at.number().and_then(whole).map(u64::from) else {
            return line.fault(0, "line without its line number");
        };
        line.orders.number = Some(number);
    }

    fn statement(&mut self, line: &mut Line<'_>) -> bool {
        if self.guard.is_open() {
            return self.guard.line(line);
        }
        if self.plane_guard.is_open() {
            return self.plane_guard.line(line);
        }
        if self.offset_guard.is_open() {
            return self.offset_guard.line(line);
        }
        let row = line.language().words.iter().find(|row| {
            matches!(row.means, Means::Statement(_)) && !row.spelling.starts_with("FN") && line.at.words(row.spelling)
        });
        let named = row.map(|row| (row.spelling, row.means));
        let Some((spelling, Means::Statement(statement))) = named else {
            let mut guards = || self.guard.line(line) || self.plane_guard.line(line) || self.offset_guard.line(line);
            return guards() || words::codes(line) && composed(line, false);
        };
        match statement {
            StatementWord::Line => {
                let Some(marks) = words::motion(line) else { return false };
                let code = if marks.rapid { Code::Rapid } else { Code::Feed };
                line.orders.mode(ModeOrder::Motion(code, 0));
                marks.sense.is_none() && composed(line, false)
            }
            StatementWord::Pole => round::centre(line, &mut self.pole),
            StatementWord::Arc => {
                let Some(marks) = words::motion(line).filter(|marks| !marks.rapid) else { return false };
                let code = marks.sense.and_then(|sense| round::close(line, spelling, sense, &self.pole));
                let Some(code) = code else { return false };
                line.orders.mode(ModeOrder::Motion(code, 0));
                composed(line, false)
            }
            StatementWord::ToolCall => tool(line),
            StatementWord::ToolDef => matches!(tool_number(line), Ok(Some(_))) && ended(line),
            StatementWord::CycleDef => cycles::define(line),
            StatementWord::CycleCall => words::codes(line) && composed(line, true),
            StatementWord::PlaneSpatial => plane::spatial(line),
            StatementWord::PlaneReset => plane::reset(line),
            StatementWord::TcpmOn => plane::tcpm(line),
            StatementWord::TcpmOff => {
                line.orders.mode(ModeOrder::TipControl(false));
                ended(line)
            }
            StatementWord::Begin => !self.began && begin(line),
            StatementWord::EndOfProgram => {
                if !self.ended {
                    line.orders.act(Act::End);
                }
                line.at.take_rest();
                true
            }
            StatementWord::Blank => blank(line),
            StatementWord::Stop => {
                line.orders.act(Act::Stop { optional: false });
                words::codes(line) && composed(line, false)
            }
            _ => false,
        }
    }
}

/// Makes orders of the words of a statement. `call`: it calls the defined cycle.
fn composed(line: &mut Line<'_>, call: bool) -> bool {
    line.compose(call);
    true
}

/// Nothing but a comment comes.
fn ended(line: &mut Line<'_>) -> bool {
    line.at.ended() || line.at.peek() == Some(b';')
}

/// `BEGIN PGM NAME MM`: the unit, and what is in force before anything is said.
fn begin(line: &mut Line<'_>) -> bool {
    let units = match line.at.take_rest().trim_ascii_end().rsplit(|byte| *byte == b' ').next() {
        Some(b"MM") => Units::Millimetres,
        Some(b"INCH") => Units::Inches,
        _ => return false,
    };
    for mode in [
        ModeOrder::Incremental(false),
        ModeOrder::FeedMode(FeedMode::PerMinute),
        ModeOrder::Side(SideOfPath::None),
        ModeOrder::Units(units),
    ] {
        line.orders.mode(mode);
    }
    true
}

/// `BLK FORM 0.1 Z X-10 Y-10 Z-10`, `BLK FORM 0.2 X+10 Y+10 Z+0`, `BLK FORM CYLINDER Z R40 L50 DIST+0`.
fn blank(line: &mut Line<'_>) -> bool {
    let part = blank_part(line).filter(|_| ended(line));
    part.into_iter().for_each(|part| line.orders.mode(ModeOrder::Blank(part)));
    part.is_some()
}

fn blank_part(line: &mut Line<'_>) -> Option<BlankPart> {
    let number = |line: &mut Line<'_>, letters: &[u8]| {
        line.at.blanks();
        let rest = line.at.rest();
        rest.starts_with(letters).then(|| line.at.skip(letters.len()))?;
        line.at.number().map(|number| number.value)
    };
    line.at.blanks();
    if line.at.word(b"CYLINDER") {
        line.at.word(b"Z").then_some(())?;
        let (radius, height) = (number(line, b"R")?, number(line, b"L")?);
        let top = number(line, b"DIST")?;
        return Some(BlankPart::cylinder(radius, top - height, top));
    }
    let corner = line.at.number()?.value;
    let first = matches!(corner, 0.1);
    if !matches!(corner, 0.1 | 0.2) || (first && !line.at.word(b"Z")) {
        return None;
    }
    let point = [number(line, b"X")?, number(line, b"Y")?, number(line, b"Z")?];
    Some(if first { BlankPart::Lower(point) } else { BlankPart::Upper(point) })
}

/// `5` or `"MILL_D12"`: number of a tool, if there is one; an error if it is unknown.
fn tool_number(line: &mut Line<'_>) -> Result<Option<u32>, ()> {
    line.at.blanks();
    let start = line.at.column();
    let named = line.at.take(b'"');
    let number = if named {
        let rest = line.at.rest();
        let end = rest.iter().position(|byte| *byte == b'"').ok_or(())?;
        line.at.skip(end + 1);
        line.tool_of(&rest[..end])
    } else if line.at.peek().is_some_and(|byte| byte.is_ascii_digit()) {
        line.at.number().and_then(whole)
    } else {
        return Ok(None);
    };
    // The empty spindle has no name.
    if number != Some(0) {
        line.called(named, start);
    }
    number.map(Some).ok_or(())
}

/// `TOOL CALL 5 Z S8000 DL+0 DR-6`, `TOOL CALL S8000 DR-6`.
fn tool(line: &mut Line<'_>) -> bool {
    let unit_mm = line.unit();
    let Ok(number) = tool_number(line) else { return false };
    if let Some(number) = number {
        line.at.blanks();
        let plane = match line.at.peek() {
            Some(b'Z') => WorkPlane::Xy,
            Some(b'Y') => WorkPlane::Zx,
            Some(b'X') => WorkPlane::Yz,
            _ => return false,
        };
        line.at.skip(1);
        for mode in [ModeOrder::Tool(number), ModeOrder::Change, ModeOrder::LengthOfTool, ModeOrder::Plane(plane)] {
            line.orders.mode(mode);
        }
        line.orders.act(Act::ToolChange);
    }
    let (mut speed, mut stated) = (None, None);
    while !ended(line) {
        let name = line.at.letters();
        let Some(word) = line.at.number() else { return false };
        let first = match name {
            b"S" => speed.replace(word.value).is_none(),
            b"DL" => word.value == 0.0,
            b"DR" => stated.replace(word.value * unit_mm).is_none(),
            _ => false,
        };
        if !first {
            return false;
        }
    }
    if speed.is_some_and(|speed| speed < 0.0) {
        line.fault(0, "S is negative");
    }
    speed.into_iter().for_each(|speed| line.orders.mode(ModeOrder::Speed(speed)));
    line.orders.mode(ModeOrder::RadiusDelta(stated.or(number.map(|_| 0.0))));
    number.is_some() || speed.is_some()
}
