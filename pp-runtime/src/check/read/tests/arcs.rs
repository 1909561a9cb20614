//! Circles and helices, in every form.

use std::f64::consts::{PI, TAU};

use super::*;

fn arc(block: &Block) -> ArcMove {
    match block.action {
        Action::Arc(arc) => arc,
        other => panic!("{other:?}"),
    }
}

#[test]
fn circles_by_centre_radius_and_angle_are_the_same() {
    let texts = [
        (Family::LinuxCnc, format!("{LINUXCNC}G0 X10 Y0 Z0\nG3 X0 Y10 I-10 J0 F100")),
        (Family::LinuxCnc, format!("{LINUXCNC}G0 X10 Y0 Z0\nG3 X0 Y10 R10 F100")),
        (Family::Siemens, format!("{SIEMENS}G0 X10 Y0 Z0\nG3 X0 Y10 I-10 J0 F100")),
        (Family::Siemens, format!("{SIEMENS}G0 X10 Y0 Z0\nG3 X0 Y10 CR=10 F100")),
        (Family::Siemens, format!("{SIEMENS}G0 X10 Y0 Z0\nG3 X0 Y10 I=AC(0) J=AC(0) F100")),
        (Family::Heidenhain, format!("{TNC}2 L X+10 Y+0 Z+0 R0 FMAX\n3 CC X+0 Y+0\n4 C X+0 Y+10 DR+ F100")),
        (Family::Heidenhain, format!("{TNC}2 L X+10 Y+0 Z+0 R0 FMAX\n3 CR X+0 Y+10 R+10 DR+ F100")),
        (Family::Heidenhain, format!("{TNC}2 L X+10 Y+0 Z+0 R0 FMAX\n3 CC X+0 Y+0\n4 CP IPA+90 DR+ F100")),
    ];
    for (family, text) in texts {
        let block = last(family, &text);
        let found = arc(&block);
        assert!(near([found.centre[0], found.centre[1], 0.0], [0.0; 3]), "{text}: {found:?}");
        assert!((found.sweep - PI / 2.0).abs() < 1e-9, "{text}: {found:?}");
        assert!(near(xyz(&block), [0.0, 10.0, 0.0]), "{text}");
    }
}

#[test]
fn circles_know_sense_long_ways_turns_and_planes() {
    let arc_of = |text: &str| arc(&last(Family::LinuxCnc, &format!("{LINUXCNC}G0 X10 Y0 Z0\n{text}")));
    assert!((arc_of("G2 X0 Y10 I-10 F9").sweep + 1.5 * PI).abs() < 1e-9);
    let long = arc_of("G3 X0 Y10 R-10 F9");
    assert!((long.sweep - 1.5 * PI).abs() < 1e-9 && near([long.centre[0], long.centre[1], 0.0], [10.0, 10.0, 0.0]));
    assert!((arc_of("G3 I-10 F9").sweep - TAU).abs() < 1e-9);
    assert!((arc_of("G2 X10 Y0 Z-5 I-10 P3 F9").sweep + 3.0 * TAU).abs() < 1e-9);
    // In G18 Z turns towards X.
    let block = last(Family::LinuxCnc, &format!("{LINUXCNC}G18\nG0 X0 Y0 Z10\nG3 X10 Z0 I0 K-10 F9"));
    assert!((arc(&block).sweep - PI / 2.0).abs() < 1e-9);
    let turn = last(Family::Siemens, &format!("{SIEMENS}G0 X10 Y0 Z0\nG3 X10 Y0 Z-4 I-10 J0 TURN=1 F9"));
    assert!((arc(&turn).sweep - 2.0 * TAU).abs() < 1e-9);
    let polar =
        last(Family::Heidenhain, &format!("{TNC}2 L X+10 Y+0 Z+0 R0 FMAX\n3 CC X+0 Y+0\n4 CP IPA-720 IZ-6 DR- F9"));
    assert!((arc(&polar).sweep + 2.0 * TAU).abs() < 1e-9 && near(xyz(&polar), [10.0, 0.0, -6.0]));
}

#[test]
fn circles_that_do_not_close_are_faults() {
    for text in ["G3 X0 Y10 I-9 F9", "G3 X10 Y0 R5 F9", "G3 X0 Y10 R1 F9", "G3 X0 Y10 F9", "G3 X0 Y10 I-10 K1 F9"] {
        assert!(!faults(Family::LinuxCnc, &format!("{LINUXCNC}G0 X10 Y0 Z0\n{text}")).is_empty(), "{text}");
    }
}
