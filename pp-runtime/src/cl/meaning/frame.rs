//! Frames of a file: position and orientation of the output frame in the model.
//!
//! The numbers of CL data are already in that frame, so the first frame *is* the workpiece frame and is only reported.
//! A later frame that differs may move every point after it: `frame_reading` decides whether they are mapped into the
//! first of their set-up, and refuses what nothing states. CSYS of SolidWorks CAM is not such a frame: it does not
//! change points and states the tool axis.

use std::collections::BTreeMap;

use super::frame_reading::{FrameReading, FrameVote, PointsIn, StatedPoint};
use super::options::{ReadingOptions, SetUpBegins};
use crate::cl::dialect::Dialect;
use crate::cl::record::FrameRecord;
use crate::cl::text::{ClFault, Span};
use crate::cl::vector::{distance, dot};
use crate::diag::code::cl;
use crate::nalgebra::{UnitVector3, Vector3};
use crate::program::Location;

/// Largest distance of equal origins. CL data has four decimals.
const SAME_ORIGIN_MM: f64 = 1e-4;

/// Largest difference of a component of equal axes. CL data has seven decimals.
const SAME_AXES: f64 = 1e-6;

/// Largest difference of a component of equal tool axes, by the digits of CL data.
const SAME_DIRECTION: f64 = 1e-5;

/// A frame stated by MSYS, by Creo's CSYS comment or by CATIA's matrix.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StatedFrame {
    /// Place of the record in the file.
    pub location: Location,
    /// Origin in the model, mm.
    pub origin: [f64; 3],
    /// Unit vectors of its X, Y and Z in the model.
    pub axes: [[f64; 3]; 3],
}

impl StatedFrame {
    pub(crate) fn new(record: &FrameRecord, unit_mm: f64, location: Location) -> Result<StatedFrame, ClFault> {
        if !record.is_rigid() {
            return Err(cl::FRAME.cl_fault(
                "frame",
                record.at,
                "the axes of this frame are not perpendicular, right-handed unit vectors",
                "check the machine coordinate system in the CAM system",
            ));
        }
        Ok(StatedFrame { location, origin: record.origin.map(|value| value * unit_mm), axes: record.axes })
    }

    pub(crate) fn is_same(&self, other: &StatedFrame) -> bool {
        distance(self.origin, other.origin) <= SAME_ORIGIN_MM
            && (0..3).all(|i| distance(self.axes[i], other.axes[i]) <= SAME_AXES)
    }

    /// A frame whose numbers are those of a base: the same in the model.
    pub(crate) fn stated_in(&self, base: &StatedFrame) -> StatedFrame {
        let in_model =
            |v: [f64; 3]| [0, 1, 2].map(|i| v[0] * base.axes[0][i] + v[1] * base.axes[1][i] + v[2] * base.axes[2][i]);
        let shift = in_model(self.origin);
        let origin = [0, 1, 2].map(|i| base.origin[i] + shift[i]);
        StatedFrame { origin, axes: self.axes.map(in_model), ..*self }
    }

    /// Its Z in the coordinates of another frame.
    fn z_in(&self, other: &StatedFrame) -> [f64; 3] {
        other.axes.map(|axis| dot(axis, self.axes[2]))
    }
}

/// Largest number of different frames in a file.
const MOST_FRAMES: usize = 100;

/// What follows from a frame that is stated.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum FrameChange {
    /// It is in force already.
    None,
    /// Another frame of the same set-up.
    Frame,
    /// Another set-up begins.
    SetUp(u32),
}

/// The frames of a file. Those of a set-up are mapped into its first; the first of all is that of the workpiece.
#[derive(Debug)]
pub(crate) struct WorkpieceFrames {
    /// Different frames, in the order in which they are first stated.
    frames: Vec<StatedFrame>,
    /// How the points after each are read; those after the first are in it.
    readings: Vec<FrameReading>,
    /// Index of the frame in force.
    current: usize,
    stated: u64,
    /// Number of the set-up in force, and whether the name of an operation has begun it.
    set_up: u32,
    named: bool,
    /// Index of the first frame of each set-up.
    first_of: BTreeMap<u32, usize>,
}

impl Default for WorkpieceFrames {
    fn default() -> Self {
        let (frames, readings) = (Vec::new(), Vec::new());
        Self { frames, readings, current: 0, stated: 0, set_up: 1, named: false, first_of: BTreeMap::new() }
    }
}

impl WorkpieceFrames {
    pub(crate) fn frame(&self) -> Option<&StatedFrame> {
        self.frames.first()
    }

