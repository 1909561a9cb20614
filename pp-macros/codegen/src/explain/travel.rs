//! Tool axes within the declared travel of the rotary axes, branch by branch.
//!
//! A wrong sign or travel shows here: the branch in which the machine works has no travel, or another cone than the
//! machine.
//!
//! With the joint angle `θ` of the second rotary, `n·b = α0 + R cos(θ - φ)`, `φ = atan2(α2, α1)`, `R = √(α1² + α2²)`:
//! on one branch `θ - φ` is in [0°, 180°], on the other in [-180°, 0°], and on each the angle to the first rotary is
//! monotone.

use std::collections::BTreeMap;

use super::section::{Section, line};
use crate::model::{Axis, Model, to_f64};
use crate::solve::{OneRotary, Orientation, Solved, TwoRotaries};
use crate::symbolic::{Id, Symbol};

/// Travel below this counts as a single position, degrees.
const POINT: f64 = 1e-9;

/// A range of angles, degrees.
type Range = (f64, f64);

/// Adds the tool axes that the declared travel leaves; nothing if no solved rotary axis has limits.
pub(crate) fn within_travel(model: &Model, solved: &Solved, section: &mut Section) {
    let limited = model.solved_rotaries().any(|axis| model.axes[axis].limits.is_some());
    let (rotary, lines) = match &solved.orientation {
        Orientation::Fixed { .. } => return,
        _ if !limited => return,
        Orientation::One(one) => (one.rotary, vec![of_one(model, one)]),
        Orientation::Two(two) => (two.rotaries[0], of_two(model, solved, two)),
    };
    let first = model.axes[rotary].letter;
    section
        .line(line(&format!("Within the declared travel, as angles between the tool axis and the axis of {first}:")));
    lines.iter().for_each(|text| section.line(line(text)));
}

fn of_one(model: &Model, one: &OneRotary) -> String {
    let axis = &model.axes[one.rotary];
    format!("{}: the whole range above, in these positions of {} only", travel(axis), axis.letter)
}

fn of_two(model: &Model, solved: &Solved, two: &TwoRotaries) -> Vec<String> {
    let values = defaults(model);
    let value = |node: Id| solved.graph.evaluate(node, &|symbol| values.get(&symbol).copied());
    let [a1, a2] = two.second.alpha.map(value);
    let mean = value(two.tilt.between.cosine) * value(two.tilt.tool.cosine);
    let (phase, amplitude) = (a2.atan2(a1).to_degrees(), a1.hypot(a2));
    let [first, second] = two.rotaries.map(|id| &model.axes[id]);
    let mut lines = Vec::new();
    for (title, plus) in [("first branch:  ", two.first_is_plus()), ("second branch: ", !two.first_is_plus())] {
        let Some(parts) = parts_of_branch(second, phase, plus) else {
            lines.push(format!("{title}none: {} has no travel on this branch", second.letter));
            continue;
        };
        let angle =
            |from_phase: f64| (mean + amplitude * from_phase.to_radians().cos()).clamp(-1.0, 1.0).acos().to_degrees();
        let cones =
            joined(parts.iter().map(|part| sorted((angle(part.from_phase.0), angle(part.from_phase.1)))).collect());
        let words = match second.limits {
            None => travel(second),
            Some(_) => {
                format!("{} {}", second.letter, written(&parts.iter().map(|part| part.words).collect::<Vec<_>>()))
            }
        };
        lines.push(format!("{title}{}, {words}: {} degrees", travel(first), written(&cones)));
    }
    lines
}

/// A part of the travel that lies on one branch.
struct Part {
    /// Words of the axis.
    words: Range,
    /// These words as `θ - φ`, from 0 to ±180.
    from_phase: Range,
}

/// The parts of the travel of the second rotary on a branch; `None` if there are none.
fn parts_of_branch(axis: &Axis, phase: f64, plus: bool) -> Option<Vec<Part>> {
    let half = if plus { (0.0, 180.0) } else { (-180.0, 0.0) };
    let Some((lower, upper)) = &axis.limits else {
        return Some(vec![Part { words: half, from_phase: half }]);
    };
    let sign = if axis.reversed { -1.0 } else { 1.0 };
    let travel = sorted((sign * to_f64(lower), sign * to_f64(upper)));
    let first = ((travel.0 - phase) / 360.0).floor() as i64 - 1;
    let last = ((travel.1 - phase) / 360.0).ceil() as i64 + 1;
    let mut parts = Vec::new();
    for turn in first..=last {
        let start = phase + 360.0 * turn as f64;
        let joint = (travel.0.max(start + half.0), travel.1.min(start + half.1));
        let single = travel.1 - travel.0 < POINT;
        if joint.1 - joint.0 > POINT || (single && joint.1 >= joint.0) {
            let words = sorted((sign * joint.0, sign * joint.1));
            parts.push(Part { words, from_phase: (joint.0 - start, joint.1 - start) });
        }
    }
    parts.sort_by(|a, b| a.words.0.total_cmp(&b.words.0));
    (!parts.is_empty()).then_some(parts)
}

/// `B -5 to 110` or `C free`.
fn travel(axis: &Axis) -> String {
    match &axis.limits {
        None => format!("{} free", axis.letter),
        Some((lower, upper)) => format!("{} {}", axis.letter, written(&[(to_f64(lower), to_f64(upper))])),
    }
}

fn sorted((a, b): Range) -> Range {
    if a <= b { (a, b) } else { (b, a) }
}

/// Ranges in order, those that overlap as one.
fn joined(mut ranges: Vec<Range>) -> Vec<Range> {
    ranges.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut all: Vec<Range> = Vec::new();
    for range in ranges {
        match all.last_mut() {
            Some(last) if range.0 <= last.1 + POINT => last.1 = last.1.max(range.1),
            _ => all.push(range),
        }
    }
    all
}

fn written(ranges: &[Range]) -> String {
    let degrees = |value: f64| (value * 1e6).round() / 1e6 + 0.0;
    let one = |(lower, upper): &Range| match (degrees(*lower), degrees(*upper)) {
        (lower, upper) if upper - lower < POINT => format!("{lower}"),
        (lower, upper) => format!("{lower} to {upper}"),
    };
    ranges.iter().map(one).collect::<Vec<_>>().join(" and ")
}

/// Values of held axes and angles at their defaults.
fn defaults(model: &Model) -> BTreeMap<Symbol, f64> {
    model.defaults.iter().filter_map(|(symbol, value)| Some((*symbol, model.ring.value(value)?))).collect()
}
