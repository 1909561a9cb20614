//! Positions of the axes at the machine retract, from the configuration: for parking, and for measuring a tool.

use std::collections::BTreeMap;

use super::super::read::{Block, MAX_AXES};
use super::super::rules::{Rules, apart};
use super::Previous;
use crate::check::tolerances::ROUNDED_WORD;
use crate::kinematics::Axis;

/// Whether a block moves rotary axes to their places, or nearer to them: an axis that takes the shorter way goes
/// there in steps of less than half a revolution, and the others with it.
pub(super) fn moves_rotary(
    rules: &Rules<'_>,
    places: &BTreeMap<char, f64>,
    previous: &Previous,
    block: &Block,
) -> bool {
    let (values, before) = (rules.words().values(&block.values), rules.words().values(&previous.words));
    let rotary = rules.words().rotary_bits();
    let largest = ROUNDED_WORD * rules.rounding().unit_rad;
    let there = |index: usize, place: f64| apart(values[index], place) <= largest;
    // An axis whose angle blocks of the shop have made unknown may be where it was.
    let nearer = |index: usize, place: f64| apart(values[index], place) < apart(before[index], place);
    // A word of the place where an axis is moves nothing.
    let all = rules.all_moved(&previous.words, previous.known, block);
    let moves = if all & rotary == 0 { block.written & rotary } else { all & rotary };
    let moved = || rules.axes().iter().enumerate().filter(|(index, _)| moves & (1 << index) != 0);
    let place = |letter: &char| places.get(letter).copied();
    let in_steps = moved().any(|(index, axis)| {
        rules.policy().words.rollover.contains_key(&axis.letter)
            && place(&axis.letter).is_some_and(|place| !there(index, place) && nearer(index, place))
    });
    let parks = |(index, axis): (usize, &Axis)| {
        place(&axis.letter).is_some_and(|place| there(index, place) || in_steps && nearer(index, place))
    };
    all & !rotary == 0 && moved().all(parks)
}

/// Whether a block moves linear axes to their places.
pub(super) fn moves_linear(rules: &Rules<'_>, places: &BTreeMap<char, f64>, block: &Block) -> bool {
    let largest = ROUNDED_WORD * rules.rounding().unit_mm;
    let at = |(index, axis): (usize, &Axis)| {
        let place = places.get(&axis.letter);
        block.written & (1 << index) == 0 || place.is_some_and(|place| (block.values[index] - place).abs() <= largest)
    };
    block.written & !rules.words().linear_bits() == 0 && rules.axes().iter().enumerate().all(at)
}

/// Letters of the axes that are not at their places with these words; `moved`: linear axes that have moved there.
pub(super) fn missing(
    rules: &Rules<'_>,
    places: &BTreeMap<char, f64>,
    moved: u16,
    words: &[f64; MAX_AXES],
) -> impl Iterator<Item = char> {
    let values = rules.words().values(words);
    let (unit_mm, largest) = (rules.rounding().unit_mm, ROUNDED_WORD * rules.rounding().unit_rad);
    let (rotary, retract) = (rules.words().rotary_bits(), rules.words().retract());
    let solved = rules.axes().iter().enumerate().filter(|(_, axis)| !axis.held);
    solved.filter_map(move |(index, axis)| {
        let place = *places.get(&axis.letter)?;
        // Whole turns count where the axis does not roll over.
        let off = match rules.policy().words.rollover.contains_key(&axis.letter) {
            true => apart(values[index], place),
            false => (values[index] - place).abs(),
        };
        let rotated = rotary & (1 << index) != 0 && off <= largest;
        let retracted = index == retract && (place - rules.policy().links.retract_mm).abs() < unit_mm;
        (!rotated && !retracted && moved & (1 << index) == 0).then_some(axis.letter)
    })
}
