//! Codes of diagnostics and findings: what a program that reads the messages may rely on.
//!
//! A code is a class of messages with one meaning and one kind of remedy; wording and numbers of a message may change,
//! its code does not. All codes are in the table below, by the stage that reports them.

use std::fmt::{self, Debug, Display, Formatter};

/// Stable name of a class of messages, such as `cl/unknown-word`: the stage and the subject.
///
/// The page *Codes of the messages* of the book lists all of them.
#[derive(Clone, Copy, PartialEq, Eq)]
pub struct Code(&'static CodeRow);

#[derive(PartialEq, Eq)]
struct CodeRow {
    name: &'static str,
    meaning: &'static str,
}

impl Code {
    /// Name in messages as JSON: stage and subject.
    #[must_use]
    pub const fn name(self) -> &'static str {
        self.0.name
    }

    /// Meaning in one line.
    #[must_use]
    pub const fn meaning(self) -> &'static str {
        self.0.meaning
    }

    /// All codes, stage by stage.
    #[must_use]
    pub const fn all() -> &'static [Self] {
        TABLE
    }
}

impl Debug for Code {
    fn fmt(&self, out: &mut Formatter<'_>) -> fmt::Result {
        Display::fmt(self, out)
    }
}

impl Display for Code {
    fn fmt(&self, out: &mut Formatter<'_>) -> fmt::Result {
        out.write_str(self.name())
    }
}

/// The codes: for each stage a module of constants, each with the subject as in the name, and its meaning.
macro_rules! codes {
    ($($stage:ident { $($code:ident $subject:literal $meaning:literal)+ })+) => {
        $(
            pub(crate) mod $stage {
                use super::{Code, CodeRow};

                $(
                    #[doc = $meaning]
                    pub(crate) const $code: Code =
                        Code(&CodeRow { name: concat!(stringify!($stage), "/", $subject), meaning: $meaning });
                )+
            }
        )+

        const TABLE: &[Code] = &[$($($stage::$code),+),+];
    };
}

