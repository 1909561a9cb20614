//! Steps of the planner into blocks of a control.

mod arcs;
mod cycles;
mod frames;
mod values;

use std::borrow::Cow;
use std::io::{self, Write};

use super::options::{Options, ProgramBlocks, Smoothing};
use crate::motion::{Cycle, Feed, Provenance, Sink, Step, VECTOR_DECIMALS, Words};
use crate::motion::{Mode, ToolPosture};
use crate::nc::{Decimal, Line, Numbering, Numerals, Writer};
use crate::program::Units;
use crate::program::{Coolant, Rotation};
use crate::set_up::Stock;

use super::belief::{Belief, LengthState};
use super::spellings::coolant_index;
use super::template::fill;
use super::{Control, Layout, LengthCall, LengthGuard, Spellings, Vectors};
use values::{Values, text};

/// What the words of an axis look like.
#[derive(Debug, Clone)]
struct Address {
    /// Position in the chain.
    index: usize,
    /// What stands before the number: `X`, `C1=`.
    word: String,
    decimals: u32,
}

/// Writes steps in the words of a control, and suppresses what stays in force.
pub struct Encoder<'a, W: Write> {
    control: &'a dyn Control,
    codes: &'static Spellings,
    writer: Writer<W>,
    axes: Vec<Address>,
    /// Position of Z in the chain: its word takes a length offset along.
    z: Option<usize>,
    units: Units,
    /// Decimals of lengths.
    linear: u32,
    setup: Options,
    program: ProgramBlocks,
    mode: Mode,
    /// How the tool axis is written in the place of rotary words.
    vectors: Option<&'static Vectors>,
    values: Values,
    numerals: Numerals,
    preselect: bool,
    belief: Belief,
    /// The cycle in force.
    cycling: Option<Cycle>,
    rigid: bool,
    /// The cutter is to run left of its path, or right.
    beside: Option<bool>,
    line: Vec<u8>,
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

/// What of a text fits into a line of so many bytes, up to a blank if there is one in it, and the rest.
fn line_of(text: &[u8], length: usize) -> (&[u8], Option<&[u8]>) {
    if text.len() <= length {
        return (text, None);
    }
    match text[..=length].iter().rposition(|&byte| byte == b' ') {
        Some(blank) => (&text[..blank], Some(&text[blank + 1..])),
        None => (&text[..length], Some(&text[length..])),
    }
}

/// A text in letters that every control has, as far as it holds signs that are written in other ways, too.
pub(crate) fn legible(text: &[u8]) -> Cow<'_, [u8]> {
    if text.is_ascii() {
        return text.into();
    }
    let mut out = Vec::with_capacity(text.len());
    for chunk in text.utf8_chunks() {
        for letter in chunk.valid().chars() {
            match letter {
                '°' => out.extend_from_slice(b" deg"),
                'µ' => out.push(b'u'),
                other => out.extend_from_slice(other.encode_utf8(&mut [0; 4]).as_bytes()),
            }
        }
        out.extend_from_slice(chunk.invalid());
    }
    out.into()
}

/// A text in lines of so many bytes; none of an empty one.
pub(crate) fn lines_of(text: &[u8], length: usize) -> impl Iterator<Item = &[u8]> {
    let mut rest = Some(text);
    let lines = std::iter::from_fn(move || {
        let (line, behind) = line_of(rest?, length);
        rest = behind;
        Some(line)
    });
    lines.filter(|line| !line.is_empty())
}

/// A name of capitals, digits and `_`.
fn plain(name: &str) -> String {
    let byte = |byte: char| if byte.is_ascii_alphanumeric() { byte.to_ascii_uppercase() } else { '_' };
    name.chars().map(byte).collect()
}

/// The name of a program as the control can hold it.
fn program_name(codes: &Spellings, layout: &Layout) -> String {
    let given = layout.setup.program_name.as_ref().map_or(layout.name.as_slice(), String::as_bytes);
    let given = given.trim_ascii();
    let byte = |byte: &u8| match byte.to_ascii_uppercase() {
        byte if !codes.plain_name => (codes.comment.byte)(byte),
        byte if byte.is_ascii_alphanumeric() => byte,
        _ => b'_',
    };
    let name: String = given.iter().take(codes.comment.length / 2).map(byte).map(char::from).collect();
    if name.is_empty() { "NONAME".to_owned() } else { name }
}

