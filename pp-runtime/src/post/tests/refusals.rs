//! Jobs that are refused, and programs that end with an error.

use std::io::{self, Read, Seek, SeekFrom, Write};

use super::*;
use crate::kinematics::machines::Xyz;
use crate::options::Mode;

#[test]
fn nothing_is_written_for_a_configuration_that_the_control_cannot_do() {
    let mut config = Config::default();
    config.motion.mode = Mode::Plane;
    let job = Job { cl_name: "part.cls", config: &config, control: &LinuxCnc, units: None };
    let mut out = Vec::new();
    let refused = post::<Cb>(&job, &mut Cursor::new(PART.as_bytes()), &mut out);
    assert!(
        matches!(&refused, Err(PostError::Unfit(text)) if text.contains("LinuxCNC has no tilted work plane")),
        "{refused:?}"
    );
    assert!(out.is_empty());
}

#[test]
fn an_indexing_step_that_the_words_cannot_state_is_refused() {
    let with = |degrees: f64| {
        let mut config = Config::default();
        config.motion.rotaries.grid.insert('C', degrees.to_radians());
        let job = Job { cl_name: "part.cls", config: &config, control: &LinuxCnc, units: None };
        post::<Cb>(&job, &mut Cursor::new(PART.as_bytes()), &mut Vec::new())
    };
    for degrees in [1e-5, 360.0 / 7.0] {
        let refused = with(degrees);
        assert!(
            matches!(&refused, Err(PostError::Unfit(text)) if text.contains("indexing step of C is not a multiple of")),
            "{degrees}: {refused:?}"
        );
    }
    assert!([2.5, 0.001, 90.0].into_iter().all(|degrees| with(degrees).is_ok()));
}

#[test]
fn an_error_in_the_cl_data_leaves_what_came_before_and_no_end_code() {
    let (text, report) = posted::<Cb>(&Config::default(), &PART.replace("GOTO/25,0,-3", "GOTO/25,0"));
    assert!(report.failed);
    assert_eq!(report.diagnostics[0].location.line, 14);
    assert!(text.contains("G1 Z-3 F800\n(ERROR in bracket.cls line 14: "), "{text}");
    assert!(text.ends_with("(the program ends here: do not run it)\n"));
    assert!(!text.contains("M2\n") && !text.contains("X25"));
}

#[test]
fn an_error_of_the_planner_and_later_errors_of_the_reader_are_reported_together() {
    let tilted = PART.replace("GOTO/25,0,-3", "GOTO/25,0,-3,0,1,0.000001").replace("GOTO/25,8,0", "GOTO/25,8");
    let (text, report) = posted::<Xyz>(&Config::default(), &tilted);
    let lines: Vec<u64> = report.diagnostics.iter().map(|found| found.location.line).collect();
    assert_eq!(lines, [14, 20]);
    assert!(text.contains("(ERROR in bracket.cls line 14: Xyz has no rotary axis"), "{text}");
}

#[test]
fn the_motion_held_back_for_its_approach_is_written_before_the_error() {
    let broken = PART.replace("RAPID\nGOTO/0,0,2\n", "GOTO/0\n");
    let (text, report) = posted::<Cb>(&Config::default(), &broken);
    assert!(report.failed);
    assert!(text.contains("M8\nZ20\n(ERROR"), "{text}");
}

#[test]
fn a_program_whose_tool_axes_all_point_into_the_table_is_refused() {
    let down = "UNITS/MM\nLOADTL/1\nSPINDL/RPM,100,CLW\nRAPID\nGOTO/0,0,-20,0,0,-1\nFEDRAT/MMPM,100\nGOTO/0,0,0\n";
    let free = |table_check| {
        let mut config = Config::default();
        config.motion.guards.table_check = table_check;
        config.set_up.limits.insert('B', None);
        posted::<Cb>(&config, down).1
    };
    let report = free(true);
    assert!(report.diagnostics[0].help.as_ref().is_some_and(|help| help.contains("part_rotation")), "{report:?}");
    // The whole program is upside down: the error is reported at its first motion.
    assert_eq!(report.diagnostics[0].location.line, 5);
    assert!(!free(false).failed);
}

#[test]
fn a_program_upside_down_is_reported_before_any_limit() {
    let down = "UNITS/MM\nLOADTL/1\nSPINDL/RPM,100,CLW\nRAPID\nGOTO/0,0,-20,0,0,-1\nFEDRAT/MMPM,100\nGOTO/0,0,0\n";
    let report = posted::<Cb>(&Config::default(), down).1;
    assert_eq!(report.diagnostics[0].text, "every tool axis of this program points into the table");
}

#[test]
fn more_tools_than_any_magazine_holds_are_refused() {
    let calls = |count: u32| {
        let calls: String = (1..=count).map(|n| format!("LOADTL/{n}\nGOTO/0,0,{n},0,0,1\n")).collect();
        let mut config = Config::default();
        config.motion.retract.distance_mm = Some(9.0);
        posted::<Cb>(&config, &format!("UNITS/MM\nSPINDL/RPM,100,CLW\nFEDRAT/9\n{calls}")).1
    };
    let refused = |report: &Report| {
        let found = report.diagnostics.iter().find(|found| found.text.contains("different tools"));
        found.map(|found| found.location.line)
    };
    assert_eq!(refused(&calls(1000)), None);
    assert_eq!(refused(&calls(1002)), Some(3 + 2 * 1000 + 1));
}

