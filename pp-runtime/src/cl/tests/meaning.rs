//! What records mean in their context.

use super::*;
use crate::cl::Dialect;

#[test]
fn rapid_holds_for_the_next_motion_only_and_feed_does_not_cancel_it() {
    let found = events("FROM/0,0,9\nRAPID\nFEDRAT/MMPM,100\nGOTO/1,0,0\nGOTO/2,0,0\nFEDRAT/RAPID\nGOTO/3,0,0\n");
    assert_eq!(
        found,
        [
            "1:1 from 0 0 9 axis 1",
            "4:1 rapid 1 0 0 axis 0 0 1 Some(PerMinute(100.0))",
            "5:1 feed 2 0 0 axis 0 0 1 Some(PerMinute(100.0))",
            "7:1 rapid 3 0 0 axis 0 0 1 Some(PerMinute(100.0))",
        ]
    );
}

#[test]
fn inches_become_millimetres() {
    let text = "UNITS/INCHES\nCUTTER/.5,.125\nLOADTL/1,LENGTH,4\nFEDRAT/10\nGOTO/1,-2,0\nFEDRAT/.01,IPR\nGOTO/1,0,0\n";
    let found = events_with(text, UNSTATED);
    assert!(found[0].contains("length_mm: Some(101.6)"), "{found:?}");
    assert!(found[0].contains("diameter_mm: Some(12.7), corner_radius_mm: Some(3.175)"), "{found:?}");
    assert_eq!(found[1], "5:1 feed 25.4 -50.8 0 axis 0 0 1 Some(PerMinute(254.0))");
    assert!(found[2].ends_with("Some(PerRevolution(0.254))"), "{found:?}");
}

#[test]
fn feeds_are_read_in_both_orders_and_all_units() {
    for (text, feed) in [
        ("FEDRAT/250,MMPM", "PerMinute(250.0)"),
        ("FEDRAT/ 250.0, mmpm", "PerMinute(250.0)"),
        ("FEDRAT/MMPM,250", "PerMinute(250.0)"),
        ("FEDRAT/250", "PerMinute(250.0)"),
        ("FEDRAT/PERMIN,250", "PerMinute(250.0)"),
        ("FEDRAT/IPM,10", "PerMinute(254.0)"),
        ("FEDRAT/.5,MMPR", "PerRevolution(0.5)"),
        ("FEDRAT/.5,PERREV", "PerRevolution(0.5)"),
        ("FEDRAT/IPR,1", "PerRevolution(25.4)"),
    ] {
        let found = events(&format!("{text}\nGOTO/0,0,0\n"));
        assert_eq!(found, [format!("2:1 feed 0 0 0 axis 0 0 1 Some({feed})")], "{text}");
    }
}

#[test]
fn the_spindle_is_read_in_any_order() {
    for (text, spindle) in [
        ("RPM,3600,CLW", "On { speed_rev_per_min: Some(3600.0), rotation: Some(Clockwise) }"),
        ("70.0,RPM, CCLW", "On { speed_rev_per_min: Some(70.0), rotation: Some(CounterClockwise) }"),
        ("400,CLW", "On { speed_rev_per_min: Some(400.0), rotation: Some(Clockwise) }"),
        ("ON", "On { speed_rev_per_min: None, rotation: None }"),
        ("off", "Off"),
    ] {
        let found = events(&format!("SPINDL/{text}\nGOTO/0,0,0\n"));
        assert_eq!(found[0], format!("1:1 Spindle({spindle})"), "{text}");
    }
}

#[test]
fn coolant_stops_and_texts_become_events() {
    let text =
        "PARTNO / MFG0001\nCOOLNT/THRU\nCOOLNT/OFF\nOPSTOP\nSTOP\nPPRINT (LOOK)\nSELECT/TOOL,7\nSELCTL/8\nGOTO/0,0,0\n";
    assert_eq!(
        events(text)[..8],
        [
            "1:1 name MFG0001",
            "2:1 Coolant(Through)",
            "3:1 Coolant(Off)",
            "4:1 OptionalStop",
            "5:1 Stop",
            "6:1 message (LOOK)",
            "7:1 Preselect(7)",
            "8:1 Preselect(8)",
        ]
    );
}

#[test]
fn an_operation_has_the_name_of_its_tool_path() {
    let found = events("TOOL PATH/A,B_1.2,TOOL,T 16\nGOTO/0,0,0\n");
    assert_eq!(found[0], "1:1 operation A,B_1.2");
}

