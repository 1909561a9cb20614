//! forward∘inverse = identity, for every branch, over the very graph that is printed.
//!
//! The forward side is the product of the elementary matrices; the inverse side is read from the emitted nodes. A `√`
//! node becomes a generator whose square is its radicand, `1/x` one whose product with `x` is 1; with `sin² + cos² = 1`
//! and `i² + j² + k² = 1` that is all there is, and everything is proven by remainders.
//!
//! A root that is claimed to equal a sum of squares is replaced by it: both are not negative and their squares are
//! compared exactly.

use std::collections::BTreeMap;

use crate::model::{AxisId, Kind, Model};
use crate::solve::{Branch, One, Orientation, Solved, Two};
use crate::symbolic::{Graph, Id, Interpreter, Matrix, Node, P3, Poly, Ring, Symbol, V3};

/// Proves a solved machine.
///
/// Returns the claims in words.
///
/// # Errors
/// The claim that does not hold. That is a fault of the solver, never of the declaration.
pub fn prove(model: &Model, solved: &mut Solved) -> Result<Vec<String>, String> {
    let product = model.product();
    joints(model, solved)?;
    let mut claims = vec![forward(model, solved, &product)?, position(model, solved)?];
    let orientation = solved.orientation.clone();
    match &orientation {
        Orientation::Fixed { deviation } => {
            let tool = product.turn(&model.tool_axis, &model.ring);
            let mut reader = Interpreter::new(&mut solved.graph, assign(model.frame.axis, tool));
            if !reader.claim(*deviation, &Poly::zero()) {
                return Err("the fixed tool axis is reached without deviation".into());
            }
            claims.push("the only reachable tool axis is the product's".into());
        }
        Orientation::One(one) => claims.push(prove_one(model, solved, &product, one)?),
        Orientation::Two(two) => {
            prove_lengths(model, solved, two)?;
            let general = General::of(model, solved).and_then(|general| prove_two(&general, solved, two).ok());
            claims.extend(match general {
                Some(claims) => claims,
                None => prove_two(&General::written_out(model), solved, two)?,
            });
        }
    }
    Ok(claims)
}

/// What `joint` answers is the declaration, and the joint with `-q` undoes the joint.
fn joints(model: &Model, solved: &mut Solved) -> Result<(), String> {
    let (directions, centres, tool_axis) = (solved.directions.clone(), solved.centres.clone(), solved.tool_axis);
    let mut reader = Interpreter::new(&mut solved.graph, BTreeMap::new());
    for (id, axis) in model.axes.iter().enumerate() {
        let letter = axis.letter;
        if model.product_of([model.joint(id), model.joint_inverse(id)]) != Matrix::identity() {
            return Err(format!("the joint of {letter} is undone by its joint with -q"));
        }
        let claim = format!("the joint of {letter} is as declared");
        let centre = if axis.kind == Kind::Rotary { model.centre(id) } else { axis.point.clone() };
        let expected = axis.direction.iter().chain(&centre);
        for (node, expected) in directions[id].into_iter().chain(centres[id]).zip(expected) {
            let value = reader.value(node);
            holds(&reader, &value, expected, &claim)?;
        }
    }
    for (node, expected) in tool_axis.into_iter().zip(&model.tool_axis) {
        let value = reader.value(node);
        holds(&reader, &value, expected, "the tool axis is as declared")?;
    }
    Ok(())
}

fn forward(model: &Model, solved: &mut Solved, product: &Matrix) -> Result<String, String> {
    let nodes = solved.forward;
    let axis = product.turn(&model.tool_axis, &model.ring);
    let mut reader = Interpreter::new(&mut solved.graph, BTreeMap::new());
    let expected = product.origin().into_iter().chain(axis);
    for (node, expected) in nodes.tip.into_iter().chain(nodes.axis).zip(expected) {
        let value = reader.value(node);
        holds(&reader, &value, &expected, "forward kinematics = product of the elementary matrices")?;
    }
    Ok("forward kinematics = product of the elementary matrices".into())
}

