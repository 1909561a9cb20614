//! Holes: records of cycles and the points after them.

use super::*;
use crate::cl::CycleArg;
use crate::cl::record::ClCycleKind;

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
fn the_level_before_a_cycle_counts_along_the_axis_of_each_hole() {
    let returns = |points: &str| -> Vec<String> {
        let text = format!(
            "{NX}MULTAX/ON\nRAPID\nGOTO/60,0,0,1,0,0\nCYCLE/DRILL,RAPTO,3,FEDTO,-5,RTRCTO,AUTO,MMPM,100\n{points}CYCLE/OFF\n"
        );
        let holes = events_without_places(&text, mm()).into_iter().filter(|event| event.starts_with("hole"));
        holes
            .map(|hole| hole.split(" to ").nth(1).and_then(|rest| rest.split(' ').next()).expect("a level").to_owned())
            .collect()
    };
    let around = "GOTO/40,0,0,1,0,0\nGOTO/0,40,0,0,1,0\nGOTO/-40,0,0,-1,0,0\nGOTO/0,-40,0,0,-1,0\n";
    assert_eq!(returns(around), ["20", "20", "20", "20"]);
    // One plane for all holes along the same axis, whatever their height.
    let stepped = "GOTO/40,0,0,1,0,0\nGOTO/45,9,0,1,0,0\nGOTO/0,40,0,0,1,0\nGOTO/9,50,0,0,1,0\nGOTO/30,0,0,1,0,0\n";
    assert_eq!(returns(stepped), ["20", "15", "20", "10", "20"]);
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
    assert!(nx("REAM,RAPTO,3,FEDTO,-5,ORIENT,0").contains("which does not belong to REAM"));
    assert!(nx("BACK,RAPTO,3,FEDTO,-5").contains("back boring leads the tool off the centre"));
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
    let unnamed = read_from(text.as_bytes(), mm()).diagnostics;
    let unnamed: Vec<String> =
        unnamed.into_iter().map(|found| format!("{} {}", found.text, found.help.unwrap_or_default())).collect();
    assert!(unnamed[0].contains("CYCLE/TAP has 2 numbers without a word"), "{unnamed:?}");
    // What it advises posts, and the post of another CAM system is not named for a file of CATIA.
    assert!(unnamed[0].contains("`args = [\"depth\", \"clearance\"]`"), "{unnamed:?}");
    assert!(!unnamed[0].contains("autodesk"), "{unnamed:?}");
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
fn words_of_cycle_on_take_the_place_of_those_of_the_cycle() {
    let text = format!(
        "{NX}CYCLE/DRILL,RAPTO,3,FEDTO,-33,RTRCTO,AUTO,MMPM,250\nGOTO/1,0,0\nCYCLE/ON,FEDTO,-20.0,RTRCTO,AUTO\n\
         GOTO/2,0,0\nCYCLE/ON,RTRCTO,4,MMPM,90\nGOTO/3,0,0\nCYCLE/OFF\nGOTO/9,0,80\nCYCLE/ON,RTRCTO,AUTO\nGOTO/4,0,0\n"
    );
    let found = events_without_places(&text, MM);
    assert_eq!(found[2], "hole 1 0 0 deep 33 from 3 to 50 Drill Some(PerMinute(250.0)) None");
    assert_eq!(found[3], "hole 2 0 0 deep 20 from 3 to 50 Drill Some(PerMinute(250.0)) None");
    assert_eq!(found[4], "hole 3 0 0 deep 20 from 3 to 4 Drill Some(PerMinute(90.0)) None");
    // After CYCLE/OFF the level is that before the cycle is resumed.
    assert_eq!(found[6], "hole 4 0 0 deep 20 from 3 to 80 Drill Some(PerMinute(90.0)) None");
    let fault = |change: &str| errors(&text.replace("CYCLE/ON,FEDTO,-20.0,RTRCTO,AUTO", change));
    assert_eq!(fault("CYCLE/ON,FEDTO,20.0"), ["5:16+4 the sign of this depth is wrong: it leads out of the part"]);
    assert_eq!(fault("CYCLE/ON,RAPTO,-1"), ["5:7+11 the clearance level lies below the top of the hole"]);
    assert!(fault("CYCLE/ON,20")[0].contains("5:10+2 CYCLE with `20` is not supported"));
    assert!(fault("CYCLE/ON,FEDTO,-9,FEDTO,-8")[0].contains("programmed twice"));
    assert_eq!(fault("CYCLE/OFF\nCYCLE/ON,FEDTO,20.0").len(), 1, "one mistake, one message");
    assert!(errors("GOTO/0,0,0\nCYCLE/ON,FEDTO,-3\n")[0].contains("without a cycle before it"));
}

#[test]
fn a_frame_in_force_may_be_stated_again_among_the_points_of_a_cycle() {
    let frame = "MSYS/0,0,9,1,0,0,0,1,0\n";
    let text = |second: &str| {
        format!("{frame}{NX}CYCLE/DRILL,RAPTO,3,FEDTO,-3\nGOTO/1,0,0\n{second}GOTO/2,0,0\nCYCLE/OFF\nGOTO/3,0,9\n")
    };
    let holes = |text: &str| events_without_places(text, MM).iter().filter(|event| event.starts_with("hole")).count();
    assert_eq!(holes(&text(frame)), 2);
    let other = errors(&text("MSYS/0,0,8,1,0,0,0,1,0\n"));
    assert!(other[0].starts_with("6:1+22 this record is not permitted between the points of a CYCLE"), "{other:?}");
    let set_up = "CSYS/1,0,0,0,0,1,0,0,0,0,1,0\n";
    let text = format!(
        "UNIT/MM\nTRNTYP/WORLD,0,0,0\n{set_up}GOTO/0,0,50\nCYCLE/CLEAR\nCYCLE/DRILL,FEDTO,4,RAPTO,3,RTRCTO,25\nGOTO/1,0,0\n{set_up}GOTO/2,0,0\n"
    );
    assert_eq!(events_without_places(&text, UNSTATED).iter().filter(|event| event.starts_with("hole")).count(), 2);
    assert!(
        errors_with(
            &text.replace("25\nGOTO/1,0,0\nCSYS/1,0,0,0,0,1,0,0,0,0,1", "25\nGOTO/1,0,0\nCSYS/1,0,0,0,0,0,1,0,0,-1,0"),
            UNSTATED
        )[0]
        .contains("not permitted between")
    );
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
fn holes_of_autodesk_are_given_by_their_bottom_and_by_planes_across_z() {
    use crate::cl::Dialect;
    let autodesk = || ReadingOptions { dialect: Some(Dialect::Autodesk), ..mm() };
    let fault = |text: String, expected: &str| {
        let found = errors_with(&text, autodesk());
        assert!(found.concat().contains(expected), "{text}: {found:?}");
    };
    let cycle =
        |cycle: &str| format!("UNITS/MM\nRAPID\nGOTO/1,2,15\n{cycle}\nFEDRAT/200.,MMPM\nGOTO/1,2,-12\nCYCLE/OFF\n");
    let drill = cycle("CYCLE/DRILL, 12., MMPM, 200., 15., RAPTO, 10.");
    // Top at 0: the feed begins 5 above it, and the tool returns to 15.
    let found = events_without_places(&drill, autodesk());
    assert_eq!(found[1], "hole 1 2 0 deep 12 from 5 to 15 Drill Some(PerMinute(200.0)) None");
    let found = events_without_places(&cycle("CYCLE/DEEP, 12., INCR, 3., MMPM, 200., 15., DWELL, 2."), autodesk());
    assert!(found[1].starts_with("hole 1 2 0 deep 12 from 15 to 15 Peck"), "{found:?}");
    // The same text of another post has another meaning.
    assert!(errors(&drill)[0].contains("4:7+39 CYCLE/DRILL has 2 numbers without a word"));
    let help = read_from(drill.as_bytes(), MM).diagnostics[0].help.clone().unwrap();
    assert!(help.contains("--dialect autodesk") && help.contains("[cl.cycle.DRILL]"), "{help}");
    // CAMplete: the point is the top, CLEAR the Z of the return level.
    let camplete = "UNITS/MM\nRAPID\nGOTO/1,2,25\nCYCLE/DRILL, FEDTO, 12., MMPM, 200., CLEAR, 25., RTRCTO, 15., RETURN, 15., RAPTO, 5.\n\
                    GOTO/1,2,10\nCYCLE/OFF\n";
    let found = events_without_places(camplete, autodesk());
    assert_eq!(found[1], "hole 1 2 10 deep 12 from 5 to 15 Drill Some(PerMinute(200.0)) None");
    let found = events_without_places(&camplete.replace(", RAPTO, 5.", ""), autodesk());
    assert_eq!(found[1], "hole 1 2 10 deep 12 from 0 to 15 Drill Some(PerMinute(200.0)) None");
    fault(
        camplete.replace("1,2,10", "1,2,-2"),
        "this point is not the top of its hole: 15 above it is Z 13, and CLEAR is 25",
    );
    fault(
        camplete.replace("RAPTO, 5.", "RAPTO, 16."),
        "RAPTO of this cycle lies below the top of the hole or above RETURN",
    );
    fault(camplete.replace("RETURN, 15.", "RETURN, 14."), "programmed twice");
    fault(camplete.replace("FEDTO, 12.", "FEDTO, -12."), "it leads out of the part");
    fault(
        cycle("CYCLE/DRILL, 12., MMPM, 200., 27., RAPTO, 10."),
        "the tool is below the clearance plane of this cycle, Z 27",
    );
    fault(
        cycle("CYCLE/DRILL, 12., MMPM, 200., 15., RAPTO, 16."),
        "the feed of this hole begins -1.0000 mm above its top",
    );
    fault(cycle("CYCLE/DRILL, 12., MMPM, 200., 15., RAPTO, -1."), "a negative RAPTO");
    fault(cycle("CYCLE/BORE, 12., MMPM, 200., 15., 1."), "CYCLE/BORE has 3 numbers without a word");
    fault(drill.replace("2,-12", "2,-12,0,.6,.8"), "planes across Z, and the tool is tilted");
    fault(format!("ORIGIN/0,0,1\n{drill}"), "the coordinates are transformed");
}
