//! Formulas with operators: `(g * g + e * e).named("spread")`.
//!
//! A [`Term`] is a node of a graph under construction. Each operator makes its node when it is evaluated, and Rust
//! evaluates operands from left to right: the text of a formula fixes the order of its nodes, hence the order of
//! operands and statements in generated code.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::ops::{Add, Div, Mul, Neg, Sub};

use super::graph::{Graph, Id, NodeVector};
use super::interpret::Interpreter;
use super::matrix::PolyVector;
use super::poly::{Poly, Symbol};
use super::ring::Ring;

/// A graph under construction.
#[derive(Debug)]
pub struct GraphBuilder {
    graph: RefCell<Graph>,
}

impl GraphBuilder {
    /// An empty graph over the symbols of a ring.
    #[must_use]
    pub fn new(ring: Ring) -> Self {
        Self { graph: RefCell::new(Graph::new(ring)) }
    }

    /// The graph with all terms made so far.
    #[must_use]
    pub fn finish(self) -> Graph {
        self.graph.into_inner()
    }

    /// Reads or changes the graph itself.
    pub fn with<T>(&self, action: impl FnOnce(&mut Graph) -> T) -> T {
        action(&mut self.graph.borrow_mut())
    }

    /// A new free symbol.
    pub fn symbol(&self, name: impl Into<String>) -> Symbol {
        self.with(|graph| graph.symbol(name))
    }

    /// A node as a term.
    #[must_use]
    pub fn term(&self, id: Id) -> Term<'_> {
        Term { builder: self, id }
    }

    /// A whole number.
    #[must_use]
    pub fn integer(&self, value: i64) -> Term<'_> {
        self.make(|graph| graph.integer(value))
    }

    /// A value supplied by the surrounding code.
    #[must_use]
    pub fn input(&self, symbol: Symbol) -> Term<'_> {
        self.make(|graph| graph.input(symbol))
    }

    /// A vector supplied by the surrounding code.
    #[must_use]
    pub fn inputs(&self, symbols: [Symbol; 3]) -> TermVector<'_> {
        TermVector(symbols.map(|symbol| self.input(symbol)))
    }

    /// A vector of declared quantities, as written; see [`Graph::declared`].
    #[must_use]
    pub fn declared(&self, vector: &PolyVector) -> TermVector<'_> {
        TermVector(vector.each_ref().map(|component| self.make(|graph| graph.declared(component))))
    }

    /// The vector (0, 0, 0).
    #[must_use]
    pub fn zero_vector(&self) -> TermVector<'_> {
        TermVector([self.integer(0); 3])
    }

    fn make(&self, node: impl FnOnce(&mut Graph) -> Id) -> Term<'_> {
        self.term(self.with(node))
    }
}

/// A node of a graph under construction, for use with operators.
#[derive(Debug, Clone, Copy)]
pub struct Term<'g> {
    builder: &'g GraphBuilder,
    id: Id,
}

impl Term<'_> {
    /// The node.
    #[must_use]
    pub fn id(self) -> Id {
        self.id
    }

    /// The same term with a name in generated code; see [`Graph::name`].
    #[expect(clippy::return_self_not_must_use, reason = "the name stays with the node")]
    pub fn named(self, name: impl Into<String>) -> Self {
        self.builder.with(|graph| graph.name(self.id, name));
        self
    }

    /// `√a`
    #[must_use]
    pub fn sqrt(self) -> Self {
        self.builder.make(|graph| graph.sqrt(self.id))
    }

    /// `a²`
    #[must_use]
    pub fn square(self) -> Self {
        self * self
    }

    /// `a`, or `-a` if `plus` is false.
    #[must_use]
    pub fn signed(self, plus: bool) -> Self {
        if plus { self } else { -self }
    }

    /// True for the constant 0.
    #[must_use]
    pub fn is_zero(self) -> bool {
        self.builder.with(|graph| graph.is_zero(self.id))
    }

    /// True for any constant.
    #[must_use]
    pub fn is_constant(self) -> bool {
        self.builder.with(|graph| graph.constant_of(self.id).is_some())
    }

    /// Reads the graph back as polynomials; see [`Interpreter`].
    pub fn read<T>(self, action: impl FnOnce(&mut Interpreter<'_>, Id) -> T) -> T {
        self.builder.with(|graph| action(&mut Interpreter::new(graph, BTreeMap::new()), self.id))
    }

    /// The same term, or the number that it is proven to be equal to everywhere.
    #[must_use]
    pub fn settled(self) -> Self {
        let value = self.read(|reader, node| reader.value(node));
        if value.as_number().is_some() { self.builder.make(|graph| graph.constant(value)) } else { self }
    }

    /// Float value at the defaults of dimensions and held axes; `None` if the term vanishes identically.
    #[must_use]
    pub fn at(self, defaults: &BTreeMap<Symbol, Poly>) -> Option<f64> {
        self.read(|reader, node| {
            let value = reader.value(node);
            let ring = reader.ring();
            (!ring.is_zero(&value)).then(|| ring.value(&ring.substitute(&value, defaults)).unwrap_or_default())
        })
    }
}

