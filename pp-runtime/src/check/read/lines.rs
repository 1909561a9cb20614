//! Lines of a program, read piece by piece. From the first statement on that may lead back to a line they are kept, as
//! many as a long loop has.

use std::io;

use super::TextPieces;
use super::text::GOES_ON;

/// A line longer than this is no line of a program, bytes.
pub(super) const LONGEST: usize = 1 << 16;

/// Text that is kept of a longer line, for messages, bytes.
const SHOWN: usize = 256;

/// Text that is kept for a jump back where no loop or call is open, bytes.
const FARTHEST_BACK: usize = 128 << 10;

/// Text that is kept for a loop, a condition or a subprogram, bytes.
const LONGEST_BODY: usize = 64 << 20;

/// What is known of a line besides its text.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct LineKind {
    /// Number of the line, of the last one where it goes on in the next, from 1.
    pub(crate) number: u64,
    /// It was cut off.
    pub(crate) long: bool,
    /// It has been joined of several.
    pub(crate) joined: bool,
    /// Its number is not one more than that of the line before, where every line has a number.
    pub(crate) misnumbered: bool,
}

/// What a kept line takes.
fn bytes(line: &[u8]) -> usize {
    line.len() + size_of::<(Vec<u8>, LineKind)>()
}

/// The lines of a program.
#[derive(Debug)]
pub(super) struct Lines<P> {
    input: P,
    piece: Vec<u8>,
    /// Number of bytes of the piece that have been read.
    used: usize,
    /// Every line has a number, and one that ends in `~` goes on in the next.
    numbered: bool,
    /// The number with which the last one begins.
    last: Option<u64>,
    /// Number of lines read from the input.
    number: u64,
    /// Lines that are kept, the place of the next one, and whether further ones are kept.
    kept: Vec<(Vec<u8>, LineKind)>,
    next: usize,
    keeps: bool,
    /// Number of lines that have been read again.
    again: u64,
    /// What the kept lines take, bytes.
    kept_bytes: usize,
    /// Lines of subprograms that come before their calls: the first so many stay kept, and what they take, bytes.
    pinned: usize,
    pinned_bytes: usize,
}

impl<P: TextPieces> Lines<P> {
    pub(super) fn new(input: P, numbered: bool) -> Self {
        Self {
            input,
            piece: Vec::new(),
            used: 0,
            numbered,
            last: None,
            number: 0,
            kept: Vec::new(),
            next: 0,
            keeps: false,
            again: 0,
            kept_bytes: 0,
            pinned: 0,
            pinned_bytes: 0,
        }
    }

    /// Number of lines read so far.
    pub(super) fn number(&self) -> u64 {
        self.number
    }

    /// Number of lines that have been read again.
    pub(super) fn again(&self) -> u64 {
        self.again
    }

    /// Puts the next line into `line`; `None` after the last one.
    pub(super) fn next(&mut self, line: &mut Vec<u8>) -> io::Result<Option<LineKind>> {
        if let Some((text, kind)) = self.kept.get(self.next) {
            line.clone_from(text);
            self.next += 1;
            self.again += 1;
            return Ok(Some(*kind));
        }
        let Some(kind) = self.read_numbered(line)? else { return Ok(None) };
        if self.keeps {
            self.push(line.clone(), kind);
            self.next = self.kept.len();
        }
        Ok(Some(kind))
    }

    /// Keeps the line at hand and those after it; its place.
    pub(super) fn keep(&mut self, line: &[u8], kind: LineKind) -> usize {
        if !self.keeps {
            self.keeps = true;
            self.push(line.to_vec(), kind);
            self.next = self.kept.len();
        }
        self.next - 1
    }

    fn push(&mut self, line: Vec<u8>, kind: LineKind) {
        self.kept_bytes += bytes(&line);
        self.kept.push((line, kind));
    }

    /// Nothing leads back to the lines that are kept, unless they are near.
    pub(super) fn forget_far(&mut self) {
        if self.kept_bytes - self.pinned_bytes > FARTHEST_BACK && self.next == self.kept.len() {
            self.kept.truncate(self.pinned);
            self.kept.shrink_to_fit();
            (self.next, self.keeps, self.kept_bytes) = (self.pinned, false, self.pinned_bytes);
        }
    }

    /// The lines up to a place stay kept: a call that comes later leads to them.
    pub(super) fn pin(&mut self, place: usize) {
        self.pinned = place + 1;
        self.pinned_bytes = self.kept[..self.pinned].iter().map(|(line, _)| bytes(line)).sum();
    }

