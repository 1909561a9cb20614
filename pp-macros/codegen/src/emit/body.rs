//! Nodes of the expression graph to statements: one variable for each node that is named or used more than once; the
//! others are written where they are used. The operators are the same in Rust and in C.

use std::collections::{BTreeMap, BTreeSet};

use proc_macro2::TokenStream;

use crate::model::LOCALS;
use crate::symbolic::{Graph, Id, Node, Symbol};

/// Language of the generated function.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Language {
    Rust,
    C,
}

/// Statements of one generated function, in the order of evaluation.
pub(crate) struct Body<'a> {
    graph: &'a Graph,
    language: Language,
    uses: BTreeMap<Id, usize>,
    written: BTreeMap<Id, String>,
    taken: BTreeSet<String>,
}

/// Name of a variable, and the expression for its value.
pub(crate) type Statement = (String, String);

impl<'a> Body<'a> {
    /// A function in Rust that computes all `outputs`, in one or more steps.
    pub(crate) fn new(graph: &'a Graph, outputs: &[Id]) -> Self {
        Self::of(Language::Rust, graph, outputs)
    }

    /// A function in C that computes all `outputs`, in one or more steps.
    pub(crate) fn in_c(graph: &'a Graph, outputs: &[Id]) -> Self {
        Self::of(Language::C, graph, outputs)
    }

    fn of(language: Language, graph: &'a Graph, outputs: &[Id]) -> Self {
        let mut uses = BTreeMap::new();
        for output in outputs {
            *uses.entry(*output).or_default() += 1;
        }
        for id in graph.reachable(outputs) {
            for operand in graph.operands(id) {
                *uses.entry(operand).or_default() += 1;
            }
        }
        let mut body = Self { graph, language, uses, written: BTreeMap::new(), taken: BTreeSet::new() };
        let inputs = body.inputs(outputs);
        body.taken.extend(inputs.into_iter().map(|symbol| graph.ring().name(symbol).to_string()));
        body.taken.extend(LOCALS.iter().map(ToString::to_string));
        body
    }

    /// Inputs that `outputs` need.
    pub(crate) fn inputs(&self, outputs: &[Id]) -> BTreeSet<Symbol> {
        let input = |id| match self.graph.node(id) {
            Node::Input(symbol) => Some(*symbol),
            _ => None,
        };
        self.graph.reachable(outputs).into_iter().filter_map(input).collect()
    }

    /// Statements for all nodes that `outputs` need and that are not written yet.
    pub(crate) fn statements(&mut self, outputs: &[Id]) -> Vec<Statement> {
        let mut statements = Vec::new();
        for id in self.graph.reachable(outputs) {
            if self.written.contains_key(&id) || !self.needs_name(id) {
                continue;
            }
            let expression = self.compound(id).0;
            let name = self.free_name(id);
            self.written.insert(id, name.clone());
            statements.push((name, expression));
        }
        statements
    }

    /// The expression for a node; its statements must have been written.
    pub(crate) fn expression(&self, id: Id) -> String {
        self.term(id).0
    }

    /// The expression as tokens.
    pub(crate) fn tokens(&self, id: Id) -> TokenStream {
        parse(&self.expression(id))
    }

    fn needs_name(&self, id: Id) -> bool {
        match self.graph.node(id) {
            Node::Constant(_) | Node::Input(_) => false,
            Node::Neg(_) => self.graph.name_of(id).is_some(),
            _ => self.graph.name_of(id).is_some() || self.uses.get(&id).is_some_and(|count| *count > 1),
        }
    }

    fn free_name(&mut self, id: Id) -> String {
        let wanted = self.graph.name_of(id).unwrap_or("t");
        let mut name = wanted.to_string();
        let mut number = 1;
        while !self.taken.insert(name.clone()) {
            number += 1;
            name = format!("{wanted}_{number}");
        }
        name
    }

    /// Expression and binding strength: 3 atoms, 2 unary minus, 1 products, 0 sums.
    fn term(&self, id: Id) -> (String, u8) {
        match self.written.get(&id) {
            Some(name) => (name.clone(), 3),
            None => self.compound(id),
        }
    }

    #[expect(clippy::expect_used, reason = "a constant of the graph is a number: it has a value without any symbol")]
    fn compound(&self, id: Id) -> (String, u8) {
        match *self.graph.node(id) {
            Node::Constant(ref value) => number(self.graph.ring().value(value).expect("constants have values")),
            Node::Input(symbol) => (self.graph.ring().name(symbol).to_string(), 3),
            Node::Neg(a) => (format!("-{}", self.within(a, 2)), 2),
            Node::Add(a, b) => (format!("{} + {}", self.within(a, 0), self.within(b, 1)), 0),
            Node::Sub(a, b) => (format!("{} - {}", self.within(a, 0), self.within(b, 1)), 0),
            Node::Mul(a, b) => (format!("{} * {}", self.within(a, 1), self.within(b, 2)), 1),
            Node::Div(a, b) => (format!("{} / {}", self.within(a, 1), self.within(b, 2)), 1),
            Node::Sqrt(a) => {
                let sqrt = match self.language {
                    Language::Rust => "math::sqrt",
                    Language::C => "sqrt",
                };
                (format!("{sqrt}({})", self.term(a).0), 3)
            }
        }
    }

    fn within(&self, id: Id, least: u8) -> String {
        let (text, strength) = self.term(id);
        if strength < least { format!("({text})") } else { text }
    }
}

/// `let` statements as tokens.
pub(crate) fn lets(statements: &[Statement]) -> TokenStream {
    let text: String = statements.iter().map(|(name, value)| format!("let {name} = {value};\n")).collect();
    parse(&text)
}

fn number(value: f64) -> (String, u8) {
    let text = format!("{:?}", value.abs());
    if value < 0.0 { (format!("-{text}"), 2) } else { (text, 3) }
}

#[expect(clippy::expect_used, reason = "the text is written here, from names and operators of Rust")]
fn parse(text: &str) -> TokenStream {
    text.parse().expect("statements are Rust")
}
