//! Reads values of a configuration file; reports each fault with its line and column.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use std::ops::{Range, RangeInclusive};

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::diag::code::config;
use crate::diag::{Code, Diagnostic, Diagnostics, Severity};
use crate::kinematics::{Axis, Limits};
use crate::program::{Location, Units};

use super::KeyScope;

/// A value with its place in the text.
pub(crate) type TomlValue<'a> = &'a Spanned<DeValue<'a>>;

/// Largest plausible length. A larger one is a typing error, or inches are read as millimetres or the reverse.
const LONGEST_MM: f64 = 1e5;

/// Largest length, speed or angle: a word has nine digits before its point, and units of a millionth are counted
/// exactly.
const LARGEST: f64 = 1e9;

/// Smallest number above zero, where zero is not permitted: a thousandth of the last digit of any word.
const SMALLEST: f64 = 1e-9;

/// Range of a number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Bound {
    /// Every finite number.
    Any,
    /// Zero or more.
    NotNegative,
    /// More than zero.
    Positive,
}

/// Quantity that a number measures.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum QuantityKind {
    /// No conversion: rev/min, seconds.
    Plain,
    /// Length in the unit of the file, or speed in that unit per minute.
    Length,
    /// Angle in degrees, or speed in degrees per minute.
    Angle,
}

/// A key of the file that no option has.
#[derive(Debug, Clone)]
pub(crate) struct UnknownKey {
    /// Name of the table that holds the key; empty for the first level of the file.
    pub(crate) table: String,
    /// Name of the key.
    pub(crate) name: String,
    /// Place of the key.
    pub(crate) span: Range<usize>,
    /// Known keys of that table.
    pub(crate) known: Vec<&'static str>,
}

/// Reads values and collects their faults.
pub(crate) struct KeyReader<'t> {
    text: &'t str,
    scope: KeyScope,
    /// Unit of length of the file.
    units: Units,
    /// A length has been read.
    lengths: bool,
    faults: Vec<Diagnostic>,
    /// Paths of the keys in the file.
    given: BTreeSet<&'static str>,
    /// Keys of the file that no option has.
    unknown: Vec<UnknownKey>,
    /// Travel of axes that the file states.
    travel: BTreeMap<char, Option<Limits>>,
    /// Every known key, with its table.
    #[cfg(test)]
    known: Vec<(String, &'static str)>,
}

impl<'t> KeyReader<'t> {
    /// Returns a reader of a file whose lengths are in millimetres until [`set_units`](Self::set_units).
    pub(crate) fn new(text: &'t str, scope: KeyScope) -> Self {
        Self {
            text,
            scope,
            units: Units::Millimetres,
            lengths: false,
            faults: Vec::new(),
            given: BTreeSet::new(),
            unknown: Vec::new(),
            travel: BTreeMap::new(),
            #[cfg(test)]
            known: Vec::new(),
        }
    }

