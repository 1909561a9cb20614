//! Small machines written by hand for the tests: closed-form angles, and linear axes solved numerically from the
//! product of the joints.

use approx::abs_diff_eq;
use nalgebra::{Isometry3, Matrix3, Point3, Translation3, UnitQuaternion, UnitVector3, Vector3};

use crate::kinematics::{
    Axis, AxisKind, Branch, Dimension, Explanation, Invalid, Joint, Limits, Machine, Pose, PoseTolerance, Side, Sign,
    Solution, Solutions, Unreachable, math,
};

const fn axis(letter: char, side: Side, limits: Option<Limits>) -> Axis {
    let kind = if matches!(letter, 'A' | 'B' | 'C') { AxisKind::Rotary } else { AxisKind::Linear };
    Axis { letter, kind, side, sign: Sign::Plus, limits, speed: None, held: false }
}

const fn degrees(lower: f64, upper: f64) -> Option<Limits> {
    Some(Limits { lower: lower.to_radians(), upper: upper.to_radians() })
}

const fn mm(lower: f64, upper: f64) -> Option<Limits> {
    Some(Limits { lower, upper })
}

fn direction(letter: char) -> UnitVector3<f64> {
    match letter {
        'X' | 'A' => Vector3::x_axis(),
        'Y' | 'B' => Vector3::y_axis(),
        _ => Vector3::z_axis(),
    }
}

/// The product of the joints.
fn product<M: Machine>(machine: &M, axes: &[f64]) -> Isometry3<f64> {
    let mut product = Isometry3::identity();
    for (index, described) in M::AXES.iter().enumerate() {
        let joint = machine.joint(index);
        let value = joint.sign * axes[index];
        product *= match described.kind {
            AxisKind::Linear => Isometry3::from(Translation3::from(joint.direction.into_inner() * value)),
            AxisKind::Rotary => {
                let rotation = UnitQuaternion::from_axis_angle(&joint.direction, value);
                let to_joint = Translation3::from(joint.point.coords);
                to_joint * rotation * to_joint.inverse()
            }
        };
    }
    product
}

fn forward<M: Machine>(machine: &M, axes: &[f64]) -> Pose {
    let product = product(machine, axes);
    Pose { tip: product * Point3::origin(), axis: product.rotation * machine.tool_axis() }
}

fn linear<M: Machine>(machine: &M, tip: &Point3<f64>, axes: &M::Axes) -> Option<M::Axes> {
    let solved: Vec<usize> = (0..M::AXES.len()).filter(|&i| M::AXES[i].kind == AxisKind::Linear).collect();
    let mut axes = *axes;
    for &i in &solved {
        axes.as_mut()[i] = 0.0;
    }
    let zero = forward(machine, axes.as_ref()).tip;
    let columns: Vec<_> = solved
        .iter()
        .map(|&i| {
            let mut moved = axes;
            moved.as_mut()[i] = 1.0;
            forward(machine, moved.as_ref()).tip - zero
        })
        .collect();
    let values = Matrix3::from_columns(&columns).try_inverse()? * (tip - zero);
    for (position, &i) in solved.iter().enumerate() {
        axes.as_mut()[i] = values[position];
    }
    Some(axes)
}

/// The parts in which the machines differ.
trait RotaryFormulas: Machine {
    const CENTRES: &'static [[f64; 3]];
    /// Angles of both branches, rad, in the order of the rotary axes, and whether the first angle is free.
    fn angles(axis: &UnitVector3<f64>, held: &Self::Axes) -> Option<(Vec<Vec<f64>>, bool)>;
}

fn inverse<M: RotaryFormulas>(machine: &M, pose: &Pose, held: &M::Axes) -> Solutions<M::Axes> {
    let rotaries: Vec<usize> = (0..M::AXES.len()).filter(|&i| M::AXES[i].kind == AxisKind::Rotary).collect();
    let Some((branches, singular)) = M::angles(&pose.axis, held) else { return Solutions::none() };
    let solution = |number: usize| {
        let mut axes = *held;
        for (&i, &angle) in rotaries.iter().zip(branches.get(number)?) {
            axes.as_mut()[i] = angle;
        }
        let axes = linear(machine, &pose.tip, &axes)?;
        let branch = if number == 0 { Branch::First } else { Branch::Second };
        let reached = forward(machine, axes.as_ref()).axis;
        let deviation = (reached.into_inner() - pose.axis.into_inner()).norm();
        Some(Solution { axes, branch, singular, deviation })
    };
    Solutions::from_branches([solution(0), solution(1)])
}

