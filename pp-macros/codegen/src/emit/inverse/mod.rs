//! The inverse kinematics: a straight path for ordinary poses, a cold one for pole and rim, and `reach`.

mod edge;
mod pair;
mod reach;
mod single;
mod solution;

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::inputs::Places;
use crate::model::Model;
use crate::solve::{Orientation, PARALLEL, Solved};
pub(crate) use edge::edge;
pub(crate) use reach::reach;

/// `inverse_kinematics`.
pub(crate) fn inverse(model: &Model, solved: &Solved) -> TokenStream {
    let body = match &solved.orientation {
        Orientation::Fixed { deviation } => single::fixed(model, solved, *deviation),
        Orientation::One(one) => single::one(model, solved, one),
        Orientation::Two(two) => pair::pair(model, solved, two),
    };
    quote! {
        #[inline]
        fn inverse_kinematics(
            &self,
            pose: &::pp_runtime::kinematics::Pose,
            held: &Self::Axes,
        ) -> ::pp_runtime::kinematics::Solutions<Self::Axes> {
            let (tip, axis) = (&pose.tip, &pose.axis);
            let _ = held;
            #body
        }
    }
}

/// The bound below which directions count as parallel, as a literal.
fn parallel() -> Literal {
    Literal::f64_unsuffixed(PARALLEL)
}

fn inverse_places() -> Places<'static> {
    Places { tip: Some("tip"), axis: Some("axis"), words: Some("held"), turns: None }
}

/// Whether the pose, and what is held, are numbers; NaN and infinity stay NaN or infinite in a sum.
fn finite(model: &Model) -> TokenStream {
    let held = model.axes.iter().enumerate().filter(|(_, axis)| axis.held.is_some()).map(|(place, _)| place);
    quote!((tip.x + tip.y + tip.z + axis.x + axis.y + axis.z #(+ held[#held])*).is_finite())
}
