//! Letters of axes, and names with a meaning of their own.

use crate::model::AxisKind;

/// Names that a dimension cannot have.
const RESERVED: &[&str] = &[
    "x",
    "y",
    "z",
    "i",
    "j",
    "k",
    "gauge",
    "part_x",
    "part_y",
    "part_z",
    "part_origin",
    "gauge_length",
    "sin",
    "cos",
    "asin",
    "acos",
    "atan2",
    "sqrt",
    "Rx",
    "Ry",
    "Rz",
    "deg",
    "mm",
    "free",
    "where",
    // Reserved since edition 2024.
    "gen",
];

/// Axis letters.
pub(crate) const LETTERS: [&str; 9] = ["X", "Y", "Z", "U", "V", "W", "A", "B", "C"];

/// Linear or rotary; `None` if it is no axis letter.
pub(crate) fn kind_of(letter: &str) -> Option<AxisKind> {
    let place = LETTERS.iter().position(|known| *known == letter)?;
    Some(if place < 6 { AxisKind::Linear } else { AxisKind::Rotary })
}

/// True if a name has a meaning in the language.
pub(crate) fn is_reserved(name: &str) -> bool {
    LETTERS.contains(&name) || name.starts_with("r#") || RESERVED.contains(&name)
}
