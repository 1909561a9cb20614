//! Closed-form kinematics as a graph: forward kinematics, rotary angles, linear axes, and derivatives of the pose.
//!
//! Input is the span-free [`Model`]; refusals name axes by their index in the chain. Limits, whole turns and the choice
//! between branches are decided in the runtime.

mod derivation;
mod forward;
mod motion;
mod orientation;
mod position;
mod refusal;

use derivation::Derivation;
pub use forward::Forward;
pub use motion::{Curve, Motion};
pub use orientation::{
    AngleRelation, Branch, Edge, FirstAngle, OneRotary, Orientation, Pole, SecondAngle, Tilt, TwoRotaries,
};
pub use position::Position;
pub use refusal::{PARALLEL_SINE_SQUARED, Refusal};

use std::collections::BTreeMap;

use crate::model::Model;
use crate::symbolic::{Graph, GraphBuilder, Id, NodeVector, Poly, Symbol, Term};

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
    pub directions: Vec<NodeVector>,
    /// Centre of every rotary axis for the current set-up; zero for linear axes.
    pub centres: Vec<NodeVector>,
    /// Tool axis with all axes at zero.
    pub tool_axis: NodeVector,
    /// Divisors that must not be zero.
    pub conditions: Vec<SideCondition>,
}

/// A divisor of the formulas or of a proof.
#[derive(Debug, Clone)]
pub struct SideCondition {
    /// Its value.
    pub divisor: Id,
    /// Absolute values up to this count as zero.
    pub tolerance: f64,
    /// Consequence for the machine if it is zero, for the message.
    pub meaning: String,
}

/// Solves a machine.
///
/// # Errors
/// All refusals of the chain.
pub fn solve(model: &Model) -> Result<Solved, Vec<Refusal>> {
    let defaults = &model.defaults;
    let derivation = Derivation { model, graph: GraphBuilder::new(model.ring.clone()) };
    let forward = forward::solve(&derivation);
    let position = position::solve(&derivation);
    let orientation = orientation::solve(&derivation, defaults);
    let mut refusals = Vec::new();
    if vanishes(derivation.graph.term(position.determinant), defaults) {
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

/// True if a determinant is zero identically, or at the defaults of dimensions and held axes.
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
    let condition = |divisor, tolerance, meaning: &str| SideCondition { divisor, tolerance, meaning: meaning.into() };
    let mut conditions =
        vec![condition(position.determinant, 1e-9, "the linear axes cannot move the tip in every direction")];
    match orientation {
        Orientation::Fixed { .. } => {}
        Orientation::One(one) => conditions.push(condition(
            one.length_claim,
            PARALLEL_SINE_SQUARED,
            "the rotary axis is parallel to the tool, so it cannot tilt it",
        )),
        Orientation::Two(two) => conditions.push(condition(
            two.second.capacity,
            PARALLEL_SINE_SQUARED,
            "the rotary axes are parallel to each other or to the tool, so the tool cannot tilt",
        )),
    }
    conditions
}
