//! Form of a line: block number, block delete, comments, contradictory codes, whole numbers.

use super::*;

const PLAIN: &str = "G21 G17 G40 G49 G80 G90 G94 G54\nG0 X0. Y0. Z5. B0. C0.\n";

/// Faults of a line after a program in which nothing is wrong.
fn of(family: Family, line: &str) -> Vec<String> {
    let (head, number) = match family {
        Family::Siemens => (SIEMENS, ""),
        Family::Heidenhain => (TNC, "2 "),
        Family::LinuxCnc | Family::Fanuc | Family::Haas => (PLAIN, ""),
    };
    assert_eq!(faults(family, head), [""; 0], "{family:?}");
    faults(family, &format!("{head}{number}{line}\n"))
}

fn refused(family: Family, lines: &[&str], part: &str) {
    for line in lines {
        let found = of(family, line);
        assert!(found.iter().any(|text| text.contains(part)), "{family:?}: {line}: {found:?}");
    }
}

fn accepted(family: Family, lines: &[&str]) {
    for line in lines {
        assert_eq!(of(family, line), [""; 0], "{family:?}: {line}");
    }
}

#[test]
fn a_block_number_is_the_first_word_of_its_block() {
    for family in [Family::LinuxCnc, Family::Fanuc, Family::Haas] {
        refused(family, &["G80 N305", "X5. N5", "M5 N30", "G1 X5. F9. N1", "(A) M5 N5"], "after the first word");
        refused(family, &["N5 N6 G0 X5."], "two N words");
        refused(family, &["N3.06 G0 X5.", "N-4 G0 X5."], "no whole number");
        accepted(family, &["N5 G0 X5.", "N5", "N0", "  N5 X5."]);
        assert!(last(family, "/N5 G0 X5.").skippable && !last(family, "N5 G0 X5.").skippable);
        refused(family, &["/2 G0 X5."], "block skip with a number");
        refused(family, &["//G0 X5.", "G0 / X5."], "is not a word");
    }
    for family in [Family::Fanuc, Family::Haas] {
        refused(family, &["N5. G0 X5."], "no whole number");
        accepted(family, &["(A) N5 G0 X5."]);
    }
    accepted(Family::LinuxCnc, &["N5. G0 X5."]);
    refused(Family::Siemens, &["CYCLE800() N610", "T1 N30", "M5 N9", "X1 N5"], "after the first word");
    refused(Family::Siemens, &["N5 N6"], "two N words");
    refused(Family::Siemens, &["N3.06", "N-4"], "no whole number");
    accepted(Family::Siemens, &["N5 G0 X5", "N5 T1"]);
    refused(Family::Heidenhain, &["L X+5 R0 FMAX N5", "N5 L X+5 R0 FMAX"], "not known");
    assert_eq!(last(Family::Fanuc, "N17 G80").number, Some(17));
}

#[test]
fn block_skip_without_a_block_is_a_fault() {
    for family in [Family::LinuxCnc, Family::Fanuc, Family::Haas, Family::Siemens] {
        refused(family, &["/", "  /", "/ "], "block skip without a block");
    }
    assert!(!of(Family::Heidenhain, "/").is_empty());
}

#[test]
fn a_length_code_has_its_register() {
    for (family, codes) in [
        (Family::LinuxCnc, &["G43", "G43 Z5."][..]),
        (Family::Fanuc, &["G43", "G43 Z5.", "G43.4", "G43.5 P1"]),
        (Family::Haas, &["G43 Z5.", "G234"]),
    ] {
        refused(family, codes, "H is missing");
        // A register that is in force changes nothing.
        for code in codes {
            let found = faults(family, &format!("{PLAIN}G43 H3 Z5.\n{code}\n"));
            assert!(found.iter().any(|text| text.contains("H is missing")), "{family:?}: {code}");
        }
    }
    assert_eq!(last(Family::Fanuc, &format!("{PLAIN}G43 H0")).state.length, Some(Length::Off));
    refused(Family::LinuxCnc, &["G43 H0"], "register 0");
}

