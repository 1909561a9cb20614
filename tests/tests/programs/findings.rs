//! Texts and lines of the findings of the check: programs are posted and then edited as a user might.

use std::f64::consts::PI;
use std::io::Cursor;

use machines::SpinnerU5620;
use nalgebra::{Point3, UnitVector3, Vector3};
use pp_runtime::check::{Finding, check};
use pp_runtime::config::{Config, Units, starting_point};
use pp_runtime::control::{self, Control};
use pp_runtime::kinematics::{Machine, Pose};
use pp_runtime::post::{self, post};

/// A program with its CL data.
struct Posted {
    config: Config,
    control: &'static dyn Control,
    data: String,
    program: String,
}

impl Posted {
    fn new(control: &str, config: &str, data: &str) -> Self {
        let control = control::by_name(control).expect("a control");
        let config = starting_point(control).read_over(&SpinnerU5620::default(), config).expect("a configuration");
        let mut config = Config { output_units: Some(Units::Millimetres), ..config };
        config.given.insert("part_origin");
        let mut program = Vec::new();
        let job = post::Job { cl_name: "part.cls", config: &config, control, units: None };
        let report = post::<SpinnerU5620>(&job, &mut Cursor::new(data), &mut program).expect("it can be written");
        assert!(!report.failed, "{:?}", report.diagnostics);
        Self { config, control, data: data.to_owned(), program: String::from_utf8(program).expect("ASCII") }
    }

    /// Findings in a program.
    fn findings(&self, program: &str) -> Vec<Finding> {
        let policy = self
            .config
            .check_policy::<SpinnerU5620>(self.control, None)
            .expect("the configuration suits control and machine");
        let checked =
            check::<SpinnerU5620>(&policy, Cursor::new(&self.data), program.as_bytes()).expect("it can be read");
        checked.outcome.findings
    }
}

const HEAD: &str = "UNITS/MM\nLOADTL/1,LENGTH,100.0\nSPINDL/RPM,1000,CLW\nFEDRAT/MMPM,500.0\nRAPID\n";

/// The table rotates by half a revolution while the tip moves from a radius of 40 mm to the centre of the table.
const INWARDS: &str = "GOTO/40.0,0.0,0.0,0.5,0.0,0.8660254\nRAPID\nGOTO/0.0,0.0,0.0,-0.5,0.0,0.8660254\n";

#[test]
fn under_tip_control_the_path_of_a_rapid_is_checked_against_the_limits() {
    let found = |control: &str, linear: &str, limit: f64| {
        let config = format!(
            "mode = 'tcp'\ntcp_frame = 'table_at_zero'\ntransition = 'direct'\nindex_angle = 360\n\
             machine_zero = {{ X = 0, Y = 0, Z = -600 }}\n[retract]\ndistance = 20\n[limits]\nY = [-{limit}, {limit}]\n\
             [control]\n{linear}\n"
        );
        let posted = Posted::new(control, &config, &format!("{HEAD}{INWARDS}"));
        let found = posted.findings(&posted.program);
        assert!(found.iter().all(|found| found.location.line == 8), "{control}: {found:?}");
        found.into_iter().map(|found| found.text).collect::<Vec<String>>().join("; ")
    };
    let (linear, apart) = ("linear_rapids = true", "linear_rapids = false");
    for (control, usual) in [("fanuc", apart), ("siemens", linear), ("heidenhain", linear), ("haas", apart)] {
        // Interpolated together Y reaches 23 mm on the path; with each axis on its own it reaches 40 mm.
        let steps = (0..=10_000).map(|step| 1e-4 * f64::from(step));
        let farthest = steps.map(|share| 40.0 * (1.0 - share) * (PI * share).sin()).fold(0.0, f64::max);
        assert_eq!(found(control, linear, 30.0), "", "{control}");
        let text = found(control, linear, 15.0);
        assert!(text.starts_with(&format!("within this block Y moves to -{farthest:.4},")), "{control}: {text}");
        let text = found(control, apart, 30.0);
        let wanted = "if each axis of this rapid moves on its own, Y moves to -40.0000,";
        assert!(text.starts_with(wanted), "{control}: {text}");
        assert_eq!(found(control, apart, 41.0), "", "{control}");
        assert_eq!(found(control, "", 30.0), found(control, usual, 30.0), "{control}");
    }
}

