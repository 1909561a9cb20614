//! `post --map FILE.json`: for each line of the program the CL record that it comes from, why it was written, and the
//! position of the machine after it. One JSON object per line, written together with the program.

use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use serde::Serialize;
use serde::ser::{SerializeMap as _, Serializer};

use crate::control::Control;
use crate::kinematics::{AnyMachine, Axis, AxisKind, Branch};
use crate::motion::ReachedPosition;
use crate::post::{LineMap, LineOrigin, ProgramEnd};

use super::outcome::{Failure, NamedWriter};
use super::output_file::OutputFile;

/// Resolution of lengths and angles in the map: steps per mm and per degree.
const STEPS_PER_UNIT: f64 = 1e6;

/// Resolution of the components of a tool axis in the map: steps per 1.
const AXIS_STEPS: f64 = 1e9;

/// The JSON object of one line of a program.
#[derive(Serialize)]
pub(crate) struct MapEntry<'a> {
    line: u64,
    #[serde(skip_serializing_if = "Option::is_none")]
    number: Option<u32>,
    step: &'a str,
    #[serde(skip_serializing_if = "Option::is_none")]
    cl_line: Option<u64>,
    why: &'a str,
    #[serde(skip_serializing_if = "Option::is_none")]
    tip: Option<[f64; 3]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    axis: Option<[f64; 3]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    branch: Option<u8>,
    #[serde(skip_serializing_if = "Option::is_none")]
    axes: Option<ValuesByLetter<'a>>,
}

/// Axis values by letter, mm and degrees, as one JSON object.
struct ValuesByLetter<'a> {
    axes: &'a [Axis],
    position: ReachedPosition<'a>,
}

impl Serialize for ValuesByLetter<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        for (letter, value) in axis_values(self.axes, &self.position) {
            map.serialize_entry(&letter, &value)?;
        }
        map.end()
    }
}

/// Letters and values of the axes whose position is known, mm and degrees.
pub(crate) fn axis_values<'a>(
    axes: &'a [Axis],
    position: &'a ReachedPosition<'_>,
) -> impl Iterator<Item = (char, f64)> + 'a {
    let known = axes.iter().zip(position.axes).enumerate().filter(|(index, _)| position.mask & (1 << index) != 0);
    known.map(|(_, (axis, value))| {
        let value = if axis.kind == AxisKind::Rotary { value.to_degrees() } else { *value };
        (axis.letter, rounded(value, STEPS_PER_UNIT))
    })
}

/// A value rounded to a resolution, without rounding noise and without a negative zero.
fn rounded(value: f64, steps_per_unit: f64) -> f64 {
    (value * steps_per_unit).round() / steps_per_unit + 0.0
}

/// Number of a branch, from 1 as in `explain`.
pub(crate) fn branch_number(branch: Branch) -> u8 {
    match branch {
        Branch::First => 1,
        Branch::Second => 2,
    }
}

impl<'a> MapEntry<'a> {
    /// The JSON object of a line, for a machine with these axes.
    pub(crate) fn new(origin: &LineOrigin<'a>, axes: &'a [Axis]) -> Self {
        let pose = origin.position_after.and_then(|position| position.pose);
        Self {
            line: origin.line,
            number: origin.number,
            step: origin.step,
            cl_line: origin.at.map(|at| at.line).filter(|line| *line > 0),
            why: origin.why.name(),
            tip: pose.map(|pose| [pose.tip.x, pose.tip.y, pose.tip.z].map(|value| rounded(value, STEPS_PER_UNIT))),
            axis: pose.map(|pose| {
                let axis = pose.axis.into_inner();
                [axis.x, axis.y, axis.z].map(|value| rounded(value, AXIS_STEPS))
            }),
            branch: origin.position_after.map(|position| branch_number(position.branch)),
            axes: origin.position_after.map(|position| ValuesByLetter { axes, position }),
        }
    }
}

/// Writes a map, one JSON object per line of the program.
pub(crate) struct MapWriter<'a, W> {
    out: W,
    axes: &'a [Axis],
    begun: bool,
}

