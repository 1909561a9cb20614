//! The inverse kinematics: a straight path for ordinary poses, a cold one for pole and rim, and `reach`.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};

use super::body::{Body, lets};
use super::kinematics::rotaries;
use super::names::{Places, prelude};
use crate::model::{AxisId, Kind, Model, Quantity};
use crate::solve::{AngleRelation, Branch, One, Orientation, Pole, Solved, Tilt, Two};
use crate::symbolic::Id;

/// Sine of a cone whose axis may come within the reach tolerance of it, with room to spare.
const SLIM: f64 = 1e-5;

/// `inverse_kinematics`.
pub(super) fn inverse(model: &Model, solved: &Solved) -> TokenStream {
    let body = match &solved.orientation {
        Orientation::Fixed { deviation } => single(model, solved, *deviation, None),
        Orientation::One(one) => single(model, solved, one.deviation, Some(one)),
        Orientation::Two(two) => pair(model, solved, two),
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

/// At most one rotary axis: one solution or none.
fn single(model: &Model, solved: &Solved, deviation: Id, one: Option<&One>) -> TokenStream {
    let words: Vec<Id> = one.iter().flat_map(|one| [one.word.0, one.word.1, one.length, one.length_claim]).collect();
    let outputs: Vec<Id> = [deviation].into_iter().chain(words.iter().copied()).collect();
    let mut body = Body::new(&solved.graph, &outputs);
    let prelude = prelude(model, &body.inputs(&outputs), inverse_places());
    let room = one.filter(|one| solved.graph.constant_of(one.length_claim).is_none()).map(|one| {
        let statements = lets(&body.statements(&[one.length_claim]));
        let room = body.tokens(one.length_claim);
        let least = parallel();
        quote! {
            #statements
            if !(#room > #least) {
                return ::pp_runtime::kinematics::Solutions::none();
            }
        }
    });
    let guard = lets(&body.statements(&[deviation]));
    let deviation = body.tokens(deviation);
    let statements = lets(&body.statements(&outputs));
    let finite = finite(model);
    let Some(one) = one else {
        let turns = turns(model, |_| None);
        let solution = solution(model, solved, &turns, &[], &quote!(First), &quote!(false), &deviation);
        return quote! {
            #prelude
            #guard
            if !(#deviation <= ::pp_runtime::kinematics::REACH_TOLERANCE) || !#finite {
                return ::pp_runtime::kinematics::Solutions::none();
            }
            #statements
            ::pp_runtime::kinematics::Solutions::from_branches([#solution, ::core::option::Option::None])
        };
    };
    let (sine, cosine) = (body.tokens(one.word.0), body.tokens(one.word.1));
    // A cone so slim that its axis is within tolerance of it: there the rotary is free.
    let claim = solved.graph.constant_of(one.length_claim).and_then(|poly| solved.graph.ring().value(poly));
    let slim = claim.is_none_or(|squared| squared < SLIM * SLIM);
    let rotary = one.rotary;
    let (first, singular) = if slim {
        let length = body.tokens(one.length);
        let first = quote! {
            let singular = !(#length >= ::pp_runtime::kinematics::SINGULAR_SINE);
            if singular && !held[#rotary].is_finite() {
                return ::pp_runtime::kinematics::Solutions::none();
            }
            let (first, value) = if singular {
                (math::sin_cos(held[#rotary]), held[#rotary])
            } else {
                ((#sine, #cosine), math::angle(#sine, #cosine))
            };
        };
        (first, quote!(singular))
    } else {
        (quote!(let (first, value) = ((#sine, #cosine), math::angle(#sine, #cosine));), quote!(false))
    };
    let turns = turns(model, |place| (one.rotary == place).then(|| quote!(first)));
    let angle = [(one.rotary, quote!(value))];
    let solution = solution(model, solved, &turns, &angle, &quote!(First), &singular, &deviation);
    quote! {
        #prelude
        #room
        #guard
        if !(#deviation <= ::pp_runtime::kinematics::REACH_TOLERANCE) || !#finite {
            return ::pp_runtime::kinematics::Solutions::none();
        }
        #statements
        #first
        ::pp_runtime::kinematics::Solutions::from_branches([#solution, ::core::option::Option::None])
    }
}

/// Two rotary axes: two solutions, unless the edge is near.
fn pair(model: &Model, solved: &Solved, two: &Two) -> TokenStream {
    let graph = &solved.graph;
    let words = |answer: &Branch| answer.words.map(|(sine, cosine)| [sine, cosine]).concat();
    let outputs: Vec<Id> = [two.second.root, two.first.sine_squared, two.second.capacity]
        .into_iter()
        .chain(two.branches.iter().flat_map(words))
        .collect();
    let mut body = Body::new(graph, &outputs);
    let prelude = prelude(model, &body.inputs(&outputs), inverse_places());
    let guarded = [two.second.root, two.first.sine_squared, two.second.capacity];
    let guard = lets(&body.statements(&guarded));
    let [root, sine_squared, capacity] = guarded.map(|node| body.tokens(node));
    let statements = lets(&body.statements(&outputs));
    let finite = finite(model);
    let pole = (!(two.pole == Pole::Orthogonal)).then(|| {
        quote!(|| !(#sine_squared >= ::pp_runtime::kinematics::SINGULAR_SINE * ::pp_runtime::kinematics::SINGULAR_SINE))
    });
    let capacity = graph.constant_of(two.second.capacity).is_none().then(|| {
        let least = parallel();
        quote!(|| !(#capacity > #least))
    });
    let angle_name = |rotary: usize, branch: usize| {
        format_ident!("angle_{}_{}", model.axes[two.rotaries[rotary]].letter.to_ascii_lowercase(), branch + 1)
    };
    let mut angles = TokenStream::new();
    let mut branches = Vec::new();
    for (branch, answer) in two.branches.iter().enumerate() {
        let mut values = Vec::new();
        for rotary in 0..2 {
            let (name, first) = (angle_name(rotary, branch), angle_name(rotary, 0));
            let (sine, cosine) = answer.words[rotary];
            let (sine, cosine) = (body.tokens(sine), body.tokens(cosine));
            let value = match answer.angles[rotary] {
                AngleRelation::Own => quote!(math::angle(#sine, #cosine)),
                AngleRelation::Same => quote!(#first),
                AngleRelation::Negated => quote!(math::negated(#first)),
                AngleRelation::HalfTurn => quote!(math::half_turn(#first)),
                AngleRelation::Mirrored => quote!(math::mirrored(#first)),
            };
            angles.extend(quote!(let #name = #value;));
            values.push((two.rotaries[rotary], quote!(#name)));
        }
        let turns = turns(model, |place| {
            let rotary = two.rotaries.iter().position(|known| *known == place)?;
            let (sine, cosine) = answer.words[rotary];
            let (sine, cosine) = (body.tokens(sine), body.tokens(cosine));
            Some(quote!((#sine, #cosine)))
        });
        let name = if branch == 0 { quote!(First) } else { quote!(Second) };
        branches.push(solution(model, solved, &turns, &values, &name, &quote!(false), &quote!(0.0)));
    }
    quote! {
        #prelude
        #guard
        if !(#root >= ::pp_runtime::kinematics::SINGULAR_SINE) #pole #capacity || !#finite {
            return self.inverse_at_the_edge(pose, held);
        }
        #statements
        #angles
        ::pp_runtime::kinematics::Solutions::from_branches([#(#branches),*])
    }
}

/// The cold path of a machine with two rotary axes and its signature: pole, rim, just beyond the rim, and what is no pose at all.
pub(super) fn edge(model: &Model, solved: &Solved) -> Option<(TokenStream, TokenStream)> {
    let Orientation::Two(two) = &solved.orientation else { return None };
    let edge = &two.edge;
    let before =
        [two.second.capacity, two.second.root_squared, two.second.height, two.second.rim, two.first.sine_squared];
    let after = [
        edge.second.0,
        edge.second.1,
        edge.first.0,
        edge.first.1,
        edge.first_squared,
        edge.reached_squared,
        edge.along.0,
        edge.along.1,
    ];
    let outputs: Vec<Id> = before.into_iter().chain(after).collect();
    let mut body = Body::new(&solved.graph, &outputs);
    let inputs = body.inputs(&outputs);
    let prelude = prelude(model, &inputs, inverse_places());
    let begin = lets(&body.statements(&before));
    let [capacity, root_squared, height, rim, sine_squared] = before.map(|node| body.tokens(node));
    let rest = lets(&body.statements(&outputs));
    let [second_sine, second_cosine, first_sine, first_cosine, first_squared, reached_squared, along, reached_along] =
        after.map(|node| body.tokens(node));
    let finite = finite(model);
    let capacity = solved.graph.constant_of(two.second.capacity).is_none().then(|| {
        let least = parallel();
        quote!(!(#capacity > #least) ||)
    });
    let [first, second] = two.rotaries;
    let turns = turns(model, |place| {
        if place == first {
            Some(quote!(first))
        } else if place == second {
            Some(quote!(second))
        } else {
            None
        }
    });
    let values = [(first, quote!(value)), (second, quote!(math::angle(second.0, second.1)))];
    let solution = solution(model, solved, &turns, &values, &quote!(First), &quote!(singular), &quote!(deviation));
    let count = model.axes.len();
    let signature = quote! {
        /// One solution where both branches meet, at the pole, at the rim and within the tolerance outside it.
        fn inverse_at_the_edge(
            &self,
            pose: &::pp_runtime::kinematics::Pose,
            held: &[f64; #count],
        ) -> ::pp_runtime::kinematics::Solutions<[f64; #count]>
    };
    let function = quote! {
        #[cold]
        #[inline(never)]
        #signature {
            let (tip, axis) = (&pose.tip, &pose.axis);
            #prelude
            #begin
            if #capacity !#finite {
                return ::pp_runtime::kinematics::Solutions::none();
            }
            let inside = #root_squared > 0.0;
            let edge_root = if inside { math::sqrt(#root_squared) } else { 0.0 };
            let edge_height = if inside { #height } else if #height < 0.0 { -#rim } else { #rim };
            #rest
            let deviation = if inside {
                0.0
            } else {
                math::hypot(#along - (#reached_along), math::sqrt(#sine_squared) - math::sqrt(#reached_squared))
            };
            if !(deviation <= ::pp_runtime::kinematics::REACH_TOLERANCE) {
                return ::pp_runtime::kinematics::Solutions::none();
            }
            let singular = !(#sine_squared
                >= ::pp_runtime::kinematics::SINGULAR_SINE * ::pp_runtime::kinematics::SINGULAR_SINE)
                || !(#first_squared > 0.0);
            if singular && !held[#first].is_finite() {
                return ::pp_runtime::kinematics::Solutions::none();
            }
            let (first, value) = if singular {
                (math::sin_cos(held[#first]), held[#first])
            } else {
                let value = math::sqrt(#first_squared);
                let first = (#first_sine / value, #first_cosine / value);
                (first, math::angle(first.0, first.1))
            };
            let second = (#second_sine, #second_cosine);
            ::pp_runtime::kinematics::Solutions::from_branches([#solution, ::core::option::Option::None])
        }
    };
    Some((function, quote!(#signature;)))
}

/// `reach`.
pub(super) fn reach(model: &Model, solved: &Solved) -> TokenStream {
    let machine = &model.name;
    let linears = model.letters(model.solved_linears());
    let inputs = inputs(model);
    let why = match &solved.orientation {
        Orientation::Fixed { deviation } => {
            let outputs: Vec<Id> = [*deviation].into_iter().collect();
            let mut body = Body::new(&solved.graph, &outputs);
            let prelude = prelude(model, &body.inputs(&outputs), inverse_places());
            let statements = lets(&body.statements(&outputs));
            let deviation = body.tokens(*deviation);
            quote! {
                #prelude
                #statements
                if !(#deviation <= ::pp_runtime::kinematics::REACH_TOLERANCE) {
                    let tool = self.forward_kinematics(held).axis;
                    return ::core::result::Result::Err(::pp_runtime::kinematics::Unreachable::Fixed {
                        machine: #machine,
                        wanted: [axis.x, axis.y, axis.z],
                        tool_axis: [tool.x, tool.y, tool.z],
                    });
                }
            }
        }
        Orientation::One(one) => {
            let varies = solved.graph.constant_of(one.length_claim).is_none();
            let guard = varies.then_some((one.length_claim, one.rotary, inputs.as_str()));
            cone(model, solved, &one.tilt, one.rotary, guard)
        }
        Orientation::Two(two) => {
            let capacity = solved.graph.constant_of(two.second.capacity).is_none();
            let guard = capacity.then_some((two.second.capacity, two.rotaries[1], inputs.as_str()));
            cone(model, solved, &two.tilt, two.rotaries[0], guard)
        }
    };
    quote! {
        fn reach(
            &self,
            axis: &::pp_runtime::nalgebra::UnitVector3<f64>,
            held: &Self::Axes,
        ) -> ::core::result::Result<(), ::pp_runtime::kinematics::Unreachable> {
            let pose = ::pp_runtime::kinematics::Pose { tip: ::pp_runtime::nalgebra::Point3::origin(), axis: *axis };
            if !self.inverse_kinematics(&pose, held).is_empty() {
                return ::core::result::Result::Ok(());
            }
            if !(axis.x + axis.y + axis.z).is_finite() {
                return ::core::result::Result::Err(::pp_runtime::kinematics::Unreachable::NotFinite);
            }
            #why
            ::core::result::Result::Err(::pp_runtime::kinematics::Unreachable::LinearAxes {
                machine: #machine,
                axes: #linears,
            })
        }
    }
}

/// Held axes and angles of `dims`: what can make a rotary unable to tilt the tool.
fn inputs(model: &Model) -> String {
    let held = model.axes.iter().filter(|axis| axis.held.is_some()).map(|axis| axis.letter.to_string());
    let angles = model.dimensions.iter().filter(|dimension| matches!(dimension.quantity, Quantity::Angle(..)));
    held.chain(angles.map(|dimension| dimension.name.clone())).collect::<Vec<_>>().join(", ")
}

fn cone(
    model: &Model,
    solved: &Solved,
    tilt: &Tilt,
    rotary: AxisId,
    capacity: Option<(Id, AxisId, &str)>,
) -> TokenStream {
    let machine = &model.name;
    let letter = model.axes[rotary].letter;
    let mut outputs = vec![];
    for (sine, cosine) in [tilt.wanted, tilt.between, tilt.tool] {
        outputs.extend([sine, cosine]);
    }
    outputs.extend(tilt.direction);
    outputs.extend(capacity.map(|(node, ..)| node));
    let mut body = Body::new(&solved.graph, &outputs);
    let prelude = prelude(model, &body.inputs(&outputs), inverse_places());
    let statements = lets(&body.statements(&outputs));
    let [wanted, between, tool] = [tilt.wanted, tilt.between, tilt.tool].map(|(sine, cosine)| {
        let (sine, cosine) = (body.tokens(sine), body.tokens(cosine));
        quote!(math::atan2(#sine, #cosine))
    });
    let direction = tilt.direction.map(|node| body.tokens(node));
    let capacity = capacity.map(|(node, axis, held)| {
        let (node, letter) = (body.tokens(node), model.axes[axis].letter);
        let least = parallel();
        quote! {
            if !(#node > #least) {
                return ::core::result::Result::Err(::pp_runtime::kinematics::Unreachable::Held {
                    machine: #machine,
                    rotary: #letter,
                    held: #held,
                });
            }
        }
    });
    quote! {
        #prelude
        #statements
        #capacity
        if let ::core::option::Option::Some(value) = ::pp_runtime::kinematics::Cone::new(#wanted, #between, #tool).outside() {
            return ::core::result::Result::Err(::pp_runtime::kinematics::Unreachable::Cone {
                machine: #machine,
                rotary: #letter,
                direction: [#(#direction),*],
                wanted: [axis.x, axis.y, axis.z],
                cone: value,
            });
        }
    }
}

/// The bound below which directions count as parallel, as a literal.
fn parallel() -> proc_macro2::Literal {
    proc_macro2::Literal::f64_unsuffixed(crate::solve::PARALLEL)
}

fn inverse_places() -> Places<'static> {
    Places { tip: Some("tip"), axis: Some("axis"), words: Some("held"), turns: None }
}

/// The (sine, cosine) of every rotary axis, held ones from their values.
fn turns(model: &Model, solved: impl Fn(AxisId) -> Option<TokenStream>) -> TokenStream {
    let pairs = rotaries(model).map(|place| solved(place).unwrap_or_else(|| quote!(math::sin_cos(held[#place]))));
    quote!([#(#pairs),*])
}

/// Whether the pose, and what is held, are numbers; NaN and infinity stay NaN or infinite in a sum.
fn finite(model: &Model) -> TokenStream {
    let held = model.axes.iter().enumerate().filter(|(_, axis)| axis.held.is_some()).map(|(place, _)| place);
    quote!((tip.x + tip.y + tip.z + axis.x + axis.y + axis.z #(+ held[#held])*).is_finite())
}

/// `Option<Solution>` of one branch.
fn solution(
    model: &Model,
    solved: &Solved,
    turns: &TokenStream,
    angles: &[(AxisId, TokenStream)],
    branch: &TokenStream,
    singular: &TokenStream,
    deviation: &TokenStream,
) -> TokenStream {
    let axes = model.axes.iter().enumerate().map(|(place, axis)| {
        if axis.held.is_some() {
            return quote!(held[#place]);
        }
        if axis.kind == Kind::Linear {
            let index = solved.position.values.iter().position(|(known, _)| *known == place);
            return quote!(solved[#index]);
        }
        angles.iter().find(|(known, _)| *known == place).map(|(_, value)| value.clone()).unwrap_or_default()
    });
    quote! {
        match self.position(tip, &#turns, held) {
            ::core::option::Option::None => ::core::option::Option::None,
            ::core::option::Option::Some(solved) => {
                ::core::option::Option::Some(::pp_runtime::kinematics::Solution {
                    axes: [#(#axes),*],
                    branch: ::pp_runtime::kinematics::Branch::#branch,
                    singular: #singular,
                    deviation: #deviation,
                })
            }
        }
    }
}
