//! Conversational programs of a Heidenhain control.
//!
//! Every line has a number, one more than the line before; one that ends in `~` goes on in the next. Only words, F and the
//! radius correction stay in force: a line begins with L, C, CR or CP. `FMAX` and M codes hold for one line. The tool axis
//! of TOOL CALL is the normal of the plane.
//!
//! What a line begins with is in the table of the language; `words` has the words of a motion, `round` the arcs about CC,
//! `cycles` CYCL DEF, `plane` PLANE and TCPM, `guard` the length guard. Functions of a statement answer whether all of it is
//! known.

mod cycles;
mod guard;
mod plane;
mod plane_guard;
mod round;
mod words;

use self::cycles::Sequence;
use self::guard::LengthGuard;
use self::plane_guard::PlaneGuardLines;
use super::block::{BlankPart, FeedMode, Side, WorkPlane};
use super::draft::Code;
use super::language::{Means, Statement};
use super::line::Line;
use super::text::{GOES_ON, shown, whole};
use crate::program::Units;

/// What is remembered from one line to the next.
#[derive(Debug, Default)]
pub(super) struct Heidenhain {
    /// The number of the line before.
    last: Option<u64>,
    /// CC, as written.
    pole: [Option<f64>; 3],
    guard: LengthGuard,
    plane_guard: PlaneGuardLines,
    /// A cycle of several lines.
    sequence: Sequence,
    began: bool,
    ended: bool,
}

impl Heidenhain {
    /// Reads one line into its draft; `false` if it is no block.
    pub(super) fn line(&mut self, line: &mut Line<'_>) -> bool {
        if line.at.ended() {
            return false;
        }
        self.number(line);
        line.at.blanks();
        self.sequence.line(line);
        line.draft.frame_faults = line.fault_count();
        let goes_on = line.at.rest().contains(&GOES_ON);
        if matches!(line.at.peek(), None | Some(b';' | b'*')) {
            if goes_on {
                line.fault(0, "a comment that goes on in the next line (~)");
            }
            return true;
        }
        line.draft.speaks();
        let start = line.at;
        // Only the parameters of a cycle go on in the next line, and they have been read to their end.
        if !self.statement(line) || goes_on && !line.at.ended() {
            line.fault(start.column(), format!("`{}` is not known to the check", shown(start.rest())));
        }
        line.contradictions();
        self.began = true;
        self.ended |= line.draft.end;
        true
    }

    /// The line before belongs to a guard that has not ended.
    pub(super) fn is_in_guard(&self) -> bool {
        self.guard.is_open() || self.plane_guard.is_open()
    }

    /// Forgets what stays in force.
    pub(super) fn forget(&mut self) {
        (self.pole, self.sequence) = ([None; 3], Sequence::default());
    }

    /// The number of the line.
    fn number(&mut self, line: &mut Line<'_>) {
        let Some(number) = line.at.number().and_then(whole).map(u64::from) else {
            return line.fault(0, "line without its line number");
        };
        if self.last.is_some_and(|last| last + 1 != number) {
            line.fault(0, "the line number does not follow that of the previous line");
        }
        self.last = Some(number);
        line.draft.number = Some(number);
    }

    fn statement(&mut self, line: &mut Line<'_>) -> bool {
        if self.guard.is_open() {
            return self.guard.line(line);
        }
        if self.plane_guard.is_open() {
            return self.plane_guard.line(line);
        }
        let row = line.language().words.iter().find(|row| {
            matches!(row.means, Means::Statement(_)) && !row.spelling.starts_with("FN") && line.at.words(row.spelling)
        });
        let named = row.map(|row| (row.spelling, row.means));
        let Some((spelling, Means::Statement(statement))) = named else {
            return self.guard.line(line) || self.plane_guard.line(line) || words::codes(line);
        };
        match statement {
            Statement::Line => {
                line.draft.code = Some(Code::Feed);
                words::motion(line) && line.draft.pitch.is_none()
            }
            Statement::Pole => round::centre(line, &mut self.pole),
            Statement::Arc => words::motion(line) && round::close(line, spelling, &self.pole),
            Statement::ToolCall => tool(line),
            Statement::ToolDef => matches!(tool_number(line), Ok(Some(_))) && ended(line),
            Statement::CycleDef => cycles::define(line),
            Statement::CycleCall => {
                line.draft.call = true;
                words::codes(line)
            }
            Statement::PlaneSpatial => plane::spatial(line),
            Statement::PlaneReset => plane::reset(line),
            Statement::TcpmOn => plane::tcpm(line),
            Statement::TcpmOff => {
                line.draft.tip_control = Some(false);
                ended(line)
            }
            Statement::Begin => !self.began && begin(line),
            Statement::EndOfProgram => {
                line.draft.end = !self.ended;
                line.at.take_rest();
                true
            }
            Statement::Blank => blank(line),
            Statement::Stop => {
                line.draft.stop = Some(false);
                words::codes(line)
            }
            _ => false,
        }
    }
}

/// Nothing but a comment comes.
fn ended(line: &mut Line<'_>) -> bool {
    line.at.ended() || line.at.peek() == Some(b';')
}

/// `BEGIN PGM NAME MM`: the unit, and what is in force before anything is said.
fn begin(line: &mut Line<'_>) -> bool {
    let draft = &mut *line.draft;
    draft.distances = Some(false);
    draft.feed_mode = Some(FeedMode::PerMinute);
    draft.side = Some(Side::None);
    draft.units = match line.at.take_rest().trim_ascii_end().rsplit(|byte| *byte == b' ').next() {
        Some(b"MM") => Some(Units::Millimetres),
        Some(b"INCH") => Some(Units::Inches),
        _ => None,
    };
    draft.units.is_some()
}

/// `BLK FORM 0.1 Z X-10 Y-10 Z-10`, `BLK FORM 0.2 X+10 Y+10 Z+0`, `BLK FORM CYLINDER Z R40 L50 DIST+0`.
fn blank(line: &mut Line<'_>) -> bool {
    line.draft.blank = blank_part(line).filter(|_| ended(line));
    line.draft.blank.is_some()
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
    line.called(named, start);
    number.map(Some).ok_or(())
}

/// `TOOL CALL 5 Z S8000 DL+0 DR-6`, `TOOL CALL S8000 DR-6`.
fn tool(line: &mut Line<'_>) -> bool {
    let unit_mm = line.unit();
    let Ok(number) = tool_number(line) else { return false };
    let (at, draft) = (&mut line.at, &mut *line.draft);
    if let Some(number) = number {
        draft.tool = Some(number);
        draft.change = true;
        draft.length_with_tool = true;
        at.blanks();
        draft.plane = match at.peek() {
            Some(b'Z') => Some(WorkPlane::Xy),
            Some(b'Y') => Some(WorkPlane::Zx),
            Some(b'X') => Some(WorkPlane::Yz),
            _ => return false,
        };
        at.skip(1);
    }
    let mut delta = draft.change.then_some(0.0);
    let mut stated = false;
    while !at.ended() && at.peek() != Some(b';') {
        let name = at.letters();
        let Some(number) = at.number() else { return false };
        let first = match name {
            b"S" => draft.speed.replace(number.value).is_none(),
            b"DL" => number.value == 0.0,
            b"DR" => {
                delta = Some(number.value * unit_mm);
                !std::mem::replace(&mut stated, true)
            }
            _ => false,
        };
        if !first {
            return false;
        }
    }
    draft.radius_delta_mm = Some(delta);
    draft.change || draft.speed.is_some()
}
