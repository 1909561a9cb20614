//! At most one solved rotary axis: one solution or none.

use proc_macro2::TokenStream;
use quote::quote;

use super::Wanted;
use super::guard::{can_be_free, finite, inverse_variables, parallel};
use super::solution::SolutionTokens;
use crate::emit::body::{Body, lets};
use crate::emit::inputs::prelude;
use crate::model::Model;
use crate::solve::{OneRotary, Solved};
use crate::symbolic::Id;

/// No solved rotary axis.
pub(crate) fn fixed(model: &Model, solved: &Solved, deviation: Id, wanted: Wanted) -> TokenStream {
    let mut body = Body::new(&solved.graph, &[deviation]);
    let prelude = prelude(model, &body.inputs(&[deviation]), inverse_variables());
    let guard = within_reach(model, &mut body, deviation, wanted);
    let (branch, singular, deviation) = (quote!(First), quote!(false), body.tokens(deviation));
    let solution = SolutionTokens { turns: &[], angles: &[], branch, singular, deviation };
    let solution = solution.tokens(model, solved, wanted);
    quote! {
        #prelude
        #guard
        pp::kinematics::Solutions::from_branches([#solution, ::core::option::Option::None])
    }
}

/// One solved rotary axis.
pub(crate) fn one(model: &Model, solved: &Solved, one: &OneRotary, wanted: Wanted) -> TokenStream {
    let outputs = [one.deviation, one.word.sine, one.word.cosine, one.length, one.length_claim];
    let mut body = Body::new(&solved.graph, &outputs);
    let prelude = prelude(model, &body.inputs(&outputs), inverse_variables());
    let can_tilt = can_tilt(solved, &mut body, one);
    let guard = within_reach(model, &mut body, one.deviation, wanted);
    let statements = lets(&body.statements(&outputs));
    let (angle, singular) = angle(solved, &body, one, wanted);
    let solution = SolutionTokens {
        turns: &[(one.rotary, quote!(first))],
        angles: &[(one.rotary, quote!(value))],
        branch: quote!(First),
        singular,
        deviation: body.tokens(one.deviation),
    };
    let solution = solution.tokens(model, solved, wanted);
    quote! {
        #prelude
        #can_tilt
        #guard
        #statements
        #angle
        pp::kinematics::Solutions::from_branches([#solution, ::core::option::Option::None])
    }
}

/// No solution where dimensions or held axes make the rotary parallel to the tool.
fn can_tilt(solved: &Solved, body: &mut Body<'_>, one: &OneRotary) -> Option<TokenStream> {
    if solved.graph.constant_of(one.length_claim).is_some() {
        return None;
    }
    let statements = lets(&body.statements(&[one.length_claim]));
    let squared = body.tokens(one.length_claim);
    let least = parallel();
    Some(quote! {
        #statements
        if !(#squared > #least) {
            return pp::kinematics::Solutions::none();
        }
    })
}

/// No solution where the wanted axis is off the cone by more than the tolerance, or is not a number.
fn within_reach(model: &Model, body: &mut Body<'_>, deviation: Id, wanted: Wanted) -> TokenStream {
    let statements = lets(&body.statements(&[deviation]));
    let deviation = body.tokens(deviation);
    let finite = finite(model, wanted);
    quote! {
        #statements
        if !(#deviation <= pp::kinematics::REACH_TOLERANCE) || !#finite {
            return pp::kinematics::Solutions::none();
        }
    }
}

/// `first` and `value`, the (sine, cosine) and the angle; and whether it is singular.
fn angle(solved: &Solved, body: &Body<'_>, one: &OneRotary, wanted: Wanted) -> (TokenStream, TokenStream) {
    let (sine, cosine) = (body.tokens(one.word.sine), body.tokens(one.word.cosine));
    if !can_be_free(solved, one) {
        let first = (wanted == Wanted::AllAxes).then(|| quote!(let first = (#sine, #cosine);));
        return (quote!(#first let value = math::angle(#sine, #cosine);), quote!(false));
    }
    let (rotary, length) = (one.rotary, body.tokens(one.length));
    let first = (wanted == Wanted::AllAxes)
        .then(|| quote!(let first = if singular { math::sin_cos(held[#rotary]) } else { (#sine, #cosine) };));
    let angle = quote! {
        let singular = !(#length >= pp::kinematics::SINGULAR_SINE);
        if singular && !held[#rotary].is_finite() {
            return pp::kinematics::Solutions::none();
        }
        #first
        let value = if singular { held[#rotary] } else { math::angle(#sine, #cosine) };
    };
    (angle, quote!(singular))
}
