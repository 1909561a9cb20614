//! True pose of the tool: the chain as a plain product of 4×4 matrices.
//!
//! [`Oracle`] multiplies what a machine *declares* (its axes, joints and tool axis); it shares no code with the
//! engine, and its rotation matrix is written out here. To find a wrongly transcribed joint too, [`papers`] holds the
//! machines of the source papers as literal chains that use nothing of the machine.

use core::f64::consts::PI;

use nalgebra::{Matrix3, Matrix4, Point3, UnitVector3, Vector3, Vector4};
use pp_runtime::kinematics::{Axis, AxisKind, Joint, Machine, Pose};

/// `Trans(v)`.
#[must_use]
#[rustfmt::skip]
pub fn translation(v: &Vector3<f64>) -> Matrix4<f64> {
    Matrix4::new(
        1.0, 0.0, 0.0, v.x,
        0.0, 1.0, 0.0, v.y,
        0.0, 0.0, 1.0, v.z,
        0.0, 0.0, 0.0, 1.0,
    )
}

/// `Rot(n, angle)`: right-handed rotation about the unit vector `n` through the origin (Rodrigues).
#[must_use]
#[rustfmt::skip]
pub fn rotation(n: &Vector3<f64>, angle: f64) -> Matrix4<f64> {
    let (s, c) = angle.sin_cos();
    let v = 1.0 - c;
    Matrix4::new(
        n.x * n.x * v + c,       n.x * n.y * v - n.z * s, n.x * n.z * v + n.y * s, 0.0,
        n.y * n.x * v + n.z * s, n.y * n.y * v + c,       n.y * n.z * v - n.x * s, 0.0,
        n.z * n.x * v - n.y * s, n.z * n.y * v + n.x * s, n.z * n.z * v + c,       0.0,
        0.0,                     0.0,                     0.0,                     1.0,
    )
}

/// `Trans(point) · Rot(n, angle) · Trans(-point)`.
#[must_use]
pub fn rotation_about(point: &Vector3<f64>, n: &Vector3<f64>, angle: f64) -> Matrix4<f64> {
    translation(point) * rotation(n, angle) * translation(&-point)
}

/// Angle between two directions, rad; exact for small and for flat angles.
#[must_use]
pub fn angle_between(a: &Vector3<f64>, b: &Vector3<f64>) -> f64 {
    a.cross(b).norm().atan2(a.dot(b))
}

/// `angle` minus whole revolutions, rad, in (-π, π].
#[must_use]
pub fn wrapped(angle: f64) -> f64 {
    let rest = angle.sin().atan2(angle.cos());
    if rest <= -PI { PI } else { rest }
}

/// Tip and tool axis of the tool; its axis at zero is `tool_axis`.
#[must_use]
pub fn pose_of(workpiece_from_tool: &Matrix4<f64>, tool_axis: &Vector3<f64>) -> Pose {
    let tip = workpiece_from_tool * Vector4::new(0.0, 0.0, 0.0, 1.0);
    let axis = workpiece_from_tool * tool_axis.push(0.0);
    Pose { tip: Point3::new(tip.x, tip.y, tip.z), axis: UnitVector3::new_normalize(axis.xyz()) }
}

/// A machine's chain for one set-up.
#[derive(Debug, Clone)]
pub struct Oracle {
    axes: &'static [Axis],
    joints: Vec<Joint>,
    tool_axis: Vector3<f64>,
}

/// Directions of the two solved rotaries and of the tool; rotations of held axes are applied.
#[derive(Debug, Clone, Copy)]
pub struct Rotaries {
    /// Direction of the rotary nearest the workpiece.
    pub first: Vector3<f64>,
    /// Direction of the other one, with the first at zero.
    pub second: Vector3<f64>,
    /// The tool axis, with both at zero.
    pub tool: Vector3<f64>,
}

impl Rotaries {
    /// Factor of the cosine of the second angle in `first · axis`.
    #[must_use]
    pub fn cosine_part(&self) -> f64 {
        self.second.cross(&self.first).dot(&self.second.cross(&self.tool))
    }

    /// Factor of the sine of the second angle in `first · axis`.
    #[must_use]
    pub fn sine_part(&self) -> f64 {
        self.first.dot(&self.second.cross(&self.tool))
    }

    /// `√D`: half the range of `first · axis` over the second rotary; zero where it cannot tilt the tool against the
    /// first.
    #[must_use]
    pub fn authority(&self) -> f64 {
        self.cosine_part().hypot(self.sine_part())
    }

