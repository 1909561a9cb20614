//! Settings of each operation, from the entries of `[operations]`.
//!
//! For each key the entry with the number of the operation counts before one with its name, and a name before a
//! pattern. Two entries of one rank that set a key of one operation differently are a fault. The name of an operation
//! is that of the last TOOL PATH before its first motion.

use crate::diag::code::config;
use crate::motion::fault::Fault;
use crate::options::{Mode, OperationChoice, OperationEntry, OperationSettings, OperationTable, Singular, Smoothing};
use crate::program::Location;

/// A setting of an operation, and the entry of the table that makes it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Chosen<'t, V> {
    /// The value.
    pub value: V,
    /// The entry.
    pub by: &'t OperationChoice,
}

/// Settings in force for one operation; `None`: those of the whole program.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ChosenSettings<'t> {
    /// Mode.
    pub mode: Option<Chosen<'t, Mode>>,
    /// Smoothing by the control.
    pub smoothing: Option<Chosen<'t, Smoothing>>,
    /// Largest deviation where the control blends or smooths, mm.
    pub path_tolerance_mm: Option<Chosen<'t, f64>>,
    /// Angle of a free first rotary axis.
    pub singular: Option<Chosen<'t, Singular>>,
    /// Largest deviation of chords and of the tip, mm.
    pub tolerance_mm: Option<Chosen<'t, f64>>,
    /// Largest feed of the tip, mm/min.
    pub largest_feed_mm_per_min: Option<Chosen<'t, f64>>,
}

impl ChosenSettings<'_> {
    /// The values alone.
    #[must_use]
    pub fn values(&self) -> OperationSettings {
        OperationSettings {
            mode: self.mode.map(|chosen| chosen.value),
            smoothing: self.smoothing.map(|chosen| chosen.value),
            path_tolerance_mm: self.path_tolerance_mm.map(|chosen| chosen.value),
            singular: self.singular.map(|chosen| chosen.value),
            tolerance_mm: self.tolerance_mm.map(|chosen| chosen.value),
            largest_feed_mm_per_min: self.largest_feed_mm_per_min.map(|chosen| chosen.value),
            // It changes nothing in the program.
            allowance_mm: None,
        }
    }
}

/// The operation that begins, and its settings.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OperationStart<'t> {
    /// Number of the operation, from 1.
    pub number: u64,
    /// Name of the last TOOL PATH; empty without one.
    pub name: &'t str,
    /// Settings that differ from those of the whole program.
    pub chosen: ChosenSettings<'t>,
    /// Tolerance in force, mm: of these settings or of the whole program, or of LINTOL.
    pub tolerance_mm: f64,
}

/// Finds the settings of each operation of a program.
#[derive(Debug, Clone, Default)]
pub(crate) struct SettingsFinder {
    table: OperationTable,
    /// Name of the last TOOL PATH.
    name: String,
    /// Location of the TOOL PATH since the last operation began.
    named_at: Option<Location>,
    /// Entries that are for an operation so far.
    used: Vec<bool>,
}

impl SettingsFinder {
    pub(crate) fn new(table: &OperationTable) -> Self {
        Self { used: vec![false; table.entries.len()], table: table.clone(), ..Self::default() }
    }

    /// Whether there are entries.
    #[inline]
    pub(crate) fn has_entries(&self) -> bool {
        !self.table.entries.is_empty()
    }

    /// Takes TOOL PATH.
    pub(crate) fn name(&mut self, at: Location, name: &[u8]) {
        if self.has_entries() {
            self.name = String::from_utf8_lossy(name).trim().to_owned();
            self.named_at = Some(at);
        }
    }

    /// Location of the beginning of an operation: its TOOL PATH, or else its first motion.
    pub(crate) fn begins_at(&mut self, first_motion: Location) -> Location {
        self.named_at.take().unwrap_or(first_motion)
    }

