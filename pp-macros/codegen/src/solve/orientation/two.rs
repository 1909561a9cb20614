//! Both rotary angles from a tool axis, in closed form.
//!
//! # Quantities
//!
//! `n` and `m` are the directions of the first and second solved rotary, counted from the workpiece, `t` is the tool
//! axis, `a` the wanted axis, `b` the tool axis rotated by the second rotary alone. A quantity has the same name here,
//! in the fields of [`TwoRotaries`] and in generated code; papers use the symbol.
//!
//! | name | symbol | value | meaning |
//! |---|---|---|---|
//! | `p` | `p` | `n·m` | cosine of the angle between the rotaries |
//! | `q` | `q` | `m·t` | cosine of the angle between the second rotary and the tool |
//! | `between_squared` | | `1 - p²` | sine squared of the angle between the rotaries |
//! | `mean` | | `p q` | mean of `n·b` over a revolution of the second rotary |
//! | `alpha` | `α1, α2` | `(m×n)·(m×t)`, `n·(m×t)` | factors of `cos` and `sin` of the second angle in `n·b` |
//! | `rim` | `√D` | `√(α1² + α2²)` | amplitude of `n·b`: the largest height |
//! | `capacity` | `D` | `α1² + α2² = (1-p²)(1-q²)` | the rim squared |
//! | `along` | | `n·a` | cosine of the angle between the first rotary and the wanted axis |
//! | `height` | `w` | `n·a - p q` | height of the wanted axis over the mean |
//! | `root` | `r` | `√(D - w²)` | zero at the rim, where both branches meet |
//! | `g`, `e` | `g, e` | `(m×n)·a`, `(m - p n)·a` | the wanted axis in the plane perpendicular to `n` |
//! | `spread` | | `g² + e² = (1-p²)\|n×a\|²` | the squared length of `(g, e)` |
//! | `sine_squared` | | `\|n×a\|²` | zero at the pole, where the first angle is free |
//! | `lean` | `A` | `(m - p n)·b = q (1-p²) - p w` | what `e` is for the rotated tool; `g` is `σ r` there |
//! | `near`, `far` | | see below | factors of the root squared |
//!
//! # Angles
//!
//! The second angle must bring the tool to the height of the wanted axis, `α1 cos + α2 sin = w`. With
//! `(m×n)·b = α1 sin - α2 cos = σ r`, `σ = ±1`, it takes `(α1, α2)` to `(w, σ r)`:
//! `c2 = (α1 w - σ α2 r)/D`, `s2 = (α2 w + σ α1 r)/D`.
//! The first angle takes the rotated tool to the wanted axis in the plane perpendicular to `n`, `(A, σ r)` to `(e, g)`:
//! `c1 = (A e + σ r g)/(g² + e²)`, `s1 = (σ r e - A g)/(g² + e²)`.
//!
//! # Conditioning
//!
//! `1 - k` loses half the digits near `k = 1`; `(|n×a|² + (1-k)²)/2` is equal to it and loses none.
//! - If `q = ε p` identically (`ε = ±1`), the pole `a = ε n` can be reached. Then `√D = 1-p²` needs no root,
//!   `r² = near·far` with `near = (|n×a|² + (1-ε n·a)²)/2` and `far = 1-2p² + ε n·a`, and `A = ε p·near`. With
//!   `p = 0` this is `r² = g² + e²`, `A = 0`.
//! - Otherwise `√D - w = near = (|n×a|² + (1-n·a)²)/2 - (p-q)²/(1-pq+√D)`, and `√D + w = far` is the same with `-a` and
//!   `-q`; the first angle is normalised by its own length, since held values may bring the machine close to the first
//!   case.
//!
//! Covers every pair of non-parallel directions, orthogonal or not, on either side of the frame.

use std::collections::BTreeMap;

use super::geometry::{Coordinates, Directions, FirstScale, Invariants, Pole, Radicand};
use super::pair::{Branch, Edge, FirstAngle, SecondAngle, TwoRotaries};
use super::relation::{AngleRelation, relation};
use super::tilt::{Tilt, in_workpiece};
use crate::model::AxisId;
use crate::solve::derivation::Derivation;
use crate::solve::refusal::Refusal;
use crate::symbolic::{GraphBuilder, Poly, SineCosine, Symbol, Term};

