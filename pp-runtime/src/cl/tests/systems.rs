//! Words and lines of single CAM systems, and what is never passed over.

use super::*;
use crate::cl::{Dialect, Frames, OwnStatement};

fn inert(word: &str) -> ReadingOptions {
    ReadingOptions { inert: vec![word.to_owned()], ..mm() }
}

#[test]
fn a_statement_with_the_numbers_of_a_frame_is_not_passed_over() {
    let text = |statement: &str| format!("{statement}\nGOTO/1,2,3\n");
    for statement in ["WPOS/1,2,3,4,5", "WPOS/A,1,B,2,C,3,D,4,E,5", "WPOS", "WPOS/1 2 3 4 5 6"] {
        assert_eq!(events_with(&text(statement), inert("WPOS")).len(), 1, "{statement}");
    }
    for statement in ["WPOS/1,2,3,4,5,6", "wpos / P,1.,-2,.3,V,0,0,1.E0", "WPOS/1,2,3/4,5,6", "WPOS/0,0,0,$\n1,0,0"] {
        let found = errors_with(&text(statement), inert("WPOS"));
        assert!(found.len() == 1 && found[0].contains("six or more numbers"), "{statement}: {found:?}");
    }
    // A row of the table that is inert stays inert.
    assert_eq!(events(&text("PAINT/1,2,3,4,5,6,7")).len(), 1);
    assert_eq!(events(&text("CSI_SET_TOOL/1,2,3,4,5,6,7")).len(), 1);
    assert_eq!(events(&text("TOOLNO/1,2,3,4,5,6,7")).len(), 1);
}

#[test]
fn no_block_takes_the_place_of_a_statement_with_the_numbers_of_a_frame() {
    let of = |statement: &str| OwnStatement::new(statement, "M68").map(|_| ());
    assert_eq!(of("CHUCK/OPEN,1,2"), Ok(()));
    assert!(of("WPOS/1,2,3,0,0,1").is_err_and(|why| why.contains("may state a frame")));
    assert!(of("MCSYS/1").is_err() && of("TCP/ON").is_err() && of("WPLANE/1").is_err());
    // The numbers of a probe are its own.
    assert!(OwnStatement::probing("TOUCH/1,2,3,0,0,1", &["M68".to_owned()]).is_ok());
}

#[test]
fn frames_and_modes_of_other_systems_are_refused_also_if_they_are_inert() {
    for (statement, text) in [
        ("WPLANE/1", "it states a frame"),
        ("PLANE/XYPLAN", "it states a frame"),
        ("TCPCTL/ON", "it switches between points of the tool tip and positions of axes"),
        ("ROTHED/30", "it commands machine axes"),
        ("ZERO/2", "it selects a zero point"),
    ] {
        let word = statement.split('/').next().expect("a word");
        let found = errors_with(&format!("{statement}\nGOTO/0,0,0\n"), inert(word));
        assert!(found.len() == 1 && found[0].contains(text), "{statement}: {found:?}");
    }
}

const LISTING: &str = "============================================================\n\
    Information listing created by :  planner\n\
    Date                           :  28-Nov-2026 18:00:00\n\
    Current work part              :  C:\\parts\\plate.prt\n\
    Node name                      :  ws12\n\
    ============================================================\n\
    TOOL PATH/FACE,TOOL,MILL\n\
    MSYS/0,0,0,1,0,0,0,1,0\n\
    GOTO/0,0,50,0,0,1\n\
    END-OF-PATH\n\
    Tool Path Listing has 17 lines.\n";

#[test]
fn a_listing_of_nx_is_its_records_alone() {
    let found = events_without_places(LISTING, MM);
    assert_eq!(found, ["operation FACE", "feed 0 0 50 axis 0 0 1 None"]);
    let mut reader = ClReader::new(LISTING.as_bytes(), mm());
    while reader.next_event().unwrap().is_some() {}
    assert!(reader.frame().is_some() && reader.dialect() == Dialect::Nx);
}

