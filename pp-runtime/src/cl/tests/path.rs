//! Records of motion: arcs, curves, holes, frames and coordinate transforms.

use super::*;
use crate::cl::record::ClCycleKind;
use crate::cl::{CycleArg, Dialect, FeedLabel, Frames, Insert, Sense};
use crate::set_up::ClPoint;

fn mm() -> ReadingOptions {
    ReadingOptions::from(MM)
}

/// Events without their places.
#[track_caller]
fn events_without_places(text: &str, options: impl Into<ReadingOptions>) -> Vec<String> {
    events_with(text, options).iter().map(|event| event.split_once(' ').unwrap().1.to_owned()).collect()
}

#[test]
fn from_moves_nothing_unless_the_option_makes_it_a_move() {
    assert_eq!(events_without_places("FROM/1,2,3\nGOTO/0,0,0\n", MM)[0], "from 1 2 3 axis 1");
    let options = ReadingOptions { from_move: true, ..mm() };
    assert_eq!(events_without_places("FROM/1,2,3\nGOTO/0,0,0\n", options)[0], "rapid 1 2 3 axis 0 0 1 None");
}

#[test]
fn gohome_with_a_point_is_a_rapid_by_the_safe_sequence() {
    let found = events_without_places("GOTO/0,0,0\nFEDRAT/100\nGOHOME/1,2,3\nGOTO/0,0,0\nGOHOME\n", MM);
    assert_eq!(found[1], "SafeSequence");
    assert_eq!(found[2], "rapid 1 2 3 axis 0 0 1 Some(PerMinute(100.0))");
    assert_eq!(found[3], "feed 0 0 0 axis 0 0 1 Some(PerMinute(100.0))");
    assert_eq!(found[4], "Home");
}

#[test]
fn rapid_holds_across_fedrat_for_one_motion_of_any_kind() {
    let found = events_without_places("GOTO/0,0,0\nRAPID\nFEDRAT/100\nGODLTA/1,0,0\nGODLTA/1,0,0\n", MM);
    assert!(found[1].starts_with("rapid 1 0 0") && found[2].starts_with("feed 2 0 0"), "{found:?}");
    refused(
        "GOTO/0,0,0\nRAPID\nCIRCLE/5,0,0,0,0,1,5\nGOTO/10,0,0\n",
        "3:1+20 RAPID before a circle: no control runs an arc at rapid",
    );
}

#[test]
fn godlta_counts_along_the_axes_or_along_the_tool() {
    let found = events_without_places("GOTO/1,2,3,0,.6,.8\nGODLTA/1,1,1\nGODLTA/10\n", MM);
    assert_eq!(found[1], "feed 2 3 4 axis 0 0.6 0.8 None");
    assert_eq!(found[2], "feed 2 9 12 axis 0 0.6 0.8 None");
    refused("GODLTA/1\nGOTO/0,0,0\n", "1:8+1 GODLTA is relative to the tool position, which is unknown here");
    assert_eq!(events_without_places("FROM/1,0,0\nGODLTA/1,0,0\n", MM)[1], "feed 2 0 0 axis 0 0 1 None");
}

#[test]
fn each_point_of_a_list_is_a_motion_and_after_a_circle_the_last_is_the_end_of_the_arc() {
    let found = events_without_places("GOTO / 1,2,3 / 4,5,6 /7,8,9\n", MM);
    assert_eq!(found.len(), 3);
    assert!(found[2].starts_with("feed 7 8 9"), "{found:?}");
    let found = events_without_places("GOTO/1,0,0\nCIRCLE/0,0,0,0,0,1,1\nGOTO/.6,.8,0 / 0,1,0\n", MM);
    assert_eq!(found[1], "arc to 0 1 0 about 0 0 1 through 90.000");
    // A point off the circle, and one on the part of the circle that the arc does not cover.
    for point in [".6,.7,0", "0,-1,0"] {
        refused(
            &format!("GOTO/1,0,0\nCIRCLE/0,0,0,0,0,1,1\nGOTO/{point} / 0,1,0\n"),
            &format!("3:6+{} a point of this list is not on its arc (circle of line 2)", point.len() + 8),
        );
    }
}

#[test]
fn the_sense_of_a_circle_follows_from_the_count_of_its_numbers() {
    for (numbers, normal) in [("0,0,0,0,0,1", 1), ("0,0,0,0,0,1,1", 1), ("0,0,0,0,0,1,1,.06,.5,10,1", -1)] {
        let found = events_without_places(&format!("GOTO/1,0,0\nCIRCLE/{numbers}\nGOTO/0,1,0\n"), MM);
        let angle = if normal > 0 { "90" } else { "270" };
        assert_eq!(found[1].replace("-0", "0"), format!("arc to 0 1 0 about 0 0 {normal} through {angle}.000"));
    }
    for count in ["0,0,0,0,0", "0,0,0,0,0,1,1,1", "0,0,0,0,0,1,1,.06,.5,10,1,1"] {
        let found = errors(&format!("GOTO/1,0,0\nCIRCLE/{count}\nGOTO/0,1,0\n"));
        assert!(found[0].contains("CIRCLE needs 6, 7 or 11 numbers"), "{found:?}");
    }
    let options = ReadingOptions { circle_sense: Some(Sense::Clockwise), ..mm() };
    assert!(
        events_without_places("GOTO/1,0,0\nCIRCLE/0,0,0,0,0,1\nGOTO/0,1,0\n", options)[1].ends_with("through 270.000")
    );
}

#[test]
fn a_full_circle_and_several_turns_and_a_helix_are_arcs() {
    let full = events_without_places("GOTO/1,0,0\nCIRCLE/0,0,0,0,0,1\nGOTO/1,0,0\n", MM);
    assert!(full[1].ends_with("through 360.000"), "{full:?}");
    // The plane of a helix is that of its end.
    let helix = events_without_places("GOTO/1,0,0\nCIRCLE/0,0,-5,0,0,-1,1,.06,.5,10,0,TIMES,3\nGOTO/0,1,-5\n", MM);
    assert_eq!(helix[1].replace("-0 -0 1", "0 0 1"), "arc to 0 1 -5 about 0 0 1 through 810.000");
}