#[test]
fn a_cutter_belongs_to_the_next_tool_but_in_creo_to_the_last() {
    let found = events("TLDATA/MILL,16,2,75,0,0\nLOAD/TOOL,1,ADJUST,11 \nGOTO/0,0,0\n");
    assert!(
        found[0].starts_with("2:1 Tool(ToolCall { number: 1, length_mm: None, length_offset: Some(11)"),
        "{found:?}"
    );
    assert!(found[0].contains("diameter_mm: Some(16.0), corner_radius_mm: Some(2.0)"), "{found:?}");

    let found = events("LOADTL/3,ADJUST,3\nGOTO/0,0,0\n");
    assert!(found[0].contains("length_offset: Some(3)"), "the register may be the one it has anyway: {found:?}");

    let found = events("$$-> MFGNO / A\nLOADTL / 1\n$$-> CUTTER / 3.0\nLOADTL / 2\nGOTO / 0,0,0\n");
    assert!(found[0].starts_with("2:1 Tool") && found[0].contains("diameter_mm: Some(3.0)"), "{found:?}");
    assert!(found[1].starts_with("4:1 Tool") && found[1].contains("diameter_mm: None"), "{found:?}");
}

#[test]
fn a_drill_has_a_diameter_and_no_corner_radius() {
    let found = events("TLDATA/DRILL,MILL,63,0,239,178,35\nLOAD/TOOL,1\nGOTO/0,0,0\n");
    assert!(found[0].contains("diameter_mm: Some(63.0), corner_radius_mm: None"), "{found:?}");
}

#[test]
fn a_cutter_without_a_tool_does_not_reach_the_next_operation() {
    let text = "TOOL PATH/A,TOOL,A\nTLDATA/MILL,50,1,50,0,0\nGOTO/0,0,0\nTOOL PATH/B,TOOL,B\nLOAD/TOOL,2\nGOTO/0,0,0\n";
    let found = events(text);
    assert!(found[3].contains("number: 2") && found[3].contains("diameter_mm: None"), "{found:?}");
}

#[test]
fn the_same_tool_called_again_keeps_its_cutter() {
    let found = events("CUTTER/16,0\nLOADTL/1\nLOADTL/1,1,1\nLOADTL/2\nGOTO/0,0,0\n");
    assert!(found[1].contains("diameter_mm: Some(16.0)"), "{found:?}");
    assert!(found[2].contains("diameter_mm: None"), "{found:?}");
}

#[test]
fn a_tool_at_the_end_of_the_file_is_not_lost() {
    assert_eq!(events("GOTO/0,0,0\nLOADTL/4\n").len(), 2);
}

#[test]
fn the_tool_axis_is_modal() {
    let found = events("GOTO/0,0,0,0,.6,.8\nGOTO/1,0,0\n");
    assert_eq!(found[1], "2:1 feed 1 0 0 axis 0 0.6 0.8 None");
    let found = events("TLAXIS/0,.6,.8\nGOTO/1,0,0\n");
    assert_eq!(found[0], "2:1 feed 1 0 0 axis 0 0.6 0.8 None");
}

#[test]
fn a_tilt_is_not_carried_into_the_next_operation() {
    let expected = "3:6+5 this point has no tool axis i, j, k, and the operation before ended with a tilted tool";
    refused("GOTO/0,0,0,0,.6,.8\nTOOL PATH/B,TOOL,B\nGOTO/1,0,0\n", expected);
    refused("GOTO/0,0,0,0,.6,.8\nLOADTL/2\nGOTO/1,0,0\n", expected);
    refused("GOTO/0,0,0,0,0,-1\nLOADTL/2\nGOTO/1,0,0\n", expected);
    let found = events("GOTO/0,0,0,0,.6,.8\nLOADTL/2\nGOTO/1,0,0,0,0,1\nLOADTL/3\nGOTO/2,0,0\n");
    assert_eq!(found[4], "5:1 feed 2 0 0 axis 0 0 1 None");
}

#[test]
fn an_axis_stated_by_tlaxis_holds_after_the_tool_change_that_follows() {
    let found = events("GOTO/0,0,0\nTLAXIS/0,.6,.8\nLOADTL/2\nGOTO/1,0,0\n");
    assert_eq!(found[2], "4:1 feed 1 0 0 axis 0 0.6 0.8 None");
}

#[test]
fn an_axis_stated_by_tlaxis_and_used_is_not_carried_further() {
    let expected = "4:6+5 this point has no tool axis i, j, k, and the operation before ended with a tilted tool";
    refused("TLAXIS/0,.6,.8\nGOTO/1,0,0\nLOADTL/2\nGOTO/1,0,0\n", expected);
}