/// Both angles of both branches.
///
/// # Errors
/// The rotary axes are parallel to each other, or the second to the tool.
pub(crate) fn solve<'g>(
    derivation: &'g Derivation<'_>,
    rotaries: [AxisId; 2],
    directions: Directions<'g>,
    defaults: &BTreeMap<Symbol, Poly>,
) -> Result<TwoRotaries, Vec<Refusal>> {
    let machine = Invariants::of(directions, rotaries, defaults)?;
    let pole = Pole::of(machine.p, machine.q);
    let wanted = Coordinates::of(directions, &machine);
    let radicand = Radicand::of(&derivation.graph, pole, &machine, &wanted);
    let root = radicand.squared.named("root_squared").sqrt().named("root");
    let lean = radicand.lean.named("lean");
    let plus = first_branch_is_plus(machine.alpha, derivation.model.axes[rotaries[1]].reversed, defaults);
    let words = RotaryWords { reversed: rotaries.map(|id| derivation.model.axes[id].reversed), machine: &machine };
    let scale = FirstScale::of(pole, root, lean, wanted.spread);
    let branches = [plus, !plus].map(|plus| {
        let root = root.signed(plus);
        let second = words.second(wanted.height, root);
        // In the orthogonal form the root cancels against the length; only its sign remains.
        let root = if pole == Pole::Orthogonal { derivation.graph.integer(1).signed(plus) } else { root };
        let (sine, cosine) = words.first(&wanted, lean, root);
        let words = [(sine * scale.inverse, cosine * scale.inverse), second];
        (plus, words.map(|(sine, cosine)| SineCosine::of(sine, cosine)))
    });
    let edge = edge(&derivation.graph, &machine, &wanted, &words, plus);
    let roots = [wanted.sine_squared, machine.between_squared, machine.tool_squared].map(Term::sqrt);
    let tilt = Tilt {
        wanted: SineCosine::of(roots[0], wanted.along),
        between: SineCosine::of(roots[1], machine.p),
        tool: SineCosine::of(roots[2], machine.q),
        direction: in_workpiece(derivation, rotaries[0]).ids(),
    };
    Ok(TwoRotaries {
        rotaries,
        second: SecondAngle {
            alpha: machine.alpha.map(Term::id),
            capacity: machine.capacity.id(),
            rim: radicand.rim.id(),
            height: wanted.height.id(),
            root: root.id(),
            root_squared: radicand.squared.id(),
        },
        first: FirstAngle {
            between_squared: machine.between_squared.id(),
            spread: wanted.spread.id(),
            sine_squared: wanted.sine_squared.id(),
            length: scale.length.map(Term::id),
            inverse: scale.inverse.id(),
        },
        branches: related(derivation, branches),
        edge,
        pole,
        tilt,
    })
}

/// Builds sine and cosine of the words, with the sign of each axis.
struct RotaryWords<'a, 'g> {
    reversed: [bool; 2],
    machine: &'a Invariants<'g>,
}

impl<'g> RotaryWords<'_, 'g> {
    /// `(α1, α2)` to `(height, root)`; the root has the sign `σ`.
    fn second(&self, height: Term<'g>, root: Term<'g>) -> (Term<'g>, Term<'g>) {
        let Invariants { alpha, capacity, .. } = *self.machine;
        let cosine = (alpha[0] * height - alpha[1] * root) / capacity;
        let sine = (alpha[1] * height + alpha[0] * root) / capacity;
        (sine.signed(!self.reversed[1]), cosine)
    }

    /// `(lean, root)` to `(e, g)`, times a common factor; the root has the sign `σ`.
    fn first(&self, wanted: &Coordinates<'g>, lean: Term<'g>, root: Term<'g>) -> (Term<'g>, Term<'g>) {
        let Coordinates { g, e, .. } = *wanted;
        // Products before sums: both branches have the same products.
        let (lean_e, root_g, root_e, lean_g) = (lean * e, root * g, root * e, lean * g);
        let cosine = lean_e + root_g;
        let sine = root_e - lean_g;
        (sine.signed(!self.reversed[0]), cosine)
    }
}

/// Formulas of the first branch with `w` and `r` as inputs.
fn edge<'g>(
    graph: &'g GraphBuilder,
    machine: &Invariants<'g>,
    wanted: &Coordinates<'g>,
    words: &RotaryWords<'_, 'g>,
    plus: bool,
) -> Edge {
    let (height_symbol, root_symbol) = (graph.symbol("edge_height"), graph.symbol("edge_root"));
    let (height, root) = (graph.input(height_symbol), graph.input(root_symbol));
    let signed_root = root.signed(plus);
    let lean = machine.lean(height);
    let first = words.first(wanted, lean, signed_root);
    let first_squared = first.0.square() + first.1.square();
    let reached_squared = (lean.square() + root.square()) / machine.between_squared;
    let second = words.second(height, signed_root);
    let reached_along = height + wanted.mean;
    Edge {
        height: height_symbol,
        root: root_symbol,
        second: SineCosine::of(second.0, second.1),
        first: SineCosine::of(first.0, first.1),
        first_squared: first_squared.id(),
        reached_squared: reached_squared.id(),
        along: (wanted.along.id(), reached_along.id()),
    }
}

/// The sign `σ` that makes the written second angle's sine, or with `α1 = 0` its cosine, not negative.
fn first_branch_is_plus(alpha: [Term<'_>; 2], reversed: bool, defaults: &BTreeMap<Symbol, Poly>) -> bool {
    let [first, second] = alpha.map(|factor| factor.at(defaults));
    match first {
        None => second.unwrap_or_default() < 0.0,
        Some(first) => (first >= 0.0) != reversed,
    }
}

/// Both branches, with the relations of the second branch's angles to the first.
fn related(derivation: &Derivation<'_>, [first, second]: [(bool, [SineCosine; 2]); 2]) -> [Branch; 2] {
    let own = |(plus, words)| Branch { plus, words, angles: [AngleRelation::Own; 2] };
    let (first, second) = (own(first), own(second));
    let angles = std::array::from_fn(|rotary| relation(derivation, first.words[rotary], second.words[rotary]));
    [first, Branch { angles, ..second }]
}
