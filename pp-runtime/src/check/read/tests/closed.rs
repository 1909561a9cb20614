//! What is not in the table of a control is a fault, wherever it hides.

use super::*;

const PLAIN: &str = "G21 G17 G40 G49 G80 G90 G94 G54\nG0 X0. Y0. Z5. B0. C0.\n";

fn faulty(family: Family, program: &str, texts: &[&str]) {
    for text in texts {
        let found = faults(family, &format!("{program}{text}\n"));
        assert!(!found.is_empty(), "{family:?}: {text}");
    }
}

#[test]
fn codes_that_move_change_or_repeat_and_are_not_in_the_table_are_faults() {
    for family in [Family::LinuxCnc, Family::Fanuc, Family::Haas] {
        let texts = [
            "G10 L2 P1 X1.",
            "G52 X1.",
            "G92 X0.",
            "G51 P2",
            "G68 R45.",
            "G16",
            "M98 P5",
            "M97 P5",
            "G65 P5",
            "G66 P5",
            "GOTO 5",
            "WHILE [#1 LT 5] DO1",
            "#5221=5",
            "M99",
            "G88 X1. Z-5. R2. F9.",
            "G31 Z-5. F9.",
            "G12 I5.",
            "G77",
            "G43.1 Z5.",
            "G5.2",
            "G28.1",
            "M62 P1",
            "G0 X5. L2",
            "G1 X5. F9. P1",
            "G1 X5. F9. Q1",
            "G0 X5. R1",
            "G54 P2",
            "H5",
            "D5",
            "G17 H2",
            "G0 E5.",
            "G41.1 D5",
        ];
        faulty(family, PLAIN, &texts);
    }
    let texts = [
        "R1=$AA_IW[X]",
        "TRANS X5",
        "ROT Z45",
        "AROT Z45",
        "ATRANS X1",
        "MIRROR X0",
        "SCALE X2",
        "GOTOF A",
        "REPEAT A",
        "FOR I=1 TO 5",
        "WHILE R1<5",
        "CALL \"A\"",
        "L100",
        "EXTCALL(\"A\")",
        "G110 X1",
        "G111",
        "CIP X1",
        "G33 K2",
        "G63",
        "FGROUP(X)",
        "SETAL(65000)",
        "WRITE(1)",
        "CYCLE840(5,0,1,-5)",
        "CYCLE86(5,0,1,-5)",
        "G0 X5 CR=3",
        "G1 X5 F9 TURN=2",
        "SPOS=0",
        "MSG(5)",
        "G4",
        "A: X5",
        "MCALL=5",
        "$P_UIFR[1]=5",
        "G55.5",
        "M3=3",
        "T=R1",
        "D=1.5",
    ];
    faulty(Family::Siemens, &format!("{SIEMENS}G0 X0 Y0 Z5\n"), &texts);
    let texts = [
        "CYCL DEF 7.0 DATUM SHIFT",
        "CYCL DEF 7.1 X+5",
        "CYCL DEF 8.0 MIRROR IMAGE",
        "CYCL DEF 10.0 ROTATION",
        "CYCL DEF 26.0",
        "CYCL DEF 206 TAPPING",
        "CYCL DEF 209 TAPPING",
        "CYCL DEF 240 CENTERING",
        "CALL LBL 1",
        "CALL LBL 1 REP 5",
        "CALL PGM A",
        "L X+Q1 R0 FMAX",
        "LP PR+5 PA+0",
        "CT X+5 Y+5",
        "RND R5",
        "CHF 5",
        "APPR LT X+1",
        "M98",
        "M97",
        "M103 F50",
        "M116",
        "M136",
        "M140 MB 50",
        "L X+5 R5 FMAX",
        "L X+5 DR+ FMAX",
        "L X+5 FMAX F100",
        "l x+5 r0 fmax",
        "PLANE VECTOR BX1 BY0 BZ0",
        "PLANE SPATIAL SPA+0 SPB+0 SPC+0",
        "FUNCTION TCPM F CONT AXIS POS PATHCTRL AXIS",
        "X+5 FMAX",
        "F100",
        "STOP X+5",
        "TRANS DATUM AXIS X+5",
        "L X+5 R0 FMAX ~",
        "SEL TABLE \"A\"",
        "FUNCTION RESET TCPM F",
    ];
    for text in texts {
        assert!(!faults(Family::Heidenhain, &format!("{TNC}2 {text}\n")).is_empty(), "{text}");
    }
}

