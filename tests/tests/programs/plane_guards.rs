//! After a plane call a program stops where the control has chosen other rotary positions: with few decimals, indexed
//! axes and renamed axes as well, no right program stops or is rejected.

use std::f64::consts::TAU;
use std::io::Cursor;

use machines::{Dmu70e, LolaXoyzba, SpinnerU5620};
use pp_runtime::check::check;
use pp_runtime::config::{Config, starting_point};
use pp_runtime::control::{self, Control};
use pp_runtime::diag::Severity;
use pp_runtime::kinematics::Machine;
use pp_runtime::post::{Job, post};

const GUARDING: [&str; 2] = ["siemens", "heidenhain"];

/// Faces tilted by these angles, degrees, each in a direction of its own.
fn faces(tilts: &[f64]) -> String {
    let mut cl = "UNITS/MM\nTOOL PATH/FACES,TOOL,D8\nMSYS/0,0,0,1,0,0,0,1,0\nLOADTL/1,ADJUST,1\nSPINDL/RPM,3000,CLW\n"
        .to_owned();
    for (number, tilt) in tilts.iter().enumerate() {
        let (tilt, turn) = (tilt.to_radians(), TAU * (0.03 + number as f64 / 7.0));
        let axis = [tilt.sin() * turn.cos(), tilt.sin() * turn.sin(), tilt.cos()];
        let point = |height: f64, along: f64| {
            let [x, y, z] = axis.map(|part| part * height);
            format!("GOTO/{:.4},{:.4},{:.4},{:.7},{:.7},{:.7}\n", x + along, y, z, axis[0], axis[1], axis[2])
        };
        cl += &format!("RAPID\n{}FEDRAT/MMPM,500\n{}{}", point(60.0, 0.0), point(20.0, 0.0), point(60.0, 0.0));
    }
    cl + "END-OF-PATH\nFINI\n"
}

fn config<M: Machine>(control: &'static dyn Control, keys: &str) -> Config {
    let text = format!(
        "mode = 'plane'\npart_origin = [0.0, 0.0, 150.0]\n{keys}\n[retract]\ndistance = 80.0\n[tools]\n1 = {{ length = 120.0 }}\n"
    );
    starting_point(control).read_over(&M::default(), &text).unwrap_or_else(|faults| panic!("{text}: {faults:?}"))
}

/// A program that passes its check.
fn posted<M: Machine>(name: &str, keys: &str, cl: &str) -> String {
    let control = control::by_name(name).expect("it is there");
    let config = config::<M>(control, keys);
    let job = Job { cl_name: "faces.cls", config: &config, control, units: None };
    let mut program = Vec::new();
    let report = post::<M>(&job, &mut Cursor::new(cl), &mut program).expect("it can run");
    let error = report.diagnostics.into_iter().find(|found| found.severity == Severity::Error);
    assert!(error.is_none(), "{name} {keys}: {error:?}");
    let policy = config.check_policy::<M>(control, None).expect("it can be checked");
    let checked = check::<M>(&policy, Cursor::new(cl), program.as_slice()).expect("it can be read");
    let findings: Vec<String> = checked.outcome.findings.into_iter().map(|finding| finding.text).collect();
    let program = String::from_utf8(program).expect("ASCII");
    assert_eq!(findings, [""; 0], "{name} {keys}\n{program}");
    program
}

/// Axes compared after each plane call.
fn compared(program: &str) -> Vec<usize> {
    let sums = program.lines().filter(|line| line.contains("SIN"));
    sums.map(|line| line.matches("SIN").count()).collect()
}

#[test]
fn an_axis_that_the_tool_axis_does_not_fix_is_not_compared() {
    for name in GUARDING {
        let program = posted::<SpinnerU5620>(name, "", &faces(&[40.0, 5.0, 0.5]));
        assert_eq!(compared(&program), [2, 2, 1], "{name}\n{program}");
        assert!(compared(&posted::<SpinnerU5620>(name, "plane_guard = false", &faces(&[40.0]))).is_empty());
    }
}

#[test]
fn few_decimals_compare_less() {
    let cl = faces(&[40.0, 20.0, 5.0]);
    for name in GUARDING {
        let guards = |decimals: u32| {
            let keys = format!("axis_tolerance_path = 5.0\n[formats]\nrotary = {decimals}");
            compared(&posted::<SpinnerU5620>(name, &keys, &cl))
        };
        assert_eq!(guards(4), [2, 2, 2], "{name}");
        assert_eq!(guards(3), [2, 2, 2], "{name}");
        assert!(guards(1).is_empty(), "{name}");
    }
    posted::<Dmu70e>("heidenhain", "[formats]\nrotary = 2", &cl);
    posted::<LolaXoyzba>("heidenhain", "[formats]\nrotary = 2", &cl);
}

#[test]
fn a_plane_between_the_steps_of_indexed_axes_is_refused() {
    for name in ["siemens", "heidenhain", "fanuc", "haas"] {
        let by = if name == "haas" { "control.plane_by = 'tilted_plane'\n" } else { "" };
        let grid = &format!("{by}grid = {{ B = 0.5 }}\n[course]\naxis_tolerance = 0.5");
        let program = posted::<SpinnerU5620>(name, grid, &faces(&[40.0, 20.5]));
        assert!(program.contains("B40") || program.contains("B+40"), "{name}\n{program}");
        let control = control::by_name(name).expect("it is there");
        let config = config::<SpinnerU5620>(control, grid);
        let job = Job { cl_name: "faces.cls", config: &config, control, units: None };
        let cl = faces(&[40.15]);
        let report = post::<SpinnerU5620>(&job, &mut Cursor::new(cl), &mut Vec::new()).expect("it can run");
        assert!(
            report.diagnostics.iter().any(|found| format!("{found:?}").contains("° off the tool axis of this plane")),
            "{name}"
        );
    }
}

#[test]
fn a_renamed_axis_that_cannot_be_read_is_refused_with_the_key() {
    let control = control::by_name("heidenhain").expect("it is there");
    let keys = "[control]\naxes = { B = \"E\" }";
    let config = config::<SpinnerU5620>(control, keys);
    let faults = config.unfit(&SpinnerU5620::default(), control);
    assert!(faults.iter().any(|fault| fault.contains("plane_guard = false")), "{faults:?}");
    posted::<SpinnerU5620>("heidenhain", &format!("plane_guard = false\n{keys}"), &faces(&[40.0]));
    posted::<SpinnerU5620>("siemens", "[control]\naxes = { B = \"B1\" }", &faces(&[40.0]));
}
