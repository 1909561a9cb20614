//! Excerpts: the source lines that diagnostics refer to, found in one more pass over the text.

use std::collections::BTreeMap;
use std::io::{self, Read};

use memchr::memchr2;

use crate::program::Location;

/// Largest number of characters of a line that are shown.
pub(crate) const WIDTH: usize = 100;

/// Bytes kept on each side of a column: at most four bytes per character.
const WINDOW_BYTES: u64 = 4 * WIDTH as u64;

/// Bytes read at once.
const CHUNK_BYTES: usize = 64 * 1024;

/// The part of a line around a column.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub(crate) struct Excerpt {
    /// The line in visible characters: control characters as symbols, bytes that are not UTF-8 replaced.
    pub(crate) text: String,
    /// Number of characters of `text` before the column.
    pub(crate) indent: usize,
    /// Number of characters of `text` that the diagnostic marks from the column on, at least 1.
    pub(crate) marked: usize,
}

/// Bytes of a line around a column, being collected.
#[derive(Debug, Default)]
struct Window {
    bytes: Vec<u8>,
    /// Offset in the line of the first byte kept.
    start: u64,
    /// The line has more bytes after those kept.
    cut: bool,
}

/// The text around each place (first byte and number of bytes). A place after the end of the text is left out.
///
/// Lines end with LF, CRLF or a single CR, as in the reader of CL data.
pub(crate) fn excerpts(
    input: &mut dyn Read,
    places: impl Iterator<Item = (Location, u32)>,
) -> io::Result<BTreeMap<(Location, u32), Excerpt>> {
    let mut windows: BTreeMap<(Location, u32), Window> = places.map(|place| (place, Window::default())).collect();
    let mut scan = LineScan { line: 1, offset: 0, after_cr: false };
    let last = windows.keys().next_back().map_or(0, |(location, _)| location.line);
    let mut buffer = vec![0; CHUNK_BYTES];
    while scan.line <= last {
        let count = match input.read(&mut buffer) {
            Ok(0) => break,
            Ok(count) => count,
            Err(error) if error.kind() == io::ErrorKind::Interrupted => continue,
            Err(error) => return Err(error),
        };
        scan.chunk(&buffer[..count], &mut windows);
    }
    let reached = (scan.line, scan.offset);
    windows.retain(|(location, _), _| (location.line, 0) < reached);
    let shown = |(place, window): ((Location, u32), Window)| {
        let (location, length) = place;
        (place, show(location, length, &window))
    };
    Ok(windows.into_iter().map(shown).collect())
}

/// Position of the pass in the text.
struct LineScan {
    line: u64,
    /// Offset in the line of the next byte.
    offset: u64,
    after_cr: bool,
}

impl LineScan {
    fn chunk(&mut self, mut bytes: &[u8], windows: &mut BTreeMap<(Location, u32), Window>) {
        if self.after_cr && bytes.first() == Some(&b'\n') {
            bytes = &bytes[1..];
        }
        if !bytes.is_empty() {
            self.after_cr = false;
        }
        while !bytes.is_empty() {
            let end = memchr2(b'\n', b'\r', bytes);
            let piece = &bytes[..end.unwrap_or(bytes.len())];
            self.keep(piece, windows);
            let Some(end) = end else {
                self.offset += piece.len() as u64;
                return;
            };
            let crlf = bytes[end] == b'\r' && bytes.get(end + 1) == Some(&b'\n');
            self.after_cr = bytes[end] == b'\r' && end + 1 == bytes.len();
            bytes = &bytes[end + 1 + usize::from(crlf)..];
            self.line += 1;
            self.offset = 0;
        }
    }

    /// Copies the bytes of `piece` that lie in the windows of this line.
    fn keep(&self, piece: &[u8], windows: &mut BTreeMap<(Location, u32), Window>) {
        let on_line = Location { line: self.line, column: 0 }..Location { line: self.line + 1, column: 0 };
        let end = self.offset + piece.len() as u64;
        for ((location, _), window) in windows.range_mut((on_line.start, 0)..(on_line.end, 0)) {
            let column = u64::from(location.column.saturating_sub(1));
            window.start = column.saturating_sub(WINDOW_BYTES);
            let wanted_end = column + WINDOW_BYTES;
            let from = window.start.clamp(self.offset, end) - self.offset;
            let to = wanted_end.clamp(self.offset, end) - self.offset;
            // Both are offsets within `piece`.
            window.bytes.extend_from_slice(&piece[from as usize..to as usize]);
            window.cut |= end > wanted_end;
        }
    }
}

/// Turns a window into an excerpt: visible characters, clipped to `WIDTH` around the column. `length`: bytes that the
/// diagnostic marks from the location on.
fn show(location: Location, length: u32, window: &Window) -> Excerpt {
    let column = u64::from(location.column.saturating_sub(1)).saturating_sub(window.start) as usize;
    let marked_end = column + length.max(1) as usize;
    // A window may begin within a UTF-8 character.
    let skipped =
        if window.start > 0 { window.bytes.iter().take_while(|&&byte| byte & 0xC0 == 0x80).count() } else { 0 };
    let cells = cells(&window.bytes[skipped..], skipped);
    let first = cells.iter().position(|(at, _)| *at >= column).unwrap_or(cells.len());
    let after = cells.iter().position(|(at, _)| *at >= marked_end).unwrap_or(cells.len());
    let (from, to) = if cells.len() <= WIDTH && window.start == 0 && !window.cut {
        (0, cells.len())
    } else {
        let from = first.saturating_sub(WIDTH / 2);
        (from, (from + WIDTH).min(cells.len()))
    };
    let cut_left = from > 0 || window.start > 0;
    let cut_right = to < cells.len() || window.cut;
    let mut text = String::new();
    text.extend(cut_left.then_some('…'));
    text.extend(cells[from..to].iter().map(|(_, shown)| shown));
    text.extend(cut_right.then_some('…'));
    Excerpt { text, indent: first - from + usize::from(cut_left), marked: after.min(to).saturating_sub(first).max(1) }
}

/// The visible characters of a text, each with the offset of its first byte.
fn cells(bytes: &[u8], mut at: usize) -> Vec<(usize, char)> {
    let mut cells = Vec::with_capacity(bytes.len());
    for chunk in bytes.utf8_chunks() {
        for character in chunk.valid().chars() {
            cells.push((at, visible(character)));
            at += character.len_utf8();
        }
        for _ in chunk.invalid() {
            cells.push((at, char::REPLACEMENT_CHARACTER));
            at += 1;
        }
    }
    cells
}

/// A character as one visible cell: control characters, which a terminal would execute, become symbols.
pub(crate) fn visible(character: char) -> char {
    match character {
        '\0'..='\u{1f}' => char::from_u32(0x2400 + u32::from(character)).unwrap_or(char::REPLACEMENT_CHARACTER),
        '\u{7f}' => '\u{2421}',
        // The C1 control set, and the marks that reorder or hide text.
        '\u{80}'..='\u{9f}'
        | '\u{ad}'
        | '\u{61c}'
        | '\u{200b}'..='\u{200f}'
        | '\u{2028}'..='\u{202e}'
        | '\u{2060}'..='\u{206f}'
        | '\u{feff}' => char::REPLACEMENT_CHARACTER,
        _ => character,
    }
}
