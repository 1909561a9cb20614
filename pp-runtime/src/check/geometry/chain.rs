//! Axis values into tip and tool axis: the chain of the declaration as a product of matrices, at run time.
//!
//! `T(q) = Π J_i(q_i)` from the workpiece to the tool, `J = Trans(q·u)` for a linear axis, `Trans(c)·Rot(n, q)·Trans(-c)` for
//! a rotary one, `q` with its sign. The tip is `T·(0,0,0,1)`, the tool axis `T·(t,0)`. Nothing of the generated functions
//! is used: the joints are those that the declaration states. The product is applied to tip and axis from the tool
//! outwards, which costs a rotation of two vectors for each rotary axis.

use nalgebra::{Matrix3, Vector3};

use super::super::read::MAX_AXES;
use crate::kinematics::{AnyMachine, AxisKind, Side};

/// One factor of the product.
#[derive(Debug, Clone, Copy)]
struct Link {
    rotary: bool,
    workpiece: bool,
    /// Direction, with the sign of the axis.
    direction: Vector3<f64>,
    /// A point of the centre line, mm.
    point: Vector3<f64>,
}

/// The chain of a machine for one part and one tool.
#[derive(Debug, Clone)]
pub(crate) struct Chain {
    links: Vec<Link>,
    tool_axis: Vector3<f64>,
}

/// Tip and tool axis in the workpiece frame, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ToolPose {
    pub(crate) tip: Vector3<f64>,
    pub(crate) axis: Vector3<f64>,
}

/// Tip positions of a box of axis values.
#[derive(Debug, Clone, Copy)]
pub(crate) struct TipRegion {
    /// Tip in the middle of the box, mm.
    pub(crate) tip: Vector3<f64>,
    /// Its change with each axis value, mm per mm or rad.
    rates: [Vector3<f64>; MAX_AXES],
    /// Half the edges of the box, mm and rad.
    by: [f64; MAX_AXES],
    /// Largest distance of a tip from the position that the rates give, mm.
    pub(crate) bend_mm: f64,
    /// Share of each axis in it, mm; a motion of two axes counts for both.
    bends_mm: [f64; MAX_AXES],
}

impl TipRegion {
    /// Largest distance of a tip from the middle along a unit vector, against it, mm.
    pub(crate) fn extent_mm(&self, direction: &Vector3<f64>) -> f64 {
        let along = self.rates.iter().zip(&self.by).map(|(rate, by)| rate.dot(direction).abs() * by);
        along.sum::<f64>() + self.bend_mm
    }

    /// The axis whose motion in the box moves the tip farthest.
    pub(crate) fn widest(&self) -> usize {
        largest(|index| self.rates[index].norm() * self.by[index])
    }

    /// The axis whose motion in the box bends the path of the tip most.
    pub(crate) fn most_bent(&self) -> usize {
        largest(|index| self.bends_mm[index])
    }
}

fn largest(value: impl Fn(usize) -> f64) -> usize {
    (0..MAX_AXES).max_by(|a, b| value(*a).total_cmp(&value(*b))).unwrap_or(0)
}

impl Chain {
    pub(crate) fn of(machine: &dyn AnyMachine) -> Self {
        let link = |index: usize| {
            let joint = machine.joint(index);
            Link {
                rotary: machine.axes()[index].kind == AxisKind::Rotary,
                workpiece: machine.axes()[index].side == Side::Workpiece,
                direction: joint.direction.into_inner() * joint.sign,
                point: joint.point.coords,
            }
        };
        Self { links: (0..machine.axes().len()).map(link).collect(), tool_axis: machine.tool_axis().into_inner() }
    }

    /// Tip and tool axis for axis values in mm and rad.
    pub(crate) fn place(&self, values: &[f64; MAX_AXES]) -> ToolPose {
        let (mut tip, mut axis) = (Vector3::zeros(), self.tool_axis);
        for (link, value) in self.links.iter().zip(values).rev() {
            if link.rotary {
                let (sine, cosine) = value.sin_cos();
                tip = link.point + link.rotated(tip - link.point, sine, cosine);
                axis = link.rotated(axis, sine, cosine);
            } else {
                tip += link.direction * *value;
            }
        }
        ToolPose { tip, axis }
    }

