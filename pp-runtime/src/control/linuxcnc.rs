//! LinuxCNC.
//!
//! The program ends with M2 and has no `%` frame: a file that lost its end has no M2 and is refused by the control.
//! `G43 H` moves nothing, `G4 P` counts seconds, `G93` wants an F in every G1 block, and F in `G94` counts along X Y Z
//! wherever one of them moves. `#5403` is what the tool table says of the tool in the spindle, whatever H is in force, in
//! the unit of the machine and not in that of the program. Without a P behind `G64` it would round corners as far as speed demands.

use super::{Control, Spellings};

/// The LinuxCNC dialect.
#[derive(Debug, Clone, Copy)]
pub struct LinuxCnc;

static SPELLINGS: Spellings = Spellings {
    name: "linuxcnc",
    title: "LinuxCNC",
    opening: &[],
    end: "M2",
    line_length: 254,
    millimetres: "G21",
    inches: "G20",
    cancel: "G17 G40 G49 G80 G90",
    blending: "G64",
    blending_address: b'P',
    per_minute: "G94",
    inverse_time: "G93",
    rapid: "G0",
    feed: "G1",
    machine: "G53",
    tool_change: "M6",
    length: "G43",
    spindle: ["M3", "M4"],
    spindle_off: "M5",
    coolant_off: "M9",
    flood: Some("M8"),
    mist: Some("M7"),
    through: None,
    air: None,
    stop: ["M0", "M1"],
    dwell: "G4",
    dwell_address: b'P',
};

impl Control for LinuxCnc {
    fn spellings(&self) -> &'static Spellings {
        &SPELLINGS
    }

    fn comment(&self, text: &[u8], line: &mut Vec<u8>) {
        line.push(b'(');
        if is_order(text) {
            line.extend_from_slice(b"- ");
        }
        for &byte in text {
            line.push(match byte {
                b'(' => b'[',
                b')' => b']',
                b'%' => b'_',
                b'\t' => b' ',
                0x20..=0x7e => byte,
                _ => b'?',
            });
        }
        line.push(b')');
    }

    fn length_guard(&self, label: u32, tool: u32, length: f64, tolerance: f64) -> Vec<String> {
        let [length, tolerance] = [length, tolerance].map(|mm| (mm * 1e4).round() / 1e4);
        // The table of a machine in inches holds another number; no tool fits both ways.
        let off = |table: &str| format!("[ABS[{table} - {length}] GT {tolerance}]");
        vec![
            format!("o{label} if [{} AND {}]", off("#5403"), off("[#5403 * 25.4]")),
            format!("(abort, T{tool} was posted with L = {length} mm: the tool table says something else)"),
            format!("o{label} endif"),
        ]
    }

    fn comment_length(&self) -> usize {
        // Two brackets and the dash.
        SPELLINGS.line_length - 4
    }
}

/// `(MSG,`, `(PRINT,`, `(LOGOPEN,`, `(AXIS,` are orders: a word and a comma at the beginning. Two orders need no comma.
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
        let blocks = LinuxCnc.length_guard(3, 12, 4.5 * 25.4, 0.01);
        let condition = "o3 if [[ABS[#5403 - 114.3] GT 0.01] AND [ABS[[#5403 * 25.4] - 114.3] GT 0.01]]";
        let message = "(abort, T12 was posted with L = 114.3 mm: the tool table says something else)";
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
