//! Axis values into tip and tool axis: the chain of the declaration as a product of matrices, at run time.
//!
//! `T(q) = Π J_i(q_i)` from the workpiece to the tool, `J = Trans(q·u)` for a linear axis,
//! `Trans(c)·Rot(n, q)·Trans(-c)` for a rotary one, `q` with its sign. The tip is `T·(0,0,0,1)`, the tool axis
//! `T·(t,0)`. Nothing of the generated functions is used: the joints are those that the declaration states. The product
//! is applied to tip and axis from the tool outwards, which costs a rotation of two vectors for each rotary axis.

use std::cell::Cell;

use nalgebra::{Matrix3, Vector3};
use wide::f64x2;

use super::super::read::MAX_AXES;
use crate::check::tolerances::PERPENDICULAR_THERE;
use crate::kinematics::{AnyMachine, Axis, AxisKind, Side};

/// One factor of the product.
#[derive(Debug, Clone)]
struct Link {
    rotary: bool,
    workpiece: bool,
    /// Direction, with the sign of the axis.
    direction: Vector3<f64>,
    /// A point of the centre line, mm.
    point: Vector3<f64>,
    /// Part of a vector along the direction, the rest of it, and that rest a quarter of a revolution on.
    along: Matrix3<f64>,
    across: Matrix3<f64>,
    quarter: Matrix3<f64>,
    /// The direction for both, and for the tip alone; the point for the tip.
    both: Pair,
    moves_tip: Pair,
    centre: Pair,
    /// Of a rotary axis whose neighbour towards the tool is rotary, too.
    next: Option<Arm>,
    /// The angle of the last rotation: often the next one is the same.
    last: Cell<Turn>,
}

/// An angle with its sine and cosine.
#[derive(Debug, Clone, Copy)]
struct Turn {
    angle: f64,
    sine: f64,
    cosine: f64,
}

impl Turn {
    fn of(angle: f64) -> Self {
        let (sine, cosine) = angle.sin_cos();
        Self { angle, sine, cosine }
    }
}

/// Distances of a point from a rotary axis, mm.
#[derive(Debug, Clone, Copy)]
struct Arm {
    /// From its point.
    length_mm: f64,
    /// From its centre line.
    lever_mm: f64,
}

/// Components of two vectors, as tip and tool axis: what is done to one is done to the other by the same instruction.
type Pair = [f64x2; 3];

/// Centre of vectors, which rotate without one.
const NO_CENTRE: Pair = [f64x2::ZERO; 3];

fn pair(one: &Vector3<f64>, other: &Vector3<f64>) -> Pair {
    [0, 1, 2].map(|index| f64x2::new([one[index], other[index]]))
}

fn vectors(pair: &Pair) -> [Vector3<f64>; 2] {
    let [x, y, z] = pair.map(f64x2::to_array);
    [0, 1].map(|index| Vector3::new(x[index], y[index], z[index]))
}

/// The chain of a machine for one part and one tool.
#[derive(Debug, Clone)]
pub(crate) struct Chain {
    links: Vec<Link>,
    tool_axis: Vector3<f64>,
    /// The tool before the first link.
    tool: Pair,
}

/// Tip and tool axis in the workpiece frame, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ToolPose {
    pub(crate) tip: Vector3<f64>,
    pub(crate) axis: Vector3<f64>,
}

