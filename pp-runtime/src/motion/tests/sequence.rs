//! The safe sequence: between operations, around stops and rewinds, to parking and home.

use super::*;

#[test]
fn two_tools_go_through_every_step_of_the_safe_sequence_one_block_each() {
    let events = [
        Event::NewStart(NewStart::Operation(b"ROUGH")),
        tool(1),
        spindle(),
        Event::Function(MachineFunction::Coolant(Coolant::Flood)),
        feed([10.0, 20.0, -1.0], UP),
        feed([30.0, 20.0, -1.0], UP),
        Event::NewStart(NewStart::Operation(b"FINISH")),
        tool(2),
        spindle(),
        feed([10.0, 0.0, 0.0], cb(90.0, 30.0)),
        feed([20.0, 0.0, 0.0], cb(90.0, 30.0)),
    ];
    let mut config = config();
    config.motion.spindle_dwell_s = 2.0;
    config.motion.park.insert('C', 0.0);
    config.motion.retract.distance_mm = Some(20.0);
    assert_eq!(
        lines::<Cb>(&config, &events),
        [
            "(OPERATION ROUGH)",
            "N1 G21 G8 G17 G40 G49 G80 G90 G91.1 G94 G97 G54 G64 P0.01",
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
            "N2 G21 G8 G17 G40 G49 G80 G90 G91.1 G94 G97 G54 G64 P0.01",
            "M9",
            "G53 G0 Z0",
            "M5",
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
        Event::Function(MachineFunction::Coolant(Coolant::Mist)),
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
fn a_first_rapid_is_reached_from_above_by_a_rapid_where_the_next_point_is_elsewhere() {
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
            "N2 G21 G8 G17 G40 G49 G80 G90 G91.1 G94 G97 G54 G64 P0.01",
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
        Event::Function(MachineFunction::Coolant(Coolant::Flood)),
        feed([0.0, 0.0, 0.0], UP),
        Event::Interruption(Interruption::Stop),
        feed([0.0, 0.0, 0.0], UP),
        Event::Interruption(Interruption::OptionalStop),
        feed([0.0, 0.0, 1.0], UP),
    ];
    let lines = lines::<Xyz>(&config(), &events);
    let stop = lines.iter().position(|line| line == "M0").expect("a stop");
    assert_eq!(lines[stop - 3..stop], ["M9", "G53 G0 Z0", "M5"]);
    assert_eq!(
        lines[stop + 1..stop + 11],
        [
            "N2 G21 G8 G17 G40 G49 G80 G90 G91.1 G94 G97 G54 G64 P0.01",
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
fn without_stop_retract_the_stop_is_alone() {
    let mut config = config();
    config.motion.stop_retract = false;
    let events = [
        tool(1),
        spindle(),
        feed([0.0, 0.0, 0.0], UP),
        Event::Interruption(Interruption::Stop),
        feed([0.0, 0.0, 0.0], UP),
    ];
    let lines = lines::<Xyz>(&config, &events);
    let stop = lines.iter().position(|line| line == "M0").expect("a stop");
    assert_eq!(lines[stop - 1], "G1 Z0 F500");
    assert_eq!(lines[stop + 3], "G53 G0 Z0");
}

#[test]
fn a_rapid_that_rotates_the_table_goes_through_the_sequence() {
    let events = [
        tool(1),
        spindle(),
        Event::Function(MachineFunction::Coolant(Coolant::Flood)),
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
fn a_rapid_that_rotates_less_than_the_index_angle_is_one_block() {
    let events = |angle: f64| {
        let tilted = cb(0.0, angle);
        [tool(1), spindle(), rapid([0.0; 3], UP), rapid([9.0, 0.0, 0.0], UP), rapid([5.0, 0.0, 0.0], tilted)]
    };
    assert_eq!(run::<Cb>(&config(), &events(1.0)).statistics.sequences, 1);
    assert_eq!(run::<Cb>(&config(), &events(1.001)).statistics.sequences, 2);
    let mut direct = config();
    direct.motion.rapids.transition = Transition::Direct;
    assert_eq!(run::<Cb>(&direct, &events(90.0)).statistics.sequences, 1);
}

#[test]
fn a_direct_transition_continues_from_the_end_of_the_operation_but_never_over_a_tool_change() {
    let mut direct = config();
    direct.motion.rapids.transition = Transition::Direct;
    let events = [
        tool(1),
        spindle(),
        feed([0.0, 0.0, 0.0], UP),
        Event::NewStart(NewStart::Operation(b"NEXT")),
        feed([5.0, 0.0, 0.0], UP),
        tool(2),
        spindle(),
        feed([6.0, 0.0, 0.0], UP),
    ];
    let lines = lines::<Xyz>(&direct, &events);
    let next = lines.iter().position(|line| line == "(OPERATION NEXT)").expect("the operation");
    assert_eq!(
        lines[next + 1..next + 7],
        ["X5", "N2 G21 G8 G17 G40 G49 G80 G90 G91.1 G94 G97 G54 G64 P0.01", "M9", "G53 G0 Z0", "M5", "T2 M6"]
    );
}

#[test]
fn a_head_needs_a_retract_along_the_tool() {
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
    assert!(near.diagnostics[0].text.contains("by only 20.000 mm"), "{:?}", near.diagnostics);
    // And back again does not count.
    assert!(
        run::<Head>(&with_lengths(None), &[tool(1), spindle(), out(0.0), out(60.0), out(50.0)]).diagnostics.len() == 1
    );
}

#[test]
fn a_retreat_of_the_cl_data_as_long_as_the_distance_is_not_repeated() {
    let mut config = config();
    config.motion.retract.distance_mm = Some(20.0);
    let events = |height| [tool(1), spindle(), feed([0.0; 3], UP), feed([0.0, 0.0, height], UP)];
    let long = lines::<Xyz>(&config, &events(20.0));
    assert_eq!(long[long.len() - 3..], ["Z20", "G53 G0 Z0", "M5"]);
    let short = lines::<Xyz>(&config, &events(19.9));
    assert_eq!(short[short.len() - 4..], ["Z19.9", "G0 Z39.9", "G53 G0 Z0", "M5"]);
}

#[test]
fn records_between_the_first_motion_and_the_second_keep_their_order() {
    let events = [
        tool(1),
        rapid([0.0, 0.0, 9.0], UP),
        Event::Text(TextKind::Message, b"LOOK"),
        spindle(),
        Event::Function(MachineFunction::Coolant(Coolant::Flood)),
        feed([0.0, 0.0, 1.0], UP),
    ];
    let lines = lines::<Xyz>(&config(), &events);
    let message = lines.iter().position(|line| line == "(LOOK)").expect("the message");
    assert_eq!(lines[message - 1..message + 4], ["Z9", "(LOOK)", "S8000 M3", "M8", "G1 Z1 F500"]);
}

#[test]
fn blocks_of_the_sequence_lie_on_the_tool_axis_within_one_unit() {
    let axis = [0.3, -0.4, 0.8];
    let config = with_lengths(Some(33.0));
    let events = [tool(1), spindle(), feed([7.0, 8.0, -9.0], axis), feed([8.0, 8.0, -9.0], axis)];
    let lines = lines::<Head>(&config, &events);
    let mut machine = config.set_up.machine::<Head>().expect("valid");
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
    // Approach point, first point, second point, retract; M5 moves nothing.
    near(5, [7.0, 8.0, -9.0], 50.0);
    near(4, [7.0, 8.0, -9.0], 0.0);
    near(3, [8.0, 8.0, -9.0], 0.0);
    near(2, [8.0, 8.0, -9.0], 33.0);
}

#[test]
fn points_of_the_sequence_keep_the_limits_too() {
    let mut config = with_lengths(Some(500.0));
    config.set_up.machine_zero.insert('Z', -300.0);
    let up = run::<Cb>(&config, &[tool(1), spindle(), feed([0.0; 3], UP)]);
    assert!(
        up.error().text.contains("`retract.distance` = 500 mm: Z would have to move to 300.000 mm"),
        "{:?}",
        up.error()
    );
    config.motion.retract.distance_mm = None;
    config.motion.retract.position_mm = Some(1.0);
    let above = run::<Cb>(&config, &[tool(1), spindle(), feed([0.0; 3], UP)]);
    assert!(above.error().text.contains("machine coordinate 1.000 mm"), "{:?}", above.error());
    config.motion.retract.position_mm = Some(0.0);
    config.motion.park.insert('B', 2.0);
    let parked = run::<Cb>(&config, &[tool(1), spindle(), feed([0.0; 3], UP)]);
    assert!(parked.error().text.contains("B would have to rotate to 114.5916°"), "{:?}", parked.error());
}

#[test]
fn axes_park_one_after_the_other_with_the_retract_axis_last() {
    let mut config = config();
    for (letter, value) in [('B', 0.0), ('X', -100.0), ('Y', 200.0), ('Z', -5.0)] {
        config.motion.park.insert(letter, value);
    }
    let lines = lines::<Cb>(&config, &[tool(1), spindle(), feed([0.0; 3], cb(0.0, 20.0))]);
    assert_eq!(lines[lines.len() - 5..], ["G53 G0 Z0", "M5", "G0 B0", "G53 G0 X-100 Y200", "G53 G0 Z-5"]);
}

#[test]
fn without_stop_retract_a_head_leaves_the_part_along_the_tool_all_the_same() {
    let tilted = [1.0, 0.0, 1.0];
    let events = [
        tool(1),
        spindle(),
        feed([0.0; 3], tilted),
        Event::Interruption(Interruption::Stop),
        feed([9.0, 0.0, 0.0], tilted),
    ];
    let mut config = with_lengths(Some(20.0));
    config.motion.stop_retract = false;
    let lines = lines::<Head>(&config, &events);
    let stop = lines.iter().position(|line| line == "M0").expect("a stop");
    assert!(lines[stop - 2].starts_with("G1 ") && lines[stop - 1].starts_with("G0 X"), "{lines:#?}");

    config.motion.retract.distance_mm = None;
    let run = run::<Head>(&config, &events);
    assert_eq!(run.error().location.line, 4, "{}", run.text());
    assert!(!run.text().contains("M0"), "{}", run.text());
}

#[test]
fn a_retract_position_at_the_part_end_of_the_travel_is_refused() {
    let mut config = config();
    config.set_up.limits.insert('Z', Some(crate::kinematics::Limits { lower: 0.0, upper: 500.0 }));
    let events = [tool(1), spindle(), feed([0.0; 3], UP)];
    let run = run::<Xyz>(&config, &events);
    assert_eq!(
        run.error().text,
        "the retract position Z = 0 mm (machine coordinate) is the end of the travel at the part"
    );
    config.motion.retract.position_mm = Some(500.0);
    lines::<Xyz>(&config, &events);
}

#[test]
fn the_spindle_stops_after_the_retract_and_only_once() {
    let mut config = config();
    config.motion.retract.distance_mm = Some(20.0);
    let cut = [
        tool(1),
        spindle(),
        feed([0.0, 0.0, 0.0], UP),
        feed([5.0, 0.0, 0.0], UP),
        Event::Function(MachineFunction::Spindle(Spindle::Off)),
    ];
    let end = |events: &[Event<'_>]| {
        let lines = lines::<Xyz>(&config, events);
        let out = lines.iter().position(|line| line == "G0 Z20").expect("the retract");
        lines[out + 1..].to_vec()
    };
    assert_eq!(end(&cut), ["G53 G0 Z0", "M5"]);
    let stopped: Vec<_> = cut.iter().copied().chain([Event::Interruption(Interruption::Stop)]).collect();
    assert_eq!(end(&stopped)[..3], ["G53 G0 Z0", "M5", "M0"]);
    let changed: Vec<_> = cut.iter().copied().chain([tool(2), spindle(), feed([9.0, 0.0, 0.0], UP)]).collect();
    assert_eq!(end(&changed)[1..5], ["M9", "G53 G0 Z0", "M5", "T2 M6"]);
}

#[test]
fn gohome_retracts_and_parks_where_a_position_is_configured() {
    let events = [tool(1), spindle(), feed([0.0; 3], UP), Event::NewStart(NewStart::Home), feed([1.0, 0.0, 0.0], UP)];
    let retracted = lines::<Cb>(&config(), &events);
    let home = retracted.iter().rposition(|line| line.starts_with("N2 G21")).expect("a restart");
    assert_eq!(retracted[home - 1], "G53 G0 Z0", "{retracted:?}");
    let mut config = config();
    config.motion.park.insert('B', 0.5);
    let lines = lines::<Cb>(&config, &events);
    let home = lines.iter().position(|line| line == "G0 B28.6479").expect("parked");
    assert_eq!(lines[home - 2..home], ["G53 G0 Z0", "M5"]);
    assert!(lines[home + 1].starts_with("N2 G21"), "{lines:?}");
}

#[test]
fn the_first_rotation_after_gohome_begins_at_the_park_position() {
    let turned = |wrap: Option<Wrap>, before: f64, after: f64| -> Vec<String> {
        let mut config = config();
        config.motion.park.insert('C', 0.0);
        config.motion.rotaries.wrap.extend(wrap.map(|wrap| ('C', wrap)));
        let point = |c: f64| feed([10.0, 0.0, 60.0], cb(c, 30.0));
        let lines =
            lines::<Cb>(&config, &[tool(1), spindle(), point(before), Event::NewStart(NewStart::Home), point(after)]);
        let words = lines.iter().flat_map(|line| line.split(' ')).filter(|word| word.starts_with('C'));
        words.map(str::to_owned).collect()
    };
    assert_eq!(turned(None, 170.0, -170.0), ["C170", "C0", "C-170", "C0"]);
    assert_eq!(turned(Some(Wrap::Symmetric), 170.0, -170.0), ["C170", "C0", "C-170", "C0"]);
    // In one block; from 170 it would take two.
    assert_eq!(turned(Some(Wrap::Positive), 170.0, -10.0), ["C170", "C0", "C350", "C0"]);
    // The sign is the sense of rotation.
    assert_eq!(turned(Some(Wrap::Sign), 170.0, -170.0), ["C170", "C-360", "C-190", "C0"]);
}

#[test]
fn from_after_gohome_leaves_parked_axes_at_their_positions() {
    let mut config = config();
    config.motion.park.insert('C', 0.0);
    let from = Event::Reference(ReferenceGeometry::From(pose([0.0; 3], cb(170.0, 30.0))));
    let events = [tool(1), Event::NewStart(NewStart::Home), from, spindle(), feed([10.0, 0.0, 60.0], cb(-170.0, 30.0))];
    let lines = lines::<Cb>(&config, &events);
    assert!(lines.contains(&"G0 B30 C-170".to_owned()), "{lines:?}");
}

#[test]
fn a_rapid_that_indexes_is_not_written_as_a_feed_motion() {
    let mut config = config();
    config.motion.rapids.rapid = Rapid::Feed;
    config.motion.rapids.rapid_feed_mm_per_min = Some(9000.0);
    config.motion.rapids.transition = Transition::Direct;
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
fn a_rapid_is_written_as_configured() {
    let blocks = |rapid_mode: Rapid, to: [f64; 3]| {
        let mut config = config();
        config.motion.rapids.rapid = rapid_mode;
        config.motion.rapids.rapid_feed_mm_per_min = Some(9000.0);
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
fn a_tool_retracts_to_the_clearance_plane() {
    let plane = ClearancePlane { normal: Vector3::z_axis(), distance_mm: 80.0 };
    let events = [
        Event::Reference(ReferenceGeometry::ClearancePlane(plane)),
        tool(1),
        spindle(),
        feed([0.0; 3], UP),
        tool(2),
        feed([1.0, 0.0, 0.0], UP),
    ];
    let lines = run::<Cb>(&config(), &events).lines;
    assert!(lines.iter().any(|line| line == "G0 Z80"), "{lines:?}");
}
