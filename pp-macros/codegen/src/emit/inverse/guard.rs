//! Inputs of the inverse, and tests for poses without a solution.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::Wanted;
use crate::emit::inputs::InputVariables;
use crate::model::Model;
use crate::solve::{OneRotary, PARALLEL_SINE_SQUARED, Pole, Solved, TwoRotaries};

/// Sine of the half angle of a cone below which its axis may be within the reach tolerance of the cone, with a margin.
const SLIM: f64 = 1e-5;

/// Whether the pole needs a test besides that of the root. In the orthogonal form the root is also zero at the pole.
pub(crate) fn needs_pole_test(two: &TwoRotaries) -> bool {
    two.pole != Pole::Orthogonal
}

/// Whether a single rotary axis can be free: the axis of a very slim cone is within the tolerance of it, and there the
/// tool axis does not define the angle.
pub(crate) fn can_be_free(solved: &Solved, one: &OneRotary) -> bool {
    let claim = solved.graph.constant_of(one.length_claim).and_then(|poly| solved.graph.ring().value(poly));
    claim.is_none_or(|squared| squared < SLIM * SLIM)
}

/// The bound below which directions count as parallel, as a literal.
pub(crate) fn parallel() -> Literal {
    Literal::f64_unsuffixed(PARALLEL_SINE_SQUARED)
}

/// Variables of the inverse that hold its inputs.
pub(crate) fn inverse_variables() -> InputVariables<'static> {
    InputVariables { tip: Some("tip"), axis: Some("axis"), words: Some("held"), turns: None }
}

/// Test that pose, or tool axis, and held values are finite; NaN and infinity stay NaN or infinite in a sum.
pub(crate) fn finite(model: &Model, wanted: Wanted) -> TokenStream {
    let tip = (wanted == Wanted::AllAxes).then(|| quote!(tip.x + tip.y + tip.z +));
    let held = model.axes.iter().enumerate().filter(|(_, axis)| axis.held.is_some()).map(|(place, _)| place);
    quote!((#tip axis.x + axis.y + axis.z #(+ held[#held])*).is_finite())
}
