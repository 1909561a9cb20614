//! Every key has an effect: with another value the job is another program, simulation or message, or it is refused.

use std::collections::BTreeSet;

use serde_json::Value;
use tempfile::tempdir;
use tests::by_name;

use crate::settings::keys_of_schema;

use super::{Job, Keys, Place, Row, Sees, of_control, run};

impl Keys {
    /// The job in which the effect of a key is seen, without it and with it.
    fn without_and_with(&self, control: &'static str, row: &Row) -> [Job; 2] {
        let mut with = self.job(control, &[row]).expect("one key agrees with itself");
        match &row.cl {
            Some(cl) => with.cl.clone_from(cl),
            None => with.cl = with.cl.replace("FINI\n", &format!("{}FINI\n", of_control(control, &row.texts[1]))),
        }
        for key in &row.without {
            with.settings.remove(key);
        }
        let effect = row.effect.as_ref().and_then(|effect| self.text(control, &row.key, Some(effect)));
        if let Some(effect) = effect {
            with.settings.insert(row.key.clone(), effect);
        }
        let mut without = with.clone();
        without.settings.remove(&row.key);
        // Where the job has it with another value.
        if row.place != Place::Base
            && let Some(value) = self.base_of(control).remove(&row.key)
        {
            without.settings.insert(row.key.clone(), value);
        }
        [without, with]
    }
}

#[test]
fn every_key_has_an_effect() {
    let (keys, folder) = (Keys::new(), tempdir().expect("a folder"));
    let mut idle = Vec::new();
    for row in keys.rows.iter().filter(|row| row.sees != Sees::Elsewhere) {
        // The simulation is of the machine: one control shows it.
        let sees = |control: &&str| row.sees != Sees::Simulation || *control == "linuxcnc";
        for control in by_name::controls().filter(sees).filter(|control| keys.applies(control, row)) {
            let [without, with] = keys.without_and_with(control, row).map(|job| job.run(&folder, row.sees));
            let same =
                (without.posted, &without.output, &without.messages) == (with.posted, &with.output, &with.messages);
            if same {
                idle.push(format!("{} on {control}", row.key));
            }
            // An effect that is a refusal is one of the key, and no slip of this table.
            let is_meant = row.effect.is_some() || row.place == Place::Alone || !row.texts[1].is_empty();
            let refused = !with.posted && without.posted && row.sees != Sees::Messages;
            if refused && !is_meant {
                idle.push(format!("{} on {control} is refused: {}", row.key, with.errors()));
            }
        }
    }
    assert!(idle.is_empty(), "without an effect: {idle:#?}");
}

#[test]
fn every_key_is_in_the_table() {
    let schema: Value = serde_json::from_str(&run(&["config", "--schema"]).output).expect("JSON");
    let mut all = Vec::new();
    keys_of_schema("", &schema, &mut all);
    assert!(all.len() > 200, "{all:?}");
    let keys = Keys::new();
    let mut tested: BTreeSet<&str> = keys.rows.iter().map(|row| row.key.as_str()).collect();
    tested.extend(keys.rows.iter().flat_map(|row| row.with.keys().map(String::as_str)));
    let below = |key: &str, table: &str| key.strip_prefix(table).is_some_and(|rest| rest.starts_with('.'));
    let is_tested = |key: &String| tested.iter().any(|of| of == key || below(key, of) || below(of, key));
    let missing: Vec<&String> = all.iter().filter(|key| !is_tested(key)).collect();
    assert!(missing.is_empty(), "give each a row: {missing:?}");
    // Every field of a tool and of an operation that the sample shows.
    for (table, example) in [("tools", "tools.12"), ("operations", "operations.\"FINISH*\"")] {
        let entry: toml::Table = format!("entry = {}", keys.example("linuxcnc", example)).parse().expect("TOML");
        for field in entry["entry"].as_table().expect("a table").keys() {
            let has = |row: &super::Row| {
                let value = row.value.as_ref().and_then(toml::Value::as_str).unwrap_or_default();
                row.key.starts_with(table)
                    && (row.key.ends_with(&format!(".{field}")) || value.contains(&format!("{field} =")))
            };
            assert!(keys.rows.iter().any(has), "no row for `{field}` of `{table}`");
        }
    }
}

/// A printed example is a value that posts, or whose refusal says what the job lacks.
#[test]
fn printed_examples_post() {
    // What the job has otherwise, or what the example is about.
    const REFUSED: &[(&str, &str)] = &[
        ("machine_zero", "above the retract position"),
        ("table_zero", "above the retract position"),
        ("floor", "below `floor`"),
        ("set_ups.2", "no operation is called `OP20`"),
        ("stock.upper", "both corners of the blank"),
        ("stock.lower", "both corners of the blank"),
        ("stock.diameter", "blank"),
        ("control.coolant", "COOLNT asks for"),
        ("control.mill_turn", "`control.mill_turn` gives the tool another one"),
        ("control.effects", "declare its effect in `[control] effects`"),
        ("control.functions", "`control.functions`"),
        ("program.operation_start", "declare its effect in `[control] effects`"),
        ("program.operation_end", "declare its effect in `[control] effects`"),
    ];
    let (keys, folder) = (Keys::new(), tempdir().expect("a folder"));
    let below = |key: &str, table: &str| key.strip_prefix(table).is_some_and(|rest| rest.starts_with('.'));
    for control in by_name::controls() {
        for (key, value) in &keys.examples[control] {
            let row = keys.rows.iter().find(|row| row.key == *key || below(key, &row.key));
            let row = row.filter(|row| row.place == Place::Asked);
            let Some(mut job) = keys.job(control, row.as_slice()) else { continue };
            job.settings.retain(|other, _| !below(other, key) && row.is_none_or(|row| *other != row.key));
            job.settings.insert(key.clone(), value.clone());
            let outcome = job.run(&folder, Sees::Text);
            let errors = outcome.errors();
            let meant = REFUSED.iter().any(|(of, text)| of == key && errors.contains(text));
            assert!(outcome.posted || meant, "{key} = {value} on {control}: {errors}");
        }
    }
}
