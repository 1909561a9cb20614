//! Nodes of a graph as formulas, their structure kept.

use std::collections::BTreeMap;

use super::expression::Formula;
use super::names::SymbolNames;
use crate::model::Model;
use crate::symbolic::{Graph, Id, Node};

/// Nodes that are written as a name.
pub type NamedNodes = BTreeMap<Id, Formula>;

pub(crate) fn of_node(model: &Model, graph: &Graph, node: Id, known: &NamedNodes) -> Formula {
    let names = SymbolNames::new(model, graph.ring());
    Reader { model, graph, names, known }.read(node)
}

struct Reader<'a> {
    model: &'a Model,
    graph: &'a Graph,
    names: SymbolNames<'a>,
    known: &'a NamedNodes,
}

impl Reader<'_> {
    fn read(&self, id: Id) -> Formula {
        if let Some(formula) = self.known.get(&id) {
            return formula.clone();
        }
        match *self.graph.node(id) {
            Node::Constant(ref poly) => Formula::of_poly(self.model, self.graph.ring(), poly),
            Node::Input(symbol) => self.names.formula(symbol),
            Node::Neg(a) => self.read(a).negated(),
            Node::Add(a, b) => sum(self.read(a), self.read(b)),
            Node::Sub(a, b) => match self.read(b) {
                // A sum that is subtracted keeps its brackets.
                whole @ Formula::Sum(_) => sum(self.read(a), Formula::Neg(Box::new(whole))),
                other => sum(self.read(a), other.negated()),
            },
            Node::Mul(a, b) if a == b => Formula::Power(Box::new(self.read(a)), 2),
            Node::Mul(a, b) => product(self.read(a), self.read(b)),
            Node::Div(a, b) => Formula::Quotient(Box::new(self.read(a)), Box::new(self.read(b))),
            Node::Sqrt(a) => Formula::call("sqrt", [self.read(a)]),
        }
    }
}

fn sum(a: Formula, b: Formula) -> Formula {
    let terms = |formula: Formula| match formula {
        Formula::Sum(terms) => terms,
        other => vec![other],
    };
    let mut all = terms(a);
    all.extend(terms(b));
    Formula::Sum(all)
}

fn product(a: Formula, b: Formula) -> Formula {
    let factors = |formula: Formula| match formula {
        Formula::Product(factors) => factors,
        other => vec![other],
    };
    let mut all = factors(a);
    all.extend(factors(b));
    // Numbers, names, brackets, functions: after a function without brackets the next factor would look like a part of
    // its argument.
    all.sort_by_key(|factor| match factor {
        Formula::Number(_) => 0,
        Formula::Name(_) | Formula::Root(_) => 1,
        Formula::Call(function, _) if function != "sqrt" => 3,
        _ => 2,
    });
    Formula::Product(all)
}
