//! JSON schema (draft 2020-12) of the configuration file, for editors.

use serde_json::{Value as Json, json};

use crate::keys::{KeyKind, KeyList, OneOf};
use crate::kinematics::AnyMachine;
use crate::program::Units;

use super::Config;
use super::read::scope;

/// Returns the JSON schema of a configuration file for `machine`. `config`: the defaults of the control.
#[must_use]
pub(crate) fn schema(machine: &dyn AnyMachine, config: &Config) -> String {
    let scope = scope(machine);
    let mut schema = KeyList::of(config, scope).schema();
    schema["properties"]["units"] = OneOf(&Units::NAMES).schema(&scope);
    schema["properties"]["units"]["description"] = json!("Unit of length of this file: \"mm\" or \"in\".");
    schema.insert("$schema".to_owned(), json!("https://json-schema.org/draft/2020-12/schema"));
    schema.insert("title".to_owned(), json!(format!("Set-up for {}", machine.name())));
    // Writing this value to a string cannot fail.
    let mut text = serde_json::to_string_pretty(&Json::Object(schema)).unwrap_or_default();
    text.push('\n');
    text
}

#[cfg(test)]
mod tests {
    use toml::de::DeTable;

    use super::super::print;
    use super::super::sample::Sample as Machine5;
    use super::*;
    use crate::control::LinuxCnc;
    use crate::keys::{KeyReader, KeyTable};

    fn of_sample() -> Json {
        serde_json::from_str(&schema(&Machine5::default(), &Config::default())).expect("JSON")
    }

    /// The printed file with every key enabled.
    fn every_key_enabled() -> String {
        let on = |line: &str| {
            let default = line.strip_prefix('#').filter(|rest| !rest.is_empty() && !rest.starts_with(' '));
            line.strip_prefix("# e.g. ").or(default).unwrap_or(line).to_owned() + "\n"
        };
        print(&Machine5::default(), &LinuxCnc).lines().map(on).collect()
    }

    #[test]
    fn every_key_of_the_reader_is_in_the_schema() {
        let text = every_key_enabled();
        let (root, errors) = DeTable::parse_recoverable(&text);
        assert!(errors.is_empty(), "{errors:?}");
        let mut reader = KeyReader::new(&text, scope(&Machine5::default()));
        Config::default().read_file(&Machine5::default(), &mut reader, &mut KeyTable::new("", Some(root.get_ref())));
        let schema = of_sample();
        let keys = reader.known().to_vec();
        assert!(keys.len() > 80, "{keys:?}");
        for (table, key) in keys {
            let mut path = table.split('.').filter(|part| !part.is_empty()).chain([key]);
            let found = path.try_fold(&schema, |schema, part| {
                let schema = schema.get("items").unwrap_or(schema);
                let numbered = || schema.get("patternProperties")?.get("^[1-9][0-9]*$");
                let named = || schema.get("additionalProperties").filter(|any| any.is_object());
                let one = || schema.get("anyOf")?.as_array()?.iter().find_map(|one| one.get("properties")?.get(part));
                schema.get("properties").and_then(|keys| keys.get(part)).or_else(numbered).or_else(named).or_else(one)
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
        let rotary = json!({
            "type": "integer", "minimum": 0, "maximum": 6, "default": 4,
            "description": "Decimals of rotary words in degrees.",
        });
        assert_eq!(key("formats.rotary"), rotary);
        assert_eq!(key("rapid_feed"), json!({ "type": "number", "exclusiveMinimum": 0 }));
        assert_eq!(key("park.X"), json!({ "type": "number" }));
        assert_eq!(key("rotary_offset.X"), Json::Null);
        assert_eq!(key("limits.B")["anyOf"][0], json!({ "const": "free" }));
        assert_eq!(key("cl.cycle.TAP.args")["items"]["enum"][0], json!("depth"));
        assert_eq!(key("control.coolant.mist")["minItems"], json!(2));
        assert_eq!(schema["additionalProperties"], json!(false));
    }
}
