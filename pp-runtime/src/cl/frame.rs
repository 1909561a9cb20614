//! Where the output frame lies in the model, and whether it stays there.
//!
//! The numbers of CL data are already in that frame, so the first frame *is* the workpiece frame and is only reported.
//! A later one that differs would put every further point elsewhere: it is mapped, given a work offset of its own, or
//! refused, never ignored. CSYS of SolidWorks CAM is no such frame: it moves nothing and says where the tool points.

use super::fault::{Fault, Span};
use super::interpret::Interpreter;
use super::options::Frames;
use super::record::FrameRecord;
use super::vector::{cross, distance, dot, length};
use crate::nalgebra::{UnitVector3, Vector3};
use crate::program::{Event, Location, Units};

/// Origins closer than this are the same, mm: CL data has four decimals.
const SAME_ORIGIN_MM: f64 = 1e-4;

/// Axes closer than this are the same: CL data has seven decimals.
const SAME_AXES: f64 = 1e-6;

/// How far the axes may be from a right-handed unit frame.
const SQUARE: f64 = 1e-3;

/// A frame stated by MSYS, by Creo's CSYS comment or by CATIA's matrix.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frame {
    /// Where it is stated.
    pub location: Location,
    /// Origin in the model, mm.
    pub origin: [f64; 3],
    /// Directions of its X, Y and Z in the model.
    pub axes: [[f64; 3]; 3],
}

impl Frame {
    pub(super) fn new(record: &FrameRecord, unit: f64, location: Location) -> Result<Frame, Fault> {
        let [x, y, z] = record.axes;
        let unit_length = [x, y, z].iter().all(|axis| (length(*axis) - 1.0).abs() <= SQUARE);
        let square = dot(x, y).abs() <= SQUARE && distance(cross(x, y), z) <= SQUARE;
        if !unit_length || !square {
            return Err(Fault::new(
                "frame",
                record.at,
                "the axes of this frame are not at right angles, of length 1 and right-handed",
                "check the machine coordinate system in the CAM system",
            ));
        }
        Ok(Frame { location, origin: record.origin.map(|value| value * unit), axes: record.axes })
    }

    pub(super) fn is_same(&self, other: &Frame) -> bool {
        distance(self.origin, other.origin) <= SAME_ORIGIN_MM
            && (0..3).all(|i| distance(self.axes[i], other.axes[i]) <= SAME_AXES)
    }
}

/// More different frames than a file may have.
const MOST_FRAMES: usize = 100;

/// The frames of a file; the first is that of the workpiece.
#[derive(Debug, Default)]
pub(super) struct Workpiece {
    /// Frames that differ, in the order of their first statement.
    frames: Vec<Frame>,
    /// Index of the one in force.
    current: usize,
    stated: u64,
}

impl Workpiece {
    pub(super) fn frame(&self) -> Option<&Frame> {
        self.frames.first()
    }

    pub(super) fn stated(&self) -> u64 {
        self.stated
    }

    /// Different frames stated so far.
    pub(super) fn different(&self) -> usize {
        self.frames.len()
    }

    /// The unit of the file became known behind the frames.
    pub(super) fn scale(&mut self, unit: f64) {
        for frame in &mut self.frames {
            frame.origin = frame.origin.map(|value| value * unit);
        }
    }

    /// Number of the frame in force, from 1.
    pub(super) fn number(&self) -> u32 {
        u32::try_from(self.current + 1).unwrap_or(u32::MAX)
    }

    /// The first frame and the one in force.
    pub(super) fn main_and_current(&self) -> Option<(&Frame, &Frame)> {
        Some((self.frames.first()?, self.frames.get(self.current)?))
    }

    /// Takes a frame; answers whether another one is in force now.
    pub(super) fn take(&mut self, frame: Frame, at: Span, frames: Frames) -> Result<bool, Fault> {
        self.stated += 1;
        let Some(first) = self.frames.first() else {
            self.frames.push(frame);
            return Ok(false);
        };
        if !first.is_same(&frame) && frames == Frames::Refuse {
            return Err(Fault::new(
                "second frame",
                at,
                format!(
                    "the frame in line {} differs from the workpiece frame in line {}",
                    frame.location.line, first.location.line
                ),
                "`--frames main` maps it into the first, `--frames offset` gives it a work offset of its own; or write \
                 one file for each frame",
            ));
        }
        let known = self.frames.iter().position(|known| known.is_same(&frame));
        let index = match known {
            Some(index) => index,
            None if self.frames.len() < MOST_FRAMES => {
                self.frames.push(frame);
                self.frames.len() - 1
            }
            None => {
                return Err(Fault::new(
                    "second frame",
                    at,
                    format!("the file states more than {MOST_FRAMES} different frames"),
                    "write one file for each set-up",
                ));
            }
        };
        Ok(std::mem::replace(&mut self.current, index) != index)
    }
}

impl Interpreter {
    /// MSYS, Creo's CSYS comment, CATIA's matrix.
    pub(super) fn take_frame(&mut self, record: &FrameRecord, here: Location) -> Result<(), Fault> {
        let unit = self.units().map_or(1.0, Units::in_mm);
        let frame = Frame::new(record, unit, here)?;
        let frames = self.options.frames;
        if !self.workpiece.take(frame, record.at, frames)? {
            return Ok(());
        }
        self.begin_operation();
        match frames {
            Frames::Main => {
                if let Some((main, current)) = self.workpiece.main_and_current() {
                    self.changes.set_frame(main, current);
                }
                self.emit(here, Event::SafeSequence);
            }
            // A frame that differs is refused before it gets here.
            Frames::Offset | Frames::Refuse => {
                (self.here, self.clearance) = (None, None);
                let number = self.workpiece.number();
                self.emit(here, Event::Frame(number));
            }
        }
        Ok(())
    }

    /// CSYS of SolidWorks CAM.
    pub(super) fn take_setup(&mut self, record: &FrameRecord, here: Location) -> Result<(), Fault> {
        if !self.world {
            return Err(Fault::new(
                "CSYS",
                record.at,
                "CSYS without TRNTYP/WORLD,0,0,0 in front of it: in which frame the points are is not known",
                "have SolidWorks CAM write its points in one common frame",
            ));
        }
        let unit = self.units().map_or(1.0, Units::in_mm);
        let frame = Frame::new(record, unit, here)?;
        let before = self.setup_frame.replace(frame);
        if before.is_some_and(|before| !before.is_same(&frame)) {
            // The tool may turn: out of the part first.
            self.setup_changes += 1;
            self.begin_operation();
            self.emit(here, Event::SafeSequence);
        }
        let normalised = self.axis.state(frame.axes[2], record.at)?;
        self.count_normalised(normalised, here);
        self.setup = Some(UnitVector3::new_normalize(Vector3::from(frame.axes[2])));
        Ok(())
    }
}
