//! Frames and coordinate transforms.

use super::*;
use crate::cl::{Frames, SetUpBegins};

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
    let creo = "$$-> A\nTRANS/1,2,3\nGOTO/0,0,0\n";
    assert!(errors(creo)[0].contains("TRANS of Creo"));
    let given = ReadingOptions { trans_adds: true, ..mm() };
    assert_eq!(events_without_places(creo, given), ["feed 1 2 3 axis 0 0 1 None"]);
    assert!(errors("$$-> A\nROTATE/AAXIS,90\nGOTO/0,0,0\n")[0].contains("ROTATE is refused"));
    let rotabl = errors("$$-> A\nROTABL/90,CLW\nGOTO/0,0,0\n");
    assert!(rotabl[0].contains("this form of ROTABL is refused"), "{rotabl:?}");
}

/// Message to the operator before the stop between two set-ups.
const CLAMPED: &str = "message NEXT SET-UP: CLAMP THE PART AGAIN, THEN START";

/// Two frames: the origin of the second is at (10, 0, 0) of the first, its X is the model's Y.
const TWO_FRAMES: &str = "MSYS/1,0,0,1,0,0,0,1,0\nGOTO/1,2,3\nMSYS/11,0,0,0,1,0,-1,0,0\nGOTO/1,2,3,.6,0,.8\n";

#[test]
fn a_second_frame_is_mapped_into_the_first_or_begins_a_set_up() {
    let found = events_without_places(TWO_FRAMES, ReadingOptions { frames: Some(Frames::Main), ..mm() });
    assert_eq!(found[1..], ["SafeSequence", "feed 8 1 3 axis 0 0.6 0.8 None"]);
    let found = events_without_places(TWO_FRAMES, with_set_up(&[2], None));
    assert_eq!(found[1..], ["Home", CLAMPED, "Stop", "SetUp(2)", "feed 1 2 3 axis 0.6 0 0.8 None"]);
    // The first frame again, then the second under its own number.
    let back = format!("{TWO_FRAMES}MSYS/1,0,0,1,0,0,0,1,0\nGOTO/1,2,3,0,0,1\nMSYS/11,0,0,0,1,0,-1,0,0\nGOTO/0,0,0\n");
    let found = events_without_places(&back, ReadingOptions { frames: Some(Frames::Main), ..mm() });
    assert!(found[4].starts_with("feed 1 2 3 axis 0 0 1") && found[6].starts_with("feed 10 0 0"), "{found:?}");
    let found = events_without_places(&back, with_set_up(&[2], None));
    let set_ups: Vec<&String> = found.iter().filter(|event| event.starts_with("SetUp")).collect();
    assert_eq!(set_ups, ["SetUp(2)", "SetUp(1)", "SetUp(2)"]);
}

/// A STOP at the end of a set-up is the stop in which the part is clamped again: park, text, stop.
#[test]
fn a_stop_before_another_set_up_is_the_stop_between_them() {
    let text = |between: &str| TWO_FRAMES.replace("\nMSYS/11", &format!("\n{between}MSYS/11"));
    let found = |between: &str| events_without_places(&text(between), with_set_up(&[2], None))[1..].to_vec();
    let (change, then) = (["Home", CLAMPED, "Stop", "SetUp(2)"], "feed 1 2 3 axis 0.6 0 0.8 None");
    assert_eq!(found("STOP\n")[..4], change);
    let named = found("STOP\nEND-OF-PATH\nTOOL PATH/OP20,TOOL,A\n");
    assert!(named[..4] == change && named[4].starts_with("operation") && named[5] == then, "{named:?}");
    // What acts or is displayed between them separates them.
    let message = found("STOP\nPPRINT/MEASURE\n");
    assert_eq!(message[..2], ["Stop", "message MEASURE"]);
    assert_eq!(message[2..6], change);
    for between in ["STOP\nCOOLNT/OFF\n", "STOP\nSTOP\n", "STOP\nLOAD/TOOL,2\n"] {
        assert_eq!(found(between)[0], "Stop", "{between}");
        assert_eq!(found(between).iter().filter(|event| *event == "Stop").count(), 2, "{between}");
    }
    // Without another set-up it stops where it is written, and the name comes after it.
    let alone = events_without_places("GOTO/1,2,3\nSTOP\nTOOL PATH/OP20,TOOL,A\nGOTO/1,2,9\nSTOP\n", mm());
    let stops: Vec<usize> = alone.iter().enumerate().filter(|(_, event)| *event == "Stop").map(|(at, _)| at).collect();
    assert_eq!(stops, [1, 4], "{alone:?}");
}

/// A face whose Z is the model's X, with its origin at (50, 0, 0), after a first face.
const FACE: &str = "MSYS/0,0,0,1,0,0,0,1,0\nGOTO/0,0,9\nMSYS/50,0,0,0,0,-1,0,1,0\n";

