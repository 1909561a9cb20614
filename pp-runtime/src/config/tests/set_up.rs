//! Keys of the set-up.

use nalgebra::{Matrix3, Rotation3};

use super::super::Config;
use super::super::sample::Sample;
use crate::control::LinuxCnc;
use crate::options::ClampCodes;
use crate::set_up::{LengthMode, ProgramZero, Stock};

fn rotation(text: &str) -> Rotation3<f64> {
    let config = Config::read::<Sample>(&format!("part_rotation = {text}\n"), &LinuxCnc);
    config.unwrap_or_else(|faults| panic!("{faults:#?}")).set_up.part_rotation
}

fn fault(text: &str) -> String {
    let faults = Config::read::<Sample>(&format!("part_rotation = {text}\n"), &LinuxCnc).expect_err("it is wrong");
    assert_eq!(faults.len(), 1);
    faults[0].text.clone()
}

#[test]
fn the_part_is_turned_about_x_first_and_about_z_last() {
    let turned = rotation("[30, 45, 60]").into_inner();
    let about = |axis, degrees: f64| Rotation3::from_axis_angle(&axis, degrees.to_radians());
    let (x, y, z) = (nalgebra::Vector3::x_axis(), nalgebra::Vector3::y_axis(), nalgebra::Vector3::z_axis());
    let product = about(z, 60.0) * about(y, 45.0) * about(x, 30.0);
    assert!((turned - product.into_inner()).abs().max() < 1e-15);
}

#[test]
fn quarters_of_a_turn_are_exact() {
    // Ry(-90)·Rx(180): X goes to Z, Y to -Y, Z to X.
    let exact = Matrix3::new(0.0, 0.0, 1.0, 0.0, -1.0, 0.0, 1.0, 0.0, 0.0);
    assert_eq!(rotation("[180, -90, 0]").into_inner(), exact);
}

#[test]
fn a_matrix_of_seven_digits_becomes_the_rotation_it_was_rounded_from() {
    let turned = rotation("[[0.8660254, -0.5, 0], [0.5, 0.8660254, 0], [0, 0, 1]]").into_inner();
    assert!((turned * turned.transpose() - Matrix3::identity()).abs().max() < 1e-15);
    assert!((turned[(0, 0)] - 0.75_f64.sqrt()).abs() < 1e-7);
    assert_eq!(
        rotation("[[0, 0, 1], [1, 0, 0], [0, 1, 0]]").into_inner(),
        Matrix3::new(0., 0., 1., 1., 0., 0., 0., 1., 0.)
    );
}

#[test]
fn a_matrix_that_is_no_rotation_is_refused() {
    assert!(fault("[[1, 0, 0], [0, 1, 0], [0, 0, 1.001]]").contains("no rotation"));
    assert!(fault("[[1, 0, 0], [0.1, 1, 0], [0, 0, 1]]").contains("no rotation"));
    assert!(fault("[[1e300, 0, 0], [0, 1, 0], [0, 0, 1]]").contains("no rotation"));
    assert!(fault("[[-1, 0, 0], [0, 1, 0], [0, 0, 1]]").contains("mirrors"));
    assert!(fault("[[1, 0], [0, 1, 0], [0, 0, 1]]").contains("in a row"));
    assert!(fault("[1, 2]").contains("three angles or three rows"));
    assert!(fault("90").contains("a list"));
}

#[test]
fn program_zero_and_length_mode_are_words() {
    let config = Config::read::<Sample>("program_zero = 'table'\nlength_mode = 'gauge'\n", &LinuxCnc).expect("right");
    assert_eq!((config.set_up.program_zero, config.set_up.length_mode), (ProgramZero::Table, LengthMode::Gauge));
    assert!(Config::read::<Sample>("length_mode = 'spindle'\n", &LinuxCnc).is_err());
}

#[test]
fn the_length_guard_can_be_forced_and_widened() {
    let read = |text: &str| Config::read::<Sample>(text, &LinuxCnc);
    let config = read("length_guard = true\nlength_tolerance = 0.05\n").expect("right");
    assert_eq!((config.motion.guards.length_guard, config.motion.guards.length_tolerance_mm), (Some(true), 0.05));
    assert!(read("length_tolerance = 0.00001\n").is_err() && read("length_tolerance = 5\n").is_err());
}

#[test]
fn a_blank_has_two_corners() {
    let read = |text: &str| Config::read::<Sample>(&format!("[stock]\n{text}\n"), &LinuxCnc);
    let config = read("lower = [-5, -4, -3]\nupper = [5, 4, 0]").expect("right");
    assert_eq!(config.set_up.stock, Some(Stock { lower: [-5.0, -4.0, -3.0], upper: [5.0, 4.0, 0.0], round: false }));
    assert_eq!(read("").expect("right").set_up.stock, None);
    for wrong in ["lower = [-5, -4, -3]", "lower = [-5, -4, 0]\nupper = [5, 4, 0]", "lower = 5\nupper = [5, 4, 0]"] {
        assert_eq!(read(wrong).expect_err("wrong").len(), 1, "{wrong}");
    }
}

#[test]
fn a_clamp_has_two_m_codes() {
    let read = |text: &str| Config::read::<Sample>(&format!("[clamp]\n{text}\n"), &LinuxCnc);
    let config = read("C = { on = 'M10', off = 'M64 P1' }").expect("right");
    assert_eq!(config.motion.rotaries.clamp[&'C'], ClampCodes { on: "M10".to_owned(), off: "M64 P1".to_owned() });
    for wrong in [
        "C = { on = 'M10' }",
        "C = { on = 'M10', off = 'M10' }",
        "C = { on = 'G0 X5', off = 'M11' }",
        "C = { on = 'M10 X5', off = 'M11' }",
        "X = { on = 'M10', off = 'M11' }",
        "C = 'M10'",
    ] {
        assert!(read(wrong).is_err(), "{wrong}");
    }
}

#[test]
fn an_offset_belongs_to_a_rotary_axis_that_is_solved() {
    let read = |text: &str| Config::read::<Sample>(&format!("[rotary_offset]\n{text}\n"), &LinuxCnc);
    let config = read("C = 12.5").expect("right");
    assert!((config.set_up.rotary_offset[&'C'].to_degrees() - 12.5).abs() < 1e-12);
    assert_eq!(read("X = 1").expect_err("linear")[0].text, "X is not a solved rotary axis");
    assert!(read("C = 361").is_err() && read("C = 360").is_ok());
}
