//! Every refusal of the language: its message, the words it underlines, its help line.
//!
//! Expectations are written inside the declaration: a comment line with `^` under the words, followed by the message.
//! The next comment lines may have further lines of the message after `|`, and its `help:`.

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
        if let Some(more) = comment.trim_start().strip_prefix("| ") {
            let last: &mut Message = expected.last_mut().expect("a message goes on");
            last.text += &format!("\n{more}");
            continue;
        }
        if let Some(help) = comment.trim_start().strip_prefix("help: ") {
            helps.push((expected.len() - 1, help.to_string()));
            continue;
        }
        let start = line.find('^').expect("a comment underlines something");
        let end = start + line[start..].chars().take_while(|c| *c == '^').count();
        let text = line[end..].trim().to_string();
        // `//^` underlines from the margin.
        let (start, end) = if start == 2 { (0, if end == 3 { 1 } else { end }) } else { (start, end) };
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
fn the_second_bar_of_two_is_underlined() {
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
// help: the machine frame (the bed) is in the chain once: write one `|`, between the axes of the workpiece side and those of the tool side
",
    );
}

#[test]
fn unknown_and_repeated_letters_are_reported_together() {
    check_errors(
        "pub struct M;
chain: C Q | X Y Z X;
//       ^ `Q` is not an axis letter
//                 ^ `X` is listed twice in the chain
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
//                 ^ `W` is a fourth linear axis, but exactly three are solved for
// help: put W in `hold`: `hold = { W: 0 };`
",
    );
}

#[test]
fn a_third_rotary_axis_belongs_in_hold() {
    check_errors(
        "pub struct M;
chain: C B | X Y Z A;
//                 ^ `A` is a third rotary axis, but at most two are solved for
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
//       ^ `C` rotates about the tool axis, so it cannot tilt the tool
// help: put C in `hold`: `hold = { C: 0 };`
",
    );
    check_errors(
        "pub struct M;
chain: C | X Y Z;
//     ^ `C` rotates about the tool axis, so it cannot tilt the tool
",
    );
}

#[test]
fn a_rotary_that_cannot_tilt_at_the_hold_default_is_refused() {
    check_errors(
        "pub struct M;
chain: A B | X Y Z C; axes = { B: X }; hold = { C: 0 }; tool_axis = (1, 0, 0);
//       ^ `A` and `B` rotate about the same direction, so they act as one axis
//       ^ `B` rotates about the tool axis, so it cannot tilt the tool
",
    );
    check_errors(
        "pub struct M;
chain: C B | X Y Z A; hold = { A: -90 };
//       ^ `B` rotates about the tool axis, so it cannot tilt the tool
",
    );
}

