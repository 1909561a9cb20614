//! The chain: its letters, its bar, and axes that cannot move or tilt the tool.

use super::check_errors;

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
//                           ^ a machine needs three solved linear axes, found X Z
// help: `Y` is held, so it is not solved for: remove Y from `hold`
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
// help: the axis next to the workpiece comes first: `chain: C B | X Y Z;`; if the order is right, C is not solved for: `hold = { C: 0 };`
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
fn the_chain_takes_a_colon() {
    check_errors(
        "pub struct M;
chain = C B | X Y Z;
//    ^ expected `:` after `chain`
// help: write `chain: C B | X Y Z;`
",
    );
}
