//! Length guards are recognised as a whole, or are faults.

use super::*;

const FANUC: &str = "G21\nIF [ABS[#10021+#11021-114.3] GT 0.01] THEN #3000=101 (T12 IS NOT 114.3 LONG)\n";
const HAAS: &str = "G21\nIF [ABS[#2021 + #2221 - 114.3] GT 0.01] THEN #3000= 101 (T12 IS NOT 114.3 LONG)\n";
const LINUX: &str = "o3 if [[ABS[#5403 - 114.3] GT 0.01] AND [ABS[[#5403 * 25.4] - 114.3] GT 0.01]]\n(abort, T12 differs)\n\
    o3 endif\n";
const SIEMENS_GUARD: &str = "G710\nIF ABS($P_TOOLL[1]-114.3)>0.01\nMSG(\"T12 differs\")\nM0\nM30\nENDIF\n";
const TNC_GUARD: &str = "0 FN 18: SYSREAD QL1 = ID50 NR1 IDX12\n1 FN 18: SYSREAD QL2 = ID50 NR4 IDX12\n\
    2 FN 1: QL1 = +QL1 + +QL2\n3 FN 12: IF +QL1 LT +114.29 GOTO LBL \"OFF3\"\n\
    4 FN 12: IF +QL1 LT +114.31 GOTO LBL \"FITS3\"\n5 LBL \"OFF3\"\n6 ; T12 differs\n7 FN 14: ERROR = 100\n8 LBL \"FITS3\"\n";

/// A guard and changes of its text.
type Changes<'a> = (Family, &'a str, &'a [(&'a str, &'a str)]);

fn guards(family: Family, text: &str) -> Vec<Guard> {
    read(family, text).into_iter().filter_map(|block| block.guards.length).collect()
}

#[test]
fn a_guard_has_its_length_tolerance_and_source() {
    let wanted = [
        (Family::Fanuc, FANUC, LengthSource::Register(21)),
        (Family::Haas, HAAS, LengthSource::Register(21)),
        (Family::LinuxCnc, LINUX, LengthSource::Spindle),
        (Family::Siemens, SIEMENS_GUARD, LengthSource::Edge),
        (Family::Heidenhain, TNC_GUARD, LengthSource::Tool(12)),
    ];
    for (family, text, source) in wanted {
        assert_eq!(faults(family, text), [""; 0], "{family:?}");
        let guard = Guard { length_mm: 114.3, tolerance_mm: 0.01, source, stops: true };
        assert_eq!(guards(family, text), [guard], "{family:?}");
    }
    let inches = guards(Family::Fanuc, &FANUC.replace("G21", "G20").replace("114.3]", "4.5]"));
    assert!((inches[0].length_mm - 114.3).abs() < 1e-9);
}

#[test]
fn a_guard_with_other_numbers_has_these_numbers() {
    let tolerance = |family: Family, text: &str| guards(family, text).first().map(|guard| guard.tolerance_mm);
    assert_eq!(tolerance(Family::Fanuc, &FANUC.replace("GT 0.01", "GT 99")), Some(99.0));
    let other = FANUC.replace("10021", "10005").replace("11021", "11005");
    assert_eq!(guards(Family::Fanuc, &other)[0].source, LengthSource::Register(5));
    assert_eq!(guards(Family::Heidenhain, &TNC_GUARD.replace("IDX12", "IDX7"))[0].source, LengthSource::Tool(7));
    assert_eq!(tolerance(Family::LinuxCnc, &LINUX.replace("0.01", "50")), Some(50.0));
}

#[test]
fn a_guard_that_is_not_complete_or_does_not_stop_is_a_fault() {
    let wrong: &[Changes] = &[
        (
            Family::Fanuc,
            FANUC,
            &[
                ("#11021", "#11022"),
                ("#3000=101", "#3000=0"),
                ("THEN #3000=101 (T12 IS NOT 114.3 LONG)", "GOTO 2"),
                ("GT", "LT"),
                ("ABS", "SIN"),
                ("#3000=101", "#3001=101"),
                ("IF", "N5 IF"),
                ("-114.3", "-#5"),
                ("(T12 IS NOT 114.3 LONG)", "G0 X5."),
            ],
        ),
        (
            Family::LinuxCnc,
            LINUX,
            &[
                ("(abort", "(msg"),
                ("(abort, T12 differs)\n", ""),
                ("o3 endif", "o4 endif"),
                ("o3 endif\n", "G0 X5\n"),
                ("o3 if", "/o3 if"),
                ("(abort", "/(abort"),
                ("AND", "OR"),
                ("- 114.3] GT 0.01] AND", "- 14.3] GT 0.01] AND"),
                ("#5403 -", "#5404 -"),
                ("0.01]]", "0.02]]"),
                ("o3 if", "o3 while"),
                ("differs)", "differs) G0 X5"),
            ],
        ),
        (
            Family::Siemens,
            SIEMENS_GUARD,
            &[
                ("M0\nM30\n", ""),
                ("M0", "G0 X5"),
                ("[1]", "[2]"),
                (">", "<"),
                ("ENDIF", "ENDIF G0 X5"),
                ("M0", "M1"),
                ("IF ABS", "/IF ABS"),
                ("ENDIF", "/ENDIF"),
                ("0.01", "R1"),
                ("M30", "MSG(\"A\") G0 X5"),
            ],
        ),
        (
            Family::Heidenhain,
            TNC_GUARD,
            &[
                ("QL2 = ID50", "QL2 = ID51"),
                ("NR4 IDX12", "NR4 IDX13"),
                ("QL1 = +QL1 + +QL2", "QL1 = +QL1 + +QL1"),
                ("5 LBL \"OFF3\"", "5 LBL \"FITS3\""),
                ("FN 14: ERROR = 100", "M8"),
                ("8 LBL \"FITS3\"", "8 LBL \"FITS4\""),
                ("+114.31", "+114.28"),
                ("4 FN 12: IF +QL1 LT +114.31 GOTO LBL \"FITS3\"", "4 L X+5 FMAX"),
                ("SYSREAD QL1", "SYSREAD Q201"),
            ],
        ),
    ];
    for (family, text, changes) in wrong {
        for (from, to) in *changes {
            let changed = text.replacen(from, to, 1);
            assert_ne!(changed, *text, "{from}");
            // A guard that has not ended is a fault of the next block.
            let changed = format!("{changed}{}", if *family == Family::Heidenhain { "9 M8\n" } else { "M8\n" });
            assert!(!faults(*family, &changed).is_empty(), "{family:?}: {to}\n{changed}");
        }
    }
}

