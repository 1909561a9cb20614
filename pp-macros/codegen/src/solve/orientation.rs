//! Closed-form rotary angles from a tool axis.
//!
//! With `n`, `m` the directions of the first and second solved rotary from the workpiece, `t` the tool axis (turns of
//! held rotaries folded in) and `a` the wanted axis, write
//! `p = n·m`, `q = m·t`, `α1 = (m×n)·(m×t)`, `α2 = n·(m×t)`, `D = α1² + α2² = (1-p²)(1-q²)`, `w = n·a - p q`,
//! `r² = D - w²`. For `σ = ±1` the second angle has
//! `c2 = (α1 w - σ α2 r)/D`, `s2 = (α2 w + σ α1 r)/D`.
//! Let `g = (m×n)·a`, `e = (m - p n)·a`, so that `g² + e² = (1-p²)|n×a|²`, and `A = q(1-p²) - p w`. The turned tool
//! axis `b = R2 t` has `n×b = (A (n×m) + σ r (m - p n)) / (1-p²)`, hence the first angle
//! `c1 = (A e + σ r g)/(g²+e²)`, `s1 = (σ r e - A g)/(g²+e²)`.
//!
//! Conditioning. `1 - k` loses half the digits near `k = 1`; `(|n×a|² + (1-k)²)/2` is the same number and loses none.
//! - If `q = ε p` identically (`ε = ±1`), the pole `a = ε n` can be reached. Then `√D = 1-p²` needs no root,
//!   `r² = near·far` with `near = (|n×a|² + (1-ε n·a)²)/2` and `far = 1-2p² + ε n·a`, and `A = ε p·near`. With
//!   `p = 0` this is `r² = g² + e²`, `A = 0`.
//! - Otherwise `√D - w = (|n×a|² + (1-n·a)²)/2 - (p-q)²/(1-pq+√D)` and likewise `√D + w` with opposite signs; the
//!   first angle is normalised by its own length, since held values may bring the machine close to the first case.
//!
//! Covers every pair of non-parallel directions, orthogonal or not, on either side of the frame.

use std::collections::BTreeMap;

use super::{Chain, PARALLEL, Refusal};
use crate::model::{AxisId, Kind, Model};
use crate::symbolic::{Graph, Id, Interpreter, Poly, Symbol, V3};

/// How the tool axis is reached.
#[derive(Debug, Clone)]
pub enum Orientation {
    /// No solved rotary axis.
    Fixed {
        /// `|a - t|`.
        deviation: Id,
    },
    /// One solved rotary axis.
    One(One),
    /// Two solved rotary axes.
    Two(Box<Two>),
}

/// One solved rotary axis.
#[derive(Debug, Clone)]
pub struct One {
    /// The axis.
    pub rotary: AxisId,
    /// Sine and cosine of its word.
    pub word: (Id, Id),
    /// Distance from the wanted axis to the reachable cone.
    pub deviation: Id,
    /// The root whose exact value on the cone is `length_claim`.
    pub length: Id,
    /// What sine and cosine of the word have in common, `1 / length`.
    pub inverse: Id,
    /// `|n×t|²`, the exact value of `length` on the cone.
    pub length_claim: Id,
    /// The angle to the rotary, wanted and reached.
    pub tilt: Tilt,
}

/// Angles to the first rotary as (sine, cosine) pairs, for diagnostics.
#[derive(Debug, Clone, Copy)]
pub struct Tilt {
    /// Angle between the first rotary and the wanted axis.
    pub wanted: (Id, Id),
    /// Angle between the first and the second rotary; 0 with one rotary.
    pub between: (Id, Id),
    /// Angle between the last rotary and the tool axis.
    pub tool: (Id, Id),
    /// Direction of the first rotary in the workpiece frame, at the held values in front of it.
    pub direction: V3,
}

/// Two solved rotary axes.
#[derive(Debug, Clone)]
pub struct Two {
    /// First and second from the workpiece.
    pub rotaries: [AxisId; 2],
    /// `D`.
    pub capacity: Id,
    /// `1-p²`.
    pub room: Id,
    /// `g² + e² = (1-p²)|n×a|²`.
    pub spread: Id,
    /// `r`, common to both branches.
    pub root: Id,
    /// `r²`.
    pub root_squared: Id,
    /// `|n×a|²`.
    pub sine_squared: Id,
    /// `w`.
    pub height: Id,
    /// `√D`.
    pub rim: Id,
    /// Set where the first angle is normalised by its own length: that root; its exact value is `spread`.
    pub length: Option<Id>,
    /// A positive factor that sine and cosine of the first angle have in common.
    pub inverse: Id,
    /// The branches in their order.
    pub answers: [Answer; 2],
    /// The formulas where the hot path ends: pole, rim, beyond the rim.
    pub edge: Edge,
    /// True if the pole can be reached.
    pub has_pole: bool,
    /// True if both branches sum up to the orthogonal form.
    pub orthogonal: bool,
    /// `α1`, `α2`.
    pub alpha: [Id; 2],
    /// The sign `σ` of the first branch is plus.
    pub first_is_plus: bool,
    /// For diagnostics.
    pub tilt: Tilt,
}

