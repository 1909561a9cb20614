//! Options of the reader: records that are refused without one, and the meaning of others.

use super::*;
use crate::cl::{Dialect, FeedLabel, Insert, OwnStatement};

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
    assert_eq!(
        found[1..],
        ["Code { letter: 77, number: 10, place: InOrder }", "Code { letter: 71, number: 64, place: InOrder }"]
    );
}

#[test]
fn the_meaning_of_a_feed_label_in_mm_in_an_inch_file_can_be_configured() {
    let text = "UNITS/INCH\nFEDRAT/10,MMPM\nGOTO/1,2,3\n";
    let label = |feed_label| ReadingOptions { feed_label, ..ReadingOptions::default() };
    assert!(events_without_places(text, label(FeedLabel::Trust))[0].ends_with("Some(PerMinute(10.0))"));
    assert!(events_without_places(text, label(FeedLabel::FileUnits))[0].ends_with("Some(PerMinute(254.0))"));
}

#[test]
fn a_statement_of_the_shop_is_its_block_in_any_case_and_with_any_blanks() {
    let own = |statement: &str, block: &str| ReadingOptions {
        own_statements: vec![OwnStatement::new(statement, block).unwrap()],
        ..mm()
    };
    for text in ["CHUCK/OPEN", "chuck / open", "CHUCK/$\nOPEN"] {
        let found = events_without_places(&format!("{text}\nGOTO/0,0,0\n"), own("Chuck/Open", " M68 "));
        assert_eq!(found[0], "insert M68", "{text}");
    }
    // Words that are refused or passed over may have one.
    for text in ["BREAK", "PAINT/PATH"] {
        let found = events_without_places(&format!("{text}\nGOTO/0,0,0\n"), own(text, "M68"));
        assert_eq!(found.len(), 2, "{text}");
    }
    // Another statement of the word may be a misspelt one.
    for text in ["CHUCK/OPN", "CHUCK", "CHUCK/OPEN,1"] {
        let read = read_from(format!("{text}\nGOTO/0,0,0\n").as_bytes(), own("CHUCK/OPEN", "M68"));
        assert!(read.diagnostics[0].text.contains("is not one of the statements in `[cl.words]`"), "{text}");
        assert_eq!(
            read.diagnostics[0].help.as_deref(),
            Some("correct the statement, of this word the table has CHUCK/OPEN; or state its block there, too")
        );
        let inert = ReadingOptions { inert: vec!["CHUCK".to_owned()], ..own("CHUCK/OPEN", "M68") };
        assert_eq!(events_without_places(&format!("{text}\nGOTO/0,0,0\n"), inert).len(), 1, "{text}");
    }
    // An arc does not go on after a block whose motion is not known.
    let cut = "GOTO/10,0,0\nCIRCLE/0,0,0,0,0,1,10\nCHUCK/OPEN\nGOTO/0,10,0\n";
    assert_eq!(errors_with(cut, own("CHUCK/OPEN", "M68")).len(), 1);
}

#[test]
fn what_is_read_and_what_moves_something_has_no_other_meaning() {
    for statement in
        ["GOTO/1,2,3", "COOLNT/DOOR", "PPRINT", "CLAMP/XAXIS", "UNCLAMP", "LOOP/START", "TURRET/1", "", "/OPEN", "A$B"]
    {
        assert!(OwnStatement::new(statement, "M68").is_err(), "{statement}");
    }
    for block in ["", "  ", "M68 (ö)", "M68\n"] {
        assert!(OwnStatement::new("CHUCK/OPEN", block).is_err(), "{block}");
    }
}

#[test]
fn a_word_can_be_declared_inert_unless_it_moves_something() {
    let inert = |word: &str| ReadingOptions { inert: vec![word.to_owned()], ..mm() };
    assert_eq!(events_without_places("AICC/ON,10\nGOTO/0,0,0\n", inert("AICC")).len(), 1);
    assert_eq!(events_without_places("BREAK\nGOTO/0,0,0\n", inert("BREAK")).len(), 1);
    // The post clamps; what it would not write may not be lost without the user's word.
    for text in ["CLAMP/CAXIS", "clamp", "UNCLAMP/BAXIS,ON"] {
        let found = errors(&format!("{text}\nGOTO/0,0,0\n"));
        assert!(found.len() == 1 && found[0].contains("`[clamp]`"), "{found:?}");
        let word = if text.starts_with('U') { "UNCLAMP" } else { "CLAMP" };
        assert_eq!(events_without_places(&format!("{text}\nGOTO/0,0,0\n"), inert(word)).len(), 1, "{text}");
    }
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
fn a_feed_can_be_given_for_motions_before_the_first_fedrat() {
    let given = ReadingOptions { default_feed_mm_per_min: Some(500.0), ..mm() };
    let text = "GOTO/1,2,3\nFEDRAT/80\nGOTO/1,2,3\nLOADTL/2\nGOTO/1,2,3\n";
    let found = events_without_places(text, given);
    let feeds: Vec<&str> =
        found.iter().filter_map(|event| event.split_once("axis 0 0 1 ")).map(|(_, feed)| feed).collect();
    assert_eq!(feeds, ["Some(PerMinute(500.0))", "Some(PerMinute(80.0))", "Some(PerMinute(80.0))"], "{found:?}");
}
