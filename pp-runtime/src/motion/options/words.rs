//! What words of a motion say: axis values, tip coordinates or coordinates in a tilted plane, and the words of rotary axes.

use std::collections::BTreeMap;

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

/// Tip control, in mode `tcp`.
#[derive(Debug, Clone, PartialEq)]
pub struct TipOptions {
    /// The frame of tip coordinates; default none: where a control has only one, that one.
    pub tcp_frame: Option<TcpFrame>,
    /// How blocks say where the tool axis goes; default [`TcpWords::Angles`].
    pub tcp_words: TcpWords,
    /// How the control moves the tool axis; default [`ToolPosture::Axes`].
    pub tool_posture: ToolPosture,
    /// The control knows held axes and linear axes between rotary ones; default false.
    pub tcp_confirmed: bool,
}

impl Default for TipOptions {
    fn default() -> Self {
        Self { tcp_frame: None, tcp_words: TcpWords::Angles, tool_posture: ToolPosture::Axes, tcp_confirmed: false }
    }
}

/// Words and clamps of rotary axes.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct RotaryOptions {
    /// How the words of endless axes stay within a turn; default none: they count turns.
    pub wrap: BTreeMap<char, Wrap>,
    /// Steps of indexed axes, rad; default none: they turn continuously.
    pub grid: BTreeMap<char, f64>,
    /// Codes of the clamps; default none.
    pub clamp: BTreeMap<char, ClampCodes>,
}

/// How the words of a rotary axis stay within a turn; without it they show as many turns as there are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Wrap {
    /// From 0 up to 360; the control goes the short way.
    Positive,
    /// Above -180 up to 180; the control goes the short way.
    Symmetric,
    /// From 0 up to 360 with the sense of the motion as sign; a whole turn stands for a zero that is reached backwards.
    Sign,
}

/// What switches the clamp of a rotary axis.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ClampCodes {
    /// The axis is held.
    pub on: String,
    /// It may turn.
    pub off: String,
}
