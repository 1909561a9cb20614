//! Closed-form rotary angles from a tool axis, for none, one or two solved rotary axes.
//!
//! Held rotary axes are folded in first: those before the first solved rotary rotate the wanted axis back, those after
//! the last one rotate the tool, those between the two rotate the second direction. The mathematics is in [`one`] and
//! [`two`].

mod one;
mod relation;
mod two;

use std::collections::BTreeMap;

use super::{Derivation, Refusal};
use crate::model::{AxisId, Kind};
use crate::symbolic::{Id, Poly, Symbol, Term, V3, Vec3};
pub use one::One;
pub use relation::AngleRelation;
pub use two::{Branch, Edge, FirstAngle, Pole, SecondAngle, Two};

/// How the tool axis is reached.
#[derive(Debug, Clone)]
pub enum Orientation {
    /// No solved rotary axis.
    Fixed {
        /// `|a - t|`.
        deviation: Id,
    },
    /// One solved rotary axis.
    One(One),
    /// Two solved rotary axes.
    Two(Box<Two>),
}

/// Angles to the first rotary as (sine, cosine) pairs, for diagnostics.
#[derive(Debug, Clone, Copy)]
pub struct Tilt {
    /// Angle between the first rotary and the wanted axis.
    pub wanted: (Id, Id),
    /// Angle between the first and the second rotary; 0 with one rotary.
    pub between: (Id, Id),
    /// Angle between the last rotary and the tool axis.
    pub tool: (Id, Id),
    /// Direction of the first rotary in the workpiece frame, at the held values before it.
    pub direction: V3,
}

pub(crate) fn solve(
    derivation: &Derivation<'_>,
    defaults: &BTreeMap<Symbol, Poly>,
) -> Result<Orientation, Vec<Refusal>> {
    let model = derivation.model;
    let solved: Vec<AxisId> = model.solved_rotaries().collect();
    let held = |id: &AxisId| model.axes[*id].kind == Kind::Rotary && model.axes[*id].held.is_some();
    let first = solved.first().copied().unwrap_or(model.axes.len());
    let after_last = solved.last().map_or(first, |last| last + 1);
    let axis = derivation.graph.inputs(model.frame.axis);
    let axis = (0..first).filter(held).fold(axis, |axis, id| derivation.rotated_back(id, axis));
    let after_last = (after_last..model.axes.len()).filter(held).rev();
    let tool = after_last.fold(derivation.tool_axis(), |tool, id| derivation.rotated(id, tool));
    match solved[..] {
        [] => Ok(Orientation::Fixed { deviation: (axis - tool).norm().named("deviation").id() }),
        [rotary] => Ok(Orientation::One(one::solve(derivation, rotary, axis, tool, defaults)?)),
        [first, second] => {
            let mut m = derivation.direction(second);
            let mut t = tool;
            for id in (first + 1..second).filter(held).rev() {
                m = derivation.rotated(id, m);
                t = derivation.rotated(id, t);
            }
            let n = derivation.direction(first);
            let directions = two::Directions { n, m, t, a: axis };
            Ok(Orientation::Two(Box::new(two::solve(derivation, [first, second], directions, defaults)?)))
        }
        _ => unreachable!("the check lets at most two solved rotary axes pass"),
    }
}

/// Direction of a rotary with the held rotaries before it rotated.
fn in_workpiece<'g>(derivation: &'g Derivation<'_>, rotary: AxisId) -> Vec3<'g> {
    let before = (0..rotary).rev().filter(|id| derivation.model.axes[*id].kind == Kind::Rotary);
    before.fold(derivation.direction(rotary), |direction, id| derivation.rotated(id, direction))
}

/// Squared length of a cross product at the defaults of dimensions and held axes; 0 if it vanishes identically.
///
/// Components are evaluated before they are squared: noise of 1e-16 becomes 1e-32, far below
/// [`PARALLEL`](super::PARALLEL).
fn squared_at(defaults: &BTreeMap<Symbol, Poly>, cross: Vec3<'_>) -> f64 {
    cross.components().map(|component| component.at(defaults).map_or(0.0, |value| value * value)).iter().sum()
}

/// The nodes of a pair, sine and cosine.
fn nodes((sine, cosine): (Term<'_>, Term<'_>)) -> (Id, Id) {
    (sine.id(), cosine.id())
}
