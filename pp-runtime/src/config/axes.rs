//! Tables of a configuration file whose keys are axes or dimensions of the machine.

use std::collections::BTreeMap;
use std::ops::Range;

use crate::kinematics::{Axis, AxisKind, DimensionKind, Limits, Machine};

use super::Units;
use super::value::{Bound, Quantity, Reader, Shape, Value, list, nearest};

pub(super) fn read_machine_zero<M: Machine>(r: &mut Reader<'_>, value: Option<Value<'_>>) -> BTreeMap<char, f64> {
    let mut read = BTreeMap::new();
    for (axis, value, span) in read_axes::<M>(r, value) {
        if axis.kind == AxisKind::Rotary {
            let help = format!("linear axes are {}", letters::<M>(|axis| axis.kind == AxisKind::Linear));
            r.fault(span, format!("{} turns; `machine_zero` is for linear axes", axis.letter), Some(help));
        } else if let Some(position) = r.length(value, Bound::Any) {
            read.insert(axis.letter, position);
        }
    }
    read
}

/// `[lowest, highest]`, or `"free"`.
const TRAVEL: &str = r#"{ "anyOf": [{ "const": "free" }, { "type": "array", "items": { "type": "number" }, "minItems": 2, "maxItems": 2 }] }"#;

pub(super) fn read_limits<M: Machine>(r: &mut Reader<'_>, value: Option<Value<'_>>) -> BTreeMap<char, Option<Limits>> {
    let mut read = BTreeMap::new();
    for (axis, value, _) in read_axes::<M>(r, value) {
        if value.get_ref().is_str() {
            read.extend(r.choice(value, &[("free", ())]).map(|()| (axis.letter, None)));
            r.note(value, || Shape::Schema(TRAVEL));
            continue;
        }
        r.note(value, || Shape::Schema(TRAVEL));
        let Some(numbers) = r.list(value) else { continue };
        let &[lower, upper] = numbers.as_slice() else {
            r.fault(value.span(), "a travel is [lowest, highest] or \"free\"", None);
            continue;
        };
        let [lower, upper] = [lower, upper].map(|number| along(r, axis, number, Bound::Any));
        let (Some(lower), Some(upper)) = (lower, upper) else { continue };
        if lower > upper {
            let help = "the lowest value comes first".to_owned();
            r.fault(value.span(), format!("this travel of {} is empty", axis.letter), Some(help));
        } else {
            read.insert(axis.letter, Some(Limits { lower, upper }));
        }
    }
    read
}

pub(super) fn read_dimensions<M: Machine>(r: &mut Reader<'_>, value: Option<Value<'_>>) -> BTreeMap<String, f64> {
    let mut read = BTreeMap::new();
    for (key, span, value) in value.map_or_else(Vec::new, |value| r.entries(value)) {
        let Some(dimension) = M::DIMENSIONS.iter().find(|dimension| dimension.name == key) else {
            let names = M::DIMENSIONS.iter().map(|dimension| dimension.name);
            let help = match nearest(key, names.clone()) {
                Some(near) => format!("did you mean `{near}`?"),
                None if M::DIMENSIONS.is_empty() => format!("{} has no dimensions", M::NAME),
                None => format!("its dimensions are {}", list(names, '`')),
            };
            r.fault(span, format!("`{key}` is not a dimension of {}", M::NAME), Some(help));
            continue;
        };
        let number = match dimension.kind {
            DimensionKind::Length => r.length(value, Bound::Any),
            DimensionKind::Angle => r.number(value, Quantity::Angle, Bound::Any),
        };
        read.extend(number.map(|number| (key.to_owned(), number)));
    }
    read
}

/// The entries of a table whose keys are axes of the machine, with the place of the key.
pub(super) fn read_axes<'a, M: Machine>(
    r: &mut Reader<'_>,
    value: Option<Value<'a>>,
) -> Vec<(&'static Axis, Value<'a>, Range<usize>)> {
    let mut read = Vec::new();
    if let Some(value) = value {
        r.note(value, || Shape::Names(M::AXES.iter().map(|axis| axis.letter.to_string()).collect()));
    }
    for (key, span, value) in value.map_or_else(Vec::new, |value| r.entries(value)) {
        match M::AXES.iter().find(|axis| axis.letter.to_string() == key) {
            Some(axis) => read.push((axis, value, span)),
            None => {
                let help = format!("its axes are {}", letters::<M>(|_| true));
                r.fault(span, format!("`{key}` is not an axis of {}", M::NAME), Some(help));
            }
        }
    }
    read
}

/// The entries of a table whose keys are rotary axes that are solved.
pub(super) fn solved_rotaries<'a, M: Machine>(
    r: &mut Reader<'_>,
    value: Option<Value<'a>>,
) -> Vec<(&'static Axis, Value<'a>)> {
    let solved = |axis: &Axis| axis.kind == AxisKind::Rotary && !axis.held;
    let mut read = Vec::new();
    let entries = read_axes::<M>(r, value);
    if let Some(value) = value {
        let solved = M::AXES.iter().filter(|axis| solved(axis));
        r.note(value, || Shape::Names(solved.map(|axis| axis.letter.to_string()).collect()));
    }
    for (axis, value, span) in entries {
        if solved(axis) {
            read.push((axis, value));
        } else {
            let help = format!("these are {}", letters::<M>(solved));
            r.fault(span, format!("{} is no rotary axis that is solved", axis.letter), Some(help));
        }
    }
    read
}

/// Steps of rotary axes that divide a turn.
pub(super) fn read_grid<M: Machine>(r: &mut Reader<'_>, value: Option<Value<'_>>) -> BTreeMap<char, f64> {
    let mut grid = BTreeMap::new();
    for (axis, value) in solved_rotaries::<M>(r, value) {
        let Some(step) = r.number(value, Quantity::Angle, Bound::Positive) else { continue };
        let steps = std::f64::consts::TAU / step;
        if (steps - steps.round()).abs() > 1e-9 * steps || steps < 2.0 {
            r.fault(
                value.span(),
                "the steps of an indexed axis divide a turn",
                Some("e.g. 1, 2.5 or 5 degrees".to_owned()),
            );
            continue;
        }
        grid.insert(axis.letter, step);
    }
    grid
}

/// A position or speed of an axis, mm or rad.
pub(super) fn along(r: &mut Reader<'_>, axis: &Axis, value: Value<'_>, bound: Bound) -> Option<f64> {
    match axis.kind {
        AxisKind::Linear => r.number(value, Quantity::Length, bound),
        AxisKind::Rotary => r.number(value, Quantity::Angle, bound),
    }
}

fn letters<M: Machine>(wanted: impl Fn(&Axis) -> bool) -> String {
    let letters: Vec<String> = M::AXES.iter().filter(|axis| wanted(axis)).map(|axis| axis.letter.to_string()).collect();
    letters.join(" ")
}

pub(super) fn show_limits(axis: &Axis, limits: Limits, units: Units) -> String {
    match axis.kind {
        AxisKind::Linear => {
            format!("{:.3} to {:.3} {}", limits.lower / units.in_mm(), limits.upper / units.in_mm(), units.name())
        }
        AxisKind::Rotary => format!("{:.4} to {:.4} degrees", limits.lower.to_degrees(), limits.upper.to_degrees()),
    }
}
