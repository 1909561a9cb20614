//! Every key with its description and its default: what the sample and the schema of a configuration file are made of.

use std::collections::BTreeMap;

use serde_json::{Map, Value as Json, json};
use toml::de::DeValue;

use super::{KeyKind, KeyScope, Keys, Slot};

/// How a key is shown in a sample.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Printed {
    /// Its default, as TOML.
    Default(String),
    /// An example, as TOML; there is no default.
    Example(String),
    /// A section of its own, with an entry for each name.
    Section(Vec<(String, Printed)>),
}

/// One key.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct KeyRow {
    /// As in a file: `work_offset`, `retract.position`.
    pub(crate) path: &'static str,
    /// The table of options that it is in, counted from 1.
    pub(crate) group: usize,
    /// What it is for; empty where the row above says so.
    pub(crate) text: String,
    /// Its default or an example.
    pub(crate) printed: Printed,
    /// The JSON schema of its value.
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
    /// No key yet.
    pub(crate) fn new(scope: KeyScope) -> Self {
        Self { scope, group: 0, rows: Vec::new(), headings: BTreeMap::new() }
    }

    /// The keys, in order.
    pub(crate) fn rows(&self) -> &[KeyRow] {
        &self.rows
    }

    /// What a section is about; empty where nothing is said.
    pub(crate) fn heading(&self, section: &str) -> &str {
        self.headings.get(section).map_or("", String::as_str)
    }

    /// A table of options begins, whose comment heads a section.
    pub(crate) fn begin(&mut self, about: &[&str], section: Option<&'static str>) {
        self.group += 1;
        if let Some(section) = section {
            self.headings.insert(section, first_paragraph(about));
        }
    }

    /// A table of options inside another one ends.
    pub(crate) fn end(&mut self) {
        self.group += 1;
    }

    /// A key with its comment and the field that holds its default.
    pub(crate) fn row<K: KeyKind>(
        &mut self,
        path: &'static str,
        comment: &[&str],
        field: &impl Slot<K::Value>,
        kind: &K,
        example: Option<&'static str>,
    ) {
        let assumed = kind.assumed();
        let printed = match (kind.printed(&self.scope), field.filled().or(assumed.as_ref()), example) {
            (Some(printed), ..) => printed,
            (None, Some(value), None) => Printed::Default(kind.print(value)),
            (None, _, Some(example)) => Printed::Example(example.to_owned()),
            (None, None, None) => Printed::Example(String::new()),
        };
        let schema = kind.schema(&self.scope);
        self.rows.push(KeyRow { path, group: self.group, text: first_paragraph(comment), printed, schema });
    }
}

impl KeyList {
    /// What the options describe.
    pub(crate) fn of(options: &impl Keys, scope: KeyScope) -> Self {
        let mut list = Self::new(scope);
        options.describe(&mut list);
        list
    }

    /// The JSON schema of a file with these keys.
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

/// The schema of a table of these keys alone.
fn object(properties: Map<String, Json>) -> Map<String, Json> {
    let entries =
        [("type", json!("object")), ("properties", Json::Object(properties)), ("additionalProperties", json!(false))];
    entries.map(|(key, value)| (key.to_owned(), value)).into_iter().collect()
}

/// A value in TOML as JSON.
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

/// The lines of a comment up to an empty one, as one.
fn first_paragraph(comment: &[&str]) -> String {
    let lines: Vec<&str> = comment.iter().map(|line| line.trim()).take_while(|line| !line.is_empty()).collect();
    lines.join(" ")
}

/// The examples and defaults of options as an inline table, for an example of all of them together.
pub(crate) fn example_entries(rows: &[KeyRow]) -> String {
    let shown = rows.iter().filter_map(|row| match &row.printed {
        Printed::Default(text) | Printed::Example(text) => Some(format!("{} = {text}", row.path)),
        Printed::Section(_) => None,
    });
    format!("{{ {} }}", shown.collect::<Vec<_>>().join(", "))
}

/// Radians in degrees without the noise of the last binary digits.
pub(crate) fn printed_degrees(radians: f64) -> String {
    printed_number((radians.to_degrees() * 1e9).round() / 1e9)
}

/// A TOML float.
pub(crate) fn printed_number(value: f64) -> String {
    format!("{:?}", value + 0.0)
}
