//! Statements that are refused, and the place that the message names.

use super::*;

#[test]
fn no_help_asks_for_another_output_where_an_edit_an_option_or_a_key_is_a_remedy() {
    let nx = "TOOL PATH/A,TOOL,B\nGOTO/0,0,50\n";
    for (text, remedy) in [
        ("ROTABL/90\nGOTO/0,0,0\n".to_owned(), "delete this line"),
        ("TRNTYP/WORLD,0,0,1\nGOTO/0,0,0\n".to_owned(), "write TRNTYP/WORLD,0,0,0"),
        ("UNIT/MM\nCSYS/1,0,0,0,0,1,0,0,0,0,1,0\nGOTO/0,0,0\n".to_owned(), "write TRNTYP/WORLD,0,0,0 above"),
        ("UNITS/MM\nUNITS/INCH\nGOTO/0,0,0\n".to_owned(), "delete it"),
        ("$$-> A\nTRANS/1,2,3\nGOTO/0,0,0\n".to_owned(), "`[cl] trans = \"add\"`"),
        ("UNITS/INCH\nFEDRAT/9,MMPM\nGOTO/0,0,0\n".to_owned(), "`[cl] feed_label = "),
        ("TRACUT/2,0,0,0,0,2,0,0,0,0,2,0\nGOTO/0,0,0\n".to_owned(), "delete TRACUT"),
        ("AUTOPS\nGOTO/0,0,0\n".to_owned(), "delete AUTOPS"),
        (format!("{nx}CYCLE/DRILL,FEDTO,-3,RAPTO,3,CLEAR,2\nGOTO/0,0,0\n"), "delete the one"),
        (format!("{nx}CYCLE/REAM,FEDTO,-3,RAPTO,3,ORIENT,0\nGOTO/0,0,0\n"), "BORE with ORIENT"),
        (format!("{nx}CYCLE/DRILL,FEDTO,0,RAPTO,3\nGOTO/0,0,0\n"), "write the depth in this record"),
        ("GOTO/1,0,0\nCIRCLE/0,0,0,1\nGOTO/0,1,0\n".to_owned(), "`--circle-sense ccw`"),
    ] {
        let options = if text.starts_with("UNIT") { UNSTATED } else { MM };
        let diagnostics = read_from(text.as_bytes(), options).diagnostics;
        let help = diagnostics[0].help.as_deref().unwrap_or_default();
        assert!(help.contains(remedy) && !help.contains("have the CAM system"), "{text}: {help}");
    }
}

#[test]
fn words_of_a_vocabulary_have_no_effect_unless_one_that_is_read_gets_another_meaning() {
    assert_eq!(errors("PPWORD/TLANGL,1\nPPWORD / CSINKD, 12, HOLDER, 3\nGOTO/0,0,0\n"), [""; 0]);
    // A word of the table with its own number, and one that begins with a digit.
    assert_eq!(
        errors("PPWORD/TLAXIS,3171\nPPWORD/3DCOMP,3155\nPPWORD/CALSUB,3150\nPPWORD/RAPID,5\nGOTO/0,0,0\n"),
        [""; 0]
    );
    // The number of FEDRAT; a word for a word; no number; not its own number.
    for words in ["rapid,1009", "rapid,GOTO", "rapid", "TLANGL,1,rapid", "rapid,77"] {
        let at = 8 + words.find("rapid").unwrap_or_default();
        let expected = format!("1:{at}+5 PPWORD is refused: it may change the meaning of `rapid`");
        refused(&format!("PPWORD/{words}\nGOTO/0,0,0\n"), &expected);
    }
    assert_eq!(errors("PPWORD/\nGOTO/0,0,0\n").len(), 1);
}

#[test]
fn goto_with_a_wrong_count_says_how_many_it_found() {
    refused("GOTO/1,2,3,4,5\n", "1:6+9 GOTO needs 3 or 6 numbers, found 5");
    refused("GOTO/1,2,3,0,0,1,0,0,1\n", "1:6+17 GOTO needs 3 or 6 numbers, found 9");
    refused("GOTO/\n", "1:1+5 GOTO needs 3 or 6 numbers, found 0");
    refused("FROM/1,2\n", "1:6+3 FROM needs 3 or 6 numbers, found 2");
}

