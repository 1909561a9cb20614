//! Encoder: steps of the planner as blocks of a control.
//!
//! [`Encoder`] passes each step to the owner of the state that it changes: [`ModalWriter`] (motions, and every modal
//! word), [`HoleWriter`] (the cycle in force), [`FrameWriter`] (tip control, tilted planes, restart points, tool
//! changes) and [`SpindleCoolantWriter`]. All of them write through the `ModalWriter`, which owns the modal state. A
//! new [`Step`] does not compile before [`Encoder::encode`] knows it.

mod frames;
mod holes;
mod modal_state;
mod modal_writer;
mod spindle_coolant;
mod text;
mod values;

use std::collections::BTreeMap;
use std::io::{self, Write};

use crate::motion::{Provenance, Sink, Step, ToolRoutine};
use crate::nc::{Decimal, WrittenLine};
use crate::program::Units;
use crate::set_up::Stock;

use super::dialects::{BlankWords, Control, LengthGuard, MessageStyle, PlaneGuard, RadiusGuard, Spellings};
use super::layout::Layout;
use super::options::{Messages, ProgramBlocks};

use frames::FrameWriter;
use holes::HoleWriter;
use modal_state::After;
use modal_writer::ModalWriter;
use spindle_coolant::SpindleCoolantWriter;
pub(crate) use text::comments;
use text::plain;
use text::{legible, lines_of};

/// Writes steps in the codes of a control, and leaves out words that are in force.
pub(crate) struct Encoder<'a> {
    control: &'a dyn Control,
    codes: &'static Spellings,
    out: ModalWriter<'a>,
    holes: HoleWriter,
    frames: FrameWriter,
    spindle_coolant: SpindleCoolantWriter,
    /// The next tool is preselected at each tool change.
    preselect: bool,
    /// As in the layout.
    tool_names: BTreeMap<u32, String>,
    tools_by_name: bool,
    /// The file begins with the name of the program.
    file_header: bool,
    program: ProgramBlocks,
    /// Blocks of the shop that measure a tool, and that look for its breakage.
    measure_tool: Vec<String>,
    check_tool: Vec<String>,
    /// Blocks of the shop at the start and the end of tools, by tool number.
    blocks_of_tools: BTreeMap<u32, [Vec<String>; 2]>,
    units: Units,
    /// Decimals of linear words.
    linear: u32,
    /// Buffer for a comment line.
    line: Vec<u8>,
}

impl<'a> Encoder<'a> {
    /// An encoder for a new program: the modal state of the control is unknown.
    pub(crate) fn new(control: &'a dyn Control, layout: &Layout, out: &'a mut dyn Write) -> Self {
        let codes = control.spellings();
        Self {
            control,
            codes,
            out: ModalWriter::new(control, layout, out),
            holes: HoleWriter::new(layout),
            frames: FrameWriter::new(layout),
            spindle_coolant: SpindleCoolantWriter::new(layout),
            preselect: layout.options.preselect.unwrap_or(codes.preselect),
            tool_names: layout.tool_names.clone(),
            tools_by_name: layout.tools_by_name,
            file_header: layout.options.file_header,
            program: layout.program.clone(),
            measure_tool: layout.options.measure_tool.clone(),
            check_tool: layout.options.check_tool.clone(),
            blocks_of_tools: layout.blocks_of_tools.clone(),
            units: layout.units,
            linear: layout.linear,
            line: Vec::with_capacity(256),
        }
    }

    /// Writes the first lines of a program. `blank`: the blank, mm, and whether it is that of the configuration.
    ///
    /// # Errors
    /// Errors of the output.
    pub(crate) fn open(&mut self, blank: Option<(&Stock, bool)>) -> io::Result<()> {
        if self.file_header {
            let header = self.control.file_header(&plain(&self.out.values().name));
            header.iter().try_for_each(|line| self.out.writer_mut().line(line.as_bytes()))?;
        }
        self.out.lines(self.codes.opening)?;
        let Some((stock, given)) = blank else { return Ok(()) };
        let words = self.blank_words(stock, given);
        self.control.blank(&words).iter().try_for_each(|line| self.out.writer_mut().line(line.as_bytes()))
    }

    /// Numbers of the blank. Sizes have no sign.
    fn blank_words(&self, stock: &Stock, given: bool) -> BlankWords {
        let decimal = |mm: f64| Decimal::fixed(mm / self.units.in_mm(), self.linear).unwrap_or_default();
        let corner = |corner: [f64; 3]| corner.map(|mm| self.out.number(decimal(mm)));
        let Stock { lower, upper, round } = *stock;
        let [diameter, height] = [upper[0] - lower[0], upper[2] - lower[2]];
        let sizes = [0.5 * diameter, diameter, height].map(|mm| self.out.size(decimal(mm)));
        BlankWords { lower: corner(lower), upper: corner(upper), round: round.then_some(sizes), given }
    }

