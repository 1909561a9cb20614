//! The whole control with its own kinematics modules: its joints and tips agree with the posted programs.
//!
//! One part is posted twice for a table of two rotaries. The `tcp` program holds tips and angles, and the control
//! computes the joints: they must be the axis values of the `axes` program. The `axes` program moves joints, and the
//! control computes the tip: it must be on the points of the CL data. The numbers of the centre lines are stated once,
//! in the declaration.
//!
//! The tables of these modules rotate right-handed about their letters: `signs` of `-` in a chain from workpiece to
//! tool. Tip control is switched by M428 and M429, which the control remaps to a change of its kinematics.

use std::io::Cursor;

use approx::abs_diff_eq;
use nalgebra::{Point3, Rotation3, UnitVector3, Vector3};
use pp_runtime::check::blocks;
use pp_runtime::check::read::{Action, Block, Length, TipControl};
use pp_runtime::config::{Config, Mode};
use pp_runtime::control::{LinuxCnc, TipControlSwitch};
use pp_runtime::kinematics::{AxisKind, Machine, Pose, PoseTolerance};
use pp_runtime::machine;
use pp_runtime::nalgebra;
use pp_runtime::post::{Job, post};
use pp_runtime::set_up::GivenTool;
use tests::block::distance_to_line;
use tests::linuxcnc::can_be_simulated;
use tests::linuxcnc::simulation::{Kinematics, MarkKinematics, Reached, SimulatedControl, Simulation, Tool};
use tests::oracle::angle_between;

use super::sweep::{cl_data, passes};

machine! {
    /// The machine of `xyzac-trt-kins`.
    pub(crate) struct TableAc;
    chain: C A | X Y Z;
    dims = { centre_x: 12.5, centre_y: -7.25, tilt_y: 14.75, tilt_z: 31.5 };
    d = { C: (centre_x, centre_y, 0), A: (0, tilt_y, tilt_z) };
    signs = { C: -, A: - };
    limits = { A: -100..100, X: -400..400, Y: -400..400, Z: -600..0 };
}

machine! {
    /// The same with the wrong sign of A.
    pub struct TableAcWrongSign;
    chain: C A | X Y Z;
    dims = { centre_x: 12.5, centre_y: -7.25, tilt_y: 14.75, tilt_z: 31.5 };
    d = { C: (centre_x, centre_y, 0), A: (0, tilt_y, tilt_z) };
    signs = { C: - };
    limits = { A: -100..100, X: -400..400, Y: -400..400, Z: -600..0 };
}

machine! {
    /// The machine of `xyzbc-trt-kins`.
    pub(crate) struct TableBc;
    chain: C B | X Y Z;
    dims = { centre_x: -4.5, centre_y: 9.75, tilt_x: 11.0, tilt_z: -22.25 };
    d = { C: (centre_x, centre_y, 0), B: (tilt_x, 0, tilt_z) };
    signs = { C: -, B: - };
    limits = { B: -100..100, X: -400..400, Y: -400..400, Z: -600..0 };
}

machine! {
    /// The same with the wrong sign of C.
    pub(crate) struct TableBcWrongSign;
    chain: C B | X Y Z;
    dims = { centre_x: -4.5, centre_y: 9.75, tilt_x: 11.0, tilt_z: -22.25 };
    d = { C: (centre_x, centre_y, 0), B: (tilt_x, 0, tilt_z) };
    signs = { B: - };
    limits = { B: -100..100, X: -400..400, Y: -400..400, Z: -600..0 };
}

/// Gauge length of tool 1, mm.
pub(crate) const LENGTH: f64 = 87.25;

/// Machine coordinate of the zero position: X Y Z of G54, mm.
pub(crate) const WORK_OFFSET: [f64; 3] = [-35.0, 20.5, -390.0];

/// Acceleration of the axes, mm/s² and deg/s²: so high that a test need not wait.
pub(crate) const ACCELERATION: f64 = 1e8;

