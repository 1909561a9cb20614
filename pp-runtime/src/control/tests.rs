//! Steps as each control spells them, and programs read back.

mod cycles;

use std::collections::BTreeMap;
use std::io;

use proptest::prelude::*;

use super::template::{self, Field};
use super::*;
use crate::config::sample::Sample;
use crate::config::{Config, starting_point};
use crate::control::{Options, ProgramBlocks, Smoothing};
use crate::motion::{ArcPlane, AxisWords, Circle, FeedWord, MAX_AXES, Step};
use crate::motion::{Mode, PathNorm, TcpWords};
use crate::nc::Decimal;
use crate::program::Units;
use crate::program::{Coolant, Rotation};

type Buffer<'b> = Encoder<'b, &'b mut Vec<u8>>;

fn layout() -> Layout {
    Layout {
        axes: vec![('C', 4), ('A', 4), ('Z', 3), ('X', 3)],
        work_offset: "G55".into(),
        path_tolerance: 0.01,
        name: b"Part 7".to_vec(),
        ..Layout::default()
    }
}

fn written_by(
    control: &dyn Control,
    layout: &Layout,
    write: impl Fn(&mut Buffer<'_>) -> io::Result<()>,
) -> Vec<String> {
    let mut out = Vec::new();
    let mut encoder = Encoder::new(control, layout, &mut out);
    write(&mut encoder).expect("memory takes everything");
    encoder.finish().expect("memory takes everything");
    drop(encoder);
    String::from_utf8(out).expect("ASCII").lines().map(str::to_owned).collect()
}

fn steps(control: &dyn Control, layout: &Layout, steps: &[Step<'_>]) -> Vec<String> {
    written_by(control, layout, |encoder| steps.iter().try_for_each(|step| encoder.encode(step)))
}

/// Words of C A Z X.
fn words(units: [i64; 4]) -> AxisWords {
    only(0b1111, units)
}

fn only(mask: u16, units: [i64; 4]) -> AxisWords {
    let mut words = AxisWords { units: [0; MAX_AXES], mask, vector: None };
    words.units[..4].copy_from_slice(&units);
    words
}

fn per_minute(units: i64) -> FeedWord {
    FeedWord::PerMinute(Decimal { units, decimals: 0 })
}

const SPEED: Decimal = Decimal { units: 3000, decimals: 0 };

/// From a restart point into a cut, out and to the next tool.
fn short_program() -> Vec<Step<'static>> {
    let (z, x) = (0b0100, 0b1000);
    vec![
        Step::Restart { number: 1 },
        Step::CoolantOff,
        Step::Machine { words: only(z, [0; 4]) },
        Step::Tool { number: 5, offset: 6, next: Some(7), speed: Some(SPEED), change: true },
        Step::Machine { words: only(z, [0; 4]) },
        Step::Length { offset: 6 },
        Step::Spindle { speed: SPEED, rotation: Rotation::Clockwise },
        Step::Dwell { seconds: 2.0 },
        Step::Rapid { words: only(0b0011, [300_000, 0, 0, 0]) },
        Step::Rapid { words: only(x, [0, 0, 0, 10_000]) },
        Step::Rapid { words: only(z, [0, 0, 50_500, 0]) },
        Step::Coolant { kind: Coolant::On },
        Step::Feed { words: words([300_000, 0, -1_000, 10_000]), feed: per_minute(800) },
        Step::Feed { words: words([310_000, 0, -1_000, 12_000]), feed: per_minute(800) },
        Step::CoolantOff,
        Step::Machine { words: only(z, [0; 4]) },
        Step::Rapid { words: only(z, [0, 0, 50_500, 0]) },
        Step::SpindleOff,
        Step::Stop { optional: true },
    ]
}

fn whole(control: &dyn Control, layout: &Layout) -> Vec<String> {
    written_by(control, layout, |encoder| {
        encoder.open(None)?;
        encoder.comment(b"a (b)")?;
        encoder.encode(&Step::Operation { name: b"Face 1" })?;
        short_program().iter().try_for_each(|step| encoder.encode(step))?;
        encoder.end(&[])
    })
}

fn edges(setup: Options) -> Layout {
    Layout { setup, ..layout() }
}

#[test]
fn every_control_states_what_no_two_of_them_share() {
    for control in CONTROLS {
        let Spellings { name, title, line_length, rotary_note, .. } = control.spellings();
        assert!(!name.is_empty() && !title.is_empty() && *line_length > 0 && !rotary_note.is_empty(), "{name}");
        let others = CONTROLS.iter().filter(|other| other.spellings().name.eq_ignore_ascii_case(name));
        assert_eq!(others.count(), 1, "{name} is the name of one control");
    }
}

#[test]
fn fanuc_writes_points_calls_the_length_with_z_and_cancels_it_with_z() {
    assert_eq!(
        whole(&Fanuc, &layout()),
        [
            "%",
            "O0001 (PART 7)",
            "(A [B])",
            "(OPERATION FACE 1)",
            "N1 G21 G17 G40 G49 G80 G90 G94 G55",
            "M9",
            "G53 G0 Z0.",
            "T5 M6",
            "T7",
            "G49 G53 G0 Z0.",
            "S3000 M3",
            "G4 P2000",
            "G0 A0. C30.",
            "X10.",
            "G43 H6 Z50.5",
            "M8",
            "G1 Z-1. F800.",
            "X12. C31.",
            "M9",
            "G49 G53 G0 Z0.",
            "G0 G43 H6 Z50.5",
            "M5",
            "M1",
            "M30",
            "%",
        ]
    );
}

#[test]
fn a_wait_of_haas_has_its_point_where_lengths_have_none() {
    let control = Options { point: Some(false), ..Options::default() };
    assert!(steps(&Haas, &edges(control), &[Step::Dwell { seconds: 2.0 }]).iter().any(|line| line == "G04 P2."));
}

#[test]
fn haas_writes_two_digits_and_a_dwell_in_seconds() {
    let text = whole(&Haas, &layout());
    assert_eq!(text[1], "O00001 (PART 7)");
    for line in ["T5 M06", "S3000 M03", "G04 P2.", "G43 H6 Z50.5", "G01 Z-1. F800.", "G49 G53 G00 Z0.", "M01", "M30"] {
        assert!(text.iter().any(|found| found == line), "{line}: {text:#?}");
    }
}

#[test]
fn siemens_calls_the_edge_again_behind_machine_coordinates_and_parts_long_names() {
    let setup = Options { axes: BTreeMap::from([('C', "C1".to_owned())]), ..Options::default() };
    assert_eq!(
        whole(&Siemens, &edges(setup)),
        [
            "; a (b)",
            "MSG(\"Face 1\")",
            "N1 TRAFOOF",
            "CYCLE800()",
            "G710 G17 G40 G64 G90 G94 G55",
            "M9",
            "SUPA G0 Z0 D0",
            "T5",
            "M6",
            "T7",
            "SUPA G0 Z0 D0",
            "D6",
            "S3000 M3",
            "G4 F2",
            "G0 A0 C1=30",
            "X10",
            "Z50.5",
            "M8",
            "G1 Z-1 F800",
            "X12 C1=31",
            "M9",
            "SUPA G0 Z0 D0",
            "D6",
            "G0 Z50.5",
            "M5",
            "M1",
            "M30",
        ]
    );
}

#[test]
fn heidenhain_counts_every_line_and_begins_every_motion_with_l() {
    let text = whole(&Heidenhain, &layout());
    let expected = [
        "0 BEGIN PGM PART_7 MM",
        "1 ; a (b)",
        "2 * - Face 1",
        "3 M129",
        "4 PLANE RESET STAY",
        "5 M127",
        "6 CYCL DEF 247 DATUM SETTING ~",
        "  Q339=+2 ;DATUM NUMBER",
        "7 M9",
        "8 L Z+0 R0 FMAX M91",
        "9 TOOL CALL 5 Z S3000",
        "10 TOOL DEF 7",
        "11 L Z+0 R0 FMAX M91",
        "12 M3",
        "13 CYCL DEF 9.0 DWELL TIME",
        "14 CYCL DEF 9.1 DWELL 2",
        "15 L A+0 C+30 R0 FMAX",
        "16 L X+10 R0 FMAX",
        "17 L Z+50.5 R0 FMAX",
        "18 M8",
        "19 L Z-1 R0 F800",
        "20 L X+12 C+31",
        "21 M9",
        "22 L Z+0 R0 FMAX M91",
        "23 L Z+50.5 R0 FMAX",
        "24 M5",
        "25 M1",
        "26 M30",
        "27 END PGM PART_7 MM",
    ];
    assert_eq!(text, expected);
}

#[test]
fn a_speed_that_changes_stands_in_a_tool_call_on_heidenhain_and_is_not_said_twice() {
    let spindle = |units| Step::Spindle { speed: Decimal { units, decimals: 0 }, rotation: Rotation::CounterClockwise };
    assert_eq!(
        steps(&Heidenhain, &layout(), &[spindle(3000), spindle(3000), spindle(4000)]),
        ["0 TOOL CALL S3000", "1 M4", "2 M4", "3 TOOL CALL S4000", "4 M4"]
    );
}

#[test]
fn a_program_in_inches_says_so() {
    let inches = Layout { units: Units::Inches, ..layout() };
    let said = |control: &dyn Control| whole(control, &inches).join(" ");
    assert!(said(&LinuxCnc).contains("N1 G20 "));
    assert!(said(&Siemens).contains("G700 "));
    assert!(said(&Heidenhain).contains("BEGIN PGM PART_7 INCH") && said(&Heidenhain).contains("END PGM PART_7 INCH"));
}

#[test]
fn words_stand_in_the_usual_order_whatever_the_chain_is() {
    let text = steps(&LinuxCnc, &layout(), &[Step::Rapid { words: words([10_000, -5, 1500, -1]) }]);
    assert_eq!(text, ["G0 X-0.001 Z1.5 A-0.0005 C1"]);
}

#[test]
fn a_block_in_which_nothing_changes_is_not_written() {
    let feed = FeedWord::InverseTime(Decimal { units: 5, decimals: 0 });
    for control in CONTROLS {
        let same = words([1, 2, 3, 4]);
        let blocks = [Step::Rapid { words: same }, Step::Feed { words: same, feed }, Step::Rapid { words: same }];
        assert_eq!(steps(*control, &layout(), &blocks).len(), 1);
    }
}

#[test]
fn everything_is_written_again_behind_a_restart_a_stop_and_a_foreign_block() {
    let feed = Step::Feed { words: words([0; 4]), feed: per_minute(100) };
    for between in [Step::Stop { optional: false }, Step::Raw { text: b"M64" }, Step::Restart { number: 7 }] {
        for control in CONTROLS {
            let text = steps(*control, &layout(), &[feed, between, feed]);
            let (first, last) = (&text[0], &text[text.len() - 1]);
            for word in first.split(' ').filter(|word| word.starts_with(['X', 'Z', 'A', 'C', 'F', 'R'])) {
                assert!(last.contains(word), "{word} behind {between:?}: {text:#?}");
            }
        }
    }
    assert_eq!(
        steps(&LinuxCnc, &layout(), &[feed, Step::Restart { number: 7 }, feed]),
        ["G94 G1 X0 Z0 A0 C0 F100", "N7 G21 G17 G40 G49 G80 G90 G94 G55 G64 P0.01", "G1 X0 Z0 A0 C0 F100"]
    );
}

#[test]
fn a_long_comment_stands_on_lines_that_the_control_reads() {
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
fn a_comment_never_goes_on_in_the_next_line_and_never_ends_early() {
    for control in CONTROLS {
        let mut line = Vec::new();
        control.comment(b"A) M3 % \n\" ~", &mut line);
        let [before, behind] = control.spellings().comment.marks;
        let line = String::from_utf8(line).expect("ASCII");
        let inside = line.strip_prefix(before).and_then(|text| text.strip_suffix(behind)).expect("the marks");
        assert!(behind.is_empty() || !inside.contains([')', '(', '%']), "{line}");
        assert!(!inside.contains('\n'));
        assert!(control.spellings().name != "heidenhain" || !inside.contains('~'));
    }
    let text = steps(&Siemens, &layout(), &[Step::Operation { name: b"a\") M3" }]);
    assert_eq!(text, ["MSG(\"a') M3\")"]);
}

#[test]
fn coolant_goes_off_by_the_code_of_its_kind() {
    let through = Step::Coolant { kind: Coolant::Through };
    let blocks = [Step::CoolantOff, through, Step::CoolantOff, Step::CoolantOff];
    assert_eq!(steps(&Haas, &layout(), &blocks), ["M09", "M88", "M89", "M09"]);
    let mut setup = Options::default();
    setup.coolant[2] = Some(["M51".to_owned(), "M59".to_owned()]);
    assert_eq!(steps(&LinuxCnc, &edges(setup), &blocks), ["M9", "M51", "M59", "M9"]);
}

#[test]
fn smoothing_is_on_in_cuts_and_off_before_machine_coordinates() {
    let setup = |smoothing| Options { smoothing, smoothing_angle: Some(0.1_f64.to_radians()), ..Options::default() };
    let text = |control: &dyn Control, smoothing| whole(control, &edges(setup(smoothing))).join("\n");
    assert!(text(&Fanuc, Smoothing::Finish).contains("G05.1 Q1\nG1 Z-1. F800.\nX12. C31.\nM9\nG05.1 Q0\nG49 G53"));
    assert!(text(&Siemens, Smoothing::Rough).contains("CYCLE832(0.01,3)\nG1 Z-1 F800"));
    assert!(text(&Haas, Smoothing::Medium).contains("G187 P2 E0.01\nG01"));
    assert!(text(&Heidenhain, Smoothing::Finish).contains("20 CYCL DEF 32.1 T0.01\n21 CYCL DEF 32.2 HSC-MODE:0 TA0.1"));
    assert!(!text(&Fanuc, Smoothing::None).contains("G05.1"));
}

#[test]
fn blocks_of_the_configuration_replace_those_of_the_table() {
    let setup = Options {
        tool_change: Some(vec!["M101".into(), "T{tool} M6 (H{offset} S{speed})".into(), "T{next}".into()]),
        safety: Some(vec!["{units} G90".into(), "{work_offset}".into()]),
        program_number: Some(42),
        program_name: Some("x-1".into()),
        ..Options::default()
    };
    let program =
        ProgramBlocks { start: vec!["(P{number} {name})".into()], end: vec!["M99".into()], ..ProgramBlocks::default() };
    let layout = Layout { program, ..edges(setup) };
    let text = written_by(&Fanuc, &layout, |encoder| {
        encoder.open(None)?;
        encoder.start()?;
        short_program()[..4].iter().try_for_each(|step| encoder.encode(step))?;
        encoder.end(&[])
    });
    assert_eq!(
        text,
        [
            "%",
            "O0042 (X-1)",
            "(P0042 X-1)",
            "N1 G21 G90",
            "G55",
            "M9",
            "G49 G53 G0 Z0.",
            "M101",
            "T5 M6 (H6 S3000)",
            "T7",
            "M99",
            "M30",
            "%"
        ]
    );
}

#[test]
fn every_table_holds_fields_that_exist() {
    let all = [template::OF_TOOL, &[Field::Seconds, Field::Milliseconds, Field::Angle, Field::Turning]].concat();
    for control in CONTROLS {
        let codes = control.spellings();
        let blocks = [codes.opening, codes.closing, codes.safety, codes.tool_change, codes.dwell, codes.smoothing_off];
        let single = [codes.length.code, codes.speed.unwrap_or_default(), codes.spindle[0], codes.spindle[1]];
        for block in blocks.into_iter().chain(codes.smoothing).flatten().copied().chain(single) {
            assert_eq!(template::check(block, &all), Ok(()), "{} {block}", codes.name);
        }
        if let Some(Cycles { form: CycleForm::Definitions(cycle), .. }) = &codes.cycles {
            let blocks = [cycle.drill, cycle.peck, cycle.chip_break, cycle.ream, cycle.thread];
            let plain = cycle.plain_drill.into_iter().flatten();
            for block in blocks.into_iter().flatten().chain(plain) {
                assert_eq!(template::check(block, template::OF_CYCLE), Ok(()), "{} {block}", codes.name);
            }
        }
        let number = if codes.counted { 8 } else { 0 };
        assert!(codes.comment.length + codes.comment.marks.concat().len() + number <= codes.line_length);
        assert!(control.work_offset("G54").is_some(), "the default");
    }
}

#[test]
fn a_control_is_found_by_its_name_and_only_by_that() {
    assert_eq!(by_name("linuxcnc").map(|control| control.spellings().title), Some("LinuxCNC"));
    for control in CONTROLS {
        let name = control.spellings().name;
        assert_eq!(by_name(&name.to_uppercase()).map(|found| found.spellings().name), Some(name));
    }
    assert!(by_name("linux").is_none());
    assert!(by_name("").is_none());
}

#[test]
fn what_a_control_does_not_have_is_told_before_anything_is_posted() {
    let faults = |control: &dyn Control, change: fn(&mut Config)| {
        let mut config = starting_point(control);
        change(&mut config);
        unfit(&Sample::default(), control, config.demands())
    };
    for control in CONTROLS {
        assert_eq!(faults(*control, |_| {}), Vec::<String>::new());
        assert_eq!(faults(*control, |config| config.set_up.work_offset = "G53".into()).len(), 1);
        assert_eq!(faults(*control, |config| config.set_up.frames = BTreeMap::from([(2, "G999".to_owned())])).len(), 1);
        assert_eq!(faults(*control, |config| config.control.axes = BTreeMap::from([('C', "c?".to_owned())])).len(), 1);
        assert_eq!(faults(*control, |config| config.control.program.start = vec!["M".repeat(600)]).len(), 1);
    }
    let long_name: fn(&mut Config) = |config| config.control.axes = BTreeMap::from([('C', "C1".to_owned())]);
    assert_eq!(faults(&Fanuc, long_name).len(), 1);
    assert_eq!(faults(&Siemens, long_name).len(), 0);
    let number: fn(&mut Config) = |config| config.control.program_number = Some(12_345);
    assert_eq!([&Fanuc as &dyn Control, &Haas, &Siemens].map(|control| faults(control, number).len()), [1, 0, 1]);
    let inverse: fn(&mut Config) = |config| config.control.path_norm = Some(PathNorm::G93Minutes);
    assert_eq!(faults(&Heidenhain, inverse).len(), 1);
    assert_eq!(faults(&Heidenhain, |config| config.control.program.line_numbers = Some(10)).len(), 1);
    assert_eq!(faults(&LinuxCnc, |config| config.control.smoothing = Smoothing::Rough).len(), 1);
    let gauge: fn(&mut Config) = |config| config.set_up.length_mode = crate::set_up::LengthMode::Gauge;
    let length = "Heidenhain TNC takes the length with every tool call: leave `length_mode` at \"tip\"";
    assert_eq!(faults(&Heidenhain, gauge), [length]);
    assert_eq!(faults(&Fanuc, gauge), Vec::<String>::new());
}

#[test]
fn work_offsets_are_those_that_the_control_has() {
    let spelled = |control: &dyn Control, word: &str| control.work_offset(word).unwrap_or_default();
    assert_eq!(spelled(&LinuxCnc, "G59.3"), "G59.3");
    assert_eq!(["G54.1 P300", "G54.1 P301", "G59.1"].map(|word| spelled(&Fanuc, word)), ["G54.1 P300", "", ""]);
    assert_eq!(["G154 P99", "G154 P0", "G54.1 P1"].map(|word| spelled(&Haas, word)), ["G154 P99", "", ""]);
    assert_eq!(["G505", "G58", "G0505"].map(|word| spelled(&Siemens, word)), ["G505", "", ""]);
    assert_eq!(["G59", "12", "012"].map(|word| spelled(&Heidenhain, word)), ["6", "12", ""]);
}

#[test]
fn a_length_that_differs_stops_the_program_on_every_control() {
    let guard =
        LengthGuard { label: 3, tool: 12, offset: 1, length: 114.3, tolerance: 0.01, units: Units::Millimetres };
    let haas = "IF [ABS[#2001 + #2201 - 114.3] GT 0.01] THEN #3000= 101 (T12 IS NOT 114.3 LONG)";
    assert_eq!(Haas.length_guard(&guard), [haas]);
    assert!(Haas.length_guard(&LengthGuard { offset: 201, ..guard }).is_empty());
    let inches = Siemens.length_guard(&LengthGuard { units: Units::Inches, ..guard });
    let message = "MSG(\"T12 was posted with L = 4.5: the tool data say something else\")";
    assert_eq!(inches, ["IF ABS($P_TOOLL[1]-4.5)>0.00039", message, "M0", "M30", "ENDIF"]);
    let heidenhain = [
        "FN 18: SYSREAD QL1 = ID50 NR1 IDX12",
        "FN 18: SYSREAD QL2 = ID50 NR4 IDX12",
        "FN 1: QL1 = +QL1 + +QL2",
        "FN 12: IF +QL1 LT +114.29 GOTO LBL \"OFF3\"",
        "FN 12: IF +QL1 LT +114.31 GOTO LBL \"FITS3\"",
        "LBL \"OFF3\"",
        "; T12 was posted with L = 114.3 mm: the tool table says something else",
        "FN 14: ERROR = 100",
        "LBL \"FITS3\"",
    ];
    for units in [Units::Millimetres, Units::Inches] {
        assert_eq!(Heidenhain.length_guard(&LengthGuard { units, ..guard }), heidenhain);
    }
    for control in CONTROLS {
        let own = LengthGuard { offset: 12, length: 123.4567, units: Units::Inches, ..guard };
        let blocks = control.length_guard(&own);
        assert!(!blocks.is_empty() && blocks.iter().all(|block| block.len() <= control.spellings().line_length));
    }
}

#[test]
fn a_wait_that_is_too_long_for_the_control_is_written_as_several() {
    let waits = |seconds| steps(&Heidenhain, &layout(), &[Step::Dwell { seconds }]);
    let lengths = |seconds| -> Vec<String> {
        waits(seconds).iter().filter_map(|line| Some(line.split_once("9.1 DWELL ")?.1.to_owned())).collect()
    };
    assert_eq!(lengths(3600.0), ["3600"]);
    assert_eq!(lengths(3600.0004), ["3600"]);
    assert_eq!(lengths(8000.25), ["3600", "3600", "800.25"]);
    assert_eq!(steps(&Fanuc, &layout(), &[Step::Dwell { seconds: 99_999.0 }]), ["G4 P99999000"]);
}

/// The centre of an arc, and whether it is clockwise.
type Round = (BTreeMap<String, i64>, bool);

/// What a motion block does: rapid, machine coordinates, where every axis stands, the F of a feed block, and its circle.
type Motion = (bool, bool, BTreeMap<String, f64>, Option<(bool, f64)>, Option<Round>);

fn number(word: &str, behind: usize) -> f64 {
    word[behind..].parse().expect("a number")
}

/// Turns X and Y about a pole, degrees; to a thousandth.
fn turn_about(pole: &BTreeMap<String, i64>, degrees: f64, at: &mut BTreeMap<String, f64>) {
    let [x, y] = ["X", "Y"].map(|axis| at[axis] - pole[axis] as f64 * 1e-3);
    let (sine, cosine) = degrees.to_radians().sin_cos();
    for (axis, value) in [("X", x * cosine - y * sine), ("Y", x * sine + y * cosine)] {
        at.insert(axis.to_owned(), (value * 1e3 + pole[axis] as f64).round() * 1e-3);
    }
}

/// Reads the motions of a program back, for every control: words stay in force until they change.
fn motions(lines: &[String]) -> Vec<Motion> {
    let (mut at, mut feed, mut rapid, mut inverse) = (BTreeMap::<String, f64>::new(), None, false, false);
    let (mut clockwise, mut pole) = (None, BTreeMap::<String, i64>::new());
    let mut read = Vec::new();
    for line in lines {
        let mut line = line.as_str();
        if let Some((number, rest)) = line.split_once(' ')
            && number.trim_start_matches('N').parse::<u32>().is_ok()
        {
            line = rest;
        }
        if line.starts_with(['(', ';', '%', 'O', '*', 'M', ' ']) || line.contains("CYCL") || line.contains("TOOL") {
            continue;
        }
        if let Some(words) = line.strip_prefix("CC ") {
            let word =
                |word: &str| (word[..1].to_owned(), (word[1..].parse::<f64>().expect("a number") * 1e3).round() as i64);
            pole = words.split(' ').map(word).collect();
            continue;
        }
        let (mut machine, mut fast, mut moves) = (false, None, false);
        let (mut centre, before) = (BTreeMap::new(), at.clone());
        let mut word_feed = None;
        for word in line.split(' ') {
            match word {
                "G53" | "SUPA" | "M91" => machine = true,
                "G0" | "G00" => (rapid, clockwise) = (true, None),
                "G1" | "G01" => (rapid, clockwise) = (false, None),
                "G2" | "G02" => (rapid, clockwise) = (false, Some(true)),
                "G3" | "G03" => (rapid, clockwise) = (false, Some(false)),
                "FMAX" => fast = Some(true),
                "L" => (fast, clockwise) = (fast.or(Some(false)), None),
                "C" | "CP" => (fast, centre) = (Some(false), pole.clone()),
                _ if word.starts_with("IZ") => *at.get_mut("Z").expect("a height") += number(word, 2),
                _ if word.starts_with("IPA") => {
                    moves = true;
                    turn_about(&pole, number(word, 3), &mut at);
                }
                "DR+" => clockwise = Some(false),
                "DR-" => clockwise = Some(true),
                "G93" => inverse = true,
                "G94" => inverse = false,
                _ => {
                    let (name, number) = match word.split_once('=') {
                        Some((name, number)) => (name, number),
                        None => word.split_at(1),
                    };
                    let Ok(number) = number.parse::<f64>() else { continue };
                    match name.as_bytes()[0] {
                        b'X'..=b'Z' | b'A' | b'C' => {
                            moves = true;
                            at.insert(name.to_owned(), number);
                        }
                        b'F' => word_feed = Some(number),
                        letter @ b'I'..=b'K' if clockwise.is_some() => {
                            let axis = ["X", "Y", "Z"][usize::from(letter - b'I')];
                            let from = before.get(axis).copied().unwrap_or(f64::NAN);
                            centre.insert(axis.to_owned(), ((from + number) * 1e3).round() as i64);
                        }
                        _ => {}
                    }
                }
            }
        }
        rapid = fast.unwrap_or(rapid);
        feed = word_feed.or(feed);
        if moves {
            let feed = if rapid || machine { None } else { feed.map(|feed| (inverse, feed)) };
            let round = clockwise.filter(|_| !rapid && !machine).map(|clockwise| (centre, clockwise));
            read.push((rapid, machine, at.clone(), feed, round));
        }
    }
    read
}

fn any_step() -> impl Strategy<Value = Step<'static>> {
    let few = || prop::array::uniform4(-2_i64..3);
    prop_oneof![
        6 => (few(), 1_i64..3).prop_map(|(to, feed)| Step::Feed { words: words(to), feed: per_minute(feed) }),
        3 => (few(), 1_i64..3).prop_map(|(to, feed)| Step::Feed {
            words: words(to),
            feed: FeedWord::InverseTime(Decimal { units: feed, decimals: 1 }),
        }),
        4 => (few(), 1_u16..16).prop_map(|(to, mask)| Step::Rapid { words: only(mask, to) }),
        1 => few().prop_map(|to| Step::Machine { words: only(0b0100, to) }),
        1 => Just(Step::Restart { number: 3 }),
        1 => Just(Step::PerMinute),
        1 => Just(Step::Tool { number: 2, offset: 2, next: None, speed: None, change: true }),
        1 => Just(Step::Length { offset: 2 }),
        1 => Just(Step::Stop { optional: false }),
        1 => Just(Step::CoolantOff),
    ]
}

proptest! {
    /// Suppressing what stays in force changes no motion: with every word in every block the control does the same.
    #[test]
    fn every_word_in_every_block_is_the_same_motion(blocks in prop::collection::vec(any_step(), 1..40)) {
        for control in CONTROLS {
            // Where the control has no inverse time the planner asks for none.
            let no_inverse = control.spellings().inverse_time.is_none();
            let blocks: Vec<Step<'_>> = blocks.iter().filter(|step| {
                !(no_inverse && matches!(step, Step::PerMinute | Step::Feed { feed: FeedWord::InverseTime(_), .. }))
            }).copied().collect();
            let modal = steps(*control, &layout(), &blocks);
            let every_word = Options { every_word: true, ..Options::default() };
            let full = steps(*control, &edges(every_word), &blocks);
            prop_assert_eq!(motions(&modal), motions(&full), "{:#?}\n{:#?}", modal, full);
            prop_assert!(modal.iter().map(String::len).sum::<usize>() <= full.iter().map(String::len).sum::<usize>());
        }
    }

    /// All controls move the machine alike.
    #[test]
    fn every_control_says_the_same_motions(blocks in prop::collection::vec(any_step(), 1..40)) {
        let blocks: Vec<Step<'_>> = blocks.into_iter().filter(|step| {
            !matches!(step, Step::Length { .. } | Step::PerMinute | Step::Feed { feed: FeedWord::InverseTime(_), .. })
        }).collect();
        let said = CONTROLS.iter().map(|control| motions(&steps(*control, &layout(), &blocks)));
        let said: Vec<Vec<Motion>> = said.collect();
        for other in &said[1..] {
            prop_assert_eq!(&said[0], other);
        }
    }
}

