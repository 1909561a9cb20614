//! Siemens 840D sl and ONE.
//!
//! An axis name that ends in a digit is separated from its value by `=` (`C1=30`). The length belongs to the cutting
//! edge D of the tool. `D0` in a block of machine coordinates cancels it, so D is called again before the next motion.
//! `G4 F` is in seconds and does not change the feed. `TRAFOOF` comes before the work offset, which it may clear.
//!
//! Length guard: `$P_TOOLL[1]` is the first length of the active edge with wear and adapter, whatever number the tool
//! management gave the tool. With `G710` and `G700` a program reads it in its own unit (Basic Functions 6FC5397-0BP40,
//! G2, 7.3). `M0` stops with the message displayed, and `M30` after it ends the program. Alarms of `SETAL` would need
//! alarm texts in the machine.
//!
//! `WORKPIECE(,"",,"BOX",112,ZA,ZI,-80,XA,YA,XI,YI)` and `WORKPIECE(,"",,"CYLINDER",192,ZA,ZI,ZB,XA)` are the blank of
//! the graphics: top, bottom, and the corners or the diameter; 16, 32, 64 and 128 of the mask make XI, YI, ZI and ZB
//! absolute. Read in public posts and programs of ShopMill and ShopTurn (github.com); no page of a manual was found.
//!
//! Plane guard: `$AA_IW[B]` is the position of an axis in the workpiece coordinate system, in which the rotary words
//! are, too; reading it stops the look-ahead, as for all variables of the main run, `$A` (Programming Guide Advanced
//! 04.00, 15.2.37, p. 15-558). `SIN` is in degrees; the sine of half the difference is zero at whole turns as well.
//!
//! Guard of the work offset: `$P_ACTFRAME` is the chain of all frames, with the components RT, SC and MI for each axis
//! (NC programming 12/2019, 6FC5398-2EP40-0BA0, p. 631 and 636). A workpiece that is aligned by a rotation of
//! coordinates has one.
//!
//! `T="NAME"` calls a tool by its name in the tool management (Fundamentals 05/2017; a name has at most 32 characters,
//! from memory).
//!
//! `/` before the block number marks a block that the operator may have skipped (SINUMERIK ONE programming manual NC
//! programming 12/2019, p. 52). Blocks with IF and ENDIF cannot be skipped (from memory), so no guard comes among such
//! blocks.
//!
//! `G41` offsets the path by the whole radius of the active edge. Where the path is that of the tool centre a guard
//! reads `$P_TOOLR`, the active radius with wear (System Variables 6FC5397-6AP40-3BA1, 03/2013), in the unit of the
//! program.
//!
//! Where the table is tilted, X and Y come over the first point in `CYCLE800`, which ends before `TRAORI`, as in
//! Autodesk's public post for the 840D; the work offset that `TRAFOOF` may have cleared comes before it.
//!
//! `TRAORI` switches on tip control, with coordinates in the frame of the table with its rotary axes at zero; after it
//! the work offset is called again. `CYCLE800` in mode 57 rotates about X, the new Y and the new Z. Its direction -1 or
//! 1 takes the pose with the lower or the higher value of the axis that is the direction reference of the swivel data
//! (828D operating manual, 10.6).
//!
//! The axes of a rapid arrive together: RTLION is the default, MD20730, and always in force under `TRAORI` (SINUMERIK
//! ONE programming manual NC programming 12/2019, p. 181).
//!
//! `CYCLE832(S_TOL,S_TOLM,S_OTOL)`: units of S_TOLM 1 finish, 2 semi-finish, 3 rough; tens 1 where S_OTOL is the
//! tolerance of the rotary axes, degrees. S_OTOL is always programmed, 1 without such a tolerance (SINUMERIK ONE
//! programming manual NC programming 12/2019, p. 1108).
//!
//! After `MCALL CYCLE81(..)` each motion ends with the cycle until `MCALL` alone. Arguments (840D Cycles PGZ, 2.1, and
//! 840D sl, which adds those from `_AXN` on): RTP return level, RFP surface, SDIS clearance above the surface, DP
//! bottom. `CYCLE82` adds DPR, DTB. `CYCLE83` adds DPR, FDEP, FDPR (depth of a step), DAM (0: all steps alike), DTB,
//! DTS, FRF, VARI (1 retract out of the hole, 0 chip breaking), _AXN, _MDEP, _VRT (retract distance), _DTD (dwell at
//! the bottom), _DIS1 (distance above the last depth after a retract). `CYCLE85` adds DPR, DTB, FFR, RFF. `CYCLE84`
//! adds DPR, DTB, SDAC (sense of rotation after the cycle), MPIT, PIT (negative: left-hand), POSS, SST, SST1, _AXN,
//! _PITA (1 mm, 3 inches). No public page was found on how `CYCLE83` divides a depth that is no
//! multiple of the step (from memory: the last two steps share the rest equally): in any case there are as many steps
//! as in the CL data, and none is longer.

