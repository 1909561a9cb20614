//! Arcs and curves.

use proptest::prelude::*;

use super::*;
use crate::cl::Sense;
use crate::set_up::ClPoint;

proptest! {
    /// A comment at its end keeps a line from being read in one pass, and changes nothing else.
    #[test]
    fn lines_that_are_read_in_one_pass_mean_what_other_lines_mean(
        lines in prop::collection::vec(
            prop::sample::select(vec![
                "GOTO/1,0,0", "GOTO/0,1,0", "GOTO/-1.,0,0", "GOTO/0,-1.0,0", "GOTO/0,2,0", "GOTO/0,1,0,0,0,1", "GOTO/0,1,0,1,0,0",
                "CIRCLE/0,0,0,0,0,1,1", "CIRCLE/0,0,0,0,0,1,1,.06,.5,10,1", "CIRCLE/0,0,0,0,0,1,1,.06,.5,10,1", "CIRCLE/0,0,0,1",
                "CIRCLE/0,0,0,0,0,2", "RAPID", "FEDRAT/100,MMPM", "CUTCOM/ON", "CUTCOM/LEFT", "LOADTL/1", "CUTTER/10", "CUTTER/0.5",
                "AUTOPS", "INDIRV/0,1,0", "CYCLE/DRILL,DEPTH,1,CLEAR,1,MMPM,100", "CYCLE/OFF", "TRANS/1,2,3", "FINI",
            ]),
            1..30,
        ),
    ) {
        let text = |comment: &str| {
            let line = |line: &&str| {
                let alone = line.starts_with("GOTO") || line.starts_with("CIRCLE");
                format!("{line}{}\n", if alone { comment } else { "" })
            };
            format!("GOTO/1,0,0\n{}", lines.iter().map(line).collect::<String>())
        };
        let [plain, commented] = ["", " $$ A"].map(|comment| read_from(text(comment).as_bytes(), MM));
        prop_assert_eq!(plain.events, commented.events);
        prop_assert_eq!(plain.diagnostics, commented.diagnostics);
    }
}

#[test]
fn the_centre_of_an_arc_has_no_signed_zeros() {
    for point in [ClPoint::Tip, ClPoint::Centre] {
        let options = ReadingOptions { cl_point: point, ..mm() };
        let text = "CUTTER/10,2\nLOADTL/1\nGOTO/1,0,0\nCIRCLE/-0.0,0,0,0,0,1,1\nGOTO/0,1,0\n";
        let mut reader = ClReader::new(text.as_bytes(), options);
        let centre = loop {
            match reader.next_event().unwrap() {
                Some((_, Event::Motion(ToolMotion::Arc(arc)))) => break arc.centre,
                other => assert!(other.is_some(), "no arc"),
            }
        };
        assert_eq!(centre.x.to_bits(), 0.0_f64.to_bits());
    }
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
        assert!(found[0].contains("CIRCLE needs 4, 6, 7 or 11 numbers"), "{found:?}");
    }
    let options = ReadingOptions { circle_sense: Some(Sense::Clockwise), ..mm() };
    assert!(
        events_without_places("GOTO/1,0,0\nCIRCLE/0,0,0,0,0,1\nGOTO/0,1,0\n", options)[1].ends_with("through 270.000")
    );
}

