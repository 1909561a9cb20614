//! What blocks mean, control by control.

use std::f64::consts::{PI, TAU};

use super::*;
use crate::program::{Rotation, Units};

mod arcs;
mod closed;
mod cycles;
mod flow;
mod frame;
mod guards;
mod heidenhain;
mod moves;
mod own;
mod planes;
mod state;

fn vocabulary(family: Family) -> Vocabulary {
    let name =
        |letter: &str| AxisName { name: letter.as_bytes().to_vec(), rotary: "ABC".contains(letter), rollover: None };
    Vocabulary {
        family,
        axes: ["C", "B", "X", "Y", "Z"].map(name).to_vec(),
        own: vec![
            OwnText { text: b"M428".to_vec(), place: OwnPlace::TipControl { on: true }, coolant: None },
            OwnText { text: b"M429".to_vec(), place: OwnPlace::TipControl { on: false }, coolant: None },
        ],
        effects: Vec::new(),
        lookup: Lookup::default(),
        swivel_data: "TC".to_owned(),
        spindle_number: None,
        plain: false,
        tools: vec![("MILL 10".to_owned(), 7)],
        tools_by_name: false,
        rounding: 0.5e-3,
    }
}

/// Every block of a program.
fn read(family: Family, text: &str) -> Vec<Block> {
    let mut reader = Reader::new(text.as_bytes(), vocabulary(family));
    let mut blocks = Vec::new();
    while let Some((block, _)) = reader.next_block().expect("text in memory") {
        blocks.push(block.clone());
    }
    blocks
}

/// The last block of a program in which nothing is wrong.
fn last(family: Family, text: &str) -> Block {
    let blocks = read(family, text);
    for block in &blocks {
        assert_eq!(block.faults, [], "line {} of {text}", block.line);
    }
    blocks.last().cloned().expect("a block")
}

fn faults(family: Family, text: &str) -> Vec<String> {
    read(family, text).into_iter().flat_map(|block| block.faults).map(|fault| fault.text).collect()
}

const LINUXCNC: &str = "G21 G17 G40 G49 G80 G90 G94 G54 G64 P0.01\n";
const SIEMENS: &str = "G710 G17 G40 G64 G90 G94 G54\n";
const TNC: &str = "0 BEGIN PGM A MM\n1 TOOL CALL 3 Z S5000\n";

fn xyz(block: &Block) -> [f64; 3] {
    [block.values[2], block.values[3], block.values[4]]
}

fn near(a: [f64; 3], b: [f64; 3]) -> bool {
    a.iter().zip(&b).all(|(a, b)| (a - b).abs() < 1e-9)
}

#[test]
fn words_stay_in_force_and_are_mm_and_rad() {
    let block = last(Family::LinuxCnc, &format!("{LINUXCNC}G0 X1 Y2 Z3 B90 C-720\nG1 X-4.5 F250\nZ.5"));
    assert_eq!(block.action, Action::Feed);
    assert!(near(xyz(&block), [-4.5, 2.0, 0.5]));
    assert_eq!((block.values[1], block.values[0], block.state.feed), (PI / 2.0, -2.0 * TAU, Some(250.0)));
    let inch = last(Family::LinuxCnc, "G20 G90 G94 G17\nG1 X1 Y0 Z0 F10");
    assert!(near(xyz(&inch), [25.4, 0.0, 0.0]));
    assert_eq!(inch.state.units, Some(Units::Inches));
}

#[test]
fn distances_add_up_and_are_known_only_from_a_known_place() {
    let block = last(Family::LinuxCnc, &format!("{LINUXCNC}G0 X1 Y2 Z3\nG91\nG1 X5 F100"));
    assert!(near(xyz(&block), [6.0, 2.0, 3.0]));
    assert!(faults(Family::LinuxCnc, &format!("{LINUXCNC}G91\nG1 X5 F100"))[0].contains("an unknown position"));
}

