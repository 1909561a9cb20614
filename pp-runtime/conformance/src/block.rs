//! Deviation of one block, sampled along its length: largest distance of the tool from the motion whose tip path is
//! straight and whose tool axis rotates evenly.
//!
//! Every axis moves linearly, as a control moves it; poses come from the [oracle](crate::oracle).

use nalgebra::{Point3, Vector3};

use crate::oracle::{Oracle, angle_between};

/// Largest deviation of a block.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Deviation {
    /// Distance of the tip from the straight line, mm.
    pub tip_mm: f64,
    /// Angle of the tool axis from the arc, rad.
    pub axis_rad: f64,
    /// Largest speed of the tip, times the time of the block, mm.
    pub tip_rate_mm: f64,
    /// Angle of the tool axis from that of an even rotation at the same share of the block, rad.
    pub axis_step_rad: f64,
    /// Distance along the straight line from the point of an even motion at the same share, mm.
    pub tip_step_mm: f64,
    /// Angle of the tool axis from the programmed one, rad: where the tip is on its line.
    pub lag_rad: f64,
}

/// Tool axis at a share of the even rotation from one to another.
#[must_use]
pub fn rotated_evenly(from: &Vector3<f64>, to: &Vector3<f64>, share: f64) -> Vector3<f64> {
    let angle = angle_between(from, to);
    let across = (to - from * from.dot(to)).try_normalize(1e-300).unwrap_or_else(Vector3::zeros);
    (from * (angle * share).cos() + across * (angle * share).sin()).normalize()
}

/// Length that a block in which the axes lead the tip takes its time for, mm: the tip is nowhere a hundredth faster
/// than programmed, but for two units of the words. `tip_rate_mm`: its largest speed, times the time of the block.
#[must_use]
pub fn timed_mm(length_mm: f64, tip_rate_mm: f64, unit_mm: f64) -> f64 {
    length_mm.max((tip_rate_mm - 2.0 * unit_mm) / 1.01)
}

/// Distance of a point from the straight line between two others.
#[must_use]
pub fn distance_to_line(point: &Point3<f64>, from: &Point3<f64>, to: &Point3<f64>) -> f64 {
    let line = to - from;
    let length = line.norm_squared();
    let along = if length > 0.0 { ((point - from).dot(&line) / length).clamp(0.0, 1.0) } else { 0.0 };
    (point - (from + line * along)).norm()
}

/// Angle of a unit vector from the shorter arc between two others.
#[must_use]
pub fn angle_to_arc(axis: &Vector3<f64>, from: &Vector3<f64>, to: &Vector3<f64>) -> f64 {
    let normal = from.cross(to);
    if normal.norm() < 1e-7 && from.dot(to) > 0.0 {
        // An arc this short equals its chord.
        return distance_to_line(&Point3::from(*axis), &Point3::from(*from), &Point3::from(*to));
    }
    let ends = angle_between(axis, from).min(angle_between(axis, to));
    let past_an_end = normal.cross(from).dot(axis) < 0.0 || to.cross(&normal).dot(axis) < 0.0;
    if past_an_end {
        return ends;
    }
    // The plane contains `from`: `axis - from` is small, and so is the error that the rounding of the normal causes.
    let height = normal.normalize().dot(&(axis - from));
    height.abs().min(1.0).asin().min(ends)
}

/// Deviation of the block between two sets of axis values from the motion between its own end poses, with `points`
/// samples after the start.
#[must_use]
pub fn deviation(oracle: &Oracle, from: &[f64], to: &[f64], points: usize) -> Deviation {
    let (start, end) = (oracle.forward(from), oracle.forward(to));
    deviation_from(oracle, from, to, points, (&start.tip, &start.axis), (&end.tip, &end.axis))
}

/// Deviation of the block from the motion between two given poses.
#[must_use]
pub fn deviation_from(
    oracle: &Oracle,
    from: &[f64],
    to: &[f64],
    points: usize,
    start: (&Point3<f64>, &Vector3<f64>),
    end: (&Point3<f64>, &Vector3<f64>),
) -> Deviation {
    let mut largest = Deviation::default();
    let mut values = from.to_vec();
    let change: Vec<f64> = from.iter().zip(to).map(|(from, to)| to - from).collect();
    for point in 0..=points {
        let share = point as f64 / points as f64;
        for (value, (a, b)) in values.iter_mut().zip(from.iter().zip(to)) {
            *value = a + (b - a) * share;
        }
        let pose = oracle.forward(&values);
        largest.tip_mm = largest.tip_mm.max(distance_to_line(&pose.tip, start.0, end.0));
        largest.tip_rate_mm = largest.tip_rate_mm.max(oracle.rates(&values, &change).0.norm());
        largest.axis_rad = largest.axis_rad.max(angle_to_arc(&pose.axis, start.1, end.1));
        let off = |share: f64| angle_between(&pose.axis, &rotated_evenly(start.1, end.1, share));
        largest.axis_step_rad = largest.axis_step_rad.max(off(share));
        let line = end.0 - start.0;
        let length = line.norm();
        let along = if length > 0.0 { (pose.tip - start.0).dot(&line) / length } else { 0.0 };
        largest.tip_step_mm = largest.tip_step_mm.max((along - length * share).abs());
        let by_tip = if length > 0.0 { (along / length).clamp(0.0, 1.0) } else { share };
        largest.lag_rad = largest.lag_rad.max(off(by_tip));
    }
    largest
}
