//! The planner on the machines of the tests, written by the LinuxCNC table: one line is one block.

use nalgebra::{Point3, UnitVector3, Vector3};

use super::machines::{Ay, Cb, Head, Xyw, Xyz};
use super::{Navigator, Nowhere, Planner, Stop};
use crate::config::{Config, Rapid, Tool, Transition, Units, Wrap};
use crate::control::{Encoder, Layout, LinuxCnc};
use crate::diag::{Diagnostic, Severity};
use crate::kinematics::{AxisKind, Limits, Machine, Pose};
use crate::program::{
    Compensation, Coolant, Dwell, Event, Feed, Location, Move, Plane, Rotation, Spindle, ToolCall, Turning,
};

/// What came out of a run.
pub(super) struct Run {
    pub(super) lines: Vec<String>,
    pub(super) diagnostics: Vec<Diagnostic>,
    pub(super) statistics: super::Statistics,
}

impl Run {
    pub(super) fn error(&self) -> &Diagnostic {
        self.diagnostics.iter().find(|found| found.severity == Severity::Error).expect("an error")
    }

    fn text(&self) -> String {
        self.lines.join("\n")
    }
}

/// Posts events; the event at position `n` stands in line `n + 1`.
pub(super) fn run<M: Machine>(config: &Config, events: &[Event<'_>]) -> Run {
    let machine = config.machine::<M>().expect("valid");
    let units = config.output_units.unwrap_or(Units::Millimetres);
    let layout = Layout::new::<M>(config, units, b"");
    let mut out = Vec::new();
    let mut encoder = Encoder::new(&LinuxCnc, &layout, &mut out);
    let abilities = crate::control::abilities(&LinuxCnc, config);
    let mut navigator = Navigator::new(machine.clone(), config);
    events.iter().for_each(|event| navigator.event(event));
    let course = navigator.finish();
    let mut planner = Planner::new(machine.clone(), config, units, abilities, false).with_course(course.clone());
    if !config.clamp.is_empty() {
        for event in events {
            planner.event(Location::default(), event, &mut Nowhere).expect("a rehearsal");
        }
        planner.finish(Location::default(), &mut Nowhere).expect("a rehearsal");
        let moving = planner.rehearsed();
        planner = Planner::new(machine, config, units, abilities, false).with_course(course).with_clamps(moving);
    }
    let mut diagnostics = Vec::new();
    let mut at = Location::default();
    let mut planned = Ok(());
    for (index, event) in events.iter().enumerate() {
        at = Location { line: index as u64 + 1, column: 1 };
        planned = planner.event(at, event, &mut encoder);
        if planned.is_err() {
            break;
        }
    }
    if planned.is_ok() {
        planned = planner.finish(at, &mut encoder);
    }
    diagnostics.append(&mut planner.take_warnings());
    match planned {
        Ok(()) => {}
        Err(Stop::Fault(fault)) => diagnostics.push(fault),
        Err(Stop::Output(error)) => panic!("{error}"),
    }
    encoder.finish().expect("memory takes everything");
    drop(encoder);
    let statistics = planner.statistics();
    let text = String::from_utf8(out).expect("ASCII");
    Run { lines: text.lines().map(str::to_owned).collect(), diagnostics, statistics }
}

/// Posts events that must pass without any remark.
fn lines<M: Machine>(config: &Config, events: &[Event<'_>]) -> Vec<String> {
    let run = run::<M>(config, events);
    assert_eq!(run.diagnostics, [], "{}", run.text());
    run.lines
}

pub(super) fn pose(tip: [f64; 3], axis: [f64; 3]) -> Pose {
    Pose { tip: Point3::from(tip), axis: UnitVector3::new_normalize(Vector3::from(axis)) }
}

const UP: [f64; 3] = [0.0, 0.0, 1.0];

/// The axis of `C` and `B` degrees on the C-B table.
fn cb(c: f64, b: f64) -> [f64; 3] {
    let ((sin_c, cos_c), (sin_b, cos_b)) = (c.to_radians().sin_cos(), b.to_radians().sin_cos());
    [sin_b * cos_c, sin_b * sin_c, cos_b]
}

pub(super) fn rapid(tip: [f64; 3], axis: [f64; 3]) -> Event<'static> {
    Event::Move(Move { pose: pose(tip, axis), rapid: true, feed: None })
}

pub(super) fn feed(tip: [f64; 3], axis: [f64; 3]) -> Event<'static> {
    Event::Move(Move { pose: pose(tip, axis), rapid: false, feed: Some(Feed::PerMinute(500.0)) })
}

pub(super) fn tool(number: u32) -> Event<'static> {
    Event::Tool(ToolCall { number, ..ToolCall::default() })
}

pub(super) fn spindle() -> Event<'static> {
    Event::Spindle(Spindle::On { speed: Some(8000.0), rotation: Some(Rotation::Clockwise) })
}

pub(super) fn config() -> Config {
    Config::default()
}

fn with_lengths(distance: Option<f64>) -> Config {
    let mut config = config();
    for number in 1..=2 {
        config.tools.insert(number, Tool { length: Some(100.0), ..Tool::default() });
    }
    config.retract.distance = distance;
    config
}

#[test]
fn two_tools_go_through_every_step_of_the_safe_sequence_one_block_each() {
    let events = [
        Event::Operation(b"ROUGH"),
        tool(1),
        spindle(),
        Event::Coolant(Coolant::Flood),
        feed([10.0, 20.0, -1.0], UP),
        feed([30.0, 20.0, -1.0], UP),
        Event::Operation(b"FINISH"),
        tool(2),
        spindle(),
        feed([10.0, 0.0, 0.0], cb(90.0, 30.0)),
        feed([20.0, 0.0, 0.0], cb(90.0, 30.0)),
    ];
    let mut config = config();
    config.spindle_dwell = 2.0;
    config.park.insert('C', 0.0);
    config.retract.distance = Some(20.0);
    assert_eq!(
        lines::<Cb>(&config, &events),
        [
            "(OPERATION ROUGH)",
            "N1 G21 G17 G40 G49 G80 G90 G94 G54 G64 P0.01",
            "M9",
            "G53 G0 Z0",
            "T1 M6",
            "G53 G0 Z0",
            "G43 H1",
            "S8000 M3",
            "G4 P2",
            "G0 B0 C0",
            "X10 Y20",
            "Z49",
            "M8",
            "G1 Z-1 F500",
            "X30",
            "M9",
            "G0 Z19",
            "(OPERATION FINISH)",
            "N2 G21 G17 G40 G49 G80 G90 G94 G54 G64 P0.01",
            "M9",
            "G53 G0 Z0",
            "T2 M6",
            "G53 G0 Z0",
            "G43 H2",
            "S8000 M3",
            "G4 P2",
            "G0 B30 C90",
            // The tip of C90 B30 at X10 Y0 Z0, 50 mm out along the axis, which is Z of the machine here.
            "X-19.933 Y-10",
            "Z44.391",
            "M8",
            "G1 Z-5.609 F500",
            "Y-20",
            "M9",
            "G0 Z14.391",
            "G53 G0 Z0",
            "M5",
            "G0 C0",
        ]
    );
}

#[test]
fn a_first_rapid_with_the_next_point_below_it_is_the_approach_point() {
    let events = [
        tool(1),
        spindle(),
        rapid([1.0, 2.0, 30.0], UP),
        Event::Coolant(Coolant::Mist),
        rapid([1.0, 2.0, 3.0], UP),
        feed([1.0, 2.0, -3.0], UP),
    ];
    let lines = lines::<Xyz>(&config(), &events);
    assert_eq!(
        &lines[7..],
        ["G0 X1 Y2", "Z30", "M7", "Z3", "G94 G1 Z-3 F500", "M9", "G53 G0 Z0", "M5"].map(|line| {
            // Feed per minute is in force since the safety line.
            line.trim_start_matches("G94 ")
        })
    );
}

#[test]
fn a_first_rapid_is_reached_from_above_by_a_rapid_where_the_next_point_lies_elsewhere() {
    let events = [tool(1), spindle(), rapid([1.0, 2.0, 3.0], UP), feed([9.0, 2.0, 3.0], UP)];
    let lines = lines::<Xyz>(&config(), &events);
    assert_eq!(&lines[7..11], ["G0 X1 Y2", "Z53", "Z3", "G1 X9 F500"]);
}

#[test]
fn the_same_tool_is_not_changed_yet_the_sequence_is_written() {
    let events =
        [tool(1), spindle(), feed([0.0, 0.0, 0.0], UP), feed([5.0, 0.0, 0.0], UP), tool(1), feed([9.0, 0.0, 0.0], UP)];
    let lines = lines::<Xyz>(&config(), &events);
    assert_eq!(lines.iter().filter(|line| line.contains("M6")).count(), 1);
    assert_eq!(
        &lines[11..],
        [
            "N2 G21 G17 G40 G49 G80 G90 G94 G54 G64 P0.01",
            "M9",
            "G53 G0 Z0",
            "(T1 stays in the spindle)",
            "G43 H1",
            "S8000 M3",
            "G0 X9 Y0",
            "Z50",
            "G1 Z0 F500",
            "G53 G0 Z0",
            "M5",
        ]
    );
}

#[test]
fn a_stop_retracts_first_and_starts_with_every_word_again() {
    let events = [
        tool(1),
        spindle(),
        Event::Coolant(Coolant::Flood),
        feed([0.0, 0.0, 0.0], UP),
        Event::Stop,
        feed([0.0, 0.0, 0.0], UP),
        Event::OptionalStop,
        feed([0.0, 0.0, 1.0], UP),
    ];
    let lines = lines::<Xyz>(&config(), &events);
    let stop = lines.iter().position(|line| line == "M0").expect("a stop");
    assert_eq!(lines[stop - 3..stop], ["M9", "G53 G0 Z0", "M5"]);
    assert_eq!(
        lines[stop + 1..stop + 11],
        [
            "N2 G21 G17 G40 G49 G80 G90 G94 G54 G64 P0.01",
            "M9",
            "G53 G0 Z0",
            "(T1 stays in the spindle)",
            "G43 H1",
            "S8000 M3",
            "G0 X0 Y0",
            "Z50",
            "M8",
            "G1 Z0 F500",
        ]
    );
    assert!(lines.contains(&"M1".to_owned()));
}