#[test]
fn a_milled_thread_has_its_pitch_and_its_hand() {
    // Two turns and a quarter of pitch 1.5, about an axis down: clockwise about it is counter-clockwise from above.
    let thread = |axis: i32, end: f64| {
        let text = format!("GOTO/5,0,0\nCIRCLE/0,0,{end},0,0,{axis},5,.06,.5,8,0,TIMES,3\nGOTO/0,5,{end}\n");
        let mut reader = ClReader::new(text.as_bytes(), mm());
        reader.next_event().unwrap();
        let Some((_, Event::Arc(arc))) = reader.next_event().unwrap() else { panic!("an arc") };
        let turns = arc.angle_rad / std::f64::consts::TAU;
        let lead = (arc.end.tip.z - arc.start.tip.z) / turns * arc.normal.z;
        ((turns * 4.0).round(), (lead * 1e9).round() / 1e9)
    };
    // Up and counter-clockwise, down and clockwise: right-handed.
    assert_eq!(thread(-1, 1.5 * 2.25), (9.0, 1.5));
    assert_eq!(thread(1, -1.5 * 2.75), (11.0, 1.5));
    assert_eq!(thread(-1, -1.5 * 2.25), (9.0, -1.5), "left-handed");
}

#[test]
fn an_arc_whose_end_is_not_on_its_circle_is_refused() {
    let at = |circle: &str, end: &str| errors(&format!("GOTO/1,0,0\nCIRCLE/{circle}\nGOTO/{end}\nGOTO/0,0,9\n"));
    assert_eq!(
        at("0,0,0,0,0,1,1", "0,1.01,0"),
        ["3:6+8 the end of an arc is 0.0100 mm off its radius of 1.0000 mm (circle of line 2)"]
    );
    assert_eq!(at("0,0,0,0,0,1,1", "0,1.004,0"), [""; 0]);
    assert_eq!(
        at("0,0,0,0,0,1,1.01", "0,1,0"),
        ["3:6+5 the start of an arc is 0.0100 mm off its radius of 1.0100 mm (circle of line 2)"]
    );
    assert_eq!(
        at("0,0,0,0,0,1,1", "0,1,1"),
        ["3:6+5 the end of an arc is 1.0000 mm off the plane of its circle (circle of line 2)"]
    );
    assert_eq!(at("0,0,0,0,0,1,1", "0,1,0,0,.6,.8"), ["3:6+13 the tool axis changes on an arc (circle of line 2)"]);
    assert_eq!(at("0,0,0,0,0,2,1", "0,1,0").len(), 1);
}

#[test]
fn a_helix_that_ends_over_its_start_has_gone_round() {
    for end in ["GOTO/10,.0002,-3", "GOTO/10,-.0002,-3", "GOTO/10,0,-3"] {
        let found = events(&format!("GOTO/10,0,0\nCIRCLE/0,0,-3,0,0,1\n{end}\n"));
        assert!(found.iter().any(|event| event.contains("through 360.")), "{end}: {found:?}");
    }
}

#[test]
fn a_chord_that_may_be_rounding_is_neither_nothing_nor_a_turn() {
    let found = errors("GOTO/10,0,0\nCIRCLE/0,0,0,0,0,1\nGOTO/10,.0002,0\n");
    assert!(found[0].contains("the arc may be empty or a full circle"), "{found:?}");
    let found = errors("GOTO/10,0,0\nCIRCLE/0,0,0,0,0,1\nGOTO/10,-.0002,0\n");
    assert!(found[0].contains("the arc may be empty or a full circle"), "{found:?}");
    assert_eq!(errors("GOTO/10,0,0\nCIRCLE/0,0,0,0,0,1\nGOTO/10,.001,0\n"), [""; 0]);
}

#[test]
fn a_circle_ends_in_one_goto_and_few_records_may_come_between() {
    let found =
        events_without_places("GOTO/1,0,0\nCIRCLE/0,0,0,0,0,1\nPAINT/PATH\nFEDRAT/9\nGOTO/0,1,0\nGOTO/0,5,0\n", MM);
    assert!(found[1].starts_with("arc") && found[2].starts_with("feed 0 5 0"), "{found:?}");
    let found = errors("GOTO/1,0,0\nCIRCLE/0,0,0,0,0,1\nLOADTL/1\nGOTO/0,1,0\n");
    assert!(found[0].contains("the circle of line 2 has no end"), "{found:?}");
    let found = errors("GOTO/1,0,0\nCIRCLE/0,0,0,0,0,1\n");
    assert!(found[0].contains("the file ends before the GOTO that ends the arc of line 2"), "{found:?}");
}

