//! Splits bytes into logical statements, in constant memory.
//!
//! A statement is one physical line, or several joined by a trailing `$`. Lines end in LF, CRLF or a lone CR; the last
//! line may have no end. `$$` begins a comment. Lines are joined as they are, with nothing added or trimmed, because
//! CAM systems split lines inside numbers. A `$` joins only when nothing but blanks follows it. A comment continues on
//! the next line only if it begins with `$$->`, and the continuation is comment too; otherwise a comment that happens
//! to end in `$` would make the GOTO after it a comment. `$$` inside a pair of quotes begins no comment, nor does any
//! `$$` after INSERT, whose text is the rest of its line. On cards of 72 columns the columns after them are not read.
//!
//! A statement on one line is a slice of the read buffer; a joined one is copied to a second buffer, with a list of the
//! lines that its pieces come from. Both buffers are reused. Nothing is interpreted here.

use std::io::{self, Read};

use memchr::{memchr, memchr2};

use super::blanks::{is_blank, skip_blanks};
use super::fault::Span;
use super::line_shape::{LINE_AND_NUMBER, LineShape, ShortNumbers};
use super::number::ShortNumber;
use crate::program::Location;

/// Number of bytes requested from the input at once.
const CHUNK: usize = 256 * 1024;

/// Longest statement and longest line that is read, in bytes; it bounds the memory. Real ones are far shorter.
pub(crate) const LONGEST_STATEMENT: usize = 1 << 20;

/// What follows a joined statement in its buffer: a line end, and bytes that a reader of whole lines may look at.
const AFTER_JOINED: [u8; LINE_AND_NUMBER] = {
    let mut bytes = [0; LINE_AND_NUMBER];
    bytes[0] = b'\n';
    bytes
};

/// Number of bytes at the start of the file that are searched for a NUL, the mark of a binary file.
const BINARY_SEARCH: usize = 1024;

/// Kind of a statement, known from its bytes alone.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum StatementKind {
    /// A record.
    Code,
    /// A comment with its `$$`.
    Comment,
    /// Longer than [`LONGEST_STATEMENT`]; skipped.
    TooLong,
    /// The file ends after the `$` that continues the statement.
    Unfinished,
}

/// One statement without the blanks around it; its bytes stay in the lexer until the next one is read.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Statement {
    pub(crate) kind: StatementKind,
    joined: bool,
    start: usize,
    end: usize,
    line: u64,
    /// Index of the line's first byte in the read buffer; meaningless for a joined statement.
    line_start: usize,
}

impl Statement {
    /// Whether it is a record that has been joined of several lines.
    pub(crate) fn is_joined_code(&self) -> bool {
        self.joined && self.kind == StatementKind::Code
    }
}

/// A word and at most `N` short numbers, with the shapes that lines of them had.
pub(crate) struct NumberLine<const N: usize> {
    word: &'static [u8],
    /// Shape of the last line, of those read number by number, that was laid out as one of the two before it.
    whole: Box<LineShape<N>>,
    /// Shape of lines that alternate with those, as the ends of arcs to and fro do.
    other: Box<LineShape<N>>,
    /// Number of the line before the last line of that shape.
    before_other: u64,
    /// Marks of the last two lines that were read number by number, the last one first; the same of lines with their
    /// digits at the same places, and seldom that of others.
    marks: [u64; 2],
}

impl<const N: usize> NumberLine<N> {
    pub(crate) fn new(word: &'static str) -> Self {
        NumberLine {
            word: word.as_bytes(),
            whole: Box::new(LineShape::NONE),
            other: Box::new(LineShape::NONE),
            before_other: 0,
            marks: [0; 2],
        }
    }
}

/// Place in the file of the bytes of a joined statement from `offset` on.
#[derive(Debug, Clone, Copy)]
struct JoinedPiece {
    offset: usize,
    location: Location,
}

/// Place of a line in the read buffer, without its line end.
#[derive(Debug, Clone, Copy)]
pub(crate) struct PhysicalLine {
    start: usize,
    end: usize,
    too_long: bool,
}