#[test]
fn only_the_known_lines_around_a_listing_are_passed_over() {
    for line in [
        "Date 28-Nov-2026",
        "Tool Path Listing has lines.",
        "Tool Path Listing has 17 lines. GOTO/1,2,3",
        "Tool Path Listing has 1,2,3,4,5,6 lines.",
        "Machine Coordinate System :  1,0,0",
        "===== X",
        "==/",
    ] {
        assert_eq!(errors(&format!("GOTO/0,0,0\n{line}\n")).len(), 1, "{line}");
    }
    refused(
        "TOOL PATH FACE,TOOL,MILL\nGOTO/0,0,0\n",
        "1:11+14 expected a slash after TOOL PATH, found `FACE,TOOL,MILL`",
    );
}

/// A quarter revolution about X: the Z of the second frame is Y of the first, reversed.
const TILTED: [&str; 2] = ["1,0,0,0,0,1,0,-1,0,10,20,30", "NUM,1,POINT,10,20,30,VECTOR,1,0,0,VECTOR,0,0,1"];

#[test]
fn mcs_and_mcsys_are_frames_in_the_workpiece_frame() {
    let autodesk = ReadingOptions { dialect: Some(Dialect::Autodesk), frames: Some(Frames::Main), ..mm() };
    for statement in [format!("MCS/{}", TILTED[0]), format!("MCSYS/{}", TILTED[1])] {
        // Also if it is the first that is stated.
        let found = events_without_places(&format!("{statement}\nGOTO/1,2,3\n"), autodesk.clone());
        assert_eq!(found, ["SafeSequence", "feed 11 17 32 axis 0 -1 0 None"], "{statement}");
        let refused =
            errors_with(&format!("{statement}\nGOTO/1,2,3\n"), ReadingOptions { frames: None, ..autodesk.clone() });
        assert!(refused.len() == 1 && refused[0].contains("differs from the workpiece frame"), "{refused:?}");
    }
    let upright = "MCS/1,0,0,0,1,0,0,0,1,0,0,0\nMCSYS/NUM,1,POINT,0,0,0,VECTOR,1,0,0,VECTOR,0,1,0\nGOTO/1,2,3\n";
    assert_eq!(events_without_places(upright, MM), ["feed 1 2 3 axis 0 0 1 None"]);
}

#[test]
fn mcs_of_another_system_is_refused_where_it_is_not_the_workpiece_frame() {
    let found =
        errors_with(&format!("MCS/{}\nGOTO/1,2,3\n", TILTED[0]), ReadingOptions { frames: Some(Frames::Main), ..mm() });
    assert!(found.len() == 1 && found[0].contains("MCS states a frame, and whether"), "{found:?}");
    let other = errors("MCSYS/NUM,2,POINT,0,0,0,VECTOR,1,0,0,VECTOR,0,1,0\nGOTO/1,2,3\n");
    assert!(other.len() == 1 && other[0].starts_with("1:11+1 MCSYS with work offset `2` is refused"), "{other:?}");
    assert_eq!(errors("MCSYS/1,2,3,4,5,6\nGOTO/1,2,3\n").len(), 1);
}

#[test]
fn camera_of_the_g_post_format_is_the_frame_of_the_comment_of_creo() {
    let matrix = "0,-1,0,1,  $\n 1,0,0,2,  $\n 0,0,1,3\n";
    let text = |first: &str, second: &str| format!("{first}\nGOTO/1,0,0\n{second}{matrix}GOTO/1,0,0\n");
    let options = ReadingOptions { frames: Some(Frames::Main), ..mm() };
    let camera = events_without_places(&text("CAMERA/1,0,0,0,0,1,0,0,0,0,1,0", "CAMERA/ "), options.clone());
    let comment = events_without_places(&text("$$-> CSYS / 1,0,0,0,0,1,0,0,0,0,1,0", "$$-> CSYS / "), options);
    assert_eq!(camera, comment);
    assert_eq!(camera[2], "feed 1 3 3 axis 0 0 1 None");
}

