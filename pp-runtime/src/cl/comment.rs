//! Comments that matter: frames, Creo's cutter, and which CAM system wrote the file.
//!
//! `$$-> CUTTER / d` and `$$-> CSYS / ..` (Creo) are records in all but name. `$$*CATIA0` is followed by a title line and
//! three comment lines with a row of the frame's matrix each. Every other comment is only looked at for the name of the
//! CAM system.

use super::Dialect;
use super::args::{Args, skip_blanks};
use super::fault::{Fault, Span};
use super::number;
use super::parse::{arguments, exactly, frame_from_rows};
use super::record::Record;
use super::tools::cutter;

/// Comment lines behind `$$*CATIA0` that may stand in front of the matrix.
const TITLE_LINES: u8 = 1;

/// The matrix behind `$$*CATIA0`, as far as it is read.
#[derive(Debug, Default)]
pub(super) struct Matrix {
    open: bool,
    titles: u8,
    rows: usize,
    numbers: [f64; 12],
}

impl Matrix {
    pub(super) fn is_open(&self) -> bool {
        self.open
    }

    /// What stands here is no row: a matrix that was begun is lost, and with it a frame.
    pub(super) fn abandon(&mut self) -> Result<(), Fault> {
        let begun = self.open && self.rows > 0;
        self.open = false;
        if begun { Err(incomplete()) } else { Ok(()) }
    }

    /// Takes the text of one comment line; answers the matrix with its last row.
    fn take(&mut self, text: &[u8]) -> Result<Option<[f64; 12]>, Fault> {
        if !self.open {
            return Ok(None);
        }
        let mut row = [0.0; 4];
        if four_numbers(text, &mut row) {
            self.numbers[4 * self.rows..4 * self.rows + 4].copy_from_slice(&row);
            self.rows += 1;
            if self.rows == 3 {
                self.open = false;
                return Ok(Some(self.numbers));
            }
        } else if self.rows == 0 && self.titles < TITLE_LINES {
            self.titles += 1;
        } else if self.rows == 0 && !begins_with_number(text) {
            self.open = false;
        } else {
            self.open = false;
            return Err(incomplete());
        }
        Ok(None)
    }
}

fn incomplete() -> Fault {
    Fault::new(
        "frame",
        Span::WHOLE,
        "a row of the matrix behind $$*CATIA0 is expected here: four numbers with blanks between them",
        "the matrix says where the points lie: write its three rows, or delete them all",
    )
}

fn begins_with_number(text: &[u8]) -> bool {
    number::prefix(&text[skip_blanks(text, 0)..]).is_some()
}

/// Reads a comment, `$$` included.
pub(super) fn read(text: &[u8], matrix: &mut Matrix) -> Result<Record<'static>, Fault> {
    if text.starts_with(b"$$->") {
        matrix.abandon()?;
        return of_creo(text);
    }
    if text.starts_with(b"$$*CATIA") {
        matrix.abandon()?;
        *matrix = Matrix { open: true, ..Matrix::default() };
        return Ok(Record::Inert);
    }
    match matrix.take(&text[2..])? {
        Some(numbers) => Ok(Record::Frame(frame_from_rows(&numbers, Span { start: 0, end: text.len() }))),
        None => Ok(Record::Inert),
    }
}

/// Which CAM system a comment gives away.
pub(super) fn dialect(text: &[u8]) -> Dialect {
    let holds = |name: &[u8]| text.windows(name.len()).any(|bytes| bytes == name);
    if text.starts_with(b"$$->") || holds(b"Pro/CLfile") {
        Dialect::Creo
    } else if text.starts_with(b"$$*CATIA") || holds(b"CATIA APT") {
        Dialect::Catia
    } else {
        Dialect::Generic
    }
}

/// `$$-> WORD / arguments`.
fn of_creo(text: &[u8]) -> Result<Record<'static>, Fault> {
    let start = skip_blanks(text, b"$$->".len());
    let end = start + text[start..].iter().take_while(|byte| byte.is_ascii_alphanumeric() || **byte == b'_').count();
    let word_at = Span { start, end };
    if text[start..end].eq_ignore_ascii_case(b"CUTTER") {
        let mut args = arguments("CUTTER", text, word_at)?;
        return cutter("CUTTER", &mut args).map(Record::CutterOfLastTool);
    }
    if text[start..end].eq_ignore_ascii_case(b"CSYS") {
        let mut args: Args<'_> = arguments("CSYS", text, word_at)?;
        let numbers = exactly("CSYS", &mut args)?;
        return Ok(Record::Frame(frame_from_rows(&numbers, args.all())));
    }
    Ok(Record::Inert)
}

/// Whether the text is four numbers with blanks between them and nothing else.
fn four_numbers(text: &[u8], row: &mut [f64; 4]) -> bool {
    let mut at = 0;
    for place in row {
        let start = skip_blanks(text, at);
        let Some((value, used)) = number::prefix(&text[start..]) else { return false };
        at = start + used;
        if at < text.len() && skip_blanks(text, at) == at {
            return false;
        }
        *place = value;
    }
    skip_blanks(text, at) == text.len()
}
