//! Fields of the language: names, an example of each, and other words that people use for them.

use crate::suggest::nearest;

/// A field of the language.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Field {
    /// Name in the declaration.
    pub(crate) name: &'static str,
    /// The field as it is written.
    pub(crate) example: &'static str,
    /// Words that manuals, data sheets and other programs use for it.
    others: &'static [&'static str],
}

/// Fields in the order of the documentation.
pub(crate) const FIELDS: [Field; 12] = [
    Field {
        name: "chain",
        example: "chain: C B | X Y Z;",
        others: &["kinematics", "order", "structure", "configuration", "machine", "layout"],
    },
    Field {
        name: "d",
        example: "d = (0, 0, 150.0);",
        others: &["offset", "offsets", "pivot", "pivots", "point", "points", "center", "centre", "centers", "centres"],
    },
    Field {
        name: "signs",
        example: "signs = { C: - };",
        others: &["polarity", "invert", "inverted", "reverse", "reversed", "sense"],
    },
    Field {
        name: "axes",
        example: "axes = { B: Rx(-45 deg) * Y };",
        others: &["axis", "direction", "directions", "vectors", "orientation"],
    },
    Field {
        name: "dims",
        example: "dims = { height: 150.0 };",
        others: &["dim", "dimension", "dimensions", "parameters", "params", "constants", "lengths"],
    },
    Field {
        name: "tool_axis",
        example: "tool_axis = (0, 0, 1);",
        others: &["tool", "tool_direction", "tool_vector", "spindle", "spindle_axis"],
    },
    Field { name: "up", example: "up = Y;", others: &["vertical", "upwards"] },
    Field { name: "hold", example: "hold = { W: 0 };", others: &["held", "fixed", "locked", "clamped", "manual"] },
    Field {
        name: "limits",
        example: "limits = { B: -5..110, C: free };",
        others: &["travel", "travels", "range", "ranges", "stroke", "strokes", "reach"],
    },
    Field {
        name: "speeds",
        example: "speeds = { B: 3600, X: 30000 };",
        others: &["velocity", "velocities", "rapid", "rapids", "max_speed", "max_speeds", "feeds"],
    },
    Field { name: "crate", example: "crate = ::my_runtime;", others: &["runtime"] },
    Field {
        name: "verify",
        example: "verify \"paper, eqs. (1)-(5)\" { i = sin(B) * cos(C); }",
        others: &["equations", "proof", "prove", "check", "formulas"],
    },
];

/// The field with this name.
pub(crate) fn field_named(name: &str) -> Option<Field> {
    FIELDS.into_iter().find(|field| field.name == name)
}

/// The field that another word probably means.
pub(crate) fn field_meant(word: &str) -> Option<Field> {
    let lower = word.to_lowercase();
    let synonym = FIELDS.into_iter().find(|field| field.name == lower || field.others.contains(&lower.as_str()));
    synonym.or_else(|| nearest(word, FIELDS.map(|field| field.name)).and_then(field_named))
}

/// All names.
pub(crate) fn list_of_fields() -> String {
    FIELDS.map(|field| format!("`{}`", field.name)).join(", ")
}