/// One branch.
#[derive(Debug, Clone, Copy)]
pub struct Answer {
    /// `σ` is plus.
    pub plus: bool,
    /// Sine and cosine of the words, first and second rotary.
    pub words: [(Id, Id); 2],
    /// How the angles follow.
    pub angles: [Angle; 2],
}

/// How an angle is obtained.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Angle {
    /// From its own sine and cosine.
    Own,
    /// Equal to that of the first branch.
    Same,
    /// Opposite sine, same cosine as in the first branch.
    Negated,
    /// Half a turn from the first branch.
    HalfTurn,
    /// Same sine, opposite cosine.
    Mirrored,
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

pub(super) fn solve(chain: &mut Chain<'_>, defaults: &BTreeMap<Symbol, Poly>) -> Result<Orientation, Vec<Refusal>> {
    let model: &Model = chain.model;
    let mut axis = model.frame.axis.map(|symbol| chain.graph.input(symbol));
    let solved: Vec<AxisId> = model.solved_rotaries().collect();
    let held = |id: &AxisId| model.axes[*id].kind == Kind::Rotary && model.axes[*id].held.is_some();
    let first = solved.first().copied().unwrap_or(model.axes.len());
    for id in (0..first).filter(held) {
        axis = chain.turn_back(id, axis);
    }
    let mut tool = chain.tool_axis();
    for id in (solved.last().map_or(first, |last| last + 1)..model.axes.len()).filter(held).rev() {
        tool = chain.turn(id, tool);
    }
    match solved[..] {
        [] => Ok(fixed(chain, axis, tool)),
        [rotary] => one(chain, rotary, axis, tool, defaults),
        [first, second] => {
            let mut m = chain.direction(second);
            for id in (first + 1..second).filter(held).rev() {
                m = chain.turn(id, m);
                tool = chain.turn(id, tool);
            }
            two(chain, [first, second], m, axis, tool, defaults)
        }
        _ => unreachable!("the check lets at most two solved rotary axes pass"),
    }
}

fn fixed(chain: &mut Chain<'_>, axis: V3, tool: V3) -> Orientation {
    let graph = &mut chain.graph;
    let gap = graph.sub_vectors(axis, tool);
    let squared = graph.dot(gap, gap);
    let deviation = graph.sqrt(squared);
    Orientation::Fixed { deviation: graph.name(deviation, "deviation") }
}

fn one(
    chain: &mut Chain<'_>,
    rotary: AxisId,
    axis: V3,
    tool: V3,
    defaults: &BTreeMap<Symbol, Poly>,
) -> Result<Orientation, Vec<Refusal>> {
    let n = chain.direction(rotary);
    let reversed = chain.model.axes[rotary].reversed;
    let graph = &mut chain.graph;
    let across = graph.cross(n, tool);
    if room(graph, across, defaults) <= PARALLEL {
        return Err(vec![Refusal::CannotTilt(rotary)]);
    }
    let square = graph.dot(across, across);
    let square = settle(graph, square);
    let level = graph.dot(n, tool);
    let outwards = graph.cross(across, n);
    let (sine, cosine) = (graph.dot(across, axis), graph.dot(outwards, axis));
    let (sine, cosine) = (graph.name(sine, "sine"), graph.name(cosine, "cosine"));
    let squares = [graph.square(sine), graph.square(cosine)];
    let sum = graph.add(squares[0], squares[1]);
    let length = graph.sqrt(sum);
    graph.name(length, "length");
    let one = graph.integer(1);
    let inverse = graph.div(one, length);
    let (s, c) = (graph.mul(sine, inverse), graph.mul(cosine, inverse));
    // Distance in the plane of the rotary and the wanted axis: along the rotary, and square to it.
    let along = graph.dot(n, axis);
    let radius = graph.sqrt(square);
    let wanted_radius = graph.div(length, radius);
    let gaps = [graph.sub(along, level), graph.sub(wanted_radius, radius)];
    let squares = gaps.map(|gap| graph.square(gap));
    let sum = graph.add(squares[0], squares[1]);
    let deviation = graph.sqrt(sum);
    graph.name(deviation, "deviation");
    let zero = graph.integer(0);
    let turned = graph.cross(n, axis);
    let squared = graph.dot(turned, turned);
    let wanted_sine = graph.sqrt(squared);
    let s = if reversed { graph.neg(s) } else { s };
    let direction = in_workpiece(chain, rotary);
    Ok(Orientation::One(One {
        rotary,
        word: (s, c),
        deviation,
        length,
        inverse,
        length_claim: square,
        tilt: Tilt { wanted: (wanted_sine, along), between: (zero, one), tool: (radius, level), direction },
    }))
}

