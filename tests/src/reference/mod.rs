//! A machine that solves its equations numerically, to test the suite itself: once correct, once with each of several
//! flaws.

mod machines;

use core::f64::consts::PI;
use core::fmt::Debug;
use core::marker::PhantomData;

use nalgebra::{Matrix3, Point3, UnitVector3, Vector3};
use pp_runtime::kinematics::{
    Axis, AxisKind, Branch, Dimension, Explanation, Invalid, Joint, Machine, MotionBound, Pose, REACH_TOLERANCE,
    SINGULAR_SINE, SMALLEST_DETERMINANT, Side, Solution, Solutions, Unreachable, curves_of_joints, rates_of_joints,
};

/// A deliberate error.
#[derive(Clone, Copy, PartialEq)]
enum Flaw {
    None,
    /// The first angle has the wrong sign.
    FlippedSign,
    /// The second branch comes first.
    SwappedBranches,
    /// The tilt comes from the arc cosine alone.
    LosesDigitsAtThePole,
    /// The free rotary goes to zero.
    ForgetsHeldValue,
    /// Forward kinematics leaves out the gauge length.
    ForgetsGaugeLength,
    /// The linear axes are a hundredth of a micrometre off.
    SlightlyOff,
    /// Every tool axis counts as reachable.
    ReachesEverything,
    /// `rates` rotates the tip in the wrong sense.
    BackwardRates,
    /// The bound is one percent too small.
    SmallBound,
    /// The bound is ten percent too large.
    LargeBound,
}

/// Description of one machine.
trait Table: Copy + Send + Sync + 'static {
    type Axes: Copy + Default + PartialEq + Debug + Send + Sync + 'static + AsRef<[f64]> + AsMut<[f64]>;
    const AXES: &'static [Axis];
    const HELD: Self::Axes;
    /// Direction and, for rotaries, a point of the centre line.
    const ROWS: &'static [([f64; 3], [f64; 3])];
    const TOOL: [f64; 3];
    const FLAW: Flaw;
}

/// A machine that is described by a table.
#[derive(Clone)]
struct Reference<T> {
    part_origin: Vector3<f64>,
    gauge_length: f64,
    table: PhantomData<T>,
}

impl<T> Default for Reference<T> {
    fn default() -> Self {
        Self { part_origin: Vector3::zeros(), gauge_length: 0.0, table: PhantomData }
    }
}

/// Rotates the vector `v` about the unit vector `n`.
fn rotated(n: &Vector3<f64>, sin: f64, cos: f64, v: &Vector3<f64>) -> Vector3<f64> {
    let along = n * n.dot(v);
    along + (v - along) * cos + n.cross(v) * sin
}

impl<T: Table> Reference<T> {
    /// Tip, directions of the solved linear axes, and tool axis; `linear`: whether the values of those axes count.
    fn place(&self, values: &[f64], linear: bool) -> (Vector3<f64>, Vec<Vector3<f64>>, Vector3<f64>) {
        let mut tip = Vector3::zeros();
        let mut columns = Vec::new();
        let mut axis = Vector3::from(T::TOOL).normalize();
        for (index, description) in T::AXES.iter().enumerate().rev() {
            let joint = self.joint(index);
            let value = joint.sign * values[index];
            match description.kind {
                AxisKind::Linear => {
                    if linear || description.held {
                        tip += joint.direction.into_inner() * value;
                    }
                    if !description.held {
                        columns.push(joint.direction.into_inner() * joint.sign);
                    }
                }
                AxisKind::Rotary => {
                    let (sin, cos) = value.sin_cos();
                    tip = rotated(&joint.direction, sin, cos, &(tip - joint.point.coords)) + joint.point.coords;
                    axis = rotated(&joint.direction, sin, cos, &axis);
                    for column in &mut columns {
                        *column = rotated(&joint.direction, sin, cos, column);
                    }
                }
            }
        }
        columns.reverse();
        (tip, columns, axis)
    }

    fn solved(&self) -> Vec<usize> {
        (0..T::AXES.len()).filter(|&i| T::AXES[i].kind == AxisKind::Rotary && !T::AXES[i].held).collect()
    }

    /// Directions of the solved rotaries and of the tool; rotations of held axes are applied.
    fn folded(&self, held: &T::Axes) -> (Vec<Vector3<f64>>, Vector3<f64>) {
        let mut tool = Vector3::from(T::TOOL).normalize();
        let mut directions: Vec<Vector3<f64>> = Vec::new();
        for (index, description) in T::AXES.iter().enumerate().rev() {
            let joint = self.joint(index);
            if description.kind == AxisKind::Rotary && description.held {
                let (sin, cos) = (joint.sign * held.as_ref()[index]).sin_cos();
                tool = rotated(&joint.direction, sin, cos, &tool);
                for direction in &mut directions {
                    *direction = rotated(&joint.direction, sin, cos, direction);
                }
            } else if description.kind == AxisKind::Rotary {
                directions.push(joint.direction.into_inner());
            }
        }
        directions.reverse();
        (directions, tool)
    }

