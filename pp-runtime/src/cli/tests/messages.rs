//! Tests of messages on standard error: with source lines as text, and as JSON.

use proptest::prelude::*;

use super::*;

#[test]
fn json_messages_are_one_object_per_line() {
    let shop = Shop::new();
    let outcome = shop.post(&["--message-format", "json"], &fails_in_line_2);
    let lines: Vec<serde_json::Value> =
        outcome.errors.lines().map(|line| serde_json::from_str(line).expect("an object")).collect();
    assert_eq!(lines.len(), 2);
    assert_eq!(lines[0]["file"], shop.arg("part.cls"));
    assert_eq!((&lines[0]["line"], &lines[0]["column"], &lines[0]["length"]), (&2.into(), &6.into(), &3.into()));
    assert_eq!((&lines[0]["severity"], &lines[0]["code"]), (&"error".into(), &"cl/syntax".into()));
    assert_eq!(lines[0]["text"], "GOTO needs 3 or 6 numbers (found 1)");
    assert_eq!(lines[0]["help"], "write X, Y and Z");
    assert_eq!(lines[1]["severity"], "note");
    assert!(lines[1]["line"].is_null() && lines[1].get("code").is_none());
}

/// The messages for findings about `text`.
fn messages(text: &[u8], found: &[Diagnostic]) -> String {
    let mut out = Vec::new();
    MessageWriter::new(&mut out, MessageFormat::Human).diagnostics("p.cls", &mut &*text, found);
    String::from_utf8(out).expect("messages are text")
}

#[test]
fn diagnostics_are_shown_in_the_order_of_the_text_and_counted() {
    let found = [
        finding(Severity::Warning, 3, 1, 1, "later", None),
        finding(Severity::Error, 1, 1, 1, "first", None),
        finding(Severity::Warning, 2, 1, 1, "second", None),
    ];
    assert_eq!(
        messages(b"A\nB\nC", &found),
        "p.cls:1:1: error: first\n  |\n1 | A\n  | ^\np.cls:2:1: warning: second\n  |\n2 | B\n  | ^\n\
         p.cls:3:1: warning: later\n  |\n3 | C\n  | ^\np.cls: 1 error, 2 warnings\n"
    );
}

#[test]
fn twenty_of_a_kind_are_shown_and_the_rest_is_counted() {
    let text = "GOTO/1\n".repeat(200);
    let numbered = |line: u64| format!("GOTO/{line}.5 is {line} numbers short of `X{line}`");
    let mut found: Vec<Diagnostic> =
        (1..=123).map(|line| finding(Severity::Warning, line, 1, 4, &numbered(line), None)).collect();
    found.push(finding(Severity::Error, 150, 1, 1, "another kind", None));
    let shown = messages(text.as_bytes(), &found);
    assert_eq!(shown.matches(": warning: ").count(), 20);
    assert!(shown.contains("p.cls: 103 more like `warning: GOTO/# is # numbers short of …`, the last in line 123\n"));
    assert!(shown.contains("p.cls:150:1: error: another kind\n"));
    assert!(shown.ends_with("p.cls: 1 error, 123 warnings\n"));
}

#[test]
fn what_is_only_counted_counts_in_the_summary() {
    let rest = Diagnostic { count: 980, ..finding(Severity::Error, 1, 1, 1, "980 more of this kind", None) };
    let shown = messages(b"GOTO/1\n", &[finding(Severity::Error, 1, 6, 1, "short", None), rest]);
    assert!(shown.ends_with("p.cls: 981 errors\n"), "{shown}");
}

#[test]
fn a_fault_of_a_whole_statement_marks_its_word() {
    let found = [finding(Severity::Error, 1, 3, 1, "odd", None), finding(Severity::Error, 2, 8, 1, "odd", None)];
    let shown = messages(b"  END-OF-PATH\nSPINDL/0,CLW\n", &found);
    let carets: Vec<&str> = shown.lines().filter(|line| line.contains('^')).collect();
    assert_eq!(carets, ["  |   ^^^^^^^^^^^", "  |        ^"]);
}

