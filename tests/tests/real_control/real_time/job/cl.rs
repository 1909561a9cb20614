//! The CL data of the mixed job as the motions that they ask for, read without the product.

use nalgebra::{Point3, UnitVector3, Vector3};
use pp_runtime::kinematics::Pose;

/// What a point of the CL data asks for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Goal {
    /// The tool is here after a rapid.
    Rapid(Pose),
    /// The tool comes here on a straight line at feed, or on half a circle about a centre; with cutter compensation it
    /// is a radius to the left of its path.
    Feed { to: Pose, centre: Option<Point3<f64>>, compensated: bool },
    /// A hole with its mouth here: heights above it of the level from which the tool feeds, and of the bottom.
    Hole { mouth: Pose, clear: f64, bottom: f64, thread: bool },
}

impl Goal {
    /// The point of the CL data.
    pub(super) fn pose(&self) -> &Pose {
        match self {
            Self::Rapid(pose) | Self::Feed { to: pose, .. } | Self::Hole { mouth: pose, .. } => pose,
        }
    }

    pub(super) fn is_compensated(&self) -> bool {
        matches!(self, Self::Feed { compensated: true, .. })
    }
}

/// An operation of the CL data.
#[derive(Debug, Clone)]
pub(super) struct Operation {
    pub(super) name: String,
    /// The set-up, from 0.
    pub(super) set_up: usize,
    pub(super) goals: Vec<Goal>,
}

/// Modal state of the CL data.
struct Reader {
    operations: Vec<Operation>,
    axis: UnitVector3<f64>,
    rapid: bool,
    compensated: bool,
    centre: Option<Point3<f64>>,
    /// The cycle in force: clearance, bottom, whether it is a thread.
    cycle: Option<(f64, f64, bool)>,
}

/// The operations of the CL data. Frame numbers are those of the set-ups: each has one.
pub(super) fn operations(cl: &str) -> Vec<Operation> {
    let mut reader = Reader {
        operations: Vec::new(),
        axis: Vector3::z_axis(),
        rapid: false,
        compensated: false,
        centre: None,
        cycle: None,
    };
    for line in cl.lines() {
        let (word, rest) = line.split_once('/').unwrap_or((line, ""));
        reader.record(word, rest);
    }
    reader.operations
}

fn numbers(text: &str) -> Vec<f64> {
    text.split(',').map(|number| number.parse().expect("a number")).collect()
}

impl Reader {
    fn record(&mut self, word: &str, rest: &str) {
        match word {
            "TOOL PATH" => {
                let name = rest.split(',').next().unwrap_or_default().to_owned();
                self.operations.push(Operation { name, set_up: 0, goals: Vec::new() });
            }
            "MSYS" => self.last().set_up = usize::from(!rest.starts_with("0,0,0,")),
            "RAPID" => self.rapid = true,
            "CUTCOM" => self.compensated = rest == "LEFT",
            "CIRCLE" => self.centre = Some(Point3::from_slice(&numbers(rest)[..3])),
            "CYCLE" => self.cycle = cycle(rest),
            "GOTO" => self.goto(&numbers(rest)),
            _ => {}
        }
    }

    fn last(&mut self) -> &mut Operation {
        self.operations.last_mut().expect("an operation")
    }

    fn goto(&mut self, numbers: &[f64]) {
        if numbers.len() == 6 {
            self.axis = UnitVector3::new_normalize(Vector3::from_column_slice(&numbers[3..]));
        }
        let pose = Pose { tip: Point3::from_slice(&numbers[..3]), axis: self.axis };
        let centre = self.centre.take();
        let goal = match self.cycle {
            Some((clear, bottom, thread)) => Goal::Hole { mouth: pose, clear, bottom, thread },
            None if self.rapid => Goal::Rapid(pose),
            None => Goal::Feed { to: pose, centre, compensated: self.compensated },
        };
        self.rapid = false;
        self.last().goals.push(goal);
    }
}

/// `DRILL,RAPTO,3,FEDTO,-20,...`; `OFF` ends it.
fn cycle(text: &str) -> Option<(f64, f64, bool)> {
    let words: Vec<&str> = text.split(',').collect();
    let value = |name: &str| {
        let index = words.iter().position(|word| *word == name).expect("a word of every cycle");
        words[index + 1].parse().expect("a number")
    };
    (words[0] != "OFF").then(|| (value("RAPTO"), value("FEDTO"), words[0] == "TAP"))
}