/// A file of *Mori APT* of Autodesk.
const MORI: &str = "PARTNO/ '1001'\nBEGIN\nUNITS/ MM\nMATERL/ TYPE, 5, COND, 6, XDIM, 100, YDIM, 80, ZDIM, 20\n\
    OPNAME/ 'Face1'\nAPPLY/ MILL\nMCSYS/ NUM, 1, POINT, 0, 0, 0, VECTOR, 1, 0, 0, VECTOR, 0, 1, 0\n\
    CLAMP/ TABLE, ALL, AUTO\nTOOLNO/ 3, MILL, OSETNO, 13, 23\nCOOLNT/ THRU\nCOOLNT/ ON\n\
    LOAD/ TOOL, 3, 'flat 10, long', NEXTTL, 4\nSPINDL/ RPM, 3000, CLW\nCUTCOM/ ON, LENGTH, 13\n\
    RAPID\nGOTO/ 30, 20, 5\nFEDRAT/ PERMIN, 500\nARCSLP/ -1\n\
    MOVARC/ CENTER, 30, 30, 5, AXIS, 0, 0, 1, RADIUS, 10\nGOTO/ 40, 30, 4\n\
    MOVARC/ CENTER, 40, 40, 4, AXIS, 0, 0, -1, RADIUS, 10\nGOTO/ 30, 40, 4\n\
    CUTCOM/ ON\nCUTCOM/ LEFT, XYPLAN, OSETNO, 23\nCOOLNT/ OFF\nGOHOME/\nEND/\n";

#[test]
fn a_file_of_mori_apt_is_read() {
    let found = events_without_places(MORI, UNSTATED);
    assert_eq!(
        found,
        [
            "name 1001",
            "operation Face1",
            "Coolant(Through)",
            "Tool(ToolCall { number: 3, length_mm: None, length_offset: Some(13), diameter_mm: None, corner_radius_mm: None })",
            "Spindle(On { speed_rev_per_min: Some(3000.0), rotation: Some(Clockwise) })",
            "rapid 30 20 5 axis 0 0 1 None",
            "arc to 40 30 4 about 0 0 1 through 90.000",
            "arc to 30 40 4 about 0 0 -1 through 90.000",
            "Compensation(Compensation { side: Left, register: Some(23), in_xy_plane: true })",
            "Coolant(Off)",
            "Home",
        ]
    );
}

#[test]
fn toolno_states_the_register_of_its_tool_in_all_calls_after_it() {
    let text = "TOOLNO/1,MILL,OSETNO,11,21\nTOOLNO/2,MILL,OSETNO,12\nLOADTL/1\nGOTO/0,0,0\nLOADTL/2\nGOTO/0,0,0\nLOADTL/1\nGOTO/0,0,0\n";
    let found = events_without_places(text, MM);
    let registers: Vec<&str> =
        found.iter().filter_map(|event| event.split_once("length_offset: ")?.1.split(", ").next()).collect();
    assert_eq!(registers, ["Some(11)", "Some(12)", "Some(11)"]);
}

#[test]
fn forms_of_mori_apt_that_contradict_are_refused() {
    for (old, new, text) in [
        ("ARCSLP/ -1", "ARCSLP/ -2", "an arc rises or falls by 1.0000 mm, and its ARCSLP states 2.0000 mm"),
        ("ARCSLP/ -1", "ARCSLP/ -1\nGOTO/ 30, 20, 5", "expected MOVARC after ARCSLP, found another motion"),
        ("ON, LENGTH, 13", "ON, LENGTH, 14", "this change of the length offset does not directly follow the tool call"),
        ("OSETNO, 13", "OSETNO, 0", "`OSETNO` 0 would cancel the length offset"),
        ("long'", "long", "the quote that begins here does not end"),
        ("APPLY/ MILL", "APPLY/ TURN", "this record belongs to turning"),
        ("ALL, AUTO", "ALL, ON", "CLAMP is refused"),
        ("NUM, 1, POINT", "NUM, 3, POINT", "MCSYS with work offset `3` is refused"),
    ] {
        let found = errors_with(&MORI.replace(old, new), UNSTATED);
        assert!(found.first().is_some_and(|first| first.contains(text)), "{new}: {found:?}");
    }
}

#[test]
fn tcp_stands_beside_multax() {
    let text = "MULTAX/ON\nTCP/ON\nGOTO/1,2,3,0,.6,.8\nTCP/OFF\nMULTAX/OFF\nGOTO/1,2,3,0,0,1\n";
    assert_eq!(events(text).len(), 2);
    let tilted = errors(&text.replace("3,0,0,1", "3,0,.8,.6"));
    assert!(tilted.len() == 1 && tilted[0].contains("holds the tool axis"), "{tilted:?}");
    let unstated = errors(&text.replace("3,0,0,1", "3"));
    assert!(unstated.len() == 1 && unstated[0].contains("no tool axis i, j, k"), "{unstated:?}");
}

