//! Bytes, lines and continuations.

use super::*;
use proptest::prelude::*;
use std::time::{Duration, Instant};

const GOTO: &str = "GOTO/-12.5,.839020,1.E-3,0.6000000,0.0000000,-0.8";

/// A file of every kind of line, without continuations.
const MIXED: &str = "$$ NAME\nPARTNO/'A B'\nUNITS/MM\nTOOL PATH/P1,TOOL,T1\nLOADTL/3\n$$-> CUTTER / 4.5\nRAPID\n\
                     GOTO/1,2,3\nFEDRAT/100,MMPM\nGOTO/1,2,-3,0,.6,.8\n\nPPRINT hello\nOPSTOP\nEND\nGOTO/0,0,0\nFINI\n";

/// Files of four CAM systems, with every record that can stay open.
const WHOLE: [&str; 5] = [
    include_str!("whole/nx.cls"),
    include_str!("whole/catia.aptsource"),
    include_str!("whole/creo.ncl"),
    include_str!("whole/solidworks.apt"),
    include_str!("whole/others.cls"),
];

/// Input that returns `size` bytes at a time.
struct InPieces<'a> {
    bytes: &'a [u8],
    size: usize,
}

impl Read for InPieces<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> std::io::Result<usize> {
        let count = self.size.min(self.bytes.len()).min(buffer.len());
        buffer[..count].copy_from_slice(&self.bytes[..count]);
        self.bytes = &self.bytes[count..];
        Ok(count)
    }
}

fn without_places(events: &[String]) -> Vec<&str> {
    events.iter().map(|event| event.split_once(' ').unwrap().1).collect()
}

#[test]
fn all_line_ends_give_the_same_events_at_the_same_places() {
    let expected = events(MIXED);
    assert_eq!(expected.len(), 8);
    for end in ["\r\n", "\r"] {
        assert_eq!(events(&MIXED.replace('\n', end)), expected, "{end:?}");
    }
}

#[test]
fn the_last_line_needs_no_end() {
    assert_eq!(events("GOTO/1,2,3"), events("GOTO/1,2,3\n"));
    assert_eq!(events("GOTO/1,2,3\x1a").len(), 1);
}

#[test]
fn the_size_of_the_reads_does_not_matter() {
    let text = format!("{MIXED}GOTO/1,2$\n.5,3\nBREAK/1,2,3\n").replace('\n', "\r\n");
    let whole = read_from(text.as_bytes(), MM);
    assert_eq!(whole.diagnostics.len(), 1);
    for size in [1, 2, 7, 1000] {
        let pieces = read_from(InPieces { bytes: text.as_bytes(), size }, MM);
        assert_eq!(pieces.events, whole.events, "{size}");
        assert_eq!(pieces.diagnostics, whole.diagnostics, "{size}");
    }
}