impl<W: Write> MapWriter<'_, W> {
    /// Begins the map of a program.
    pub(crate) fn begin(machine: &dyn AnyMachine, mut out: W, cl: &str, control: &dyn Control) -> io::Result<Self> {
        let text = |text: &str| serde_json::to_string(text).map_err(io::Error::from);
        let [cl, name, control] = [text(cl)?, text(machine.name())?, text(control.spellings().name)?];
        writeln!(out, "{{\"cl\":{cl},\"machine\":{name},\"control\":{control},\"units\":[\"mm\",\"deg\"],\"lines\":[")?;
        Ok(Self { out, axes: machine.axes(), begun: false })
    }

    /// Ends the map.
    pub(crate) fn end(mut self) -> io::Result<()> {
        self.out.write_all(b"\n]}\n")?;
        self.out.flush()
    }
}

impl<W: Write> LineMap for MapWriter<'_, W> {
    fn line(&mut self, origin: &LineOrigin<'_>) -> io::Result<()> {
        if self.begun {
            self.out.write_all(b",\n")?;
        }
        self.begun = true;
        serde_json::to_writer(&mut self.out, &MapEntry::new(origin, self.axes)).map_err(io::Error::from)
    }
}

/// Holds back the last lines of a line map: before them the comment about the check may be inserted, which is written
/// after posting.
pub(crate) struct EndBuffer<'a> {
    line_map: &'a mut dyn LineMap,
    end: Vec<LineOrigin<'static>>,
}

impl<'a> EndBuffer<'a> {
    pub(crate) fn new(line_map: &'a mut dyn LineMap) -> Self {
        Self { line_map, end: Vec::new() }
    }

    /// Hands the lines on. `inserted`: number of lines inserted before the end of the program.
    pub(crate) fn end(self, inserted: usize, program_end: ProgramEnd) -> io::Result<()> {
        let counted = program_end.counted;
        let Self { line_map, end } = self;
        let later = |origin: &LineOrigin<'static>, lines: u32| LineOrigin {
            line: origin.line + u64::from(lines),
            number: origin.number.map(|number| if counted { number + lines } else { number }),
            ..*origin
        };
        let (before, after) = end.split_at(end.len().saturating_sub(program_end.lines));
        before.iter().try_for_each(|origin| line_map.line(origin))?;
        let more = u32::try_from(inserted).unwrap_or_default();
        if let Some(first) = after.first() {
            let first = LineOrigin { step: "check", number: first.number.filter(|_| counted), ..*first };
            (0..more).try_for_each(|index| line_map.line(&later(&first, index)))?;
        }
        after.iter().try_for_each(|origin| line_map.line(&later(origin, more)))
    }
}

impl LineMap for EndBuffer<'_> {
    fn line(&mut self, origin: &LineOrigin<'_>) -> io::Result<()> {
        if origin.step != "end" {
            return self.line_map.line(origin);
        }
        self.end.push(LineOrigin { position_after: None, ..*origin });
        Ok(())
    }
}

/// The file of a map: its final name holds the map of the program of the same run, or does not exist.
pub(crate) struct MapFile {
    path: PathBuf,
    target: OutputFile,
}

impl MapFile {
    pub(crate) fn create(path: &Path) -> Result<Self, Failure> {
        let target = OutputFile::create(path).map_err(|error| Failure::unwritable(path, error))?;
        Ok(Self { path: path.to_owned(), target })
    }

    pub(crate) fn begin(
        &mut self,
        machine: &dyn AnyMachine,
        cl: &str,
        control: &dyn Control,
    ) -> Result<MapWriter<'static, BufWriter<NamedWriter<'_>>>, Failure> {
        let out = BufWriter::new(self.target.writer());
        MapWriter::begin(machine, out, cl, control).map_err(|error| Failure::unwritable(&self.path, error))
    }

    /// Removes the map of an earlier program.
    pub(crate) fn clear(&self) -> Result<(), Failure> {
        self.target.clear().map_err(|error| Failure::unwritable(&self.path, error))
    }

    pub(crate) fn finish(self) -> Result<(), Failure> {
        self.target.finish(|_| false).map(drop).map_err(|error| Failure::unwritable(&self.path, error))
    }
}
