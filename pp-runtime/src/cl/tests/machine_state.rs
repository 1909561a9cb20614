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
fn a_spindle_that_is_switched_on_at_a_stop_is_remarked_on() {
    let remarks = |text: &str| -> Vec<String> {
        let text = format!("SPINDL/900,RPM,CLW\nGOTO/0,0,9\n{text}\nGOTO/0,0,0\n");
        read_from(text.as_bytes(), MM).diagnostics.iter().map(|found| found.text.clone()).collect()
    };
    for (stop, word) in [("SPINDL/ON\nSTOP\nSPINDL/OFF", "STOP"), ("SPINDL/ON\nPPRINT A\nOPSTOP", "OPSTOP")] {
        let expected = format!("SPINDL/ON comes directly before {word}, where a spindle is switched off");
        assert_eq!(remarks(stop), [expected], "{stop}");
    }
    for stop in [
        "STOP\nSPINDL/ON",
        "SPINDL/OFF\nSTOP\nSPINDL/ON",
        "SPINDL/ON\nGOTO/0,0,8\nSTOP",
        "SPINDL/ON\nSPINDL/OFF\nSTOP",
        // A speed for the next tool, checked before its first cut.
        "SPINDL/RPM,900,CLW\nSTOP",
    ] {
        assert_eq!(remarks(stop), [""; 0], "{stop}");
    }
}

#[test]
fn coolant_through_the_spindle_may_have_a_pressure() {
    let text = "COOLNT/THRU,LOW\nCOOLNT/THRU,MEDIUM\nCOOLNT/THRU,HIGH\nGOTO/0,0,0\n";
    let pressures = ["Low", "Medium", "High"].map(|word| format!("Coolant(ThroughAt({word}))"));
    assert_eq!(events_without_places(text, MM)[..3], pressures);
}

#[test]
fn a_pressure_of_other_coolant_is_left_out_with_a_warning() {
    for kind in ["ON", "FLOOD", "MIST"] {
        let text = format!("COOLNT / {kind}, HIGH\nGOTO/0,0,0\n");
        let Outcome { events, diagnostics } = read_from(text.as_bytes(), MM);
        assert!(events[0].to_uppercase().ends_with(&format!("COOLANT({kind})")), "{events:?}");
        let [warning] = &diagnostics[..] else { panic!("{diagnostics:?}") };
        assert_eq!(warning.severity, Severity::Warning);
        assert!(warning.text.contains("without its pressure, HIGH"), "{}", warning.text);
    }
    for text in ["COOLNT/OFF,HIGH", "COOLNT/AIR,LOW", "COOLNT/FLOOD,MOST"] {
        assert!(errors(&format!("{text}\nGOTO/0,0,0\n"))[0].contains("is not supported"), "{text}");
    }
    assert_eq!(errors("FEDRAT/INVERS,OFF\nGOTO/0,0,0\n"), [""; 0]);
}

#[test]
fn cutcom_on_waits_for_its_side() {
    let plain = events_without_places("CUTCOM/LEFT,3\nGOTO/0,0,0\nCUTCOM/OFF\nCUTCOM/ON\nGOTO/9,0,0\n", MM);
    for begin in
        ["CUTCOM/ON\nCUTCOM/LEFT, 3", "CUTCOM/ON,3\nCUTCOM/LEFT", "CUTCOM/ON\nFEDRAT/9\nCUTCOM/ON\nCUTCOM/LEFT,3"]
    {
        let text = format!("{begin}\nGOTO/0,0,0\nCUTCOM/OFF\nCUTCOM/ON\nGOTO/9,0,0\n");
        let found = events_without_places(&text, MM);
        let compensation = |events: &[String]| -> Vec<String> {
            events.iter().filter(|event| event.starts_with("Compensation")).cloned().collect()
        };
        assert_eq!(compensation(&found), compensation(&plain), "{begin}");
    }
    refused(
        "GOTO/0,0,0\nCUTCOM/ON\nGOTO/1,0,0\nGOTO/2,0,0\n",
        "3:1+10 a motion follows CUTCOM/ON, and no CUTCOM/LEFT or RIGHT has stated the side",
    );
    assert_eq!(errors("GOTO/0,0,0\nCUTCOM/ON\nCUTCOM/OFF\nGOTO/1,0,0\n"), [""; 0]);
}

#[test]
fn opskip_begins_and_ends_blocks_that_may_be_skipped() {
    let outcome = read_from(&b"GOTO/0,0,0\nOPSKIP/ON\nGOTO/1,0,0\nOPSKIP/OFF\n"[..], MM);
    let skips: Vec<&String> = outcome.events.iter().filter(|event| event.contains("BlockSkip")).collect();
    assert_eq!(skips.len(), 2, "{:?}", outcome.events);
    assert!(skips[0].contains("on: true") && skips[1].contains("on: false"), "{skips:?}");
    assert_eq!(outcome.diagnostics, []);
}

#[test]
fn a_length_offset_belongs_to_the_tool_called_before_it() {
    assert!(events_without_places("LOADTL/3\nSET/OFSETL,7\nGOTO/0,0,0\n", MM)[0].contains("length_offset: Some(7)"));
    assert_eq!(errors("LOADTL/3\nGOTO/0,0,0\nSET/OFSETL,3\n"), [""; 0]);
    assert!(errors("LOADTL/3\nGOTO/0,0,0\nSET/OFSETL,4\n")[0].contains("does not directly follow the tool call"));
}

