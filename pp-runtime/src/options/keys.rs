//! Keys of planning that are tables by axis or have their own syntax.

use nalgebra::{Point3, Vector3};
use serde_json::{Value as Json, json};

use crate::keys::{
    AxisEntry, AxisSet, Bound, KeyKind, KeyReader, KeyScope, KeyTable, LengthPoint, PerAxis, Printed, QuantityKind,
    TomlValue, along, solved,
};
use crate::kinematics::{Axis, AxisKind, Limits};
use crate::program::{Clearance, ClearancePlane, Units};

use super::CourseOptions;
use crate::tolerance::writer::{CONVERTED_NOISE, INDEX_STEP_NOISE};

const FORMS: &str = "write `{ plane = 80 }`, `{ box = [[-60, -60, -40], [60, 60, 30]] }` or \
                     `{ cylinder = { radius = 90, lower = -40, upper = 30 } }`";

const SCHEMA: &str = r#"{
    "type": "object", "minProperties": 1, "maxProperties": 1, "additionalProperties": false,
    "properties": {
        "plane": { "type": "number" },
        "box": {
            "type": "array", "minItems": 2, "maxItems": 2,
            "items": { "type": "array", "items": { "type": "number" }, "minItems": 3, "maxItems": 3 }
        },
        "cylinder": {
            "type": "object", "additionalProperties": false, "required": ["radius", "lower", "upper"],
            "properties": {
                "radius": { "type": "number", "exclusiveMinimum": 0 },
                "lower": { "type": "number" },
                "upper": { "type": "number" },
                "centre": { "type": "array", "items": { "type": "number" }, "minItems": 2, "maxItems": 2 }
            }
        }
    }
}"#;

/// How the codes of a clamp are written.
fn clamp_form(letter: char) -> String {
    format!("write `{letter} = {{ on = \"M10\", off = \"M11\" }}`")
}

/// A plane, a box or a cylinder around the part.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Geometry;

impl KeyKind for Geometry {
    type Value = Clearance;

    fn read(&self, r: &mut KeyReader<'_>, value: TomlValue<'_>) -> Option<Clearance> {
        geometry(r, value)
    }

    fn print(&self, _value: &Clearance) -> String {
        String::new()
    }

    fn schema(&self, _scope: &KeyScope) -> Json {
        serde_json::from_str(SCHEMA).unwrap_or_default()
    }
}

/// `B+`: a rotary axis, and the preferred side of zero at the beginning of operations.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Preference;

impl KeyKind for Preference {
    type Value = (char, bool);

    fn read(&self, r: &mut KeyReader<'_>, value: TomlValue<'_>) -> Option<(char, bool)> {
        let text = r.line(value)?;
        let KeyScope { machine, axes, .. } = r.scope();
        let preference = CourseOptions::preference(axes, &text);
        if preference.is_none() {
            r.fault(
                value.span(),
                format!("\"{text}\" is not a rotary axis with `+` or `-`"),
                Some(CourseOptions::preferences(machine, axes)),
            );
        }
        preference
    }

    fn print(&self, &(letter, positive): &(char, bool)) -> String {
        format!("\"{letter}{}\"", if positive { '+' } else { '-' })
    }

    fn schema(&self, _scope: &KeyScope) -> Json {
        json!({ "type": "string" })
    }

    fn printed(&self, scope: &KeyScope) -> Option<Printed> {
        let rotary = scope.axes.iter().rev().find(|axis| solved(axis));
        Some(Printed::Example(self.print(&(rotary.map_or('B', |axis| axis.letter), true))))
    }
}

impl CourseOptions {
    /// Reads `B+`: a rotary axis of the machine, and the preferred side of zero at the beginning of operations.
    pub(crate) fn preference(axes: &[Axis], text: &str) -> Option<(char, bool)> {
        let positive = [('+', true), ('-', false)];
        positive.into_iter().find_map(|(sign, positive)| {
            let letter = text.strip_suffix(sign)?.trim();
            let named = |axis: &&Axis| solved(axis) && letter.eq_ignore_ascii_case(&axis.letter.to_string());
            axes.iter().find(named).map(|axis| (axis.letter, positive))
        })
    }

    /// Help line with the preferences that a machine allows.
    pub(crate) fn preferences(machine: &str, axes: &[Axis]) -> String {
        let rotaries = axes.iter().filter(|axis| solved(axis));
        let all: Vec<String> =
            rotaries.flat_map(|axis| ['+', '-'].map(|sign| format!("\"{}{sign}\"", axis.letter))).collect();
        match all.is_empty() {
            true => format!("{machine} has no rotary axis"),
            false => format!("write one of {}", all.join(", ")),
        }
    }
}