#[test]
fn what_is_no_number_is_shown() {
    for (text, shown) in [("NaN", "NaN"), ("inf", "inf"), ("1e", "1e"), ("1 2", "1 2"), ("0x1F", "0x1F")] {
        let expected = format!("1:10+{} `{shown}` is not a number", text.len());
        refused(&format!("GOTO/1,2,{text}\n"), &expected);
    }
    refused("GOTO/1,2,1E999\n", "1:10+5 `1E999` is beyond the range of numbers");
    refused("GOTO/1,2,1E7\n", "1:6+7 a coordinate is more than a kilometre from the origin");
}

#[test]
fn a_word_without_its_number_is_named() {
    for (text, expected) in [
        ("CYCLE/DRILL,DEPTH,MMPM,200,CLEAR,2", "1:13+5 `DEPTH` has no number after it, `MMPM` follows"),
        ("CYCLE/DRILL,FEDTO,-3,RAPTO", "1:22+5 `RAPTO` has no number after it"),
        ("CYCLE/DRILL,FEDTO,-3,RAPTO,1,RTRCTO,MMPM", "1:30+6 `RTRCTO` has no number after it, `MMPM` follows"),
        ("CYCLE/DRILL,FEDTO,-3,RAPTO,1,IPM", "1:30+3 `IPM` has no number after it"),
        ("CYCLE/DRILL,FEDTO,-3,RAPTO,1,DWELL,REV,MMPM,9", "1:30+5 `DWELL` has no number after it, `MMPM` follows"),
        ("LOADTL/1,LENGTH,OSETNO,2", "1:10+6 `LENGTH` has no number after it, `OSETNO` follows"),
        ("LOADTL/1,ADJUST", "1:10+6 `ADJUST` has no number after it"),
        ("FEDRAT/IPM,CLW", "1:8+3 `IPM` has no number after it, `CLW` follows"),
        ("CIRCLE/0,0,0,0,0,1,1,TIMES", "1:22+5 `TIMES` has no number after it"),
    ] {
        let found = errors(&format!("{text}\nGOTO/0,0,0\n"));
        assert_eq!(found[0], expected, "{text}");
    }
    // A number that is none is still shown.
    assert!(errors("CYCLE/DRILL,FEDTO,-3x,RAPTO,1\n")[0].contains("`-3x` is not a number"));
}

#[test]
fn no_point_that_a_record_leads_to_is_a_kilometre_away() {
    let far = "a coordinate is more than a kilometre from the origin";
    for (text, at) in [
        ("GODLTA/1E308,0,0", "2:8+9"),
        ("GODLTA/1E7", "2:8+3"),
        ("CIRCLE/1E308,0,0,0,0,1\nGOTO/0,0,0", "2:8+15"),
        ("CIRCLE/1E150,0,0,0,0,1\nGOTO/0,0,0", "2:8+15"),
        ("CLEARP/XYPLAN,1E308", "2:8+12"),
        ("TRACUT/1,0,0,1E308,0,1,0,0,0,0,1,0\nGOTO/1,2,3", "3:6+5"),
        ("ORIGIN/1E307,0,0\nGOTO/1,2,3", "3:6+5"),
        ("INDIRV/0,1,0\nTLON,GOFWD/(CIRCLE/1E308,0,0,1),ON,(LINE/0,0,0,1,0,0)", "3:12+42"),
        ("$$-> A\nCYCLE/DRILL,DEPTH,1E308,CLEAR,1\nGOTO/0,0,0", "4:6+5"),
        ("$$-> A\nCYCLE/DRILL,DEPTH,1,CLEAR,1,RETURN,1E9\nGOTO/0,0,0", "4:6+5"),
    ] {
        let found = errors(&format!("GOTO/0,0,0\n{text}\n"));
        assert_eq!(found[0], format!("{at} {far}"), "{text}");
    }
    refused("SPINDL/1E308,CLW\nGOTO/0,0,0\n", "1:8+5 a spindle speed of `1E308` rev/min is not plausible");
    refused("FEDRAT/1E308\nGOTO/0,0,0\n", "1:8+5 the feed 1e308 is not plausible");
}

