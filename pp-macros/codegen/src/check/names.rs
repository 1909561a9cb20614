//! Names with a meaning of their own.

use crate::model::kind_of;

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
    "tan",
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
    "required",
    "near",
    "in",
    // Reserved since edition 2024.
    "gen",
];

/// True if a name has a meaning in the language.
pub(crate) fn is_reserved(name: &str) -> bool {
    kind_of(name).is_some() || name.starts_with("r#") || RESERVED.contains(&name)
}
