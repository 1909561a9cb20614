//! One branch as an `Option<Solution>`: the linear axes follow from the rotary angles.

use proc_macro2::TokenStream;
use quote::quote;

use super::Wanted;
use crate::emit::kinematics::rotaries;
use crate::model::{AxisId, AxisKind, Model};
use crate::solve::Solved;

/// Expressions of a branch.
pub(crate) struct SolutionTokens<'a> {
    /// (sine, cosine) of the solved rotary axes.
    pub(crate) turns: &'a [(AxisId, TokenStream)],
    /// Angles of the solved rotary axes.
    pub(crate) angles: &'a [(AxisId, TokenStream)],
    /// Variant of `Branch`.
    pub(crate) branch: TokenStream,
    pub(crate) singular: TokenStream,
    pub(crate) deviation: TokenStream,
}

impl SolutionTokens<'_> {
    /// `Option<Solution>`
    pub(crate) fn tokens(&self, model: &Model, solved: &Solved, wanted: Wanted) -> TokenStream {
        match wanted {
            Wanted::AllAxes => self.with_linear_axes(model, solved),
            Wanted::RotaryAxes => self.alone(),
        }
    }

    /// The rotary axes, in the order of the chain.
    fn alone(&self) -> TokenStream {
        let mut angles = self.angles.to_vec();
        angles.sort_by_key(|(place, _)| *place);
        let angles = angles.into_iter().map(|(_, angle)| angle).chain([quote!(0.0), quote!(0.0)]).take(2);
        let solution = self.solution(&quote!([#(#angles),*]));
        quote!(::core::option::Option::Some(#solution))
    }

    fn solution(&self, axes: &TokenStream) -> TokenStream {
        let Self { branch, singular, deviation, .. } = self;
        quote! {
            pp::kinematics::Solution {
                axes: #axes,
                branch: pp::kinematics::Branch::#branch,
                singular: #singular,
                deviation: #deviation,
            }
        }
    }

    fn with_linear_axes(&self, model: &Model, solved: &Solved) -> TokenStream {
        let turns = self.all_turns(model);
        let axes = model.axes.iter().enumerate().map(|(place, axis)| {
            if axis.held.is_some() {
                return quote!(held[#place]);
            }
            if axis.kind == AxisKind::Linear {
                let index = solved.position.values.iter().position(|(known, _)| *known == place);
                return quote!(solved[#index]);
            }
            of(self.angles, place).cloned().unwrap_or_default()
        });
        let solution = self.solution(&quote!([#(#axes),*]));
        quote! {
            match self.position(tip, &#turns, held) {
                ::core::option::Option::None => ::core::option::Option::None,
                ::core::option::Option::Some(solved) => ::core::option::Option::Some(#solution),
            }
        }
    }

    /// The (sine, cosine) of every rotary axis, held ones from their values.
    fn all_turns(&self, model: &Model) -> TokenStream {
        let pairs = rotaries(model)
            .map(|place| of(self.turns, place).cloned().unwrap_or_else(|| quote!(math::sin_cos(held[#place]))));
        quote!([#(#pairs),*])
    }
}

fn of(list: &[(AxisId, TokenStream)], place: AxisId) -> Option<&TokenStream> {
    list.iter().find(|(known, _)| *known == place).map(|(_, tokens)| tokens)
}
