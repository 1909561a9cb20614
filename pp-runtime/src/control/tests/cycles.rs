//! Hole cycles: words of the cycles of each control, and holes read back from programs.
//!
//! The readers take the arguments of `CYCLE81` and the Q parameters of `CYCL DEF` from the manuals, not from the
//! templates.

use proptest::prelude::*;

use super::*;
use crate::motion::{CannedCycle, CannedKind};

/// A hole at X10 Y20: surface at Z1, feed from Z3 down to Z-9.
fn cycle(kind: CannedKind) -> CannedCycle {
    CannedCycle {
        kind,
        words: AxisWords { mask: 0b011, ..linear([10_000, 20_000, 0]) },
        z: 2,
        surface: 1_000,
        clearance: 3_000,
        bottom: -9_000,
        back: 8_000,
        dwell: None,
        feed: FEED,
    }
}

const PECK: CannedKind = CannedKind::Peck { step: 2_500, gap: 500 };
const CHIPS: CannedKind = CannedKind::ChipBreak { step: 2_500, gap: 200 };

fn thread(left: bool) -> CannedKind {
    let number = |units, decimals| Decimal { units, decimals };
    CannedKind::Tap { pitch: number(12_500, 4), left, speed: number(400, 0) }
}

fn cycles(control: &dyn Control, holes: &[CannedCycle]) -> Vec<String> {
    let blocks: Vec<Step<'_>> = holes.iter().map(|cycle| Step::Cycle { cycle }).collect();
    steps(control, &milling(), &blocks)
}

#[test]
fn siemens_cycles_hold_levels_steps_and_pitch_in_their_order() {
    let definition =
        |cycle: CannedCycle| cycles(&Siemens, &[cycle]).into_iter().find(|line| line.starts_with("MCALL "));
    let waits = |kind| CannedCycle { dwell: Some(0.25), ..cycle(kind) };
    let call = |cycle| definition(cycle).expect("a call");
    assert_eq!(call(cycle(CannedKind::Drill)), "MCALL CYCLE81(8,1,2,-9)");
    assert_eq!(call(waits(CannedKind::Drill)), "MCALL CYCLE82(8,1,2,-9,,0.25)");
    assert_eq!(call(cycle(PECK)), "MCALL CYCLE83(8,1,2,-9,,,2.5,0,0,0,1,1,,,,0,0.5)");
    assert_eq!(call(waits(CHIPS)), "MCALL CYCLE83(8,1,2,-9,,,2.5,0,0,0,1,0,,,0.2,0.25)");
    assert_eq!(call(waits(CannedKind::Ream)), "MCALL CYCLE85(8,1,2,-9,,0.25,500,500)");
    assert_eq!(call(cycle(thread(false))), "MCALL CYCLE84(8,1,2,-9,,0,3,,1.25,0,400,400,,1)");
    assert_eq!(call(cycle(thread(true))), "MCALL CYCLE84(8,1,2,-9,,0,4,,-1.25,0,400,400,,1)");
    let inches = Layout { units: Units::Inches, ..milling() };
    let block = steps(&Siemens, &inches, &[Step::Cycle { cycle: &cycle(thread(false)) }])[1].clone();
    assert!(block.ends_with(",,3)"), "{block}");
}

#[test]
fn siemens_calls_the_cycle_at_each_position_until_it_is_cancelled() {
    let first = cycle(CannedKind::Drill);
    let second = CannedCycle { words: AxisWords { mask: 0b011, ..linear([15_000, 20_000, 0]) }, ..first };
    let higher = CannedCycle { surface: 2_000, clearance: 4_000, bottom: -8_000, ..second };
    let text = cycles(&Siemens, &[first, second, second, higher]);
    let expected = [
        "G94",
        "F500",
        "MCALL CYCLE81(8,1,2,-9)",
        "G0 X10 Y20",
        "X15",
        "X15 Y20",
        "MCALL",
        "F500",
        "MCALL CYCLE81(8,2,2,-8)",
        "G0 X15 Y20",
    ];
    assert_eq!(text, expected);
    let (rapid, feed) = (Step::Rapid { words: linear([15_000, 20_000, 8_000]) }, per_minute(500));
    let down = Step::Feed { words: linear([15_000, 20_000, 0]), feed };
    let text = steps(&Siemens, &milling(), &[Step::PerMinute, Step::Cycle { cycle: &first }, rapid, down]);
    assert_eq!(text[4..], ["MCALL", "G0 X15 Z8", "G1 Z0 F500"]);
}