    /// Tip positions of the axis values around `values`, each by `by` or less on its own, mm and rad.
    ///
    /// A rotation by `δ` about `n` moves `a + L`, `a` the arm and `L` what the axes nearer the tool add, by `δ·n×a` and, apart
    /// from that, by `|δ|·|n×L| + δ²/2·(|n×a| + |n×L|)` at most.
    pub(crate) fn around(&self, values: &[f64; MAX_AXES], by: &[f64; MAX_AXES]) -> TipRegion {
        let (mut tip, mut rates) = (Vector3::zeros(), [Vector3::zeros(); MAX_AXES]);
        let (mut bend_mm, mut bends_mm) = (0.0, [0.0; MAX_AXES]);
        for (index, (link, value)) in self.links.iter().zip(values).enumerate().rev() {
            if !link.rotary {
                (tip, rates[index]) = (tip + link.direction * *value, link.direction);
                continue;
            }
            let (sine, cosine) = value.sin_cos();
            let arm = link.rotated(tip - link.point, sine, cosine);
            let angle = by[index];
            let mut across_mm = 0.0;
            for nearer in index + 1..MAX_AXES {
                rates[nearer] = link.rotated(rates[nearer], sine, cosine);
                let added_mm = by[nearer] * link.direction.cross(&rates[nearer]).norm();
                across_mm += added_mm;
                bends_mm[nearer] += angle * added_mm;
            }
            (tip, rates[index]) = (link.point + arm, link.direction.cross(&arm));
            bends_mm[index] = angle * across_mm + 0.5 * angle * angle * (rates[index].norm() + across_mm);
            bend_mm += bends_mm[index];
        }
        TipRegion { tip, rates, by: *by, bend_mm, bends_mm }
    }

    /// Tool axis, and how it changes with each axis value, 1/rad.
    pub(crate) fn axis_rates(&self, values: &[f64; MAX_AXES]) -> (Vector3<f64>, [Vector3<f64>; MAX_AXES]) {
        let (mut axis, mut rates) = (self.tool_axis, [Vector3::zeros(); MAX_AXES]);
        for (index, (link, value)) in
            self.links.iter().zip(values).enumerate().rev().filter(|(_, (link, _))| link.rotary)
        {
            let (sine, cosine) = value.sin_cos();
            axis = link.rotated(axis, sine, cosine);
            for rate in &mut rates[index + 1..] {
                *rate = link.rotated(*rate, sine, cosine);
            }
            rates[index] = link.direction.cross(&axis);
        }
        (axis, rates)
    }

    /// Point on the workpiece of a point in the frame of the machine, mm: rotated by the rotary axes of the table.
    pub(crate) fn onto_workpiece(&self, point: Vector3<f64>, values: &[f64; MAX_AXES]) -> Vector3<f64> {
        let mut point = point;
        for (link, value) in self.links.iter().zip(values).rev().filter(|(link, _)| link.rotary && link.workpiece) {
            let (sine, cosine) = value.sin_cos();
            point = link.point + link.rotated(point - link.point, sine, cosine);
        }
        point
    }

    /// Position of the tip with all rotary axes at zero, mm.
    pub(crate) fn at_zero(&self, values: &[f64; MAX_AXES]) -> Vector3<f64> {
        let linear = self.links.iter().zip(values).filter(|(link, _)| !link.rotary);
        linear.fold(Vector3::zeros(), |tip, (link, value)| tip + link.direction * *value)
    }

    /// Values of these three linear axes whose motion together, at the zero position, is a vector.
    pub(crate) fn along(&self, axes: [usize; 3], vector: &Vector3<f64>) -> [f64; 3] {
        let columns = axes.map(|index| self.links[index].direction);
        let inverse = Matrix3::from_columns(&columns).try_inverse();
        inverse.map_or([0.0; 3], |inverse| (inverse * vector).into())
    }
}

