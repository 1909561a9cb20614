//! Chains of every class are solved and proven, and a wrong formula is not.

use std::collections::BTreeMap;

use pp_codegen::check::check;
use pp_codegen::model::Model;
use pp_codegen::proof::prove;
use pp_codegen::report::Errors;
use pp_codegen::solve::{AngleRelation, Orientation, Solved, solve};
use pp_codegen::symbolic::{Id, Interpreter, SineCosine};
use pp_codegen::syntax::parse;

fn solved(text: &str) -> (Model, Solved) {
    let tokens = format!("pub struct M; {text}").parse().expect("Rust tokens");
    let mut errors = Errors::default();
    let declaration = parse(tokens, &mut errors).expect("syntax");
    let model = check(&declaration, &mut errors).expect("rules").model;
    let solved = solve(&model).expect("a solvable chain");
    (model, solved)
}

macro_rules! proven {
    ($($name:ident: $text:expr;)*) => {
        /// All declarations of this file.
        const ALL: &[&str] = &[$($text),*];
        $(
            #[test]
            fn $name() {
                let (model, solved) = solved($text);
                let claims = prove(&model, &solved).unwrap_or_else(|claim| panic!("not proven: {claim}"));
                assert!(claims.len() >= 3);
            }
        )*
    };
}

proven! {
    table_table: "chain: C B | X Y Z; d = (0, 0, d); dims = { d: 150.0 };";
    inclined_table: "chain: C B | X Y Z; axes = { B: Rx(-45 deg) * Y }; d = (0, 0, d); dims = { d: 150.0 };";
    head_head: "chain: X | Y Z B A;";
    head_table: "chain: C | X Y Z B; d = { C: (1, 2, 3), B: (4, 5, 60) };";
    one_table_rotary_with_signs: "chain: A Y | X Z; signs = { A: -, Y: - };";
    one_inclined_rotary: "chain: B | X Y Z; axes = { B: (0, 1, 1) };";
    no_rotary: "chain: X Y | Z;";
    inclined_by_a_dimension: "chain: C B | X Y Z; axes = { B: Rx(alpha) * Y }; dims = { alpha: -45 deg };";
    inclined_by_two_dimensions: "chain: C B | X Y Z; axes = { B: Rz(a) * Rx(b) * Y }; dims = { a: 1 deg, b: 2 deg };";
    inclined_together_by_two_dimensions: "chain: C B | X Y Z; axes = { C: Rx(a) * Ry(b) * Z, B: Rx(a) * Ry(b) * Y };
        tool_axis = Rx(a) * Ry(b) * Z; dims = { a: 1 deg, b: 2 deg };";
    inclined_by_fifty_degrees: "chain: C B | X Y Z; axes = { B: Rx(-50 deg) * Y };";
    inclined_head: "chain: X Y Z | C B; axes = { B: Rx(45 deg) * Y }; signs = { B: - };";
    slanted_linear: "chain: C B | X Y Z; axes = { Y: (0, 1, -0.5) };";
    linears_between_and_outside: "chain: X C Y | A Z; d = { C: (1, 2, 3), A: (4, 5, 6) };";
    held_quill: "chain: C B | X Y Z W; hold = { W: 0 };";
    held_head: "chain: C B | X Y Z A; hold = { A: 0 };";
    held_between_the_rotaries: "chain: C A B | X Y Z; hold = { A: 10 };";
    held_next_to_the_workpiece: "chain: A C B | X Y Z; hold = { A: 30 };";
    horizontal_spindle: "chain: B A | X Y Z; tool_axis = (0, 0, -1);";
    oblique_everywhere: "chain: X B Y | Z A; axes = { A: (1, 2, 2), B: (0.1, 0.7, -0.3), X: (1, 0.1, 0.2),
        Y: (0.05, 1, 0), Z: (0.1, 0.2, 1) }; d = { B: (1, d, 3), A: (4, 5, d) }; dims = { d: 10.0 };
        tool_axis = (0.1, 0.2, 0.9);";
}

