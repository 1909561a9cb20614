//! Generated kinematics modules by themselves: they agree with LinuxCNC's own modules for the same machines, answer
//! every question with a defined value, and read their pins only while they are switched.

use std::path::Path;

use pp_runtime::config::{Config, Mode};
use pp_runtime::kinematics::{AxisKind, Machine};
use pp_runtime::machine;
use pp_runtime::transformation::linuxcnc::files;
use tempfile::TempDir;
use tests::linuxcnc::installed;
use tests::linuxcnc::module::{MODULES, Module, Nine, can_be_compiled, compile};
use tests::random::Random;

use super::real_time::kinematics::{LENGTH, TableAc, TableBc, WORK_OFFSET, set_up};

machine! {
    /// The machine of `5axiskins`: its B is opposite to ISO 841, and a positive W moves the tool out of the head.
    pub(crate) struct Bridge;
    chain: | X Y Z C B W;
    dims = { pivot: 250.0 };
    d = { C: (0, 0, pivot), B: (0, 0, pivot) };
    hold = { W: 0 };
    signs = { B: -, W: - };
}

machine! {
    /// Its linear axes cannot move the tip in every direction at B 90.
    struct Between;
    chain: C X B | Y Z;
    d = { C: (0, 0, 0), B: (5, 0, 70) };
}

/// Letters of a pose in LinuxCNC.
const LETTERS: &str = "XYZABCUVW";

/// Largest difference between two modules, mm and degrees.
const SAME: f64 = 1e-9;

/// Compiles and loads the module of a machine, with the pins of its set-up.
fn generated<M: Machine>(config: &Config) -> (Module, TempDir) {
    let machine = config.set_up.machine::<M>().expect("valid");
    let files = files(&machine, config).expect("LinuxCNC can express it");
    let folder = TempDir::new().expect("a folder");
    let compiled = compile(&files, folder.path()).unwrap_or_else(|error| panic!("{}: {error}", M::NAME));
    let mut module = Module::load(&compiled, "", "");
    assert!(module.makes_its_pins_once(), "{}", M::NAME);
    let hal = &files.iter().find(|file| file.name.ends_with(".hal")).expect("a HAL file").text;
    for line in hal.lines().filter_map(|line| line.strip_prefix("setp ")) {
        let (pin, value) = line.split_once(' ').expect("a pin and a value");
        if !pin.starts_with("spindle") {
            module.set(pin, value.parse().expect("a number"));
        }
    }
    let tool = hal.lines().find_map(|line| line.split_once("=> ").filter(|(_, pin)| pin.ends_with("tool-offset")));
    module.set(tool.expect("the pin of the tool length").1, LENGTH);
    (module, folder)
}

/// Joints of the axes of a machine, mm and degrees, in the order of LinuxCNC.
fn joints<M: Machine>(random: &mut Random) -> Nine {
    let mut joints = [0.0; 9];
    let letters = LETTERS.chars().filter_map(|letter| M::AXES.iter().find(|axis| axis.letter == letter));
    for (joint, axis) in joints.iter_mut().zip(letters) {
        *joint = match axis.kind {
            AxisKind::Linear => random.between(-400.0, 400.0),
            AxisKind::Rotary if random.chance(0.2) => 90.0 * [-2.0, -1.0, 0.0, 1.0][random.below(4)],
            AxisKind::Rotary => random.between(-400.0, 400.0),
        };
    }
    joints
}

fn apart(one: &Nine, other: &Nine) -> f64 {
    one.iter().zip(other).map(|(one, other)| (one - other).abs()).fold(0.0, f64::max)
}

/// Compares the module of a machine with one of LinuxCNC, in both types and both directions.
fn agrees<M: Machine>(name: &str, letters: &str, pins: &[(&str, f64)]) {
    let (mut ours, _folder) = generated::<M>(&set_up(Mode::Tcp));
    let path = Path::new(MODULES).join(name).with_extension("so");
    let mut theirs = Module::load(&path, letters, "identityfirst");
    for (pin, value) in pins {
        theirs.set(&format!("{name}.{pin}"), *value);
    }
    let random = &mut Random::new(24);
    for kinematics in [1, 0] {
        assert!(ours.switch(kinematics) && theirs.switch(kinematics));
        for _ in 0..2_000 {
            let joints = joints::<M>(random);
            let (pose, other) = (ours.forward(&joints), theirs.forward(&joints));
            let (pose, other) = (pose.expect("a pose"), other.expect("a pose"));
            assert!(apart(&pose, &other) <= SAME, "{name} {kinematics}, {joints:?}: {pose:?}, own module {other:?}");
            let (back, other) = (ours.inverse(&pose).expect("joints"), theirs.inverse(&pose).expect("joints"));
            assert!(apart(&back, &other) <= SAME, "{name} {kinematics}, {pose:?}: {back:?}, own module {other:?}");
            assert!(apart(&back, &joints) <= SAME, "{name} {kinematics}: {joints:?} is {back:?} after both directions");
        }
    }
    assert!(ours.switch(1) && theirs.switch(1));
    let times: Vec<[f64; 2]> = (0..7).map(|_| [ours.nanoseconds(200_000), theirs.nanoseconds(200_000)]).collect();
    let mut ratios: Vec<f64> = times.iter().map(|[ours, theirs]| ours / theirs).collect();
    ratios.sort_by(f64::total_cmp);
    println!("{name}: time of ours to its own, median of 7: {:.2} ({times:?})", ratios[3]);
}