#[test]
fn statements_across_the_end_of_the_buffer_are_whole() {
    for line in ["GOTO/1.5,2.5,3.5,0,0,1 $$ some comment\n", "GOTO/1.5,2.5,3.5,0,0,1\n", "GOTO/1.5,2.5,3.5,0,0,1  \r\n"]
    {
        let found = events(&line.repeat(25_000));
        assert_eq!(found.len(), 25_000);
        for (index, event) in found.iter().enumerate() {
            assert_eq!(*event, format!("{}:1 feed 1.5 2.5 3.5 axis 0 0 1 None", index + 1));
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(3000))]
    /// A limit of columns beyond every line changes nothing, but then no line is read in one pass.
    #[test]
    fn a_line_read_in_one_pass_has_the_meaning_it_has_else(
        lines in prop::collection::vec(
            "(GOTO|goto| GOTO|GOTO |GOTO/1,2,3 )?/? ?(-?[0-9]{0,7}[.]?[0-9]{0,9}[, \\t/]){1,7}[0-9.]{1,4}([ $]|E1|D2|,|x)?", 1..6
        ),
        end in prop::sample::select(vec!["\n", "\r\n", "\r", "$$ A\n", "\n\nGOTO/1,2,3\n"]),
        size in prop::sample::select(vec![1_usize, 5, 64, 4096]),
    ) {
        let text: String = lines.iter().flat_map(|line| [line, end]).collect();
        let options = ReadingOptions { columns: Some(4096), ..MM.into() };
        let (found, expected) =
            (read_from(InPieces { bytes: text.as_bytes(), size }, MM), read_from(text.as_bytes(), options));
        prop_assert_eq!(found.events, expected.events);
        prop_assert_eq!(found.diagnostics, expected.diagnostics);
    }

    /// Nor does it for lines that are continued, several in succession or one.
    #[test]
    fn a_joined_statement_read_in_one_pass_has_the_meaning_it_has_else(
        lines in prop::collection::vec(
            (
                "(GOTO|GOTO|goto| GOTO|GOTO )/ ?(-?[0-9]{1,4}[.][0-9]{0,5}, ?){2}-?[0-9]{1,4}[.][0-9]{0,5}(,0,[.]6,[.]8)?(,|x| )?",
                prop::collection::vec((any::<prop::sample::Index>(), "[$] {0,2}"), 0..4),
                1_usize..4,
            ),
            1..6,
        ),
        between in prop::sample::select(vec!["", "$$ A\n", "FEDRAT/5,MMPM\n", "CYCLE/DRILL,DEPTH,5,MMPM,5\n", "CYCLE/OFF\n"]),
        end in prop::sample::select(vec!["\n", "\r\n", "\r"]),
        size in prop::sample::select(vec![1_usize, 5, 64, 4096]),
    ) {
        let mut text = String::new();
        for (line, breaks, times) in &lines {
            let mut line = line.clone();
            for (at, mark) in breaks {
                line.insert_str(at.index(line.len()), &format!("{mark}\n"));
            }
            (0..*times).for_each(|_| text += &format!("{line}\n"));
            text += between;
        }
        let text = text.replace('\n', end);
        let options = ReadingOptions { columns: Some(4096), ..MM.into() };
        let (found, expected) =
            (read_from(InPieces { bytes: text.as_bytes(), size }, MM), read_from(text.as_bytes(), options));
        prop_assert_eq!(found.events, expected.events);
        prop_assert_eq!(found.diagnostics, expected.diagnostics);
    }

    /// Nor does it for circles, whose axis and ends are right where the text of their numbers is.
    #[test]
    fn a_circle_read_in_one_pass_has_the_meaning_it_has_else(
        lines in prop::collection::vec(
            (
                "GOTO/1,0,0[ ]?",
                "(CIRCLE|CIRCLE|circle| CIRCLE|CIRCLE )/ ?-?0[.]?0{0,9}, ?(0.0|-0.|0),0(,0[.]0,0,[-+]?1[.]?0?)?(,[0-9]?1([.]0{0,3})?)?\
                 (,[.]06,(0[.]5|[0-9]{1,16}),1E1,-?3[.])?(,TIMES,2|,|x| [$][$] c)?[ ]?",
                "(GOTO/0,1[.]?0{0,2},0( /1,0,0)?|PPRINT/A|FEDRAT/5)",
            ),
            1..6,
        ),
        end in prop::sample::select(vec!["\n", "\r\n", "\r", "$$ A\n", "\n\nCIRCLE/0,0,0,0,0,1\n"]),
        size in prop::sample::select(vec![1_usize, 5, 64, 4096]),
    ) {
        let text: String = lines.iter().flat_map(|(start, circle, goto)| [start, "\n", circle, end, goto, end]).collect();
        let options = ReadingOptions { columns: Some(4096), ..MM.into() };
        let (found, expected) =
            (read_from(InPieces { bytes: text.as_bytes(), size }, MM), read_from(text.as_bytes(), options));
        prop_assert_eq!(found.events, expected.events);
        prop_assert_eq!(found.diagnostics, expected.diagnostics);
    }
}

