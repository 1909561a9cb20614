//! Settings of single operations, by number, name or pattern: the table `[operations]`.
//!
//! Here are the entries as they are in the file; `source/settings` finds those of each operation.

use std::ops::Range;

use serde_json::{Value as Json, json};

use crate::keys::{
    Bound, KeyKind, KeyList, KeyReader, KeyScope, KeyTable, Keys, Measure, OneOf, Printed, TomlValue, example_entries,
    options,
};

use super::{Mode, Singular, beyond_words, nearly_zero};

/// Smoothing of the path by the control.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Smoothing {
    /// No smoothing code in the program.
    #[default]
    None,
    /// Speed first.
    Rough,
    /// Between the two.
    Medium,
    /// Surface first.
    Finish,
}

impl Smoothing {
    /// Names in a file.
    pub(crate) const NAMES: [(&'static str, Self); 4] =
        [("none", Self::None), ("rough", Self::Rough), ("medium", Self::Medium), ("finish", Self::Finish)];

    /// `none`, `rough`, `medium` or `finish`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Rough => "rough",
            Self::Medium => "medium",
            Self::Finish => "finish",
        }
    }

    /// Index of the level in the codes of a control; `None` without smoothing.
    #[must_use]
    pub const fn level(self) -> Option<usize> {
        match self {
            Self::None => None,
            Self::Rough => Some(0),
            Self::Medium => Some(1),
            Self::Finish => Some(2),
        }
    }
}

options! {
    /// Settings of an operation; each without a value is that of the whole program.
    pub struct OperationSettings {
        /// Mode, as `mode`.
        mode: Option<Mode> = None, key("mode", OneOf(&Mode::NAMES), "\"tcp\"");
        /// Smoothing by the control, as `control.smoothing`.
        smoothing: Option<Smoothing> = None, key("smoothing", OneOf(&Smoothing::NAMES), "\"finish\"");
        /// Largest deviation where the control blends or smooths, as `path_tolerance`.
        path_tolerance_mm: Option<f64> = None,
            key("path_tolerance", Measure::length(Bound::Positive).unless(nearly_zero), "0.05");
        /// Angle of a free first rotary axis, as `singular`.
        singular: Option<Singular> = None, key("singular", OneOf(&Singular::NAMES), "\"previous\"");
        /// Largest deviation of chords and of the tip, as `tolerance`.
        tolerance_mm: Option<f64> = None,
            key("tolerance", Measure::length(Bound::Positive).unless(beyond_words), "0.02");
        /// Largest feed of the tool tip in feed motions; rapids at feed keep theirs.
        largest_feed_mm_per_min: Option<f64> = None, key("largest_feed", Measure::length(Bound::Positive), "2000.0");
        /// Material that the operation leaves on the design, for `simulate`: rest up to it is no finding.
        allowance_mm: Option<f64> = None, key("allowance", Measure::length(Bound::NotNegative), "0.3");
    }
}

/// The operations that an entry of the table is for.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum OperationChoice {
    /// The operation of this number, counted from 1.
    Number(u64),
    /// Operations of this name, in any letter case.
    Name(String),
    /// Operations whose names match: `*` is any text, `?` any one character.
    Pattern(String),
}

impl OperationChoice {
    /// The choice that a key of the table makes; the reason if it makes none.
    pub(crate) fn of(key: &str) -> Result<Self, &'static str> {
        let key = key.trim();
        if key.is_empty() {
            return Err("an operation needs a number, a name or a pattern");
        }
        if key.bytes().all(|byte| byte.is_ascii_digit()) {
            // With leading zeros two entries could be for one operation.
            let number = key.parse().ok().filter(|number: &u64| *number > 0 && number.to_string() == key);
            return number.map(Self::Number).ok_or("operations are counted from 1, without leading zeros");
        }
        Ok(if key.contains(['*', '?']) { Self::Pattern(key.to_owned()) } else { Self::Name(key.to_owned()) })
    }

    /// The entry in a message: `[operations.3]`, `[operations."FINISH*"]`.
    #[must_use]
    pub fn shown(&self) -> String {
        match self {
            Self::Number(number) => format!("[operations.{number}]"),
            Self::Name(name) | Self::Pattern(name) => format!("[operations.\"{name}\"]"),
        }
    }
}

