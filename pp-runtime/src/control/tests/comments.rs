//! Comments and names of operations.

use super::*;

#[test]
fn a_long_comment_is_split_into_lines_that_the_control_reads() {
    for control in CONTROLS {
        let text = written_by(*control, &layout(), |encoder| encoder.comment(&[b'('; 1000]));
        let length = control.spellings().line_length;
        assert!(text.iter().all(|line| line.len() <= length.min(254)), "{text:?}");
        let [before, _] = control.spellings().comment.marks;
        assert!(text.iter().all(|line| line.contains(before)));
    }
}

#[test]
fn a_long_comment_is_broken_between_its_words() {
    let words = ["word"; 20].join(" ");
    let text = written_by(&Fanuc, &layout(), |encoder| encoder.comment(words.as_bytes()));
    let (first, second) = (["WORD"; 14].join(" "), ["WORD"; 6].join(" "));
    assert_eq!(text, [format!("({first})"), format!("({second})")]);
}

#[test]
fn a_comment_never_continues_in_the_next_line_and_never_ends_early() {
    for control in CONTROLS {
        let mut line = Vec::new();
        control.comment(b"A) M3 % \n\" ~", &mut line);
        let [before, after] = control.spellings().comment.marks;
        let line = String::from_utf8(line).expect("ASCII");
        let inside = line.strip_prefix(before).and_then(|text| text.strip_suffix(after)).expect("the marks");
        assert!(after.is_empty() || !inside.contains([')', '(', '%']), "{line}");
        assert!(!inside.contains('\n'));
        assert!(control.spellings().name != "heidenhain" || !inside.contains('~'));
    }
    let text = steps(&Siemens, &layout(), &[Step::Operation { name: b"a\") M3" }]);
    assert_eq!(text, ["MSG(\"a') M3\")"]);
}

#[test]
fn letters_that_no_control_has_are_written_in_ascii_in_every_text() {
    let (name, text) = ("FRÄSEN Ж".as_bytes(), "Öl prüfen 45°, côté".as_bytes());
    for control in CONTROLS {
        let comment = written_by(*control, &layout(), |encoder| encoder.comment(text)).concat().to_uppercase();
        assert!(comment.contains("OEL PRUEFEN 45 DEG, COTE"), "{comment}");
        let operation = steps(*control, &layout(), &[Step::Operation { name }]).concat().to_uppercase();
        assert!(operation.contains("FRAESEN ZH"), "{operation}");
    }
}