#[test]
fn a_word_after_seven_numbers_states_the_sense_of_a_circle() {
    let arc =
        |circle: &str| events_without_places(&format!("GOTO/1,0,0\nCIRCLE/{circle}\nGOTO/0,1,0\n"), MM)[1].clone();
    for (word, angle) in [("COUNTERCLOCKWISE", 90), ("CCLW", 90), ("CLOCKWISE ", 270), ("clw", 270)] {
        assert!(arc(&format!("0,0,0,0,0,1,1,{word}")).ends_with(&format!("through {angle}.000")), "{word}");
    }
    assert!(arc("0,0,0,0,0,1,1,CLW,TIMES,2").ends_with("through 630.000"));
    for circle in ["0,0,0,0,0,1,CLW", "0,0,0,1,CLW", "0,0,0,0,0,1,1,.06,.5,10,1,CLW", "0,0,0,0,0,1,1,CLW,CLW"] {
        let found = errors(&format!("GOTO/1,0,0\nCIRCLE/{circle}\nGOTO/0,1,0\n"));
        assert!(found[0].contains("CIRCLE with `CLW` is not supported"), "{circle}: {found:?}");
    }
    // About an axis that points down it may be meant from above; and its ends must be on its circle.
    let down = errors("GOTO/1,0,0\nCIRCLE/0,0,0,0,0,-1,1,CLW\nGOTO/0,1,0\n");
    assert!(down[0].contains("whether it is seen along or against the axis is not known"), "{down:?}");
    let off = errors("GOTO/1,0,0\nCIRCLE/0,0,0,0,0,1,1.01,CLW\nGOTO/0,1,0\n");
    assert!(off[0].contains("0.0100 mm off its radius"), "{off:?}");
    // No option replaces what is stated.
    let with = |sense: Sense| {
        let options = ReadingOptions { circle_sense: Some(sense), ..mm() };
        errors_with("GOTO/1,0,0\nCIRCLE/0,0,0,0,0,1,1,CLW\nGOTO/0,1,0\n", options)
    };
    assert_eq!(with(Sense::Clockwise), [""; 0]);
    assert!(with(Sense::CounterClockwise)[0].contains("states its sense by a word"));
}

#[test]
fn cusps_at_arcs_whose_sense_is_stated_are_remarked_on() {
    // Around the rest of a corner: up to the arc, which begins and ends in a cusp, as CAMWorks writes it.
    let text = |word: &str| {
        format!(
            "GOTO/.75,-.5,0\nGOTO/.75,0,0\nCIRCLE/0,0,0,0,0,1,.75{word}\nGOTO/0,-.75,0\nGOTO/.5,-.75,0\n\
             CIRCLE/.5,-.5,0,0,0,1,.25{word}\nGOTO/.75,-.5,0\n"
        )
    };
    let severities = |text: &str| -> Vec<Severity> {
        read_from(text.as_bytes(), MM).diagnostics.iter().map(|found| found.severity).collect()
    };
    assert_eq!(
        severities(&text(",CLOCKWISE").replacen("-.5,0,0,0,1,.25,CLOCKWISE", "-.5,0,0,0,1,.25,CCLW", 1)),
        [Severity::Warning]
    );
    assert_eq!(severities(&text("")), [], "the first arc is tangent the long way round");
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
        let Some((_, Event::Motion(ToolMotion::Arc(arc)))) = reader.next_event().unwrap() else { panic!("an arc") };
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
        at("0,0,-1,0,0,1,1", "0,1,0"),
        ["3:6+5 the end of an arc is 1.0000 mm off the plane of its circle (circle of line 2)"]
    );
    assert_eq!(at("0,0,0,0,0,1,1", "0,1,0,0,.6,.8"), ["3:6+13 the tool axis changes on an arc (circle of line 2)"]);
    assert_eq!(at("0,0,0,0,0,2,1", "0,1,0").len(), 1);
}

#[test]
fn the_centre_of_a_helix_of_creo_and_of_a_movarc_is_at_the_level_of_either_end() {
    // The thread of *CL Output for Circular Interpolation* in the manual of Creo, one orbit up.
    let thread = |record: &str| format!("GOTO/8.2,0,-1\n{record}\nGOTO/8.2,0,-.9\n");
    for level in ["-1", "-.9"] {
        for record in
            [format!("CIRCLE/8,0,{level},$ $$ 1ST ORBIT\n0,0,1,.2"), format!("MOVARC/8,0,{level},0,0,1,.2,ANGLE,360")]
        {
            assert_eq!(events_without_places(&thread(&record), MM)[1], "arc to 8.2 0 -0.9 about 0 0 1 through 360.000");
        }
    }
    assert!(errors(&thread("CIRCLE/8,0,-.95,0,0,1,.2"))[0].contains("0.0500 mm off the plane"));
    // NX and SolidWorks CAM: the level of the end only.
    for record in ["CIRCLE/8,0,-1,0,0,1", "CIRCLE/8,0,-1,0,0,1,.2,.06,.5,0,0"] {
        assert!(errors(&thread(record))[0].contains("0.1000 mm off the plane"), "{record}");
    }
}

