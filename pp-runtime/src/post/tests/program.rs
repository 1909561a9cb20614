//! Whole programs and their summaries.

use nalgebra::{Matrix3, Rotation3, Vector3};

use super::*;
use crate::control::Siemens;
use crate::program::{Clearance, ClearancePlane, Rotation};

#[test]
fn a_program_ends_with_its_end_code_and_has_no_fault() {
    let (text, report) = posted::<Cb>(&Config::default(), PART);
    assert_eq!(report.diagnostics, []);
    assert!(!report.failed);
    assert!(text.ends_with("M9\nG53 G0 Z0\nM5\nM2\n"), "{text}");
    assert_eq!(
        blocks(&text)[..11],
        [
            "N1 G21 G8 G17 G40 G49 G80 G90 G91.1 G94 G97 G54 G64 P0.01",
            "M9",
            "G53 G0 Z0",
            "T1 M6",
            "G53 G0 Z0",
            "G43 H1",
            "S6000 M3",
            "G0 B0 C0",
            "X0 Y0",
            "Z20",
            "M8",
        ]
    );
    assert_eq!(report.statistics.motions, 6);
    assert_eq!(report.blocks as usize, text.lines().filter(|line| !line.starts_with('(')).count());
}

#[test]
fn times_are_written_after_the_blocks_of_the_user_and_before_the_end_code() {
    let mut config = Config::default();
    config.control.program.times = true;
    config.control.program.end = vec!["M60".to_owned()];
    let (text, _) = posted::<Cb>(&config, PART);
    let (_, end) = text.split_once("\nM60\n").expect("the block of the user");
    let lines: Vec<&str> = end.lines().collect();
    assert!(lines[0].starts_with("(machining time "), "{lines:?}");
    assert_eq!(lines.iter().filter(|line| !line.starts_with('(')).copied().collect::<Vec<_>>(), ["M2"]);
    assert_eq!(lines.last(), Some(&"M2"));
}

#[test]
fn the_summary_states_the_rotary_axes_after_the_last_motion() {
    // The second operation sweeps C from 0 to 391 degrees at B 30.
    let revolution = (0..=391).step_by(17).map(|degrees| {
        let (sin_c, cos_c) = f64::from(degrees).to_radians().sin_cos();
        format!("GOTO/25,8,0,{:.9},{:.9},0.866025404\n", 0.5 * cos_c, 0.5 * sin_c)
    });
    let part = PART.replace("GOTO/25,8,0\n", &revolution.collect::<String>());
    let stated = |change: fn(&mut Config), part: &str| {
        let mut config = Config::default();
        change(&mut config);
        let (_, report) = posted::<Cb>(&config, part);
        assert!(!report.failed, "{:?}", report.diagnostics);
        report
            .summary()
            .into_iter()
            .find_map(|line| Some(line.strip_prefix("rotary axes after the last motion: ")?.to_owned()))
    };
    assert_eq!(stated(|_| {}, &part).as_deref(), Some("C 391, B 30 degrees"));
    let symmetric = |config: &mut Config| _ = config.motion.rotaries.wrap.insert('C', crate::options::Wrap::Symmetric);
    assert_eq!(stated(symmetric, &part).as_deref(), Some("C 31, B 30 degrees"));
    let parked = |config: &mut Config| _ = config.motion.park.insert('B', 0.0);
    assert_eq!(stated(parked, &part).as_deref(), Some("C 391, B 0 degrees"));
    // After a stop the axes are where a hand has left them.
    let stopped = part.replace("FINI", "STOP\nFINI");
    assert_eq!(stated(|_| {}, &stopped), None);
    assert_eq!(stated(parked, &stopped).as_deref(), Some("B 0 degrees"));
}

