//! Writer of blocks that leaves out modal words in force: axis words, motion code, feed mode, F.
//!
//! The writer owns the modal state and enters every word that it writes. [`motion`], [`arcs`] and [`retract`] write the
//! blocks that move the machine; the methods here write templates and everything else that changes the state.

mod arcs;
mod motion;
mod retract;

use std::io::{self, Write};

use crate::control::dialects::{Control, RetractForm, Spellings, ToolAxisWords};
use crate::control::layout::Layout;
use crate::control::options::BlockNumbers;
use crate::motion::{AxisWords, VECTOR_DECIMALS};
use crate::nc::{Decimal, Numbering, Numerals, WordForm, Writer};
use crate::options::{Smoothing, ToolPosture};
use crate::program::Units;

use super::modal_state::{After, LengthState, ModalState, SmoothingState};
use super::text::program_name;
use super::values::{Values, text};

/// Words of an axis.
#[derive(Debug, Clone)]
struct AxisAddress {
    /// Index in the chain.
    index: usize,
    /// Its bit in the masks of axis words.
    bit: u16,
    word: WordForm<'static>,
    linear: bool,
    /// Text after the number: `)` of `C=DC(350)`.
    after: &'static str,
}

/// Smoothing, each with its tolerance in the unit of the program.
struct SmoothingOfCuts {
    /// Of the configuration.
    usual: (Smoothing, Decimal),
    /// Of the cuts that come.
    wanted: (Smoothing, Decimal),
    /// Numbers of the levels.
    levels: Option<[u32; 3]>,
    /// Tolerance of the blending in force, where the safety blocks state it.
    blending: Decimal,
}

/// Tip control as far as its codes are those of other functions.
struct TipControlState {
    /// Code that calls the length offset and switches it on, where one does both.
    length_code: Option<&'static str>,
    /// It is on, or comes on with the next length offset.
    is_on: bool,
    /// It may have cancelled the work offset.
    offset_lost: bool,
    /// It ends with the code that cancels the length offset, in the next block of machine coordinates.
    ends: bool,
}

/// Writes blocks in the codes of a control, and leaves out words that are in force.
pub(crate) struct ModalWriter<'a> {
    codes: &'static Spellings,
    writer: Writer<'a>,
    /// Axes in the order of their words in a block.
    axes: Vec<AxisAddress>,
    /// A word of an axis has text after its number.
    has_shortest: bool,
    /// F with each number of decimals.
    feed_words: [WordForm<'static>; 7],
    /// Words of the centre of an arc: distances from its start along X, Y and Z.
    centre_words: [WordForm<'static>; 3],
    /// Index of Z in the chain: a length offset may be called with its word.
    z: Option<usize>,
    numerals: Numerals,
    /// Every block holds every word.
    every_word: bool,
    smoothing: SmoothingOfCuts,
    /// Unit of lengths, mm.
    unit_mm: f64,
    /// Words for the tool axis as a vector, where it is written instead of rotary words.
    vectors: Option<&'static ToolAxisWords>,
    vector_words: [WordForm<'static>; 3],
    tip: TipControlState,
    /// Machine retract of the control, and the blocks that take its place.
    retract: Option<RetractForm>,
    own_retract: Vec<String>,
    /// Side of cutter compensation from the next feed block on, true for left; `None`: off.
    side: Option<bool>,
    modal: ModalState,
    values: Values,
}

/// Words of the axes in the usual order of a block, X Y Z U V W A B C.
fn addresses(control: &dyn Control, layout: &Layout, numerals: Numerals) -> Vec<AxisAddress> {
    let mut axes: Vec<(usize, char, u32)> =
        layout.axes.iter().enumerate().map(|(index, &(letter, decimals))| (index, letter, decimals)).collect();
    axes.sort_by_key(|&(_, letter, _)| "XYZUVWABC".chars().position(|known| known == letter));
    axes.into_iter()
        .map(|(index, letter, decimals)| {
            let name = layout.options.axes.get(&letter).cloned().unwrap_or_else(|| letter.to_string());
            // The configuration was refused if the control permits no axis of this name.
            let name = control.axis_word(&name).unwrap_or(name);
            let shortest = control.spellings().shortest_word.filter(|_| layout.shortest_axes.contains(&letter));
            let (name, after) = match shortest {
                Some([before, after]) => (format!("{}{before}", name.trim_end_matches('=')), after),
                None => (name, ""),
            };
            let word = WordForm::new(name, decimals, numerals);
            AxisAddress { index, bit: 1 << index, word, linear: "XYZUVW".contains(letter), after }
        })
        .collect()
}

/// Code for the motion of the tool axis under tip control.
fn posture(codes: &Spellings, layout: &Layout) -> &'static str {
    let Some(tip) = &codes.tip else { return "" };
    let words = tip.vectors.as_ref().filter(|_| layout.vectors).map_or(&tip.posture, |vectors| &vectors.posture);
    words[usize::from(layout.posture == ToolPosture::Plane)]
}

/// Code that calls the length offset and switches on tip control, where one does both.
fn tip_length_code(codes: &Spellings, layout: &Layout, vectors: Option<&ToolAxisWords>) -> Option<&'static str> {
    let tip = codes.tip.as_ref().filter(|_| layout.options.tip_control_codes().is_none())?;
    vectors.map_or(tip.with_length, |vectors| vectors.with_length)
}

