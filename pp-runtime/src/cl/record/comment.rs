//! Comments that are read: frames, the cutter of Creo, and names of the CAM system.
//!
//! `$$-> CUTTER / d` and `$$-> CSYS / ..` (Creo) are records written as comments. `$$*CATIA0` is followed by a title
//! line and three comment lines, each a row of the frame's matrix. Every other comment is only searched for the name of
//! the CAM system.

use super::Record;
use super::coordinates::{CoordinateRecord, FrameRecord};
use super::tool::{ToolRecord, cutter};
use super::words::look_up;
use crate::cl::dialect::Dialect;
use crate::cl::text::{Args, ClFault, Span, number_at_start, skip_blanks};

/// Number of comment lines that may come between `$$*CATIA0` and the matrix.
const TITLE_LINES: u8 = 1;

/// The matrix after `$$*CATIA0`, while it is read.
#[derive(Debug, Default)]
pub(crate) struct CatiaMatrix {
    open: bool,
    titles: u8,
    rows: usize,
    numbers: [f64; 12],
}

impl CatiaMatrix {
    pub(crate) fn is_open(&self) -> bool {
        self.open
    }

    /// Ends the matrix at a statement that is not a row; refused if rows have been read, since a frame would be lost.
    pub(crate) fn abandon(&mut self) -> Result<(), ClFault> {
        let begun = self.open && self.rows > 0;
        self.open = false;
        if begun { Err(incomplete()) } else { Ok(()) }
    }

    /// Takes the text of one comment line; returns the matrix when its last row is read.
    fn take(&mut self, text: &[u8]) -> Result<Option<[f64; 12]>, ClFault> {
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

fn incomplete() -> ClFault {
    ClFault::new(
        "frame",
        Span::WHOLE,
        "expected a row of the matrix of $$*CATIA0: four numbers separated by blanks",
        "the matrix is the frame of the points: write all three rows, or delete all of them",
    )
}

fn begins_with_number(text: &[u8]) -> bool {
    number_at_start(&text[skip_blanks(text, 0)..]).is_some()
}

/// Reads a comment, `$$` included.
pub(crate) fn read_comment(text: &[u8], matrix: &mut CatiaMatrix) -> Result<Record<'static>, ClFault> {
    if text.starts_with(b"$$->") {
        matrix.abandon()?;
        return of_creo(text);
    }
    if text.starts_with(b"$$*CATIA") {
        matrix.abandon()?;
        *matrix = CatiaMatrix { open: true, ..CatiaMatrix::default() };
        return Ok(Record::Inert);
    }
    match matrix.take(&text[2..])? {
        Some(numbers) => {
            let frame = FrameRecord::from_rows(&numbers, Span { start: 0, end: text.len() });
            Ok(Record::Coordinates(CoordinateRecord::Frame(frame)))
        }
        None => Ok(Record::Inert),
    }
}

/// CAM system that a comment identifies.
pub(crate) fn comment_dialect(text: &[u8]) -> Dialect {
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
fn of_creo(text: &[u8]) -> Result<Record<'static>, ClFault> {
    let start = skip_blanks(text, b"$$->".len());
    let end = start + text[start..].iter().take_while(|byte| byte.is_ascii_alphanumeric() || **byte == b'_').count();
    let Some(row) = look_up(&text[start..end]) else { return Ok(Record::Inert) };
    match row.word.name {
        "CUTTER" => {
            let mut args = Args::after_slash(&row.word, text, end)?;
            cutter(&mut args).map(|cutter| Record::Tool(ToolRecord::CutterOfLastTool(cutter)))
        }
        "CSYS" => {
            let mut args = Args::after_slash(&row.word, text, end)?;
            let numbers = args.exactly()?;
            let frame = FrameRecord::from_rows(&numbers, args.all());
            Ok(Record::Coordinates(CoordinateRecord::Frame(frame)))
        }
        _ => Ok(Record::Inert),
    }
}

/// Whether the text is four numbers with blanks between them and nothing else.
fn four_numbers(text: &[u8], row: &mut [f64; 4]) -> bool {
    let mut at = 0;
    for place in row {
        let start = skip_blanks(text, at);
        let Some((value, used)) = number_at_start(&text[start..]) else { return false };
        at = start + used;
        if at < text.len() && skip_blanks(text, at) == at {
            return false;
        }
        *place = value;
    }
    skip_blanks(text, at) == text.len()
}
