//! List of all keys with descriptions and defaults. The sample file and the JSON schema are made from it.

use std::collections::BTreeMap;

use serde_json::{Map, Value as Json, json};
use toml::de::DeValue;

use super::{KeyKind, KeyScope, Keys, Slot};

/// Value of a key as shown in the sample.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Printed {
    /// Default, as TOML.
    Default(String),
    /// Example, as TOML, of a key that has no default.
    Example(String),
    /// A section with these entries.
    Section(Vec<(String, Printed)>),
}

/// One key.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct KeyRow {
    /// Path in the file: `work_offset`, `retract.position`.
    pub(crate) path: &'static str,
    /// Number of the table of options that declares the key, from 1.
    pub(crate) group: usize,
    /// Description; empty where the row before describes this key, too.
    pub(crate) text: String,
    /// Note on the machine and the control of the sample; empty without one.
    pub(crate) note: String,
    /// Default or example.
    pub(crate) printed: Printed,
    /// JSON schema of the value.
    pub(crate) schema: Json,
}

/// Every key of a configuration file, in the order of the tables.
#[derive(Debug, Clone)]
pub(crate) struct KeyList {
    scope: KeyScope,
    group: usize,
    rows: Vec<KeyRow>,
    headings: BTreeMap<&'static str, String>,
}

impl KeyList {
    /// An empty list.
    pub(crate) fn new(scope: KeyScope) -> Self {
        Self { scope, group: 0, rows: Vec::new(), headings: BTreeMap::new() }
    }

    /// The keys, in order.
    pub(crate) fn rows(&self) -> &[KeyRow] {
        &self.rows
    }

    /// Description of a section; empty if it has none.
    pub(crate) fn heading(&self, section: &str) -> &str {
        self.headings.get(section).map_or("", String::as_str)
    }

    /// Begins a table of options. `about`: its comment, which becomes the description of `section`.
    pub(crate) fn begin(&mut self, about: &[&str], section: Option<&'static str>) {
        self.group += 1;
        if let Some(section) = section {
            self.headings.insert(section, first_paragraph(about));
        }
    }

    /// Ends a table of options inside another one.
    pub(crate) fn end(&mut self) {
        self.group += 1;
    }

    /// Adds a key. `field` holds its default.
    pub(crate) fn row<K: KeyKind>(
        &mut self,
        path: &'static str,
        comment: &[&str],
        field: &impl Slot<K::Value>,
        kind: &K,
        example: Option<&'static str>,
    ) {
        let assumed = kind.assumed();
        let of_control = self.scope.examples_of(path).next();
        let printed = match (kind.printed(&self.scope), of_control.or(example)) {
            (Some(Printed::Section(entries)), _) => Printed::Section(entries),
            (Some(printed), _) if of_control.is_none() => printed,
            (_, Some(example)) => Printed::Example(example.to_owned()),
            (_, None) => match field.filled().or(assumed.as_ref()) {
                Some(value) => Printed::Default(kind.print(value)),
                None => Printed::Example(String::new()),
            },
        };
        let schema = kind.schema(&self.scope);
        self.add(path, comment, printed, schema);
    }

    /// The part of [`row`](Self::row) that does not depend on the kind of key, so that it is compiled once.
    #[inline(never)]
    fn add(&mut self, path: &'static str, comment: &[&str], printed: Printed, schema: Json) {
        let (group, text, note) = (self.group, first_paragraph(comment), String::new());
        self.rows.push(KeyRow { path, group, text, note, printed, schema });
    }

    /// Takes out the keys of these paths.
    pub(crate) fn leave_out(&mut self, paths: &[&str]) {
        self.rows.retain(|row| !paths.contains(&row.path));
    }

    /// Adds a note to the key of this path.
    pub(crate) fn add_note(&mut self, path: &str, note: &str) {
        for row in self.rows.iter_mut().filter(|row| row.path == path) {
            let space = if row.note.is_empty() || note.is_empty() { "" } else { " " };
            row.note.push_str(space);
            row.note.push_str(note);
        }
    }
}

impl KeyList {
    /// List of the keys that these options describe.
    pub(crate) fn of(options: &impl Keys, scope: KeyScope) -> Self {
        let mut list = Self::new(scope);
        options.describe(&mut list);
        list
    }

    /// JSON schema of a file with these keys.
    pub(crate) fn schema(&self) -> Map<String, Json> {
        let mut properties = Map::new();
        for row in &self.rows {
            let mut schema = row.schema.clone();
            if !row.text.is_empty() {
                schema["description"] = json!(row.text);
            }
            match &row.printed {
                Printed::Default(text) => schema["default"] = from_toml(text),
                Printed::Example(_) => {}
                Printed::Section(entries) => {
                    for (name, printed) in entries {
                        if let Printed::Default(text) = printed {
                            schema["properties"][name]["default"] = from_toml(text);
                        }
                    }
                }
            }
            let Some((section, key)) = row.path.split_once('.') else {
                properties.insert(row.path.to_owned(), schema);
                continue;
            };
            let inside = properties.entry(section).or_insert_with(|| {
                let mut inside = object(Map::new());
                if !self.heading(section).is_empty() {
                    inside.insert("description".to_owned(), json!(self.heading(section)));
                }
                Json::Object(inside)
            });
            inside["properties"][key] = schema;
        }
        object(properties)
    }
}

/// JSON schema of a table that permits these keys only.
fn object(properties: Map<String, Json>) -> Map<String, Json> {
    let entries =
        [("type", json!("object")), ("properties", Json::Object(properties)), ("additionalProperties", json!(false))];
    entries.map(|(key, value)| (key.to_owned(), value)).into_iter().collect()
}

/// Converts a value from TOML to JSON.
fn from_toml(text: &str) -> Json {
    DeValue::parse(text).map_or(Json::Null, |value| plain(value.get_ref()))
}

fn plain(value: &DeValue<'_>) -> Json {
    match value {
        DeValue::String(text) => json!(text),
        DeValue::Integer(number) => number.as_str().parse::<i64>().map_or(Json::Null, |number| json!(number)),
        DeValue::Float(number) => number.as_str().parse::<f64>().map_or(Json::Null, |number| json!(number)),
        DeValue::Boolean(truth) => json!(truth),
        DeValue::Array(list) => list.iter().map(|value| plain(value.get_ref())).collect(),
        DeValue::Table(table) => {
            table.iter().map(|(key, value)| (key.get_ref().to_string(), plain(value.get_ref()))).collect()
        }
        DeValue::Datetime(_) => Json::Null,
    }
}

/// First paragraph of a comment, as one line.
fn first_paragraph(comment: &[&str]) -> String {
    let lines: Vec<&str> = comment.iter().map(|line| line.trim()).take_while(|line| !line.is_empty()).collect();
    lines.join(" ")
}

/// Defaults and examples of options as an inline table: an example of all of them together.
pub(crate) fn example_entries(rows: &[KeyRow]) -> String {
    let shown = rows.iter().filter_map(|row| match &row.printed {
        Printed::Default(text) | Printed::Example(text) => Some(format!("{} = {text}", row.path)),
        Printed::Section(_) => None,
    });
    format!("{{ {} }}", shown.collect::<Vec<_>>().join(", "))
}

/// Angle in degrees as TOML, rounded to nine decimals to hide binary rounding.
pub(crate) fn printed_degrees(radians: f64) -> String {
    printed_number((radians.to_degrees() * 1e9).round() / 1e9)
}

/// Number as a TOML float; negative zero becomes zero.
pub(crate) fn printed_number(value: f64) -> String {
    format!("{:?}", value + 0.0)
}