#[test]
fn coolant_is_not_switched_on_and_off_in_one_block() {
    refused(Family::Haas, &["M09 M88", "M8 M89"], "on and off in one block");
    for family in [Family::LinuxCnc, Family::Fanuc, Family::Haas, Family::Siemens, Family::Heidenhain] {
        refused(family, &["M8 M9"], "on and off in one block");
    }
    refused(Family::Heidenhain, &["M13 M9"], "on and off in one block");
}

#[test]
fn a_block_has_as_many_m_codes_as_the_control_executes() {
    for family in [Family::Fanuc, Family::Haas] {
        refused(
            family,
            &["S500 M3 M8", "M5 M9", "M7 M8", "M3 M3"],
            if family == Family::Fanuc { "two M codes" } else { "M" },
        );
    }
    refused(Family::LinuxCnc, &["M7 M8", "M3 M3", "M0 M30"], "another code of its group");
    accepted(Family::LinuxCnc, &["S500 M3 M8", "M5 M9"]);
    accepted(Family::Siemens, &["S500 M3 M8", "M7 M8"]);
    accepted(Family::Heidenhain, &["M3 M8"]);
    for line in ["M3 M3", "M5 M3", "M30 M17", "TRAORI TRAFOOF", "ORIWKS ORIMKS", "ORIAXES ORIVECT"] {
        refused(Family::Siemens, &[line], "another code of its group");
    }
}

#[test]
fn a_code_that_acts_in_its_block_alone_has_no_other_beside_it() {
    refused(Family::Siemens, &["G4 F1.5 SUPA", "G4 F1 G53", "SUPA G53 G0 Z0"], "another code of its group");
    refused(Family::Siemens, &["G0 G4 F1.5", "G4 F1 G1"], "motion code in a block with a dwell");
    for family in [Family::LinuxCnc, Family::Fanuc, Family::Haas] {
        let dwell = if family == Family::Haas { "G4 P0.5" } else { "G4 P5" };
        refused(family, &[&format!("G0 {dwell}"), &format!("{dwell} G3")], "motion code in a block with a dwell");
        refused(family, &[&format!("{dwell} G53"), &format!("G28 {dwell}")], "another code of its group");
    }
    refused(Family::LinuxCnc, &["G0 G28 Z0."], "reference motion");
    refused(Family::LinuxCnc, &["G3 M0", "G2 M1", "M30 G3"], "an arc without its words");
    accepted(Family::Fanuc, &["G0 G28 Z0."]);
}

#[test]
fn f_and_s_are_numbers_that_can_be_executed() {
    refused(Family::Siemens, &["F0", "G1 X5 F0", "F-5", "S-5"], "");
    refused(Family::Fanuc, &["F0.", "G1 X5. F-9."], "F is not above 0");
    refused(Family::Heidenhain, &["L X+5 R0 F0"], "F is not above 0");
    refused(Family::LinuxCnc, &["G4 P-1"], "negative");
    refused(Family::Siemens, &["G602", "G603"], "not known");
    accepted(Family::Siemens, &["G601", "G4 F1.5"]);
    refused(Family::Haas, &["S0 M03", "G00 S0"], "S is not above 0");
}

#[test]
fn a_spindle_starts_with_the_s_of_its_operation() {
    let none = "no S has been programmed since the complete state";
    let found = |text: &str| faults(Family::LinuxCnc, text).iter().filter(|fault| fault.contains(none)).count();
    assert_eq!(found("M3\n"), 1);
    assert_eq!(found("S900 M3\nM5\nM4\n"), 0);
    assert_eq!(found("S900 M3\nG21 G17 G40 G49 G80 G90 G94 G54\nM3\nS900\nM3\n"), 1);
}

