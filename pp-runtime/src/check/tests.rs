//! Programs that are written right, each of a kind whose check has to look twice.

mod between;
mod clear;
mod edges;
mod edits;
mod order;
mod poles;
mod selected;
mod states;

use std::io::Cursor;

use super::*;
use crate::config::Config;
use crate::control::Control;
use crate::options::Mode;
use crate::{control, post};

crate::machine! {
    /// Both rotary axes in the table.
    struct Tables;
    chain: C B | X Y Z;
    d = (0, 0, 150);
    limits = { B: -5..110, C: free };
}

crate::machine! {
    /// B in the head, C in the table.
    struct HeadTable;
    chain: C | X Y Z B;
    d = { C: (0, 0, 0), B: (8, 0, 140) };
}

crate::machine! {
    /// Both in the head.
    struct TwoInHead;
    chain: X | Y Z B A;
    d = (0, 0, 0);
}

crate::machine! {
    /// Both in the table, the second about a line inclined by 45°.
    struct Nutating;
    chain: C B | X Y Z;
    axes = { B: Rx(-45 deg) * Y };
    d = (0, 0, 0);
}

crate::machine! {
    /// A in the table, over a moving Y.
    struct OneTable;
    chain: A Y | X Z;
    signs = { A: -, Y: - };
    d = (0, 0, 0);
}

crate::machine! {
    /// Three axes.
    struct Mill;
    chain: X Y | Z;
}

/// What the check says of a program that has just been posted, and the program.
fn posted<M: Machine>(
    control: &str,
    mode: Mode,
    set_up: &str,
    data: &str,
) -> Result<(Vec<String>, String), Vec<Diagnostic>> {
    let (control, config) = configured::<M>(control, mode, set_up);
    let mut program = Vec::new();
    let job = post::Job { cl_name: "part.cls", config: &config, control, units: None };
    let report = post::post::<M>(&job, &mut Cursor::new(data), &mut program).expect("memory takes it");
    if report.failed {
        return Err(report.diagnostics);
    }
    let found = findings::<M>(&config, control, data, &program);
    Ok((found, String::from_utf8(program).expect("ASCII")))
}

fn configured<M: Machine>(control: &str, mode: Mode, set_up: &str) -> (&'static dyn Control, Config) {
    let control = control::by_name(control).expect("a control");
    let set_up = format!("defaults = {{ speed = 2000, direction = \"CLW\" }}\n{set_up}");
    let mut config = crate::config::starting_point(control).read_over(&M::default(), &set_up).expect("a configuration");
    config.motion.mode = mode;
    // Its blocks are those of the control.
    config.motion.guards.offset_guard = false;
    config.given.insert("part_origin");
    (control, config)
}

/// A program that has just been posted, of which the check has nothing to say.
#[track_caller]
fn posted_right<M: Machine>(control: &str, mode: Mode, set_up: &str, data: &str) -> String {
    let (found, program) = posted::<M>(control, mode, set_up, data).expect("it can be posted");
    assert_eq!(found, [""; 0], "{program}");
    program
}

/// Of a program that somebody has changed the check has something to say.
#[track_caller]
fn assert_told<M: Machine>(control: &str, mode: Mode, set_up: &str, data: &str, changed: &str) {
    assert_ne!(again::<M>(control, mode, set_up, data, changed), [""; 0], "{changed}");
}

/// What the check says of a program that somebody has changed.
fn again<M: Machine>(control: &str, mode: Mode, set_up: &str, data: &str, program: &str) -> Vec<String> {
    let (control, config) = configured::<M>(control, mode, set_up);
    findings::<M>(&config, control, data, program.as_bytes())
}

fn findings<M: Machine>(config: &Config, control: &dyn Control, data: &str, program: &[u8]) -> Vec<String> {
    let policy = config.check_policy::<M>(control, None).expect("the configuration suits control and machine");
    let outcome = check::<M>(&policy, Cursor::new(data), program).expect("it can be read").outcome;
    outcome.findings.into_iter().map(|found| format!("{}: {}", found.location.line, found.text)).collect()
}

