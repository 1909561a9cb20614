//! The first lines of a program: header, blank, name of the file.

use super::*;
use crate::control::{Heidenhain, Siemens};
use crate::kinematics::Limits;
use crate::kinematics::machines::Head;
use crate::options::Wrap;
use crate::set_up::GivenTool;

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
    let narrower: fn(&mut Config) = |config| {
        let tool = GivenTool { diameter_mm: Some(8.0), path_diameter_mm: Some(10.0), ..GivenTool::default() };
        config.set_up.tools.insert(1, tool);
    };
    assert_eq!(blank(narrower, PART)[0], "1 BLK FORM 0.1 Z X-4 Y-4 Z-3");
    let given: fn(&mut Config) = |config| {
        config.set_up.stock =
            Some(crate::set_up::Stock { lower: [-50.0, -40.0, -30.5], upper: [50.0, 40.0, 0.0], round: false });
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
    let (text, report) = posted::<Cb>(&config, PART);
    let left_out = "LinuxCNC has no file header: `control.file_header` is left out";
    assert!(report.set_up.iter().any(|line| line == left_out), "{:?}", report.set_up);
    assert!(text.contains(&format!("({left_out})")), "{text}");
}

#[test]
fn travels_that_are_wider_than_those_of_the_machine_are_named() {
    let machine = crate::kinematics::machines::Cb::default();
    let axis = machine.axes().iter().find(|axis| axis.limits.is_some()).expect("an axis with a travel");
    let declared = axis.limits.expect("a travel");
    let wider = Some(Limits { upper: declared.upper + 0.1, ..declared });
    let narrower = Some(Limits { upper: declared.upper - 0.1, ..declared });
    for (given, named) in [(wider, true), (None, true), (narrower, false), (Some(declared), false)] {
        let mut config = Config::default();
        config.set_up.limits.insert(axis.letter, given);
        let (text, report) = posted::<Cb>(&config, PART);
        let line = format!("`limits` of {} are wider than declared for the machine", axis.letter);
        assert_eq!(report.summary().join("\n").contains(&line), named, "{given:?}");
        assert_eq!(text.contains(&line), named, "{text}");
    }
}

#[test]
fn only_axes_that_pass_a_revolution_and_do_not_roll_over_have_words_beyond_it() {
    let line = |control: &dyn Control, wrapped: &str, b_lower_deg: f64| {
        let mut config = crate::config::starting_point(control);
        config.motion.mode = crate::options::Mode::Axes;
        config.motion.rotaries.wrap.extend(wrapped.chars().map(|letter| (letter, Wrap::Positive)));
        let limits = Limits { lower: b_lower_deg.to_radians(), upper: 110_f64.to_radians() };
        config.set_up.limits.insert('B', Some(limits));
        let job = Job { cl_name: "bracket.cls", config: &config, control, units: None };
        let mut out = Vec::new();
        post::<Cb>(&job, &mut Cursor::new(PART.as_bytes()), &mut out).expect("memory neither fails nor fills");
        let text = String::from_utf8(out).expect("ASCII");
        text.lines().find_map(|line| Some(line[line.find("ROTARY WORDS")?..].to_owned()))
    };
    let (within, beyond) = (0.0, -35.0);
    let counts = "are absolute and may go below 0 or beyond 360";
    let not_shortest = "M127 is in force, so the axes do not take the shortest path";
    let displayed = "M126 is active, so these axes must not be displayed within one revolution";
    let unwrapped = "the axes must not be wrapped [WRAPPED_ROTARY = 0])";
    assert_eq!(line(&Heidenhain, "", within), Some(format!("ROTARY WORDS of C {counts}: {not_shortest}")));
    assert_eq!(line(&Heidenhain, "", beyond), Some(format!("ROTARY WORDS {counts}: {not_shortest}")));
    assert_eq!(line(&Heidenhain, "C", within), None);
    assert_eq!(line(&Heidenhain, "C", beyond), Some(format!("ROTARY WORDS of B {counts}: {displayed}")));
    assert_eq!(line(&Heidenhain, "BC", beyond), None);
    assert_eq!(line(&LinuxCnc, "C", within), None);
    assert_eq!(line(&LinuxCnc, "C", beyond), Some(format!("ROTARY WORDS of B {counts}: {unwrapped}")));
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
        "(MACHINE Cb, CONTROL LinuxCNC, MODE auto [axes])",
        "(UNITS mm, WORK OFFSET G54)",
        "(PART ORIGIN X1 Y2 Z50.25 from the reference point of the table)",
        "(WHILE A ROTARY AXIS MOVES the tip stays within 0.01 of its line at feed, the tool axis within 0.1 deg of its great circle)",
        "(AXIS C+ rotates the table left-handed about +Z, as in ISO 841)",
        "(AXIS X+ moves the tool along +X, as in ISO 841)",
        "(linear limits not checked: no machine_zero [X Y Z])",
        "(valid only for part origin X1 Y2 Z50.25 from the reference point of the table; do not touch off again)",
        "(T1 END MILL DIA 10 R0.5 L80 H21, 2 operations, tip Z -3 to 20)",
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
    config.motion.retract = crate::options::Retract { distance_mm: Some(30.0), ..Config::default().motion.retract };
    let (text, report) = posted::<Head>(&config, &text);
    assert_eq!(report.diagnostics, []);
    assert!(text.contains("(T1 posted with L = 95.5: H1 must hold exactly this)"), "{text}");
    assert!(!text.contains("touch off"));
    assert!(text.contains("(the entries of B and A in G54 must be zero)"), "{text}");
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
