//! Steps of the planner into blocks of a control.
//!
//! [`Encoder`] gives each step to the owner of what it changes: [`ModalWriter`] (motions, and every modal word), [`Holes`]
//! (the cycle in force), [`FrameWriter`] (tip control, tilted planes, restart points, tool changes) and [`SpindleCoolant`]. All
//! of them write through the `ModalWriter`, which owns the modal state. A new [`Step`] does not compile before
//! [`Encoder::encode`] knows it.

mod frames;
mod holes;
mod modal_state;
mod modal_writer;
mod spindle_coolant;
mod text;
mod values;

use std::io::{self, Write};

use crate::motion::{Provenance, Sink, Step};
use crate::nc::{Decimal, Line};
use crate::program::Units;
use crate::set_up::Stock;

use super::dialects::{Control, LengthGuard, Spellings};
use super::layout::Layout;
use super::options::ProgramBlocks;

use frames::FrameWriter;
use holes::Holes;
use modal_state::After;
use modal_writer::ModalWriter;
use spindle_coolant::SpindleCoolant;
use text::plain;
pub(crate) use text::{legible, lines_of};

/// Writes steps in the words of a control, and suppresses what stays in force.
pub struct Encoder<'a, W: Write> {
    control: &'a dyn Control,
    codes: &'static Spellings,
    out: ModalWriter<W>,
    holes: Holes,
    frames: FrameWriter,
    spindle_coolant: SpindleCoolant,
    /// The tool after the next is called up.
    preselect: bool,
    /// The program begins with the name of its file.
    file_header: bool,
    program: ProgramBlocks,
    units: Units,
    /// Decimals of lengths.
    linear: u32,
    /// A comment line in the making.
    line: Vec<u8>,
}

impl<'a, W: Write> Encoder<'a, W> {
    /// An encoder that knows of nothing in force yet.
    pub fn new(control: &'a dyn Control, layout: &Layout, out: W) -> Self {
        let codes = control.spellings();
        Self {
            control,
            codes,
            out: ModalWriter::new(control, layout, out),
            holes: Holes::new(layout),
            frames: FrameWriter::new(layout),
            spindle_coolant: SpindleCoolant::new(layout),
            preselect: layout.setup.preselect.unwrap_or(codes.preselect),
            file_header: layout.setup.file_header,
            program: layout.program.clone(),
            units: layout.units,
            linear: layout.linear,
            line: Vec::with_capacity(256),
        }
    }

    /// The lines a program of this control begins with. `blank`: the corners of the box around it, mm.
    ///
    /// # Errors
    /// Those of the output.
    pub fn open(&mut self, blank: Option<&Stock>) -> io::Result<()> {
        if self.file_header {
            let header = self.control.file_header(&plain(&self.out.values().name));
            header.iter().try_for_each(|line| self.out.writer_mut().line(line.as_bytes()))?;
        }
        self.out.lines(self.codes.opening)?;
        let Some(Stock { lower, upper }) = blank else { return Ok(()) };
        let [lower, upper] = [lower, upper].map(|corner| self.point(corner));
        self.control.blank(&lower, &upper).iter().try_for_each(|line| self.out.writer_mut().line(line.as_bytes()))
    }

    /// A point as words X Y Z.
    fn point(&self, point: &[f64; 3]) -> String {
        let words = ["X", "Y", "Z"].iter().zip(point).map(|(letter, mm)| {
            let value = Decimal::fixed(mm / self.units.in_mm(), self.linear).unwrap_or_default();
            format!("{letter}{}", self.out.number(value))
        });
        words.collect::<Vec<_>>().join(" ")
    }

    /// The blocks of the configuration after the header.
    ///
    /// # Errors
    /// Those of the output.
    pub fn start(&mut self) -> io::Result<()> {
        self.out.foreign(&self.program.start)
    }