#[test]
fn f_is_written_again_where_tip_control_or_a_plane_has_begun() {
    let angles = [Decimal { units: 30, decimals: 0 }; 3];
    let plane = Step::Plane { angles, pose: Some(true) };
    let cut = |x| Step::Feed { words: only(0b1100, [0, 0, 0, x]), feed: per_minute(800) };
    for (mode, on, off) in [
        (Mode::Tcp, Step::TipControl { on: true }, Step::TipControl { on: false }),
        (Mode::Plane, plane, Step::PlaneOff),
    ] {
        let blocks =
            [Step::Restart { number: 1 }, Step::Length { offset: 6 }, on, cut(1), cut(2), off, on, cut(3), cut(4)];
        for control in CONTROLS.iter().filter(|control| control.spellings().tip.is_some()) {
            let lines = steps(*control, &Layout { mode, ..layout() }, &blocks);
            let with_f = lines.iter().filter(|line| line.contains("F800")).count();
            assert_eq!(with_f, 2, "{lines:#?}");
        }
    }
}

/// X Y Z, millimetres.
fn milling() -> Layout {
    Layout { axes: vec![('X', 3), ('Y', 3), ('Z', 3)], ..layout() }
}

/// Where the axes stand, whole units.
type Place = [i64; 3];

fn linear(to: Place) -> AxisWords {
    let mut words = AxisWords { mask: 0b111, ..AxisWords::default() };
    words.units[..3].copy_from_slice(&to);
    words
}

