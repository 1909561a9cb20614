//! Steps of the planner into blocks of a control.

use std::io::{self, Write};

use crate::config::Units;
use crate::motion::{Feed, Sink, Step, Words};
use crate::nc::{Decimal, Writer};

use super::{Control, Spellings};

/// What the words of an axis look like.
#[derive(Debug, Clone, Copy)]
struct Address {
    /// Position in the chain.
    index: usize,
    letter: u8,
    decimals: u32,
}

/// Writes steps in the words of a control, and suppresses what stays in force.
pub struct Encoder<'a, W: Write> {
    control: &'a dyn Control,
    spellings: &'static Spellings,
    writer: Writer<W>,
    axes: Vec<Address>,
    units: Units,
    work_offset: String,
    path_tolerance: Decimal,
    /// The motion code in force.
    motion: &'static str,
    /// The feed mode in force.
    feed_mode: &'static str,
    line: Vec<u8>,
}

/// What an encoder needs to know of the job.
#[derive(Debug, Clone)]
pub struct Layout {
    /// Letters of the axes in chain order, and the decimals of their words; blocks hold them as X Y Z U V W A B C.
    pub axes: Vec<(char, u32)>,
    /// Unit of lengths.
    pub units: Units,
    /// Word of the work offset.
    pub work_offset: String,
    /// How far the control may leave the path where it blends blocks, in `units`.
    pub path_tolerance: f64,
    /// Step of the block numbers, `None` for none.
    pub line_numbers: Option<u32>,
}

/// The axes in the order in which people read them.
fn addresses(layout: &Layout) -> Vec<Address> {
    let address =
        |(index, &(letter, decimals)): (usize, &(char, u32))| Address { index, letter: letter as u8, decimals };
    let mut axes: Vec<Address> = layout.axes.iter().enumerate().map(address).collect();
    axes.sort_by_key(|axis| b"XYZUVWABC".iter().position(|&letter| letter == axis.letter));
    axes
}

impl<'a, W: Write> Encoder<'a, W> {
    /// An encoder that knows of nothing in force yet.
    pub fn new(control: &'a dyn Control, layout: &Layout, out: W) -> Self {
        Self {
            control,
            spellings: control.spellings(),
            writer: Writer::new(out, layout.line_numbers),
            axes: addresses(layout),
            units: layout.units,
            work_offset: layout.work_offset.clone(),
            // A tolerance that the format cannot hold was refused with the configuration.
            path_tolerance: Decimal::fixed(layout.path_tolerance, 6).unwrap_or_default(),
            motion: "",
            feed_mode: "",
            line: Vec::with_capacity(256),
        }
    }

    /// The lines a program of this control begins with.
    ///
    /// # Errors
    /// Those of the output.
    pub fn open(&mut self) -> io::Result<()> {
        for line in self.spellings.opening {
            self.writer.line(line.as_bytes())?;
        }
        Ok(())
    }

    /// A block as it stands; nothing is known to be in force behind it.
    ///
    /// # Errors
    /// Those of the output.
    pub fn raw(&mut self, block: &str) -> io::Result<()> {
        self.writer.line(block.as_bytes())?;
        self.forget();
        Ok(())
    }

    /// A comment, on as many lines as it needs.
    ///
    /// # Errors
    /// Those of the output.
    pub fn comment(&mut self, text: &[u8]) -> io::Result<()> {
        for piece in text.chunks(self.control.comment_length()) {
            self.line.clear();
            self.control.comment(piece, &mut self.line);
            self.writer.line(&self.line)?;
        }
        Ok(())
    }

    /// Blocks written so far, comments not counted.
    pub fn blocks(&self) -> u64 {
        self.writer.blocks()
    }

    /// Hands on what is left.
    ///
    /// # Errors
    /// Those of the output.
    pub fn finish(&mut self) -> io::Result<()> {
        self.writer.finish()
    }

    fn forget(&mut self) {
        self.writer.forget_all();
        self.motion = "";
        self.feed_mode = "";
    }

    fn block(&mut self, code: &str) -> io::Result<()> {
        self.writer.code(code);
        self.writer.end()
    }

