//! Fanuc 30i, 31i and related controls.
//!
//! A number without a decimal point is in least increments, so every axis and feed word has one. `G4 P` is in
//! milliseconds. `G43` and `G49` may move Z by the length of the tool. `G43 H` is therefore written in the block that
//! moves Z to the approach point, and `G49` in the block that moves Z to its machine position.
//!
//! Length guard of the 30i and 31i with offset memory B or C and custom macros: `#10000+H` and `#11000+H` are the two
//! parts of a length, geometry and wear. Machines differ in which is which (programs of machines show both orders).
//! `G43` takes their sum, and so does the guard. Both are in the unit of the program. `#3000` stops with an alarm of at
//! most 26 characters.
//!
//! `G91 G28 Z0.` moves Z to the reference position, through the point where it is. It cancels the length offset on its
//! way there, as `G53` does (B-63844EN, p. 204).
//!
//! R of `G05.1 Q1` is the level of machining condition selection, an option: 1 for speed to 10 for accuracy. Autodesk's
//! public post for Fanuc writes it (`setSmoothing`); the range is from memory.
//!
//! D is a radius where parameter 5004#2 is 0, and a diameter where it is 1 (from memory).
//!
//! In `G95` F of a thread is its pitch, as in Autodesk's public posts for Fanuc and Haas (`useG95forTapping`). F of an
//! inch program has four decimals: with a decimal point the control takes five (parameter 1404#2, from memory). F of
//! `G93` has one range in both units (B-62764EN/01, G93).
//!
//! `G43.4 H` starts tip control in the block that moves to the first point, which is one of length compensation only
//! (A-79348E, p. 16): never with rotary words, never alone. X and Y are over this point before it: over a tilted table
//! in `G68.2`, which `G69` ends, as in Autodesk's public post for Fanuc (`writeInitialPositioning`), and the rotary
//! words are written again after it. `G49` ends tip control in the block of `G53`, as B-63844EN, p. 204, has it for
//! `G43`. Parameter 19696#5 selects the frame of its coordinates: 0 that of the table at the angle that it has at
//! `G43.4`, 1 one that does not rotate (B-63783EN, p. 1116; A-79348E, p. 19). P of `G43.4` and `G43.5` belongs to tool
//! posture control, an option: 0 rotates the rotary axes evenly, 1 the tool axis in a plane; without P parameter
//! 19604#0 decides (A-79294E/05, p. 3 and 11).
//!
//! `G68.2` takes Euler angles about Z, the new X and the new Z, and `G53.1` rotates the axes. Of several poses it takes
//! the one that rotates the master axis least (B-63784EN, tool axis direction control), so the axes are rotated to the
//! planned pose before it.

use crate::motion::{CycleAbilities, FineBoreAbility, PlaneAngles, PoseRule};
use crate::nc::{Formats, Numerals};

use super::control::{Control, LengthGuard, numbered};
use super::functions::ControlFunction;
use super::spellings::{
    ArcCodes, Cancel, CommentStyle, CycleCodes, CycleForm, FoundAt, HoleCycles, MachineRetract, Spellings, ThreadCodes,
    TiltedPlaneCodes, TipControlCodes, ToolAxisWords, ascii_in_brackets,
};

/// The Fanuc dialect.
#[derive(Debug, Clone, Copy)]
pub struct Fanuc;

