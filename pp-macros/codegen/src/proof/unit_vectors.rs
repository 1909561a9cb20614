//! Symbols for the components of directions that are products: what holds for every unit vector holds for the declared
//! ones.

use std::collections::BTreeMap;

use crate::model::{AxisKind, Model};
use crate::solve::Solved;
use crate::symbolic::{Graph, Id, Interpreter, Node, NodeVector, Poly, PolyVector, Symbol};

/// A machine whose rotary directions and tool axis are general unit vectors.
///
/// Directions that are products of sines of dimensions make long polynomials. A claim that holds with a symbol for each
/// of their components and `n_z² = 1 - n_x² - n_y²` alone holds for every unit vector, hence for the declared ones.
pub(crate) struct GeneralDirections {
    model: Model,
    /// Nodes of components, and their symbols.
    known: Vec<(Id, Poly)>,
}

impl GeneralDirections {
    /// The machine itself, every direction as declared.
    pub(crate) fn written_out(model: &Model) -> Self {
        Self { model: model.clone(), known: Vec::new() }
    }

    /// The machine, its directions as symbols where they are products.
    pub(crate) fn model(&self) -> &Model {
        &self.model
    }

    /// With symbols for the directions that are products; `None` if there is none, or if one is not a unit vector.
    /// `joints` has proven that the nodes are as declared.
    pub(crate) fn of(model: &Model, solved: &Solved, graph: &mut Graph) -> Option<Self> {
        let mut general = Self::written_out(model);
        let rotaries = model.axes.iter().zip(&solved.directions).filter(|(axis, _)| axis.kind == AxisKind::Rotary);
        let directions = rotaries.map(|(axis, nodes)| (&axis.direction, *nodes));
        for (direction, nodes) in directions.chain([(&model.tool_axis, solved.tool_axis)]) {
            if !graph.ring().is_zero(&(&graph.ring().dot(direction, direction) - &Poly::one())) {
                return None;
            }
            generalise(graph, direction, nodes, &mut general.known);
        }
        let replace = |direction: &mut PolyVector, nodes: NodeVector| {
            *direction =
                std::array::from_fn(|index| generalised(graph, &direction[index], nodes[index], &general.known));
        };
        general
            .model
            .axes
            .iter_mut()
            .zip(&solved.directions)
            .for_each(|(axis, nodes)| replace(&mut axis.direction, *nodes));
        replace(&mut general.model.tool_axis, solved.tool_axis);
        general.model.ring = graph.ring().clone();
        (!general.known.is_empty()).then_some(general)
    }

    /// Reads the graph with the symbols in place of the components.
    pub(crate) fn reader<'a>(&self, graph: &'a mut Graph, inputs: BTreeMap<Symbol, Poly>) -> Interpreter<'a> {
        let mut reader = Interpreter::new(graph, inputs);
        for (node, value) in &self.known {
            reader.assume(*node, value.clone());
        }
        reader
    }
}

/// Makes symbols for the components of a unit vector that are products; numbers and single sines stay as they are.
fn generalise(graph: &mut Graph, direction: &PolyVector, nodes: NodeVector, known: &mut Vec<(Id, Poly)>) {
    let is_product = |node: &Id| !matches!(graph.node(*node), Node::Constant(_) | Node::Input(_));
    let nodes_without_sign = nodes.map(|node| unsigned(graph, node).0);
    let fresh: Vec<Id> = nodes_without_sign
        .into_iter()
        .filter(|node| is_product(node) && known.iter().all(|(other, _)| other != node))
        .collect();
    let Some((last, free)) = fresh.split_last() else { return };
    let alone = nodes_without_sign.iter().all(|node| node == last || graph.constant_of(*node).is_some());
    if alone || free.contains(last) {
        return;
    }
    known.extend(free.iter().map(|node| (*node, Poly::from(graph.symbol("component")))));
    let others = (0..3).filter(|index| nodes_without_sign[*index] != *last);
    let others: Vec<Poly> = others.map(|index| generalised(graph, &direction[index], nodes[index], known)).collect();
    let square = others.iter().fold(Poly::one(), |rest, part| &rest - &graph.ring().mul(part, part));
    known.push((*last, Poly::from(graph.root("component", square))));
}

/// The symbol of a component, or the component itself.
fn generalised(graph: &Graph, component: &Poly, node: Id, known: &[(Id, Poly)]) -> Poly {
    let (node, minus) = unsigned(graph, node);
    match known.iter().find(|(other, _)| *other == node) {
        Some((_, value)) if minus => -value,
        Some((_, value)) => value.clone(),
        None => component.clone(),
    }
}

/// The node without its sign, and whether that is minus.
fn unsigned(graph: &Graph, node: Id) -> (Id, bool) {
    match *graph.node(node) {
        Node::Neg(inner) => (inner, true),
        _ => (node, false),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::proof::two::prove_two;
    use crate::solve::Orientation;

    fn general(fields: &str) -> (Graph, Orientation, Option<GeneralDirections>) {
        let text = format!("pub struct M; chain: C B | X Y Z; {fields}");
        let mut errors = crate::report::Errors::default();
        let declaration = crate::syntax::parse(text.parse().expect("tokens"), &mut errors).expect("syntax");
        let model = crate::check::check(&declaration, &mut errors).expect("rules").model;
        let solved = crate::solve::solve(&model).expect("solvable");
        let mut graph = solved.graph.clone();
        let general = GeneralDirections::of(&model, &solved, &mut graph);
        (graph, solved.orientation, general)
    }

    #[test]
    fn directions_that_are_products_need_to_be_unit_vectors_and_no_more() {
        let (mut graph, orientation, general) =
            general("axes = { C: Rx(a) * Ry(b) * Z }; dims = { a: 1 deg, b: 2 deg };");
        let Orientation::Two(two) = orientation else { unreachable!("two rotaries") };
        let mut general = general.expect("products");
        assert!(prove_two(&general, &mut graph, &two).is_ok());
        // Nor may one vector take the place of another.
        general.known[0].1 = -&general.known[0].1;
        assert!(prove_two(&general, &mut graph, &two).is_err());
    }

    #[test]
    fn numbers_and_single_angles_stay_as_they_are() {
        assert!(general("axes = { B: Rx(a) * Y }; dims = { a: 1 deg };").2.is_none());
        assert!(general("axes = { B: Rx(-45 deg) * Y };").2.is_none());
    }
}