#[test]
fn an_arc_over_a_limit_is_found_although_its_ends_are_inside() {
    let arc = "GOTO/20.0,0.0,0.0,0.0,0.0,1.0\nFEDRAT/MMPM,500.0\nGOTO/20.0,0.0,-1.0\n\
        CIRCLE/0.0,0.0,-1.0,0.0,0.0,1.0,20.0\nGOTO/-20.0,0.0,-1.0\nGOTO/-20.0,-1.0,-1.0\n";
    let within = |limit: f64| {
        format!(
            "machine_zero = {{ X = 0, Y = 0, Z = -600 }}\n[retract]\ndistance = 20\n[limits]\nY = [-{limit}, {limit}]\n"
        )
    };
    for control in ["linuxcnc", "siemens", "heidenhain"] {
        let wide = Posted::new(control, &within(20.0), &format!("{HEAD}{arc}"));
        assert!(wide.findings(&wide.program).is_empty(), "{control}: {}", wide.program);
        let control = wide.control;
        let narrow =
            starting_point(control).read_over(&SpinnerU5620::default(), &within(19.0)).expect("a configuration");
        let narrow = Posted { config: Config { output_units: Some(Units::Millimetres), ..narrow }, ..wide };
        let found = narrow.findings(&narrow.program);
        assert!(found.len() == 1 && found[0].text.contains("within this block Y moves to"), "{found:?}");
        assert_eq!(found[0].location.line, 10, "the CL line of the arc: {found:?}");
    }
}

/// Coordinate that a finding reports, mm.
fn reported_mm(found: &Finding) -> f64 {
    let after = found.text.split(" moves to ").nth(1).expect("a coordinate");
    after.split(',').next().and_then(|number| number.parse().ok()).expect("a number")
}

/// Arcs over the top of a circle, with the start at growing distances, so that the top is anywhere between two samples.
#[test]
fn the_furthest_point_of_an_arc_is_reported_and_none_is_missed() {
    let within = |limit: f64| {
        format!(
            "machine_zero = {{ X = 0, Y = 0, Z = -600 }}\n[retract]\ndistance = 20\n[limits]\nY = [-{limit}, {limit}]\n"
        )
    };
    for step in 1..40 {
        let angle = 0.07 * f64::from(step);
        let (sine, cosine) = angle.sin_cos();
        // From `angle` before the top to half of it after the top.
        let radius = 60.0;
        let (x, y) = (radius * sine, radius * cosine);
        let data = format!(
            "{HEAD}GOTO/{x:.4},{y:.4},20.0,0.0,0.0,1.0\nFEDRAT/MMPM,500.0\nGOTO/{x:.4},{y:.4},-1.0\n\
             CIRCLE/0.0,0.0,-1.0,0.0,0.0,1.0,{radius}\nGOTO/{:.4},{:.4},-1.0\n",
            -radius * (0.5 * angle).sin(),
            radius * (0.5 * angle).cos(),
        );
        let posted = Posted::new("linuxcnc", &within(61.0), &data);
        let limit = y.max(radius * (0.5 * angle).cos()).max(59.9);
        let narrow =
            starting_point(posted.control).read_over(&SpinnerU5620::default(), &within(limit)).expect("it reads");
        let narrow = Posted { config: Config { output_units: Some(Units::Millimetres), ..narrow }, ..posted };
        let found = narrow.findings(&narrow.program);
        let over = radius > limit + narrow.config.motion.tolerance_mm + 0.002;
        let within_block: Vec<_> = found.iter().filter(|found| found.text.starts_with("within this block Y")).collect();
        assert_eq!(within_block.len(), usize::from(over), "{step}: {found:?}");
        // The words of the ends and of the centre are rounded to a thousandth.
        assert!(within_block.iter().all(|found| (reported_mm(found) - radius).abs() < 2.5e-3), "{step}: {found:?}");
    }
}

/// A cut in which the tool axis rotates by 58 degrees and passes the pole at 9 degrees, where C rotates fast.
const PAST_THE_POLE: &str = "GOTO/60.0,0.0,0.0,0.5,0.0,0.8660254\nFEDRAT/MMPM,500.0\n\
    GOTO/10.0,30.0,0.0,-0.4330127,0.25,0.8660254\nGOTO/10.0,30.0,1.0,-0.4330127,0.25,0.8660254\n";