/// Feed override, percent: a test does not wait for the feeds of the part.
pub(crate) const FEED_OVERRIDE: u32 = 1000;

/// Rounding of a word with three decimals, mm.
const ROUNDED: f64 = 0.5e-3;

/// Tolerance of a tip, mm: three rounded words, and the six decimals of the sampler.
pub(crate) const TIP: f64 = ROUNDED * 1.733 + 2e-6;

/// Tolerance of a joint that is computed from a rounded tip against a rounded word, mm.
pub(crate) const JOINT: f64 = TIP + ROUNDED;

/// Tolerance of a tool axis, rad: two angles with four decimals.
pub(crate) const AXIS: f64 = 0.5e-4 * 1.4143 / 57.295 + 1e-8;

/// Largest distance, mm, and angle, rad, between a point and the block that goes there: the rounding of its words.
const PARTNER: PoseTolerance = PoseTolerance { tip_mm: TIP, axis_rad: 2e-6 };

pub(crate) fn set_up(mode: Mode) -> Config {
    let mut config = Config::default();
    config.motion.mode = mode;
    config.set_up.part_origin = [40.0, -25.0, 18.0];
    config.set_up.machine_zero = "XYZ".chars().zip(WORK_OFFSET).collect();
    config.set_up.tools.insert(1, GivenTool { length_mm: Some(LENGTH), ..GivenTool::default() });
    config.motion.retract.distance_mm = Some(50.0);
    if mode == Mode::Tcp {
        config.control.tip_control = Some(TipControlSwitch::Codes(["M428".to_owned(), "M429".to_owned()]));
    }
    config
}

/// The control of a machine, with the declared centre lines in machine coordinates.
fn control<M: Machine>(kinematics: &'static str, letters: &'static str) -> SimulatedControl {
    let machine = set_up(Mode::Axes).set_up.machine::<M>().expect("valid");
    let index = |letter: char| M::AXES.iter().position(|axis| axis.letter == letter).expect("an axis of the chain");
    let centre = |letter: char| machine.joint(index(letter)).point.coords + Vector3::from(WORK_OFFSET);
    let tilt = letters.chars().nth(3).expect("a tilting axis");
    let (table, tilting) = (centre('C'), centre(tilt));
    let offset = tilting - table;
    let across = if tilt == 'A' { ("y-offset", offset.y) } else { ("x-offset", offset.x) };
    let pins = vec![("x-rot-point", table.x), ("y-rot-point", table.y), across, ("z-offset", tilting.z)];
    let travel = |letter: char| {
        let axis = M::AXES[index(letter)];
        match (axis.kind, axis.limits) {
            (_, None) => [-1e5, 1e5],
            (AxisKind::Linear, Some(limits)) => [limits.lower, limits.upper],
            (AxisKind::Rotary, Some(limits)) => [limits.lower, limits.upper].map(f64::to_degrees),
        }
    };
    let travel = letters.chars().map(travel).collect();
    SimulatedControl {
        kinematics: Kinematics::Module(kinematics, pins),
        letters,
        work_offsets: vec![WORK_OFFSET],
        travel,
        tools: vec![Tool { number: 1, length: LENGTH, diameter: 10.0 }],
        acceleration: ACCELERATION,
        feed_override: FEED_OVERRIDE,
    }
}

/// Blocks of a program that are compared, and the positions of the control after them.
pub(crate) struct Run {
    pub(crate) blocks: Vec<Block>,
    pub(crate) reached: Vec<Reached>,
    /// For each point of the CL data, the index of the block that goes there.
    pub(crate) partners: Vec<usize>,
}

/// Points of the CL data.
pub(crate) fn points() -> Vec<Pose> {
    passes().concat()
}

/// Only the blocks that go to the points, with their new indices.
fn only(blocks: &[Block], partners: &[usize]) -> (Vec<Block>, Vec<usize>) {
    (partners.iter().map(|&partner| blocks[partner].clone()).collect(), (0..partners.len()).collect())
}

