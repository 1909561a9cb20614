//! Angles to the first rotary axis, for the message about a tool axis that cannot be reached.

use crate::model::{AxisId, AxisKind};
use crate::solve::derivation::Derivation;
use crate::symbolic::{NodeVector, SineCosine, TermVector};

/// Angles to the first rotary, for diagnostics.
#[derive(Debug, Clone, Copy)]
pub struct Tilt {
    /// Angle between the first rotary and the wanted axis.
    pub wanted: SineCosine,
    /// Angle between the first and the second rotary; 0 with one rotary.
    pub between: SineCosine,
    /// Angle between the last rotary and the tool axis.
    pub tool: SineCosine,
    /// Direction of the first rotary in the workpiece frame, at the held values before it.
    pub direction: NodeVector,
}

/// Direction of a rotary with the held rotaries before it rotated.
pub(crate) fn in_workpiece<'g>(derivation: &'g Derivation<'_>, rotary: AxisId) -> TermVector<'g> {
    let before = (0..rotary).rev().filter(|id| derivation.model.axes[*id].kind == AxisKind::Rotary);
    before.fold(derivation.direction(rotary), |direction, id| derivation.rotated(id, direction))
}
