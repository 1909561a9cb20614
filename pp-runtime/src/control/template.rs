//! Blocks with named fields: `T{tool} M6`.
//!
//! The tables of the controls and the blocks of a configuration are templates. A word whose field has no value is left
//! out. A block with `{next}` is left out as a whole where no tool follows.
//!
//! ```
//! use pp_runtime::control::template::{BadTemplate, Field, check};
//!
//! assert_eq!(check("T{tool} M6", &[Field::Tool]), Ok(()));
//! assert_eq!(check("T{tol} M6", &[Field::Tool]), Err(BadTemplate::Field("tol".to_owned())));
//! ```

use std::fmt;

/// Table of the fields: meaning, and name in braces.
macro_rules! fields {
    ($($(#[$doc:meta])* $field:ident = $name:literal,)*) => {
        /// Field of a template.
        #[derive(Debug, Clone, Copy, PartialEq, Eq)]
        pub enum Field {
            $($(#[$doc])* $field,)*
        }

        impl Field {
            const ALL: &[Self] = &[$(Self::$field),*];

            /// Name in braces.
            #[must_use]
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$field => $name,)*
                }
            }
        }
    };
}

fields! {
    /// Name of the program, in the characters of the control.
    Name = "name",
    /// Number of the program, with leading zeros.
    Number = "number",
    /// Code or word of the unit of length.
    Units = "units",
    /// Work offset in the code of the control.
    WorkOffset = "work_offset",
    /// Path tolerance of the control, in the unit of the program.
    PathTolerance = "path_tolerance",
    /// The tool as the control calls it: its number, or its name.
    Tool = "tool",
    /// Number of the tool.
    ToolNumber = "tool_number",
    /// Number of the next tool.
    Next = "next",
    /// Length offset of the tool.
    Offset = "offset",
    /// Register of the cutter radius.
    Radius = "radius",
    /// Delta of the tool radius, which takes the radius off where the path is that of the tool centre.
    RadiusDelta = "radius_delta",
    /// Spindle speed, rev/min.
    Speed = "speed",
    /// Dwell, s.
    Seconds = "seconds",
    /// Dwell, ms.
    Milliseconds = "milliseconds",
    /// Largest deviation of the tool axis while the control smooths, degrees.
    Angle = "angle",
    /// Number of the level of smoothing.
    SmoothingLevel = "smoothing_level",
    /// Code that switches shortest-path rotation of rotary axes on or off.
    RotaryPath = "rotary_path",
    /// Motion of the tool axis under tip control.
    Posture = "posture",
    /// First angle of a tilted plane, in the order of the control.
    First = "first",
    /// Second angle of a tilted plane.
    Second = "second",
    /// Third angle of a tilted plane.
    Third = "third",
    /// Pose of the rotary axes in a tilted plane.
    Pose = "pose",
    /// Name of the swivel data, in quotation marks.
    SwivelData = "swivel_data",
    /// Top of a hole, as a value of Z.
    Surface = "surface",
    /// Distance from the top of a hole up to the level where feed begins.
    Clearance = "clearance",
    /// Bottom of a hole, as a value of Z.
    Bottom = "bottom",
    /// Distance from the top of a hole to its bottom, negative.
    Depth = "depth",
    /// Return level after a hole, as a value of Z.
    Back = "back",
    /// Distance from the top of a hole up to the return level.
    Higher = "higher",
    /// Depth of one step (peck) of a hole.
    Step = "step",
    /// Number of steps.
    Steps = "steps",
    /// Retract that breaks the chip, or distance above the last depth at which feed begins again after a full retract.
    Gap = "gap",
    /// Feed in a hole.
    Feed = "feed",
    /// Pitch of a thread, negative for a left-hand one.
    Pitch = "pitch",
    /// Unit of the pitch: 1 for millimetres, 3 for inches.
    PitchUnit = "pitch_unit",
    /// Sense of rotation of the spindle: 3 or 4, as in M3 and M4.
    Rotation = "rotation",
    /// Shift along X off the wall of a bore.
    ShiftX = "shift_x",
    /// Shift along Y off the wall of a bore.
    ShiftY = "shift_y",
    /// Direction off the wall of a bore: 1 -X, 2 -Y, 3 +X, 4 +Y.
    Quadrant = "quadrant",
    /// Angle at which the spindle stops, degrees.
    Orient = "orient",
}

/// Fields that have a value in the whole program.
pub(crate) const OF_PROGRAM: &[Field] =
    &[Field::Name, Field::Number, Field::Units, Field::WorkOffset, Field::PathTolerance];

/// Fields that have a value in a tool change.
pub(crate) const OF_TOOL: &[Field] = &[
    Field::Name,
    Field::Number,
    Field::Units,
    Field::WorkOffset,
    Field::PathTolerance,
    Field::Tool,
    Field::ToolNumber,
    Field::Next,
    Field::Offset,
    Field::Speed,
    Field::RadiusDelta,
];

/// Fields that have a value in a hole cycle.
#[cfg(test)]
pub(crate) const OF_CYCLE: &[Field] = &[
    Field::Surface,
    Field::Clearance,
    Field::Bottom,
    Field::Depth,
    Field::Back,
    Field::Higher,
    Field::Step,
    Field::Steps,
    Field::Gap,
    Field::Feed,
    Field::Pitch,
    Field::PitchUnit,
    Field::Rotation,
    Field::ShiftX,
    Field::ShiftY,
    Field::Quadrant,
    Field::Orient,
    Field::Seconds,
    Field::Speed,
];

/// Error in a template.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum BadTemplate {
    /// An opening brace without a closing one, or the reverse.
    Brace,
    /// A field that does not exist or has no value in this block.
    Field(String),
}

