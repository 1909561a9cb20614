//! Spindle, coolant, dwells and smoothing.

use super::*;
use crate::options::Smoothing;

#[test]
fn a_dwell_of_haas_has_its_point_where_lengths_have_none() {
    let control = ControlOptions { point: Some(false), ..ControlOptions::default() };
    assert!(steps(&Haas, &layout_with(control), &[Step::Dwell { seconds: 2.0 }]).iter().any(|line| line == "G04 P2."));
}

#[test]
fn a_new_speed_is_written_once_in_a_tool_call_of_heidenhain() {
    let spindle = |units| Step::Spindle { speed: Decimal { units, decimals: 0 }, rotation: Rotation::CounterClockwise };
    assert_eq!(
        steps(&Heidenhain, &layout(), &[spindle(3000), spindle(3000), spindle(4000)]),
        ["0 TOOL CALL S3000", "1 M4", "2 M4", "3 TOOL CALL S4000", "4 M4"]
    );
}

#[test]
fn coolant_is_switched_off_by_the_code_of_its_kind() {
    let through = Step::Coolant { kind: Coolant::Through };
    let blocks = [Step::CoolantOff, through, Step::CoolantOff, Step::CoolantOff];
    assert_eq!(steps(&Haas, &layout(), &blocks), ["M09", "M88", "M89", "M09"]);
    let mut options = ControlOptions::default();
    options.coolant[2] = Some(["M51".to_owned(), "M59".to_owned()]);
    assert_eq!(steps(&LinuxCnc, &layout_with(options.clone()), &blocks), ["M9", "M51", "M59", "M9"]);
    // Flood and mist have codes of the shop: each is switched off by its own, wherever it may be on.
    options.coolant[0] = Some(["M181".to_owned(), "M189".to_owned()]);
    assert_eq!(steps(&LinuxCnc, &layout_with(options.clone()), &blocks), ["M189", "M9", "M51", "M59", "M189", "M9"]);
    options.coolant[1] = Some(["M182".to_owned(), "M189".to_owned()]);
    assert_eq!(steps(&LinuxCnc, &layout_with(options.clone()), &blocks), ["M189", "M51", "M59", "M189"]);
    assert_eq!(steps(&Haas, &layout_with(options), &blocks), ["M189", "M51", "M59", "M189"]);
}

#[test]
fn smoothing_is_on_in_cuts_and_off_before_machine_coordinates() {
    let options =
        |smoothing, smoothing_angle_rad| ControlOptions { smoothing, smoothing_angle_rad, ..ControlOptions::default() };
    let angle = Some(0.1_f64.to_radians());
    let text = |control: &dyn Control, smoothing| whole(control, &layout_with(options(smoothing, angle))).join("\n");
    assert!(text(&Fanuc, Smoothing::Finish).contains("G05.1 Q1\nG1 Z-1. F800.\nX12. C31.\nM9\nG05.1 Q0\nG49 G53"));
    assert!(text(&Siemens, Smoothing::Rough).contains("CYCLE832(0.01,13,0.1)\nG1 Z-1 F800"));
    let plain = whole(&Siemens, &layout_with(options(Smoothing::Finish, None))).join("\n");
    assert!(plain.contains("CYCLE832(0.01,1,1)\nG1 Z-1 F800"));
    assert!(text(&Haas, Smoothing::Medium).contains("G187 P2 E0.01\nG01"));
    assert!(text(&Heidenhain, Smoothing::Finish).contains("20 CYCL DEF 32.1 T0.01\n21 CYCL DEF 32.2 HSC-MODE:0 TA0.1"));
    assert!(!text(&Fanuc, Smoothing::None).contains("G05.1"));
}

#[test]
fn a_dwell_that_is_too_long_for_the_control_is_written_as_several() {
    let waits = |seconds| steps(&Heidenhain, &layout(), &[Step::Dwell { seconds }]);
    let lengths = |seconds| -> Vec<String> {
        waits(seconds).iter().filter_map(|line| Some(line.split_once("9.1 DWELL ")?.1.to_owned())).collect()
    };
    assert_eq!(lengths(3600.0), ["3600"]);
    assert_eq!(lengths(3600.0004), ["3600"]);
    assert_eq!(lengths(8000.25), ["3600", "3600", "800.25"]);
    assert_eq!(steps(&Fanuc, &layout(), &[Step::Dwell { seconds: 99_999.0 }]), ["G4 P99999000"]);
}
