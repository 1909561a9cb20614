//! What the reader of a program has to know of the set-up: names of axes and tools, codes of the shop.

use super::policy::Policy;
use super::read::{AxisName, Vocabulary, coolant};
use crate::kinematics::{AnyMachine, Axis, AxisKind};
use crate::program::Units;

/// Names and codes of a program.
pub(super) fn vocabulary(machine: &dyn AnyMachine, policy: &Policy, units: Units) -> Vocabulary {
    let axis = |axis: &Axis| AxisName {
        name: policy
            .words
            .axis_names
            .get(&axis.letter)
            .map_or_else(|| axis.letter.to_string(), String::clone)
            .into_bytes(),
        rotary: axis.kind == AxisKind::Rotary,
        rollover: policy.words.rollover.get(&axis.letter).copied(),
    };
    let mut known: Vec<Vec<u8>> = Vec::new();
    for line in &policy.shop.lines {
        known.push(line.trim().as_bytes().to_vec());
        known.extend(line.split_whitespace().map(|word| word.as_bytes().to_vec()));
    }
    let kinds = [coolant::FLOOD, coolant::MIST, coolant::THROUGH, coolant::AIR];
    let codes = policy.shop.coolant.iter().zip(kinds).filter_map(|(codes, bit)| Some((codes.as_ref()?, bit)));
    let mut switches: Vec<(Vec<u8>, u8, bool)> = Vec::new();
    for ([on, off], bit) in codes {
        switches.push((on.trim().as_bytes().to_vec(), bit, true));
        // One code may switch off several kinds.
        let off = off.trim().as_bytes().to_vec();
        match switches.iter_mut().find(|(code, _, on)| *code == off && !on) {
            Some((_, bits, _)) => *bits |= bit,
            None => switches.push((off, bit, false)),
        }
    }
    let tools = policy.set_up.tools.iter().filter_map(|(number, tool)| Some((tool.name.clone()?, *number)));
    Vocabulary {
        family: policy.family,
        axes: machine.axes().iter().map(axis).collect(),
        known,
        coolant: switches,
        plain: policy.words.plain_numbers,
        tools: tools.collect(),
        rounding: 0.5 * 10_f64.powi(-(policy.digits.linear(units) as i32)) * units.in_mm(),
    }
}