/// A circle of a plane from one place to another about a centre, its sweep as the places say.
fn round(plane: ArcPlane, from: Place, to: Place, centre: [i64; 2], clockwise: bool) -> Circle {
    let [first, second, square] = plane.axes();
    let (start, end) = ([from[first], from[second]], [to[first], to[second]]);
    let angle = |point: [i64; 2]| ((point[1] - centre[1]) as f64).atan2((point[0] - centre[0]) as f64);
    let turn = (angle(end) - angle(start)) * if clockwise { -1.0 } else { 1.0 };
    let turn = turn.rem_euclid(std::f64::consts::TAU);
    let sweep = if turn > 0.0 { turn } else { std::f64::consts::TAU };
    Circle { plane, chain: [0, 1, 2], clockwise, start, centre, radius: None, sweep, rise: to[square] - from[square] }
}

const FEED: Decimal = Decimal { units: 500, decimals: 0 };

/// A quarter, a whole turn, a helix and an arc in the plane of Z and X, from X10 Y0 Z0 about the origin.
fn some_arcs(control: &dyn Control, setup: Options, radius: Option<i64>) -> Vec<String> {
    let quarter = Circle { radius, ..round(ArcPlane::Xy, [10_000, 0, 0], [0, 10_000, 0], [0, 0], false) };
    let whole = round(ArcPlane::Xy, [0, 10_000, 0], [0, 10_000, 0], [0, 0], true);
    let helix = round(ArcPlane::Xy, [0, 10_000, 0], [10_000, 0, -2_500], [0, 0], true);
    let upright = round(ArcPlane::Zx, [10_000, 0, -2_500], [0, 0, 7_500], [-2_500, 0], false);
    let mut blocks = vec![
        Step::Restart { number: 1 },
        Step::Feed { words: linear([10_000, 0, 0]), feed: per_minute(500) },
        Step::Arc { words: linear([0, 10_000, 0]), circle: &quarter, feed: FEED },
        Step::Arc { words: linear([0, 10_000, 0]), circle: &whole, feed: FEED },
        Step::Arc { words: linear([10_000, 0, -2_500]), circle: &helix, feed: FEED },
    ];
    if control.spellings().arcs.planes[1].is_some() {
        blocks.push(Step::Arc { words: linear([0, 0, 7_500]), circle: &upright, feed: FEED });
        blocks.push(Step::Machine { words: only(0b100, [0; 4]) });
    }
    let blocks = steps(control, &Layout { setup, ..milling() }, &blocks);
    let first = blocks.iter().position(|line| line.contains("X10") || line.contains("X+10")).expect("the first motion");
    blocks[first..].to_vec()
}