    /// Settings of the operation of a number, if it begins now.
    ///
    /// # Errors
    /// Two entries of one rank that set the same key differently.
    pub(crate) fn chosen(&self, number: u64) -> Result<ChosenSettings<'_>, Fault> {
        self.table.chosen(number, &self.name, &self.table.of(number, &self.name))
    }

    /// The operation of a number begins. `tolerance_mm`: in force.
    ///
    /// # Errors
    /// Two entries of one rank that set the same key differently.
    pub(crate) fn begin(&mut self, number: u64, tolerance_mm: f64) -> Result<OperationStart<'_>, Fault> {
        for index in self.table.of(number, &self.name) {
            self.used[index] = true;
        }
        Ok(OperationStart { number, name: &self.name, chosen: self.chosen(number)?, tolerance_mm })
    }

    /// Entries that are for no operation so far.
    pub(crate) fn unused(&self) -> impl Iterator<Item = &OperationChoice> {
        let entries = self.table.entries.iter().zip(&self.used);
        entries.filter(|(_, used)| !**used).map(|(entry, _)| &entry.of)
    }
}

impl OperationChoice {
    /// Entries of a higher rank count before those of a lower one.
    const fn rank(&self) -> u8 {
        match self {
            Self::Number(_) => 2,
            Self::Name(_) => 1,
            Self::Pattern(_) => 0,
        }
    }

    /// Whether an operation is among those of the entry. `name`: in lower case, without blanks around it.
    fn includes(&self, number: u64, name: &str) -> bool {
        match self {
            Self::Number(wanted) => *wanted == number,
            Self::Name(wanted) => wanted.to_lowercase() == name,
            Self::Pattern(pattern) => matches(&pattern.to_lowercase(), name),
        }
    }
}

/// Whether a text matches a pattern with `*` and `?`.
fn matches(pattern: &str, text: &str) -> bool {
    let (pattern, text): (Vec<char>, Vec<char>) = (pattern.chars().collect(), text.chars().collect());
    let (mut at, mut read) = (0, 0);
    // The last star, and the first character after the text that it matches.
    let mut star: Option<(usize, usize)> = None;
    while read < text.len() {
        match pattern.get(at) {
            Some('*') => {
                star = Some((at, read));
                at += 1;
            }
            Some(wanted) if *wanted == '?' || *wanted == text[read] => (at, read) = (at + 1, read + 1),
            _ => {
                let Some((last, end)) = star else { return false };
                star = Some((last, end + 1));
                (at, read) = (last + 1, end + 1);
            }
        }
    }
    pattern[at..].iter().all(|rest| *rest == '*')
}

impl OperationTable {
    /// Indices of the entries for an operation. `name`: as in TOOL PATH.
    fn of(&self, number: u64, name: &str) -> Vec<usize> {
        let name = name.trim().to_lowercase();
        let included = |(index, entry): (usize, &OperationEntry)| entry.of.includes(number, &name).then_some(index);
        self.entries.iter().enumerate().filter_map(included).collect()
    }

    /// The settings that these entries make for an operation.
    ///
    /// # Errors
    /// Two entries of one rank that set the same key differently.
    fn chosen(&self, number: u64, name: &str, entries: &[usize]) -> Result<ChosenSettings<'_>, Fault> {
        let merge = Merge { table: self, entries, operation: (number, name) };
        Ok(ChosenSettings {
            mode: merge.key("mode", |settings| settings.mode)?,
            smoothing: merge.key("smoothing", |settings| settings.smoothing)?,
            path_tolerance_mm: merge.key("path_tolerance", |settings| settings.path_tolerance_mm)?,
            singular: merge.key("singular", |settings| settings.singular)?,
            tolerance_mm: merge.key("tolerance", |settings| settings.tolerance_mm)?,
            largest_feed_mm_per_min: merge.key("largest_feed", |settings| settings.largest_feed_mm_per_min)?,
        })
    }
}

/// Entries for one operation.
struct Merge<'t, 'm> {
    table: &'t OperationTable,
    entries: &'m [usize],
    operation: (u64, &'m str),
}

impl<'t> Merge<'t, '_> {
    /// The value of a key in the entries of the highest rank that have it.
    fn key<V: Copy + PartialEq>(
        &self,
        key: &str,
        value: fn(&OperationSettings) -> Option<V>,
    ) -> Result<Option<Chosen<'t, V>>, Fault> {
        let entries = self.entries.iter().map(|&index| &self.table.entries[index]);
        let having = entries.filter_map(|entry| Some(Chosen { value: value(&entry.settings)?, by: &entry.of }));
        let highest = having.clone().map(|chosen| chosen.by.rank()).max();
        let mut having = having.filter(|chosen| Some(chosen.by.rank()) == highest);
        let chosen = having.next();
        match (chosen, having.find(|other| chosen.is_some_and(|chosen| chosen.value != other.value))) {
            (Some(one), Some(other)) => Err(self.conflict(key, one.by, other.by)),
            (chosen, _) => Ok(chosen),
        }
    }

    fn conflict(&self, key: &str, one: &OperationChoice, other: &OperationChoice) -> Fault {
        let operation = named(self.operation.0, self.operation.1);
        let text = format!("{} and {} set different values of `{key}` for {operation}", one.shown(), other.shown());
        config::OPERATION.fault(text).help(format_args!(
            "give this operation an entry of its own, `[operations.{}] {key}`: a number counts before a name, a name \
             before a pattern",
            self.operation.0
        ))
    }
}

