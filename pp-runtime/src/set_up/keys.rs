//! Kinds of keys of the set-up: tables by axis, tool or frame, and values that only the set-up has.

use std::collections::BTreeMap;
use std::ops::RangeInclusive;

use serde_json::{Map, Value as Json, json};

use crate::keys::{
    AxisEntry, AxisSet, Bound, KeyKind, KeyList, KeyReader, KeyScope, KeyTable, Keys, LengthPoint, PerAxis, Printed,
    QuantityKind, TomlValue, along, example_entries, letters, list, nearest, printed_along, printed_degrees,
    printed_number, solved,
};
use crate::kinematics::{AxisKind, Dimension, DimensionKind, Limits};

use crate::program::{Coolant, Coolants};

use super::{FurtherSetUp, GivenTool, LARGEST_TOOL, MOST_FRAMES, Stock};

/// Work offsets that the help lists.
const WORK_OFFSETS: [&str; 9] = ["G54", "G55", "G56", "G57", "G58", "G59", "G59.1", "G59.2", "G59.3"];

/// Largest rotary offset, one revolution.
const LARGEST_OFFSET_RAD: f64 = std::f64::consts::TAU * (1.0 + 1e-12);

/// Kind of key: a work offset that at least one control has. Whether the control of the job has it is checked later.
#[derive(Debug, Clone, Copy)]
pub(crate) struct OffsetWord;

impl KeyKind for OffsetWord {
    type Value = String;

    fn read(&self, r: &mut KeyReader<'_>, value: TomlValue<'_>) -> Option<String> {
        if let Some(text) = value.get_ref().as_str()
            && (r.scope().is_work_offset)(text)
        {
            return Some(text.to_owned());
        }
        r.choice(value, &WORK_OFFSETS.map(|word| (word, word))).map(str::to_owned)
    }

    fn print(&self, value: &String) -> String {
        format!("\"{value}\"")
    }

    fn schema(&self, _scope: &KeyScope) -> Json {
        json!({ "type": "string" })
    }
}

/// Kind of key: kinds of coolant that are on together, one name or a list of names.
#[derive(Debug, Clone, Copy)]
pub(crate) struct CoolantKinds;

impl CoolantKinds {
    fn names() -> [(&'static str, Coolant); 7] {
        std::array::from_fn(|index| (Coolant::NAMES[index], Coolant::KINDS[index]))
    }
}

impl KeyKind for CoolantKinds {
    type Value = Coolants;

    fn read(&self, r: &mut KeyReader<'_>, value: TomlValue<'_>) -> Option<Coolants> {
        let names = Self::names();
        if value.get_ref().as_array().is_none() {
            return r.choice(value, &names).map(Coolants::of);
        }
        let values = r.list(value)?;
        let kinds: Vec<Coolant> = values.iter().filter_map(|value| r.choice(value, &names)).collect();
        let together: Coolants = kinds.iter().copied().collect();
        let through = |kind: &&Coolant| matches!(kind, Coolant::Through | Coolant::ThroughAt(_));
        if kinds.len() != together.kinds().count() || values.is_empty() {
            r.fault(value.span(), "expected one or more kinds of coolant, each once", None);
        } else if kinds.iter().filter(through).count() > 1 {
            r.fault(value.span(), "coolant through the spindle has one pressure at a time", None);
        }
        Some(together)
    }

    fn print(&self, value: &Coolants) -> String {
        let names: Vec<String> =
            value.kinds().filter_map(|kind| Some(format!("\"{}\"", Coolant::NAMES[kind.index()?]))).collect();
        if names.len() == 1 { names.concat() } else { format!("[{}]", names.join(", ")) }
    }

    fn schema(&self, _scope: &KeyScope) -> Json {
        let kind = json!({ "enum": Coolant::NAMES });
        json!({ "anyOf": [kind, { "type": "array", "items": kind, "minItems": 1, "uniqueItems": true }] })
    }
}

/// Kind of key: set-ups after the first, by number.
#[derive(Debug, Clone, Copy)]
pub(crate) struct SetUpTable;

impl KeyKind for SetUpTable {
    type Value = BTreeMap<u32, FurtherSetUp>;

