//! In which coordinates the points after a second frame are: its own, or those of the first.
//!
//! Creo writes the same comment whether its points are in the frame of the sequence or all in that of the machine; NX
//! and CATIA mean the former (help of NX, *MSYS*). So the records have to state it, in every dialect. Where the Z of
//! the frame leans against that of the first, a tool axis (0, 0, 1) is its own Z, and its points are in it; a tool axis
//! that is its Z as the first frame has it says that they are in the first. Points without a tool axis are in it if
//! plunges and retracts are along its Z. A tool axis along neither, or records of both kinds, state nothing; nor does
//! any record where the Z is that of the first frame: then the reading must be given.

use super::options::Frames;
use crate::cl::text::{ClFault, Span};
use crate::cl::vector::{cross, distance, length};
use crate::diag::code::cl;
use crate::program::Location;

/// Z of a frame in itself.
const UP: [f64; 3] = [0.0, 0.0, 1.0];

/// Largest difference of a component of equal directions: the matrices of two frames, of five decimals, lie between
/// them.
const SAME_DIRECTION: f64 = 5e-5;

/// Sine of the largest angle between a motion and the direction that it is along, by the digits of its points.
const ALONG: f64 = 1e-4;

/// Length of the shortest motion with a direction, in units of the file.
const SHORTEST: f64 = 0.01;

/// Coordinates of the points after a frame.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum PointsIn {
    /// Those of the frame: they are mapped.
    Own,
    /// Those of the first frame of the file.
    First,
}

/// What decides it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum DecidedBy {
    /// Nothing yet.
    Nothing,
    /// Tool axes.
    ToolAxes,
    /// A point without a tool axis, which is in its own frame; motions must confirm it.
    NoToolAxis,
    /// The option.
    Option,
    /// The frame begins a set-up, and its points are in it unless a tool axis says otherwise.
    SetUp,
}

/// Points or motions that state one of the two: how many, and the first.
#[derive(Debug, Clone, Copy, Default)]
struct Evidence {
    count: u64,
    first: Option<(Location, [f64; 3])>,
}

impl Evidence {
    fn add(&mut self, here: Location, direction: [f64; 3]) {
        self.count += 1;
        self.first.get_or_insert((here, direction));
    }
}

/// Evidence for each of the two.
#[derive(Debug, Clone, Copy, Default)]
struct Both {
    own: Evidence,
    first: Evidence,
}

impl Both {
    fn of(&mut self, points: PointsIn) -> &mut Evidence {
        match points {
            PointsIn::Own => &mut self.own,
            PointsIn::First => &mut self.first,
        }
    }
}

/// A point of a record, as the file has it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct StatedPoint {
    pub(crate) tip: [f64; 3],
    /// Its tool axis, if a record states it.
    pub(crate) axis: Option<[f64; 3]>,
    pub(crate) rapid: bool,
    pub(crate) at: Span,
    pub(crate) here: Location,
}

/// Motions since the frame was stated last.
#[derive(Debug, Clone, Copy, Default)]
struct Stretch {
    from: Option<[f64; 3]>,
    /// The last motion was a rapid; `None` before the first one.
    rapid: Option<bool>,
}

/// Counts for the report.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct FrameVote {
    /// Number of frames whose points are in them, and are mapped.
    pub mapped: u64,
    /// Number of frames whose points are in the first one already.
    pub in_first: u64,
    /// Number of these whose reading the option gives.
    pub given: u64,
    /// Number of tool axes and motions that confirm the others.
    pub confirmed: u64,
}

/// How the points after a frame other than the first are read.
#[derive(Debug, Clone)]
pub(crate) struct FrameReading {
    /// Line of the frame, and that of the first one.
    lines: [u64; 2],
    /// Its Z in the first frame, and in the model if the CL data may mean that.
    columns: Vec<[f64; 3]>,
    points: PointsIn,
    by: DecidedBy,
    axes: Both,
    motions: Both,
    /// A tool axis along neither Z has come: the path tilts the tool, and may come along the other Z.
    tilts: bool,
    stretch: Stretch,
}

impl FrameReading {
    pub(crate) fn new(lines: [u64; 2], columns: Vec<[f64; 3]>, given: Option<Frames>, begins_set_up: bool) -> Self {
        let (points, by) = match given {
            _ if begins_set_up => (PointsIn::Own, DecidedBy::SetUp),
            Some(Frames::Main) => (PointsIn::Own, DecidedBy::Option),
            Some(Frames::First) => (PointsIn::First, DecidedBy::Option),
            None => (PointsIn::Own, DecidedBy::Nothing),
        };
        let [axes, motions] = [Both::default(); 2];
        Self { lines, columns, points, by, axes, motions, tilts: false, stretch: Stretch::default() }
    }