#[test]
fn tangent_lines_vote_on_the_sense_of_arcs() {
    // A line along +Y to (1, 0), the arc left about the origin, a line along -X.
    let path = |circle: &str| format!("GOTO/1,-5,0\nGOTO/1,0,0\nCIRCLE/0,0,0,0,0,{circle}\nGOTO/0,1,0\nGOTO/-5,1,0\n");
    let vote = |text: &str| {
        let mut reader = ClReader::new(text.as_bytes(), mm());
        while reader.next_event().unwrap().is_some() {}
        (reader.arcs(), reader.diagnostics().to_vec())
    };
    let (arcs, none) = vote(&path("1"));
    assert_eq!((arcs.arcs, arcs.agree, arcs.against, none.len()), (1, 1, 0, 0));
    let (arcs, majority) = vote(&path("-1"));
    assert_eq!((arcs.agree, arcs.against), (0, 1));
    assert_eq!(majority[0].severity, Severity::Error);
    assert_eq!(majority[0].location.line, 4);
    assert!(majority[0].text.starts_with("1 of 1 arcs"), "{majority:?}");
    // One cusp among several arcs is a warning. Arcs vote in groups by the sign of their axis.
    let cusp = "GOTO/1,-5,0\nGOTO/1,0,0\nCIRCLE/0,0,0,0,0,1\nGOTO/0,-1,0\nGOTO/-5,-1,0\n";
    assert_eq!(vote(&cusp.replace("0,-1,0\nGOTO/-5,-1,0", "0,1,0\nGOTO/5,1,0")).0.agree, 0, "in and out contradict");
    let against = "GOTO/1,5,0\nGOTO/1,0,0\nCIRCLE/0,0,0,0,0,1\nGOTO/0,1,0\n";
    let (arcs, warning) = vote(&format!("{}{}RAPID\n{against}", path("1"), path("1")));
    assert_eq!((arcs.agree, arcs.against), (2, 1));
    assert_eq!(warning.iter().map(|found| found.severity).collect::<Vec<_>>(), [Severity::Warning]);
    // A rapid does not vote.
    let (arcs, _) = vote("GOTO/1,-5,0\nRAPID\nGOTO/1,0,0\nCIRCLE/0,0,0,0,0,1\nGOTO/0,1,0\nRAPID\nGOTO/-5,1,0\n");
    assert_eq!((arcs.arcs, arcs.agree + arcs.against), (1, 0));
}

#[test]
fn movarc_must_have_the_angle_of_its_record() {
    let text = |angle: &str| format!("GOTO/1,0,0\nMOVARC/0,0,0,0,0,1,1,ANGLE,{angle}\nGOTO/0,1,0\n");
    assert!(events_without_places(&text("90"), MM)[1].ends_with("through 90.000"));
    assert!(events_without_places(&text("450"), MM)[1].ends_with("through 450.000"));
    assert!(errors(&text("91"))[0].contains("is at 90.0000 degrees, its record states 91.0000"));
}

#[test]
fn an_arc_of_catia_begins_along_indirv_and_ends_where_its_line_ends() {
    let text = "GOTO/20.4,0,-30\nAUTOPS\nINDIRV/0,0,1\n\
                TLON,GOFWD/      (CIRCLE/     25.0,      0.0,    -30.0,$\n       4.6),ON,(LINE/     25.0, 0, -30.0,$\n\
                \x20     25.0,      0.0,    -25.4)\nGOTO/30,0,-25.4\n";
    let found = events_without_places(text, MM);
    assert_eq!(found[1].replace("-0 ", "0 "), "arc to 25 0 -25.4 about 0 1 0 through 90.000");
    let second = text.replace("ON,(", "ON,2,INTOF,(");
    assert_eq!(events_without_places(&second, MM)[1], found[1]);
    assert!(errors(&text.replace("-25.4)", "-25.3)"))[0].contains("off the circle"));
    assert!(errors(&text.replace("INDIRV/0,0,1", "INDIRV/1,0,0"))[0].contains("INDIRV is not tangent"));
    assert!(errors(&text.replace("INDIRV/0,0,1\n", ""))[0].contains("no INDIRV"));
    assert!(errors(&text.replace("GOFWD", "GOBACK"))[0].contains("expected `GOFWD`"));
    for word in ["AUTOPS", "INDIRV/0,0,1"] {
        let alone = errors(&format!("GOTO/0,0,0\n{word}\nGOTO/1,0,0\nGOTO/2,0,0\n"));
        assert_eq!(alone, ["3:1+10 expected TLON after AUTOPS or INDIRV, found another motion"]);
    }
}

#[test]
fn a_curve_of_nx_begins_at_the_tool_position_and_the_next_goto_is_a_line() {
    let text = "GOTO/0,0,0\nNURBS/\nKNOT/.5\nKNOT/1.0\nCNTRL/1,0,0\nCNTRL/2,0,0\nPAINT/PATH\nCNTRL/3,1,0\nCNTRL/4,4,0\nGOTO/5,5,5\n";
    let found = events_without_places(text, MM);
    assert_eq!(found[1], "spline [0.0, 0.0, 0.0, 0.0, 0.5, 1.0, 1.0, 1.0, 1.0] 5");
    assert!(found[2].starts_with("feed 5 5 5"), "{found:?}");
    let two = text.replace("GOTO/5,5,5", "NURBS/\nKNOT/1\nCNTRL/5,0,0\nCNTRL/6,0,0\nCNTRL/7,0,0\nGODLTA/1,0,0");
    let found = events_without_places(&two, MM);
    assert_eq!(found[2], "spline [0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0] 4");
    assert!(found[3].starts_with("feed 8 0 0"), "{found:?}");
    let missing = errors(&text.replace("CNTRL/4,4,0\n", ""));
    assert!(missing[0].starts_with("9:1+10 the curve of line 2 is invalid: it lists 2 knots and 3"), "{missing:?}");
    assert!(errors(&text.replace("KNOT/1.0", "KNOT/.25"))[0].contains("its knots decrease"));
    for knots in ["0,1", "1,1", "0,0", "-1,-1"] {
        let broken = errors(&text.replace("KNOT/.5\nKNOT/1.0", &format!("KNOT/{knots}")));
        let why = if knots.starts_with('-') { "its knots decrease" } else { "too many of its knots are equal" };
        assert!(broken[0].ends_with(why), "{knots}: {broken:?}");
    }
    let inside = |knots: &str| {
        let points = "CNTRL/1,0,0\n".repeat(knots.split(',').count() + 2);
        errors(&format!("GOTO/0,0,0\nNURBS/\nKNOT/{knots}\n{points}"))
    };
    assert_eq!(inside(".5,.5,.5,1"), [""; 0], "a corner is no break");
    assert!(inside(".5,.5,.5,.5,1")[0].ends_with("too many of its knots are equal"));
    refused("GOTO/0,0,0\nKNOT/1\n", "2:6+1 KNOT comes outside a NURBS");
    refused("NURBS/\nGOTO/0,0,0\n", "1:1+6 NURBS is relative to the tool position, which is unknown here");
}

