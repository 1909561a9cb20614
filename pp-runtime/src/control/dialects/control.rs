//! Interface of a control: its table, and methods for what no table can hold.

use std::ops::RangeInclusive;

use crate::program::Units;

use super::spellings::Spellings;

/// A CNC control: its table of codes, and methods for what no table can hold.
pub trait Control: Sync {
    /// Table of the codes.
    fn spellings(&self) -> &'static Spellings;

    /// Appends one comment line to `line`. Characters are replaced so that the control never executes the text.
    fn comment(&self, text: &[u8], line: &mut Vec<u8>) {
        self.plain_comment(text, line);
    }

    /// Appends a comment whose text the control does not read as a command.
    fn plain_comment(&self, text: &[u8], line: &mut Vec<u8>) {
        let comment = &self.spellings().comment;
        line.extend_from_slice(comment.marks[0].as_bytes());
        line.extend(text.iter().map(|&byte| (comment.byte)(byte)));
        line.extend_from_slice(comment.marks[1].as_bytes());
    }

    /// Byte written for a byte of an operation name, where the name is not written as a comment.
    fn message(&self, byte: u8) -> u8 {
        (self.spellings().comment.byte)(byte)
    }

    /// Code of a work offset of the configuration; `None` if the control does not have this work offset.
    fn work_offset(&self, word: &str) -> Option<String>;

    /// Letters before the number in words of an axis; `None` if the control permits no axis of this name.
    fn axis_word(&self, name: &str) -> Option<String> {
        (name.len() == 1 && name.as_bytes()[0].is_ascii_uppercase()).then(|| name.to_owned())
    }

    /// First lines of the file, with the name of the program, for `file_header = true`; empty if the control has no
    /// such lines. `name`: capitals, digits and `_`.
    fn file_header(&self, _name: &str) -> Vec<String> {
        Vec::new()
    }

    /// Lines that define the box of the blank for the graphics of the control. `lower`, `upper`: corners as words X Y
    /// Z.
    fn blank(&self, _lower: &str, _upper: &str) -> Vec<String> {
        Vec::new()
    }

    /// Blocks that compare the tool length of the control with the posted length, and stop the program with a message
    /// if they differ by more than the tolerance. Empty if the control cannot compare them.
    fn length_guard(&self, guard: &LengthGuard) -> Vec<String>;

    /// Blocks that stop the program with a message if the radius of the tool is larger than its wear can be. Empty if the
    /// control cannot compare it.
    fn radius_guard(&self, _guard: &RadiusGuard) -> Vec<String> {
        Vec::new()
    }

    /// Blocks that stop the program with a message if a rotary axis is not at its position, apart from whole turns, after the
    /// control has tilted a plane. Empty if the control cannot compare them.
    fn plane_guard(&self, _guard: &PlaneGuard) -> Vec<String> {
        Vec::new()
    }

    /// Whether [`plane_guard`](Self::plane_guard) has blocks.
    fn compares_rotary_positions(&self) -> bool {
        !self.plane_guard(&PlaneGuard { label: 1, axes: vec![("C".to_owned(), 0.0)] }).is_empty()
    }
}

/// Radius of a tool that must be wear only, because the path is that of the tool centre.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RadiusGuard {
    /// Number of the tool in the spindle.
    pub tool: u32,
    /// Largest wear, mm.
    pub largest_wear_mm: f64,
    /// Unit of the program.
    pub units: Units,
}

impl RadiusGuard {
    /// Largest wear in the unit of the program, rounded as it is written.
    pub(crate) fn in_program(&self) -> f64 {
        let places = if self.units == Units::Inches { 1e5 } else { 1e4 };
        (self.largest_wear_mm / self.units.in_mm() * places).round() / places
    }
}

/// Positions of rotary axes, to be compared after the control has tilted a plane.
#[derive(Debug, Clone, PartialEq)]
pub struct PlaneGuard {
    /// Number that occurs once among the plane guards of the program, for labels.
    pub label: u32,
    /// Name of each axis in the control, and its position, degrees.
    pub axes: Vec<(String, f64)>,
}

impl PlaneGuard {
    /// Largest sum of |sin(d/2)| over the differences d of all axes: 0.1 degrees for one axis alone. The control computes the
    /// positions from rounded angles; another solution is farther away.
    pub(crate) const LARGEST: f64 = 0.0009;

    /// `B30 C-20.5`.
    pub(crate) fn positions(&self) -> String {
        let words: Vec<String> = self.axes.iter().map(|(name, degrees)| format!("{name}{degrees}")).collect();
        words.join(" ")
    }

    /// A number with the sign of its subtraction: `-30`, `+20.5`.
    pub(crate) fn subtracted(degrees: f64) -> String {
        format!("{}{}", if degrees < 0.0 { '+' } else { '-' }, degrees.abs())
    }
}

/// Posted length of a tool, to be compared with the length that the control has for it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LengthGuard {
    /// Number that occurs once in the program, for labels.
    pub label: u32,
    /// Number of the tool in the spindle.
    pub tool: u32,
    /// Number of its length offset.
    pub offset: u32,
    /// Posted gauge length, mm.
    pub length_mm: f64,
    /// Largest permitted difference, mm.
    pub tolerance_mm: f64,
    /// Unit of the program.
    pub units: Units,
}

impl LengthGuard {
    /// Length and tolerance in the unit of the program, rounded as they are written.
    pub(crate) fn in_program(&self) -> [f64; 2] {
        let places = if self.units == Units::Inches { 1e5 } else { 1e4 };
        [self.length_mm, self.tolerance_mm].map(|mm| (mm / self.units.in_mm() * places).round() / places)
    }

    /// Length and tolerance in millimetres, whatever the unit of the program.
    pub(crate) fn in_millimetres(&self) -> [f64; 2] {
        Self { units: Units::Millimetres, ..*self }.in_program()
    }
}

/// Whether a word is this prefix followed by a number of this range, without leading zeros or a sign.
pub(crate) fn numbered(word: &str, prefix: &str, range: RangeInclusive<u32>) -> bool {
    let number = word.strip_prefix(prefix).and_then(|number| Some((number, number.parse::<u32>().ok()?)));
    number.is_some_and(|(text, number)| range.contains(&number) && number.to_string() == text)
}
