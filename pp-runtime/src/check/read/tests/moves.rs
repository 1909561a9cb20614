//! Lines of axis words and F, which are read in one pass.

use super::*;

/// Lines after a start, read as they are and with a comment that keeps them from being read in one pass.
fn assert_alike(family: Family, start: &str, lines: &[&str]) {
    let program = |comment: &str| {
        let lines: String = lines.iter().map(|line| format!("{line}{comment}\n")).collect();
        read(family, &format!("{start}{lines}"))
    };
    let (plain, commented) = (program(""), program(" (A)"));
    assert_eq!(plain.len(), commented.len(), "{family:?} {start} {lines:?}");
    for (plain, commented) in plain.iter().zip(&commented) {
        // The text of a fault may show the rest of its line.
        let mut commented = commented.clone();
        commented.faults.iter_mut().for_each(|fault| fault.text = fault.text.replace(" (A)", ""));
        // That a block only moves permits a shortcut, which a line with a comment need not take.
        assert!(plain.only_moves || !commented.only_moves, "{family:?} {start} {lines:?}");
        commented.only_moves = plain.only_moves;
        assert_eq!(*plain, commented, "{family:?} {start} {lines:?}");
    }
}

#[test]
fn lines_of_an_arc_in_force_are_read_alike_in_one_pass_and_word_by_word() {
    let start = "G21 G17 G40 G49 G80 G90 G94 G54\nG0 X10. Y0. Z0. B0. C0.\n";
    let lines = [
        "X0. Y-10. I-10. J0.",
        "N20 X0. Y-10. Z-1. I-10. J0. F50.",
        "X0. Y10. I-10.",
        "Y-10. X0. J0. I-10.",
        "X0. Y10. R10.",
        "X0. Y10. I-10. R10.",
        "X10. Y0. I-10. P2",
        "X0. Y-10. I-10. J0. K0.",
        "X0. Y-10. I-10. I-10.",
        "X0. Y-10. I-10. J",
        "X0. Y-10. I-10 J0",
        "X0. Y-10. I-9. J0.",
        "I-10. J0.",
        "X0. Y-10.",
        "X0. Y-10. I-10. J0. S500",
        "X0. Y-10. I-10. J0. M8",
        "G1 X0. I1.",
    ];
    for family in [Family::LinuxCnc, Family::Fanuc, Family::Haas] {
        for line in lines {
            for code in [
                "G3 X-10. Y0. I-10. J0. F100.",
                "G2 X-10. Y0. R10. F100.",
                "G1 X1. F100.",
                "G18 G3 X-10. Z0. I-10. K0. F100.",
            ] {
                let turned = line.replace("I-10", "I10").replace("I-9", "I9");
                assert_alike(family, start, &[code, &turned, "X3. Y4.", "G1 X3.", line]);
                assert_alike(family, start, &[code, "G91", &turned, "G90", &turned]);
                assert_alike(family, start, &[code, "G43.5 H1", &turned, "G49", &turned]);
                assert_alike(family, start, &[code, "G0 X10. Y0. Z0.", line, "G80", line]);
            }
        }
    }
}

#[test]
fn a_line_of_an_arc_in_force_only_moves() {
    let start = "G21 G17 G40 G49 G80 G90 G94 G54\nG0 X10. Y0. Z0. B0. C0.\nG3 X-10. Y0. I-10. J0. F100.\n";
    for family in [Family::LinuxCnc, Family::Fanuc, Family::Haas] {
        let last = |line: &str| read(family, &format!("{start}{line}\n")).pop().expect("a block");
        let plain = last("X0. Y-10. I10. J0.");
        assert!(plain.only_moves && plain.faults.is_empty(), "{family:?}: {plain:?}");
        let Action::Arc(arc) = plain.action else { panic!("{family:?}: {plain:?}") };
        assert!(arc.centre[0].abs() < 1e-12 && (arc.sweep - std::f64::consts::FRAC_PI_2).abs() < 1e-12, "{arc:?}");
        // No arc follows from words that are a tool axis, and nothing else is in force where I and J have no meaning.
        assert!(!last("X0. Y-10. I10. J0. K1.").faults.is_empty(), "{family:?}");
        assert!(!last("G1 X0. Y-10.\nX1. I10.").faults.is_empty(), "{family:?}");
    }
    // Under G43.5 I and J of a line without a code are the tool axis.
    let vectors = "G43.5 H1 Z0.\nG0 X10. Y0. Z0. I0. J0. K1.\nG3 X-10. Y0. I-10. J0. F100.\nX0. Y-10. I10. J0.\n";
    let blocks = read(Family::Fanuc, &format!("{start}{vectors}"));
    assert_eq!(blocks.last().map(|block| block.action), Some(Action::Feed), "{blocks:?}");
}

#[test]
fn holes_that_are_drilled_again_are_read_alike_in_one_pass_and_word_by_word() {
    let start = "G21 G17 G40 G49 G80 G90 G94 G54\nM3 S1000\nG0 X10. Y0. Z9. B0. C0.\n";
    let cycles = [
        "G98 G81 Z-5. R2. F100.",
        "G99 G82 X1. Y2. Z-5. R2. P500 F100.",
        "G98 G83 Z-5. R2. Q1. F100.",
        "G98 G84 Z-5. R2. F1000.",
        "G95 G98 G74 Z-5. R2. F1.",
        "G98 G86 Z-5. R2. F100.",
        "G18 G98 G81 Y-5. R2. F100.",
        "G98 G81 Z-5. F100.",
        "G98 G81 R2. F100.",
        "M29 S500",
    ];
    let between = [
        "X5. Y6.",
        "N10 X5. Y6.",
        "X5.",
        "X5. B30.",
        "X5. Z-6.",
        "Z-6.",
        "X5. F50.",
        "F50.",
        "S500",
        "X5. S500",
        "R3.",
        "X5. R3.",
        "Q2.",
        "X5. Q2.",
        "P300",
        "G91",
        "X5. I1.",
        "G99",
        "G18",
        "G4 P100",
        "M8",
        "X5. X6.",
        "X",
        "(A)",
        "G43 H1",
        "G80",
        "G0 X3.",
        "G20",
        "M0",
        "/ X5. Y6.",
        "/ X5. Z-6.",
        "G93",
        "G94",
        "G95 X5.",
        "G94 X5.",
        "G93 X5. F10.",
        "G21 G98 X5.",
        "G18 X5.",
    ];
    for family in [Family::LinuxCnc, Family::Fanuc, Family::Haas] {
        for cycle in cycles {
            for line in between {
                assert_alike(family, start, &[cycle, "X1. Y1.", line, "X2. Y-2.", "Y7.", line, line, "G80", "X1."]);
            }
        }
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
