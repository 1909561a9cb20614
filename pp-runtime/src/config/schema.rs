//! A JSON schema of the configuration file, for editors: draft 2020-12.
//!
//! Nothing is stated here that stands elsewhere. The printed file, with every line switched on, is read by the reader,
//! which notes of each value what it has to be; comments before a key are its description, and a line that was switched off
//! as a default is one.

use std::collections::BTreeMap;

use serde_json::{Map, Value as Json, json};
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::kinematics::Machine;

use super::value::{Bound, Notes, Reader, Shape};
use super::{Config, print};

/// What the printed file says of the key in a line.
#[derive(Debug, Clone, Default)]
struct Line {
    description: String,
    default: bool,
}

/// The printed file with every line switched on.
struct Sample {
    text: String,
    /// By line, from 0.
    lines: BTreeMap<usize, Line>,
}

/// The JSON schema of a configuration file for the machine `M`; `config`: the defaults of the control.
#[must_use]
pub fn schema<M: Machine>(config: &Config) -> String {
    let sample = switched_on(&print::<M>(config));
    let (root, _) = DeTable::parse_recoverable(&sample.text);
    let mut reader = Reader::noting(&sample.text);
    // Values that do not suit each other are faults of a file, not of their shape.
    Config::default().read_root::<M>(&mut reader, root.get_ref());
    let writer = Writer { sample: &sample, notes: reader.into_notes() };
    let mut schema = writer.table(root.get_ref());
    schema.insert("$schema".to_owned(), json!("https://json-schema.org/draft/2020-12/schema"));
    schema.insert("title".to_owned(), json!(format!("Set-up for {}", M::NAME)));
    // Nothing in it can fail to be written.
    let mut text = serde_json::to_string_pretty(&Json::Object(schema)).unwrap_or_default();
    text.push('\n');
    text
}

/// Takes the marks off the lines that are switched off, and keeps what the comments say.
fn switched_on(printed: &str) -> Sample {
    let mut sample = Sample { text: String::new(), lines: BTreeMap::new() };
    let mut comment = String::new();
    for (number, line) in printed.lines().enumerate() {
        let example = line.strip_prefix("# e.g. ");
        let default = line.strip_prefix('#').filter(|rest| !rest.is_empty() && !rest.starts_with(' '));
        match (example.or(default), line.strip_prefix('#')) {
            (None, Some(text)) => {
                comment.push_str(if comment.is_empty() { "" } else { " " });
                comment.push_str(text.trim());
                sample.text.push_str(line);
            }
            (setting, _) => {
                if !line.is_empty() {
                    let description = std::mem::take(&mut comment);
                    sample.lines.insert(number, Line { description, default: default.is_some() && example.is_none() });
                }
                comment.clear();
                sample.text.push_str(setting.unwrap_or(line));
            }
        }
        sample.text.push('\n');
    }
    sample
}

struct Writer<'s> {
    sample: &'s Sample,
    notes: Notes,
}

