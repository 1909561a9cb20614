//! Linear axes from the tip and the rotary axes.

use std::collections::BTreeMap;

use super::chain::{at_the_table, letter, part};
use super::section::{Section, line};
use super::steps::steps;
use crate::formula::{Formula, is_readable};
use crate::model::{AxisId, Model};
use crate::solve::{Position, Solved};
use crate::symbolic::{Graph, Id, Interpreter, Node, Poly};

/// Formulas of the solved linear axes, over a common determinant where it varies.
pub(crate) struct LinearFormulas {
    /// With the part origin at the table's reference point.
    short: Vec<LinearFormula>,
    /// With the part origin anywhere.
    whole: Vec<LinearFormula>,
    determinant: Formula,
}

#[derive(Clone, PartialEq)]
struct LinearFormula {
    axis: Formula,
    /// True if the value is divided by the determinant.
    divided: bool,
    value: Formula,
}

impl LinearFormula {
    /// The equation, with `below` for the determinant.
    fn equation(&self, below: &Formula) -> (Formula, Formula) {
        let divided = |above: Formula| Formula::Quotient(Box::new(above), Box::new(below.clone()));
        (self.axis.clone(), if self.divided { divided(self.value.clone()) } else { self.value.clone() })
    }
}

impl LinearFormulas {
    /// `None` where they are too long for a line.
    pub(crate) fn of(model: &Model, solved: &Solved) -> Option<Self> {
        let mut graph = solved.graph.clone();
        let Linears { axes, determinant } = Linears::read(model, solved, &mut graph);
        if !axes.iter().map(|axis| &axis.value).chain([&determinant]).all(|poly| is_readable(&graph, poly)) {
            return None;
        }
        let formula = |poly: &Poly| Formula::of_poly(model, graph.ring(), poly);
        let one = |axis: &LinearAxis, value: &Poly| LinearFormula {
            axis: letter(model, axis.axis),
            divided: axis.divided,
            value: formula(value),
        };
        Some(Self {
            short: axes.iter().map(|axis| one(axis, &at_the_table(model, &axis.value))).collect(),
            whole: axes.iter().map(|axis| one(axis, &axis.value)).collect(),
            determinant: formula(&determinant),
        })
    }

    /// Equations with the part origin anywhere, the determinant written out.
    pub(crate) fn equations(&self) -> Vec<(Formula, Formula)> {
        self.whole.iter().map(|axis| axis.equation(&self.determinant)).collect()
    }

    /// Adds the equations, with the determinant by name.
    fn write(&self, model: &Model, section: &mut Section) {
        let below = Formula::name("det");
        if self.whole.iter().any(|axis| axis.divided) {
            section.equations(&[(below.clone(), self.determinant.clone())]);
        }
        let equations = |axes: &[LinearFormula]| axes.iter().map(|axis| axis.equation(&below)).collect::<Vec<_>>();
        if self.short == self.whole {
            section.equations(&equations(&self.whole));
            return;
        }
        section.words("with the part origin at the table's reference point:");
        section.equations(&equations(&self.short));
        section.line(line("with the part origin at ").vector(&part(model)).words(":"));
        section.equations(&equations(&self.whole));
    }
}

/// Equations of the linear axes.
pub(crate) fn linear(model: &Model, solved: &Solved, formulas: Option<&LinearFormulas>, section: &mut Section) {
    section.words("Linear axes from the tip (x, y, z), for any values of the rotary axes:");
    match formulas {
        Some(formulas) => formulas.write(model, section),
        None => in_steps(model, solved, section),
    }
}

/// A linear axis as a polynomial, over the determinant if `divided`.
struct LinearAxis {
    axis: AxisId,
    divided: bool,
    value: Poly,
}

/// All solved linear axes. Those over the determinant come first; the equations of the others may contain their words.
struct Linears {
    axes: Vec<LinearAxis>,
    determinant: Poly,
}

impl Linears {
    fn read(model: &Model, solved: &Solved, graph: &mut Graph) -> Self {
        let Position { values, determinant, .. } = &solved.position;
        let mut reader = Interpreter::new(graph, BTreeMap::new());
        let mut axes: Vec<LinearAxis> = Vec::new();
        for &(axis, node) in values {
            let (minus, inner) = match *solved.graph.node(node) {
                Node::Neg(inner) => (true, inner),
                _ => (false, node),
            };
            if let Some(above) = over_the_determinant(solved, inner) {
                let value = reader.value(above);
                axes.push(LinearAxis { axis, divided: true, value: if minus { -&value } else { value } });
                let word = Poly::from(model.axes[axis].word);
                reader.assume(inner, if minus { -&word } else { word.clone() });
                reader.assume(node, word);
            }
        }
        for &(axis, node) in values {
            if !axes.iter().any(|known| known.axis == axis) {
                axes.push(LinearAxis { axis, divided: false, value: reader.value(node) });
            }
        }
        Self { axes, determinant: reader.value(*determinant) }
    }
}

/// `a` of `a / det` or `a (1 / det)`, where the determinant varies.
fn over_the_determinant(solved: &Solved, node: Id) -> Option<Id> {
    let (graph, determinant) = (&solved.graph, solved.position.determinant);
    if graph.constant_of(determinant).is_some() {
        return None;
    }
    match *graph.node(node) {
        Node::Div(above, below) if below == determinant => Some(above),
        Node::Mul(a, b) => [(a, b), (b, a)].into_iter().find_map(|(value, inverse)| {
            matches!(*graph.node(inverse), Node::Div(_, below) if below == determinant).then_some(value)
        }),
        _ => None,
    }
}

fn in_steps(model: &Model, solved: &Solved, section: &mut Section) {
    let values: Vec<Id> = solved.position.values.iter().map(|(_, node)| *node).collect();
    let known = steps(model, &solved.graph, &values, section);
    let formula = |node: Id| Formula::of_node(model, &solved.graph, node, &known);
    let equations = solved.position.values.iter().map(|(axis, node)| (letter(model, *axis), formula(*node)));
    section.equations(&equations.collect::<Vec<_>>());
}