    fn read(&self, r: &mut KeyReader<'_>, value: TomlValue<'_>) -> Option<BTreeMap<u32, FurtherSetUp>> {
        let mut set_ups = BTreeMap::new();
        let entries = r.entries(value);
        let alone = entries.len() == 1;
        for (key, span, value) in entries {
            let Some(number) = number(key, 2..=MOST_FRAMES) else {
                let help =
                    "set-ups are tables with a number from 2: [set_ups.2]; the first has the keys without a table";
                r.unknown_key(span, format!("`{key}` is not the number of a further set-up"), Some(help.to_owned()));
                continue;
            };
            let mut table = KeyTable::of(r, format!("set_ups.{number}"), Some(value));
            let mut set_up = FurtherSetUp::default();
            set_up.read(&mut table, r);
            table.close(r);
            if set_up.work_offset.is_none() {
                let help = "give `work_offset = \"G55\"`: the operator sets it for this clamping".to_owned();
                r.missing_key(span.clone(), format!("set-up {number} has no work offset"), Some(help));
            }
            match (set_up.frames.is_empty(), set_up.begins.is_some()) {
                (true, false) if alone && number == 2 => set_up.frames.push(2),
                (true, false) => {
                    let help =
                        "give `frames = [3]`, or the name of its first operation, `begins = \"OP20\"`".to_owned();
                    r.missing_key(span, format!("where set-up {number} begins is not known"), Some(help));
                }
                (false, true) => {
                    r.conflict(
                        span,
                        format!("set-up {number} has both `frames` and `begins`"),
                        Some("give one".to_owned()),
                    );
                }
                (true, true) | (false, false) => {}
            }
            set_ups.insert(number, set_up);
        }
        Some(set_ups)
    }

    fn print(&self, _value: &BTreeMap<u32, FurtherSetUp>) -> String {
        "{}".to_owned()
    }

    fn schema(&self, scope: &KeyScope) -> Json {
        numbered(&Json::Object(KeyList::of(&FurtherSetUp::default(), *scope).schema()))
    }

    fn printed(&self, scope: &KeyScope) -> Option<Printed> {
        let example = example_entries(KeyList::of(&FurtherSetUp::default(), *scope).rows());
        Some(Printed::Section(vec![("2".to_owned(), Printed::Example(example))]))
    }

    fn counts(&self) -> bool {
        false
    }
}

/// Kind of key: tools by tool number.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ToolsByNumber;

impl KeyKind for ToolsByNumber {
    type Value = BTreeMap<u32, GivenTool>;

    fn read(&self, r: &mut KeyReader<'_>, value: TomlValue<'_>) -> Option<BTreeMap<u32, GivenTool>> {
        let mut tools = BTreeMap::new();
        for (key, span, value) in r.entries(value) {
            // With leading zeros two tables could describe one tool.
            let Some(number) = number(key, 1..=LARGEST_TOOL) else {
                let help = format!("tools are tables with a number from 1 to {LARGEST_TOOL}: [tools.12]");
                r.unknown_key(span, format!("`{key}` is not the number of a tool"), Some(help));
                continue;
            };
            let mut table = KeyTable::of(r, format!("tools.{number}"), Some(value));
            let mut tool = GivenTool::default();
            tool.read(&mut table, r);
            table.close(r);
            tools.insert(number, tool);
        }
        Some(tools)
    }

    fn print(&self, _value: &BTreeMap<u32, GivenTool>) -> String {
        "{}".to_owned()
    }

    fn schema(&self, scope: &KeyScope) -> Json {
        numbered(&Json::Object(KeyList::of(&GivenTool::default(), *scope).schema()))
    }