impl<'g> Add for Term<'g> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        self.builder.make(|graph| graph.add(self.id, other.id))
    }
}

impl<'g> Sub for Term<'g> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self.builder.make(|graph| graph.sub(self.id, other.id))
    }
}

impl<'g> Mul for Term<'g> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        self.builder.make(|graph| graph.mul(self.id, other.id))
    }
}

impl<'g> Div for Term<'g> {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        self.builder.make(|graph| graph.div(self.id, other.id))
    }
}

impl<'g> Neg for Term<'g> {
    type Output = Self;
    fn neg(self) -> Self {
        self.builder.make(|graph| graph.neg(self.id))
    }
}

impl<'g> Add<Term<'g>> for i64 {
    type Output = Term<'g>;
    fn add(self, other: Term<'g>) -> Term<'g> {
        other.builder.integer(self) + other
    }
}

impl<'g> Sub<Term<'g>> for i64 {
    type Output = Term<'g>;
    fn sub(self, other: Term<'g>) -> Term<'g> {
        other.builder.integer(self) - other
    }
}

impl<'g> Mul<Term<'g>> for i64 {
    type Output = Term<'g>;
    fn mul(self, other: Term<'g>) -> Term<'g> {
        other.builder.integer(self) * other
    }
}

impl<'g> Div<Term<'g>> for i64 {
    type Output = Term<'g>;
    fn div(self, other: Term<'g>) -> Term<'g> {
        other.builder.integer(self) / other
    }
}

impl<'g> Div<i64> for Term<'g> {
    type Output = Self;
    fn div(self, other: i64) -> Self {
        self / self.builder.integer(other)
    }
}

/// Three terms: a vector, for use with operators.
#[derive(Debug, Clone, Copy)]
pub struct TermVector<'g>([Term<'g>; 3]);

impl<'g> TermVector<'g> {
    /// The nodes.
    #[must_use]
    pub fn ids(self) -> NodeVector {
        self.0.map(Term::id)
    }

    /// The components.
    #[must_use]
    pub fn components(self) -> [Term<'g>; 3] {
        self.0
    }

    /// A vector of these components.
    #[must_use]
    pub fn from_fn(component: impl FnMut(usize) -> Term<'g>) -> Self {
        Self(std::array::from_fn(component))
    }

    /// `a · b`
    #[must_use]
    pub fn dot(self, other: Self) -> Term<'g> {
        let [x, y, z] = std::array::from_fn(|index| self.0[index] * other.0[index]);
        x + y + z
    }

    /// `a × b`
    #[must_use]
    pub fn cross(self, other: Self) -> Self {
        Self::from_fn(|index| {
            let (next, last) = ((index + 1) % 3, (index + 2) % 3);
            self.0[next] * other.0[last] - self.0[last] * other.0[next]
        })
    }

    /// `√(a · a)`
    #[must_use]
    pub fn norm(self) -> Term<'g> {
        self.dot(self).sqrt()
    }

