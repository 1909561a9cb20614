//! LinuxCNC: the pins of a sheet, set at the module itself, give the joints of the machine.

use std::cell::RefCell;
use std::path::Path;

use approx::abs_diff_eq;
use machine_library::{BridgeMill, XyzabTdr, XyzacTrt, XyzbcTrt};
use pp_runtime::kinematics::Machine;
use pp_runtime::machine;
use pp_runtime::nalgebra::Vector3;
use pp_runtime::transformation::SheetControl::LinuxCnc;
use tests::linuxcnc::installed;
use tests::linuxcnc::module::{MODULES, Module, Nine};

use super::printed::Printed;
use super::{Position, agrees, refusal, sheet};

machine! {
    /// The machine of `xyzac-trt-kins` with the centre line of C anywhere.
    pub struct TableAc;
    chain: C A | X Y Z;
    dims = { centre_x: 12.5, centre_y: -7.25, tilt_y: 14.75, tilt_z: 31.5 };
    d = { C: (centre_x, centre_y, 0), A: (0, tilt_y, tilt_z) };
    signs = { C: -, A: - };
    limits = { A: -100..50 };
}

machine! {
    /// The same with the words of A and C as ISO 841 has them.
    pub struct TableAcIso;
    chain: C A | X Y Z;
    d = { C: (0, 0, 0), A: (0, 10, 20) };
    limits = { A: -50..100 };
}

machine! {
    /// The machine of `xyzbc-trt-kins` with the centre line of C anywhere.
    pub struct TableBc;
    chain: C B | X Y Z;
    dims = { centre_x: -4.5, centre_y: 9.75, tilt_x: 11.0, tilt_z: -22.25 };
    d = { C: (centre_x, centre_y, 0), B: (tilt_x, 0, tilt_z) };
    signs = { C: -, B: - };
}

machine! {
    /// The machine of `xyzab_tdr_kins` with both centre lines anywhere.
    pub struct TablesAb;
    chain: A B | X Y Z;
    dims = { a_y: 3.0, a_z: 4.0, b_x: 5.0, b_z: 6.0 };
    d = { A: (0, a_y, a_z), B: (b_x, 0, b_z) };
}

machine! {
    /// A fork head whose B is not under C.
    pub struct ForkOff;
    chain: | X Y Z C B;
    d = { C: (0, 0, 0), B: (12.5, 0, 150) };
    signs = { B: - };
}

/// Sets the pins of a sheet at a module, and compares its joints with those of the machine.
fn module_agrees<M: Machine>(name: &str, letters: &str, joints: &str) {
    if !installed() {
        return;
    }
    let path = Path::new(MODULES).join(name).with_extension("so");
    let module = RefCell::new(Module::load(&path, letters, if letters.is_empty() { "" } else { "identityfirst" }));
    assert!(module.borrow_mut().switch(1), "{name}");
    agrees::<M>(LinuxCnc, |printed: &Printed, position: &Position| {
        let mut module = module.borrow_mut();
        let gauge = position.length.z;
        let pins = ["x-rot-point", "y-rot-point", "z-rot-point", "x-offset", "y-offset", "z-offset"];
        for row in printed.rows.iter().filter(|row| pins.contains(&row.number.as_str()) && row.expected != "any") {
            module.set(&format!("{name}.{}", row.number), row.value());
        }
        for row in &printed.rows {
            match row.number.as_str() {
                pin @ ("tool-offset" | "tool-offset-z") => module.set(&format!("{name}.{pin}"), gauge),
                "pivot-length" => module.set(&format!("{name}.pivot-length"), row.value() + gauge),
                _ => {}
            }
        }
        let tip = position.point + position.length;
        let mut pose: Nine = [0.0; 9];
        pose[..3].copy_from_slice(tip.as_slice());
        for (letter, angle) in &position.angles {
            pose["XYZABC".find(*letter).expect("a letter")] = angle.to_degrees();
        }
        let found = module.inverse(&pose).expect("joints");
        for (letter, angle) in &position.angles {
            let joint = found[joints.find(*letter).expect("a joint")];
            assert!(abs_diff_eq!(joint, angle.to_degrees(), epsilon = 1e-9), "{name}: {letter}");
        }
        Vector3::from_fn(|component, _| found[joints.find(['X', 'Y', 'Z'][component]).expect("a joint")])
    });
}

#[test]
fn pins_of_tilting_tables_agree() {
    module_agrees::<TableAc>("xyzac-trt-kins", "XYZAC", "XYZAC");
    module_agrees::<XyzacTrt>("xyzac-trt-kins", "XYZAC", "XYZAC");
    module_agrees::<TableBc>("xyzbc-trt-kins", "XYZBC", "XYZBC");
    module_agrees::<XyzbcTrt>("xyzbc-trt-kins", "XYZBC", "XYZBC");
}

#[test]
fn pins_of_two_rotary_tables_agree() {
    module_agrees::<TablesAb>("xyzab_tdr_kins", "", "XYZAB");
    module_agrees::<XyzabTdr>("xyzab_tdr_kins", "", "XYZAB");
}

#[test]
fn the_pin_of_the_fork_head_agrees() {
    module_agrees::<BridgeMill>("5axiskins", "XYZBCW", "XYZBCW");
}

#[test]
fn a_module_that_counts_the_other_way_has_the_mirrored_declaration() {
    let reason = refusal::<TableAcIso>(LinuxCnc);
    assert!(reason.starts_with("xyzac-trt-kins counts C and A in the opposite direction"), "{reason}");
    let declaration =
        "declare `signs = { C: -, A: - }`, with its travel mirrored, `limits = { A: -100..50 }`, and post for that";
    assert!(reason.contains(declaration), "{reason}");
}

#[test]
fn machines_that_no_module_has_are_refused() {
    let reason = refusal::<machines::LolaXoyzba>(LinuxCnc);
    assert!(reason.starts_with("LolaXoyzba is none of the machines of LinuxCNC's own modules"), "{reason}");
    let reason = refusal::<ForkOff>(LinuxCnc);
    assert!(reason.contains("that of B is 12.5000 mm from it"), "{reason}");
}

#[test]
fn travel_and_types_are_on_the_sheet() {
    let text = sheet::<TableAc>(LinuxCnc, "").expect("a sheet");
    let printed = Printed::read(&text);
    let expected = |number: &str, name: &str| {
        let row = printed.rows.iter().find(|row| row.number == number && row.name == name);
        row.unwrap_or_else(|| panic!("{number} {name} in {text}")).expected.clone()
    };
    assert_eq!(expected("[KINS]", "KINEMATICS"), "xyzac-trt-kins");
    assert_eq!(expected("[KINS]", "KINEMATICS, sparm="), "identityfirst");
    assert_eq!(expected("[JOINT_3]", "MIN_LIMIT, A"), "-100.0000");
    assert_eq!(expected("[JOINT_3]", "MAX_LIMIT, A"), "50.0000");
    assert_eq!(expected("[RS274NGC]", "REMAP=M428, modalgroup=10, type"), "1");
    assert_eq!(expected("x-rot-point", "centre line of C, X"), "needs machine_zero");
    assert!(text.lines().all(|line| line.chars().count() <= super::printed::WIDTH), "{text}");
}
