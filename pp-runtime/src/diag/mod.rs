//! Errors and warnings about CL data or a configuration file. They have line and column, not a copy of the
//! source text.
//!
//! ```
//! use pp_runtime::config::Config;
//! use pp_runtime::control::LinuxCnc;
//! use pp_runtime::diag::Severity;
//! # pp_runtime::machine! {
//! #     /// A table that rotates about Z on a table that tilts about X.
//! #     pub struct Trunnion;
//! #     chain: C A | X Y Z;
//! # }
//!
//! let text = "[limits]\nD = [0, 1]\n";
//! let faults = Config::read::<Trunnion>(text, &LinuxCnc).expect_err("the machine has no such axis");
//! assert_eq!(faults[0].severity, Severity::Error);
//! assert_eq!(faults[0].code.name(), "config/unknown-key");
//! let line = text.lines().nth(faults[0].location.line as usize - 1).expect("a line of the text");
//! let column = faults[0].location.column as usize - 1;
//! assert_eq!(&line[column..column + faults[0].length as usize], "D");
//! ```

pub(crate) mod code;

use std::collections::BTreeMap;
use std::error::Error;
use std::fmt::{self, Display, Formatter};
use std::ops::Deref;

use crate::program::Location;

pub use code::Code;

/// Number of diagnostics of one kind that are listed; further ones are counted.
pub(crate) const LISTED_OF_A_KIND: u64 = 20;

/// Largest number of kinds that are counted separately; further kinds share one count. It bounds the memory.
const MOST_KINDS: usize = 1000;

/// Severity of a diagnostic.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Severity {
    /// Posting ends here.
    Error,
    /// Posting goes on; a person should check this place.
    Warning,
}

impl Severity {
    /// Word of a message.
    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::Error => "error",
            Self::Warning => "warning",
        }
    }
}

/// One error or warning, in a machinist's words, with its remedy.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Diagnostic {
    /// Class of the message, whatever its wording and numbers.
    pub code: Code,
    /// Error or warning.
    pub severity: Severity,
    /// Place of the first byte concerned.
    pub location: Location,
    /// Number of bytes concerned, at least 1, within that line.
    pub length: u32,
    /// One sentence, no final stop.
    pub text: String,
    /// Remedy.
    pub help: Option<String>,
    /// Number of diagnostics that this one represents: 1, or all of its kind that are not listed.
    pub count: u64,
}

impl Diagnostic {
    /// Text with every number and every quoted word replaced: equal for diagnostics of one kind.
    pub(crate) fn kind(&self) -> String {
        without_numbers(&self.text, |_| "…")
    }
}

impl Display for Diagnostic {
    /// Line, column, severity and text; the remedy on a line of its own. Without a place the text begins with the
    /// severity.
    fn fmt(&self, out: &mut Formatter<'_>) -> fmt::Result {
        let Location { line, column } = self.location;
        if line > 0 {
            write!(out, "{line}:{column}: ")?;
        }
        write!(out, "{}: {}", self.severity.name(), self.text)?;
        self.help.as_ref().map_or(Ok(()), |help| write!(out, "\nhelp: {help}"))
    }
}

/// All faults of a text, in its order: the error of a function that goes on reading after a fault.
///
/// ```
/// use pp_runtime::config::Config;
/// use pp_runtime::control::LinuxCnc;
/// # pp_runtime::machine! {
/// #     /// A table that rotates about Z on a table that tilts about X.
/// #     pub struct Trunnion;
/// #     chain: C A | X Y Z;
/// # }
///
/// let read = || -> Result<Config, Box<dyn std::error::Error>> { Ok(Config::read::<Trunnion>("tolerance = -1\n",
/// &LinuxCnc)?) }; assert!(read().is_err_and(|faults| faults.to_string().starts_with("1:13: error: ")));
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Diagnostics(pub(crate) Vec<Diagnostic>);

impl Deref for Diagnostics {
    type Target = [Diagnostic];

    fn deref(&self) -> &[Diagnostic] {
        &self.0
    }
}

impl IntoIterator for Diagnostics {
    type Item = Diagnostic;
    type IntoIter = std::vec::IntoIter<Diagnostic>;

    fn into_iter(self) -> Self::IntoIter {
        self.0.into_iter()
    }
}

impl Display for Diagnostics {
    fn fmt(&self, out: &mut Formatter<'_>) -> fmt::Result {
        self.iter().enumerate().try_for_each(|(index, fault)| {
            let before = if index == 0 { "" } else { "\n" };
            write!(out, "{before}{fault}")
        })
    }
}

impl Error for Diagnostics {}

/// A text with every number replaced, and what is quoted in it as `quoted` has it.
pub(crate) fn without_numbers(text: &str, quoted: impl Fn(&str) -> &str) -> String {
    let mut kind = String::new();
    for (index, piece) in text.split('`').enumerate() {
        if index % 2 == 1 {
            kind.push_str(quoted(piece));
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

/// Diagnostics in the order found. The first [`LISTED_OF_A_KIND`] of a kind are listed, further ones are counted: a
/// file with a million of them must not fill the memory.
#[derive(Debug, Default)]
pub(crate) struct Remarks {
    listed: Vec<Diagnostic>,
    /// Number found of each kind, and the first of them that is not listed.
    kinds: BTreeMap<String, (u64, Option<Diagnostic>)>,
}

impl Remarks {
    pub(crate) fn add(&mut self, found: Diagnostic) {
        let mut kind = found.kind();
        if self.kinds.len() >= MOST_KINDS && !self.kinds.contains_key(&kind) {
            kind = "other messages".into();
        }
        let (count, hidden) = self.kinds.entry(kind).or_default();
        *count += 1;
        if *count <= LISTED_OF_A_KIND {
            self.listed.push(found);
        } else {
            hidden.get_or_insert(found);
        }
    }

    /// The listed diagnostics, then one for each kind that has more, with their number.
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

/// A count with its noun: `1 tool`, `2 tools`, `2 stretches`.
pub(crate) fn counted(count: u64, word: &str) -> String {
    let ending = match word.ends_with("ch") {
        _ if count == 1 => "",
        true => "es",
        false => "s",
    };
    format!("{} {word}{ending}", grouped(count))
}

/// Formats a number in groups of three digits: `48 211`.
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
            Diagnostic {
                code: code::cl::ARC,
                severity: Severity::Warning,
                location,
                length: 4,
                text,
                help: None,
                count: 1,
            }
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