    fn printed(&self, scope: &KeyScope) -> Option<Printed> {
        let example = example_entries(KeyList::of(&GivenTool::default(), *scope).rows());
        Some(Printed::Section(vec![("12".to_owned(), Printed::Example(example))]))
    }

    fn counts(&self) -> bool {
        false
    }
}

/// Kind of key: the blank, by the two corners of a box, or by diameter, bottom and top of a cylinder.
#[derive(Debug, Clone, Copy)]
pub(crate) struct BlankCorners;

impl BlankCorners {
    /// A cylinder. `corners`: there are corners as well.
    fn cylinder(
        r: &mut KeyReader<'_>,
        value: &TomlValue<'_>,
        round: [Option<TomlValue<'_>>; 3],
        corners: bool,
    ) -> Option<Stock> {
        let [Some(diameter), Some(bottom), Some(top)] = round else {
            let help = "diameter = 80, bottom = -40 and top = 0".to_owned();
            r.missing_key(value.span(), "a round blank needs its diameter, its bottom and its top", Some(help));
            return None;
        };
        if corners {
            r.fault(
                value.span(),
                "a blank is a box (`lower`, `upper`) or a cylinder (`diameter`, `bottom`, `top`), not both",
                None,
            );
        }
        let diameter = r.length(diameter, Bound::Positive);
        let [bottom, top] = [bottom, top].map(|level| r.length(level, Bound::Any));
        let (radius, bottom, top) = (0.5 * diameter?, bottom?, top?);
        if bottom >= top {
            r.fault(value.span(), "this blank is empty: `bottom` must be below `top`", None);
            return None;
        }
        Some(Stock { lower: [-radius, -radius, bottom], upper: [radius, radius, top], round: true })
    }
}

impl KeyKind for BlankCorners {
    type Value = Stock;

    fn read(&self, r: &mut KeyReader<'_>, value: TomlValue<'_>) -> Option<Stock> {
        let mut table = KeyTable::of(r, "stock", Some(value));
        let [lower, upper] = ["lower", "upper"].map(|key| table.get(key, r));
        let round = ["diameter", "bottom", "top"].map(|key| table.get(key, r));
        table.close(r);
        if round.iter().any(Option::is_some) {
            let both = lower.is_some() || upper.is_some();
            return Self::cylinder(r, &value, round, both);
        }
        let corners = [lower, upper].map(|corner| corner.and_then(|corner| LengthPoint.read(r, corner)));
        let [Some(lower), Some(upper)] = corners else {
            if lower.is_some() != upper.is_some() {
                let help = "lower = [-50, -40, -30] and upper = [50, 40, 0]".to_owned();
                r.missing_key(value.span(), "both corners of the blank are needed", Some(help));
            }
            return None;
        };
        if (0..3).any(|index| lower[index] >= upper[index]) {
            r.fault(value.span(), "this blank is empty: each value of `lower` must be below that of `upper`", None);
            return None;
        }
        Some(Stock { lower, upper, round: false })
    }

    fn print(&self, _value: &Stock) -> String {
        "{}".to_owned()
    }

    fn schema(&self, scope: &KeyScope) -> Json {
        let corner = LengthPoint.schema(scope);
        json!({
            "type": "object",
            "properties": {
                "lower": corner.clone(),
                "upper": corner,
                "diameter": { "type": "number", "exclusiveMinimum": 0 },
                "bottom": { "type": "number" },
                "top": { "type": "number" },
            },
            "additionalProperties": false
        })
    }

    fn printed(&self, _scope: &KeyScope) -> Option<Printed> {
        let corners = [("lower", "[-50.0, -40.0, -30.0]"), ("upper", "[50.0, 40.0, 0.0]")];
        let corners = corners.map(|(key, corner)| (key.to_owned(), Printed::Example(corner.to_owned())));
        Some(Printed::Section(corners.to_vec()))
    }