#[test]
fn arcs_hold_the_words_of_their_plane_and_the_way_to_the_centre() {
    let arcs = |control| some_arcs(control, Options::default(), None);
    let expected = [
        "G1 X10 Y0 Z0 F500",
        "G3 X0 Y10 I-10 J0",
        "G2 X0 Y10 I0 J-10",
        "X10 Y0 Z-2.5 I0 J-10",
        "G18 G3 X0 Z7.5 I-10 K0",
        "G17",
        "G53 G0 Z0",
    ];
    assert_eq!(arcs(&LinuxCnc), expected);
    assert_eq!(arcs(&Siemens), expected[..4]);
    assert_eq!(
        arcs(&Fanuc)[1..5],
        ["G3 X0. Y10. I-10. J0.", "G2 X0. Y10. I0. J-10.", "X10. Y0. Z-2.5 I0. J-10.", "G18 G3 X0. Z7.5 I-10. K0."]
    );
    assert_eq!(arcs(&Haas)[1], "G03 X0. Y10. I-10. J0.");
}

#[test]
fn heidenhain_states_the_pole_and_counts_the_angle_of_a_helix() {
    assert_eq!(
        some_arcs(&Heidenhain, Options::default(), None),
        [
            "4 L X+10 Y+0 Z+0 R0 F500",
            "5 CC X+0 Y+0",
            "6 C X+0 Y+10 DR+",
            "7 CC X+0 Y+0",
            "8 C X+0 Y+10 DR-",
            "9 CC X+0 Y+0",
            "10 CP IPA-90 IZ-2.5 DR-",
        ]
    );
}