#[test]
fn forms_of_numbers_are_read_or_refused() {
    let wanted = 5.0;
    for text in ["G01 X5. F9.", "G1X5.F9.", "g01 x5. f9.", "G 1 X 5. F 9.", "G1 X+5. F9", "G1 X05.00 F9."] {
        let block = last(Family::LinuxCnc, &format!("{PLAIN}{text}"));
        assert_eq!((block.action, block.values[2]), (Action::Feed, wanted), "{text}");
    }
    for family in [Family::LinuxCnc, Family::Fanuc, Family::Haas] {
        let texts = [
            "G1 X[1+#3] F9.",
            "G1 X#5 F9.",
            "G1 X-#5 F9.",
            "G1 X5.5.5",
            "G#1 X5.",
            "G1 X5 5",
            "G1.5 X5.",
            "G1 X5.e1",
            "G1 X1/2",
            "G01. 5 X5.",
            "G1 (A) (B X5.",
            "G1 X5. (A (B) X9.",
            "X5.=6.",
        ];
        faulty(family, PLAIN, &texts);
    }
    let texts = [
        "G1 X=R1 F9",
        "G1 X=5+R9 F9",
        "G1 X5*2 F9",
        "G1 X=AC(5",
        "G1 X=AC(5+R9)",
        "G1 X=SIN(R9)",
        "G1 X=DC(5)",
        "X[1]=5",
        "F=AC(5)",
    ];
    faulty(Family::Siemens, SIEMENS, &texts);
    let block = last(Family::Siemens, &format!("{SIEMENS}G0 X1\nG91\nG1 X=AC(5) F9"));
    assert!(near(xyz(&block), [5.0, 0.0, 0.0]), "{block:?}");
}

#[test]
fn what_follows_the_end_of_a_block_in_its_line_is_a_fault() {
    for family in [Family::Fanuc, Family::Haas] {
        assert_eq!(faults(family, &format!("{PLAIN}G0 X5.;\n")), [""; 0]);
        faulty(family, PLAIN, &["G0 X5.; G0 X9.", "G0 X5.;(A)", "; G1 Z-50."]);
    }
    assert_eq!(faults(Family::LinuxCnc, &format!("{PLAIN}G0 X5. ; G0 X9.\n")), [""; 0]);
}

#[test]
fn comments_that_are_orders_are_faults_on_linuxcnc() {
    for text in
        ["(abort, A)", "(LOGOPEN,a.txt)", "(probeopen a)", "(py, x())", "(PROBECLOSE)", ";py,x()", "( Axis,hide)"]
    {
        faulty(Family::LinuxCnc, PLAIN, &[text]);
    }
    assert_eq!(faults(Family::LinuxCnc, &format!("{PLAIN}(MSG, A)\n(D 10, R 2)\n(DEBUG, A)\n")), [""; 0]);
}

#[test]
fn contradictory_codes_of_a_block_are_faults() {
    for family in [Family::LinuxCnc, Family::Fanuc, Family::Haas, Family::Siemens] {
        faulty(family, PLAIN, &["M8 M9", "M3 M4", "M3 M5", "M0 M1", "G0 G1 X5.", "G90 G91", "G54 G55", "G41 G40"]);
    }
    for text in ["L X+5 FMAX M8 M9", "M3 M4", "M126 M127", "M128 M129", "M13 M5"] {
        assert!(!faults(Family::Heidenhain, &format!("{TNC}2 {text}\n")).is_empty(), "{text}");
    }
    assert_eq!(last(Family::Siemens, "M7 M8").state.coolant, Some(coolant::FLOOD | coolant::MIST));
}

#[test]
fn a_program_ends_where_its_control_ends_it() {
    for (family, text) in [
        (Family::LinuxCnc, "%\nG21\nG0 X1\n%"),
        (Family::Siemens, "G710\nG0 X1\nRET"),
        (Family::Siemens, "G710\nG0 X1\nM17"),
        (Family::Heidenhain, "0 BEGIN PGM A MM\n1 L X+1 R0 FMAX\n2 END PGM A MM"),
    ] {
        assert_eq!(last(family, text).action, Action::End, "{family:?}: {text}");
    }
    // After its end code a program may have its closing mark.
    for (family, text) in [
        (Family::Fanuc, "%\nO0001 (A)\nG21\nM30\n%"),
        (Family::LinuxCnc, "%\nG21\nM2\n%"),
        (Family::Heidenhain, "0 BEGIN PGM A MM\n1 M30\n2 END PGM A MM"),
    ] {
        let ends = read(family, text).into_iter().filter(|block| block.action == Action::End).count();
        assert_eq!(ends, 1, "{family:?}");
    }
    faulty(Family::Fanuc, PLAIN, &["% G0 X9.", "O0002 G0 X9.", "M99", "%", "O0002"]);
    assert!(!faults(Family::Heidenhain, "0 BEGIN PGM A MM\n1 BEGIN PGM B INCH\n").is_empty());
}

#[test]
fn machine_coordinates_are_never_incremental() {
    assert!(!faults(Family::Heidenhain, &format!("{TNC}2 L IZ+0 R0 FMAX M91\n")).is_empty());
    assert!(!faults(Family::Siemens, &format!("{SIEMENS}SUPA G0 Z=IC(5) D0\n")).is_empty());
    faulty(Family::LinuxCnc, PLAIN, &["G91 G53 G0 Z0"]);
}
