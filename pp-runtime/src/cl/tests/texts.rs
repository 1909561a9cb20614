//! Texts in UTF-8 and in Latin-1.

use super::*;
use crate::cl::SetUpBegins;

#[test]
fn texts_are_utf_8_whatever_the_encoding_of_the_file() {
    let latin = b"PARTNO FR\xC4SEN\nTOOL PATH/TASCHE GRO\xDF,TOOL,A\nPPRINT \xE9t\xE9\nGOTO/0,0,0\n";
    let utf: Vec<u8> = String::from_utf8_lossy(latin).replace('\u{FFFD}', "").into_bytes();
    let found = read_from(&latin[..], MM).events;
    assert_eq!(found[..3], ["1:1 name FRÄSEN", "2:1 operation TASCHE GROß", "3:1 message été"]);
    assert_ne!(read_from(&utf[..], MM).events, found);
    let utf = "PARTNO FRÄSEN\nTOOL PATH/TASCHE GROß,TOOL,A\nPPRINT été\nGOTO/0,0,0\n";
    assert_eq!(events(utf), found);
    // Each text by itself: another line does not decide.
    let mixed = [b"PARTNO FR\xC4SEN\n", "PPRINT Ж\nGOTO/0,0,0\n".as_bytes()].concat();
    assert_eq!(read_from(&mixed[..], MM).events[..2], ["1:1 name FRÄSEN", "2:1 message Ж"]);
}

#[test]
fn a_set_up_begins_with_an_operation_named_in_latin_1() {
    let set_up = SetUpBegins { number: 2, frames: Vec::new(), operation: Some("Rückseite".into()) };
    let options = ReadingOptions { set_ups: vec![set_up], ..mm() };
    let text = b"TOOL PATH/A,TOOL,A\nGOTO/0,0,0\nTOOL PATH/R\xFCckseite,TOOL,A\nGOTO/1,0,0\n";
    let found = read_from(&text[..], options).events;
    assert!(found.iter().any(|event| event.ends_with("SetUp(2)")), "{found:?}");
}

#[test]
fn messages_show_letters_of_both_encodings() {
    for text in [&b"FR\xC4SEN/1\nGOTO/0,0,0\n"[..], "FRÄSEN/1\nGOTO/0,0,0\n".as_bytes()] {
        let found = read_from(text, MM).diagnostics;
        assert!(found[0].text.starts_with("`FR` is not a known word"), "{found:?}");
    }
    let found = read_from(&b"GOTO/0,0,\xC4\n"[..], MM).diagnostics;
    assert_eq!(found[0].text, "`Ä` is not a number");
}
