//! The whole control with generated kinematics: a module is compiled, loaded and switched, and runs posted programs.
//!
//! For each machine one part is posted twice. The `tcp` program holds tips and angles, and the control computes the
//! joints by the module: they must be the axis values of the `axes` program, and by the matrices of the oracle the tip
//! of the machine in these joints must be on the points of the CL data. A module with a wrong sign is found.

use nalgebra::{Point3, Vector3};
use pp_runtime::config::Mode;
use pp_runtime::kinematics::{AxisKind, Machine};
use pp_runtime::machine;
use pp_runtime::nalgebra;
use pp_runtime::transformation::linuxcnc::files;
use tests::linuxcnc::can_be_simulated;
use tests::linuxcnc::module::can_be_compiled;
use tests::linuxcnc::simulation::{Kinematics, Reached, SERVO_PERIOD, SimulatedControl, Simulation, can_be_loaded};
use tests::oracle::{Oracle, angle_between};

use super::kinematics::{
    ACCELERATION, AXIS, FEED_OVERRIDE, JOINT, LENGTH, Run, TIP, WORK_OFFSET, larger, largest_difference, points, run,
    set_up,
};

machine! {
    /// Table on table.
    struct TableOnTable;
    chain: C B | X Y Z;
    dims = { height: 60.5 };
    d = { C: (2, -3, 0), B: (0, 0, height) };
    limits = { X: -900..900, Y: -900..900, Z: -900..500, B: -5..110 };
}

machine! {
    /// A table, and a head.
    struct HeadOverTable;
    chain: C | X Y Z B;
    d = { C: (2, -3, 0), B: (8, 0, 140) };
}

machine! {
    /// Both rotary axes in the head.
    struct ForkHead;
    chain: X | Y Z C A;
    dims = { pivot: 180.0 };
    d = { C: (0, 0, pivot), A: (0, 12.5, pivot) };
}

machine! {
    /// B is inclined in the head.
    struct Nutating;
    chain: X Y | Z C B;
    dims = { tilt: 45 deg };
    axes = { B: Rx(tilt) * Y };
    d = { C: (0, 0, 210), B: (0, 25, 180) };
}

machine! {
    /// The same with the wrong sign of B.
    struct NutatingWrongSign;
    chain: X Y | Z C B;
    dims = { tilt: 45 deg };
    axes = { B: Rx(tilt) * Y };
    d = { C: (0, 0, 210), B: (0, 25, 180) };
    signs = { B: - };
}

machine! {
    /// The slide of Y is inclined, and its words count backwards.
    struct SlantBed;
    chain: C B | X Y Z;
    axes = { Y: (0, 1, -0.5) };
    d = { C: (10, 20, 0), B: (0, 0, -30) };
    signs = { Y: - };
}

/// Letters of LinuxCNC in its order.
const LETTERS: &str = "XYZABCUVW";

/// The control with the module of `Module`.
fn control<Module: Machine>(letters: &'static str) -> SimulatedControl {
    let mut config = set_up(Mode::Tcp);
    // Fast, so that a test need not wait.
    config.set_up.speeds = Module::AXES.iter().map(|axis| (axis.letter, 6e6)).collect();
    let machine = config.set_up.machine::<Module>().expect("valid");
    let files = files(&machine, &config).expect("LinuxCNC can express it");
    SimulatedControl {
        kinematics: Kinematics::Generated(files),
        letters,
        work_offsets: vec![WORK_OFFSET],
        travel: Vec::new(),
        tools: Vec::new(),
        acceleration: ACCELERATION,
        feed_override: FEED_OVERRIDE,
    }
}

/// Largest differences of a run with tip control from the CL data and from the program with axis positions.
#[derive(Debug, Clone, Copy, Default)]
struct Difference {
    /// Tip of the control from the points, mm.
    control_tip: f64,
    /// Tip of the machine in its joints, by the oracle, from the points, mm.
    tip: f64,
    /// Tool axis of the machine in its joints, by the oracle, from that of the points, rad.
    axis: f64,
    /// Joints from those of the program with axis positions, mm and degrees.
    joints: f64,
}

fn difference<M: Machine>(tcp: &Run, axes: &Run) -> Difference {
    let machine = set_up(Mode::Tcp).set_up.machine::<M>().map(|mut machine| {
        machine.set_up(set_up(Mode::Tcp).set_up.part_origin.into(), LENGTH);
        machine
    });
    let oracle = Oracle::of(&machine.expect("valid"));
    let mut found = Difference::default();
    for (index, point) in points().iter().enumerate() {
        let (by_tip, by_axes) = (&tcp.reached[tcp.partners[index]], &axes.reached[axes.partners[index]]);
        let offset = Vector3::from(WORK_OFFSET) + Vector3::z() * LENGTH;
        let word = |component: usize, letter: char| {
            let axis = M::AXES.iter().find(|axis| axis.letter == letter).expect("an axis of the chain");
            (by_tip.axes[component] - offset[component]) * axis.sign.factor()
        };
        let tip = Point3::new(word(0, 'X'), word(1, 'Y'), word(2, 'Z'));
        found.control_tip = larger(found.control_tip, (tip - point.tip).norm());
        let pose = oracle.forward(&words::<M>(by_tip));
        found.tip = larger(found.tip, (pose.tip - point.tip).norm());
        found.axis = larger(found.axis, angle_between(&pose.axis, &point.axis));
        found.joints = larger(found.joints, largest_difference(&by_tip.joints, &by_axes.joints));
    }
    found
}

