//! Tests of posting, from CL text to the bytes of a program.

use std::io::{self, Cursor, Read, Seek, SeekFrom, Write};

use nalgebra::{Matrix3, Rotation3, Vector3};

use super::*;
use crate::control::{Heidenhain, LinuxCnc, Siemens};
use crate::motion::machines::{Cb, Head, Xyz};
use crate::motion::{Mode, Operations, Wrap};
use crate::program::{Clearance, ClearancePlane, Rotation};
use crate::set_up::GivenTool;

const PART: &str = "\
PARTNO BRACKET
UNITS/MM
TOOL PATH/ROUGH,TOOL,D10
CUTTER/10.0,0.5
LOADTL/1
SPINDL/RPM,6000,CLW
COOLNT/ON
RAPID
GOTO/0,0,20,0,0,1
RAPID
GOTO/0,0,2
FEDRAT/MMPM,800
GOTO/0,0,-3
GOTO/25,0,-3
END-OF-PATH
TOOL PATH/SIDE,TOOL,D10
LOADTL/1
FEDRAT/MMPM,300
GOTO/25,0,0,0.5,0,0.8660254
GOTO/25,8,0
FINI
";

fn posted<M: Machine>(config: &Config, text: &str) -> (String, Report) {
    let job = Job { cl_name: "bracket.cls", config, control: &LinuxCnc, units: None };
    let mut out = Vec::new();
    let report = post::<M>(&job, &mut Cursor::new(text.as_bytes()), &mut out).expect("memory neither fails nor fills");
    (String::from_utf8(out).expect("ASCII"), report)
}

/// The lines without the header.
fn blocks(text: &str) -> Vec<&str> {
    text.lines().skip_while(|line| line.starts_with('(')).collect()
}

