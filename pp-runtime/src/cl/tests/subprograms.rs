//! Subprograms: DEFSUB, ENDSUB and CALSUB.

use super::*;

/// Events of a file whose only remark is that its subprograms are written in full.
#[track_caller]
fn called(text: &str) -> Vec<String> {
    let outcome = read_from(text.as_bytes(), MM);
    let [remark] = &outcome.diagnostics[..] else { panic!("{:?}", outcome.diagnostics) };
    assert!(remark.text.contains("written in full"), "{remark:?}");
    outcome.events
}

#[test]
fn many_subprograms_take_no_more_time_than_their_text_and_their_number_is_bounded() {
    let define = |count: u32| (0..count).map(|n| format!("DEFSUB/{n}\nENDSUB\n")).collect::<String>();
    // A search through all known subprograms for each new one took a minute here.
    let text = format!("{}GOTO/0,0,0\nCALSUB/99999\n", define(100_000));
    assert_eq!(called(&text).len(), 1);
    let found = errors(&format!("{}GOTO/0,0,0\n", define(100_002)));
    assert_eq!(found[0], "200001:1+13 the file defines too many subprograms");
    assert_eq!(found.len(), 2);
}

#[test]
fn a_subprogram_may_have_a_name() {
    let text = "DEFSUB / Pocket_1\nGODLTA/1,0,0\nENDSUB\nGOTO/0,0,0\nCALSUB / POCKET_1\n";
    assert_eq!(called(text)[1], "2:1 feed 1 0 0 axis 0 0 1 None");
    refused(&text.replace("POCKET_1", "POCKET_2"), "5:10+8 no DEFSUB with this name comes before the call");
    let long = "A".repeat(33);
    refused(&format!("GOTO/0,0,0\nCALSUB/{long}\n"), "2:8+33 the name of a subprogram has at most 32 characters");
}

#[test]
fn calls_of_subprograms_are_one_warning_that_they_are_written_in_full() {
    let text = "DEFSUB/1\nGODLTA/1,0,0\nENDSUB\nGOTO/0,0,0\nCALSUB/1\nGOTO/0,5,0\nCALSUB/1\n";
    let [warning] = &read_from(text.as_bytes(), MM).diagnostics[..] else { panic!("one warning") };
    assert_eq!((warning.severity, warning.location.line), (Severity::Warning, 5));
    assert!(warning.text.starts_with("calls of subprograms (CALSUB): 2; their records are written in full"));
    assert_eq!(read_from(&b"DEFSUB/1\nGODLTA/1,0,0\nENDSUB\nGOTO/0,0,0\n"[..], MM).diagnostics, []);
}

#[test]
fn a_subprogram_is_executed_where_it_is_called() {
    let text = "DEFSUB/1\nGODLTA/1,0,0\nPPRINT there\nENDSUB\nGOTO/0,0,0\nCALSUB/1\nGOTO/0,5,0\nCALSUB/1\n";
    let found = called(text);
    assert_eq!(
        found,
        [
            "5:1 feed 0 0 0 axis 0 0 1 None",
            "2:1 feed 1 0 0 axis 0 0 1 None",
            "3:1 message there",
            "7:1 feed 0 5 0 axis 0 0 1 None",
            "2:1 feed 1 5 0 axis 0 0 1 None",
            "3:1 message there",
        ]
    );
    refused("GOTO/0,0,0\nCALSUB/2\n", "2:8+1 no DEFSUB with this name comes before the call");
    refused("GOTO/0,0,0\nDEFSUB/2\nGOTO/1,0,0\n", "3:1+10 the file ends before the ENDSUB of a subprogram");
    refused("GOTO/0,0,0\nENDSUB\n", "2:1+6 ENDSUB without DEFSUB");
    refused("DEFSUB/1\nCALSUB/1\nENDSUB\nGOTO/0,0,0\nCALSUB/1\n", "2:8+1 CALSUB inside a subprogram is not supported");
    refused("DEFSUB/1\nENDSUB\nDEFSUB/1\nENDSUB\nGOTO/0,0,0\n", "3:1+8 this subprogram is already defined");
    refused("DEFSUB/1\n  GOTO/1,2\nENDSUB\nGOTO/0,0,0\n", "2:8+3 GOTO needs 3 or 6 numbers, found 2");
    refused(
        "DEFSUB/1\n  GODLTA/1\nENDSUB\nCALSUB/1\nGOTO/0,0,0\n",
        "2:10+1 GODLTA is relative to the tool position, which is unknown here",
    );
}