#[test]
fn the_part_origin_is_assumed_where_words_travel_or_speeds_depend_on_it() {
    use crate::options::Mode;
    let assumed = |mode: Mode, change: fn(&mut Config)| {
        let mut config = crate::config::starting_point(&Siemens);
        config.motion.mode = mode;
        change(&mut config);
        let job = Job { cl_name: "bracket.cls", config: &config, control: &Siemens, units: None };
        let report = post::<Cb>(&job, &mut Cursor::new(PART.as_bytes()), &mut Vec::new()).expect("a program");
        report.assumptions.into_iter().find(|assumption| assumption.contains("part_origin"))
    };
    let machine_zero = |config: &mut Config| _ = config.set_up.machine_zero.insert('X', 0.0);
    let speed = |config: &mut Config| _ = config.set_up.speeds.insert('X', 9000.0);
    let bounds =
        "part_origin 0, 0, 0 for travel and speeds of the axes: the part zero is the reference point of the table";
    for mode in [Mode::Tcp, Mode::Plane] {
        assert_eq!(assumed(mode, |_| {}), None, "{mode:?}");
        assert_eq!(assumed(mode, machine_zero).as_deref(), Some(bounds), "{mode:?}");
    }
    assert_eq!(assumed(Mode::Tcp, speed).as_deref(), Some(bounds));
    assert_eq!(assumed(Mode::Plane, speed), None);
    let given = |config: &mut Config| {
        config.set_up.machine_zero.insert('X', 0.0);
        config.given.insert("part_origin");
    };
    assert_eq!(assumed(Mode::Plane, given), None);
}

#[test]
fn assumptions_are_listed_in_the_summary() {
    let mut config = Config::default();
    config.motion.defaults.speed_rev_per_min = Some(3000.0);
    config.motion.defaults.rotation = Some(Rotation::Clockwise);
    let (_, report) = posted::<Cb>(&config, &PART.replace("SPINDL/RPM,6000,CLW\n", ""));
    let summary = report.summary().join("\n");
    for text in [
        "assumed: part_origin 0, 0, 0",
        "assumed: work offset G54",
        "assumed: retract to machine coordinate 0 mm",
        "assumed: spindle of T1 from the configuration",
        "linear limits not checked: no machine_zero (X Y Z)",
        "rapids are not linearised",
    ] {
        assert!(summary.contains(text), "missing {text} in\n{summary}");
    }
}

#[test]
fn a_unit_that_is_given_is_not_assumed() {
    let config = Config { cl_units: Some(Units::Millimetres), ..Config::default() };
    let (text, report) = posted::<Cb>(&config, &PART.replace("UNITS/MM\n", ""));
    let line = "unit of the CL data is mm, as given; the CL file states none".to_owned();
    assert!(report.reading.contains(&line) && !report.assumptions.iter().any(|text| text.contains("unit")));
    assert!(text.contains(&format!("({line})\n")), "{text}");
    assert!(!posted::<Cb>(&config, PART).1.reading.contains(&line));
}

#[test]
fn the_pitch_of_every_thread_is_in_the_summary() {
    let tap =
        |feed: &str| format!("CYCLE/TAP,RAPTO,5,FEDTO,-14,RTRCTO,AUTO,{feed}\nGOTO/5,0,0\nGOTO/25,0,0\nCYCLE/OFF\n");
    let cl = |feed: &str, sense: &str| {
        format!(
            "UNITS/MM\nTOOL PATH/TAP,TOOL,M8\nLOADTL/3\nSPINDL/RPM,500,{sense}\nRAPID\nGOTO/5,0,50,0,0,1\n{}RAPID\nGOTO/25,0,90\nFINI\n",
            tap(feed)
        )
    };
    let threads = |feed: &str, sense: &str| {
        let report = posted::<Cb>(&Config::default(), &cl(feed, sense)).1;
        report.summary().into_iter().filter(|line| line.starts_with("threads")).collect::<Vec<_>>()
    };
    assert_eq!(threads("MMPR,1.25", "CLW"), ["threads: T3 pitch 1.250 mm (2 holes)"]);
    // A feed per minute that was meant for another speed.
    assert_eq!(threads("MMPM,1000", "CCLW"), ["threads: T3 pitch 2.000 mm left-hand (2 holes)"]);
    assert!(posted::<Cb>(&Config::default(), PART).1.threads.listed().is_empty());
}