/// Bounds of a motion whose axis values change evenly, by the share of it that is done.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Swing {
    /// Second derivative of the tip, mm.
    pub(crate) bend_mm: f64,
    /// Third derivative of the tip, mm.
    pub(crate) jerk_mm: f64,
    /// Rotation of the tool axis, rad: that of all rotary axes together. Its square is the bound of the second
    /// derivative.
    pub(crate) angle: f64,
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
        let is_rotary = |axis: &Axis| axis.kind == AxisKind::Rotary;
        let link = |index: usize| {
            let joint = machine.joint(index);
            let direction = joint.direction.into_inner() * joint.sign;
            let along = direction * direction.transpose();
            let of_tip = |vector| pair(&vector, &Vector3::zeros());
            let next = machine.axes().get(index + 1).filter(|axis| is_rotary(axis));
            Link {
                rotary: is_rotary(&machine.axes()[index]),
                workpiece: machine.axes()[index].side == Side::Workpiece,
                direction,
                point: joint.point.coords,
                along,
                across: Matrix3::identity() - along,
                quarter: direction.cross_matrix(),
                both: pair(&direction, &direction),
                moves_tip: of_tip(direction),
                centre: of_tip(joint.point.coords),
                last: Cell::new(Turn::of(0.0)),
                next: next.map(|_| Arm::of(&direction, &(machine.joint(index + 1).point.coords - joint.point.coords))),
            }
        };
        let tool_axis = machine.tool_axis().into_inner();
        Self {
            links: (0..machine.axes().len()).map(link).collect(),
            tool_axis,
            tool: pair(&Vector3::zeros(), &tool_axis),
        }
    }

    /// Tip and tool axis for axis values in mm and rad.
    pub(crate) fn place(&self, values: &[f64; MAX_AXES]) -> ToolPose {
        let mut tool = self.tool;
        for (link, value) in self.links.iter().zip(values).rev() {
            tool = if link.rotary { link.rotated(&tool, *value) } else { link.moved(&tool, *value) };
        }
        let [tip, axis] = vectors(&tool);
        ToolPose { tip, axis }
    }

    /// Tip at axis values, and how far each of three changes of the linear axes moves it.
    pub(crate) fn tip_and_shifts(
        &self,
        values: &[f64; MAX_AXES],
        [first, second, third]: &[[f64; MAX_AXES]; 3],
    ) -> (Vector3<f64>, [Vector3<f64>; 3]) {
        let (mut tip_and_first, mut others) = ([f64x2::splat(0.0); 3], [f64x2::splat(0.0); 3]);
        for (index, (link, value)) in self.links.iter().zip(values).enumerate().rev() {
            if link.rotary {
                tip_and_first = link.rotated(&tip_and_first, *value);
                others = link.rotated_about(&NO_CENTRE, &others, *value);
            } else {
                let by = [f64x2::new([*value, first[index]]), f64x2::new([second[index], third[index]])];
                tip_and_first = [0, 1, 2].map(|axis| tip_and_first[axis] + link.both[axis] * by[0]);
                others = [0, 1, 2].map(|axis| others[axis] + link.both[axis] * by[1]);
            }
        }
        let ([tip, first], [second, third]) = (vectors(&tip_and_first), vectors(&others));
        (tip, [first, second, third])
    }

    /// Bounds of a motion to axis values, each of which changes evenly, by `change` in the whole motion, mm and rad.
    ///
    /// From the tool outwards, `r` being the tip in the frame of a link: a linear axis adds to its speed. A rotary axis
    /// leads the arm `a = r - c` to `R a`, with the derivatives `ω n×Ra + R a'` and `ω² n×(n×Ra) + 2ω n×Ra' + R a''`;
    /// the third is bounded by `ω³|a| + 3ω²|a'| + 3ω|a''| + |a'''|`. Arms are those at the end of the motion, by their
    /// lengths where another axis rotates them, and no longer before it than by the speed.
    #[inline(always)]
    pub(crate) fn swing(&self, values: &[f64; MAX_AXES], change: &[f64; MAX_AXES]) -> Swing {
        // The tip from the last centre, and the length of what has been rotated about it.
        let (mut arm_and_step, mut rotated_mm) = ([f64x2::splat(0.0); 3], 0.0);
        let (mut speed_mm, mut bend_mm, mut jerk_mm, mut angle) = (0.0, 0.0, 0.0, 0.0);
        for ((link, value), change) in self.links.iter().zip(values).zip(change).rev() {
            if !link.rotary {
                let by = f64x2::new([*value, *change]);
                arm_and_step = [0, 1, 2].map(|index| arm_and_step[index] + link.both[index] * by);
                continue;
            }
            let turn = change.abs();
            let arm = link.next.unwrap_or_else(|| {
                let [arm, step] = vectors(&arm_and_step);
                speed_mm += step.norm();
                Arm::of(&link.direction, &(arm - link.point))
            });
            let lever_mm = arm.lever_mm + rotated_mm + speed_mm;
            jerk_mm += turn * (3.0 * bend_mm + turn * (3.0 * speed_mm + turn * lever_mm));
            (bend_mm, speed_mm) = (bend_mm + turn * (2.0 * speed_mm + turn * lever_mm), speed_mm + turn * lever_mm);
            (arm_and_step, rotated_mm) = (link.centre, rotated_mm + arm.length_mm);
            angle += turn;
        }
        Swing { bend_mm, jerk_mm, angle }
    }

    /// Speed of the tip at axis values, each of which changes by `change` in the whole motion, mm in the whole of it.
    pub(crate) fn speed(&self, values: &[f64; MAX_AXES], change: &[f64; MAX_AXES]) -> Vector3<f64> {
        // The tip and its speed.
        let mut moving = [f64x2::splat(0.0); 3];
        for ((link, value), change) in self.links.iter().zip(values).zip(change).rev() {
            if !link.rotary {
                let by = f64x2::new([*value, *change]);
                moving = [0, 1, 2].map(|index| moving[index] + link.both[index] * by);
                continue;
            }
            moving = link.rotated(&moving, *value);
            let [tip, speed] = vectors(&moving);
            moving = pair(&tip, &(speed + link.direction.cross(&(tip - link.point)) * *change));
        }
        let [_, speed] = vectors(&moving);
        speed
    }

    /// Whether linear axes lead the tip in perpendicular directions with the rotary axes at these values. `linear`:
    /// their positions.
    pub(crate) fn is_perpendicular(&self, values: &[f64; MAX_AXES], linear: impl Iterator<Item = usize>) -> bool {
        let unit = |place: usize| std::array::from_fn(|index| if index == place { 1.0 } else { 0.0 });
        let directions: Vec<_> = linear.map(|place| self.speed(values, &unit(place))).collect();
        directions
            .iter()
            .enumerate()
            .all(|(place, one)| directions[place + 1..].iter().all(|other| one.dot(other).abs() <= PERPENDICULAR_THERE))
    }

    /// Tip positions of the axis values around `values`, each by `by` or less on its own, mm and rad.
    ///
    /// A rotation by `δ` about `n` moves `a + L`, `a` the arm and `L` what the axes nearer the tool add, by `δ·n×a`
    /// and, apart from that, by `|δ|·|n×L| + δ²/2·(|n×a| + |n×L|)` at most.
    pub(crate) fn around(&self, values: &[f64; MAX_AXES], by: &[f64; MAX_AXES]) -> TipRegion {
        let (mut tip, mut rates) = (Vector3::zeros(), [Vector3::zeros(); MAX_AXES]);
        let (mut bend_mm, mut bends_mm) = (0.0, [0.0; MAX_AXES]);
        for (index, (link, value)) in self.links.iter().zip(values).enumerate().rev() {
            if !link.rotary {
                (tip, rates[index]) = (tip + link.direction * *value, link.direction);
                continue;
            }
            let rotation = link.rotation(*value);
            let arm = rotation * (tip - link.point);
            let angle = by[index];
            let mut across_mm = 0.0;
            for nearer in index + 1..MAX_AXES {
                rates[nearer] = rotation * rates[nearer];
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
            let rotation = link.rotation(*value);
            axis = rotation * axis;
            for rate in &mut rates[index + 1..] {
                *rate = rotation * *rate;
            }
            rates[index] = link.direction.cross(&axis);
        }
        (axis, rates)
    }

    /// Point on the workpiece of a point in the frame of the machine, mm: rotated by the rotary axes of the table.
    pub(crate) fn onto_workpiece(&self, point: Vector3<f64>, values: &[f64; MAX_AXES]) -> Vector3<f64> {
        let mut point = point;
        for (link, value) in self.links.iter().zip(values).rev().filter(|(link, _)| link.rotary && link.workpiece) {
            point = link.point + link.rotation(*value) * (point - link.point);
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

impl Arm {
    /// Of a point as seen from that of the axis.
    fn of(direction: &Vector3<f64>, from_point: &Vector3<f64>) -> Self {
        Self { length_mm: from_point.norm(), lever_mm: direction.cross(from_point).norm() }
    }
}

impl Link {
    /// The tip moved along the direction.
    fn moved(&self, tool: &Pair, value: f64) -> Pair {
        let value = f64x2::splat(value);
        [0, 1, 2].map(|index| tool[index] + self.moves_tip[index] * value)
    }

    /// [`rotation`](Self::rotation) of the tip about the centre line, and of the tool axis.
    #[inline(always)]
    fn rotated(&self, tool: &Pair, angle: f64) -> Pair {
        self.rotated_about(&self.centre, tool, angle)
    }

    /// Rotates two points, each about its own centre, or two vectors.
    #[inline(always)]
    fn rotated_about(&self, centre: &Pair, tool: &Pair, angle: f64) -> Pair {
        let Turn { sine, cosine, .. } = self.turn(angle);
        let (sine, cosine, n) = (f64x2::splat(sine), f64x2::splat(cosine), &self.both);
        let arm = [0, 1, 2].map(|index| tool[index] - centre[index]);
        let part = n[0] * arm[0] + n[1] * arm[1] + n[2] * arm[2];
        let quarter = [n[1] * arm[2] - n[2] * arm[1], n[2] * arm[0] - n[0] * arm[2], n[0] * arm[1] - n[1] * arm[0]];
        [0, 1, 2].map(|index| {
            let along = n[index] * part;
            centre[index] + along + (arm[index] - along) * cosine + quarter[index] * sine
        })
    }

    /// Sine and cosine of an angle.
    fn turn(&self, angle: f64) -> Turn {
        let last = self.last.get();
        if last.angle.to_bits() == angle.to_bits() {
            return last;
        }
        let turn = Turn::of(angle);
        self.last.set(turn);
        turn
    }

    /// Rodrigues: the part along the direction stays, the rest rotates.
    fn rotation(&self, angle: f64) -> Matrix3<f64> {
        let Turn { sine, cosine, .. } = self.turn(angle);
        self.along + self.across * cosine + self.quarter * sine
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
    fn no_motion_bends_more_than_its_swing_and_its_speed_is_that_of_its_places() {
        let mut head = Head::default();
        Machine::set_up(&mut head, Vector3::new(3.0, -4.0, 25.0), 120.0);
        for chain in [Chain::of(&head), Chain::of(&Cb::default())] {
            let mut tightest = [0.0_f64; 3];
            for turn in 0..200 {
                let at = 0.37 * f64::from(turn);
                let scaled = |index: usize, value: f64| match chain.links.get(index) {
                    Some(link) if link.rotary => 0.01 * value,
                    Some(_) => value,
                    None => 0.0,
                };
                let values: [f64; MAX_AXES] =
                    std::array::from_fn(|index| scaled(index, 100.0 * (at + index as f64).sin()));
                let change: [f64; MAX_AXES] =
                    std::array::from_fn(|index| scaled(index, 20.0 * (at + 2.0 * index as f64).cos()));
                let swing = chain.swing(&values, &change);
                let place = |share: f64| {
                    chain.place(&std::array::from_fn(|index| values[index] - change[index] * (1.0 - share)))
                };
                const STEP: f64 = 1e-3;
                for point in 1..100 {
                    let share = f64::from(point) / 100.0;
                    let [a, b, c] = [-STEP, 0.0, STEP].map(|step| place(share + step));
                    let tip = (a.tip - b.tip * 2.0 + c.tip).norm() / (STEP * STEP);
                    let axis = (a.axis - b.axis * 2.0 + c.axis).norm() / (STEP * STEP);
                    assert!(tip <= swing.bend_mm + 1e-5, "{turn} {share}: {tip} {swing:?}");
                    assert!(axis <= swing.angle * swing.angle + 1e-7, "{turn} {share}: {axis} {swing:?}");
                    let speed = |share: f64| {
                        let at = std::array::from_fn(|index| values[index] - change[index] * (1.0 - share));
                        chain.speed(&at, &change)
                    };
                    let [before, here, after] = [-STEP, 0.0, STEP].map(|step| speed(share + step));
                    assert!(
                        ((c.tip - a.tip) / (2.0 * STEP) - here).norm() <= STEP * STEP * swing.jerk_mm,
                        "{turn} {share}"
                    );
                    let jerk = (before - here * 2.0 + after).norm() / (STEP * STEP);
                    assert!(jerk <= swing.jerk_mm + 1e-5, "{turn} {share}: {jerk} {swing:?}");
                    tightest = [
                        tightest[0].max(tip / swing.bend_mm),
                        tightest[1].max(axis / swing.angle.powi(2)),
                        tightest[2].max(jerk / swing.jerk_mm),
                    ];
                }
            }
            let [tip, axis, jerk] = tightest;
            assert!(tip > 0.7 && axis > 0.7 && jerk > 0.5, "{tightest:?}");
        }
    }

    #[test]
    fn shifts_of_the_tip_are_differences_of_its_places() {
        let mut head = Head::default();
        Machine::set_up(&mut head, Vector3::new(3.0, -4.0, 25.0), 120.0);
        for chain in [Chain::of(&head), Chain::of(&Cb::default())] {
            for turn in 0..40 {
                let at = 0.37 * f64::from(turn);
                let values: [f64; MAX_AXES] = std::array::from_fn(|index| at - 0.7 * index as f64);
                let linear = |index: usize| chain.links.get(index).is_some_and(|link| !link.rotary);
                let changes = [11.0, -3.0, 0.5].map(|scale| {
                    std::array::from_fn(|index| if linear(index) { scale * (at + index as f64).sin() } else { 0.0 })
                });
                let (tip, shifts) = chain.tip_and_shifts(&values, &changes);
                assert!((tip - chain.place(&values).tip).norm() < 1e-12);
                for (change, shift) in changes.iter().zip(shifts) {
                    let moved = chain.place(&std::array::from_fn(|index| values[index] + change[index])).tip;
                    assert!((moved - tip - shift).norm() < 1e-12, "{turn}: {shift}");
                }
            }
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
