//! Closed-form rotary angles from a tool axis, for none, one or two solved rotary axes.
//!
//! Held rotary axes are folded in first: those before the first solved rotary rotate the wanted axis back, those after
//! the last one rotate the tool, those between the two rotate the second direction. The mathematics is in [`one`] and
//! [`two`].

mod geometry;
mod one;
mod pair;
mod relation;
mod tilt;
mod two;

use std::collections::BTreeMap;

use super::derivation::Derivation;
use super::refusal::Refusal;
use crate::model::{AxisId, AxisKind};
use crate::symbolic::{Id, Poly, Symbol};
use geometry::Directions;
pub use geometry::Pole;
pub use one::OneRotary;
pub use pair::{Branch, Edge, FirstAngle, SecondAngle, TwoRotaries};
pub use relation::AngleRelation;
pub use tilt::Tilt;

/// Rotary angles from the tool axis.
#[derive(Debug, Clone)]
pub enum Orientation {
    /// No solved rotary axis.
    Fixed {
        /// `|a - t|`.
        deviation: Id,
    },
    /// One solved rotary axis.
    One(OneRotary),
    /// Two solved rotary axes.
    Two(Box<TwoRotaries>),
}

pub(crate) fn solve(
    derivation: &Derivation<'_>,
    defaults: &BTreeMap<Symbol, Poly>,
) -> Result<Orientation, Vec<Refusal>> {
    let model = derivation.model;
    let solved: Vec<AxisId> = model.solved_rotaries().collect();
    let held = |id: &AxisId| model.axes[*id].kind == AxisKind::Rotary && model.axes[*id].held.is_some();
    let first = solved.first().copied().unwrap_or(model.axes.len());
    let after_last = solved.last().map_or(first, |last| last + 1);
    let axis = derivation.graph.inputs(model.symbols.axis);
    let axis = (0..first).filter(held).fold(axis, |axis, id| derivation.rotated_back(id, axis));
    let after_last = (after_last..model.axes.len()).filter(held).rev();
    let tool = after_last.fold(derivation.tool_axis(), |tool, id| derivation.rotated(id, tool));
    match solved[..] {
        [] => Ok(Orientation::Fixed { deviation: (axis - tool).norm().named("deviation").id() }),
        [rotary] => Ok(Orientation::One(one::solve(derivation, rotary, axis, tool, defaults)?)),
        // `check` refuses a third one.
        [first, second, ..] => {
            let mut m = derivation.direction(second);
            let mut t = tool;
            for id in (first + 1..second).filter(held).rev() {
                m = derivation.rotated(id, m);
                t = derivation.rotated(id, t);
            }
            let n = derivation.direction(first);
            let directions = Directions { n, m, t, a: axis };
            Ok(Orientation::Two(Box::new(two::solve(derivation, [first, second], directions, defaults)?)))
        }
    }
}
