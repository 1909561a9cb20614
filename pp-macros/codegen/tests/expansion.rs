//! Generated code: the same tokens every time, and readable.

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
    let middle = start + text[start..].find("fn rotary_axes(").expect("generated");
    let end = middle + text[middle..].find("fn linear_axes(").expect("generated");
    for inverse in [&text[start..middle], &text[middle..end]] {
        assert_eq!(inverse.matches("math::angles").count(), 1, "{inverse}");
        assert_eq!(inverse.matches("math::sqrt").count(), 1, "{inverse}");
        assert!(inverse.matches(" / ").count() <= 1, "{inverse}");
        for word in ["sin_cos", "turns([", "for ", "while ", "loop ", "vec!", "Box"] {
            assert!(!inverse.contains(word), "{word} in {inverse}");
        }
    }
}

#[test]
fn curves_are_straight_line_code_with_the_sine_of_the_inner_rotary_alone() {
    let file = syn::parse2(pp_codegen::expand(SPINNER.parse().expect("Rust tokens"))).expect("items");
    let text = prettyplease::unparse(&file);
    let start = text.find("fn curves").expect("generated");
    let end = start + text[start..].find("fn rates(").expect("generated");
    let motion = &text[start..end];
    assert_eq!(motion.matches("let [(sin_b, cos_b)] = math::turns(").count(), 1, "{motion}");
    assert_eq!(motion.matches("math::turns(").count(), 1, "{motion}");
    assert!(motion.matches("math::sqrt").count() <= 9, "{motion}");
    for word in ["for ", "while ", "loop ", "vec!", "Box", "atan2", "sin_cos", "* 0.0", "* 1.0"] {
        assert!(!motion.contains(word), "{word} in {motion}");
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
        "pub struct M; chain: C B | X Y Z; d = (axes + sin_b, pose, root); axes = { C: Rx(b) * Z };
         dims = { axes: 1, pose: 2, root: 3, sin_b: 4, b: 30 deg };",
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
    assert!(text.contains("(sin_a , cos_a) = math :: sin_cos (self . a)"), "{text}");
    assert!(text.contains("(sin_dim_a , cos_dim_a) = math :: sin_cos (self . dim_a)"), "{text}");
}

#[test]
fn a_dimension_never_shares_a_local_variable_with_an_axis() {
    let text = expand(
        "pub struct M; chain: C B | X Y Z; axes = { C: Rx(b) * Z }; d = (word_x, sin_b, angle_b_1);
         dims = { sin_b: 4, b: 30 deg, word_x: 5, angle_b_1: 6 };",
    );
    let axis = "(sin_b__ , cos_b_)] = math :: turns ([axes [0usize] , axes [1usize]])";
    for line in [
        "let sin_b = self . sin_b",
        "(sin_b_ , cos_b) = math :: sin_cos (self . b)",
        axis,
        "let word_x_ = axes [2usize]",
    ] {
        assert!(text.contains(line), "{line} in {text}");
    }
}
