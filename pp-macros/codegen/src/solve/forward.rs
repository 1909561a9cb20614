//! Pose from axis values: the joints applied to the tool point, last joint first.

use super::Chain;
use crate::model::{Kind, Model};
use crate::symbolic::V3;

/// Nodes of the forward map.
#[derive(Debug, Clone, Copy)]
pub struct Forward {
    /// Tool tip.
    pub tip: V3,
    /// Tool axis.
    pub axis: V3,
}

pub(super) fn solve(chain: &mut Chain<'_>) -> Forward {
    let model: &Model = chain.model;
    let mut tip = chain.origin();
    let mut axis = chain.tool_axis();
    for id in (0..model.axes.len()).rev() {
        match model.axes[id].kind {
            Kind::Linear => {
                let by = chain.displacement(id);
                tip.offset = chain.graph.add_vectors(tip.offset, by);
            }
            Kind::Rotary => {
                tip = chain.seen_from(tip, Some(id));
                tip.offset = chain.turn(id, tip.offset);
                axis = chain.turn(id, axis);
            }
        }
    }
    Forward { tip: chain.seen_from(tip, None).offset, axis }
}
