//! Haas NGC.
//!
//! Codes have two digits, as Haas writes them. As on Fanuc, a number needs a decimal point and `G43` is written with Z.
//! The dwell is in seconds because its P has a point. Coolant through the spindle has its own off code.
//!
//! Length guard of the NGC with macros: `#2000+H` is the length in the offset page, `#2200+H` its wear, for H1 to H200,
//! in the unit of the machine, which is that of the program; `G43` takes their sum. Reading them stops the look-ahead
//! (Haas mill manual 96-8000, macros). `#3000` stops with an alarm.
//!
//! F of `G93` is at most 9999.99, as in Autodesk's public posts for Haas (`setMultiAxisFeedrate`); the page of G93 of
//! Haas states no limit.
//!
//! D is a radius or a diameter, as setting 40 states (mill manual, setting 40; from memory). `;` is the end of a block,
//! so no comment holds one.
//!
//! `G234 H` switches on tip control, with coordinates in the frame of the table with its rotary axes at zero. Before it
//! `G254` moves the zero of the words with the table, whose axes stay those of the machine: X and Y come over the
//! approach point, `G255` ends it, and the block of `G234` moves Z alone (`prepositionDWO` in Autodesk's public post
//! for Haas; `G254` is an option, the entry of B in the work offset is 0: UMC manual, p. 56, and the page of G254).
//! `G49` ends tip control in the block of `G53`.
//!
//! In `G95` F of a thread is its pitch, as in Autodesk's public posts for Haas (`useG95forTapping`). F of an inch
//! program has four decimals, from memory; Autodesk's public post for the NGC writes three (`feedFormat`, 2 in mm).
//! With three a thread of 80 threads per inch at 101 rev/min is off by 0.04 %.
//!
//! `G91 G28 Z0.` moves Z to machine zero, through the point where it is, and cancels the length offset (mill manual
//! 96-8000, G28).
//!
//! In mode "plane" the same `G254` is in force for the whole operation: after all rotary motion, then X and Y in one
//! block and Z in another; `G28`, `G53` and `M06` ignore it, and `G255` ends it before an axis rotates (UMC manual, p.
//! 56, and the page of G254).
//!
//! `G268` tilts a plane instead (`control.plane_by`), with the length offset active before it, and `G253` rotates the
//! axes; `Q123` is the order of its angles: about X, then Y, then Z of the work offset. From memory: no page of Haas
//! that states it was found, and the header of a program with planes asks for it.

use crate::motion::{CycleAbilities, FineBoreAbility, PlaneAngles, PoseRule};
use crate::nc::{Formats, Numerals};

use super::control::{Control, LengthGuard, numbered};
use super::functions::ControlFunction;
use super::spellings::{
    ArcCodes, Cancel, CommentStyle, CycleCodes, CycleForm, FoundAt, HoleCycles, MachineRetract, Spellings,
    TiltedPlaneCodes, TipControlCodes, ascii_in_brackets,
};

/// The Haas dialect.
#[derive(Debug, Clone, Copy)]
pub struct Haas;