#[test]
fn a_number_that_counts_is_whole() {
    refused(
        Family::Haas,
        &["G187 P1.5", "G154 P1.5", "T1.5", "G43 H1.5 Z5.", "G268 X0. Y0. Z0. I0. J0. K0. Q12.5"],
        "",
    );
    refused(Family::Fanuc, &["G54.1 P1.5", "G5.1 Q0.5", "G43.4 H1 P0.5", "D1.5"], "");
    refused(Family::LinuxCnc, &["G2 X5 I2.5 P1.5 F9", "T1.5"], "");
    let swivel = |mode: &str, direction: &str| format!("CYCLE800(0,\"TC\",0,{mode},0,0,0,30,0,0,0,0,0,{direction},0)");
    accepted(Family::Siemens, &[&swivel("57", "1")]);
    let texts = [swivel("57.5", "1"), swivel("57", "1.5")];
    refused(Family::Siemens, &[&texts[0], &texts[1], "CYCLE832(0.01,1.5)", "T1.5", "D1.5"], "");
    refused(
        Family::Siemens,
        &["CYCLE83(25,0,2,-10,,,3,0,0,,1,0.5)", "CYCLE84(25,0,2,-10,,0,3.5,,1,0,500,500)"],
        "whole number",
    );
    refused(Family::Heidenhain, &["CYCL DEF 247 DATUM SETTING ~\n Q339=+1.5 ;A"], "whole number");
    refused(Family::Heidenhain, &["CYCL DEF 247.04 DATUM SETTING ~\n Q339=+1 ;A"], "not known");
    refused(Family::Heidenhain, &["TOOL CALL 1.5 Z S100", "TOOL DEF 1.5"], "not known");
    accepted(Family::Heidenhain, &["CYCL DEF 247 DATUM SETTING ~\n Q339=+1 ;A"]);
}

#[test]
fn m29_is_followed_by_its_thread() {
    let thread = "G98 G84 X1. Y2. Z-10. R2. F500.\n";
    let program = |text: &str| faults(Family::Fanuc, &format!("{PLAIN}S500 M3\n{text}"));
    for text in [format!("M29 S500\n{thread}X9.\nG80\n"), format!("M29 S500\n\n(A)\n{}", thread.replace("G84", "G74"))]
    {
        assert_eq!(program(&text), [""; 0], "{text}");
    }
    for text in [
        format!("M29\n{thread}"),
        format!("M29 S500\nG0 X5.\n{thread}"),
        format!("M29 S500\nM8\n{thread}"),
        format!("M29 S500\nM77\n{thread}"),
        format!("M29 S500\n{}", thread.replace("G84", "G81")),
        "M29 S500\nM30\n".to_owned(),
        format!("M29 S500 G80\n{thread}"),
        format!("M29 S500 X5.\n{thread}"),
        format!("M29 S500 G90\n{thread}"),
        format!("M29 S500 F100.\n{thread}"),
        "M29 S500\n%\n".to_owned(),
    ] {
        assert!(!program(&text).is_empty(), "{text}");
    }
}

#[test]
fn words_beside_axis_words_are_read_in_blocks_without_a_code_too() {
    for family in [Family::LinuxCnc, Family::Fanuc, Family::Haas] {
        let of = |line: &str| faults(family, &format!("{PLAIN}G1 X1. F100.\n{line}\n"));
        assert_eq!(of("N7 X5. S500 F200."), [""; 0], "{family:?}");
        for line in ["X5. P1", "X5. Q1.", "X5. R2.", "X5. I1.", "X5. H3", "X5. D3", "X5. E1."] {
            assert!(!of(line).is_empty(), "{family:?}: {line}");
        }
        let arc = last(family, &format!("{PLAIN}G2 X10. Y0. I5. J0. F100.\nX0. Y0. R5.\n"));
        assert!(matches!(arc.action, Action::Arc(_)), "{family:?}: {arc:?}");
    }
    assert!(!of(Family::LinuxCnc, "X5. T3").is_empty());
    assert_eq!(last(Family::Fanuc, &format!("{PLAIN}X5. T3\n")).state.selected, Some(3));
}
