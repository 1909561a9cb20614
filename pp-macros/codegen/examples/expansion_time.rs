//! Expansion time of a machine: the four machines of the papers, then chains with more and more unknowns.
//!
//! `cargo run -p pp-codegen --example expansion_time`

use std::time::Instant;

const DECLARATIONS: [(&str, &str); 14] = [
    ("Spinner U5-620", "chain: C B | X Y Z; d = (0, 0, d); dims = { d: 150.0 };"),
    ("DMU 70e", "chain: C B | X Y Z; axes = { B: Rx(-45 deg) * Y }; d = (0, 0, d); dims = { d: 150.0 };"),
    ("LOLA X'OYZBA", "chain: X | Y Z B A;"),
    ("MultiProDesk", "chain: A Y | X Z; signs = { A: -, Y: - };"),
    ("inclined by a symbol", "chain: C B | X Y Z; axes = { B: Rx(alpha) * Y }; dims = { alpha: -45 deg };"),
    ("held between the rotaries", "chain: C A B | X Y Z; hold = { A: 10 };"),
    ("linears between and outside", "chain: X C Y | A Z; d = { C: (1, 2, 3), A: (4, 5, 6) };"),
    (
        "two angles in each rotary",
        "chain: C B | X Y Z; axes = { C: Ry(e1) * Rx(e2) * Z, B: Rz(e3) * Rx(e4) * Y };
         dims = { e1: 0.01 deg, e2: -0.02 deg, e3: 0.03 deg, e4: 0.01 deg };",
    ),
    (
        "two angles in each rotary, first inclined",
        "chain: X Y Z | C B; axes = { C: Rx(a1) * Ry(a2) * Z, B: Rx(b1) * Rz(b2) * Y };
         dims = { a1: 0.01 deg, a2: -0.02 deg, b1: 0.03 deg, b2: 0.01 deg };",
    ),
    (
        "two angles shared by both rotaries",
        "chain: C B | X Y Z; axes = { C: Rx(a) * Ry(b) * Z, B: Rz(a) * Rx(b) * Y }; dims = { a: 1 deg, b: 2 deg };",
    ),
    (
        "two angles in both rotaries and the tool",
        "chain: C B | X Y Z; axes = { C: Rx(a) * Ry(b) * Z, B: Rx(a) * Ry(b) * Y };
         tool_axis = Rx(a) * Ry(b) * Z; dims = { a: 0.01 deg, b: -0.02 deg };",
    ),
    (
        "an angle in each of three directions",
        "chain: C B | X Y Z; axes = { B: Rx(e1) * Y, Y: Rz(e2) * Y, X: Ry(e3) * X };
         dims = { e1: 0.01 deg, e2: -0.02 deg, e3: 0.03 deg };",
    ),
    (
        "oblique, three digits",
        "chain: X A | Y C Z; axes = { A: (0.5, 7, 1), C: (0.5, 3, 1), X: (0.25, 1, 1), Z: (0, 1, -2.75), Y: (1, 2, 70) };
         d = { A: (p, 2, q), C: (q, p, 0) }; dims = { p: 10, q: 20 }; tool_axis = (sqrt(2)/2, 0.5, 1);",
    ),
    (
        "oblique, nine digits",
        "chain: X | A C Z Y; axes = { A: (0.5, 70, 1), C: (0.5, 0.123456789, 1), X: (0.123456789, 1, 1),
         Z: (0, 1, -2.75), Y: (1, 0.123456789, 70) }; d = { A: (p, 2, q), C: (q, p, 0) }; dims = { p: 10, q: 20 };
         tool_axis = (0.123456789, 0.5, 1);",
    ),
];

fn main() {
    for (name, text) in DECLARATIONS {
        let tokens = format!("pub struct M; {text}").parse().expect("Rust tokens");
        let start = Instant::now();
        let expansion = pp_codegen::expand(tokens);
        println!("{:7.1} ms  {:6} tokens  {name}", start.elapsed().as_secs_f64() * 1e3, expansion.into_iter().count());
    }
}