#[test]
fn a_number_without_a_point_depends_on_a_setting_on_fanuc_and_haas() {
    let fanuc = format!("{}G1 X10 Y10. Z0 F100.\n", &LINUXCNC.replace(" G64 P0.01", ""));
    assert!(faults(Family::Fanuc, &fanuc)[0].contains("without a decimal point"));
    let haas = format!("{}G1 X1. Y0. Z0. F100\n", &LINUXCNC.replace(" G64 P0.01", ""));
    assert!(faults(Family::Haas, &haas)[0].contains("depends on a setting"));
}

#[test]
fn a_dwell_is_seconds_or_milliseconds() {
    assert_eq!(last(Family::LinuxCnc, "G4 P500").action, Action::Dwell(500.0));
    assert_eq!(last(Family::Fanuc, "G4 P500").action, Action::Dwell(0.5));
    assert_eq!(last(Family::Haas, "G04 P0.5").action, Action::Dwell(0.5));
    assert_eq!(last(Family::Siemens, "G4 F0.5").action, Action::Dwell(0.5));
    assert_eq!(
        last(Family::Heidenhain, "1 CYCL DEF 9.0 DWELL TIME\n2 CYCL DEF 9.1 DWELL 0.5").action,
        Action::Dwell(0.5)
    );
}

#[test]
fn what_is_not_known_is_a_fault_and_never_passed_over() {
    for text in ["G77", "X1 @", "M55", "G1 X1 X2", "G0 G1 X1", "(open", "E5", "Q3", "G1 X1e5", "G43", "#3000=5"] {
        assert!(!faults(Family::LinuxCnc, &format!("{LINUXCNC}{text}")).is_empty(), "{text}");
    }
    for text in ["FOO", "G1 X=A", "CYCLE99(1)", "G0 G1 X1", "IF R1>0 GOTOF A"] {
        assert!(!faults(Family::Siemens, &format!("{SIEMENS}{text}")).is_empty(), "{text}");
    }
    for text in ["2 FOO", "2 L X+1 W+2", "3 L X+1", "L X+1", "2 PLANE VECTOR BX1", "2 CYCL DEF 19.0"] {
        assert!(!faults(Family::Heidenhain, &format!("{TNC}{text}")).is_empty(), "{text}");
    }
    assert!(!faults(Family::Fanuc, "M10").is_empty());
}

#[test]
fn machine_coordinates_leave_the_place_unknown() {
    for (family, text) in [
        (Family::LinuxCnc, format!("{LINUXCNC}G0 X1 Y1 Z1 B0 C0\nG53 G0 Z0")),
        (Family::Siemens, format!("{SIEMENS}G0 X1 Y1 Z1 B0 C0\nSUPA G0 Z0 D0")),
        (Family::Heidenhain, format!("{TNC}2 L X+1 Y+1 Z+1 B+0 C+0 R0 FMAX\n3 L Z+0 R0 FMAX M91")),
    ] {
        let block = last(family, &text);
        assert_eq!((block.action, block.written, block.values[4]), (Action::Machine, 1 << 4, 0.0), "{text}");
        assert_eq!(block.known & (1 << 4), 0, "{text}");
    }
}

#[test]
fn tool_spindle_and_coolant_are_kept() {
    for (family, text) in [
        (Family::LinuxCnc, "T7 M6\nG43 H7\nS5000 M4\nM8"),
        (Family::Fanuc, "T7 M6\nT8\nS5000 M4\nM8\nG0 G43 H7 Z5."),
        (Family::Siemens, "T7\nM6\nD7\nS5000 M4\nM8"),
        (Family::Heidenhain, "0 TOOL CALL 7 Z S5000\n1 TOOL DEF 8\n2 M4\n3 M8"),
    ] {
        let state = last(family, text).state;
        assert_eq!(state.tool, Some(7), "{text}");
        assert_eq!(state.length, Some(Length::Register(7)), "{text}");
        assert_eq!((state.spindle, state.speed), (Some(Some(Rotation::CounterClockwise)), Some(5000.0)), "{text}");
        assert_eq!(state.coolant, Some(coolant::FLOOD), "{text}");
    }
}