#[test]
fn tool_axes_state_in_which_frame_the_points_are() {
    let own = events_without_places(&format!("{FACE}GOTO/1,2,3,0,0,1\nGOTO/1,2,0\n"), MM);
    assert_eq!(own[1..], ["SafeSequence", "feed 53 2 -1 axis 1 0 0 None", "feed 50 2 -1 axis 1 0 0 None"]);
    let first = events_without_places(&format!("{FACE}GOTO/60,2,3,1,0,0\nGOTO/50,2,3\n"), MM);
    assert_eq!(first[1..], ["SafeSequence", "feed 60 2 3 axis 1 0 0 None", "feed 50 2 3 axis 1 0 0 None"]);
    let by_tlaxis = events_without_places(&format!("{FACE}TLAXIS/1,0,0\nGOTO/60,2,3\n"), MM);
    assert_eq!(by_tlaxis[1..], ["SafeSequence", "feed 60 2 3 axis 1 0 0 None"]);
    // Without one, plunge and retract along its own Z.
    let bare = events_without_places(&format!("{FACE}RAPID\nGOTO/1,2,30\nGOTO/1,2,0\nGOTO/9,2,0\n"), MM);
    assert_eq!(bare[2], "rapid 80 2 -1 axis 1 0 0 None");
    let mut reader = ClReader::new(FACE.as_bytes(), mm());
    while reader.next_event().unwrap().is_some() {}
    assert_eq!(reader.frame_vote(), crate::cl::FrameVote { mapped: 1, ..Default::default() });
}

#[test]
fn a_frame_is_refused_where_the_records_state_both_or_neither() {
    let fault = |text: &str| errors(&format!("{FACE}{text}"));
    let unknown = |found: Vec<String>, why: &str| {
        assert!(found[0].contains("nothing states in which of them") && found[0].ends_with(why), "{found:?}");
    };
    unknown(fault("GOTO/1,2,3,.6,0,.8\n"), "the tool axis 0.6, 0, 0.8 is along neither Z");
    unknown(fault("GOTO/1,2,3\nGOTO/9,9,0\n"), "no plunge or retract is along its Z");
    let both = fault("GOTO/1,2,3,0,0,1\nGOTO/60,2,3,1,0,0\n");
    assert!(
        both[0].contains("in it by the tool axis 0, 0, 1 of line 4") && both[0].contains("1, 0, 0 of line 5"),
        "{both:?}"
    );
    // Its points are in the first frame, where the tool comes along X; no record states that axis.
    let sideways = fault("RAPID\nGOTO/90,2,3\nGOTO/50,2,3\nGOTO/50,9,3\nRAPID\nGOTO/90,9,3\n");
    assert!(sideways[0].starts_with("3:1+1") && sideways[0].contains("their tool axis is not stated"), "{sideways:?}");
    // Two faces, each in its own way.
    let other = "MSYS/0,0,0,1,0,0,0,0,1\nGOTO/1,-9,3,0,-1,0\n";
    let mixed = fault(&format!("GOTO/1,2,3,0,0,1\n{other}"));
    assert!(mixed[0].contains("in it by the tool axis of line 4") && mixed[0].contains("of line 6"), "{mixed:?}");
    for (frames, axis) in [(Frames::Main, "1,0,0"), (Frames::First, "0,0,1")] {
        let given = ReadingOptions { frames: Some(frames), ..mm() };
        let found = errors_with(&format!("{FACE}GOTO/1,2,3,{axis}\n"), given);
        assert!(found[0].contains("is contradicted by the tool axis"), "{found:?}");
    }
    assert!(fault("CLEARP/XYPLAN,9\nGOTO/1,2,3,0,0,1\n")[0].contains("CLEARP comes before a point"));
}

#[test]
fn an_option_decides_for_a_path_that_tilts_the_tool_from_its_begin() {
    for (frames, expected) in [(Frames::Main, "feed 53 2 -1"), (Frames::First, "feed 1 2 3")] {
        let given = ReadingOptions { frames: Some(frames), ..mm() };
        let found = events_without_places(&format!("{FACE}GOTO/1,2,3,.6,0,.8\nGOTO/1,2,3,0,.6,.8\n"), given);
        assert!(found[2].starts_with(expected), "{found:?}");
    }
}

/// The points of a set-up of its own are in its frame, unless a tool axis says that they are in the first.
#[test]
fn points_of_a_set_up_may_be_in_the_first_frame() {
    let found = events_without_places(&format!("{FACE}GOTO/60,2,3,1,0,0\n"), with_set_up(&[2], None));
    assert_eq!(found.last().map(String::as_str), Some("feed -3 2 10 axis 0 0 1 None"));
}

