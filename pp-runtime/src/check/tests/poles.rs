//! Tool axes near the pole.

use std::f64::consts::TAU;

use super::*;
use crate::check::read::MAX_AXES;
use crate::check::rules::Words;

#[test]
fn the_rotary_axes_of_a_tool_axis_near_the_pole_are_found() {
    let (control, config) = configured::<Tables>("siemens", Mode::Tcp, "");
    let policy = config.check_policy::<Tables>(control, None).expect("it can be checked");
    let words = Words::new(&Tables::default(), &policy);
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
            // The tool axis is met to 1e-14 rad, and the table, whose rate is the tilt, to that over the tilt; or the last step was
            // below 1e-9 rad.
            assert!((found[table] - to[table]).abs() <= (2e-14 / tilt).max(1e-9), "{tilt}: {found:?} {to:?}");
            assert!((found[tilting] - to[tilting]).abs() <= 2e-9, "{tilt}: {found:?} {to:?}");
        }
    }
}

#[test]
fn where_the_pole_leaves_the_table_free_it_stays_or_is_not_found() {
    let (control, config) = configured::<Tables>("siemens", Mode::Tcp, "");
    let policy = config.check_policy::<Tables>(control, None).expect("it can be checked");
    let words = Words::new(&Tables::default(), &policy);
    let rotary: Vec<usize> = words.rotary().collect();
    let &[table, tilting] = &rotary[..] else { panic!("two axes: {rotary:?}") };
    let at = |turn: f64, tilt: f64| {
        let mut place = [0.0; MAX_AXES];
        (place[table], place[tilting]) = (turn, tilt);
        place
    };
    // The tool vectors of a program are 1e-7 rad from the pole, or more.
    let from = at(0.2, 5e-7);
    for step in 0..100 {
        let tilt = 5e-7 * 10_f64.powf(-0.1 * f64::from(step));
        let axis = words.tool_axis_at(&at(-0.4, tilt));
        if let Some(found) = words.rotated_to(&from, &axis, 0.0) {
            let off = (found[table] - 0.2).abs().min((found[table] + 0.4).abs());
            assert!(off <= 2e-6, "at {tilt} the table is at {}", found[table]);
        } else {
            assert!(tilt < 1e-7, "nothing is found at {tilt}");
        }
    }
}
