//! Joints of LinuxCNC's own modules for the machines of the library that have one: the same as those of the machine.

use std::path::Path;

use machine_library::{BridgeMill, Max5, XyzabTdr, XyzacTrt, XyzbcTrt};
use pp_runtime::kinematics::{AxisKind, Machine};
use pp_runtime::nalgebra::Vector3;
use tests::by_hand::{axes, set_up};
use tests::linuxcnc::installed;
use tests::linuxcnc::module::{MODULES, Module, Nine};
use tests::random::Random;

/// Letters of a pose in LinuxCNC.
const LETTERS: &str = "XYZABCUVW";

/// A module, as it is loaded.
struct Own {
    name: &'static str,
    /// Letters of its joints; empty where they are fixed.
    letters: &'static str,
    /// Joints by number, where they are fixed.
    joints: &'static str,
    /// It has types of kinematics; type 1 is tip control.
    switched: bool,
}

/// Compares joints of random tips and angles with the axis values of the machine, mm. `pins` of a machine with a
/// set-up: those of the module when the reference point of the table is at the machine zero, and the height of the
/// spindle nose over the tip at the zero position.
fn agrees<M: Machine>(own: &Own, pins: impl Fn(&M, f64) -> Vec<(&'static str, f64)>) {
    if !installed() {
        return;
    }
    let path = Path::new(MODULES).join(own.name).with_extension("so");
    let random = &mut Random::new(23);
    for _ in 0..20 {
        let (mut machine, _, gauge_length) = set_up::<M>(random);
        machine.set_up(Vector3::zeros(), gauge_length);
        let mut module = Module::load(&path, own.letters, if own.switched { "identityfirst" } else { "" });
        for (pin, value) in pins(&machine, gauge_length) {
            module.set(&format!("{}.{pin}", own.name), value);
        }
        assert!(!own.switched || module.switch(1), "{}", own.name);
        for _ in 0..200 {
            let values = axes::<M>(random);
            let tip = machine.forward_kinematics(&values).tip;
            let mut pose: Nine = [0.0; 9];
            pose[..3].copy_from_slice(tip.coords.as_slice());
            for (axis, value) in M::AXES.iter().zip(values.as_ref()) {
                let place = LETTERS.find(axis.letter).expect("a letter");
                match axis.kind {
                    AxisKind::Rotary => pose[place] = value.to_degrees(),
                    AxisKind::Linear if place > 2 => pose[place] = *value,
                    AxisKind::Linear => {}
                }
            }
            let joints = module.inverse(&pose).expect("joints");
            for (axis, value) in M::AXES.iter().zip(values.as_ref()) {
                let joint = joints[own.joints.find(axis.letter).expect("a joint")];
                let expected = if axis.kind == AxisKind::Rotary { value.to_degrees() } else { *value };
                let apart = (joint - expected).abs();
                assert!(apart <= 1e-9, "{} {values:?}: joint {} is {joint}, not {expected}", own.name, axis.letter);
            }
        }
    }
}

#[test]
fn tilting_tables_have_the_joints_of_their_modules() {
    let own = Own { name: "xyzac-trt-kins", letters: "XYZAC", joints: "XYZAC", switched: true };
    agrees::<XyzacTrt>(&own, |machine, gauge| {
        vec![("y-offset", machine.y_offset), ("z-offset", machine.z_offset - gauge), ("tool-offset", gauge)]
    });
    let own = Own { name: "xyzbc-trt-kins", letters: "XYZBC", joints: "XYZBC", switched: true };
    agrees::<XyzbcTrt>(&own, |machine, gauge| {
        vec![("x-offset", machine.x_offset), ("z-offset", machine.z_offset - gauge), ("tool-offset", gauge)]
    });
}

#[test]
fn two_rotary_tables_have_the_joints_of_their_module() {
    let own = Own { name: "xyzab_tdr_kins", letters: "", joints: "XYZAB", switched: true };
    agrees::<XyzabTdr>(&own, |machine, _| {
        // The reference point is the centre of the face of A.
        vec![
            ("x-offset", machine.x_offset),
            ("z-offset", machine.z_offset),
            ("x-rot-point", -machine.x_offset),
            ("z-rot-point", -machine.z_offset),
        ]
    });
}

#[test]
fn the_fork_head_has_the_joints_of_its_module() {
    let own = Own { name: "5axiskins", letters: "XYZBCW", joints: "XYZBCW", switched: true };
    agrees::<BridgeMill>(&own, |machine, gauge| vec![("pivot-length", machine.pivot_length + gauge)]);
}

#[test]
fn max_has_the_joints_of_its_module() {
    let own = Own { name: "maxkins", letters: "", joints: LETTERS, switched: false };
    agrees::<Max5>(&own, |machine, gauge| vec![("pivot-length", machine.pivot_length + gauge)]);
}
