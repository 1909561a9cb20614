//! Comments that matter: frames, Creo's cutter, and evidence of the CAM system.
//!
//! `$$-> CUTTER / d` and `$$-> CSYS / ..` (Creo) are records in all but name. `$$*CATIA0` is followed by a title line and
//! three comment lines with a row of the frame's matrix each. Every other comment is only searched for the name of the
//! CAM system.

use super::Record;
use super::coordinates::{CoordinateRecord, FrameRecord};
use super::tool::{ToolRecord, cutter};
use super::words::look_up;
use crate::cl::dialect::Dialect;
use crate::cl::text::{Args, ClFault, Span, number_at_start, skip_blanks};

/// Comment lines after `$$*CATIA0` that may come before the matrix.
const TITLE_LINES: u8 = 1;

/// The matrix after `$$*CATIA0`, as far as it is read.
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

    /// The statement is no row: a matrix that was begun is lost, and with it a frame.
    pub(crate) fn abandon(&mut self) -> Result<(), ClFault> {
        let begun = self.open && self.rows > 0;
        self.open = false;
        if begun { Err(incomplete()) } else { Ok(()) }
    }

    /// Takes the text of one comment line; answers the matrix with its last row.
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
        "a row of the matrix behind $$*CATIA0 is expected here: four numbers with blanks between them",
        "the matrix says where the points lie: write its three rows, or delete them all",
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

/// The CAM system that a comment gives away.
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
