//! The mixed job on the control: where the tool really was.

use nalgebra::{Point3, Rotation3, UnitVector3, Vector3};
use pp_runtime::kinematics::{Machine, Pose};
use tests::linuxcnc::simulation::{
    Kinematics, MarkKinematics, Reached, RotaryTable, Rotation, SimulatedControl, Simulation, Tool,
};
use tests::oracle::Oracle;

use super::super::kinematics::{largest, largest_difference};

/// Joints in the order of the control, and their axes.
const LETTERS: &str = "XYZBC";

/// Machine coordinates of the tip of a tool of length 0 on the reference point of the table, mm.
const REFERENCE: Vector3<f64> = Vector3::new(-35.0, 20.5, -440.0);

/// Tools of the job: number, length, diameter, mm.
const TOOLS: [Tool; 4] = [
    Tool { number: 1, length: 120.0, diameter: 8.0 },
    Tool { number: 2, length: 110.0, diameter: 8.0 },
    Tool { number: 3, length: 100.0, diameter: 10.0 },
    Tool { number: 4, length: 130.0, diameter: 6.0 },
];

/// Acceleration of the axes, mm/s² and deg/s²: in a thread the control corrects the error of a servo cycle with it, and
/// at a much higher one it never settles.
const ACCELERATION: f64 = 1.6e6;

/// Feed override, percent: a test does not wait for the feeds of the job.
pub(super) const FEED_OVERRIDE: u32 = 4000;

/// The zero of each set-up from the reference point of the table, mm, and its rotation about Z, degrees.
const SET_UPS: [([f64; 3], f64); 2] = [([0.0, 0.0, 50.0], 0.0), ([5.0, 0.0, 60.0], 90.0)];

/// A line of the program that has been carried out.
#[derive(Debug, Clone)]
pub(super) struct Line {
    pub(super) number: usize,
    pub(super) text: String,
    /// The G code of the motion in force.
    pub(super) motion: String,
    /// Poses in the part of the set-up in every servo cycle since the line before that is here.
    pub(super) way: Vec<Pose>,
    /// Pose at its end.
    pub(super) end: Pose,
    /// Largest motion of a joint since then, mm or degrees.
    pub(super) moved: f64,
    /// The operation, by the comment that begins it.
    pub(super) operation: String,
}

/// The control of a machine `C B | X Y Z`; its centre lines are those of the declaration.
pub(super) fn control<M: Machine>() -> SimulatedControl {
    let machine = M::default();
    let rotation = |letter: char| {
        let joint = machine.joint(index::<M>(letter));
        let point = joint.point.coords + REFERENCE;
        Rotation { direction: (joint.direction.into_inner() * joint.sign).into(), point: point.into() }
    };
    SimulatedControl {
        kinematics: Kinematics::Component(RotaryTable { b: rotation('B'), c: rotation('C') }),
        letters: LETTERS,
        work_offsets: SET_UPS.iter().map(|(zero, _)| (REFERENCE + Vector3::from(*zero)).into()).collect(),
        travel: vec![[-1e4, 1e4]; 5],
        tools: TOOLS.to_vec(),
        acceleration: ACCELERATION,
        feed_override: FEED_OVERRIDE,
    }
}

fn index<M: Machine>(letter: char) -> usize {
    M::AXES.iter().position(|axis| axis.letter == letter).expect("an axis of the chain")
}

/// Tip and tool axis in the part, by the oracle.
struct Observer<M> {
    oracle: Oracle,
    set_up: usize,
    length: f64,
    machine: std::marker::PhantomData<M>,
}

impl<M: Machine> Observer<M> {
    fn pose(&self, joints: &[f64]) -> Pose {
        let mut values = [0.0; 5];
        for (letter, joint) in LETTERS.chars().zip(joints) {
            values[index::<M>(letter)] = match letter {
                'X' => joint - REFERENCE.x,
                'Y' => joint - REFERENCE.y,
                'Z' => joint - REFERENCE.z - self.length,
                _ => joint.to_radians(),
            };
        }
        let on_table = self.oracle.forward(&values);
        let (zero, rotation) = SET_UPS[self.set_up];
        let part_from_table = Rotation3::from_axis_angle(&Vector3::z_axis(), -f64::to_radians(rotation));
        let tip = part_from_table * (on_table.tip.coords - Vector3::from(zero));
        Pose { tip: Point3::from(tip), axis: UnitVector3::new_normalize(part_from_table * on_table.axis.into_inner()) }
    }
}

/// Lines after which the control stops and is asked for its position: those with a block, but the last one, not between
/// G41 and G40, where LinuxCNC refuses to wait, and not after the O-words of a guard, which it passes over.
fn asked(program: &str) -> Vec<usize> {
    let mut compensated = false;
    let mut lines = Vec::new();
    for (index, line) in program.lines().enumerate() {
        if line.starts_with("G41") || line.starts_with("G40") {
            compensated = line.starts_with("G41");
        }
        if !compensated && !line.starts_with(['(', 'o']) && line != "M2" {
            lines.push(index + 1);
        }
    }
    lines
}

/// Runs a program; `M` is the machine that the control really moves.
pub(super) fn run<M: Machine>(simulation: &mut Simulation, program: &str) -> Result<Vec<Line>, String> {
    let asked = asked(program);
    let reached = simulation.run(program, &asked, MarkKinematics::AsProgrammed)?;
    Ok(lines::<M>(program, &reached))
}

fn lines<M: Machine>(program: &str, reached: &[Reached]) -> Vec<Line> {
    let mut observer =
        Observer::<M> { oracle: Oracle::of(&M::default()), set_up: 0, length: 0.0, machine: std::marker::PhantomData };
    let mut next = reached.iter().peekable();
    let (mut motion, mut operation) = (String::new(), String::new());
    let mut lines = Vec::new();
    for (index, text) in program.lines().enumerate() {
        if let Some(name) = text.strip_prefix("(OPERATION ") {
            operation = name.trim_end_matches(')').to_owned();
        }
        for word in text.split(' ').filter(|_| !text.starts_with('(')) {
            match word {
                "G0" | "G1" | "G2" | "G3" | "G33.1" | "G81" => motion = word.to_owned(),
                "G54" => observer.set_up = 0,
                "G55" => observer.set_up = 1,
                _ => {}
            }
            if let Some(number) = word.strip_prefix('H') {
                let number: u32 = number.parse().expect("a tool");
                observer.length = TOOLS.iter().find(|tool| tool.number == number).expect("a tool of the job").length;
            }
        }
        let Some(reached) = next.next_if(|reached| reached.line == index + 1) else { continue };
        let way: Vec<Pose> = reached.way.iter().map(|joints| observer.pose(joints)).collect();
        let off = |joints: &Vec<f64>| largest_difference(joints, &reached.joints);
        lines.push(Line {
            number: reached.line,
            text: text.to_owned(),
            motion: motion.clone(),
            way,
            end: observer.pose(&reached.joints),
            moved: largest(reached.way.iter().map(off)),
            operation: operation.clone(),
        });
    }
    lines
}
