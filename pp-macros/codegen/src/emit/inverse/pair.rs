//! Two solved rotary axes: two solutions, unless the edge is near.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::Wanted;
use super::guard::{finite, inverse_variables, needs_pole_test, parallel};
use super::solution::SolutionTokens;
use crate::emit::body::{Body, lets};
use crate::emit::inputs::prelude;
use crate::model::{AxisId, Model};
use crate::solve::{AngleRelation, Branch, Solved, TwoRotaries};
use crate::symbolic::{Id, SineCosine};

/// Both branches, or the cold path.
pub(crate) fn pair(model: &Model, solved: &Solved, two: &TwoRotaries, wanted: Wanted) -> TokenStream {
    let guarded = [two.second.root, two.first.sine_squared, two.second.capacity];
    let words = |branch: &Branch| branch.words.map(SineCosine::nodes).concat();
    let outputs: Vec<Id> = guarded.into_iter().chain(two.branches.iter().flat_map(words)).collect();
    let mut body = Body::new(&solved.graph, &outputs);
    let prelude = prelude(model, &body.inputs(&outputs), inverse_variables());
    let guard = lets(&body.statements(&guarded));
    let near_the_edge = near_the_edge(solved, &body, two);
    let finite = finite(model, wanted);
    let statements = lets(&body.statements(&outputs));
    let angles = angles(model, &body, two);
    let tokens = PairTokens { model, solved, body: &body, two, wanted };
    let solutions = (0..2).map(|branch| tokens.solution(branch));
    let at_the_edge = match wanted {
        Wanted::AllAxes => quote!(self.inverse_at_the_edge(pose, held)),
        Wanted::RotaryAxes => quote!(self.rotary_axes_at_the_edge(axis, held)),
    };
    quote! {
        #prelude
        #guard
        if #near_the_edge || !#finite {
            return #at_the_edge;
        }
        #statements
        #angles
        pp::kinematics::Solutions::from_branches([#(#solutions),*])
    }
}

/// Test that both branches meet, the first rotary is free, or the rotary axes cannot tilt the tool.
fn near_the_edge(solved: &Solved, body: &Body<'_>, two: &TwoRotaries) -> TokenStream {
    let [root, sine_squared, capacity] =
        [two.second.root, two.first.sine_squared, two.second.capacity].map(|node| body.tokens(node));
    let pole = needs_pole_test(two)
        .then(|| quote!(|| !(#sine_squared >= pp::kinematics::SINGULAR_SINE * pp::kinematics::SINGULAR_SINE)));
    let capacity = solved.graph.constant_of(two.second.capacity).is_none().then(|| {
        let least = parallel();
        quote!(|| !(#capacity > #least))
    });
    quote!(!(#root >= pp::kinematics::SINGULAR_SINE) #pole #capacity)
}

/// `let` statements for the angles of both branches: the arc tangents together, and then those that follow from them.
fn angles(model: &Model, body: &Body<'_>, two: &TwoRotaries) -> TokenStream {
    let all = || (0..2).flat_map(|branch| (0..2).map(move |rotary| (branch, rotary)));
    let name = |branch: usize, rotary: usize| angle_name(model, two, rotary, branch);
    let is_own = |branch: usize, rotary: usize| matches!(two.branches[branch].angles[rotary], AngleRelation::Own);
    let own = all().filter(|&(branch, rotary)| is_own(branch, rotary));
    let (names, turns): (Vec<_>, Vec<_>) = own
        .map(|(branch, rotary)| {
            let word = two.branches[branch].words[rotary];
            let (sine, cosine) = (body.tokens(word.sine), body.tokens(word.cosine));
            (name(branch, rotary), quote!((#sine, #cosine)))
        })
        .unzip();
    let others = all().filter_map(|(branch, rotary)| {
        let (name, first) = (name(branch, rotary), name(0, rotary));
        let value = match two.branches[branch].angles[rotary] {
            AngleRelation::Own => return None,
            AngleRelation::Same => quote!(#first),
            AngleRelation::Negated => quote!(math::negated(#first)),
            AngleRelation::HalfTurn => quote!(math::half_turn(#first)),
            AngleRelation::Mirrored => quote!(math::mirrored(#first)),
        };
        Some(quote!(let #name = #value;))
    });
    quote! {
        let [#(#names),*] = math::angles([#(#turns),*]);
        #(#others)*
    }
}

/// Machine, nodes and names from which the solutions of both branches are written.
struct PairTokens<'a> {
    model: &'a Model,
    solved: &'a Solved,
    body: &'a Body<'a>,
    two: &'a TwoRotaries,
    wanted: Wanted,
}

impl PairTokens<'_> {
    /// The solution of a branch.
    fn solution(&self, branch: usize) -> TokenStream {
        let Self { model, solved, body, two, wanted } = *self;
        let turns = two.branches[branch].words.map(|word| {
            let (sine, cosine) = (body.tokens(word.sine), body.tokens(word.cosine));
            quote!((#sine, #cosine))
        });
        let angles = [0, 1].map(|rotary| {
            let name = angle_name(model, two, rotary, branch);
            quote!(#name)
        });
        let of_rotaries =
            |tokens: [TokenStream; 2]| -> Vec<(AxisId, TokenStream)> { two.rotaries.into_iter().zip(tokens).collect() };
        let name = if branch == 0 { quote!(First) } else { quote!(Second) };
        let solution = SolutionTokens {
            turns: &of_rotaries(turns),
            angles: &of_rotaries(angles),
            branch: name,
            singular: quote!(false),
            deviation: quote!(0.0),
        };
        solution.tokens(model, solved, wanted)
    }
}

/// `angle_c_1`
fn angle_name(model: &Model, two: &TwoRotaries, rotary: usize, branch: usize) -> Ident {
    format_ident!("angle_{}_{}", model.axes[two.rotaries[rotary]].letter.to_ascii_lowercase(), branch + 1)
}
