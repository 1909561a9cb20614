//! Lines of axis words and F, which are read in one pass.

use super::*;

/// Lines after a start, read as they are and with a comment that keeps them from being read in one pass.
fn assert_alike(family: Family, start: &str, lines: &[&str]) {
    let program = |comment: &str| {
        let lines: String = lines.iter().map(|line| format!("{line}{comment}\n")).collect();
        read(family, &format!("{start}{lines}"))
    };
    let (plain, commented) = (program(""), program(" (A)"));
    assert_eq!(plain.len(), commented.len(), "{family:?}");
    for (plain, commented) in plain.iter().zip(&commented) {
        // The text of a fault may show the rest of its line.
        let mut commented = commented.clone();
        commented.faults.iter_mut().for_each(|fault| fault.text = fault.text.replace(" (A)", ""));
        assert_eq!(*plain, commented, "{family:?} {start} {lines:?}");
    }
}

#[test]
fn lines_of_words_are_read_alike_in_one_pass_and_word_by_word() {
    let start = "G21 G17 G40 G49 G80 G90 G94 G54\n";
    let lines = [
        "G0 X1. Y2. Z3. B0. C0.",
        "G1 X1.5 F100.",
        "X2.25 Y-3. Z-0.125 B12.5 C-370.0001 F1250.5",
        "N10 X3. Y.5",
        "N0011 Z-.25 F.5",
        "X4.Y5.",
        "X 5. Y6.",
        " X6.\tY7. ",
        "x7. y8.",
        "X8 Y9.",
        "X+9. Y-0.",
        "F75.",
        "X1. F0.",
        "X1. F-5.",
        "X1. X2.",
        "F1. X1. F2.",
        "X1. N10",
        "N10. X1.",
        "N-1 X1.",
        "N1 N2 X1.",
        "N99999999999 X1.",
        "X1.2.3",
        "X.",
        "X1. Y",
        "X1234567890123.123456",
        "X12345678901234567890.",
        "X1. I2.",
        "X1. A3.",
        "X1. S500",
        "X1. M8",
        "/ X1. Y2.",
        "X1. = Y2.",
        "X1.#2",
    ];
    for family in [Family::LinuxCnc, Family::Fanuc, Family::Haas] {
        assert_alike(family, start, &lines);
        for line in lines {
            assert_alike(family, start, &["G0 X0. Y0. Z0. B0. C0.", "G1 F200.", line, "X1. Y1. F300."]);
            // In a cycle a word is a hole, under inverse-time feed F holds for its block, and words may be distances.
            assert_alike(family, start, &["G0 X0. Y0. Z9. B0. C0.", "G98 G81 Z-5. R2. F100.", line, "G80", line]);
            assert_alike(family, start, &["G0 X0. Y0. Z9. B0. C0.", "G93", "G1 X1. F5.", line, "G94", line]);
            assert_alike(family, start, &["G0 X0. Y0. Z9. B0. C0.", "G91", line, line, "G90", line]);
            assert_alike(family, start, &[line]);
        }
    }
}
