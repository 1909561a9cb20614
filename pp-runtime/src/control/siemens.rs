//! Siemens 840D sl and ONE.
//!
//! A name that ends in a digit is parted from its number by `=` (`C1=30`). The length belongs to the cutting edge D of
//! the tool; `D0` in a block of machine coordinates takes it away, so it is called again before the next motion. `G4 F`
//! counts seconds and leaves the feed alone. `TRAFOOF` stands before the work offset, which it may clear.
//!
//! `TRAORI` controls the tip in the frame of the table at zero; behind it the work offset is called again. `CYCLE800` in
//! mode 57 turns about X, the new Y and the new Z. Its direction -1 or 1 takes the pose with the lower or the higher value
//! of the axis that is the direction reference of the swivel data (828D operating manual, 10.6).

use crate::config::{Formats, PathNorm};
use crate::motion::{PlaneAngles, PoseRule, Registers};
use crate::nc::Numerals;

use super::spellings::{Comments, Length, LengthCall, Spellings, Tilting, Tip, Vectors, printable};
use super::{Control, numbered};

/// The Siemens dialect.
#[derive(Debug, Clone, Copy)]
pub struct Siemens;

static SPELLINGS: Spellings = Spellings {
    name: "siemens",
    title: "Siemens 840D",
    formats: Formats { linear_whole: 6, rotary_whole: 6, feed_whole: 9, speed_whole: 6, ..Formats::DEFAULT },
    numerals: Numerals { point: false, plus: false },
    line_length: 512,
    counted: false,
    comment: Comments { marks: ["; ", ""], length: 200, byte: printable },
    operation: Some(["MSG(\"", "\")"]),
    opening: &[],
    end: "M30",
    closing: &[],
    number_digits: 0,
    plain_name: false,
    units: ["G710", "G700"],
    safety: &["TRAFOOF", "CYCLE800()", "{units} G17 G40 G64 G90 G94 {work_offset}"],
    per_minute: "G94",
    offset_title: "",
    inverse_time: Some("G93"),
    path_norm: PathNorm::G93Minutes,
    feed_per_inch: 1.0,
    rapid: "G0",
    rapid_end: "",
    feed: "G1",
    motion_modal: true,
    centre: "",
    machine: ["SUPA G0", "D0"],
    tool_change: &["T{tool}", "M6", "T{next}"],
    preselect: true,
    length: Length {
        code: "D{offset}",
        call: LengthCall::Alone,
        off: "",
        machine_ends: true,
        registers: Registers::Edges,
        address: "D",
    },
    speed: None,
    spindle: ["S{speed} M3", "S{speed} M4"],
    spindle_off: "M5",
    coolant_off: "M9",
    coolant: [Some(["M8", "M9"]), Some(["M7", "M9"]), None, None],
    stop: ["M0", "M1"],
    dwell: &["G4 F{seconds}"],
    smoothing: [
        &["CYCLE832({path_tolerance},3)"],
        &["CYCLE832({path_tolerance},2)"],
        &["CYCLE832({path_tolerance},1)"],
    ],
    smoothing_off: &["CYCLE832()"],
    turning: ["", ""],
    tip: Some(Tip {
        on: &["TRAORI", "{posture}", "{work_offset}"],
        with_length: None,
        off: &["TRAFOOF"],
        reset: &[],
        ends_length: false,
        posture: ["ORIMKS ORIAXES", "ORIWKS ORIVECT"],
        // In ORIMKS they would be counted in the frame of the machine.
        vectors: Some(Vectors {
            words: ["A3=", "B3=", "C3="],
            with_length: None,
            motion: None,
            rapid_end: "",
            posture: ["ORIWKS ORIAXES", "ORIWKS ORIVECT"],
        }),
        frame_is_set: false,
        turns_in_plane: true,
        note: "",
    }),
    plane: Some(Tilting {
        on: &["CYCLE800(0,{swivel_data},0,57,0,0,0,{first},{second},{third},0,0,0,{pose},0)"],
        length_first: false,
        off: &["CYCLE800()"],
        reset: &[],
        poses: ["-1", "1"],
        angles: PlaneAngles::MovingXyz,
        decimals: Some(6),
        pose: PoseRule::Side,
        ends_behind_retract: true,
        note: "the direction reference of the swivel data must be the rotary axis nearest the tool",
    }),
    rotary_note: "the axes must not be modulo axes (MD30310 = 0)",
};

impl Control for Siemens {
    fn spellings(&self) -> &'static Spellings {
        &SPELLINGS
    }

    fn work_offset(&self, word: &str) -> Option<String> {
        let known = numbered(word, "G", 54..=57) || numbered(word, "G", 505..=599);
        known.then(|| word.to_owned())
    }

    fn axis_word(&self, name: &str) -> Option<String> {
        let digits = name.strip_prefix(|first: char| first.is_ascii_uppercase())?;
        match digits.len() {
            0 => Some(name.to_owned()),
            1..=2 if digits.bytes().all(|digit| digit.is_ascii_digit()) => Some(format!("{name}=")),
            _ => None,
        }
    }

    fn message(&self, byte: u8) -> u8 {
        if byte == b'"' { b'\'' } else { printable(byte) }
    }
}