#[test]
fn two_rotaries_about_one_direction_cannot_tilt() {
    check_errors(
        "pub struct M;
chain: A B | X Y Z; axes = { B: (-2, 0, 0) };
//       ^ `A` and `B` rotate about the same direction, so they act as one axis
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
// help: give a point for each rotary axis, on the workpiece side from the reference point of the table, on the tool side from the gauge line of the spindle: for example `d = { C: (0, 0, 0), B: (0, 0, 60) };`
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
//             ^ expected an angle, but `d` is a length
d = (0, alpha, d * d);
//      ^^^^^ expected a length, found an angle
//             ^^^^^ this product is an area, not a length
",
    );
    check_errors(
        "pub struct M;
chain: C B | X Y Z;
axes = { B: Rx(45) * Y };
//             ^^ an angle needs a unit
// help: add the unit, for example `45 deg`
limits = { X: 0deg..5 };
//            ^^^^ `X` is a linear axis, but its value is an angle
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
fn reserved_names_are_refused_here_and_not_by_rustc() {
    check_errors(
        "pub struct M;
chain: C B | X Y Z;
dims = { X: 1, gauge: 2, fn: 3, sqrt: 4, r#type: 5, ok: 6, ok: 7 };
//       ^ `X` cannot be the name of a dimension
//             ^^^^^ `gauge` cannot be the name of a dimension
//                       ^^ `fn` cannot be the name of a dimension
//                              ^^^^ `sqrt` cannot be the name of a dimension
//                                       ^^^^^^ `r#type` cannot be the name of a dimension
//                                                         ^^ `ok` is given twice in `dims`
",
    );
}

#[test]
fn an_empty_limit_is_refused() {
    check_errors(
        "pub struct M;
chain: C B | X Y Z;
limits = { B: 110..-5, C: free };
//            ^^^^^^^ the travel of `B` is empty: its lower end is above its upper end
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
//                    ^ `B` is given twice in `signs`
hold = { W: 0 };
//       ^ `W` in `hold` is not an axis of the chain
speeds = { Q: 1, X: 0 };
//         ^ `Q` in `speeds` is not an axis of the chain
//                  ^ the speed of `X` must be above zero
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
//          ^^^^ `0x10` is not a valid number
// help: write numbers in decimal digits
d = (.5, 0, 0);
//   ^ a number needs a digit before the point
// help: write 0.5 instead of .5
hold = { C: 45rad };
//          ^^^^^ `45rad` is not a valid number
// help: unknown unit `rad`: use `deg` or `mm`
",
    );
}

#[test]
fn three_mistakes_in_three_fields_are_three_messages_in_source_order() {
    check_errors(
        "pub struct M;
limits = { B: 5..1 };
//            ^^^^ the travel of `B` is empty: its lower end is above its upper end
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
//^^^ the field `signs` is given twice
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
//       ^ `B` rotates about the tool axis, so it cannot tilt the tool
",
    );
    check_errors(
        "pub struct M;
chain: C | X Y Z A; axes = { C: Rx(10 deg) * Z }; hold = { A: 10 };
//     ^ `C` rotates about the tool axis, so it cannot tilt the tool
",
    );
    check_errors(
        "pub struct M;
chain: C B | X Y Z; axes = { B: Rx(al) * Ry(be) * Z }; dims = { al: 7 deg, be: 8 deg };
//       ^ `B` rotates about the tool axis, so it cannot tilt the tool
tool_axis = Rx(7 deg) * Ry(8 deg) * Z;
",
    );
}

#[test]
fn nearly_parallel_rotaries_are_refused_with_the_tolerance_of_the_generated_code() {
    check_errors(
        "pub struct M;
chain: C B | X Y Z; axes = { B: (0, 1, 1000000) };
//       ^ `C` and `B` rotate about the same direction, so they act as one axis
",
    );
}

#[test]
fn numbers_beyond_every_float_are_refused() {
    check_errors(
        "pub struct M;
chain: C B | X Y Z;
dims = { d: 1e400, e: 1e300 * 1e300 };
//          ^^^^^ `1e400` is not a valid number
//                    ^^^^^^^^^^^^^ this number is too large
d = (0, 0, 1e200 * 1e200);
//         ^^^^^^^^^^^^^ this number is too large
",
    );
}

#[test]
fn one_mistake_gives_one_message() {
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
fn derive_of_a_generated_trait_and_a_struct_body_are_refused() {
    check_errors(
        "#[derive(PartialEq, Debug)]
//                  ^^^^^ `Debug` is already generated by `machine!`
pub struct M;
chain: C B | X Y Z;
",
    );
    check_errors(
        "pub struct M { d: f64 }
//           ^ expected `;` after the name
",
    );
}

#[test]
fn arithmetic_that_gives_no_number_is_refused() {
    check_errors(
        "pub struct M;
chain: C B | X Y Z;
dims = { a: d, b: 5 / 0, c: 5mm + 3deg, e: 2mm * 3mm, f: (2 deg) ^ 2, g: sqrt(2), h: 1 / 2mm };
//          ^ `d` is not a number
// help: only numbers are allowed here, such as `150.0` or `45 deg`
//                    ^ division by zero
//                          ^^^^^^^^^^ these units cannot be combined
// help: add and subtract equal units, multiply and divide by plain numbers
//                                         ^^^^^^^^^ these units cannot be combined
//                                                       ^^^^^^^^^^^ these units cannot be combined
//                                                                       ^^^^^^^ expected a rational number
// help: write it in decimal digits
//                                                                                   ^^^^^^^ these units cannot be combined
hold = { C: sqrt(0 - 2), B: sin(1) }; speeds = { X: sqrt(4 deg) };
//          ^^^^^^^^^^^ `sqrt` takes a rational number that is not negative
// help: for example `sqrt(2)/2`
//                          ^^^^^^ the only function allowed here is `sqrt` of a number
//                                                  ^^^^^^^^^^^ these units cannot be combined
",
    );
    check_errors(
        "pub struct M;
chain: C B | X Y Z;
d = (1 / 0, 2 deg, 3);
//       ^ division by zero
// help: give a divisor that is not zero
//          ^^^^^ expected a length, found an angle
// help: components of `d` are lengths in mm
tool_axis = (0, 1mm, 1);
//              ^^^ a component of a direction has no unit
// help: write plain numbers: `(0, 1, -0.5)`
",
    );
}

#[test]
fn rotations_take_angles_only() {
    check_errors(
        "pub struct M;
chain: C B | X Y Z;
dims = { alpha: 5 deg };
axes = { C: Rx(5mm) * Z, B: Ry(alpha / 2) * Y, X: Rz(0.5 * alpha) * X, Y: Rz(lost) * Y };
//             ^^^ expected an angle, found a length
// help: add the unit, for example `45 deg`
//                             ^^^^^^^^^ this is not an angle
// help: write degrees or an angle of `dims`: `Rx(-45 deg)`, `Rx(alpha)`
//                                                   ^^^ an angle can be multiplied only by a whole number up to 24
// help: write `2 * alpha`
//                                                                           ^^^^ `lost` is not a dimension
",
    );
}

#[test]
fn an_axis_value_has_the_unit_of_its_axis() {
    check_errors(
        "pub struct M;
chain: C B | X Y Z;
limits = { B: 0..5mm, X: -1 deg..1 };
//               ^^^ `B` is a rotary axis, but its value is a length
// help: give values of rotary axes in degrees, of linear axes in mm
//                       ^^^^^^ `X` is a linear axis, but its value is an angle
",
    );
}

#[test]
fn d_without_a_rotary_is_refused() {
    check_errors(
        "pub struct M;
chain: X Y | Z;
d = (0, 0, 10);
//  ^^^^^^^^^^ `d` is given, but the chain has no rotary axis
// help: remove `d`
",
    );
}

#[test]
fn the_help_for_an_undeclared_dimension_is_its_declaration() {
    check_errors(
        "pub struct M;
chain: C B | X Y Z;
d = (0, 0, height);
//         ^^^^^^ `height` is not a dimension
// help: declare it: `dims = { height: 100.0 };`
",
    );
}

#[test]
fn literals_of_rust_that_are_no_numbers_are_refused() {
    check_errors(
        "pub struct M;
chain: C B | X Y Z;
dims = { a: \"5\", b: 1e999, c: 1e9999999999 };
//          ^^^ `\"5\"` is not a valid number
// help: write a decimal number such as 150.0, followed by `deg` or `mm` if it has a unit
//                  ^^^^^ `1e999` is not a valid number
//                            ^^^^^^^^^^^^ `1e9999999999` is not a valid number
",
    );
    let digits = "1".repeat(401);
    check_errors(&format!(
        "pub struct M;
chain: C B | X Y Z;
dims = {{ a: {digits} }};
//          {} `{digits}` is not a valid number
// help: write at most 400 digits
",
        "^".repeat(401)
    ));
}

#[test]
fn expressions_end_where_they_should() {
    check_errors(
        "pub struct M;
chain: C B | X Y Z;
dims = { a: 2 ^ 65, b: 2 ^ 1.5, c: (1 2), e: };
//              ^^ an exponent must be a whole number up to 64, nested exponents multiplied
// help: write `a ^ 2`
//                         ^^^ an exponent must be a whole number up to 64, nested exponents multiplied
//                                    ^ expected `)`
// help: close the parenthesis
//                                           ^ unexpected end of input, expected a number or a dimension
// help: for example `150.0`, `45 deg` or `d + 10`
",
    );
    let open = "(".repeat(70);
    let close = ")".repeat(70);
    check_errors(&format!(
        "pub struct M;
chain: C B | X Y Z;
dims = {{ a: {open}1{close} }};
//          {}^ parentheses are nested too deeply
// help: use at most 64 levels of parentheses
",
        " ".repeat(65)
    ));
}

#[test]
fn the_chain_takes_a_colon() {
    check_errors(
        "pub struct M;
chain = C B | X Y Z;
//    ^ expected `:`
// help: `chain` is followed by a colon: `chain: C B | X Y Z;`
",
    );
}

#[test]
fn entries_are_asked_for_in_braces() {
    check_errors(
        "pub struct M;
chain: C B | X Y Z;
  d: (0, 0, 0);
// ^ expected `=`
// help: `d` is followed by `=`: `d = ...;`
signs = C: -;
//      ^ expected `{`
// help: write `{ NAME: value, NAME: value }`
dims = { d = 5, 7: 3, e: 1 2 };
//         ^ expected `:`
// help: write `NAME: value`
//              ^ expected a name
// help: write `NAME: value`
//                         ^ expected `,`
// help: separate the entries with commas
hold = { C: 0 }
limits = { C: free };
//^^^^ expected `;`
// help: end the field `hold` with a semicolon
",
    );
}

#[test]
fn directions_are_vectors_or_rotated_coordinate_axes() {
    check_errors(
        "pub struct M;
chain: C B | X Y Z;
axes = { C: Q, B: Rx * Y, X: Rx(1 deg), Y: Rx(1 deg, 2 deg) * Y, Z: 5 };
//          ^ `Q` is not a direction
// help: write X, Y, Z or a vector, with rotations Rx(...), Ry(...), Rz(...) before it: `Rx(-45 deg) * Y`
//                   ^ expected `(`
// help: write `Rx(45 deg) * Y`
//                                    ^ expected `*`
// help: write the direction that is rotated: `Rx(...) * Y`
//                                                 ^ expected `)`
// help: a rotation has one angle: `Rx(45 deg) * Y`
//                                                                  ^ expected a direction
// help: write a rotated coordinate axis such as `Rx(-45 deg) * Y`, or a vector `(0, 1, -0.5)`
d = { C: 5, B: (1 2 3) };
//       ^ expected `(`
// help: write three components: `(0, 0, 150.0)`
//                ^ expected `,`
// help: separate the components with commas
",
    );
}

#[test]
fn travel_is_written_with_two_dots() {
    check_errors(
        "pub struct M;
chain: C B | X Y Z;
limits = { B: 5, C: 0..=5, X: 0...5 };
//             ^ expected `..`
// help: write the travel as `-5..110`, or `free`
//                   ^ expected `..`
// help: both ends belong to the travel: write `-5..110`
//                             ^ expected `..`
",
    );
}

#[test]
fn a_field_begins_with_its_name() {
    check_errors(
        "pub struct M;
chain: C B | X Y Z; 5 = 3;
//                  ^ expected a field
// help: the fields are `chain`, `d`, `signs`, `axes`, `dims`, `tool_axis`, `hold`, `limits`, `speeds`, `verify`
",
    );
}

/// (12) of Maletić and Živanović 2023 as printed: it contradicts their (9).
#[test]
fn a_cosine_that_became_a_sine_is_named() {
    check_errors(
        "pub struct Lola;
chain: X | Y Z B A;
verify \"LOLA, eq. (12) as printed\" {
    X = x + gauge * sin(B) * sin(A);
//  ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^ this equation for `X` does not follow from the chain
//  |   derived:    X = x + gauge * sin(B) * cos(A)
//  |   difference: -gauge * (sin(A) - cos(A)) * sin(B)
// help: write `cos(A)` in place of `sin(A)`
}
",
    );
}

/// (4) of My et al. with the minus that one copy lost.
#[test]
fn a_lost_sign_is_named() {
    check_errors(
        "pub struct Spinner;
chain: C B | X Y Z; d = (0, 0, d); dims = { d: 150.0 };
verify \"Spinner U5-620, eq. (4) with the lost sign\" {
    Y = x * sin(C) + y * cos(C);
//  ^^^^^^^^^^^^^^^^^^^^^^^^^^^ this equation for `Y` does not follow from the chain
//  |   derived:    Y = -x * sin(C) + y * cos(C)
//  |   difference: -2 * x * sin(C)
// help: write `-x * sin(C)` in place of `x * sin(C)`
}
",
    );
}

/// (6) and (7) of My et al. as printed contradict their own `R_alpha` of (10).
#[test]
fn an_angle_measured_from_another_direction_is_named() {
    check_errors(
        "pub struct Dmu;
chain: C B | X Y Z; axes = { B: Rx(alpha) * Y }; dims = { alpha: -45 deg };
verify \"DMU 70e, eqs. (6) and (7) as printed\" {
    B = acos((k - cos(alpha)^2) / sin(alpha)^2);
//  ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^ this equation for `B` does not follow from the chain
//  |   not zero:   -(1 - 2 * sin(alpha)^2) * (1 - cos(B)) * sin(alpha)^2
// help: exchange `sin(alpha)` and `cos(alpha)` wherever they occur
    C = atan2(-(j * sin(alpha) * sin(B) + i * sin(alpha) * cos(alpha) * (1 - cos(B))), -i * sin(alpha) * sin(B) + j * sin(alpha) * cos(alpha) * (1 - cos(B)));
//  ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^ this equation for `C` does not follow from the chain
//  |   not zero:   (sin(alpha) + cos(alpha)) * (1 - cos(B)) * cos(alpha) * sin(B) * sin(alpha)
// help: no single change makes it true; compare `signs`, `d` and `axes` with the source as well
}
",
    );
}

#[test]
fn a_missing_term_is_found() {
    check_errors(
        "pub struct Spinner;
chain: C B | X Y Z; d = (0, 0, d); dims = { d: 150.0 };
verify \"from memory\" {
    Z = x * sin(B) * cos(C) + y * sin(B) * sin(C) + z * cos(B) + d;
//  ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^ this equation for `Z` does not follow from the chain
//  |   derived:    Z = (x * cos(C) + y * sin(C)) * sin(B) + (z - d) * cos(B) + d
//  |   difference: -d * cos(B)
// help: add `- d * cos(B)`
}
",
    );
}

#[test]
fn an_axis_that_the_source_counts_in_the_opposite_direction_is_named() {
    check_errors(
        "pub struct M;
chain: C B | X Y Z;
verify \"a control whose B rotates in the opposite direction\" {
    Z = -x * sin(B) * cos(C) - y * sin(B) * sin(C) + z * cos(B);
//  ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^ this equation for `Z` does not follow from the chain
//  |   derived:    Z = (x * cos(C) + y * sin(C)) * sin(B) + z * cos(B)
//  |   difference: 2 * (x * cos(C) + y * sin(C)) * sin(B)
// help: it is true with `-B` in place of `B`: the source counts B in the opposite direction; if the machine does so as well, declare `signs = { B: - };`
}
",
    );
}

