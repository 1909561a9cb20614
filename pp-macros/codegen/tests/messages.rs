//! Every refusal of the language: its text, the words it underlines, its remedy.
//!
//! Expectations stand inside the declaration: a comment line with `^` under the words and the message behind them, and
//! perhaps `help:` on the next comment line.

use pp_codegen::{Options, generate};

#[derive(Debug, PartialEq, Eq)]
struct Message {
    line: usize,
    columns: (usize, usize),
    text: String,
}

/// Compares the messages of a declaration with the comments in it, in order.
#[track_caller]
fn check_errors(declaration: &str) {
    let mut expected = Vec::new();
    let mut helps = Vec::new();
    let mut code_line = 0;
    for (index, line) in declaration.lines().enumerate() {
        let Some(comment) = line.trim_start().strip_prefix("//") else {
            code_line = index + 1;
            continue;
        };
        if let Some(help) = comment.trim_start().strip_prefix("help: ") {
            helps.push((expected.len() - 1, help.to_string()));
            continue;
        }
        let start = line.find('^').expect("a comment underlines something");
        let end = start + line[start..].chars().take_while(|c| *c == '^').count();
        let text = line[end..].trim().to_string();
        // `//^` underlines from the margin.
        let start = if start == 2 { 0 } else { start };
        expected.push(Message { line: code_line, columns: (start, end), text });
    }
    let tokens = declaration.parse().expect("the declaration is Rust tokens");
    let errors = match generate(tokens, Options::default()) {
        Ok(_) => vec![],
        Err(refused) => refused.0,
    };
    let found: Vec<(Message, String)> = errors
        .iter()
        .map(|error| {
            let (start, end) = (error.span().start(), error.span().end());
            let message = error.to_string();
            let (text, help) = message.split_once("\n\nhelp: ").unwrap_or((&message, ""));
            let columns = (start.column, if start.line == end.line { end.column } else { usize::MAX });
            (Message { line: start.line, columns, text: text.to_string() }, help.to_string())
        })
        .collect();
    let messages: Vec<&Message> = found.iter().map(|(message, _)| message).collect();
    assert_eq!(messages, expected.iter().collect::<Vec<_>>(), "in\n{declaration}");
    for (index, help) in helps {
        assert_eq!(found[index].1, help);
    }
    for (message, help) in &found {
        assert!(!help.is_empty() || message.text.starts_with("expected"), "no remedy: {message:?}");
    }
}

#[test]
fn missing_bar_underlines_the_whole_axis_list() {
    check_errors(
        "pub struct M;
chain: C B X Y Z;
//     ^^^^^^^^^ missing `|` in the kinematic chain
// help: list the workpiece-side axes, then `|`, then the tool-side axes: `chain: C B | X Y Z;`
",
    );
}

#[test]
fn double_bar_is_underlined_where_it_is_too_much() {
    check_errors(
        "pub struct M;
chain: C B || X Y Z;
//          ^ double `|` in the kinematic chain
",
    );
    check_errors(
        "pub struct M;
chain: C | B | X Y Z;
//           ^ double `|` in the kinematic chain
// help: there is one machine frame: write `|` once, between workpiece side and tool side
",
    );
}

#[test]
fn unknown_and_repeated_letters_are_reported_together() {
    check_errors(
        "pub struct M;
chain: C Q | X Y Z X;
//       ^ `Q` is not an axis letter
//                 ^ `X` stands twice in the chain
",
    );
}

#[test]
fn two_linear_axes_are_too_few() {
    check_errors(
        "pub struct M;
chain: C B | X Z;
//     ^^^^^^^^^ a machine needs three solved linear axes, found X Z
",
    );
    check_errors(
        "pub struct M;
chain: C B | X Y Z; hold = { Y: 0 };
//     ^^^^^^^^^^^ a machine needs three solved linear axes, found X Z
",
    );
}

#[test]
fn a_fourth_linear_axis_belongs_in_hold() {
    check_errors(
        "pub struct M;
chain: C B | X Y Z W;
//                 ^ `W` is a fourth linear axis: three are solved for
// help: put W in `hold`: `hold = { W: 0 };`
",
    );
}

#[test]
fn a_third_rotary_axis_belongs_in_hold() {
    check_errors(
        "pub struct M;
chain: C B | X Y Z A;
//                 ^ `A` is a third rotary axis: two tilt the tool
// help: put A in `hold`: `hold = { A: 0 };`
",
    );
}

#[test]
fn linear_axes_in_one_plane_are_refused() {
    check_errors(
        "pub struct M;
chain: C B | X Y Z; axes = { Z: (1, 1, 0) };
//     ^^^^^^^^^^^ the linear axes X Y Z cannot move the tip in every direction
",
    );
}

