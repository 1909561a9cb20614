//! How each control spells what the planner asks for: a table of spellings, and hooks where tables end.
//!
//! Controls know steps and words, nothing of CL data, and plan nothing. A new control is a new table in a file of its
//! own and a line in [`CONTROLS`].

mod belief;
mod encoder;
mod fanuc;
mod fit;
mod haas;
mod heidenhain;
mod layout;
mod linuxcnc;
mod siemens;
mod spellings;
pub mod template;
#[cfg(test)]
mod tests;

use std::ops::RangeInclusive;

pub use encoder::Encoder;
pub use fanuc::Fanuc;
pub use fit::{abilities, check, starting_point, unsuited};
pub use haas::Haas;
pub use heidenhain::Heidenhain;
pub use layout::Layout;
pub use linuxcnc::LinuxCnc;
pub use siemens::Siemens;
pub use spellings::{Comments, Length, LengthCall, Spellings, Tilting, Tip, Vectors};

/// Every control there is, the default first.
pub const CONTROLS: &[&dyn Control] = &[&LinuxCnc, &Fanuc, &Siemens, &Heidenhain, &Haas];

/// The control of that name, as on the command line.
#[must_use]
pub fn by_name(name: &str) -> Option<&'static dyn Control> {
    CONTROLS.iter().copied().find(|control| control.spellings().name.eq_ignore_ascii_case(name))
}

/// A CNC: its spellings, and what tables cannot say.
pub trait Control: Sync {
    /// The codes.
    fn spellings(&self) -> &'static Spellings;

    /// Appends one comment line to `line`, made safe: whatever the text holds, the control does not act on it.
    fn comment(&self, text: &[u8], line: &mut Vec<u8>) {
        self.plain_comment(text, line);
    }

    /// A comment whose text is no order to the control.
    fn plain_comment(&self, text: &[u8], line: &mut Vec<u8>) {
        let comment = &self.spellings().comment;
        line.extend_from_slice(comment.marks[0].as_bytes());
        line.extend(text.iter().map(|&byte| (comment.byte)(byte)));
        line.extend_from_slice(comment.marks[1].as_bytes());
    }

    /// What becomes of a byte in the name of an operation that is no comment.
    fn message(&self, byte: u8) -> u8 {
        (self.spellings().comment.byte)(byte)
    }

    /// How a work offset of the configuration is written; `None` if the control does not have it.
    fn work_offset(&self, word: &str) -> Option<String>;

    /// What stands before the number of an axis of this name; `None` if the control cannot have an axis of this name.
    fn axis_word(&self, name: &str) -> Option<String> {
        (name.len() == 1 && name.as_bytes()[0].is_ascii_uppercase()).then(|| name.to_owned())
    }

    /// Blocks that stop the program with a message where the length of the tool in the spindle, as the control knows it,
    /// is off the posted one by more than a tolerance, mm; `label` occurs once in a program. None where a control cannot
    /// compare.
    fn length_guard(&self, _label: u32, _tool: u32, _length: f64, _tolerance: f64) -> Vec<String> {
        Vec::new()
    }
}

/// Whether a word is a prefix and a number of a range, written as people write it.
fn numbered(word: &str, prefix: &str, range: RangeInclusive<u32>) -> bool {
    let number = word.strip_prefix(prefix).and_then(|number| Some((number, number.parse::<u32>().ok()?)));
    number.is_some_and(|(text, number)| range.contains(&number) && number.to_string() == text)
}
