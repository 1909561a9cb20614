//! The executed program as a stream: each block with the state before and after it, the path of the axes, the record of the
//! CL data that it carries out, and the findings about it.
//!
//! Positions are axis values of the machine; [`Leg::pose`] has tip and tool axis on the workpiece.

use nalgebra::{Point3, UnitVector3, Vector3};

use crate::kinematics::{AxisValues, Pose};
use crate::program::Location;

use super::geometry::{PathShape, Segment, ToolPose};
use super::read::{Action, ArcMove, Block, MAX_AXES, State};
use super::rules::{BlockPath, Rules};

/// Receives the blocks of a program in the order in which they are executed.
pub trait Observer {
    /// A block has been executed and compared. Blocks without effect are included, comments are not.
    fn executed(&mut self, executed: &ExecutedBlock<'_>);
}

impl<F: FnMut(&ExecutedBlock<'_>)> Observer for F {
    fn executed(&mut self, executed: &ExecutedBlock<'_>) {
        self(executed);
    }
}

/// A block of a program that has been executed.
pub struct ExecutedBlock<'b> {
    /// The block with the state after it.
    pub block: &'b Block,
    /// State before it.
    pub before: &'b State,
    /// Record of the CL data that was next, or the last one.
    pub record: Location,
    /// Number of findings about it.
    pub findings: u64,
    from: [f64; MAX_AXES],
    known: u16,
    rules: &'b Rules<'b>,
}

/// A part of a block in which the axes move at feed or at rapid: an arc, or a straight line of the words.
pub struct Leg<'b> {
    /// At rapid.
    pub rapid: bool,
    /// All axes arrive together; otherwise each moves on its own, and the path between the ends is unknown.
    pub together: bool,
    block: Block,
    from: [f64; MAX_AXES],
    /// Tool axis before the leg, where the program states tool axes.
    axis: Option<Vector3<f64>>,
    rules: &'b Rules<'b>,
}

impl<'b> ExecutedBlock<'b> {
    /// `from`: words before the block, and the bits of those that are known.
    pub(super) fn new(
        (block, before): (&'b Block, &'b State),
        (record, findings): (Location, u64),
        (from, known): ([f64; MAX_AXES], u16),
        rules: &'b Rules<'b>,
    ) -> Self {
        Self { block, before, record, findings, from, known, rules }
    }

    /// Position of the part zero from the reference point of the table in the set-up of the block, mm.
    #[must_use]
    pub fn part_origin(&self) -> Vector3<f64> {
        self.rules.words().part_origin()
    }

    /// The parts of the block, in order; none where nothing moves, where the start is unknown, and for machine coordinates.
    ///
    /// A cycle has its rapid over the hole and down to the clearance level, the feed to the bottom, and the way out; its
    /// pecks are the control's own.
    #[must_use]
    pub fn legs(&self) -> Vec<Leg<'b>> {
        let block = self.block;
        if !self.rules.is_known(block, self.known & block.known) {
            return Vec::new();
        }
        let leg = |action: Action, from: [f64; MAX_AXES], to: [f64; MAX_AXES]| Leg {
            rapid: action == Action::Rapid,
            together: action != Action::Rapid || self.rules.rapids_are_interpolated(),
            block: Block { action, values: to, faults: Vec::new(), ..block.clone() },
            from,
            axis: block.state.vector.map(|_| self.rules.words().place(&self.from, self.before).axis),
            rules: self.rules,
        };
        match block.action {
            Action::Rapid | Action::Feed | Action::Arc(_) => vec![leg(block.action, self.from, block.values)],
            Action::Cycle(cycle) => {
                let normal = block.state.plane.and_then(|plane| self.rules.words().xyz()[plane.axes()[2]]);
                let Some(normal) = normal else { return Vec::new() };
                let at = |level: f64| {
                    let mut words = block.values;
                    words[normal] = level;
                    words
                };
                let over = at(self.from[normal].max(cycle.reference));
                let (start, bottom, back) = (at(cycle.reference), at(cycle.bottom), at(cycle.back_to));
                let out = if cycle.retracts_at_feed() { Action::Feed } else { Action::Rapid };
                let legs = [
                    (Action::Rapid, self.from, over),
                    (Action::Rapid, over, start),
                    (Action::Feed, start, bottom),
                    (out, bottom, start),
                    (Action::Rapid, start, back),
                ];
                let moves = |(_, from, to): &(Action, [f64; MAX_AXES], [f64; MAX_AXES])| {
                    from.iter().zip(to).any(|(from, to)| (from - to).abs() > 0.0)
                };
                legs.into_iter().filter(moves).map(|(action, from, to)| leg(action, from, to)).collect()
            }
            Action::Nothing
            | Action::Machine
            | Action::Reference
            | Action::Orient
            | Action::Dwell(_)
            | Action::ToolChange
            | Action::Stop
            | Action::OptionalStop
            | Action::End => Vec::new(),
        }
    }
}

impl Leg<'_> {
    fn words(&self, share: f64) -> [f64; MAX_AXES] {
        let path: BlockPath<'_> = self.rules.path(self.from, &self.block);
        path.at(share)
    }

    /// Axis values at a share of the leg, 0 to 1, in mm and rad and in the order of the chain; `None` where the control
    /// chooses the rotary axes.
    #[must_use]
    pub fn axis_values(&self, share: f64) -> Option<AxisValues> {
        self.rules.words().axes(&self.words(share), &self.block.state)
    }

    /// Tip and tool axis on the workpiece at a share of the leg, mm. A stated tool axis rotates evenly from the one before it.
    #[must_use]
    pub fn pose(&self, share: f64) -> Pose {
        let to = self.rules.words().place(&self.words(share), &self.block.state);
        let pose = self.axis.map_or(to, |axis| {
            let from = ToolPose { axis, ..to };
            Segment { from, to, shape: PathShape::Line }.at(share)
        });
        Pose { tip: Point3::from(pose.tip), axis: UnitVector3::new_normalize(pose.axis) }
    }

    /// Angle of an arc about the normal of its plane, rad; 0 for a straight line.
    #[must_use]
    pub fn sweep(&self) -> f64 {
        match self.block.action {
            Action::Arc(ArcMove { sweep, .. }) => sweep,
            _ => 0.0,
        }
    }
}
