//! How each control spells what the planner asks for: a table of spellings, and hooks where tables end.
//!
//! Controls know steps and words, nothing of CL data, and plan nothing. A new control is a new table in a file of its
//! own and a line in [`CONTROLS`].

mod encoder;
mod linuxcnc;

use crate::program::{Coolant, Rotation};

pub use encoder::{Encoder, Layout};
pub use linuxcnc::LinuxCnc;

/// Every control there is, the default first.
pub const CONTROLS: &[&dyn Control] = &[&LinuxCnc];

/// The control of that name, as on the command line.
#[must_use]
pub fn by_name(name: &str) -> Option<&'static dyn Control> {
    CONTROLS.iter().copied().find(|control| control.spellings().name.eq_ignore_ascii_case(name))
}

/// Codes of a control.
#[derive(Debug, Clone, Copy)]
pub struct Spellings {
    /// Name on the command line.
    pub name: &'static str,
    /// Name for people.
    pub title: &'static str,
    /// Lines before everything else.
    pub opening: &'static [&'static str],
    /// Last block.
    pub end: &'static str,
    /// Longest line the control reads, line end not counted.
    pub line_length: usize,
    /// Lengths in millimetres.
    pub millimetres: &'static str,
    /// Lengths in inches.
    pub inches: &'static str,
    /// Codes of the safety line that cancel whatever may be active: compensation, length offset, cycle; absolute.
    pub cancel: &'static str,
    /// Blending of blocks within a tolerance.
    pub blending: &'static str,
    /// Address of that tolerance.
    pub blending_address: u8,
    /// Feed per minute.
    pub per_minute: &'static str,
    /// Inverse time, F in 1/min.
    pub inverse_time: &'static str,
    /// Rapid.
    pub rapid: &'static str,
    /// Feed.
    pub feed: &'static str,
    /// Prefix of a rapid in machine coordinates.
    pub machine: &'static str,
    /// Tool change behind the T word.
    pub tool_change: &'static str,
    /// Length offset before the H word; causes no motion here.
    pub length: &'static str,
    /// Spindle clockwise and counter-clockwise.
    pub spindle: [&'static str; 2],
    /// Spindle stop.
    pub spindle_off: &'static str,
    /// Coolant off, all kinds.
    pub coolant_off: &'static str,
    /// Flood.
    pub flood: Option<&'static str>,
    /// Mist.
    pub mist: Option<&'static str>,
    /// Through the spindle.
    pub through: Option<&'static str>,
    /// Air.
    pub air: Option<&'static str>,
    /// Stop, and stop where the operator has asked for it.
    pub stop: [&'static str; 2],
    /// Dwell, before the word with the time.
    pub dwell: &'static str,
    /// Address of the dwell time.
    pub dwell_address: u8,
}

impl Spellings {
    /// The code of a kind of coolant; `None` if the control has none for it.
    #[must_use]
    pub fn coolant(&self, coolant: Coolant) -> Option<&'static str> {
        match coolant {
            Coolant::On | Coolant::Flood => self.flood,
            Coolant::Mist => self.mist,
            Coolant::Through => self.through,
            Coolant::Air => self.air,
            Coolant::Off => Some(self.coolant_off),
        }
    }

    /// The code of a sense of rotation.
    #[must_use]
    pub fn rotation(&self, rotation: Rotation) -> &'static str {
        match rotation {
            Rotation::Clockwise => self.spindle[0],
            Rotation::CounterClockwise => self.spindle[1],
        }
    }
}

/// A CNC: its spellings, and what tables cannot say.
pub trait Control: Sync {
    /// The codes.
    fn spellings(&self) -> &'static Spellings;

    /// Appends one comment line to `line`, made safe: whatever the text holds, the control does not act on it.
    fn comment(&self, text: &[u8], line: &mut Vec<u8>);

    /// Most bytes of a comment's text that one line holds.
    fn comment_length(&self) -> usize;

    /// The number in the dwell word.
    fn dwell(&self, seconds: f64) -> f64 {
        seconds
    }

    /// Blocks that stop the program with a message where the length of the tool in the spindle, as the control knows it,
    /// is off the posted one by more than a tolerance, mm; `label` occurs once in a program. None where a control cannot
    /// compare.
    fn length_guard(&self, _label: u32, _tool: u32, _length: f64, _tolerance: f64) -> Vec<String> {
        Vec::new()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_control_is_found_by_its_name_and_only_by_that() {
        assert_eq!(by_name("linuxcnc").map(|control| control.spellings().title), Some("LinuxCNC"));
        assert!(by_name("LinuxCNC").is_some());
        assert!(by_name("linux").is_none());
        assert!(by_name("").is_none());
    }
}