#[test]
fn linear_axes_that_degenerate_at_the_held_value_are_refused() {
    check_errors(
        "pub struct M;
chain: X Y A | Z; hold = { A: 90 };
//     ^^^^^^^^^ the linear axes X Y Z cannot move the tip in every direction
",
    );
}

#[test]
fn a_rotary_about_the_tool_axis_cannot_tilt_it() {
    check_errors(
        "pub struct M;
chain: B C | X Y Z;
//       ^ `C` turns about the tool axis, so it cannot tilt the tool
// help: put C in `hold`: `hold = { C: 0 };`
",
    );
    check_errors(
        "pub struct M;
chain: C | X Y Z;
//     ^ `C` turns about the tool axis, so it cannot tilt the tool
",
    );
}

#[test]
fn a_rotary_that_cannot_tilt_at_the_hold_default_is_refused() {
    check_errors(
        "pub struct M;
chain: A B | X Y Z C; axes = { B: X }; hold = { C: 0 }; tool_axis = (1, 0, 0);
//       ^ `A` and `B` turn about the same direction, so the tool cannot tilt
//       ^ `B` turns about the tool axis, so it cannot tilt the tool
",
    );
    check_errors(
        "pub struct M;
chain: C B | X Y Z A; hold = { A: -90 };
//       ^ `B` turns about the tool axis, so it cannot tilt the tool
",
    );
}

#[test]
fn two_rotaries_about_one_direction_cannot_tilt() {
    check_errors(
        "pub struct M;
chain: A B | X Y Z; axes = { B: (-2, 0, 0) };
//       ^ `A` and `B` turn about the same direction, so the tool cannot tilt
",
    );
}

#[test]
fn one_d_for_both_sides_is_refused() {
    check_errors(
        "pub struct M;
chain: C | X Y Z B;
d = (0, 0, 10);
//  ^^^^^^^^^^ one `d` for rotary axes on both sides of `|`
// help: the sides count from different points, the table's and the spindle's: write `d = { C: (0, 0, 0), B: (0, 0, 60) };`
",
    );
}

#[test]
fn lengths_and_angles_are_not_mixed_up() {
    check_errors(
        "pub struct M;
chain: C B | X Y Z;
dims = { d: 150.0, alpha: -45 deg };
axes = { B: Rx(d) * Y };
//             ^ `d` is a length where an angle is needed
d = (0, alpha, d * d);
//      ^^^^^ an angle where a length is needed
//             ^^^^^ this product is an area, not a length
",
    );
    check_errors(
        "pub struct M;
chain: C B | X Y Z;
axes = { B: Rx(45) * Y };
//             ^^ an angle needs its unit
// help: write `45 deg`
limits = { X: 0deg..5 };
//            ^^^^ an angle for a linear axis
",
    );
}

#[test]
fn a_name_that_is_not_a_dimension_lists_those_that_are() {
    check_errors(
        "pub struct M;
chain: C B | X Y Z;
dims = { height: 150.0 };
d = (0, 0, hieght);
//         ^^^^^^ `hieght` is not a dimension
// help: the dimensions are height
",
    );
}

