//! The expression graph that is printed as Rust: hash-consed, folded while it is built.
//!
//! A node is made once: the same operation on the same operands gives the same [`Id`]. This alone shares common
//! subexpressions. Folding is exact for real numbers; in floating point it only leaves out roundings: constants, zeros
//! and ones, double negation, `a - a`. Signs move outwards (`(-a)·b = -(a·b)`), so that the two solution branches share
//! subexpressions that differ only in sign.

use std::collections::BTreeMap;

use super::poly::{Poly, Symbol};
use super::ring::Ring;

/// Handle of a node; smaller handles never depend on larger ones.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Id(u32);

/// Three nodes.
pub type NodeVector = [Id; 3];

/// One operation.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub enum Node {
    /// A number known at expansion: a polynomial in constants only.
    Constant(Poly),
    /// A value supplied by the surrounding code.
    Input(Symbol),
    /// `-a`
    Neg(Id),
    /// `a + b`
    Add(Id, Id),
    /// `a - b`
    Sub(Id, Id),
    /// `a * b`
    Mul(Id, Id),
    /// `a / b`
    Div(Id, Id),
    /// `√a`
    Sqrt(Id),
}

/// Arena of nodes, with the ring whose symbols they use.
#[derive(Debug, Clone, Default)]
pub struct Graph {
    /// Symbols and their relations. It only grows: a polynomial that was read keeps its meaning.
    ring: Ring,
    nodes: Vec<Node>,
    index: BTreeMap<Node, Id>,
    names: BTreeMap<Id, String>,
}

impl Graph {
    /// An empty graph over the symbols of a ring.
    #[must_use]
    pub fn new(ring: Ring) -> Self {
        Self { ring, ..Self::default() }
    }

    /// Symbols of the nodes, and their relations.
    #[must_use]
    pub fn ring(&self) -> &Ring {
        &self.ring
    }

    /// A new free symbol; see [`Ring::symbol`].
    pub fn symbol(&mut self, name: impl Into<String>) -> Symbol {
        self.ring.symbol(name)
    }

    /// Sine and cosine of a new angle; see [`Ring::sin_cos`].
    pub fn sin_cos(&mut self, sine: impl Into<String>, cosine: impl Into<String>) -> (Symbol, Symbol) {
        self.ring.sin_cos(sine, cosine)
    }

    /// A root, whose square is `radicand`; see [`Ring::root`].
    pub fn root(&mut self, name: impl Into<String>, radicand: Poly) -> Symbol {
        self.ring.root(name, radicand)
    }

    /// A reciprocal: times `divisor` it is 1; see [`Ring::reciprocal`].
    pub fn reciprocal(&mut self, name: impl Into<String>, divisor: Poly) -> Symbol {
        self.ring.reciprocal(name, divisor)
    }

    /// The operation of a handle.
    #[must_use]
    pub fn node(&self, id: Id) -> &Node {
        &self.nodes[id.0 as usize]
    }

    /// Names a node in generated code; the first name is kept. Constants and inputs keep their own.
    pub fn name(&mut self, id: Id, name: impl Into<String>) -> Id {
        if !matches!(self.node(id), Node::Constant(_) | Node::Input(_)) {
            self.names.entry(id).or_insert_with(|| name.into());
        }
        id
    }

    /// The name of a node.
    #[must_use]
    pub fn name_of(&self, id: Id) -> Option<&str> {
        self.names.get(&id).map(String::as_str)
    }

    /// The polynomial of a constant node.
    #[must_use]
    pub fn constant_of(&self, id: Id) -> Option<&Poly> {
        match self.node(id) {
            Node::Constant(poly) => Some(poly),
            _ => None,
        }
    }

    /// True for the constant 0.
    #[must_use]
    pub fn is_zero(&self, id: Id) -> bool {
        self.constant_of(id).is_some_and(Poly::is_zero)
    }

    /// A number.
    pub fn constant(&mut self, value: Poly) -> Id {
        self.intern(Node::Constant(value))
    }

    /// A whole number.
    pub fn integer(&mut self, value: i64) -> Id {
        self.constant(Poly::from(value))
    }

    /// A value supplied by the surrounding code.
    pub fn input(&mut self, symbol: Symbol) -> Id {
        self.intern(Node::Input(symbol))
    }

