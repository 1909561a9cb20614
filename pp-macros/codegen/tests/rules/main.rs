//! Every rewrite rule of the symbolic engine: true for random values, and not applied where its condition does not
//! hold.
//!
//! A module for each rule of the table in `symbolic`. Values are made with floats, independently of the rule.

mod angles;
mod graph;
mod ring;
mod surds;

use std::collections::BTreeMap;

use num_rational::BigRational;
use pp_codegen::symbolic::{Graph, Id, Interpreter, Poly, Ring, Surd, Symbol};
use proptest::prelude::*;

#[test]
fn every_rule_of_the_table_has_its_tests() {
    let rules: Vec<String> = include_str!("../../src/symbolic/mod.rs")
        .lines()
        .filter_map(|line| line.strip_prefix("//! | `")?.split_once('`'))
        .map(|(rule, _)| rule.replace('-', "_"))
        .collect();
    let files =
        [include_str!("ring.rs"), include_str!("surds.rs"), include_str!("angles.rs"), include_str!("graph.rs")];
    let tests: Vec<&str> = files
        .iter()
        .flat_map(|file| file.lines())
        .filter_map(|line| line.strip_prefix("mod ")?.strip_suffix(" {"))
        .collect();
    assert_eq!(rules, tests);
}

/// The value of `poly` in floats.
fn value(ring: &Ring, poly: &Poly, of: &[(Symbol, f64)]) -> f64 {
    let of: BTreeMap<Symbol, f64> = of.iter().copied().collect();
    ring.evaluate(poly, &|symbol| of.get(&symbol).copied()).expect("every symbol has a value")
}

#[track_caller]
fn assert_close(a: f64, b: f64) {
    assert!((a - b).abs() <= 1e-9 * (1.0 + a.abs().max(b.abs())), "{a} is not {b}");
}

fn power(ring: &Ring, base: &Poly, exponent: u32) -> Poly {
    (0..exponent).fold(Poly::one(), |product, _| ring.mul(&product, base))
}

fn degrees(numerator: i64, denominator: i64) -> BigRational {
    BigRational::new(numerator.into(), denominator.into())
}

fn root(number: i64) -> Surd {
    Surd::from(number).sqrt().expect("a small number")
}

/// Inputs named after the letters.
fn inputs<const N: usize>(graph: &mut Graph, names: [&str; N]) -> [(Symbol, Id); N] {
    names.map(|name| {
        let symbol = graph.symbol(name);
        (symbol, graph.input(symbol))
    })
}

fn evaluate(graph: &Graph, id: Id, of: &[(Symbol, f64)]) -> f64 {
    let of: BTreeMap<Symbol, f64> = of.iter().copied().collect();
    graph.evaluate(id, &|symbol| of.get(&symbol).copied())
}
