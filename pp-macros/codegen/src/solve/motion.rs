//! Derivatives of tip and tool axis while the axes move linearly: the first two, and a bound of the third.
//!
//! Computed from the tool to the workpiece. A linear axis adds to the first derivative; a rotary axis about `n` through
//! `c` with the rate `δ` maps a point `y` to `z = c + R (y - c)` with
//!
//! ```text
//! z'  = R (y' + δ n × (y - c))
//! z'' = R (y'' + δ n × (2 y' + δ n × (y - c)))
//! |z'''| <= M + |δ| (3 A + |δ| (3 V + |δ| ρ))
//! ```
//!
//! where `V A M` are the largest `|y'| |y''| |y'''|` of the block and `ρ` the largest `|n × (y - c)|`. The values in
//! the middle of the block bound them: `A <= |y''| + M/2`, `V <= |y'| + A/2`, `ρ <= |n × (y - c)| + V/2`. From these
//! the runtime, `pp_runtime::kinematics::MotionBound`, computes the deviation of the block.
//!
//! A deviation is the same from wherever it is seen, so the outermost rotary axis is not rotated for it: a linear axis
//! after it is rotated back instead.

use super::derivation::{Derivation, Point};
use crate::model::{Axis, AxisId, AxisKind, Model};
use crate::symbolic::{Graph, GraphBuilder, Id, Node, NodeVector, Symbol, Term, TermVector};

/// Nodes of the derivatives, in a graph of their own.
#[derive(Debug)]
pub struct Motion {
    /// The nodes.
    pub graph: Graph,
    /// Change of every axis over the block, mm or rad; the block takes one unit of time, so these are the rates.
    pub changes: Vec<Symbol>,
    /// Absolute values of the changes.
    pub sizes: Vec<Symbol>,
    /// First derivatives of tip and tool axis in the workpiece frame.
    pub rates: [NodeVector; 2],
    /// Derivatives of the tip, as seen from the inner side of the outermost rotary axis.
    pub tip: Curve,
    /// The tool axis, as seen from there.
    pub axis: NodeVector,
    /// Its derivatives.
    pub axis_curve: Curve,
    /// Centres of the rotary axes for the current set-up.
    pub centres: Vec<NodeVector>,
}

/// Two derivatives, and a bound of the third over a block with these values in its middle.
#[derive(Debug, Clone, Copy)]
pub struct Curve {
    /// First derivative.
    pub rate: NodeVector,
    /// Second derivative.
    pub bend: NodeVector,
    /// Upper bound of the length of the third derivative.
    pub third: Id,
}

pub(crate) fn solve(model: &Model) -> Motion {
    let graph = GraphBuilder::new(model.ring.clone());
    let symbols = |what: &str| -> Vec<Symbol> {
        let name = |axis: &Axis| format!("{what}_{}", axis.letter.to_ascii_lowercase());
        model.axes.iter().map(|axis| graph.symbol(name(axis))).collect()
    };
    let (changes, sizes) = (symbols("change"), symbols("size"));
    let derivation = Derivation { model, graph };
    let moving = Moving { derivation: &derivation, changes: &changes, sizes: &sizes };
    let (mut tip, mut tip_curve) = (derivation.origin(), moving.at_rest());
    let (mut axis, mut axis_curve) = (derivation.tool_axis(), moving.at_rest());
    let outermost = model.axes.iter().position(|axis| axis.kind == AxisKind::Rotary);
    let mut seen_inside: Option<(Derivatives<'_>, _, _)> = None;
    for (id, joint) in model.axes.iter().enumerate().rev() {
        match joint.kind {
            AxisKind::Linear => {
                let displacement = derivation.displacement(id);
                tip.offset = tip.offset + displacement;
                tip_curve = tip_curve.moved(moving.change(id) * derivation.step(id));
                if let (Some((inside, ..)), Some(outermost)) = (&mut seen_inside, outermost) {
                    let step = derivation.rotated_back(outermost, derivation.step(id));
                    *inside = inside.moved(moving.change(id) * step);
                }
            }
            AxisKind::Rotary => {
                tip = derivation.seen_from(tip, Some(id));
                tip_curve = moving.before_rotation("tip", id, tip.offset, tip_curve);
                axis_curve = moving.before_rotation("axis", id, axis, axis_curve);
                if outermost == Some(id) {
                    seen_inside = Some((tip_curve, axis, axis_curve));
                }
                tip = Point { offset: derivation.rotated(id, tip.offset), ..tip };
                (tip_curve, axis_curve) = (moving.rotated(id, tip_curve), moving.rotated(id, axis_curve));
                axis = derivation.rotated(id, axis);
            }
        }
    }
    let rotary = |id: &AxisId| model.axes[*id].kind == AxisKind::Rotary;
    let centres = (0..model.axes.len()).filter(rotary).map(|id| derivation.joint_centre(id).ids()).collect();
    let rates = [tip_curve.rate.ids(), axis_curve.rate.ids()];
    let (tip, axis, axis_curve) = seen_inside.unwrap_or((tip_curve, axis, axis_curve));
    let (tip, axis, axis_curve) = (tip.nodes(), axis.ids(), axis_curve.nodes());
    Motion { graph: derivation.graph.finish(), changes, sizes, rates, tip, axis, axis_curve, centres }
}

/// A chain whose axes move.
struct Moving<'a> {
    derivation: &'a Derivation<'a>,
    changes: &'a [Symbol],
    sizes: &'a [Symbol],
}