codes! {
    run {
        ARGUMENT "argument" "an argument of the command line, or what it asks for, cannot be carried out"
        READ "read" "a file cannot be read, or has changed while it was read"
        WRITE "write" "a file cannot be written, or would overwrite another file of the run"
    }
    config {
        SYNTAX "syntax" "the configuration is not TOML"
        UNKNOWN_KEY "unknown-key" "no option has this key"
        VALUE "value" "the value of a key is of another kind, outside its range, or not possible for this machine"
        MISSING "missing" "a key is missing that another key or the machine needs"
        CONFLICT "conflict" "two keys contradict each other"
        SET_UP "set-up" "a set-up of the configuration does not begin in the CL data, or one is not configured"
        OPERATION "operation" "an entry for operations is for no operation of the CL data, or contradicts another one"
        PART_ORIGIN "part-origin" "the place of the part on a table that rotates is not configured"
        DIMENSIONS "dimensions" "the dimensions of the machine are invalid"
    }
    control {
        UNFIT "unfit" "control or machine cannot do what the configuration asks for"
    }
    cl {
        FILE "file" "the file is no CL data, or is incomplete"
        UNKNOWN_WORD "unknown-word" "a word is in no table of CL data, or a statement of the shop is not configured"
        REFUSED "refused" "a known word is refused, because its effect on the program is unknown"
        UNSUPPORTED "unsupported" "a form of a record that is not supported"
        TURNING "turning" "the record belongs to turning"
        SYNTAX "syntax" "the form of a statement is wrong: slash, comma, quote, `$`, number of arguments"
        NUMBER "number" "an argument is not the number that is needed"
        UNITS "units" "the unit of the file is unknown or contradictory"
        FRAME "frame" "the frame of the points or a transformation is unknown, invalid or ambiguous"
        TOOL_AXIS "tool-axis" "the tool axis is no unit vector, or contradictory"
        POSITION "position" "a record needs a position or a clearance plane before it"
        ARC "arc" "the data of an arc or a curve is incomplete or contradictory"
        HOLE "hole" "the data of a cycle is incomplete or contradictory"
        TOOL "tool" "the data of a tool or its call is invalid"
        TOOL_NUMBER "tool-number" "one number belongs to two tools, or the number of a tool is ambiguous"
        CUTTER_COMPENSATION "cutter-compensation" "CUTCOM is incomplete or contradictory"
        SPINDLE "spindle" "the data of the spindle is invalid or contradictory"
        FEED "feed" "the feed is invalid or not plausible"
        VALUE "value" "a dwell, a tolerance or a pressure is invalid, unusual or not stated"
        NC_TEXT "nc-text" "NC text or codes in the CL data, whose effect on the machine is unknown"
        SUBPROGRAM "subprogram" "a subprogram of the CL data is invalid, or is written in full"
    }
    plan {
        LIMITS "limits" "an axis would leave its travel"
        REACH "reach" "the machine cannot reach the tool axis"
        INDEXING "indexing" "an indexed axis would have to rotate in a cut, or between its steps"
        TOOL_AXIS "tool-axis" "every tool axis points into the table, or its rotation is undefined"
        POLE "pole" "a rotary axis would rotate on the spot, or the tool axis comes too near to the pole"
        COURSE "course" "the rotary axes cannot take the course or the sense of rotation that is required"
        REWIND "rewind" "the rotary axes are rewound, or cannot be"
        MODE "mode" "the mode of the operation cannot make this motion, or the control cannot enter it"
        TOLERANCE "tolerance" "the tolerance cannot be kept, or exceeds that of the configuration"
        WORD "word" "a value is too large or too small for its word"
        DEPTH "depth" "the tool tip would move below `floor`, or at rapid below the lowest cut of its operation"
        RETRACT "retract" "the retract is missing, too low, or not possible"
        APPROACH "approach" "the approach to an operation is not possible, or differs from the CL data"
        ARC "arc" "an arc or a curve cannot be written within tolerance"
        HOLE "hole" "a hole or thread cannot be made as programmed"
        CUTTER_COMPENSATION "cutter-compensation" "cutter compensation by the control is not possible here"
        FEED "feed" "the feed is missing, too large, or too small for its word"
        SPINDLE "spindle" "the spindle is off, or its speed or sense is missing, too large, or wrong for the tool"
        COOLANT "coolant" "the control has no code for this coolant"
        TOOL "tool" "a tool is not called, or its name, register or place of measuring does not suit"
        TOOL_LENGTH "tool-length" "the gauge length of the tool is needed and unknown"
        BLOCK_SKIP "block-skip" "OPSKIP skips nothing, or skips what the control must execute"
        NC_TEXT "nc-text" "NC text or a statement of the shop cannot be written here"
        PROBE "probe" "the probe cannot measure here"
        MACHINE "machine" "the CL data was made for another machine"
        INTERNAL "internal" "a fault of the postprocessor: report it"
    }
    check {
        WORD "word" "a word, code or line of the program that its control does not permit or understand"
        STATE "state" "the modal state differs from that required: tool, offsets, spindle, coolant, plane, modes"
        PATH "path" "a motion leaves the path or the tool axis of the CL data"
        FEED "feed" "the feed of a block, or a rapid in its place, differs from the CL data"
        LIMITS "limits" "a motion leaves the travel of an axis"
        ORDER "order" "a block or restart point comes where it must not come, or the CL data has nothing for it"
        MISSING "missing" "a block is missing that the CL data or the safe sequence requires"
        SEQUENCE "sequence" "retract, rotation or approach between two cuts are incomplete, in another order, or unsafe"
        GUARD "guard" "a guard of tool length, radius, offset or plane is missing, wrong, or in another place"
        CLAMP "clamp" "the clamps of the rotary axes are open or closed against the motion"
        HOLE "hole" "a hole or thread differs from the CL data"
        CUTTER_COMPENSATION "cutter-compensation" "the path offset by the control differs from the CL data"
        TOOL "tool" "a tool is called or selected that the CL data does not call here"
        STOP "stop" "a stop, a dwell or the end differs from the CL data"
        BLOCK_SKIP "block-skip" "a block is skipped or executed against OPSKIP"
        PROBE "probe" "a probe or a tool check measures in an unsafe state"
        SHOP_LINE "shop-line" "a line of the configuration is missing, incomplete, or in another place"
        TEXT "text" "a text for the operator differs from the CL data"
        EDIT "edit" "an edit of the program that is not permitted"
    }
    simulate {
        CONTACT "contact" "two bodies meet, or the tool is in the stock where it must not cut"
        TOOL_TABLE "tool-table" "a tool has another size in the tool table of the machine than it was posted with"
        GOUGE "gouge" "the machined part differs from the design"
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    #[test]
    fn a_name_is_stage_and_subject_in_small_letters_and_names_one_code() {
        let names: BTreeSet<&str> = Code::all().iter().map(|code| code.name()).collect();
        assert_eq!(names.len(), Code::all().len());
        let permitted = |letter: char| letter.is_ascii_lowercase() || letter == '-';
        for code in Code::all() {
            let (stage, subject) = code.name().split_once('/').expect("stage and subject");
            assert!([stage, subject].iter().all(|part| !part.is_empty() && part.chars().all(permitted)), "{code}");
            assert!(!code.meaning().is_empty() && !code.meaning().ends_with('.'), "{code}");
        }
    }
}
