//! Rotation conventions of tilted planes, each as its control has it.
//!
//! A matrix takes coordinates of the plane to those of the program. Angles in degrees, as the words are.

use nalgebra::{Matrix3, Rotation3, Vector3};

/// A turn about X (0), Y (1) or Z (2) by degrees.
pub(super) fn turn(axis: usize, degrees: f64) -> Matrix3<f64> {
    let mut direction = Vector3::zeros();
    direction[axis] = 1.0;
    *Rotation3::new(direction * degrees.to_radians()).matrix()
}

/// Words of G68.2 and G268.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct EulerWords {
    /// I J K, degrees.
    pub(crate) angles: [f64; 3],
    /// Q: the order of the turns.
    pub(crate) order: Option<u32>,
}

impl EulerWords {
    /// G68.2: about Z by I, about the new X by J, about the new Z by K.
    pub(super) fn euler(&self) -> Option<Matrix3<f64>> {
        let [i, j, k] = self.angles;
        self.order.is_none().then(|| turn(2, i) * turn(0, j) * turn(2, k))
    }

    /// G268: I J K turn about X Y Z of the work offset, which stay where they are; the digits of Q say in which order.
    ///
    /// As posts use it: FreeCAD's for the Haas next generation control writes `Q123` with spatial angles about the
    /// fixed axes. No worked example of the manufacturer is known here.
    pub(super) fn haas(&self) -> Option<Matrix3<f64>> {
        let order = self.order?;
        let digits = [order / 100, order / 10 % 10, order % 10];
        if order > 999 || digits.iter().any(|digit| !(1..=3).contains(digit)) || repeated(digits) {
            return None;
        }
        let turns = digits.map(|digit| turn(digit as usize - 1, self.angles[digit as usize - 1]));
        Some(turns[2] * turns[1] * turns[0])
    }
}

fn repeated([a, b, c]: [u32; 3]) -> bool {
    a == b || b == c || a == c
}

/// PLANE SPATIAL: about the fixed X by A, then the fixed Y by B, then the fixed Z by C.
pub(super) fn spatial([a, b, c]: [f64; 3]) -> Matrix3<f64> {
    turn(2, c) * turn(1, b) * turn(0, a)
}

/// CYCLE800 in mode axis by axis: two bits of the mode for each of its angles name the axis (1 X, 2 Y, 3 Z), the first
/// angle in the lowest bits; each turn is about the axes as the turns before have left them. `None` for other modes.
pub(super) fn axis_by_axis(mode: u32, angles: [f64; 3]) -> Option<Matrix3<f64>> {
    let axes = [mode & 3, mode >> 2 & 3, mode >> 4 & 3];
    if mode >> 6 != 0 || axes.contains(&0) || repeated(axes) {
        return None;
    }
    let turns = [0, 1, 2].map(|index| turn(axes[index] as usize - 1, angles[index]));
    Some(turns[0] * turns[1] * turns[2])
}
