//! Kinds of keys that several stages use.

use std::ops::RangeInclusive;

use serde_json::{Value as Json, json};

use super::list::{printed_degrees, printed_number};
use super::reader::{Bound, KeyReader, QuantityKind, TomlValue};
use super::{KeyKind, KeyScope};

/// Kind of key: a number, read as mm, as rad, or without conversion.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Measure {
    quantity: QuantityKind,
    bound: Bound,
    /// Additional rule: returns the fault of a number that breaks it.
    fault: fn(f64) -> Option<String>,
}

impl Measure {
    /// A length or a speed: mm, mm/min.
    pub(crate) const fn length(bound: Bound) -> Self {
        Self { quantity: QuantityKind::Length, bound, fault: |_| None }
    }

    /// An angle or a rotary speed: rad, rad/min; degrees in a file.
    pub(crate) const fn angle(bound: Bound) -> Self {
        Self { quantity: QuantityKind::Angle, bound, fault: |_| None }
    }

    /// A number without conversion: rev/min, seconds.
    pub(crate) const fn plain(bound: Bound) -> Self {
        Self { quantity: QuantityKind::Plain, bound, fault: |_| None }
    }

    /// Adds a rule, which returns the fault of a number that breaks it.
    pub(crate) const fn unless(self, fault: fn(f64) -> Option<String>) -> Self {
        Self { fault, ..self }
    }
}

impl KeyKind for Measure {
    type Value = f64;

    fn read(&self, r: &mut KeyReader<'_>, value: TomlValue<'_>) -> Option<f64> {
        let number = match self.quantity {
            QuantityKind::Length => r.length(value, self.bound),
            QuantityKind::Angle | QuantityKind::Plain => r.number(value, self.quantity, self.bound),
        };
        if let Some(fault) = number.and_then(self.fault) {
            r.fault(value.span(), fault, None);
        }
        number
    }

    fn print(&self, value: &f64) -> String {
        match self.quantity {
            QuantityKind::Length | QuantityKind::Plain => printed_number(*value),
            QuantityKind::Angle => printed_degrees(*value),
        }
    }

    fn schema(&self, _scope: &KeyScope) -> Json {
        match self.bound {
            Bound::Any => json!({ "type": "number" }),
            Bound::NotNegative => json!({ "type": "number", "minimum": 0 }),
            Bound::Positive => json!({ "type": "number", "exclusiveMinimum": 0 }),
        }
    }
}

/// Kind of key: a whole number within a range.
#[derive(Debug, Clone)]
pub(crate) struct Whole(pub(crate) RangeInclusive<u32>);

impl KeyKind for Whole {
    type Value = u32;

    fn read(&self, r: &mut KeyReader<'_>, value: TomlValue<'_>) -> Option<u32> {
        r.whole(value, self.0.clone())
    }

    fn print(&self, value: &u32) -> String {
        value.to_string()
    }

    fn schema(&self, _scope: &KeyScope) -> Json {
        json!({ "type": "integer", "minimum": self.0.start(), "maximum": self.0.end() })
    }
}

/// Kind of key: true or false.
#[derive(Debug, Clone, Copy)]
pub(crate) struct YesNo;

impl KeyKind for YesNo {
    type Value = bool;

    fn read(&self, r: &mut KeyReader<'_>, value: TomlValue<'_>) -> Option<bool> {
        r.boolean(value)
    }

    fn print(&self, value: &bool) -> String {
        value.to_string()
    }

    fn schema(&self, _scope: &KeyScope) -> Json {
        json!({ "type": "boolean" })
    }
}

/// Kind of key: one line of text without control characters.
#[derive(Debug, Clone, Copy)]
pub(crate) struct OneLine;

impl KeyKind for OneLine {
    type Value = String;

    fn read(&self, r: &mut KeyReader<'_>, value: TomlValue<'_>) -> Option<String> {
        r.line(value)
    }

    fn print(&self, value: &String) -> String {
        format!("\"{value}\"")
    }

    fn schema(&self, _scope: &KeyScope) -> Json {
        json!({ "type": "string" })
    }
}

