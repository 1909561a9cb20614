//! How tip and tool axis move when the axes move linearly: two derivatives, and a bound of the third.
//!
//! From the tool to the workpiece. A linear axis adds to the first derivative; a rotary axis about `n` through `c` with
//! the rate `δ` makes of `y` the point `z = c + R (y - c)` with
//!
//! ```text
//! z'  = R (y' + δ n × (y - c))
//! z'' = R (y'' + δ n × (2 y' + δ n × (y - c)))
//! |z'''| <= M + |δ| (3 A + |δ| (3 V + |δ| ρ))
//! ```
//!
//! where `V A M` are the largest `|y'| |y''| |y'''|` of the block and `ρ` the largest `|n × (y - c)|`. What is known in
//! the middle of the block bounds them: `A <= |y''| + M/2`, `V <= |y'| + A/2`, `ρ <= |n × (y - c)| + V/2`. The runtime,
//! `pp_runtime::kinematics::MotionBound`, makes the deviation of the block from these.

use super::{Chain, Point};
use crate::model::{AxisId, Kind, Model};
use crate::symbolic::{Graph, Id, Node, Symbol, V3};

/// Nodes of the moving tool, in a graph of their own.
#[derive(Debug)]
pub struct Motion {
    /// The nodes.
    pub graph: Graph,
    /// Change of every axis in a unit of time: rates of the values in mm or rad.
    pub changes: Vec<Symbol>,
    /// Magnitudes of these.
    pub sizes: Vec<Symbol>,
    /// The tip's curve.
    pub tip: Curve,
    /// The tool axis.
    pub axis: V3,
    /// The tool axis' curve.
    pub axis_curve: Curve,
    /// Centres of the rotary axes for the current set-up.
    pub centres: Vec<V3>,
}

/// Two derivatives, and a bound of the third over a block with these values in its middle.
#[derive(Debug, Clone, Copy)]
pub struct Curve {
    /// First derivative.
    pub rate: V3,
    /// Second derivative.
    pub bend: V3,
    /// Largest third derivative.
    pub third: Id,
}

pub(super) fn solve(model: &Model) -> Motion {
    let mut graph = Graph::new(model.ring.clone());
    let letter = |axis: &crate::model::Axis| axis.letter.to_ascii_lowercase();
    let changes = model.axes.iter().map(|axis| graph.symbol(format!("change_{}", letter(axis)))).collect();
    let sizes = model.axes.iter().map(|axis| graph.symbol(format!("size_{}", letter(axis)))).collect();
    let mut moving = Moving { chain: Chain { model, graph }, changes, sizes };
    let (mut tip, mut tip_curve) = (moving.chain.origin(), moving.still());
    let (mut axis, mut axis_curve) = (moving.chain.tool_axis(), moving.still());
    for id in (0..model.axes.len()).rev() {
        match model.axes[id].kind {
            Kind::Linear => {
                let by = moving.chain.displacement(id);
                tip.offset = moving.chain.graph.add_vectors(tip.offset, by);
                tip_curve.rate = moving.slide(id, tip_curve.rate);
            }
            Kind::Rotary => {
                tip = moving.chain.seen_from(tip, Some(id));
                tip_curve = moving.turn("tip", id, tip.offset, tip_curve);
                tip = Point { offset: moving.chain.turn(id, tip.offset), ..tip };
                axis_curve = moving.turn("axis", id, axis, axis_curve);
                axis = moving.chain.turn(id, axis);
            }
        }
    }
    let rotary = |id: &AxisId| model.axes[*id].kind == Kind::Rotary;
    let centres = (0..model.axes.len()).filter(rotary).map(|id| moving.chain.joint_centre(id)).collect();
    let Moving { chain, changes, sizes } = moving;
    Motion { graph: chain.graph, changes, sizes, tip: tip_curve, axis, axis_curve, centres }
}

/// A chain whose axes move.
struct Moving<'a> {
    chain: Chain<'a>,
    changes: Vec<Symbol>,
    sizes: Vec<Symbol>,
}

impl Moving<'_> {
    fn still(&mut self) -> Curve {
        let zero = self.chain.graph.integer(0);
        Curve { rate: [zero; 3], bend: [zero; 3], third: zero }
    }

    /// The first derivative with what a linear axis adds to it.
    fn slide(&mut self, axis: AxisId, rate: V3) -> V3 {
        let change = self.chain.graph.input(self.changes[axis]);
        let step = self.chain.step(axis);
        let by = self.chain.graph.scale_vector(change, step);
        self.chain.graph.add_vectors(rate, by)
    }

    /// The curve of a point, seen through a rotary axis from whose centre it is `lever` away.
    fn turn(&mut self, what: &str, axis: AxisId, lever: V3, curve: Curve) -> Curve {
        let Curve { rate, bend, .. } = curve;
        let direction = self.chain.step(axis);
        let change = self.chain.graph.input(self.changes[axis]);
        let swing = self.chain.graph.cross(direction, lever);
        self.chain.name(&format!("{what}_swing"), axis, swing);
        let third = self.third(axis, swing, curve);
        let graph = &mut self.chain.graph;
        let by_turn = graph.scale_vector(change, swing);
        let twice = graph.add_vectors(rate, rate);
        let both = graph.add_vectors(twice, by_turn);
        let across = graph.cross(direction, both);
        let by_bend = graph.scale_vector(change, across);
        let (new_rate, new_bend) = (graph.add_vectors(rate, by_turn), graph.add_vectors(bend, by_bend));
        Curve { rate: self.chain.turn(axis, new_rate), bend: self.chain.turn(axis, new_bend), third }
    }

    /// `M + |δ| (3 A + |δ| (3 V + |δ| ρ))`
    fn third(&mut self, axis: AxisId, swing: V3, Curve { rate, bend, third }: Curve) -> Id {
        let (bend, rate, swing) = (self.norm(bend), self.norm(rate), self.norm(swing));
        let size = self.chain.graph.input(self.sizes[axis]);
        let graph = &mut self.chain.graph;
        let two = graph.integer(2);
        let largest_bend = add_half(graph, bend, third, two);
        let largest_rate = add_half(graph, rate, largest_bend, two);
        let largest_swing = add_half(graph, swing, largest_rate, two);
        let three = graph.integer(3);
        let mut sum = graph.mul(size, largest_swing);
        for (largest, factor) in [(largest_rate, three), (largest_bend, three)] {
            let term = graph.mul(factor, largest);
            let inner = graph.add(term, sum);
            sum = graph.mul(size, inner);
        }
        graph.add(third, sum)
    }

    /// Length of a vector; of a single axis' motion its magnitude.
    fn norm(&mut self, v: V3) -> Id {
        let graph = &mut self.chain.graph;
        let parts: Vec<Id> = v.into_iter().filter(|id| !graph.is_zero(*id)).collect();
        if let [only] = parts[..] {
            let inside = match *graph.node(only) {
                Node::Neg(inner) => inner,
                _ => only,
            };
            if let Node::Input(symbol) = *graph.node(inside)
                && let Some(axis) = self.changes.iter().position(|change| *change == symbol)
            {
                return graph.input(self.sizes[axis]);
            }
        }
        let square = graph.dot(v, v);
        graph.sqrt(square)
    }
}

/// `a + b / two`
fn add_half(graph: &mut Graph, a: Id, b: Id, two: Id) -> Id {
    let half = graph.div(b, two);
    graph.add(a, half)
}