/// How the tool axis moves under tip control, in the words of the control.
fn posture(codes: &Spellings, layout: &Layout) -> &'static str {
    let plane = layout.posture == ToolPosture::Plane;
    let Some(tip) = &codes.tip else { return "" };
    let words = tip.vectors.as_ref().filter(|_| layout.vectors).map_or(&tip.posture, |vectors| &vectors.posture);
    words[usize::from(plane)]
}

impl<'a, W: Write> Encoder<'a, W> {
    /// An encoder that knows of nothing in force yet.
    pub fn new(control: &'a dyn Control, layout: &Layout, out: W) -> Self {
        let codes = control.spellings();
        let setup = layout.setup.clone();
        let numerals = Numerals { point: setup.point.unwrap_or(codes.numerals.point), ..codes.numerals };
        let numbering = match (codes.counted, layout.program.line_numbers) {
            (true, _) => Numbering::EveryLine,
            (false, Some(step)) => Numbering::Step(step),
            (false, None) => Numbering::None,
        };
        // A tolerance that the format cannot hold was refused with the configuration.
        let path_tolerance = Decimal::fixed(layout.path_tolerance, 6).unwrap_or_default();
        let values = Values {
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
        };
        Self {
            control,
            codes,
            writer: Writer::new(out, numbering),
            axes: addresses(control, layout),
            z: layout.axes.iter().position(|&(letter, _)| letter == 'Z'),
            units: layout.units,
            linear: layout.linear,
            values,
            numerals,
            preselect: setup.preselect.unwrap_or(codes.preselect),
            setup,
            program: layout.program.clone(),
            mode: layout.mode,
            vectors: codes.tip.as_ref().and_then(|tip| tip.vectors.as_ref()).filter(|_| layout.vectors),
            belief: Belief::default(),
            cycling: None,
            rigid: layout.rigid,
            beside: None,
            line: Vec::with_capacity(256),
        }
    }

    /// The lines a program of this control begins with. `blank`: the corners of the box around it, mm.
    ///
    /// # Errors
    /// Those of the output.
    pub fn open(&mut self, blank: Option<&Stock>) -> io::Result<()> {
        if self.setup.file_header {
            let header = self.control.file_header(&plain(&self.values.name));
            header.iter().try_for_each(|line| self.writer.line(line.as_bytes()))?;
        }
        let opening = self.codes.opening;
        self.lines(opening)?;
        let Some(Stock { lower, upper }) = blank else { return Ok(()) };
        let [lower, upper] = [lower, upper].map(|corner| self.point(corner));
        self.control.blank(&lower, &upper).iter().try_for_each(|line| self.writer.line(line.as_bytes()))
    }

    /// A point as words X Y Z.
    fn point(&self, point: &[f64; 3]) -> String {
        let words = ["X", "Y", "Z"].iter().zip(point).map(|(letter, mm)| {
            let value = Decimal::fixed(mm / self.units.in_mm(), self.linear).unwrap_or_default();
            format!("{letter}{}", text(value, self.numerals))
        });
        words.collect::<Vec<_>>().join(" ")
    }

    /// The blocks of the configuration behind the header.
    ///
    /// # Errors
    /// Those of the output.
    pub fn start(&mut self) -> io::Result<()> {
        let blocks = std::mem::take(&mut self.program.start);
        self.foreign(&blocks)
    }

    /// The blocks of the configuration before the end code, remarks as comments, and the end.
    ///
    /// # Errors
    /// Those of the output.
    pub fn end(&mut self, remarks: &[String]) -> io::Result<()> {
        let blocks = std::mem::take(&mut self.program.end);
        self.foreign(&blocks)?;
        remarks.iter().try_for_each(|remark| self.comment(remark.as_bytes()))?;
        self.block(self.codes.end)?;
        self.lines(self.codes.closing)
    }

    /// A comment, on as many lines as it needs.
    ///
    /// # Errors
    /// Those of the output.
    pub fn comment(&mut self, text: &[u8]) -> io::Result<()> {
        let text = legible(text);
        for piece in lines_of(&text, self.codes.comment.length) {
            self.line.clear();
            self.control.comment(piece, &mut self.line);
            self.writer.line(&self.line)?;
        }
        Ok(())
    }

