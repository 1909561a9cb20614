//! Faults and remarks about CL data or a configuration file, without the text they point at.

use std::collections::BTreeMap;

use crate::program::Location;

/// Diagnostics of one kind that are listed; the rest is counted.
pub(crate) const LISTED_OF_A_KIND: u64 = 20;

/// More kinds than this share one count; it bounds the memory.
const MOST_KINDS: usize = 1000;

/// How much a diagnostic weighs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Severity {
    /// Nothing is posted from here on.
    Error,
    /// Posted, but to be looked at.
    Warning,
}

/// One fault or remark, in a machinist's words, with a remedy.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Diagnostic {
    /// Error or warning.
    pub severity: Severity,
    /// First byte it speaks of.
    pub location: Location,
    /// Number of bytes it speaks of, at least 1, within that line.
    pub length: u32,
    /// One sentence, no final stop.
    pub text: String,
    /// What to do about it.
    pub help: Option<String>,
    /// How many it stands for: 1, or all that are not listed because they are like others before them.
    pub count: u64,
}

impl Diagnostic {
    /// What diagnostics have in common that differ only in numbers and quoted words.
    pub(crate) fn kind(&self) -> String {
        let mut kind = String::new();
        for (index, piece) in self.text.split('`').enumerate() {
            if index % 2 == 1 {
                kind.push('…');
                continue;
            }
            let mut in_number = false;
            for character in piece.chars() {
                let belongs = character.is_ascii_digit() || (in_number && character == '.');
                match (in_number, belongs) {
                    (false, true) => kind.push('#'),
                    (_, false) => kind.push(character),
                    (true, true) => {}
                }
                in_number = belongs;
            }
        }
        kind
    }
}

/// Remarks in the order found. A file with a million of them must not fill the memory, so each kind is listed a few
/// times and counted from then on.
#[derive(Debug, Default)]
pub(crate) struct Remarks {
    listed: Vec<Diagnostic>,
    /// How many of each kind were found, and the first that is not listed.
    kinds: BTreeMap<String, (u64, Option<Diagnostic>)>,
}

impl Remarks {
    pub(crate) fn add(&mut self, found: Diagnostic) {
        let mut kind = found.kind();
        if self.kinds.len() >= MOST_KINDS && !self.kinds.contains_key(&kind) {
            kind = "other remarks".into();
        }
        let (count, hidden) = self.kinds.entry(kind).or_default();
        *count += 1;
        if *count <= LISTED_OF_A_KIND {
            self.listed.push(found);
        } else {
            hidden.get_or_insert(found);
        }
    }

    /// All that is listed, and how many others there were.
    pub(crate) fn conclude(self) -> Vec<Diagnostic> {
        let hidden = self.kinds.into_iter().filter_map(|(kind, (count, hidden))| {
            let count = count - LISTED_OF_A_KIND.min(count);
            let text = format!("{count} more of this kind from here on: {kind}");
            hidden.map(|first| Diagnostic { length: 1, text, help: None, count, ..first })
        });
        let mut all = self.listed;
        all.extend(hidden);
        all
    }
}

/// A number as people read it: `48 211`.
pub(crate) fn grouped(number: u64) -> String {
    let digits = number.to_string();
    let mut text = String::new();
    for (index, digit) in digits.chars().enumerate() {
        if index > 0 && (digits.len() - index).is_multiple_of(3) {
            text.push(' ');
        }
        text.push(digit);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn twenty_remarks_of_a_kind_are_listed_and_the_rest_is_counted() {
        let remark = |line: u64, text: String| {
            let location = Location { line, column: 1 };
            Diagnostic { severity: Severity::Warning, location, length: 4, text, help: None, count: 1 }
        };
        let mut remarks = Remarks::default();
        (1..=100_000).for_each(|line| remarks.add(remark(line, format!("`M{line}` is {line}.5 mm away"))));
        remarks.add(remark(7, "another".into()));
        let found = remarks.conclude();
        assert_eq!(found.len(), 22);
        assert_eq!(found[20].text, "another");
        let rest = &found[21];
        assert_eq!((rest.count, rest.location.line), (99_980, 21));
        assert_eq!(rest.text, "99980 more of this kind from here on: … is # mm away");
        let mut remarks = Remarks::default();
        let name = |n: u64| format!("{}x", char::from_u32(0x4E00 + n as u32).unwrap_or('?'));
        (0..5000).for_each(|n| remarks.add(remark(n, name(n))));
        let found = remarks.conclude();
        assert!(found.len() <= MOST_KINDS + 21, "{}", found.len());
        assert_eq!(found.iter().map(|remark| remark.count).sum::<u64>(), 5000);
    }
}