#[test]
fn a_missing_comma_is_no_longer_a_number() {
    refused("SPINDL/900CCLW\nGOTO/1,2,3\n", "1:8+7 `900CCLW` is not a number");
}

#[test]
fn an_empty_place_is_refused_where_it_is() {
    refused("GOTO/1,,3\n", "1:8+1 an argument is missing at this comma");
    refused("GOTO/1,2,\n", "1:9+1 an argument is missing at this comma");
    refused("GOTO/,2,3\n", "1:6+1 an argument is missing at this comma");
    refused("CUTTER/,1\nGOTO/0,0,0\n", "1:8+1 an argument is missing at this comma");
    refused("CUTTER/20,,3\nGOTO/0,0,0\n", "1:11+1 an argument is missing at this comma");
    refused("TLDATA/MILL,20,,3\nGOTO/0,0,0\n", "1:16+1 an argument is missing at this comma");
    refused("SPINDL/RPM,,CLW\nGOTO/0,0,0\n", "1:12+1 an argument is missing at this comma");
}

#[test]
fn an_empty_place_without_effect_passes() {
    for text in ["TOOLNO/1, 20.0, 3.0,, 120.0", "TOOLNO/,", "TPRINT/T7 Ball,,T7", "MACHIN/", "MACHIN", "MACHIN/A,,1,"] {
        assert!(events(&format!("{text}\nGOTO/0,0,0\n")).len() <= 2, "{text}");
    }
    for text in ["CUTTER/20,2,,,,,50", "CUTTER/20,2,", "TLDATA/MILL,20,2,,0", "TLDATA/DRILL,,"] {
        assert_eq!(errors(&format!("{text}\nGOTO/0,0,0\n")).is_empty(), text != "TLDATA/DRILL,,", "{text}");
    }
    refused("TOOLNO/1,,TURN\nGOTO/0,0,0\n", "1:11+4 this record belongs to turning: only milling is supported");
    refused("CUTTER/1,2,3,4,5,6,7,\nGOTO/0,0,0\n", "1:8+14 CUTTER needs 1 to 7 numbers, found 8");
    refused("CUTTER/1,2,X\nGOTO/0,0,0\n", "1:12+1 `X` is not a number");
}

#[test]
fn a_word_of_notes_can_be_declared_inert_but_not_in_a_turning_file() {
    let inert = |word: &str| ReadingOptions { inert: vec![word.to_owned()], ..mm() };
    for text in ["TOOLNO", "TLDATA/SPECIAL,1,,X", "CUTTER/,,", "MACHIN/", "PARTNO A", "PPRINT A", "CUTTER"] {
        let word = text.split(['/', ' ']).next().unwrap();
        assert_eq!(
            events_without_places(&format!("{text}\nGOTO/1,2,3\n"), inert(word)),
            ["feed 1 2 3 axis 0 0 1 None"]
        );
    }
    for text in ["TOOLNO/1,TURN", "TLDATA/TURN,1"] {
        let found = errors_with(&format!("{text}\nGOTO/0,0,0\n"), inert(&text[..6]));
        assert!(found[0].contains("belongs to turning"), "{found:?}");
    }
}

#[test]
fn a_bare_slash_is_an_error_only_where_something_is_needed() {
    assert_eq!(events("RAPID/\nMULTAX/\nGOTO/1,2,3\n").len(), 1);
    refused("COOLNT/\nGOTO/0,0,0\n", "1:1+7 an argument of COOLNT is missing");
}

