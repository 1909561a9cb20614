//! Every key of the configuration in a job that uses it, and every pair of keys.
//!
//! `tests/data/options/rows.toml` has the keys with a value that is not their default, what else they need, and the
//! settings without which the job cannot be posted; `job.cls` is the job: faces, a contour with cutter compensation, a
//! blade, a pole, a tilted pocket, holes, a bore, a thread and a probe.

mod commands;
mod effects;
mod pairs;
mod together;

use std::collections::{BTreeMap, BTreeSet};
use std::fs;

use machines::SpinnerU5620;
use pp_runtime::cli::{self, Status, Streams};
use tempfile::TempDir;
use tests::by_name;
use toml::{Table, Value};

const JOB: &str = include_str!("../../../data/options/job.cls");
const ROWS: &str = include_str!("../../../data/options/rows.toml");
const BLOCK: &str = include_str!("../../../data/options/block.stl");

/// Settings of a job by key, as TOML.
type Settings = BTreeMap<String, String>;

/// A key, and what its tests need.
struct Row {
    key: String,
    /// Its value, or one for each control; without it the printed example.
    value: Option<Value>,
    /// The value whose effect is seen, where the job cannot be posted with it.
    effect: Option<Value>,
    /// Keys that it needs.
    with: Table,
    /// Settings of the job that it replaces.
    without: Vec<String>,
    /// Operations of the job that it does not have.
    drop: Vec<String>,
    /// Controls that have it.
    controls: Vec<String>,
    /// Where its effect is seen.
    sees: Sees,
    /// Records at the end of the job, those for the effect alone, those before the first operation, and an operation.
    texts: [String; 4],
    /// CL data in the place of the job.
    cl: Option<String>,
    /// The job has it in any case, or not at all.
    place: Place,
}

#[derive(Clone, Copy, PartialEq)]
enum Place {
    /// In the job only where it is asked for.
    Asked,
    /// In every job.
    Base,
    /// In no pair: it changes the meaning of the other settings, or is refused alone.
    Alone,
}

#[derive(Clone, Copy, PartialEq)]
enum Sees {
    /// Blocks of the program.
    Blocks,
    /// Comments, too.
    Text,
    /// Messages.
    Messages,
    /// The simulation.
    Simulation,
    /// The program without `--control`.
    Unnamed,
    /// In other tests: edited programs, a design.
    Elsewhere,
}

/// The table of the keys, and the printed examples of each control.
struct Keys {
    base: Table,
    rows: Vec<Row>,
    examples: BTreeMap<&'static str, Settings>,
}

fn strings(table: &Table, name: &str) -> Vec<String> {
    let list = table.get(name).and_then(Value::as_array).into_iter().flatten();
    list.map(|text| text.as_str().expect("a text").to_owned()).collect()
}

impl Row {
    fn new(key: &str, table: &Table) -> Self {
        let text = |name: &str| table.get(name).and_then(Value::as_str).unwrap_or_default().to_owned();
        let is = |name: &str| table.get(name).and_then(Value::as_bool).unwrap_or(false);
        let sees = match text("sees").as_str() {
            "" => Sees::Blocks,
            "text" => Sees::Text,
            "messages" => Sees::Messages,
            "simulate" => Sees::Simulation,
            "unnamed" => Sees::Unnamed,
            "elsewhere" => Sees::Elsewhere,
            other => panic!("{key}: {other}"),
        };
        let place = match (is("base"), is("effect_only")) {
            (true, _) => Place::Base,
            (_, true) => Place::Alone,
            _ => Place::Asked,
        };
        Self {
            key: key.to_owned(),
            value: table.get("value").cloned(),
            effect: table.get("effect").cloned(),
            with: table.get("with").and_then(Value::as_table).cloned().unwrap_or_default(),
            without: strings(table, "without"),
            drop: strings(table, "drop"),
            controls: strings(table, "controls"),
            sees,
            texts: ["records", "alone", "begin", "operation"].map(text),
            cl: table.get("cl").and_then(Value::as_str).map(str::to_owned),
            place,
        }
    }
}

impl Keys {
    fn new() -> Self {
        let table: Table = ROWS.parse().expect("TOML");
        let part = |name: &str| table[name].as_table().expect("a table").clone();
        let rows = part("keys").iter().map(|(key, of)| Row::new(key, of.as_table().expect("a table"))).collect();
        let examples = by_name::controls().map(|control| (control, examples(control))).collect();
        Self { base: part("base"), rows, examples }
    }