/// `T(q)·0 = tip`, shown as `J_c ... J_n·0 = J_(c-1)⁻¹ ... J_1⁻¹·tip` at the cut `c`: the same equation with far fewer
/// products of sines.
fn position(model: &Model, solved: &mut Solved) -> Result<String, String> {
    let values = solved.position.values.clone();
    let cut = solved.position.cut;
    let claim = "the linear axes bring the tip to (x, y, z)";
    let undone = model.product_of((0..cut).rev().map(|axis| model.joint_inverse(axis)));
    let tool = model.product_of((cut..model.axes.len()).map(|axis| model.joint(axis)));
    let wanted = {
        let tip = model.frame.tip.map(Poly::from);
        let turned = undone.turn(&tip, &model.ring);
        let origin = undone.origin();
        turned.into_iter().zip(origin).map(|(a, b)| &a + &b).collect::<Vec<_>>()
    };
    let mut reader = Interpreter::new(&mut solved.graph, BTreeMap::new());
    let words = values.iter().map(|(axis, node)| (model.axes[*axis].word, reader.value(*node))).collect();
    for (reached, wanted) in tool.origin().iter().zip(&wanted) {
        let gap = reader.ring().substitute(&(reached - wanted), &words);
        holds(&reader, &gap, &Poly::zero(), claim)?;
    }
    Ok(format!("{claim} for every value of the rotary axes where the determinant is not zero"))
}

fn prove_one(model: &Model, solved: &mut Solved, product: &Matrix, one: &One) -> Result<String, String> {
    let letter = model.axes[one.rotary].letter;
    let axis = product.turn(&model.tool_axis, &model.ring);
    let mut reader = Interpreter::new(&mut solved.graph, assign(model.frame.axis, axis));
    let length = reader.value(one.length_claim);
    if !reader.claim(one.length, &length) || !reader.claim(one.deviation, &Poly::zero()) {
        return Err(format!("every tool axis made by {letter} is found to be reachable"));
    }
    let (sine, cosine) = model.axes[one.rotary].turn;
    let claim = format!("{letter} is found again from the tool axis it makes");
    for (node, symbol) in [(one.word.0, sine), (one.word.1, cosine)] {
        let value = reader.value(node);
        holds(&reader, &value, &Poly::from(symbol), &claim)?;
    }
    Ok(claim)
}

/// `r² = D - w²`, and the own length of the first angle's direction is `g² + e²`.
///
/// Both follow from `p = n·m`, `q = m·t` and `n·a` alone, whatever these are made of: with symbols for the three the
/// identities are small. What the symbols leave out is shown before: `|m×n|² = 1-p²`, `D = (1-p²)(1-q²)`,
/// `|n×a|² = 1-(n·a)²`, `g² + e² = (1-p²)|n×a|²`. Roots are replaced by what has the same square and is not negative.
fn prove_lengths(model: &Model, solved: &mut Solved, two: &Two) -> Result<(), String> {
    let letters = model.letters(two.rotaries);
    let graph = &mut solved.graph;
    let cosines = [two.tilt.between.1, two.tilt.tool.1, two.edge.along.0];
    let sine_squares =
        |values: &[Poly; 3], ring: &Ring| values.clone().map(|value| &Poly::one() - &ring.mul(&value, &value));
    let parts = |[p, q, along]: &[Poly; 3], ring: &Ring| {
        [
            (two.first.between_squared, p.clone()),
            (two.second.capacity, ring.mul(p, q)),
            (two.first.sine_squared, along.clone()),
            (two.first.spread, ring.mul(p, along)),
        ]
    };
    let mut reader = Interpreter::new(graph, BTreeMap::new());
    let values = cosines.map(|node| reader.value(node));
    let squares = sine_squares(&values, reader.ring());
    for (node, expected) in parts(&squares, reader.ring()) {
        let value = reader.value(node);
        holds(&reader, &value, &expected, &format!("the directions of {letters} are unit vectors"))?;
    }
    let [p, q, _] = &values;
    let same =
        [(q, p, false), (q, &-p, true)].into_iter().find(|(a, b, _)| reader.equal(a, b)).map(|(.., minus)| minus);
    let symbols = ["p", "q", "along"].map(|name| Poly::from(graph.symbol(name)));
    let mut abstracted: [Poly; 3] = std::array::from_fn(|index| {
        graph.constant_of(cosines[index]).cloned().unwrap_or_else(|| symbols[index].clone())
    });
    // Where the pole is reached one of the two determines the other.
    if let Some(minus) = same {
        abstracted[1] = if minus { -&abstracted[0] } else { abstracted[0].clone() };
    }
    let squares = sine_squares(&abstracted, graph.ring());
    let mut reader = Interpreter::new(graph, BTreeMap::new());
    for (node, value) in cosines.into_iter().zip(abstracted) {
        reader.assume(node, value);
    }
    for (node, value) in parts(&squares, &reader.ring().clone()) {
        reader.assume(node, value);
    }
    if lengths_hold(&mut reader, two) {
        return Ok(());
    }
    // Folding may have taken a symbol's node apart: then the same with everything written out.
    if lengths_hold(&mut Interpreter::new(&mut solved.graph, BTreeMap::new()), two) {
        return Ok(());
    }
    Err(format!("the root of {letters} is √(D - w²), and their direction has the length g² + e²"))
}

