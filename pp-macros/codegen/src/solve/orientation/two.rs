//! Both rotary angles from a tool axis, in closed form.
//!
//! # Words
//!
//! `n` and `m` are the directions of the first and second solved rotary, counted from the workpiece, `t` is the tool
//! axis, `a` the wanted axis, `b` the tool axis rotated by the second rotary alone. One word names a quantity here, in the
//! fields of [`Two`] and in generated code; papers use the symbol.
//!
//! | word | symbol | value | meaning |
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
//! | `spread` | | `g² + e² = (1-p²)\|n×a\|²` | its distance from `n` there, squared |
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
//! `1 - k` loses half the digits near `k = 1`; `(|n×a|² + (1-k)²)/2` is the same number and loses none.
//! - If `q = ε p` identically (`ε = ±1`), the pole `a = ε n` can be reached. Then `√D = 1-p²` needs no root,
//!   `r² = near·far` with `near = (|n×a|² + (1-ε n·a)²)/2` and `far = 1-2p² + ε n·a`, and `A = ε p·near`. With
//!   `p = 0` this is `r² = g² + e²`, `A = 0`.
//! - Otherwise `√D - w = near = (|n×a|² + (1-n·a)²)/2 - (p-q)²/(1-pq+√D)`, and `√D + w = far` is the same with `-a` and
//!   `-q`; the first angle is normalised by its own length, since held values may bring the machine close to the first
//!   case.
//!
//! Covers every pair of non-parallel directions, orthogonal or not, on either side of the frame.

use std::collections::BTreeMap;

use super::relation::{AngleRelation, relation};
use super::{Tilt, in_workpiece, nodes, squared_at};
use crate::model::{AxisId, Model};
use crate::solve::{Derivation, PARALLEL, Refusal};
use crate::symbolic::{GraphBuilder, Id, Interpreter, Poly, Symbol, Term, Vec3};

/// Two solved rotary axes.
#[derive(Debug, Clone)]
pub struct Two {
    /// First and second from the workpiece.
    pub rotaries: [AxisId; 2],
    /// What both branches have in common in the second angle.
    pub second: SecondAngle,
    /// What both branches have in common in the first angle.
    pub first: FirstAngle,
    /// The branches in their order.
    pub branches: [Branch; 2],
    /// The formulas where the hot path ends: pole, rim, beyond the rim.
    pub edge: Edge,
    /// Whether the tool can be laid parallel to the first rotary.
    pub pole: Pole,
    /// For diagnostics.
    pub tilt: Tilt,
}

impl Two {
    /// Whether `σ` is plus on the first branch.
    #[must_use]
    pub fn first_is_plus(&self) -> bool {
        self.branches[0].plus
    }

    /// `α1 sin - α2 cos` of the second joint: it has the sign `σ`, and is the root on the branch with plus.
    #[must_use]
    pub fn side(&self, model: &Model, reader: &mut Interpreter<'_>) -> Poly {
        let second = self.rotaries[1];
        let [sine_factor, cosine_factor] = self.second.alpha.map(|node| reader.value(node));
        let (ring, cosine) = (reader.ring(), Poly::from(model.axes[second].turn.1));
        &ring.mul(&sine_factor, &model.joint_sine(second)) - &ring.mul(&cosine_factor, &cosine)
    }
}

/// The second angle solves `α1 cos + α2 sin = height`.
#[derive(Debug, Clone, Copy)]
pub struct SecondAngle {
    /// `α1`, `α2`.
    pub alpha: [Id; 2],
    /// `D = α1² + α2²`, what sine and cosine are divided by.
    pub capacity: Id,
    /// `√D`.
    pub rim: Id,
    /// `w`.
    pub height: Id,
    /// `r`, common to both branches.
    pub root: Id,
    /// `r² = D - w²`, as it is computed.
    pub root_squared: Id,
}

/// The first angle takes the rotated tool to the wanted axis, in the plane perpendicular to the first rotary.
#[derive(Debug, Clone, Copy)]
pub struct FirstAngle {
    /// `1-p²`.
    pub between_squared: Id,
    /// `g² + e² = (1-p²)|n×a|²`.
    pub spread: Id,
    /// `|n×a|²`.
    pub sine_squared: Id,
    /// Set where the angle is normalised by its own length: that root; its exact value is `spread`.
    pub length: Option<Id>,
    /// A positive factor that sine and cosine have in common.
    pub inverse: Id,
}

/// One branch.
#[derive(Debug, Clone, Copy)]
pub struct Branch {
    /// `σ` is plus.
    pub plus: bool,
    /// Sine and cosine of the words, first and second rotary.
    pub words: [(Id, Id); 2],
    /// How the angles follow.
    pub angles: [AngleRelation; 2],
}

/// Formulas of the first branch over free `w` and `r`.
#[derive(Debug, Clone, Copy)]
pub struct Edge {
    /// `w`.
    pub height: Symbol,
    /// `r`.
    pub root: Symbol,
    /// Sine and cosine of the second word.
    pub second: (Id, Id),
    /// Sine and cosine of the first word times a common factor.
    pub first: (Id, Id),
    /// Square of that factor.
    pub first_squared: Id,
    /// `|n×b|²` of the reached axis.
    pub reached_squared: Id,
    /// `n·a` of the wanted and `n·b` of the reached axis.
    pub along: (Id, Id),
}