    /// Smallest and largest angle between the tool axis and the first rotary, rad.
    #[must_use]
    pub fn cone(&self) -> (f64, f64) {
        let first_to_second = angle_between(&self.first, &self.second);
        let second_to_tool = angle_between(&self.second, &self.tool);
        let sum = first_to_second + second_to_tool;
        ((first_to_second - second_to_tool).abs(), sum.min(2.0 * PI - sum))
    }

    /// Whether the tool axis can be parallel to the first rotary: in the same direction for `side` `1.0`, in the
    /// opposite one for `-1.0`.
    #[must_use]
    pub fn ends_at_pole(&self, side: f64) -> bool {
        (self.second.dot(&self.first) - side * self.second.dot(&self.tool)).abs() < 1e-14
    }

    /// The second angle (right-handed, sign not applied) at which the tool is closest to the first rotary, rad; the
    /// other edge of the cone is at half a revolution more.
    #[must_use]
    pub fn edge(&self) -> f64 {
        self.sine_part().atan2(self.cosine_part())
    }
}

impl Oracle {
    /// The chain of a machine with its present dimensions and set-up.
    #[must_use]
    pub fn of<M: Machine>(machine: &M) -> Self {
        Self::new(M::AXES, (0..M::AXES.len()).map(|index| machine.joint(index)).collect(), machine.tool_axis())
    }

    pub(crate) fn new(axes: &'static [Axis], joints: Vec<Joint>, tool_axis: UnitVector3<f64>) -> Self {
        assert_eq!(axes.len(), joints.len(), "one joint per axis");
        Self { axes, joints, tool_axis: tool_axis.into_inner() }
    }

    fn matrix(&self, index: usize, value: f64) -> Matrix4<f64> {
        let joint = &self.joints[index];
        let signed = joint.sign * value;
        match self.axes[index].kind {
            AxisKind::Linear => translation(&(joint.direction.into_inner() * signed)),
            AxisKind::Rotary => rotation_about(&joint.point.coords, &joint.direction, signed),
        }
    }

    /// Pose of the tool for axis values in chain order, mm and rad.
    ///
    /// # Panics
    /// If there are not as many values as axes.
    #[must_use]
    pub fn forward(&self, values: &[f64]) -> Pose {
        assert_eq!(values.len(), self.axes.len(), "one value per axis");
        let mut workpiece_from_tool = Matrix4::identity();
        for (index, &value) in values.iter().enumerate() {
            workpiece_from_tool *= self.matrix(index, value);
        }
        pose_of(&workpiece_from_tool, &self.tool_axis)
    }

    /// Derivatives of tip and tool axis while the axes change by `change` in a unit of time: the product rule, on dual
    /// matrices.
    ///
    /// # Panics
    /// If there are not as many values as axes.
    #[must_use]
    pub fn rates(&self, values: &[f64], change: &[f64]) -> (Vector3<f64>, Vector3<f64>) {
        assert_eq!((values.len(), change.len()), (self.axes.len(), self.axes.len()), "one value per axis");
        let (mut product, mut dual) = (Matrix4::<f64>::identity(), Matrix4::<f64>::zeros());
        for (index, &value) in values.iter().enumerate() {
            let (matrix, slope) = (self.matrix(index, value), self.slope(index, value) * change[index]);
            dual = dual * matrix + product * slope;
            product *= matrix;
        }
        ((dual * Vector4::new(0.0, 0.0, 0.0, 1.0)).xyz(), (dual * self.tool_axis.push(0.0)).xyz())
    }

    /// Derivative of a joint's matrix by its value.
    fn slope(&self, index: usize, value: f64) -> Matrix4<f64> {
        let joint = &self.joints[index];
        match self.axes[index].kind {
            AxisKind::Linear => translation(&(joint.direction.into_inner() * joint.sign)) - Matrix4::identity(),
            AxisKind::Rotary => {
                // Sine and cosine at a quarter revolution more, minus the part along `n`, which does not rotate.
                let n = joint.direction.into_inner();
                let mut slope = rotation(&n, joint.sign * value + core::f64::consts::FRAC_PI_2);
                for row in 0..3 {
                    for column in 0..3 {
                        slope[(row, column)] -= n[row] * n[column];
                    }
                }
                slope[(3, 3)] = 0.0;
                translation(&joint.point.coords) * slope * translation(&-joint.point.coords) * joint.sign
            }
        }
    }

