//! Heidenhain TNC 640 and iTNC 530, conversational.
//!
//! Every line has a number, comments included. Every straight motion begins with L, an arc with C or CR, and a helix
//! with CP; only axis words, F and R0 are modal. There is no inverse-time feed, so F applies to the control's own path.
//! The spindle speed is part of TOOL CALL, which takes the length from the tool table. In an inch program F is in
//! tenths of an inch. Q239 is -99.9999 to 99.9999 (TNC 640, cycle programming 34059x-01, p. 102), so a pitch has four
//! decimals in both units. A `~` at the end of a line continues it in the next line, so no comment holds one. A dwell
//! of cycle 9 is at most 3600 s (TNC 640 user's manual, 19.3).
//!
//! `L .. FMAX` is a straight line in which all axes of the block move together (iTNC 530 ISO manual 60642x-03, p. 211:
//! G00 straight line at rapid traverse; the axes of one block move simultaneously).
//!
//! `BLK FORM CYLINDER Z R L DIST` is a round blank about X0 Y0: radius, height, and the distance of its top from the
//! datum. The words are those of FreeCAD's public post for Heidenhain; that DIST counts to the top is from memory.
//!
//! Length guard: `FN 18` reads the length (ID50 NR1) and the oversize (NR4) of the tool from the tool table, whose sum
//! `TOOL CALL` takes; always in millimetres, whatever the unit of the program. `QL` parameters are local to this
//! program. `FN 14` stops with an error number, so the message is a comment before it.
//!
//! Plane guard: `FN 18` reads the positions of the rotary axes in the active coordinate system (ID270 NR1, IDX4 to IDX6
//! for A B C: TNC 426/430 Technical Manual, p. 7-30). `FN 20: WAIT FOR SYNC` is before it, so that the look-ahead has
//! not passed the call (TNC 640 user's manual, FN 20; from memory). The sine of half the difference is zero at whole
//! turns as well.
//!
//! Guard of the work offset: `FN 18` reads the basic rotation (ID210 NR1: TNC 426/430 Technical Manual, p. 7-30).
//!
//! `/` before the number marks a block that the operator may have skipped, as Autodesk's public post for the TNC writes
//! it (`writeOptionalBlock`).
//!
//! `TOOL CALL "NAME"` and `TOOL DEF "NAME"` take the name of the tool table, as Autodesk's public post writes them
//! (`toolAsName`): at most 32 capitals, digits and some signs (TNC 640 ISO manual 1/2015, p. 170).
//!
//! `RL` and `RR` offset the path by R + DR of the tool table + DR of the tool call (TNC 620 user's manual 1/2022, p.
//! 134). Where the path is that of the tool centre the tool call takes the radius off, `DR-6`, so that wear is left; at
//! most 99.999 mm (TNC 640 ISO manual 1/2015, p. 171). No manual was found that states whether a tool call with S alone
//! keeps DR, so it is written there again.
//!
//! `FUNCTION TCPM` switches on tip control, with coordinates in the frame of the table with its rotary axes at zero.
//! Where the table is tilted, X and Y come over the first point in a `PLANE` before it, as in Autodesk's public post
//! for the TNC, which moves its zero there with cycle 7; the coordinates of the point are the same position.
//! `PLANE SPATIAL` rotates about X, then Y, then Z of the frame that it tilts (SPC·SPB·SPA as a product). SEQ is the
//! sign of the master axis, the first one from the tool. `COORD ROT`: where a rotary axis is parallel to the tool, the
//! coordinates are rotated and not the axis (TNC7 user's manual 81762x-17, COORD ROT and TABLE ROT). Both are switched
//! off before a tool call and before M91.
//!
//! `L M140 MB MAX` retracts along the tool axis to the end of the travel, at rapid without F, as Autodesk's public post
//! writes it (`useM140`). It needs the tool axis of a tool call before it (programs of that post call `TOOL CALL Z`
//! first); up to the first tool call the retract is therefore M91.
//!
//! A position with M99 calls the cycle that was defined last. Each cycle moves from the set-up clearance Q200 above the
//! surface Q203 down by Q201, and afterwards at rapid to Q204 above the surface. Cycle 200 is used without pecking.
//! Cycle 205 retracts to Q200 after each step Q202 and returns at rapid to Q258 = Q259 above the last depth. Cycle 203
//! retracts by Q256 only, as long as there are no more chip breaks than Q213, and moves out at Q208 at the end. Cycle
//! 201 moves out to Q200 at its own feed where Q208 is 0. Cycle 207 synchronises spindle and feed, cuts a left-hand
//! thread where Q239 is negative, and leaves the spindle stopped (user's manuals of cycle programming, iTNC 530 and TNC
//! 640). F in cycles, Q206, is in the same unit as elsewhere in the program, in tenths of an inch as well: from memory,
//! since no public page states it; the header of an inch program with cycles says so.

