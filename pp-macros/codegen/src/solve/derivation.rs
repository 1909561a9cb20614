//! Directions, centres and rotations of the chain as terms, from which the formulas are built.

use crate::model::{AxisId, AxisKind, Model};
use crate::symbolic::{GraphBuilder, Poly, PolyVector, TermVector};

/// A model, and the graph that receives its formulas.
pub(crate) struct Derivation<'a> {
    pub(crate) model: &'a Model,
    pub(crate) graph: GraphBuilder,
}

/// A point relative to the centre of the rotary axis `from`; `None`: relative to the origin.
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

    /// Rotates a vector by the inverse of a rotary joint.
    pub(crate) fn rotated_back<'g>(&'g self, axis: AxisId, v: TermVector<'g>) -> TermVector<'g> {
        self.rotated_by(axis, v, !self.model.axes[axis].reversed)
    }

    fn rotated_by<'g>(&'g self, axis: AxisId, v: TermVector<'g>, back: bool) -> TermVector<'g> {
        let (sine, cosine) = self.model.axes[axis].sin_cos;
        let (sine, cosine) = (self.graph.input(sine), self.graph.input(cosine));
        let sine = sine.signed(!back);
        v.rotated(self.direction(axis), sine, cosine)
    }

    /// Signed direction of an axis: the displacement for 1 mm, or the rotation vector for 1 rad, of the word.
    pub(crate) fn step(&self, axis: AxisId) -> TermVector<'_> {
        let direction = self.direction(axis);
        if self.model.axes[axis].reversed { -direction } else { direction }
    }

    pub(crate) fn displacement(&self, axis: AxisId) -> TermVector<'_> {
        self.graph.input(self.model.axes[axis].word) * self.step(axis)
    }

    /// Names the components of a point after the axis to whose centre it is relative.
    pub(crate) fn name(&self, what: &str, axis: AxisId, offset: TermVector<'_>) {
        let letter = self.model.axes[axis].letter.to_ascii_lowercase();
        for (term, component) in offset.components().into_iter().zip(["x", "y", "z"]) {
            term.named(format!("{what}_{letter}_{component}"));
        }
    }

    /// The same point, relative to another centre. Centres on one side differ by their `d` only, whatever the set-up.
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
