//! The 120 orders whose last rotary is C: it rotates about the tool axis and cannot tilt the tool.

use super::all_orders;

/// Text of an expansion, with the messages of all `compile_error!`s.
fn messages(expansion: &proc_macro2::TokenStream) -> String {
    expansion.to_string()
}

#[test]
fn a_last_rotary_about_the_tool_axis_is_refused_with_a_remedy() {
    let mut refused = 0;
    for (place, (order, last)) in all_orders().into_iter().enumerate() {
        if last != 'C' {
            continue;
        }
        let bar = 1 + place % 4;
        let mut chain: Vec<String> = order.iter().map(char::to_string).collect();
        chain.insert(bar, "|".to_owned());
        let chain = chain.join(" ");
        let declaration = format!("pub struct Chain; chain: {chain};");
        let text = messages(&pp_codegen::expand(declaration.parse().expect("the declaration is made of tokens")));
        assert!(text.contains("compile_error"), "`{chain}` is accepted");
        assert!(text.contains('C') && text.contains("hold"), "`{chain}`: the message must name C and `hold`: {text}");
        refused += 1;
    }
    assert_eq!(refused, 120);
}

#[test]
fn two_rotaries_about_one_direction_are_refused() {
    let declaration = "pub struct Chain; chain: C B | X Y Z; axes = { C: Y };";
    let text = messages(&pp_codegen::expand(declaration.parse().expect("the declaration is made of tokens")));
    assert!(text.contains("compile_error") && text.contains('B') && text.contains('C'), "{text}");
}