/// Park positions of the axes.
pub(crate) const PARK: PerAxis<f64> = PerAxis {
    axes: AxisSet::All,
    section: false,
    read: |r, &AxisEntry { axis, value, .. }| {
        let position = along(r, axis, value, Bound::Any)?;
        // A position at the limit must pass.
        if let Some(limits) = r.travel_of(axis)
            && !(limits.lower - CONVERTED_NOISE..=limits.upper + CONVERTED_NOISE).contains(&position)
        {
            let travel = show_limits(axis, limits, r.units());
            let letter = axis.letter;
            r.fault(
                value.span(),
                format!("{letter} cannot be there: its travel (`limits.{letter}`) is {travel}"),
                None,
            );
        }
        Some(position)
    },
    printed: |_, axis| (axis.kind == AxisKind::Rotary).then(|| Printed::Example("0.0".to_owned())),
    schema: || json!({ "type": "number" }),
};

/// Home positions of linear axes.
pub(crate) const HOME: PerAxis<f64> = PerAxis {
    axes: AxisSet::Linear,
    section: false,
    read: PARK.read,
    printed: |_, axis| {
        let linear = axis.kind == AxisKind::Linear && !axis.held && axis.letter != 'Z';
        linear.then(|| Printed::Example("0.0".to_owned()))
    },
    schema: PARK.schema,
};

/// Rollover of the words of endless axes.
pub(crate) const WRAP: PerAxis<Wrap> = PerAxis {
    axes: AxisSet::All,
    section: true,
    read: |r, AxisEntry { axis, span, value }| {
        let wrap = r.choice(value, &Wrap::NAMES)?;
        if !solved(axis) || r.travel_of(axis).is_some() {
            let text = format!("{} is not an endless rotary axis: its words cannot roll over", axis.letter);
            r.fault(span.clone(), text, Some(format!("set `[limits] {} = \"free\"` if it is endless", axis.letter)));
            return None;
        }
        wrap
    },
    printed: |_, axis| (solved(axis) && axis.limits.is_none()).then(|| Printed::Default("\"none\"".to_owned())),
    schema: || json!({ "enum": Wrap::NAMES.map(|(word, _)| word) }),
};

/// Steps of indexed axes; they divide a full turn.
pub(crate) const GRID: PerAxis<f64> = PerAxis {
    axes: AxisSet::Solved,
    section: true,
    read: |r, entry| {
        let step = r.number(entry.value, QuantityKind::Angle, Bound::Positive)?;
        let steps = std::f64::consts::TAU / step;
        if (steps - steps.round()).abs() > INDEX_STEP_NOISE * steps || steps < 2.0 {
            let help = "give for example 1, 2.5 or 5 degrees".to_owned();
            r.fault(entry.value.span(), "the step of an indexed axis must divide 360 degrees", Some(help));
            return None;
        }
        Some(step)
    },
    printed: |_, axis| solved(axis).then(|| Printed::Example("1.0".to_owned())),
    schema: || json!({ "type": "number", "exclusiveMinimum": 0 }),
};

/// Clamps of the rotary axes, A and B before C: brakes of the fourth and of the fifth axis.
const CLAMP_EXAMPLES: [&str; 2] = ["{ on = \"M10\", off = \"M11\" }", "{ on = \"M12\", off = \"M13\" }"];

/// Clamp codes.
pub(crate) const CLAMP: PerAxis<ClampCodes> = PerAxis {
    axes: AxisSet::Solved,
    section: true,
    read: clamp_codes,
    printed: |scope, axis| {
        let rotary = || scope.axes.iter().filter(|axis| solved(axis)).map(|axis| axis.letter);
        rotary().find(|letter| *letter == axis.letter)?;
        let place = rotary().filter(|letter| *letter < axis.letter).count();
        let of_control = scope.examples_of("clamp").nth(place);
        Some(Printed::Example(of_control.or_else(|| CLAMP_EXAMPLES.get(place).copied())?.to_owned()))
    },
    schema: || {
        let code = json!({ "type": "string" });
        json!({
            "type": "object",
            "properties": { "on": code.clone(), "off": code },
            "additionalProperties": false
        })
    },
};

fn clamp_codes(r: &mut KeyReader<'_>, entry: &AxisEntry<'_>) -> Option<ClampCodes> {
    let mut table = KeyTable::of(r, format!("clamp.{}", entry.axis.letter), Some(entry.value));
    let values = ["on", "off"].map(|key| table.get(key, r));
    let given = values.iter().flatten().count();
    let codes = values.map(|value| value.and_then(|value| clamp_code(r, entry.axis.letter, value)));
    table.close(r);
    match codes {
        [Some(on), Some(off)] if on != off => Some(ClampCodes { on, off }),
        // What is wrong with one of them has been said.
        [None, _] | [_, None] if given == 2 => None,
        _ => {
            r.fault(entry.value.span(), "two different codes are needed here", Some(clamp_form(entry.axis.letter)));
            None
        }
    }
}