fn hole(block: &Block) -> CycleMove {
    match block.action {
        Action::Cycle(cycle) => CycleMove { over: None, ..cycle },
        other => panic!("{other:?}"),
    }
}

#[test]
fn cycles_make_the_same_hole_on_each_control() {
    let peck = CycleMove {
        kind: CycleKind::Peck(3.0),
        over: None,
        reference: 2.0,
        bottom: -10.0,
        back_to: 25.0,
        dwell: 0.0,
        feed: None,
        gap: None,
    };
    let texts = [
        (Family::LinuxCnc, format!("{LINUXCNC}G0 X0 Y0 Z25\nG98 G83 X1 Y2 Z-10 R2 Q3 F100"), None),
        (
            Family::Fanuc,
            format!("{}G0 X0. Y0. Z25.\nG98 G83 X1. Y2. Z-10. R2. Q3. F100.", LINUXCNC.replace(" G64 P0.01", "")),
            None,
        ),
        (Family::Siemens, format!("{SIEMENS}F100\nMCALL CYCLE83(25,0,2,-10,,,3,0,0,,1,1)\nG0 X1 Y2"), None),
        (
            Family::Heidenhain,
            format!(
                "{TNC}2 L X+0 Y+0 Z+25 R0 FMAX\n3 CYCL DEF 200 DRILLING ~\n Q200=+2 ;A ~\n Q201=-10 ;B ~\n Q206=+100 ;C ~\n Q202=+3 ;D ~\n Q210=+0 ~\n Q203=+0 ;E ~\n Q204=+25 ;F ~\n Q211=+0\n4 L X+1 Y+2 R0 FMAX M99"
            ),
            Some(100.0),
        ),
    ];
    for (family, text, feed) in texts {
        let block = last(family, &text);
        assert_eq!(hole(&block), CycleMove { feed, ..peck }, "{text}");
        assert!(near(xyz(&block), [1.0, 2.0, 25.0]), "{text}");
    }
}

#[test]
fn a_cycle_goes_on_at_each_point_until_it_is_cancelled() {
    let blocks = read(Family::LinuxCnc, &format!("{LINUXCNC}G0 X0 Y0 Z25\nG99 G81 X1 Y2 Z-10 R2 F100\nX5\nG80\nG0 X9"));
    let holes: Vec<_> = blocks.iter().filter(|block| matches!(block.action, Action::Cycle(_))).collect();
    assert_eq!(holes.len(), 2);
    assert!(near(xyz(holes[1]), [5.0, 2.0, 2.0]));
    assert_eq!(blocks.last().map(|block| block.action), Some(Action::Rapid));
    let called = read(Family::Siemens, &format!("{SIEMENS}MCALL CYCLE81(25,0,2,-10)\nG0 X1 Y2\nX5\nMCALL\nX9"));
    assert_eq!(called.iter().filter(|block| matches!(block.action, Action::Cycle(_))).count(), 2);
    assert_eq!(called.last().map(|block| block.action), Some(Action::Rapid));
}

fn tilt(block: &Block) -> Tilt {
    block.state.tilt.expect("a plane")
}

#[test]
fn tip_control_is_switched_on_and_off() {
    for (family, on, off) in [
        (Family::Fanuc, "G43.4 H1", "G49"),
        (Family::Haas, "G234 H1", "G49"),
        (Family::Siemens, "TRAORI", "TRAFOOF"),
        (Family::LinuxCnc, "M428", "M429"),
        (Family::Heidenhain, "1 FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS", "2 FUNCTION RESET TCPM"),
        (Family::Heidenhain, "1 M128", "2 M129"),
    ] {
        assert_ne!(last(family, on).state.tip_control, TipControl::Off, "{on}");
        assert_eq!(last(family, &format!("{on}\n{off}")).state.tip_control, TipControl::Off, "{off}");
    }
}

