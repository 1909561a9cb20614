//! Steps of the planner into blocks of a control.

use std::io::{self, Write};

use crate::config::{ControlSetup, Mode, Program, Smoothing, Stock, ToolPosture, Units};
use crate::motion::{Circle, Cycle, CycleKind, Feed, MAX_AXES, PoseRule, Sink, Step, VECTOR_DECIMALS, Words};
use crate::nc::{Decimal, Numbering, Numerals, Writer, write_number};
use crate::program::{Coolant, Rotation};

use super::belief::{Belief, LengthState};
use super::spellings::coolant_index;
use super::template::{Field, fill};
use super::{ArcCentre, Control, Layout, LengthCall, LengthGuard, Spellings, Thread, Vectors};

/// What the words of an axis look like.
#[derive(Debug, Clone)]
struct Address {
    /// Position in the chain.
    index: usize,
    /// What stands before the number: `X`, `C1=`.
    word: String,
    decimals: u32,
}

/// Decimals of the angle of a helix, degrees: at 10 m from its axis they are a hundredth of a word.
const POLAR_DECIMALS: u32 = 6;

/// From this angle on the ends of an arc lie so near each other that the start has to be known to the digit, rad.
const NEARLY_WHOLE: f64 = 1.9 * std::f64::consts::PI;

/// Values of the fields of templates.
#[derive(Debug, Default)]
struct Values {
    name: String,
    number: String,
    units: &'static str,
    work_offset: String,
    path_tolerance: String,
    angle: Option<f64>,
    turning: &'static str,
    tool: Option<u32>,
    next: Option<u32>,
    offset: Option<u32>,
    speed: Option<Decimal>,
    seconds: Option<f64>,
    posture: &'static str,
    plane: [Decimal; 3],
    pose: &'static str,
    swivel_data: String,
    numerals: Numerals,
}

fn text(number: Decimal, numerals: Numerals) -> String {
    let mut text = Vec::new();
    write_number(&mut text, number, numerals);
    String::from_utf8(text).unwrap_or_default()
}

impl Values {
    fn get(&self, field: Field) -> Option<String> {
        let whole = |number: Option<u32>| number.map(|number| number.to_string());
        // What the format cannot hold was refused with the configuration or by the planner.
        let decimal = |value: f64, decimals| Decimal::fixed(value, decimals).unwrap_or_default();
        let plain = Numerals { plus: false, ..self.numerals };
        match field {
            Field::Name => Some(self.name.clone()),
            Field::Number => Some(self.number.clone()),
            Field::Units => Some(self.units.to_owned()),
            Field::WorkOffset => Some(self.work_offset.clone()),
            Field::PathTolerance => Some(self.path_tolerance.clone()),
            Field::Turning => Some(self.turning.to_owned()),
            Field::Angle => self.angle.map(|angle| text(decimal(angle, 4), plain)),
            Field::Tool => whole(self.tool),
            Field::Next => whole(self.next),
            Field::Offset => whole(self.offset),
            Field::Speed => self.speed.map(|speed| text(speed, Numerals::default())),
            Field::Seconds => self.seconds.map(|seconds| text(decimal(seconds, 3), plain)),
            Field::Posture => Some(self.posture.to_owned()),
            Field::First => Some(text(self.plane[0], self.numerals)),
            Field::Second => Some(text(self.plane[1], self.numerals)),
            Field::Third => Some(text(self.plane[2], self.numerals)),
            Field::Pose => Some(self.pose.to_owned()),
            Field::SwivelData => Some(self.swivel_data.clone()),
            Field::Milliseconds => self.seconds.map(|seconds| text(decimal(seconds * 1e3, 0), Numerals::default())),
        }
    }
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
    setup: ControlSetup,
    program: Program,
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
    let plane = layout.posture == Some(ToolPosture::Plane);
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
        let mut rest = text;
        loop {
            let (piece, behind) = line_of(rest, self.codes.comment.length);
            if !piece.is_empty() {
                self.line.clear();
                self.control.comment(piece, &mut self.line);
                self.writer.line(&self.line)?;
            }
            match behind {
                Some(behind) => rest = behind,
                None => return Ok(()),
            }
        }
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

    /// Calls the length offset that waits, in front of a motion or with it.
    fn call_length(&mut self, words: &Words) -> io::Result<()> {
        let LengthState::Wanted(register) = self.belief.length else { return Ok(()) };
        match self.codes.length.call {
            LengthCall::Alone => {
                self.belief.length = LengthState::On(register);
                self.fill(self.codes.length.code)
            }
            LengthCall::WithZ if self.z.is_none_or(|z| words.has(z)) => {
                self.belief.length = LengthState::On(register);
                if let Some(z) = self.z {
                    self.belief.forget_axis(z);
                }
                let code = fill(self.length_code(), |field| self.values.get(field)).unwrap_or_default();
                self.writer.code(&code);
                Ok(())
            }
            LengthCall::WithZ | LengthCall::WithTool => Ok(()),
        }
    }