    fn commented(&mut self, prefix: &str, text: &[u8]) -> io::Result<()> {
        let mut whole = Vec::with_capacity(prefix.len() + text.len());
        whole.extend_from_slice(prefix.as_bytes());
        whole.extend_from_slice(text);
        self.comment(&whole)
    }

    #[inline]
    fn any_changes(&self, words: &Words) -> bool {
        self.axes.iter().any(|axis| words.has(axis.index) && self.writer.changes(axis.letter, words.units[axis.index]))
    }

    #[inline]
    fn axis_words(&mut self, words: &Words) {
        for axis in &self.axes {
            if words.has(axis.index) {
                let number = Decimal { units: words.units[axis.index], decimals: axis.decimals };
                self.writer.modal(axis.letter, number);
            }
        }
    }

    fn motion(&mut self, code: &'static str) {
        if self.motion != code {
            self.motion = code;
            self.writer.code(code);
        }
    }

    fn feed_mode(&mut self, code: &'static str) {
        if self.feed_mode != code {
            self.feed_mode = code;
            self.writer.code(code);
            self.writer.forget(b'F');
        }
    }
}

impl<W: Write> Sink for Encoder<'_, W> {
    #[inline]
    fn step(&mut self, step: &Step<'_>) -> io::Result<()> {
        let codes = self.spellings;
        match *step {
            Step::Feed { ref words, feed } => {
                if !self.any_changes(words) {
                    return Ok(());
                }
                match feed {
                    Feed::PerMinute(_) => self.feed_mode(codes.per_minute),
                    Feed::InverseTime(_) => self.feed_mode(codes.inverse_time),
                }
                self.motion(codes.feed);
                self.axis_words(words);
                match feed {
                    Feed::PerMinute(value) => self.writer.modal(b'F', value),
                    Feed::InverseTime(value) => {
                        self.writer.word(b'F', value);
                        self.writer.forget(b'F');
                    }
                }
                self.writer.end()
            }
            Step::Rapid { ref words } => {
                if !self.any_changes(words) {
                    return Ok(());
                }
                self.motion(codes.rapid);
                self.axis_words(words);
                self.writer.end()
            }
            Step::Machine { ref words } => {
                self.writer.code(codes.machine);
                self.writer.code(codes.rapid);
                // Not every control keeps the motion code of such a block in force.
                self.motion = "";
                for axis in &self.axes {
                    if words.has(axis.index) {
                        let number = Decimal { units: words.units[axis.index], decimals: axis.decimals };
                        self.writer.word(axis.letter, number);
                        self.writer.forget(axis.letter);
                    }
                }
                self.writer.end()
            }
            Step::Restart { number } => {
                self.forget();
                self.writer.number_next(number);
                self.writer.code(match self.units {
                    Units::Millimetres => codes.millimetres,
                    Units::Inches => codes.inches,
                });
                self.writer.code(codes.cancel);
                self.feed_mode(codes.per_minute);
                self.writer.code(&self.work_offset);
                self.writer.code(codes.blending);
                self.writer.word(codes.blending_address, self.path_tolerance);
                self.writer.end()
            }
            Step::PerMinute => {
                self.feed_mode(codes.per_minute);
                self.writer.end()
            }
            Step::Tool { number, change: true } => {
                self.writer.word(b'T', Decimal { units: number.into(), decimals: 0 });
                self.writer.code(codes.tool_change);
                self.writer.end()?;
                self.writer.forget_all();
                self.motion = "";
                Ok(())
            }
            Step::Tool { number, change: false } => self.comment(format!("T{number} stays in the spindle").as_bytes()),
            Step::Length { offset } => {
                self.writer.code(codes.length);
                self.writer.word(b'H', Decimal { units: offset.into(), decimals: 0 });
                self.writer.end()
            }
            Step::LengthGuard { label, tool, length, tolerance } => {
                for block in self.control.length_guard(label, tool, length, tolerance) {
                    self.writer.line(block.as_bytes())?;
                }
                Ok(())
            }
            Step::Spindle { speed, rotation } => {
                self.writer.word(b'S', speed);
                self.writer.code(codes.rotation(rotation));
                self.writer.end()
            }
            Step::SpindleOff => self.block(codes.spindle_off),
            Step::Dwell { seconds } => {
                self.writer.code(codes.dwell);
                // A dwell that the format cannot hold was refused with the configuration.
                let number = Decimal::fixed(self.control.dwell(seconds), 3).unwrap_or_default();
                self.writer.word(codes.dwell_address, number);
                self.writer.end()
            }
            Step::Coolant { kind } => self.block(codes.coolant(kind).unwrap_or_default()),
            Step::CoolantOff => self.block(codes.coolant_off),
            Step::Stop { optional } => {
                self.block(codes.stop[usize::from(optional)])?;
                self.forget();
                Ok(())
            }
            Step::Operation { name } => self.commented("OPERATION ", name),
            Step::Message { text } => self.comment(text),
            Step::WorkOffset { word } => {
                self.work_offset.clear();
                self.work_offset.push_str(word);
                Ok(())
            }
            Step::Raw { text } => {
                self.writer.line(text)?;
                self.forget();
                Ok(())
            }
            Step::End => self.block(codes.end),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::LinuxCnc;
    use super::*;
    use crate::motion::MAX_AXES;

    fn written(write: impl Fn(&mut Encoder<'_, &mut Vec<u8>>) -> io::Result<()>) -> String {
        let layout = Layout {
            axes: vec![('C', 4), ('A', 4), ('Z', 3), ('X', 3)],
            units: Units::Millimetres,
            work_offset: "G55".into(),
            path_tolerance: 0.01,
            line_numbers: None,
        };
        let mut out = Vec::new();
        let mut encoder = Encoder::new(&LinuxCnc, &layout, &mut out);
        write(&mut encoder).expect("memory takes everything");
        encoder.finish().expect("memory takes everything");
        drop(encoder);
        String::from_utf8(out).expect("ASCII")
    }

    fn words(units: [i64; 4]) -> Words {
        let mut words = Words { units: [0; MAX_AXES], mask: 0b1111 };
        words.units[..4].copy_from_slice(&units);
        words
    }

    #[test]
    fn words_stand_in_the_usual_order_whatever_the_chain_is() {
        let text = written(|encoder| encoder.step(&Step::Rapid { words: words([10_000, -5, 1500, -1]) }));
        assert_eq!(text, "G0 X-0.001 Z1.5 A-0.0005 C1\n");
    }

    #[test]
    fn a_block_in_which_nothing_changes_is_not_written() {
        let feed = Feed::InverseTime(Decimal { units: 5, decimals: 0 });
        let text = written(|encoder| {
            encoder.step(&Step::Rapid { words: words([1, 2, 3, 4]) })?;
            encoder.step(&Step::Feed { words: words([1, 2, 3, 4]), feed })?;
            encoder.step(&Step::Rapid { words: words([1, 2, 3, 4]) })
        });
        assert_eq!(text.lines().count(), 1, "{text}");
    }

    #[test]
    fn everything_is_written_again_behind_a_restart() {
        let per_minute = Feed::PerMinute(Decimal { units: 100, decimals: 0 });
        let text = written(|encoder| {
            encoder.step(&Step::Feed { words: words([0; 4]), feed: per_minute })?;
            encoder.step(&Step::Restart { number: 7 })?;
            encoder.step(&Step::Feed { words: words([0; 4]), feed: per_minute })
        });
        assert_eq!(
            text,
            "G94 G1 X0 Z0 A0 C0 F100\nN7 G21 G17 G40 G49 G80 G90 G94 G55 G64 P0.01\nG1 X0 Z0 A0 C0 F100\n"
        );
    }

    #[test]
    fn a_long_comment_stands_on_lines_that_the_control_reads() {
        let text = written(|encoder| encoder.comment(&[b'('; 1000]));
        assert!(text.lines().all(|line| line.len() < 255 && line.starts_with("([") && line.ends_with("[)")));
        assert_eq!(text.matches('[').count(), 1000);
    }
}