#[test]
fn a_spindle_speed_that_rounds_to_nothing_is_refused() {
    refused("SPINDL/    0.0004,RPM,CLW\nGOTO/0,0,0\n", "1:12+6 a spindle speed of `0.0004` rev/min rounds to 0");
    // The decimals of the word decide.
    assert_eq!(errors("SPINDL/.0005,RPM,CLW\nGOTO/0,0,0\n"), [""; 0]);
}

/// The tool calls of a file, as their events.
fn tools(text: &str, options: impl Into<ReadingOptions>) -> Vec<String> {
    events_without_places(text, options).into_iter().filter(|event| event.starts_with("Tool(")).collect()
}

#[test]
fn numbers_after_the_tool_have_the_meaning_of_the_cam_system_or_of_the_configuration() {
    use crate::cl::{Dialect, ToolArg};
    let register = |tools: &[String], expected: &str| assert!(tools[0].contains(expected), "{tools:?}");
    register(&tools("$$*CATIA0\nLOADTL/2,1\nGOTO/0,0,0\n", MM), "number: 2, length_mm: None, length_offset: Some(1)");
    register(&tools("$$*CATIA0\nLOADTL/2,2\nGOTO/0,0,0\n", MM), "length_offset: None");
    assert!(errors("$$*CATIA0\nLOADTL/2,0\n")[0].contains("2:10+1 0 is no length offset register for tool 2"));
    assert!(errors("$$*CATIA0\nLOADTL/2,1.5\n")[0].contains("1.5 is no length offset register for tool 2"));
    assert!(errors("$$*CATIA0\nLOADTL/2,0,1\n")[0].contains("2 numbers without a word"));
    let autodesk = ReadingOptions { dialect: Some(Dialect::Autodesk), ..mm() };
    let four = "LOADTL/3, 0, 35.0, 13\nGOTO/0,0,0\n";
    register(&tools(four, autodesk), "number: 3, length_mm: None, length_offset: Some(13)");
    let given = |args: &[ToolArg]| ReadingOptions { tool_args: args.to_vec(), ..mm() };
    let args = [ToolArg::Ignored, ToolArg::Length, ToolArg::Offset];
    register(&tools(four, given(&args)), "number: 3, length_mm: Some(35.0), length_offset: Some(13)");
    // Configured, a repeated number has that meaning, too; a call without numbers needs none.
    register(&tools("LOADTL/3,3\nGOTO/0,0,0\n", given(&[ToolArg::Length])), "length_mm: Some(3.0)");
    register(&tools("LOADTL/3\nGOTO/0,0,0\n", given(&args)), "length_mm: None, length_offset: None");
    assert!(errors_with("LOADTL/3,1\n", given(&args))[0].contains("`[cl.loadtl] args` has 3"));
    assert!(
        errors_with("LOADTL/3,4,ADJUST,5\n", given(&[ToolArg::Offset]))[0].contains("4 is no length offset register")
    );
    assert!(errors_with("LOADTL/3,4,LENGTH,5\n", given(&[ToolArg::Length]))[0].contains("is stated twice"));
    for text in ["LOADTL/3,9", "LOADTL/3,0,35,13"] {
        let help = read_from(text.as_bytes(), MM).diagnostics[0].help.clone().unwrap();
        assert!(help.contains("[cl.loadtl]") && help.contains("autodesk") == text.contains("35"), "{help}");
    }
}

#[test]
fn words_of_a_tool_call_have_the_meaning_of_their_post() {
    let catia = tools("LOADTL/3,ADJUST,1,SPINDL,15915.49,MILL\nGOTO/0,0,0\n", MM);
    assert!(catia[0].contains("number: 3, length_mm: None, length_offset: Some(1)"), "{catia:?}");
    // With IN the length is that of the body.
    let Outcome { events, diagnostics } = read_from(&b"LOADTL/4, IN, 0, LENGTH, 100, OSETNO, 14\nGOTO/0,0,0\n"[..], MM);
    assert!(events[0].contains("number: 4, length_mm: None, length_offset: Some(14)"), "{events:?}");
    assert_eq!(
        diagnostics[0].text,
        "LENGTH of a LOADTL with IN is the length of the body of tool 4, not its gauge length"
    );
    assert!(diagnostics.len() == 1 && diagnostics[0].severity == Severity::Warning);
    assert!(tools("LOADTL/4,LENGTH,100\nGOTO/0,0,0\n", MM)[0].contains("length_mm: Some(100.0)"));
}

#[test]
fn a_side_after_cutcom_on_and_a_feed_in_feet_are_read() {
    for side in ["LEFT", "RIGHT"] {
        let (plain, after_on) =
            (format!("CUTCOM/{side},3\nGOTO/0,0,0\n"), format!("CUTCOM/ON, {side}, 3\nGOTO/0,0,0\n"));
        assert_eq!(events_without_places(&after_on, MM), events_without_places(&plain, MM));
    }
    refused("CUTCOM/ON,OFF\nGOTO/0,0,0\n", "1:11+3 CUTCOM with `OFF` is not supported");
    refused("CUTCOM/ON,LEFT,RIGHT\nGOTO/0,0,0\n", "1:16+5 CUTCOM with `RIGHT` is not supported");
    for (feed, expected) in [("1.0,FPM", "PerMinute(304.8"), ("FPR,.01", "PerRevolution(3.048")] {
        assert!(events(&format!("FEDRAT/{feed}\nGOTO/0,0,0\n"))[0].contains(expected), "{feed}");
    }
}