/// On Siemens another plane would give the length of the tool to another axis. In the words of G43.5 I J K are the tool axis.
#[test]
fn no_arc_is_said_where_its_plane_or_its_centre_means_something_else() {
    let planes = |control: &dyn Control, mode, tcp_words| {
        let mut config = starting_point(control);
        config.motion.mode = mode;
        config.motion.tip.tcp_words = tcp_words;
        abilities(control, config.demands()).arc_planes
    };
    let (all, only) = ([true; 3], [false, false, true]);
    assert_eq!(planes(&Siemens, Mode::Axes, TcpWords::Angles), only);
    assert_eq!(planes(&Siemens, Mode::Tcp, TcpWords::Vectors), only);
    assert_eq!(planes(&Fanuc, Mode::Tcp, TcpWords::Angles), all);
    assert_eq!(planes(&Fanuc, Mode::Axes, TcpWords::Vectors), all);
    assert_eq!(planes(&Fanuc, Mode::Tcp, TcpWords::Vectors), [false; 3]);
    assert_eq!(planes(&Heidenhain, Mode::Tcp, TcpWords::Vectors), only);
}

/// A helix ends at an angle: where X and Y stand behind it is right but for rounding. To `C` the end of a whole turn would be
/// a point next to the start, or the start.
#[test]
fn behind_a_helix_heidenhain_counts_the_angle_of_a_whole_turn() {
    let helix = round(ArcPlane::Xy, [10_000, 0, 0], [0, 10_000, -2_500], [0, 0], false);
    let whole = round(ArcPlane::Xy, [0, 10_000, -2_500], [0, 10_000, -2_500], [0, 0], true);
    let half = round(ArcPlane::Xy, [0, 10_000, -2_500], [0, -10_000, -2_500], [0, 0], true);
    let again = round(ArcPlane::Xy, [0, -10_000, -2_500], [0, -10_000, -2_500], [0, 0], true);
    let blocks = [
        Step::Restart { number: 1 },
        Step::Feed { words: linear([10_000, 0, 0]), feed: per_minute(500) },
        Step::Arc { words: linear([0, 10_000, -2_500]), circle: &helix, feed: FEED },
        Step::Arc { words: linear([0, 10_000, -2_500]), circle: &whole, feed: FEED },
        Step::Arc { words: linear([0, -10_000, -2_500]), circle: &half, feed: FEED },
        Step::Arc { words: linear([0, -10_000, -2_500]), circle: &again, feed: FEED },
    ];
    let lines = steps(&Heidenhain, &milling(), &blocks);
    let arcs: Vec<&str> = lines.iter().filter(|line| line.contains("DR")).map(|line| &line[2..]).collect();
    let arcs: Vec<&str> = arcs.iter().map(|line| line.trim_start()).collect();
    assert_eq!(arcs, ["CP IPA+90 IZ-2.5 DR+", "CP IPA-360 DR-", "C X+0 Y-10 DR-", "C X+0 Y-10 DR-"]);
}

