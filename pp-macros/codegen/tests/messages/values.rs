//! Numbers, units, names of dimensions, and expressions.

use super::check_errors;

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
// help: did you mean `height`?
",
    );
}

#[test]
fn reserved_names_are_refused_here_and_not_by_rustc() {
    check_errors(
        "pub struct M;
chain: C B | X Y Z;
d = (0, 0, ok);
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
// help: angles are in degrees, written `deg`
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
// help: a number is written without quotes: `150.0`
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
// help: write `a^2`
//                         ^^^ an exponent must be a whole number up to 64, nested exponents multiplied
//                                    ^ expected `)`
// help: close the parenthesis
//                                           ^ expected a number or a dimension
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