/// An operation in a message: `operation 3 (FINISH)`.
fn named(number: u64, name: &str) -> String {
    match name.trim() {
        "" => format!("operation {number}"),
        name => format!("operation {number} ({name})"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_star_is_any_text_and_a_question_mark_one_character() {
        let cases = [
            ("finish*", "finish", true),
            ("finish*", "finish blade", true),
            ("finish*", "prefinish", false),
            ("*finish", "prefinish", true),
            ("*blade*", "finish blade 2", true),
            ("?0", "10", true),
            ("?0", "0", false),
            ("?0", "100", false),
            ("a*b*c", "aXbYbZc", true),
            ("a*b*c", "aXbYbZ", false),
            ("*", "", true),
            ("?", "", false),
            ("***x", "x", true),
            ("größe?", "größe1", true),
        ];
        for (pattern, text, expected) in cases {
            assert_eq!(matches(pattern, text), expected, "{pattern} {text}");
        }
    }

    fn table(entries: &[(&str, Option<Mode>, Option<f64>)]) -> OperationTable {
        let entry = |&(key, mode, tolerance_mm): &(&str, Option<Mode>, Option<f64>)| OperationEntry {
            of: OperationChoice::of(key).expect("a choice"),
            settings: OperationSettings { mode, tolerance_mm, ..OperationSettings::default() },
        };
        OperationTable { entries: entries.iter().map(entry).collect() }
    }

    fn values(table: &OperationTable, number: u64, name: &str) -> Result<OperationSettings, Fault> {
        table.chosen(number, name, &table.of(number, name)).map(|chosen| chosen.values())
    }

    #[test]
    fn a_number_counts_before_a_name_and_a_name_before_a_pattern_key_by_key() {
        let table = table(&[
            ("3", Some(Mode::Axes), None),
            ("Finish*", Some(Mode::Tcp), Some(0.3)),
            (" finish blade ", Some(Mode::Plane), Some(0.2)),
        ]);
        let of = |number, name| {
            let OperationSettings { mode, tolerance_mm, .. } = values(&table, number, name).expect("no conflict");
            (mode, tolerance_mm)
        };
        assert_eq!(of(3, "FINISH BLADE"), (Some(Mode::Axes), Some(0.2)));
        assert_eq!(of(2, "Finish Blade "), (Some(Mode::Plane), Some(0.2)));
        assert_eq!(of(4, "FINISH HUB"), (Some(Mode::Tcp), Some(0.3)));
        assert_eq!(of(5, "ROUGH"), (None, None));
    }

    #[test]
    fn patterns_that_differ_in_a_key_of_one_operation_are_refused_and_equal_ones_are_not() {
        let table = table(&[
            ("finish*", Some(Mode::Tcp), Some(0.3)),
            ("*blade", Some(Mode::Tcp), Some(0.2)),
            ("4", None, Some(0.1)),
        ]);
        let fault = values(&table, 2, "FINISH BLADE").expect_err("0.3 and 0.2");
        let shown = fault.at(crate::program::Location::default(), crate::diag::Severity::Error).text;
        assert_eq!(
            shown,
            "[operations.\"finish*\"] and [operations.\"*blade\"] set different values of `tolerance` for operation 2 \
             (FINISH BLADE)"
        );
        assert!(values(&table, 3, "FINISH HUB").is_ok());
        // The number decides.
        assert_eq!(values(&table, 4, "FINISH BLADE").map(|settings| settings.tolerance_mm), Ok(Some(0.1)));
    }
}
