//! Writer of blocks: one reused buffer, handed to the output in large pieces. It has no modal state.

use std::borrow::Cow;
use std::io::{self, Write};
use std::iter;

use super::number::{Decimal, NUMBER_ROOM, Numerals, ShortForm, put_number};

/// Number of bytes collected before they are written to the output.
const PIECE: usize = 64 * 1024;

/// Largest block number; numbering starts again after it.
const LAST_NUMBER: u32 = 99_999;

/// Numbering of lines.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) enum Numbering {
    /// Numbers only for blocks after [`Writer::number_next`].
    #[default]
    None,
    /// `N10`, `N20`: blocks are numbered in this step, comments are not.
    Step(u32),
    /// `0`, `1`, `2`: every line is numbered, without N and without a largest number.
    EveryLine,
}

/// Line of a program that was written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct WrittenLine {
    /// Line number in the file, from 1.
    pub line: u64,
    /// Block number, if it has one.
    pub number: Option<u32>,
}

/// Letters of a word, `X` or `C1=`, and the form of its numbers.
#[derive(Debug, Clone)]
pub(crate) struct WordForm<'l> {
    letters: Cow<'l, str>,
    decimals: u32,
    numerals: Numerals,
    short: ShortForm,
}

impl<'l> WordForm<'l> {
    /// A word with numbers of these decimals.
    #[must_use]
    pub(crate) fn new(letters: impl Into<Cow<'l, str>>, decimals: u32, numerals: Numerals) -> Self {
        let letters = letters.into();
        Self { short: ShortForm::new(&letters, decimals, numerals), letters, decimals, numerals }
    }

    /// Its letters.
    #[must_use]
    pub(crate) fn letters(&self) -> &str {
        &self.letters
    }

    /// Decimals of its numbers.
    #[must_use]
    pub(crate) fn decimals(&self) -> u32 {
        self.decimals
    }
}

/// Writes blocks word by word; a block without words writes no line.
pub(crate) struct Writer<'a> {
    out: &'a mut dyn Write,
    /// Written blocks, then room.
    buffer: Vec<u8>,
    /// End of the text in the buffer.
    end: usize,
    /// Start of the current block in the buffer.
    block: usize,
    numbering: Numbering,
    number_word: WordForm<'static>,
    next_number: u32,
    /// Number for the next block only, where blocks are not numbered.
    single_number: Option<u32>,
    blocks: u64,
    /// Number of the current block.
    number: Option<u32>,
    /// Lines begin with the mark of block skip.
    skippable: bool,
    journal: Option<Journal>,
}

/// Record of the lines that were written.
#[derive(Debug, Default)]
struct Journal {
    lines: u64,
    /// Lines since the last call of [`Writer::take_lines`].
    kept: Vec<WrittenLine>,
}

impl Journal {
    /// Adds the lines of a block; its number is in the first one.
    fn add(&mut self, text: &[u8], number: Option<u32>) {
        let ends = text.iter().filter(|&&byte| byte == b'\n').count();
        for index in 0..ends {
            self.lines += 1;
            self.kept.push(WrittenLine { line: self.lines, number: number.filter(|_| index == 0) });
        }
    }
}

impl<'a> Writer<'a> {
    /// A writer for a new program.
    pub(crate) fn new(out: &'a mut dyn Write, numbering: Numbering) -> Self {
        let letters = if numbering == Numbering::EveryLine { "" } else { "N" };
        Self {
            out,
            buffer: vec![0; PIECE + 4096],
            end: 0,
            block: 0,
            numbering,
            number_word: WordForm::new(letters, 0, Numerals::default()),
            next_number: if let Numbering::Step(step) = numbering { step } else { 0 },
            single_number: None,
            blocks: 0,
            number: None,
            skippable: false,
            journal: None,
        }
    }

    /// Gives the next block a number even where blocks are not numbered.
    pub(crate) fn number_next(&mut self, number: u32) {
        self.single_number = Some(number);
    }

    /// Begins each line from here on with `/`, the mark of block skip, or no longer.
    pub(crate) fn set_skippable(&mut self, skippable: bool) {
        self.skippable = skippable;
    }

    fn append(&mut self, text: &[u8]) {
        self.end = put_text(&mut self.buffer, self.end, text);
    }

    /// Begins a block, if none is begun. In a block a blank follows each word; that after the last becomes the line
    /// feed.
    #[inline]
    fn begin(&mut self) {
        let is_new = self.end == self.block;
        if is_new && (self.skippable || self.numbering != Numbering::None || self.single_number.is_some()) {
            self.begin_block();
        }
    }

    fn begin_block(&mut self) {
        self.mark_skippable();
        match self.numbering {
            Numbering::Step(step) => {
                let number = self.next_number;
                self.next_number = if number > LAST_NUMBER - step.min(LAST_NUMBER) { step } else { number + step };
                self.number(number);
            }
            Numbering::EveryLine => self.number_line(),
            Numbering::None => {
                if let Some(number) = self.single_number.take() {
                    self.number(number);
                }
            }
        }
    }

