//! Tool axes near the pole.

use std::f64::consts::TAU;

use super::*;
use crate::check::read::MAX_AXES;
use crate::check::rules::MachineWords;

#[test]
fn the_rotary_axes_of_a_tool_axis_near_the_pole_are_found() {
    let (control, config) = configured::<Tables>("siemens", Mode::Tcp, "");
    let policy = config.check_policy::<Tables>(control, None).expect("it can be checked");
    let words = MachineWords::new(&Tables::default(), &policy);
    let rotary: Vec<usize> = words.rotary().collect();
    let &[table, tilting] = &rotary[..] else { panic!("two axes: {rotary:?}") };
    for tilt in [1e-3, 1e-4, 3e-5, 1e-5, 1e-6] {
        for eighth in 0..8 {
            let mut from = [0.0; MAX_AXES];
            (from[table], from[tilting]) = (TAU * f64::from(eighth) / 8.0, tilt);
            // The table rotates by twelve degrees.
            let mut to = from;
            to[table] += 0.2;
            let found = words.rotated_to(&from, &words.tool_axis_at(&to), 0.0).expect("it is found");
            // The tool axis is met to 1e-14 rad, and the table, whose rate is the tilt, to that over the tilt; or the
            // last step was below 1e-9 rad.
            assert!((found[table] - to[table]).abs() <= (2e-14 / tilt).max(1e-9), "{tilt}: {found:?} {to:?}");
            assert!((found[tilting] - to[tilting]).abs() <= 2e-9, "{tilt}: {found:?} {to:?}");
        }
    }
}