#[test]
fn a_number_cut_in_two_is_one_number() {
    assert_eq!(
        events("GOTO/0$\n.839020,-0$\n.738549,   1$   \n.000000\n"),
        ["1:1 feed 0.83902 -0.738549 1 axis 0 0 1 None"]
    );
}

#[test]
fn a_continuation_adds_and_trims_no_blanks() {
    refused("GOTO/1,2,0$\n .5\n", "1:10+1 `0 .5` is not a number");
}

#[test]
fn a_fault_on_a_continued_line_is_placed_on_that_line() {
    refused("GOTO/1,$\n  2,$\n3x,0,0,1\n", "3:1+2 `3x` is not a number");
    refused("GOTO/1,2$\n,3,4$\n,5\n", "1:6+3 GOTO needs 3 or 6 numbers, found 5");
}

#[test]
fn a_blank_before_the_word_moves_its_column() {
    assert_eq!(events("  \tGOTO / 1 , 2,\t3 \n"), ["1:4 feed 1 2 3 axis 0 0 1 None"]);
}

#[test]
fn a_comment_that_ends_in_a_dollar_swallows_no_goto() {
    assert_eq!(events("$$ costs 5 $\nGOTO/1,2,3\n").len(), 1);
    assert_eq!(events("$$\nGOTO/1,2,3\n").len(), 1);
}

#[test]
fn a_creo_comment_is_continued_by_a_dollar() {
    let csys = "$$-> CSYS / 1,0,0,0, $\n 0,1,0,0, $\n 0,0,1,0\nGOTO/1,2,3\n";
    assert_eq!(events(csys).len(), 1);
    let mut reader = ClReader::new(csys.as_bytes(), MM.into());
    while reader.next_event().unwrap().is_some() {}
    assert_eq!(reader.frame().unwrap().axes, [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]);
}

#[test]
fn a_dollar_inside_a_statement_joins_nothing() {
    refused(
        "GOTO/1,2,3 $ five\n,0,0,1\nGOTO/1,2,3\n".replace("\n,0,0,1", "").as_str(),
        "1:10+8 `$` inside a statement: `3 $ five`",
    );
}

#[test]
fn a_comment_after_a_record_ends_it() {
    assert_eq!(events("GOTO/1,2,3 $$ 4,5\nGOTO/1,$ $$ cut\n2,3\n").len(), 2);
}

#[test]
fn a_file_that_ends_after_a_dollar_is_refused() {
    refused("GOTO/0,0,0\nGOTO/1,2,3$\n", "2:1+10 the file ends after the `$` that continues this statement");
}

#[test]
fn a_byte_order_mark_and_foreign_encodings_are_no_fault() {
    let text = b"\xEF\xBB\xBFPPRINT \xCF\xD0\n$$ \xFF\xFE\nGOTO/1,2,3\n";
    let outcome = read_from(&text[..], MM);
    assert_eq!(outcome.diagnostics, []);
    assert_eq!(outcome.events.len(), 2);
    assert!(outcome.events[0].starts_with("1:1 message"));
}

#[test]
fn empty_binary_and_motionless_files_have_one_clear_error() {
    refused("", "1:1+1 the file is empty");
    refused("\u{FEFF}", "1:1+1 the file is empty");
    refused("GOTO/1,2,3\n\0\0GOTO\n", "1:1+1 this is not a text file: it contains NUL bytes");
    refused("\n$$ nothing\nFINI\n", "1:1+1 the file contains no motion: no GOTO was found");
}

#[test]
fn a_line_of_ten_megabytes_ends_soon_and_in_one_error() {
    let mut text = b"GOTO/1,2,3\nGOTO/".to_vec();
    text.resize(10_000_000, b'1');
    text.extend_from_slice(b"\nGOTO/4,5\n");
    let start = Instant::now();
    let outcome = read_from(&text[..], MM);
    assert!(start.elapsed() < Duration::from_secs(20));
    let texts: Vec<_> = outcome.diagnostics.iter().map(|d| (d.location.line, d.text.as_str())).collect();
    assert_eq!(texts, [(2, "this statement is longer than 1048576 bytes"), (3, "GOTO needs 3 or 6 numbers, found 2")]);
}

