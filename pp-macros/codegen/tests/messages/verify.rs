//! `verify` blocks: equations that do not follow from the chain, and blocks that cannot be read.

use super::check_errors;

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
verify \"Spinner U5-620, j and eq. (4) with the lost sign\" {
    j = sin(B) * sin(C);
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
//                           ^^^^^^^^^^^^^^^^ both equations of \"DMU 70e, eqs. (6) and (7) as printed\" do not follow from this declaration
//  |   the first:  B = acos((k - cos(alpha)^2) / sin(alpha)^2)
//  |   equal only where this is zero: -(1 - 2 * sin(alpha)^2) * (1 - cos(B)) * sin(alpha)^2
// help: all equations follow with `axes = { B: Rx(-90 deg - alpha) * Y };`
verify \"DMU 70e, eqs. (6) and (7) as printed\" {
    B = acos((k - cos(alpha)^2) / sin(alpha)^2);
    C = atan2(-(j * sin(alpha) * sin(B) + i * sin(alpha) * cos(alpha) * (1 - cos(B))), -i * sin(alpha) * sin(B) + j * sin(alpha) * cos(alpha) * (1 - cos(B)));
}
",
    );
}

/// Of two equations, one has a misprint, and one is true: no declaration makes both true.
#[test]
fn an_equation_that_no_declaration_makes_true_is_reported_alone() {
    check_errors(
        "pub struct Dmu;
chain: C B | X Y Z; axes = { B: Rx(alpha) * Y }; dims = { alpha: -45 deg };
verify \"from memory\" {
    k = cos(alpha)^2 * cos(B) + sin(alpha)^2;
    B = acos((k - cos(alpha)^2) / sin(alpha)^2);
//  ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^ this equation for `B` does not follow from the chain
//  |   equal only where this is zero: -(1 - 2 * sin(alpha)^2) * (1 - cos(B)) * sin(alpha)^2
// help: exchange `sin(alpha)` and `cos(alpha)` wherever they occur
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
//       ^ the equation of \"a control whose B rotates in the opposite direction\" does not follow from this declaration
//  |   equation:   Z = -x * sin(B) * cos(C) - y * sin(B) * sin(C) + z * cos(B)
//  |   derived:    Z = (x * cos(C) + y * sin(C)) * sin(B) + z * cos(B)
//  |   difference: 2 * (x * cos(C) + y * sin(C)) * sin(B)
// help: it follows with `signs = { B: - };`; if the declaration is right: it is true with `-B` in place of `B`: the source counts B in the opposite direction
verify \"a control whose B rotates in the opposite direction\" {
    Z = -x * sin(B) * cos(C) - y * sin(B) * sin(C) + z * cos(B);
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
//  |   equal only where this is zero: 2 * (1 - cos(A))
}
",
    );
}

#[test]
fn names_and_kinds_of_an_equation_are_checked() {
    check_errors(
        "pub struct M;
chain: C B | X Y Z; dims = { d: 1, alpha: 45 deg }; d = (0, 0, d); axes = { B: Rx(alpha) * Y };
verify \"kinds\" {
    i = sin(X);
//          ^ `X` is not an angle
    i = sin(B) + q;
//               ^ unknown name `q` in `verify`
// help: the names are x y z i j k, the axes C B X Y Z, d, alpha, gauge, part_x, part_y, part_z; a symbol of the source gets its meaning by `where q = ...;`
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
    k = cot(B);
//      ^^^^^^ `cot` is not a function of `verify`
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
    B = 2 * atan2(sqrt(1 - k) * (x * y) / sqrt(x^2 * y^2), sqrt(1 + k));
//      ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^ this expression is too large to be decided
}
",
    );
}

#[test]
fn assumptions_of_a_block_are_checked() {
    check_errors(
        "pub struct M;
chain: C B | X Y Z; dims = { d: 1, alpha: 45 deg }; d = (0, 0, d); axes = { B: Rx(alpha) * Y };
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
//          ^ expected `=`
// help: both sides are joined by one `=`: `X = x * cos(C) + y * sin(C);`
    k = cos(B) sin(C);
//      ^^^^^^^^^^^^^ a product is written with `*`
// help: write `cos(B) * sin(C)`
    where = 3;
//        ^ expected a name
// help: give the name a value, for example `where alpha = -45 deg;`
    where alpha 3;
//              ^ expected `=`
    k = cos(B)
//           ^ missing `;` after `)`
}
verify { k = cos(B); }
//     ^ expected the source of the equations in quotes
",
    );
}
