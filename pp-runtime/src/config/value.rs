//! Values and keys of a configuration file, each fault with the place it stands at.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::ops::{Range, RangeInclusive};

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::diag::{Diagnostic, Severity};
use crate::program::Location;

use super::Units;

/// A value with its place in the text.
pub(super) type Value<'a> = &'a Spanned<DeValue<'a>>;

/// Longest length that is taken for one, mm. A typing error, or inches in place of millimetres, shows up here.
const LONGEST_MM: f64 = 1e5;

/// Which numbers make sense.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Bound {
    /// Every finite number.
    Any,
    /// Zero or more.
    NotNegative,
    /// More than zero.
    Positive,
}

/// What a number measures.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Quantity {
    /// As it stands: rev/min, seconds.
    Plain,
    /// The file's unit of length, or that per minute.
    Length,
    /// Degrees, or degrees per minute.
    Angle,
}

/// What a value has to be.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Shape {
    /// A number.
    Number(Bound),
    /// A whole number.
    Whole(RangeInclusive<u32>),
    /// True or false.
    Boolean,
    /// A line of text.
    Text,
    /// One of a few words.
    Choice(Vec<&'static str>),
    /// A table of these keys, with values that are alike.
    Names(Vec<String>),
    /// A table whose keys are numbers, with values that are alike.
    Numbered,
    /// As this JSON schema says.
    Schema(&'static str),
}

/// What was asked for while a file was read: the place of a value in the text and what it has to be, and all keys there are,
/// with their tables.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Notes {
    pub(super) shapes: BTreeMap<usize, Shape>,
    pub(super) keys: Vec<(String, &'static str)>,
}

/// Collects faults while values are read.
pub(super) struct Reader<'t> {
    text: &'t str,
    /// Unit of the file.
    pub(super) units: Units,
    /// A length was read.
    pub(super) lengths: bool,
    faults: Vec<Diagnostic>,
    top: Vec<&'static str>,
    /// What was asked for, where that is wanted.
    notes: Option<Notes>,
}

impl<'t> Reader<'t> {
    pub(super) fn new(text: &'t str) -> Self {
        Self { text, units: Units::Millimetres, lengths: false, faults: Vec::new(), top: Vec::new(), notes: None }
    }

    /// A reader that also notes what each value has to be.
    pub(super) fn noting(text: &'t str) -> Self {
        Self { notes: Some(Notes::default()), ..Self::new(text) }
    }

    /// What has been noted.
    pub(super) fn into_notes(self) -> Notes {
        self.notes.unwrap_or_default()
    }

    /// Notes what a value has to be; the last note about it counts.
    pub(super) fn note(&mut self, value: Value<'_>, shape: impl FnOnce() -> Shape) {
        if let Some(notes) = &mut self.notes {
            notes.shapes.insert(value.span().start, shape());
        }
    }

    pub(super) fn has_faults(&self) -> bool {
        !self.faults.is_empty()
    }

    /// All faults in the order of the text.
    pub(super) fn into_faults(mut self) -> Vec<Diagnostic> {
        self.faults.sort_by_key(|fault| fault.location);
        self.faults
    }

    pub(super) fn fault(&mut self, span: Range<usize>, text: impl Into<String>, help: Option<String>) {
        let bytes = self.text.as_bytes();
        let start = span.start.min(bytes.len());
        let line_start = bytes[..start].iter().rposition(|&byte| byte == b'\n').map_or(0, |at| at + 1);
        let line_end = bytes[start..].iter().position(|&byte| byte == b'\n').map_or(bytes.len(), |at| start + at);
        let line = 1 + bytes[..start].iter().filter(|&&byte| byte == b'\n').count();
        let length = span.end.min(line_end).saturating_sub(start).max(1);
        self.faults.push(Diagnostic {
            severity: Severity::Error,
            location: Location { line: line as u64, column: clamp_u32(start - line_start + 1) },
            length: clamp_u32(length),
            count: 1,
            text: text.into(),
            help,
        });
    }

    fn wrong_type(&mut self, value: Value<'_>, wanted: &str) {
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

    /// A finite number in mm, rad, or as it stands.
    pub(super) fn number(&mut self, value: Value<'_>, quantity: Quantity, bound: Bound) -> Option<f64> {
        self.note(value, || Shape::Number(bound));
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
            Bound::Any => None,
            Bound::NotNegative => (number < 0.0).then_some("a number that is not negative is needed here"),
            Bound::Positive => (number <= 0.0).then_some("a number above zero is needed here"),
        };
        if let Some(wrong) = wrong {
            self.fault(value.span(), wrong, None);
            return None;
        }
        Some(match quantity {
            Quantity::Plain => number,
            Quantity::Angle => number.to_radians(),
            Quantity::Length => {
                self.lengths = true;
                number * self.units.in_mm()
            }
        })
    }

    /// A length in mm that a machine shop can have.
    pub(super) fn length(&mut self, value: Value<'_>, bound: Bound) -> Option<f64> {
        let length = self.number(value, Quantity::Length, bound)?;
        if length.abs() > LONGEST_MM {
            let metres = length.abs() / 1000.0;
            let help = format!("the unit of this file is `{}`", self.units.name());
            self.fault(value.span(), format!("this is a length of {metres} m"), Some(help));
            return None;
        }
        Some(length)
    }

