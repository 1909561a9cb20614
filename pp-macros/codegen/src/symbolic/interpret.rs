//! Reads graph nodes back as polynomials, so that the formulas that are proven are the ones that run.

use std::collections::BTreeMap;

use super::graph::{Graph, Id, Node};
use super::poly::{Poly, Symbol};
use super::ring::Ring;

/// Interprets nodes of one graph under an assignment of polynomials to inputs.
///
/// `√a` becomes a generator `r` with `r² = a` (unless its value was [claimed](Self::claim)), `1/b` a generator `v` with
/// `v·b = 1`; both live in the graph's ring.
#[derive(Debug)]
pub struct Interpreter<'a> {
    graph: &'a mut Graph,
    inputs: BTreeMap<Symbol, Poly>,
    values: BTreeMap<Id, Poly>,
    reciprocals: Vec<(Poly, Poly)>,
    /// True after a division by an identically vanishing divisor: from then on nothing counts as equal.
    void: bool,
}

impl<'a> Interpreter<'a> {
    /// With the given polynomials for some inputs; the others stay symbols.
    pub fn new(graph: &'a mut Graph, inputs: BTreeMap<Symbol, Poly>) -> Self {
        Self { graph, inputs, values: BTreeMap::new(), reciprocals: Vec::new(), void: false }
    }

    /// Takes `value` for a `√` node, if the squares agree exactly; the caller guarantees `value >= 0`.
    #[must_use]
    pub fn claim(&mut self, root: Id, value: &Poly) -> bool {
        let Node::Sqrt(radicand) = *self.graph.node(root) else { return false };
        let square = self.graph.ring().mul(value, value);
        let radicand = self.value(radicand);
        let holds = self.equal(&square, &radicand);
        if holds {
            self.values.insert(root, value.clone());
        }
        holds
    }

    /// Takes `value` for a node; the caller guarantees that it is right.
    pub fn assume(&mut self, node: Id, value: Poly) {
        self.values.insert(node, value);
    }

    /// Takes a generator with the square `square` for a `√` node; the caller guarantees the square.
    pub fn assume_square(&mut self, root: Id, square: Poly) -> Symbol {
        let symbol = self.graph.root("r", square);
        self.values.insert(root, Poly::from(symbol));
        symbol
    }

    /// The node as a polynomial in normal form.
    pub fn value(&mut self, id: Id) -> Poly {
        for id in self.graph.reachable(&[id]) {
            if self.values.contains_key(&id) {
                continue;
            }
            let node = self.graph.node(id).clone();
            let value = match node {
                Node::Constant(poly) => poly,
                Node::Input(symbol) => self.inputs.get(&symbol).cloned().unwrap_or_else(|| Poly::from(symbol)),
                Node::Neg(a) => -&self.values[&a],
                Node::Add(a, b) => &self.values[&a] + &self.values[&b],
                Node::Sub(a, b) => &self.values[&a] - &self.values[&b],
                Node::Mul(a, b) => self.graph.ring().mul(&self.values[&a], &self.values[&b]),
                Node::Div(a, b) => {
                    let divisor = self.values[&b].clone();
                    let reciprocal = self.reciprocal(divisor);
                    self.graph.ring().mul(&self.values[&a], &reciprocal)
                }
                Node::Sqrt(a) => {
                    let radicand = self.values[&a].clone();
                    Poly::from(self.graph.root("r", radicand))
                }
            };
            self.values.insert(id, value);
        }
        self.values[&id].clone()
    }

    /// True only if two polynomials are proven to be equal wherever no divisor is zero.
    #[must_use]
    pub fn equal(&self, a: &Poly, b: &Poly) -> bool {
        !self.void && self.graph.ring().is_zero(&(a - b))
    }

    /// The graph that is read.
    #[must_use]
    pub fn graph(&self) -> &Graph {
        self.graph
    }

    /// The ring of the graph.
    #[must_use]
    pub fn ring(&self) -> &Ring {
        self.graph.ring()
    }

    fn reciprocal(&mut self, divisor: Poly) -> Poly {
        if let Some(inverse) = divisor.as_number().and_then(|number| number.inverse()) {
            return Poly::from(inverse);
        }
        if let Some((_, known)) = self.reciprocals.iter().find(|(d, _)| *d == divisor) {
            return known.clone();
        }
        self.void |= self.graph.ring().is_zero(&divisor);
        let symbol = Poly::from(self.graph.reciprocal("v", divisor.clone()));
        self.reciprocals.push((divisor, symbol.clone()));
        symbol
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_is_proven_by_dividing_by_zero() {
        let mut graph = Graph::default();
        let (s, c) = graph.sin_cos("s", "c");
        let (one, s, c) = (graph.integer(1), graph.input(s), graph.input(c));
        let squares = [graph.square(s), graph.square(c)];
        let sum = graph.add(squares[0], squares[1]);
        let nothing = graph.sub(sum, one);
        let quotient = graph.div(one, nothing);
        let mut reader = Interpreter::new(&mut graph, BTreeMap::new());
        let value = reader.value(quotient);
        assert!(!reader.equal(&value, &value));
    }

    #[test]
    fn a_claimed_root_must_square_to_its_radicand() {
        let mut graph = Graph::default();
        let (x, y) = (graph.symbol("x"), graph.symbol("y"));
        let (a, b) = (graph.input(x), graph.input(y));
        let sum = graph.add(a, b);
        let square = graph.square(sum);
        let root = graph.sqrt(square);
        let mut reader = Interpreter::new(&mut graph, BTreeMap::new());
        let right = &Poly::from(x) + &Poly::from(y);
        assert!(!reader.claim(root, &(&Poly::from(x) - &Poly::from(y))));
        assert!(reader.claim(root, &right));
        assert_eq!(reader.value(root), right);
    }
}