#[test]
fn forms_that_are_not_read_are_refused_not_skipped() {
    refused("GOTO/0,0,0\nCUTCOM/OFF,LENGTH,1\n", "2:12+6 CUTCOM with `LENGTH` is not supported");
    refused("GOTO/0,0,0\nRAPID/X\n", "2:7+1 RAPID with `X` is not supported");
    refused("GOTO/0,0,0\nSPINDL/STOP\n", "2:8+4 SPINDL with `STOP` is not supported");
    refused("GOTO/0,0,0\nSET/MODE,INCR\n", "2:10+4 SET with `INCR` is not supported");
    refused("GOTO/0,0,0\nMODE/INCR\n", "2:6+4 MODE with `INCR` is not supported");
    refused("GOTO/0,0,0\nCOOLNT/AIR,HIGH\n", "2:12+4 COOLNT with `HIGH` is not supported");
    refused(
        "GOTO/0,0,0\nTRNTYP/WORLD,0,0,1\n",
        "2:8+11 TRNTYP with numbers other than 0 is refused: its effect on the coordinates is not known",
    );
    refused("GOTO/0,0,0\nFEDRAT/INVERS,5\n", "2:15+1 FEDRAT with `5` is not supported");
    refused("GOTO/0,0,0\nCOOLNT/THRU,MUCH\n", "2:13+4 COOLNT with `MUCH` is not supported");
    refused("GOTO/0,0,0\nOPSKIP/1\n", "2:8+1 OPSKIP with `1` is not supported");
}

#[test]
fn dangerous_words_are_refused_with_their_reason() {
    let found = errors("GOTO/0,0,0\nINSERT/G0 Z-5\nCOPY/1\nSYN/'A','$$*B'\n");
    assert_eq!(
        found,
        [
            "2:8+6 INSERT is refused: the effect of its NC text on the machine is unknown",
            "3:1+4 COPY is refused: it changes the coordinates of all points after it",
            "4:1+3 SYN is refused: it changes the meaning of other records",
        ]
    );
}

#[test]
fn an_unknown_word_names_the_nearest_known_one() {
    let diagnostics = read_from(&b"GOTO/0,0,0\nGOTTO/1,2,3\nsfsdfsdf\n"[..], MM).diagnostics;
    assert_eq!(diagnostics[0].text, "`GOTTO` is not a known word of CL data");
    assert_eq!(
        diagnostics[0].help.as_deref(),
        Some("did you mean GOTO? A statement of the shop gets its block in `[cl.words]`")
    );
    assert_eq!(diagnostics[1].text, "`sfsdfsdf` is not a known word of CL data");
    assert!(!diagnostics[1].help.as_deref().unwrap().contains("mean"));
    assert_eq!(diagnostics.len(), 2);
}

#[test]
fn a_slash_must_follow_the_word() {
    refused("GOTO 1,2,3\n", "1:6+5 expected a slash after GOTO, found `1,2,3`");
    refused("GOTO/1,2,3/4,5\n", "1:12+3 GOTO needs 3 numbers between slashes, found 2");
    refused("FROM/1,2,3/4,5,6\n", "1:10+3 this argument contains a second slash");
}

#[test]
fn tool_axes_are_checked_by_their_length() {
    refused("GOTO/1,2,3,0,0,0\n", "1:6+11 the tool axis is 0, 0, 0 and has no direction");
    refused("GOTO/1,2,3,0,0,1.002\n", "1:6+15 the tool axis has length 1.002000, not 1");
    refused("TLAXIS/0,0,0\nGOTO/0,0,0\n", "1:8+5 the tool axis is 0, 0, 0 and has no direction");
    assert_eq!(events("GOTO/1,2,3,0,0,1.00000999\n"), ["1:1 feed 1 2 3 axis 0 0 1 None"]);
    assert_eq!(errors("GOTO/1,2,3,0,0,1.00101\n").len(), 1);
}

