//! Functions of controls that are options, and effects of lines.

use super::super::template::Field;

/// A function that is an option of controls.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ControlFunction {
    /// Tip control (TCP).
    TipControl,
    /// Tilted work planes.
    Planes,
    /// Dynamic work offset: the zero of the words follows the table.
    DynamicOffset,
    /// Scaling of the coordinates.
    Scaling,
    /// Rotation of the coordinates.
    Rotation,
    /// Polar coordinates.
    Polar,
    /// Compensation of the place of the part (Fanuc: workpiece setting error).
    SettingError,
    /// Smoothing of the path.
    Smoothing,
}

impl ControlFunction {
    pub(crate) const NAMES: [(&'static str, Self); 8] = [
        ("tip_control", Self::TipControl),
        ("planes", Self::Planes),
        ("dynamic_offset", Self::DynamicOffset),
        ("scaling", Self::Scaling),
        ("rotation", Self::Rotation),
        ("polar", Self::Polar),
        ("setting_error", Self::SettingError),
        ("smoothing", Self::Smoothing),
    ];

    /// Name in a file.
    pub(crate) fn name(self) -> &'static str {
        Self::NAMES.iter().find(|(_, function)| *function == self).map_or("", |(name, _)| name)
    }
}

/// Effect of a line or a word that the user brought into the program, for the check.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum LineEffect {
    /// Nothing that the check reads.
    None,
    /// It clamps work, or sets it free. The machine has retracted, with the spindle off; so with a chuck, a pallet and
    /// a door.
    Clamp,
    /// It opens or closes a chuck.
    Chuck,
    /// It opens or closes a door.
    Door,
    /// It changes a pallet; the positions of the axes are unknown afterwards.
    Pallet,
    /// The coolant is unknown afterwards.
    Coolant,
    /// The spindle is unknown afterwards.
    Spindle,
    /// The program stops.
    Stop,
    /// The positions of the axes are unknown afterwards.
    PositionLost,
    /// Positions and modal state are unknown afterwards.
    StateLost,
    /// It measures; the positions of the axes are unknown afterwards.
    Measures,
    /// The tool of its field `{tool}` is in the spindle afterwards, as after the tool change of the control: spindle
    /// off, the positions of the axes unknown. For whole lines only, by their text as configured: `G65 P9001 T{tool}`.
    ToolChange,
}

impl LineEffect {
    pub(crate) const NAMES: [(&'static str, Self); 12] = [
        ("none", Self::None),
        ("clamp", Self::Clamp),
        ("chuck", Self::Chuck),
        ("door", Self::Door),
        ("pallet", Self::Pallet),
        ("coolant", Self::Coolant),
        ("spindle", Self::Spindle),
        ("stop", Self::Stop),
        ("position lost", Self::PositionLost),
        ("state lost", Self::StateLost),
        ("measures", Self::Measures),
        ("tool change", Self::ToolChange),
    ];

    /// Name, as in configuration files.
    pub(crate) fn name(self) -> &'static str {
        Self::NAMES.iter().find(|(_, effect)| *effect == self).map_or("", |(name, _)| name)
    }

    /// Whether the machine retracts and the spindle stops before a line with this effect.
    pub(crate) const fn needs_standstill(self) -> bool {
        matches!(self, Self::Clamp | Self::Chuck | Self::Door | Self::Pallet)
    }

    /// The reason why a line or a word cannot have this effect.
    pub(crate) fn refusal(self, text: &str) -> Option<String> {
        let is_called = text.contains(&format!("{{{}}}", Field::Tool.name()));
        (self == Self::ToolChange && !is_called).then(|| {
            format!(
                "`{text}` has no field {{tool}}: which tool a line with the effect \"tool change\" calls is unknown"
            )
        })
    }
}