/// A [`Curve`] under construction: `y'`, `y''` and `M`.
#[derive(Clone, Copy)]
struct Derivatives<'g> {
    rate: TermVector<'g>,
    bend: TermVector<'g>,
    third: Term<'g>,
    /// Vectors as long as the first two, with shorter formulas where the last axis is a rotary one: as seen before its
    /// rotation.
    as_long: [TermVector<'g>; 2],
}

impl<'g> Derivatives<'g> {
    fn new(rate: TermVector<'g>, bend: TermVector<'g>, third: Term<'g>) -> Self {
        Self { rate, bend, third, as_long: [rate, bend] }
    }

    /// With a motion of a linear axis.
    fn moved(self, rate: TermVector<'g>) -> Self {
        let rate = self.rate + rate;
        Self { rate, as_long: [rate, self.as_long[1]], ..self }
    }

    fn nodes(self) -> Curve {
        Curve { rate: self.rate.ids(), bend: self.bend.ids(), third: self.third.id() }
    }
}

impl<'g> Moving<'g> {
    fn at_rest(&self) -> Derivatives<'g> {
        let zero = self.derivation.graph.zero_vector();
        Derivatives::new(zero, zero, self.derivation.graph.integer(0))
    }

    /// Derivatives of a point after a rotary axis, as seen before its rotation; `lever` is the vector from the centre
    /// of the axis to the point.
    fn before_rotation(
        &self,
        what: &str,
        axis: AxisId,
        lever: TermVector<'g>,
        curve: Derivatives<'g>,
    ) -> Derivatives<'g> {
        let Derivatives { rate, bend, .. } = curve;
        let direction = self.derivation.step(axis);
        let change = self.change(axis);
        let swing = direction.cross(lever);
        self.derivation.name(&format!("{what}_swing"), axis, swing);
        let third = self.third(axis, swing, curve);
        let by_rotation = change * swing;
        let by_bend = change * direction.cross(rate + rate + by_rotation);
        Derivatives::new(rate + by_rotation, bend + by_bend, third)
    }

    fn rotated(&self, axis: AxisId, curve: Derivatives<'g>) -> Derivatives<'g> {
        let turn = |v| self.derivation.rotated(axis, v);
        Derivatives { rate: turn(curve.rate), bend: turn(curve.bend), ..curve }
    }

    /// `M + |δ| (3 A + |δ| (3 V + |δ| ρ))`, computed from the innermost bracket outwards.
    fn third(&self, axis: AxisId, swing: TermVector<'g>, curve: Derivatives<'g>) -> Term<'g> {
        let Derivatives { third, as_long: [rate, bend], .. } = curve;
        let (bend, rate, swing) = (self.norm(bend), self.norm(rate), self.norm(swing));
        let size = self.size(axis);
        let largest_bend = bend + third / 2;
        let largest_rate = rate + largest_bend / 2;
        let largest_swing = swing + largest_rate / 2;
        let sum = size * largest_swing;
        let sum = size * (3 * largest_rate + sum);
        let sum = size * (3 * largest_bend + sum);
        third + sum
    }

    /// Length of a vector; the absolute value where only one component is not zero, and that is a product of changes.
    fn norm(&self, v: TermVector<'g>) -> Term<'g> {
        let graph = &self.derivation.graph;
        let factors = graph.with(|graph| {
            let mut parts = v.ids().into_iter().filter(|id| !graph.is_zero(*id));
            let (only, None) = (parts.next()?, parts.next()) else { return None };
            let mut factors = Vec::new();
            self.collect_changes(graph, only, &mut factors).then_some(factors)
        });
        let size = factors.and_then(|axes| axes.into_iter().map(|axis| self.size(axis)).reduce(|a, b| a * b));
        size.unwrap_or_else(|| v.norm())
    }

    /// Adds the axes whose changes a product is of, whatever its sign. Returns false if it has other factors.
    fn collect_changes(&self, graph: &Graph, product: Id, out: &mut Vec<AxisId>) -> bool {
        match *graph.node(product) {
            Node::Neg(inner) => self.collect_changes(graph, inner, out),
            Node::Mul(a, b) => self.collect_changes(graph, a, out) && self.collect_changes(graph, b, out),
            Node::Input(symbol) => {
                let axis = self.changes.iter().position(|change| *change == symbol);
                out.extend(axis);
                axis.is_some()
            }
            _ => false,
        }
    }

    fn change(&self, axis: AxisId) -> Term<'g> {
        self.derivation.graph.input(self.changes[axis])
    }

    fn size(&self, axis: AxisId) -> Term<'g> {
        self.derivation.graph.input(self.sizes[axis])
    }
}