fn lengths_hold(reader: &mut Interpreter<'_>, two: &Two) -> bool {
    let (height, capacity) = (reader.value(two.second.height), reader.value(two.second.capacity));
    let square = &capacity - &reader.ring().mul(&height, &height);
    let radicand = reader.value(two.second.root_squared);
    if !reader.equal(&radicand, &square) {
        return false;
    }
    reader.assume_square(two.second.root, square);
    let spread = reader.value(two.first.spread);
    two.first.length.is_none_or(|length| reader.claim(length, &spread))
}

/// A machine of which only this is known: its rotary axes and its tool axis are unit vectors.
///
/// Directions that are products of sines of dimensions make long polynomials. What holds with a symbol for each of their
/// components and `n_z² = 1 - n_x² - n_y²` alone holds for every unit vector, hence for the declared ones.
struct General {
    model: Model,
    /// Nodes of components, and their symbols.
    known: Vec<(Id, Poly)>,
}

impl General {
    /// The machine itself, every direction as declared.
    fn written_out(model: &Model) -> Self {
        Self { model: model.clone(), known: Vec::new() }
    }

    /// With symbols for the directions that are products; `None` if there is none, or if one is no unit vector. `joints`
    /// has shown that the nodes are the declaration.
    fn of(model: &Model, solved: &mut Solved) -> Option<Self> {
        let mut general = Self::written_out(model);
        let graph = &mut solved.graph;
        let rotaries = model.axes.iter().zip(&solved.directions).filter(|(axis, _)| axis.kind == Kind::Rotary);
        let directions = rotaries.map(|(axis, nodes)| (&axis.direction, *nodes));
        for (direction, nodes) in directions.chain([(&model.tool_axis, solved.tool_axis)]) {
            if !graph.ring().is_zero(&(&graph.ring().dot(direction, direction) - &Poly::one())) {
                return None;
            }
            disguise(graph, direction, nodes, &mut general.known);
        }
        let replace = |direction: &mut P3, nodes: V3| {
            *direction =
                std::array::from_fn(|index| in_disguise(graph, &direction[index], nodes[index], &general.known));
        };
        general
            .model
            .axes
            .iter_mut()
            .zip(&solved.directions)
            .for_each(|(axis, nodes)| replace(&mut axis.direction, *nodes));
        replace(&mut general.model.tool_axis, solved.tool_axis);
        general.model.ring = solved.graph.ring().clone();
        (!general.known.is_empty()).then_some(general)
    }

    fn reader<'a>(&self, graph: &'a mut Graph, inputs: BTreeMap<Symbol, Poly>) -> Interpreter<'a> {
        let mut reader = Interpreter::new(graph, inputs);
        for (node, value) in &self.known {
            reader.assume(*node, value.clone());
        }
        reader
    }
}

/// Makes symbols for the components of a unit vector that are products; numbers and single sines stay what they are.
fn disguise(graph: &mut Graph, direction: &P3, nodes: V3, known: &mut Vec<(Id, Poly)>) {
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
    let others: Vec<Poly> = others.map(|index| in_disguise(graph, &direction[index], nodes[index], known)).collect();
    let square = others.iter().fold(Poly::one(), |rest, part| &rest - &graph.ring().mul(part, part));
    known.push((*last, Poly::from(graph.root("component", square))));
}