    /// Writes the blocks of the configuration after the header.
    ///
    /// # Errors
    /// Errors of the output.
    pub(crate) fn start(&mut self) -> io::Result<()> {
        self.out.configured_blocks(&self.program.start)
    }

    /// Writes the end of a program: blocks of the configuration, remarks as comments, end code.
    ///
    /// # Errors
    /// Errors of the output.
    pub(crate) fn end(&mut self, remarks: &[String]) -> io::Result<()> {
        // A code of the CL data may have come since it was on.
        self.out.stop_smoothing()?;
        self.out.configured_blocks(&self.program.end)?;
        remarks.iter().try_for_each(|remark| self.comment(remark.as_bytes()))?;
        self.out.block(self.codes.end)?;
        self.out.lines(self.codes.closing)
    }

    /// Writes a comment, on as many lines as it needs.
    ///
    /// # Errors
    /// Errors of the output.
    pub(crate) fn comment(&mut self, text: &[u8]) -> io::Result<()> {
        let text = legible(text);
        for piece in lines_of(&text, self.codes.comment.length) {
            self.line.clear();
            self.control.comment(piece, &mut self.line);
            self.out.writer_mut().line(&self.line)?;
        }
        Ok(())
    }

    /// Records the lines from now on; [`take_lines`](Self::take_lines) returns them.
    pub(crate) fn keep_lines(&mut self) {
        self.out.writer_mut().keep_lines();
    }

