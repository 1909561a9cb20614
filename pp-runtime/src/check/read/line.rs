//! One line while it is read: the place in its text, its words, what it orders, and what was in force before it.

use super::Vocabulary;
use super::block::BlockFault;
use super::facts::{Facts, LineForm};
use super::language::Language;
use super::machine::Interpreter;
use super::orders::{Orders, fault};
use super::text::{Cursor, Number, shown, tenths, whole};
use super::words::{Coded, OpenWords, Word};
use crate::program::Units;

/// A line on its way into orders.
///
/// Vocabulary, language and machine live as long as the program and are only asked; place, words, orders and faults as
/// long as the line. What a family has to remember from one line to the next is in its own reader.
#[derive(Debug)]
pub(super) struct Line<'a> {
    vocabulary: &'a Vocabulary,
    language: &'static Language,
    facts: &'a Facts,
    machine: &'a Interpreter,
    pub(crate) at: Cursor<'a>,
    pub(crate) words: &'a mut OpenWords,
    pub(crate) orders: &'a mut Orders,
    faults: &'a mut Vec<BlockFault>,
}

/// What a line is read into.
#[derive(Debug)]
pub(super) struct LineResult<'a> {
    pub(super) words: &'a mut OpenWords,
    pub(super) orders: &'a mut Orders,
    pub(super) faults: &'a mut Vec<BlockFault>,
}

impl<'a> Line<'a> {
    /// A line before its first byte.
    pub(super) fn new(
        text: &'a [u8],
        vocabulary: &'a Vocabulary,
        machine: &'a Interpreter,
        into: LineResult<'a>,
    ) -> Self {
        let LineResult { words, orders, faults } = into;
        let language = vocabulary.family.language();
        Self { vocabulary, language, facts: machine.facts(), machine, at: Cursor::new(text), words, orders, faults }
    }

    pub(super) fn vocabulary(&self) -> &'a Vocabulary {
        self.vocabulary
    }

    pub(super) fn language(&self) -> &'static Language {
        self.language
    }

    pub(super) fn facts(&self) -> &'a Facts {
        self.facts
    }

    /// The state before the line.
    pub(super) fn machine(&self) -> &'a Interpreter {
        self.machine
    }

    /// Number of its faults.
    pub(super) fn fault_count(&self) -> usize {
        self.faults.len()
    }

    /// The first of its faults that are not of its frame.
    pub(super) fn first_fault(&self) -> Option<&str> {
        self.faults.get(self.orders.frame_faults).map(|fault| fault.text.as_str())
    }

    /// Takes away its faults except those of its frame.
    pub(super) fn excuse(&mut self) {
        self.faults.truncate(self.orders.frame_faults);
    }

    /// Adds a fault at a column, from 0.
    #[cold]
    pub(super) fn fault(&mut self, column: usize, text: impl Into<String>) {
        fault(self.faults, column, text);
    }

    /// Adds a fault that nothing takes away, whatever the user declares for the line.
    #[cold]
    pub(super) fn lasting_fault(&mut self, column: usize, text: impl Into<String>) {
        let fault = BlockFault { column: column + 1, text: text.into() };
        self.faults.insert(self.orders.frame_faults, fault);
        self.orders.frame_faults += 1;
    }

    /// Takes a block number: the first word of the line.
    pub(super) fn block_number(&mut self, number: Number, column: usize) {
        let point = number.point && !self.facts.block_number_has_point;
        let value = whole(number).filter(|_| !point && !number.negative).map(u64::from);
        if value.is_none() {
            self.fault(column, "block number that is no whole number");
        } else if self.orders.number.is_some() {
            self.fault(column, "two N words");
        }
        self.orders.number = value;
        let mut comment = false;
        let comments = self.facts.form == LineForm::Letters;
        let is_word = |byte: &u8| {
            let within = comments && (comment || *byte == b'(');
            comment = within && *byte != b')';
            !within && !matches!(byte, b' ' | b'\t' | b'\r')
        };
        if self.at.before(column).iter().any(is_word) {
            self.fault(column, "block number after the first word of its block");
        }
    }

    /// Adds a word that has been read. It is a fault if the line has it already.
    pub(super) fn word(&mut self, name: &[u8], word: Word) {
        let letter = if let [letter] = name { Some(letter.to_ascii_uppercase()) } else { None };
        self.orders.speaks = true;
        let word = Word { letter, ..word };
        if !self.words.add(word) {
            self.fault(word.column, format!("two {} words", shown(name)));
        }
    }

    /// Adds a code by its letter and number, which has been read from a column on; `false` if the table does not have
    /// it.
    pub(super) fn code(&mut self, letter: u8, number: Number, column: usize) -> bool {
        let Some(number) = tenths(number) else { return false };
        let Some(row) = self.language.code(letter, number) else { return false };
        self.orders.speaks = true;
        self.words.add_code(Coded { row, number, column, end: self.at.column() });
        true
    }

    /// What has been read from a column on.
    pub(super) fn read_from(&self, column: usize) -> &'a [u8] {
        self.at.read_from(column)
    }

    /// Adds the fault that what has been read from a column on is not in the language.
    pub(super) fn unknown(&mut self, column: usize) {
        self.unknown_text(column, self.read_from(column));
    }

    /// Adds the fault that a text at a column is not in the language.
    #[cold]
    pub(super) fn unknown_text(&mut self, column: usize, text: &[u8]) {
        self.orders.unknown = true;
        self.fault(column, format!("`{}` is not known to the check", shown(text)));
    }

    /// Position of an axis in the chain, by its name in the program.
    pub(super) fn axis(&self, name: &[u8]) -> Option<usize> {
        self.machine.axis_named(name)
    }

    /// The unit in which the line counts.
    pub(super) fn units(&self) -> Option<Units> {
        self.orders.units().or(self.machine.state().units)
    }

    /// The unit in which the line counts, mm; 1 where it is unknown.
    pub(super) fn unit(&self) -> f64 {
        self.units().map_or(1.0, Units::in_mm)
    }

    /// Number of a tool that is called by its name.
    pub(super) fn tool_of(&self, name: &[u8]) -> Option<u32> {
        let tools = &self.vocabulary().tools;
        let known = tools.iter().find(|(known, _)| known.as_bytes() == name).map(|(_, number)| *number);
        known.or_else(|| std::str::from_utf8(name).ok()?.parse().ok())
    }

    /// Compares the form of a tool call with that of the configuration: a name, or a number.
    pub(super) fn called(&mut self, by_name: bool, column: usize) {
        match (by_name, self.vocabulary().tools_by_name) {
            (true, false) => self.fault(column, "the tool is called by its name, expected its number"),
            (false, true) => self.fault(column, "the tool is called by its number, expected its name"),
            (true, true) | (false, false) => {}
        }
    }

    /// Whether a tool is in the spindle, as far as the program says.
    pub(super) fn has_tool(&self) -> bool {
        self.machine.state().tool.is_some()
    }
}