/// Reads statements from `R`.
pub(crate) struct Lexer<R> {
    input: R,
    buffer: Vec<u8>,
    /// Unread bytes are `buffer[start..end]`.
    start: usize,
    end: usize,
    at_end: bool,
    begun: bool,
    /// The last line ended in CR; a LF that follows belongs to it.
    after_cr: bool,
    /// Number of the line read last.
    line: u64,
    joined: Vec<u8>,
    pieces: Vec<JoinedPiece>,
    /// Number of bytes of a line that are read; the rest is ignored.
    columns: usize,
}

impl<R: Read> Lexer<R> {
    pub(crate) fn new(input: R, columns: Option<u32>) -> Self {
        Lexer {
            input,
            columns: columns.map_or(usize::MAX, |columns| columns as usize),
            buffer: vec![0; CHUNK],
            start: 0,
            end: 0,
            at_end: false,
            begun: false,
            after_cr: false,
            line: 0,
            joined: Vec::new(),
            pieces: Vec::new(),
        }
    }

    /// Reads the first bytes, skips a UTF-8 byte order mark, and returns whether they are text.
    pub(crate) fn begin(&mut self) -> io::Result<Beginning> {
        while !self.at_end && self.end < BINARY_SEARCH {
            self.fill()?;
        }
        self.begun = true;
        if self.buffer[..self.end].starts_with(b"\xEF\xBB\xBF") {
            self.start = 3;
        }
        Ok(match memchr(0, &self.buffer[..self.end.min(BINARY_SEARCH)]) {
            Some(_) => Beginning::Binary,
            None if self.start == self.end => Beginning::Empty,
            None => Beginning::Text,
        })
    }

    /// Reads the next statement that is not blank.
    pub(crate) fn next(&mut self) -> io::Result<Option<Statement>> {
        if !self.begun {
            self.begin()?;
        }
        loop {
            let Some(line) = self.take_line()? else { return Ok(None) };
            let statement = if line.too_long {
                return Ok(Some(self.on_one_line(line, StatementKind::TooLong)));
            } else if memchr(b'$', &self.buffer[line.start..line.end]).is_none() {
                self.on_one_line(line, StatementKind::Code)
            } else {
                self.with_dollar(line)?
            };
            let statement = self.trimmed(statement);
            if statement.start < statement.end {
                return Ok(Some(statement));
            }
        }
    }

    /// Reads the next line in one pass, if it is a word, a slash, and short numbers between commas of which `make`
    /// makes a value of the first `USED`; any other line is left to [`next`](Self::next). Nearly every line of a file
    /// is such a GOTO.
    #[inline(always)]
    pub(crate) fn next_numbers<const N: usize, const USED: usize, T>(
        &mut self,
        before: &mut NumberLine<N>,
        make: impl FnOnce(ShortNumbers<USED>) -> Option<T>,
    ) -> Option<(PhysicalLine, T)> {
        let line = &self.buffer[self.start..];
        if self.columns < usize::MAX {
            return None;
        }
        let known = line.first_chunk().and_then(|text| before.whole.read::<USED>(text));
        let (numbers, length) = match known {
            Some(read) => read,
            None => unlike_the_last(line, self.line, before)?,
        };
        // After the end of what has been read there are bytes of earlier reads.
        if self.start + length > self.end {
            return None;
        }
        let end = self.start + numbers.at.end;
        let made = make(numbers)?;
        self.line += 1;
        let line = PhysicalLine { start: self.start, end, too_long: false };
        self.start += length;
        self.after_cr = false;
        Some((line, made))
    }

    /// [`next_numbers`](Self::next_numbers) of a statement that has been joined.
    pub(crate) fn joined_numbers<const N: usize, const USED: usize, T>(
        &self,
        statement: &Statement,
        before: &mut NumberLine<N>,
        make: impl FnOnce(ShortNumbers<USED>) -> Option<T>,
    ) -> Option<T> {
        if !statement.is_joined_code() || self.columns < usize::MAX {
            return None;
        }
        let text = &self.joined[statement.start..];
        let known = text.first_chunk().and_then(|text| before.whole.read::<USED>(text));
        let (numbers, _) = known.or_else(|| unlike_the_last(text, self.line, before))?;
        make(numbers)
    }