    #[cfg(test)]
    pub(crate) fn note_known(&mut self, table: &str, keys: &[&'static str]) {
        self.known.extend(keys.iter().map(|key| (table.to_owned(), *key)));
    }

    /// Every known key, with its table.
    #[cfg(test)]
    pub(crate) fn known(&self) -> &[(String, &'static str)] {
        &self.known
    }

    /// Context of the keys.
    pub(crate) fn scope(&self) -> KeyScope {
        self.scope
    }

    /// Unit of length of the file.
    pub(crate) fn units(&self) -> Units {
        self.units
    }

    /// Sets the unit of all lengths that are read after this call.
    pub(crate) fn set_units(&mut self, units: Units) {
        self.units = units;
    }

    /// Whether a length has been read.
    pub(crate) fn has_lengths(&self) -> bool {
        self.lengths
    }

    /// Notes that the file has this key.
    pub(crate) fn mark_given(&mut self, path: &'static str) {
        self.given.insert(path);
    }

    /// Whether the file has this key.
    pub(crate) fn is_given(&self, path: &str) -> bool {
        self.given.contains(path)
    }

    /// Keys in the file.
    pub(crate) fn given(&self) -> &BTreeSet<&'static str> {
        &self.given
    }

    /// Notes a key of the file that no option has.
    pub(crate) fn add_unknown(&mut self, key: UnknownKey) {
        self.unknown.push(key);
    }

    /// Reports the unknown keys. `above`: known keys of the first level of the file, to recognise a key below the wrong
    /// header.
    pub(crate) fn report_unknown(&mut self, above: &[&str]) {
        for UnknownKey { table, name, span, known } in std::mem::take(&mut self.unknown) {
            let dot = if table.is_empty() { "" } else { "." };
            let path = format!("{table}{dot}{name}");
            if !table.is_empty() && above.contains(&name.as_str()) {
                let help = format!("`{name}` belongs before the first [section] of the file");
                self.unknown_key(span, format!("unknown key `{path}`"), Some(help));
            } else if let Some(near) = nearest(&name, known.iter().copied()) {
                self.unknown_key(span, format!("unknown key `{path}`; did you mean `{near}`?"), None);
            } else {
                let help = format!("known keys are {}", list(known.iter().copied(), '`'));
                self.unknown_key(span, format!("unknown key `{path}`"), Some(help));
            }
        }
    }

    /// Notes the travel of an axis as stated in the file; keys that are read later are compared with it.
    pub(crate) fn state_travel(&mut self, axis: char, limits: Option<Limits>) {
        self.travel.insert(axis, limits);
    }

    /// Travel of an axis: as stated in the file, else as the machine declares it.
    pub(crate) fn travel_of(&self, axis: &Axis) -> Option<Limits> {
        self.travel.get(&axis.letter).copied().unwrap_or(axis.limits)
    }

    pub(crate) fn has_faults(&self) -> bool {
        !self.faults.is_empty()
    }

    /// All faults in the order of the text.
    pub(crate) fn into_faults(mut self) -> Diagnostics {
        self.faults.sort_by_key(|fault| fault.location);
        Diagnostics(self.faults)
    }

    /// Reports a value that is not permitted.
    pub(crate) fn fault(&mut self, span: Range<usize>, text: impl Into<String>, help: Option<String>) {
        self.report(config::VALUE, span, text, help);
    }

    /// Reports a key that no option has.
    pub(crate) fn unknown_key(&mut self, span: Range<usize>, text: impl Into<String>, help: Option<String>) {
        self.report(config::UNKNOWN_KEY, span, text, help);
    }

    /// Reports a place where a key is missing.
    pub(crate) fn missing_key(&mut self, span: Range<usize>, text: impl Into<String>, help: Option<String>) {
        self.report(config::MISSING, span, text, help);
    }

    /// Reports a key that contradicts another one.
    pub(crate) fn conflict(&mut self, span: Range<usize>, text: impl Into<String>, help: Option<String>) {
        self.report(config::CONFLICT, span, text, help);
    }

    /// Reports a fault with its code.
    pub(crate) fn report(&mut self, code: Code, span: Range<usize>, text: impl Into<String>, help: Option<String>) {
        let bytes = self.text.as_bytes();
        let start = span.start.min(bytes.len());
        let line_start = bytes[..start].iter().rposition(|&byte| byte == b'\n').map_or(0, |at| at + 1);
        let line_end = bytes[start..].iter().position(|&byte| byte == b'\n').map_or(bytes.len(), |at| start + at);
        let line = 1 + bytes[..start].iter().filter(|&&byte| byte == b'\n').count();
        let length = span.end.min(line_end).saturating_sub(start).max(1);
        self.faults.push(Diagnostic {
            code,
            severity: Severity::Error,
            location: Location { line: line as u64, column: clamp_u32(start - line_start + 1) },
            length: clamp_u32(length),
            count: 1,
            text: text.into(),
            help,
        });
    }

    fn wrong_type(&mut self, value: TomlValue<'_>, wanted: &str) {
        let found = match value.get_ref() {
            DeValue::String(_) => "text in quotes",
            DeValue::Integer(_) => "a whole number",
            DeValue::Float(_) => "a number",
            DeValue::Boolean(_) => "true or false",
            DeValue::Datetime(_) => "a date",
            DeValue::Array(_) => "a list",
            DeValue::Table(_) => "a table",
        };
        self.fault(value.span(), format!("{wanted} is needed here, found {found}"), None);
    }

    /// Reads a number of a plausible size and converts it to mm or rad, or leaves it.
    pub(crate) fn number(&mut self, value: TomlValue<'_>, quantity: QuantityKind, bound: Bound) -> Option<f64> {
        let number = self.as_written(value, quantity, bound)?;
        Some(match quantity {
            QuantityKind::Plain => number,
            QuantityKind::Angle => number.to_radians(),
            QuantityKind::Length => {
                self.lengths = true;
                number * self.units.in_mm()
            }
        })
    }

    /// Reads an angle, degrees.
    pub(crate) fn degrees(&mut self, value: TomlValue<'_>) -> Option<f64> {
        self.as_written(value, QuantityKind::Angle, Bound::Any)
    }

    /// Reads a number of a plausible size, in the unit of the file.
    fn as_written(&mut self, value: TomlValue<'_>, quantity: QuantityKind, bound: Bound) -> Option<f64> {
        let read = match value.get_ref() {
            DeValue::Integer(integer) if integer.radix() == 10 => integer.as_str().parse::<f64>().ok(),
            DeValue::Float(float) => float.as_str().parse::<f64>().ok(),
            _ => {
                self.wrong_type(value, "a number");
                return None;
            }
        };
        let Some(number) = read.filter(|number| number.is_finite()) else {
            self.fault(value.span(), "a finite number is needed here", None);
            return None;
        };
        let wrong = match bound {
            Bound::NotNegative if number < 0.0 => "a number that is not negative is needed here".to_owned(),
            Bound::Positive if number <= 0.0 => "a number above zero is needed here".to_owned(),
            Bound::Positive if number < SMALLEST => format!("at least {SMALLEST} is needed here"),
            _ if quantity == QuantityKind::Plain || number.abs() <= LARGEST => return Some(number),
            _ if quantity == QuantityKind::Angle => format!("at most {LARGEST} degrees are needed here"),
            _ => format!("at most {LARGEST} is needed here"),
        };
        self.fault(value.span(), wrong, None);
        None
    }

    /// Reads a plausible length, mm.
    pub(crate) fn length(&mut self, value: TomlValue<'_>, bound: Bound) -> Option<f64> {
        let length = self.number(value, QuantityKind::Length, bound)?;
        if length.abs() > LONGEST_MM {
            let metres = length.abs() / 1000.0;
            let help = format!("the unit of this file is `{}`", self.units.name());
            self.fault(value.span(), format!("a length of {metres} m is not plausible"), Some(help));
            return None;
        }
        Some(length)
    }

    /// Reads a whole number within `range`.
    pub(crate) fn whole(&mut self, value: TomlValue<'_>, range: RangeInclusive<u32>) -> Option<u32> {
        let DeValue::Integer(integer) = value.get_ref() else {
            self.wrong_type(value, "a whole number");
            return None;
        };
        let read = u32::from_str_radix(integer.as_str(), integer.radix()).ok().filter(|number| range.contains(number));
        if read.is_none() {
            let (low, high) = (range.start(), range.end());
            self.fault(value.span(), format!("a whole number from {low} to {high} is needed here"), None);
        }
        read
    }

    pub(crate) fn boolean(&mut self, value: TomlValue<'_>) -> Option<bool> {
        let read = value.get_ref().as_bool();
        if read.is_none() {
            self.wrong_type(value, "true or false");
        }
        read
    }

    /// Reads one line of text without control characters.
    pub(crate) fn line(&mut self, value: TomlValue<'_>) -> Option<String> {
        let Some(text) = value.get_ref().as_str() else {
            self.wrong_type(value, "text in quotes");
            return None;
        };
        if text.chars().any(char::is_control) {
            self.fault(value.span(), "one line of text without control characters is needed here", None);
            return None;
        }
        Some(text.to_owned())
    }

    /// Reads one of a few words.
    pub(crate) fn choice<T: Copy>(&mut self, value: TomlValue<'_>, choices: &[(&'static str, T)]) -> Option<T> {
        let Some(text) = value.get_ref().as_str() else {
            self.wrong_type(value, "text in quotes");
            return None;
        };
        let found = choices.iter().find(|(name, _)| *name == text).map(|&(_, choice)| choice);
        if found.is_none() {
            let names: Vec<&str> = choices.iter().map(|(name, _)| *name).collect();
            self.not_permitted(value, text, &names);
        }
        found
    }

    /// Reports a word that is none of `names`.
    fn not_permitted(&mut self, value: TomlValue<'_>, text: &str, names: &[&str]) {
        let names = names.iter().copied();
        let help = match nearest(text, names.clone()) {
            Some(near) => format!("did you mean \"{near}\"?"),
            None => format!("write one of {}", list(names, '"')),
        };
        self.fault(value.span(), format!("\"{text}\" is not a permitted value"), Some(help));
    }

    /// Reads a list and returns its elements.
    pub(crate) fn list<'a>(&mut self, value: TomlValue<'a>) -> Option<Vec<TomlValue<'a>>> {
        let read = value.get_ref().as_array();
        if read.is_none() {
            self.wrong_type(value, "a list in brackets");
        }
        read.map(|array| array.iter().collect())
    }

    /// Reads a table with any keys and returns its entries in the order of the text.
    pub(crate) fn entries<'a>(&mut self, value: TomlValue<'a>) -> Vec<(&'a str, Range<usize>, TomlValue<'a>)> {
        let Some(table) = value.get_ref().as_table() else {
            self.wrong_type(value, "a table");
            return Vec::new();
        };
        let mut entries: Vec<_> =
            table.iter().map(|(key, value)| (key.get_ref().as_ref(), key.span(), value)).collect();
        entries.sort_by_key(|(_, span, _)| span.start);
        entries
    }

    /// Reads a table.
    pub(crate) fn table<'a>(&mut self, value: TomlValue<'a>) -> Option<&'a DeTable<'a>> {
        let table = value.get_ref().as_table();
        if table.is_none() {
            self.wrong_type(value, "a table");
        }
        table
    }
}

/// Name nearest to a mistyped one: at most a third of its letters differ, or the mistyped one adds words to it, as
/// `floor_x` does to `floor`.
pub(crate) fn nearest<'n>(word: &str, names: impl Iterator<Item = &'n str> + Clone) -> Option<&'n str> {
    let word = word.to_lowercase();
    let extended = names.clone().filter(|name| {
        word.strip_prefix(&name.to_lowercase()).is_some_and(|added| !name.is_empty() && added.starts_with('_'))
    });
    names
        .map(|name| (strsim::damerau_levenshtein(&word, &name.to_lowercase()), name))
        .filter(|(distance, name)| *distance <= name.chars().count().max(3) / 3)
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, name)| name)
        .or_else(|| extended.max_by_key(|name| name.len()))
}

/// Names in the given quotes, separated by commas.
pub(crate) fn list<'n>(names: impl Iterator<Item = &'n str>, quote: char) -> String {
    let mut all = String::new();
    for name in names {
        let comma = if all.is_empty() { "" } else { ", " };
        // Writing to a string cannot fail.
        let _ = write!(all, "{comma}{quote}{name}{quote}");
    }
    all
}

fn clamp_u32(number: usize) -> u32 {
    u32::try_from(number).unwrap_or(u32::MAX)
}