/// Lowest and highest Y of that cut, mm, if the tool axis rotates in the plane of its ends: the generated inverse at a
/// hundred thousand points.
fn y_range_past_the_pole() -> (f64, f64) {
    let machine = SpinnerU5620::default();
    let (from, to) = (Vector3::new(0.5, 0.0, 0.75_f64.sqrt()), Vector3::new(-0.433_012_7, 0.25, 0.75_f64.sqrt()));
    let (tips, angle) = ([Vector3::new(60.0, 0.0, 0.0), Vector3::new(10.0, 30.0, 0.0)], from.angle(&to));
    let values = (0..=100_000).map(|step| {
        let share = 1e-5 * f64::from(step);
        let axis = (from * (angle * (1.0 - share)).sin() + to * (angle * share).sin()) / angle.sin();
        let tip = Point3::from(tips[0].lerp(&tips[1], share));
        let pose = Pose { tip, axis: UnitVector3::new_normalize(axis) };
        let solutions = machine.inverse_kinematics(&pose, &SpinnerU5620::HELD);
        let positive_tilt = solutions.iter().find(|solution| solution.axes[1] >= 0.0).expect("a solution");
        positive_tilt.axes[3]
    });
    values.fold((f64::MAX, f64::MIN), |(low, high), y| (low.min(y), high.max(y)))
}

#[test]
fn axes_are_checked_where_the_control_rotates_the_tool_axis_in_a_plane() {
    let (low, high) = y_range_past_the_pole();
    assert!(low < -20.0, "{low} {high}");
    for (control, words) in [
        ("siemens", "angles"),
        ("siemens", "vectors"),
        ("fanuc", "angles"),
        ("fanuc", "vectors"),
        ("heidenhain", "angles"),
        ("heidenhain", "vectors"),
    ] {
        let config = |least: f64| {
            format!(
                "mode = 'tcp'\ntcp_frame = 'table_at_zero'\ntcp_words = '{words}'\ntool_posture = 'plane'\n\
                 machine_zero = {{ X = 0, Y = 0, Z = -600 }}\n[retract]\ndistance = 20\n[limits]\n\
                 Y = [{least:.3}, {:.3}]\n",
                high + 20.0
            )
        };
        let posted = Posted::new(control, &config(-200.0), &format!("{HEAD}{PAST_THE_POLE}"));
        assert!(posted.findings(&posted.program).is_empty(), "{}", posted.program);
        let narrowed = |least: f64| {
            let narrow = starting_point(posted.control).read_over(&SpinnerU5620::default(), &config(least));
            let config = Config { output_units: Some(Units::Millimetres), ..narrow.expect("a configuration") };
            let (data, program) = (posted.data.clone(), posted.program.clone());
            let narrow = Posted { config, control: posted.control, data, program };
            narrow.findings(&narrow.program)
        };
        assert_eq!(narrowed(low - 0.001), [], "{control} {words}");
        let found = narrowed(low + 0.1);
        assert!(
            found.len() == 1 && found[0].text.starts_with("within this block Y moves to"),
            "{control} {words}: {found:?}"
        );
        assert!((reported_mm(&found[0]) - low).abs() < 2e-3, "{control} {words}: {low} {found:?}");
    }
}

/// Through the pole the axes would continue to B -17.5, below the limit of -5: the control selects the solution with C
/// rotated by half a revolution.
#[test]
fn at_a_travel_limit_the_control_takes_the_other_solution() {
    let through = "GOTO/30.0,5.0,0.0,0.2,0.0,0.9797959\nFEDRAT/MMPM,500.0\n\
        GOTO/30.0,5.0,0.0,-0.3,0.0,0.9539392\nGOTO/30.0,5.0,1.0,-0.3,0.0,0.9539392\n";
    let config = |most: f64| {
        format!(
            "mode = 'tcp'\ntcp_frame = 'table_at_zero'\ntcp_words = 'vectors'\ntool_posture = 'plane'\n\
             machine_zero = {{ X = 0, Y = 0, Z = -600 }}\n[retract]\ndistance = 20\n[limits]\nB = [-5, {most}]\n"
        )
    };
    for control in ["siemens", "heidenhain"] {
        let posted = Posted::new(control, &config(110.0), &format!("{HEAD}{through}"));
        assert_eq!(posted.findings(&posted.program), [], "{}", posted.program);
        let narrow = starting_point(posted.control).read_over(&SpinnerU5620::default(), &config(17.0));
        let config = Config { output_units: Some(Units::Millimetres), ..narrow.expect("a configuration") };
        let narrow = Posted { config, ..posted };
        let found = narrow.findings(&narrow.program);
        // Now neither solution is inside the limits.
        let outside = |found: &Finding| found.text.starts_with("B moves to -17.45");
        assert!(!found.is_empty() && found.iter().all(outside), "{control}: {found:?}");
    }
}