    /// The statement of the line that [`next_numbers`](Self::next_numbers) has returned last.
    pub(crate) fn last_line(&self, line: PhysicalLine) -> Statement {
        self.on_one_line(line, StatementKind::Code)
    }

    /// Bytes of the statement returned last.
    pub(crate) fn text(&self, statement: &Statement) -> &[u8] {
        let bytes = if statement.joined { &self.joined } else { &self.buffer };
        &bytes[statement.start..statement.end]
    }

    /// Place in the file of byte `offset` of the statement, and number of its bytes from there on that line.
    pub(crate) fn locate(&self, statement: &Statement, offset: usize) -> (Location, usize) {
        let at = statement.start + offset;
        if !statement.joined {
            let location = Location { line: statement.line, column: column(at - statement.line_start) };
            return (location, statement.end.saturating_sub(at));
        }
        let next = self.pieces.partition_point(|piece| piece.offset <= at);
        let piece = self.pieces[next.saturating_sub(1)];
        let end = self.pieces.get(next).map_or(statement.end, |piece| piece.offset);
        let Location { line, column: first } = piece.location;
        (Location { line, column: column(first as usize - 1 + at - piece.offset) }, end.saturating_sub(at))
    }

    /// Lines of a joined statement after its first, each with the index of the statement's byte at which it begins.
    pub(crate) fn joined_lines(&self, statement: &Statement) -> impl Iterator<Item = (usize, &[u8])> {
        let pieces = if statement.joined { self.pieces.get(1..).unwrap_or_default() } else { &[] };
        let ends = pieces.iter().skip(1).map(|piece| piece.offset).chain([statement.end]);
        pieces.iter().zip(ends).filter_map(move |(piece, end)| {
            // The blanks around the statement are removed from it, not from its pieces.
            let (from, to) = (piece.offset.max(statement.start), end.min(statement.end));
            (from < to).then(|| (from - statement.start, &self.joined[from..to]))
        })
    }

    /// Number of lines read so far.
    pub(crate) fn lines(&self) -> u64 {
        self.line
    }

    /// Returns the statement of a line that holds a `$`: a comment, a record before a comment, or a continued record.
    fn with_dollar(&mut self, line: PhysicalLine) -> io::Result<Statement> {
        let text = &self.buffer[line.start..line.end];
        let whole = is_insert(text);
        let comment = if whole { None } else { comment_start(text) };
        let blank_before = text.iter().take_while(|byte| is_blank(**byte)).count();
        if comment == Some(blank_before) {
            let continues = text[blank_before..].starts_with(b"$$->") && continued(text).is_some();
            return if continues {
                self.join(line, StatementKind::Comment)
            } else {
                Ok(self.on_one_line(line, StatementKind::Comment))
            };
        }
        let code = &text[..comment.unwrap_or(text.len())];
        if continued(code).is_some() {
            return self.join(line, StatementKind::Code);
        }
        let end = line.start + code.len();
        Ok(self.on_one_line(PhysicalLine { end, ..line }, StatementKind::Code))
    }