/// Entry of the table.
#[derive(Debug, Clone, PartialEq)]
pub struct OperationEntry {
    /// The operations that it is for.
    pub of: OperationChoice,
    /// Their settings.
    pub settings: OperationSettings,
}

/// Settings of single operations, in the order of the file.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct OperationTable {
    /// The entries.
    pub entries: Vec<OperationEntry>,
}

impl OperationTable {
    /// Whether an entry sets a mode.
    #[must_use]
    pub fn sets_mode(&self) -> bool {
        self.entries.iter().any(|entry| entry.settings.mode.is_some())
    }

    /// Whether an entry sets smoothing or its tolerance.
    #[must_use]
    pub fn sets_smoothing(&self) -> bool {
        let sets = |settings: &OperationSettings| settings.smoothing.is_some() || settings.path_tolerance_mm.is_some();
        self.entries.iter().any(|entry| sets(&entry.settings))
    }

    /// Whether an entry switches smoothing on.
    #[must_use]
    pub fn smooths(&self) -> bool {
        let on = |entry: &OperationEntry| entry.settings.smoothing.is_some_and(|level| level != Smoothing::None);
        self.entries.iter().any(on)
    }
}

/// Kind of key: the table of operations.
#[derive(Debug, Clone, Copy)]
pub(crate) struct OperationsTable;

impl OperationsTable {
    /// Reads the choice of an entry, and refuses a second entry for the same operations.
    fn choice(
        r: &mut KeyReader<'_>,
        (key, span): (&str, Range<usize>),
        entries: &[OperationEntry],
    ) -> Option<OperationChoice> {
        let of = match OperationChoice::of(key) {
            Ok(of) => of,
            Err(text) => {
                let help = "[operations.3], [operations.\"FINISH BLADE\"] or [operations.\"FINISH*\"]".to_owned();
                r.fault(span, text, Some(help));
                return None;
            }
        };
        let twice = entries.iter().find(|entry| entry.of.shown().to_lowercase() == of.shown().to_lowercase());
        if let Some(other) = twice {
            r.conflict(
                span,
                format!("{} and {} are for the same operations: letter case is ignored", of.shown(), other.of.shown()),
                Some("leave one of them out".to_owned()),
            );
            return None;
        }
        Some(of)
    }
}

impl KeyKind for OperationsTable {
    type Value = OperationTable;

    fn read(&self, r: &mut KeyReader<'_>, value: TomlValue<'_>) -> Option<OperationTable> {
        let mut entries = Vec::new();
        for (key, span, value) in r.entries(value) {
            let mut table = KeyTable::of(r, format!("operations.{key}"), Some(value));
            let mut settings = OperationSettings::default();
            settings.read(&mut table, r);
            table.close(r);
            entries.extend(Self::choice(r, (key, span), &entries).map(|of| OperationEntry { of, settings }));
        }
        Some(OperationTable { entries })
    }

    fn print(&self, _value: &OperationTable) -> String {
        "{}".to_owned()
    }

    fn schema(&self, scope: &KeyScope) -> Json {
        let settings = Json::Object(KeyList::of(&OperationSettings::default(), *scope).schema());
        json!({ "type": "object", "additionalProperties": settings })
    }

    fn printed(&self, scope: &KeyScope) -> Option<Printed> {
        let example = example_entries(KeyList::of(&OperationSettings::default(), *scope).rows());
        let shown = [("3", "{ mode = \"axes\" }"), ("\"FINISH*\"", &example)];
        let entry = |(key, example): (&str, &str)| (key.to_owned(), Printed::Example(example.to_owned()));
        Some(Printed::Section(shown.map(entry).to_vec()))
    }

    fn counts(&self) -> bool {
        false
    }
}