/// Reading with a second set-up that has these frames, or begins with this operation.
fn with_set_up(frames: &[u32], operation: Option<&str>) -> ReadingOptions {
    let operation = operation.map(str::to_owned);
    ReadingOptions { set_ups: vec![SetUpBegins { number: 2, frames: frames.to_vec(), operation }], ..mm() }
}

/// Frames 1 and 3 belong to the first set-up, 2 and 4 to the second: 3 is mapped into 1, and 4 into 2.
#[test]
fn frames_of_a_set_up_are_mapped_into_its_first() {
    let frame = |x: u32| format!("MSYS/{x},0,0,1,0,0,0,1,0\nGOTO/1,0,0\n");
    let text: String = [0, 10, 5, 17].map(frame).concat();
    let found =
        events_without_places(&text, ReadingOptions { frames: Some(Frames::Main), ..with_set_up(&[2, 4], None) });
    let points: Vec<&str> = found.iter().filter_map(|event| event.strip_prefix("feed ")?.split(' ').next()).collect();
    assert_eq!(points, ["1", "1", "6", "8"], "{found:?}");
    assert_eq!(found.iter().filter(|event| *event == "Stop").count(), 3);
    // Without a table the second frame is refused with one to paste.
    assert!(errors_with(&text, mm())[0].contains("the frame in line 3 differs"));
}

#[test]
fn a_set_up_may_begin_with_the_name_of_an_operation() {
    let text = "TOOL PATH/OP10,TOOL,A\nMSYS/0,0,0,1,0,0,0,1,0\nGOTO/1,0,0\nEND-OF-PATH\n\
                TOOL PATH/OP20,TOOL,A\nMSYS/10,0,0,1,0,0,0,1,0\nGOTO/1,0,0\nEND-OF-PATH\n\
                TOOL PATH/OP30,TOOL,A\nMSYS/15,0,0,1,0,0,0,1,0\nGOTO/1,0,0\n";
    assert!(errors_with(text, with_set_up(&[], Some("op20")))[0].contains("the frame in line 10 differs"));
    let found =
        events_without_places(text, ReadingOptions { frames: Some(Frames::Main), ..with_set_up(&[], Some("op20")) });
    let position = |what: &str| found.iter().position(|event| event.contains(what)).expect("an event");
    assert!(position("SetUp(2)") < position("OP20") && position("Stop") < position("SetUp(2)"), "{found:?}");
    let points: Vec<&str> = found.iter().filter_map(|event| event.strip_prefix("feed ")?.split(' ').next()).collect();
    assert_eq!(points, ["1", "1", "6"], "the third frame is mapped into the second: {found:?}");
}

#[test]
fn a_frame_before_units_is_in_that_unit_too() {
    let text = "MSYS/1,0,0,1,0,0,0,1,0\nUNITS/INCH\nGOTO/0,0,0\nMSYS/1,0,0,1,0,0,0,1,0\nGOTO/1,0,0\nMSYS/2,0,0,1,0,0,0,1,0\nGOTO/0,0,0\n";
    let found = events_without_places(text, ReadingOptions { frames: Some(Frames::Main), ..ReadingOptions::default() });
    assert_eq!(found[1..], ["feed 25.4 0 0 axis 0 0 1 None", "SafeSequence", "feed 25.4 0 0 axis 0 0 1 None"]);
}