/// The symbol of a component, or the component itself.
fn in_disguise(graph: &Graph, component: &Poly, node: Id, known: &[(Id, Poly)]) -> Poly {
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

fn prove_two(general: &General, solved: &mut Solved, two: &Two) -> Result<Vec<String>, String> {
    let mut claims = Vec::new();
    for answer in &two.branches {
        claims.push(prove_answer(general, solved, two, answer)?);
    }
    claims.push(prove_edge(general, solved, two)?);
    Ok(claims)
}

fn prove_answer(general: &General, solved: &mut Solved, two: &Two, answer: &Branch) -> Result<String, String> {
    let model = &general.model;
    let letters = model.letters(two.rotaries);
    let mut reader = general.reader(&mut solved.graph, BTreeMap::new());
    // `prove_lengths` has shown these two.
    let (capacity, height) = (reader.value(two.second.capacity), reader.value(two.second.height));
    let square = &capacity - &reader.ring().mul(&height, &height);
    reader.assume_square(two.second.root, square);
    if let Some(length) = two.first.length {
        let spread = reader.value(two.first.spread);
        reader.assume(length, spread);
    }
    let words = turns(model, &mut reader, &two.rotaries, &answer.words);
    for axis in two.rotaries {
        on_circle(model, &reader, axis, &words)?;
    }
    let branch = if answer.plus == two.first_is_plus() { "first" } else { "second" };
    let claim = format!("{letters} turn the tool to (i, j, k), {branch} branch");
    // R1 R2 t = a, shown as R2 t = R1⁻¹ a, and likewise for what is held: far fewer products of sines.
    let after = two.rotaries[0] + 1;
    let tool = model.product_of((after..model.axes.len()).map(|axis| model.joint(axis)));
    let undone = model.product_of((0..after).rev().map(|axis| model.joint_inverse(axis)));
    let reached = tool.turn(&model.tool_axis, reader.ring());
    let wanted = undone.turn(&model.frame.axis.map(Poly::from), reader.ring());
    for (reached, wanted) in reached.iter().zip(&wanted) {
        let [reached, wanted] = [reached, wanted].map(|part| reader.ring().substitute(part, &words));
        holds(&reader, &reached, &wanted, &claim)?;
    }
    // The branch: α1 s2 - α2 c2 = σ r, and a root is never negative.
    let (_, cosine) = model.axes[two.rotaries[1]].turn;
    let sine = reader.ring().substitute(&model.joint_sine(two.rotaries[1]), &words);
    let [first, second] = two.second.alpha.map(|node| reader.value(node));
    let side = &reader.ring().mul(&first, &sine) - &reader.ring().mul(&second, &words[&cosine]);
    let root = reader.value(two.second.root);
    let root = if answer.plus { root } else { -&root };
    holds(&reader, &side, &root, &format!("{letters} stay on their branch"))?;
    Ok(claim)
}

fn prove_edge(general: &General, solved: &mut Solved, two: &Two) -> Result<String, String> {
    let model = &general.model;
    let [first, second] = two.rotaries;
    let edge = &two.edge;
    let height = Poly::from(edge.height);
    let capacity = general.reader(&mut solved.graph, BTreeMap::new()).value(two.second.capacity);
    let radicand = &capacity - &solved.graph.ring().mul(&height, &height);
    let root = Poly::from(solved.graph.root("edge", radicand));
    let mut reader = general.reader(&mut solved.graph, BTreeMap::from([(edge.root, root)]));
    let mut words = turns(model, &mut reader, &[second], &[edge.second]);
    on_circle(model, &reader, second, &words)?;
    let (sine, cosine) = model.axes[first].turn;
    words.insert(sine, Poly::zero());
    words.insert(cosine, Poly::one());

    let ring = reader.ring().clone();
    let reached = model.product().turn(&model.tool_axis, &ring).map(|part| ring.substitute(&part, &words));
    let before = model.product_of((0..first).map(|axis| model.joint(axis)));
    let direction = before.turn(&model.axes[first].direction, &ring);
    let wanted = model.frame.axis.map(Poly::from);
    let (n_b, n_a) = (cross(&direction, &reached, &ring), cross(&direction, &wanted, &ring));
    let room = {
        let (p, one) = (reader.value(two.tilt.between.1), Poly::one());
        &one - &ring.mul(&p, &p)
    };
    let signed_sine = ring.mul(&room, &ring.dot(&n_b, &wanted));
    let signed_sine = if model.axes[first].reversed { -&signed_sine } else { signed_sine };
    let claim = "at the rim the nearest reachable tool axis is taken";
    let squares = [edge.first.0, edge.first.1].map(|node| reader.value(node)).map(|part| ring.mul(&part, &part));
    let pairs = [
        (edge.first_squared, &squares[0] + &squares[1]),
        (edge.along.1, ring.dot(&direction, &reached)),
        (edge.reached_squared, ring.dot(&n_b, &n_b)),
        (edge.first.0, signed_sine),
        (edge.first.1, ring.mul(&room, &ring.dot(&n_b, &n_a))),
    ];
    for (node, expected) in pairs {
        let value = reader.value(node);
        holds(&reader, &value, &expected, claim)?;
    }
    Ok(claim.into())
}

fn assign(symbols: [Symbol; 3], values: P3) -> BTreeMap<Symbol, Poly> {
    symbols.into_iter().zip(values).collect()
}

fn turns(model: &Model, reader: &mut Interpreter<'_>, axes: &[AxisId], words: &[(Id, Id)]) -> BTreeMap<Symbol, Poly> {
    let mut values = BTreeMap::new();
    for (axis, (sine, cosine)) in axes.iter().zip(words) {
        let turn = model.axes[*axis].turn;
        values.insert(turn.0, reader.value(*sine));
        values.insert(turn.1, reader.value(*cosine));
    }
    values
}

fn on_circle(
    model: &Model,
    reader: &Interpreter<'_>,
    axis: AxisId,
    words: &BTreeMap<Symbol, Poly>,
) -> Result<(), String> {
    let (sine, cosine) = model.axes[axis].turn;
    let squares = [&words[&sine], &words[&cosine]].map(|part| reader.ring().mul(part, part));
    let letter = model.axes[axis].letter;
    holds(reader, &(&squares[0] + &squares[1]), &Poly::one(), &format!("sin² {letter} + cos² {letter} = 1"))
}

fn holds(reader: &Interpreter<'_>, left: &Poly, right: &Poly, claim: &str) -> Result<(), String> {
    if reader.equal(left, right) { Ok(()) } else { Err(claim.to_string()) }
}

fn cross(a: &P3, b: &P3, ring: &Ring) -> P3 {
    std::array::from_fn(|index| {
        let (next, last) = ((index + 1) % 3, (index + 2) % 3);
        &ring.mul(&a[next], &b[last]) - &ring.mul(&a[last], &b[next])
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn general(axes: &str) -> (Solved, Option<General>) {
        let text = format!("pub struct M; chain: C B | X Y Z; axes = {{ {axes} }}; dims = {{ a: 1 deg, b: 2 deg }};");
        let mut errors = crate::report::Errors::default();
        let declaration = crate::syntax::parse(text.parse().expect("tokens"), &mut errors).expect("syntax");
        let (mut model, _) = crate::check::check(&declaration, &mut errors).expect("rules");
        let mut solved = crate::solve::solve(&mut model).expect("solvable");
        let general = General::of(&model, &mut solved);
        (solved, general)
    }

    #[test]
    fn directions_that_are_products_need_to_be_unit_vectors_and_no_more() {
        let (mut solved, general) = general("C: Rx(a) * Ry(b) * Z");
        let Orientation::Two(two) = solved.orientation.clone() else { unreachable!("two rotaries") };
        let mut general = general.expect("products");
        assert!(prove_two(&general, &mut solved, &two).is_ok());
        // Nor may one vector take the place of another.
        general.known[0].1 = -&general.known[0].1;
        assert!(prove_two(&general, &mut solved, &two).is_err());
    }

    #[test]
    fn numbers_and_single_angles_stay_as_they_are() {
        assert!(general("B: Rx(a) * Y").1.is_none());
        assert!(general("B: Rx(-45 deg) * Y").1.is_none());
    }
}