#[test]
fn without_stop_retract_the_stop_stands_alone() {
    let mut config = config();
    config.stop_retract = false;
    let events = [tool(1), spindle(), feed([0.0, 0.0, 0.0], UP), Event::Stop, feed([0.0, 0.0, 0.0], UP)];
    let lines = lines::<Xyz>(&config, &events);
    let stop = lines.iter().position(|line| line == "M0").expect("a stop");
    assert_eq!(lines[stop - 1], "G1 Z0 F500");
    assert_eq!(lines[stop + 3], "G53 G0 Z0");
}

#[test]
fn a_rapid_that_turns_the_table_goes_through_the_sequence() {
    let events = [
        tool(1),
        spindle(),
        Event::Coolant(Coolant::Flood),
        feed([0.0, 0.0, 0.0], UP),
        rapid([0.0, 0.0, 5.0], UP),
        rapid([0.0, 0.0, 60.0], [0.0, -1.0, 1.0]),
        rapid([0.0, 0.0, 10.0], [0.0, -1.0, 1.0]),
    ];
    let lines = lines::<Ay>(&config(), &events);
    let start = lines.iter().position(|line| line == "G0 Z5").expect("the rapid before");
    assert_eq!(
        lines[start + 1..],
        [
            "M9",
            "G53 G0 Z0",
            "G0 A45",
            // The next point is not along the axis: 50 mm out from the first.
            "Y63.64",
            "Z83.64",
            "M8",
            "Z33.64",
            "Y28.284 Z-1.716",
            "M9",
            "G53 G0 Z0",
            "M5",
        ]
    );
}

#[test]
fn a_rapid_that_turns_less_than_the_index_angle_is_one_block() {
    let events = |angle: f64| {
        let tilted = cb(0.0, angle);
        [tool(1), spindle(), rapid([0.0; 3], UP), rapid([9.0, 0.0, 0.0], UP), rapid([5.0, 0.0, 0.0], tilted)]
    };
    assert_eq!(run::<Cb>(&config(), &events(1.0)).statistics.sequences, 1);
    assert_eq!(run::<Cb>(&config(), &events(1.001)).statistics.sequences, 2);
    let mut direct = config();
    direct.transition = Transition::Direct;
    assert_eq!(run::<Cb>(&direct, &events(90.0)).statistics.sequences, 1);
}

#[test]
fn a_direct_transition_goes_on_where_the_operation_ended_but_never_over_a_tool_change() {
    let mut direct = config();
    direct.transition = Transition::Direct;
    let events = [
        tool(1),
        spindle(),
        feed([0.0, 0.0, 0.0], UP),
        Event::Operation(b"NEXT"),
        feed([5.0, 0.0, 0.0], UP),
        tool(2),
        spindle(),
        feed([6.0, 0.0, 0.0], UP),
    ];
    let lines = lines::<Xyz>(&direct, &events);
    let next = lines.iter().position(|line| line == "(OPERATION NEXT)").expect("the operation");
    assert_eq!(
        lines[next + 1..next + 6],
        ["X5", "N2 G21 G17 G40 G49 G80 G90 G94 G54 G64 P0.01", "M9", "G53 G0 Z0", "T2 M6"]
    );
}

#[test]
fn a_head_does_not_post_without_the_length_of_the_tool() {
    let run = run::<Head>(&config(), &[tool(7), spindle(), feed([0.0; 3], UP)]);
    assert!(run.error().text.contains("gauge length of T7"), "{:?}", run.error());
    assert_eq!(run.error().location.line, 1);
    assert_eq!(run.lines, [""; 0]);
}

#[test]
fn a_head_refuses_two_lengths_and_a_table_only_warns() {
    let mut config = config();
    config.tools.insert(1, Tool { length: Some(100.0), ..Tool::default() });
    let call = |length| Event::Tool(ToolCall { number: 1, length: Some(length), ..ToolCall::default() });
    let events = |length| [call(length), spindle(), feed([0.0; 3], UP), feed([0.0, 0.0, 60.0], UP)];
    assert!(run::<Head>(&config, &events(100.02)).error().text.contains("100 mm long"));
    assert_eq!(run::<Head>(&config, &events(100.009)).diagnostics, []);
    let table = run::<Cb>(&config, &events(100.02));
    assert_eq!(table.diagnostics.len(), 1);
    assert_eq!(table.diagnostics[0].severity, Severity::Warning);
}

#[test]
fn a_head_needs_a_way_out_along_the_tool() {
    let tilted = [1.0, 0.0, 1.0];
    let out = |mm: f64| feed([mm / 2_f64.sqrt(), 0.0, mm / 2_f64.sqrt()], tilted);
    let cut = [tool(1), spindle(), out(0.0), feed([0.0, 5.0, 0.0], tilted)];
    let with = |last: Option<Event<'static>>| {
        let mut events = cut.to_vec();
        events.extend(last);
        events
    };
    // Nothing leads out.
    let nothing = run::<Head>(&with_lengths(None), &with(None));
    assert!(nothing.error().help.as_ref().is_some_and(|help| help.contains("retract.distance")));
    assert_eq!(nothing.error().location.line, 4);
    // The configuration leads out, along the axis and not along Z.
    let given = lines::<Head>(&with_lengths(Some(100.0)), &with(None));
    let end = given.len();
    assert_eq!(given[end - 3..], ["G0 X247.487 Z-2.513", "G53 G0 Z0", "M5"], "{given:?}");
    // The CL data leads out, far enough or with a remark.
    let far = [tool(1), spindle(), out(0.0), out(51.0)];
    assert_eq!(run::<Head>(&with_lengths(None), &far).diagnostics, []);
    let near = run::<Head>(&with_lengths(None), &[tool(1), spindle(), out(0.0), out(20.0)]);
    assert_eq!(near.diagnostics.len(), 1);
    assert!(near.diagnostics[0].text.contains("20.000 mm only"), "{:?}", near.diagnostics);
    // And back again does not count.
    assert!(
        run::<Head>(&with_lengths(None), &[tool(1), spindle(), out(0.0), out(60.0), out(50.0)]).diagnostics.len() == 1
    );
}

#[test]
fn a_retreat_of_the_cl_data_as_long_as_the_distance_is_not_repeated() {
    let mut config = config();
    config.retract.distance = Some(20.0);
    let events = |height| [tool(1), spindle(), feed([0.0; 3], UP), feed([0.0, 0.0, height], UP)];
    let long = lines::<Xyz>(&config, &events(20.0));
    assert_eq!(long[long.len() - 3..], ["Z20", "G53 G0 Z0", "M5"]);
    let short = lines::<Xyz>(&config, &events(19.9));
    assert_eq!(short[short.len() - 4..], ["Z19.9", "G0 Z39.9", "G53 G0 Z0", "M5"]);
}

