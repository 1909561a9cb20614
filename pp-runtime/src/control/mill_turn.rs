//! A turning machine that mills: how words of X become radii, the modes in which C is an axis and the tool is driven,
//! and the spindle of the tool (`control.mill_turn`).
//!
//! Public post for a Mazak INTEGREX i-200S (Autodesk's, revised): `G122.1` words of X are radii, `M302` the main
//! spindle holds the part, `M200` C is an axis, `M252` the milling spindle is free, `M203`, `M204` and `M205` drive the
//! tool. Autodesk's post for turning centres of Siemens: `S3=2000 M3=3`, the number of the spindle before the sign.

use serde_json::{Value as Json, json};

use crate::keys::{KeyKind, KeyReader, KeyScope, OneLine, Printed, TomlValue};
use crate::program::Rotation;

/// Settings of a turning machine.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct MillTurn {
    /// Block after which words of X are radii; without it they are by a setting of the machine.
    pub radius: Option<String>,
    /// Blocks after it: C is an axis, and the tool is driven.
    pub modes: Vec<String>,
    /// Spindle of the tool.
    pub spindle: ToolSpindle,
}

/// Spindle of the tool.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum ToolSpindle {
    /// That of M3, M4 and M5.
    Master,
    /// One with this number: `S3=2000`, `M3=3`.
    Number(u32),
    /// One with codes of its own: clockwise, counter-clockwise, off.
    Codes([String; 3]),
}

impl MillTurn {
    /// Blocks of a restart point.
    pub(crate) fn blocks(&self) -> impl Iterator<Item = &String> {
        self.radius.iter().chain(&self.modes)
    }
}

impl ToolSpindle {
    /// Block that sets its speed, with the field {speed}; `None` for the block of the control.
    pub(crate) fn speed_block(&self) -> Option<String> {
        match self {
            Self::Master => None,
            Self::Number(number) => Some(format!("S{number}={{speed}}")),
            Self::Codes(_) => Some("S{speed}".to_owned()),
        }
    }

    /// Blocks that switch it: clockwise, counter-clockwise, off.
    pub(crate) fn switches(&self) -> Option<[String; 3]> {
        match self {
            Self::Master => None,
            Self::Number(number) => Some([3, 4, 5].map(|code| format!("M{number}={code}"))),
            Self::Codes(codes) => Some(codes.clone()),
        }
    }

    /// The switches with the sense of rotation of each.
    pub(crate) fn rotations(&self) -> impl Iterator<Item = (String, Option<Rotation>)> {
        let senses = [Some(Rotation::Clockwise), Some(Rotation::CounterClockwise), None];
        self.switches().into_iter().flatten().zip(senses)
    }
}

/// Value of a key: `{ radius = "G122.1", modes = ["M200"], spindle = ["M203", "M204", "M205"] }`.
#[derive(Debug, Clone, Copy)]
pub(super) struct MillTurnKey;

const ENTRIES: [&str; 3] = ["radius", "modes", "spindle"];

const FORM: &str = "{ radius = \"G122.1\" or \"parameter\", modes = [\"M200\"] or [], spindle = [\"M203\", \"M204\", \"M205\"], its \
                    number, or \"master\" }";

impl KeyKind for MillTurnKey {
    type Value = MillTurn;

    fn read(&self, r: &mut KeyReader<'_>, value: TomlValue<'_>) -> Option<MillTurn> {
        let span = value.span();
        let (mut radius, mut modes, mut spindle) = (None, None, None);
        for (key, span, value) in r.entries(value) {
            match key {
                "radius" => radius = r.line(value),
                "modes" => modes = Some(lines(r, value)),
                "spindle" => spindle = tool_spindle(r, value),
                _ => {
                    let help = format!("its entries: {}", ENTRIES.join(", "));
                    r.unknown_key(span, format!("unknown entry `{key}`"), Some(help));
                }
            }
        }
        let (Some(radius), Some(modes), Some(spindle)) = (radius, modes, spindle) else {
            r.missing_key(
                span,
                "how words of X become radii, the modes and the spindle of the tool are all needed",
                Some(FORM.to_owned()),
            );
            return None;
        };
        let radius = Some(radius).filter(|radius| radius.trim() != "parameter");
        Some(MillTurn { radius, modes, spindle })
    }

    fn print(&self, value: &MillTurn) -> String {
        let quoted = |text: &String| OneLine.print(text);
        let list = |texts: &[String]| format!("[{}]", texts.iter().map(quoted).collect::<Vec<_>>().join(", "));
        let spindle = match &value.spindle {
            ToolSpindle::Master => "\"master\"".to_owned(),
            ToolSpindle::Number(number) => number.to_string(),
            ToolSpindle::Codes(codes) => list(codes),
        };
        let radius = value.radius.as_ref().map_or_else(|| "\"parameter\"".to_owned(), quoted);
        format!("{{ radius = {radius}, modes = {}, spindle = {spindle} }}", list(&value.modes))
    }

    fn schema(&self, _scope: &KeyScope) -> Json {
        let lines = json!({ "type": "array", "items": { "type": "string" } });
        let spindle = json!({ "anyOf": [{ "const": "master" }, { "type": "integer", "minimum": 1 }, lines] });
        json!({
            "type": "object",
            "properties": { "radius": { "type": "string" }, "modes": lines, "spindle": spindle },
            "required": ENTRIES,
            "additionalProperties": false
        })
    }

    fn printed(&self, _scope: &KeyScope) -> Option<Printed> {
        let example = MillTurn {
            radius: Some("G122.1".to_owned()),
            modes: vec!["M200".to_owned()],
            spindle: ToolSpindle::Codes(["M203", "M204", "M205"].map(str::to_owned)),
        };
        Some(Printed::Example(self.print(&example)))
    }
}

/// Blocks of a list.
fn lines(r: &mut KeyReader<'_>, value: TomlValue<'_>) -> Vec<String> {
    let lines = r.list(value).unwrap_or_default();
    lines.into_iter().filter_map(|line| r.line(line)).collect()
}

fn tool_spindle(r: &mut KeyReader<'_>, value: TomlValue<'_>) -> Option<ToolSpindle> {
    let text = value.get_ref();
    let spindle = match text.as_str() {
        Some("master") => Some(ToolSpindle::Master),
        Some(_) => None,
        None if text.as_array().is_some() => <[String; 3]>::try_from(lines(r, value))
            .ok()
            .filter(|codes| codes.iter().all(|code| !code.trim().is_empty()))
            .map(ToolSpindle::Codes),
        None => return r.whole(value, 1..=99).map(ToolSpindle::Number),
    };
    if spindle.is_none() {
        r.fault(value.span(), "expected three codes, the number of the spindle, or \"master\"", Some(FORM.to_owned()));
    }
    spindle
}
