//! Reference machines, correct and flawed, and the rule that the suite reports for each flaw.

use pp_runtime::kinematics::{Axis, AxisKind, Side, Sign};

use super::{Flaw, Reference, Table};
use crate::conformance::{check, find_fault};

const fn axis(letter: char, side: Side, sign: Sign, held: bool) -> Axis {
    let kind = if matches!(letter, 'A'..='C') { AxisKind::Rotary } else { AxisKind::Linear };
    Axis { letter, kind, side, sign, limits: None, speed: None, held }
}

macro_rules! reference {
    ($name:ident, $count:literal, $flaw:ident, tool $tool:expr,
     $($letter:literal $side:ident $sign:ident $($held:literal)? = $direction:expr, $point:expr;)*) => {
        #[derive(Clone, Copy)]
        struct $name;
        impl Table for $name {
            type Axes = [f64; $count];
            const AXES: &'static [Axis] =
                &[$(axis($letter, Side::$side, Sign::$sign, reference!(@held $($held)?))),*];
            const HELD: Self::Axes = [$(reference!(@value $($held)?)),*];
            const ROWS: &'static [([f64; 3], [f64; 3])] = &[$(($direction, $point)),*];
            const TOOL: [f64; 3] = $tool;
            const FLAW: Flaw = Flaw::$flaw;
        }
    };
    (@held) => { false };
    (@held $held:literal) => { true };
    (@value) => { 0.0 };
    (@value $held:literal) => { $held };
}

const X: [f64; 3] = [1.0, 0.0, 0.0];
const Y: [f64; 3] = [0.0, 1.0, 0.0];
const Z: [f64; 3] = [0.0, 0.0, 1.0];
const O: [f64; 3] = [0.0, 0.0, 0.0];

macro_rules! table_table {
    ($name:ident, $flaw:ident) => {
        reference! { $name, 5, $flaw, tool Z,
            'C' Workpiece Plus = Z, [0.0, 0.0, 150.0];
            'B' Workpiece Plus = Y, [0.0, 0.0, 150.0];
            'X' Tool Plus = X, O;
            'Y' Tool Plus = Y, O;
            'Z' Tool Plus = Z, O;
        }
    };
}

macro_rules! inclined {
    ($name:ident, $flaw:ident) => {
        reference! { $name, 5, $flaw, tool Z,
            'C' Workpiece Minus = Z, [3.0, -4.0, 0.0];
            'B' Workpiece Plus = [0.0, 1.0, -1.0], [0.0, 2.0, 150.0];
            'X' Tool Plus = X, O;
            'Y' Tool Minus = [0.0, 1.0, -0.5], O;
            'Z' Tool Plus = Z, O;
        }
    };
}

table_table!(Table0, None);
table_table!(TableFlipped, FlippedSign);
table_table!(TableSwapped, SwappedBranches);
table_table!(TableForgets, ForgetsHeldValue);
table_table!(TableSlightlyOff, SlightlyOff);
table_table!(TableBackward, BackwardRates);
table_table!(TableSmallBound, SmallBound);
table_table!(TableLargeBound, LargeBound);
inclined!(Inclined, None);
inclined!(InclinedLosesDigits, LosesDigitsAtThePole);

