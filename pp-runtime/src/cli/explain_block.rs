//! `explain-block IN.cls N1230`: the CL record that a block of the program comes from, why the block was written, and
//! the position of the machine after it.
//!
//! The CL data is posted once more with the same set-up, to a temporary file: the same data gives the same program.

use std::fmt::Write as _;
use std::io::{self, Seek as _};
use std::path::Path;

use crate::kinematics::{AnyMachine, Axis, AxisKind, Pose};
use crate::post::{LineMap, LineOrigin, OwnedPosition};
use crate::program::Location;

use super::args::{BlockName, ExplainBlockArgs, MessageFormat};
use super::excerpt::excerpts;
use super::inputs::{open_cl_data, read_config};
use super::map::{MapEntry, axis_values, branch_number};
use super::messages::MessageWriter;
use super::outcome::{Failure, Status, Streams, print};
use super::posting::{PostFn, PostRun};
use super::self_check::Checking;

/// Name of the temporary program in messages.
const TEMPORARY: &str = "a temporary file";

/// Largest number of blocks that are explained. Several blocks can have one number: block numbers start again after the
/// largest.
const MOST_EXPLAINED: usize = 20;

/// A line that was asked for, and the position of the machine after it.
struct FoundLine {
    origin: LineOrigin<'static>,
    position_after: Option<OwnedPosition>,
}

impl FoundLine {
    fn of(origin: &LineOrigin<'_>) -> Self {
        Self {
            origin: LineOrigin { position_after: None, ..*origin },
            position_after: origin.position_after.map(|position| OwnedPosition::of(&position)),
        }
    }

    fn origin(&self) -> LineOrigin<'_> {
        LineOrigin { position_after: self.position_after.as_ref().map(OwnedPosition::borrowed), ..self.origin }
    }
}

/// Search for a block among the lines of a program.
struct BlockSearch {
    wanted: BlockName,
    found: Vec<FoundLine>,
    /// Number of blocks that match.
    count: usize,
    /// Number of lines of the program.
    lines: u64,
    /// Every block has a number, not only the restart points.
    numbered: bool,
}

impl LineMap for BlockSearch {
    fn line(&mut self, origin: &LineOrigin<'_>) -> io::Result<()> {
        self.lines = origin.line;
        let matches = match self.wanted {
            BlockName::Number(number) => origin.number == Some(number),
            BlockName::Line(line) => origin.line == line,
        };
        if matches {
            self.count += 1;
            if self.found.len() < MOST_EXPLAINED {
                self.found.push(FoundLine::of(origin));
            }
        }
        Ok(())
    }
}

impl BlockSearch {
    /// The message that no block matches.
    fn missing(&self) -> String {
        let has = format!("the program has {} lines", self.lines);
        match self.wanted {
            BlockName::Line(line) => format!("there is no line {line}: {has}"),
            BlockName::Number(number) if self.numbered => format!("there is no block N{number}: {has}"),
            BlockName::Number(number) => format!(
                "there is no block N{number}: {has}, and posted with these options only its restart points have block \
                 numbers. Give all options that the program was posted with, --line-numbers too, or give a line of the \
                 program, without N: `57`"
            ),
        }
    }
}