    pub(crate) fn points(&self) -> PointsIn {
        self.points
    }

    /// What its tool axes state, if they do.
    pub(crate) fn stated(&self) -> Option<PointsIn> {
        (self.by == DecidedBy::ToolAxes).then_some(self.points)
    }

    /// Whether no record has decided the reading yet.
    pub(crate) fn is_open(&self) -> bool {
        self.by == DecidedBy::Nothing
    }

    /// Whether its Z is that of the first frame, so that no record can state the reading.
    pub(crate) fn is_upright(&self) -> bool {
        self.columns.first().is_none_or(|column| distance(*column, UP) <= SAME_DIRECTION)
    }

    /// The frame is stated, or stated again.
    pub(crate) fn begin_stretch(&mut self, at: Span) -> Result<(), ClFault> {
        self.stretch = Stretch::default();
        if self.is_upright() && self.is_open() {
            return Err(self.unknown(at, "its Z is that of the first frame"));
        }
        Ok(())
    }

    /// The position is unknown: the next motion leads from nowhere.
    pub(crate) fn forget_place(&mut self) {
        self.stretch.from = None;
    }

    /// Takes a point of a record.
    pub(crate) fn take(&mut self, point: &StatedPoint) -> Result<(), ClFault> {
        if self.is_upright() {
            return Ok(());
        }
        match point.axis {
            Some(axis) => self.take_axis(axis, point),
            None if self.points == PointsIn::First => Err(self.without_axis(point.at)),
            None => {
                if self.by == DecidedBy::Nothing {
                    self.by = DecidedBy::NoToolAxis;
                }
                Ok(())
            }
        }?;
        self.take_motion(point);
        Ok(())
    }

    fn take_axis(&mut self, axis: [f64; 3], point: &StatedPoint) -> Result<(), ClFault> {
        let size = length(axis);
        let axis = axis.map(|value| value / size);
        let is = |direction: &[f64; 3]| distance(*direction, axis) <= SAME_DIRECTION;
        let found = match (is(&UP), self.columns.iter().any(is)) {
            (true, false) => PointsIn::Own,
            (false, true) => PointsIn::First,
            (both, _) => {
                self.tilts |= !both;
                let which = if both { "both" } else { "neither" };
                let why = || format!("the tool axis {} is along {which} Z", shown(axis));
                return if self.is_open() { Err(self.unknown(point.at, &why())) } else { Ok(()) };
            }
        };
        if self.tilts && found != self.points {
            return Ok(());
        }
        let is_own_unstated = self.axes.own.count == 0;
        self.axes.of(found).add(point.here, axis);
        match self.by {
            DecidedBy::Nothing => (self.points, self.by) = (found, DecidedBy::ToolAxes),
            DecidedBy::SetUp if is_own_unstated => (self.points, self.by) = (found, DecidedBy::ToolAxes),
            _ if found == self.points => {}
            DecidedBy::Option => return Err(self.contradicts_option(axis, point.at)),
            DecidedBy::NoToolAxis => return Err(self.without_axis(point.at)),
            DecidedBy::ToolAxes | DecidedBy::SetUp => return Err(self.both(point.at)),
        }
        Ok(())
    }

    /// Notes a motion of points without a tool axis that leads to the part or from it: the first one, a plunge, or a
    /// retract.
    fn take_motion(&mut self, point: &StatedPoint) {
        let Some(from) = self.stretch.from.replace(point.tip) else { return };
        let motion = [0, 1, 2].map(|i| point.tip[i] - from[i]);
        let size = length(motion);
        if size < SHORTEST || self.stretch.rapid.replace(point.rapid) == Some(point.rapid) || point.axis.is_some() {
            return;
        }
        let along = |direction: &[f64; 3]| length(cross(motion, *direction)) <= ALONG * size;
        match (along(&UP), self.columns.iter().any(along)) {
            (true, false) => self.motions.own.add(point.here, motion),
            (false, true) => self.motions.first.add(point.here, motion),
            (true, true) | (false, false) => {}
        }
    }

    /// At the end of the file: refuses points without a tool axis that no motion confirms.
    pub(crate) fn conclude(&self) -> Result<(), ClFault> {
        let Both { own, first } = self.motions;
        if self.points == PointsIn::First || self.axes.own.count > 0 {
            return Ok(());
        }
        match (first.first, self.by) {
            (Some((here, _)), _) if own.count == 0 => Err(self.along_first(here)),
            (Some((here, _)), DecidedBy::NoToolAxis) => Err(self.unknown(
                Span::WHOLE,
                &format!(
                    "of the motions of points without a tool axis that of line {} is along its Z in the first",
                    here.line
                ),
            )),
            (None, DecidedBy::NoToolAxis) if own.count == 0 => {
                Err(self.unknown(Span::WHOLE, "its points have no tool axis, and no plunge or retract is along its Z"))
            }
            _ => Ok(()),
        }
    }