reference! { Head, 5, None, tool Z,
    'X' Workpiece Plus = X, O;
    'Y' Tool Plus = Y, O;
    'Z' Tool Plus = Z, O;
    'B' Tool Minus = Y, [0.0, 0.0, 51.2];
    'A' Tool Plus = X, [0.0, 10.0, 30.0];
}
reference! { HeadForgetsGauge, 5, ForgetsGaugeLength, tool Z,
    'X' Workpiece Plus = X, O;
    'Y' Tool Plus = Y, O;
    'Z' Tool Plus = Z, O;
    'B' Tool Plus = Y, O;
    'A' Tool Plus = X, O;
}
// Rotaries between the linear axes: the determinant passes through zero.
reference! { Between, 5, None, tool Z,
    'X' Workpiece Plus = X, O;
    'A' Workpiece Plus = X, [0.0, 10.0, 30.0];
    'Y' Tool Plus = Y, O;
    'B' Tool Minus = Y, [5.0, 0.0, 51.2];
    'Z' Tool Plus = Z, O;
}
reference! { BetweenOthers, 5, None, tool Z,
    'Y' Workpiece Plus = Y, O;
    'C' Workpiece Plus = Z, [0.0, 10.0, 30.0];
    'Z' Workpiece Plus = Z, O;
    'A' Tool Plus = X, [5.0, 0.0, 51.2];
    'X' Tool Plus = X, O;
}
reference! { Oblique, 5, None, tool [0.2, -0.1, 1.0],
    'C' Workpiece Plus = [0.3, -0.5, 0.8], [10.0, 20.0, 30.0];
    'X' Workpiece Plus = X, O;
    'Y' Tool Plus = Y, O;
    'Z' Tool Plus = Z, O;
    'A' Tool Minus = [0.9, 0.4, -0.2], [0.0, 10.0, 30.0];
}
reference! { ObliqueReachesAll, 5, ReachesEverything, tool [0.2, -0.1, 1.0],
    'C' Workpiece Plus = [0.3, -0.5, 0.8], [10.0, 20.0, 30.0];
    'X' Workpiece Plus = X, O;
    'Y' Tool Plus = Y, O;
    'Z' Tool Plus = Z, O;
    'A' Tool Minus = [0.9, 0.4, -0.2], [0.0, 10.0, 30.0];
}
reference! { FourAxes, 4, None, tool Z,
    'A' Workpiece Minus = X, [0.0, 7.0, 30.0];
    'Y' Workpiece Minus = Y, O;
    'X' Tool Plus = X, O;
    'Z' Tool Plus = Z, O;
}
reference! { ThreeAxes, 3, None, tool Z,
    'X' Workpiece Plus = X, O;
    'Y' Workpiece Plus = Y, O;
    'Z' Tool Plus = Z, O;
}
reference! { Quill, 6, None, tool Z,
    'C' Workpiece Plus = Z, [0.0, 7.0, 30.0];
    'B' Workpiece Plus = Y, [0.0, 7.0, 30.0];
    'X' Tool Plus = X, O;
    'Y' Tool Plus = Y, O;
    'Z' Tool Plus = Z, O;
    'W' Tool Plus 25.0 = Z, O;
}
reference! { ManualHead, 6, None, tool Z,
    'C' Workpiece Plus = Z, [0.0, 7.0, 30.0];
    'B' Workpiece Plus = Y, [0.0, 7.0, 30.0];
    'X' Tool Plus = X, O;
    'Y' Tool Plus = Y, O;
    'Z' Tool Plus = Z, O;
    'A' Tool Minus 0.25 = X, [0.0, 0.0, 90.0];
}

const POSES: usize = 4_000;

macro_rules! conforms {
    ($($test:ident: $table:ident;)*) => { $(#[test] fn $test() { check::<Reference<$table>>(POSES); })* };
}

conforms! {
    a_table_with_two_rotaries_conforms: Table0;
    an_inclined_table_with_a_slanted_linear_axis_conforms: Inclined;
    a_head_with_two_rotaries_conforms: Head;
    rotaries_between_linear_axes_conform: Between;
    rotaries_between_other_linear_axes_conform: BetweenOthers;
    an_oblique_pair_conforms: Oblique;
    one_rotary_conforms: FourAxes;
    no_rotary_conforms: ThreeAxes;
    a_held_quill_conforms: Quill;
    a_held_rotary_conforms: ManualHead;
}

fn assert_found<T: Table>(rule: &str) {
    let fault = find_fault::<Reference<T>>(4_000).expect("a flawed machine has a fault");
    assert_eq!(fault.rule, rule, "{fault}");
}

#[test]
fn a_flipped_sign_is_found() {
    assert_found::<TableFlipped>("a solution brings the tool axis to the pose");
}

#[test]
fn swapped_branches_are_found() {
    assert_found::<TableSwapped>("branches follow their documented definition");
}

#[test]
fn a_formula_that_loses_digits_at_the_pole_is_found() {
    assert_found::<InclinedLosesDigits>("an axis that the machine reaches is reached");
}

#[test]
fn a_forgotten_held_value_is_found() {
    assert_found::<TableForgets>("a free rotary keeps its held value");
}

#[test]
fn a_hundredth_of_a_micrometre_off_is_found() {
    assert_found::<TableSlightlyOff>("a solution brings the tip to the pose");
}

#[test]
fn a_forgotten_gauge_length_is_found() {
    assert_found::<HeadForgetsGauge>("forward kinematics puts the tip where the joints do");
}

#[test]
fn a_machine_that_claims_to_reach_everything_is_found() {
    assert_found::<ObliqueReachesAll>("an axis outside the cone is refused");
}

#[test]
fn a_rotation_of_the_wrong_sense_in_rates_is_found() {
    assert_found::<TableBackward>("`rates` are the derivatives of the tip");
}

#[test]
fn a_bound_one_percent_too_small_is_found() {
    assert_found::<TableSmallBound>("no tip deviates from its line more than the bound of `motion`");
}

#[test]
fn a_bound_ten_percent_too_large_is_found() {
    assert_found::<TableLargeBound>("a bound is near the true deviation");
}