#[test]
fn words_of_axes_that_roll_over_are_turned_the_way_the_control_turns_them() {
    let mut vocabulary = vocabulary(Family::LinuxCnc);
    vocabulary.axes[0].rollover = Some(crate::check::read::RolloverRule::Sign);
    vocabulary.axes[1].rollover = Some(crate::check::read::RolloverRule::Shortest);
    let text = format!("{LINUXCNC}G0 B350 C350\nB10 C10\nC-350\nC-360");
    let mut reader = Reader::new(text.as_bytes(), vocabulary);
    let mut seen = Vec::new();
    while let Some((block, _)) = reader.next_block().expect("text in memory") {
        assert_eq!(block.faults, []);
        seen.push([block.values[1].to_degrees().round(), block.values[0].to_degrees().round()]);
    }
    assert_eq!(seen[1..], [[350.0, 350.0], [370.0, 370.0], [370.0, 350.0], [370.0, 0.0]]);
}

#[test]
fn a_guard_is_known_and_nothing_moves_in_it() {
    let guard = "o1 if [[ABS[#5403 - 101.5] GT 0.01] AND [ABS[[#5403 * 25.4] - 101.5] GT 0.01]]\n(abort, no)\no1 endif";
    let wanted = Guard { length_mm: 101.5, tolerance_mm: 0.01, source: LengthSource::Spindle, stops: true };
    assert_eq!(last(Family::LinuxCnc, guard).guards.length, Some(wanted));
    assert!(!faults(Family::LinuxCnc, &guard.replace("(abort, no)", "G0 X1")).is_empty());
    let fanuc = "IF [ABS[#11001-101.5] LT 0.01] GOTO 5\n#3000=1 (LENGTH)\nN5 G0";
    let wanted = Guard { source: LengthSource::Variable(11_001), ..wanted };
    assert_eq!(read(Family::Fanuc, fanuc)[1].guards.length, Some(wanted));
    assert!(faults(Family::Fanuc, fanuc).is_empty());
    assert!(!faults(Family::Fanuc, "#3000=1 (LENGTH)").is_empty());
}

#[test]
fn lines_of_any_length_and_any_bytes_are_read_without_harm() {
    let long = format!("G0 X1\n({})\nG0 X2\n", "a".repeat(1 << 18));
    assert!(faults(Family::LinuxCnc, &long).iter().any(|text| text.contains("longer than")));
    let mut state = 0x2545_f491_4f6c_dd1d_u64;
    let bytes: Vec<u8> = (0..200_000)
        .map(|_| {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            b"GXYZBCMTFSHDPQRLIJKNO0123456789.-+=()[]; \n~\"#%CYCLE"[(state % 51) as usize]
        })
        .collect();
    for family in [Family::LinuxCnc, Family::Fanuc, Family::Haas, Family::Siemens, Family::Heidenhain] {
        let mut reader = Reader::new(&bytes[..], vocabulary(family));
        while reader.next_block().expect("memory").is_some() {}
    }
}

#[test]
fn one_code_ends_what_the_set_up_and_the_control_have_switched_on() {
    for family in [Family::Fanuc, Family::Siemens, Family::Heidenhain] {
        let mut vocabulary = vocabulary(family);
        for (text, on) in [(b"M7", true), (b"M9", false)] {
            let coolant = Some((coolant::MIST, on));
            vocabulary.own.push(OwnText { text: text.to_vec(), place: OwnPlace::Coolant, coolant });
        }
        let text = if family == Family::Heidenhain { "1 M8\n2 M9\n3 M7\n4 M9\n" } else { "M8\nM9\nM7\nM9\n" };
        let mut reader = Reader::new(text.as_bytes(), vocabulary);
        let mut found = Vec::new();
        while let Some((block, _)) = reader.next_block().expect("text in memory") {
            assert_eq!(block.faults, [], "{family:?}");
            found.push(block.state.coolant);
        }
        assert_eq!(found, [Some(coolant::FLOOD), Some(0), Some(coolant::MIST), Some(0)], "{family:?}");
    }
}