#[test]
fn normalised_axes_are_counted_in_one_warning() {
    let text = "GOTO/1,2,3,0,0,1\nGOTO/1,2,3,0,0,1.00099\nGOTO/1,2,3,0,0,1.000011\n";
    let outcome = read_from(text.as_bytes(), MM);
    assert_eq!(outcome.events.len(), 3);
    assert!(outcome.events[1].contains("axis 0 0 1"));
    let [warning] = &outcome.diagnostics[..] else { panic!("{:?}", outcome.diagnostics) };
    assert_eq!(warning.severity, Severity::Warning);
    assert_eq!(warning.location, Location { line: 2, column: 1 });
    assert!(warning.text.starts_with("2 tool axes"), "{}", warning.text);
}

#[test]
fn turning_files_are_refused_as_such() {
    for text in ["SWITCH/3", "TURRET/1", "TOOLNO/1,TURN,1", "SPINDL/500,SFM,CLW", "TLDATA/TURN,1", "SPINDL/MAXRPM,9"] {
        let found = errors(&format!("{text}\nGOTO/0,0,0\n"));
        assert_eq!(found.len(), 1, "{text}");
        assert!(found[0].ends_with("this record belongs to turning: only milling is supported"), "{found:?}");
    }
}

#[test]
fn tool_records_state_what_their_numbers_mean() {
    let unknown = "without a word after tool 5, whose meaning is unknown";
    refused("LOADTL/5,6\nGOTO/0,0,0\n", &format!("1:10+1 LOADTL has 1 number {unknown}"));
    refused("LOADTL/5,5,6\nGOTO/0,0,0\n", &format!("1:10+3 LOADTL has 2 numbers {unknown}"));
    refused("LOADTL/5,1,2,3,4,5\nGOTO/0,0,0\n", "1:18+1 LOADTL with `5` is not supported");
    refused("LOADTL/5,ADJUST,9,TURN\n", "1:19+4 this record belongs to turning: only milling is supported");
    refused("LOADTL/1.5\nGOTO/0,0,0\n", "1:8+3 `1.5` must be a whole number, 0 or more");
    refused("LOADTL/-1\nGOTO/0,0,0\n", "1:8+2 `-1` must be a whole number, 0 or more");
    refused("LOADTL/1,LENGTH,0\nGOTO/0,0,0\n", "1:17+1 the gauge length (LENGTH) must be above 0, found `0`");
    refused("LOADTL/1,ADJUST,0\nGOTO/0,0,0\n", "1:17+1 `ADJUST` 0 would cancel the length offset");
    refused("LOADTL/1,ADJUST,2,OSETNO,3\nGOTO/0,0,0\n", "1:26+1 two different length offset registers for one tool");
    refused("LOAD/HOLDER,1\nGOTO/0,0,0\n", "1:6+6 LOAD with `HOLDER` is not supported");
    refused("LOAD/TOOL\nGOTO/0,0,0\n", "1:6+4 an argument of LOAD is missing");
}

#[test]
fn implausible_feeds_are_refused() {
    refused("FEDRAT/0.0394,MMPM\nGOTO/0,0,0\n", "1:8+6 a feed of 0.0394 mm/min is not plausible");
    refused("FEDRAT/0,MMPM\nGOTO/0,0,0\n", "1:8+1 the feed must be above 0, found 0");
    refused("FEDRAT/MMPM\nGOTO/0,0,0\n", "1:8+4 `MMPM` has no number after it");
    refused("FEDRAT/100,SMM\nGOTO/0,0,0\n", "1:12+3 FEDRAT with `SMM` is not supported");
    assert_eq!(events("FEDRAT/0.05,MMPR\nGOTO/0,0,0\n").len(), 1);
}

#[test]
fn a_spindle_has_one_speed_and_one_sense() {
    refused("SPINDL/500,600\nGOTO/0,0,0\n", "1:12+3 `600` contradicts an earlier word of this SPINDL");
    refused("SPINDL/CLW,CCLW\nGOTO/0,0,0\n", "1:12+4 `CCLW` contradicts an earlier word of this SPINDL");
    refused("SPINDL/OFF,500\nGOTO/0,0,0\n", "1:12+3 `500` contradicts an earlier word of this SPINDL");
    refused("SPINDL/0,CLW\nGOTO/0,0,0\n", "1:8+1 the spindle speed must be above 0, found `0`");
    refused("SPINDL/RPM,CLW\nGOTO/0,0,0\n", "1:8+7 SPINDL with RPM has no speed");
}

