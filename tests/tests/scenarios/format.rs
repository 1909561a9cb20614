//! A scenario file: Markdown with settings as list items and fenced blocks.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use pp_runtime::config::{Mode, Operations};
use pp_runtime::control;

use crate::program::is_like;

/// Contents of a fenced block, by the first word after its fence.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    /// CL data, a part of it with a name, or its edit.
    Cl,
    /// Configuration.
    Toml,
    /// Lines of the program.
    Nc,
    /// All lines of the program that are like one of these.
    All,
    /// Texts that are in no line of the program.
    Never,
    /// Edits of the program.
    Edit,
    /// Lines of the program that are lost, one at a time.
    Lost,
    /// Findings after the edit, or after the check with other input, that comes before.
    Finding,
    /// Messages of a job that is refused.
    Error,
    /// Remarks of the post.
    Remark,
    /// Lines of its summary.
    Summary,
    /// Hints of its messages.
    Help,
    /// What a user does who follows a hint.
    Follow,
    /// What the job means, in plain words.
    Means,
}

const KINDS: [(&str, Kind); 14] = [
    ("cl", Kind::Cl),
    ("toml", Kind::Toml),
    ("nc", Kind::Nc),
    ("all", Kind::All),
    ("never", Kind::Never),
    ("edit", Kind::Edit),
    ("lost", Kind::Lost),
    ("finding", Kind::Finding),
    ("error", Kind::Error),
    ("remark", Kind::Remark),
    ("summary", Kind::Summary),
    ("help", Kind::Help),
    ("follow", Kind::Follow),
    ("means", Kind::Means),
];

/// Words that change what a block is for.
const FLAGS: [&str; 10] = ["alone", "also", "check", "cl", "each", "edit", "only", "options", "passes", "toml"];

pub(crate) const MACHINES: [&str; 4] = ["spinner-u5-620", "dmu-70e", "lola-xoyzba", "multiprodesk"];

/// A fenced block.
#[derive(Debug, Clone)]
pub(crate) struct Block {
    pub(crate) kind: Kind,
    /// Words after the kind.
    words: Vec<String>,
    /// Name of a part of CL data.
    pub(crate) name: Option<String>,
    /// Number of places at which an edit can be made.
    pub(crate) places: Option<usize>,
    pub(crate) lines: Vec<String>,
    /// The same as in the file, with the words of the table.
    source: Vec<String>,
    /// Line of its fence, from 1.
    pub(crate) line: usize,
    /// Number of the tries that follow each other and end with their findings; 0 before the first of them.
    pub(crate) tries: usize,
}

impl Block {
    /// Whether the check is tried with another program or other input.
    pub(crate) fn is_try(&self) -> bool {
        matches!(self.kind, Kind::Edit | Kind::Lost) || self.is("check")
    }

    /// The block as one of another kind: `follow cl edit` as `cl edit`.
    pub(crate) fn as_kind(&self, kind: Kind) -> Self {
        Self { kind, ..self.clone() }
    }

    pub(crate) fn is(&self, word: &str) -> bool {
        self.words.iter().any(|known| known == word)
    }

    /// Whether the block is for a run: of the machines, controls and modes, it names none or that of the run.
    pub(crate) fn is_for(&self, run: &Run) -> bool {
        let fits = |names: &mut dyn Iterator<Item = &str>, own: &str| {
            let named: Vec<&str> = names.filter(|name| self.is(name)).collect();
            named.is_empty() || named.contains(&own)
        };
        fits(&mut MACHINES.into_iter(), &run.machine)
            && fits(&mut controls(), &run.control)
            && fits(&mut modes(), run.mode.as_deref().unwrap_or_default())
    }

    /// The block with the words of a control in the place of their names.
    fn spelt(&self, control: &str, words: &Words) -> Self {
        let spell = |line: &String| {
            let own = words.iter().filter(|((of, _), _)| of == control);
            own.fold(line.clone(), |line, ((_, name), text)| line.replace(&format!("<{name}>"), text))
        };
        Self { lines: self.source.iter().map(spell).collect(), ..self.clone() }
    }