#[test]
fn heidenhain_keeps_a_definition_until_it_changes_or_may_have_changed() {
    let first = cycle(CannedKind::Drill);
    let definition = [
        "CYCL DEF 200 DRILLING ~",
        "  Q200=+2 ;SET-UP CLEARANCE ~",
        "  Q201=-10 ;DEPTH ~",
        "  Q206=+500 ;FEED RATE FOR PLNGNG ~",
        "  Q202=+10 ;PLUNGING DEPTH ~",
        "  Q210=+0 ;DWELL TIME AT TOP ~",
        "  Q203=+1 ;SURFACE COORDINATE ~",
        "  Q204=+7 ;2ND SET-UP CLEARANCE ~",
        "  Q211=+0 ;DWELL TIME AT DEPTH",
    ];
    let call = Step::Cycle { cycle: &first };
    let away = Step::Rapid { words: linear([0, 0, 9_000]) };
    let text = steps(&Heidenhain, &milling(), &[call, away, call]);
    assert_eq!(text[0], format!("0 {}", definition[0]));
    assert_eq!(text[1..9], definition[1..]);
    assert_eq!(text[9..], ["1 L X+10 Y+20 R0 FMAX M99", "2 L X+0 Y+0 Z+9 R0 FMAX", "3 L X+10 Y+20 R0 FMAX M99"]);
    let tool = Step::Tool { number: 2, offset: 2, next: None, speed: None, radius_delta: None, change: true };
    for between in [
        Step::Stop { optional: false },
        Step::Restart { number: 3, changes_tool: false },
        Step::Raw { text: b"M64" },
        tool,
    ] {
        let text = steps(&Heidenhain, &milling(), &[call, between, call]);
        assert_eq!(text.iter().filter(|line| line.contains("CYCL DEF 200")).count(), 2, "{text:#?}");
    }
}

#[test]
fn heidenhain_has_a_cycle_for_each_kind() {
    let definition = |kind| cycles(&Heidenhain, &[cycle(kind)]).join(" ");
    let holds = |text: String, parts: &[&str]| {
        assert!(parts.iter().all(|part| text.contains(part)), "{text}");
    };
    holds(definition(PECK), &["CYCL DEF 205 ", "Q202=+2.5 ", "Q258=+0.5 ", "Q259=+0.5 ", "Q212=+0 ", "Q257=+0 "]);
    holds(definition(CHIPS), &["CYCL DEF 203 ", "Q202=+2.5 ", "Q213=+4 ", "Q256=+0.2", "Q212=+0 ", "Q208=+99999 "]);
    holds(definition(CannedKind::Ream), &["CYCL DEF 201 ", "Q206=+500 ", "Q208=+0 "]);
    holds(definition(thread(false)), &["CYCL DEF 207 ", "Q239=+1.25 "]);
    holds(definition(thread(true)), &["CYCL DEF 207 ", "Q239=-1.25 "]);
}

/// A hole as written in a program.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
struct WrittenHole {
    surface: i64,
    clearance: i64,
    bottom: i64,
    back: i64,
    /// Depth of a step; 0 without pecking.
    step: i64,
    gap: i64,
    /// Full retract after each step.
    out: bool,
    /// Retract at feed.
    ream: bool,
    wait: i64,
    feed: i64,
    /// Pitch in ten-thousandths of a unit, negative for a left-hand thread.
    pitch: i64,
}