    /// A polynomial of declared quantities (dimensions, fixed angles) as written; not for normal forms of solutions.
    pub fn declared(&mut self, poly: &Poly) -> Id {
        if self.ring.value(poly).is_some() {
            return self.constant(poly.clone());
        }
        let mut sum = self.integer(0);
        for (monomial, factor) in &poly.terms {
            let mut product = self.constant(Poly::from(factor.clone()));
            for &(symbol, power) in monomial {
                let known = Poly::from(symbol);
                let base = if self.ring.value(&known).is_some() { self.constant(known) } else { self.input(symbol) };
                for _ in 0..power {
                    product = self.mul(product, base);
                }
            }
            sum = self.add(sum, product);
        }
        sum
    }

    /// `-a`
    pub fn neg(&mut self, a: Id) -> Id {
        match self.node(a) {
            Node::Constant(value) => {
                let value = -value;
                self.constant(value)
            }
            Node::Neg(inner) => *inner,
            Node::Sub(b, c) => {
                let (b, c) = (*b, *c);
                self.sub(c, b)
            }
            _ => self.intern(Node::Neg(a)),
        }
    }

    /// `a + b`
    pub fn add(&mut self, a: Id, b: Id) -> Id {
        match (self.node(a), self.node(b)) {
            (Node::Constant(p), Node::Constant(q)) => {
                let sum = p + q;
                self.constant(sum)
            }
            (Node::Constant(p), _) if p.is_zero() => b,
            (_, Node::Constant(q)) if q.is_zero() => a,
            (Node::Neg(p), Node::Neg(q)) => {
                let (p, q) = (*p, *q);
                let sum = self.add(p, q);
                self.neg(sum)
            }
            (_, Node::Neg(q)) => {
                let q = *q;
                self.sub(a, q)
            }
            (Node::Neg(p), _) => {
                let p = *p;
                self.sub(b, p)
            }
            _ => match (self.is_negative(a), self.is_negative(b)) {
                (false, true) => {
                    let b = self.neg(b);
                    self.sub(a, b)
                }
                (true, false) => {
                    let a = self.neg(a);
                    self.sub(b, a)
                }
                _ => self.intern(Node::Add(a.min(b), a.max(b))),
            },
        }
    }

    /// `a - b`
    pub fn sub(&mut self, a: Id, b: Id) -> Id {
        if a == b {
            return self.integer(0);
        }
        match (self.node(a), self.node(b)) {
            (Node::Constant(p), Node::Constant(q)) => {
                let difference = p - q;
                self.constant(difference)
            }
            (_, Node::Constant(q)) if q.is_zero() => a,
            (Node::Constant(p), _) if p.is_zero() => self.neg(b),
            (_, Node::Neg(q)) => {
                let q = *q;
                self.add(a, q)
            }
            (Node::Neg(p), _) => {
                let p = *p;
                let sum = self.add(p, b);
                self.neg(sum)
            }
            _ if self.is_negative(b) => {
                let b = self.neg(b);
                self.add(a, b)
            }
            _ => self.intern(Node::Sub(a, b)),
        }
    }

    /// `a · b`
    pub fn mul(&mut self, a: Id, b: Id) -> Id {
        let (a, b) = (a.min(b), a.max(b));
        match (self.node(a), self.node(b)) {
            (Node::Constant(p), Node::Constant(q)) => {
                let product = self.ring.mul(p, q);
                self.constant(product)
            }
            (Node::Neg(p), _) => {
                let p = *p;
                let product = self.mul(p, b);
                self.neg(product)
            }
            (_, Node::Neg(q)) => {
                let q = *q;
                let product = self.mul(a, q);
                self.neg(product)
            }
            (Node::Constant(p), _) => {
                let p = p.clone();
                self.scale(&p, b)
            }
            (_, Node::Constant(q)) => {
                let q = q.clone();
                self.scale(&q, a)
            }
            _ => self.intern(Node::Mul(a, b)),
        }
    }

    /// `a / b`
    pub fn div(&mut self, a: Id, b: Id) -> Id {
        if let Some(divisor) = self.constant_of(b).filter(|divisor| !divisor.is_zero()).cloned() {
            let inverse = match divisor.as_number().and_then(|number| number.inverse()) {
                Some(inverse) => Poly::from(inverse),
                None => Poly::from(self.ring.reciprocal("reciprocal", divisor)),
            };
            let inverse = self.constant(inverse);
            return self.mul(a, inverse);
        }
        if self.is_zero(a) && !self.is_zero(b) {
            return a;
        }
        match (self.node(a), self.node(b)) {
            (Node::Neg(p), _) => {
                let p = *p;
                let quotient = self.div(p, b);
                self.neg(quotient)
            }
            (_, Node::Neg(q)) => {
                let q = *q;
                let quotient = self.div(a, q);
                self.neg(quotient)
            }
            _ => self.intern(Node::Div(a, b)),
        }
    }

