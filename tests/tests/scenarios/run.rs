//! The runs of a case, compared with its blocks.

use std::fmt::{self, Display, Formatter};
use std::path::PathBuf;

use tests::posting::renumbered;

use crate::format::{Block, Case, Kind, Run};
use crate::job::{Chosen, Job, Message};
use crate::program::{self, contains, edited, edits};
use crate::remedies;

/// What is not as a block expects it.
#[derive(Debug)]
pub(crate) struct Failure {
    pub(crate) file: PathBuf,
    /// Line of the fence of the block, or of the heading.
    pub(crate) line: usize,
    /// Runs that fail so.
    pub(crate) runs: Vec<String>,
    pub(crate) text: String,
    /// Lines that the block would have.
    pub(crate) blessed: Option<Vec<String>>,
}

impl Failure {
    pub(crate) fn new(case: &Case, line: usize, run: &str, text: &str, blessed: Option<Vec<String>>) -> Self {
        let text = format!("{}\n{}", case.name, text.trim_end()).replace('\n', "\n    ");
        Self { file: case.file.clone(), line, runs: vec![run.to_owned()], text, blessed }
    }

    /// Joins failures of a block in several runs that differ in nothing else.
    pub(crate) fn joined(failures: Vec<Self>) -> Vec<Self> {
        let mut joined: Vec<Self> = Vec::new();
        for mut failure in failures {
            let is_alike = |one: &&mut Self| (one.line, &one.text) == (failure.line, &failure.text);
            match joined.iter_mut().find(is_alike) {
                Some(one) => one.runs.append(&mut failure.runs),
                None => joined.push(failure),
            }
        }
        joined
    }
}

impl Display for Failure {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let name = self.file.file_name().unwrap_or_default().display();
        writeln!(f, "tests/scenarios/{name}:{}: {}\n    in: {}", self.line, self.text, self.runs.join("; "))
    }
}

/// Failures of a case; `shows`: its programs are printed.
pub(crate) fn failures(case: &Case, shows: bool) -> Vec<Failure> {
    let mut failures = Vec::new();
    let mut idle: Vec<&Block> = case.blocks.iter().filter(|block| block.line > case.line).collect();
    for run in case.runs() {
        idle.retain(|block| !block.is_for(&run));
        let blocks = case.blocks_of(&run);
        let mut choices = vec![Chosen::new()];
        for block in blocks.iter().filter(|block| block.is("each")) {
            let more = |choice: &Chosen| {
                let with =
                    |lines: &[String]| choice.clone().into_iter().chain([(block.line, lines.to_vec())]).collect();
                edits(&block.lines).map(with).collect::<Vec<Chosen>>()
            };
            choices = choices.iter().flat_map(more).collect();
        }
        for chosen in &choices {
            failures.append(&mut compare(case, &run, &blocks, chosen, shows));
        }
    }
    failures.extend(idle.iter().map(|block| Failure::new(case, block.line, "none", "no run has this block", None)));
    Failure::joined(failures)
}

