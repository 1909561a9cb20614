//! Options of axis words: axis values, tip coordinates or coordinates in a tilted plane, and the words of rotary axes.

use std::collections::BTreeMap;

use super::keys::{CLAMP, ClampCodes, GRID, WRAP, Wrap};
use crate::keys::{OneOf, YesNo, options};

/// Meaning of the words of a program.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Mode {
    /// Chosen for each stretch by the motion of its tool axis: see `StretchMode`.
    #[default]
    Auto,
    /// Axis positions: the inverse kinematics is in the program.
    Axes,
    /// Tip coordinates and rotary angles: the control keeps the tip on its path.
    Tcp,
    /// Tip coordinates in a plane that the control tilts; rotary axes do not move in the cut.
    Plane,
}

impl Mode {
    /// Modes and their names on the command line and in a file.
    pub const NAMES: [(&'static str, Self); 4] =
        [("auto", Self::Auto), ("axes", Self::Axes), ("tcp", Self::Tcp), ("plane", Self::Plane)];

    /// `auto`, `axes`, `tcp` or `plane`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Auto => "auto",
            Self::Axes => StretchMode::Axes.name(),
            Self::Tcp => StretchMode::Tcp.name(),
            Self::Plane => StretchMode::Plane.name(),
        }
    }

    /// Mode of every stretch; `None` where it is chosen for each.
    #[must_use]
    pub const fn of_all(self) -> Option<StretchMode> {
        match self {
            Self::Auto => None,
            Self::Axes => Some(StretchMode::Axes),
            Self::Tcp => Some(StretchMode::Tcp),
            Self::Plane => Some(StretchMode::Plane),
        }
    }
}

/// Meaning of the words of a stretch: the part of an operation between two changes of the tool axis in the air, or the
/// holes of an operation.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Default)]
pub enum StretchMode {
    /// Axis positions.
    #[default]
    Axes,
    /// Tip coordinates under tip control.
    Tcp,
    /// Tip coordinates in a tilted plane.
    Plane,
}

impl StretchMode {
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

/// Frame of tip coordinates while a rotary table rotates.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TcpFrame {
    /// Fixed to the table in its zero position: the frame of the CL data.
    TableAtZero,
    /// Fixed to the table in its position at the start of tip control.
    TableAtStart,
    /// Fixed in the machine; it does not rotate with the table.
    NotTurning,
}

impl TcpFrame {
    const NAMES: [(&'static str, Self); 3] = [
        ("table_at_zero", Self::TableAtZero),
        ("table_at_start", Self::TableAtStart),
        ("not_turning", Self::NotTurning),
    ];
}

/// Motion of the tool axis within a block under tip control.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum ToolPosture {
    /// Rotary angles are interpolated linearly.
    #[default]
    Axes,
    /// The tool axis rotates in the plane of its start and end directions.
    Plane,
}

impl ToolPosture {
    const NAMES: [(&'static str, Self); 2] = [("axes", Self::Axes), ("plane", Self::Plane)];
}

/// Words for the tool axis in a block of mode `tcp`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TcpWords {
    /// Angles of the rotary axes.
    Angles,
    /// Components of the tool axis: the control chooses the angles.
    Vectors,
}

impl TcpWords {
    const NAMES: [(&'static str, Self); 2] = [("angles", Self::Angles), ("vectors", Self::Vectors)];
}

options! {
    /// Tip control, in mode `tcp`.
    pub struct TipOptions {
        /// Frame of tip coordinates while a table rotates: fixed to the table at zero ("table_at_zero") or at the start
        /// of tip control ("table_at_start"), or fixed in the machine ("not_turning"). Fanuc: parameter 19696#5 = 0
        /// is "table_at_start" in the manual, 1 "not_turning"; "table_at_zero" has the same 0, and must be proven.
        ///
        /// Without it: the frame of the control, where it has only one.
        tcp_frame: Option<TcpFrame> = None, key("tcp_frame", OneOf(&TcpFrame::NAMES), "\"table_at_zero\"");
        /// Words of mode "tcp" for the tool axis: "angles" of the rotary axes, or "vectors", for which the control
        /// chooses the angles.
        tcp_words: TcpWords = TcpWords::Angles, key("tcp_words", OneOf(&TcpWords::NAMES));
        /// Motion of the tool axis in a block of mode "tcp": rotary "axes" evenly, or in the "plane" of its start and
        /// end directions.
        tool_posture: ToolPosture = ToolPosture::Axes, key("tool_posture", OneOf(&ToolPosture::NAMES));
        /// Confirms that in mode "tcp" the control accounts for held axes and for linear axes between rotary ones, and
        /// that in modes "tcp" and "plane" entries of `rotary_offset` in the work offset do not move its frame.
        tcp_confirmed: bool = false, key("tcp_confirmed", YesNo);
    }
}

options! {
    /// Words and clamps of rotary axes.
    pub struct RotaryOptions {
        /// Rollover of the words of endless rotary axes: "none" (words count beyond 360), "0..360" or "+-180" (the
        /// control takes the shortest path, on Siemens by DC(..), on Heidenhain by M126), "sign" (0..360, with the
        /// sense of rotation as sign).
        wrap: BTreeMap<char, Wrap> = BTreeMap::new(), key("wrap", WRAP);
        /// Steps of indexed rotary axes (Hirth): they rotate between cuts only, and to multiples of the step only.
        grid: BTreeMap<char, f64> = BTreeMap::new(), key("grid", GRID);
        /// Codes for the clamp of a rotary axis: on where the axis does not move between two approaches, off before it
        /// rotates.
        clamp: BTreeMap<char, ClampCodes> = BTreeMap::new(), key("clamp", CLAMP);
    }
}
