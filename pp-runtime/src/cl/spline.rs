//! NURBS of NX: knots and control points of a cubic, collected until the next record ends it.
//!
//! Four zero knots are implied in front, the last one counts four times, and the first control point is where the tool
//! stands. So the points listed are two more than the knots listed.

use crate::nalgebra::{Point3, UnitVector3, Vector3};
use crate::program::{Feed, Location};

/// More control points than this are not one curve of a tool path; it bounds the memory.
const MOST_POINTS: usize = 100_000;

/// A curve, while it is read and when it is complete.
#[derive(Debug)]
pub(super) struct Curve {
    pub(super) knots: Vec<f64>,
    pub(super) points: Vec<Point3<f64>>,
    pub(super) axis: UnitVector3<f64>,
    pub(super) feed: Option<Feed>,
    pub(super) at: Location,
}

impl Default for Curve {
    fn default() -> Self {
        Curve { knots: Vec::new(), points: Vec::new(), axis: Vector3::z_axis(), feed: None, at: Location::default() }
    }
}

impl Curve {
    /// Begins at a point.
    pub(super) fn begin(&mut self, start: Point3<f64>, axis: UnitVector3<f64>, feed: Option<Feed>, at: Location) {
        self.knots.clear();
        self.knots.extend([0.0; 4]);
        self.points.clear();
        self.points.push(start);
        (self.axis, self.feed, self.at) = (axis, feed, at);
    }

    /// Whether there is room for more.
    pub(super) fn has_room(&self) -> bool {
        self.knots.len() < MOST_POINTS && self.points.len() < MOST_POINTS
    }

    /// Completes the knots; says what is wrong otherwise.
    pub(super) fn complete(&mut self) -> Result<(), String> {
        let (knots, points) = (self.knots.len() - 4, self.points.len() - 1);
        if knots == 0 || points != knots + 2 {
            return Err(format!("it lists {knots} knots and {points} control points, which must be two more"));
        }
        if self.knots.windows(2).any(|pair| pair[1] < pair[0]) {
            return Err("its knots do not rise".into());
        }
        let last = self.knots[self.knots.len() - 1];
        self.knots.extend([last; 3]);
        // A cubic breaks at four equal knots; at its ends, where they are implied, at a fifth.
        let inner = &self.knots[1..self.knots.len() - 1];
        if inner.windows(4).any(|four| four[3] <= four[0]) {
            return Err("it breaks where too many of its knots are equal".into());
        }
        Ok(())
    }
}