#[test]
fn a_clearance_plane_belongs_to_its_frame() {
    let text = format!("CLEARP/XYPLAN,50\n{TWO_FRAMES}RETRCT\n");
    let found = errors_with(&text, with_set_up(&[2], None));
    assert_eq!(found, ["6:1+6 RETRCT needs a clearance plane, and no CLEARP comes before it"]);
    let found = events_without_places(&text, ReadingOptions { frames: Some(Frames::Main), ..mm() });
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

/// Three rows of a frame of CATIA with this origin.
fn rows(x: f64) -> String {
    format!("$$ 1. 0. 0. {x}\n$$ 0. 1. 0. -170.\n$$ 0. 0. 1. 20.\n")
}

#[test]
fn a_matrix_of_catia_is_a_frame_without_its_label_too() {
    let title = "$$     CATIA APT VERSION 1.0\n";
    let expected = "the frame in line 9 differs from the workpiece frame in line 5, and nothing states in which of them its points \
                    are: its Z is that of the first frame";
    refused(
        &format!("$$*CATIA0\n$$ P\n{}GOTO/1,2,3\n{}GOTO/1,2,3\n", rows(-220.0), rows(500.0)),
        &format!("9:1+15 {expected}"),
    );
    for begin in
        ["", title, "$$ 7. 8. 9. 10.\n", "$$ 7. 8. 9. 10.\n$$ 7. 8. 9. 10.\n$$ 7. 8. 9. 10.\n", "$$*CATIA0\n$$ P\n"]
    {
        let text = format!("{begin}{}GOTO/1,2,3\n{begin}{}GOTO/1,2,3\n", rows(-220.0), rows(500.0));
        assert!(errors(&text).concat().contains("differs from the workpiece frame"), "{text}");
        let mapped = events_without_places(&text, ReadingOptions { frames: Some(Frames::Main), ..mm() });
        assert_eq!(mapped[1..], ["SafeSequence", "feed 721 2 3 axis 0 0 1 None"], "{text}");
        let equal = format!("{begin}{}GOTO/1,2,3\n{begin}{}GOTO/1,2,3\n", rows(-220.0), rows(-220.0));
        assert_eq!(events(&equal).len(), 2, "{equal}");
    }
}

#[test]
fn four_numbers_in_comments_that_are_no_frame_are_a_comment() {
    let row = "$$ 1. 0. 0. 5.\n";
    for comment in [row.to_owned(), row.repeat(2), row.repeat(3), row.repeat(4), "$$ 1. 0. 0.\n".repeat(3)] {
        assert_eq!(events(&format!("{}GOTO/1,2,3\n{comment}GOTO/1,2,3\n", rows(0.0))).len(), 2, "{comment}");
    }
    // Rows between which a record comes are none.
    let apart = "$$ 1. 0. 0. 500.\n$$ 0. 1. 0. -170.\nGOTO/1,2,3\n$$ 0. 0. 1. 20.\n";
    assert_eq!(events(&format!("{}{apart}", rows(0.0))).len(), 1);
}

/// `-> CSYS` of a frame with this origin, after `$$` or REMARK.
fn creo_frame(word: &str, x: u32) -> String {
    format!("{word}-> CSYS / 1,0,0,{x},0,1,0,0,$\n0,0,1,0\nGOTO/1,2,3\n")
}

#[test]
fn a_remark_with_an_arrow_is_the_record_that_a_comment_with_one_is() {
    for word in ["$$", "REMARK ", "remark  "] {
        let text = format!("{}{}", creo_frame(word, 0), creo_frame(word, 100));
        assert!(
            errors(&text).concat().contains("the frame in line 4 differs from the workpiece frame in line 1"),
            "{text}"
        );
        let mapped = events_without_places(&text, ReadingOptions { frames: Some(Frames::Main), ..mm() });
        assert_eq!(mapped[1..], ["SafeSequence", "feed 101 2 3 axis 0 0 1 None"], "{text}");
    }
    let tool = events("LOADTL/1\nREMARK -> CUTTER / 12.5\nGOTO/0,0,0\n");
    assert!(tool[0].contains("diameter_mm: Some(12.5)"), "{tool:?}");
    assert!(errors("REMARK -> MFGNO / A\nTRANS/1,2,3\nGOTO/0,0,0\n")[0].contains("TRANS of Creo"));
    assert!(errors("REMARK Pro/CLFILE Version 15\nTRANS/1,2,3\nGOTO/0,0,0\n")[0].contains("TRANS of Creo"));
    assert_eq!(events("REMARK CSYS / 1,2\nREMARK\nREMARK/ > A -> CSYS / 1\nGOTO/0,0,0\n").len(), 1);
    refused("REMARK -> CSYS / 1,2,3\nGOTO/0,0,0\n", "1:18+5 CSYS needs 12 numbers, found 3");
}

#[test]
fn a_word_of_a_frame_or_of_motions_that_are_not_cut_is_never_inert() {
    for word in ["DNTCUT", "CUT", "SCALE", "MCS2", "MIRROR", "MODSYS", "PLANE", "REFSYS", "WPLANE"] {
        let text = format!("{word}/1,0,0,0,0,1,0,0,0,0,1,0\nGOTO/0,0,0\n");
        let inert = ReadingOptions { inert: vec![word.to_owned()], ..mm() };
        assert!(errors_with(&text, inert.clone())[0].contains(&format!("{word} is refused: ")), "{word}");
        let help = read_from(text.as_bytes(), inert).diagnostics[0].help.clone().unwrap();
        assert!(!help.contains("--inert"), "{help}");
    }
    // One that is read is read.
    let upright = "CAMERA/1,0,0,0,0,1,0,0,0,0,1,0\nGOTO/0,0,0\n";
    let other = "CAMERA/1,0,0,9,0,1,0,0,0,0,1,0\nGOTO/0,0,0\n";
    let inert = ReadingOptions { inert: vec!["CAMERA".to_owned()], ..mm() };
    assert!(errors_with(&format!("{upright}{other}"), inert)[0].contains("the frame in line 3 differs"));
}
