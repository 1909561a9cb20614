//! One line while it is read: the place in its text, what it has said so far, and what was in force before it.

use super::Vocabulary;
use super::block::{Fault, WorkPlane};
use super::draft::{Draft, fault};
use super::facts::{Facts, Form};
use super::language::Language;
use super::machine::Interpreter;
use super::text::{Cursor, Number, shown, whole};
use crate::program::Units;

/// A line on its way into a draft.
///
/// Vocabulary, language and machine live as long as the program and are only asked; place, draft and faults as long as the
/// line. What a family has to remember from one line to the next is in its own reader.
#[derive(Debug)]
pub(super) struct Line<'a> {
    vocabulary: &'a Vocabulary,
    language: &'static Language,
    facts: &'a Facts,
    machine: &'a Interpreter,
    pub(crate) at: Cursor<'a>,
    pub(crate) draft: &'a mut Draft,
    faults: &'a mut Vec<Fault>,
}

impl<'a> Line<'a> {
    /// A line before its first byte.
    pub(super) fn new(
        text: &'a [u8],
        vocabulary: &'a Vocabulary,
        machine: &'a Interpreter,
        draft: &'a mut Draft,
        faults: &'a mut Vec<Fault>,
    ) -> Self {
        let language = vocabulary.family.language();
        Self { vocabulary, language, facts: machine.facts(), machine, at: Cursor::new(text), draft, faults }
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
        self.faults.get(self.draft.frame_faults).map(|fault| fault.text.as_str())
    }

    /// Takes away its faults except those of its frame.
    pub(super) fn excuse(&mut self) {
        self.faults.truncate(self.draft.frame_faults);
    }

    /// Notes what is wrong at a column, from 0.
    #[cold]
    pub(super) fn fault(&mut self, column: usize, text: impl Into<String>) {
        fault(self.faults, column, text);
    }

    /// Notes a fault that nothing takes away, whatever the user declares for the line.
    #[cold]
    pub(super) fn lasting_fault(&mut self, column: usize, text: impl Into<String>) {
        let fault = Fault { column: column + 1, text: text.into() };
        self.faults.insert(self.draft.frame_faults, fault);
        self.draft.frame_faults += 1;
    }

    /// Takes a block number: the first word of the line.
    pub(super) fn block_number(&mut self, number: Number, column: usize) {
        let point = number.point && !self.facts.block_number_has_point;
        self.draft.number = whole(number).filter(|_| !point && !number.negative).map(u64::from);
        if self.draft.number.is_none() {
            self.fault(column, "block number that is no whole number");
        }
        let mut comment = false;
        let comments = self.facts.form == Form::Letters;
        let is_word = |byte: &u8| {
            let within = comments && (comment || *byte == b'(');
            comment = within && *byte != b')';
            !within && !matches!(byte, b' ' | b'\t' | b'\r')
        };
        if self.at.before(column).iter().any(is_word) {
            self.fault(column, "block number after the first word of its block");
        }
    }

    /// Says that a word stands twice, unless it is the first.
    pub(super) fn once(&mut self, first: bool, word: &[u8], column: usize) {
        if !first {
            self.fault(column, format!("two {} words", shown(word)));
        }
    }

    /// What has been read from a column on.
    pub(super) fn read_from(&self, column: usize) -> &'a [u8] {
        self.at.read_from(column)
    }

    /// Says that what has been read from a column on is not in the language.
    #[cold]
    pub(super) fn unknown(&mut self, column: usize) {
        let text = self.read_from(column);
        self.fault(column, format!("`{}` is not known to the check", shown(text)));
    }

    /// Position of an axis in the chain, by its name in the program.
    pub(super) fn axis(&self, name: &[u8]) -> Option<usize> {
        self.machine.axis_named(name)
    }

    /// Takes the word of I, J or K; `false` if it stands there already.
    pub(super) fn centre(&mut self, letter: u8, value: f64) -> bool {
        let axis = usize::from(letter - b'I');
        let first = self.draft.centre_written & (1 << axis) == 0;
        self.draft.centre[axis] = value;
        self.draft.centre_written |= 1 << axis;
        first
    }

    /// Takes a component of the tool axis, X being 0; `false` if it stands there already.
    pub(super) fn vector(&mut self, axis: usize, value: f64) -> bool {
        let first = self.draft.vector_written & (1 << axis) == 0;
        self.draft.vector[axis] = value;
        self.draft.vector_written |= 1 << axis;
        first
    }

    /// The unit in which the line counts.
    pub(super) fn units(&self) -> Option<Units> {
        self.draft.units.or(self.machine.state().units)
    }

    /// The same, mm.
    pub(super) fn unit(&self) -> f64 {
        self.units().map_or(1.0, Units::in_mm)
    }

    /// Number of a tool that is called by its name.
    pub(super) fn tool_of(&self, name: &[u8]) -> Option<u32> {
        let tools = &self.vocabulary().tools;
        let known = tools.iter().find(|(known, _)| known.as_bytes() == name).map(|(_, number)| *number);
        known.or_else(|| std::str::from_utf8(name).ok()?.parse().ok())
    }

    /// Notes that a tool is called by its name, or by its number.
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

    /// Whether the words of the line are distances.
    pub(super) fn incremental(&self) -> bool {
        self.draft.distances.or(self.machine.state().incremental) == Some(true)
    }

    /// Position of the axis along the normal of the plane in which the line acts.
    pub(super) fn normal(&self) -> Option<usize> {
        let [_, _, normal] = self.draft.plane.or(self.machine.state().plane).map(WorkPlane::axes)?;
        self.machine.linear()[normal]
    }
}
