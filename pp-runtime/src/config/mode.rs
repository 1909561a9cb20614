//! How multi-axis motion is written: axis values, tip coordinates, or coordinates in a tilted plane.

use super::Config;
use super::read::set;
use super::value::{Reader, Section};

/// What the words of a motion say.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Mode {
    /// Where every axis goes: the inverse kinematics is in the program.
    #[default]
    Axes,
    /// Where the tip goes, and the angles of the rotary axes: the control keeps the tip on its path.
    Tcp,
    /// Where the tip goes in a plane that the control tilts; the rotary axes stand still in the cut.
    Plane,
}

impl Mode {
    /// Every mode, and its name on the command line and in a file.
    pub const NAMES: [(&'static str, Self); 3] = [("axes", Self::Axes), ("tcp", Self::Tcp), ("plane", Self::Plane)];

    /// `axes`, `tcp` or `plane`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Axes => "axes",
            Self::Tcp => "tcp",
            Self::Plane => "plane",
        }
    }
}

/// The frame in which a control counts tip coordinates while a rotary table turns under them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TcpFrame {
    /// Fixed to the table as it stands with its rotary axes at zero: the frame of the CL data.
    TableAtZero,
    /// Fixed to the table as it stands where tip control begins.
    TableAtStart,
    /// Standing still while the table turns.
    NotTurning,
}

/// How a control moves the tool axis from one block to the next while it keeps the tip on its path.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum ToolPosture {
    /// Rotary axes move evenly.
    #[default]
    Axes,
    /// The tool axis turns in the plane of its ends.
    Plane,
}

/// How a block of mode `tcp` says where the tool axis goes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TcpWords {
    /// By the angles of the rotary axes.
    Angles,
    /// By the tool axis itself: the control chooses the angles.
    Vectors,
}

const FRAMES: [(&str, TcpFrame); 3] = [
    ("table_at_zero", TcpFrame::TableAtZero),
    ("table_at_start", TcpFrame::TableAtStart),
    ("not_turning", TcpFrame::NotTurning),
];
const POSTURES: [(&str, ToolPosture); 2] = [("axes", ToolPosture::Axes), ("plane", ToolPosture::Plane)];

const WORDS: [(&str, TcpWords); 2] = [("angles", TcpWords::Angles), ("vectors", TcpWords::Vectors)];

impl Config {
    pub(super) fn read_mode(&mut self, r: &mut Reader<'_>, top: &mut Section<'_>) {
        if let Some(value) = self.get(top, "mode") {
            set(&mut self.mode, r.choice(value, &Mode::NAMES));
        }
        if let Some(value) = self.get(top, "tcp_frame") {
            self.tcp_frame = r.choice(value, &FRAMES);
        }
        if let Some(value) = self.get(top, "tcp_words") {
            set(&mut self.tcp_words, r.choice(value, &WORDS));
        }
        if let Some(value) = self.get(top, "tool_posture") {
            set(&mut self.tool_posture, r.choice(value, &POSTURES));
        }
        if let Some(value) = self.get(top, "tcp_confirmed") {
            set(&mut self.tcp_confirmed, r.boolean(value));
        }
    }
}