    /// Lines of a program as the file has them, where it has lines for them.
    pub(crate) fn unspelt(&self, lines: Vec<String>) -> Vec<String> {
        let written = |line: String| {
            let known = self.lines.iter().position(|wanted| is_like(&line, wanted));
            known.map_or(line, |at| self.source[at].clone())
        };
        lines.into_iter().map(written).collect()
    }
}

fn controls() -> impl Iterator<Item = &'static str> {
    control::CONTROLS.iter().map(|control| control.spellings().name)
}

fn modes() -> impl Iterator<Item = &'static str> {
    Mode::NAMES.into_iter().map(|(name, _)| name)
}

/// Texts by control and name.
type Words = BTreeMap<(String, String), String>;

/// One run of a case.
#[derive(Debug, Clone)]
pub(crate) struct Run {
    pub(crate) machine: String,
    pub(crate) control: String,
    /// Without one, the mode is that of the configuration.
    pub(crate) mode: Option<String>,
}

/// Settings of a file or a case.
#[derive(Debug, Clone, Default)]
pub(crate) struct Settings {
    machines: Vec<String>,
    controls: Vec<String>,
    modes: Vec<String>,
    /// The operations that are posted.
    pub(crate) operations: Option<Operations>,
    /// Lift of a dry run, mm.
    pub(crate) lift_mm: Option<f64>,
    /// Options of the command line, where a hint is followed.
    pub(crate) options: Vec<String>,
}

/// A case with the blocks of the head of its file.
#[derive(Debug, Clone)]
pub(crate) struct Case {
    pub(crate) file: PathBuf,
    pub(crate) name: String,
    /// Line of its heading, from 1.
    pub(crate) line: usize,
    pub(crate) settings: Settings,
    pub(crate) blocks: Vec<Block>,
    words: Words,
}

impl Case {
    /// Blocks of a run.
    pub(crate) fn blocks_of(&self, run: &Run) -> Vec<Block> {
        let own = self.blocks.iter().filter(|block| block.is_for(run));
        own.map(|block| block.spelt(&run.control, &self.words)).collect()
    }

    /// Name of the file, and heading.
    pub(crate) fn title(&self) -> String {
        format!("{}: {}", self.file.file_stem().unwrap_or_default().display(), self.name)
    }

    pub(crate) fn runs(&self) -> Vec<Run> {
        let modes = match &*self.settings.modes {
            [] => vec![None],
            modes => modes.iter().cloned().map(Some).collect(),
        };
        let mut runs = Vec::new();
        for machine in &self.settings.machines {
            for control in &self.settings.controls {
                let of = |mode: &Option<String>| Run {
                    machine: machine.clone(),
                    control: control.clone(),
                    mode: mode.clone(),
                };
                // LinuxCNC has no tilted work planes.
                let has = |mode: &&Option<String>| control != "linuxcnc" || mode.as_deref() != Some("plane");
                runs.extend(modes.iter().filter(has).map(of));
            }
        }
        runs
    }
}