#[test]
fn a_feed_motion_needs_tool_spindle_and_feed() {
    let text = |events: &[Event<'_>]| run::<Xyz>(&config(), events).error().text.clone();
    assert!(text(&[spindle(), feed([0.0; 3], UP)]).contains("before the first tool"));
    assert!(text(&[tool(1), feed([0.0; 3], UP)]).contains("without spindle speed"));
    assert!(text(&[tool(1), spindle(), Event::Spindle(Spindle::Off), feed([0.0; 3], UP)]).contains("spindle off"));
    let silent = Event::Move(Move { pose: pose([0.0; 3], UP), rapid: false, feed: None });
    assert!(text(&[tool(1), spindle(), silent]).contains("without feed"));
}

#[test]
fn a_rapid_before_the_first_tool_moves_nothing_because_no_length_offset_is_active() {
    let away = rapid([0.0, 0.0, 100.0], UP);
    let armed = [tool(1), spindle(), feed([0.0; 3], UP)];
    let late = run::<Xyz>(&config(), &[&[away, away][..], &armed].concat());
    assert_eq!(late.lines, lines::<Xyz>(&config(), &armed));
    assert_eq!(late.diagnostics.len(), 1);
    assert!(late.diagnostics[0].text.contains("no length offset"));
    assert!(run::<Head>(&with_lengths(None), &[away]).error().text.contains("before the first tool"));
}

#[test]
fn the_speed_of_one_tool_is_not_that_of_the_next() {
    let events = [tool(1), spindle(), feed([0.0; 3], UP), tool(2), feed([0.0; 3], UP)];
    assert!(run::<Xyz>(&config(), &events).error().text.contains("since the tool was called"));
    let before =
        [tool(1), spindle(), feed([0.0; 3], UP), Event::Operation(b"B"), spindle(), tool(2), feed([0.0; 3], UP)];
    assert_eq!(run::<Xyz>(&config(), &before).diagnostics, []);
}

#[test]
fn speed_and_direction_come_from_the_configuration_where_the_cl_data_gives_none() {
    let mut config = config();
    config.defaults.speed = Some(1000.0);
    config.defaults.rotation = Some(Rotation::Clockwise);
    config.tools.insert(1, Tool { speed: Some(2000.0), ..Tool::default() });
    let text = run::<Xyz>(&config, &[tool(1), feed([0.0; 3], UP), tool(2), feed([0.0; 3], UP)]).text();
    assert!(text.contains("S2000 M3") && text.contains("S1000 M3"), "{text}");
}

#[test]
fn spindle_speeds_that_make_no_sense_are_refused() {
    let mut config = config();
    config.spindle_max = Some(8000.0);
    let text = |config: &Config, speed, rotation| {
        let on = Event::Spindle(Spindle::On { speed: Some(speed), rotation: Some(rotation) });
        run::<Xyz>(config, &[tool(1), on, feed([0.0; 3], UP)]).diagnostics.first().map(|found| found.text.clone())
    };
    assert_eq!(text(&config, 8000.0, Rotation::Clockwise), None);
    assert!(text(&config, 8000.1, Rotation::Clockwise).is_some_and(|text| text.contains("spindle_max")));
    assert!(text(&config, 0.4, Rotation::Clockwise).is_some_and(|text| text.contains("S0")));
    config.tools.insert(1, Tool { left_handed: true, ..Tool::default() });
    assert!(text(&config, 100.0, Rotation::Clockwise).is_some_and(|text| text.contains("counter-clockwise")));
    assert_eq!(text(&config, 100.0, Rotation::CounterClockwise), None);
}

#[test]
fn the_floor_is_the_lowest_tip() {
    let mut config = config();
    config.floor = Some(-5.0);
    let events = |z| [tool(1), spindle(), feed([0.0, 0.0, z], UP)];
    assert_eq!(run::<Xyz>(&config, &events(-5.0)).diagnostics, []);
    assert!(run::<Xyz>(&config, &events(-5.01)).error().text.contains("floor"));
}

#[test]
fn inverse_time_stands_where_a_rotary_word_changes_and_f_is_repeated_behind_it() {
    let events = [
        tool(1),
        spindle(),
        feed([0.0; 3], cb(0.0, 10.0)),
        feed([10.0, 0.0, 0.0], cb(0.0, 10.0)),
        feed([20.0, 0.0, 0.0], cb(0.0, 12.0)),
        feed([25.0, 0.0, 0.0], cb(0.0, 14.0)),
        feed([30.0, 0.0, 0.0], cb(0.0, 14.0)),
        feed([35.0, 0.0, 0.0], cb(0.0, 14.0)),
        feed([36.0, 0.0, 0.0], cb(0.0, 15.0)),
        rapid([90.0, 0.0, 0.0], cb(0.0, 15.0)),
        feed([91.0, 0.0, 0.0], cb(0.0, 15.0)),
    ];
    let lines = lines::<Cb>(&Config { tolerance: 1.0, ..config() }, &events);
    let first = lines.iter().position(|line| line.starts_with("G93")).expect("inverse time");
    let codes: Vec<String> = lines[first..first + 8]
        .iter()
        .map(|line| line.split(' ').filter(|word| word.starts_with(['G', 'F', 'B'])).collect::<Vec<_>>().join(" "))
        .collect();
    assert_eq!(codes, ["G93 B12 F50", "B14 F100", "G94 F500", "", "G93 B15 F500", "G94", "G0", "G1 F500"]);
}

#[test]
fn a_feed_per_revolution_becomes_a_feed_per_minute_with_the_written_speed() {
    let per_turn = Event::Move(Move { pose: pose([0.0; 3], UP), rapid: false, feed: Some(Feed::PerRevolution(0.1)) });
    let text = run::<Xyz>(&config(), &[tool(1), spindle(), per_turn]).text();
    assert!(text.contains("G1 Z0 F800"), "{text}");
}

#[test]
fn a_spiral_of_twenty_turns_counts_past_360_without_a_jump() {
    let mut events = vec![tool(1), spindle()];
    let steps = 20 * 72;
    for step in 0..=steps {
        let angle = f64::from(step) * 5.0;
        let (sin, cos) = angle.to_radians().sin_cos();
        events.push(feed([30.0 * cos, 30.0 * sin, -f64::from(step) / 300.0], cb(angle, 60.0)));
    }
    let lines = lines::<Cb>(&Config { tolerance: 1.0, ..config() }, &events);
    let turns: Vec<f64> = lines
        .iter()
        .filter(|line| !line.starts_with('('))
        .flat_map(|line| line.split(' ').filter_map(|word| word.strip_prefix('C')?.parse().ok()))
        .collect();
    assert_eq!(turns.len() as i32, steps + 1);
    for (step, turn) in turns.iter().enumerate() {
        assert!((turn - step as f64 * 5.0).abs() < 1e-9, "step {step} stands at {turn}");
    }
}

/// The line that ends a turn in which one rotary turns and the other stands at zero.
fn turns_alone(turning: char, standing: char, end: &str, lines: &[String]) -> usize {
    let zero = format!("{standing}0");
    let start = lines.iter().position(|line| line.starts_with("X") && line.split(' ').any(|word| word == zero));
    let start = start.expect("the pole") + 1;
    let end = lines.iter().position(|line| line.split(' ').any(|word| word == end)).expect("the end of the turn");
    assert!(start <= end, "{lines:#?}");
    assert!(lines[start..=end].iter().all(|line| line.contains(turning) && !line.contains(standing)), "{lines:#?}");
    end
}

#[test]
fn a_free_rotary_turns_at_the_vertical_for_what_follows() {
    let events = [
        tool(1),
        spindle(),
        feed([10.0, 0.0, 0.0], cb(40.0, 20.0)),
        feed([9.0, 0.0, 0.0], UP),
        feed([8.0, 0.0, 0.0], cb(45.0, 5.0)),
    ];
    let lines = run::<Cb>(&config(), &events).lines;
    let vertical = lines.iter().find(|line| line.contains("B0")).expect("the vertical");
    assert!(!vertical.contains('C'), "{vertical}");
    // In place, and the tilt begins with the table where it has to stand.
    let end = turns_alone('C', 'B', "C45", &lines);
    assert!(lines[end + 1].contains('B') && !lines[end + 1].contains('C'), "{lines:#?}");
}

#[test]
fn rounding_near_the_vertical_does_not_turn_the_table() {
    let at = |axis| feed([8.0, 0.0, 0.0], axis);
    let turned = |axis| {
        let first = feed([10.0, 0.0, 0.0], cb(40.0, 0.01));
        let run = run::<Cb>(&config(), &[tool(1), spindle(), first, at(axis)]);
        (run.lines.iter().filter(|line| line.contains('C')).count() > 1, run.statistics.near_pole)
    };
    assert_eq!(turned([-1e-7, 2e-7, 1.0]), (false, 1));
    assert_eq!(turned([-1e-5, 2e-5, 1.0]), (true, 0));
}

/// Minutes of the blocks in inverse time.
fn minutes(lines: &[String]) -> f64 {
    let word = |line: &String| line.rsplit_once(" F").map(|(_, word)| word.parse::<f64>().expect("a number"));
    let mut inverse = false;
    let mut sum = 0.0;
    for line in lines {
        inverse = (inverse || line.contains("G93")) && !line.contains("G94");
        sum += if inverse { word(line).map_or(0.0, |word| 1.0 / word) } else { 0.0 };
    }
    sum
}

#[test]
fn a_motion_that_turns_an_axis_far_becomes_blocks_within_tolerance() {
    let turned = |to: f64, tolerance: f64| {
        let events = [tool(1), spindle(), feed([40.0, 0.0, 0.0], cb(0.0, 30.0)), feed([10.0, 40.0, 0.0], cb(to, 30.0))];
        run::<Cb>(&Config { tolerance, ..config() }, &events)
    };
    let far = turned(60.0, 0.01);
    assert_eq!(far.diagnostics, []);
    assert!((20..80).contains(&far.statistics.inserted), "{:?}", far.statistics);
    let used = far.statistics.largest_tip_bound;
    assert!(used > 0.009 && used <= 0.01 && far.statistics.largest_axis_bound <= 0.1_f64.to_radians());
    assert!((minutes(&far.lines) - 50.0 / 500.0).abs() < 1e-6, "the tip keeps its speed: {}", far.text());
    let finer = turned(60.0, 0.0025).statistics.inserted as f64 / far.statistics.inserted as f64;
    assert!((1.8..2.6).contains(&finer), "a quarter of the tolerance takes twice the blocks: {finer}");
    assert_eq!(turned(0.02, 0.01).statistics.inserted, 0);
}

#[test]
fn beside_the_pole_the_tool_follows_its_path_and_through_it_the_branch_may_change() {
    let across = |from: f64, to: f64| {
        let events = [tool(1), spindle(), feed([9.0, 0.0, 0.0], cb(from, 4.0)), feed([9.0, 5.0, 0.0], cb(to, 4.0))];
        let run = run::<Cb>(&config(), &events);
        assert_eq!(run.diagnostics, []);
        run
    };
    // 0.7 degrees beside the pole there is no way from one branch to the other.
    let beside = across(10.0, 170.0);
    assert!(beside.statistics.inserted > 20 && !beside.text().contains("B-4"), "{}", beside.text());
    assert!(beside.text().contains("C170"));
    let through = across(10.0, 190.0);
    assert!(through.statistics.inserted < 10 && through.text().contains("B-4"), "{}", through.text());
}

#[test]
fn what_cannot_be_certified_is_an_error_with_its_reason() {
    let error = |config: &Config, from: [f64; 3], to: [f64; 3]| {
        let events = [tool(1), spindle(), feed([9.0, 0.0, 0.0], from), feed([9.0, 5.0, 0.0], to)];
        let run = run::<Cb>(config, &events);
        (run.error().location.line, run.error().text.clone())
    };
    let (line, opposite) = error(&config(), cb(0.0, 90.0), cb(180.0, 90.0));
    assert!(line == 4 && opposite.contains("turns by 180° in one motion"), "{opposite}");
    let (_, limit) = error(&config(), cb(0.0, 105.0), cb(120.0, 105.0));
    assert!(limit.contains("on the way from the point before") && limit.contains("limits -5"), "{limit}");
    let fine = Config { tolerance: 0.0005, ..config() };
    let (_, coarse) = error(&fine, cb(0.0, 30.0), cb(90.0, 30.0));
    assert!(coarse.contains("too coarse for a tolerance of 0.0005 mm"), "{coarse}");
}

crate::machine! {
    /// Cannot stand the tool upright: between 30° and 150° from the vertical.
    struct Leaning;
    chain: C B | X Y Z;
    tool_axis = (0, 1/2, sqrt(3)/2);
}

#[test]
fn an_axis_out_of_reach_between_two_points_is_an_error() {
    let events = [tool(1), spindle(), feed([9.0, 0.0, 0.0], cb(0.0, 50.0)), feed([9.0, 5.0, 0.0], cb(180.0, 50.0))];
    let mut config = config();
    config.retract.distance = Some(20.0);
    let run = run::<Leaning>(&config, &events);
    assert_eq!(run.error().location.line, 4);
    assert!(run.error().text.starts_with("on the way from the point before: "), "{}", run.error().text);
    let beside = [tool(1), spindle(), feed([9.0, 0.0, 0.0], cb(0.0, 50.0)), feed([9.0, 5.0, 0.0], cb(50.0, 50.0))];
    assert_eq!(self::run::<Leaning>(&config, &beside).diagnostics, []);
}

#[test]
fn a_rapid_below_everything_that_was_cut_is_remarked_on() {
    let to = |depth| {
        let cut =
            [tool(1), spindle(), feed([0.0, 0.0, -2.0], UP), feed([0.0, 0.0, 5.0], UP), rapid([9.0, 0.0, 5.0], UP)];
        let mut events = cut.to_vec();
        events.push(rapid([9.0, 0.0, depth], UP));
        run::<Xyz>(&config(), &events).diagnostics.len()
    };
    assert_eq!((to(-2.0), to(-2.1)), (0, 1));
}

#[test]
fn a_tool_that_is_called_again_keeps_the_length_that_was_given_once() {
    let call = |length| Event::Tool(ToolCall { number: 1, length, ..ToolCall::default() });
    let events = |again| {
        let out = |x| feed([x, 0.0, 60.0], UP);
        [call(Some(120.0)), spindle(), feed([0.0; 3], UP), out(0.0), call(again), feed([0.0; 3], UP), out(0.0)]
    };
    assert_eq!(run::<Head>(&config(), &events(None)).diagnostics, []);
    assert!(run::<Head>(&config(), &events(Some(121.0))).error().text.contains("two lengths"));
}

#[test]
fn the_first_pose_counts_from_the_pose_of_from() {
    let first = feed([10.0, 0.0, 0.0], cb(170.0, 4.0));
    let chosen = |events: &[Event<'_>]| {
        lines::<Cb>(&config(), events).into_iter().find(|line| line.starts_with("G0 B")).expect("rotaries")
    };
    // From zero the second branch turns less; from C 160 the first one does.
    assert_eq!(chosen(&[tool(1), spindle(), first]), "G0 B-4 C-10");
    assert_eq!(chosen(&[Event::From(pose([0.0; 3], cb(160.0, 50.0))), tool(1), spindle(), first]), "G0 B4 C170");
}

#[test]
fn a_rotary_limit_is_named_with_value_and_line() {
    let events = [tool(1), spindle(), feed([0.0; 3], cb(0.0, 100.0)), feed([0.0; 3], cb(0.0, 112.5))];
    let run = run::<Cb>(&config(), &events);
    let error = run.error();
    assert!(error.text.contains("B") && error.text.contains("112.5°"), "{error:?}");
    assert!(error.text.contains("-5.0000° to 110.0000°"), "{error:?}");
    assert_eq!(error.location.line, 4);
    assert!(error.help.is_some());
}

#[test]
fn an_axis_is_turned_back_a_whole_turn_out_of_the_part() {
    let mut config = config();
    config.limits.insert('C', Some(crate::kinematics::Limits { lower: -3.2, upper: 3.2 }));
    let at = |angle: f64, feed: bool| {
        let pose = pose([10.0, 0.0, 0.0], cb(angle, 30.0));
        Event::Move(Move { pose, rapid: !feed, feed: Some(Feed::PerMinute(100.0)) })
    };
    let events = |last| [tool(1), spindle(), at(170.0, true), at(183.0, true), last];
    let cut = run::<Cb>(&config, &events(at(186.0, true)));
    assert!(cut.error().text.contains("have to be rewound"), "{:?}", cut.error());
    assert_eq!(run::<Cb>(&config, &events(at(186.0, false))).diagnostics, []);
    config.retract.distance = Some(20.0);
    let cut = run::<Cb>(&config, &events(at(186.0, true)));
    assert_eq!(cut.statistics.rewinds, 1);
    assert!(cut.diagnostics[0].text.contains("unavoidable within C -183.3465° to 183.3465°"), "{:?}", cut.diagnostics);
    // Begun a whole turn lower there would be no need.
    config.limits.insert('C', Some(crate::kinematics::Limits { lower: -3.5, upper: 3.2 }));
    assert_eq!(run::<Cb>(&config, &events(at(186.0, true))).diagnostics, []);
}

#[test]
fn a_rewind_never_begins_by_going_down_to_the_clearance() {
    let mut config = config();
    config.limits.insert('C', Some(crate::kinematics::Limits { lower: -3.2, upper: 3.2 }));
    let plane = Plane { normal: Vector3::z_axis(), distance: 30.0 };
    let mut events = vec![tool(1), spindle(), Event::ClearancePlane(plane)];
    events.extend([170.0, 183.0, 186.0].map(|angle| feed([10.0, 0.0, 60.0], cb(angle, 30.0))));
    let run = run::<Cb>(&config, &events);
    assert_eq!(run.statistics.rewinds, 1);
    let rewound = run.lines.iter().rposition(|line| line.starts_with("G0 C")).expect("a rewind");
    // At G94 straight to the machine retract.
    assert_eq!(run.lines[rewound - 2..rewound], ["G94", "G53 G0 Z0"], "{}", run.text());
}

#[test]
fn only_the_rapid_that_turns_an_axis_is_cut_into_short_ways() {
    let mut config = config();
    config.wrap.insert('C', Wrap::Positive);
    config.limits.insert('B', Some(crate::kinematics::Limits { lower: 0.0, upper: 2.0 }));
    config.retract.distance = Some(20.0);
    let events = [
        tool(1),
        spindle(),
        feed([0.0, 0.0, -80.0], cb(0.0, 30.0)),
        feed([10.0, 0.0, -80.0], cb(0.0, 30.0)),
        rapid([10.0, 0.0, 60.0], cb(180.0, 30.0)),
        feed([10.0, 0.0, 50.0], cb(180.0, 30.0)),
    ];
    let lines = lines::<Cb>(&config, &events);
    let turned = lines.iter().position(|line| line == "C180").expect("the second half of the turn");
    assert_eq!(lines[turned - 1], "G0 C90");
    // No block on the way down that counts from where the tool was in the cut.
    let down: Vec<&str> = lines[turned + 1..turned + 4].iter().map(|line| &line[..1]).collect();
    assert_eq!(down, ["X", "Z", "Z"], "{lines:?}");
}

#[test]
fn the_table_turns_for_a_cut_from_the_pole_where_the_operation_begins() {
    let mut config = config();
    config.retract.distance = Some(20.0);
    let events = [
        tool(1),
        spindle(),
        rapid([0.0, 0.0, 50.0], UP),
        rapid([0.0, 0.0, 5.0], UP),
        feed([0.0; 3], UP),
        feed([10.0, 0.0, 0.0], UP),
        feed([20.0, 0.0, 0.0], cb(90.0, 20.0)),
    ];
    let run = run::<Cb>(&config, &events);
    assert_eq!((run.statistics.sequences, run.statistics.rewinds), (1, 0), "{}", run.text());
    assert!(run.lines.contains(&"G0 B0 C90".to_owned()), "{}", run.text());
}

#[test]
fn a_free_axis_stands_inside_limits_that_exclude_zero() {
    let mut config = config();
    config.limits.insert('C', Some(crate::kinematics::Limits { lower: 0.5, upper: 6.0 }));
    let lines = lines::<Cb>(&config, &[tool(1), spindle(), feed([0.0; 3], UP), feed([10.0, 0.0, 0.0], UP)]);
    assert!(lines.contains(&"G0 B0 C28.6479".to_owned()), "{lines:?}");
}

#[test]
fn first_and_second_pass_count_from_the_same_place() {
    let mut config = config();
    config.limits.insert('B', Some(crate::kinematics::Limits { lower: -1.2, upper: 1.8 }));
    config.limits.insert('C', Some(crate::kinematics::Limits { lower: -5.2, upper: 5.2 }));
    let events = [
        Event::From(pose([0.0, 0.0, 100.0], cb(100.0, 20.0))),
        // Not written, for there is no tool; the table keeps its value at the pole.
        rapid([0.0, 0.0, 90.0], UP),
        tool(1),
        spindle(),
        feed([0.0; 3], cb(-60.0, 30.0)),
        feed([0.0; 3], cb(-60.0, 80.0)),
    ];
    // From C100 the branch with B- is nearer, which does not tilt as far.
    let run = run::<Cb>(&config, &events);
    assert!(run.diagnostics.iter().all(|found| found.severity == Severity::Warning), "{:?}", run.diagnostics);
    assert!(run.lines.contains(&"G0 B30 C-60".to_owned()), "{}", run.text());
}

#[test]
fn a_direct_operation_has_its_speed_before_the_course_cuts_for_it() {
    let mut config = config();
    config.transition = Transition::Direct;
    config.retract.distance = Some(20.0);
    let limit = 180_f64.to_radians();
    config.limits.insert('C', Some(crate::kinematics::Limits { lower: -limit, upper: limit }));
    let events = [
        tool(1),
        spindle(),
        feed([10.0, 0.0, 0.0], cb(160.0, 30.0)),
        feed([10.0, 0.0, 0.0], cb(170.0, 30.0)),
        Event::Operation(b"NEXT"),
        Event::Spindle(Spindle::On { speed: Some(3000.0), rotation: Some(Rotation::Clockwise) }),
        Event::Coolant(Coolant::Flood),
        // The table reaches its limit on the way.
        feed([10.0, 0.0, 0.0], cb(190.0, 30.0)),
    ];
    let on = run::<Cb>(&config, &events);
    assert_eq!(on.statistics.rewinds, 1, "{:?} {}", on.diagnostics, on.text());
    let next = on.lines.iter().position(|line| line == "(OPERATION NEXT)").expect("the operation");
    assert_eq!(on.lines[next + 1..next + 3], ["S3000 M3", "M8"], "{}", on.text());
    // With the spindle off nothing is cut on the way either.
    let mut off = events;
    off[5] = Event::Spindle(Spindle::Off);
    let off = run::<Cb>(&config, &off);
    assert!(off.error().text.contains("with the spindle off"), "{:?}", off.error());
    assert_eq!(off.lines[next + 1..], ["M5"], "{}", off.text());
}

#[test]
fn on_request_a_rewind_leaves_the_tip_in_place() {
    let mut config = config();
    config.limits.insert('C', Some(crate::kinematics::Limits { lower: -3.2, upper: 3.2 }));
    config.retract.rewind = crate::config::Rewind::Follow;
    let at = |angle: f64| feed([10.0, 0.0, 0.0], cb(angle, 30.0));
    let run = run::<Cb>(&config, &[tool(1), spindle(), at(170.0), at(183.0), at(186.0)]);
    assert_eq!(run.statistics.rewinds, 1);
    assert!(run.diagnostics.len() == 1 && run.diagnostics[0].text.contains("swings about it"), "{:?}", run.diagnostics);
    let machine = config.machine::<Cb>().expect("valid");
    let mut axes = [0.0; 5];
    let mut turned = 0.0_f64;
    for line in run.lines.iter().skip_while(|line| !line.starts_with("G93")).take_while(|line| *line != "G94") {
        for word in line.split(' ') {
            let Some(index) = "CBXYZ".find(&word[..1]) else { continue };
            let value: f64 = word[1..].parse().expect("a number");
            axes[index] = if index < 2 { value.to_radians() } else { value };
        }
        let tip = machine.forward_kinematics(&axes).tip;
        assert!((tip - Point3::new(10.0, 0.0, 0.0)).norm() < 1e-3, "{line}: {tip}");
        turned = turned.min(axes[0]);
    }
    assert!(turned < -3.0, "{}", run.text());
}

#[test]
fn an_operation_begins_in_the_branch_and_turn_that_last() {
    let rotaries = |config: &Config, poses: &[[f64; 3]]| {
        let mut events = vec![tool(1), spindle()];
        events.extend(poses.iter().map(|&axis| feed([0.0; 3], axis)));
        let run = run::<Cb>(config, &events);
        assert!(run.diagnostics.iter().all(|found| found.severity == Severity::Warning), "{:?}", run.diagnostics);
        run.lines.into_iter().find(|line| line.starts_with("G0 B")).expect("rotaries")
    };
    // Alone, C-10 B-4 is nearer; the tilt of 60 degrees needs the other branch.
    let tilting = [cb(170.0, 4.0), cb(170.0, 30.0), cb(170.0, 60.0)];
    assert_eq!(rotaries(&config(), &tilting[..1]), "G0 B-4 C-10");
    assert_eq!(rotaries(&config(), &tilting), "G0 B4 C170");
    // From the vertical the table has to stand right before the tilt begins, yet only if it matters.
    assert_eq!(rotaries(&config(), &[UP, cb(180.0, 3.0), cb(180.0, 30.0)]), "G0 B0 C180");
    assert_eq!(rotaries(&config(), &[UP, cb(0.0, 3.0), cb(0.0, 30.0)]), "G0 B0 C0");
    // 160 to 320 degrees do not fit below 200: begin at -200.
    let mut limited = config();
    let limit = 200_f64.to_radians();
    limited.limits.insert('C', Some(crate::kinematics::Limits { lower: -limit, upper: limit }));
    let turning: Vec<_> = (0..=80).map(|step| cb(160.0 + 2.0 * f64::from(step), 30.0)).collect();
    assert_eq!(rotaries(&limited, &turning), "G0 B30 C-200");
    assert_eq!(rotaries(&limited, &turning[..10]), "G0 B30 C160");
}

#[test]
fn a_branch_is_changed_at_the_vertical_only() {
    let tilts = |from: i32, to: i32| {
        let mut events = vec![tool(1), spindle()];
        events.extend((from..=to).map(|tilt| feed([0.0; 3], cb(0.0, f64::from(-tilt)))));
        run::<Cb>(&config(), &events)
    };
    // B goes down to -5 and not further: C turns where B is 0.
    let short = tilts(-20, 5);
    assert_eq!(short.diagnostics, []);
    assert!(!short.lines.iter().any(|line| line.contains("C180")), "{}", short.text());
    let through = tilts(-20, 20);
    assert_eq!(through.diagnostics, []);
    let turn = through.lines.iter().position(|line| line.contains("C180")).expect("a turn");
    assert!(through.lines[turn - 1].contains("B0") && !through.lines[turn].contains('B'), "{}", through.text());
    // Beside the vertical nothing helps.
    let mut limited = config();
    let limit = |angle: f64| angle.to_radians();
    limited.limits.insert('C', Some(crate::kinematics::Limits { lower: limit(-60.0), upper: limit(60.0) }));
    let past = [cb(-50.0, 20.0), cb(-70.0, 20.0)].map(|axis| feed([0.0; 3], axis));
    let past = run::<Cb>(&limited, &[tool(1), spindle(), past[0], past[1]]);
    assert!(past.error().text.contains("C would have to turn to -70°"), "{:?}", past.error());
}

#[test]
fn an_axis_out_of_reach_is_told_in_the_words_of_the_machine() {
    let run = run::<Xyz>(&config(), &[tool(1), spindle(), feed([0.0; 3], [0.1, 0.0, 1.0])]);
    assert!(run.error().text.contains("Xyz has no rotary axis to tilt the tool"), "{:?}", run.error());
}

#[test]
fn linear_limits_are_machine_coordinates_that_count_the_gauge_length() {
    let mut config = config();
    config.machine_zero.insert('Z', -200.0);
    config.approach.distance = 10.0;
    config.tools.insert(1, Tool { length: Some(100.0), ..Tool::default() });
    let events = |z| [tool(1), spindle(), feed([0.0, 0.0, z], UP)];
    // -200 + z + 100 >= -300, and the approach point stays below Z0.
    assert_eq!(run::<Xyz>(&config, &events(-200.0)).diagnostics, []);
    let low = run::<Xyz>(&config, &events(-200.001));
    assert!(low.error().text.contains("-300.001 mm (machine coordinate)"), "{:?}", low.error());
    assert_eq!(run::<Xyz>(&config, &events(90.0)).diagnostics, []);
    assert!(run::<Xyz>(&config, &events(90.001)).error().text.contains("approach"));
    // Lower retract position: the approach point must not lie above it.
    config.retract.position = -50.0;
    assert!(run::<Xyz>(&config, &events(45.0)).error().text.contains("above the retract position"));
    assert_eq!(run::<Xyz>(&config, &events(40.0)).diagnostics, []);
}

#[test]
fn without_machine_zero_only_the_span_is_compared_with_the_travel() {
    let events = |x| [tool(1), spindle(), feed([1000.0, 0.0, 0.0], UP), feed([1000.0 + x, 0.0, 0.0], UP)];
    assert_eq!(run::<Xyz>(&config(), &events(400.0)).diagnostics, []);
    let wide = run::<Xyz>(&config(), &events(400.001));
    assert!(wide.error().text.contains("400.001 mm of X travel"), "{:?}", wide.error());
}

#[test]
fn words_of_a_tilted_program_put_the_tip_within_half_a_unit_for_the_written_angles() {
    fn check<M: Machine>(config: &Config, axes: impl Fn(f64) -> [f64; 3]) {
        let mut events = vec![tool(1), spindle()];
        let mut wanted = Vec::new();
        for step in 0..200 {
            let t = f64::from(step) / 200.0;
            let tip = [40.0 * t, 13.0 * (3.0 * t).sin(), 5.0 * (7.0 * t).cos()];
            wanted.push(tip);
            events.push(feed(tip, axes(t)));
        }
        let run = run::<M>(config, &events);
        assert_eq!(run.diagnostics, []);
        let mut machine = config.machine::<M>().expect("valid");
        machine.set_up(config.part_origin.into(), config.tools[&1].length.unwrap_or(0.0));
        let mut axes = M::HELD;
        let mut checked = 0;
        for line in run.lines.iter().filter(|line| !line.starts_with(['(', 'N', 'o']) && !line.contains("G53")) {
            let mut moved = false;
            for word in line.split(' ') {
                if let Some(index) = M::AXES.iter().position(|axis| word.starts_with(axis.letter)) {
                    let value: f64 = word[1..].parse().expect("a number");
                    let rotary = M::AXES[index].kind == AxisKind::Rotary;
                    axes.as_mut()[index] = if rotary { value.to_radians() } else { value };
                    moved = true;
                }
            }
            if moved && checked < wanted.len() {
                // Linear words for these very angles, computed without rounding.
                let exact = machine.linear_axes(&Point3::from(wanted[checked]), &axes).expect("regular");
                let off = |index: usize| (exact.as_ref()[index] - axes.as_ref()[index]).abs();
                let near = (0..M::AXES.len()).all(|index| off(index) <= 0.000_5 + 1e-9);
                // The blocks of the approach come first.
                if near {
                    checked += 1;
                    let tip = machine.forward_kinematics(&axes).tip;
                    assert!((tip - Point3::from(wanted[checked - 1])).norm() <= 0.000_9);
                } else {
                    assert_eq!(checked, 0, "block {line} is off");
                }
            }
        }
        assert_eq!(checked, wanted.len());
    }
    let mut config = with_lengths(Some(10.0));
    config.part_origin = [3.0, -2.0, 50.0];
    config.tools.insert(1, Tool { length: Some(123.456), ..Tool::default() });
    check::<Cb>(&config, |t| cb(300.0 * t, 10.0 + 50.0 * t));
    check::<Head>(&config, |t| [0.5 * t, 0.3 * (5.0 * t).sin(), 1.0]);
    check::<Ay>(&config, |t| [0.0, 0.5 * (6.0 * t).sin(), 1.0]);
}

#[test]
fn words_in_inches_are_ten_thousandths() {
    let mut config = config();
    config.output_units = Some(Units::Inches);
    let lines = lines::<Xyz>(&config, &[tool(1), spindle(), feed([25.4, 12.7, 1.0], UP)]);
    assert!(lines[0].starts_with("N1 G20 "));
    assert_eq!(lines[7..10], ["G0 X1 Y0.5", "Z2.0079", "G1 Z0.0394 F19.685"]);
}

#[test]
fn coolant_that_the_control_has_no_code_for_is_refused() {
    let events = [tool(1), spindle(), Event::Coolant(Coolant::Through), feed([0.0; 3], UP)];
    assert!(run::<Xyz>(&config(), &events).error().text.contains("no code for coolant through the spindle"));
}

#[test]
fn what_stands_between_the_first_motion_and_the_second_keeps_its_order() {
    let events = [
        tool(1),
        rapid([0.0, 0.0, 9.0], UP),
        Event::Message(b"LOOK"),
        spindle(),
        Event::Coolant(Coolant::Flood),
        feed([0.0, 0.0, 1.0], UP),
    ];
    let lines = lines::<Xyz>(&config(), &events);
    let message = lines.iter().position(|line| line == "(LOOK)").expect("the message");
    assert_eq!(lines[message - 1..message + 4], ["Z9", "(LOOK)", "S8000 M3", "M8", "G1 Z1 F500"]);
}

#[test]
fn the_program_is_the_same_each_time() {
    let events: Vec<_> = [tool(1), spindle()]
        .into_iter()
        .chain((0..50).map(|i| feed([f64::from(i), 0.0, 0.0], cb(f64::from(i) * 7.0, 30.0))))
        .collect();
    assert_eq!(lines::<Cb>(&config(), &events), lines::<Cb>(&config(), &events));
}

#[test]
fn blocks_of_the_sequence_lie_on_the_tool_axis_within_one_unit() {
    let axis = [0.3, -0.4, 0.8];
    let config = with_lengths(Some(33.0));
    let events = [tool(1), spindle(), feed([7.0, 8.0, -9.0], axis), feed([8.0, 8.0, -9.0], axis)];
    let lines = lines::<Head>(&config, &events);
    let mut machine = config.machine::<Head>().expect("valid");
    machine.set_up(Vector3::zeros(), 100.0);
    let mut axes = Head::HELD;
    let mut tips = Vec::new();
    for line in lines.iter().filter(|line| !line.starts_with(['(', 'N', 'o']) && !line.contains("G53")) {
        for word in line.split(' ') {
            let Some(index) = Head::AXES.iter().position(|axis| word.starts_with(axis.letter)) else { continue };
            let value: f64 = word[1..].parse().expect("a number");
            axes[index] = if index > 2 { value.to_radians() } else { value };
        }
        tips.push((line.as_str(), machine.forward_kinematics(&axes).tip));
    }
    let wanted = pose([0.0; 3], axis).axis;
    let near = |place: usize, tip: [f64; 3], along: f64| {
        let (line, found) = tips[tips.len() - place];
        let off = found - (Point3::from(tip) + wanted.into_inner() * along);
        // Half a unit in each of three axes, and the rounding of the angles over the length.
        assert!(off.norm() < 0.000_9 + along * 2e-6, "{line} is {} mm off", off.norm());
    };
    // Approach point, first point, second point, out; M5 moves nothing.
    near(5, [7.0, 8.0, -9.0], 50.0);
    near(4, [7.0, 8.0, -9.0], 0.0);
    near(3, [8.0, 8.0, -9.0], 0.0);
    near(2, [8.0, 8.0, -9.0], 33.0);
}

#[test]
fn points_of_the_sequence_keep_the_limits_too() {
    let mut config = with_lengths(Some(500.0));
    config.machine_zero.insert('Z', -300.0);
    let up = run::<Cb>(&config, &[tool(1), spindle(), feed([0.0; 3], UP)]);
    assert!(
        up.error().text.contains("`retract.distance` = 500 mm: Z would have to go to 300.000 mm"),
        "{:?}",
        up.error()
    );
    config.retract.distance = None;
    config.retract.position = 1.0;
    let above = run::<Cb>(&config, &[tool(1), spindle(), feed([0.0; 3], UP)]);
    assert!(above.error().text.contains("machine coordinate 1.000 mm"), "{:?}", above.error());
    config.retract.position = 0.0;
    config.park.insert('B', 2.0);
    let parked = run::<Cb>(&config, &[tool(1), spindle(), feed([0.0; 3], UP)]);
    assert!(parked.error().text.contains("B would have to turn to 114.5916°"), "{:?}", parked.error());
}

#[test]
fn axes_park_one_after_the_other_with_the_retract_axis_last() {
    let mut config = config();
    for (letter, value) in [('B', 0.0), ('X', -100.0), ('Y', 200.0), ('Z', -5.0)] {
        config.park.insert(letter, value);
    }
    let lines = lines::<Cb>(&config, &[tool(1), spindle(), feed([0.0; 3], cb(0.0, 20.0))]);
    assert_eq!(lines[lines.len() - 5..], ["G53 G0 Z0", "M5", "G0 B0", "G53 G0 X-100 Y200", "G53 G0 Z-5"]);
}

#[test]
fn tool_axes_just_out_of_reach_are_counted_with_the_largest() {
    let events = [
        tool(1),
        spindle(),
        feed([0.0; 3], UP),
        feed([1.0, 0.0, 0.0], [5e-7, 0.0, 1.0]),
        feed([2.0, 0.0, 0.0], [2e-7, 0.0, 1.0]),
    ];
    let run = run::<Ay>(&config(), &events);
    assert_eq!((run.diagnostics.len(), run.statistics.deviations), (0, 2));
    assert!((run.statistics.largest_deviation - 5e-7).abs() < 1e-12);
}

#[test]
fn a_tool_that_is_called_again_without_its_offset_register_keeps_it() {
    let call = |offset| Event::Tool(ToolCall { number: 1, offset, ..ToolCall::default() });
    let cut = feed([0.0, 0.0, 0.0], UP);
    let events = [call(Some(5)), spindle(), cut, call(None), cut, call(Some(1)), cut, call(None), cut];
    let lines = lines::<Xyz>(&config(), &events);
    let offsets: Vec<_> = lines.iter().filter(|line| line.starts_with("G43")).collect();
    assert_eq!(offsets, ["G43 H5", "G43 H5", "G43 H1", "G43 H1"]);
}

#[test]
fn without_stop_retract_a_head_leaves_the_part_along_the_tool_all_the_same() {
    let tilted = [1.0, 0.0, 1.0];
    let events = [tool(1), spindle(), feed([0.0; 3], tilted), Event::Stop, feed([9.0, 0.0, 0.0], tilted)];
    let mut config = with_lengths(Some(20.0));
    config.stop_retract = false;
    let lines = lines::<Head>(&config, &events);
    let stop = lines.iter().position(|line| line == "M0").expect("a stop");
    assert!(lines[stop - 2].starts_with("G1 ") && lines[stop - 1].starts_with("G0 X"), "{lines:#?}");

    config.retract.distance = None;
    let run = run::<Head>(&config, &events);
    assert_eq!(run.error().location.line, 4, "{}", run.text());
    assert!(!run.text().contains("M0"), "{}", run.text());
}

#[test]
fn the_speed_of_one_tool_is_never_that_of_another() {
    let on = Event::Spindle(Spindle::On { speed: None, rotation: None });
    let cut = feed([0.0, 0.0, 0.0], UP);
    // Turned off and on again in the start in which the tool changes, and given to a tool that never moves.
    let again = [tool(1), spindle(), cut, Event::Stop, Event::Spindle(Spindle::Off), tool(2), on, cut];
    let skipped = [tool(1), spindle(), tool(2), cut];
    for events in [&again[..], &skipped] {
        let run = run::<Xyz>(&config(), events);
        assert!(run.error().text.contains("without spindle speed"), "{}", run.text());
    }
    // In front of the tool record it is meant for that tool, and the same tool keeps its own.
    lines::<Xyz>(&config(), &[tool(1), spindle(), cut, Event::Stop, spindle(), tool(2), cut]);
    lines::<Xyz>(&config(), &[tool(1), spindle(), tool(1), cut]);
}

#[test]
fn the_table_turns_where_the_tool_passes_the_vertical_between_two_points() {
    let events = [
        tool(1),
        spindle(),
        feed([0.0; 3], cb(0.0, 20.0)),
        feed([10.0, 0.0, 0.0], cb(0.0, 10.0)),
        feed([20.0, 0.0, 0.0], cb(0.0, -20.0)),
    ];
    let mut config = config();
    config.index_angle = 360_f64.to_radians();
    let run = run::<Cb>(&config, &events);
    assert_eq!(run.diagnostics, [], "{}", run.text());
    let end = turns_alone('C', 'B', "C180", &run.lines);
    assert!(run.lines[end..].iter().any(|line| line.contains("B20")), "{}", run.text());
    assert!(run.lines[end + 1..].iter().all(|line| !line.contains('C')), "{}", run.text());
}

#[test]
fn a_linear_axis_that_f_does_not_count_along_is_fed_in_inverse_time() {
    let events = [tool(1), spindle(), feed([0.0; 3], UP), feed([0.01, 0.0, -10.0], UP)];
    let lines = lines::<Xyw>(&config(), &events);
    assert!(lines.contains(&"X0.01 W-10 F50".to_owned()), "{lines:#?}");
    assert!(lines.iter().any(|line| line.starts_with("G93 G1 W0")), "{lines:#?}");
}

#[test]
fn a_retract_position_at_the_part_end_of_the_travel_is_refused() {
    let mut config = config();
    config.limits.insert('Z', Some(crate::kinematics::Limits { lower: 0.0, upper: 500.0 }));
    let events = [tool(1), spindle(), feed([0.0; 3], UP)];
    let run = run::<Xyz>(&config, &events);
    assert_eq!(
        run.error().text,
        "the retract position Z = 0 mm (machine coordinate) is the end of the travel at the part"
    );
    config.retract.position = 500.0;
    lines::<Xyz>(&config, &events);
}

#[test]
fn the_spindle_stops_behind_the_way_out_and_only_once() {
    let mut config = config();
    config.retract.distance = Some(20.0);
    let cut = [tool(1), spindle(), feed([0.0, 0.0, 0.0], UP), feed([5.0, 0.0, 0.0], UP), Event::Spindle(Spindle::Off)];
    let end = |events: &[Event<'_>]| {
        let lines = lines::<Xyz>(&config, events);
        let out = lines.iter().position(|line| line == "G0 Z20").expect("the way out");
        lines[out + 1..].to_vec()
    };
    assert_eq!(end(&cut), ["G53 G0 Z0", "M5"]);
    let stopped: Vec<_> = cut.iter().copied().chain([Event::Stop]).collect();
    assert_eq!(end(&stopped)[..3], ["G53 G0 Z0", "M5", "M0"]);
    let changed: Vec<_> = cut.iter().copied().chain([tool(2), spindle(), feed([9.0, 0.0, 0.0], UP)]).collect();
    assert_eq!(end(&changed)[1..5], ["M9", "G53 G0 Z0", "M5", "T2 M6"]);
}

#[test]
fn a_spindle_that_is_off_stops_before_the_next_rapid_and_refuses_the_next_feed() {
    let off = |next| {
        let events = [tool(1), spindle(), feed([0.0, 0.0, 0.0], UP), Event::Spindle(Spindle::Off), next];
        run::<Xyz>(&config(), &events)
    };
    let rapid = off(rapid([5.0, 0.0, 50.0], UP)).lines;
    let stop = rapid.iter().position(|line| line == "M5").expect("stopped");
    assert_eq!(rapid[stop + 1], "G0 X5 Z50");
    assert!(off(feed([5.0, 0.0, 0.0], UP)).diagnostics[0].text.contains("spindle off"));
}

#[test]
fn a_rotary_that_is_free_at_the_start_turns_before_the_cut_and_not_in_it() {
    let mut config = config();
    config.limits.insert('B', Some(Limits { lower: -0.1, upper: 1.9 }));
    let events = [
        tool(1),
        spindle(),
        feed([10.0, 0.0, 0.0], UP),
        feed([9.0, 0.0, 0.0], cb(35.0, 4.0)),
        feed([8.0, 0.0, 0.0], cb(36.0, 8.0)),
    ];
    let lines = run::<Cb>(&config, &events).lines;
    assert!(lines.iter().any(|line| line == "G0 B0 C35"), "{lines:?}");
    let leaving = lines.iter().find(|line| line.contains("B4")).expect("the block that leaves the pole");
    assert!(!leaving.contains('C'), "{leaving}");
}

#[test]
fn gohome_retracts_and_parks_or_is_refused() {
    let events = [tool(1), spindle(), feed([0.0; 3], UP), Event::Home, feed([1.0, 0.0, 0.0], UP)];
    assert!(run::<Cb>(&config(), &events).error().text.contains("neither `park` nor `retract.position`"));
    let mut config = config();
    config.park.insert('B', 0.5);
    let lines = lines::<Cb>(&config, &events);
    let home = lines.iter().position(|line| line == "G0 B28.6479").expect("parked");
    assert_eq!(lines[home - 1], "G53 G0 Z0");
    assert!(lines[home + 1].starts_with("N2 G21"), "{lines:?}");
}

#[test]
fn the_first_turn_behind_gohome_counts_from_where_the_axes_were_parked() {
    let turned = |wrap: Option<Wrap>, before: f64, behind: f64| -> Vec<String> {
        let mut config = config();
        config.park.insert('C', 0.0);
        config.wrap.extend(wrap.map(|wrap| ('C', wrap)));
        let point = |c: f64| feed([10.0, 0.0, 60.0], cb(c, 30.0));
        let lines = lines::<Cb>(&config, &[tool(1), spindle(), point(before), Event::Home, point(behind)]);
        let words = lines.iter().flat_map(|line| line.split(' ')).filter(|word| word.starts_with('C'));
        words.map(str::to_owned).collect()
    };
    assert_eq!(turned(None, 170.0, -170.0), ["C170", "C0", "C-170", "C0"]);
    assert_eq!(turned(Some(Wrap::Symmetric), 170.0, -170.0), ["C170", "C0", "C-170", "C0"]);
    // Not in two pieces, as from 170 it would have to be.
    assert_eq!(turned(Some(Wrap::Positive), 170.0, -10.0), ["C170", "C0", "C350", "C0"]);
    // The sign says the way.
    assert_eq!(turned(Some(Wrap::Sign), 170.0, -170.0), ["C170", "C-360", "C-190", "C0"]);
}

#[test]
fn from_behind_gohome_does_not_move_what_has_been_parked() {
    let mut config = config();
    config.park.insert('C', 0.0);
    let from = Event::From(pose([0.0; 3], cb(170.0, 30.0)));
    let events = [tool(1), Event::Home, from, spindle(), feed([10.0, 0.0, 60.0], cb(-170.0, 30.0))];
    let lines = lines::<Cb>(&config, &events);
    assert!(lines.contains(&"G0 B30 C-170".to_owned()), "{lines:?}");
}

#[test]
fn nc_text_and_codes_leave_nothing_in_force() {
    for (event, block) in [(Event::Insert(b"G0 X5"), "G0 X5"), (Event::Code { letter: b'M', number: 10 }, "M10")] {
        let events = [tool(1), spindle(), feed([0.0; 3], UP), event, feed([0.0, 0.0, 1.0], UP)];
        let lines = lines::<Cb>(&config(), &events);
        let at = lines.iter().position(|line| line == block).expect("as it stands");
        assert!(lines[at + 1].starts_with("N2 G21 G17 G40"), "{lines:?}");
        assert!(lines[at..].iter().any(|line| line == "S8000 M3"));
    }
}

#[test]
fn nc_text_that_is_not_ascii_is_refused() {
    for text in [&b"G0 X\xff"[..], b"G0\tX1", b""] {
        let events = [tool(1), spindle(), feed([0.0; 3], UP), Event::Insert(text)];
        assert!(run::<Cb>(&config(), &events).error().text.contains("not ASCII"));
    }
}

#[test]
fn cutter_compensation_is_refused() {
    let before = [tool(1), spindle(), feed([0.0; 3], UP)];
    let with = |event: Event<'static>| run::<Cb>(&config(), &[&before[..], &[event]].concat());
    assert!(with(Event::Compensation(Compensation::Left)).error().text.contains("CUTCOM"));
    assert_eq!(with(Event::Compensation(Compensation::Off)).diagnostics, []);
}

#[test]
fn an_indexed_axis_stands_on_its_steps_and_never_turns_in_a_cut() {
    let mut config = config();
    config.grid.insert('C', 5_f64.to_radians());
    let with = |config: &Config, axes: &[[f64; 3]]| {
        let mut events = vec![tool(1), spindle()];
        events.extend(axes.iter().map(|&axis| feed([0.0; 3], axis)));
        run::<Cb>(config, &events)
    };
    let errors = |run: Run| run.diagnostics.iter().filter(|found| found.severity == Severity::Error).count();
    assert_eq!(errors(with(&config, &[cb(35.0, 30.0), cb(35.0, 40.0)])), 0);
    // What CL data rounds is no other direction.
    let rounded = with(&config, &[cb(35.000_03, 30.0)]);
    assert!(rounded.diagnostics.is_empty() && rounded.lines.contains(&"G0 B30 C35".to_owned()), "{}", rounded.text());
    let between = with(&config, &[cb(36.0, 30.0)]);
    assert!(between.error().text.contains("36°, between the steps of 5°"), "{:?}", between.error());
    let turning = with(&config, &[cb(35.0, 30.0), cb(40.0, 30.0)]);
    assert!(turning.error().text.contains("from 35° to 40° in the cut"), "{:?}", turning.error());
    config.axis_tolerance = 1_f64.to_radians();
    assert_eq!(with(&config, &[cb(36.0, 30.0)]).diagnostics, []);
}

#[test]
fn an_indexed_axis_stays_where_it_is_while_another_turns() {
    let mut config = config();
    config.grid.insert('B', 5_f64.to_radians());
    let around = |by: f64| {
        let mut events = vec![tool(1), spindle()];
        events.extend((0..=6).map(|step| feed([100.0, 0.0, 0.0], cb(by * f64::from(step), 30.0))));
        run::<Cb>(&config, &events)
    };
    // An even turn from one direction to the next would take B along, by 0.003 degrees.
    let near = around(2.0);
    assert_eq!(near.diagnostics, []);
    assert!(near.statistics.inserted > 0, "{}", near.text());
    assert_eq!(near.lines.iter().filter(|line| line.contains('B')).count(), 1, "{}", near.text());
    assert!(around(20.0).error().text.contains("in the cut, and it is indexed"));
}

#[test]
fn an_axis_tolerance_at_the_pole_is_none_of_the_path() {
    let mut config = config();
    config.axis_tolerance = 0.5_f64.to_radians();
    let beside = 0.4_f64.to_radians();
    let across = |tilt: f64| [tilt.to_radians().sin(), beside, tilt.to_radians().cos()];
    let mut events = vec![tool(1), spindle()];
    events.extend([-4.0, -2.0, 0.0, 2.0, 4.0].map(|tilt| feed([tilt, 0.0, 0.0], across(tilt))));
    let run = run::<Cb>(&config, &events);
    assert_eq!(run.diagnostics, [], "{}", run.text());
    assert_eq!(run.statistics.near_pole, 1);
    assert!((run.statistics.largest_at_pole - beside).abs() < 1e-4, "{:?}", run.statistics);
}

#[test]
fn a_spiral_of_forty_turns_is_written_within_a_turn() {
    let mut config = config();
    config.wrap.insert('A', Wrap::Positive);
    config.park.insert('A', 0.0);
    let axis = |degrees: f64| {
        let angle = degrees.to_radians();
        [0.0, -angle.sin(), angle.cos()]
    };
    let mut events = vec![tool(1), spindle()];
    let steps = 40 * 36;
    events
        .extend((0..=steps).map(|step| feed([f64::from(step) * 0.05, 0.0, 5.0], axis(f64::from(step) * 10.0 + 200.0))));
    let lines = lines::<Ay>(&config, &events);
    let word = |line: &String| line.split(' ').find_map(|word| word.strip_prefix('A')?.parse::<f64>().ok());
    let angles: Vec<f64> = lines.iter().filter_map(word).collect();
    assert!(angles.iter().all(|angle| (0.0..360.0).contains(angle)));
    let (mut here, mut turned) = (0.0, 0.0);
    for angle in angles {
        // The control goes the short way.
        let step = (angle - here + 540.0).rem_euclid(360.0) - 180.0;
        assert!(step.abs() < 180.0 - 1e-9, "{here} to {angle}");
        (here, turned) = (angle, turned + step);
    }
    // Forty turns, and from there to the nearest zero; there is no way back.
    assert!(
        (turned - (200.0_f64 - 360.0 + 40.0 * 360.0 + 160.0)).abs() < 1e-6 || (turned - 40.0 * 360.0).abs() < 1e-6,
        "{turned}"
    );
}

#[test]
fn a_rapid_that_indexes_is_not_written_as_a_feed_motion() {
    let config = Config { rapid: Rapid::Feed, rapid_feed: Some(9000.0), transition: Transition::Direct, ..config() };
    let tilted = cb(200.0, 100.0);
    let events = [
        tool(1),
        spindle(),
        feed([0.0; 3], cb(10.0, 100.0)),
        // As a path this would lead through B below its limit.
        rapid([0.0, 0.0, 50.0], tilted),
        rapid([0.0, 0.0, 20.0], tilted),
        feed([0.0; 3], tilted),
    ];
    let lines = lines::<Cb>(&config, &events);
    let indexed: Vec<&String> = lines.iter().filter(|line| line.starts_with("G0 ") && line.contains('C')).collect();
    assert!(indexed.len() == 2 && indexed[1].contains("C-160"), "{lines:?}");
    assert!(lines.iter().any(|line| line.ends_with("F9000")), "{lines:?}");
}

#[test]
fn a_rapid_is_written_as_the_configuration_wants_it() {
    let blocks = |rapid_mode: Rapid, to: [f64; 3]| {
        let config = Config { rapid: rapid_mode, rapid_feed: Some(9000.0), ..config() };
        let events = [tool(1), spindle(), feed([0.0; 3], UP), rapid(to, UP), feed([20.0, 0.0, -3.0], UP)];
        let lines = lines::<Cb>(&config, &events);
        let from = lines.iter().position(|line| line.starts_with("G1 Z0")).expect("the first point");
        lines[from + 1..lines.len() - 3].to_vec()
    };
    assert_eq!(blocks(Rapid::Direct, [20.0, 0.0, 5.0])[0], "G0 X20 Z5");
    assert_eq!(blocks(Rapid::Split, [20.0, 0.0, 5.0])[..2], ["G0 Z5", "X20"]);
    assert_eq!(blocks(Rapid::Split, [20.0, 0.0, -2.0])[..2], ["G0 X20", "Z-2"]);
    assert_eq!(blocks(Rapid::Split, [20.0, 0.0, 0.0])[0], "G0 X20");
    assert_eq!(blocks(Rapid::Feed, [20.0, 0.0, 5.0])[0], "X20 Z5 F9000");
}

#[test]
fn the_table_turns_the_way_that_rotabl_asks_for() {
    let after = |turning: Turning, last: Event<'static>| {
        let before = [tool(1), spindle(), feed([0.0; 3], cb(10.0, 30.0))];
        [&before[..], &[Event::Turning(turning), last, Event::Turning(Turning::Shortest)]].concat()
    };
    let rotaries = |config: &Config, turning| {
        let run = run::<Cb>(config, &after(turning, rapid([0.0; 3], cb(40.0, 30.0))));
        assert_eq!(run.diagnostics, []);
        run.lines.into_iter().rfind(|line| line.starts_with("G0 C") || line.starts_with("C")).expect("a turn")
    };
    assert_eq!(rotaries(&config(), Turning::Shortest), "G0 C40");
    assert_eq!(rotaries(&config(), Turning::Next(Rotation::Clockwise)), "G0 C40");
    assert_eq!(rotaries(&config(), Turning::Next(Rotation::CounterClockwise)), "G0 C-320");
    // Where the axis is limited, the sense leads to a state inside, or nowhere.
    let mut limited = config();
    limited.limits.insert('C', Some(crate::kinematics::Limits { lower: -6.0, upper: 1.0 }));
    assert_eq!(rotaries(&limited, Turning::Next(Rotation::CounterClockwise)), "G0 C-320");
    limited.limits.insert('C', Some(crate::kinematics::Limits { lower: -1.0, upper: 1.0 }));
    let events = after(Turning::Next(Rotation::CounterClockwise), rapid([0.0; 3], cb(40.0, 30.0)));
    assert!(run::<Cb>(&limited, &events).error().text.contains("leads out of the limits"));
    let events = after(Turning::Next(Rotation::CounterClockwise), feed([0.0; 3], cb(40.0, 30.0)));
    assert!(run::<Cb>(&config(), &events).error().text.contains("in front of a cut"));
    let events = after(Turning::Next(Rotation::CounterClockwise), rapid([0.0; 3], UP));
    assert!(
        run::<Head>(&with_lengths(Some(50.0)), &events).error().text.contains("no rotary axis stands in the table")
    );
}

