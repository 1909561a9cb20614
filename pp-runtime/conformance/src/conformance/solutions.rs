//! Checks of forward kinematics, and of every solution of the inverse.

use core::f64::consts::PI;

use pp_runtime::kinematics::{AxisKind, Branch};

use super::setting::{Case, Setting};
use super::{
    AXIS, FORWARD_AXIS, FORWARD_SHARE, Fault, POSITION, ROTARY, SMALLEST_SINE, UNIT, exceeds, position_tolerance,
};
use crate::oracle::{angle_between, wrapped};
use crate::random::Random;
use crate::subject::Found;

impl Setting {
    pub(super) fn forward(&self, random: &mut Random) -> Result<(), Fault> {
        let mut values = self.draw_angles(random);
        for index in self.oracle.linear() {
            values[index] = random.between(-500.0, 500.0);
        }
        // Forward kinematics accepts any number of revolutions.
        for index in self.oracle.rotary() {
            if random.chance(0.2) {
                values[index] += random.sign() * 2.0 * PI;
            }
        }
        let held = values.clone();
        let case = self.case(values, self.oracle.forward(&held), held);
        let pose = self.machine.forward(&case.values);
        let distance = (pose.tip - case.pose.tip).norm();
        let allowed = FORWARD_SHARE * self.oracle.scale(&case.values);
        if exceeds(distance, allowed) {
            let more = format!("forward kinematics gives {:?}: {distance:e} mm off, allowed {allowed:e}", pose.tip);
            return Err(self.fault("forward kinematics puts the tip where the joints do", &case, &more));
        }
        let angle = angle_between(&pose.axis, &case.pose.axis);
        if exceeds(angle, FORWARD_AXIS) || exceeds((pose.axis.norm() - 1.0).abs(), UNIT) {
            let more = format!("forward kinematics gives {:?}: {angle:e} rad off", pose.axis);
            return Err(self.fault("forward kinematics tilts the tool as the joints do", &case, &more));
        }
        Ok(())
    }

    pub(super) fn inverse(&self, random: &mut Random) -> Result<(), Fault> {
        let Some(case) = self.draw_case(random) else { return Ok(()) };
        let solutions = self.machine.inverse(&case.pose, &case.held);
        if solutions.is_empty() && case.determinant >= 2e-9 {
            let more = format!("{:?}", self.machine.reach(&case.pose.axis, &case.held));
            return Err(self.fault("a pose that the machine reaches has a solution", &case, &more));
        }
        for solution in &solutions {
            self.solution(&case, solution)?;
        }
        self.found_again(&case, &solutions)?;
        self.branches(&case, &solutions)?;
        self.free_rotary(&case, &solutions)?;
        self.linear_axes(&case, &solutions, random)?;
        self.rotary_axes_alone(&case, &solutions)?;
        if self.machine.reach(&case.pose.axis, &case.held).is_ok() == solutions.is_empty() {
            let more = format!("{solutions:?}\n{:?}", self.machine.reach(&case.pose.axis, &case.held));
            return Err(self.fault("`reach` refuses exactly what has no solution", &case, &more));
        }
        Ok(())
    }