    /// Returns the lines since the last call; none if they are not recorded.
    pub(crate) fn take_lines(&mut self) -> impl Iterator<Item = WrittenLine> + '_ {
        self.out.writer_mut().take_lines()
    }

    /// Number of blocks written so far, without comments.
    pub(crate) fn blocks(&self) -> u64 {
        self.out.writer().blocks()
    }

    /// Writes the rest of the buffer to the output.
    ///
    /// # Errors
    /// Errors of the output.
    pub(crate) fn finish(&mut self) -> io::Result<()> {
        self.out.writer_mut().finish()
    }

    /// Writes the blocks of a step.
    ///
    /// # Errors
    /// Errors of the output.
    #[inline]
    pub(crate) fn encode(&mut self, step: &Step<'_>) -> io::Result<()> {
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
            Step::Retract { ref words } => out.retract(words),
            Step::Home { ref words } => out.home(words),
            Step::Modes => self.frames.modes(out),
            Step::Restart { number, changes_tool } => self.frames.restart(number, changes_tool, out),
            Step::PerMinute => {
                out.feed_mode(codes.per_minute);
                out.end()
            }
            Step::Tool { number, offset, next, speed, radius_delta, change } => {
                self.tool([number, offset], next, speed, radius_delta, change)
            }
            Step::ToolRoutine { tool, routine } => {
                let of_tool = self.blocks_of_tools.get(&tool);
                let blocks = match routine {
                    ToolRoutine::Measure => Some(&self.measure_tool),
                    ToolRoutine::Check => Some(&self.check_tool),
                    ToolRoutine::Start => of_tool.map(|[start, _]| start),
                    ToolRoutine::End => of_tool.map(|[_, end]| end),
                };
                blocks.map_or(Ok(()), |blocks| out.configured_blocks(blocks))
            }
            Step::Length { offset } => out.length(offset),
            Step::CutterCompensation { left, register } => {
                out.set_compensation_side(left, register);
                Ok(())
            }
            Step::TipControl { on } => self.frames.tip_control(on, out),
            Step::Plane { angles, pose } => self.frames.tilt(angles, pose, out),
            Step::PlaneOff => self.frames.tilt_off(out),
            Step::DynamicOffset { on } => self.frames.dynamic_offset(on, out),
            Step::LengthGuard { label, tool, offset, length, tolerance } => {
                let units = self.units;
                let guard = LengthGuard { label, tool, offset, length_mm: length, tolerance_mm: tolerance, units };
                self.lines(&self.control.length_guard(&guard))
            }
            Step::RadiusGuard { tool, wear } => {
                let guard = RadiusGuard { tool, largest_wear_mm: wear, units: self.units };
                self.lines(&self.control.radius_guard(&guard))
            }
            Step::PlaneGuard { label, ref words } => {
                let guard = PlaneGuard { label, axes: out.positions(words) };
                self.lines(&self.control.plane_guard(&guard))
            }
            Step::OffsetGuard { label } => self.lines(&self.control.offset_guard(label)),
            Step::Spindle { speed, rotation } => self.spindle_coolant.spindle(speed, rotation, out),
            Step::Code { text } => out.block(text),
            Step::SpindleOff => self.spindle_coolant.spindle_off(out),
            Step::Dwell { seconds } => self.spindle_coolant.dwell(seconds, out),
            Step::Coolant { kind } => self.spindle_coolant.coolant(kind, out),
            Step::CoolantOff => self.spindle_coolant.coolant_off(out),
            Step::Stop { optional } => self.stop(optional),
            Step::BlockSkip { on } => out.skip_blocks(on),
            Step::Operation { name } => self.operation(name),
            Step::Message { text } => self.message(text),
            Step::WorkOffset { word } => {
                out.values().work_offset = self.control.work_offset(word).unwrap_or_else(|| word.to_owned());
                Ok(())
            }
            Step::Smoothing { level, tolerance_mm } => {
                out.set_smoothing(level, tolerance_mm);
                Ok(())
            }
            Step::OperationBlocks { at_end } => {
                let program = &self.program;
                out.configured_blocks(if at_end { &program.operation_end } else { &program.operation_start })
            }
            Step::Probe { blocks } => {
                out.stop_smoothing()?;
                blocks.iter().try_for_each(|block| out.raw(block.as_bytes()))
            }
            Step::Raw { text } => out.raw(text),
        }
    }

    /// Writes a tool change, or a comment that the tool is in the spindle already.
    fn tool(
        &mut self,
        [number, offset]: [u32; 2],
        next: Option<u32>,
        speed: Option<Decimal>,
        radius_delta: Option<f64>,
        change: bool,
    ) -> io::Result<()> {
        let unit_mm = self.units.in_mm();
        let called = self.tool_word(number);
        let next = next.filter(|_| self.preselect).map(|next| self.tool_word(next));
        let delta = radius_delta.map(|mm| Decimal::fixed(mm / unit_mm, self.linear).unwrap_or_default());
        self.out.modal().call_tool();
        let values = self.out.values();
        values.radius_delta = delta;
        values.tool = Some(called);
        values.tool_number = Some(number);
        values.offset = Some(offset);
        values.next = next;
        values.speed = speed;
        if change {
            let name = self.tool_names.get(&number).filter(|_| !self.tools_by_name);
            if let Some(text) = name.map(|name| format!("T{number} {name}")) {
                self.comment(text.as_bytes())?;
            }
            self.frames.tool_change(&mut self.out)
        } else {
            self.comment(format!("T{number} stays in the spindle").as_bytes())
        }
    }

    /// Value of `{tool}`: the number of a tool, or its name.
    fn tool_word(&self, number: u32) -> String {
        match (self.tool_names.get(&number).filter(|_| self.tools_by_name), self.codes.tool_name) {
            (Some(name), Some([before, after])) => format!("{before}{name}{after}"),
            _ => number.to_string(),
        }
    }

    fn lines(&mut self, lines: &[String]) -> io::Result<()> {
        lines.iter().try_for_each(|line| self.out.writer_mut().line(line.as_bytes()))
    }

    fn stop(&mut self, optional: bool) -> io::Result<()> {
        self.out.smooth(false)?;
        self.out.block(self.codes.stop[usize::from(optional)])?;
        self.out.modal().forget(After::Anything);
        Ok(())
    }

    /// Writes a text for the operator, as the configuration selects.
    fn message(&mut self, text: &[u8]) -> io::Result<()> {
        let shown = self.codes.message.filter(|_| self.program.messages == Messages::Display);
        let Some(MessageStyle { marks, length }) = shown else { return self.comment(text) };
        let text = legible(text);
        for piece in lines_of(&text, length) {
            self.displayed(marks, piece)?;
        }
        Ok(())
    }

    /// Writes a line that the control displays, or uses as a heading.
    fn displayed(&mut self, [before, after]: [&str; 2], text: &[u8]) -> io::Result<()> {
        self.line.clear();
        self.line.extend_from_slice(before.as_bytes());
        self.line.extend(text.iter().map(|&byte| self.control.message(byte)));
        self.line.extend_from_slice(after.as_bytes());
        self.out.writer_mut().line(&self.line)
    }

    /// Writes the name of an operation, as a message or a comment.
    fn operation(&mut self, name: &[u8]) -> io::Result<()> {
        let name = legible(name);
        match self.codes.operation {
            Some(marks) => self.displayed(marks, &name[..name.len().min(self.codes.comment.length)]),
            None => self.comment(&[b"OPERATION ", &*name].concat()),
        }
    }
}

impl Sink for Encoder<'_> {
    #[inline]
    fn step(&mut self, step: &Step<'_>, _: &Provenance<'_>) -> io::Result<()> {
        self.encode(step)
    }
}