pub(crate) fn run(
    machine: &dyn AnyMachine,
    args: &ExplainBlockArgs,
    streams: &mut Streams<'_>,
    post: PostFn<'_>,
) -> Result<Status, Failure> {
    let format = args.set_up.message_format;
    let config = read_config(machine, &args.set_up, &mut MessageWriter::new(streams.errors, format))?;
    let mut source = open_cl_data(&args.input, &args.set_up, streams.input)?;
    let (name, control) = (source.name().to_owned(), args.set_up.control());
    let numbered = config.control.program.line_numbers.are_on_every_block() || control.spellings().numbers_every_line;
    let mut search = BlockSearch { wanted: args.block, found: Vec::new(), count: 0, lines: 0, numbered };
    let unwritable = |error| Failure::Unwritable(TEMPORARY.to_owned(), error);
    let mut program = tempfile::tempfile().map_err(unwritable)?;
    let (output, checking) = (Path::new(TEMPORARY), Checking::for_text(&config));
    let run = PostRun { input: &args.input, output, checking, config: &config, control, post };
    // Messages about the program were written when it was posted; they are repeated only if it was rejected.
    let mut repeated = Vec::new();
    let mut messages = MessageWriter::new(&mut repeated, format);
    let written = run.write(machine, &mut source, &mut program, Some(&mut search), &mut messages)?;
    let rejected = written.summary.is_err();
    if rejected {
        // If standard error is closed, the messages are lost.
        let _ = streams.errors.write_all(&repeated);
    }
    let unreadable = |error| Failure::Unreadable(name.clone(), error);
    if search.found.is_empty() {
        return Err(Failure::Argument(search.missing()));
    }
    program.rewind().map_err(unwritable)?;
    source.rewind().map_err(unreadable)?;
    let in_program = |found: &FoundLine| (Location { line: found.origin.line, column: 1 }, 1);
    let in_cl = |found: &FoundLine| found.origin.at.filter(|at| at.line > 0).map(|at| (at, 1));
    let blocks = excerpts(&mut program, search.found.iter().map(in_program)).map_err(unwritable)?;
    let records = excerpts(&mut source, search.found.iter().filter_map(in_cl)).map_err(unreadable)?;
    print(streams, |out| {
        search.found.iter().enumerate().try_for_each(|(index, found)| {
            let origin = found.origin();
            if args.set_up.message_format == MessageFormat::Json {
                serde_json::to_writer(&mut *out, &MapEntry::new(&origin, machine.axes()))?;
                return out.write_all(b"\n");
            }
            if index > 0 {
                out.write_all(b"\n")?;
            }
            let block = blocks.get(&in_program(found)).map_or("", |excerpt| &excerpt.text);
            let record = in_cl(found).and_then(|place| Some((place.0.line, &records.get(&place)?.text)));
            out.write_all(
                explanation(&origin, machine.axes(), block, record.map(|(line, text)| (&*name, line, &**text)))
                    .as_bytes(),
            )
        })
    })?;
    let more = search.count - search.found.len();
    if more > 0 {
        MessageWriter::new(streams.errors, format).note(&format!("{more} more blocks have this number"));
    }
    Ok(if rejected { Status::Rejected } else { Status::Done })
}

/// The explanation of a block as text. `record`: file, line and text of its CL record.
fn explanation(origin: &LineOrigin<'_>, axes: &[Axis], block: &str, record: Option<(&str, u64, &str)>) -> String {
    let mut text = format!("line {} of the program ({}):\n    {block}\n", origin.line, origin.step);
    // Writing to a string cannot fail.
    let _ = writeln!(text, "{}", origin.why.text());
    if let Some((file, line, record)) = record {
        let _ = write!(text, "{file}, line {line}:\n    {record}\n");
    }
    let Some(position) = &origin.position_after else { return text };
    if let Some(Pose { tip, axis }) = position.pose {
        let _ =
            writeln!(text, "tip X {:.4}, Y {:.4}, Z {:.4} mm in the workpiece", tip.x + 0.0, tip.y + 0.0, tip.z + 0.0);
        let _ = writeln!(text, "tool axis I {:.7}, J {:.7}, K {:.7}", axis.x + 0.0, axis.y + 0.0, axis.z + 0.0);
    }
    let unit = |letter: char| {
        let rotary = axes.iter().any(|axis| axis.letter == letter && axis.kind == AxisKind::Rotary);
        if rotary { "°" } else { "" }
    };
    let values: Vec<String> =
        axis_values(axes, position).map(|(letter, value)| format!("{letter} {value:.4}{}", unit(letter))).collect();
    let note = if position.pose.is_none() { " (only these axes are in position)" } else { "" };
    let _ = writeln!(text, "axis values {}{note}", values.join(", "));
    if axes.iter().any(|axis| axis.kind == AxisKind::Rotary) {
        let _ = writeln!(text, "branch {} of the inverse kinematics", branch_number(position.branch));
    }
    text
}