use crate::motion::{CycleAbilities, FineBoreAbility, PlaneAngles, PoseRule, Registers};
use crate::nc::Formats;
use crate::tolerance::writer::GUARDED_SINES;

use super::control::{BlankWords, Control, LengthGuard, PlaneGuard, RadiusGuard, numbered};
use super::functions::ControlFunction;
use super::spellings::{
    ArcCodes, Cancel, CommentStyle, CycleDefinitions, CycleForm, FoundAt, HoleCycles, LengthCall, LengthCodes,
    LinearRapids, MachineRetract, MessageStyle, Spellings, TiltedPlaneCodes, TipControlCodes, ToolAxisWords, printable,
};

/// The Siemens dialect.
#[derive(Debug, Clone, Copy)]
pub struct Siemens;

static SPELLINGS: Spellings = Spellings {
    name: "siemens",
    title: "Siemens 840D",
    formats: Formats { linear_whole: 6, rotary_whole: 6, feed_whole: 9, speed_whole: 6, ..Formats::DEFAULT },
    line_length: 512,
    comment: CommentStyle { marks: ["; ", ""], length: 200, byte: printable },
    operation: Some(["MSG(\"", "\")"]),
    // At most 124 characters (from memory).
    message: Some(MessageStyle { marks: ["MSG(\"", "\")"], length: 124 }),
    skips_guards: false,
    units: ["G710", "G700"],
    // Function manual 840D sl, S1: M19 positions the spindle, M40 to M45 are gear stages, M70 makes it an axis.
    own_m: &[
        (17, "end of a subprogram"),
        (19, "spindle to an angle"),
        (30, "end of program"),
        (40, "choice of the gear stage"),
        (41, "gear stage 1"),
        (42, "gear stage 2"),
        (43, "gear stage 3"),
        (44, "gear stage 4"),
        (45, "gear stage 5"),
        (70, "spindle as an axis"),
    ],
    linear_rapids: LinearRapids::AsDelivered,
    safety: &["TRANS", "{units} G17 G40 G64 G90 G94 {work_offset}"],
    cancels: &[
        Cancel::usual(ControlFunction::TipControl, "TRAFOOF"),
        Cancel::usual(ControlFunction::Planes, "CYCLE800()"),
    ],
    arcs: ArcCodes {
        // In another plane the tool length applies at once along X or Y, unless SD42940 keeps it along Z
        // (6FC5398-1BP10-2BA0, 8.17.4).
        planes: [None, None, Some("G17")],
        radius: "CR=",
        // MD21000, or the radius at the start times MD21010 where that is larger (SINUMERIK 808D ADVANCED parameter
        // manual 6FC5397-8EP40-0BA0, 08/2013, p. 147). 0.01 mm as delivered is from memory.
        radius_tolerance_mm: 0.01,
        ..ArcCodes::ISO
    },
    cycles: Some(HoleCycles {
        abilities: CycleAbilities {
            ream_higher: true,
            tap_dwell: true,
            peck_dwell: true,
            returns_to_any_level: true,
            programs_gap: true,
            // The cycle starts the spindle in the sense SDIR and stops it at POSS: Cycles PGZ, CYCLE86.
            fine_bore: Some(FineBoreAbility { states_angle: true, fixed_shift_um: None, stops_spindle: true }),
            ..CycleAbilities::CODES
        },
        form: CycleForm::Definitions(CycleDefinitions {
            drill: &["F{feed}", "MCALL CYCLE82({back},{surface},{clearance},{bottom},,{seconds})"],
            plain_drill: Some(&["F{feed}", "MCALL CYCLE81({back},{surface},{clearance},{bottom})"]),
            peck: &[
                "F{feed}",
                "MCALL CYCLE83({back},{surface},{clearance},{bottom},,,{step},0,0,0,1,1,,,,{seconds},{gap})",
            ],
            chip_break: &[
                "F{feed}",
                "MCALL CYCLE83({back},{surface},{clearance},{bottom},,,{step},0,0,0,1,0,,,{gap},{seconds})",
            ],
            ream: &["MCALL CYCLE85({back},{surface},{clearance},{bottom},,{seconds},{feed},{feed})"],
            fine_bore: &[
                "F{feed}",
                "MCALL CYCLE86({back},{surface},{clearance},{bottom},,{seconds},{rotation},{shift_x},{shift_y},0,{orient})",
            ],
            thread: &[
                "MCALL CYCLE84({back},{surface},{clearance},{bottom},,{seconds},{rotation},,{pitch},0,{speed},{speed},,{pitch_unit})",
            ],
            call: "",
            end: "MCALL",
        }),
    }),
    compensation: ["G41", "G42", "G40"],
    radius_data: ["the cutting edge must hold the radius of the tool", "the cutting edge must hold wear only"],
    machine: ["SUPA G0", "D0"],
    retracts: &[MachineRetract::to_machine_coordinate("SUPA")],
    tool_change: &["T{tool}", "M6", "T{next}"],
    // industrialmonitordirect.com, "SINUMERIK 840D PLC restore tool conflict resolution": T0 M6 returns the tool to its
    // place.
    empty_spindle_note: "",
    tool_name: Some(["=\"", "\""]),
    tool_name_byte: |byte| (b' '..=b'~').contains(&byte) && byte != b'"',
    length: LengthCodes {
        code: "D{offset}",
        call: LengthCall::Alone,
        off: "",
        cancelled_by_machine_coordinates: true,
        registers: Registers::Edges,
        address: "D",
    },
    dwell: &["G4 F{seconds}"],
    smoothing: [
        &["CYCLE832({path_tolerance},3,1)"],
        &["CYCLE832({path_tolerance},2,1)"],
        &["CYCLE832({path_tolerance},1,1)"],
    ],
    smoothing_with_angle: [
        &["CYCLE832({path_tolerance},13,{angle})"],
        &["CYCLE832({path_tolerance},12,{angle})"],
        &["CYCLE832({path_tolerance},11,{angle})"],
    ],
    smoothing_off: &["CYCLE832()"],
    tip: Some(TipControlCodes {
        on: &["TRAORI", "{posture}", "{work_offset}"],
        with_length: None,
        off: &["TRAFOOF"],
        reset: &[],
        may_cancel_offset: true,
        dynamic_offset: None,
        posture: ["ORIMKS ORIAXES", "ORIWKS ORIVECT"],
        posture_setting: ["", ""],
        // In ORIMKS they would be components in the machine frame.
        vectors: Some(ToolAxisWords {
            words: ["A3=", "B3=", "C3="],
            with_length: None,
            motion: None,
            rapid_end: "",
            posture: ["ORIWKS ORIAXES", "ORIWKS ORIVECT"],
        }),
        frame_is_set: false,
        frame_settings: [""; 3],
        turns_in_plane: true,
        note: "",
    }),
    plane: Some(TiltedPlaneCodes {
        on: &["CYCLE800(0,{swivel_data},0,57,0,0,0,{first},{second},{third},0,0,0,{pose},0)"],
        length_first: false,
        off: &["CYCLE800()"],
        reset: &[],
        poses: ["-1", "1"],
        angles: PlaneAngles::MovingXyz,
        decimals: Some(4),
        pose: PoseRule::Side,
        cancelled_after_retract: true,
        note: "the direction reference of the swivel data must be the rotary axis nearest the tool",
    }),
    // Outside the modulo range DC raises alarm 16830: Axes and Spindles 06/2019, p. 225.
    shortest_word: Some(["=DC(", ")"]),
    shortest_note: "a modulo axis (MD30310 = 1, MD30455 bit 0 = 0), its range from 0 or -180 as `wrap` has it (MD30340)",
    rotary_note: "the axes must not be modulo axes (MD30310 = 0)",
    examples: &[
        ("control.safety", r#"["TRAFOOF", "CYCLE800()", "TRANS", "{units} G17 G40 G64 G90 G94 {work_offset}"]"#),
        ("control.tool_change", r#"["T{tool}", "M6", "T{next}"]"#),
        ("retract.method", r#""SUPA""#),
        ("cycles.probe", r#"{ "PROBE/BORE,20" = ["PROBE_BORE(20)"] }"#),
        ("cycles.measure_tool", r#"["MEASURE_TOOL({tool})"]"#),
        ("cycles.check_tool", r#"["CHECK_TOOL({tool})"]"#),
    ],
    unused_keys: &["control.program_number", "control.smoothing_levels", "control.states", "control.plane_by"],
    found_at: &[
        FoundAt {
            key: "part_origin",
            place: "the work offset of the part (Parameter, Work offset) less that of the reference point of the \
                    table, both touched off with the same tool and with the rotary axes at zero",
            source: "",
        },
        FoundAt {
            key: "machine_zero",
            place: "the work offset of the part (Parameter, Work offset) where the lengths in the tool list are \
                    counted from the gauge line; else the machine coordinates (Machine, Act. values MCS) with the \
                    gauge line on the part zero and the rotary axes at zero",
            source: "",
        },
        FoundAt {
            key: "tools",
            place: "length 1 of the cutting edge (Parameter, Tool list), if it is counted from the gauge line",
            source: "",
        },
        FoundAt {
            key: "dimensions",
            place: "MD24550 to MD24560 (base tool, joint offset, joint offset of the part) and the swivel data record \
                    $TC_CARR1 to $TC_CARR20; `kinematics --siemens` prints each with the value that it must have",
            source: "IM9 12/2017, p. 572",
        },
        FoundAt {
            key: "limits",
            place: "MD36100 and MD36110 of each axis, POS_LIMIT_MINUS and POS_LIMIT_PLUS, in machine coordinates \
                    (Startup, Machine data)",
            source: "",
        },
        FoundAt { key: "speeds", place: "MD32000 of each axis, MAX_AX_VELO (Startup, Machine data)", source: "" },
        FoundAt {
            key: "control.swivel_data",
            place: "name of the swivel data record: the second argument of CYCLE800 in a program of the machine",
            source: "",
        },
    ],
    ..Spellings::ISO
};

/// Sum of rotations in degrees, and of deviations of scales from 1, above which the guard of the work offset stops.
const GUARDED_FRAME: f64 = 1e-4;

/// Blocks that stop the program with a message if a condition holds.
fn stops_if(condition: &str, message: &str) -> Vec<String> {
    let [condition, message] = [format!("IF {condition}"), format!("MSG(\"{message}\")")];
    vec![condition, message, "M0".to_owned(), "M30".to_owned(), "ENDIF".to_owned()]
}

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

    fn file_header(&self, name: &str) -> Vec<String> {
        // File names have at most 24 characters.
        vec![format!("%_N_{}_MPF", &name[..name.len().min(24)]), ";$PATH=/_N_MPF_DIR".to_owned()]
    }

    fn blank(&self, blank: &BlankWords) -> Vec<String> {
        let BlankWords { lower: [x, y, z], upper: [to_x, to_y, top], round, given } = blank;
        match round {
            _ if !given => Vec::new(),
            Some([_, diameter, _]) => vec![format!("WORKPIECE(,\"\",,\"CYLINDER\",192,{top},{z},{z},{diameter})")],
            None => vec![format!("WORKPIECE(,\"\",,\"BOX\",112,{top},{z},-80,{x},{y},{to_x},{to_y})")],
        }
    }

    fn length_guard(&self, guard: &LengthGuard) -> Vec<String> {
        let [length, tolerance] = guard.in_program();
        stops_if(
            &format!("ABS($P_TOOLL[1]-{length})>{tolerance}"),
            &format!("T{} was posted with L = {length}: the length in the tool data differs", guard.tool),
        )
    }

    fn radius_guard(&self, guard: &RadiusGuard) -> Vec<String> {
        let RadiusGuard { tool, .. } = guard;
        stops_if(
            &format!("ABS($P_TOOLR)>{}", guard.in_program()),
            &format!("T{tool} follows the path of its centre: the radius in the tool data must be wear only"),
        )
    }

    fn plane_guard(&self, guard: &PlaneGuard) -> Vec<String> {
        let sine = |(name, degrees): &(String, f64)| {
            format!("ABS(SIN(($AA_IW[{name}]{})/2))", PlaneGuard::subtracted(*degrees))
        };
        let sum: Vec<String> = guard.axes.iter().map(sine).collect();
        stops_if(
            &format!("{}>{GUARDED_SINES}", sum.join("+")),
            &format!("After the plane call the axes are not at {}", guard.positions()),
        )
    }

    fn offset_guard(&self, _label: u32) -> Vec<String> {
        let sum = |component: &str, plain: &str| {
            ["X", "Y", "Z"].map(|axis| format!("ABS($P_ACTFRAME[{axis},{component}]{plain})")).join("+")
        };
        let mirrors = ["X", "Y", "Z"].map(|axis| format!("$P_ACTFRAME[{axis},MI]")).join(" OR ");
        let condition = format!("({}+{}>{GUARDED_FRAME}) OR {mirrors}", sum("RT", ""), sum("SC", "-1"));
        stops_if(&condition, "A rotation, a scale or a mirror lies over the work offset")
    }

    fn message(&self, byte: u8) -> u8 {
        if byte == b'"' { b'\'' } else { printable(byte) }
    }
}
