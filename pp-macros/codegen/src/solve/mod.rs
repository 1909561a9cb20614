//! Closed-form kinematics as a graph: forward map, rotary angles, linear axes, and how the tool moves.
//!
//! Input is the span-free [`Model`]; refusals name axes by their place in the chain. Limits, turns and the choice
//! between branches live in the runtime.

mod forward;
mod motion;
mod orientation;
mod position;

pub use forward::Forward;
pub use motion::{Curve, Motion};
pub use orientation::{Angle, Answer, Edge, One, Orientation, Tilt, Two};
pub use position::Position;

use crate::model::{AxisId, Kind, Model};
use crate::symbolic::{Graph, Id, Interpreter, P3, V3};

/// Square of the sine below which two directions count as parallel.
pub const PARALLEL: f64 = 1e-18;

/// Why a chain has no kinematics.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Refusal {
    /// The determinant of the linear axes vanishes for every pose (at the declared dimensions and held values).
    DependentLinears,
    /// The solved rotary nearest the tool is parallel to the tool axis.
    CannotTilt(AxisId),
    /// Both solved rotaries turn about the same direction.
    SameDirection(AxisId, AxisId),
}

/// Everything the emitter prints, in one graph.
#[derive(Debug)]
pub struct Solved {
    /// The nodes.
    pub graph: Graph,
    /// Axis values to pose.
    pub forward: Forward,
    /// Tool axis to rotary angles.
    pub orientation: Orientation,
    /// Tip and rotary angles to linear axes.
    pub position: Position,
    /// Axis values and their rates to the rates of the pose.
    pub motion: Motion,
    /// Direction of every axis, as declared.
    pub directions: Vec<V3>,
    /// Centre of every rotary axis for the current set-up; zero for linear axes.
    pub centres: Vec<V3>,
    /// Tool axis with all axes at zero.
    pub tool_axis: V3,
    /// What must not be zero.
    pub conditions: Vec<SideCondition>,
}

/// A divisor of the formulas or of a proof.
#[derive(Debug, Clone)]
pub struct SideCondition {
    /// Its value.
    pub divisor: Id,
    /// Absolute values up to this count as zero.
    pub zero: f64,
    /// What it means if it is zero.
    pub meaning: String,
}

/// Solves a machine.
///
/// # Errors
/// All refusals of the chain.
pub fn solve(model: &mut Model) -> Result<Solved, Vec<Refusal>> {
    let defaults = model.defaults();
    let model: &Model = model;
    let mut chain = Chain { model, graph: Graph::new(model.ring.clone()) };
    let forward = forward::solve(&mut chain);
    let mut refusals = Vec::new();
    let position = position::solve(&mut chain);
    let orientation = orientation::solve(&mut chain, &defaults);
    let vanishes = |graph: &mut Graph, node: Id| {
        let value = Interpreter::new(graph, std::collections::BTreeMap::new()).value(node);
        let at_defaults = graph.ring().substitute(&value, &defaults);
        graph.ring().is_zero(&value)
            || graph.ring().value(&at_defaults).map_or(at_defaults.is_zero(), |v| v.abs() < 1e-9)
    };
    if vanishes(&mut chain.graph, position.determinant) {
        refusals.push(Refusal::DependentLinears);
    }
    let orientation = orientation.map_err(|mut found| refusals.append(&mut found)).ok();
    let (Some(orientation), true) = (orientation, refusals.is_empty()) else { return Err(refusals) };
    let axes = 0..model.axes.len();
    let directions = axes.clone().map(|axis| chain.direction(axis)).collect();
    let centres = axes.map(|axis| chain.joint_centre(axis)).collect();
    let tool_axis = chain.tool_axis();
    let conditions = conditions(&orientation, &position);
    let motion = motion::solve(model);
    let graph = chain.graph;
    Ok(Solved { graph, forward, orientation, position, motion, directions, centres, tool_axis, conditions })
}

