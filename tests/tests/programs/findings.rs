//! The farthest points of paths that the check reports, against points computed here. Other texts and lines of findings
//! are in `tests/scenarios/findings.md`.

use std::f64::consts::PI;
use std::io::Cursor;

use machines::SpinnerU5620;
use nalgebra::{Point3, UnitVector3, Vector3};
use pp_runtime::check::{Finding, check};
use pp_runtime::config::{Config, starting_point};
use pp_runtime::control::{self, Control};
use pp_runtime::kinematics::{Machine, Pose};
use pp_runtime::post::{self, post};
use pp_runtime::program::Units;

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
        // The header states how rapids move: the lines of the program count differently.
        let without_line = |text: String| text.split("; line").next().unwrap_or_default().to_owned();
        found.into_iter().map(|found| without_line(found.text)).collect::<Vec<String>>().join("; ")
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