#[test]
fn a_formula_that_is_right_on_no_branch_is_refused() {
    check_errors(
        "pub struct M;
chain: A | X Y Z;
verify \"half a turn off\" {
    A = atan2(j, -k);
//  ^^^^^^^^^^^^^^^^ this formula gives `A + 180 deg` at every pose
// help: change the sign of both arguments
    A = acos(k + 2 - 2 * k);
//  ^^^^^^^^^^^^^^^^^^^^^^^ this equation for `A` does not follow from the chain
//  |   derived:    A = atan2(-j, k)
//  |   not zero:   2 * (1 - cos(A))
}
",
    );
}

#[test]
fn names_and_kinds_of_an_equation_are_checked() {
    check_errors(
        "pub struct M;
chain: C B | X Y Z; dims = { d: 1, alpha: 45 deg };
verify \"kinds\" {
    i = sin(X);
//          ^ `X` is not an angle
    i = sin(B) + q;
//               ^ unknown name `q` in `verify`
// help: the names are x y z i j k, the axes C B X Y Z, d, alpha, gauge, part_x, part_y, part_z, and names given by `where`
    B = 2 * k;
//  ^^^^^^^^^ one side is an angle, the other is a number
    X = 2 * B;
//  ^^^^^^^^^ one side is an angle, the other is a number
    X = B + 1;
//      ^^^^^ an angle and a number cannot be added or subtracted
    X = B * d;
//      ^^^^^ an angle can be multiplied only by a whole number up to 24
    X = B / 2;
//      ^^^^^ an angle can be added to or subtracted from an angle, or multiplied by a whole number
    k = sqrt(C);
//           ^ expected a number, but `C` is an angle
    k = tan(B);
//      ^^^^^^ `tan` is not a function of `verify`
    k = cos(B, C);
//      ^^^^^^^^^ `cos` takes one argument, found 2
    B = atan2(k);
//      ^^^^^^^^ `atan2` takes two arguments, found 1
    k = sqrt(1 - 2);
//           ^^^^^ the number under the root is negative
    k = 1 / (i^2 + j^2 + k^2 - 1);
//          ^^^^^^^^^^^^^^^^^^^^^ the divisor `i^2 + j^2 + k^2 - 1` is zero at every pose of this machine
    k = (x + y + z + d)^64;
//      ^^^^^^^^^^^^^^^^^^ this expression is too large to be decided
}
",
    );
}