#[test]
fn multax_off_keeps_the_axis_in_catia_and_elsewhere_a_tilt_is_in_doubt() {
    let text = "MULTAX/ON\nGOTO/0,0,0,0,.6,.8\nMULTAX/OFF\nGOTO/1,0,0\n";
    assert_eq!(events(&format!("$$*CATIA0\n{text}"))[1], "5:1 feed 1 0 0 axis 0 0.6 0.8 None");
    let expected = "6+5 this point has no tool axis i, j, k, and the tool was tilted at MULTAX/OFF";
    refused(text, &format!("4:{expected}"));
    refused(&format!("$$-> MFGNO / A\n{text}"), &format!("5:{expected}"));
    // The point may state either.
    for axis in ["0,0,1", "0,.6,.8"] {
        assert_eq!(events(&text.replace("1,0,0", &format!("1,0,0,{axis}"))).len(), 2);
    }
}

#[test]
fn a_point_that_tilts_the_tool_after_multax_off_is_refused() {
    let held = |line| format!("MULTAX/OFF of line {line} holds the tool axis, and this record changes it");
    refused("MULTAX/OFF\nGOTO/1,0,0\nGOTO/1,0,0,0,.6,.8\n", &format!("3:6+13 {}", held(1)));
    refused("MULTAX/OFF\nTLAXIS/0,.6,.8\nGOTO/1,0,0\n", &format!("2:8+7 {}", held(1)));
    refused("GOTO/0,0,0\nMULTAX/OFF\nGODLTA/1,0,0,0,.6,.8\n", &format!("3:8+13 {}", held(2)));
    // In CATIA the axis that is held is the last one, and another one comes with MULTAX/ON.
    let tilted = "$$*CATIA0\nMULTAX\nGOTO/0,0,0,0,.6,.8\nMULTAX/OFF\n";
    refused(&format!("{tilted}GOTO/1,0,0,0,0,1\n"), &format!("5:6+11 {}", held(4)));
    assert_eq!(events(&format!("{tilted}GOTO/1,0,0,0,.6,.8\nMULTAX\nGOTO/1,0,0,0,0,1\n")).len(), 3);
    assert_eq!(events("MULTAX/OFF\nGOTO/1,0,0,0,0,1\nMULTAX/ON\nGOTO/1,0,0,0,.6,.8\n").len(), 2);
    // A new operation does not end it.
    assert!(errors("MULTAX/OFF\nGOTO/1,0,0\nLOADTL/2\nGOTO/1,0,0,0,.6,.8\n")[0].contains(&held(1)));
    // CSYS of SolidWorks CAM is a set-up of its own.
    let csys = "UNIT/MM\nTRNTYP/WORLD,0,0,0\nMULTAX/OFF\nCSYS/1,0,0,0,0,0,1,0,0,-1,0,0\nGOTO/1,2,3\n";
    assert!(events_without_places(csys, MM).last().unwrap().starts_with("feed 1 2 3 axis 0 1 0"));
}

#[test]
fn inert_records_cause_nothing() {
    let text = "PAINT/COLOR,1\nSEQNO/1\nDISPLY/ON\nTPRINT/T1 Drill,,D\nTPRINT/\nREWIND/0\nTOOLNO/1,  16,2\nLETTER x\n\
                LEADER/1\nCHECK/1\nTMARK/1\nINTOL /  0.025\nTOLER/0.01\nOUTTOL/0\nSETUP/START,1\nCSI_SET_FLUTE_LENGTH/70.\n\
                TRNTYP/WORLD,0,0,0\nSET/MODE,ABSOL\nCYCLE/OFF\nREMARK a/b,,\nEND-OF-PATH\nEND\nGOTO/1,2,3\nFINI\n";
    assert_eq!(events(text), ["23:1 feed 1 2 3 axis 0 0 1 None"]);
}

#[test]
fn the_catia_matrix_is_a_frame() {
    let matrix = "$$*CATIA0\n$$ Program.1\n$$  1.0 0.0 0.0 10.0\n$$  0.0 -1.0 0.0 0.0\n$$  0.0 0.0 -1.0 5.0\n";
    let text = format!("{matrix}GOTO/0,0,0\n{matrix}GOTO/0,0,0\n");
    let mut reader = ClReader::new(text.as_bytes(), MM.into());
    while reader.next_event().unwrap().is_some() {}
    assert!(!reader.failed());
    assert_eq!(reader.frames_stated(), 2);
    let frame = reader.frame().unwrap();
    assert_eq!((frame.location.line, frame.origin), (5, [10.0, 0.0, 5.0]));
    assert_eq!(frame.axes, [[1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, -1.0]]);

    let other = text.replacen("5.0\nGOTO", "5.1\nGOTO", 1);
    let found = errors(&other);
    assert_eq!(found.len(), 1);
    assert!(found[0].contains("the frame in line 11 differs from the workpiece frame in line 5"), "{found:?}");
}

