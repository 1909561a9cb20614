//! The path so far: where the tool is, how it came there, and how it moves next.

use crate::cl::text::{ClFault, Span};
use crate::kinematics::Pose;
use crate::nalgebra::{Point3, Vector3};
use crate::program::{ClearancePlane, Feed};

/// Position of the tool and the modes of its motion, in the workpiece frame.
#[derive(Debug, Default)]
pub(crate) struct PathState {
    here: Option<Pose>,
    /// Start of the feed line that led there.
    line_from: Option<Point3<f64>>,
    /// The last motion was a hole: the tool is above the point of its record.
    above_hole: bool,
    /// RAPID waits for its motion.
    rapid: bool,
    feed: Option<Feed>,
    clearance: Option<ClearancePlane>,
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

    /// RAPID.
    pub(crate) fn set_rapid(&mut self, rapid: bool) {
        self.rapid = rapid;
    }

    /// Whether RAPID waited; it does so no longer.
    pub(crate) fn take_rapid(&mut self) -> bool {
        std::mem::take(&mut self.rapid)
    }

    /// Position of the tool, for what counts from there.
    pub(crate) fn position(&self, name: &'static str, at: Span) -> Result<Pose, ClFault> {
        if self.above_hole {
            return Err(ClFault::new(
                name,
                at,
                format!("{name} stands behind a hole: whether it counts from the hole or from above it is not known"),
                "give a GOTO in front of it",
            ));
        }
        self.here.ok_or_else(|| {
            ClFault::new(
                name,
                at,
                format!("{name} counts from where the tool stands, and nothing before it says where that is"),
                "give a GOTO or FROM before it",
            )
        })
    }

    /// The feed line to a point, if it is one.
    pub(crate) fn line_to(&self, tip: Point3<f64>) -> Option<Vector3<f64>> {
        self.here.filter(|_| !self.rapid).map(|before| tip - before.tip)
    }

    /// The feed line that led to `tip`, where the tool is.
    pub(crate) fn line_before(&self, tip: Point3<f64>) -> Option<Vector3<f64>> {
        self.line_from.map(|from| tip - from)
    }

    /// A straight motion; answers whether it is rapid.
    #[inline]
    pub(crate) fn move_to(&mut self, pose: Pose) -> bool {
        self.motions += 1;
        self.above_hole = false;
        let rapid = std::mem::take(&mut self.rapid);
        self.line_from = if rapid { None } else { self.here.map(|pose| pose.tip) };
        self.here = Some(pose);
        rapid
    }

    /// A curve or an arc; where it ends is noted apart.
    pub(crate) fn count_motion(&mut self) {
        self.motions += 1;
        self.line_from = None;
    }

    /// The end of a motion, or where a refused one would have ended: what follows counts from there.
    pub(crate) fn set_here(&mut self, pose: Pose) {
        self.here = Some(pose);
    }

    /// FROM.
    pub(crate) fn start_at(&mut self, pose: Pose) {
        self.here = Some(pose);
        self.above_hole = false;
        self.line_from = None;
    }

    /// A point under a cycle.
    pub(crate) fn begin_hole(&mut self) {
        self.rapid = false;
        self.count_motion();
    }

    /// The tool is above a hole.
    pub(crate) fn end_hole(&mut self, above: Pose) {
        self.here = Some(above);
        self.above_hole = true;
    }

    /// GOHOME: neither RAPID nor a hole matters to it.
    pub(crate) fn begin_home(&mut self) {
        self.rapid = false;
        self.leave_hole();
        self.line_from = None;
    }

    /// The direction along the tool is the same from a hole and from above it.
    pub(crate) fn leave_hole(&mut self) {
        self.above_hole = false;
    }

    /// The next motion has no feed line before it.
    pub(crate) fn forget_line(&mut self) {
        self.line_from = None;
    }

    /// The position is unknown.
    pub(crate) fn forget_position(&mut self) {
        self.here = None;
        self.line_from = None;
    }

    /// Position and clearance plane belong to another frame.
    pub(crate) fn change_frame(&mut self) {
        (self.here, self.clearance) = (None, None);
    }
}