    /// Indices of the solved linear axes in chain order.
    #[must_use]
    pub fn linear(&self) -> Vec<usize> {
        self.indices(AxisKind::Linear)
    }

    /// Indices of the solved rotary axes in chain order.
    #[must_use]
    pub fn rotary(&self) -> Vec<usize> {
        self.indices(AxisKind::Rotary)
    }

    fn indices(&self, kind: AxisKind) -> Vec<usize> {
        (0..self.axes.len()).filter(|&index| self.axes[index].kind == kind && !self.axes[index].held).collect()
    }

    /// Motion of the tip in the workpiece frame per millimetre of each solved linear axis; unit columns.
    ///
    /// # Panics
    /// If the machine does not have three solved linear axes.
    #[must_use]
    pub fn linear_directions(&self, values: &[f64]) -> Matrix3<f64> {
        let mut rotated = Matrix4::identity();
        let mut columns = Vec::with_capacity(3);
        for (index, axis) in self.axes.iter().enumerate() {
            let joint = &self.joints[index];
            match axis.kind {
                AxisKind::Rotary => rotated *= rotation(&joint.direction, joint.sign * values[index]),
                AxisKind::Linear if axis.held => {}
                AxisKind::Linear => columns.push((rotated * joint.direction.push(0.0)).xyz() * joint.sign),
            }
        }
        assert_eq!(columns.len(), 3, "three solved linear axes");
        Matrix3::from_columns(&columns)
    }

    /// Determinant of the (unit) directions of the linear axes at these rotary and held values.
    #[must_use]
    pub fn determinant(&self, values: &[f64]) -> f64 {
        let directions = self.linear_directions(values);
        directions.column(0).cross(&directions.column(1)).dot(&directions.column(2))
    }

    /// Sets the solved linear axes so that the tip is at `tip`; rotary and held values do not change.
    ///
    /// # Panics
    /// If the determinant is zero.
    pub fn bring_tip_to(&self, tip: &Point3<f64>, values: &mut [f64]) {
        let linear = self.linear();
        for &index in &linear {
            values[index] = 0.0;
        }
        let inverse = self.linear_directions(values).try_inverse().expect("the linear axes are independent");
        let moved = inverse * (tip - self.forward(values).tip);
        for (&index, value) in linear.iter().zip(moved.iter()) {
            values[index] = *value;
        }
    }

    /// The two solved rotaries, with the rotations of held axes applied; `None` if there are not two.
    #[must_use]
    pub fn rotaries(&self, values: &[f64]) -> Option<Rotaries> {
        let [first_index, second_index] = self.rotary()[..] else { return None };
        let mut rotated = Matrix4::identity();
        let mut directions = Vec::with_capacity(2);
        for (index, joint) in self.joints.iter().enumerate() {
            if index == first_index || index == second_index {
                directions.push((rotated * joint.direction.push(0.0)).xyz());
            } else if self.axes[index].kind == AxisKind::Rotary {
                rotated *= rotation(&joint.direction, joint.sign * values[index]);
            }
        }
        let tool = (rotated * self.tool_axis.push(0.0)).xyz();
        Some(Rotaries { first: directions[0], second: directions[1], tool })
    }

    /// The tool axis with the first rotary at zero: only the second rotary and the held axes rotate it.
    ///
    /// # Panics
    /// If the machine does not have two solved rotaries.
    #[must_use]
    pub fn axis_before_first(&self, values: &[f64]) -> Vector3<f64> {
        let mut values = values.to_vec();
        values[self.rotary()[0]] = 0.0;
        self.forward(&values).axis.into_inner()
    }

    /// Sign of an axis, `1.0` or `-1.0`.
    #[must_use]
    pub fn sign(&self, index: usize) -> f64 {
        self.joints[index].sign
    }

    /// Length that rounding errors of the tip are proportional to, mm.
    #[must_use]
    pub fn scale(&self, values: &[f64]) -> f64 {
        let travel: f64 =
            (0..values.len()).filter(|&i| self.axes[i].kind == AxisKind::Linear).map(|i| values[i].abs()).sum();
        let arms: f64 = self.joints.iter().map(|joint| joint.point.coords.norm()).sum();
        1.0 + travel + 2.0 * arms
    }
}

/// The machines of the source papers as literal products, without any `joint` or direction of the machine.
///
/// Lengths in mm, angles in rad. `part_origin` is the part zero relative to the table's reference point, `gauge` the
/// distance from gauge line to tip.
pub mod papers {
    use core::f64::consts::FRAC_1_SQRT_2;