#[test]
fn a_radius_takes_the_place_of_the_centre() {
    let quarter = |control, radius| some_arcs(control, Options::default(), Some(radius))[1].clone();
    assert_eq!(quarter(&Fanuc, 10_000), "G3 X0. Y10. R10.");
    assert_eq!(quarter(&Siemens, -10_000), "G3 X0 Y10 CR=-10");
    assert_eq!(quarter(&Heidenhain, 10_000), "5 CR X+0 Y+10 R+10 DR+");
}

/// Where to; centre and sense of an arc; a number that says what else.
type Leg = (Place, Option<([i64; 2], bool)>, u8);

/// Motions of a program that begins at the origin: arcs with whole turns among them.
fn any_path() -> impl Strategy<Value = Vec<Leg>> {
    let place = prop::array::uniform3(-3_i64..4).prop_map(|place| place.map(|value| value * 1000));
    let centre = prop::option::weighted(0.6, (prop::array::uniform2(-4_i64..5), any::<bool>()));
    let centre = centre.prop_map(|arc| arc.map(|(at, clockwise)| (at.map(|value| value * 1000 + 500), clockwise)));
    prop::collection::vec((place, centre, 0_u8..8), 1..30)
}

proptest! {
    /// Arcs are the same with every word and without, and on every control.
    #[test]
    fn arcs_are_the_same_on_every_control(path in any_path()) {
        let (mut here, mut circles) = ([0; 3], Vec::new());
        for (to, arc, _) in &path {
            circles.push(arc.map(|(centre, clockwise)| {
                // Both ends as far from the centre: what the words say is then the same for all.
                let [x, y] = [2 * centre[0] - here[0], 2 * centre[1] - here[1]];
                let end = if to[0] == here[0] { [here[0], here[1], to[2]] } else { [x, y, to[2]] };
                (end, round(ArcPlane::Xy, here, end, centre, clockwise))
            }));
            here = circles.last().and_then(|circle| circle.map(|(end, _)| end)).unwrap_or(*to);
        }
        let mut blocks = vec![Step::Restart { number: 1 }, Step::Rapid { words: linear([0; 3]) }];
        for ((to, _, kind), circle) in path.iter().zip(&circles) {
            let at = circle.map_or(*to, |(end, _)| end);
            match circle {
                Some((end, circle)) => blocks.push(Step::Arc { words: linear(*end), circle, feed: FEED }),
                None => {
                    let words = linear(*to);
                    blocks.push(if kind % 2 == 0 { Step::Rapid { words } } else { Step::Feed { words, feed: per_minute(500) } });
                }
            }
            if *kind == 7 {
                blocks.extend([Step::Restart { number: 2 }, Step::Rapid { words: linear(at) }]);
            }
        }
        let said: Vec<_> = CONTROLS.iter().map(|control| {
            let modal = motions(&steps(*control, &milling(), &blocks));
            let every_word = Options { every_word: true, ..Options::default() };
            let full = motions(&steps(*control, &Layout { setup: every_word, ..milling() }, &blocks));
            // Behind a helix Heidenhain writes where it ends once more.
            let moving = |mut motions: Vec<Motion>| {
                motions.dedup_by(|next, before| next.4.is_none() && next.2 == before.2);
                motions
            };
            (moving(modal), moving(full))
        }).collect();
        for (index, (modal, full)) in said.iter().enumerate() {
            prop_assert_eq!(modal, full, "{}", CONTROLS[index].spellings().name);
            prop_assert_eq!(modal, &said[0].0, "{}", CONTROLS[index].spellings().name);
        }
    }
}
