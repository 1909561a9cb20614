//! The nodes of `rates` and `motion` are derivatives of the matrix product, as polynomials.

use std::collections::BTreeMap;

use pp_codegen::check::check;
use pp_codegen::model::{AxisKind, Model};
use pp_codegen::report::Errors;
use pp_codegen::solve::{Motion, solve};
use pp_codegen::symbolic::{Id, Interpreter, Poly, PolyVector, Ring, Symbol};
use pp_codegen::syntax::parse;

const CHAINS: &[&str] = &[
    "chain: C B | X Y Z; d = (0, 0, d); dims = { d: 150.0 };",
    "chain: C B | X Y Z; axes = { B: Rx(-45 deg) * Y }; d = (0, 0, d); dims = { d: 150.0 };",
    "chain: C B | X Y Z; axes = { B: Rx(alpha) * Y }; dims = { alpha: -45 deg };",
    "chain: X | Y Z B A; signs = { B: -, X: - };",
    "chain: C | X Y Z B; d = { C: (1, 2, 3), B: (4, 5, 60) };",
    "chain: A Y | X Z; signs = { A: -, Y: - };",
    "chain: X Y | Z;",
    "chain: X C Y | A Z; d = { C: (1, 2, 3), A: (4, 5, 6) };",
    "chain: C A B | X Y Z W; hold = { A: 10, W: 0 };",
];

fn solved(text: &str) -> (Model, Motion) {
    let tokens = format!("pub struct M; {text}").parse().expect("Rust tokens");
    let mut errors = Errors::default();
    let declaration = parse(tokens, &mut errors).expect("syntax");
    let model = check(&declaration, &mut errors).expect("rules").model;
    let solved = solve(&model).expect("a solvable chain");
    (model, solved.motion)
}

/// `d poly / dt`, with the changes as the derivatives of the words.
fn derivative(poly: &Poly, model: &Model, motion: &Motion, ring: &Ring) -> Poly {
    let mut slopes: BTreeMap<Symbol, Poly> = BTreeMap::new();
    for (axis, change) in model.axes.iter().zip(&motion.changes) {
        let change = Poly::from(*change);
        match axis.kind {
            AxisKind::Linear => drop(slopes.insert(axis.word, change)),
            AxisKind::Rotary => {
                let (sine, cosine) = axis.sin_cos;
                slopes.insert(sine, ring.mul(&Poly::from(cosine), &change));
                slopes.insert(cosine, -&ring.mul(&Poly::from(sine), &change));
            }
        }
    }
    let mut sum = Poly::zero();
    for (monomial, factor) in poly.terms() {
        for (place, &(symbol, power)) in monomial.iter().enumerate() {
            let Some(slope) = slopes.get(&symbol) else { continue };
            let mut term = ring.mul(&Poly::from(factor.clone()), slope);
            for (other, &(symbol, power)) in monomial.iter().enumerate() {
                for _ in 0..if other == place { power - 1 } else { power } {
                    term = ring.mul(&term, &Poly::from(symbol));
                }
            }
            sum = &sum + &ring.mul(&Poly::from(i64::from(power)), &term);
        }
    }
    sum
}

/// Compares three nodes with three polynomials.
fn equal(motion: &mut Motion, nodes: [Id; 3], expected: &PolyVector) -> bool {
    let mut reader = Interpreter::new(&mut motion.graph, BTreeMap::new());
    nodes.iter().zip(expected).all(|(node, expected)| {
        let value = reader.value(*node);
        reader.equal(&value, expected)
    })
}

/// First and second derivatives of tip and tool axis: nodes, and the expected polynomials.
fn derivatives(model: &Model, motion: &Motion) -> Vec<(&'static str, [Id; 3], PolyVector)> {
    let ring = motion.graph.ring();
    let product = model.product();
    let slope = |vector: &PolyVector| -> PolyVector {
        std::array::from_fn(|row| derivative(&vector[row], model, motion, ring))
    };
    let (tip, axis) = (product.origin(), product.rotate(&model.tool_axis, ring));
    let (tip_rate, axis_rate) = (slope(&tip), slope(&axis));
    let (tip_bend, axis_bend) = (slope(&tip_rate), slope(&axis_rate));
    // As seen from the inner side of the outermost rotary axis.
    let outermost = model.axes.iter().position(|axis| axis.kind == AxisKind::Rotary);
    let back = outermost.map(|axis| model.joint_inverse(axis));
    let inside = |vector: &PolyVector| back.as_ref().map_or_else(|| vector.clone(), |back| back.rotate(vector, ring));
    vec![
        ("tip', inside", motion.tip.rate, inside(&tip_rate)),
        ("tip'', inside", motion.tip.bend, inside(&tip_bend)),
        ("axis, inside", motion.axis, inside(&axis)),
        ("axis', inside", motion.axis_curve.rate, inside(&axis_rate)),
        ("axis'', inside", motion.axis_curve.bend, inside(&axis_bend)),
        ("tip'", motion.rates[0], tip_rate),
        ("axis'", motion.rates[1], axis_rate),
    ]
}

#[test]
fn rates_and_bends_are_the_derivatives_of_the_product() {
    for text in CHAINS {
        let (model, mut motion) = solved(text);
        for (name, nodes, expected) in derivatives(&model, &motion) {
            assert!(equal(&mut motion, nodes, &expected), "{name} of {text}");
        }
    }
}

#[test]
fn a_flipped_sign_is_no_derivative() {
    for text in CHAINS {
        let (model, mut motion) = solved(text);
        for (name, nodes, expected) in derivatives(&model, &motion) {
            for place in 0..3 {
                let mut flawed = nodes;
                flawed[place] = motion.graph.neg(nodes[place]);
                if flawed[place] != nodes[place] {
                    assert!(!equal(&mut motion, flawed, &expected), "{name} of {text}");
                }
            }
        }
    }
}