    /// Checks that a solution gives the pose back, by the oracle.
    pub(super) fn solution(&self, case: &Case, solution: &Found) -> Result<(), Fault> {
        let fault = |rule, more: &str| Err(self.fault(rule, case, &format!("{solution:?}\n{more}")));
        if solution.axes.iter().any(|value| !value.is_finite()) {
            return fault("solutions are finite numbers", "");
        }
        for (index, axis) in self.machine.axes().iter().enumerate() {
            let value = solution.axes[index];
            if axis.held && value.to_bits() != case.held[index].to_bits() {
                return fault("a held axis keeps its value", "");
            }
            if axis.kind == AxisKind::Rotary && !axis.held && !(value > -PI && value <= PI) {
                return fault("rotary values are in (-180°, 180°]", "");
            }
        }
        let determinant = self.oracle.determinant(&solution.axes).abs();
        if determinant < 0.5e-9 {
            return fault("degenerate linear axes have no solution", &format!("determinant {determinant:e}"));
        }
        if !(0.0..=AXIS).contains(&solution.deviation) {
            return fault("an axis that the machine reaches is reached", "");
        }
        let reached = self.oracle.forward(&solution.axes);
        let distance = (reached.tip - case.pose.tip).norm();
        let allowed = position_tolerance(determinant);
        if exceeds(distance, allowed) {
            let more = format!("{distance:e} mm off, allowed {allowed:e}, determinant {determinant:e}");
            return fault("a solution brings the tip to the pose", &more);
        }
        let angle = angle_between(&reached.axis, &case.pose.axis);
        if exceeds(angle, AXIS + solution.deviation) {
            return fault("a solution brings the tool axis to the pose", &format!("{angle:e} rad off"));
        }
        Ok(())
    }

    /// Checks that the rotary axes alone are the same, bit for bit, and that any more have degenerate linear axes.
    fn rotary_axes_alone(&self, case: &Case, solutions: &[Found]) -> Result<(), Fault> {
        let solved = self.oracle.rotary();
        let alone = self.machine.rotary_axes(&case.pose.axis, &case.held);
        let mut whole = solutions.iter();
        for solution in &alone {
            let mut axes = case.held.clone();
            solved.iter().zip(solution.axes).for_each(|(index, angle)| axes[*index] = angle);
            let Some(linear) = self.machine.linear_axes(&case.pose.tip, &axes) else { continue };
            let same = whole.next().is_some_and(|whole| {
                let angles = solved.iter().zip(solution.axes);
                let of_same = (whole.branch, whole.singular) == (solution.branch, solution.singular)
                    && whole.deviation.to_bits() == solution.deviation.to_bits();
                of_same && angles.clone().all(|(index, angle)| whole.axes[*index].to_bits() == angle.to_bits())
            });
            if !same {
                let more = format!("{solution:?}\nwith {linear:?} is not in {solutions:?}");
                return Err(self.fault("the rotary axes alone are those of the solutions", case, &more));
            }
        }
        if whole.next().is_some() {
            let more = format!("{alone:?} are not all of {solutions:?}");
            return Err(self.fault("the rotary axes alone are those of the solutions", case, &more));
        }
        Ok(())
    }

    /// Checks that the axis values that made the pose are among the solutions.
    pub(super) fn found_again(&self, case: &Case, solutions: &[Found]) -> Result<(), Fault> {
        let sine = case.pole_sine.min(case.rim_sine);
        if sine < SMALLEST_SINE || case.determinant < 2e-9 {
            return Ok(());
        }
        let angle = ROTARY / sine;
        let lever = self.oracle.scale(&case.values) + case.pose.tip.coords.norm();
        let length = (2.0 * angle * lever + POSITION) / case.determinant;
        let same = |solution: &Found| {
            self.machine.axes().iter().enumerate().all(|(index, axis)| {
                let difference = solution.axes[index] - case.values[index];
                match axis.kind {
                    AxisKind::Rotary => wrapped(difference).abs() <= angle,
                    AxisKind::Linear => difference.abs() <= length,
                }
            })
        };
        if solutions.iter().any(same) {
            return Ok(());
        }
        let more = format!("within {angle:e} rad and {length:e} mm\n{solutions:?}");
        Err(self.fault("the axis values that made the pose are found again", case, &more))
    }

