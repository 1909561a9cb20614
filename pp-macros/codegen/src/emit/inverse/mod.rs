//! The inverse kinematics: straight-line code for ordinary poses, a cold path for pole and rim, and `reach`.

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
            pose: &pp::kinematics::Pose,
            held: &Self::Axes,
        ) -> pp::kinematics::Solutions<Self::Axes> {
            let (tip, axis) = (&pose.tip, &pose.axis);
            let _ = held;
            #body
        }
    }
}