impl fmt::Display for BadTemplate {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Brace => write!(out, "unmatched brace"),
            Self::Field(name) => write!(out, "`{{{name}}}` is not a field of this block"),
        }
    }
}

/// The first field of a text: text before it, name, text after it.
fn split(text: &str) -> Option<(&str, &str, &str)> {
    let (before, rest) = text.split_once('{')?;
    let (name, after) = rest.split_once('}')?;
    Some((before, name, after))
}

/// Checks that a text is a template with no other fields than `allowed`.
///
/// # Errors
/// The first error of the text.
pub fn check(text: &str, allowed: &[Field]) -> Result<(), BadTemplate> {
    let mut rest = text;
    while let Some((before, name, after)) = split(rest) {
        if before.contains('}') || name.contains('{') {
            return Err(BadTemplate::Brace);
        }
        if !allowed.iter().any(|field| field.name() == name) {
            return Err(BadTemplate::Field(name.to_owned()));
        }
        rest = after;
    }
    if rest.contains(['{', '}']) { Err(BadTemplate::Brace) } else { Ok(()) }
}

/// The block of a template; `None` if no word of it is left, or it has `{next}` and no tool follows. A block may have
/// several lines.
pub(crate) fn fill(text: &str, value: impl Fn(Field) -> Option<String>) -> Option<String> {
    if !text.contains('\n') {
        return fill_line(text, &value);
    }
    let lines: Option<Vec<String>> = text.split('\n').map(|line| fill_line(line, &value)).collect();
    lines.map(|lines| lines.join("\n"))
}

fn fill_line(text: &str, value: &impl Fn(Field) -> Option<String>) -> Option<String> {
    let mut words = Vec::new();
    for word in text.split(' ') {
        let (mut rest, mut written) = (word, String::new());
        let mut missing = false;
        while let Some((before, name, after)) = split(rest) {
            written.push_str(before);
            let field = Field::ALL.iter().copied().find(|field| field.name() == name);
            match field.and_then(value).filter(|value| !value.is_empty()) {
                // A name is assigned to an address, `T="MILL 10"`; elsewhere it is the text alone, `L9001("MILL 10")`.
                Some(value) if !written.ends_with(|byte: char| byte.is_ascii_alphanumeric()) => {
                    written.push_str(value.strip_prefix('=').unwrap_or(&value));
                }
                Some(value) => written.push_str(&value),
                None if field == Some(Field::Next) => return None,
                None => missing = true,
            }
            rest = after;
        }
        if !missing {
            written.push_str(rest);
            words.push(written);
        }
    }
    Some(words.join(" ")).filter(|block| !block.trim().is_empty())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn filled(text: &str, tool: Option<u32>, speed: Option<u32>) -> Option<String> {
        fill(text, |field| match field {
            Field::Tool | Field::Next => tool.map(|tool| tool.to_string()),
            Field::Speed => speed.map(|speed| speed.to_string()),
            _ => None,
        })
    }

    #[test]
    fn a_word_without_value_is_left_out_and_so_is_a_block_of_such_words() {
        assert_eq!(filled("TOOL CALL {tool} Z S{speed}", Some(5), Some(900)).as_deref(), Some("TOOL CALL 5 Z S900"));
        assert_eq!(filled("TOOL CALL {tool} Z S{speed}", Some(5), None).as_deref(), Some("TOOL CALL 5 Z"));
        assert_eq!(filled("S{speed} M3", None, None).as_deref(), Some("M3"));
        assert_eq!(filled("S{speed}", None, None), None);
    }

    #[test]
    fn a_block_with_the_next_tool_is_left_out_without_one() {
        assert_eq!(filled("TOOL DEF {next}", Some(6), None).as_deref(), Some("TOOL DEF 6"));
        assert_eq!(filled("TOOL DEF {next}", None, None), None);
    }

    #[test]
    fn a_name_is_assigned_to_an_address_and_stands_alone_elsewhere() {
        let called = |text: &str| fill(text, |_| Some("=\"MILL 10\"".to_owned())).expect("a block");
        assert_eq!(called("T{tool} D1"), "T=\"MILL 10\" D1");
        assert_eq!(called("T={tool} D1"), "T=\"MILL 10\" D1");
        assert_eq!(called("L9001({tool},1)"), "L9001(\"MILL 10\",1)");
        assert_eq!(called("CHANGE {tool}"), "CHANGE \"MILL 10\"");
    }

    #[test]
    fn blanks_of_a_block_stay() {
        assert_eq!(filled("  Q1=+{tool}  ;A", Some(3), None).as_deref(), Some("  Q1=+3  ;A"));
    }

    #[test]
    fn an_unknown_field_and_an_unmatched_brace_are_found() {
        assert_eq!(check("T{tool} M6", OF_TOOL), Ok(()));
        assert_eq!(check("T{tol} M6", OF_TOOL), Err(BadTemplate::Field("tol".into())));
        assert_eq!(check("T{tool} M6", OF_PROGRAM), Err(BadTemplate::Field("tool".into())));
        for text in ["T{tool", "T}", "{a{tool}}", "}{tool}", "{tool}}"] {
            assert!(check(text, OF_TOOL).is_err(), "{text}");
        }
    }
}
