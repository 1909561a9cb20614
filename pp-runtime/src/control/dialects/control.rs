//! The interface of a control: its table, and hooks where tables end.

use std::ops::RangeInclusive;

use crate::program::Units;

use super::spellings::Spellings;

/// A CNC: its spellings, and what tables cannot hold.
pub trait Control: Sync {
    /// The codes.
    fn spellings(&self) -> &'static Spellings;

    /// Appends one comment line to `line`, made safe: whatever the text holds, the control does not act on it.
    fn comment(&self, text: &[u8], line: &mut Vec<u8>) {
        self.plain_comment(text, line);
    }

    /// A comment whose text is no command to the control.
    fn plain_comment(&self, text: &[u8], line: &mut Vec<u8>) {
        let comment = &self.spellings().comment;
        line.extend_from_slice(comment.marks[0].as_bytes());
        line.extend(text.iter().map(|&byte| (comment.byte)(byte)));
        line.extend_from_slice(comment.marks[1].as_bytes());
    }

    /// The byte that is written for one of the name of an operation, where that is no comment.
    fn message(&self, byte: u8) -> u8 {
        (self.spellings().comment.byte)(byte)
    }

    /// How a work offset of the configuration is written; `None` if the control does not have it.
    fn work_offset(&self, word: &str) -> Option<String>;

    /// The letters before the number of an axis of this name; `None` if the control cannot have an axis of this name.
    fn axis_word(&self, name: &str) -> Option<String> {
        (name.len() == 1 && name.as_bytes()[0].is_ascii_uppercase()).then(|| name.to_owned())
    }

    /// Lines before everything else with the name of the program's file, where the configuration asks for them; none where
    /// the control knows no such lines. `name`: capitals, digits and `_`.
    fn file_header(&self, _name: &str) -> Vec<String> {
        Vec::new()
    }

    /// Lines with the box of the blank for the graphics of the control; corners as words X Y Z.
    fn blank(&self, _lower: &str, _upper: &str) -> Vec<String> {
        Vec::new()
    }

    /// Blocks that stop the program with a message where the length of the tool in the spindle, as the control has it,
    /// differs from the posted one by more than a tolerance. None where a control cannot compare.
    fn length_guard(&self, guard: &LengthGuard) -> Vec<String>;
}

/// The length of a tool that is to be compared with the control's own.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LengthGuard {
    /// A number that occurs once in a program.
    pub label: u32,
    /// The tool in the spindle.
    pub tool: u32,
    /// Its length offset.
    pub offset: u32,
    /// Posted gauge length, mm.
    pub length_mm: f64,
    /// Largest difference, mm.
    pub tolerance_mm: f64,
    /// Unit of the program.
    pub units: Units,
}

impl LengthGuard {
    /// Length and tolerance in the unit of the program, as they are written.
    pub(crate) fn in_program(&self) -> [f64; 2] {
        let places = if self.units == Units::Inches { 1e5 } else { 1e4 };
        [self.length_mm, self.tolerance_mm].map(|mm| (mm / self.units.in_mm() * places).round() / places)
    }

    /// The same in millimetres, whatever the unit of the program.
    pub(crate) fn in_millimetres(&self) -> [f64; 2] {
        Self { units: Units::Millimetres, ..*self }.in_program()
    }
}

/// Whether a word is a prefix and a number of a range, written as people write it.
pub(crate) fn numbered(word: &str, prefix: &str, range: RangeInclusive<u32>) -> bool {
    let number = word.strip_prefix(prefix).and_then(|number| Some((number, number.parse::<u32>().ok()?)));
    number.is_some_and(|(text, number)| range.contains(&number) && number.to_string() == text)
}