    /// Keeps the lines that are written, from the first one on, until they are taken.
    pub fn keep_lines(&mut self) {
        self.writer.keep_lines();
    }

    /// Takes the lines since the last call; none if they are not kept.
    pub fn take_lines(&mut self) -> impl Iterator<Item = Line> + '_ {
        self.writer.take_lines()
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

    /// Lines of the frame around the program, which are no blocks.
    fn lines(&mut self, templates: &[&str]) -> io::Result<()> {
        for template in templates {
            if let Some(line) = fill(template, |field| self.values.get(field)) {
                self.writer.line(line.as_bytes())?;
            }
        }
        Ok(())
    }

    /// Blocks of the configuration: nothing is known behind them.
    fn foreign(&mut self, templates: &[String]) -> io::Result<()> {
        for template in templates {
            if let Some(line) = fill(template, |field| self.values.get(field)) {
                self.writer.line(line.as_bytes())?;
                self.belief.forget();
            }
        }
        Ok(())
    }

    fn block(&mut self, code: &str) -> io::Result<()> {
        self.writer.code(code);
        self.writer.end()
    }

    fn fill(&mut self, template: &str) -> io::Result<()> {
        match fill(template, |field| self.values.get(field)) {
            Some(block) => self.block(&block),
            None => Ok(()),
        }
    }

    fn fill_all(&mut self, templates: &[impl AsRef<str>]) -> io::Result<()> {
        templates.iter().try_for_each(|template| self.fill(template.as_ref()))
    }

    /// Whether a word is written that the control believes already.
    #[inline]
    fn writes(&self, changes: bool) -> bool {
        changes || self.setup.every_word
    }

    #[inline]
    fn any_changes(&self, words: &Words) -> bool {
        let z = self.z.filter(|_| matches!(self.belief.length, LengthState::Wanted(_)));
        self.belief.vector_changes(words.vector)
            || self.axes.iter().any(|axis| {
                words.has(axis.index)
                    && (self.belief.axis_changes(axis.index, words.units[axis.index]) || z == Some(axis.index))
            })
    }

    #[inline]
    fn axis_words(&mut self, words: &Words, all: bool) {
        for axis in &self.axes {
            if words.has(axis.index) {
                let units = words.units[axis.index];
                let changes = self.belief.axis_changes(axis.index, units);
                self.belief.set_axis(axis.index, units);
                if all || changes || self.setup.every_word {
                    self.writer.word(&axis.word, Decimal { units, decimals: axis.decimals }, self.numerals);
                }
            }
        }
        if let (Some(vectors), Some(vector)) = (self.vectors, words.vector)
            && self.writes(self.belief.vector_changes(words.vector))
        {
            self.belief.set_vector(vector);
            for (word, units) in vectors.words.into_iter().zip(vector) {
                self.writer.word(word, Decimal { units, decimals: VECTOR_DECIMALS }, self.numerals);
            }
        }
    }

    /// The code of a motion that writes a tool axis, and what ends a rapid of it, where these differ.
    fn along_vector(&self, words: &Words) -> Option<(&'static str, &'static str)> {
        let vectors = self.vectors.filter(|_| self.writes(self.belief.vector_changes(words.vector)))?;
        vectors.motion.map(|code| (code, vectors.rapid_end))
    }

    fn motion(&mut self, code: &'static str) {
        let changes = self.belief.set_motion(code);
        if changes || !self.codes.motion_modal || self.setup.every_word {
            self.writer.code(code);
        }
    }

    fn feed_mode(&mut self, code: &'static str) {
        let changes = self.belief.set_feed_mode(code);
        if changes {
            self.belief.forget_feed();
        }
        if self.writes(changes) {
            self.writer.code(code);
        }
    }

    fn feed_word(&mut self, value: Decimal) {
        let numerals = Numerals { plus: false, ..self.numerals };
        self.writer.word("F", value, numerals);
    }

    fn smooth(&mut self, on: bool) -> io::Result<()> {
        let level = match self.setup.smoothing {
            Smoothing::None => return Ok(()),
            Smoothing::Rough => 0,
            Smoothing::Medium => 1,
            Smoothing::Finish => 2,
        };
        if self.belief.smooth != on {
            let codes = self.codes;
            self.fill_all(if on { codes.smoothing[level] } else { codes.smoothing_off })?;
            self.belief.smooth = on;
            // Cycles of some controls bring codes of their own.
            self.belief.motion = "";
            self.belief.cycle = None;
        }
        Ok(())
    }