/// A tolerance in the unit of the program. The configuration was refused if it cannot be written with six decimals.
fn path_tolerance(tolerance: f64) -> Decimal {
    Decimal::fixed(tolerance, 6).unwrap_or_default()
}

/// Values of the template fields at the start of the program.
fn values(control: &dyn Control, layout: &Layout, numerals: Numerals) -> Values {
    let (codes, options) = (control.spellings(), &layout.options);
    let path_tolerance = path_tolerance(layout.path_tolerance);
    Values {
        name: program_name(codes, layout),
        number: format!("{:0width$}", options.program_number.unwrap_or(1), width = codes.number_digits),
        units: codes.units[usize::from(layout.units == Units::Inches)],
        work_offset: control.work_offset(&layout.work_offset).unwrap_or_else(|| layout.work_offset.clone()),
        path_tolerance: text(path_tolerance, Numerals { plus: false, ..numerals }),
        angle_deg: options.smoothing_angle_rad.map(f64::to_degrees),
        rotary_path: codes.rotary_path[usize::from(!layout.shortest_axes.is_empty())],
        posture: options.posture_word.then(|| posture(codes, layout)),
        swivel_data: format!("\"{}\"", options.swivel_data.as_deref().unwrap_or_default()),
        numerals,
        dwell_numerals: Numerals { plus: false, point: numerals.point || codes.numerals.point },
        ..Values::default()
    }
}

impl<'a> ModalWriter<'a> {
    /// A writer for a new program: the modal state of the control is unknown.
    pub(crate) fn new(control: &dyn Control, layout: &Layout, out: &'a mut dyn Write) -> Self {
        let codes = control.spellings();
        let numerals = Numerals { point: layout.options.point.unwrap_or(codes.numerals.point), ..codes.numerals };
        let numbering = match (codes.numbers_every_line, layout.program.line_numbers) {
            (true, _) => Numbering::EveryLine,
            (false, BlockNumbers::Step(step)) => Numbering::Step(step),
            (false, BlockNumbers::Restarts | BlockNumbers::ToolChanges | BlockNumbers::None) => Numbering::None,
        };
        let vectors = codes.tip.as_ref().and_then(|tip| tip.vectors.as_ref()).filter(|_| layout.vectors);
        let axes = addresses(control, layout, numerals);
        let smoothing = (layout.options.smoothing, path_tolerance(layout.path_tolerance));
        Self {
            codes,
            writer: Writer::new(out, numbering),
            has_shortest: axes.iter().any(|axis| !axis.after.is_empty()),
            axes,
            feed_words: std::array::from_fn(|decimals| {
                WordForm::new("F", decimals as u32, Numerals { plus: false, ..numerals })
            }),
            centre_words: ["I", "J", "K"].map(|letter| WordForm::new(letter, layout.linear, numerals)),
            z: layout.axes.iter().position(|&(letter, _)| letter == 'Z'),
            numerals,
            every_word: layout.options.every_word,
            smoothing: SmoothingOfCuts {
                usual: smoothing,
                wanted: smoothing,
                levels: layout.options.smoothing_levels,
                blending: smoothing.1,
            },
            unit_mm: layout.units.in_mm(),
            vectors,
            vector_words: vectors
                .map_or([""; 3], |vectors| vectors.words)
                .map(|letters| WordForm::new(letters, VECTOR_DECIMALS, numerals)),
            tip: TipControlState {
                length_code: tip_length_code(codes, layout, vectors),
                is_on: false,
                offset_lost: false,
                ends: false,
            },
            retract: layout.options.retract_form(codes),
            own_retract: layout.options.own_retract().cloned().unwrap_or_default(),
            side: None,
            modal: ModalState::default(),
            values: values(control, layout, numerals),
        }
    }