/// Replaces one output node at a time by its negative; every such machine must fail its proof.
#[test]
fn a_flipped_sign_in_any_output_is_not_proven() {
    for text in ALL {
        let (model, reference) = solved(text);
        for index in 0..outputs(&mut solved(text).1).len() {
            let mut flawed = Solved { graph: reference.graph.clone(), ..solved(text).1 };
            let old = *outputs(&mut flawed)[index];
            let new = flawed.graph.neg(old);
            let value = Interpreter::new(&mut flawed.graph, BTreeMap::new()).value(old);
            if value.is_zero() {
                continue;
            }
            *outputs(&mut flawed)[index] = new;
            assert!(prove(&model, &flawed).is_err(), "output {index} of {text}");
        }
    }
}

#[test]
fn sine_and_cosine_swapped_are_not_proven() {
    let swap = |word: &mut SineCosine| *word = SineCosine { sine: word.cosine, cosine: word.sine };
    for text in ALL {
        let (model, mut flawed) = solved(text);
        match &mut flawed.orientation {
            Orientation::Fixed { .. } => continue,
            Orientation::One(one) => swap(&mut one.word),
            Orientation::Two(two) => swap(&mut two.branches[0].words[1]),
        }
        assert!(prove(&model, &flawed).is_err(), "{text}");
    }
}

#[test]
fn the_first_branch_is_the_one_that_the_papers_print() {
    let first = |text: &str| {
        let (model, solved) = solved(text);
        let proofs = prove(&model, &solved).expect("proven");
        pp_codegen::explain::explain(&model, &solved, proofs, &[]).branches.text[0].clone()
    };
    assert_eq!(first("chain: C B | X Y Z;"), "first branch:  sin B >= 0");
    assert_eq!(first("chain: C B | X Y Z; signs = { B: - };"), "first branch:  sin B >= 0");
    assert_eq!(first("chain: A B | X Y Z;"), "first branch:  cos B >= 0");
    assert_eq!(first("chain: X | Y Z B A; signs = { A: - };"), "first branch:  cos A >= 0");
    let turned = "chain: A B | X Y Z; axes = { A: Ry(33 deg) * X }; tool_axis = Ry(33 deg) * Z;";
    assert_eq!(first(turned), "first branch:  cos B >= 0");
}

#[test]
fn second_branch_of_an_orthogonal_machine_needs_no_atan2_of_its_own() {
    let angles = |text: &str| match solved(text).1.orientation {
        Orientation::Two(two) => two.branches[1].angles,
        _ => unreachable!("two rotaries"),
    };
    assert_eq!(angles("chain: C B | X Y Z;"), [AngleRelation::HalfTurn, AngleRelation::Negated]);
    assert_eq!(angles("chain: X | Y Z B A;"), [AngleRelation::HalfTurn, AngleRelation::Mirrored]);
    assert_eq!(
        angles("chain: C B | X Y Z; axes = { B: Rx(-45 deg) * Y };"),
        [AngleRelation::Own, AngleRelation::Negated]
    );
    let leaning = "chain: C B | X Y Z; axes = { C: Rx(33 deg) * Z, B: Rx(33 deg) * Y }; tool_axis = Rx(33 deg) * Z;";
    assert_eq!(angles(leaning), [AngleRelation::HalfTurn, AngleRelation::Negated]);
}

fn outputs(solved: &mut Solved) -> Vec<&mut Id> {
    let mut list: Vec<&mut Id> = solved.forward.tip.iter_mut().chain(&mut solved.forward.axis).collect();
    list.extend(solved.position.values.iter_mut().map(|(_, node)| node));
    list.extend(solved.directions.iter_mut().chain(&mut solved.centres).chain([&mut solved.tool_axis]).flatten());
    match &mut solved.orientation {
        Orientation::Fixed { .. } => {}
        Orientation::One(one) => list.extend([&mut one.word.sine, &mut one.word.cosine]),
        Orientation::Two(two) => {
            for branch in &mut two.branches {
                for word in &mut branch.words {
                    list.extend([&mut word.sine, &mut word.cosine]);
                }
            }
            let edge = &mut two.edge;
            list.extend([&mut edge.second.sine, &mut edge.second.cosine, &mut edge.first.sine, &mut edge.first.cosine]);
            list.extend([&mut edge.reached_squared, &mut edge.along.1, &mut edge.first_squared]);
        }
    }
    list
}
