//! Holes as single motions and as cycles, which are read and executed as a control does.

use proptest::prelude::*;

use super::*;
use crate::config::Config;
use crate::control::{CONTROLS, Control, Heidenhain, Siemens};
use crate::diag::Severity;
use crate::kinematics::machines::{Cb, Head, Xyz};
use crate::motion::Provenance;
use crate::motion::tests::{Run, config, feed, plan, pose, rapid, run, spindle, tool};
use crate::program::{Dwell, Event, Gap, Gaps, ToolMotion};
use crate::set_up::GivenTool;

const UP: [f64; 3] = [0.0, 0.0, 1.0];

fn set_up(output: CycleOutput) -> Config {
    let mut config = config();
    config.set_up.tools.insert(1, GivenTool { length_mm: Some(100.0), ..GivenTool::default() });
    config.motion.retract.distance_mm = Some(20.0);
    config.motion.cycles.output = output;
    config
}

fn hole(top: [f64; 3], drilling: Drilling, back_to: f64, dwell: Option<Dwell>) -> Event<'static> {
    let feed = Some(Programmed::PerMinute(100.0));
    Event::Motion(ToolMotion::Hole(Hole {
        top: pose(top, UP),
        depth_mm: 5.0,
        clearance_mm: 2.0,
        return_mm: back_to,
        drilling,
        feed,
        dwell,
    }))
}