    fn counts(&self) -> bool {
        false
    }
}

/// Kind of key: dimensions of the machine, by name.
#[derive(Debug, Clone, Copy)]
pub(crate) struct DimensionTable;

impl KeyKind for DimensionTable {
    type Value = BTreeMap<String, f64>;

    fn read(&self, r: &mut KeyReader<'_>, value: TomlValue<'_>) -> Option<BTreeMap<String, f64>> {
        let KeyScope { machine, dimensions, .. } = r.scope();
        let mut read = BTreeMap::new();
        for (key, span, value) in r.entries(value) {
            let Some(dimension) = dimensions.iter().find(|dimension| dimension.name == key) else {
                let names = dimensions.iter().map(|dimension| dimension.name);
                let help = match nearest(key, names.clone()) {
                    Some(near) => format!("did you mean `{near}`?"),
                    None if dimensions.is_empty() => format!("{machine} has no dimensions"),
                    None => format!("its dimensions are {}", list(names, '`')),
                };
                r.unknown_key(span, format!("`{key}` is not a dimension of {machine}"), Some(help));
                continue;
            };
            let number = match dimension.kind {
                DimensionKind::Length => r.length(value, Bound::Any),
                DimensionKind::Angle => r.number(value, QuantityKind::Angle, Bound::Any),
            };
            read.extend(number.map(|number| (key.to_owned(), number)));
        }
        Some(read)
    }

    fn print(&self, _value: &BTreeMap<String, f64>) -> String {
        "{}".to_owned()
    }

    fn schema(&self, scope: &KeyScope) -> Json {
        let number = |dimension: &Dimension| (dimension.name.to_owned(), json!({ "type": "number" }));
        let properties: Map<String, Json> = scope.dimensions.iter().map(number).collect();
        json!({ "type": "object", "properties": properties, "additionalProperties": false })
    }

    fn printed(&self, scope: &KeyScope) -> Option<Printed> {
        let printed = |dimension: &Dimension| {
            if dimension.default.is_nan() {
                let example = if dimension.kind == DimensionKind::Angle { "30.0" } else { "150.0" };
                return (dimension.name.to_owned(), Printed::Example(example.to_owned()));
            }
            let value = match dimension.kind {
                DimensionKind::Length => printed_number(dimension.default),
                DimensionKind::Angle => printed_degrees(dimension.default),
            };
            (dimension.name.to_owned(), Printed::Default(value))
        };
        Some(Printed::Section(scope.dimensions.iter().map(printed).collect()))
    }

