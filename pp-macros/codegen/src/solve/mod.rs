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
pub use orientation::{AngleRelation, Branch, Edge, FirstAngle, One, Orientation, Pole, SecondAngle, Tilt, Two};
pub use position::Position;

use std::collections::BTreeMap;

use crate::model::{AxisId, Kind, Model};
use crate::symbolic::{Graph, GraphBuilder, Id, P3, Poly, Symbol, Term, V3, Vec3};

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
    let derivation = Derivation { model, graph: GraphBuilder::new(model.ring.clone()) };
    let forward = forward::solve(&derivation);
    let position = position::solve(&derivation);
    let orientation = orientation::solve(&derivation, &defaults);
    let mut refusals = Vec::new();
    if vanishes(derivation.graph.term(position.determinant), &defaults) {
        refusals.push(Refusal::DependentLinears);
    }
    let orientation = orientation.map_err(|mut found| refusals.append(&mut found)).ok();
    let (Some(orientation), true) = (orientation, refusals.is_empty()) else { return Err(refusals) };
    let axes = 0..model.axes.len();
    let directions = axes.clone().map(|axis| derivation.direction(axis).ids()).collect();
    let centres = axes.map(|axis| derivation.joint_centre(axis).ids()).collect();
    let tool_axis = derivation.tool_axis().ids();
    let conditions = conditions(&orientation, &position);
    let motion = motion::solve(model);
    let graph = derivation.graph.finish();
    Ok(Solved { graph, forward, orientation, position, motion, directions, centres, tool_axis, conditions })
}

/// Whether a determinant is zero identically, or at the defaults of dimensions and held axes.
fn vanishes(determinant: Term<'_>, defaults: &BTreeMap<Symbol, Poly>) -> bool {
    determinant.read(|reader, node| {
        let value = reader.value(node);
        let ring = reader.ring();
        let at_defaults = ring.substitute(&value, defaults);
        ring.is_zero(&value) || ring.value(&at_defaults).map_or(at_defaults.is_zero(), |v| v.abs() < 1e-9)
    })
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
            two.second.capacity,
            PARALLEL,
            "the rotary axes are parallel to each other or to the tool, so the tool cannot tilt",
        )),
    }
    conditions
}

/// A model, and the graph that its formulas are written into.
struct Derivation<'a> {
    model: &'a Model,
    graph: GraphBuilder,
}

/// A point given from the centre of a rotary axis, or from the origin.
#[derive(Debug, Clone, Copy)]
struct Point<'g> {
    from: Option<AxisId>,
    offset: Vec3<'g>,
}

impl Derivation<'_> {
    fn direction(&self, axis: AxisId) -> Vec3<'_> {
        self.graph.declared(&self.model.axes[axis].direction)
    }

    fn tool_axis(&self) -> Vec3<'_> {
        self.graph.declared(&self.model.tool_axis)
    }

    fn joint_centre(&self, axis: AxisId) -> Vec3<'_> {
        match self.model.axes[axis].kind {
            Kind::Linear => self.graph.zero_vector(),
            Kind::Rotary => self.graph.declared(&self.model.centre(axis)),
        }
    }

    fn origin(&self) -> Point<'_> {
        Point { from: None, offset: self.graph.zero_vector() }
    }

    /// Rotates a vector by a rotary joint whose word is an input.
    fn rotated<'g>(&'g self, axis: AxisId, v: Vec3<'g>) -> Vec3<'g> {
        self.rotated_by(axis, v, self.model.axes[axis].reversed)
    }

    /// Rotates a vector against a rotary joint.
    fn rotated_back<'g>(&'g self, axis: AxisId, v: Vec3<'g>) -> Vec3<'g> {
        self.rotated_by(axis, v, !self.model.axes[axis].reversed)
    }

    fn rotated_by<'g>(&'g self, axis: AxisId, v: Vec3<'g>, back: bool) -> Vec3<'g> {
        let (sine, cosine) = self.model.axes[axis].turn;
        let (sine, cosine) = (self.graph.input(sine), self.graph.input(cosine));
        let sine = sine.signed(!back);
        v.rotated(self.direction(axis), sine, cosine)
    }

    /// Signed direction of an axis: what a millimetre, or a radian, of the word does.
    fn step(&self, axis: AxisId) -> Vec3<'_> {
        let direction = self.direction(axis);
        if self.model.axes[axis].reversed { -direction } else { direction }
    }

    fn displacement(&self, axis: AxisId) -> Vec3<'_> {
        self.graph.input(self.model.axes[axis].word) * self.step(axis)
    }

    /// Names the components of a point after the axis it is seen from.
    fn name(&self, what: &str, axis: AxisId, offset: Vec3<'_>) {
        let letter = self.model.axes[axis].letter.to_ascii_lowercase();
        for (term, component) in offset.components().into_iter().zip(["x", "y", "z"]) {
            term.named(format!("{what}_{letter}_{component}"));
        }
    }

    /// The same point, given from another centre. Centres on one side differ by their `d` alone, whatever the set-up.
    fn seen_from<'g>(&'g self, point: Point<'g>, from: Option<AxisId>) -> Point<'g> {
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
        let shift: P3 = std::array::from_fn(|index| &old[index] - &new[index]);
        Point { from, offset: point.offset + self.graph.declared(&shift) }
    }
}
