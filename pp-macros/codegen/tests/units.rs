//! Values with units: each reads as what it is.

use num_rational::BigRational;
use pp_codegen::model::{Axis, Model};
use pp_codegen::{compile, generate};

fn model(text: &str) -> Model {
    let tokens = format!("pub struct M; {text}").parse().expect("Rust tokens");
    compile(tokens).unwrap_or_else(|refused| panic!("{text}: {refused:?}")).model
}

fn axis(model: &Model, letter: char) -> &Axis {
    model.axes.iter().find(|axis| axis.letter == letter).expect("an axis of the chain")
}

fn exact(above: i64, below: i64) -> BigRational {
    BigRational::new(above.into(), below.into())
}

#[test]
fn speeds_have_the_units_of_data_sheets() {
    let model = model(
        "chain: C B | X Y Z W; hold = { W: 0 };
         speeds = { C: 50 rpm, B: 25 deg/s, X: 36 m/min, Y: 1000 in/min, Z: 500 mm/s, W: 12000 };",
    );
    let speed = |letter: char| axis(&model, letter).speed.clone().expect("declared");
    assert_eq!(speed('C'), exact(18_000, 1));
    assert_eq!(speed('B'), exact(1_500, 1));
    assert_eq!(speed('X'), exact(36_000, 1));
    assert_eq!(speed('Y'), exact(25_400, 1));
    assert_eq!(speed('Z'), exact(30_000, 1));
    assert_eq!(speed('W'), exact(12_000, 1));
}

#[test]
fn inches_are_exact() {
    let model = model("chain: C B | X Y Z; d = (0, 0, d + 1 in); dims = { d: 5.9 in }; limits = { X: -12in..12 in };");
    assert_eq!(model.dimensions[0].default, Some(exact(14_986, 100)));
    assert_eq!(axis(&model, 'X').limits, Some((exact(-3_048, 10), exact(3_048, 10))));
}

#[test]
fn a_required_length_has_no_default_and_is_refused_until_it_is_given() {
    let text = "chain: C B | X Y Z; d = (0, 0, d); dims = { d: required };";
    assert_eq!(model(text).dimensions[0].default, None);
    let tokens = format!("pub struct M; {text}").parse().expect("Rust tokens");
    let code = generate(tokens, pp_codegen::Options::default()).expect("a machine").to_string();
    assert!(code.contains("d : :: core :: primitive :: f64 :: NAN"), "{code}");
    assert!(code.contains("Invalid :: Required { name : \"d\" }"), "{code}");
}

/// The slide of Y is inclined by an angle that each machine has of its own.
#[test]
fn a_required_angle_may_incline_a_linear_axis() {
    let text =
        "chain: C | Z X Y; tool_axis = X; axes = { Y: Rz(slant) * Y }; dims = { slant: required deg }; hold = { C: 0 };
        verify \"a manual\" { where C = 0; Y = y / cos(slant); X = x + y * sin(slant) / cos(slant); }";
    let model = model(text);
    assert_eq!(model.dimensions[0].default, None);
    let tokens = format!("pub struct M; {text}").parse().expect("Rust tokens");
    let machine = compile(tokens).expect("a machine");
    assert!(machine.explanation.jog_sheet.text.iter().any(|line| line.contains("Y: its direction depends on slant")));
}

#[test]
fn a_renamed_runtime_is_named_by_its_path() {
    let tokens = "pub struct M; chain: C B | X Y Z; crate = ::shop::post;".parse().expect("Rust tokens");
    let code = generate(tokens, pp_codegen::Options { serde: true }).expect("a machine").to_string();
    assert!(!code.contains("pp_runtime"), "{code}");
    assert!(code.contains("use :: shop :: post :: { self as pp , kinematics :: math }"), "{code}");
    assert!(code.contains("crate = \"::shop::post::serde\""), "{code}");
}

#[test]
fn a_function_of_a_single_name_needs_no_parentheses() {
    model("chain: C B | X Y Z; verify \"a paper\" { i = sin B * cos C; j = sin B * sin C; k = cos B; B = acos k; }");
}