#[test]
fn control_characters_and_bytes_that_are_not_text_are_made_visible() {
    let found = [finding(Severity::Error, 1, 7, 2, "odd", None)];
    let shown = messages(b"\tA\x1b[\xff\xc3\xa4B\r\n", &found);
    assert_eq!(shown.lines().nth(2), Some("1 | ␉A␛[\u{fffd}äB"));
    // Two bytes before the column are one character: the caret is below the character at or after the column.
    assert_eq!(shown.lines().nth(3), Some("  |       ^"));
}

#[test]
fn control_characters_in_a_message_reach_no_terminal() {
    let found = [finding(Severity::Error, 1, 1, 1, "odd \x1b[2J", None)];
    assert!(!messages(b"A", &found).contains('\x1b'));
}

#[test]
fn a_long_line_is_clipped_around_the_column() {
    let line: String = (0..5000).map(|index| char::from(b'a' + (index % 26) as u8)).collect();
    let text = format!("short\n{line}\n");
    for (column, starts, ends) in [(1, false, true), (2500, true, true), (5000, true, false)] {
        let shown = messages(text.as_bytes(), &[finding(Severity::Error, 2, column, 3, "here", None)]);
        let lines: Vec<&str> = shown.lines().collect();
        assert!(lines[2].chars().count() <= 4 + 100 + 2, "{}", lines[2]);
        assert_eq!((lines[2].starts_with("2 | …"), lines[2].ends_with('…')), (starts, ends), "{}", lines[2]);
        let caret = lines[3].find('^').expect("a caret");
        let wanted = char::from(b'a' + ((column - 1) % 26) as u8);
        assert_eq!(lines[2].chars().nth(caret), Some(wanted), "{column}");
    }
}

#[test]
fn lines_end_in_lf_crlf_or_a_lone_cr_also_across_reads() {
    /// Gives one byte at a time.
    struct Drip<'a>(&'a [u8]);
    impl Read for Drip<'_> {
        fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
            let count = usize::from(!self.0.is_empty() && !buffer.is_empty());
            buffer[..count].copy_from_slice(&self.0[..count]);
            self.0 = &self.0[count..];
            Ok(count)
        }
    }
    let text = b"one\r\ntwo\rthree\n\nfive";
    let places = || (1..=6).map(|line| (Location { line, column: 1 }, 1));
    let whole = excerpt::excerpts(&mut &text[..], places()).expect("memory is readable");
    let dripped = excerpt::excerpts(&mut Drip(text), places()).expect("memory is readable");
    assert_eq!(whole, dripped);
    let texts: Vec<&str> = whole.values().map(|excerpt| excerpt.text.as_str()).collect();
    assert_eq!(texts, ["one", "two", "three", "", "five"]);
}

#[test]
fn a_place_after_the_end_of_the_text_is_shown_without_a_line() {
    assert_eq!(
        messages(b"A\n", &[finding(Severity::Error, 2, 1, 1, "the file ends early", None)]),
        "p.cls:2:1: error: the file ends early\np.cls: 1 error\n"
    );
}

proptest! {
    /// The caret is below the text and the excerpt is short, for any bytes and any place.
    #[test]
    fn any_place_in_any_text_can_be_shown(
        bytes in proptest::collection::vec(prop_oneof![any::<u8>(), Just(b'\n'), Just(b'\r'), Just(0xC3), Just(b'A')], 0..600),
        line in 0_u64..40,
        column in 0_u32..700,
        length in 0_u32..50,
    ) {
        let place = (Location { line, column }, length);
        let found = excerpt::excerpts(&mut &bytes[..], std::iter::once(place)).expect("memory is readable");
        for excerpt in found.values() {
            let count = excerpt.text.chars().count();
            prop_assert!(count <= 102, "{count}");
            prop_assert!(excerpt.indent <= count && excerpt.marked >= 1);
            prop_assert!(!excerpt.text.chars().any(char::is_control));
        }
    }
}