#[test]
fn the_eighth_number_of_a_circle_of_camplete_is_its_angle() {
    use crate::cl::Dialect;
    let autodesk = ReadingOptions { dialect: Some(Dialect::Autodesk), ..mm() };
    let text = |angle: &str, end: &str| {
        format!("GOTO/1,0,0\nCIRCLE/0.,0.,0., 0.,0.,-1., 1., {angle}, 0.0, 0.0, 0.0\nGOTO/{end}\n")
    };
    let found = events_without_places(&text("90.", "0,1,0"), autodesk.clone());
    assert_eq!(found[1].replace("-0 ", "0 "), "arc to 0 1 0 about 0 0 1 through 90.000");
    let found = events_without_places(&text("450.", "0,1,5"), autodesk.clone());
    assert_eq!(
        found[1].replace("-0 ", "0 "),
        "arc to 0 1 5 about 0 0 1 through 450.000",
        "the centre is at the level of the start"
    );
    assert!(errors_with(&text("80.", "0,1,0"), autodesk)[0].contains("its record states 80.0000 degrees"));
    // In NX it is a tolerance.
    assert_eq!(errors(&text("80.", "0,1,0")), [""; 0]);
}

#[test]
fn a_circle_without_axis_lies_across_the_tool_and_takes_its_sense_from_the_points_between() {
    use crate::cl::Sense;
    let text = |end: &str| format!("GOTO/1,0,0\nCIRCLE/0,0,0,1\nGOTO/{end}\n");
    let about = |text: &str| events_without_places(text, MM)[1].replace("-0 ", "0 ");
    assert_eq!(about(&text(".6,.8,0 / 0,1,0")), "arc to 0 1 0 about 0 0 1 through 90.000");
    assert_eq!(about(&text("0,-1,0 / -1,0,0 / 0,1,0")), "arc to 0 1 0 about 0 0 -1 through 270.000");
    let message = "CIRCLE with 4 numbers does not state the sense of its arc (circle of line 2)";
    for end in ["0,1,0", "0,1,0 / 0,1,0"] {
        assert!(errors(&text(end))[0].ends_with(message), "{end}");
    }
    for (sense, expected) in [(Sense::Clockwise, "-1 through 270.000"), (Sense::CounterClockwise, "1 through 90.000")] {
        let given = ReadingOptions { circle_sense: Some(sense), ..mm() };
        let found = events_without_places(&text("0,1,0"), given);
        assert!(found[1].ends_with(expected), "{found:?}");
    }
    let tilted = "MULTAX/ON\nGOTO/0,0,1,1,0,0\nCIRCLE/0,0,0,1\nGOTO/0,-.6,.8 / 0,-1,0\n";
    assert_eq!(about(tilted), "arc to 0 -1 0 about 1 0 0 through 90.000");
    // Of a full circle the order of two points states it.
    assert!(errors(&text("0,1,0 / 1,0,0"))[0].ends_with(message));
    assert_eq!(about(&text("0,1,0 / -1,0,0 / 1,0,0")), "arc to 1 0 0 about 0 0 1 through 360.000");
    assert_eq!(about(&text("0,-1,0 / -1,0,0 / 1,0,0")), "arc to 1 0 0 about 0 0 -1 through 360.000");
}

#[test]
fn a_helix_that_ends_over_its_start_has_gone_round() {
    for end in ["GOTO/10,.0002,-3", "GOTO/10,-.0002,-3", "GOTO/10,0,-3"] {
        let found = events(&format!("GOTO/10,0,0\nCIRCLE/0,0,-3,0,0,1\n{end}\n"));
        assert!(found.iter().any(|event| event.contains("through 360.")), "{end}: {found:?}");
    }
}

#[test]
fn ends_in_one_direction_from_the_centre_are_those_of_a_whole_turn_or_refused() {
    // The radii differ by three micrometres: no rounding decides between nothing and a turn.
    for end in ["0.497,0", "0.497,1e-9", "0.497,-1e-9", "0.503,-1e-9"] {
        let found = events(&format!("GOTO/.5,0,0\nCIRCLE/0,0,-3,0,0,1,.5\nGOTO/{end},-3\n"));
        assert!(found.iter().any(|event| event.contains("through 360.")), "{end}: {found:?}");
        let flat = errors(&format!("GOTO/.5,0,0\nCIRCLE/0,0,0,0,0,1,.5\nGOTO/{end},0\n"));
        assert!(flat[0].contains("the arc may be empty or a full circle"), "{end}: {flat:?}");
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