    fn feed(&mut self, words: &Words, feed: Feed) -> io::Result<()> {
        if !self.any_changes(words) {
            return Ok(());
        }
        self.smooth(true)?;
        if self.codes.length.call == LengthCall::Alone {
            self.call_length(words)?;
        }
        match feed {
            Feed::PerMinute(_) => self.feed_mode(self.codes.per_minute),
            Feed::InverseTime(_) => self.feed_mode(self.codes.inverse_time.unwrap_or_default()),
        }
        let along = self.along_vector(words);
        self.motion(along.map_or(self.codes.feed, |(code, _)| code));
        self.call_length(words)?;
        self.side_code();
        self.axis_words(words, false);
        self.centre_word(along.is_some());
        match feed {
            Feed::PerMinute(value) => self.changed_feed(value),
            Feed::InverseTime(value) => {
                self.feed_word(value);
                self.belief.forget_feed();
            }
        }
        self.writer.end()
    }

    /// Left or right of the path, or on it again: in front of the words, where nothing stands behind them.
    fn side_code(&mut self) {
        if self.codes.centre.is_empty() {
            self.changed_side();
        }
    }

    fn changed_side(&mut self) {
        if self.belief.beside != self.beside {
            let index = self.beside.map_or(2, |left| usize::from(!left));
            let code = fill(self.codes.beside[index], |field| self.values.get(field)).unwrap_or_default();
            self.writer.code(&code);
            self.belief.beside = self.beside;
            self.belief.centre = self.beside.is_none();
        }
    }

    /// On which side of the path, where that stands behind the words; `implied`: the motion code says that it is on it.
    fn centre_word(&mut self, implied: bool) {
        if self.beside.is_some() || self.belief.beside.is_some() {
            return self.changed_side();
        }
        if !implied && self.writes(!self.belief.centre) {
            self.writer.code(self.codes.centre);
        }
        self.belief.centre |= !implied;
    }

    fn changed_feed(&mut self, feed: Decimal) {
        let changes = self.belief.set_feed(feed);
        if self.writes(changes) {
            self.feed_word(feed);
        }
    }

    /// Decimals of the words of an axis.
    fn decimals(&self, index: usize) -> u32 {
        self.axes.iter().find(|address| address.index == index).map_or(0, |address| address.decimals)
    }

    fn rapid(&mut self, words: &Words) -> io::Result<()> {
        if !self.any_changes(words) {
            return Ok(());
        }
        if self.codes.length.call == LengthCall::Alone {
            self.call_length(words)?;
        }
        let along = self.along_vector(words);
        self.motion(along.map_or(self.codes.rapid, |(code, _)| code));
        self.call_length(words)?;
        self.axis_words(words, false);
        self.writer.code(along.map_or(self.codes.rapid_end, |(_, end)| end));
        self.writer.end()
    }

    fn spindle(&mut self, speed: Decimal, rotation: Rotation) -> io::Result<()> {
        self.values.speed = Some(speed);
        if let Some(alone) = self.codes.speed
            && self.writes(self.belief.speed != Some(speed))
        {
            self.fill(alone)?;
        }
        self.belief.speed = Some(speed);
        self.fill(self.codes.rotation(rotation))
    }

    /// A wait, in as many pieces as the control needs; pieces are whole milliseconds, as they are written.
    fn dwell(&mut self, seconds: f64) -> io::Result<()> {
        let mut rest = (seconds * 1e3).round() as u32;
        while rest > 0 {
            let piece = rest.min(self.codes.longest_dwell);
            self.values.seconds = Some(f64::from(piece) / 1e3);
            self.fill_all(self.codes.dwell)?;
            rest -= piece;
        }
        Ok(())
    }

    /// On and off of a kind of coolant.
    fn coolant_codes(&self, kind: Coolant) -> Option<[&str; 2]> {
        let index = coolant_index(kind)?;
        let given = self.setup.coolant[index].as_ref().map(|[on, off]| [on.as_str(), off.as_str()]);
        given.or(self.codes.coolant[index])
    }

    fn coolant(&mut self, kind: Coolant) -> io::Result<()> {
        let code = self.coolant_codes(kind).map(|[on, _]| on.to_owned());
        self.belief.coolant = Some(kind);
        self.block(&code.unwrap_or_default())
    }

