//! Rotary angles in closed form: `atan2` of two polynomials in the tool axis and one root.
//!
//! Formulas are read from the nodes of the code as polynomials and factored. They are the same functions, but not the
//! same operations: the well-conditioned form near the pole is in the code only.

use std::collections::BTreeMap;

use super::expression::Formula;
use super::factor::common_number;
use crate::model::{AxisId, Model};
use crate::solve::{OneRotary, Orientation, Solved, TwoRotaries};
use crate::symbolic::{Graph, Id, Interpreter, Node, Poly, SineCosine, Surd, Symbol};

/// Polynomials with more terms than this are shown step by step, as they are computed.
const LONGEST: usize = 60;

/// Roots whose radicand has at most this [size](Formula::size) are written in place.
const SHORT: usize = 2;

/// Both angles of both branches, with one named root.
#[derive(Clone)]
pub(crate) struct ClosedForm {
    /// Name of the root.
    root: Formula,
    /// `sqrt(...)`
    value: Formula,
    branches: [[Formula; 2]; 2],
}

impl ClosedForm {
    /// Angles of a machine with two solved rotary axes; `None` if they are too long for one line.
    pub(crate) fn of_two(model: &Model, solved: &Solved, two: &TwoRotaries) -> Option<Self> {
        let mut graph = solved.graph.clone();
        // r² = D - w², however the code computes it.
        let square = {
            let mut reader = Interpreter::new(&mut graph, BTreeMap::new());
            let (capacity, height) = (reader.value(two.second.capacity), reader.value(two.second.height));
            let square = reader.ring().mul(&height, &height);
            &capacity - &square
        };
        let mut root = None;
        let mut angle = |word: SineCosine, common: Id| {
            let word = without_factor(&graph, word, common);
            let mut reader = Interpreter::new(&mut graph, BTreeMap::new());
            let symbol = reader.assume_square(two.second.root, square.clone());
            let arguments = arguments(&mut reader, word, Some(symbol))?;
            root.get_or_insert_with(|| Formula::of_poly(model, reader.ring(), &Poly::from(symbol)));
            Some(atan2(model, &graph, &arguments))
        };
        let [first, second] = two.branches.map(|answer| {
            Some([angle(answer.words[0], two.first.inverse)?, angle(answer.words[1], two.second.capacity)?])
        });
        let branches = [first?, second?];
        let radicand = Formula::of_poly(model, graph.ring(), &square);
        Some(Self { root: root?, value: Formula::call("sqrt", [radicand]), branches })
    }

    /// `r` and `sqrt(...)`, if the angles are written with the name: a short root is written in place.
    pub(crate) fn named_root(&self) -> Option<(Formula, Formula)> {
        let named = !self.is_short() && self.branches.iter().flatten().any(|angle| angle.mentions(&self.root));
        named.then(|| (self.root.clone(), self.value.clone()))
    }

    /// Angles of both branches, a short root written in place.
    pub(crate) fn branches(self) -> [[Formula; 2]; 2] {
        let short = self.is_short();
        let Self { root, value, branches } = self;
        branches.map(|branch| branch.map(|angle| if short { angle.with(&root, &value) } else { angle }))
    }

    /// Angles of both branches, the root written in place.
    pub(crate) fn roots_in_place(self) -> [[Formula; 2]; 2] {
        let Self { root, value, branches } = self;
        branches.map(|branch| branch.map(|angle| angle.with(&root, &value)))
    }

    fn is_short(&self) -> bool {
        self.value.size() <= SHORT
    }
}

/// Angle of the only solved rotary axis; `None` if it is too long for one line.
pub(crate) fn angle_of_one(model: &Model, solved: &Solved, one: &OneRotary) -> Option<Formula> {
    let mut graph = solved.graph.clone();
    let word = without_factor(&graph, one.word, one.inverse);
    let arguments = arguments(&mut Interpreter::new(&mut graph, BTreeMap::new()), word, None)?;
    Some(atan2(model, &graph, &arguments))
}

/// `T = atan2(...)` of the first branch for each solved rotary axis, where that is no longer than a line.
pub(crate) fn first_branch(model: &Model, solved: &Solved) -> Vec<(AxisId, Formula)> {
    match &solved.orientation {
        Orientation::Fixed { .. } => Vec::new(),
        Orientation::One(one) => {
            angle_of_one(model, solved, one).map(|angle| (one.rotary, angle)).into_iter().collect()
        }
        Orientation::Two(two) => match ClosedForm::of_two(model, solved, two) {
            Some(closed) => {
                let [first, _] = closed.roots_in_place();
                two.rotaries.into_iter().zip(first).collect()
            }
            None => Vec::new(),
        },
    }
}

/// True if a polynomial fits in a line and has no divisors but numbers.
pub(crate) fn is_readable(graph: &Graph, poly: &Poly) -> bool {
    let ring = graph.ring();
    let unknown = |symbol: Symbol| ring.value(&Poly::from(symbol)).is_none();
    let is_divided = poly.symbols().any(|symbol| ring.divisor(symbol).is_some() && unknown(symbol));
    !is_divided && poly.coefficients().count() <= LONGEST
}

/// True for minus, and a node without its sign and without a positive factor or divisor.
type Signed = (bool, Id);

/// Sine and cosine without their common factor or divisor.
fn without_factor(graph: &Graph, SineCosine { sine, cosine }: SineCosine, common: Id) -> [Signed; 2] {
    let without = |id: Id| {
        let (minus, inner) = match *graph.node(id) {
            Node::Neg(inner) => (true, inner),
            _ => (false, id),
        };
        match *graph.node(inner) {
            Node::Mul(a, b) if b == common => Some((minus, a)),
            Node::Mul(a, b) if a == common => Some((minus, b)),
            Node::Div(a, b) if b == common => Some((minus, a)),
            _ if graph.is_zero(inner) => Some((minus, inner)),
            _ => None,
        }
    };
    match (without(sine), without(cosine)) {
        (Some(sine), Some(cosine)) => [sine, cosine],
        _ => [(false, sine), (false, cosine)],
    }
}

/// Arguments of an `atan2`, without a common number; `None` if they are too long.
fn arguments(reader: &mut Interpreter<'_>, word: [Signed; 2], root: Option<Symbol>) -> Option<[Poly; 2]> {
    let parts = word.map(|(minus, node)| {
        let value = reader.value(node);
        if minus { -&value } else { value }
    });
    if !parts.iter().all(|part| is_readable(reader.graph(), part)) {
        return None;
    }
    // The common number is that of the terms without the root, if there are any.
    let rooted = |powers: &[(Symbol, u32)]| powers.iter().any(|(symbol, _)| Some(*symbol) == root);
    let terms: Vec<_> = parts.iter().flat_map(Poly::terms).collect();
    let all: Vec<&Surd> = terms.iter().map(|(_, factor)| *factor).collect();
    let plain: Vec<&Surd> = terms.iter().filter(|(powers, _)| !rooted(powers)).map(|(_, factor)| *factor).collect();
    let number = common_number(if plain.is_empty() { &all } else { &plain });
    let inverse = number.inverse().unwrap_or_else(Surd::one);
    Some(parts.map(|part| part.scaled(&inverse)))
}

fn atan2(model: &Model, graph: &Graph, [sine, cosine]: &[Poly; 2]) -> Formula {
    Formula::call("atan2", [sine, cosine].map(|part| Formula::of_poly(model, graph.ring(), part)))
}