const NX: &str = "TOOL PATH/A,TOOL,B\nGOTO/0,0,50\n";

#[test]
fn nx_counts_fedto_up_and_auto_is_the_level_before_the_cycle() {
    let found = events_without_places(
        &format!("{NX}CYCLE/DRILL,RAPTO,3,FEDTO,-33,RTRCTO,AUTO,MMPM,250\nGOTO/1,0,0\nCYCLE/OFF\nGOTO/2,0,50\n"),
        MM,
    );
    assert_eq!(found[2], "hole 1 0 0 deep 33 from 3 to 50 Drill Some(PerMinute(250.0)) None");
    assert!(found[3].starts_with("feed 2 0 50"), "the feed of a cycle is its own: {found:?}");
    assert!(found[3].ends_with("None"));
    let deep =
        events_without_places(&format!("{NX}CYCLE/DRILL,DEEP,STEP,20,CLEAR,3,FEDTO,-72,MMPM,250\nGOTO/1,0,0\n"), MM);
    assert_eq!(
        deep[2],
        "hole 1 0 0 deep 72 from 3 to 3 Peck { first_mm: 20.0, later_mm: 20.0 } Some(PerMinute(250.0)) None"
    );
    let manual =
        events_without_places(&format!("{NX}CYCLE/DRILL,RAPTO,3,FEDTO,-3,RTRCTO,40,MANUAL,IPR,.01\nGOTO/1,0,0\n"), MM);
    assert!(manual[2].starts_with("hole 1 0 0 deep 3 from 3 to 40 Drill Some(PerRevolution("), "{manual:?}");
}

#[test]
fn depth_and_clear_count_depth_down_and_return_to_the_clearance_level() {
    let creo = "$$-> MFGNO / A\nGOTO / 0,0,9\n";
    let found = events_without_places(
        &format!("{creo}CYCLE / DEEP, DEPTH, 3.5, STEP, 1, MMPM, 50, CLEAR,$\n 1.0\nGOTO / 1,0,0\n"),
        MM,
    );
    assert_eq!(
        found[1],
        "hole 1 0 0 deep 3.5 from 1 to 1 Peck { first_mm: 1.0, later_mm: 1.0 } Some(PerMinute(50.0)) None"
    );
    let found = events_without_places(
        &format!("{creo}CYCLE / DRILL, DEPTH, 3.5, CLEAR, 1, RETURN, 9, DWELL, 2\nFEDRAT/7\nGOTO / 1,0,0\n"),
        MM,
    );
    assert_eq!(found[1], "hole 1 0 0 deep 3.5 from 1 to 9 Drill Some(PerMinute(7.0)) Some(Seconds(2.0))");
    let found = events_without_places(
        &format!("{creo}CYCLE / BRKCHP, DEPTH, 3, STEP, 1, BACK, .3, CLEAR, 1, DWELL, REV, 2\nGOTO / 1,0,0\n"),
        MM,
    );
    assert_eq!(
        found[1],
        "hole 1 0 0 deep 3 from 1 to 1 ChipBreak { step_mm: 1.0, retract_mm: Some(0.3) } None Some(Revolutions(2.0))"
    );
}

#[test]
fn solidworks_counts_fedto_down_and_states_the_return_level() {
    let text = |state: &str| {
        format!(
            "UNIT/MM\nGOTO/0,0,50\n{state}CYCLE/DEEP2,FEDTO,40.,1STPECK,5.,SUBPECK,2.,MMPM,400,RAPTO,3.,RTRCTO,25.\nGOTO/1,0,0\nCYCLE/OFF\n"
        )
    };
    let hole = |back: u32| {
        format!(
            "hole 1 0 0 deep 40 from 3 to {back} Peck {{ first_mm: 5.0, later_mm: 2.0 }} Some(PerMinute(400.0)) None"
        )
    };
    assert_eq!(events_without_places(&text("CYCLE/INIT\n"), UNSTATED)[1], hole(25));
    assert_eq!(events_without_places(&text("CYCLE/CLEAR\n"), UNSTATED)[1], hole(3));
    assert!(errors_with(&text(""), UNSTATED)[0].contains("neither CYCLE/INIT nor CYCLE/CLEAR"));
}

