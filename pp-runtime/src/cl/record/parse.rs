//! Parses a statement into a typed record.
//!
//! A statement is `MAJOR[/argument,argument..]`. The major word is looked up in `words`, and the function of its row
//! reads all arguments. An argument that is not understood is refused, never passed over.

use super::Record;
use super::comment::remark_dialect;
use super::machine::CLAMPS_LEFT_TO_POST;
use super::own::GivenMeanings;
use super::values::Text;
use super::words::{Handling, has_numbers_of_a_frame, look_up, major_word};
use crate::cl::dialect::Dialect;
use crate::cl::text::{Args, ClFault, Help, Span, is_blank, quoted, skip_blanks};
use crate::diag::Severity;
use crate::diag::code::cl;

/// Largest number of bytes of an unknown word that its message shows.
const LONGEST_NAME: usize = 32;

/// Parses one statement that is not a comment. `text` is not empty. `given`: what the user says about words; words that
/// are read, and words that affect the motion after them, are not passed over and have no other meaning.
pub(crate) fn parse<'a>(text: &'a [u8], given: GivenMeanings<'_>) -> Result<Record<'a>, ClFault> {
    let word_at = major_word(text);
    let word = &text[word_at.start..word_at.end];
    let declared = || given.is_inert(word);
    let Some(row) = look_up(word) else {
        return match own_statement(text, word_at, given) {
            Some(own) => own,
            None if declared() => inert_unless_many_numbers(text, word_at),
            None if is_of_listing(text) => Ok(Record::Inert),
            None => Err(unknown(text, word_at)),
        };
    };
    let name = row.word.name;
    let passed_over = row.is_note() && declared();
    match row.handling {
        Handling::Read(read) => {
            if let Some(own) = own_record(text, given) {
                return Ok(own);
            }
            let mut args = Args::after_slash(&row.word, text, word_at.end)?;
            let read = read(&mut args).and_then(|record| args.finish().map(|()| record));
            // A turning tool is refused all the same.
            if passed_over && !read.as_ref().is_err_and(ClFault::is_of_lathe) { Ok(Record::Inert) } else { read }
        }
        Handling::ReadText(_) if passed_over => Ok(Record::Inert),
        Handling::ReadText(read) => read(&mut Args::new(&row.word, text, word_at.end)),
        Handling::Inert => own_statement(text, word_at, given).unwrap_or(Ok(Record::Inert)),
        Handling::Refused(reason) => match own_statement(text, word_at, given) {
            Some(own) => own,
            None if declared() => Ok(Record::Inert),
            None => Err(cl::REFUSED.cl_fault(
                name,
                word_at,
                format!("{name} is refused: {reason}"),
                format!("suppress {name} in the CAM system; {}", if_harmless(name)),
            )),
        },
        Handling::Automatic(_) if declared() || leaves_clamps_to_post(text) => Ok(Record::Inert),
        Handling::Automatic(reason) => Err(cl::REFUSED.cl_fault(
            name,
            word_at,
            format!("{name} is refused: {reason}"),
            format!("add `--inert {name}` if that is what it asks for; else suppress {name} in the CAM system"),
        )),
        Handling::Hazard(reason) => {
            Err(cl::REFUSED.cl_fault(name, word_at, format!("{name} is refused: {reason}"), instead_of(name)))
        }
        Handling::Lathe => Err(ClFault::lathe_record(word_at)),
    }
}

/// A statement of an unknown word that is declared inert. With as many numbers as a frame has it is refused: a path
/// without its frame is wrong.
fn inert_unless_many_numbers<'a>(text: &[u8], word_at: Span) -> Result<Record<'a>, ClFault> {
    if !has_numbers_of_a_frame(text) {
        return Ok(Record::Inert);
    }
    let word = String::from_utf8_lossy(&text[word_at.start..word_at.end]);
    Err(cl::REFUSED.cl_fault(
        "numbers of an inert word",
        Span { start: word_at.start, end: text.len() },
        format!(
            "{word} has six or more numbers: it may be a frame or a point, so it is not passed over, though it is inert"
        ),
        "for a frame of the points after it, as the frame of the part has it, write MCSYS/NUM,1,POINT,x,y,z,VECTOR,i,j,k,VECTOR,i,j,k \
         (origin, X, Y) and add `--frames main`; for a point write GOTO; if it has no effect, delete this statement",
    ))
}

/// Whether a CLAMP leaves the clamps to the postprocessor.
fn leaves_clamps_to_post(text: &[u8]) -> bool {
    let written = || text.iter().filter(|byte| !is_blank(**byte)).map(u8::to_ascii_uppercase);
    CLAMPS_LEFT_TO_POST.iter().any(|form| written().eq(form.bytes()))
}

/// What a user can do about a word that is always refused.
fn instead_of(word: &str) -> String {
    match word {
        "ROTATE" => "output the points in the frame of the part, with i, j, k in each GOTO in place of table rotations; in Creo see its \
                     parameters COORDINATE_OUTPUT (the machine coordinate system) and CL_DATA_MODE (no rotations in the file)"
            .into(),
        _ => format!("no option passes over {word}: output the path without it"),
    }
}

/// Begin of the lines that the Information window of NX writes before a listing; a colon follows.
const LISTING_HEADER: [&str; 4] = ["Information listing created by", "Date", "Current work part", "Node name"];

