//! Whole programs as each control writes them.

use super::*;

#[test]
fn fanuc_writes_points_calls_the_length_with_z_and_cancels_it_with_z() {
    assert_eq!(
        whole(&Fanuc, &layout()),
        [
            "%",
            "O0001 (PART 7)",
            "(A [B])",
            "(OPERATION FACE 1)",
            "N1 G21 G17 G40 G49 G80 G90 G94 G55",
            "M9",
            "G53 G0 Z0.",
            "T5 M6",
            "T7",
            "G49 G53 G0 Z0.",
            "S3000 M3",
            "G4 P2000",
            "G0 A0. C30.",
            "X10.",
            "G43 H6 Z50.5",
            "M8",
            "G1 Z-1. F800.",
            "X12. C31.",
            "M9",
            "G49 G53 G0 Z0.",
            "G0 G43 H6 Z50.5",
            "M5",
            "M1",
            "M30",
            "%",
        ]
    );
}

#[test]
fn haas_writes_two_digits_and_a_dwell_in_seconds() {
    let text = whole(&Haas, &layout());
    assert_eq!(text[1], "O00001 (PART 7)");
    for line in ["T5 M06", "S3000 M03", "G04 P2.", "G43 H6 Z50.5", "G01 Z-1. F800.", "G49 G53 G00 Z0.", "M01", "M30"] {
        assert!(text.iter().any(|found| found == line), "{line}: {text:#?}");
    }
}

#[test]
fn siemens_calls_the_edge_again_after_machine_coordinates_and_separates_long_names() {
    let options = ControlOptions { axes: BTreeMap::from([('C', "C1".to_owned())]), ..ControlOptions::default() };
    assert_eq!(
        whole(&Siemens, &layout_with(options)),
        [
            "; a (b)",
            "MSG(\"Face 1\")",
            "N1 TRAFOOF",
            "CYCLE800()",
            "TRANS",
            "G710 G17 G40 G64 G90 G94 G55",
            "M9",
            "SUPA G0 Z0 D0",
            "T5",
            "M6",
            "T7",
            "SUPA G0 Z0 D0",
            "D6",
            "S3000 M3",
            "G4 F2",
            "G0 A0 C1=30",
            "X10",
            "Z50.5",
            "M8",
            "G1 Z-1 F800",
            "X12 C1=31",
            "M9",
            "SUPA G0 Z0 D0",
            "D6",
            "G0 Z50.5",
            "M5",
            "M1",
            "M30",
        ]
    );
}

#[test]
fn heidenhain_numbers_every_line_and_begins_every_motion_with_l() {
    let text = whole(&Heidenhain, &layout());
    let expected = [
        "0 BEGIN PGM PART_7 MM",
        "1 ; a (b)",
        "2 * - Face 1",
        "3 M129",
        "4 PLANE RESET STAY",
        "5 M127",
        "6 CYCL DEF 247 DATUM SETTING ~",
        "  Q339=+2 ;DATUM NUMBER",
        "7 M9",
        "8 L Z+0 R0 FMAX M91",
        "9 TOOL CALL 5 Z S3000",
        "10 TOOL DEF 7",
        "11 L Z+0 R0 FMAX M91",
        "12 M3",
        "13 CYCL DEF 9.0 DWELL TIME",
        "14 CYCL DEF 9.1 DWELL 2",
        "15 L A+0 C+30 R0 FMAX",
        "16 L X+10 R0 FMAX",
        "17 L Z+50.5 R0 FMAX",
        "18 M8",
        "19 L Z-1 R0 F800",
        "20 L X+12 C+31",
        "21 M9",
        "22 L Z+0 R0 FMAX M91",
        "23 L Z+50.5 R0 FMAX",
        "24 M5",
        "25 M1",
        "26 M30",
        "27 END PGM PART_7 MM",
    ];
    assert_eq!(text, expected);
}

#[test]
fn a_program_in_inches_has_the_code_of_inches() {
    let inches = Layout { units: Units::Inches, ..layout() };
    let text = |control: &dyn Control| whole(control, &inches).join(" ");
    assert!(text(&LinuxCnc).contains("N1 G20 "));
    assert!(text(&Siemens).contains("G700 "));
    assert!(text(&Heidenhain).contains("BEGIN PGM PART_7 INCH") && text(&Heidenhain).contains("END PGM PART_7 INCH"));
}

#[test]
fn words_come_in_the_usual_order_whatever_the_chain_is() {
    let text = steps(&LinuxCnc, &layout(), &[Step::Rapid { words: words([10_000, -5, 1500, -1]) }]);
    assert_eq!(text, ["G0 X-0.001 Z1.5 A-0.0005 C1"]);
}

#[test]
fn blocks_of_the_configuration_replace_those_of_the_table() {
    let options = ControlOptions {
        tool_change: Some(vec!["M101".into(), "T{tool} M6 (H{offset} S{speed})".into(), "T{next}".into()]),
        safety: Some(vec!["{units} G90".into(), "{work_offset}".into()]),
        program_number: Some(42),
        program_name: Some("x-1".into()),
        ..ControlOptions::default()
    };
    let program =
        ProgramBlocks { start: vec!["(P{number} {name})".into()], end: vec!["M99".into()], ..ProgramBlocks::default() };
    let layout = Layout { program, ..layout_with(options) };
    let text = written_by(&Fanuc, &layout, |encoder| {
        encoder.open(None)?;
        encoder.start()?;
        short_program()[..4].iter().try_for_each(|step| encoder.encode(step))?;
        encoder.end(&[])
    });
    assert_eq!(
        text,
        [
            "%",
            "O0042 (X-1)",
            "(P0042 X-1)",
            "N1 G21 G90",
            "G55",
            "M9",
            "G49 G53 G0 Z0.",
            "M101",
            "T5 M6 (H6 S3000)",
            "T7",
            "M99",
            "M30",
            "%"
        ]
    );
}
