//! The `machine!` macro; its engine is the ordinary library `pp_codegen`.
// A library returns its errors and leaves output to its caller.
#![cfg_attr(
    not(test),
    warn(
        clippy::unwrap_used,
        clippy::expect_used,
        clippy::panic,
        clippy::unreachable,
        clippy::print_stdout,
        clippy::print_stderr
    )
)]

use proc_macro::TokenStream;

/// Declares a machine tool and generates its proven kinematics.
///
/// ```
/// use pp_runtime::kinematics::{Machine, Pose};
/// use pp_runtime::nalgebra::{Point3, UnitVector3, Vector3};
///
/// pp_runtime::machine! {
///     /// A rotary table on a tilting table.
///     pub struct Table;
///     chain: C B | X Y Z;
///     d = (0, 0, d);
///     dims = { d: 150.0 };
///     limits = { B: -5..110, C: free };
/// }
///
/// let machine = Table::default();
/// let axis = UnitVector3::new_normalize(Vector3::new(0.3, 0.4, 1.0));
/// let pose = Pose { tip: Point3::new(10.0, 20.0, 30.0), axis };
/// let solutions = machine.inverse_kinematics(&pose, &Table::HELD);
/// assert_eq!(solutions.len(), 2);
/// let again = machine.forward_kinematics(&solutions[0].axes);
/// assert!((again.tip - pose.tip).norm() < 1e-9);
/// ```
///
/// # Fields
///
/// `chain` takes a colon, every other field `=`; each ends with `;`. Only the struct and `chain` are required. Lengths are in
/// mm, angles in degrees; `5.9 in` is 149.86 mm.
///
/// | field | meaning | default |
/// |---|---|---|
/// | `/// doc`, `vis struct Name;` | the generated type; attributes pass through | |
/// | `chain: C B \| X Y Z;` | axes from workpiece to tool; `\|` is the machine frame. X Y Z U V W are linear, A B C rotary | |
/// | `d = (0, 0, d);` or `d = { C: (0, 0, 0), B: (0, 0, -60.5) };` | a point on each rotary centre line, mm: from the table's reference point on the workpiece side, from the gauge line on the tool side | origin |
/// | `signs = { C: -, Y: - };` | `+` is ISO 841; `-` where a positive word moves the axis in the opposite direction | `+` |
/// | `axes = { B: Rx(-45 deg) * Y, Y: (0, 1, -0.5) };` | direction of an axis that is not its letter's own: a rotated coordinate axis (the rotation next to it acts first), or a vector, normalised exactly | X = A = (1, 0, 0), ... |
/// | `dims = { d: 150.0, alpha: -45 deg, h: required };` | named dimensions with defaults: public fields, changeable at run time. With `deg` an angle, else a length. `required`: a length that each machine has of its own; its default is NaN, and nothing is posted until it is given. A dimension that nothing depends on is refused | none |
/// | `tool_axis = (0, 0, 1);` | direction from tip to spindle with all axes at zero | Z |
/// | `hold = { W: 0, A: 0 };` | axes that exist but are not solved for, with their default values in mm and degrees | none |
/// | `limits = { B: -5..110, C: free };` | travel in mm and degrees, ends included | `free` |
/// | `speeds = { B: 3600, X: 30000 };` | largest axis speeds, deg/min and mm/min, or with a unit: `50 rpm`, `60 deg/s`, `36 m/min`, `500 mm/s`, `1200 in/min` | unlimited |
/// | `up = Y;` | the coordinate direction that is up at the machine, for the jog sheet: Y on a horizontal machining centre | Z |
/// | `crate = ::shop::post;` | path of the runtime where it is renamed or re-exported | `::pp_runtime` |
/// | `verify "source" { i = sin(B) * cos(C); }` | equations to be proven, see below; any number of blocks | none |
///
/// Zero position: with all axes at zero the tool tip is at the workpiece origin, so with all rotary axes at zero the
/// linear axes are the CL coordinates, up to signs and directions.
///
/// # Equations to be proven
///
/// A paper, a control's manual or your own notes give the formulas of the machine. Write them down as they are
/// printed; the machine compiles only if they follow from its chain.
///
/// ```
/// pp_runtime::machine! {
///     /// Both rotary axes in the head.
///     pub struct Lola;
///     chain: X | Y Z B A;
///
///     verify "Maletić and Živanović 2023, eqs. (8)-(14)" {
///         i = sin(B) * cos(A);
///         j = -sin(A);
///         k = cos(B) * cos(A);
///         A = asin(-j);
///         B = atan2(i, k);
///         X = x + gauge * sin(B) * cos(A);
///     }
/// }
/// ```
///
/// - Names: `x y z i j k` of the CL data, axis letters, dimensions, `gauge` (the gauge length), `part_x part_y part_z` (the
///   part origin). Set-up symbols that a block does not mention are zero in it.
/// - Functions: sin, cos, asin, acos, atan2, sqrt; a single name may follow without parentheses, `sin B`. Products are written
///   with `*`; `^` takes a whole exponent and binds tighter than a minus. Numbers are exact: `1/2`, `sqrt(2)/2`, `0.25`, `90 deg`.
/// - `where alpha = -45 deg;` gives a value to a dimension, a set-up symbol or a held axis, or introduces a name of the
///   block.
/// - A block describes one solution: equations that hold on different branches belong in blocks of their own.
/// - `NAME explain --verify` prints the derived formulas as such blocks.
///
/// Every equation is decided exactly: both sides become polynomials in axis values, sines and cosines, and their
/// difference must vanish. Angles are compared modulo 360 deg. Fixed angles are exact where they are multiples of
/// 15 deg; other fixed angles count as unrelated, except by multiples of 90 deg and by sums as written. A formula that
/// holds on one branch only is accepted with its condition ("holds where sin B >= 0"), which the type's documentation
/// shows; a divisor made of dimensions is tested by `validate`. A false equation is an error at that equation, with the
/// formula that does follow:
///
/// ```compile_fail
/// pp_runtime::machine! {
///     pub struct Lola;
///     chain: X | Y Z B A;
///     // Printed with sin(A); the help line is: write `cos(A)` in place of `sin(A)`.
///     verify "eq. (12) as printed" { X = x + gauge * sin(B) * sin(A); }
/// }
/// ```
///
/// # Generated items
///
/// The struct with a public field for each dimension, `part_origin` and `gauge_length`, and its implementation of
/// `pp_runtime::kinematics::Machine`. Its documentation shows the solved formulas, the branches, the singular set and
/// the proven claims.
///
/// # Refusals
///
/// Every mistake of a declaration is reported in one compilation, at the words that are wrong. For example, the axis next to
/// the workpiece comes first; in the opposite order C would rotate about the tool axis and could not tilt the tool:
///
/// ```compile_fail
/// pp_runtime::machine! {
///     pub struct Table;
///     chain: B C | X Y Z;
/// }
/// ```
///
/// A chain needs its machine frame:
///
/// ```compile_fail
/// pp_runtime::machine! {
///     pub struct Table;
///     chain: C B X Y Z;
/// }
/// ```
///
/// Three linear axes in one plane cannot move the tip in every direction:
///
/// ```compile_fail
/// pp_runtime::machine! {
///     pub struct Table;
///     chain: C B | X Y Z;
///     axes = { Z: (1, 1, 0) };
/// }
/// ```
#[proc_macro]
pub fn machine(input: TokenStream) -> TokenStream {
    let options = pp_codegen::Options { serde: cfg!(feature = "serde") };
    pp_codegen::expand_with(input.into(), options).into()
}