    fn mark_skippable(&mut self) {
        if self.skippable {
            self.append(b"/");
        }
    }

    /// Writes the number of a line, where every line has one.
    fn number_line(&mut self) {
        let number = self.next_number;
        self.next_number += 1;
        self.number(number);
    }

    fn number(&mut self, number: u32) {
        self.number = Some(number);
        let word = Some((&self.number_word, number.into()));
        self.end = put_words(&mut self.buffer, self.end, word, iter::empty());
    }

    /// Writes a code with a fixed number: `G1`, `M30`.
    pub(crate) fn code(&mut self, code: &str) {
        if !code.is_empty() {
            self.begin();
            self.append(code.as_bytes());
            self.append(b" ");
        }
    }

    /// Adds text to the last word.
    pub(crate) fn attach(&mut self, text: &str) {
        if self.end > self.block {
            self.end -= 1;
            self.append(text.as_bytes());
            self.append(b" ");
        }
    }

    /// Writes a word: `X` or `C1=`, and its number.
    pub(crate) fn word(&mut self, prefix: &str, number: Decimal, numerals: Numerals) {
        self.words([(&WordForm::new(prefix, number.decimals, numerals), number.units)]);
    }

    /// Writes words in their order, each with whole units of its last decimal; without words no block begins.
    #[inline(always)]
    pub(crate) fn words<'w>(&mut self, words: impl IntoIterator<Item = (&'w WordForm<'w>, i64)>) {
        let mut words = words.into_iter();
        let first = words.next();
        if first.is_some() {
            self.begin();
        }
        self.end = put_words(&mut self.buffer, self.end, first, words);
    }

    /// Ends the block; a block without words writes no line.
    ///
    /// # Errors
    /// Errors of the output.
    #[inline]
    pub(crate) fn end(&mut self) -> io::Result<()> {
        if self.end > self.block {
            self.blocks += 1;
            // In place of the blank after the last word.
            self.buffer[self.end - 1] = b'\n';
            self.finish_line()?;
        }
        Ok(())
    }

    /// Writes a line without modal effect, such as a comment; it is numbered only where every line is.
    ///
    /// # Errors
    /// Errors of the output.
    pub(crate) fn line(&mut self, text: &[u8]) -> io::Result<()> {
        self.mark_skippable();
        if self.numbering == Numbering::EveryLine {
            self.number_line();
        }
        self.append(text);
        self.append(b"\n");
        self.finish_line()
    }

    /// Takes the line that has ended.
    #[inline(always)]
    fn finish_line(&mut self) -> io::Result<()> {
        if let Some(journal) = &mut self.journal {
            journal.add(&self.buffer[self.block..self.end], self.number);
        }
        self.number = None;
        self.block = self.end;
        if self.end >= PIECE { self.hand_on() } else { Ok(()) }
    }

    /// Writes the buffer to the output.
    fn hand_on(&mut self) -> io::Result<()> {
        self.out.write_all(&self.buffer[..self.end])?;
        (self.end, self.block) = (0, 0);
        Ok(())
    }

    /// Records the lines from now on; [`take_lines`](Self::take_lines) returns them.
    pub(crate) fn keep_lines(&mut self) {
        self.journal = Some(Journal::default());
    }

    /// Returns the lines since the last call; none if they are not recorded.
    pub(crate) fn take_lines(&mut self) -> impl Iterator<Item = WrittenLine> + '_ {
        self.journal.iter_mut().flat_map(|journal| journal.kept.drain(..))
    }

    /// Number of blocks written so far, without comments.
    pub(crate) fn blocks(&self) -> u64 {
        self.blocks
    }

    /// Writes the rest of the buffer to the output.
    ///
    /// # Errors
    /// Errors of the output.
    pub(crate) fn finish(&mut self) -> io::Result<()> {
        self.hand_on()?;
        self.out.flush()
    }
}

/// Puts words at `end`, each with a blank after it; returns their end.
#[inline(always)]
fn put_words<'w>(
    buffer: &mut Vec<u8>,
    end: usize,
    first: Option<(&'w WordForm<'w>, i64)>,
    mut others: impl Iterator<Item = (&'w WordForm<'w>, i64)>,
) -> usize {
    let mut rest = &mut buffer[end..];
    let mut next = first;
    while let Some((form, units)) = next {
        match rest.first_chunk_mut().and_then(|room| form.short.put(room, units)) {
            Some(length) => rest = &mut rest[length..],
            None => {
                let left = rest.len();
                let end = put_long_word(buffer, buffer.len() - left, form, units);
                rest = &mut buffer[end..];
            }
        }
        next = others.next();
    }
    let left = rest.len();
    buffer.len() - left
}