#[test]
fn all_faults_of_a_file_are_reported_and_no_event_follows_the_first() {
    let outcome = read_from(&b"GOTO/1,2,3\nGOTO/1\nGOTO/4,5,6\nBREAK/1\nGOTO/7,8,9\nX\n"[..], MM);
    assert_eq!(outcome.events.len(), 1);
    let lines: Vec<_> = outcome.diagnostics.iter().map(|diagnostic| diagnostic.location.line).collect();
    assert_eq!(lines, [2, 4, 6]);
}

#[test]
fn after_twenty_of_a_kind_the_rest_is_counted() {
    let text = format!("{}GOTO/1\n", "BREAK/1\n".repeat(25));
    let found = errors(&text);
    assert_eq!(found.len(), 22);
    assert_eq!(found[19], "20:1+5 BREAK is refused: its meaning depends on the postprocessor that it was written for");
    assert_eq!(found[20], "26:6+1 GOTO needs 3 or 6 numbers, found 1");
    assert_eq!(found[21], "21:1+1 5 more of this kind from here on: BREAK");
    assert_eq!(errors(&format!("{}GOTO/1,2,3\n", "BREAK/1\n".repeat(20))).len(), 20);
}

#[test]
fn units_are_needed_at_the_first_number_and_missed_once() {
    let found = errors_with("TOOL PATH/A,TOOL,B\nGOTO/1,2,3\nGOTO/4,5,6\n", UNSTATED);
    assert_eq!(found.len(), 1);
    assert!(found[0].starts_with("2:6+5 the unit of the file is unknown"), "{found:?}");
    let help = read_from(&b"GOTO/1,2,3\n"[..], UNSTATED).diagnostics[0].help.clone().unwrap();
    assert!(help.contains("--units mm") && help.contains("--units in"), "{help}");
}

#[test]
fn units_that_contradict_are_refused() {
    refused("UNITS/INCH\nGOTO/1,2,3\n", "1:1+10 the unit of the file contradicts `--units` or `cl_units`");
    refused_with(
        "UNITS/MM\nGOTO/1,2,3\nUNITS/INCHES\nGOTO/1,2,3\n",
        UNSTATED,
        "3:1+12 this unit differs from that of line 1",
    );
    refused_with("UNITS/CM\nGOTO/1,2,3\n", MM, "1:7+2 `CM` is not a known unit");
    assert_eq!(events("UNITS/MM\nGOTO/1,2,3\nUNIT/MM\n").len(), 1);
}

#[test]
fn a_feed_in_millimetres_in_an_inch_file_is_refused() {
    let text = "UNITS/INCH\nFEDRAT/10,MMPM\nGOTO/1,2,3\n";
    refused_with(text, UNSTATED, "2:11+4 feed labelled in mm in a file in inch: such labels are often wrong");
}

#[test]
fn only_tiny_cutters_in_claimed_millimetres_are_inches() {
    let text = "CUTTER/.25\nLOADTL/1\nGOTO/1,2,3\nCUTTER/.3937\nLOADTL/2\nGOTO/1,2,3\n";
    refused(text, "1:1+1 the largest cutter has a diameter of 0.3937 mm: is this file in inch?");
    events_with(&format!("UNITS/MM\n{text}"), UNSTATED);
    events(&text.replace(".3937", "1.5"));
    // `--units mm` is an answer.
    let confirmed = read_from(text.as_bytes(), ReadingOptions { units_confirmed: true, ..mm() });
    let [warning] = &confirmed.diagnostics[..] else { panic!("{:?}", confirmed.diagnostics) };
    assert!(confirmed.events.len() == 4 && warning.severity == Severity::Warning, "{confirmed:?}");
    events_with(text, Some(Units::Inches));
}