    /// The rotary angles (signed, right-handed) with branch, singular and deviation.
    fn angles(&self, a: &Vector3<f64>, held: &T::Axes) -> Vec<(Vec<f64>, Branch, bool, f64)> {
        let (directions, t) = self.folded(held);
        let solved = self.solved();
        let near = |reached: &Vector3<f64>| {
            let angle = reached.cross(a).norm().atan2(reached.dot(a));
            if T::FLAW == Flaw::ReachesEverything { 0.0 } else { angle }
        };
        let between = |n: &Vector3<f64>, from: &Vector3<f64>, to: &Vector3<f64>| {
            let sin = n.dot(&from.cross(to));
            sin.atan2(n.cross(from).dot(&n.cross(to)))
        };
        match directions[..] {
            [] => {
                let deviation = near(&t);
                if deviation > REACH_TOLERANCE { vec![] } else { vec![(vec![], Branch::First, false, deviation)] }
            }
            [n] => {
                let angle = between(&n, &t, a);
                let deviation = near(&rotated(&n, angle.sin(), angle.cos(), &t));
                if deviation > REACH_TOLERANCE { vec![] } else { vec![(vec![angle], Branch::First, false, deviation)] }
            }
            [n, m] => {
                let alpha1 = m.cross(&n).dot(&m.cross(&t));
                let alpha2 = n.dot(&m.cross(&t));
                let d = alpha1 * alpha1 + alpha2 * alpha2;
                let sign = T::AXES[solved[1]].sign.factor();
                // The order of the branches is decided at the declared held values.
                let (at_default, tool) = self.folded(&T::HELD);
                let along_first = at_default[1].cross(&at_default[0]).dot(&at_default[1].cross(&tool));
                let across = at_default[0].dot(&at_default[1].cross(&tool));
                let sigma = if along_first.abs() > 1e-12 { along_first.signum() * sign } else { -across.signum() };
                let pole = |side: f64| (m.dot(&n) - side * m.dot(&t)).abs() < 1e-15;
                let rho = if pole(1.0) || pole(-1.0) { 1.0 - n.dot(&m).powi(2) } else { d.sqrt() };
                let offset = n.dot(&m) * m.dot(&t);
                let mut w = n.dot(a) - offset;
                // The factor that vanishes at a pole, without cancellation.
                let minus = if pole(1.0) { (a - n).norm_squared() / 2.0 } else { rho - w };
                let plus = if pole(-1.0) { (a + n).norm_squared() / 2.0 } else { rho + w };
                let mut square = minus * plus;
                if T::FLAW == Flaw::LosesDigitsAtThePole {
                    square = rho * rho - w * w;
                }
                if square < 0.0 {
                    w = w.signum() * rho;
                    square = 0.0;
                }
                let r = square.sqrt();
                let h = n.cross(a).norm();
                let singular = h < SINGULAR_SINE;
                let mut list = Vec::new();
                for (branch, side) in [(Branch::First, sigma), (Branch::Second, -sigma)] {
                    let side = if T::FLAW == Flaw::SwappedBranches { -side } else { side };
                    let (mut c, mut s) = ((alpha1 * w - side * alpha2 * r) / d, (alpha2 * w + side * alpha1 * r) / d);
                    let length = c.hypot(s);
                    (c, s) = (c / length, s / length);
                    let b = rotated(&m, s, c, &t);
                    let second = s.atan2(c);
                    let mut first = between(&n, &b, a);
                    if singular {
                        first = T::AXES[solved[0]].sign.factor() * held.as_ref()[solved[0]];
                        if T::FLAW == Flaw::ForgetsHeldValue {
                            first = 0.0;
                        }
                    }
                    let reached = rotated(&n, first.sin(), first.cos(), &b);
                    let deviation = near(&reached);
                    if deviation > REACH_TOLERANCE {
                        continue;
                    }
                    if T::FLAW == Flaw::FlippedSign {
                        first = -first;
                    }
                    let deviation = if deviation < 1e-13 { 0.0 } else { deviation };
                    list.push((vec![first, second], branch, singular, deviation));
                    if r < 1e-15 || singular {
                        break;
                    }
                }
                list
            }
            _ => unreachable!("at most two rotaries"),
        }
    }
}

impl<T: Table> Machine for Reference<T> {
    type Axes = T::Axes;
    const NAME: &'static str = "Reference";
    const AXES: &'static [Axis] = T::AXES;
    const DIMENSIONS: &'static [Dimension] = &[];
    const HELD: T::Axes = T::HELD;
    const EXPLANATION: &'static Explanation = &Explanation::EMPTY;