#[test]
fn a_cycle_that_would_not_make_the_hole_is_refused() {
    let nx = |cycle: &str| {
        let found = errors(&format!("{NX}CYCLE/{cycle}\nGOTO/1,0,0\nGOTO/2,0,0\nCYCLE/OFF\n"));
        assert_eq!(found.len(), 1, "{found:?}");
        found[0].split_once(' ').unwrap().1.to_owned()
    };
    assert_eq!(nx("DRILL,RAPTO,3,FEDTO,0.0000,MMPM,250"), "the depth of this hole is 0");
    assert_eq!(nx("DRILL,RAPTO,3,FEDTO,5,MMPM,250"), "the sign of this depth is wrong: it leads out of the part");
    assert_eq!(nx("DRILL,RAPTO,-3,FEDTO,-5,MMPM,250"), "the clearance level lies below the top of the hole");
    assert_eq!(nx("DRILL,FEDTO,-5,MMPM,250"), "this cycle has no clearance level");
    assert_eq!(nx("DRILL,RAPTO,3,FEDTO,-5,RTRCTO,2"), "the return level of this cycle lies below its clearance level");
    assert_eq!(nx("DRILL,DEEP,RAPTO,3,FEDTO,-5"), "this cycle has no step");
    assert_eq!(nx("DRILL,RAPTO,3,FEDTO,-5,STEP,2"), "this cycle has a word that does not belong to DRILL");
    assert!(nx("BORE,RAPTO,3,FEDTO,-5,ORIENT,0").contains("stops the spindle at an angle"));
    assert!(nx("BACK,RAPTO,3,FEDTO,-5").contains("stops the spindle at an angle"));
    assert_eq!(nx("MILL,RAPTO,3"), "CYCLE with `MILL` is not supported");
    let low = errors(&format!("{NX}GOTO/0,0,1\nCYCLE/DRILL,RAPTO,3,FEDTO,-5,RTRCTO,AUTO\nGOTO/1,0,0\n"));
    assert!(low[0].contains("the level before the cycle lies 1.0000 mm above this hole"), "{low:?}");
    let unknown = errors("GOTO/0,0,9\nCYCLE/DRILL,DEPTH,3,CLEAR,1\nGOTO/0,0,0\n");
    assert!(unknown[0].contains("that of this file is unknown"), "{unknown:?}");
    let unknown = errors("GOTO/0,0,9\nCYCLE/DRILL,FEDTO,3,RAPTO,1\nGOTO/0,0,0\n");
    assert!(unknown[0].contains("the sign of FEDTO depends on the CAM system"), "{unknown:?}");
    let under = errors(&format!("{NX}CYCLE/DRILL,RAPTO,3,FEDTO,-5\nLOADTL/1\nGOTO/1,0,0\n"));
    assert!(under[0].contains("this record is not permitted between the points of a CYCLE"), "{under:?}");
    assert!(errors("CYCLE/DRILL,FEDTO,1.5,DWELL,,IPM,1\nGOTO/0,0,0\n")[0].contains("an argument is missing"));
}

#[test]
fn numbers_without_words_need_a_table_of_their_meaning() {
    let text = "$$*CATIA0\nGOTO/0,0,9\nCYCLE/TAP,   50.7,    1.5\nGOTO/0,0,0\n";
    assert!(errors(text)[0].contains("CYCLE/TAP has 2 numbers without a word"));
    let args = vec![(ClCycleKind::Tap, vec![CycleArg::Depth, CycleArg::Pitch])];
    let found = errors_with(text, ReadingOptions { cycle_args: args, ..mm() });
    assert!(found[0].contains("this cycle has no clearance level"), "{found:?}");
    let args = vec![(ClCycleKind::Tap, vec![CycleArg::Depth, CycleArg::Clearance])];
    let found = events_without_places(text, ReadingOptions { cycle_args: args, ..mm() });
    assert!(found[1].starts_with("hole 0 0 0 deep 50.7 from 1.5 to 1.5 Tap { pitch_mm: None }"), "{found:?}");
}

#[test]
fn a_cycle_can_be_resumed() {
    let text = format!("{NX}CYCLE/DRILL,RAPTO,3,FEDTO,-3\nGOTO/1,0,0\nCYCLE/OFF\nGOTO/2,0,9\nCYCLE/ON\nGOTO/3,0,0\n");
    let found = events_without_places(&text, MM);
    assert!(found[2].starts_with("hole") && found[3].starts_with("feed") && found[4].starts_with("hole 3 0 0"));
    assert!(errors("GOTO/0,0,0\nCYCLE/ON\n")[0].contains("without a cycle before it"));
    // AUTO returns to the level at which the cycle is resumed, not to that of its definition.
    let auto = text.replace("FEDTO,-3", "FEDTO,-3,RTRCTO,AUTO").replace("GOTO/2,0,9", "GOTO/2,0,80");
    let found = events_without_places(&auto, MM);
    assert!(found[2].contains("from 3 to 50") && found[4].contains("from 3 to 80"), "{found:?}");
}

#[test]
fn a_cycle_is_not_resumed_in_another_operation() {
    let cycle = format!("{NX}CYCLE/DRILL,RAPTO,3,FEDTO,-3\nGOTO/1,0,0\nCYCLE/OFF\n");
    for between in ["TOOL PATH/B,TOOL,C", "LOAD/TOOL,2"] {
        let found = errors(&format!("{cycle}{between}\nGOTO/2,0,9\nCYCLE/ON\nGOTO/3,0,0\n"));
        assert_eq!(found, ["8:7+2 CYCLE/ON without a cycle before it in this operation"], "{between}");
    }
    // Nor does CYCLE/INIT hold for a cycle in another operation.
    let text = "UNIT/MM\nGOTO/0,0,50\nCYCLE/INIT\nLOAD/TOOL,2\nGOTO/0,0,50\nCYCLE/DRILL,FEDTO,4,RAPTO,3,RTRCTO,25\nGOTO/1,0,0\n";
    assert!(errors_with(text, UNSTATED)[0].contains("neither CYCLE/INIT nor CYCLE/CLEAR"));
}

#[test]
fn no_relative_motion_follows_a_hole() {
    let cycle = format!("CLEARP/XYPLAN,60\n{NX}CYCLE/DRILL,RAPTO,3,FEDTO,-3\n");
    let counted = |text: &str| errors(&format!("{cycle}GOTO/1,0,0\n{text}\n"));
    assert_eq!(
        counted("GODLTA/10,0,0"),
        ["6:8+6 GODLTA after a hole is ambiguous: it may start from the hole or from the level above it"]
    );
    for text in ["GODLTA/5", "CYCLE/OFF\nGODLTA/5", "CYCLE/OFF\nCIRCLE/0,0,0,0,0,1\nGOTO/0,1,0", "CYCLE/OFF\nNURBS/"] {
        assert!(counted(text)[0].contains("after a hole is ambiguous"), "{text}");
    }
    assert_eq!(counted("CYCLE/OFF\nGOTO/0,0,9\nGODLTA/5"), [""; 0]);
    assert_eq!(counted("CYCLE/OFF\nRETRCT\nGODLTA/5"), [""; 0]);
    // The first hole may be relative to the point before it.
    assert!(events_without_places(&format!("{cycle}GODLTA/1,0,-50\n"), MM)[3].starts_with("hole 1 0 0"));
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
    let Some((_, Event::Spline(spline))) = reader.next_event().unwrap() else { panic!("a curve") };
    let x: Vec<f64> = spline.points.iter().map(|point| (point.x * 10.0).round() / 10.0).collect();
    assert_eq!(x, [25.4, 50.8, 76.2, 101.6]);
}

