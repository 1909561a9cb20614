//! Blocks into one reused buffer, flushed in large pieces.

use std::io::{self, Write};

use super::number::{Decimal, write_decimal};

/// Bytes that are collected before they are handed on.
const PIECE: usize = 64 * 1024;

/// Block numbers start again after this one.
const LAST_NUMBER: u32 = 99_999;

/// Writes blocks word by word and remembers the words that stay in force.
///
/// A block without words leaves no line. Words that have not changed since they were last written are left out.
#[derive(Debug)]
pub struct Writer<W: Write> {
    out: W,
    buffer: Vec<u8>,
    /// Where the block begins in the buffer.
    block: usize,
    /// Last written value of each address A to Z, in units of its own decimals.
    modal: [Option<i64>; 26],
    step: Option<u32>,
    next_number: u32,
    /// Number for the next block only, where blocks are not numbered.
    single_number: Option<u32>,
    blocks: u64,
    lines: u64,
}

impl<W: Write> Writer<W> {
    /// `numbers`: step of the block numbers, `None` for none.
    pub fn new(out: W, numbers: Option<u32>) -> Self {
        Self {
            out,
            buffer: Vec::with_capacity(PIECE + 4096),
            block: 0,
            modal: [None; 26],
            step: numbers.filter(|&step| step > 0),
            next_number: numbers.unwrap_or(0),
            single_number: None,
            blocks: 0,
            lines: 0,
        }
    }

    /// Gives the next block a number even where blocks are not numbered.
    pub fn number_next(&mut self, number: u32) {
        self.single_number = Some(number);
    }

    fn separate(&mut self) {
        if self.buffer.len() > self.block {
            self.buffer.push(b' ');
            return;
        }
        let number = match self.step {
            Some(step) => {
                let number = self.next_number;
                self.next_number = if number > LAST_NUMBER - step.min(LAST_NUMBER) { step } else { number + step };
                Some(number)
            }
            None => self.single_number.take(),
        };
        if let Some(number) = number {
            self.buffer.push(b'N');
            write_decimal(&mut self.buffer, Decimal { units: number.into(), decimals: 0 });
            self.buffer.push(b' ');
        }
    }

    /// A code that stands for itself: `G1`, `M30`.
    pub fn code(&mut self, code: &str) {
        if !code.is_empty() {
            self.separate();
            self.buffer.extend_from_slice(code.as_bytes());
        }
    }

    /// A word that is always written.
    pub fn word(&mut self, address: u8, number: Decimal) {
        self.separate();
        self.buffer.push(address);
        write_decimal(&mut self.buffer, number);
    }

    /// Whether a modal word would be written.
    #[inline]
    pub fn changes(&self, address: u8, units: i64) -> bool {
        self.modal[slot(address)] != Some(units)
    }

    /// A word that stays in force: left out while it has the value it had. An address keeps its number of decimals.
    #[inline]
    pub fn modal(&mut self, address: u8, number: Decimal) {
        if self.changes(address, number.units) {
            self.modal[slot(address)] = Some(number.units);
            self.word(address, number);
        }
    }

    /// The value of this address is unknown from here on: its next word is written.
    pub fn forget(&mut self, address: u8) {
        self.modal[slot(address)] = None;
    }

    /// No value is known any more.
    pub fn forget_all(&mut self) {
        self.modal = [None; 26];
    }

    /// Ends the block; a block without words leaves nothing behind.
    ///
    /// # Errors
    /// Those of the output.
    #[inline]
    pub fn end(&mut self) -> io::Result<()> {
        if self.buffer.len() > self.block {
            self.blocks += 1;
            self.finish_line()?;
        }
        Ok(())
    }

    /// A line of its own without number and modal effect: a comment.
    ///
    /// # Errors
    /// Those of the output.
    pub fn line(&mut self, text: &[u8]) -> io::Result<()> {
        self.buffer.extend_from_slice(text);
        self.finish_line()
    }

    #[inline]
    fn finish_line(&mut self) -> io::Result<()> {
        self.buffer.push(b'\n');
        self.lines += 1;
        if self.buffer.len() >= PIECE {
            self.out.write_all(&self.buffer)?;
            self.buffer.clear();
        }
        self.block = self.buffer.len();
        Ok(())
    }

    /// Blocks written so far, comments not counted.
    pub fn blocks(&self) -> u64 {
        self.blocks
    }

    /// Lines written so far; the next one is one more.
    pub fn lines(&self) -> u64 {
        self.lines
    }

    /// Hands on what is left.
    ///
    /// # Errors
    /// Those of the output.
    pub fn finish(&mut self) -> io::Result<()> {
        self.out.write_all(&self.buffer)?;
        self.buffer.clear();
        self.block = 0;
        self.out.flush()
    }
}

fn slot(address: u8) -> usize {
    usize::from(address.wrapping_sub(b'A')).min(25)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn thousandths(units: i64) -> Decimal {
        Decimal { units, decimals: 3 }
    }

    fn written(numbers: Option<u32>, write: impl Fn(&mut Writer<&mut Vec<u8>>) -> io::Result<()>) -> String {
        let mut out = Vec::new();
        let mut writer = Writer::new(&mut out, numbers);
        write(&mut writer).expect("memory takes everything");
        writer.finish().expect("memory takes everything");
        String::from_utf8(out).expect("ASCII")
    }

    #[test]
    fn a_word_that_has_not_changed_is_written_once() {
        let text = written(None, |writer| {
            for x in [1000, 1000, 2000] {
                writer.modal(b'X', thousandths(x));
                writer.modal(b'Y', thousandths(500));
                writer.end()?;
            }
            Ok(())
        });
        assert_eq!(text, "X1 Y0.5\nX2\n");
    }

    #[test]
    fn a_forgotten_word_is_written_again() {
        let text = written(None, |writer| {
            for _ in 0..2 {
                writer.modal(b'X', thousandths(0));
                writer.modal(b'Z', thousandths(0));
                writer.end()?;
                writer.forget(b'Z');
            }
            Ok(())
        });
        assert_eq!(text, "X0 Z0\nZ0\n");
    }

    #[test]
    fn blocks_are_numbered_and_comments_are_not() {
        let text = written(Some(10), |writer| {
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
        let text = written(Some(50_000), |writer| {
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
        let text = written(None, |writer| {
            writer.number_next(3);
            writer.code("G90");
            writer.end()?;
            writer.code("G0");
            writer.end()
        });
        assert_eq!(text, "N3 G90\nG0\n");
    }

    #[test]
    fn a_long_program_is_handed_on_in_pieces_and_whole() {
        let text = written(None, |writer| {
            for x in 0..50_000 {
                writer.modal(b'X', thousandths(x));
                writer.end()?;
            }
            Ok(())
        });
        assert_eq!(text.lines().count(), 50_000);
        assert!(text.ends_with("X49.999\n"));
    }
}