fn two(
    chain: &mut Chain<'_>,
    rotaries: [AxisId; 2],
    m: V3,
    a: V3,
    t: V3,
    defaults: &BTreeMap<Symbol, Poly>,
) -> Result<Orientation, Vec<Refusal>> {
    let n = chain.direction(rotaries[0]);
    let reversed = rotaries.map(|id| chain.model.axes[id].reversed);
    let graph = &mut chain.graph;
    let (m_n, m_t) = (graph.cross(m, n), graph.cross(m, t));
    let (n_room, t_room) = (graph.dot(m_n, m_n), graph.dot(m_t, m_t));
    let n_room = settle(graph, n_room);
    let (between, tool) = (room(graph, m_n, defaults), room(graph, m_t, defaults));
    if between * tool <= PARALLEL {
        let same = (between <= PARALLEL || between <= tool).then_some(Refusal::SameDirection(rotaries[0], rotaries[1]));
        let still = (tool <= PARALLEL || tool < between).then_some(Refusal::CannotTilt(rotaries[1]));
        return Err(same.into_iter().chain(still).collect());
    }

    let [p, q] = [graph.dot(n, m), graph.dot(m, t)].map(|node| settle(graph, node));
    let alpha = [graph.dot(m_n, m_t), graph.dot(n, m_t)].map(|node| settle(graph, node));
    let squares = alpha.map(|component| graph.square(component));
    let capacity = graph.add(squares[0], squares[1]);
    let capacity = settle(graph, capacity);
    graph.name(capacity, "capacity");
    let pole = Pole::of(graph, p, q);

    let along = graph.dot(n, a);
    let g = graph.dot(m_n, a);
    let m_across = graph.cross(n, m_n);
    let e = graph.dot(m_across, a);
    let squares = [graph.square(g), graph.square(e)];
    let spread = graph.add(squares[0], squares[1]);
    graph.name(spread, "spread");
    let sine_squared = graph.div(spread, n_room);
    graph.name(sine_squared, "sine_squared");
    let level = graph.mul(p, q);
    let height = graph.sub(along, level);
    graph.name(height, "height");

    let one = graph.integer(1);
    let half = {
        let two = graph.integer(2);
        graph.div(one, two)
    };
    // (|n×a|² + (1 ∓ n·a)²) / 2, which is 1 ∓ n·a without the loss of digits.
    let clear_of = |graph: &mut Graph, along: Id| {
        let rest = graph.sub(one, along);
        let rest = graph.square(rest);
        let sum = graph.add(sine_squared, rest);
        graph.mul(half, sum)
    };
    let (rim, root_squared, lean) = match pole {
        Pole::Reached { square: true, .. } => (n_room, spread, graph.integer(0)),
        Pole::Reached { plus, square: false } => {
            let signed_along = if plus { along } else { graph.neg(along) };
            let near = clear_of(graph, signed_along);
            graph.name(near, "near");
            let p_squared = graph.square(p);
            let twice = graph.add(p_squared, p_squared);
            let rest = graph.sub(one, twice);
            let far = graph.add(rest, signed_along);
            graph.name(far, "far");
            let product = graph.mul(near, far);
            let lean = graph.mul(p, near);
            (n_room, product, if plus { lean } else { graph.neg(lean) })
        }
        Pole::Elsewhere => {
            let rim = graph.sqrt(capacity);
            graph.name(rim, "rim");
            let minus_along = graph.neg(along);
            let factors = [(along, graph.sub(p, q), graph.sub(one, level)), {
                (minus_along, graph.add(p, q), graph.add(one, level))
            }];
            let [near, far] = factors.map(|(along, gap, room)| {
                let clear = clear_of(graph, along);
                let gap_squared = graph.square(gap);
                let room = graph.add(room, rim);
                let lost = graph.div(gap_squared, room);
                graph.sub(clear, lost)
            });
            graph.name(near, "near");
            graph.name(far, "far");
            let product = graph.mul(near, far);
            (rim, product, lean_of(graph, p, q, n_room, height))
        }
    };
    graph.name(root_squared, "root_squared");
    let root = graph.sqrt(root_squared);
    graph.name(root, "root");
    graph.name(lean, "lean");

    let first_is_plus = first_branch(graph, alpha, reversed[1], defaults);
    let orthogonal = matches!(pole, Pole::Reached { square: true, .. });
    let signed = |graph: &mut Graph, plus: bool, node: Id| if plus { node } else { graph.neg(node) };
    let second_word = |graph: &mut Graph, height: Id, root: Id| {
        let sums = [[(0, height, true), (1, root, false)], [(1, height, true), (0, root, true)]];
        let [cosine, sine] = sums.map(|terms| {
            let products = terms.map(|(index, factor, plus)| {
                let product = graph.mul(alpha[index], factor);
                signed(graph, plus, product)
            });
            let sum = graph.add(products[0], products[1]);
            graph.div(sum, capacity)
        });
        (signed(graph, !reversed[1], sine), cosine)
    };
    let first_word = |graph: &mut Graph, lean: Id, root: Id| {
        let lean_e = graph.mul(lean, e);
        let root_g = graph.mul(root, g);
        let root_e = graph.mul(root, e);
        let lean_g = graph.mul(lean, g);
        let cosine = graph.add(lean_e, root_g);
        let sine = graph.sub(root_e, lean_g);
        (signed(graph, !reversed[0], sine), cosine)
    };
    let mut length = None;
    let inverse = if orthogonal {
        graph.div(one, root)
    } else if pole == Pole::Elsewhere {
        let squares = [graph.square(lean), graph.square(root)];
        let turned = graph.add(squares[0], squares[1]);
        let squared = graph.mul(turned, spread);
        let own = graph.sqrt(squared);
        graph.name(own, "length");
        length = Some(own);
        graph.div(one, own)
    } else {
        graph.div(one, spread)
    };
    graph.name(inverse, "inverse");
    let answers = [first_is_plus, !first_is_plus].map(|plus| {
        let signed_root = signed(graph, plus, root);
        let second = second_word(graph, height, signed_root);
        // In the orthogonal form the root cancels against the length: only its sign is left.
        let factor = if orthogonal { signed(graph, plus, one) } else { signed_root };
        let (sine, cosine) = first_word(graph, lean, factor);
        let first = (graph.mul(sine, inverse), graph.mul(cosine, inverse));
        Answer { plus, words: [first, second], angles: [Angle::Own; 2] }
    });

    let edge = {
        let symbols = (graph.symbol("edge_height"), graph.symbol("edge_root"));
        let (edge_height, edge_root) = (graph.input(symbols.0), graph.input(symbols.1));
        let signed_root = signed(graph, first_is_plus, edge_root);
        let lean = lean_of(graph, p, q, n_room, edge_height);
        let first = first_word(graph, lean, signed_root);
        let squares = [first.0, first.1].map(|part| graph.square(part));
        let first_squared = graph.add(squares[0], squares[1]);
        let squares = [lean, edge_root].map(|part| graph.square(part));
        let turned = graph.add(squares[0], squares[1]);
        let reached_squared = graph.div(turned, n_room);
        let second = second_word(graph, edge_height, signed_root);
        let reached_along = graph.add(edge_height, level);
        Edge {
            height: symbols.0,
            root: symbols.1,
            second,
            first,
            first_squared,
            reached_squared,
            along: (along, reached_along),
        }
    };
    let roots = [sine_squared, n_room, t_room].map(|square| graph.sqrt(square));
    let direction = in_workpiece(chain, rotaries[0]);
    let tilt = Tilt { wanted: (roots[0], along), between: (roots[1], p), tool: (roots[2], q), direction };
    let mut two = Two {
        rotaries,
        capacity,
        room: n_room,
        spread,
        root,
        root_squared,
        sine_squared,
        height,
        rim,
        length,
        inverse,
        answers,
        edge,
        has_pole: pole != Pole::Elsewhere,
        orthogonal,
        alpha,
        first_is_plus,
        tilt,
    };
    relate(chain, &mut two);
    Ok(Orientation::Two(Box::new(two)))
}