/// Axis values in chain order, mm and rad, from the joints: without work offset and tool length.
fn words<M: Machine>(reached: &Reached) -> Vec<f64> {
    let letters: Vec<char> = LETTERS.chars().filter(|l| M::AXES.iter().any(|axis| axis.letter == *l)).collect();
    let offset = Vector3::from(WORK_OFFSET) + Vector3::z() * LENGTH;
    let word = |letter: char, kind: AxisKind| {
        let joint = letters.iter().position(|known| *known == letter).expect("a joint of the axis");
        let value = reached.joints[joint];
        match (kind, "XYZ".find(letter)) {
            (AxisKind::Rotary, _) => value.to_radians(),
            (AxisKind::Linear, Some(component)) => value - offset[component],
            (AxisKind::Linear, None) => value,
        }
    };
    M::AXES.iter().map(|axis| word(axis.letter, axis.kind)).collect()
}

/// Runs the part on the control with the module of `Module`, posted for `M`.
fn on_the_control<M: Machine, Module: Machine>(letters: &'static str) -> Difference {
    let mut simulation = Simulation::start(&control::<Module>(letters)).unwrap_or_else(|error| panic!("{error}"));
    let mut tcp = set_up(Mode::Tcp);
    // The control has the kinematics of this very machine.
    tcp.motion.tip.tcp_confirmed = true;
    let tcp = run::<M>(&mut simulation, &tcp, false);
    let axes = run::<M>(&mut simulation, &set_up(Mode::Axes), false);
    let found = difference::<M>(&tcp, &axes);
    println!("{} with the module of {}: {} points, {found:?}", M::NAME, Module::NAME, tcp.partners.len());
    found
}

fn assert_runs<M: Machine>(letters: &'static str) {
    let Difference { control_tip, tip, axis, joints } = on_the_control::<M, M>(letters);
    assert!(control_tip <= TIP && tip <= TIP && axis <= AXIS && joints <= JOINT, "{tip} {control_tip} {axis} {joints}");
}

/// Largest speeds, mm/min and deg/min, that a program must hold.
const SPEEDS: [(char, f64); 5] = [('X', 9_000.0), ('Y', 9_000.0), ('Z', 7_200.0), ('B', 2_700.0), ('C', 3_600.0)];

/// How many times faster than that the machine of this test moves, by its speeds and by the feed override, so that it
/// need not wait.
const FASTER: f64 = 10.0;

#[test]
fn joints_keep_their_speeds_under_tip_control() {
    if !possible() {
        return;
    }
    let mut config = set_up(Mode::Tcp);
    let speeds = |scale: f64| {
        let in_radians = |letter: char, speed: f64| if "BC".contains(letter) { speed.to_radians() } else { speed };
        SPEEDS.map(|(letter, speed)| (letter, scale * in_radians(letter, speed))).into()
    };
    config.set_up.speeds = speeds(FASTER);
    config.motion.tip.tcp_confirmed = true;
    // Exact path: where LinuxCNC rounds a corner, it adds the speeds of two blocks, with the unlimited acceleration of
    // this test in one cycle.
    let exact = "{units} G17 G40 G49 G80 G90 G94 {work_offset} G61".to_owned();
    config.control.safety = Some(vec![exact]);
    let machine = config.set_up.machine::<Nutating>().expect("valid");
    let files = files(&machine, &config).expect("LinuxCNC can express it");
    let faster = SimulatedControl { kinematics: Kinematics::Generated(files), ..control::<Nutating>("XYZBC") };
    let faster = SimulatedControl { feed_override: 100 * FASTER as u32, ..faster };
    let mut simulation = Simulation::start(&faster).unwrap_or_else(|error| panic!("{error}"));
    config.set_up.speeds = speeds(1.0);
    // Of the speed, over one servo cycle: the sampler has six decimals. With the line and the axis.
    let fastest = |run: &Run| {
        let cycles = run.reached.iter().flat_map(|reached| {
            reached.way.windows(2).zip(reached.cycles.windows(2)).map(|(joints, cycles)| (reached.line, joints, cycles))
        });
        let shares = cycles.flat_map(|(line, joints, cycles)| {
            let minutes = (cycles[1] - cycles[0]) as f64 * FASTER * SERVO_PERIOD / 60.0;
            let joints = joints[0].iter().zip(&joints[1]).zip(SPEEDS);
            let share = |((before, after), (letter, speed)): ((&f64, &f64), (char, f64))| {
                ((after - before).abs() / (speed * minutes), line, letter)
            };
            joints.map(share).collect::<Vec<_>>()
        });
        shares.fold((0.0, 0, ' '), |most, share| if share.0 > most.0 { share } else { most })
    };
    let held = fastest(&run::<Nutating>(&mut simulation, &config, false));
    // The same program without the speeds would be far too fast: the test can fail.
    config.motion.feed.keep_speeds = false;
    let free = fastest(&run::<Nutating>(&mut simulation, &config, false));
    println!("fastest joint, of its speed, with its line: {held:?}; without holding it {free:?}");
    assert!(held.0 <= 1.02 && free.0 > 1.2, "{held:?} {free:?}");
}

/// Whether generated modules can be compiled and loaded; if not, prints that the test is skipped.
fn possible() -> bool {
    can_be_simulated() && can_be_compiled() && can_be_loaded()
}

#[test]
fn tables_and_heads_run_under_generated_kinematics() {
    if possible() {
        assert_runs::<TableOnTable>("XYZBC");
        assert_runs::<HeadOverTable>("XYZBC");
        assert_runs::<ForkHead>("XYZAC");
    }
}

#[test]
fn inclined_axes_run_under_generated_kinematics_and_a_wrong_sign_is_found() {
    if possible() {
        assert_runs::<Nutating>("XYZBC");
        assert_runs::<SlantBed>("XYZBC");
        let wrong = on_the_control::<Nutating, NutatingWrongSign>("XYZBC");
        assert!(wrong.tip > 10.0 && wrong.joints > 10.0, "{wrong:?}");
    }
}