    /// Joins the lines from `line` on up to the first that does not end in `$`.
    #[cold]
    fn join(&mut self, line: PhysicalLine, mut kind: StatementKind) -> io::Result<Statement> {
        let is_comment = kind == StatementKind::Comment;
        let whole = is_comment || is_insert(&self.buffer[line.start..line.end]);
        let first = self.line;
        self.joined.clear();
        self.pieces.clear();
        let mut line = line;
        loop {
            let text = &self.buffer[line.start..line.end];
            let text = if whole { text } else { &text[..comment_start(text).unwrap_or(text.len())] };
            let more = continued(text);
            let piece = &text[..more.unwrap_or(text.len())];
            self.pieces
                .push(JoinedPiece { offset: self.joined.len(), location: Location { line: self.line, column: 1 } });
            // A line counts with its place too: a statement of lines without text is no shorter.
            let places = size_of::<JoinedPiece>() * self.pieces.len();
            if line.too_long || self.joined.len() + piece.len() + places > LONGEST_STATEMENT {
                kind = StatementKind::TooLong;
                self.joined.clear();
                self.pieces.clear();
            } else {
                self.joined.extend_from_slice(piece);
            }
            if more.is_none() {
                break;
            }
            match self.take_line()? {
                Some(next) => line = next,
                None => {
                    let cut_short = kind == StatementKind::Code;
                    kind = if cut_short { StatementKind::Unfinished } else { kind };
                    break;
                }
            }
        }
        if kind == StatementKind::TooLong {
            self.joined.clear();
            self.joined.push(b'$');
            self.pieces.clear();
            self.pieces.push(JoinedPiece { offset: 0, location: Location { line: first, column: 1 } });
        }
        let end = self.joined.len();
        self.joined.extend_from_slice(&AFTER_JOINED);
        Ok(Statement { kind, joined: true, start: 0, end, line: first, line_start: 0 })
    }

    fn on_one_line(&self, line: PhysicalLine, kind: StatementKind) -> Statement {
        Statement { kind, joined: false, start: line.start, end: line.end, line: self.line, line_start: line.start }
    }

    fn trimmed(&self, statement: Statement) -> Statement {
        let text = self.text(&statement);
        let before = text.iter().take_while(|byte| is_blank(**byte)).count();
        let after = text[before..].iter().rev().take_while(|byte| is_blank(**byte)).count();
        Statement { start: statement.start + before, end: statement.end - after, ..statement }
    }

    /// Reads the next physical line, without its line end.
    fn take_line(&mut self) -> io::Result<Option<PhysicalLine>> {
        // No line end lies before `searched`: a long line is searched once only, whatever the size of the reads.
        let mut searched = self.start;
        let mut too_long = false;
        loop {
            if self.after_cr && self.start < self.end {
                self.after_cr = false;
                if self.buffer[self.start] == b'\n' {
                    self.start += 1;
                    searched = self.start;
                }
            }
            if let Some(found) = memchr2(b'\n', b'\r', &self.buffer[searched..self.end]) {
                let end = searched + found;
                let line =
                    PhysicalLine { start: self.start, end: end.min(self.start.saturating_add(self.columns)), too_long };
                let cr = self.buffer[end] == b'\r';
                // A LF that has not been read yet is skipped before the next line.
                self.after_cr = cr && end + 1 == self.end;
                let lf = cr && self.buffer[..self.end].get(end + 1) == Some(&b'\n');
                self.start = end + 1 + usize::from(lf);
                self.line += 1;
                return Ok(Some(line));
            }
            if self.end - self.start > LONGEST_STATEMENT {
                too_long = true;
                self.end = self.start;
            }
            if self.at_end {
                if self.start == self.end && !too_long {
                    return Ok(None);
                }
                let end = self.end.min(self.start.saturating_add(self.columns));
                let line = PhysicalLine { start: self.start, end, too_long };
                self.start = self.end;
                self.line += 1;
                return Ok(Some(line));
            }
            let unread = self.end - self.start;
            self.fill()?;
            searched = self.start + unread;
        }
    }

    /// Moves the unread bytes to the front of the buffer and reads more after them.
    fn fill(&mut self) -> io::Result<()> {
        self.buffer.copy_within(self.start..self.end, 0);
        self.end -= self.start;
        self.start = 0;
        if self.end == self.buffer.len() {
            self.buffer.resize(2 * self.end, 0);
        }
        loop {
            match self.input.read(&mut self.buffer[self.end..]) {
                Ok(0) => self.at_end = true,
                Ok(count) => self.end += count,
                Err(error) if error.kind() == io::ErrorKind::Interrupted => continue,
                Err(error) => return Err(error),
            }
            return Ok(());
        }
    }
}