static SPELLINGS: Spellings = Spellings {
    name: "haas",
    title: "Haas",
    formats: Formats {
        rotary: 3,
        feed: 2,
        feed_inch: 4,
        linear_whole: 6,
        rotary_whole: 6,
        feed_whole: 6,
        speed_whole: 5,
        ..Formats::DEFAULT
    },
    numerals: Numerals { point: true, plus: false },
    line_length: 254,
    comment: CommentStyle { marks: ["(", ")"], length: 76, byte: commented },
    opening: &["%", "O{number} ({name})"],
    closing: &["%"],
    number_digits: 5,
    largest_inverse_time: 9999.99,
    rapid: "G00",
    feed: "G01",
    arcs: ArcCodes { senses: ["G02", "G03"], ..ArcCodes::ISO },
    cycles: Some(HoleCycles {
        abilities: CycleAbilities {
            ream_higher: true,
            tap_stops_spindle: true,
            tap_uses_feed: true,
            fine_bore: Some(FineBoreAbility { states_angle: false, fixed_shift_um: None, stops_spindle: false }),
            ..CycleAbilities::CODES
        },
        // Without Q, I and J are direction and distance of the shift: mill operator's manual 96-8000, p. 187 and 188.
        // With Q the direction would be that of setting 27.
        form: CycleForm::Codes(CycleCodes { fine_bore: "G76", bore_shift_by_axis: true, ..CycleCodes::ISO }),
    }),
    radius_data: [
        "D must hold the radius of the tool where setting 40 is RADIUS, its diameter where it is DIAMETER",
        "D must hold wear only",
    ],
    cancels: &[
        Cancel::listed(ControlFunction::Scaling, "G50"),
        Cancel::listed(ControlFunction::Rotation, "G69"),
        Cancel::listed(ControlFunction::Smoothing, "G187"),
    ],
    machine: ["G53 G00", ""],
    retracts: &[MachineRetract::to_machine_coordinate("G53"), MachineRetract::to_reference_position(true)],
    tool_change: &["T{tool} M06", "T{next}"],
    spindle: ["S{speed} M03", "S{speed} M04"],
    spindle_off: "M05",
    coolant_off: "M09",
    coolant: [Some(["M08", "M09"]), None, Some(["M88", "M89"]), None],
    stop: ["M00", "M01"],
    per_revolution: "G95",
    dwell: &["G04 P{seconds}"],
    smoothing: [&["G187 P1 E{path_tolerance}"], &["G187 P2 E{path_tolerance}"], &["G187 P3 E{path_tolerance}"]],
    smoothing_off: &["G187"],
    tip: Some(TipControlCodes {
        on: &[],
        with_length: Some("G234 H{offset}"),
        off: &[],
        reset: &[],
        may_cancel_offset: false,
        dynamic_offset: Some(["G254", "G255"]),
        posture: ["", ""],
        posture_setting: ["", ""],
        vectors: None,
        frame_is_set: false,
        frame_settings: [""; 3],
        turns_in_plane: false,
        note: "G234 must move only the axes of its block, and G49 G53 straight to the machine position",
    }),
    plane: Some(TiltedPlaneCodes {
        on: &["G268 X0. Y0. Z0. I{first} J{second} K{third} Q123", "G253"],
        length_first: true,
        off: &["G269"],
        reset: &["G269"],
        poses: ["", ""],
        angles: PlaneAngles::FixedXyz,
        decimals: None,
        pose: PoseRule::Nearest,
        cancelled_after_retract: true,
        note: "G43 H must move nothing by itself, G268 must rotate about X, then Y, then Z of the work offset, and G253 \
               must take the pose of the actual axis positions",
    }),
    rotary_note: "the axes must not take the shortest path to an angle beyond 360",
    examples: &[("control.tool_change", r#"["T{tool} M06", "T{next}"]"#)],
    unused_keys: &["control.smoothing_levels", "control.swivel_data", "control.tip_control"],
    found_at: &[
        FoundAt {
            key: "part_origin",
            place: "the work offset of the part (OFFSET, WORK) less that of the reference point of the table, both \
                    touched off with the same tool and with the rotary axes at zero",
            source: "",
        },
        FoundAt {
            key: "machine_zero",
            place: "the work offset of the part (OFFSET, WORK) where the lengths in the tool page are counted from \
                    the gauge line; else the machine coordinates (POSITION, MACHINE) with the gauge line on the part \
                    zero and the rotary axes at zero",
            source: "",
        },
        FoundAt {
            key: "table_zero",
            place: "settings 255 to 257 (machine rotary zero point), less the dimensions that lead from the reference point of \
                    the table to it; with the right values `kinematics --haas` prints the settings of the control",
            source: "",
        },
        FoundAt {
            key: "tools",
            place: "the length in the tool page (OFFSET, TOOL), if it is counted from the gauge line",
            source: "",
        },
        FoundAt {
            key: "dimensions",
            place: "settings 255 to 257 (machine rotary zero point X, Y, Z), in newer software 300 to 305; \
                    `kinematics --haas` prints each with the value that it must have",
            source: "",
        },
        FoundAt {
            key: "limits",
            place: "the travels of the machine in its manual, in machine coordinates: no page of the control was \
                    found that shows them",
            source: "",
        },
        FoundAt {
            key: "speeds",
            place: "the largest rapids of the machine in its specification: no page of the control was found that \
                    shows them",
            source: "",
        },
    ],
    ..Spellings::ISO
};

fn commented(byte: u8) -> u8 {
    if byte == b';' { b',' } else { ascii_in_brackets(byte) }
}

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
