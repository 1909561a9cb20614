//! Pose from axis values: the joints applied to the tool point, last joint first.

use super::derivation::{Derivation, Point};
use crate::model::AxisKind;
use crate::symbolic::NodeVector;

/// Nodes of the forward kinematics.
#[derive(Debug, Clone, Copy)]
pub struct Forward {
    /// Tool tip.
    pub tip: NodeVector,
    /// Tool axis.
    pub axis: NodeVector,
}

pub(crate) fn solve(derivation: &Derivation<'_>) -> Forward {
    let mut tip = derivation.origin();
    let mut axis = derivation.tool_axis();
    for (id, joint) in derivation.model.axes.iter().enumerate().rev() {
        match joint.kind {
            AxisKind::Linear => {
                let displacement = derivation.displacement(id);
                tip.offset = tip.offset + displacement;
            }
            AxisKind::Rotary => {
                let Point { from, offset } = derivation.seen_from(tip, Some(id));
                tip = Point { from, offset: derivation.rotated(id, offset) };
                axis = derivation.rotated(id, axis);
            }
        }
    }
    Forward { tip: derivation.seen_from(tip, None).offset.ids(), axis: axis.ids() }
}