/// Divisors of the closed forms.
fn conditions(orientation: &Orientation, position: &Position) -> Vec<SideCondition> {
    let condition = |divisor, zero, meaning: &str| SideCondition { divisor, zero, meaning: meaning.into() };
    let mut conditions =
        vec![condition(position.determinant, 1e-9, "the linear axes cannot move the tip in every direction")];
    match orientation {
        Orientation::Fixed { .. } => {}
        Orientation::One(one) => conditions.push(condition(
            one.length_claim,
            PARALLEL,
            "the rotary axis is parallel to the tool, so it cannot tilt it",
        )),
        Orientation::Two(two) => conditions.push(condition(
            two.capacity,
            PARALLEL,
            "the rotary axes are parallel to each other or to the tool, so the tool cannot tilt",
        )),
    }
    conditions
}

/// A model with the graph that its formulas go into.
struct Chain<'a> {
    model: &'a Model,
    graph: Graph,
}

/// A point given from the centre of a rotary axis, or from the origin.
#[derive(Debug, Clone, Copy)]
struct Point {
    from: Option<AxisId>,
    offset: V3,
}

impl Chain<'_> {
    fn declared(&mut self, vector: &P3) -> V3 {
        std::array::from_fn(|index| self.graph.declared(&vector[index]))
    }

    fn direction(&mut self, axis: AxisId) -> V3 {
        self.declared(&self.model.axes[axis].direction)
    }

    fn tool_axis(&mut self) -> V3 {
        self.declared(&self.model.tool_axis)
    }

    fn joint_centre(&mut self, axis: AxisId) -> V3 {
        match self.model.axes[axis].kind {
            Kind::Linear => [self.graph.integer(0); 3],
            Kind::Rotary => self.declared(&self.model.centre(axis)),
        }
    }

    fn origin(&mut self) -> Point {
        Point { from: None, offset: [self.graph.integer(0); 3] }
    }

    /// Turns a vector by a rotary joint whose word is an input.
    fn turn(&mut self, axis: AxisId, v: V3) -> V3 {
        self.turn_by(axis, v, false)
    }

    /// Turns a vector against a rotary joint.
    fn turn_back(&mut self, axis: AxisId, v: V3) -> V3 {
        self.turn_by(axis, v, true)
    }

    fn turn_by(&mut self, axis: AxisId, v: V3, back: bool) -> V3 {
        let (sine, cosine) = self.model.axes[axis].turn;
        let (mut sine, cosine) = (self.graph.input(sine), self.graph.input(cosine));
        if back != self.model.axes[axis].reversed {
            sine = self.graph.neg(sine);
        }
        let direction = self.direction(axis);
        self.graph.rotate(direction, sine, cosine, v)
    }

    /// Signed direction of a linear axis: what a millimetre of the word does.
    fn step(&mut self, axis: AxisId) -> V3 {
        let direction = self.direction(axis);
        if self.model.axes[axis].reversed { direction.map(|component| self.graph.neg(component)) } else { direction }
    }

    fn displacement(&mut self, axis: AxisId) -> V3 {
        let word = self.graph.input(self.model.axes[axis].word);
        let step = self.step(axis);
        self.graph.scale_vector(word, step)
    }

    /// Names the components of a point after the axis it is seen from.
    fn name(&mut self, what: &str, axis: AxisId, offset: V3) {
        let letter = self.model.axes[axis].letter.to_ascii_lowercase();
        for (node, component) in offset.into_iter().zip(["x", "y", "z"]) {
            self.graph.name(node, format!("{what}_{letter}_{component}"));
        }
    }

    /// The same point, given from another centre. Centres on one side differ by their `d` alone, whatever the set-up.
    fn seen_from(&mut self, point: Point, from: Option<AxisId>) -> Point {
        if point.from == from {
            return point;
        }
        let side = |axis: Option<AxisId>| axis.map(|axis| self.model.axes[axis].side);
        let centre = |axis: Option<AxisId>, whole: bool| match axis {
            None => std::array::from_fn(|_| crate::symbolic::Poly::zero()),
            Some(axis) if whole => self.model.centre(axis),
            Some(axis) => self.model.axes[axis].point.clone(),
        };
        let whole = side(point.from) != side(from);
        let (old, new) = (centre(point.from, whole), centre(from, whole));
        let shift: P3 = std::array::from_fn(|index| &old[index] - &new[index]);
        let shift = self.declared(&shift);
        Point { from, offset: self.graph.add_vectors(point.offset, shift) }
    }
}
