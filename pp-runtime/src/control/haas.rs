//! Haas NGC.
//!
//! Codes have two digits, as Haas writes them. As on Fanuc a number needs its point and `G43` stands with Z; the dwell
//! is in seconds because its P has a point. Coolant through the spindle has an off code of its own.
//!
//! Length guard of the NGC with macros: `#2000+H` is the length in the offset page, `#2200+H` its wear, for H1 to H200, in
//! the unit of the machine, which is that of the program; `G43` takes their sum. To read them stops the look-ahead (Haas
//! mill manual 96-8000, macros). `#3000` stops with an alarm.
//!
//! `G234 H` controls the tip in the frame of the table at zero. `G268` tilts a plane, with the length offset active before
//! it, and `G253` turns the axes; `Q123` is the order of its angles.

use crate::motion::PathNorm;
use crate::motion::{CycleAbilities, PlaneAngles, PoseRule, Registers};
use crate::nc::Formats;
use crate::nc::Numerals;

use super::spellings::{
    ArcCentre, Arcs, Comments, CycleCodes, CycleForm, Cycles, Length, LengthCall, Spellings, Tilting, Tip,
    ascii_in_brackets,
};
use super::{Control, LengthGuard, numbered};

/// The Haas dialect.
#[derive(Debug, Clone, Copy)]
pub struct Haas;

static SPELLINGS: Spellings = Spellings {
    name: "haas",
    title: "Haas",
    formats: Formats {
        rotary: 3,
        feed: 2,
        linear_whole: 6,
        rotary_whole: 6,
        feed_whole: 6,
        speed_whole: 5,
        ..Formats::DEFAULT
    },
    numerals: Numerals { point: true, plus: false },
    line_length: 254,
    counted: false,
    comment: Comments { marks: ["(", ")"], length: 76, byte: ascii_in_brackets },
    operation: None,
    opening: &["%", "O{number} ({name})"],
    end: "M30",
    closing: &["%"],
    number_digits: 5,
    plain_name: false,
    units: ["G21", "G20"],
    safety: &["{units} G17 G40 G49 G80 G90 G94 {work_offset}"],
    per_minute: "G94",
    offset_title: "",
    inverse_time: Some("G93"),
    path_norm: PathNorm::G93Minutes,
    feed_per_inch: 1.0,
    rapid: "G00",
    rapid_end: "",
    feed: "G01",
    arcs: Arcs {
        senses: ["G02", "G03"],
        planes: [Some("G19"), Some("G18"), Some("G17")],
        centre: ArcCentre::Offsets,
        radius: "R",
        // Less than the control lets pass.
        radius_tolerance: 0.002,
    },
    cycles: Some(Cycles {
        can: CycleAbilities { ream_higher: true, tap_stops: true, tap_feed: true, ..CycleAbilities::CODES },
        form: CycleForm::Codes(CycleCodes::USUAL),
    }),
    motion_modal: true,
    centre: "",
    beside: ["G41 D{radius}", "G42 D{radius}", "G40"],
    machine: ["G53 G00", ""],
    tool_change: &["T{tool} M06", "T{next}"],
    preselect: true,
    length: Length {
        code: "G43 H{offset}",
        call: LengthCall::WithZ,
        off: "G49",
        machine_ends: true,
        registers: Registers::Shared,
        address: "H",
    },
    speed: None,
    spindle: ["S{speed} M03", "S{speed} M04"],
    spindle_off: "M05",
    coolant_off: "M09",
    coolant: [Some(["M08", "M09"]), None, Some(["M88", "M89"]), None],
    stop: ["M00", "M01"],
    dwell: &["G04 P{seconds}"],
    longest_dwell: 99_999_000,
    smoothing: [&["G187 P1 E{path_tolerance}"], &["G187 P2 E{path_tolerance}"], &["G187 P3 E{path_tolerance}"]],
    smoothing_off: &["G187"],
    turning: ["", ""],
    tip: Some(Tip {
        on: &[],
        with_length: Some("G234 H{offset}"),
        off: &["G49"],
        reset: &[],
        ends_length: true,
        posture: ["", ""],
        vectors: None,
        frame_is_set: false,
        turns_in_plane: false,
        note: "G234 and G49 must move nothing by themselves",
    }),
    plane: Some(Tilting {
        on: &["G268 X0. Y0. Z0. I{first} J{second} K{third} Q123", "G253"],
        length_first: true,
        off: &["G269"],
        reset: &["G269"],
        poses: ["", ""],
        angles: PlaneAngles::FixedXyz,
        decimals: None,
        pose: PoseRule::Nearest,
        ends_behind_retract: true,
        note: "G43 H moves nothing by itself, G268 turns about X, then Y, then Z of the work offset, and G253 takes the \
               pose where the axes stand",
    }),
    rotary_note: "the axes must not take the shortest way to an angle of another turn",
};

impl Control for Haas {
    fn spellings(&self) -> &'static Spellings {
        &SPELLINGS
    }

    fn work_offset(&self, word: &str) -> Option<String> {
        let known = numbered(word, "G", 54..=59) || numbered(word, "G154 P", 1..=99);
        known.then(|| word.to_owned())
    }

    fn length_guard(&self, guard: &LengthGuard) -> Vec<String> {
        if !(1..=200).contains(&guard.offset) {
            return Vec::new();
        }
        let ([length, tolerance], [geometry, wear]) = (guard.in_program(), [2000, 2200].map(|at| at + guard.offset));
        let alarm = format!("#3000= 101 (T{} IS NOT {length} LONG)", guard.tool);
        vec![format!("IF [ABS[#{geometry} + #{wear} - {length}] GT {tolerance}] THEN {alarm}")]
    }
}
