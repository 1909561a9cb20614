//! Programs in which the choice of the control, or the rounding of words, decides: each is posted and passes its check.
//!
//! Tool vectors near a pole, where the control finds the rotary angles; helices by angle; points closer together than
//! the words; blocks of nothing but rounding, and their F; the sense in which a table rotates to an operation.

use std::io::Cursor;

use machines::{Dmu70e, LolaXoyzba, MultiProDesk, SpinnerU5620};
use pp_runtime::check::check;
use pp_runtime::config::starting_point;
use pp_runtime::diag::Severity;
use pp_runtime::kinematics::Machine;
use pp_runtime::post::{Job, post};
use tests::by_name;
use tests::further::HeadTable;

const DEFAULTS: &str = "[defaults]\nspeed = 2000\ndirection = \"CLW\"\n";

/// A program, and the findings of its check.
struct Checked {
    program: String,
    findings: Vec<String>,
}

/// Posts CL data and checks the program after `edit`.
fn checked<M: Machine>(control: &str, keys: &str, cl: &str, edit: impl Fn(&str) -> String) -> Checked {
    let control = by_name::control(control);
    let origin = if keys.contains("part_origin") { "" } else { "part_origin = [0.0, 0.0, 0.0]\n" };
    let keys = format!("{origin}{keys}{DEFAULTS}");
    let config = starting_point(control).read_over(&M::default(), &keys).expect("valid keys");
    let job = Job { cl_name: "near.cls", config: &config, control, units: None };
    let mut program = Vec::new();
    let report = post::<M>(&job, &mut Cursor::new(cl), &mut program).expect("it can run");
    assert!(!report.failed, "{:?}", report.diagnostics);
    let program = edit(&String::from_utf8(program).expect("ASCII"));
    let policy = config.check_policy::<M>(control, None).expect("it can be checked");
    let outcome = check::<M>(&policy, Cursor::new(cl), program.as_bytes()).expect("it can be read").outcome;
    Checked { findings: outcome.findings.iter().map(|found| found.diagnostic().text).collect(), program }
}

/// A program that passes its check.
fn passes<M: Machine>(control: &str, keys: &str, cl: &str) -> String {
    let Checked { program, findings } = checked::<M>(control, keys, cl, str::to_owned);
    assert!(findings.is_empty(), "{program}\n{findings:?}");
    program
}

const LIMITED: &str = "[limits]\nC = [-200, 200]\n[retract]\ndistance = 40.0\n";

/// Two cuts past the pole at 0.002° and back, 60 mm of retract.
const PAST_THE_POLE: &str = "UNITS/MM\nLOADTL/2\nFEDRAT/MMPM,2777\n\
    GOTO/-14.106,-15.353,-0.988,0.022846,-0.003116,0.999734\n\
    GOTO/-12.229,-7.705,-2.864,-0.000513,0.000106,1.000000\n\
    GOTO/-17.477,-7.705,-2.205,0.022215,-0.006174,0.999734\n";

#[test]
fn tool_vectors_lead_through_a_pole_that_they_pass_closely() {
    for posture in ["axes", "plane"] {
        let keys = format!("tcp_words = \"vectors\"\ntool_posture = \"{posture}\"\n{LIMITED}");
        let at_pole = |program: &str, pole: &str| program.lines().filter(|line| line.contains(pole)).count();
        let siemens = passes::<HeadTable>("siemens", &keys, PAST_THE_POLE);
        assert_eq!(at_pole(&siemens, "A3=0 B3=0 C3=1"), 2, "{siemens}");
        let heidenhain = passes::<SpinnerU5620>("heidenhain", &keys, PAST_THE_POLE);
        assert_eq!(at_pole(&heidenhain, "TX+0 TY+0 TZ+1"), 2, "{heidenhain}");
    }
}

