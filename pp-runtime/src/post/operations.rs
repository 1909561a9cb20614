//! Operations of the CL data by number and name: those that are posted, and those with settings of their own.

use std::ops::RangeInclusive;

use crate::config::{Config, list, nearest};
use crate::diag::code::config;
use crate::diag::{Diagnostic, Severity, counted};
use crate::motion::OperationStart;
use crate::options::{Mode, OperationChoice, OperationSettings, Operations, Singular};
use crate::program::{Location, Shown};

/// Largest number of operation names that are kept for a message.
const MOST_NAMES: usize = 1000;

/// Largest number of operation names that a message lists.
const MOST_LISTED: usize = 10;

/// The selected operations (`--ops`, `--from-op`), and whether the CL data has them.
#[derive(Debug, Default)]
pub(super) struct SelectedOperations {
    select: Option<Operations>,
    /// The next operation has the selected name.
    named: bool,
    /// Number of the first operation of that name.
    first: Option<u64>,
    /// Other names of operations, for the message.
    names: Vec<String>,
}

impl SelectedOperations {
    pub(super) fn of(select: Option<Operations>) -> Self {
        Self { select, ..Self::default() }
    }

    /// Takes the name of a TOOL PATH record.
    pub(super) fn name(&mut self, name: &[u8]) {
        let Some(Operations::From(wanted)) = &self.select else { return };
        let name = String::from_utf8_lossy(name).trim().to_owned();
        let found = name.eq_ignore_ascii_case(wanted.trim());
        if !found && self.names.len() < MOST_NAMES {
            self.names.push(name);
        }
        self.named |= found;
    }

    /// Notes that the operation of this number begins.
    pub(super) fn begin(&mut self, number: u64) {
        if std::mem::take(&mut self.named) {
            self.first.get_or_insert(number);
        }
    }

    /// Whether the operation that has just begun is selected.
    pub(super) fn holds(&self, number: u64) -> bool {
        match &self.select {
            None => true,
            Some(Operations::Range(first, last)) => number >= *first && last.is_none_or(|last| number <= last),
            Some(Operations::From(_)) => self.first.is_some(),
        }
    }

    /// Numbers of the selected operations, of `operations` in all; `None` for all, a sentence if they do not exist.
    /// Where they go on to the end, the records after the last operation are selected, too.
    pub(super) fn numbers(&self, operations: u64) -> Option<Result<RangeInclusive<u64>, String>> {
        Some(match self.select.as_ref()? {
            Operations::Range(first, last) => {
                let missing = last.unwrap_or(*first).max(*first);
                if missing > operations {
                    let count = counted(operations, "operation");
                    Err(format!("the CL data has {count}: there is no operation {missing}"))
                } else {
                    Ok(*first..=last.map_or(u64::MAX, |last| last.max(*first)))
                }
            }
            Operations::From(name) => match self.first {
                Some(first) => Ok(first..=u64::MAX),
                None => Err(format!("no operation of the CL data is called `{name}`: {}", self.known_names(name))),
            },
        })
    }

    fn known_names(&self, name: &str) -> String {
        let names = || self.names.iter().map(String::as_str);
        match nearest(name, names()) {
            Some(near) => format!("did you mean `{near}`?"),
            None if self.names.is_empty() => "none has a name".to_owned(),
            None => format!("its operations are {}", list(names().take(MOST_LISTED), '`')),
        }
    }
}

/// Operations by number and name.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct OperationNames {
    /// The first of them.
    names: Vec<(u64, String)>,
    /// Number of all.
    count: u64,
}

impl OperationNames {
    /// Adds an operation.
    pub(super) fn add(&mut self, start: &OperationStart<'_>) {
        self.count += 1;
        if self.names.len() < MOST_NAMES {
            self.names.push((start.number, start.name.to_owned()));
        }
    }

    /// `3 FINISH, 4 and 2 more`.
    fn listed(&self) -> String {
        let shown = self.names.iter().take(MOST_LISTED);
        let shown: Vec<String> = shown.map(|(number, name)| format!("{number} {name}").trim().to_owned()).collect();
        let more = match self.count - shown.len() as u64 {
            0 => String::new(),
            more => format!(" and {more} more"),
        };
        format!("{}{more}", shown.join(", "))
    }

    /// Error of an entry that is for no operation of the program; none for a pattern, which may serve several programs.
    pub(super) fn unused(&self, entry: &OperationChoice, operations: u64, location: Location) -> Option<Diagnostic> {
        let near = match entry {
            OperationChoice::Name(wanted) => nearest(wanted, self.names.iter().map(|(_, name)| name.as_str())),
            OperationChoice::Number(_) => None,
            OperationChoice::Pattern(_) => return None,
        };
        let help = match (near, operations) {
            (_, 0) => "remove it: the CL data has no motion after a tool call".to_owned(),
            (Some(near), _) => format!("did you mean `{near}`? The operations are {}", self.listed()),
            (None, _) => format!("the operations are {}", self.listed()),
        };
        let text = format!("`{}` of the configuration is for no operation of the CL data", entry.shown());
        Some(Diagnostic {
            code: config::OPERATION,
            severity: Severity::Error,
            location,
            length: 1,
            count: 1,
            text,
            help: Some(help),
        })
    }
}

/// Settings of operations that differ from those of the whole program, one sentence each.
pub(super) fn settings(config: &Config, settings: &[(OperationSettings, OperationNames)]) -> Vec<String> {
    let line = |(settings, names): &(OperationSettings, OperationNames)| {
        let differ = differences(config, settings);
        let word = if names.count == 1 { "operation" } else { "operations" };
        (!differ.is_empty()).then(|| format!("{word} {}: {}", names.listed(), differ.join(", ")))
    };
    settings.iter().filter_map(line).collect()
}

fn differences(config: &Config, settings: &OperationSettings) -> Vec<String> {
    let motion = &config.motion;
    let mode = settings.mode.filter(|mode| *mode != motion.mode).map(|mode| format!("mode {}", Mode::name(mode)));
    let smoothing = settings.smoothing.filter(|level| *level != config.control.smoothing);
    let singular = settings.singular.filter(|singular| *singular != motion.singular);
    let tolerance = settings.tolerance_mm.filter(|tolerance| tolerance.total_cmp(&motion.tolerance_mm).is_ne());
    let feed = settings.largest_feed_mm_per_min.map(|feed| format!("feed at most {} mm/min", Shown(feed)));
    [
        mode,
        smoothing.map(|level| format!("smoothing {}", level.name())),
        settings.path_tolerance_mm.map(|tolerance| format!("path tolerance {} mm", Shown(tolerance))),
        singular.map(|singular| format!("singular {}", Singular::name(singular))),
        tolerance.map(|tolerance| format!("tolerance {} mm", Shown(tolerance))),
        feed,
    ]
    .into_iter()
    .flatten()
    .collect()
}