#[test]
fn a_second_frame_is_refused_with_both_lines() {
    let frame = "MSYS/1,2,3,1,0,0,0,1,0\n";
    events(&format!("{frame}GOTO/0,0,0\nMSYS/1.00009,2,3,1,0,0,0,1,0\nGOTO/0,0,0\n"));
    let expected = "the frame in line 3 differs from the workpiece frame in line 1, and nothing states in which of them its points \
                    are: its Z is that of the first frame";
    refused(&format!("{frame}GOTO/0,0,0\nMSYS/1.0002,2,3,1,0,0,0,1,0\n"), &format!("3:6+22 {expected}"));
    let turned = format!("{frame}GOTO/0,0,0\nMSYS/1,2,3,0,1,0,-1,0,0\n");
    refused(&turned, &format!("3:6+18 {expected}"));
    let skew = "MSYS/0,0,0,1,0,0,1,0,0\nGOTO/0,0,0\n";
    refused(skew, "1:6+17 the axes of this frame are not perpendicular, right-handed unit vectors");
}

#[test]
fn tool_0_leaves_the_spindle_empty() {
    let text = "the spindle is left without a tool (tool 0 or UNLOAD), and the tool moves after it";
    for record in ["LOADTL/0", "LOAD/TOOL,0,ADJUST,1", "UNLOAD/TOOL", "UNLOAD/TOOL,3", "UNLOAD"] {
        for motion in ["GOTO/0,0,0", "RAPID\nGOTO/0,0,0", "GODLTA/1,0,0"] {
            let found = errors(&format!("LOADTL/1\nGOTO/0,0,9\n{record}\n{motion}\nGOTO/0,0,5\n"));
            assert!(found.len() == 1 && found[0].starts_with("3:1") && found[0].contains(text), "{record}: {found:?}");
        }
        let arc = "INDIRV/1,0,0\nTLON,GOFWD/ (CIRCLE/5,0,5),ON,(LINE/5,0,9,5,9,9)";
        assert!(!errors(&format!("LOADTL/1\nGOTO/0,0,9\n{record}\n{arc}\n")).is_empty(), "{record}");
        // At the end, and before another tool.
        for after in ["", "GOHOME\n", "LOADTL/2\nGOTO/0,0,8\n", "STOP\nLOADTL/2\nGOTO/0,0,8\n"] {
            assert!(events(&format!("LOADTL/1\nGOTO/0,0,9\n{record}\n{after}")).len() > 2, "{record} {after}");
        }
    }
    refused("UNLOAD/PALLET\n", "1:8+6 UNLOAD with `PALLET` is not supported");
}

#[test]
fn a_record_that_a_dollar_makes_part_of_a_text_is_refused() {
    let text = "would be lost: the `$` at the end of the line before joins it to";
    refused("PPRINT PRICE IN US$\n GOTO / 0,0,50\nGOTO/9,9,50\n", &format!("2:2+4 GOTO {text} PPRINT"));
    refused("PARTNO A$ \nRAPID\nGOTO/9,9,50\n", &format!("2:1+5 RAPID {text} PARTNO"));
    refused("MACHIN/A,1,$\nB$\nSPINDL/OFF\nGOTO/9,9,50\n", &format!("3:1+6 SPINDL {text} MACHIN"));
    refused("GOTO/9,9,50\n$$-> FEATNO / 12 $\nGOTO/0,0,50\n", &format!("3:1+4 GOTO {text} $$->"));
    assert_eq!(events("PPRINT first $\n STOP at once\nGOTO/0,0,0\n").len(), 2);
}

#[test]
fn a_feed_per_minute_with_the_label_of_one_per_revolution_is_refused() {
    let text = "mm per revolution is not plausible";
    refused("FEDRAT/250,PERREV\nGOTO/0,0,0\n", &format!("1:8+3 a feed of 250 {text}"));
    refused("FEDRAT/IPR,10\nGOTO/0,0,0\n", &format!("1:12+2 a feed of 254 {text}"));
    assert_eq!(events("FEDRAT/20,PERREV\nGOTO/0,0,0\n").len(), 1);
}
