//! Inputs of the inverse, and tests for poses without a solution.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use crate::emit::inputs::InputVariables;
use crate::model::Model;
use crate::solve::PARALLEL_SINE_SQUARED;

/// The bound below which directions count as parallel, as a literal.
pub(crate) fn parallel() -> Literal {
    Literal::f64_unsuffixed(PARALLEL_SINE_SQUARED)
}

/// Variables of the inverse that hold its inputs.
pub(crate) fn inverse_variables() -> InputVariables<'static> {
    InputVariables { tip: Some("tip"), axis: Some("axis"), words: Some("held"), turns: None }
}

/// Test that pose and held values are finite; NaN and infinity stay NaN or infinite in a sum.
pub(crate) fn finite(model: &Model) -> TokenStream {
    let held = model.axes.iter().enumerate().filter(|(_, axis)| axis.held.is_some()).map(|(place, _)| place);
    quote!((tip.x + tip.y + tip.z + axis.x + axis.y + axis.z #(+ held[#held])*).is_finite())
}