#[test]
fn the_sign_of_a_rolling_axis_is_its_way_and_not_its_place() {
    let mut vocabulary = vocabulary(Family::Fanuc);
    vocabulary.axes[0].rollover = Some(crate::check::read::RolloverRule::Sign);
    let mut reader = Reader::new(&b"G21 G90 G94 G17\nG0 C-181.5\nG0 C-181.5\nG0 C-180.\n"[..], vocabulary);
    let mut places = Vec::new();
    while let Some((block, _)) = reader.next_block().expect("text in memory") {
        places.push(block.values[0].to_degrees());
    }
    for (place, wanted) in places[1..].iter().zip([181.5, 181.5, 180.0]) {
        assert!((place - wanted).abs() < 1e-9, "{places:?}");
    }
}

#[test]
fn numbers_without_a_point_are_plain_where_the_set_up_says_so() {
    for (plain, wanted) in [(false, 0.01), (true, 10.0)] {
        let vocabulary = Vocabulary { plain, ..vocabulary(Family::Haas) };
        let mut reader = Reader::new(&b"G21 G90 G94 G17\nG00 X10\n"[..], vocabulary);
        let mut last = f64::NAN;
        while let Some((block, _)) = reader.next_block().expect("text in memory") {
            last = block.values[2];
        }
        assert!((last - wanted).abs() < 1e-12, "{plain}: {last}");
    }
}

#[test]
fn the_levels_of_a_cycle_count_as_the_other_lengths_do() {
    for (plain, unit) in [(false, 1e-3), (true, 1.0)] {
        let vocabulary = Vocabulary { plain, ..vocabulary(Family::Haas) };
        let text = b"G21 G90 G94 G17\nG00 X0. Y0. Z25.\nG98 G83 X1. Y2. Z-10 R2 Q3 F100.\n";
        let mut reader = Reader::new(&text[..], vocabulary);
        let mut last = Action::Nothing;
        while let Some((block, _)) = reader.next_block().expect("text in memory") {
            last = block.action;
        }
        let Action::Cycle(hole) = last else { panic!("{last:?}") };
        let CycleKind::Peck(step) = hole.kind else { panic!("{hole:?}") };
        assert!(near([hole.bottom, hole.reference, step], [-10.0 * unit, 2.0 * unit, 3.0 * unit]), "{hole:?}");
    }
}

#[test]
fn a_byte_order_mark_is_told_once_and_what_stands_behind_it_is_read() {
    let texts = [
        (Family::LinuxCnc, "%\nG21 G90 G94 G17\nG0 X1"),
        (Family::Fanuc, "O1 (A)\nG21 G90 G94 G17\nG0 X1."),
        (Family::Siemens, "G710 G90 G94 G17\nG0 X1"),
        (Family::Heidenhain, "0 BEGIN PGM A MM\n1 L X+1 R0 FMAX"),
    ];
    for (family, text) in texts {
        let marked = format!("\u{feff}{text}");
        let found = faults(family, &marked);
        assert!(found.len() == 1 && found[0].contains("byte order mark (UTF-8)"), "{family:?}: {found:?}");
        let (with, without) = (read(family, &marked), last(family, text));
        assert_eq!(with.last(), Some(&without), "{family:?}");
    }
    let wide: Vec<u8> = "\u{feff}G0 X1\n".encode_utf16().flat_map(u16::to_le_bytes).collect();
    let mut reader = Reader::new(&wide[..], vocabulary(Family::LinuxCnc));
    let (block, _) = reader.next_block().expect("text in memory").expect("a block");
    assert!(block.faults[0].text.contains("byte order mark (UTF-16)"), "{:?}", block.faults);
}