/// A part with a milling and a drilling tool; each line has one effect.
const TWO_TOOLS: &str = "UNITS/MM
LOADTL/1,LENGTH,100.0
SPINDL/RPM,1000,CLW
FEDRAT/MMPM,500.0
RAPID
GOTO/0.0,0.0,20.0,0.0,0.0,1.0
GOTO/1.0,2.0,-1.0
GOTO/11.0,4.0,-1.0
GOTO/17.0,9.0,-2.0
GOTO/19.0,13.0,-3.0
RAPID
GOTO/19.0,13.0,20.0
RAPID
GOTO/41.0,31.0,22.0
GOTO/43.0,37.0,-1.0
RAPID
GOTO/43.0,37.0,20.0
OPSTOP
LOADTL/2,LENGTH,80.0
SPINDL/RPM,2000,CLW
RAPID
GOTO/0.0,0.0,20.0
CYCLE/DRILL,RAPTO,2.0,FEDTO,-6.0,RTRCTO,AUTO,MMPM,150.0
GOTO/10.0,10.0,0.0
GOTO/21.0,15.0,0.0
GOTO/32.0,25.0,0.0
GOTO/44.0,35.0,0.0
CYCLE/OFF
RAPID
GOTO/44.0,35.0,20.0
";

/// A program without one of its lines; line numbers are renumbered, as an editor does.
fn without(program: &str, lost: usize) -> String {
    let lines = program.lines().enumerate().filter(|(index, _)| *index != lost).map(|(_, line)| line);
    let mut next = 0;
    let counted = lines.map(|line| match line.split_once(' ') {
        Some((number, text)) if number.parse::<u64>().is_ok() => {
            next += 1;
            format!("{} {text}\n", next - 1)
        }
        _ => format!("{line}\n"),
    });
    counted.collect()
}

#[test]
fn a_lost_line_is_reported_with_its_line_of_the_cl_data() {
    const LOST: &str = "has no block before this one: missing or out of order";
    for control in ["linuxcnc", "fanuc", "siemens", "heidenhain", "haas"] {
        let posted = Posted::new(control, "[retract]\ndistance = 20\n[cl]\ndialect = 'nx'\n", TWO_TOOLS);
        assert!(posted.findings(&posted.program).is_empty());
        let change = if control == "heidenhain" { "TOOL CALL 2" } else { "M6" };
        let (a_feed, a_rapid, a_hole) = (["X11", "8"], ["X41", "14"], ["X32", "26"]);
        for [word, line] in [a_feed, a_rapid, a_hole, ["M1", "18"], [change, "19"]] {
            let plain = |text: &str| text.replace(['+', '.'], " ").replace("M0", "M").replace("X ", "X");
            let has = |text: &str| plain(text).contains(&format!("{word} "));
            let lost = posted.program.lines().collect::<Vec<&str>>().iter().rposition(|text| has(&format!("{text} ")));
            let found = posted.findings(&without(&posted.program, lost.unwrap_or_else(|| panic!("{word}"))));
            let first = found.first().unwrap_or_else(|| panic!("{control} {word}: nothing is found"));
            assert_eq!(first.location.line.to_string(), line, "{control} {word}: {found:?}");
            if word == change {
                assert!(first.text.starts_with("T1 is in the spindle, expected T2"), "{control}: {found:?}");
            } else {
                assert!(first.text.starts_with(&format!("CL line {line} {LOST}")), "{control} {word}: {found:?}");
                assert_eq!(found.len(), 1, "{control} {word}: {found:?}");
            }
        }
    }
}

#[test]
fn lines_that_are_lost_together_are_reported_together() {
    let posted = Posted::new("linuxcnc", "[retract]\ndistance = 20\n[cl]\ndialect = 'nx'\n", TWO_TOOLS);
    let at = posted.program.lines().position(|line| line == "X11 Y4").expect("it is there");
    let found = posted.findings(&without(&without(&posted.program, at), at));
    assert_eq!(found.len(), 1, "{found:?}");
    assert!(found[0].text.contains("CL lines 8 to 9 have no block before this one"), "{found:?}");
}

