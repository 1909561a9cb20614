//! The inverse kinematics, and its rotary axes alone: straight-line code for ordinary poses, a cold path for pole and
//! rim, and `reach`.
//!
//! Sines are computed in three places only: of a rotary that is free at the pole, of held rotaries, and of dimensions
//! that are angles.

mod edge;
mod guard;
mod pair;
mod reach;
mod single;
mod solution;

use proc_macro2::TokenStream;
use quote::quote;

use crate::model::Model;
use crate::solve::{Orientation, Solved};
pub(crate) use edge::edge;
pub(crate) use guard::{can_be_free, needs_pole_test};
pub(crate) use reach::reach;

/// What a function solves for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Wanted {
    /// All axes, for a pose.
    AllAxes,
    /// The rotary axes, for a tool axis.
    RotaryAxes,
}

fn body(model: &Model, solved: &Solved, wanted: Wanted) -> TokenStream {
    match &solved.orientation {
        Orientation::Fixed { deviation } => single::fixed(model, solved, *deviation, wanted),
        Orientation::One(one) => single::one(model, solved, one, wanted),
        Orientation::Two(two) => pair::pair(model, solved, two, wanted),
    }
}

/// `rotary_axes`.
pub(crate) fn rotary_axes(model: &Model, solved: &Solved) -> TokenStream {
    let body = body(model, solved, Wanted::RotaryAxes);
    quote! {
        #[inline]
        fn rotary_axes(
            &self,
            axis: &pp::nalgebra::UnitVector3<f64>,
            held: &Self::Axes,
        ) -> pp::kinematics::Solutions<pp::kinematics::RotaryAngles> {
            let _ = held;
            #body
        }
    }
}

/// `inverse_kinematics`.
pub(crate) fn inverse(model: &Model, solved: &Solved) -> TokenStream {
    let body = body(model, solved, Wanted::AllAxes);
    quote! {
        #[inline]
        fn inverse_kinematics(
            &self,
            pose: &pp::kinematics::Pose,
            held: &Self::Axes,
        ) -> pp::kinematics::Solutions<Self::Axes> {
            let (tip, axis) = (&pose.tip, &pose.axis);
            let _ = held;
            #body
        }
    }
}