    /// The blocks of the configuration before the end code, remarks as comments, and the end.
    ///
    /// # Errors
    /// Those of the output.
    pub fn end(&mut self, remarks: &[String]) -> io::Result<()> {
        self.out.foreign(&self.program.end)?;
        remarks.iter().try_for_each(|remark| self.comment(remark.as_bytes()))?;
        self.out.block(self.codes.end)?;
        self.out.lines(self.codes.closing)
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
            self.out.writer_mut().line(&self.line)?;
        }
        Ok(())
    }

    /// Keeps the lines that are written, from the first one on, until they are taken.
    pub fn keep_lines(&mut self) {
        self.out.writer_mut().keep_lines();
    }

    /// Takes the lines since the last call; none if they are not kept.
    pub fn take_lines(&mut self) -> impl Iterator<Item = Line> + '_ {
        self.out.writer_mut().take_lines()
    }

    /// Blocks written up to now, comments not counted.
    pub fn blocks(&self) -> u64 {
        self.out.writer().blocks()
    }

    /// Hands on what is left.
    ///
    /// # Errors
    /// Those of the output.
    pub fn finish(&mut self) -> io::Result<()> {
        self.out.writer_mut().finish()
    }

    /// Writes the blocks of a step.
    ///
    /// # Errors
    /// Those of the output.
    #[inline]
    pub fn encode(&mut self, step: &Step<'_>) -> io::Result<()> {
        let (codes, out) = (self.codes, &mut self.out);
        if !matches!(step, Step::Cycle { .. }) {
            self.holes.end_cycle(out)?;
        }
        match *step {
            Step::Feed { ref words, feed } => out.feed(words, feed),
            Step::Cycle { cycle } => self.holes.cycle(cycle, out),
            Step::Arc { ref words, circle, feed } => out.arc(words, circle, feed),
            Step::Rapid { ref words } => out.rapid(words),
            Step::Machine { ref words } => out.machine_rapid(words),
            Step::Restart { number } => self.frames.restart(number, out),
            Step::PerMinute => {
                out.feed_mode(codes.per_minute);
                out.end()
            }
            Step::Tool { number, offset, next, speed, change } => self.tool(number, offset, next, speed, change),
            Step::Length { offset } => out.length(offset),
            Step::CutterCompensation { left, register } => {
                out.offset_path(left, register);
                Ok(())
            }
            Step::TipControl { on } => self.frames.tip_control(on, out),
            Step::Plane { angles, pose } => self.frames.tilt(angles, pose, out),
            Step::PlaneOff => self.frames.tilt_off(out),
            Step::LengthGuard { label, tool, offset, length, tolerance } => {
                self.length_guard(&LengthGuard { label, tool, offset, length, tolerance, units: self.units })
            }
            Step::Spindle { speed, rotation } => self.spindle_coolant.spindle(speed, rotation, out),
            Step::Code { text } => out.block(text),
            Step::SpindleOff => out.block(codes.spindle_off),
            Step::Dwell { seconds } => self.spindle_coolant.dwell(seconds, out),
            Step::Coolant { kind } => self.spindle_coolant.coolant(kind, out),
            Step::CoolantOff => self.spindle_coolant.coolant_off(out),
            Step::Stop { optional } => self.stop(optional),
            Step::Operation { name } => self.operation(name),
            Step::Message { text } => self.comment(text),
            Step::WorkOffset { word } => {
                out.values().work_offset = self.control.work_offset(word).unwrap_or_else(|| word.to_owned());
                Ok(())
            }
            Step::Raw { text } => out.raw(text),
        }
    }

    /// The tool of what follows: a change, or a remark that it is in the spindle already.
    fn tool(
        &mut self,
        number: u32,
        offset: u32,
        next: Option<u32>,
        speed: Option<Decimal>,
        change: bool,
    ) -> io::Result<()> {
        let values = self.out.values();
        values.tool = Some(number);
        values.offset = Some(offset);
        values.next = next.filter(|_| self.preselect);
        values.speed = speed;
        if change {
            self.frames.tool_change(&mut self.out)
        } else {
            self.comment(format!("T{number} stays in the spindle").as_bytes())
        }
    }

    fn length_guard(&mut self, guard: &LengthGuard) -> io::Result<()> {
        let blocks = self.control.length_guard(guard);
        blocks.iter().try_for_each(|block| self.out.writer_mut().line(block.as_bytes()))
    }

    fn stop(&mut self, optional: bool) -> io::Result<()> {
        self.out.smooth(false)?;
        self.out.block(self.codes.stop[usize::from(optional)])?;
        self.out.modal().forget(After::Anything);
        Ok(())
    }

    /// The name of an operation, for the operator.
    fn operation(&mut self, name: &[u8]) -> io::Result<()> {
        let Some([before, after]) = self.codes.operation else {
            return self.comment(&[b"OPERATION ", name].concat());
        };
        self.line.clear();
        self.line.extend_from_slice(before.as_bytes());
        self.line.extend(name.iter().take(self.codes.comment.length).map(|&byte| self.control.message(byte)));
        self.line.extend_from_slice(after.as_bytes());
        self.out.writer_mut().line(&self.line)
    }
}

impl<W: Write> Sink for Encoder<'_, W> {
    #[inline]
    fn step(&mut self, step: &Step<'_>, _: &Provenance<'_>) -> io::Result<()> {
        self.encode(step)
    }
}