/// The numbers of a line that has not the shape of the last one, and the number of its bytes with its end. `number`: of
/// the line before.
#[inline(never)]
fn unlike_the_last<const N: usize, const USED: usize>(
    line: &[u8],
    number: u64,
    before: &mut NumberLine<N>,
) -> Option<(ShortNumbers<USED>, usize)> {
    // Nearly every line of another word has another first letter.
    if line.first() != before.word.first() {
        return None;
    }
    let Some(read) = line.first_chunk().and_then(|text| before.other.read::<USED>(text)) else {
        return one_by_one(line, before);
    };
    // Lines in succession are of one shape: it is the one to be expected.
    if before.before_other + 1 == number {
        std::mem::swap(&mut before.whole, &mut before.other);
    }
    before.before_other = number;
    Some(read)
}

/// The numbers of a line that begins with the word, and the number of its bytes with its end.
#[inline(never)]
fn one_by_one<const N: usize, const USED: usize>(
    line: &[u8],
    before: &mut NumberLine<N>,
) -> Option<(ShortNumbers<USED>, usize)> {
    let slash = skip_blanks(line, before.word.len());
    if !line.starts_with(before.word) || line.get(slash) != Some(&b'/') {
        return None;
    }
    let (mut numbers, mut count, mut end, mut mark) = ([0.0; N], 0, slash, 0_u64);
    for number in &mut numbers {
        let start = end + 1;
        // At the end of the buffer there may be no such bytes.
        let read = ShortNumber::read(line.get(start..)?.first_chunk()?)?;
        *number = read.value;
        (count, end, mark) = (count + 1, start + read.end, mark.rotate_left(11) ^ read.mark);
        if line.get(end) != Some(&b',') {
            break;
        }
    }
    let after = skip_blanks(line, end);
    let length = match line.get(after)? {
        b'\n' => after + 1,
        b'\r' if line.get(after + 1) == Some(&b'\n') => after + 2,
        _ => return None,
    };
    let at = Span { start: skip_blanks(line, slash + 1), end };
    let [last, second] = before.marks;
    before.marks = [mark, last];
    if last == mark || second == mark {
        if last != mark {
            std::mem::swap(&mut before.whole, &mut before.other);
        }
        before.whole.take(line, length, count, at);
    }
    Some((ShortNumbers { numbers: *numbers.first_chunk()?, count, at }, length))
}

/// Content of a file by its first bytes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Beginning {
    Text,
    Binary,
    Empty,
}

/// Index of the first `$$` outside quotes.
fn comment_start(text: &[u8]) -> Option<usize> {
    let mut from = 0;
    while let Some(found) = memchr2(b'$', b'\'', &text[from..]) {
        let at = from + found;
        from = at + 1;
        match text[at] {
            b'\'' => from = memchr(b'\'', &text[from..]).map_or(from, |closing| from + closing + 1),
            _ if text.get(from) == Some(&b'$') => return Some(at),
            _ => {}
        }
    }
    None
}

/// Whether a line is an INSERT; its text is the rest of the line, `$$` included.
fn is_insert(text: &[u8]) -> bool {
    const INSERT: &[u8] = b"INSERT";
    let text = text.trim_ascii_start();
    text.get(..INSERT.len()).is_some_and(|word| word.eq_ignore_ascii_case(INSERT))
        && text.get(INSERT.len()).is_none_or(|byte| !byte.is_ascii_alphanumeric())
}

/// Index of the `$` with only blanks after it, if the text ends in one.
fn continued(text: &[u8]) -> Option<usize> {
    let blanks = text.iter().rev().take_while(|byte| is_blank(**byte)).count();
    let last = (text.len() - blanks).checked_sub(1)?;
    (text[last] == b'$').then_some(last)
}

/// Column, counted from 1, of the byte at `index`.
fn column(index: usize) -> u32 {
    u32::try_from(index + 1).unwrap_or(u32::MAX)
}