fn written(cycle: &CannedCycle) -> WrittenHole {
    let CannedCycle { surface, clearance, bottom, back, .. } = *cycle;
    let (step, gap) = match cycle.kind {
        CannedKind::Peck { step, gap } | CannedKind::ChipBreak { step, gap } => (step, gap),
        _ => (0, 0),
    };
    let (pitch, feed) = match cycle.kind {
        CannedKind::Tap { pitch, left, .. } => (if left { -pitch.units } else { pitch.units }, 0),
        _ => (0, cycle.feed.units),
    };
    let out = matches!(cycle.kind, CannedKind::Peck { .. });
    let wait = (cycle.dwell.unwrap_or(0.0) * 1e3) as i64;
    let ream = cycle.kind == CannedKind::Ream;
    WrittenHole { surface, clearance, bottom, back, step, gap, out, ream, wait, feed, pitch }
}

fn thousandths(number: &str) -> i64 {
    if number.is_empty() { 0 } else { (number.parse::<f64>().expect("a number") * 1e3).round() as i64 }
}

/// Hole of `CYCLE81(RTP,RFP,SDIS,DP,DPR,..)`; `feed`: the F in force.
fn sinumerik(call: &str, feed: i64) -> WrittenHole {
    let (number, arguments) = call.split_once('(').expect("arguments");
    let arguments: Vec<i64> = arguments.trim_end_matches(')').split(',').map(thousandths).collect();
    let at = |place: usize| arguments.get(place).copied().unwrap_or(0);
    let basic = WrittenHole {
        back: at(0),
        surface: at(1),
        clearance: at(1) + at(2),
        bottom: at(3),
        feed,
        ..WrittenHole::default()
    };
    match (number, arguments.len()) {
        ("CYCLE81", 4) => basic,
        ("CYCLE82", 6) => WrittenHole { wait: at(5), ..basic },
        ("CYCLE83", 16 | 17) => {
            let out = at(11) == 1_000;
            assert!(at(7) == 0 && at(10) == 1_000, "neither degression nor another first feed");
            WrittenHole { step: at(6), out, gap: at(if out { 16 } else { 14 }), wait: at(15), ..basic }
        }
        ("CYCLE85", 8) => {
            assert_eq!(at(6), at(7));
            WrittenHole { ream: true, wait: at(5), feed: at(6) / 1_000, ..basic }
        }
        ("CYCLE84", 14) => {
            assert_eq!([at(10), at(11), at(6)], [400_000, 400_000, if at(8) < 0 { 4_000 } else { 3_000 }]);
            WrittenHole { pitch: at(8) * 10, wait: at(5), feed: 0, ..basic }
        }
        _ => panic!("{call}"),
    }
}

/// Hole of a `CYCL DEF` with its Q parameters.
fn conversational(number: &str, q: &BTreeMap<u32, i64>) -> WrittenHole {
    let (surface, feed) = (q[&203], q.get(&206).map_or(0, |feed| feed / 1_000));
    let (clearance, bottom, back) = (surface + q[&200], surface + q[&201], surface + q[&204].max(q[&200]));
    let wait = q.get(&211).copied().unwrap_or(0);
    let basic = WrittenHole { surface, clearance, bottom, back, feed, wait, ..WrittenHole::default() };
    match number {
        "200" => {
            assert!(q[&202] >= -q[&201], "at once");
            basic
        }
        "201" if q[&208] == 0 => WrittenHole { ream: true, ..basic },
        "203" => {
            assert!(q[&212] == 0 && q[&213] / 1_000 * q[&202] >= -q[&201], "never out of the hole");
            WrittenHole { step: q[&202], gap: q[&256], ..basic }
        }
        "205" => {
            assert!(q[&212] == 0 && q[&257] == 0 && q[&258] == q[&259] && q[&379] == 0);
            WrittenHole { step: q[&202], gap: q[&258], out: true, ..basic }
        }
        "207" => WrittenHole { pitch: q[&239] * 10, ..basic },
        _ => panic!("{number}"),
    }
}