    /// `√a`
    pub fn sqrt(&mut self, a: Id) -> Id {
        let Some(radicand) = self.constant_of(a).filter(|_| !self.is_negative(a)).cloned() else {
            return self.intern(Node::Sqrt(a));
        };
        let root = match radicand.as_number().and_then(|number| number.sqrt()) {
            Some(root) => Poly::from(root),
            None => Poly::from(self.ring.root("root", radicand)),
        };
        self.constant(root)
    }

    /// `a · a`
    pub fn square(&mut self, a: Id) -> Id {
        self.mul(a, a)
    }

    /// Float value of a node for given inputs; NaN where an input is missing.
    pub fn evaluate(&self, id: Id, of: &dyn Fn(Symbol) -> Option<f64>) -> f64 {
        let mut values: BTreeMap<Id, f64> = BTreeMap::new();
        for id in self.reachable(&[id]) {
            let value = match *self.node(id) {
                Node::Constant(ref poly) => self.ring.value(poly).unwrap_or(f64::NAN),
                Node::Input(symbol) => of(symbol).unwrap_or(f64::NAN),
                Node::Neg(a) => -values[&a],
                Node::Add(a, b) => values[&a] + values[&b],
                Node::Sub(a, b) => values[&a] - values[&b],
                Node::Mul(a, b) => values[&a] * values[&b],
                Node::Div(a, b) => values[&a] / values[&b],
                Node::Sqrt(a) => values[&a].sqrt(),
            };
            values.insert(id, value);
        }
        values[&id]
    }

    /// Operands of a node.
    pub fn operands(&self, id: Id) -> impl Iterator<Item = Id> + use<> {
        let (first, second) = match *self.node(id) {
            Node::Constant(_) | Node::Input(_) => (None, None),
            Node::Neg(a) | Node::Sqrt(a) => (Some(a), None),
            Node::Add(a, b) | Node::Sub(a, b) | Node::Mul(a, b) | Node::Div(a, b) => (Some(a), Some(b)),
        };
        first.into_iter().chain(second)
    }

    /// Everything that `outputs` depend on, operands first.
    #[must_use]
    pub fn reachable(&self, outputs: &[Id]) -> Vec<Id> {
        let mut seen = std::collections::BTreeSet::new();
        let mut pending = outputs.to_vec();
        while let Some(id) = pending.pop() {
            if seen.insert(id) {
                pending.extend(self.operands(id));
            }
        }
        seen.into_iter().collect()
    }

    fn is_negative(&self, id: Id) -> bool {
        self.constant_of(id).and_then(|poly| self.ring.value(poly)).is_some_and(|value| value < 0.0)
    }

    fn scale(&mut self, factor: &Poly, a: Id) -> Id {
        if factor.is_zero() {
            return self.integer(0);
        }
        if factor.is_one() {
            return a;
        }
        if self.ring.value(factor).is_some_and(|value| value < 0.0) {
            let product = self.scale(&-factor, a);
            return self.neg(product);
        }
        if let Node::Mul(inner, rest) = *self.node(a)
            && let Some(other) = self.constant_of(inner)
        {
            let product = self.ring.mul(factor, other);
            return self.scale(&product, rest);
        }
        let factor = self.constant(factor.clone());
        self.intern(Node::Mul(factor, a))
    }

    #[expect(clippy::expect_used, reason = "memory ends before 2^32 nodes")]
    fn intern(&mut self, node: Node) -> Id {
        if let Some(id) = self.index.get(&node) {
            return *id;
        }
        let id = Id(u32::try_from(self.nodes.len()).expect("fewer than 2^32 nodes"));
        self.nodes.push(node.clone());
        self.index.insert(node, id);
        id
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn signs_move_outwards_so_that_branches_share() {
        let mut graph = Graph::default();
        let (x, y) = (graph.symbol("x"), graph.symbol("y"));
        let (x, y) = (graph.input(x), graph.input(y));
        let product = graph.mul(x, y);
        let minus_x = graph.neg(x);
        let mirrored = graph.mul(minus_x, y);
        assert_eq!(mirrored, graph.neg(product));
        let sum = graph.add(product, mirrored);
        assert!(graph.is_zero(sum));
    }
}