    /// Adds what it has found to that of other frames.
    pub(crate) fn count(&self, vote: &mut FrameVote) {
        let (axes, motions) = match self.points {
            PointsIn::Own => (self.axes.own, self.motions.own),
            PointsIn::First => (self.axes.first, self.motions.first),
        };
        vote.mapped += u64::from(self.points == PointsIn::Own);
        vote.in_first += u64::from(self.points == PointsIn::First);
        vote.given += u64::from(self.by == DecidedBy::Option);
        vote.confirmed += axes.count + motions.count;
    }

    fn unknown(&self, at: Span, why: &str) -> ClFault {
        let [this, first] = self.lines;
        fault(
            at,
            format!(
                "the frame in line {this} differs from the workpiece frame in line {first}, and nothing states in which of them its \
                 points are: {why}"
            ),
            format!(
                "in that of line {this}: `--frames main`; in that of line {first}: `--frames first`; the part is clamped again: \
                 configure the set-up, `[set_ups.2]`, `frames = [2]`, `part_origin = [0.0, 0.0, 0.0]`, `part_rotation = [0.0, 0.0, \
                 0.0]`, `work_offset = \"G55\"`"
            ),
        )
    }

    fn contradicts_option(&self, axis: [f64; 3], at: Span) -> ClFault {
        let [this, first] = self.lines;
        let (option, z) = match self.points {
            PointsIn::Own => ("main", format!("in that of line {first}, where its points are then")),
            PointsIn::First => ("first", "in itself, where its points are then".to_owned()),
        };
        let text = format!(
            "`--frames {option}` is contradicted by the tool axis {}: the Z of the frame of line {this} {z}",
            shown(axis)
        );
        fault(at, text, "leave out `--frames` and `[cl] frames`: the tool axes state in which frame the points are")
    }

    fn both(&self, at: Span) -> ClFault {
        let place = |of: &Evidence| of.first.map_or((0, UP), |(here, axis)| (here.line, axis));
        let [(own, up), (first, column)] = [place(&self.axes.own), place(&self.axes.first)];
        let text = format!(
            "the points of the frame of line {} are in it by the tool axis {} of line {own}, and in the first frame by {} of line {first}",
            self.lines[0],
            shown(up),
            shown(column)
        );
        fault(at, text, ONE_SYSTEM)
    }

    /// The fault that the tool axes of two frames state different readings.
    pub(crate) fn differs(&self, other: &Self, at: Span) -> ClFault {
        let place = |of: &Self| {
            let evidence = if of.points == PointsIn::Own { &of.axes.own } else { &of.axes.first };
            evidence.first.map_or(0, |(here, _)| here.line)
        };
        let in_it = |of: &Self| if of.points == PointsIn::Own { "in it" } else { "in the first frame" };
        let text = format!(
            "the points of the frame of line {} are {} by the tool axis of line {}, and those of the frame of line {} are {} by that \
             of line {}",
            other.lines[0],
            in_it(other),
            place(other),
            self.lines[0],
            in_it(self),
            place(self)
        );
        fault(at, text, ONE_SYSTEM)
    }

    fn without_axis(&self, at: Span) -> ClFault {
        let text = format!(
            "the points of the frame of line {} are in the first frame, where its Z is tilted, and a point of them has no tool axis",
            self.lines[0]
        );
        fault(at, text, STATE_AXES)
    }

    fn along_first(&self, here: Location) -> ClFault {
        let text = format!(
            "the motion of line {} is along the Z of the frame of line {} in the first frame: its points are in the first, and their tool \
             axis is not stated",
            here.line, self.lines[0]
        );
        fault(Span::WHOLE, text, STATE_AXES)
    }
}

const ONE_SYSTEM: &str = "choose one coordinate system for the output of all operations in the CAM system";

const STATE_AXES: &str = "output i, j, k with the points (multi-axis output, MULTAX/ON) in the CAM system";

fn fault(at: Span, text: String, help: impl Into<String>) -> ClFault {
    cl::FRAME.cl_fault("second frame", at, text, help)
}

/// A direction, for messages.
fn shown(axis: [f64; 3]) -> String {
    let [i, j, k] = axis.map(|value| (value * 1e6).round() / 1e6 + 0.0);
    format!("{i}, {j}, {k}")
}