    /// Checks the order of the branches, and that two solutions differ.
    pub(super) fn branches(&self, case: &Case, solutions: &[Found]) -> Result<(), Fault> {
        if let [first, second] = solutions {
            if (first.branch, second.branch) != (Branch::First, Branch::Second) {
                return Err(self.fault("the first branch comes first", case, &format!("{solutions:?}")));
            }
            if case.rim_sine > 1e-14 && first.axes == second.axes {
                return Err(self.fault("two solutions differ", case, &format!("{solutions:?}")));
            }
        }
        let &[_, second_rotary] = &self.oracle.rotary()[..] else {
            return if solutions.len() < 2 {
                Ok(())
            } else {
                Err(self.fault("fewer than two rotaries have one solution", case, &format!("{solutions:?}")))
            };
        };
        let (Some(sigma), Some(rotaries)) = (self.first_branch, self.oracle.rotaries(&case.values)) else {
            return Ok(());
        };
        if case.rim_sine < SMALLEST_SINE {
            return Ok(());
        }
        for solution in solutions {
            let (sin, cos) = (self.oracle.sign(second_rotary) * solution.axes[second_rotary]).sin_cos();
            // `n · axis` falls with the second angle on the branch `σ = 1`.
            let falls = rotaries.cosine_part() * sin - rotaries.sine_part() * cos;
            if ((falls * sigma > 0.0) != (solution.branch == Branch::First)) && falls.abs() > 1e-9 {
                return Err(self.fault("branches follow their documented definition", case, &format!("{solutions:?}")));
            }
        }
        Ok(())
    }

    /// Checks that `singular` is reported at the pole only.
    pub(super) fn free_rotary(&self, case: &Case, solutions: &[Found]) -> Result<(), Fault> {
        if self.oracle.rotary().len() < 2 {
            return match solutions.iter().any(|solution| solution.singular) {
                true => Err(self.fault("only two rotaries can leave one free", case, &format!("{solutions:?}"))),
                false => Ok(()),
            };
        }
        let first = self.oracle.rotary()[0];
        for solution in solutions {
            let fault = |rule| Err(self.fault(rule, case, &format!("{solutions:?}")));
            if solution.singular && case.pole_sine > 4e-15 {
                return fault("a rotary is free at the pole only");
            }
            if !solution.singular && case.pole_sine < 3e-16 {
                return fault("at the pole the first rotary is free");
            }
            if solution.singular && solution.axes[first].to_bits() != case.held[first].to_bits() {
                return fault("a free rotary keeps its held value");
            }
            if solution.singular && solutions.len() != 1 {
                return fault("at the pole there is one solution");
            }
        }
        Ok(())
    }

    /// Checks that `linear_axes` agrees with the inverse kinematics and with the oracle.
    pub(super) fn linear_axes(&self, case: &Case, solutions: &[Found], random: &mut Random) -> Result<(), Fault> {
        let mut wanted = case.values.clone();
        for index in self.oracle.linear() {
            wanted[index] = random.between(-500.0, 500.0);
        }
        let expected = solutions.iter().map(|solution| (&solution.axes, Some(&solution.axes)));
        for (input, solution) in expected.chain([(&wanted, None)]) {
            let determinant = self.oracle.determinant(input).abs();
            let answer = self.machine.linear_axes(&case.pose.tip, input);
            let fault = |rule| Err(self.fault(rule, case, &format!("linear_axes({input:?}) = {answer:?}")));
            let Some(axes) = &answer else {
                if determinant >= 2e-9 {
                    return fault("`linear_axes` has an answer");
                }
                continue;
            };
            if determinant < 0.5e-9 {
                return fault("`linear_axes` has no answer where the linear axes are degenerate");
            }
            let linear = self.oracle.linear();
            if (0..axes.len()).any(|index| !linear.contains(&index) && axes[index].to_bits() != input[index].to_bits())
            {
                return fault("`linear_axes` leaves rotary and held values alone");
            }
            let allowed = position_tolerance(determinant);
            if exceeds((self.oracle.forward(axes).tip - case.pose.tip).norm(), allowed) {
                return fault("`linear_axes` brings the tip to the pose");
            }
            if let Some(solution) = solution
                && linear
                    .iter()
                    .any(|&index| exceeds((axes[index] - solution[index]).abs(), 2.0 * allowed / determinant))
            {
                return fault("`linear_axes` agrees with the inverse kinematics");
            }
        }
        Ok(())
    }
}