/// Kind of key: one of a few words, each with its value.
#[derive(Debug, Clone, Copy)]
pub(crate) struct OneOf<T: 'static>(pub(crate) &'static [(&'static str, T)]);

impl<T: Copy + PartialEq> KeyKind for OneOf<T> {
    type Value = T;

    fn read(&self, r: &mut KeyReader<'_>, value: TomlValue<'_>) -> Option<T> {
        r.choice(value, self.0)
    }

    fn print(&self, value: &T) -> String {
        let word = self.0.iter().find(|(_, known)| known == value).map_or("", |(word, _)| word);
        format!("\"{word}\"")
    }

    fn schema(&self, _scope: &KeyScope) -> Json {
        one_of(self.0.iter().map(|(word, _)| json!(word)).collect())
    }
}

fn one_of(words: Vec<Json>) -> Json {
    json!({ "enum": words })
}

/// Kind of key: a list of values of one kind.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ListOf<K>(pub(crate) K);

impl<K: KeyKind> KeyKind for ListOf<K> {
    type Value = Vec<K::Value>;

    fn read(&self, r: &mut KeyReader<'_>, value: TomlValue<'_>) -> Option<Vec<K::Value>> {
        let values = r.list(value)?;
        Some(values.into_iter().filter_map(|value| self.0.read(r, value)).collect())
    }

    fn print(&self, value: &Vec<K::Value>) -> String {
        let values: Vec<String> = value.iter().map(|value| self.0.print(value)).collect();
        format!("[{}]", values.join(", "))
    }

    fn schema(&self, scope: &KeyScope) -> Json {
        json!({ "type": "array", "items": self.0.schema(scope) })
    }
}

/// Last character of a line of a block that goes on in the next line (a cycle of Heidenhain).
const GOES_ON: char = '~';

/// Kind of key: a list of lines that are blocks. A line that ends in `~` and those that continue it are one block,
/// whose lines have a line feed between them.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Blocks<K>(pub(crate) K);

impl<K: KeyKind<Value = String>> KeyKind for Blocks<K> {
    type Value = Vec<String>;

    fn read(&self, r: &mut KeyReader<'_>, value: TomlValue<'_>) -> Option<Vec<String>> {
        let mut blocks: Vec<String> = Vec::new();
        let mut open = None;
        for value in r.list(value)? {
            let Some(line) = self.0.read(r, value) else { continue };
            let goes_on = line.trim_end().ends_with(GOES_ON);
            match blocks.last_mut().filter(|_| open.is_some()) {
                Some(block) => {
                    block.truncate(block.trim_end().len());
                    block.push('\n');
                    block.push_str(&line);
                }
                None => blocks.push(line),
            }
            open = goes_on.then(|| value.span());
        }
        if let Some(span) = open {
            let help = "each line of a cycle is an element of the list, and the last one ends without `~`";
            let text = "a block goes on in the next line where its line ends in `~`, and no line follows";
            r.fault(span, text.to_owned(), Some(help.to_owned()));
        }
        Some(blocks)
    }

    fn print(&self, value: &Vec<String>) -> String {
        let lines = value.iter().flat_map(|block| block.split('\n'));
        let lines: Vec<String> = lines.map(|line| self.0.print(&line.to_owned())).collect();
        format!("[{}]", lines.join(", "))
    }

    fn schema(&self, scope: &KeyScope) -> Json {
        ListOf(OneLine).schema(scope)
    }
}

/// Kind of key: a point, three lengths X, Y and Z.
#[derive(Debug, Clone, Copy)]
pub(crate) struct LengthPoint;

impl KeyKind for LengthPoint {
    type Value = [f64; 3];

    fn read(&self, r: &mut KeyReader<'_>, value: TomlValue<'_>) -> Option<[f64; 3]> {
        let numbers = r.list(value)?;
        let &[x, y, z] = numbers.as_slice() else {
            let text = format!("three numbers [x, y, z] are needed here, found {}", numbers.len());
            r.fault(value.span(), text, None);
            return None;
        };
        // All three are read before any fault ends the reading, so that each fault is reported.
        let [x, y, z] = [x, y, z].map(|number| r.length(number, Bound::Any));
        Some([x?, y?, z?])
    }

    fn print(&self, value: &[f64; 3]) -> String {
        format!("[{}]", value.map(printed_number).join(", "))
    }

    fn schema(&self, _scope: &KeyScope) -> Json {
        json!({ "type": "array", "items": { "type": "number" }, "minItems": 3, "maxItems": 3 })
    }
}

/// Kind of key with a default for an absent value. The option stays `None`, so that an assumed value is distinguished
/// from a given one.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Assumed<K, V>(pub(crate) K, pub(crate) V);

impl<K: KeyKind<Value = V>, V: Clone> KeyKind for Assumed<K, V> {
    type Value = V;

    fn read(&self, r: &mut KeyReader<'_>, value: TomlValue<'_>) -> Option<V> {
        self.0.read(r, value)
    }

    fn print(&self, value: &V) -> String {
        self.0.print(value)
    }

    fn schema(&self, scope: &KeyScope) -> Json {
        self.0.schema(scope)
    }

    fn assumed(&self) -> Option<V> {
        Some(self.1.clone())
    }
}
