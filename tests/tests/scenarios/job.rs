//! CL data and configuration of a run, posted and checked.

use std::collections::BTreeMap;
use std::ffi::OsString;
use std::io::Cursor;

use machines::{Dmu70e, LolaXoyzba, MultiProDesk, SpinnerU5620};
use pp_runtime::check::check;
use pp_runtime::cli::{Status, Streams, run_with};
use pp_runtime::config::{Config, starting_point};
use pp_runtime::control::{self, Control};
use pp_runtime::diag::Diagnostic;
use pp_runtime::kinematics::Machine;
use tests::posting::written;
use toml::{Table, Value};

use crate::format::{Block, Kind, Run, Settings};
use crate::program::{contains, edited, edits};

/// A message with the line of the CL data.
#[derive(Debug, Clone)]
pub(crate) struct Message {
    line: u64,
    text: String,
    /// Without lines of the program.
    short: String,
}

impl Message {
    fn new(line: u64, text: &str) -> Self {
        Self { line, text: text.to_owned(), short: text.to_owned() }
    }

    fn of(found: &Diagnostic) -> Vec<Self> {
        let texts = [Some(&found.text), found.help.as_ref()].into_iter().flatten();
        texts.map(|text| Self::new(found.location.line, text)).collect()
    }

    /// Whether it has the expected text, and the line of the CL data before a colon if one is expected.
    pub(crate) fn has(&self, expected: &str) -> bool {
        match expected.split_once(": ").and_then(|(line, text)| Some((line.parse::<u64>().ok()?, text))) {
            Some((line, text)) => line == self.line && contains(&self.text, text),
            None => contains(&self.text, expected),
        }
    }

    pub(crate) fn full(&self) -> String {
        format!("{}: {}", self.line, self.text)
    }

    /// As a scenario has it.
    pub(crate) fn blessed(&self) -> String {
        format!("{}: {}", self.line, self.short)
    }
}

/// A program that was posted.
pub(crate) struct Posted {
    pub(crate) program: String,
    pub(crate) remarks: Vec<Message>,
    pub(crate) summary: Vec<Message>,
}

/// Alternatives that were chosen, by the line of their block.
pub(crate) type Chosen = BTreeMap<usize, Vec<String>>;

/// CL data and configuration.
pub(crate) struct Job<'s> {
    run: &'s Run,
    settings: &'s Settings,
    cl: String,
    keys: String,
}

/// Calls a function for the machine of a job.
macro_rules! with_machine {
    ($job:ident.$function:ident($($argument:expr),*)) => {
        match &*$job.run.machine {
            "spinner-u5-620" => $job.$function::<SpinnerU5620>($($argument),*),
            "dmu-70e" => $job.$function::<Dmu70e>($($argument),*),
            "lola-xoyzba" => $job.$function::<LolaXoyzba>($($argument),*),
            _ => $job.$function::<MultiProDesk>($($argument),*),
        }
    };
}

impl<'s> Job<'s> {
    /// `other`: the block with which the program is checked, not posted.
    pub(crate) fn of(
        run: &'s Run,
        settings: &'s Settings,
        blocks: &[Block],
        chosen: &Chosen,
        other: Option<&Block>,
    ) -> Self {
        let (mut cl, mut keys) = (Vec::new(), Table::new());
        for block in blocks.iter().filter(|block| !block.is("check")).chain(other) {
            let lines = chosen.get(&block.line).unwrap_or(&block.lines);
            match block.kind {
                Kind::Cl if block.is("edit") => cl = edits(lines).fold(cl, everywhere),
                Kind::Cl if block.name.is_none() => cl = expanded(blocks, lines),
                Kind::Toml if block.is("alone") => keys = table(lines),
                Kind::Toml => merge(&mut keys, table(lines)),
                _ => {}
            }
        }
        keys.extend(run.mode.clone().map(|mode| ("mode".to_owned(), Value::String(mode))));
        // CL data without lines is an empty file.
        let end = if cl.is_empty() { "" } else { "\n" };
        Self { run, settings, cl: cl.join("\n") + end, keys: keys.to_string() }
    }

