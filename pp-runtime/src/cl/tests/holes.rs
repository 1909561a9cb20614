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
        "this point is not the top of its hole: 15 mm above it is 13 mm along the tool axis, and CLEAR is 25 mm",
    );
    fault(
        camplete.replace("RAPTO, 5.", "RAPTO, 16."),
        "RAPTO of this cycle lies below the top of the hole or above RETURN",
    );
    fault(camplete.replace("RETURN, 15.", "RETURN, 14."), "programmed twice");
    fault(camplete.replace("FEDTO, 12.", "FEDTO, -12."), "it leads out of the part");
    fault(
        cycle("CYCLE/DRILL, 12., MMPM, 200., 27., RAPTO, 10."),
        "the tool is below the clearance plane of this cycle, 27 mm along its axis",
    );
    fault(
        cycle("CYCLE/DRILL, 12., MMPM, 200., 15., RAPTO, 16."),
        "the feed of this hole begins -1.0000 mm above its top",
    );
    fault(cycle("CYCLE/DRILL, 12., MMPM, 200., 15., RAPTO, -1."), "a negative RAPTO");
    fault(cycle("CYCLE/BORE, 12., MMPM, 200., 15., 1."), "CYCLE/BORE has 3 numbers without a word");
    // In a tilted section the planes count along the tool axis, on which the tool was below them.
    fault(
        drill.replace("2,-12", "2,-12,0,.6,.8"),
        "the tool is below the clearance plane of this cycle, 15 mm along its axis",
    );
    fault(format!("ORIGIN/0,0,1\n{drill}"), "the coordinates are transformed");
}

fn autodesk() -> ReadingOptions {
    ReadingOptions { dialect: Some(crate::cl::Dialect::Autodesk), ..mm() }
}

#[test]
fn planes_of_autodesk_count_along_a_tilted_tool() {
    let text = |before: &str| {
        format!(
            "UNITS/MM\nMULTAX/ON\nRAPID\nGOTO/{before},20.,10.,1.,0.,0.\nCYCLE/DRILL, 12., MMPM, 200., 60., RAPTO, 15.\n\
             FEDRAT/200., MMPM\nGOTO/28.,20.,10.,1.,0.,0.\nGOTO/28.,40.,10.,1.,0.,0.\nCYCLE/OFF\n"
        )
    };
    // Bottom at X 28, so the top is at 40, the plane 20 above it and the feed begins 15 below the plane.
    let found = events_without_places(&text("60."), autodesk());
    assert_eq!(found[1], "hole 40 20 10 deep 12 from 5 to 20 Drill Some(PerMinute(200.0)) None");
    assert_eq!(found[2], "hole 40 40 10 deep 12 from 5 to 20 Drill Some(PerMinute(200.0)) None");
    let low = errors_with(&text("59."), autodesk());
    assert!(low[0].contains("the tool is below the clearance plane of this cycle, 60 mm along its axis"), "{low:?}");
}

#[test]
fn without_a_return_level_camplete_returns_to_its_clearance_plane() {
    let text = |cycle: &str| format!("UNITS/MM\nRAPID\nGOTO/1,2,25\nCYCLE/{cycle}\nGOTO/1,2,10\nCYCLE/OFF\n");
    let deep = text("DRILL, DEEP, FEDTO, 12, INCR, 4, MMPM, 200, CLEAR, 25, RAPTO, 5");
    let found = events_without_places(&deep, autodesk());
    assert_eq!(
        found[1],
        "hole 1 2 10 deep 12 from 5 to 15 Peck { first_mm: 4.0, later_mm: 4.0 } Some(PerMinute(200.0)) None"
    );
    // Without RAPTO its retract plane is the clearance plane: the feed begins there.
    let found = events_without_places(&deep.replace(", RAPTO, 5", ""), autodesk());
    assert!(found[1].starts_with("hole 1 2 10 deep 12 from 15 to 15 Peck"), "{found:?}");
    let high = errors_with(&deep.replace("RAPTO, 5", "RAPTO, 16"), autodesk());
    assert!(high[0].contains("the feed of this hole begins 16.0000 mm above its top"), "{high:?}");
    let auto = errors_with(&deep.replace("RAPTO, 5", "RTRCTO, AUTO"), autodesk());
    assert!(auto[0].contains("RTRCTO,AUTO is supported for NX only"), "{auto:?}");
    let rigid = text("RIGID, DEPTH, 12., PITCH, 1.25, CLEAR, 25., RETURN, 15., RAPTO, 5.");
    let found = events_without_places(&rigid, autodesk());
    assert_eq!(
        found[1],
        "hole 1 2 10 deep 12 from 5 to 15 Tap { pitch_mm: Some(1.25) } Some(PerRevolution(1.25)) None"
    );
}