    /// The text of a value for a control: its own one, that for others, or the printed example; `None` where it has
    /// none (`-`).
    fn text(&self, control: &str, key: &str, value: Option<&Value>) -> Option<String> {
        let text = match value {
            Some(Value::Table(by_control)) => by_control.get(control).or_else(|| by_control.get("other"))?.as_str()?,
            Some(value) => value.as_str()?,
            None => "",
        };
        match text {
            "-" => None,
            "" => Some(self.example(control, key)),
            text => Some(text.to_owned()),
        }
    }

    /// The printed example of a key, of a table as one.
    fn example(&self, control: &str, key: &str) -> String {
        let examples = &self.examples[control];
        examples.get(key).cloned().unwrap_or_else(|| {
            let below = format!("{key}.");
            let entries = examples.iter().filter_map(|(of, value)| Some((of.strip_prefix(&below)?, value)));
            let entries: Vec<String> = entries.map(|(name, value)| format!("{name} = {value}")).collect();
            assert!(!entries.is_empty(), "no example of {key} for {control}");
            format!("{{ {} }}", entries.join(", "))
        })
    }

    fn base_of(&self, control: &str) -> Settings {
        let value = |(key, value): (&String, &Value)| Some((key.clone(), self.text(control, key, Some(value))?));
        self.base.iter().filter_map(value).collect()
    }

    /// Whether a control has a key.
    fn applies(&self, control: &str, row: &Row) -> bool {
        let listed = row.controls.is_empty() || row.controls.iter().any(|name| name == control);
        match row.place {
            Place::Base => listed && self.base_of(control).contains_key(&row.key),
            _ => listed && self.text(control, &row.key, row.value.as_ref()).is_some(),
        }
    }

    /// What a key adds to the settings of the job: what it needs, and itself.
    fn settings_of(&self, control: &str, row: &Row) -> Settings {
        let with = |(key, value): (&String, &Value)| Some((key.clone(), self.text(control, key, Some(value))?));
        let mut settings: Settings = row.with.iter().filter_map(with).collect();
        if row.place != Place::Base {
            settings.extend(self.text(control, &row.key, row.value.as_ref()).map(|value| (row.key.clone(), value)));
        }
        settings
    }

    /// The job with some keys; `None` if one needs a value that another one does not have.
    fn job(&self, control: &'static str, rows: &[&Row]) -> Option<Job> {
        let mut asked = Settings::new();
        for row in rows {
            for (key, value) in self.settings_of(control, row) {
                let before = asked.insert(key, value.clone());
                if before.is_some_and(|before| before != value) {
                    return None;
                }
            }
        }
        let base = self.base_of(control);
        let replaces = |row: &&Row| row.place == Place::Base && asked.contains_key(&row.key);
        if rows.iter().copied().any(|row| replaces(&row)) {
            return None;
        }
        let mut settings = base;
        settings.extend(asked);
        let mut texts = [const { String::new() }; 3];
        let mut drop = BTreeSet::new();
        for row in rows {
            let [records, _, begin, operation] = &row.texts;
            for (text, more) in texts.iter_mut().zip([records, begin, operation]) {
                text.push_str(more);
            }
            drop.extend(row.drop.iter().cloned());
        }
        for operation in &drop {
            settings.remove(&format!("operations.{operation}"));
        }
        let cl = job_text(control, &texts, &drop);
        Some(Job { control, settings, cl })
    }
}

/// The printed examples of a control by key.
fn examples(control: &str) -> Settings {
    let sample = run(&["config", "--control", control]).output;
    let (mut section, mut found) = (String::new(), Settings::new());
    for line in sample.lines() {
        if let Some(name) = line.strip_prefix('[').and_then(|line| line.strip_suffix(']')) {
            section = format!("{name}.");
        } else if let Some((key, value)) = line.strip_prefix("# e.g. ").and_then(|line| line.split_once(" = ")) {
            found.insert(format!("{section}{key}"), value.to_owned());
        }
    }
    found
}