    /// Squared length at the defaults of dimensions and held axes; 0 if it vanishes identically.
    ///
    /// Components are evaluated before they are squared: noise of 1e-16 becomes 1e-32.
    #[must_use]
    pub fn squared_at(self, defaults: &BTreeMap<Symbol, Poly>) -> f64 {
        self.0.map(|component| component.at(defaults).map_or(0.0, |value| value * value)).iter().sum()
    }

    /// `Rot(n, t) · v` with the sine and cosine of `t`; entries as in [`rotation`](super::rotation), so that rotating
    /// about a coordinate axis leaves that coordinate untouched.
    #[must_use]
    pub fn rotated(self, n: Self, sine: Term<'g>, cosine: Term<'g>) -> Self {
        let (builder, n) = (sine.builder, n.0);
        Self::from_fn(|row| {
            let mut sum = builder.integer(0);
            for (column, component) in self.0.into_iter().enumerate() {
                let along = n[row] * n[column];
                let mut entry = along + (i64::from(row == column) - along) * cosine;
                if row != column {
                    let term = n[3 - row - column] * sine;
                    entry = if (row + 1) % 3 == column { entry - term } else { entry + term };
                }
                sum = sum + entry * component;
            }
            sum
        })
    }
}

/// Sine and cosine of an angle, or both times a common factor.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SineCosine {
    /// The sine.
    pub sine: Id,
    /// The cosine.
    pub cosine: Id,
}

impl SineCosine {
    pub(crate) fn of(sine: Term<'_>, cosine: Term<'_>) -> Self {
        Self { sine: sine.id(), cosine: cosine.id() }
    }

    /// Both nodes, the sine first.
    #[must_use]
    pub fn nodes(self) -> [Id; 2] {
        [self.sine, self.cosine]
    }
}

impl Add for TermVector<'_> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::from_fn(|index| self.0[index] + other.0[index])
    }
}

impl Sub for TermVector<'_> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self::from_fn(|index| self.0[index] - other.0[index])
    }
}

impl Neg for TermVector<'_> {
    type Output = Self;
    fn neg(self) -> Self {
        Self(self.0.map(Neg::neg))
    }
}

impl<'g> Mul<TermVector<'g>> for Term<'g> {
    type Output = TermVector<'g>;
    fn mul(self, vector: TermVector<'g>) -> TermVector<'g> {
        TermVector(vector.0.map(|component| self * component))
    }
}

impl<'g> Div<Term<'g>> for TermVector<'g> {
    type Output = Self;
    fn div(self, divisor: Term<'g>) -> Self {
        Self(self.0.map(|component| component / divisor))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rotation_about_z_leaves_z_alone() {
        let graph = GraphBuilder::new(Ring::default());
        let (s, c) = graph.with(|graph| graph.sin_cos("s", "c"));
        let v = graph.inputs(["x", "y", "z"].map(|name| graph.symbol(name)));
        let n = TermVector([0, 0, 1].map(|value| graph.integer(value)));
        let (s, c) = (graph.input(s), graph.input(c));
        let turned = v.rotated(n, s, c).ids();
        assert_eq!(turned[2], v.ids()[2]);
        assert_ne!(v.rotated(n, -s, c).ids()[0], turned[0]);
    }

    #[test]
    fn a_formula_makes_the_nodes_of_the_graph_s_own_operations() {
        let graph = GraphBuilder::new(Ring::default());
        let [x, y] = ["x", "y"].map(|name| graph.input(graph.symbol(name)));
        let written = ((1 - x) * y / 2 + 3 * x).named("sum");
        let mut graph_itself = graph.graph.borrow().clone();
        let (one, two, three) = (graph_itself.integer(1), graph_itself.integer(2), graph_itself.integer(3));
        let difference = graph_itself.sub(one, x.id());
        let product = graph_itself.mul(difference, y.id());
        let half = graph_itself.div(product, two);
        let triple = graph_itself.mul(three, x.id());
        let written = written.id();
        assert_eq!(graph_itself.add(half, triple), written);
        assert_eq!(graph.finish().name_of(written), Some("sum"));
    }
}