#[test]
fn under_tip_control_a_block_may_turn_the_tool_alone() {
    let text = "G710 G17 G90 G94\nTRAORI\nG1 X0 Y0 Z0 A3=0 B3=0 C3=1 F100\nA3=0 B3=0.6 C3=0.8\n";
    let block = last(Family::Siemens, text);
    assert_eq!(block.action, Action::Feed);
    assert!((block.state.vector.expect("a tool axis").y - 0.6).abs() < 1e-12);
}

/// A program in pieces of so many bytes.
struct InPieces<'a> {
    bytes: &'a [u8],
    size: usize,
}

impl TextPieces for InPieces<'_> {
    fn next_piece(&mut self, piece: &mut Vec<u8>) -> io::Result<()> {
        let (now, later) = self.bytes.split_at(self.size.min(self.bytes.len()));
        self.bytes = later;
        piece.clear();
        piece.extend_from_slice(now);
        Ok(())
    }
}

/// Every block of a program in pieces of so many bytes, and the text of its line.
fn in_pieces(family: Family, bytes: &[u8], size: usize) -> Vec<(Block, Vec<u8>)> {
    let mut reader = Reader::new(InPieces { bytes, size }, vocabulary(family));
    let mut blocks = Vec::new();
    while let Some((block, text)) = reader.next_block().expect("text in memory") {
        blocks.push((block.clone(), text.to_vec()));
    }
    blocks
}

#[test]
fn a_piece_may_end_anywhere_in_a_line() {
    let tnc = format!("{TNC}2 L X+1 Y+2 Z+3 B+0 C+0 R0 FMAX\n3 CYCL DEF 200 DRILLING~\n  Q200=2 ~\n  Q201=-5\n4 M99\n");
    for (family, text) in [
        (Family::LinuxCnc, format!("{LINUXCNC}(a comment)\n\nG0 X1 Y2 Z3 B90 C-720\nG1 X-4.5 F250\nG3 X1 Y0 I2\nZ.5")),
        (Family::Siemens, format!("{SIEMENS}G0 X1 Y2 Z3\nG1 X=-4.5 F250 ; to the end\nM30\n")),
        (Family::Heidenhain, tnc),
    ] {
        for text in [text.clone(), text.replace('\n', "\r\n")] {
            let whole = in_pieces(family, text.as_bytes(), usize::MAX);
            assert!(whole.len() > 3);
            for size in [1, 2, 3, 7, 64] {
                assert_eq!(in_pieces(family, text.as_bytes(), size), whole, "{size}: {text:?}");
            }
        }
    }
}

#[test]
fn a_line_is_read_up_to_the_longest_and_the_next_one_after_it() {
    for length in LONGEST - 2..LONGEST + 3 {
        let comment = format!("({})", "x".repeat(length - 5));
        for end in ["\n", "\r\n"] {
            let text = format!("G21 G90 G94 G17\nG1 {comment}{end}G0 X1 Y2 Z3\n");
            for size in [1, 1000, LONGEST - 1, LONGEST, LONGEST + 1, usize::MAX] {
                let blocks = in_pieces(Family::LinuxCnc, text.as_bytes(), size);
                let faults: Vec<_> = blocks.iter().map(|(block, _)| block.faults.len()).collect();
                // The line end counts as a byte of the line.
                let too_long = length + end.len() > LONGEST;
                assert_eq!(blocks.len(), 3, "{length} {size}");
                assert_eq!((faults[0], faults[2]), (0, 0), "{length} {size}: {:?}", blocks[2].0.faults);
                let is_long = blocks[1].0.faults.iter().any(|fault| fault.text.contains("longer than"));
                assert_eq!(is_long, too_long, "{length} {size}");
                assert_eq!((blocks[2].0.line, xyz(&blocks[2].0)), (3, [1.0, 2.0, 3.0]), "{length} {size}");
            }
        }
    }
}
