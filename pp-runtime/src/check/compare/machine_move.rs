//! Motions to positions of the machine: its retract in the form of the configuration, and home positions.

use super::super::policy::RetractRule;
use super::super::read::{Action, Block};
use super::super::rules::Rules;
use super::Previous;
use crate::check::tolerances::ROUNDED_WORD;
use crate::kinematics::{Axis, AxisKind};

/// Where the configuration has other positions.
const KEYS: &str =
    "other positions of the axes have keys: `park`, `retract.tool_change_position`, `cycles.tool_position`";

/// What is wrong with a block as the machine retract.
pub(super) fn fault_of_retract(rules: &Rules<'_>, previous: &Previous, block: &Block) -> Option<String> {
    let (index, links) = (rules.words().retract(), &rules.policy().links);
    let position = links.retract_mm;
    let alone = block.written == 1 << index;
    let there = || (block.values[index] - position).abs() <= ROUNDED_WORD * rules.rounding().unit_mm;
    // Out of tip control that ends with the length offset, the block of machine coordinates ends both.
    let ends_tip_control = previous.tip_control && rules.facts().length_ends_tip_control;
    let coordinate = match links.retract {
        RetractRule::MachineCoordinate => true,
        RetractRule::ReferencePosition | RetractRule::OwnBlocks(_) => ends_tip_control,
        RetractRule::AlongTool => block.state.tool.is_none(),
    };
    match (block.action, links.retract) {
        (Action::Machine, _) if coordinate => (!alone || !there()).then(|| {
            format!(
                "motion in machine coordinates: expected the retract, which moves its axis alone to {}; {KEYS}",
                rules.units().length(position)
            )
        }),
        (Action::Reference { direct: true }, RetractRule::ReferencePosition) if !coordinate => (!alone)
            .then(|| "motion to the reference position: expected the retract, which moves its axis alone".to_owned()),
        (Action::Reference { .. }, RetractRule::ReferencePosition) if !coordinate => Some(
            "motion to the reference position through another point: its words must be distances of 0 (G91)".to_owned(),
        ),
        (Action::EndOfTravel, RetractRule::AlongTool) => (!alone || !rules.tool_leads_along_retract(&block.state))
            .then(|| "retract along the tool axis, which is not the retract axis here".to_owned()),
        (Action::Reference { .. }, _) => {
            Some("motion to the reference point: its path is unknown, and the position after it".to_owned())
        }
        _ => Some(format!("motion to a position of the machine that is not the retract of `retract.method`; {KEYS}")),
    }
}

/// What is wrong with the way of the machine retract: it must lead away from the part. Where `machine_zero` or the
/// length of the tool is unknown, it is not compared.
pub(super) fn leads_down(rules: &Rules<'_>, previous: &Previous, block: &Block) -> Option<String> {
    let (words, policy) = (rules.words(), rules.policy());
    let index = words.retract();
    let axis = &rules.axes()[index];
    let zero = policy.set_up.machine_zero.get(&axis.letter).filter(|_| words.is_length_known())?;
    let by_word = || previous.value_of_retract_axis(rules, &block.state, previous.known & block.known_before);
    let coordinate = previous.retract_axis.or_else(by_word)? + zero + words.gauge_of(index);
    let down = (coordinate - policy.links.retract_mm) * words.outwards();
    (down > rules.rounding().unit_mm).then(|| {
        format!(
            "the machine retract leads {} towards the part: {} is at machine coordinate {} before it",
            rules.units().coordinate(down),
            axis.letter,
            rules.units().coordinate(coordinate)
        )
    })
}

/// Linear axes other than the retract axis, by position in the chain.
fn others<'a>(rules: &'a Rules<'_>) -> impl Iterator<Item = (usize, &'a Axis)> {
    let retract = rules.words().retract();
    let linear = |axis: &Axis| axis.kind == AxisKind::Linear && !axis.held;
    rules.axes().iter().enumerate().filter(move |(index, axis)| *index != retract && linear(axis))
}

/// Whether a block moves the other linear axes to their home positions, in the form of the machine retract.
pub(super) fn goes_home(rules: &Rules<'_>, block: &Block) -> bool {
    let links = &rules.policy().links;
    let Some(home) = &links.home_mm else { return false };
    let all = others(rules).fold(0, |bits, (index, _)| bits | 1 << index);
    let largest = ROUNDED_WORD * rules.rounding().unit_mm;
    let there = |(index, axis): (usize, &Axis)| {
        home.get(&axis.letter).is_some_and(|position| (block.values[index] - position).abs() <= largest)
    };
    block.written == all
        && match (links.retract, block.action) {
            (RetractRule::ReferencePosition, action) => action == Action::Reference { direct: true },
            (_, action) => action == Action::Machine && others(rules).all(there),
        }
}

/// Whether the other linear axes must be at their home positions, and some are not; `homed`: those that are, as bits.
pub(super) fn is_not_home(rules: &Rules<'_>, homed: u16) -> bool {
    rules.policy().links.home_mm.is_some() && others(rules).any(|(index, _)| homed & (1 << index) == 0)
}
