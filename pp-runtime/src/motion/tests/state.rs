//! State before a motion (tool, spindle, feed, coolant), and the records that change it.

use super::*;
use crate::program::{BlockPlace, Coolants};
use crate::set_up::FurtherSetUp;

#[test]
fn a_head_does_not_post_without_the_length_of_the_tool() {
    let run = run::<Head>(&config(), &[tool(7), spindle(), feed([0.0; 3], UP)]);
    assert!(run.error().text.contains("gauge length of T7"), "{:?}", run.error());
    assert_eq!(run.error().location.line, 1);
    assert_eq!(run.lines, [""; 0]);
}

#[test]
fn a_feed_motion_needs_tool_spindle_and_feed() {
    let text = |events: &[Event<'_>]| run::<Xyz>(&config(), events).error().text.clone();
    assert!(text(&[spindle(), feed([0.0; 3], UP)]).contains("before the first tool"));
    assert!(text(&[tool(1), feed([0.0; 3], UP)]).contains("without spindle speed"));
    assert!(
        text(&[tool(1), spindle(), Event::Function(MachineFunction::Spindle(Spindle::Off)), feed([0.0; 3], UP)])
            .contains("spindle off")
    );
    let silent = Event::Motion(ToolMotion::Move(Move { pose: pose([0.0; 3], UP), rapid: false, feed: None }));
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
    assert!(run::<Xyz>(&config(), &events).error().text.contains("since the tool call"));
    let before = [
        tool(1),
        spindle(),
        feed([0.0; 3], UP),
        Event::NewStart(NewStart::Operation(b"B")),
        spindle(),
        tool(2),
        feed([0.0; 3], UP),
    ];
    assert_eq!(run::<Xyz>(&config(), &before).diagnostics, []);
}

#[test]
fn speed_and_direction_come_from_the_configuration_where_the_cl_data_gives_none() {
    let mut config = config();
    config.motion.defaults.speed_rev_per_min = Some(1000.0);
    config.motion.defaults.rotation = Some(Rotation::Clockwise);
    config.set_up.tools.insert(1, GivenTool { speed_rev_per_min: Some(2000.0), ..GivenTool::default() });
    let text = run::<Xyz>(&config, &[tool(1), feed([0.0; 3], UP), tool(2), feed([0.0; 3], UP)]).text();
    assert!(text.contains("S2000 M3") && text.contains("S1000 M3"), "{text}");
}

#[test]
fn spindle_speeds_that_make_no_sense_are_refused() {
    let mut config = config();
    config.motion.guards.spindle_max_rev_per_min = Some(8000.0);
    let text = |config: &Config, speed, rotation| {
        let on = Event::Function(MachineFunction::Spindle(Spindle::On {
            speed_rev_per_min: Some(speed),
            rotation: Some(rotation),
        }));
        run::<Xyz>(config, &[tool(1), on, feed([0.0; 3], UP)]).diagnostics.first().map(|found| found.text.clone())
    };
    assert_eq!(text(&config, 8000.0, Rotation::Clockwise), None);
    assert!(text(&config, 8000.1, Rotation::Clockwise).is_some_and(|text| text.contains("spindle_max")));
    assert!(text(&config, 0.4, Rotation::Clockwise).is_some_and(|text| text.contains("S0")));
    config.formats.speed = 1;
    assert_eq!(text(&config, 0.4, Rotation::Clockwise), None);
    config.set_up.tools.insert(1, GivenTool { left_handed: true, ..GivenTool::default() });
    assert!(text(&config, 100.0, Rotation::Clockwise).is_some_and(|text| text.contains("counter-clockwise")));
    assert_eq!(text(&config, 100.0, Rotation::CounterClockwise), None);
}

#[test]
fn the_floor_is_the_lowest_tip() {
    let mut config = config();
    config.motion.guards.floor_mm = Some(-5.0);
    let events = |z| [tool(1), spindle(), feed([0.0, 0.0, z], UP)];
    assert_eq!(run::<Xyz>(&config, &events(-5.0)).diagnostics, []);
    assert!(run::<Xyz>(&config, &events(-5.01)).error().text.contains("floor"));
}

#[test]
fn inverse_time_is_written_where_a_rotary_word_changes_and_f_is_repeated_after_it() {
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
    let mut config = config();
    config.motion.tolerance_mm = 1.0;
    let lines = lines::<Cb>(&config, &events);
    let first = lines.iter().position(|line| line.starts_with("G93")).expect("inverse time");
    let codes: Vec<String> = lines[first..first + 8]
        .iter()
        .map(|line| line.split(' ').filter(|word| word.starts_with(['G', 'F', 'B'])).collect::<Vec<_>>().join(" "))
        .collect();
    assert_eq!(codes, ["G93 B12 F50", "B14 F100", "G94 F500", "", "G93 B15 F500", "G94", "G0", "G1 F500"]);
}

#[test]
fn a_feed_per_revolution_becomes_a_feed_per_minute_with_the_written_speed() {
    let per_turn = Event::Motion(ToolMotion::Move(Move {
        pose: pose([0.0; 3], UP),
        rapid: false,
        feed: Some(Feed::PerRevolution(0.1)),
    }));
    let text = run::<Xyz>(&config(), &[tool(1), spindle(), per_turn]).text();
    assert!(text.contains("G1 Z0 F800"), "{text}");
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
fn a_direct_operation_has_its_speed_before_the_course_cuts_for_it() {
    let mut config = config();
    config.motion.rapids.transition = Transition::Direct;
    config.motion.retract.distance_mm = Some(20.0);
    let limit = 180_f64.to_radians();
    config.set_up.limits.insert('C', Some(crate::kinematics::Limits { lower: -limit, upper: limit }));
    let events = [
        tool(1),
        spindle(),
        feed([10.0, 0.0, 0.0], cb(160.0, 30.0)),
        feed([10.0, 0.0, 0.0], cb(170.0, 30.0)),
        Event::NewStart(NewStart::Operation(b"NEXT")),
        Event::Function(MachineFunction::Spindle(Spindle::On {
            speed_rev_per_min: Some(3000.0),
            rotation: Some(Rotation::Clockwise),
        })),
        Event::Function(MachineFunction::Coolant(Coolant::Flood)),
        // The table reaches its limit in this motion.
        feed([10.0, 0.0, 0.0], cb(190.0, 30.0)),
    ];
    let on = run::<Cb>(&config, &events);
    assert_eq!(on.statistics.rewinds, 1, "{:?} {}", on.diagnostics, on.text());
    let next = on.lines.iter().position(|line| line == "(OPERATION NEXT)").expect("the operation");
    assert_eq!(on.lines[next + 1..next + 3], ["S3000 M3", "M8"], "{}", on.text());
    // With the spindle off the course changes do not cut either.
    let mut off = events;
    off[5] = Event::Function(MachineFunction::Spindle(Spindle::Off));
    let off = run::<Cb>(&config, &off);
    assert!(off.error().text.contains("with the spindle off"), "{:?}", off.error());
    assert_eq!(off.lines[next + 1..], ["M5"], "{}", off.text());
}

#[test]
fn coolant_that_the_control_has_no_code_for_is_refused() {
    let events = [tool(1), spindle(), Event::Function(MachineFunction::Coolant(Coolant::Through)), feed([0.0; 3], UP)];
    let text = "COOLNT asks for coolant through the spindle, for which this control has no code";
    assert_eq!(run::<Xyz>(&config(), &events).error().text, text);
    let mut config = config();
    config.motion.defaults.coolant = Coolants::of(Coolant::Air);
    let events = [tool(1), spindle(), Event::Function(MachineFunction::Coolant(Coolant::On)), feed([0.0; 3], UP)];
    assert!(
        run::<Xyz>(&config, &events)
            .error()
            .text
            .starts_with("`coolant` of the tool, or of `[defaults]`, asks for air")
    );
}

#[test]
fn a_pressure_that_the_control_has_no_code_for_is_left_out_with_a_warning() {
    let pressure = Event::Function(MachineFunction::Coolant(Coolant::ThroughAt(Pressure::High)));
    let events = [tool(1), spindle(), pressure, feed([0.0; 3], UP)];
    let mut config = config();
    config.control.coolant[2] = Some(["M51".to_owned(), "M59".to_owned()]);
    let plain = run::<Xyz>(&config, &events);
    let [remark] = &plain.diagnostics[..] else { panic!("{:?}", plain.diagnostics) };
    assert!(remark.text.contains("HIGH has no code"), "{remark:?}");
    assert!(plain.lines.iter().any(|line| line == "M51"), "{}", plain.text());
    config.control.coolant[6] = Some(["M52".to_owned(), "M59".to_owned()]);
    let high = run::<Xyz>(&config, &events);
    assert_eq!(high.diagnostics.len(), 0, "{:?}", high.diagnostics);
    assert!(high.lines.iter().any(|line| line == "M52"), "{}", high.text());
    assert!(!high.lines.iter().any(|line| line == "M51"), "{}", high.text());
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
fn the_speed_of_one_tool_is_never_that_of_another() {
    let on = Event::Function(MachineFunction::Spindle(Spindle::On { speed_rev_per_min: None, rotation: None }));
    let cut = feed([0.0, 0.0, 0.0], UP);
    // Off and on again in the start in which the tool changes, and given to a tool that never moves.
    let again = [
        tool(1),
        spindle(),
        cut,
        Event::Interruption(Interruption::Stop),
        Event::Function(MachineFunction::Spindle(Spindle::Off)),
        tool(2),
        on,
        cut,
    ];
    let skipped = [tool(1), spindle(), tool(2), cut];
    for events in [&again[..], &skipped] {
        let run = run::<Xyz>(&config(), events);
        assert!(run.error().text.contains("without spindle speed"), "{}", run.text());
    }
    // Before the tool record it belongs to that tool, and the same tool keeps its own.
    lines::<Xyz>(
        &config(),
        &[tool(1), spindle(), cut, Event::Interruption(Interruption::Stop), spindle(), tool(2), cut],
    );
    lines::<Xyz>(&config(), &[tool(1), spindle(), tool(1), cut]);
}

#[test]
fn a_linear_axis_that_f_does_not_count_along_is_fed_in_inverse_time() {
    let events = [tool(1), spindle(), feed([0.0; 3], UP), feed([0.01, 0.0, -10.0], UP)];
    let lines = lines::<Xyw>(&config(), &events);
    assert!(lines.contains(&"X0.01 W-10 F50".to_owned()), "{lines:#?}");
    assert!(lines.iter().any(|line| line.starts_with("G93 G1 W0")), "{lines:#?}");
}

#[test]
fn a_spindle_that_is_off_stops_before_the_next_rapid_and_refuses_the_next_feed() {
    let off = |next| {
        let events = [
            tool(1),
            spindle(),
            feed([0.0, 0.0, 0.0], UP),
            Event::Function(MachineFunction::Spindle(Spindle::Off)),
            next,
        ];
        run::<Xyz>(&config(), &events)
    };
    let rapid = off(rapid([5.0, 0.0, 50.0], UP)).lines;
    let stop = rapid.iter().position(|line| line == "M5").expect("stopped");
    assert_eq!(rapid[stop + 1], "G0 X5 Z50");
    assert!(off(feed([5.0, 0.0, 0.0], UP)).diagnostics[0].text.contains("spindle off"));
}

#[test]
fn nc_text_and_codes_leave_nothing_in_force() {
    for (event, block) in [
        (Event::Interruption(Interruption::Insert(b"G0 X5", BlockPlace::InOrder)), "G0 X5"),
        (Event::Interruption(Interruption::Code { letter: b'M', number: 10, place: BlockPlace::InOrder }), "M10"),
    ] {
        let events = [tool(1), spindle(), feed([0.0; 3], UP), event, feed([0.0, 0.0, 1.0], UP)];
        let lines = lines::<Cb>(&config(), &events);
        let at = lines.iter().position(|line| line == block).expect("as it stands");
        assert!(lines[at + 1].starts_with("N2 G21 G8 G17 G40"), "{lines:?}");
        assert!(lines[at..].iter().any(|line| line == "S8000 M3"));
    }
}

#[test]
fn nc_text_that_is_not_ascii_is_refused() {
    for text in [&b"G0 X\xff"[..], b"G0\tX1", b""] {
        let events = [
            tool(1),
            spindle(),
            feed([0.0; 3], UP),
            Event::Interruption(Interruption::Insert(text, BlockPlace::InOrder)),
        ];
        assert!(run::<Cb>(&config(), &events).error().text.contains("not ASCII"));
    }
}

#[test]
fn cutter_compensation_is_refused_without_compensation_path() {
    let before = [tool(1), spindle(), feed([0.0; 3], UP)];
    let with = |event: Event<'static>| run::<Cb>(&config(), &[&before[..], &[event]].concat());
    let asked = |side| {
        with(Event::Function(MachineFunction::Compensation(Compensation { side, register: None, in_xy_plane: true })))
    };
    let refused = asked(CutterSide::Left);
    assert!(refused.error().text.contains("CUTCOM"));
    assert!(refused.error().help.as_ref().is_some_and(|help| help.contains("[compensation] path")));
    assert_eq!(asked(CutterSide::Off).diagnostics, []);
}

#[test]
fn a_wait_is_written_in_seconds() {
    let wait = |dwell| {
        lines::<Cb>(
            &config(),
            &[
                tool(1),
                spindle(),
                feed([0.0; 3], UP),
                Event::Function(MachineFunction::Delay(dwell)),
                feed([1.0, 0.0, 0.0], UP),
            ],
        )
    };
    assert!(wait(Dwell::Seconds(2.5)).contains(&"G4 P2.5".to_owned()));
    assert!(wait(Dwell::Revolutions(400.0)).contains(&"G4 P3".to_owned()), "400 turns at 8000/min");
    let still = [tool(1), Event::Function(MachineFunction::Delay(Dwell::Revolutions(2.0)))];
    let off = Event::Function(MachineFunction::Spindle(Spindle::Off));
    let stopped =
        [tool(1), spindle(), feed([0.0; 3], UP), off, Event::Function(MachineFunction::Delay(Dwell::Revolutions(2.0)))];
    for events in [&still[..], &stopped] {
        assert!(run::<Cb>(&config(), events).error().text.contains("while the spindle is off"));
    }
}

#[test]
fn each_set_up_has_its_own_work_offset() {
    let events =
        [tool(1), spindle(), feed([0.0; 3], UP), Event::NewStart(NewStart::SetUp(2)), feed([1.0, 0.0, 0.0], UP)];
    assert!(run::<Xyz>(&config(), &events).error().text.contains("set-up 2 is not configured"));
    let mut config = config();
    let further = FurtherSetUp { work_offset: Some("G55".to_owned()), ..FurtherSetUp::default() };
    config.set_up.set_ups.insert(2, further);
    let lines = lines::<Xyz>(&config, &events);
    let safety: Vec<&String> = lines.iter().filter(|line| line.contains("G17")).collect();
    assert!(safety[0].contains("G54") && safety[1].contains("G55"), "{safety:?}");
    // The clearance plane ends with its frame: in the other frame it would be another plane.
    let plane = ClearancePlane { normal: Vector3::z_axis(), distance_mm: 80.0 };
    let mut above = vec![Event::Reference(ReferenceGeometry::ClearancePlane(plane))];
    above.extend(events);
    above.extend([tool(2), feed([1.0, 0.0, 0.0], UP)]);
    let run = run::<Xyz>(&config, &above);
    assert_eq!(run.lines.iter().filter(|line| *line == "G0 Z80").count(), 1, "{:?}", run.lines);
}

#[test]
fn another_machine_in_the_cl_data_is_remarked_on() {
    let events = [Event::Text(TextKind::MachineName, b"UNCX01"), tool(1), spindle(), feed([0.0; 3], UP)];
    let run = run::<Cb>(&config(), &events);
    assert!(run.diagnostics[0].text.contains("made for the machine `UNCX01`"), "{:?}", run.diagnostics);
}

#[test]
fn the_posted_length_is_guarded_where_it_matters() {
    let guards = |run: &Run| run.lines.iter().filter(|line| line.contains("#5403")).count();
    let events = [
        tool(1),
        spindle(),
        feed([0.0, 0.0, -80.0], UP),
        Event::Interruption(Interruption::Stop),
        feed([9.0, 0.0, -80.0], UP),
    ];
    let mut config = with_lengths(Some(9.0));
    let head = run::<Head>(&config, &events);
    let at = head.lines.iter().position(|line| line == "G43 H1").expect("a length offset");
    assert!(head.lines[at + 1].starts_with("o1 if [[ABS[#5403 - 100] GT 0.01]"), "{}", head.text());
    assert!(head.lines.contains(&"o2 endif".to_owned()), "after the stop again: {}", head.text());
    assert_eq!((guards(&head), guards(&run::<Cb>(&config, &events))), (2, 0));
    config.motion.guards.length_guard = Some(true);
    assert_eq!(guards(&run::<Cb>(&config, &events)), 2);
    config.motion.guards.length_guard = Some(false);
    assert_eq!(guards(&run::<Head>(&config, &events)), 0);
    config.motion.guards.length_guard = None;
    config.set_up.tools.insert(1, GivenTool { length_mm: Some(100.0), offset: Some(21), ..GivenTool::default() });
    assert_eq!(guards(&run::<Head>(&config, &events)), 0, "the tool table has no length for H21");
}

#[test]
fn in_a_dry_run_spindle_and_coolant_stay_off() {
    let events = [
        tool(1),
        spindle(),
        Event::Function(MachineFunction::Coolant(Coolant::Flood)),
        feed([0.0, 0.0, -5.0], UP),
        Event::Function(MachineFunction::Spindle(Spindle::On { speed_rev_per_min: Some(900.0), rotation: None })),
        feed([9.0, 0.0, -5.0], UP),
    ];
    let mut config = config();
    config.motion.lift_mm = Some(50.0);
    config.motion.spindle_dwell_s = 1.0;
    let lines = lines::<Cb>(&config, &events);
    assert!(lines.iter().any(|line| line == "M5"), "{lines:?}");
    for code in ["M3", "M4", "M8", "M7", "G4 P"] {
        assert!(!lines.iter().any(|line| line.contains(code)), "{code} in {lines:?}");
    }
    let raw = run::<Cb>(
        &config,
        &[
            tool(1),
            spindle(),
            feed([0.0; 3], UP),
            Event::Interruption(Interruption::Insert(b"M3", BlockPlace::InOrder)),
        ],
    );
    assert!(raw.error().text.contains("a dry run writes no NC text"), "{}", raw.error().text);
}