/// Posts the part and runs it on the control; `every`: all blocks between the safe sequences are compared, else only
/// those that go to the points.
pub(crate) fn run<M: Machine>(simulation: &mut Simulation, config: &Config, every: bool) -> Run {
    let job = Job { cl_name: "sweep.cls", config, control: &LinuxCnc, units: None };
    let mut program = Vec::new();
    let report = post::<M>(&job, &mut Cursor::new(cl_data()), &mut program).expect("memory");
    let text = String::from_utf8(program).expect("ASCII");
    assert!(!report.failed, "{:?}\n{text}", report.diagnostics);
    let read = config.check_policy::<M>(&LinuxCnc, None).expect("the configuration suits control and machine");
    let blocks: Vec<Block> = blocks::<M>(&read, text.as_bytes()).expect("it can be read");
    let blocks: Vec<Block> = blocks.into_iter().filter(|block| is_compared::<M>(block, config.motion.mode)).collect();
    let partners = partners::<M>(&blocks, config);
    let (blocks, partners) = if every { (blocks, partners) } else { only(&blocks, &partners) };
    let lines: Vec<usize> = blocks.iter().map(|block| block.line as usize).collect();
    let mark_kinematics =
        if config.motion.mode == Mode::Tcp { MarkKinematics::AsProgrammed } else { MarkKinematics::OfMachine };
    let reached = simulation.run(&text, &lines, mark_kinematics).unwrap_or_else(|error| panic!("{}: {error}", M::NAME));
    Run { blocks, reached, partners }
}

/// Whether a block is a motion between the safe sequences with every axis at a known position.
fn is_compared<M: Machine>(block: &Block, mode: Mode) -> bool {
    let moves = matches!(block.action, Action::Rapid | Action::Feed) && block.written != 0;
    let known = block.known.count_ones() as usize == M::AXES.len();
    let tool = block.state.length == Some(Length::Register(1));
    moves && known && tool && (mode == Mode::Axes || block.state.tip_control != TipControl::Off)
}

/// Pose of a block by the product's reader.
fn pose_of_block<M: Machine>(machine: &M, block: &Block, mode: Mode) -> Pose {
    let mut axes = M::Axes::default();
    axes.as_mut().copy_from_slice(&block.values[..M::AXES.len()]);
    let pose = machine.forward_kinematics(&axes);
    if mode == Mode::Axes {
        return pose;
    }
    // A word that counts backwards does so under tip control, too.
    let word = |letter: char| {
        let index = M::AXES.iter().position(|axis| axis.letter == letter)?;
        Some(block.values[index] * M::AXES[index].sign.factor())
    };
    let tip = Point3::from(['X', 'Y', 'Z'].map(|letter| word(letter).expect("a linear axis")));
    Pose { tip, axis: pose.axis }
}

/// Indices of the blocks that go to the points, in order.
fn partners<M: Machine>(blocks: &[Block], config: &Config) -> Vec<usize> {
    let mut machine = config.set_up.machine::<M>().expect("valid");
    machine.set_up(config.set_up.part_origin.into(), LENGTH);
    let mut next = 0;
    let partner = |point: &Pose| {
        let goes_there =
            |block: &Block| abs_diff_eq!(pose_of_block(&machine, block, config.motion.mode), *point, epsilon = PARTNER);
        let found = blocks[next..].iter().position(goes_there).map(|index| next + index);
        next = found.unwrap_or_else(|| panic!("{}: no block goes to {point:?}", M::NAME)) + 1;
        next - 1
    };
    points().iter().map(partner).collect()
}

/// Largest differences between the control and the programs.
#[derive(Debug, Clone, Copy, Default)]
struct Difference {
    /// Tip of the `axes` program from the points, mm.
    tip: f64,
    /// Tool axis of the `axes` program from that of the points, rad.
    axis: f64,
    /// Tip of the blocks between points from the line between them, mm.
    path: f64,
    /// Linear joints of the `tcp` program from the words of the `axes` program, mm.
    joints: f64,
    /// Rotary joints of the `tcp` program from those of the `axes` program, degrees.
    rotary_joints: f64,
    /// Joints of the `axes` program from its own words, mm and degrees.
    words: f64,
    /// Joints X and Y from standstill, and Z from the length of the motion, where the tool moves along its axis under
    /// tip control, mm.
    along: f64,
}

