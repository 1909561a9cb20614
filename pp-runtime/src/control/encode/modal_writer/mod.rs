//! Blocks of which only what changes is written: words, motion code, feed mode, F.
//!
//! The writer owns the modal state, so a word that leaves it is always entered there. [`motion`] and [`arcs`] are its
//! blocks that move the machine; templates, and whatever else changes the state, go through the methods here.

mod arcs;
mod motion;

use std::io::{self, Write};

use crate::control::dialects::{Control, Spellings, Vectors};
use crate::control::layout::Layout;
use crate::control::options::Smoothing;
use crate::motion::{AxisWords, Mode, ToolPosture, VECTOR_DECIMALS};
use crate::nc::{Decimal, Numbering, Numerals, Writer};
use crate::program::Units;

use super::modal_state::{After, LengthState, ModalState};
use super::text::program_name;
use super::values::{Values, text};

/// The words of an axis.
#[derive(Debug, Clone)]
struct Address {
    /// Position in the chain.
    index: usize,
    /// The letters before the number: `X`, `C1=`.
    word: String,
    decimals: u32,
}

/// Writes blocks in the words of a control, and suppresses what is in force.
pub(crate) struct ModalWriter<W: Write> {
    codes: &'static Spellings,
    writer: Writer<W>,
    /// In the order of a block.
    axes: Vec<Address>,
    /// Position of Z in the chain: its word takes a length offset along.
    z: Option<usize>,
    numerals: Numerals,
    /// Every block holds every word.
    every_word: bool,
    smoothing: Smoothing,
    /// How the tool axis is written in the place of rotary words.
    vectors: Option<&'static Vectors>,
    /// Calls the length offset, and with it tip control where the two go together.
    length_code: &'static str,
    /// Side on which the cutter shall run from the next feed block on: left, or right.
    side: Option<bool>,
    modal: ModalState,
    values: Values,
}

/// The axes in the order in which people read them.
fn addresses(control: &dyn Control, layout: &Layout) -> Vec<Address> {
    let mut axes: Vec<(usize, char, u32)> =
        layout.axes.iter().enumerate().map(|(index, &(letter, decimals))| (index, letter, decimals)).collect();
    axes.sort_by_key(|&(_, letter, _)| "XYZUVWABC".chars().position(|known| known == letter));
    axes.into_iter()
        .map(|(index, letter, decimals)| {
            let name = layout.setup.axes.get(&letter).cloned().unwrap_or_else(|| letter.to_string());
            // A name that the control cannot have was refused with the configuration.
            Address { index, word: control.axis_word(&name).unwrap_or(name), decimals }
        })
        .collect()
}

/// How the tool axis moves under tip control, in the words of the control.
fn posture(codes: &Spellings, layout: &Layout) -> &'static str {
    let Some(tip) = &codes.tip else { return "" };
    let words = tip.vectors.as_ref().filter(|_| layout.vectors).map_or(&tip.posture, |vectors| &vectors.posture);
    words[usize::from(layout.posture == ToolPosture::Plane)]
}

/// The code that calls the length offset in a motion.
fn length_code(codes: &Spellings, layout: &Layout, vectors: Option<&Vectors>) -> &'static str {
    let tip = codes.tip.as_ref().filter(|_| layout.mode == Mode::Tcp && layout.setup.tip_control.is_none());
    let code = tip.and_then(|tip| vectors.map_or(tip.with_length, |vectors| vectors.with_length));
    code.unwrap_or(codes.length.code)
}

/// Values that hold for the whole program.
fn values(control: &dyn Control, layout: &Layout, numerals: Numerals) -> Values {
    let (codes, setup) = (control.spellings(), &layout.setup);
    // A tolerance that the format cannot hold was refused with the configuration.
    let path_tolerance = Decimal::fixed(layout.path_tolerance, 6).unwrap_or_default();
    Values {
        name: program_name(codes, layout),
        number: format!("{:0width$}", setup.program_number.unwrap_or(1), width = codes.number_digits),
        units: codes.units[usize::from(layout.units == Units::Inches)],
        work_offset: control.work_offset(&layout.work_offset).unwrap_or_else(|| layout.work_offset.clone()),
        path_tolerance: text(path_tolerance, Numerals { plus: false, ..numerals }),
        angle: setup.smoothing_angle.map(f64::to_degrees),
        turning: codes.turning[usize::from(layout.shortest)],
        posture: posture(codes, layout),
        swivel_data: format!("\"{}\"", setup.swivel_data.as_deref().unwrap_or_default()),
        numerals,
        timed: Numerals { plus: false, point: numerals.point || codes.numerals.point },
        ..Values::default()
    }
}

