//! LinuxCNC.
//!
//! The program ends with M2 and has no `%` lines: a truncated file has no M2, and the control refuses it. `G43 H` moves
//! nothing, `G4 P` is in seconds, `G93` needs an F in every G1 block, and F in `G94` applies to the path of X Y Z
//! wherever one of them moves. `#5403` is the length of the tool in the spindle in the tool table, whatever H is in
//! force, in the unit of the machine and not of the program. `G64` without P would round corners without bound at high
//! speed. The axes of a rapid arrive together (handbook, node 53). `G41 D` offsets the path by half the diameter in the
//! tool table (handbook, nodes 85 and 86). `#5210` is 1 while G92 or G52 is active, `#5220` the number of the work
//! offset, and `#5230`, 20 more for each further offset, its rotation (G-code overview, numbered parameters); G92.1
//! would clear what the shop has set. `G28 Z` moves Z to the position that `G28.1` has stored (parameters 5161 to
//! 5166), through the point of its word (G-code documentation, G28). `(MSG, text)` displays a text (G-code overview,
//! comments). Tip control is only switched by codes of the configuration; there is no tilted plane.

use std::borrow::Cow;

use crate::motion::{CycleAbilities, StraightCorners};

use super::control::{Control, LengthGuard, numbered};
use super::spellings::{
    ArcCodes, CommentStyle, CycleCodes, CycleForm, FoundAt, HoleCycles, LengthCall, LengthCodes, LinearRapids,
    MachineRetract, MessageStyle, Spellings, ThreadCodes, ascii_in_brackets,
};

/// The LinuxCNC dialect.
#[derive(Debug, Clone, Copy)]
pub struct LinuxCnc;

