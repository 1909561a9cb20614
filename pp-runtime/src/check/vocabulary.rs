//! What the reader of a program has to know of the set-up: names of axes and tools, codes of the shop.

use super::policy::{CheckPolicy, ShopLine};
use super::read::{AxisName, Effect, OwnText, Vocabulary, is_read};
use crate::kinematics::{AnyMachine, Axis, AxisKind};
use crate::program::Units;

/// Names and codes of a program.
pub(super) fn vocabulary(machine: &dyn AnyMachine, policy: &CheckPolicy, units: Units) -> Vocabulary {
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
    let own = |line: &ShopLine| OwnText {
        text: line.text.trim().as_bytes().to_vec(),
        place: line.place,
        coolant: line.coolant,
    };
    let declared = policy.shop.effects.iter().map(|(text, effect)| (text.clone().into_bytes(), *effect));
    let tools = policy.set_up.tools.iter().filter_map(|(number, tool)| Some((tool.name.clone()?, *number)));
    let mut vocabulary = Vocabulary {
        family: policy.family,
        axes: machine.axes().iter().map(axis).collect(),
        own: policy.shop.lines.iter().map(own).collect(),
        effects: declared.collect(),
        swivel_data: policy.shop.swivel_data.clone(),
        plain: policy.words.plain_numbers,
        tools: tools.collect(),
        tools_by_name: policy.shop.tool_names,
        rounding: 0.5 * 10_f64.powi(-(policy.digits.linear(units) as i32)) * units.in_mm(),
    };
    // What the table reads is executed by its codes: a motion among the lines that measure is a motion.
    let measuring = policy.shop.measuring.iter().map(|line| line.trim().as_bytes().to_vec());
    let unread: Vec<_> = measuring.filter(|line| !is_read(line, &vocabulary)).collect();
    vocabulary.effects.extend(unread.into_iter().map(|line| (line, Effect::Measures)));
    vocabulary
}