/// Failures of a run with some alternatives.
fn compare(case: &Case, run: &Run, blocks: &[Block], chosen: &Chosen, shows: bool) -> Vec<Failure> {
    let choice = chosen.values().map(|lines| format!(", {}", lines.join(" | "))).collect::<String>();
    let name = format!("{} {} {}{choice}", run.machine, run.control, run.mode.as_deref().unwrap_or_default());
    let failure = |line: usize, text: &str, blessed| Failure::new(case, line, &name, text, blessed);
    if blocks.iter().any(|block| block.kind == Kind::Help) {
        let failures = remedies::failures(case, run, blocks, shows);
        return failures.into_iter().map(|(line, text, blessed)| failure(line, &text, blessed)).collect();
    }
    let job = Job::of(run, &case.settings, blocks, chosen, None);
    let of_error = blocks.iter().filter(|block| block.kind == Kind::Error);
    let posted = match job.posted() {
        Ok(posted) => posted,
        Err(messages) if of_error.clone().count() == 0 => {
            return vec![failure(case.line, &format!("it is refused:\n{}", listed(&messages)), None)];
        }
        Err(messages) => {
            let of = |block: &Block| missing(block, &messages).map(|(text, new)| failure(block.line, &text, new));
            return of_error.filter_map(of).collect();
        }
    };
    if shows {
        println!("{}, {name}:\n{}", case.title(), posted.program);
    }
    let lines = program::unnumbered(&posted.program, job.control().spellings().numbers_every_line);
    let mut failures = Vec::new();
    // What was checked last, with its findings: at first the posted program.
    let (mut tried, mut tries) = (vec![(String::new(), job.findings(&posted.program))], 0);
    let is_own_finding = |block: &Block| block.kind == Kind::Finding && block.tries == 0;
    if !blocks.iter().any(is_own_finding) && !tried[0].1.is_empty() {
        failures.push(failure(case.line, &format!("its check finds:\n{}", listed(&tried[0].1)), None));
    }
    for block in blocks {
        let mut fails = |text: &str, blessed: Option<Vec<String>>| {
            failures.push(failure(block.line, text, blessed.map(|lines| block.unspelt(lines))));
        };
        match block.kind {
            Kind::Error => fails("it is posted, not refused", None),
            Kind::Remark | Kind::Summary => {
                let messages = if block.kind == Kind::Remark { &posted.remarks } else { &posted.summary };
                if let Some((text, blessed)) = missing(block, messages) {
                    fails(&text, blessed);
                }
            }
            Kind::Nc => {
                if let Some((text, blessed)) = program::excerpt(&lines, &block.lines) {
                    fails(&text, blessed);
                }
            }
            Kind::All => {
                let found = program::like_one_of(&lines, &block.lines);
                let alike = found.iter().zip(&block.lines).all(|(line, wanted)| program::is_like(line, wanted));
                if found.len() != block.lines.len() || !alike {
                    fails(&program::difference(&block.lines, &found), Some(found));
                }
            }
            Kind::Never => {
                for text in block.lines.iter().filter(|text| lines.iter().any(|line| contains(line, text))) {
                    fails(&format!("the program has {text}"), None);
                }
            }
            Kind::Finding if block.tries != tries => {}
            Kind::Finding => {
                for (what, found) in &tried {
                    if let Some((text, blessed)) = missing(block, found) {
                        fails(&format!("{what}{text}"), blessed);
                    }
                }
            }
            // A case with a hint is compared by `remedies`.
            Kind::Help | Kind::Follow | Kind::Means => {}
            Kind::Cl | Kind::Toml if !block.is("check") => {}
            Kind::Cl | Kind::Toml => {
                let other = Job::of(run, &case.settings, blocks, chosen, Some(block));
                tried = vec![(block.lines.join("\n") + "\n", other.findings(&posted.program))];
            }
            Kind::Edit | Kind::Lost => {
                let lost = block.lines.iter().map(|line| vec![format!("- {line}")]);
                let edits: Vec<Vec<String>> = match block.kind {
                    Kind::Lost => lost.collect(),
                    _ => edits(&block.lines).map(<[String]>::to_vec).collect(),
                };
                tried.clear();
                for edit in edits {
                    let programs = edited(&lines, &edit);
                    if block.places.map_or(programs.is_empty(), |places| places != programs.len()) {
                        let places = programs.len();
                        fails(&format!("{places} places for the edit\n{}", edit.join("\n")), None);
                    }
                    tried.extend(programs.into_iter().map(|edited| {
                        let text: Vec<&str> = edited.iter().map(String::as_str).collect();
                        let found = job.findings(&renumbered(job.control(), &text));
                        (program::difference(&lines, &edited), found)
                    }));
                }
            }
        }
        if block.is_try() {
            tries = block.tries;
            for (what, found) in tried.iter().filter(|(_, found)| block.is("passes") != found.is_empty()) {
                let found = if found.is_empty() { "it is not found".to_owned() } else { listed(found) };
                failures.push(failure(block.line, &format!("{what}{found}"), None));
            }
        }
    }
    failures
}

fn listed(messages: &[Message]) -> String {
    messages.iter().map(Message::full).collect::<Vec<_>>().join("\n")
}

/// The expected lines of a block that no message has, with the messages, and the lines that it would have.
fn missing(block: &Block, messages: &[Message]) -> Option<(String, Option<Vec<String>>)> {
    let has = |expected: &&String| messages.iter().any(|message| message.has(expected));
    let (present, lost): (Vec<&String>, Vec<&String>) = block.lines.iter().partition(has);
    let more = block.is("only") && messages.len() > block.lines.len();
    if lost.is_empty() && !more && (block.is("only") || !block.lines.is_empty()) {
        return None;
    }
    let new = messages.first().map(Message::blessed);
    let blessed = new.map(|new| present.into_iter().cloned().chain([new]).collect());
    Some((format!("expected: {lost:?}\nfound:\n{}", listed(messages)), blessed))
}
