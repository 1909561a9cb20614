//! Cycles of several lines, and lines that go on in the next one.

use super::*;

/// Faults of numbered lines after a program in which nothing is wrong.
fn of(lines: &[&str]) -> Vec<String> {
    let numbered = lines.iter().enumerate().map(|(index, line)| format!("{} {line}\n", index + 2));
    faults(Family::Heidenhain, &format!("{TNC}{}", numbered.collect::<String>()))
}

const SMOOTH: [&str; 3] = ["CYCL DEF 32.0 TOLERANCE", "CYCL DEF 32.1 T0.02", "CYCL DEF 32.2 HSC-MODE:1 TA0.5"];
const WAIT: [&str; 2] = ["CYCL DEF 9.0 DWELL TIME", "CYCL DEF 9.1 DWELL 0.5"];

#[test]
fn the_lines_of_a_cycle_follow_each_other_in_order_and_completely() {
    for complete in [
        &SMOOTH[..],
        &WAIT,
        &["CYCL DEF 32.0 TOLERANCE", "CYCL DEF 32.1"],
        &["CYCL DEF 32.0 TOLERANCE", "CYCL DEF 32.1 ;OFF"],
    ] {
        assert_eq!(of(&[complete, &["M8"]].concat()), [""; 0], "{complete:?}");
        // One line is missing.
        for missing in 0..complete.len() {
            let mut lines = complete.to_vec();
            lines.remove(missing);
            assert!(!of(&[&lines[..], &["M8"]].concat()).is_empty(), "{complete:?} without {missing}");
        }
        // Another line is between them, or two have changed places.
        for at in 1..complete.len() {
            for other in ["M8", "; A", "* - A", "L X+5 R0 FMAX", "CYCL DEF 9.0 DWELL TIME", "STOP", complete[at - 1]] {
                let mut lines = complete.to_vec();
                lines.insert(at, other);
                assert!(!of(&[&lines[..], &["M8"]].concat()).is_empty(), "{lines:?}");
            }
            let mut lines = complete.to_vec();
            lines.swap(at - 1, at);
            assert!(!of(&[&lines[..], &["M8"]].concat()).is_empty(), "{lines:?}");
        }
    }
    assert!(!of(&["CYCL DEF 32.0 TOLERANCE", "CYCL DEF 32.1", SMOOTH[2]]).is_empty());
}

#[test]
fn nothing_follows_the_values_of_a_cycle_line() {
    for (lines, at) in [(&SMOOTH[..], 0), (&SMOOTH, 1), (&SMOOTH, 2), (&WAIT, 0), (&WAIT, 1)] {
        for more in [" BLK FORM 0.1 Z X+0 Y+0 Z+0", " M8", " CYCL DEF 32.1 T5", " 5", " T1", " TA1"] {
            let joined = format!("{}{more}", lines[at]);
            let mut lines = lines.to_vec();
            lines[at] = &joined;
            assert!(!of(&lines).is_empty(), "{joined}");
        }
    }
    assert!(!of(&["CYCL DEF 32.0 TOLERANCE", "CYCL DEF 32.1 BLK FORM 0.1 Z X+0 Y+0 Z+0"]).is_empty());
    assert!(!of(&["CYCL DEF 9 DWELL TIME", WAIT[1]]).is_empty());
    assert!(!of(&["CYCL DEF 9.0 DWELL TIME", "CYCL DEF 9.1 DWELL -1"]).is_empty());
}

#[test]
fn a_line_of_the_shop_does_not_come_between_the_lines_of_a_cycle() {
    let mut vocabulary = vocabulary(Family::Heidenhain);
    let place = OwnPlace::Clamp { axis: 0, on: true };
    vocabulary.own.push(OwnText { text: b"M77".to_vec(), place, coolant: None });
    let text = format!("{TNC}2 {}\n3 M77\n4 {}\n5 {}\n", SMOOTH[0], SMOOTH[1], SMOOTH[2]);
    let mut reader = Reader::new(text.as_bytes(), vocabulary);
    let mut found = Vec::new();
    while let Some((block, _)) = reader.next_block().expect("text in memory") {
        found.push(block.faults.len());
    }
    assert_eq!(found, [0, 0, 0, 1, 1, 0]);
}

const DRILLING: &str = "2 CYCL DEF 200 DRILLING ~\n  Q200=+2 ;SET-UP CLEARANCE ~\n  Q201=-10 ;DEPTH ~\n  Q206=+100 ;FEED ~\n  \
    Q202=+6 ;PLUNGING DEPTH ~\n  Q210=+0 ;DWELL ~\n  Q203=+0 ;SURFACE ~\n  Q204=+25 ;2ND CLEARANCE ~\n  Q211=+0 ;DWELL\n3 M8\n";

#[test]
fn what_follows_the_first_semicolon_of_a_physical_line_is_comment() {
    let of = |text: &str| faults(Family::Heidenhain, &format!("{TNC}{text}"));
    assert_eq!(of(DRILLING), [""; 0]);
    let joined = DRILLING.replace("DEPTH ~\n  Q210", "DEPTH ~   Q210");
    assert!(of(&joined).iter().any(|text| text.contains("Q210") && text.contains("missing")), "{:?}", of(&joined));
    // A mark that nothing follows, and one within a comment, are no end of a parameter.
    assert_eq!(of(&DRILLING.replace(";DEPTH ~", ";DEPTH ~ OF ~ HOLE ~")), [""; 0]);
    for (from, to) in [
        ("DRILLING ~\n", "DRILLING ~ "),
        ("DRILLING ~\n", "DRILLING ;"),
        (";FEED ~\n  Q202", "~ Q202"),
        (";DWELL\n", ";DWELL ~\n"),
        (";DEPTH ~", ";DEPTH"),
        ("3 M8\n", "3 M8 ~\n4 M9\n"),
        ("3 M8\n", "3 ; A ~\n4 L X+5 R0 FMAX\n"),
        ("3 M8\n", "3 M8 ;A ~\n4 L X+5 R0 FMAX\n"),
        ("3 M8\n", "3 * - A ~\n4 L X+5 R0 FMAX\n"),
    ] {
        let changed = DRILLING.replacen(from, to, 1);
        assert_ne!(changed, DRILLING, "{from}");
        assert!(!of(&changed).is_empty(), "{changed}");
    }
}

#[test]
fn a_finding_shows_the_lines_as_the_program_has_them() {
    let text = format!("{TNC}{DRILLING}");
    let mut reader = Reader::new(text.as_bytes(), vocabulary(Family::Heidenhain));
    let mut seen = Vec::new();
    while let Some((_, text)) = reader.next_block().expect("text in memory") {
        seen.push(String::from_utf8_lossy(text).into_owned());
    }
    assert!(DRILLING.starts_with(&seen[2]) && seen[2].contains("~\n  Q200=+2"), "{}", seen[2]);
}

#[test]
fn a_function_at_the_end_of_a_block_comes_before_or_after_the_cycle_there() {
    let of = |end: &str| {
        let text = format!("{TNC}{DRILLING}4 L X+5 Y+5 Z+25 R0 FMAX {end}\n");
        let blocks = read(Family::Heidenhain, &text);
        let block = blocks.iter().find(|block| block.action.moves()).expect("it moves");
        let coolant = |state: &State| state.coolant;
        (coolant(&block.state), block.early.as_deref().map(coolant))
    };
    assert_eq!(of("M9").1, None);
    let (late, early) = of("M99 M9");
    assert_eq!(late, Some(0));
    assert!(early.flatten().is_some_and(|on| on != 0), "{early:?}");
}