    /// The texts of its files: CL data and configuration.
    pub(crate) fn files(&self) -> [(&'static str, &str); 2] {
        [("part.cls", &self.cl), ("job.toml", &self.keys)]
    }

    /// Runs a command of the machine in this process: whether it was done, and its messages.
    pub(crate) fn run(&self, args: &[OsString]) -> (bool, String) {
        with_machine!(self.command(args))
    }

    fn command<M: Machine>(&self, args: &[OsString]) -> (bool, String) {
        let (mut output, mut errors) = (Vec::new(), Vec::new());
        let streams = Streams { input: &mut &b""[..], output: &mut output, errors: &mut errors, terminal: false };
        let done = run_with::<M>(args, streams) == Status::Done;
        (done, String::from_utf8(errors).expect("text"))
    }

    pub(crate) fn control(&self) -> &'static dyn Control {
        control::by_name(&self.run.control).expect("a control")
    }

    /// The program, or why there is none.
    pub(crate) fn posted(&self) -> Result<Posted, Vec<Message>> {
        with_machine!(self.post())
    }

    /// Findings of the check, with the fault of its CL data.
    pub(crate) fn findings(&self, program: &str) -> Vec<Message> {
        with_machine!(self.check(program)).unwrap_or_else(|refused| refused)
    }

    fn config<M: Machine>(&self) -> Result<Config, Vec<Message>> {
        let read = starting_point(self.control()).read_over(&M::default(), &self.keys);
        let mut config = read.map_err(|faults| faults.iter().flat_map(Message::of).collect::<Vec<_>>())?;
        config.motion.selected = self.settings.operations.clone();
        config.motion.lift_mm = self.settings.lift_mm;
        let unfit: Vec<Message> =
            config.unfit(&M::default(), self.control()).iter().map(|text| Message::new(0, text)).collect();
        if unfit.is_empty() { Ok(config) } else { Err(unfit) }
    }

    fn post<M: Machine>(&self) -> Result<Posted, Vec<Message>> {
        let written = written::<M>(&self.config::<M>()?, self.control(), &self.cl);
        let (program, report) = written.map_err(|error| vec![Message::new(0, &error.to_string())])?;
        let remarks = report.diagnostics.iter().flat_map(Message::of).collect();
        let summary = report.summary().iter().map(|line| Message::new(0, line)).collect();
        if report.failed { Err(remarks) } else { Ok(Posted { program, remarks, summary }) }
    }

    fn check<M: Machine>(&self, program: &str) -> Result<Vec<Message>, Vec<Message>> {
        let policy = self.config::<M>()?.check_policy::<M>(self.control(), None).expect("a configuration that fits");
        let checked = check::<M>(&policy, Cursor::new(&self.cl), program.as_bytes()).expect("it can be read");
        let fault = checked.fault.iter().flat_map(Message::of);
        let findings = checked.outcome.findings.into_iter();
        let message = |found: pp_runtime::check::Finding| Message {
            line: found.location.line,
            text: found.text,
            short: found.cause,
        };
        Ok(findings.map(message).chain(fault).collect())
    }
}

/// CL data with its named parts in the place of their names.
fn expanded(blocks: &[Block], lines: &[String]) -> Vec<String> {
    let part = |line: &String| match blocks.iter().rfind(|block| block.name.as_deref() == Some(line.trim())) {
        Some(block) => expanded(blocks, &block.lines),
        None => vec![line.clone()],
    };
    lines.iter().flat_map(part).collect()
}

/// CL data after an edit at every one of its places.
fn everywhere(cl: Vec<String>, edit: &[String]) -> Vec<String> {
    let count = edited(&cl, edit).len();
    assert!(count > 0 || edit[0].starts_with('#'), "the CL data has no place for the edit {edit:?}");
    (0..count).rev().fold(cl, |cl, place| edited(&cl, edit).swap_remove(place))
}

fn table(lines: &[String]) -> Table {
    lines.join("\n").parse().unwrap_or_else(|fault| panic!("{fault}"))
}

fn merge(into: &mut Table, from: Table) {
    for (key, value) in from {
        match (into.get_mut(&key), value) {
            (Some(Value::Table(into)), Value::Table(from)) => merge(into, from),
            (_, value) => drop(into.insert(key, value)),
        }
    }
}