#[test]
fn reserved_names_are_refused_by_us_and_not_by_rustc() {
    check_errors(
        "pub struct M;
chain: C B | X Y Z;
dims = { X: 1, gauge: 2, fn: 3, sqrt: 4, r#type: 5, ok: 6, ok: 7 };
//       ^ `X` cannot be the name of a dimension
//             ^^^^^ `gauge` cannot be the name of a dimension
//                       ^^ `fn` cannot be the name of a dimension
//                              ^^^^ `sqrt` cannot be the name of a dimension
//                                       ^^^^^^ `r#type` cannot be the name of a dimension
//                                                         ^^ `ok` stands twice in `dims`
",
    );
}

#[test]
fn an_empty_limit_is_refused() {
    check_errors(
        "pub struct M;
chain: C B | X Y Z;
limits = { B: 110..-5, C: free };
//            ^^^^^^^ the travel of `B` is empty
// help: write the smaller value first: `-5..110`
",
    );
}

#[test]
fn keys_must_be_axes_of_the_chain() {
    check_errors(
        "pub struct M;
chain: C B | X Y Z;
signs = { A: -, B: -, B: + };
//        ^ `A` in `signs` is not an axis of the chain
// help: the axes are C B X Y Z
//                    ^ `B` stands twice in `signs`
hold = { W: 0 };
//       ^ `W` in `hold` is not an axis of the chain
speeds = { Q: 1, X: 0 };
//         ^ `Q` in `speeds` is not an axis of the chain
//                  ^ the speed of `X` is not above zero
d = { X: (0, 0, 0) };
//    ^ `X` is a linear axis: it has no centre line
",
    );
}

#[test]
fn numbers_of_other_languages_get_a_message_of_their_own() {
    check_errors(
        "pub struct M;
chain: C B | X Y Z;
dims = { a: 0x10 };
//          ^^^^ `0x10` is not a number here
// help: write numbers in decimal digits
d = (.5, 0, 0);
//   ^ a number needs a digit before the point
// help: write 0.5 instead of .5
hold = { C: 45rad };
//          ^^^^^ `45rad` is not a number here
// help: the unit `rad` is not known: use `deg` or `mm`
",
    );
}

#[test]
fn three_mistakes_in_three_fields_are_three_messages_in_source_order() {
    check_errors(
        "pub struct M;
limits = { B: 5..1 };
//            ^^^^ the travel of `B` is empty
sings = { C: - };
//^^^ unknown field `sings`
chain: C B X Y Z;
//     ^^^^^^^^^ missing `|` in the kinematic chain
",
    );
}

#[test]
fn a_zero_vector_has_no_direction() {
    check_errors(
        "pub struct M;
chain: C B | X Y Z;
axes = { B: (0, 0.0, 0) };
//          ^^^^^^^^^^^ the vector (0, 0, 0) has no direction
tool_axis = (1, 2);
//          ^^^^^^ a vector has three components, found 2
",
    );
}

#[test]
fn a_field_given_twice_is_reported() {
    check_errors(
        "pub struct M;
chain: C B | X Y Z;
signs = { C: - };
signs = { B: - };
//^^^ `signs` is given twice
",
    );
}

#[test]
fn a_machine_without_a_chain_is_refused() {
    check_errors(
        "pub struct Mill;
//         ^^^^ the machine has no `chain`
",
    );
    check_errors(
        "chain: C B | X Y Z;
//^^^ expected `struct`
// help: begin with `pub struct MyMachine;`
",
    );
}

#[test]
fn angles_that_are_no_multiple_of_fifteen_degrees_are_exact_too() {
    check_errors(
        "pub struct M;
chain: C B | X Y Z; axes = { B: Rx(123 deg) * Y }; tool_axis = Rx(33 deg) * Z;
//       ^ `B` turns about the tool axis, so it cannot tilt the tool
",
    );
    check_errors(
        "pub struct M;
chain: C | X Y Z A; axes = { C: Rx(10 deg) * Z }; hold = { A: 10 };
//     ^ `C` turns about the tool axis, so it cannot tilt the tool
",
    );
    check_errors(
        "pub struct M;
chain: C B | X Y Z; axes = { B: Rx(al) * Ry(be) * Z }; dims = { al: 7 deg, be: 8 deg };
//       ^ `B` turns about the tool axis, so it cannot tilt the tool
tool_axis = Rx(7 deg) * Ry(8 deg) * Z;
",
    );
}

#[test]
fn nearly_parallel_rotaries_are_refused_by_the_rule_of_the_running_machine() {
    check_errors(
        "pub struct M;
chain: C B | X Y Z; axes = { B: (0, 1, 1000000) };
//       ^ `C` and `B` turn about the same direction, so the tool cannot tilt
",
    );
}

#[test]
fn numbers_beyond_every_float_are_refused() {
    check_errors(
        "pub struct M;
chain: C B | X Y Z;
dims = { d: 1e400, e: 1e300 * 1e300 };
//          ^^^^^ `1e400` is not a number here
//                    ^^^^^^^^^^^^^ this is larger than any number of the machine
d = (0, 0, 1e200 * 1e200);
//         ^^^^^^^^^^^^^ this is larger than any number of the machine
",
    );
}

#[test]
fn one_mistake_has_no_followers() {
    check_errors(
        "pub struct M;
chain: C B | X Y Z;
d = (0, 0, d);
dims = { d: ?, fn: 2 };
//          ^ expected a number or a dimension
//             ^^ `fn` cannot be the name of a dimension
signs = { B: *, Q: - };
//           ^ expected `+` or `-`
//              ^ `Q` in `signs` is not an axis of the chain
",
    );
    check_errors(
        "pub struct M;
chain: C B, | X Y Z;
//        ^ `,` does not belong in the chain
",
    );
}

#[test]
fn what_is_generated_is_not_derived_again() {
    check_errors(
        "#[derive(PartialEq, Debug)]
//                  ^^^^^ `Debug` is implemented already
pub struct M;
chain: C B | X Y Z;
",
    );
    check_errors(
        "pub struct M { d: f64 }
//           ^ expected `;` behind the name
",
    );
}