    fn counts(&self) -> bool {
        false
    }
}

/// Rotary offsets: the axis value at which the word of a rotary axis is zero.
pub(crate) const ROTARY_OFFSET: PerAxis<f64> = PerAxis {
    axes: AxisSet::Solved,
    section: false,
    read: |r, entry| {
        let offset = r.number(entry.value, QuantityKind::Angle, Bound::Any)?;
        if offset.abs() > LARGEST_OFFSET_RAD {
            r.fault(entry.value.span(), "an offset of at most 360 degrees is needed here", None);
        }
        Some(offset)
    },
    printed: |_, axis| solved(axis).then(|| Printed::Example("0.0".to_owned())),
    schema: any_number,
};

/// Machine coordinates of the linear axes at the zero position.
pub(crate) const MACHINE_ZERO: PerAxis<f64> = PerAxis {
    axes: AxisSet::All,
    section: false,
    read: |r, entry| linear_coordinate(r, entry, "machine_zero"),
    printed: |_, axis| (axis.kind == AxisKind::Linear).then(|| Printed::Example("0.0".to_owned())),
    schema: any_number,
};

/// Machine coordinates of the linear axes with the gauge line on the reference point of the table.
pub(crate) const TABLE_ZERO: PerAxis<f64> =
    PerAxis { read: |r, entry| linear_coordinate(r, entry, "table_zero"), ..MACHINE_ZERO };

/// Reads the machine coordinate of a linear axis.
fn linear_coordinate(r: &mut KeyReader<'_>, entry: &AxisEntry<'_>, key: &str) -> Option<f64> {
    if entry.axis.kind == AxisKind::Rotary {
        let linear = letters(r.scope().axes, |axis| axis.kind == AxisKind::Linear);
        let text = format!("{} is a rotary axis; `{key}` is for linear axes", entry.axis.letter);
        let help = format!("linear axes are {linear}; for a rotary axis use `rotary_offset`");
        r.fault(entry.span.clone(), text, Some(help));
        return None;
    }
    r.length(entry.value, Bound::Any)
}

/// Position of the axes at the start of a program.
pub(crate) const START_POSITION: PerAxis<f64> = PerAxis {
    axes: AxisSet::All,
    section: false,
    read: |r, entry| along(r, entry.axis, entry.value, Bound::Any),
    printed: |_, axis| (!axis.held).then(|| Printed::Example("0.0".to_owned())),
    schema: any_number,
};

/// Travel of the axes: `[lowest, highest]`, or `"free"`.
pub(crate) const LIMITS: PerAxis<Option<Limits>> = PerAxis {
    axes: AxisSet::All,
    section: true,
    read: |r, entry| {
        let limits = read_limits(r, entry)?;
        r.state_travel(entry.axis.letter, limits);
        Some(limits)
    },
    printed: |_, axis| {
        let shown = |limits: Limits| {
            let [lower, upper] = [limits.lower, limits.upper].map(|value| printed_along(axis, value));
            format!("[{lower}, {upper}]")
        };
        Some(Printed::Default(axis.limits.map_or_else(|| "\"free\"".to_owned(), shown)))
    },
    schema: || {
        let range = json!({ "type": "array", "items": { "type": "number" }, "minItems": 2, "maxItems": 2 });
        json!({ "anyOf": [{ "const": "free" }, range] })
    },
};

/// Largest speeds of the axes.
pub(crate) const SPEEDS: PerAxis<f64> = PerAxis {
    axes: AxisSet::All,
    section: true,
    read: |r, entry| along(r, entry.axis, entry.value, Bound::Positive),
    printed: |_, axis| {
        Some(match (axis.speed, axis.kind) {
            (Some(speed), _) => Printed::Default(printed_along(axis, speed)),
            (None, AxisKind::Linear) => Printed::Example("20000.0".to_owned()),
            (None, AxisKind::Rotary) => Printed::Example("3600.0".to_owned()),
        })
    },
    schema: || json!({ "type": "number", "exclusiveMinimum": 0 }),
};

fn any_number() -> Json {
    json!({ "type": "number" })
}

/// JSON schema of a table whose keys are numbers.
fn numbered(value: &Json) -> Json {
    json!({ "type": "object", "patternProperties": { "^[1-9][0-9]*$": value }, "additionalProperties": false })
}

/// Reads a key that is a number within a range, without leading zeros.
fn number(key: &str, range: RangeInclusive<u32>) -> Option<u32> {
    key.parse().ok().filter(|number: &u32| range.contains(number) && number.to_string() == key)
}

fn read_limits(r: &mut KeyReader<'_>, entry: &AxisEntry<'_>) -> Option<Option<Limits>> {
    let &AxisEntry { axis, value, .. } = entry;
    if value.get_ref().is_str() {
        return r.choice(value, &[("free", None)]);
    }
    let numbers = r.list(value)?;
    let &[lower, upper] = numbers.as_slice() else {
        r.fault(value.span(), "the travel of an axis is [lowest, highest] or \"free\"", None);
        return None;
    };
    let [lower, upper] = [lower, upper].map(|number| along(r, axis, number, Bound::Any));
    let (lower, upper) = (lower?, upper?);
    if lower > upper {
        let help = "the lowest value comes first".to_owned();
        r.fault(value.span(), format!("this travel of {} is empty", axis.letter), Some(help));
        return None;
    }
    Some(Some(Limits { lower, upper }))
}
