//! Conversational programs of a Heidenhain control.
//!
//! Every line has a number, one more than the line before; one that ends in `~` goes on in the next. Only words, F and the
//! radius correction stay in force: a line begins with L, C, CR or CP. `FMAX` and M codes hold for one line. The tool axis
//! of TOOL CALL is the normal of the plane.
//!
//! Here is what a line begins with, `words` has those of a motion, `round` the arcs about CC, `cycles` CYCL DEF, `plane`
//! PLANE and TCPM. Functions of a statement answer whether all of it is known.

mod cycles;
mod guard;
mod plane;
mod round;
mod words;

use self::guard::Jump;
use super::block::{FeedMode, Side, WorkPlane};
use super::draft::Code;
use super::line::Line;
use super::text::{shown, whole};
use crate::program::Units;

/// What is remembered from one line to the next.
#[derive(Debug, Default)]
pub(super) struct Heidenhain {
    /// The number of the line before.
    last: Option<u64>,
    /// CC, as written.
    pole: [Option<f64>; 3],
    jump: Jump,
}

impl Heidenhain {
    /// Reads one line into its draft; `false` if it is no block.
    pub(super) fn line(&mut self, line: &mut Line<'_>) -> bool {
        if line.at.ended() {
            return false;
        }
        self.number(line);
        line.at.blanks();
        if matches!(line.at.peek(), None | Some(b';' | b'*')) {
            return true;
        }
        line.draft.speaks();
        let start = line.at;
        if !self.statement(line) && !line.in_set_up(start.rest().trim_ascii()) {
            line.fault(start.at, format!("`{}` is not known to the check", shown(start.rest())));
        }
        true
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
        if self.jump.leads_on() {
            return self.jump.over(&mut line.at);
        }
        let at = &mut line.at;
        if at.word(b"L") || at.word(b"LN") {
            line.draft.code = Some(Code::Feed);
            words::motion(line)
        } else if at.word(b"CC") {
            round::centre(line, &mut self.pole)
        } else if at.word(b"CR") || at.word(b"C") || at.word(b"CP") {
            words::motion(line) && round::close(line, &self.pole)
        } else if at.word(b"TOOL") {
            tool(line)
        } else if at.word(b"CYCL") {
            cycles::statement(line)
        } else if at.word(b"PLANE") {
            plane::statement(line)
        } else if at.word(b"FUNCTION") {
            plane::function(line)
        } else if at.word(b"BEGIN") {
            begin(line)
        } else if at.word(b"END") || at.word(b"BLK") {
            at.word(b"PGM") || at.word(b"FORM")
        } else if at.word(b"FN") {
            self.jump.function(at)
        } else if at.word(b"LBL") {
            at.blanks();
            at.number().is_some()
        } else {
            if at.word(b"STOP") {
                line.draft.stop = Some(false);
            }
            words::motion(line)
        }
    }
}

/// `BEGIN PGM NAME MM`: the unit, and what is in force before anything is said.
fn begin(line: &mut Line<'_>) -> bool {
    let draft = &mut *line.draft;
    draft.distances = Some(false);
    draft.feed_mode = Some(FeedMode::PerMinute);
    draft.side = Some(Side::None);
    draft.units = match line.at.rest().trim_ascii_end().rsplit(|byte| *byte == b' ').next() {
        Some(b"MM") => Some(Units::Millimetres),
        Some(b"INCH") => Some(Units::Inches),
        _ => None,
    };
    line.at.word(b"PGM") && draft.units.is_some()
}

/// `TOOL CALL 5 Z S8000 DL+0`, `TOOL CALL S8000`, `TOOL DEF 6`.
fn tool(line: &mut Line<'_>) -> bool {
    let (at, draft) = (&mut line.at, &mut *line.draft);
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
