//! Blocks that compare the length of a tool.

use super::*;

#[test]
fn a_length_that_differs_stops_the_program_on_every_control() {
    let guard =
        LengthGuard { label: 3, tool: 12, offset: 1, length_mm: 114.3, tolerance_mm: 0.01, units: Units::Millimetres };
    let haas = "IF [ABS[#2001 + #2201 - 114.3] GT 0.01] THEN #3000= 101 (T12 IS NOT 114.3 LONG)";
    assert_eq!(Haas.length_guard(&guard), [haas]);
    assert!(Haas.length_guard(&LengthGuard { offset: 201, ..guard }).is_empty());
    let inches = Siemens.length_guard(&LengthGuard { units: Units::Inches, ..guard });
    let message = "MSG(\"T12 was posted with L = 4.5: the length in the tool data differs\")";
    assert_eq!(inches, ["IF ABS($P_TOOLL[1]-4.5)>0.00039", message, "M0", "M30", "ENDIF"]);
    let heidenhain = [
        "FN 18: SYSREAD QL1 = ID50 NR1 IDX12",
        "FN 18: SYSREAD QL2 = ID50 NR4 IDX12",
        "FN 1: QL1 = +QL1 + +QL2",
        "FN 12: IF +QL1 LT +114.29 GOTO LBL \"OFF3\"",
        "FN 12: IF +QL1 LT +114.31 GOTO LBL \"FITS3\"",
        "LBL \"OFF3\"",
        "; T12 was posted with L = 114.3 mm: the length in the tool table differs",
        "FN 14: ERROR = 100",
        "LBL \"FITS3\"",
    ];
    for units in [Units::Millimetres, Units::Inches] {
        assert_eq!(Heidenhain.length_guard(&LengthGuard { units, ..guard }), heidenhain);
    }
    for control in CONTROLS {
        let own = LengthGuard { offset: 12, length_mm: 123.4567, units: Units::Inches, ..guard };
        let blocks = control.length_guard(&own);
        assert!(!blocks.is_empty() && blocks.iter().all(|block| block.len() <= control.spellings().line_length));
    }
}