#[test]
fn a_program_ends_with_its_end_code_and_has_no_fault() {
    let (text, report) = posted::<Cb>(&Config::default(), PART);
    assert_eq!(report.diagnostics, []);
    assert!(!report.failed);
    assert!(text.ends_with("M9\nG53 G0 Z0\nM5\nM2\n"), "{text}");
    assert_eq!(
        blocks(&text)[..11],
        [
            "N1 G21 G17 G40 G49 G80 G90 G94 G54 G64 P0.01",
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
fn a_heidenhain_program_begins_with_the_blank_of_the_configuration_or_a_box_around_the_cuts() {
    let blank = |change: fn(&mut Config), part: &str| -> Vec<String> {
        let mut config = crate::config::starting_point(&Heidenhain);
        change(&mut config);
        let job = Job { cl_name: "bracket.cls", config: &config, control: &Heidenhain, units: None };
        let mut out = Vec::new();
        post::<Cb>(&job, &mut Cursor::new(part.as_bytes()), &mut out).expect("memory neither fails nor fills");
        let text = String::from_utf8(out).expect("ASCII");
        text.lines().skip(1).take_while(|line| line.contains("BLK FORM")).map(str::to_owned).collect()
    };
    // Cuts from X 0 to 25, Y 0 to 8, Z -3 to 0 with a cutter of 10 mm.
    assert_eq!(blank(|_| {}, PART), ["1 BLK FORM 0.1 Z X-5 Y-5 Z-3", "2 BLK FORM 0.2 X+30 Y+13 Z+0"]);
    let wider: fn(&mut Config) = |config| {
        config.set_up.tools.insert(1, GivenTool { diameter_mm: Some(12.0), ..GivenTool::default() });
    };
    assert_eq!(blank(wider, PART)[0], "1 BLK FORM 0.1 Z X-6 Y-6 Z-3");
    let given: fn(&mut Config) = |config| {
        config.set_up.stock = Some(crate::set_up::Stock { lower: [-50.0, -40.0, -30.5], upper: [50.0, 40.0, 0.0] });
        config.set_up.part_origin = [0.0, 0.0, 80.0];
        config.set_up.program_zero = crate::set_up::ProgramZero::Table;
    };
    assert_eq!(blank(given, PART), ["1 BLK FORM 0.1 Z X-50 Y-40 Z+49.5", "2 BLK FORM 0.2 X+50 Y+40 Z+80"]);
    let inches: fn(&mut Config) = |config| config.output_units = Some(Units::Inches);
    assert_eq!(blank(inches, PART)[1], "2 BLK FORM 0.2 X+1.1811 Y+0.5118 Z+0");
    let flat = PART.replace("GOTO/0,0,-3", "GOTO/0,0,0").replace("GOTO/25,0,-3", "GOTO/25,0,0");
    assert_eq!(blank(|_| {}, &flat), Vec::<String>::new(), "a plane is no blank");
}

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
fn a_siemens_program_begins_with_the_name_of_its_file_where_that_is_wanted() {
    let mut config = crate::config::starting_point(&Siemens);
    config.control.file_header = true;
    config.control.program_name = Some("op 10: a bracket with a long name".to_owned());
    let job = Job { cl_name: "bracket.cls", config: &config, control: &Siemens, units: None };
    let mut out = Vec::new();
    post::<Cb>(&job, &mut Cursor::new(PART.as_bytes()), &mut out).expect("memory neither fails nor fills");
    let text = String::from_utf8(out).expect("ASCII");
    assert!(text.starts_with("%_N_OP_10__A_BRACKET_WITH_A__MPF\n;$PATH=/_N_MPF_DIR\n; PROGRAM"), "{}", &text[..90]);
    assert_eq!(control::unfit(&Cb::default(), &Siemens, config.demands()), Vec::<String>::new());
    assert_eq!(control::unfit(&Cb::default(), &LinuxCnc, config.demands()).len(), 1);
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
fn only_axes_that_do_not_roll_over_have_words_beyond_a_revolution() {
    let line = |control: &dyn Control, wrapped: &str, wrap: Wrap| {
        let mut config = crate::config::starting_point(control);
        config.motion.rotaries.wrap.extend(wrapped.chars().map(|letter| (letter, wrap)));
        let job = Job { cl_name: "bracket.cls", config: &config, control, units: None };
        let mut out = Vec::new();
        post::<Cb>(&job, &mut Cursor::new(PART.as_bytes()), &mut out).expect("memory neither fails nor fills");
        let text = String::from_utf8(out).expect("ASCII");
        text.lines().find_map(|line| Some(line[line.find("ROTARY WORDS")?..].to_owned()))
    };
    let counts = "are absolute and go beyond 360";
    let none = line(&Heidenhain, "", Wrap::Positive).expect("a line");
    assert_eq!(none, format!("ROTARY WORDS {counts}: M127 is in force, so the axes do not take the shortest path"));
    let both = [Wrap::Positive, Wrap::Sign].map(|wrap| line(&Heidenhain, "BC", wrap));
    assert_eq!(both, [None, None]);
    let one = line(&Heidenhain, "C", Wrap::Positive).expect("a line");
    assert_eq!(
        one,
        format!(
            "ROTARY WORDS of B {counts}: M126 is active, so these axes must not be displayed within one revolution"
        )
    );
    let linuxcnc = line(&LinuxCnc, "C", Wrap::Positive).expect("a line");
    assert_eq!(linuxcnc, format!("ROTARY WORDS of B {counts}: the axes must not be wrapped [WRAPPED_ROTARY = 0])"));
}

#[test]
fn the_header_states_the_set_up_that_the_program_is_valid_for() {
    let mut config = Config::default();
    config.set_up.part_origin = [1.0, 2.0, 50.25];
    config.set_up.tools.insert(
        1,
        GivenTool { name: Some("END MILL".into()), length_mm: Some(80.0), offset: Some(21), ..GivenTool::default() },
    );
    config.given.insert("part_origin");
    let (text, _) = posted::<Cb>(&config, PART);
    for line in [
        "(PROGRAM BRACKET)",
        "(CL FILE bracket.cls)",
        "(MACHINE Cb, CONTROL LinuxCNC, MODE axes)",
        "(UNITS mm, WORK OFFSET G54)",
        "(PART ORIGIN X1 Y2 Z50.25 from the reference point of the table)",
        "(WHILE A ROTARY AXIS MOVES the tip stays within 0.01 of its line at feed, the tool axis within 0.1 deg)",
        "(AXIS C+ rotates the table left-handed about +Z, as in ISO 841)",
        "(AXIS X+ moves the tool along +X, as in ISO 841)",
        "(linear limits not checked: no machine_zero [X Y Z])",
        "(valid only for part origin X1 Y2 Z50.25 from the reference point of the table; do not touch off again)",
        "(T1 END MILL D10 R0.5 L80 H21, 2 operations, tip Z -3 to 20)",
        "(ASSUMED work offset G54)",
    ] {
        assert!(text.lines().any(|found| found == line), "missing {line} in\n{text}");
    }
    assert!(!text.contains("part_origin 0"));
    assert!(text.lines().all(|line| line.len() < 255 && line.is_ascii()));
}

#[test]
fn a_program_for_a_head_states_the_length_it_was_posted_with() {
    let text = PART.replace("LOADTL/1\nSPINDL", "LOADTL/1,LENGTH,95.5\nSPINDL");
    let mut config = Config::default();
    config.motion.retract = crate::motion::Retract { distance_mm: Some(30.0), ..Config::default().motion.retract };
    let (text, report) = posted::<Head>(&config, &text);
    assert_eq!(report.diagnostics, []);
    assert!(text.contains("(T1 posted with L = 95.5: H1 must hold exactly this)"), "{text}");
    assert!(!text.contains("touch off"));
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
fn blocks_of_the_configuration_come_after_the_header_and_before_the_end() {
    let mut config = Config::default();
    config.control.program.start = vec!["G64 P0.01".into()];
    config.control.program.end = vec!["M64 P0".into()];
    config.control.program.line_numbers = Some(5);
    let (text, _) = posted::<Cb>(&config, PART);
    assert_eq!(blocks(&text)[..3], ["G64 P0.01", "(OPERATION ROUGH)", "N5 G21 G17 G40 G49 G80 G90 G94 G54 G64 P0.01"]);
    assert!(text.contains("M64 P0\nN"), "{text}");
}

#[test]
fn the_same_input_gives_the_same_bytes() {
    assert_eq!(posted::<Cb>(&Config::default(), PART), posted::<Cb>(&Config::default(), PART));
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

#[test]
fn an_empty_file_is_no_program() {
    let mut config = Config::default();
    config.set_up.part_origin = [0.0; 3];
    let (text, report) = posted::<Cb>(&config, "");
    assert!(report.failed, "an empty file has no motion");
    assert!(!text.contains("M2\n"));
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
fn the_header_states_the_required_rotary_entries_of_the_work_offset() {
    let mut config = Config::default();
    config.set_up.rotary_offset.insert('C', 12.5_f64.to_radians());
    let (text, _) = posted::<Cb>(&config, PART);
    assert!(text.contains("(words of C are the axis value minus 12.5: its entry in G54 must be 12.5)"), "{text}");
    assert!(text.contains("(the entries of B in G54 must be zero)"), "{text}");
    assert!(posted::<Cb>(&Config::default(), PART).0.contains("(the entries of C and B in G54 must be zero)"));
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

const FOUR: &str = "\
UNITS/MM
TOOL PATH/ROUGH,TOOL,D10
LOADTL/1
SPINDL/RPM,6000,CLW
COOLNT/ON
FEDRAT/MMPM,800
GOTO/0,0,2,0,0,1
GOTO/9,0,2
TOOL PATH/SIDE,TOOL,D10
GOTO/25,0,0,-0.5,0,0.8660254
GOTO/25,8,0
STOP
PPRINT NOW THE FINISH
TOOL PATH/FINISH,TOOL,D6
LOADTL/2
SPINDL/RPM,9000,CLW
GOTO/25,9,0,0.6,0,0.8
GOTO/25,19,0
RAPID
GOTO/25,19,80
TOOL PATH/CHAMFER,TOOL,D6
GOTO/5,9,0,0,0.6,0.8
GOTO/5,19,0
FINI
";

/// The blocks of each operation by its number: from its restart point to that of the next.
fn by_operation(text: &str) -> std::collections::BTreeMap<u64, Vec<&str>> {
    let mut operations = std::collections::BTreeMap::new();
    let mut number = 0;
    for line in text.lines() {
        let restart = line.strip_prefix('N').and_then(|rest| rest.split(' ').next()?.parse().ok());
        number = restart.unwrap_or(number);
        operations.entry(number).or_insert_with(Vec::new).push(line);
    }
    operations
}

/// Blocks that move the tool in the coordinates of the program.
fn moving<'l>(lines: &[&'l str]) -> Vec<&'l str> {
    let moves = |line: &&&str| line.contains(['X', 'Y', 'Z', 'B', 'C']) && !line.contains('(') && !line.contains("G53");
    lines.iter().filter(moves).copied().collect()
}

#[test]
fn an_operation_that_is_posted_alone_moves_as_it_does_in_the_whole_program() {
    let (whole, report) = posted::<Cb>(&Config::default(), FOUR);
    assert!(!report.failed, "{report:?}");
    let all = by_operation(&whole);
    for (first, last) in [(1, 1), (1, 2), (2, 2), (2, 3), (3, 4), (4, 4)] {
        let operations = Some(Operations::Range(first, Some(last)));
        let mut config = Config::default();
        config.motion.operations = operations;
        let (text, report) = posted::<Cb>(&config, FOUR);
        assert!(!report.failed && text.ends_with("M5\nM2\n"), "{report:?}\n{text}");
        assert!(text.contains(&format!("only operations {first} to {last} of 4")), "{text}");
        assert_eq!(report.tools.len(), if (first, last) == (2, 3) { 2 } else { 1 });
        let some = by_operation(&text);
        let restarts: Vec<u64> = some.keys().copied().filter(|number| *number > 0).collect();
        assert_eq!(restarts, (first..=last).collect::<Vec<_>>(), "{text}");
        for (number, blocks) in some.iter().filter(|(number, _)| **number > 0) {
            assert_eq!(moving(blocks), moving(&all[number]), "N{number} of {first}..{last}\n{text}\n{whole}");
            assert!(blocks.contains(&"M8"), "the coolant that was asked for before");
        }
        assert_eq!(report.statistics.motions, 2 * (last - first + 1) + u64::from(first <= 3 && last >= 3));
        let top: Vec<&str> = blocks(&text).into_iter().filter(|block| !block.starts_with('(')).collect();
        assert!(top[0].starts_with('N') && top[3].ends_with(" M6"), "{top:?}");
    }
}

#[test]
fn without_transitions_an_operation_that_is_posted_alone_is_entered_and_left_safely() {
    let operations = Some(Operations::Range(2, Some(2)));
    let transition = crate::motion::Transition::Direct;
    let mut config = Config::default();
    config.motion.operations = operations;
    config.motion.rapids.transition = transition;
    let (text, report) = posted::<Cb>(&config, FOUR);
    assert!(!report.failed, "{report:?}");
    let blocks = blocks(&text);
    assert!(blocks[0].starts_with("N2 G21") && blocks.contains(&"T1 M6"), "{text}");
    assert!(text.ends_with("G53 G0 Z0\nM5\nM2\n"), "{text}");
    let moving: Vec<&str> = moving(&blocks).into_iter().filter(|block| block.contains(['X', 'Y'])).collect();
    assert_eq!(moving.len(), 2, "above the first point, and to the second: {text}");
}

#[test]
fn records_between_operations_belong_to_the_operation_they_refer_to() {
    let some = |first, last| {
        let operations = Some(Operations::Range(first, Some(last)));
        let mut config = Config::default();
        config.motion.operations = operations;
        posted::<Cb>(&config, FOUR).0
    };
    let second = some(2, 2);
    assert!(second.contains("(OPERATION SIDE)") && second.contains("M0") && !second.contains("FINISH"), "{second}");
    assert!(second.contains("S6000 M3") && second.contains("T1 M6"), "{second}");
    let third = some(3, 4);
    assert!(third.contains("(NOW THE FINISH)\n(OPERATION FINISH)\nN3 "), "{third}");
    assert!(!third.contains("M0\n") && !third.contains("SIDE"), "{third}");
}

#[test]
fn operations_are_found_by_name_and_a_missing_one_is_reported() {
    let post = |operations| {
        let mut config = Config::default();
        config.motion.operations = Some(operations);
        let job = Job { cl_name: "a", config: &config, control: &LinuxCnc, units: None };
        let mut out = Vec::new();
        post::<Cb>(&job, &mut Cursor::new(FOUR.as_bytes()), &mut out).map(|_| String::from_utf8(out).expect("ASCII"))
    };
    let named = |name: &str| post(Operations::From(name.to_owned()));
    assert_eq!(named("finish").expect("there"), post(Operations::Range(3, None)).expect("there"));
    let said = |result: Result<String, PostError>| result.expect_err("not there").to_string();
    assert_eq!(said(named("FINISHH")), "no operation of the CL data is called `FINISHH`: did you mean `FINISH`?");
    assert!(said(named("x")).contains("its operations are `ROUGH`, `SIDE`, `FINISH`, `CHAMFER`"));
    assert_eq!(said(post(Operations::Range(3, Some(5)))), "the CL data has 4 operations: there is no operation 5");
    assert!(said(post(Operations::Range(7, None))).contains("no operation 7"));
}

#[test]
fn clamps_hold_the_axes_of_an_operation_that_does_not_turn_them() {
    let mut config = Config::default();
    let codes = crate::motion::ClampCodes { on: "M10".to_owned(), off: "M11".to_owned() };
    config.motion.rotaries.clamp.insert('C', codes);
    let (text, report) = posted::<Cb>(&config, FOUR);
    assert!(!report.failed, "{report:?}");
    assert_eq!(text.matches("\nM11\nG0 B").count(), 4, "{text}");
    assert_eq!(text.matches("\nM10\n").count(), 4, "{text}");
    let (plain, _) = posted::<Cb>(&Config::default(), FOUR);
    assert_eq!(text.replace("M10\n", "").replace("M11\n", ""), plain);
}

#[test]
fn the_last_operation_that_is_posted_is_left_along_the_tool() {
    let mut config = Config::default();
    config.motion.operations = Some(Operations::Range(1, Some(1)));
    config.motion.rapids.transition = crate::motion::Transition::Direct;
    config.motion.retract.distance_mm = Some(12.0);
    let (text, report) = posted::<Cb>(&config, FOUR);
    assert!(!report.failed, "{report:?}");
    assert!(text.ends_with("\nM9\nG0 Z14\nG53 G0 Z0\nM5\nM2\n"), "{text}");
}

#[test]
fn a_rapid_before_the_first_tool_is_no_operation() {
    let early = FOUR.replace("TOOL PATH/ROUGH", "RAPID\nGOTO/0,0,90,0,0,1\nTOOL PATH/ROUGH");
    let operations = Some(Operations::Range(4, None));
    let mut config = Config::default();
    config.motion.operations = operations;
    let (text, report) = posted::<Cb>(&config, &early);
    assert!(!report.failed && report.set_up[0].contains("4 to 4 of 4"), "{report:?}");
    assert!(text.contains("(OPERATION CHAMFER)\nN4 "), "{text}");
}

/// The last operation holds B, which the one before it rotates at feed.
const TURNS_THEN_HOLDS: &str = "\
UNITS/MM
LOADTL/1
SPINDL/RPM,6000,CLW
FEDRAT/MMPM,800
TOOL PATH/FIRST,TOOL,D10
RAPID
GOTO/0,0,20,0,0,1
GOTO/0,0,0
TOOL PATH/TURNS,TOOL,D10
GOTO/5,0,0,0.1,0,0.99498743710662
GOTO/10,0,0,0.2,0,0.9797958971132712
GOTO/12,0,30
LOADTL/2
SPINDL/RPM,6000,CLW
TOOL PATH/HOLDS,TOOL,D6
RAPID
GOTO/0,0,20,0,0,1
GOTO/0,0,0
GOTO/9,0,0
";

#[test]
fn clamps_of_some_operations_are_open_where_these_turn_an_axis() {
    let mut config = Config::default();
    let codes = crate::motion::ClampCodes { on: "M12".to_owned(), off: "M13".to_owned() };
    config.motion.rotaries.clamp.insert('B', codes);
    config.motion.rapids.transition = crate::motion::Transition::Direct;
    config.motion.retract.distance_mm = Some(50.0);
    for operations in [None, Some(Operations::Range(2, Some(3)))] {
        config.motion.operations = operations;
        let (text, report) = posted::<Cb>(&config, TURNS_THEN_HOLDS);
        assert!(!report.failed, "{report:?}");
        let (mut on, mut here, mut turns) = (None, None, 0);
        for line in text.lines().filter(|line| !line.starts_with('(')) {
            match line {
                "M12" => on = Some(true),
                "M13" => on = Some(false),
                _ => {}
            }
            let word = line.split(' ').find_map(|word| word.strip_prefix('B'));
            if let Some(there) = word.filter(|there| here != Some(*there)) {
                assert_eq!(on, Some(false), "B turns under its clamp in `{line}`:\n{text}");
                (here, turns) = (Some(there), turns + 1);
            }
        }
        assert!(turns > 3, "{text}");
    }
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
