//! The cold path of a machine with two rotary axes: pole, rim, just beyond the rim, and poses that are not numbers.

use proc_macro2::TokenStream;
use quote::quote;

use super::Wanted;
use super::guard::{finite, inverse_variables, parallel};
use super::solution::SolutionTokens;
use crate::emit::body::{Body, lets};
use crate::emit::inputs::prelude;
use crate::model::Model;
use crate::solve::{Edge, Orientation, Solved, TwoRotaries};
use crate::symbolic::Id;

/// The function and its signature; `None` if fewer than two rotary axes are solved for.
pub(crate) fn edge(model: &Model, solved: &Solved, wanted: Wanted) -> Option<(TokenStream, TokenStream)> {
    let Orientation::Two(two) = &solved.orientation else { return None };
    let count = model.axes.len();
    let signature = match wanted {
        Wanted::AllAxes => quote! {
            /// One solution where both branches coincide: at the pole, at the limit of reach, and within the tolerance
            /// beyond it.
            fn inverse_at_the_edge(
                &self,
                pose: &pp::kinematics::Pose,
                held: &[f64; #count],
            ) -> pp::kinematics::Solutions<[f64; #count]>
        },
        Wanted::RotaryAxes => quote! {
            /// The rotary axes of that solution.
            fn rotary_axes_at_the_edge(
                &self,
                axis: &pp::nalgebra::UnitVector3<f64>,
                held: &[f64; #count],
            ) -> pp::kinematics::Solutions<pp::kinematics::RotaryAngles>
        },
    };
    let pose = (wanted == Wanted::AllAxes).then(|| quote!(let (tip, axis) = (&pose.tip, &pose.axis);));
    let statements = statements(model, solved, two, wanted);
    let function = quote! {
        #[cold]
        #[inline(never)]
        #signature {
            #pose
            #statements
        }
    };
    Some((function, quote!(#signature;)))
}

fn statements(model: &Model, solved: &Solved, two: &TwoRotaries, wanted: Wanted) -> TokenStream {
    let Edge { second, first, first_squared, reached_squared, along, .. } = two.edge;
    let needed =
        [two.second.capacity, two.second.root_squared, two.second.height, two.second.rim, two.first.sine_squared];
    let reached =
        [second.sine, second.cosine, first.sine, first.cosine, first_squared, reached_squared, along.0, along.1];
    let outputs: Vec<Id> = needed.into_iter().chain(reached).collect();
    let mut body = Body::new(&solved.graph, &outputs);
    let prelude = prelude(model, &body.inputs(&outputs), inverse_variables());
    let begin = lets(&body.statements(&needed));
    let rest = lets(&body.statements(&outputs));
    let is_a_pose = is_a_pose(model, solved, &body, two, wanted);
    let onto_the_rim = onto_the_rim(&body, two);
    let deviation = deviation(&body, two);
    let first_angle = first_angle(&body, two, wanted);
    let (sine, cosine) = (body.tokens(second.sine), body.tokens(second.cosine));
    let [first, second] = two.rotaries;
    let solution = SolutionTokens {
        turns: &[(first, quote!(first)), (second, quote!(second))],
        angles: &[(first, quote!(value)), (second, quote!(math::angle(second.0, second.1)))],
        branch: quote!(First),
        singular: quote!(singular),
        deviation: quote!(deviation),
    };
    let solution = solution.tokens(model, solved, wanted);
    quote! {
        #prelude
        #begin
        #is_a_pose
        #onto_the_rim
        #rest
        #deviation
        #first_angle
        let second = (#sine, #cosine);
        pp::kinematics::Solutions::from_branches([#solution, ::core::option::Option::None])
    }
}

/// No solution for a pose that is not a number, or where the rotary axes cannot tilt the tool.
fn is_a_pose(model: &Model, solved: &Solved, body: &Body<'_>, two: &TwoRotaries, wanted: Wanted) -> TokenStream {
    let capacity = solved.graph.constant_of(two.second.capacity).is_none().then(|| {
        let (capacity, least) = (body.tokens(two.second.capacity), parallel());
        quote!(!(#capacity > #least) ||)
    });
    let finite = finite(model, wanted);
    quote! {
        if #capacity !#finite {
            return pp::kinematics::Solutions::none();
        }
    }
}

/// Height and root of the nearest axis that can be reached.
fn onto_the_rim(body: &Body<'_>, two: &TwoRotaries) -> TokenStream {
    let [root_squared, height, rim] =
        [two.second.root_squared, two.second.height, two.second.rim].map(|node| body.tokens(node));
    quote! {
        let inside = #root_squared > 0.0;
        let edge_root = if inside { math::sqrt(#root_squared) } else { 0.0 };
        let edge_height = if inside { #height } else if #height < 0.0 { -#rim } else { #rim };
    }
}

/// Distance of the nearest axis from the wanted one; no solution beyond the tolerance.
fn deviation(body: &Body<'_>, two: &TwoRotaries) -> TokenStream {
    let [along, reached_along, sine_squared, reached_squared] =
        [two.edge.along.0, two.edge.along.1, two.first.sine_squared, two.edge.reached_squared]
            .map(|node| body.tokens(node));
    quote! {
        let deviation = if inside {
            0.0
        } else {
            math::hypot(#along - (#reached_along), math::sqrt(#sine_squared) - math::sqrt(#reached_squared))
        };
        if !(deviation <= pp::kinematics::REACH_TOLERANCE) {
            return pp::kinematics::Solutions::none();
        }
    }
}

/// `first` and `value`, the (sine, cosine) and the angle of the first rotary; at the pole those of its given value.
fn first_angle(body: &Body<'_>, two: &TwoRotaries, wanted: Wanted) -> TokenStream {
    let rotary = two.rotaries[0];
    let [sine_squared, first_squared, sine, cosine] =
        [two.first.sine_squared, two.edge.first_squared, two.edge.first.sine, two.edge.first.cosine]
            .map(|node| body.tokens(node));
    let first = (wanted == Wanted::AllAxes)
        .then(|| quote!(let first = if singular { math::sin_cos(held[#rotary]) } else { direction };));
    quote! {
        let singular = !(#sine_squared
            >= pp::kinematics::SINGULAR_SINE * pp::kinematics::SINGULAR_SINE)
            || !(#first_squared > 0.0);
        if singular && !held[#rotary].is_finite() {
            return pp::kinematics::Solutions::none();
        }
        let length = math::sqrt(#first_squared);
        let direction = (#sine / length, #cosine / length);
        #first
        let value = if singular { held[#rotary] } else { math::angle(direction.0, direction.1) };
    }
}
