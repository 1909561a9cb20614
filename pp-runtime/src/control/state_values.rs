//! Settings and parameters of controls that no word of a program states, and on which the meaning of words depends.
//!
//! One row is one key of `[control.states]`, by the name that the control itself gives it.

use std::collections::BTreeMap;

use serde_json::{Map, Value as Json, json};

use crate::keys::{Bound, KeyKind, KeyReader, KeyScope, Measure, Printed, TomlValue, list, nearest};
use crate::program::Drilling;

/// A setting or parameter of a control; a length.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ControlState {
    /// Name of the control on the command line.
    control: &'static str,
    /// Name of the state on the control.
    pub(crate) key: &'static str,
    /// What it is.
    what: &'static str,
    /// Value that a program needs where the configuration gives none.
    pub(crate) needed: &'static str,
    of: StepCycles,
    /// It is the distance between the rapid back into a hole, or the short retract, and the last depth.
    is_gap: bool,
    /// Manual and page.
    source: &'static str,
}

/// Cycles in steps that read a state.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) struct StepCycles {
    /// Out of the hole after each step.
    pub(crate) peck: bool,
    /// Back by a little after each step.
    pub(crate) chip_break: bool,
}

impl StepCycles {
    const PECK: Self = Self { peck: true, chip_break: false };
    const CHIP_BREAK: Self = Self { peck: false, chip_break: true };
    const BOTH: Self = Self { peck: true, chip_break: true };

    /// The cycle of a hole is used.
    pub(crate) fn add(&mut self, drilling: &Drilling) {
        self.peck |= matches!(drilling, Drilling::Peck { .. });
        self.chip_break |= matches!(drilling, Drilling::ChipBreak { .. });
    }

    const fn has_any_of(self, other: Self) -> bool {
        self.peck && other.peck || self.chip_break && other.chip_break
    }
}

const STATES: &[ControlState] = &[
    ControlState {
        control: "haas",
        key: "setting 22",
        what: "retract of G73 after each step, and distance above the last depth to which G83 returns at rapid",
        needed: "shorter than each step",
        of: StepCycles::BOTH,
        is_gap: true,
        source: "Haas mill operator's manual (NGC, 2017), setting 22",
    },
    ControlState {
        control: "haas",
        key: "setting 52",
        what: "distance above R to which G83 retracts after each step",
        needed: "0",
        of: StepCycles::PECK,
        is_gap: false,
        source: "Haas VF series manual 96-8000 (June 1999), p. 192",
    },
    ControlState {
        control: "fanuc",
        key: "5114",
        what: "retract of G73 after each step",
        needed: "shorter than each step",
        of: StepCycles::CHIP_BREAK,
        is_gap: true,
        source: "from memory",
    },
    ControlState {
        control: "fanuc",
        key: "5115",
        what: "distance above the last depth to which G83 returns at rapid",
        needed: "shorter than each step",
        of: StepCycles::PECK,
        is_gap: true,
        source: "from memory",
    },
];

impl ControlState {
    /// States of a control.
    pub(crate) fn of(control: &str) -> impl Iterator<Item = &'static Self> {
        STATES.iter().filter(move |state| state.control == control)
    }

    /// States of a control that cycles of a program read.
    pub(crate) fn used(control: &str, cycles: StepCycles) -> impl Iterator<Item = &'static Self> {
        Self::of(control).filter(move |state| state.of.has_any_of(cycles))
    }

    /// Gaps of the cycles of a control, mm, as far as the configuration gives them: that of G83, and that of G73.
    pub(crate) fn gaps_mm(control: &str, given: &BTreeMap<String, f64>) -> [Option<f64>; 2] {
        [StepCycles::PECK, StepCycles::CHIP_BREAK].map(|cycle| {
            let state = Self::used(control, cycle).find(|state| state.is_gap)?;
            given.get(state.key).copied()
        })
    }

    /// What it is, with its source.
    pub(crate) fn title(&self) -> String {
        let Self { key, what, .. } = self;
        match self.is_from_memory() {
            true => format!("{key} ({what}; from memory)"),
            false => format!("{key} ({what})"),
        }
    }

    /// No public page has it.
    pub(super) fn is_from_memory(&self) -> bool {
        self.source == "from memory"
    }
}

/// Value of a key: states of the control by their names, `{ "setting 22" = 1.0 }`.
#[derive(Debug, Clone, Copy)]
pub(in crate::control) struct States;

/// A length.
const VALUE: Measure = Measure::length(Bound::NotNegative);

impl KeyKind for States {
    type Value = BTreeMap<String, f64>;

    fn read(&self, r: &mut KeyReader<'_>, value: TomlValue<'_>) -> Option<Self::Value> {
        let mut states = BTreeMap::new();
        for (key, span, value) in r.entries(value) {
            let names = || STATES.iter().map(|state| state.key);
            if !names().any(|name| name == key) {
                let help = match nearest(key, names()) {
                    Some(near) => format!("did you mean `{near}`?"),
                    None => format!("states: {}", list(names(), '`')),
                };
                r.unknown_key(span, format!("unknown state of a control `{key}`"), Some(help));
                continue;
            }
            if let Some(value) = VALUE.read(r, value) {
                states.insert(key.to_owned(), value);
            }
        }
        Some(states)
    }

    fn print(&self, _value: &Self::Value) -> String {
        "{}".to_owned()
    }

    fn schema(&self, scope: &KeyScope) -> Json {
        let states: Map<String, Json> = STATES
            .iter()
            .map(|state| {
                let mut schema = VALUE.schema(scope);
                schema["description"] = json!(format!("{}: {}", state.control, state.title()));
                (state.key.to_owned(), schema)
            })
            .collect();
        json!({ "type": "object", "properties": states, "additionalProperties": false })
    }

    fn printed(&self, _scope: &KeyScope) -> Option<Printed> {
        Some(Printed::Example("{ \"setting 22\" = 1.0 }".to_owned()))
    }
}
