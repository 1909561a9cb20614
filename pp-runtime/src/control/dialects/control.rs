//! Interface of a control: its table, and methods for what no table can hold.

use std::borrow::Cow;
use std::ops::RangeInclusive;

use crate::program::Units;

use super::functions::LineEffect;
use super::spellings::Spellings;

/// A CNC control: its table of codes, and methods for what no table can hold.
///
/// A control of one's own is based on one of this crate: its table states the differences
/// (`..Fanuc.spellings().clone()`), and every method that it does not have is that of its [`base`](Self::base).
///
/// ```
/// # use std::sync::LazyLock;
/// use pp_runtime::control::{Control, Fanuc, LineEffect, Spellings};
///
/// /// Fanuc with a chip conveyor that stops for the tool change.
/// struct House;
///
/// static CODES: LazyLock<Spellings> = LazyLock::new(|| Spellings {
///     name: "house",
///     title: "House control",
///     tool_change: &["M140", "T{tool} M6", "T{next}"],
///     ..Fanuc.spellings().clone()
/// });
///
/// impl Control for House {
///     fn spellings(&self) -> &'static Spellings {
///         &CODES
///     }
///     fn base(&self) -> Option<&'static dyn Control> {
///         Some(&Fanuc)
///     }
///     fn effects(&self) -> &'static [(&'static str, LineEffect)] {
///         &[("M140", LineEffect::None)]
///     }
/// }
///
/// assert_eq!(House.family(), "fanuc");
/// assert_eq!(House.work_offset("G54.1 P3").as_deref(), Some("G54.1 P3"));
/// ```
pub trait Control: Sync {
    /// Table of the codes.
    fn spellings(&self) -> &'static Spellings;

    /// The control whose methods this one has where it has none of its own, and whose language its programs are read
    /// back in.
    fn base(&self) -> Option<&'static dyn Control> {
        None
    }

    /// Name of the control of this crate in whose language the check reads the programs.
    fn family(&self) -> &'static str {
        self.base().map_or(self.spellings().name, Control::family)
    }

    /// Effects of the lines and words that the [`family`](Self::family) does not have, or has with another meaning; as
    /// in `[control] effects` of the configuration. The check refuses what is neither in the language of the family nor
    /// here.
    ///
    /// A line that changes the tool by a macro has its text as in the table:
    /// `("G65 P9001 T{tool}", LineEffect::ToolChange)`.
    fn effects(&self) -> &'static [(&'static str, LineEffect)] {
        self.base().map_or(&[], Control::effects)
    }

    /// Appends one comment line to `line`. Characters are replaced so that the control never executes the text.
    fn comment(&self, text: &[u8], line: &mut Vec<u8>) {
        let comment = &self.spellings().comment;
        line.extend_from_slice(comment.marks[0].as_bytes());
        line.extend(self.harmless(text).iter().map(|&byte| (comment.byte)(byte)));
        line.extend_from_slice(comment.marks[1].as_bytes());
    }

    /// The text of a comment, changed where the control would read it as a command.
    fn harmless<'a>(&self, text: &'a [u8]) -> Cow<'a, [u8]> {
        self.base().map_or(Cow::Borrowed(text), |base| base.harmless(text))
    }

    /// Byte written for a byte of an operation name, where the name is not written as a comment.
    fn message(&self, byte: u8) -> u8 {
        self.base().map_or_else(|| (self.spellings().comment.byte)(byte), |base| base.message(byte))
    }

    /// Code of a work offset of the configuration; `None` if the control does not have this work offset.
    fn work_offset(&self, word: &str) -> Option<String> {
        self.base()?.work_offset(word)
    }

    /// Letters before the number in words of an axis; `None` if the control permits no axis of this name.
    fn axis_word(&self, name: &str) -> Option<String> {
        match self.base() {
            Some(base) => base.axis_word(name),
            None => (name.len() == 1 && name.as_bytes()[0].is_ascii_uppercase()).then(|| name.to_owned()),
        }
    }

    /// First lines of the file, with the name of the program, for `file_header = true`; empty if the control has no
    /// such lines. `name`: capitals, digits and `_`.
    fn file_header(&self, name: &str) -> Vec<String> {
        self.base().map_or_else(Vec::new, |base| base.file_header(name))
    }

    /// Lines that define the blank for the graphics of the control; empty if the control has none.
    fn blank(&self, blank: &BlankWords) -> Vec<String> {
        self.base().map_or_else(Vec::new, |base| base.blank(blank))
    }

    /// Blocks that compare the tool length of the control with the posted length, and stop the program with a message
    /// if they differ by more than the tolerance. Empty if the control cannot compare them.
    fn length_guard(&self, guard: &LengthGuard) -> Vec<String> {
        self.base().map_or_else(Vec::new, |base| base.length_guard(guard))
    }

    /// Blocks that stop the program with a message if the radius of the tool is larger than its wear can be. Empty if
    /// the control cannot compare it.
    fn radius_guard(&self, guard: &RadiusGuard) -> Vec<String> {
        self.base().map_or_else(Vec::new, |base| base.radius_guard(guard))
    }

    /// Blocks that stop the program with a message if a rotary axis is not at its position, apart from whole turns,
    /// after the control has tilted a plane. Empty if the control cannot compare them.
    fn plane_guard(&self, guard: &PlaneGuard) -> Vec<String> {
        self.base().map_or_else(Vec::new, |base| base.plane_guard(guard))
    }

    /// Blocks that stop the program with a message if a rotation, a scale, a mirror or a shift that lasts lies over the
    /// work offset in force. `label`: a number that occurs once among these guards. Empty if the control cannot compare
    /// them.
    fn offset_guard(&self, label: u32) -> Vec<String> {
        self.base().map_or_else(Vec::new, |base| base.offset_guard(label))
    }

    /// Whether [`plane_guard`](Self::plane_guard) has blocks.
    fn compares_rotary_positions(&self) -> bool {
        !self.plane_guard(&PlaneGuard { label: 1, axes: vec![("C".to_owned(), 0.0)] }).is_empty()
    }
}

/// Numbers of a blank as they are written, in the unit and the coordinates of the program.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct BlankWords {
    /// X, Y and Z of the lower corner.
    pub lower: [String; 3],
    /// X, Y and Z of the upper corner.
    pub upper: [String; 3],
    /// Radius, diameter and height, where it is a cylinder along Z about X0 Y0.
    pub round: Option<[String; 3]>,
    /// It is that of the configuration, not a box around all cuts.
    pub given: bool,
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