#[test]
fn a_wait_is_written_in_seconds() {
    let wait = |dwell| {
        lines::<Cb>(
            &config(),
            &[tool(1), spindle(), feed([0.0; 3], UP), Event::Delay(dwell), feed([1.0, 0.0, 0.0], UP)],
        )
    };
    assert!(wait(Dwell::Seconds(2.5)).contains(&"G4 P2.5".to_owned()));
    assert!(wait(Dwell::Revolutions(400.0)).contains(&"G4 P3".to_owned()), "400 turns at 8000/min");
    let still = [tool(1), Event::Delay(Dwell::Revolutions(2.0))];
    assert!(run::<Cb>(&config(), &still).error().text.contains("the spindle does not turn"));
}

#[test]
fn a_frame_of_its_own_has_a_work_offset_of_its_own_where_no_table_turns() {
    let events = [tool(1), spindle(), feed([0.0; 3], UP), Event::Frame(2), feed([1.0, 0.0, 0.0], UP)];
    assert!(run::<Cb>(&config(), &events).error().text.contains("on a table that turns"));
    assert!(run::<Xyz>(&config(), &events).error().text.contains("frame 2 of the CL data has no work offset"));
    let mut config = config();
    config.frames.insert(2, "G55".to_owned());
    let lines = lines::<Xyz>(&config, &events);
    let safety: Vec<&String> = lines.iter().filter(|line| line.contains("G17")).collect();
    assert!(safety[0].contains("G54") && safety[1].contains("G55"), "{safety:?}");
    // The clearance plane stays behind: in the other frame it would be another plane.
    let plane = Plane { normal: Vector3::z_axis(), distance: 80.0 };
    let mut above = vec![Event::ClearancePlane(plane)];
    above.extend(events);
    above.extend([tool(2), feed([1.0, 0.0, 0.0], UP)]);
    let run = run::<Xyz>(&config, &above);
    assert_eq!(run.lines.iter().filter(|line| *line == "G0 Z80").count(), 1, "{:?}", run.lines);
}

