//! In which frame the numbers of the file are: MSYS, TRACUT, ORIGIN and TRANS.
//!
//! A point goes through TRACUT, then ORIGIN is subtracted or TRANS added, then the frame of the operation is mapped into the
//! first. Programs are made in the first frame, and written through the inverse of all that.

use nalgebra::{Matrix3, Rotation3, Vector3};

use super::Program;

/// What is done with frames behind the first.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Frames {
    /// There are none.
    None,
    /// Their points are mapped into the first.
    Main,
    /// Each has a work offset of its own, and its points stay as they are.
    Offset,
}

/// Frames that a file may state.
pub(crate) const FRAMES: usize = 3;

/// A frame as it lies in another, mm.
#[derive(Debug, Clone, Copy)]
pub(super) struct Frame {
    axes: Matrix3<f64>,
    origin: Vector3<f64>,
}

impl Frame {
    pub(super) fn none() -> Self {
        Self { axes: Matrix3::identity(), origin: Vector3::zeros() }
    }

    /// Coordinates in this frame of a point and of a direction.
    pub(super) fn point(&self, point: Vector3<f64>) -> Vector3<f64> {
        self.axes.transpose() * (point - self.origin)
    }

    pub(super) fn direction(&self, direction: Vector3<f64>) -> Vector3<f64> {
        self.axes.transpose() * direction
    }

    /// What a direction in this frame is outside it.
    pub(super) fn outside(&self, direction: Vector3<f64>) -> Vector3<f64> {
        self.axes * direction
    }

    /// A frame that lies in this one.
    fn with(&self, inner: &Self) -> Self {
        Self { axes: self.axes * inner.axes, origin: self.origin + self.axes * inner.origin }
    }
}

impl Program<'_> {
    /// The frames of the file: the first is that of the part, wherever it lies in the model.
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

    /// MSYS of an operation.
    pub(super) fn enter_frame(&mut self) {
        // The first that is stated is that of the part.
        let number = if self.stated { self.random.below(self.frames.len()) } else { 0 };
        self.stated = true;
        let (model, frame) = self.frames[number];
        let origin = self.numbers(model.origin, 5);
        let axes = [0, 1].map(|axis| self.digits(model.axes.column(axis).into_owned(), 9));
        self.line(&format!("MSYS/{origin},{},{}", axes[0], axes[1]));
        self.frame_of_file = frame;
        self.join();
    }

    /// TRACUT, ORIGIN, TRANS, or none of them any more.
    pub(super) fn change(&mut self) {
        match self.random.below(4) {
            0 => {
                let change = self.some_frame(40.0);
                let rows = [0, 1, 2].map(|row| {
                    let turn = self.digits(change.axes.row(row).transpose(), 9);
                    format!("{turn},{}", self.number(change.origin[row], 5))
                });
                self.line(&format!("TRACUT/{}", rows.join(",")));
                self.tracut = change;
            }
            1 => {
                let shift = Vector3::new(self.around(40.0), self.around(40.0), self.around(15.0));
                let numbers = self.numbers(shift, 5);
                self.line(&format!("TRANS/{numbers}"));
                self.translation = shift;
            }
            2 => {
                let shift = Vector3::new(self.around(40.0), self.around(40.0), self.around(15.0));
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
        self.join();
    }

    /// Everything that is in force, as one frame.
    fn join(&mut self) {
        let shift = Frame { origin: self.translation - self.origin_of_file, ..Frame::none() };
        self.file = self.frame_of_file.with(&shift).with(&self.tracut);
    }

    /// A frame somewhere: turned about Z, about an axis by right angles, or anyhow.
    fn some_frame(&mut self, far: f64) -> Frame {
        let origin = Vector3::new(self.around(far), self.around(far), self.around(far));
        let any = [0, 1, 2].map(|_| self.random.between(-180.0, 180.0));
        let [x, y, z] = match self.random.below(4) {
            0 => [0.0; 3],
            1 => [0.0, 0.0, any[2]],
            2 => [90.0 * self.random.sign(), 0.0, 0.0],
            _ => any,
        };
        let turn = Rotation3::from_euler_angles(x.to_radians(), y.to_radians(), z.to_radians());
        Frame { axes: turn.into_inner(), origin }
    }
}