impl<W: Write> ModalWriter<W> {
    /// A writer that knows of nothing in force yet.
    pub(crate) fn new(control: &dyn Control, layout: &Layout, out: W) -> Self {
        let codes = control.spellings();
        let numerals = Numerals { point: layout.setup.point.unwrap_or(codes.numerals.point), ..codes.numerals };
        let numbering = match (codes.counted, layout.program.line_numbers) {
            (true, _) => Numbering::EveryLine,
            (false, Some(step)) => Numbering::Step(step),
            (false, None) => Numbering::None,
        };
        let vectors = codes.tip.as_ref().and_then(|tip| tip.vectors.as_ref()).filter(|_| layout.vectors);
        Self {
            codes,
            writer: Writer::new(out, numbering),
            axes: addresses(control, layout),
            z: layout.axes.iter().position(|&(letter, _)| letter == 'Z'),
            numerals,
            every_word: layout.setup.every_word,
            smoothing: layout.setup.smoothing,
            vectors,
            length_code: length_code(codes, layout, vectors),
            side: None,
            modal: ModalState::default(),
            values: values(control, layout, numerals),
        }
    }

    /// The table of the control.
    pub(crate) fn codes(&self) -> &'static Spellings {
        self.codes
    }

    pub(crate) fn writer(&self) -> &Writer<W> {
        &self.writer
    }

    /// The writer itself, for lines without modal effect.
    pub(crate) fn writer_mut(&mut self) -> &mut Writer<W> {
        &mut self.writer
    }

    pub(crate) fn modal(&mut self) -> &mut ModalState {
        &mut self.modal
    }

    pub(crate) fn values(&mut self) -> &mut Values {
        &mut self.values
    }

    /// A number as the words of axes have it.
    pub(crate) fn number(&self, number: Decimal) -> String {
        text(number, self.numerals)
    }

    /// A block of one code.
    pub(crate) fn block(&mut self, code: &str) -> io::Result<()> {
        self.writer.code(code);
        self.writer.end()
    }

    /// The code of a template as part of a block.
    pub(crate) fn code(&mut self, template: &str) {
        let code = self.values.fill(template).unwrap_or_default();
        self.writer.code(&code);
    }

    /// The block of a template, if something of it is left.
    pub(crate) fn fill(&mut self, template: &str) -> io::Result<()> {
        match self.values.fill(template) {
            Some(block) => self.block(&block),
            None => Ok(()),
        }
    }

    /// Blocks of templates.
    pub(crate) fn fill_all(&mut self, templates: &[impl AsRef<str>]) -> io::Result<()> {
        templates.iter().try_for_each(|template| self.fill(template.as_ref()))
    }

    /// Lines around the program, which are no blocks.
    pub(crate) fn lines(&mut self, templates: &[&str]) -> io::Result<()> {
        for template in templates {
            if let Some(line) = self.values.fill(template) {
                self.writer.line(line.as_bytes())?;
            }
        }
        Ok(())
    }

    /// Blocks of the configuration: nothing is known after them.
    pub(crate) fn foreign(&mut self, templates: &[String]) -> io::Result<()> {
        for template in templates {
            if let Some(line) = self.values.fill(template) {
                self.raw(line.as_bytes())?;
            }
        }
        Ok(())
    }

    /// A block that is not ours: nothing is known after it.
    pub(crate) fn raw(&mut self, block: &[u8]) -> io::Result<()> {
        self.writer.line(block)?;
        self.modal.forget(After::Anything);
        Ok(())
    }

    /// Whether a word is written though it may be in force.
    #[inline]
    fn writes(&self, changes: bool) -> bool {
        changes || self.every_word
    }

    #[inline]
    fn any_changes(&self, words: &AxisWords) -> bool {
        let z = self.z.filter(|_| matches!(self.modal.length(), LengthState::Pending(_)));
        self.modal.vector_changes(words.vector)
            || self.axes.iter().any(|axis| {
                words.has(axis.index)
                    && (self.modal.axis_changes(axis.index, words.units[axis.index]) || z == Some(axis.index))
            })
    }

    /// Words of axes that change, or all of them.
    #[inline]
    pub(crate) fn axis_words(&mut self, words: &AxisWords, all: bool) {
        for axis in &self.axes {
            if words.has(axis.index) {
                let units = words.units[axis.index];
                let changes = self.modal.axis_changes(axis.index, units);
                self.modal.set_axis(axis.index, units);
                if all || changes || self.every_word {
                    self.writer.word(&axis.word, Decimal { units, decimals: axis.decimals }, self.numerals);
                }
            }
        }
        if let (Some(vectors), Some(vector)) = (self.vectors, words.vector)
            && self.writes(self.modal.vector_changes(words.vector))
        {
            self.modal.set_vector(vector);
            for (word, units) in vectors.words.into_iter().zip(vector) {
                self.writer.word(word, Decimal { units, decimals: VECTOR_DECIMALS }, self.numerals);
            }
        }
    }

    /// A word in the numerals of axes that is always written.
    pub(crate) fn word(&mut self, prefix: &str, number: Decimal) {
        self.writer.word(prefix, number, self.numerals);
    }

    /// The words of a place; the same place once more is written in full.
    pub(crate) fn place_words(&mut self, words: &AxisWords) {
        if !self.any_changes(words) {
            self.modal.forget_axes(words);
        }
        self.axis_words(words, false);
    }

    /// A motion code.
    pub(crate) fn motion(&mut self, code: &'static str) {
        let changes = self.modal.set_motion(code);
        if changes || !self.codes.motion_modal || self.every_word {
            self.writer.code(code);
        }
    }

    /// A feed mode.
    pub(crate) fn feed_mode(&mut self, code: &'static str) {
        let changes = self.modal.set_feed_mode(code);
        if self.writes(changes) {
            self.writer.code(code);
        }
    }

    /// F, whether it is in force or not.
    pub(crate) fn feed_word(&mut self, value: Decimal) {
        let numerals = Numerals { plus: false, ..self.numerals };
        self.writer.word("F", value, numerals);
    }

    fn changed_feed(&mut self, feed: Decimal) {
        let changes = self.modal.set_feed(feed);
        if self.writes(changes) {
            self.feed_word(feed);
        }
    }

    /// Ends the block.
    #[inline]
    pub(crate) fn end(&mut self) -> io::Result<()> {
        self.writer.end()
    }

    /// Decimals of the words of an axis.
    pub(crate) fn decimals(&self, index: usize) -> u32 {
        self.axes.iter().find(|address| address.index == index).map_or(0, |address| address.decimals)
    }

    /// A speed in a block of its own, where the spindle block cannot hold it.
    pub(crate) fn changed_speed(&mut self, speed: Decimal) -> io::Result<()> {
        self.values.speed = Some(speed);
        if let Some(alone) = self.codes.speed
            && self.writes(!self.modal.is_speed(speed))
        {
            self.fill(alone)?;
        }
        self.modal.set_speed(Some(speed));
        Ok(())
    }

    /// Smoothing on or off, where the configuration asks for it.
    pub(crate) fn smooth(&mut self, on: bool) -> io::Result<()> {
        let level = match self.smoothing {
            Smoothing::None => return Ok(()),
            Smoothing::Rough => 0,
            Smoothing::Medium => 1,
            Smoothing::Finish => 2,
        };
        if self.modal.smooths() != on {
            let codes = self.codes;
            self.fill_all(if on { codes.smoothing[level] } else { codes.smoothing_off })?;
            self.modal.set_smoothing(on);
            self.modal.forget(After::Smoothing);
        }
        Ok(())
    }
}