#[test]
fn origin_is_subtracted_trans_added_and_tracut_turns_points_and_axes() {
    let found =
        events_without_places("ORIGIN/1,2,3\nTRANS/10,0,0\nGOTO/0,0,0\nORIGIN/NOMORE\nTRANS/0\nGOTO/1,0,0\n", MM);
    assert!(found[0].starts_with("feed 9 -2 -3") && found[1].starts_with("feed 1 0 0"), "{found:?}");
    // A quarter turn about X and a shift: (x, y, z) to (x + 5, -z, y).
    let turn = "TRACUT/1,0,0,5,0,0,-1,0,0,1,0,0\n";
    assert_eq!(events_without_places(&format!("{turn}GOTO/1,2,3,0,0,1\n"), MM)[0], "feed 6 -3 2 axis 0 -1 0 None");
    let both = events_without_places(&format!("{turn}ORIGIN/0,0,1\nGOTO/1,2,3\nTRACUT/NOMORE\nGOTO/1,2,3\n"), MM);
    assert!(both[0].starts_with("feed 6 -3 1") && both[1].starts_with("feed 1 2 2"), "{both:?}");
    let arc = events_without_places(&format!("{turn}GOTO/1,0,0\nCIRCLE/0,0,0,0,0,1\nGOTO/0,1,0\n"), MM);
    assert_eq!(arc[1], "arc to 5 0 1 about 0 -1 0 through 90.000");
    let delta = events_without_places(&format!("{turn}GOTO/0,0,0\nGODLTA/0,1,0\n"), MM);
    assert!(delta[1].starts_with("feed 5 0 1"), "{delta:?}");
    for matrix in ["-1,0,0,0,0,1,0,0,0,0,1,0", "2,0,0,0,0,2,0,0,0,0,2,0", "1,.1,0,0,0,1,0,0,0,0,1,0"] {
        assert!(errors(&format!("TRACUT/{matrix}\nGOTO/0,0,0\n"))[0].contains("scales, shears or mirrors"));
    }
    assert!(errors("TRACUT/LAST\nGOTO/0,0,0\n")[0].contains("`LAST` is not a number"));
    assert!(errors("$$-> A\nTRANS/1,2,3\nGOTO/0,0,0\n")[0].contains("TRANS of Creo"));
    assert!(errors("$$-> A\nROTATE/AAXIS,90\nGOTO/0,0,0\n")[0].contains("ROTATE is refused"));
    assert!(errors("$$-> A\nROTABL/90,CLW\nGOTO/0,0,0\n")[0].contains("this form of ROTABL is refused"));
}

/// Two frames: the origin of the second is at (10, 0, 0) of the first, its X is the model's Y.
const TWO_FRAMES: &str = "MSYS/1,0,0,1,0,0,0,1,0\nGOTO/1,2,3\nMSYS/11,0,0,0,1,0,-1,0,0\nGOTO/1,2,3,.6,0,.8\n";

#[test]
fn a_second_frame_is_mapped_into_the_first_or_has_an_offset_of_its_own() {
    let found = events_without_places(TWO_FRAMES, ReadingOptions { frames: Frames::Main, ..mm() });
    assert_eq!(found[1..], ["SafeSequence", "feed 8 1 3 axis 0 0.6 0.8 None"]);
    let found = events_without_places(TWO_FRAMES, ReadingOptions { frames: Frames::Offset, ..mm() });
    assert_eq!(found[1..], ["Frame(2)", "feed 1 2 3 axis 0.6 0 0.8 None"]);
    // The first frame again, then the second under its own number.
    let back = format!("{TWO_FRAMES}MSYS/1,0,0,1,0,0,0,1,0\nGOTO/1,2,3,0,0,1\nMSYS/11,0,0,0,1,0,-1,0,0\nGOTO/0,0,0\n");
    let found = events_without_places(&back, ReadingOptions { frames: Frames::Main, ..mm() });
    assert!(found[4].starts_with("feed 1 2 3 axis 0 0 1") && found[6].starts_with("feed 10 0 0"), "{found:?}");
    let found = events_without_places(&back, ReadingOptions { frames: Frames::Offset, ..mm() });
    assert_eq!((found[3].as_str(), found[5].as_str()), ("Frame(1)", "Frame(2)"));
}

#[test]
fn a_frame_before_units_is_in_that_unit_too() {
    let text = "MSYS/1,0,0,1,0,0,0,1,0\nUNITS/INCH\nGOTO/0,0,0\nMSYS/1,0,0,1,0,0,0,1,0\nGOTO/1,0,0\nMSYS/2,0,0,1,0,0,0,1,0\nGOTO/0,0,0\n";
    let found = events_without_places(text, ReadingOptions { frames: Frames::Main, ..ReadingOptions::default() });
    assert_eq!(found[1..], ["feed 25.4 0 0 axis 0 0 1 None", "SafeSequence", "feed 25.4 0 0 axis 0 0 1 None"]);
}

#[test]
fn a_clearance_plane_belongs_to_its_frame() {
    let text = format!("CLEARP/XYPLAN,50\n{TWO_FRAMES}RETRCT\n");
    let found = errors_with(&text, ReadingOptions { frames: Frames::Offset, ..mm() });
    assert_eq!(found, ["6:1+6 RETRCT needs a clearance plane, and no CLEARP comes before it"]);
    let found = events_without_places(&text, ReadingOptions { frames: Frames::Main, ..mm() });
    assert_eq!(found.last().map(String::as_str), Some("rapid 8 36.25 50 axis 0 0.6 0.8 None"));
}

