//! What comes out: the same tokens every time, no panic whatever goes in, and code a person can read.

use proptest::prelude::*;
use proptest::sample::select;

const SPINNER: &str = "/// A table.
    pub struct Table; chain: C B | X Y Z; d = (0, 0, d); dims = { d: 150.0 }; limits = { B: -5..110, C: free };";

fn expand(text: &str) -> String {
    pp_codegen::expand(text.parse().expect("Rust tokens")).to_string()
}

#[test]
fn same_input_gives_the_same_tokens() {
    let first = expand(SPINNER);
    expand("pub struct Other; chain: X | Y Z B A;");
    assert_eq!(expand(SPINNER), first);
}

#[test]
fn inverse_is_straight_line_code_without_sine_or_loop() {
    let file = syn::parse2(pp_codegen::expand(SPINNER.parse().expect("Rust tokens"))).expect("items");
    let text = prettyplease::unparse(&file);
    let start = text.find("fn inverse_kinematics").expect("generated");
    let end = start + text[start..].find("fn linear_axes(").expect("generated");
    let inverse = &text[start..end];
    assert_eq!(inverse.matches("math::angle").count(), 2, "{inverse}");
    assert_eq!(inverse.matches("math::sqrt").count(), 1, "{inverse}");
    assert_eq!(inverse.matches(" / ").count(), 1, "{inverse}");
    for word in ["sin_cos", "for ", "while ", "loop ", "vec!", "Box"] {
        assert!(!inverse.contains(word), "{word} in {inverse}");
    }
}

#[test]
fn generated_code_names_only_core_and_the_runtime() {
    let text = expand(SPINNER);
    for path in text.split(":: ").filter_map(|rest| rest.split_whitespace().next()) {
        assert!(!["std", "alloc", "nalgebra_", "pp_macros", "pp_codegen"].contains(&path), "{path}");
    }
}

#[test]
fn a_dimension_may_be_called_like_a_local_variable() {
    let text = expand(
        "pub struct M; chain: C B | X Y Z; d = (axes, pose, root); dims = { axes: 1, pose: 2, root: 3, sin_b: 4, b: 30 deg };",
    );
    assert!(text.contains("let dim_axes = self . axes"), "{text}");
    assert!(!text.contains("compile_error"));
}

#[test]
fn two_dimensions_never_share_a_local_variable() {
    let text = expand(
        "pub struct M; chain: C B | X Y Z; d = { C: (tip, 0, 0), B: (dim_tip, 0, 9) }; dims = { tip: 10, dim_tip: 20 };",
    );
    assert!(text.contains("let dim_tip = self . tip") && text.contains("let dim_tip_ = self . dim_tip"), "{text}");
    let text = expand(
        "pub struct M; chain: C B | X Y Z; axes = { B: Rx(a) * Y, C: Ry(dim_a) * Z }; dims = { a: 10 deg, dim_a: 40 deg };",
    );
    assert!(text.contains("(sin_dim_a , cos_dim_a) = math :: sin_cos (self . a)"), "{text}");
    assert!(text.contains("(sin_dim_a_ , cos_dim_a_) = math :: sin_cos (self . dim_a)"), "{text}");
}

/// Words that declarations are made of, right and wrong.
fn word() -> impl Strategy<Value = &'static str> {
    select(vec![
        "pub",
        "struct",
        "M",
        ";",
        "chain",
        ":",
        "|",
        "X",
        "Y",
        "Z",
        "U",
        "W",
        "A",
        "B",
        "C",
        "d",
        "=",
        "(",
        ")",
        "{",
        "}",
        ",",
        "0",
        "1.5",
        "-",
        "+",
        "*",
        "/",
        "^",
        "45 deg",
        "45deg",
        "mm",
        "Rx",
        "free",
        "..",
        "dims",
        "signs",
        "axes",
        "hold",
        "limits",
        "speeds",
        "tool_axis",
        "verify",
        "0x1",
        ".",
        "#",
        "r#type",
        "99999999999999999999",
        "1e400",
    ])
}

fn vector() -> impl Strategy<Value = String> {
    let part = || select(vec!["0", "1", "-1", "0.5", "0.123456789", "-2.75", "sqrt(2)/2", "1e-9", "70"]);
    (part(), part(), part()).prop_map(|(x, y, z)| format!("({x}, {y}, {z})"))
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 4000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn random_words_never_panic(words in prop::collection::vec(word(), 0..40)) {
        if let Ok(tokens) = format!("pub struct M; {}", words.join(" ")).parse() {
            let _ = pp_codegen::expand(tokens);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 150, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn random_chains_are_proven_or_refused(
        order in Just(vec!['X', 'Y', 'Z', 'A', 'C']).prop_shuffle(),
        bar in 0_usize..6,
        directions in prop::collection::vec(vector(), 5),
        minus in prop::collection::vec(any::<bool>(), 5),
        tool in vector(),
    ) {
        let mut chain: Vec<String> = order.iter().map(char::to_string).collect();
        chain.insert(bar, "|".into());
        let axes: Vec<String> = order.iter().zip(&directions).map(|(letter, v)| format!("{letter}: {v}")).collect();
        let signs: Vec<String> =
            order.iter().zip(&minus).map(|(letter, minus)| format!("{letter}: {}", if *minus { '-' } else { '+' })).collect();
        let text = format!(
            "pub struct M; chain: {}; axes = {{ {} }}; signs = {{ {} }}; d = {{ A: (p, 2, q), C: (q, p, 0) }};
             dims = {{ p: 10, q: 20 }}; tool_axis = {tool};",
            chain.join(" "), axes.join(", "), signs.join(", "),
        );
        let tokens = text.parse().expect("Rust tokens");
        if let Err(refused) = pp_codegen::generate(tokens, pp_codegen::Options::default()) {
            let unproven = refused.0.iter().any(|error| error.to_string().contains("could not be proven"));
            prop_assert!(!unproven, "{}", text);
        }
    }
}