    fn dimension(&self, index: usize) -> f64 {
        panic!("there is no dimension {index}")
    }
    fn set_dimension(&mut self, index: usize, _value: f64) {
        panic!("there is no dimension {index}")
    }
    fn set_up(&mut self, part_origin: Vector3<f64>, gauge_length: f64) {
        self.part_origin = part_origin;
        self.gauge_length = gauge_length;
    }
    fn validate(&self) -> Result<(), Invalid> {
        if self.part_origin.iter().chain([&self.gauge_length]).all(|value| value.is_finite()) {
            Ok(())
        } else {
            Err(Invalid::NotFinite { name: "set-up" })
        }
    }
    fn joint(&self, index: usize) -> Joint {
        let (direction, point) = T::ROWS[index];
        let point = match (T::AXES[index].kind, T::AXES[index].side) {
            (AxisKind::Linear, _) => Vector3::zeros(),
            (AxisKind::Rotary, Side::Workpiece) => Vector3::from(point) - self.part_origin,
            (AxisKind::Rotary, Side::Tool) => Vector3::from(point) + self.tool_axis().into_inner() * self.gauge_length,
        };
        Joint {
            direction: UnitVector3::new_normalize(Vector3::from(direction)),
            point: Point3::from(point),
            sign: T::AXES[index].sign.factor(),
        }
    }
    fn tool_axis(&self) -> UnitVector3<f64> {
        UnitVector3::new_normalize(Vector3::from(T::TOOL))
    }
    fn forward_kinematics(&self, axes: &T::Axes) -> Pose {
        let mut machine = self.clone();
        if T::FLAW == Flaw::ForgetsGaugeLength {
            machine.gauge_length = 0.0;
        }
        let (tip, _, axis) = machine.place(axes.as_ref(), true);
        Pose { tip: Point3::from(tip), axis: UnitVector3::new_normalize(axis) }
    }
    fn inverse_kinematics(&self, pose: &Pose, held: &T::Axes) -> Solutions<T::Axes> {
        if !pose.tip.iter().chain(pose.axis.iter()).all(|value| value.is_finite()) {
            return Solutions::none();
        }
        let mut found = Vec::new();
        for (angles, branch, singular, deviation) in self.angles(&pose.axis, held) {
            let mut axes = *held;
            for (&index, angle) in self.solved().iter().zip(angles) {
                let value = T::AXES[index].sign.factor() * angle;
                axes.as_mut()[index] = if value <= -PI { PI } else { value };
            }
            if let Some(axes) = self.linear_axes(&pose.tip, &axes) {
                found.push(Solution { axes, branch, singular, deviation });
            }
        }
        let mut found = found.into_iter();
        Solutions::from_branches([found.next(), found.next()])
    }
    fn linear_axes(&self, tip: &Point3<f64>, axes: &T::Axes) -> Option<T::Axes> {
        let (start, columns, _) = self.place(axes.as_ref(), false);
        let matrix = Matrix3::from_columns(&columns);
        if matrix.determinant().abs() < SMALLEST_DETERMINANT {
            return None;
        }
        let moved = matrix.try_inverse()? * (tip.coords - start);
        let mut answer = *axes;
        let mut next = moved.iter();
        for (index, axis) in T::AXES.iter().enumerate() {
            if axis.kind == AxisKind::Linear && !axis.held {
                answer.as_mut()[index] = *next.next()?;
                if T::FLAW == Flaw::SlightlyOff {
                    answer.as_mut()[index] += 1e-8;
                }
            }
        }
        Some(answer)
    }
    fn motion(&self, from: &T::Axes, to: &T::Axes) -> MotionBound {
        let bound = curves_of_joints(self, from, to).bound();
        let factor = match T::FLAW {
            Flaw::SmallBound => 0.99,
            Flaw::LargeBound => 1.1,
            _ => return bound,
        };
        MotionBound {
            tip: bound.tip * factor,
            axis: bound.axis * factor,
            tip_rate: bound.tip_rate * factor,
            axis_step: bound.axis_step * factor,
            tip_step: bound.tip_step * factor,
            length: bound.length / factor,
            turn: bound.turn * factor,
        }
    }
    fn rates(&self, axes: &T::Axes, change: &T::Axes) -> (Vector3<f64>, Vector3<f64>) {
        let mut change = *change;
        if T::FLAW == Flaw::BackwardRates {
            change.as_mut()[0] *= -1.0;
        }
        rates_of_joints(self, axes, &change)
    }
    fn reach(&self, axis: &UnitVector3<f64>, held: &T::Axes) -> Result<(), Unreachable> {
        if !axis.iter().all(|value| value.is_finite()) {
            return Err(Unreachable::NotFinite);
        }
        if self.angles(axis, held).is_empty() {
            return Err(Unreachable::Fixed { machine: "", wanted: [0.0; 3], tool_axis: [0.0; 3] });
        }
        let pose = Pose { tip: Point3::origin(), axis: *axis };
        if self.inverse_kinematics(&pose, held).is_empty() {
            return Err(Unreachable::LinearAxes { machine: "", axes: "" });
        }
        Ok(())
    }
}
