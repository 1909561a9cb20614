//! The root and the lengths by which the formulas of two rotary axes are normalised.

use std::collections::BTreeMap;

use super::claim::holds;
use crate::model::Model;
use crate::solve::TwoRotaries;
use crate::symbolic::{Graph, Interpreter, Poly, Ring};

/// Proves `r² = D - w²`, and that the direction of the first angle has the length `g² + e²`.
///
/// Both follow from `p = n·m`, `q = m·t` and `n·a` alone: with symbols for these three the identities are small. The
/// relations that the symbols leave out are shown before: `|m×n|² = 1-p²`, `D = (1-p²)(1-q²)`, `|n×a|² = 1-(n·a)²`,
/// `g² + e² = (1-p²)|n×a|²`. A root is replaced by an expression that has the same square and is not negative.
pub(crate) fn prove_lengths(model: &Model, graph: &mut Graph, two: &TwoRotaries) -> Result<(), String> {
    let letters = model.letters(two.rotaries);
    let cosines = [two.tilt.between.cosine, two.tilt.tool.cosine, two.edge.along.0];
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
    // Folding may have removed a node that has a symbol; then the same is shown with everything written out.
    if lengths_hold(&mut Interpreter::new(graph, BTreeMap::new()), two) {
        return Ok(());
    }
    Err(format!("the root of {letters} is √(D - w²), and their direction has the length g² + e²"))
}

fn lengths_hold(reader: &mut Interpreter<'_>, two: &TwoRotaries) -> bool {
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