use crate::motion::{CycleAbilities, FineBoreAbility, PlaneAngles, PoseRule, Registers};
use crate::nc::{Formats, Numerals};
use crate::options::PathNorm;

use super::control::{BlankWords, Control, LengthGuard, PlaneGuard, numbered};
use super::functions::ControlFunction;
use super::spellings::{
    ArcCentre, ArcCodes, Cancel, CommentStyle, CycleDefinitions, CycleForm, FoundAt, HoleCycles, LengthCall,
    LengthCodes, LinearRapids, MachineRetract, RetractForm, Spellings, TiltedPlaneCodes, TipControlCodes,
    ToolAxisWords, printable,
};
use crate::tolerance::writer::GUARDED_SINES;

/// The Heidenhain dialect.
#[derive(Debug, Clone, Copy)]
pub struct Heidenhain;

const DRILLING: &str = "CYCL DEF 200 DRILLING ~\n\
    \x20 Q200={clearance} ;SET-UP CLEARANCE ~\n\
    \x20 Q201={depth} ;DEPTH ~\n\
    \x20 Q206=+{feed} ;FEED RATE FOR PLNGNG ~\n\
    \x20 Q202={step} ;PLUNGING DEPTH ~\n\
    \x20 Q210=+0 ;DWELL TIME AT TOP ~\n\
    \x20 Q203={surface} ;SURFACE COORDINATE ~\n\
    \x20 Q204={higher} ;2ND SET-UP CLEARANCE ~\n\
    \x20 Q211=+{seconds} ;DWELL TIME AT DEPTH";

const REAMING: &str = "CYCL DEF 201 REAMING ~\n\
    \x20 Q200={clearance} ;SET-UP CLEARANCE ~\n\
    \x20 Q201={depth} ;DEPTH ~\n\
    \x20 Q206=+{feed} ;FEED RATE FOR PLNGNG ~\n\
    \x20 Q211=+{seconds} ;DWELL TIME AT DEPTH ~\n\
    \x20 Q208=+0 ;RETRACTION FEED RATE ~\n\
    \x20 Q203={surface} ;SURFACE COORDINATE ~\n\
    \x20 Q204={higher} ;2ND SET-UP CLEARANCE";

/// Directions Q214, as Autodesk's public post has them: 1 -X, 2 -Y, 3 +X, 4 +Y.
const BORING: &str = "CYCL DEF 202 BORING ~\n\
    \x20 Q200={clearance} ;SET-UP CLEARANCE ~\n\
    \x20 Q201={depth} ;DEPTH ~\n\
    \x20 Q206=+{feed} ;FEED RATE FOR PLNGNG ~\n\
    \x20 Q211=+{seconds} ;DWELL TIME AT DEPTH ~\n\
    \x20 Q208=+99999 ;RETRACTION FEED RATE ~\n\
    \x20 Q203={surface} ;SURFACE COORDINATE ~\n\
    \x20 Q204={higher} ;2ND SET-UP CLEARANCE ~\n\
    \x20 Q214=+{quadrant} ;DISENGAGING DIRECTN ~\n\
    \x20 Q336={orient} ;ANGLE OF SPINDLE";

const UNIVERSAL_DRILLING: &str = "CYCL DEF 203 UNIVERSAL DRILLING ~\n\
    \x20 Q200={clearance} ;SET-UP CLEARANCE ~\n\
    \x20 Q201={depth} ;DEPTH ~\n\
    \x20 Q206=+{feed} ;FEED RATE FOR PLNGNG ~\n\
    \x20 Q202={step} ;PLUNGING DEPTH ~\n\
    \x20 Q210=+0 ;DWELL TIME AT TOP ~\n\
    \x20 Q203={surface} ;SURFACE COORDINATE ~\n\
    \x20 Q204={higher} ;2ND SET-UP CLEARANCE ~\n\
    \x20 Q212=+0 ;DECREMENT ~\n\
    \x20 Q213=+{steps} ;NR OF BREAKS ~\n\
    \x20 Q205=+0 ;MIN. PLUNGING DEPTH ~\n\
    \x20 Q211=+{seconds} ;DWELL TIME AT DEPTH ~\n\
    \x20 Q208=+99999 ;RETRACTION FEED RATE ~\n\
    \x20 Q256={gap} ;DIST FOR CHIP BRKNG";