#[test]
fn a_matrix_of_catia_is_read_whole_or_refused() {
    let row = "expected a row of the matrix of $$*CATIA0: four numbers separated by blanks";
    let matrix = |rows: &str| errors(&format!("$$*CATIA0\n$$ Program.1\n{rows}GOTO/0,0,0\nGOTO/1,0,0\n"));
    // A number that fills its field leaves no blank.
    assert_eq!(matrix("$$ 1 0 0-10000.0\n$$ 0 1 0 0\n$$ 0 0 1 0\n"), [format!("3:1+16 {row}")]);
    assert_eq!(matrix("$$ 1 0 0 0\n$$ 0 1 0\n$$ 0 0 1 0\n"), [format!("4:1+8 {row}")]);
    assert_eq!(matrix("$$ 1 0 0 0\n$$ 0 1 0 0\n"), [format!("5:1+10 {row}")]);
    assert_eq!(matrix("$$ 1 0 0 0\n$$*CATIA0\n"), [format!("4:1+9 {row}")]);
    assert_eq!(matrix("$$ no matrix here\n$$ 1 0 0 0\n"), [""; 0]);
}

#[test]
fn records_and_comments_identify_the_cam_system() {
    for (text, dialect) in [
        ("GOTO/1,2,3\n", Dialect::Generic),
        ("TOOL PATH/A,TOOL,B\n", Dialect::Nx),
        ("$$     CATIA APT VERSION 1.0\n", Dialect::Catia),
        ("$$*CATIA0\n", Dialect::Catia),
        ("$$*  Pro/CLfile  Version 8.0\n", Dialect::Creo),
        ("$$-> MFGNO / A\nUNIT/MM\n", Dialect::Creo),
        ("UNIT/MM\n", Dialect::SolidWorks),
        ("CSI_X/1\n", Dialect::SolidWorks),
        ("UNITS/MM\n", Dialect::Generic),
    ] {
        let mut reader = ClReader::new(text.as_bytes(), MM.into());
        while reader.next_event().unwrap().is_some() {}
        assert_eq!(reader.dialect(), dialect, "{text}");
    }
}

#[test]
fn every_length_of_an_inch_file_is_in_inches() {
    let inch = |text: &str| events_without_places(&format!("UNITS/INCH\n$$-> A\nGOTO/0,0,2\n{text}\n"), UNSTATED);
    let levels = "DEPTH,1,CLEAR,.5,RETURN,2,IPM,10";
    let peck = inch(&format!("CYCLE/DEEP,{levels},STEP,.5,1STPECK,.25\nGOTO/1,0,0"));
    assert_eq!(
        peck[1],
        "hole 25.4 0 0 deep 25.4 from 12.7 to 50.8 Peck { first_mm: 6.35, later_mm: 12.7 } Some(PerMinute(254.0)) None"
    );
    let chip = inch(&format!("CYCLE/BRKCHP,{levels},STEP,.5,BACK,.25,DWELL,2\nGOTO/1,0,0"));
    assert!(
        chip[1]
            .ends_with("ChipBreak { step_mm: 12.7, retract_mm: Some(6.35) } Some(PerMinute(254.0)) Some(Seconds(2.0))"),
        "{chip:?}"
    );
    assert_eq!(inch("LINTOL/.001")[1], "Tolerance(Some(0.0254))");
    assert_eq!(inch("GODLTA/1")[1], "feed 0 0 76.19999999999999 axis 0 0 1 None");
    assert_eq!(inch("GODLTA/1,0,0")[1], "feed 25.4 0 50.8 axis 0 0 1 None");
    assert_eq!(inch("ORIGIN/1,0,0\nGOTO/0,0,0")[1], "feed -25.4 0 0 axis 0 0 1 None");
    assert_eq!(inch("TRACUT/1,0,0,1,0,1,0,0,0,0,1,0\nGOTO/0,0,0")[1], "feed 25.4 0 0 axis 0 0 1 None");
    assert_eq!(inch("CLEARP/XYPLAN,3\nRETRCT")[2], "rapid 0 0 76.19999999999999 axis 0 0 1 None");
    assert_eq!(inch("CIRCLE/1,0,2,0,0,1,1\nGOTO/2,0,2")[1], "arc to 50.8 0 50.8 about 0 0 1 through 180.000");
    let tracut = "TRACUT/1,0,0,1,0,1,0,0,0,0,1,0\n";
    let text = format!("UNITS/INCH\n{tracut}GOTO/0,0,0\nNURBS/\nKNOT/1\nCNTRL/1,0,0\nCNTRL/2,0,0\nCNTRL/3,0,0\n");
    let mut reader = ClReader::new(text.as_bytes(), ReadingOptions::default());
    reader.next_event().unwrap();
    let Some((_, Event::Motion(ToolMotion::Spline(spline)))) = reader.next_event().unwrap() else { panic!("a curve") };
    let x: Vec<f64> = spline.points.iter().map(|point| (point.x * 10.0).round() / 10.0).collect();
    assert_eq!(x, [25.4, 50.8, 76.2, 101.6]);
}
