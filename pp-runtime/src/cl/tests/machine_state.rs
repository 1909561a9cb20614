//! Records of machine state: delays, compensation, length offsets, spindle speed.

use super::*;

#[test]
fn records_of_machine_state_become_events() {
    let text = "MACHIN / UNCX01, 1\nDELAY/2.5\nDELAY/3,REV\nCUTCOM/LEFT,XYPLAN\nCUTCOM/OFF\nROTABL/SHORT\nROTABL/NEXT,CCLW\n\
                LINTOL/.005\nLINTOL/OFF\nINVERSE/ON\nFEDRAT/INVERS,AUTO\nOPSKIP/OFF\nMODE/MILL\nGOTO/0,0,0\n";
    assert_eq!(
        events_without_places(text, MM)[..9],
        [
            "machine UNCX01",
            "Delay(Seconds(2.5))",
            "Delay(Revolutions(3.0))",
            "Compensation(Compensation { side: Left, register: None, in_xy_plane: true })",
            "Compensation(Compensation { side: Off, register: None, in_xy_plane: true })",
            "RotaryDirection(Shortest)",
            "RotaryDirection(Towards(CounterClockwise))",
            "Tolerance(Some(0.005))",
            "Tolerance(None)",
        ]
    );
    refused("ROTABL/    0.000000,,TABLE,CLW\nGOTO/0,0,0\n", "1:21+1 an argument is missing at this comma");
    assert!(errors("ROTABL/90\nGOTO/0,0,0\n")[0].contains("this form of ROTABL is refused"));
    assert!(errors("LINTOL/0\nGOTO/0,0,0\n")[0].contains("LINTOL must be above 0"));
}

#[test]
fn a_long_dwell_causes_a_warning() {
    let outcome = read_from(&b"DELAY/   50.0\nGOTO/0,0,0\n"[..], MM);
    assert_eq!(outcome.diagnostics.len(), 1);
    assert_eq!(outcome.diagnostics[0].severity, Severity::Warning);
    assert_eq!(outcome.events.len(), 2);
}

#[test]
fn coolant_through_the_spindle_may_have_a_pressure() {
    let text = "COOLNT/THRU,LOW\nCOOLNT/THRU,MEDIUM\nCOOLNT/THRU,HIGH\nGOTO/0,0,0\n";
    let pressures = ["Low", "Medium", "High"].map(|word| format!("Coolant(ThroughAt({word}))"));
    assert_eq!(events_without_places(text, MM)[..3], pressures);
}

#[test]
fn block_skip_is_ignored_with_a_warning_and_a_message() {
    let outcome = read_from(&b"GOTO/0,0,0\nOPSKIP/ON\nGOTO/1,0,0\nOPSKIP/OFF\n"[..], MM);
    assert_eq!(outcome.events.len(), 3, "{:?}", outcome.events);
    assert!(outcome.events[1].contains("OPSKIP ON ignored"), "{:?}", outcome.events);
    let [warning] = &outcome.diagnostics[..] else { panic!("{:?}", outcome.diagnostics) };
    assert_eq!((warning.severity, warning.location.line), (Severity::Warning, 2));
    assert!(warning.text.contains("always executed"), "{}", warning.text);
}

#[test]
fn a_length_offset_belongs_to_the_tool_called_before_it() {
    assert!(events_without_places("LOADTL/3\nSET/OFSETL,7\nGOTO/0,0,0\n", MM)[0].contains("length_offset: Some(7)"));
    assert_eq!(errors("LOADTL/3\nGOTO/0,0,0\nSET/OFSETL,3\n"), [""; 0]);
    assert!(errors("LOADTL/3\nGOTO/0,0,0\nSET/OFSETL,4\n")[0].contains("does not directly follow the tool call"));
}

#[test]
fn a_spindle_speed_that_rounds_to_nothing_is_refused() {
    refused("SPINDL/    0.3980,RPM,CLW\nGOTO/0,0,0\n", "1:12+6 a spindle speed of 0.398 rev/min rounds to 0");
    assert_eq!(errors("SPINDL/.5,RPM,CLW\nGOTO/0,0,0\n"), [""; 0]);
}