#[test]
fn coolnt_on_keeps_the_kind_that_is_on() {
    let coolants = |text: &str| {
        let found = events_without_places(&format!("{text}\nGOTO/0,0,0\n"), MM);
        found.into_iter().filter(|event| event.starts_with("Coolant")).collect::<Vec<_>>()
    };
    assert_eq!(coolants("COOLNT/MIST\nCOOLNT/ON"), ["Coolant(Mist)"]);
    assert_eq!(coolants("COOLNT/ON\nCOOLNT/MIST"), ["Coolant(On)", "Coolant(Mist)"]);
    assert_eq!(coolants("COOLNT/MIST\nCOOLNT/OFF\nCOOLNT/ON"), ["Coolant(Mist)", "Coolant(Off)", "Coolant(On)"]);
    // ON for another tool is its own kind.
    assert_eq!(coolants("COOLNT/MIST\nLOADTL/2\nCOOLNT/ON"), ["Coolant(Mist)", "Coolant(On)"]);
}

#[test]
fn the_remedy_of_a_table_rotation_is_no_deletion_where_points_are_in_the_turned_frame() {
    let help = |text: &str| read_from(text.as_bytes(), MM).diagnostics[0].help.clone().expect("a remedy");
    let indexed = help("TLAXIS/0,-1,0\nROTABL/1.570796,AAXIS,TABLE,CCLW\nGOTO/0,0,25\n");
    assert!(
        indexed.contains("output the points in the frame of the part") && indexed.contains("not TLAXIS"),
        "{indexed}"
    );
    let rotate = help("ROTATE / AAXIS,  INCR,  -90.000000,  CCLW\nGOTO/0,0,25\n");
    assert!(
        rotate.contains("output the points in the frame of the part") && rotate.contains("COORDINATE_OUTPUT"),
        "{rotate}"
    );
    assert!(!rotate.contains("delete"), "{rotate}");
}

/// What the remedies of frames and table rotations say, followed to the letter.
#[test]
fn a_remedy_that_is_followed_gives_the_path_of_the_part() {
    let options = ReadingOptions { frames: Some(Frames::Main), ..mm() };
    let path = |frame: &str| {
        let text = format!("MSYS/0,0,0,1,0,0,0,1,0\nGOTO/0,0,50\n{frame}\nGOTO/1,2,3\n");
        events_without_places(&text, options.clone())[2].clone()
    };
    // MSYS (origin, X, Y) in place of a statement with the numbers of a frame.
    assert_eq!(path("MSYS/10,20,30,1,0,0,0,0,1"), "feed 11 17 32 axis 0 -1 0 None");
    // NUM,1 in place of the number of another work offset.
    assert_eq!(path(&format!("MCSYS/{}", TILTED[1])), path("MSYS/10,20,30,1,0,0,0,0,1"));
    // Without the rotation of the table, where each GOTO has i, j, k in the frame of the part.
    let tilted = "RAPID\nGOTO/0,-25,0,0,-1,0\nGOTO/0,2.75,0,0,-1,0\n";
    assert_eq!(errors(&format!("ROTABL/90,AAXIS,TABLE\n{tilted}")).len(), 1);
    assert_eq!(events_without_places(tilted, MM), ["rapid 0 -25 0 axis 0 -1 0 None", "feed 0 2.75 0 axis 0 -1 0 None"]);
    // The cycle again after a record that ends it: its hole is drilled.
    let cycle = "CYCLE/DRILL,RAPTO,3,FEDTO,-10,MMPM,100";
    let holes = format!(
        "TOOL PATH/A,TOOL,B\nGOTO/0,0,50\n{cycle}\nGOTO/0,0,0\nCYCLE/OFF\nOPSTOP\n{cycle}\nGOTO/9,0,0\nCYCLE/OFF\n"
    );
    assert_eq!(events(&holes).iter().filter(|event| event.contains(" hole ")).count(), 2);
}