#[test]
fn csys_of_solidworks_moves_nothing_and_sets_the_tool_axis() {
    let world = "UNIT/MM\nTRNTYP/WORLD,0,0,0\n";
    let text = format!(
        "{world}CSYS/1,0,0,5,0,1,0,5,0,0,1,5\nGOTO/1,2,3\n{world}CSYS/0,0,1,0,1,0,0,0,0,1,0,0\nGOTO/1,2,3,1,0,0\nGOTO/4,5,6\n"
    );
    let found = events_without_places(&text, UNSTATED);
    assert_eq!(found[0], "feed 1 2 3 axis 0 0 1 None");
    assert_eq!(found[1..], ["SafeSequence", "feed 1 2 3 axis 1 0 0 None", "feed 4 5 6 axis 1 0 0 None"]);
    let same = events_without_places(
        &text.replace("0,0,1,0,1,0,0,0,0,1,0,0\nGOTO/1,2,3,1,0,0", "1,0,0,5,0,1,0,5,0,0,1,5"),
        UNSTATED,
    );
    assert_eq!(same[1..], ["feed 4 5 6 axis 0 0 1 None"], "an equal CSYS is no new set-up");
    let mut reader = ClReader::new(text.as_bytes(), ReadingOptions::default());
    while reader.next_event().unwrap().is_some() {}
    assert_eq!(reader.setup_changes(), 1);
    let against = errors_with(&text.replace("3,1,0,0", "3,0,0,1"), UNSTATED);
    assert!(against[0].contains("contradicts the third column of CSYS"), "{against:?}");
    let bare = errors("CSYS/1,0,0,5,0,1,0,5,0,0,1,5\nGOTO/0,0,0\n");
    assert!(bare[0].contains("CSYS without TRNTYP/WORLD,0,0,0"), "{bare:?}");
}

#[test]
fn retrct_goes_along_the_tool_to_the_plane_of_clearp() {
    let found = events_without_places("CLEARP/XYPLAN,50\nGOTO/0,0,0,0,.6,.8\nRETRCT\nRETRCT\n", MM);
    assert_eq!(found[2], "rapid 0 37.5 50 axis 0 0.6 0.8 None");
    assert_eq!(found.len(), 3, "the tool is above the plane already");
    assert!(events_without_places("CLEARP/0,0,2,100\nGOTO/0,0,0\nRETRCT\n", MM)[2].starts_with("rapid 0 0 50"));
    refused("GOTO/0,0,0\nRETRCT\n", "2:1+6 RETRCT needs a clearance plane, and no CLEARP comes before it");
    assert!(errors("CLEARP/XYPLAN,50\nGOTO/0,0,0,1,0,0\nRETRCT\n")[0].contains("does not reach the clearance plane"));
}

#[test]
fn the_centre_of_the_corner_radius_lies_above_the_tip() {
    let text = "CUTTER/10,5\nLOADTL/1\nGOTO/0,0,0,0,.6,.8\nGOTO/1,0,0,0,0,1\nCIRCLE/0,0,0,0,0,1\nGOTO/0,1,0\n";
    let centre = ReadingOptions { cl_point: ClPoint::Centre, ..mm() };
    let found = events_without_places(text, centre.clone());
    assert_eq!(found[1], "feed 0 -3 -4 axis 0 0.6 0.8 None");
    assert_eq!(found[3], "arc to 0 1 -5 about 0 0 1 through 90.000");
    assert!(errors_with("LOADTL/1\nGOTO/0,0,0\n", centre.clone())[0].contains("the radius of this tool is unknown"));
    let creo = "$$-> A\nLOADTL/1\nSPINDL/900,CLW\n$$-> CUTTER / 10,5\nGOTO/0,0,0\n";
    assert_eq!(events_without_places(creo, centre)[2], "feed 0 0 -5 axis 0 0 1 None");
    let mut of_one = mm();
    of_one.cl_point_of.insert(1, ClPoint::Centre);
    assert_eq!(events_without_places(text, of_one)[1], "feed 0 -3 -4 axis 0 0.6 0.8 None");
}

#[test]
fn insert_is_refused_a_comment_or_nc_text() {
    let text = "GOTO/0,0,0\nINSERT/Stock Size X40. $$ Z40.\nGOTO/1,0,0\n";
    assert_eq!(errors(text), ["2:8+23 INSERT is refused: the effect of its NC text on the machine is unknown"]);
    let insert = |insert| ReadingOptions { insert, ..mm() };
    assert_eq!(events_without_places(text, insert(Insert::Comment))[1], "message Stock Size X40. $$ Z40.");
    assert_eq!(events_without_places(text, insert(Insert::Write))[1], "insert Stock Size X40. $$ Z40.");
    let stop = "GOTO/0,0,0\nINSERT/STOP  Insert holdings\n";
    assert!(errors_with(stop, insert(Insert::Comment))[0].contains("may be a program stop that is needed"));
    let found = events_without_places(stop, ReadingOptions { insert_stop: true, ..mm() });
    assert_eq!(found[1..], ["Stop", "message STOP  Insert holdings"]);
}

#[test]
fn codes_pass_only_if_they_are_allowed() {
    let text = "GOTO/0,0,0\nAUXFUN/10,NEXT\nPREFUN/64\n";
    assert_eq!(errors(text).len(), 2);
    assert!(errors(text)[0].contains("AUXFUN is refused: the effect of M10 on the machine is unknown"));
    let found = events_without_places(text, ReadingOptions { auxfun: vec![10], prefun: vec![64], ..mm() });
    assert_eq!(found[1..], ["Code { letter: 77, number: 10 }", "Code { letter: 71, number: 64 }"]);
}

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
fn a_length_offset_belongs_to_the_tool_called_before_it() {
    assert!(events_without_places("LOADTL/3\nSET/OFSETL,7\nGOTO/0,0,0\n", MM)[0].contains("length_offset: Some(7)"));
    assert_eq!(errors("LOADTL/3\nGOTO/0,0,0\nSET/OFSETL,3\n"), [""; 0]);
    assert!(errors("LOADTL/3\nGOTO/0,0,0\nSET/OFSETL,4\n")[0].contains("does not directly follow the tool call"));
}

