//! The motions of a hole, level by level.

use super::super::geometry::{ToolPose, angle_between, tool_pose};
use crate::check::tolerances::{MOST_HOLE_STEPS, SAME_AXIS, SAME_LEVEL};
use crate::kinematics::Pose;
use crate::program::{Drilling, Dwell, Hole, Move};

/// A hole that is expected.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ExpectedHole {
    /// Number of the hole: its motions have the same number.
    pub(crate) number: u64,
    pub(crate) hole: Hole,
}

impl ExpectedHole {
    /// Tip and tool axis on the clearance level.
    pub(crate) fn clearance_point(&self) -> ToolPose {
        tool_pose(&self.hole.level(self.hole.clearance_mm))
    }

    /// Where an approach ends whose first motion leads to `to`, over the hole: on the return level, and not below the
    /// approach distance; `None` if the motion leads elsewhere.
    pub(crate) fn approach_point(&self, to: &ToolPose, approach_mm: f64) -> Option<ToolPose> {
        let hole = &self.hole;
        let level = hole.return_mm.max(hole.clearance_mm + approach_mm);
        let clearance = self.clearance_point();
        let height = (to.tip - clearance.tip).dot(&clearance.axis);
        let leads_over =
            height >= -SAME_LEVEL && (to.tip - clearance.tip - clearance.axis * height).norm() <= SAME_LEVEL;
        leads_over.then(|| tool_pose(&hole.level(level)))
    }
}

/// One step of a hole by motions.
pub(crate) enum HoleStep {
    Move(Move),
    Dwell(Dwell),
}

/// The motions of a hole from where the tool is.
pub(crate) fn unfolded(hole: &Hole, here: Option<&Pose>, peck_gap_mm: f64) -> Vec<HoleStep> {
    let (top, axis) = (hole.top.tip, hole.top.axis);
    let level = |height: f64| Pose { tip: top + axis.into_inner() * height, axis };
    let motion = |pose: Pose, rapid: bool| HoleStep::Move(Move { pose, rapid, feed: hole.feed });
    let mut steps = Vec::new();
    let same_axis = here.filter(|here| angle_between(&here.axis, &axis) <= SAME_AXIS);
    if let Some(here) = same_axis {
        let height = (here.tip - top).dot(&axis);
        let lift = hole.clearance_mm - height;
        if lift > SAME_LEVEL {
            steps.push(motion(Pose { tip: here.tip + axis.into_inner() * lift, axis }, true));
        }
        let over = level(height.max(hole.clearance_mm));
        if (over.tip - here.tip).norm() > SAME_LEVEL {
            steps.push(motion(over, true));
        }
    }
    steps.push(motion(level(hole.clearance_mm), true));
    let (first, later) = match hole.drilling {
        Drilling::Peck { first_mm, later_mm } => (first_mm, later_mm),
        Drilling::ChipBreak { step_mm, .. } => (step_mm, step_mm),
        Drilling::Drill
        | Drilling::Ream
        | Drilling::FineBore { .. }
        | Drilling::Through { .. }
        | Drilling::Tap { .. } => (hole.depth_mm, hole.depth_mm),
    };
    if let Drilling::Through { gaps } = hole.drilling {
        // Through each plate at feed, through the gap below it at rapid.
        steps.extend(
            gaps.iter()
                .flat_map(|gap| [motion(level(-gap.feed_ends_mm), false), motion(level(-gap.feed_begins_mm), true)]),
        );
    }
    let mut depth = first.min(hole.depth_mm);
    for _ in 0..MOST_HOLE_STEPS {
        if depth > hole.depth_mm - SAME_LEVEL {
            depth = hole.depth_mm;
        }
        steps.push(motion(level(-depth), false));
        if depth >= hole.depth_mm {
            break;
        }
        if matches!(hole.drilling, Drilling::Peck { .. }) {
            steps.push(motion(level(hole.clearance_mm), true));
        }
        let back = match hole.drilling {
            Drilling::ChipBreak { retract_mm: Some(back), .. } => back,
            _ => peck_gap_mm,
        };
        steps.push(motion(level((back - depth).min(hole.clearance_mm)), true));
        depth += later;
    }
    steps.extend(hole.dwell.map(HoleStep::Dwell));
    if matches!(hole.drilling, Drilling::Ream | Drilling::Tap { .. }) {
        steps.push(motion(level(hole.clearance_mm), false));
    }
    steps.push(motion(level(hole.return_mm), true));
    steps
}
