//! Comments that are read: frames, the cutter of Creo, and names of the CAM system.
//!
//! `$$-> CUTTER / d` and `$$-> CSYS / ..` (Creo) are records written as comments. `$$*CATIA0` is followed by a title
//! line and three comment lines, each a row of the frame's matrix (CATIA, "Syntaxes Interpreted by APT Import"). Three
//! such rows without `$$*CATIA0` before them are a frame, too, if they are a rigid motion. Every other comment is only
//! searched for the name of the CAM system.

use super::Record;
use super::coordinates::{self, CoordinateRecord, FrameRecord};
use super::machine::MachineRecord;
use super::tool::{ToolRecord, cutter};
use super::words::look_up;
use crate::cl::dialect::Dialect;
use crate::cl::text::{Args, ClFault, MajorWord, Span, number_at_start, skip_blanks};
use crate::diag::code::cl;

/// Name in the first lines of a file of Pro/ENGINEER and Creo.
const CREO_NAME: &[u8] = b"Pro/CLfile";

/// Number of comment lines that may come between `$$*CATIA0` and the matrix.
const TITLE_LINES: u8 = 1;

/// A matrix of CATIA while it is read.
#[derive(Debug, Default)]
pub(crate) struct CatiaMatrix {
    /// `$$*CATIA0` has come: a matrix must follow.
    labelled: bool,
    titles: u8,
    rows: usize,
    numbers: [f64; 12],
}

impl CatiaMatrix {
    /// Whether a statement that is not a row would end a matrix.
    pub(crate) fn is_open(&self) -> bool {
        self.labelled || self.rows > 0
    }

    /// Ends the matrix at a statement that is not a row; refused if rows of `$$*CATIA0` have been read, since a frame
    /// would be lost. One or two rows without it are a comment.
    pub(crate) fn abandon(&mut self) -> Result<(), ClFault> {
        let begun = self.labelled && self.rows > 0;
        (self.labelled, self.rows) = (false, 0);
        if begun { Err(incomplete()) } else { Ok(()) }
    }

    /// Takes the text of one comment line; returns the frame when its last row is read.
    fn take(&mut self, text: &[u8], at: Span) -> Result<Option<FrameRecord>, ClFault> {
        let mut row = [0.0; 4];
        if four_numbers(text, &mut row) {
            self.numbers[4 * self.rows..4 * self.rows + 4].copy_from_slice(&row);
            self.rows += 1;
            if self.rows < 3 {
                return Ok(None);
            }
            let frame = FrameRecord::from_rows(&self.numbers, at);
            if std::mem::take(&mut self.labelled) || frame.is_rigid() {
                self.rows = 0;
                return Ok(Some(frame));
            }
            // Its last two rows may be the first of a frame.
            self.numbers.copy_within(4.., 0);
            self.rows = 2;
            return Ok(None);
        }
        if self.labelled && self.rows == 0 && self.titles < TITLE_LINES {
            self.titles += 1;
        } else if self.labelled && (self.rows > 0 || begins_with_number(text)) {
            (self.labelled, self.rows) = (false, 0);
            return Err(incomplete());
        } else {
            (self.labelled, self.rows) = (false, 0);
        }
        Ok(None)
    }
}

fn incomplete() -> ClFault {
    cl::FRAME.cl_fault(
        "frame",
        Span::WHOLE,
        "expected a row of the matrix of $$*CATIA0: four numbers separated by blanks",
        "the matrix is the frame of the points after it: write all three rows",
    )
}

fn begins_with_number(text: &[u8]) -> bool {
    number_at_start(&text[skip_blanks(text, 0)..]).is_some()
}

/// Reads a comment, `$$` included.
pub(crate) fn read_comment(text: &[u8], matrix: &mut CatiaMatrix) -> Result<Record<'static>, ClFault> {
    if text.starts_with(b"$$->") {
        matrix.abandon()?;
        return of_creo(text, b"$$->".len());
    }
    if text.starts_with(b"$$*CATIA") {
        matrix.abandon()?;
        *matrix = CatiaMatrix { labelled: true, ..CatiaMatrix::default() };
        return Ok(Record::Inert);
    }
    let frame = matrix.take(&text[2..], Span { start: 0, end: text.len() })?;
    Ok(frame.map_or(Record::Inert, |frame| Record::Coordinates(CoordinateRecord::Frame(frame))))
}

/// CAM system that a comment identifies.
pub(crate) fn comment_dialect(text: &[u8]) -> Dialect {
    if text.starts_with(b"$$->") || is_named(text, CREO_NAME) {
        Dialect::Creo
    } else if text.starts_with(b"$$*CATIA") || is_named(text, b"CATIA APT") {
        Dialect::Catia
    } else {
        Dialect::Generic
    }
}

/// Whether a text names a CAM system, in capitals or small letters.
fn is_named(text: &[u8], name: &[u8]) -> bool {
    text.windows(name.len()).any(|bytes| bytes.eq_ignore_ascii_case(name))
}

/// Begin of the text of a REMARK that is a record of Creo, and of such a comment after its `$$`.
const ARROW: &[u8] = b"->";

/// REMARK: `REMARK -> WORD / ..` is the record that newer versions of Pro/ENGINEER and Creo write as `$$-> WORD / ..`;
/// any other text has no effect.
pub(crate) fn remark<'a>(args: &mut Args<'a>) -> Result<Record<'a>, ClFault> {
    let (text, at) = (args.text(), args.position());
    args.skip_rest();
    if text[at..].starts_with(ARROW) { of_creo(text, at + ARROW.len()) } else { Ok(Record::Inert) }
}

/// CAM system that the text of a REMARK identifies.
pub(crate) fn remark_dialect(text: &[u8]) -> Dialect {
    let creo = text[skip_blanks(text, 0)..].starts_with(ARROW) || is_named(text, CREO_NAME);
    if creo { Dialect::Creo } else { Dialect::Generic }
}

/// Whether the points before and after CUTCOM are those of the centre of the tool or of the contour (parameter of a
/// sequence of Creo).
const GEOMETRY_TYPE: MajorWord =
    MajorWord { name: "CUTCOM_GEOMETRY_TYPE", forms: " / OUTPUT_ON_CENTER; / OUTPUT_ON_PROFILE" };

/// `-> WORD / arguments`; `start` is the byte after the arrow.
fn of_creo(text: &[u8], start: usize) -> Result<Record<'static>, ClFault> {
    let start = skip_blanks(text, start);
    let end = start + text[start..].iter().take_while(|byte| byte.is_ascii_alphanumeric() || **byte == b'_').count();
    if text[start..end].eq_ignore_ascii_case(GEOMETRY_TYPE.name.as_bytes()) {
        let mut args = Args::after_slash(&GEOMETRY_TYPE, text, end)?;
        let of_centre = args.one_of(&[("OUTPUT_ON_CENTER", true), ("OUTPUT_ON_PROFILE", false)])?;
        return Ok(Record::Machine(MachineRecord::CompensatedPath { of_centre, at: args.all() }));
    }
    let Some(row) = look_up(&text[start..end]) else { return Ok(Record::Inert) };
    match row.word.name {
        "CUTTER" => {
            let mut args = Args::after_slash(&row.word, text, end)?;
            cutter(&mut args).map(|cutter| Record::Tool(ToolRecord::CutterOfLastTool(cutter)))
        }
        "CSYS" => coordinates::matrix(&mut Args::after_slash(&row.word, text, end)?).map(Record::Coordinates),
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