#[test]
fn lost_motions_of_a_subprogram_are_reported_with_the_line_before_its_call() {
    let part = "DEFSUB/1\nGOTO/10,0,5\nGOTO/20,0,5\nGOTO/20,10,5\nENDSUB\nRAPID\nGOTO/0,0,100,0,0,1\n\
        FEDRAT/MMPM,500\nGOTO/0,-10,5\nGOTO/10,-10,5\nCALSUB/1\nGOTO/20,20,5\n";
    let posted = Posted::new("linuxcnc", "", &format!("{HEAD}{part}"));
    let lines: Vec<&str> = posted.program.lines().collect();
    let first = lines.iter().position(|line| *line == "X10").expect("the line before the subprogram");
    // That line and the first of the subprogram.
    let lost: Vec<&str> =
        lines.iter().enumerate().filter(|(at, _)| *at != first && *at != first + 1).map(|(_, line)| *line).collect();
    let found = posted.findings(&lost.join("\n"));
    assert!(
        found.iter().any(|found| found.text.contains("CL line 15 and the subprogram that it calls have no block")),
        "{found:?}"
    );
}

#[test]
fn findings_use_the_terms_of_the_shop_floor() {
    let posted = Posted::new("fanuc", "[retract]\ndistance = 20\n[cl]\ndialect = 'nx'\n", TWO_TOOLS);
    let edited = |from: &str, to: &str| {
        // After the head, which has the same text in a comment.
        let at = posted.program.rfind(from).unwrap_or_else(|| panic!("{from}: {}", posted.program));
        let found = posted.findings(&[&posted.program[..at], to, &posted.program[at + from.len()..]].concat());
        found.into_iter().map(|found| found.text).collect::<Vec<String>>().join("; ")
    };
    for (from, to, expected) in [
        ("G54", "G55", "work offset is G55, expected G54"),
        ("S1000", "S1500", "S is 1500, expected 1000"),
        ("G43 H1", "G43 H7", "length compensation is register 7, expected register 1"),
        ("X11.", "/X11.", "the operator may skip this block (`/`), without OPSKIP/ON in the CL data here"),
    ] {
        let found = edited(from, to);
        assert!(found.contains(expected) && !found.contains("Some("), "{from} {to}: {found}");
    }
}

#[test]
fn after_a_lost_line_the_check_recovers_at_the_program_stop() {
    let part = TWO_TOOLS.replace("OPSTOP", "STOP");
    for control in ["linuxcnc", "siemens", "heidenhain"] {
        let posted = Posted::new(control, "[retract]\ndistance = 20\n[cl]\ndialect = 'nx'\n", &part);
        // The last cut, without which the retract has no starting point.
        let lost = posted.program.lines().position(|line| line.contains("43") && line.contains("37"));
        let found = posted.findings(&without(&posted.program, lost.expect("the cut")));
        let reported: Vec<(u64, &str)> = found.iter().map(|found| (found.location.line, &*found.text)).collect();
        assert!(
            !reported.is_empty() && reported.iter().all(|(line, _)| (14..=16).contains(line)),
            "{control}: {reported:#?}"
        );
    }
}

#[test]
fn a_truncated_program_is_distinguished_from_one_without_an_end_code() {
    let posted =
        Posted::new("linuxcnc", "[retract]\ndistance = 20\n", &format!("{HEAD}GOTO/1.0,0.0,0.0\nGOTO/2.0,0.0,0.0\n"));
    let findings = |program: &str| -> Vec<(u64, String)> {
        posted.findings(program).into_iter().map(|found| (found.location.line, found.text)).collect()
    };
    let without_end = posted.program.replace("M2\n", "");
    let [(_, text)] = &findings(&without_end)[..] else { panic!("{:?}", findings(&without_end)) };
    assert!(text.contains("no end code"), "{text}");
    let last = without_end.find("G1 ").expect("the cut");
    let [(7, text)] = &findings(&without_end[..last])[..] else { panic!("{:?}", findings(&without_end[..last])) };
    assert!(text.contains("breaks off before the end of the CL data"), "{text}");
}