    use super::{Matrix4, Pose, Vector3, pose_of, rotation_about, translation};

    const X: Vector3<f64> = Vector3::new(1.0, 0.0, 0.0);
    const Y: Vector3<f64> = Vector3::new(0.0, 1.0, 0.0);
    const Z: Vector3<f64> = Vector3::new(0.0, 0.0, 1.0);
    /// `Rx(-45°)` applied to Y.
    const INCLINED_B: Vector3<f64> = Vector3::new(0.0, FRAC_1_SQRT_2, -FRAC_1_SQRT_2);

    fn pose(workpiece_from_tool: &Matrix4<f64>) -> Pose {
        pose_of(workpiece_from_tool, &Z)
    }

    /// Spinner U5-620, `C B | X Y Z`: both centre lines through `(0, 0, d)`; values in that order.
    #[must_use]
    pub fn spinner_u5_620(d: f64, part_origin: &Vector3<f64>, [c, b, x, y, z]: [f64; 5]) -> Pose {
        let centre = Vector3::new(0.0, 0.0, d) - part_origin;
        pose(&(rotation_about(&centre, &Z, c) * rotation_about(&centre, &Y, b) * translation(&Vector3::new(x, y, z))))
    }

    /// Deckel Maho DMU 70e, `C B | X Y Z`, B about `(0, 1, -1)/√2`: both centre lines through `(0, 0, d)`.
    #[must_use]
    pub fn dmu_70e(d: f64, part_origin: &Vector3<f64>, [c, b, x, y, z]: [f64; 5]) -> Pose {
        let centre = Vector3::new(0.0, 0.0, d) - part_origin;
        pose(
            &(rotation_about(&centre, &Z, c)
                * rotation_about(&centre, &INCLINED_B, b)
                * translation(&Vector3::new(x, y, z))),
        )
    }

    /// LOLA, `X | Y Z B A`: both centre lines at `gauge` above the tip.
    #[must_use]
    pub fn lola_xoyzba(gauge: f64, [x, y, z, b, a]: [f64; 5]) -> Pose {
        let centre = Z * gauge;
        pose(
            &(translation(&(X * x))
                * translation(&(Y * y))
                * translation(&(Z * z))
                * rotation_about(&centre, &Y, b)
                * rotation_about(&centre, &X, a)),
        )
    }

    /// MultiProDesk, `A Y | X Z` with negative signs for A and Y; the A centre line passes through `centre`, a point of
    /// the table.
    #[must_use]
    pub fn multiprodesk(centre: &Vector3<f64>, part_origin: &Vector3<f64>, [a, y, x, z]: [f64; 4]) -> Pose {
        pose(
            &(rotation_about(&(centre - part_origin), &X, -a)
                * translation(&(Y * -y))
                * translation(&(X * x))
                * translation(&(Z * z))),
        )
    }
}