/// Cases of a file, or its first mistake.
pub(crate) fn read(path: &Path) -> Result<Vec<Case>, String> {
    let text = fs::read_to_string(path).map_err(|error| format!("{}: {error}", path.display()))?;
    let head = Case {
        file: path.to_owned(),
        name: String::new(),
        line: 1,
        settings: Settings { machines: vec![MACHINES[0].to_owned()], ..Settings::default() },
        blocks: Vec::new(),
        words: Words::new(),
    };
    let mut columns: Vec<String> = Vec::new();
    let mut cases = vec![head];
    let mut lines = (1..).zip(text.lines());
    while let Some((number, line)) = lines.next() {
        let fault = |what: &str| Err(format!("{}:{number}: {what}: {line}", path.display()));
        if let Some(name) = line.strip_prefix("## ") {
            let head = cases[0].clone();
            cases.push(Case { name: name.to_owned(), line: number, ..head });
        }
        let case = cases.last_mut().expect("the head");
        if let Some(words) = line.strip_prefix("```") {
            let inside: Vec<String> =
                lines.by_ref().map(|(_, line)| line.to_owned()).take_while(|line| !line.starts_with("```")).collect();
            match block(words, inside, number) {
                Some(mut block) => {
                    let last = case.blocks.last().map_or((0, false), |last| (last.tries, last.kind == Kind::Finding));
                    block.tries = last.0 + usize::from(block.is_try() && (last.1 || last.0 == 0));
                    case.blocks.push(block);
                }
                None => return fault("a word that no block has"),
            }
        }
        if let Some(row) = line.strip_prefix('|').and_then(|row| row.strip_suffix('|')) {
            let cells: Vec<String> = row.split('|').map(|cell| cell.trim().trim_matches('`').to_owned()).collect();
            if cells[0].is_empty() {
                columns = cells;
            } else if !cells[0].starts_with("--") {
                let of_controls = columns.iter().zip(&cells).skip(1).filter(|(_, text)| !text.is_empty());
                case.words.extend(of_controls.map(|(of, text)| ((of.clone(), cells[0].clone()), text.clone())));
            }
        }
        if let Some((key, values)) = line.strip_prefix("- ").and_then(|item| item.split_once(": "))
            && set(&mut case.settings, key, values).is_none()
        {
            return fault("no setting, or none of its values");
        }
    }
    cases.remove(0);
    match cases.iter().find(|case| case.settings.controls.is_empty()) {
        Some(case) => Err(format!("{}:{}: no controls are named", path.display(), case.line)),
        None => Ok(cases),
    }
}

fn block(words: &str, lines: Vec<String>, line: usize) -> Option<Block> {
    let mut words = words.split_whitespace();
    let first = words.next()?;
    let kind = KINDS.iter().find(|(name, _)| *name == first)?.1;
    let mut block =
        Block { kind, words: Vec::new(), name: None, places: None, source: lines.clone(), lines, line, tries: 0 };
    for word in words {
        if controls().chain(modes()).chain(MACHINES).chain(FLAGS).any(|known| known == word) {
            block.words.push(word.to_owned());
        } else if kind == Kind::Cl && word == word.to_uppercase() {
            block.name = Some(word.to_owned());
        } else if matches!(kind, Kind::Edit | Kind::Lost) && matches!(word, "place" | "places") {
            block.places?;
        } else {
            block.places = Some(word.parse().ok()?);
        }
    }
    Some(block)
}

fn set(settings: &mut Settings, key: &str, values: &str) -> Option<()> {
    let (values, without) = values.split_once(" but ").unwrap_or((values, ""));
    let list = |text: &str| -> Vec<String> {
        text.split([',', ' ']).filter(|word| !word.is_empty() && *word != "and").map(str::to_owned).collect()
    };
    let chosen = |known: &[&str]| {
        let values = if values == "all" { known.iter().map(|name| (*name).to_owned()).collect() } else { list(values) };
        let (known, without) = (|name: &String| known.contains(&&**name), list(without));
        let valid = values.iter().chain(&without).all(known);
        valid.then(|| values.into_iter().filter(|name| !without.contains(name)).collect::<Vec<String>>())
    };
    match key {
        "machine" | "machines" => settings.machines = chosen(&MACHINES)?,
        "control" | "controls" => settings.controls = chosen(&controls().collect::<Vec<_>>())?,
        "mode" | "modes" => settings.modes = chosen(&modes().collect::<Vec<_>>())?,
        "operations" => {
            settings.operations = Some(match values.strip_prefix("from ") {
                Some(name) => Operations::From(name.to_owned()),
                None => {
                    let (first, last) = values.split_once(" to ").unwrap_or((values, values));
                    Operations::Range(first.parse().ok()?, Some(last.parse().ok()?))
                }
            });
        }
        "options" => settings.options = values.split_whitespace().map(str::to_owned).collect(),
        "dry run lifted by" => settings.lift_mm = Some(values.strip_suffix(" mm")?.parse().ok()?),
        _ => return None,
    }
    Some(())
}