#[test]
fn args_fill_what_a_cycle_does_not_state_and_replace_nothing() {
    let read = |cycle: &str, args: &[CycleArg]| {
        let text = format!("$$*CATIA0\nGOTO/0,0,9\nCYCLE/DRILL,{cycle}\nGOTO/0,0,0\n");
        let options = ReadingOptions { cycle_args: vec![(ClCycleKind::Drill, args.to_vec())], ..mm() };
        let outcome = read_from(text.as_bytes(), options);
        let help = outcome.diagnostics.first().and_then(|found| found.help.clone()).unwrap_or_default();
        let text = outcome.diagnostics.first().map(|found| found.text.clone());
        text.map_or_else(|| Ok(outcome.events[1].split_once(' ').unwrap().1.to_owned()), |text| Err((text, help)))
    };
    use CycleArg::{Clearance, Depth, Dwell, Feed, Return, Step};
    let filled = read("5,DEPTH,20,CLEAR,2,MMPM,100", &[Return]).unwrap();
    assert_eq!(filled, "hole 0 0 0 deep 20 from 2 to 5 Drill Some(PerMinute(100.0)) None");
    for (record, args, name) in [
        ("32,DEPTH,12,CLEAR,2", vec![Depth], "depth"),
        ("20,DEPTH,12,CLEAR,2", vec![Clearance], "clearance"),
        ("32,DEPTH,12,CLEAR,2,RETURN,5", vec![Return], "return"),
        ("32,DEPTH,12,CLEAR,2,DWELL,REV,2", vec![Dwell], "dwell"),
        ("32,DEPTH,12,CLEAR,2,STEP,1", vec![Step], "step"),
        ("32,DEPTH,12,CLEAR,2,IPM,1", vec![Feed], "feed"),
        ("12,13,CLEAR,2", vec![Depth, Depth], "depth"),
    ] {
        let (text, help) = read(record, &args).unwrap_err();
        assert!(text.starts_with(&format!("the {name} of this cycle is stated twice")), "{record}: {text}");
        // Both remedies, taken literally, leave one statement.
        assert!(help.contains(&format!("\"{name}\" in `[cl.cycle.DRILL]`, `args`")), "{help}");
    }
    assert!(read("DEPTH,12,CLEAR,2", &[]).is_ok());
    let (text, _) = read("12,-1,CLEAR,2", &[Depth]).unwrap_err();
    assert!(text.contains("has 2 numbers without a word"), "{text}");
}

#[test]
fn thru_of_creo_states_plates_from_the_top() {
    let read = |cycle: &str| {
        let text = format!("$$-> MFGNO / A\nGOTO / 0,0,50\nCYCLE / THRU, {cycle}\nGOTO / 1,0,0\n");
        let outcome = read_from(text.as_bytes(), mm());
        let fault = outcome.diagnostics.first().map(|found| found.text.clone());
        fault.map_or_else(|| Ok(outcome.events[1].split_once(' ').unwrap().1.to_owned()), Err)
    };
    let gap = |ends: &str, begins: &str| format!("Gap {{ feed_ends_mm: {ends}, feed_begins_mm: {begins} }}");
    let two = read("DEPTH, 12.0, 20.0, 32.0, MMPM, 100, CLEAR,$\n 2.0, RETURN, 5").unwrap();
    assert!(two.starts_with("hole 1 0 0 deep 32 from 2 to 5 Through"), "{two}");
    assert!(two.contains(&gap("12.0", "18.0")) && two.contains("count: 1"), "{two}");
    let three = read("DEPTH,12,20,32,40,52,CLEAR,2").unwrap();
    assert!(three.starts_with("hole 1 0 0 deep 52 from 2 to 2 Through") && three.contains("count: 2"), "{three}");
    assert!(three.contains(&gap("32.0", "38.0")), "{three}");
    assert_eq!(read("DEPTH,12,CLEAR,2").unwrap(), "hole 1 0 0 deep 12 from 2 to 2 Drill None None");
    assert_eq!(read("DEPTH,12,32,CLEAR,2").unwrap_err(), "THRU with 2 depths: a plate is incomplete");
    for wrong in ["12,11,32", "12,20,20", "12,20,32,30,40"] {
        let found = read(&format!("DEPTH,{wrong},CLEAR,2")).unwrap_err();
        assert_eq!(found, "the depths of this THRU do not increase", "{wrong}");
    }
    assert!(read("DEPTH,1,2,3,4,5,6,7,CLEAR,.5").unwrap().contains("count: 3"));
    assert_eq!(read("DEPTH,1,2,3,4,5,6,7,8,9,CLEAR,.5").unwrap_err(), "THRU with more than 4 plates");
    assert_eq!(
        read("DEPTH,12,20,32,CLEAR,2,STEP,1").unwrap_err(),
        "this cycle has a word that does not belong to THRU"
    );
    // Other numbers without a word have no place beside them.
    assert_eq!(read("5,DEPTH,12,20,32,CLEAR,2").unwrap_err(), "CYCLE with `20` is not supported");
    assert_eq!(read("DEPTH,12,20,32,CLEAR,2,5").unwrap_err(), "CYCLE with `5` is not supported");
    // Only the documentation of Creo states what they mean.
    let iso = ReadingOptions { dialect: Some(crate::cl::Dialect::Iso), ..mm() };
    let found = errors_with("GOTO/0,0,50\nCYCLE/THRU,DEPTH,12,20,32,CLEAR,2\nGOTO/1,0,0\n", iso);
    assert_eq!(found, ["2:18+8 several numbers after DEPTH: what they mean is known of Creo only"]);
}