#[cfg(test)]
mod tests {
    use core::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_2, SQRT_2};

    use approx::assert_abs_diff_eq;
    use nalgebra::{Point3, Vector3};

    use super::{angle_between, papers, rotation, wrapped};
    use crate::random::Random;

    fn assert_near(left: f64, right: f64) {
        assert_abs_diff_eq!(left, right, epsilon = 1e-11);
    }

    fn draw_angle(random: &mut Random) -> f64 {
        random.between(-3.2, 3.2)
    }

    fn draw_point(random: &mut Random) -> [f64; 3] {
        core::array::from_fn(|_| random.between(-300.0, 300.0))
    }

    #[test]
    fn a_rotation_of_90_degrees_about_z_brings_x_to_y() {
        let rotated = rotation(&Vector3::z(), FRAC_PI_2) * Vector3::x().push(0.0);
        assert_abs_diff_eq!(rotated.xyz(), Vector3::y(), epsilon = 5e-16);
    }

    #[test]
    fn small_and_flat_angles_are_exact() {
        let tilted = Vector3::new(1e-12, 0.0, 1.0);
        assert_abs_diff_eq!(angle_between(&tilted, &Vector3::z()), 1e-12, epsilon = 1e-24);
        assert_abs_diff_eq!(wrapped(3.0 * FRAC_PI_2), -FRAC_PI_2, epsilon = 1e-15);
    }

    #[test]
    fn spinner_obeys_its_paper() {
        let mut random = Random::new(1);
        for _ in 0..1000 {
            let (c, b, d) = (draw_angle(&mut random), draw_angle(&mut random), random.between(-200.0, 200.0));
            let [x_axis, y_axis, z_axis] = draw_point(&mut random);
            let pose = papers::spinner_u5_620(d, &Vector3::zeros(), [c, b, x_axis, y_axis, z_axis]);
            let ((sb, cb), (sc, cc)) = (b.sin_cos(), c.sin_cos());
            assert_near(pose.axis.x, sb * cc);
            assert_near(pose.axis.y, sb * sc);
            assert_near(pose.axis.z, cb);
            let Point3 { coords } = pose.tip;
            let (x, y, z) = (coords.x, coords.y, coords.z);
            assert_near(x_axis, x * cb * cc + y * cb * sc - z * sb + d * sb);
            assert_near(y_axis, -x * sc + y * cc);
            assert_near(z_axis, x * sb * cc + y * sb * sc + z * cb - d * cb + d);
        }
    }

    #[test]
    fn dmu_obeys_its_paper() {
        let mut random = Random::new(2);
        for _ in 0..1000 {
            let (c, b, d) = (draw_angle(&mut random), draw_angle(&mut random), random.between(-200.0, 200.0));
            let [x_axis, y_axis, z_axis] = draw_point(&mut random);
            let pose = papers::dmu_70e(d, &Vector3::zeros(), [c, b, x_axis, y_axis, z_axis]);
            let ((sb, cb), (sc, cc)) = (b.sin_cos(), c.sin_cos());
            assert_near(pose.axis.x, sb * cc / SQRT_2 + sc * (1.0 - cb) / 2.0);
            assert_near(pose.axis.y, sb * sc / SQRT_2 - cc * (1.0 - cb) / 2.0);
            assert_near(pose.axis.z, (1.0 + cb) / 2.0);
            let (x, y, z) = (pose.tip.x, pose.tip.y, pose.tip.z);
            assert_near(
                x_axis,
                FRAC_1_SQRT_2 * (d * sb + x * sb * sc - y * sb * cc - z * sb) + x * cb * cc + y * cb * sc,
            );
            let leaning = FRAC_1_SQRT_2 * (y * sb * sc + x * sb * cc);
            let rotated = -x * cb * sc + y * cb * cc + z * cb - d * cb;
            assert_near(y_axis, leaning + (rotated - x * sc + y * cc - z + d) / 2.0);
            assert_near(z_axis, leaning + (rotated + x * sc - y * cc + z + d) / 2.0);
        }
    }

    #[test]
    fn lola_obeys_its_paper() {
        let mut random = Random::new(3);
        for _ in 0..1000 {
            let (a, b, length) = (draw_angle(&mut random), draw_angle(&mut random), random.between(0.0, 300.0));
            let [x_axis, y_axis, z_axis] = draw_point(&mut random);
            let pose = papers::lola_xoyzba(length, [x_axis, y_axis, z_axis, b, a]);
            let ((sb, cb), (sa, ca)) = (b.sin_cos(), a.sin_cos());
            assert_near(pose.axis.x, sb * ca);
            assert_near(pose.axis.y, -sa);
            assert_near(pose.axis.z, cb * ca);
            assert_near(x_axis, pose.tip.x + length * sb * ca);
            assert_near(y_axis, pose.tip.y - length * sa);
            assert_near(z_axis, pose.tip.z + length * cb * ca - length);
        }
    }

    #[test]
    fn multiprodesk_obeys_its_paper() {
        let mut random = Random::new(4);
        for _ in 0..1000 {
            let a = draw_angle(&mut random);
            let [y_axis, x_axis, z_axis] = draw_point(&mut random);
            let centre = Vector3::from(draw_point(&mut random));
            let pose = papers::multiprodesk(&centre, &Vector3::zeros(), [a, y_axis, x_axis, z_axis]);
            let (sa, ca) = a.sin_cos();
            assert_near(pose.axis.x, 0.0);
            assert_near(pose.axis.y, sa);
            assert_near(pose.axis.z, ca);
            // The table rotates right-handed for positive A: undo that rotation about the centre line.
            let (y, z) = (pose.tip.y - centre.y, pose.tip.z - centre.z);
            assert_near(x_axis, pose.tip.x);
            assert_near(-y_axis, y * ca - z * sa + centre.y);
            assert_near(z_axis, y * sa + z * ca + centre.z);
        }
    }
}