/// Behind arcs by their angle the tool is a few roundings off the words of their ends; a point that is there already
/// and whole turns from there are run from where it is.
#[test]
fn whole_turns_behind_a_helix_by_its_angle_begin_where_it_ended() {
    let data = "UNITS/MM
LOAD/TOOL,2
FEDRAT/MMPR,0.268
GOTO/76.426,-51.334,43.783,0.000000,0.032708,0.999465
GOTO/94.105,28.469,-8.345
CIRCLE/106.910,40.359,-12.472,0.000000,0.032708,0.999465,17.562,0.0600,0.5000,10.0000,0.0000,TIMES,2
GOTO/113.839,56.488,-13.000
GOTO/113.839,56.488,-13.000
CIRCLE/114.197,49.241,-12.763,0.000000,0.032708,0.999465,7.260,0.0600,0.5000,10.0000,0.0000,TIMES,4
GOTO/107.909,45.614,-12.644,0.000000,0.032708,0.999465
";
    let program = posted_right::<Tables>("heidenhain", Mode::Plane, "retract = { clearance = { plane = 200 } }", data);
    assert_eq!(program.matches("CP IPA").count(), 7, "{program}");
}

/// On a steep helix the point nearest to the end of a block lies between those of its angle and of its height.
#[test]
fn a_steep_helix_may_end_where_rounding_puts_it() {
    let data = "UNITS/MM
LOADTL/4,LENGTH,100
FEDRAT/MMPM,2482.974
GOTO/-17.177,-49.893,13.775
CIRCLE/-16.106,-52.112,16.654,0.0000000,0.0000000,-1.0000000,2.464
GOTO/-16.164,-49.649,16.654
";
    let program = posted_right::<OneTable>("haas", Mode::Axes, "retract = { distance = 95.0 }", data);
    assert_eq!(program.matches("Z15.215").count(), 1, "{program}");
    let higher = program.replace("Z15.215", "Z15.235");
    assert_told::<OneTable>("haas", Mode::Axes, "retract = { distance = 95.0 }", data, &higher);
}

/// A turn that ends a little behind its beginning is a whole turn and a step of one unit.
#[test]
fn the_rest_of_a_turn_belongs_to_it_although_a_wait_stands_behind() {
    let data = "UNITS/INCHES
LOAD/TOOL,4
FEDRAT/IPM,101.0432
GOTO/-3.1963,-1.0810,-0.1793,0.00000000,0.01587904,0.99987392
MOVARC/-4.2996,-1.0537,-0.1460,0.00000000,-0.01587904,-0.99987392,1.1036,ANGLE,360.000000
GOTO/-3.1963,-1.0805,-0.1455
DELAY/2,REV
";
    let program = posted_right::<OneTable>("haas", Mode::Axes, "", data);
    let lines: Vec<&str> = program.lines().collect();
    let rest = lines.iter().position(|line| line.starts_with("G04")).expect("the wait") - 1;
    assert!(lines[rest].contains('I'), "{program}");
    // Farther than its record says it is no rest.
    let farther = program.replace(lines[rest], &lines[rest].replace("Y1.0781", "Y1.0791"));
    assert_told::<OneTable>("haas", Mode::Axes, "", data, &farther);
}

#[test]
fn a_rapid_behind_arcs_by_their_angle_goes_round_its_corner_from_where_they_ended() {
    let set_up = "part_origin = [-33.0, -34.2842, -47.7332]
limits = { B = [0, 180] }
rapid = \"split\"
formats = { linear_mm = 5, rotary = 2 }
";
    let data = "UNITS/MM
LOADTL/4
FEDRAT/MMPM,1391.059
TRANS/-4.06486727,12.00000000,-0.37790603
GOTO/14.388,60.448,-47.823,-0.374541,0.881179,0.288520
MOVARC/-2.957,52.154,-45.009,0.374541,-0.881179,-0.288520,19.431,ANGLE,894.884821
GOTO/-19.799,43.541,-40.567
RAPID
GOTO/-43.188,98.569,-22.550
";
    posted_right::<Nutating>("heidenhain", Mode::Axes, set_up, data);
}

