//! State of the path: position of the tool, feed, RAPID, clearance plane, and the last feed line.

use crate::cl::text::{ClFault, Span};
use crate::diag::code::cl;
use crate::kinematics::Pose;
use crate::nalgebra::{Point3, Vector3};
use crate::program::{ClearancePlane, Feed};

/// Position of the tool and the modes of its motion, in the workpiece frame.
#[derive(Debug, Default)]
pub(crate) struct PathState {
    here: Option<Pose>,
    /// Start of the feed line that ends at `here`; `None` after any other motion.
    line_from: Option<Point3<f64>>,
    /// The last motion was a hole: the tool is above the point of its GOTO.
    above_hole: bool,
    /// RAPID has come; the next motion is a rapid.
    rapid: bool,
    feed: Option<Feed>,
    clearance: Option<ClearancePlane>,
    /// Number of motions so far.
    motions: u64,
}

impl PathState {
    pub(crate) fn here(&self) -> Option<Pose> {
        self.here
    }

    pub(crate) fn feed(&self) -> Option<Feed> {
        self.feed
    }

    pub(crate) fn motions(&self) -> u64 {
        self.motions
    }

    pub(crate) fn clearance(&self) -> Option<ClearancePlane> {
        self.clearance
    }

    pub(crate) fn is_above_hole(&self) -> bool {
        self.above_hole
    }

    /// FEDRAT.
    pub(crate) fn set_feed(&mut self, feed: Feed) {
        self.feed = Some(feed);
    }

    /// CLEARP.
    pub(crate) fn set_clearance(&mut self, plane: ClearancePlane) {
        self.clearance = Some(plane);
    }

    /// Sets or cancels RAPID for the next motion.
    pub(crate) fn set_rapid(&mut self, rapid: bool) {
        self.rapid = rapid;
    }

    /// Whether the next motion is a rapid.
    pub(crate) fn is_rapid(&self) -> bool {
        self.rapid
    }

    /// Returns whether RAPID is set, and cancels it.
    pub(crate) fn take_rapid(&mut self) -> bool {
        std::mem::take(&mut self.rapid)
    }

    /// Position of the tool, for the record `name`, which is relative to it. Refused where it is unknown or ambiguous.
    #[inline]
    pub(crate) fn position(&self, name: &'static str, at: Span) -> Result<Pose, ClFault> {
        match self.here {
            Some(here) if !self.above_hole => Ok(here),
            _ => Err(self.no_position(name, at)),
        }
    }

    #[cold]
    fn no_position(&self, name: &'static str, at: Span) -> ClFault {
        let (text, help) = if self.above_hole {
            let text = "after a hole is ambiguous: it may start from the hole or from the level above it";
            (text, "program a GOTO before it")
        } else {
            ("is relative to the tool position, which is unknown here", "program a GOTO or FROM before it")
        };
        cl::POSITION.cl_fault(name, at, format!("{name} {text}"), help)
    }

    /// Vector of the motion to a point, if that motion is a feed line.
    pub(crate) fn line_to(&self, tip: Point3<f64>) -> Option<Vector3<f64>> {
        self.here.filter(|_| !self.rapid).map(|before| tip - before.tip)
    }

    /// Vector of the feed line that ended at `tip`, the position of the tool.
    pub(crate) fn line_before(&self, tip: Point3<f64>) -> Option<Vector3<f64>> {
        self.line_from.map(|from| tip - from)
    }

    /// Executes a straight motion; returns whether it is a rapid.
    #[inline]
    pub(crate) fn move_to(&mut self, pose: Pose) -> bool {
        self.motions += 1;
        self.above_hole = false;
        let rapid = std::mem::take(&mut self.rapid);
        self.line_from = if rapid { None } else { self.here.map(|pose| pose.tip) };
        self.here = Some(pose);
        rapid
    }

    /// Counts a curve or an arc; its end is set by [`set_here`](Self::set_here).
    pub(crate) fn count_motion(&mut self) {
        self.motions += 1;
        self.line_from = None;
    }

    /// Sets the position: the end of a motion, also of a refused one.
    pub(crate) fn set_here(&mut self, pose: Pose) {
        self.here = Some(pose);
    }

    /// Sets the position of FROM.
    pub(crate) fn start_at(&mut self, pose: Pose) {
        self.here = Some(pose);
        self.above_hole = false;
        self.line_from = None;
    }

    /// Begins a hole: GOTO while a cycle is active.
    pub(crate) fn begin_hole(&mut self) {
        self.rapid = false;
        self.count_motion();
    }

    /// Ends a hole: the tool is above it.
    pub(crate) fn end_hole(&mut self, above: Pose) {
        self.here = Some(above);
        self.above_hole = true;
    }

    /// Begins GOHOME: cancels RAPID; it is absolute, so it may follow a hole.
    pub(crate) fn begin_home(&mut self) {
        self.rapid = false;
        self.leave_hole();
        self.line_from = None;
    }

    /// Permits RETRCT after a hole: along the tool axis it is the same from the hole and from above it.
    pub(crate) fn leave_hole(&mut self) {
        self.above_hole = false;
    }

    /// Forgets the feed line before the next motion.
    pub(crate) fn forget_line(&mut self) {
        self.line_from = None;
    }

    /// Forgets the position.
    pub(crate) fn forget_position(&mut self) {
        self.here = None;
        self.line_from = None;
    }

    /// Forgets position and clearance plane: they are in another frame.
    pub(crate) fn change_frame(&mut self) {
        (self.here, self.clearance) = (None, None);
    }
}