#[test]
fn the_meaning_of_a_feed_label_in_mm_in_an_inch_file_can_be_configured() {
    let text = "UNITS/INCH\nFEDRAT/10,MMPM\nGOTO/1,2,3\n";
    let label = |feed_label| ReadingOptions { feed_label, ..ReadingOptions::default() };
    assert!(events_without_places(text, label(FeedLabel::Trust))[0].ends_with("Some(PerMinute(10.0))"));
    assert!(events_without_places(text, label(FeedLabel::FileUnits))[0].ends_with("Some(PerMinute(254.0))"));
}

#[test]
fn a_word_can_be_declared_inert_unless_it_moves_something() {
    let inert = |word: &str| ReadingOptions { inert: vec![word.to_owned()], ..mm() };
    assert_eq!(events_without_places("AICC/ON,10\nGOTO/0,0,0\n", inert("AICC")).len(), 1);
    assert_eq!(events_without_places("BREAK\nGOTO/0,0,0\n", inert("BREAK")).len(), 1);
    assert_eq!(errors_with("LOOP/START,15\nGOTO/0,0,0\n", inert("LOOP")).len(), 1);
    assert_eq!(events_without_places("GOTO/0,0,0\n", inert("GOTO")).len(), 1);
}

#[test]
fn the_dialect_can_be_given() {
    let text = "GOTO/0,0,9\nCYCLE/DRILL,DEPTH,3,CLEAR,1\nGOTO/0,0,0\n";
    assert!(
        events_without_places(text, ReadingOptions { dialect: Some(Dialect::Iso), ..mm() })[1]
            .starts_with("hole 0 0 0 deep 3")
    );
}

#[test]
fn columns_after_the_configured_ones_are_not_read() {
    let card = format!("{:<72}00000010\n{:<72}00000020\n", "GOTO/1,2,3", "GOTO/4,5,$");
    let text = format!("{card}{:<72}00000030\n", "6");
    let options = ReadingOptions { columns: Some(72), ..mm() };
    assert_eq!(events_without_places(&text, options), ["feed 1 2 3 axis 0 0 1 None", "feed 4 5 6 axis 0 0 1 None"]);
    assert_eq!(errors(&text).len(), 3);
}

#[test]
fn a_dollar_pair_in_quotes_or_after_insert_begins_no_comment() {
    assert_eq!(errors("SYN/'TLAXIS','$$*TLAXIS'\nGOTO/0,0,0\n").len(), 1);
    assert_eq!(events_without_places("PARTNO/'A $$ B'\nGOTO/0,0,0\n", MM)[0], "name A $$ B");
    assert_eq!(events_without_places("PPRINT don't $$ it\nGOTO/0,0,0\n", MM)[0], "message don't");
}

#[test]
fn a_spindle_speed_that_rounds_to_nothing_is_refused() {
    refused("SPINDL/    0.3980,RPM,CLW\nGOTO/0,0,0\n", "1:12+6 a spindle speed of 0.398 rev/min rounds to 0");
    assert_eq!(errors("SPINDL/.5,RPM,CLW\nGOTO/0,0,0\n"), [""; 0]);
}

#[test]
fn many_subprograms_take_no_more_time_than_their_text_and_their_number_is_bounded() {
    let define = |count: u32| (0..count).map(|n| format!("DEFSUB/{n}\nENDSUB\n")).collect::<String>();
    // A search through all known subprograms for each new one took a minute here.
    let text = format!("{}GOTO/0,0,0\nCALSUB/99999\n", define(100_000));
    assert_eq!(events(&text).len(), 1);
    let found = errors(&format!("{}GOTO/0,0,0\n", define(100_002)));
    assert_eq!(found[0], "200001:1+13 the file defines too many subprograms");
    assert_eq!(found.len(), 2);
}

#[test]
fn a_subprogram_is_executed_where_it_is_called() {
    let text = "DEFSUB/1\nGODLTA/1,0,0\nPPRINT there\nENDSUB\nGOTO/0,0,0\nCALSUB/1\nGOTO/0,5,0\nCALSUB/1\n";
    let found = events(text);
    assert_eq!(
        found,
        [
            "5:1 feed 0 0 0 axis 0 0 1 None",
            "2:1 feed 1 0 0 axis 0 0 1 None",
            "3:1 message there",
            "7:1 feed 0 5 0 axis 0 0 1 None",
            "2:1 feed 1 5 0 axis 0 0 1 None",
            "3:1 message there",
        ]
    );
    refused("GOTO/0,0,0\nCALSUB/2\n", "2:8+1 no DEFSUB with this number comes before the call");
    refused("GOTO/0,0,0\nDEFSUB/2\nGOTO/1,0,0\n", "3:1+10 the file ends before the ENDSUB of a subprogram");
    refused("GOTO/0,0,0\nENDSUB\n", "2:1+6 ENDSUB without DEFSUB");
    refused("DEFSUB/1\nCALSUB/1\nENDSUB\nGOTO/0,0,0\nCALSUB/1\n", "2:8+1 CALSUB inside a subprogram is not supported");
    refused("DEFSUB/1\nENDSUB\nDEFSUB/1\nENDSUB\nGOTO/0,0,0\n", "3:1+8 this subprogram is already defined");
    refused("DEFSUB/1\n  GOTO/1,2\nENDSUB\nGOTO/0,0,0\n", "2:8+3 GOTO needs 3 or 6 numbers, found 2");
    refused(
        "DEFSUB/1\n  GODLTA/1\nENDSUB\nCALSUB/1\nGOTO/0,0,0\n",
        "2:10+1 GODLTA is relative to the tool position, which is unknown here",
    );
}
