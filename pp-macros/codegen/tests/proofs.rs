//! Chains of every class are solved and proven.

use std::time::Instant;

use pp_codegen::check::check;
use pp_codegen::proof::prove;
use pp_codegen::report::Errors;
use pp_codegen::solve::solve;
use pp_codegen::syntax::parse;

fn prove_text(text: &str) -> Result<Vec<String>, String> {
    let tokens = text.parse().expect("Rust tokens");
    let mut errors = Errors::default();
    let declaration = parse(tokens, &mut errors).map_err(|e| e.to_compile_error().to_string())?;
    let (mut model, _) = check(&declaration, &mut errors).map_err(|e| e.to_compile_error().to_string())?;
    let start = Instant::now();
    let mut solved = solve(&mut model).map_err(|refusals| format!("{refusals:?}"))?;
    let solve_time = start.elapsed();
    let claims = prove(&model, &mut solved)?;
    println!("solve {solve_time:?} prove {:?}", start.elapsed() - solve_time);
    Ok(claims)
}

macro_rules! proven {
    ($($name:ident: $text:expr;)*) => {$(
        #[test]
        fn $name() {
            match prove_text(concat!("pub struct M; ", $text)) {
                Ok(claims) => println!("{claims:#?}"),
                Err(error) => panic!("{error}"),
            }
        }
    )*};
}

proven! {
    spinner: "chain: C B | X Y Z; d = (0, 0, d); dims = { d: 150.0 };";
    dmu: "chain: C B | X Y Z; axes = { B: Rx(-45 deg) * Y }; d = (0, 0, d); dims = { d: 150.0 };";
    lola: "chain: X | Y Z B A;";
    multiprodesk: "chain: A Y | X Z; signs = { A: -, Y: - };";
    inclined_by_a_symbol: "chain: C B | X Y Z; axes = { B: Rx(alpha) * Y }; dims = { alpha: -45 deg };";
    inclined_by_fifty: "chain: C B | X Y Z; axes = { B: Rx(-50 deg) * Y };";
    slanted: "chain: C B | X Y Z; axes = { Y: (0, 1, -0.5) };";
    spread_linears: "chain: X C Y | A Z; d = { C: (1, 2, 3), A: (4, 5, 6) };";
    held_quill: "chain: C B | X Y Z W; hold = { W: 0 };";
    held_head: "chain: C B | X Y Z A; hold = { A: 0 };";
    oblique: "chain: X B Y | Z A; axes = { A: (1, 2, 2), B: (0.1, 0.7, -0.3), X: (1, 0.1, 0.2), Y: (0.05, 1, 0), Z: (0.1, 0.2, 1) }; d = { B: (1, d, 3), A: (4, 5, d) }; dims = { d: 10.0 }; tool_axis = (0.1, 0.2, 0.9);";
    no_rotary: "chain: X Y | Z;";
    one_inclined: "chain: B | X Y Z; axes = { B: (0, 1, 1) };";
    held_between: "chain: C A B | X Y Z; hold = { A: 10 };";
}
