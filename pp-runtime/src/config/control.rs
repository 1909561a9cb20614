//! `[control]`: how the control that is chosen differs from its table.

use crate::control::template::{self, BadTemplate, Field, OF_PROGRAM, OF_TOOL};
use crate::kinematics::Machine;

use super::axes::read_axes;
use super::read::set;
use super::value::{Bound, Quantity, Reader, Section, Shape, Value, list, nearest};
use super::{Config, PathNorm, Smoothing, WORK_OFFSETS};

const PATH_NORMS: [(&str, PathNorm); 4] = [
    ("xyz", PathNorm::Xyz),
    ("xyz+deg", PathNorm::XyzDegrees),
    ("g93_min", PathNorm::G93Minutes),
    ("g93_s", PathNorm::G93Seconds),
];
const SMOOTHINGS: [(&str, Smoothing); 4] = [
    ("none", Smoothing::None),
    ("rough", Smoothing::Rough),
    ("medium", Smoothing::Medium),
    ("finish", Smoothing::Finish),
];
const COOLANTS: [&str; 4] = ["flood", "mist", "through", "air"];

/// Lines of text.
pub(super) const TEXTS: &str = r#"{ "type": "array", "items": { "type": "string" } }"#;

/// Codes, on and off.
const CODES: &str = r#"{ "type": "array", "items": { "type": "string" }, "minItems": 2, "maxItems": 2 }"#;

impl Config {
    pub(super) fn read_control<M: Machine>(&mut self, r: &mut Reader<'_>, section: &mut Section<'_>) {
        if let Some(value) = self.get(section, "control.program_number") {
            self.control.program_number = r.whole(value, 1..=99_999);
        }
        if let Some(value) = self.get(section, "control.program_name") {
            self.control.program_name = r.line(value);
        }
        if let Some(value) = self.get(section, "control.file_header") {
            set(&mut self.control.file_header, r.boolean(value));
        }
        if let Some(value) = self.get(section, "control.safety") {
            self.control.safety = Some(templates(r, value, OF_PROGRAM));
        }
        if let Some(value) = self.get(section, "control.tool_change") {
            self.control.tool_change = Some(templates(r, value, OF_TOOL));
        }
        if let Some(value) = self.get(section, "control.preselect") {
            self.control.preselect = r.boolean(value);
        }
        if let Some(value) = self.get(section, "control.coolant") {
            self.read_coolant(r, value);
        }
        if let Some(value) = self.get(section, "control.smoothing") {
            set(&mut self.control.smoothing, r.choice(value, &SMOOTHINGS));
        }
        if let Some(value) = self.get(section, "control.smoothing_angle") {
            self.control.smoothing_angle = r.number(value, Quantity::Angle, Bound::Positive);
        }
        if let Some(value) = self.get(section, "control.path_norm") {
            self.control.path_norm = r.choice(value, &PATH_NORMS);
        }
        if let Some(value) = self.get(section, "control.point") {
            self.control.point = r.boolean(value);
        }
        if let Some(value) = self.get(section, "control.tip_control") {
            self.control.tip_control = two_codes(r, value);
        }
        if let Some(value) = self.get(section, "control.swivel_data") {
            self.control.swivel_data = r.line(value);
        }
        if let Some(value) = self.get(section, "control.linear_rapids") {
            self.control.linear_rapids = r.boolean(value);
        }
        if let Some(value) = self.get(section, "control.every_word") {
            set(&mut self.control.every_word, r.boolean(value));
        }
        let axes = self.get(section, "control.axes");
        for (axis, value, _) in read_axes::<M>(r, axes) {
            self.control.axes.extend(r.line(value).map(|name| (axis.letter, name)));
        }
    }

    /// `through = ["M88", "M89"]`.
    fn read_coolant(&mut self, r: &mut Reader<'_>, value: Value<'_>) {
        r.note(value, || Shape::Names(COOLANTS.map(str::to_owned).to_vec()));
        for (key, span, value) in r.entries(value) {
            r.note(value, || Shape::Schema(CODES));
            let Some(kind) = COOLANTS.iter().position(|kind| *kind == key) else {
                let help = match nearest(key, COOLANTS.into_iter()) {
                    Some(near) => format!("did you mean `{near}`?"),
                    None => format!("the kinds are {}", list(COOLANTS.into_iter(), '`')),
                };
                r.fault(span, format!("`{key}` is no kind of coolant"), Some(help));
                continue;
            };
            self.control.coolant[kind] = two_codes(r, value);
        }
    }
}

/// `["M88", "M89"]`.
fn two_codes(r: &mut Reader<'_>, value: Value<'_>) -> Option<[String; 2]> {
    let codes: Vec<String> = r.list(value).unwrap_or_default().into_iter().filter_map(|code| r.line(code)).collect();
    let codes = <[String; 2]>::try_from(codes).ok().filter(|codes| codes.iter().all(|code| !code.trim().is_empty()));
    if codes.is_none() {
        r.fault(value.span(), "two codes are needed here: [on, off]", None);
    }
    codes
}

/// Blocks with named fields.
pub(super) fn templates(r: &mut Reader<'_>, value: Value<'_>, allowed: &[Field]) -> Vec<String> {
    let mut blocks = Vec::new();
    r.note(value, || Shape::Schema(TEXTS));
    for value in r.list(value).unwrap_or_default() {
        let Some(block) = r.line(value) else { continue };
        if let Err(bad) = template::check(&block, allowed) {
            let names = allowed.iter().map(|field| field.name());
            let help = match &bad {
                BadTemplate::Brace => "fields stand in braces: {name}".to_owned(),
                BadTemplate::Field(name) => match nearest(name, names.clone()) {
                    Some(near) => format!("did you mean `{{{near}}}`?"),
                    None => format!("the fields here are {}", list(names, '`')),
                },
            };
            r.fault(value.span(), bad.to_string(), Some(help));
        }
        blocks.push(block);
    }
    blocks
}

/// A work offset that one of the controls has; which one has it is seen when it is chosen.
pub(super) fn work_offset(r: &mut Reader<'_>, value: Value<'_>) -> Option<String> {
    r.note(value, || Shape::Text);
    if let Some(text) = value.get_ref().as_str()
        && crate::control::CONTROLS.iter().any(|control| control.work_offset(text).is_some())
    {
        return Some(text.to_owned());
    }
    r.choice(value, &WORK_OFFSETS.map(|word| (word, word))).map(str::to_owned)
}