#[test]
fn words_of_rotary_axes_do_not_need_a_point_at_the_pole() {
    let program = passes::<HeadTable>("siemens", LIMITED, PAST_THE_POLE);
    assert!(!program.contains("A3="), "{program}");
}

#[test]
fn a_tool_vector_at_the_pole_is_found_where_the_motion_is_not_near_it() {
    let keys = format!("tcp_words = \"vectors\"\n{LIMITED}");
    let cl = PAST_THE_POLE.replace("-0.000513,0.000106,1.000000", "-0.000513,0.030106,0.999547");
    let away = |program: &str| {
        assert!(!program.contains("A3=0 B3=0 C3=1"), "{program}");
        let lines = program.lines().map(|line| match line.split_once(" A3=") {
            Some((linear, _)) if line.starts_with("X-12.") => format!("{linear} A3=0 B3=0 C3=1"),
            _ => line.to_owned(),
        });
        lines.collect::<Vec<_>>().join("\n") + "\n"
    };
    let Checked { program, findings } = checked::<HeadTable>("siemens", &keys, &cl, away);
    assert!(program.contains("A3=0 B3=0 C3=1") && !findings.is_empty(), "{program}");
}

#[test]
fn the_ends_of_helices_by_angle_stay_within_the_tolerance() {
    let cl = "UNITS/INCHES\nMSYS/0,0,0,1,0,0,0,1,0\nLOAD/TOOL,4\nFEDRAT/IPM,26.86603\nLINTOL/0.00026\n\
        MSYS/0.1181102362,0.0787401575,-0.9842519685,-0.888861677,0.081391597,-0.450888375,-0.264656588,0.712106707,\
        0.650277578\n\
        GOTO/-0.76694,3.34159,-1.86358,-0.4508884,0.6502776,-0.6114235\nGOTO/1.67131,-0.14570,-3.94351\n\
        CIRCLE/1.71100,0.24152,-3.59814,-0.4508884,0.6502776,-0.6114235,0.51988,0.0600,0.5000,10.0000,0.0000,TIMES,4\n\
        GOTO/1.65786,-0.13182,-3.95602\n";
    passes::<SpinnerU5620>("heidenhain", "[cl]\nframes = \"main\"\n", cl);
}

#[test]
fn a_block_after_points_of_the_same_words_belongs_to_its_own_point() {
    let cl = "UNITS/MM\nLOAD/TOOL,1\nTLAXIS/-0.016680,-0.004305,0.999852\nRAPID\nGOTO/64.16400,14.65899,46.64059\n\
        FEDRAT/MMPM,2510.73944\nGOTO/98.58791,5.45802,16.61509\nGOTO/110.91700,-17.26891,16.72293\n\
        GOTO/110.91636,-17.26826,16.72292\nGOTO/110.91944,-17.27388,16.72295,-0.016680,-0.004305,0.999852\n\
        GOTO/110.13484,-17.47636,63.75343\n";
    let keys = "part_rotation = [0.0, 0.0, 30.0]\nmode = \"plane\"\n[formats]\nlinear_mm = 2\n";
    passes::<LolaXoyzba>("fanuc", keys, cl);
}

/// Two holes whose levels along the tool axis are 0.0005 mm apart: the tool lifts by one unit between them.
const NEARLY_LEVEL: &str = "UNITS/MM\nTOOL PATH/OP_38,TOOL,T2\nLOAD/TOOL,2\nTLAXIS/0.01950980,0.01950980,0.99961930\nRAPID\nGOTO/-1.042,-40.930,36.400\n\
    CYCLE/BORE,RAPTO,11.864,FEDTO,-7.834,MMPM,310.388\nGOTO/38.176,-39.343,-2.880\nGOTO/32.000,-66.394,-2.231\n";

const RAPIDS_AT_FEED: &str = "mode = \"tcp\"\nrapid = \"feed\"\nrapid_feed = 8000.0\n[feed]\nshortest_block = 0.01\n";