    /// Table of the control.
    pub(crate) fn codes(&self) -> &'static Spellings {
        self.codes
    }

    pub(crate) fn writer(&self) -> &Writer<'a> {
        &self.writer
    }

    /// Underlying writer, for lines without modal effect.
    pub(crate) fn writer_mut(&mut self) -> &mut Writer<'a> {
        &mut self.writer
    }

    pub(crate) fn modal(&mut self) -> &mut ModalState {
        &mut self.modal
    }

    pub(crate) fn values(&mut self) -> &mut Values {
        &mut self.values
    }

    /// Notes that tip control is on, or off; `with_length`: it ends with the code that cancels the length offset.
    pub(crate) fn set_tip_control(&mut self, on: bool, with_length: bool) {
        self.tip.is_on = on;
        self.tip.ends = !on && with_length;
    }

    /// Notes that the work offset may have been cancelled, or is in force.
    pub(crate) fn set_offset_lost(&mut self, lost: bool) {
        self.tip.offset_lost = lost;
    }

    /// Writes the work offset, if it may have been cancelled.
    pub(crate) fn restate_offset(&mut self) -> io::Result<()> {
        if std::mem::take(&mut self.tip.offset_lost) { self.fill("{work_offset}") } else { Ok(()) }
    }

    /// A number in the form of axis words.
    pub(crate) fn number(&self, number: Decimal) -> String {
        text(number, self.numerals)
    }

    /// A number in the form of axis words, without a sign of its own.
    pub(crate) fn size(&self, number: Decimal) -> String {
        text(number, Numerals { plus: false, ..self.numerals })
    }

    /// Writes a block of one code.
    pub(crate) fn block(&mut self, code: &str) -> io::Result<()> {
        self.writer.code(code);
        self.writer.end()
    }

    /// Writes the code of a template as part of a block.
    pub(crate) fn code(&mut self, template: &str) {
        let code = self.values.fill(template).unwrap_or_default();
        self.writer.code(&code);
    }

    /// Writes the block of a template, unless it is left out.
    pub(crate) fn fill(&mut self, template: &str) -> io::Result<()> {
        match self.values.fill(template) {
            Some(block) => self.block(&block),
            None => Ok(()),
        }
    }

    /// Writes the blocks of templates.
    pub(crate) fn fill_all(&mut self, templates: &[impl AsRef<str>]) -> io::Result<()> {
        templates.iter().try_for_each(|template| self.fill(template.as_ref()))
    }

    /// Writes lines before or after the program that are not blocks.
    pub(crate) fn lines(&mut self, templates: &[&str]) -> io::Result<()> {
        for template in templates {
            if let Some(line) = self.values.fill(template) {
                self.writer.line(line.as_bytes())?;
            }
        }
        Ok(())
    }

    /// Writes blocks of the configuration; the modal state is unknown after them.
    pub(crate) fn configured_blocks(&mut self, templates: &[String]) -> io::Result<()> {
        for template in templates {
            if let Some(line) = self.values.fill(template) {
                self.raw(line.as_bytes())?;
            }
        }
        Ok(())
    }

    /// Writes a block as it is; the modal state is unknown after it.
    pub(crate) fn raw(&mut self, block: &[u8]) -> io::Result<()> {
        self.writer.line(block)?;
        self.modal.forget(After::Anything);
        Ok(())
    }

    /// Whether a word is written: it changes, or every word is written.
    #[inline]
    fn writes(&self, changes: bool) -> bool {
        changes || self.every_word
    }

    #[inline]
    fn any_changes(&self, words: &AxisWords) -> bool {
        self.changes_with(words, self.modal.changed_axes(words))
    }

    /// Whether a block with these words is written, of which those of these axes change.
    #[inline]
    fn changes_with(&self, words: &AxisWords, changed: u16) -> bool {
        let z = self.z.filter(|_| self.has_pending_length());
        changed != 0 || self.modal.vector_changes(words.vector) || z.is_some_and(|z| words.has(z))
    }

    /// Whether a length offset is called by the next motion.
    #[inline]
    fn has_pending_length(&self) -> bool {
        matches!(self.modal.length(), LengthState::Pending(_))
    }

    /// Writes the words of the axes that change, or of all axes.
    #[inline]
    pub(crate) fn axis_words(&mut self, words: &AxisWords, all: bool) {
        let written = if all { words.mask } else { self.modal.changed_axes(words) };
        self.words_of(words, written);
    }

    /// Writes the words of these axes, or of all where every word is written.
    #[inline(always)]
    fn words_of(&mut self, words: &AxisWords, written: u16) {
        let written = if self.every_word { words.mask } else { written };
        let changed = self.axes.iter().filter(|axis| written & axis.bit != 0);
        if self.has_shortest {
            for axis in changed {
                self.writer.words([(&axis.word, words.units[axis.index])]);
                self.writer.attach(axis.after);
            }
        } else {
            self.writer.words(changed.map(|axis| (&axis.word, words.units[axis.index])));
        }
        self.modal.set_axes(words, written);
        if let Some(vector) = words.vector
            && self.vectors.is_some()
            && self.writes(self.modal.vector_changes(words.vector))
        {
            self.modal.set_vector(vector);
            self.writer.words(self.vector_words.iter().zip(vector));
        }
    }

    /// Name and position of each axis of some words, degrees.
    pub(crate) fn positions(&self, words: &AxisWords) -> Vec<(String, f64)> {
        let position =
            |address: &AxisAddress| words.units[address.index] as f64 / 10_f64.powi(address.word.decimals() as i32);
        let rotary = self.axes.iter().filter(|address| words.has(address.index));
        rotary
            .map(|address| (address.word.letters().split('=').next().unwrap_or_default().to_owned(), position(address)))
            .collect()
    }

    /// Writes a word in the number format of axes, whether it is in force or not.
    pub(crate) fn word(&mut self, prefix: &str, number: Decimal) {
        self.writer.word(prefix, number, self.numerals);
    }

    /// Writes the words of a position that change; if none changes, all of them.
    pub(crate) fn place_words(&mut self, words: &AxisWords) {
        if !self.any_changes(words) {
            self.modal.forget_axes(words);
        }
        self.axis_words(words, false);
    }

    /// Writes a motion code, unless it is in force.
    pub(crate) fn motion(&mut self, code: &'static str) {
        let changes = self.modal.set_motion(code);
        if changes || !self.codes.motion_modal || self.every_word {
            self.writer.code(code);
        }
    }

    /// Writes a feed mode, unless it is in force.
    pub(crate) fn feed_mode(&mut self, code: &'static str) {
        let changes = self.modal.set_feed_mode(code);
        if self.writes(changes) {
            self.writer.code(code);
        }
    }

    /// Writes F, whether it is in force or not.
    #[inline(always)]
    pub(crate) fn feed_word(&mut self, value: Decimal) {
        match self.feed_words.get(value.decimals as usize) {
            Some(form) => self.writer.words([(form, value.units)]),
            None => self.small_feed_word(value),
        }
    }

    /// Writes F with more decimals than are usual.
    #[cold]
    fn small_feed_word(&mut self, value: Decimal) {
        self.writer.word("F", value, Numerals { plus: false, ..self.numerals });
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
        self.axes.iter().find(|address| address.index == index).map_or(0, |address| address.word.decimals())
    }

    /// Enters a spindle speed; writes it in its own block, where the spindle block does not hold it.
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

    /// Blocks that may be skipped begin, or end: what they leave in force is unknown.
    pub(crate) fn skip_blocks(&mut self, on: bool) -> io::Result<()> {
        self.smooth(false)?;
        self.modal.forget(After::Anything);
        self.modal.skip(on);
        self.writer.set_skippable(on);
        Ok(())
    }

    /// Sets the smoothing of the cuts that come, and its tolerance, mm; `None`: that of the configuration.
    pub(crate) fn set_smoothing(&mut self, level: Option<Smoothing>, tolerance_mm: Option<f64>) {
        let (usual_level, usual) = self.smoothing.usual;
        let tolerance = tolerance_mm.map_or(usual, |mm| path_tolerance(mm / self.unit_mm));
        self.smoothing.wanted = (level.unwrap_or(usual_level), tolerance);
        self.values.path_tolerance = text(tolerance, Numerals { plus: false, ..self.numerals });
    }

    /// Notes that the safety blocks have stated the tolerance of the blending.
    pub(crate) fn note_blending(&mut self) {
        self.smoothing.blending = self.smoothing.wanted.1;
    }

    /// Switches smoothing on or off, where that of the cuts differs from the one in force. `cuts`: a cut comes. Where
    /// it is unknown, the next cut decides.
    #[inline]
    pub(crate) fn smooth(&mut self, cuts: bool) -> io::Result<()> {
        let (level, tolerance) = self.smoothing.wanted;
        let wanted = match level.level() {
            Some(level) if cuts => SmoothingState::On(level, tolerance),
            _ => SmoothingState::Off,
        };
        let before = self.modal.smoothing();
        let waits = before == SmoothingState::Unknown && !cuts;
        if before != wanted && !waits {
            self.switch_smoothing(before, wanted)?;
        }
        if cuts { self.blend() } else { Ok(()) }
    }

    /// Switches smoothing off for a cycle of the control or the end of the program, unless it is known to be off.
    pub(crate) fn stop_smoothing(&mut self) -> io::Result<()> {
        match self.modal.smoothing() {
            SmoothingState::Off => Ok(()),
            before => self.switch_smoothing(before, SmoothingState::Off),
        }
    }

    /// Writes the tolerance of the blending of the cuts that come, if no safety block has stated it.
    #[inline]
    pub(crate) fn blend(&mut self) -> io::Result<()> {
        if self.smoothing.blending == self.smoothing.wanted.1 { Ok(()) } else { self.write_blending() }
    }

    #[cold]
    fn write_blending(&mut self) -> io::Result<()> {
        self.note_blending();
        self.fill_all(self.codes.blending)
    }

    #[cold]
    fn switch_smoothing(&mut self, before: SmoothingState, after: SmoothingState) -> io::Result<()> {
        let codes = self.codes;
        let begins = |state, values: &mut Values| {
            let SmoothingState::On(level, _) = state else { return Vec::new() };
            values.smoothing_level = self.smoothing.levels.map(|levels| levels[level]);
            let angled = codes.smoothing_with_angle[level];
            let blocks = if values.angle_deg.is_some() && !angled.is_empty() { angled } else { codes.smoothing[level] };
            blocks.iter().filter_map(|block| values.fill(block)).collect()
        };
        let on_before: Vec<String> = begins(before, &mut self.values);
        let on = begins(after, &mut self.values);
        self.modal.set_smoothing(after);
        let same_tolerance =
            !matches!((before, after), (SmoothingState::On(_, one), SmoothingState::On(_, other)) if one != other);
        if on_before == on && same_tolerance && before != SmoothingState::Unknown {
            // The control has one level.
            return Ok(());
        }
        if on.is_empty() || !on_before.is_empty() {
            self.fill_all(codes.smoothing_off)?;
        }
        on.iter().try_for_each(|block| self.block(block))?;
        self.modal.forget(After::Smoothing);
        Ok(())
    }
}
