//! What the reader of a program has to know of the set-up: names of axes and tools, codes of the shop.

use super::policy::{CheckPolicy, ShopLine};
use super::read::{AxisName, Effect, Lookup, OwnText, Vocabulary, is_read, moves, refusal};
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
        lookup: Lookup::default(),
        swivel_data: policy.shop.swivel_data.clone(),
        spindle_number: policy.shop.spindle_number,
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

/// Declared effects that contradict the control's own language, and blocks in the place of statements of CL data that
/// move an axis, each by its key.
pub(crate) fn faults_of_lines<'b>(
    machine: &dyn AnyMachine,
    policy: &CheckPolicy,
    declared: impl Iterator<Item = (&'b str, Effect)>,
    statements: impl Iterator<Item = (&'b str, &'b str)>,
) -> Vec<String> {
    let vocabulary = vocabulary(machine, policy, Units::Millimetres);
    let of_effects = declared.filter_map(|(text, effect)| {
        let why = refusal(text, effect, &vocabulary)?;
        Some(format!("no effect can be declared for `{text}` (`control.effects`): {why}"))
    });
    let of_statements = statements.filter(|(_, block)| block.lines().any(|line| moves(line, &vocabulary)));
    let of_statements = of_statements.map(|(statement, block)| {
        format!(
            "`{block}` of `[cl.words]` moves an axis: what a statement of the shop (`{statement}`) moves is not in the CL data, and \
             is not compared"
        )
    });
    of_effects.chain(of_statements).collect()
}