#[test]
fn a_lift_of_one_unit_between_two_holes_has_the_f_of_its_own_length() {
    // 0.001 mm in 0.01 s.
    let program = passes::<Dmu70e>("heidenhain", RAPIDS_AT_FEED, NEARLY_LEVEL);
    assert!(program.contains(" L Z+8.98 F6\n"), "{program}");
}

#[test]
fn a_wrong_f_of_a_lift_between_two_holes_is_found() {
    let wrong = |program: &str| program.replace(" L Z+8.98 F6\n", " L Z+8.98 F9000\n");
    let Checked { program, findings } = checked::<Dmu70e>("heidenhain", RAPIDS_AT_FEED, NEARLY_LEVEL, wrong);
    assert!(program.contains("F9000") && findings.iter().any(|text| text.starts_with("F is 9000")), "{findings:?}");
}

/// A motion to 0.0001 degrees from the pole: at the pole C rotates, and B follows in a block in which no coordinate of
/// the tip changes.
const NEAR_THE_POLE: &str = "UNITS/INCHES\nLOADTL/3\nFEDRAT/IPM,67.0930\n\
    GOTO/-0.6327,-0.8250,-0.6136,-0.008481,0.002044,0.999962\n\
    GOTO/-0.8493,-1.0150,-0.6803,0.000002,-0.000000,1.000000\nGOTO/-0.8493,-1.0150,1.3957,0.000002,-0.000000,1.000000\n";

#[test]
fn a_block_in_which_no_coordinate_of_the_tip_changes_has_the_f_of_its_rotation() {
    let program = passes::<Dmu70e>("siemens", "mode = \"tcp\"\n", NEAR_THE_POLE);
    // Both rotations at the reorientation speed, so F is not repeated.
    assert!(program.contains("\nC0.0001 F1800\nB0.0002\nZ1.3957 F67.093\n"), "{program}");
}

#[test]
fn the_f_of_a_tool_vector_that_ends_a_motion_is_that_of_a_rotation() {
    let keys = "mode = \"tcp\"\ntcp_words = \"vectors\"\ntool_posture = \"plane\"\nreorient_speed = 720.0\n\
        [control]\nevery_word = true\n[feed]\nshortest_block = 0.01\n";
    let program = passes::<Dmu70e>("siemens", keys, NEAR_THE_POLE);
    // C rotates by 166 degrees at the pole, at the reorientation speed.
    assert!(program.contains(" A3=0.000002 B3=0 C3=1 F720\n"), "{program}");
}

#[test]
fn the_position_after_a_cycle_has_x_and_y_of_its_words() {
    // On the way back along the axis of the CL data, 0.00036 degrees from that of the words, Y would be 0.001 mm less.
    let cl = "UNITS/MM\nTLDATA/MILL,10.000,1.500,50.000,0.0000,0.0000\nLOADTL/4\nFEDRAT/MMPM,1342.145\nTOOL PATH/OP_65,TOOL,T1\n\
        GOTO/-20.595,-24.581,60.254,0.000000,-0.539236,0.842155\n\
        CYCLE/BORE,RAPTO,11.235,FEDTO,-4.731,RTRCTO,AUTO,MMPM,343.062\nGOTO/30.000,-25.536,-4.049\nCYCLE/OFF\n\
        GOTO/30.000,-54.459,41.123\nGOTO/-47.191,-101.543,10.846\n";
    let keys = "mode = \"plane\"\ncl_point = \"centre\"\n\
        [retract]\nclearance = { box = [[-200, -200, -200], [200, 200, 200]] }\n";
    let program = passes::<MultiProDesk>("haas", keys, cl);
    assert!(
        program.contains(" G85 X30. Y23.689 ") && program.contains("G80\nG01 Y23.688 Z62.498 F1342.15\n"),
        "{program}"
    );
}