static SPELLINGS: Spellings = Spellings {
    name: "fanuc",
    title: "Fanuc",
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
    line_length: 132,
    comment: CommentStyle { marks: ["(", ")"], length: 72, byte: printed },
    opening: &["%", "O{number} ({name})"],
    closing: &["%"],
    number_digits: 4,
    radius_data: [
        "D must hold the radius of the tool where parameter 5004#2 is 0, its diameter where it is 1",
        "D must hold wear only",
    ],
    arcs: ArcCodes {
        // Parameter 3410, 0.01 mm or more on machines in use (from memory: no public page was found). A smaller value
        // than the control's only makes chords of an arc that it would take.
        radius_tolerance_mm: 0.002,
        ..ArcCodes::ISO
    },
    cycles: Some(HoleCycles {
        abilities: CycleAbilities {
            ream_higher: true,
            tap_dwell: true,
            tap_stops_spindle: true,
            tap_uses_feed: true,
            fine_bore: Some(FineBoreAbility { states_angle: false, fixed_shift_um: None, stops_spindle: false }),
            ..CycleAbilities::CODES
        },
        form: CycleForm::Codes(CycleCodes {
            thread: ThreadCodes::Cycle { codes: ["G84", "G74"], rigid: "M29 S{speed}" },
            // Q is the shift without its direction, which parameter 5148 has (6240 of the 15i: operator's manual, p.
            // 315).
            fine_bore: "G76",
            bore_setting: "parameter 5148",
            dwell: "P{milliseconds}",
            ..CycleCodes::ISO
        }),
    }),
    cancels: &[
        Cancel::listed(ControlFunction::Scaling, "G50"),
        Cancel::listed(ControlFunction::Rotation, "G69"),
        Cancel::listed(ControlFunction::Polar, "G15"),
        Cancel::listed(ControlFunction::SettingError, "G54.4 P0"),
        Cancel::listed(ControlFunction::Smoothing, "G05.1 Q0"),
    ],
    retracts: &[MachineRetract::to_machine_coordinate("G53"), MachineRetract::to_reference_position(true)],
    per_revolution: "G95",
    dwell: &["G4 P{milliseconds}"],
    smoothing: [&["G05.1 Q1 R{smoothing_level}"]; 3],
    smoothing_off: &["G05.1 Q0"],
    tip: Some(TipControlCodes {
        on: &[],
        with_length: Some("G43.4 H{offset} P{posture}"),
        off: &[],
        reset: &[],
        may_cancel_offset: false,
        dynamic_offset: None,
        posture: ["0", "1"],
        posture_setting: ["parameter 19604#0 must be 0", "parameter 19604#0 must be 1"],
        vectors: Some(ToolAxisWords {
            words: ["I", "J", "K"],
            with_length: Some("G43.5 H{offset} P{posture}"),
            motion: None,
            rapid_end: "",
            posture: ["0", "1"],
        }),
        frame_is_set: true,
        frame_settings: [
            "parameter 19696#5 = 0, in the manual the frame at G43.4, so prove this one at the first G43.4 over a tilted table",
            "parameter 19696#5 = 0",
            "parameter 19696#5 = 1",
        ],
        turns_in_plane: true,
        note: "G43.4 must move only the axes of its block (parameter 5006#6 = 1), and G49 G53 straight to the machine \
               position",
    }),
    plane: Some(TiltedPlaneCodes {
        on: &["G68.2 X0. Y0. Z0. I{first} J{second} K{third}", "G53.1"],
        length_first: false,
        off: &["G69"],
        reset: &["G69"],
        poses: ["", ""],
        angles: PlaneAngles::EulerZxz,
        decimals: None,
        pose: PoseRule::Nearest,
        cancelled_after_retract: true,
        note: "G53.1 must take the pose that rotates the rotary axes least; they are in it already",
    }),
    // B-63534EN, p. 531.
    shortest_note: "parameters 1008#0 = 1 and 1008#1 = 0",
    rotary_note: "the axes must not roll over (parameter 1008#0 = 0)",
    examples: &[("control.states", r#"{ "5114" = 0.5, "5115" = 0.5 }"#)],
    unused_keys: &["control.plane_by", "control.swivel_data", "control.tip_control"],
    found_at: &[
        FoundAt {
            key: "part_origin",
            place: "the work offset of the part (OFFSET, WORK) less that of the reference point of the table, both \
                    touched off with the same tool and with the rotary axes at zero; parameters 19700 to 19702 have a \
                    point of the first rotary axis of the table in machine coordinates",
            source: "A-79348E, p. 82",
        },
        FoundAt {
            key: "machine_zero",
            place: "the work offset of the part (OFFSET, WORK) where the lengths in the offset page are counted from \
                    the gauge line; else the machine coordinates (POS, ALL) with the gauge line on the part zero and \
                    the rotary axes at zero",
            source: "",
        },
        FoundAt {
            key: "table_zero",
            place: "parameters 19700 to 19702, and the vector 19703 to 19705 added where the reference point of the table is \
                    on the centre line of the second axis; with the right values `kinematics --fanuc` prints the \
                    parameters of the control",
            source: "",
        },
        FoundAt {
            key: "tools",
            place: "the length of H (OFFSET, GEOM(H)), if it is counted from the gauge line",
            source: "",
        },
        FoundAt {
            key: "dimensions",
            place: "parameters 19703 to 19705 (from the first to the second rotary axis of the table) and 19709 to \
                    19714 (from the tool axis to the rotary axes of the head); `kinematics --fanuc` prints each with \
                    the value that it must have",
            source: "A-79348E, p. 82 to 84",
        },
        FoundAt {
            key: "limits",
            place: "parameters 1320 (positive) and 1321 (negative) of each axis, in machine coordinates (SYSTEM, \
                    PARAM)",
            source: "cnc.wiki, stored stroke limit G22 and G23",
        },
        FoundAt {
            key: "speeds",
            place: "parameter 1420, rapid traverse of each axis, and 1430, its largest feed: the smaller one (SYSTEM, \
                    PARAM)",
            source: "",
        },
        FoundAt {
            key: "tcp_frame",
            place: "parameter 19696#5: 0 is \"table_at_start\", 1 is \"not_turning\"; \"table_at_zero\" is in no manual, so prove \
                    it at the machine with 0",
            source: "A-79348E, p. 19",
        },
    ],
    ..Spellings::ISO
};

/// The byte as a capital, digit or sign that every model can display.
fn printed(byte: u8) -> u8 {
    match ascii_in_brackets(byte).to_ascii_uppercase() {
        byte @ (b'A'..=b'Z'
        | b'0'..=b'9'
        | b' '
        | b'+'
        | b'-'
        | b'*'
        | b'/'
        | b'='
        | b'.'
        | b','
        | b'#'
        | b'['
        | b']') => byte,
        b':' | b';' => b',',
        b'_' => b'-',
        _ => b' ',
    }
}

impl Control for Fanuc {
    fn spellings(&self) -> &'static Spellings {
        &SPELLINGS
    }

    fn work_offset(&self, word: &str) -> Option<String> {
        let known = numbered(word, "G", 54..=59) || numbered(word, "G54.1 P", 1..=300);
        known.then(|| word.to_owned())
    }

    fn length_guard(&self, guard: &LengthGuard) -> Vec<String> {
        if !(1..=999).contains(&guard.offset) {
            return Vec::new();
        }
        let ([length, tolerance], [wear, geometry]) =
            (guard.in_program(), [10_000, 11_000].map(|at| at + guard.offset));
        let alarm = format!("#3000=101 (T{} IS NOT {length} LONG)", guard.tool);
        vec![format!("IF [ABS[#{wear}+#{geometry}-{length}] GT {tolerance}] THEN {alarm}")]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::program::Units;

    #[test]
    fn the_length_guard_adds_geometry_and_wear_of_the_register_in_the_unit_of_the_program() {
        let guard = LengthGuard {
            label: 3,
            tool: 12,
            offset: 21,
            length_mm: 114.3,
            tolerance_mm: 0.01,
            units: Units::Millimetres,
        };
        let block = "IF [ABS[#10021+#11021-114.3] GT 0.01] THEN #3000=101 (T12 IS NOT 114.3 LONG)";
        assert_eq!(Fanuc.length_guard(&guard), [block]);
        let inches = Fanuc.length_guard(&LengthGuard { units: Units::Inches, ..guard });
        assert_eq!(inches, ["IF [ABS[#10021+#11021-4.5] GT 0.00039] THEN #3000=101 (T12 IS NOT 4.5 LONG)"]);
        assert!(Fanuc.length_guard(&LengthGuard { offset: 1000, ..guard }).is_empty());
    }

    #[test]
    fn comments_hold_capitals_and_signs_that_every_model_prints() {
        let mut line = Vec::new();
        Fanuc.comment("Fräser: d=10 (ball) ~50% a_b".as_bytes(), &mut line);
        assert_eq!(String::from_utf8(line).expect("ASCII"), "(FR  SER, D=10 [BALL]  50- A-B)");
    }
}