#[test]
fn remarks_of_a_kind_are_counted_and_only_so_many_records_are_held_back() {
    let part = PART.replace("RAPID\nGOTO/0,0,20", &format!("{}RAPID\nGOTO/0,0,20", "MACHIN/ABC\n".repeat(5000)));
    let (_, report) = posted::<Cb>(&Config::default(), &part);
    assert!(!report.failed);
    assert_eq!(report.diagnostics.len(), 21);
    assert_eq!(report.diagnostics[20].count, 4980);
    for record in ["PPRINT said between\n", "COOLNT/ON\n", "SPINDL/ON\n", "DELAY/1\n", "FROM/0,0,0\n"] {
        let part = |count| PART.replace("RAPID\nGOTO/0,0,2\n", &format!("{}RAPID\nGOTO/0,0,2\n", record.repeat(count)));
        assert!(!posted::<Cb>(&Config::default(), &part(100)).1.failed, "{record}");
        let report = posted::<Cb>(&Config::default(), &part(20_000)).1;
        assert!(report.diagnostics[0].text.contains("too many records between"), "{record}: {report:?}");
    }
}

#[test]
fn input_and_output_errors_are_told_apart() {
    struct Broken;
    impl Read for Broken {
        fn read(&mut self, _: &mut [u8]) -> io::Result<usize> {
            Err(io::Error::other("gone"))
        }
    }
    impl Seek for Broken {
        fn seek(&mut self, _: SeekFrom) -> io::Result<u64> {
            Ok(0)
        }
    }
    impl Write for Broken {
        fn write(&mut self, _: &[u8]) -> io::Result<usize> {
            Err(io::Error::from(io::ErrorKind::BrokenPipe))
        }
        fn flush(&mut self) -> io::Result<()> {
            Ok(())
        }
    }
    let config = Config::default();
    let job = Job { cl_name: "a", config: &config, control: &LinuxCnc, units: None };
    assert!(matches!(post::<Cb>(&job, &mut Broken, &mut Vec::new()), Err(PostError::Input(_))));
    let output = post::<Cb>(&job, &mut Cursor::new(PART), &mut Broken);
    assert!(matches!(output, Err(PostError::Output(error)) if error.kind() == io::ErrorKind::BrokenPipe));
}

/// The control of a first trial is the exception: it posts with the assumption, and says so.
#[test]
fn a_table_that_rotates_under_axis_positions_needs_the_place_of_the_part() {
    let errors = |control: &dyn Control, change: fn(&mut Config), text: &str| {
        let mut config = crate::config::starting_point(control);
        config.motion.mode = crate::options::Mode::Axes;
        change(&mut config);
        let job = Job { cl_name: "bracket.cls", config: &config, control, units: None };
        let report = post::<Cb>(&job, &mut Cursor::new(text), &mut Vec::new()).expect("memory neither fails nor fills");
        let errors = report.diagnostics.into_iter().filter(|found| found.severity == Severity::Error);
        errors.map(|error| (error.location.line, error.text)).collect::<Vec<_>>()
    };
    let upright = PART.replace(",0.5,0,0.8660254", "");
    let given: [fn(&mut Config); 2] = [
        |config| {
            config.given.insert("part_origin");
        },
        |config| config.set_up.part_origin = [0.0, 0.0, 80.0],
    ];
    for control in control::CONTROLS.iter().copied() {
        let found = errors(control, |_| {}, PART);
        if control::is_default_family(control) {
            assert_eq!(found, []);
        } else {
            assert_eq!(found.len(), 1, "{found:?}");
            assert_eq!(found[0].0, 19, "the first motion with a tilted tool: {found:?}");
            assert!(found[0].1.contains("the place of the part on it is not known"), "{found:?}");
        }
        given.iter().for_each(|given| assert_eq!(errors(control, *given, PART), []));
        assert_eq!(errors(control, |_| {}, &upright), []);
    }
}

#[test]
fn an_empty_file_is_no_program() {
    let mut config = Config::default();
    config.set_up.part_origin = [0.0; 3];
    let (text, report) = posted::<Cb>(&config, "");
    assert!(report.failed, "an empty file has no motion");
    assert!(!text.contains("M2\n"));
}

#[test]
fn a_rapid_that_cannot_be_posted_is_reported_together_with_a_later_error_of_the_reader() {
    let mut config = Config::default();
    config.motion.guards.floor_mm = Some(-10.0);
    let broken = PART.replace("GOTO/25,0,-3\n", "GOTO/25,0,-3\nRAPID\nGOTO/25,0,-30\nNOSUCHWORD/1\n");
    let (text, report) = posted::<Cb>(&config, &broken);
    let errors: Vec<_> = report.diagnostics.iter().filter(|found| found.severity == Severity::Error).collect();
    assert_eq!(errors.len(), 2, "{report:?}");
    assert!(errors[0].text.contains("below `floor`") && text.contains("below `floor`"), "{report:?}");
}