/// `program` with F of its first line that begins so multiplied by a factor.
fn with_f(program: &str, begins: &str, factor: f64) -> String {
    let line = program.lines().find(|line| line.starts_with(begins)).expect("a line");
    let (words, feed) = line.split_once('F').expect("F");
    let feed: f64 = feed.parse().expect("a number");
    program.replacen(line, &format!("{words}F{:.3}", feed * factor), 1)
}

/// A tool axis 0.27 degrees from the pole that is put there, where C rotates before the next cut.
const AT_THE_POLE: &str = "UNITS/MM\nLOADTL/2,LENGTH,80\nFEDRAT/MMPM,1170.171638\n\
    GOTO/69.142022,77.189763,-28.026708,-0.014994671,-0.030716479,0.999415658\n\
    GOTO/66.387277,73.239454,-29.190922,0.001715275,0.004375852,0.999988955\n\
    GOTO/61.510891,71.412363,-29.230504,-0.009873157,-0.032724044,0.999415658\n";

#[test]
fn the_f_of_a_cut_after_a_rotation_at_the_pole_is_that_of_its_tip_path() {
    let keys = |rest: &str| format!("{rest}[course]\naxis_tolerance = 0.5\n[retract]\ndistance = 75.0\n");
    let linuxcnc = keys("mode = \"tcp\"\n[control]\ntip_control = [\"M428\", \"M429\"]\n");
    let cut = "X61.511 Y71.412 Z-29.231 B-1.9588 F";
    let program = passes::<SpinnerU5620>("linuxcnc", &linuxcnc, AT_THE_POLE);
    assert!(program.contains(&format!("\nC73.2109 F1800\n{cut}1170.172\n")), "{program}");
    for factor in [0.97, 1.02] {
        let wrong = |program: &str| with_f(program, cut, factor);
        let found = checked::<SpinnerU5620>("linuxcnc", &linuxcnc, AT_THE_POLE, wrong).findings;
        assert!(found.len() == 1 && found[0].contains("expected 1170.17"), "{found:?}");
    }
    for control in by_name::controls_with_tip_control() {
        for mode in ["axes", "tcp"] {
            passes::<SpinnerU5620>(
                control,
                &keys(&format!("mode = \"{mode}\"\ntcp_frame = \"table_at_zero\"\n")),
                AT_THE_POLE,
            );
            passes::<HeadTable>(
                control,
                &keys(&format!("mode = \"{mode}\"\ntcp_frame = \"table_at_zero\"\n")),
                AT_THE_POLE,
            );
        }
    }
}

#[test]
fn a_block_under_tip_control_takes_as_long_as_an_axis_needs_at_its_fastest() {
    // Past the pole C rotates fast and Y follows, up to twice as fast at one end of a block as at the other.
    let cl = "UNITS/MM\nLOADTL/3\nFEDRAT/MMPM,379.657\n\
        GOTO/34.902,49.411,25.135,0.082571215,-0.223786069,0.971134280\n\
        GOTO/29.609,53.766,26.278,-0.004133440,0.025848545,0.999657325\n";
    let keys = "part_origin = [-18.0, -44.1325, -39.5468]\nmode = \"tcp\"\n[speeds]\nY = 10000.0\n[retract]\ndistance = 75.0\n\
        [control]\ntip_control = [\"M428\", \"M429\"]\n";
    let program = passes::<SpinnerU5620>("linuxcnc", keys, cl);
    let slowed: Vec<&str> = program.lines().filter(|line| line.contains(" C") && line.contains(" F")).skip(1).collect();
    assert!(slowed.len() >= 4, "{program}");
    for line in &slowed[..slowed.len() - 1] {
        let (words, _) = line.split_once('F').expect("F");
        for factor in [0.92, 1.08] {
            let found =
                checked::<SpinnerU5620>("linuxcnc", keys, cl, |program| with_f(program, words, factor)).findings;
            assert!(!found.is_empty(), "{line}, {factor} times as fast");
        }
    }
}

