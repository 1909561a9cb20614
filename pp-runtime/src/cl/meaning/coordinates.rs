//! From the numbers of a file to the workpiece frame: all coordinate transforms, and the frames stated in the file.

use super::frame::{FrameChange, SetUpFrame, StatedFrame, WorkpieceFrames};
use super::frame_reading::StatedPoint;
use super::options::{ReadingOptions, SetUpBegins};
use super::transform::{RigidTransform, Transforms};
use crate::cl::dialect::Dialect;
use crate::cl::text::{ClFault, Span};
use crate::cl::vector::{length, within_a_kilometre};
use crate::diag::code::cl;
use crate::nalgebra::{Point3, UnitVector3, Vector3};
use crate::program::ClearancePlane;

/// State that determines the position of a point of the file.
#[derive(Debug, Default)]
pub(crate) struct Coordinates {
    workpiece: WorkpieceFrames,
    set_up: SetUpFrame,
    transforms: Transforms,
}

impl Coordinates {
    /// Frames stated by MSYS, Creo's CSYS comment or CATIA's matrix.
    pub(crate) fn workpiece(&self) -> &WorkpieceFrames {
        &self.workpiece
    }

    /// Set-up frame: CSYS of SolidWorks CAM.
    pub(crate) fn set_up(&self) -> &SetUpFrame {
        &self.set_up
    }

    /// Coordinate transforms in force.
    pub(crate) fn transforms(&self) -> &Transforms {
        &self.transforms
    }

    /// Whether a frame is in force already: stating it again changes nothing.
    pub(crate) fn is_frame_in_force(&self, frame: &StatedFrame) -> bool {
        self.workpiece.in_force().is_some_and(|known| known.is_same(frame))
    }

    /// Whether a CSYS of SolidWorks CAM is in force already.
    pub(crate) fn is_set_up_in_force(&self, frame: &StatedFrame) -> bool {
        self.set_up.in_force().is_some_and(|known| known.is_same(frame))
    }

    /// Sets TRACUT; `unit_mm`: mm in one unit of the file.
    pub(crate) fn set_tracut(&mut self, rows: Option<[f64; 12]>, unit_mm: f64, at: Span) -> Result<(), ClFault> {
        let tracut = rows.map(|rows| RigidTransform::from_rows(&rows, unit_mm, at)).transpose()?;
        self.transforms.set_tracut(tracut);
        Ok(())
    }

    /// Sets ORIGIN, mm.
    pub(crate) fn set_origin(&mut self, origin: Option<[f64; 3]>) {
        self.transforms.set_origin(origin);
    }

    /// Sets TRANS, mm.
    pub(crate) fn set_translation(&mut self, by: Option<[f64; 3]>) {
        self.transforms.set_translation(by);
    }

    /// Converts the frames stated so far to mm, when the unit of the file is stated after them.
    pub(crate) fn scale_frames(&mut self, unit_mm: f64) {
        self.workpiece.scale(unit_mm);
    }

    /// Sets the frame in force.
    pub(crate) fn take_frame(
        &mut self,
        frame: StatedFrame,
        at: Span,
        options: &ReadingOptions,
        dialect: Dialect,
    ) -> Result<FrameChange, ClFault> {
        self.workpiece.take(frame, at, options, dialect)
    }

    /// Takes a point as the file has it, before it is transformed: it may state in which frame it is.
    pub(crate) fn take_point(&mut self, point: &StatedPoint) -> Result<(), ClFault> {
        if self.workpiece.take_point(point)? {
            self.map_frame();
        }
        Ok(())
    }

    /// The position is unknown.
    pub(crate) fn forget_place(&mut self) {
        self.workpiece.forget_place();
    }

    /// The set-up that begins with an operation of this name, if another one is in force.
    pub(crate) fn begin_operation(&mut self, name: &[u8], set_ups: &[SetUpBegins]) -> Option<u32> {
        self.workpiece.begin_operation(name, set_ups)
    }

    /// Sets the transform from the frame of the points to the first frame of their set-up.
    pub(crate) fn map_frame(&mut self) {
        if let Some((main, current)) = self.workpiece.main_and_current() {
            self.transforms.set_frame(main, current);
        }
    }

    /// TRNTYP/WORLD.
    pub(crate) fn set_world(&mut self) {
        self.set_up.set_world();
    }

    /// Sets CSYS; returns whether it differs from the one before.
    pub(crate) fn take_set_up(&mut self, frame: StatedFrame) -> bool {
        self.set_up.replace(frame)
    }

    /// Requires the tool axis of CSYS for the following points.
    pub(crate) fn hold_axis(&mut self, axis: [f64; 3]) {
        self.set_up.hold_axis(axis);
    }

    /// Ends that requirement: a new operation states its own tool axis.
    pub(crate) fn release_axis(&mut self) {
        self.set_up.release_axis();
    }

    /// Point in the workpiece frame; refused if a coordinate is above one kilometre.
    pub(crate) fn point(&self, point: Point3<f64>, at: Span) -> Result<Point3<f64>, ClFault> {
        Ok(within_a_kilometre(self.transforms.point(point), at)?)
    }

    /// Clearance plane in the workpiece frame; `unit_mm`: mm in one unit of the file.
    pub(crate) fn plane(
        &self,
        normal: [f64; 3],
        distance: f64,
        unit_mm: f64,
        at: Span,
    ) -> Result<ClearancePlane, ClFault> {
        let length = length(normal);
        if length < 1e-9 {
            return Err(cl::POSITION.cl_fault(
                "CLEARP",
                at,
                "the normal of this plane is 0, 0, 0",
                "program CLEARP/XYPLAN,z",
            ));
        }
        let normal = normal.map(|value| value / length);
        let distance = distance * unit_mm / length;
        let point = self.point(Point3::from(normal.map(|value| value * distance)), at)?;
        let normal = self.transforms.direction(UnitVector3::new_normalize(Vector3::from(normal)));
        Ok(ClearancePlane { normal, distance_mm: point.coords.dot(&normal) })
    }
}