/// Holes of a program, each with its position.
fn read(lines: &[String]) -> Vec<(WrittenHole, [i64; 2])> {
    let (mut holes, mut at, mut feed) = (Vec::new(), [i64::MIN; 2], 0);
    let (mut modal, mut number, mut q) = (None, String::new(), BTreeMap::new());
    for line in lines {
        if let Some((word, value)) = line.trim_start().strip_prefix('Q').and_then(|rest| rest.split_once('=')) {
            q.insert(word.parse().expect("a number"), thousandths(value.split(' ').next().expect("a value")));
            continue;
        }
        let words =
            line.split_once(' ').filter(|(count, _)| count.parse::<u32>().is_ok()).map_or(&**line, |(_, rest)| rest);
        if let Some(name) = words.strip_prefix("CYCL DEF ") {
            q.clear();
            name[..3].clone_into(&mut number);
            continue;
        }
        if words == "MCALL" {
            modal = None;
        } else if let Some(call) = words.strip_prefix("MCALL ") {
            modal = Some(sinumerik(call, feed));
        } else {
            let mut moves = false;
            for word in words.split(' ') {
                match word.split_at(1) {
                    ("F", value) if !value.starts_with("MAX") => feed = thousandths(value) / 1_000,
                    (axis @ ("X" | "Y"), value) => {
                        at[usize::from(axis == "Y")] = thousandths(value);
                        moves = true;
                    }
                    _ => {}
                }
            }
            if words.ends_with("M99") {
                holes.push((conversational(&number, &q), at));
            } else if let Some(written) = modal.filter(|_| moves) {
                assert!(words.starts_with("G0") || !words.starts_with('G'), "{words}");
                holes.push((written, at));
            }
        }
    }
    holes
}

fn any_cycle() -> impl Strategy<Value = CannedCycle> {
    let place = prop::array::uniform2(0_i64..3);
    let levels = (0_i64..2, 1_i64..3, 1_i64..3, 0_i64..3, 0_i64..2);
    let kinds = vec![CannedKind::Drill, PECK, CHIPS, CannedKind::Ream, thread(false), thread(true)];
    let waits = prop::option::of(Just(0.5));
    (place, levels, prop::sample::select(kinds), waits).prop_map(
        |([x, y], (top, above, deep, up, fast), kind, dwell)| {
            let surface = top * 1_500;
            let (clearance, bottom) = (surface + above * 1_000, surface - deep * 5_000);
            let words = AxisWords { mask: 0b011, ..linear([x * 1_000, y * 1_000, 0]) };
            let feed = Decimal { units: 100 + fast, decimals: 0 };
            // Cycle 207 does not wait.
            let dwell = dwell.filter(|_| !matches!(kind, CannedKind::Tap { .. }));
            CannedCycle { kind, words, z: 2, surface, clearance, bottom, back: clearance + up * 1_000, dwell, feed }
        },
    )
}

proptest! {
    /// Each hole is written as it is and where it is, and none is drilled twice, whatever comes between them.
    #[test]
    fn every_hole_is_written_as_it_is(holes in prop::collection::vec((any_cycle(), 0_u8..8), 1..20)) {
        let mut blocks = vec![Step::Restart { number: 1, changes_tool: false }];
        for (cycle, between) in &holes {
            match between {
                0 => blocks.push(Step::Rapid { words: linear([7_000, 7_000, 90_000]) }),
                1 => blocks.push(Step::Stop { optional: false }),
                2 => blocks.push(Step::Feed { words: linear([0, 500, 0]), feed: per_minute(7) }),
                _ => {}
            }
            blocks.push(Step::Cycle { cycle });
        }
        let expected: Vec<_> = holes.iter().map(|(cycle, _)| (written(cycle), [cycle.words.units[0], cycle.words.units[1]])).collect();
        for control in [&Siemens as &dyn Control, &Heidenhain] {
            let text = steps(control, &milling(), &blocks);
            prop_assert_eq!(&read(&text), &expected, "{:#?}", text);
            let every_word = ControlOptions { every_word: true, ..ControlOptions::default() };
            let text = steps(control, &Layout { options: every_word, ..milling() }, &blocks);
            prop_assert_eq!(&read(&text), &expected, "{:#?}", text);
        }
    }
}