impl Writer<'_> {
    /// A table of fixed keys.
    fn table(&self, table: &DeTable<'_>) -> Map<String, Json> {
        let mut properties = Map::new();
        for (key, value) in table {
            let mut schema = self.value(value);
            let line = self.sample.text[..key.span().start].matches('\n').count();
            if let (Json::Object(schema), Some(said)) = (&mut schema, self.sample.lines.get(&line)) {
                if !said.description.is_empty() {
                    schema.insert("description".to_owned(), json!(said.description));
                }
                if said.default {
                    schema.insert("default".to_owned(), plain(value.get_ref()));
                }
            }
            properties.insert(key.get_ref().to_string(), schema);
        }
        let mut schema = Map::new();
        schema.insert("type".to_owned(), json!("object"));
        schema.insert("properties".to_owned(), Json::Object(properties));
        schema.insert("additionalProperties".to_owned(), json!(false));
        schema
    }

    fn value(&self, value: &Spanned<DeValue<'_>>) -> Json {
        match (self.notes.shapes.get(&value.span().start), value.get_ref()) {
            (Some(Shape::Names(names)), DeValue::Table(table)) => self.named(names, table),
            (Some(Shape::Numbered), DeValue::Table(table)) => {
                let alike = table.values().next().map_or(json!({}), |value| self.value(value));
                json!({ "type": "object", "patternProperties": { "^[1-9][0-9]*$": alike }, "additionalProperties": false })
            }
            (Some(Shape::Schema(schema)), _) => serde_json::from_str(schema).unwrap_or_default(),
            (_, DeValue::Table(table)) => Json::Object(self.table(table)),
            (Some(Shape::Number(Bound::Any)), _) => json!({ "type": "number" }),
            (Some(Shape::Number(Bound::NotNegative)), _) => json!({ "type": "number", "minimum": 0 }),
            (Some(Shape::Number(Bound::Positive)), _) => json!({ "type": "number", "exclusiveMinimum": 0 }),
            (Some(Shape::Whole(range)), _) => {
                json!({ "type": "integer", "minimum": range.start(), "maximum": range.end() })
            }
            (Some(Shape::Boolean), _) => json!({ "type": "boolean" }),
            (Some(Shape::Text), _) => json!({ "type": "string" }),
            (Some(Shape::Choice(words)), _) => json!({ "enum": words }),
            (_, DeValue::Array(list)) => {
                let alike = list.iter().next().map_or(json!({}), |value| self.value(value));
                json!({ "type": "array", "items": alike })
            }
            _ => json!({}),
        }
    }

    /// A table of names whose values are like those that the file shows.
    fn named(&self, names: &[String], table: &DeTable<'_>) -> Json {
        let alike = table.values().next().map_or(json!({}), |value| self.value(value));
        let mut schema = self.table(table);
        if let Some(Json::Object(properties)) = schema.get_mut("properties") {
            for name in names {
                properties.entry(name.clone()).or_insert_with(|| alike.clone());
            }
        }
        Json::Object(schema)
    }
}

/// A value as JSON.
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

#[cfg(test)]
mod tests {
    use super::super::sample::Sample as Machine5;
    use super::*;

    fn of_sample() -> Json {
        serde_json::from_str(&schema::<Machine5>(&Config::default())).expect("JSON")
    }

    #[test]
    fn every_key_of_the_reader_is_in_the_schema() {
        let sample = switched_on(&print::<Machine5>(&Config::default()));
        let (root, errors) = DeTable::parse_recoverable(&sample.text);
        assert!(errors.is_empty(), "{errors:?}");
        let mut reader = Reader::noting(&sample.text);
        Config::default().read_root::<Machine5>(&mut reader, root.get_ref());
        let schema = of_sample();
        let keys = reader.into_notes().keys;
        assert!(keys.len() > 80, "{keys:?}");
        for (table, key) in keys {
            let mut path = table.split('.').filter(|part| !part.is_empty()).chain([key]);
            let found = path.try_fold(&schema, |schema, part| {
                let numbered = || schema.get("patternProperties")?.get("^[1-9][0-9]*$");
                schema.get("properties").and_then(|keys| keys.get(part)).or_else(numbered)
            });
            let found = found.unwrap_or_else(|| panic!("`{key}` of [{table}] is missing"));
            assert!(found.as_object().is_some_and(|schema| !schema.is_empty()), "`{key}` of [{table}] may be anything");
        }
    }

    #[test]
    fn a_key_has_its_type_its_words_its_description_and_its_default() {
        let schema = of_sample();
        let key = |path: &str| path.split('.').fold(&schema, |schema, part| &schema["properties"][part]).clone();
        let rapid = key("rapid");
        assert_eq!((&rapid["enum"], &rapid["default"]), (&json!(["direct", "split", "feed"]), &json!("direct")));
        assert!(rapid["description"].as_str().is_some_and(|text| text.starts_with("Rapids inside an operation: ")));
        assert_eq!(key("formats.rotary"), json!({ "type": "integer", "minimum": 0, "maximum": 6, "default": 4 }));
        assert_eq!(key("rapid_feed"), json!({ "type": "number", "exclusiveMinimum": 0 }));
        assert_eq!(key("park.X"), json!({ "type": "number" }));
        assert_eq!(key("rotary_offset.X"), Json::Null);
        assert_eq!(key("limits.B")["anyOf"][0], json!({ "const": "free" }));
        assert_eq!(key("cl.cycle.TAP.args")["items"]["enum"][0], json!("depth"));
        assert_eq!(key("control.coolant.mist")["minItems"], json!(2));
        assert_eq!(schema["additionalProperties"], json!(false));
    }
}