#[test]
fn ten_megabytes_of_continued_lines_end_soon_and_in_one_error() {
    let text = format!("GOTO/{}3\nGOTO/4,5\n", "1,$\n".repeat(2_500_000));
    let found = errors(&text);
    assert_eq!(found.len(), 2);
    assert_eq!(found[0], "1:1+1 this statement is longer than 1048576 bytes");
    assert_eq!(found[1], "2500002:6+3 GOTO needs 3 or 6 numbers, found 2");
}

#[test]
fn continued_lines_without_text_make_a_statement_longer_too() {
    let found = errors(&format!("GOTO/1,$\n{}2,3\nGOTO/4,5\n", "$\n".repeat(100_000)));
    assert_eq!(found.len(), 2);
    assert_eq!(found[0], "1:1+1 this statement is longer than 1048576 bytes");
}

#[test]
fn a_statement_that_is_too_long_is_reported_at_the_end_of_the_file_as_well() {
    // The statement is never finished.
    let found = errors(&format!("GOTO/1,$\n{}", "$\n".repeat(100_000)));
    assert_eq!(found, ["1:1+1 this statement is longer than 1048576 bytes"]);
}

/// Random numbers (xorshift): fast, and the same in every run.
fn noise(state: &mut u64) -> u64 {
    *state ^= *state << 13;
    *state ^= *state >> 7;
    *state ^= *state << 17;
    *state
}

#[test]
fn a_hundred_thousand_random_inputs_cause_no_panic() {
    const PARTS: [&str; 64] = [
        "GOTO/",
        "FROM/",
        "FEDRAT/",
        "SPINDL/",
        "LOADTL/",
        "LOAD/TOOL,",
        "CUTTER/",
        "TLDATA/",
        "MILL,",
        "DRILL,",
        "MSYS/",
        "TLAXIS/",
        "UNITS/MM",
        "MULTAX",
        "TOOL PATH/",
        "PPRINT ",
        "PARTNO",
        "$$-> CSYS /",
        "$$-> CUTTER /",
        "$$*CATIA0",
        "$$",
        "$\n",
        "$",
        "\n",
        "\r",
        "\r\n",
        ",",
        "/",
        " ",
        "1",
        "0,0,1",
        "-.5E3",
        "1D400",
        "'",
        "RPM",
        "CLW",
        "OFF",
        "TOOLNO/",
        "COOLNT/",
        "CIRCLE/0,0,0,0,0,1\n",
        "CIRCLE/",
        "TIMES,2",
        "NURBS/\n",
        "KNOT/1\n",
        "CNTRL/1,0,0\n",
        "CYCLE/DRILL,",
        "CYCLE/OFF\n",
        "FEDTO,-3,",
        "RAPTO,1,",
        "DEPTH,3,",
        "GODLTA/1\n",
        "GOHOME\n",
        "TLON,GOFWD/(CIRCLE/0,0,0,1),ON,(LINE/0,0,0,1,0,0)\n",
        "INDIRV/0,1,0\n",
        "TRACUT/1,0,0,5,0,0,-1,0,0,1,0,0\n",
        "CSYS/1,0,0,0,0,1,0,0,0,0,1,0\n",
        "TRNTYP/WORLD,0,0,0\n",
        "INSERT ",
        "DEFSUB/1\n",
        "ENDSUB\n",
        "CALSUB/1\n",
        "CLEARP/XYPLAN,5\nRETRCT\n",
        "DELAY/1\n",
        "\u{FEFF}",
    ];
    let mut state = 0x9E37_79B9_7F4A_7C15;
    let mut text = Vec::new();
    for round in 0..100_000_u32 {
        text.clear();
        for _ in 0..noise(&mut state) % 24 {
            let choice = noise(&mut state);
            if choice & 1 == 0 {
                let index = usize::try_from(choice >> 8).unwrap() % PARTS.len();
                text.extend_from_slice(PARTS[index].as_bytes());
            } else {
                text.push(choice.to_le_bytes()[3]);
            }
        }
        let mut reader = ClReader::new(&text[..], MM.into());
        while let Some((place, _)) = reader.next_event().unwrap() {
            assert!(place.line >= 1 && place.column >= 1, "round {round}: {text:?}");
        }
        for diagnostic in reader.diagnostics() {
            let place = diagnostic.location;
            assert!(place.line >= 1 && place.column >= 1 && diagnostic.length >= 1, "round {round}: {text:?}");
        }
    }
}