const UNIVERSAL_PECKING: &str = "CYCL DEF 205 UNIVERSAL PECKING ~\n\
    \x20 Q200={clearance} ;SET-UP CLEARANCE ~\n\
    \x20 Q201={depth} ;DEPTH ~\n\
    \x20 Q206=+{feed} ;FEED RATE FOR PLNGNG ~\n\
    \x20 Q202={step} ;PLUNGING DEPTH ~\n\
    \x20 Q203={surface} ;SURFACE COORDINATE ~\n\
    \x20 Q204={higher} ;2ND SET-UP CLEARANCE ~\n\
    \x20 Q212=+0 ;DECREMENT ~\n\
    \x20 Q205=+0 ;MIN. PLUNGING DEPTH ~\n\
    \x20 Q258={gap} ;UPPER ADV STOP DIST ~\n\
    \x20 Q259={gap} ;LOWER ADV STOP DIST ~\n\
    \x20 Q257=+0 ;DEPTH FOR CHIP BRKNG ~\n\
    \x20 Q256=+0.2 ;DIST FOR CHIP BRKNG ~\n\
    \x20 Q211=+{seconds} ;DWELL TIME AT DEPTH ~\n\
    \x20 Q379=+0 ;STARTING POINT ~\n\
    \x20 Q253=+99999 ;F PRE-POSITIONING";

const RIGID_TAPPING: &str = "CYCL DEF 207 RIGID TAPPING NEW ~\n\
    \x20 Q200={clearance} ;SET-UP CLEARANCE ~\n\
    \x20 Q201={depth} ;DEPTH OF THREAD ~\n\
    \x20 Q239={pitch} ;THREAD PITCH ~\n\
    \x20 Q203={surface} ;SURFACE COORDINATE ~\n\
    \x20 Q204={higher} ;2ND SET-UP CLEARANCE";

