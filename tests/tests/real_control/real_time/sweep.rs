//! A part for tables of two rotaries: every quadrant, more than a revolution, through the pole, near it, one tilted
//! face.

use std::f64::consts::TAU;
use std::fmt::Write as _;

use nalgebra::{Point3, UnitVector3, Vector3};
use pp_runtime::kinematics::Pose;

/// Length of approach and retract along the tool axis, mm.
const CLEAR: f64 = 60.0;

/// Height of the pole of the dome, and its radius, mm.
const DOME: (f64, f64) = (15.0, 45.0);

fn unit(x: f64, y: f64, z: f64) -> UnitVector3<f64> {
    UnitVector3::new_normalize(Vector3::new(x, y, z))
}

/// Pose with the tool perpendicular to the dome, at the point in the direction of the tool axis.
fn on_dome(axis: UnitVector3<f64>) -> Pose {
    let (pole, radius) = DOME;
    Pose { tip: Point3::new(0.0, 0.0, pole - radius) + axis.into_inner() * radius, axis }
}

fn spherical(tilt: f64, around: f64) -> UnitVector3<f64> {
    unit(tilt.sin() * around.cos(), tilt.sin() * around.sin(), tilt.cos())
}

/// One and a quarter revolutions around the dome; the tilt of the tool increases.
fn round() -> Vec<Pose> {
    (0..=40)
        .map(|step| on_dome(spherical(0.4 + 0.008 * f64::from(step), 0.3 + 1.25 * TAU * f64::from(step) / 40.0)))
        .collect()
}

/// Path over the top in a plane that passes the pole at `offset_rad`.
fn across(offset_rad: f64) -> Vec<Pose> {
    let pose = |step: i32| {
        let tilt = 0.06 * f64::from(step);
        on_dome(unit(tilt.tan() * 0.8 - offset_rad * 0.6, tilt.tan() * 0.6 + offset_rad * 0.8, 1.0))
    };
    (-10..=10).map(pose).collect()
}

/// A square on a tilted face, with a constant tool axis.
fn face() -> Vec<Pose> {
    let axis = spherical(0.7, 3.6);
    let [u, v] = [Vector3::y().cross(&axis).normalize(), axis.cross(&Vector3::y().cross(&axis)).normalize()];
    let corner = |(x, y): (f64, f64)| Pose { tip: Point3::new(-20.0, -12.0, 4.0) + u * x + v * y, axis };
    [(0.0, 0.0), (15.0, 0.0), (15.0, 12.5), (0.0, 12.5), (0.0, 0.0)].map(corner).to_vec()
}

/// The tip does not move, and the tool axis swings.
fn swing() -> Vec<Pose> {
    let pose =
        |step: i32| Pose { tip: Point3::new(22.0, -9.0, 6.0), axis: spherical(0.2 + 0.07 * f64::from(step), 5.0) };
    (0..=6).map(pose).collect()
}

/// Every pass, with its approach and retract.
pub(crate) fn passes() -> Vec<Vec<Pose>> {
    let with_approach_and_retract = |cut: Vec<Pose>| {
        let out = |pose: &Pose| Pose { tip: pose.tip + pose.axis.into_inner() * CLEAR, axis: pose.axis };
        let (first, last) = (out(&cut[0]), out(&cut[cut.len() - 1]));
        std::iter::once(first).chain(cut).chain([last]).collect()
    };
    [round(), across(0.0), across(0.02), face(), swing()].map(with_approach_and_retract).to_vec()
}

/// The CL data of all passes: fast, since the control runs in real time.
pub(crate) fn cl_data() -> String {
    let mut cl =
        "UNITS/MM\nPARTNO/SWEEP\nMULTAX\nFROM/0.0,0.0,250.0,0.0,0.0,1.0\nLOADTL/1\nSPINDL/RPM,9000,CLW\nCOOLNT/ON\n"
            .to_owned();
    for (index, pass) in passes().iter().enumerate() {
        let _ = write!(cl, "TOOL PATH/PASS {index},TOOL,BALL\nFEDRAT/MMPM,30000.0\n");
        for (place, Pose { tip, axis }) in pass.iter().enumerate() {
            if place == 0 || place == pass.len() - 1 {
                cl += "RAPID\n";
            }
            let numbers = [tip.x, tip.y, tip.z].map(|number| format!("{number:.6}")).join(",");
            let axis = [axis.x, axis.y, axis.z].map(|number| format!("{number:.9}")).join(",");
            let _ = writeln!(cl, "GOTO/{numbers},{axis}");
        }
        cl += "END-OF-PATH\n";
    }
    cl + "COOLNT/OFF\nSPINDL/OFF\nFINI\n"
}