/// Two cuts past the pole of a table at 0.032°, to the other side and back: C rotates by 178.7° in each, in the same
/// sense.
const ROUND_THE_POLE: &str = "UNITS/MM\nLOADTL/4\nFEDRAT/MMPM,1200\n\
    GOTO/-11.728,28.571,13.346,0.1559210,0.1980625,0.9677086\n\
    GOTO/-13.984,26.961,12.730,-0.0157005,-0.0209458,0.9996573\n\
    GOTO/-12.983,34.715,14.351,0.1463707,0.2052211,0.9677086\n";

#[test]
fn tool_vectors_keep_the_branch_of_the_control_past_a_pole() {
    for control in ["siemens", "fanuc", "heidenhain"] {
        for posture in ["axes", "plane"] {
            let keys = |words: &str| {
                format!(
                    "mode = \"tcp\"\ntcp_frame = \"table_at_zero\"\ntcp_words = \"{words}\"\ntool_posture = \"{posture}\"\n{LIMITED}"
                )
            };
            // Words lead B to the other side of the pole, where C need not rotate.
            let is_retract = |line: &&str| ["SUPA G0 Z", "G53 G0 Z", "L Z+0"].iter().any(|words| line.contains(words));
            let retracts = |program: &str| program.lines().filter(is_retract).count();
            let angles = passes::<SpinnerU5620>(control, &keys("angles"), ROUND_THE_POLE);
            let vectors = passes::<SpinnerU5620>(control, &keys("vectors"), ROUND_THE_POLE);
            assert!(angles.contains("B-1.5"), "{angles}");
            // The control would rotate C to -305.5°: the axes are rewound.
            assert!(retracts(&vectors) > retracts(&angles), "{control} {posture} {vectors}");
        }
    }
}

#[test]
fn a_rapid_that_rotates_by_half_a_revolution_is_two_blocks_where_the_shorter_path_is_taken() {
    let cl = "UNITS/MM\nLOADTL/3\nFEDRAT/MMPM,2789\nCLEARP/XYPLAN,150\n\
        GOTO/9.911,7.076,39.903,0.0044693,-0.0500849,0.9987350\n\
        GOTO/13.112,13.076,38.771,0,0,1\n\
        GOTO/8.554,18.076,38.457,-0.0222262,0.0451051,0.9987350\nRETRCT\n";
    let keys = "index_angle = 360.0\n[course]\nstart_branch = \"first\"\ngreedy = true\n[wrap]\nC = \"0..360\"\n[tools]\n3 = { length = 78.0 }\n";
    for control in ["siemens", "heidenhain"] {
        let program = passes::<HeadTable>(control, keys, cl);
        assert!(program.contains("26.2324") && program.contains("116.2324"), "{program}");
        // A way round by other angles is found.
        let edit = |program: &str| program.replace("26.2324", "36.2324");
        assert!(!checked::<HeadTable>(control, keys, cl, edit).findings.is_empty());
        // So is a rotation in two blocks by more than a rapid may rotate.
        let keys = keys.replace("360.0", "185.0");
        let edit = |program: &str| program.replace("296.2324", "306.2324").replace("26.2324", "31.2324");
        passes::<HeadTable>(control, &keys, cl);
        assert!(!checked::<HeadTable>(control, &keys, cl, edit).findings.is_empty());
    }
}