/// Direction of a rotary with the held rotaries in front of it turned.
fn in_workpiece(chain: &mut Chain<'_>, rotary: AxisId) -> V3 {
    let mut direction = chain.direction(rotary);
    for id in (0..rotary).rev() {
        if chain.model.axes[id].kind == Kind::Rotary {
            direction = chain.turn(id, direction);
        }
    }
    direction
}

/// Whether and where the tool can be laid parallel to the first rotary.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Pole {
    /// At `n` (plus) or `-n`; both if the rotaries are square to each other and to the tool.
    Reached { plus: bool, square: bool },
    /// Not for all values of held axes and dimensions.
    Elsewhere,
}

impl Pole {
    fn of(graph: &mut Graph, p: Id, q: Id) -> Self {
        let mut reader = Interpreter::new(graph, BTreeMap::new());
        let (p, q) = (reader.value(p), reader.value(q));
        if reader.equal(&p, &q) {
            Self::Reached { plus: true, square: p.is_zero() }
        } else if reader.equal(&p, &-&q) {
            Self::Reached { plus: false, square: false }
        } else {
            Self::Elsewhere
        }
    }
}

/// The same node, or the number it is identically equal to.
fn settle(graph: &mut Graph, node: Id) -> Id {
    let value = Interpreter::new(graph, BTreeMap::new()).value(node);
    if value.as_number().is_some() { graph.constant(value) } else { node }
}