#[test]
fn a_tool_leaves_to_the_clearance_plane() {
    let plane = Plane { normal: Vector3::z_axis(), distance: 80.0 };
    let events =
        [Event::ClearancePlane(plane), tool(1), spindle(), feed([0.0; 3], UP), tool(2), feed([1.0, 0.0, 0.0], UP)];
    let lines = run::<Cb>(&config(), &events).lines;
    assert!(lines.iter().any(|line| line == "G0 Z80"), "{lines:?}");
}

#[test]
fn another_machine_in_the_cl_data_is_remarked_on() {
    let events = [Event::MachineName(b"UNCX01"), tool(1), spindle(), feed([0.0; 3], UP)];
    let run = run::<Cb>(&config(), &events);
    assert!(run.diagnostics[0].text.contains("made for the machine `UNCX01`"), "{:?}", run.diagnostics);
}

#[test]
fn the_posted_length_is_guarded_where_it_matters() {
    let guards = |run: &Run| run.lines.iter().filter(|line| line.contains("#5403")).count();
    let events = [tool(1), spindle(), feed([0.0, 0.0, -80.0], UP), Event::Stop, feed([9.0, 0.0, -80.0], UP)];
    let mut config = with_lengths(Some(9.0));
    let head = run::<Head>(&config, &events);
    let at = head.lines.iter().position(|line| line == "G43 H1").expect("a length offset");
    assert!(head.lines[at + 1].starts_with("o1 if [[ABS[#5403 - 100] GT 0.01]"), "{}", head.text());
    assert!(head.lines.contains(&"o2 endif".to_owned()), "behind the stop again: {}", head.text());
    assert_eq!((guards(&head), guards(&run::<Cb>(&config, &events))), (2, 0));
    config.length_guard = Some(true);
    assert_eq!(guards(&run::<Cb>(&config, &events)), 2);
    config.length_guard = Some(false);
    assert_eq!(guards(&run::<Head>(&config, &events)), 0);
    config.length_guard = None;
    config.tools.insert(1, Tool { length: Some(100.0), offset: Some(21), ..Tool::default() });
    assert_eq!(guards(&run::<Head>(&config, &events)), 0, "the table of the tool says nothing about H21");
}

#[test]
fn in_a_dry_run_spindle_and_coolant_stay_off() {
    let events = [
        tool(1),
        spindle(),
        Event::Coolant(Coolant::Flood),
        feed([0.0, 0.0, -5.0], UP),
        Event::Spindle(Spindle::On { speed: Some(900.0), rotation: None }),
        feed([9.0, 0.0, -5.0], UP),
    ];
    let config = Config { lift: Some(50.0), spindle_dwell: 1.0, ..config() };
    let lines = lines::<Cb>(&config, &events);
    assert!(lines.iter().any(|line| line == "M5"), "{lines:?}");
    for code in ["M3", "M4", "M8", "M7", "G4 P"] {
        assert!(!lines.iter().any(|line| line.contains(code)), "{code} in {lines:?}");
    }
    let raw = run::<Cb>(&config, &[tool(1), spindle(), feed([0.0; 3], UP), Event::Insert(b"M3")]);
    assert!(raw.error().text.contains("a dry run writes no NC text"), "{}", raw.error().text);
}
