//! `post --map FILE.json`: which record of the CL data each line of the program serves, why it is there, and where the
//! machine is after it. One object per line, written while the program is.

use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use serde::Serialize;
use serde::ser::{SerializeMap as _, Serializer};

use crate::control::Control;
use crate::kinematics::{AnyMachine, Axis, AxisKind, Branch};
use crate::motion::ReachedPosition;
use crate::post::{Account, Origin};

use super::outcome::Failure;
use super::output_file::OutputFile;

/// Lengths and angles have no more digits than these: 1/10⁶ mm and degree.
const FINE: f64 = 1e6;

/// Components of tool axes.
const FINE_AXIS: f64 = 1e9;

/// One line of a program for programs.
#[derive(Serialize)]
pub(crate) struct MapLine<'a> {
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
    axes: Option<Axes<'a>>,
}

/// Axis values by letter, mm and degrees.
struct Axes<'a> {
    axes: &'a [Axis],
    standing: ReachedPosition<'a>,
}

impl Serialize for Axes<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        for (letter, value) in axis_values(self.axes, &self.standing) {
            map.serialize_entry(&letter, &value)?;
        }
        map.end()
    }
}

/// Letters and values of the axes that are known, mm and degrees.
pub(crate) fn axis_values<'a>(
    axes: &'a [Axis],
    standing: &'a ReachedPosition<'_>,
) -> impl Iterator<Item = (char, f64)> + 'a {
    let known = axes.iter().zip(standing.axes).enumerate().filter(|(index, _)| standing.mask & (1 << index) != 0);
    known.map(|(_, (axis, value))| {
        let value = if axis.kind == AxisKind::Rotary { value.to_degrees() } else { *value };
        (axis.letter, rounded(value, FINE))
    })
}

/// Without the digits that are arithmetic, and without a minus on nothing.
fn rounded(value: f64, fine: f64) -> f64 {
    (value * fine).round() / fine + 0.0
}

/// `explain` numbers them from 1.
pub(crate) fn branch_number(branch: Branch) -> u8 {
    match branch {
        Branch::First => 1,
        Branch::Second => 2,
    }
}

impl<'a> MapLine<'a> {
    /// The line of an origin, for a machine with these axes.
    pub(crate) fn new(origin: &Origin<'a>, axes: &'a [Axis]) -> Self {
        let pose = origin.standing.and_then(|standing| standing.pose);
        Self {
            line: origin.line,
            number: origin.number,
            step: origin.step,
            cl_line: origin.at.map(|at| at.line).filter(|line| *line > 0),
            why: origin.why.name(),
            tip: pose.map(|pose| [pose.tip.x, pose.tip.y, pose.tip.z].map(|value| rounded(value, FINE))),
            axis: pose.map(|pose| {
                let axis = pose.axis.into_inner();
                [axis.x, axis.y, axis.z].map(|value| rounded(value, FINE_AXIS))
            }),
            branch: origin.standing.map(|standing| branch_number(standing.branch)),
            axes: origin.standing.map(|standing| Axes { axes, standing }),
        }
    }
}

/// Writes a map line by line.
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

    /// Ends it.
    pub(crate) fn end(mut self) -> io::Result<()> {
        self.out.write_all(b"\n]}\n")?;
        self.out.flush()
    }
}

impl<W: Write> Account for MapWriter<'_, W> {
    fn line(&mut self, origin: &Origin<'_>) -> io::Result<()> {
        if self.begun {
            self.out.write_all(b",\n")?;
        }
        self.begun = true;
        let written = serde_json::to_writer(&mut self.out, &MapLine::new(origin, self.axes)).map_err(io::Error::from);
        written.map_err(|error| io::Error::new(error.kind(), format!("its map: {error}")))
    }
}

/// Keeps the last lines of an account back: before these something may be written that the posting does not know of.
pub(crate) struct Tail<'a> {
    account: &'a mut dyn Account,
    end: Vec<Origin<'static>>,
}

impl<'a> Tail<'a> {
    pub(crate) fn new(account: &'a mut dyn Account) -> Self {
        Self { account, end: Vec::new() }
    }

    /// Hands them on. `inserted` lines come before the `last` ones; `counted`: every line has a number of its own.
    pub(crate) fn end(self, inserted: usize, last: usize, counted: bool) -> io::Result<()> {
        let Self { account, end } = self;
        let later = |origin: &Origin<'static>, lines: u32| Origin {
            line: origin.line + u64::from(lines),
            number: origin.number.map(|number| if counted { number + lines } else { number }),
            ..*origin
        };
        let (before, after) = end.split_at(end.len().saturating_sub(last));
        before.iter().try_for_each(|origin| account.line(origin))?;
        let more = u32::try_from(inserted).unwrap_or_default();
        if let Some(first) = after.first() {
            let first = Origin { step: "check", number: first.number.filter(|_| counted), ..*first };
            (0..more).try_for_each(|index| account.line(&later(&first, index)))?;
        }
        after.iter().try_for_each(|origin| account.line(&later(origin, more)))
    }
}

impl Account for Tail<'_> {
    fn line(&mut self, origin: &Origin<'_>) -> io::Result<()> {
        if origin.step != "end" {
            return self.account.line(origin);
        }
        self.end.push(Origin { standing: None, ..*origin });
        Ok(())
    }
}

/// The file of a map: its name holds the map of the program that was written with it, or nothing.
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
    ) -> Result<MapWriter<'static, BufWriter<&mut dyn Write>>, Failure> {
        let out = BufWriter::new(self.target.writer());
        MapWriter::begin(machine, out, cl, control).map_err(|error| Failure::unwritable(&self.path, error))
    }

    /// Takes the map of an earlier program away, before there is another program.
    pub(crate) fn clear(&self) -> Result<(), Failure> {
        self.target.clear().map_err(|error| Failure::unwritable(&self.path, error))
    }

    pub(crate) fn finish(self) -> Result<(), Failure> {
        self.target.finish(|_| false).map(drop).map_err(|error| Failure::unwritable(&self.path, error))
    }
}
