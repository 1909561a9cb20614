//! The chain as terms: directions, centres and rotations that formulas are written with.

use crate::model::{AxisId, AxisKind, Model};
use crate::symbolic::{GraphBuilder, Poly, PolyVector, TermVector};

/// A model, and the graph that its formulas are written into.
pub(crate) struct Derivation<'a> {
    pub(crate) model: &'a Model,
    pub(crate) graph: GraphBuilder,
}

/// A point given from the centre of a rotary axis, or from the origin.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Point<'g> {
    pub(crate) from: Option<AxisId>,
    pub(crate) offset: TermVector<'g>,
}

impl Derivation<'_> {
    pub(crate) fn direction(&self, axis: AxisId) -> TermVector<'_> {
        self.graph.declared(&self.model.axes[axis].direction)
    }

    pub(crate) fn tool_axis(&self) -> TermVector<'_> {
        self.graph.declared(&self.model.tool_axis)
    }

    pub(crate) fn joint_centre(&self, axis: AxisId) -> TermVector<'_> {
        match self.model.axes[axis].kind {
            AxisKind::Linear => self.graph.zero_vector(),
            AxisKind::Rotary => self.graph.declared(&self.model.centre(axis)),
        }
    }

    pub(crate) fn origin(&self) -> Point<'_> {
        Point { from: None, offset: self.graph.zero_vector() }
    }

    /// Rotates a vector by a rotary joint whose word is an input.
    pub(crate) fn rotated<'g>(&'g self, axis: AxisId, v: TermVector<'g>) -> TermVector<'g> {
        self.rotated_by(axis, v, self.model.axes[axis].reversed)
    }

    /// Rotates a vector against a rotary joint.
    pub(crate) fn rotated_back<'g>(&'g self, axis: AxisId, v: TermVector<'g>) -> TermVector<'g> {
        self.rotated_by(axis, v, !self.model.axes[axis].reversed)
    }

    fn rotated_by<'g>(&'g self, axis: AxisId, v: TermVector<'g>, back: bool) -> TermVector<'g> {
        let (sine, cosine) = self.model.axes[axis].sin_cos;
        let (sine, cosine) = (self.graph.input(sine), self.graph.input(cosine));
        let sine = sine.signed(!back);
        v.rotated(self.direction(axis), sine, cosine)
    }

    /// Signed direction of an axis: what a millimetre, or a radian, of the word does.
    pub(crate) fn step(&self, axis: AxisId) -> TermVector<'_> {
        let direction = self.direction(axis);
        if self.model.axes[axis].reversed { -direction } else { direction }
    }

    pub(crate) fn displacement(&self, axis: AxisId) -> TermVector<'_> {
        self.graph.input(self.model.axes[axis].word) * self.step(axis)
    }

    /// Names the components of a point after the axis it is seen from.
    pub(crate) fn name(&self, what: &str, axis: AxisId, offset: TermVector<'_>) {
        let letter = self.model.axes[axis].letter.to_ascii_lowercase();
        for (term, component) in offset.components().into_iter().zip(["x", "y", "z"]) {
            term.named(format!("{what}_{letter}_{component}"));
        }
    }

    /// The same point, given from another centre. Centres on one side differ by their `d` alone, whatever the set-up.
    pub(crate) fn seen_from<'g>(&'g self, point: Point<'g>, from: Option<AxisId>) -> Point<'g> {
        if point.from == from {
            return point;
        }
        let side = |axis: Option<AxisId>| axis.map(|axis| self.model.axes[axis].side);
        let centre = |axis: Option<AxisId>, whole: bool| match axis {
            None => std::array::from_fn(|_| Poly::zero()),
            Some(axis) if whole => self.model.centre(axis),
            Some(axis) => self.model.axes[axis].point.clone(),
        };
        let whole = side(point.from) != side(from);
        let (old, new) = (centre(point.from, whole), centre(from, whole));
        let shift: PolyVector = std::array::from_fn(|index| &old[index] - &new[index]);
        Point { from, offset: point.offset + self.graph.declared(&shift) }
    }
}