impl Link {
    /// Rodrigues: the part along the direction stays, the rest turns.
    fn rotated(&self, v: Vector3<f64>, sine: f64, cosine: f64) -> Vector3<f64> {
        let along = self.direction * self.direction.dot(&v);
        along + (v - along) * cosine + self.direction.cross(&v) * sine
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kinematics::Machine;
    use crate::kinematics::machines::{Cb, Head};

    /// The same product with 4 × 4 matrices, written out.
    fn product<M: Machine>(machine: &M, values: &[f64]) -> (Vector3<f64>, Vector3<f64>) {
        use nalgebra::{Matrix4, Vector4};
        let mut all = Matrix4::identity();
        for (index, value) in values.iter().enumerate() {
            let joint = machine.joint(index);
            let n = joint.direction.into_inner();
            let step = n * (joint.sign * value);
            all *= match M::AXES[index].kind {
                AxisKind::Linear => Matrix4::new_translation(&step),
                AxisKind::Rotary => {
                    let there = Matrix4::new_translation(&joint.point.coords);
                    let back = Matrix4::new_translation(&-joint.point.coords);
                    there * Matrix4::from_axis_angle(&joint.direction, joint.sign * value) * back
                }
            };
        }
        let t = machine.tool_axis().into_inner();
        let (tip, axis) = (all * Vector4::new(0.0, 0.0, 0.0, 1.0), all * Vector4::new(t.x, t.y, t.z, 0.0));
        (tip.xyz(), axis.xyz())
    }

    fn agrees<M: Machine>(values: [f64; 5]) {
        let mut machine = M::default();
        Machine::set_up(&mut machine, Vector3::new(3.0, -4.0, 25.0), 120.0);
        let mut all = [0.0; MAX_AXES];
        all[..5].copy_from_slice(&values);
        let placed = Chain::of(&machine).place(&all);
        let (tip, axis) = product(&machine, &values);
        assert!((placed.tip - tip).norm() < 1e-10 && (placed.axis - axis).norm() < 1e-13, "{placed:?} {tip} {axis}");
    }

    #[test]
    fn the_rates_of_the_tool_axis_are_its_differences() {
        let mut machine = Head::default();
        Machine::set_up(&mut machine, Vector3::new(3.0, -4.0, 25.0), 120.0);
        for chain in [Chain::of(&machine), Chain::of(&Cb::default())] {
            for turn in 0..20 {
                let at = 0.37 * f64::from(turn);
                let values: [f64; MAX_AXES] = std::array::from_fn(|index| at + 0.3 * index as f64);
                let (axis, rates) = chain.axis_rates(&values);
                assert!((axis - chain.place(&values).axis).norm() < 1e-14);
                for (index, rate) in rates.into_iter().enumerate() {
                    let moved = |step: f64| {
                        let mut moved = values;
                        moved[index] += step;
                        chain.place(&moved).axis
                    };
                    assert!(((moved(1e-5) - moved(-1e-5)) / 2e-5 - rate).norm() < 1e-9, "{index} of {values:?}");
                }
            }
        }
    }

    #[test]
    fn no_tip_of_a_box_of_axis_values_is_outside_its_region() {
        let mut machine = Head::default();
        Machine::set_up(&mut machine, Vector3::new(3.0, -4.0, 25.0), 120.0);
        for chain in [Chain::of(&machine), Chain::of(&Cb::default())] {
            let mut tightest = 0.0_f64;
            for turn in 0..60 {
                let at = 0.37 * f64::from(turn);
                let rotary: Vec<bool> = chain.links.iter().map(|link| link.rotary).collect();
                let scaled = |index: usize, value: f64| match rotary.get(index) {
                    Some(true) => 0.01 * value,
                    Some(false) => value,
                    None => 0.0,
                };
                let values: [f64; MAX_AXES] =
                    std::array::from_fn(|index| scaled(index, 100.0 * (at + index as f64).sin()));
                let by: [f64; MAX_AXES] =
                    std::array::from_fn(|index| scaled(index, 30.0 * (at + 2.0 * index as f64).cos().abs()));
                let region = chain.around(&values, &by);
                assert!((region.tip - chain.place(&values).tip).norm() < 1e-12);
                for corner in 0..3_usize.pow(5) {
                    let step = |index: usize| (corner / 3_usize.pow(index as u32)) as f64 % 3.0;
                    let moved: [f64; MAX_AXES] = std::array::from_fn(|index| {
                        values[index] + by[index] * if index < 5 { step(index).floor() - 1.0 } else { 0.0 }
                    });
                    let off = chain.place(&moved).tip - region.tip;
                    let bound = region.extent_mm(&off.normalize());
                    assert!(off.norm() < 1e-9 || off.norm() <= bound + 1e-9, "{turn} {corner}: {} {bound}", off.norm());
                    tightest = tightest.max(off.norm() / bound);
                }
            }
            assert!(tightest > 0.7, "{tightest}");
        }
    }

    #[test]
    fn tip_and_axis_are_those_of_the_product_of_matrices() {
        for turn in 0..40 {
            let at = f64::from(turn);
            agrees::<Cb>([0.31 * at, 0.17 * at - 2.0, at, -2.0 * at, 50.0 - at]);
            agrees::<Head>([at, 3.0 - at, 100.0, 0.05 * at, 0.3 - 0.04 * at]);
        }
    }
}
