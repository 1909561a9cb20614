//! One branch as an `Option<Solution>`: the linear axes follow from the rotary angles.

use proc_macro2::TokenStream;
use quote::quote;

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
    pub(crate) fn tokens(&self, model: &Model, solved: &Solved) -> TokenStream {
        let Self { branch, singular, deviation, .. } = self;
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
        quote! {
            match self.position(tip, &#turns, held) {
                ::core::option::Option::None => ::core::option::Option::None,
                ::core::option::Option::Some(solved) => {
                    ::core::option::Option::Some(pp::kinematics::Solution {
                        axes: [#(#axes),*],
                        branch: pp::kinematics::Branch::#branch,
                        singular: #singular,
                        deviation: #deviation,
                    })
                }
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
