//! The box of a rapid in which each axis moves at its own speed, and the axes arrive in any order.

use nalgebra::Point3;

use crate::kinematics::AxisKind;

use super::{AxisPosition, Placer};
use crate::tolerance::writer::SAME_AXIS_VALUE;

/// Largest distance of the centre line of a rotary axis from the part zero, mm.
const FARTHEST_CENTRE_MM: f64 = 5000.0;

/// Tips that such a rapid may reach.
#[derive(Debug, Clone)]
pub(crate) struct DogLeg {
    /// Tips at the corners of the box of axis values.
    pub(crate) corners: Vec<Point3<f64>>,
    /// Largest distance of a tip in the box from the convex hull of the corners, mm.
    pub(crate) beyond_mm: f64,
}

impl Placer {
    /// The box of a rapid between two positions; `None` where a single linear axis moves, on a line.
    ///
    /// At fixed rotary axes the tip is an affine function of the linear ones. Where a rotary axis rotates by θ, a tip
    /// at the distance r from its centre line is no farther than r·θ²/8 from the chord.
    pub(crate) fn dog_leg(&self, from: &AxisPosition, to: &AxisPosition) -> Option<DogLeg> {
        let moves = |index: &usize| (from.axes[*index] - to.axes[*index]).abs() > SAME_AXIS_VALUE;
        let moved: Vec<usize> = (0..self.chain.len()).filter(moves).collect();
        let rotary = || moved.iter().filter(|index| self.chain[**index].kind == AxisKind::Rotary);
        if moved.len() < 2 && rotary().next().is_none() {
            return None;
        }
        let corner = |arrived: u32| {
            let mut axes = from.axes;
            for (bit, &index) in moved.iter().enumerate() {
                if arrived & (1 << bit) != 0 {
                    axes[index] = to.axes[index];
                }
            }
            self.machine.forward_kinematics(&axes).tip
        };
        let corners: Vec<Point3<f64>> = (0..1 << moved.len()).map(corner).collect();
        let farthest = corners.iter().map(|tip| tip.coords.norm()).fold(0.0, f64::max);
        let bent: f64 = rotary().map(|&index| (to.axes[index] - from.axes[index]).powi(2) / 8.0).sum();
        Some(DogLeg { corners, beyond_mm: (FARTHEST_CENTRE_MM + farthest) * bent })
    }
}
