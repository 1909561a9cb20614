//! Branch, whole turns and free axes; limits of rotary axes; blocks within tolerance.

use super::*;

#[test]
fn a_spiral_of_twenty_turns_counts_past_360_without_a_jump() {
    let mut events = vec![tool(1), spindle()];
    let steps = 20 * 72;
    for step in 0..=steps {
        let angle = f64::from(step) * 5.0;
        let (sin, cos) = angle.to_radians().sin_cos();
        events.push(feed([30.0 * cos, 30.0 * sin, -f64::from(step) / 300.0], cb(angle, 60.0)));
    }
    let mut config = config();
    config.motion.tolerance_mm = 1.0;
    let lines = lines::<Cb>(&config, &events);
    let turns: Vec<f64> = lines
        .iter()
        .filter(|line| !line.starts_with('('))
        .flat_map(|line| line.split(' ').filter_map(|word| word.strip_prefix('C')?.parse().ok()))
        .collect();
    assert_eq!(turns.len() as i32, steps + 1);
    for (step, turn) in turns.iter().enumerate() {
        assert!((turn - step as f64 * 5.0).abs() < 1e-9, "step {step} is at {turn}");
    }
}

/// Index of the line that ends a rotation of one rotary axis while the other rests at zero.
fn rotates_alone(rotating: char, resting: char, end: &str, lines: &[String]) -> usize {
    let zero = format!("{resting}0");
    let start = lines.iter().position(|line| line.starts_with("X") && line.split(' ').any(|word| word == zero));
    let start = start.expect("the pole") + 1;
    let end = lines.iter().position(|line| line.split(' ').any(|word| word == end)).expect("the end of the rotation");
    assert!(start <= end, "{lines:#?}");
    assert!(lines[start..=end].iter().all(|line| line.contains(rotating) && !line.contains(resting)), "{lines:#?}");
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
    // In place, and the tilt begins with the table at its angle.
    let end = rotates_alone('C', 'B', "C45", &lines);
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

#[test]
fn a_motion_with_a_large_rotation_becomes_blocks_within_tolerance() {
    let turned = |to: f64, tolerance: f64| {
        let events = [tool(1), spindle(), feed([40.0, 0.0, 0.0], cb(0.0, 30.0)), feed([10.0, 40.0, 0.0], cb(to, 30.0))];
        let mut config = config();
        config.motion.tolerance_mm = tolerance;
        run::<Cb>(&config, &events)
    };
    let far = turned(60.0, 0.01);
    assert_eq!(far.diagnostics, []);
    assert!((20..80).contains(&far.statistics.inserted), "{:?}", far.statistics);
    let used = far.statistics.largest_tip_bound_mm;
    assert!(used > 0.009 && used <= 0.01 && far.statistics.largest_axis_bound_rad <= 0.1_f64.to_radians());
    assert!((minutes(&far.lines) - 50.0 / 500.0).abs() < 1e-6, "the tip keeps its speed: {}", far.text());
    let finer = turned(60.0, 0.0025).statistics.inserted as f64 / far.statistics.inserted as f64;
    assert!((1.8..2.6).contains(&finer), "a quarter of the tolerance takes twice the blocks: {finer}");
    assert_eq!(turned(0.02, 0.01).statistics.inserted, 0);
}

#[test]
fn near_the_pole_the_tool_follows_its_path_and_through_it_the_branch_may_change() {
    let across = |from: f64, to: f64| {
        let events = [tool(1), spindle(), feed([9.0, 0.0, 0.0], cb(from, 4.0)), feed([9.0, 5.0, 0.0], cb(to, 4.0))];
        let run = run::<Cb>(&config(), &events);
        assert_eq!(run.diagnostics, []);
        run
    };
    // 0.7 degrees from the pole no path leads from one branch to the other.
    let near = across(10.0, 170.0);
    assert!(near.statistics.inserted > 20 && !near.text().contains("B-4"), "{}", near.text());
    assert!(near.text().contains("C170"));
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
    assert!(line == 4 && opposite.contains("rotates by 180° in one motion"), "{opposite}");
    let (_, limit) = error(&config(), cb(0.0, 105.0), cb(120.0, 105.0));
    assert!(limit.contains("between the last point and this one") && limit.contains("limits -5"), "{limit}");
    let mut fine = config();
    fine.motion.tolerance_mm = 0.0005;
    let (_, coarse) = error(&fine, cb(0.0, 30.0), cb(90.0, 30.0));
    assert!(coarse.contains("too coarse for a tolerance of 0.0005 mm"), "{coarse}");
    let mut whole_degrees = config();
    whole_degrees.formats.rotary = 0;
    let (_, coarse) = error(&whole_degrees, cb(0.0, 30.0), cb(90.0, 30.0));
    assert!(coarse.contains("the rotary words are too coarse for a tolerance of 0.1000°"), "{coarse}");
}

crate::machine! {
    /// Tool axis between 30° and 150° from the vertical, never upright.
    struct Leaning;
    chain: C B | X Y Z;
    tool_axis = (0, 1/2, sqrt(3)/2);
}

#[test]
fn an_axis_out_of_reach_between_two_points_is_an_error() {
    let events = [tool(1), spindle(), feed([9.0, 0.0, 0.0], cb(0.0, 50.0)), feed([9.0, 5.0, 0.0], cb(180.0, 50.0))];
    let mut config = config();
    config.motion.retract.distance_mm = Some(20.0);
    let run = run::<Leaning>(&config, &events);
    assert_eq!(run.error().location.line, 4);
    assert!(run.error().text.starts_with("between the last point and this one: "), "{}", run.error().text);
    let around = [tool(1), spindle(), feed([9.0, 0.0, 0.0], cb(0.0, 50.0)), feed([9.0, 5.0, 0.0], cb(50.0, 50.0))];
    assert_eq!(self::run::<Leaning>(&config, &around).diagnostics, []);
}

#[test]
fn the_first_pose_counts_from_the_pose_of_from() {
    let first = feed([10.0, 0.0, 0.0], cb(170.0, 4.0));
    let chosen = |events: &[Event<'_>]| {
        lines::<Cb>(&config(), events).into_iter().find(|line| line.starts_with("G0 B")).expect("rotaries")
    };
    // From zero the second branch rotates less; from C 160 the first one does.
    assert_eq!(chosen(&[tool(1), spindle(), first]), "G0 B-4 C-10");
    assert_eq!(
        chosen(&[
            Event::Reference(ReferenceGeometry::From(pose([0.0; 3], cb(160.0, 50.0)))),
            tool(1),
            spindle(),
            first
        ]),
        "G0 B4 C170"
    );
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
fn an_axis_is_rewound_a_full_turn_out_of_the_part() {
    let mut config = config();
    config.set_up.limits.insert('C', Some(crate::kinematics::Limits { lower: -3.2, upper: 3.2 }));
    let at = |angle: f64, feed: bool| {
        let pose = pose([10.0, 0.0, 0.0], cb(angle, 30.0));
        Event::Motion(ToolMotion::Move(Move { pose, rapid: !feed, feed: Some(Feed::PerMinute(100.0)) }))
    };
    let events = |last| [tool(1), spindle(), at(170.0, true), at(183.0, true), last];
    let cut = run::<Cb>(&config, &events(at(186.0, true)));
    assert!(cut.error().text.contains("have to be rewound"), "{:?}", cut.error());
    assert_eq!(run::<Cb>(&config, &events(at(186.0, false))).diagnostics, []);
    config.motion.retract.distance_mm = Some(20.0);
    let cut = run::<Cb>(&config, &events(at(186.0, true)));
    assert_eq!(cut.statistics.rewinds, 1);
    assert!(cut.diagnostics[0].text.contains("unavoidable within C -183.3465° to 183.3465°"), "{:?}", cut.diagnostics);
    // A start one full turn lower needs no rewind.
    config.set_up.limits.insert('C', Some(crate::kinematics::Limits { lower: -3.5, upper: 3.2 }));
    assert_eq!(run::<Cb>(&config, &events(at(186.0, true))).diagnostics, []);
}

#[test]
fn a_rewind_never_begins_by_going_down_to_the_clearance() {
    let mut config = config();
    config.set_up.limits.insert('C', Some(crate::kinematics::Limits { lower: -3.2, upper: 3.2 }));
    let plane = ClearancePlane { normal: Vector3::z_axis(), distance_mm: 30.0 };
    let mut events = vec![tool(1), spindle(), Event::Reference(ReferenceGeometry::ClearancePlane(plane))];
    events.extend([170.0, 183.0, 186.0].map(|angle| feed([10.0, 0.0, 60.0], cb(angle, 30.0))));
    let run = run::<Cb>(&config, &events);
    assert_eq!(run.statistics.rewinds, 1);
    let rewound = run.lines.iter().rposition(|line| line.starts_with("G0 C")).expect("a rewind");
    // At G94 straight to the machine retract.
    assert_eq!(run.lines[rewound - 2..rewound], ["G94", "G53 G0 Z0"], "{}", run.text());
}

#[test]
fn only_the_rapid_that_rotates_an_axis_is_split_for_the_shortest_path() {
    let mut config = config();
    config.motion.rotaries.wrap.insert('C', Wrap::Positive);
    config.set_up.limits.insert('B', Some(crate::kinematics::Limits { lower: 0.0, upper: 2.0 }));
    config.motion.retract.distance_mm = Some(20.0);
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
    // No block of the approach counts from the last position in the cut.
    let down: Vec<&str> = lines[turned + 1..turned + 4].iter().map(|line| &line[..1]).collect();
    assert_eq!(down, ["X", "Z", "Z"], "{lines:?}");
}

#[test]
fn the_table_rotates_for_a_cut_from_the_pole_at_the_beginning_of_the_operation() {
    let mut config = config();
    config.motion.retract.distance_mm = Some(20.0);
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
fn a_rotation_at_the_pole_in_the_cut_is_stated_and_has_a_limit() {
    let mut config = config();
    config.motion.retract.distance_mm = Some(50.0);
    config.set_up.limits.insert('B', Some(Limits { lower: -0.1, upper: 1.8 }));
    // Over the pole to the other side: the table rotates by half a revolution there.
    let events = [
        tool(1),
        spindle(),
        feed([0.0; 3], cb(0.0, 20.0)),
        feed([10.0, 0.0, 0.0], UP),
        feed([20.0, 0.0, 0.0], cb(180.0, 20.0)),
    ];
    let in_cut = run::<Cb>(&config, &events);
    assert_eq!((in_cut.statistics.sequences, in_cut.statistics.rewinds), (1, 0), "{}", in_cut.text());
    assert!((in_cut.statistics.largest_on_spot_rad - std::f64::consts::PI).abs() < 1e-6, "{:?}", in_cut.statistics);
    config.motion.course.rotation_at_pole_rad = Some(1.0);
    let out = run::<Cb>(&config, &events);
    assert_eq!((out.statistics.rewinds, out.statistics.largest_on_spot_rad), (1, 0.0), "{}", out.text());
    let texts: Vec<&str> = out.diagnostics.iter().map(|found| &*found.text).collect();
    assert!(
        texts.len() == 1 && texts[0].contains("C has to rotate by 180.000°, more than `course.rotation_at_pole`"),
        "{texts:?}"
    );
}

#[test]
fn a_free_axis_is_inside_limits_that_exclude_zero() {
    let mut config = config();
    config.set_up.limits.insert('C', Some(crate::kinematics::Limits { lower: 0.5, upper: 6.0 }));
    let lines = lines::<Cb>(&config, &[tool(1), spindle(), feed([0.0; 3], UP), feed([10.0, 0.0, 0.0], UP)]);
    assert!(lines.contains(&"G0 B0 C28.6479".to_owned()), "{lines:?}");
}

#[test]
fn first_and_second_pass_count_from_the_same_place() {
    let mut config = config();
    config.set_up.limits.insert('B', Some(crate::kinematics::Limits { lower: -1.2, upper: 1.8 }));
    config.set_up.limits.insert('C', Some(crate::kinematics::Limits { lower: -5.2, upper: 5.2 }));
    let events = [
        Event::Reference(ReferenceGeometry::From(pose([0.0, 0.0, 100.0], cb(100.0, 20.0)))),
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
fn on_request_a_rewind_leaves_the_tip_in_place() {
    let mut config = config();
    config.set_up.limits.insert('C', Some(crate::kinematics::Limits { lower: -3.2, upper: 3.2 }));
    config.motion.retract.rewind = crate::options::Rewind::Follow;
    let at = |angle: f64| feed([10.0, 0.0, 0.0], cb(angle, 30.0));
    let run = run::<Cb>(&config, &[tool(1), spindle(), at(170.0), at(183.0), at(186.0)]);
    assert_eq!(run.statistics.rewinds, 1);
    assert!(
        run.diagnostics.len() == 1 && run.diagnostics[0].text.contains("swings about it)"),
        "{:?}",
        run.diagnostics
    );
    let machine = config.set_up.machine::<Cb>().expect("valid");
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
fn an_operation_begins_in_the_branch_and_turn_that_last_to_its_end() {
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
    // At the vertical the table rotates before the tilt begins, yet only where necessary.
    assert_eq!(rotaries(&config(), &[UP, cb(180.0, 3.0), cb(180.0, 30.0)]), "G0 B0 C180");
    assert_eq!(rotaries(&config(), &[UP, cb(0.0, 3.0), cb(0.0, 30.0)]), "G0 B0 C0");
    // 160 to 320 degrees do not fit below 200: begin at -200.
    let mut limited = config();
    let limit = 200_f64.to_radians();
    limited.set_up.limits.insert('C', Some(crate::kinematics::Limits { lower: -limit, upper: limit }));
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
    // Away from the vertical a limit cannot be avoided.
    let mut limited = config();
    let limit = |angle: f64| angle.to_radians();
    limited.set_up.limits.insert('C', Some(crate::kinematics::Limits { lower: limit(-60.0), upper: limit(60.0) }));
    let past = [cb(-50.0, 20.0), cb(-70.0, 20.0)].map(|axis| feed([0.0; 3], axis));
    let past = run::<Cb>(&limited, &[tool(1), spindle(), past[0], past[1]]);
    assert!(past.error().text.contains("C would have to rotate to -70°"), "{:?}", past.error());
}

#[test]
fn the_table_rotates_where_the_tool_passes_the_vertical_between_two_points() {
    let events = [
        tool(1),
        spindle(),
        feed([0.0; 3], cb(0.0, 20.0)),
        feed([10.0, 0.0, 0.0], cb(0.0, 10.0)),
        feed([20.0, 0.0, 0.0], cb(0.0, -20.0)),
    ];
    let mut config = config();
    config.motion.rapids.index_angle_rad = 360_f64.to_radians();
    let run = run::<Cb>(&config, &events);
    assert_eq!(run.diagnostics, [], "{}", run.text());
    let end = rotates_alone('C', 'B', "C180", &run.lines);
    assert!(run.lines[end..].iter().any(|line| line.contains("B20")), "{}", run.text());
    assert!(run.lines[end + 1..].iter().all(|line| !line.contains('C')), "{}", run.text());
}

#[test]
fn a_rotary_that_is_free_at_the_start_rotates_before_the_cut_and_not_in_it() {
    let mut config = config();
    config.set_up.limits.insert('B', Some(Limits { lower: -0.1, upper: 1.9 }));
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
fn an_indexed_axis_is_on_its_steps_and_never_rotates_in_a_cut() {
    let mut config = config();
    config.motion.rotaries.grid.insert('C', 5_f64.to_radians());
    let with = |config: &Config, axes: &[[f64; 3]]| {
        let mut events = vec![tool(1), spindle()];
        events.extend(axes.iter().map(|&axis| feed([0.0; 3], axis)));
        run::<Cb>(config, &events)
    };
    let errors = |run: Run| run.diagnostics.iter().filter(|found| found.severity == Severity::Error).count();
    assert_eq!(errors(with(&config, &[cb(35.0, 30.0), cb(35.0, 40.0)])), 0);
    // Rounding of CL data is no other direction.
    let rounded = with(&config, &[cb(35.000_03, 30.0)]);
    assert!(rounded.diagnostics.is_empty() && rounded.lines.contains(&"G0 B30 C35".to_owned()), "{}", rounded.text());
    // A step at a limit that the digits of CL data exceed.
    let mut limited = config.clone();
    limited.set_up.limits.insert('C', Some(Limits { lower: 0.0, upper: 35_f64.to_radians() }));
    let rounded = with(&limited, &[cb(35.000_06, 30.0)]);
    assert!(rounded.diagnostics.is_empty() && rounded.lines.contains(&"G0 B30 C35".to_owned()), "{}", rounded.text());
    let between = with(&config, &[cb(36.0, 30.0)]);
    assert!(
        between.error().text.contains("36°, which is not a multiple of its indexing step of 5°"),
        "{:?}",
        between.error()
    );
    // The course sets words of its own, which are steps.
    let mut preferred = config.clone();
    preferred.motion.course.prefer = Some(('C', true));
    let between = with(&preferred, &[cb(101.0, 30.0)]);
    assert!(
        between.error().text.contains("101°, which is not a multiple of its indexing step of 5°"),
        "{:?}",
        between.error()
    );
    preferred.motion.course.axis_tolerance_rad = 1_f64.to_radians();
    let near = with(&preferred, &[cb(101.0, 30.0)]);
    assert!(near.diagnostics.is_empty() && near.lines.contains(&"G0 B30 C100".to_owned()), "{}", near.text());
    let turning = with(&config, &[cb(35.0, 30.0), cb(40.0, 30.0)]);
    assert!(turning.error().text.contains("from 35° to 40° in the cut"), "{:?}", turning.error());
    config.motion.course.axis_tolerance_rad = 1_f64.to_radians();
    assert_eq!(with(&config, &[cb(36.0, 30.0)]).diagnostics, []);
}

#[test]
fn an_indexed_axis_keeps_its_angle_while_another_rotates() {
    let mut config = config();
    config.motion.rotaries.grid.insert('B', 5_f64.to_radians());
    let around = |by: f64| {
        let mut events = vec![tool(1), spindle()];
        events.extend((0..=6).map(|step| feed([100.0, 0.0, 0.0], cb(by * f64::from(step), 30.0))));
        run::<Cb>(&config, &events)
    };
    // An even rotation from one direction to the next would move B by 0.003 degrees.
    let near = around(2.0);
    assert_eq!(near.diagnostics, []);
    assert!(near.statistics.inserted > 0, "{}", near.text());
    assert_eq!(near.lines.iter().filter(|line| line.contains('B')).count(), 1, "{}", near.text());
    assert!(around(20.0).error().text.contains("in the cut, but it is an indexed axis"));
}

#[test]
fn the_axis_tolerance_at_the_pole_is_not_that_of_the_path() {
    let mut config = config();
    config.motion.course.axis_tolerance_rad = 0.5_f64.to_radians();
    let beside = 0.4_f64.to_radians();
    let across = |tilt: f64| [tilt.to_radians().sin(), beside, tilt.to_radians().cos()];
    let mut events = vec![tool(1), spindle()];
    events.extend([-4.0, -2.0, 0.0, 2.0, 4.0].map(|tilt| feed([tilt, 0.0, 0.0], across(tilt))));
    let run = run::<Cb>(&config, &events);
    assert_eq!(run.diagnostics, [], "{}", run.text());
    assert_eq!(run.statistics.near_pole, 1);
    assert!((run.statistics.largest_at_pole_rad - beside).abs() < 1e-4, "{:?}", run.statistics);
}

#[test]
fn a_spiral_of_forty_turns_is_written_within_a_turn() {
    let mut config = config();
    config.motion.rotaries.wrap.insert('A', Wrap::Positive);
    config.motion.park.insert('A', 0.0);
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
        // The control takes the shortest path.
        let step = (angle - here + 540.0).rem_euclid(360.0) - 180.0;
        assert!(step.abs() < 180.0 - 1e-9, "{here} to {angle}");
        (here, turned) = (angle, turned + step);
    }
    // Forty turns, and from there to the nearest zero; the axis does not rotate back.
    assert!(
        (turned - (200.0_f64 - 360.0 + 40.0 * 360.0 + 160.0)).abs() < 1e-6 || (turned - 40.0 * 360.0).abs() < 1e-6,
        "{turned}"
    );
}

#[test]
fn the_table_rotates_in_the_sense_of_rotabl() {
    let after = |turning: RotaryDirection, last: Event<'static>| {
        let before = [tool(1), spindle(), feed([0.0; 3], cb(10.0, 30.0))];
        [
            &before[..],
            &[
                Event::Function(MachineFunction::RotaryDirection(turning)),
                last,
                Event::Function(MachineFunction::RotaryDirection(RotaryDirection::Shortest)),
            ],
        ]
        .concat()
    };
    let rotaries = |config: &Config, turning| {
        let run = run::<Cb>(config, &after(turning, rapid([0.0; 3], cb(40.0, 30.0))));
        assert_eq!(run.diagnostics, []);
        run.lines.into_iter().rfind(|line| line.starts_with("G0 C") || line.starts_with("C")).expect("a turn")
    };
    assert_eq!(rotaries(&config(), RotaryDirection::Shortest), "G0 C40");
    assert_eq!(rotaries(&config(), RotaryDirection::Towards(Rotation::Clockwise)), "G0 C40");
    assert_eq!(rotaries(&config(), RotaryDirection::Towards(Rotation::CounterClockwise)), "G0 C-320");
    // Where the axis is limited, the sense leads to an angle inside the limits, or is refused.
    let mut limited = config();
    limited.set_up.limits.insert('C', Some(crate::kinematics::Limits { lower: -6.0, upper: 1.0 }));
    assert_eq!(rotaries(&limited, RotaryDirection::Towards(Rotation::CounterClockwise)), "G0 C-320");
    limited.set_up.limits.insert('C', Some(crate::kinematics::Limits { lower: -1.0, upper: 1.0 }));
    let events = after(RotaryDirection::Towards(Rotation::CounterClockwise), rapid([0.0; 3], cb(40.0, 30.0)));
    assert!(run::<Cb>(&limited, &events).error().text.contains("leads out of the limits of the axis"));
    let events = after(RotaryDirection::Towards(Rotation::CounterClockwise), feed([0.0; 3], cb(40.0, 30.0)));
    assert!(run::<Cb>(&config(), &events).error().text.contains("before a cut"));
    let events = after(RotaryDirection::Towards(Rotation::CounterClockwise), rapid([0.0; 3], UP));
    assert!(run::<Head>(&with_lengths(Some(50.0)), &events).error().text.contains("no rotary axis in the table"));
}
