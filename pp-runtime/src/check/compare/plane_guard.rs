//! Guards of rotary positions: after a plane call the program stops where the control has chosen other positions.

use super::Previous;
use super::phase::Phase;
use crate::check::read::RotaryGuard;
use crate::check::rules::Rules;

/// Largest sum of |sin(d/2)| over the differences d: 0.1 degrees of one axis.
const LARGEST: f64 = 0.0009;

/// Positions that differ by less are the same, rad: rounding of the numbers of a guard.
const SAME: f64 = 1e-6;

/// Rotation of the tool axis with a rotary axis from which on the tool axis fixes its position, rad per rad.
const FIXES: f64 = 0.03;

/// What is wrong with a guard, which is no longer due.
pub(super) fn fault(guard: &RotaryGuard, phase: &mut Phase, rules: &Rules<'_>, previous: &Previous) -> Option<String> {
    let retracted = match phase {
        Phase::Retracted(retracted) => retracted,
        Phase::Cutting(_) | Phase::Leaving(_) => {
            return Some(
                "rotary positions are compared with the tool at the part: the look-ahead stops there".to_owned(),
            );
        }
        Phase::Unknown { .. } | Phase::Ended => {
            return Some("rotary positions are compared, and no plane call comes before".to_owned());
        }
    };
    retracted.plane_guard_due = false;
    if guard.largest > LARGEST * 1.01 {
        let largest = guard.largest;
        return Some(format!("the guard of the rotary positions allows {largest}, expected {LARGEST}"));
    }
    let differs = |(axis, position): &(usize, f64)| {
        let known = previous.known & (1 << axis) != 0;
        known && ((previous.words[*axis] - position) / 2.0).sin().abs() > SAME
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
    let fixes = rules.rounding().fixes_rotaries(2.0 * LARGEST)?.max(FIXES);
    let due = |index: &usize| compared & (1 << index) == 0 && rates[*index].norm() > fixes;
    let index = words.rotary().find(due).filter(|_| previous.known & words.rotary_bits() == words.rotary_bits())?;
    let letter = rules.axes()[index].letter;
    Some(format!("the position of {letter} is not compared after the plane call: the control may have chosen another"))
}