/// A program that begins with a cut to a point, followed by holes.
fn after_cut(point: [f64; 3], holes: &[Event<'static>]) -> Vec<Event<'static>> {
    let start = [tool(1), spindle(), feed(point, UP)];
    start.into_iter().chain(holes.iter().copied()).collect()
}

fn lines(config: &Config, events: &[Event<'_>]) -> Vec<String> {
    let run = run::<Xyz>(config, events);
    // A clearance level below the first cut is remarked on.
    assert!(run.diagnostics.iter().all(|found| found.severity == Severity::Warning), "{:?}", run.diagnostics);
    let first = run.lines.iter().position(|line| line.starts_with("G1 ")).expect("the first cut");
    let last = run.lines.iter().rposition(|line| line == "G53 G0 Z0").expect("the retract");
    run.lines[first + 1..last].to_vec()
}

/// Heights of the blocks that move Z, and whether they are rapids.
fn heights(point: [f64; 3], drilling: Drilling, back_to: f64, dwell: Option<Dwell>) -> Vec<(f64, bool)> {
    let events = after_cut(point, &[hole([1.0, 0.0, 0.0], drilling, back_to, dwell)]);
    let (mut fast, mut found) = (false, Vec::new());
    for line in lines(&set_up(CycleOutput::Expanded), &events) {
        fast = if line.contains("G0") { true } else { fast && !line.contains("G1") };
        found.extend(line.split(' ').filter_map(|word| Some((word.strip_prefix('Z')?.parse().ok()?, fast))));
    }
    // The last one is the retract out of the part.
    found.pop();
    found
}

#[test]
fn a_hole_is_drilled_at_feed_and_left_at_rapid() {
    let found = heights([0.0, 0.0, 9.0], Drilling::Drill, 2.0, Some(Dwell::Seconds(1.0)));
    assert_eq!(found, [(2.0, true), (-5.0, false), (2.0, true)]);
    let found = heights([0.0, 0.0, 9.0], Drilling::Ream, 9.0, None);
    assert_eq!(found, [(2.0, true), (-5.0, false), (2.0, false), (9.0, true)]);
}

#[test]
fn deep_holes_are_cleared_after_each_step_and_chips_broken_without() {
    let found = heights([1.0, 0.0, 2.0], Drilling::Peck { first_mm: 3.0, later_mm: 1.5 }, 2.0, None);
    let expected = [-3.0, 2.0, -2.5, -4.5, 2.0, -4.0, -5.0, 2.0];
    assert_eq!(found.iter().map(|(height, _)| *height).collect::<Vec<_>>(), expected);
    assert_eq!(
        found.iter().map(|(_, fast)| !fast).collect::<Vec<_>>(),
        expected.map(|height| [-3.0, -4.5, -5.0].contains(&height))
    );
    let found = heights([1.0, 0.0, 2.0], Drilling::ChipBreak { step_mm: 2.0, retract_mm: Some(0.3) }, 2.0, None);
    assert_eq!(found.iter().map(|(height, _)| *height).collect::<Vec<_>>(), [-2.0, -1.7, -4.0, -3.7, -5.0, 2.0]);
}

#[test]
fn a_hole_through_plates_is_fed_through_each_and_passes_the_gaps_at_rapid() {
    let gap = |feed_ends_mm: f64, feed_begins_mm: f64| Gap { feed_ends_mm, feed_begins_mm };
    let through = |gaps: &[Gap]| Drilling::Through { gaps: Gaps::of(gaps).unwrap() };
    let found = heights([0.0, 0.0, 9.0], through(&[gap(1.0, 1.5), gap(2.5, 4.0)]), 3.0, Some(Dwell::Seconds(1.0)));
    let expected = [(2.0, true), (-1.0, false), (-1.5, true), (-2.5, false), (-4.0, true), (-5.0, false), (3.0, true)];
    assert_eq!(found, expected);
    // The next plate begins within the clearance level of the one above, or just at it: up in the hole, or not at all.
    let found = heights([0.0, 0.0, 9.0], through(&[gap(3.0, 2.5)]), 2.0, None);
    assert_eq!(found, [(2.0, true), (-3.0, false), (-2.5, true), (-5.0, false), (2.0, true)]);
    let found = heights([0.0, 0.0, 9.0], through(&[gap(3.0, 3.0)]), 2.0, None);
    assert_eq!(found, [(2.0, true), (-3.0, false), (-5.0, false), (2.0, true)]);
    // No cycle moves the tool so.
    let events = after_cut([0.0, 0.0, 2.0], &[hole([1.0, 2.0, 0.0], through(&[gap(1.0, 2.0)]), 2.0, None)]);
    assert_eq!(lines(&set_up(CycleOutput::Native), &events)[0], "G0 X1 Y2");
}

#[test]
fn the_tool_lifts_before_it_goes_over_to_a_higher_hole() {
    for output in [CycleOutput::Native, CycleOutput::Expanded] {
        let found =
            lines(&set_up(output), &after_cut([0.0, 0.0, -1.0], &[hole([8.0, 0.0, 4.0], Drilling::Drill, 2.0, None)]));
        assert_eq!(found[0], "G0 Z6", "{found:#?}");
        assert!(found[1].contains("X8"), "{found:#?}");
    }
}

#[test]
fn equal_holes_are_positions_of_one_cycle() {
    let at = |x: f64, y: f64| hole([x, y, 0.0], Drilling::Drill, 2.0, None);
    let events = after_cut([0.0, 0.0, 9.0], &[at(1.0, 2.0), at(5.0, 2.0), at(5.0, 2.0), rapid([5.0, 2.0, 9.0], UP)]);
    let expected = ["G99 G81 X1 Y2 Z-5 R2 F100", "X5", "X5 Y2", "G80", "G0 Z9"];
    assert_eq!(lines(&set_up(CycleOutput::Native), &events)[..5], expected);
}

#[test]
fn the_tool_is_at_the_return_level_before_a_cycle_that_returns_to_its_start() {
    let events = after_cut([0.0, 0.0, 9.0], &[hole([1.0, 2.0, 0.0], Drilling::Drill, 7.0, None)]);
    let found = lines(&set_up(CycleOutput::Native), &events);
    assert_eq!(found[..4], ["G0 X1 Y2", "Z7", "G98 G81 X1 Y2 Z-5 R2 F100", "G80"]);
}

#[test]
fn holes_that_differ_from_every_cycle_are_expanded() {
    let cycle = |drilling, dwell| {
        let events = after_cut([0.0, 0.0, 2.0], &[hole([1.0, 2.0, 0.0], drilling, 2.0, dwell)]);
        lines(&set_up(CycleOutput::Native), &events)[0].clone()
    };
    let waits = Some(Dwell::Seconds(0.5));
    assert_eq!(cycle(Drilling::Drill, waits), "G99 G82 X1 Y2 Z-5 R2 P0.5 F100");
    assert_eq!(cycle(Drilling::Peck { first_mm: 2.0, later_mm: 2.0 }, None), "G99 G83 X1 Y2 Z-5 R2 Q2 F100");
    assert_eq!(cycle(Drilling::ChipBreak { step_mm: 2.0, retract_mm: None }, None), "G99 G73 X1 Y2 Z-5 R2 Q2 F100");
    assert_eq!(cycle(Drilling::Ream, None), "G99 G85 X1 Y2 Z-5 R2 F100");
    assert_eq!(cycle(Drilling::Ream, waits), "G99 G89 X1 Y2 Z-5 R2 P0.5 F100");
    for (drilling, dwell) in [
        (Drilling::Peck { first_mm: 3.0, later_mm: 2.0 }, None),
        (Drilling::Peck { first_mm: 2.0, later_mm: 2.0 }, waits),
        (Drilling::ChipBreak { step_mm: 2.0, retract_mm: Some(0.3) }, None),
    ] {
        assert_eq!(cycle(drilling, dwell), "G0 X1 Y2", "{drilling:?}");
    }
}

#[test]
fn a_thread_follows_the_spindle_and_is_never_expanded() {
    let tap = |pitch| hole([1.0, 2.0, 0.0], Drilling::Tap { pitch_mm: pitch }, 9.0, None);
    let events = after_cut([0.0, 0.0, 9.0], &[tap(Some(1.25))]);
    let found = lines(&set_up(CycleOutput::Native), &events);
    assert_eq!(found[..4], ["G0 X1 Y2", "Z2", "G33.1 Z-5 K1.25", "G0 Z9"]);
    let refused = |config: &Config, events: &[Event<'_>]| run::<Xyz>(config, events).error().text.clone();
    assert!(refused(&set_up(CycleOutput::Expanded), &events).contains("tapping synchronises"));
    let waiting = hole([1.0, 2.0, 0.0], Drilling::Tap { pitch_mm: Some(1.0) }, 9.0, Some(Dwell::Seconds(1.0)));
    assert!(
        refused(&set_up(CycleOutput::Native), &after_cut([0.0, 0.0, 9.0], &[waiting]))
            .contains("no dwell at the bottom")
    );
    // Without a pitch the feed defines it: 100 mm/min at 8000 rev/min.
    let found = lines(&set_up(CycleOutput::Native), &after_cut([0.0, 0.0, 9.0], &[tap(None)]));
    assert_eq!(found[2], "G33.1 Z-5 K0.0125");
}

#[test]
fn the_motion_to_a_thread_is_no_other_hole_of_the_cycle_before() {
    let tap = hole([9.0, 2.0, 0.0], Drilling::Tap { pitch_mm: Some(1.0) }, 2.0, None);
    let events = after_cut([0.0, 0.0, 2.0], &[hole([1.0, 2.0, 0.0], Drilling::Drill, 2.0, None), tap]);
    let found = lines(&set_up(CycleOutput::Native), &events);
    assert_eq!(found[..4], ["G99 G81 X1 Y2 Z-5 R2 F100", "G80", "G0 X9 Z2", "G33.1 Z-5 K1"]);
}

#[test]
fn a_hole_with_too_many_steps_is_refused() {
    let dust = hole([0.0; 3], Drilling::Peck { first_mm: 1e-6, later_mm: 1e-6 }, 2.0, None);
    let run = run::<Xyz>(&set_up(CycleOutput::Expanded), &after_cut([0.0, 0.0, 9.0], &[dust]));
    assert!(run.error().text.contains("more than 10000 steps"), "{:?}", run.error());
}

#[test]
fn on_a_head_only_holes_along_z_are_cycles() {
    let counted = |axis: [f64; 3]| {
        let top = pose([1.0, 2.0, -60.0], axis);
        let feed = Some(Programmed::PerMinute(100.0));
        let (depth, clearance, drilling) = (5.0, 2.0, Drilling::Drill);
        let hole = Hole { top, depth_mm: depth, clearance_mm: clearance, return_mm: 2.0, drilling, feed, dwell: None };
        let run =
            run::<Head>(&set_up(CycleOutput::Native), &[tool(1), spindle(), Event::Motion(ToolMotion::Hole(hole))]);
        assert_eq!(run.diagnostics, []);
        run.statistics.cycles
    };
    assert_eq!([counted(UP), counted([0.3, 0.0, 0.9])], [1, 0]);
}

/// Merges consecutive rapids along Z, and removes rapids that end where they began.
fn simplify(path: &mut Vec<([i64; 3], bool)>) {
    path.dedup_by(|next, before| {
        let same = next.1 && before.1 && next.0[..2] == before.0[..2];
        if same {
            before.0 = next.0;
        }
        same
    });
    path.dedup_by(|next, before| next.1 && next.0 == before.0);
}

/// Path of the tip as a control executes the program: rapids, feeds and the cycles `G81`, `G82`, `G85`, `G89`.
fn travelled(run: &Run) -> Vec<([i64; 3], bool)> {
    let (mut at, mut motion, mut cycle, mut initial) = ([0_i64; 3], String::new(), [0_i64; 2], 0_i64);
    let (mut high, mut path) = (false, Vec::new());
    for line in run.lines.iter().filter(|line| !line.starts_with('(') && !line.contains("G53") && !line.contains("G4"))
    {
        let mut words = at;
        let mut moves = false;
        for word in line.split(' ') {
            let value = || (word[1..].parse::<f64>().expect("a number") * 1e3).round() as i64;
            match word {
                "G98" => high = true,
                "G99" => high = false,
                "G0" | "G1" | "G80" => motion = word.to_owned(),
                "G81" | "G82" | "G85" | "G89" => {
                    initial = at[2];
                    motion = word.to_owned();
                }
                _ if word.starts_with(['X', 'Y']) => {
                    words[usize::from(word.starts_with('Y'))] = value();
                    moves = true;
                }
                _ if word.starts_with('Z') && motion.starts_with("G8") => cycle[0] = value(),
                _ if word.starts_with('Z') => {
                    words[2] = value();
                    moves = true;
                }
                _ if word.starts_with('R') => cycle[1] = value(),
                _ => {}
            }
        }
        if !moves {
            continue;
        }
        let before = at[2];
        let mut go = |to: [i64; 3], fast: bool| {
            if to != at {
                path.push((to, fast));
                at = to;
            }
        };
        if motion.starts_with("G8") {
            let level = |z: i64| [words[0], words[1], z];
            let here = level(before);
            assert!(here[2] >= cycle[1], "the tool goes over below the clearance level: {line}");
            go(here, true);
            go(level(cycle[1]), true);
            go(level(cycle[0]), false);
            go(level(cycle[1]), !matches!(motion.as_str(), "G85" | "G89"));
            go(level(if high { initial } else { cycle[1] }), true);
        } else {
            go(words, motion == "G0");
        }
    }
    simplify(&mut path);
    path
}

fn any_hole() -> impl Strategy<Value = Event<'static>> {
    let whole = |range: std::ops::Range<i32>| range.prop_map(f64::from);
    let kind = prop_oneof![Just(Drilling::Drill), Just(Drilling::Ream)];
    let dwell = prop::option::of(Just(Dwell::Seconds(0.5)));
    (whole(-3..4), whole(-3..4), whole(-2..3), whole(1..3), whole(0..3), kind, dwell).prop_map(
        |(x, y, z, clearance, above, drilling, dwell)| {
            let feed = Some(Programmed::PerMinute(100.0));
            let top = pose([x, y, z], UP);
            Event::Motion(ToolMotion::Hole(Hole {
                top,
                depth_mm: 4.0,
                clearance_mm: clearance,
                return_mm: clearance + above,
                drilling,
                feed,
                dwell,
            }))
        },
    )
}

/// Path of the tip of [`Xyz`] through steps, and whether at rapid; a cycle moves as its documentation defines.
#[derive(Default)]
struct TracedPath {
    at: [i64; 3],
    path: Vec<([i64; 3], bool)>,
    cycles: Vec<CannedCycle>,
    rapid_below: bool,
}

impl TracedPath {
    fn go(&mut self, to: [i64; 3], fast: bool) {
        if to != self.at {
            self.path.push((to, fast));
            self.at = to;
        }
    }

    fn words(&mut self, words: &AxisWords, fast: bool) {
        let mut to = self.at;
        for (axis, value) in to.iter_mut().enumerate().filter(|(axis, _)| words.has(*axis)) {
            *value = words.units[axis];
        }
        self.go(to, fast);
    }

    fn cycle(&mut self, cycle: &CannedCycle, returns: bool) {
        let began = self.at[2];
        self.rapid_below |= began < cycle.clearance;
        self.words(&cycle.words, true);
        let [x, y, _] = self.at;
        let level = |path: &mut Self, z: i64, fast: bool| path.go([x, y, z], fast);
        level(self, cycle.clearance, true);
        let (step, gap, out) = match cycle.kind {
            CannedKind::Peck { step, gap } => (step, gap, true),
            CannedKind::ChipBreak { step, gap } => (step, gap, false),
            _ => (cycle.surface - cycle.bottom, 0, false),
        };
        let mut done = (cycle.surface - step).max(cycle.bottom);
        level(self, done, false);
        while done > cycle.bottom {
            if out {
                level(self, cycle.clearance, true);
            }
            level(self, done + gap, true);
            done = (done - step).max(cycle.bottom);
            level(self, done, false);
        }
        level(self, cycle.clearance, cycle.kind != CannedKind::Ream);
        assert!(returns || cycle.back == cycle.clearance || cycle.back == began, "it comes back to where it began");
        level(self, cycle.back, true);
        self.cycles.push(*cycle);
    }
}

/// Decimals of the pitch of a control.
fn pitch_decimals(control: &dyn Control) -> (u32, u32) {
    let formats = &control.spellings().formats;
    (formats.pitch_mm, formats.pitch_inch)
}

/// Path of a program on a control, without intermediate stops of rapids along Z.
fn path(control: &dyn Control, output: CycleOutput, events: &[Event<'_>]) -> (Vec<([i64; 3], bool)>, Vec<CannedCycle>) {
    struct Steps(TracedPath, bool);
    impl Sink for Steps {
        fn step(&mut self, step: &Step<'_>, _: &Provenance<'_>) -> std::io::Result<()> {
            match step {
                Step::Rapid { words } => self.0.words(words, true),
                Step::Feed { words, .. } => self.0.words(words, false),
                Step::Cycle { cycle } => self.0.cycle(cycle, self.1),
                _ => {}
            }
            Ok(())
        }
    }
    let mut config = set_up(output);
    (config.formats.pitch_mm, config.formats.pitch_inch) = pitch_decimals(control);
    let returns = crate::control::abilities(control, config.demands()).cycles.returns_to_any_level;
    let mut steps = Steps(TracedPath::default(), returns);
    let (diagnostics, _) = plan::<Xyz>(control, &config, events, &mut steps);
    assert!(diagnostics.iter().all(|found| found.severity == Severity::Warning), "{diagnostics:?}");
    assert!(!steps.0.rapid_below, "the tool goes over below the clearance level");
    let mut path = steps.0.path;
    simplify(&mut path);
    (path, steps.0.cycles)
}

/// Cycle of one hole, 5 mm deep, from its clearance level 2 mm above.
fn kind(control: &dyn Control, drilling: Drilling, dwell: Option<Dwell>) -> Option<CannedKind> {
    let events = after_cut([0.0, 0.0, 2.0], &[hole([1.0, 2.0, 0.0], drilling, 2.0, dwell)]);
    path(control, CycleOutput::Native, &events).1.first().map(|cycle| cycle.kind)
}

#[test]
fn holes_with_the_steps_of_a_control_are_written_as_its_cycles() {
    let waits = Some(Dwell::Seconds(0.5));
    let peck = |step: f64| Drilling::Peck { first_mm: step, later_mm: step };
    let chips = |step: f64| Drilling::ChipBreak { step_mm: step, retract_mm: Some(0.3) };
    let native = |control: &dyn Control| {
        [(peck(2.5), None), (peck(2.0), None), (peck(2.5), waits), (chips(2.5), None), (chips(2.0), None)]
            .map(|(drilling, dwell)| kind(control, drilling, dwell).is_some())
    };
    assert_eq!(native(&Siemens), [true; 5]);
    assert_eq!(native(&Heidenhain), [true, true, false, true, true]);
    let uneven = Drilling::Peck { first_mm: 3.0, later_mm: 2.0 };
    let too_far = Drilling::ChipBreak { step_mm: 2.5, retract_mm: Some(4.6) };
    for control in [&Siemens as &dyn Control, &Heidenhain] {
        assert_eq!(kind(control, peck(2.5), None), Some(CannedKind::Peck { step: 2500, gap: 500 }));
        assert_eq!(kind(control, chips(2.5), None), Some(CannedKind::ChipBreak { step: 2500, gap: 300 }));
        assert_eq!([kind(control, uneven, None), kind(control, too_far, None)], [None, None]);
    }
}

#[test]
fn a_dwell_that_is_too_long_for_a_cycle_is_written_after_single_motions() {
    let native = |control, seconds| kind(control, Drilling::Drill, Some(Dwell::Seconds(seconds))).is_some();
    assert_eq!(
        [native(&Heidenhain, 3600.0), native(&Heidenhain, 3600.5), native(&Siemens, 3600.5)],
        [true, false, true]
    );
}

#[test]
fn the_pitch_of_a_thread_has_the_digits_of_the_control() {
    let pitch = |control, pitch| match kind(control, Drilling::Tap { pitch_mm: Some(pitch) }, None) {
        Some(CannedKind::Tap { pitch, .. }) => pitch.value(),
        _ => f64::NAN,
    };
    let eighteen = 25.4 / 18.0;
    assert!((pitch(&Siemens, eighteen) - 1.411_111).abs() < 1e-9);
    assert!((pitch(&Heidenhain, eighteen) - 1.4111).abs() < 1e-9);
    let events = after_cut([0.0, 0.0, 2.0], &[hole([0.0; 3], Drilling::Tap { pitch_mm: Some(0.0103) }, 2.0, None)]);
    let mut config = set_up(CycleOutput::Native);
    (config.formats.pitch_mm, config.formats.pitch_inch) = pitch_decimals(&Heidenhain);
    let refused = |control: &dyn Control| {
        let (found, _) = plan::<Xyz>(control, &config, &events, &mut crate::motion::DiscardSteps);
        found.into_iter().find(|found| found.severity == Severity::Error).map(|found| found.text)
    };
    assert_eq!(refused(&Heidenhain), None);
    let events = after_cut([0.0, 0.0, 2.0], &[hole([0.0; 3], Drilling::Tap { pitch_mm: Some(0.010_33) }, 2.0, None)]);
    let (found, _) = plan::<Xyz>(&Heidenhain, &config, &events, &mut crate::motion::DiscardSteps);
    assert!(found[0].text.contains("and that of its rounded words"), "{found:?}");
    // 1.25 mm in inches: with four decimals 1.249 68 mm would be cut.
    let events =
        after_cut([0.0, 0.0, 2.0], &[hole([0.0; 3], Drilling::Tap { pitch_mm: Some(1.25 / 25.4) }, 2.0, None)]);
    let (found, _) = plan::<Xyz>(&Heidenhain, &config, &events, &mut crate::motion::DiscardSteps);
    assert!(found[0].text.contains("and that of its rounded words"), "{found:?}");
}

fn any_steps() -> impl Strategy<Value = Drilling> {
    let step = || (1_i32..9).prop_map(|half| f64::from(half) * 0.5);
    prop_oneof![
        Just(Drilling::Drill),
        Just(Drilling::Ream),
        step().prop_map(|step| Drilling::Peck { first_mm: step, later_mm: step }),
        (step(), step()).prop_map(|(first, later)| Drilling::Peck { first_mm: first, later_mm: later }),
        (step(), prop::option::of(step()))
            .prop_map(|(step, back)| Drilling::ChipBreak { step_mm: step, retract_mm: back }),
    ]
}

proptest! {
    /// A cycle moves the tool just as the single motions do.
    #[test]
    fn cycles_and_motions_move_the_tool_in_the_same_way(
        holes in prop::collection::vec(any_hole(), 1..12),
        start in prop::array::uniform3(-4_i32..8),
    ) {
        let events = after_cut(start.map(f64::from), &holes);
        let posted = |output| {
            let run = run::<Cb>(&set_up(output), &events);
            // A clearance level below the first cut is remarked on, however the hole is made.
            let remarks: Vec<String> = run.diagnostics.iter().map(|remark| remark.text.clone()).collect();
            (travelled(&run), run.statistics.cycles, remarks)
        };
        let (native, expanded) = (posted(CycleOutput::Native), posted(CycleOutput::Expanded));
        prop_assert_eq!((&native.0, &native.2), (&expanded.0, &expanded.2));
        prop_assert!(native.1 > 0 || holes.iter().all(|hole| matches!(hole, Event::Motion(ToolMotion::Hole(hole)) if hole.drilling == Drilling::Ream)));
        prop_assert_eq!(expanded.1, 0);
    }

    /// On every control a cycle has the path of the single motions, step by step where the cycle programs its gap.
    #[test]
    fn the_cycles_of_every_control_have_the_path_of_the_motions(
        holes in prop::collection::vec((any_hole(), any_steps()), 1..8),
        start in prop::array::uniform3(-4_i32..8),
    ) {
        for control in CONTROLS {
            let programs_gap = crate::control::abilities(*control, set_up(CycleOutput::Native).demands()).cycles.programs_gap;
            let holes: Vec<Event<'static>> = holes.iter().map(|(event, drilling)| match *event {
                Event::Motion(ToolMotion::Hole(hole)) if programs_gap => Event::Motion(ToolMotion::Hole(Hole { drilling: *drilling, ..hole })),
                event => event,
            }).collect();
            let events = after_cut(start.map(f64::from), &holes);
            let (native, cycles) = path(*control, CycleOutput::Native, &events);
            let (expanded, none) = path(*control, CycleOutput::Expanded, &events);
            prop_assert_eq!(native, expanded, "{}", control.spellings().name);
            prop_assert!(none.is_empty());
            let plain = |event: &Event<'_>| matches!(event, Event::Motion(ToolMotion::Hole(hole)) if hole.drilling == Drilling::Drill);
            prop_assert!(!cycles.is_empty() || !holes.iter().any(plain));
        }
    }
}