static SPELLINGS: Spellings = Spellings {
    name: "heidenhain",
    title: "Heidenhain TNC",
    formats: Formats {
        pitch_mm: 4,
        pitch_inch: 4,
        linear_whole: 5,
        rotary_whole: 5,
        feed_whole: 5,
        speed_whole: 5,
        ..Formats::DEFAULT
    },
    numerals: Numerals { point: false, plus: true },
    line_length: 250,
    numbers_every_line: true,
    // iTNC 530 ISO manual 6/2010, p. 467: with a rotary table a preset counts from its centre.
    offset_has_coordinates: false,
    // Overview of the M functions in the manuals of the iTNC 530.
    own_m: &[
        (13, "spindle on, clockwise, with coolant"),
        (14, "spindle on, counterclockwise, with coolant"),
        (30, "end of program"),
        (89, "cycle at each point"),
        (90, "corners at constant speed"),
        (91, "machine coordinates"),
        (92, "coordinates from a point of the machine builder"),
        (94, "display of a rotary axis below 360"),
        (97, "small steps of a contour"),
        (98, "open corners of a contour"),
        (99, "cycle at this point"),
    ],
    comment: CommentStyle { marks: ["; ", ""], length: 200, byte: commented },
    operation: Some(["* - ", ""]),
    message: None,
    skips_guards: true,
    opening: &["BEGIN PGM {name} {units}"],
    end: "M30",
    closing: &["END PGM {name} {units}"],
    number_digits: 0,
    plain_name: true,
    units: ["MM", "INCH"],
    safety: &["{rotary_path}", "CYCL DEF 247 DATUM SETTING ~\n  Q339=+{work_offset} ;DATUM NUMBER"],
    cancels: &[
        Cancel::usual(ControlFunction::TipControl, "M129"),
        Cancel::usual(ControlFunction::Planes, "PLANE RESET STAY"),
    ],
    per_minute: "",
    per_revolution: "",
    offset_title: "preset ",
    inverse_time: None,
    largest_inverse_time: f64::INFINITY,
    linear_rapids: LinearRapids::AsDelivered,
    times_faint_moves: false,
    tip_control_holds_axis_speeds: true,
    path_norm: PathNorm::XyzDegrees,
    feed_per_inch: 10.0,
    rapid: "L",
    rapid_end: "R0 FMAX",
    feed: "L",
    arcs: ArcCodes {
        senses: ["DR-", "DR+"],
        // Arcs lie in the plane perpendicular to the axis of TOOL CALL.
        planes: [None, None, Some("")],
        centre: ArcCentre::Pole,
        radius: "R",
        // The control accepts 0.016 mm as delivered (from memory: no public page was found).
        radius_tolerance_mm: 0.01,
    },
    cycles: Some(HoleCycles {
        abilities: CycleAbilities {
            ream_higher: true,
            longest_dwell_ms: 3_600_000,
            returns_to_any_level: true,
            programs_gap: true,
            tap_stops_spindle: true,
            // 0.2 mm, and the spindle as before: cycle 202 in the manuals of cycle programming (from memory).
            fine_bore: Some(FineBoreAbility { states_angle: true, fixed_shift_um: Some(200), stops_spindle: false }),
            ..CycleAbilities::CODES
        },
        form: CycleForm::Definitions(CycleDefinitions {
            drill: &[DRILLING],
            plain_drill: None,
            peck: &[UNIVERSAL_PECKING],
            chip_break: &[UNIVERSAL_DRILLING],
            ream: &[REAMING],
            fine_bore: &[BORING],
            thread: &[RIGID_TAPPING],
            call: "M99",
            end: "",
        }),
    }),
    motion_modal: false,
    no_compensation: "R0",
    compensation: ["RL", "RR", "R0"],
    straight_corners: None,
    radius_data: [
        "R and DR of the tool table must hold the radius of the tool",
        "the tool call takes the radius off (DR)",
    ],
    machine: ["L", "R0 FMAX M91"],
    retracts: &[
        MachineRetract::to_machine_coordinate("M91"),
        MachineRetract { name: "M140", form: RetractForm::AlongTool { block: "L M140 MB MAX" } },
    ],
    tool_change: &["TOOL CALL {tool} Z S{speed} DR{radius_delta}", "TOOL DEF {next}"],
    // TNC7 basic, User's Manual (81762x-19), "Tool ID number": TOOL CALL 0 unloads the tool and inserts no new one.
    empty_spindle_note: "",
    tool_name: Some(["\"", "\""]),
    tool_name_byte: |byte| byte.is_ascii_uppercase() || byte.is_ascii_digit() || b"#$%&,-._@".contains(&byte),
    preselect: true,
    length: LengthCodes {
        code: "",
        call: LengthCall::WithTool,
        off: "",
        cancelled_by_machine_coordinates: false,
        registers: Registers::Rows,
        address: "",
    },
    speed: Some("TOOL CALL S{speed} DR{radius_delta}"),
    spindle: ["M3", "M4"],
    spindle_off: "M5",
    coolant_off: "M9",
    coolant: [Some(["M8", "M9"]), None, None, None],
    stop: ["M0", "M1"],
    dwell: &["CYCL DEF 9.0 DWELL TIME", "CYCL DEF 9.1 DWELL {seconds}"],
    longest_dwell: 3_600_000,
    smoothing: [
        &["CYCL DEF 32.0 TOLERANCE", "CYCL DEF 32.1 T{path_tolerance}", "CYCL DEF 32.2 HSC-MODE:1 TA{angle}"],
        &["CYCL DEF 32.0 TOLERANCE", "CYCL DEF 32.1 T{path_tolerance}", "CYCL DEF 32.2 HSC-MODE:1 TA{angle}"],
        &["CYCL DEF 32.0 TOLERANCE", "CYCL DEF 32.1 T{path_tolerance}", "CYCL DEF 32.2 HSC-MODE:0 TA{angle}"],
    ],
    smoothing_with_angle: [&[], &[], &[]],
    smoothing_off: &["CYCL DEF 32.0 TOLERANCE", "CYCL DEF 32.1"],
    blending: &[],
    rotary_path: ["M127", "M126"],
    may_begin_in_tip_control: false,
    tip: Some(TipControlCodes {
        on: &["FUNCTION TCPM F TCP AXIS POS PATHCTRL {posture}"],
        with_length: None,
        off: &["FUNCTION RESET TCPM"],
        reset: &["FUNCTION RESET TCPM"],
        may_cancel_offset: false,
        dynamic_offset: None,
        posture: ["AXIS", "VECTOR"],
        posture_setting: ["", ""],
        vectors: Some(ToolAxisWords {
            words: ["TX", "TY", "TZ"],
            with_length: None,
            motion: Some("LN"),
            rapid_end: "FMAX",
            posture: ["AXIS", "VECTOR"],
        }),
        frame_is_set: false,
        frame_settings: [""; 3],
        turns_in_plane: true,
        note: "",
    }),
    plane: Some(TiltedPlaneCodes {
        on: &["PLANE SPATIAL SPA{first} SPB{second} SPC{third} TURN MB MAX FMAX SEQ{pose} COORD ROT"],
        length_first: false,
        off: &["PLANE RESET STAY"],
        reset: &[],
        poses: ["-", "+"],
        angles: PlaneAngles::FixedXyz,
        decimals: Some(4),
        pose: PoseRule::Sign,
        cancelled_after_retract: false,
        note: "the master axis of SEQ must be the rotary axis nearest the tool",
    }),
    shortest_word: None,
    shortest_note: "",
    rotary_note: "M127 is in force, so the axes do not take the shortest path",
    examples: &[
        (
            "control.safety",
            r#"["M129", "PLANE RESET STAY", "M127", "CYCL DEF 247 DATUM SETTING ~", "Q339=+{work_offset} ;DATUM NUMBER"]"#,
        ),
        ("control.tool_change", r#"["TOOL CALL {tool} Z S{speed} DR{radius_delta}", "TOOL DEF {next}"]"#),
        ("control.mill_turn", r#"{ radius = "parameter", modes = ["M200"], spindle = "master" }"#),
        ("control.coolant", r#"{ through = ["M50", "M51"] }"#),
        ("retract.method", r#""M140""#),
        ("cycles.probe", r#"{ "PROBE/BORE,20" = ["CALL PGM TNC:\\PROBE\\BORE20.H"] }"#),
        // Words of cycle 481: TNC 640 Programming of Measuring Cycles, "Measuring a tool length (cycle 481)".
        (
            "cycles.measure_tool",
            r#"["TCH PROBE 481 TOOL LENGTH ~", "Q340=+1 ;CHECK ~", "Q260=+100 ;CLEARANCE HEIGHT ~", "Q341=+1 ;PROBING THE TEETH"]"#,
        ),
        ("cycles.check_tool", r#"["CALL PGM TNC:\\PROBE\\CHECK.H"]"#),
        ("clamp", r#"{ on = "M10", off = "M11" }"#),
        ("clamp", r#"{ on = "M22", off = "M23" }"#),
    ],
    unused_keys: &[
        "control.program_number",
        "control.smoothing_levels",
        "control.swivel_data",
        "control.states",
        "control.plane_by",
    ],
    found_at: &[
        FoundAt {
            key: "part_origin",
            place: "the row of the preset table of the part: with a rotary table it holds the distance of the datum from the \
                    centre of the table, which is no machine coordinate; less that of the reference point of the table, \
                    where this is another point",
            source: "iTNC 530 ISO manual 6/2010, p. 467",
        },
        FoundAt {
            key: "machine_zero",
            place: "the position display REF (MOD, Position display) with the gauge line on the part zero and the \
                    rotary axes at zero",
            source: "TNC 407 manual, p. 295",
        },
        FoundAt { key: "tools", place: "L of the tool table", source: "" },
        FoundAt {
            key: "dimensions",
            place: "the kinematics description of the machine builder, after the code number of the builder; \
                    `kinematics --heidenhain` prints each step with the value that it must have",
            source: "Technical Manual iTNC 530, 07/2013, p. 670 and 722",
        },
        FoundAt {
            key: "limits",
            place: "the software limit switches, which FN 18: SYSREAD Q1 = ID230 NR2 IDX1 (negative, axis 1) and NR3 \
                    (positive) read, in REF coordinates",
            source: "Technical Manual TNC 426/430, p. 7-30",
        },
        FoundAt { key: "speeds", place: "machine parameter maxFeed of each axis; MP1010 on the iTNC 530", source: "" },
    ],
};

/// Axes in the order of their numbers.
const AXES: [&str; 9] = ["X", "Y", "Z", "A", "B", "C", "U", "V", "W"];

/// `- 30`, `+ 20.5`.
fn spaced(degrees: f64) -> String {
    let text = PlaneGuard::subtracted(degrees);
    let (sign, number) = text.split_at(1);
    format!("{sign} {number}")
}

fn commented(byte: u8) -> u8 {
    if byte == b'~' { b'-' } else { printable(byte) }
}

impl Control for Heidenhain {
    fn spellings(&self) -> &'static Spellings {
        &SPELLINGS
    }

    /// Row of the preset table; G54 to G59 are rows 1 to 6.
    fn work_offset(&self, word: &str) -> Option<String> {
        if numbered(word, "G", 54..=59) {
            let number: u32 = word.strip_prefix('G')?.parse().ok()?;
            return Some((number - 53).to_string());
        }
        numbered(word, "", 0..=999).then(|| word.to_owned())
    }

    fn blank(&self, blank: &BlankWords) -> Vec<String> {
        let BlankWords { lower, upper, round, .. } = blank;
        if let Some([radius, _, height]) = round {
            return vec![format!("BLK FORM CYLINDER Z R{radius} L{height} DIST{}", upper[2])];
        }
        let words = |[x, y, z]: &[String; 3]| format!("X{x} Y{y} Z{z}");
        vec![format!("BLK FORM 0.1 Z {}", words(lower)), format!("BLK FORM 0.2 {}", words(upper))]
    }

    fn length_guard(&self, guard: &LengthGuard) -> Vec<String> {
        let LengthGuard { label, tool, .. } = *guard;
        let [length, tolerance] = guard.in_millimetres();
        let bound = |value: f64| format!("{:+}", (value * 1e4).round() / 1e4);
        let (low, high) = (bound(length - tolerance), bound(length + tolerance));
        vec![
            format!("FN 18: SYSREAD QL1 = ID50 NR1 IDX{tool}"),
            format!("FN 18: SYSREAD QL2 = ID50 NR4 IDX{tool}"),
            "FN 1: QL1 = +QL1 + +QL2".to_owned(),
            format!("FN 12: IF +QL1 LT {low} GOTO LBL \"OFF{label}\""),
            format!("FN 12: IF +QL1 LT {high} GOTO LBL \"FITS{label}\""),
            format!("LBL \"OFF{label}\""),
            format!("; T{tool} was posted with L = {length} mm: the length in the tool table differs"),
            "FN 14: ERROR = 100".to_owned(),
            format!("LBL \"FITS{label}\""),
        ]
    }

    fn plane_guard(&self, guard: &PlaneGuard) -> Vec<String> {
        let PlaneGuard { label, axes } = guard;
        let mut lines = vec!["FN 20: WAIT FOR SYNC".to_owned()];
        let mut sum = Vec::new();
        for (number, (name, degrees)) in (1..).zip(axes) {
            let index = AXES.iter().position(|axis| axis == name);
            let Some(index) = index else { return Vec::new() };
            lines.push(format!("FN 18: SYSREAD QL{number} = ID270 NR1 IDX{}", index + 1));
            sum.push(format!("ABS ( SIN ( ( QL{number} {} ) / 2 ) )", spaced(*degrees)));
        }
        lines.extend([
            format!("QL3 = {}", sum.join(" + ")),
            format!("FN 12: IF +QL3 LT +{GUARDED_SINES} GOTO LBL \"PLANE{label}\""),
            format!("; after the plane call the axes are not at {}", guard.positions()),
            "FN 14: ERROR = 101".to_owned(),
            format!("LBL \"PLANE{label}\""),
        ]);
        lines
    }

    fn offset_guard(&self, label: u32) -> Vec<String> {
        vec![
            "FN 18: SYSREAD QL1 = ID210 NR1".to_owned(),
            format!("FN 9: IF +QL1 EQU +0 GOTO LBL \"OFFSET{label}\""),
            "; a basic rotation lies over the preset".to_owned(),
            "FN 14: ERROR = 102".to_owned(),
            format!("LBL \"OFFSET{label}\""),
        ]
    }

    fn message(&self, byte: u8) -> u8 {
        commented(byte)
    }
}