/// Puts a word of any length and a blank at `end`; returns their end.
#[cold]
fn put_long_word(buffer: &mut Vec<u8>, end: usize, form: &WordForm<'_>, units: i64) -> usize {
    let mut room = [0; NUMBER_ROOM];
    let length = put_number(&mut room, Decimal { units, decimals: form.decimals }, form.numerals);
    let end = put_text(buffer, end, form.letters.as_bytes());
    put_text(buffer, end, &room[..length])
}

/// Puts text at `end`; returns its end.
fn put_text(buffer: &mut Vec<u8>, end: usize, text: &[u8]) -> usize {
    if buffer.len() - end < text.len() {
        grow(buffer, end + text.len());
    }
    buffer[end..end + text.len()].copy_from_slice(text);
    end + text.len()
}

#[cold]
fn grow(buffer: &mut Vec<u8>, least: usize) {
    buffer.resize(least + PIECE, 0);
}

#[cfg(test)]
mod tests {
    use super::*;

    fn thousandths(units: i64) -> Decimal {
        Decimal { units, decimals: 3 }
    }

    fn written(numbering: Numbering, write: impl Fn(&mut Writer<'_>) -> io::Result<()>) -> String {
        let mut out = Vec::new();
        let mut writer = Writer::new(&mut out, numbering);
        write(&mut writer).expect("memory takes everything");
        writer.finish().expect("memory takes everything");
        String::from_utf8(out).expect("ASCII")
    }

    #[test]
    fn blocks_are_numbered_and_comments_are_not() {
        let text = written(Numbering::Step(10), |writer| {
            writer.code("G0");
            writer.end()?;
            writer.line(b"(A)")?;
            writer.end()?;
            writer.code("M2");
            writer.end()
        });
        assert_eq!(text, "N10 G0\n(A)\nN20 M2\n");
    }

    #[test]
    fn block_numbers_start_again_before_they_have_six_digits() {
        let text = written(Numbering::Step(50_000), |writer| {
            for _ in 0..3 {
                writer.code("G0");
                writer.end()?;
            }
            Ok(())
        });
        assert_eq!(text, "N50000 G0\nN50000 G0\nN50000 G0\n");
    }

    #[test]
    fn a_number_can_be_given_to_one_block_alone() {
        let text = written(Numbering::None, |writer| {
            writer.number_next(3);
            writer.code("G90");
            writer.end()?;
            writer.code("G0");
            writer.end()
        });
        assert_eq!(text, "N3 G90\nG0\n");
    }

    #[test]
    fn lines_that_may_be_skipped_begin_with_their_mark_before_the_number() {
        let text = |numbering| {
            written(numbering, |writer| {
                writer.code("G0");
                writer.end()?;
                writer.set_skippable(true);
                writer.end()?;
                writer.word("X", thousandths(1), Numerals::default());
                writer.code("M8");
                writer.end()?;
                writer.line(b"(A)")?;
                writer.set_skippable(false);
                writer.code("M2");
                writer.end()
            })
        };
        assert_eq!(text(Numbering::None), "G0\n/X0.001 M8\n/(A)\nM2\n");
        assert_eq!(text(Numbering::Step(5)), "N5 G0\n/N10 X0.001 M8\n/(A)\nN15 M2\n");
        assert_eq!(text(Numbering::EveryLine), "0 G0\n/1 X0.001 M8\n/2 (A)\n3 M2\n");
    }

    #[test]
    fn a_long_program_is_handed_on_in_pieces_and_whole() {
        let text = written(Numbering::None, |writer| {
            for x in 0..50_000 {
                writer.word("X", thousandths(x), Numerals::default());
                writer.end()?;
            }
            Ok(())
        });
        assert_eq!(text.lines().count(), 50_000);
        assert!(text.ends_with("X49.999\n"));
    }

    #[test]
    fn words_are_written_whole_where_the_buffer_ends_and_where_they_are_long() {
        let words = [
            WordForm::new("X", 3, Numerals::default()),
            WordForm::new("SPINDLE=", 3, Numerals { point: true, plus: true }),
            WordForm::new("Y", 9, Numerals::default()),
        ];
        let text = written(Numbering::None, |writer| {
            for _ in 0..3 {
                writer.words((0..10_000).flat_map(|_| words.iter().map(|word| (word, -1500))));
                writer.words([(&words[0], 1_000_000_000)]);
                writer.end()?;
            }
            Ok(())
        });
        assert_eq!(
            text,
            ["X-1.5 SPINDLE=-1.5 Y-0.0000015 ".repeat(10_000), "X1000000\n".to_owned()].concat().repeat(3)
        );
    }

    #[test]
    fn where_every_line_is_counted_comments_are_too_and_no_number_is_left_out() {
        let text = written(Numbering::EveryLine, |writer| {
            writer.line(b"BEGIN")?;
            writer.number_next(7);
            writer.code("L");
            writer.end()?;
            writer.end()?;
            writer.line(b"; A")
        });
        assert_eq!(text, "0 BEGIN\n1 L\n2 ; A\n");
    }
}
