//! Chains that are listed in another order than from workpiece to tool.

use crate::model::{Axis, AxisId, AxisKind, Model, Side};
use crate::solve::solve;

/// Help for a rotary axis that cannot tilt the tool: the order in which it could, if there is one; then `hold`.
pub(crate) fn or_hold(model: &Model, axis: AxisId) -> String {
    let letter = model.axes[axis].letter;
    let hold = format!("`hold = {{ {letter}: 0 }};`");
    // Linear axes in the order Z Y X: the whole chain is probably listed from the tool.
    let linears: Vec<char> = model.solved_linears().map(|id| model.axes[id].letter).collect();
    let backwards = linears.len() == 3 && linears.iter().rev().is_sorted();
    let next_to = match model.axes[axis].side {
        Side::Workpiece => "the axis next to the workpiece comes first",
        Side::Tool => "the axis next to the tool comes last",
    };
    // Linear axes before the frame and the rotary axis after it: the tool side is probably listed first.
    let tool_side_first = !backwards
        && model.axes[axis].side == Side::Tool
        && model.solved_linears().all(|id| model.axes[id].side == Side::Workpiece);
    let others = [
        backwards.then(|| ("the axes are listed from the workpiece to the tool", whole_reversed(model))),
        rotaries_exchanged(model).map(|other| (next_to, other)),
        tool_side_first.then(|| ("with both rotary axes in the table", both_in_the_table(model, axis))),
        tool_side_first.then(|| ("the side of the workpiece comes before `|`", sides_exchanged(model))),
    ];
    let solvable = others.into_iter().flatten().filter(|(_, other)| solve(other).is_ok());
    let orders: Vec<String> = solvable.map(|(reason, other)| format!("{reason}: {}", chain(&other))).collect();
    if orders.is_empty() {
        return format!("put {letter} in `hold`: {hold}");
    }
    format!("{}; if the order is right, {letter} is not solved for: {hold}", orders.join("; or "))
}

/// The chain from the other end.
fn whole_reversed(model: &Model) -> Model {
    let mut other = model.clone();
    other.axes.reverse();
    for axis in &mut other.axes {
        axis.side = axis.side.across();
    }
    other
}

/// The chain with all rotary axes before the frame, `first` at the workpiece, and the linear axes after it.
fn both_in_the_table(model: &Model, first: AxisId) -> Model {
    let mut other = model.clone();
    let next_to_workpiece = other.axes.remove(first);
    other.axes.insert(0, next_to_workpiece);
    other.axes.sort_by_key(|axis| axis.kind == AxisKind::Linear);
    for axis in &mut other.axes {
        axis.side = if axis.kind == AxisKind::Linear { Side::Tool } else { Side::Workpiece };
    }
    other
}

/// The chain with what is after the frame before it.
fn sides_exchanged(model: &Model) -> Model {
    let mut other = model.clone();
    for axis in &mut other.axes {
        axis.side = axis.side.across();
    }
    other.axes.sort_by_key(|axis| axis.side == Side::Tool);
    other
}

/// The chain with its two solved rotary axes exchanged, if both are on one side of the frame.
fn rotaries_exchanged(model: &Model) -> Option<Model> {
    let rotaries: Vec<AxisId> = model.solved_rotaries().collect();
    let [first, second] = rotaries[..] else { return None };
    if model.axes[first].side != model.axes[second].side {
        return None;
    }
    let mut other = model.clone();
    other.axes.swap(first, second);
    Some(other)
}

/// `` `chain: C B | X Y Z;` ``
fn chain(model: &Model) -> String {
    let bar = model.axes.iter().take_while(|axis| axis.side == Side::Workpiece).count();
    let mut words: Vec<String> = model.axes.iter().map(|Axis { letter, .. }| letter.to_string()).collect();
    words.insert(bar, "|".into());
    format!("`chain: {};`", words.join(" "))
}