#[test]
fn threads_per_inch_and_a_pitch_state_the_thread() {
    let read = |units: &str, cycle: &str| {
        let text = format!("$$-> MFGNO / A\nUNITS / {units}\nGOTO / 0,0,9\nCYCLE / {cycle}\nGOTO / 1,0,0\n");
        let mut reader = ClReader::new(text.as_bytes(), ReadingOptions::default());
        let mut pitch = None;
        while let Some((_, event)) = reader.next_event().unwrap() {
            if let Event::Motion(ToolMotion::Hole(hole)) = event {
                let crate::program::Drilling::Tap { pitch_mm } = hole.drilling else { panic!("{:?}", hole.drilling) };
                pitch = pitch_mm;
            }
        }
        let fault = reader.diagnostics().first().map(|found| found.text.clone());
        fault.map_or_else(|| Ok(pitch.map(|pitch| (pitch * 1e6).round() / 1e6)), Err)
    };
    assert_eq!(read("MM", "TAP, DEPTH, 15.0, TPI, 20.0, CLEAR, 2.0"), Ok(Some(1.27)));
    assert_eq!(read("INCHES", "TAP, DEPTH, 0.6, TPI, 20.0, CLEAR, 0.1"), Ok(Some(1.27)));
    assert_eq!(read("INCHES", "TAP, DEPTH, 0.6, PITCH, 0.05, CLEAR, 0.1"), Ok(Some(1.27)));
    assert_eq!(read("MM", "TAP, DEPTH, 15, TPI, 20, MMPR, 1.27, CLEAR, 2"), Ok(Some(1.27)));
    let two = Err("this cycle states two pitches".to_owned());
    assert_eq!(read("MM", "TAP, DEPTH, 15, TPI, 20, MMPR, 1.25, CLEAR, 2"), two);
    assert_eq!(read("MM", "TAP, DEPTH, 15, TPI, 20, PITCH, 1.25, CLEAR, 2"), two);
    assert_eq!(read("MM", "TAP, DEPTH, 15, TPI, 20, TPI, 20, CLEAR, 2"), two);
    assert_eq!(read("MM", "TAP, DEPTH, 15, TPI, 0, CLEAR, 2"), Err("TPI must be above 0".to_owned()));
    assert!(read("MM", "DRILL, DEPTH, 15, TPI, 20, CLEAR, 2").unwrap_err().contains("which DRILL does not make"));
}

#[test]
fn a_countersink_is_as_deep_as_its_cone() {
    let read = |cycle: &str| {
        let text = format!("$$-> MFGNO / A\nGOTO / 0,0,9\nCYCLE / {cycle}, CLEAR, 2\nGOTO / 1,0,0\n");
        let outcome = read_from(text.as_bytes(), mm());
        let fault = outcome.diagnostics.first().map(|found| found.text.clone());
        fault.map_or_else(|| Ok(outcome.events[1].split(' ').nth(6).unwrap().parse::<f64>().unwrap()), Err)
    };
    let near =
        |found: Result<f64, String>, depth: f64| assert!((found.clone().unwrap() - depth).abs() < 1e-9, "{found:?}");
    near(read("CSINK, DIAMET, 10, TLANGL, 90"), 5.0);
    near(read("CSINK, TLANGL, 120, DIAMET, 10"), 5.0 / 3.0_f64.sqrt());
    near(read("CSINK, DEPTH, 5, DIAMET, 10, TLANGL, 90"), 5.0);
    assert_eq!(
        read("CSINK, DEPTH, 4.9, DIAMET, 10, TLANGL, 90").unwrap_err(),
        "this depth is 4.9, and by DIAMET and TLANGL it is 5.0000"
    );
    assert!(read("CSINK, DIAMET, 10").unwrap_err().contains("one of them is absent"));
    assert!(read("CSINK, DIAMET, 10, TLANGL, 180").unwrap_err().contains("an angle between 0 and 180 degrees"));
    assert!(read("DRILL, DIAMET, 10, TLANGL, 90").unwrap_err().contains("which DRILL is not"));
}