    /// Whether more is kept than any loop has.
    pub(super) fn are_too_many(&self) -> bool {
        self.kept_bytes > LONGEST_BODY
    }

    /// The text of a line that is kept.
    pub(super) fn kept(&self, place: usize) -> Option<&[u8]> {
        self.kept.get(place).map(|(text, _)| text.as_slice())
    }

    /// Place of the first line that suits among those that are kept.
    pub(super) fn find_kept(&self, mut suits: impl FnMut(&[u8]) -> bool) -> Option<usize> {
        self.kept.iter().position(|(text, _)| suits(text))
    }

    /// Goes to a line that is kept.
    pub(super) fn go_to(&mut self, place: usize) {
        self.next = place;
    }

    /// Place of the first line from a place on that suits, as far as lines are kept; further lines are read for it.
    pub(super) fn find(&mut self, from: usize, mut suits: impl FnMut(&[u8]) -> bool) -> io::Result<Option<usize>> {
        let mut line = Vec::new();
        let mut place = from;
        loop {
            if place == self.kept.len() {
                if self.are_too_many() {
                    return Ok(None);
                }
                let Some(kind) = self.read_numbered(&mut line)? else { return Ok(None) };
                self.push(line.clone(), kind);
            }
            if suits(&self.kept[place].0) {
                return Ok(Some(place));
            }
            place += 1;
        }
    }

    /// Reads a line, and compares its number with that of the line before.
    fn read_numbered(&mut self, line: &mut Vec<u8>) -> io::Result<Option<LineKind>> {
        let kind = self.read(line)?;
        let text = line.trim_ascii_start();
        let text = text.strip_prefix(b"/").unwrap_or(text);
        let digits = text.iter().take_while(|byte| byte.is_ascii_digit()).count();
        let number = std::str::from_utf8(&text[..digits]).ok().and_then(|number| number.parse::<u64>().ok());
        if !self.numbered || number.is_none() {
            return Ok(kind);
        }
        let misnumbered = self.last.is_some_and(|last| number != Some(last + 1));
        self.last = number;
        Ok(kind.map(|kind| LineKind { misnumbered, ..kind }))
    }

    /// Reads a line, with those that continue it.
    fn read(&mut self, line: &mut Vec<u8>) -> io::Result<Option<LineKind>> {
        line.clear();
        let (mut long, mut joined) = (false, false);
        loop {
            let before = line.len();
            let read = self.take(line)?;
            if read == 0 {
                return Ok(joined.then_some(LineKind { number: self.number, long, joined, misnumbered: false }));
            }
            self.number += 1;
            if line.last() == Some(&b'\n') {
                line.pop();
            } else if read == LONGEST {
                long = true;
                self.skip()?;
            }
            while line.len() > before && line.last().is_some_and(u8::is_ascii_whitespace) {
                line.pop();
            }
            let goes_on = self.numbered && line[before..].last() == Some(&b'~');
            long |= line.len() > LONGEST;
            if long {
                line.truncate(LONGEST);
            }
            if !goes_on {
                if long {
                    line.truncate(SHOWN);
                }
                return Ok(Some(LineKind { number: self.number, long, joined, misnumbered: false }));
            }
            // It separates the parameters of a cycle, and a `~` anywhere else is text.
            if let Some(mark) = line.last_mut() {
                *mark = b' ';
                line.push(GOES_ON);
            }
            joined = true;
            if long {
                line.truncate(before);
            }
        }
    }

    /// Appends the bytes up to the next line end, at most [`LONGEST`]; their number, the line end included.
    fn take(&mut self, line: &mut Vec<u8>) -> io::Result<usize> {
        let mut read = 0;
        loop {
            let text = &self.piece[self.used..];
            let text = &text[..text.len().min(LONGEST - read)];
            let end = memchr::memchr(b'\n', text).map(|end| end + 1);
            let count = end.unwrap_or(text.len());
            line.extend_from_slice(&text[..count]);
            self.used += count;
            read += count;
            if end.is_some() || read == LONGEST || !self.next_piece()? {
                return Ok(read);
            }
        }
    }

    /// Passes over the bytes up to the next line end.
    fn skip(&mut self) -> io::Result<()> {
        loop {
            match memchr::memchr(b'\n', &self.piece[self.used..]) {
                Some(end) => self.used += end + 1,
                None if self.next_piece()? => continue,
                None => (),
            }
            return Ok(());
        }
    }

    /// Gets the next piece; whether there is one.
    #[inline(never)]
    fn next_piece(&mut self) -> io::Result<bool> {
        self.used = 0;
        self.input.next_piece(&mut self.piece)?;
        Ok(!self.piece.is_empty())
    }
}