/// A point that repeats needs no block; the step behind it has a feed of its own.
#[test]
fn a_step_behind_a_point_that_repeats_has_its_own_feed() {
    let data = "UNITS/MM
LOADTL/1
FEDRAT/MMPM,617.810
GOTO/126.8258,-61.7572,14.8462,0,0,1
GOTO/126.8258,-61.7572,14.8462
FEDRAT/MMPM,2910.711
GOTO/126.8198,-61.7642,14.8462
";
    let set_up = "formats = { linear_mm = 2 }\nretract = { distance = 60 }\n";
    let program = posted_right::<Tables>("haas", Mode::Tcp, set_up, data);
    let wrong = program.replace("F2910.71", "F1910.71");
    assert_ne!(wrong, program);
    assert_told::<Tables>("haas", Mode::Tcp, set_up, data, &wrong);
}

/// Angles of a plane are as coarse as rotary words.
#[test]
fn rotary_axes_stand_in_a_plane_to_the_digits_of_both() {
    let data = "UNITS/MM\nLOADTL/1\nRAPID\nGOTO/-1.0524,24.774747,15.66743,-0.016843,0.016843,0.999716\n";
    let set_up = "formats = { rotary = 2 }\nretract = { distance = 55.697 }\n";
    posted_right::<TwoInHead>("fanuc", Mode::Plane, set_up, data);
}

