//! How far two bodies move against each other at most while axes move.
//!
//! Only the axes between their links count. They are moved one after the other, from the first body on. A linear axis
//! by `v` moves the second body by `v`. A rotary axis by `v` moves no point of a body by more than `v` times its
//! distance from the centre line, and none by more than twice that distance; rotating the one body is the same as
//! rotating the other back, so the smaller of both counts. The distance of the second body is that at the beginning,
//! since the axes after it have not moved yet; that of the first one has grown by what the axes before have moved it.

use nalgebra::Point3;

use super::links::MachineLinks;
use crate::kinematics::{AxisValues, MAX_AXES};

/// A sphere around a body, in the coordinates of its link.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Ball {
    pub(crate) centre: Point3<f64>,
    pub(crate) radius: f64,
}

/// Axis values with the distances of two bodies from the centre lines there.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Levers {
    pub(crate) values: AxisValues,
    from: usize,
    to: usize,
    /// Of linear axes `None`; else largest distance of a point of the first and of the second body, mm.
    levers: [Option<[f64; 2]>; MAX_AXES],
}

impl Levers {
    /// Of bodies on two links, the first one nearer to the table.
    pub(crate) fn of(links: &MachineLinks, [from, to]: [usize; 2], balls: [&Ball; 2], values: &AxisValues) -> Self {
        let mut levers = [None; MAX_AXES];
        for (joint, lever) in levers.iter_mut().enumerate().take(to).skip(from) {
            let Some(line) = links.centre_line(joint) else { continue };
            let first = links.between(from, joint, values).inverse_transform_point(&balls[0].centre);
            let second = links.between(joint, to, values).transform_point(&balls[1].centre);
            *lever = Some([line.distance(&first) + balls[0].radius, line.distance(&second) + balls[1].radius]);
        }
        Self { values: *values, from, to, levers }
    }

    /// Largest motion of the bodies against each other while no axis value differs by more than `by` from that here,
    /// mm.
    pub(crate) fn motion(&self, by: &AxisValues) -> f64 {
        let (mut total, mut moved) = (0.0, 0.0);
        for (by, levers) in by.iter().zip(&self.levers).take(self.to).skip(self.from) {
            match levers {
                None => {
                    total += by;
                    moved += by;
                }
                Some([first, second]) => {
                    let angle = by.min(2.0);
                    let of_first = angle * (first + moved);
                    total += of_first.min(angle * second);
                    moved += of_first;
                }
            }
        }
        total
    }
}