    /// The code that calls the length offset, and with it tip control where the two go together.
    fn length_code(&self) -> &'static str {
        let tip = self.codes.tip.as_ref().filter(|_| self.mode == Mode::Tcp && self.setup.tip_control.is_none());
        let code = tip.and_then(|tip| self.vectors.map_or(tip.with_length, |vectors| vectors.with_length));
        code.unwrap_or(self.codes.length.code)
    }

    /// Tip control on or off; where it comes with the length offset, with the next motion.
    fn tip_control(&mut self, on: bool) -> io::Result<()> {
        self.usual_plane()?;
        self.frame_changes();
        if let Some(codes) = &self.setup.tip_control {
            let code = codes[usize::from(!on)].clone();
            return self.block(&code);
        }
        let Some(tip) = &self.codes.tip else { return Ok(()) };
        if !on {
            self.smooth(false)?;
        }
        self.fill_all(if on { tip.on } else { tip.off })?;
        if let LengthState::On(register) = self.belief.length
            && !on
            && tip.ends_length
        {
            self.belief.length = LengthState::Wanted(register);
        }
        Ok(())
    }

    /// Tilts the plane. The control turns the rotary axes to it, and its blocks may bring codes of their own.
    fn tilt(&mut self, angles: [Decimal; 3], pose: Option<bool>) -> io::Result<()> {
        let Some(plane) = &self.codes.plane else { return Ok(()) };
        self.usual_plane()?;
        if let LengthState::Wanted(register) = self.belief.length
            && plane.length_first
        {
            self.belief.length = LengthState::On(register);
            self.fill(self.codes.length.code)?;
        }
        self.values.plane = angles;
        // Where both poses are one, a control that wants a word gets one.
        self.values.pose = match pose {
            Some(higher) => plane.poses[usize::from(higher)],
            None if plane.pose == PoseRule::Side => plane.poses[1],
            None => "",
        };
        self.fill_all(plane.on)?;
        self.frame_changes();
        Ok(())
    }

    fn tilt_off(&mut self) -> io::Result<()> {
        let Some(plane) = &self.codes.plane else { return Ok(()) };
        self.smooth(false)?;
        self.fill_all(plane.off)?;
        self.frame_changes();
        Ok(())
    }

    /// Words mean something else from here on, F too: it may count along another path.
    fn frame_changes(&mut self) {
        self.belief.forget_axes();
        self.belief.forget_feed();
        self.belief.motion = "";
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

    /// The path is not compensated; `implied`: the motion code says so for its block.
    fn centre_word(&mut self, implied: bool) {
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

    /// A plane of arcs that is to be in force.
    fn plane(&mut self, code: &'static str) {
        if self.writes(self.belief.plane != code) {
            self.writer.code(code);
        }
        self.belief.plane = code;
    }

    /// The usual plane, in a block of its own: a length offset may count along the axis square to another one.
    fn usual_plane(&mut self) -> io::Result<()> {
        let usual = self.codes.arcs.planes[2].unwrap_or_default();
        if self.belief.plane == usual || self.belief.plane.is_empty() {
            return Ok(());
        }
        self.plane(usual);
        self.writer.end()
    }

    fn arc(&mut self, words: &Words, circle: &Circle, feed: Decimal) -> io::Result<()> {
        self.smooth(true)?;
        if self.codes.length.call == LengthCall::Alone {
            self.call_length(words)?;
        }
        self.feed_mode(self.codes.per_minute);
        let [first, second, _] = circle.plane.axes().map(|axis| circle.chain[axis]);
        let known =
            !self.belief.axis_changes(first, circle.start[0]) && !self.belief.axis_changes(second, circle.start[1]);
        // Its words are complete: what is left out of an arc means something else on each control.
        for axis in &circle.plane.axes()[..2] {
            self.belief.forget_axis(circle.chain[*axis]);
        }
        match self.codes.arcs.centre {
            ArcCentre::Offsets => self.arc_with_offsets(words, circle),
            ArcCentre::Pole => self.arc_about_pole(words, circle, known)?,
        }
        self.centre_word(false);
        self.changed_feed(feed);
        self.writer.end()
    }

    /// `G17 G2 X Y Z I J`.
    fn arc_with_offsets(&mut self, words: &Words, circle: &Circle) {
        let arcs = &self.codes.arcs;
        let [first, second, square] = circle.plane.axes();
        self.plane(arcs.planes[square].unwrap_or_default());
        self.motion(arcs.senses[usize::from(!circle.clockwise)]);
        self.axis_words(words, false);
        let decimals = self.decimals(circle.chain[first]);
        if let Some(units) = circle.radius {
            self.writer.word(arcs.radius, Decimal { units, decimals }, self.numerals);
            return;
        }
        let mut offsets = [(first, 0), (second, 1)];
        offsets.sort_unstable();
        for (axis, place) in offsets {
            let units = circle.centre[place] - circle.start[place];
            self.writer.word(["I", "J", "K"][axis], Decimal { units, decimals }, self.numerals);
        }
    }

    /// `CC X Y`, and `C X Y DR+`, `CR X Y R DR+` or `CP IPA IZ DR+`. `known`: the axes stand where the words of the arc say
    /// that it begins; behind a helix, whose end is an angle, they stand there but for rounding, and to `C` a whole turn
    /// from there might be no turn at all.
    fn arc_about_pole(&mut self, words: &Words, circle: &Circle, known: bool) -> io::Result<()> {
        let arcs = &self.codes.arcs;
        let [first, second, square] = circle.plane.axes().map(|axis| circle.chain[axis]);
        let decimals = self.decimals(first);
        let sense = arcs.senses[usize::from(!circle.clockwise)];
        self.belief.motion = "";
        if let Some(units) = circle.radius.filter(|_| circle.rise == 0) {
            self.writer.code("CR");
            self.axis_words(words, false);
            self.writer.word(arcs.radius, Decimal { units, decimals }, self.numerals);
            self.writer.code(sense);
            return Ok(());
        }
        self.writer.code("CC");
        for (axis, units) in [first, second].into_iter().zip(circle.centre) {
            let word = self.axes.iter().find(|address| address.index == axis).map_or("", |address| &address.word);
            self.writer.word(word, Decimal { units, decimals }, self.numerals);
        }
        self.writer.end()?;
        if circle.rise == 0 && (known || circle.sweep < NEARLY_WHOLE) {
            self.writer.code("C");
            self.axis_words(words, false);
        } else {
            self.writer.code("CP");
            let degrees = if circle.clockwise { -circle.sweep } else { circle.sweep }.to_degrees();
            // At most a turn in six decimals.
            let angle = Decimal::fixed(degrees, POLAR_DECIMALS).unwrap_or_default();
            self.writer.word("IPA", angle, self.numerals);
            if circle.rise != 0 {
                let word = self.axes.iter().find(|address| address.index == square).map_or("", |address| &address.word);
                let rise = Decimal { units: circle.rise, decimals: self.decimals(square) };
                self.writer.word(&format!("I{word}"), rise, self.numerals);
                self.belief.set_axis(square, words.units[square]);
            }
        }
        self.writer.code(sense);
        Ok(())
    }

    /// Cancels the cycle in force; behind it a motion says everything again.
    fn end_cycle(&mut self) -> io::Result<()> {
        let Some(cycle) = self.cycling.take() else { return Ok(()) };
        self.belief.motion = "";
        self.belief.forget_axis(cycle.z);
        self.belief.forget_feed();
        let end = self.codes.cycles.as_ref().map_or("", |cycles| cycles.end);
        self.block(end)
    }

    /// A hole: the cycle with all its words, or only where, while the same one is in force.
    fn cycle(&mut self, cycle: &Cycle) -> io::Result<()> {
        let Some(cycles) = &self.codes.cycles else { return Ok(()) };
        if let (CycleKind::Tap { pitch, .. }, Thread::Motion(code)) = (cycle.kind, cycles.thread) {
            return self.thread(cycle, code, pitch);
        }
        if self.cycling.is_some_and(|before| cycle.repeats(&before)) {
            if !self.any_changes(&cycle.words) {
                // The same place once more is said by its words.
                self.forget_words(&cycle.words);
            }
            self.axis_words(&cycle.words, false);
            return self.writer.end();
        }
        self.end_cycle()?;
        self.smooth(false)?;
        self.usual_plane()?;
        let code = match (cycle.kind, cycles.thread) {
            (CycleKind::Drill, _) => cycles.drill[usize::from(cycle.dwell.is_some())],
            (CycleKind::Peck(_), _) => cycles.peck,
            (CycleKind::ChipBreak(_), _) => cycles.chip_break,
            (CycleKind::Ream, _) => cycles.ream[usize::from(cycle.dwell.is_some())],
            (CycleKind::Tap { left, speed, .. }, Thread::Cycle { codes, rigid, .. }) => {
                if self.rigid {
                    self.values.speed = Some(speed);
                    self.fill(rigid)?;
                }
                codes[usize::from(left)]
            }
            (CycleKind::Tap { .. }, Thread::Motion(code)) => code,
        };
        self.feed_mode(self.codes.per_minute);
        self.writer.code(cycles.returns[usize::from(cycle.back != cycle.clearance)]);
        self.writer.code(code);
        self.forget_words(&cycle.words);
        self.axis_words(&cycle.words, false);
        self.cycle_words(cycle)?;
        self.cycling = Some(*cycle);
        Ok(())
    }

    /// `Z R Q P F`.
    fn cycle_words(&mut self, cycle: &Cycle) -> io::Result<()> {
        let decimals = self.decimals(cycle.z);
        let words = Words { mask: 1 << cycle.z, ..Words::default() };
        let mut bottom = words;
        bottom.units[cycle.z] = cycle.bottom;
        self.axis_words(&bottom, true);
        self.writer.word("R", Decimal { units: cycle.clearance, decimals }, self.numerals);
        if let CycleKind::Peck(units) | CycleKind::ChipBreak(units) = cycle.kind {
            self.writer.word("Q", Decimal { units, decimals }, self.numerals);
        }
        if let (Some(seconds), Some(cycles)) = (cycle.dwell, &self.codes.cycles) {
            self.values.seconds = Some(seconds);
            let word = fill(cycles.dwell, |field| self.values.get(field)).unwrap_or_default();
            self.writer.code(&word);
        }
        self.feed_word(cycle.feed);
        self.writer.end()
    }

    /// A thread by a motion: over to it, down to where it begins, in and out, and up to where the tool is to stand.
    fn thread(&mut self, cycle: &Cycle, code: &'static str, pitch: Decimal) -> io::Result<()> {
        let mut z = Words { mask: 1 << cycle.z, ..Words::default() };
        self.rapid(&cycle.words)?;
        z.units[cycle.z] = cycle.clearance;
        self.rapid(&z)?;
        self.motion(code);
        let mut bottom = z;
        bottom.units[cycle.z] = cycle.bottom;
        self.axis_words(&bottom, true);
        self.writer.word("K", pitch, self.numerals);
        self.writer.end()?;
        self.belief.motion = "";
        self.belief.set_axis(cycle.z, cycle.clearance);
        z.units[cycle.z] = cycle.back;
        self.rapid(&z)
    }

    fn forget_words(&mut self, words: &Words) {
        for axis in (0..MAX_AXES).filter(|&axis| words.has(axis)) {
            self.belief.forget_axis(axis);
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

    /// A rapid in machine coordinates. Not every control keeps its motion code in force, and some end the length offset.
    fn machine(&mut self, words: &Words) -> io::Result<()> {
        self.smooth(false)?;
        self.usual_plane()?;
        let length = &self.codes.length;
        if length.machine_ends {
            if !matches!(self.belief.length, LengthState::Off | LengthState::Wanted(_)) {
                self.writer.code(length.off);
            }
            self.belief.length = match self.belief.length {
                LengthState::On(register) | LengthState::Wanted(register) => LengthState::Wanted(register),
                LengthState::Off | LengthState::Unknown => LengthState::Off,
            };
        }
        self.belief.motion = "";
        let [before, behind] = self.codes.machine;
        self.writer.code(before);
        self.axis_words(words, true);
        self.writer.code(behind);
        for axis in self.axes.iter().filter(|axis| words.has(axis.index)) {
            self.belief.forget_axis(axis.index);
        }
        self.writer.end()
    }

    fn restart(&mut self, number: u32) -> io::Result<()> {
        self.smooth(false)?;
        self.belief.forget();
        self.writer.number_next(number);
        match self.setup.safety.take() {
            Some(safety) => {
                self.fill_all(&safety)?;
                self.setup.safety = Some(safety);
            }
            None => {
                self.fill_all(self.codes.safety)?;
                self.reset_frame()?;
                self.belief.feed_mode = self.codes.per_minute;
                self.belief.length = LengthState::Off;
                self.belief.plane = self.codes.arcs.planes[2].unwrap_or_default();
            }
        }
        Ok(())
    }

    /// What a restart point cancels besides, in a mode that uses it.
    fn reset_frame(&mut self) -> io::Result<()> {
        match (self.mode, &self.setup.tip_control, &self.codes.tip, &self.codes.plane) {
            (Mode::Tcp, Some([_, off]), _, _) => {
                let off = off.clone();
                self.block(&off)
            }
            (Mode::Tcp, None, Some(tip), _) => self.fill_all(tip.reset),
            (Mode::Plane, _, _, Some(plane)) => self.fill_all(plane.reset),
            _ => Ok(()),
        }
    }

    fn tool_change(&mut self) -> io::Result<()> {
        match self.setup.tool_change.take() {
            Some(blocks) => {
                self.fill_all(&blocks)?;
                self.setup.tool_change = Some(blocks);
            }
            None => {
                self.fill_all(self.codes.tool_change)?;
                self.belief.speed = self.values.speed;
            }
        }
        self.belief.forget_axes();
        self.belief.forget_feed();
        self.belief.motion = "";
        self.belief.length = LengthState::Unknown;
        Ok(())
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
    fn step(&mut self, step: &Step<'_>) -> io::Result<()> {
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