/// Whether a line is one of those around the records of a listing in the Information window of NX, which have no
/// effect. The lines between them are those of a CLSF.
fn is_of_listing(text: &[u8]) -> bool {
    let after = |start: &str| {
        let begins = text.get(..start.len())?.eq_ignore_ascii_case(start.as_bytes());
        begins.then(|| &text[skip_blanks(text, start.len())..])
    };
    let is_header = || LISTING_HEADER.iter().any(|start| after(start).is_some_and(|rest| rest.starts_with(b":")));
    let is_footer = || {
        after("Tool Path Listing has ").is_some_and(|rest| {
            let count = rest.iter().take_while(|byte| byte.is_ascii_digit()).count();
            count > 0 && rest[count..].trim_ascii().eq_ignore_ascii_case(b"lines.")
        })
    };
    text.iter().all(|byte| *byte == b'=') || is_header() || is_footer()
}

/// Fault of a line that is a record itself and that the `$` of the line before joins to the record `text`.
pub(crate) fn joined_record(text: &[u8], offset: usize, line: &[u8]) -> Option<ClFault> {
    let start = skip_blanks(line, 0);
    let end = start + major_word(&line[start..]).end;
    let row = look_up(&line[start..end]).filter(|row| row.handling.is_read())?;
    // If another word follows, the line is text that happens to begin with a major word.
    if line.get(skip_blanks(line, end)).is_some_and(|next| *next != b'/') {
        return None;
    }
    let word = major_word(text);
    // A comment has no major word; its `$$->` is shown.
    let shown = if word.end == 0 { text.len().min(4) } else { word.end };
    let first = String::from_utf8_lossy(&text[..shown]);
    Some(cl::SYNTAX.cl_fault(
        "joined record",
        Span { start: offset + start, end: offset + end },
        format!("{} would be lost: the `$` at the end of the line before joins it to {first}", row.word.name),
        "delete that `$`: at the end of a line it continues the statement on the next line",
    ))
}

/// CAM system that a record identifies.
pub(crate) fn record_dialect(text: &[u8]) -> Dialect {
    // Words of CSI_ are of any length.
    let begins = |word: &str| text.get(..word.len()).is_some_and(|start| start.eq_ignore_ascii_case(word.as_bytes()));
    if !["TOOL", "REMARK", "UNIT", "CSYS", "TRNTYP", "CSI_"].into_iter().any(begins) {
        return Dialect::Generic;
    }
    let word_at = major_word(text);
    match look_up(&text[word_at.start..word_at.end]).map(|row| row.word.name) {
        Some("TOOL PATH") => Dialect::Nx,
        Some("REMARK") => remark_dialect(&text[word_at.end..]),
        Some("UNIT" | "CSYS" | "TRNTYP" | "CSI_") => Dialect::SolidWorks,
        _ => Dialect::Generic,
    }
}

/// The statement of the shop that a statement is.
fn own_record<'a>(text: &'a [u8], given: GivenMeanings<'_>) -> Option<Record<'a>> {
    let index = given.own(text)?;
    Some(Record::Own(Text { bytes: text, at: Span { start: 0, end: text.len() } }, index))
}

/// A statement whose word has a statement of the shop. Any other statement of that word is refused, unless the word is
/// declared inert: it may be a misspelt one.
fn own_statement<'a>(text: &'a [u8], word_at: Span, given: GivenMeanings<'_>) -> Option<Result<Record<'a>, ClFault>> {
    let word = &text[word_at.start..word_at.end];
    let mut known = given.beginning_with(word).peekable();
    known.peek()?;
    let whole = Span { start: 0, end: text.len() };
    if let Some(own) = own_record(text, given) {
        return Some(Ok(own));
    }
    if given.is_inert(word) {
        return None;
    }
    let known: Vec<&str> = known.collect();
    Some(Err(cl::UNKNOWN_WORD.cl_fault(
        "statement of the shop",
        whole,
        format!("{} is not one of the statements in `[cl.words]`", quoted(text)),
        format!(
            "correct the statement, of this word the table has {}; or state its block there, too",
            known.join(", ")
        ),
    )))
}

/// What a user can do about a word that changes nothing, or that is one of the shop.
pub(crate) fn if_harmless(word: &str) -> String {
    format!(
        "if it moves no axis and changes no state, add `--inert {word}`; if it calls a block of the shop, state the \
         block in `[cl.words]`"
    )
}

fn unknown(text: &[u8], mut at: Span) -> ClFault {
    let tool_path = b"TOOL PATH";
    if text.get(..tool_path.len()).is_some_and(|start| start.eq_ignore_ascii_case(tool_path))
        && let Some(row) = look_up(tool_path)
        && let Err(fault) = Args::after_slash(&row.word, text, tool_path.len())
    {
        return fault;
    }
    let named = at.start..at.end.min(at.start + LONGEST_NAME);
    if at.start == at.end {
        at.end = text.len();
    }
    let word = &text[at.start..at.end];
    ClFault {
        code: cl::UNKNOWN_WORD,
        kind: "unknown word",
        at,
        text: format!("{} is not a known word of CL data", quoted(word)),
        help: Help::NearestTo(String::from_utf8_lossy(&text[named]).into_owned()),
        severity: Severity::Error,
    }
}