/// `A = q (1-p²) - p w`.
fn lean_of(graph: &mut Graph, p: Id, q: Id, n_room: Id, height: Id) -> Id {
    let (q_room, p_height) = (graph.mul(q, n_room), graph.mul(p, height));
    graph.sub(q_room, p_height)
}

/// Squared length of a cross product at the defaults of dimensions and held axes; 0 if it vanishes identically.
///
/// Components are evaluated before they are squared: noise of 1e-16 becomes 1e-32, far below [`PARALLEL`].
fn room(graph: &mut Graph, cross: V3, defaults: &BTreeMap<Symbol, Poly>) -> f64 {
    let squares = cross.map(|component| at_defaults(graph, component, defaults).map_or(0.0, |value| value * value));
    squares.iter().sum()
}

/// The float value of a node at the defaults; `None` if it vanishes identically.
fn at_defaults(graph: &mut Graph, node: Id, defaults: &BTreeMap<Symbol, Poly>) -> Option<f64> {
    let value = Interpreter::new(graph, BTreeMap::new()).value(node);
    if graph.ring().is_zero(&value) {
        return None;
    }
    let value = graph.ring().substitute(&value, defaults);
    Some(graph.ring().value(&value).unwrap_or_default())
}

/// The sign `σ` that makes the written second angle's sine, or with `α1 = 0` its cosine, not negative.
fn first_branch(graph: &mut Graph, alpha: [Id; 2], reversed: bool, defaults: &BTreeMap<Symbol, Poly>) -> bool {
    let [first, second] = alpha.map(|node| at_defaults(graph, node, defaults));
    match first {
        None => second.unwrap_or_default() < 0.0,
        Some(first) => (first >= 0.0) != reversed,
    }
}

/// Finds angles of the second branch that follow from the first without an `atan2`.
///
/// One numeric point refutes most relations at once; what it does not refute is decided exactly.
fn relate(chain: &mut Chain<'_>, two: &mut Two) {
    let sample = chain.model.sample();
    let of = |symbol: Symbol| sample.get(&symbol).copied();
    for rotary in 0..2 {
        let mut relation = |part: fn((Id, Id)) -> Id| {
            let [first, other] = [0, 1].map(|branch: usize| part(two.answers[branch].words[rotary]));
            let [a, b] = [first, other].map(|node| chain.graph.evaluate(node, &of));
            let differs = |a: f64, b: f64| (a - b).abs() > 1e-6;
            let (same, opposite) = (!differs(a, b), !differs(a, -b));
            let mut reader = Interpreter::new(&mut chain.graph, BTreeMap::new());
            if same && {
                let (a, b) = (reader.value(first), reader.value(other));
                reader.equal(&a, &b)
            } {
                Some(true)
            } else if opposite && {
                let (a, b) = (reader.value(first), reader.value(other));
                reader.equal(&a, &-&b)
            } {
                Some(false)
            } else {
                None
            }
        };
        two.answers[1].angles[rotary] = match (relation(|word| word.0), relation(|word| word.1)) {
            (Some(true), Some(true)) => Angle::Same,
            (Some(false), Some(true)) => Angle::Negated,
            (Some(false), Some(false)) => Angle::HalfTurn,
            (Some(true), Some(false)) => Angle::Mirrored,
            _ => Angle::Own,
        };
    }
}
