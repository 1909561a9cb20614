//! NURBS of NX: knots and control points of a cubic B-spline, collected until another record ends it.
//!
//! NX implies four zero knots before the first listed one, multiplicity 4 of the last one, and the tool position as
//! first control point. So a curve lists two more control points than knots.

use crate::cl::text::{ClFault, Span};
use crate::diag::code::cl;
use crate::nalgebra::{Point3, UnitVector3, Vector3};
use crate::program::{Feed, Location, Spline};

/// Largest number of knots or control points of a curve; it bounds the memory. No curve of a tool path has as many.
const MOST_POINTS: usize = 100_000;

/// A curve, while it is read and when it is complete.
#[derive(Debug)]
struct NurbsCurve {
    knots: Vec<f64>,
    points: Vec<Point3<f64>>,
    axis: UnitVector3<f64>,
    feed: Option<Feed>,
    at: Location,
}

impl Default for NurbsCurve {
    fn default() -> Self {
        NurbsCurve {
            knots: Vec::new(),
            points: Vec::new(),
            axis: Vector3::z_axis(),
            feed: None,
            at: Location::default(),
        }
    }
}

impl NurbsCurve {
    /// Clears the curve and begins it at a point.
    fn begin(&mut self, start: Point3<f64>, axis: UnitVector3<f64>, feed: Option<Feed>, at: Location) {
        self.knots.clear();
        self.knots.extend([0.0; 4]);
        self.points.clear();
        self.points.push(start);
        (self.axis, self.feed, self.at) = (axis, feed, at);
    }

    /// Whether the curve is below [`MOST_POINTS`].
    fn has_room(&self) -> bool {
        self.knots.len() < MOST_POINTS && self.points.len() < MOST_POINTS
    }

    /// Adds the implied end knots; the error is the reason why knots and points define no curve.
    fn complete(&mut self) -> Result<(), String> {
        let (knots, points) = (self.knots.len() - 4, self.points.len() - 1);
        if knots == 0 || points != knots + 2 {
            return Err(format!("it lists {knots} knots and {points} control points, expected {}", knots + 2));
        }
        if self.knots.windows(2).any(|pair| pair[1] < pair[0]) {
            return Err("its knots decrease".into());
        }
        let last = self.knots[self.knots.len() - 1];
        self.knots.extend([last; 3]);
        // A cubic is discontinuous at an inner knot of multiplicity 4, and degenerate at an end knot of multiplicity 5.
        let inner = &self.knots[1..self.knots.len() - 1];
        if inner.windows(4).any(|four| four[3] <= four[0]) {
            return Err("it is discontinuous where too many of its knots are equal".into());
        }
        Ok(())
    }
}

/// The curve that is being read, and the one that was completed last.
#[derive(Debug, Default)]
pub(crate) struct OpenCurve {
    open: bool,
    reading: NurbsCurve,
    complete: NurbsCurve,
}

impl OpenCurve {
    pub(crate) fn is_open(&self) -> bool {
        self.open
    }

    /// NURBS: begins at the position of the tool.
    pub(crate) fn begin(&mut self, start: Point3<f64>, axis: UnitVector3<f64>, feed: Option<Feed>, here: Location) {
        self.reading.begin(start, axis, feed, here);
        self.open = true;
    }

    /// Refuses KNOT and CNTRL outside a NURBS, and beyond [`MOST_POINTS`].
    pub(crate) fn check_open(&self, name: &'static str, at: Span) -> Result<(), ClFault> {
        if self.open && self.reading.has_room() {
            return Ok(());
        }
        let text = if self.open {
            format!("this curve has more than {MOST_POINTS} knots or control points")
        } else {
            format!("{name} comes outside a NURBS")
        };
        Err(cl::ARC.cl_fault("NURBS", at, text, "write KNOT and CNTRL after NURBS/"))
    }

    /// KNOT.
    pub(crate) fn add_knots(&mut self, knots: impl Iterator<Item = f64>) {
        self.reading.knots.extend(knots);
    }

    /// CNTRL.
    pub(crate) fn add_point(&mut self, point: Point3<f64>) {
        self.reading.points.push(point);
    }

    /// Completes the curve; returns the place of its NURBS record.
    pub(crate) fn close(&mut self) -> Result<Location, ClFault> {
        self.open = false;
        if let Err(why) = self.reading.complete() {
            return Err(cl::ARC.cl_fault(
                "NURBS",
                Span::WHOLE,
                format!("the curve of line {} is invalid: {why}", self.reading.at.line),
                "the file may be cut off here; with the motion output Line NX writes lines in place of curves",
            ));
        }
        std::mem::swap(&mut self.reading, &mut self.complete);
        Ok(self.complete.at)
    }

    /// Curve that was completed last.
    pub(crate) fn completed(&self) -> Spline<'_> {
        let NurbsCurve { knots, points, axis, feed, .. } = &self.complete;
        Spline { knots, points, axis: *axis, feed: *feed }
    }
}