/// Whether and where the tool can be laid parallel to the first rotary.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Pole {
    /// At `n` and `-n`: the rotaries are perpendicular to each other and to the tool.
    Orthogonal,
    /// At `n`.
    Plus,
    /// At `-n`.
    Minus,
    /// Not for all values of held axes and dimensions.
    Elsewhere,
}

impl Pole {
    fn of(p: Term<'_>, q: Term<'_>) -> Self {
        p.read(|reader, p| {
            let (p, q) = (reader.value(p), reader.value(q.id()));
            if reader.equal(&p, &q) {
                if p.is_zero() { Self::Orthogonal } else { Self::Plus }
            } else if reader.equal(&p, &-&q) {
                Self::Minus
            } else {
                Self::Elsewhere
            }
        })
    }
}

/// Directions at the held values: both rotaries, the tool axis, the wanted axis.
#[derive(Clone, Copy)]
pub(crate) struct Directions<'g> {
    pub(crate) n: Vec3<'g>,
    pub(crate) m: Vec3<'g>,
    pub(crate) t: Vec3<'g>,
    pub(crate) a: Vec3<'g>,
}

pub(crate) fn solve<'g>(
    derivation: &'g Derivation<'_>,
    rotaries: [AxisId; 2],
    directions: Directions<'g>,
    defaults: &BTreeMap<Symbol, Poly>,
) -> Result<Two, Vec<Refusal>> {
    let machine = Invariants::of(directions, rotaries, defaults)?;
    let pole = Pole::of(machine.p, machine.q);
    let wanted = Coordinates::of(directions, &machine);
    let radicand = Radicand::of(&derivation.graph, pole, &machine, &wanted);
    let root = radicand.squared.named("root_squared").sqrt().named("root");
    let lean = radicand.lean.named("lean");
    let plus = first_branch_is_plus(machine.alpha, derivation.model.axes[rotaries[1]].reversed, defaults);
    let words = Words { reversed: rotaries.map(|id| derivation.model.axes[id].reversed), machine: &machine };
    let scale = FirstScale::of(pole, root, lean, wanted.spread);
    let branches = [plus, !plus].map(|plus| {
        let root = root.signed(plus);
        let second = words.second(wanted.height, root);
        // In the orthogonal form the root cancels against the length: only its sign is left.
        let root = if pole == Pole::Orthogonal { derivation.graph.integer(1).signed(plus) } else { root };
        let (sine, cosine) = words.first(&wanted, lean, root);
        (plus, [(sine * scale.inverse, cosine * scale.inverse), second].map(nodes))
    });
    let edge = edge(&derivation.graph, &machine, &wanted, &words, plus);
    let roots = [wanted.sine_squared, machine.between_squared, machine.tool_squared].map(Term::sqrt);
    let tilt = Tilt {
        wanted: nodes((roots[0], wanted.along)),
        between: nodes((roots[1], machine.p)),
        tool: nodes((roots[2], machine.q)),
        direction: in_workpiece(derivation, rotaries[0]).ids(),
    };
    Ok(Two {
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

/// What does not depend on the wanted axis.
struct Invariants<'g> {
    p: Term<'g>,
    q: Term<'g>,
    alpha: [Term<'g>; 2],
    capacity: Term<'g>,
    between_squared: Term<'g>,
    /// `|m×t|² = 1 - q²`.
    tool_squared: Term<'g>,
    /// `m×n`
    m_n: Vec3<'g>,
}

impl<'g> Invariants<'g> {
    fn of(
        Directions { n, m, t, .. }: Directions<'g>,
        rotaries: [AxisId; 2],
        defaults: &BTreeMap<Symbol, Poly>,
    ) -> Result<Self, Vec<Refusal>> {
        let (m_n, m_t) = (m.cross(n), m.cross(t));
        let (between_squared, tool_squared) = (m_n.dot(m_n), m_t.dot(m_t));
        let between_squared = between_squared.settled();
        let (between, tool) = (squared_at(defaults, m_n), squared_at(defaults, m_t));
        if between * tool <= PARALLEL {
            let [first, second] = rotaries;
            let same = (between <= PARALLEL || between <= tool).then_some(Refusal::SameDirection(first, second));
            let still = (tool <= PARALLEL || tool < between).then_some(Refusal::CannotTilt(second));
            return Err(same.into_iter().chain(still).collect());
        }
        let [p, q] = [n.dot(m), m.dot(t)].map(Term::settled);
        let alpha = [m_n.dot(m_t), n.dot(m_t)].map(Term::settled);
        let capacity = (alpha[0].square() + alpha[1].square()).settled().named("capacity");
        Ok(Self { p, q, alpha, capacity, between_squared, tool_squared, m_n })
    }

    /// `A` of a tool at a height.
    fn lean(&self, height: Term<'g>) -> Term<'g> {
        self.q * self.between_squared - self.p * height
    }
}

/// Where the wanted axis is: its height, and its coordinates in the plane perpendicular to the first rotary.
struct Coordinates<'g> {
    along: Term<'g>,
    mean: Term<'g>,
    height: Term<'g>,
    g: Term<'g>,
    e: Term<'g>,
    spread: Term<'g>,
    sine_squared: Term<'g>,
}

impl<'g> Coordinates<'g> {
    fn of(Directions { n, a, .. }: Directions<'g>, machine: &Invariants<'g>) -> Self {
        let along = n.dot(a);
        let g = machine.m_n.dot(a);
        // n×(m×n) = m - p n
        let e = n.cross(machine.m_n).dot(a);
        let spread = (g * g + e * e).named("spread");
        let sine_squared = (spread / machine.between_squared).named("sine_squared");
        let mean = machine.p * machine.q;
        let height = (along - mean).named("height");
        Self { along, mean, height, g, e, spread, sine_squared }
    }

    /// `(|n×a|² + (1-k)²)/2`, which is `1-k` without the loss of digits; `k` is `n·a` or `-n·a`.
    fn one_minus(&self, k: Term<'g>) -> Term<'g> {
        (self.sine_squared + (1 - k).square()) / 2
    }
}

/// The root squared in the form that keeps its digits, and what belongs to that form.
struct Radicand<'g> {
    rim: Term<'g>,
    squared: Term<'g>,
    lean: Term<'g>,
}

impl<'g> Radicand<'g> {
    fn of(graph: &'g GraphBuilder, pole: Pole, machine: &Invariants<'g>, wanted: &Coordinates<'g>) -> Self {
        match pole {
            Pole::Orthogonal => Self { rim: machine.between_squared, squared: wanted.spread, lean: graph.integer(0) },
            Pole::Plus => Self::with_pole(true, machine, wanted),
            Pole::Minus => Self::with_pole(false, machine, wanted),
            Pole::Elsewhere => Self::without_pole(machine, wanted),
        }
    }

    /// `q = ε p`, with `ε` plus or minus.
    fn with_pole(plus: bool, machine: &Invariants<'g>, wanted: &Coordinates<'g>) -> Self {
        let p = machine.p;
        let along = wanted.along.signed(plus);
        let near = wanted.one_minus(along).named("near");
        let p_squared = p.square();
        let far = (1 - (p_squared + p_squared) + along).named("far");
        Self { rim: machine.between_squared, squared: near * far, lean: (p * near).signed(plus) }
    }

    fn without_pole(machine: &Invariants<'g>, wanted: &Coordinates<'g>) -> Self {
        let Invariants { p, q, .. } = *machine;
        let (along, mean) = (wanted.along, wanted.mean);
        let rim = machine.capacity.sqrt().named("rim");
        let minus_along = -along;
        let sides = [(along, p - q, 1 - mean), (minus_along, p + q, 1 + mean)];
        let [near, far] = sides.map(|(k, gap, one_minus_mean)| {
            let clear = wanted.one_minus(k);
            let gap_squared = gap.square();
            clear - gap_squared / (one_minus_mean + rim)
        });
        let (near, far) = (near.named("near"), far.named("far"));
        Self { rim, squared: near * far, lean: machine.lean(wanted.height) }
    }
}

/// What the sine and cosine of the first angle are multiplied by.
struct FirstScale<'g> {
    length: Option<Term<'g>>,
    inverse: Term<'g>,
}

impl<'g> FirstScale<'g> {
    fn of(pole: Pole, root: Term<'g>, lean: Term<'g>, spread: Term<'g>) -> Self {
        let (length, divisor) = match pole {
            Pole::Orthogonal => (None, root),
            Pole::Plus | Pole::Minus => (None, spread),
            Pole::Elsewhere => {
                let length = ((lean.square() + root.square()) * spread).sqrt().named("length");
                (Some(length), length)
            }
        };
        Self { length, inverse: (1 / divisor).named("inverse") }
    }
}

/// Sine and cosine of the words, with the sign of each axis.
struct Words<'a, 'g> {
    reversed: [bool; 2],
    machine: &'a Invariants<'g>,
}

impl<'g> Words<'_, 'g> {
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

/// The first branch over free `w` and `r`.
fn edge<'g>(
    graph: &'g GraphBuilder,
    machine: &Invariants<'g>,
    wanted: &Coordinates<'g>,
    words: &Words<'_, 'g>,
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
        second: nodes(second),
        first: nodes(first),
        first_squared: first_squared.id(),
        reached_squared: reached_squared.id(),
        along: nodes((wanted.along, reached_along)),
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

/// The branches, with angles of the second that follow from the first.
fn related(derivation: &Derivation<'_>, [first, second]: [(bool, [(Id, Id); 2]); 2]) -> [Branch; 2] {
    let own = |(plus, words)| Branch { plus, words, angles: [AngleRelation::Own; 2] };
    let (first, second) = (own(first), own(second));
    let angles = std::array::from_fn(|rotary| relation(derivation, first.words[rotary], second.words[rotary]));
    [first, Branch { angles, ..second }]
}
