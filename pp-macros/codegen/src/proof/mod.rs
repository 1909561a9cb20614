//! forward∘inverse = identity, proven for every branch on the same graph that is printed.
//!
//! The forward side is the product of the elementary matrices; the inverse side is read from the emitted nodes. A `√`
//! node becomes a generator whose square is its radicand, `1/x` one whose product with `x` is 1. These relations,
//! `sin² + cos² = 1` and `i² + j² + k² = 1` are the only ones; everything is proven by remainders.
//!
//! A root that is claimed to equal a sum of squares is replaced by it: neither is negative, and their squares are
//! compared exactly.

mod claim;
mod lengths;
mod two;
mod unit_vectors;

use std::collections::BTreeMap;

use claim::holds;
use lengths::prove_lengths;
use two::prove_two;
use unit_vectors::GeneralDirections;

use crate::model::{AxisKind, Model};
use crate::solve::{OneRotary, Orientation, Position, Solved};
use crate::symbolic::{Graph, Interpreter, Matrix, Poly, PolyVector, Symbol};

/// Proves a solved machine.
///
/// Returns the claims in words.
///
/// # Errors
/// The claim that does not hold. That is a fault of the solver, never of the declaration.
pub fn prove(model: &Model, solved: &Solved) -> Result<Vec<String>, String> {
    let product = model.product();
    // Generators of the proof are symbols of this copy alone.
    let graph = &mut solved.graph.clone();
    joints(model, solved, graph)?;
    let mut claims = vec![forward(model, solved, graph, &product)?, position(model, solved, graph)?];
    match &solved.orientation {
        Orientation::Fixed { deviation } => {
            let tool = product.rotate(&model.tool_axis, &model.ring);
            let mut reader = Interpreter::new(graph, assign(model.symbols.axis, tool));
            if !reader.claim(*deviation, &Poly::zero()) {
                return Err("the fixed tool axis is reached without deviation".into());
            }
            claims.push("the only reachable tool axis is that of the matrix product".into());
        }
        Orientation::One(one) => claims.push(prove_one(model, graph, &product, one)?),
        Orientation::Two(two) => {
            prove_lengths(model, graph, two)?;
            let general = GeneralDirections::of(model, solved, graph);
            claims.extend(match general.and_then(|general| prove_two(&general, graph, two).ok()) {
                Some(claims) => claims,
                None => prove_two(&GeneralDirections::written_out(model), graph, two)?,
            });
        }
    }
    Ok(claims)
}

/// Proves that the joints are those of the declaration, and that the joint with `-q` is the inverse of the joint.
fn joints(model: &Model, solved: &Solved, graph: &mut Graph) -> Result<(), String> {
    let Solved { directions, centres, tool_axis, .. } = solved;
    let mut reader = Interpreter::new(graph, BTreeMap::new());
    for (id, axis) in model.axes.iter().enumerate() {
        let letter = axis.letter;
        if model.product_of([model.joint(id), model.joint_inverse(id)]) != Matrix::identity() {
            return Err(format!("the joint of {letter} with -q is the inverse of the joint"));
        }
        let claim = format!("the joint of {letter} is as declared");
        let centre = if axis.kind == AxisKind::Rotary { model.centre(id) } else { axis.point.clone() };
        let expected = axis.direction.iter().chain(&centre);
        for (node, expected) in directions[id].into_iter().chain(centres[id]).zip(expected) {
            let value = reader.value(node);
            holds(&reader, &value, expected, &claim)?;
        }
    }
    for (node, expected) in tool_axis.iter().zip(&model.tool_axis) {
        let value = reader.value(*node);
        holds(&reader, &value, expected, "the tool axis is as declared")?;
    }
    Ok(())
}

fn forward(model: &Model, solved: &Solved, graph: &mut Graph, product: &Matrix) -> Result<String, String> {
    let nodes = solved.forward;
    let axis = product.rotate(&model.tool_axis, &model.ring);
    let mut reader = Interpreter::new(graph, BTreeMap::new());
    let expected = product.origin().into_iter().chain(axis);
    for (node, expected) in nodes.tip.into_iter().chain(nodes.axis).zip(expected) {
        let value = reader.value(node);
        holds(&reader, &value, &expected, "forward kinematics = product of the elementary matrices")?;
    }
    Ok("forward kinematics = product of the elementary matrices".into())
}

/// `T(q)·0 = tip`, shown as `J_c ... J_n·0 = J_(c-1)⁻¹ ... J_1⁻¹·tip` at the cut `c`: the same equation with far fewer
/// products of sines.
fn position(model: &Model, solved: &Solved, graph: &mut Graph) -> Result<String, String> {
    let Position { values, cut, .. } = &solved.position;
    let claim = "the linear axes bring the tip to (x, y, z)";
    let undone = model.product_of((0..*cut).rev().map(|axis| model.joint_inverse(axis)));
    let tool = model.product_of((*cut..model.axes.len()).map(|axis| model.joint(axis)));
    let wanted = {
        let tip = model.symbols.tip.map(Poly::from);
        let rotated = undone.rotate(&tip, &model.ring);
        let origin = undone.origin();
        rotated.into_iter().zip(origin).map(|(a, b)| &a + &b).collect::<Vec<_>>()
    };
    let mut reader = Interpreter::new(graph, BTreeMap::new());
    let words = values.iter().map(|(axis, node)| (model.axes[*axis].word, reader.value(*node))).collect();
    for (reached, wanted) in tool.origin().iter().zip(&wanted) {
        let gap = reader.ring().substitute(&(reached - wanted), &words);
        holds(&reader, &gap, &Poly::zero(), claim)?;
    }
    Ok(format!("{claim} for every value of the rotary axes where the determinant is not zero"))
}

fn prove_one(model: &Model, graph: &mut Graph, product: &Matrix, one: &OneRotary) -> Result<String, String> {
    let letter = model.axes[one.rotary].letter;
    let axis = product.rotate(&model.tool_axis, &model.ring);
    let mut reader = Interpreter::new(graph, assign(model.symbols.axis, axis));
    let length = reader.value(one.length_claim);
    if !reader.claim(one.length, &length) || !reader.claim(one.deviation, &Poly::zero()) {
        return Err(format!("every tool axis that {letter} produces is reachable"));
    }
    let (sine, cosine) = model.axes[one.rotary].sin_cos;
    let claim = format!("the inverse returns {letter} from the tool axis that {letter} produces");
    for (node, symbol) in [(one.word.sine, sine), (one.word.cosine, cosine)] {
        let value = reader.value(node);
        holds(&reader, &value, &Poly::from(symbol), &claim)?;
    }
    Ok(claim)
}

fn assign(symbols: [Symbol; 3], values: PolyVector) -> BTreeMap<Symbol, Poly> {
    symbols.into_iter().zip(values).collect()
}
