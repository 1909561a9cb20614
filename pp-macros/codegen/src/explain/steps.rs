//! Formulas step by step, as the code computes them, where they are too long for one line.

use std::collections::{BTreeMap, BTreeSet};

use super::section::Section;
use crate::formula::{Formula, NamedNodes};
use crate::model::Model;
use crate::symbolic::{Graph, Id, Node};

/// Adds one equation for each node that is named in the code or used more than once.
pub(crate) fn steps(model: &Model, graph: &Graph, outputs: &[Id], section: &mut Section) -> NamedNodes {
    let mut uses: BTreeMap<Id, usize> = BTreeMap::new();
    let reachable = graph.reachable(outputs);
    for operand in reachable.iter().flat_map(|id| graph.operands(*id)) {
        *uses.entry(operand).or_default() += 1;
    }
    let mut known = NamedNodes::new();
    let mut taken: BTreeSet<String> = BTreeSet::new();
    let mut equations = Vec::new();
    for id in reachable {
        let plain = matches!(graph.node(id), Node::Constant(_) | Node::Input(_) | Node::Neg(_));
        let wanted = graph.name_of(id);
        if plain || (wanted.is_none() && uses.get(&id).is_none_or(|count| *count < 2)) {
            continue;
        }
        let wanted = wanted.unwrap_or("t");
        let mut name = wanted.to_string();
        let mut number = 1;
        while !taken.insert(name.clone()) {
            number += 1;
            name = format!("{wanted}_{number}");
        }
        let name = Formula::name(name);
        equations.push((name.clone(), Formula::of_node(model, graph, id, &known)));
        known.insert(id, name);
    }
    section.equations(&equations);
    known
}
