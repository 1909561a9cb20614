//! Kind of key: a table whose keys are axes of the machine.

use std::collections::BTreeMap;
use std::ops::Range;

use serde_json::{Map, Value as Json, json};

use crate::kinematics::{Axis, AxisKind};

use super::list::{Printed, printed_degrees, printed_number};
use super::reader::{Bound, KeyReader, QuantityKind, TomlValue};
use super::{KeyKind, KeyScope};

/// Axes that a table may name.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum AxisSet {
    /// Every axis of the machine.
    All,
    /// Linear axes that the inverse kinematics solves for.
    Linear,
    /// Rotary axes that the inverse kinematics solves for.
    Solved,
}

impl AxisSet {
    fn has(self, axis: &Axis) -> bool {
        match self {
            Self::All => true,
            Self::Linear => axis.kind == AxisKind::Linear && !axis.held,
            Self::Solved => solved(axis),
        }
    }
}

/// One entry of a table whose keys are axes.
#[derive(Debug, Clone)]
pub(crate) struct AxisEntry<'a> {
    /// The axis.
    pub(crate) axis: &'static Axis,
    /// Place of the letter in the file.
    pub(crate) span: Range<usize>,
    /// Value of the entry.
    pub(crate) value: TomlValue<'a>,
}

/// Kind of key: a table with one value for each axis named.
#[derive(Debug, Clone, Copy)]
pub(crate) struct PerAxis<V> {
    /// Axes that the table may name.
    pub(crate) axes: AxisSet,
    /// The table is printed as a section, not inline.
    pub(crate) section: bool,
    /// Reads one value.
    pub(crate) read: fn(&mut KeyReader<'_>, &AxisEntry<'_>) -> Option<V>,
    /// Entry of an axis in the sample; `None` leaves the axis out.
    pub(crate) printed: fn(&KeyScope, &Axis) -> Option<Printed>,
    /// The JSON schema of one value.
    pub(crate) schema: fn() -> Json,
}

impl<V> KeyKind for PerAxis<V> {
    type Value = BTreeMap<char, V>;

    fn read(&self, r: &mut KeyReader<'_>, value: TomlValue<'_>) -> Option<BTreeMap<char, V>> {
        let mut read = BTreeMap::new();
        for entry in entries(r, self.axes, value) {
            read.extend((self.read)(r, &entry).map(|value| (entry.axis.letter, value)));
        }
        Some(read)
    }

    fn print(&self, _value: &BTreeMap<char, V>) -> String {
        "{}".to_owned()
    }

    fn schema(&self, scope: &KeyScope) -> Json {
        let mut properties = Map::new();
        for axis in scope.axes.iter().filter(|axis| self.axes.has(axis)) {
            properties.insert(axis.letter.to_string(), (self.schema)());
        }
        json!({ "type": "object", "properties": properties, "additionalProperties": false })
    }

    fn printed(&self, scope: &KeyScope) -> Option<Printed> {
        let printed = |axis: &Axis| Some((axis.letter.to_string(), (self.printed)(scope, axis)?));
        let mut entries: Vec<(String, Printed)> = scope.axes.iter().filter_map(printed).collect();
        if self.section {
            return Some(Printed::Section(entries));
        }
        if entries.is_empty() {
            let zero = |axis: &Axis| (axis.letter.to_string(), Printed::Example("0.0".to_owned()));
            entries = scope.axes.iter().map(zero).collect();
        }
        let inline = entries.into_iter().filter_map(|(letter, printed)| match printed {
            Printed::Default(text) | Printed::Example(text) => Some(format!("{letter} = {text}")),
            Printed::Section(_) => None,
        });
        Some(Printed::Example(format!("{{ {} }}", inline.collect::<Vec<_>>().join(", "))))
    }

    fn counts(&self) -> bool {
        false
    }
}

/// Entries of a table whose keys are axes; any other key is a fault.
fn entries<'a>(r: &mut KeyReader<'_>, set: AxisSet, value: TomlValue<'a>) -> Vec<AxisEntry<'a>> {
    let KeyScope { machine, axes, .. } = r.scope();
    let mut read = Vec::new();
    for (key, span, value) in r.entries(value) {
        match axes.iter().find(|axis| axis.letter.to_string() == key) {
            Some(axis) if !set.has(axis) => {
                let what = if set == AxisSet::Linear { "linear" } else { "rotary" };
                let help = format!("solved {what} axes are {}", letters(axes, |axis| set.has(axis)));
                r.fault(value.span(), format!("{} is not a solved {what} axis", axis.letter), Some(help));
            }
            Some(axis) => read.push(AxisEntry { axis, span, value }),
            None => {
                let help = format!("its axes are {}", letters(axes, |_| true));
                r.unknown_key(span, format!("`{key}` is not an axis of {machine}"), Some(help));
            }
        }
    }
    read
}

/// Whether an axis is a rotary axis whose angle follows from the tool axis.
pub(crate) fn solved(axis: &Axis) -> bool {
    axis.kind == AxisKind::Rotary && !axis.held
}

/// Letters of the wanted axes, separated by blanks: `X Y Z`.
pub(crate) fn letters(axes: &[Axis], wanted: impl Fn(&Axis) -> bool) -> String {
    let letters: Vec<String> = axes.iter().filter(|axis| wanted(axis)).map(|axis| axis.letter.to_string()).collect();
    letters.join(" ")
}

/// Reads a position or speed of an axis: mm, rad, or these per minute.
pub(crate) fn along(r: &mut KeyReader<'_>, axis: &Axis, value: TomlValue<'_>, bound: Bound) -> Option<f64> {
    match axis.kind {
        AxisKind::Linear => r.number(value, QuantityKind::Length, bound),
        AxisKind::Rotary => r.number(value, QuantityKind::Angle, bound),
    }
}

/// Position or speed of an axis as TOML.
pub(crate) fn printed_along(axis: &Axis, value: f64) -> String {
    match axis.kind {
        AxisKind::Linear => printed_number(value),
        AxisKind::Rotary => printed_degrees(value),
    }
}