/// The way out before the rotary axes turn leads along the very line that the rapid of the CL data takes.
#[test]
fn a_way_out_along_a_rapid_that_is_run_at_feed_is_no_share_of_it() {
    let set_up = "rapid = \"feed\"
rapid_feed = 8000.0
course = { start_branch = \"second\" }
retract = { distance = 49.7634 }
";
    let data = "UNITS/MM
LOAD/TOOL,2,ADJUST,2
COOLNT/ON
FEDRAT/MMPM,655.27178
GOTO/102.24687,25.91054,-31.17297,-0.15802802,-0.24200521,0.95731950
GOTO/103.30457,18.02925,-33.17161,0.01045449,0.02399867,0.99965732
RAPID
GOTO/103.88313,19.35737,22.15070
";
    let program = posted_right::<Tables>("haas", Mode::Tcp, set_up, data);
    assert!(program.contains("M09\nG00 X103.825 Y19.224 Z16.575\nG49 G53"), "{program}");
    // Alone, G49 may move the tool by its length.
    let alone = program.replace("Z16.575\nG49 G53", "Z16.575\nG49\nG53");
    assert_told::<Tables>("haas", Mode::Tcp, set_up, data, &alone);
}

/// At the pole the tool axis is at its end to the digits of the CL data while the table has some of its turn left.
#[test]
fn the_rest_of_a_turn_at_the_pole_belongs_to_the_cut_that_it_ends() {
    let set_up = "part_origin = [28.0, 8.0, 9.0]
course = { prefer = \"C+\" }
retract = { distance = 64.2854 }
tools = { 2 = { length = 98.0 } }
";
    let data = "UNITS/MM
LOADTL/2
FEDRAT/MMPM,1956.54971
GOTO/96.05179,26.39804,55.30254,0.00489612,-0.00468027,0.99997706
GOTO/95.34271,33.39804,56.69310,-0.00108154,0.00098819,0.99999893
GOTO/98.05225,27.16281,54.78549,0.00510202,-0.00445492,0.99997706
GOTO/98.05225,27.16281,54.78549,-0.00112496,0.00093846,0.99999893
GOTO/91.47771,38.20112,52.70413,0.00548234,-0.00397755,0.99997706
GOTO/75.36590,-15.06366,31.66462,0.00007868,-0.00008427,0.99999999
GOTO/80.08815,-15.06366,32.33409,-0.00686730,0.00513161,0.99996325
GOTO/77.08815,-14.78550,32.90465,0.00010311,-0.00005157,0.99999999
GOTO/79.97308,-18.87726,32.14992,-0.00822510,0.00241681,0.99996325
GOTO/79.20920,-11.04755,30.60343,0.00011462,-0.00001241,0.99999999
GOTO/75.20920,-13.12958,30.67634,-0.00855173,-0.00060099,0.99996325
GOTO/75.20920,-13.12958,30.67634,0.00011176,0.00002832,0.99999999
RAPID
GOTO/75.21182,-13.12891,54.11004
";
    let (found, program) = posted::<HeadTable>("linuxcnc", Mode::Axes, set_up, data).expect("it can be posted");
    assert_eq!(found, [""; 0]);
    assert!(program.contains("\nX-126.814 Y22.324 B-0.0066 C-1605.7805 F2266.43\nG94\n"), "{program}");
}

/// The points of two holes put their levels a fraction of a unit apart: the tool is lifted by the last digit of a word.
#[test]
fn a_lift_of_less_than_a_unit_between_two_holes_is_that_lift() {
    let data = "UNITS/MM
TOOL PATH/OP_53,TOOL,T1
LOADTL/1
RAPID
GOTO/-55.998,55.486,50.327,-0.96050546,0.10218595,0.25881905
CYCLE/REAM,RAPTO,8.548,FEDTO,-5.269,MMPM,387.055
GOTO/-20.726,47.908,-27.552
GOTO/-10.032,64.619,5.538
";
    let program = posted_right::<HeadTable>("heidenhain", Mode::Tcp, "", data);
    let blocks: Vec<&str> = program.lines().filter_map(|line| line.split_once(' ').map(|(_, block)| block)).collect();
    let lift =
        blocks.iter().position(|block| *block == "L X-28.937 Y+48.782 R0 FMAX").expect("the point of the second hole");
    assert!(blocks[lift - 1].ends_with("Z-25.34"), "{program}");
}

/// RETRCT ends in the clearance plane; seen from the rounded place 0.4 µm below it that plane is 2.9 µm away along the
/// tool.
#[test]
fn a_retract_to_a_plane_along_a_grazing_axis_has_led_out() {
    let data = |z: f64| {
        format!(
            "UNITS/MM
LOADTL/1
FEDRAT/MMPM,900
CLEARP/XYPLAN,{z}
GOTO/-50.2403,17.9907,45.0580,-0.487056,0.861664,0.142517
RETRCT
"
        )
    };
    for tenth in 0..10 {
        posted_right::<Tables>("haas", Mode::Axes, "", &data(150.0 + 1e-4 * f64::from(tenth)));
    }
}

/// Points that repeat stand before a step of a little more than half a unit: its block belongs to none of them.
#[test]
fn points_that_repeat_leave_a_small_step_to_its_own_record() {
    let data = "UNITS/INCHES
LOADTL/1
FEDRAT/IPM,29.0
GOTO/1.0,1.0,0.0
GOTO/1.1003,1.1003,0.0
GOTO/1.1003,1.1003,0.0
GOTO/1.1003,1.1003,0.0
GOTO/1.1007,1.1007,0.0
GOTO/1.2,1.3,0.3
";
    let program = posted_right::<Mill>("heidenhain", Mode::Axes, "formats = { linear_inch = 3 }", data);
    assert!(program.contains(" L X+1.101 Y+1.101\n"), "{program}");
}

/// RETRCT leads to the clearance plane, and so does the way out before the rotary axes turn for it.
#[test]
fn a_way_out_that_ends_where_a_rapid_does_is_told_from_it_by_what_follows() {
    let data = |coolant: &str, more: &str| {
        format!(
            "UNITS/MM
LOADTL/1
COOLNT/{coolant}
CLEARP/XYPLAN,150
FEDRAT/MMPM,1615
GOTO/60.795,-81.941,0.754,-0.00737508,0.03053267,0.99950656
GOTO/58.795,-78.030,0.581,0.00256954,-0.02605053,0.99965732
RETRCT
{more}"
        )
    };
    let set_up = "limits = { C = [-190, 270], B = [-180, 180] }\ncourse = { start_branch = \"first\" }";
    for coolant in ["ON", "OFF"] {
        let tool = "LOADTL/2\nGOTO/-34,34,34,0,0,1\n";
        for more in
            ["", "STOP\n", tool, "GOTO/50,-78,160\n", "RAPID\nGOTO/50,-78,160\nGOTO/50,-78,100\n", "GOHOME/0,0,180\n"]
        {
            let (found, program) =
                posted::<Nutating>("siemens", Mode::Axes, set_up, &data(coolant, more)).expect("it can be posted");
            assert_eq!(found, [""; 0], "{coolant} {more}{program}");
            assert!(program.matches("SUPA G0 Z0 D0").count() > 3, "{program}");
        }
    }
}

/// A rapid of the CL data leads up the tool axis and a cut down again, and the table is rewound: the tool comes back
/// over the cut before the rapid as well as over the one after it. What follows tells them apart.
#[test]
fn a_rewind_beside_a_rapid_out_and_a_cut_back_is_read_by_what_follows() {
    let data = "UNITS/MM
LOADTL/1
SPINDL/RPM,1000,CLW
FEDRAT/500
RAPID
GOTO/10,0,50,-0.492403877,0.086824089,0.866025404
GOTO/10,0,0
GOTO/10,0,0,-0.499314767,-0.026167978,0.866025404
RAPID
GOTO/-14.96573835,-1.3083989,43.3012702
GOTO/10,0,0
GOTO/10,0,0,-0.497260948,-0.052264232,0.866025404
";
    for distance in [40, 50, 60] {
        let set_up = format!("limits = {{ C = [-183.3, 183.3] }}\nretract = {{ distance = {distance} }}\n");
        let program = posted_right::<Tables>("fanuc", Mode::Axes, &set_up, data);
        assert!(program.contains("\nG0 C-"), "{program}");
    }
}

/// Down along the tool to a hole lies one more unit across: a rapid in two blocks ends in both of them.
#[test]
fn the_last_unit_of_a_split_rapid_belongs_to_it() {
    let data = "UNITS/MM
LOADTL/3
FEDRAT/MMPM,76
GOTO/-68.472,67.416,-80.310,0.95142594,0.00000000,0.30787771
RAPID
GOTO/-14.973,67.416,-62.999
GOHOME/-29.247,3.710,139.000,0.00000000,0.00000000,1.00000000
";
    let set_up = "rapid = \"split\"\nretract = { distance = 105.0 }\ntools = { 3 = { length = 116.4222 } }\n";
    let program = posted_right::<HeadTable>("haas", Mode::Axes, set_up, data);
    assert!(program.contains("G00 X223.457 Z-248.087\nZ-248.088\n"), "{program}");
}

/// The words of a cycle say its place at the clearance level; 18 mm above it the rounded plane leads 0.1 µm elsewhere.
#[test]
fn a_cycle_goes_back_along_the_tool_axis_of_its_plane() {
    let data = "UNITS/MM
TOOL PATH/OP_22,TOOL,T1
LOAD/TOOL,1
RAPID
GOTO/34.817064,28.465358,-6.227757,0.0000000,0.9117994,0.4106359
CYCLE/DRILL,RAPTO,9.956617,FEDTO,-4.576551,RTRCTO,AUTO,MMPM,50.365638
GOTO/-19.250494,-27.870271,37.489579
";
    let program = posted_right::<OneTable>("haas", Mode::Plane, "", data);
    assert!(program.contains("G98 G81 X-19.25 Y45.628 Z-14.594 R-0.061"), "{program}");
}

/// Where the rotary axes turn on the way to a hole, the tool is neither lifted first nor led over it.
#[test]
fn an_approach_leads_straight_over_a_hole() {
    let data = "UNITS/MM
TOOL PATH/OP_65,TOOL,T4
LOADTL/4
ROTABL/NEXT,CCLW
TLAXIS/0.0214170,0.0214170,0.9995412
RAPID
GOTO/44.6709,39.8953,13.9747
CYCLE/DEEP,STEP,3.1775,RAPTO,11.9233,FEDTO,-8.3729,DWELL,0.5,MMPM,265.6276
GOTO/39.2282,4.3779,28.3778
";
    let set_up = "course = { prefer = \"C+\" }\nlimits = { C = [-200, 200] }\nretract = { distance = 76 }\n";
    let program = posted_right::<Tables>("siemens", Mode::Tcp, set_up, data);
    assert_eq!(program.matches("\nTRAORI").count(), 2, "{program}");
}

/// ROTABL/NEXT turns the table for a point that repeats, and the tool comes back to it.
#[test]
fn a_point_that_repeats_is_come_back_to_where_the_table_turns_for_it() {
    let data = |more: &str| {
        format!(
            "UNITS/MM
LOADTL/3
FEDRAT/MMPM,300
ROTABL/NEXT,CCLW
RAPID
GOTO/-0.810,-17.985,39.439,-0.4155124,-0.2781177,0.8660254
RAPID
GOTO/-0.810,-17.985,39.439
{more}"
        )
    };
    let set_up = "course = { prefer = \"C+\" }\nlimits = { C = [-200, 200] }\nretract = { distance = 86 }
tools = { 3 = { length = 156.9346 } }\n";
    for more in ["", "GOTO/5,-18,39\n", "RAPID\nGOTO/5,-18,39\n", "STOP\n"] {
        let (found, program) = posted::<HeadTable>("fanuc", Mode::Axes, set_up, &data(more)).expect("it can be posted");
        assert_eq!(found, [""; 0], "{more}{program}");
        assert!(program.matches("G53 G0 Z0.").count() > 3, "{program}");
    }
}

/// ROTABL/NEXT turns the table between two holes of one tool axis, and the tool is led to the second one as to the
/// first.
#[test]
fn a_hole_is_approached_again_where_the_table_turns_for_it() {
    let data = "UNITS/MM
TOOL PATH/HOLES,TOOL,T1
LOADTL/1
CYCLE/DRILL,RAPTO,11,FEDTO,-20,RTRCTO,14,DWELL,REV,3,MMPM,387
ROTABL/NEXT,CCLW
GOTO/25.923754,12.183644,-43.619778,0.2588190,0.9659258,0
GOTO/37.061096,-2.247340,-26.058269
";
    let set_up = "course = { start_branch = \"first\" }\ncycles = { output = \"expanded\" }
limits = { C = [-200, 200] }\n";
    for control in ["heidenhain", "fanuc", "siemens"] {
        posted_right::<HeadTable>(control, Mode::Plane, set_up, data);
    }
}

/// An axis that takes the short way makes half a turn in two blocks, and everything else goes half its way with it.
#[test]
fn a_rapid_of_half_a_turn_goes_in_steps_where_axes_take_the_short_way() {
    let data = "UNITS/MM
LOADTL/1
FEDRAT/MMPM,300
GOTO/10,20,5,0.6,0,0.8
GOTO/10,20,50
RAPID
GOTO/-10,20,50,-0.6,0,0.8
GOTO/-10,20,5
";
    let set_up = "transition = \"direct\"\nwrap = { C = \"0..360\" }\nlimits = { B = [0, 110] }\n";
    for control in ["linuxcnc", "heidenhain"] {
        let program = posted_right::<Tables>(control, Mode::Axes, set_up, data);
        let half = if control == "heidenhain" { "Y+0 C+90" } else { "Y0 C90" };
        assert!(program.contains(half), "{program}");
        let aside = program.replace(half, &half.replace("90", "91"));
        let found = again::<Tables>(control, Mode::Axes, set_up, data, &aside);
        assert!(found.len() == 1 && found[0].starts_with("7: the intermediate points of this rapid"), "{found:?}");
    }
    // A step farther than the end, one backwards, one in another state.
    let program = posted_right::<Tables>("linuxcnc", Mode::Axes, set_up, data);
    let step = program.lines().find(|line| line.ends_with("Y0 C90")).expect("the step");
    let wrong = [format!("{step}\nY-40 C270"), step.replace("Y0 C90", "Y30 C315"), format!("M5\n{step}\nM3")];
    for wrong in wrong {
        assert_told::<Tables>("linuxcnc", Mode::Axes, set_up, data, &program.replace(step, &wrong));
    }
}

/// A rapid that has less than half a turn to go is one block.
#[test]
fn a_short_rapid_has_no_steps() {
    let data = "UNITS/MM
LOADTL/1
FEDRAT/MMPM,300
GOTO/10,20,5,0.6,0,0.8
GOTO/10,20,50
RAPID
GOTO/-30,40,50,0.59088465,0.10418891,0.8
";
    let set_up = "transition = \"direct\"\nwrap = { C = \"0..360\" }\nlimits = { B = [0, 110] }\n";
    let program = posted_right::<Tables>("linuxcnc", Mode::Axes, set_up, data);
    let rapid = program.lines().find(|line| line.ends_with("C10")).expect("the rapid");
    // Half of its way, and twelve times its way.
    for step in ["G0 X25.961 Y22.301 Z58.72 C5", "G0 X-244.948 Y315.224 Z-158.708 C120"] {
        assert_told::<Tables>(
            "linuxcnc",
            Mode::Axes,
            set_up,
            data,
            &program.replace(rapid, &format!("{step}\n{rapid}")),
        );
    }
}

/// Whole turns by their angle end where they began, however many they are.
#[test]
fn many_turns_by_their_angle_allow_no_more_than_one() {
    let data = "UNITS/MM
LOADTL/1
FEDRAT/MMPM,300
GOTO/5,0,5,0,0,1
GOTO/5,0,0
CIRCLE/0,0,-30,0,0,-1,5,0.06,0.5,10,1,TIMES,60
GOTO/5,0,-30
GOTO/4.92,0,-30
RAPID
GOTO/4.92,0,5
";
    let program = posted_right::<Mill>("heidenhain", Mode::Axes, "", data);
    let last = program.rfind("IPA").expect("a turn");
    let (before, behind) = program.split_at(last);
    let short = format!("{before}{}", behind.replacen("360", "359.2", 1));
    let lost = program.lines().find(|line| line.contains("X+4.92")).expect("the last cut");
    for wrong in [short, program.replace(lost, &lost[..lost.find(' ').expect("its number")])] {
        assert_told::<Mill>("heidenhain", Mode::Axes, "", data, &wrong);
    }
}

/// Over the pole the table may turn and the tool stays: not at rapid with the tool at the part, and not by turns.
#[test]
fn a_table_that_turns_under_a_tool_at_the_part_is_told() {
    let data = "UNITS/MM
LOADTL/1
FEDRAT/MMPM,300
GOTO/10,20,5,0,0,1
GOTO/10,30,5
RAPID
GOTO/10,30,50
GOTO/40,30,50
GOTO/40,30,5
GOTO/60,30,5
";
    let set_up = "retract = { distance = 20 }\n";
    let program = posted_right::<Tables>("siemens", Mode::Tcp, set_up, data);
    let behind = |line: &str, more: &str| program.replace(&format!("\n{line}\n"), &format!("\n{line}\n{more}\n"));
    for (line, more) in [("G0 Z50", "G0 C180"), ("Y30", "C7200"), ("X60", "C-360")] {
        let wrong = behind(line, more);
        assert_ne!(wrong, program, "{line} is not in {program}");
        assert_told::<Tables>("siemens", Mode::Tcp, set_up, data, &wrong);
    }
    // D0 takes the tool offset away, and not the transformation.
    let (before, behind) = program.rsplit_once("TRAFOOF\n").expect("the end of tip control");
    let lost = format!("{before}{behind}");
    assert_told::<Tables>("siemens", Mode::Tcp, set_up, data, &lost);
}

/// How tip control turns the tool is said when it is switched on, and holds for all that follows.
#[test]
fn tip_control_that_turns_the_tool_in_another_way_is_told() {
    let data = "UNITS/MM
LOADTL/1
FEDRAT/MMPM,300
GOTO/10,20,5,0,0,1
GOTO/10,30,5,0.6,0,0.8
GOTO/10,40,5,0.48,0.36,0.8
";
    let edits = [
        ("siemens", "ORIAXES", "ORIVECT"),
        ("siemens", "ORIMKS", "ORIWKS"),
        ("siemens", "ORIMKS ORIAXES\n", ""),
        ("heidenhain", "AXIS POS", "AXIS SPAT"),
        ("heidenhain", "PATHCTRL AXIS", "PATHCTRL VECTOR"),
        ("fanuc", "P0", "P1"),
    ];
    for (control, right, wrong) in edits {
        let frame = if control == "fanuc" { "tcp_frame = \"table_at_zero\"\n" } else { "" };
        let set_up = format!("{frame}retract = {{ distance = 20 }}\n");
        let program = posted_right::<Tables>(control, Mode::Tcp, &set_up, data);
        let edited = program.replace(right, wrong);
        assert_ne!(edited, program, "{right}");
        assert_told::<Tables>(control, Mode::Tcp, &set_up, data, &edited);
    }
}

/// Over a hole the table must not turn at rapid, whoever thinks of a cycle that goes back to its level.
#[test]
fn a_table_that_turns_over_a_hole_is_told() {
    let data = "UNITS/MM
TOOL PATH/HOLES,TOOL,T1
LOADTL/1
RAPID
GOTO/10,20,50,0,0,1
CYCLE/DRILL,RAPTO,3.0000,FEDTO,-10.0000,RTRCTO,10.0000,MMPM,100.0000
GOTO/10,20,0
CYCLE/OFF
RAPID
GOTO/10,20,50
";
    let set_up = "retract = { distance = 20 }\n";
    let program = posted_right::<Tables>("siemens", Mode::Tcp, set_up, data);
    let down = program.lines().find(|line| line.ends_with("Z3")).expect("the clearance level");
    let wrong = program.replacen(&format!("{down}\n"), &format!("{down}\nG0 C180\n"), 1);
    assert_told::<Tables>("siemens", Mode::Tcp, set_up, data, &wrong);
}

/// Near the pole the rotary axes rotate far while the tip hardly moves: rounded words reach the end of a motion before
/// its last blocks, and the cut may be interrupted there for a rewind.
#[test]
fn a_cut_at_the_pole_goes_on_after_a_rewind_although_its_end_is_reached_but_for_rounding() {
    let set_up = "tolerance = 0.002
axis_tolerance_path = 1
part_origin = [60.0, -70.0, 55.0]
table_check = false
limits = { C = [-90.0, 90.0] }
retract = { distance = 400.0 }
";
    let mut random = 12_345_u64;
    let mut next = move || {
        random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (random >> 33) as f64 / (1_u64 << 31) as f64 - 0.5
    };
    let mut rewinds = 0;
    for _ in 0..60 {
        let mut data = "UNITS/MM\nLOADTL/1,LENGTH,80.0\nSPINDL/RPM,3000,CLW\nCOOLNT/ON\nFEDRAT/721.3,MMPM\n".to_owned();
        for point in 0..6 {
            let [x, y, z] = [next(), next(), next()].map(|value| value * 30.0);
            let size = if point % 2 == 0 { 0.05 } else { 3e-5 };
            let (i, j) = (next() * size, next() * size);
            let k = (1.0 - i * i - j * j).sqrt();
            data += &format!("GOTO/{x:.3},{y:.3},{z:.3},{i:.7},{j:.7},{k:.7}\n");
        }
        for control in ["linuxcnc", "siemens"] {
            // An F may have more digits than the control allows.
            let Ok((found, program)) = posted::<Tables>(control, Mode::Axes, set_up, &data) else { continue };
            assert_eq!(found, [""; 0], "{data}\n{program}");
            rewinds += program.matches("Z0").count();
        }
    }
    assert!(rewinds > 400, "{rewinds} machine retracts");
}