    /// Off by the code of the kind that is on; by the general one where none is known to be.
    fn coolant_off(&mut self) -> io::Result<()> {
        let kind = self.belief.coolant.take();
        let code =
            kind.and_then(|kind| self.coolant_codes(kind)).map_or(self.codes.coolant_off, |[_, off]| off).to_owned();
        self.block(&code)
    }

    /// The name of an operation, for the eyes of the operator.
    fn operation(&mut self, name: &[u8]) -> io::Result<()> {
        let Some([before, behind]) = self.codes.operation else {
            return self.comment(&[b"OPERATION ", name].concat());
        };
        self.line.clear();
        self.line.extend_from_slice(before.as_bytes());
        self.line.extend(name.iter().take(self.codes.comment.length).map(|&byte| self.control.message(byte)));
        self.line.extend_from_slice(behind.as_bytes());
        self.writer.line(&self.line)
    }
}

impl<W: Write> Sink for Encoder<'_, W> {
    #[inline]
    fn step(&mut self, step: &Step<'_>, _: &Provenance<'_>) -> io::Result<()> {
        self.encode(step)
    }
}

impl<W: Write> Encoder<'_, W> {
    /// Writes the blocks of a step.
    ///
    /// # Errors
    /// Those of the output.
    #[inline]
    pub fn encode(&mut self, step: &Step<'_>) -> io::Result<()> {
        let codes = self.codes;
        if self.cycling.is_some() && !matches!(step, Step::Cycle { .. }) {
            self.end_cycle()?;
        }
        match *step {
            Step::Feed { ref words, feed } => self.feed(words, feed),
            Step::Cycle { cycle } => self.cycle(cycle),
            Step::Arc { ref words, circle, feed } => self.arc(words, circle, feed),
            Step::Rapid { ref words } => self.rapid(words),
            Step::Machine { ref words } => self.machine(words),
            Step::Restart { number } => self.restart(number),
            Step::PerMinute => {
                self.feed_mode(codes.per_minute);
                self.writer.end()
            }
            Step::Tool { number, offset, next, speed, change } => {
                self.values.tool = Some(number);
                self.values.offset = Some(offset);
                self.values.next = next.filter(|_| self.preselect);
                self.values.speed = speed;
                if change {
                    self.tool_change()
                } else {
                    self.comment(format!("T{number} stays in the spindle").as_bytes())
                }
            }
            Step::Length { offset } => {
                self.values.offset = Some(offset);
                if codes.length.call == LengthCall::WithTool {
                    return Ok(());
                }
                self.belief.length = LengthState::Wanted(offset);
                if codes.length.call == LengthCall::Alone { self.call_length(&Words::default()) } else { Ok(()) }
            }
            Step::Beside { left, register } => {
                self.beside = left;
                self.values.radius = Some(register);
                Ok(())
            }
            Step::TipControl { on } => self.tip_control(on),
            Step::Plane { angles, pose } => self.tilt(angles, pose),
            Step::PlaneOff => self.tilt_off(),
            Step::LengthGuard { label, tool, offset, length, tolerance } => {
                let guard = LengthGuard { label, tool, offset, length, tolerance, units: self.units };
                let blocks = self.control.length_guard(&guard);
                blocks.iter().try_for_each(|block| self.writer.line(block.as_bytes()))
            }
            Step::Spindle { speed, rotation } => self.spindle(speed, rotation),
            Step::Code { text } => self.block(text),
            Step::SpindleOff => self.block(codes.spindle_off),
            Step::Dwell { seconds } => self.dwell(seconds),
            Step::Coolant { kind } => self.coolant(kind),
            Step::CoolantOff => self.coolant_off(),
            Step::Stop { optional } => {
                self.smooth(false)?;
                self.block(codes.stop[usize::from(optional)])?;
                self.belief.forget();
                Ok(())
            }
            Step::Operation { name } => self.operation(name),
            Step::Message { text } => self.comment(text),
            Step::WorkOffset { word } => {
                self.values.work_offset = self.control.work_offset(word).unwrap_or_else(|| word.to_owned());
                Ok(())
            }
            Step::Raw { text } => {
                self.writer.line(text)?;
                self.belief.forget();
                Ok(())
            }
        }
    }
}