#[test]
fn blocks_of_the_configuration_come_after_the_header_and_before_the_end() {
    let mut config = Config::default();
    config.control.program.start = vec!["G64 P0.01".into()];
    config.control.program.end = vec!["M64 P0".into()];
    config.control.program.line_numbers = BlockNumbers::Step(5);
    let (text, _) = posted::<Cb>(&config, PART);
    assert_eq!(
        blocks(&text)[..3],
        ["G64 P0.01", "(OPERATION ROUGH)", "N5 G21 G8 G17 G40 G49 G80 G90 G91.1 G94 G97 G54 G64 P0.01"]
    );
    assert!(text.contains("M64 P0\nN"), "{text}");
}

#[test]
fn the_same_input_gives_the_same_bytes() {
    assert_eq!(posted::<Cb>(&Config::default(), PART), posted::<Cb>(&Config::default(), PART));
}

/// The part upside down: every Y and Z, of tips and axes, has the other sign.
fn overturned(text: &str) -> String {
    let turned = |line: &str| match line.strip_prefix("GOTO/").or_else(|| line.strip_prefix("CLEARP/")) {
        Some(numbers) => {
            let (word, _) = line.split_once('/').expect("a slash");
            let numbers = numbers.split(',').enumerate().map(|(index, number)| match index % 3 {
                0 => number.to_owned(),
                _ => format!("{}", -number.parse::<f64>().expect("a number")),
            });
            format!("{word}/{}\n", numbers.collect::<Vec<_>>().join(","))
        }
        None => format!("{line}\n"),
    };
    // Without an axis of its own the first point would have that of the frame.
    text.replace("GOTO/0,0,20\n", "GOTO/0,0,20,0,0,1\n").lines().map(turned).collect()
}

#[test]
fn part_rotation_turns_a_part_that_was_programmed_upside_down_before_any_other_stage() {
    let upright = PART.replace("TOOL PATH/SIDE", "GOTO/25,0,9\nTOOL PATH/SIDE");
    let mut config = Config::default();
    config.motion.guards.floor_mm = Some(-3.0);
    config.motion.retract.clearance =
        Some(Clearance::Plane(ClearancePlane { normal: Vector3::z_axis(), distance_mm: 30.0 }));
    let (expected, report) = posted::<Cb>(&config, &upright);
    assert!(!report.failed && report.set_up.is_empty(), "{report:?}");
    config.set_up.part_rotation =
        Rotation3::from_matrix_unchecked(Matrix3::from_diagonal(&Vector3::new(1.0, -1.0, -1.0)));
    let (text, report) = posted::<Cb>(&config, &overturned(&upright));
    assert!(!report.failed, "{report:?}");
    assert_eq!(blocks(&text), blocks(&expected));
    let said = "part rotation 180, 0, 0: the CL data is rotated by these degrees about X, then Y, then Z of the table";
    assert_eq!(report.set_up, [said]);
    assert!(text.lines().any(|line| line == format!("({said})")), "{text}");
    assert!(text.contains("tip Z -3 to 20"), "{text}");
    config.motion.guards.floor_mm = Some(-2.0);
    assert!(posted::<Cb>(&config, &overturned(&upright)).1.failed);
}

#[test]
fn a_dry_run_is_named_in_the_header_and_runs_the_same_path_further_out() {
    let (_, report) = posted::<Cb>(&Config::default(), PART);
    let mut config = Config::default();
    config.motion.lift_mm = Some(50.0);
    let (text, dry) = posted::<Cb>(&config, PART);
    assert!(!dry.failed && dry.statistics.motions == report.statistics.motions, "{dry:?}");
    let said = "DRY RUN: every point is 50 mm further out along the tool axis, spindle and coolant off";
    assert!(dry.set_up == [said] && text.contains(said), "{text}");
    assert!(text.contains("\nG1 Z47 F800\nX25\n"), "{text}");
    assert!(!text.contains("M3\n") && !text.contains("M8\n"), "{text}");
}