/// Tip in the part by the control, mm, and tool axis with a table that rotates right-handed.
fn pose(reached: &Reached, letters: &str) -> (Point3<f64>, Vector3<f64>) {
    let axes = &reached.axes;
    let [x, y, z] = WORK_OFFSET;
    let tilted = if letters.contains('A') { Vector3::x_axis() } else { Vector3::y_axis() };
    let rotation = |axis: &UnitVector3<f64>, degrees: f64| Rotation3::from_axis_angle(axis, -degrees.to_radians());
    let axis = rotation(&Vector3::z_axis(), axes[4]) * rotation(&tilted, axes[3]) * Vector3::z();
    (Point3::new(axes[0] - x, axes[1] - y, axes[2] - z - LENGTH), axis)
}

/// Joints that a block of an `axes` program commands, mm and degrees.
fn commanded_joints<M: Machine>(block: &Block, letters: &str) -> Vec<f64> {
    let zero = [WORK_OFFSET[0], WORK_OFFSET[1], WORK_OFFSET[2] + LENGTH, 0.0, 0.0];
    let value = |(place, letter): (usize, char)| {
        let index = M::AXES.iter().position(|axis| axis.letter == letter).expect("an axis of the chain");
        let rotary = M::AXES[index].kind == AxisKind::Rotary;
        zero[place] + if rotary { block.values[index].to_degrees() } else { block.values[index] }
    };
    letters.chars().enumerate().map(value).collect()
}

/// The larger of two numbers; NaN if one of them is NaN.
pub(crate) fn larger(one: f64, other: f64) -> f64 {
    if one.is_nan() || other.is_nan() { f64::NAN } else { one.max(other) }
}

pub(crate) fn largest(differences: impl Iterator<Item = f64>) -> f64 {
    differences.fold(0.0, larger)
}

pub(crate) fn largest_difference(one: &[f64], other: &[f64]) -> f64 {
    largest(one.iter().zip(other).map(|(one, other)| (one - other).abs()))
}

/// Compares the two programs with each other and with the CL data, by the positions that the control has reached.
fn difference<M: Machine>(tcp: &Run, axes: &Run, letters: &str) -> Difference {
    let points = points();
    let mut found = Difference::default();
    for (index, point) in points.iter().enumerate() {
        let (by_tip, by_axes) = (&tcp.reached[tcp.partners[index]], &axes.reached[axes.partners[index]]);
        let (tip, axis) = pose(by_axes, letters);
        found.tip = larger(found.tip, (tip - point.tip).norm());
        found.axis = larger(found.axis, angle_between(&axis, &point.axis));
        found.joints = larger(found.joints, largest_difference(&by_tip.joints[..3], &by_axes.joints[..3]));
        found.rotary_joints =
            larger(found.rotary_joints, largest_difference(&by_tip.joints[3..], &by_axes.joints[3..]));
        if index > 0 && (points[index - 1].axis.into_inner() - point.axis.into_inner()).norm() < 1e-12 {
            let before = &tcp.reached[tcp.partners[index - 1]];
            found.along = larger(found.along, off_axis(&before.joints, &by_tip.joints, &points[index - 1], point));
        }
    }
    for (block, reached) in axes.blocks.iter().zip(&axes.reached) {
        found.words = larger(found.words, largest_difference(&reached.joints, &commanded_joints::<M>(block, letters)));
    }
    found.path = largest([tcp, axes].into_iter().map(|run| off_path(run, &points, letters)));
    found
}