#[test]
fn a_pole_passed_too_far_to_lead_through_it_and_too_closely_for_the_control_is_refused_with_tool_vectors() {
    // The tool axis passes the pole at 0.002 degrees, and may leave its path by 0.001.
    let refused = |words: &str| {
        let keys = format!("axis_tolerance_path = 0.001\ntcp_words = \"{words}\"\n{LIMITED}{DEFAULTS}");
        let control = by_name::control("siemens");
        let config = starting_point(control).read_over(&HeadTable::default(), &keys).expect("valid keys");
        let job = Job { cl_name: "near.cls", config: &config, control, units: None };
        let report = post::<HeadTable>(&job, &mut Cursor::new(PAST_THE_POLE), &mut Vec::new()).expect("it can run");
        let error = report.diagnostics.into_iter().find(|found| found.severity == Severity::Error);
        error.map(|error| (error.location.line, error.text, error.help.unwrap_or_default()))
    };
    assert_eq!(refused("angles"), None);
    let (line, text, help) = refused("vectors").expect("an error");
    assert!(
        line == 5 && text.contains("may rotate C by up to 180°") && help.contains("tcp_words"),
        "{line} {text} {help}"
    );
}

#[test]
fn rotabl_next_before_an_operation_holds_for_its_first_motion_alone() {
    let operation = |sense: &str, [x, y]: [f64; 2], [i, j]: [f64; 2]| {
        let point = |z: u32| format!("GOTO/{x},{y},{z},{i},{j},0.8660254038\n");
        format!("TOOL PATH/OP_A,TOOL,T1\n{sense}RAPID\n{}{}RAPID\n{}END-OF-PATH\n", point(50), point(10), point(60))
    };
    let cl = |sense: &str| {
        let first = operation("", [10.0, 0.0], [0.5, 0.0]);
        let others = [operation(sense, [0.0, 10.0], [0.0, 0.5]), operation("", [-10.0, 0.0], [-0.5, 0.0])];
        format!("UNITS/MM\nLOADTL/1,LENGTH,80\nFEDRAT/MMPM,500\n{first}{}FINI\n", others.concat())
    };
    for (control, modes) in
        [("linuxcnc", &["axes"][..]), ("siemens", &["axes", "tcp"]), ("heidenhain", &["axes", "tcp"])]
    {
        for mode in modes {
            let keys = format!("mode = \"{mode}\"\ntcp_frame = \"table_at_zero\"\n[retract]\ndistance = 60.0\n");
            let angles = |sense: &str| -> Vec<f64> {
                let program = passes::<SpinnerU5620>(control, &keys, &cl(sense));
                let word = |line: &str| {
                    let words = line.split(' ').filter(|word| !line.contains(['(', ';']) && word.starts_with('C'));
                    words.filter_map(|word| word[1..].parse().ok()).next()
                };
                let mut angles: Vec<f64> = program.lines().filter_map(word).collect();
                angles.dedup();
                angles
            };
            assert_eq!(angles("ROTABL/NEXT,CLW\n"), [0.0, 90.0, 180.0], "{control} {mode}");
            assert_eq!(angles("ROTABL/NEXT,CCLW\n"), [0.0, -270.0, -180.0], "{control} {mode}");
            assert_eq!(angles("ROTABL/SHORT\n"), [0.0, 90.0, 180.0], "{control} {mode}");
        }
    }
}

#[test]
fn an_operation_may_begin_where_the_last_one_ended() {
    let own_safety = "[program]\nstart = ['G21']\n[control]\nsafety = ['G17 G40 G80 G90 G94 G54']\n".to_owned();
    let safety = [
        ("linuxcnc", own_safety),
        ("linuxcnc", String::new()),
        ("fanuc", String::new()),
        ("siemens", String::new()),
        ("heidenhain", String::new()),
        ("haas", String::new()),
    ];
    for (first, next) in [("", ""), ("", "GOTO/5,5,-2\n"), ("RAPID\n", "GOTO/5,5,-2\n"), ("FEDRAT/MMPM,100\n", "")] {
        let cl = format!(
            "UNITS/MM\nLOADTL/1\nRAPID\nGOTO/10,0,5,0,0,1\nFEDRAT/MMPM,250\nGOTO/10,0,0\nGOTO/0,10,-2\n\
             LOADTL/1\n{first}GOTO/0,10,-2\n{next}"
        );
        for (control, keys) in &safety {
            passes::<SpinnerU5620>(control, keys, &cl);
        }
    }
}