#[test]
fn assumptions_of_a_block_are_checked() {
    check_errors(
        "pub struct M;
chain: C B | X Y Z; dims = { d: 1, alpha: 45 deg };
verify \"assumptions\" {
    where alpha = 3;
//                ^ an angle needs a unit
    where d = 1; where d = 2;
//                     ^ `d` is given twice by `where`
    where B = 0 deg;
//        ^ `where` cannot give a value to `B`
    where x = 1;
//        ^ `where` cannot give a value to `x`
    where gauge = q;
//                ^ `q` is not a dimension
    k = cos(B);
}
",
    );
}

#[test]
fn the_form_of_a_block_is_explained() {
    check_errors(
        "pub struct M;
chain: C B | X Y Z;
verify \"form\" {
    k cos(B);
//    ^^^ expected `=`
// help: an equation has two sides: `X = x * cos(C) + y * sin(C);`
    k = cos(B) sin(C);
//             ^^^ expected `;`
// help: end every equation with a semicolon; products are written with `*`
    where = 3;
//        ^ expected a name
// help: give the name a value, for example `where alpha = -45 deg;`
    where alpha 3;
//              ^ expected `=`
    k = cos(B)
}
//^ unexpected end of input, expected `;`
verify { k = cos(B); }
//     ^ expected the source of the equations in quotes
",
    );
}
