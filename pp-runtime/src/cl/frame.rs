//! Where the output frame lies in the model, and whether it stays there.
//!
//! The numbers of CL data are already in that frame, so the first frame *is* the workpiece frame and is only reported.
//! A later one that differs would put every further point elsewhere: it is refused, never ignored.

use super::fault::{Fault, Span};
use super::record::FrameRecord;
use super::vector::{cross, distance, dot, length};
use crate::program::Location;

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

    fn is_same(&self, other: &Frame) -> bool {
        distance(self.origin, other.origin) <= SAME_ORIGIN_MM
            && (0..3).all(|i| distance(self.axes[i], other.axes[i]) <= SAME_AXES)
    }
}

/// The frame of the workpiece, once stated.
#[derive(Debug, Default)]
pub(super) struct Workpiece {
    frame: Option<Frame>,
    stated: u64,
}

impl Workpiece {
    pub(super) fn frame(&self) -> Option<&Frame> {
        self.frame.as_ref()
    }

    pub(super) fn stated(&self) -> u64 {
        self.stated
    }

    pub(super) fn take(&mut self, frame: Frame, at: Span) -> Result<(), Fault> {
        self.stated += 1;
        match &self.frame {
            None => self.frame = Some(frame),
            Some(first) if first.is_same(&frame) => {}
            Some(first) => {
                return Err(Fault::new(
                    "second frame",
                    at,
                    format!(
                        "the frame in line {} differs from the workpiece frame in line {}",
                        frame.location.line, first.location.line
                    ),
                    "write one file for each frame, or let all operations use one coordinate system",
                ));
            }
        }
        Ok(())
    }
}
