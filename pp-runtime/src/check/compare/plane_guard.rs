//! Guards of rotary positions: after a plane call the program stops where the control has chosen other positions.

use super::Previous;
use super::phase::Phase;
use crate::check::read::RotaryGuard;
use crate::check::rules::Rules;
use crate::check::tolerances::{GUARDED_SINES, LEAST_GUARDED_RATE, ROUNDED_GUARD_POSITION};

/// What is wrong with a guard.
pub(super) fn fault(guard: &RotaryGuard, phase: &Phase, rules: &Rules<'_>, previous: &Previous) -> Option<String> {
    match phase {
        Phase::Retracted(retracted) if retracted.since_plane.is_some() => {}
        Phase::Cutting(_) | Phase::Leaving(_) => {
            return Some(
                "rotary positions are compared with the tool at the part: the look-ahead stops there".to_owned(),
            );
        }
        Phase::Retracted(_) | Phase::Unknown { .. } | Phase::Ended => {
            return Some("rotary positions are compared, and no plane call comes before".to_owned());
        }
    }
    if guard.largest > GUARDED_SINES * 1.01 {
        let largest = guard.largest;
        return Some(format!("the guard of the rotary positions allows {largest}, expected {GUARDED_SINES}"));
    }
    let differs = |(axis, position): &(usize, f64)| {
        let known = previous.known & (1 << axis) != 0;
        known && ((previous.words[*axis] - position) / 2.0).sin().abs() > ROUNDED_GUARD_POSITION
    };
    if let Some((axis, position)) = guard.positions.into_iter().flatten().find(differs) {
        let letter = rules.axes()[axis].letter;
        let [here, compared] = [previous.words[axis], position].map(f64::to_degrees);
        return Some(format!("the guard compares {letter} with {compared:.3}, but it is at {here:.3}"));
    }
    let compared = guard.positions.iter().flatten().fold(0, |bits, (axis, _)| bits | 1 << axis);
    uncompared(compared, rules, previous)
}

/// What is wrong where no guard comes between a plane call and the motion after it.
pub(super) fn missing(rules: &Rules<'_>, previous: &Previous) -> Option<String> {
    uncompared(0, rules, previous)
}

/// A rotary axis that the tool axis fixes, and that is not compared.
fn uncompared(compared: u16, rules: &Rules<'_>, previous: &Previous) -> Option<String> {
    let words = rules.words();
    let (_, rates) = words.chain().axis_rates(&words.values(&previous.words));
    let fixes = rules.rounding().fixes_rotaries(2.0 * GUARDED_SINES)?.max(LEAST_GUARDED_RATE);
    let due = |index: &usize| compared & (1 << index) == 0 && rates[*index].norm() > fixes;
    let index = words.rotary().find(due).filter(|_| previous.known & words.rotary_bits() == words.rotary_bits())?;
    let letter = rules.axes()[index].letter;
    Some(format!("the position of {letter} is not compared after the plane call: the control may have chosen another"))
}