    /// First frame of each set-up, of those that have one.
    pub(crate) fn of_set_ups(&self) -> impl Iterator<Item = (u32, &StatedFrame)> {
        self.first_of.iter().filter_map(|(set_up, index)| Some((*set_up, self.frames.get(*index)?)))
    }

    /// The frame stated last.
    pub(crate) fn in_force(&self) -> Option<&StatedFrame> {
        self.frames.get(self.current)
    }

    pub(crate) fn stated(&self) -> u64 {
        self.stated
    }

    /// Number of different frames stated so far.
    pub(crate) fn different(&self) -> usize {
        self.frames.len()
    }

    /// Converts the frames stated so far to mm, when the unit of the file is stated after them.
    pub(crate) fn scale(&mut self, unit_mm: f64) {
        for frame in &mut self.frames {
            frame.origin = frame.origin.map(|value| value * unit_mm);
        }
    }

    /// Number of the frame in force, from 1.
    pub(crate) fn number(&self) -> u32 {
        u32::try_from(self.current + 1).unwrap_or(u32::MAX)
    }

    /// The first frame of the set-up in force, and that of the points.
    pub(crate) fn main_and_current(&self) -> Option<(&StatedFrame, &StatedFrame)> {
        let main = self.first_of.get(&self.set_up).copied().unwrap_or(self.current);
        let in_first = self.reading().is_some_and(|reading| reading.points() == PointsIn::First);
        Some((self.frames.get(main)?, self.frames.get(if in_first { 0 } else { self.current })?))
    }

    /// How the points after the frame in force are read; `None` for the first frame.
    fn reading(&self) -> Option<&FrameReading> {
        self.readings.get(self.current.checked_sub(1)?)
    }

    /// Whether points after the frame in force state how they are read.
    pub(crate) fn is_watched(&self) -> bool {
        self.reading().is_some_and(|reading| !reading.is_upright())
    }

    /// Whether no point has decided yet how those after the frame in force are read.
    pub(crate) fn is_open(&self) -> bool {
        self.reading().is_some_and(FrameReading::is_open)
    }

    /// The position is unknown: the next motion leads from nowhere.
    pub(crate) fn forget_place(&mut self) {
        if let Some(reading) = self.current.checked_sub(1).and_then(|index| self.readings.get_mut(index)) {
            reading.forget_place();
        }
    }

    /// Takes a point after the frame in force. Says whether those after it are read in another way than before.
    pub(crate) fn take_point(&mut self, point: &StatedPoint) -> Result<bool, ClFault> {
        let Some(index) = self.current.checked_sub(1) else { return Ok(false) };
        let before = self.readings[index].points();
        self.readings[index].take(point)?;
        let taken = &self.readings[index];
        let other = self
            .readings
            .iter()
            .find(|other| other.stated().is_some_and(|points| taken.stated().is_some_and(|stated| stated != points)));
        match other {
            Some(other) => Err(taken.differs(other, point.at)),
            None => Ok(taken.points() != before),
        }
    }

    /// For each frame whose reading nothing confirms: its place, and the fault.
    pub(crate) fn unconfirmed(&self) -> impl Iterator<Item = (Location, ClFault)> + '_ {
        let frames = self.frames.iter().skip(1).zip(&self.readings);
        frames.filter_map(|(frame, reading)| Some((frame.location, reading.conclude().err()?)))
    }

    /// How the frames are read, for the report.
    pub(crate) fn vote(&self) -> FrameVote {
        let mut vote = FrameVote::default();
        for reading in &self.readings {
            reading.count(&mut vote);
        }
        vote
    }

    /// The set-up that begins with an operation of this name, if another one is in force.
    pub(crate) fn begin_operation(&mut self, name: &[u8], set_ups: &[SetUpBegins]) -> Option<u32> {
        let is_named = |set_up: &&SetUpBegins| {
            let begins = set_up.operation.as_ref().map(|operation| operation.trim().as_bytes());
            begins.is_some_and(|begins| begins.eq_ignore_ascii_case(name.trim_ascii()))
        };
        let number = set_ups.iter().find(is_named)?.number;
        self.named = true;
        (std::mem::replace(&mut self.set_up, number) != number).then_some(number)
    }

    /// Sets the frame in force.
    pub(crate) fn take(
        &mut self,
        frame: StatedFrame,
        at: Span,
        options: &ReadingOptions,
        dialect: Dialect,
    ) -> Result<FrameChange, ClFault> {
        self.stated += 1;
        let known = self.frames.iter().position(|known| known.is_same(&frame));
        if known.is_none() && self.frames.len() == MOST_FRAMES {
            let text = format!("the file states more than {MOST_FRAMES} different frames");
            return Err(cl::FRAME.cl_fault("second frame", at, text, "output one file for each set-up"));
        }
        let index = known.unwrap_or(self.frames.len());
        let listed =
            options.set_ups.iter().find(|set_up| set_up.frames.iter().any(|number| *number as usize == index + 1));
        let set_up = match listed {
            Some(set_up) => set_up.number,
            None if self.named => self.set_up,
            None => 1,
        };
        self.named &= listed.is_none();
        let begins_set_up = *self.first_of.entry(set_up).or_insert(index) == index;
        if known.is_none() {
            if let Some(first) = self.frames.first() {
                // The comment of Creo may stand beside points in the coordinates of the machine, which are those of its
                // numbers.
                let in_model = (dialect == Dialect::Creo).then_some(frame.axes[2]);
                let columns = std::iter::once(frame.z_in(first)).chain(in_model).collect();
                let lines = [frame.location.line, first.location.line];
                self.readings.push(FrameReading::new(lines, columns, options.frames, begins_set_up));
            }
            self.frames.push(frame);
        }
        if let Some(reading) = index.checked_sub(1).and_then(|index| self.readings.get_mut(index)) {
            reading.begin_stretch(at)?;
        }
        let before = (std::mem::replace(&mut self.set_up, set_up), std::mem::replace(&mut self.current, index));
        Ok(match before {
            (other, _) if other != set_up => FrameChange::SetUp(set_up),
            (_, other) if other != index => FrameChange::Frame,
            _ => FrameChange::None,
        })
    }
}