proptest! {
    #[test]
    fn a_goto_cut_anywhere_reads_the_same(cuts in prop::collection::btree_set(1..GOTO.len(), 1..6)) {
        let mut text = String::new();
        let mut from = 0;
        for cut in cuts {
            text.push_str(&GOTO[from..cut]);
            text.push_str("$\n");
            from = cut;
        }
        text.push_str(&GOTO[from..]);
        prop_assert_eq!(events(&text), events(GOTO));
    }

    /// Lines deleted, doubled, swapped, and bytes changed: no panic, every place has line and column, and a file that
    /// is refused has an error.
    #[test]
    fn a_file_with_damage_is_read_or_refused_with_a_reason(
        damage in prop::collection::vec((0_u8..4, any::<prop::sample::Index>(), any::<prop::sample::Index>(), any::<u8>()), 0..6),
        whole in prop::sample::select(WHOLE.to_vec()),
    ) {
        let mut lines: Vec<Vec<u8>> = whole.lines().map(|line| line.as_bytes().to_vec()).collect();
        for (kind, first, second, byte) in damage {
            let (a, b) = (first.index(lines.len()), second.index(lines.len()));
            match kind {
                0 => lines[a].clear(),
                1 => lines[a] = lines[b].clone(),
                2 => lines.swap(a, b),
                _ => {
                    let length = lines[a].len();
                    if length > 0 {
                        lines[a][second.index(length)] = byte;
                    }
                }
            }
        }
        let text = lines.join(&b'\n');
        let options = ReadingOptions { insert: crate::cl::Insert::Write, frames: Some(crate::cl::Frames::Main), ..ReadingOptions::from(MM) };
        let mut reader = ClReader::new(&text[..], options);
        let mut motions = 0;
        while let Some((place, event)) = reader.next_event().unwrap() {
            prop_assert!(place.line >= 1 && place.column >= 1);
            motions += u32::from(matches!(event, Event::Motion(ToolMotion::Move(_) | ToolMotion::Hole(_) | ToolMotion::Arc(_))));
        }
        prop_assert!(reader.failed() || motions > 0);
        prop_assert_eq!(reader.failed(), reader.diagnostics().iter().any(|found| found.severity == Severity::Error));
    }

    #[test]
    fn any_bytes_read_the_same_in_pieces(bytes in prop::collection::vec(any::<u8>(), 0..200), size in 1_usize..9) {
        let whole = read_from(&bytes[..], MM);
        let pieces = read_from(InPieces { bytes: &bytes, size }, MM);
        prop_assert_eq!(without_places(&whole.events), without_places(&pieces.events));
        prop_assert_eq!(whole.diagnostics, pieces.diagnostics);
    }
}

#[test]
fn a_dollar_pair_in_quotes_or_after_insert_begins_no_comment() {
    assert_eq!(errors("SYN/'TLAXIS','$$*TLAXIS'\nGOTO/0,0,0\n").len(), 1);
    assert_eq!(events_without_places("PARTNO/'A $$ B'\nGOTO/0,0,0\n", MM)[0], "name A $$ B");
    assert_eq!(events_without_places("PPRINT don't $$ it\nGOTO/0,0,0\n", MM)[0], "message don't");
}
