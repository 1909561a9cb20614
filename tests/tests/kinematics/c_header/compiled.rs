//! The header of a machine, compiled into a program that answers poses.

use std::fs;
use std::io::Write as _;
use std::path::PathBuf;
use std::process::{Command, Stdio};

use nalgebra::Vector3;
use pp_runtime::kinematics::AnyMachine;
use pp_runtime::kinematics::{AxisValues, MAX_AXES, Pose};
use pp_runtime::nalgebra;
use pp_runtime::transformation::c_header;
use tempfile::TempDir;

/// A program made of a header.
pub(crate) struct Compiled {
    program: PathBuf,
    axes: usize,
    _folder: TempDir,
}

/// What the program computes for a pose.
#[derive(Debug)]
pub(crate) struct Answer {
    /// Axis values of each branch.
    pub(crate) solutions: Vec<AxisValues>,
    /// Tip and tool axis of each branch.
    forward: Vec<(Vector3<f64>, Vector3<f64>)>,
    /// All axes with the tip at the place of the pose and the others as given.
    pub(crate) linear: Option<AxisValues>,
}

impl Answer {
    /// Tip and tool axis of a solution of this answer.
    pub(crate) fn forward_of(&self, solution: &AxisValues) -> (Vector3<f64>, Vector3<f64>) {
        let index = self.solutions.iter().position(|known| std::ptr::eq(known, solution)).expect("of this answer");
        self.forward[index]
    }
}

/// Reads the set-up and then poses as binary numbers; prints the number of branches, both branches with their poses,
/// and the linear axes, as numbers too.
const MAIN: &str = r#"
#include <stdio.h>

int main(void)
{
    double set_up[4 + DIMENSIONS + 1], question[6 + AXES], answer[2 + 2 * (AXES + 6) + AXES];
    machine_machine m;
    machine_default(&m);
    if (fread(set_up, sizeof(double), 4 + DIMENSIONS, stdin) != 4 + DIMENSIONS) return 1;
    for (int i = 0; i < 3; i++) m.part_origin[i] = set_up[i];
    m.gauge_length = set_up[3];
    SET_DIMENSIONS
    while (fread(question, sizeof(double), 6 + AXES, stdin) == 6 + AXES) {
        const double *tip = question, *axis = question + 3, *held = question + 6;
        double axes[2 * AXES] = {0}, *to = answer + 2;
        const int count = machine_inverse(&m, tip, axis, held, axes);
        answer[0] = count;
        for (int branch = 0; branch < 2; branch++) {
            double reached[3] = {0}, direction[3] = {0};
            if (branch < count) machine_forward(&m, axes + branch * AXES, reached, direction);
            for (int i = 0; i < AXES; i++) *to++ = axes[branch * AXES + i];
            for (int i = 0; i < 3; i++) *to++ = reached[i];
            for (int i = 0; i < 3; i++) *to++ = direction[i];
        }
        for (int i = 0; i < AXES; i++) to[i] = held[i];
        answer[1] = machine_linear_axes(&m, tip, to);
        fwrite(answer, sizeof(double), sizeof(answer) / sizeof(double), stdout);
    }
    return 0;
}
"#;

impl Compiled {
    /// Compiles the header of a machine as strict C99, all warnings as errors.
    pub(crate) fn of(machine: &dyn AnyMachine) -> Self {
        let folder = TempDir::new().expect("a folder for temporary files");
        let header = c_header(machine, "machine").expect("declared with `machine!`");
        let fields = machine.c_source().fields;
        let set = fields.iter().enumerate().map(|(index, field)| format!("m.{field} = set_up[{}];", 4 + index));
        let main = MAIN.replace("SET_DIMENSIONS", &set.collect::<String>());
        let source =
            format!("{header}\n#define AXES {}\n#define DIMENSIONS {}\n{main}", machine.axes().len(), fields.len());
        let (path, program) = (folder.path().join("main.c"), folder.path().join("main"));
        fs::write(&path, source).expect("written");
        let mut compiler = Command::new("cc");
        compiler.args(["-std=c99", "-pedantic", "-Wall", "-Wextra", "-Werror", "-O1", "-o"]);
        let output = compiler.arg(&program).arg(&path).arg("-lm").output().expect("cc, which Rust needs to link");
        assert!(output.status.success(), "{}: {}", machine.name(), String::from_utf8_lossy(&output.stderr));
        Self { program, axes: machine.axes().len(), _folder: folder }
    }

    /// Answers of the program for a machine with a part origin and a gauge length.
    pub(crate) fn answers(
        &self,
        machine: &dyn AnyMachine,
        (origin, gauge): (Vector3<f64>, f64),
        poses: &[(Pose, AxisValues)],
    ) -> Vec<Answer> {
        let dimensions = (0..machine.dimensions().len()).map(|index| machine.dimension(index));
        let mut input: Vec<f64> = origin.iter().copied().chain([gauge]).chain(dimensions).collect();
        for (pose, held) in poses {
            input.extend(pose.tip.iter().chain(pose.axis.iter()).chain(&held[..self.axes]));
        }
        let bytes: Vec<u8> = input.iter().flat_map(|number| number.to_ne_bytes()).collect();
        let mut command = Command::new(&self.program);
        let mut process = command.stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().expect("the program starts");
        let mut stdin = process.stdin.take().expect("piped");
        let writer = std::thread::spawn(move || stdin.write_all(&bytes));
        let output = process.wait_with_output().expect("the program ends");
        writer.join().expect("no panic").expect("written");
        assert!(output.status.success());
        let (numbers, _) = output.stdout.as_chunks::<8>();
        let numbers: Vec<f64> = numbers.iter().map(|bytes| f64::from_ne_bytes(*bytes)).collect();
        numbers.chunks(2 + 2 * (self.axes + 6) + self.axes).map(|numbers| self.answer(numbers)).collect()
    }

    fn answer(&self, numbers: &[f64]) -> Answer {
        let values = |numbers: &[f64]| {
            let mut values = [0.0; MAX_AXES];
            values[..self.axes].copy_from_slice(&numbers[..self.axes]);
            values
        };
        let branches: Vec<&[f64]> = numbers[2..2 + 2 * (self.axes + 6)].chunks(self.axes + 6).collect();
        let count = [0.0, 1.0, 2.0].iter().position(|count| numbers[0].total_cmp(count).is_eq()).expect("0 to 2");
        let pose = |numbers: &[f64]| {
            let vector = |from: usize| Vector3::from_column_slice(&numbers[from..from + 3]);
            (vector(self.axes), vector(self.axes + 3))
        };
        Answer {
            solutions: branches[..count].iter().copied().map(values).collect(),
            forward: branches[..count].iter().copied().map(pose).collect(),
            linear: (numbers[1] > 0.5).then(|| values(&numbers[2 + 2 * (self.axes + 6)..])),
        }
    }
}