#[test]
fn modules_agree_with_those_of_the_control() {
    if !installed() || !can_be_compiled() {
        return;
    }
    let config = set_up(Mode::Tcp);
    let [x, y, z] = WORK_OFFSET;
    let [part_x, part_y, part_z] = config.set_up.part_origin;
    // Machine coordinates of the reference point of the table; the numbers are those of the declarations.
    let (x, y, z) = (x - part_x, y - part_y, z - part_z);
    agrees::<TableAc>(
        "xyzac-trt-kins",
        "XYZAC",
        &[
            ("x-rot-point", x + 12.5),
            ("y-rot-point", y - 7.25),
            ("y-offset", 14.75 + 7.25),
            ("z-offset", z + 31.5),
            ("tool-offset", LENGTH),
        ],
    );
    agrees::<TableBc>(
        "xyzbc-trt-kins",
        "XYZBC",
        &[
            ("x-rot-point", x - 4.5),
            ("y-rot-point", y + 9.75),
            ("x-offset", 11.0 + 4.5),
            ("z-offset", z - 22.25),
            ("tool-offset", LENGTH),
        ],
    );
    agrees::<Bridge>("5axiskins", "XYZBCW", &[("pivot-length", 250.0 + LENGTH)]);
}

#[test]
fn pins_are_read_at_the_switch_and_answers_are_defined() {
    if !can_be_compiled() {
        return;
    }
    let (mut module, _folder) = generated::<TableAc>(&set_up(Mode::Tcp));
    let joints = [10.0, -20.0, 30.0, 40.0, 50.0, 0.0, 0.0, 0.0, 0.0];
    let pose = [10.0, -20.0, 30.0, 40.0, 0.0, 50.0, 0.0, 0.0, 0.0];
    assert_eq!(module.forward(&joints), Some(pose), "type 0 has the joints as axes");
    assert!(module.is_on("kinstype.is-0") && !module.is_on("kinstype.is-1"));
    assert!(module.switch(1));
    assert!(!module.is_on("kinstype.is-0") && module.is_on("kinstype.is-1"));
    let tip = module.forward(&joints).expect("a pose");
    assert!(apart(&tip, &pose) > 10.0);
    // No step of the joints: they are where they were.
    assert!(apart(&module.inverse(&tip).expect("joints"), &joints) <= SAME);
    // A pin that changes under tip control takes effect at the next switch.
    let pin = "table-ac-kins.tilt-z";
    module.set(pin, 41.5);
    assert_eq!(module.forward(&joints), Some(tip));
    assert!(module.switch(1));
    let changed = module.forward(&joints).expect("a pose");
    assert!(apart(&changed, &tip) > 1.0);
    // What is no number, and types that do not exist, change nothing.
    module.set(pin, f64::NAN);
    assert!(!module.switch(1) && !module.switch(2) && !module.switch(-1));
    assert_eq!(module.forward(&joints), Some(changed));
    for (index, wrong) in [(0, f64::NAN), (2, f64::INFINITY), (3, f64::NAN), (5, f64::INFINITY)] {
        let mut pose = tip;
        pose[index] = wrong;
        assert_eq!(module.inverse(&pose), None, "{wrong} at {index}");
    }
    assert!(module.switch(0));

    let (mut module, _folder) = generated::<Between>(&set_up(Mode::Tcp));
    assert!(module.switch(1));
    assert!(module.inverse(&[1.0, 2.0, 3.0, 0.0, 45.0, 10.0, 0.0, 0.0, 0.0]).is_some());
    assert_eq!(module.inverse(&[1.0, 2.0, 3.0, 0.0, 90.0, 10.0, 0.0, 0.0, 0.0]), None, "X is parallel to Z");
}
