//! Records of motion along lines, at feed and at rapid.

use super::*;
use crate::cl::StatedTool;
use crate::set_up::ClPoint;

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
    assert_eq!(events_without_places(creo, centre.clone())[2], "feed 0 0 -5 axis 0 0 1 None");
    // Of a tool whose corner radius the configuration gives, called or not.
    let given = StatedTool { corner_radius_mm: Some(2.0), ..StatedTool::default() };
    let of_entry = ReadingOptions { tools: [(1, given)].into(), default_tool: Some(1), ..centre.clone() };
    for call in ["LOADTL/1\n", ""] {
        let found = events_without_places(&format!("{call}GOTO/0,0,0\n"), of_entry.clone());
        assert_eq!(found.last().map(String::as_str), Some("feed 0 0 -2 axis 0 0 1 None"));
    }
    // Described after the call, or for what moves without one; the first rapid is with that cutter, too.
    for (before, options) in
        [("LOADTL/1\n", centre.clone()), ("", ReadingOptions { default_tool: Some(1), ..centre.clone() })]
    {
        let found = events_without_places(&format!("{before}CUTTER/10,1\nRAPID\nGOTO/0,0,5\nGOTO/0,0,0\n"), options);
        assert_eq!(found[found.len() - 2..], ["rapid 0 0 4 axis 0 0 1 None", "feed 0 0 -1 axis 0 0 1 None"]);
    }
    let other = "CUTTER/10,1\nLOADTL/1\nGOTO/0,0,0\nCUTTER/10,2\nRAPID\nGOTO/0,0,5\n";
    assert!(errors_with(other, centre.clone())[0].contains("tool 1 has a corner radius of 2"));
    let mut of_one = mm();
    of_one.cl_point_of.insert(1, ClPoint::Centre);
    assert_eq!(events_without_places(text, of_one)[1], "feed 0 -3 -4 axis 0 0.6 0.8 None");
}
