//! Steps of the planner into blocks of a control.

use std::io::{self, Write};

use crate::config::Units;
use crate::motion::{Feed, Sink, Step, Words};
use crate::nc::{Decimal, Writer};

use super::{Control, Spellings};

/// What the words of an axis look like.
#[derive(Debug, Clone, Copy)]
struct Address {
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
    /// The motion code in force.
    motion: &'static str,
    /// The feed mode in force.
    feed_mode: &'static str,
    line: Vec<u8>,
}

/// What an encoder needs to know of the job.
#[derive(Debug, Clone)]
pub struct Layout {
    /// Letters of the axes in chain order, and the decimals of their words.
    pub axes: Vec<(char, u32)>,
    /// Unit of lengths.
    pub units: Units,
    /// Word of the work offset.
    pub work_offset: String,
    /// Step of the block numbers, `None` for none.
    pub line_numbers: Option<u32>,
}

impl<'a, W: Write> Encoder<'a, W> {
    /// An encoder that knows of nothing in force yet.
    pub fn new(control: &'a dyn Control, layout: &Layout, out: W) -> Self {
        Self {
            control,
            spellings: control.spellings(),
            writer: Writer::new(out, layout.line_numbers),
            axes: layout.axes.iter().map(|&(letter, decimals)| Address { letter: letter as u8, decimals }).collect(),
            units: layout.units,
            work_offset: layout.work_offset.clone(),
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
        self.axes.iter().enumerate().any(|(i, axis)| words.has(i) && self.writer.changes(axis.letter, words.units[i]))
    }

    #[inline]
    fn axis_words(&mut self, words: &Words) {
        for (i, axis) in self.axes.iter().enumerate() {
            if words.has(i) {
                self.writer.modal(axis.letter, Decimal { units: words.units[i], decimals: axis.decimals });
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
                for (i, axis) in self.axes.iter().enumerate() {
                    if words.has(i) {
                        self.writer.word(axis.letter, Decimal { units: words.units[i], decimals: axis.decimals });
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
            Step::End => self.block(codes.end),
        }
    }
}