static SPELLINGS: Spellings = Spellings {
    name: "linuxcnc",
    title: "LinuxCNC",
    line_length: 254,
    // 254 bytes, less two brackets and the "- " before a text that would be a command.
    comment: CommentStyle { marks: ["(", ")"], length: 250, byte: ascii_in_brackets },
    message: Some(MessageStyle { marks: ["(MSG, ", ")"], length: 246 }),
    end: "M2",
    linear_rapids: LinearRapids::Always,
    // Versions up to 2.8.4: a block with `Y0.001 A-6.6666` rotates at the speed of the axis (from memory).
    times_faint_moves: true,
    // Its planner knows the coordinates only: github.com/LinuxCNC/linuxcnc, issue 97 (following errors of the joints).
    tip_control_holds_axis_speeds: false,
    // G90.1 (absolute centres of arcs), G7 (X as a diameter) and G96 (S as a cutting speed) survive M2:
    // interp_convert.cc, convert_stop.
    safety: &["{units} G8 G17 G40 G49 G80 G90 G91.1 G94 G97 {work_offset} G64 P{path_tolerance}"],
    blending: &["G64 P{path_tolerance}"],
    arcs: ArcCodes {
        // If the radii differ by more, the interpreter of version 2.9 also compares their ratio.
        radius_tolerance_mm: 0.001_27,
        ..ArcCodes::ISO
    },
    cycles: Some(HoleCycles {
        abilities: CycleAbilities::CODES,
        form: CycleForm::Codes(CycleCodes { thread: ThreadCodes::Motion("G33.1"), ..CycleCodes::ISO }),
    }),
    radius_data: [
        "the tool table must hold the diameter of the tool",
        "the tool table must hold twice the wear, and no diameter",
    ],
    // Switchable kinematics: linuxcnc.org; bridgemill/5axis.ini begins in 5axiskins.
    may_begin_in_tip_control: true,
    // interp_convert.cc: TOLERANCE_CONCAVE_CORNER is 0.05 rad. interp_queue.cc, move_endpoint_and_flush: an arc that
    // becomes longer by more stops the program; measured with the interpreter of 2.9.
    straight_corners: Some(StraightCorners { largest_rad: 0.05, longer_rad: [0.0254, 0.001] }),
    preselect: false,
    // LinuxCNC documentation, M codes, M6: with tool 0 there is no tool in the spindle after it.
    empty_spindle_note: "",
    retracts: &[MachineRetract::to_machine_coordinate("G53"), MachineRetract::to_reference_position(false)],
    // G43 moves nothing, and G53 leaves it in force.
    length: LengthCodes {
        call: LengthCall::Alone,
        off: "",
        cancelled_by_machine_coordinates: false,
        ..LengthCodes::ISO
    },
    rotary_note: "the axes must not be wrapped (WRAPPED_ROTARY = 0)",
    examples: &[
        ("control.safety", r#"["{units} G8 G17 G40 G49 G80 G90 G91.1 G94 G97 {work_offset} G64 P{path_tolerance}"]"#),
        ("control.coolant", r#"{ through = ["M64 P2", "M65 P2"] }"#),
        ("control.effects", r#"{ "M110" = "none" }"#),
        ("cycles.probe", r#"{ "PROBE/BORE,20" = ["o<probe_bore> call [20]"] }"#),
        ("cycles.measure_tool", r#"["o<measure_tool> call [{tool}]"]"#),
        ("cycles.check_tool", r#"["o<check_tool> call [{tool}]"]"#),
        ("cl.words", r#"{ "CHUCK/OPEN" = "M110" }"#),
        ("program.operation_start", r#"["M131"]"#),
        ("program.operation_end", r#"["M133"]"#),
        ("start", r#"["M131"]"#),
        ("end", r#"["M133"]"#),
        ("clamp", r#"{ on = "M64 P0", off = "M65 P0" }"#),
        ("clamp", r#"{ on = "M64 P1", off = "M65 P1" }"#),
    ],
    unused_keys: &[
        "control.program_number",
        "control.states",
        "control.smoothing_levels",
        "control.functions",
        "control.swivel_data",
        "control.plane_by",
        "cycles.bore_retract",
        "cycles.bore_shift",
    ],
    found_at: &[
        FoundAt {
            key: "part_origin",
            place: "the work offset of the part (`#5221` to `#5223` for G54) less that of the reference point of the \
                    table, both touched off with the same tool and with the rotary axes at zero",
            source: "linuxcnc.org, G-code overview",
        },
        FoundAt {
            key: "machine_zero",
            place: "the work offset of the part (`#5221` to `#5223` for G54), if the lengths in the tool table are \
                    counted from the gauge line",
            source: "linuxcnc.org, G-code overview",
        },
        FoundAt {
            key: "tools",
            place: "Z of the tool table, if it is counted from the gauge line",
            source: "linuxcnc.org, tool compensation",
        },
        FoundAt {
            key: "dimensions",
            place: "the pins of the kinematics (`halcmd show pin kins`), on xyzac-trt-kins x-rot-point to \
                    z-rot-point, y-offset and z-offset; `kinematics --linuxcnc` writes a module with the dimensions \
                    of this file",
            source: "linuxcnc.org, 5-axis kinematics",
        },
        FoundAt {
            key: "limits",
            place: "MIN_LIMIT and MAX_LIMIT of [AXIS_X] to [AXIS_C] in the INI file",
            source: "linuxcnc.org, INI configuration",
        },
        FoundAt {
            key: "speeds",
            place: "MAX_VELOCITY of [AXIS_X] to [AXIS_C] in the INI file, times 60: it is per second",
            source: "linuxcnc.org, INI configuration",
        },
        FoundAt {
            key: "control.tip_control",
            place: "the M-codes of the REMAP lines in the INI file that switch the kinematics",
            source: "linuxcnc.org, switchable kinematics",
        },
    ],
    ..Spellings::ISO
};

/// Labels of the guards of the work offset come after those of the lengths, which are numbers of restart points.
const OFFSET_GUARDS: u32 = 1_000_000;

impl Control for LinuxCnc {
    fn spellings(&self) -> &'static Spellings {
        &SPELLINGS
    }

    fn harmless<'a>(&self, text: &'a [u8]) -> Cow<'a, [u8]> {
        if is_order(text) { Cow::Owned([b"- ", text].concat()) } else { Cow::Borrowed(text) }
    }

    fn length_guard(&self, guard: &LengthGuard) -> Vec<String> {
        let LengthGuard { label, tool, .. } = *guard;
        if guard.offset != tool {
            // `#5403` is not the length of another register.
            return Vec::new();
        }
        let [length, tolerance] = guard.in_millimetres();
        // The table of a machine in inches holds the length in inches. No length fits in both units.
        let off = |table: &str| format!("[ABS[{table} - {length}] GT {tolerance}]");
        vec![
            format!("o{label} if [{} AND {}]", off("#5403"), off("[#5403 * 25.4]")),
            format!("(abort, T{tool} was posted with L = {length} mm: the length in the tool table differs)"),
            format!("o{label} endif"),
        ]
    }

    fn offset_guard(&self, label: u32) -> Vec<String> {
        let label = OFFSET_GUARDS + label;
        vec![
            format!("o{label} if [[#5210 NE 0] OR [#[5210 + 20 * #5220] NE 0]]"),
            "(abort, G92, G52 or a rotation lies over the work offset: G92.2, G10 L2 R0)".to_owned(),
            format!("o{label} endif"),
        ]
    }

    fn work_offset(&self, word: &str) -> Option<String> {
        let known = numbered(word, "G", 54..=59) || ["G59.1", "G59.2", "G59.3"].contains(&word);
        known.then(|| word.to_owned())
    }
}

/// Whether a comment would be a command: it begins with a word and a comma, as `(MSG,`, `(PRINT,`, `(LOGOPEN,` and
/// `(AXIS,` do, or with one of two words that need no comma.
fn is_order(text: &[u8]) -> bool {
    let text = text.trim_ascii_start();
    let end = text.iter().position(|byte| !byte.is_ascii_alphanumeric() && *byte != b'_').unwrap_or(text.len());
    let (word, rest) = text.split_at(end);
    rest.trim_ascii_start().starts_with(b",")
        || word.eq_ignore_ascii_case(b"probeclose")
        || word.eq_ignore_ascii_case(b"logclose")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::program::Units;

    fn comment(text: &str) -> String {
        let mut line = Vec::new();
        LinuxCnc.comment(text.as_bytes(), &mut line);
        String::from_utf8(line).expect("ASCII")
    }

    #[test]
    fn a_comment_cannot_end_early_or_hold_other_bytes_than_ascii() {
        assert_eq!(comment("A) M3 S9999 (B"), "(A] M3 S9999 [B)");
        assert_eq!(comment("50 % ; x"), "(50 _ ; x)");
        assert_eq!(comment("a\tb\r\nc"), "(a b??c)");
        assert_eq!(comment("Fräser"), "(Fr??ser)");
    }

    #[test]
    fn the_length_guard_compares_with_the_table_in_either_unit() {
        let guard = LengthGuard {
            label: 3,
            tool: 12,
            offset: 12,
            length_mm: 4.5 * 25.4,
            tolerance_mm: 0.01,
            units: Units::Inches,
        };
        let blocks = LinuxCnc.length_guard(&guard);
        let condition = "o3 if [[ABS[#5403 - 114.3] GT 0.01] AND [ABS[[#5403 * 25.4] - 114.3] GT 0.01]]";
        let message = "(abort, T12 was posted with L = 114.3 mm: the length in the tool table differs)";
        assert_eq!(blocks, [condition, message, "o3 endif"]);
    }

    #[test]
    fn a_comment_is_never_an_order_to_the_control() {
        assert_eq!(comment("MSG, hello"), "(- MSG, hello)");
        assert_eq!(comment("  logopen,/tmp/x"), "(-   logopen,/tmp/x)");
        assert_eq!(comment("Probeclose"), "(- Probeclose)");
        assert_eq!(comment("py ,x"), "(- py ,x)");
        assert_eq!(comment("D 10, R 2"), "(D 10, R 2)");
        assert_eq!(comment("FACE: D10, R2"), "(FACE: D10, R2)");
    }
}