macro_rules! by_hand {
    ($(#[$doc:meta])* $name:ident, $count:literal, $axes:expr, $centres:expr, $angles:expr) => {
        $(#[$doc])*
        #[derive(Debug, Clone, Default, PartialEq)]
        pub(crate) struct $name {
            part_origin: Vector3<f64>,
            gauge_length: f64,
        }

        impl RotaryFormulas for $name {
            const CENTRES: &'static [[f64; 3]] = $centres;
            fn angles(axis: &UnitVector3<f64>, held: &[f64; $count]) -> Option<(Vec<Vec<f64>>, bool)> {
                let angles: fn(&UnitVector3<f64>, &[f64; $count]) -> Option<(Vec<Vec<f64>>, bool)> = $angles;
                angles(axis, held)
            }
        }

        impl Machine for $name {
            type Axes = [f64; $count];
            const NAME: &'static str = stringify!($name);
            const AXES: &'static [Axis] = $axes;
            const DIMENSIONS: &'static [Dimension] = &[];
            const HELD: [f64; $count] = [0.0; $count];
            const EXPLANATION: &'static Explanation = &Explanation::EMPTY;
            fn dimension(&self, _: usize) -> f64 {
                unreachable!("no dimensions")
            }
            fn set_dimension(&mut self, _: usize, _: f64) {}
            fn set_up(&mut self, part_origin: Vector3<f64>, gauge_length: f64) {
                self.part_origin = part_origin;
                self.gauge_length = gauge_length;
            }
            fn validate(&self) -> Result<(), Invalid> {
                Ok(())
            }
            fn joint(&self, index: usize) -> Joint {
                let described = &Self::AXES[index];
                let centre = Vector3::from(Self::CENTRES[index]);
                let point = match (described.kind, described.side) {
                    (AxisKind::Linear, _) => Vector3::zeros(),
                    (AxisKind::Rotary, Side::Workpiece) => centre - self.part_origin,
                    (AxisKind::Rotary, Side::Tool) => centre + Vector3::z() * self.gauge_length,
                };
                Joint { direction: direction(described.letter), point: Point3::from(point), sign: described.sign.factor() }
            }
            fn tool_axis(&self) -> UnitVector3<f64> {
                Vector3::z_axis()
            }
            fn forward_kinematics(&self, axes: &Self::Axes) -> Pose {
                forward(self, axes)
            }
            fn inverse_kinematics(&self, pose: &Pose, held: &Self::Axes) -> Solutions<Self::Axes> {
                inverse(self, pose, held)
            }
            fn linear_axes(&self, tip: &Point3<f64>, axes: &Self::Axes) -> Option<Self::Axes> {
                linear(self, tip, axes)
            }
            fn reach(&self, axis: &UnitVector3<f64>, held: &Self::Axes) -> Result<(), Unreachable> {
                if Self::angles(axis, held).is_some() {
                    return Ok(());
                }
                Err(Unreachable::Fixed { machine: Self::NAME, wanted: axis.into_inner().into(), tool_axis: [0.0, 0.0, 1.0] })
            }
        }
    };
}

use Side::{Tool, Workpiece};

by_hand!(
    /// `C B | X Y Z`: both rotary axes in the table.
    Cb,
    5,
    &[
        axis('C', Workpiece, None),
        axis('B', Workpiece, degrees(-5.0, 110.0)),
        axis('X', Tool, mm(-310.0, 310.0)),
        axis('Y', Tool, mm(-250.0, 250.0)),
        axis('Z', Tool, mm(-460.0, 0.0)),
    ],
    &[[0.0; 3], [0.5, 0.0, -40.0], [0.0; 3], [0.0; 3], [0.0; 3]],
    |axis, held| {
        let tilt = axis.x.hypot(axis.y);
        if tilt < 1e-15 {
            return Some((vec![vec![held[0], math::angle(0.0, axis.z)]], true));
        }
        let (c, b) = (math::angle(axis.y, axis.x), math::angle(tilt, axis.z));
        Some((vec![vec![c, b], vec![math::half_turn(c), -b]], false))
    }
);

by_hand!(
    /// `X | Y Z B A`: both rotary axes in the head.
    Head,
    5,
    &[
        axis('X', Workpiece, mm(-500.0, 500.0)),
        axis('Y', Tool, mm(-500.0, 500.0)),
        axis('Z', Tool, mm(-600.0, 0.0)),
        axis('B', Tool, degrees(-95.0, 95.0)),
        axis('A', Tool, degrees(-95.0, 95.0)),
    ],
    &[[0.0; 3], [0.0; 3], [0.0; 3], [0.0, 0.0, 150.0], [0.0, 5.0, 150.0]],
    |axis, held| {
        let level = axis.x.hypot(axis.z);
        if level < 1e-15 {
            return Some((vec![vec![held[3], math::angle(-axis.y, 0.0)]], true));
        }
        let (b, a) = (math::angle(axis.x, axis.z), math::angle(-axis.y, level));
        Some((vec![vec![b, a], vec![math::half_turn(b), math::mirrored(a)]], false))
    }
);

by_hand!(
    /// `C B | X Y Z` whose words of Y run backwards.
    Mirrored,
    5,
    &[
        axis('C', Workpiece, None),
        axis('B', Workpiece, degrees(-5.0, 110.0)),
        axis('X', Tool, None),
        Axis { sign: Sign::Minus, ..axis('Y', Tool, None) },
        axis('Z', Tool, None),
    ],
    &[[0.0; 3], [0.5, 0.0, -40.0], [0.0; 3], [0.0; 3], [0.0; 3]],
    Cb::angles
);

by_hand!(
    /// `A Y | X Z`: one rotary axis in the table.
    Ay,
    4,
    &[
        axis('A', Workpiece, None),
        axis('Y', Workpiece, mm(-100.0, 100.0)),
        axis('X', Tool, mm(-200.0, 200.0)),
        axis('Z', Tool, mm(-150.0, 0.0)),
    ],
    &[[0.0, 0.0, -30.0], [0.0; 3], [0.0; 3], [0.0; 3]],
    |axis, _| (axis.x.abs() < 1e-6).then(|| (vec![vec![math::angle(-axis.y, axis.z)]], false))
);

by_hand!(
    /// `| X Y Z`: no rotary axis.
    Xyz,
    3,
    &[axis('X', Tool, mm(-200.0, 200.0)), axis('Y', Tool, mm(-200.0, 200.0)), axis('Z', Tool, mm(-300.0, 0.0))],
    &[[0.0; 3]; 3],
    |axis, _| (axis.z > 1.0 - 1e-12).then(|| (vec![vec![]], false))
);

by_hand!(
    /// `| X Y W`: a quill instead of Z.
    Xyw,
    3,
    &[axis('X', Tool, None), axis('Y', Tool, None), axis('W', Tool, None)],
    &[[0.0; 3]; 3],
    |axis, _| (axis.z > 1.0 - 1e-12).then(|| (vec![vec![]], false))
);

#[test]
fn the_machines_of_the_tests_agree_with_themselves() {
    fn check<M: Machine>() {
        let mut machine = M::default();
        machine.set_up(Vector3::new(3.0, -2.0, 50.0), 120.0);
        let mut axes = M::HELD;
        for (index, value) in axes.as_mut().iter_mut().enumerate() {
            *value =
                if M::AXES[index].kind == AxisKind::Rotary { 0.3 + 0.2 * index as f64 } else { 10.0 * index as f64 };
        }
        let pose = machine.forward_kinematics(&axes);
        for solution in machine.inverse_kinematics(&pose, &M::HELD).iter() {
            let again = machine.forward_kinematics(&solution.axes);
            let largest = PoseTolerance { tip_mm: 1e-9, axis_rad: 1e-12 };
            assert!(abs_diff_eq!(again, pose, epsilon = largest), "{}: {again:?} is not {pose:?}", M::NAME);
        }
    }
    check::<Cb>();
    check::<Mirrored>();
    check::<Head>();
    check::<Ay>();
    check::<Xyz>();
    check::<Xyw>();
}
