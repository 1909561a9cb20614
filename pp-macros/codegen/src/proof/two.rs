//! Two rotary axes rotate the tool to the wanted axis, on both branches and at the edge.

use std::collections::BTreeMap;

use super::claim::holds;
use super::unit_vectors::GeneralDirections;
use crate::model::{AxisId, Model};
use crate::solve::{Branch, TwoRotaries};
use crate::symbolic::{Graph, Interpreter, Poly, PolyVector, Ring, SineCosine, Symbol};

/// Proves both branches, and the axis that is taken at the rim; returns the claims in words.
///
/// # Errors
/// The claim that is not proven.
pub(crate) fn prove_two(
    general: &GeneralDirections,
    graph: &mut Graph,
    two: &TwoRotaries,
) -> Result<Vec<String>, String> {
    let mut claims = Vec::new();
    for branch in &two.branches {
        claims.push(prove_branch(general, graph, two, branch)?);
    }
    claims.push(prove_edge(general, graph, two)?);
    Ok(claims)
}

fn prove_branch(
    general: &GeneralDirections,
    graph: &mut Graph,
    two: &TwoRotaries,
    branch: &Branch,
) -> Result<String, String> {
    let model = general.model();
    let letters = model.letters(two.rotaries);
    let mut reader = general.reader(graph, BTreeMap::new());
    // `prove_lengths` has shown these two.
    let (capacity, height) = (reader.value(two.second.capacity), reader.value(two.second.height));
    let square = &capacity - &reader.ring().mul(&height, &height);
    reader.assume_square(two.second.root, square);
    if let Some(length) = two.first.length {
        let spread = reader.value(two.first.spread);
        reader.assume(length, spread);
    }
    let words = sin_cos_values(model, &mut reader, &two.rotaries, &branch.words);
    for axis in two.rotaries {
        on_circle(model, &reader, axis, &words)?;
    }
    let name = if branch.plus == two.first_is_plus() { "first" } else { "second" };
    let claim = format!("{letters} rotate the tool axis to (i, j, k), {name} branch");
    // R1 R2 t = a, shown as R2 t = R1⁻¹ a, with held axes on their side of it: far fewer products of sines.
    let after = two.rotaries[0] + 1;
    let tool = model.product_of((after..model.axes.len()).map(|axis| model.joint(axis)));
    let undone = model.product_of((0..after).rev().map(|axis| model.joint_inverse(axis)));
    let reached = tool.rotate(&model.tool_axis, reader.ring());
    let wanted = undone.rotate(&model.symbols.axis.map(Poly::from), reader.ring());
    for (reached, wanted) in reached.iter().zip(&wanted) {
        let [reached, wanted] = [reached, wanted].map(|part| reader.ring().substitute(part, &words));
        holds(&reader, &reached, &wanted, &claim)?;
    }
    // The branch: α1 s2 - α2 c2 = σ r, and a root is never negative.
    let (_, cosine) = model.axes[two.rotaries[1]].sin_cos;
    let sine = reader.ring().substitute(&model.joint_sine(two.rotaries[1]), &words);
    let [first, second] = two.second.alpha.map(|node| reader.value(node));
    let side = &reader.ring().mul(&first, &sine) - &reader.ring().mul(&second, &words[&cosine]);
    let root = reader.value(two.second.root);
    let root = if branch.plus { root } else { -&root };
    holds(&reader, &side, &root, &format!("{letters} stay on their branch"))?;
    Ok(claim)
}

fn prove_edge(general: &GeneralDirections, graph: &mut Graph, two: &TwoRotaries) -> Result<String, String> {
    let model = general.model();
    let [first, second] = two.rotaries;
    let edge = &two.edge;
    let height = Poly::from(edge.height);
    let capacity = general.reader(graph, BTreeMap::new()).value(two.second.capacity);
    let radicand = &capacity - &graph.ring().mul(&height, &height);
    let root = Poly::from(graph.root("edge", radicand));
    let mut reader = general.reader(graph, BTreeMap::from([(edge.root, root)]));
    let mut words = sin_cos_values(model, &mut reader, &[second], &[edge.second]);
    on_circle(model, &reader, second, &words)?;
    let (sine, cosine) = model.axes[first].sin_cos;
    words.insert(sine, Poly::zero());
    words.insert(cosine, Poly::one());

    let ring = reader.ring().clone();
    let reached = model.product().rotate(&model.tool_axis, &ring).map(|part| ring.substitute(&part, &words));
    let before = model.product_of((0..first).map(|axis| model.joint(axis)));
    let direction = before.rotate(&model.axes[first].direction, &ring);
    let wanted = model.symbols.axis.map(Poly::from);
    let (n_b, n_a) = (cross(&direction, &reached, &ring), cross(&direction, &wanted, &ring));
    let room = {
        let (p, one) = (reader.value(two.tilt.between.cosine), Poly::one());
        &one - &ring.mul(&p, &p)
    };
    let signed_sine = ring.mul(&room, &ring.dot(&n_b, &wanted));
    let signed_sine = if model.axes[first].reversed { -&signed_sine } else { signed_sine };
    let claim = "a tool axis up to 1e-6 rad beyond the reachable ones is replaced by the nearest reachable one";
    let squares = edge.first.nodes().map(|node| reader.value(node)).map(|part| ring.mul(&part, &part));
    let pairs = [
        (edge.first_squared, &squares[0] + &squares[1]),
        (edge.along.1, ring.dot(&direction, &reached)),
        (edge.reached_squared, ring.dot(&n_b, &n_b)),
        (edge.first.sine, signed_sine),
        (edge.first.cosine, ring.mul(&room, &ring.dot(&n_b, &n_a))),
    ];
    for (node, expected) in pairs {
        let value = reader.value(node);
        holds(&reader, &value, &expected, claim)?;
    }
    Ok(claim.into())
}

fn sin_cos_values(
    model: &Model,
    reader: &mut Interpreter<'_>,
    axes: &[AxisId],
    words: &[SineCosine],
) -> BTreeMap<Symbol, Poly> {
    let mut values = BTreeMap::new();
    for (axis, word) in axes.iter().zip(words) {
        let symbols = model.axes[*axis].sin_cos;
        values.insert(symbols.0, reader.value(word.sine));
        values.insert(symbols.1, reader.value(word.cosine));
    }
    values
}

fn on_circle(
    model: &Model,
    reader: &Interpreter<'_>,
    axis: AxisId,
    words: &BTreeMap<Symbol, Poly>,
) -> Result<(), String> {
    let (sine, cosine) = model.axes[axis].sin_cos;
    let squares = [&words[&sine], &words[&cosine]].map(|part| reader.ring().mul(part, part));
    let letter = model.axes[axis].letter;
    holds(reader, &(&squares[0] + &squares[1]), &Poly::one(), &format!("sin² {letter} + cos² {letter} = 1"))
}

fn cross(a: &PolyVector, b: &PolyVector, ring: &Ring) -> PolyVector {
    std::array::from_fn(|index| {
        let (next, last) = ((index + 1) % 3, (index + 2) % 3);
        &ring.mul(&a[next], &b[last]) - &ring.mul(&a[last], &b[next])
    })
}
