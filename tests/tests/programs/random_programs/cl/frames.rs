//! Frame of the numbers of the file: MSYS, TRACUT, ORIGIN and TRANS.
//!
//! A point is transformed by TRACUT, then ORIGIN is subtracted or TRANS added, then it is mapped from the frame of the
//! operation into the first frame. Points are generated in the first frame, and written through the inverse.

use nalgebra::{Matrix3, Rotation3, Vector3};

use super::Program;

/// Treatment of the frames after the first.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Frames {
    /// There are no other frames.
    None,
    /// Their points are mapped into the first.
    Main,
    /// Each is a set-up of its own, and its points are not changed.
    SetUps,
}

/// Number of frames in a file.
pub(crate) const FRAMES: usize = 3;

/// Position of a frame in another one, mm.
#[derive(Debug, Clone, Copy)]
pub(super) struct Frame {
    axes: Matrix3<f64>,
    origin: Vector3<f64>,
}

impl Frame {
    pub(super) fn none() -> Self {
        Self { axes: Matrix3::identity(), origin: Vector3::zeros() }
    }

    /// Coordinates of an outer point in this frame, mm.
    pub(super) fn point(&self, point: Vector3<f64>) -> Vector3<f64> {
        self.axes.transpose() * (point - self.origin)
    }

    /// Components of an outer direction in this frame.
    pub(super) fn direction(&self, direction: Vector3<f64>) -> Vector3<f64> {
        self.axes.transpose() * direction
    }

    /// Components of a direction of this frame in the outer frame.
    pub(super) fn outside(&self, direction: Vector3<f64>) -> Vector3<f64> {
        self.axes * direction
    }

    /// An inner frame, relative to the outer one.
    fn with(&self, inner: &Self) -> Self {
        Self { axes: self.axes * inner.axes, origin: self.origin + self.axes * inner.origin }
    }
}

impl Program<'_> {
    /// Chooses the frames of the file: the first is that of the part, at any position in the model.
    pub(super) fn state_frames(&mut self) {
        let model = if self.random.chance(0.3) { self.some_frame(200.0) } else { Frame::none() };
        self.frames = vec![(model, Frame::none())];
        if self.needs.frames != Frames::None {
            for _ in 1..FRAMES {
                let frame = self.some_frame(30.0);
                let written = if self.needs.frames == Frames::Main { frame } else { Frame::none() };
                self.frames.push((model.with(&frame), written));
            }
        }
    }

    /// Writes MSYS of an operation.
    pub(super) fn enter_frame(&mut self) {
        // The first frame that is written is that of the part.
        let number = if self.stated { self.random.below(self.frames.len()) } else { 0 };
        self.stated = true;
        let (model, frame) = self.frames[number];
        let origin = self.numbers(model.origin, 5);
        let axes = [0, 1].map(|axis| self.digits(model.axes.column(axis).into_owned(), 9));
        self.line(&format!("MSYS/{origin},{},{}", axes[0], axes[1]));
        self.frame_of_file = frame;
        self.compose();
    }

    /// Writes TRACUT, ORIGIN or TRANS, or cancels all three.
    pub(super) fn change_frame(&mut self) {
        match self.random.below(4) {
            0 => {
                let change = self.some_frame(40.0);
                let rows = [0, 1, 2].map(|row| {
                    let rotation = self.digits(change.axes.row(row).transpose(), 9);
                    format!("{rotation},{}", self.number(change.origin[row], 5))
                });
                self.line(&format!("TRACUT/{}", rows.join(",")));
                self.tracut = change;
            }
            1 => {
                let shift = Vector3::new(self.plus_minus(40.0), self.plus_minus(40.0), self.plus_minus(15.0));
                let numbers = self.numbers(shift, 5);
                self.line(&format!("TRANS/{numbers}"));
                self.translation = shift;
            }
            2 => {
                let shift = Vector3::new(self.plus_minus(40.0), self.plus_minus(40.0), self.plus_minus(15.0));
                let numbers = self.numbers(shift, 5);
                self.line(&format!("ORIGIN/{numbers}"));
                self.origin_of_file = shift;
            }
            _ => {
                self.line("TRACUT/NOMORE");
                self.line("TRANS/NOMORE");
                self.line("ORIGIN/NOMORE");
                (self.tracut, self.translation, self.origin_of_file) =
                    (Frame::none(), Vector3::zeros(), Vector3::zeros());
            }
        }
        self.compose();
    }

    /// Composes the transformations in force into one frame.
    fn compose(&mut self) {
        let shift = Frame { origin: self.translation - self.origin_of_file, ..Frame::none() };
        self.file = self.frame_of_file.with(&shift).with(&self.tracut);
    }

    /// A random frame: parallel, rotated about Z, by a right angle about X, or about all axes.
    fn some_frame(&mut self, far: f64) -> Frame {
        let origin = Vector3::new(self.plus_minus(far), self.plus_minus(far), self.plus_minus(far));
        let any = [0, 1, 2].map(|_| self.random.between(-180.0, 180.0));
        let [x, y, z] = match self.random.below(4) {
            0 => [0.0; 3],
            1 => [0.0, 0.0, any[2]],
            2 => [90.0 * self.random.sign(), 0.0, 0.0],
            _ => any,
        };
        let rotation = Rotation3::from_euler_angles(x.to_radians(), y.to_radians(), z.to_radians());
        Frame { axes: rotation.into_inner(), origin }
    }
}