/// Reads an M code, with or without parameters P, Q, L and E.
fn clamp_code(r: &mut KeyReader<'_>, letter: char, value: TomlValue<'_>) -> Option<String> {
    let code = r.line(value)?;
    let number = |text: &str| !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
    let mut words = code.split(' ');
    let first = words.next().and_then(|word| word.strip_prefix('M')).is_some_and(number);
    if first && words.all(|word| word.strip_prefix(['P', 'Q', 'L', 'E']).is_some_and(number)) {
        return Some(code);
    }
    r.fault(value.span(), format!("\"{code}\" is not an M code"), Some(clamp_form(letter)));
    None
}

fn show_limits(axis: &Axis, limits: Limits, units: Units) -> String {
    match axis.kind {
        AxisKind::Linear => {
            format!("{:.3} to {:.3} {}", limits.lower / units.in_mm(), limits.upper / units.in_mm(), units.name())
        }
        AxisKind::Rotary => format!("{:.4} to {:.4} degrees", limits.lower.to_degrees(), limits.upper.to_degrees()),
    }
}

/// Reads one geometry and reports its faults.
fn geometry(r: &mut KeyReader<'_>, value: TomlValue<'_>) -> Option<Clearance> {
    let entries = r.entries(value);
    let [(kind, span, value)] = &entries[..] else {
        if value.get_ref().as_table().is_some() {
            r.missing_key(value.span(), "one of `plane`, `box` and `cylinder` is needed here", Some(FORMS.to_owned()));
        }
        return None;
    };
    match *kind {
        "plane" => {
            let distance = r.length(value, Bound::Any)?;
            Some(Clearance::Plane(ClearancePlane { normal: Vector3::z_axis(), distance_mm: distance }))
        }
        "box" => read_box(r, value),
        "cylinder" => read_cylinder(r, value),
        other => {
            r.unknown_key(span.clone(), format!("`{other}` is not a clearance geometry"), Some(FORMS.to_owned()));
            None
        }
    }
}

fn read_box(r: &mut KeyReader<'_>, value: TomlValue<'_>) -> Option<Clearance> {
    let corners = r.list(value)?;
    let [lower, upper] = corners[..] else {
        r.fault(value.span(), "two corners are needed here", Some(FORMS.to_owned()));
        return None;
    };
    let [lower, upper] = [LengthPoint.read(r, lower)?, LengthPoint.read(r, upper)?];
    if (0..3).any(|i| lower[i] >= upper[i]) {
        r.fault(value.span(), "the box is empty: give the lower corner first", None);
        return None;
    }
    Some(Clearance::Box { lower: Point3::from(lower), upper: Point3::from(upper) })
}

fn read_cylinder(r: &mut KeyReader<'_>, value: TomlValue<'_>) -> Option<Clearance> {
    let (mut radius, mut lower, mut upper, mut centre) = (None, None, None, [0.0; 2]);
    for (key, span, value) in r.entries(value) {
        match key {
            "radius" => radius = r.length(value, Bound::Positive),
            "lower" => lower = r.length(value, Bound::Any),
            "upper" => upper = r.length(value, Bound::Any),
            "centre" => {
                let numbers = r.list(value)?;
                let [x, y] = numbers[..] else {
                    r.fault(value.span(), "X and Y are needed here", None);
                    return None;
                };
                centre = [r.length(x, Bound::Any)?, r.length(y, Bound::Any)?];
            }
            other => r.unknown_key(span, format!("`{other}` is not a key of a cylinder"), Some(FORMS.to_owned())),
        }
    }
    match (radius, lower, upper) {
        (Some(radius), Some(lower), Some(upper)) if lower < upper => {
            Some(Clearance::Cylinder { centre, radius_mm: radius, lower_z_mm: lower, upper_z_mm: upper })
        }
        _ => {
            r.fault(value.span(), "`radius`, `lower` and a higher `upper` are needed here", Some(FORMS.to_owned()));
            None
        }
    }
}

/// Rollover of the words of an endless rotary axis; without it the words count beyond 360 degrees.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Wrap {
    /// From 0 up to 360; the control takes the shortest path.
    Positive,
    /// From -180 up to 180; the control takes the shortest path.
    Symmetric,
    /// From 0 up to 360, with the sense of rotation as sign; zero that is reached backwards is written as -360.
    Sign,
}

impl Wrap {
    /// Names in a file; the first means no rollover.
    pub(crate) const NAMES: [(&'static str, Option<Self>); 4] = [
        ("none", None),
        ("0..360", Some(Self::Positive)),
        ("+-180", Some(Self::Symmetric)),
        ("sign", Some(Self::Sign)),
    ];
}

/// Codes for the clamp of a rotary axis.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ClampCodes {
    /// Clamp.
    pub on: String,
    /// Unclamp.
    pub off: String,
}
