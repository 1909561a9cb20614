//! What `explain --verify` prints compiles: the blocks, added to their declaration, are proven.

use pp_codegen::compile;

fn compiled(text: &str) -> Result<pp_codegen::Compiled, String> {
    let tokens = format!("pub struct M; {text}").parse().expect("Rust tokens");
    compile(tokens).map_err(|refused| refused.0.iter().map(|error| format!("{error}\n")).collect())
}

/// Compiles a machine, and again with its printed blocks; the number of their equations.
fn pasted_back(text: &str) -> usize {
    let machine = compiled(text).unwrap_or_else(|errors| panic!("{text}\n{errors}"));
    let block = machine.explanation.verify.text.join("\n");
    let with = compiled(&format!("{text}\n{block}")).unwrap_or_else(|errors| panic!("{text}\n{block}\n{errors}"));
    with.verified.iter().map(|block| block.equations.len()).sum()
}

#[test]
fn printed_blocks_are_proven_for_every_kind_of_chain() {
    let expected = [
        // Six of the pose, three linear axes, and each rotary axis on each branch.
        ("chain: C B | X Y Z; d = (0, 0, d); dims = { d: 150.0 };", 13),
        ("chain: C B | X Y Z; d = (0, 0, d); dims = { d: required };", 13),
        ("chain: C A | X Y Z; d = { C: (0, 0, 0), A: (0, 1, h) }; dims = { h: 60 }; signs = { C: -, A: - };", 13),
        ("chain: C B | X Y Z; axes = { B: Rx(-45 deg) * Y }; d = (0, 0, d); dims = { d: 150.0 };", 13),
        // Angles divided by functions of a dimension are computed step by step.
        ("chain: C B | X Y Z; axes = { B: Rx(alpha) * Y }; dims = { alpha: -45 deg };", 9),
        ("chain: X | Y Z B A;", 13),
        ("chain: X Y Z | C B; d = { C: (0, 0, 0), B: (0, 0, p) }; dims = { p: 180 };", 13),
        ("chain: X Y Z | C B; axes = { B: Rx(45 deg) * Y };", 13),
        ("chain: X Y Z | C B; axes = { B: Rx(-50 deg) * Y };", 13),
        ("chain: C | X Y Z B; d = { C: (1, 2, 3), B: (4, 5, 60) };", 13),
        ("chain: A Y | X Z; signs = { A: -, Y: - };", 10),
        ("chain: A | X Y Z; d = (0, 0, h); dims = { h: 30 };", 10),
        ("chain: X Y | Z;", 9),
        ("chain: C B | X Y Z W; hold = { W: 0 };", 13),
        ("chain: C B | X Y Z; axes = { Y: (0, 1, -0.5) };", 13),
        ("chain: X C Y | A Z; d = { C: (1, 2, 3), A: (4, 5, 6) };", 13),
        ("chain: B A | X Y Z; tool_axis = (0, 0, -1);", 13),
        ("chain: C | X Y Z B; axes = { Y: Rx(30 deg) * Y };", 13),
    ];
    let found: Vec<(&str, usize)> = expected.iter().map(|(text, _)| (*text, pasted_back(text))).collect();
    assert_eq!(found, expected);
}

#[test]
fn blocks_of_oblique_machines_leave_out_what_is_too_long() {
    let text = "chain: X B Y | Z A; axes = { A: (1, 2, 2), B: (0.1, 0.7, -0.3), X: (1, 0.1, 0.2), Y: (0.05, 1, 0), Z: (0.1, 0.2, 1) };
        tool_axis = (0.1, 0.2, 0.9);";
    let machine = compiled(text).expect("a machine");
    let block = machine.explanation.verify.text.join("\n");
    println!("{block}");
    pasted_back(text);
}