    /// A whole number within `range`.
    pub(super) fn whole(&mut self, value: Value<'_>, range: RangeInclusive<u32>) -> Option<u32> {
        self.note(value, || Shape::Whole(range.clone()));
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

    pub(super) fn boolean(&mut self, value: Value<'_>) -> Option<bool> {
        self.note(value, || Shape::Boolean);
        let read = value.get_ref().as_bool();
        if read.is_none() {
            self.wrong_type(value, "true or false");
        }
        read
    }

    /// Text of one line without control characters.
    pub(super) fn line(&mut self, value: Value<'_>) -> Option<String> {
        self.note(value, || Shape::Text);
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

    /// One of a few words.
    pub(super) fn choice<T: Copy>(&mut self, value: Value<'_>, choices: &[(&'static str, T)]) -> Option<T> {
        self.note(value, || Shape::Choice(choices.iter().map(|(name, _)| *name).collect()));
        let Some(text) = value.get_ref().as_str() else {
            self.wrong_type(value, "text in quotes");
            return None;
        };
        let found = choices.iter().find(|(name, _)| *name == text).map(|&(_, choice)| choice);
        if found.is_none() {
            let names = choices.iter().map(|(name, _)| *name);
            let help = match nearest(text, names.clone()) {
                Some(near) => format!("did you mean \"{near}\"?"),
                None => format!("write one of {}", list(names, '"')),
            };
            self.fault(value.span(), format!("\"{text}\" is not known here"), Some(help));
        }
        found
    }

    /// The elements of a list.
    pub(super) fn list<'a>(&mut self, value: Value<'a>) -> Option<Vec<Value<'a>>> {
        let read = value.get_ref().as_array();
        if read.is_none() {
            self.wrong_type(value, "a list in brackets");
        }
        read.map(|array| array.iter().collect())
    }

    /// A table of free keys, in the order of the text.
    pub(super) fn entries<'a>(&mut self, value: Value<'a>) -> Vec<(&'a str, Range<usize>, Value<'a>)> {
        let Some(table) = value.get_ref().as_table() else {
            self.wrong_type(value, "a table");
            return Vec::new();
        };
        let mut entries: Vec<_> =
            table.iter().map(|(key, value)| (key.get_ref().as_ref(), key.span(), value)).collect();
        entries.sort_by_key(|(_, span, _)| span.start);
        entries
    }

    /// Remembers the keys of the file's first level, for the remark that a key stands below the wrong header.
    pub(super) fn remember_top(&mut self, section: &Section<'_>) {
        self.top.clone_from(&section.known);
    }
}

/// A table of fixed keys: whatever is never asked for is unknown.
pub(super) struct Section<'a> {
    name: String,
    table: Option<&'a DeTable<'a>>,
    known: Vec<&'static str>,
}

impl<'a> Section<'a> {
    /// The file itself, `name` empty, or a table in it.
    pub(super) fn new(name: impl Into<String>, table: &'a DeTable<'a>) -> Self {
        Self { name: name.into(), table: Some(table), known: Vec::new() }
    }

    /// The table in `value`; a section without keys if there is none.
    pub(super) fn of(reader: &mut Reader<'_>, name: impl Into<String>, value: Option<Value<'a>>) -> Self {
        let table = value.and_then(|value| {
            let table = value.get_ref().as_table();
            if table.is_none() {
                reader.wrong_type(value, "a table");
            }
            table
        });
        Self { name: name.into(), table, known: Vec::new() }
    }

    /// The value of a key, the last part of `path`.
    pub(super) fn get(&mut self, path: &'static str) -> Option<Value<'a>> {
        let key = path.rsplit('.').next().unwrap_or(path);
        self.known.push(key);
        self.table?.get(key)
    }

    /// Reports every key that was never asked for.
    pub(super) fn finish(self, reader: &mut Reader<'_>) {
        if let Some(notes) = &mut reader.notes {
            notes.keys.extend(self.known.iter().map(|key| (self.name.clone(), *key)));
        }
        for (key, _) in self.table.into_iter().flat_map(DeTable::iter) {
            let (name, span) = (key.get_ref().as_ref(), key.span());
            if self.known.contains(&name) {
                continue;
            }
            let dot = if self.name.is_empty() { "" } else { "." };
            let path = format!("{}{dot}{name}", self.name);
            if reader.top.contains(&name) {
                let help = format!("`{name}` belongs above the first [header] of the file");
                reader.fault(span, format!("unknown key `{path}`"), Some(help));
            } else if let Some(near) = nearest(name, self.known.iter().copied()) {
                reader.fault(span, format!("unknown key `{path}`; did you mean `{near}`?"), None);
            } else {
                let help = format!("known here are {}", list(self.known.iter().copied(), '`'));
                reader.fault(span, format!("unknown key `{path}`"), Some(help));
            }
        }
    }
}

/// The name that a mistyped one most likely means: at most a third of its letters differ.
pub(crate) fn nearest<'n>(word: &str, names: impl Iterator<Item = &'n str>) -> Option<&'n str> {
    let word = word.to_lowercase();
    names
        .map(|name| (strsim::damerau_levenshtein(&word, &name.to_lowercase()), name))
        .filter(|(distance, name)| *distance <= name.chars().count().max(3) / 3)
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, name)| name)
}

/// `a`, `b`, `c` in quotes of the given kind.
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