/// The CL data of the job. `texts`: records at its end, records before its first operation, an operation.
fn job_text(control: &str, [records, begin, operation]: &[String; 3], drop: &BTreeSet<String>) -> String {
    let mut cl = String::new();
    let mut skips = false;
    for line in JOB.lines() {
        if let Some(name) = line.strip_prefix("TOOL PATH/").and_then(|line| line.split(',').next()) {
            skips = drop.contains(name);
            if name == "FACE" {
                cl.push_str(begin);
            }
        } else if line == "END-OF-PATH" {
            skips = false;
            cl.push_str(operation);
        } else if line == "FINI" {
            cl.push_str(records);
        }
        if !skips {
            cl.push_str(line);
            cl.push('\n');
        }
    }
    of_control(control, &cl)
}

/// CL data with the words that a control has.
fn of_control(control: &str, cl: &str) -> String {
    let one = control == "linuxcnc";
    cl.replace("{aux}", if one { "110" } else { "77" })
        .replace("{orient}", if one { "" } else { ",ORIENT,0" })
        .replace("{offset}", if one || control == "heidenhain" { "2" } else { "12" })
        .replace("PREFUN/{prefun}\n", if control == "heidenhain" { "" } else { "PREFUN/100\n" })
}

/// CL data and settings for a control.
#[derive(Clone)]
struct Job {
    control: &'static str,
    settings: Settings,
    cl: String,
}

struct Outcome {
    posted: bool,
    output: String,
    messages: String,
}

impl Outcome {
    /// Its errors, or all messages where none is marked.
    fn errors(&self) -> String {
        let errors: Vec<&str> = self.messages.lines().filter(|line| line.contains("error")).collect();
        if errors.is_empty() { self.messages.clone() } else { errors.join("\n") }
    }
}

/// Runs a command of the machine: its status, output and messages.
fn executed(arguments: &[impl AsRef<str>]) -> (Status, Vec<u8>, Vec<u8>) {
    let arguments: Vec<_> =
        std::iter::once("spinner").chain(arguments.iter().map(AsRef::as_ref)).map(Into::into).collect();
    let (mut output, mut errors) = (Vec::new(), Vec::new());
    let streams = Streams { input: &mut &b""[..], output: &mut output, errors: &mut errors, terminal: false };
    (cli::run_with::<SpinnerU5620>(&arguments, streams), output, errors)
}

/// The same as text.
fn run(arguments: &[&str]) -> Outcome {
    let (status, output, errors) = executed(arguments);
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).expect("text");
    Outcome { posted: status == Status::Done, output: text(output), messages: text(errors) }
}

impl Job {
    /// The settings as a configuration; keys of a tool or an operation that is a table of its own are in that.
    fn toml(&self) -> String {
        let mut settings = self.settings.clone();
        for (key, value) in &self.settings {
            let table = self.settings.iter().find(|(other, of)| {
                of.starts_with('{') && key.strip_prefix(other.as_str()).is_some_and(|rest| rest.starts_with('.'))
            });
            if let Some((table, _)) = table {
                settings.remove(key);
                let name = &key[table.len() + 1..];
                let of = settings.get_mut(table).expect("it is there");
                let end = of.trim_end().strip_suffix('}').expect("a table").trim_end().to_owned();
                *of = format!("{end}, {name} = {value} }}");
            }
        }
        settings.iter().map(|(key, value)| format!("{key} = {value}\n")).collect()
    }

    /// Posts the job, or does what else shows an effect.
    fn run(&self, folder: &TempDir, sees: Sees) -> Outcome {
        let path = |name: &str| folder.path().join(name).to_str().expect("text").to_owned();
        let (cl, config) = (path("part.cls"), path("set_up.toml"));
        fs::write(&cl, &self.cl).expect("it can be written");
        fs::write(&config, self.toml()).expect("it can be written");
        fs::write(path("block.stl"), BLOCK).expect("it can be written");
        let command = if sees == Sees::Simulation { "simulate" } else { "post" };
        let mut arguments = vec![command, &cl, "--config", &config];
        if sees != Sees::Unnamed {
            arguments.extend(["--control", self.control]);
        }
        arguments.extend(if sees == Sees::Simulation { vec!["--json", "--pitch", "4"] } else { vec!["-o", "-"] });
        let mut outcome = run(&arguments);
        if matches!(sees, Sees::Blocks | Sees::Unnamed) {
            outcome.output = outcome.output.lines().map(|line| format!("{}\n", self.block(line))).collect();
        }
        outcome
    }

    /// A line without its comment.
    fn block<'l>(&self, line: &'l str) -> &'l str {
        let mark = if matches!(self.control, "siemens" | "heidenhain") { ';' } else { '(' };
        line.split(mark).next().unwrap_or_default().trim_end()
    }
}