/// Motion of the joints other than Z while the tool moves along its axis, mm; 0 for any other motion.
fn off_axis(before: &[f64], after: &[f64], from: &Pose, to: &Pose) -> f64 {
    let motion = to.tip - from.tip;
    let along = motion.dot(&from.axis);
    if (motion - from.axis.into_inner() * along).norm() > 1e-6 {
        return 0.0;
    }
    largest_difference(&[after[0], after[1], after[2] - along], &before[..3])
}

/// Largest distance of feed blocks between two points from the line between them, mm.
fn off_path(run: &Run, points: &[Pose], letters: &str) -> f64 {
    let between = run.partners.windows(2).enumerate().flat_map(|(index, blocks)| {
        let feeds = (blocks[0] + 1..blocks[1]).filter(|&block| run.blocks[block].action == Action::Feed);
        feeds.map(move |block| (index, block))
    });
    largest(between.map(|(index, block)| {
        let (tip, _) = pose(&run.reached[block], letters);
        distance_to_line(&tip, &points[index].tip, &points[index + 1].tip)
    }))
}

/// Checks that a machine agrees with its control, and that a wrong sign and a displaced centre line are found.
fn assert_agrees<M: Machine, WrongSign: Machine>(kinematics: &'static str, letters: &'static str, centre: &str) {
    let mut simulation =
        Simulation::start(&control::<M>(kinematics, letters)).unwrap_or_else(|error| panic!("{error}"));
    let (tcp, axes) = (set_up(Mode::Tcp), set_up(Mode::Axes));
    let by_tip = run::<M>(&mut simulation, &tcp, true);
    let by_axes = run::<M>(&mut simulation, &axes, true);
    let right = difference::<M>(&by_tip, &by_axes, letters);
    println!("{kinematics}: {} and {} blocks, {right:?}", by_tip.blocks.len(), by_axes.blocks.len());
    assert!(right.tip <= TIP && right.axis <= AXIS && right.path <= TIP, "{right:?}");
    assert!(right.joints <= JOINT && right.rotary_joints <= 2e-6 && right.words <= 2e-6, "{right:?}");
    assert!(right.along <= 2.0 * TIP, "{right:?}");

    // The same numbers with one wrong sign: the tip of the control differs.
    let wrong_sign = difference::<WrongSign>(
        &run::<WrongSign>(&mut simulation, &tcp, false),
        &run::<WrongSign>(&mut simulation, &axes, false),
        letters,
    );
    println!("{kinematics} with a wrong sign: {wrong_sign:?}");
    assert!(
        wrong_sign.tip > 10.0 && wrong_sign.axis > 0.5 && wrong_sign.joints > 10.0 && wrong_sign.along > 10.0,
        "{wrong_sign:?}"
    );

    // A centre line that is displaced by a tenth of a millimetre.
    let declared = M::DIMENSIONS.iter().find(|dimension| dimension.name == centre).expect("a dimension").default;
    let mut displaced = axes;
    displaced.set_up.dimensions = [(centre.to_owned(), declared + 0.1)].into();
    let displaced = difference::<M>(&by_tip, &run::<M>(&mut simulation, &displaced, false), letters);
    println!("{kinematics} with {centre} displaced by a tenth: {displaced:?}");
    assert!((0.05..0.25).contains(&displaced.tip) && (0.05..0.25).contains(&displaced.joints), "{displaced:?}");

    // The control has the declared travel, and its messages are returned.
    let message = simulation
        .run("G21 G90 G54\nG0 X436\nM2\n", &[2], MarkKinematics::AsProgrammed)
        .expect_err("beyond the travel");
    assert!(message.contains("exceed joint 0's positive limit"), "{message}");
}

#[test]
fn a_table_of_a_and_c_agrees_with_the_control() {
    if can_be_simulated() {
        assert_agrees::<TableAc, TableAcWrongSign>("xyzac-trt-kins", "XYZAC", "tilt_z");
    }
}

#[test]
fn a_table_of_b_and_c_agrees_with_the_control() {
    if can_be_simulated() {
        assert_agrees::<TableBc, TableBcWrongSign>("xyzbc-trt-kins", "XYZBC", "centre_x");
    }
}