const SIEMENS_PLANE: &str = "G710\nIF ABS(SIN(($AA_IW[C]-30)/2))+ABS(SIN(($AA_IW[B]+20.5)/2))>0.0009\nMSG(\"no\")\nM0\nM30\n\
    ENDIF\n";
const TNC_PLANE: &str = "0 FN 20: WAIT FOR SYNC\n1 FN 18: SYSREAD QL1 = ID270 NR1 IDX6\n2 FN 18: SYSREAD QL2 = ID270 NR1 IDX5\n\
    3 QL3 = ABS ( SIN ( ( QL1 - 30 ) / 2 ) ) + ABS ( SIN ( ( QL2 + 20.5 ) / 2 ) )\n\
    4 FN 12: IF +QL3 LT +0.0009 GOTO LBL \"PLANE3\"\n5 ; no\n6 FN 14: ERROR = 101\n7 LBL \"PLANE3\"\n";

#[test]
fn a_guard_of_rotary_positions_has_its_axes_and_positions() {
    for (family, text) in [(Family::Siemens, SIEMENS_PLANE), (Family::Heidenhain, TNC_PLANE)] {
        assert_eq!(faults(family, text), [""; 0], "{family:?}");
        let guards: Vec<_> = read(family, text).into_iter().filter_map(|block| block.guards.plane).collect();
        assert_eq!(guards.len(), 1, "{family:?}");
        // C is the first axis of the chain, B the second.
        let positions = [Some((0, 30_f64.to_radians())), Some((1, -20.5_f64.to_radians()))];
        assert_eq!((guards[0].positions, guards[0].largest), (positions, 0.0009), "{family:?}");
    }
}

#[test]
fn a_guard_of_rotary_positions_that_is_not_complete_is_a_fault() {
    let wrong: &[Changes] = &[
        (
            Family::Siemens,
            SIEMENS_PLANE,
            &[
                ("M0\nM30\n", ""),
                ("[C]", "[X]"),
                ("[B]", "[C]"),
                ("[B]", "[Q]"),
                ("/2", "/3"),
                ("SIN", "COS"),
                ("ABS", "POT"),
                ("-30", "*30"),
                ("-30", "-R1"),
                ("-30", "--30"),
                (">", "<"),
                (">0.0009", ">0"),
                ("))+A", "))-A"),
                ("_IW", "_IM"),
                ("ENDIF", "ENDIF M8"),
            ],
        ),
        (
            Family::Heidenhain,
            TNC_PLANE,
            &[
                ("0 FN 20: WAIT FOR SYNC", "0 M8"),
                ("QL1 = ID270", "QL1 = ID240"),
                ("NR1 IDX6", "NR2 IDX6"),
                ("IDX6", "IDX1"),
                ("IDX6", "IDX12"),
                ("QL3 =", "QL4 ="),
                ("QL1 - 30", "QL2 - 30"),
                ("QL1 - 30", "QL1 * 30"),
                ("/ 2", "/ 3"),
                (") + ABS ( SIN ( ( QL2 + 20.5 ) / 2 ) )", ")"),
                ("LT +0.0009", "LT +QL1"),
                ("LT", "GT"),
                ("7 LBL \"PLANE3\"", "7 LBL \"PLANE4\""),
                ("6 FN 14: ERROR = 101", "6 M8"),
            ],
        ),
    ];
    for (family, text, changes) in wrong {
        for (from, to) in *changes {
            let changed = text.replacen(from, to, 1);
            assert_ne!(changed, *text, "{from}");
            let changed = format!("{changed}{}", if *family == Family::Heidenhain { "8 M8\n" } else { "M8\n" });
            assert!(!faults(*family, &changed).is_empty(), "{family:?}: {to}\n{changed}");
        }
    }
}

#[test]
fn a_comment_in_a_guard_does_nothing() {
    let text = SIEMENS_GUARD.replace("MSG", "; MSG");
    assert_eq!((guards(Family::Siemens, &text).len(), faults(Family::Siemens, &text)), (1, Vec::new()));
}

#[test]
fn a_jump_over_an_alarm_leads_to_the_block_after_it() {
    let text = "G21\nIF [ABS[#11001-101.5] LT 0.01] GOTO 5\n#3000=1 (LENGTH)\nN5 G0 X5.\n";
    let guard = Guard { length_mm: 101.5, tolerance_mm: 0.01, source: LengthSource::Variable(11_001), stops: true };
    assert_eq!((guards(Family::Fanuc, text), faults(Family::Fanuc, text)), (vec![guard], Vec::new()));
    for (from, to) in [
        ("N5", "N6"),
        ("#3000=1 (LENGTH)", "G0 Z-5."),
        ("LT", "GT"),
        ("#3000=1 (LENGTH)\n", ""),
        ("N5 G0 X5.", "G0 X5."),
    ] {
        assert!(!faults(Family::Fanuc, &text.replacen(from, to, 1)).is_empty(), "{to}");
    }
}