/// Set-up frame of SolidWorks CAM: the CSYS in force, whose third column is the tool axis.
#[derive(Debug, Default)]
pub(crate) struct SetUpFrame {
    /// TRNTYP/WORLD: the points of all set-ups are in one frame.
    in_world: bool,
    /// The CSYS stated last.
    stated: Option<StatedFrame>,
    /// Number of CSYS that differ from the one before.
    changes: u64,
    /// Tool axis of the CSYS in force.
    axis: Option<UnitVector3<f64>>,
}

impl SetUpFrame {
    /// TRNTYP/WORLD.
    pub(crate) fn set_world(&mut self) {
        self.in_world = true;
    }

    /// The CSYS in force, while it states the tool axis.
    pub(crate) fn in_force(&self) -> Option<&StatedFrame> {
        self.stated.as_ref().filter(|_| self.axis.is_some())
    }

    pub(crate) fn changes(&self) -> u64 {
        self.changes
    }

    /// Refuses a CSYS without TRNTYP/WORLD before it.
    pub(crate) fn check_world(&self, at: Span) -> Result<(), ClFault> {
        if self.in_world {
            return Ok(());
        }
        Err(cl::FRAME.cl_fault(
            "CSYS",
            at,
            "CSYS without TRNTYP/WORLD,0,0,0 before it: the frame of the points is unknown",
            "if all points of the file are in one common frame, write TRNTYP/WORLD,0,0,0 above this line",
        ))
    }

    /// Sets CSYS; returns whether it differs from the one before.
    pub(crate) fn replace(&mut self, frame: StatedFrame) -> bool {
        let differs = self.stated.replace(frame).is_some_and(|before| !before.is_same(&frame));
        self.changes += u64::from(differs);
        differs
    }

    /// Requires the tool axis of CSYS for the following points.
    pub(crate) fn hold_axis(&mut self, axis: [f64; 3]) {
        self.axis = Some(UnitVector3::new_normalize(Vector3::from(axis)));
    }

    /// Ends that requirement: a new operation states its own tool axis.
    pub(crate) fn release_axis(&mut self) {
        self.axis = None;
    }

    /// Refuses a point whose tool axis differs from that of the CSYS in force.
    #[inline]
    pub(crate) fn check_axis(&self, given: Option<[f64; 3]>, at: Span) -> Result<(), ClFault> {
        match (self.axis, given) {
            (Some(axis), Some(given)) => compare_axis(axis, given, at),
            _ => Ok(()),
        }
    }
}

/// Refuses a tool axis other than the one that CSYS holds.
fn compare_axis(axis: UnitVector3<f64>, given: [f64; 3], at: Span) -> Result<(), ClFault> {
    if distance([axis.x, axis.y, axis.z], given) <= SAME_DIRECTION {
        return Ok(());
    }
    Err(cl::TOOL_AXIS.cl_fault(
        "tool axis",
        at,
        "this tool axis contradicts the third column of CSYS",
        "one of the two is wrong: correct CSYS, or i, j, k of this point; the tool axis is constant within one CSYS",
    ))
}
